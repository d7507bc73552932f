! SPDX-License-Identifier: GPL-3.0-or-later
!> A contact whose work of adhesion depends on the speed of its edge: all that a step in time reads, sampled once over the radius.
!>
!> At one contact radius all states differ by the flat punch's: d = d0(a) - e, F = F0(a) - k(a) e, and the energy release rate is
!> G = (e/D(a))^2, D the opening dl(a) at a work of adhesion of 1. What a machine controls, s = w_d d + w_F F, determines e:
!> theory/adhesion.md (1.1)-(1.4).
module mdrcontact_adhesion_rate_contact
    use mdrcontact_object, only: room
    use mdrcontact_contact, only: contact_t
    use mdrcontact_contact_control, only: control_t
    use mdrcontact_contact_curve, only: curve_t, new_curve
    use mdrcontact_contact_equilibrium, only: equilibrium_t
    use mdrcontact_contact_range, only: coordinates_between
    use mdrcontact_contact_state, only: contact_state_t
    use mdrcontact_error, only: check_made, check_not_negative, check_positive, error_domain, error_invalid, error_t, raise, &
                                to_text
    use mdrcontact_adhesion_rate_law, only: rate_law_t
    use mdrcontact_kinds, only: wp
    use mdrcontact_numerics_stiff_step, only: equation_t
    implicit none (type, external)
    private
    public :: rate_contact_t, new_rate_contact, edge_t, edge_equation_t

    !> Relative error of the samples.
    real(wp), parameter :: tolerance = 1.0e-11_wp
    !> The edge is followed down to this part of the radius at which adhesion hands over to elasticity, or of the largest.
    real(wp), parameter :: smallest_part = 1.0e-3_wp
    !> Step in ln a in search of the handover; what is sampled beyond both ends, as stages of a step may lie there.
    real(wp), parameter :: stride = 0.7_wp, margin = 0.7_wp
    integer, parameter :: most_strides = 60

    !> Samples and law. Any number of threads may share it.
    type :: rate_contact_t
        !> whether it was made: set last by what makes it
        logical :: is_made = .false.
        !> d0, F0, k and D over x
        type(curve_t) :: curve
        !> speed of the edge
        type(rate_law_t) :: law
        !> coordinates x = ln(a - end radius) between which there is a contact
        real(wp) :: first = 0.0_wp, last = 0.0_wp
    contains
        procedure :: edge
        procedure :: coordinate_of
    end type rate_contact_t

    !> A contact with its edge at coordinate x under a control: state, energy release rate and how they change.
    type :: edge_t
        real(wp) :: radius = 0.0_wp, depth = 0.0_wp, force = 0.0_wp
        !> G, 0 where the edge is compressed, and dG/dx
        real(wp) :: energy = 0.0_wp, energy_slope = 0.0_wp
        !> partial derivatives of d and F over x, and over s
        real(wp) :: depth_by_x = 0.0_wp, depth_by_s = 0.0_wp, force_by_x = 0.0_wp, force_by_s = 0.0_wp
        !> e, > 0: tension [length]
        real(wp) :: opening = 0.0_wp
    end type edge_t

    !> dx/dt = -v/(a - end radius) while s is linear in time.
    type, extends(equation_t) :: edge_equation_t
        type(rate_contact_t), pointer :: contact => null()
        type(control_t) :: control
        !> s at t = 0, and ds/dt
        real(wp) :: start = 0.0_wp, speed = 0.0_wp
    contains
        procedure :: rate
    end type edge_equation_t

