! SPDX-License-Identifier: GPL-3.0-or-later
!> A function that was sampled once and is then evaluated, differentiated and integrated for the price of a short polynomial.
!>
!> Piecewise Chebyshev interpolation on panels that are halved until the last coefficients vanish against the largest and the
!> series is the function where it was not sampled. A panel that begins at a break of the function uses the variable
!> sqrt(x - left edge), in which the square-root branches of contact mechanics are analytic.
module mdrcontact_numerics_sampled_function
    use, intrinsic :: iso_fortran_env, only: int64
    use mdrcontact_nonfinite, only: is_finite
    use mdrcontact_object, only: real_bytes
    use mdrcontact_cancel, only: check_cancelled
    use mdrcontact_error, only: check_memory, error_no_convergence, error_t, raise, to_text
    use mdrcontact_kinds, only: pi, wp
    use mdrcontact_numerics_chebyshev, only: chebyshev_sum, chebyshev_sums, cosine_transform, differentiate
    use mdrcontact_numerics_scalar_function, only: scalar_function_t
    use mdrcontact_numerics_search, only: interval_of
    implicit none (type, external)
    private
    public :: sampled_function_t, new_sampled_function

    !> Chebyshev nodes, and coefficients, in a panel.
    integer, parameter :: nodes = 20
    integer, parameter :: most_panels = 20000
    !> Where a series is compared with its function, in the panel's variable: in two gaps between its nodes, or in all of them and
    !> beyond the outermost ones.
    real(wp), parameter :: in_some(2) = [cos(0.35_wp*pi), cos(0.6_wp*pi)]
    integer, parameter :: gaps(nodes + 1) = [0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18, 19, 20]
    real(wp), parameter :: in_all(nodes + 1) = (1.0_wp - 1.0e-6_wp)*cos(pi*real(gaps, wp)/nodes)
    !> By how much more than the last coefficients a series may miss its function.
    real(wp), parameter :: margin = 10.0_wp
    !> A panel is not halved below this length relative to its distance from 0.
    real(wp), parameter :: shortest_panel = 1.0e-10_wp
    !> Where f may have steps of noise, a panel shorter than the first, relative likewise, is a straight line if its last
    !> coefficients have not fallen below the second times the others: it holds a kink or noise, of which a polynomial has slopes
    !> that the function has nowhere.
    real(wp), parameter :: narrow_panel = 1.0e-6_wp, least_fall = 1.0e-3_wp

    !> The slope in x of a function of t = sqrt(x - left edge) is taken no closer to the edge than this t: 1/t amplifies rounding.
    real(wp), parameter :: smallest_root = 1.0e-5_wp

    !> Chebyshev series on panels.
    type :: sampled_function_t
        private
        !> panel i runs from edges(i) to edges(i+1)
        real(wp), allocatable :: edges(:)
        !> whether panel i uses the variable sqrt(x - edges(i))
        logical, allocatable :: from_root(:)
        !> (nodes, panels)
        real(wp), allocatable :: coefficients(:, :)
        !> those of the derivative in the panel's variable, which runs from -1 to 1 (nodes, panels)
        real(wp), allocatable :: derivatives(:, :)
        !> how many coefficients of each panel count; the others are rounding
        integer, allocatable :: used(:)
        !> integral from edges(1) to edges(i)
        real(wp), allocatable :: integrals(:)
    contains
        procedure :: value
        procedure :: slope
        procedure :: integral
        procedure :: lower
        procedure :: upper
        procedure :: panel_edges
        procedure :: panels
        procedure :: edge
        procedure :: move_to
        procedure :: bytes
        procedure :: values_in
        procedure :: slopes_in
        procedure :: degree_in
    end type sampled_function_t

