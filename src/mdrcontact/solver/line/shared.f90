! SPDX-License-Identifier: GPL-3.0-or-later
!> Data shared by exact media that are created one after the other: the waves of the kernel's tabulation, and
!> the kernel itself where only the unit of length changes. It belongs to what makes the media; media do not refer to it.
module mdrcontact_line_shared
    use mdrcontact_error, only: error_t
    use mdrcontact_kinds, only: wp
    use mdrcontact_line_kernel, only: kernel_t
    use mdrcontact_body_compliance, only: compliance_t
    use mdrcontact_line_tabulate, only: attempts, elastic_misfit, tabulate_kernel
    use mdrcontact_line_waves, only: wave_table_t
    use mdrcontact_tension_table, only: punch_table_t
    implicit none (type, external)
    private
    public :: kernel_cache_t, shared_kernel

    !> A trial, its neighbours in two moduli, and the trial before.
    integer, parameter :: most_kernels = 4

    !> A kernel and the numbers that determine it.
    type :: kept_kernel_t
        type(kernel_t) :: kernel
        real(wp), allocatable :: key(:)
    end type kept_kernel_t

    !> Empty at first, and filled as media are made. Not for several threads at a time.
    type :: kernel_cache_t
        !> flat punches under surface tension; none before the first half-space with it
        type(punch_table_t), allocatable :: punches
        !> none before the first medium
        type(wave_table_t), allocatable, private :: tables(:)
        !> the kernels made last, and the one to be overwritten next
        type(kept_kernel_t), allocatable, private :: kernels(:)
        integer, private :: oldest = 1
    end type kernel_cache_t

contains

    !> The kernel of a compliance: that of one made before where both are the same but for their size.
    subroutine shared_kernel(shared, surface, kernel, error, allowed)
        type(kernel_cache_t), intent(inout) :: shared
        class(compliance_t), intent(in) :: surface
        type(kernel_t), intent(out) :: kernel
        type(error_t), allocatable, intent(out) :: error
        !> largest error of the table of chi, in parts of its largest value; default: as little as of an elastic body
        real(wp), intent(in), optional :: allowed
        real(wp), allocatable :: key(:)
        real(wp) :: misfit
        integer :: i

        call surface%key(key, error)
        if (allocated(error)) return
        if (.not. allocated(shared%kernels)) allocate (shared%tables(attempts), shared%kernels(most_kernels))
        do i = 1, most_kernels
            if (is_same(shared%kernels(i), key)) exit
        end do
        if (i > most_kernels) then
            i = shared%oldest
            if (allocated(shared%kernels(i)%key)) deallocate (shared%kernels(i)%key)
            misfit = elastic_misfit
            if (present(allowed)) misfit = allowed
            call tabulate_kernel(shared%kernels(i)%kernel, surface, shared%tables, misfit, error)
            if (allocated(error)) return
            call move_alloc(key, shared%kernels(i)%key)
            shared%oldest = modulo(i, most_kernels) + 1
        end if
        kernel = shared%kernels(i)%kernel
        if (.not. kernel%vanishes) kernel%unit = surface%first_depth
    end subroutine shared_kernel

    pure function is_same(kept, key) result(answer)
        type(kept_kernel_t), intent(in) :: kept
        real(wp), intent(in) :: key(:)
        logical :: answer

        answer = .false.
        if (.not. allocated(kept%key) .or. size(key) == 0) return
        if (size(kept%key) == size(key)) answer = all(kept%key == key)
    end function is_same

end module mdrcontact_line_shared