contains

    !> Samples a contact up to a largest radius.
    subroutine new_rate_contact(self, contact, law, largest_radius, error, smallest_radius)
        type(rate_contact_t), intent(out) :: self
        !> its own work of adhesion is not used, its rule for the opening is
        type(contact_t), intent(in) :: contact
        type(rate_law_t), intent(in) :: law
        !> > 0 [length]
        real(wp), intent(in) :: largest_radius
        type(error_t), allocatable, intent(out) :: error
        !> at which a contact begins and ends; default or 0: 1e-3 of the largest, and at most of the radius at which adhesion hands
        !> over to elasticity [length]
        real(wp), intent(in), optional :: smallest_radius
        type(equilibrium_t) :: equilibrium
        real(wp), allocatable :: coordinates(:)
        real(wp) :: smallest, from, to

        smallest = 0.0_wp
        call check_made(error, "contact", contact%is_made)
        call check_made(error, "law", law%is_made)
        if (allocated(error)) return
        if (present(smallest_radius)) smallest = smallest_radius
        call check_positive(error, "largest_radius", largest_radius)
        call check_not_negative(error, "smallest_radius", smallest)
        if (allocated(contact%equilibrium%cohesion)) then
            call raise(error, error_invalid, "cohesive_stress: it excludes a rate-dependent work of adhesion. Omit it")
        end if
        if (allocated(error)) return
        call room(contact%equilibrium%bytes(), error)
        if (allocated(error)) return
        equilibrium = contact%equilibrium
        equilibrium%work_of_adhesion = 1.0_wp
        call check_profile(equilibrium, largest_radius, error)
        if (allocated(error)) return
        self%law = law
        self%last = log(largest_radius)
        if (smallest > 0.0_wp) then
            self%first = log(smallest)
        else
            call find_first(equilibrium, min(law%work, law%closing_work), self%last, self%first, error)
            if (allocated(error)) return
        end if
        if (exp(self%first) < equilibrium%medium%smallest_radius) then
            call raise(error, error_domain, " = "//to_text(exp(self%first))//": the medium is defined from "// &
                       to_text(equilibrium%medium%smallest_radius)//" on", "smallest_radius")
            return
        end if
        from = max(self%first - margin, equilibrium%coordinate_of(equilibrium%medium%smallest_radius))
        to = min(self%last + margin, equilibrium%coordinate_of(equilibrium%last_radius))
        call coordinates_between(equilibrium, from, to, coordinates, error)
        if (.not. allocated(error)) call new_curve(self%curve, equilibrium, coordinates, tolerance, error)
        self%is_made = .not. allocated(error)
    end subroutine new_rate_contact

    !> Raises where the edge cannot move from any radius to any other.
    pure subroutine check_profile(equilibrium, largest_radius, error)
        type(equilibrium_t), intent(in) :: equilibrium
        real(wp), intent(in) :: largest_radius
        type(error_t), allocatable, intent(inout) :: error

        if (equilibrium%profile%end_radius > 0.0_wp) then
            call raise(error, error_invalid, "indenter: it has a flat end of radius "//to_text(equilibrium%profile%end_radius)// &
                       ", which excludes a rate-dependent work of adhesion. Use an indenter without a flat end")
        else if (equilibrium%profile%sharp_radius > 0.0_wp) then
            call raise(error, error_invalid, "indenter: it is an imprint, whose edge rests and so excludes a rate-dependent "// &
                       "work of adhesion. Use a constant work_of_adhesion")
        else if (largest_radius > equilibrium%last_radius) then
            call raise(error, error_domain, " = "//to_text(largest_radius)//": indenter and medium are defined up to "// &
                       to_text(equilibrium%last_radius)//trim(equilibrium%why_it_ends()), "largest_radius")
        end if
    end subroutine check_profile

    !> The coordinate at which a contact ends.
    subroutine find_first(equilibrium, work, last, first, error)
        type(equilibrium_t), intent(in) :: equilibrium
        real(wp), intent(in) :: work, last
        real(wp), intent(out) :: first
        type(error_t), allocatable, intent(out) :: error
        type(contact_state_t) :: parts
        integer :: i

        first = last
        do i = 1, most_strides
            call equilibrium%parts(equilibrium%radius_of(first), parts, error)
            if (allocated(error)) return
            if (parts%depth < -parts%punch_depth*sqrt(work)) exit
            first = first - stride
        end do
        first = first + log(smallest_part)
    end subroutine find_first

    !> x of a contact radius.
    pure function coordinate_of(self, radius) result(x)
        class(rate_contact_t), intent(in) :: self
        !> [length]
        real(wp), intent(in) :: radius
        real(wp) :: x

        x = self%curve%coordinate%of(radius)
    end function coordinate_of

    !> The contact with its edge at x while s is controlled.
    pure function edge(self, control, s, x) result(here)
        class(rate_contact_t), intent(in) :: self
        type(control_t), intent(in) :: control
        !> what is controlled, and ln(a - end radius)
        real(wp), intent(in) :: s, x
        type(edge_t) :: here
        real(wp) :: p(4), dp(4), give, by_x

        call self%curve%parts(x, p, dp)
        here%radius = self%curve%coordinate%radius(x)
        give = control%of(1.0_wp, p(3))
        here%opening = (control%of(p(1), p(2)) - s)/give
        by_x = (control%of(dp(1), dp(2)) - here%opening*control%of(0.0_wp, dp(3)))/give
        here%depth = p(1) - here%opening
        here%force = p(2) - p(3)*here%opening
        here%depth_by_x = dp(1) - by_x
        here%depth_by_s = 1.0_wp/give
        here%force_by_x = dp(2) - dp(3)*here%opening - p(3)*by_x
        here%force_by_s = p(3)/give
        if (.not. here%opening > 0.0_wp) return
        here%energy = (here%opening/p(4))**2
        here%energy_slope = 2.0_wp*here%energy*(by_x/here%opening - dp(4)/p(4))
    end function edge

    pure subroutine rate(self, t, y, f, slope)
        class(edge_equation_t), intent(in) :: self
        real(wp), intent(in) :: t, y
        real(wp), intent(out) :: f, slope
        type(edge_t) :: here
        real(wp) :: v, by_energy

        here = self%contact%edge(self%control, self%start + self%speed*t, y)
        call self%contact%law%speed_at(here%energy, v, by_energy)
        f = -v*exp(-y)
        slope = -f - by_energy*here%energy_slope*exp(-y)
    end subroutine rate

end module mdrcontact_adhesion_rate_contact
