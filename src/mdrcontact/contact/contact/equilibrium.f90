! SPDX-License-Identifier: GPL-3.0-or-later
!> The equilibrium of an indenter on a medium at a given contact radius, with or without adhesion (theory/paper.md (2.1), (4.1),
!> (5.1)).
!>
!> With adhesion the edge springs are drawn by dl(a): d = d0(a) - dl(a), F = F0(a) - k(a) dl(a), d0 and F0 those of the non-adhesive
!> state. With a zeta(a) the depth is zeta(a) g(a), equation (9).
module mdrcontact_contact_equilibrium
    use, intrinsic :: iso_fortran_env, only: int64
    use mdrcontact_nonfinite, only: is_finite
    use mdrcontact_object, only: object_t
    use mdrcontact_codes, only: adhesion_automatic, adhesion_energy, adhesion_paper
    use mdrcontact_contact_cohesion, only: cohesion_t
    use mdrcontact_contact_coordinate, only: coordinate_t, coordinate_under
    use mdrcontact_contact_state, only: contact_state_t
    use mdrcontact_contact_scaled_profile, only: new_scaled_profile, scaled_profile_t
    use mdrcontact_error, only: error_domain, error_invalid, error_no_convergence, error_t, raise, to_text
    use mdrcontact_kinds, only: pi, wp
    use mdrcontact_medium_solver, only: copy, reason_length, solved_t, solver_t
    use mdrcontact_numerics_radius_law, only: interpolation_roughness, radius_law_t
    use mdrcontact_profile, only: copy, profile_t
    implicit none (type, external)
    private
    public :: equilibrium_t, new_equilibrium, unstable_range_t
    public :: adhesion_automatic, adhesion_paper, adhesion_energy

    !> No contact radius is larger [length].
    real(wp), parameter :: largest_number = 1.0e100_wp

    !> A stretch of contact radii over which depth and force of the non-adhesive state fall.
    type :: unstable_range_t
        !> coordinates x = ln(a - end radius) of its ends
        real(wp) :: first = 0.0_wp, last = 0.0_wp
        !> at the first end: the most that contacts up to there carry
        type(contact_state_t) :: top
    end type unstable_range_t

    !> Quantities that determine a state at a given contact radius.
    type, extends(object_t) :: equilibrium_t
        !> with zeta g for g where a zeta is given
        class(profile_t), allocatable :: profile
        logical :: has_zeta = .false.
        class(solver_t), allocatable :: medium
        !> gamma >= 0 [modulus length]
        real(wp) :: work_of_adhesion = 0.0_wp
        !> one of adhesion_...
        integer :: rule = adhesion_automatic
        !> the range of adhesion; not allocated: none
        type(cohesion_t), allocatable :: cohesion
        !> the largest contact radius at which all parts are defined [length]
        real(wp) :: last_radius = 0.0_wp
        !> whether a state is a formula and costs less than to start a thread for it
        logical :: is_formula = .false.
        !> relative accuracy of a state where medium or zeta are interpolated between samples; 0 where they are computed
        real(wp) :: roughness = 0.0_wp
        !> the state without adhesion at the sharp end of an imprint, that of its largest load
        type(contact_state_t) :: sharp_end
        !> ascending; found for contacts, by find_unstable_ranges
        type(unstable_range_t), allocatable :: unstable_ranges(:)
    contains
        procedure :: at
        procedure :: parts
        procedure :: add_breaks
        procedure :: coordinate
        procedure :: radius_of
        procedure :: coordinate_of
        procedure :: ends_sharply
        procedure :: why_it_ends
        procedure :: bytes
    end type equilibrium_t

