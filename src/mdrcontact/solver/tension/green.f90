! SPDX-License-Identifier: GPL-3.0-or-later
!> Response to a line load of 1 of a half-space under a surface with tension or a plate (theory/surfaces.md (6.8)):
!>     Phi(y) = int_0^inf kappa_0(k) cos ky dk,   kappa_0 = 1/(1/s_0 + l k + b k^3) = sum R/(k - k_r),
!>     l = 2 tau/E0*, b = 2 B/E0*.
!>
!> s_0 = 1 + c/(1 + l_m k) where the surface is stiff in its plane (mdrcontact_body_membrane), else 1. Phi = sum R g(-k_r y), g of
!> sine and cosine integrals. Next to y = 0 it is P(y) + Q(y) ln y with analytic P and Q; elsewhere it is tabulated. One pole
!> without a plate, a real one and a pair with it; one more where the surface is stiff in its plane.
module mdrcontact_tension_green
    use mdrcontact_nonfinite, only: is_finite
    use mdrcontact_error, only: error_no_convergence, error_t, raise
    use mdrcontact_kinds, only: pi, wp
    use mdrcontact_lapack, only: dgeev
    use mdrcontact_numerics_chebyshev, only: node
    use mdrcontact_tension_auxiliary, only: auxiliary, regular_parts
    implicit none (type, external)
    private
    public :: green_t, new_green
    public :: of_load, of_load_slope, of_couple, of_couple_slope, of_couples, of_couples_slope

    !> Columns: Phi, y Phi'; with a plate also Phi', Phi' + y Phi'', Phi'', 2 Phi'' + y Phi'''.
    integer, parameter :: of_load = 1, of_load_slope = 2, of_couple = 3, of_couple_slope = 4, of_couples = 5, of_couples_slope = 6
    !> Terms of a panel's series: it is analytic down to y = 0, at least one panel's length away.
    integer, parameter :: terms = 22
    !> Panels are no longer than this while waves of a plate are left, exp(-faded) [1/|k_r|].
    real(wp), parameter :: longest = 4.0_wp, faded = 40.0_wp
    !> Poles of a plate that is stiff in its plane, and steps that make them exact.
    integer, parameter :: most_poles = 4, newton_steps = 4
    !> Points whose series are summed side by side.
    integer, parameter :: block = 8
    !> Up to here P and Q are taken [1/|k_r|].
    real(wp), parameter :: near_end = 1.0_wp

    !> Made by new_green.
    type :: green_t
        !> 2, or 6 with a plate
        integer :: columns = 2
        !> l [length] and b [length^3]
        real(wp) :: tension_length = 0.0_wp, bending_volume = 0.0_wp
        !> c and l_m [length]
        real(wp) :: excess = 0.0_wp, stretching_length = 0.0_wp
        !> the largest |k_r| without l_m [1/length]
        real(wp) :: rate = 0.0_wp
        !> y up to which `split` holds, and beyond which there is no table [length]
        real(wp) :: near = 0.0_wp, last = 0.0_wp
        !> -k_r [1/length] and R, twice that of a pole that represents a pair [1/length]
        complex(wp), allocatable, private :: rho(:), residue(:)
        !> ascending ends of the panels [length], and their series: (column, term, panel)
        real(wp), allocatable, private :: edges(:), series(:, :, :)
        !> P and Q of all columns up to `near`: (column, term)
        real(wp), allocatable, private :: regular(:, :), logarithmic(:, :)
    contains
        procedure :: at
        procedure :: split
        procedure :: spectrum
    end type green_t

