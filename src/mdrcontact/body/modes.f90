! SPDX-License-Identifier: GPL-3.0-or-later
!> One homogeneous elastic layer at wavenumber k: how it carries the 2x2 compliance of what lies below it to its top (theory 6).
!>
!> State at a depth: displacement (u, w) and traction (tau, sigma)/(2 G k) of the Hankel components, z down. Modes decaying
!> downward are (1, 1) e^{-kz} and (kz, kz + 3 - 4 nu) e^{-kz}, growing ones their mirror images. Decaying modes are referred
!> to the top of the layer and growing ones to its bottom, so that no positive exponent appears; a layer thin against the
!> wavelength is carried by its transfer matrix instead, whose entries are small where they should be and not by
!> cancellation: the compliance of a soft layer keeps its relative precision. Nothing is divided by 1 - 2 nu.
module mdrcontact_body_modes
    use mdrcontact_kinds, only: wp
    implicit none (type, external)
    private
    public :: layer_modes_t, new_layer_modes, half_space_compliance, compliance_above, reflected_part, &
              transferred, series_product

    !> Layers thinner than this, in units of 1/|k|, are carried by the transfer matrix.
    real(wp), parameter :: thin = 0.5_wp
    complex(wp), parameter :: none = (0.0_wp, 0.0_wp), one = (1.0_wp, 0.0_wp)

    !> What a material's Poisson's ratio determines.
    type :: layer_modes_t
        complex(wp) :: poisson = 0.0_wp
        !> displacement and traction of the decaying and growing modes where they are referred to
        complex(wp) :: decaying_u(2, 2) = 0.0_wp, decaying_t(2, 2) = 0.0_wp
        complex(wp) :: growing_u(2, 2) = 0.0_wp, growing_t(2, 2) = 0.0_wp
        !> compliance of a half-space
        complex(wp) :: half_space(2, 2) = 0.0_wp
        !> matrix A of the state's equation dy/d(kz) = A y, then A^2 - 1 and A (A^2 - 1)
        complex(wp) :: rate(4, 4) = 0.0_wp, rate_even(4, 4) = 0.0_wp, rate_odd(4, 4) = 0.0_wp
    end type layer_modes_t

contains

    !> The modes of a material of Poisson's ratio nu, complex where it oscillates.
    pure function new_layer_modes(poisson) result(self)
        complex(wp), intent(in) :: poisson
        type(layer_modes_t) :: self
        complex(wp) :: free, ratio
        integer :: i

        self%poisson = poisson
        free = 1.0_wp - 2.0_wp*poisson
        self%decaying_u = reshape([one, one, none, 1.0_wp + 2.0_wp*free], [2, 2])
        self%decaying_t = reshape([-one, -one, -free, -1.0_wp - free], [2, 2])
        self%growing_u = reshape([one, -one, none, 1.0_wp + 2.0_wp*free], [2, 2])
        self%growing_t = reshape([one, -one, -free, 1.0_wp + free], [2, 2])
        self%half_space = half_space_compliance(poisson)

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
    end function new_layer_modes

    !> (u, w) = S (tau, sigma)/(2 G k) at the surface of a half-space.
    pure function half_space_compliance(poisson) result(compliance)
        complex(wp), intent(in) :: poisson
        complex(wp) :: compliance(2, 2)
        complex(wp) :: free

        free = 1.0_wp - 2.0_wp*poisson
        compliance = reshape([-1.0_wp - free, free, free, -1.0_wp - free], [2, 2])
    end function half_space_compliance

    !> The compliance at the top of a layer of thickness t/k with the compliance `below` at its bottom, both times 2 G of the layer.
    pure function compliance_above(layer, t, below) result(above)
        type(layer_modes_t), intent(in) :: layer
        complex(wp), intent(in) :: t, below(2, 2)
        complex(wp) :: above(2, 2)

        if (abs(t) < thin) then
            above = transferred(transfer_matrix(layer, t), below)
        else
            above = layer%half_space + reflected_part(layer, t, below)
        end if
    end function compliance_above

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

    !> Multiplies a power series in k of transfer matrices (4, 4, 0:n) from the right by that of one more layer, exp(-k h A), with
    !> tractions relative to 2 G k of a material whose shear modulus is 1/shear times the layer's.
    pure subroutine series_product(layer, thickness, shear, series)
        type(layer_modes_t), intent(in) :: layer
        real(wp), intent(in) :: thickness
        complex(wp), intent(in) :: shear
        complex(wp), intent(inout) :: series(:, :, 0:)
        complex(wp) :: step(4, 4), power(4, 4), product(4, 4, 0:ubound(series, 3))
        integer :: i, n

        step = -thickness*layer%rate
        step(1:2, 3:4) = step(1:2, 3:4)/shear
        step(3:4, 1:2) = step(3:4, 1:2)*shear
        product = series
        power = 0.0_wp
        do i = 1, 4
            power(i, i) = 1.0_wp
        end do
        do n = 1, ubound(series, 3)
            power = matmul(power, step)/real(n, wp)
            do i = n, ubound(series, 3)
                product(:, :, i) = product(:, :, i) + matmul(series(:, :, i - n), power)
            end do
        end do
        series = product
    end subroutine series_product

    !> What the layer's bottom adds to the compliance of a half-space of its material; exponentially small in t, to full
    !> relative precision.
    pure function reflected_part(layer, t, below) result(part)
        type(layer_modes_t), intent(in) :: layer
        complex(wp), intent(in) :: t, below(2, 2)
        complex(wp) :: part(2, 2)
        complex(wp) :: reflection(2, 2), added(2, 2), traction(2, 2)

        reflection = times(inverse(layer%growing_u - times(below, layer%growing_t)), &
                           times(below, layer%decaying_t) - layer%decaying_u)
        ! to the top: exp(-t) (1, -t; 0, 1) R (1, t; 0, 1) exp(-t)
        reflection(:, 2) = reflection(:, 2) + t*reflection(:, 1)
        reflection(1, :) = reflection(1, :) - t*reflection(2, :)
        reflection = exp(-2.0_wp*t)*reflection
        added = times(layer%growing_u - times(layer%half_space, layer%growing_t), reflection)
        traction = layer%decaying_t + times(layer%growing_t, reflection)
        part = times(added, inverse(traction))
    end function reflected_part

    !> exp(-t A), the state at the top from that at the bottom. (A^2 - 1)^2 = 0.
    pure function transfer_matrix(layer, t) result(p)
        type(layer_modes_t), intent(in) :: layer
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

    pure function inverse(a) result(b)
        complex(wp), intent(in) :: a(2, 2)
        complex(wp) :: b(2, 2)

        b(1, 1) = a(2, 2)
        b(2, 2) = a(1, 1)
        b(1, 2) = -a(1, 2)
        b(2, 1) = -a(2, 1)
        b = b/(a(1, 1)*a(2, 2) - a(1, 2)*a(2, 1))
    end function inverse

end module mdrcontact_body_modes
