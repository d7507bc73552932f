! SPDX-License-Identifier: GPL-3.0-or-later
!> The equilibria of a contact sampled along their curve, whatever the range of adhesion: what a compiled law needs of them.
module mdrcontact_contact_samples
    use mdrcontact_contact_control, only: control_t
    use mdrcontact_contact_equilibrium, only: equilibrium_t
    use mdrcontact_contact_state, only: contact_state_t
    use mdrcontact_error, only: error_t
    use mdrcontact_kinds, only: wp
    use mdrcontact_numerics_roots, only: find_root
    use mdrcontact_numerics_scalar_function, only: scalar_function_t
    implicit none (type, external)
    private
    public :: curve_point_t, samples_t

    !> One equilibrium, at coordinate x.
    type :: curve_point_t
        real(wp) :: x = 0.0_wp, radius = 0.0_wp, depth = 0.0_wp, force = 0.0_wp, stiffness = 0.0_wp
    end type curve_point_t

    !> Samples on panels of a coordinate x along the curve.
    type, abstract :: samples_t
        !> panel i runs over x from edges(i) to edges(i+1)
        real(wp), allocatable :: edges(:)
        !> how many contact states were computed
        integer :: solutions = 0
    contains
        procedure(point_at), deferred :: at
        procedure(slope_of), deferred :: slope
        procedure(point_with), deferred :: find
        procedure(work_of), deferred :: work_between
        procedure(state_of), deferred :: state_at
        procedure :: turn
    end type samples_t

    abstract interface
        !> The equilibrium at coordinate x.
        pure function point_at(self, x) result(point)
            import :: curve_point_t, samples_t, wp
            class(samples_t), intent(in) :: self
            real(wp), intent(in) :: x
            type(curve_point_t) :: point
        end function point_at

        !> ds/dx at coordinate x.
        pure function slope_of(self, control, x) result(rate)
            import :: control_t, samples_t, wp
            class(samples_t), intent(in) :: self
            type(control_t), intent(in) :: control
            real(wp), intent(in) :: x
            real(wp) :: rate
        end function slope_of

        !> The equilibrium between two coordinates at which s, which grows from the first to the last, lies u from an end value.
        pure function point_with(self, control, origin, side, root, u, first, last) result(point)
            import :: control_t, curve_point_t, samples_t, wp
            class(samples_t), intent(in) :: self
            type(control_t), intent(in) :: control
            !> s at `first` (side = 1) or at `last` (side = -1), and whether it is an extremum or a break; without, s follows a
            !> power of the radius from origin = 0 on
            real(wp), intent(in) :: origin, side
            logical, intent(in) :: root
            !> side*(s - origin) >= 0
            real(wp), intent(in) :: u
            real(wp), intent(in) :: first, last
            type(curve_point_t) :: point
        end function point_with

        !> int F dd from one coordinate to another, both clipped to the sampled range.
        function work_of(self, from, to) result(work)
            import :: samples_t, wp
            class(samples_t), intent(in) :: self
            real(wp), intent(in) :: from, to
            real(wp) :: work
        end function work_of

        !> The state of the contact itself at coordinate x.
        subroutine state_of(self, equilibrium, x, state, error)
            import :: contact_state_t, equilibrium_t, error_t, samples_t, wp
            class(samples_t), intent(in) :: self
            type(equilibrium_t), intent(in) :: equilibrium
            real(wp), intent(in) :: x
            type(contact_state_t), intent(out) :: state
            type(error_t), allocatable, intent(out) :: error
        end subroutine state_of
    end interface

    !> ds/dx as a function of x.
    type, extends(scalar_function_t) :: slope_t
        class(samples_t), pointer :: samples => null()
        type(control_t) :: control
    contains
        procedure :: value => slope_at
    end type slope_t

contains

    !> The coordinate of the extremum of s between two coordinates where its slopes have opposite signs.
    subroutine turn(self, control, lower, upper, x, error)
        class(samples_t), intent(in), target :: self
        type(control_t), intent(in) :: control
        real(wp), intent(in) :: lower, upper
        real(wp), intent(out) :: x
        type(error_t), allocatable, intent(out) :: error
        type(slope_t) :: f

        f%samples => self
        f%control = control
        call find_root(f, lower, upper, x, error)
    end subroutine turn

    function slope_at(self, x) result(y)
        class(slope_t), intent(inout) :: self
        real(wp), intent(in) :: x
        real(wp) :: y

        y = self%samples%slope(self%control, x)
    end function slope_at

end module mdrcontact_contact_samples
