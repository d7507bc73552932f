! SPDX-License-Identifier: GPL-3.0-or-later
!> Many states of a compiled law, on one thread or several.
module mdrcontact_law_values
    use mdrcontact_batch, only: batch_t, check_threads, run_batch
    use mdrcontact_error, only: count_text, error_invalid, error_t, raise, raise_at
    use mdrcontact_kinds, only: wp
    use mdrcontact_law, only: contact_law_t, law_point_t
    implicit none (type, external)
    private
    public :: law_points_from_depth, law_points_from_force

    type, extends(batch_t) :: law_batch_t
        type(contact_law_t), pointer :: law => null()
        logical :: by_depth = .true.
        integer, allocatable :: branch
        real(wp), pointer :: input(:) => null()
        type(law_point_t), pointer :: points(:) => null()
    contains
        procedure :: work
    end type law_batch_t

    integer, parameter :: block_size = 512, smallest_parallel = 16*block_size

contains

    !> law%at_depth for many depths. Where some fail, the error is that of the first, and `points` is undefined.
    subroutine law_points_from_depth(law, depths, points, error, branch, threads)
        type(contact_law_t), intent(in) :: law
        !> [length]
        real(wp), intent(in) :: depths(:)
        !> same size as depths
        type(law_point_t), intent(inout) :: points(:)
        type(error_t), allocatable, intent(out) :: error
        !> on_loading or on_unloading (default)
        integer, intent(in), optional :: branch
        !> at least 1 (default), or 0 for as many as OpenMP offers; few points stay on one
        integer, intent(in), optional :: threads

        call run(law, .true., depths, points, error, branch, threads)
    end subroutine law_points_from_depth

    !> law%at_force for many forces, as law_points_from_depth.
    subroutine law_points_from_force(law, forces, points, error, branch, threads)
        type(contact_law_t), intent(in) :: law
        !> [modulus length^2]
        real(wp), intent(in) :: forces(:)
        !> same size as forces
        type(law_point_t), intent(inout) :: points(:)
        type(error_t), allocatable, intent(out) :: error
        !> on_loading or on_unloading (default)
        integer, intent(in), optional :: branch
        !> at least 1 (default), or 0 for as many as OpenMP offers; few points stay on one
        integer, intent(in), optional :: threads

        call run(law, .false., forces, points, error, branch, threads)
    end subroutine law_points_from_force

    subroutine run(law, by_depth, input, points, error, branch, threads)
        type(contact_law_t), intent(in), target :: law
        logical, intent(in) :: by_depth
        real(wp), intent(in), target :: input(:)
        type(law_point_t), intent(inout), target :: points(:)
        type(error_t), allocatable, intent(out) :: error
        integer, intent(in), optional :: branch, threads
        type(law_batch_t) :: batch
        integer :: team

        team = 1
        if (present(threads)) team = threads
        call check_threads(error, team)
        if (size(input) /= size(points)) then
            call raise(error, error_invalid, "the arrays have "//count_text(size(input))//" and "//count_text(size(points))// &
                       " entries: they must have the same number")
        end if
        if (allocated(error)) return
        batch%law => law
        batch%by_depth = by_depth
        if (present(branch)) batch%branch = branch
        batch%input => input
        batch%points => points
        call run_batch(batch, size(input), block_size, smallest_parallel, team, error)
    end subroutine run

    subroutine work(self, first, last, error)
        class(law_batch_t), intent(inout) :: self
        integer, intent(in) :: first, last
        type(error_t), allocatable, intent(out) :: error
        integer :: i

        do i = first, last
            if (self%by_depth) then
                call self%law%at_depth(self%input(i), self%points(i), error, self%branch)
            else
                call self%law%at_force(self%input(i), self%points(i), error, self%branch)
            end if
            if (.not. allocated(error)) cycle
            call raise_at(error, i)
            return
        end do
    end subroutine work

end module mdrcontact_law_values
