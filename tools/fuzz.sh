#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# The coverage-guided fuzzers, one after the other: tools/fuzz.sh [SECONDS each, 60] [c_api | law | readers ...]
#   c_api    the whole C API                      } libFuzzer (libfuzzer-14-dev), library with AddressSanitizer,
#   law      the reader of saved laws             } UndefinedBehaviorSanitizer and the run-time checks of gfortran
#   readers  problem files, fit files and tables    atheris, in an environment of its own
# What they find lies in build/fuzz/findings; the corpora grow in build/fuzz, not in tests/fuzz/corpus: see docs/faults.md.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
seconds=${1:-60}
shift || true
targets=("$@")
((${#targets[@]})) || targets=(c_api law readers)
build=build/fuzz
mkdir -p "$build/findings"
export OPENBLAS_NUM_THREADS=1

build_library_fuzzers() {
    local checks="-g -O1 -fno-omit-frame-pointer -fsanitize=address,undefined,float-cast-overflow -fno-sanitize-recover=all"
    cmake -S . -B "$build/native" -G Ninja -DCMAKE_BUILD_TYPE=None -DMDRCONTACT_FUZZERS=ON -DMDRCONTACT_OPENMP=OFF \
        -DMDRCONTACT_BUILD_EXAMPLES=OFF -DCMAKE_C_FLAGS="$checks" \
        -DCMAKE_Fortran_FLAGS="$checks -fcheck=bounds,do,mem,pointer" > "$build/configure.log"
    cmake --build "$build/native" --parallel 2 > "$build/build.log"
}

fuzz() {
    local target=$1 options=(-max_total_time="$seconds" -timeout=30 -rss_limit_mb=3000 -print_final_stats=1)
    options+=(-artifact_prefix="$build/findings/$target-")
    mkdir -p "$build/$target"
    case $target in
        readers)
            [[ -d $build/venv ]] || python3 -m venv "$build/venv"
            "$build/venv/bin/pip" install --quiet . atheris
            "$build/venv/bin/python" tests/fuzz/readers/fuzz_readers.py "${options[@]}" -max_len=1500 \
                -dict=tests/fuzz/readers/words.dict "$build/$target" tests/fuzz/corpus/readers
            ;;
        *)
            build_library_fuzzers
            "$build/native/tests/fuzz/fuzz_$target" "${options[@]}" -max_len="$([[ $target == law ]] && echo 9000 || echo 600)" \
                "$build/$target" "tests/fuzz/corpus/$target"
            ;;
    esac
}

for target in "${targets[@]}"; do
    fuzz "$target"
done
