! SPDX-License-Identifier: GPL-3.0-or-later
!> A contact that sticks all over and is twisted about its axis, exactly (theory 10): 4 G0 phi x = q + K q with odd q, the kernel of
!> shear across the plane of waves, and the moment M = 4 int_0^a x q dx; 16 G a^3 phi/3 on a homogeneous body.
module mdrcontact_layered_torsion
    use mdrcontact_error, only: error_no_convergence, error_t, raise, to_text
    use mdrcontact_kinds, only: wp
    use mdrcontact_layered_kernel, only: kernel_t
    use mdrcontact_layered_legendre, only: moments_t, new_interaction
    use mdrcontact_layered_solve, only: factorize, first_unknowns, next_unknowns, solve_lower
    implicit none (type, external)
    private
    public :: torsional_ratio

    integer, parameter :: most_unknowns = 1500

contains

    !> M/phi over (16/3) G0 a^3.
    subroutine torsional_ratio(kernel, tolerance, a, ratio, error)
        type(kernel_t), intent(in) :: kernel
        !> relative tolerance, contact radius [length]
        real(wp), intent(in) :: tolerance, a
        real(wp), intent(out) :: ratio
        type(error_t), allocatable, intent(inout) :: error
        real(wp) :: before
        integer :: n

        ratio = 1.0_wp
        if (kernel%vanishes) return
        n = first_unknowns(kernel, tolerance, a/kernel%unit, is_kinked=.false., to_edge=.false.)
        call solve_with(n, before)
        do while (.not. allocated(error))
            n = next_unknowns(n, 2.0_wp)
            call solve_with(n, ratio)
            if (allocated(error)) return
            if (abs(ratio - before) <= 0.1_wp*tolerance*ratio) return
            before = ratio
            if (n > most_unknowns) exit
        end do
        if (.not. allocated(error)) call raise(error, error_no_convergence, "the torsional stiffness did not reach the "// &
                                               "relative tolerance "//to_text(tolerance)//" at contact radius "//to_text(a))

    contains

        !> With n unknowns: the first coefficient of the solution of (1 + H) c = (1, 0, ...).
        subroutine solve_with(n, first)
            integer, intent(in) :: n
            real(wp), intent(out) :: first
            type(moments_t) :: moments
            real(wp), allocatable :: h(:, :)
            real(wp) :: x(n, 1)
            integer :: i
            logical :: solved

            first = 1.0_wp
            call new_interaction(moments, h, kernel, a, n, n, 4*n + 4, 4*n, error, odd=.true.)
            if (allocated(error)) return
            do i = 1, n
                h(i, i) = h(i, i) + moments%diagonal
            end do
            call factorize(n, n, h, solved)
            if (.not. solved) then
                call raise(error, error_no_convergence, "the springs of this body nearly cancel at contact radius "//to_text(a))
                return
            end if
            x = 0.0_wp
            x(1, 1) = 1.0_wp
            call solve_lower(n, n, 1, h, x)
            first = sum(x**2)
        end subroutine solve_with

    end subroutine torsional_ratio

end module mdrcontact_layered_torsion
