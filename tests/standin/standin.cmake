# SPDX-License-Identifier: GPL-3.0-or-later
# Runs pFUnit test files where pFUnit is not installed; the function has the name and the arguments of pFUnit's own.
find_package(Python3 REQUIRED COMPONENTS Interpreter)

set(standin_dir "${CMAKE_CURRENT_LIST_DIR}")
add_library(pfunit_standin STATIC
  "${standin_dir}/test_record.f90" "${standin_dir}/test_words.f90" "${standin_dir}/assert_condition.f90"
  "${standin_dir}/assert_exact.f90" "${standin_dir}/assert_real.f90" "${standin_dir}/funit.f90")
set_target_properties(pfunit_standin PROPERTIES Fortran_MODULE_DIRECTORY "${CMAKE_CURRENT_BINARY_DIR}/standin_modules")
target_include_directories(pfunit_standin PUBLIC "${CMAKE_CURRENT_BINARY_DIR}/standin_modules")
mdrcontact_set_flags(pfunit_standin)

# add_standin_ctest(name TEST_SOURCES file.pf LINK_LIBRARIES library...): one program from one test file, and its test.
function(add_standin_ctest name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "TEST_SOURCES" "LINK_LIBRARIES")
  get_filename_component(source "${arg_TEST_SOURCES}" ABSOLUTE)
  set(translated "${CMAKE_CURRENT_BINARY_DIR}/${name}_translated/${name}.F90")
  file(MAKE_DIRECTORY "${CMAKE_CURRENT_BINARY_DIR}/${name}_translated")
  add_custom_command(OUTPUT "${translated}"
    COMMAND Python3::Interpreter "${CMAKE_CURRENT_FUNCTION_LIST_DIR}/translate_pf.py" "${source}" "${translated}"
    DEPENDS "${source}" "${CMAKE_CURRENT_FUNCTION_LIST_DIR}/translate_pf.py"
    COMMENT "Translating ${name}.pf" VERBATIM)
  add_executable(${name} "${translated}")
  set_target_properties(${name} PROPERTIES Fortran_MODULE_DIRECTORY "${CMAKE_CURRENT_BINARY_DIR}/${name}_modules")
  target_link_libraries(${name} PRIVATE pfunit_standin ${arg_LINK_LIBRARIES})
  mdrcontact_set_test_flags(${name})
  add_test(NAME ${name} COMMAND ${name})
endfunction()
