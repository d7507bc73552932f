! SPDX-License-Identifier: GPL-3.0-or-later
!> Some of many positions, where a part of them is evaluated apart: pack and unpack take memory without a status.
module mdrcontact_numerics_pick
    use mdrcontact_error, only: check_memory, error_t
    use mdrcontact_kinds, only: wp
    implicit none (type, external)
    private
    public :: pick

contains

    !> The x above or below a limit; nothing happens after an error.
    pure subroutine pick(x, places, picked, values, error, above, below)
        real(wp), intent(in) :: x(:)
        !> where they are in x, in ascending order
        integer, allocatable, intent(out) :: places(:)
        !> they themselves, and room for as many results
        real(wp), allocatable, intent(out) :: picked(:), values(:)
        type(error_t), allocatable, intent(inout) :: error
        !> one of them: the limit, not itself among the picked
        real(wp), intent(in), optional :: above, below
        integer :: i, n, stat

        if (allocated(error)) return
        n = 0
        do i = 1, size(x)
            if (is_meant(x(i))) n = n + 1
        end do
        allocate (places(n), picked(n), values(n), stat=stat)
        call check_memory(error, stat)
        if (allocated(error)) return
        n = 0
        do i = 1, size(x)
            if (.not. is_meant(x(i))) cycle
            n = n + 1
            places(n) = i
            picked(n) = x(i)
        end do

    contains

        pure function is_meant(x) result(answer)
            real(wp), intent(in) :: x
            logical :: answer

            if (present(above)) then
                answer = x > above
            else
                answer = x < below
            end if
        end function is_meant

    end subroutine pick

end module mdrcontact_numerics_pick
