! SPDX-License-Identifier: GPL-3.0-or-later
!> One function of one variable that costs much, with its slope and its integral, sampled from values to their rounding.
!>
!> Users: profile_sampled (shapes of indenters), numerics_radius_law (laws of the contact radius), body_graded (constants of a
!> gradient), medium_power_graded (transforms of shapes), adhesion_steady_crack (speeds of a crack).
module mdrcontact_numerics_sampled_function
    use, intrinsic :: iso_fortran_env, only: int64
    use mdrcontact_error, only: check_memory, error_t
    use mdrcontact_kinds, only: pi, wp
    use mdrcontact_numerics_chebyshev, only: chebyshev_sum, chebyshev_sums, differentiate
    use mdrcontact_numerics_sampler, only: column_source_t, panels_t, part, sample_panels, sampling_t, smallest_root
    use mdrcontact_numerics_scalar_function, only: scalar_function_t
    use mdrcontact_numerics_search, only: interval_of
    use mdrcontact_object, only: real_bytes
    implicit none (type, external)
    private
    public :: new_sampled_function, sampled_function_t

    !> Terms of a panel.
    integer, parameter :: nodes = 20
    !> Where the series are compared with f: in two gaps between the nodes, or in all of them and beyond the outermost ones.
    real(wp), parameter :: in_some(2) = [cos(0.35_wp*pi), cos(0.6_wp*pi)]
    integer, parameter :: gaps(nodes + 1) = [0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18, 19, 20]
    real(wp), parameter :: in_all(nodes + 1) = (1.0_wp - 1.0e-6_wp)*cos(pi*real(gaps, wp)/nodes)

    !> One function as a column.
    type, extends(column_source_t) :: function_source_t
        class(scalar_function_t), pointer :: f => null()
    contains
        procedure :: sample => sample_function
        procedure :: radius => argument_of_function
        procedure :: allowed => allowed_of_function
    end type function_source_t

    !> Series of one function.
    type, extends(panels_t) :: sampled_function_t
        private
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
        class(scalar_function_t), intent(inout), target :: f
        !> ascending; panels never cross one, so put them where f is not analytic
        real(wp), intent(in) :: edges(:)
        !> (size(edges) - 1) whether f has a square-root branch at the panel's left edge; of size 0: it has none
        logical, intent(in) :: from_root(:)
        real(wp), intent(in) :: tolerance
        type(error_t), allocatable, intent(out) :: error
        !> absolute accuracy of the values of f, beyond which no panel is refined; default 0
        real(wp), intent(in), optional :: noise
        !> number of panels, beyond which f is not smooth enough; default 20000
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
        type(function_source_t) :: source
        type(sampling_t) :: sampling
        real(wp), allocatable :: kept(:, :, :), unused(:), places(:)
        logical :: roots(size(edges) - 1)
        integer :: i, count, stat

        sampling = sampling_t(tolerance, shortest_length=0.0_wp, shortest_part=1.0e-10_wp, most_panels=20000, last_terms=3, &
                              margin=10.0_wp, largest_miss=huge(1.0_wp))
        if (present(noise)) sampling%noise = noise
        if (present(most)) sampling%most_panels = most
        if (present(roughness)) sampling%roughness = roughness
        if (present(least_size)) sampling%least_size = least_size
        if (present(steps)) sampling%steps = steps
        places = in_some
        if (present(everywhere)) then
            if (everywhere) places = in_all
        end if
        source%columns = 1
        source%counted = 1
        source%terms = nodes
        source%what = "the function"
        source%argument = "x"
        source%f => f
        roots = .false.
        if (size(from_root) > 0) roots = from_root
        call sample_panels(self, source, edges, roots, sampling, places, kept, unused, error)
        if (allocated(error)) return
        count = size(self%from_root)
        allocate (self%coefficients(nodes, count), self%derivatives(nodes, count), self%used(count), self%integrals(count + 1), &
                  stat=stat)
        call check_memory(error, stat)
        if (allocated(error)) return
        self%integrals(1) = 0.0_wp
        do i = 1, count
            self%coefficients(:, i) = kept(1, :, i)
            self%used(i) = leading(self%coefficients(:, i), self%edges(i), self%edges(i + 1))
            ! those left out as rounding would come back in the lowest coefficients of the derivative, as a slope of what is level
            self%derivatives(:, i) = 0.0_wp
            if (self%used(i) > 1) call differentiate(self%coefficients(:self%used(i), i), self%derivatives(:self%used(i), i))
            self%integrals(i + 1) = self%integrals(i) + partial_integral(self, i, 1.0_wp)
        end do
    end subroutine new_sampled_function

    !> Limit of the last terms of one function.
    pure function allowed_of_function(self, sampling, panel, left, right, tail, before) result(allowed)
        class(function_source_t), intent(in) :: self
        type(sampling_t), intent(in) :: sampling
        real(wp), intent(in) :: panel(:, :)
        real(wp), intent(in) :: left, right, tail, before
        real(wp) :: allowed
        real(wp) :: size_of_f, x

        associate (unused => self)
        end associate
        size_of_f = maxval(abs(panel(1, :)))
        x = max(abs(left), abs(right), sampling%least_size)
        ! No polynomial can be closer than the rounding of x allows, which moves x by this much of a narrow panel.
        allowed = sampling%tolerance*size_of_f + epsilon(x)*x/(right - left)*maxval(abs(panel(1, 2:)))
        allowed = max(allowed, sampling%noise)
        if (tail > 0.1_wp*maxval(abs(panel(1, nodes/2:nodes - 3)))) allowed = max(allowed, sampling%roughness*size_of_f)
        if (tail > 0.5_wp*before) allowed = max(allowed, sampling%steps*size_of_f)
    end function allowed_of_function

    subroutine sample_function(self, x, values, error, slopes)
        class(function_source_t), intent(inout) :: self
        real(wp), intent(in) :: x
        real(wp), intent(out) :: values(:)
        type(error_t), allocatable, intent(inout) :: error
        real(wp), intent(out), optional :: slopes(:)

        if (present(slopes)) slopes = 0.0_wp
        values(1) = self%f%value(x)
        if (allocated(self%f%error)) error = self%f%error
    end subroutine sample_function

    pure function argument_of_function(self, x) result(radius)
        class(function_source_t), intent(in) :: self
        real(wp), intent(in) :: x
        real(wp) :: radius

        associate (unused => self)
        end associate
        radius = x
    end function argument_of_function

    !> Number of coefficients that exceed the rounding of values and positions.
    pure function leading(c, left, right) result(count)
        real(wp), intent(in) :: c(nodes), left, right
        integer :: count
        real(wp) :: rounding

        rounding = epsilon(c)*(2.0_wp*maxval(abs(c)) + max(abs(left), abs(right))/(right - left)*maxval(abs(c(2:))))
        do count = nodes, 2, -1
            if (abs(c(count)) > rounding) return
        end do
    end function leading

    !> f(x) for lower() <= x <= upper(); beyond, the outermost panel's polynomial.
    elemental function value(self, x) result(y)
        class(sampled_function_t), intent(in) :: self
        real(wp), intent(in) :: x
        real(wp) :: y
        integer :: panel

        panel = interval_of(self%edges, x)
        y = chebyshev_sum(self%coefficients(:self%used(panel), panel), 2.0_wp*part(self, panel, x) - 1.0_wp)
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
        real(wp) :: t
        integer :: panel

        panel = interval_of(self%edges, x)
        t = part(self, panel, x)
        if (self%from_root(panel)) t = max(t, smallest_root)
        y = 2.0_wp*chebyshev_sum(self%derivatives(:max(self%used(panel) - 1, 1), panel), 2.0_wp*t - 1.0_wp) &
            /(self%edges(panel + 1) - self%edges(panel))
        if (self%from_root(panel)) y = y/(2.0_wp*t)
    end function slope

    !> The integral of f from lower() to x.
    elemental function integral(self, x) result(y)
        class(sampled_function_t), intent(in) :: self
        real(wp), intent(in) :: x
        real(wp) :: y
        integer :: i

        i = interval_of(self%edges, x)
        y = self%integrals(i) + partial_integral(self, i, part(self, i, x))
    end function integral

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

    !> Size of a copy [byte].
    pure function bytes(self)
        class(sampled_function_t), intent(in) :: self
        integer(int64) :: bytes

        bytes = real_bytes*(2*size(self%coefficients) + 4*size(self%edges))
    end function bytes

end module mdrcontact_numerics_sampled_function
