! SPDX-License-Identifier: GPL-3.0-or-later
!> Coatings and layers by Gao's weights (theory/paper.md (3.2)-(3.5)): the shear moduli of all depths averaged with the weight dI0 -
!> in parallel, their compliances in series, or by any power mean between -, Poisson's ratios with dI1. Exact to first order in the
!> contrast. Gao, Chiu, Lee, Int. J. Solids Struct. 29 (1992) 2471; Popov 2014, equations (12)-(16).
module mdrcontact_medium_gao
    use, intrinsic :: iso_fortran_env, only: int64
    use mdrcontact_object, only: real_bytes, room
    use mdrcontact_body_compliance, only: shear_load
    use mdrcontact_codes, only: gao_nu_effective => weight_nu_effective, gao_nu_given => weight_nu_given, &
                                gao_nu_substrate => weight_nu_substrate, gao_nu_surface => weight_nu_surface
    use mdrcontact_error, only: check_code, check_made, check_memory, check_poisson, check_positive, count_text, error_invalid, &
                                error_t, raise
    use mdrcontact_kinds, only: wp
    use mdrcontact_material, only: material_t
    use mdrcontact_medium_solver, only: refuse_load, solver_t
    use mdrcontact_medium_effective, only: effective_medium_t
    use mdrcontact_numerics_power_mean, only: new_power_mean, power_mean_t
    use mdrcontact_weights, only: all_weights, weight_i0_poisson_slope, weight_i0_slope, weight_i0_tangential_poisson_slope, &
                                  weight_i0_tangential_slope, weight_i1_slope
    implicit none (type, external)
    private
    public :: gao_t, new_gao, new_gao_layered, gao_options_t, i0_poisson_choice
    public :: gao_nu_surface, gao_nu_substrate, gao_nu_effective, gao_nu_given

    !> The choices that Gao's weights leave.
    type :: gao_options_t
        !> p of the power mean [sum w G^p]^(1/p), -1 <= p <= 1: 1 the moduli in parallel (Popov 2014), -1 the compliances in series,
        !> which is far closer to the exact solution at large contrast; 0 their logarithms
        real(wp) :: exponent = 1.0_wp
        !> one of gao_nu_...
        integer :: weight_nu_choice = gao_nu_surface
        !> the number for gao_nu_given
        real(wp) :: weight_nu = 0.5_wp
    end type gao_options_t

    !> Layers 1, 2, ... top to bottom on a substrate, which is the last entry of each array.
    type, extends(effective_medium_t) :: gao_t
        private
        !> G as the mean takes it, and nu
        real(wp), allocatable :: shear(:), poisson(:)
        type(power_mean_t) :: mean
        !> depths of the interfaces [length]
        real(wp), allocatable :: depth(:)
        type(gao_options_t) :: options
        !> whether it is the modulus under a load along the surface
        logical :: under_shear = .false.
        !> the modulus is 2 p G_eff/(p - nu_eff): p = 1 under normal load, E_eff, and 2 under shear, G_t
        real(wp) :: p = 1.0_wp
    contains
        procedure :: effective_modulus
        procedure :: effective_modulus_slope
        procedure :: for_load
        procedure :: bytes
    end type gao_t

