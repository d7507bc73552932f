! SPDX-License-Identifier: GPL-3.0-or-later
!> One film on a half-space or a rigid base, in closed form (theory/exact.md (2.3)). Perriot, Barthel, J. Mater. Res. 19 (2004) 600.
!>
!> k C = (1 + 4 b t e - c b e^2)/(1 - (c + b + 4 b t^2) e + c b e^2) times that of a half-space of the film, t = kh, e = exp(-2 t),
!> is a quotient of differences that cancel for long waves and high contrasts. Here each is a sum of terms that do not. Shear in the
!> plane of the wave changes the sign of 4 b t alone (theory/friction.md (2.4)).
module mdrcontact_body_film
    use mdrcontact_body_compliance, only: along
    use mdrcontact_kinds, only: wp
    implicit none (type, external)
    private
    public :: film_t, new_film

    !> Parameters of the compliance in addition to kh.
    type :: film_t
        private
        !> b, c, and 1 - b, 1 - c, 1 + c, 1 - b c
        complex(wp) :: b = 0.0_wp, c = 0.0_wp, b_rest = 1.0_wp, c_rest = 1.0_wp, one_plus_c = 1.0_wp, product_rest = 1.0_wp
    contains
        procedure :: response
    end type film_t

contains

    !> The film of these Poisson's ratios on a base; complex constants where it oscillates.
    pure function new_film(film_poisson, base_poisson, contrast) result(self)
        complex(wp), intent(in) :: film_poisson, base_poisson
        !> shear modulus of the film over that of the base; 0 on a rigid base
        complex(wp), intent(in) :: contrast
        type(film_t) :: self
        complex(wp) :: film, base

        film = 3.0_wp - 4.0_wp*film_poisson
        base = 3.0_wp - 4.0_wp*base_poisson
        self%b = (contrast - 1.0_wp)/(contrast + film)
        self%c = (contrast*base - film)/(1.0_wp + contrast*base)
        self%b_rest = (1.0_wp + film)/(contrast + film)
        self%c_rest = (1.0_wp + film)/(1.0_wp + contrast*base)
        self%one_plus_c = (2.0_wp*contrast*base + (4.0_wp*film_poisson - 2.0_wp))/(1.0_wp + contrast*base)
        self%product_rest = contrast*(1.0_wp + film)*(1.0_wp + base)/((contrast + film)*(1.0_wp + contrast*base))
    end function new_film

    !> one_plus_chi and chi = one_plus_chi - 1 at t = kh under a load in the plane of the wave.
    pure subroutine response(self, t, direction, one_plus_chi, chi)
        class(film_t), intent(in) :: self
        complex(wp), intent(in) :: t
        !> along the surface or normal to it
        integer, intent(in) :: direction
        complex(wp), intent(out) :: one_plus_chi, chi
        real(wp) :: way
        complex(wp) :: e, o, under, x, sine, cosine, mixed, lowest
        integer :: j
        !> (sinh t - t)/t^3 and (cosh t - 1)/t^2 as series in t^2
        real(wp), parameter :: of_sine(0:*) = [(1.0_wp/gamma(real(2*j + 4, wp)), j=0, 8)], &
                               of_cosine(0:*) = [(1.0_wp/gamma(real(2*j + 3, wp)), j=0, 8)]

        way = merge(-1.0_wp, 1.0_wp, direction == along)
        mixed = self%c*self%b_rest + self%b*self%c_rest
        x = t*t
        associate (b => self%b, c => self%c)
            if (real(t, wp)**2 + aimag(t)**2 < 1.0_wp) then
                sine = of_sine(8)
                cosine = of_cosine(8)
                do j = 7, 0, -1
                    sine = of_sine(j) + x*sine
                    cosine = of_cosine(j) + x*cosine
                end do
                sine = t*x*sine
                cosine = x*cosine
                e = 1.0_wp/(1.0_wp + t + sine + cosine)
                ! 1 - exp(-2t)
                o = 2.0_wp*e*(t + sine)
                e = e*e
                ! c + way
                lowest = merge(self%one_plus_c, -self%c_rest, way > 0.0_wp)
                ! sinh^2 t - t^2, and half of sinh 2t - 2t
                under = self%c_rest*self%b_rest + o*mixed + 4.0_wp*b*e*(2.0_wp*t + sine)*sine - b*self%c_rest*(o*o)
                one_plus_chi = (self%product_rest + 4.0_wp*b*e*(c*(sine + (t + sine)*cosine) + lowest*t))/under
            else
                e = exp(-2.0_wp*t)
                o = 1.0_wp - e
                under = 1.0_wp - (c + b + 4.0_wp*b*x)*e + c*b*(e*e)
                one_plus_chi = (1.0_wp + 4.0_wp*way*b*t*e - c*b*(e*e))/under
            end if
            chi = e*(mixed + 2.0_wp*c*b*o + 4.0_wp*b*t*(way + t))/under
        end associate
    end subroutine response

end module mdrcontact_body_film
