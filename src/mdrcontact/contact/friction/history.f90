! SPDX-License-Identifier: GPL-3.0-or-later
!> A contact with friction along any path of normal and tangential loading, with the memory of where it has slipped
!> (theory/friction.md (6.1), (6.2)).
module mdrcontact_friction_history
    use, intrinsic :: iso_fortran_env, only: int64
    use mdrcontact_object, only: real_bytes, room
    use mdrcontact_cancel, only: check_cancelled
    use mdrcontact_codes, only: given_shift => shift, given_tangential_force => tangential_force
    use mdrcontact_contact_state, only: contact_state_t
    use mdrcontact_contact_values, only: given_depth, given_force
    use mdrcontact_error, only: check_code, check_finite, check_made, check_not_negative, count_text, error_domain, &
                                error_invalid, error_t, error_unreachable, raise, to_text
    use mdrcontact_friction_partial_slip, only: friction_t, tangential_state_t
    use mdrcontact_friction_rings, only: new_ring_grid, ring_grid_t, rings_t
    use mdrcontact_friction_springs, only: radius_at, springs_t
    use mdrcontact_kinds, only: wp
    use mdrcontact_numerics_roots, only: find_root
    use mdrcontact_numerics_scalar_function, only: scalar_function_t
    implicit none (type, external)
    private
    public :: friction_history_t, friction_past_t, new_friction_history, given_shift, given_tangential_force

    integer, parameter :: most_doublings = 60
    !> Default number of rings, and its range.
    integer, parameter :: usual_rings = 100, fewest_rings = 10, most_rings = 1000

    !> Record of the past: the states reached, all 0 at first, with the energy dissipated since then; and by springs, or by rings
    !> where there are.
    type :: friction_past_t
        type(contact_state_t) :: normal
        type(tangential_state_t) :: tangential
        type(springs_t), private :: springs
        type(rings_t), allocatable, private :: rings
    end type friction_past_t

    !> A contact with its past. It belongs to its user: copies are independent, and no two threads may advance one at a time.
    type :: friction_history_t
        private
        !> whether it was made: set last by what makes it
        logical, public :: is_made = .false.
        type(friction_t) :: friction
        !> G* [modulus]
        real(wp) :: modulus = 0.0_wp
        !> where springs interact, and where they are requested
        type(ring_grid_t), allocatable :: grid
        !> a copy of it restores this state
        type(friction_past_t), allocatable, public :: past
    contains
        procedure :: advance
        procedure :: copy
    end type friction_history_t

    !> T after a step to a shift, less what it should be.
    type, extends(scalar_function_t) :: force_after_t
        class(friction_history_t), pointer :: history => null()
        type(contact_state_t) :: state
        real(wp) :: target = 0.0_wp
    contains
        procedure :: value => force_after
    end type force_after_t

