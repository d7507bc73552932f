! SPDX-License-Identifier: GPL-3.0-or-later
!> Line loads known in closed form: q(x) = sum of c_i x^(i - 1), as those of a flat punch, cone, paraboloid on a half-space.
module example_loads
    use mdrcontact_error, only: error_invalid, error_t, raise, to_text
    use mdrcontact_medium_load, only: load_t
    use mdrcontact_kinds, only: half_pi, wp
    implicit none (type, external)
    private
    public :: inside_load_t, polynomial_load_t, rough_load_t, hertz_load, cone_load, punch_load

    !> A load that is known by its slope: stresses inside alone can read it.
    type, abstract, extends(load_t) :: inside_load_t
    contains
        procedure :: line_load => no_field
        procedure :: pressure => no_field
        procedure :: displacement => no_field
    end type inside_load_t

    type, extends(inside_load_t) :: polynomial_load_t
        real(wp), allocatable :: coefficients(:)
    contains
        procedure :: slope
    end type polynomial_load_t

    !> A parabola with waves of q' of 6e-6 a: a thousand panels of some nodes each do not follow them.
    type, extends(inside_load_t) :: rough_load_t
    contains
        procedure :: slope => rough_slope
    end type rough_load_t

contains

    subroutine no_field(self, r, values, error)
        class(inside_load_t), intent(in) :: self
        real(wp), intent(in) :: r(:)
        real(wp), intent(out) :: values(:)
        type(error_t), allocatable, intent(out) :: error

        values = 0.0_wp*r
        call raise(error, error_invalid, "a load of radius "//to_text(self%radius)//" of which the slope alone is known")
    end subroutine no_field

    pure function rough_slope(self, start, distance) result(y)
        class(rough_load_t), intent(in) :: self
        real(wp), intent(in) :: start, distance(:)
        real(wp) :: y(size(distance))

        y = -(start + distance)/self%radius*(1.0_wp + 1.0e-3_wp*sin(1.0e6_wp*(start + distance)/self%radius))
    end function rough_slope

    pure function slope(self, start, distance) result(y)
        class(polynomial_load_t), intent(in) :: self
        real(wp), intent(in) :: start, distance(:)
        real(wp) :: y(size(distance))
        integer :: i

        y = 0.0_wp
        do i = size(self%coefficients), 2, -1
            y = real(i - 1, wp)*self%coefficients(i) + (start + distance)*y
        end do
    end function slope

    pure function with_coefficients(radius, coefficients) result(load)
        real(wp), intent(in) :: radius, coefficients(:)
        type(polynomial_load_t) :: load
        integer :: i

        load%radius = radius
        allocate (load%coefficients, source=coefficients)
        allocate (load%kinks(0))
        load%edge = sum(coefficients*[(radius**(i - 1), i=1, size(coefficients))])
        if (abs(load%edge) < 1.0e-14_wp*maxval(abs(coefficients))) load%edge = 0.0_wp
    end function with_coefficients

    !> Pressure p0 sqrt(1 - r^2/a^2): p0 = 2 E* a/(pi R), q = E* (a^2 - x^2)/R.
    pure function hertz_load(radius, p0) result(load)
        real(wp), intent(in) :: radius, p0
        type(polynomial_load_t) :: load

        load = with_coefficients(radius, half_pi*p0*[radius, 0.0_wp, -1.0_wp/radius])
    end function hertz_load

    !> Pressure p_m arcosh(a/r), p_m the mean pressure: q = pi p_m (a - x).
    pure function cone_load(radius, mean) result(load)
        real(wp), intent(in) :: radius, mean
        type(polynomial_load_t) :: load

        load = with_coefficients(radius, 2.0_wp*half_pi*mean*[radius, -1.0_wp])
    end function cone_load

    !> Pressure p_m/(2 sqrt(1 - r^2/a^2)): q = pi p_m a/2.
    pure function punch_load(radius, mean) result(load)
        real(wp), intent(in) :: radius, mean
        type(polynomial_load_t) :: load

        load = with_coefficients(radius, [half_pi*mean*radius])
    end function punch_load

end module example_loads
