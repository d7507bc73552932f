# SPDX-License-Identifier: GPL-3.0-or-later
# Test programs under valgrind, where it is installed. The longest tests begin first.
find_program(VALGRIND valgrind)

# Helgrind does not know how OpenBLAS keeps its own threads in step: there are none. Valgrind computes fused multiplications in
# hundreds of instructions: OpenBLAS takes a kernel without them.
set(valgrind_environment OPENBLAS_NUM_THREADS=1)
if(CMAKE_SYSTEM_PROCESSOR MATCHES "^(x86_64|AMD64|amd64)$")
  list(APPEND valgrind_environment OPENBLAS_CORETYPE=Nehalem)
endif()

# mdrcontact_add_valgrind(TARGET): errors and lost blocks are failures.
function(mdrcontact_add_valgrind target)
  if(VALGRIND)
    add_test(NAME valgrind_${target} COMMAND "${VALGRIND}" --quiet --leak-check=full --show-leak-kinds=all
      --errors-for-leak-kinds=all --error-exitcode=99 "--suppressions=${PROJECT_SOURCE_DIR}/tests/openmp.supp"
      $<TARGET_FILE:${target}>)
    set_tests_properties(valgrind_${target} PROPERTIES TIMEOUT 1800 COST 10 ENVIRONMENT "${valgrind_environment}")
  endif()
endfunction()

# mdrcontact_add_helgrind(NAME TARGET ARGUMENTS...): data races are failures.
function(mdrcontact_add_helgrind name target)
  if(VALGRIND)
    add_test(NAME ${name} COMMAND "${VALGRIND}" --tool=helgrind --quiet --error-exitcode=1 $<TARGET_FILE:${target}> ${ARGN})
    set_tests_properties(${name} PROPERTIES TIMEOUT 1800 COST 20 ENVIRONMENT "${valgrind_environment}")
  endif()
endfunction()
