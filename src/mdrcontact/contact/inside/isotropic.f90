! SPDX-License-Identifier: GPL-3.0-or-later
!> The field of an isotropic half-space under a line load, in closed form (theory/stress.md (4.2)-(4.10), (6.7)-(6.10)).
!>
!> With zeta = z + i x and rho = sqrt(r^2 + zeta^2), Re rho >= 0, each field is a sum of integrals (mdrcontact_inside_half_space) of
!>     A0 = 1/rho   A1 = zeta/rho^3   A2 = (2 zeta^2 - r^2)/rho^5                                   (Hankel integrals with J0)
!>     b0 = 1/(rho (rho + zeta))   b1 = 1/rho^3   b2 = 3 zeta/rho^5                                 (J1/r)
!>     c0 = 1/(rho (rho + zeta)^2)   c1 = (zeta + 2 rho)/(rho^3 (rho + zeta)^2)                     (J2/r^2)
module mdrcontact_inside_isotropic
    use mdrcontact_inside_half_space, only: half_space_rule_t, half_space_t, integrate, on_surface
    use mdrcontact_kinds, only: wp
    use mdrcontact_medium_load, only: load_t
    implicit none (type, external)
    private
    public :: isotropic_half_space_t, new_isotropic_half_space

    !> The integrals by their place in a list.
    integer, parameter :: a0 = 1, a1 = 2, a2 = 3, b0 = 4, b1 = 5, b2 = 6, c0 = 7, c1 = 8, kernels = 8

    !> Isotropic half-space of one Poisson's ratio.
    type, extends(half_space_t) :: isotropic_half_space_t
        real(wp) :: poisson = 0.0_wp
    contains
        procedure :: add_normal
        procedure :: add_shear
        procedure :: add_normal_image
        procedure :: add_shear_image
        procedure :: add_kernels
    end type isotropic_half_space_t

