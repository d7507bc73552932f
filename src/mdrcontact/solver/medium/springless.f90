! SPDX-License-Identifier: GPL-3.0-or-later
!> A body whose surface has a tension or carries a plate (theory/surfaces.md (5.1), (6.1)-(6.3)): k C(k) vanishes for short waves,
!> so there are no springs, and a Galerkin solver of its own finds the states.
!>
!> Depth, force and stiffness meet 1e-9, of a cone 1e-8 (measured: docs/surfaces.md).
module mdrcontact_medium_springless
    use, intrinsic :: iso_fortran_env, only: int64
    use mdrcontact_nonfinite, only: infinity
    use mdrcontact_body, only: body_t, copy
    use mdrcontact_body_compliance, only: compliance_t, normal_load
    use mdrcontact_error, only: error_invalid, error_t, raise, to_text
    use mdrcontact_gsl, only: disable_gsl_abort
    use mdrcontact_kinds, only: wp
    use mdrcontact_line_shared, only: layered_shared_t
    use mdrcontact_medium_homogeneous, only: homogeneous_t, new_homogeneous_from_modulus
    use mdrcontact_medium_solver, only: of_displacement, of_line_load, of_pressure, solver_t
    use mdrcontact_profile, only: profile_t
    use mdrcontact_tension_fields, only: load_t, new_load
    use mdrcontact_tension_green, only: green_t, new_green
    use mdrcontact_body_membrane, only: membrane_t, new_membrane
    use mdrcontact_tension_solution, only: solution_t, solve_punch
    use mdrcontact_tension_stability, only: check_stability
    use mdrcontact_tension_surface, only: check_surface, surface_t
    use mdrcontact_tension_table, only: new_punch_table, punch_table_t
    implicit none (type, external)
    private
    public :: springless_t, new_springless

    !> Contact radii up to this many lengths of the tension and so many of a plate, 1/|k_r|: the error grows with the radius, and
    !> what the surface adds falls, to 0.3 % of a stiffness at the first. Radii from this part of a plate's length on: smaller
    !> contacts bend it so little that the equations lose their digits. Radii up to this many thicknesses of the first layer.
    real(wp), parameter :: most_tension_lengths = 1.0e3_wp, most_plate_lengths = 2.0e2_wp, least_plate_length = 1.0e-2_wp, &
                           most_thicknesses = 30.0_wp, extreme_length = 1.0e90_wp

    !> A body under a surface with tension or a plate.
    type, extends(solver_t) :: springless_t
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
        procedure :: response
        procedure :: field
        procedure :: bytes
        procedure :: table_error
    end type springless_t

