! SPDX-License-Identifier: GPL-3.0-or-later
!> Hankel integrals of the layers' states: int p_hat(k) y(k, z) J_n(k r) dk and the like, at single points or on grids of r and z.
!>
!> A prepared integral contains layers and load; points and grids then cost sums over its nodes, on a grid as products of matrices.
module mdrcontact_inside_hankel
    use, intrinsic :: iso_c_binding, only: c_size_t
    use mdrcontact_batch, only: batch_t, run_batch
    use mdrcontact_cancel, only: check_cancelled
    use mdrcontact_error, only: check_memory, error_t
    use mdrcontact_inside_half_space, only: shear_sums
    use mdrcontact_medium_load, only: load_t
    use mdrcontact_inside_states, only: depth_t, normal_rows, shear_rows, states_t
    use mdrcontact_inside_transform, only: hankel_transform
    use mdrcontact_inside_waves, only: faded, first_panel, part_of_waves
    use mdrcontact_gsl, only: gsl_sort_index
    use mdrcontact_kinds, only: wp
    use mdrcontact_lapack, only: dgemm
    use mdrcontact_numerics_bessel, only: bessel_t, new_bessel
    use mdrcontact_numerics_search, only: interval_of
    use mdrcontact_numerics_waves, only: wave_rule
    implicit none (type, external)
    private
    public :: hankel_t, part_t, new_hankel, twin_hankel, add_point, add_grid

    !> Wavenumbers, radii and depths that are worked on together. OpenBLAS starts threads from products of 2^18 on.
    integer, parameter :: slab = 256, radii = 25, together = 40

    !> A body (lengths in units of a) under a load, ready to be integrated for r <= farthest - 1 and k <= last: part after part of
    !> the wavenumbers, so that no more memory is needed for many layers.
    type :: hankel_t
        class(states_t), pointer :: states => null()
        type(bessel_t), allocatable :: bessel
        !> wavenumbers and p_hat dk of the part
        real(wp), allocatable :: k(:), load(:)
        !> of all parts, and how many of them are known
        real(wp), allocatable :: all_k(:), all_load(:)
        integer :: done = 0
    contains
        procedure :: next_part
    end type hankel_t

    !> The integrals of one load, of which others share the nodes.
    type :: part_t
        type(hankel_t), pointer :: hankel => null()
        !> its sums are those after this one
        integer :: before = 0
    end type part_t

    !> A slab of wavenumbers of a grid: first the states at all depths, then their products with the Bessel functions.
    type, extends(batch_t) :: grid_t
        type(part_t), allocatable :: parts(:)
        type(depth_t), pointer :: depths(:) => null()
        real(wp), pointer :: r(:) => null(), sums(:, :, :) => null()
        integer, pointer :: place(:) => null()
        !> (node, depth in the order of `place`, sum)
        real(wp), allocatable :: columns(:, :, :)
        integer :: first = 0, last = 0, active = 0
        logical :: is_bessel = .false.
    contains
        procedure :: work => grid_work
    end type grid_t

