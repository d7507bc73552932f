! SPDX-License-Identifier: GPL-3.0-or-later
!> Bessel functions J0, J1 and J2 of many arguments at a time: the power series up to 1, Taylor series about equally spaced places
!> up to 25, and Hankel's asymptotic series beyond, each to 1e-16.
module mdrcontact_numerics_bessel
    use mdrcontact_gsl, only: gsl_sf_bessel_j0, gsl_sf_bessel_j1
    use mdrcontact_kinds, only: pi, wp
    implicit none (type, external)
    private
    public :: bessel_t, new_bessel

    !> Places of Taylor series in a unit of x, where they begin and end, and their degree: (1/8)^12/12! is 3e-20.
    integer, parameter :: in_unit = 4, first_place = 1*in_unit, last_place = 25*in_unit, degree = 11
    real(wp), parameter :: begin = 1.0_wp, far = 25.0_wp
    !> Terms of the power series, and of each of the four asymptotic ones: the next one is 6e-17 at x = 25.
    integer, parameter :: terms = 9, far_terms = 8
    !> Arguments that are worked on together.
    integer, parameter :: block = 64

    !> The coefficients.
    type :: bessel_t
        private
        !> (-1/4)^i/(i! (i + n)!) of J_n: (i, n)
        real(wp) :: power(0:terms, 0:2) = 0.0_wp
        !> J0 and J1 about x = place/in_unit: (power, place); 18 kB, not for the stack
        real(wp), allocatable :: even(:, :), odd(:, :)
        !> P and Q of J0, and those of J1, in powers of 1/x^2
        real(wp), dimension(0:far_terms) :: p0 = 0.0_wp, q0 = 0.0_wp, p1 = 0.0_wp, q1 = 0.0_wp
    contains
        procedure :: at
    end type bessel_t

