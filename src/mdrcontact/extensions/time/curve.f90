! SPDX-License-Identifier: GPL-3.0-or-later
!> The elastic curve F(d), a(d) from which the history of a body of one relaxation shape follows: states of the elastic contact, by
!> a compiled law where each is the solution of a system and many are needed.
module mdrcontact_time_curve
    use mdrcontact_contact, only: contact_t
    use mdrcontact_contact_state, only: contact_state_t
    use mdrcontact_contact_values, only: contact_states, given_depth
    use mdrcontact_error, only: check_memory, error_t
    use mdrcontact_kinds, only: wp
    use mdrcontact_law, only: contact_law_t, law_point_t
    use mdrcontact_law_from_contact, only: law_options_t, new_contact_law
    implicit none (type, external)
    private
    public :: elastic_curve_t, break_depths

    !> From so many states on a law costs less than they do.
    integer, parameter :: many = 200
    real(wp), parameter :: law_tolerance = 1.0e-9_wp

    !> An elastic contact, and its law once it is compiled.
    type :: elastic_curve_t
        type(contact_t), pointer :: contact => null()
        type(contact_law_t), allocatable :: law
    contains
        procedure :: at_depths
    end type elastic_curve_t

contains

    !> F, a and k = dF/dd at depths > 0.
    subroutine at_depths(self, depths, error, force, radius, stiffness)
        class(elastic_curve_t), intent(inout) :: self
        real(wp), intent(in) :: depths(:)
        type(error_t), allocatable, intent(out) :: error
        !> same size as depths
        real(wp), intent(out), optional :: force(:), radius(:), stiffness(:)
        type(contact_state_t), allocatable :: states(:)
        type(law_point_t) :: point
        type(law_options_t) :: options
        integer :: i, stat

        if (size(depths) == 0) return
        if (.not. self%contact%is_formula() .and. .not. allocated(self%law) .and. size(depths) > many) then
            allocate (self%law)
            options%tolerance = law_tolerance
            call new_contact_law(self%law, self%contact, maxval(depths), error, options)
            if (allocated(error)) then
                ! then state by state
                deallocate (self%law)
                deallocate (error)
            end if
        end if
        if (allocated(self%law)) then
            do i = 1, size(depths)
                call self%law%at_depth(min(depths(i), self%law%by_depth%highest), point, error)
                if (allocated(error)) return
                if (present(force)) force(i) = point%force
                if (present(radius)) radius(i) = point%radius
                if (present(stiffness)) stiffness(i) = point%stiffness
            end do
        else
            allocate (states(size(depths)), stat=stat)
            call check_memory(error, stat)
            if (allocated(error)) return
            call find_states(self%contact, depths, states, error)
            if (allocated(error)) return
            if (present(force)) force = states%force
            if (present(radius)) radius = states%radius
            if (present(stiffness)) stiffness = states%stiffness
        end if
    end subroutine at_depths

    !> States at depths > 0; on a homogeneous body under an indenter whose g(x) has an inverse they need no search.
    subroutine find_states(contact, depths, states, error)
        type(contact_t), intent(in) :: contact
        real(wp), intent(in) :: depths(:)
        type(contact_state_t), intent(out) :: states(:)
        type(error_t), allocatable, intent(out) :: error
        integer :: i

        associate (equilibrium => contact%equilibrium)
            if (.not. contact%is_formula() .or. .not. equilibrium%profile%radius_from_mdr(depths(1)) > 0.0_wp) then
                call contact_states(contact, given_depth, depths, states, error)
                return
            end if
            do i = 1, size(depths)
                call contact%at_radius(equilibrium%profile%radius_from_mdr(depths(i)), states(i), error)
                if (allocated(error)) return
            end do
        end associate
    end subroutine find_states

    !> Depths at which the curve is not analytic, ascending [length].
    subroutine break_depths(contact, depths, error)
        type(contact_t), intent(in) :: contact
        real(wp), allocatable, intent(out) :: depths(:)
        type(error_t), allocatable, intent(out) :: error
        type(contact_state_t) :: state
        real(wp), allocatable :: radii(:)
        real(wp) :: end_radius, smallest, largest
        integer :: i, stat

        call contact%radius_range(end_radius, smallest, largest, radii, error)
        allocate (depths(size(radii)), stat=stat)
        call check_memory(error, stat)
        if (allocated(error)) return
        do i = 1, size(radii)
            call contact%at_radius(radii(i), state, error)
            if (allocated(error)) return
            depths(i) = state%depth
        end do
    end subroutine break_depths

end module mdrcontact_time_curve
