! SPDX-License-Identifier: GPL-3.0-or-later
!> Indenters without a closed form: a user's function, a table, an area function. f and g are sampled once, when the indenter
!> is made, and from then on cost as little as a closed form; a user's function is not called again.
module mdrcontact_profile_sampled
    use, intrinsic :: iso_fortran_env, only: int64
    use mdrcontact_object, only: real_bytes
    use mdrcontact_error, only: check_memory, error_invalid, error_t, raise, to_text
    use mdrcontact_kinds, only: wp
    use mdrcontact_numerics_quadrature, only: merge_breaks
    use mdrcontact_profile, only: profile_t
    use mdrcontact_profile_corners, only: add_corners
    use mdrcontact_profile_transform, only: new_transform, transform_t
    use mdrcontact_numerics_sampled_function, only: new_sampled_function, sampled_function_t
    use mdrcontact_numerics_scalar_function, only: scalar_function_t
    implicit none (type, external)
    private
    public :: sampled_profile_t, sample_from_height, sample_from_mdr, first_edge

    !> f and g between a smallest and the largest radius, and as powers of the radius below.
    type, extends(profile_t) :: sampled_profile_t
        private
        type(sampled_function_t) :: f, g
        real(wp) :: f_exponent = 0.0_wp, g_exponent = 0.0_wp
        !> radii where f is not analytic, ascending [length]
        real(wp), allocatable :: breaks(:)
    contains
        procedure :: height
        procedure :: slope
        procedure :: mdr
        procedure :: mdr_slope
        procedure :: mdr_moment
        procedure :: add_breaks
        procedure :: bytes
    end type sampled_profile_t

    real(wp), parameter :: height_tolerance = 1.0e-14_wp, transform_tolerance = 2.0e-14_wp
    !> f is sampled this much further down than g; below it is a power of r, whose transform is a fast power series.
    integer, parameter :: extra_octaves = 1
    !> Points in a panel, smooth by construction, at which a profile is seen not to decrease.
    integer, parameter :: checks_in_panel = 16
    !> Octaves towards a flat end, where x - b loses the digits of x and only absolute accuracy is left to have.
    integer, parameter :: flat_octaves = 10
    !> The uppermost edge of the panels towards the axis, relative to where they begin: the others are halves of it. No corner of a
    !> user's function comes to lie on one by chance, where it would go unseen.
    real(wp), parameter :: first_edge = 0.7390851332151607_wp
    !> Keeps the radii of considers f off the edges of panels.
    real(wp), parameter :: irrational = 0.8603335890193797_wp
    !> Best accuracy of f and g for a given scatter of f.
    real(wp), parameter :: height_roughness = 20.0_wp, transform_roughness = 30.0_wp
    !> No panel behind a break reaches further, relative to where it begins: it is as accurate as its largest value.
    real(wp), parameter :: largest_step = 4.0_wp
    !> Largest number of times that f is sampled again with the corners found.
    integer, parameter :: most_rounds = 4
    !> Lengths below it, and above its inverse, raise an error.
    real(wp), parameter :: smallest_length = 1.0e-150_wp
    !> The range over which f and g are sampled: down to this fraction of their largest value or of the largest radius,
    real(wp), parameter :: smallest_value = 1.0e-20_wp, smallest_radius = 1.0e-10_wp
    !> and on until the exponent of r changes by less than `straight` in an octave, but not beyond these.
    real(wp), parameter :: straight = 1.0e-13_wp, least_value = 1.0e-60_wp, least_radius = 1.0e-30_wp

