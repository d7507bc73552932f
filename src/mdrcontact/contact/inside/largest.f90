! SPDX-License-Identifier: GPL-3.0-or-later
!> The largest value of a stress in a part of a loaded body, in the plane of symmetry: of all azimuths without friction, of sliding
!> with it. It is searched for on a grid, from its highest peaks on smaller ones, and on the polynomials through these.
module mdrcontact_inside_largest
    use, intrinsic :: iso_c_binding, only: c_size_t
    use mdrcontact_nonfinite, only: infinity, is_finite
    use mdrcontact_body_layers, only: layers_t
    use mdrcontact_cancel, only: check_cancelled
    use mdrcontact_codes, only: free_surface_tension, interface_shear, interface_tension, tension, tresca, von_mises
    use mdrcontact_error, only: error_t
    use mdrcontact_inside_interior, only: components, infinite_pressure, interior_field, kept_waves_t, s_rr, &
                                          s_rz, s_tt, s_zz
    use mdrcontact_gsl, only: gsl_sort
    use mdrcontact_kinds, only: pi, wp
    use mdrcontact_medium_load, only: load_t
    use mdrcontact_numerics_lagrange, only: lagrange
    use mdrcontact_numerics_quadrature, only: merge_breaks
    implicit none (type, external)
    private
    public :: box_t, maximum_t, stressed_t

    !> A largest stress and where it is.
    type :: maximum_t
        !> von_mises, tresca, tension of a layer; interface_shear, interface_tension; or free_surface_tension
        integer :: quantity = 0
        !> which layer or interface, 0 is the first one from the surface; 0 of the free surface
        integer :: place = 0
        !> [modulus]; negative if the whole region is under compression
        real(wp) :: value = -huge(1.0_wp)
        !> distance from the axis and depth [length]
        real(wp) :: r = 0.0_wp, z = 0.0_wp
        !> azimuth from the direction of sliding [radian], 0 or pi; 0 without friction
        real(wp) :: angle = 0.0_wp
    end type maximum_t

    !> Where a largest value is searched for; at an interface the side above is meant.
    type :: box_t
        !> distances from the axis and depths, from and to [length]
        real(wp) :: r(2) = 0.0_wp, z(2) = 0.0_wp
    end type box_t

    !> Values on a grid around a peak.
    type :: grid_t
        !> [length]
        real(wp), allocatable :: r(:), z(:)
        !> (radius, depth, part) [modulus]
        real(wp), allocatable :: values(:, :, :)
        !> [length], and which azimuth
        real(wp) :: ends_r(2) = 0.0_wp, ends_z(2) = 0.0_wp
        integer :: side = 0
    end type grid_t

    !> Grids that were filled before: quantities share them.
    type :: grids_t
        type(grid_t), allocatable :: list(:)
        integer :: count = 0
    end type grids_t

    !> A body of layers under a load and its friction.
    type :: stressed_t
        class(load_t), allocatable :: load
        type(layers_t) :: layers
        !> traction friction*p(r) in +x; either sign
        real(wp) :: friction = 0.0_wp
        !> radii on the surface where stresses are infinite [length]
        real(wp), allocatable :: singular(:)
        integer :: threads = 1
        !> of the fields that were computed before
        type(kept_waves_t) :: kept
    contains
        procedure :: mark_singular
        procedure :: largest
        procedure :: has_singular_edge
        procedure :: is_off_singular
    end type stressed_t

    !> Azimuths.
    real(wp), parameter :: azimuth(2) = [0.0_wp, pi]
    !> Components of the quantities: functions without the kinks of their maximum.
    integer, parameter :: by_mises = 1, in_plane = 2, down_from_hoop = 3, up_from_hoop = 4, along_plane = 5, hoop = 6, &
                          shear_outward = 7, shear_inward = 8, across = 9, size_of_parts = 9
    !> Radii of a grid over its length, as many next to the edge of the contact, and depths.
    integer, parameter :: grid_r = 20, grid_z = 25
    !> Distance of the former from the edge [a].
    real(wp), parameter :: beside_edge = 0.3_wp
    !> Points in each direction of a smaller grid, a quarter as long as the one before; the last one is shorter by `smallest`.
    integer, parameter :: points = 9
    real(wp), parameter :: smallest = 4.0_wp**(-7)
    !> Grids at most: some are shifted to where values rise.
    integer, parameter :: most_grids = 24
    !> Largest difference of the polynomial through a grid from the stress where it is largest, of the grid's largest value.
    real(wp), parameter :: agreement = 1.0e-11_wp
    !> So many peaks of the grid are followed, which fall short of the highest one by no more than this part of the range of values.
    integer, parameter :: most_peaks = 4
    real(wp), parameter :: noticed = 0.2_wp
    !> Part of a grid's largest value that the last term of its polynomial may be where it can meet the stress.
    real(wp), parameter :: resolved = 1.0e-7_wp
    !> How many times less a stress falls from its place in a grid a quarter as long: 16 times beside a smooth maximum, 4 times or
    !> less beside a kink.
    real(wp), parameter :: most_fall = 8.0_wp
    !> Nothing is searched for nearer than this to where stresses are infinite [a].
    real(wp), parameter :: off_singular = 1.0e-3_wp, rounding = 1.0e-9_wp
    !> Distances from there at which a grid also has points [a].
    real(wp), parameter :: close_by(6) = off_singular*[1.0_wp, 2.0_wp, 4.0_wp, 8.0_wp, 16.0_wp, 32.0_wp]

