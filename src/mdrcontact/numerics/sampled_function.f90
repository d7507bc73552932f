! SPDX-License-Identifier: GPL-3.0-or-later
!> A function that was sampled once and is then evaluated, differentiated and integrated for the price of a short polynomial.
!>
!> Piecewise Chebyshev interpolation on panels that are halved until the last coefficients vanish against the
!> largest. A panel that begins at a break of the function uses the variable sqrt(x - left edge), in which the square-root
!> branches of contact mechanics are analytic.
module mdrcontact_numerics_sampled_function
    use, intrinsic :: ieee_arithmetic, only: ieee_is_finite
    use mdrcontact_error, only: error_no_convergence, error_t, raise, to_text
    use mdrcontact_kinds, only: pi, wp
    use mdrcontact_numerics_scalar_function, only: scalar_function_t
    implicit none (type, external)
    private
    public :: sampled_function_t, new_sampled_function

    !> Chebyshev nodes, and coefficients, in a panel.
    integer, parameter :: nodes = 20
    integer, parameter :: most_panels = 20000
    !> A panel is not halved below this length relative to its distance from 0.
    real(wp), parameter :: shortest_panel = 1.0e-10_wp

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
        !> integral from edges(1) to edges(i)
        real(wp), allocatable :: integrals(:)
    contains
        procedure :: value
        procedure :: slope
        procedure :: integral
        procedure :: lower
        procedure :: upper
        procedure :: panel_edges
    end type sampled_function_t

