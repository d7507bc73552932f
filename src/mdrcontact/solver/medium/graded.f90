! SPDX-License-Identifier: GPL-3.0-or-later
!> Any depth dependence of the elastic constants by Gao's weights (theory/paper.md (3.6), (3.7); Popov 2014, equations (16)-(18)):
!>     nu_eff = int (dI1(z/a)/dz) nu(z) dz,    G_eff = int (dI0(z/a)/dz) G(z) dz   (or another power mean of G).
!>
!> The integrals are done once, when the medium is made, over a range of contact radii; afterwards E_eff(a) is an interpolation.
module mdrcontact_medium_graded
    use, intrinsic :: iso_fortran_env, only: int64
    use mdrcontact_body, only: body_t
    use mdrcontact_body_compliance, only: shear_load
    use mdrcontact_body_sublayers, only: is_integrated_by
    use mdrcontact_cancel, only: check_cancelled
    use mdrcontact_error, only: check_made, check_memory, error_invalid, error_t, raise
    use mdrcontact_gsl, only: disable_gsl_abort
    use mdrcontact_kinds, only: wp
    use mdrcontact_medium_solver, only: refuse_load, solver_t
    use mdrcontact_medium_effective, only: effective_medium_t
    use mdrcontact_medium_gao, only: gao_nu_effective, gao_options_t, i0_poisson_choice
    use mdrcontact_numerics_power_mean, only: new_power_mean, power_mean_t
    use mdrcontact_numerics_quadrature, only: gauss_legendre
    use mdrcontact_numerics_radius_law, only: new_radius_law_from_function, radius_law_t
    use mdrcontact_numerics_scalar_function, only: scalar_function_t
    use mdrcontact_weights, only: weight_i0, weight_i0_slope, weight_i0_tangential, weight_i0_tangential_slope, weight_i1, &
                                  weight_i1_slope, weight_j0, weight_j0_tangential, weight_j1
    implicit none (type, external)
    private
    public :: graded_t, new_graded

    !> A graded half-space: E_eff(a), sampled.
    type, extends(effective_medium_t) :: graded_t
        private
        type(radius_law_t) :: law
        type(gao_options_t) :: options
    contains
        procedure :: effective_modulus
        procedure :: effective_modulus_slope
        procedure :: for_load
        procedure :: bytes
    end type graded_t

    !> E_eff(a) by quadrature over depth, z(1) < z < z(n); constant above and below.
    type, extends(scalar_function_t) :: average_t
        !> G as the mean takes it, and nu
        real(wp), allocatable :: z(:), dz(:), shear(:), poisson(:)
        type(power_mean_t) :: mean
        real(wp) :: top_depth = 0.0_wp, bottom_depth = 0.0_wp
        real(wp) :: top_shear = 0.0_wp, top_poisson = 0.0_wp, bottom_shear = 0.0_wp, bottom_poisson = 0.0_wp
        type(gao_options_t) :: options
        !> whether it is the modulus under a load along the surface
        logical :: under_shear = .false.
    contains
        procedure :: value => average_at
    end type average_t

    !> Range of contact radii around the depths of the gradient, times the contrast; outside, E_eff is that of the surface or of the
    !> bottom to machine precision.
    real(wp), parameter :: range_factor = 1.0e13_wp
    real(wp), parameter :: sampling_tolerance = 1.0e-13_wp
    !> Nodes between two depths that differ by a factor 4 at most, and between neighbours in a fine table.
    integer, parameter :: wide_nodes = 20, narrow_nodes = 6
    integer, parameter :: most_law_panels = 1000

