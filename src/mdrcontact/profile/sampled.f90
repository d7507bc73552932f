! SPDX-License-Identifier: GPL-3.0-or-later
!> Indenters without a closed form: a user's function, a table, an area function. f and g are sampled once, when the indenter
!> is made, and from then on cost as little as a closed form; a user's function is not called again.
module mdrcontact_profile_sampled
    use mdrcontact_error, only: error_invalid, error_t, raise, to_text
    use mdrcontact_kinds, only: half_pi, wp
    use mdrcontact_profile, only: profile_t
    use mdrcontact_numerics_quadrature, only: gauss_legendre
    use mdrcontact_numerics_sampled_function, only: new_sampled_function, sampled_function_t
    use mdrcontact_numerics_scalar_function, only: scalar_function_t
    implicit none (type, external)
    private
    public :: sampled_profile_t, sample_from_height, sample_from_mdr

    !> f and g between a smallest and the largest radius, and as powers of the radius below.
    type, extends(profile_t) :: sampled_profile_t
        private
        type(sampled_function_t) :: f, g
        real(wp) :: f_exponent = 0.0_wp, g_exponent = 0.0_wp
        !> radius of the flat end, 0 if there is none [length]
        real(wp) :: flat_radius = 0.0_wp
        !> radii where f is not analytic, ascending [length]
        real(wp), allocatable :: breaks(:)
    contains
        procedure :: height
        procedure :: slope
        procedure :: mdr
        procedure :: mdr_slope
        procedure :: mdr_moment
        procedure :: largest_radius
        procedure :: end_radius
        procedure :: break_radii
    end type sampled_profile_t

    !> g(x) = x int_0^{pi/2} f'(x sin t) dt, equation (3).
    type, extends(scalar_function_t) :: forward_transform_t
        type(sampled_function_t), pointer :: f => null()
        real(wp), allocatable :: edges(:)
        !> f follows this power below its first edge
        real(wp) :: exponent = 0.0_wp
    contains
        procedure :: value => forward_value
    end type forward_transform_t

    !> f(r) = (2/pi) int_0^{pi/2} g(r sin t) dt, equation (4).
    type, extends(scalar_function_t) :: backward_transform_t
        type(sampled_function_t), pointer :: g => null()
        real(wp), allocatable :: edges(:)
        !> g follows this power below its first edge
        real(wp) :: exponent = 0.0_wp
    contains
        procedure :: value => backward_value
    end type backward_transform_t

    real(wp), parameter :: height_tolerance = 1.0e-14_wp, transform_tolerance = 2.0e-14_wp
    !> f is sampled this much further down than g; below it is a power of r, whose transform is a fast power series.
    integer, parameter :: extra_octaves = 1, series_terms = 28
    !> Points in a panel, smooth by construction, at which a profile is seen not to decrease.
    integer, parameter :: checks_in_panel = 16
    !> Octaves towards a flat end, where x - b loses the digits of x and only absolute accuracy is left to have.
    integer, parameter :: flat_octaves = 10
    !> Keeps the radii that probe for lost digits off powers of 2, where a user's formula may lose none by chance.
    real(wp), parameter :: irrational = 0.7390851332151607_wp
    !> Lengths below it, and above its inverse, are refused.
    real(wp), parameter :: smallest_length = 1.0e-150_wp
    !> The range over which f and g are sampled: down to this fraction of their largest value or of the largest radius.
    real(wp), parameter :: smallest_value = 1.0e-20_wp, smallest_radius = 1.0e-10_wp

