! SPDX-License-Identifier: GPL-3.0-or-later
!> A body with E(z) and nu(z) varying with depth: its constants at any depth, and sublayers that thin towards the surface.
module mdrcontact_body_graded
    use, intrinsic :: iso_fortran_env, only: int64
    use mdrcontact_object, only: real_bytes
    use mdrcontact_parameter, only: nature_poisson, parameter_t
    use mdrcontact_body, only: body_t, copy
    use mdrcontact_body_compliance, only: compliance_t, normal_load
    use mdrcontact_body_gradation, only: gradation_t, new_gradation, nodes
    use mdrcontact_body_layers, only: layers_t
    use mdrcontact_body_sublayers, only: sublayer_ends
    use mdrcontact_error, only: check_made, check_memory, check_poisson, check_positive, check_table, count_text, error_invalid, &
                                error_t, raise, to_text
    use mdrcontact_gsl, only: disable_gsl_abort
    use mdrcontact_kinds, only: wp
    use mdrcontact_material, only: material_t
    use mdrcontact_numerics_quadrature, only: merge_breaks, new_antiderivative
    use mdrcontact_numerics_sampled_function, only: new_sampled_function, sampled_function_t
    use mdrcontact_numerics_scalar_function, only: scalar_function_t, watched_function_t
    use mdrcontact_numerics_search, only: interval_of
    implicit none (type, external)
    private
    public :: graded_body_t, new_graded_body, new_graded_body_from_functions

    !> Octaves of depth above the first entry of a table, and in the range of a function, before the homogeneous top.
    integer, parameter :: table_octaves = 30, function_octaves = 50
    real(wp), parameter :: function_tolerance = 1.0e-13_wp
    !> Functions that need more panels than this are not smooth.
    integer, parameter :: most_panels = 500

    !> A graded half-space.
    type, extends(body_t) :: graded_body_t
        private
        !> E and nu at depths z, or as functions
        real(wp), allocatable :: z(:), young(:), poisson(:)
        type(sampled_function_t), allocatable :: young_of, poisson_of
        !> depths of the sublayers' ends, 0 first [length]
        real(wp), allocatable :: ends(:)
    contains
        procedure :: moduli
        procedure :: add_breaks
        procedure :: compliance => surface_compliance
        procedure :: sublayers
        procedure :: parameters
        procedure :: with_parameters
        procedure :: bytes
    end type graded_body_t

