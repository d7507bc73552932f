! SPDX-License-Identifier: GPL-3.0-or-later
!> Layers that conduct, electrically or thermally, on a base, and the response of their surface to a flux (Hankel space).
!>
!> A layer of conductivities kappa_z into the body and kappa_r along the surface is the isotropic one of S = sqrt(kappa_r kappa_z)
!> and thickness h sqrt(kappa_r/kappa_z). With heat capacity c and Laplace variable s its waves fall as exp(-beta z),
!> beta = sqrt(k^2 + s c/kappa_r). Potential over flux density C(k) goes from the bottom of a layer to its top as
!>     C = (y C_b + t)/(y (1 + y C_b t)),  y = S kappa,  t = tanh(kappa H),
!> and S_0 k C = 1 + chi at the surface: theory/conduction.md (1.1)-(1.5).
module mdrcontact_conduction_conductors
    use mdrcontact_codes, only: half_space_base => base_half_space, insulating_base => base_insulating, &
                                perfect_base => base_perfect
    use mdrcontact_error, only: check_code, check_finite, check_memory, check_not_negative, check_positive, error_invalid, &
                                error_t, raise
    use mdrcontact_kinds, only: wp
    use mdrcontact_numerics_layer_search, only: find_layer
    implicit none (type, external)
    private
    public :: conductor_t, conductors_t, new_conductors, half_space_base, perfect_base, insulating_base, layer_at

    !> C of an insulating base: all other terms are negligible compared with it, so that the result equals the limit to the last
    !> digit.
    real(wp), parameter :: without_end = 1.0e100_wp
    !> Exponent kappa H of the surface layer from which exp(-2 kappa H) is 0.
    real(wp), parameter :: out_of_reach = 373.0_wp

    !> A layer and the interface below it.
    type :: conductor_t
        !> h > 0, not used of a half-space [length]
        real(wp) :: thickness = 0.0_wp
        !> kappa_z > 0 into the body and kappa_r > 0 along the surface [conductance/length]
        real(wp) :: sigma = 1.0_wp, along = 1.0_wp
        !> c >= 0, per volume; 0: steady
        real(wp) :: capacity = 0.0_wp
        !> R >= 0 between it and what lies below, not used of a half-space [length^2/conductance]
        real(wp) :: resistance = 0.0_wp
    end type conductor_t

    !> A body that conducts, top to bottom; made by new_conductors, read only.
    type :: conductors_t
        !> whether it was made: set last by what makes it
        logical :: is_made = .false.
        !> half_space_base, perfect_base or insulating_base
        integer :: base = half_space_base
        !> layers that have a bottom
        integer :: layers = 0
        !> S, H, sqrt(kappa_r/kappa_z), c/kappa_r, R below; one more entry for the half-space
        real(wp), allocatable :: s(:), h(:), stretch(:), rate(:), r(:)
    contains
        procedure :: response
        procedure :: below
        procedure :: depth
        procedure :: sheet
    end type conductors_t

