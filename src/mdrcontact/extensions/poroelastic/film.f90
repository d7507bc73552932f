! SPDX-License-Identifier: GPL-3.0-or-later
!> The surface of a gel film of thickness 1, bonded to a rigid base that lets no fluid through: three waves that decay downwards
!> from the surface and their mirrors that decay from the base up, under six conditions at one k and s (theory/poroelastic.md (1.1),
!> (1.2), (4.1)).
module mdrcontact_poroelastic_film
    use mdrcontact_kinds, only: wp
    implicit none (type, external)
    private
    public :: film_compliance

    !> Below this k the film is compressed as if it were loaded all over: consolidation.
    real(wp), parameter :: longest = 1.0e-4_wp
    !> Meaning of the rows: along, down, shear, stress, pore pressure and its slope.
    integer, parameter :: along = 1, down = 2, shear = 3, stress = 4, pore = 5, flux = 6

contains

    !> r = 2 G k C - 1.
    pure function film_compliance(poisson, is_sealed, k, s) result(r)
        real(wp), intent(in) :: poisson
        logical, intent(in) :: is_sealed
        !> [1/thickness], [D/thickness^2]
        real(wp), intent(in) :: k
        complex(wp), intent(in) :: s
        complex(wp) :: r
        complex(wp) :: top(6, 6), base(6, 6), system(6, 7), modulus, q
        integer :: drain

        q = sqrt(k*k + s)
        modulus = 2.0_wp*(1.0_wp - poisson)/(1.0_wp - 2.0_wp*poisson)
        if (k < longest .and. .not. is_sealed) then
            r = 2.0_wp*k/modulus*tanh(sqrt(s))/sqrt(s) - 1.0_wp
            return
        end if
        top = waves(real(modulus, wp), k, q, 0.0_wp)
        base = waves(real(modulus, wp), k, q, 1.0_wp)
        drain = merge(flux, pore, is_sealed)
        system(:3, :6) = top([stress, shear, drain], :)
        system(4:, :6) = base([along, down, flux], :)
        system(:, 7) = [-1.0_wp, 0.0_wp, 0.0_wp, 0.0_wp, 0.0_wp, 0.0_wp]
        call eliminate(system)
        r = 2.0_wp*k*sum(top(down, :)*system(:, 7)) - 1.0_wp
    end function film_compliance

    !> The rows of the six waves at depth z.
    pure function waves(modulus, k, q, z) result(rows)
        real(wp), intent(in) :: modulus, k, z
        complex(wp), intent(in) :: q
        complex(wp) :: rows(6, 6)
        real(wp), parameter :: mirror(6) = [1.0_wp, -1.0_wp, -1.0_wp, 1.0_wp, 1.0_wp, -1.0_wp]
        integer :: i

        rows(:, :3) = decaying(modulus, k, q, z)
        rows(:, 4:) = decaying(modulus, k, q, 1.0_wp - z)
        do i = 4, 6
            rows(:, i) = mirror*rows(:, i)
        end do
    end function waves

    !> The two of an incompressible body, the second with a harmonic pore pressure, and that of dilation, from which so much of the
    !> first is taken that it stays independent of the others as s -> 0.
    pure function decaying(modulus, k, q, z) result(rows)
        real(wp), intent(in) :: modulus, k, z
        complex(wp), intent(in) :: q
        complex(wp) :: rows(6, 3)
        complex(wp) :: fast, rest
        real(wp) :: e

        e = exp(-k*z)
        fast = exp(-q*z)
        rest = -z*e*fall((q - k)*z)
        rows(:, 1) = e*[1.0_wp, 1.0_wp, -2.0_wp*k, -2.0_wp*k, 0.0_wp, 0.0_wp]
        rows(:, 2) = e*[k*z, k*z + 1.0_wp, -2.0_wp*k*k*z, -2.0_wp*k*(k*z + 1.0_wp), 2.0_wp*k, -2.0_wp*k*k]
        rows(:, 3) = [-k*rest, -fast - k*rest, 2.0_wp*k*(fast + k*rest), 2.0_wp*k*k*rest, modulus*(q + k)*fast, &
                      -modulus*q*(q + k)*fast]
    end function decaying

    !> (1 - e^-x)/x.
    pure function fall(x) result(value)
        complex(wp), intent(in) :: x
        complex(wp) :: value
        integer :: i

        if (abs(real(x, wp)) + abs(aimag(x)) > 0.5_wp) then
            value = (1.0_wp - exp(-x))/x
        else
            value = 1.0_wp
            do i = 15, 2, -1
                value = 1.0_wp - x/i*value
            end do
        end if
    end function fall

    !> Gauss's elimination with partial pivoting; the last column becomes the solution. LAPACK costs more than six rows do.
    pure subroutine eliminate(a)
        complex(wp), intent(inout) :: a(6, 7)
        complex(wp) :: row(7)
        integer :: i, j, p

        do i = 1, 6
            p = maxloc(abs(real(a(i:, i), wp)) + abs(aimag(a(i:, i))), dim=1) + i - 1
            row = a(p, :)
            a(p, :) = a(i, :)
            a(i, :) = row/row(i)
            do j = 1, 6
                if (j == i) cycle
                a(j, i + 1:) = a(j, i + 1:) - a(j, i)*a(i, i + 1:)
            end do
        end do
    end subroutine eliminate

end module mdrcontact_poroelastic_film
