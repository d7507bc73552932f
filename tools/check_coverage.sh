#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# How much of the Fortran core the Fortran and C tests run through: tools/check_coverage.sh [lowest percentage, 95]
# Needs gcovr in .venv or on PATH. Prints every file with lines that no test reaches; status 1 below the lowest percentage.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
lowest=${1:-95}
build=build/coverage
jobs=$(nproc 2> /dev/null || echo 2)
[[ -x .venv/bin/gcovr ]] && gcovr=.venv/bin/gcovr || gcovr=gcovr

# -O0: lines as they are written. Examples and the tests of the installation would add nothing.
cmake -S . -B "$build" -G Ninja -DCMAKE_BUILD_TYPE=Debug -DMDRCONTACT_BUILD_EXAMPLES=OFF \
    -DCMAKE_Fortran_FLAGS="--coverage -fprofile-update=atomic -O0" -DCMAKE_C_FLAGS="--coverage -fprofile-update=atomic -O0" > "$build.configure.log"
cmake --build "$build" --parallel "$jobs" > "$build.build.log"
find "$build" -name '*.gcda' -delete
ctest --test-dir "$build" --parallel "$jobs" --no-tests=error --output-on-failure --tests-regex '^(test_|c_)' --exclude-regex 'c_binary'
# Counters of loops grow beyond what gcovr takes for sound, and it does not find bodies that are included.
"$gcovr" --root . --object-directory "$build" --filter 'src/mdrcontact/' --merge-mode-functions=separate \
    --gcov-ignore-parse-errors=all --gcov-ignore-errors=source_not_found --gcov-ignore-errors=no_working_dir_found \
    --sort uncovered-percent --txt "$build.txt" --json-summary "$build.json" --fail-under-line "$lowest" --print-summary \
    "$build/src" 2> "$build.gcovr.log" || status=$?
awk '$4 ~ /%/ && $4 != "100%"' "$build.txt"
exit "${status:-0}"
