! SPDX-License-Identifier: GPL-3.0-or-later
!> The profile that a plastic contact has left: its imprint under the indenter, as an elastic contact sees both.
!>
!> The line load at the largest load is a polynomial in the edge coordinate s = sqrt(1 - u^2), u = x/A. It has two terms for the
!> pressure pu + ph sqrt(1 - r^2/A^2) (theory/plastic.md (2.1), (2.13)). Then g(x) = [q(0) - q(x)]/E0* is a closed form, and f(r)
!> one by complete elliptic integrals. Layers below the surface add a smooth function of u^2, a polynomial with those of f and the
!> moment.
module mdrcontact_plastic_profile
    use, intrinsic :: iso_fortran_env, only: int64
    use mdrcontact_error, only: check_memory, error_t
    use mdrcontact_kinds, only: half_pi, pi, wp
    use mdrcontact_nonfinite, only: infinity
    use mdrcontact_numerics_quadrature, only: gauss_legendre
    use mdrcontact_object, only: real_bytes
    use mdrcontact_profile, only: profile_t
    implicit none (type, external)
    private
    public :: imprint_profile_t, new_imprint_profile

    !> Below this u the series of (arcsin u - u s)/2 keeps the digits that the difference loses, with so many terms.
    real(wp), parameter :: near_axis = 0.3_wp
    integer, parameter :: terms_near_axis = 15
    !> Steps of the arithmetic-geometric mean, which doubles its digits in each, at most.
    integer, parameter :: most_steps = 12
    !> Places at which polynomials are summed together.
    integer, parameter :: together = 8
    integer, parameter :: of_mdr = 1, of_height = 2, of_moment = 3
    !> Coefficients of layers that are smaller than this part of the largest are left out.
    real(wp), parameter :: negligible = 1.0e-16_wp

    !> It ends at the contact radius A of the largest load, where its slope is infinite if the pressure there is not 0.
    type, extends(profile_t) :: imprint_profile_t
        private
        !> q/E0* = sum_k loads(k) s^k at the largest load [length]
        real(wp), allocatable :: loads(:)
        !> sum of loads(k) over k > j, j = 0, 1, ... [length]
        real(wp), allocatable :: tails(:)
        !> what layers add to g is u^2 times a sum of T_k(2 u^2 - 1), to f the same of r/A, to the moment u^3 times one: their
        !> coefficients (k, of_mdr | of_height | of_moment) [length]
        real(wp), allocatable :: layers(:, :)
    contains
        procedure :: height
        procedure :: slope
        procedure :: mdr
        procedure :: mdr_at
        procedure :: mdr_slope
        procedure :: mdr_moment
        procedure :: radius_from_mdr
        procedure :: bytes
    end type imprint_profile_t

