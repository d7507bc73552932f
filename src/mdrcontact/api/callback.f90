! SPDX-License-Identifier: GPL-3.0-or-later
!> A C caller's `mdr_function` as a function of the library.
module mdrcontact_api_callback
    use, intrinsic :: ieee_arithmetic, only: ieee_is_finite, ieee_quiet_nan, ieee_value
    use, intrinsic :: iso_c_binding, only: c_associated, c_double, c_f_procpointer, c_funptr, c_int, c_ptr
    use mdrcontact_api_status, only: check_given
    use mdrcontact_error, only: count_text, error_callback, error_t, raise, to_text
    use mdrcontact_kinds, only: wp
    use mdrcontact_numerics_scalar_function, only: scalar_function_t
    implicit none (type, external)
    private
    public :: c_function_t, new_c_function

    abstract interface
        !> typedef int (*mdr_function)(double x, double *y, void *context)
        function mdr_function(x, y, context) result(status) bind(C)
            import :: c_double, c_int, c_ptr
            real(c_double), value :: x
            real(c_double), intent(inout) :: y
            type(c_ptr), value :: context
            integer(c_int) :: status
        end function mdr_function
    end interface

    type, extends(scalar_function_t) :: c_function_t
        private
        procedure(mdr_function), pointer, nopass :: f => null()
        type(c_ptr) :: context
        character(len=:), allocatable :: name
    contains
        procedure :: value
    end type c_function_t

contains

    !> The function behind a C pointer; `name` is the argument's name in the header.
    subroutine new_c_function(self, name, pointer_to_f, context, error)
        type(c_function_t), intent(out) :: self
        character(len=*), intent(in) :: name
        type(c_funptr), intent(in) :: pointer_to_f
        type(c_ptr), intent(in) :: context
        type(error_t), allocatable, intent(inout) :: error

        call check_given(error, name, c_associated(pointer_to_f))
        if (allocated(error)) return
        call c_f_procpointer(pointer_to_f, self%f)
        self%context = context
        self%name = name
    end subroutine new_c_function

    !> Starts from NaN: a function that reports success without writing its value has failed too.
    function value(self, x) result(y)
        class(c_function_t), intent(inout) :: self
        real(wp), intent(in) :: x
        real(wp) :: y
        integer(c_int) :: status

        y = ieee_value(y, ieee_quiet_nan)
        status = self%f(x, y, self%context)
        if (status /= 0) then
            call raise(self%error, error_callback, "the function "//self%name//" reported failure "//count_text(int(status))// &
                       " at x = "//to_text(x))
            y = ieee_value(y, ieee_quiet_nan)
        else if (.not. ieee_is_finite(y)) then
            call raise(self%error, error_callback, "the function "//self%name//" returned "//to_text(y)//" at x = "//to_text(x)// &
                       ": it must return a finite number")
        end if
    end function value

end module mdrcontact_api_callback