contains

    !> E and nu at given depths, linear between them, constant below the last.
    subroutine new_graded_body(self, z, young, poisson, error)
        type(graded_body_t), intent(out) :: self
        !> ascending depths from z(1) = 0, at least 2; a thin interval makes a step [length]
        real(wp), intent(in) :: z(:)
        !> E > 0 [modulus] and -1 < nu <= 1/2, same size as z
        real(wp), intent(in) :: young(:), poisson(:)
        type(error_t), allocatable, intent(out) :: error
        integer :: i, stat

        call check_table(error, "z", z, "E", young, 2)
        call check_table(error, "z", z, "nu", poisson, 2)
        if (allocated(error)) return
        if (z(1) /= 0.0_wp) call raise(error, error_invalid, " = "//to_text(z(1))//": depths must start at the surface, z = 0", &
                                       "z", 1)
        do i = 1, size(z)
            call check_positive(error, "E", young(i), i)
            call check_poisson(error, "nu", poisson(i), i)
        end do
        if (allocated(error)) return
        allocate (self%z(size(z)), self%young(size(z)), self%poisson(size(z)), stat=stat)
        call check_memory(error, stat)
        if (stat /= 0) return
        self%z(:) = z
        self%young(:) = young
        self%poisson(:) = poisson
        ! a homogeneous top is one sublayer
        do i = 1, size(z) - 1
            if (young(i + 1) /= young(1) .or. poisson(i + 1) /= poisson(1)) exit
        end do
        call build(self, merge(z(i), scale(z(2), -table_octaves), i > 1), error)
        self%is_made = .not. allocated(error)
    end subroutine new_graded_body

    !> Depth, E and nu of each point of its table; none of functions.
    pure subroutine parameters(self, list)
        class(graded_body_t), intent(in) :: self
        type(parameter_t), allocatable, intent(out) :: list(:)
        character(len=:), allocatable :: at
        integer :: i

        i = 0
        if (allocated(self%z)) i = size(self%z)
        allocate (list(3*i))
        do i = 1, size(list)/3
            at = "["//count_text(i - 1)//"]"
            list(3*i - 2:3*i) = [parameter_t("z"//at, self%z(i)), parameter_t("E"//at, self%young(i)), &
                                 parameter_t("nu"//at, self%poisson(i), nature_poisson)]
        end do
    end subroutine parameters

    subroutine with_parameters(self, values, body, error)
        class(graded_body_t), intent(in) :: self
        real(wp), intent(in) :: values(:)
        class(body_t), allocatable, intent(out) :: body
        type(error_t), allocatable, intent(out) :: error
        type(graded_body_t), allocatable :: graded

        call check_made(error, "body", self%is_made)
        if (allocated(error)) return
        if (.not. allocated(self%z)) then
            call copy(self, body, error)
            return
        end if
        allocate (graded)
        call new_graded_body(graded, values(1::3), values(2::3), values(3::3), error)
        call move_alloc(graded, body)
    end subroutine with_parameters

    pure recursive function bytes(self)
        class(graded_body_t), intent(in) :: self
        integer(int64) :: bytes

        bytes = real_bytes*size(self%ends)
        if (allocated(self%z)) bytes = bytes + 3*real_bytes*size(self%z)
    end function bytes

    !> E(z) and nu(z) as functions on 0 < z <= depth, constant below. They are called here and never again.
    subroutine new_graded_body_from_functions(self, young, poisson, depth, error)
        type(graded_body_t), intent(out) :: self
        !> E(z) > 0 [modulus] and -1 < nu(z) <= 1/2, smooth: peaks narrower than 0.5 % of the depth may be missed
        class(scalar_function_t), intent(inout), target :: young, poisson
        !> depth below which the body is homogeneous, > 0 [length]
        real(wp), intent(in) :: depth
        type(error_t), allocatable, intent(out) :: error
        type(watched_function_t) :: watched(2)
        real(wp) :: edges(function_octaves + 1), shear, nu
        real(wp), allocatable :: depths(:)
        integer :: i

        call check_positive(error, "depth", depth)
        if (allocated(error)) return
        call disable_gsl_abort()
        edges = [(scale(depth, i - function_octaves), i=0, function_octaves)]
        watched%name = [character(len=16) :: "function for E", "function for nu"]
        watched%argument = "z"
        watched(1)%f => young
        watched(2)%f => poisson
        allocate (self%young_of, self%poisson_of)
        call new_sampled_function(self%young_of, watched(1), edges, spread(.false., 1, function_octaves), function_tolerance, &
                                  error, most=most_panels, everywhere=.true.)
        if (.not. allocated(error)) call new_sampled_function(self%poisson_of, watched(2), edges, &
                                                              spread(.false., 1, function_octaves), function_tolerance, error, &
                                                              noise=1.0e-15_wp, most=most_panels, &
                                                              everywhere=.true.)
        if (allocated(error)) return
        call self%add_breaks(depths, error)
        do i = 1, size(depths)
            call self%moduli(depths(i), shear, nu)
            call check_positive(error, "E at z = "//to_text(depths(i)), 2.0_wp*shear*(1.0_wp + nu))
            call check_poisson(error, "nu at z = "//to_text(depths(i)), nu)
        end do
        if (.not. allocated(error)) call build(self, edges(1), error)
        self%is_made = .not. allocated(error)
    end subroutine new_graded_body_from_functions

    !> Adds to ascending depths those between which the constants are analytic; beyond the last they are constant [length].
    pure subroutine add_breaks(self, depths, error)
        class(graded_body_t), intent(in) :: self
        !> ascending [length]; not allocated: none yet
        real(wp), allocatable, intent(inout) :: depths(:)
        type(error_t), allocatable, intent(inout) :: error

        if (allocated(self%z)) then
            call merge_breaks(depths, self%z(2:), error)
        else
            call merge_breaks(depths, self%young_of%edges, error)
            call merge_breaks(depths, self%poisson_of%edges, error)
        end if
    end subroutine add_breaks

    !> G [modulus] and nu at depth z >= 0.
    pure subroutine moduli(self, z, shear, poisson)
        class(graded_body_t), intent(in) :: self
        !> depth, at least 0 [length]
        real(wp), intent(in) :: z
        !> G [modulus] and nu [1] there
        real(wp), intent(out) :: shear, poisson
        real(wp) :: young, fraction
        integer :: i

        if (allocated(self%z)) then
            i = interval_of(self%z, z)
            fraction = min((z - self%z(i))/(self%z(i + 1) - self%z(i)), 1.0_wp)
            young = self%young(i) + fraction*(self%young(i + 1) - self%young(i))
            poisson = self%poisson(i) + fraction*(self%poisson(i + 1) - self%poisson(i))
        else
            ! a polynomial must not be continued beyond its panel
            young = self%young_of%value(min(max(z, self%young_of%lower()), self%young_of%upper()))
            poisson = self%poisson_of%value(min(max(z, self%poisson_of%lower()), self%poisson_of%upper()))
            ! an incompressible body's 1/2 comes back from the interpolation with its rounding error
            if (abs(poisson - 0.5_wp) < function_tolerance) poisson = 0.5_wp
        end if
        shear = 0.5_wp*young/(1.0_wp + poisson)
    end subroutine moduli

    !> Sublayers from a homogeneous one of thickness `first` down to the last knot, split at each; the numbers that every body has.
    subroutine build(self, first, error)
        type(graded_body_t), intent(inout) :: self
        real(wp), intent(in) :: first
        type(error_t), allocatable, intent(inout) :: error
        real(wp) :: antiderivative(nodes + 1, nodes), t(nodes), shear(nodes), nu(nodes), g, v
        real(wp), allocatable :: knots(:)
        integer :: i, n

        call self%add_breaks(knots, error)
        call new_antiderivative(t, antiderivative, error)
        if (.not. allocated(error)) call sublayer_ends(self, first, knots, t, antiderivative(nodes + 1, :), self%ends, error)
        if (allocated(error)) return
        n = size(self%ends) - 1
        call self%moduli(0.5_wp*first, g, v)
        self%surface_material = material_t(2.0_wp*g*(1.0_wp + v), v)
        self%surface_modulus = 2.0_wp*g/(1.0_wp - v)
        self%softest = self%surface_material%young
        self%stiffest = self%softest
        do i = 2, n
            call constants_in(self, i, t, shear, nu)
            self%softest = min(self%softest, minval(2.0_wp*shear*(1.0_wp + nu)))
            self%stiffest = max(self%stiffest, maxval(2.0_wp*shear*(1.0_wp + nu)))
        end do
        call self%moduli(self%ends(n + 1), g, v)
        self%long_wave_limit = self%surface_modulus*(1.0_wp - v)/(2.0_wp*g)
        self%first_depth = self%ends(2)
        self%last_depth = self%ends(n + 1)
        self%is_graded = .true.
    end subroutine build

    !> G and nu at nodes of a sublayer; the first one is homogeneous.
    pure subroutine constants_in(self, sublayer, t, shear, poisson)
        class(graded_body_t), intent(in) :: self
        integer, intent(in) :: sublayer
        !> parts of its thickness
        real(wp), intent(in) :: t(:)
        real(wp), intent(out) :: shear(:), poisson(:)
        integer :: j

        do j = 1, size(t)
            associate (top => self%ends(sublayer), bottom => self%ends(sublayer + 1))
                call self%moduli(merge(0.5_wp*bottom, top + (bottom - top)*t(j), sublayer == 1), shear(j), poisson(j))
            end associate
        end do
    end subroutine constants_in

    subroutine surface_compliance(self, load, compliance, error)
        class(graded_body_t), intent(in) :: self
        integer, intent(in) :: load
        class(compliance_t), allocatable, intent(out) :: compliance
        type(error_t), allocatable, intent(inout) :: error
        type(gradation_t), allocatable :: own
        real(wp), allocatable :: shear(:, :), poisson(:, :), end_shear(:), end_poisson(:)
        real(wp) :: antiderivative(nodes + 1, nodes), t(nodes)
        integer :: i, n, stat

        call check_made(error, "body", self%is_made)
        if (allocated(error)) return
        n = size(self%ends) - 1
        call new_antiderivative(t, antiderivative, error)
        if (allocated(error)) return
        allocate (own)
        allocate (shear(nodes, n), poisson(nodes, n), end_shear(n), end_poisson(n), stat=stat)
        call check_memory(error, stat)
        if (stat /= 0) return
        do i = 1, n
            call constants_in(self, i, t, shear(:, i), poisson(:, i))
            call self%moduli(self%ends(i + 1), end_shear(i), end_poisson(i))
        end do
        call new_gradation(own, load, self%ends, shear, poisson, end_shear, end_poisson, error)
        if (load == normal_load) own%at_zero = self%long_wave_limit
        call move_alloc(own, compliance)
    end subroutine surface_compliance

    !> None.
    pure subroutine sublayers(self, layers, error)
        class(graded_body_t), intent(in) :: self
        type(layers_t), intent(out) :: layers
        type(error_t), allocatable, intent(inout) :: error

        call check_made(error, "body", self%is_made)
        if (allocated(error)) return
        associate (unused => self)
        end associate
        layers%rigid_base = .false.
        call raise(error, error_invalid, "body: a graded body has no layers, so energies and largest stresses of layers are "// &
                   "not available. Use interior for its stresses")
    end subroutine sublayers

end module mdrcontact_body_graded
