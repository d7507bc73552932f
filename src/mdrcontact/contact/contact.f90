! SPDX-License-Identifier: GPL-3.0-or-later
!> The contact of an indenter with a medium: states from depth, force or radius (theory/paper.md (2.1), (4.1), (5.1)).
module mdrcontact_contact
    use mdrcontact_codes, only: on_loading, on_unloading
    use mdrcontact_contact_adhesive_branch, only: adhesive_branch_t, stable_segment_t
    use mdrcontact_contact_branch, only: branch_t, new_branch
    use mdrcontact_contact_control, only: control_t, depth_control, force_control
    use mdrcontact_contact_state, only: contact_state_t
    use mdrcontact_contact_equilibrium, only: adhesion_automatic, adhesion_energy, adhesion_paper, equilibrium_t, &
                                                new_equilibrium
    use mdrcontact_contact_exact_zeta, only: exact_zeta
    use mdrcontact_contact_unstable_ranges, only: find_unstable_ranges
    use mdrcontact_error, only: check_code, check_finite, check_made, check_not_negative, error_domain, error_invalid, error_t, &
                                error_unreachable, raise, to_text
    use mdrcontact_contact_load, only: check_state, contact_load_t, new_contact_load
    use mdrcontact_gsl, only: disable_gsl_abort
    use mdrcontact_contact_inversion, only: invert, neighbours_t
    use mdrcontact_contact_zone_branch, only: add_cohesion, new_zone_branch, zone_branch_t
    use mdrcontact_contact_warnings, only: add_warning => add, contact_warning_t, find_warnings, warning_short_zone
    use mdrcontact_kinds, only: wp
    use mdrcontact_medium, only: check_elastic, medium_t
    use mdrcontact_medium_solver, only: solver_t
    use mdrcontact_profile, only: profile_t
    use mdrcontact_numerics_quadrature, only: merge_breaks
    use mdrcontact_numerics_radius_law, only: radius_law_t
    implicit none (type, external)
    private
    public :: contact_t, new_contact, check_adhesion, check_cohesion, contact_options_t
    public :: on_loading, on_unloading, check_branch

    !> Optional properties of a contact.
    type :: contact_options_t
        !> gamma >= 0 [modulus length]
        real(wp) :: work_of_adhesion = 0.0_wp
        !> adhesion_automatic, adhesion_paper or adhesion_energy
        integer :: adhesion_rule = adhesion_automatic
        !> zeta(a) of (9), d = zeta(a) g(a), for a medium with an effective modulus; zeta = 1 if not allocated
        type(radius_law_t), allocatable :: zeta
        !> whether zeta is that of this body solved exactly, for radii up to 1000 thicknesses, instead of a given one
        logical :: zeta_is_exact = .false.
        !> sigma_0 >= 0, under which the bodies attract each other up to a gap of gamma/sigma_0; 0: the JKR limit [modulus]
        real(wp) :: cohesive_stress = 0.0_wp
    end type contact_options_t

    !> An indenter on a medium. It holds copies of both and never changes; any number of threads may share it.
    type :: contact_t
        !> whether it was made: set last by what makes it
        logical :: is_made = .false.
        !> what determines a state once the radius is known; read only
        type(equilibrium_t) :: equilibrium
        !> the adhesive branch; not allocated without adhesion
        class(adhesive_branch_t), allocatable, private :: branch
        !> a cohesive stress was given whose zone is too short to change a digit: the JKR limit represents it
        logical :: has_short_zone = .false.
    contains
        procedure :: at_radius
        procedure :: at_depth
        procedure :: at_force
        procedure :: at_control
        procedure :: load
        procedure :: slope
        procedure :: pull_off
        procedure :: stable_segments
        procedure :: state_on_segment
        procedure :: work_between
        procedure :: first_attraction
        procedure :: is_adhesive
        procedure :: is_formula
        procedure :: radius_range
        procedure :: warnings
    end type contact_t

    !> A contact of a profile with a medium or its solver.
    interface new_contact
        module procedure new_contact_with_medium, new_contact_with_solver
    end interface new_contact

