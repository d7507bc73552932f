# SPDX-License-Identifier: GPL-3.0-or-later
# Installs, moves the installed folder, builds tests/export/project on it by CMake and by pkg-config, and runs the programs.
set(ENV{DESTDIR}) # a packager's: the tests install where they say
function(run)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if(NOT result EQUAL 0)
    string(REPLACE ";" " " command "${ARGN}")
    message(FATAL_ERROR "${command}\nfailed (${result}):\n${output}")
  endif()
  set(output "${output}" PARENT_SCOPE)
endfunction()

# The programs print a line that says which result they checked.
function(run_checked program)
  run(${CMAKE_COMMAND} -E env "LD_LIBRARY_PATH=${prefix}/${lib_dir}"
      "DYLD_LIBRARY_PATH=${prefix}/${lib_dir}" "${program}")
  if(NOT output MATCHES "checks passed")
    message(FATAL_ERROR "${program} printed: ${output}")
  endif()
  message(STATUS "${program}: ${output}")
endfunction()

file(REMOVE_RECURSE "${work_dir}")
set(prefix "${work_dir}/moved")
run(${CMAKE_COMMAND} --install "${build_dir}" --prefix "${work_dir}/installed" --config "${config}")
file(RENAME "${work_dir}/installed" "${prefix}")

# What was installed knows nothing of where it was built.
file(GLOB_RECURSE texts "${prefix}/*.cmake" "${prefix}/*.pc")
if(NOT texts)
  message(FATAL_ERROR "no package files were installed")
endif()
foreach(file IN LISTS texts)
  file(READ "${file}" text)
  foreach(place IN ITEMS "${build_dir}" "${work_dir}")
    string(FIND "${text}" "${place}" position)
    if(NOT position EQUAL -1)
      message(FATAL_ERROR "${file} contains ${place}")
    endif()
  endforeach()
endforeach()

run(${CMAKE_COMMAND} -S "${source_dir}" -B "${work_dir}/cmake" -G "${generator}" "-DCMAKE_PREFIX_PATH=${prefix}"
  "-DCMAKE_C_COMPILER=${c_compiler}" "-DCMAKE_Fortran_COMPILER=${fortran_compiler}")
run(${CMAKE_COMMAND} --build "${work_dir}/cmake")
foreach(program IN ITEMS c_shared c_static fortran_static)
  run_checked("${work_dir}/cmake/${program}")
endforeach()

# Projects without Fortran; with the shared library, without GSL and LAPACK.
foreach(language IN ITEMS C CXX)
  if(language STREQUAL "CXX" AND NOT cxx_compiler)
    message(STATUS "there is no C++ compiler: not tested")
    continue()
  endif()
  foreach(kind IN ITEMS shared static)
    set(dir "${work_dir}/${language}_${kind}")
    run(${CMAKE_COMMAND} -S "${source_dir}/c_only" -B "${dir}" -G "${generator}" "-DCMAKE_PREFIX_PATH=${prefix}"
      -Dlanguage=${language} -Dkind=${kind} "-DCMAKE_C_COMPILER=${c_compiler}" "-DCMAKE_CXX_COMPILER=${cxx_compiler}")
    run(${CMAKE_COMMAND} --build "${dir}")
    run_checked("${dir}/program")
  endforeach()
endforeach()

# What is no component is named.
file(WRITE "${work_dir}/unknown/CMakeLists.txt" "cmake_minimum_required(VERSION 3.22)
project(unknown LANGUAGES NONE)
find_package(mdrcontact REQUIRED COMPONENTS shared statik)
")
execute_process(COMMAND ${CMAKE_COMMAND} -S "${work_dir}/unknown" -B "${work_dir}/unknown/build" "-DCMAKE_PREFIX_PATH=${prefix}"
  RESULT_VARIABLE result ERROR_VARIABLE output OUTPUT_QUIET)
string(REGEX REPLACE "[ \n]+" " " output "${output}")
if(result EQUAL 0 OR NOT output MATCHES "mdrcontact has no component statik, but shared and static")
  message(FATAL_ERROR "an unknown component gives: ${output}")
endif()

# What is there, and nothing of the inside.
foreach(file IN ITEMS include/mdrcontact.h include/mdrcontact/law.h include/mdrcontact_law.h include/mdrcontact.hpp ${doc_dir}/LICENSE)
  if(NOT EXISTS "${prefix}/${file}")
    message(FATAL_ERROR "${file} is not installed")
  endif()
endforeach()
file(GLOB_RECURSE modules RELATIVE "${prefix}/include/mdrcontact/modules" "${prefix}/include/mdrcontact/modules/*")
if(fortran_id STREQUAL "GNU" AND NOT modules MATCHES "^GNU-[0-9]+/mdrcontact.mod$")
  message(FATAL_ERROR "installed modules: ${modules}")
endif()

if(pkg_config)
  set(ENV{PKG_CONFIG_PATH} "${prefix}/${pc_dir}")
  foreach(package IN ITEMS mdrcontact mdrcontact-static)
    run(${pkg_config} --cflags --libs ${package})
    separate_arguments(${package} UNIX_COMMAND "${output}")
  endforeach()
  run(${c_compiler} "${source_dir}/main.c" ${mdrcontact} -lm -o "${work_dir}/pc_c")
  run(${c_compiler} "${source_dir}/main.c" ${mdrcontact-static} -o "${work_dir}/pc_c_static")
  run(${fortran_compiler} "${source_dir}/main.f90" ${mdrcontact-static} -o "${work_dir}/pc_fortran")
  # Where only the static library is, --static says what it needs.
  file(COPY "${prefix}/" DESTINATION "${work_dir}/only_static")
  file(GLOB shared "${work_dir}/only_static/${lib_dir}/libmdrcontact*.so*" "${work_dir}/only_static/${lib_dir}/libmdrcontact*.dylib")
  file(REMOVE ${shared})
  set(ENV{PKG_CONFIG_PATH} "${work_dir}/only_static/${pc_dir}")
  run(${pkg_config} --static --cflags --libs mdrcontact)
  separate_arguments(mdrcontact UNIX_COMMAND "${output}")
  run(${c_compiler} "${source_dir}/main.c" ${mdrcontact} -o "${work_dir}/pc_only_static")
  foreach(program IN ITEMS pc_c pc_c_static pc_fortran pc_only_static)
    run_checked("${work_dir}/${program}")
  endforeach()
else()
  message(STATUS "pkg-config was not found: its file is not tested")
endif()

# All of it can be removed again.
run(${CMAKE_COMMAND} --install "${build_dir}" --prefix "${work_dir}/removed" --config "${config}")
run(${CMAKE_COMMAND} --build "${build_dir}" --target uninstall)
file(GLOB_RECURSE left "${work_dir}/removed/*")
if(left OR EXISTS "${work_dir}/removed/include/mdrcontact")
  message(FATAL_ERROR "left after uninstall: ${left}")
endif()
