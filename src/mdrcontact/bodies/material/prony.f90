! SPDX-License-Identifier: GPL-3.0-or-later
!> Sums of exponentials in time: moduli that relax, f(t) = limit + sum weight_i exp(-rate_i t) + viscosity delta(t), and the
!> compliances that belong to them, J(t) = instant + sum weight_j (1 - exp(-rate_j t)) + fluidity t.
!>
!> Q(s) = s times the Laplace transform of f(t). Its zeros lie at s = -p, p > 0, one between neighbouring rates: they are the rates
!> of the compliance, whose transform is 1/Q: theory/time.md (1.1)-(1.4).
module mdrcontact_material_prony
    use mdrcontact_kinds, only: pi, wp
    use mdrcontact_numerics_one_thread, only: find_eigenvalues
    implicit none (type, external)
    private
    public :: prony_t, creep_t, creep_of, power_law_series, merged, risen

    !> A relaxing modulus.
    type :: prony_t
        !> f(infinity)
        real(wp) :: limit = 0.0_wp
        !> > 0, and rates > 0, ascending [1/time]
        real(wp), allocatable :: weight(:), rate(:)
        !> of a dashpot in parallel [modulus time]
        real(wp) :: viscosity = 0.0_wp
    contains
        procedure :: at => relaxation_at
        procedure :: instant => instant_modulus
        procedure :: transform
    end type prony_t

    !> A compliance that creeps.
    type :: creep_t
        real(wp) :: instant = 0.0_wp
        real(wp), allocatable :: weight(:), rate(:)
        !> slope at long times
        real(wp) :: fluidity = 0.0_wp
    contains
        procedure :: at => creep_at
    end type creep_t

