! SPDX-License-Identifier: GPL-3.0-or-later
!> What a contact needs of its adhesive equilibria, whatever the range of adhesion: the stable segments under a control, and the
!> states on them. All equilibria lie on one curve with a coordinate, and are stable where what the machine controls grows along it.
module mdrcontact_contact_adhesive_branch
    use mdrcontact_contact_control, only: control_t, depth_control, force_control
    use mdrcontact_contact_equilibrium, only: equilibrium_t
    use mdrcontact_contact_state, only: contact_state_t
    use mdrcontact_error, only: error_t
    use mdrcontact_kinds, only: wp
    implicit none (type, external)
    private
    public :: adhesive_branch_t, stable_segment_t

    !> A stable segment of the branch: s grows from `lowest` to `highest` as the coordinate goes from `first` to `last`.
    type :: stable_segment_t
        real(wp) :: first = 0.0_wp, last = 0.0_wp
        real(wp) :: lowest = 0.0_wp, highest = 0.0_wp
        !> the radius stays at the indenter's vertical wall, the depth changes
        logical :: at_wall = .false.
    end type stable_segment_t

    !> The equilibria from where adhesion is all to where it is nothing.
    type, abstract :: adhesive_branch_t
        !> the gap at which bodies that approach begin to attract each other [length]: 0 where adhesion has no range
        real(wp) :: range = 0.0_wp
        !> stable segments under depth and force control, once they are found
        type(stable_segment_t), allocatable, private :: of_depth(:), of_force(:)
    contains
        procedure(find), deferred :: find_segments
        procedure :: stable_segments
        procedure :: keep_segments
        procedure(find_state), deferred :: state_on
        procedure(state_at_radius), deferred :: at_radius
        procedure(work_of), deferred :: work_between
        procedure :: first_attraction
    end type adhesive_branch_t

    abstract interface
        !> In ascending order of the coordinate. The last reaches to the end of the indenter or medium.
        subroutine find(self, equilibrium, control, list, error)
            import :: adhesive_branch_t, control_t, equilibrium_t, error_t, stable_segment_t
            class(adhesive_branch_t), intent(in) :: self
            type(equilibrium_t), intent(in), target :: equilibrium
            type(control_t), intent(in) :: control
            type(stable_segment_t), allocatable, intent(out) :: list(:)
            type(error_t), allocatable, intent(out) :: error
        end subroutine find

        !> The state with a given s on a segment that contains it.
        subroutine find_state(self, equilibrium, control, segment, s, state, error)
            import :: adhesive_branch_t, contact_state_t, control_t, equilibrium_t, error_t, stable_segment_t, wp
            class(adhesive_branch_t), intent(in) :: self
            type(equilibrium_t), intent(in), target :: equilibrium
            type(control_t), intent(in) :: control
            type(stable_segment_t), intent(in) :: segment
            real(wp), intent(in) :: s
            type(contact_state_t), intent(out) :: state
            type(error_t), allocatable, intent(out) :: error
        end subroutine find_state

        !> The state at a radius that the caller has checked.
        subroutine state_at_radius(self, equilibrium, radius, state, error)
            import :: adhesive_branch_t, contact_state_t, equilibrium_t, error_t, wp
            class(adhesive_branch_t), intent(in) :: self
            type(equilibrium_t), intent(in), target :: equilibrium
            real(wp), intent(in) :: radius
            type(contact_state_t), intent(out) :: state
            type(error_t), allocatable, intent(out) :: error
        end subroutine state_at_radius

        !> int F dd along the branch between two of its states.
        function work_of(self, equilibrium, from, to) result(work)
            import :: adhesive_branch_t, contact_state_t, equilibrium_t, wp
            class(adhesive_branch_t), intent(in) :: self
            type(equilibrium_t), intent(in) :: equilibrium
            type(contact_state_t), intent(in) :: from, to
            real(wp) :: work
        end function work_of
    end interface

contains

    !> The stable segments under a control, in ascending order of the coordinate.
    subroutine stable_segments(self, equilibrium, control, list, error)
        class(adhesive_branch_t), intent(in) :: self
        type(equilibrium_t), intent(in), target :: equilibrium
        type(control_t), intent(in) :: control
        type(stable_segment_t), allocatable, intent(out) :: list(:)
        type(error_t), allocatable, intent(out) :: error

        if (allocated(self%of_depth) .and. control%force_weight == 0.0_wp) then
            list = self%of_depth
        else if (allocated(self%of_force) .and. control%depth_weight == 0.0_wp) then
            list = self%of_force
        else
            call self%find_segments(equilibrium, control, list, error)
        end if
    end subroutine stable_segments

    !> Finds the segments under depth and force control once for all.
    subroutine keep_segments(self, equilibrium, error)
        class(adhesive_branch_t), intent(inout) :: self
        type(equilibrium_t), intent(in), target :: equilibrium
        type(error_t), allocatable, intent(inout) :: error
        type(stable_segment_t), allocatable :: of_depth(:), of_force(:)

        call self%find_segments(equilibrium, depth_control, of_depth, error)
        if (.not. allocated(error)) call self%find_segments(equilibrium, force_control, of_force, error)
        if (allocated(error)) return
        call move_alloc(of_depth, self%of_depth)
        call move_alloc(of_force, self%of_force)
    end subroutine keep_segments

    !> s at which bodies that approach begin to attract each other: they touch, or come within the range of adhesion.
    elemental function first_attraction(self, control) result(s)
        class(adhesive_branch_t), intent(in) :: self
        type(control_t), intent(in) :: control
        real(wp) :: s

        s = 0.0_wp
        if (self%range > 0.0_wp) s = control%of(-self%range, 0.0_wp)
    end function first_attraction

end module mdrcontact_contact_adhesive_branch
