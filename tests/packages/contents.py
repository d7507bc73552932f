# SPDX-License-Identifier: GPL-3.0-or-later
"""What is in the packages: contents.py ROOT SDIST WHEEL.

Both hold the licence and all of the library's sources or modules, and nothing that a build or a run left behind. What a wheel is
built from is the same in the source package and in ROOT, so that a wheel of one is a wheel of the other; and the source package
holds no file that is not under version control, where ROOT is.
"""

import re
import shutil
import subprocess
import sys
import tarfile
import zipfile
from pathlib import Path

JUNK = re.compile(
    r"(^|/)(build[^/]*|\.venv|output|__pycache__|\.git|[^/]*\.egg-info)/|\.(o|a|smod|pyc|orig|rej|log)$|(?<!/go)\.mod$|~$"
)
BUILT_FROM = ("cmake", "include", "src", "python", "examples/problems")


def complain(package, what, names):
    """Ends the program if there are such files."""
    if names:
        sys.exit(f"{package.name}: {what}: {', '.join(sorted(names)[:20])}")


def under(root, *patterns):
    """Files below ROOT by their relative names."""
    return {path.relative_to(root).as_posix() for pattern in patterns for path in root.glob(pattern)}


def source_names(sdist):
    """Names in a source package, without its one top folder, with their content."""
    with tarfile.open(sdist) as archive:
        names = {member.name: archive.extractfile(member).read() for member in archive.getmembers() if member.isfile()}
    tops = {name.split("/")[0] for name in names}
    if len(tops) != 1:
        sys.exit(f"{sdist.name}: one top folder is meant, found {sorted(tops)}")
    return {name.split("/", 1)[1]: content for name, content in names.items()}


def junk(name):
    """Whether no source package holds such a file."""
    return JUNK.search(name) or name.endswith(".so")


def versioned(root):
    """The files of ROOT under version control; none where there is no git or ROOT is a copy."""
    if not shutil.which("git"):
        return set()
    listed = subprocess.run(["git", "-C", str(root), "ls-files"], capture_output=True, text=True, check=False)
    names = set(listed.stdout.splitlines()) if listed.returncode == 0 else set()
    return names if "pyproject.toml" in names else set()


def check_source(root, sdist):
    """All that a build needs, with the content that it has in ROOT; the licence; no junk."""
    names = source_names(sdist)
    wanted = {"LICENSE", "README.md", "CHANGELOG.md", "CMakeLists.txt", "pyproject.toml"}
    wanted |= {name for name in under(root, *(f"{folder}/**/*.*" for folder in BUILT_FROM)) if not junk(name)}
    complain(sdist, "missing", wanted - set(names))
    complain(sdist, "not meant to be there", {name for name in names if junk(name)})
    complain(sdist, "not as in the folder", {name for name in wanted if names[name] != (root / name).read_bytes()})
    listed = versioned(root)
    if listed:
        complain(sdist, "not under version control", set(names) - listed - {"PKG-INFO"})
    print(f"   {sdist.name}: {len(names)} files, {sdist.stat().st_size / 1e6:.1f} MB")


def check_wheel(root, wheel):
    """All modules, one extension, the licence and those of the libraries inside, no junk."""
    with zipfile.ZipFile(wheel) as archive:
        names = set(archive.namelist())
    wanted = {f"mdrcontact/{name}" for name in under(root / "python" / "mdrcontact", "**/*.py", "**/*.pyi", "py.typed")}
    wanted |= {f"mdrcontact/{name}" for name in under(root / "examples", "problems/*.toml")}
    wanted |= {f"mdrcontact/{name}" for name in under(root, "include/*.h", "include/*.hpp")}
    wanted |= {f"mdrcontact/{name}" for name in ("cmake/mdrcontact-config.cmake", "pkgconfig/mdrcontact.pc")}
    complain(wheel, "missing", wanted - names)
    complain(wheel, "not meant to be there", {name for name in names if JUNK.search(name)})
    tops = {name.split("/")[0] for name in names}
    information = {top for top in tops if re.fullmatch(r"mdrcontact-[0-9.]+\.dist-info", top)}
    complain(wheel, "not meant to be there", tops - information - {"mdrcontact", "mdrcontact.libs"})
    if not any(name.endswith(".dist-info/licenses/LICENSE") for name in names):
        sys.exit(f"{wheel.name}: LICENSE is missing")
    libraries = {name for name in names if name.startswith("mdrcontact.libs/") and ".so" in name}
    licences = {name.split("/")[2] for name in names if ".dist-info/licenses/" in name and name.count("/") > 2}
    if not libraries or not licences:
        sys.exit(f"{wheel.name}: {len(libraries)} libraries inside, with the licences of {sorted(licences)}")
    if sum(name.startswith("mdrcontact/_native.") and name.endswith(".so") for name in names) != 1:
        sys.exit(f"{wheel.name}: one extension module mdrcontact/_native is meant")
    if sum(name.startswith("mdrcontact/lib/libmdrcontact.so") for name in names) != 1:
        sys.exit(f"{wheel.name}: one shared library for C is meant")
    if "manylinux" not in wheel.name:
        sys.exit(f"{wheel.name}: its libraries were not put inside")
    print(f"   {wheel.name}: {len(names)} files, {wheel.stat().st_size / 1e6:.1f} MB")


if __name__ == "__main__":
    check_source(Path(sys.argv[1]), Path(sys.argv[2]))
    check_wheel(Path(sys.argv[1]), Path(sys.argv[3]))