contains

    !> The equilibrium without adhesion.
    subroutine new_equilibrium(self, profile, medium, error, zeta)
        type(equilibrium_t), intent(out) :: self
        !> copied
        class(profile_t), intent(in) :: profile
        !> copied
        class(solver_t), intent(in) :: medium
        type(error_t), allocatable, intent(out) :: error
        !> zeta(a) of (9); without it, or not allocated: 1
        type(radius_law_t), allocatable, intent(in), optional :: zeta
        type(scaled_profile_t), allocatable :: scaled

        if (medium%is_rigid) then
            call raise(error, error_invalid, ": it is rigid. Pair it with a deformable body", "medium")
            return
        end if
        if (medium%spherical_only .and. .not. profile%is_spherical()) then
            call raise(error, error_invalid, "indenter: the models dimitriadis and garcia apply to a paraboloid or a sphere. "// &
                       "For other indenters use the model exact")
            return
        end if
        if (profile%end_radius > medium%largest_radius) then
            call raise(error, error_domain, "the indenter's flat end, radius "//to_text(profile%end_radius)// &
                       ", is larger than the largest contact radius of the medium, "//to_text(medium%largest_radius))
            return
        end if
        call copy(medium, self%medium, error)
        if (allocated(error)) return
        self%last_radius = largest_contact_radius(profile, medium)
        self%is_formula = medium%is_formula
        self%roughness = medium%roughness
        allocate (self%unstable_ranges(0))
        if (present(zeta)) then
            if (allocated(zeta)) then
                call check_zeta(profile, medium, zeta, error)
                if (allocated(error)) return
                allocate (scaled)
                call new_scaled_profile(scaled, profile, zeta, error)
                if (allocated(error)) return
                call move_alloc(scaled, self%profile)
                self%has_zeta = .true.
                self%last_radius = min(self%last_radius, zeta%largest_radius)
                self%is_formula = .false.
                self%roughness = max(self%roughness, interpolation_roughness)
            end if
        end if
        if (.not. self%has_zeta) call copy(profile, self%profile, error)
        if (allocated(error)) return
        if (self%ends_sharply()) call self%at(self%last_radius, self%sharp_end, error)
        self%is_made = .not. allocated(error)
    end subroutine new_equilibrium

    pure recursive function bytes(self)
        class(equilibrium_t), intent(in) :: self
        integer(int64) :: bytes

        bytes = self%profile%bytes() + self%medium%bytes()
    end function bytes

    subroutine check_zeta(profile, medium, zeta, error)
        class(profile_t), intent(in) :: profile
        class(solver_t), intent(in) :: medium
        type(radius_law_t), intent(in) :: zeta
        type(error_t), allocatable, intent(out) :: error
        real(wp), allocatable :: radii(:)
        real(wp) :: depth, before
        integer :: i

        if (medium%is_exact) then
            call raise(error, error_invalid, "zeta: this medium determines its depth exactly. Omit zeta")
            return
        end if
        call zeta%add_breaks(radii, error)
        before = 0.0_wp
        do i = 1, count(radii <= profile%largest_radius)
            depth = zeta%at(radii(i))*profile%mdr(radii(i))
            if (depth < before) then
                call raise(error, error_invalid, "zeta: the depth zeta(a) g(a) decreases between a = "//to_text(radii(i - 1))// &
                           " and a = "//to_text(radii(i)))
                return
            end if
            before = depth
        end do
    end subroutine check_zeta

    !> Radii where indenter, zeta or medium are not analytic, ascending [length].
    pure subroutine add_breaks(self, radii, error)
        class(equilibrium_t), intent(in) :: self
        real(wp), allocatable, intent(inout) :: radii(:)
        type(error_t), allocatable, intent(inout) :: error

        call self%profile%add_breaks(radii, error)
        call self%medium%add_breaks(radii, error)
    end subroutine add_breaks

    !> The state at a radius that the caller has checked; at a vertical wall that of the lowest depth.
    subroutine at(self, radius, state, error)
        class(equilibrium_t), intent(in) :: self
        real(wp), intent(in) :: radius
        type(contact_state_t), intent(out) :: state
        type(error_t), allocatable, intent(out) :: error

        if (radius <= 0.0_wp) return
        call self%parts(radius, state, error)
        if (allocated(error)) return
        state%depth = state%depth + state%punch_depth
        state%force = state%force + state%stiffness*state%punch_depth
        if (.not. (is_finite(state%depth) .and. is_finite(state%force) .and. is_finite(state%stiffness))) then
            call raise(error, error_no_convergence, "the state at radius = "//to_text(radius)// &
                       " is beyond the range of floating-point numbers")
        end if
    end subroutine at

    !> The parts of the state at a radius > 0: depth and force of the non-adhesive state, the stiffness, and the punch_depth -dl(a),
    !> equation (28) or its energy-consistent form.
    subroutine parts(self, radius, state, error, slopes)
        class(equilibrium_t), intent(in) :: self
        real(wp), intent(in) :: radius
        type(contact_state_t), intent(out) :: state
        type(error_t), allocatable, intent(out) :: error
        !> of ln d0, ln F0 and ln k over the coordinate; 0 where d0'(a) is not known
        real(wp), intent(out), optional :: slopes(3)
        type(solved_t) :: solved
        type(coordinate_t) :: coordinate
        real(wp) :: modulus, rate

        state%radius = radius
        call self%medium%solve(self%profile, radius, solved, error, adhesive=self%work_of_adhesion > 0.0_wp)
        if (allocated(error)) return
        state%depth = solved%depth
        state%force = solved%force
        state%stiffness = 2.0_wp*radius*solved%modulus
        if (present(slopes)) then
            if (.not. self%medium%is_exact) solved%depth_slope = self%profile%mdr_slope(radius)
            coordinate = self%coordinate()
            rate = coordinate%rate(radius)
            ! property B (theory/exact.md (1.7)): dF = k dd
            slopes = [solved%depth_slope/state%depth, state%stiffness*solved%depth_slope/state%force, &
                      solved%stiffness_slope/state%stiffness]*rate
            if (.not. (solved%depth_slope > 0.0_wp .and. all(is_finite(slopes)))) slopes = 0.0_wp
        end if
        if (.not. self%work_of_adhesion > 0.0_wp) return
        modulus = solved%modulus
        if (self%rule == adhesion_energy .or. (self%rule == adhesion_automatic .and. self%medium%is_exact)) then
            modulus = 0.5_wp*solved%stiffness_slope
        end if
        if (.not. modulus > 0.0_wp) then
            call raise(error, error_no_convergence, "the contact stiffness of this medium does not grow with the radius at a = "// &
                       to_text(radius)//": the energy balance has no adhesive state there. Use the adhesion rule paper or "// &
                       "another model")
            return
        end if
        state%punch_depth = -sqrt(2.0_wp*pi*radius*self%work_of_adhesion/modulus)
    end subroutine parts

    !> The coordinate of contact radii in which every shape's laws are close to straight lines.
    pure function coordinate(self)
        class(equilibrium_t), intent(in) :: self
        type(coordinate_t) :: coordinate

        coordinate = coordinate_under(self%profile)
    end function coordinate

    !> Whether its largest contact is that of an imprint at the largest load, at whose edge an adhesive contact rests.
    pure function ends_sharply(self) result(answer)
        class(equilibrium_t), intent(in) :: self
        logical :: answer

        answer = self%profile%sharp_radius > 0.0_wp .and. self%last_radius >= self%profile%sharp_radius
    end function ends_sharply

    !> The radius at a coordinate.
    pure function radius_of(self, x) result(radius)
        class(equilibrium_t), intent(in) :: self
        real(wp), intent(in) :: x
        real(wp) :: radius
        type(coordinate_t) :: coordinate

        coordinate = self%coordinate()
        radius = min(coordinate%radius(x), self%last_radius)
    end function radius_of

    pure function coordinate_of(self, radius) result(x)
        class(equilibrium_t), intent(in) :: self
        real(wp), intent(in) :: radius
        real(wp) :: x
        type(coordinate_t) :: coordinate

        coordinate = self%coordinate()
        x = coordinate%of(radius)
    end function coordinate_of

    !> Remedy in a message that the last radius would be passed.
    pure function why_it_ends(self) result(words)
        class(equilibrium_t), intent(in) :: self
        character(len=reason_length) :: words

        words = ""
        if (self%ends_sharply()) words = ". Beyond the largest load of an imprint the body yields again"
        if (self%last_radius >= self%medium%largest_radius) words = self%medium%why_it_ends
    end function why_it_ends

    !> Largest contact radius: to a vertical wall or a sharp end, or one rounding below the profile's end, which may be a vertical
    !> tangent that media with a unit of length of their own must not reach by rounding; far below the end of the number range.
    pure function largest_contact_radius(profile, medium) result(radius)
        class(profile_t), intent(in) :: profile
        class(solver_t), intent(in) :: medium
        real(wp) :: radius

        radius = profile%largest_radius
        if (.not. (profile%has_wall .or. profile%sharp_radius >= radius)) radius = radius*(1.0_wp - 4.0_wp*epsilon(radius))
        radius = min(radius, medium%largest_radius, largest_number)
    end function largest_contact_radius

end module mdrcontact_contact_equilibrium