contains

    !> Nodes and weights of the integrals over wavenumber, for one load on one body.
    subroutine new_hankel(self, load, states, farthest, last, error)
        type(hankel_t), intent(out) :: self
        class(load_t), intent(in) :: load
        class(states_t), intent(inout), target :: states
        !> largest a + r [a] and largest wavenumber [1/a]
        real(wp), intent(in) :: farthest, last
        type(error_t), allocatable, intent(inout) :: error
        real(wp), allocatable :: weight(:)

        self%states => states
        allocate (self%bessel)
        call new_bessel(self%bessel)
        call wave_rule(first_panel/max(farthest, states%structure), last, farthest, self%all_k, weight, error)
        if (allocated(error)) return
        allocate (self%all_load(size(self%all_k)))
        call hankel_transform(load, self%all_k/load%radius, self%all_load, error)
        if (allocated(error)) return
        self%all_load(:) = self%all_load*weight/load%radius**2
    end subroutine new_hankel

    !> The same for the load in another direction.
    subroutine twin_hankel(self, states, other)
        type(hankel_t), intent(out) :: self
        class(states_t), intent(inout), target :: states
        type(hankel_t), intent(in) :: other

        self%states => states
        self%bessel = other%bessel
        self%all_k = other%all_k
        self%all_load = other%all_load
    end subroutine twin_hankel

    !> Goes to the next part of the wavenumbers; false if it does not exist, or an error.
    function next_part(self, error) result(found)
        class(hankel_t), intent(inout) :: self
        type(error_t), allocatable, intent(inout) :: error
        logical :: found
        integer :: n

        found = self%done < size(self%all_k) .and. .not. allocated(error)
        if (.not. found) return
        call check_cancelled(error)
        n = min(size(self%all_k) - self%done, part_of_waves(self%states%steps))
        self%k = self%all_k(self%done + 1:self%done + n)
        self%load = self%all_load(self%done + 1:self%done + n)
        self%done = self%done + n
        if (.not. allocated(error)) call self%states%prepare(self%k, error)
        found = .not. allocated(error)
    end function next_part

    !> Number of nodes for a depth.
    pure function wave_count(self, depth) result(number)
        type(hankel_t), intent(in) :: self
        type(depth_t), intent(in) :: depth
        integer :: number

        number = 0
        if (self%k(1) <= depth%last) number = interval_of(self%k, depth%last)
        if (self%k(size(self%k)) <= depth%last) number = size(self%k)
    end function wave_count

    !> Numbers of sums with J0, J1/r and J2/r^2, in this order.
    pure function groups(self) result(sizes)
        type(hankel_t), intent(in) :: self
        integer :: sizes(0:2)

        sizes = merge([2, 4, 2], [3, 2, 0], self%states%along_surface)
    end function groups

    !> Factors of the Bessel functions in each sum, times p_hat dk: (node, sum). The last shear sum is with J2 itself.
    pure subroutine weighted_state(self, depth, first, last, columns)
        type(hankel_t), intent(in) :: self
        type(depth_t), intent(in) :: depth
        !> requested nodes
        integer, intent(in) :: first, last
        real(wp), intent(out) :: columns(:, :)
        real(wp) :: y(last - first + 1, merge(shear_rows, normal_rows, self%states%along_surface))
        integer :: i

        call self%states%state(depth, first, last, y)
        do i = 1, size(y, 2)
            y(:, i) = self%load(first:last)*y(:, i)
        end do
        associate (k => self%k(first:last))
            if (self%states%along_surface) then
                columns(:, 1) = y(:, 5) - y(:, 1)
                columns(:, 2) = k*(y(:, 6) - y(:, 3))
                columns(:, 3) = y(:, 2)
                columns(:, 4) = k*y(:, 4)
                columns(:, 5) = k*y(:, 1)
                columns(:, 6) = k*y(:, 5)
                columns(:, 7) = y(:, 5) + y(:, 1)
                columns(:, 8) = k*(y(:, 6) + y(:, 3))
            else
                columns(:, 1) = y(:, 2)
                columns(:, 2) = k*y(:, 4)
                columns(:, 3) = k*y(:, 1)
                columns(:, 4) = y(:, 1)
                columns(:, 5) = k*y(:, 3)
            end if
        end associate
    end subroutine weighted_state

    !> J0, J1/r and J2/r^2 at nodes first to last: (node, order).
    pure subroutine bessel_table(self, along_surface, r, first, last, j)
        type(hankel_t), intent(in) :: self
        !> whether J2 is needed
        logical, intent(in) :: along_surface
        real(wp), intent(in) :: r
        integer, intent(in) :: first, last
        real(wp), intent(out) :: j(first:, 0:)

        if (along_surface) then
            call self%bessel%at(self%k(first:last), r, j(:, 0), j(:, 1), j(:, 2))
        else
            call self%bessel%at(self%k(first:last), r, j(:, 0), j(:, 1))
        end if
    end subroutine bessel_table

    !> Adds the sums at one point.
    pure subroutine add_point(self, depth, r, sums)
        type(hankel_t), intent(in) :: self
        type(depth_t), intent(in) :: depth
        real(wp), intent(in) :: r
        real(wp), intent(inout) :: sums(:)
        integer, parameter :: block = 128
        real(wp) :: columns(block, size(sums)), j(block, 0:3), part(size(sums))
        integer :: first, last, waves, n, i

        waves = wave_count(self, depth)
        do first = 1, waves, block
            last = min(first + block - 1, waves)
            n = last - first + 1
            call weighted_state(self, depth, first, last, columns(:n, :))
            call bessel_table(self, self%states%along_surface, r, first, last, j(:n, :))
            part = 0.0_wp
            if (self%states%along_surface) then
                ! J2/r^2 to J2 for the last one
                j(:n, 3) = j(:n, 2)*r**2
                do i = 1, n
                    part = part + j(i, [0, 0, 1, 1, 1, 1, 2, 3])*columns(i, :)
                end do
            else
                do i = 1, n
                    part = part + j(i, [0, 0, 0, 1, 1])*columns(i, :)
                end do
            end if
            sums = sums + part
        end do
    end subroutine add_point

    !> Adds the sums on a grid of radii and depths, by threads.
    subroutine add_grid(parts, depths, r, sums, threads, error)
        !> of the same nodes
        type(part_t), intent(in) :: parts(:)
        type(depth_t), intent(in), target :: depths(:)
        real(wp), intent(in), target :: r(:)
        !> (radius, sum, depth)
        real(wp), intent(inout), target :: sums(:, :, :)
        integer, intent(in) :: threads
        type(error_t), allocatable, intent(inout) :: error
        type(grid_t) :: grid
        integer, allocatable, target :: place(:)
        integer(c_size_t), allocatable :: order(:)
        real(wp), allocatable :: last(:)
        integer :: first, waves, stat

        grid%is_short = .true.
        allocate (grid%parts, source=parts)
        grid%depths => depths
        grid%r => r
        grid%sums => sums
        ! deepest reach in k first: those that need a slab are the first ones
        allocate (order(size(depths)), last(size(depths)), place(size(depths)), grid%columns(slab, size(depths), size(sums, 2)), &
                  stat=stat)
        call check_memory(error, stat)
        if (stat /= 0) return
        last = -depths%last
        call gsl_sort_index(order, last, 1_c_size_t, size(order, kind=c_size_t))
        place = int(order) + 1
        grid%place => place
        associate (hankel => parts(1)%hankel)
            waves = wave_count(hankel, depths(place(1)))
            do first = 1, waves, slab
                grid%first = first
                grid%last = min(first + slab - 1, waves)
                grid%active = count(depths%last >= hankel%k(first))
                grid%is_bessel = .false.
                call run_batch(grid, grid%active, 4, 8, threads, error)
                grid%is_bessel = .true.
                call run_batch(grid, size(r), radii, 2*radii, threads, error)
                if (allocated(error)) return
            end do
        end associate
    end subroutine add_grid

    subroutine grid_work(self, first, last, error)
        class(grid_t), intent(inout) :: self
        integer, intent(in) :: first, last
        type(error_t), allocatable, intent(out) :: error
        integer :: i, j, n

        if (self%is_bessel) then
            do i = first, last, radii
                call multiply(self, i, min(i + radii - 1, last), error)
                if (allocated(error)) return
            end do
        else
            do i = first, last
                associate (depth => self%depths(self%place(i)))
                    n = min(wave_count(self%parts(1)%hankel, depth), self%last) - self%first + 1
                    self%columns(n + 1:, i, :) = 0.0_wp
                    do j = 1, size(self%parts)
                        associate (hankel => self%parts(j)%hankel, before => self%parts(j)%before)
                            call weighted_state(hankel, depth, self%first, self%first + n - 1, &
                                                self%columns(:n, i, before + 1:before + sum(groups(hankel))))
                        end associate
                    end do
                end associate
            end do
        end if
    end subroutine grid_work

    !> The radii from first to last of a slab: the Bessel functions, then the sums of each load.
    subroutine multiply(self, first, last, error)
        class(grid_t), intent(inout) :: self
        integer, intent(in) :: first, last
        type(error_t), allocatable, intent(inout) :: error
        real(wp), allocatable :: j(:, :, :)
        logical :: along_surface
        integer :: i, m, stat

        m = last - first + 1
        allocate (j(self%last - self%first + 1, m, 0:2), stat=stat)
        call check_memory(error, stat)
        if (stat /= 0) return
        along_surface = .false.
        do i = 1, size(self%parts)
            along_surface = along_surface .or. self%parts(i)%hankel%states%along_surface
        end do
        do i = 1, m
            call bessel_table(self%parts(1)%hankel, along_surface, self%r(first + i - 1), self%first, self%last, j(:, i, :))
        end do
        do i = 1, size(self%parts)
            call multiply_part(self, self%parts(i), first, last, j)
        end do
    end subroutine multiply

    !> Products of matrices for every sum of a load, so small that no BLAS starts threads for them.
    subroutine multiply_part(self, part, first, last, j)
        class(grid_t), intent(inout) :: self
        type(part_t), intent(in) :: part
        integer, intent(in) :: first, last
        !> (node, radius, order); J2/r^2 becomes J2
        real(wp), intent(inout) :: j(self%last - self%first + 1, last - first + 1, 0:2)
        real(wp) :: product(radii, together)
        integer :: i, n, m, deep, count, place, order, group(0:2)

        n = self%last - self%first + 1
        m = last - first + 1
        group = groups(part%hankel)
        place = part%before
        do order = 0, 2
            do i = 1, group(order)
                place = place + 1
                if (place - part%before == shear_sums) call times_square(self%r(first:last), j(:, :, order))
                do deep = 1, self%active, together
                    count = min(together, self%active - deep + 1)
                    call dgemm("T", "N", m, count, n, 1.0_wp, j(1, 1, order), n, self%columns(1, deep, place), slab, 0.0_wp, &
                               product, radii)
                    call add_product(product(:m, :count), self%place(deep:deep + count - 1), self%sums(first:last, place, :))
                end do
            end do
        end do
    end subroutine multiply_part

    !> J2/r^2 to J2, for the last shear sum.
    pure subroutine times_square(r, j)
        real(wp), intent(in) :: r(:)
        !> (node, radius)
        real(wp), intent(inout) :: j(:, :)
        integer :: i

        do i = 1, size(r)
            j(:, i) = j(:, i)*r(i)**2
        end do
    end subroutine times_square

    pure subroutine add_product(product, place, sums)
        real(wp), intent(in) :: product(:, :)
        !> which depth each column is
        integer, intent(in) :: place(:)
        !> (radius, depth)
        real(wp), intent(inout) :: sums(:, :)
        integer :: i

        do i = 1, size(place)
            sums(:, place(i)) = sums(:, place(i)) + product(:, i)
        end do
    end subroutine add_product

end module mdrcontact_inside_hankel
