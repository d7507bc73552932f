! SPDX-License-Identifier: GPL-3.0-or-later
!> One homogeneous isotropic layer at wavenumber k: how it carries the 2x2 compliance of what lies below it to its top
!> (theory/exact.md (2.1), (2.2)).
!>
!> State at a depth: displacement (u, w) and traction (tau, sigma)/(2 G k) of the Hankel components, z down. Modes decaying
!> downward are (1, 1) e^{-kz} and (kz, kz + 3 - 4 nu) e^{-kz}, growing ones their mirror images. Decaying modes are referred
!> to the top of the layer and growing ones to its bottom, so that no positive exponent appears; a layer thin against the
!> wavelength is carried by its transfer matrix instead, whose entries are small where they should be and not by
!> cancellation: the compliance of a soft layer keeps its relative precision. Nothing is divided by 1 - 2 nu.
module mdrcontact_body_elements_layer
    use mdrcontact_body_elements_element, only: element_t
    use mdrcontact_kinds, only: wp
    implicit none (type, external)
    private
    public :: layer_t, new_layer, half_space_compliance, transferred, times, inverse

    !> Layers thinner than this, in units of 1/|k|, are carried by the transfer matrix.
    real(wp), parameter :: thin = 0.5_wp
    complex(wp), parameter :: none = (0.0_wp, 0.0_wp), one = (1.0_wp, 0.0_wp)

    !> A layer.
    type, extends(element_t) :: layer_t
        private
        !> G over that of the surface
        complex(wp) :: shear = 1.0_wp
        !> displacement and traction of the decaying and growing modes where they are referred to, relative to its own 2 G k
        complex(wp) :: decaying_u(2, 2) = 0.0_wp, decaying_t(2, 2) = 0.0_wp
        complex(wp) :: growing_u(2, 2) = 0.0_wp, growing_t(2, 2) = 0.0_wp
        !> S of a half-space, relative to 1/(2 G) of its own
        complex(wp) :: own_half_space(2, 2) = 0.0_wp
        !> matrix A of the state's equation dy/d(kz) = A y, then A^2 - 1 and A (A^2 - 1)
        complex(wp) :: rate(4, 4) = 0.0_wp, rate_even(4, 4) = 0.0_wp, rate_odd(4, 4) = 0.0_wp
    contains
        procedure :: above
        procedure :: reflected
        procedure :: above_across
        procedure :: reflected_across
    end type layer_t

