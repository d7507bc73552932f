! SPDX-License-Identifier: GPL-3.0-or-later
!> The exact layered medium (theory/exact.md (1.4), (1.5)): no approximation in contact radius, depth or stiffness.
!>
!> Once made, the medium holds its body and the kernel; a contact radius then costs a small symmetric positive definite system.
!> Results meet the stated relative tolerance, or an error is raised.
module mdrcontact_medium_exact
    use mdrcontact_nonfinite, only: infinity
    use mdrcontact_body, only: body_t, copy
    use mdrcontact_body_compliance, only: compliance_t, normal_load
    use mdrcontact_body_stack, only: new_stack, stack_t
    use mdrcontact_error, only: check_made, check_within, error_invalid, error_t, raise
    use mdrcontact_medium_load, only: load_t, lower_body, upper_body
    use mdrcontact_medium_exact_load, only: exact_load_t, new_exact_load, part_t
    use mdrcontact_medium_slip, only: slip_t
    use mdrcontact_gsl, only: disable_gsl_abort
    use mdrcontact_kinds, only: wp
    use mdrcontact_line_combine, only: add_kernels
    use mdrcontact_line_fields, only: line_load_t
    use mdrcontact_line_moments, only: is_smooth
    use mdrcontact_line_kernel, only: kernel_t
    use mdrcontact_line_shared, only: kernel_cache_t, shared_kernel
    use mdrcontact_medium_exact_slip, only: layered_slip_t, new_layered_slip
    use mdrcontact_line_solve, only: solution_t, solve_springs => solve
    use mdrcontact_line_springs, only: springs_t
    use mdrcontact_material, only: in_series, material_t
    use mdrcontact_medium_solver, only: depth_and_force, set_pair, solved_t, solver_t
    use mdrcontact_medium_homogeneous, only: homogeneous_t, new_homogeneous_from_modulus
    use mdrcontact_profile, only: profile_t
    implicit none (type, external)
    private
    public :: layered_exact_t, new_layered_exact, new_exact_pair

    real(wp), parameter :: smallest_tolerance = 1.0e-12_wp, largest_tolerance = 1.0e-2_wp

    !> Contact radii up to this many depths of all layers are offered.
    real(wp), parameter :: largest_ratio = 1.0e4_wp
    !> The same where all layers are of one material [length].
    real(wp), parameter :: largest_homogeneous = 1.0e100_wp

    !> A layered or graded half-space, or two bodies pressed together, solved exactly.
    type, extends(solver_t) :: layered_exact_t
        private
        !> of two deformable bodies: the lower and the upper one
        type(part_t), allocatable :: parts(:)
        !> a half-space of the surface materials
        type(homogeneous_t) :: surface
    contains
        procedure :: modulus
        procedure :: solve
        procedure :: load => new_load
        procedure :: slip
        procedure :: for_load
        procedure :: zeta
    end type layered_exact_t

    !> The exact medium of a body, or of layers on a substrate.
    interface new_layered_exact
        module procedure new_exact_from_body
        module procedure new_exact_from_layers
        module procedure new_exact_from_homogeneous
        module procedure new_exact_from_compliance
    end interface new_layered_exact

