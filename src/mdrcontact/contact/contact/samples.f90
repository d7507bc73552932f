! SPDX-License-Identifier: GPL-3.0-or-later
!> The equilibria of a contact sampled along their curve, for any range of adhesion: evaluated, inverted, searched for extrema and
!> integrated for the price of short polynomials, by branches, loops, laws and fits.
module mdrcontact_contact_samples
    use mdrcontact_contact_control, only: control_t, depth_control
    use mdrcontact_contact_equilibrium, only: equilibrium_t
    use mdrcontact_contact_state, only: contact_state_t
    use mdrcontact_error, only: error_t
    use mdrcontact_kinds, only: half_pi, wp
    use mdrcontact_numerics_quadrature, only: gauss_legendre
    use mdrcontact_numerics_roots, only: find_root
    use mdrcontact_numerics_sampled_columns, only: columns_t, series
    use mdrcontact_numerics_sampler, only: lanes
    use mdrcontact_numerics_scalar_function, only: scalar_function_t
    use mdrcontact_numerics_search, only: interval_of
    implicit none (type, external)
    private
    public :: curve_point_t, samples_t, rows

    !> Columns that depth, force and stiffness follow from: one group.
    integer, parameter :: rows = lanes
    !> Nodes in a panel of the integral of work.
    integer, parameter :: work_nodes = 20
    !> Where s is considered for extrema in each panel, denser towards its ends: extrema lie close to touch where the range is long.
    integer, parameter :: probes = 48
    integer, parameter :: most_steps = 100
    !> A step of Newton's method that is so short leaves less than rounding.
    real(wp), parameter :: last_step = 1.0e-8_wp
    !> Neighbouring panels differ by their tolerance where they meet: a root may lie a little beyond the end of one.
    real(wp), parameter :: overlap = 1.0e-6_wp

    !> One equilibrium, at coordinate x.
    type :: curve_point_t
        real(wp) :: x = 0.0_wp, radius = 0.0_wp, depth = 0.0_wp, force = 0.0_wp, stiffness = 0.0_wp
    end type curve_point_t

    !> Samples on panels of a coordinate x along the curve.
    type, abstract, extends(columns_t) :: samples_t
        !> whether depth and force follow powers of the radius where the curve begins
        logical :: follows_powers = .false.
        !> d and F at the edges
        real(wp), allocatable, private :: depths(:), forces(:)
        !> nodes and weights on [0, 1] for the work
        real(wp), private :: work_rule(work_nodes, 2) = 0.0_wp
    contains
        procedure(point_in), deferred :: point_of
        procedure(control_in), deferred :: control_of
        procedure(state_of), deferred :: state_at
        procedure :: prepare
        procedure :: keep_ends
        procedure :: at
        procedure :: control_at
        procedure :: slope
        procedure :: find
        procedure :: turns
        procedure :: turn
        procedure :: extrema
        procedure :: work_between
    end type samples_t

    abstract interface
        !> The equilibrium at coordinate x, where the columns have these values.
        pure function point_in(self, x, v) result(point)
            import :: curve_point_t, rows, samples_t, wp
            class(samples_t), intent(in) :: self
            real(wp), intent(in) :: x, v(rows)
            type(curve_point_t) :: point
        end function point_in

        !> s and its slope, where the columns have these values and slopes.
        pure subroutine control_in(self, control, v, dv, s, ds)
            import :: control_t, rows, samples_t, wp
            class(samples_t), intent(in) :: self
            type(control_t), intent(in) :: control
            real(wp), intent(in) :: v(rows), dv(rows)
            real(wp), intent(out) :: s, ds
        end subroutine control_in

        !> The state of the contact itself at coordinate x.
        subroutine state_of(self, equilibrium, x, state, error)
            import :: contact_state_t, equilibrium_t, error_t, samples_t, wp
            class(samples_t), intent(in) :: self
            type(equilibrium_t), intent(in) :: equilibrium
            real(wp), intent(in) :: x
            type(contact_state_t), intent(out) :: state
            type(error_t), allocatable, intent(out) :: error
        end subroutine state_of
    end interface

    !> ds/dx as a function of x.
    type, extends(scalar_function_t) :: slope_t
        class(samples_t), pointer :: samples => null()
        type(control_t) :: control
    contains
        procedure :: value => slope_at
    end type slope_t

