#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# All benchmarks in one run: ./benchmarks/run.sh. Writes tests/data/benchmarks.md, the tables of docs/benchmarks.md from it, and docs/benchmarks.png.
# Builds the library and a Python environment with the boundary-element codes; what does not install is named in the table.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
build=build/benchmarks
cmake -S . -B "$build" -DMDRCONTACT_BUILD_BENCHMARKS=ON -DMDRCONTACT_BUILD_TESTS=OFF -DMDRCONTACT_BUILD_EXAMPLES=OFF > /dev/null
cmake --build "$build" --parallel 2 --target law_cost law_external exact_states plastic_law_cost > /dev/null
[[ -d $build/venv ]] || python3 -m venv "$build/venv"
"$build/venv/bin/pip" install --quiet . scipy matplotlib
for package in tamaas ContactMechanics aspher; do
    "$build/venv/bin/pip" install --quiet "$package" > "$build/$package.log" 2>&1 || echo "$package does not install here"
done
export OPENBLAS_NUM_THREADS=1 # threads of the library's own are what is measured
page=$build/page # docs is touched at the end only: half a page would break what is built from it meanwhile
mkdir -p "$page"
"$build/venv/bin/python" benchmarks/compare.py "$build/benchmarks/law_cost" "$page"
"$build/benchmarks/law_external" >> "$page/benchmarks.md"
echo >> "$page/benchmarks.md"
late=()
"$build/benchmarks/exact_states" >> "$page/benchmarks.md" || late+=(exact_states)
echo >> "$page/benchmarks.md"
"$build/benchmarks/plastic_law_cost" >> "$page/benchmarks.md" || late+=(plastic_law_cost)
for section in pairs stresses histories tangential coatings tension conduction wear plastic fits; do
    echo >> "$page/benchmarks.md" # a heading right behind a table would be a row of it
    "$build/venv/bin/python" "benchmarks/$section.py" >> "$page/benchmarks.md" || late+=("$section")
done
cat -s "$page/benchmarks.md" > tests/data/benchmarks.md
"$build/venv/bin/python" docs/make_tables.py benchmarks.md
mv "$page/benchmarks.png" docs
[[ ${#late[@]} -eq 0 ]] || echo "budgets are missed in: ${late[*]}"
