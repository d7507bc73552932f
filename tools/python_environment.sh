# SPDX-License-Identifier: GPL-3.0-or-later
# The virtual environment .venv with the Python package; nothing is done again while the sources stay the same.
# Sourced by quickstart.sh and runtests.sh; needs messages.sh and system_packages.sh.

# One number for the content of everything that the installed package is made of.
sources_fingerprint() {
    find CMakeLists.txt pyproject.toml README.md LICENSE cmake src include python examples/problems -type f \
        ! -name '*.so' ! -name '*.pyc' -print0 2> /dev/null | sort -z | xargs -0 sha256sum | sha256sum
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
    sources="$(sources_fingerprint) $(.venv/bin/python -VV)"
    if [[ $(cat .venv/mdrcontact.installed 2> /dev/null) != "$sources" ]]; then
        note "compiling and installing the Python package"
        rm -f .venv/mdrcontact.installed
        with_progress "$log_dir/pip-package.log" .venv/bin/python -m pip install --disable-pip-version-check . ||
            give_up "The Python package could not be built."
        printf '%s\n' "$sources" > .venv/mdrcontact.installed
    else
        note "the Python package is up to date"
    fi
    wanted="mdrcontact[$extra] $* $(sha256sum pyproject.toml)"
    if ! grep -qxF -- "$wanted" .venv/mdrcontact.extras 2> /dev/null; then
        note "installing what mdrcontact[$extra] asks for" ${*:+"and $*"}
        with_progress "$log_dir/pip-extras.log" .venv/bin/python -m pip install --disable-pip-version-check "mdrcontact[$extra]" "$@" ||
            give_up "Packages from the Python index could not be installed; is there a network?"
        printf '%s\n' "$wanted" >> .venv/mdrcontact.extras
    fi
}
