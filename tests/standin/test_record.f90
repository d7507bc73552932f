! SPDX-License-Identifier: GPL-3.0-or-later
!> The record of a run of tests: which test is running, which assertions have failed, and the summary at the end.
module test_record
    use, intrinsic :: iso_fortran_env, only: output_unit
    implicit none (type, external)
    private
    public :: SourceLocation, anyExceptions, note_assertion, note_failure
    public :: start_test, finish_test, skip_test, finish_suite

    !> Where an assertion stands.
    type :: SourceLocation
        character(len=256) :: file = "(unknown file)"
        integer :: line = 0
    end type SourceLocation

    character(len=256) :: current_test = ""
    integer :: tests_run = 0, tests_failed = 0, tests_disabled = 0
    integer :: assertions = 0, failures = 0

contains

    !> Whether an assertion of the current test has failed.
    function anyExceptions() result(answer)
        logical :: answer

        answer = failures > 0
    end function anyExceptions

    !> An assertion is being looked at.
    subroutine note_assertion()
        assertions = assertions + 1
    end subroutine note_assertion

    !> An assertion of the current test has failed.
    subroutine note_failure(reason, message, location)
        character(len=*), intent(in) :: reason
        character(len=*), intent(in), optional :: message
        type(SourceLocation), intent(in), optional :: location

        failures = failures + 1
        write (output_unit, "(a)") "Failure in: "//trim(current_test)
        if (present(location)) write (output_unit, "(3a, i0, a)") "  Location: [", trim(location%file), ":", location%line, "]"
        if (present(message)) write (output_unit, "(2a)") "  ", trim(message)
        write (output_unit, "(2a)") "  ", reason
    end subroutine note_failure

    subroutine start_test(name)
        character(len=*), intent(in) :: name

        current_test = name
        assertions = 0
        failures = 0
    end subroutine start_test

    !> Ends the current test. A test that has looked at nothing has failed.
    subroutine finish_test()
        if (assertions == 0) call note_failure("the test ended without one assertion")
        tests_run = tests_run + 1
        if (failures > 0) then
            tests_failed = tests_failed + 1
            write (output_unit, "(2a)") "failed   ", trim(current_test)
        else
            write (output_unit, "(2a)") "passed   ", trim(current_test)
        end if
    end subroutine finish_test

    subroutine skip_test(name)
        character(len=*), intent(in) :: name

        tests_disabled = tests_disabled + 1
        write (output_unit, "(2a)") "disabled ", name
    end subroutine skip_test

    !> Prints how many tests ran, and ends the program with status 1 if one failed or none ran.
    subroutine finish_suite()
        if (tests_failed > 0 .or. tests_run == 0) then
            write (output_unit, "(/, a)") " FAILURES!!!"
            write (output_unit, "(3(a, i0))") "Tests run: ", tests_run, ", Failures: ", tests_failed, &
                ", Errors: 0, Disabled: ", tests_disabled
            flush (output_unit)
            stop 1
        end if
        write (output_unit, "(/, a)") " OK"
        if (tests_disabled > 0) then
            write (output_unit, "(2(a, i0), a)") " (", tests_run, " tests, ", tests_disabled, " disabled)"
        else
            write (output_unit, "(a, i0, a)") " (", tests_run, " tests)"
        end if
    end subroutine finish_suite

end module test_record
