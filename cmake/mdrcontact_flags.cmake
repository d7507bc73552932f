# SPDX-License-Identifier: GPL-3.0-or-later
# Compiler flags for our own targets; the user's defaults stay as they are.

# Equality of reals is compared on purpose (exact zeros, n = 2): -Wno-compare-reals.
include(CheckCCompilerFlag)
include(CheckFortranCompilerFlag)
foreach(language IN ITEMS C Fortran)
  cmake_language(CALL "check_${language}_compiler_flag" -ffp-contract=off mdrcontact_${language}_rounds_each)
  cmake_language(CALL "check_${language}_compiler_flag" -O3 mdrcontact_${language}_has_O3)
endforeach()

# mdrcontact_set_flags(target): warnings, language standards, vectorisation of atan and log (-O3, never -ffast-math, also in a host
# project without a build type), the same bits on all processors (no a*b + c in one operation).
function(mdrcontact_set_flags target)
  foreach(language IN ITEMS C Fortran)
    if(mdrcontact_${language}_rounds_each)
      target_compile_options(${target} PRIVATE "$<$<COMPILE_LANGUAGE:${language}>:-ffp-contract=off>")
    endif()
    if(mdrcontact_${language}_has_O3)
      target_compile_options(${target} PRIVATE "$<$<AND:$<COMPILE_LANGUAGE:${language}>,$<CONFIG:Release,>>:-O3>")
    endif()
  endforeach()
  set(gnu_fortran "$<COMPILE_LANG_AND_ID:Fortran,GNU>")
  set(gnu_c "$<COMPILE_LANG_AND_ID:C,GNU,Clang>")
  target_compile_options(${target} PRIVATE
    "$<${gnu_fortran}:-std=f2018;-fimplicit-none;-Wall;-Wextra;-Wpedantic;-Wimplicit-interface;-Wimplicit-procedure;-Wtrampolines;-Wno-compare-reals>"
    "$<${gnu_c}:-Wall;-Wextra;-Wpedantic;-Wconversion>")
  if(MDRCONTACT_WARNINGS_AS_ERRORS)
    target_compile_options(${target} PRIVATE "$<$<OR:${gnu_fortran},${gnu_c}>:-Werror>")
  endif()
endfunction()

# mdrcontact_export_only(target pattern): a shared library or module in which all other symbols are its own, so that no function of
# a program can take the place of one of them, nor they that of a program's.
function(mdrcontact_export_only target pattern)
  if(NOT CMAKE_EXECUTABLE_FORMAT STREQUAL "ELF")
    return()
  endif()
  set(script "${CMAKE_CURRENT_BINARY_DIR}/${target}.map")
  file(CONFIGURE OUTPUT "${script}" CONTENT "{ global: ${pattern}; local: *; };\n")
  target_link_options(${target} PRIVATE "-Wl,--version-script=${script},-Bsymbolic-functions")
  set_property(TARGET ${target} APPEND PROPERTY LINK_DEPENDS "${script}")
endfunction()
