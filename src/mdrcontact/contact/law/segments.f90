! SPDX-License-Identifier: GPL-3.0-or-later
!> The stable segments of a sampled branch, cut where it is not analytic, and compiled.
module mdrcontact_law_segments
    use mdrcontact_contact_adhesive_branch, only: stable_segment_t
    use mdrcontact_contact_samples, only: samples_t
    use mdrcontact_error, only: error_invalid, error_t, raise
    use mdrcontact_kinds, only: wp
    use mdrcontact_law_compile, only: compile_pieces, control_of, piece_t
    use mdrcontact_law_table, only: law_table_t
    use mdrcontact_numerics_scalar_function, only: scalar_function_t
    implicit none (type, external)
    private
    public :: compile_segments, move_to_folds, fold_margin

    !> The samples reach this far beyond a fold, so that it can be found on them; the search interval.
    real(wp), parameter :: fold_margin = 0.06_wp, search_width = 0.04_wp
    !> A break closer to an end of a segment than this is merged with it.
    real(wp), parameter :: no_room = 1.0e-9_wp

contains

    !> Moves the ends of the segments of an adhesive contact to the extrema of its samples, and marks those that end at one.
    subroutine move_to_folds(table, curve, list, ends_at_fold, error)
        type(law_table_t), intent(in) :: table
        class(samples_t), intent(in) :: curve
        !> by ascending coordinate
        type(stable_segment_t), intent(inout) :: list(:)
        logical, allocatable, intent(out) :: ends_at_fold(:)
        type(error_t), allocatable, intent(out) :: error
        real(wp) :: range_end
        integer :: i

        range_end = curve%edges(size(curve%edges))
        ends_at_fold = list%last < range_end - fold_margin
        do i = 1, size(list)
            call move_to_fold(table, curve, 1.0_wp, list(i)%first, error)
            if (.not. allocated(error) .and. ends_at_fold(i)) call move_to_fold(table, curve, -1.0_wp, list(i)%last, error)
            if (allocated(error)) return
            list(i)%last = min(list(i)%last, range_end)
        end do
    end subroutine move_to_folds

    !> Compiles the segments under one control.
    subroutine compile_segments(table, curve, list, ends_at_fold, breaks, tolerance, error, conductance)
        type(law_table_t), intent(inout) :: table
        class(samples_t), intent(in) :: curve
        !> by ascending coordinate, within the samples
        type(stable_segment_t), intent(in) :: list(:)
        !> whether s has an extremum at the end of each
        logical, intent(in) :: ends_at_fold(:)
        !> coordinates where indenter or medium are not analytic
        real(wp), intent(in) :: breaks(:)
        real(wp), intent(in) :: tolerance
        type(error_t), allocatable, intent(out) :: error
        !> G(a), for a law that conducts
        class(scalar_function_t), intent(inout), optional :: conductance
        type(piece_t), allocatable :: pieces(:)
        real(wp), allocatable :: cuts(:)
        integer :: i, j

        do i = 1, size(list)
            cuts = [list(i)%first, pack(breaks, breaks > list(i)%first + no_room .and. breaks < list(i)%last - no_room), &
                    list(i)%last]
            if (allocated(pieces)) deallocate (pieces)
            allocate (pieces(size(cuts) - 1))
            do j = 1, size(pieces)
                pieces(j) = piece_t(cuts(j), cuts(j + 1), table%adhesive .or. j > 1, ends_at_fold(i) .and. j == size(pieces))
            end do
            pieces(1)%from_nothing = table%adhesive .and. cuts(1) <= curve%edges(1)
            call compile_pieces(table, curve, pieces, tolerance, error, conductance)
            if (allocated(error)) return
        end do
    end subroutine compile_segments

    !> The extremum of s on the samples near x: a minimum for side = 1, a maximum for side = -1.
    subroutine move_to_fold(table, curve, side, x, error)
        type(law_table_t), intent(in) :: table
        class(samples_t), intent(in) :: curve
        real(wp), intent(in) :: side
        real(wp), intent(inout) :: x
        type(error_t), allocatable, intent(out) :: error
        real(wp) :: low, high

        low = x - search_width
        high = x + search_width
        if (side*curve%slope(control_of(table), low) >= 0.0_wp .or. side*curve%slope(control_of(table), high) <= 0.0_wp) then
            call raise(error, error_invalid, "contact: a stable segment of its branch does not begin at an extremum of depth "// &
                       "or force, so it cannot be compiled")
            return
        end if
        call curve%turn(control_of(table), low, high, x, error)
    end subroutine move_to_fold

end module mdrcontact_law_segments