contains

    !> Samples `f` between the first and the last of `edges` to a relative `tolerance` of the largest value in each panel.
    subroutine new_sampled_function(self, f, edges, from_root, tolerance, error, noise, most, roughness, everywhere, &
                                    least_size, steps)
        type(sampled_function_t), intent(out) :: self
        class(scalar_function_t), intent(inout) :: f
        !> ascending; panels never cross one, so put them where f is not analytic
        real(wp), intent(in) :: edges(:)
        !> (size(edges) - 1) whether f has a square-root branch at the panel's left edge; of size 0: it has none
        logical, intent(in) :: from_root(:)
        real(wp), intent(in) :: tolerance
        type(error_t), allocatable, intent(out) :: error
        !> absolute accuracy of the values of f, beyond which no panel is refined; default 0
        real(wp), intent(in), optional :: noise
        !> number of panels, beyond which f is not smooth enough; default most_panels
        integer, intent(in), optional :: most
        !> relative accuracy of the values of f, beyond which a panel whose coefficients no longer fall is not refined; default 0
        real(wp), intent(in), optional :: roughness
        !> whether the series are compared with f in all gaps between the nodes, for an f with narrow features; default: in two
        logical, intent(in), optional :: everywhere
        !> f sees x rounded as if |x| were at least this: 1 if x is a logarithm; default 0
        real(wp), intent(in), optional :: least_size
        !> relative size of steps of f that are noise: a panel that halving made no better is not refined below them, else its slope
        !> would be that of a step; default 0
        real(wp), intent(in), optional :: steps
        !> left edge, right edge, and what was unresolved of the panel before it was halved
        real(wp), allocatable :: stack(:, :)
        logical, allocatable :: root_stack(:)
        integer :: waiting, count, limit, stat
        real(wp) :: cosines(nodes, nodes), coefficients(nodes), left, right, unresolved, attainable, largest, missed, x
        logical :: resolved, stagnates, look_everywhere

        limit = most_panels
        if (present(most)) limit = most
        look_everywhere = .false.
        if (present(everywhere)) look_everywhere = everywhere
        ! Panels wait on a stack, leftmost on top, so that finished ones come out in ascending order.
        call resize(self, 0, size(edges) + 64, error)
        if (allocated(error)) return
        allocate (stack(3, size(edges) + 64), root_stack(size(edges) + 64), stat=stat)
        call check_memory(error, stat)
        if (stat /= 0) return
        call cosine_transform(cosines)
        waiting = size(edges) - 1
        stack(1, :waiting) = edges(waiting:1:-1)
        stack(2, :waiting) = edges(waiting + 1:2:-1)
        stack(3, :waiting) = huge(1.0_wp)
        root_stack(:waiting) = .false.
        if (size(from_root) > 0) root_stack(:waiting) = from_root(waiting:1:-1)
        count = 0
        do while (waiting > 0)
            call check_cancelled(error)
            if (allocated(error)) return
            left = stack(1, waiting)
            right = stack(2, waiting)
            call sample_panel(f, left, right, root_stack(waiting), cosines, coefficients)
            if (allocated(f%error)) then
                error = f%error
                return
            end if
            if (.not. all(is_finite(coefficients))) then
                call raise(error, error_no_convergence, "the function leaves the number range near x = "//to_text(left))
                return
            end if
            unresolved = maxval(abs(coefficients(nodes - 2:)))
            largest = maxval(abs(coefficients))
            x = max(abs(left), abs(right))
            if (present(least_size)) x = max(x, least_size)
            ! No polynomial can be closer than the rounding of x allows, which moves x by this much of a narrow panel.
            attainable = tolerance*largest &
                         + epsilon(x)*x/(right - left)*maxval(abs(coefficients(2:)))
            if (present(noise)) attainable = max(attainable, noise)
            if (present(roughness)) then
                stagnates = unresolved > 0.1_wp*maxval(abs(coefficients(nodes/2:nodes - 3)))
                if (stagnates) attainable = max(attainable, roughness*largest)
            end if
            if (present(steps)) then
                if (unresolved > 0.5_wp*stack(3, waiting)) attainable = max(attainable, steps*largest)
            end if
            resolved = unresolved <= attainable
            if (resolved) then
                if (look_everywhere) then
                    call compare(f, left, right, root_stack(waiting), coefficients, in_all, missed)
                else
                    call compare(f, left, right, root_stack(waiting), coefficients, in_some, missed)
                end if
                if (allocated(f%error)) then
                    error = f%error
                    return
                end if
                resolved = missed <= margin*attainable
            end if
            if (.not. resolved .and. right - left <= shortest_panel*x) resolved = .true.
            if (.not. resolved .and. waiting < size(root_stack)) then
                stack(:, waiting + 1) = [left, 0.5_wp*(left + right), unresolved]
                stack(1, waiting) = 0.5_wp*(left + right)
                stack(3, waiting) = unresolved
                root_stack(waiting + 1) = root_stack(waiting)
                root_stack(waiting) = .false.
                waiting = waiting + 1
                cycle
            end if
            if (.not. resolved .or. count >= limit) then
                call raise(error, error_no_convergence, "the function is not smooth enough to be sampled near x = "//to_text(left))
                return
            end if
            if (present(steps)) then
                if (right - left < narrow_panel*x .and. unresolved > least_fall*maxval(abs(coefficients(3:)))) then
                    call straighten(coefficients, 0.5_wp*nodes*cosines(1, 2))
                end if
            end if
            count = count + 1
            if (count > size(self%from_root)) call resize(self, count - 1, 2*count, error)
            if (allocated(error)) return
            self%edges(count) = left
            self%from_root(count) = root_stack(waiting)
            self%coefficients(:, count) = coefficients
            waiting = waiting - 1
        end do
        call resize(self, count, count, error)
        if (allocated(error)) return
        allocate (self%derivatives(nodes, count), self%used(count), self%integrals(count + 1), stat=stat)
        call check_memory(error, stat)
        if (allocated(error)) return
        self%edges(count + 1) = edges(size(edges))
        do count = 1, size(self%from_root)
            self%used(count) = leading(self%coefficients(:, count), self%edges(count), self%edges(count + 1))
            ! those left out as rounding would come back in the lowest coefficients of the derivative, as a slope of what is level
            self%derivatives(:, count) = 0.0_wp
            if (self%used(count) > 1) call differentiate(self%coefficients(:self%used(count), count), &
                                                         self%derivatives(:self%used(count), count))
        end do
        call integrate_panels(self)
    end subroutine new_sampled_function

    !> How many coefficients are more than the rounding of values and of positions.
    pure function leading(c, left, right) result(count)
        real(wp), intent(in) :: c(nodes), left, right
        integer :: count
        real(wp) :: rounding

        rounding = epsilon(c)*(2.0_wp*maxval(abs(c)) + max(abs(left), abs(right))/(right - left)*maxval(abs(c(2:))))
        do count = nodes, 2, -1
            if (abs(c(count)) > rounding) return
        end do
    end function leading

    subroutine sample_panel(f, left, right, from_root, cosines, coefficients)
        class(scalar_function_t), intent(inout) :: f
        real(wp), intent(in) :: left, right
        logical, intent(in) :: from_root
        real(wp), intent(in) :: cosines(nodes, nodes)
        real(wp), intent(out) :: coefficients(nodes)
        real(wp) :: values(nodes), t
        integer :: i, j

        coefficients = 0.0_wp
        do i = 1, nodes
            t = place(0.5_wp*nodes*cosines(i, 2), from_root)
            values(i) = f%value(left + (right - left)*t)
            if (allocated(f%error)) return
        end do
        do j = 1, nodes
            coefficients(j) = sum(values*cosines(:, j))
        end do
    end subroutine sample_panel

    !> The straight line through the values at the outermost nodes, z and -z.
    pure subroutine straighten(c, z)
        real(wp), intent(inout) :: c(nodes)
        real(wp), intent(in) :: z
        real(wp) :: ends(2)

        ends = [chebyshev_sum(c, -abs(z)), chebyshev_sum(c, abs(z))]
        c = 0.0_wp
        c(1) = 0.5_wp*sum(ends)
        c(2) = 0.5_wp*(ends(2) - ends(1))/abs(z)
    end subroutine straighten

    !> Where the panel's variable z, -1 to 1, lies in the panel, 0 to 1.
    pure function place(z, from_root) result(t)
        real(wp), intent(in) :: z
        logical, intent(in) :: from_root
        real(wp) :: t

        t = 0.5_wp*(1.0_wp + z)
        if (from_root) t = t**2
    end function place

    !> The largest distance of a panel's series from its function at some places z.
    subroutine compare(f, left, right, from_root, coefficients, z, missed)
        class(scalar_function_t), intent(inout) :: f
        real(wp), intent(in) :: left, right
        logical, intent(in) :: from_root
        real(wp), intent(in) :: coefficients(nodes)
        real(wp), intent(in) :: z(:)
        real(wp), intent(out) :: missed
        real(wp) :: distance
        integer :: i

        missed = 0.0_wp
        do i = 1, size(z)
            distance = abs(f%value(left + (right - left)*place(z(i), from_root)) - chebyshev_sum(coefficients, z(i)))
            if (allocated(f%error)) return
            ! what is no number has missed too
            if (.not. distance <= missed) missed = distance
        end do
    end subroutine compare

    !> Keeps the first panels and makes room for `room` of them.
    subroutine resize(self, kept, room, error)
        type(sampled_function_t), intent(inout) :: self
        integer, intent(in) :: kept, room
        type(error_t), allocatable, intent(inout) :: error
        real(wp), allocatable :: edges(:), coefficients(:, :)
        logical, allocatable :: from_root(:)
        integer :: stat

        allocate (edges(room + 1), from_root(room), coefficients(nodes, room), stat=stat)
        call check_memory(error, stat)
        if (allocated(error)) return
        if (kept > 0) then
            edges(:kept) = self%edges(:kept)
            from_root(:kept) = self%from_root(:kept)
            coefficients(:, :kept) = self%coefficients(:, :kept)
        end if
        call move_alloc(edges, self%edges)
        call move_alloc(from_root, self%from_root)
        call move_alloc(coefficients, self%coefficients)
    end subroutine resize

    !> What a copy takes [byte].
    pure function bytes(self)
        class(sampled_function_t), intent(in) :: self
        integer(int64) :: bytes

        bytes = real_bytes*(2*size(self%coefficients) + 4*size(self%edges))
    end function bytes

    subroutine integrate_panels(self)
        type(sampled_function_t), intent(inout) :: self
        integer :: i

        self%integrals(1) = 0.0_wp
        do i = 1, size(self%from_root)
            self%integrals(i + 1) = self%integrals(i) + partial_integral(self, i, 1.0_wp)
        end do
    end subroutine integrate_panels

    !> f(x) for lower() <= x <= upper(); beyond, the outermost panel's polynomial.
    elemental function value(self, x) result(y)
        class(sampled_function_t), intent(in) :: self
        real(wp), intent(in) :: x
        real(wp) :: y

        y = value_in(self, interval_of(self%edges, x), x)
    end function value

    !> f(x) and f'(x) at points of one panel, counted from 1, that does not begin at a branch.
    pure subroutine values_in(self, panel, x, y)
        class(sampled_function_t), intent(in) :: self
        integer, intent(in) :: panel
        real(wp), intent(in) :: x(:)
        !> same size as x
        real(wp), intent(out) :: y(:)

        call chebyshev_sums(self%coefficients(:self%used(panel), panel), self%edges(panel), self%edges(panel + 1), x, y)
    end subroutine values_in

    pure subroutine slopes_in(self, panel, x, y)
        class(sampled_function_t), intent(in) :: self
        integer, intent(in) :: panel
        real(wp), intent(in) :: x(:)
        real(wp), intent(out) :: y(:)

        call chebyshev_sums(self%derivatives(:max(self%used(panel) - 1, 1), panel), self%edges(panel), self%edges(panel + 1), x, y)
        y = y*(2.0_wp/(self%edges(panel + 1) - self%edges(panel)))
    end subroutine slopes_in

    elemental function value_in(self, panel, x) result(y)
        type(sampled_function_t), intent(in) :: self
        integer, intent(in) :: panel
        real(wp), intent(in) :: x
        real(wp) :: y

        y = chebyshev_sum(self%coefficients(:self%used(panel), panel), 2.0_wp*local(self, panel, x) - 1.0_wp)
    end function value_in

    !> The degree of a panel's polynomial.
    pure function degree_in(self, panel) result(degree)
        class(sampled_function_t), intent(in) :: self
        integer, intent(in) :: panel
        integer :: degree

        degree = self%used(panel) - 1
    end function degree_in

    !> f'(x).
    elemental function slope(self, x) result(y)
        class(sampled_function_t), intent(in) :: self
        real(wp), intent(in) :: x
        real(wp) :: y

        y = slope_in(self, interval_of(self%edges, x), x)
    end function slope

    elemental function slope_in(self, panel, x) result(y)
        type(sampled_function_t), intent(in) :: self
        integer, intent(in) :: panel
        real(wp), intent(in) :: x
        real(wp) :: y
        real(wp) :: t

        t = local(self, panel, x)
        if (self%from_root(panel)) t = max(t, smallest_root)
        y = 2.0_wp*chebyshev_sum(self%derivatives(:max(self%used(panel) - 1, 1), panel), 2.0_wp*t - 1.0_wp) &
            /(self%edges(panel + 1) - self%edges(panel))
        if (self%from_root(panel)) y = y/(2.0_wp*t)
    end function slope_in

    !> The integral of f from lower() to x.
    elemental function integral(self, x) result(y)
        class(sampled_function_t), intent(in) :: self
        real(wp), intent(in) :: x
        real(wp) :: y
        integer :: i

        i = interval_of(self%edges, x)
        y = self%integrals(i) + partial_integral(self, i, local(self, i, x))
    end function integral

    pure function lower(self) result(x)
        class(sampled_function_t), intent(in) :: self
        real(wp) :: x

        x = self%edges(1)
    end function lower

    pure function upper(self) result(x)
        class(sampled_function_t), intent(in) :: self
        real(wp) :: x

        x = self%edges(size(self%edges))
    end function upper

    !> The edges of all panels, ascending.
    pure function panel_edges(self) result(edges)
        class(sampled_function_t), intent(in) :: self
        real(wp), allocatable :: edges(:)

        edges = self%edges
    end function panel_edges

    !> How many panels there are.
    pure function panels(self) result(count)
        class(sampled_function_t), intent(in) :: self
        integer :: count

        count = size(self%from_root)
    end function panels

    !> The left edge of panel i, 1 to panels() + 1.
    pure function edge(self, i) result(x)
        class(sampled_function_t), intent(in) :: self
        integer, intent(in) :: i
        real(wp) :: x

        x = self%edges(i)
    end function edge

    !> Moves to another place, without a copy.
    pure subroutine move_to(self, to)
        class(sampled_function_t), intent(inout) :: self
        type(sampled_function_t), intent(inout) :: to

        call move_alloc(self%edges, to%edges)
        call move_alloc(self%from_root, to%from_root)
        call move_alloc(self%coefficients, to%coefficients)
        call move_alloc(self%derivatives, to%derivatives)
        call move_alloc(self%used, to%used)
        call move_alloc(self%integrals, to%integrals)
    end subroutine move_to

    !> The panel's variable, 0 at its left and 1 at its right edge.
    pure function local(self, i, x) result(t)
        type(sampled_function_t), intent(in) :: self
        integer, intent(in) :: i
        real(wp), intent(in) :: x
        real(wp) :: t

        t = (x - self%edges(i))/(self%edges(i + 1) - self%edges(i))
        if (self%from_root(i)) t = sqrt(max(t, 0.0_wp))
    end function local

    !> The integral over panel i from its left edge to local variable t.
    pure function partial_integral(self, i, t) result(y)
        type(sampled_function_t), intent(in) :: self
        integer, intent(in) :: i
        real(wp), intent(in) :: t
        real(wp) :: y
        real(wp) :: integrand(nodes + 3), primitive(nodes + 2)
        integer :: j

        ! With x = l + L t the integrand in t is L f, with x = l + L t^2 it is 2 L t f, and t = (1 + z)/2.
        integrand = 0.0_wp
        if (self%from_root(i)) then
            integrand(:nodes) = self%coefficients(:, i)
            integrand(2) = integrand(2) + self%coefficients(1, i)
            do j = 2, nodes
                integrand(j - 1) = integrand(j - 1) + 0.5_wp*self%coefficients(j, i)
                integrand(j + 1) = integrand(j + 1) + 0.5_wp*self%coefficients(j, i)
            end do
        else
            integrand(:nodes) = self%coefficients(:, i)
        end if
        primitive(1) = 0.0_wp
        primitive(2) = integrand(1) - 0.5_wp*integrand(3)
        do j = 3, nodes + 2
            primitive(j) = (integrand(j - 1) - integrand(j + 1))/(2.0_wp*(j - 1))
        end do
        y = 0.5_wp*(self%edges(i + 1) - self%edges(i)) &
            *(chebyshev_sum(primitive, 2.0_wp*t - 1.0_wp) - chebyshev_sum(primitive, -1.0_wp))
    end function partial_integral

end module mdrcontact_numerics_sampled_function
