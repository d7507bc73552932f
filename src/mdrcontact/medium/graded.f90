! SPDX-License-Identifier: GPL-3.0-or-later
!> Any depth dependence of the elastic constants by Gao's weights (theory 3; Popov 2014, equations (16)-(18)):
!>     nu_eff = int (dI1(z/a)/dz) nu(z) dz,    G_eff = int (dI0(z/a)/dz) G(z) dz   (or 1/G in series).
!>
!> The integrals are done once, when the medium is made, over a range of contact radii; afterwards E_eff(a) is an interpolation.
module mdrcontact_medium_graded
    use, intrinsic :: ieee_arithmetic, only: ieee_is_finite
    use mdrcontact_error, only: check_poisson, check_positive, check_table, entry_name, error_callback, error_invalid, error_t, &
                                raise, to_text
    use mdrcontact_gsl, only: disable_gsl_abort
    use mdrcontact_kinds, only: wp
    use mdrcontact_medium_effective, only: effective_medium_t
    use mdrcontact_medium_gao, only: gao_nu_effective, gao_options_t, i0_poisson_choice
    use mdrcontact_numerics_quadrature, only: gauss_legendre
    use mdrcontact_numerics_radius_law, only: new_radius_law_from_function, radius_law_t
    use mdrcontact_numerics_sampled_function, only: new_sampled_function, sampled_function_t
    use mdrcontact_numerics_scalar_function, only: scalar_function_t
    use mdrcontact_weights, only: weight_i0, weight_i0_slope, weight_i1, weight_i1_slope, weight_j0, weight_j1
    implicit none (type, external)
    private
    public :: graded_t, new_graded, new_graded_from_functions

    !> A graded half-space: E_eff(a), sampled.
    type, extends(effective_medium_t) :: graded_t
        private
        type(radius_law_t) :: law
    contains
        procedure :: effective_modulus
        procedure :: effective_modulus_slope
    end type graded_t

    !> E_eff(a) by quadrature over depth, z(1) < z < z(n); constant above and below.
    type, extends(scalar_function_t) :: average_t
        real(wp), allocatable :: z(:), dz(:), shear(:), poisson(:)
        real(wp) :: top_depth = 0.0_wp, bottom_depth = 0.0_wp
        real(wp) :: top_shear = 0.0_wp, top_poisson = 0.0_wp, bottom_shear = 0.0_wp, bottom_poisson = 0.0_wp
        type(gao_options_t) :: options
    contains
        procedure :: value => average_at
    end type average_t

    !> A user's function of depth, watched for values that are not numbers.
    type, extends(scalar_function_t) :: watched_function_t
        class(scalar_function_t), pointer :: f => null()
        character(len=2) :: name = ""
    contains
        procedure :: value => watched_value
    end type watched_function_t

    !> Range of contact radii around the depths of the gradient; outside, E_eff is that of the surface or of the bottom to rounding.
    real(wp), parameter :: range_factor = 1.0e13_wp
    real(wp), parameter :: sampling_tolerance = 1.0e-13_wp, function_tolerance = 1.0e-13_wp
    !> Nodes between two depths that differ by a factor 4 at most, and between neighbours in a fine table.
    integer, parameter :: wide_nodes = 20, narrow_nodes = 6
    !> Every panel of E(z) costs time at every radius of E_eff(a): functions that want more of them are not smooth.
    integer, parameter :: most_function_panels = 500, most_law_panels = 1000

