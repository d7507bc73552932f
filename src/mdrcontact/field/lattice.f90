! SPDX-License-Identifier: GPL-3.0-or-later
!> Which points share a radius and which a depth: a grid of few distinct ones costs far less than as many scattered points.
module mdrcontact_field_lattice
    use, intrinsic :: iso_c_binding, only: c_size_t
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
    subroutine new_lattice(self, r, z)
        type(lattice_t), intent(out) :: self
        !> same size [length]
        real(wp), intent(in) :: r(:), z(:)
        integer, allocatable :: rows(:), columns(:)

        allocate (self%row(size(r)), self%column(size(r)))
        call distinct(r, rows, self%row)
        call distinct(z, columns, self%column)
        self%is_grid = real(size(rows), wp)*real(size(columns), wp) < 4.0_wp*real(size(r), wp) .and. size(rows) > 1
    end subroutine new_lattice

    !> The distinct ones of some values: where each occurs first, and which one each value is.
    subroutine distinct(values, first, which)
        real(wp), intent(in) :: values(:)
        integer, allocatable, intent(out) :: first(:)
        !> same size as values
        integer, intent(out) :: which(:)
        integer(c_size_t), allocatable :: order(:)
        integer :: i, n, count

        n = period(values)
        allocate (first(n), order(n))
        if (all(values(2:n) >= values(:n - 1))) then
            order = [(int(i, c_size_t), i=0, n - 1)]
        else
            call gsl_sort_index(order, values, 1_c_size_t, int(n, c_size_t))
        end if
        count = 0
        do i = 1, n
            associate (here => int(order(i)) + 1)
                if (count == 0) then
                    count = 1
                    first(1) = here
                else if (values(here) > values(first(count))) then
                    count = count + 1
                    first(count) = here
                end if
                which(here) = count
            end associate
        end do
        first = first(:count)
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

    !> The same for some of the values, from which ones they all are.
    pure subroutine distinct_among(which, first, among)
        !> of the values meant
        integer, intent(in) :: which(:)
        integer, allocatable, intent(out) :: first(:)
        !> same size as which
        integer, intent(out) :: among(:)
        integer :: place(maxval(which)), i, count

        place = 0
        count = 0
        allocate (first(size(place)))
        do i = 1, size(which)
            if (place(which(i)) == 0) then
                count = count + 1
                place(which(i)) = count
                first(count) = i
            end if
            among(i) = place(which(i))
        end do
        first = first(:count)
    end subroutine distinct_among

end module mdrcontact_field_lattice
