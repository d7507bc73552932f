! SPDX-License-Identifier: GPL-3.0-or-later
!> The transforms between an indenter's f(r) and its one-dimensional g(x), equations (3) and (4), of a sampled function:
!>
!>     g(x) = x int_0^x f'(r)/sqrt(x^2 - r^2) dr,    f(r) = (2/pi) int_0^r g(x)/sqrt(r^2 - x^2) dx.
!>
!> The cost of a value does not grow with the number of panels, so that tables of many points are transformed in linear time: in v =
!> x^2, u = r^2 the kernel 1/sqrt(v - u) is a power series in (u - c)/(v - c) away from u = c, a few of whose moments represent all
!> panels of a group that lies far enough below (a tree of groups, each of two smaller ones). Between two edges the far groups
!> together are one short polynomial; near panels are integrated one by one in sqrt(x - r), where the integrand is smooth.
module mdrcontact_profile_transform
    use mdrcontact_error, only: check_memory, error_t
    use mdrcontact_kinds, only: half_pi, wp
    use mdrcontact_numerics_chebyshev, only: chebyshev_sum, cosine_transform
    use mdrcontact_numerics_quadrature, only: gauss_legendre
    use mdrcontact_numerics_sampled_function, only: sampled_function_t
    use mdrcontact_numerics_scalar_function, only: scalar_function_t
    use mdrcontact_numerics_search, only: interval_of
    implicit none (type, external)
    private
    public :: transform_t, new_transform

    !> Moments of a group: a group whose half-width is at most `separation` of its distance needs them to 4^-28 = 1e-17.
    integer, parameter :: terms = 28
    real(wp), parameter :: separation = 0.25_wp
    !> Chebyshev nodes of the far part between two edges, and how many half-widths of that block the far groups are away: 1e-14.
    integer, parameter :: far_nodes = 16
    real(wp), parameter :: far_distance = 3.0_wp
    integer, parameter :: many_nodes = 20, few_nodes = 8
    !> Terms of the series below the first edge.
    integer, parameter :: series_terms = 28

    !> One of the two transforms.
    type, extends(scalar_function_t) :: transform_t
        private
        type(sampled_function_t), pointer :: f => null()
        !> from f to g, or back
        logical :: forward = .true.
        !> the sampled function follows this power below its first edge; 0: there is nothing
        real(wp) :: exponent = 0.0_wp
        !> its value at its first edge
        real(wp) :: lowest_value = 0.0_wp
        real(wp), allocatable :: edges(:)
        !> level l has groups first(l) to first(l + 1) - 1, each of two of the level below; those of level 1 are the panels
        integer, allocatable :: first(:)
        !> of the groups: in u = r^2
        real(wp), allocatable :: centre(:), half_width(:), moments(:, :)
        real(wp) :: many(many_nodes) = 0.0_wp, many_weights(many_nodes) = 0.0_wp
        real(wp) :: few(few_nodes) = 0.0_wp, few_weights(few_nodes) = 0.0_wp
        !> the panel between whose edges the last x lay, and the far part there as Chebyshev coefficients in x^2
        integer :: block = 0, near_count = 0, far_count = 0
        integer, allocatable :: near(:), far(:)
        real(wp) :: far_part(far_nodes) = 0.0_wp, cosines(far_nodes, far_nodes) = 0.0_wp
    contains
        procedure :: value
    end type transform_t