contains

    !> Samples f = `height` on [0, largest] and transforms it.
    subroutine sample_from_height(self, height, largest, flat_radius, breaks, roughness, error)
        type(sampled_profile_t), intent(out) :: self
        !> f(r) >= 0 with f(0) = 0, not decreasing [length]
        class(scalar_function_t), intent(inout) :: height
        !> radius where the profile ends [length]
        real(wp), intent(in) :: largest
        !> radius up to which f = 0 [length]
        real(wp), intent(in) :: flat_radius
        !> ascending radii in (flat_radius, largest) where f is not analytic, as far as they are known [length]
        real(wp), intent(in) :: breaks(:)
        !> scatter of the heights, relative to themselves
        real(wp), intent(in) :: roughness
        type(error_t), allocatable, intent(out) :: error
        type(sampled_function_t), target :: f
        type(transform_t) :: transform
        real(wp), allocatable :: all_breaks(:), edges(:)
        logical, allocatable :: roots(:)
        integer :: round, known, octaves

        call merge_breaks(all_breaks, breaks, error)
        do round = 1, most_rounds
            if (allocated(error)) return
            known = size(all_breaks)
            call sample_height(f, height, largest, flat_radius, all_breaks, roughness, octaves, edges, error)
            if (.not. allocated(error)) call add_corners(f, height, edges, all_breaks, error)
            if (allocated(error)) return
            if (size(all_breaks) == known) exit
        end do
        call check_ascending(f, error)
        if (.not. allocated(error)) call new_transform(transform, f, .true., end_exponent(f, flat_radius), error)
        if (.not. allocated(error)) call plan_panels(flat_radius, all_breaks, largest, octaves, edges, roots, error)
        if (allocated(error)) return
        call new_sampled_function(self%g, transform, edges, roots, transform_tolerance, error, &
                                  noise=flat_noise(transform, flat_radius, first_break(all_breaks, largest)), &
                                  most=most_panels(edges), roughness=transform_roughness*roughness)
        if (allocated(error)) return
        call f%move_to(self%f)
        call finish(self, flat_radius, all_breaks, error)
        self%is_made = .not. allocated(error)
    end subroutine sample_from_height

    !> f on panels between the breaks and, towards the axis, by octaves.
    subroutine sample_height(f, height, largest, flat_radius, breaks, roughness, octaves, edges, error)
        type(sampled_function_t), intent(out) :: f
        class(scalar_function_t), intent(inout) :: height
        real(wp), intent(in) :: largest, flat_radius, breaks(:), roughness
        !> over which g is sampled below the first break
        integer, intent(out) :: octaves
        !> of the panels, before any was halved
        real(wp), allocatable, intent(out) :: edges(:)
        type(error_t), allocatable, intent(inout) :: error
        logical, allocatable :: roots(:)
        real(wp) :: top

        octaves = 0
        call check_sizes([first_break(breaks, largest), largest], error)
        if (allocated(error)) return
        top = height%value(largest)
        if (allocated(height%error)) error = height%error
        if (.not. allocated(error)) call check_sizes([top], error)
        if (.not. allocated(error)) call descending_edges(height, flat_radius, first_break(breaks, largest), top, roughness, &
                                                          octaves, error)
        if (.not. allocated(error)) call plan_panels(flat_radius, breaks, largest, octaves + extra_octaves, edges, roots, error)
        if (allocated(error)) return
        call new_sampled_function(f, height, edges, [logical ::], height_tolerance, error, most=most_panels(edges), &
                                  roughness=height_roughness*roughness, everywhere=.true.)
    end subroutine sample_height

    !> Transform g = `mdr` on [0, largest] back to f.
    subroutine sample_from_mdr(self, mdr, largest, flat_radius, breaks, error)
        type(sampled_profile_t), intent(out) :: self
        !> g(x) >= 0 with g(0) = 0, not decreasing [length]
        class(scalar_function_t), intent(inout) :: mdr
        real(wp), intent(in) :: largest, flat_radius
        real(wp), intent(in) :: breaks(:)
        type(error_t), allocatable, intent(out) :: error
        type(sampled_function_t), target :: g
        type(transform_t) :: transform
        real(wp), allocatable :: f_edges(:), g_edges(:)
        logical, allocatable :: roots(:)
        integer :: octaves

        call check_sizes([first_break(breaks, largest), largest, mdr%value(largest)], error)
        if (allocated(error)) return
        call descending_edges(mdr, flat_radius, first_break(breaks, largest), mdr%value(largest), epsilon(largest), octaves, error)
        if (allocated(error)) return
        call plan_panels(flat_radius, breaks, largest, octaves + extra_octaves, g_edges, roots, error)
        if (.not. allocated(error)) call plan_panels(flat_radius, breaks, largest, octaves, f_edges, roots, error)
        if (allocated(error)) return
        call new_sampled_function(g, mdr, g_edges, [logical ::], height_tolerance, error, most=most_panels(g_edges))
        if (allocated(error)) return
        call check_ascending(g, error)
        if (.not. allocated(error)) call new_transform(transform, g, .false., end_exponent(g, flat_radius), error)
        if (allocated(error)) return
        call new_sampled_function(self%f, transform, f_edges, roots, transform_tolerance, error, &
                                  noise=flat_noise(transform, flat_radius, first_break(breaks, largest)), most=most_panels(f_edges))
        if (allocated(error)) return
        call g%move_to(self%g)
        call finish(self, flat_radius, breaks, error)
        self%is_made = .not. allocated(error)
    end subroutine sample_from_mdr

    subroutine finish(self, flat_radius, breaks, error)
        type(sampled_profile_t), intent(inout) :: self
        real(wp), intent(in) :: flat_radius, breaks(:)
        type(error_t), allocatable, intent(inout) :: error
        integer :: flat_ends, stat

        self%end_radius = flat_radius
        self%largest_radius = self%g%upper()
        flat_ends = merge(1, 0, flat_radius > 0.0_wp)
        allocate (self%breaks(flat_ends + size(breaks)), stat=stat)
        call check_memory(error, stat)
        if (allocated(error)) return
        self%breaks(:flat_ends) = flat_radius
        self%breaks(flat_ends + 1:) = breaks
        self%f_exponent = end_exponent(self%f, flat_radius)
        self%g_exponent = end_exponent(self%g, flat_radius)
    end subroutine finish

    pure recursive function bytes(self)
        class(sampled_profile_t), intent(in) :: self
        integer(int64) :: bytes

        bytes = self%f%bytes() + self%g%bytes() + real_bytes*size(self%breaks)
    end function bytes

    elemental function height(self, x) result(y)
        class(sampled_profile_t), intent(in) :: self
        real(wp), intent(in) :: x
        real(wp) :: y

        if (x <= self%end_radius) then
            y = 0.0_wp
        else if (x < self%f%lower()) then
            y = self%f%value(self%f%lower())*(x/self%f%lower())**self%f_exponent
        else
            y = max(self%f%value(x), 0.0_wp)
        end if
    end function height

    elemental function slope(self, x) result(y)
        class(sampled_profile_t), intent(in) :: self
        real(wp), intent(in) :: x
        real(wp) :: y

        if (x <= self%end_radius) then
            y = 0.0_wp
        else if (x < self%f%lower()) then
            y = self%f_exponent*self%f%value(self%f%lower())/self%f%lower()*(x/self%f%lower())**(self%f_exponent - 1.0_wp)
        else
            ! f does not decrease, as was seen when it was sampled: less than 0 is the rounding of a level place
            y = max(self%f%slope(x), 0.0_wp)
        end if
    end function slope

    elemental function mdr(self, x) result(y)
        class(sampled_profile_t), intent(in) :: self
        real(wp), intent(in) :: x
        real(wp) :: y

        if (x <= self%end_radius) then
            y = 0.0_wp
        else if (x < self%g%lower()) then
            y = self%g%value(self%g%lower())*(x/self%g%lower())**self%g_exponent
        else
            y = max(self%g%value(x), 0.0_wp)
        end if
    end function mdr

    elemental function mdr_slope(self, x) result(y)
        class(sampled_profile_t), intent(in) :: self
        real(wp), intent(in) :: x
        real(wp) :: y

        if (x <= self%end_radius) then
            y = 0.0_wp
        else if (x < self%g%lower()) then
            y = self%g_exponent*self%g%value(self%g%lower())/self%g%lower()*(x/self%g%lower())**(self%g_exponent - 1.0_wp)
        else
            y = self%g%slope(x)
        end if
    end function mdr_slope

    !> x g(x) - int_0^x g(s) ds.
    elemental function mdr_moment(self, x) result(y)
        class(sampled_profile_t), intent(in) :: self
        real(wp), intent(in) :: x
        real(wp) :: y

        if (x <= self%end_radius) then
            y = 0.0_wp
        else if (x < self%g%lower()) then
            y = x*self%mdr(x)*self%g_exponent/(self%g_exponent + 1.0_wp)
        else
            y = x*self%g%value(x) - self%g%integral(x)
            if (self%end_radius <= 0.0_wp) y = y - self%g%lower()*self%g%value(self%g%lower())/(self%g_exponent + 1.0_wp)
        end if
    end function mdr_moment

    pure subroutine add_breaks(self, radii, error)
        class(sampled_profile_t), intent(in) :: self
        real(wp), allocatable, intent(inout) :: radii(:)
        type(error_t), allocatable, intent(inout) :: error

        call merge_breaks(radii, self%breaks, error)
    end subroutine add_breaks

    !> Loss of accuracy by rounding behind a flat end: relative accuracy of the transform at the first break.
    function flat_noise(transform, flat_radius, first) result(noise)
        class(scalar_function_t), intent(inout) :: transform
        real(wp), intent(in) :: flat_radius, first
        real(wp) :: noise

        noise = 0.0_wp
        if (flat_radius > 0.0_wp) noise = transform_tolerance*transform%value(first)
    end function flat_noise

    subroutine check_ascending(f, error)
        type(sampled_function_t), intent(in) :: f
        type(error_t), allocatable, intent(inout) :: error
        real(wp) :: heights(checks_in_panel), here, before, rounding, left, right
        integer :: i, j

        rounding = 1.0e-12_wp*f%value(f%upper())
        before = f%value(f%lower())
        do i = 1, size(f%from_root)
            left = f%edges(i)
            right = f%edges(i + 1)
            call f%values_in(i, left + (right - left)*[(real(j, wp)/checks_in_panel, j=1, checks_in_panel)], heights)
            do j = 1, checks_in_panel
                here = heights(j)
                if (here < before - rounding) then
                    call raise(error, error_invalid, "the profile decreases between "//to_text(left)//" and "//to_text(right)// &
                               ": it must not decrease")
                    return
                end if
                before = here
            end do
        end do
    end subroutine check_ascending

    !> Number of halvings of the first panel towards the axis: until the height is negligible and a power of the radius.
    subroutine descending_edges(f, flat_radius, first, top, roughness, count, error)
        class(scalar_function_t), intent(inout) :: f
        real(wp), intent(in) :: flat_radius, first, top, roughness
        integer, intent(out) :: count
        type(error_t), allocatable, intent(inout) :: error
        real(wp) :: height, outside, exponent, bend, scale

        outside = top
        exponent = huge(exponent)
        do count = 0, merge(flat_octaves, nint(-log(least_radius)/log(2.0_wp)), flat_radius > 0.0_wp) - 1
            scale = irrational*0.5_wp**(count + 1 + extra_octaves)
            height = f%value(flat_radius + (first - flat_radius)*scale)
            if (allocated(f%error)) error = f%error
            if (height <= 0.0_wp .and. outside > smallest_value*top .and. flat_radius <= 0.0_wp) then
                call raise(error, error_invalid, "f = "//to_text(height)//" at r = "//to_text(first*scale)// &
                           ": f must be greater than 0 for r > 0. For a flat end use a table with leading zeros of f")
            end if
            if (allocated(error)) return
            if (.not. height > least_value*top .or. first*scale < smallest_length) exit
            bend = abs(log(outside/height)/log(2.0_wp) - exponent)
            if ((height < smallest_value*top .or. scale < smallest_radius) .and. bend < max(straight, 4.0_wp*roughness)) exit
            exponent = log(outside/height)/log(2.0_wp)
            outside = height
        end do
        ! a function that falls faster than that within an octave still needs the octave
        count = max(count, 1)
    end subroutine descending_edges

    !> Raises unless lengths are far from the ends of the number range, where powers and products of them would leave it.
    pure subroutine check_sizes(lengths, error)
        real(wp), intent(in) :: lengths(:)
        type(error_t), allocatable, intent(inout) :: error
        integer :: i

        do i = 1, size(lengths)
            if (lengths(i) >= smallest_length .and. lengths(i) <= 1.0_wp/smallest_length) cycle
            call raise(error, error_invalid, "the length "//to_text(lengths(i))//" in this profile: radii and heights must "// &
                       "lie between "//to_text(smallest_length)//" and "//to_text(1.0_wp/smallest_length))
            return
        end do
    end subroutine check_sizes

    !> Every panel of the sampled function costs time in every value of its transform: more than this many are noise, not shape.
    pure function most_panels(edges) result(most)
        real(wp), intent(in) :: edges(:)
        integer :: most

        most = 1000 + 20*size(edges)
    end function most_panels

    !> The edges of panels: start + (stop - start) first_edge 2^-count, ... towards the first break, a flat end's own radius before
    !> them, then the breaks, with steps between those far apart, and the end. Behind a flat end and a break the transform has a
    !> square-root branch.
    pure subroutine plan_panels(flat_radius, breaks, largest, count, edges, roots, error)
        real(wp), intent(in) :: flat_radius, breaks(:), largest
        integer, intent(in) :: count
        real(wp), allocatable, intent(out) :: edges(:)
        !> of each panel: whether it begins at such a branch
        logical, allocatable, intent(out) :: roots(:)
        type(error_t), allocatable, intent(inout) :: error
        real(wp) :: next
        integer :: i, j, k, flat_ends, steps(size(breaks)), stat

        flat_ends = merge(1, 0, flat_radius > 0.0_wp)
        next = largest
        do j = size(breaks), 1, -1
            ! a little more than a whole number of steps is that number
            steps(j) = max(ceiling(log(next/breaks(j))/log(largest_step) - 1.0e-6_wp), 1)
            next = breaks(j)
        end do
        allocate (edges(flat_ends + count + sum(steps) + 2), stat=stat)
        if (stat == 0) allocate (roots(size(edges) - 1), stat=stat)
        call check_memory(error, stat)
        if (allocated(error)) return
        edges(:flat_ends) = flat_radius
        do i = 0, count
            edges(flat_ends + i + 1) = flat_radius + (first_break(breaks, largest) - flat_radius)*first_edge*0.5_wp**(count - i)
        end do
        roots(:flat_ends) = .true.
        roots(flat_ends + 1:) = .false.
        i = flat_ends + count + 2
        do j = 1, size(breaks)
            roots(i) = .true.
            edges(i:i + steps(j) - 1) = breaks(j)*[(largest_step**k, k=0, steps(j) - 1)]
            i = i + steps(j)
        end do
        edges(size(edges)) = largest
    end subroutine plan_panels

    pure function first_break(breaks, largest) result(radius)
        real(wp), intent(in) :: breaks(:), largest
        real(wp) :: radius

        radius = largest
        if (size(breaks) > 0) radius = breaks(1)
    end function first_break

    !> The power that f follows below its first edge; 0 behind a flat end, where it is 0.
    pure function end_exponent(f, flat_radius) result(exponent)
        type(sampled_function_t), intent(in) :: f
        real(wp), intent(in) :: flat_radius
        real(wp) :: exponent

        exponent = 0.0_wp
        if (flat_radius <= 0.0_wp) exponent = log_slope(f)
    end function end_exponent

    !> The power of x that f follows at its lower end, over its lowest octave so that rounding errors of f matter least.
    pure function log_slope(f) result(exponent)
        type(sampled_function_t), intent(in) :: f
        real(wp) :: exponent

        exponent = log(f%value(2.0_wp*f%lower())/f%value(f%lower()))/log(2.0_wp)
    end function log_slope

end module mdrcontact_profile_sampled
