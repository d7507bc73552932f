! SPDX-License-Identifier: GPL-3.0-or-later
!> A body with E(z) and nu(z) varying with depth, as a surface compliance: sublayers that thin towards the surface, each with
!> its gradient.
!>
!> Below the first, homogeneous sublayer (a negligible fraction of the gradient's depth) sublayers take a tenth of their
!> depth, so that any wavelength sees
!> the same number of them: those shallower than it through one power series, some forty more one by one.
module mdrcontact_layered_graded
    use mdrcontact_error, only: check_poisson, check_positive, check_table, entry_name, error_invalid, error_t, raise, to_text
    use mdrcontact_kinds, only: wp
    use mdrcontact_layered_gradient, only: gradient_series, multiply_series, new_antiderivative, order, series_value
    use mdrcontact_layered_modes, only: half_space_compliance, layer_modes_t, new_layer_modes, reflected_part, transferred
    use mdrcontact_layered_rule, only: new_rule, rule_t
    use mdrcontact_layered_surface, only: surface_t
    use mdrcontact_numerics_sampled_function, only: new_sampled_function, sampled_function_t
    use mdrcontact_numerics_scalar_function, only: scalar_function_t
    implicit none (type, external)
    private
    public :: graded_surface_t, new_graded_surface, new_graded_surface_from_functions

    !> Growth of depth from one sublayer to the next, and the largest ratio of shear moduli within one.
    real(wp), parameter :: growth = 1.1_wp, largest_ratio = 1.3_wp
    integer, parameter :: nodes = 10
    !> Waves see sublayers through one series while k times their depth is at most `longest`, and nothing below `deepest`/k.
    real(wp), parameter :: longest = 0.5_wp, deepest = 25.0_wp
    !> Octaves of depth above the first entry of a table, and in the range of a function, before the homogeneous top.
    integer, parameter :: table_octaves = 30, function_octaves = 50
    real(wp), parameter :: function_tolerance = 1.0e-13_wp

    !> The surface compliance of a graded half-space.
    type, extends(surface_t) :: graded_surface_t
        private
        !> depths of the sublayers' ends, 0 first [length]
        real(wp), allocatable :: ends(:)
        !> series of each sublayer's transfer matrix, and of all from the surface to its end (4, 4, 0:order, sublayer)
        real(wp), allocatable :: series(:, :, :, :), from_surface(:, :, :, :)
        !> compliance of a half-space of the material at each end, relative to 1/(2 G) of the surface (2, 2, end)
        real(wp), allocatable :: local(:, :, :)
        type(layer_modes_t) :: top
        real(wp) :: contact_modulus = 0.0_wp, sigma_zero = 0.0_wp
    contains
        procedure :: response
        procedure :: surface_modulus
        procedure :: long_wave_limit
        procedure :: first_depth
        procedure :: last_depth
        procedure :: ratios
    end type graded_surface_t

    !> G(z) and nu(z), from a table or from sampled functions.
    type :: constants_t
        real(wp), allocatable :: z(:), young(:), poisson(:)
        type(sampled_function_t) :: young_of, poisson_of
        logical :: is_table = .true.
    contains
        procedure :: at => constants_at
    end type constants_t

contains

    !> E and nu at given depths, linear between them, constant below the last.
    subroutine new_graded_surface(self, z, young, poisson, error)
        type(graded_surface_t), intent(out) :: self
        !> ascending depths from z(1) = 0, at least 2; a thin interval makes a step [length]
        real(wp), intent(in) :: z(:)
        !> E > 0 [modulus] and -1 < nu <= 1/2, same size as z
        real(wp), intent(in) :: young(:), poisson(:)
        type(error_t), allocatable, intent(out) :: error
        type(constants_t) :: constants
        integer :: i

        call check_table(error, "z", z, "E", young, 2)
        call check_table(error, "z", z, "nu", poisson, 2)
        if (allocated(error)) return
        if (z(1) /= 0.0_wp) call raise(error, error_invalid, entry_name("z", 1)//" = "//to_text(z(1))// &
                                       " is not allowed: depths start at the surface, z = 0")
        do i = 1, size(z)
            call check_positive(error, entry_name("E", i), young(i))
            call check_poisson(error, entry_name("nu", i), poisson(i))
        end do
        if (allocated(error)) return
        allocate (constants%z, source=z)
        allocate (constants%young, source=young)
        allocate (constants%poisson, source=poisson)
        call build(self, constants, scale(z(2), -table_octaves), z(2:))
    end subroutine new_graded_surface

    !> E(z) and nu(z) as functions on [0, depth], constant below. They are called here and never again.
    subroutine new_graded_surface_from_functions(self, young, poisson, depth, error)
        type(graded_surface_t), intent(out) :: self
        !> E(z) > 0 [modulus] and -1 < nu(z) <= 1/2, smooth
        class(scalar_function_t), intent(inout) :: young, poisson
        !> depth below which the body is homogeneous, > 0 [length]
        real(wp), intent(in) :: depth
        type(error_t), allocatable, intent(out) :: error
        type(constants_t) :: constants
        real(wp) :: edges(function_octaves + 1), shear, nu
        integer :: i

        call check_positive(error, "depth", depth)
        if (allocated(error)) return
        edges = [(scale(depth, i - function_octaves), i=0, function_octaves)]
        call new_sampled_function(constants%young_of, young, edges, spread(.false., 1, function_octaves), function_tolerance, error)
        if (.not. allocated(error)) call new_sampled_function(constants%poisson_of, poisson, edges, &
                                                              spread(.false., 1, function_octaves), function_tolerance, error, &
                                                              noise=1.0e-15_wp)
        if (allocated(error)) return
        constants%is_table = .false.
        edges = constants%young_of%value(edges)
        do i = 1, size(edges)
            call check_positive(error, "E of the graded body", edges(i))
        end do
        edges = [(scale(depth, i - function_octaves), i=0, function_octaves)]
        do i = 1, size(edges)
            call constants%at(edges(i), shear, nu)
            call check_poisson(error, "nu of the graded body", nu)
        end do
        if (allocated(error)) return
        call build(self, constants, edges(1), constants%young_of%panel_edges())
    end subroutine new_graded_surface_from_functions

    !> Sublayers from a homogeneous one of thickness `first` down to the last of `knots`, split at each of these.
    subroutine build(self, constants, first, knots)
        type(graded_surface_t), intent(inout) :: self
        type(constants_t), intent(in) :: constants
        real(wp), intent(in) :: first
        !> ascending
        real(wp), intent(in) :: knots(:)
        type(rule_t) :: rule
        real(wp) :: antiderivative(nodes + 1, nodes), surface_shear, surface_nu, shear(nodes), nu(nodes), g, v
        integer :: i, j, n

        call sublayer_ends(constants, first, knots, self%ends)
        n = size(self%ends) - 1
        allocate (self%series(4, 4, 0:order, n), self%from_surface(4, 4, 0:order, n), self%local(2, 2, n))
        rule = new_rule(nodes)
        antiderivative = new_antiderivative(rule)
        call constants%at(0.5_wp*first, surface_shear, surface_nu)
        self%top = new_layer_modes(surface_nu)
        self%contact_modulus = 2.0_wp*surface_shear/(1.0_wp - surface_nu)
        do i = 1, n
            do j = 1, nodes
                call constants%at(self%ends(i) + (self%ends(i + 1) - self%ends(i))*rule%nodes(j), shear(j), nu(j))
            end do
            if (i == 1) shear = surface_shear
            if (i == 1) nu = surface_nu
            call gradient_series(antiderivative, self%ends(i + 1) - self%ends(i), shear/surface_shear, nu, self%series(:, :, :, i))
            self%from_surface(:, :, :, i) = self%series(:, :, :, i)
            if (i > 1) then
                self%from_surface(:, :, :, i) = self%from_surface(:, :, :, i - 1)
                call multiply_series(self%from_surface(:, :, :, i), self%series(:, :, :, i))
            end if
            call constants%at(self%ends(i + 1), g, v)
            self%local(:, :, i) = half_space_compliance(v)*(surface_shear/g)
        end do
        self%sigma_zero = self%contact_modulus*(1.0_wp - v)/(2.0_wp*g)
    end subroutine build

    subroutine sublayer_ends(constants, first, knots, ends)
        type(constants_t), intent(in) :: constants
        real(wp), intent(in) :: first, knots(:)
        real(wp), allocatable, intent(out) :: ends(:)
        real(wp) :: here, next, shear, shear_next, nu
        integer :: i

        allocate (ends(2))
        ends(:) = [0.0_wp, first]
        here = first
        do i = 1, size(knots)
            do while (here < knots(i))
                next = min(here*growth, knots(i))
                if (knots(i) - next < 0.3_wp*(next - here)) next = knots(i)
                call constants%at(here, shear, nu)
                do
                    call constants%at(next, shear_next, nu)
                    if (max(shear/shear_next, shear_next/shear) <= largest_ratio) exit
                    if (next <= here*(1.0_wp + 8.0_wp*epsilon(1.0_wp))) exit
                    next = here + 0.5_wp*(next - here)
                end do
                ends = [ends, next]
                here = next
            end do
        end do
    end subroutine sublayer_ends

    !> The compliance carried up from where waves end, or from the homogeneous body below.
    pure subroutine response(self, k, sigma, chi)
        class(graded_surface_t), intent(in) :: self
        complex(wp), intent(in) :: k
        complex(wp), intent(out) :: sigma, chi
        complex(wp) :: compliance(2, 2)
        real(wp) :: scale
        integer :: i, start, seen

        start = min(count(self%ends(2:)*real(k, wp) <= deepest) + 1, size(self%ends) - 1)
        seen = min(count(self%ends(2:)*abs(k) <= longest), start)
        compliance = self%local(:, :, start)
        do i = start, max(seen, 1) + 1, -1
            compliance = transferred(series_value(self%series(:, :, :, i), k), compliance)
        end do
        scale = real(self%top%half_space(2, 2), wp)
        if (seen > 0) then
            compliance = transferred(series_value(self%from_surface(:, :, :, seen), k), compliance)
            sigma = compliance(2, 2)/scale
            chi = sigma - 1.0_wp
        else
            compliance = reflected_part(self%top, k*self%ends(2), compliance)
            chi = compliance(2, 2)/scale
            sigma = 1.0_wp + chi
        end if
    end subroutine response

    !> G and nu at depth z.
    pure subroutine constants_at(self, z, shear, poisson)
        class(constants_t), intent(in) :: self
        real(wp), intent(in) :: z
        real(wp), intent(out) :: shear, poisson
        real(wp) :: young, fraction
        integer :: i

        if (self%is_table) then
            i = min(max(count(self%z <= z), 1), size(self%z) - 1)
            fraction = min((z - self%z(i))/(self%z(i + 1) - self%z(i)), 1.0_wp)
            young = self%young(i) + fraction*(self%young(i + 1) - self%young(i))
            poisson = self%poisson(i) + fraction*(self%poisson(i + 1) - self%poisson(i))
        else
            young = self%young_of%value(max(z, self%young_of%lower()))
            poisson = self%poisson_of%value(max(z, self%poisson_of%lower()))
        end if
        shear = 0.5_wp*young/(1.0_wp + poisson)
    end subroutine constants_at

    pure function surface_modulus(self) result(value)
        class(graded_surface_t), intent(in) :: self
        real(wp) :: value

        value = self%contact_modulus
    end function surface_modulus

    pure function long_wave_limit(self) result(value)
        class(graded_surface_t), intent(in) :: self
        real(wp) :: value

        value = self%sigma_zero
    end function long_wave_limit

    pure function first_depth(self) result(value)
        class(graded_surface_t), intent(in) :: self
        real(wp) :: value

        value = self%ends(2)
    end function first_depth

    pure function last_depth(self) result(value)
        class(graded_surface_t), intent(in) :: self
        real(wp) :: value

        value = self%ends(size(self%ends))
    end function last_depth

    pure function ratios(self) result(values)
        class(graded_surface_t), intent(in) :: self
        real(wp), allocatable :: values(:)

        associate (unused => self)
        end associate
        allocate (values(0))
    end function ratios

end module mdrcontact_layered_graded
