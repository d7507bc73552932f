! SPDX-License-Identifier: GPL-3.0-or-later
!> The AFM "bottom effect" (theory/paper.md (3.14)): an incompressible layer bonded to a rigid base, pressed by a paraboloid.
!>
!> The published series are for the force, F/F_Hertz = S(chi) = 1 + c1 chi + c2 chi^2 + c3 chi^3 + c4 chi^4
!> with chi = sqrt(R d)/h. With a = sqrt(R d), as for a homogeneous body, they are the effective modulus
!> E_eff = E* [S + (chi/3) S'], chi = a/h, which gives back the published force for a paraboloid, and nearly so for a sphere with
!> a << R. They hold for chi < 1, and under no other indenter.
!> Dimitriadis, Horkay, Maresca, Kachar, Chadwick, Biophys. J. 82 (2002) 2798; Garcia, Garcia, Biophys. J. 114 (2018) 2923.
module mdrcontact_medium_bottom_effect
    use mdrcontact_error, only: check_made, check_positive, error_invalid, error_t, raise, to_text
    use mdrcontact_kinds, only: wp
    use mdrcontact_material, only: material_t
    use mdrcontact_medium_effective, only: effective_medium_t
    implicit none (type, external)
    private
    public :: bottom_effect_t, new_bottom_effect, dimitriadis_series, garcia_series, bottom_effect_ratio

    !> c0 ... c4 of Dimitriadis et al. 2002
    real(wp), parameter :: dimitriadis_series(0:4) = [1.0_wp, 1.133_wp, 1.283_wp, 0.769_wp, 0.0975_wp]
    !> c0 ... c4 of Garcia and Garcia 2018
    real(wp), parameter :: garcia_series(0:4) = [1.0_wp, 1.133_wp, 1.497_wp, 1.469_wp, 0.755_wp]

    !> largest a/h
    real(wp), parameter :: bottom_effect_ratio = 1.0_wp

    !> An incompressible layer on a rigid base.
    type, extends(effective_medium_t) :: bottom_effect_t
        private
        real(wp) :: contact_modulus = 0.0_wp
        real(wp) :: thickness = 0.0_wp
        !> c_k (1 + k/3)
        real(wp) :: coefficients(0:4) = 0.0_wp
    contains
        procedure :: effective_modulus
        procedure :: effective_modulus_slope
    end type bottom_effect_t

contains

    !> An incompressible layer on a rigid base, for a paraboloid.
    subroutine new_bottom_effect(self, layer, thickness, series, error)
        type(bottom_effect_t), intent(out) :: self
        !> nu must be 1/2
        type(material_t), intent(in) :: layer
        !> h > 0 [length]
        real(wp), intent(in) :: thickness
        !> dimitriadis_series or garcia_series
        real(wp), intent(in) :: series(0:4)
        type(error_t), allocatable, intent(out) :: error
        integer :: k

        call check_made(error, "layer", layer%young > 0.0_wp)
        if (allocated(error)) return
        call check_positive(error, "thickness", thickness)
        if (layer%poisson /= 0.5_wp) then
            call raise(error, error_invalid, "coating nu = "//to_text(layer%poisson)//": this model needs nu = 0.5")
        end if
        if (allocated(error)) return
        self%contact_modulus = layer%contact()
        self%thickness = thickness
        self%spherical_only = .true.
        self%largest_radius = bottom_effect_ratio*thickness
        self%why_it_ends = ". The models dimitriadis and garcia are valid for a < h. For larger contacts use the model exact"
        self%coefficients = series*[(1.0_wp + k/3.0_wp, k=0, 4)]
        self%is_made = .not. allocated(error)
    end subroutine new_bottom_effect

    elemental function effective_modulus(self, a) result(value)
        class(bottom_effect_t), intent(in) :: self
        real(wp), intent(in) :: a
        real(wp) :: value, x
        integer :: k

        x = a/self%thickness
        value = 0.0_wp
        do k = 4, 0, -1
            value = value*x + self%coefficients(k)
        end do
        value = value*self%contact_modulus
    end function effective_modulus

    elemental function effective_modulus_slope(self, a) result(value)
        class(bottom_effect_t), intent(in) :: self
        real(wp), intent(in) :: a
        real(wp) :: value, x
        integer :: k

        x = a/self%thickness
        value = 0.0_wp
        do k = 4, 1, -1
            value = value*x + k*self%coefficients(k)
        end do
        value = value*self%contact_modulus/self%thickness
    end function effective_modulus_slope

end module mdrcontact_medium_bottom_effect
