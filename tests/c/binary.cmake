# SPDX-License-Identifier: GPL-3.0-or-later
# What the compiled library must not have: writable static data, which threads would share, global symbols of names that a program
# may use, and an executable stack.
execute_process(COMMAND "${nm}" "${library}" OUTPUT_VARIABLE symbols RESULT_VARIABLE result)
if(NOT result EQUAL 0 OR NOT symbols MATCHES "mdr_contact_new")
  message(FATAL_ERROR "${nm} ${library} did not list the library's symbols")
endif()
string(REGEX MATCHALL "[^\n]+ [bBdD] [^\n]+" data "${symbols}")
# Type descriptors of the compiler, which for flang are read-only once relocated; the error text, the number of threads, the question
# whether to stop and the arithmetic of the host, which are thread-local; and an atomic that says whether GSL's handler is off.
list(FILTER data EXCLUDE REGEX "(___vtab_|___def_init_|__copy_|XDerivedInit$| last_text$| last_length$| last_failure$| wanted_threads$| cancel_state$| host_arithmetic$| handler_state$)")
if(data)
  string(REPLACE ";" "\n" data "${data}")
  message(FATAL_ERROR "static data in ${library}:\n${data}")
endif()

# Global symbols: mdr_... in both libraries; in the static one also the module procedures and constants, which flang names _QM..., _QQ...
# and _FortranA..., the C functions that Fortran calls and the objects of GSL that it refers to.
string(REGEX MATCHALL "[^\n]+ [TDBRCVW] [^\n]+" global "${symbols}")
list(FILTER global EXCLUDE REGEX " [TDBRCVW] (mdr_[a-z0-9_]+|gsl_[a-z_]+|mdrcontact_[a-z0-9_]+|__mdrcontact_.*|__copy_.*|_Q[MQ].*|_FortranA.*|\\.gomp_critical_user_mdrcontact_.*)$")
if(global)
  string(REPLACE ";" "\n" global "${global}")
  message(FATAL_ERROR "global symbols in ${library}:\n${global}")
endif()
execute_process(COMMAND "${nm}" -D --defined-only "${shared_library}" OUTPUT_VARIABLE exported RESULT_VARIABLE result)
if(NOT result EQUAL 0 OR NOT exported MATCHES "mdr_contact_new")
  message(FATAL_ERROR "${nm} -D ${shared_library} did not list the library's symbols")
endif()
string(REGEX MATCHALL "[^\n]+" exported "${exported}")
list(FILTER exported EXCLUDE REGEX " (T mdr_[a-z0-9_]+@@MDR_[0-9.]+|A MDR_[0-9.]+)$")
if(exported)
  string(REPLACE ";" "\n" exported "${exported}")
  message(FATAL_ERROR "symbols exported from ${shared_library}:\n${exported}")
endif()

if(readelf)
  execute_process(COMMAND "${readelf}" -l -W "${shared_library}" OUTPUT_VARIABLE segments)
  if(NOT segments MATCHES "GNU_STACK[^\n]* RW ")
    message(FATAL_ERROR "${shared_library} lacks the mark of a stack that cannot be executed:\n${segments}")
  endif()
endif()
