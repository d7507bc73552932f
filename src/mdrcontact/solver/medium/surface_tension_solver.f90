! SPDX-License-Identifier: GPL-3.0-or-later
!> A body whose surface has a tension or carries a plate (theory/surfaces.md (5.1), (6.1)-(6.3)): k C(k) vanishes for short waves,
!> so there are no springs, and a Galerkin solver of its own finds the states.
!>
!> Depth, force and stiffness meet 1e-9, of a cone 1e-8 (measured: docs/surfaces.md).
module mdrcontact_medium_surface_tension_solver
    use, intrinsic :: iso_fortran_env, only: int64
    use mdrcontact_nonfinite, only: infinity
    use mdrcontact_body, only: body_t, copy
    use mdrcontact_body_compliance, only: compliance_t, normal_load
    use mdrcontact_error, only: error_invalid, error_t, raise, to_text
    use mdrcontact_gsl, only: disable_gsl_abort
    use mdrcontact_kinds, only: wp
    use mdrcontact_line_shared, only: kernel_cache_t
    use mdrcontact_medium_homogeneous, only: homogeneous_t, new_homogeneous_from_modulus
    use mdrcontact_medium_effective, only: effective_load_t
    use mdrcontact_medium_load, only: load_t
    use mdrcontact_medium_solver, only: solved_t, solver_t
    use mdrcontact_profile, only: profile_t
    use mdrcontact_tension_fields, only: new_tension_load, tension_load_t
    use mdrcontact_tension_green, only: green_t, new_green
    use mdrcontact_body_membrane, only: membrane_t, new_membrane
    use mdrcontact_tension_solution, only: solution_t, solve_punch
    use mdrcontact_tension_stability, only: check_stability
    use mdrcontact_tension_surface, only: check_surface, surface_t
    use mdrcontact_tension_table, only: new_punch_table, punch_table_t
    implicit none (type, external)
    private
    public :: surface_tension_solver_t, new_surface_tension_solver

    !> Contact radii up to this many lengths of the tension and so many of a plate, 1/|k_r|: the error grows with the radius, and
    !> what the surface adds falls, to 0.3 % of a stiffness at the first. Radii from this part of a plate's length on: smaller
    !> contacts bend it so little that the equations lose their digits. Radii up to this many thicknesses of the first layer.
    real(wp), parameter :: most_tension_lengths = 1.0e3_wp, most_plate_lengths = 2.0e2_wp, least_plate_length = 1.0e-2_wp, &
                           most_thicknesses = 30.0_wp, extreme_length = 1.0e90_wp

    !> A body under a surface with tension or a plate.
    type, extends(solver_t) :: surface_tension_solver_t
        private
        class(compliance_t), allocatable :: compliance
        type(green_t) :: green
        !> E0* of the surface material [modulus]
        real(wp) :: surface_modulus = 0.0_wp
        !> c and l_m of a surface that is stiff in its plane
        real(wp) :: bare_excess = 0.0_wp, bare_length = 0.0_wp
        !> of a half-space under tension alone
        type(punch_table_t), allocatable :: table
    contains
        procedure :: modulus
        procedure :: solve
        procedure :: load => new_load
        procedure :: bytes
        procedure :: table_error
    end type surface_tension_solver_t

    !> The load on the sheet. Line load and pressure are infinite at an edge that carries a line force. Inside the contact the
    !> springs' depth is d - g, as on a half-space without a sheet. What the sheet hands on to the body next to it is not part of
    !> it.
    type, extends(load_t) :: on_tension_load_t
        private
        class(surface_tension_solver_t), pointer :: medium => null()
        type(tension_load_t) :: on_sheet
        !> d [length]
        real(wp) :: depth = 0.0_wp
    contains
        procedure :: line_load
        procedure :: pressure
        procedure :: displacement
    end type on_tension_load_t