contains

    !> A layer of Poisson's ratio nu, complex where it oscillates.
    pure subroutine new_layer(self, thickness, shear, poisson)
        type(layer_t), intent(out) :: self
        !> h [length]
        real(wp), intent(in) :: thickness
        !> G over that of the surface, and nu [1]
        complex(wp), intent(in) :: shear, poisson
        complex(wp) :: free, ratio
        integer :: i

        self%thickness = thickness
        self%shear = shear
        free = 1.0_wp - 2.0_wp*poisson
        self%decaying_u = reshape([one, one, none, 1.0_wp + 2.0_wp*free], [2, 2])
        self%decaying_t = reshape([-one, -one, -free, -1.0_wp - free], [2, 2])
        self%growing_u = reshape([one, -one, none, 1.0_wp + 2.0_wp*free], [2, 2])
        self%growing_t = reshape([one, -one, -free, 1.0_wp + free], [2, 2])
        self%own_half_space = half_space_compliance(poisson)
        self%half_space = self%own_half_space/shear
        self%half_space_across = 1.0_wp/shear

        ratio = poisson/(1.0_wp - poisson)
        self%rate(1, :) = [none, one, 2.0_wp*one, none]
        self%rate(2, :) = [-ratio, none, none, free/(1.0_wp - poisson)]
        self%rate(3, :) = [1.0_wp/(1.0_wp - poisson), none, none, ratio]
        self%rate(4, :) = [none, none, -one, none]
        self%rate_even = matmul(self%rate, self%rate)
        do i = 1, 4
            self%rate_even(i, i) = self%rate_even(i, i) - 1.0_wp
        end do
        self%rate_odd = matmul(self%rate, self%rate_even)
        ! tractions of the state are relative to those of the surface
        self%generator = -thickness*self%rate
        self%generator(1:2, 3:4) = self%generator(1:2, 3:4)/shear
        self%generator(3:4, 1:2) = self%generator(3:4, 1:2)*shear
    end subroutine new_layer

    !> (u, w) = S (tau, sigma)/(2 G k) at the surface of a half-space.
    pure function half_space_compliance(poisson) result(compliance)
        complex(wp), intent(in) :: poisson
        complex(wp) :: compliance(2, 2)
        complex(wp) :: free

        free = 1.0_wp - 2.0_wp*poisson
        compliance = reshape([-1.0_wp - free, free, free, -1.0_wp - free], [2, 2])
    end function half_space_compliance

    !> S at the top.
    pure function above(self, k, below) result(compliance)
        class(layer_t), intent(in) :: self
        complex(wp), intent(in) :: k, below(2, 2)
        complex(wp) :: compliance(2, 2)
        complex(wp) :: t

        t = k*self%thickness
        if (abs(t) < thin) then
            compliance = transferred(transfer_matrix(self, t), self%shear*below)
        else
            compliance = self%own_half_space + reflected_part(self, t, self%shear*below)
        end if
        compliance = compliance/self%shear
    end function above

    !> Contribution of the layer's bottom to a half-space; exponentially small in k h.
    pure function reflected(self, k, below) result(compliance)
        class(layer_t), intent(in) :: self
        complex(wp), intent(in) :: k, below(2, 2)
        complex(wp) :: compliance(2, 2)

        compliance = reflected_part(self, k*self%thickness, self%shear*below)/self%shear
    end function reflected

    !> y = k C_T G of a layer goes from its bottom to its top as (y + tanh kh)/(1 + y tanh kh).
    pure function above_across(self, k, below) result(compliance)
        class(layer_t), intent(in) :: self
        complex(wp), intent(in) :: k, below
        complex(wp) :: compliance
        complex(wp) :: y, rise

        y = self%shear*below
        rise = tanh(k*self%thickness)
        compliance = (y + rise)/(1.0_wp + y*rise)/self%shear
    end function above_across

    !> The same less 1.
    pure function reflected_across(self, k, below) result(compliance)
        class(layer_t), intent(in) :: self
        complex(wp), intent(in) :: k, below
        complex(wp) :: compliance
        complex(wp) :: y, fall

        y = self%shear*below
        ! 1 - tanh
        fall = exp(-2.0_wp*k*self%thickness)
        fall = 2.0_wp*fall/(1.0_wp + fall)
        compliance = (y - 1.0_wp)*fall/(1.0_wp + y*tanh(k*self%thickness))/self%shear
    end function reflected_across

    !> The compliance above what has the transfer matrix p.
    pure function transferred(p, below) result(above)
        complex(wp), intent(in) :: p(4, 4), below(2, 2)
        complex(wp) :: above(2, 2)
        complex(wp) :: displacement(2, 2), traction(2, 2)

        displacement = p(1:2, 1:2)
        traction = p(3:4, 1:2)
        displacement = times(displacement, below) + p(1:2, 3:4)
        traction = times(traction, below) + p(3:4, 3:4)
        above = times(displacement, inverse(traction))
    end function transferred

    !> Contribution of the layer's bottom to the compliance of a half-space of its material; exponentially small in t, to full
    !> relative precision.
    pure function reflected_part(layer, t, below) result(part)
        class(layer_t), intent(in) :: layer
        complex(wp), intent(in) :: t, below(2, 2)
        complex(wp) :: part(2, 2)
        complex(wp) :: reflection(2, 2), added(2, 2), traction(2, 2)

        reflection = times(inverse(layer%growing_u - times(below, layer%growing_t)), &
                           times(below, layer%decaying_t) - layer%decaying_u)
        ! to the top: exp(-t) (1, -t; 0, 1) R (1, t; 0, 1) exp(-t)
        reflection(:, 2) = reflection(:, 2) + t*reflection(:, 1)
        reflection(1, :) = reflection(1, :) - t*reflection(2, :)
        reflection = exp(-2.0_wp*t)*reflection
        added = times(layer%growing_u - times(layer%own_half_space, layer%growing_t), reflection)
        traction = layer%decaying_t + times(layer%growing_t, reflection)
        part = times(added, inverse(traction))
    end function reflected_part

    !> exp(-t A), the state at the top from that at the bottom. (A^2 - 1)^2 = 0.
    pure function transfer_matrix(layer, t) result(p)
        class(layer_t), intent(in) :: layer
        complex(wp), intent(in) :: t
        complex(wp) :: p(4, 4)
        complex(wp) :: even, odd, t2, odd_rest
        integer :: i

        t2 = t*t
        even = cosh(t)
        odd = sinh(t)
        ! (t cosh t - sinh t)/2 by its series: |t| < 1/2
        odd_rest = t*t2/6.0_wp*(1.0_wp + t2/10.0_wp*(1.0_wp + t2/28.0_wp*(1.0_wp + t2/54.0_wp*(1.0_wp + t2/88.0_wp &
                   *(1.0_wp + t2/130.0_wp*(1.0_wp + t2/180.0_wp))))))
        p = 0.5_wp*t*odd*layer%rate_even - odd*layer%rate - odd_rest*layer%rate_odd
        do i = 1, 4
            p(i, i) = p(i, i) + even
        end do
    end function transfer_matrix

    !> a b; the intrinsic matmul on 2x2 function results costs far more than the product.
    pure function times(a, b) result(c)
        complex(wp), intent(in) :: a(2, 2), b(2, 2)
        complex(wp) :: c(2, 2)

        c(1, 1) = a(1, 1)*b(1, 1) + a(1, 2)*b(2, 1)
        c(2, 1) = a(2, 1)*b(1, 1) + a(2, 2)*b(2, 1)
        c(1, 2) = a(1, 1)*b(1, 2) + a(1, 2)*b(2, 2)
        c(2, 2) = a(2, 1)*b(1, 2) + a(2, 2)*b(2, 2)
    end function times

    !> The inverse of a 2x2 matrix.
    pure function inverse(a) result(b)
        complex(wp), intent(in) :: a(2, 2)
        complex(wp) :: b(2, 2)

        b(1, 1) = a(2, 2)
        b(2, 2) = a(1, 1)
        b(1, 2) = -a(1, 2)
        b(2, 1) = -a(2, 1)
        b = b/(a(1, 1)*a(2, 2) - a(1, 2)*a(2, 1))
    end function inverse

end module mdrcontact_body_elements_layer
