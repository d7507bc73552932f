! SPDX-License-Identifier: GPL-3.0-or-later
!> A structure given by voxels: the phase of every cell of a regular array, a micrograph or a tomogram (theory/lateral.md (2.9)).
module mdrcontact_lateral_voxels
    use mdrcontact_error, only: check_count_within, check_finite, check_made, check_memory, check_not_negative, check_poisson, &
                                check_positive, count_text, error_invalid, error_t, raise
    use mdrcontact_kinds, only: pi, wp
    use mdrcontact_lateral_cells, only: cell_weights
    use mdrcontact_lateral_slab, only: in_radii, new_slab, slab_t
    use mdrcontact_lateral_structure, only: structure_t
    use mdrcontact_material, only: material_t
    use mdrcontact_numerics_power_mean, only: new_power_mean, power_mean_t
    implicit none (type, external)
    private
    public :: voxels_t, new_voxels

    real(wp), parameter :: two_pi = 2.0_wp*pi
    !> Periods that count cell by cell, and their cells in a slice.
    integer, parameter :: most_images = 100
    real(wp), parameter :: most_cells = 2.0_wp**30

    !> Cell (i, j, k) fills origin + spacing*[i-1 ... i, j-1 ... j] and the depths spacing(3)*(k-1 ... k).
    type, extends(structure_t) :: voxels_t
        private
        integer, allocatable :: labels(:, :, :)
        !> G and nu of each phase
        real(wp), allocatable :: shear(:), poisson(:)
        real(wp) :: spacing(3) = 0.0_wp, origin(2) = 0.0_wp
        logical :: periodic = .true.
        integer :: images = 1
        !> what lies below the array and, unless it is periodic, next to it
        type(material_t) :: below, beside
    contains
        procedure :: means
    end type voxels_t

