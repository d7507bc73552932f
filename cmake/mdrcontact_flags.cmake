# SPDX-License-Identifier: GPL-3.0-or-later
# Compiler flags for our own targets; the user's defaults stay as they are.

include(CheckSourceCompiles)
set(mdrcontact_C_program "int main(void) { return 0; }")
set(mdrcontact_Fortran_program "
subroutine half(x) bind(C, name='half')
  use, intrinsic :: iso_c_binding, only: c_double
  implicit none
  real(c_double), intent(inout), optional :: x
  if (present(x)) x = 0.5_c_double*x
end subroutine half
program p
end program p")

# mdrcontact_${language}_flags: those flags of the list under which the compiler takes a program of our kind without a word.
function(mdrcontact_keep_known language)
  set(known "")
  foreach(flag IN LISTS ARGN)
    string(MAKE_C_IDENTIFIER "MDRCONTACT_${language}${flag}" is_known)
    set(CMAKE_REQUIRED_FLAGS "${flag}")
    check_source_compiles(${language} "${mdrcontact_${language}_program}" ${is_known} FAIL_REGEX "[Ww]arning|portability")
    if(${is_known})
      list(APPEND known "${flag}")
    endif()
  endforeach()
  set(mdrcontact_${language}_flags "${known}" PARENT_SCOPE)
endfunction()

# Warnings and the language's standard; vectorisation of atan and log (-O3, never -ffast-math), also in a host project without a
# build type; the same bits on all processors (no a*b + c in one operation). Equality of reals is compared on purpose (exact zeros,
# n = 2).
if(MDRCONTACT_WARNINGS_AS_ERRORS)
  set(werror -Werror)
endif()
mdrcontact_keep_known(Fortran -std=f2018 -fimplicit-none -Wall -Wextra -Wpedantic -Wimplicit-interface -Wimplicit-procedure
  -Wtrampolines -Wno-compare-reals -ffp-contract=off -O3 ${werror})
mdrcontact_keep_known(C -Wall -Wextra -Wpedantic -Wconversion -ffp-contract=off -O3 ${werror})

# mdrcontact_set_flags(target)
function(mdrcontact_set_flags target)
  foreach(language IN ITEMS C Fortran)
    set(flags "${mdrcontact_${language}_flags}")
    list(TRANSFORM flags REPLACE "^-O3$" "$<$<CONFIG:Release,>:-O3>")
    target_compile_options(${target} PRIVATE "$<$<COMPILE_LANGUAGE:${language}>:${flags}>")
  endforeach()
endfunction()

# mdrcontact_set_test_flags(target): of a program that is compiled as often as it runs. Its own statements need no speed. Without
# optimisation gfortran warns of bounds that it has not followed.
function(mdrcontact_set_test_flags target)
  mdrcontact_set_flags(${target})
  target_compile_options(${target} PRIVATE
    "$<$<CONFIG:Release>:-O0;$<$<COMPILE_LANG_AND_ID:Fortran,GNU>:-Wno-maybe-uninitialized>>")
endfunction()

# mdrcontact_export_only(target script): a shared library or module in which all symbols that the script does not name are its own,
# so that no function of a program can take the place of one of them, nor they that of a program's.
function(mdrcontact_export_only target script)
  if(NOT CMAKE_EXECUTABLE_FORMAT STREQUAL "ELF")
    return()
  endif()
  target_link_options(${target} PRIVATE "-Wl,--version-script=${script},-Bsymbolic-functions")
  set_property(TARGET ${target} APPEND PROPERTY LINK_DEPENDS "${script}")
endfunction()
