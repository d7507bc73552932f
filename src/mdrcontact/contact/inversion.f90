! SPDX-License-Identifier: GPL-3.0-or-later
!> From a given depth or force to the non-adhesive state: the contact radius that has it, found where every law is nearly straight.
module mdrcontact_inversion
    use mdrcontact_branch, only: control_t
    use mdrcontact_contact_state, only: contact_state_t
    use mdrcontact_equilibrium, only: equilibrium_t
    use mdrcontact_error, only: error_t, error_unreachable, raise, to_text
    use mdrcontact_kinds, only: wp
    use mdrcontact_roots, only: guess_from_below, solve_increasing
    use mdrcontact_scalar_function, only: scalar_function_t
    implicit none (type, external)
    private
    public :: invert

    !> ln(s/target), s = d or F or what a spring adds of both, as a function of ln(a - end radius): close to linear for every
    !> shape and medium.
    type, extends(scalar_function_t) :: mismatch_t
        type(equilibrium_t), pointer :: equilibrium => null()
        type(control_t) :: control
        real(wp) :: target_value = 0.0_wp
    contains
        procedure :: value => mismatch_value
    end type mismatch_t

    !> ln of the smallest contact radius searched: its cube is still a normal number.
    real(wp), parameter :: smallest_log = -230.0_wp
    !> ln of the contact radius at which the search for a radius begins.
    real(wp), parameter :: first_guess = -35.0_wp

contains

    !> The non-adhesive state with a given s, which grows with the contact radius.
    subroutine invert(equilibrium, control, name, s, state, error)
        type(equilibrium_t), intent(in), target :: equilibrium
        type(control_t), intent(in) :: control
        character(len=*), intent(in) :: name
        real(wp), intent(in) :: s
        type(contact_state_t), intent(out) :: state
        type(error_t), allocatable, intent(out) :: error
        real(wp) :: closest
        logical :: found

        if (s <= 0.0_wp) then
            call equilibrium%at(equilibrium%profile%end_radius(), state, error)
            return
        end if
        if (equilibrium%profile%has_wall() .and. equilibrium%last_radius >= equilibrium%profile%largest_radius()) then
            call equilibrium%at(equilibrium%last_radius, state, error)
            if (allocated(error)) return
            if (s >= control%of(state%depth, state%force)) then
                call push_beyond_wall(state, control, s)
                return
            end if
        end if
        call radius_with(equilibrium, control, s, closest, found, error)
        if (allocated(error)) return
        call equilibrium%at(closest, state, error)
        if (allocated(error) .or. found) return
        call raise(error, error_unreachable, name//" = "//to_text(s)//" cannot be reached: at radius "//to_text(state%radius)// &
                   ", where the indenter or the medium ends, the "//name//" is "//to_text(control%of(state%depth, state%force)))
    end subroutine invert

    !> At a vertical wall the radius stays and the indenter goes on as a flat punch.
    pure subroutine push_beyond_wall(state, control, s)
        type(contact_state_t), intent(inout) :: state
        type(control_t), intent(in) :: control
        real(wp), intent(in) :: s

        state%excess = (s - control%of(state%depth, state%force))/control%of(1.0_wp, state%stiffness)
        state%depth = state%depth + state%excess
        state%force = state%force + state%stiffness*state%excess
    end subroutine push_beyond_wall

    subroutine radius_with(equilibrium, control, s, radius, found, error)
        type(equilibrium_t), intent(in), target :: equilibrium
        type(control_t), intent(in) :: control
        real(wp), intent(in) :: s
        real(wp), intent(out) :: radius
        logical, intent(out) :: found
        type(error_t), allocatable, intent(out) :: error
        type(mismatch_t) :: mismatch
        real(wp) :: first, last, guess, slope, root

        mismatch%equilibrium => equilibrium
        mismatch%control = control
        mismatch%target_value = s
        first = smallest_log
        if (equilibrium%medium%smallest_radius() > equilibrium%profile%end_radius()) then
            first = equilibrium%coordinate_of(equilibrium%medium%smallest_radius())
        end if
        last = equilibrium%coordinate_of(equilibrium%last_radius)
        radius = -1.0_wp
        if (control%depth_weight > 0.0_wp) radius = equilibrium%profile%radius_from_mdr(s/control%depth_weight)
        if (radius > equilibrium%profile%end_radius()) then
            guess = equilibrium%coordinate_of(radius)
            slope = 2.0_wp
        else
            call guess_from_below(mismatch, min(max(first, first_guess), last - 1.0_wp), 0.0_wp, guess, slope)
            if (allocated(mismatch%error)) then
                found = .false.
                error = mismatch%error
                return
            end if
        end if
        call solve_increasing(mismatch, guess, slope, first, last, root, found, error)
        radius = equilibrium%radius_of(root)
    end subroutine radius_with

    function mismatch_value(self, x) result(y)
        class(mismatch_t), intent(inout) :: self
        real(wp), intent(in) :: x
        real(wp) :: y
        real(wp) :: depth, force

        y = 0.0_wp
        force = 0.0_wp
        if (self%control%force_weight > 0.0_wp) then
            call self%equilibrium%first_touch(self%equilibrium%radius_of(x), depth, force, self%error)
        else
            call self%equilibrium%medium%first_touch_depth(self%equilibrium%profile, self%equilibrium%radius_of(x), depth, &
                                                           self%error)
        end if
        if (allocated(self%error)) return
        y = log(max(self%control%of(depth, force), tiny(depth))/self%target_value)
    end function mismatch_value

end module mdrcontact_inversion
