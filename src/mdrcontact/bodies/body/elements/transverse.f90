! SPDX-License-Identifier: GPL-3.0-or-later
!> One layer that is isotropic in its plane, perhaps under a stress there, at wavenumber k: how it carries the 2x2 compliance of
!> what lies below it to its top.
!>
!> The state is v = (k U, S), w = (k W, T) (mdrcontact_material_transverse; theory/surfaces.md (1.4)-(1.13), (2.2)). Waves that
!> decay downward are v = exp(-Q k z) v0, w = -Z v, with Q = sqrt(A B) and Z = A^-1 Q, growing ones have +Q and +Z: no eigenvectors,
!> so that a double root (an isotropic medium) and complex roots are ordinary points. A layer thin against the wavelength is carried
!> by its transfer matrix, whose entries are small where they should be and not by cancellation.
module mdrcontact_body_elements_transverse
    use mdrcontact_body_elements_element, only: element_t
    use mdrcontact_body_elements_layer, only: times, transferred
    use mdrcontact_kinds, only: wp
    use mdrcontact_material_transverse, only: transverse_t
    implicit none (type, external)
    private
    public :: transverse_layer_t, new_transverse_layer, transverse_half_space, modes_t, new_modes

    !> Layers thinner than this, in units of 1/|lambda k|, are carried by the transfer matrix.
    real(wp), parameter :: thin = 1.0_wp
    complex(wp), parameter :: one = (1.0_wp, 0.0_wp)

    !> The waves in a medium whose moduli are in units of 2 G.
    type :: modes_t
        !> A, B, A B, B A, A B A, B A B, Q - (trace Q)/2 and Z
        real(wp), dimension(2, 2) :: a = 0.0_wp, b = 0.0_wp, ab = 0.0_wp, ba = 0.0_wp, aba = 0.0_wp, bab = 0.0_wp, turn = 0.0_wp, &
                                     z = 0.0_wp
        !> of the roots: sum of squares, product and sum
        real(wp) :: squares = 2.0_wp, product = 1.0_wp, total = 2.0_wp
        !> half the difference of the roots, real or imaginary
        complex(wp) :: apart = 0.0_wp
        !> lambda and G/2 across the plane
        real(wp) :: across = 1.0_wp, shear = 0.5_wp
    contains
        procedure :: fall
        procedure :: roots
    end type modes_t

    !> A layer.
    type, extends(element_t) :: transverse_layer_t
        private
        type(modes_t) :: modes
        !> displacement (k U, k W) and traction (T, S) of the decaying and growing modes where they are referred to
        complex(wp), dimension(2, 2) :: decaying_u = 0.0_wp, decaying_t = 0.0_wp, growing_u = 0.0_wp, growing_t = 0.0_wp
        !> displacement of the growing modes less that of a half-space under their traction
        complex(wp) :: edge(2, 2) = 0.0_wp
        !> largest k h at which the transfer matrix is taken
        real(wp) :: thinnest = thin
    contains
        procedure :: above
        procedure :: reflected
        procedure :: above_across
        procedure :: reflected_across
    end type transverse_layer_t

