! SPDX-License-Identifier: GPL-3.0-or-later
!> From a contact with friction to its compiled law, and its verification: in first shear, and along cycles of depth and shift.
module mdrcontact_law_friction_from_contact
    use mdrcontact_contact_state, only: contact_state_t
    use mdrcontact_contact_values, only: given_depth
    use mdrcontact_error, only: error_t
    use mdrcontact_history_friction, only: first_shear_t, friction_t, tangential_state_t
    use mdrcontact_history_friction_history, only: friction_history_t, given_shift, new_friction_history
    use mdrcontact_kinds, only: pi, wp
    use mdrcontact_law_friction, only: friction_law_t, friction_memory_t
    use mdrcontact_law_from_contact, only: law_options_t, new_contact_law
    implicit none (type, external)
    private
    public :: new_friction_law

    !> Parts of the largest depth and of the shift of sliding; and cycles: steps, shifts in units of the largest mu S,
    !> cycles of the shift in one of the depth.
    real(wp), parameter :: depths(*) = [0.01_wp, 0.1_wp, 1.0_wp], parts(*) = [0.05_wp, 0.3_wp, 0.6_wp, 0.9_wp]
    integer, parameter :: steps = 100
    real(wp), parameter :: amplitudes(*) = [0.3_wp, 1.0_wp, 3.0_wp], cycles(*) = [0.5_wp, 1.0_wp, 2.0_wp]

contains

    !> Compiles a contact with friction up to `largest_depth`.
    subroutine new_friction_law(self, friction, largest_depth, error, options)
        type(friction_law_t), intent(out) :: self
        type(friction_t), intent(in) :: friction
        !> > 0 [length]
        real(wp), intent(in) :: largest_depth
        type(error_t), allocatable, intent(out) :: error
        !> as of a contact's law
        type(law_options_t), intent(in), optional :: options

        allocate (self%law)
        call new_contact_law(self%law, friction%contact, largest_depth, error, options, friction%tangential)
        self%coefficient = friction%coefficient
        if (.not. allocated(error)) call verify_first_shear(self, friction, largest_depth, error)
        if (allocated(error)) return
        if (friction%contact%equilibrium%medium%has_independent_springs()) call verify_paths(self, friction, largest_depth, error)
    end subroutine new_friction_law

    !> T after one step at constant F, against what the contact itself says.
    subroutine verify_first_shear(self, friction, largest_depth, error)
        type(friction_law_t), intent(inout) :: self
        type(friction_t), intent(in) :: friction
        real(wp), intent(in) :: largest_depth
        type(error_t), allocatable, intent(out) :: error
        type(contact_state_t) :: state
        type(first_shear_t) :: shear
        type(tangential_state_t) :: exact
        type(friction_memory_t) :: memory
        integer :: i, j

        do i = 1, size(depths)
            call friction%contact%at_depth(depths(i)*largest_depth, state, error)
            if (.not. allocated(error)) call friction%first_shear(state, shear, error)
            if (allocated(error)) return
            do j = 1, size(parts)
                call shear%at_shift(parts(j)*shear%sliding_shift, exact, error)
                if (allocated(error)) return
                memory = friction_memory_t()
                call self%advance(state%force*(1.0_wp - 4.0_wp*epsilon(1.0_wp)), [0.0_wp, 0.0_wp, 0.0_wp], memory, error)
                if (.not. allocated(error)) then
                    call self%advance(memory%normal_force, [exact%shift, 0.0_wp, 0.0_wp], memory, error)
                end if
                if (allocated(error)) return
                self%first_shear_error = max(self%first_shear_error, &
                                             abs(memory%force(1) - exact%tangential_force)/shear%sliding_force)
            end do
        end do
    end subroutine verify_first_shear

    !> T along cycles of depth from touch to touch, with shifts to and fro, against the exact history.
    subroutine verify_paths(self, friction, largest_depth, error)
        type(friction_law_t), intent(inout) :: self
        type(friction_t), intent(in) :: friction
        real(wp), intent(in) :: largest_depth
        type(error_t), allocatable, intent(out) :: error
        type(friction_history_t) :: history
        type(friction_memory_t) :: memory
        real(wp) :: time, depth, shift, before, size_of_shift
        integer :: i, j, step

        self%path_error = 0.0_wp
        size_of_shift = self%coefficient*self%law%by_depth%highest
        do i = 1, size(amplitudes)
            do j = 1, size(cycles)
                call new_friction_history(history, friction, error)
                if (allocated(error)) return
                memory = friction_memory_t()
                before = 0.0_wp
                do step = 1, steps - 1
                    time = real(step, wp)/steps
                    depth = (1.0_wp - 4.0_wp*epsilon(1.0_wp))*largest_depth*sin(pi*time)
                    shift = amplitudes(i)*size_of_shift*sin(2.0_wp*pi*cycles(j)*time)
                    call history%advance(given_depth, depth, given_shift, shift, error)
                    if (.not. allocated(error)) then
                        call self%advance(history%past%normal%force, [shift - before, 0.0_wp, 0.0_wp], memory, error)
                    end if
                    if (allocated(error)) return
                    before = shift
                    self%path_error = max(self%path_error, abs(memory%force(1) - history%past%tangential%tangential_force) &
                                          /(self%coefficient*self%law%by_force%highest))
                end do
            end do
        end do
    end subroutine verify_paths

end module mdrcontact_law_friction_from_contact
