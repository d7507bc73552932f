! SPDX-License-Identifier: GPL-3.0-or-later
!> One direction of a compiled law: depth to force (a, k), or force to depth (a, k), on every stable segment of the branch.
module mdrcontact_law_table
    use, intrinsic :: iso_c_binding, only: c_double, c_int
    use mdrcontact_contact, only: on_loading
    use mdrcontact_kinds, only: wp
    use mdrcontact_law_interval, only: contains_ends, interval_place, interval_rate, interval_t, panel_count, &
                                      panel_ends, place_t, polynomial, polynomial_moments, polynomial_with_slope, row_t, &
                                      scale_interval
    implicit none (type, external)
    private
    public :: contact_rows_t, law_table_t, table_segment_t
    public :: interval_for, segment_for, interval_in, below_range, no_contact, fewest_roots, most_roots
    public :: conductance_in, values_in, value_below, values_below, energy_in, energy_below, find_direct, add_energies, scale_table

    !> Result of interval_for if there is no interval: below the compiled range of a contact without adhesion; open.
    integer, parameter :: below_range = -1, no_contact = 0
    !> Least and largest lowest power of the root of s below the range.
    integer, parameter :: fewest_roots = 2, most_roots = 12

    !> A stable segment: s grows from lowest to highest with the contact radius, through the intervals first to last.
    type :: table_segment_t
        real(wp) :: lowest = 0.0_wp, highest = 0.0_wp
        integer :: first = 1, last = 1
        !> int F dd along the branch from the lowest depth of the first segment to that of this one
        real(wp) :: energy = 0.0_wp
    end type table_segment_t

    !> Quantities that are rarely needed with F or d: the polynomials of a and k of one panel.
    type :: contact_rows_t
        type(row_t) :: radius, stiffness
    end type contact_rows_t

    !> One direction of a law: intervals, panels and their polynomials.
    type :: law_table_t
        !> whether s is the depth and the other quantity the force, or the reverse
        logical :: by_depth = .true.
        logical :: adhesive = .false.
        !> whether s beyond the highest is answered, along the tangent there
        logical :: continued = .false.
        !> with adhesion: s from which on bodies that approach attract each other; 0 where adhesion has no range
        real(wp) :: first_attraction = 0.0_wp
        !> radius of the indenter's flat end [length]
        real(wp) :: end_radius = 0.0_wp
        !> ends of the compiled range of s
        real(wp) :: lowest = 0.0_wp, highest = 0.0_wp
        !> without adhesion, at the lowest s: F or d, a less the end radius; and the powers of s they follow below it, p the first
        real(wp) :: end_values(2) = 0.0_wp
        real(wp) :: powers(2) = 0.0_wp
        !> F as s^(m/2) (1 - b + b s^(1/2)), s by the lowest and b = 2 p - m, instead of s^p: m, or 0. Of a table by force its
        !> inverse, with 1/p instead of p
        integer :: roots = 0
        type(table_segment_t), allocatable :: segments(:)
        type(interval_t), allocatable :: intervals(:)
        !> of each panel: F or d, in a table of its own, so that many laws stay in cache; a and k
        type(row_t), allocatable :: other(:)
        type(contact_rows_t), allocatable :: contact(:)
        !> by depth: int F dd from the beginning of the branch to the middle of each panel
        real(wp), allocatable :: energy(:)
        !> of each panel, of a law that conducts: G
        type(row_t), allocatable :: conductance(:)
        !> the interval in which nothing has to be searched for: no root, one segment, the first panels; empty if it does not exist
        type(interval_t) :: direct = interval_t(lowest=1.0_wp, highest=-1.0_wp)
    end type law_table_t

    interface
        !> base^exponent for 0 < base <= 1: that of include/mdrcontact_law.h, in kernel.c.
        pure function power_of(base, exponent) result(power) bind(C, name="mdrcontact_law_power")
            import :: c_double
            real(c_double), intent(in), value :: base, exponent
            real(c_double) :: power
        end function power_of

        !> F below the range and its slope: also there.
        pure subroutine first_touch(lowest, first, power, roots, s, other, slope) bind(C, name="mdrcontact_law_touch")
            import :: c_double, c_int
            real(c_double), intent(in), value :: lowest, first, power, s
            integer(c_int), intent(in), value :: roots
            real(c_double), intent(out) :: other, slope
        end subroutine first_touch

        !> int F dd from initial contact to a depth below the range: also there.
        pure function first_energy(lowest, power, roots, d, force) result(energy) bind(C, name="mdrcontact_law_touch_energy")
            import :: c_double, c_int
            real(c_double), intent(in), value :: lowest, power, d, force
            integer(c_int), intent(in), value :: roots
            real(c_double) :: energy
        end function first_energy
    end interface