contains

    !> Samples f = `height` on [0, largest] and transforms it.
    subroutine sample_from_height(self, height, largest, flat_radius, breaks, may_lose_digits, error)
        type(sampled_profile_t), intent(out) :: self
        !> f(r) >= 0 with f(0) = 0, not decreasing [length]
        class(scalar_function_t), intent(inout) :: height
        !> radius where the profile ends [length]
        real(wp), intent(in) :: largest
        !> radius up to which f = 0 [length]
        real(wp), intent(in) :: flat_radius
        !> ascending radii in (flat_radius, largest) where f is not analytic [length]
        real(wp), intent(in) :: breaks(:)
        !> whether `height` may lose relative accuracy towards the axis, as a user's formula does
        logical, intent(in) :: may_lose_digits
        type(error_t), allocatable, intent(out) :: error
        type(sampled_function_t), target :: f
        type(forward_transform_t) :: transform
        real(wp), allocatable :: f_edges(:), g_edges(:)
        real(wp) :: top
        integer :: count, i

        call check_sizes([first_break(breaks, largest), largest], error)
        if (allocated(error)) return
        top = height%value(largest)
        if (.not. allocated(height%error)) call check_start(height, flat_radius, top, error)
        if (allocated(height%error)) error = height%error
        if (.not. allocated(error)) call check_sizes([top], error)
        if (allocated(error)) return
        call descending_edges(height, flat_radius, first_break(breaks, largest), top, may_lose_digits, count, error)
        if (allocated(error)) return
        f_edges = [geometric(flat_radius, first_break(breaks, largest), count + extra_octaves), breaks, largest]
        g_edges = [geometric(flat_radius, first_break(breaks, largest), count), breaks, largest]

        call new_sampled_function(f, height, f_edges, [(.false., i=1, size(f_edges) - 1)], height_tolerance, error, &
                                  noise=4.0_wp*epsilon(top)*top, most=most_panels(f_edges))
        if (allocated(error)) return
        call check_ascending(f, error)
        if (allocated(error)) return
        transform%f => f
        transform%edges = f%panel_edges()
        if (flat_radius <= 0.0_wp) transform%exponent = log_slope(f)
        call new_sampled_function(self%g, transform, g_edges, [(root_starts(g_edges(i), flat_radius, breaks), &
                                                                i=1, size(g_edges) - 1)], transform_tolerance, error, &
                                  noise=max(flat_noise(transform, flat_radius, first_break(breaks, largest)), &
                                            merge(100.0_wp*epsilon(top)*top, 0.0_wp, may_lose_digits)), most=most_panels(g_edges))
        if (allocated(error)) return
        self%f = f
        call finish(self, flat_radius, breaks)
    end subroutine sample_from_height

    !> Takes g = `mdr` on [0, largest] and transforms it back to f.
    subroutine sample_from_mdr(self, mdr, largest, flat_radius, breaks, error)
        type(sampled_profile_t), intent(out) :: self
        !> g(x) >= 0 with g(0) = 0, not decreasing [length]
        class(scalar_function_t), intent(inout) :: mdr
        real(wp), intent(in) :: largest, flat_radius
        real(wp), intent(in) :: breaks(:)
        type(error_t), allocatable, intent(out) :: error
        type(sampled_function_t), target :: g
        type(backward_transform_t) :: transform
        real(wp), allocatable :: f_edges(:), g_edges(:)
        integer :: i, octaves

        call check_sizes([first_break(breaks, largest), largest, mdr%value(largest)], error)
        if (allocated(error)) return
        octaves = merge(flat_octaves, 33, flat_radius > 0.0_wp)
        g_edges = [geometric(flat_radius, first_break(breaks, largest), octaves + extra_octaves), breaks, largest]
        f_edges = [geometric(flat_radius, first_break(breaks, largest), octaves), breaks, largest]
        call new_sampled_function(g, mdr, g_edges, [(.false., i=1, size(g_edges) - 1)], height_tolerance, error, &
                                  most=most_panels(g_edges))
        if (allocated(error)) return
        call check_ascending(g, error)
        if (allocated(error)) return
        transform%g => g
        transform%edges = g%panel_edges()
        if (flat_radius <= 0.0_wp) transform%exponent = log_slope(g)
        call new_sampled_function(self%f, transform, f_edges, [(root_starts(f_edges(i), flat_radius, breaks), &
                                                                i=1, size(f_edges) - 1)], transform_tolerance, error, &
                                  noise=flat_noise(transform, flat_radius, first_break(breaks, largest)), most=most_panels(f_edges))
        if (allocated(error)) return
        self%g = g
        call finish(self, flat_radius, breaks)
    end subroutine sample_from_mdr

    subroutine finish(self, flat_radius, breaks)
        type(sampled_profile_t), intent(inout) :: self
        real(wp), intent(in) :: flat_radius, breaks(:)

        self%flat_radius = flat_radius
        self%breaks = breaks
        if (flat_radius > 0.0_wp) then
            self%breaks = [flat_radius, breaks]
        else
            self%f_exponent = log_slope(self%f)
            self%g_exponent = log_slope(self%g)
        end if
    end subroutine finish

    elemental function height(self, x) result(y)
        class(sampled_profile_t), intent(in) :: self
        real(wp), intent(in) :: x
        real(wp) :: y

        if (x <= self%flat_radius) then
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

        if (x <= self%flat_radius) then
            y = 0.0_wp
        else if (x < self%f%lower()) then
            y = self%f_exponent*self%f%value(self%f%lower())/self%f%lower()*(x/self%f%lower())**(self%f_exponent - 1.0_wp)
        else
            y = self%f%slope(x)
        end if
    end function slope

    elemental function mdr(self, x) result(y)
        class(sampled_profile_t), intent(in) :: self
        real(wp), intent(in) :: x
        real(wp) :: y

        if (x <= self%flat_radius) then
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

        if (x <= self%flat_radius) then
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

        if (x <= self%flat_radius) then
            y = 0.0_wp
        else if (x < self%g%lower()) then
            y = x*self%mdr(x)*self%g_exponent/(self%g_exponent + 1.0_wp)
        else
            y = x*self%g%value(x) - self%g%integral(x)
            if (self%flat_radius <= 0.0_wp) y = y - self%g%lower()*self%g%value(self%g%lower())/(self%g_exponent + 1.0_wp)
        end if
    end function mdr_moment

    pure function largest_radius(self) result(radius)
        class(sampled_profile_t), intent(in) :: self
        real(wp) :: radius

        radius = self%g%upper()
    end function largest_radius

    pure function end_radius(self) result(radius)
        class(sampled_profile_t), intent(in) :: self
        real(wp) :: radius

        radius = self%flat_radius
    end function end_radius

    pure function break_radii(self) result(radii)
        class(sampled_profile_t), intent(in) :: self
        real(wp), allocatable :: radii(:)

        radii = self%breaks
    end function break_radii

    !> Panel by panel in t, r = x sin t, where the integrand is smooth.
    function forward_value(self, x) result(y)
        class(forward_transform_t), intent(inout) :: self
        real(wp), intent(in) :: x
        real(wp) :: y
        real(wp) :: from, to, nodes(20), weights(20)
        integer :: i, n

        y = 0.0_wp
        if (self%exponent > 0.0_wp) then
            y = self%exponent*self%f%value(self%edges(1))*below_first(self%edges(1)/x, self%exponent)
        end if
        from = asin(min(self%edges(1)/x, 1.0_wp))
        do i = 2, size(self%edges)
            to = asin(min(self%edges(i)/x, 1.0_wp))
            n = nodes_for(to - from)
            call gauss_legendre(nodes(:n), weights(:n))
            y = y + x*(to - from)*sum(weights(:n)*self%f%slope(min(x*sin(from + (to - from)*nodes(:n)), self%edges(i))))
            if (self%edges(i) >= x) exit
            from = to
        end do
    end function forward_value

    function backward_value(self, x) result(y)
        class(backward_transform_t), intent(inout) :: self
        real(wp), intent(in) :: x
        real(wp) :: y
        real(wp) :: from, to, nodes(20), weights(20)
        integer :: i, n

        from = asin(min(self%edges(1)/x, 1.0_wp))
        y = 0.0_wp
        if (self%exponent > 0.0_wp) then
            y = self%g%value(self%edges(1))*self%edges(1)/x*below_first(self%edges(1)/x, self%exponent + 1.0_wp)
        end if
        do i = 2, size(self%edges)
            to = asin(min(self%edges(i)/x, 1.0_wp))
            n = nodes_for(to - from)
            call gauss_legendre(nodes(:n), weights(:n))
            y = y + (to - from)*sum(weights(:n)*self%g%value(min(x*sin(from + (to - from)*nodes(:n)), self%edges(i))))
            if (self%edges(i) >= x) exit
            from = to
        end do
        y = y/half_pi
    end function backward_value

    !> int_0^1 s^(n-1)/sqrt(1 - (q s)^2) ds for q <= 1/2: the transform of a power below the first edge.
    pure function below_first(q, n) result(integral)
        real(wp), intent(in) :: q, n
        real(wp) :: integral, coefficient
        integer :: k

        integral = 1.0_wp/n
        coefficient = 1.0_wp
        do k = 1, series_terms
            coefficient = coefficient*q**2*(2*k - 1)/(2*k)
            integral = integral + coefficient/(n + 2*k)
        end do
    end function below_first

    !> Gauss nodes for a panel of this angle: fewer where a fine table makes narrow panels.
    pure function nodes_for(angle) result(n)
        real(wp), intent(in) :: angle
        integer :: n

        n = merge(8, 20, angle < 0.05_wp)
    end function nodes_for

    !> What is lost to rounding behind a flat end: relative accuracy of the transform at the first break.
    function flat_noise(transform, flat_radius, first) result(noise)
        class(scalar_function_t), intent(inout) :: transform
        real(wp), intent(in) :: flat_radius, first
        real(wp) :: noise

        noise = 0.0_wp
        if (flat_radius > 0.0_wp) noise = transform_tolerance*transform%value(first)
    end function flat_noise

    !> f(0) must be 0, and the profile must rise at all.
    subroutine check_start(f, flat_radius, top, error)
        class(scalar_function_t), intent(inout) :: f
        real(wp), intent(in) :: flat_radius, top
        type(error_t), allocatable, intent(inout) :: error
        real(wp) :: start

        start = f%value(0.0_wp)
        if (allocated(f%error)) return
        if (abs(start) > 1.0e-12_wp*abs(top) .and. flat_radius <= 0.0_wp) then
            call raise(error, error_invalid, "f(0) = "//to_text(start)//" is not allowed: heights are counted from the "// &
                       "indenter's lowest point, f(0) = 0")
        else if (.not. top > 0.0_wp) then
            call raise(error, error_invalid, "f at the largest radius = "//to_text(top)//" is not allowed: the profile must rise")
        end if
    end subroutine check_start

    subroutine check_ascending(f, error)
        type(sampled_function_t), intent(in) :: f
        type(error_t), allocatable, intent(inout) :: error
        real(wp), allocatable :: edges(:)
        real(wp) :: here, before, rounding
        integer :: i, j

        allocate (edges, source=f%panel_edges())
        rounding = 1.0e-12_wp*f%value(edges(size(edges)))
        before = f%value(edges(1))
        do i = 2, size(edges)
            do j = 1, checks_in_panel
                here = f%value(edges(i - 1) + (edges(i) - edges(i - 1))*real(j, wp)/checks_in_panel)
                if (here < before - rounding) then
                    call raise(error, error_invalid, "the profile decreases between "//to_text(edges(i - 1))//" and "// &
                               to_text(edges(i))//": it must not")
                    return
                end if
                before = here
            end do
        end do
    end subroutine check_ascending

    !> How many times the first panel is halved towards the axis: until the height is negligible or, for a function that
    !> may lose digits there (R - sqrt(R^2 - r^2)), until ln f stops becoming straighter in ln r.
    subroutine descending_edges(f, flat_radius, first, top, may_lose_digits, count, error)
        class(scalar_function_t), intent(inout) :: f
        real(wp), intent(in) :: flat_radius, first, top
        logical, intent(in) :: may_lose_digits
        integer, intent(out) :: count
        type(error_t), allocatable, intent(inout) :: error
        real(wp) :: values(3), bend, bend_before

        count = 0
        values = 0.0_wp
        bend_before = huge(bend)
        do while (count < merge(flat_octaves, nint(-log(smallest_radius)/log(2.0_wp)), flat_radius > 0.0_wp))
            values(2:3) = values(1:2)
            values(1) = f%value(flat_radius + irrational*(first - flat_radius)*0.5_wp**(count + 1 + extra_octaves))
            if (allocated(f%error)) then
                error = f%error
                return
            end if
            if (.not. values(1) > smallest_value*top) exit
            if (may_lose_digits .and. values(3) > 0.0_wp) then
                bend = abs(log(values(1)/values(2)) - log(values(2)/values(3)))
                if (bend > bend_before .and. bend > 1.0e-12_wp) exit
                bend_before = bend
            end if
            count = count + 1
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
            call raise(error, error_invalid, "the length "//to_text(lengths(i))//" in this profile is not allowed: radii and "// &
                       "heights must be between "//to_text(smallest_length)//" and "//to_text(1.0_wp/smallest_length))
            return
        end do
    end subroutine check_sizes

    !> Every panel of the sampled function costs time in every value of its transform: more than this many are noise, not shape.
    pure function most_panels(edges) result(most)
        real(wp), intent(in) :: edges(:)
        integer :: most

        most = 1000 + 20*size(edges)
    end function most_panels

    !> start + (stop - start) 2^-count, ..., up to but without stop; a flat end adds its own radius.
    pure function geometric(start, stop, count) result(edges)
        real(wp), intent(in) :: start, stop
        integer, intent(in) :: count
        real(wp), allocatable :: edges(:)
        integer :: i

        edges = [(start + (stop - start)*0.5_wp**i, i=count, 1, -1)]
        if (start > 0.0_wp) edges = [start, edges]
    end function geometric

    pure function first_break(breaks, largest) result(radius)
        real(wp), intent(in) :: breaks(:), largest
        real(wp) :: radius

        radius = largest
        if (size(breaks) > 0) radius = breaks(1)
    end function first_break

    pure function root_starts(edge, flat_radius, breaks) result(answer)
        real(wp), intent(in) :: edge, flat_radius, breaks(:)
        logical :: answer

        answer = (flat_radius > 0.0_wp .and. edge == flat_radius) .or. any(breaks == edge)
    end function root_starts

    !> The power of x that f follows at its lower end, over its lowest octave so that rounding errors of f matter least.
    pure function log_slope(f) result(exponent)
        type(sampled_function_t), intent(in) :: f
        real(wp) :: exponent

        exponent = log(f%value(2.0_wp*f%lower())/f%value(f%lower()))/log(2.0_wp)
    end function log_slope

end module mdrcontact_profile_sampled
