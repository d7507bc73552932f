# SPDX-License-Identifier: GPL-3.0-or-later
# Runs each of `programs` under `valgrind`; any error or lost block is a failure.
foreach(program IN LISTS programs)
  execute_process(
    COMMAND "${valgrind}" --quiet --leak-check=full --show-leak-kinds=all --errors-for-leak-kinds=all --error-exitcode=99 "--suppressions=${CMAKE_CURRENT_LIST_DIR}/openmp.supp"
      "${program}"
    RESULT_VARIABLE result)
  if(NOT result EQUAL 0)
    message(FATAL_ERROR "${program} under valgrind: ${result}")
  endif()
endforeach()
