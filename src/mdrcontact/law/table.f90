! SPDX-License-Identifier: GPL-3.0-or-later
!> One direction of a compiled law: depth to force (a, k), or force to depth (a, k), on every stable stretch of the branch.
module mdrcontact_law_table
    use mdrcontact_contact, only: on_loading
    use mdrcontact_kinds, only: wp
    use mdrcontact_law_segment, only: coefficient_count, column_count, place_t, polynomial, polynomial_slope, segment_place, &
                                      segment_rate, segment_t
    implicit none (type, external)
    private
    public :: law_table_t, table_stretch_t
    public :: segment_for, stretch_for, segment_in, below_range, no_contact
    public :: value_in, values_in, values_below

    !> What segment_for says where there is no segment: below the compiled range of a contact without adhesion; open.
    integer, parameter :: below_range = -1, no_contact = 0
    !> Columns.
    integer, parameter :: other_column = 1, radius_column = 2, stiffness_column = 3

    !> A stable stretch: s grows from lowest to highest with the contact radius, through the segments first to last.
    type :: table_stretch_t
        real(wp) :: lowest = 0.0_wp, highest = 0.0_wp
        integer :: first = 1, last = 1
    end type table_stretch_t

    !> One direction of a law: segments, panels and their polynomials.
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
        type(table_stretch_t), allocatable :: stretches(:)
        type(segment_t), allocatable :: segments(:)
        !> (coefficient_count, column_count, panels)
        real(wp), allocatable :: coefficients(:, :, :)
    end type law_table_t

contains

    !> The segment in which the state of a branch at s <= highest lies; below_range or no_contact where there is none.
    pure function segment_for(self, branch, s) result(segment)
        type(law_table_t), intent(in) :: self
        !> on_loading or on_unloading
        integer, intent(in) :: branch
        real(wp), intent(in) :: s
        integer :: segment
        integer :: stretch

        stretch = stretch_for(self, branch, s)
        if (stretch > 0) then
            segment = segment_in(self, stretch, s)
        else if (self%adhesive .or. s <= 0.0_wp) then
            segment = no_contact
        else
            segment = below_range
        end if
    end function segment_for

    !> The stretch on which the state of a branch at s lies, 0 if there is none.
    pure function stretch_for(self, branch, s) result(stretch)
        type(law_table_t), intent(in) :: self
        integer, intent(in) :: branch
        real(wp), intent(in) :: s
        integer :: stretch
        integer :: i

        stretch = 0
        if (branch == on_loading .and. s < 0.0_wp) return
        do i = 1, size(self%stretches)
            if (s < self%stretches(i)%lowest .or. s > self%stretches(i)%highest) cycle
            stretch = i
            if (branch == on_loading) return
        end do
    end function stretch_for

    !> The segment of a stretch that contains s.
    pure function segment_in(self, stretch, s) result(segment)
        type(law_table_t), intent(in) :: self
        integer, intent(in) :: stretch
        real(wp), intent(in) :: s
        integer :: segment
        integer :: low, high, middle

        low = self%stretches(stretch)%first
        high = self%stretches(stretch)%last
        do while (low < high)
            middle = (low + high)/2
            if (s > self%segments(middle)%highest) then
                low = middle + 1
            else
                high = middle
            end if
        end do
        segment = low
    end function segment_in

    !> F(d) or d(F) in a segment.
    pure function value_in(self, segment, s) result(value)
        type(law_table_t), intent(in) :: self
        integer, intent(in) :: segment
        real(wp), intent(in) :: s
        real(wp) :: value
        type(place_t) :: place

        place = segment_place(self%segments(segment), s)
        value = polynomial(self%coefficients(:, other_column, place%panel), place%t)
    end function value_in

    !> F or d, its derivative with respect to s along the branch, a and k in a segment.
    pure subroutine values_in(self, segment, s, other, slope, radius, stiffness)
        type(law_table_t), intent(in) :: self
        integer, intent(in) :: segment
        real(wp), intent(in) :: s
        real(wp), intent(out) :: other, slope, radius, stiffness
        type(place_t) :: place

        place = segment_place(self%segments(segment), s)
        other = polynomial(self%coefficients(:, other_column, place%panel), place%t)
        slope = polynomial_slope(self%coefficients(:, other_column, place%panel), place%t)*segment_rate(self%segments(segment), s)
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

end module mdrcontact_law_table