contains

    !> Voxels with the given phases over a half-space `below`.
    subroutine new_voxels(self, labels, phases, spacing, below, error, beside, origin, images, reference_nu, exponent)
        type(voxels_t), intent(out) :: self
        !> (nx, ny, nz) number of the phase, 1 to size(phases)
        integer, intent(in) :: labels(:, :, :)
        type(material_t), intent(in) :: phases(:)
        !> edge lengths of a cell > 0 [length]
        real(wp), intent(in) :: spacing(3)
        type(material_t), intent(in) :: below
        type(error_t), allocatable, intent(out) :: error
        !> what lies next to the array; default: the array repeats itself in x and y
        type(material_t), intent(in), optional :: beside
        !> x and y of the array's lower corner; default 0 [length]
        real(wp), intent(in), optional :: origin(2)
        !> periodic only: how many periods in each direction count cell by cell; beyond them each slice counts with its mean.
        !> 1 to 100, default 1
        integer, intent(in), optional :: images
        !> Poisson's ratio of the weights; default: the mean over all voxels
        real(wp), intent(in), optional :: reference_nu
        !> of the mean of G, -1 (series) to 1 (parallel); default 1
        real(wp), intent(in), optional :: exponent
        type(power_mean_t) :: mean
        integer :: i, stat

        call check_made(error, "phases", all(phases%young > 0.0_wp))
        call check_made(error, "below", below%young > 0.0_wp)
        if (present(beside)) call check_made(error, "beside", beside%young > 0.0_wp)
        if (allocated(error)) return
        do i = 1, 3
            call check_positive(error, "spacing "//count_text(i), spacing(i))
        end do
        if (size(labels) == 0 .or. size(phases) == 0) call raise(error, error_invalid, "voxels or phases: the array is empty")
        if (allocated(error)) return
        if (minval(labels) < 1 .or. maxval(labels) > size(phases)) then
            call raise(error, error_invalid, "labels from "//count_text(minval(labels))//" to "//count_text(maxval(labels))// &
                       ": there are phases 1 to "//count_text(size(phases)))
        end if
        if (allocated(error)) return
        allocate (self%labels, source=labels, stat=stat)
        if (stat == 0) allocate (self%shear(size(phases)), stat=stat)
        if (stat == 0) allocate (self%poisson(size(phases)), stat=stat)
        call check_memory(error, stat)
        if (allocated(error)) return
        do i = 1, size(phases)
            self%shear(i) = phases(i)%shear()
            self%poisson(i) = phases(i)%poisson
        end do
        self%spacing = spacing
        self%below = below
        self%periodic = .not. present(beside)
        self%beside = below
        if (present(beside)) self%beside = beside
        if (present(origin)) self%origin = origin
        if (present(images)) self%images = images
        do i = 1, 2
            call check_finite(error, "origin "//count_text(i), self%origin(i))
        end do
        call check_count_within(error, "images", self%images, 1, most_images)
        if (4.0_wp*real(self%images, wp)**2*size(labels, 1)*size(labels, 2) > most_cells) then
            call raise(error, error_invalid, "images = "//count_text(self%images)//": this number of periods has too many "// &
                       "cells. Use fewer images")
        end if
        self%reference_nu = 0.0_wp
        do i = 1, size(phases)
            self%reference_nu = self%reference_nu + self%poisson(i)*(count(labels == i)/real(size(labels), wp))
        end do
        ! a mean of equal numbers may miss them by a rounding
        self%reference_nu = min(max(self%reference_nu, minval(self%poisson)), maxval(self%poisson))
        if (present(reference_nu)) self%reference_nu = reference_nu
        call check_poisson(error, "reference_nu", self%reference_nu)
        if (present(exponent)) self%exponent = exponent
        call new_power_mean(mean, self%exponent, self%shear, error)
        self%is_made = .not. allocated(error)
    end subroutine new_voxels

    !> By direct summation: the weight of every cell. What is outside the array enters through the differences from it.
    subroutine means(self, x, y, a, exponent, shear, poisson, error)
        class(voxels_t), intent(in) :: self
        real(wp), intent(in) :: x, y, a, exponent
        real(wp), intent(out) :: shear, poisson
        type(error_t), allocatable, intent(out) :: error
        type(slab_t) :: slab
        type(power_mean_t) :: mean
        integer, allocatable :: columns(:), rows(:)
        real(wp), allocatable :: lines_x(:), lines_y(:), shear_weights(:, :), poisson_weights(:, :)
        real(wp) :: phases(size(self%shear)), below(2), beside(2), base(2)
        integer :: k, stat

        shear = 0.0_wp
        poisson = 0.0_wp
        call check_made(error, "structure", self%is_made)
        if (allocated(error)) return
        call new_power_mean(mean, exponent, [self%shear, self%below%shear(), self%beside%shear()], error)
        if (allocated(error)) return
        phases = mean%transformed(self%shear)
        below = [mean%transformed(self%below%shear()), self%below%poisson]
        beside = [mean%transformed(self%beside%shear()), self%beside%poisson]
        call window(self, 1, x, columns, lines_x, error)
        if (.not. allocated(error)) call window(self, 2, y, rows, lines_y, error)
        if (allocated(error)) return
        allocate (shear_weights(size(columns), size(rows)), poisson_weights(size(columns), size(rows)), stat=stat)
        call check_memory(error, stat)
        if (allocated(error)) return
        lines_x = in_radii(lines_x, a)
        lines_y = in_radii(lines_y, a)
        do k = 1, size(self%labels, 3)
            call new_slab(slab, self%reference_nu, in_radii((k - 1)*self%spacing(3), a), &
                          in_radii(k*self%spacing(3), a), hypot(maxval(abs(lines_x)), maxval(abs(lines_y))), error)
            if (allocated(error)) return
            call cell_weights(slab, lines_x, lines_y, shear_weights, poisson_weights, error)
            if (allocated(error)) return
            base = beside
            if (self%periodic) base = slice_mean(self, k, phases, below)
            ! differences from `below`, then from the slice's base: a homogeneous structure returns itself exactly
            shear = shear + two_pi*slab%whole(1)*(base(1) - below(1)) &
                    + weighted(shear_weights, phases - base(1), self%labels(:, :, k), columns, rows)
            poisson = poisson + two_pi*slab%whole(2)*(base(2) - below(2)) &
                      + weighted(poisson_weights, self%poisson - base(2), self%labels(:, :, k), columns, rows)
        end do
        shear = mean%mean(shear + below(1))
        poisson = poisson + below(2)
    end subroutine means

    !> The cells that count one by one in a direction: their indices, and their lines relative to the axis.
    pure subroutine window(self, direction, at, indices, lines, error)
        class(voxels_t), intent(in) :: self
        integer, intent(in) :: direction
        real(wp), intent(in) :: at
        integer, allocatable, intent(out) :: indices(:)
        real(wp), allocatable, intent(out) :: lines(:)
        type(error_t), allocatable, intent(inout) :: error
        integer :: n, i, first, last, stat
        real(wp) :: place

        n = size(self%labels, direction)
        place = (at - self%origin(direction))/self%spacing(direction)
        if (self%periodic) then
            place = modulo(place, real(n, wp))
            first = floor(place) - self%images*n
            last = floor(place) + self%images*n
        else
            first = 0
            last = n
        end if
        allocate (indices(last - first), lines(last - first + 1), stat=stat)
        call check_memory(error, stat)
        if (allocated(error)) return
        do i = first, last
            lines(i - first + 1) = (i - place)*self%spacing(direction)
            if (i < last) indices(i - first + 1) = modulo(i, n) + 1
        end do
    end subroutine window

    !> Reference for a slice that repeats itself: its own mean.
    pure function slice_mean(self, k, phases, below) result(base)
        class(voxels_t), intent(in) :: self
        integer, intent(in) :: k
        !> what G of each phase counts as, and G and nu of what lies below
        real(wp), intent(in) :: phases(:), below(2)
        real(wp) :: base(2)
        real(wp) :: share
        integer :: phase

        base = below
        do phase = 1, size(self%shear)
            share = count(self%labels(:, :, k) == phase)/real(size(self%labels, 1)*size(self%labels, 2), wp)
            base = base + share*[phases(phase) - below(1), self%poisson(phase) - below(2)]
        end do
    end function slice_mean

    !> Sum over the cells of weight times the value of their phase.
    pure function weighted(weights, values, labels, columns, rows) result(total)
        real(wp), intent(in) :: weights(:, :), values(:)
        integer, intent(in) :: labels(:, :), columns(:), rows(:)
        real(wp) :: total
        integer :: i, j

        total = 0.0_wp
        do j = 1, size(rows)
            do i = 1, size(columns)
                total = total + weights(i, j)*values(labels(columns(i), rows(j)))
            end do
        end do
    end function weighted

end module mdrcontact_lateral_voxels
