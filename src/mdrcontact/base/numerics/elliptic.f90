! SPDX-License-Identifier: GPL-3.0-or-later
!> Complete elliptic integrals of the modulus sqrt(1 - kappa^2), kappa > 0, by those of Carlson.
module mdrcontact_numerics_elliptic
    use, intrinsic :: iso_c_binding, only: c_int
    use mdrcontact_gsl, only: gsl_sf_ellint_rd, gsl_sf_ellint_rf
    use mdrcontact_kinds, only: wp
    implicit none (type, external)
    private
    public :: complete_b, complete_k

contains

    !> K = int_0^(pi/2) dt/sqrt(cos^2 t + kappa^2 sin^2 t).
    elemental function complete_k(kappa) result(value)
        real(wp), intent(in) :: kappa
        real(wp) :: value

        value = gsl_sf_ellint_rf(0.0_wp, kappa**2, 1.0_wp, 0_c_int)
    end function complete_k

    !> B = (E - kappa^2 K)/(1 - kappa^2), the same integral with cos^2 t above.
    elemental function complete_b(kappa) result(value)
        real(wp), intent(in) :: kappa
        real(wp) :: value

        value = kappa**2/3.0_wp*gsl_sf_ellint_rd(0.0_wp, 1.0_wp, kappa**2, 0_c_int)
    end function complete_b

end module mdrcontact_numerics_elliptic
