# SPDX-License-Identifier: GPL-3.0-or-later
# Installs, moves the installed folder, builds tests/export/project on it by CMake and by pkg-config, and runs the programs.
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

# A project that speaks C only can use the shared library.
run(${CMAKE_COMMAND} -S "${source_dir}/c_only" -B "${work_dir}/c_only" -G "${generator}" "-DCMAKE_PREFIX_PATH=${prefix}"
  "-DCMAKE_C_COMPILER=${c_compiler}")
run(${CMAKE_COMMAND} --build "${work_dir}/c_only")
run_checked("${work_dir}/c_only/c_only")

if(pkg_config)
  set(ENV{PKG_CONFIG_PATH} "${prefix}/${pc_dir}")
  foreach(package IN ITEMS mdrcontact mdrcontact-static)
    run(${pkg_config} --cflags --libs ${package})
    separate_arguments(${package} UNIX_COMMAND "${output}")
  endforeach()
  run(${c_compiler} "${source_dir}/main.c" ${mdrcontact} -lm -o "${work_dir}/pc_c")
  run(${c_compiler} "${source_dir}/main.c" ${mdrcontact-static} -o "${work_dir}/pc_c_static")
  run(${fortran_compiler} "${source_dir}/main.f90" ${mdrcontact-static} -o "${work_dir}/pc_fortran")
  foreach(program IN ITEMS pc_c pc_c_static pc_fortran)
    run_checked("${work_dir}/${program}")
  endforeach()
else()
  message(STATUS "pkg-config was not found: its file is not tested")
endif()
