! SPDX-License-Identifier: GPL-3.0-or-later
!> Calls that take long check now and then whether to stop, and report their progress: see mdr_set_cancel() and mdr_set_progress()
!> in mdrcontact.h.
module mdrcontact_cancel
    use, intrinsic :: iso_c_binding, only: c_double, c_funloc, c_funptr, c_int, c_loc, c_null_funptr, &
                                           c_null_ptr, c_ptr
    use mdrcontact_error, only: error_cancelled, error_t, raise
    implicit none (type, external)
    private
    public :: cancel_function, check_cancelled, poll_for_team, report_progress, set_cancel, set_progress

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

        subroutine mdrcontact_poll_for_team(team_flag) bind(C)
            import :: c_ptr
            type(c_ptr), value :: team_flag
        end subroutine mdrcontact_poll_for_team
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

    !> From now on histories that the calling thread marches through time, and searches of stresses, write their progress; null()
    !> ends it.
    subroutine set_progress(part)
        !> receives the number of rounds that are done, each with steps half as long, plus the part of the path that the present one
        !> has behind it; of a search the part that is done
        real(c_double), pointer, intent(in) :: part
        type(c_ptr) :: place
        integer(c_int) :: status

        place = c_null_ptr
        if (associated(part)) place = c_loc(part)
        status = mdr_set_progress(place)
    end subroutine set_progress

    !> In a thread that helps another one: check_cancelled follows that one.
    subroutine poll_for_team(team_flag)
        !> address of an integer(c_int) that is not 0 once it was cancelled; null: the thread no longer helps
        type(c_ptr), intent(in) :: team_flag

        call mdrcontact_poll_for_team(team_flag)
    end subroutine poll_for_team

    !> Raises if the caller cancels the call. It costs about ten nanoseconds: for anything that is done thousands of times.
    subroutine check_cancelled(error)
        type(error_t), allocatable, intent(inout) :: error

        if (mdrcontact_is_cancelled() /= 0) call raise(error, error_cancelled, "cancelled by the caller")
    end subroutine check_cancelled

    !> Reports the progress of the call.
    subroutine report_progress(part)
        !> rounds that are done, and the part of the present one
        real(c_double), intent(in) :: part

        call mdrcontact_report(part)
    end subroutine report_progress

end module mdrcontact_cancel
