! SPDX-License-Identifier: GPL-3.0-or-later
!> A pressure known at points as a polynomial in the edge coordinate s = sqrt(1 - r^2/A^2), in which plastic pressures are smooth up
!> to the edge (theory/plastic.md (2.13)).
module mdrcontact_plastic_pressure
    use mdrcontact_error, only: check_memory, check_not_negative, check_same_size, count_text, error_invalid, error_t, raise, &
                                to_text
    use mdrcontact_kinds, only: wp
    use mdrcontact_lapack, only: dgels
    implicit none (type, external)
    private
    public :: fit_pressure

    !> Columns of room for LAPACK.
    integer, parameter :: blocks = 65
    !> Degrees, which powers of s bear without loss, and points that they take.
    integer, parameter :: largest_degree = 8, fewest_points = 4
    !> A lower degree is enough where the misfit, relative to the largest pressure, is below this; and what is refused.
    real(wp), parameter :: close_enough = 1.0e-11_wp, largest_misfit = 0.05_wp

contains

    !> Least squares; of the degrees the lowest one that goes through the points.
    subroutine fit_pressure(r, p, powers, misfit, error)
        !> ascending from >= 0 to A [length], and the pressure there >= 0 [modulus]
        real(wp), intent(in) :: r(:), p(:)
        !> coefficients of s^0, s^1, ... [modulus], at least 2
        real(wp), allocatable, intent(out) :: powers(:)
        !> largest difference at the points, relative to the largest pressure [1]
        real(wp), intent(out) :: misfit
        type(error_t), allocatable, intent(inout) :: error
        real(wp), allocatable :: s(:), t(:, :), work(:, :)
        integer :: degree, k, stat

        misfit = 0.0_wp
        call check_points(r, p, error)
        if (allocated(error)) return
        allocate (s(size(r)), t(size(r), 0:largest_degree), work(size(r), largest_degree + 2), stat=stat)
        call check_memory(error, stat)
        if (stat /= 0) return
        associate (a => r(size(r)))
            s(:) = sqrt((a - r)/a*(1.0_wp + r/a))
        end associate
        t(:, 0) = 1.0_wp
        t(:, 1) = 2.0_wp*s - 1.0_wp
        do k = 2, largest_degree
            t(:, k) = 2.0_wp*t(:, 1)*t(:, k - 1) - t(:, k - 2)
        end do
        ! at points that do not crowd at the ends, polynomials of higher degree oscillate
        do degree = 1, min(largest_degree, int(sqrt(2.0_wp*size(r))))
            call solve(t(:, :degree), p, work(:, :degree + 2), powers, misfit, error)
            if (allocated(error) .or. misfit <= close_enough) exit
        end do
        if (allocated(error)) return
        if (misfit > largest_misfit) then
            call raise(error, error_invalid, "p: a smooth pressure differs from it by "//to_text(misfit)//" of its largest "// &
                       "value. Give more points, and r from the axis to the edge of the contact")
            return
        end if
        powers = monomials(powers)
    end subroutine fit_pressure

    pure subroutine check_points(r, p, error)
        real(wp), intent(in) :: r(:), p(:)
        type(error_t), allocatable, intent(inout) :: error
        integer :: i

        call check_same_size(error, size(r), size(p))
        if (size(r) < fewest_points .and. .not. allocated(error)) then
            call raise(error, error_invalid, "r has "//count_text(size(r))//" entries: give at least "//count_text(fewest_points))
        end if
        do i = 1, size(r)
            call check_not_negative(error, "r", r(i), i)
            call check_not_negative(error, "p", p(i), i)
        end do
        do i = 2, size(r)
            if (allocated(error)) return
            if (.not. r(i) > r(i - 1)) then
                call raise(error, error_invalid, " = "//to_text(r(i))//": r must ascend, and the previous entry is "// &
                           to_text(r(i - 1)), "r", i)
            end if
        end do
        if (allocated(error)) return
        if (.not. maxval(p) > 0.0_wp) call raise(error, error_invalid, "p: it is 0 everywhere. Give the pressure at the "// &
                                                           "largest load")
    end subroutine check_points

    !> Chebyshev coefficients in 2 s - 1, and the misfit.
    subroutine solve(t, p, room, c, misfit, error)
        real(wp), intent(in) :: t(:, 0:), p(:)
        !> as t, with one column more
        real(wp), intent(out), contiguous :: room(:, :)
        real(wp), allocatable, intent(out) :: c(:)
        real(wp), intent(out) :: misfit
        type(error_t), allocatable, intent(inout) :: error
        real(wp) :: work(blocks*(largest_degree + 1))
        integer :: info, i, n

        n = size(t, 2)
        room(:, :n) = t
        room(:, n + 1) = p
        call dgels("N", size(p), n, 1, room(:, :n), size(p), room(:, n + 1:), size(p), work, size(work), info)
        if (info /= 0) then
            call raise(error, error_invalid, "r: the points lie too close together to determine the pressure")
            return
        end if
        c = room(:n, n + 1)
        misfit = 0.0_wp
        do i = 1, size(p)
            misfit = max(misfit, abs(dot_product(t(i, :), c) - p(i)))
        end do
        misfit = misfit/maxval(p)
    end subroutine solve

    !> Coefficients of s^k from those of T_k(2 s - 1).
    pure function monomials(c) result(powers)
        real(wp), intent(in) :: c(0:)
        real(wp) :: powers(0:ubound(c, 1))
        real(wp), dimension(0:ubound(c, 1)) :: here, before, next
        integer :: k, n

        n = ubound(c, 1)
        powers = 0.0_wp
        before = 0.0_wp
        before(0) = 1.0_wp
        here = 0.0_wp
        here(0:1) = [-1.0_wp, 2.0_wp]
        powers(0) = c(0)
        do k = 1, n
            powers = powers + c(k)*here
            next = -2.0_wp*here - before
            next(1:) = next(1:) + 4.0_wp*here(:n - 1)
            before = here
            here = next
        end do
    end function monomials

end module mdrcontact_plastic_pressure
