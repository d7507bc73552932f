! SPDX-License-Identifier: GPL-3.0-or-later
!> First loading of coated bodies and of other profiles than paraboloids by the overload rule, a model: the elastic contact at the
!> same radius tells by how much it is overloaded, and the paraboloid on a half-space what force and depth are left
!> (theory/plastic.md (7.1)-(7.3)).
module mdrcontact_plastic_overload
    use, intrinsic :: iso_c_binding, only: c_double
    use mdrcontact_body_layers, only: layers_t
    use mdrcontact_codes, only: von_mises
    use mdrcontact_contact, only: contact_t
    use mdrcontact_contact_load, only: contact_load_t
    use mdrcontact_contact_state, only: contact_state_t
    use mdrcontact_error, only: check_made, check_positive, count_text, error_domain, error_invalid, error_t, raise, &
                                raise_at, to_text
    use mdrcontact_inside, only: layers_of
    use mdrcontact_inside_critical, only: largest_of, new_stressed
    use mdrcontact_inside_largest, only: maximum_t, stressed_t
    use mdrcontact_kinds, only: pi, wp
    use mdrcontact_medium_solver, only: check_springs
    use mdrcontact_plastic_radius_search, only: by_depth, by_radius, check_given, find_radius, miss_t
    use mdrcontact_plastic_virgin, only: largest_load, new_virgin, virgin_t
    use mdrcontact_plastic_yielding, only: fall_of_hardness, largest_slope
    implicit none (type, external)
    private
    public :: overload_t, overload_state_t, new_overload

    !> Thicknesses of a film that the contact radius may have, and up to which the rule is as good as stated first.
    real(wp), parameter :: widest = 2.0_wp, narrow = 1.0_wp
    !> Relative errors of force and depth against finite elements (theory/plastic.md (7.3)): half-spaces under a paraboloid and
    !> under others, films up to a = h, and up to 2 h; the depth of other profiles on films up to a = h.
    real(wp), parameter :: errors_of_paraboloid(2) = [2.0e-3_wp, 2.0e-3_wp], errors_of_others(2) = [1.5e-2_wp, 2.0e-2_wp], &
                           errors_of_film(2) = [5.0e-2_wp, 1.0e-2_wp], errors_of_wide(2) = [9.0e-2_wp, 0.14_wp], &
                           error_of_depth = 7.0e-2_wp
    !> Exponents of a profile at the edge, a f'/f, for which the rule was tested: 1 and 2; that of a sphere is higher.
    real(wp), parameter :: exponents(2) = [1.0_wp, 2.05_wp], rounding = 1.0e-9_wp
    !> Relative step by which the elastic mean pressure is followed, and its fall that is a rounding error.
    real(wp), parameter :: step = 1.0e-3_wp, level = 1.0e-7_wp

    !> Yield stresses below an elastic contact. It never changes.
    type :: overload_t
        !> the elastic contact
        type(contact_t) :: contact
        !> Y of the layers, top to bottom, and of what lies below them [modulus]; infinite where it does not yield
        real(wp), allocatable :: yield_stress(:)
        !> thickness of the surface layer [length]; huge() without layers
        real(wp) :: thickness = huge(1.0_wp)
        !> whether a maker has made it
        logical :: is_made = .false.
        type(virgin_t), private :: virgin
    contains
        procedure :: at
        procedure :: states
        procedure, private :: evaluate
        procedure, private :: check_profile
        procedure, private :: check_below
    end type overload_t

    !> A state of first loading, C's struct mdr_overload_state.
    type, bind(C) :: overload_state_t
        !> d, a [length], F [modulus length^2]
        real(c_double) :: depth = 0.0_c_double, radius = 0.0_c_double, force = 0.0_c_double
        !> Lambda of (7.1) [1]
        real(c_double) :: load = 0.0_c_double
        !> parts of the pressure uniform + hertz sqrt(1 - r^2/a^2) whose line load on the axis is S(Lambda) F/(pi a) [modulus]
        real(c_double) :: uniform = 0.0_c_double, hertz = 0.0_c_double
        !> relative errors of force and depth at this radius [1]
        real(c_double) :: force_error = 0.0_c_double, depth_error = 0.0_c_double
    end type overload_state_t

    type, extends(miss_t) :: overload_miss_t
        type(overload_t), pointer :: rule => null()
    contains
        procedure :: depth_and_force
    end type overload_miss_t

