! SPDX-License-Identifier: GPL-3.0-or-later
!> Layers with complex elastic constants, those of an oscillation or of a Laplace transform: chi(k) is complex on the real axis.
!>
!> Its real and its imaginary part there are two functions that are analytic in k and real on the axis,
!> [chi(k) + conjg chi(conjg k)]/2 and the difference over 2i, so that each is a body like an elastic one to whoever tabulates its
!> kernel.
module mdrcontact_body_harmonic
    use mdrcontact_body_stack, only: stack_t
    use mdrcontact_body_surface, only: new_surface, surface_t
    use mdrcontact_kinds, only: wp
    implicit none (type, external)
    private
    public :: harmonic_t, new_harmonic

    !> One of the two parts; the stack is that of the elastic body of the same thicknesses.
    type, extends(stack_t) :: harmonic_t
        private
        type(surface_t) :: oscillating
        !> sigma(0)
        complex(wp) :: zero = 0.0_wp
        logical :: is_imaginary = .false.
    contains
        procedure :: response
        procedure :: long_wave_limit
        procedure :: first_depth
        procedure :: last_depth
        procedure :: ratios
    end type harmonic_t

contains

    !> The real or the imaginary part of chi; sigma = 1 + chi of both.
    pure function new_harmonic(shear, poisson, thickness, rigid_base, is_imaginary) result(self)
        !> of the layers and, one more, of the half-space, which is not used if the base is rigid [modulus]; [1]
        complex(wp), intent(in) :: shear(:), poisson(:)
        !> of the layers [length]
        real(wp), intent(in) :: thickness(:)
        logical, intent(in) :: rigid_base, is_imaginary
        type(harmonic_t) :: self
        integer :: n

        n = size(thickness)
        self%oscillating = new_surface(shear, poisson, thickness, rigid_base)
        if (.not. rigid_base) self%zero = shear(1)*(1.0_wp - poisson(n + 1))/(shear(n + 1)*(1.0_wp - poisson(1)))
        self%is_imaginary = is_imaginary
    end function new_harmonic

    pure subroutine response(self, k, sigma, chi)
        class(harmonic_t), intent(in) :: self
        complex(wp), intent(in) :: k
        complex(wp), intent(out) :: sigma, chi
        complex(wp) :: other_sigma, other_chi

        call self%oscillating%normal_response(k, sigma, chi)
        call self%oscillating%normal_response(conjg(k), other_sigma, other_chi)
        if (self%is_imaginary) then
            chi = (chi - conjg(other_chi))/(0.0_wp, 2.0_wp)
            sigma = 1.0_wp + chi
        else
            chi = 0.5_wp*(chi + conjg(other_chi))
            sigma = 0.5_wp*(sigma + conjg(other_sigma))
        end if
    end subroutine response

    pure function long_wave_limit(self) result(value)
        class(harmonic_t), intent(in) :: self
        real(wp) :: value

        value = real(self%zero, wp)
        if (self%is_imaginary) value = 1.0_wp + aimag(self%zero)
    end function long_wave_limit

    pure function first_depth(self) result(value)
        class(harmonic_t), intent(in) :: self
        real(wp) :: value

        value = self%oscillating%h(1)
    end function first_depth

    pure function last_depth(self) result(value)
        class(harmonic_t), intent(in) :: self
        real(wp) :: value

        value = self%oscillating%depth
    end function last_depth

    !> None: no two frequencies have the same kernel.
    pure function ratios(self) result(values)
        class(harmonic_t), intent(in) :: self
        real(wp), allocatable :: values(:)

        associate (unused => self)
        end associate
        values = [real(wp) ::]
    end function ratios

end module mdrcontact_body_harmonic
