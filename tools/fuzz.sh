#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# The coverage-guided fuzzers, one after the other: tools/fuzz.sh [MINUTES in total, 3] [c_api | law | readers ...]
#   c_api    the whole C API                      } libFuzzer (libfuzzer-14-dev), library with AddressSanitizer,
#   law      the reader of saved laws             } UndefinedBehaviorSanitizer and the run-time checks of gfortran
#   readers  problem files, fit files and tables    atheris, in an environment of its own
# Prints executions, features reached and findings of each target, and fails if there is a finding; a finding is kept in
# build/fuzz/findings, and the target goes on. The corpora grow in build/fuzz, not in tests/fuzz/corpus: see tests/README.md.
# Two of these commands may run at a time.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
minutes=${1:-3}
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

install_package() {
    [[ -d $build/venv ]] || python3 -m venv "$build/venv"
    "$build/venv/bin/pip" install --quiet . atheris
}

# prepare TARGET: sets the command that fuzzes it.
prepare() {
    case $1 in
        readers)
            install_package
            command=("$build/venv/bin/python" tests/fuzz/readers/fuzz_readers.py -max_len=1500
                -dict=tests/fuzz/readers/words.dict)
            ;;
        *)
            build_library_fuzzers
            command=("$build/native/tests/fuzz/fuzz_$1" -max_len="$([[ $1 == law ]] && echo 9000 || echo 600)")
            ;;
    esac
}

# fuzz TARGET SECONDS: a fuzzer ends at what it finds; begin again until the time is over.
fuzz() {
    local target=$1 end=$((SECONDS + $2)) log executions=0 features=0 findings=0 count
    log=$(mktemp "$build/$target-XXXXXX.log")
    mkdir -p "$build/$target"
    while ((SECONDS < end)); do
        "${command[@]}" -max_total_time=$((end - SECONDS)) -timeout=120 -rss_limit_mb=3000 -print_final_stats=1 \
            -artifact_prefix="$build/findings/$target-" "$build/$target" "tests/fuzz/corpus/$target" > "$log" 2>&1 \
            || { ((++findings)) && grep -aE '^FINDING|ERROR|SUMMARY|Test unit written' "$log" || tail "$log"; }
        count=$(grep -a number_of_executed_units "$log" | tail -1 | tr -dc 0-9) || { tail "$log" && return 1; }
        executions=$((executions + count))
        count=$(grep -aoE ' ft: [0-9]+' "$log" | tail -1 | tr -dc 0-9) || true
        features=$((${count:-0} > features ? count : features))
    done
    printf '%-8s %12d executions %8d features %4d findings in %d s\n' "$target" "$executions" "$features" "$findings" "$2"
    found=$((found + findings))
}

found=0
for target in "${targets[@]}"; do
    exec 9> "$build/lock"
    flock 9
    prepare "$target"
    exec 9>&-
    fuzz "$target" $((60 * minutes / ${#targets[@]}))
done
((found == 0))
