! SPDX-License-Identifier: GPL-3.0-or-later
!> The growing part of a history as panels on which the elastic stiffness k(d) is a polynomial, with the hereditary integrals
!>     S(t) = int exp(-rate (t - u)) dF(d(u)),    D(t) = int exp(-rate (t - u)) d'(u) du
!> at the end of each, one for every rate: exact where the depth is linear in time, for any rate.
module mdrcontact_time_path
    use mdrcontact_error, only: check_memory, error_t
    use mdrcontact_gsl, only: gsl_sf_bessel_il_scaled_array, gsl_success
    use mdrcontact_time_curve, only: elastic_curve_t
    use mdrcontact_kinds, only: wp
    use mdrcontact_numerics_quadrature, only: gauss_legendre, legendre
    implicit none (type, external)
    private
    public :: path_t, new_path, mean_decay, mean_rise, mean_lag, partial_integrals

    !> Coefficients of a panel; up to which rate times length their moments are sums of powers, and of how many.
    integer, parameter :: most = 16, fewest = 4, powers = 22
    real(wp), parameter :: slow = 16.0_wp
    !> Number of powers if half of that product is at most 1, and 0.01; number of rates in a block of the sum.
    integer, parameter :: few_powers = 8, fewest_powers = 3, block_size = 8
    !> Digits that k has on each panel.
    real(wp), parameter :: digits_wanted = 13.0_wp
    !> Panels double in depth from first contact on, so many times at most.
    integer, parameter :: doublings = 48

    !> Gauss rules of all sizes n on [0, 1], (:n, n), and the Legendre polynomials at their nodes times weights times 2 l + 1,
    !> (:n, :n, n).
    type :: rules_t
        real(wp), allocatable :: nodes(:, :), weights(:, :), to_coefficients(:, :, :)
    end type rules_t

    !> Panels, from first contact to the largest depth.
    type :: path_t
        integer :: count = 0
        !> (0:count) time and depth at their ends
        real(wp), allocatable :: time(:), depth(:)
        !> Legendre coefficients of k(d) on each, (most, count), and how many; none where the depth is held
        real(wp), allocatable :: stiffness(:, :)
        integer, allocatable :: terms(:)
        !> S and D at their ends, (rates, 0:count); the last rate is 0
        real(wp), allocatable :: load(:, :), rise(:, :)
        !> which panel ends at each of the given points
        integer, allocatable :: place(:)
        real(wp), allocatable :: rates(:)
        type(rules_t) :: rules
    end type path_t

