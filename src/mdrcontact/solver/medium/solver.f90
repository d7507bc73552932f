! SPDX-License-Identifier: GPL-3.0-or-later
!> The solver of a medium: it gives depth, force, stiffness and line load of a profile pressed into it at contact radius a.
!>
!> Every frictionless contact state at radius a is the non-adhesive state plus a flat punch of radius a:
!>     q(x; a) = q_nonadhesive(x; a) + punch_depth * q_punch(x; a),    punch_depth = d - d0(a),
!> q_punch per unit of depth, d0 the depth of the non-adhesive state.
!> `punch_depth` is 0 without adhesion, negative at an adhesive edge (theory/paper.md (5.1)) and positive at a vertical wall (flat
!> punch). Contact, adhesion and fitting are written in these terms, for any solver.
module mdrcontact_medium_solver
    use, intrinsic :: iso_fortran_env, only: int64
    use mdrcontact_object, only: object_t, room
    use mdrcontact_body, only: body_t, copy
    use mdrcontact_body_compliance, only: twist_load
    use mdrcontact_error, only: check_made, error_invalid, error_t, raise
    use mdrcontact_medium_load, only: load_t
    use mdrcontact_medium_slip, only: slip_t
    use mdrcontact_kinds, only: wp
    use mdrcontact_line_springs, only: springs_t
    use mdrcontact_numerics_scalar_function, only: scalar_function_t
    use mdrcontact_profile, only: profile_t
    use mdrcontact_tension_surface, only: is_bare, surface_t
    implicit none (type, external)
    private
    public :: copy, solver_t, modulus_of_radius_t, depth_and_force, set_pair
    public :: check_springs, refuse, refuse_load
    public :: reason_length, solved_t

    !> Length of the text of why_it_ends.
    integer, parameter :: reason_length = 120

    !> The non-adhesive contact at one radius.
    type :: solved_t
        !> d [length], F [modulus length^2], E_eff [modulus] and k'(a) = 2 (E_eff + a E_eff') [modulus]
        real(wp) :: depth = 0.0_wp, force = 0.0_wp, modulus = 0.0_wp, stiffness_slope = 0.0_wp
        !> d'(a) [1]; negative if the solution does not provide it
        real(wp) :: depth_slope = -1.0_wp
    end type solved_t

    !> An elastic half-space, or two of them. Concrete solvers are made by their `new_...` procedures and never change afterwards.
    !> All radii are positive and finite, and at most the profile's largest_radius: callers check this.
    type, abstract, extends(object_t) :: solver_t
        !> the body that is pressed and, of two deformable ones, the upper one, where they are known; not allocated else
        class(body_t), allocatable :: pressed, counterbody
        !> the springs on a line to which it comes exactly; not allocated where there are none or a modulus alone is known
        type(springs_t), allocatable :: springs
        !> tension and plate of the surface; bare for most
        type(surface_t) :: sheet
        !> whether it represents two deformable bodies, and whether it holds for paraboloids and spheres alone
        logical :: is_pair = .false., spherical_only = .false.
        !> part of the upper body in a change of depth, where that is the same at all radii: 0 if the indenter is rigid [1]
        real(wp) :: share_of_upper = 0.0_wp
        !> the smallest and the largest contact radius at which it is defined [length]; huge() where there is no end
        real(wp) :: smallest_radius = 0.0_wp, largest_radius = huge(1.0_wp)
        !> relative accuracy of E_eff and its slope where they are interpolated between samples; 0 where they are computed
        real(wp) :: roughness = 0.0_wp
        !> E0, z0, m and nu of one power-law graded body; not allocated of any other
        real(wp), allocatable :: power_law(:)
        !> how many times stiffer the surface is than what lies below it, at most, where that is known
        real(wp) :: surface_contrast = 1.0_wp
        !> what follows a message that a contact would be larger: why, and what to do; blank where the end was given by the caller
        character(len=reason_length) :: why_it_ends = ""
        !> whether its states are the exact ones of a body: depths need no zeta (9), and an adhesive edge meets the energy balance.
        !> Of a medium with an effective modulus both are choices (theory/paper.md (4.1), (5.2), (5.3)), and the depth is g(a) of
        !> the profile
        logical :: is_exact = .false.
        !> whether a state is a formula, so that it costs less than to start a thread for it
        logical :: is_formula = .false.
        !> whether E_eff(a) is a formula; elsewhere each value is the solution of a system
        logical :: is_modulus_formula = .true.
        !> whether the load of a spring depends on its own displacement alone, by one factor for all of them
        logical :: has_free_springs = .false.
        !> whether it does not deform: one body of a pair, not a medium alone; and whether the lower body of a pair does not
        logical :: is_rigid = .false., lower_is_rigid = .false.
    contains
        !> E_eff(a), equation (10) [modulus], and its slope
        procedure(radius_function), deferred :: modulus
        !> the non-adhesive contact at radius a
        procedure(solved_at), deferred :: solve
        !> the load of a state
        procedure(load_of_state), deferred :: load
        !> first shear of a state
        procedure :: slip
        !> the medium that responds to another load as this one does to a pressure
        procedure :: for_load
        !> radii where E_eff is not analytic, ascending [length]
        procedure :: add_breaks
        procedure :: bytes
    end type solver_t

    !> A copy of a solver, after a trial of the memory that it takes.
    interface copy
        module procedure copy_solver
    end interface copy

    !> E_eff of a medium as a function of the contact radius.
    type, extends(scalar_function_t) :: modulus_of_radius_t
        class(solver_t), pointer :: medium => null()
    contains
        procedure :: value => modulus_at
    end type modulus_of_radius_t

    abstract interface
        subroutine radius_function(self, a, values, error, slopes)
            import :: error_t, solver_t, wp
            class(solver_t), intent(in) :: self
            !> contact radii [length]
            real(wp), intent(in) :: a(:)
            !> same size as a
            real(wp), intent(out) :: values(:)
            type(error_t), allocatable, intent(out) :: error
            !> dE_eff/da [modulus/length], same size
            real(wp), intent(out), optional :: slopes(:)
        end subroutine radius_function

        subroutine solved_at(self, profile, a, solved, error, adhesive, accuracy, series)
            import :: error_t, profile_t, solved_t, solver_t, wp
            class(solver_t), intent(in) :: self
            class(profile_t), intent(in) :: profile
            !> contact radius [length]
            real(wp), intent(in) :: a
            type(solved_t), intent(out) :: solved
            type(error_t), allocatable, intent(out) :: error
            !> stiffness_slope is as exact as the rest: an adhesive edge depends on it; default false
            logical, intent(in), optional :: adhesive
            !> relative accuracy that is enough, where less costs less; on return that of the numbers, 0 if it is the medium's own
            real(wp), intent(inout), optional :: accuracy
            !> coefficients of s_j P_2j(x/a), j = 0, 1, ..., s_j = sqrt((4j + 1)/2), of q under a flat punch of unit depth [modulus]
            !> and of q without adhesion [modulus length] (term, 2); not allocated where they are not known. Integrals over q are
            !> as exact as the state by them, values at points to about 100 times its tolerance
            real(wp), allocatable, intent(out), optional :: series(:, :)
        end subroutine solved_at

        subroutine load_of_state(self, profile, a, punch_depth, load, error)
            import :: error_t, load_t, profile_t, solver_t, wp
            !> the load refers to medium and profile: both must outlive it
            class(solver_t), intent(in), target :: self
            class(profile_t), intent(in), target :: profile
            !> contact radius [length] and depth beyond that of the non-adhesive state [length]
            real(wp), intent(in) :: a, punch_depth
            class(load_t), allocatable, intent(out) :: load
            type(error_t), allocatable, intent(out) :: error
        end subroutine load_of_state
    end interface

