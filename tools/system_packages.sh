# SPDX-License-Identifier: GPL-3.0-or-later
# What the build needs from the system: finds what is missing and installs it by apt, or says what to install.
# Sourced by quickstart.sh, runtests.sh and check_packages.sh; needs messages.sh.
# shellcheck shell=bash disable=SC2154  # who sources this sets log_dir

on_macos() { [[ $(uname) == Darwin ]]; }

# Whether the linker of gfortran finds lib$1.
has_library() {
    local found
    found=$(gfortran -print-file-name="lib$1.so" 2> /dev/null) && [[ $found == */* ]]
}

has_header() { printf '#include <%s>\n' "$1" | gcc -E -x c - > /dev/null 2>&1; }

# CMake calls pkg-config first, which knows folders that compilers do not search by themselves.
has_gsl() { pkg-config --exists 'gsl >= 2.5' 2> /dev/null || { has_library gsl && has_header gsl/gsl_version.h; }; }

# macOS always has LAPACK and BLAS, in its framework Accelerate.
has_lapack() { on_macos || { has_library lapack && has_library blas; }; }

# CMake 3.22 or newer.
has_cmake() {
    local major minor
    IFS=. read -r major minor _ <<< "$(cmake --version 2> /dev/null | sed -n '1s/[^0-9]*\([0-9.]*\).*/\1/p')"
    ((${major:-0} > 3 || (${major:-0} == 3 && ${minor:-0} >= 22)))
}

# A Python that can make virtual environments and compile extension modules.
python_is_complete() {
    "$1" - > /dev/null 2>&1 << 'CODE'
import ensurepip, os, sys, sysconfig, venv
assert sys.version_info >= (3, 10)
assert os.path.exists(os.path.join(sysconfig.get_path("include"), "Python.h"))
CODE
}

# The first complete Python among $PYTHON, the one on PATH and the system's; nothing if there is none.
find_python() {
    local candidate
    for candidate in ${PYTHON:+"$PYTHON"} python3 /usr/bin/python3; do
        if python_is_complete "$candidate"; then
            command -v "$candidate"
            return
        fi
    done
}

# Prints the Debian packages that are missing. Arguments: further commands that are wanted, as command:package.
missing_packages() {
    local wanted
    command -v gfortran > /dev/null || echo gfortran
    { command -v gcc > /dev/null && has_header stdlib.h; } || echo gcc libc6-dev
    has_cmake || echo cmake
    command -v ninja > /dev/null || echo ninja-build
    command -v pkg-config > /dev/null || echo pkg-config
    has_gsl || echo libgsl-dev
    has_lapack || echo libopenblas-dev
    [[ -n $(find_python) ]] || echo python3 python3-dev python3-venv
    for wanted in "$@"; do
        command -v "${wanted%%:*}" > /dev/null || echo "${wanted#*:}"
    done
}

# Installs what is missing. Arguments as for missing_packages.
install_system_packages() {
    local packages as_root=()
    # shellcheck disable=SC2046,SC2005  # one line of words is meant
    packages=$(echo $(missing_packages "$@"))
    if [[ -z $packages ]]; then
        note "the system has all that is needed"
        return
    fi
    if ! command -v apt-get > /dev/null; then
        give_up "These are missing, under their Debian names: $packages" \
            "This script installs them on Debian and Ubuntu only. With dnf they are called" \
            "  gcc-gfortran gcc cmake ninja-build pkgconf gsl-devel openblas-devel lapack-devel python3-devel valgrind gcc-c++," \
            "with brew  gcc cmake ninja pkgconf gsl python. Install them and run this again."
    fi
    if [[ $(id -u) != 0 ]]; then
        command -v sudo > /dev/null ||
            give_up "Missing: $packages" "Only root can install them here, and there is no sudo. As root:  apt-get install $packages"
        as_root=(sudo)
        note "sudo may need your password to install: $packages"
        sudo -v || give_up "Without it, an administrator can install them:  apt-get install $packages"
        as_root+=(env)
    else
        as_root=(env)
    fi
    note "installing $packages"
    with_progress "$log_dir/apt-update.log" "${as_root[@]}" DEBIAN_FRONTEND=noninteractive apt-get update ||
        give_up "apt-get could not read its package lists; is there a network?"
    # shellcheck disable=SC2086  # one word per package is meant
    with_progress "$log_dir/apt-install.log" "${as_root[@]}" DEBIAN_FRONTEND=noninteractive \
        apt-get install --yes --no-install-recommends $packages || give_up "apt-get could not install: $packages"
    hash -r
    # shellcheck disable=SC2046,SC2005
    packages=$(echo $(missing_packages "$@"))
    [[ -z $packages ]] || give_up "Still missing or too old after the installation: $packages" \
        "CMake 3.22 and Python 3.10 or newer are needed: Debian 12, Ubuntu 22.04 or later have them."
}
