! SPDX-License-Identifier: GPL-3.0-or-later
!> Which points share a radius and which a depth: a grid of few distinct ones costs far less than as many scattered points.
module mdrcontact_inside_lattice
    use, intrinsic :: iso_c_binding, only: c_size_t
    use mdrcontact_error, only: check_memory, error_t
    use mdrcontact_gsl, only: gsl_sort_index
    use mdrcontact_kinds, only: wp
    implicit none (type, external)
    private
    public :: lattice_t, new_lattice, distinct, distinct_among

    !> The distinct radius and depth of each point, counted in ascending order.
    type :: lattice_t
        integer, allocatable :: row(:), column(:)
        !> a product of matrices over the distinct radii and depths does less than sums at every point
        logical :: is_grid = .false.
    end type lattice_t

contains

    !> The lattice of points (r, z).
    subroutine new_lattice(self, r, z, error)
        type(lattice_t), intent(out) :: self
        !> same size [length]
        real(wp), intent(in) :: r(:), z(:)
        type(error_t), allocatable, intent(inout) :: error
        integer, allocatable :: rows(:), columns(:)
        integer :: stat

        allocate (self%row(size(r)), self%column(size(r)), stat=stat)
        call check_memory(error, stat)
        call distinct(r, rows, self%row, error)
        call distinct(z, columns, self%column, error)
        if (allocated(error)) return
        self%is_grid = real(size(rows), wp)*real(size(columns), wp) < 4.0_wp*real(size(r), wp) .and. size(rows) > 1
    end subroutine new_lattice

    !> The distinct ones of some values: where each occurs first, and which one each value is.
    subroutine distinct(values, first, which, error)
        real(wp), intent(in) :: values(:)
        integer, allocatable, intent(out) :: first(:)
        !> same size as values
        integer, intent(inout) :: which(:)
        type(error_t), allocatable, intent(inout) :: error
        integer(c_size_t), allocatable :: order(:)
        integer :: i, n, count, last, stat

        if (allocated(error)) return
        n = period(values)
        allocate (order(n), stat=stat)
        call check_memory(error, stat)
        if (stat /= 0) return
        if (all(values(2:n) >= values(:n - 1))) then
            do i = 1, n
                order(i) = int(i - 1, c_size_t)
            end do
        else
            call gsl_sort_index(order, values, 1_c_size_t, int(n, c_size_t))
        end if
        count = min(n, 1)
        last = 1
        do i = 1, n
            associate (here => int(order(i)) + 1)
                if (i == 1) last = here
                if (values(here) > values(last)) then
                    count = count + 1
                    last = here
                end if
                which(here) = count
            end associate
        end do
        allocate (first(count), stat=stat)
        call check_memory(error, stat)
        if (stat /= 0) return
        do i = n, 1, -1
            first(which(order(i) + 1)) = int(order(i)) + 1
        end do
        do i = n + 1, size(values)
            which(i) = which(i - n)
        end do
    end subroutine distinct

    !> After how many values they repeat, as one coordinate of a grid does; their number if they do not.
    pure function period(values) result(n)
        real(wp), intent(in) :: values(:)
        integer :: n
        integer :: i

        n = size(values)
        do i = 2, size(values)
            if (values(i) < values(1) .or. values(i) > values(1)) cycle
            if (all(values(i:) >= values(:size(values) - i + 1) .and. values(i:) <= values(:size(values) - i + 1))) n = i - 1
            exit
        end do
    end function period

    !> The same for chosen ones of the values, from which ones they all are: where each occurs first among all values, and which one
    !> each chosen value is.
    pure subroutine distinct_among(which, chosen, first, among, error)
        integer, intent(in) :: which(:), chosen(:)
        !> both allocated here; the second has the size of chosen
        integer, allocatable, intent(out) :: first(:), among(:)
        type(error_t), allocatable, intent(inout) :: error
        integer, allocatable :: place(:)
        integer :: i, count, stat

        if (allocated(error)) return
        allocate (place(maxval(which)), among(size(chosen)), stat=stat)
        call check_memory(error, stat)
        if (stat /= 0) return
        place = 0
        count = 0
        do i = 1, size(chosen)
            if (place(which(chosen(i))) == 0) then
                count = count + 1
                place(which(chosen(i))) = count
            end if
            among(i) = place(which(chosen(i)))
        end do
        allocate (first(count), stat=stat)
        call check_memory(error, stat)
        if (stat /= 0) return
        do i = size(chosen), 1, -1
            first(among(i)) = chosen(i)
        end do
    end subroutine distinct_among

end module mdrcontact_inside_lattice