contains

    !> The interval in which the state of a branch at s <= highest lies; below_range or no_contact if it does not exist.
    pure function interval_for(self, branch, s) result(interval)
        type(law_table_t), intent(in) :: self
        !> on_loading or on_unloading
        integer, intent(in) :: branch
        real(wp), intent(in) :: s
        integer :: interval
        integer :: segment

        segment = segment_for(self, branch, s)
        if (segment > 0) then
            interval = interval_in(self, segment, s)
        else if (self%adhesive .or. s <= 0.0_wp) then
            interval = no_contact
        else
            interval = below_range
        end if
    end function interval_for

    !> The segment on which the state of a branch at s lies, 0 if it does not exist.
    pure function segment_for(self, branch, s) result(segment)
        type(law_table_t), intent(in) :: self
        integer, intent(in) :: branch
        real(wp), intent(in) :: s
        integer :: segment
        integer :: i

        segment = 0
        if (branch == on_loading .and. s < self%first_attraction) return
        do i = 1, size(self%segments)
            if (s < self%segments(i)%lowest .or. s > self%segments(i)%highest) cycle
            segment = i
            if (branch == on_loading) return
        end do
    end function segment_for

    !> The interval of a segment that contains s.
    pure function interval_in(self, segment, s) result(interval)
        type(law_table_t), intent(in) :: self
        integer, intent(in) :: segment
        real(wp), intent(in) :: s
        integer :: interval
        integer :: low, high, middle

        low = self%segments(segment)%first
        high = self%segments(segment)%last
        do while (low < high)
            middle = (low + high)/2
            if (s > self%intervals(middle)%highest) then
                low = middle + 1
            else
                high = middle
            end if
        end do
        interval = low
    end function interval_in

    !> F or d, its derivative with respect to s along the branch, a and k in an interval.
    pure subroutine values_in(self, interval, s, other, slope, radius, stiffness)
        type(law_table_t), intent(in) :: self
        integer, intent(in) :: interval
        real(wp), intent(in) :: s
        real(wp), intent(out) :: other, slope, radius, stiffness
        type(place_t) :: place

        place = interval_place(self%intervals(interval), s)
        call polynomial_with_slope(self%other(place%panel)%c, place%t, other, slope)
        slope = interval_rate(self%intervals(interval), s)*slope
        radius = polynomial(self%contact(place%panel)%radius%c, place%t)
        stiffness = polynomial(self%contact(place%panel)%stiffness%c, place%t)
    end subroutine values_in

    !> G and its derivative with respect to s along the branch in an interval of a table that has them, or below its range as the
    !> power of s with the same value and slope.
    pure subroutine conductance_in(self, interval, s, conductance, slope)
        type(law_table_t), intent(in) :: self
        !> or below_range
        integer, intent(in) :: interval
        real(wp), intent(in) :: s
        real(wp), intent(out) :: conductance, slope
        type(place_t) :: place
        real(wp) :: within

        within = max(s, self%lowest)
        associate (range => self%intervals(max(interval, 1)))
            place = interval_place(range, within)
            call polynomial_with_slope(self%conductance(place%panel)%c, place%t, conductance, slope)
            slope = interval_rate(range, within)*slope
        end associate
        if (interval /= below_range .or. .not. conductance > 0.0_wp) return
        slope = max(slope, 0.0_wp)*within/conductance
        conductance = conductance*power_of(s/within, slope)
        slope = slope*conductance/s
    end subroutine conductance_in

    !> int F dd from the beginning of the branch to depth s in an interval.
    pure function energy_in(self, interval, s) result(energy)
        type(law_table_t), intent(in) :: self
        integer, intent(in) :: interval
        real(wp), intent(in) :: s
        real(wp) :: energy
        type(place_t) :: place

        place = interval_place(self%intervals(interval), s)
        energy = self%energy(place%panel) + energy_from_middle(self, self%intervals(interval), place)
    end function energy_in

    !> int F dd from the middle of a panel: dd is dy/scale, with a root 2 side (y - offset) dy/scale^2.
    pure function energy_from_middle(self, interval, place) result(energy)
        type(law_table_t), intent(in) :: self
        type(interval_t), intent(in) :: interval
        type(place_t), intent(in) :: place
        real(wp) :: energy
        real(wp) :: moments(2), ends(2)

        moments = polynomial_moments(self%other(place%panel)%c, place%t)
        if (interval%root) then
            ends = panel_ends(interval, place%panel - interval%first_panel)
            energy = 2.0_wp*interval%side*((0.5_wp*(ends(1) + ends(2)) - interval%offset)*moments(1) + moments(2))/interval%scale**2
        else
            energy = moments(1)/interval%scale
        end if
    end function energy_from_middle

    !> The energies of a table by depth whose other parts are complete.
    pure subroutine add_energies(self)
        type(law_table_t), intent(inout) :: self
        real(wp) :: energy
        integer :: i, j, k, panel, count

        allocate (self%energy(size(self%other)), source=0.0_wp)
        do i = 1, size(self%segments)
            energy = self%segments(i)%energy
            if (.not. self%adhesive) energy = energy_below(self, self%lowest)
            do j = self%segments(i)%first, self%segments(i)%last
                associate (interval => self%intervals(j))
                    count = panel_count(interval)
                    do k = 1, count
                        panel = merge(k, count + 1 - k, interval%side > 0.0_wp)
                        call add_energy(self, interval, panel, energy)
                    end do
                end associate
            end do
        end do
    end subroutine add_energies

    !> The energy in the middle of a panel, from that at its lower end, which becomes that at its upper end; both within the
    !> interval.
    pure subroutine add_energy(self, interval, panel, energy)
        type(law_table_t), intent(inout) :: self
        type(interval_t), intent(in) :: interval
        integer, intent(in) :: panel
        real(wp), intent(inout) :: energy
        real(wp) :: ends(2), y(2), t(2)
        type(place_t) :: place
        integer :: number

        number = interval%first_panel + panel
        ends = panel_ends(interval, panel)
        place = interval_place(interval, interval%lowest)
        y = merge(ends, ends(2:1:-1), interval%side > 0.0_wp)
        t = y - 0.5_wp*(ends(1) + ends(2))
        if (place%panel == number) t(1) = place%t
        place = interval_place(interval, interval%highest)
        if (place%panel == number) t(2) = place%t
        self%energy(number) = energy - energy_from_middle(self, interval, place_t(number, t(1)))
        energy = self%energy(number) + energy_from_middle(self, interval, place_t(number, t(2)))
    end subroutine add_energy

    !> The interval that callers may evaluate independently.
    pure subroutine find_direct(self)
        type(law_table_t), intent(inout) :: self

        self%direct = interval_t(lowest=1.0_wp, highest=-1.0_wp)
        if (self%adhesive .or. size(self%segments) /= 1) return
        if (self%intervals(1)%first_panel == 0 .and. contains_ends(self%intervals(1))) self%direct = self%intervals(1)
    end subroutine find_direct

    !> F or d there, and its slope: the part of values_below that many callers need.
    pure subroutine value_below(self, s, other, slope)
        type(law_table_t), intent(in) :: self
        !> between 0 and the lowest
        real(wp), intent(in) :: s
        real(wp), intent(out) :: other, slope

        if (self%by_depth .or. self%roots == 0) then
            call first_touch(self%lowest, self%end_values(1), self%powers(1), int(self%roots, c_int), s, other, slope)
        else
            call inverse_below(self, s, other, slope)
        end if
    end subroutine value_below

    !> The depth of a force below the range by Newton's method, where the force is a polynomial of the root of the depth.
    pure subroutine inverse_below(self, s, other, slope)
        !> by force
        type(law_table_t), intent(in) :: self
        real(wp), intent(in) :: s
        real(wp), intent(out) :: other, slope
        integer, parameter :: most_iterations = 60
        real(wp) :: force, change
        integer :: i

        other = power_of(s/self%lowest, self%powers(1))
        do i = 1, most_iterations
            call first_touch(1.0_wp, 1.0_wp, 1.0_wp/self%powers(1), int(self%roots, c_int), other, force, slope)
            change = (s/self%lowest - force)/slope
            other = max(other + change, 0.5_wp*other)
            if (abs(change) <= 4.0_wp*epsilon(1.0_wp)*other) exit
        end do
        other = self%end_values(1)*other
        slope = self%end_values(1)/(self%lowest*slope)
    end subroutine inverse_below

    !> The same between initial contact and the compiled range: what continues value and slope.
    pure subroutine values_below(self, s, other, slope, radius, stiffness)
        type(law_table_t), intent(in) :: self
        real(wp), intent(in) :: s
        real(wp), intent(out) :: other, slope, radius, stiffness

        call value_below(self, s, other, slope)
        radius = self%end_radius + self%end_values(2)*power_of(s/self%lowest, self%powers(2))
        stiffness = slope
        if (.not. self%by_depth) stiffness = 1.0_wp/slope
    end subroutine values_below

    !> int F dd from initial contact to a depth below the compiled range.
    pure function energy_below(self, s) result(energy)
        type(law_table_t), intent(in) :: self
        real(wp), intent(in) :: s
        real(wp) :: energy
        real(wp) :: force, slope

        call value_below(self, s, force, slope)
        energy = first_energy(self%lowest, self%powers(1), int(self%roots, c_int), s, force)
    end function energy_below

    !> The table in which s and the other quantity are a factor larger at the same radius and stiffness.
    pure subroutine scale_table(self, factor)
        type(law_table_t), intent(inout) :: self
        !> > 0
        real(wp), intent(in) :: factor
        integer :: i

        self%lowest = factor*self%lowest
        self%highest = factor*self%highest
        self%end_values(1) = factor*self%end_values(1)
        self%segments%lowest = factor*self%segments%lowest
        self%segments%highest = factor*self%segments%highest
        do i = 1, size(self%other)
            self%other(i)%c = factor*self%other(i)%c
        end do
        do i = 1, size(self%intervals)
            call scale_interval(self%intervals(i), factor)
        end do
        if (allocated(self%energy)) self%energy = factor**2*self%energy
        call find_direct(self)
    end subroutine scale_table

end module mdrcontact_law_table