contains

    !> A layer of six numbers.
    pure subroutine new_transverse_layer(self, thickness, constants, surface_shear)
        type(transverse_layer_t), intent(out) :: self
        !> h [length]
        real(wp), intent(in) :: thickness
        type(transverse_t), intent(in) :: constants
        !> G of the body's surface [modulus]
        real(wp), intent(in) :: surface_shear

        self%thickness = thickness
        call new_modes(self%modes, constants%scaled(2.0_wp*surface_shear))
        associate (z => self%modes%z)
            self%decaying_u(1, 1) = one
            self%decaying_u(2, :) = -z(1, :)
            self%decaying_t(1, :) = -z(2, :)
            self%decaying_t(2, 2) = one
            self%growing_u(1, 1) = one
            self%growing_u(2, :) = z(1, :)
            self%growing_t(1, :) = z(2, :)
            self%growing_t(2, 2) = one
        end associate
        self%half_space = transverse_half_space(constants, surface_shear)
        self%edge = self%growing_u - times(self%half_space, self%growing_t)
        self%half_space_across = surface_shear/constants%shear()
        self%fastest = sqrt(max(1.0_wp, abs(self%modes%squares), self%modes%product))
        self%thinnest = thin/self%fastest
        self%generator([1, 4], [2, 3]) = -thickness*self%modes%a
        self%generator([2, 3], [1, 4]) = -thickness*self%modes%b
        self%decay = constants%decay()
    end subroutine new_transverse_layer

    !> The waves in a medium.
    pure subroutine new_modes(self, constants)
        type(modes_t), intent(out) :: self
        !> in units of 2 G
        type(transverse_t), intent(in) :: constants
        real(wp) :: k(2, 2)

        associate (s44 => constants%s44, s33 => constants%s33, c => constants%c, sigma => constants%prestress, &
                   stiff => constants%h + constants%prestress)
            self%a = reshape([1.0_wp, sigma, s44, -1.0_wp], [2, 2])
            self%b = reshape([-c, stiff, s33, c], [2, 2])
            self%ab = matmul(self%a, self%b)
            self%ba = matmul(self%b, self%a)
            self%aba = matmul(self%ab, self%a)
            self%bab = matmul(self%ba, self%b)
            self%squares = constants%root_square_sum()
            self%product = constants%root_product()
            self%total = constants%root_sum()
            self%apart = 0.5_wp*sqrt(cmplx(self%squares - 2.0_wp*self%product, kind=wp))
            k(1, :) = [s44*stiff - c, s33 + s44*c]
            k(2, :) = [-stiff - sigma*c, sigma*s33 - c]
            self%turn = k
            self%turn(1, 1) = k(1, 1) + self%product
            self%turn(2, 2) = k(2, 2) + self%product
            self%turn = self%turn/self%total
            self%z(1, :) = (self%turn(1, :) + s44*self%turn(2, :))/(1.0_wp + sigma*s44)
            self%z(2, :) = (sigma*self%turn(1, :) - self%turn(2, :))/(1.0_wp + sigma*s44)
            ! Q - (trace Q)/2, whose trace cancels
            self%turn(1, 1) = 0.5_wp*(k(1, 1) - k(2, 2))/self%total
            self%turn(2, 2) = -self%turn(1, 1)
        end associate
        self%across = constants%shear_decay()
        self%shear = constants%shear()
    end subroutine new_modes

    !> Both lambda, the one that decays faster first.
    pure function roots(self) result(lambda)
        class(modes_t), intent(in) :: self
        complex(wp) :: lambda(2)

        lambda = 0.5_wp*self%total + self%apart*[1.0_wp, -1.0_wp]
        if (real(self%apart, wp) > 0.0_wp) lambda(2) = self%product/lambda(1)
    end function roots

    !> exp(-Q x).
    pure function fall(self, x) result(matrix)
        class(modes_t), intent(in) :: self
        complex(wp), intent(in) :: x
        complex(wp) :: matrix(2, 2)
        complex(wp) :: lambda(2), y, other, even, odd

        lambda = self%roots()
        y = self%apart*x
        if (real(y, wp)**2 + aimag(y)**2 < 0.25_wp) then
            other = exp(-0.5_wp*self%total*x)
            even = other*cosh(y)
            y = y*y
            ! sinh(y)/y
            odd = x*other*(1.0_wp + y/6.0_wp*(1.0_wp + y/20.0_wp*(1.0_wp + y/42.0_wp*(1.0_wp + y/72.0_wp*(1.0_wp + y/110.0_wp &
                  *(1.0_wp + y/156.0_wp))))))
        else if (real(y, wp) < 0.0_wp) then
            ! the first decays less where x is complex; its part, not its inverse, which overflows
            other = exp(2.0_wp*y)
            even = exp(-lambda(1)*x)
            odd = 0.5_wp*even*(other - 1.0_wp)/self%apart
            even = 0.5_wp*even*(1.0_wp + other)
        else
            other = exp(-2.0_wp*y)
            even = exp(-lambda(2)*x)
            odd = 0.5_wp*even*(1.0_wp - other)/self%apart
            even = 0.5_wp*even*(1.0_wp + other)
        end if
        matrix = -odd*self%turn
        matrix(1, 1) = matrix(1, 1) + even
        matrix(2, 2) = matrix(2, 2) + even
    end function fall

    !> (k U, k W) = S (T, S)/(2 G) at the surface of a half-space, moduli of it relative to 2 G.
    pure function transverse_half_space(constants, surface_shear) result(compliance)
        type(transverse_t), intent(in) :: constants
        !> G [modulus]
        real(wp), intent(in) :: surface_shear
        complex(wp) :: compliance(2, 2)
        type(modes_t) :: modes

        call new_modes(modes, constants%scaled(2.0_wp*surface_shear))
        associate (z => modes%z)
            compliance(1, :) = [-1.0_wp, -z(2, 2)]/z(2, 1)
            compliance(2, :) = [z(1, 1), z(1, 1)*z(2, 2) - z(1, 2)*z(2, 1)]/z(2, 1)
        end associate
    end function transverse_half_space

    !> S at the top.
    pure function above(self, k, below) result(compliance)
        class(transverse_layer_t), intent(in) :: self
        complex(wp), intent(in) :: k, below(2, 2)
        complex(wp) :: compliance(2, 2)
        complex(wp) :: t

        t = k*self%thickness
        if (abs(t) < self%thinnest) then
            compliance = transferred(transfer_matrix(self%modes, t), below)
        else
            compliance = self%half_space + reflected_part(self, t, below)
        end if
    end function above

    !> Contribution of the layer's bottom to a half-space; exponentially small in k h.
    pure function reflected(self, k, below) result(compliance)
        class(transverse_layer_t), intent(in) :: self
        complex(wp), intent(in) :: k, below(2, 2)
        complex(wp) :: compliance(2, 2)

        compliance = reflected_part(self, k*self%thickness, below)
    end function reflected

    !> y = k C_T G goes from the bottom to the top as (y + tanh lambda kh)/(1 + y tanh lambda kh).
    pure function above_across(self, k, below) result(compliance)
        class(transverse_layer_t), intent(in) :: self
        complex(wp), intent(in) :: k, below
        complex(wp) :: compliance
        complex(wp) :: y, rise

        y = below/self%half_space_across
        rise = tanh(self%modes%across*k*self%thickness)
        compliance = (y + rise)/(1.0_wp + y*rise)*self%half_space_across
    end function above_across

    !> The same less that of a half-space.
    pure function reflected_across(self, k, below) result(compliance)
        class(transverse_layer_t), intent(in) :: self
        complex(wp), intent(in) :: k, below
        complex(wp) :: compliance
        complex(wp) :: y, t, fall

        y = below/self%half_space_across
        t = self%modes%across*k*self%thickness
        ! 1 - tanh
        fall = exp(-2.0_wp*t)
        fall = 2.0_wp*fall/(1.0_wp + fall)
        compliance = (y - 1.0_wp)*fall/(1.0_wp + y*tanh(t))*self%half_space_across
    end function reflected_across

    pure function reflected_part(layer, t, below) result(part)
        type(transverse_layer_t), intent(in) :: layer
        complex(wp), intent(in) :: t, below(2, 2)
        complex(wp) :: part(2, 2)
        complex(wp), dimension(2, 2) :: reflection, traction, down, sheared
        complex(wp) :: determinant

        ! the tractions (T, S) of both modes are (-Z2, e_S) and (Z2, e_S)
        sheared(:, 1) = layer%growing_t(1, 1)*below(:, 1)
        sheared(:, 2) = layer%growing_t(1, 2)*below(:, 1)
        traction = layer%growing_u - sheared
        traction(:, 2) = traction(:, 2) - below(:, 2)
        determinant = 1.0_wp/(traction(1, 1)*traction(2, 2) - traction(1, 2)*traction(2, 1))
        down = -layer%decaying_u - sheared
        down(:, 2) = down(:, 2) + below(:, 2)
        reflection(1, :) = determinant*(traction(2, 2)*down(1, :) - traction(1, 2)*down(2, :))
        reflection(2, :) = determinant*(traction(1, 1)*down(2, :) - traction(2, 1)*down(1, :))
        down = layer%modes%fall(t)
        reflection = times(times(down, reflection), down)
        ! decaying_t + growing_t R
        traction(1, :) = layer%decaying_t(1, :) + layer%growing_t(1, 1)*reflection(1, :) + layer%growing_t(1, 2)*reflection(2, :)
        traction(2, :) = layer%decaying_t(2, :) + reflection(2, :)
        determinant = 1.0_wp/(traction(1, 1)*traction(2, 2) - traction(1, 2)*traction(2, 1))
        part = times(layer%edge, reflection)
        down(:, 1) = determinant*(part(:, 1)*traction(2, 2) - part(:, 2)*traction(2, 1))
        down(:, 2) = determinant*(part(:, 2)*traction(1, 1) - part(:, 1)*traction(1, 2))
        part = down
    end function reflected_part

    !> The state (k U, k W, T, S) at the top from that at the bottom:
    !>     v(-x) = cosh(x sqrt K) v - sinh(x sqrt K)/sqrt K A w  with K = A B,  and the same of w with B A.
    pure function transfer_matrix(modes, x) result(p)
        type(modes_t), intent(in) :: modes
        complex(wp), intent(in) :: x
        complex(wp) :: p(4, 4)
        integer, parameter :: terms = 12
        complex(wp) :: even(0:1), odd(0:1), power(0:1), next, factor
        integer :: n

        ! of K^n = power(0) + power(1) K, by its characteristic equation, which is that of B Aalso
        power = [one, (0.0_wp, 0.0_wp)]
        even = power
        odd = x*power
        factor = 1.0_wp
        do n = 1, terms
            next = power(0) + modes%squares*power(1)
            power(0) = -modes%product**2*power(1)
            power(1) = next
            factor = factor*x*x/real(2*n*(2*n - 1), wp)
            even = even + factor*power
            odd = odd + factor*x/real(2*n + 1, wp)*power
        end do
        ! rows and columns k U, k W, T, S; v holds the first and the last
        p(1, [1, 4]) = even(1)*modes%ab(1, :)
        p(4, [1, 4]) = even(1)*modes%ab(2, :)
        p(2, 2:3) = even(1)*modes%ba(1, :)
        p(3, 2:3) = even(1)*modes%ba(2, :)
        do n = 1, 4
            p(n, n) = p(n, n) + even(0)
        end do
        p(1, 2:3) = -odd(0)*modes%a(1, :) - odd(1)*modes%aba(1, :)
        p(4, 2:3) = -odd(0)*modes%a(2, :) - odd(1)*modes%aba(2, :)
        p(2, [1, 4]) = -odd(0)*modes%b(1, :) - odd(1)*modes%bab(1, :)
        p(3, [1, 4]) = -odd(0)*modes%b(2, :) - odd(1)*modes%bab(2, :)
    end function transfer_matrix

end module mdrcontact_body_elements_transverse
