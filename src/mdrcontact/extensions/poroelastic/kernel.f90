! SPDX-License-Identifier: GPL-3.0-or-later
!> Response of the surface of a gel to waves of pressure, at the Laplace variable s: 2 G k C(k; s) = 1 + r (theory/poroelastic.md
!> (2.1), (2.2), (3.5), (5.6)).
!>
!> Agbezuge, Deresiewicz, Israel J. Technol. 12 (1974) 322; McNamee, Gibson, Q. J. Mech. Appl. Math. 13 (1960) 98.
module mdrcontact_poroelastic_kernel
    use mdrcontact_kinds, only: wp
    use mdrcontact_poroelastic_film, only: film_compliance
    use mdrcontact_poroelastic_gel, only: gel_t, sealed
    implicit none (type, external)
    private
    public :: relative_compliance, surface_flux, pore_part

contains

    !> r(k; s): 0 of an incompressible half-space, 1 - 2 nu of a drained one. Of the drainage sealed_by_indenter it is that of a
    !> surface which drains everywhere.
    elemental function relative_compliance(gel, k, s) result(r)
        type(gel_t), intent(in) :: gel
        !> real and > 0, or beyond the reach of a film's base [1/a]
        complex(wp), intent(in) :: k
        !> not on the negative axis [D/a^2]
        complex(wp), intent(in) :: s
        complex(wp) :: r

        ! beyond, the base changes it by less than rounding
        if (gel%ratio > 0.0_wp .and. real(k, wp) < 20.0_wp*gel%ratio) then
            r = film_compliance(gel%poisson, gel%drainage == sealed, real(k, wp)/gel%ratio, s/gel%ratio**2)
        else
            r = half_space_yield(gel, k, sqrt(k*k + s))
        end if
    end function relative_compliance

    !> r by q = sqrt(k^2 + s).
    elemental function half_space_yield(gel, k, q) result(r)
        type(gel_t), intent(in) :: gel
        complex(wp), intent(in) :: k, q
        complex(wp) :: r
        complex(wp) :: y

        y = gel%local()/(1.0_wp - gel%poisson)*k/(q + k)
        if (gel%drainage == sealed) y = y*k/q
        r = y/(1.0_wp - y)
    end function half_space_yield

    !> Phi/k: the flux through the surface of a half-space per k and total less pore pressure.
    elemental function surface_flux(gel, k, s) result(ratio)
        type(gel_t), intent(in) :: gel
        complex(wp), intent(in) :: k, s
        complex(wp) :: ratio
        complex(wp) :: q

        q = sqrt(k*k + s)
        ratio = (1.0_wp + half_space_yield(gel_t(gel%poisson), k, q))*s/(k*(q + k))
    end function surface_flux

    !> Pore pressure per total pressure at the surface of a half-space that is sealed everywhere.
    elemental function pore_part(gel, k, s) result(part)
        type(gel_t), intent(in) :: gel
        complex(wp), intent(in) :: k, s
        complex(wp) :: part

        part = surface_flux(gel, k, s)
        part = part/(1.0_wp + part)
    end function pore_part

end module mdrcontact_poroelastic_kernel
