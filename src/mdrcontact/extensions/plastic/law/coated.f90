! SPDX-License-Identifier: GPL-3.0-or-later
!> Laws of coated bodies: first loading by the overload rule; unloading as that of the half-space on which the imprint gives back
!> the same work (theory/plastic.md (9.7)).
module mdrcontact_plastic_law_coated
    use mdrcontact_error, only: check_made, check_positive, error_domain, error_invalid, error_t, raise, to_text
    use mdrcontact_kinds, only: pi, wp
    use mdrcontact_law, only: contact_law_t
    use mdrcontact_law_from_contact, only: law_options_t, new_contact_law
    use mdrcontact_medium, only: medium_t
    use mdrcontact_plastic_imprint, only: imprint_t, new_imprint_of_two_terms
    use mdrcontact_plastic_law, only: plastic_law_t
    use mdrcontact_plastic_law_new, only: new_plastic_law_from_loading, plastic_options_t
    use mdrcontact_plastic_loading, only: new_table_loading, table_loading_t
    use mdrcontact_plastic_overload, only: overload_state_t, overload_t
    use mdrcontact_plastic_radius_search, only: by_depth, by_radius
    implicit none (type, external)
    private
    public :: new_plastic_law_from_overload

    !> Points of first loading.
    integer, parameter :: points = 100
    !> Most steps of the search for first yield.
    integer, parameter :: most_steps = 200
    !> Between the moments of s and s^2, (2.3).
    real(wp), parameter :: kappa = 0.25_wp*pi - 2.0_wp/3.0_wp

    !> Points of first loading; what remains after an unloading from each, and E* of the half-space that unloads.
    type :: curve_t
        real(wp), dimension(points) :: depth = 0.0_wp, force = 0.0_wp, radius = 0.0_wp, residual = 0.0_wp, modulus = 0.0_wp
        !> work of the elastic contact at first yield, and what the two terms of pressure lack of it [modulus length^3]
        real(wp) :: work = 0.0_wp, lacking = 0.0_wp
    end type curve_t

