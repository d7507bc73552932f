! SPDX-License-Identifier: GPL-3.0-or-later
!> Work on many entries, on one thread or several: the same numbers and the same error, however many threads there are.
!>
!> The caller sets the number of threads; nothing is remembered between calls. Called from within a parallel region, all stays on
!> the calling thread.
module mdrcontact_batch
    use, intrinsic :: iso_c_binding, only: c_int64_t, c_null_ptr, c_ptr
    use, intrinsic :: iso_fortran_env, only: int64
    use mdrcontact_cancel, only: check_cancelled, help_team, lead_team, stop_team
    use mdrcontact_error, only: count_text, error_cancelled, error_invalid, error_t, raise
    use mdrcontact_kinds, only: wp
    !$ use omp_lib, only: omp_get_max_threads, omp_get_num_procs, omp_in_parallel
    implicit none (type, external)
    private
    public :: batch_t, map_t, run_batch, run_map, team_size, check_threads

    !> The operation on each entry. It is shared by the threads: results go to arrays it points to. (It is passed as intent(inout):
    !> of an intent(in) argument gfortran 12 takes what its pointers point to as unchangedalso.)
    type, abstract :: batch_t
        !> entries of some nanoseconds: the cancel function is not called
        logical :: is_quick = .false.
        !> entries of some microseconds, also in arrays of some hundred
        logical :: is_short = .false.
    contains
        procedure(entries), deferred :: work
    end type batch_t

    !> A function of one number, for arrays. No value may depend on its index in the array.
    type, abstract :: map_t
    contains
        procedure(mapped), deferred :: values
    end type map_t

    abstract interface
        !> Does entries first to last in ascending order, up to the first that fails.
        subroutine entries(self, first, last, error)
            import :: batch_t, error_t
            class(batch_t), intent(inout) :: self
            integer, intent(in) :: first, last
            type(error_t), allocatable, intent(out) :: error
        end subroutine entries

        pure subroutine mapped(self, x, y)
            import :: map_t, wp
            class(map_t), intent(in) :: self
            real(wp), intent(in) :: x(:)
            !> same size as x
            real(wp), intent(out) :: y(:)
        end subroutine mapped
    end interface

    interface
        !> A thread of a team may round otherwise than the one that started it: arithmetic.h.
        subroutine mdrcontact_set_arithmetic(before) bind(C)
            import :: c_int64_t
            integer(c_int64_t), intent(out) :: before(16)
        end subroutine mdrcontact_set_arithmetic

        subroutine mdrcontact_set_arithmetic_back(before) bind(C)
            import :: c_int64_t
            integer(c_int64_t), intent(in) :: before(16)
        end subroutine mdrcontact_set_arithmetic_back
    end interface

    type, extends(batch_t) :: map_batch_t
        class(map_t), pointer :: map => null()
        real(wp), pointer, contiguous :: x(:) => null(), y(:) => null()
    contains
        procedure :: work => map_entries
    end type map_batch_t

    !> Points of a function of some nanoseconds that a thread takes at a time, and from how many on several threads pay.
    integer, parameter :: map_block = 2048, map_smallest = 16384
    !> More threads gain nothing, and where the system cannot start them the OpenMP runtime ends the program.
    !$ integer, parameter :: most_per_processor = 4
    !> Seconds of rest from which several threads pay: where the caller leaves their number to OpenMP, and for short entries.
    !> Threads of OpenMP spin for some hundredths of a second when they have nothing to do.
    real(wp), parameter :: long_rest = 0.3_wp, short_rest = 1.0e-2_wp
    !> The rest is estimated from work of this part of it.
    real(wp), parameter :: seen = 0.03_wp