contains

    !> A body under a surface.
    subroutine new_springless(self, body, surface, error, shared)
        type(springless_t), intent(out) :: self
        !> copied
        class(body_t), intent(in) :: body
        !> not bare
        type(surface_t), intent(in) :: surface
        type(error_t), allocatable, intent(inout) :: error
        !> what this medium has in common with others made before it, which then costs less
        type(layered_shared_t), intent(inout), optional :: shared

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
        if (surface%bending > 0.0_wp .or. self%compliance%first_depth > 0.0_wp .or. self%bare_excess > 0.0_wp) return
        if (present(shared)) then
            if (allocated(shared%punches)) then
                self%table = shared%punches
                return
            end if
        end if
        allocate (self%table)
        call new_punch_table(self%table, self%compliance, error)
        if (present(shared) .and. .not. allocated(error)) shared%punches = self%table
    end subroutine new_springless

    !> Phi, and between which radii the solver holds.
    subroutine set_lengths(self, error)
        type(springless_t), intent(inout) :: self
        type(error_t), allocatable, intent(inout) :: error
        real(wp) :: l, b, largest

        l = 2.0_wp*self%sheet%tension/self%surface_modulus
        b = 2.0_wp*self%sheet%bending/self%surface_modulus
        call check_lengths(self, l, b, error)
        if (allocated(error)) return
        largest = most_tension_lengths*l
        self%why_it_ends = ": beyond 1000 lengths 2 tau/E* of the tension it adds less than 0.3 %: leave it out"
        if (b > 0.0_wp) then
            largest = most_plate_lengths*b**(1.0_wp/3.0_wp)
            self%why_it_ends = ": beyond 200 lengths (2 B/E*)^(1/3) of the plate it adds next to nothing: leave it out"
            if (l > b**(1.0_wp/3.0_wp)) then
                largest = most_plate_lengths*sqrt(b/l)
                self%why_it_ends = ": beyond 200 lengths (B/tau)^(1/2) of the plate under tension it adds next to nothing: "// &
                                   "leave it out"
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
        type(springless_t), intent(in) :: self
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
                   to_text(self%sheet%bending)//" is not allowed: the lengths 2 tau/E*, (2 B/E*)^(1/3) and (B/tau)^(1/2) must "// &
                   "be between 1e-90 and 1e90")
    end subroutine check_lengths

    pure recursive function bytes(self)
        class(springless_t), intent(in) :: self
        integer(int64) :: bytes

        bytes = self%pressed%bytes() + self%compliance%bytes()
    end function bytes

    !> Relative difference of the table from the solver where it was not sampled; 0 without a table.
    pure function table_error(self) result(difference)
        class(springless_t), intent(in) :: self
        real(wp) :: difference

        difference = 0.0_wp
        if (allocated(self%table)) difference = self%table%error
    end function table_error

    !> The flat punch, from the table where it has it.
    subroutine punch_at(self, a, punch, error)
        class(springless_t), intent(in) :: self
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
        class(springless_t), intent(in) :: self
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

    subroutine response(self, profile, a, depth, force, modulus, stiffness_slope, error, adhesive, depth_slope, accuracy)
        class(springless_t), intent(in) :: self
        class(profile_t), intent(in) :: profile
        real(wp), intent(in) :: a
        real(wp), intent(out) :: depth, force, modulus, stiffness_slope
        type(error_t), allocatable, intent(out) :: error
        logical, intent(in), optional :: adhesive
        real(wp), intent(inout), optional :: depth_slope
        real(wp), intent(inout), optional :: accuracy
        type(solution_t) :: punch
        real(wp) :: stiffness

        associate (unused => adhesive, also_unused => depth_slope)
        end associate
        depth = 0.0_wp
        force = 0.0_wp
        modulus = 0.0_wp
        stiffness_slope = 0.0_wp
        if (present(accuracy)) accuracy = 0.0_wp
        call punch_at(self, a, punch, error)
        if (.not. allocated(error)) call punch%respond(profile, stiffness, stiffness_slope, depth, force, error)
        if (allocated(error)) return
        force = self%surface_modulus*force
        modulus = 0.5_wp*self%surface_modulus*stiffness/a
        stiffness_slope = self%surface_modulus*stiffness_slope
    end subroutine response

    !> The load of a state, and its depth.
    subroutine find_load(self, profile, a, punch_depth, load, depth, error)
        class(springless_t), intent(in) :: self
        class(profile_t), intent(in) :: profile
        real(wp), intent(in) :: a, punch_depth
        type(load_t), intent(out) :: load
        real(wp), intent(out) :: depth
        type(error_t), allocatable, intent(out) :: error
        type(solution_t) :: punch
        real(wp), allocatable :: coefficients(:)
        real(wp) :: stiffness, slope, force

        depth = 0.0_wp
        call solve_punch(punch, self%green, self%compliance, a, error)
        if (.not. allocated(error)) call punch%respond(profile, stiffness, slope, depth, force, error)
        if (allocated(error)) return
        depth = depth + punch_depth
        call punch%load_of(profile, depth, coefficients, error)
        if (allocated(error)) return
        call new_load(load, a, coefficients, punch%couple, abs(punch_depth) > 0.0_wp .or. punch%couple == 1)
    end subroutine find_load

    elemental function at_edge(load) result(value)
        type(load_t), intent(in) :: load
        real(wp) :: value

        value = 0.0_wp
        if (abs(load%line_force) > 0.0_wp) value = sign(infinity, load%line_force)
    end function at_edge

    !> On the sheet. Line load and pressure are infinite at an edge that carries a line force. Inside the contact the springs' depth
    !> is d - g, as on a half-space without a sheet.
    subroutine field(self, quantity, profile, a, punch_depth, r, values, error)
        class(springless_t), intent(in) :: self
        integer, intent(in) :: quantity
        class(profile_t), intent(in) :: profile
        real(wp), intent(in) :: a, punch_depth
        real(wp), intent(in) :: r(:)
        real(wp), intent(out) :: values(:)
        type(error_t), allocatable, intent(out) :: error
        type(load_t) :: load
        type(homogeneous_t) :: half_space
        real(wp), allocatable :: inside(:)
        real(wp) :: depth
        integer :: i

        call find_load(self, profile, a, punch_depth, load, depth, error)
        if (allocated(error)) return
        select case (quantity)
        case (of_line_load)
            where (r < a)
                values = self%surface_modulus*load%line_load(min(r, a*(1.0_wp - epsilon(a))))
            else where
                values = at_edge(load)
            end where
        case (of_pressure)
            values = self%surface_modulus*load%pressure(r)
            if (abs(load%line_force) > 0.0_wp) then
                where (.not. r < a) values = at_edge(load)
            end if
        case default
            call new_homogeneous_from_modulus(half_space, self%surface_modulus, error)
            allocate (inside, mold=r)
            if (.not. allocated(error)) then
                call half_space%field(of_displacement, profile, a, depth - profile%mdr(a), r, inside, error)
            end if
            do i = 1, size(r)
                if (allocated(error)) return
                call load%displacement(self%green, self%compliance, r(i), inside(i), values(i), error)
            end do
        end select
    end subroutine field

end module mdrcontact_medium_springless
