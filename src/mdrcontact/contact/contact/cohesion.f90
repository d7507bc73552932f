! SPDX-License-Identifier: GPL-3.0-or-later
!> Finite-range adhesion: bodies whose surfaces attract each other with a constant cohesive stress sigma_0 up to a gap of
!> gamma/sigma_0 (Dugdale; Maugis, J. Colloid Interface Sci. 150 (1992) 243), at one contact radius or, without contact, one radius
!> of the zone: theory/adhesion.md (2.5), (2.7), (2.10).
module mdrcontact_contact_cohesion
    use mdrcontact_nonfinite, only: is_finite
    use mdrcontact_contact_state, only: contact_state_t
    use mdrcontact_error, only: error_domain, error_invalid, error_no_convergence, error_t, raise, to_text
    use mdrcontact_kinds, only: pi, wp
    use mdrcontact_line_kernel, only: kernel_t
    use mdrcontact_line_zone, only: new_zoned_springs, zone_load_t, zone_state_t, zoned_springs_t
    use mdrcontact_medium_solver, only: check_springs, solver_t
    use mdrcontact_numerics_roots, only: solve_increasing
    use mdrcontact_numerics_scalar_function, only: scalar_function_t
    use mdrcontact_profile, only: profile_t
    implicit none (type, external)
    private
    public :: cohesion_t, new_cohesion, zone_guess_t

    !> The law between the surfaces, and the springs that it loads.
    type :: cohesion_t
        !> sigma_0 > 0 [modulus], gamma/sigma_0 [length]
        real(wp) :: stress = 0.0_wp, range = 0.0_wp
        !> length of the zone in the limit of a small one, pi E0* gamma/(4 sigma_0^2) [length]
        real(wp) :: small_zone = 0.0_wp
        !> about the length of a zone of which nothing is known [length]
        real(wp) :: likely_zone = 0.0_wp
        !> radius of the zone at which attracted bodies touch [length]
        real(wp) :: touching_zone = 0.0_wp
        !> radii at which elasticity equals JKR adhesion and at which that is over [length]: of add_cohesion
        real(wp) :: handover_radius = 0.0_wp, over_radius = 0.0_wp
        !> no zone ends beyond this radius [length]
        real(wp) :: last_radius = 0.0_wp
        !> E0* [modulus], and relative tolerance
        real(wp) :: modulus = 0.0_wp, tolerance = 0.0_wp
        type(kernel_t) :: kernel
    contains
        procedure :: at_radius
        procedure :: apart
        procedure :: load
    end type cohesion_t

    !> Data of a zone before its solution.
    type :: zone_guess_t
        !> c - a [length], and d ln h/d ln(c - a) there [1]
        real(wp) :: length = 0.0_wp, slope = 1.1_wp
        !> dd/d ln(c - a) [length], and dF/d ln(c - a) over E0* [length^2]
        real(wp) :: depth_rate = 0.0_wp, force_rate = 0.0_wp
        !> the slopes are good to some digits: a guess that is nearly right is mended by them
        logical :: is_close = .false.
        !> how many unknowns the springs take (see `unknowns_for`), where the body's constants vary with depth; 0: not known
        real(wp) :: unknowns = 0.0_wp
        !> relative accuracy that is enough, or better that of the medium
        real(wp) :: tolerance = 0.0_wp
    end type zone_guess_t

    !> ln of h(c) over the range, as a function of ln l, l the length of the zone.
    type, extends(scalar_function_t) :: gap_t
        type(zoned_springs_t), pointer :: springs => null()
        real(wp) :: stress = 0.0_wp, range = 0.0_wp
    contains
        procedure :: value => gap_at
    end type gap_t

    !> A zone is searched for in this range of ln l around the first guess.
    real(wp), parameter :: widest = 80.0_wp
    !> Newton's steps from a guess, which end where ln h is so close to its value.
    integer, parameter :: most_steps = 6
    real(wp), parameter :: close_enough = 1.0e-13_wp, widest_step = 1.5_wp
    !> Slopes are taken from steps longer than this, and trusted to be right to as many digits over a step up to this.
    real(wp), parameter :: shortest_secant = 1.0e-5_wp, last_step = 1.0e-9_wp
    !> The same where the body's constants vary with depth: slopes are right to as much as the step is long from which they are, and
    !> the last step may leave so much of a state.
    real(wp), parameter :: shortest_fine_secant = 1.0e-7_wp, negligible_step = 1.0e-12_wp
    !> Where c - a of a state has lost its digits [a].
    real(wp), parameter :: shortest_length = 1.0e-9_wp
    !> The opening next to the contact may be below 0 by so much of the range: rounding.
    real(wp), parameter :: negligible = 1.0e-7_wp

