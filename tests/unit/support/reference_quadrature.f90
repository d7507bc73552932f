! SPDX-License-Identifier: GPL-3.0-or-later
!> Integrals for the tests by the double exponential (tanh-sinh) rule: a way of its own beside the library's quadrature.
module reference_quadrature
    use mdrcontact_kinds, only: half_pi, wp
    implicit none (type, external)
    private
    public :: integrand_t, integral

    !> A function to be integrated; extensions hold its parameters.
    type, abstract :: integrand_t
    contains
        procedure(value_at), deferred :: at
    end type integrand_t

    abstract interface
        function value_at(self, x) result(y)
            import :: integrand_t, wp
            implicit none (type, external)
            class(integrand_t), intent(in) :: self
            real(wp), intent(in) :: x(:)
            real(wp) :: y(size(x))
        end function value_at
    end interface

    real(wp), parameter :: step = 1.0_wp/24.0_wp
    integer, parameter :: last = 87

contains

    !> The integral over [edges(1), edges(size(edges))]; f is analytic between the edges and may be singular, but integrable,
    !> at them.
    function integral(f, edges) result(total)
        class(integrand_t), intent(in) :: f
        real(wp), intent(in) :: edges(:)
        real(wp) :: total
        real(wp) :: x(-last:last, size(edges) - 1), weight(-last:last, size(edges) - 1)
        logical :: inside(-last:last, size(edges) - 1)
        integer :: i

        do i = 1, size(edges) - 1
            call panel(edges(i), edges(i + 1), x(:, i), weight(:, i), inside(:, i))
        end do
        ! one call: to begin an evaluation can be most of the work
        total = sum(pack(weight, inside)*f%at(pack(x, inside)))
    end function integral

    pure subroutine panel(lower, upper, x, weight, inside)
        real(wp), intent(in) :: lower, upper
        real(wp), intent(out) :: x(-last:last), weight(-last:last)
        logical, intent(out) :: inside(-last:last)
        real(wp) :: t(-last:last), distance(-last:last)
        integer :: i

        t = [(i*step, i=-last, last)]
        ! distance from the nearer end as a fraction of the length, without cancellation
        distance = 1.0_wp/(1.0_wp + exp(2.0_wp*half_pi*sinh(abs(t))))
        weight = half_pi*cosh(t)/cosh(half_pi*sinh(t))**2*0.5_wp*(upper - lower)*step
        x = merge(lower + distance*(upper - lower), upper - distance*(upper - lower), t < 0.0_wp)
        inside = x > lower .and. x < upper
    end subroutine panel

end module reference_quadrature
