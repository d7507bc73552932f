# SPDX-License-Identifier: GPL-3.0-or-later
# The virtual environment .venv with the Python package; nothing is done again while the sources stay the same.
# Sourced by quickstart.sh and runtests.sh; needs messages.sh and system_packages.sh.
# shellcheck shell=bash disable=SC2154  # who sources this sets log_dir

# One number for the content of the files and folders given, made by .venv's Python: not every system has sha256sum.
fingerprint() {
    .venv/bin/python - "$@" << 'CODE'
import hashlib, pathlib, sys
total = hashlib.sha256()
for given in map(pathlib.Path, sys.argv[1:]):
    for path in sorted(given.rglob("*")) if given.is_dir() else [given]:
        if path.is_file() and path.suffix not in (".so", ".pyc"):
            total.update(f"{path}\0{path.stat().st_size}\0".encode() + path.read_bytes())
print(total.hexdigest())
CODE
}

# install_python_package EXTRA [TOOL...]: .venv holds mdrcontact[EXTRA] made from the sources as they are, and the tools from PyPI.
install_python_package() {
    local extra=$1 python sources wanted
    shift
    if [[ ! -x .venv/bin/python ]] || ! .venv/bin/python -c "import pip" 2> /dev/null; then
        python=$(find_python)
        note "making the virtual environment .venv with $("$python" --version)"
        rm -rf .venv
        with_progress "$log_dir/venv.log" "$python" -m venv .venv || give_up "The virtual environment could not be made."
    fi
    # everything that the installed package is made of
    sources="$(fingerprint CMakeLists.txt pyproject.toml README.md LICENSE cmake src include python examples/problems)"
    sources+=" $(.venv/bin/python -VV)"
    if [[ $(cat .venv/mdrcontact.installed 2> /dev/null) != "$sources" ]]; then
        note "compiling and installing the Python package"
        rm -f .venv/mdrcontact.installed
        with_progress "$log_dir/pip-package.log" .venv/bin/python -m pip install --disable-pip-version-check . ||
            give_up "The Python package could not be built."
        printf '%s\n' "$sources" > .venv/mdrcontact.installed
    else
        note "the Python package is up to date"
    fi
    wanted="mdrcontact[$extra] $* $(fingerprint pyproject.toml)"
    if ! grep -qxF -- "$wanted" .venv/mdrcontact.extras 2> /dev/null; then
        note "installing what mdrcontact[$extra] asks for${*:+ and }$*"
        with_progress "$log_dir/pip-extras.log" .venv/bin/python -m pip install --disable-pip-version-check "mdrcontact[$extra]" "$@" ||
            give_up "Packages from the Python index could not be installed; is there a network?"
        printf '%s\n' "$wanted" >> .venv/mdrcontact.extras
    fi
}
