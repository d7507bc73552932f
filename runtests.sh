#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# The tests in every language: ./runtests.sh [--all]
# --all adds what takes longer: valgrind, sanitizers, installed copies, the library without extensions, packages, and the tests that
# pytest knows as slow, among them the code of the guide and the examples in Python.
# Same set-up as quickstart.sh, plus the tools of the tests. Status 0 only if all passed and every suite ran tests.
set -uo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")" || exit 1
log_dir=build/logs
source tools/messages.sh
source tools/system_packages.sh
source tools/python_environment.sh

ctest_options=(-LE long) pytest_options=(-m "not slow") all=false
case ${1:-} in
    "") ;;
    --all) ctest_options=() pytest_options=() all=true ;;
    *) give_up "$1 is not an option of ./runtests.sh: it knows --all." ;;
esac

build=build/tests
shared_build=$build # for pip: the library is compiled once
results=build/results
jobs=$(getconf _NPROCESSORS_ONLN 2> /dev/null || echo 2)
export CMAKE_GENERATOR=Ninja # for the projects that the tests configure, too: a bare machine has no make
export OPENBLAS_NUM_THREADS=1 # a process for each core runs already; threads of OpenBLAS that wait for a core cost tenfold
rm -rf "$results"
mkdir -p "$results" "$log_dir"

# check NAME COMMAND...: a check that either passes or fails as a whole.
check() {
    local name=$1
    shift
    if "$@"; then
        echo passed > "$results/$name.check"
    else
        echo failed > "$results/$name.check"
        note "FAILED: $name"
    fi
}

note "This takes about $($all && echo 40 || echo 12) minutes on two cores, after the download of packages."
say "1/6 System packages"
tools=(g++:g++)
on_macos || tools+=(valgrind:valgrind)
python_tools=(fortitude-lint pytest-timeout ruff yamllint)
# the page of mdrcontact app in a browser; elsewhere than on Debian only if there is one
if $all; then
    grep -qs "^ID=debian" /etc/os-release && tools+=(chromium:chromium chromedriver:chromium-driver)
    python_tools+=(selenium axe-core-python)
fi
install_system_packages "${tools[@]}"
say "2/6 Python package in .venv"
install_python_package test "${python_tools[@]}"

say "3/6 Linters and documentation: next to the compilation and ctest; their output follows that of ctest"
linters() {
    check fortitude .venv/bin/fortitude check src tests examples python
    check ruff .venv/bin/ruff check python tests examples docs tools
    check ruff_format .venv/bin/ruff format --check python tests examples docs tools benchmarks
    check mypy .venv/bin/python -m mypy
    check yamllint .venv/bin/yamllint --strict .
    check documentation with_progress "$log_dir/docs.log" docs/build.sh
}
linters > "$log_dir/linters.log" 2>&1 &
linters_job=$!

say "4/6 Library, examples, Fortran and C tests (ctest)"
build_all() {
    with_progress "$log_dir/configure.log" cmake -S . -B "$build" -G Ninja -DMDRCONTACT_WARNINGS_AS_ERRORS=ON \
        -DPython3_EXECUTABLE="$PWD/.venv/bin/python" -DPython_EXECUTABLE="$PWD/.venv/bin/python" &&
        with_progress "$log_dir/build.log" cmake --build "$build" --parallel "$jobs"
}
check build build_all
ctest --test-dir "$build" --parallel "$jobs" ${ctest_options[@]+"${ctest_options[@]}"} --output-on-failure --no-tests=error \
    --test-output-size-passed 1000000 --test-output-size-failed 1000000 --output-junit "$PWD/$results/ctest.xml"
wait "$linters_job"
cat "$log_dir/linters.log"

# the library without any extension: it is built, passes its tests, and is used as installed
core() {
    cmake --preset core -DPython3_EXECUTABLE="$PWD/.venv/bin/python" && cmake --build build/core --parallel "$jobs" &&
        ctest --test-dir build/core --parallel "$jobs" -LE long --output-on-failure --no-tests=error &&
        ctest --test-dir build/core -R "^export_installed$" --output-on-failure --no-tests=error
}
if $all; then
    check core with_progress "$log_dir/core.log" core
fi

# the C tests, the hosts and the kept inputs of the fuzzers under the sanitizers; all of tests/README.md: tools/check_faults.sh
if $all && ! on_macos; then
    check sanitizers with_progress "$log_dir/sanitizers.log" tools/check_faults.sh quick
    check races with_progress "$log_dir/races.log" tools/check_faults.sh races
    check python_sanitizer with_progress "$log_dir/python_sanitizer.log" tools/check_faults.sh python
fi

say "5/6 Python tests (pytest)"
# the Fortran and C code of README and guide uses the library as installed
if with_progress "$log_dir/install.log" cmake --install "$build" --prefix "$PWD/build/prefix"; then
    export MDRCONTACT_PREFIX="$PWD/build/prefix"
fi
# a test that waits for ever fails, with where it waits; the longest takes two minutes
.venv/bin/python -m pytest -n "$jobs" --dist worksteal --timeout=900 ${pytest_options[@]+"${pytest_options[@]}"} \
    --junitxml="$results/pytest.xml" -o junit_family=xunit2

say "6/6 Packages"
if $all && ! on_macos; then
    check packages tools/check_packages.sh "$wheel_dir"/*.whl
else
    note "left out: ./runtests.sh --all, on Linux, looks at them"
fi

say "Summary, after $SECONDS s"
.venv/bin/python tools/summarize_tests.py "$results" ctest pytest
