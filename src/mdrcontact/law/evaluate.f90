! SPDX-License-Identifier: GPL-3.0-or-later
!> Values of one direction of a compiled law, one by one and in batches.
module mdrcontact_law_evaluate
    use mdrcontact_batch, only: team_size
    use mdrcontact_contact, only: on_loading
    use mdrcontact_kinds, only: wp
    use mdrcontact_law_interval, only: polynomial, interval_place, place_t
    use mdrcontact_law_table, only: below_range, law_table_t, no_contact, interval_for, value_in, values_below, values_in
    implicit none (type, external)
    private
    public :: law_point_t, value_at, point_at, values_of, all_of

    !> A state of the law.
    type :: law_point_t
        !> d [length]
        real(wp) :: depth = 0.0_wp
        !> F [modulus length^2]
        real(wp) :: force = 0.0_wp
        !> dF/dd along the branch [modulus length]; infinite slopes at pull-off are cut off at a large number
        real(wp) :: slope = 0.0_wp
        !> a [length]
        real(wp) :: radius = 0.0_wp
        !> k = 2 a E_eff(a), the stiffness at constant radius [modulus length]; without adhesion it equals the slope
        real(wp) :: stiffness = 0.0_wp
    end type law_point_t

    !> Points that a thread takes at a time, and the number of points below which one thread does them all.
    integer, parameter :: block_size = 512, smallest_parallel = 128*block_size

contains

    !> F(d) or d(F) at s <= highest; 0 where the bodies are apart.
    pure function value_at(table, branch, s) result(value)
        type(law_table_t), intent(in) :: table
        integer, intent(in) :: branch
        real(wp), intent(in) :: s
        real(wp) :: value
        real(wp) :: slope, radius, stiffness
        integer :: interval

        interval = interval_for(table, branch, s)
        if (interval > 0) then
            value = value_in(table, interval, s)
        else if (interval == below_range) then
            call values_below(table, s, value, slope, radius, stiffness)
        else
            value = 0.0_wp
        end if
    end function value_at

    !> F or d, its slope, a and k at s <= highest; all 0 where the bodies are apart.
    pure subroutine point_at(table, branch, s, other, slope, radius, stiffness)
        type(law_table_t), intent(in) :: table
        integer, intent(in) :: branch
        real(wp), intent(in) :: s
        real(wp), intent(out) :: other, slope, radius, stiffness
        integer :: interval

        interval = interval_for(table, branch, s)
        if (interval > 0) then
            call values_in(table, interval, s, other, slope, radius, stiffness)
        else if (interval == below_range) then
            call values_below(table, s, other, slope, radius, stiffness)
        else
            other = 0.0_wp
            slope = 0.0_wp
            radius = 0.0_wp
            stiffness = 0.0_wp
        end if
    end subroutine point_at

    !> value_at for many points, on `threads` threads (0: as many as the runtime offers). Called from within a parallel region it
    !> stays on the calling thread.
    subroutine values_of(table, branch, s, values, threads)
        type(law_table_t), intent(in) :: table
        integer, intent(in) :: branch
        real(wp), intent(in) :: s(:)
        !> same size as s
        real(wp), intent(out) :: values(:)
        integer, intent(in) :: threads
        integer :: first, last, team

        team = team_size(size(s), smallest_parallel, threads)
        !$omp parallel do schedule(static) num_threads(team) private(last) default(shared)
        do first = 1, size(s), block_size
            last = min(first + block_size - 1, size(s))
            call block_of_values(table, branch, last - first + 1, s(first:last), values(first:last))
        end do
        !$omp end parallel do
    end subroutine values_of

    !> point_at for many points.
    subroutine all_of(table, branch, s, other, slope, radius, stiffness, threads)
        type(law_table_t), intent(in) :: table
        integer, intent(in) :: branch
        real(wp), intent(in) :: s(:)
        !> same size as s
        real(wp), intent(out) :: other(:), slope(:), radius(:), stiffness(:)
        integer, intent(in) :: threads
        integer :: i, team

        team = team_size(size(s), smallest_parallel, threads)
        !$omp parallel do schedule(static) num_threads(team) default(shared)
        do i = 1, size(s)
            call point_at(table, branch, s(i), other(i), slope(i), radius(i), stiffness(i))
        end do
        !$omp end parallel do
    end subroutine all_of

    !> A block of points, most of which lie on one interval in the usual case.
    pure subroutine block_of_values(table, branch, n, s, values)
        type(law_table_t), intent(in) :: table
        integer, intent(in) :: branch, n
        real(wp), intent(in) :: s(n)
        real(wp), intent(out) :: values(n)
        type(place_t) :: place
        real(wp) :: least
        integer :: i

        least = table%lowest
        if (branch == on_loading) least = max(least, 0.0_wp)
        if (size(table%intervals) == 1) then
            associate (interval => table%intervals(1), c => table%coefficients)
                do i = 1, n
                    place = interval_place(interval, s(i))
                    values(i) = polynomial(c(:, 1, place%panel), place%t)
                end do
                do i = 1, n
                    if (s(i) < least) values(i) = value_at(table, branch, s(i))
                end do
            end associate
        else
            do i = 1, n
                values(i) = value_at(table, branch, s(i))
            end do
        end if
    end subroutine block_of_values

end module mdrcontact_law_evaluate
