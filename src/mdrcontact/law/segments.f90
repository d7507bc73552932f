! SPDX-License-Identifier: GPL-3.0-or-later
!> The stable segments of a sampled branch, cut where it is not analytic, and compiled.
module mdrcontact_law_segments
    use mdrcontact_contact_adhesive_branch, only: stable_segment_t
    use mdrcontact_contact_curve, only: curve_t
    use mdrcontact_error, only: error_invalid, error_t, raise
    use mdrcontact_kinds, only: wp
    use mdrcontact_law_compile, only: compile_pieces, control_of, piece_t
    use mdrcontact_law_table, only: law_table_t
    use mdrcontact_numerics_scalar_function, only: scalar_function_t
    implicit none (type, external)
    private
    public :: compile_segments, fold_margin

    !> The samples reach this far beyond a fold, so that it can be found on them; the search interval.
    real(wp), parameter :: fold_margin = 0.06_wp, search_width = 0.04_wp

contains

    !> Compiles the segments under one control; their ends are moved to the extrema of the samples.
    subroutine compile_segments(table, curve, list, breaks, tolerance, error, conductance)
        type(law_table_t), intent(inout) :: table
        type(curve_t), intent(in) :: curve
        !> by ascending coordinate
        type(stable_segment_t), intent(inout) :: list(:)
        !> coordinates where indenter or medium are not analytic
        real(wp), intent(in) :: breaks(:)
        real(wp), intent(in) :: tolerance
        type(error_t), allocatable, intent(out) :: error
        !> G(a), for a law that conducts
        class(scalar_function_t), intent(inout), optional :: conductance
        type(piece_t), allocatable :: pieces(:)
        real(wp), allocatable :: cuts(:)
        real(wp) :: range_end
        integer :: i, j
        logical :: ends_at_fold

        range_end = curve%edges(size(curve%edges))
        do i = 1, size(list)
            if (table%adhesive) then
                call move_to_fold(table, curve, 1.0_wp, list(i)%first, error)
                if (allocated(error)) return
            end if
            ends_at_fold = list(i)%last < range_end - fold_margin .and. table%adhesive
            if (ends_at_fold) call move_to_fold(table, curve, -1.0_wp, list(i)%last, error)
            if (allocated(error)) return
            list(i)%last = min(list(i)%last, range_end)
            cuts = [list(i)%first, pack(breaks, breaks > list(i)%first .and. breaks < list(i)%last), list(i)%last]
            if (allocated(pieces)) deallocate (pieces)
            allocate (pieces(size(cuts) - 1))
            do j = 1, size(pieces)
                pieces(j) = piece_t(cuts(j), cuts(j + 1), table%adhesive .or. j > 1, ends_at_fold .and. j == size(pieces))
            end do
            call compile_pieces(table, curve, pieces, tolerance, error, conductance)
            if (allocated(error)) return
        end do
    end subroutine compile_segments

    !> The extremum of s on the samples near x: a minimum for side = 1, a maximum for side = -1.
    subroutine move_to_fold(table, curve, side, x, error)
        type(law_table_t), intent(in) :: table
        type(curve_t), intent(in) :: curve
        real(wp), intent(in) :: side
        real(wp), intent(inout) :: x
        type(error_t), allocatable, intent(out) :: error
        real(wp) :: low, high

        low = x - search_width
        high = x + search_width
        if (side*curve%slope(control_of(table), low) >= 0.0_wp .or. side*curve%slope(control_of(table), high) <= 0.0_wp) then
            call raise(error, error_invalid, "this adhesive contact cannot be compiled: a stable segment of its "// &
                       "branch does not begin at an extremum of depth or force")
            return
        end if
        call curve%turn(control_of(table), low, high, x, error)
    end subroutine move_to_fold

end module mdrcontact_law_segments
