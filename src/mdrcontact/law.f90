! SPDX-License-Identifier: GPL-3.0-or-later
!> A compiled contact law: F(d), a(d), k(d) and d(F), a(F), k(F) of one contact over a range of depths, for the price of a short
!> polynomial.
!>
!> It is made once from any contact and verified against it. Evaluating it allocates nothing and locks nothing; any number
!> of threads may share it. Unlike the contact it is made from, the law has an answer for bodies that are apart: force,
!> radius, stiffness and slope are 0 below first touch, and with adhesion below pull-off (on loading: below d = 0).
module mdrcontact_law
    use, intrinsic :: ieee_arithmetic, only: ieee_is_finite, ieee_quiet_nan, ieee_value
    use, intrinsic :: iso_c_binding, only: c_double
    use mdrcontact_batch, only: check_threads
    use mdrcontact_contact_branch, only: stable_segment_t
    use mdrcontact_contact_control, only: depth_control, force_control
    use mdrcontact_contact_curve, only: curve_t, new_curve
    use mdrcontact_contact_range, only: coordinate_before, coordinate_beyond, coordinates_between
    use mdrcontact_contact, only: check_branch, contact_t, on_loading, on_unloading
    use mdrcontact_contact_state, only: contact_state_t
    use mdrcontact_error, only: check_finite, check_positive, check_same_size, check_within, count_text, error_domain, &
                                error_invalid, error_no_convergence, error_t, error_unreachable, raise, raise_at, to_text
    use mdrcontact_kinds, only: wp
    use mdrcontact_law_compile, only: close_table, compile_straight, open_table
    use mdrcontact_law_evaluate, only: count_within, energy_at, point_at, point_in, run_points, wanted_t
    use mdrcontact_law_interval, only: interval_place, place_t, polynomial, polynomial_with_slope
    use mdrcontact_law_segments, only: compile_segments, fold_margin
    use mdrcontact_law_table, only: below_range, interval_for, interval_in, law_table_t, no_contact, scale_table, segment_for, &
                                    values_in
    use mdrcontact_law_verify, only: largest_error
    use mdrcontact_medium, only: medium_t
    use mdrcontact_profile_power_law, only: power_law_t
    implicit none (type, external)
    private
    public :: contact_law_t, new_contact_law, law_options_t, law_point_t
    public :: check_depths
    public :: default_law_tolerance

    !> Relative tolerance of a law for which none is asked for.
    real(wp), parameter :: default_law_tolerance = 1.0e-9_wp
    real(wp), parameter :: smallest_tolerance = 1.0e-12_wp, largest_tolerance = 1.0e-2_wp
    !> Decades of depth below the largest, where none are asked for.
    real(wp), parameter :: default_decades = 1.0e-4_wp
    !> Shares of the tolerance: of the samples, and of the polynomials through them.
    real(wp), parameter :: sample_share = 0.1_wp, fit_share = 0.3_wp
    !> Noise of the contact's states with which it is worth to go on to verification.
    real(wp), parameter :: largest_noise = 1.0e-6_wp
    !> Of two, beyond which with_radius would come near over- or underflow.
    integer, parameter :: largest_power = 500
    !> What a law can be asked for.
    type :: law_options_t
        !> Without adhesion: the depth down to which the tolerance holds [length]; 0: 1e-4 of the largest. Nearer to first touch
        !> the law follows a power of d. With adhesion the law begins at pull-off.
        real(wp) :: smallest_depth = 0.0_wp
        !> of F, a and k, relative; 1e-12 to 1e-2. With adhesion relative to |F| + |d dF/dd|: at pull-off the slope is infinite.
        real(wp) :: tolerance = default_law_tolerance
        !> whether the law answers beyond its largest depth and force too, along the tangent there, and says so in `beyond`: one
        !> hard collision then does not end a run. Else it refuses
        logical :: continue_beyond = .false.
        !> the problem the law is made from, in words
        character(len=:), allocatable :: description
    end type law_options_t

    !> A state of the law; struct mdr_law_point of the header.
    type, bind(C) :: law_point_t
        !> d [length]
        real(c_double) :: depth = 0.0_c_double
        !> F [modulus length^2]
        real(c_double) :: force = 0.0_c_double
        !> dF/dd along the branch [modulus length]; infinite slopes at pull-off are cut off at a large number
        real(c_double) :: slope = 0.0_c_double
        !> a [length]
        real(c_double) :: radius = 0.0_c_double
        !> k = 2 a E_eff(a), the stiffness at constant radius [modulus length]; without adhesion it equals the slope
        real(c_double) :: stiffness = 0.0_c_double
        !> U = int F dd along the branch from first touch on, without adhesion the elastic energy; with adhesion from pull-off on
        !> [modulus length^3]
        real(c_double) :: energy = 0.0_c_double
        !> how far d lies beyond the largest depth, where the law is continued along its tangent: the numbers are then no longer
        !> those of the contact; 0 within the range [length]
        real(c_double) :: beyond = 0.0_c_double
    end type law_point_t

    !> A compiled law. It never changes.
    type :: contact_law_t
        !> F, a, k from the depth, and d, a, k from the force; `lowest` and `highest` are the ends of the range
        type(law_table_t) :: by_depth, by_force
        !> asked for, and the largest error found on verification
        real(wp) :: tolerance = 0.0_wp, error = 0.0_wp
        !> contact states computed to make and to verify it
        integer :: solutions = 0
        !> R of the paraboloid it was made for [length]; 0 for any other indenter
        real(wp) :: radius = 0.0_wp
        !> the problem in words, as given in the options
        character(len=:), allocatable :: description
    contains
        procedure :: at_depth
        procedure :: at_force
        procedure :: follow
        procedure :: force
        procedure :: force_and_slope
        procedure :: energy
        procedure :: from_depths
        procedure :: from_forces
        procedure :: with_radius
    end type contact_law_t

