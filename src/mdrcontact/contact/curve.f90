! SPDX-License-Identifier: GPL-3.0-or-later
!> The equilibria of a contact, sampled once over the contact radius and then evaluated and inverted for the price of a short
!> polynomial: F(d) for the adhesive branch, the law and the fit.
!>
!> The radius is the natural parameter: one solution gives depth, force and stiffness, none of them by iteration. What is
!> interpolated are the logarithms of d0, F0, k and, with adhesion, dl over x = ln(a - end radius), where every shape and medium is
!> close to a straight line (theory 4 and 5): d = d0 - dl, F = F0 - k dl.
module mdrcontact_contact_curve
    use mdrcontact_cancel, only: check_cancelled
    use mdrcontact_contact_control, only: control_t, depth_control
    use mdrcontact_contact_equilibrium, only: equilibrium_t
    use mdrcontact_contact_samples, only: curve_point_t, samples_t
    use mdrcontact_contact_state, only: contact_state_t
    use mdrcontact_error, only: check_memory, error_no_convergence, error_t, raise, to_text
    use mdrcontact_kinds, only: wp
    use mdrcontact_medium_solver, only: solver_t
    use mdrcontact_numerics_chebyshev, only: half, node, nodes => terms, series_of_slopes, series_of_values
    use mdrcontact_numerics_quadrature, only: gauss_legendre
    use mdrcontact_numerics_search, only: interval_of
    implicit none (type, external)
    private
    public :: curve_t, curve_point_t, new_curve

    !> The length in ln a of a panel for which its terms usually suffice.
    real(wp), parameter :: usual_length = 1.6_wp
    !> Halving a panel makes its last terms many times smaller: where more than this part is left, slopes may be less exact than
    !> values.
    real(wp), parameter :: least_gain = 0.1_wp
    !> By how many times that accuracy neighbouring panels may differ.
    real(wp), parameter :: margin = 30.0_wp
    !> A panel is not halved below this length: a kink is then resolved well enough.
    real(wp), parameter :: shortest_length = 1.0e-4_wp
    !> Halving a panel of a smooth quantity below this length makes its last coefficients many times smaller: else they are noise.
    real(wp), parameter :: noisy_length = 0.25_wp
    integer, parameter :: most_panels = 400
    !> Rows of the samples: ln d0, ln F0, ln k, ln dl.
    integer, parameter :: work_nodes = 20
    integer, parameter :: rows = 4, of_depth = 1, of_force = 2, of_stiffness = 3, of_excess = 4

    !> The sampled equilibria.
    type, extends(samples_t) :: curve_t
        !> radius of the indenter's flat end [length]
        real(wp) :: end_radius = 0.0_wp
        logical :: adhesive = .false.
        !> whether panel i begins at a break of the indenter or medium and uses sqrt(x - edges(i))
        logical, allocatable, private :: from_root(:)
        !> (rows, nodes, panels)
        real(wp), allocatable, private :: coefficients(:, :, :)
        !> d and F at the edges
        real(wp), allocatable, private :: depths(:), forces(:)
        !> nodes and weights on [0, 1] for the work
        real(wp), private :: work_rule(work_nodes, 2) = 0.0_wp
    contains
        procedure :: at
        procedure :: parts
        procedure :: slope
        procedure :: find
        procedure :: turns
        procedure :: work_between
        procedure :: state_at
        procedure :: shear
    end type curve_t

    !> Where s is looked at for extrema in each panel.
    integer, parameter :: probes_per_panel = 24
    integer, parameter :: most_steps = 100
    !> A step of Newton's method that is so short leaves less than rounding.
    real(wp), parameter :: last_step = 1.0e-8_wp
    !> Neighbouring panels differ by their tolerance where they meet: a root may lie a little beyond the end of one.
    real(wp), parameter :: overlap = 1.0e-6_wp
    !> The slope in x of a function of t = sqrt(x - left edge) is taken no closer to the edge than this t.
    real(wp), parameter :: smallest_root = 1.0e-5_wp