contains

    !> Works on entries 1 to n, `block` at a time, on several threads from `smallest` entries on. Where entries fail, the error is
    !> that of the first of them.
    subroutine run_batch(batch, n, block, smallest, threads, error)
        class(batch_t), intent(inout) :: batch
        integer, intent(in) :: n, block, smallest
        !> at least 1, or 0 for as many as OpenMP offers from where the rest takes long
        integer, intent(in) :: threads
        type(error_t), allocatable, intent(inout) :: error
        integer :: i, blocks, team, failed, done
        type(c_ptr) :: helped
        integer(c_int64_t) :: before(16)

        if (allocated(error) .or. n < 1) return
        blocks = (n - 1)/block + 1
        team = min(team_size(n, smallest, threads), blocks)
        done = 0
        if (team == 1) then
            call run_alone(batch, n, block, huge(1.0_wp), done, error)
        else if (threads == 0 .and. .not. batch%is_quick) then
            call run_alone(batch, n, block, long_rest, done, error)
        else if (batch%is_short) then
            call run_alone(batch, n, block, short_rest, done, error)
        end if
        if (allocated(error) .or. done == blocks) return
        failed = blocks + 1
        ! Dynamic: blocks begin in ascending order, and those after a failed one need not begin.
        helped = lead_team()
        !$omp parallel num_threads(team) default(shared) private(before)
        call mdrcontact_set_arithmetic(before)
        call help_team(helped)
        !$omp do schedule(dynamic)
        do i = done + 1, blocks
            call run_block(batch, i, (i - 1)*block + 1, last_of(i, block, n), failed, helped, error)
        end do
        !$omp end do
        call help_team(c_null_ptr)
        call mdrcontact_set_arithmetic_back(before)
        !$omp end parallel
    end subroutine run_batch

    !> Blocks on the calling thread, up to the one that fails, or to where the rest takes longer than `most_rest`.
    subroutine run_alone(batch, n, block, most_rest, done, error)
        class(batch_t), intent(inout) :: batch
        integer, intent(in) :: n, block
        !> seconds; huge: all blocks
        real(wp), intent(in) :: most_rest
        !> number of blocks
        integer, intent(out) :: done
        type(error_t), allocatable, intent(inout) :: error
        integer(int64) :: began, now, rate
        integer :: blocks
        real(wp) :: seconds, before, longest

        blocks = (n - 1)/block + 1
        if (most_rest < huge(1.0_wp)) call system_clock(began, rate)
        done = 0
        seconds = 0.0_wp
        longest = 0.0_wp
        do while (done < blocks)
            done = done + 1
            call batch%work((done - 1)*block + 1, last_of(done, block, n), error)
            if (.not. (allocated(error) .or. batch%is_quick)) call check_cancelled(error)
            if (allocated(error)) return
            if (.not. most_rest < huge(1.0_wp)) cycle
            call system_clock(now)
            before = seconds
            seconds = real(now - began, wp)/real(rate, wp)
            ! the system may have interrupted the longest block
            longest = max(longest, seconds - before)
            if (seconds < seen*most_rest .or. done == 1) cycle
            if ((seconds - longest)*(blocks - done) > most_rest*(done - 1)) return
        end do
    end subroutine run_alone

    !> The last entry of a block: i*block itself may exceed every integer.
    pure function last_of(i, block, n) result(last)
        integer, intent(in) :: i, block, n
        integer :: last

        last = (i - 1)*block
        last = last + min(block, n - last)
    end function last_of

    !> One block, unless an earlier one has failed.
    subroutine run_block(batch, number, first, last, failed, helped, error)
        class(batch_t), intent(inout) :: batch
        integer, intent(in) :: number, first, last
        !> Number of the earliest block that has failed, and its error. Both are shared by the threads: without `target` flang 22
        !> reads `failed` in the critical section from a register.
        integer, intent(inout), target :: failed
        !> the team of the caller's thread, the only one with a cancel function
        type(c_ptr), intent(in) :: helped
        type(error_t), allocatable, intent(inout), target :: error
        type(error_t), allocatable :: found
        integer :: earliest

        !$omp atomic read
        earliest = failed
        if (earliest < number) return
        call batch%work(first, last, found)
        if (.not. (allocated(found) .or. batch%is_quick)) call check_cancelled(found)
        if (.not. allocated(found)) return
        if (found%code == error_cancelled) call stop_team(helped)
        !$omp critical (mdrcontact_batch_failed)
        if (number < failed) then
            !$omp atomic write
            failed = number
            call move_alloc(found, error)
        end if
        !$omp end critical (mdrcontact_batch_failed)
    end subroutine run_block

    !> A quick function at many points.
    subroutine run_map(map, x, y, threads)
        class(map_t), intent(in), target :: map
        real(wp), intent(in), target, contiguous :: x(:)
        !> same size as x
        real(wp), intent(inout), target, contiguous :: y(:)
        integer, intent(in) :: threads
        type(map_batch_t) :: batch
        type(error_t), allocatable :: error

        batch%is_quick = .true.
        batch%map => map
        batch%x => x
        batch%y => y
        call run_batch(batch, size(x), map_block, map_smallest, threads, error)
    end subroutine run_map

    subroutine map_entries(self, first, last, error)
        class(map_batch_t), intent(inout) :: self
        integer, intent(in) :: first, last
        type(error_t), allocatable, intent(out) :: error

        call self%map%values(self%x(first:last), self%y(first:last))
    end subroutine map_entries

    !> Number of threads for a number of entries.
    function team_size(n, smallest, threads) result(team)
        integer, intent(in) :: n, smallest, threads
        integer :: team

        team = 1
        if (n < smallest) return
        !$ team = threads
        !$ if (threads == 0) team = omp_get_max_threads()
        !$ team = min(team, most_per_processor*omp_get_num_procs())
        !$ if (omp_in_parallel()) team = 1
        associate (unused => threads)
        end associate
    end function team_size

    !> Raises unless `threads` is a number of threads, or 0.
    pure subroutine check_threads(error, threads)
        type(error_t), allocatable, intent(inout) :: error
        integer, intent(in) :: threads

        if (threads < 0) then
            call raise(error, error_invalid, "threads = "//count_text(threads)//": it must be at least 1, or 0 for the number "// &
                       "that OpenMP offers")
        end if
    end subroutine check_threads

end module mdrcontact_batch