contains

    !> The cohesion of a profile with a medium.
    subroutine new_cohesion(self, profile, medium, last_radius, work, stress, error)
        type(cohesion_t), intent(out) :: self
        class(profile_t), intent(in), target :: profile
        class(solver_t), intent(in) :: medium
        !> where indenter or medium end [length]
        real(wp), intent(in) :: last_radius
        !> gamma > 0 [modulus length], sigma_0 > 0 [modulus]
        real(wp), intent(in) :: work, stress
        type(error_t), allocatable, intent(inout) :: error
        type(contact_state_t) :: state
        type(zone_guess_t) :: guess

        if (profile%has_wall) then
            call raise(error, error_invalid, ": an indenter with a vertical wall has no gap next to the contact. Omit it: the "// &
                       "JKR limit applies", "cohesive_stress")
        end if
        if (profile%sharp_radius > 0.0_wp) then
            call raise(error, error_invalid, ": the profile of an imprint is not defined next to the largest contact. Omit it: "// &
                       "the JKR limit applies", "cohesive_stress")
        end if
        call check_springs(medium, "the load of a cohesive zone (cohesive_stress) is", error)
        if (allocated(error)) return
        self%kernel = medium%springs%kernel
        self%modulus = medium%springs%modulus
        self%tolerance = medium%springs%tolerance
        self%stress = stress
        self%range = work/stress
        self%small_zone = 0.25_wp*pi*self%modulus*self%range/stress
        self%last_radius = last_radius
        self%likely_zone = self%small_zone
        ! a stiff surface hides what is below from short zones only
        if (.not. self%kernel%vanishes .and. self%kernel%one_plus_chi_zero > 1.0_wp) self%likely_zone = &
            min(self%small_zone, max(self%kernel%unit, self%small_zone/self%kernel%one_plus_chi_zero))
        guess%length = self%likely_zone
        call find_zone(self, profile, 0.0_wp, guess, state, error)
        self%touching_zone = state%zone_radius
        self%likely_zone = min(self%likely_zone, self%touching_zone)
    end subroutine new_cohesion

    !> The state in which the contact has this radius; at 0 the bodies just touch.
    subroutine at_radius(self, profile, radius, state, error, guess)
        class(cohesion_t), intent(in) :: self
        class(profile_t), intent(in), target :: profile
        !> a >= 0 [length]
        real(wp), intent(in) :: radius
        type(contact_state_t), intent(out) :: state
        type(error_t), allocatable, intent(inout) :: error
        !> what the zone is expected to be, then what it is
        type(zone_guess_t), intent(inout), optional :: guess
        type(zone_guess_t) :: start

        start%length = self%likely_zone
        if (present(guess)) start = guess
        if (radius > 0.0_wp) then
            call find_zone(self, profile, radius, start, state, error)
        else
            start%length = self%touching_zone
            call self%apart(profile, self%touching_zone, state, error)
        end if
        if (present(guess)) guess = start
    end subroutine at_radius

    !> The state in which the bodies attract each other over a radius c without contact.
    subroutine apart(self, profile, zone_radius, state, error)
        class(cohesion_t), intent(in) :: self
        class(profile_t), intent(in), target :: profile
        !> c, 0 <= c <= that in which they touch [length]
        real(wp), intent(in) :: zone_radius
        type(contact_state_t), intent(out) :: state
        type(error_t), allocatable, intent(inout) :: error
        type(zoned_springs_t) :: springs
        type(zone_state_t) :: zone

        state%depth = -self%range
        state%zone_radius = zone_radius
        if (.not. zone_radius > 0.0_wp) return
        call new_zoned_springs(springs, self%kernel, self%tolerance, profile, 0.0_wp, error)
        if (allocated(error)) return
        call springs%with_zone(zone_radius, 2.0_wp*self%stress/self%modulus, zone, error)
        if (allocated(error)) return
        call check_opening(self, zone, 0.0_wp, error)
        state%depth = zone%depth + (zone%gap - self%range)
        state%punch_depth = state%depth
        state%force = -pi*self%stress*zone_radius**2
    end subroutine apart

    !> The zone at whose end the gap is the range.
    subroutine find_zone(self, profile, radius, guess, state, error)
        class(cohesion_t), intent(in) :: self
        class(profile_t), intent(in), target :: profile
        real(wp), intent(in) :: radius
        type(zone_guess_t), intent(inout) :: guess
        type(contact_state_t), intent(out) :: state
        type(error_t), allocatable, intent(inout) :: error
        type(zoned_springs_t), target :: springs
        type(zone_state_t) :: zone
        logical :: met

        do
            call new_zoned_springs(springs, self%kernel, max(self%tolerance, guess%tolerance), profile, radius, error, &
                                   least=guess%unknowns)
            if (.not. allocated(error)) call close_gap(self, springs, guess, zone, error)
            if (allocated(error)) return
            call springs%check_convergence(zone, met, guess%unknowns, error)
            if (allocated(error)) return
            if (met) exit
            guess%is_close = .true.
        end do
        call check_opening(self, zone, radius, error)
        if (allocated(error)) return
        state%depth = zone%depth
        state%radius = radius
        state%force = self%modulus*zone%force
        state%stiffness = self%modulus*springs%stiffness
        state%punch_depth = zone%depth - springs%depth
        state%zone_radius = radius + guess%length
        if (is_finite(state%depth) .and. is_finite(state%force)) return
        call raise(error, error_no_convergence, "the state at radius = "//to_text(radius)//" is beyond the range of "// &
                   "floating-point numbers")
    end subroutine find_zone

    !> Newton's steps in ln l with the slope that is known, then secants; a bracketed search where they do not arrive.
    subroutine close_gap(self, springs, guess, zone, error)
        class(cohesion_t), intent(in) :: self
        type(zoned_springs_t), intent(in), target :: springs
        type(zone_guess_t), intent(inout) :: guess
        type(zone_state_t), intent(out) :: zone
        type(error_t), allocatable, intent(inout) :: error
        type(zone_state_t) :: before
        real(wp) :: x, y, step, y_before, shortest, secant
        logical :: is_fine
        integer :: i

        is_fine = self%kernel%is_graded()
        shortest = merge(shortest_fine_secant, shortest_secant, is_fine)
        secant = huge(secant)
        x = log(min(guess%length, 0.5_wp*(self%last_radius - springs%a)))
        step = 0.0_wp
        y_before = 0.0_wp
        do i = 1, most_steps
            call springs%with_zone(exp(x), 2.0_wp*self%stress/self%modulus, zone, error)
            if (allocated(error)) return
            y = log(max(zone%gap, tiny(y))/self%range)
            if (abs(step) > shortest .and. (y - y_before)/sign(max(abs(step), tiny(y)), step) > 0.2_wp) then
                guess%slope = (y - y_before)/step
                guess%depth_rate = (zone%depth - before%depth)/step
                guess%force_rate = (zone%force - before%force)/step
                secant = abs(step)
            end if
            if (abs(y) <= close_enough) exit
            y_before = y
            before = zone
            step = -max(-widest_step, min(widest_step, y/guess%slope))
            x = x + step
            if ((guess%is_close .and. max(abs(step), abs(y)) <= last_step) .or. &
                (is_fine .and. max(abs(step), abs(y))*min(secant + abs(step), 1.0_wp) <= negligible_step)) then
                zone%depth = zone%depth + guess%depth_rate*step
                zone%force = zone%force + guess%force_rate*step
                exit
            end if
        end do
        if (i > most_steps .or. exp(x) > self%last_radius - springs%a) then
            call solve_for_length(self, springs, guess%length, error)
            if (.not. allocated(error)) call springs%with_zone(guess%length, 2.0_wp*self%stress/self%modulus, zone, error)
        else
            guess%length = exp(x)
        end if
    end subroutine close_gap

    subroutine solve_for_length(self, springs, length, error)
        class(cohesion_t), intent(in) :: self
        type(zoned_springs_t), intent(in), target :: springs
        !> about the zone's length, then what it is [length]
        real(wp), intent(inout) :: length
        type(error_t), allocatable, intent(inout) :: error
        type(gap_t) :: gap
        type(error_t), allocatable :: failed
        real(wp) :: start, root, largest
        logical :: found

        largest = self%last_radius - springs%a
        start = log(min(length, 0.5_wp*largest))
        gap%springs => springs
        gap%stress = 2.0_wp*self%stress/self%modulus
        gap%range = self%range
        call solve_increasing(gap, start, 1.1_wp, start - widest, min(log(largest), start + widest), root, found, failed)
        length = exp(root)
        if (allocated(failed)) then
            error = failed
        else if (.not. found) then
            call raise(error, error_domain, "the cohesive zone around a contact of radius "//to_text(springs%a)// &
                       " reaches beyond radius "//to_text(self%last_radius)//", where the indenter or the medium ends: a "// &
                       "larger cohesive_stress makes it shorter")
        end if
    end subroutine solve_for_length

    !> The load of a state of this contact, with the springs that carry it.
    subroutine load(self, profile, state, springs, found, error)
        class(cohesion_t), intent(in), target :: self
        class(profile_t), intent(in), target :: profile
        type(contact_state_t), intent(in) :: state
        type(zoned_springs_t), intent(out), target :: springs
        type(zone_load_t), intent(out) :: found
        type(error_t), allocatable, intent(inout) :: error
        type(zone_state_t) :: zone
        type(zone_guess_t) :: guess

        if (self%kernel%is_graded()) then
            call raise(error, error_invalid, "fields: they are not available on a graded body with a cohesive_stress. Use its "// &
                       "states, branches, loops and laws")
            return
        end if
        call new_zoned_springs(springs, self%kernel, self%tolerance, profile, state%radius, error, at_points=.true.)
        if (allocated(error)) return
        guess%length = state%zone_radius - state%radius
        if (guess%length < shortest_length*state%radius) guess%length = self%likely_zone
        if (state%radius > 0.0_wp) call close_gap(self, springs, guess, zone, error)
        if (.not. allocated(error)) call springs%with_zone(guess%length, 2.0_wp*self%stress/self%modulus, zone, error, found)
    end subroutine load

    !> Raises where the surfaces would meet in the zone.
    pure subroutine check_opening(self, zone, radius, error)
        class(cohesion_t), intent(in) :: self
        type(zone_state_t), intent(in) :: zone
        real(wp), intent(in) :: radius
        type(error_t), allocatable, intent(inout) :: error

        if (zone%first_opening >= -negligible*self%range) return
        call raise(error, error_domain, " = "//to_text(self%stress)//": it closes the gap outside a contact of radius "// &
                   to_text(radius)//", so that the contact is not a single area. Use a smaller cohesive_stress", "cohesive_stress")
    end subroutine check_opening

    function gap_at(self, x) result(y)
        class(gap_t), intent(inout) :: self
        real(wp), intent(in) :: x
        real(wp) :: y
        type(zone_state_t) :: zone

        call self%springs%with_zone(exp(x), self%stress, zone, self%error)
        y = log(max(zone%gap, tiny(y))/self%range)
    end function gap_at

end module mdrcontact_contact_cohesion