contains

    !> Compiles a contact up to `largest_depth`. With `tangential` the law is that of a shift: in place of the depth it has
    !> S = int dF/k_t, in place of the stiffness k_t; `error` is then left to the caller.
    subroutine new_contact_law(self, contact, largest_depth, error, options, tangential)
        type(contact_law_t), intent(out) :: self
        type(contact_t), intent(in) :: contact
        !> > 0 [length]
        real(wp), intent(in) :: largest_depth
        type(error_t), allocatable, intent(out) :: error
        type(law_options_t), intent(in), optional :: options
        !> without adhesion: its modulus is G_t(a) = k_t/(2 a)
        class(medium_t), intent(in), optional :: tangential
        type(law_options_t) :: chosen
        real(wp) :: end_radius, smallest, largest
        real(wp), allocatable :: breaks(:)

        if (present(options)) chosen = options
        if (.not. allocated(chosen%description)) chosen%description = ""
        call check_positive(error, "largest_depth", largest_depth)
        call check_within(error, "tolerance", chosen%tolerance, smallest_tolerance, largest_tolerance)
        if (chosen%smallest_depth == 0.0_wp) chosen%smallest_depth = default_decades*largest_depth
        call check_positive(error, "smallest_depth", chosen%smallest_depth)
        if (allocated(error)) return
        if (chosen%smallest_depth > 0.5_wp*largest_depth) then
            call raise(error, error_invalid, "smallest_depth = "//to_text(chosen%smallest_depth)//" is not allowed: it must be "// &
                       "at most half the largest depth, "//to_text(largest_depth))
            return
        end if
        self%tolerance = chosen%tolerance
        self%description = chosen%description
        select type (profile => contact%equilibrium%profile)
        type is (power_law_t)
            self%radius = profile%paraboloid_radius()
        end select
        call contact%radius_range(end_radius, smallest, largest, breaks)
        call open_table(self%by_depth, .true., contact%is_adhesive(), end_radius)
        call open_table(self%by_force, .false., contact%is_adhesive(), end_radius)
        if (smallest >= largest*(1.0_wp - 1.0e-12_wp)) then
            call compile_punch(self, contact, largest_depth, chosen%smallest_depth, error, tangential)
        else
            call compile_branch(self, contact, end_radius, smallest, largest_depth, chosen%smallest_depth, error, tangential)
        end if
        if (allocated(error)) return
        call close_table(self%by_depth)
        call close_table(self%by_force)
        self%by_depth%continued = chosen%continue_beyond
        self%by_force%continued = chosen%continue_beyond
    end subroutine new_contact_law

    !> The law of the same bodies for a paraboloid of another radius R. At a given contact radius depth and force are proportional
    !> to 1/R on any linear body, and the stiffness is the same: F(d; R) = (R0/R) F0(d R/R0), up to R0/R times the largest depth.
    subroutine with_radius(self, radius, law, error)
        class(contact_law_t), intent(in) :: self
        !> R > 0 [length]
        real(wp), intent(in) :: radius
        type(contact_law_t), intent(out) :: law
        type(error_t), allocatable, intent(out) :: error
        integer :: power

        call check_positive(error, "radius", radius)
        if (allocated(error)) return
        if (self%by_depth%adhesive) then
            call raise(error, error_invalid, " = "//to_text(radius)//" is not allowed: with adhesion a law holds for "// &
                       "other radii only where work of adhesion times R^2 stays the same; make a law for each radius", "radius")
        else if (.not. self%radius > 0.0_wp) then
            call raise(error, error_invalid, " = "//to_text(radius)//" is not allowed: the law was not made for a "// &
                       "paraboloid, or comes from a file that does not hold its radius; make a law for each indenter", "radius")
        else
            power = exponent(self%radius) - exponent(radius)
            if (min(power, power + exponent(min(self%by_depth%lowest, self%by_force%lowest))) < -largest_power .or. &
                max(power, power + exponent(max(self%by_depth%highest, self%by_force%highest))) > largest_power) then
                call raise(error, error_invalid, " = "//to_text(radius)//" is not allowed: it is too far from the law's radius "// &
                           to_text(self%radius), "radius")
            end if
        end if
        if (allocated(error)) return
        law = self
        law%radius = radius
        law%description = self%description//"; with_radius("//to_text(radius)//")"
        call scale_table(law%by_depth, self%radius/radius)
        call scale_table(law%by_force, self%radius/radius)
    end subroutine with_radius

    !> A flat punch: one state determines the law.
    subroutine compile_punch(self, contact, largest_depth, smallest_depth, error, tangential)
        type(contact_law_t), intent(inout) :: self
        type(contact_t), intent(in) :: contact
        real(wp), intent(in) :: largest_depth, smallest_depth
        type(error_t), allocatable, intent(out) :: error
        class(medium_t), intent(in), optional :: tangential
        type(contact_state_t) :: state, pull_off
        real(wp) :: low, modulus(1), stiffness, share

        call contact%at_depth(largest_depth, state, error)
        low = smallest_depth
        if (contact%is_adhesive() .and. .not. allocated(error)) then
            call contact%pull_off(depth_control, pull_off, error)
            low = pull_off%depth
        end if
        if (allocated(error)) return
        self%solutions = 1
        stiffness = state%stiffness
        if (present(tangential)) then
            call tangential%modulus([state%radius], modulus, error)
            if (allocated(error)) return
            stiffness = 2.0_wp*state%radius*modulus(1)
        end if
        share = state%stiffness/stiffness
        call compile_straight(self%by_depth, state%radius, stiffness, share*low, share*largest_depth)
        call compile_straight(self%by_force, state%radius, stiffness, low*state%stiffness, largest_depth*state%stiffness)
    end subroutine compile_punch

    subroutine compile_branch(self, contact, end_radius, smallest, largest_depth, smallest_depth, error, tangential)
        type(contact_law_t), intent(inout) :: self
        type(contact_t), intent(in) :: contact
        real(wp), intent(in) :: end_radius, smallest, largest_depth, smallest_depth
        type(error_t), allocatable, intent(out) :: error
        class(medium_t), intent(in), optional :: tangential
        type(curve_t) :: curve
        type(stable_segment_t), allocatable :: of_depth(:), of_force(:)
        real(wp), allocatable :: coordinates(:)
        real(wp) :: first, last, found
        integer :: i

        call coordinate_beyond(contact%equilibrium, largest_depth, largest_depth, last, found, self%solutions, error)
        if (allocated(error)) return
        if (found < largest_depth) then
            call raise(error, error_unreachable, "largest_depth = "//to_text(largest_depth)//" cannot be reached: indenter or "// &
                       "medium end at depth "//to_text(found)//trim(contact%equilibrium%why_it_ends()))
            return
        end if
        if (contact%is_adhesive()) then
            call contact%stable_segments(depth_control, of_depth, error)
            if (.not. allocated(error)) call contact%stable_segments(force_control, of_force, error)
            if (allocated(error)) return
            of_depth = pack(of_depth, of_depth%first < last)
            of_force = pack(of_force, of_force%first < last)
            first = min(minval(of_depth%first), minval(of_force%first)) - fold_margin
            if (end_radius > 0.0_wp .or. size(of_depth) == 0 .or. size(of_force) == 0) then
                call raise(error, error_invalid, "this adhesive contact cannot be compiled: its branch does not begin at an "// &
                           "extremum of depth and force within the range")
                return
            end if
            if (smallest > end_radius) first = max(first, log(smallest - end_radius) + 8.0_wp*epsilon(1.0_wp))
        else
            allocate (of_depth(1), of_force(1))
            call coordinate_before(contact%equilibrium, smallest_depth, first, found, self%solutions, error)
            if (allocated(error)) return
            if (found > smallest_depth) then
                call raise(error, error_unreachable, "smallest_depth = "//to_text(smallest_depth)//" cannot be reached: the "// &
                           "medium begins at depth "//to_text(found))
                return
            end if
            of_depth%first = first
            of_depth%last = last
            of_force = of_depth
        end if
        coordinates = coordinates_between(contact%equilibrium, first, last)
        ! what the samples miss, verification finds
        call new_curve(curve, contact%equilibrium, coordinates, sample_share*self%tolerance, error, largest_noise)
        if (.not. allocated(error) .and. present(tangential)) call curve%shear(tangential, error)
        if (allocated(error)) return
        self%solutions = self%solutions + curve%solutions
        coordinates = coordinates(2:size(coordinates) - 1)
        call compile_segments(self%by_depth, curve, of_depth, coordinates, fit_share*self%tolerance, error)
        if (allocated(error)) return
        do i = 2, size(of_depth)
            self%by_depth%segments(i)%energy = curve%work_between(of_depth(1)%first, of_depth(i)%first)
        end do
        if (.not. allocated(error)) then
            call compile_segments(self%by_force, curve, of_force, coordinates, fit_share*self%tolerance, error)
        end if
        if (allocated(error) .or. present(tangential)) return
        call largest_error(self%by_depth, self%by_force, contact, curve, of_depth, of_force, self%error, self%solutions, error)
        if (allocated(error)) return
        if (.not. self%error <= self%tolerance) then
            call raise(error, error_no_convergence, "the compiled law misses the tolerance "//to_text(self%tolerance)// &
                       ": its error is "//to_text(self%error)//"; the contact itself may not be computed more accurately")
        end if
    end subroutine compile_branch

    !> The state at depth d; all but d is 0 where the bodies are apart.
    pure subroutine at_depth(self, depth, point, error, branch)
        class(contact_law_t), intent(in) :: self
        !> at most the largest depth, unless the law continues beyond; any value below [length]
        real(wp), intent(in) :: depth
        type(law_point_t), intent(out) :: point
        type(error_t), allocatable, intent(out) :: error
        !> on_loading or on_unloading (default)
        integer, intent(in), optional :: branch
        integer :: way, interval

        way = on_unloading
        if (present(branch)) way = branch
        call check_branch(error, way)
        call check_below(error, "depth", depth, self%by_depth)
        if (allocated(error)) return
        interval = interval_for(self%by_depth, way, min(depth, self%by_depth%highest))
        point%depth = depth
        call point_in(self%by_depth, interval, depth, point%force, point%slope, point%radius, point%stiffness)
        call add_energy(self, interval, point)
    end subroutine at_depth

    !> The state under force F: there is one at every force down to 0, with adhesion down to pull-off on unloading.
    pure subroutine at_force(self, force, point, error, branch)
        class(contact_law_t), intent(in) :: self
        !> [modulus length^2]
        real(wp), intent(in) :: force
        type(law_point_t), intent(out) :: point
        type(error_t), allocatable, intent(out) :: error
        !> on_loading or on_unloading (default)
        integer, intent(in), optional :: branch
        real(wp) :: compliance
        integer :: way

        way = on_unloading
        if (present(branch)) way = branch
        call check_branch(error, way)
        call check_force(error, self, way, force)
        if (allocated(error)) return
        point%force = force
        call point_at(self%by_force, way, force, point%depth, compliance, point%radius, point%stiffness)
        if (compliance > 0.0_wp) point%slope = 1.0_wp/compliance
        call add_energy(self, interval_at_radius(self%by_depth, point), point)
    end subroutine at_force

    !> Energy, and how far beyond the range, of a state on an interval of the depths.
    pure subroutine add_energy(self, interval, point)
        type(contact_law_t), intent(in) :: self
        integer, intent(in) :: interval
        type(law_point_t), intent(inout) :: point

        point%energy = energy_at(self%by_depth, interval, point%depth)
        point%beyond = max(point%depth - self%by_depth%highest, 0.0_wp)
    end subroutine add_energy

    !> The interval of the depths on which a state lies: of several at its depth the one with its contact radius.
    pure function interval_at_radius(table, point) result(interval)
        type(law_table_t), intent(in) :: table
        type(law_point_t), intent(in) :: point
        integer :: interval
        real(wp) :: unused(2), depth, radius, stiffness, nearest
        integer :: i, candidate

        ! rounding may put a state at an end of the range a little outside
        depth = min(max(point%depth, table%lowest), table%highest)
        interval = no_contact
        if (.not. table%adhesive) interval = interval_for(table, on_unloading, min(point%depth, table%highest))
        if (.not. table%adhesive .or. point%radius <= 0.0_wp) return
        nearest = huge(1.0_wp)
        do i = 1, size(table%segments)
            if (depth < table%segments(i)%lowest .or. depth > table%segments(i)%highest) cycle
            candidate = interval_in(table, i, depth)
            call values_in(table, candidate, depth, unused(1), unused(2), radius, stiffness)
            if (abs(radius - point%radius) > nearest) cycle
            nearest = abs(radius - point%radius)
            interval = candidate
        end do
    end function interval_at_radius

    !> F at depth d, for inner loops and arrays: as at_depth, but NaN where that has an error.
    elemental function force(self, depth, branch) result(value)
        class(contact_law_t), intent(in) :: self
        !> [length]
        real(wp), intent(in) :: depth
        !> on_loading or on_unloading (default)
        integer, intent(in), optional :: branch
        real(wp) :: value
        type(place_t) :: place
        real(wp) :: unused

        if (depth >= self%by_depth%direct%lowest .and. depth <= self%by_depth%direct%highest) then
            place = interval_place(self%by_depth%direct, depth)
            value = polynomial(self%by_depth%other(place%panel)%c, place%t)
        else
            call force_elsewhere(self, depth, branch, value, unused)
        end if
    end function force

    !> F and dF/dd at depth d, for inner loops and arrays: as at_depth, but NaN where that has an error.
    elemental subroutine force_and_slope(self, depth, force, slope, branch)
        class(contact_law_t), intent(in) :: self
        !> [length]
        real(wp), intent(in) :: depth
        !> [modulus length^2], [modulus length]
        real(wp), intent(out) :: force, slope
        !> on_loading or on_unloading (default)
        integer, intent(in), optional :: branch
        type(place_t) :: place

        if (depth >= self%by_depth%direct%lowest .and. depth <= self%by_depth%direct%highest) then
            place = interval_place(self%by_depth%direct, depth)
            call polynomial_with_slope(self%by_depth%other(place%panel)%c, place%t, force, slope)
            slope = self%by_depth%direct%scale*slope
        else
            call force_elsewhere(self, depth, branch, force, slope)
        end if
    end subroutine force_and_slope

    !> U = int F dd at depth d, as in law_point_t; NaN where at_depth has an error.
    elemental function energy(self, depth, branch) result(value)
        class(contact_law_t), intent(in) :: self
        !> [length]
        real(wp), intent(in) :: depth
        !> on_loading or on_unloading (default)
        integer, intent(in), optional :: branch
        !> [modulus length^3]
        real(wp) :: value
        type(law_point_t) :: point
        type(error_t), allocatable :: error

        call self%at_depth(depth, point, error, branch)
        value = point%energy
        if (allocated(error)) value = ieee_value(value, ieee_quiet_nan)
    end function energy

    pure subroutine force_elsewhere(self, depth, branch, force, slope)
        class(contact_law_t), intent(in) :: self
        real(wp), intent(in) :: depth
        integer, intent(in), optional :: branch
        real(wp), intent(out) :: force, slope
        real(wp) :: radius, stiffness
        type(error_t), allocatable :: error
        integer :: way

        way = on_unloading
        if (present(branch)) way = branch
        call check_branch(error, way)
        call check_below(error, "depth", depth, self%by_depth)
        if (allocated(error)) then
            force = ieee_value(force, ieee_quiet_nan)
            slope = force
        else
            call point_at(self%by_depth, way, depth, force, slope, radius, stiffness)
        end if
    end subroutine force_elsewhere

    !> The states at many depths: at_depth for arrays. Where one is refused the error is that of the first, and nothing is written.
    subroutine from_depths(self, depths, error, force, slope, radius, stiffness, branch, threads)
        class(contact_law_t), intent(in) :: self
        !> [length]
        real(wp), intent(in), contiguous :: depths(:)
        type(error_t), allocatable, intent(out) :: error
        !> same size as depths: F [modulus length^2], dF/dd [modulus length], a [length], k [modulus length]; what is not given is
        !> not computed
        real(wp), intent(inout), optional, target, contiguous :: force(:), slope(:), radius(:), stiffness(:)
        !> on_loading or on_unloading (default)
        integer, intent(in), optional :: branch
        !> at least 1 (default), or 0 for as many as OpenMP offers; few points stay on one
        integer, intent(in), optional :: threads
        type(wanted_t) :: wanted
        integer :: way, team
        logical :: all_direct

        if (present(force)) wanted%other => force
        if (present(slope)) wanted%slope => slope
        if (present(radius)) wanted%radius => radius
        if (present(stiffness)) wanted%stiffness => stiffness
        call check_call(error, size(depths), wanted, branch, threads, way, team)
        all_direct = count_within(depths, self%by_depth%direct%lowest, self%by_depth%direct%highest) == size(depths)
        if (.not. all_direct) call check_depths(error, self, depths)
        if (allocated(error)) return
        call run_points(self%by_depth, way, depths, all_direct, team, wanted)
    end subroutine from_depths

    !> The states under many forces: at_force for arrays, as from_depths.
    subroutine from_forces(self, forces, error, depth, compliance, radius, stiffness, branch, threads)
        class(contact_law_t), intent(in) :: self
        !> [modulus length^2]
        real(wp), intent(in), contiguous :: forces(:)
        type(error_t), allocatable, intent(out) :: error
        !> same size as forces: d [length], dd/dF [1/(modulus length)], a [length], k [modulus length]; what is not given is not
        !> computed
        real(wp), intent(inout), optional, target, contiguous :: depth(:), compliance(:), radius(:), stiffness(:)
        !> on_loading or on_unloading (default)
        integer, intent(in), optional :: branch
        !> at least 1 (default), or 0 for as many as OpenMP offers; few points stay on one
        integer, intent(in), optional :: threads
        type(wanted_t) :: wanted
        integer :: way, team, i
        logical :: all_direct

        if (present(depth)) wanted%other => depth
        if (present(compliance)) wanted%slope => compliance
        if (present(radius)) wanted%radius => radius
        if (present(stiffness)) wanted%stiffness => stiffness
        call check_call(error, size(forces), wanted, branch, threads, way, team)
        if (allocated(error)) return
        all_direct = count_within(forces, self%by_force%direct%lowest, self%by_force%direct%highest) == size(forces)
        if (.not. all_direct) then
            do i = 1, size(forces)
                call check_force(error, self, way, forces(i))
                if (.not. allocated(error)) cycle
                call raise_at(error, i)
                return
            end do
        end if
        call run_points(self%by_force, way, forces, all_direct, team, wanted)
    end subroutine from_forces

    !> Raises unless the law has a state at each depth.
    pure subroutine check_depths(error, self, depths)
        type(error_t), allocatable, intent(inout) :: error
        class(contact_law_t), intent(in) :: self
        real(wp), intent(in) :: depths(:)
        integer :: i

        if (allocated(error)) return
        do i = 1, size(depths)
            call check_below(error, "depth", depths(i), self%by_depth)
            if (.not. allocated(error)) cycle
            call raise_at(error, i)
            return
        end do
    end subroutine check_depths

    !> What from_depths and from_forces take beside the points.
    subroutine check_call(error, n, wanted, branch, threads, way, team)
        type(error_t), allocatable, intent(inout) :: error
        integer, intent(in) :: n
        type(wanted_t), intent(in) :: wanted
        integer, intent(in), optional :: branch, threads
        integer, intent(out) :: way, team

        way = on_unloading
        if (present(branch)) way = branch
        team = 1
        if (present(threads)) team = threads
        call check_branch(error, way)
        call check_threads(error, team)
        call check_size(error, n, wanted%other)
        call check_size(error, n, wanted%slope)
        call check_size(error, n, wanted%radius)
        call check_size(error, n, wanted%stiffness)
    end subroutine check_call

    subroutine check_size(error, n, array)
        type(error_t), allocatable, intent(inout) :: error
        integer, intent(in) :: n
        real(wp), pointer, intent(in) :: array(:)

        if (associated(array)) call check_same_size(error, n, size(array))
    end subroutine check_size

    !> The lowest force under which a branch has a state.
    pure function lowest_force(self, branch) result(force)
        class(contact_law_t), intent(in) :: self
        integer, intent(in) :: branch
        real(wp) :: force

        force = 0.0_wp
        if (self%by_force%adhesive .and. branch == on_unloading) force = self%by_force%lowest
    end function lowest_force

    !> The state at depth d of a contact with a history: it stays on its segment until that ends, and then falls open or onto the
    !> nearest one. Open bodies come into contact at d >= 0.
    pure subroutine follow(self, depth, segment, point, error)
        class(contact_law_t), intent(in) :: self
        !> at most the largest depth, unless the law continues beyond; any value below [length]
        real(wp), intent(in) :: depth
        !> where the contact is: 0 for open at the beginning, then what the last call returned
        integer, intent(inout) :: segment
        type(law_point_t), intent(out) :: point
        type(error_t), allocatable, intent(out) :: error
        real(wp) :: within
        integer :: interval

        if (segment < 0 .or. segment > size(self%by_depth%segments)) then
            call raise(error, error_invalid, "segment = "//count_text(segment)//" is not allowed: it must be 0 (open) "// &
                       "or what the last call returned")
        end if
        call check_below(error, "depth", depth, self%by_depth)
        if (allocated(error)) return
        within = min(depth, self%by_depth%highest)
        call move_segment(self%by_depth, within, segment)
        point%depth = depth
        if (segment == 0) return
        interval = below_range
        if (within >= self%by_depth%lowest) interval = interval_in(self%by_depth, segment, within)
        call point_in(self%by_depth, interval, depth, point%force, point%slope, point%radius, point%stiffness)
        call add_energy(self, interval, point)
    end subroutine follow

    pure subroutine move_segment(table, depth, segment)
        type(law_table_t), intent(in) :: table
        real(wp), intent(in) :: depth
        integer, intent(inout) :: segment

        if (.not. table%adhesive) then
            segment = merge(1, 0, depth > 0.0_wp)
        else if (segment == 0) then
            segment = segment_for(table, on_loading, depth)
        else if (depth > table%segments(segment)%highest) then
            do segment = segment + 1, size(table%segments) - 1
                if (depth >= table%segments(segment)%lowest .and. depth <= table%segments(segment)%highest) exit
            end do
        else if (depth < table%segments(segment)%lowest) then
            do segment = segment - 1, 1, -1
                if (depth >= table%segments(segment)%lowest .and. depth <= table%segments(segment)%highest) exit
            end do
        end if
    end subroutine move_segment

    !> Raises unless s is finite and, unless the table is continued, at most the end of the compiled range.
    pure subroutine check_below(error, name, s, table)
        type(error_t), allocatable, intent(inout) :: error
        character(len=*), intent(in) :: name
        real(wp), intent(in) :: s
        type(law_table_t), intent(in) :: table

        ! a comparison with NaN would signal an invalid operation
        if (.not. ieee_is_finite(s)) then
            call check_finite(error, name, s)
        else if (s > table%highest .and. .not. table%continued) then
            call raise(error, error_domain, " = "//to_text(s)//" is not allowed: the law was compiled up to "// &
                       to_text(table%highest), name)
        end if
    end subroutine check_below

    !> Raises unless a branch has a state under the force.
    pure subroutine check_force(error, self, branch, force)
        type(error_t), allocatable, intent(inout) :: error
        class(contact_law_t), intent(in) :: self
        integer, intent(in) :: branch
        real(wp), intent(in) :: force

        call check_below(error, "force", force, self%by_force)
        if (.not. allocated(error) .and. force < lowest_force(self, branch)) then
            call raise(error, error_unreachable, " = "//to_text(force)//" cannot be reached: no contact carries less than "// &
                       to_text(lowest_force(self, branch)), "force")
        end if
    end subroutine check_force

end module mdrcontact_law