contains

    !> The transform of a sampled f to g, or of a sampled g to f.
    subroutine new_transform(self, f, forward, exponent, error)
        type(transform_t), intent(out) :: self
        type(sampled_function_t), target, intent(in) :: f
        logical, intent(in) :: forward
        !> the power that f follows below its first edge; 0: it is 0 there
        real(wp), intent(in) :: exponent
        type(error_t), allocatable, intent(inout) :: error
        integer :: panels, count, levels, stat

        self%f => f
        self%forward = forward
        self%exponent = exponent
        self%lowest_value = f%value(f%lower())
        call cosine_transform(self%cosines)
        call gauss_legendre(self%many, self%many_weights, error)
        call gauss_legendre(self%few, self%few_weights, error)
        if (allocated(error)) return
        panels = size(f%from_root)
        allocate (self%first(34))
        self%first(1) = 1
        count = panels
        do levels = 1, 33
            self%first(levels + 1) = self%first(levels) + count
            if (count == 1) exit
            count = (count + 1)/2
        end do
        self%first = self%first(:levels + 1)
        count = self%first(levels + 1) - 1
        allocate (self%centre(count), self%half_width(count), self%edges(panels + 1), self%moments(0:terms - 1, count), &
                  self%near(panels), self%far(panels), stat=stat)
        call check_memory(error, stat)
        if (allocated(error)) return
        do count = 1, panels + 1
            self%edges(count) = f%edges(count)
        end do
        call find_moments(self, panels, levels)
    end subroutine new_transform

    !> Moments int phi ((u - c)/h)^k dr of the panels by quadrature, of the groups from those of their halves.
    subroutine find_moments(self, panels, levels)
        type(transform_t), intent(inout) :: self
        integer, intent(in) :: panels, levels
        real(wp) :: binomial(0:terms - 1, 0:terms - 1), r(many_nodes), t(many_nodes), phi(many_nodes)
        integer :: i, k, level, child, last

        do i = 1, panels
            call place(self, i, self%edges(i)**2, self%edges(i + 1)**2)
            r = self%edges(i) + (self%edges(i + 1) - self%edges(i))*self%many
            call density(self, i, r, phi)
            phi = phi*self%many_weights*(self%edges(i + 1) - self%edges(i))
            t = (r**2 - self%centre(i))/self%half_width(i)
            do k = 0, terms - 1
                self%moments(k, i) = sum(phi)
                phi = phi*t
            end do
        end do
        binomial = 0.0_wp
        binomial(:, 0) = 1.0_wp
        do k = 1, terms - 1
            binomial(k, 1:) = binomial(k - 1, 1:) + binomial(k - 1, :terms - 2)
        end do
        do level = 2, levels
            do i = self%first(level), self%first(level + 1) - 1
                child = self%first(level - 1) + 2*(i - self%first(level))
                last = min(child + 1, self%first(level) - 1)
                call place(self, i, self%centre(child) - self%half_width(child), self%centre(last) + self%half_width(last))
                self%moments(:, i) = shifted(self, child, i, binomial)
                if (last > child) self%moments(:, i) = self%moments(:, i) + shifted(self, last, i, binomial)
            end do
        end do
        ! the series of 1/sqrt(1 - t)
        binomial(0, 0) = 1.0_wp
        do k = 1, terms - 1
            binomial(k, 0) = binomial(k - 1, 0)*(2*k - 1)/(2*k)
        end do
        do i = 1, size(self%centre)
            self%moments(:, i) = self%moments(:, i)*binomial(:, 0)
        end do
    end subroutine find_moments

    pure subroutine place(self, group, low, high)
        type(transform_t), intent(inout) :: self
        integer, intent(in) :: group
        real(wp), intent(in) :: low, high

        self%centre(group) = 0.5_wp*(low + high)
        self%half_width(group) = 0.5_wp*(high - low)
    end subroutine place

    !> The moments of a group about the centre of another, in its half-width.
    pure function shifted(self, from, to, binomial) result(moments)
        type(transform_t), intent(in) :: self
        integer, intent(in) :: from, to
        real(wp), intent(in) :: binomial(0:terms - 1, 0:terms - 1)
        real(wp) :: moments(0:terms - 1)
        real(wp) :: shrink(0:terms - 1), shift(0:terms - 1)
        integer :: j, k

        shrink(0) = 1.0_wp
        shift(0) = 1.0_wp
        do k = 1, terms - 1
            shrink(k) = shrink(k - 1)*self%half_width(from)/self%half_width(to)
            shift(k) = shift(k - 1)*(self%centre(from) - self%centre(to))/self%half_width(to)
        end do
        shrink = shrink*self%moments(:, from)
        do k = 0, terms - 1
            moments(k) = 0.0_wp
            do j = 0, k
                moments(k) = moments(k) + binomial(k, j)*shrink(j)*shift(k - j)
            end do
        end do
    end function shifted

    !> The factor of the kernel under the integral, in a panel.
    pure subroutine density(self, panel, r, phi)
        class(transform_t), intent(in) :: self
        integer, intent(in) :: panel
        real(wp), intent(in) :: r(:)
        real(wp), intent(out) :: phi(:)

        if (self%forward) then
            call self%f%slopes_in(panel, r, phi)
        else
            call self%f%values_in(panel, r, phi)
        end if
    end subroutine density

    !> g(x) or f(x), for x within the sampled range.
    function value(self, x) result(y)
        class(transform_t), intent(inout) :: self
        real(wp), intent(in) :: x
        real(wp) :: y
        integer :: i

        call enter_block(self, x)
        y = 0.0_wp
        if (self%far_count > 0) y = far_value(self, x)
        do i = 1, self%near_count
            y = y + near_integral(self, self%near(i), x)
        end do
        if (self%forward) y = y*x
        if (self%exponent > 0.0_wp) then
            associate (lowest => self%edges(1))
                if (self%forward) then
                    y = y + self%exponent*self%lowest_value*below_first(lowest/x, self%exponent)
                else
                    y = y + self%lowest_value*lowest/x*below_first(lowest/x, self%exponent + 1.0_wp)
                end if
            end associate
        end if
        if (.not. self%forward) y = y/half_pi
    end function value

    !> Finds the panel that holds x, and what is near to it and what far.
    subroutine enter_block(self, x)
        class(transform_t), intent(inout) :: self
        real(wp), intent(in) :: x
        real(wp) :: low, high, v, values(far_nodes)
        integer :: i, j, at

        if (self%block > 0) then
            if (x >= self%edges(self%block) .and. x <= self%edges(self%block + 1)) return
        end if
        self%block = interval_of(self%edges, x)
        self%near_count = 0
        self%far_count = 0
        call sort_group(self, size(self%first) - 1, size(self%centre))
        if (self%far_count == 0) return
        low = self%edges(self%block)**2
        high = self%edges(self%block + 1)**2
        do j = 1, far_nodes
            v = low + (high - low)*0.5_wp*(1.0_wp + 0.5_wp*far_nodes*self%cosines(j, 2))
            values(j) = 0.0_wp
            do i = 1, self%far_count
                at = self%far(i)
                values(j) = values(j) + series(self%moments(:, at), self%half_width(at)/(v - self%centre(at))) &
                            /sqrt(v - self%centre(at))
            end do
        end do
        do i = 1, far_nodes
            self%far_part(i) = sum(values*self%cosines(:, i))
        end do
    end subroutine enter_block

    !> A group goes to the far ones as a whole, to the near ones if it is a panel, or is considered by halves.
    recursive subroutine sort_group(self, level, group)
        class(transform_t), intent(inout) :: self
        integer, intent(in) :: level, group
        real(wp) :: low, distance
        integer :: child

        low = self%edges(self%block)**2
        distance = low - self%centre(group) - self%half_width(group)
        if (self%half_width(group) <= separation*(low - self%centre(group)) .and. &
            distance >= far_distance*0.5_wp*(self%edges(self%block + 1)**2 - low)) then
            self%far_count = self%far_count + 1
            self%far(self%far_count) = group
        else if (level == 1) then
            if (group > self%block) return
            self%near_count = self%near_count + 1
            self%near(self%near_count) = group
        else
            child = self%first(level - 1) + 2*(group - self%first(level))
            call sort_group(self, level - 1, child)
            if (child + 1 >= self%first(level)) return
            if (ishft(child + 1 - self%first(level - 1), level - 2) >= self%block) return
            call sort_group(self, level - 1, child + 1)
        end if
    end subroutine sort_group

    !> c(0) + c(1) t + ..., in four chains side by side.
    pure function series(c, t) result(y)
        real(wp), intent(in) :: c(0:terms - 1), t
        real(wp) :: y
        real(wp) :: part(0:3), t4
        integer :: k

        t4 = (t*t)*(t*t)
        part = c(terms - 4:)
        do k = terms - 8, 0, -4
            part = part*t4 + c(k:k + 3)
        end do
        y = (part(0) + part(1)*t) + (t*t)*(part(2) + part(3)*t)
    end function series

    pure function far_value(self, x) result(y)
        class(transform_t), intent(in) :: self
        real(wp), intent(in) :: x
        real(wp) :: y
        real(wp) :: low, high

        low = self%edges(self%block)
        high = self%edges(self%block + 1)
        y = chebyshev_sum(self%far_part, 2.0_wp*(x - low)*(x + low)/((high - low)*(high + low)) - 1.0_wp)
    end function far_value

    !> The integral over a panel as far as x, in s = sqrt(x - r).
    pure function near_integral(self, panel, x) result(y)
        class(transform_t), intent(in) :: self
        integer, intent(in) :: panel
        real(wp), intent(in) :: x
        real(wp) :: y
        real(wp) :: low, high, from, to

        low = self%edges(panel)
        high = min(self%edges(panel + 1), x)
        y = 0.0_wp
        if (.not. low < high) return
        from = sqrt(max(x - high, 0.0_wp))
        to = sqrt(x - low)
        ! few where a fine table makes narrow panels
        if (high - low < 0.05_wp*x .and. self%f%degree_in(panel) < few_nodes) then
            y = gauss(few_nodes, self%few, self%few_weights)
        else
            y = gauss(many_nodes, self%many, self%many_weights)
        end if

    contains

        pure function gauss(n, nodes, weights) result(integral)
            integer, intent(in) :: n
            real(wp), intent(in) :: nodes(n), weights(n)
            real(wp) :: integral
            ! no arrays that are allocated: this is done millions of times for a long table
            real(wp) :: square(many_nodes), r(many_nodes), phi(many_nodes)

            square(:n) = (from + (to - from)*nodes)**2
            r(:n) = min(max(x - square(:n), low), high)
            call density(self, panel, r(:n), phi(:n))
            integral = 2.0_wp*(to - from)*sum(weights*phi(:n)/sqrt(2.0_wp*x - square(:n)))
        end function gauss

    end function near_integral

    !> int_0^1 s^(n-1)/sqrt(1 - (q s)^2) ds for q <= 1/2: the transform of a power below the first edge.
    pure function below_first(q, n) result(integral)
        real(wp), intent(in) :: q, n
        real(wp) :: integral, coefficient
        integer :: k

        integral = 1.0_wp/n
        coefficient = 1.0_wp
        do k = 1, series_terms
            coefficient = coefficient*q**2*(2*k - 1)/(2*k)
            integral = integral + coefficient/(n + 2*k)
            if (coefficient < 0.1_wp*epsilon(q)) exit
        end do
    end function below_first

end module mdrcontact_profile_transform
