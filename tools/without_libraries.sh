#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Runs a command on a machine that seems to have no compiler, GSL, LAPACK, BLAS or Fortran runtime library:
#   unshare --mount tools/without_libraries.sh COMMAND...            as root
#   unshare --mount --map-root-user tools/without_libraries.sh COMMAND...
# In a mount namespace of its own it lays an empty file over each of them; the machine itself stays as it is.
set -euo pipefail

hide() {
    local path
    path=$(readlink -f "$1") && [[ -f $path ]] && mount --bind /dev/null "$path"
}

hidden=0
for library in $(/sbin/ldconfig -p | grep -E '/lib(gsl|gslcblas|blas|lapack|openblas[a-z0-9]*|gfortran|quadmath|gomp)\.so' |
    sed 's/.*=> //' | xargs -r -n 1 readlink -f | sort -u); do
    hide "$library"
    hidden=$((hidden + 1))
done
for program in gcc gfortran cc c++ g++ clang f77 f95 ld as cmake ninja make pkg-config; do
    for folder in ${PATH//:/ } /usr/bin /bin /usr/local/bin; do
        [[ -x $folder/$program && -s $folder/$program ]] && hide "$folder/$program"
    done
done
printf '   %s\n' "$hidden system libraries are hidden, and every compiler"
if gfortran --version > /dev/null 2>&1 || gcc --version > /dev/null 2>&1; then
    echo "a compiler still runs" >&2
    exit 1
fi
exec env -i PATH=/usr/bin:/bin HOME="${HOME:-/}" LANG=C.UTF-8 "$@"
