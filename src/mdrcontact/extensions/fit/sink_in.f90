! SPDX-License-Identifier: GPL-3.0-or-later
!> Sink-in of the surface at the edge of a contact: h_s = d - f(a) = sink(a) F/k.
!>
!> At one contact radius d, f and F of an indenter f = c r^n grow proportionally to c, so that sink depends on radius and body
!> alone. On a half-space it is Oliver and Pharr's epsilon: 2 (pi - 2)/pi of a cone, 0.75 of a paraboloid, 1 of a punch. An indent
!> that has yielded unloads as if a smooth indenter c r^n lay in it (Pharr, Bolshakov, J. Mater. Res. 17 (2002) 2660); a film lets
!> that indenter sink in more or less deeply than a half-space does, and the exact contact determines the depth.
module mdrcontact_fit_sink_in
    use mdrcontact_contact_curve, only: curve_point_t, curve_t, new_curve
    use mdrcontact_contact_equilibrium, only: equilibrium_t, new_equilibrium
    use mdrcontact_contact_range, only: coordinates_between
    use mdrcontact_error, only: error_domain, error_t, raise, to_text
    use mdrcontact_kinds, only: pi, wp
    use mdrcontact_medium_solver, only: solver_t
    use mdrcontact_profile, only: profile_t
    use mdrcontact_profile_power_law, only: new_power_law, power_law_t
    implicit none (type, external)
    private
    public :: sink_in_t, new_sink_in, half_space_factor

    !> Relative, of depth, force and stiffness.
    real(wp), parameter :: tolerance = 1.0e-9_wp
    !> Between these exponents lie the indenters whose epsilon has an indenter.
    real(wp), parameter :: sharpest = 1.0_wp, flattest = 20.0_wp
    integer, parameter :: halvings = 60
    !> No curve is shorter, in ln a.
    real(wp), parameter :: shortest = 0.01_wp

    !> sink(a) and E_eff(a) of a body over a range of radii.
    type :: sink_in_t
        private
        type(equilibrium_t) :: equilibrium
        type(curve_t) :: curve
        !> sink = share*(that of the equilibrium's indenter) + rest: beyond the sharpest and the flattest indenter epsilon's effect
        !> continues proportionally, to 0 and to the punch
        real(wp) :: share = 1.0_wp, rest = 0.0_wp
        !> the radii between which it is known [length]
        real(wp), public :: smallest = 0.0_wp, largest = 0.0_wp
    contains
        procedure :: at
    end type sink_in_t

contains

    !> The sink-in of an indenter, or of the one that epsilon represents.
    subroutine new_sink_in(self, medium, smallest, largest, error, epsilon_factor, indenter)
        type(sink_in_t), intent(out) :: self
        class(solver_t), intent(in) :: medium
        !> contact radii, 0 < smallest < largest; cut where medium and indenter end [length]
        real(wp), intent(in) :: smallest, largest
        type(error_t), allocatable, intent(out) :: error
        !> h_s/(F/k) on a half-space, which represents an indenter c r^n [1]; either this or the indenter
        real(wp), intent(in), optional :: epsilon_factor
        class(profile_t), intent(in), optional :: indenter
        type(power_law_t) :: power
        real(wp), allocatable :: coordinates(:)
        real(wp) :: exponent

        if (present(indenter)) then
            call new_equilibrium(self%equilibrium, indenter, medium, error)
        else
            exponent = exponent_of(epsilon_factor)
            if (epsilon_factor < half_space_factor(sharpest)) then
                self%share = epsilon_factor/half_space_factor(sharpest)
            else if (epsilon_factor > half_space_factor(flattest)) then
                self%share = (1.0_wp - epsilon_factor)/(1.0_wp - half_space_factor(flattest))
                self%rest = 1.0_wp - self%share
            end if
            call new_power_law(power, exponent, largest**(1.0_wp - exponent), error)
            if (.not. allocated(error)) call new_equilibrium(self%equilibrium, power, medium, error)
        end if
        if (allocated(error)) return
        self%smallest = max(smallest, medium%smallest_radius*(1.0_wp + 16.0_wp*epsilon(1.0_wp)))
        self%largest = min(largest, self%equilibrium%last_radius)
        if (.not. self%smallest < self%largest) then
            call raise(error, error_domain, "the contact radii "//to_text(smallest)//" to "//to_text(largest)// &
                       " are outside the range of the medium"//trim(medium%why_it_ends))
            return
        end if
        associate (first => self%equilibrium%coordinate_of(self%smallest), last => self%equilibrium%coordinate_of(self%largest))
            call coordinates_between(self%equilibrium, min(first, last - shortest), last, coordinates, error)
        end associate
        if (.not. allocated(error)) call new_curve(self%curve, self%equilibrium, coordinates, tolerance, error)
    end subroutine new_sink_in

    !> sink and E_eff at a radius in the range.
    subroutine at(self, radius, sink, modulus)
        class(sink_in_t), intent(in) :: self
        !> [length]
        real(wp), intent(in) :: radius
        !> [1]
        real(wp), intent(out) :: sink
        !> [modulus]
        real(wp), intent(out) :: modulus
        type(curve_point_t) :: point

        point = self%curve%at(self%equilibrium%coordinate_of(radius))
        sink = (point%depth - self%equilibrium%profile%height(radius))*point%stiffness/point%force
        sink = self%rest + self%share*sink
        modulus = point%stiffness/(2.0_wp*radius)
    end subroutine at

    !> h_s/(F/k) of an indenter c r^n on a half-space.
    pure function half_space_factor(exponent) result(factor)
        real(wp), intent(in) :: exponent
        real(wp) :: factor
        real(wp) :: kappa

        kappa = 0.5_wp*sqrt(pi)*exponent*exp(log_gamma(0.5_wp*exponent) - log_gamma(0.5_wp*(exponent + 1.0_wp)))
        factor = (1.0_wp - 1.0_wp/kappa)*(1.0_wp + 1.0_wp/exponent)
    end function half_space_factor

    !> The exponent whose half-space factor is epsilon, or the end of the range nearest to it.
    pure function exponent_of(factor) result(exponent)
        real(wp), intent(in) :: factor
        real(wp) :: exponent
        real(wp) :: low, high
        integer :: i

        low = sharpest
        high = flattest
        do i = 1, halvings
            exponent = 0.5_wp*(low + high)
            if (half_space_factor(exponent) < factor) then
                low = exponent
            else
                high = exponent
            end if
        end do
    end function exponent_of

end module mdrcontact_fit_sink_in
