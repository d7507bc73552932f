! SPDX-License-Identifier: GPL-3.0-or-later
!> From an `error_t` to the status of a C call and the calling thread's error text.
module mdrcontact_api_status
    use, intrinsic :: iso_c_binding, only: c_char, c_int
    use mdrcontact_error, only: error_null, error_t, raise, success
    implicit none (type, external)
    private
    public :: status_of, check_given, wanted_threads

    interface
        subroutine mdrcontact_store_error(status, words, length, argument, argument_length, text_length, entry) bind(C)
            import :: c_char, c_int
            character(kind=c_char), intent(in) :: words(*), argument(*)
            integer(c_int), value :: status, length, argument_length, text_length, entry
        end subroutine mdrcontact_store_error

        function mdrcontact_wanted_threads() result(threads) bind(C)
            import :: c_int
            integer(c_int) :: threads
        end function mdrcontact_wanted_threads
    end interface

contains

    !> The status to return. A failure's text becomes the thread's last error; success leaves the text as it was.
    function status_of(error) result(status)
        type(error_t), allocatable, intent(in) :: error
        integer(c_int) :: status

        status = success
        if (.not. allocated(error)) return
        status = int(error%code, c_int)
        call mdrcontact_store_error(status, error%message, len(error%message, c_int), error%argument, len(error%argument, c_int), &
                                    len(error%text, c_int), int(error%entry, c_int))
    end function status_of

    !> Number of threads for calls of the calling thread, as set by mdr_set_threads().
    function wanted_threads() result(threads)
        integer :: threads

        threads = int(mdrcontact_wanted_threads())
    end function wanted_threads

    !> Raises unless a required pointer is there.
    pure subroutine check_given(error, name, is_given)
        type(error_t), allocatable, intent(inout) :: error
        character(len=*), intent(in) :: name
        logical, intent(in) :: is_given

        if (.not. is_given) call raise(error, error_null, " is NULL: a pointer is required", name)
    end subroutine check_given

end module mdrcontact_api_status
