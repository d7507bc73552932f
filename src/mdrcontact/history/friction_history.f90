! SPDX-License-Identifier: GPL-3.0-or-later
!> A contact with friction along any path of normal and tangential loading, with the memory of where it has slipped (theory 10).
module mdrcontact_history_friction_history
    use mdrcontact_contact_state, only: contact_state_t
    use mdrcontact_contact_values, only: given_depth, given_force
    use mdrcontact_error, only: check_finite, count_text, error_invalid, error_t, error_unreachable, raise, to_text
    use mdrcontact_history_friction, only: friction_t, tangential_state_t
    use mdrcontact_history_friction_springs, only: radius_at, springs_t
    use mdrcontact_kinds, only: wp
    use mdrcontact_numerics_roots, only: find_root
    use mdrcontact_numerics_scalar_function, only: scalar_function_t
    implicit none (type, external)
    private
    public :: friction_history_t, new_friction_history, given_shift, given_tangential_force

    !> What is prescribed along the surface, enum mdr_tangential_given.
    integer, parameter :: given_shift = 1, given_tangential_force = 2

    !> A contact with its past. It belongs to its user: copies are independent, and no two threads may advance one at a time.
    type :: friction_history_t
        private
        type(friction_t) :: friction
        !> G* [modulus]
        real(wp) :: modulus = 0.0_wp
        type(springs_t) :: springs
        !> the states reached, all 0 at first; energy dissipated since then
        type(contact_state_t), public :: normal
        !> see normal
        type(tangential_state_t), public :: tangential
    contains
        procedure :: advance
    end type friction_history_t

    !> T after a step to a shift, less what it should be.
    type, extends(scalar_function_t) :: force_after_t
        type(friction_history_t), pointer :: history => null()
        real(wp) :: depth = 0.0_wp, target = 0.0_wp
    contains
        procedure :: value => force_after
    end type force_after_t

contains

    !> A contact that has not been loaded yet.
    subroutine new_friction_history(self, friction, error)
        type(friction_history_t), intent(out) :: self
        !> on homogeneous bodies, whose springs do not interact. Copied
        type(friction_t), intent(in) :: friction
        type(error_t), allocatable, intent(out) :: error
        real(wp) :: normal(1), shear(1)

        if (.not. friction%contact%equilibrium%medium%has_independent_springs()) then
            call raise(error, error_invalid, "histories of friction are known for homogeneous bodies only; at constant normal "// &
                       "force tangential states and loops are known for this medium too")
            return
        end if
        call friction%contact%equilibrium%medium%modulus([1.0_wp], normal, error)
        if (.not. allocated(error)) call friction%tangential%modulus([1.0_wp], shear, error)
        if (allocated(error)) return
        self%friction = friction
        self%modulus = shear(1)
        self%springs%limit = friction%coefficient*normal(1)/shear(1)
    end subroutine new_friction_history

    !> One step of the path, in which depth and shift change in proportion; after a failure all is as before.
    subroutine advance(self, normal_given, normal, tangential_given, tangential, error)
        class(friction_history_t), intent(inout) :: self
        !> given_depth or given_force, and d [length] or F [modulus length^2] at the end of the step, >= 0
        integer, intent(in) :: normal_given
        !> see normal_given
        real(wp), intent(in) :: normal
        !> given_shift or given_tangential_force, and s [length] or T [modulus length^2] at its end, |T| < mu F
        integer, intent(in) :: tangential_given
        !> see tangential_given
        real(wp), intent(in) :: tangential
        type(error_t), allocatable, intent(out) :: error
        type(contact_state_t) :: state
        type(springs_t) :: springs
        real(wp) :: shift, force, dissipated, stick

        associate (contact => self%friction%contact)
            select case (normal_given)
            case (given_depth)
                call contact%at_depth(normal, state, error)
            case (given_force)
                call contact%at_force(normal, state, error)
            case default
                call raise(error, error_invalid, "normal_given = "//count_text(normal_given)//" is not allowed: it must be 1 "// &
                           "(depth) or 2 (force)")
            end select
            if (allocated(error)) return
            select case (tangential_given)
            case (given_shift)
                call check_finite(error, "shift", tangential)
                shift = tangential
            case (given_tangential_force)
                call find_shift(self, state, tangential, shift, error)
            case default
                call raise(error, error_invalid, "tangential_given = "//count_text(tangential_given)//" is not allowed: it "// &
                           "must be 1 (shift) or 2 (tangential force)")
            end select
            if (allocated(error)) return
            springs = self%springs
            call springs%advance(state%depth, shift)
            call springs%force(contact, force, error)
            if (.not. allocated(error)) call springs%dissipated(contact, dissipated, error)
            if (.not. allocated(error)) call radius_at(contact, springs%stick_depth(), stick, error)
        end associate
        if (allocated(error)) return
        self%springs = springs
        self%normal = state
        self%tangential%shift = shift
        self%tangential%tangential_force = self%modulus*force
        self%tangential%stick_radius = stick
        self%tangential%stiffness = 2.0_wp*stick*self%modulus
        self%tangential%dissipated_energy = self%tangential%dissipated_energy + self%modulus*dissipated
        self%tangential%sliding = merge(1.0_wp, 0.0_wp, state%radius > 0.0_wp .and. .not. stick > 0.0_wp)
    end subroutine advance

    !> The shift at which the tangential force is as asked for: it rises with the shift.
    subroutine find_shift(self, state, force, shift, error)
        class(friction_history_t), intent(in), target :: self
        type(contact_state_t), intent(in) :: state
        real(wp), intent(in) :: force
        real(wp), intent(out) :: shift
        type(error_t), allocatable, intent(out) :: error
        type(force_after_t) :: equation
        real(wp) :: reach

        shift = self%tangential%shift
        call check_finite(error, "tangential_force", force)
        if (allocated(error)) return
        if (abs(force) >= self%friction%coefficient*state%force .and. abs(force) > 0.0_wp) then
            call raise(error, error_unreachable, " = "//to_text(force)//" cannot be reached: the contact slides at coefficient "// &
                       "times normal force, "//to_text(self%friction%coefficient*state%force)//", and its shift is then free", &
                       "tangential_force")
            return
        end if
        if (.not. state%radius > 0.0_wp) return
        ! beyond, all slides
        reach = 2.1_wp*self%springs%limit*max(state%depth, self%normal%depth)
        allocate (equation%history, source=self)
        equation%depth = state%depth
        equation%target = force
        call find_root(equation, shift - reach, shift + reach, shift, error)
        deallocate (equation%history)
    end subroutine find_shift

    function force_after(self, x) result(y)
        class(force_after_t), intent(inout) :: self
        real(wp), intent(in) :: x
        real(wp) :: y
        type(springs_t) :: springs

        y = 0.0_wp
        springs = self%history%springs
        call springs%advance(self%depth, x)
        call springs%force(self%history%friction%contact, y, self%error)
        y = self%history%modulus*y - self%target
    end function force_after

end module mdrcontact_history_friction_history