contains

    !> A body under a surface.
    subroutine new_surface_tension_solver(self, body, surface, error, shared)
        type(surface_tension_solver_t), intent(out) :: self
        !> copied
        class(body_t), intent(in) :: body
        !> not bare
        type(surface_t), intent(in) :: surface
        type(error_t), allocatable, intent(inout) :: error
        !> data shared with media created before, which make this one cheaper
        type(kernel_cache_t), intent(inout), optional :: shared

        type(membrane_t), allocatable :: membrane
        class(compliance_t), allocatable :: own

        call disable_gsl_abort()
        call check_surface(surface, error)
        if (.not. allocated(error)) call body%compliance(normal_load, own, error)
        if (allocated(error)) return
        if (surface%stretching > 0.0_wp) then
            allocate (membrane)
            call new_membrane(membrane, surface%stretching, own, error, has_springs=.false.)
            if (allocated(error)) return
            self%bare_excess = membrane%excess
            self%bare_length = membrane%length
            call move_alloc(membrane, self%compliance)
        else
            call move_alloc(own, self%compliance)
        end if
        if (.not. allocated(error)) call check_stability(surface, self%compliance, error)
        if (.not. allocated(error)) call copy(body, self%pressed, error)
        if (allocated(error)) return
        self%sheet = surface
        self%surface_modulus = real(self%compliance%scale, wp)
        self%surface_contrast = max(1.0_wp, real(self%compliance%at_zero, wp))
        self%is_exact = .true.
        self%is_modulus_formula = .false.
        call set_lengths(self, error)
        if (allocated(error)) return
        if (surface%bending > 0.0_wp .or. self%compliance%first_depth > 0.0_wp .or. self%bare_excess > 0.0_wp) then
            self%is_made = .true.
            return
        end if
        if (present(shared)) then
            if (allocated(shared%punches)) then
                self%table = shared%punches
                self%is_made = .true.
                return
            end if
        end if
        allocate (self%table)
        call new_punch_table(self%table, self%compliance, error)
        if (present(shared) .and. .not. allocated(error)) shared%punches = self%table
        self%is_made = .not. allocated(error)
    end subroutine new_surface_tension_solver

    !> Phi, and between which radii the solver holds.
    subroutine set_lengths(self, error)
        type(surface_tension_solver_t), intent(inout) :: self
        type(error_t), allocatable, intent(inout) :: error
        real(wp) :: l, b, largest

        l = 2.0_wp*self%sheet%tension/self%surface_modulus
        b = 2.0_wp*self%sheet%bending/self%surface_modulus
        call check_lengths(self, l, b, error)
        if (allocated(error)) return
        largest = most_tension_lengths*l
        self%why_it_ends = ". Beyond 1000 lengths 2 tau/E* the tension contributes less than 0.3 %: omit it"
        if (b > 0.0_wp) then
            largest = most_plate_lengths*b**(1.0_wp/3.0_wp)
            self%why_it_ends = ". Beyond 200 lengths (2 B/E*)^(1/3) the contribution of the plate is negligible: omit it"
            if (l > b**(1.0_wp/3.0_wp)) then
                largest = most_plate_lengths*sqrt(b/l)
                self%why_it_ends = ". Beyond 200 lengths (B/tau)^(1/2) the contribution of the plate under tension is "// &
                                   "negligible: omit it"
            end if
        end if
        if (self%compliance%first_depth > 0.0_wp .and. most_thicknesses*self%compliance%first_depth < largest) then
            largest = most_thicknesses*self%compliance%first_depth
            self%why_it_ends = ": under a surface with tension or a plate, 30 thicknesses of the first layer"
        end if
        self%largest_radius = largest
        call new_green(self%green, l, b, 2.0_wp*largest, error, self%bare_excess, self%bare_length)
        if (b > 0.0_wp) self%smallest_radius = least_plate_length/self%green%rate
    end subroutine set_lengths

    !> Raises where the third powers of Phi's poles would leave the range of numbers.
    pure subroutine check_lengths(self, l, b, error)
        type(surface_tension_solver_t), intent(in) :: self
        real(wp), intent(in) :: l, b
        type(error_t), allocatable, intent(inout) :: error
        real(wp) :: shortest, longest

        if (b > 0.0_wp) then
            shortest = b**(1.0_wp/3.0_wp)
            longest = max(shortest, abs(l))
            if (abs(l) > shortest) shortest = sqrt(b/abs(l))
        else
            shortest = l
            longest = l
        end if
        if (shortest > 1.0_wp/extreme_length .and. longest < extreme_length) return
        call raise(error, error_invalid, "surface tension = "//to_text(self%sheet%tension)//" with surface bending = "// &
                   to_text(self%sheet%bending)//": the lengths 2 tau/E*, (2 B/E*)^(1/3) and (B/tau)^(1/2) must lie between "// &
                   "1e-90 and 1e90")
    end subroutine check_lengths

    pure recursive function bytes(self)
        class(surface_tension_solver_t), intent(in) :: self
        integer(int64) :: bytes

        bytes = self%pressed%bytes() + self%compliance%bytes()
    end function bytes

    !> Relative difference of the table from the solver where it was not sampled; 0 without a table.
    pure function table_error(self) result(difference)
        class(surface_tension_solver_t), intent(in) :: self
        real(wp) :: difference

        difference = 0.0_wp
        if (allocated(self%table)) difference = self%table%error
    end function table_error

    !> The flat punch, from the table where it has it.
    subroutine punch_at(self, a, punch, error)
        class(surface_tension_solver_t), intent(in) :: self
        real(wp), intent(in) :: a
        type(solution_t), intent(out) :: punch
        type(error_t), allocatable, intent(inout) :: error

        if (allocated(self%table)) then
            if (self%table%covers(a/self%green%tension_length)) then
                call self%table%at(self%green%tension_length, a, punch)
                return
            end if
        end if
        call solve_punch(punch, self%green, self%compliance, a, error)
    end subroutine punch_at

    !> E_eff = k/(2 a).
    subroutine modulus(self, a, values, error, slopes)
        class(surface_tension_solver_t), intent(in) :: self
        real(wp), intent(in) :: a(:)
        real(wp), intent(out) :: values(:)
        type(error_t), allocatable, intent(out) :: error
        real(wp), intent(out), optional :: slopes(:)
        type(solution_t) :: punch
        real(wp) :: stiffness, slope
        integer :: i

        do i = 1, size(a)
            call punch_at(self, a(i), punch, error)
            if (allocated(error)) return
            call punch%flat(stiffness, slope)
            values(i) = 0.5_wp*self%surface_modulus*stiffness/a(i)
            if (present(slopes)) slopes(i) = (0.5_wp*self%surface_modulus*slope - values(i))/a(i)
        end do
    end subroutine modulus

    subroutine solve(self, profile, a, solved, error, adhesive, accuracy, series)
        class(surface_tension_solver_t), intent(in) :: self
        class(profile_t), intent(in) :: profile
        real(wp), intent(in) :: a
        type(solved_t), intent(out) :: solved
        type(error_t), allocatable, intent(out) :: error
        logical, intent(in), optional :: adhesive
        real(wp), intent(inout), optional :: accuracy
        real(wp), allocatable, intent(out), optional :: series(:, :)
        type(solution_t) :: punch
        real(wp) :: stiffness

        if (present(adhesive) .or. present(series)) continue
        if (present(accuracy)) accuracy = 0.0_wp
        call punch_at(self, a, punch, error)
        if (.not. allocated(error)) call punch%respond(profile, stiffness, solved%stiffness_slope, solved%depth, solved%force, &
                                                       error)
        if (allocated(error)) return
        solved%force = self%surface_modulus*solved%force
        solved%modulus = 0.5_wp*self%surface_modulus*stiffness/a
        solved%stiffness_slope = self%surface_modulus*solved%stiffness_slope
    end subroutine solve

    subroutine new_load(self, profile, a, punch_depth, load, error)
        class(surface_tension_solver_t), intent(in), target :: self
        class(profile_t), intent(in), target :: profile
        real(wp), intent(in) :: a, punch_depth
        class(load_t), allocatable, intent(out) :: load
        type(error_t), allocatable, intent(out) :: error
        type(on_tension_load_t), allocatable :: own
        type(solution_t) :: punch
        real(wp), allocatable :: coefficients(:)
        real(wp) :: stiffness, slope, force

        allocate (own)
        own%medium => self
        own%profile => profile
        own%radius = a
        own%punch_depth = punch_depth
        call solve_punch(punch, self%green, self%compliance, a, error)
        if (.not. allocated(error)) call punch%respond(profile, stiffness, slope, own%depth, force, error)
        if (allocated(error)) return
        own%depth = own%depth + punch_depth
        call punch%load_of(profile, own%depth, coefficients, error)
        if (allocated(error)) return
        call new_tension_load(own%on_sheet, a, coefficients, punch%couple, abs(punch_depth) > 0.0_wp .or. punch%couple == 1)
        call move_alloc(own, load)
    end subroutine new_load

    elemental function at_edge(load) result(value)
        type(tension_load_t), intent(in) :: load
        real(wp) :: value

        value = 0.0_wp
        if (abs(load%line_force) > 0.0_wp) value = sign(infinity, load%line_force)
    end function at_edge

    subroutine line_load(self, r, values, error)
        class(on_tension_load_t), intent(in) :: self
        real(wp), intent(in) :: r(:)
        real(wp), intent(out) :: values(:)
        type(error_t), allocatable, intent(out) :: error

        if (allocated(error)) continue
        associate (a => self%radius)
            where (r < a)
                values = self%medium%surface_modulus*self%on_sheet%line_load(min(r, a*(1.0_wp - epsilon(a))))
            else where
                values = at_edge(self%on_sheet)
            end where
        end associate
    end subroutine line_load

    subroutine pressure(self, r, values, error)
        class(on_tension_load_t), intent(in) :: self
        real(wp), intent(in) :: r(:)
        real(wp), intent(out) :: values(:)
        type(error_t), allocatable, intent(out) :: error

        if (allocated(error)) continue
        values = self%medium%surface_modulus*self%on_sheet%pressure(r)
        if (abs(self%on_sheet%line_force) > 0.0_wp) then
            where (.not. r < self%radius) values = at_edge(self%on_sheet)
        end if
    end subroutine pressure

    subroutine displacement(self, r, values, error)
        class(on_tension_load_t), intent(in) :: self
        real(wp), intent(in) :: r(:)
        real(wp), intent(out) :: values(:)
        type(error_t), allocatable, intent(out) :: error
        type(homogeneous_t), target :: half_space
        type(effective_load_t) :: bare
        real(wp), allocatable :: inside(:)
        integer :: i

        call new_homogeneous_from_modulus(half_space, self%medium%surface_modulus, error)
        allocate (inside, mold=r)
        if (.not. allocated(error)) then
            call bare%begin(half_space, self%profile, self%radius, self%depth - self%profile%mdr(self%radius))
            call bare%displacement(r, inside, error)
        end if
        do i = 1, size(r)
            if (allocated(error)) return
            call self%on_sheet%displacement(self%medium%green, self%medium%compliance, r(i), inside(i), values(i), error)
        end do
    end subroutine displacement

end module mdrcontact_medium_surface_tension_solver
