! SPDX-License-Identifier: GPL-3.0-or-later
!> From a contact to its compiled law: the range, the samples of the branch, the tables, and the verification.
module mdrcontact_law_from_contact
    use mdrcontact_contact_adhesive_branch, only: stable_segment_t
    use mdrcontact_contact_control, only: depth_control, force_control
    use mdrcontact_contact_curve, only: curve_t, new_curve
    use mdrcontact_contact_equilibrium, only: equilibrium_t
    use mdrcontact_contact_range, only: coordinate_before, coordinate_beyond, coordinates_between
    use mdrcontact_contact, only: contact_t
    use mdrcontact_contact_samples, only: samples_t
    use mdrcontact_contact_state, only: contact_state_t
    use mdrcontact_contact_zone_curve, only: coordinate_of, new_zone_curve, zone_curve_t
    use mdrcontact_error, only: check_made, check_positive, check_within, error_invalid, error_no_convergence, error_t, &
                                error_unreachable, explain, raise, to_text
    use mdrcontact_kinds, only: wp
    use mdrcontact_law, only: contact_law_t
    use mdrcontact_law_compile, only: close_table, compile_straight, open_table
    use mdrcontact_law_reach, only: reach_unloading
    use mdrcontact_law_segments, only: compile_segments, fold_margin, move_to_folds
    use mdrcontact_law_verify, only: add_conductance_error, largest_error
    use mdrcontact_medium_solver, only: solver_t
    use mdrcontact_numerics_scalar_function, only: scalar_function_t
    implicit none (type, external)
    private
    public :: new_contact_law, law_options_t, default_law_tolerance

    !> Relative tolerance of a law for which none is given.
    real(wp), parameter :: default_law_tolerance = 1.0e-9_wp
    real(wp), parameter :: smallest_tolerance = 1.0e-12_wp, largest_tolerance = 1.0e-2_wp
    !> Decades of depth below the largest, where none are given.
    real(wp), parameter :: default_decades = 1.0e-4_wp
    !> Largest start of a law, relative to its largest depth.
    real(wp), parameter :: largest_part_below = 0.5_wp
    !> Shares of the tolerance: of the samples, and of the polynomials through them.
    real(wp), parameter :: sample_share = 0.1_wp, sample_share_of_zone = 1.0e-2_wp, fit_share = 0.3_wp
    !> Noise of the contact's states with which it is worth to continue with verification.
    real(wp), parameter :: largest_noise = 1.0e-6_wp

    !> A law ends at this part of the depth at which a contact jumps, at most: the radius has a root's singularity there.
    real(wp), parameter :: largest_part = 0.99_wp
    !> By so much in the coordinate a law continues beyond its largest depth, for rounding.
    real(wp), parameter :: beyond = 1.0e-6_wp

    !> The stable parts of a sampled branch.
    type :: branch_t
        !> by ascending coordinate
        type(stable_segment_t), allocatable :: of_depth(:), of_force(:)
        !> whether they end at an extremum
        logical, allocatable :: of_depth_fold(:), of_force_fold(:)
        !> coordinate from which energies count
        real(wp) :: start = 0.0_wp
    end type branch_t

    !> The options of a law.
    type :: law_options_t
        !> Without adhesion: the depth down to which the tolerance holds [length]; 0: 1e-4 of the largest, or where the medium
        !> begins. Nearer to initial contact the law continues value and slope. With adhesion the law begins at pull-off.
        real(wp) :: smallest_depth = 0.0_wp
        !> whether no smallest depth is given: the law's own one gives way to the medium's
        logical, private :: begins_with_medium = .false.
        !> of F, a and k, relative; 1e-12 to 1e-2. With adhesion relative to |F| + |d dF/dd|: at pull-off the slope is infinite.
        real(wp) :: tolerance = default_law_tolerance
        !> whether the law continues along its tangent beyond its largest depth and force, with `beyond` > 0, so that one hard
        !> collision does not end a run. Otherwise it raises an error there
        logical :: continue_beyond = .false.
        !> G(a), for a law that conducts: a function of the caller, which lives as long as the options
        class(scalar_function_t), pointer :: conductance => null()
        !> the problem the law is made from, as text
        character(len=:), allocatable :: description
    end type law_options_t

