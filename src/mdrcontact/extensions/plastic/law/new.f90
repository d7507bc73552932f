! SPDX-License-Identifier: GPL-3.0-or-later
!> Laws of contacts that yield, from materials or from points of a curve.
module mdrcontact_plastic_law_new
    use mdrcontact_contact, only: contact_t, new_contact
    use mdrcontact_error, only: check_made, check_not_negative, check_positive, check_within, error_domain, error_invalid, &
                                error_t, raise, to_text
    use mdrcontact_kinds, only: pi, wp
    use mdrcontact_law, only: contact_law_t
    use mdrcontact_law_from_contact, only: law_options_t, new_contact_law
    use mdrcontact_material, only: in_series
    use mdrcontact_medium_homogeneous, only: homogeneous_t, new_homogeneous_from_modulus
    use mdrcontact_plastic_law, only: plastic_law_t
    use mdrcontact_plastic_law_compile, only: compile_loading, default_tolerance, largest_tolerance, scale_law, smallest_tolerance
    use mdrcontact_plastic_loading, only: loaded_t, loading_t, new_paraboloid_loading, new_table_loading, paraboloid_loading_t, &
                                          table_loading_t
    use mdrcontact_plastic_virgin, only: largest_load, new_virgin, virgin_t
    use mdrcontact_plastic_yielding, only: are_equal, yielding_t
    use mdrcontact_profile, only: profile_t
    use mdrcontact_profile_power_law, only: new_paraboloid, power_law_t
    implicit none (type, external)
    private
    public :: plastic_options_t, new_plastic_law, new_plastic_law_from_points, new_plastic_law_from_loading, with_radius, &
              steepest, steep

    !> Largest a/R of the law, and from which on it has an error that is stated.
    real(wp), parameter :: steepest = 0.3_wp, steep = 0.1_wp
    !> With adhesion the curve reaches this part of the depth beyond the largest one, more than polynomials differ from it.
    real(wp), parameter :: beyond = 1.0e-8_wp
    !> Largest factor of with_radius and its inverse: no number of a law leaves the range of numbers.
    real(wp), parameter :: largest_factor = 1.0e30_wp
    !> Most steps of a search.
    integer, parameter :: most_steps = 200

    !> Options of a law.
    type :: plastic_options_t
        !> the other body, which is rigid if it is not allocated; it yields if it has a yield stress
        type(yielding_t), allocatable :: other
        !> gamma >= 0 [modulus length]
        real(wp) :: work_of_adhesion = 0.0_wp
        !> of F and a, relative; 1e-11 to 1e-2
        real(wp) :: tolerance = default_tolerance
    end type plastic_options_t