contains

    !> A contact of `profile` with an elastic medium.
    subroutine new_contact_with_medium(self, profile, medium, error, options)
        type(contact_t), intent(out) :: self
        !> copied
        class(profile_t), intent(in) :: profile
        !> copied
        type(medium_t), intent(in) :: medium
        type(error_t), allocatable, intent(out) :: error
        !> without it: no adhesion, zeta = 1
        type(contact_options_t), intent(in), optional :: options

        call check_made(error, "profile", profile%is_made)
        call check_made(error, "medium", medium%is_given())
        if (allocated(error)) return
        call check_elastic(medium, error)
        if (.not. allocated(error)) call new_contact(self, profile, medium%solver, error, options)
        self%is_made = .not. allocated(error)
    end subroutine new_contact_with_medium

    !> The same with a medium that is known by its solver.
    subroutine new_contact_with_solver(self, profile, medium, error, options)
        type(contact_t), intent(out) :: self
        class(profile_t), intent(in) :: profile
        class(solver_t), intent(in) :: medium
        type(error_t), allocatable, intent(out) :: error
        type(contact_options_t), intent(in), optional :: options
        type(radius_law_t), allocatable :: zeta

        call check_made(error, "profile", profile%is_made)
        call check_made(error, "medium", medium%is_made)
        if (allocated(error)) return
        call disable_gsl_abort()
        if (.not. present(options)) then
            call new_equilibrium(self%equilibrium, profile, medium, error)
            if (.not. allocated(error)) call find_unstable_ranges(self%equilibrium, error)
            self%is_made = .not. allocated(error)
            return
        end if
        if (options%zeta_is_exact) then
            call exact_zeta(profile, medium, zeta, error)
            if (.not. allocated(error)) call new_equilibrium(self%equilibrium, profile, medium, error, zeta)
        else
            call new_equilibrium(self%equilibrium, profile, medium, error, options%zeta)
        end if
        if (.not. allocated(error)) call set_adhesion(self, options, error)
        if (.not. (allocated(error) .or. self%is_adhesive())) call find_unstable_ranges(self%equilibrium, error)
        self%is_made = .not. allocated(error)
    end subroutine new_contact_with_solver

    subroutine set_adhesion(self, options, error)
        type(contact_t), intent(inout) :: self
        type(contact_options_t), intent(in) :: options
        type(error_t), allocatable, intent(out) :: error
        type(branch_t), allocatable :: branch

        call check_adhesion(options%work_of_adhesion, options%adhesion_rule, error)
        call check_cohesion(options, error)
        if (allocated(error) .or. options%work_of_adhesion <= 0.0_wp) return
        self%equilibrium%work_of_adhesion = options%work_of_adhesion
        self%equilibrium%rule = options%adhesion_rule
        if (options%cohesive_stress > 0.0_wp) call set_cohesion(self, options, error)
        if (allocated(error) .or. allocated(self%branch)) return
        allocate (branch)
        call new_branch(branch, self%equilibrium, error)
        call move_alloc(branch, self%branch)
    end subroutine set_adhesion

    !> Finite-range adhesion; none where the zone is too short to change a digit.
    subroutine set_cohesion(self, options, error)
        type(contact_t), intent(inout) :: self
        type(contact_options_t), intent(in) :: options
        type(error_t), allocatable, intent(out) :: error
        type(zone_branch_t), allocatable :: branch

        call add_cohesion(self%equilibrium, options%cohesive_stress, error)
        if (allocated(error)) return
        self%has_short_zone = .not. allocated(self%equilibrium%cohesion)
        if (self%has_short_zone) return
        allocate (branch)
        call new_zone_branch(branch, self%equilibrium, error)
        call move_alloc(branch, self%branch)
    end subroutine set_cohesion

    !> Raises unless the cohesive stress is >= 0 and goes with the other options.
    pure subroutine check_cohesion(options, error)
        type(contact_options_t), intent(in) :: options
        type(error_t), allocatable, intent(inout) :: error

        call check_not_negative(error, "cohesive_stress", options%cohesive_stress)
        if (allocated(error) .or. .not. options%cohesive_stress > 0.0_wp) return
        if (.not. options%work_of_adhesion > 0.0_wp) then
            call raise(error, error_invalid, " = "//to_text(options%cohesive_stress)//": it needs a work_of_adhesion, because "// &
                       "the range of adhesion is work_of_adhesion/cohesive_stress", "cohesive_stress")
        else if (options%adhesion_rule == adhesion_paper) then
            call raise(error, error_invalid, " = "//to_text(options%cohesive_stress)//": the adhesion rule paper has no "// &
                       "cohesive zone. Use the rule energy", "cohesive_stress")
        else if (options%zeta_is_exact .or. allocated(options%zeta)) then
            call raise(error, error_invalid, " = "//to_text(options%cohesive_stress)//": it excludes zeta, because a contact "// &
                       "with a cohesive zone is solved exactly. Omit zeta", "cohesive_stress")
        end if
    end subroutine check_cohesion

    !> Raises unless the work of adhesion is >= 0 and the rule is automatic, the paper's or energy.
    pure subroutine check_adhesion(work_of_adhesion, rule, error)
        real(wp), intent(in) :: work_of_adhesion
        integer, intent(in) :: rule
        type(error_t), allocatable, intent(inout) :: error

        call check_not_negative(error, "work_of_adhesion", work_of_adhesion)
        call check_code(error, "adhesion_rule", rule, [adhesion_automatic, adhesion_paper, adhesion_energy])
    end subroutine check_adhesion

    !> The load of a state, solved once for all that is read from it.
    subroutine load(self, state, found, error)
        !> it must outlive the load
        class(contact_t), intent(in), target :: self
        !> a state of this contact, a > 0
        type(contact_state_t), intent(in) :: state
        type(contact_load_t), intent(out) :: found
        type(error_t), allocatable, intent(out) :: error

        if (.not. self%is_made) call check_made(error, "contact", self%is_made)
        if (allocated(error)) return
        call new_contact_load(found, self%equilibrium, state, error)
    end subroutine load

    !> dF/dd along the branch of equilibria through a state, on which the contact radius changes with the depth. Without adhesion,
    !> and at a vertical wall of the indenter, where the radius stays, it is the stiffness. With adhesion it is less, 0 where the
    !> force turns and infinite where the depth does (theory/paper.md (5.4)).
    subroutine slope(self, state, found, error)
        class(contact_t), intent(in) :: self
        !> a state of equilibrium of this contact
        type(contact_state_t), intent(in) :: state
        !> 0 where the bodies do not act on each other [modulus length]
        real(wp), intent(out) :: found
        type(error_t), allocatable, intent(out) :: error

        found = 0.0_wp
        if (.not. self%is_made) call check_made(error, "contact", self%is_made)
        if (allocated(error)) return
        if (max(state%radius, state%zone_radius) <= 0.0_wp) return
        call check_state(self%equilibrium, state, error)
        if (allocated(error)) return
        found = state%stiffness
        if (.not. self%is_adhesive()) return
        associate (profile => self%equilibrium%profile)
            if ((profile%has_wall .or. profile%sharp_radius > 0.0_wp) &
                .and. state%radius >= profile%largest_radius*(1.0_wp - 1.0e-12_wp)) return
            ! at the edge of a flat end the depth moves before the radius
            if (.not. allocated(self%equilibrium%cohesion) .and. state%radius <= profile%end_radius*(1.0_wp + 1.0e-12_wp)) return
        end associate
        call self%branch%slope_at(self%equilibrium, state, found, error)
    end subroutine slope

    !> Whether the work of adhesion is greater than 0.
    pure function is_adhesive(self) result(answer)
        class(contact_t), intent(in) :: self
        logical :: answer

        answer = allocated(self%branch)
    end function is_adhesive

    !> Whether a state is a formula and costs less than to start a thread for it.
    pure function is_formula(self) result(answer)
        class(contact_t), intent(in) :: self
        logical :: answer

        answer = self%equilibrium%is_formula .and. .not. self%is_adhesive()
    end function is_formula

    !> Between which contact radii the contact is defined, and where it is not analytic in between.
    subroutine radius_range(self, end_radius, smallest, largest, breaks, error)
        class(contact_t), intent(in) :: self
        !> radius of the indenter's flat end, 0 if it does not exist [length]
        real(wp), intent(out) :: end_radius
        !> smallest and largest contact radius at which there is a state [length]; equal for a flat punch
        real(wp), intent(out) :: smallest, largest
        !> radii where indenter or medium are not analytic, ascending [length]
        real(wp), allocatable, intent(out) :: breaks(:)
        type(error_t), allocatable, intent(out) :: error
        real(wp), allocatable :: all_breaks(:)

        if (.not. self%is_made) call check_made(error, "contact", self%is_made)
        if (allocated(error)) return
        end_radius = self%equilibrium%profile%end_radius
        smallest = max(end_radius, self%equilibrium%medium%smallest_radius)
        largest = max(smallest, self%equilibrium%last_radius)
        call self%equilibrium%add_breaks(all_breaks, error)
        call merge_breaks(breaks, all_breaks(count(all_breaks <= smallest) + 1:count(all_breaks < largest)), error)
    end subroutine radius_range

    !> Doubts about the numbers of a state: slopes and strains that are not small, moduli in two units.
    subroutine warnings(self, state, found, error)
        class(contact_t), intent(in) :: self
        !> a state of this contact
        type(contact_state_t), intent(in) :: state
        !> none where nothing does
        type(contact_warning_t), allocatable, intent(out) :: found(:)
        type(error_t), allocatable, intent(out) :: error

        if (.not. self%is_made) call check_made(error, "contact", self%is_made)
        if (allocated(error)) return
        if (state%radius /= 0.0_wp) call check_state(self%equilibrium, state, error)
        if (allocated(error)) return
        call find_warnings(self%equilibrium, state, found)
        if (self%has_short_zone) call add_warning(found, warning_short_zone, "the cohesive zone is too short to affect the "// &
                                                  "result: the states are those of the JKR limit")
    end subroutine warnings

    !> The state of equilibrium at contact radius a, stable or not.
    subroutine at_radius(self, radius, state, error)
        class(contact_t), intent(in) :: self
        !> a: at least the radius of the indenter's flat end, at most where indenter and medium are defined; 0 is initial contact
        real(wp), intent(in) :: radius
        type(contact_state_t), intent(out) :: state
        type(error_t), allocatable, intent(out) :: error
        real(wp) :: end_radius, wall_radius, smallest

        if (.not. self%is_made) call check_made(error, "contact", self%is_made)
        if (allocated(error)) return
        call check_not_negative(error, "radius", radius)
        if (allocated(error)) return
        end_radius = self%equilibrium%profile%end_radius
        ! with a zone a part of a flat end may be in contact
        if (allocated(self%equilibrium%cohesion)) end_radius = 0.0_wp
        wall_radius = self%equilibrium%profile%largest_radius
        smallest = self%equilibrium%medium%smallest_radius
        if (radius < end_radius) then
            call raise(error, error_unreachable, " = "//to_text(radius)//": the contact radius is at least that of the flat "// &
                       "end, "//to_text(end_radius), "radius")
        else if (self%equilibrium%profile%has_wall .and. radius >= wall_radius) then
            call raise(error, error_unreachable, " = "//to_text(radius)//": it does not determine a state at the vertical "// &
                       "wall of the indenter, radius "//to_text(wall_radius)//". Give depth or force", "radius")
        else if (radius > self%equilibrium%last_radius) then
            call raise(error, error_domain, " = "//to_text(radius)//": indenter and medium are defined up to "// &
                       to_text(self%equilibrium%last_radius)//trim(self%equilibrium%why_it_ends()), "radius")
        else if (radius < smallest) then
            call raise(error, error_domain, " = "//to_text(radius)//": the medium is defined from "//to_text(smallest)//" on", &
                       "radius")
        end if
        if (allocated(error)) return
        if (allocated(self%branch)) then
            call self%branch%at_radius(self%equilibrium, radius, state, error)
        else
            call self%equilibrium%at(radius, state, error)
        end if
    end subroutine at_radius

    !> The stable state at indentation depth d.
    subroutine at_depth(self, depth, state, error, branch, neighbours)
        class(contact_t), intent(in), target :: self
        !> d >= 0, or with adhesion down to the pull-off depth on unloading [length]. Where a contact without adhesion has several
        !> states of this depth, on a stiff coating that bends: the one with the smallest radius, met first as the contact grows
        real(wp), intent(in) :: depth
        type(contact_state_t), intent(out) :: state
        type(error_t), allocatable, intent(out) :: error
        !> on_loading or on_unloading (default)
        integer, intent(in), optional :: branch
        !> states found last, which may save most of the work without adhesion
        type(neighbours_t), intent(inout), optional :: neighbours

        if (.not. self%is_made) call check_made(error, "contact", self%is_made)
        if (allocated(error)) return
        call self%at_control(depth_control, "depth", depth, state, error, branch, neighbours)
        if (.not. allocated(error)) state%depth = depth
    end subroutine at_depth

    !> The stable state under normal force F.
    subroutine at_force(self, force, state, error, branch, neighbours)
        class(contact_t), intent(in), target :: self
        !> F >= 0, or with adhesion down to the pull-off force on unloading [modulus length^2]
        real(wp), intent(in) :: force
        type(contact_state_t), intent(out) :: state
        type(error_t), allocatable, intent(out) :: error
        !> on_loading or on_unloading (default)
        integer, intent(in), optional :: branch
        !> states found last, which may save most of the work without adhesion
        type(neighbours_t), intent(inout), optional :: neighbours

        if (.not. self%is_made) call check_made(error, "contact", self%is_made)
        if (allocated(error)) return
        call self%at_control(force_control, "force", force, state, error, branch, neighbours)
        if (.not. allocated(error)) state%force = force
    end subroutine at_force

    !> Raises unless `branch` is on_loading or on_unloading.
    pure subroutine check_branch(error, branch)
        type(error_t), allocatable, intent(inout) :: error
        integer, intent(in) :: branch

        call check_code(error, "branch", branch, [on_loading, on_unloading])
    end subroutine check_branch

    !> The stable state at a given value s of what a machine controls: depth, force, or the far end of a spring.
    subroutine at_control(self, control, name, s, state, error, branch, neighbours)
        class(contact_t), intent(in), target :: self
        type(control_t), intent(in) :: control
        !> what s is called in error messages
        character(len=*), intent(in) :: name
        !> value of what is controlled, in its unit: [length] or [modulus length^2]
        real(wp), intent(in) :: s
        type(contact_state_t), intent(out) :: state
        type(error_t), allocatable, intent(out) :: error
        !> on_loading or on_unloading (default)
        integer, intent(in), optional :: branch
        !> states found last, which may save most of the work without adhesion
        type(neighbours_t), intent(inout), optional :: neighbours
        integer :: way

        if (.not. self%is_made) call check_made(error, "contact", self%is_made)
        if (allocated(error)) return
        way = on_unloading
        if (present(branch)) way = branch
        call check_branch(error, way)
        call check_finite(error, name, s)
        if (allocated(error)) return
        if (self%is_adhesive()) then
            call adhesive_state(self, control, name, s, way, state, error)
        else if (s < 0.0_wp) then
            call raise(error, error_unreachable, " = "//to_text(s)//": without adhesion there is no contact below "//name// &
                       " = 0", name)
        else
            call invert(self%equilibrium, control, name, s, state, error, neighbours)
        end if
    end subroutine at_control

    !> Where the contact breaks: the state of lowest depth or force on the whole branch, and the other local minima.
    subroutine pull_off(self, control, state, error, others)
        class(contact_t), intent(in) :: self
        !> depth_control, force_control, or a spring in between
        type(control_t), intent(in) :: control
        !> all zero without adhesion
        type(contact_state_t), intent(out) :: state
        type(error_t), allocatable, intent(out) :: error
        !> ends of the other stable segments, in ascending order of the radius
        type(contact_state_t), allocatable, intent(out), optional :: others(:)
        type(stable_segment_t), allocatable :: list(:)
        type(contact_state_t), allocatable :: ends(:)
        real(wp) :: smallest
        integer :: i, global

        if (.not. self%is_made) call check_made(error, "contact", self%is_made)
        if (allocated(error)) return
        if (present(others)) allocate (others(0))
        if (.not. self%is_adhesive()) return
        call self%stable_segments(control, list, error)
        if (allocated(error)) return
        if (size(list) == 0) then
            call raise(error, error_unreachable, "this contact has no stable adhesive state under this control")
            return
        end if
        ! from the edge of an imprint, where a stable contact goes on, it does not detach
        if (self%equilibrium%ends_sharply() .and. size(list) > 1) then
            if (list(size(list) - 1)%last >= list(size(list))%first) list = list(:size(list) - 1)
        end if
        allocate (ends(size(list)))
        do i = 1, size(list)
            call self%state_on_segment(control, list(i), list(i)%lowest, ends(i), error)
            if (allocated(error)) return
        end do
        global = minloc(list%lowest, dim=1)
        smallest = self%equilibrium%medium%smallest_radius
        if (smallest > self%equilibrium%profile%end_radius .and. ends(global)%radius <= smallest*(1.0_wp + 1.0e-12_wp)) then
            call raise(error, error_domain, "pull-off: the contact is still stable at the smallest radius of the medium, "// &
                       to_text(smallest))
            return
        end if
        state = ends(global)
        if (present(others)) others = [ends(:global - 1), ends(global + 1:)]
    end subroutine pull_off

    !> The stable segments of the adhesive branch under a control, by ascending radius.
    subroutine stable_segments(self, control, list, error)
        class(contact_t), intent(in) :: self
        type(control_t), intent(in) :: control
        type(stable_segment_t), allocatable, intent(out) :: list(:)
        type(error_t), allocatable, intent(out) :: error

        if (.not. self%is_made) call check_made(error, "contact", self%is_made)
        if (allocated(error)) return
        if (allocated(self%branch)) then
            call self%branch%stable_segments(self%equilibrium, control, list, error)
        else
            allocate (list(0))
        end if
    end subroutine stable_segments

    !> The state with a given value of the controlled quantity on one of the stable segments.
    subroutine state_on_segment(self, control, segment, s, state, error)
        class(contact_t), intent(in) :: self
        type(control_t), intent(in) :: control
        type(stable_segment_t), intent(in) :: segment
        !> between the lowest and the highest value of the segment
        real(wp), intent(in) :: s
        type(contact_state_t), intent(out) :: state
        type(error_t), allocatable, intent(out) :: error

        if (.not. self%is_made) call check_made(error, "contact", self%is_made)
        if (allocated(error)) return
        call self%branch%state_on(self%equilibrium, control, segment, s, state, error)
    end subroutine state_on_segment

    !> int F dd along the adhesive branch between two of its states.
    function work_between(self, from, to) result(work)
        class(contact_t), intent(in) :: self
        type(contact_state_t), intent(in) :: from, to
        real(wp) :: work

        work = self%branch%work_between(self%equilibrium, from, to)
    end function work_between

    !> s at which adhesive bodies that approach begin to attract each other.
    pure function first_attraction(self, control) result(s)
        class(contact_t), intent(in) :: self
        type(control_t), intent(in) :: control
        real(wp) :: s

        s = self%branch%first_attraction(control)
    end function first_attraction

    !> The stable adhesive state with a given s, on loading (the smallest contact that the approach meets) or on unloading
    !> (the largest).
    subroutine adhesive_state(self, control, name, s, way, state, error)
        type(contact_t), intent(in) :: self
        type(control_t), intent(in) :: control
        character(len=*), intent(in) :: name
        real(wp), intent(in) :: s
        integer, intent(in) :: way
        type(contact_state_t), intent(out) :: state
        type(error_t), allocatable, intent(out) :: error
        type(stable_segment_t), allocatable :: list(:)
        character(len=:), allocatable :: what
        integer :: chosen

        what = " = "//to_text(s)
        if (way == on_loading .and. s < self%branch%first_attraction(control)) then
            call raise(error, error_unreachable, what//" on loading: the bodies attract each other from "//name//" = "// &
                       to_text(self%branch%first_attraction(control))//" on. Below it a contact exists on unloading only", name)
            return
        end if
        call self%stable_segments(control, list, error)
        if (allocated(error)) return
        if (size(list) == 0) then
            call raise(error, error_unreachable, what//": this contact has no stable adhesive state", name)
            return
        end if
        chosen = findloc(list%lowest <= s .and. s <= list%highest, .true., dim=1, back=way == on_unloading)
        if (chosen > 0) then
            call self%state_on_segment(control, list(chosen), s, state, error)
        else if (s < minval(list%lowest)) then
            call raise(error, error_unreachable, what//": the adhesive branch ends at pull-off, "//name//" = "// &
                       to_text(minval(list%lowest)), name)
        else
            call raise(error, error_unreachable, what//": the branch ends with the indenter or the medium at "//name//" = "// &
                       to_text(maxval(list%highest))//trim(self%equilibrium%why_it_ends()), name)
        end if
    end subroutine adhesive_state

end module mdrcontact_contact
