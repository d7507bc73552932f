! SPDX-License-Identifier: GPL-3.0-or-later
!> A contact that wears by Archard's law, dh = k p ds (theory/wear.md (1.1), (8.1), (8.2)). The body keeps its shape and its layers
!> unless said: everything here is exact on layered bodies.
module mdrcontact_wear
    use mdrcontact_contact, only: contact_t
    use mdrcontact_contact_load, only: contact_load_t
    use mdrcontact_contact_state, only: contact_state_t
    use mdrcontact_contact_values, only: given_depth
    use mdrcontact_error, only: check_made, check_memory, check_not_negative, check_positive, error_domain, error_invalid, &
                                error_t, raise, to_text
    use mdrcontact_kinds, only: wp
    use mdrcontact_profile_worn, only: worn_profile_t
    use mdrcontact_wear_limit, only: check_carries, check_control, find_limit, wear_limit_t
    use mdrcontact_wear_rate, only: new_wear_rate, wear_rate_t
    use mdrcontact_wear_running_in, only: slowest_decay
    implicit none (type, external)
    private
    public :: new_wear, wear_t

    !> A track up to this part of the depth: beyond, tip and groove conform.
    real(wp), parameter :: deepest_track = 0.1_wp

    !> A contact and how fast its two sides wear.
    type :: wear_t
        !> whether it was made: set last by what makes it
        logical :: is_made = .false.
        !> unworn
        type(contact_t) :: contact
        !> of the indenter
        type(wear_rate_t) :: rate
        !> k of the body, >= 0 [1/modulus]
        real(wp) :: body_coefficient = 0.0_wp
    contains
        procedure :: limit
        procedure :: track
        procedure :: passes_through
        procedure :: running_in_length
    end type wear_t

