! SPDX-License-Identifier: GPL-3.0-or-later
!> Which wavenumbers the Hankel integrals of stresses need, and the Bessel functions at them.
!>
!> Panels of Gauss nodes: octaves from k = 0 up, where a stiff film's state varies on the scale of its bending, then of one length
!> that resolves the waves of a contact of radius a = 1 seen at distance r.
module mdrcontact_inside_waves
    use mdrcontact_gsl, only: gsl_sf_bessel_j0, gsl_sf_bessel_j1
    use mdrcontact_error, only: error_domain, error_t, raise, to_text
    use mdrcontact_kinds, only: wp
    use mdrcontact_numerics_quadrature, only: gauss_legendre
    implicit none (type, external)
    private
    public :: faded, panel_nodes, wave_rule, part_of_waves, bessel_012

    !> exp(-faded) is nothing.
    real(wp), parameter :: faded = 42.0_wp
    !> Nodes in a panel; the largest phase of cos(k (a + r)) in one, where 16 nodes integrate to 1e-16.
    integer, parameter :: panel_nodes = 16
    real(wp), parameter :: longest_phase = 15.0_wp
    !> Nodes at most: some seconds.
    real(wp), parameter :: most_waves = 1.0e6_wp
    !> Nodes times layers that are worked on together, of 50 bytes each, and nodes at least.
    integer, parameter :: most_amplitudes = 2000000, least_part = 256
    !> Where the octaves begin, relative to the longest structure.
    real(wp), parameter :: first_panel = 1.0e-3_wp

contains

    !> Nodes k and weights dk on [0, last].
    subroutine wave_rule(farthest, structure, last, k, weight, error)
        !> a + r at most, in units of a
        real(wp), intent(in) :: farthest
        !> the longest length on which the layers' state varies; 0 if it does not
        real(wp), intent(in) :: structure
        !> largest k > 0
        real(wp), intent(in) :: last
        real(wp), allocatable, intent(out) :: k(:), weight(:)
        type(error_t), allocatable, intent(inout) :: error
        real(wp), allocatable :: ends(:)
        real(wp) :: node(panel_nodes), w(panel_nodes)
        integer :: i

        call gauss_legendre(node, w, error)
        if (allocated(error)) return
        if (last*farthest > most_waves/panel_nodes*longest_phase) then
            call raise(error, error_domain, "stresses in layers "//to_text(farthest)//" contact radii away are sums of "// &
                       to_text(panel_nodes*last*farthest/longest_phase)//" waves, "//to_text(most_waves)//" are allowed: take "// &
                       "points closer to the contact")
            return
        end if
        call panel_ends(farthest, min(first_panel/max(farthest, structure), last), last, ends)
        allocate (k(panel_nodes*(size(ends) - 1)), weight(panel_nodes*(size(ends) - 1)))
        do i = 1, size(ends) - 1
            k(panel_nodes*(i - 1) + 1:panel_nodes*i) = ends(i) + (ends(i + 1) - ends(i))*node
            weight(panel_nodes*(i - 1) + 1:panel_nodes*i) = (ends(i + 1) - ends(i))*w
        end do
    end subroutine wave_rule

    !> How many nodes to work on together in a body of so many layers: memory for all of them would grow with both.
    pure function part_of_waves(layers) result(number)
        integer, intent(in) :: layers
        integer :: number

        number = max(least_part, most_amplitudes/layers)
    end function part_of_waves

    pure subroutine panel_ends(farthest, first, last, ends)
        real(wp), intent(in) :: farthest, first, last
        real(wp), allocatable, intent(out) :: ends(:)
        real(wp) :: longest
        integer :: octaves, equal

        longest = longest_phase/farthest
        ! octaves until they are longer than the longest panel
        octaves = max(0, ceiling(log(min(longest, last)/first)/log(2.0_wp)))
        allocate (ends(0))
        ends = [0.0_wp, first*2.0_wp**[(equal, equal=0, octaves)]]
        if (ends(size(ends)) >= last) then
            ends = [pack(ends, ends < last), last]
            return
        end if
        associate (from => ends(size(ends)))
            equal = ceiling((last - from)/longest)
            ends = [ends, from + (last - from)*[(real(octaves, wp)/real(equal, wp), octaves=1, equal)]]
        end associate
    end subroutine panel_ends

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