contains

    !> Compiles a contact up to `largest_depth`. With `tangential` the law is that of a shift: instead of the depth it has S = int
    !> dF/k_t, instead of the stiffness k_t; `error` is then left to the caller.
    subroutine new_contact_law(self, contact, largest_depth, error, options, tangential)
        type(contact_law_t), intent(out) :: self
        type(contact_t), intent(in) :: contact
        !> > 0 [length]
        real(wp), intent(in) :: largest_depth
        type(error_t), allocatable, intent(out) :: error
        type(law_options_t), intent(in), optional :: options
        !> without adhesion: its modulus is G_t(a) = k_t/(2 a)
        class(solver_t), intent(in), optional :: tangential
        type(law_options_t) :: chosen
        real(wp) :: end_radius, smallest, largest
        real(wp), allocatable :: breaks(:)

        call check_made(error, "contact", contact%is_made)
        if (present(tangential)) call check_made(error, "tangential", tangential%is_made)
        if (present(options)) chosen = options
        if (present(tangential)) nullify (chosen%conductance)
        if (.not. allocated(chosen%description)) chosen%description = ""
        call check_positive(error, "largest_depth", largest_depth)
        call check_within(error, "tolerance", chosen%tolerance, smallest_tolerance, largest_tolerance)
        chosen%begins_with_medium = chosen%smallest_depth == 0.0_wp
        if (chosen%begins_with_medium) chosen%smallest_depth = default_decades*largest_depth
        call check_positive(error, "smallest_depth", chosen%smallest_depth)
        if (allocated(error)) return
        if (chosen%smallest_depth > largest_part_below*largest_depth) then
            call raise(error, error_invalid, "smallest_depth = "//to_text(chosen%smallest_depth)// &
                       ": it must be at most half the largest depth, "//to_text(largest_depth))
            return
        end if
        self%tolerance = chosen%tolerance
        self%description = chosen%description
        self%radius = contact%equilibrium%profile%paraboloid_radius
        call contact%radius_range(end_radius, smallest, largest, breaks, error)
        if (allocated(error)) return
        call open_table(self%by_depth, .true., contact%is_adhesive(), end_radius)
        call open_table(self%by_force, .false., contact%is_adhesive(), end_radius)
        if (allocated(contact%equilibrium%cohesion)) then
            call compile_zone(self, contact, largest_depth, chosen, error)
        else if (smallest >= largest*(1.0_wp - 1.0e-12_wp)) then
            call compile_punch(self, contact, largest_depth, chosen, error, tangential)
        else
            call compile_branch(self, contact, end_radius, smallest, largest_depth, chosen, error, tangential)
        end if
        if (allocated(error)) return
        call close_table(self%by_depth)
        call close_table(self%by_force)
        self%by_force%roots = self%by_depth%roots
        self%by_depth%continued = chosen%continue_beyond
        self%by_force%continued = chosen%continue_beyond
        self%is_made = .not. allocated(error)
    end subroutine new_contact_law

    !> A flat punch: one state determines the law.
    subroutine compile_punch(self, contact, largest_depth, options, error, tangential)
        type(contact_law_t), intent(inout) :: self
        type(contact_t), intent(in) :: contact
        real(wp), intent(in) :: largest_depth
        type(law_options_t), intent(in) :: options
        type(error_t), allocatable, intent(out) :: error
        class(solver_t), intent(in), optional :: tangential
        type(contact_state_t) :: state, pull_off
        real(wp) :: low, modulus(1), stiffness, share

        call contact%at_depth(largest_depth, state, error)
        low = options%smallest_depth
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
        ! if it does not exist the null pointer is an absent argument
        call compile_straight(self%by_depth, state%radius, stiffness, share*low, share*largest_depth, options%conductance)
        if (associated(options%conductance)) then
            if (allocated(options%conductance%error)) call move_alloc(options%conductance%error, error)
            if (allocated(error)) return
        end if
        call compile_straight(self%by_force, state%radius, stiffness, low*state%stiffness, largest_depth*state%stiffness)
    end subroutine compile_punch

    subroutine compile_branch(self, contact, end_radius, smallest, largest_depth, options, error, tangential)
        type(contact_law_t), intent(inout) :: self
        type(contact_t), intent(in) :: contact
        real(wp), intent(in) :: end_radius, smallest, largest_depth
        type(law_options_t), intent(in) :: options
        type(error_t), allocatable, intent(out) :: error
        class(solver_t), intent(in), optional :: tangential
        type(curve_t) :: curve
        type(stable_segment_t), allocatable :: of_depth(:), of_force(:)
        real(wp), allocatable :: coordinates(:)
        logical, allocatable :: of_depth_fold(:), of_force_fold(:)
        type(branch_t) :: branch
        real(wp) :: first, last, found, smallest_depth
        logical :: jumps

        smallest_depth = options%smallest_depth
        jumps = size(contact%equilibrium%unstable_ranges) > 0
        found = largest_depth
        if (jumps) then
            call ends_before_fall(contact, smallest_depth, largest_depth, first, last, error)
        else
            call coordinate_beyond(contact%equilibrium, largest_depth, largest_depth, last, found, self%solutions, error)
        end if
        if (allocated(error)) return
        if (found < largest_depth .and. contact%is_adhesive() .and. contact%equilibrium%ends_sharply()) then
            call raise(error, error_unreachable, "largest_depth = "//to_text(largest_depth)//": with adhesion the edge of an "// &
                       "imprint rests from depth "//to_text(found)//" on, where its law ends. Use the contact itself beyond")
            return
        end if
        if (found < largest_depth) then
            call raise(error, error_unreachable, "largest_depth = "//to_text(largest_depth)// &
                       ": indenter or medium end at depth "//to_text(found)//trim(contact%equilibrium%why_it_ends()))
            return
        end if
        if (contact%is_adhesive()) then
            call contact%stable_segments(depth_control, of_depth, error)
            if (.not. allocated(error)) call contact%stable_segments(force_control, of_force, error)
            call reach_unloading(contact, self%tolerance, last, self%solutions, error)
            if (allocated(error)) return
            of_depth = pack(of_depth, of_depth%first < last)
            of_force = pack(of_force, of_force%first < last)
            first = min(minval(of_depth%first), minval(of_force%first)) - fold_margin
            if (end_radius > 0.0_wp .or. size(of_depth) == 0 .or. size(of_force) == 0) then
                call raise(error, error_invalid, "contact: its branch does not begin at an extremum of depth and force within "// &
                           "the range, so it cannot be compiled")
                return
            end if
            if (smallest > end_radius) first = max(first, log(smallest - end_radius) + 8.0_wp*epsilon(1.0_wp))
        else
            allocate (of_depth(1), of_force(1))
            found = smallest_depth
            if (.not. jumps) call coordinate_before(contact%equilibrium, smallest_depth, first, found, self%solutions, error)
            if (allocated(error)) return
            if (found > smallest_depth) call check_beginning(options, smallest_depth, largest_depth, found, error)
            if (allocated(error)) return
            of_depth%first = first
            of_depth%last = last
            of_force = of_depth
        end if
        call coordinates_between(contact%equilibrium, first, last, coordinates, error)
        if (allocated(error)) return
        ! what the samples miss, verification finds
        call new_curve(curve, contact%equilibrium, coordinates, sample_share*self%tolerance, error, largest_noise)
        if (.not. allocated(error) .and. present(tangential)) call curve%shear(tangential, error)
        if (allocated(error)) return
        self%solutions = self%solutions + curve%solutions
        coordinates = coordinates(2:size(coordinates) - 1)
        allocate (of_depth_fold(size(of_depth)), of_force_fold(size(of_force)), source=.false.)
        if (contact%is_adhesive()) then
            call move_to_folds(self%by_depth, curve, of_depth, of_depth_fold, error)
            if (.not. allocated(error)) call move_to_folds(self%by_force, curve, of_force, of_force_fold, error)
            if (allocated(error)) return
        end if
        branch = branch_t(of_depth, of_force, of_depth_fold, of_force_fold, of_depth(1)%first)
        call compile_tables(self, contact%equilibrium, curve, branch, coordinates, options, present(tangential), error)
    end subroutine compile_branch

    !> Raises unless a law may begin where the medium does.
    pure subroutine check_beginning(options, smallest_depth, largest_depth, beginning, error)
        type(law_options_t), intent(in) :: options
        real(wp), intent(in) :: smallest_depth, largest_depth
        !> depth of the smallest contact of the medium, > smallest_depth [length]
        real(wp), intent(in) :: beginning
        type(error_t), allocatable, intent(inout) :: error

        if (.not. options%begins_with_medium) then
            call raise(error, error_unreachable, "smallest_depth = "//to_text(smallest_depth)//": the medium begins at depth "// &
                       to_text(beginning)//". Omit smallest_depth to begin there")
        else if (beginning > largest_part_below*largest_depth) then
            call raise(error, error_unreachable, "largest_depth = "//to_text(largest_depth)//": the medium begins at depth "// &
                       to_text(beginning)//". Compile up to at least twice that depth")
        end if
    end subroutine check_beginning

    !> A contact with a cohesive zone: the law begins where the bodies attract each other, with or without contact.
    subroutine compile_zone(self, contact, largest_depth, options, error)
        type(contact_law_t), intent(inout) :: self
        type(contact_t), intent(in) :: contact
        real(wp), intent(in) :: largest_depth
        type(law_options_t), intent(in) :: options
        type(error_t), allocatable, intent(out) :: error
        type(zone_curve_t) :: curve
        type(branch_t) :: branch
        type(contact_state_t) :: largest
        real(wp) :: last

        call contact%at_depth(largest_depth, largest, error)
        if (allocated(error)) then
            call explain(error, "largest_depth: ", "")
            return
        end if
        associate (equilibrium => contact%equilibrium)
            last = min(coordinate_of(equilibrium, largest%radius, largest%zone_radius) + beyond, &
                       coordinate_of(equilibrium, equilibrium%last_radius, 0.0_wp))
            call reach_unloading(contact, self%tolerance, last, self%solutions, error)
            if (allocated(error)) return
            call new_zone_curve(curve, equilibrium, last, error, sample_share_of_zone*self%tolerance)
        end associate
        if (allocated(error)) return
        self%solutions = self%solutions + curve%solutions
        self%by_depth%end_radius = 0.0_wp
        self%by_force%end_radius = 0.0_wp
        self%by_depth%first_attraction = contact%first_attraction(depth_control)
        self%by_force%first_attraction = contact%first_attraction(force_control)
        call curve%segments(depth_control, branch%of_depth, error)
        call curve%segments(force_control, branch%of_force, error)
        if (allocated(error)) return
        branch%of_depth_fold = branch%of_depth%last < curve%edges(size(curve%edges))
        branch%of_force_fold = branch%of_force%last < curve%edges(size(curve%edges))
        branch%start = curve%edges(1)
        if (size(branch%of_depth) == 0 .or. size(branch%of_force) == 0) then
            call raise(error, error_invalid, "largest_depth = "//to_text(largest_depth)// &
                       ": up to this depth no state is stable under force control")
            return
        end if
        call compile_tables(self, contact%equilibrium, curve, branch, curve%breaks(), options, .false., error)
    end subroutine compile_zone

    !> The tables of both controls from the samples, and their verification.
    subroutine compile_tables(self, equilibrium, curve, branch, breaks, options, is_tangential, error)
        type(contact_law_t), intent(inout) :: self
        type(equilibrium_t), intent(in) :: equilibrium
        class(samples_t), intent(in) :: curve
        type(branch_t), intent(in) :: branch
        !> coordinates where indenter or medium are not analytic
        real(wp), intent(in) :: breaks(:)
        type(law_options_t), intent(in) :: options
        logical, intent(in) :: is_tangential
        type(error_t), allocatable, intent(out) :: error
        integer :: i

        associate (tolerance => fit_share*self%tolerance)
            ! if it does not exist the null pointer is an absent argument
            call compile_segments(self%by_depth, curve, branch%of_depth, branch%of_depth_fold, breaks, tolerance, error, &
                                  options%conductance)
            if (.not. allocated(error)) call compile_segments(self%by_force, curve, branch%of_force, branch%of_force_fold, breaks, &
                                                              tolerance, error)
        end associate
        if (allocated(error)) return
        do i = 1, size(branch%of_depth)
            self%by_depth%segments(i)%energy = curve%work_between(branch%start, branch%of_depth(i)%first)
        end do
        if (is_tangential) return
        call largest_error(self%by_depth, self%by_force, curve, equilibrium, branch%of_depth, branch%of_force, self%error, &
                           self%solutions, error)
        if (allocated(error)) return
        if (associated(options%conductance)) then
            call add_conductance_error(self%by_depth, curve, equilibrium, branch%of_depth, options%conductance, self%error, &
                                       error)
            if (allocated(error)) return
        end if
        if (.not. self%error <= self%tolerance) then
            call raise(error, error_no_convergence, "the compiled law misses the tolerance "//to_text(self%tolerance)// &
                       ": its error is "//to_text(self%error)//". The contact itself may not be more accurate")
        end if
    end subroutine compile_tables

    !> The ends of a law of a contact whose depth and force fall over some radii: it jumps there, as no law without adhesion does.
    subroutine ends_before_fall(contact, smallest_depth, largest_depth, first, last, error)
        type(contact_t), intent(in) :: contact
        real(wp), intent(in) :: smallest_depth, largest_depth
        !> coordinates
        real(wp), intent(out) :: first, last
        type(error_t), allocatable, intent(out) :: error
        type(contact_state_t) :: smallest, largest

        first = 0.0_wp
        last = 0.0_wp
        associate (equilibrium => contact%equilibrium, top => contact%equilibrium%unstable_ranges(1)%top)
            if (largest_depth > largest_part*top%depth) then
                call raise(error, error_unreachable, "largest_depth = "//to_text(largest_depth)//": the contact jumps at depth "// &
                           to_text(top%depth)//", contact radius "//to_text(top%radius)//", because the surface bends "// &
                           "strongly. Compile up to depth "//to_text(largest_part*top%depth))
                return
            end if
            call contact%at_depth(smallest_depth, smallest, error)
            if (.not. allocated(error)) call contact%at_depth(largest_depth, largest, error)
            first = equilibrium%coordinate_of(smallest%radius) - beyond
            last = equilibrium%coordinate_of(largest%radius) + beyond
        end associate
    end subroutine ends_before_fall

end module mdrcontact_law_from_contact