contains

    !> Finds the radii where stresses are infinite; load and layers are known.
    subroutine mark_singular(self)
        class(stressed_t), intent(inout) :: self
        real(wp) :: places(size(self%load%kinks) + 2)
        logical :: chosen(size(places))
        integer :: i

        associate (load => self%load)
            places = load%radius
            places(1) = 0.0_wp
            places(2:size(load%kinks) + 1) = load%kinks
            do i = 1, size(places)
                chosen(i) = abs(infinite_pressure(load, places(i), 0.0_wp)) > 0.0_wp
            end do
        end associate
        allocate (self%singular(count(chosen)))
        self%singular(:) = pack(places, chosen)
    end subroutine mark_singular

    !> Whether stresses are infinite at the edge of the contact, no matter how weak the load is.
    pure function has_singular_edge(self) result(answer)
        class(stressed_t), intent(in) :: self
        logical :: answer

        answer = any(self%singular >= self%load%radius)
    end function has_singular_edge

    !> Whether a point is so far from where stresses are infinite that maxima are searched for there.
    pure function is_off_singular(self, r, z) result(answer)
        class(stressed_t), intent(in) :: self
        !> [length]
        real(wp), intent(in) :: r, z
        logical :: answer

        answer = all(hypot(r - self%singular, z) >= (1.0_wp - rounding)*off_singular*self%load%radius)
    end function is_off_singular

    !> The largest values of some quantities in a box. What a coarse search gives is the largest on its grid.
    subroutine largest(self, box, quantities, is_coarse, found, error)
        class(stressed_t), intent(inout) :: self
        type(box_t), intent(in) :: box
        integer, intent(in) :: quantities(:)
        logical, intent(in) :: is_coarse
        !> same size; their `place` is left to the caller
        type(maximum_t), intent(out) :: found(:)
        type(error_t), allocatable, intent(inout) :: error
        real(wp), allocatable :: r(:), z(:), values(:, :, :, :)
        type(grids_t) :: grids
        integer :: i

        if (allocated(error)) return
        r = radii_in(box%r, self%load%radius, self%singular)
        z = depths_in(box%z, self%load%radius, self%singular)
        call find_values(self, r, z, values, error)
        if (allocated(error)) return
        allocate (grids%list(size(quantities)*most_peaks*(most_grids + 1)))
        do i = 1, size(quantities)
            call search(self, box, r, z, values, quantities(i), is_coarse, grids, found(i), error)
            if (allocated(error)) return
        end do
    end subroutine largest

    !> The largest value of one quantity.
    subroutine search(self, box, r, z, values, quantity, is_coarse, grids, found, error)
        class(stressed_t), intent(inout) :: self
        type(box_t), intent(in) :: box
        !> the first grid [length], and what it has: (radius, depth, azimuth, part)
        real(wp), intent(in) :: r(:), z(:), values(:, :, :, :)
        integer, intent(in) :: quantity
        logical, intent(in) :: is_coarse
        type(grids_t), intent(inout) :: grids
        type(maximum_t), intent(out) :: found
        type(error_t), allocatable, intent(inout) :: error
        integer, allocatable :: peaks(:, :), parts(:)

        allocate (parts, source=parts_of(quantity))
        allocate (peaks, source=peaks_of(values(:, :, :, parts), merge(1, most_peaks, is_coarse)))
        peaks(4, :) = parts(peaks(4, :))
        found%quantity = quantity
        if (size(peaks, 2) == 0) return
        associate (at => peaks(:, 1))
            found = maximum_t(quantity, 0, values(at(1), at(2), at(3), at(4)), r(at(1)), z(at(2)), azimuth(at(3)))
        end associate
        if (.not. is_coarse) call follow_peaks(self, box, r, z, values, peaks, grids, found, error)
    end subroutine search

    !> Follows the peaks of a quantity from what the first smaller grid of each promises, the highest one first. Lower ones are left
    !> out, unless they may still rise above it as much as they rose from the first grid to this one.
    subroutine follow_peaks(self, box, r, z, values, peaks, grids, found, error)
        class(stressed_t), intent(inout) :: self
        type(box_t), intent(in) :: box
        !> the first grid [length], and what it has: (radius, depth, azimuth, part)
        real(wp), intent(in) :: r(:), z(:), values(:, :, :, :)
        !> (radius, depth, azimuth, part; peak)
        integer, intent(in) :: peaks(:, :)
        type(grids_t), intent(inout) :: grids
        type(maximum_t), intent(inout) :: found
        type(error_t), allocatable, intent(inout) :: error
        type(maximum_t) :: peak
        real(wp) :: promised(size(peaks, 2)), first, reachable, top(3)
        integer :: which(size(peaks, 2)), k, i

        do k = 1, size(peaks, 2)
            call find_grid(self, around(r, peaks(1, k)), around(z, peaks(2, k)), peaks(3, k), grids, which(k), error)
            if (allocated(error)) return
            call find_top(grids%list(which(k)), peaks(4, k), top)
            promised(k) = max(top(1), maxval(grids%list(which(k))%values(:, :, peaks(4, k))))
        end do
        do i = 1, size(peaks, 2)
            k = maxloc(promised, 1)
            associate (at => peaks(:, k))
                first = values(at(1), at(2), at(3), at(4))
                reachable = promised(k) + max(promised(k) - first, 0.0_wp)
                if (i == 1 .or. reachable > found%value) then
                    peak = maximum_t(found%quantity, 0, first, r(at(1)), z(at(2)), azimuth(at(3)))
                    call find_peak(self, box, grids, which(k), at(4), peak, error)
                    if (allocated(error)) return
                    if (peak%value > found%value .or. i == 1) found = peak
                end if
            end associate
            promised(k) = -infinity
        end do
    end subroutine follow_peaks

    !> A smaller grid from end to end, unless it is known.
    subroutine find_grid(self, ends_r, ends_z, side, grids, which, error)
        class(stressed_t), intent(inout) :: self
        !> [length]
        real(wp), intent(in) :: ends_r(2), ends_z(2)
        !> which azimuth
        integer, intent(in) :: side
        type(grids_t), intent(inout) :: grids
        !> its place in the list
        integer, intent(out) :: which
        type(error_t), allocatable, intent(inout) :: error
        real(wp), allocatable :: values(:, :, :, :)

        do which = 1, grids%count
            associate (grid => grids%list(which))
                if (grid%side == side .and. all(grid%ends_r == ends_r) .and. all(grid%ends_z == ends_z)) return
            end associate
        end do
        grids%count = which
        associate (grid => grids%list(which))
            grid%side = side
            grid%ends_r = ends_r
            grid%ends_z = ends_z
            grid%r = evenly(ends_r)
            grid%z = evenly(ends_z)
            call find_values(self, grid%r, grid%z, values, error)
            if (allocated(error)) return
            grid%values = values(:, :, side, :)
        end associate
    end subroutine find_grid

    !> Follows a peak on ever smaller grids around the largest value, until the polynomial through a grid meets the stress where it
    !> is largest.
    subroutine find_peak(self, box, grids, first, part, peak, error)
        class(stressed_t), intent(inout) :: self
        type(box_t), intent(in) :: box
        type(grids_t), intent(inout) :: grids
        !> the one around the peak, and what has the peak
        integer, intent(in) :: first, part
        type(maximum_t), intent(inout) :: peak
        type(error_t), allocatable, intent(inout) :: error
        real(wp) :: ends_r(2), ends_z(2), before(4), falls(4)
        integer :: i, at(2), which, side
        logical :: is_met, is_last

        which = first
        side = grids%list(first)%side
        before = infinity
        do i = 1, most_grids
            associate (grid => grids%list(which), all_r => grids%list(first)%ends_r, all_z => grids%list(first)%ends_z)
                at = maxloc(grid%values(:, :, part))
                call raise_peak(peak, grid%values(at(1), at(2), part), grid%r(at(1)), grid%z(at(2)))
                falls = falls_around(grid%values(:, :, part), at)
                if (is_at_kink(self, grid%r(at(1)), grid%z(at(2)))) then
                    if (all(falls > 0.0_wp .and. falls >= before/most_fall)) return
                    before = falls
                end if
                ends_r = closer(grid%r, at(1), box%r)
                ends_z = closer(grid%z, at(2), box%z)
                is_last = length(ends_r) <= smallest*length(all_r) .and. length(ends_z) <= smallest*length(all_z)
                if (is_within(ends_r, grid%ends_r) .and. is_within(ends_z, grid%ends_z) .and. &
                    (is_last .or. is_resolved(grid%values(:, :, part), at))) then
                    call meet_top(self, grid, part, peak, is_met, error)
                    if (is_met .or. allocated(error)) return
                end if
                if (is_last) return
            end associate
            call find_grid(self, ends_r, ends_z, side, grids, which, error)
            if (allocated(error)) return
        end do
    end subroutine find_peak

    !> Whether a point is where stresses are not smooth at the surface: at the edge, or where the indenter is not.
    pure function is_at_kink(self, r, z) result(answer)
        class(stressed_t), intent(in) :: self
        real(wp), intent(in) :: r, z
        logical :: answer

        answer = .not. z > 0.0_wp .and. any(abs(r - [self%load%radius, self%load%kinks]) <= rounding*self%load%radius)
    end function is_at_kink

    !> By how much values around the largest one are smaller; infinity beyond the ends.
    pure function falls_around(values, at) result(falls)
        real(wp), intent(in) :: values(:, :)
        integer, intent(in) :: at(2)
        real(wp) :: falls(4)

        falls = infinity
        associate (i => at(1), j => at(2))
            if (i > 1) falls(1) = values(i, j) - values(i - 1, j)
            if (i < size(values, 1)) falls(2) = values(i, j) - values(i + 1, j)
            if (j > 1) falls(3) = values(i, j) - values(i, j - 1)
            if (j < size(values, 2)) falls(4) = values(i, j) - values(i, j + 1)
        end associate
    end function falls_around

    !> Whether the last terms of polynomials through the row and the column of the largest value are small.
    pure function is_resolved(values, at) result(answer)
        real(wp), intent(in) :: values(:, :)
        integer, intent(in) :: at(2)
        logical :: answer

        answer = max(last_term(values(:, at(2))), last_term(values(at(1), :))) <= resolved*maxval(abs(values))
    end function is_resolved

    !> The Chebyshev polynomial's part of the highest degree in values at `points` even places; 0 for a single one.
    pure function last_term(values) result(term)
        real(wp), intent(in) :: values(:)
        real(wp) :: term
        real(wp) :: differences(size(values))
        integer :: i

        term = 0.0_wp
        if (size(values) < points) return
        differences = values
        do i = 1, points - 1
            differences(:points - i) = differences(2:points - i + 1) - differences(:points - i)
        end do
        ! over 8! (1/4)^8 2^7
        term = abs(differences(1))*(4.0_wp**8/(40320.0_wp*2.0_wp**7))
    end function last_term

    !> Compares the polynomial through a grid with the stress where it is largest.
    subroutine meet_top(self, grid, part, peak, is_met, error)
        class(stressed_t), intent(inout) :: self
        type(grid_t), intent(in) :: grid
        integer, intent(in) :: part
        type(maximum_t), intent(inout) :: peak
        logical, intent(out) :: is_met
        type(error_t), allocatable, intent(inout) :: error
        real(wp), allocatable :: values(:, :, :, :)
        real(wp) :: top(3)

        is_met = .false.
        call find_top(grid, part, top)
        if (.not. top(1) > -infinity) return
        top(2:) = [at_end(top(2), grid%r), at_end(top(3), grid%z)]
        call find_values(self, top(2:2), top(3:3), values, error)
        if (allocated(error)) return
        associate (there => values(1, 1, grid%side, part))
            call raise_peak(peak, there, top(2), top(3))
            is_met = abs(there - top(1)) <= agreement*maxval(abs(grid%values(:, :, part)))
        end associate
    end subroutine meet_top

    pure function is_within(ends, others) result(answer)
        real(wp), intent(in) :: ends(2), others(2)
        logical :: answer

        answer = ends(1) >= others(1) .and. ends(2) <= others(2)
    end function is_within

    pure subroutine raise_peak(peak, value, r, z)
        type(maximum_t), intent(inout) :: peak
        !> of another point
        real(wp), intent(in) :: value, r, z

        if (value < peak%value) return
        peak%value = value
        peak%r = r
        peak%z = z
    end subroutine raise_peak

    !> The largest value and its place, by the polynomial through a grid; -infinity where values are infinite.
    pure subroutine find_top(grid, part, top)
        type(grid_t), intent(in) :: grid
        integer, intent(in) :: part
        !> value, radius, depth
        real(wp), intent(out) :: top(3)
        real(wp), allocatable :: r(:), z(:), here(:, :)
        real(wp) :: all_r(2), all_z(2)
        integer :: i, at(2)

        top = -infinity
        associate (values => grid%values(:, :, part))
            if (.not. all(is_finite(values))) return
            r = grid%r
            z = grid%z
            all_r = r([1, size(r)])
            all_z = z([1, size(z)])
            here = values
            do i = 1, most_grids
                at = maxloc(here)
                if (here(at(1), at(2)) > top(1)) top = [here(at(1), at(2)), r(at(1)), z(at(2))]
                if (length(r) <= smallest*length(all_r) .and. length(z) <= smallest*length(all_z)) return
                r = evenly(closer(r, at(1), all_r))
                z = evenly(closer(z, at(2), all_z))
                if (size(r) < size(grid%r) .or. size(z) < size(grid%z)) return
                here = matmul(matmul(lagrange(grid%r, r), values), transpose(lagrange(grid%z, z)))
            end do
        end associate
    end subroutine find_top

    !> A place, or the end of a grid that is so close to it that rounding decides which of both has the larger value: the axis, the
    !> surface or an interface.
    pure function at_end(place, x) result(chosen)
        real(wp), intent(in) :: place, x(:)
        real(wp) :: chosen

        chosen = place
        if (place - x(1) <= 0.1_wp*smallest*length(x)) chosen = x(1)
        if (x(size(x)) - place <= 0.1_wp*smallest*length(x)) chosen = x(size(x))
    end function at_end

    pure function length(x)
        real(wp), intent(in) :: x(:)
        real(wp) :: length

        length = x(size(x)) - x(1)
    end function length

    !> The values of all parts on a grid; -infinity next to what is singular.
    subroutine find_values(self, r, z, values, error)
        class(stressed_t), intent(inout), target :: self
        !> [length]
        real(wp), intent(in) :: r(:), z(:)
        !> (radius, depth, azimuth, part) [modulus]
        real(wp), allocatable, intent(out) :: values(:, :, :, :)
        type(error_t), allocatable, intent(inout) :: error
        real(wp), allocatable :: all_r(:), all_z(:), zero(:), field(:, :), opposite(:, :)
        integer :: i, n

        call check_cancelled(error)
        if (allocated(error)) return
        n = size(r)*size(z)
        allocate (all_r(n), all_z(n), field(n, components), zero(n), source=0.0_wp)
        do i = 1, size(r)
            all_r((i - 1)*size(z) + 1:i*size(z)) = r(i)
            all_z((i - 1)*size(z) + 1:i*size(z)) = z
        end do
        if (self%friction /= 0.0_wp) allocate (opposite, mold=field)
        call interior_field(self%load, self%layers, all_r, all_z, .false., field, error, self%friction, zero, self%threads, &
                            self%kept, opposite)
        if (allocated(error)) return
        allocate (values(size(r), size(z), merge(2, 1, self%friction /= 0.0_wp), size_of_parts))
        call fill_parts(self, r, z, field, values(:, :, 1, :))
        if (allocated(opposite)) call fill_parts(self, r, z, opposite, values(:, :, 2, :))
    end subroutine find_values

    !> The parts at one azimuth.
    pure subroutine fill_parts(self, r, z, field, values)
        class(stressed_t), intent(in) :: self
        real(wp), intent(in) :: r(:), z(:)
        !> (point, component), depths first
        real(wp), intent(in) :: field(:, :)
        !> (radius, depth, part)
        real(wp), intent(out) :: values(:, :, :)
        real(wp) :: components_at(components)
        integer :: i, j, k

        do j = 1, size(z)
            do i = 1, size(r)
                components_at = field((i - 1)*size(z) + j, :)
                do k = 1, size_of_parts
                    values(i, j, k) = part_at(k, components_at)
                    if (.not. is_finite(values(i, j, k))) values(i, j, k) = -infinity
                end do
                if (.not. self%is_off_singular(r(i), z(j))) values(i, j, :) = -infinity
            end do
        end do
    end subroutine fill_parts

    !> Parts whose maximum a quantity is.
    pure function parts_of(quantity) result(parts)
        !> one of those of maximum_t
        integer, intent(in) :: quantity
        integer, allocatable :: parts(:)

        select case (quantity)
        case (von_mises)
            parts = [by_mises]
        case (tresca)
            parts = [in_plane, down_from_hoop, up_from_hoop]
        case (tension, free_surface_tension)
            parts = [along_plane, hoop]
        case (interface_shear)
            parts = [shear_outward, shear_inward]
        case default ! interface_tension
            parts = [across]
        end select
    end function parts_of

    !> A part at a point in the plane of symmetry, where s_rt = s_tz = 0 and the hoop stress is a principal one [modulus].
    pure function part_at(part, field) result(value)
        integer, intent(in) :: part
        !> the components of mdrcontact_inside_interior
        real(wp), intent(in) :: field(components)
        real(wp) :: value
        real(wp) :: mean, circle

        mean = 0.5_wp*(field(s_rr) + field(s_zz))
        circle = hypot(0.5_wp*(field(s_rr) - field(s_zz)), field(s_rz))
        select case (part)
        case (by_mises)
            value = sqrt(0.5_wp*((field(s_rr) - field(s_tt))**2 + (field(s_tt) - field(s_zz))**2 + (field(s_zz) - field(s_rr))**2) &
                         + 3.0_wp*field(s_rz)**2)
        case (in_plane)
            value = circle
        case (down_from_hoop)
            value = 0.5_wp*(field(s_tt) - (mean - circle))
        case (up_from_hoop)
            value = 0.5_wp*(mean + circle - field(s_tt))
        case (along_plane)
            value = mean + circle
        case (hoop)
            value = field(s_tt)
        case (shear_outward)
            value = field(s_rz)
        case (shear_inward)
            value = -field(s_rz)
        case default ! across
            value = field(s_zz)
        end select
    end function part_at

    !> The places (i, j, k, l) of the highest peaks among values on grids, the highest one first; none where no value is finite.
    pure function peaks_of(values, most) result(peaks)
        real(wp), intent(in) :: values(:, :, :, :)
        integer, intent(in) :: most
        !> (4, as many as there are)
        integer, allocatable :: peaks(:, :)
        real(wp), allocatable :: left(:, :, :, :)
        real(wp) :: highest, least
        integer :: i, j, k, l, n, at(4), found(4, most)

        allocate (left, source=values)
        do l = 1, size(values, 4)
            do k = 1, size(values, 3)
                do j = 1, size(values, 2)
                    do i = 1, size(values, 1)
                        associate (beside => values(max(i - 1, 1):min(i + 1, size(values, 1)), &
                                                    max(j - 1, 1):min(j + 1, size(values, 2)), k, l))
                            if (values(i, j, k, l) < maxval(beside)) left(i, j, k, l) = -infinity
                        end associate
                    end do
                end do
            end do
        end do
        highest = maxval(values)
        least = highest - noticed*(highest - minval(values, mask=is_finite(values)))
        n = 0
        do while (n < most)
            at = maxloc(left)
            if (.not. left(at(1), at(2), at(3), at(4)) >= least) exit
            n = n + 1
            found(:, n) = at
            left(at(1), at(2), at(3), at(4)) = -infinity
        end do
        allocate (peaks(4, n))
        peaks(:, :) = found(:, :n)
    end function peaks_of

    !> Radii of a box, as many next to the edge of the contact, and some next to places where stresses are infinite.
    pure function radii_in(ends, radius, singular) result(r)
        !> a, and radii of those places [length]
        real(wp), intent(in) :: ends(2), radius, singular(:)
        real(wp), allocatable :: r(:)
        real(wp) :: all_r(2*grid_r + 2 + 2*size(close_by)*size(singular))
        integer :: i, n

        do i = 0, grid_r
            all_r(i + 1) = ends(1) + (ends(2) - ends(1))*real(i, wp)/real(grid_r, wp)
        end do
        do i = 1, grid_r
            all_r(grid_r + 1 + i) = radius*(1.0_wp + beside_edge*(real(2*i - 1 - grid_r, wp)/real(grid_r - 1, wp))**3)
        end do
        all_r(2*grid_r + 2) = radius
        n = 2*grid_r + 2
        do i = 1, size(singular)
            all_r(n + 1:n + size(close_by)) = singular(i) - close_by*radius
            all_r(n + size(close_by) + 1:n + 2*size(close_by)) = singular(i) + close_by*radius
            n = n + 2*size(close_by)
        end do
        r = ascending_within(ends, all_r)
    end function radii_in

    !> Depths of a box, denser towards the surface, and some next to places where stresses are infinite.
    pure function depths_in(ends, radius, singular) result(z)
        real(wp), intent(in) :: ends(2), radius, singular(:)
        real(wp), allocatable :: z(:)
        real(wp) :: all_z(grid_z + size(close_by))
        integer :: i

        all_z = ends(2)
        do i = 0, grid_z - 1
            all_z(i + 1) = ends(1) + (ends(2) - ends(1))*(real(i, wp)/real(grid_z - 1, wp))**2
        end do
        if (size(singular) > 0) all_z(grid_z + 1:) = close_by*radius
        z = ascending_within(ends, all_z)
    end function depths_in

    !> The distinct ones of some values from one end to the other, both included.
    pure function ascending_within(ends, values) result(x)
        real(wp), intent(in) :: ends(2), values(:)
        real(wp), allocatable :: x(:)
        real(wp), allocatable :: inside(:)
        type(error_t), allocatable :: unused

        inside = pack(values, values > ends(1) .and. values < ends(2))
        call gsl_sort(inside, 1_c_size_t, size(inside, kind=c_size_t))
        x = ends(:1)
        call merge_breaks(x, [inside, ends(2)], unused)
    end function ascending_within

    pure function evenly(ends) result(x)
        real(wp), intent(in) :: ends(2)
        real(wp), allocatable :: x(:)
        integer :: i

        if (ends(2) > ends(1)) then
            x = [(ends(1) + (ends(2) - ends(1))*real(i, wp)/real(points - 1, wp), i=0, points - 1)]
        else
            x = ends(:1)
        end if
    end function evenly

    !> From the value before to the one after.
    pure function around(x, i) result(ends)
        real(wp), intent(in) :: x(:)
        integer, intent(in) :: i
        real(wp) :: ends(2)

        ends = [x(max(i - 1, 1)), x(min(i + 1, size(x)))]
    end function around

    !> The next ends of a smaller grid, around its largest value; as far apart as before where that lies at an end, but in the box.
    pure function closer(x, i, box) result(ends)
        real(wp), intent(in) :: x(:), box(2)
        integer, intent(in) :: i
        real(wp) :: ends(2)
        real(wp) :: half

        ends = around(x, i)
        if (size(x) == 1) return
        half = 0.5_wp*(x(size(x)) - x(1))
        if ((i == 1 .and. x(1) > box(1)) .or. (i == size(x) .and. x(i) < box(2))) then
            ends = [max(x(i) - half, box(1)), min(x(i) + half, box(2))]
        end if
    end function closer

end module mdrcontact_inside_largest
