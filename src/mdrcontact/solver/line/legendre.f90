! SPDX-License-Identifier: GPL-3.0-or-later
!> The springs' interaction in even Legendre polynomials over a contact (theory/exact.md (3.1)-(3.5)),
!> (K p)(x) = (1/pi) int_-a^a X(x - t) p(t) dt.
!>
!> With p_j(u) = s_j P_2j(u), s_j = sqrt((4j + 1)/2), u = x/a, everything follows from the kernel's moments
!> T_k = int_-1^1 P_k(u) [X(a (1 + u)) - shift] du: the matrix H_ij = <p_i, K p_j> by a recurrence, K p_j at the edge of the
!> contact, and its slope there. Two constants of the kernel that would drown the rest are kept apart: X(0) of a stiff film
!> (`shift`), and the integral of X over the whole axis for a soft one (`diagonal`, what it leaves of the unit matrix).
module mdrcontact_line_legendre
    use mdrcontact_error, only: check_memory, error_t
    use mdrcontact_kinds, only: half_pi, pi, wp
    use mdrcontact_line_kernel, only: kernel_t
    use mdrcontact_line_rule, only: largest_rule, new_rule, rule_t
    implicit none (type, external)
    private
    public :: moments_t, new_interaction, interaction_matrix, contact_rule, edge_kernel, edge_row, edge_slopes, is_fine, &
              normalisation

    !> Moments of a rule of N nodes are accurate up to order 0.8 N.
    real(wp), parameter :: trusted = 0.8_wp

    !> The kernel's moments for one contact radius.
    type :: moments_t
        !> contact radius [unit]
        real(wp) :: a = 0.0_wp
        !> T_k, k >= 0
        real(wp), allocatable :: t(:)
        !> what 1 + K leaves on the diagonal next to the matrix made of the moments
        real(wp) :: diagonal = 1.0_wp
        !> the part of X that is left out of the moments: a constant, and one that represents a delta function
        real(wp) :: shift = 0.0_wp, spike = 0.0_wp
        !> X(2a) - X(0)
        real(wp) :: drop = 0.0_wp
        !> how large the rounding errors of K are, in units of epsilon
        real(wp) :: magnitude = 0.0_wp
    end type moments_t

