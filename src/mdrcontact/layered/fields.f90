! SPDX-License-Identifier: GPL-3.0-or-later
!> Line load, pressure and surface displacement from a solution of the springs' equation.
!>
!> q = E0* (d - g + s) with s = d (q_1 - 1) - v smooth: the part d - g belongs to a half-space of the surface material and is
!> left to it; this module adds
!> what s does. s is kept as Legendre series on the panels, on the first one in x^2 since it is even.
module mdrcontact_layered_fields
    use mdrcontact_kinds, only: pi, wp
    use mdrcontact_layered_grid, only: longest_panel
    use mdrcontact_layered_indenter, only: add_fine_interaction, load_t
    use mdrcontact_layered_kernel, only: kernel_t
    use mdrcontact_layered_matrix, only: interaction_row
    use mdrcontact_layered_rule, only: legendre, rule_t
    use mdrcontact_layered_solve, only: solution_t
    implicit none (type, external)
    private
    public :: smooth_load_t, new_smooth_load, smooth_value, smooth_pressure, displacement_beyond

    !> s(x) on [0, a]: coefficients (degree, panel).
    type :: smooth_load_t
        real(wp), allocatable :: edges(:), coefficients(:, :)
    end type smooth_load_t

contains

    !> s = d (q_1 - 1) - v.
    function new_smooth_load(solution, rule, depth) result(self)
        type(solution_t), intent(in) :: solution
        !> the rule of the solution's grid
        type(rule_t), intent(in) :: rule
        !> d [length]
        real(wp), intent(in) :: depth
        type(smooth_load_t) :: self
        real(wp) :: s(rule%n)
        integer :: i, first, last

        allocate (self%edges, source=solution%grid%edges)
        allocate (self%coefficients(rule%n, size(self%edges) - 1))
        do i = 1, size(self%edges) - 1
            first = (i - 1)*rule%n + 1
            last = i*rule%n
            s = depth*(solution%punch(first:last) - 1.0_wp) - solution%v(first:last)
            if (i == 1) s = at_squares(rule, s)
            self%coefficients(:, i) = matmul(rule%to_legendre, s)
        end do
    end function new_smooth_load

    !> Values at positions t with t^2 at the rule's nodes, from values at positions t at the nodes: interpolation in t^2.
    pure function at_squares(rule, values) result(other)
        type(rule_t), intent(in) :: rule
        real(wp), intent(in) :: values(:)
        real(wp) :: other(size(values))
        real(wp) :: weight(rule%n), term, above, below
        integer :: i, j

        do i = 1, rule%n
            weight(i) = 1.0_wp
            do j = 1, rule%n
                if (j /= i) weight(i) = weight(i)/(2.0_wp*(rule%nodes(i) - rule%nodes(j))*(rule%nodes(i) + rule%nodes(j)))
            end do
        end do
        do i = 1, rule%n
            above = 0.0_wp
            below = 0.0_wp
            do j = 1, rule%n
                if (abs(rule%nodes(i) - rule%nodes(j)**2) < tiny(1.0_wp)) exit
                term = weight(j)/(rule%nodes(i) - rule%nodes(j)**2)
                above = above + term*values(j)
                below = below + term
            end do
            if (j <= rule%n) then
                other(i) = values(j)
            else
                other(i) = above/below
            end if
        end do
    end function at_squares

    !> s(x) and s'(x)/x.
    pure subroutine smooth_value(self, x, value, slope_over_x)
        type(smooth_load_t), intent(in) :: self
        real(wp), intent(in) :: x
        real(wp), intent(out) :: value, slope_over_x
        integer :: panel
        real(wp) :: length, slope

        panel = min(max(count(self%edges <= x), 1), size(self%edges) - 1)
        length = self%edges(panel + 1) - self%edges(panel)
        if (panel == 1) then
            call legendre_sum(self%coefficients(:, 1), (x/length)**2, value, slope)
            slope_over_x = 2.0_wp*slope/length**2
        else
            call legendre_sum(self%coefficients(:, panel), (x - self%edges(panel))/length, value, slope)
            slope_over_x = slope/(length*x)
        end if
    end subroutine smooth_value

    !> sum of c_n P_n(2 t - 1) and its derivative with respect to t.
    pure subroutine legendre_sum(coefficients, t, value, slope)
        real(wp), intent(in) :: coefficients(:), t
        real(wp), intent(out) :: value, slope
        real(wp) :: p(size(coefficients), 1), u, slope_before, slope_here
        integer :: i

        call legendre([t], p)
        u = 2.0_wp*t - 1.0_wp
        value = sum(coefficients*p(:, 1))
        ! P'_(n+1) = P'_(n-1) + (2 n + 1) P_n
        slope = 0.0_wp
        slope_before = 0.0_wp
        slope_here = 0.0_wp
        do i = 2, size(coefficients)
            u = slope_before + real(2*i - 3, wp)*p(i - 1, 1)
            slope = slope + coefficients(i)*u
            slope_before = slope_here
            slope_here = u
        end do
        slope = 2.0_wp*slope
    end subroutine legendre_sum

    !> -(1/pi) int_r^a s'(x)/sqrt(x^2 - r^2) dx at r [unit], equation (6), without E0*; x^2 = r^2 + t^2.
    function smooth_pressure(self, rule, r) result(pressure)
        type(smooth_load_t), intent(in) :: self
        !> any rule of high order
        type(rule_t), intent(in) :: rule
        real(wp), intent(in) :: r
        real(wp) :: pressure
        real(wp) :: low, high, t, value, slope
        integer :: panel, i

        pressure = 0.0_wp
        do panel = 1, size(self%edges) - 1
            if (self%edges(panel + 1) <= r) cycle
            low = max(self%edges(panel), r)
            low = sqrt((low - r)*(low + r))
            high = sqrt((self%edges(panel + 1) - r)*(self%edges(panel + 1) + r))
            do i = 1, rule%n
                t = low + (high - low)*rule%nodes(i)
                call smooth_value(self, min(max(sqrt(r**2 + t**2), self%edges(panel)), self%edges(panel + 1)), value, slope)
                pressure = pressure - (high - low)*rule%weights(i)*slope
            end do
        end do
        pressure = pressure/pi
    end function smooth_pressure

    !> (2/pi) int_a^r w(x)/sqrt(r^2 - x^2) dx [length], with w(x) = (1/pi) int_0^a [X(x-s) + X(x+s)] q(s)/E0* ds the springs'
    !> displacement beyond the contact.
    function displacement_beyond(kernel, rule, solution, grid_rule, load, depth, r) result(u)
        type(kernel_t), intent(in) :: kernel
        !> any rule of high order
        type(rule_t), intent(in) :: rule
        type(solution_t), intent(in) :: solution
        !> the rule of the solution's grid
        type(rule_t), intent(in) :: grid_rule
        type(load_t), intent(in) :: load
        !> d [length] and r > a [unit]
        real(wp), intent(in) :: depth, r
        real(wp) :: u
        real(wp) :: here, length, x, part
        integer :: i
        logical :: last

        u = 0.0_wp
        here = solution%a
        last = .false.
        do while (.not. last)
            length = longest_panel + (here - solution%a)
            last = here + 2.0_wp*length >= r
            if (last) length = r - here
            part = 0.0_wp
            do i = 1, rule%n
                if (last) then
                    x = r - length*rule%nodes(i)**2
                    part = part + 2.0_wp*rule%weights(i)*sqrt(length/(r + x)) &
                           *spring_displacement(kernel, solution, grid_rule, load, depth, x)
                else
                    x = here + length*rule%nodes(i)
                    part = part + length*rule%weights(i)/sqrt((r - x)*(r + x)) &
                           *spring_displacement(kernel, solution, grid_rule, load, depth, x)
                end if
            end do
            u = u + part
            here = here + length
        end do
        u = (2.0_wp/pi)*u
    end function displacement_beyond

    function spring_displacement(kernel, solution, grid_rule, load, depth, x) result(w)
        type(kernel_t), intent(in) :: kernel
        type(solution_t), intent(in) :: solution
        !> the rule of the solution's grid
        type(rule_t), intent(in) :: grid_rule
        type(load_t), intent(in) :: load
        real(wp), intent(in) :: depth, x
        real(wp) :: w
        real(wp) :: row(size(solution%grid%x)), fine

        call interaction_row(kernel, solution%grid, grid_rule, x, row)
        fine = 0.0_wp
        call add_fine_interaction(kernel, load, x, fine)
        w = sum(row*(depth*solution%punch - solution%v - load%values)) - fine
    end function spring_displacement

end module mdrcontact_layered_fields