contains

    !> The law of a coated body, or of another indenter, up to a largest depth at which the overload rule holds.
    subroutine new_plastic_law_from_overload(self, rule, largest_depth, error, options)
        type(plastic_law_t), intent(out) :: self
        type(overload_t), intent(in), target :: rule
        !> > 0 [length]
        real(wp), intent(in) :: largest_depth
        type(error_t), allocatable, intent(out) :: error
        type(plastic_options_t), intent(in), optional :: options
        type(plastic_options_t) :: chosen
        type(overload_state_t) :: last
        type(table_loading_t) :: loading
        type(curve_t) :: curve
        real(wp) :: first

        call check_made(error, "rule", rule%is_made)
        if (allocated(error)) return
        if (present(options)) chosen = options
        if (allocated(chosen%other)) call raise(error, error_invalid, "other: the contact of the rule has both bodies. Omit it")
        call check_positive(error, "largest_depth", largest_depth)
        if (.not. allocated(error)) call rule%at(by_depth, largest_depth, last, error)
        if (allocated(error)) return
        if (.not. last%force_error > 0.0_wp) then
            call raise(error, error_domain, " = "//to_text(largest_depth)//": nothing yields there. Increase it, or use an "// &
                       "elastic law", "largest_depth")
            return
        end if
        call find_yield(rule, last%radius, first, error)
        last%depth = largest_depth ! to which the search has come close
        if (.not. allocated(error)) call find_curve(rule, first, last, chosen%tolerance, curve, error)
        if (.not. allocated(error)) call new_table_loading(loading, curve%depth, curve%force, curve%radius, curve%residual, &
                                                           curve%modulus, error)
        if (.not. allocated(error)) call new_plastic_law_from_loading(self, loading, largest_depth, error, chosen, rule%contact)
    end subroutine new_plastic_law_from_overload

    !> The largest contact radius at which the rule is still elastic.
    subroutine find_yield(rule, largest, radius, error)
        type(overload_t), intent(in), target :: rule
        real(wp), intent(in) :: largest
        real(wp), intent(out) :: radius
        type(error_t), allocatable, intent(inout) :: error
        type(overload_state_t) :: state
        real(wp) :: high, middle
        integer :: i

        radius = 0.0_wp
        high = largest
        do i = 1, most_steps
            middle = 0.5_wp*(radius + high)
            if (allocated(error) .or. .not. (middle > radius .and. middle < high)) exit
            call rule%at(by_radius, middle, state, error)
            if (state%force_error > 0.0_wp) then
                high = middle
            else
                radius = middle
            end if
        end do
        if (allocated(error) .or. radius > 0.0_wp) return
        call raise(error, error_domain, "rule: its contact yields from initial contact on, as under a cone, and has no elastic "// &
                   "range. Give its points to the law of a table")
    end subroutine find_yield

    !> Points between first yield and the end, closer at yield.
    subroutine find_curve(rule, first, last, tolerance, curve, error)
        type(overload_t), intent(in), target :: rule
        real(wp), intent(in) :: first
        type(overload_state_t), intent(in) :: last
        real(wp), intent(in) :: tolerance
        type(curve_t), intent(out) :: curve
        type(error_t), allocatable, intent(inout) :: error
        type(overload_state_t) :: state
        type(medium_t) :: medium
        type(contact_law_t) :: elastic
        type(law_options_t) :: options
        integer :: i

        medium%solver = rule%contact%equilibrium%medium
        call rule%at(by_radius, first, state, error)
        options%tolerance = tolerance
        if (.not. allocated(error)) call new_contact_law(elastic, rule%contact, state%depth, error, options)
        if (allocated(error)) return
        curve%work = elastic%energy(state%depth)
        do i = 1, points
            if (i < points) then
                call rule%at(by_radius, first + (last%radius - first)*((i - 1.0_wp)/(points - 1))**2, state, error)
            else
                state = last
            end if
            if (.not. allocated(error)) call add_point(medium, state, curve, i, error)
            if (allocated(error)) return
        end do
    end subroutine find_curve

    !> The point of a state.
    subroutine add_point(medium, state, curve, i, error)
        type(medium_t), intent(in) :: medium
        type(overload_state_t), intent(in) :: state
        type(curve_t), intent(inout) :: curve
        integer, intent(in) :: i
        type(error_t), allocatable, intent(inout) :: error
        type(imprint_t) :: imprint
        real(wp) :: recovery, stored, part

        call new_imprint_of_two_terms(imprint, medium, state%radius, state%uniform, state%hertz, state%depth, error)
        if (allocated(error)) return
        ! at first yield unloading gives all work back
        if (i == 1) curve%lacking = curve%work - imprint%recovered_work
        recovery = imprint%depth - imprint%residual_depth
        stored = imprint%recovered_work + curve%lacking
        part = uniform_part(stored/(state%force*recovery))
        if (part < 0.0_wp) then
            part = 0.0_wp
            recovery = 2.5_wp*stored/state%force
        end if
        recovery = min(recovery, state%depth)
        curve%depth(i) = state%depth
        curve%force(i) = state%force
        curve%radius(i) = state%radius
        curve%residual(i) = state%depth - recovery
        curve%modulus(i) = 0.5_wp*state%force/(state%radius*recovery*(2.0_wp/3.0_wp + kappa*part))
    end subroutine add_point

    !> A2/(A1 + A2) of the two terms that give back the work `ratio` F (d - residual depth) on a half-space: a root of (2.8)
    !> over (2.3).
    pure function uniform_part(ratio) result(part)
        real(wp), intent(in) :: ratio
        real(wp) :: part
        real(wp), parameter :: second = 8.0_wp/15.0_wp - 0.375_wp*pi + 2.0_wp/3.0_wp
        real(wp) :: first, constant

        first = 0.375_wp*pi - 16.0_wp/15.0_wp - 2.0_wp*kappa*ratio
        constant = 8.0_wp/15.0_wp - 4.0_wp/3.0_wp*ratio
        part = -2.0_wp*constant/(first + sign(sqrt(max(first**2 - 4.0_wp*second*constant, 0.0_wp)), first))
    end function uniform_part

end module mdrcontact_plastic_law_coated
