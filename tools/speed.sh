#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Is the library slower than it was? Times of an earlier build and of the present one, by turns in the order A B B A:
#
#     tools/speed.sh keep build/before        # before a change: keeps the package and the programs of build/tests
#     tools/speed.sh build/before [ROUNDS]    # after it: medians of 9 rounds, ratios; status 1 if one is above 1.05
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
python=$PWD/.venv/bin/python
export OPENBLAS_NUM_THREADS=1

# keep FOLDER: the Python package with its library, and the timing programs
keep() {
    rm -rf "$1"
    mkdir -p "$1"
    cp -rL python/mdrcontact tools/speed.py "$1"
    cp -L --remove-destination build/tests/python/_native*.so "$1/mdrcontact"
    cc -O3 -std=c11 -Iinclude tools/speed.c build/tests/src/libmdrcontact.a \
        -lgsl -lgslcblas -llapack -lblas -lgfortran -lgomp -lmvec -lm -o "$1/speed"
}

measure() { "$1/speed" && PYTHONPATH=$1 "$python" -P "$1/speed.py"; }

if [[ ${1:-} == keep && -n ${2:-} ]]; then
    keep "$2"
    exit
fi
sides=("${1:?"a folder made by tools/speed.sh keep"}" build/speed) names=(old new)
times=$(mktemp -d)
trap 'rm -r "$times"' EXIT
keep "${sides[1]}"
for ((round = 0; round < ${2:-9}; ++round)); do
    for ((turn = 0; turn < 2; ++turn)); do
        side=$(((round + turn) % 2))
        measure "${sides[side]}" >> "$times/${names[side]}"
    done
    printf 'round %d\r' "$((round + 1))" >&2
done
"$python" - "$times/old" "$times/new" << 'CODE'
import statistics, sys

def medians(path):
    rows = {}
    for line in open(path):
        name, value = line.rsplit(": ", 1)
        rows.setdefault(name, []).append(float(value))
    return {name: statistics.median(values) for name, values in rows.items()}

old, new = map(medians, sys.argv[1:])
slower = 0
for name in (name for name in old if name in new):
    ratio = new[name] / old[name]
    slower += ratio > 1.05
    print(f"{name:36}{old[name]:12.4g}{new[name]:12.4g}{ratio:8.3f}{'  slower' if ratio > 1.05 else ''}")
sys.exit(slower > 0)
CODE
