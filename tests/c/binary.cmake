# SPDX-License-Identifier: GPL-3.0-or-later
# What the compiled library must not have: writable static data, which threads would share, and an executable stack.
execute_process(COMMAND "${nm}" "${library}" OUTPUT_VARIABLE symbols RESULT_VARIABLE result)
if(NOT result EQUAL 0 OR NOT symbols MATCHES "mdr_contact_new")
  message(FATAL_ERROR "${nm} ${library} did not list the library's symbols")
endif()
string(REGEX MATCHALL "[^\n]+ [bBdD] [^\n]+" data "${symbols}")
# Type descriptors of the compiler, the error text, which is thread-local, and an atomic that says whether GSL's handler is off.
list(FILTER data EXCLUDE REGEX "(___vtab_|___def_init_|__copy_| last_text$| last_length$| handler_state$)")
if(data)
  string(REPLACE ";" "\n" data "${data}")
  message(FATAL_ERROR "static data in ${library}:\n${data}")
endif()

if(readelf)
  execute_process(COMMAND "${readelf}" -l -W "${shared_library}" OUTPUT_VARIABLE segments)
  if(NOT segments MATCHES "GNU_STACK[^\n]* RW ")
    message(FATAL_ERROR "${shared_library} does not ask for a stack that cannot be executed:\n${segments}")
  endif()
endif()
