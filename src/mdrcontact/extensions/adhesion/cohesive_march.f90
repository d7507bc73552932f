! SPDX-License-Identifier: GPL-3.0-or-later
!> An indenter on a viscoelastic half-space whose surface it attracts (cohesive zone of Dugdale), step by step:
!> theory/adhesion.md (5.3), (5.4). Of the springs of adhesion/cohesive_spring.f90
!>     x < a: w = d - g;      w(a) = d - g(a) with q(a) = -2 sigma_0 sqrt(c^2 - a^2);
!>     h(c) = (2/pi) int_a^c [w - (d - g)]/sqrt(c^2 - x^2) dx = gamma/sigma_0
!> determine c and d for each a, and what a machine controls determines a. Without contact, a = 0, d follows from c. Memories live
!> on panels of x that end at a, at c and where these have turned.
module mdrcontact_adhesion_cohesive_march
    use mdrcontact_contact_control, only: control_t
    use mdrcontact_error, only: error_domain, error_invalid, error_no_convergence, error_t, raise, to_text
    use mdrcontact_adhesion_cohesive_spring, only: new_spring_step, spring_step_t, zone_load
    use mdrcontact_time_panels, only: add_turn, cut, interpolate, new_panels, panels_t
    use mdrcontact_kinds, only: half_pi, pi, wp
    use mdrcontact_material_prony, only: creep_t
    use mdrcontact_numerics_quadrature, only: gauss_legendre
    use mdrcontact_profile, only: copy, profile_t
    implicit none (type, external)
    private
    public :: cohesive_march_t, start_march, rest_march, step_march, step_apart, jump_march, mark_edges, first_attraction

    !> Gauss nodes between two places at which w(x) is not smooth.
    integer, parameter :: nodes = 16
    !> Newton's steps, and where they end: of ln h, and of what is controlled.
    integer, parameter :: most_trials = 40, enough = 8
    real(wp), parameter :: zone_tolerance = 1.0e-11_wp, tolerance = 1.0e-10_wp, widest_step = 1.5_wp
    !> Largest residual of ln h and of the controlled quantity, due to rounding and breaks of w, if the steps do not converge.
    real(wp), parameter :: rounding = 1.0e-7_wp
    !> d ln h/d ln(c - a), about.
    real(wp), parameter :: usual_slope = 1.1_wp
    !> Trials nearer to each other give no information on a slope but their rounding [ln l].
    real(wp), parameter :: same_slope = 1.0e-8_wp
    !> Largest displacement of the place in one step [zone], at first [of that], and in a jump from one trial to the next [1].
    real(wp), parameter :: farthest = 0.6_wp, first_part = 1.0e-3_wp, stride = 0.03_wp
    integer, parameter :: most_strides = 5000, halvings = 50
    !> Radii nearer to each other than this are merged, and no zone without contact is smaller [zone at touch].
    real(wp), parameter :: near = 1.0e-7_wp, smallest = 1.0e-6_wp
    !> Breaks nearer to each other are merged [zone]: the gap jumps by about ten times this where one begins to count.
    real(wp), parameter :: same_break = 1.0e-12_wp
    !> The surface may reach into the indenter by so much of the range: the error of the method.
    real(wp), parameter :: negligible = 1.0e-2_wp
    !> The longest panels in and outside the contact [largest radius].
    real(wp), parameter :: longest_inside = 0.4_wp, longest_outside = 0.1_wp

    !> State of a history.
    type :: cohesive_march_t
        class(profile_t), allocatable :: profile
        !> the step that is taken, and with it the body; a(2) and c(2) are the radii of contact and zone
        type(spring_step_t) :: springs
        !> gamma/sigma_0, and no zone ends beyond the last radius [length]
        real(wp) :: range = 0.0_wp, last_radius = 0.0_wp
        !> the bodies do not even attract each other
        logical :: is_apart = .true.
        !> d [length], F [modulus length^2]
        real(wp) :: depth = 0.0_wp, force = 0.0_wp
        !> a, or without contact, < 0, c less its value where the bodies touch [length]; and what it changed by in time
        real(wp) :: place = 0.0_wp, speed = 0.0_wp
        !> c where the bodies touch, at the end of the present step [length]
        real(wp) :: touching = 0.0_wp
        !> where memories are not smooth [length], ascending
        real(wp), allocatable :: turns(:)
        !> q in the contact and z_l: (nodes, 1 + l)
        type(panels_t) :: panels
        real(wp), allocatable :: past(:, :)
        real(wp), private :: node(nodes) = 0.0_wp, weight(nodes) = 0.0_wp
    end type cohesive_march_t

    !> Quantities of a place at the end of a step.
    type :: trial_t
        real(wp) :: a = 0.0_wp, c = 0.0_wp, depth = 0.0_wp, force = 0.0_wp
        !> h(c), and the least of w - (d - g) next to the contact [range]
        real(wp) :: gap = 1.0_wp, least = 0.0_wp
        !> memories, where the force is known
        type(panels_t) :: panels
        real(wp), allocatable :: past(:, :)
    end type trial_t

