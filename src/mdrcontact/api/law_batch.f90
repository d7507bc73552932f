! SPDX-License-Identifier: GPL-3.0-or-later
!> Compiled contact laws for C: arrays of points.
module mdrcontact_api_law_batch
    use, intrinsic :: iso_c_binding, only: c_double, c_int, c_ptr
    use mdrcontact_api_arrays, only: check_array, check_count
    use mdrcontact_api_handles, only: open_handle
    use mdrcontact_api_status, only: check_memory, status_of, wanted_threads
    use mdrcontact_error, only: error_t, error_unreachable, raise, raise_at, to_text
    use mdrcontact_contact, only: check_branch
    use mdrcontact_law, only: check_below, contact_law_t, lowest_force
    use mdrcontact_law_evaluate, only: all_of, values_of
    use mdrcontact_law_table, only: law_table_t
    implicit none (type, external)
    private
    public :: mdr_law_from_depth, mdr_law_from_force

contains

    function mdr_law_from_depth(law, branch, n, d, f, slope, a, k) result(status) bind(C)
        type(c_ptr), value :: law
        integer(c_int), value :: branch, n
        real(c_double), intent(in), optional :: d(*)
        real(c_double), intent(inout), optional :: f(*), slope(*), a(*), k(*)
        integer(c_int) :: status
        type(contact_law_t), pointer :: inside
        type(error_t), allocatable :: error

        call open_handle(law, "law", inside, error)
        call check_call(error, branch, n, "d", present(d))
        if (.not. allocated(error) .and. n > 0) then
            call check_all(error, "depth", d(:n), -huge(1.0_c_double), inside%by_depth%highest)
            if (.not. allocated(error)) then
                call evaluate(inside%by_depth, int(branch), int(n), d, f, slope, a, k, wanted_threads(), error)
            end if
        end if
        status = status_of(error)
    end function mdr_law_from_depth

    function mdr_law_from_force(law, branch, n, f, d, compliance, a, k) result(status) bind(C)
        type(c_ptr), value :: law
        integer(c_int), value :: branch, n
        real(c_double), intent(in), optional :: f(*)
        real(c_double), intent(inout), optional :: d(*), compliance(*), a(*), k(*)
        integer(c_int) :: status
        type(contact_law_t), pointer :: inside
        type(error_t), allocatable :: error

        call open_handle(law, "law", inside, error)
        call check_call(error, branch, n, "F", present(f))
        if (.not. allocated(error) .and. n > 0) then
            call check_all(error, "force", f(:n), lowest_force(inside, int(branch)), inside%by_force%highest)
            if (.not. allocated(error)) then
                call evaluate(inside%by_force, int(branch), int(n), f, d, compliance, a, k, wanted_threads(), error)
            end if
        end if
        status = status_of(error)
    end function mdr_law_from_force

    pure subroutine check_call(error, branch, n, name, is_given)
        type(error_t), allocatable, intent(inout) :: error
        integer(c_int), intent(in) :: branch, n
        character(len=*), intent(in) :: name
        logical, intent(in) :: is_given

        call check_branch(error, int(branch))
        call check_count(error, n)
        call check_array(error, name, n, is_given)
    end subroutine check_call

    !> Every point, before anything is written.
    pure subroutine check_all(error, name, s, lowest, highest)
        type(error_t), allocatable, intent(inout) :: error
        character(len=*), intent(in) :: name
        real(c_double), intent(in) :: s(:), lowest, highest
        integer :: i, outside

        outside = 0
        do i = 1, size(s)
            outside = outside + merge(0, 1, s(i) >= lowest .and. s(i) <= highest)
        end do
        if (outside == 0) return
        do i = 1, size(s)
            call check_below(error, name, s(i), highest)
            if (.not. allocated(error) .and. s(i) < lowest) then
                call raise(error, error_unreachable, " = "//to_text(s(i))// &
                           " cannot be reached: no contact carries less than "//to_text(lowest), name)
            end if
            if (.not. allocated(error)) cycle
            call raise_at(error, i)
            return
        end do
    end subroutine check_all

    !> One polynomial a point where only the first quantity is asked for.
    subroutine evaluate(table, branch, n, s, other, slope, a, k, threads, error)
        type(law_table_t), intent(in) :: table
        integer, intent(in) :: branch, n, threads
        real(c_double), intent(in) :: s(n)
        real(c_double), intent(inout), optional :: other(n), slope(n), a(n), k(n)
        type(error_t), allocatable, intent(inout) :: error
        real(c_double), allocatable :: unwanted(:, :)
        integer :: stat

        if (.not. (present(slope) .or. present(a) .or. present(k))) then
            if (present(other)) call values_of(table, branch, s, other, threads)
        else if (present(other) .and. present(slope) .and. present(a) .and. present(k)) then
            call all_of(table, branch, s, other, slope, a, k, threads)
        else
            allocate (unwanted(n, 4), stat=stat)
            call check_memory(error, stat)
            if (allocated(error)) return
            call all_of(table, branch, s, unwanted(:, 1), unwanted(:, 2), unwanted(:, 3), unwanted(:, 4), threads)
            if (present(other)) other = unwanted(:, 1)
            if (present(slope)) slope = unwanted(:, 2)
            if (present(a)) a = unwanted(:, 3)
            if (present(k)) k = unwanted(:, 4)
        end if
    end subroutine evaluate

end module mdrcontact_api_law_batch
