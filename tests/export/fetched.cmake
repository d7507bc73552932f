# SPDX-License-Identifier: GPL-3.0-or-later
# Builds and installs tests/export/host, and runs what was installed.
function(run)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if(NOT result EQUAL 0)
    string(REPLACE ";" " " command "${ARGN}")
    message(FATAL_ERROR "${command}\nfailed (${result}):\n${output}")
  endif()
  set(output "${output}" PARENT_SCOPE)
endfunction()

file(REMOVE_RECURSE "${work_dir}")
run(${CMAKE_COMMAND} -S "${source_dir}" -B "${work_dir}/build" -G "${generator}" "-Dlibrary_dir=${library_dir}"
  "-DCMAKE_C_COMPILER=${c_compiler}" "-DCMAKE_Fortran_COMPILER=${fortran_compiler}" -DCMAKE_EXPORT_COMPILE_COMMANDS=ON
  -DCMAKE_INSTALL_LIBDIR=lib)
file(READ "${work_dir}/build/compile_commands.json" commands)
if(NOT commands MATCHES "-O3 [^\n]*src/mdrcontact/contact/law/interval.f90" OR NOT commands MATCHES "-O3 [^\n]*src/mdrcontact/contact/law/kernel.c")
  message(FATAL_ERROR "the library is not optimised in a host project without a build type")
endif()
run(${CMAKE_COMMAND} --build "${work_dir}/build" --parallel 2)
run(${CMAKE_COMMAND} --install "${work_dir}/build" --prefix "${work_dir}/installed")
file(REMOVE_RECURSE "${work_dir}/build")
run("${work_dir}/installed/bin/host")
if(NOT output MATCHES "checks passed")
  message(FATAL_ERROR "host printed: ${output}")
endif()
message(STATUS "${output}")