contains

    !> Wear of a contact without adhesion.
    subroutine new_wear(self, contact, coefficients, error, thickness, body_coefficient)
        type(wear_t), intent(out) :: self
        !> copied
        type(contact_t), intent(in) :: contact
        !> k > 0 of the indenter: worn volume per force and sliding distance; of its layers from the surface, where there are
        !> [1/modulus]
        real(wp), intent(in) :: coefficients(:)
        type(error_t), allocatable, intent(out) :: error
        !> of the layers of the indenter, one less than coefficients [length]
        real(wp), intent(in), optional :: thickness(:)
        !> k >= 0 of the body, default 0 [1/modulus]
        real(wp), intent(in), optional :: body_coefficient

        call check_made(error, "contact", contact%is_made)
        if (allocated(error)) return
        if (present(thickness)) then
            call new_wear_rate(self%rate, coefficients, thickness, error)
        else
            call new_wear_rate(self%rate, coefficients, [real(wp) ::], error)
        end if
        if (present(body_coefficient)) self%body_coefficient = body_coefficient
        call check_not_negative(error, "body_coefficient", self%body_coefficient)
        if (.not. allocated(error) .and. contact%is_adhesive()) then
            call raise(error, error_invalid, "wear: it is not available with adhesion, because Archard's law is not defined "// &
                "under tension. Set work_of_adhesion = 0")
        end if
        if (allocated(error)) return
        self%contact = contact
        self%is_made = .not. allocated(error)
    end subroutine new_wear

    !> The end of fretting: see mdrcontact_wear_limit.
    subroutine limit(self, state, stick_radius, control, reached, error, profile)
        class(wear_t), intent(in), target :: self
        !> of the unworn contact
        type(contact_state_t), intent(in) :: state
        !> 0 < c <= a [length]
        real(wp), intent(in) :: stick_radius
        !> given_depth or given_force
        integer, intent(in) :: control
        type(wear_limit_t), intent(out) :: reached
        type(error_t), allocatable, intent(out) :: error
        !> the worn indenter
        type(worn_profile_t), allocatable, intent(out), optional :: profile

        call check_made(error, "wear", self%is_made)
        if (allocated(error)) return
        call find_limit(self%contact, state, stick_radius, control, reached, error, profile)
    end subroutine limit

    !> h(y) = k N q(y): depth of the track that the tip leaves in the body after N passes, since the load that passes over a place
    !> at distance y from its axis, int p dx, is the line load; to first order in h/d.
    subroutine track(self, state, y, passes, depths, error)
        class(wear_t), intent(in), target :: self
        type(contact_state_t), intent(in) :: state
        !> distances from the axis of the track, >= 0 [length]
        real(wp), intent(in) :: y(:)
        !> N > 0 [1]
        real(wp), intent(in) :: passes
        !> 0 beyond the contact radius [length]
        real(wp), intent(out) :: depths(:)
        type(error_t), allocatable, intent(out) :: error
        type(contact_load_t) :: load
        real(wp) :: axis(1)
        real(wp), allocatable :: loads(:)
        integer :: i, stat

        depths = 0.0_wp
        call check_made(error, "wear", self%is_made)
        if (allocated(error)) return
        call check_body(self, error)
        call check_positive(error, "passes", passes)
        do i = 1, size(y)
            call check_not_negative(error, "y", y(i), i)
        end do
        if (.not. allocated(error)) call self%contact%load(state, load, error)
        if (.not. allocated(error)) call load%line_load([0.0_wp], axis, error)
        if (.not. allocated(error)) call check_carries(load, error)
        if (.not. allocated(error)) call check_shallow(self%body_coefficient*passes*axis(1), state, error)
        if (.not. allocated(error)) then
            allocate (loads(size(y)), stat=stat)
            call check_memory(error, stat)
        end if
        if (allocated(error)) return
        call load%line_load(min(y, state%radius), loads, error)
        if (.not. allocated(error)) depths = merge(self%body_coefficient*passes*loads, 0.0_wp, y <= state%radius)
    end subroutine track

    !> N = h/(k q(0)): passes of the tip until its track is as deep as h.
    subroutine passes_through(self, state, depth, passes, error)
        class(wear_t), intent(in), target :: self
        type(contact_state_t), intent(in) :: state
        !> h > 0, such as the thickness of a coating [length]
        real(wp), intent(in) :: depth
        !> N [1]
        real(wp), intent(out) :: passes
        type(error_t), allocatable, intent(out) :: error
        type(contact_load_t) :: load
        real(wp) :: axis(1)

        passes = 0.0_wp
        call check_made(error, "wear", self%is_made)
        if (allocated(error)) return
        call check_body(self, error)
        call check_positive(error, "depth", depth)
        if (.not. allocated(error)) call self%contact%load(state, load, error)
        if (.not. allocated(error)) call load%line_load([0.0_wp], axis, error)
        if (.not. allocated(error)) call check_carries(load, error)
        if (.not. allocated(error)) call check_shallow(depth, state, error)
        if (.not. allocated(error)) passes = depth/(self%body_coefficient*axis(1))
    end subroutine passes_through

    !> The length l [length]: under a flat punch what the pressure still differs by from that at the end, F/(pi a^2) at constant
    !> force, 0 at constant depth, falls as exp(-s/l) after some of them. Of a coated punch that is worn through.
    subroutine running_in_length(self, control, length, error)
        class(wear_t), intent(in) :: self
        !> given_depth or given_force: what is constant
        integer, intent(in) :: control
        !> sliding distance [length]
        real(wp), intent(out) :: length
        type(error_t), allocatable, intent(out) :: error

        length = 0.0_wp
        call check_made(error, "wear", self%is_made)
        if (allocated(error)) return
        call check_control(error, control)
        if (allocated(error)) return
        associate (profile => self%contact%equilibrium%profile)
            if (.not. profile%has_wall .or. profile%end_radius < profile%largest_radius) then
                call raise(error, error_invalid, "indenter: running_in_length needs a flat punch. For other indenters use a "// &
                           "sliding history")
                return
            end if
            call slowest_decay(self%contact%equilibrium%medium, profile%largest_radius, &
                               self%rate%coefficients(size(self%rate%coefficients)), control == given_depth, length, error)
        end associate
    end subroutine running_in_length

    pure subroutine check_body(self, error)
        class(wear_t), intent(in) :: self
        type(error_t), allocatable, intent(inout) :: error

        if (self%body_coefficient > 0.0_wp) return
        call raise(error, error_invalid, "body_coefficient = 0: it must be greater than 0 for a track")
    end subroutine check_body

    !> Raises where a track is so deep that the contact is no longer that with a flat.
    pure subroutine check_shallow(depth, state, error)
        real(wp), intent(in) :: depth
        type(contact_state_t), intent(in) :: state
        type(error_t), allocatable, intent(inout) :: error

        if (depth <= deepest_track*state%depth) return
        call raise(error, error_domain, "a track of depth "//to_text(depth)//" is too deep: it must be at most "// &
                   to_text(deepest_track)//" of the indentation depth, "//to_text(state%depth)// &
                   ". A deeper groove conforms to the tip")
    end subroutine check_shallow

end module mdrcontact_wear