contains

    !> A contact that has not been loaded yet.
    subroutine new_friction_history(self, friction, error, largest_depth, rings)
        type(friction_history_t), intent(out) :: self
        !> on homogeneous bodies, whose springs do not interact, or on exact layered ones. Copied
        type(friction_t), intent(in) :: friction
        type(error_t), allocatable, intent(out) :: error
        !> up to which there are rings, > 0; needed on layered bodies. Without it, or with 0, each step on homogeneous ones is exact
        !> [length]
        real(wp), intent(in), optional :: largest_depth
        !> how many, 10 to 1000; default or 0: 100
        integer, intent(in), optional :: rings
        type(contact_state_t) :: state
        real(wp) :: normal(1), shear(1), deepest
        integer :: count

        deepest = 0.0_wp
        call check_made(error, "friction", friction%is_made)
        if (allocated(error)) return
        if (present(largest_depth)) deepest = largest_depth
        count = 0
        if (present(rings)) count = rings
        if (count == 0) count = usual_rings
        call check_not_negative(error, "largest_depth", deepest)
        if (count < fewest_rings .or. count > most_rings) then
            call raise(error, error_invalid, "rings = "//count_text(count)//": it must be from "//count_text(fewest_rings)// &
                       " to "//count_text(most_rings))
        end if
        if (allocated(error)) return
        call room(friction%bytes(), error)
        if (allocated(error)) return
        self%friction = friction
        allocate (self%past)
        associate (contact => self%friction%contact, medium => self%friction%contact%equilibrium%medium)
            if (deepest > 0.0_wp) then
                call contact%at_depth(deepest, state, error)
                if (allocated(error)) return
                allocate (self%grid, self%past%rings)
                call new_ring_grid(self%grid, friction%tangential, state, count, error)
            else if (medium%has_free_springs) then
                call medium%modulus([1.0_wp], normal, error)
                if (.not. allocated(error)) call friction%tangential%modulus([1.0_wp], shear, error)
                if (allocated(error)) return
                self%modulus = shear(1)
                self%past%springs%limit = friction%coefficient*normal(1)/shear(1)
            else
                call raise(error, error_invalid, "largest_depth is missing: on a layered body a history of friction needs the "// &
                           "largest depth of its rings")
            end if
        end associate
        self%is_made = .not. allocated(error)
    end subroutine new_friction_history

    !> One step of the path, in which depth and shift change proportionally; after a failure all is as before.
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
        type(friction_past_t) :: next
        type(tangential_state_t) :: sheared
        real(wp) :: shift, dissipated, modulus(1)

        call check_made(error, "history", self%is_made)
        if (allocated(error)) return
        call check_cancelled(error)
        if (allocated(error)) return
        associate (contact => self%friction%contact)
            select case (normal_given)
            case (given_depth)
                call contact%at_depth(normal, state, error)
            case (given_force)
                call contact%at_force(normal, state, error)
            case default
                call check_code(error, "normal_given", normal_given, [given_depth, given_force])
            end select
            if (allocated(error)) return
            if (allocated(self%grid)) then
                if (state%depth > self%grid%largest_depth) then
                    call raise(error, error_domain, "depth = "//to_text(state%depth)//": the rings of this history reach up "// &
                               "to largest_depth = "//to_text(self%grid%largest_depth))
                    return
                end if
            end if
            select case (tangential_given)
            case (given_shift)
                call check_finite(error, "shift", tangential)
                shift = tangential
            case (given_tangential_force)
                call find_shift(self, state, tangential, shift, error)
            case default
                call check_code(error, "tangential_given", tangential_given, [given_shift, given_tangential_force])
            end select
            if (allocated(error)) return
        end associate
        next = self%past
        call move(self, next, state, shift, sheared%tangential_force, dissipated, sheared%stick_radius, error)
        if (allocated(error)) return
        if (sheared%stick_radius > 0.0_wp) then
            call self%friction%tangential%modulus([sheared%stick_radius], modulus, error)
            if (allocated(error)) return
            sheared%stiffness = 2.0_wp*sheared%stick_radius*modulus(1)
        end if
        sheared%shift = shift
        sheared%dissipated_energy = self%past%tangential%dissipated_energy + dissipated
        sheared%sliding = merge(1.0_wp, 0.0_wp, state%radius > 0.0_wp .and. .not. sheared%stick_radius > 0.0_wp)
        self%past = next
        self%past%normal = state
        self%past%tangential = sheared
    end subroutine advance

    !> An independent copy.
    subroutine copy(self, other, error)
        class(friction_history_t), intent(in) :: self
        type(friction_history_t), intent(out) :: other
        type(error_t), allocatable, intent(out) :: error
        integer(int64) :: bytes

        call check_made(error, "history", self%is_made)
        if (allocated(error)) return
        bytes = self%friction%bytes()
        if (allocated(self%grid)) bytes = bytes + real_bytes*size(self%grid%products)
        call room(bytes, error)
        if (allocated(error)) return
        other%friction = self%friction
        other%modulus = self%modulus
        other%past = self%past
        if (allocated(self%grid)) other%grid = self%grid
        other%is_made = .true.
    end subroutine copy

    !> T, what is dissipated and the radius of stick of a step.
    subroutine move(self, past, state, shift, force, dissipated, stick, error)
        class(friction_history_t), intent(in) :: self
        type(friction_past_t), intent(inout) :: past
        type(contact_state_t), intent(in) :: state
        real(wp), intent(in) :: shift
        real(wp), intent(out) :: force, dissipated, stick
        type(error_t), allocatable, intent(inout) :: error

        associate (friction => self%friction)
            force = 0.0_wp
            dissipated = 0.0_wp
            stick = 0.0_wp
            if (allocated(self%grid)) then
                call past%rings%advance(self%grid, friction%contact, friction%tangential, friction%coefficient, state, shift, error)
                force = past%rings%force
                dissipated = past%rings%dissipated
                stick = past%rings%stick_radius
            else
                call past%springs%advance(state%depth, shift)
                call past%springs%force(friction%contact, force, error)
                if (.not. allocated(error)) call past%springs%dissipated(friction%contact, dissipated, error)
                if (.not. allocated(error)) call radius_at(friction%contact, past%springs%stick_depth(), stick, error)
                force = self%modulus*force
                dissipated = self%modulus*dissipated
            end if
        end associate
    end subroutine move

    !> The shift at which the tangential force has the given value: it rises with the shift.
    subroutine find_shift(self, state, force, shift, error)
        class(friction_history_t), intent(in), target :: self
        type(contact_state_t), intent(in) :: state
        real(wp), intent(in) :: force
        real(wp), intent(out) :: shift
        type(error_t), allocatable, intent(out) :: error
        type(force_after_t) :: equation
        real(wp) :: reach, modulus(1)
        integer :: i

        shift = self%past%tangential%shift
        call check_finite(error, "tangential_force", force)
        if (allocated(error)) return
        if (abs(force) >= self%friction%coefficient*state%force .and. abs(force) > 0.0_wp) then
            call raise(error, error_unreachable, " = "//to_text(force)//": the contact slides at coefficient times normal "// &
                       "force, "//to_text(self%friction%coefficient*state%force)//", at which the shift is undetermined", &
                       "tangential_force")
            return
        end if
        if (.not. state%radius > 0.0_wp) return
        call self%friction%tangential%modulus([state%radius], modulus, error)
        if (allocated(error)) return
        reach = self%friction%coefficient*max(state%force, self%past%normal%force)/(state%radius*modulus(1))
        equation%history => self
        equation%state = state
        equation%target = force
        ! up to where all slides
        do i = 1, most_doublings
            if (equation%value(shift - reach)*equation%value(shift + reach) <= 0.0_wp .or. allocated(equation%error)) exit
            reach = 2.0_wp*reach
        end do
        call find_root(equation, shift - reach, shift + reach, shift, error)
    end subroutine find_shift

    function force_after(self, x) result(y)
        class(force_after_t), intent(inout) :: self
        real(wp), intent(in) :: x
        real(wp) :: y
        type(friction_past_t) :: next
        real(wp) :: dissipated, stick

        next = self%history%past
        call move(self%history, next, self%state, x, y, dissipated, stick, self%error)
        y = y - self%target
    end function force_after

end module mdrcontact_friction_history