contains

    !> Any body, solved exactly. The medium keeps it.
    subroutine new_exact_from_body(self, body, error, tolerance, shared)
        type(layered_exact_t), intent(out) :: self
        class(body_t), intent(in) :: body
        type(error_t), allocatable, intent(out) :: error
        !> relative tolerance of E_eff, d and F, 1e-12 to 1e-2; default 1e-10
        real(wp), intent(in), optional :: tolerance
        !> data shared with media created before, which make this one cheaper
        type(kernel_cache_t), intent(inout), optional :: shared

        call check_made(error, "body", body%is_made)
        if (allocated(error)) return
        allocate (self%springs)
        if (present(tolerance)) then
            call check_within(error, "tolerance", tolerance, smallest_tolerance, largest_tolerance)
            if (allocated(error)) return
            self%springs%tolerance = tolerance
        end if
        call solve_body(self, body, normal_load, error, shared)
        if (.not. allocated(error)) call copy(body, self%pressed, error)
        self%is_made = .not. allocated(error)
    end subroutine new_exact_from_body

    !> Any compliance under a normal load; what it is of is not known.
    subroutine new_exact_from_compliance(self, compliance, error, tolerance, shared)
        type(layered_exact_t), intent(out) :: self
        class(compliance_t), intent(in) :: compliance
        type(error_t), allocatable, intent(out) :: error
        real(wp), intent(in) :: tolerance
        type(kernel_cache_t), intent(inout), optional :: shared

        call check_within(error, "tolerance", tolerance, smallest_tolerance, largest_tolerance)
        allocate (self%springs)
        self%springs%tolerance = tolerance
        call solve_compliance(self, compliance, error, shared)
        self%is_made = .not. allocated(error)
    end subroutine new_exact_from_compliance

    !> The kernel of a body under a load, and what follows from it.
    subroutine solve_body(self, body, load, error, shared)
        type(layered_exact_t), intent(inout) :: self
        class(body_t), intent(in) :: body
        integer, intent(in) :: load
        type(error_t), allocatable, intent(inout) :: error
        type(kernel_cache_t), intent(inout), optional :: shared
        class(compliance_t), allocatable :: compliance

        if (load /= normal_load .and. body%slides) then
            call raise(error, error_invalid, "medium: a layer over a sliding interface has no tangential stiffness. Give the "// &
                       "interface a tangential stiffness")
            return
        end if
        call body%compliance(load, compliance, error)
        if (.not. allocated(error)) call solve_compliance(self, compliance, error, shared)
    end subroutine solve_body

    subroutine solve_compliance(self, compliance, error, shared)
        type(layered_exact_t), intent(inout) :: self
        class(compliance_t), intent(in) :: compliance
        type(error_t), allocatable, intent(inout) :: error
        type(kernel_cache_t), intent(inout), optional :: shared
        type(kernel_cache_t) :: own

        if (allocated(error)) return
        call disable_gsl_abort()
        self%springs%modulus = real(compliance%scale, wp)
        call new_homogeneous_from_modulus(self%surface, self%springs%modulus, error)
        if (allocated(error)) return
        if (present(shared)) then
            call shared_kernel(shared, compliance, self%springs%kernel, error)
        else
            call shared_kernel(own, compliance, self%springs%kernel, error)
        end if
        self%largest_radius = merge(largest_homogeneous, largest_ratio*compliance%last_depth, self%springs%kernel%vanishes)
        self%surface_contrast = contrast_of(self%springs%kernel)
        call mark_exact(self)
    end subroutine solve_compliance

    !> k'(a) = 2 E0* q_1(a; a)^2, so that by the energy balance the edge spring carries q(a) = -sqrt(2 pi a gamma E0*).
    pure subroutine mark_exact(self)
        type(layered_exact_t), intent(inout) :: self

        self%is_exact = .true.
        self%is_modulus_formula = .false.
    end subroutine mark_exact

    !> A stack of bonded layers on an elastic half-space or a rigid base: the arguments of new_stack and those above.
    subroutine new_exact_from_layers(self, layers, thickness, substrate, error, tolerance, rigid_base, shared)
        type(layered_exact_t), intent(out) :: self
        type(material_t), intent(in) :: layers(:)
        real(wp), intent(in) :: thickness(:)
        type(material_t), intent(in) :: substrate
        type(error_t), allocatable, intent(out) :: error
        real(wp), intent(in), optional :: tolerance
        logical, intent(in), optional :: rigid_base
        type(kernel_cache_t), intent(inout), optional :: shared
        type(stack_t) :: stack

        call new_stack(stack, layers, thickness, substrate, error, rigid_base)
        if (.not. allocated(error)) call new_exact_from_body(self, stack, error, tolerance, shared)
        self%is_made = .not. allocated(error)
    end subroutine new_exact_from_layers

    !> A homogeneous half-space, or a rigid one, to be paired.
    subroutine new_exact_from_homogeneous(self, homogeneous, error)
        type(layered_exact_t), intent(out) :: self
        class(homogeneous_t), intent(in) :: homogeneous
        type(error_t), allocatable, intent(out) :: error

        call check_made(error, "homogeneous", homogeneous%is_made)
        if (allocated(error)) return
        if (allocated(homogeneous%pressed)) call copy(homogeneous%pressed, self%pressed, error)
        self%surface = homogeneous
        allocate (self%springs)
        self%springs%modulus = homogeneous%half_space_modulus()
        self%largest_radius = largest_homogeneous
        self%springs%tolerance = largest_tolerance
        call mark_exact(self)
        self%is_made = .not. allocated(error)
    end subroutine new_exact_from_homogeneous

    !> Two bodies pressed together (theory/exact.md (5.1)): 1/E0* = 1/E1* + 1/E2*, X = E0* (X_1/E1* + X_2/E2*), and nothing else
    !> changes.
    subroutine new_exact_pair(self, lower, upper, error)
        type(layered_exact_t), intent(out) :: self
        !> not pairs, not both rigid
        class(layered_exact_t), intent(in) :: lower, upper
        type(error_t), allocatable, intent(out) :: error
        real(wp) :: shares(2)

        allocate (self%springs)
        self%springs%modulus = in_series(lower%springs%modulus, upper%springs%modulus)
        allocate (self%parts(2))
        self%parts(lower_body)%kernel = lower%springs%kernel
        self%parts(upper_body)%kernel = upper%springs%kernel
        shares = self%springs%modulus/[lower%springs%modulus, upper%springs%modulus]
        self%parts%share = shares
        self%largest_radius = min(lower%largest_radius, upper%largest_radius)
        self%springs%tolerance = min(lower%springs%tolerance, upper%springs%tolerance)
        call set_pair(self, lower, upper, error)
        if (allocated(error)) return
        call new_homogeneous_from_modulus(self%surface, self%springs%modulus, error)
        if (.not. allocated(error)) call add_kernels(lower%springs%kernel, upper%springs%kernel, shares, &
                                                     self%springs%kernel, error)
        self%surface_contrast = contrast_of(self%springs%kernel)
        call mark_exact(self)
        self%is_made = .not. allocated(error)
    end subroutine new_exact_pair

    !> E0*/E_eff at large radii, or what it comes to at the unit if the base is stiff again.
    pure function contrast_of(kernel) result(ratio)
        type(kernel_t), intent(in) :: kernel
        real(wp) :: ratio

        ratio = 1.0_wp
        if (.not. kernel%vanishes) ratio = max(kernel%one_plus_chi_zero, kernel%origin)
    end function contrast_of

    !> E_eff(a), the stiffness of a flat punch over 2 a, and E_eff'(a) = (E0* q_1(a; a)^2 - E_eff(a))/a.
    subroutine modulus(self, a, values, error, slopes)
        class(layered_exact_t), intent(in) :: self
        real(wp), intent(in) :: a(:)
        real(wp), intent(out) :: values(:)
        type(error_t), allocatable, intent(out) :: error
        real(wp), intent(out), optional :: slopes(:)
        type(solution_t) :: solution
        integer :: i

        if (.not. self%is_made) call check_made(error, "medium", self%is_made)
        if (allocated(error)) return
        do i = 1, size(a)
            call solve_springs(self%springs%kernel, self%springs%tolerance, a(i), solution, error, edge=present(slopes))
            if (allocated(error)) return
            values(i) = self%springs%modulus*solution%modulus
            if (present(slopes)) slopes(i) = self%springs%modulus*(solution%punch_edge**2 - solution%modulus)/a(i)
        end do
    end subroutine modulus

    !> All quantities from one solution: k'(a) = 2 E0* q_1(a; a)^2, where E_eff + a E_eff' would cancel on a soft film.
    subroutine solve(self, profile, a, solved, error, adhesive, accuracy, series)
        class(layered_exact_t), intent(in) :: self
        class(profile_t), intent(in) :: profile
        real(wp), intent(in) :: a
        type(solved_t), intent(out) :: solved
        type(error_t), allocatable, intent(out) :: error
        logical, intent(in), optional :: adhesive
        real(wp), intent(inout), optional :: accuracy
        real(wp), allocatable, intent(out), optional :: series(:, :)
        type(solution_t) :: solution
        real(wp) :: tolerance

        if (.not. self%is_made) call check_made(error, "medium", self%is_made)
        if (allocated(error)) return
        tolerance = self%springs%tolerance
        if (present(accuracy)) tolerance = max(tolerance, accuracy)
        ! of smooth indenters on films
        if (present(series) .and. is_smooth(profile)) then
            call solve_springs(self%springs%kernel, tolerance, a, solution, error, profile, adhesive, series)
            if (.not. allocated(error)) series = self%springs%modulus*series
        else
            call solve_springs(self%springs%kernel, tolerance, a, solution, error, profile, adhesive)
        end if
        if (allocated(error)) return
        if (present(accuracy)) then
            accuracy = maxval(solution%errors([1, 3, 4]))
            if (accuracy <= self%springs%tolerance) accuracy = 0.0_wp
        end if
        solved%depth = solution%depth
        solved%force = self%springs%modulus*solution%force
        solved%modulus = self%springs%modulus*solution%modulus
        solved%stiffness_slope = 2.0_wp*self%springs%modulus*solution%punch_edge**2
        solved%depth_slope = solution%depth_slope
    end subroutine solve

    !> zeta(a) = d/g(a), equation (9): what the depth is to that of a homogeneous body at the same contact radius.
    subroutine zeta(self, profile, a, values, error)
        class(layered_exact_t), intent(in) :: self
        class(profile_t), intent(in) :: profile
        !> contact radii beyond the flat end of the profile [length]
        real(wp), intent(in) :: a(:)
        !> same size as a
        real(wp), intent(out) :: values(:)
        type(error_t), allocatable, intent(out) :: error
        real(wp) :: force
        integer :: i

        if (.not. self%is_made) call check_made(error, "medium", self%is_made)
        if (allocated(error)) return
        do i = 1, size(a)
            call depth_and_force(self, profile, a(i), values(i), force, error)
            if (allocated(error)) return
            values(i) = values(i)/profile%mdr(a(i))
        end do
    end subroutine zeta

    subroutine new_load(self, profile, a, punch_depth, load, error)
        class(layered_exact_t), intent(in), target :: self
        class(profile_t), intent(in), target :: profile
        real(wp), intent(in) :: a, punch_depth
        class(load_t), allocatable, intent(out) :: load
        type(error_t), allocatable, intent(out) :: error
        type(exact_load_t), allocatable :: own

        if (.not. self%is_made) call check_made(error, "medium", self%is_made)
        if (allocated(error)) return
        allocate (own)
        call new_exact_load(own, self%springs, self%surface, profile, a, punch_depth, error, self%parts)
        if (.not. allocated(error)) call move_alloc(own, load)
    end subroutine new_load

    subroutine for_load(self, load, other, error)
        class(layered_exact_t), intent(in) :: self
        integer, intent(in) :: load
        class(solver_t), allocatable, intent(out) :: other
        type(error_t), allocatable, intent(out) :: error
        type(layered_exact_t), allocatable :: own

        if (.not. self%is_made) call check_made(error, "medium", self%is_made)
        if (allocated(error)) return
        allocate (own)
        call new_under_load(own, self, load, error)
        if (.not. allocated(error)) call move_alloc(own, other)
    end subroutine for_load

    !> The same bodies under another load; of two, their compliances add.
    subroutine new_under_load(medium, normal, load, error)
        type(layered_exact_t), intent(out) :: medium
        class(layered_exact_t), intent(in) :: normal
        integer, intent(in) :: load
        type(error_t), allocatable, intent(inout) :: error
        type(layered_exact_t) :: lower, upper

        if (allocated(normal%parts)) then
            call new_body_under_load(lower, normal%springs%tolerance, normal%pressed, normal%parts(lower_body)%share, load, error)
            if (allocated(error)) return
            call new_body_under_load(upper, normal%springs%tolerance, normal%counterbody, normal%parts(upper_body)%share, load, &
                                     error)
            if (.not. allocated(error)) call new_exact_pair(medium, lower, upper, error)
        else
            call new_body_under_load(medium, normal%springs%tolerance, normal%pressed, 1.0_wp, load, error)
        end if
        medium%is_made = .not. allocated(error)
    end subroutine new_under_load

    subroutine new_body_under_load(medium, tolerance, body, share, load, error)
        type(layered_exact_t), intent(out) :: medium
        class(body_t), allocatable, intent(in) :: body
        !> relative tolerance, and part of the compliance, 0 if the body is rigid
        real(wp), intent(in) :: tolerance, share
        integer, intent(in) :: load
        type(error_t), allocatable, intent(inout) :: error

        allocate (medium%springs)
        if (allocated(body)) then
            medium%springs%tolerance = tolerance
            call solve_body(medium, body, load, error)
        else if (share > 0.0_wp) then
            call raise(error, error_invalid, "medium: the tangential stiffness needs E and nu")
        else
            medium%springs%modulus = infinity
            medium%springs%tolerance = largest_tolerance
        end if
        medium%is_made = .not. allocated(error)
    end subroutine new_body_under_load

    subroutine slip(self, tangential, load, found, error)
        class(layered_exact_t), intent(in) :: self
        class(solver_t), intent(in) :: tangential
        class(load_t), intent(in) :: load
        class(slip_t), allocatable, intent(out) :: found
        type(error_t), allocatable, intent(out) :: error
        type(layered_slip_t), allocatable :: own
        type(line_load_t) :: springs
        real(wp), allocatable :: sheared(:)

        if (.not. self%is_made) call check_made(error, "medium", self%is_made)
        call check_made(error, "tangential", tangential%is_made)
        if (allocated(error)) return
        select type (load)
        class is (exact_load_t)
            call load%take_series(springs, error)
        class default
            call raise(error, error_invalid, "load: it does not belong to this medium")
        end select
        if (allocated(error)) return
        allocate (sheared, mold=springs%q)
        call springs%part_of(tangential%springs%kernel, sheared, error)
        if (allocated(error)) return
        allocate (own)
        call new_layered_slip(own, self, tangential, load%profile, springs, sheared, load%punch_depth, error)
        if (.not. allocated(error)) call move_alloc(own, found)
    end subroutine slip

end module mdrcontact_medium_exact