contains

    !> Checks and keeps a stack.
    pure subroutine new_conductors(self, layers, base, error)
        type(conductors_t), intent(out) :: self
        !> top to bottom; on half_space_base the last one is the half-space
        type(conductor_t), intent(in) :: layers(:)
        !> half_space_base, perfect_base or insulating_base
        integer, intent(in) :: base
        type(error_t), allocatable, intent(out) :: error
        integer :: i, n, stat

        if (allocated(error)) return
        call check_code(error, "base", base, [half_space_base, perfect_base, insulating_base])
        n = size(layers)
        if (n == 0 .and. .not. allocated(error)) call raise(error, error_invalid, "conductor: it has no layer. Give at least one")
        if (allocated(error)) return
        self%base = base
        self%layers = n
        if (base == half_space_base) self%layers = n - 1
        do i = 1, n
            call check_layer(layers(i), i, i <= self%layers, error)
        end do
        if (allocated(error)) return
        allocate (self%s(n), self%h(n), self%stretch(n), self%rate(n), self%r(n), stat=stat)
        call check_memory(error, stat)
        if (stat /= 0) return
        self%s = sqrt(layers%sigma)*sqrt(layers%along)
        self%stretch = sqrt(layers%along/layers%sigma)
        self%h = layers%thickness*self%stretch
        self%rate = layers%capacity/layers%along
        self%r = layers%resistance
        self%is_made = .not. allocated(error)
    end subroutine new_conductors

    pure subroutine check_layer(layer, i, has_bottom, error)
        type(conductor_t), intent(in) :: layer
        integer, intent(in) :: i
        logical, intent(in) :: has_bottom
        type(error_t), allocatable, intent(inout) :: error

        call check_positive(error, "sigma", layer%sigma, i)
        call check_positive(error, "along", layer%along, i)
        call check_not_negative(error, "capacity", layer%capacity, i)
        if (.not. has_bottom) return
        call check_positive(error, "thickness", layer%thickness, i)
        call check_not_negative(error, "resistance", layer%resistance, i)
    end subroutine check_layer

    !> Scaled thickness of all layers.
    pure function depth(self) result(total)
        class(conductors_t), intent(in) :: self
        real(wp) :: total

        total = sum(self%h(:self%layers))
    end function depth

    !> Thickness of the surface material that would conduct along the surface as much as all layers do.
    pure function sheet(self) result(total)
        class(conductors_t), intent(in) :: self
        real(wp) :: total

        total = sum(self%s(:self%layers)*self%h(:self%layers))/self%s(1)
    end function sheet

    !> The layer at a depth, and the scaled distance from its top; an interface belongs to the layer below it if `lower`.
    pure subroutine layer_at(self, z, lower, layer, distance)
        type(conductors_t), intent(in) :: self
        !> >= 0 [length]
        real(wp), intent(in) :: z
        logical, intent(in) :: lower
        !> layers + 1: the base
        integer, intent(out) :: layer
        !> scaled as its thickness is
        real(wp), intent(out) :: distance

        call find_layer(self%h(:self%layers)/self%stretch(:self%layers), z, lower, layer, distance)
        if (layer <= size(self%s)) distance = distance*self%stretch(layer)
    end subroutine layer_at

    !> C at the bottom of a layer: what lies below, and the interface's resistance.
    pure function below(self, layer, k, s) result(c)
        class(conductors_t), intent(in) :: self
        !> 1 ... layers
        integer, intent(in) :: layer
        !> wavenumber [1/length]
        complex(wp), intent(in) :: k
        !> Laplace variable, 0: steady
        complex(wp), intent(in) :: s
        complex(wp) :: c
        complex(wp) :: x, y, t
        integer :: i

        c = self%r(self%layers)
        if (self%base == half_space_base) then
            c = c + 1.0_wp/(self%s(self%layers + 1)*kappa_of(self, self%layers + 1, k, s))
        else if (self%base == insulating_base) then
            c = without_end
        end if
        do i = self%layers, layer + 1, -1
            x = kappa_of(self, i, k, s)*self%h(i)
            y = self%s(i)*kappa_of(self, i, k, s)
            t = tanh_of(x, exp(-2.0_wp*x))
            c = (y*c + t)/(y*(1.0_wp + y*c*t)) + self%r(i - 1)
        end do
    end function below

    !> 1 + chi = S_0 k C of the surface and chi, each to full relative precision; what of chi the layers below the surface
    !> layer make falls as exp(-2 kappa H).
    elemental subroutine response(self, k, s, one_plus_chi, chi)
        class(conductors_t), intent(in) :: self
        !> wavenumber [1/length], and Laplace variable [1/time]
        complex(wp), intent(in) :: k, s
        !> both [1]
        complex(wp), intent(out) :: one_plus_chi, chi
        complex(wp) :: ratio, kappa, y, t, fall

        kappa = k
        ratio = 1.0_wp
        chi = 0.0_wp
        if (s /= 0.0_wp .and. self%rate(1) > 0.0_wp) then
            kappa = kappa_of(self, 1, k, s)
            ratio = k/kappa
            ! k/kappa - 1
            chi = -s*self%rate(1)/(kappa*(k + kappa))
        end if
        one_plus_chi = ratio
        if (self%layers == 0) return
        if (real(kappa, wp)*self%h(1) > out_of_reach) return
        fall = exp(-2.0_wp*kappa*self%h(1))
        t = tanh_of(kappa*self%h(1), fall)
        y = self%s(1)*kappa*self%below(1, k, s)
        one_plus_chi = ratio*(y + t)/(1.0_wp + y*t)
        ! 1 - t
        fall = 2.0_wp*fall/(1.0_wp + fall)
        chi = chi + ratio*(y - 1.0_wp)*fall/(1.0_wp + y*t)
    end subroutine response

    pure function kappa_of(self, layer, k, s) result(kappa)
        class(conductors_t), intent(in) :: self
        integer, intent(in) :: layer
        complex(wp), intent(in) :: k, s
        complex(wp) :: kappa

        kappa = k
        if (s /= 0.0_wp) kappa = sqrt(k**2 + s*self%rate(layer))
    end function kappa_of

    !> tanh x, by exp(-2 x) where no digits are lost.
    elemental function tanh_of(x, fall) result(t)
        complex(wp), intent(in) :: x, fall
        complex(wp) :: t

        t = (1.0_wp - fall)/(1.0_wp + fall)
        if (abs(real(x, wp)) > 0.3_wp) return
        if (abs(x) < 0.3_wp) t = tanh(x)
    end function tanh_of

end module mdrcontact_conduction_conductors
