! SPDX-License-Identifier: GPL-3.0-or-later
!> Weight of each point of a half-space in the effective modulus at contact radius a (theory/lateral.md (2.4), (2.5)), lengths
!> in units of a.
!>
!> First-order perturbation of the frictionless flat punch: the relative change of the stiffness is the strain energy that a
!> change of the moduli adds, divided by the whole. The field for any Poisson's ratio follows from one harmonic function psi
!> (2G = 1):
!>     u_r = (1 - 2 nu) phi_r - z psi_r,   u_z = 2 (1 - nu) psi - z psi_z,   phi_z = -psi.
!> With c = z + i and R = sqrt(rho^2 + c^2) = s + i t, all derivatives are elementary:
!>     psi = (2/pi) Im ln(R + c),   psi_z = (2/pi) Im 1/R,   phi_r/rho = (2/pi) Im 1/(R + c).
!> s and t are oblate spheroidal coordinates, rho^2 = (1 + s^2)(1 - t^2), z = s t, and the volume element is (s^2 + t^2) ds dt
!> dtheta.
module mdrcontact_lateral_density
    use mdrcontact_nonfinite, only: infinity
    use mdrcontact_kinds, only: pi, wp
    implicit none (type, external)
    private
    public :: lateral_density, lateral_density_spheroidal, deviatoric_weight, volumetric_weight

    !> Beyond this both weights, which fall as R^-4, are below all numbers; |sqrt(rho^2 + c^2)| below which its cube has no inverse.
    real(wp), parameter :: farthest = 1.0e80_wp, nearest = 1.0e-100_wp

contains

    !> The pair of weights at (rho, z), z >= 0, each with integral 1 over the half-space: `shear` for G at constant nu,
    !> `poisson` for nu.
    !>     delta E*/E* = int shear delta G/G dV + int poisson delta nu dV/(1 - nu)
    !> Integrated over planes z they are dI0/dz and dI1/dz of theory/paper.md (3.3), (3.4). Both grow as 1/distance at the edge
    !> rho = 1, z = 0.
    elemental subroutine lateral_density(rho, z, nu, shear, poisson)
        !> distance from the axis >= 0 and depth >= 0, in units of a
        real(wp), intent(in) :: rho, z
        !> Poisson's ratio of the reference medium, -1 < nu <= 1/2
        real(wp), intent(in) :: nu
        !> weights of G and of nu, densities per volume in units of a^3 [1]
        real(wp), intent(out) :: shear, poisson
        complex(wp) :: root

        shear = 0.0_wp
        poisson = 0.0_wp
        if (max(rho, z) > farthest) return
        root = sqrt(cmplx((rho - 1.0_wp)*(rho + 1.0_wp) + z**2, 2.0_wp*z, wp))
        if (abs(root) < nearest) then
            shear = infinity
            poisson = shear
            return
        end if
        call from_root(rho, z, root, nu, shear, poisson)
    end subroutine lateral_density

    !> The same at spheroidal coordinates s >= 0, 0 <= t <= 1, precise up to the edge s = t = 0 itself.
    elemental subroutine lateral_density_spheroidal(s, t, nu, shear, poisson)
        real(wp), intent(in) :: s, t, nu
        real(wp), intent(out) :: shear, poisson

        call from_root(sqrt((1.0_wp + s**2)*(1.0_wp - t)*(1.0_wp + t)), s*t, cmplx(s, t, wp), nu, shear, poisson)
    end subroutine lateral_density_spheroidal

    !> Energy of volume change over all energy: the weight of ln K, the bulk modulus, at constant G.
    elemental function volumetric_weight(rho, z, nu) result(weight)
        !> as in lateral_density
        real(wp), intent(in) :: rho, z, nu
        real(wp) :: weight, shear, poisson

        call lateral_density(rho, z, nu, shear, poisson)
        weight = volumetric_share(nu)*poisson
    end function volumetric_weight

    !> Energy of shape change over all energy: the weight of ln G at constant K.
    elemental function deviatoric_weight(rho, z, nu) result(weight)
        !> as in lateral_density
        real(wp), intent(in) :: rho, z, nu
        real(wp) :: weight, shear, poisson

        call lateral_density(rho, z, nu, shear, poisson)
        weight = shear - volumetric_share(nu)*poisson
    end function deviatoric_weight

    !> At constant G, delta ln K = 3 delta nu/((1 + nu)(1 - 2 nu)).
    elemental function volumetric_share(nu) result(share)
        real(wp), intent(in) :: nu
        real(wp) :: share

        share = (1.0_wp + nu)*(1.0_wp - 2.0_wp*nu)/(3.0_wp*(1.0_wp - nu))
    end function volumetric_share

    elemental subroutine from_root(rho, z, root, nu, shear, poisson)
        real(wp), intent(in) :: rho, z, nu
        complex(wp), intent(in) :: root
        real(wp), intent(out) :: shear, poisson
        complex(wp) :: c, q, cube
        real(wp) :: m, psi_z, psi_zz, psi_rz, psi_r, phi_r, e_rr, e_tt, e_zz, e_rz

        c = cmplx(z, 1.0_wp, wp)
        q = 1.0_wp/root
        cube = q*q*q
        psi_z = (2.0_wp/pi)*aimag(q)
        psi_zz = -(2.0_wp/pi)*aimag(c*cube)
        psi_rz = -(2.0_wp/pi)*rho*aimag(cube)
        ! psi_r and phi_r: first derivatives over rho
        psi_r = (2.0_wp/pi)*aimag(q/(root + c))
        phi_r = (2.0_wp/pi)*aimag(1.0_wp/(root + c))
        m = 1.0_wp - 2.0_wp*nu
        e_rr = z*(psi_zz + psi_r) + m*(psi_z - phi_r)
        e_tt = -z*psi_r + m*phi_r
        e_zz = m*psi_z - z*psi_zz
        e_rz = -z*psi_rz
        poisson = 0.5_wp*psi_z**2
        shear = (0.5_wp*(e_rr**2 + e_tt**2 + e_zz**2 + 2.0_wp*e_rz**2) + 2.0_wp*nu*m*psi_z**2)/(4.0_wp*(1.0_wp - nu))
    end subroutine from_root

end module mdrcontact_lateral_density
