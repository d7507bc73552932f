! SPDX-License-Identifier: GPL-3.0-or-later
!> Running-in of a flat punch (theory/wear.md (4.4)-(4.6)): the deviation of its pressure from the final one finally falls as
!> exp(-s/l) at last.
!>
!> With the radius fixed the equation of wear on the line is linear, (L q)' = E0* d' - k E0*/(2 a) |D| q, L = 1 + K, x in units of
!> a. In phi_j = sin((2 j + 1) t), x = cos t, |D| is diagonal, int phi_i |D| phi_j dx = (2 j + 1) (pi/2) delta_ij, and
!> int phi_j dx = (pi/2) delta_j0: without j = 0 the force stays.
module mdrcontact_wear_running_in
    use mdrcontact_error, only: error_no_convergence, error_t, raise
    use mdrcontact_kinds, only: half_pi, pi, wp
    use mdrcontact_medium_solver, only: check_springs, solver_t
    use mdrcontact_numerics_one_thread, only: add_product, find_eigenvalues
    use mdrcontact_numerics_quadrature, only: legendre
    implicit none (type, external)
    private
    public :: slowest_decay

    !> Number of functions phi_j, and largest number of Legendre polynomials for the interaction of a film's springs.
    integer, parameter :: functions = 48, most_waves = 96

contains

    !> l of the part that stays longest.
    subroutine slowest_decay(solver, radius, coefficient, by_depth, length, error)
        class(solver_t), intent(in) :: solver
        !> of the punch [length]
        real(wp), intent(in) :: radius
        !> k > 0 [1/modulus]
        real(wp), intent(in) :: coefficient
        !> the depth is constant, else the force
        logical, intent(in) :: by_depth
        !> [length]
        real(wp), intent(out) :: length
        type(error_t), allocatable, intent(inout) :: error
        real(wp) :: matrix(0:functions - 1, 0:functions - 1), rates(functions), modulus
        integer :: first, i, j, info

        length = 0.0_wp
        call spring_products(solver, radius, matrix, modulus, error)
        if (allocated(error)) return
        do j = 0, functions - 1
            do i = 0, functions - 1
                matrix(i, j) = matrix(i, j)/(half_pi*sqrt(real((2*i + 1)*(2*j + 1), wp)))
            end do
        end do
        first = merge(0, 1, by_depth)
        call find_eigenvalues(.false., matrix(first:, first:), rates(:functions - first), info)
        if (info /= 0) then
            call raise(error, error_no_convergence, "the decay of wear under a flat punch was not found")
        else
            length = 2.0_wp*rates(functions - first)*radius/(coefficient*modulus)
        end if
    end subroutine slowest_decay

    !> int_-1^1 phi_i L phi_j dx.
    subroutine spring_products(solver, radius, matrix, modulus, error)
        class(solver_t), intent(in) :: solver
        real(wp), intent(in) :: radius
        real(wp), intent(out) :: matrix(0:, 0:)
        !> E0* [modulus]
        real(wp), intent(out) :: modulus
        type(error_t), allocatable, intent(inout) :: error
        real(wp), allocatable :: interaction(:, :), coupled(:, :), waves(:, :)
        integer :: i, j, m

        do j = 0, functions - 1
            do i = 0, functions - 1
                matrix(i, j) = 1.0_wp/real(1 - 4*(i - j)**2, wp) - 1.0_wp/real(1 - 4*(i + j + 1)**2, wp)
            end do
        end do
        modulus = 0.0_wp
        call check_springs(solver, "the wear of a sliding indenter is", error)
        if (allocated(error)) return
        modulus = solver%springs%modulus
        call solver%springs%interaction(radius, most_waves, interaction, error)
        if (allocated(error)) return
        m = size(interaction, 1)
        if (m == 0) return
        allocate (waves(m, functions), coupled(m, functions))
        call set_waves(waves)
        call add_product("N", "N", m, functions, m, 1.0_wp, interaction, m, waves, m, 0.0_wp, coupled, m)
        call add_product("T", "N", functions, functions, m, 1.0_wp, waves, m, coupled, m, 1.0_wp, matrix, functions)
    end subroutine spring_products

    !> int_-1^1 sqrt((4 m + 1)/2) P_2m phi_j dx, by the trapezoid rule in t, which is exact for them.
    pure subroutine set_waves(waves)
        !> (m, j)
        real(wp), intent(out) :: waves(:, :)
        real(wp), allocatable :: p(:, :)
        real(wp) :: t(size(waves, 1) + size(waves, 2) + 1)
        integer :: i, j, m, points

        points = size(t)
        t = [(pi*(real(i, wp) - 0.5_wp)/real(2*points, wp), i=1, points)]
        p = legendre(2*size(waves, 1) - 1, cos(t))
        do j = 1, size(waves, 2)
            do m = 1, size(waves, 1)
                waves(m, j) = sqrt(0.5_wp*real(4*m - 3, wp))*pi/real(points, wp) &
                              *sum(p(:, 2*m - 1)*sin(real(2*j - 1, wp)*t)*sin(t))
            end do
        end do
    end subroutine set_waves

end module mdrcontact_wear_running_in
