# SPDX-License-Identifier: GPL-3.0-or-later
# Runs f2py as a generator. Where it does not know a type it guesses one, says so in its log only, and the results are silently
# wrong: a guess is an error here.
execute_process(
  COMMAND "${PYTHON}" -m numpy.f2py -m "${MODULE}" --lower ${SOURCES}
  WORKING_DIRECTORY "${DIRECTORY}"
  OUTPUT_VARIABLE log ERROR_VARIABLE log RESULT_VARIABLE result)
file(WRITE "${DIRECTORY}/f2py.log" "${log}")
if(NOT result EQUAL 0)
  message(FATAL_ERROR "f2py failed:\n${log}")
endif()
string(REGEX MATCHALL "[^\n]*(is mapped to C|getctype:|[Nn]o typespec|[Uu]nknown type)[^\n]*" guesses "${log}")
if(guesses)
  list(JOIN guesses "\n" guesses)
  message(FATAL_ERROR "f2py guessed a type:\n${guesses}")
endif()
