! SPDX-License-Identifier: GPL-3.0-or-later
!> Which wavenumbers the Hankel integrals of stresses need, and the Bessel functions at them.
module mdrcontact_inside_waves
    use mdrcontact_gsl, only: gsl_sf_bessel_j0, gsl_sf_bessel_j1
    use mdrcontact_kinds, only: wp
    implicit none (type, external)
    private
    public :: faded, first_panel, part_of_waves, bessel_012

    !> exp(-faded) is negligible.
    real(wp), parameter :: faded = 42.0_wp
    !> Nodes times layers that are worked on together, of 50 bytes each, and nodes at least.
    integer, parameter :: most_amplitudes = 2000000, least_part = 256
    !> Where the octaves of wavenumbers begin, relative to the longest length on which the layers' state varies, or a + r.
    real(wp), parameter :: first_panel = 1.0e-3_wp

contains

    !> Number of nodes in a block for a given number of layers: memory for all nodes would grow with both.
    pure function part_of_waves(layers) result(number)
        integer, intent(in) :: layers
        integer :: number

        number = max(least_part, most_amplitudes/layers)
    end function part_of_waves

    !> J0(k r), J1(k r)/r and J2(k r)/r^2 with their limits at r = 0.
    pure subroutine bessel_012(k, r, j0, j1, j2)
        real(wp), intent(in) :: k, r
        real(wp), intent(out) :: j0, j1
        real(wp), intent(out), optional :: j2
        real(wp) :: x, term, square
        integer :: i

        x = k*r
        if (x > 1.0_wp) then
            j0 = gsl_sf_bessel_j0(x)
            j1 = gsl_sf_bessel_j1(x)/r
            if (present(j2)) j2 = (2.0_wp*j1/k - j0)/r**2
            return
        end if
        ! sum of (-x^2/4)^i/(i! (i + n)!) (k/2)^n
        square = 0.25_wp*x**2
        term = 1.0_wp
        j0 = 1.0_wp
        j1 = 1.0_wp
        square = -square
        if (present(j2)) j2 = 0.5_wp
        do i = 1, 9
            term = term*square/real(i, wp)**2
            j0 = j0 + term
            j1 = j1 + term/real(i + 1, wp)
            if (present(j2)) j2 = j2 + term/real((i + 1)*(i + 2), wp)
        end do
        j1 = 0.5_wp*k*j1
        if (present(j2)) j2 = 0.25_wp*k**2*j2
    end subroutine bessel_012

end module mdrcontact_inside_waves
