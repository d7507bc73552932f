! SPDX-License-Identifier: GPL-3.0-or-later
!> Indenters from data: a table of heights f(r), a table of g(x), a user's function f(r).
module mdrcontact_profile_tabulated
    use mdrcontact_error, only: check_positive, check_table, error_invalid, error_t, raise, to_text
    use mdrcontact_gsl, only: disable_gsl_abort
    use mdrcontact_kinds, only: wp
    use mdrcontact_numerics_monotone_table, only: monotone_table_t, new_monotone_table
    use mdrcontact_profile_sampled, only: sample_from_height, sample_from_mdr, sampled_profile_t
    use mdrcontact_profile_user_height, only: new_user_height, user_height_t
    use mdrcontact_numerics_scalar_function, only: scalar_function_t, watched_function_t
    implicit none (type, external)
    private
    public :: new_tabulated_profile, new_profile_from_mdr, new_profile_from_function

contains

    !> An indenter through the points (r, f), interpolated without overshoot (Steffen); leading zeros of f are a flat end.
    subroutine new_tabulated_profile(self, r, f, error)
        type(sampled_profile_t), intent(out) :: self
        !> ascending radii from r(1) = 0, at least 3 [length]
        real(wp), intent(in) :: r(:)
        !> heights from f(1) = 0, not decreasing, same size as r [length]
        real(wp), intent(in) :: f(:)
        type(error_t), allocatable, intent(out) :: error
        type(monotone_table_t) :: table
        integer :: flat

        call check_profile_table("r", r, "f", f, error)
        if (.not. allocated(error)) call new_monotone_table(table, r, f, error)
        if (allocated(error)) return
        flat = last_zero(f)
        call sample_from_height(self, table, r(size(r)), r(flat), r(flat + 1:size(r) - 1), epsilon(f), error)
        self%is_made = .not. allocated(error)
    end subroutine new_tabulated_profile

    !> The indenter whose one-dimensional profile goes through the points (x, g), equation (4).
    subroutine new_profile_from_mdr(self, x, g, error)
        type(sampled_profile_t), intent(out) :: self
        !> ascending positions from x(1) = 0, at least 3 [length]
        real(wp), intent(in) :: x(:)
        !> from g(1) = 0, not decreasing, same size as x [length]
        real(wp), intent(in) :: g(:)
        type(error_t), allocatable, intent(out) :: error
        type(monotone_table_t) :: table
        integer :: flat

        call check_profile_table("x", x, "g", g, error)
        if (.not. allocated(error)) call new_monotone_table(table, x, g, error)
        if (allocated(error)) return
        flat = last_zero(g)
        call sample_from_mdr(self, table, x(size(x)), x(flat), x(flat + 1:size(x) - 1), error)
        self%is_made = .not. allocated(error)
    end subroutine new_profile_from_mdr

    !> An indenter from a function f(r), smooth but for a power of r at the axis. The function is called here and never again.
    subroutine new_profile_from_function(self, height, largest_radius, error)
        type(sampled_profile_t), intent(out) :: self
        !> f(r) on [0, largest_radius]: f(0) = 0, not decreasing, smooth but for corners and a power of r at the axis. Where it
        !> loses digits towards the axis, as R - sqrt(R^2 - r^2) does and r^2/(R + sqrt(R^2 - r^2)) does not, it is continued
        !> by a series in r that its values determine to 3e-10, or error_no_convergence is raised.
        class(scalar_function_t), intent(inout), target :: height
        !> up to where contacts reach, > 0 [length]
        real(wp), intent(in) :: largest_radius
        type(error_t), allocatable, intent(out) :: error
        type(watched_function_t), target :: watched
        type(user_height_t) :: user
        real(wp), parameter :: no_breaks(0) = [real(wp) ::]

        call disable_gsl_abort()
        call check_positive(error, "largest_radius", largest_radius)
        if (allocated(error)) return
        watched%f => height
        watched%name = "profile function"
        watched%argument = "r"
        call new_user_height(user, watched, largest_radius, error)
        if (allocated(error)) return
        call sample_from_height(self, user, largest_radius, 0.0_wp, no_breaks, user%roughness, error)
        self%is_made = .not. allocated(error)
    end subroutine new_profile_from_function

    pure subroutine check_profile_table(x_name, x, y_name, y, error)
        character(len=*), intent(in) :: x_name, y_name
        real(wp), intent(in) :: x(:), y(:)
        type(error_t), allocatable, intent(out) :: error
        integer :: i

        call check_table(error, x_name, x, y_name, y, 3)
        if (allocated(error)) return
        if (x(1) /= 0.0_wp .or. y(1) /= 0.0_wp) then
            call raise(error, error_invalid, "the table starts at ("//to_text(x(1))//", "//to_text(y(1))// &
                       "): it must start at "//x_name//" = 0, "//y_name//" = 0")
        end if
        do i = 2, size(y)
            if (y(i) < y(i - 1)) then
                call raise(error, error_invalid, " = "//to_text(y(i))//": "//y_name//" must not decrease, and the previous "// &
                           "entry is "//to_text(y(i - 1)), y_name, i)
                return
            end if
        end do
        if (.not. y(size(y)) > 0.0_wp) call raise(error, error_invalid, y_name//": it is 0 everywhere. Use a flat punch")
    end subroutine check_profile_table

    pure function last_zero(y) result(i)
        real(wp), intent(in) :: y(:)
        integer :: i

        i = count(y <= 0.0_wp)
    end function last_zero

end module mdrcontact_profile_tabulated