contains

    !> Panels through points of never decreasing time and depth, from first contact, the first point.
    subroutine new_path(self, curve, breaks, rates, time, depth, error)
        type(path_t), intent(out) :: self
        type(elastic_curve_t), intent(inout) :: curve
        !> depths at which k is not analytic, ascending [length]
        real(wp), intent(in) :: breaks(:)
        !> >= 0 [1/time]
        real(wp), intent(in) :: rates(:)
        !> (0:n); depth(0) = 0
        real(wp), intent(in) :: time(0:), depth(0:)
        type(error_t), allocatable, intent(out) :: error

        self%rates = rates
        call place_panels(self, breaks, time, depth, error)
        if (.not. allocated(error)) call make_rules(self%rules, maxval(self%terms), error)
        if (.not. allocated(error)) call sample(self, curve, error)
        if (.not. allocated(error)) call integrate(self, error)
    end subroutine new_path

    subroutine place_panels(self, breaks, time, depth, error)
        type(path_t), intent(inout) :: self
        real(wp), intent(in) :: breaks(:), time(0:), depth(0:)
        type(error_t), allocatable, intent(out) :: error
        real(wp), allocatable :: t(:), d(:)
        integer, allocatable :: terms(:)
        real(wp) :: next, low, ratio
        integer :: i, n, room, stat

        n = ubound(depth, 1)
        room = n + size(breaks) + 2*doublings + 64
        allocate (t(0:room), d(0:room), terms(room), self%place(0:n), stat=stat)
        call check_memory(error, stat)
        if (stat /= 0) return
        ! below the lowest depth k is constant between points, as near as it matters
        low = max(scale(maxval(depth), -doublings), tiny(low))
        t(0) = time(0)
        d(0) = 0.0_wp
        self%place(0) = 0
        self%count = 0
        do i = 1, n
            do
                next = depth(i)
                if (d(self%count) < low) then
                    next = min(next, low)
                else if (next > 2.0_wp*d(self%count)) then
                    next = 2.0_wp*d(self%count)
                    if (depth(i) < 1.5_wp*next) next = 0.5_wp*(depth(i) + d(self%count))
                end if
                if (any(breaks > d(self%count) .and. breaks < next)) next = minval(breaks, mask=breaks > d(self%count))
                self%count = self%count + 1
                if (next >= depth(i)) then
                    t(self%count) = time(i)
                    d(self%count) = depth(i)
                else
                    d(self%count) = next
                    t(self%count) = time(i - 1) + (time(i) - time(i - 1))*(next - depth(i - 1))/(depth(i) - depth(i - 1))
                end if
                if (d(self%count) <= d(self%count - 1)) then
                    terms(self%count) = 0
                else if (d(self%count) <= low) then
                    terms(self%count) = 1
                else
                    ! k has its singularity at first contact: how fast its Legendre series falls
                    ratio = (d(self%count) + d(self%count - 1))/(d(self%count) - d(self%count - 1))
                    ratio = log10(ratio + sqrt(ratio**2 - 1.0_wp))
                    terms(self%count) = min(max(ceiling(digits_wanted/ratio), fewest), most)
                end if
                if (d(self%count) >= depth(i)) exit
            end do
            self%place(i) = self%count
        end do
        allocate (self%time(0:self%count), self%depth(0:self%count), self%terms(self%count), stat=stat)
        call check_memory(error, stat)
        if (stat /= 0) return
        self%time(:) = t(:self%count)
        self%depth(:) = d(:self%count)
        self%terms(:) = terms(:self%count)
    end subroutine place_panels

    subroutine make_rules(rules, largest, error)
        type(rules_t), intent(inout) :: rules
        integer, intent(in) :: largest
        type(error_t), allocatable, intent(out) :: error
        integer :: l, n

        allocate (rules%nodes(largest, largest), rules%weights(largest, largest), rules%to_coefficients(largest, largest, largest))
        do n = 1, largest
            call gauss_legendre(rules%nodes(:n, n), rules%weights(:n, n), error)
            if (allocated(error)) return
            ! the coefficient of P_l is 2 l + 1 times the mean of P_l times the function
            rules%to_coefficients(:n, :n, n) = transpose(legendre(n, 2.0_wp*rules%nodes(:n, n) - 1.0_wp))
            do l = 1, n
                rules%to_coefficients(l, :n, n) = real(2*l - 1, wp)*rules%to_coefficients(l, :n, n)*rules%weights(:n, n)
            end do
        end do
    end subroutine make_rules

    !> k(d) at the nodes of all panels.
    subroutine sample(self, curve, error)
        type(path_t), intent(inout) :: self
        type(elastic_curve_t), intent(inout) :: curve
        type(error_t), allocatable, intent(out) :: error
        real(wp), allocatable :: depths(:), values(:)
        !> F at the ends of the panels of one term
        real(wp), dimension(1) :: force, before
        integer :: i, n, first, stat

        allocate (depths(sum(self%terms)), values(sum(self%terms)), self%stiffness(most, self%count), stat=stat)
        call check_memory(error, stat)
        if (stat /= 0) return
        first = 0
        do i = 1, self%count
            n = self%terms(i)
            if (n == 0) cycle
            depths(first + 1:first + n) = self%depth(i - 1) + (self%depth(i) - self%depth(i - 1))*self%rules%nodes(:n, n)
            first = first + n
        end do
        call curve%at_depths(depths, error, stiffness=values)
        if (allocated(error)) return
        self%stiffness(:, :) = 0.0_wp
        first = 0
        force = 0.0_wp
        do i = 1, self%count
            n = self%terms(i)
            if (n == 0) cycle
            self%stiffness(:n, i) = matmul(self%rules%to_coefficients(:n, :n, n), values(first + 1:first + n))
            if (n == 1) then
                before = force
                call curve%at_depths([self%depth(i)], error, force=force)
                if (allocated(error)) return
                self%stiffness(1, i) = (force(1) - before(1))/(self%depth(i) - self%depth(i - 1))
            end if
            first = first + n
        end do
    end subroutine sample

    subroutine integrate(self, error)
        type(path_t), intent(inout) :: self
        type(error_t), allocatable, intent(inout) :: error
        real(wp) :: moments(size(self%rates), most), decay(size(self%rates)), length, before, rise
        integer :: i, l, n, made, stat

        allocate (self%load(size(self%rates), 0:self%count), self%rise(size(self%rates), 0:self%count), stat=stat)
        call check_memory(error, stat)
        if (stat /= 0) return
        self%load(:, 0) = 0.0_wp
        self%rise(:, 0) = 0.0_wp
        before = -1.0_wp
        made = 0
        do i = 1, self%count
            length = self%time(i) - self%time(i - 1)
            rise = self%depth(i) - self%depth(i - 1)
            n = self%terms(i)
            ! lengths are known to the rounding of the times
            if (abs(length - before) > 4.0_wp*epsilon(length)*max(abs(self%time(i)), abs(self%time(i - 1))) .or. n > made) then
                before = length
                made = max(n, 1)
                call moments_of(self%rates*length, made, moments, decay)
            end if
            self%load(:, i) = decay*self%load(:, i - 1)
            self%rise(:, i) = decay*self%rise(:, i - 1) + rise*moments(:, 1)
            do l = 1, n
                self%load(:, i) = self%load(:, i) + (rise*self%stiffness(l, i))*moments(:, l)
            end do
        end do
    end subroutine integrate

    !> int_0^1 P_l(2 x - 1) exp(-z (1 - x)) dx = exp(-z/2) i_l(z/2), l < n, and exp(-z), for each z.
    subroutine moments_of(z, n, moments, decay)
        real(wp), intent(in) :: z(:)
        integer, intent(in) :: n
        real(wp), intent(inout) :: moments(:, :)
        real(wp), intent(out) :: decay(:)
        real(wp) :: root(size(z)), row(n)
        integer :: j, l, status

        root = exp(-0.5_wp*min(z, 1400.0_wp))
        decay = root**2
        call moments_of_slow(z, root, n, moments)
        do j = 1, size(z)
            if (z(j) <= slow) cycle
            if (z(j) > n**2) then
                ! upwards, which keeps digits as long as n^2 is small compared with z
                moments(j, 1) = (1.0_wp - decay(j))/z(j)
                if (n > 1) moments(j, 2) = (1.0_wp + decay(j))/z(j) - 2.0_wp*moments(j, 1)/z(j)
                do l = 1, n - 2
                    moments(j, l + 2) = moments(j, l) - real(4*l + 2, wp)/z(j)*moments(j, l + 1)
                end do
            else
                status = gsl_sf_bessel_il_scaled_array(n - 1, 0.5_wp*z(j), row)
                moments(j, :n) = merge(row, 0.0_wp, status == gsl_success)
            end if
        end do
    end subroutine moments_of

    !> The same for z at most `slow`, x = z/2: exp(-x) x^l/(2 l + 1)!! s_l with
    !> s_l = sum_k (x^2/2)^k/(k! (2 l + 3) ... (2 l + 2 k + 1)), which is summed for the two highest l, and
    !> s_(l-1) = s_l + x^2/((2 l + 1)(2 l + 3)) s_(l+1). Rates ascend: the first of a block need few powers.
    pure subroutine moments_of_slow(z, root, n, moments)
        real(wp), intent(in) :: z(:), root(:)
        integer, intent(in) :: n
        real(wp), intent(inout) :: moments(:, :)
        real(wp), dimension(block_size) :: square, factor
        integer :: first, last, width, k, l, needed

        do first = 1, size(z), block_size
            last = min(first + block_size - 1, size(z))
            width = last - first + 1
            square(:width) = min(0.5_wp*z(first:last), 0.5_wp*slow)**2
            needed = powers
            if (maxval(square(:width)) < 1.0_wp) needed = few_powers
            if (maxval(square(:width)) < 1.0e-4_wp) needed = fewest_powers
            do l = max(n - 2, 0), n - 1
                moments(first:last, l + 1) = 1.0_wp
                do k = needed, 1, -1
                    moments(first:last, l + 1) = 1.0_wp + moments(first:last, l + 1)*square(:width) &
                                                 *(1.0_wp/real(2*k*(2*l + 2*k + 1), wp))
                end do
            end do
            do l = n - 2, 1, -1
                moments(first:last, l) = moments(first:last, l + 1) + moments(first:last, l + 2)*square(:width) &
                                         *(1.0_wp/real((2*l + 1)*(2*l + 3), wp))
            end do
            factor(:width) = root(first:last)
            do l = 1, n
                moments(first:last, l) = factor(:width)*moments(first:last, l)
                factor(:width) = factor(:width)*min(0.5_wp*z(first:last), 0.5_wp*slow)*(1.0_wp/real(2*l + 1, wp))
            end do
        end do
    end subroutine moments_of_slow

    !> (1 - exp(-x))/x.
    elemental function mean_decay(x) result(value)
        real(wp), intent(in) :: x
        real(wp) :: value

        if (x < 1.0e-2_wp) then
            value = 1.0_wp - x*(0.5_wp - x*(1.0_wp/6.0_wp - x*(1.0_wp/24.0_wp - x*(1.0_wp/120.0_wp - x/720.0_wp))))
        else if (x < 700.0_wp) then
            value = (1.0_wp - exp(-x))/x
        else
            value = 1.0_wp/x
        end if
    end function mean_decay

    !> 1 - (1 - exp(-x))/x, accurate for small x: what a load that rises linearly in time leaves in a spring's memory.
    elemental function mean_rise(x) result(value)
        real(wp), intent(in) :: x
        real(wp) :: value

        if (x < 1.0e-2_wp) then
            value = x*(0.5_wp - x*(1.0_wp/6.0_wp - x*(1.0_wp/24.0_wp - x*(1.0_wp/120.0_wp - x/720.0_wp))))
        else
            value = 1.0_wp - mean_decay(x)
        end if
    end function mean_rise

    !> (1 - exp(-x))/x - exp(-x), accurate for small x: of a load that falls linearly to 0.
    elemental function mean_lag(x) result(value)
        real(wp), intent(in) :: x
        real(wp) :: value

        if (x < 1.0e-2_wp) then
            value = x*(0.5_wp - x*(1.0_wp/3.0_wp - x*(1.0_wp/8.0_wp - x*(1.0_wp/30.0_wp - x/144.0_wp))))
        else
            value = mean_decay(x) - exp(-x)
        end if
    end function mean_lag

    !> S and D at a fraction of a panel, for every rate.
    subroutine partial_integrals(self, panel, fraction, load, passed)
        type(path_t), intent(in) :: self
        integer, intent(in) :: panel
        !> 0 to 1
        real(wp), intent(in) :: fraction
        real(wp), intent(out) :: load(:), passed(:)
        real(wp) :: k(most), p(most, most), moments(size(self%rates), most), decay(size(self%rates)), length, rise
        integer :: l, n

        n = self%terms(panel)
        length = fraction*(self%time(panel) - self%time(panel - 1))
        rise = fraction*(self%depth(panel) - self%depth(panel - 1))
        p(:n, :n) = legendre(n, 2.0_wp*(fraction*self%rules%nodes(:n, n)) - 1.0_wp)
        k(:n) = matmul(p(:n, :n), self%stiffness(:n, panel))
        call moments_of(self%rates*length, n, moments, decay)
        passed = decay*self%rise(:, panel - 1) + rise*moments(:, 1)
        load = decay*self%load(:, panel - 1)
        do l = 1, n
            load = load + rise*sum(self%rules%to_coefficients(l, :n, n)*k(:n))*moments(:, l)
        end do
    end subroutine partial_integrals

end module mdrcontact_time_path