contains

    function modulus_at(self, x) result(y)
        class(modulus_of_radius_t), intent(inout) :: self
        real(wp), intent(in) :: x
        real(wp) :: y
        real(wp) :: values(1)

        call self%medium%modulus([x], values, self%error)
        y = values(1)
    end function modulus_at

    !> The bodies are those of two media.
    subroutine set_pair(self, lower, upper, error)
        class(solver_t), intent(inout) :: self
        class(solver_t), intent(in) :: lower, upper
        type(error_t), allocatable, intent(inout) :: error

        self%is_pair = .true.
        self%lower_is_rigid = lower%is_rigid
        self%spherical_only = lower%spherical_only .or. upper%spherical_only
        if (allocated(lower%pressed)) call copy(lower%pressed, self%pressed, error)
        if (allocated(upper%pressed)) call copy(upper%pressed, self%counterbody, error)
    end subroutine set_pair

    !> Depth and force alone.
    subroutine depth_and_force(solver, profile, a, depth, force, error)
        class(solver_t), intent(in) :: solver
        class(profile_t), intent(in) :: profile
        !> contact radius [length]
        real(wp), intent(in) :: a
        !> d [length] and F [modulus length^2] of the non-adhesive contact
        real(wp), intent(out) :: depth, force
        type(error_t), allocatable, intent(out) :: error
        type(solved_t) :: solved

        call solver%solve(profile, a, solved, error)
        depth = solved%depth
        force = solved%force
    end subroutine depth_and_force

    pure subroutine add_breaks(self, radii, error)
        class(solver_t), intent(in) :: self
        !> ascending [length]; not allocated: none yet
        real(wp), allocatable, intent(inout) :: radii(:)
        type(error_t), allocatable, intent(inout) :: error

        associate (unused => self, also_unused => error)
        end associate
        if (.not. allocated(radii)) allocate (radii(0))
    end subroutine add_breaks

    !> Size of its bodies.
    pure recursive function bytes(self)
        class(solver_t), intent(in) :: self
        integer(int64) :: bytes

        bytes = 0
        if (allocated(self%pressed)) bytes = bytes + self%pressed%bytes()
        if (allocated(self%counterbody)) bytes = bytes + self%counterbody%bytes()
    end function bytes

    !> The same solver; an error where there is no memory for it.
    subroutine copy_solver(from, to, error)
        class(solver_t), intent(in) :: from
        class(solver_t), allocatable, intent(out) :: to
        type(error_t), allocatable, intent(inout) :: error

        call room(from%bytes(), error)
        if (.not. allocated(error)) allocate (to, source=from)
    end subroutine copy_solver

    !> Only of media that respond to a shear is it known.
    subroutine slip(self, tangential, load, found, error)
        class(solver_t), intent(in) :: self
        !> the same medium under shear
        class(solver_t), intent(in) :: tangential
        !> of a state of this medium, with a punch_depth >= 0
        class(load_t), intent(in) :: load
        class(slip_t), allocatable, intent(out) :: found
        type(error_t), allocatable, intent(out) :: error

        if (.not. self%is_made) call check_made(error, "medium", self%is_made)
        call check_made(error, "tangential", tangential%is_made)
        if (allocated(error)) return
        associate (unused => self, also_unused => tangential, unused_too => load, this_too => found)
        end associate
        call raise(error, error_invalid, "medium: friction is not available")
    end subroutine slip

    !> Quantities that are not available for most media.
    subroutine for_load(self, load, other, error)
        class(solver_t), intent(in) :: self
        !> shear_load: its modulus is then G_t(a) = k_t(a)/(2 a); twist_load
        integer, intent(in) :: load
        class(solver_t), allocatable, intent(out) :: other
        type(error_t), allocatable, intent(out) :: error

        if (.not. self%is_made) call check_made(error, "medium", self%is_made)
        if (allocated(error)) return
        associate (unused => other)
        end associate
        call refuse_load(self, load, error)
    end subroutine for_load

    !> The refusal of a load along the surface.
    pure subroutine refuse_load(self, load, error)
        class(solver_t), intent(in) :: self
        !> shear_load or twist_load
        integer, intent(in) :: load
        type(error_t), allocatable, intent(inout) :: error

        if (load == twist_load) then
            call refuse(self, "the torsional stiffness is", "a homogeneous medium with E and nu, or a coated, layered or "// &
                        "graded one with the model exact", "the theory does not include a twist", error)
        else
            call refuse(self, "the tangential stiffness is", "a homogeneous one with E and nu, or a coated, layered or graded "// &
                        "one with the model exact or one of the weighted means (gao, gao-series, gao-power)", &
                        "the theory does not include a shift", error)
        end if
    end subroutine refuse_load

    !> Raises unless the medium comes to springs exactly.
    pure subroutine check_springs(self, what, error)
        class(solver_t), intent(in) :: self
        !> quantity that needs them, with its verb
        character(len=*), intent(in) :: what
        type(error_t), allocatable, intent(inout) :: error

        if (allocated(self%springs) .or. allocated(error)) return
        call refuse(self, what, "a homogeneous one, or a coated, layered or graded one with the model exact: an effective "// &
                    "modulus has no equation for springs", "its springs do not exist or are nearly singular", error)
    end subroutine check_springs

    !> Error for a quantity that only other media provide.
    pure subroutine refuse(self, what, instead, under_sheet, error)
        class(solver_t), intent(in) :: self
        !> with its verb; media that provide it; why none does under a surface with tension or a sheet
        character(len=*), intent(in) :: what, instead, under_sheet
        type(error_t), allocatable, intent(inout) :: error

        if (is_bare(self%sheet)) then
            call raise(error, error_invalid, what//" not available for this medium. Use "//instead)
        else
            call raise(error, error_invalid, what//" not available under a surface with tension or a sheet: "//under_sheet)
        end if
    end subroutine refuse

end module mdrcontact_medium_solver