contains

    !> For y up to `last` from the table, beyond it from the functions themselves.
    subroutine new_green(self, tension_length, bending_volume, last, error, excess, stretching_length)
        type(green_t), intent(out) :: self
        !> l and b; l > 0 where b = 0, and no pole on the positive axis
        real(wp), intent(in) :: tension_length, bending_volume, last
        type(error_t), allocatable, intent(inout) :: error
        !> c and l_m of a surface that is stiff in its plane; default 0
        real(wp), intent(in), optional :: excess, stretching_length

        if (allocated(error)) return
        self%tension_length = tension_length
        self%bending_volume = bending_volume
        if (bending_volume > 0.0_wp) then
            self%columns = 6
            call find_poles(self)
        else
            self%rho = [cmplx(1.0_wp/tension_length, 0.0_wp, wp)]
            self%residue = self%rho
        end if
        self%rate = maxval(abs(self%rho))
        if (present(excess)) then
            self%excess = excess
            self%stretching_length = stretching_length
            if (excess > 0.0_wp) call find_all_poles(self, error)
            if (allocated(error)) return
        end if
        self%near = near_end/maxval(abs(self%rho))
        self%last = max(last, 2.0_wp*self%near)
        call tabulate(self)
    end subroutine new_green

    !> The real pole by Newton's steps from the side from which they converge, and the pair that is left.
    pure subroutine find_poles(self)
        type(green_t), intent(inout) :: self
        real(wp) :: x, step
        integer :: i

        associate (l => self%tension_length, b => self%bending_volume)
            ! b x^3 + l x = 1 at k = -x; the slope grows with x, and all x beyond the root have b x^3 + l x > 1
            x = 2.0_wp*max(b**(-1.0_wp/3.0_wp), sqrt(max(-l, 0.0_wp)/b))
            do i = 1, 200
                step = (b*x**3 + l*x - 1.0_wp)/(3.0_wp*b*x**2 + l)
                x = x - step
                if (abs(step) <= epsilon(x)*x) exit
            end do
            ! k^2 - x k + (x^2 + l/b) of the pair
            self%rho = [cmplx(x, 0.0_wp, wp), -0.5_wp*cmplx(x, sqrt(max(3.0_wp*x**2 + 4.0_wp*l/b, 0.0_wp)), wp)]
            self%residue = 1.0_wp/(l + 3.0_wp*b*self%rho**2)
            self%residue(2) = 2.0_wp*self%residue(2)
        end associate
    end subroutine find_poles

    !> All poles of kappa_0 with s_0: the eigenvalues of its companion matrix, refined by Newton's steps.
    subroutine find_all_poles(self, error)
        type(green_t), intent(inout) :: self
        type(error_t), allocatable, intent(inout) :: error
        real(wp) :: powers(0:most_poles), companion(most_poles, most_poles), work(16*most_poles), left(1, 1), right(1, 1), unit
        real(wp), dimension(most_poles) :: real_parts, imaginary_parts
        complex(wp) :: k, value, slope
        integer :: i, j, n, info

        associate (l => self%tension_length, b => self%bending_volume, c => self%excess, m => self%stretching_length)
            ! (1 + m k) + (l k + b k^3) (1 + c + m k) in powers of k
            powers = [1.0_wp, m + l*(1.0_wp + c), l*m, b*(1.0_wp + c), b*m]
            n = merge(4, 2, b > 0.0_wp)
            unit = powers(n)**(-1.0_wp/n)
            companion = 0.0_wp
            do i = 1, n
                if (i < n) companion(i + 1, i) = 1.0_wp
                companion(i, n) = -powers(i - 1)*unit**(i - 1)
            end do
            ! LAPACK balances for ever what is not finite
            info = merge(0, 1, all(is_finite(companion)))
            if (info == 0) call dgeev("N", "N", n, companion, most_poles, real_parts, imaginary_parts, left, 1, right, 1, work, &
                                      size(work), info)
            if (info /= 0) then
                call raise(error, error_no_convergence, "the poles of a surface that is stiff in its plane were not found")
                return
            end if
            self%rho = pack(-unit*cmplx(real_parts(:n), imaginary_parts(:n), wp), imaginary_parts(:n) >= 0.0_wp)
            self%residue = self%rho
            do i = 1, size(self%rho)
                k = -self%rho(i)
                do j = 0, newton_steps
                    call polynomial(powers(:n), k, value, slope)
                    if (j < newton_steps) k = k - value/slope
                end do
                self%rho(i) = -k
                self%residue(i) = merge(2.0_wp, 1.0_wp, abs(aimag(k)) > 0.0_wp)*(1.0_wp + c + m*k)/slope
            end do
        end associate
    end subroutine find_all_poles

    !> A polynomial and its slope.
    pure subroutine polynomial(powers, x, value, slope)
        real(wp), intent(in) :: powers(0:)
        complex(wp), intent(in) :: x
        complex(wp), intent(out) :: value, slope
        integer :: i

        value = powers(ubound(powers, 1))
        slope = 0.0_wp
        do i = ubound(powers, 1) - 1, 0, -1
            slope = slope*x + value
            value = value*x + powers(i)
        end do
    end subroutine polynomial

    pure subroutine tabulate(self)
        type(green_t), intent(inout) :: self
        real(wp), dimension(self%columns, terms) :: values, others
        real(wp) :: waves, edge, middle, half
        integer :: i, panel

        waves = 0.0_wp
        if (self%bending_volume > 0.0_wp) waves = faded/max(maxval(abs(aimag(self%rho))), tiny(1.0_wp))
        self%edges = [self%near]
        do while (self%edges(size(self%edges)) < self%last)
            edge = self%edges(size(self%edges))
            self%edges = [self%edges, edge + merge(min(edge, longest/self%rate), edge, edge < waves)]
        end do
        allocate (self%series(self%columns, terms, size(self%edges) - 1))
        do panel = 1, size(self%edges) - 1
            middle = 0.5_wp*(self%edges(panel) + self%edges(panel + 1))
            half = 0.5_wp*(self%edges(panel + 1) - self%edges(panel))
            do i = 1, terms
                call compute(self, middle + half*node(i, terms), values(:, i))
            end do
            self%series(:, :, panel) = series_through(values)
        end do
        do i = 1, terms
            call compute_parts(self, 0.5_wp*self%near*(1.0_wp + node(i, terms)), values(:, i), others(:, i))
        end do
        self%regular = series_through(values)
        self%logarithmic = series_through(others)
    end subroutine tabulate

    !> Chebyshev series from values at its nodes.
    pure function series_through(values) result(series)
        !> (column, node)
        real(wp), intent(in) :: values(:, :)
        real(wp) :: series(size(values, 1), terms)
        integer :: i, j

        do j = 1, terms
            series(:, j) = 2.0_wp/terms*matmul(values, [(cos(pi*(j - 1)*(i - 0.5_wp)/terms), i=1, terms)])
        end do
        series(:, 1) = 0.5_wp*series(:, 1)
    end function series_through

    !> The columns at ascending y.
    pure subroutine at(self, y, values)
        class(green_t), intent(in) :: self
        !> > 0 [length]
        real(wp), intent(in) :: y(:)
        !> (size(y), columns), the first of them
        real(wp), intent(out) :: values(:, :)
        real(wp), allocatable :: logarithmic(:, :)
        real(wp) :: computed(self%columns)
        integer :: first, last, panel

        first = count(y < self%near) + 1
        if (first > 1) then
            allocate (logarithmic(first - 1, size(values, 2)))
            call self%split(y(:first - 1), values(:first - 1, :), logarithmic)
            values(:first - 1, :) = values(:first - 1, :) + logarithmic*spread(log(y(:first - 1)), 2, size(values, 2))
        end if
        panel = 1
        do while (first <= size(y))
            if (y(first) >= self%edges(size(self%edges))) then
                call compute(self, y(first), computed)
                values(first, :) = computed(:size(values, 2))
                first = first + 1
                cycle
            end if
            do while (y(first) >= self%edges(panel + 1))
                panel = panel + 1
            end do
            last = first
            do while (last < size(y))
                if (y(last + 1) >= self%edges(panel + 1)) exit
                last = last + 1
            end do
            call sum_series(self%series(:, :, panel), self%edges(panel), self%edges(panel + 1), y(first:last), &
                            values(first:last, :))
            first = last + 1
        end do
    end subroutine at

    !> Clenshaw's sums of all columns of a panel, points side by side.
    pure subroutine sum_series(series, low, high, y, values)
        real(wp), intent(in) :: series(:, :), low, high, y(:)
        real(wp), intent(out) :: values(:, :)
        real(wp), dimension(block) :: x, before, here, next
        integer :: first, count, column, j

        do first = 1, size(y), block
            count = min(block, size(y) - first + 1)
            x = 0.0_wp
            x(:count) = 2.0_wp*(2.0_wp*y(first:first + count - 1) - (low + high))/(high - low)
            do column = 1, size(values, 2)
                before = 0.0_wp
                here = 0.0_wp
                do j = terms, 2, -1
                    next = series(column, j) + x*here - before
                    before = here
                    here = next
                end do
                next = series(column, 1) + 0.5_wp*x*here - before
                values(first:first + count - 1, column) = next(:count)
            end do
        end do
    end subroutine sum_series

    !> P and Q of each column, P + Q ln y, y <= near.
    pure subroutine split(self, y, regular, logarithmic)
        class(green_t), intent(in) :: self
        real(wp), intent(in) :: y(:)
        !> (size(y), columns), the first of them
        real(wp), intent(out) :: regular(:, :), logarithmic(:, :)

        call sum_series(self%regular, 0.0_wp, self%near, y, regular)
        call sum_series(self%logarithmic, 0.0_wp, self%near, y, logarithmic)
    end subroutine split

    !> The columns from sine and cosine integrals.
    pure subroutine compute(self, y, values)
        class(green_t), intent(in) :: self
        real(wp), intent(in) :: y
        real(wp), intent(out) :: values(:)
        complex(wp) :: f(size(self%rho)), g(size(self%rho))

        call auxiliary(self%rho*y, f, g)
        call combine(self, y, f, g, 1.0_wp, values)
    end subroutine compute

    !> P and Q of each column from their series.
    pure subroutine compute_parts(self, y, regular, logarithmic)
        class(green_t), intent(in) :: self
        real(wp), intent(in) :: y
        !> (columns)
        real(wp), intent(out) :: regular(:), logarithmic(:)
        complex(wp), dimension(size(self%rho)) :: f, g

        call regular_parts(self%rho*y, log(self%rho), f, g)
        call combine(self, y, f, g, 1.0_wp, regular)
        call combine(self, y, sin(self%rho*y), -cos(self%rho*y), 0.0_wp, logarithmic)
    end subroutine compute_parts

    !> g' = f - 1/w and f' = -g; of a plate sum R = sum R k_r = 0 and sum R k_r^2 = 1/b.
    pure subroutine combine(self, y, f, g, one, values)
        class(green_t), intent(in) :: self
        real(wp), intent(in) :: y
        complex(wp), intent(in) :: f(:), g(:)
        !> 1, or 0 for the factor of ln y
        real(wp), intent(in) :: one
        real(wp), intent(out) :: values(:)
        real(wp) :: second, third

        associate (rho => self%rho, r => self%residue)
            values(of_load) = sum(real(r*g, wp))
            if (self%columns == 2) then
                values(of_load_slope) = sum(real(r*(rho*y*f - one), wp))
                return
            end if
            values(of_couple) = sum(real(r*rho*f, wp))
            values(of_load_slope) = y*values(of_couple)
            second = -sum(real(r*rho**2*g, wp))
            third = one/self%bending_volume - y*sum(real(r*rho**3*f, wp))
            values(of_couple_slope) = values(of_couple) + y*second
            values(of_couples) = second
            values(of_couples_slope) = 2.0_wp*second + third
        end associate
    end subroutine combine

    !> kappa_0(k).
    elemental function spectrum(self, k) result(value)
        class(green_t), intent(in) :: self
        !> [1/length]
        real(wp), intent(in) :: k
        real(wp) :: value

        value = 1.0_wp/(1.0_wp - self%excess/(1.0_wp + self%excess + self%stretching_length*k) &
                        + k*(self%tension_length + k**2*self%bending_volume))
    end function spectrum

end module mdrcontact_tension_green
