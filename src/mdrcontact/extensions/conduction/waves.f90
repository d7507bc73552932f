! SPDX-License-Identifier: GPL-3.0-or-later
!> Rules for integrals over wavenumbers.
module mdrcontact_conduction_waves
    use mdrcontact_error, only: error_domain, error_t, raise
    use mdrcontact_kinds, only: pi, wp
    use mdrcontact_numerics_quadrature, only: gauss_legendre
    implicit none (type, external)
    private
    public :: wave_rule

    !> Nodes of a panel of one octave, or of 2 pi of the phase.
    integer, parameter :: per_panel = 16
    !> Panels at most.
    integer, parameter :: most_panels = 30000

contains

    !> Nodes and weights for integrals from 0 to `last` of what varies over octaves from `first` on and oscillates as cos(length k).
    subroutine wave_rule(first, last, length, k, weight, error)
        !> 0 < first < last [1/length]
        real(wp), intent(in) :: first, last
        !> > 0 [length]
        real(wp), intent(in) :: length
        real(wp), allocatable, intent(out) :: k(:), weight(:)
        type(error_t), allocatable, intent(inout) :: error
        real(wp) :: node(per_panel), w(per_panel), left, right
        real(wp), allocatable :: edge(:)
        integer :: i, n

        if (allocated(error)) return
        call gauss_legendre(node, w, error)
        if (allocated(error)) return
        allocate (edge(0:most_panels))
        n = 1
        edge(:1) = [0.0_wp, min(first, last)]
        do while (edge(n) < last)
            if (n == most_panels) then
                call raise(error, error_domain, "a point or a spot so many thicknesses of the first layer away, or wide, "// &
                           "takes more waves than are offered")
                return
            end if
            edge(n + 1) = min(2.0_wp*edge(n), edge(n) + 2.0_wp*pi/length)
            n = n + 1
        end do
        edge(n) = last
        allocate (k(n*per_panel), weight(n*per_panel))
        do i = 1, n
            left = edge(i - 1)
            right = edge(i)
            k((i - 1)*per_panel + 1:i*per_panel) = left + (right - left)*node
            weight((i - 1)*per_panel + 1:i*per_panel) = (right - left)*w
        end do
    end subroutine wave_rule

end module mdrcontact_conduction_waves