contains

    !> E and nu at given depths, linear between them, constant below the last.
    subroutine new_graded(self, z, young, poisson, error, options)
        type(graded_t), intent(out) :: self
        !> ascending depths from z(1) = 0, at least 2; a thin interval makes a step [length]
        real(wp), intent(in) :: z(:)
        !> E > 0 [modulus] and -1 < nu <= 1/2, same size as z
        real(wp), intent(in) :: young(:), poisson(:)
        type(error_t), allocatable, intent(out) :: error
        type(gao_options_t), intent(in), optional :: options
        type(average_t) :: average
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
        call depth_nodes(average, z)
        allocate (average%shear, mold=average%z)
        allocate (average%poisson, mold=average%z)
        do i = 1, size(average%z)
            average%poisson(i) = linear(z, poisson, average%z(i))
            average%shear(i) = 0.5_wp*linear(z, young, average%z(i))/(1.0_wp + average%poisson(i))
        end do
        call finish(self, average, young(1), poisson(1), young(size(z)), poisson(size(z)), options, error)
    end subroutine new_graded

    !> E(z) and nu(z) as functions on [0, depth], constant below. They are called here and never again.
    subroutine new_graded_from_functions(self, young, poisson, depth, error, options)
        type(graded_t), intent(out) :: self
        !> E(z) > 0 [modulus] and -1 < nu(z) <= 1/2, smooth
        class(scalar_function_t), intent(inout), target :: young, poisson
        !> depth below which the body is homogeneous, > 0 [length]
        real(wp), intent(in) :: depth
        type(error_t), allocatable, intent(out) :: error
        type(gao_options_t), intent(in), optional :: options
        type(average_t) :: average
        type(watched_function_t) :: watched_young, watched_poisson
        type(sampled_function_t) :: e, nu
        real(wp), allocatable :: edges(:)
        real(wp) :: top_young, top_poisson
        integer :: i

        call check_positive(error, "depth", depth)
        if (allocated(error)) return
        watched_young%f => young
        watched_young%name = "E"
        watched_poisson%f => poisson
        watched_poisson%name = "nu"
        edges = [(depth*0.5_wp**i, i=40, 0, -1)]
        call new_sampled_function(e, watched_young, edges, spread(.false., 1, 40), function_tolerance, error, &
                                  most=most_function_panels)
        if (.not. allocated(error)) call new_sampled_function(nu, watched_poisson, edges, spread(.false., 1, 40), &
                                                              function_tolerance, error, noise=1.0e-15_wp, &
                                                              most=most_function_panels)
        if (allocated(error)) return
        call depth_nodes(average, [0.0_wp, e%panel_edges()])
        ! Above the first sample, depth*2^-40, both are constant: a polynomial must not be continued beyond its panel.
        allocate (average%shear, source=e%value(max(average%z, e%lower())))
        allocate (average%poisson, source=nu%value(max(average%z, nu%lower())))
        ! An incompressible body's 1/2 comes back from the interpolation with its rounding error.
        where (abs(average%poisson - 0.5_wp) < function_tolerance) average%poisson = 0.5_wp
        do i = 1, size(average%z)
            call check_positive(error, "E at z = "//to_text(average%z(i)), average%shear(i))
            call check_poisson(error, "nu at z = "//to_text(average%z(i)), average%poisson(i))
        end do
        if (allocated(error)) return
        average%shear = 0.5_wp*average%shear/(1.0_wp + average%poisson)
        top_young = young%value(0.0_wp)
        top_poisson = poisson%value(0.0_wp)
        if (allocated(young%error)) then
            error = young%error
        else if (allocated(poisson%error)) then
            error = poisson%error
        end if
        if (allocated(error)) return
        call finish(self, average, top_young, top_poisson, e%value(depth), nu%value(depth), options, error)
    end subroutine new_graded_from_functions

    !> Samples E_eff(a) over all radii at which it varies.
    subroutine finish(self, average, top_young, top_poisson, bottom_young, bottom_poisson, options, error)
        type(graded_t), intent(inout) :: self
        type(average_t), intent(inout) :: average
        real(wp), intent(in) :: top_young, top_poisson, bottom_young, bottom_poisson
        type(gao_options_t), intent(in), optional :: options
        type(error_t), allocatable, intent(out) :: error

        call disable_gsl_abort()
        call check_positive(error, "E at the surface", top_young)
        call check_poisson(error, "nu at the surface", top_poisson)
        if (present(options)) average%options = options
        call i0_poisson_choice(average%options, top_poisson, bottom_poisson, error)
        if (allocated(error)) return
        average%top_poisson = top_poisson
        average%bottom_poisson = bottom_poisson
        average%top_shear = 0.5_wp*top_young/(1.0_wp + top_poisson)
        average%bottom_shear = 0.5_wp*bottom_young/(1.0_wp + bottom_poisson)
        call new_radius_law_from_function(self%law, average, "the effective modulus", average%top_depth, &
                                          average%bottom_depth*range_factor, sampling_tolerance, error, most_law_panels)
    end subroutine finish

    elemental function effective_modulus(self, a) result(value)
        class(graded_t), intent(in) :: self
        real(wp), intent(in) :: a
        real(wp) :: value

        value = self%law%at(a)
    end function effective_modulus

    elemental function effective_modulus_slope(self, a) result(value)
        class(graded_t), intent(in) :: self
        real(wp), intent(in) :: a
        real(wp) :: value

        value = self%law%slope_at(a)
    end function effective_modulus_slope

    !> Nodes in depth on panels that never cross an entry of z and grow by 4 from the surface.
    subroutine depth_nodes(average, z)
        type(average_t), intent(inout) :: average
        real(wp), intent(in) :: z(:)
        real(wp) :: t(wide_nodes), w(wide_nodes), t6(narrow_nodes), w6(narrow_nodes), from, to
        real(wp), allocatable :: nodes(:), weights(:)
        integer :: i

        call gauss_legendre(t, w)
        call gauss_legendre(t6, w6)
        average%top_depth = z(2)/range_factor
        average%bottom_depth = z(size(z))
        allocate (nodes(0), weights(0))
        from = average%top_depth
        do i = 2, size(z)
            do while (from < z(i))
                to = min(4.0_wp*from, z(i))
                if (to > 1.3_wp*from) then
                    nodes = [nodes, from + (to - from)*t]
                    weights = [weights, (to - from)*w]
                else
                    nodes = [nodes, from + (to - from)*t6]
                    weights = [weights, (to - from)*w6]
                end if
                from = to
            end do
        end do
        call move_alloc(nodes, average%z)
        call move_alloc(weights, average%dz)
    end subroutine depth_nodes

    function average_at(self, x) result(y)
        class(average_t), intent(inout) :: self
        real(wp), intent(in) :: x
        real(wp) :: y
        real(wp) :: nu, weight_nu, shear, top, bottom

        top = self%top_depth/x
        bottom = self%bottom_depth/x
        nu = sum(weight_i1_slope(self%z/x)*(self%dz/x)*self%poisson) + weight_i1(top)*self%top_poisson &
             + weight_j1(bottom)*self%bottom_poisson
        weight_nu = merge(nu, self%options%weight_nu, self%options%weight_nu_choice == gao_nu_effective)
        if (self%options%in_series) then
            shear = 1.0_wp/(sum(weight_i0_slope(self%z/x, weight_nu)*(self%dz/x)/self%shear) &
                            + weight_i0(top, weight_nu)/self%top_shear + weight_j0(bottom, weight_nu)/self%bottom_shear)
        else
            shear = sum(weight_i0_slope(self%z/x, weight_nu)*(self%dz/x)*self%shear) &
                    + weight_i0(top, weight_nu)*self%top_shear + weight_j0(bottom, weight_nu)*self%bottom_shear
        end if
        y = 2.0_wp*shear/(1.0_wp - nu)
    end function average_at

    pure function linear(z, values, at) result(value)
        real(wp), intent(in) :: z(:), values(:), at
        real(wp) :: value
        integer :: low, high, middle

        low = 1
        high = size(z)
        do while (high - low > 1)
            middle = (low + high)/2
            if (at < z(middle)) then
                high = middle
            else
                low = middle
            end if
        end do
        value = values(low) + (values(high) - values(low))*((at - z(low))/(z(high) - z(low)))
    end function linear

    function watched_value(self, x) result(y)
        class(watched_function_t), intent(inout) :: self
        real(wp), intent(in) :: x
        real(wp) :: y

        y = self%f%value(x)
        if (allocated(self%f%error)) then
            self%error = self%f%error
        else if (.not. ieee_is_finite(y)) then
            call raise(self%error, error_callback, "the function for "//trim(self%name)//" returned "//to_text(y)//" at z = "// &
                       to_text(x)//": it must return a finite number")
        end if
    end function watched_value

end module mdrcontact_medium_graded
