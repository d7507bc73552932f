! SPDX-License-Identifier: GPL-3.0-or-later
!> One direction of a compiled law: depth to force (a, k), or force to depth (a, k), on every stable segment of the branch.
module mdrcontact_law_table
    use mdrcontact_contact, only: on_loading
    use mdrcontact_kinds, only: wp
    use mdrcontact_law_interval, only: coefficient_count, column_count, place_t, polynomial, polynomial_slope, interval_place, &
                                      interval_rate, interval_t, scale_interval
    implicit none (type, external)
    private
    public :: law_table_t, table_segment_t
    public :: interval_for, segment_for, interval_in, below_range, no_contact
    public :: value_in, values_in, values_below, scale_table

    !> What interval_for says where there is no interval: below the compiled range of a contact without adhesion; open.
    integer, parameter :: below_range = -1, no_contact = 0
    !> Columns.
    integer, parameter :: other_column = 1, radius_column = 2, stiffness_column = 3

    !> A stable segment: s grows from lowest to highest with the contact radius, through the intervals first to last.
    type :: table_segment_t
        real(wp) :: lowest = 0.0_wp, highest = 0.0_wp
        integer :: first = 1, last = 1
    end type table_segment_t

    !> One direction of a law: intervals, panels and their polynomials.
    type :: law_table_t
        !> whether s is the depth and the other quantity the force, or the reverse
        logical :: by_depth = .true.
        logical :: adhesive = .false.
        !> radius of the indenter's flat end [length]
        real(wp) :: end_radius = 0.0_wp
        !> ends of the compiled range of s
        real(wp) :: lowest = 0.0_wp, highest = 0.0_wp
        !> without adhesion, at the lowest s: F or d, a less the end radius, k; and the powers of s they follow below it
        real(wp) :: end_values(column_count) = 0.0_wp
        real(wp) :: powers(column_count) = 0.0_wp
        type(table_segment_t), allocatable :: segments(:)
        type(interval_t), allocatable :: intervals(:)
        !> (coefficient_count, column_count, panels)
        real(wp), allocatable :: coefficients(:, :, :)
    end type law_table_t

contains

    !> The interval in which the state of a branch at s <= highest lies; below_range or no_contact where there is none.
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

    !> The segment on which the state of a branch at s lies, 0 if there is none.
    pure function segment_for(self, branch, s) result(segment)
        type(law_table_t), intent(in) :: self
        integer, intent(in) :: branch
        real(wp), intent(in) :: s
        integer :: segment
        integer :: i

        segment = 0
        if (branch == on_loading .and. s < 0.0_wp) return
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

    !> F(d) or d(F) in an interval.
    pure function value_in(self, interval, s) result(value)
        type(law_table_t), intent(in) :: self
        integer, intent(in) :: interval
        real(wp), intent(in) :: s
        real(wp) :: value
        type(place_t) :: place

        place = interval_place(self%intervals(interval), s)
        value = polynomial(self%coefficients(:, other_column, place%panel), place%t)
    end function value_in

    !> F or d, its derivative with respect to s along the branch, a and k in an interval.
    pure subroutine values_in(self, interval, s, other, slope, radius, stiffness)
        type(law_table_t), intent(in) :: self
        integer, intent(in) :: interval
        real(wp), intent(in) :: s
        real(wp), intent(out) :: other, slope, radius, stiffness
        type(place_t) :: place

        place = interval_place(self%intervals(interval), s)
        other = polynomial(self%coefficients(:, other_column, place%panel), place%t)
        slope = polynomial_slope(self%coefficients(:, other_column, place%panel), place%t) &
                *interval_rate(self%intervals(interval), s)
        radius = polynomial(self%coefficients(:, radius_column, place%panel), place%t)
        stiffness = polynomial(self%coefficients(:, stiffness_column, place%panel), place%t)
    end subroutine values_in

    !> The same between first touch and the compiled range: powers of s that continue value and slope.
    pure subroutine values_below(self, s, other, slope, radius, stiffness)
        type(law_table_t), intent(in) :: self
        real(wp), intent(in) :: s
        real(wp), intent(out) :: other, slope, radius, stiffness
        real(wp) :: part(column_count)

        part = self%end_values*(s/self%lowest)**self%powers
        other = part(other_column)
        slope = self%powers(other_column)*other/s
        radius = self%end_radius + part(radius_column)
        stiffness = part(stiffness_column)
    end subroutine values_below

    !> The table in which s and the other quantity are a factor larger at the same radius and stiffness.
    pure subroutine scale_table(self, factor)
        type(law_table_t), intent(inout) :: self
        !> > 0
        real(wp), intent(in) :: factor
        integer :: i

        self%lowest = factor*self%lowest
        self%highest = factor*self%highest
        self%end_values(other_column) = factor*self%end_values(other_column)
        self%segments%lowest = factor*self%segments%lowest
        self%segments%highest = factor*self%segments%highest
        self%coefficients(:, other_column, :) = factor*self%coefficients(:, other_column, :)
        do i = 1, size(self%intervals)
            call scale_interval(self%intervals(i), factor)
        end do
    end subroutine scale_table

end module mdrcontact_law_table