contains

    !> The imprint of a line load that falls from the axis to 0 at A.
    subroutine new_imprint_profile(self, radius, loads, error, layers)
        type(imprint_profile_t), intent(out) :: self
        !> A > 0 [length]
        real(wp), intent(in) :: radius
        !> of q/E0* = sum_k loads(k) s^k, at least 2 [length]
        real(wp), intent(in) :: loads(:)
        type(error_t), allocatable, intent(inout) :: error
        !> what layers add to g, over u^2, at the nodes cos(pi (i - 1/2)/n) of 2 u^2 - 1 [length]
        real(wp), intent(in), optional :: layers(:)
        integer :: j, stat

        allocate (self%loads(size(loads)), self%tails(0:size(loads) - 1), stat=stat)
        call check_memory(error, stat)
        if (allocated(error)) return
        self%loads = loads
        do j = 0, size(loads) - 1
            self%tails(j) = sum(loads(j + 1:))
        end do
        self%largest_radius = radius
        self%sharp_radius = radius
        if (any(abs(loads(1::2)) > 0.0_wp)) self%singular_radius = radius
        if (present(layers)) call set_layers(self, layers, error)
        self%is_made = .not. allocated(error)
    end subroutine new_imprint_profile

    !> The polynomials of layers from values of the first. Height and moment are integrals of g along the radius, of its degree.
    subroutine set_layers(self, values, error)
        type(imprint_profile_t), intent(inout) :: self
        !> see new_imprint_profile
        real(wp), intent(in) :: values(:)
        type(error_t), allocatable, intent(inout) :: error
        real(wp) :: coefficients(size(values)), square(size(values)), t(size(values) + 2), w(size(values) + 2), sines(size(t))
        integer :: i, n, stat

        n = size(values)
        coefficients = series_of(values)
        n = findloc(abs(coefficients) > negligible*maxval(abs(coefficients)), .true., dim=1, back=.true.)
        if (n == 0) return
        allocate (self%layers(n, 3), stat=stat)
        call check_memory(error, stat)
        call gauss_legendre(t, w, error)
        if (allocated(error)) return
        self%layers(:, of_mdr) = coefficients(:n)
        sines = [(sin(half_pi*(i - 0.5_wp)/size(t))**2, i=1, size(t))]
        square(:n) = [(0.5_wp*(1.0_wp + cos(pi*(i - 0.5_wp)/n)), i=1, n)]
        self%layers(:, of_height) = series_of([(sum(sines*sum_of(self%layers(:, of_mdr), square(i)*sines))/size(t), i=1, n)])
        self%layers(:, of_moment) = self%layers(:, of_mdr) &
            - series_of([(sum(w*t**2*sum_of(self%layers(:, of_mdr), square(i)*t**2)), i=1, n)])
    end subroutine set_layers

    !> Coefficients of T_k from values at the nodes cos(pi (i - 1/2)/n).
    pure function series_of(values) result(c)
        real(wp), intent(in) :: values(:)
        real(wp) :: c(size(values))
        integer :: i, k, n

        n = size(values)
        do k = 1, n
            c(k) = merge(1.0_wp, 2.0_wp, k == 1)/n*sum(values*[(cos(pi*(k - 1)*(i - 0.5_wp)/n), i=1, n)])
        end do
    end function series_of

    !> Sum of c(k) T_(k-1)(2 square - 1), by Clenshaw, for a few places at a time, which a processor works on together.
    pure function sum_of(c, square) result(y)
        real(wp), intent(in) :: c(:), square(:)
        real(wp) :: y(size(square))
        real(wp), dimension(together) :: z, next, before, here
        integer :: first, last, k

        do first = 1, size(square), together
            last = min(first + together - 1, size(square))
            z = 0.0_wp
            z(:last - first + 1) = 4.0_wp*square(first:last) - 2.0_wp
            next = 0.0_wp
            before = 0.0_wp
            do k = size(c), 2, -1
                here = c(k) + z*next - before
                before = next
                next = here
            end do
            here = c(1) + 0.5_wp*z*next - before
            y(first:last) = here(:last - first + 1)
        end do
    end function sum_of

    !> The same at one place, and its slope over `square`.
    pure subroutine sum_and_slope(c, square, y, slope)
        real(wp), intent(in) :: c(:), square
        real(wp), intent(out) :: y, slope
        real(wp) :: z, before, other, slope_before
        integer :: k

        z = 2.0_wp*(2.0_wp*square - 1.0_wp)
        y = 0.0_wp
        before = 0.0_wp
        slope = 0.0_wp
        slope_before = 0.0_wp
        do k = size(c), 2, -1
            other = slope
            slope = 2.0_wp*y + z*slope - slope_before
            slope_before = other
            other = y
            y = c(k) + z*y - before
            before = other
        end do
        slope = 2.0_wp*(y + 0.5_wp*z*slope - slope_before)
        y = c(1) + 0.5_wp*z*y - before
    end subroutine sum_and_slope

    pure recursive function bytes(self)
        class(imprint_profile_t), intent(in) :: self
        integer(int64) :: bytes

        bytes = 2*real_bytes*size(self%loads)
        if (allocated(self%layers)) bytes = bytes + real_bytes*size(self%layers)
    end function bytes

    !> (2/pi) sum_k loads(k) (pi/2 - int Delta^k dtheta): theory/plastic.md (2.14).
    elemental function height(self, x) result(y)
        class(imprint_profile_t), intent(in) :: self
        real(wp), intent(in) :: x
        real(wp) :: y
        real(wp) :: rest(-1:size(self%loads)), modulus

        modulus = min(x/self%largest_radius, 1.0_wp)
        call find_rests(modulus, rest)
        y = 2.0_wp/pi*sum(self%loads*rest(1:))
        if (allocated(self%layers)) y = y + added(self, of_height, modulus)*modulus**2
    end function height

    elemental function slope(self, x) result(y)
        class(imprint_profile_t), intent(in) :: self
        real(wp), intent(in) :: x
        real(wp) :: y
        real(wp) :: rest(-1:size(self%loads)), modulus, more, more_slope
        integer :: k

        y = 0.0_wp
        modulus = min(x/self%largest_radius, 1.0_wp)
        if (modulus <= 0.0_wp) return
        call find_rests(modulus, rest)
        do k = 1, size(self%loads)
            if (abs(self%loads(k)) > 0.0_wp) y = y + k*self%loads(k)*(rest(k) - rest(k - 2))
        end do
        y = 2.0_wp/pi*y/modulus
        if (allocated(self%layers)) then
            call sum_and_slope(self%layers(:, of_height), modulus**2, more, more_slope)
            y = y + 2.0_wp*modulus*(more + modulus**2*more_slope)
        end if
        y = y/self%largest_radius
    end function slope

    !> R(k) = int_0^(pi/2) (1 - Delta^k) dtheta, Delta^2 = 1 - m^2 sin^2 theta, for k = -1, 0, 1, ... without cancellation near the
    !> axis: -1 and 1 by the arithmetic-geometric mean, then
    !> k R(k) = (k - 1)(2 - m^2) R(k - 2) - (k - 2)(1 - m^2) R(k - 4) + m^2 pi/2.
    pure subroutine find_rests(modulus, rest)
        !> m, from 0 to 1
        real(wp), intent(in) :: modulus
        real(wp), intent(out) :: rest(-1:)
        real(wp) :: a, b, c, weight, first, second, far, whole, square, other
        integer :: i, k

        square = modulus**2
        other = (1.0_wp - modulus)*(1.0_wp + modulus)
        a = 1.0_wp
        b = sqrt(other)
        c = modulus
        ! sums of c_n, n > 0, and of 2^(n - 1) c_n^2, n >= 0
        first = 0.0_wp
        second = 0.5_wp*square
        weight = 1.0_wp
        if (b > 0.0_wp) then
            do i = 1, most_steps
                ! (a - b)/2 without cancellation
                c = c**2/(2.0_wp*(a + b))
                first = first + c
                second = second + weight*c**2
                weight = 2.0_wp*weight
                if (c <= epsilon(c)*first) exit
                b = sqrt(a*b)
                a = a - c
            end do
            whole = 0.5_wp*pi/(1.0_wp - first)
            rest(-1) = -whole*first
            rest(1) = whole*(second - first)
        else
            rest(-1) = -infinity
            rest(1) = 0.5_wp*pi - 1.0_wp
        end if
        rest(0) = 0.0_wp
        do k = 2, ubound(rest, 1)
            far = 0.0_wp
            if (other > 0.0_wp) far = rest(max(k - 4, -1))*other
            rest(k) = ((k - 1)*(2.0_wp - square)*rest(k - 2) - (k - 2)*far + 0.5_wp*pi*square)/k
        end do
    end subroutine find_rests

    !> theory/plastic.md (2.13): 1 - s^k = (1 - s)(1 + s + ...), and 1 - s = u^2/(1 + s).
    elemental function mdr(self, x) result(y)
        class(imprint_profile_t), intent(in) :: self
        real(wp), intent(in) :: x
        real(wp) :: y
        real(wp) :: s, u
        integer :: j

        call edge_coordinate(self, x, u, s)
        y = 0.0_wp
        do j = size(self%loads) - 1, 0, -1
            y = y*s + self%tails(j)
        end do
        y = y*u**2/(1.0_wp + s)
        if (allocated(self%layers)) y = y + added(self, of_mdr, u)*u**2
    end function mdr

    !> The same at many places, side by side.
    pure function mdr_at(self, x) result(y)
        class(imprint_profile_t), intent(in) :: self
        real(wp), intent(in) :: x(:)
        real(wp) :: y(size(x))
        real(wp), dimension(size(x)) :: s, square
        integer :: j

        associate (a => self%largest_radius)
            square = (x/a)**2
            s = sqrt(max((a - x)/a*(1.0_wp + x/a), 0.0_wp))
        end associate
        y = 0.0_wp
        do j = size(self%loads) - 1, 0, -1
            y = y*s + self%tails(j)
        end do
        y = y/(1.0_wp + s)
        if (allocated(self%layers)) y = y + sum_of(self%layers(:, of_mdr), square)
        y = y*square
    end function mdr_at

    !> The sum of a column of `layers` at u.
    pure function added(self, column, u) result(y)
        class(imprint_profile_t), intent(in) :: self
        integer, intent(in) :: column
        real(wp), intent(in) :: u
        real(wp) :: y
        real(wp) :: z, next, before
        integer :: k

        z = 4.0_wp*u**2 - 2.0_wp
        next = 0.0_wp
        before = 0.0_wp
        do k = size(self%layers, 1), 2, -1
            y = self%layers(k, column) + z*next - before
            before = next
            next = y
        end do
        y = self%layers(1, column) + 0.5_wp*z*next - before
    end function added

    elemental function mdr_slope(self, x) result(y)
        class(imprint_profile_t), intent(in) :: self
        real(wp), intent(in) :: x
        real(wp) :: y
        real(wp) :: s, u, more, more_slope
        integer :: k

        call edge_coordinate(self, x, u, s)
        y = 0.0_wp
        do k = size(self%loads), 2, -1
            y = y*s + k*self%loads(k)
        end do
        if (self%loads(1) > 0.0_wp) then
            if (s > 0.0_wp) then
                y = y + self%loads(1)/s
            else
                y = infinity
            end if
        end if
        y = y*u
        if (allocated(self%layers)) then
            call sum_and_slope(self%layers(:, of_mdr), u**2, more, more_slope)
            y = y + 2.0_wp*u*(more + u**2*more_slope)
        end if
        y = y/self%largest_radius
    end function mdr_slope

    !> A sum_k k loads(k) M(k - 1), M(j) = int sin^2 cos^j, (j + 2) M(j) = u^3 s^(j - 1) + (j - 1) M(j - 2).
    elemental function mdr_moment(self, x) result(y)
        class(imprint_profile_t), intent(in) :: self
        real(wp), intent(in) :: x
        real(wp) :: y
        real(wp) :: s, u, odd, even, power
        integer :: k

        call edge_coordinate(self, x, u, s)
        odd = first_moment(u, s)
        even = u**3/3.0_wp
        y = self%loads(1)*odd + 2.0_wp*self%loads(2)*even
        power = s
        do k = 3, size(self%loads)
            if (modulo(k, 2) == 1) then
                odd = (u**3*power + (k - 2)*odd)/(k + 1)
                y = y + k*self%loads(k)*odd
            else
                even = (u**3*power + (k - 2)*even)/(k + 1)
                y = y + k*self%loads(k)*even
            end if
            power = power*s
        end do
        if (allocated(self%layers)) y = y + added(self, of_moment, u)*u**3
        y = y*self%largest_radius
    end function mdr_moment

    !> (arcsin u - u s)/2.
    elemental function first_moment(u, s) result(y)
        real(wp), intent(in) :: u, s
        real(wp) :: y
        real(wp) :: term
        integer :: n

        if (u > near_axis) then
            y = 0.5_wp*(atan2(u, s) - u*s)
            return
        end if
        y = 0.0_wp
        term = u**3
        do n = 0, terms_near_axis
            y = y + term/(2*n + 3)
            term = term*u**2*(2*n + 1)/(2*n + 2)
        end do
    end function first_moment

    elemental subroutine edge_coordinate(self, x, u, s)
        class(imprint_profile_t), intent(in) :: self
        !> [length]
        real(wp), intent(in) :: x
        !> u = x/A and s = sqrt(1 - u^2)
        real(wp), intent(out) :: u, s

        associate (a => self%largest_radius)
            u = x/a
            s = sqrt(max((a - x)/a*(1.0_wp + u), 0.0_wp))
        end associate
    end subroutine edge_coordinate

    !> Of two terms in closed form: theory/plastic.md (2.9).
    pure function radius_from_mdr(self, depth) result(radius)
        class(imprint_profile_t), intent(in) :: self
        real(wp), intent(in) :: depth
        real(wp) :: radius
        real(wp) :: linear, root, t

        radius = -1.0_wp
        if (size(self%loads) > 2 .or. allocated(self%layers)) return
        linear = self%loads(1) + 2.0_wp*self%loads(2)
        root = linear**2 - 4.0_wp*self%loads(2)*depth
        if (root < 0.0_wp) return
        t = min(2.0_wp*depth/(linear + sqrt(root)), 1.0_wp)
        radius = self%largest_radius*sqrt(t*(2.0_wp - t))
    end function radius_from_mdr

end module mdrcontact_plastic_profile
