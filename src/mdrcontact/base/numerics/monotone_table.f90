! SPDX-License-Identifier: GPL-3.0-or-later
!> A table as a function: piecewise cubic with the slopes of GSL's Steffen interpolation, which never overshoots the data.
!>
!> GSL computes the slopes once; the function then is plain data that can be copied and shared between threads.
module mdrcontact_numerics_monotone_table
    use, intrinsic :: iso_c_binding, only: c_associated, c_int, c_null_ptr, c_ptr, c_size_t
    use, intrinsic :: iso_fortran_env, only: int64
    use mdrcontact_object, only: real_bytes
    use mdrcontact_error, only: error_invalid, error_memory, error_t, raise
    use mdrcontact_gsl, only: disable_gsl_abort, gsl_interp_steffen, gsl_spline_alloc, gsl_spline_eval_deriv, &
                              gsl_spline_free, gsl_spline_init, gsl_success
    use mdrcontact_kinds, only: wp
    use mdrcontact_numerics_scalar_function, only: scalar_function_t
    use mdrcontact_numerics_search, only: interval_of
    implicit none (type, external)
    private
    public :: monotone_table_t, new_monotone_table

    !> An end slope below this, relative to the first secant, is a rounding error of 0.
    real(wp), parameter :: negligible = 1.0e-10_wp

    !> Points and the slopes of the cubics between them.
    type, extends(scalar_function_t) :: monotone_table_t
        private
        real(wp), allocatable :: x(:), y(:), slopes(:)
    contains
        procedure :: value
        procedure :: bytes
        procedure :: at
        procedure :: slope_at
    end type monotone_table_t

contains

    !> Interpolates at least 3 points with ascending x, all of which the caller has checked.
    subroutine new_monotone_table(self, x, y, error)
        type(monotone_table_t), intent(out) :: self
        real(wp), intent(in) :: x(:), y(:)
        type(error_t), allocatable, intent(out) :: error
        type(c_ptr) :: spline
        integer(c_int) :: status
        integer :: i, stat

        call disable_gsl_abort()
        spline = gsl_spline_alloc(gsl_interp_steffen, int(size(x), c_size_t))
        if (.not. c_associated(spline)) then
            call raise(error, error_memory, "not enough memory to interpolate a table")
            return
        end if
        status = gsl_spline_init(spline, x, y, int(size(x), c_size_t))
        if (status /= gsl_success) call raise(error, error_invalid, "the table cannot be interpolated")
        allocate (self%x(size(x)), self%y(size(x)), self%slopes(size(x)), stat=stat)
        if (stat /= 0) call raise(error, error_memory, "not enough memory to interpolate a table")
        if (allocated(error)) then
            call gsl_spline_free(spline)
            return
        end if
        self%x(:) = x
        self%y(:) = y
        do i = 1, size(x)
            self%slopes(i) = gsl_spline_eval_deriv(spline, x(i), c_null_ptr)
        end do
        call gsl_spline_free(spline)
        self%slopes(1) = end_slope(x(1:3), y(1:3))
        i = size(x)
        self%slopes(i) = end_slope([x(i), x(i - 1), x(i - 2)], [y(i), y(i - 1), y(i - 2)])
    end subroutine new_monotone_table

    !> The slope at the first of three points: of the parabola through them, limited so that the first piece stays monotone
    !> (Steffen, Astron. Astrophys. 239 (1990) 443; GSL takes the secant). A blunt tip stays blunt, a cone a cone.
    pure function end_slope(x, y) result(slope)
        real(wp), intent(in) :: x(3), y(3)
        real(wp) :: slope
        real(wp) :: first, second, share

        first = (y(2) - y(1))/(x(2) - x(1))
        second = (y(3) - y(2))/(x(3) - x(2))
        share = (x(2) - x(1))/(x(3) - x(1))
        slope = first + (first - second)*share
        if (slope*first <= 0.0_wp .or. abs(slope) < negligible*abs(first)) then
            slope = 0.0_wp
        else if (abs(slope) > 2.0_wp*abs(first)) then
            slope = 2.0_wp*first
        end if
    end function end_slope

    !> Size of a copy [byte].
    pure function bytes(self)
        class(monotone_table_t), intent(in) :: self
        integer(int64) :: bytes

        bytes = 3*real_bytes*size(self%x)
    end function bytes

    function value(self, x) result(y)
        class(monotone_table_t), intent(inout) :: self
        real(wp), intent(in) :: x
        real(wp) :: y

        y = self%at(x)
    end function value

    !> The interpolated value, for x within the table.
    elemental function at(self, x) result(y)
        class(monotone_table_t), intent(in) :: self
        real(wp), intent(in) :: x
        real(wp) :: y
        real(wp) :: c(0:3), u

        call cubic(self, x, c, u)
        y = c(0) + u*(c(1) + u*(c(2) + u*c(3)))
    end function at

    elemental function slope_at(self, x) result(slope)
        class(monotone_table_t), intent(in) :: self
        real(wp), intent(in) :: x
        real(wp) :: slope
        real(wp) :: c(0:3), u

        call cubic(self, x, c, u)
        slope = c(1) + u*(2.0_wp*c(2) + 3.0_wp*u*c(3))
    end function slope_at

    !> Coefficients of the piece that holds x, in u = x - its left end.
    pure subroutine cubic(self, x, c, u)
        class(monotone_table_t), intent(in) :: self
        real(wp), intent(in) :: x
        real(wp), intent(out) :: c(0:3), u
        integer :: i
        real(wp) :: length, rise

        i = interval_of(self%x, x)
        length = self%x(i + 1) - self%x(i)
        rise = (self%y(i + 1) - self%y(i))/length
        c(0) = self%y(i)
        c(1) = self%slopes(i)
        c(2) = (3.0_wp*rise - 2.0_wp*self%slopes(i) - self%slopes(i + 1))/length
        c(3) = (self%slopes(i) + self%slopes(i + 1) - 2.0_wp*rise)/length**2
        u = x - self%x(i)
    end subroutine cubic

end module mdrcontact_numerics_monotone_table