contains

    !> Quantities derived from the series: ends of panels, and the rule of work.
    subroutine prepare(self, error)
        class(samples_t), intent(inout) :: self
        type(error_t), allocatable, intent(inout) :: error

        call gauss_legendre(self%work_rule(:, 1), self%work_rule(:, 2), error)
        if (.not. allocated(error)) call self%keep_ends()
    end subroutine prepare

    !> d and F at the edges of panels.
    pure subroutine keep_ends(self)
        class(samples_t), intent(inout) :: self
        type(curve_point_t) :: point
        real(wp) :: v(rows), dv(rows)
        integer :: i, panel

        self%depths = 0.0_wp*self%edges
        self%forces = self%depths
        do i = 1, size(self%edges)
            panel = min(i, size(self%from_root))
            call self%in_panel(panel, merge(-1.0_wp, 1.0_wp, panel == i), v, dv)
            point = self%point_of(self%edges(i), v)
            self%depths(i) = point%depth
            self%forces(i) = point%force
        end do
    end subroutine keep_ends

    !> The equilibrium at coordinate x.
    pure function at(self, x) result(point)
        class(samples_t), intent(in) :: self
        real(wp), intent(in) :: x
        type(curve_point_t) :: point
        real(wp) :: v(rows), dv(rows)

        call self%values_at(x, v, dv)
        point = self%point_of(x, v)
    end function at

    !> s and ds/dx at coordinate x.
    pure subroutine control_at(self, control, x, s, slope)
        class(samples_t), intent(in) :: self
        type(control_t), intent(in) :: control
        real(wp), intent(in) :: x
        real(wp), intent(out) :: s, slope
        real(wp) :: v(rows), dv(rows)

        call self%values_at(x, v, dv)
        call self%control_of(control, v, dv, s, slope)
    end subroutine control_at

    !> ds/dx at coordinate x; at a break that of the panel before it: of a root's it has no digits.
    pure function slope(self, control, x) result(rate)
        class(samples_t), intent(in) :: self
        type(control_t), intent(in) :: control
        real(wp), intent(in) :: x
        real(wp) :: rate
        real(wp) :: v(rows), dv(rows), s, z
        integer :: panel

        panel = interval_of(self%edges, x)
        if (panel > 1 .and. .not. x > self%edges(panel)) panel = panel - 1
        z = self%local(panel, x)
        call self%in_panel(panel, z, v, dv)
        call self%control_of(control, v, dv, s, rate)
        rate = rate*self%rate(panel, z)
    end function slope

    !> The equilibrium between two coordinates at which s, which grows from the first to the last, lies u from an end value:
    !> Newton's method on the root of the distance, in which folds and breaks are smooth, held in a bracket.
    pure function find(self, control, origin, side, root, u, first, last) result(point)
        class(samples_t), intent(in) :: self
        type(control_t), intent(in) :: control
        !> s at `first` (side = 1) or at `last` (side = -1), and whether it is an extremum or a break; without, s follows a power of
        !> the radius from origin = 0 on where the curve does, and the logarithm takes the place of the root
        real(wp), intent(in) :: origin, side
        logical, intent(in) :: root
        !> side*(s - origin) >= 0
        real(wp), intent(in) :: u
        real(wp), intent(in) :: first, last
        type(curve_point_t) :: point
        real(wp) :: v(rows), dv(rows), s, y, dy, z, low, high, step, wanted, ends(2)
        integer :: panel, i
        logical :: by_root

        if (u <= 0.0_wp) then
            point = self%at(merge(first, last, side > 0.0_wp))
            return
        end if
        by_root = root .or. .not. self%follows_powers
        panel = panel_with(self, control, origin, side, u, first, last)
        low = -1.0_wp - overlap
        high = 1.0_wp + overlap
        if (first > self%edges(panel)) low = self%local(panel, first)
        if (last < self%edges(panel + 1)) high = self%local(panel, last)
        wanted = merge(sqrt(u), log(u), by_root)
        ! the panel's ends give the first guess: root or logarithm are close to a straight line
        ends = side*(control%of(self%depths(panel:panel + 1), self%forces(panel:panel + 1)) - origin)
        z = 0.5_wp*(low + high)
        if (all(ends > 0.0_wp)) then
            ends = merge(sqrt(ends), log(ends), by_root)
            z = min(max(2.0_wp*(wanted - ends(1))/(ends(2) - ends(1)) - 1.0_wp, low), high)
        end if
        do i = 1, most_steps
            call series(self%coefficients(:, :, 1, panel), z, v, dv)
            call self%control_of(control, v, dv, s, dy)
            s = max(side*(s - origin), 0.0_wp)
            y = merge(sqrt(s), log(max(s, tiny(s))), by_root) - wanted
            if (s > 0.0_wp) then
                dy = side*dy/merge(2.0_wp*sqrt(s), s, by_root)
            else
                dy = 0.0_wp
            end if
            if (y < 0.0_wp .eqv. side > 0.0_wp) then
                low = z
            else
                high = z
            end if
            step = 0.5_wp*(low + high) - z
            if (abs(y) < 4.0_wp*abs(dy)) then
                if (abs(y) <= last_step*abs(dy) .or. (z - y/dy > low .and. z - y/dy < high)) step = -y/dy
            end if
            z = z + step
            if (abs(step) <= last_step) exit
        end do
        point = self%point_of(min(max(self%place(panel, z), first), last), v + dv*step)
    end function find

    !> The panel between two coordinates in which s lies u from an end value.
    pure function panel_with(self, control, origin, side, u, first, last) result(panel)
        class(samples_t), intent(in) :: self
        type(control_t), intent(in) :: control
        real(wp), intent(in) :: origin, side, u, first, last
        integer :: panel
        integer :: last_panel, middle

        panel = interval_of(self%edges, first)
        last_panel = interval_of(self%edges, last)
        if (last_panel > panel .and. last <= self%edges(last_panel)) last_panel = last_panel - 1
        do while (last_panel > panel)
            middle = (panel + last_panel + 1)/2
            if (side*(control%of(self%depths(middle), self%forces(middle)) - origin) < u .eqv. side > 0.0_wp) then
                panel = middle
            else
                last_panel = middle - 1
            end if
        end do
    end function panel_with

    !> Coordinates between which s has one extremum each, (2, extrema), ascending.
    pure function turns(self, control) result(brackets)
        class(samples_t), intent(in) :: self
        type(control_t), intent(in) :: control
        real(wp), allocatable :: brackets(:, :)
        real(wp), allocatable :: ends(:)
        real(wp) :: x, x_before, rate, rate_before
        integer :: panel, probe

        allocate (ends(0))
        x_before = self%edges(1)
        rate_before = 0.0_wp
        do panel = 1, size(self%from_root)
            do probe = 1, probes
                x = self%edges(panel) + (self%edges(panel + 1) - self%edges(panel))*sin(half_pi*(probe - 0.5_wp)/probes)**2
                rate = self%slope(control, x)
                if ((rate < 0.0_wp .and. rate_before > 0.0_wp) .or. (rate > 0.0_wp .and. rate_before < 0.0_wp)) then
                    ends = [ends, x_before, x]
                end if
                x_before = x
                rate_before = rate
            end do
        end do
        brackets = reshape(ends, [2, size(ends)/2])
    end function turns

    !> The coordinate of the extremum of s between two coordinates where its slopes have opposite signs.
    subroutine turn(self, control, lower, upper, x, error)
        class(samples_t), intent(in), target :: self
        type(control_t), intent(in) :: control
        real(wp), intent(in) :: lower, upper
        real(wp), intent(out) :: x
        type(error_t), allocatable, intent(out) :: error
        type(slope_t) :: f

        f%samples => self
        f%control = control
        call find_root(f, lower, upper, x, error)
    end subroutine turn

    !> The coordinates of the ends of the curve and of all extrema of s between them, ascending.
    subroutine extrema(self, control, x, error)
        class(samples_t), intent(in) :: self
        type(control_t), intent(in) :: control
        real(wp), allocatable, intent(out) :: x(:)
        type(error_t), allocatable, intent(inout) :: error
        real(wp), allocatable :: brackets(:, :)
        type(error_t), allocatable :: failed
        integer :: i

        allocate (brackets, source=self%turns(control))
        allocate (x(size(brackets, 2) + 2))
        x(1) = self%edges(1)
        x(size(x)) = self%edges(size(self%edges))
        do i = 1, size(brackets, 2)
            call self%turn(control, brackets(1, i), brackets(2, i), x(i + 1), failed)
            if (allocated(failed) .and. .not. allocated(error)) call move_alloc(failed, error)
        end do
    end subroutine extrema

    !> int F dd from one coordinate to another, both clipped to the sampled range.
    pure function work_between(self, from, to) result(work)
        class(samples_t), intent(in) :: self
        real(wp), intent(in) :: from, to
        real(wp) :: work
        type(curve_point_t) :: point
        real(wp) :: low, high, z, v(rows), dv(rows), depth, rate
        integer :: panel, i

        work = 0.0_wp
        do panel = 1, size(self%from_root)
            low = min(max(min(from, to), self%edges(panel)), self%edges(panel + 1))
            high = min(max(max(from, to), self%edges(panel)), self%edges(panel + 1))
            if (.not. high > low) cycle
            low = self%local(panel, low)
            high = self%local(panel, high)
            do i = 1, work_nodes
                z = low + (high - low)*self%work_rule(i, 1)
                call self%in_panel(panel, z, v, dv)
                call self%control_of(depth_control, v, dv, depth, rate)
                point = self%point_of(self%place(panel, z), v)
                work = work + (high - low)*self%work_rule(i, 2)*point%force*rate
            end do
        end do
        if (to < from) work = -work
    end function work_between

    function slope_at(self, x) result(y)
        class(slope_t), intent(inout) :: self
        real(wp), intent(in) :: x
        real(wp) :: y

        y = self%samples%slope(self%control, x)
    end function slope_at

end module mdrcontact_contact_samples
