#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# The tests with every checker switched on: tools/check_faults.sh [address | quick | python | traps | thread | races | all]
#   address  AddressSanitizer, LeakSanitizer, UndefinedBehaviorSanitizer over the Fortran and C tests
#   quick    the same over the C tests, the hosts and the kept inputs of the fuzzers only
#   traps    run-time checks of gfortran, copies of arrays among them; in Fortran programs an invalid operation, a division by zero
#            or an overflow ends the program
#   thread   helgrind over threads that share every kind of object
#   races    ThreadSanitizer over the same and a host of 4 threads, of a library without OpenMP, whose barriers it does not know
# Status 0 only if all tests passed. tests/README.md says what each of them finds.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
build=build/faults
jobs=$(nproc 2> /dev/null || echo 2)
export CMAKE_GENERATOR=Ninja OPENBLAS_NUM_THREADS=1

# build_and_test NAME C_FLAGS FORTRAN_FLAGS TARGETS CTEST_ARGUMENTS...
build_and_test() {
    local name=$1 c_flags=$2 fortran_flags=$3 targets
    read -ra targets <<< "$4"
    shift 4
    mkdir -p "$build"
    cmake -S . -B "$build/$name" -DCMAKE_BUILD_TYPE=None -DCMAKE_C_FLAGS="$c_flags" -DCMAKE_CXX_FLAGS="$c_flags" \
        -DCMAKE_Fortran_FLAGS="$fortran_flags" -DMDRCONTACT_BUILD_EXAMPLES=OFF "-DMDRCONTACT_OPENMP=${openmp:-ON}" > "$build/$name.log"
    cmake --build "$build/$name" --parallel "$jobs" --target "${targets[@]}" >> "$build/$name.log" || {
        tail -n 40 "$build/$name.log"
        return 1
    }
    ctest --test-dir "$build/$name" --parallel "$jobs" --output-on-failure --no-tests=error "$@"
}

# valgrind cannot run what the sanitizers changed; export configures projects of its own, without the flags; c_memory brings
# a malloc and c_binary counts the static data of the library alone.
# Two copies of the library have the same names of their own, and 2^31 numbers need addresses that the sanitizers take.
without="valgrind|helgrind|export|c_memory|c_binary|host_copies|host_many"

# check_address TARGETS CTEST_ARGUMENTS...
check_address() {
    local flags="-g -O2 -fno-omit-frame-pointer -fsanitize=address,undefined,float-cast-overflow -fno-sanitize-recover=all"
    ASAN_OPTIONS=detect_leaks=1:detect_stack_use_after_return=1 UBSAN_OPTIONS=print_stacktrace=1 \
        build_and_test address "$flags" "$flags" "$@" -E "$without"
}

# NumPy keeps small arrays that were freed; the tests look at those themselves. Python's own allocator would hide the rest.
check_python() {
    local place=$build/python/package flags="-g -O2 -fno-omit-frame-pointer -fsanitize=address"
    mkdir -p "$build"
    cmake -S . -B "$build/python" -DCMAKE_BUILD_TYPE=None -DCMAKE_C_FLAGS="$flags" -DCMAKE_Fortran_FLAGS="$flags" \
        -DMDRCONTACT_BUILD_PYTHON=ON -DMDRCONTACT_BUILD_TESTS=OFF -DMDRCONTACT_BUILD_EXAMPLES=OFF \
        -DPython3_EXECUTABLE="$PWD/.venv/bin/python" -DPython_EXECUTABLE="$PWD/.venv/bin/python" > "$build/python.log"
    cmake --build "$build/python" --parallel "$jobs" --target mdrcontact_python >> "$build/python.log" || {
        tail -n 40 "$build/python.log"
        return 1
    }
    rm -rf "$place"
    mkdir -p "$place"
    cp -r python/mdrcontact "$place"
    cp "$build"/python/python/_native*.so "$place/mdrcontact"
    LD_PRELOAD=$(gcc -print-file-name=libasan.so) PYTHONMALLOC=malloc ASAN_OPTIONS=detect_leaks=0 PYTHONPATH="$place" \
        .venv/bin/python -m pytest -q -p no:cacheprovider tests/python/test_objects.py tests/python/test_native.py \
        tests/python/test_pickles.py -k "not memory_is_lost and not exported"
}

# Only Fortran programs set traps. Left out: test_layered_and_graded takes the root of a negative number on purpose, and
# test_adhesion takes works of adhesion at the ends of the number range, where the overflow is what the library reports.
check_traps() {
    build_and_test traps "-g -O1" "-g -O2 -fcheck=all,no-recursion -ffpe-trap=invalid,zero,overflow -finit-real=snan" \
        all -R "^(test_|c_)" -E "^(test_layered_and_graded|test_adhesion)$|$without"
}

check_races() {
    local flags="-g -O1 -fsanitize=thread"
    TSAN_OPTIONS=halt_on_error=1 build_and_test races "$flags" "$flags" "tests/c/all tests/hosts/all" -R "^(c_threads|host_threads)"
}

check_thread() {
    build_and_test thread "-g -O2" "-g -O2" tests/c/all -R "helgrind"
}

case ${1:-all} in
    address) check_address all ;;
    quick)
        without+="|c_rounding" # calls of the threads' hosts once more, rounded otherwise
        check_address "tests/c/all tests/fuzz/all tests/hosts/all" -R "^(c_|fuzz_replay|host_)"
        ;;
    python) check_python ;;
    traps) check_traps ;;
    thread) check_thread ;;
    races) openmp=OFF check_races ;;
    all) check_address all && check_traps && check_thread && openmp=OFF check_races ;;
    *) sed -n '3,9s/^# //p' "${BASH_SOURCE[0]}" && exit 2 ;;
esac
