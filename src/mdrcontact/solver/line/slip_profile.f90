! SPDX-License-Identifier: GPL-3.0-or-later
!> The profile against which first shear is a contact without adhesion: [R(0) - R(x)]/G0* with R = q_n + K_t q_n, q_n the normal
!> line load and K_t the springs' interaction under shear (theory/friction.md (3.1), (3.2)). On a homogeneous body it is (E*/G*)
!> g(x).
module mdrcontact_line_slip_profile
    use mdrcontact_nonfinite, only: quiet_nan
    use mdrcontact_error, only: error_t
    use mdrcontact_kinds, only: wp
    use mdrcontact_line_legendre, only: normalisation
    use mdrcontact_line_rule, only: new_rule, rule_t
    use mdrcontact_line_series, only: add_even_sum, add_projections, even_slope, even_sum
    use mdrcontact_profile, only: profile_t
    implicit none (type, external)
    private
    public :: slip_profile_t

    !> ratio [g(x) + sum of c_j (P_2j(x/a) - P_2j(0))], for 0 <= x <= a.
    type, extends(profile_t) :: slip_profile_t
        !> g
        class(profile_t), allocatable :: base
        !> a [length]
        real(wp) :: radius = 0.0_wp
        !> E0*/G0* [1]
        real(wp) :: ratio = 1.0_wp
        !> c_j, j = 0, 1, ... [length]
        real(wp), allocatable :: c(:)
        !> sum of c_j P_2j(0) [length]
        real(wp) :: at_axis = 0.0_wp
    contains
        procedure :: height => no_height
        procedure :: slope => no_height
        procedure :: mdr
        procedure :: mdr_at
        procedure :: mdr_slope
        procedure :: mdr_slope_beyond
        procedure :: mdr_moment => no_height
        procedure :: add_breaks
        procedure :: moments
    end type slip_profile_t

contains

    !> Not needed: only the springs press against this profile, and their forces come from its moments.
    elemental function no_height(self, x) result(y)
        class(slip_profile_t), intent(in) :: self
        real(wp), intent(in) :: x
        real(wp) :: y

        associate (unused => self, also_unused => x)
        end associate
        y = quiet_nan
    end function no_height

    elemental function mdr(self, x) result(y)
        class(slip_profile_t), intent(in) :: self
        real(wp), intent(in) :: x
        real(wp) :: y
        real(wp) :: all_of(1)

        all_of = self%mdr_at([x])
        y = all_of(1)
    end function mdr

    !> Its terms are summed at all places together.
    pure function mdr_at(self, x) result(y)
        class(slip_profile_t), intent(in) :: self
        real(wp), intent(in) :: x(:)
        real(wp) :: y(size(x))

        y = self%base%mdr(x) - self%at_axis
        call add_even_sum(self%c, x, self%radius, 1.0_wp, y)
        y = self%ratio*y
    end function mdr_at

    elemental function mdr_slope(self, x) result(y)
        class(slip_profile_t), intent(in) :: self
        real(wp), intent(in) :: x
        real(wp) :: y
        real(wp) :: series(1)

        series = even_slope(self%c, [x/self%radius])
        y = self%ratio*(self%base%mdr_slope(x) + series(1)/self%radius)
    end function mdr_slope

    elemental function mdr_slope_beyond(self, start, distance) result(y)
        class(slip_profile_t), intent(in) :: self
        real(wp), intent(in) :: start, distance
        real(wp) :: y
        real(wp) :: series(1)

        series = even_slope(self%c, [(start + distance)/self%radius])
        y = self%ratio*(self%base%mdr_slope_beyond(start, distance) + series(1)/self%radius)
    end function mdr_slope_beyond

    pure subroutine add_breaks(self, radii, error)
        class(slip_profile_t), intent(in) :: self
        real(wp), allocatable, intent(inout) :: radii(:)
        type(error_t), allocatable, intent(inout) :: error

        call self%base%add_breaks(radii, error)
    end subroutine add_breaks

    !> Adds the Legendre coefficients of the sum on a smaller contact to those of g, times the ratio. Beyond its own degree they
    !> are 0.
    subroutine moments(self, a, g, error)
        class(slip_profile_t), intent(in) :: self
        !> a smaller contact radius [length]
        real(wp), intent(in) :: a
        !> G_j = int_-1^1 g(a |u|) s_j P_2j(u) du; those of g at first
        real(wp), intent(inout) :: g(0:)
        type(error_t), allocatable, intent(inout) :: error
        type(rule_t) :: rule
        real(wp), allocatable :: u(:), added(:)

        allocate (added(0:min(ubound(g, 1), size(self%c) - 1)), source=0.0_wp)
        call new_rule(rule, size(self%c) + size(added) - 1, error)
        if (allocated(error)) return
        ! both halves of the rule are the same
        u = 1.0_wp - rule%distance(:size(rule%distance)/2)
        call add_projections(size(u), u, 2.0_wp*rule%weights(:size(u))*(even_sum(self%c, (a/self%radius)*u) - self%at_axis), added)
        g(:size(added) - 1) = g(:size(added) - 1) + normalisation(size(added))*added
        g = self%ratio*g
    end subroutine moments

end module mdrcontact_line_slip_profile
