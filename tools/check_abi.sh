#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Whether programs compiled against an earlier version run with today's shared library: tools/check_abi.sh [REVISION]
# The library of REVISION - the last tag v*, if none is given - and that of the working tree are compared by abidiff (abigail-tools).
# Status 0 if functions were added at most; 1 if one is gone or a type has changed, which abidiff's report then names.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
log_dir=$PWD/build/logs
source tools/messages.sh

command -v abidiff > /dev/null || give_up "abidiff is missing: install abigail-tools."
before=${1:-$(git describe --tags --abbrev=0 --match 'v*' 2> /dev/null || true)}
if [[ -z $before ]]; then
    note "no tag v* yet: nothing to compare with; tools/check_abi.sh REVISION compares with any commit"
    exit 0
fi
place=$PWD/build/abi
mkdir -p "$place" "$log_dir"

library_of() { # SOURCES BUILD: compiled with what abidiff reads, quickly
    cmake -S "$1" -B "$2" -G Ninja -DCMAKE_BUILD_TYPE=Debug -DMDRCONTACT_BUILD_TESTS=OFF -DMDRCONTACT_BUILD_EXAMPLES=OFF &&
        cmake --build "$2" --target mdrcontact_shared
}

rm -rf "$place/sources"
mkdir "$place/sources"
git archive "$before" | tar -x -C "$place/sources" || give_up "There is no revision $before."
with_progress "$log_dir/abi-before.log" library_of "$place/sources" "$place/before" || give_up "$before does not build."
with_progress "$log_dir/abi-after.log" library_of . "$place/after" || give_up "The working tree does not build."
status=0
abidiff --no-added-syms --headers-dir1 "$place/sources/include" --headers-dir2 include \
    "$place/before/src/libmdrcontact.so" "$place/after/src/libmdrcontact.so" || status=$?
[[ $status == 0 ]] || give_up "The interface has changed since $before."
note "programs compiled against $before run with this library"
