! SPDX-License-Identifier: GPL-3.0-or-later
!> The equilibrium of an indenter on a medium at a given contact radius, with or without adhesion (theory 2, 4 and 5).
!>
!> With adhesion the edge springs hang by dl(a): d = d0(a) - dl(a), F = F0(a) - k(a) dl(a), d0 and F0 without it.
module mdrcontact_contact_equilibrium
    use, intrinsic :: ieee_arithmetic, only: ieee_is_finite
    use mdrcontact_contact_state, only: contact_state_t
    use mdrcontact_error, only: error_no_convergence, error_t, raise, to_text
    use mdrcontact_kinds, only: pi, wp
    use mdrcontact_medium, only: medium_t
    use mdrcontact_profile, only: profile_t
    implicit none (type, external)
    private
    public :: equilibrium_t, largest_contact_radius
    public :: adhesion_automatic, adhesion_paper, adhesion_energy

    !> dl by the source's rule (28), sqrt(2 pi a gamma/E_eff), or by the balance of energy, sqrt(4 pi a gamma/k'(a)).
    !> Automatic: the energy balance where the medium meets it exactly, the source's rule elsewhere.
    integer, parameter :: adhesion_automatic = 0, adhesion_paper = 1, adhesion_energy = 2

    !> No contact radius is larger [length].
    real(wp), parameter :: largest_number = 1.0e100_wp

    !> What determines a state once the contact radius is known.
    type :: equilibrium_t
        class(profile_t), allocatable :: profile
        class(medium_t), allocatable :: medium
        !> gamma >= 0 [modulus length]
        real(wp) :: work_of_adhesion = 0.0_wp
        !> one of adhesion_...
        integer :: rule = adhesion_automatic
        !> the largest contact radius at which all parts are defined [length]
        real(wp) :: last_radius = 0.0_wp
    contains
        procedure :: at
        procedure :: radius_of
        procedure :: coordinate_of
    end type equilibrium_t

contains

    !> The state at a radius that the caller has checked; at a vertical wall that of the lowest depth.
    subroutine at(self, radius, state, error)
        class(equilibrium_t), intent(in) :: self
        real(wp), intent(in) :: radius
        type(contact_state_t), intent(out) :: state
        type(error_t), allocatable, intent(out) :: error
        real(wp) :: modulus, modulus_slope

        if (radius <= 0.0_wp) return
        state%radius = radius
        call self%medium%response(self%profile, radius, state%depth, state%force, modulus, modulus_slope, error)
        if (allocated(error)) return
        state%stiffness = 2.0_wp*radius*modulus
        if (self%work_of_adhesion > 0.0_wp) call hang(self, radius, modulus, modulus_slope, state, error)
        if (allocated(error)) return
        if (.not. (ieee_is_finite(state%depth) .and. ieee_is_finite(state%force) .and. ieee_is_finite(state%stiffness))) then
            call raise(error, error_no_convergence, "the state at radius = "//to_text(radius)// &
                       " is beyond the range of floating-point numbers")
        end if
    end subroutine at

    !> Lets the edge hang by dl(a), equation (28) or its energy-consistent form.
    pure subroutine hang(self, radius, modulus, modulus_slope, state, error)
        class(equilibrium_t), intent(in) :: self
        real(wp), intent(in) :: radius, modulus, modulus_slope
        type(contact_state_t), intent(inout) :: state
        type(error_t), allocatable, intent(inout) :: error
        real(wp) :: edge_modulus

        edge_modulus = modulus
        if (self%rule == adhesion_energy .or. (self%rule == adhesion_automatic .and. self%medium%edge_is_exact())) then
            edge_modulus = modulus + radius*modulus_slope
        end if
        if (.not. edge_modulus > 0.0_wp) then
            call raise(error, error_no_convergence, "the contact stiffness of this medium does not grow with the radius at a = "// &
                       to_text(radius)//": the energy balance has no adhesive state there; use the source's rule or another model")
            return
        end if
        state%excess = -sqrt(2.0_wp*pi*radius*self%work_of_adhesion/edge_modulus)
        state%depth = state%depth + state%excess
        state%force = state%force + state%stiffness*state%excess
    end subroutine hang

    !> The radius at coordinate x = ln(a - end radius), in which every shape's laws are close to straight lines.
    pure function radius_of(self, x) result(radius)
        class(equilibrium_t), intent(in) :: self
        real(wp), intent(in) :: x
        real(wp) :: radius

        radius = min(self%profile%end_radius() + exp(x), self%last_radius)
    end function radius_of

    pure function coordinate_of(self, radius) result(x)
        class(equilibrium_t), intent(in) :: self
        real(wp), intent(in) :: radius
        real(wp) :: x

        x = log(max(radius - self%profile%end_radius(), tiny(1.0_wp)))
    end function coordinate_of

    !> How far the contact radius goes: to a vertical wall, or a hair below the profile's end, which may be a vertical tangent that
    !> media with a unit of length of their own must not reach by rounding; far below the end of the number range.
    pure function largest_contact_radius(profile, medium) result(radius)
        class(profile_t), intent(in) :: profile
        class(medium_t), intent(in) :: medium
        real(wp) :: radius

        radius = profile%largest_radius()
        if (.not. profile%has_wall()) radius = radius*(1.0_wp - 4.0_wp*epsilon(radius))
        radius = min(radius, medium%largest_radius(), largest_number)
    end function largest_contact_radius

end module mdrcontact_contact_equilibrium
