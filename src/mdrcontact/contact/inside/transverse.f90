! SPDX-License-Identifier: GPL-3.0-or-later
!> The field of a half-space that is isotropic in its plane under a line load, in closed form: any roots, double and complex ones
!> included (theory/surfaces.md (8.3)-(8.6); Elliott 1948, Hanson 1992).
!>
!> The waves exp(-Q k z) v0 take the mean of a function at zeta_i = lambda_i z + i x times v0, and z times its divided difference
!> (f_1 - f_2)/(zeta_1 - zeta_2), which has closed forms without cancellation, times (Q - (trace Q)/2) v0. The antiderivatives P,
!> with rho_i = sqrt(r^2 + zeta_i^2) and alpha_i = rho_i + zeta_i:
!>     J0: ln alpha   k J0: -1/rho   J1/r: -1/alpha   k J1/r: -1/(rho alpha)   J2/r^2: -1/(2 alpha^2)   k J2 = 2 J1/r - k J0
module mdrcontact_inside_transverse
    use mdrcontact_body_elements_transverse, only: modes_t, new_modes
    use mdrcontact_inside_half_space, only: half_space_t, on_surface
    use mdrcontact_kinds, only: wp
    use mdrcontact_material_transverse, only: transverse_t
    implicit none (type, external)
    private
    public :: transverse_half_space_t, new_transverse_half_space

    !> The functions by their place in a list: their means, from `parted` on z times their divided differences, and from `across` on
    !> their values for waves across the plane.
    integer, parameter :: j0 = 1, k_j0 = 2, j1 = 3, k_j1 = 4, j2 = 5, kinds = 5, parted = kinds, across = 2*kinds

    !> Transversely isotropic half-space of six numbers, without a stress in its plane.
    type, extends(half_space_t) :: transverse_half_space_t
        private
        !> in units of 2 G of the body's surface
        type(modes_t) :: modes
        complex(wp) :: roots(2) = 1.0_wp
        !> y1 to y4 under a load across and along the surface: what goes with the mean, and with the divided difference
        real(wp) :: pressed(4, 2) = 0.0_wp, sheared(4, 2) = 0.0_wp
    contains
        procedure :: add_normal
        procedure :: add_shear
        procedure :: add_kernels
    end type transverse_half_space_t

