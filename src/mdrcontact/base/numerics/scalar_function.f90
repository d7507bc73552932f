! SPDX-License-Identifier: GPL-3.0-or-later
!> A real function of one real variable that carries its own data: the argument of root finders, samplers and callbacks.
module mdrcontact_numerics_scalar_function
    use mdrcontact_nonfinite, only: is_finite
    use mdrcontact_error, only: error_callback, error_t, raise, to_text
    use mdrcontact_kinds, only: wp
    implicit none (type, external)
    private
    public :: scalar_function_t, watched_function_t

    !> Extend it with the data that the function needs. A failed evaluation allocates `error` and returns any number; the caller
    !> considers `error` before using the number.
    type, abstract :: scalar_function_t
        !> allocated by an evaluation that failed
        type(error_t), allocatable :: error
        !> df/dx at the x of the last evaluation, if the function provides it; 0 if it does not
        real(wp) :: known_slope = 0.0_wp
        !> f is rough at the level of its rounding errors: a root counts only if f was considered there
        logical :: is_rough = .false.
        !> distance from the root within which the search goes the rest of the way alone; 0: as near as rounding allows
        real(wp) :: near_enough = 0.0_wp
        !> accuracy of f that is enough at the next evaluation, and on return what was reached; 0: the best there is
        real(wp) :: accuracy = 0.0_wp
    contains
        !> f(x)
        procedure(value_at), deferred :: value
    end type scalar_function_t

    !> A user's function, whose values raise an error if they are not numbers.
    type, extends(scalar_function_t) :: watched_function_t
        class(scalar_function_t), pointer :: f => null()
        !> its name and that of its argument
        character(len=16) :: name = "function"
        character(len=1) :: argument = "x"
    contains
        procedure :: value => watched_value
    end type watched_function_t

    abstract interface
        !> y = f(x).
        function value_at(self, x) result(y)
            import :: scalar_function_t, wp
            class(scalar_function_t), intent(inout) :: self
            !> in the unit of the function's argument
            real(wp), intent(in) :: x
            real(wp) :: y
        end function value_at
    end interface

contains

    function watched_value(self, x) result(y)
        class(watched_function_t), intent(inout) :: self
        real(wp), intent(in) :: x
        real(wp) :: y

        y = self%f%value(x)
        if (allocated(self%f%error)) then
            self%error = self%f%error
        else if (.not. is_finite(y)) then
            call raise(self%error, error_callback, "the "//trim(self%name)//" returned "//to_text(y)//" at "//self%argument// &
                       " = "//to_text(x)//": it must return a finite number")
        end if
    end function watched_value

end module mdrcontact_numerics_scalar_function