contains

    !> Create the coefficients.
    pure subroutine new_bessel(self)
        type(bessel_t), intent(out) :: self
        real(wp) :: x, c(0:degree)
        integer :: place, n

        allocate (self%even(0:degree, first_place:last_place), self%odd(0:degree - 1, first_place:last_place))
        do place = first_place, last_place
            x = real(place, wp)/real(in_unit, wp)
            c(0) = gsl_sf_bessel_j0(x)
            c(1) = -gsl_sf_bessel_j1(x)
            ! x y'' + y' + x y = 0
            c(2) = -0.5_wp*(c(1)/x + c(0))
            do n = 1, degree - 2
                c(n + 2) = -(real((n + 1)**2, wp)*c(n + 1) + x*c(n) + c(n - 1))/(x*real((n + 2)*(n + 1), wp))
            end do
            self%even(:, place) = c
            self%odd(:, place) = -c(1:)*[(real(n, wp), n=1, degree)]
        end do
        do n = 0, 2
            self%power(0, n) = 1.0_wp/real(max(n, 1), wp)
            do place = 1, terms
                self%power(place, n) = -0.25_wp*self%power(place - 1, n)/real(place*(place + n), wp)
            end do
        end do
        call asymptotic(0.0_wp, self%p0, self%q0)
        call asymptotic(4.0_wp, self%p1, self%q1)
    end subroutine new_bessel

    !> P and Q of Hankel's series, sqrt(2/(pi x)) (P cos - Q sin)(x - (n/2 + 1/4) pi), in powers of 1/x^2; Q over x.
    pure subroutine asymptotic(four_square, p, q)
        !> 4 n^2
        real(wp), intent(in) :: four_square
        real(wp), intent(out) :: p(0:far_terms), q(0:far_terms)
        real(wp) :: term
        integer :: i

        term = 1.0_wp
        do i = 0, far_terms
            p(i) = term
            term = term*(four_square - real(4*i + 1, wp)**2)/real(8*(2*i + 1), wp)
            q(i) = term
            term = -term*(four_square - real(4*i + 3, wp)**2)/real(8*(2*i + 2), wp)
        end do
    end subroutine asymptotic

    !> J0(k r), J1(k r)/r and J2(k r)/r^2 with their limits at r = 0.
    pure subroutine at(self, k, r, j0, j1, j2)
        class(bessel_t), intent(in) :: self
        !> wavenumbers > 0, ascending, and r >= 0
        real(wp), intent(in) :: k(:), r
        !> same size as k
        real(wp), intent(out) :: j0(:), j1(:)
        real(wp), intent(out), optional :: j2(:)
        integer :: near, middle

        near = count(k*r <= begin)
        middle = count(k*r < far)
        call from_power(self%power(:, 0), k(:near), r, 0, j0(:near))
        call from_power(self%power(:, 1), k(:near), r, 1, j1(:near))
        if (present(j2)) call from_power(self%power(:, 2), k(:near), r, 2, j2(:near))
        call from_taylor(self, k(near + 1:middle), r, j0(near + 1:middle), j1(near + 1:middle))
        call from_far(self, k(middle + 1:), r, j0(middle + 1:), j1(middle + 1:))
        if (.not. r > 0.0_wp) return
        j1(near + 1:) = j1(near + 1:)/r
        if (present(j2)) j2(near + 1:) = (2.0_wp*j1(near + 1:)/k(near + 1:) - j0(near + 1:))/r**2
    end subroutine at

    !> J_n(k r)/r^n for k r <= 1: (k/2)^n times a polynomial in (k r)^2.
    pure subroutine from_power(coefficients, k, r, order, values)
        real(wp), intent(in) :: coefficients(0:terms), k(:), r
        integer, intent(in) :: order
        real(wp), intent(out) :: values(:)
        real(wp) :: square, value
        integer :: i, n

        do n = 1, size(k)
            square = (k(n)*r)**2
            value = coefficients(terms)
            do i = terms - 1, 0, -1
                value = coefficients(i) + square*value
            end do
            values(n) = value
        end do
        if (order >= 1) values = 0.5_wp*k*values
        if (order >= 2) values = 0.5_wp*k*values
    end subroutine from_power

    !> J0 and J1 for 1 < k r < 25.
    pure subroutine from_taylor(self, k, r, j0, j1)
        type(bessel_t), intent(in) :: self
        real(wp), intent(in) :: k(:), r
        real(wp), intent(out) :: j0(:), j1(:)
        real(wp) :: x, even, odd
        integer :: i, n, place

        do n = 1, size(k)
            x = k(n)*r
            ! the nearest one, without the call of nint
            place = int(x*real(in_unit, wp) + 0.5_wp)
            x = x - real(place, wp)/real(in_unit, wp)
            even = self%even(degree, place)
            odd = self%odd(degree - 1, place)
            do i = degree - 1, 1, -1
                even = self%even(i, place) + x*even
                odd = self%odd(i - 1, place) + x*odd
            end do
            j0(n) = self%even(0, place) + x*even
            j1(n) = odd
        end do
    end subroutine from_taylor

    !> J0 and J1 for k r >= 25.
    pure subroutine from_far(self, k, r, j0, j1)
        type(bessel_t), intent(in) :: self
        real(wp), intent(in) :: k(:), r
        real(wp), intent(out) :: j0(:), j1(:)
        real(wp), dimension(block) :: over, square, plus, minus, amplitude, p0, q0, p1, q1
        integer :: i, n, first, last

        ! cos and sin of x, several at a time
        j0 = cos(k*r)
        j1 = sin(k*r)
        do first = 1, size(k), block
            last = min(first + block - 1, size(k))
            n = last - first + 1
            over(:n) = 1.0_wp/(k(first:last)*r)
            square(:n) = over(:n)**2
            i = most_terms(k(first)*r)
            p0(:n) = self%p0(i)
            q0(:n) = self%q0(i)
            p1(:n) = self%p1(i)
            q1(:n) = self%q1(i)
            do i = i - 1, 0, -1
                p0(:n) = self%p0(i) + square(:n)*p0(:n)
                q0(:n) = self%q0(i) + square(:n)*q0(:n)
                p1(:n) = self%p1(i) + square(:n)*p1(:n)
                q1(:n) = self%q1(i) + square(:n)*q1(:n)
            end do
            amplitude(:n) = sqrt(over(:n)/pi)
            plus(:n) = j1(first:last) + j0(first:last)
            minus(:n) = j1(first:last) - j0(first:last)
            j0(first:last) = amplitude(:n)*(p0(:n)*plus(:n) - over(:n)*q0(:n)*minus(:n))
            j1(first:last) = amplitude(:n)*(p1(:n)*minus(:n) + over(:n)*q1(:n)*plus(:n))
        end do
    end subroutine from_far

    !> Powers of 1/x^2 that asymptotic series need beyond x: the next one is less than 2e-18.
    pure function most_terms(x) result(number)
        real(wp), intent(in) :: x
        integer :: number

        number = far_terms
        if (x >= 100.0_wp) number = 4
        if (x >= 1000.0_wp) number = 2
    end function most_terms

end module mdrcontact_numerics_bessel