contains

    !> One coating of thickness h on a substrate.
    subroutine new_gao(self, coating, thickness, substrate, error, options)
        type(gao_t), intent(out) :: self
        type(material_t), intent(in) :: coating, substrate
        !> h > 0 [length]
        real(wp), intent(in) :: thickness
        type(error_t), allocatable, intent(out) :: error
        !> without it: in parallel, nu of the surface in I0
        type(gao_options_t), intent(in), optional :: options

        call check_made(error, "coating", coating%young > 0.0_wp)
        call check_made(error, "substrate", substrate%young > 0.0_wp)
        if (allocated(error)) return
        call check_positive(error, "thickness", thickness)
        if (allocated(error)) return
        call new_gao_layered(self, [coating], [thickness], substrate, error, options)
        self%is_made = .not. allocated(error)
    end subroutine new_gao

    !> Layers on a substrate.
    subroutine new_gao_layered(self, layers, thickness, substrate, error, options)
        type(gao_t), intent(out) :: self
        !> top to bottom, at least one
        type(material_t), intent(in) :: layers(:)
        !> thicknesses > 0, same size [length]
        real(wp), intent(in) :: thickness(:)
        type(material_t), intent(in) :: substrate
        type(error_t), allocatable, intent(out) :: error
        !> as in new_gao
        type(gao_options_t), intent(in), optional :: options
        integer :: i, n, stat

        call check_made(error, "layers", all(layers%young > 0.0_wp))
        call check_made(error, "substrate", substrate%young > 0.0_wp)
        if (allocated(error)) return
        if (size(layers) == 0 .or. size(layers) /= size(thickness)) then
            call raise(error, error_invalid, "there are "//count_text(size(layers))//" layers and "//count_text(size(thickness))// &
                       " thicknesses: there must be at least one layer, and one thickness for each")
            return
        end if
        do i = 1, size(layers)
            call check_positive(error, "thickness", thickness(i), i)
        end do
        if (present(options)) self%options = options
        n = size(layers)
        allocate (self%shear(n + 1), self%poisson(n + 1), self%depth(n), stat=stat)
        call check_memory(error, stat)
        if (allocated(error)) return
        self%depth(1) = thickness(1)
        do i = 1, n
            self%shear(i) = layers(i)%shear()
            self%poisson(i) = layers(i)%poisson
            if (i > 1) self%depth(i) = self%depth(i - 1) + thickness(i)
        end do
        self%shear(n + 1) = substrate%shear()
        self%poisson(n + 1) = substrate%poisson
        call new_power_mean(self%mean, self%options%exponent, self%shear, error)
        if (allocated(error)) return
        do i = 1, n + 1
            self%shear(i) = self%mean%transformed(self%shear(i))
        end do
        call i0_poisson_choice(self%options, self%poisson(1), substrate%poisson, error)
        self%is_made = .not. allocated(error)
    end subroutine new_gao_layered

    !> Turns the choice of nu in I0 into its number, `options%weight_nu`.
    pure subroutine i0_poisson_choice(options, surface, substrate, error)
        type(gao_options_t), intent(inout) :: options
        real(wp), intent(in) :: surface, substrate
        type(error_t), allocatable, intent(inout) :: error

        select case (options%weight_nu_choice)
        case (gao_nu_surface, gao_nu_effective)
            options%weight_nu = surface
        case (gao_nu_substrate)
            options%weight_nu = substrate
        case (gao_nu_given)
            call check_poisson(error, "weight_nu", options%weight_nu)
        case default
            call check_code(error, "weight_nu_choice", options%weight_nu_choice, [gao_nu_surface, gao_nu_substrate, &
                                                                                  gao_nu_effective, gao_nu_given])
        end select
    end subroutine i0_poisson_choice

    !> The same layers under shear, G_t = 4 G_eff/(2 - nu_eff) with the weights of a load along the surface, exact to first order in
    !> the contrast.
    subroutine for_load(self, load, other, error)
        class(gao_t), intent(in) :: self
        integer, intent(in) :: load
        class(solver_t), allocatable, intent(out) :: other
        type(error_t), allocatable, intent(out) :: error
        type(gao_t), allocatable :: own

        if (.not. self%is_made) call check_made(error, "medium", self%is_made)
        if (allocated(error)) return
        if (load /= shear_load) then
            call refuse_load(self, load, error)
            return
        end if
        call room(3*real_bytes*size(self%shear), error)
        if (allocated(error)) return
        allocate (own)
        own%shear = self%shear
        own%poisson = self%poisson
        own%depth = self%depth
        own%mean = self%mean
        own%options = self%options
        own%under_shear = .true.
        own%p = 2.0_wp
        own%is_made = .true.
        call move_alloc(own, other)
    end subroutine for_load

    pure recursive function bytes(self)
        class(gao_t), intent(in) :: self
        integer(int64) :: bytes

        bytes = 3*real_bytes*size(self%shear)
        if (allocated(self%pressed)) bytes = bytes + self%pressed%bytes()
    end function bytes

    !> E_eff = 2 G_eff/(1 - nu_eff), every average a sum of positive weights times values.
    elemental function effective_modulus(self, a) result(value)
        class(gao_t), intent(in) :: self
        real(wp), intent(in) :: a
        real(wp) :: value
        real(wp) :: nu, total

        call averages(self, a, nu, total)
        value = 2.0_wp*self%p*self%mean%mean(total)/(self%p - nu)
    end function effective_modulus

    elemental function effective_modulus_slope(self, a) result(value)
        class(gao_t), intent(in) :: self
        real(wp), intent(in) :: a
        real(wp) :: value
        real(wp) :: nu, nu_slope, total, total_slope, shear, shear_slope
        integer :: i

        call averages(self, a, nu, total)
        shear = self%mean%mean(total)
        nu_slope = 0.0_wp
        do i = 1, size(self%depth)
            nu_slope = nu_slope - (self%poisson(i) - self%poisson(i + 1))*weight_i1_slope(self%depth(i)/a)*(self%depth(i)/a)
        end do
        nu_slope = nu_slope/a
        total_slope = 0.0_wp
        do i = 1, size(self%depth)
            total_slope = total_slope + (self%shear(i) - self%shear(i + 1)) &
                          *i0_slope(self, a, self%depth(i)/a, i0_poisson(self%options, nu), nu_slope)
        end do
        shear_slope = self%mean%mean_slope(total)*total_slope
        value = 2.0_wp*self%p*(shear_slope + shear*nu_slope/(self%p - nu))/(self%p - nu)
    end function effective_modulus_slope

    !> nu_eff, and the sum that belongs to G_eff
    pure subroutine averages(self, a, nu, total)
        class(gao_t), intent(in) :: self
        real(wp), intent(in) :: a
        real(wp), intent(out) :: nu, total
        real(wp) :: unused

        call average(self, a, self%options%weight_nu, nu, total)
        if (self%options%weight_nu_choice == gao_nu_effective) call average(self, a, nu, unused, total)
    end subroutine averages

    !> nu_eff, and the weighted sum for G_eff with nu_weight in I0. The weight of each layer comes from the weights above (i) and
    !> below (j = 1 - i) its interfaces, as the difference of whichever is smaller, so that a thin or remote layer's share keeps its
    !> relative accuracy. Called at every node of every force: no arrays.
    pure subroutine average(self, a, nu_weight, nu, total)
        class(gao_t), intent(in) :: self
        real(wp), intent(in) :: a, nu_weight
        real(wp), intent(out) :: nu, total
        real(wp) :: i0, j0, i1, j1, i0_above, j0_above, i1_above, j1_above
        integer :: layer

        i0_above = 0.0_wp
        j0_above = 1.0_wp
        i1_above = 0.0_wp
        j1_above = 1.0_wp
        nu = 0.0_wp
        total = 0.0_wp
        do layer = 1, size(self%depth)
            call all_weights(self%depth(layer)/a, nu_weight, self%under_shear, i0, j0, i1, j1)
            nu = nu + self%poisson(layer)*share(i1, i1_above, j1, j1_above)
            total = total + self%shear(layer)*share(i0, i0_above, j0, j0_above)
            i0_above = i0
            j0_above = j0
            i1_above = i1
            j1_above = j1
        end do
        nu = nu + self%poisson(layer)*j1_above
        total = total + self%shear(layer)*j0_above

    contains

        pure function share(i, i_above, j, j_above) result(value)
            real(wp), intent(in) :: i, i_above, j, j_above
            real(wp) :: value

            value = merge(i - i_above, j_above - j, i < 0.5_wp .or. layer == 1)
        end function share

    end subroutine average

    !> dI0/da at an interface at the depth x a; nu may vary with a.
    pure function i0_slope(self, a, x, nu, nu_slope) result(slope)
        class(gao_t), intent(in) :: self
        real(wp), intent(in) :: a, x, nu, nu_slope
        real(wp) :: slope
        real(wp) :: poisson_slope

        if (self%under_shear) then
            slope = -weight_i0_tangential_slope(x, nu)*x/a
            poisson_slope = weight_i0_tangential_poisson_slope(x, nu)
        else
            slope = -weight_i0_slope(x, nu)*x/a
            poisson_slope = weight_i0_poisson_slope(x, nu)
        end if
        if (self%options%weight_nu_choice == gao_nu_effective) slope = slope + poisson_slope*nu_slope
    end function i0_slope

    pure function i0_poisson(options, effective) result(nu)
        type(gao_options_t), intent(in) :: options
        real(wp), intent(in) :: effective
        real(wp) :: nu

        nu = merge(effective, options%weight_nu, options%weight_nu_choice == gao_nu_effective)
    end function i0_poisson

end module mdrcontact_medium_gao