contains

    !> f(t) without the dashpot, at t >= 0.
    pure function relaxation_at(self, t) result(value)
        class(prony_t), intent(in) :: self
        real(wp), intent(in) :: t
        real(wp) :: value

        value = self%limit + sum(self%weight*exp(-self%rate*t))
    end function relaxation_at

    !> f(0+) without the dashpot.
    pure function instant_modulus(self) result(value)
        class(prony_t), intent(in) :: self
        real(wp) :: value

        value = self%limit + sum(self%weight)
    end function instant_modulus

    !> Q(s), off the negative real axis.
    pure function transform(self, s) result(value)
        class(prony_t), intent(in) :: self
        complex(wp), intent(in) :: s
        complex(wp) :: value

        value = self%limit + sum(self%weight*(s/(s + self%rate))) + self%viscosity*s
    end function transform

    !> J(t) at t >= 0.
    pure function creep_at(self, t) result(value)
        class(creep_t), intent(in) :: self
        real(wp), intent(in) :: t
        real(wp) :: value

        ! 1 - exp(-x) = 2 exp(-x/2) sinh(x/2), and exp(-x) is nothing long before sinh ends
        value = self%instant + sum(self%weight*risen(self%rate*t)) + self%fluidity*t
    end function creep_at

    !> 1 - exp(-x).
    elemental function risen(x) result(value)
        real(wp), intent(in) :: x
        real(wp) :: value

        value = 1.0_wp
        if (x < 1.0_wp) then
            value = 2.0_wp*exp(-0.5_wp*x)*sinh(0.5_wp*x)
        else if (x < 700.0_wp) then
            value = 1.0_wp - exp(-x)
        end if
    end function risen

    !> The same sum with rates ascending and no two of them equal.
    pure function merged(series) result(sorted)
        type(prony_t), intent(in) :: series
        type(prony_t) :: sorted
        real(wp) :: weight(size(series%rate)), rate(size(series%rate)), next
        integer :: i, count

        count = 0
        next = 0.0_wp
        do
            if (.not. any(series%rate > next)) exit
            next = minval(series%rate, mask=series%rate > next)
            count = count + 1
            rate(count) = next
            weight(count) = sum(series%weight, mask=series%rate == next)
        end do
        sorted%limit = series%limit
        sorted%viscosity = series%viscosity
        allocate (sorted%rate(count), sorted%weight(count))
        do i = 1, count
            sorted%rate(i) = rate(i)
            sorted%weight(i) = weight(i)
        end do
    end function merged

    !> The compliance 1/Q(s) of a sum with ascending rates, as a sum of exponentials.
    pure function creep_of(series) result(creep)
        type(prony_t), intent(in) :: series
        type(creep_t) :: creep
        real(wp) :: slope, root, low, high
        integer :: i, n, first, count

        n = size(series%rate)
        first = merge(0, 1, series%limit > 0.0_wp)
        count = n - first + merge(1, 0, series%viscosity > 0.0_wp)
        if (n == 0) count = merge(1, 0, first == 0 .and. series%viscosity > 0.0_wp)
        allocate (creep%weight(count), creep%rate(count))
        if (.not. series%viscosity > 0.0_wp) creep%instant = 1.0_wp/series%instant()
        if (first == 1) creep%fluidity = 1.0_wp/(series%viscosity + sum(series%weight/series%rate))
        do i = 1, count
            low = 0.0_wp
            if (first + i - 1 > 0) low = series%rate(first + i - 1)
            if (first + i - 1 < n) then
                high = series%rate(first + i)
            else
                high = low + series%instant()/series%viscosity
            end if
            call zero_between(series, low, high, root, slope)
            creep%rate(i) = root
            creep%weight(i) = 1.0_wp/(root*slope)
        end do
    end function creep_of

    !> The zero p of Q(-p) between two rates, where it falls from infinity to minus infinity, and -dQ(-p)/dp there, by Newton's
    !> method for Q times its distances from both ends, within a bracket. p is counted from the nearer end: it may lie close to it.
    pure subroutine zero_between(series, low, high, root, slope)
        type(prony_t), intent(in) :: series
        real(wp), intent(in) :: low, high
        real(wp), intent(out) :: root, slope
        integer, parameter :: most = 200
        real(wp) :: distance(size(series%rate)), origin, x, next, value, lower, upper
        integer :: i

        x = 0.5_wp*(low + high)
        origin = low
        if (q_at(x - series%rate, x) > 0.0_wp) origin = high
        distance = origin - series%rate
        lower = low - origin
        upper = high - origin
        x = x - origin
        do i = 1, most
            value = q_at(distance + x, origin + x)
            slope = series%viscosity + sum(series%weight*(series%rate/(distance + x)**2))
            if (value > 0.0_wp) lower = x
            if (value < 0.0_wp) upper = x
            ! of (p - low)(high - p) Q(-p)
            next = x + value/(slope - value*(1.0_wp/(x - (low - origin)) - 1.0_wp/((high - origin) - x)))
            if (.not. (next > lower .and. next < upper)) next = 0.5_wp*(lower + upper)
            if (abs(next - x) <= 2.0_wp*epsilon(x)*abs(x) .or. next <= lower .or. next >= upper) exit
            x = next
        end do
        root = origin + x

    contains

        !> Q(-p).
        pure function q_at(distances, p) result(q)
            real(wp), intent(in) :: distances(:), p
            real(wp) :: q

            q = series%limit - series%viscosity*p + sum(series%weight*(p/distances))
        end function q_at

    end subroutine zero_between

    !> (t/time)^(-exponent) as a sum of exponentials, relative to its size at the longest time good to `tolerance` between the
    !> times given: the trapezoidal rule of (1/Gamma(a)) int exp(-rate t) rate^a d(ln rate). What is faster than both the
    !> shortest time and the tolerance show becomes a dashpot, what is slower a few terms.
    function power_law_series(time, exponent, shortest, longest, tolerance) result(series)
        !> unit of time > 0, and 0 < exponent < 1
        real(wp), intent(in) :: time, exponent
        !> > 0, ascending [time]
        real(wp), intent(in) :: shortest, longest
        real(wp), intent(in) :: tolerance
        type(prony_t) :: series
        ! the rule's error falls as exp(-pi^2/step), a little slower for exponents near 1
        real(wp), parameter :: steps_of_error = 1.15_wp, resolved = 40.0_wp
        real(wp) :: step, slowest, fastest, factor, slow_weight, slow_rate
        integer :: first, last, i

        step = pi**2/(steps_of_error*log(1.0_wp/tolerance))
        slowest = sqrt(tolerance)/longest
        fastest = max(resolved/shortest, tolerance**(-1.0_wp/(2.0_wp - exponent))/longest)
        first = floor(log(slowest)/step)
        last = ceiling(log(fastest)/step)
        factor = step/gamma(exponent)*time**exponent
        allocate (series%weight(last - first + 1), series%rate(last - first + 1))
        do i = first, last
            series%rate(i - first + 1) = exp(step*i)
        end do
        series%weight = factor*series%rate**exponent
        ! the geometric series of slower terms, and of their slopes
        slow_weight = series%weight(1)/(1.0_wp - exp(-step*exponent))
        slow_rate = series%weight(1)*series%rate(1)/(1.0_wp - exp(-step*(1.0_wp + exponent)))
        series%weight(1) = slow_weight
        series%rate(1) = slow_rate/slow_weight
        series%viscosity = series%weight(size(series%weight))/series%rate(size(series%rate)) &
                           /(exp(step*(1.0_wp - exponent)) - 1.0_wp)
        call gather_slow(series, longest)
    end function power_law_series

    !> Replaces the terms that hardly decay within a time by few others with equal first moments: Gauss's rule for their weights, by
    !> Lanczos's recursion (Golub, Welsch, Math. Comp. 23 (1969) 221). The error is that of exp(-x), 0 <= x <= 1.
    subroutine gather_slow(series, longest)
        type(prony_t), intent(inout) :: series
        real(wp), intent(in) :: longest
        integer, parameter :: few = 6
        real(wp) :: matrix(few, few), nodes(few)
        real(wp), allocatable :: vectors(:, :), next(:)
        integer :: slow, i, info

        slow = count(series%rate*longest <= 1.0_wp)
        if (slow <= few) return
        allocate (vectors(slow, few), next(slow))
        vectors(:, 1) = sqrt(series%weight(:slow)/sum(series%weight(:slow)))
        matrix = 0.0_wp
        do i = 1, few - 1
            next = series%rate(:slow)*vectors(:, i)
            matrix(i, i) = dot_product(vectors(:, i), next)
            ! twice is enough
            next = next - matmul(vectors(:, :i), matmul(next, vectors(:, :i)))
            next = next - matmul(vectors(:, :i), matmul(next, vectors(:, :i)))
            matrix(i, i + 1) = norm2(next)
            vectors(:, i + 1) = next/matrix(i, i + 1)
        end do
        matrix(few, few) = dot_product(vectors(:, few), series%rate(:slow)*vectors(:, few))
        call find_eigenvalues(.true., matrix, nodes, info)
        if (info /= 0 .or. .not. nodes(1) > 0.0_wp) return
        series%weight = [sum(series%weight(:slow))*matrix(1, :)**2, series%weight(slow + 1:)]
        series%rate = [nodes, series%rate(slow + 1:)]
    end subroutine gather_slow

end module mdrcontact_material_prony
