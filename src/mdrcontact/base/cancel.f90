! SPDX-License-Identifier: GPL-3.0-or-later
!> Calls that take long check now and then whether to stop, and report their progress: see mdr_set_cancel() and mdr_set_progress()
!> in mdrcontact.h.
module mdrcontact_cancel
    use, intrinsic :: iso_c_binding, only: c_double, c_funloc, c_funptr, c_int, c_loc, c_null_funptr, &
                                           c_null_ptr, c_ptr
    use mdrcontact_error, only: error_cancelled, error_invalid, error_t, raise
    implicit none (type, external)
    private
    public :: cancel_function, check_cancelled, help_team, lead_team, report_progress, set_cancel, set_progress, stop_team

    !> The answer where the cancel function itself makes the call: cancel.c.
    integer(c_int), parameter :: asked_from_within = 2_c_int

    abstract interface
        !> Nonzero: stop. After that it must return nonzero until the call has returned.
        function cancel_function(context) result(stop_now) bind(C)
            import :: c_int, c_ptr
            type(c_ptr), value :: context
            integer(c_int) :: stop_now
        end function cancel_function
    end interface

    interface
        function mdr_set_cancel(cancel, context) result(status) bind(C)
            import :: c_funptr, c_int, c_ptr
            type(c_funptr), value :: cancel
            type(c_ptr), value :: context
            integer(c_int) :: status
        end function mdr_set_cancel

        function mdrcontact_is_cancelled() result(answer) bind(C)
            import :: c_int
            integer(c_int) :: answer
        end function mdrcontact_is_cancelled

        function mdr_set_progress(part) result(status) bind(C)
            import :: c_int, c_ptr
            type(c_ptr), value :: part
            integer(c_int) :: status
        end function mdr_set_progress

        subroutine mdrcontact_report(part) bind(C)
            import :: c_double
            real(c_double), value :: part
        end subroutine mdrcontact_report

        function mdrcontact_lead_team() result(team) bind(C)
            import :: c_ptr
            type(c_ptr) :: team
        end function mdrcontact_lead_team

        subroutine mdrcontact_help(team) bind(C)
            import :: c_ptr
            type(c_ptr), value :: team
        end subroutine mdrcontact_help

        subroutine mdrcontact_stop_team(team) bind(C)
            import :: c_ptr
            type(c_ptr), value :: team
        end subroutine mdrcontact_stop_team
    end interface

contains

    !> From now on every call of the calling thread that takes long calls `cancel`, at least every 0.2 s, and ends with
    !> error_cancelled if it returns nonzero; without arguments none is called any more.
    subroutine set_cancel(cancel, context)
        !> absent: none
        procedure(cancel_function), optional :: cancel
        !> handed on to it
        type(c_ptr), intent(in), optional :: context
        type(c_funptr) :: entry
        type(c_ptr) :: handed_on
        integer(c_int) :: status

        entry = c_null_funptr
        handed_on = c_null_ptr
        if (present(cancel)) entry = c_funloc(cancel)
        if (present(context)) handed_on = context
        status = mdr_set_cancel(entry, handed_on)
    end subroutine set_cancel

    !> From now on histories that the calling thread marches through time, searches of stresses, and equilibria that are sampled
    !> for a cohesive stress write their progress; null() ends it.
    subroutine set_progress(part)
        !> receives the number of rounds that are done, each with steps half as long, plus the part of the path that the present one
        !> has behind it; of a search, or of equilibria, the part that is done
        real(c_double), pointer, intent(in) :: part
        type(c_ptr) :: place
        integer(c_int) :: status

        place = c_null_ptr
        if (associated(part)) place = c_loc(part)
        status = mdr_set_progress(place)
    end subroutine set_progress

    !> A team begins to work for the calling thread, the only one whose cancel function is called: what its threads give to
    !> help_team and stop_team.
    function lead_team() result(team)
        type(c_ptr) :: team

        team = mdrcontact_lead_team()
    end function lead_team

    !> The calling thread works for a team from now on: check_cancelled follows the thread that leads it.
    subroutine help_team(team)
        !> a null pointer ends its help
        type(c_ptr), intent(in) :: team

        call mdrcontact_help(team)
    end subroutine help_team

    !> The thread that leads a team was cancelled.
    subroutine stop_team(team)
        type(c_ptr), intent(in) :: team

        call mdrcontact_stop_team(team)
    end subroutine stop_team

    !> Raises if the caller cancels the call. It costs about ten nanoseconds: for anything that is done thousands of times.
    subroutine check_cancelled(error)
        type(error_t), allocatable, intent(inout) :: error

        integer(c_int) :: answer

        answer = mdrcontact_is_cancelled()
        if (answer == asked_from_within) then
            call raise(error, error_invalid, "the cancel function makes a long call: it must return first")
        else if (answer /= 0_c_int) then
            call raise(error, error_cancelled, "cancelled by the caller")
        end if
    end subroutine check_cancelled

    !> Reports the progress of the call.
    subroutine report_progress(part)
        !> rounds that are done, and the part of the present one
        real(c_double), intent(in) :: part

        call mdrcontact_report(part)
    end subroutine report_progress

end module mdrcontact_cancel
