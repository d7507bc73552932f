! SPDX-License-Identifier: GPL-3.0-or-later
!> One film on a half-space or a rigid base, in closed form. Perriot, Barthel, J. Mater. Res. 19 (2004) 600.
!>
!> k C = (1 + 4 b t e - c b e^2)/(1 - (c + b + 4 b t^2) e + c b e^2) times that of a half-space of the film, t = kh, e = exp(-2 t),
!> is a quotient of differences that cancel for long waves and high contrasts. Here each is a sum of terms that do not. Shear in the
!> plane of the wave changes the sign of 4 b t alone.
module mdrcontact_body_film
    use mdrcontact_kinds, only: wp
    implicit none (type, external)
    private
    public :: film_t, new_film

    !> What the compliance depends on beside kh.
    type :: film_t
        private
        !> b, c, and 1 - b, 1 - c, 1 + c, 1 - b c
        complex(wp) :: b = 0.0_wp, c = 0.0_wp, b_rest = 1.0_wp, c_rest = 1.0_wp, one_plus_c = 1.0_wp, product_rest = 1.0_wp
    contains
        procedure :: response
        procedure :: in_plane_response
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

    !> sigma and chi = sigma - 1 at t = kh under normal load.
    pure subroutine response(self, t, sigma, chi)
        class(film_t), intent(in) :: self
        complex(wp), intent(in) :: t
        complex(wp), intent(out) :: sigma, chi

        call quotient(self, t, 1.0_wp, sigma, chi)
    end subroutine response

    !> The same under shear in the plane of the wave.
    pure subroutine in_plane_response(self, t, sigma, chi)
        class(film_t), intent(in) :: self
        complex(wp), intent(in) :: t
        complex(wp), intent(out) :: sigma, chi

        call quotient(self, t, -1.0_wp, sigma, chi)
    end subroutine in_plane_response

    pure subroutine quotient(self, t, way, sigma, chi)
        class(film_t), intent(in) :: self
        complex(wp), intent(in) :: t
        !> 1 for normal load, -1 for shear
        real(wp), intent(in) :: way
        complex(wp), intent(out) :: sigma, chi
        complex(wp) :: e, o, under, over, lowest

        e = exp(-2.0_wp*t)
        ! 1 - e
        o = 2.0_wp*exp(-t)*sinh(t)
        ! c + way
        lowest = merge(self%one_plus_c, -self%c_rest, way > 0.0_wp)
        associate (b => self%b, c => self%c, mixed => self%c*self%b_rest + self%b*self%c_rest)
            if (abs(t) < 1.0_wp) then
                ! sinh^2 t - t^2, and sinh 2t - 2t
                over = (sinh(t) + t)*beyond_linear(t)
                under = self%c_rest*self%b_rest + o*mixed + 4.0_wp*b*e*over - b*self%c_rest*o**2
                sigma = (self%product_rest + 2.0_wp*b*e*(c*beyond_linear(2.0_wp*t) + 2.0_wp*lowest*t))/under
            else
                under = 1.0_wp - (c + b + 4.0_wp*b*t**2)*e + c*b*e**2
                sigma = (1.0_wp + 4.0_wp*way*b*t*e - c*b*e**2)/under
            end if
            chi = e*(mixed + 2.0_wp*c*b*o + 4.0_wp*b*t*(way + t))/under
        end associate
    end subroutine quotient

    !> sinh(t) - t.
    pure function beyond_linear(t) result(value)
        complex(wp), intent(in) :: t
        complex(wp) :: value
        complex(wp) :: square
        integer :: n

        if (abs(t) > 1.0_wp) then
            value = sinh(t) - t
            return
        end if
        square = t**2
        value = 1.0_wp
        do n = 17, 5, -2
            value = 1.0_wp + value*square/real(n*(n - 1), wp)
        end do
        value = value*t*square/6.0_wp
    end function beyond_linear

end module mdrcontact_body_film
