! SPDX-License-Identifier: GPL-3.0-or-later
!> Values of one direction of a compiled law, one by one and in batches.
module mdrcontact_law_evaluate
    use, intrinsic :: iso_c_binding, only: c_double, c_int, c_int64_t, c_loc, c_null_ptr, c_ptr
    use mdrcontact_batch, only: batch_t, run_batch
    use mdrcontact_contact, only: on_loading, on_unloading
    use mdrcontact_error, only: error_t
    use mdrcontact_kinds, only: wp
    use mdrcontact_law_interval, only: shift_of
    use mdrcontact_law_table, only: below_range, energy_below, energy_in, interval_for, law_table_t, no_contact, values_below, &
                                    values_in
    implicit none (type, external)
    private
    public :: law_view_t, last_open, point_at, point_in, energy_at, run_points, count_within, wanted_t

    !> struct mdr_law_view of include/mdrcontact_law.h.
    type, bind(C) :: law_view_t
        !> s at the ends of the interval in which nothing has to be searched for; lowest > highest if it does not exist
        real(c_double) :: lowest = 1.0_c_double, highest = -1.0_c_double
        real(c_double) :: scale = 0.0_c_double, offset = 0.0_c_double
        !> bits of y that number the panel, and the bit of its middle
        integer(c_int64_t) :: mask = 0_c_int64_t, half = 0_c_int64_t
        !> first coefficients of F or d, and of a and k; first energy, by depth
        type(c_ptr) :: force = c_null_ptr, contact = c_null_ptr, energy = c_null_ptr
        !> all of the law, as contact/law/pack.f90 writes it; not needed within the interval
        type(c_ptr) :: buffer = c_null_ptr
        integer(c_int) :: branch = on_unloading, shift = 0_c_int
        !> up to for separated bodies
        real(c_double) :: open = -huge(1.0_c_double)
    end type law_view_t

    !> Where values at points go; null: not requested. Pointers, as absent arrays of assumed shape cannot be handed on without a
    !> descriptor of nothing.
    type :: wanted_t
        !> the force at depths or the depth under forces, its slope
        real(wp), pointer, contiguous :: other(:) => null(), slope(:) => null()
        !> contact radius and contact stiffness
        real(wp), pointer, contiguous :: radius(:) => null(), stiffness(:) => null()
    end type wanted_t

    !> Points of a table.
    type, extends(batch_t) :: points_t
        type(law_table_t), pointer :: table => null()
        type(law_view_t) :: view
        !> whether all points lie within the view
        logical :: all_direct = .false.
        real(wp), pointer, contiguous :: s(:) => null()
        type(wanted_t) :: wanted
    contains
        procedure :: work
    end type points_t

    !> Points that a thread takes at a time, and the number of points below which one thread does them all.
    integer, parameter :: block_size = 4096, smallest_parallel = 16*block_size

    interface
        !> Points within the view, the others moved to its ends: src/mdrcontact/contact/law/kernel.c.
        pure subroutine mdrcontact_law_points(view, n, s, other, slope, radius, stiffness) bind(C)
            import :: c_int, c_ptr, law_view_t
            type(law_view_t), intent(in) :: view
            integer(c_int), intent(in), value :: n
            type(c_ptr), intent(in), value :: s, other, slope, radius, stiffness
        end subroutine mdrcontact_law_points
    end interface