contains

    !> The rule for an elastic contact.
    subroutine new_overload(self, contact, yield_stress, error)
        type(overload_t), intent(out) :: self
        !> copied; without adhesion, of a rigid indenter
        type(contact_t), intent(in) :: contact
        !> > 0, of the layers, top to bottom, and of the half-space if there is one: infinite where it does not yield [modulus]
        real(wp), intent(in) :: yield_stress(:)
        type(error_t), allocatable, intent(out) :: error
        type(layers_t) :: layers

        call check_made(error, "contact", contact%is_made)
        if (.not. allocated(error)) call check_contact(contact, error)
        if (.not. allocated(error)) call layers_of(contact%equilibrium, .false., layers, error)
        if (.not. allocated(error)) call check_stresses(yield_stress, layers%bodies(), error)
        if (.not. allocated(error)) call new_virgin(self%virgin, layers%poisson(1), error)
        if (allocated(error)) return
        self%contact = contact
        self%yield_stress = yield_stress
        if (size(layers%thickness) > 0) self%thickness = layers%thickness(1)
        self%is_made = .true.
    end subroutine new_overload

    !> Raises unless the rule holds for a contact: a rigid indenter without a flat end, no adhesion, one body with springs.
    subroutine check_contact(contact, error)
        type(contact_t), intent(in) :: contact
        type(error_t), allocatable, intent(inout) :: error

        if (contact%is_adhesive()) then
            call raise(error, error_invalid, "contact: no rule is known for adhesion during plastic loading. Omit the adhesion")
        else if (contact%equilibrium%medium%is_pair) then
            call raise(error, error_invalid, "contact: the overload rule is one for a rigid indenter. Press it into one body")
        else if (contact%equilibrium%profile%end_radius > 0.0_wp) then
            call raise(error, error_invalid, "contact: the edge of a flat end yields at any load. Use an indenter without a "// &
                       "flat end, or measure force, depth and radius, and create an imprint")
        else
            call check_springs(contact%equilibrium%medium, "an overload rule is", error)
        end if
    end subroutine check_contact

    !> Raises unless there is a yield stress > 0 of each material, a finite one of the first.
    pure subroutine check_stresses(yield_stress, bodies, error)
        real(wp), intent(in) :: yield_stress(:)
        integer, intent(in) :: bodies
        type(error_t), allocatable, intent(inout) :: error
        integer :: i

        if (size(yield_stress) /= bodies) then
            call raise(error, error_invalid, "yield_stress: it has "//count_text(size(yield_stress))//" entries. Give one for "// &
                       "each of the "//count_text(bodies)//" materials, top to bottom")
            return
        end if
        if (bodies > 1 .and. yield_stress(1) > huge(1.0_wp)) then
            call raise(error, error_invalid, " = infinity: below a film that does not yield the body yields, where the force "// &
                       "would have an error of 40 to 80 %. Measure force, depth and radius, and create an imprint", &
                       "yield_stress", 1)
            return
        end if
        call check_positive(error, "yield_stress", yield_stress(1), 1)
        do i = 2, bodies
            if (allocated(error)) return
            if (.not. yield_stress(i) > 0.0_wp) call check_positive(error, "yield_stress", yield_stress(i), i)
        end do
    end subroutine check_stresses

    !> The state at a given radius, depth or force.
    subroutine at(self, given, value, state, error)
        class(overload_t), intent(in), target :: self
        !> radius, depth or force of mdrcontact_codes
        integer, intent(in) :: given
        !> > 0 [length] or [modulus length^2]
        real(wp), intent(in) :: value
        type(overload_state_t), intent(out) :: state
        type(error_t), allocatable, intent(out) :: error
        type(contact_state_t) :: elastic
        real(wp) :: radius

        call check_made(error, "rule", self%is_made)
        call check_given(given, value, error)
        if (allocated(error)) return
        radius = value
        if (given /= by_radius) call search(self, given == by_depth, value, radius, error)
        if (.not. allocated(error)) call self%evaluate(radius, state, elastic, error)
        if (.not. allocated(error)) call self%check_profile(state, elastic, error)
        if (.not. allocated(error)) call self%check_below(state, elastic, error)
        if (.not. allocated(error)) call state_errors(self, state)
    end subroutine at

    !> States at given radii, depths or forces.
    subroutine states(self, given, values, found, error)
        class(overload_t), intent(in), target :: self
        !> see at
        integer, intent(in) :: given
        !> radii [length], depths [length] or forces, > 0
        real(wp), intent(in) :: values(:)
        !> as many
        type(overload_state_t), intent(out) :: found(:)
        type(error_t), allocatable, intent(out) :: error
        integer :: i

        call check_made(error, "rule", self%is_made)
        if (allocated(error)) return
        do i = 1, size(values)
            call self%at(given, values(i), found(i), error)
            if (.not. allocated(error)) cycle
            call raise_at(error, i)
            return
        end do
    end subroutine states

    !> (7.1)-(7.3) at a radius; beyond the largest load as at it.
    subroutine evaluate(self, radius, state, elastic, error)
        class(overload_t), intent(in) :: self
        real(wp), intent(in) :: radius
        type(overload_state_t), intent(out) :: state
        type(contact_state_t), intent(out) :: elastic
        type(error_t), allocatable, intent(out) :: error
        real(wp) :: mean, pressure, depth, unused, deficit, part, height, slope

        call check_made(error, "rule", self%is_made)
        if (allocated(error)) return
        call self%contact%at_radius(radius, elastic, error)
        if (allocated(error)) return
        mean = elastic%force/(pi*radius**2)
        state%load = 0.75_wp*pi*mean/self%yield_stress(1)
        call self%virgin%at(min(state%load, largest_load), pressure, depth, unused, deficit)
        height = self%contact%equilibrium%profile%height(radius)
        slope = self%contact%equilibrium%profile%slope(radius)
        state%radius = radius
        state%force = elastic%force
        state%depth = elastic%depth
        if (state%load > self%virgin%first_yield) then
            part = pressure*self%yield_stress(1)/mean
            state%force = pi*radius**2*self%yield_stress(1)*pressure
            state%depth = height + (elastic%depth - height)*part - 0.5_wp*(1.0_wp + part - 2.0_wp*depth)*radius*slope
        end if
        mean = state%force/(pi*radius**2)
        state%uniform = 0.25_wp*pi*mean*deficit/(0.25_wp*pi - 2.0_wp/3.0_wp)
        state%hertz = 1.5_wp*(mean - state%uniform)
    end subroutine evaluate

    !> The radius of a depth or a force: both grow with it, from that of the elastic contact.
    subroutine search(self, is_depth, wanted, radius, error)
        class(overload_t), intent(in), target :: self
        logical, intent(in) :: is_depth
        real(wp), intent(in) :: wanted
        real(wp), intent(out) :: radius
        type(error_t), allocatable, intent(out) :: error
        type(overload_miss_t) :: miss
        type(contact_state_t) :: elastic

        radius = 0.0_wp
        if (is_depth) then
            call self%contact%at_depth(wanted, elastic, error)
        else
            call self%contact%at_force(wanted, elastic, error)
        end if
        if (allocated(error)) return
        miss%rule => self
        miss%is_depth = is_depth
        miss%wanted = wanted
        associate (last => self%contact%equilibrium%last_radius)
            call find_radius(miss, elastic%radius, last, "indenter and medium are defined up to the radius "//to_text(last), &
                             radius, error)
        end associate
    end subroutine search

    subroutine depth_and_force(self, radius, depth, force, error)
        class(overload_miss_t), intent(in) :: self
        real(wp), intent(in) :: radius
        real(wp), intent(out) :: depth, force
        type(error_t), allocatable, intent(out) :: error
        type(overload_state_t) :: state
        type(contact_state_t) :: elastic

        call self%rule%evaluate(radius, state, elastic, error)
        depth = state%depth
        force = state%force
    end subroutine depth_and_force

    !> Raises where the rule was not tested: for other profiles, larger loads and radii, and where the elastic mean pressure falls.
    subroutine check_profile(self, state, elastic, error)
        class(overload_t), intent(in) :: self
        type(overload_state_t), intent(in) :: state
        type(contact_state_t), intent(in) :: elastic
        type(error_t), allocatable, intent(out) :: error
        type(contact_state_t) :: before
        real(wp) :: exponent, slope

        call check_made(error, "rule", self%is_made)
        if (allocated(error)) return
        if (state%load <= self%virgin%first_yield) return
        slope = self%contact%equilibrium%profile%slope(state%radius)
        exponent = state%radius*slope/self%contact%equilibrium%profile%height(state%radius)
        if (self%contact%equilibrium%profile%is_spherical() .and. slope > largest_slope) then
            call raise(error, error_domain, "radius = "//to_text(state%radius)//": a/R is "//to_text(slope)//" there. It must "// &
                       "be at most 0.3, where the hardness has fallen by 13 %. Reduce the load")
        else if (.not. (exponent >= exponents(1) - rounding .and. exponent <= exponents(2))) then
            call raise(error, error_invalid, "contact: at the radius "//to_text(state%radius)//" the indenter rises as the "// &
                       "radius to the power "//to_text(exponent)//". The overload rule holds from 1, a cone, to 2, a paraboloid")
        else if (state%load > largest_load) then
            call raise(error, error_domain, "radius = "//to_text(state%radius)//": the overload (3 pi/4) p/Y is "// &
                       to_text(state%load)//" there. It must be at most "//to_text(largest_load)//". Reduce the load")
        else if (state%radius > widest*self%thickness) then
            call raise(error, error_domain, "radius = "//to_text(state%radius)//": it must be at most two thicknesses of the "// &
                       "film, "//to_text(widest*self%thickness)//", because the film piles up beyond. Reduce the load")
        end if
        if (allocated(error)) return
        call self%contact%at_radius((1.0_wp - step)*state%radius, before, error)
        if (allocated(error)) return
        if (elastic%force/elastic%radius**2 >= before%force/before%radius**2*(1.0_wp - level)) return
        call raise(error, error_domain, "radius = "//to_text(state%radius)//": the mean pressure of the elastic contact falls "// &
                   "with the radius there, as on stiff films, and the overload rule does not hold. Reduce the load")
    end subroutine check_profile

    !> Raises where the body below the film yields: its von Mises stress in the elastic contact, reduced to the force of the rule.
    subroutine check_below(self, state, elastic, error)
        class(overload_t), intent(in), target :: self
        type(overload_state_t), intent(in) :: state
        type(contact_state_t), intent(in) :: elastic
        type(error_t), allocatable, intent(out) :: error
        type(contact_load_t) :: load
        type(stressed_t) :: body
        type(maximum_t) :: found(1)
        real(wp) :: stress
        integer :: i

        call check_made(error, "rule", self%is_made)
        if (allocated(error)) return
        if (size(self%yield_stress) == 1) return
        if (.not. any(self%yield_stress(2:) <= huge(1.0_wp))) return
        call self%contact%load(elastic, load, error)
        if (.not. allocated(error)) call new_stressed(body, load, .false., 0.0_wp, error)
        do i = 2, size(self%yield_stress)
            if (self%yield_stress(i) > huge(1.0_wp)) cycle
            call largest_of(body, [von_mises], i - 1, .false., found, error)
            if (allocated(error)) return
            stress = found(1)%value*state%force/elastic%force
            if (stress <= self%yield_stress(i)) cycle
            call raise(error, error_domain, "radius = "//to_text(state%radius)//": material "//count_text(i)//" yields under "// &
                       "the film, as its elastic von Mises stress reaches "//to_text(stress)//", above its yield stress "// &
                       to_text(self%yield_stress(i))//". The force would have an error of 40 to 80 %. Measure force, depth "// &
                       "and radius, and create an imprint")
            return
        end do
    end subroutine check_below

    !> Errors against finite elements, 0 before yield.
    subroutine state_errors(self, state)
        class(overload_t), intent(in) :: self
        type(overload_state_t), intent(inout) :: state
        real(wp) :: errors(2)
        logical :: is_round

        if (state%load <= self%virgin%first_yield) return
        is_round = self%contact%equilibrium%profile%is_spherical()
        if (size(self%yield_stress) == 1) then
            errors = merge(errors_of_paraboloid, errors_of_others, is_round)
        else if (state%radius <= narrow*self%thickness) then
            errors = errors_of_film
            if (.not. is_round) errors(2) = error_of_depth
        else
            errors = errors_of_wide
        end if
        if (is_round) errors(1) = errors(1) + fall_of_hardness*self%contact%equilibrium%profile%slope(state%radius)**2
        state%force_error = errors(1)
        state%depth_error = errors(2)
    end subroutine state_errors

end module mdrcontact_plastic_overload