contains

    !> Samples the states between the first and the last of some coordinates.
    subroutine new_curve(self, equilibrium, coordinates, tolerance, error, largest_noise)
        type(curve_t), intent(out) :: self
        type(equilibrium_t), intent(in) :: equilibrium
        !> ascending; at the inner ones indenter or medium are not analytic
        real(wp), intent(in) :: coordinates(:)
        !> relative, of the interpolated quantities
        real(wp), intent(in) :: tolerance
        type(error_t), allocatable, intent(out) :: error
        !> relative noise of the equilibria up to which a panel is accepted though it misses the tolerance, by a caller that
        !> compares the result with the contact itself; default: the roughness of medium and zeta, 0 where they are computed
        real(wp), intent(in), optional :: largest_noise
        real(wp), allocatable :: waiting(:), before(:), kept(:, :, :)
        real(wp) :: panel(rows, nodes), left, right, tail, attainable, noise, edges(most_panels + 1), reached(most_panels)
        logical :: root, has_slopes, by_slopes, tested, roots(most_panels)
        integer :: count, i, stat

        self%end_radius = equilibrium%profile%end_radius
        self%adhesive = equilibrium%work_of_adhesion > 0.0_wp
        call gauss_legendre(self%work_rule(:, 1), self%work_rule(:, 2), error)
        if (allocated(error)) return
        noise = equilibrium%roughness
        if (present(largest_noise)) noise = largest_noise
        ! one more than can be sampled is enough to be refused
        allocate (waiting, source=first_edges(coordinates(:min(size(coordinates), most_panels + 2))))
        allocate (before(size(waiting)), source=huge(1.0_wp))
        allocate (kept(rows, nodes, most_panels), stat=stat)
        call check_memory(error, stat)
        if (allocated(error)) return
        ! where states are solved for, slopes come with them
        has_slopes = .not. (self%adhesive .or. equilibrium%medium%is_modulus_formula)
        by_slopes = has_slopes
        tested = .false.
        count = 0
        edges(1) = coordinates(1)
        do while (size(waiting) > 0)
            if (count + size(waiting) > most_panels) then
                call raise(error, error_no_convergence, "the contact is not smooth or not accurate enough near radius = "// &
                           to_text(equilibrium%radius_of(edges(count + 1)))//" to be sampled")
                return
            end if
            left = edges(count + 1)
            right = waiting(1)
            root = any(coordinates(2:) == left)
            call check_cancelled(error)
            if (allocated(error)) return
            call sample_panel(self, equilibrium, left, right, root, by_slopes, has_slopes, panel, error)
            if (allocated(error)) return
            if (by_slopes .and. .not. has_slopes) then
                by_slopes = .false.
                cycle
            end if
            ! Close to a flat end a - b, and all that depends on it, has lost digits.
            attainable = max(tolerance, 16.0_wp*epsilon(1.0_wp)*self%end_radius*exp(-left))
            tail = maxval(abs(panel(:, nodes - 1:)))
            ! What halving does not make smaller is noise of the equilibria.
            if (right - left < noisy_length .and. tail > 0.5_wp*before(1)) attainable = max(attainable, noise)
            if (by_slopes .and. tail > attainable .and. (.not. tested .or. tail > least_gain*before(1))) then
                ! if values alone make the panel, slopes are left for good
                by_slopes = .false.
                tested = .true.
                cycle
            end if
            if (tail > attainable .and. right - left > shortest_length) then
                by_slopes = has_slopes
                waiting = [0.5_wp*(left + right), waiting]
                before = [tail, tail, before(2:)]
                cycle
            end if
            waiting = waiting(2:)
            before = before(2:)
            count = count + 1
            edges(count + 1) = right
            roots(count) = root
            kept(:, :, count) = panel
            reached(count) = max(tail, attainable)
        end do
        self%edges = edges(:count + 1)
        self%from_root = roots(:count)
        allocate (self%coefficients(rows, nodes, count), self%depths(count + 1), self%forces(count + 1), stat=stat)
        call check_memory(error, stat)
        if (allocated(error)) return
        self%coefficients(:, :, :) = kept(:, :, :count)
        do i = 1, count + 1
            call edge_values(self, i, self%depths(i), self%forces(i))
        end do
        call compare_neighbours(self, equilibrium, reached(:count), error)
    end subroutine new_curve

    !> Two panels must agree on d0, F0 and k where they meet, which is a node of neither. The slope of k, on which dl depends, may
    !> jump there.
    subroutine compare_neighbours(self, equilibrium, reached, error)
        type(curve_t), intent(in) :: self
        type(equilibrium_t), intent(in) :: equilibrium
        !> relative accuracy of each panel by its last terms
        real(wp), intent(in) :: reached(:)
        type(error_t), allocatable, intent(inout) :: error
        real(wp) :: before(rows), next(rows), unused(rows), missed
        integer :: i

        do i = 1, size(reached) - 1
            call series(self%coefficients(:, :, i), 1.0_wp, before, unused)
            call series(self%coefficients(:, :, i + 1), -1.0_wp, next, unused)
            missed = maxval(abs(before(:of_stiffness) - next(:of_stiffness)))
            if (missed <= margin*maxval(reached(i:i + 1))) cycle
            call raise(error, error_no_convergence, "samples of the contact differ by "//to_text(missed)//" from one another "// &
                       "near radius = "//to_text(equilibrium%radius_of(self%edges(i + 1))))
            return
        end do
    end subroutine compare_neighbours

    !> Right edges of panels of at most the usual length between the breaks.
    pure function first_edges(breaks) result(edges)
        real(wp), intent(in) :: breaks(:)
        real(wp), allocatable :: edges(:)
        integer :: i, j, count

        allocate (edges(0))
        do i = 1, size(breaks) - 1
            count = max(1, ceiling((breaks(i + 1) - breaks(i))/usual_length))
            edges = [edges, (breaks(i) + (breaks(i + 1) - breaks(i))*(real(j, wp)/count), j=1, count - 1), breaks(i + 1)]
        end do
    end function first_edges

    !> The series of a panel, from values and slopes where the slopes are known.
    subroutine sample_panel(self, equilibrium, left, right, root, by_slopes, has_slopes, coefficients, error)
        type(curve_t), intent(inout) :: self
        type(equilibrium_t), intent(in) :: equilibrium
        real(wp), intent(in) :: left, right
        logical, intent(in) :: root, by_slopes
        !> whether slopes are known; where they are needed and are not, there is no series
        logical, intent(inout) :: has_slopes
        real(wp), intent(out) :: coefficients(rows, nodes)
        type(error_t), allocatable, intent(out) :: error
        type(contact_state_t) :: state
        real(wp) :: values(rows, nodes), slopes(rows, nodes), t, rate
        integer :: i, count

        coefficients = 0.0_wp
        values = 0.0_wp
        slopes = 0.0_wp
        count = merge(half, nodes, by_slopes)
        do i = 1, count
            t = 0.5_wp*(1.0_wp + node(i, count))
            rate = 0.5_wp*(right - left)
            if (root) then
                rate = 2.0_wp*t*rate
                t = t**2
            end if
            call equilibrium%parts(equilibrium%radius_of(left + (right - left)*t), state, error, slopes(:of_stiffness, i))
            if (allocated(error)) return
            self%solutions = self%solutions + 1
            if (by_slopes .and. .not. slopes(of_depth, i) > 0.0_wp) then
                has_slopes = .false.
                return
            end if
            values(:, i) = [state%depth, state%force, state%stiffness, merge(-state%punch_depth, 1.0_wp, self%adhesive)]
            if (.not. (minval(values(:, i)) >= 0.0_wp .and. maxval(values(:, i)) <= huge(1.0_wp))) then
                call raise(error, error_no_convergence, "the depth or the force of this medium is not a positive "// &
                           "number near a = "//to_text(state%radius))
                return
            end if
            values(:, i) = log(max(values(:, i), tiny(1.0_wp)))
            slopes(:, i) = rate*slopes(:, i)
        end do
        if (by_slopes) then
            coefficients = series_of_slopes(values(:, :half), slopes(:, :half))
        else
            coefficients = series_of_values(values)
        end if
    end subroutine sample_panel

    pure subroutine edge_values(self, i, depth, force)
        type(curve_t), intent(in) :: self
        integer, intent(in) :: i
        real(wp), intent(out) :: depth, force
        type(curve_point_t) :: point
        real(wp) :: v(rows), dv(rows)
        integer :: panel

        panel = min(i, size(self%from_root))
        call series(self%coefficients(:, :, panel), merge(-1.0_wp, 1.0_wp, panel == i), v, dv)
        point = point_of(self, panel, -1.0_wp, v)
        depth = point%depth
        force = point%force
    end subroutine edge_values

    !> The rows and their slopes in z by Clenshaw's recurrence.
    pure subroutine series(c, z, v, dv)
        real(wp), intent(in) :: c(rows, nodes), z
        real(wp), intent(out) :: v(rows), dv(rows)
        real(wp) :: b(rows), b1(rows), b2(rows), s(rows), s1(rows), s2(rows)
        integer :: j

        b1 = 0.0_wp
        b2 = 0.0_wp
        s1 = 0.0_wp
        s2 = 0.0_wp
        do j = nodes, 2, -1
            s = 2.0_wp*(z*s1 + b1) - s2
            s2 = s1
            s1 = s
            b = 2.0_wp*z*b1 - b2 + c(:, j)
            b2 = b1
            b1 = b
        end do
        v = z*b1 - b2 + c(:, 1)
        dv = z*s1 - s2 + b1
    end subroutine series

    pure function point_of(self, panel, z, v) result(point)
        type(curve_t), intent(in) :: self
        integer, intent(in) :: panel
        real(wp), intent(in) :: z, v(rows)
        type(curve_point_t) :: point
        real(wp) :: t, e(rows)

        t = 0.5_wp*(1.0_wp + z)
        if (self%from_root(panel)) t = t**2
        e = exp(v)
        if (.not. self%adhesive) e(of_excess) = 0.0_wp
        point%x = self%edges(panel) + (self%edges(panel + 1) - self%edges(panel))*t
        point%radius = self%end_radius + exp(point%x)
        point%depth = e(of_depth) - e(of_excess)
        point%force = e(of_force) - e(of_stiffness)*e(of_excess)
        point%stiffness = e(of_stiffness)
    end function point_of

    !> s and its slope in z.
    pure subroutine control_of(self, control, v, dv, s, ds)
        type(curve_t), intent(in) :: self
        type(control_t), intent(in) :: control
        real(wp), intent(in) :: v(rows), dv(rows)
        real(wp), intent(out) :: s, ds
        real(wp) :: e(rows)

        e = exp(v)
        if (.not. self%adhesive) e(of_excess) = 0.0_wp
        s = control%of(e(of_depth) - e(of_excess), e(of_force) - e(of_stiffness)*e(of_excess))
        ds = control%of(e(of_depth)*dv(of_depth) - e(of_excess)*dv(of_excess), &
                        e(of_force)*dv(of_force) - e(of_stiffness)*e(of_excess)*(dv(of_stiffness) + dv(of_excess)))
    end subroutine control_of

    !> The panel's variable, -1 at its left and 1 at its right edge.
    pure function local(self, panel, x) result(z)
        type(curve_t), intent(in) :: self
        integer, intent(in) :: panel
        real(wp), intent(in) :: x
        real(wp) :: z

        z = (x - self%edges(panel))/(self%edges(panel + 1) - self%edges(panel))
        if (self%from_root(panel)) z = sqrt(max(z, 0.0_wp))
        z = 2.0_wp*z - 1.0_wp
    end function local

    !> The equilibrium at coordinate x.
    pure function at(self, x) result(point)
        class(curve_t), intent(in) :: self
        real(wp), intent(in) :: x
        type(curve_point_t) :: point
        real(wp) :: v(rows), dv(rows)
        integer :: panel

        panel = interval_of(self%edges, x)
        call series(self%coefficients(:, :, panel), local(self, panel, x), v, dv)
        point = point_of(self, panel, local(self, panel, x), v)
    end function at

    !> d0, F0, k and dl at coordinate x, and their slopes in x.
    pure subroutine parts(self, x, values, slopes)
        class(curve_t), intent(in) :: self
        real(wp), intent(in) :: x
        real(wp), intent(out) :: values(rows), slopes(rows)
        real(wp) :: z, v(rows), dv(rows)
        integer :: panel

        panel = interval_of(self%edges, x)
        z = local(self, panel, x)
        call series(self%coefficients(:, :, panel), z, v, dv)
        values = exp(v)
        slopes = 2.0_wp*values*dv/(self%edges(panel + 1) - self%edges(panel))
        if (self%from_root(panel)) slopes = slopes/max(1.0_wp + z, 2.0_wp*smallest_root)
    end subroutine parts

    !> ds/dx at coordinate x; at a break that of the panel before it: of a root's it has no digits.
    pure function slope(self, control, x) result(rate)
        class(curve_t), intent(in) :: self
        type(control_t), intent(in) :: control
        real(wp), intent(in) :: x
        real(wp) :: rate
        integer :: panel

        panel = interval_of(self%edges, x)
        if (panel > 1 .and. .not. x > self%edges(panel)) panel = panel - 1
        rate = slope_in(self, panel, control, x)
    end function slope

    !> ds/dx by the samples of one panel.
    pure function slope_in(self, panel, control, x) result(rate)
        type(curve_t), intent(in) :: self
        integer, intent(in) :: panel
        type(control_t), intent(in) :: control
        real(wp), intent(in) :: x
        real(wp) :: rate
        real(wp) :: v(rows), dv(rows), s, z

        z = local(self, panel, x)
        call series(self%coefficients(:, :, panel), z, v, dv)
        call control_of(self, control, v, dv, s, rate)
        rate = 2.0_wp*rate/(self%edges(panel + 1) - self%edges(panel))
        if (self%from_root(panel)) rate = rate/max(1.0_wp + z, 2.0_wp*smallest_root)
    end function slope_in

    !> The equilibrium between two coordinates at which s, which grows from the first to the last, lies u from an end value:
    !> Newton's method on the root of the distance, in which folds and breaks are smooth, held in a bracket.
    pure function find(self, control, origin, side, root, u, first, last) result(point)
        class(curve_t), intent(in) :: self
        type(control_t), intent(in) :: control
        !> s at `first` (side = 1) or at `last` (side = -1), and whether it is an extremum or a break; without, s follows a power of
        !> the radius from origin = 0 on, and the logarithm takes the place of the root
        real(wp), intent(in) :: origin, side
        logical, intent(in) :: root
        !> side*(s - origin) >= 0
        real(wp), intent(in) :: u
        real(wp), intent(in) :: first, last
        type(curve_point_t) :: point
        real(wp) :: v(rows), dv(rows), s, ds, y, dy, z, low, high, step, wanted, ends(2)
        integer :: panel, last_panel, middle, i

        if (u <= 0.0_wp) then
            point = self%at(merge(first, last, side > 0.0_wp))
            return
        end if
        panel = interval_of(self%edges, first)
        last_panel = interval_of(self%edges, last)
        middle = last_panel
        do while (last_panel > panel)
            middle = (panel + last_panel + 1)/2
            if (side*(control%of(self%depths(middle), self%forces(middle)) - origin) < u .eqv. side > 0.0_wp) then
                panel = middle
            else
                last_panel = middle - 1
            end if
        end do
        low = -1.0_wp - overlap
        high = 1.0_wp + overlap
        if (first > self%edges(panel)) low = local(self, panel, first)
        if (last < self%edges(panel + 1)) high = local(self, panel, last)
        wanted = merge(sqrt(u), log(u), root)
        ! the panel's ends give the first guess: root or logarithm are close to a straight line
        ends = side*(control%of(self%depths(panel:panel + 1), self%forces(panel:panel + 1)) - origin)
        z = 0.5_wp*(low + high)
        if (all(ends > 0.0_wp)) then
            ends = merge(sqrt(ends), log(ends), root)
            z = min(max(2.0_wp*(wanted - ends(1))/(ends(2) - ends(1)) - 1.0_wp, low), high)
        end if
        do i = 1, most_steps
            call series(self%coefficients(:, :, panel), z, v, dv)
            if (self%adhesive .or. root .or. control%force_weight > 0.0_wp) then
                call control_of(self, control, v, dv, s, ds)
                s = max(side*(s - origin), 0.0_wp)
                y = merge(sqrt(s), log(max(s, tiny(s))), root) - wanted
                dy = 0.0_wp
                if (s > 0.0_wp) dy = side*ds/merge(2.0_wp*sqrt(s), s, root)
            else
                y = v(of_depth) + log(control%depth_weight) - wanted
                dy = dv(of_depth)
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
        point = point_of(self, panel, z, v + dv*step)
    end function find

    !> Coordinates between which s has one extremum each, (2, extrema), ascending.
    pure function turns(self, control) result(brackets)
        class(curve_t), intent(in) :: self
        type(control_t), intent(in) :: control
        real(wp), allocatable :: brackets(:, :)
        real(wp), allocatable :: ends(:)
        real(wp) :: x, x_before, rate, rate_before
        integer :: panel, probe

        allocate (ends(0))
        x_before = self%edges(1)
        rate_before = self%slope(control, x_before)
        do panel = 1, size(self%from_root)
            do probe = 1, probes_per_panel
                x = self%edges(panel) + (self%edges(panel + 1) - self%edges(panel))*(real(probe, wp)/probes_per_panel)
                if (probe == probes_per_panel) x = self%edges(panel + 1)
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

    !> int F dd from one coordinate to another, both clipped to the sampled range.
    function work_between(self, from, to) result(work)
        class(curve_t), intent(in) :: self
        real(wp), intent(in) :: from, to
        real(wp) :: work
        type(curve_point_t) :: point
        real(wp) :: low, high, v(rows), dv(rows), s, ds
        integer :: panel, i

        work = 0.0_wp
        do panel = 1, size(self%from_root)
            low = min(max(min(from, to), self%edges(panel)), self%edges(panel + 1))
            high = min(max(max(from, to), self%edges(panel)), self%edges(panel + 1))
            if (.not. high > low) cycle
            low = local(self, panel, low)
            high = local(self, panel, high)
            do i = 1, work_nodes
                call series(self%coefficients(:, :, panel), low + (high - low)*self%work_rule(i, 1), v, dv)
                call control_of(self, depth_control, v, dv, s, ds)
                point = point_of(self, panel, low, v)
                work = work + (high - low)*self%work_rule(i, 2)*point%force*ds
            end do
        end do
        if (to < from) work = -work
    end function work_between

    !> The state of the contact itself at coordinate x.
    subroutine state_at(self, equilibrium, x, state, error)
        class(curve_t), intent(in) :: self
        type(equilibrium_t), intent(in) :: equilibrium
        real(wp), intent(in) :: x
        type(contact_state_t), intent(out) :: state
        type(error_t), allocatable, intent(out) :: error

        call equilibrium%at(self%end_radius + exp(x), state, error)
    end subroutine state_at

    !> Puts in place of depth and stiffness the shift S = int dF/k_t under which the contact would begin to slide if its coefficient
    !> of friction were 1, and the tangential stiffness k_t = dF/dS: those of superposed punches (theory 10).
    subroutine shear(self, tangential, error)
        class(curve_t), intent(inout) :: self
        !> its modulus is G_t(a)
        class(solver_t), intent(in) :: tangential
        type(error_t), allocatable, intent(out) :: error
        type(curve_point_t) :: point
        real(wp) :: z, v(rows), dv(rows), modulus(1), k(nodes), shifts(0:nodes), gained(0:nodes + 1), places(0:nodes + 1)
        integer :: panel, i, j

        self%adhesive = .false.
        places = [-1.0_wp, (node(i, nodes), i=nodes, 1, -1), 1.0_wp]
        do panel = 1, size(self%from_root)
            do i = 1, nodes
                call series(self%coefficients(:, :, panel), node(i, nodes), v, dv)
                point = point_of(self, panel, node(i, nodes), v)
                call tangential%modulus([point%radius], modulus, error)
                if (allocated(error)) return
                k(i) = 2.0_wp*point%radius*modulus(1)
            end do
            self%coefficients(of_stiffness, :, panel) = reshape(series_of_values(reshape(log(k), [1, nodes])), [nodes])
            if (panel == 1) then
                ! below, F and k_t are powers of a
                call series(self%coefficients(:, :, 1), -1.0_wp, v, dv)
                shifts(0) = exp(v(of_force) - v(of_stiffness))*dv(of_force)/(dv(of_force) - dv(of_stiffness))
            end if
            gained = 0.0_wp
            do i = 1, nodes + 1
                do j = 1, work_nodes
                    z = places(i - 1) + (places(i) - places(i - 1))*self%work_rule(j, 1)
                    call series(self%coefficients(:, :, panel), z, v, dv)
                    gained(i) = gained(i) + (places(i) - places(i - 1))*self%work_rule(j, 2) &
                                *exp(v(of_force) - v(of_stiffness))*dv(of_force)
                end do
                gained(i) = gained(i) + gained(i - 1)
            end do
            shifts(1:) = shifts(0) + gained(nodes:1:-1)
            self%coefficients(of_depth, :, panel) = reshape(series_of_values(reshape(log(shifts(1:)), [1, nodes])), [nodes])
            shifts(0) = shifts(0) + gained(nodes + 1)
        end do
        do i = 1, size(self%edges)
            call edge_values(self, i, self%depths(i), self%forces(i))
        end do
    end subroutine shear

end module mdrcontact_contact_curve