contains

    !> A body at rest that no indenter has touched.
    subroutine start_march(self, profile, creep, stress, range, last_radius, error)
        type(cohesive_march_t), intent(out) :: self
        class(profile_t), intent(in) :: profile
        type(creep_t), intent(in) :: creep
        !> sigma_0 > 0 [modulus], gamma/sigma_0 > 0, and where indenter and body end [length]
        real(wp), intent(in) :: stress, range, last_radius
        type(error_t), allocatable, intent(inout) :: error

        call copy(profile, self%profile, error)
        if (.not. allocated(error)) call new_spring_step(self%springs, creep, 2.0_wp*stress, error)
        if (.not. allocated(error)) call gauss_legendre(self%node, self%weight, error)
        if (allocated(error)) return
        self%range = range
        self%last_radius = last_radius
        self%turns = [real(wp) ::]
        self%panels = new_panels([0.0_wp])
        allocate (self%past(0, 1 + size(creep%rate)))
    end subroutine start_march

    !> The relaxed body in equilibrium with what is controlled, in the largest contact, for ever.
    subroutine rest_march(self, control, s, error)
        type(cohesive_march_t), intent(inout) :: self
        type(control_t), intent(in) :: control
        real(wp), intent(in) :: s
        type(error_t), allocatable, intent(inout) :: error
        type(creep_t) :: creep
        real(wp) :: values(2)
        integer :: i

        creep = self%springs%creep
        self%springs%creep%instant = creep%instant + sum(creep%weight)
        self%springs%creep%weight = 0.0_wp
        self%is_apart = .false.
        self%place = length_scale(self)
        do
            values(1) = value_at(self, control, self%place, error)
            values(2) = value_at(self, control, 2.0_wp*self%place, error)
            if (allocated(error)) return
            if (all(values > s)) exit
            self%place = 2.0_wp*self%place
            if (2.0_wp*self%place < self%last_radius) cycle
            call refuse_radius(self, error)
            return
        end do
        call jump_march(self, control, s, -1, error)
        self%springs%creep = creep
        if (allocated(error)) return
        do i = 1, size(self%panels%x)
            self%past(i, 2:) = self%past(i, 1)
            if (self%panels%x(i) > self%springs%a(2)) then
                self%past(i, 2:) = zone_load(self%springs%stress, self%springs%c(2), self%panels%x(i))
            end if
        end do
    end subroutine rest_march

    !> A length to begin searches with: the zone of a large contact.
    pure function length_scale(self) result(length)
        type(cohesive_march_t), intent(in) :: self
        real(wp) :: length

        length = min(half_pi*self%range/(self%springs%stress*self%springs%creep%instant), 0.01_wp*self%last_radius)
    end function length_scale

    subroutine refuse_radius(self, error)
        type(cohesive_march_t), intent(in) :: self
        type(error_t), allocatable, intent(inout) :: error

        if (allocated(error)) return
        call raise(error, error_domain, "the contact and its zone would be larger than radius "//to_text(self%last_radius)// &
                   ", where the indenter or the medium ends")
    end subroutine refuse_radius

    !> One step of length h > 0 to what is controlled. Where no state lies near, `found` is false and nothing has changed; towards
    !> which side then is `direction`, 1: a larger contact, -1: a smaller one.
    subroutine step_march(self, h, control, s, found, direction, error)
        type(cohesive_march_t), intent(inout) :: self
        real(wp), intent(in) :: h
        type(control_t), intent(in) :: control
        real(wp), intent(in) :: s
        logical, intent(out) :: found
        integer, intent(out) :: direction
        type(error_t), allocatable, intent(inout) :: error
        real(wp) :: x, x_before, y, y_before, most, scale, next, low, high
        logical :: grows
        integer :: i

        found = .false.
        call begin_step(self, h)
        most = farthest*max(self%springs%c(1) - self%springs%a(1), first_part*self%springs%c(1))
        if (self%place < most) call find_touching(self, error)
        scale = control%depth_weight*self%range + control%force_weight*self%range**2/self%springs%creep%instant
        x_before = self%place
        y_before = value_at(self, control, x_before, error) - s
        direction = merge(-1, 1, y_before > 0.0_wp)
        low = merge(-huge(x), x_before, y_before > 0.0_wp)
        high = merge(x_before, huge(x), y_before > 0.0_wp)
        x = self%place + direction*max(min(abs(self%speed*h), 0.5_wp*most), first_part*most)
        do i = 1, most_trials
            if (allocated(error) .or. x < smallest*self%touching - self%touching) return
            y = value_at(self, control, x, error) - s
            if (allocated(error)) return
            ! s grows with the contact, or the state is not stable; where the edge rests rounding may contradict this
            grows = (y - y_before)*(x - x_before) > 0.0_wp
            found = abs(y) <= merge(tolerance, rounding, grows)*scale
            if (found) exit
            if (.not. grows) return
            if (y > 0.0_wp) then
                high = x
            else
                low = x
            end if
            next = x - y*(x - x_before)/(y - y_before)
            ! where the contact vanishes s has a kink, next to which secants go to and fro
            if (i > enough .and. modulo(i, 2) == 0 .and. low > -huge(x) .and. high < huge(x)) next = 0.5_wp*(low + high)
            found = abs(next - x) <= tolerance*most
            if (found) exit
            if (abs(next - self%place) > most) return
            x_before = x
            y_before = y
            x = next
        end do
        if (.not. found) return
        self%speed = (x - self%place)/h
        call commit(self, x, error)
    end subroutine step_march

    !> The bodies stay apart for a time h, and their surfaces recover.
    subroutine step_apart(self, h, error)
        type(cohesive_march_t), intent(inout) :: self
        real(wp), intent(in) :: h
        type(error_t), allocatable, intent(inout) :: error
        type(trial_t) :: trial

        call begin_step(self, h)
        call remember(self, trial, 0.0_wp, error)
        if (allocated(error)) return
        self%panels = trial%panels
        self%past = trial%past
        self%springs%a(2) = 0.0_wp
        self%springs%c(2) = 0.0_wp
        self%force = 0.0_wp
        self%speed = 0.0_wp
        self%is_apart = .true.
    end subroutine step_apart

    !> The depth at which separated bodies begin to attract each other.
    function first_attraction(self) result(depth)
        type(cohesive_march_t), intent(in) :: self
        real(wp) :: depth
        real(wp) :: past(1, size(self%past, 2))

        past = interpolate(self%panels, self%past, [0.0_wp])
        depth = sum(self%springs%creep%weight*past(1, 2:)) - self%range
    end function first_attraction

    !> From here to the nearest state that is controlled, instantaneously: the body has its glassy response. Towards larger contacts
    !> (1) or smaller ones (-1); if it does not exist smaller the bodies separate.
    subroutine jump_march(self, control, s, direction, error)
        type(cohesive_march_t), intent(inout) :: self
        type(control_t), intent(in) :: control
        real(wp), intent(in) :: s
        integer, intent(in) :: direction
        type(error_t), allocatable, intent(inout) :: error
        real(wp) :: x, x_before, low, high, middle, first
        integer :: i

        call mark_edges(self)
        call begin_step(self, 0.0_wp)
        call find_touching(self, error)
        first = (smallest - 1.0_wp)*self%touching
        x = self%place
        if (self%is_apart) x = first
        do i = 1, most_strides
            if (allocated(error)) return
            x_before = x
            x = x + direction*stride*max(abs(x), 0.1_wp*self%touching)
            if (x < first) then
                call step_apart(self, 0.0_wp, error)
                return
            end if
            if (x > self%last_radius .or. i == most_strides) call refuse_radius(self, error)
            if (allocated(error)) return
            if (direction*(value_at(self, control, x, error) - s) > 0.0_wp) exit
        end do
        low = min(x, x_before)
        high = max(x, x_before)
        do i = 1, halvings
            middle = 0.5_wp*(low + high)
            if (value_at(self, control, middle, error) > s) then
                high = middle
            else
                low = middle
            end if
            if (allocated(error)) return
        end do
        call commit(self, 0.5_wp*(low + high), error)
        self%speed = 0.0_wp
        if (.not. allocated(error)) call mark_edges(self)
    end subroutine jump_march

    !> Memories keep the edges as they are now.
    pure subroutine mark_edges(self)
        type(cohesive_march_t), intent(inout) :: self

        associate (a => self%springs%a(2), c => self%springs%c(2))
            if (a > near*c) call add_turn(self%turns, a, c)
            if (c > 0.0_wp) call add_turn(self%turns, c, c)
        end associate
    end subroutine mark_edges

    pure subroutine begin_step(self, h)
        type(cohesive_march_t), intent(inout) :: self
        real(wp), intent(in) :: h

        self%springs%length = h
        self%springs%a(1) = self%springs%a(2)
        self%springs%c(1) = self%springs%c(2)
    end subroutine begin_step

    !> The controlled quantity if the contact ends at a place at the end of the step.
    function value_at(self, control, place, error) result(s)
        type(cohesive_march_t), intent(inout) :: self
        type(control_t), intent(in) :: control
        real(wp), intent(in) :: place
        type(error_t), allocatable, intent(inout) :: error
        real(wp) :: s
        type(trial_t) :: trial

        call try(self, place, trial, error)
        if (.not. allocated(error) .and. control%force_weight > 0.0_wp) call remember(self, trial, trial%a, error)
        s = control%of(trial%depth, trial%force)
        ! trials leave the step as it began
        self%springs%a(2) = self%springs%a(1)
        self%springs%c(2) = self%springs%c(1)
    end function value_at

    !> The step ends at a place.
    subroutine commit(self, place, error)
        type(cohesive_march_t), intent(inout) :: self
        real(wp), intent(in) :: place
        type(error_t), allocatable, intent(inout) :: error
        type(trial_t) :: trial

        call try(self, place, trial, error)
        if (.not. allocated(error)) call remember(self, trial, trial%c, error)
        if (allocated(error)) return
        if (trial%least < -negligible) then
            call raise(error, error_invalid, "the surface outside a contact of radius "//to_text(trial%a)// &
                       " touches the indenter: the contact is no longer a single area")
            return
        end if
        self%is_apart = .false.
        self%place = place
        self%depth = trial%depth
        self%force = trial%force
        self%panels = trial%panels
        self%past = trial%past
        self%springs%a(2) = trial%a
        self%springs%c(2) = trial%c
    end subroutine commit

    !> c and d at a place.
    subroutine try(self, place, trial, error)
        type(cohesive_march_t), intent(inout) :: self
        real(wp), intent(in) :: place
        type(trial_t), intent(out) :: trial
        type(error_t), allocatable, intent(inout) :: error
        real(wp) :: x, y, x_before, y_before, slope, step
        integer :: i

        trial%a = max(place, 0.0_wp)
        if (place < 0.0_wp) then
            trial%c = self%touching + place
            call open_gap(self, trial)
            return
        end if
        x = log(length_scale(self))
        if (self%springs%c(1) > self%springs%a(1)) x = log(self%springs%c(1) - self%springs%a(1))
        slope = usual_slope
        x_before = x
        y_before = 0.0_wp
        do i = 1, most_trials
            if (.not. exp(x) < self%last_radius - trial%a) then
                call refuse_radius(self, error)
                return
            end if
            trial%c = trial%a + exp(x)
            call open_gap(self, trial)
            y = log(max(trial%gap, tiny(y)))
            if (abs(y) <= zone_tolerance) return
            if (i > enough .and. abs(y) <= rounding) return
            if (i > 1) then
                if (abs(x - x_before) > same_slope) slope = max(0.2_wp, (y - y_before)/(x - x_before))
            end if
            step = -max(-widest_step, min(widest_step, y/slope))
            if (abs(step) <= zone_tolerance) return
            x_before = x
            y_before = y
            x = x + step
        end do
        if (abs(y) <= rounding) return
        call raise(error, error_no_convergence, "the cohesive zone around a contact of radius "//to_text(trial%a)// &
                   " was not found")
    end subroutine try

    !> d from the edge, and the gap at the end of the zone; without contact d from that gap.
    subroutine open_gap(self, trial)
        type(cohesive_march_t), intent(inout) :: self
        type(trial_t), intent(inout) :: trial
        real(wp) :: ends(4 + size(self%turns)), x(nodes), weights(nodes), w(nodes), total, mean, edge(1), length
        integer :: i, count

        self%springs%a(2) = trial%a
        self%springs%c(2) = trial%c
        length = trial%c - trial%a
        call roots_of_breaks(self, trial, ends, count)
        call displacements(self, [trial%a], edge)
        mean = 0.0_wp
        total = 0.0_wp
        trial%least = huge(1.0_wp)
        trial%depth = edge(1) + self%profile%mdr(trial%a)
        do i = 1, count
            call zone_nodes(self, trial, ends(i), ends(i + 1), x, weights)
            call displacements(self, x, w)
            w = w + mdr_at(self, x) - trial%depth
            trial%least = min(trial%least, minval(w)/self%range)
            total = total + sum(weights*w)
        end do
        if (trial%a > 0.0_wp) then
            trial%gap = total/self%range
        else
            ! the opening at the axis is what d, until here that of a touch, must be less
            trial%least = 1.0_wp - total/self%range
            trial%depth = trial%depth + total - self%range
        end if
        if (length < 0.0_wp) trial%gap = 0.0_wp
    end subroutine open_gap

    !> Roots of (c - x)/(c - a), ascending from 0 to 1, between which w is smooth.
    pure subroutine roots_of_breaks(self, trial, ends, count)
        type(cohesive_march_t), intent(in) :: self
        type(trial_t), intent(in) :: trial
        real(wp), intent(out) :: ends(:)
        !> of intervals
        integer, intent(out) :: count
        real(wp) :: places(size(ends) - 2), next
        integer :: i

        places = [self%springs%a(1), self%springs%c(1), self%turns]
        ends = 0.0_wp
        count = 1
        next = trial%c
        do i = 1, size(places)
            next = maxval(places, mask=places < next - same_break*(trial%c - trial%a))
            if (.not. next > trial%a + same_break*(trial%c - trial%a)) exit
            count = count + 1
            ends(count) = sqrt((trial%c - next)/(trial%c - trial%a))
        end do
        ends(count + 1) = 1.0_wp
    end subroutine roots_of_breaks

    !> x = c - (c - a) y^2, and weights of (2/pi) dx/sqrt(c^2 - x^2).
    pure subroutine zone_nodes(self, trial, from, to, x, weights)
        type(cohesive_march_t), intent(in) :: self
        type(trial_t), intent(in) :: trial
        real(wp), intent(in) :: from, to
        real(wp), intent(out) :: x(nodes), weights(nodes)
        real(wp) :: y(nodes), length

        length = trial%c - trial%a
        y = from + (to - from)*self%node
        x = trial%c - length*y**2
        weights = (to - from)*self%weight*2.0_wp*length/(half_pi*sqrt(length*(2.0_wp*trial%c - length*y**2)))
    end subroutine zone_nodes

    function mdr_at(self, x) result(g)
        type(cohesive_march_t), intent(in) :: self
        real(wp), intent(in) :: x(:)
        real(wp) :: g(size(x))
        integer :: i

        do i = 1, size(x)
            g(i) = self%profile%mdr(x(i))
        end do
    end function mdr_at

    !> w at places that are in the zone, or at its inner end, at the end of the step.
    subroutine displacements(self, x, w)
        type(cohesive_march_t), intent(in) :: self
        real(wp), intent(in) :: x(:)
        real(wp), intent(out) :: w(:)
        real(wp) :: past(size(x), size(self%past, 2)), z(size(self%past, 2) - 1), rise(size(self%past, 2) - 1), memory, compliance
        integer :: i

        call look_back(self, x, past)
        do i = 1, size(x)
            z = past(i, 2:)
            call self%springs%pass(x(i), past(i, 1), z, rise, memory, compliance)
            w(i) = memory + compliance*zone_load(self%springs%stress, self%springs%c(2), x(i))
        end do
    end subroutine displacements

    !> q and z_l at the beginning of the step.
    subroutine look_back(self, x, past)
        type(cohesive_march_t), intent(in) :: self
        real(wp), intent(in) :: x(:)
        real(wp), intent(out) :: past(:, :)

        past = interpolate(self%panels, self%past, x)
        where (x > self%springs%a(1)) past(:, 1) = zone_load(self%springs%stress, self%springs%c(1), x)
    end subroutine look_back

    !> Memories and the force after the step.
    subroutine remember(self, trial, reach, error)
        type(cohesive_march_t), intent(inout) :: self
        type(trial_t), intent(inout) :: trial
        !> a for the force alone, else c, the radius up to which the surface has been attracted
        real(wp), intent(in) :: reach
        type(error_t), allocatable, intent(inout) :: error
        real(wp), allocatable :: past(:, :)
        real(wp) :: z(size(self%past, 2) - 1), rise(size(self%past, 2) - 1), memory, compliance
        integer :: i

        self%springs%a(2) = trial%a
        self%springs%c(2) = trial%c
        call place(self, trial, reach, error)
        if (allocated(error)) return
        associate (x => trial%panels%x, a => trial%a, c => trial%c, stress => self%springs%stress)
            allocate (past(size(x), size(self%past, 2)), trial%past(size(x), size(self%past, 2)))
            call look_back(self, x, past)
            do i = 1, size(x)
                z = past(i, 2:)
                call self%springs%pass(x(i), past(i, 1), z, rise, memory, compliance)
                trial%past(i, 1) = zone_load(stress, c, x(i))
                if (x(i) <= a .and. a > 0.0_wp) then
                    trial%past(i, 1) = (trial%depth - self%profile%mdr(x(i)) - memory)/compliance
                end if
                trial%past(i, 2:) = z + rise*trial%past(i, 1)
            end do
            trial%force = 2.0_wp*sum(trial%panels%weights*trial%past(:, 1), mask=x <= a .and. a > 0.0_wp) &
                          - stress*(c**2*atan2(sqrt((c - a)*(c + a)), a) - a*sqrt((c - a)*(c + a)))
        end associate
    end subroutine remember

    !> Panels to the turns, to the edges, and as far as the surface has been attracted.
    subroutine place(self, trial, reach, error)
        type(cohesive_march_t), intent(in) :: self
        type(trial_t), intent(inout) :: trial
        real(wp), intent(in) :: reach
        type(error_t), allocatable, intent(inout) :: error
        real(wp), allocatable :: ends(:), edges(:)
        real(wp) :: extent, slack
        integer :: i

        extent = reach
        if (.not. reach < trial%c) extent = max(trial%c, self%panels%ends(ubound(self%panels%ends, 1)))
        slack = near*trial%c
        call self%profile%add_breaks(ends, error)
        if (allocated(error)) return
        ends = [ends, self%turns, trial%a, trial%c, extent]
        edges = [0.0_wp]
        do
            i = minloc(ends, dim=1, mask=ends > edges(size(edges)) + slack)
            if (i == 0) exit
            if (ends(i) > extent) exit
            edges = [edges, ends(i)]
        end do
        ! a turn next to an edge gives way to it
        do i = 2, size(edges)
            if (abs(edges(i) - trial%a) <= slack) edges(i) = trial%a
            if (abs(edges(i) - trial%c) <= slack) edges(i) = trial%c
        end do
        i = count(edges <= trial%a + slack)
        ends = cut(edges(i:), longest_outside*extent)
        trial%panels = new_panels([cut(edges(:i), longest_inside*extent), ends(2:)])
    end subroutine place

    !> The radius of the zone at which the bodies touch at the end of the step.
    subroutine find_touching(self, error)
        type(cohesive_march_t), intent(inout) :: self
        type(error_t), allocatable, intent(inout) :: error
        type(trial_t) :: trial
        real(wp) :: low, high
        integer :: i

        low = 0.0_wp
        high = length_scale(self)
        do
            trial%c = high
            call open_gap(self, trial)
            if (.not. trial%least > 0.0_wp) exit
            low = high
            high = 2.0_wp*high
            if (high > self%last_radius) call refuse_radius(self, error)
            if (allocated(error)) return
        end do
        do i = 1, halvings
            trial%c = 0.5_wp*(low + high)
            call open_gap(self, trial)
            if (trial%least > 0.0_wp) then
                low = trial%c
            else
                high = trial%c
            end if
        end do
        self%touching = trial%c
        self%springs%a(2) = self%springs%a(1)
        self%springs%c(2) = self%springs%c(1)
    end subroutine find_touching

end module mdrcontact_adhesion_cohesive_march