contains

    !> The law of a paraboloid on a half-space that yields, up to a largest depth.
    subroutine new_plastic_law(self, profile, metal, largest_depth, error, options)
        type(plastic_law_t), intent(out) :: self
        !> a paraboloid
        class(profile_t), intent(in) :: profile
        type(yielding_t), intent(in) :: metal
        !> > 0 [length]
        real(wp), intent(in) :: largest_depth
        type(error_t), allocatable, intent(out) :: error
        type(plastic_options_t), intent(in), optional :: options
        type(plastic_options_t) :: chosen
        type(paraboloid_loading_t) :: loading
        type(virgin_t) :: virgin
        real(wp) :: modulus, own, share

        call check_made(error, "profile", profile%is_made)
        call check_made(error, "metal", metal%is_made)
        if (allocated(error)) return
        if (present(options)) chosen = options
        if (allocated(chosen%other)) call check_made(error, "other", chosen%other%is_made)
        call check_positive(error, "largest_depth", largest_depth)
        if (allocated(error)) return
        if (size(metal%stress) == 0) then
            call raise(error, error_invalid, "metal: it does not yield. Give a yield stress")
            return
        else if (.not. profile%paraboloid_radius > 0.0_wp) then
            call raise(error, error_invalid, "profile: the law is that of a paraboloid. Give the curve of another profile as "// &
                       "points")
            return
        end if
        call new_virgin(virgin, metal%material%poisson, error)
        call find_moduli(metal, chosen, modulus, own, share, error)
        if (allocated(error)) return
        self%radius = profile%paraboloid_radius
        self%first_yield = virgin%first_yield
        call new_paraboloid_loading(loading, self%radius, metal, virgin, modulus, own, share)
        call new_plastic_law_from_loading(self, loading, largest_depth, error, chosen)
    end subroutine new_plastic_law

    !> E* of the contact, that of the body that yields, and its ratio to that of an elastic partner.
    subroutine find_moduli(metal, options, modulus, own, share, error)
        type(yielding_t), intent(in) :: metal
        type(plastic_options_t), intent(in) :: options
        real(wp), intent(out) :: modulus, own, share
        type(error_t), allocatable, intent(inout) :: error

        own = metal%material%contact()
        modulus = own
        share = 0.0_wp
        if (.not. allocated(options%other)) return
        associate (other => options%other)
            modulus = in_series(own, other%material%contact())
            if (size(other%stress) > 0) then
                if (.not. are_equal(metal, other)) call raise(error, error_invalid, "other: two different bodies that both "// &
                                                              "yield are not supported. Give the harder one as elastic")
                own = modulus
            else
                share = own/other%material%contact()
            end if
        end associate
    end subroutine find_moduli

    !> The law of a curve of first loading, elastic before its first depth as a paraboloid on a homogeneous half-space.
    subroutine new_plastic_law_from_loading(self, loading, largest_depth, error, options, contact)
        !> with R and L at first yield, where they are known
        type(plastic_law_t), intent(inout) :: self
        class(loading_t), intent(in) :: loading
        real(wp), intent(in) :: largest_depth
        type(error_t), allocatable, intent(inout) :: error
        type(plastic_options_t), intent(in) :: options
        !> before the first depth; not present: a paraboloid on a half-space
        type(contact_t), intent(in), optional :: contact
        type(loaded_t) :: first, last
        type(contact_law_t) :: elastic
        real(wp) :: line, highest, end_depth

        call check_not_negative(error, "work_of_adhesion", options%work_of_adhesion)
        call check_within(error, "tolerance", options%tolerance, smallest_tolerance, largest_tolerance)
        if (loading%is_coated .and. options%work_of_adhesion > 0.0_wp) then
            call raise(error, error_invalid, " = "//to_text(options%work_of_adhesion)//": laws of coated bodies have no "// &
                       "adhesion. Omit it", "work_of_adhesion")
        end if
        if (allocated(error)) return
        self%tolerance = options%tolerance
        self%modulus = loading%modulus
        self%is_coated = loading%is_coated
        self%work_of_adhesion = options%work_of_adhesion
        line = 2.0_wp*pi*options%work_of_adhesion/loading%modulus
        first = loading%at_depth(loading%first)
        call check_adhesion(self, first, error)
        last = loading%at_depth(loading%last)
        end_depth = last%depth
        if (line > 0.0_wp) end_depth = end_of(last, line)
        if (.not. allocated(error)) call check_range(self, largest_depth, end_depth, last, error)
        if (allocated(error)) return
        highest = without_adhesion(loading, first, largest_depth, line)
        if (present(contact)) then
            call compile_contact(elastic, contact, self%tolerance, largest_depth, error)
        else
            call compile_elastic(elastic, self, loading, first, highest, largest_depth, error)
        end if
        if (allocated(error)) return
        call add_facts(self, loading, elastic, first, highest, largest_depth, line)
        call check_slope(self, largest_depth, error)
        if (.not. allocated(error)) call compile_loading(self, elastic, loading, highest, line, error)
        self%is_made = .not. allocated(error)
    end subroutine new_plastic_law_from_loading

    !> Raises if adhesion alone yields the body: if the contact of Johnson, Kendall and Roberts under no force is larger than that
    !> at first yield (theory/plastic.md (3.6)).
    pure subroutine check_adhesion(law, first, error)
        type(plastic_law_t), intent(in) :: law
        type(loaded_t), intent(in) :: first
        type(error_t), allocatable, intent(inout) :: error
        real(wp) :: most

        ! a_0^3 = 9 pi gamma R^2/(2 E*), R = a^2/d
        most = 2.0_wp*law%modulus*first%depth**2/(9.0_wp*pi*first%radius)
        if (law%work_of_adhesion > most) then
            call raise(error, error_domain, "work_of_adhesion = "//to_text(law%work_of_adhesion)//": adhesion alone yields "// &
                       "the body from "//to_text(most)//" on. Decrease it, or increase the radius or the yield stress")
        end if
    end subroutine check_adhesion

    !> Raises beyond the end of the curve.
    pure subroutine check_range(law, largest_depth, end_depth, last, error)
        type(plastic_law_t), intent(in) :: law
        real(wp), intent(in) :: largest_depth, end_depth
        type(loaded_t), intent(in) :: last
        type(error_t), allocatable, intent(inout) :: error

        if (largest_depth <= end_depth) return
        if (law%first_yield > 0.0_wp) then
            call raise(error, error_domain, "largest_depth = "//to_text(largest_depth)//": the finite elements of the law end "// &
                       "at a E*/(R Y) = "//to_text(largest_load)//", at the depth "//to_text(end_depth)//". Decrease largest_depth")
        else
            call raise(error, error_domain, "largest_depth = "//to_text(largest_depth)//": the curve ends at the depth "// &
                       to_text(end_depth)//", radius "//to_text(last%radius)//". Decrease largest_depth")
        end if
    end subroutine check_range

    !> The depth without adhesion of first loading to a depth with it: d + l(a).
    pure function without_adhesion(loading, first, depth, line) result(found)
        class(loading_t), intent(in) :: loading
        type(loaded_t), intent(in) :: first
        real(wp), intent(in) :: depth, line
        real(wp) :: found
        real(wp) :: low, high, radius
        type(loaded_t) :: state
        integer :: i

        found = depth
        if (.not. line > 0.0_wp) return
        low = depth
        high = loading%last
        do i = 1, most_steps
            found = 0.5_wp*(low + high)
            radius = first%radius*sqrt(found/first%depth)
            if (found > loading%first) then
                state = loading%at_depth(found)
                radius = state%radius
            end if
            if (found - sqrt(line*radius) < depth) then
                low = found
            else
                high = found
            end if
            if (high - low <= epsilon(1.0_wp)*high) exit
        end do
        found = min(high*(1.0_wp + beyond), loading%last)
    end function without_adhesion

    !> The largest depth of a law with adhesion whose curve ends at a state.
    pure function end_of(last, line) result(depth)
        type(loaded_t), intent(in) :: last
        real(wp), intent(in) :: line
        real(wp) :: depth

        depth = last%depth*(1.0_wp - beyond) - sqrt(line*last%radius)
    end function end_of

    !> The elastic law, of the paraboloid and modulus that the curve begins with; up to the largest depth, as that of a contact
    !> that does not yield.
    subroutine compile_elastic(elastic, law, loading, first, highest, largest_depth, error)
        type(contact_law_t), intent(out) :: elastic
        type(plastic_law_t), intent(in) :: law
        class(loading_t), intent(in) :: loading
        type(loaded_t), intent(in) :: first
        real(wp), intent(in) :: highest, largest_depth
        type(error_t), allocatable, intent(out) :: error
        type(power_law_t) :: indenter
        type(homogeneous_t) :: medium
        type(contact_t) :: contact
        type(law_options_t) :: options
        real(wp) :: radius, modulus, reach

        radius = law%radius
        modulus = loading%modulus
        if (.not. radius > 0.0_wp) then
            radius = first%radius**2/first%depth
            modulus = 0.75_wp*first%force/(first%radius*first%depth)
        end if
        reach = largest_depth
        if (highest > largest_depth) reach = max(largest_depth, min(highest, loading%first))
        options%tolerance = law%tolerance
        call new_paraboloid(indenter, radius, error)
        if (.not. allocated(error)) call new_homogeneous_from_modulus(medium, modulus, error)
        if (.not. allocated(error)) call new_contact(contact, indenter, medium, error)
        if (.not. allocated(error)) call new_contact_law(elastic, contact, reach, error, options)
    end subroutine compile_elastic

    subroutine compile_contact(elastic, contact, tolerance, largest_depth, error)
        type(contact_law_t), intent(out) :: elastic
        type(contact_t), intent(in) :: contact
        real(wp), intent(in) :: tolerance, largest_depth
        type(error_t), allocatable, intent(out) :: error
        type(law_options_t) :: options

        options%tolerance = tolerance
        call new_contact_law(elastic, contact, largest_depth, error, options)
    end subroutine compile_contact

    !> The numbers of a law at first yield and at its end.
    pure subroutine add_facts(law, loading, elastic, first, highest, largest_depth, line)
        type(plastic_law_t), intent(inout) :: law
        class(loading_t), intent(in) :: loading
        type(contact_law_t), intent(in) :: elastic
        type(loaded_t), intent(in) :: first
        real(wp), intent(in) :: highest, largest_depth, line
        type(loaded_t) :: last
        real(wp) :: slope

        law%yield_depth = first%depth - sqrt(line*first%radius)
        law%yield_force = first%force - 2.0_wp*law%modulus*first%radius*sqrt(line*first%radius)
        if (highest > loading%first) then
            last = loading%at_depth(highest)
        else
            last%radius = first%radius*sqrt(highest/first%depth)
            call elastic%force_and_slope(highest, last%force, slope)
        end if
        if (law%is_coated) law%modulus = last%modulus
        law%largest_depth = largest_depth
        law%largest_radius = last%radius
        law%largest_force = last%force - 2.0_wp*law%modulus*last%radius*sqrt(line*last%radius)
    end subroutine add_facts

    !> Raises where strains are not small.
    pure subroutine check_slope(law, largest_depth, error)
        type(plastic_law_t), intent(in) :: law
        real(wp), intent(in) :: largest_depth
        type(error_t), allocatable, intent(inout) :: error

        if (.not. law%radius > 0.0_wp .or. law%largest_radius <= steepest*law%radius) return
        call raise(error, error_domain, "largest_depth = "//to_text(largest_depth)//": the contact radius is there "// &
                   to_text(law%largest_radius/law%radius)//" R, and the law holds for small strains, up to "//to_text(steepest)// &
                   " R. Decrease largest_depth")
    end subroutine check_slope

    !> The law of a measured or computed curve of first loading, whose first point is the end of elastic loading.
    subroutine new_plastic_law_from_points(self, depth, force, radius, residual, modulus, error, options)
        type(plastic_law_t), intent(out) :: self
        !> d, F and a, each > 0 and rising; the depth that remains after an unloading from each, as of new_table_loading [length]
        real(wp), intent(in) :: depth(:), force(:), radius(:), residual(:)
        !> E* > 0, with which the contact unloads from each [modulus]
        real(wp), intent(in) :: modulus(:)
        type(error_t), allocatable, intent(out) :: error
        type(plastic_options_t), intent(in), optional :: options
        type(plastic_options_t) :: chosen
        type(table_loading_t) :: loading
        real(wp) :: largest_depth

        if (present(options)) chosen = options
        if (allocated(chosen%other)) then
            call raise(error, error_invalid, "other: the curve is that of both bodies. Omit it")
            return
        end if
        call new_table_loading(loading, depth, force, radius, residual, modulus, error)
        if (allocated(error)) return
        call check_not_negative(error, "work_of_adhesion", chosen%work_of_adhesion)
        if (allocated(error)) return
        largest_depth = loading%last
        if (chosen%work_of_adhesion > 0.0_wp) then
            largest_depth = end_of(loading%at_depth(loading%last), 2.0_wp*pi*chosen%work_of_adhesion/loading%modulus)
        end if
        if (.not. largest_depth > 0.0_wp) then
            call raise(error, error_domain, "work_of_adhesion = "//to_text(chosen%work_of_adhesion)//": the curve ends before "// &
                       "a contact with this adhesion is pressed. Continue the curve")
            return
        end if
        call new_plastic_law_from_loading(self, loading, largest_depth, error, chosen)
    end subroutine new_plastic_law_from_points

    !> The law of the same bodies for a paraboloid of another radius: at the same strains d and a grow as R, F as R^2
    !> (theory/plastic.md (9.3)).
    subroutine with_radius(law, radius, other, error)
        type(plastic_law_t), intent(in) :: law
        !> R > 0 [length]
        real(wp), intent(in) :: radius
        type(plastic_law_t), intent(out) :: other
        type(error_t), allocatable, intent(out) :: error

        call check_made(error, "law", law%is_made)
        if (allocated(error)) return
        call check_positive(error, "radius", radius)
        if (allocated(error)) return
        if (.not. law%radius > 0.0_wp) then
            call raise(error, error_invalid, " = "//to_text(radius)//": the law is not that of a paraboloid. Create a law for "// &
                       "each curve", "radius")
        else if (law%work_of_adhesion > 0.0_wp) then
            call raise(error, error_invalid, " = "//to_text(radius)//": a law with adhesion applies to other radii only at a "// &
                       "work of adhesion proportional to R. Create a law for each radius", "radius")
        else if (radius > largest_factor*law%radius .or. law%radius > largest_factor*radius) then
            call raise(error, error_invalid, " = "//to_text(radius)//": it is too far from the radius of the law, "// &
                       to_text(law%radius), "radius")
        end if
        if (allocated(error)) return
        other = law
        call scale_law(other, radius/law%radius)
        other%radius = radius
    end subroutine with_radius

end module mdrcontact_plastic_law_new