contains

    !> H_ij, i >= j, without `diagonal`, and the moments that it is made of; what lies above the diagonal of h is not defined.
    subroutine new_interaction(moments, h, kernel, a, rows, columns, count, order, error, odd)
        type(moments_t), intent(out) :: moments
        !> (rows, columns)
        real(wp), allocatable, intent(out) :: h(:, :)
        type(kernel_t), intent(in) :: kernel
        !> [length]
        real(wp), intent(in) :: a
        !> count and order as in contact_rule
        integer, intent(in) :: rows, columns, count, order
        type(error_t), allocatable, intent(inout) :: error
        !> between odd polynomials, sqrt((4j + 3)/2) P_(2j+1)(u), instead; default false
        logical, intent(in), optional :: odd
        real(wp), allocatable :: work(:, :)
        integer :: status

        call new_moments(moments, kernel, a/kernel%unit, count, order, 2*(rows + columns), &
                         is_fine(kernel, a/kernel%unit, columns), error)
        if (allocated(error)) return
        allocate (h(rows, columns), work(rows + columns, 5), stat=status)
        call check_memory(error, status)
        if (status /= 0) return
        call fill_matrix(moments, h, work(:rows, 1), work(:, 2), work(:, 3), work(:, 4), work(:, 5), odd)
    end subroutine new_interaction

    !> Matrix H_ij, i, j = 0 ... n - 1, with `diagonal`; 0 where there are no layers.
    subroutine interaction_matrix(kernel, a, n, nodes, matrix, error)
        type(kernel_t), intent(in) :: kernel
        !> [length]
        real(wp), intent(in) :: a
        !> polynomials, and nodes that the kernel takes
        integer, intent(in) :: n, nodes
        real(wp), allocatable, intent(out) :: matrix(:, :)
        type(error_t), allocatable, intent(inout) :: error
        type(moments_t) :: moments
        integer :: i

        if (allocated(error)) return
        if (kernel%vanishes) then
            allocate (matrix(n, n))
            matrix = 0.0_wp
            return
        end if
        call new_interaction(moments, matrix, kernel, a, n, n, nodes, 4*n, error)
        if (allocated(error)) return
        do i = 1, n
            matrix(i, i) = matrix(i, i) + (moments%diagonal - 1.0_wp)
            matrix(i, i + 1:) = matrix(i + 1:, i)
        end do
    end subroutine interaction_matrix

    !> s_j, j = 0 ... size - 1.
    pure function normalisation(count) result(s)
        integer, intent(in) :: count
        real(wp) :: s(0:count - 1)
        integer :: j

        do j = 0, count - 1
            s(j) = sqrt(real(4*j + 1, wp)*0.5_wp)
        end do
    end function normalisation

    !> Whether the kernel varies at lengths that n unknowns do not follow, as it does on a graded body.
    pure function is_fine(kernel, a, n) result(answer)
        type(kernel_t), intent(in) :: kernel
        !> contact radius [unit]
        real(wp), intent(in) :: a
        integer, intent(in) :: n
        logical :: answer

        answer = kernel%is_graded() .and. real(n, wp) < 2.7_wp*sqrt(a) + 2.0_wp
    end function is_fine

    !> The rule that resolves the kernel from one end of a contact of radius a [unit]: of at least `count` nodes, and where the
    !> kernel is fine of as many as polynomials of this order take, closer at the end. Where one rule is too short, as many as are
    !> needed share the half waves of the polynomials.
    subroutine contact_rule(rule, a, count, order, fine, error)
        type(rule_t), intent(out) :: rule
        real(wp), intent(in) :: a
        integer, intent(in) :: count, order
        !> see is_fine
        logical, intent(in) :: fine
        type(error_t), allocatable, intent(inout) :: error
        type(rule_t) :: panel
        real(wp) :: ends(2)
        integer :: i, nodes, panels, first

        nodes = count
        if (fine) nodes = max(ceiling(1.5_wp/trusted*real(order, wp)), min(24 + nint(16.0_wp*sqrt(sqrt(a))), 256))
        panels = 1
        ! nodes lie closest to the ends of a rule of its own, pi/2 times as far apart where panels join
        if (nodes > largest_rule) panels = ceiling(half_pi*real(nodes, wp)/real(largest_rule, wp))
        call new_rule(panel, min(nodes, largest_rule), error)
        if (allocated(error)) return
        if (panels == 1 .and. .not. fine) then
            call move_alloc(panel%distance, rule%distance)
            call move_alloc(panel%weights, rule%weights)
            return
        end if
        nodes = size(panel%weights)
        allocate (rule%distance(panels*nodes), rule%weights(panels*nodes))
        do i = 1, panels
            first = (i - 1)*nodes + 1
            ends = 2.0_wp*sin(half_pi*[real(i - 1, wp), real(i, wp)]/real(panels, wp))**2
            ! fine at the surface: the rule in the cube root of the distance, 1 + u = s^3/4 on 0 < s < 2
            if (fine) ends = (4.0_wp*ends)**(1.0_wp/3.0_wp)
            rule%distance(first:first + nodes - 1) = ends(1) + 0.5_wp*(ends(2) - ends(1))*panel%distance
            rule%weights(first:first + nodes - 1) = 0.5_wp*(ends(2) - ends(1))*panel%weights
        end do
        if (.not. fine) return
        rule%weights = 0.75_wp*rule%weights*rule%distance**2
        rule%distance = 0.25_wp*rule%distance**3
    end subroutine contact_rule

    !> The moments T_0 ... T_last at contact radius a [unit]; the arguments of contact_rule.
    subroutine new_moments(self, kernel, a, count, order, last, fine, error)
        type(moments_t), intent(out) :: self
        type(kernel_t), intent(in) :: kernel
        real(wp), intent(in) :: a
        integer, intent(in) :: count, order, last
        logical, intent(in) :: fine
        type(error_t), allocatable, intent(inout) :: error
        type(rule_t) :: rule
        real(wp), allocatable :: x(:), even(:), odd(:), work(:, :)
        real(wp) :: base(1)
        integer :: n, half, highest

        self%a = a
        call contact_rule(rule, a, count, order, fine, error)
        if (allocated(error)) return
        n = size(rule%weights)
        highest = n - 1
        if (fine) highest = floor(trusted/1.5_wp*n)
        half = n/2
        allocate (x(n), even(half), odd(half), work(n, 4), self%t(0:last))
        if (kernel%one_plus_chi_zero > 1.0_wp .and. 2.0_wp*a <= scale(1.0_wp, kernel%plateau)) self%shift = kernel%origin
        work(:, 1) = a*rule%distance
        call kernel%evaluate(work(:, 1), self%shift, x)
        call kernel%evaluate([2.0_wp*a], kernel%origin, base)
        self%drop = base(1)
        x = x*rule%weights
        self%magnitude = 2.0_wp*a/pi*sum(abs(x))
        base = sum(x)
        if (kernel%one_plus_chi_zero < 1.0_wp .and. 2.0_wp*a >= 1.0_wp) then
            self%diagonal = kernel%one_plus_chi_zero
            self%spike = 0.5_wp*pi*(kernel%one_plus_chi_zero - 1.0_wp)/a
            base = -kernel%integral_beyond(2.0_wp*a)/a
            ! the sum of X is exact here: what is left are its first moments
            self%magnitude = 2.0_wp*a/pi*sum(abs(x)*rule%distance)
        end if
        if (fine) then
            call sum_moments(n, rule%distance, x, x, base(1), 0.0_wp, min(highest, last), work, self%t)
        else
            ! the rule is symmetric, and P_k(-u) = (-1)^k P_k(u)
            even(:) = x(:half) + x(n:half + 1:-1)
            odd(:) = x(:half) - x(n:half + 1:-1)
            call sum_moments(half, rule%distance, even, odd, base(1), 2.0_wp*sum(x(half + 1:)), min(highest, last), work, self%t)
        end if
        if (highest < last) self%t(highest + 1:) = base(1) - sum(x)
        self%t(1::2) = -self%t(1::2)
    end subroutine new_moments

    !> t_k = base + sum of x r_k with P_k(v - 1) = (-1)^k (1 + r_k(v)), k = 0 ... count: r_k keeps its digits towards v = 0.
    pure subroutine sum_moments(n, v, even, odd, base, less, count, work, t)
        !> a multiple of 2
        integer, intent(in) :: n
        !> nodes, x for even k and for odd k, and what is taken off `base` for odd k
        real(wp), intent(in) :: v(n), even(n), odd(n), base, less
        integer, intent(in) :: count
        real(wp), intent(out) :: work(n, 4)
        real(wp), intent(inout) :: t(0:)
        real(wp) :: parts(2)
        integer :: k

        work(:, :2) = 0.0_wp
        t(0) = base
        do k = 1, count, 2
            call add_orders(n, k, v, odd, even, work(:, 1), work(:, 2), work(:, 3), work(:, 4), parts)
            t(k) = (base - less) + parts(1)
            if (k < count) t(k + 1) = base + parts(2)
        end do
    end subroutine sum_moments

    !> From r_(k-1) and its difference from the one before to r_(k+1), and the sums of x r_k and of y r_(k+1): first the products,
    !> then the sums, two at a time, which compilers take as vectors.
    pure subroutine add_orders(n, k, v, x, y, difference, r, of_x, of_y, totals)
        integer, intent(in) :: n, k
        real(wp), intent(in) :: v(n), x(n), y(n)
        real(wp), intent(inout) :: difference(n), r(n)
        !> the products
        real(wp), intent(out) :: of_x(n), of_y(n)
        real(wp), intent(out) :: totals(2)
        real(wp) :: keep(2), turn(2), part(2), d, s
        integer :: i

        keep = [real(k - 1, wp)/real(k, wp), real(k, wp)/real(k + 1, wp)]
        turn = [real(2*k - 1, wp)/real(k, wp), real(2*k + 1, wp)/real(k + 1, wp)]
        do i = 1, n
            d = keep(1)*difference(i) - turn(1)*(v(i)*(1.0_wp + r(i)))
            s = r(i) + d
            of_x(i) = x(i)*s
            d = keep(2)*d - turn(2)*(v(i)*(1.0_wp + s))
            s = s + d
            of_y(i) = y(i)*s
            difference(i) = d
            r(i) = s
        end do
        part = 0.0_wp
        do i = 1, n, 2
            part(1) = part(1) + of_x(i)
            part(2) = part(2) + of_x(i + 1)
        end do
        totals(1) = sum(part)
        part = 0.0_wp
        do i = 1, n, 2
            part(1) = part(1) + of_y(i)
            part(2) = part(2) + of_y(i + 1)
        end do
        totals(2) = sum(part)
    end subroutine add_orders

    !> The matrix of new_interaction.
    pure subroutine fill_matrix(moments, h, s, even, odd, over_even, over_odd, is_odd)
        type(moments_t), intent(in) :: moments
        real(wp), intent(out), contiguous :: h(0:, 0:)
        !> room: as many as rows, and as rows and columns together
        real(wp), intent(out), contiguous :: s(0:), even(0:), odd(0:), over_even(0:), over_odd(0:)
        logical, intent(in), optional :: is_odd
        integer :: c, j, last
        logical :: between_odd

        between_odd = .false.
        if (present(is_odd)) between_odd = is_odd
        last = ubound(h, 1) + ubound(h, 2)
        do j = 0, last
            over_even(j) = 1.0_wp/real(4*j + 1, wp)
            over_odd(j) = 1.0_wp/real(4*j + 3, wp)
        end do
        associate (t => moments%t)
            even(0) = 2.0_wp*(t(0) - t(1))
            do j = 1, last + 1
                even(j) = 2.0_wp*(t(2*j - 1) - t(2*j + 1))/real(4*j + 1, wp)
            end do
            do j = 0, last
                odd(j) = (2.0_wp*(t(2*j + 2) - t(2*j)) - (even(j + 1) - even(j)))*over_odd(j)
            end do
        end associate
        even(0) = even(0) + 4.0_wp*moments%shift
        do j = 0, ubound(s, 1)
            s(j) = sqrt(moments%a/pi)*sqrt(real(4*j + 1, wp)*0.5_wp)
        end do
        do c = 0, ubound(h, 2)
            h(c:, c) = s(c)*s(c:)*even(c:ubound(h, 1))
            if (between_odd) then
                do j = c, ubound(h, 1)
                    h(j, c) = 0.5_wp*moments%a/pi*sqrt(real(4*c + 3, wp)*real(4*j + 3, wp))*odd(j)
                end do
            end if
            last = last - 1
            do j = c + 1, last + 1
                even(j) = even(j) + (real(4*c + 3, wp)*over_even(j))*(odd(j - 1) - odd(j))
            end do
            do j = c + 1, last
                odd(j) = odd(j) + (real(4*c + 5, wp)*over_odd(j))*(even(j) - even(j + 1))
            end do
        end do
    end subroutine fill_matrix

    !> r'_j: values at the edge of the contact are sum r'_j c_j for a solution c of (1 + H) c = (sqrt(2), 0, ...), and
    !> sum r'_j c_j - (K c)(a) for others: row 0 of 1 + H over sqrt(2) less the edge row of K. The difference 1 - (K c)(a), which
    !> cancels on a stiff film, is never formed, and X(0) drops out.
    pure subroutine edge_row(moments, first_column, row)
        type(moments_t), intent(in) :: moments
        !> H_j0, j >= 0
        real(wp), intent(in) :: first_column(0:)
        real(wp), intent(out) :: row(0:)

        call edge_kernel(moments, row)
        row = sqrt(0.5_wp)*first_column - row
        row(0) = sqrt(0.5_wp)*(moments%diagonal - (moments%a/pi)*(moments%t(1) + moments%spike))
    end subroutine edge_row

    !> K p_j at the edge of the contact, without `shift`.
    pure subroutine edge_kernel(moments, values)
        type(moments_t), intent(in) :: moments
        real(wp), intent(out) :: values(0:)
        integer :: j

        do j = 0, size(values) - 1
            values(j) = (moments%a/pi)*sqrt(real(4*j + 1, wp)*0.5_wp)*(moments%t(2*j) + moments%spike)
        end do
    end subroutine edge_kernel

    !> The slope of K p_j at the edge of the contact [1/unit].
    pure subroutine edge_slopes(moments, slopes)
        type(moments_t), intent(in) :: moments
        real(wp), intent(out) :: slopes(0:)
        real(wp) :: total
        integer :: j

        total = moments%drop
        do j = 0, size(slopes) - 1
            slopes(j) = sqrt(real(4*j + 1, wp)*0.5_wp)*total/pi
            total = total - real(4*j + 3, wp)*(moments%t(2*j + 1) - moments%spike)
        end do
    end subroutine edge_slopes

end module mdrcontact_line_legendre