contains

    !> The interval of a table, which must outlive the view, in which nothing has to be searched for.
    function direct_view(table, branch) result(view)
        type(law_table_t), intent(in), target :: table
        !> on_loading or on_unloading
        integer, intent(in) :: branch
        type(law_view_t) :: view

        view%branch = int(branch, c_int)
        if (table%direct%lowest > table%direct%highest) return
        view%lowest = table%direct%lowest
        view%highest = table%direct%highest
        view%scale = table%direct%scale
        view%offset = table%direct%offset
        view%shift = int(shift_of(table%direct), c_int)
        view%half = shiftl(1_c_int64_t, shift_of(table%direct) - 1)
        view%mask = not(2_c_int64_t*view%half - 1_c_int64_t)
        view%force = c_loc(table%other(1)%c)
        view%contact = c_loc(table%contact(1)%radius%c)
    end function direct_view

    !> The largest s at which the bodies are separated.
    pure function last_open(table, branch) result(s)
        type(law_table_t), intent(in) :: table
        integer, intent(in) :: branch
        real(wp) :: s

        s = 0.0_wp
        if (.not. table%adhesive) return
        s = nearest(max(table%lowest, merge(table%first_attraction, table%lowest, branch == on_loading)), -1.0_wp)
    end function last_open

    !> F or d, its slope, a and k at finite s, which is at most the highest unless the table is continued; all 0 for separated
    !> bodies. Beyond the range a and k are those at its end.
    pure subroutine point_at(table, branch, s, other, slope, radius, stiffness)
        type(law_table_t), intent(in) :: table
        integer, intent(in) :: branch
        real(wp), intent(in) :: s
        real(wp), intent(out) :: other, slope, radius, stiffness

        call point_in(table, interval_for(table, branch, min(s, table%highest)), s, other, slope, radius, stiffness)
    end subroutine point_at

    !> point_at where the interval is known, as interval_for returns at the lesser of s and the highest.
    pure subroutine point_in(table, interval, s, other, slope, radius, stiffness)
        type(law_table_t), intent(in) :: table
        integer, intent(in) :: interval
        real(wp), intent(in) :: s
        real(wp), intent(out) :: other, slope, radius, stiffness
        real(wp) :: within

        within = min(s, table%highest)
        if (interval > 0) then
            call values_in(table, interval, within, other, slope, radius, stiffness)
            if (s > within) other = other + slope*(s - within)
        else if (interval == below_range) then
            call values_below(table, s, other, slope, radius, stiffness)
        else
            other = 0.0_wp
            slope = 0.0_wp
            radius = 0.0_wp
            stiffness = 0.0_wp
        end if
    end subroutine point_in

    !> int F dd along the branch, from initial contact or, with adhesion, from pull-off; 0 for separated bodies.
    pure function energy_at(table, interval, s) result(energy)
        !> by depth
        type(law_table_t), intent(in) :: table
        !> as interval_for returns at the lesser of s and the highest depth
        integer, intent(in) :: interval
        real(wp), intent(in) :: s
        real(wp) :: energy
        real(wp) :: within, force, slope, radius, stiffness

        energy = 0.0_wp
        if (interval == below_range) energy = energy_below(table, s)
        if (interval <= no_contact) return
        within = min(s, table%highest)
        energy = energy_in(table, interval, within)
        if (s <= within) return
        call values_in(table, interval, within, force, slope, radius, stiffness)
        energy = energy + (force + 0.5_wp*slope*(s - within))*(s - within)
    end function energy_at

    !> point_at for many points, on `threads` threads (0: as many as the runtime offers); what is not given is not computed.
    subroutine run_points(table, branch, s, all_direct, threads, wanted)
        type(law_table_t), intent(in), target :: table
        integer, intent(in) :: branch
        real(wp), intent(in), target, contiguous :: s(:)
        !> whether all points lie in the table's direct interval
        logical, intent(in) :: all_direct
        integer, intent(in) :: threads
        !> same size as s
        type(wanted_t), intent(in) :: wanted
        type(points_t) :: points
        type(error_t), allocatable :: unused

        points%is_quick = .true.
        points%table => table
        points%view = direct_view(table, branch)
        points%all_direct = all_direct
        points%s => s
        points%wanted = wanted
        call run_batch(points, size(s), block_size, smallest_parallel, threads, unused)
    end subroutine run_points

    !> Number of values between two limits: a loop that is vectorized; no NaN does.
    pure function count_within(s, lowest, highest) result(inside)
        real(wp), intent(in) :: s(:), lowest, highest
        integer :: inside
        integer :: i

        inside = 0
        do i = 1, size(s)
            inside = inside + merge(1, 0, s(i) >= lowest .and. s(i) <= highest)
        end do
    end function count_within

    subroutine work(self, first, last, error)
        class(points_t), intent(inout) :: self
        integer, intent(in) :: first, last
        type(error_t), allocatable, intent(out) :: error
        real(wp) :: other, slope, radius, stiffness
        integer :: i

        associate (view => self%view, wanted => self%wanted)
            if (view%lowest <= view%highest) then
                call mdrcontact_law_points(view, last - first + 1, c_loc(self%s(first)), place(wanted%other, first), &
                                           place(wanted%slope, first), place(wanted%radius, first), place(wanted%stiffness, first))
            end if
            if (self%all_direct) return
            do i = first, last
                if (self%s(i) >= view%lowest .and. self%s(i) <= view%highest) cycle
                call point_at(self%table, int(view%branch), self%s(i), other, slope, radius, stiffness)
                if (associated(wanted%other)) wanted%other(i) = other
                if (associated(wanted%slope)) wanted%slope(i) = slope
                if (associated(wanted%radius)) wanted%radius(i) = radius
                if (associated(wanted%stiffness)) wanted%stiffness(i) = stiffness
            end do
        end associate
    end subroutine work

    !> Where entry i of an array lies; null for no array.
    function place(array, i) result(pointer)
        real(wp), pointer, intent(in) :: array(:)
        integer, intent(in) :: i
        type(c_ptr) :: pointer

        pointer = c_null_ptr
        if (associated(array)) pointer = c_loc(array(i))
    end function place

end module mdrcontact_law_evaluate