contains

    !> Create a half-space of six numbers in units of 2 G.
    pure subroutine new_transverse_half_space(self, constants)
        type(transverse_half_space_t), intent(out) :: self
        type(transverse_t), intent(in) :: constants
        real(wp) :: sinks

        call new_modes(self%modes, constants)
        self%functions = 3*kinds
        self%normal_functions = 2*kinds
        self%roots = self%modes%roots()
        self%decay = constants%decay()
        self%turn = maxval(abs(aimag(self%roots)))
        self%pressed = amplitudes(self%modes, [0.0_wp, -1.0_wp])
        self%sheared = amplitudes(self%modes, [1.0_wp, 0.0_wp])
        ! k U over sigma_zz
        sinks = -self%pressed(1, 1)
        self%singular = constants%c + [constants%h, constants%h - 2.0_wp*constants%c66, constants%h - constants%c66]*sinks
        where (abs(self%singular) < 1.0e-12_wp) self%singular = 0.0_wp
    end subroutine new_transverse_half_space

    !> y1 to y4 at the surface under the traction (T, S), and those of (Q - (trace Q)/2) v.
    pure function amplitudes(modes, traction) result(y)
        type(modes_t), intent(in) :: modes
        real(wp), intent(in) :: traction(2)
        real(wp) :: y(4, 2)
        real(wp) :: v(2), w(2)
        integer :: i

        v = [-(traction(1) + modes%z(2, 2)*traction(2))/modes%z(2, 1), traction(2)]
        do i = 1, 2
            w = -matmul(modes%z, v)
            y(:, i) = [v(1), w(1), w(2), v(2)]
            v = matmul(modes%turn, v)
        end do
    end function amplitudes

    !> 2 G u_z, sigma_zz, int p_hat y1 k J0 dk, 2 G u_r/r, sigma_rz/r.
    pure subroutine add_normal(self, z, i, sums)
        class(transverse_half_space_t), intent(in) :: self
        real(wp), intent(in) :: z, i(:)
        real(wp), intent(inout) :: sums(:)

        associate (unused => z)
        end associate
        associate (y => self%pressed)
            sums = sums + [of_row(y(2, :), i, j0), of_row(y(4, :), i, k_j0), of_row(y(1, :), i, k_j0), of_row(y(1, :), i, j1), &
                           of_row(y(3, :), i, k_j1)]
        end associate
    end subroutine add_normal

    !> (y5 - y1) J0, (N - T) k J0, y2 J1/r, S k J1/r, y1 k J1/r, y5 k J1/r, (y5 + y1) J2/r^2, (N + T) k J2.
    pure subroutine add_shear(self, z, i, sums)
        class(transverse_half_space_t), intent(in) :: self
        real(wp), intent(in) :: z, i(:)
        real(wp), intent(inout) :: sums(:)
        real(wp) :: y5

        associate (unused => z)
        end associate
        y5 = 1.0_wp/self%modes%shear
        ! N = -exp(-lambda_3 k z)
        associate (y => self%sheared)
            sums = sums + [y5*i(across + j0) - of_row(y(1, :), i, j0), -i(across + k_j0) - of_row(y(3, :), i, k_j0), &
                           of_row(y(2, :), i, j1), of_row(y(4, :), i, k_j1), of_row(y(1, :), i, k_j1), y5*i(across + k_j1), &
                           y5*i(across + j2) + of_row(y(1, :), i, j2), 2.0_wp*(of_row(y(3, :), i, j1) - i(across + j1)) &
                           - of_row(y(3, :), i, k_j0) + i(across + k_j0)]
        end associate
    end subroutine add_shear

    !> The Hankel integral of a row of the state: of what goes with the mean, and with the divided difference.
    pure function of_row(row, integrals, kind) result(value)
        real(wp), intent(in) :: row(2), integrals(:)
        integer, intent(in) :: kind
        real(wp) :: value

        value = row(1)*integrals(kind) + row(2)*integrals(parted + kind)
    end function of_row

    pure subroutine add_kernels(self, r, z, t, weight, integrals)
        class(transverse_half_space_t), intent(in) :: self
        real(wp), intent(in) :: r, z, t(:), weight(:)
        real(wp), intent(inout) :: integrals(:)
        complex(wp) :: zeta(2), rho(2), other, mean(kinds), apart(kinds), alone(kinds)
        integer :: n

        if (.not. z > 0.0_wp) then
            integrals(:kinds) = integrals(:kinds) + on_surface(r, t, weight)
            if (size(integrals) > across) integrals(across + 1:) = integrals(across + 1:) + on_surface(r, t, weight)
            return
        end if
        do n = 1, size(t)
            zeta = cmplx(0.0_wp, r + t(n), wp) + self%roots*z
            rho = distance(r, z*self%roots, t(n))
            mean = 0.5_wp*(values(zeta(1), rho(1)) + values(zeta(2), rho(2)))
            apart = z*differences(zeta, rho)
            integrals(:kinds) = integrals(:kinds) + weight(n)*aimag(mean)
            integrals(parted + 1:across) = integrals(parted + 1:across) + weight(n)*aimag(apart)
            if (size(integrals) == across) cycle
            other = cmplx(self%modes%across*z, r + t(n), wp)
            alone = values(other, distance(r, cmplx(self%modes%across*z, kind=wp), t(n)))
            integrals(across + 1:) = integrals(across + 1:) + weight(n)*aimag(alone)
        end do
    end subroutine add_kernels

    !> rho without the cancellation of r^2 + (depth + i (r + t))^2.
    elemental function distance(r, depth, t) result(rho)
        real(wp), intent(in) :: r, t
        complex(wp), intent(in) :: depth
        complex(wp) :: rho

        rho = sqrt(depth**2 - t*(2.0_wp*r + t) + cmplx(0.0_wp, 2.0_wp*(r + t), wp)*depth)
    end function distance

    !> The antiderivatives P.
    pure function values(zeta, rho) result(p)
        complex(wp), intent(in) :: zeta, rho
        complex(wp) :: p(kinds)
        complex(wp) :: alpha

        alpha = rho + zeta
        p(j0) = log(alpha)
        p(k_j0) = -1.0_wp/rho
        p(j1) = -1.0_wp/alpha
        p(k_j1) = p(j1)/rho
        p(j2) = -0.5_wp*p(j1)**2
    end function values

    !> Their divided differences.
    pure function differences(zeta, rho) result(p)
        complex(wp), intent(in) :: zeta(2), rho(2)
        complex(wp) :: p(kinds)
        complex(wp) :: alpha(2), total, slope, rise

        alpha = rho + zeta
        total = (zeta(1) + zeta(2))/(rho(1) + rho(2))
        rise = 1.0_wp + total
        slope = rise/(alpha(1)*alpha(2))
        p(j0) = rise/alpha(2)*log_slope((zeta(1) - zeta(2))*rise/alpha(2))
        p(k_j0) = total/(rho(1)*rho(2))
        p(j1) = slope
        p(k_j1) = (zeta(1)*rise + zeta(2) + rho(2))/(rho(1)*alpha(1)*rho(2)*alpha(2))
        p(j2) = 0.5_wp*slope*(alpha(1) + alpha(2))/(alpha(1)*alpha(2))
    end function differences

    !> ln(1 + x)/x.
    elemental function log_slope(x) result(slope)
        complex(wp), intent(in) :: x
        complex(wp) :: slope
        complex(wp) :: y

        if (abs(x) > 0.1_wp) then
            slope = log(1.0_wp + x)/x
        else
            ! 2 artanh(y)/x
            y = (x/(2.0_wp + x))**2
            slope = 2.0_wp/(2.0_wp + x)*(1.0_wp + y*(1.0_wp/3.0_wp + y*(0.2_wp + y*(1.0_wp/7.0_wp + y*(1.0_wp/9.0_wp + y*( &
                    1.0_wp/11.0_wp))))))
        end if
    end function log_slope

end module mdrcontact_inside_transverse
