# SPDX-License-Identifier: GPL-3.0-or-later
# The virtual environment .venv with the Python package; nothing is done again while the sources stay the same.
# Sourced by quickstart.sh, runtests.sh and docs/build.sh; needs messages.sh and system_packages.sh.
# shellcheck shell=bash disable=SC2154  # who sources this sets log_dir

wheel_dir=build/wheel

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

# install_python_package EXTRA [TOOL...]: .venv holds mdrcontact[EXTRA] made from the sources as they are, and the tools. The wheel
# stays in $wheel_dir. Into the folder $shared_build, if that is set, it is compiled with the flags and next to the tests of CMake.
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
    if [[ $(cat .venv/mdrcontact.installed 2> /dev/null) != "$sources" ]] || ! compgen -G "$wheel_dir/*.whl" > /dev/null; then
        note "compiling and installing the Python package"
        rm -f .venv/mdrcontact.installed "$wheel_dir"/*.whl
        with_progress "$log_dir/pip-package.log" build_and_install_wheel || give_up "The Python package could not be built."
        printf '%s\n' "$sources" > .venv/mdrcontact.installed
    else
        note "the Python package is up to date"
    fi
    wanted="mdrcontact[$extra] $* $(fingerprint pyproject.toml)"
    if ! grep -qxF -- "$wanted" .venv/mdrcontact.extras 2> /dev/null; then
        note "installing what mdrcontact[$extra] needs${*:+ and }$*"
        with_progress "$log_dir/pip-extras.log" .venv/bin/python -m pip install --disable-pip-version-check "mdrcontact[$extra]" "$@" ||
            give_up "Python packages could not be installed; is there a network?"
        printf '%s\n' "$wanted" >> .venv/mdrcontact.extras
    fi
}

build_and_install_wheel() {
    local pip=(.venv/bin/python -m pip --disable-pip-version-check) options=()
    if [[ -n ${shared_build:-} ]]; then
        # pip's own environment for builds is gone after the build; CMake would look for its NumPy there
        "${pip[@]}" install "scikit-build-core>=0.10" "numpy>=2.0" || return
        options=(--no-build-isolation --config-settings=build-dir="$shared_build")
        for name in BUILD_TESTS BUILD_EXAMPLES WARNINGS_AS_ERRORS; do
            options+=(--config-settings="cmake.define.MDRCONTACT_$name=ON")
        done
    fi
    "${pip[@]}" wheel --no-deps --wheel-dir "$wheel_dir" ${options[@]+"${options[@]}"} . &&
        "${pip[@]}" install --no-deps --force-reinstall "$wheel_dir"/*.whl
}
