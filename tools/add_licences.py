#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Put the licences of the libraries that auditwheel copied into a wheel beside the wheel's own: add_licences.py WHEEL.

auditwheel notes which Debian or RPM package each library came from; that package's licence goes to licenses/PACKAGE/ of the wheel.
"""

import base64
import hashlib
import json
import subprocess
import sys
import zipfile
from pathlib import Path
from urllib.parse import unquote


def licence_files(origin, package):
    """The files in which an installed package has its licence."""
    if origin.startswith("pkg:deb/"):
        return [Path("/usr/share/doc", package, "copyright")]
    if origin.startswith("pkg:rpm/"):
        listed = subprocess.run(["rpm", "--query", "--licensefiles", package], capture_output=True, text=True, check=True)
        return [Path(line) for line in listed.stdout.splitlines() if line.startswith("/")]
    sys.exit(f"{origin}: neither a Debian nor an RPM package")


def licences(archive):
    """(name in the wheel, content) for every package that a library in this wheel came from."""
    names = archive.namelist()
    notes = [name for name in names if name.endswith("/sboms/auditwheel.cdx.json")]
    if len(notes) != 1:
        sys.exit("the wheel has no note of where its libraries came from: was it repaired by a recent auditwheel?")
    information = notes[0].split("/")[0]
    found = {}
    for component in json.loads(archive.read(notes[0]))["components"]:
        package = unquote(component["name"])
        if package == "mdrcontact":
            continue
        files = [path for path in licence_files(component["purl"], package) if path.is_file()]
        if not files:
            sys.exit(f"{package}: its licence was not found")
        found |= {f"{information}/licenses/{package}/{path.name}": path.read_bytes() for path in files}
    libraries = [name for name in names if ".libs/" in name and ".so" in name]
    if libraries and not found:
        sys.exit("there are libraries in the wheel, and no word of where they came from")
    return information, found


def main(wheel):
    """Appends the licences, and their lines to RECORD."""
    with zipfile.ZipFile(wheel) as archive:
        information, found = licences(archive)
        content = {entry: archive.read(entry) for entry in archive.infolist()}
    record = f"{information}/RECORD"
    lines = ""
    for name, text in found.items():
        digest = base64.urlsafe_b64encode(hashlib.sha256(text).digest()).rstrip(b"=").decode()
        lines += f"{name},sha256={digest},{len(text)}\n"
    with zipfile.ZipFile(wheel, "w", zipfile.ZIP_DEFLATED) as archive:
        for entry, data in content.items():
            archive.writestr(entry, data + lines.encode() if entry.filename == record else data)
        for name, text in found.items():
            archive.writestr(name, text)
    print(f"   licences added: {', '.join(sorted({name.split('/')[2] for name in found}))}")


if __name__ == "__main__":
    main(Path(sys.argv[1]))