contains

    !> Samples `f` between the first and the last of `edges` to a relative `tolerance` of the largest value in each panel.
    subroutine new_sampled_function(self, f, edges, from_root, tolerance, error, noise, most, roughness)
        type(sampled_function_t), intent(out) :: self
        class(scalar_function_t), intent(inout) :: f
        !> ascending; panels never cross one, so put them where f is not analytic
        real(wp), intent(in) :: edges(:)
        !> (size(edges) - 1): whether f has a square-root branch at the panel's left edge
        logical, intent(in) :: from_root(:)
        real(wp), intent(in) :: tolerance
        type(error_t), allocatable, intent(out) :: error
        !> absolute accuracy of the values of f, beyond which no panel is refined; default 0
        real(wp), intent(in), optional :: noise
        !> number of panels, beyond which f is not smooth enough; default most_panels
        integer, intent(in), optional :: most
        !> relative accuracy of the values of f, beyond which a panel whose coefficients no longer fall is not refined; default 0
        real(wp), intent(in), optional :: roughness
        real(wp), allocatable :: stack(:, :)
        logical, allocatable :: root_stack(:)
        integer :: waiting, count, limit
        real(wp) :: coefficients(nodes), left, right, unresolved
        logical :: resolved

        limit = most_panels
        if (present(most)) limit = most
        ! Panels wait on a stack, leftmost on top, so that finished ones come out in ascending order.
        allocate (self%edges(64), self%from_root(64), self%coefficients(nodes, 64))
        allocate (stack(2, size(edges) + 64), root_stack(size(edges) + 64))
        waiting = size(edges) - 1
        stack(1, :waiting) = edges(waiting:1:-1)
        stack(2, :waiting) = edges(waiting + 1:2:-1)
        root_stack(:waiting) = from_root(waiting:1:-1)
        count = 0
        do while (waiting > 0)
            left = stack(1, waiting)
            right = stack(2, waiting)
            call sample_panel(f, left, right, root_stack(waiting), coefficients)
            if (allocated(f%error)) then
                error = f%error
                return
            end if
            if (.not. all(ieee_is_finite(coefficients))) then
                call raise(error, error_no_convergence, "the function leaves the number range near x = "//to_text(left))
                return
            end if
            unresolved = maxval(abs(coefficients(nodes - 2:)))
            ! No polynomial can be closer than the rounding of x allows, which moves x by this much of a narrow panel.
            resolved = unresolved <= tolerance*maxval(abs(coefficients)) + &
                       epsilon(left)*max(abs(left), abs(right))/(right - left)*maxval(abs(coefficients(2:)))
            if (present(noise)) resolved = resolved .or. unresolved <= noise
            if (present(roughness)) resolved = resolved .or. unresolved <= roughness*maxval(abs(coefficients)) .and. &
                                               unresolved > 0.1_wp*maxval(abs(coefficients(nodes/2:nodes - 3)))
            if (.not. resolved .and. right - left <= shortest_panel*max(abs(left), abs(right))) resolved = .true.
            if (.not. resolved .and. waiting < size(root_stack)) then
                stack(:, waiting + 1) = [left, 0.5_wp*(left + right)]
                stack(1, waiting) = 0.5_wp*(left + right)
                root_stack(waiting + 1) = root_stack(waiting)
                root_stack(waiting) = .false.
                waiting = waiting + 1
                cycle
            end if
            if (.not. resolved .or. count >= limit) then
                call raise(error, error_no_convergence, "the function is not smooth enough to be sampled near x = "//to_text(left))
                return
            end if
            count = count + 1
            if (count > size(self%from_root)) call grow(self)
            self%edges(count) = left
            self%from_root(count) = root_stack(waiting)
            self%coefficients(:, count) = coefficients
            waiting = waiting - 1
        end do
        self%edges = [self%edges(:count), edges(size(edges))]
        self%from_root = self%from_root(:count)
        self%coefficients = self%coefficients(:, :count)
        allocate (self%derivatives, mold=self%coefficients)
        do count = 1, size(self%from_root)
            call differentiate(self%coefficients(:, count), self%derivatives(:, count))
        end do
        call integrate_panels(self)
    end subroutine new_sampled_function

    subroutine sample_panel(f, left, right, from_root, coefficients)
        class(scalar_function_t), intent(inout) :: f
        real(wp), intent(in) :: left, right
        logical, intent(in) :: from_root
        real(wp), intent(out) :: coefficients(nodes)
        real(wp) :: values(nodes), t
        integer :: i, j

        coefficients = 0.0_wp
        do i = 1, nodes
            t = 0.5_wp*(1.0_wp + cos(pi*(i - 0.5_wp)/nodes))
            if (from_root) t = t**2
            values(i) = f%value(left + (right - left)*t)
            if (allocated(f%error)) return
        end do
        do j = 1, nodes
            coefficients(j) = (2.0_wp/nodes)*sum(values*cos(pi*(j - 1)*([(i, i=1, nodes)] - 0.5_wp)/nodes))
        end do
        coefficients(1) = 0.5_wp*coefficients(1)
    end subroutine sample_panel

    subroutine grow(self)
        type(sampled_function_t), intent(inout) :: self
        real(wp), allocatable :: edges(:), coefficients(:, :)
        logical, allocatable :: from_root(:)
        integer :: size_before

        size_before = size(self%from_root)
        allocate (edges(2*size_before), from_root(2*size_before), coefficients(nodes, 2*size_before))
        edges(:size_before) = self%edges
        from_root(:size_before) = self%from_root
        coefficients(:, :size_before) = self%coefficients
        call move_alloc(edges, self%edges)
        call move_alloc(from_root, self%from_root)
        call move_alloc(coefficients, self%coefficients)
    end subroutine grow

    subroutine integrate_panels(self)
        type(sampled_function_t), intent(inout) :: self
        integer :: i

        allocate (self%integrals(size(self%edges)))
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
        integer :: i

        i = panel_of(self, x)
        y = chebyshev_sum(self%coefficients(:, i), 2.0_wp*local(self, i, x) - 1.0_wp)
    end function value

    !> f'(x).
    elemental function slope(self, x) result(y)
        class(sampled_function_t), intent(in) :: self
        real(wp), intent(in) :: x
        real(wp) :: y
        real(wp) :: t
        integer :: i

        i = panel_of(self, x)
        t = local(self, i, x)
        if (self%from_root(i)) t = max(t, smallest_root)
        y = 2.0_wp*chebyshev_sum(self%derivatives(:, i), 2.0_wp*t - 1.0_wp)/(self%edges(i + 1) - self%edges(i))
        if (self%from_root(i)) y = y/(2.0_wp*t)
    end function slope

    !> The integral of f from lower() to x.
    elemental function integral(self, x) result(y)
        class(sampled_function_t), intent(in) :: self
        real(wp), intent(in) :: x
        real(wp) :: y
        integer :: i

        i = panel_of(self, x)
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

    pure function panel_of(self, x) result(low)
        type(sampled_function_t), intent(in) :: self
        real(wp), intent(in) :: x
        integer :: low, high, middle

        low = 1
        high = size(self%from_root) + 1
        do while (high - low > 1)
            middle = (low + high)/2
            if (x < self%edges(middle)) then
                high = middle
            else
                low = middle
            end if
        end do
    end function panel_of

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

    !> Clenshaw's sum of c(1) T_0 + c(2) T_1 + ... at z.
    pure function chebyshev_sum(c, z) result(y)
        real(wp), intent(in) :: c(:), z
        real(wp) :: y
        real(wp) :: b1, b2, b3
        integer :: j

        b1 = 0.0_wp
        b2 = 0.0_wp
        do j = size(c), 2, -1
            b3 = b2
            b2 = b1
            b1 = 2.0_wp*z*b2 - b3 + c(j)
        end do
        y = z*b1 - b2 + c(1)
    end function chebyshev_sum

    pure subroutine differentiate(c, derivative)
        real(wp), intent(in) :: c(nodes)
        real(wp), intent(out) :: derivative(nodes)
        integer :: j

        derivative(nodes) = 0.0_wp
        derivative(nodes - 1) = 2.0_wp*(nodes - 1)*c(nodes)
        do j = nodes - 2, 1, -1
            derivative(j) = derivative(j + 2) + 2.0_wp*j*c(j + 1)
        end do
        derivative(1) = 0.5_wp*derivative(1)
    end subroutine differentiate

end module mdrcontact_numerics_sampled_function