contains

    !> A graded body by Gao's weights.
    subroutine new_graded(self, body, error, options, under_shear)
        type(graded_t), intent(out) :: self
        class(body_t), intent(in) :: body
        type(error_t), allocatable, intent(out) :: error
        type(gao_options_t), intent(in), optional :: options
        !> G_t instead of E_eff; default false
        logical, intent(in), optional :: under_shear
        type(average_t) :: average
        real(wp), allocatable :: knots(:)
        integer :: i, stat

        call check_made(error, "body", body%is_made)
        if (allocated(error)) return
        call disable_gsl_abort()
        call body%add_breaks(knots, error)
        if (allocated(error)) return
        average%top_depth = knots(1)/(range_factor*contrast(body, knots))
        average%bottom_depth = knots(size(knots))
        call depth_nodes(average, body, knots, error)
        if (allocated(error)) return
        allocate (average%shear(size(average%z)), average%poisson(size(average%z)), stat=stat)
        call check_memory(error, stat)
        if (allocated(error)) return
        do i = 1, size(average%z)
            call body%moduli(average%z(i), average%shear(i), average%poisson(i))
        end do
        call body%moduli(0.0_wp, average%top_shear, average%top_poisson)
        call body%moduli(average%bottom_depth, average%bottom_shear, average%bottom_poisson)
        if (present(options)) average%options = options
        if (present(under_shear)) average%under_shear = under_shear
        self%options = average%options
        call i0_poisson_choice(average%options, average%top_poisson, average%bottom_poisson, error)
        call new_power_mean(average%mean, average%options%exponent, &
                            [min(average%top_shear, minval(average%shear), average%bottom_shear), &
                             max(average%top_shear, maxval(average%shear), average%bottom_shear)], error)
        if (allocated(error)) return
        do i = 1, size(average%shear)
            average%shear(i) = average%mean%transformed(average%shear(i))
        end do
        average%top_shear = average%mean%transformed(average%top_shear)
        average%bottom_shear = average%mean%transformed(average%bottom_shear)
        ! E_eff(a) at all radii at which it varies
        call new_radius_law_from_function(self%law, average, "the effective modulus", average%top_depth, &
                                          average%bottom_depth*(knots(1)/average%top_depth), sampling_tolerance, error, &
                                          most_law_panels)
        self%is_made = .not. allocated(error)
    end subroutine new_graded

    !> The ratio of the largest to the smallest G at the knots.
    pure function contrast(body, knots) result(ratio)
        class(body_t), intent(in) :: body
        real(wp), intent(in) :: knots(:)
        real(wp) :: ratio
        real(wp) :: shear, nu, least, most
        integer :: i

        call body%moduli(0.0_wp, least, nu)
        most = least
        do i = 1, size(knots)
            call body%moduli(knots(i), shear, nu)
            least = min(least, shear)
            most = max(most, shear)
        end do
        ratio = most/least
    end function contrast

    !> The same body, under shear.
    subroutine for_load(self, load, other, error)
        class(graded_t), intent(in) :: self
        integer, intent(in) :: load
        class(solver_t), allocatable, intent(out) :: other
        type(error_t), allocatable, intent(out) :: error
        type(graded_t), allocatable :: own

        if (.not. self%is_made) call check_made(error, "medium", self%is_made)
        if (allocated(error)) return
        if (load /= shear_load) then
            call refuse_load(self, load, error)
            return
        end if
        allocate (own)
        if (allocated(self%pressed)) then
            call new_graded(own, self%pressed, error, self%options, under_shear=.true.)
        else
            call raise(error, error_invalid, "medium: its tangential stiffness is not available")
        end if
        if (.not. allocated(error)) call move_alloc(own, other)
    end subroutine for_load

    pure recursive function bytes(self)
        class(graded_t), intent(in) :: self
        integer(int64) :: bytes

        bytes = self%law%bytes()
        if (allocated(self%pressed)) bytes = bytes + self%pressed%bytes()
    end function bytes

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

    !> Nodes in depth on panels that never cross a knot, grow by 4 from the surface at most, and are halved until their rule
    !> integrates the constants.
    subroutine depth_nodes(average, body, knots, error)
        type(average_t), intent(inout) :: average
        class(body_t), intent(in) :: body
        real(wp), intent(in) :: knots(:)
        type(error_t), allocatable, intent(inout) :: error
        real(wp) :: t(wide_nodes), w(wide_nodes), t6(narrow_nodes), w6(narrow_nodes), from, to
        integer :: i, count, round, stat

        call gauss_legendre(t, w, error)
        call gauss_legendre(t6, w6, error)
        if (allocated(error)) return
        ! counted, then set
        do round = 1, 2
            count = 0
            from = average%top_depth
            do i = 1, size(knots)
                do while (from < knots(i))
                    call check_cancelled(error)
                    if (allocated(error)) return
                    to = min(4.0_wp*from, knots(i))
                    do while (.not. is_integrated_by(body, t, w, from, to))
                        to = from + 0.5_wp*(to - from)
                    end do
                    if (to <= 1.3_wp*from .and. is_integrated_by(body, t6, w6, from, to)) then
                        call add_panel(t6, w6)
                    else
                        call add_panel(t, w)
                    end if
                    from = to
                end do
            end do
            if (round == 2) exit
            allocate (average%z(count), average%dz(count), stat=stat)
            call check_memory(error, stat)
            if (stat /= 0) return
        end do

    contains

        subroutine add_panel(places, weights)
            real(wp), intent(in) :: places(:), weights(:)

            if (round == 2) then
                average%z(count + 1:count + size(places)) = from + (to - from)*places
                average%dz(count + 1:count + size(places)) = (to - from)*weights
            end if
            count = count + size(places)
        end subroutine add_panel

    end subroutine depth_nodes

    function average_at(self, x) result(y)
        class(average_t), intent(inout) :: self
        real(wp), intent(in) :: x
        real(wp) :: y
        real(wp) :: nu, weight_nu, total, top, bottom

        top = self%top_depth/x
        bottom = self%bottom_depth/x
        nu = sum(weight_i1_slope(self%z/x)*(self%dz/x)*self%poisson) + weight_i1(top)*self%top_poisson &
             + weight_j1(bottom)*self%bottom_poisson
        weight_nu = merge(nu, self%options%weight_nu, self%options%weight_nu_choice == gao_nu_effective)
        if (self%under_shear) then
            total = sum(weight_i0_tangential_slope(self%z/x, weight_nu)*(self%dz/x)*self%shear) &
                    + weight_i0_tangential(top, weight_nu)*self%top_shear &
                    + weight_j0_tangential(bottom, weight_nu)*self%bottom_shear
            y = 4.0_wp*self%mean%mean(total)/(2.0_wp - nu)
        else
            total = sum(weight_i0_slope(self%z/x, weight_nu)*(self%dz/x)*self%shear) &
                    + weight_i0(top, weight_nu)*self%top_shear + weight_j0(bottom, weight_nu)*self%bottom_shear
            y = 2.0_wp*self%mean%mean(total)/(1.0_wp - nu)
        end if
    end function average_at

end module mdrcontact_medium_graded
