! SPDX-License-Identifier: GPL-3.0-or-later
!> Closed forms of Popov (2014) for an incompressible coating on an incompressible half-space (theory/paper.md (4.5), (4.6), (5.5),
!> (5.6)), nu = 1/2: Popov 2014, equations (24), (27) without and (29), (31), (32) with adhesion.
module mdrcontact_contact_closed_forms
    use mdrcontact_kinds, only: half_pi, pi, wp
    use mdrcontact_weights, only: weight_i0, weight_j0
    implicit none (type, external)
    private
    public :: coated_paraboloid_force, coated_cone_force, coated_paraboloid_adhesive_depth
    public :: adhesive_radius_scale, adhesive_depth_scale, reduced_adhesive_depth

contains

    !> F(a) of a paraboloid, equation (24), xi = h/a:
    !> (16 a^3/(3R)) [G1 + (G0 - G1)/(2 pi) (4 arctan xi + xi^3 ln(1 + xi^-2) - xi)], xi = h/a.
    elemental function coated_paraboloid_force(a, radius, coating_shear, substrate_shear, thickness) result(force)
        !> a and R [length], G0 and G1 [modulus], h [length], all > 0
        real(wp), intent(in) :: a, radius, coating_shear, substrate_shear, thickness
        real(wp) :: force, xi, tail

        xi = thickness/a
        tail = xi*log_remainder(1.0_wp/xi**2)
        force = 8.0_wp*a**3/(3.0_wp*pi*radius)*(coating_shear*(4.0_wp*atan(xi) + tail) &
                                                + substrate_shear*(4.0_wp*atan(1.0_wp/xi) - tail))
    end function coated_paraboloid_force

    !> F(a) of a cone, equation (27): 2 pi a^2 tan(phi) [G1 + (G0 - G1) (2/pi) arctan(h/a)].
    elemental function coated_cone_force(a, inclination, coating_shear, substrate_shear, thickness) result(force)
        !> a [length], phi [radian], G0 and G1 [modulus], h [length], all > 0
        real(wp), intent(in) :: a, inclination, coating_shear, substrate_shear, thickness
        real(wp) :: force

        force = 2.0_wp*pi*a**2*tan(inclination) &
                *(coating_shear*atan(thickness/a) + substrate_shear*atan(a/thickness))/half_pi
    end function coated_cone_force

    !> d(a) of an adhesive paraboloid with the edge condition (28), equation (29): a^2/R - sqrt(2 pi a gamma/E_eff(a)).
    elemental function coated_paraboloid_adhesive_depth(a, radius, coating_shear, substrate_shear, thickness, &
                                                        work_of_adhesion) result(depth)
        !> a and R [length], G0 and G1 [modulus], h [length], gamma [modulus length]
        real(wp), intent(in) :: a, radius, coating_shear, substrate_shear, thickness, work_of_adhesion
        real(wp) :: depth, xi, shear

        xi = thickness/a
        shear = coating_shear*weight_i0(xi, 0.5_wp) + substrate_shear*weight_j0(xi, 0.5_wp)
        depth = a**2/radius - sqrt(half_pi*a*work_of_adhesion/shear)
    end function coated_paraboloid_adhesive_depth

    !> a_c = (pi gamma R^2/(32 G1))^(1/3), the contact radius at which an uncoated contact breaks under depth control,
    !> equation (31).
    elemental function adhesive_radius_scale(radius, substrate_shear, work_of_adhesion) result(scale)
        !> R [length], G1 [modulus], gamma [modulus length], all > 0
        real(wp), intent(in) :: radius, substrate_shear, work_of_adhesion
        real(wp) :: scale

        scale = (pi*work_of_adhesion*radius**2/(32.0_wp*substrate_shear))**(1.0_wp/3.0_wp)
    end function adhesive_radius_scale

    !> d_c = 3 (pi^2 gamma^2 R/(2^10 G1^2))^(1/3), minus its depth there, equation (31).
    elemental function adhesive_depth_scale(radius, substrate_shear, work_of_adhesion) result(scale)
        !> R [length], G1 [modulus], gamma [modulus length], all > 0
        real(wp), intent(in) :: radius, substrate_shear, work_of_adhesion
        real(wp) :: scale

        scale = 3.0_wp*((pi*work_of_adhesion/(32.0_wp*substrate_shear))**2*radius)**(1.0_wp/3.0_wp)
    end function adhesive_depth_scale

    !> d/d_c at a/a_c, equation (32): at^2/3 - (4/3) sqrt(at) [1 + (tau - 1) I0(ht/at; nu = 1/2)]^(-1/2).
    elemental function reduced_adhesive_depth(reduced_radius, shear_ratio, reduced_thickness) result(depth)
        !> at = a/a_c > 0, tau = G0/G1 > 0, ht = h/a_c > 0
        real(wp), intent(in) :: reduced_radius, shear_ratio, reduced_thickness
        real(wp) :: depth, xi

        xi = reduced_thickness/reduced_radius
        depth = (reduced_radius**2 - 4.0_wp*sqrt(reduced_radius/(shear_ratio*weight_i0(xi, 0.5_wp) + weight_j0(xi, 0.5_wp)))) &
                /3.0_wp
    end function reduced_adhesive_depth

    !> (ln(1 + t) - t)/t without cancellation at small t.
    elemental function log_remainder(t) result(value)
        real(wp), intent(in) :: t
        real(wp) :: value
        integer :: k

        if (t > huge(t)) then
            value = -1.0_wp
        else if (t > 0.1_wp) then
            value = log(1.0_wp + t)/t - 1.0_wp
        else
            value = 0.0_wp
            do k = 17, 2, -1
                value = (merge(-1.0_wp, 1.0_wp, mod(k, 2) == 0)/k + value)*t
            end do
        end if
    end function log_remainder

end module mdrcontact_contact_closed_forms