contains

    !> Create an isotropic half-space of Poisson's ratio nu.
    pure subroutine new_isotropic_half_space(self, poisson)
        type(isotropic_half_space_t), intent(out) :: self
        real(wp), intent(in) :: poisson

        self%poisson = poisson
        self%functions = kernels
        self%normal_functions = kernels
        self%singular = [1.0_wp, 2.0_wp*poisson, poisson + 0.5_wp]
    end subroutine new_isotropic_half_space

    !> Adds the homogeneous body's part to the five sums of a normal load at one point:
    !>     2 G u_z, sigma_zz, int p_hat y1 k J0 dk, 2 G u_r/r, sigma_rz/r                                 (lengths in units of a)
    pure subroutine add_normal(self, z, i, sums)
        class(isotropic_half_space_t), intent(in) :: self
        real(wp), intent(in) :: z, i(:)
        real(wp), intent(inout) :: sums(:)

        associate (nu => self%poisson)
            sums = sums + [2.0_wp*(1.0_wp - nu)*i(a0) + z*i(a1), -i(a1) - z*i(a2), -(1.0_wp - 2.0_wp*nu)*i(a1) + z*i(a2), &
                           -(1.0_wp - 2.0_wp*nu)*i(b0) + z*i(b1), -z*i(b2)]
        end associate
    end subroutine add_normal

    !> Adds the homogeneous body's part to the eight sums of a load that shears, p(r) in +x: the Hankel integrals of
    !>     (y5 - y1) J0, (N - T) k J0, y2 J1/r, S k J1/r, y1 k J1/r, y5 k J1/r, (y5 + y1) J2/r^2, (N + T) k J2
    pure subroutine add_shear(self, z, i, sums)
        class(isotropic_half_space_t), intent(in) :: self
        real(wp), intent(in) :: z, i(:)
        real(wp), intent(inout) :: sums(:)

        associate (nu => self%poisson)
            sums = sums + [(4.0_wp - 2.0_wp*nu)*i(a0) - z*i(a1), -2.0_wp*i(a1) + z*i(a2), &
                           (1.0_wp - 2.0_wp*nu)*i(b0) + z*i(b1), -z*i(b2), -2.0_wp*(1.0_wp - nu)*i(b1) + z*i(b2), &
                           2.0_wp*i(b1), 2.0_wp*nu*i(c0) + z*i(c1), z*(i(a2) - 2.0_wp*i(b1))]
        end associate
    end subroutine add_shear

    !> Adds the normal load's sums of a state (alpha + beta k z) e^(-k (z + shift)).
    pure subroutine add_normal_image(self, rule, load, shift, alpha, beta, r, z, sums)
        class(isotropic_half_space_t), intent(in) :: self
        type(half_space_rule_t), intent(in) :: rule
        class(load_t), intent(in) :: load
        !> [a], and y1 to y4
        real(wp), intent(in) :: shift, alpha(:), beta(:)
        !> distance from the axis [length] and depth [a] of the point
        real(wp), intent(in) :: r, z
        real(wp), intent(inout) :: sums(:)
        real(wp) :: i(kernels)

        call integrate(self, rule, load, r, z + shift, i)
        associate (b => z*beta)
            sums = sums + [alpha(2)*i(a0) + b(2)*i(a1), alpha(4)*i(a1) + b(4)*i(a2), alpha(1)*i(a1) + b(1)*i(a2), &
                           alpha(1)*i(b0) + b(1)*i(b1), alpha(3)*i(b1) + b(3)*i(b2)]
        end associate
    end subroutine add_normal_image

    !> The same under a load that shears; k J2 = 2 J1/r - k J0.
    pure subroutine add_shear_image(self, rule, load, shift, alpha, beta, r, z, sums)
        class(isotropic_half_space_t), intent(in) :: self
        type(half_space_rule_t), intent(in) :: rule
        class(load_t), intent(in) :: load
        !> [a], and y1 to y5 and N
        real(wp), intent(in) :: shift, alpha(:), beta(:)
        !> distance from the axis [length] and depth [a] of the point
        real(wp), intent(in) :: r, z
        real(wp), intent(inout) :: sums(:)
        real(wp) :: i(kernels)

        call integrate(self, rule, load, r, z + shift, i)
        associate (b => z*beta)
            sums = sums + [(alpha(5) - alpha(1))*i(a0) + (b(5) - b(1))*i(a1), (alpha(6) - alpha(3))*i(a1) + (b(6) - b(3))*i(a2), &
                           alpha(2)*i(b0) + b(2)*i(b1), alpha(4)*i(b1) + b(4)*i(b2), alpha(1)*i(b1) + b(1)*i(b2), &
                           alpha(5)*i(b1) + b(5)*i(b2), (alpha(5) + alpha(1))*i(c0) + (b(5) + b(1))*i(c1), &
                           (alpha(6) + alpha(3))*(2.0_wp*i(b0) - i(a1)) + (b(6) + b(3))*(2.0_wp*i(b1) - i(a2))]
        end associate
    end subroutine add_shear_image

    !> Adds sum of weight Im P(z + i (r + t)) for all kernels.
    pure subroutine add_kernels(self, r, z, t, weight, integrals)
        class(isotropic_half_space_t), intent(in) :: self
        real(wp), intent(in) :: r, z, t(:), weight(:)
        real(wp), intent(inout) :: integrals(:)

        associate (unused => self)
        end associate

        if (z > 0.0_wp) then
            call add_inside(r, z, t, weight, integrals)
        else
            ! the others occur with a factor z
            integrals([a0, a1, b0, b1, c0]) = integrals([a0, a1, b0, b1, c0]) + on_surface(r, t, weight)
        end if
    end subroutine add_kernels

    pure subroutine add_inside(r, z, t, weight, integrals)
        real(wp), intent(in) :: r, z, t(:), weight(:)
        real(wp), intent(inout) :: integrals(kernels)
        real(wp), dimension(size(t)) :: im_a0, im_a1, im_a2, im_b0, im_b1, im_b2, im_c0, im_c1
        real(wp) :: x, square, cross, modulus, root, rho_re, rho_im, g_re, g_im, inv_re, inv_im, inv2_re, inv2_im, inv3_re, &
                    inv3_im, h_re, h_im, b_re, b_im
        integer :: i

        do i = 1, size(t)
            x = r + t(i)
            ! rho^2 without the cancellation of r^2 + zeta^2
            square = z**2 - t(i)*(2.0_wp*r + t(i))
            cross = 2.0_wp*z*x
            modulus = sqrt(square**2 + cross**2)
            root = sqrt(0.5_wp*(modulus + abs(square)))
            rho_re = merge(root, 0.5_wp*cross/root, square >= 0.0_wp)
            rho_im = merge(0.5_wp*cross/root, root, square >= 0.0_wp)
            inv_re = rho_re/modulus
            inv_im = -rho_im/modulus
            h_re = rho_re + z
            h_im = rho_im + x
            root = 1.0_wp/(h_re**2 + h_im**2)
            g_re = h_re*root
            g_im = -h_im*root
            inv2_re = inv_re**2 - inv_im**2
            inv2_im = 2.0_wp*inv_re*inv_im
            inv3_re = inv2_re*inv_re - inv2_im*inv_im
            inv3_im = inv2_re*inv_im + inv2_im*inv_re
            b_re = inv_re*g_re - inv_im*g_im
            b_im = inv_re*g_im + inv_im*g_re
            im_a0(i) = atan2(h_im, h_re)
            im_a1(i) = -inv_im
            im_a2(i) = -(z*inv3_im + x*inv3_re)
            im_b0(i) = -g_im
            im_b1(i) = -b_im
            im_b2(i) = -inv3_im
            im_c0(i) = -g_re*g_im
            im_c1(i) = -(b_re*g_im + b_im*g_re)
        end do
        integrals = integrals + [sum(weight*im_a0), sum(weight*im_a1), sum(weight*im_a2), sum(weight*im_b0), sum(weight*im_b1), &
                                 sum(weight*im_b2), sum(weight*im_c0), sum(weight*im_c1)]
    end subroutine add_inside

end module mdrcontact_inside_isotropic
