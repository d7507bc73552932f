! SPDX-License-Identifier: GPL-3.0-or-later
!> Zeros of a trigonometric polynomial of degree 2: where a circle meets an ellipse.
module mdrcontact_lateral_trigonometric
    use, intrinsic :: iso_c_binding, only: c_associated, c_double, c_int, c_ptr, c_size_t
    use mdrcontact_gsl, only: disable_gsl_abort
    use mdrcontact_kinds, only: pi, wp
    implicit none (type, external)
    private
    public :: trigonometric_roots

    !> Zeros with a larger imaginary part of tan(theta/2) are complex ones.
    real(wp), parameter :: real_enough = 1.0e-7_wp
    integer, parameter :: samples = 12

    interface
        function gsl_poly_complex_workspace_alloc(n) result(workspace) bind(C)
            import :: c_ptr, c_size_t
            implicit none (type, external)
            integer(c_size_t), value :: n
            type(c_ptr) :: workspace
        end function gsl_poly_complex_workspace_alloc

        subroutine gsl_poly_complex_workspace_free(workspace) bind(C)
            import :: c_ptr
            implicit none (type, external)
            type(c_ptr), value :: workspace
        end subroutine gsl_poly_complex_workspace_free

        function gsl_poly_complex_solve(a, n, workspace, z) result(status) bind(C)
            import :: c_double, c_int, c_ptr, c_size_t
            implicit none (type, external)
            integer(c_size_t), value :: n
            real(c_double), intent(in) :: a(n)
            type(c_ptr), value :: workspace
            real(c_double), intent(out) :: z(2*n - 2)
            integer(c_int) :: status
        end function gsl_poly_complex_solve
    end interface

contains

    !> Angles theta with  constant + c1 cos theta + s1 sin theta + c2 cos 2 theta + s2 sin 2 theta = 0.
    subroutine trigonometric_roots(constant, c1, s1, c2, s2, angles, count)
        real(wp), intent(in) :: constant, c1, s1, c2, s2
        real(wp), intent(out) :: angles(4)
        !> 0 to 4
        integer, intent(out) :: count
        real(wp) :: a(0:4), turned(4), shift, values(samples), roots(8), amplitude
        type(c_ptr) :: workspace
        integer(c_int) :: status
        integer :: i

        count = 0
        angles = 0.0_wp
        amplitude = hypot(c1, s1)
        if (hypot(c2, s2) <= 1.0e-14_wp*amplitude) then
            ! a circle: constant + amplitude cos(theta - theta0) = 0
            if (amplitude == 0.0_wp .or. abs(constant) >= amplitude) return
            angles(1:2) = atan2(s1, c1) + [-1.0_wp, 1.0_wp]*acos(-constant/amplitude)
            count = 2
            return
        end if
        ! theta = shift + 2 arctan(tau): far from the zeros at theta = shift + pi, so that tau stays finite
        values = [(abs(value_at(2.0_wp*pi*i/samples)), i=1, samples)]
        shift = 2.0_wp*pi*maxloc(values, 1)/samples - pi
        turned = [c1*cos(shift) + s1*sin(shift), s1*cos(shift) - c1*sin(shift), &
                  c2*cos(2.0_wp*shift) + s2*sin(2.0_wp*shift), s2*cos(2.0_wp*shift) - c2*sin(2.0_wp*shift)]
        a = [constant + turned(1) + turned(3), 2.0_wp*turned(2) + 4.0_wp*turned(4), 2.0_wp*constant - 6.0_wp*turned(3), &
             2.0_wp*turned(2) - 4.0_wp*turned(4), constant - turned(1) + turned(3)]
        if (a(4) == 0.0_wp) return
        call disable_gsl_abort()
        workspace = gsl_poly_complex_workspace_alloc(5_c_size_t)
        if (.not. c_associated(workspace)) return
        status = gsl_poly_complex_solve(a, 5_c_size_t, workspace, roots)
        call gsl_poly_complex_workspace_free(workspace)
        if (status /= 0_c_int) return
        do i = 1, 4
            if (abs(roots(2*i)) > real_enough*(1.0_wp + abs(roots(2*i - 1)))) cycle
            count = count + 1
            angles(count) = shift + 2.0_wp*atan(roots(2*i - 1))
        end do

    contains

        pure function value_at(theta) result(value)
            real(wp), intent(in) :: theta
            real(wp) :: value

            value = constant + c1*cos(theta) + s1*sin(theta) + c2*cos(2.0_wp*theta) + s2*sin(2.0_wp*theta)
        end function value_at

    end subroutine trigonometric_roots

end module mdrcontact_lateral_trigonometric
