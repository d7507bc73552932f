! SPDX-License-Identifier: GPL-3.0-or-later
!> Bodies embedded in a half-space z > 0: layers, half-spaces, balls, fibres, pillars, boxes (theory/lateral.md (1.2)).
module mdrcontact_lateral_shape
    use mdrcontact_nonfinite, only: infinity, is_finite, is_nan
    use mdrcontact_codes, only: shape_ball, shape_box, shape_fibre, shape_half_space, shape_layer, shape_pillar
    use mdrcontact_error, only: check_finite, check_made, check_positive, count_text, error_invalid, error_t, raise, to_text
    use mdrcontact_kinds, only: wp
    use mdrcontact_lateral_section, only: ellipse, everything, rectangle, section_t, strip
    use mdrcontact_material, only: material_t
    implicit none (type, external)
    private
    public :: shape_t, new_shape, section_at, depth_breaks, most_depths
    public :: shape_layer, shape_half_space, shape_ball, shape_fibre, shape_pillar, shape_box

    !> a shape has at most so many special depths
    integer, parameter :: most_depths = 2

    !> An axis this close to the horizontal, by the sine of its inclination, is taken as horizontal.
    real(wp), parameter :: horizontal = 1.0e-6_wp

    !> A body of one material.
    type :: shape_t
        !> whether it was made: set last by what makes it
        logical :: is_made = .false.
        !> one of shape_...
        integer :: kind = shape_layer
        !> as above; directions have unit length
        real(wp) :: parameters(7) = 0.0_wp
        !> what fills it
        type(material_t) :: material
    end type shape_t

contains

    !> A body. `parameters` beyond those of the kind are ignored.
    subroutine new_shape(self, kind, parameters, material, error)
        type(shape_t), intent(out) :: self
        !> one of shape_...
        integer, intent(in) :: kind
        !> as defined with the constants shape_... [length]; directions of any length
        real(wp), intent(in) :: parameters(7)
        type(material_t), intent(in) :: material
        type(error_t), allocatable, intent(out) :: error

        call check_made(error, "material", material%young > 0.0_wp)
        if (allocated(error)) return
        self%kind = kind
        self%parameters = parameters
        self%material = material
        select case (kind)
        case (shape_layer)
            call check_interval(error, "z_top", parameters(1), "z_bottom", parameters(2))
        case (shape_half_space)
            call check_all(error, "the interface", parameters(:6))
            call normalize(error, "normal", self%parameters(4:6))
        case (shape_ball)
            call check_all(error, "the ball", parameters(:3))
            call check_positive(error, "radius", parameters(4))
        case (shape_fibre)
            call check_all(error, "the fibre", parameters(:6))
            call normalize(error, "direction", self%parameters(4:6))
            call check_positive(error, "radius", parameters(7))
        case (shape_pillar)
            call check_all(error, "the pillar", parameters(:2))
            call check_positive(error, "radius", parameters(3))
            call check_interval(error, "z_top", parameters(4), "z_bottom", parameters(5))
        case (shape_box)
            call check_all(error, "the box", parameters(:4))
            call check_interval(error, "x_low", parameters(1), "x_high", parameters(2))
            call check_interval(error, "y_low", parameters(3), "y_high", parameters(4))
            call check_interval(error, "z_top", parameters(5), "z_bottom", parameters(6))
        case default
            call raise(error, error_invalid, "kind = "//count_text(kind)//": it must be layer (0), half-space (1), ball (2), "// &
                       "fibre (3), pillar (4) or box (5)")
        end select
        self%is_made = .not. allocated(error)
    end subroutine new_shape

    !> Cross-section of the body at depth z = a xi, in units of a and relative to the axis through (x, y).
    pure function section_at(self, x, y, a, xi) result(section)
        type(shape_t), intent(in) :: self
        real(wp), intent(in) :: x, y, a, xi
        type(section_t) :: section
        real(wp) :: z, half, slope

        z = a*xi
        section%centre = (self%parameters(1:2) - [x, y])/a
        associate (p => self%parameters)
            select case (self%kind)
            case (shape_layer)
                if (z > p(1) .and. z < p(2)) section%kind = everything
            case (shape_half_space)
                slope = norm2(p(4:5))
                if (slope < horizontal) then
                    if ((z - p(3))*p(6) > 0.0_wp) section%kind = everything
                    return
                end if
                section%kind = strip
                section%direction = p(4:5)/slope
                section%extent = [(z - p(3))/a*p(6)/slope, infinity]
            case (shape_ball)
                half = (p(4) - (z - p(3)))*(p(4) + (z - p(3)))
                if (half <= 0.0_wp) return
                section%kind = ellipse
                section%extent = sqrt(half)/a
            case (shape_fibre)
                slope = norm2(p(4:5))
                if (abs(p(6)) < horizontal) then
                    half = (p(7) - (z - p(3)))*(p(7) + (z - p(3)))
                    if (half <= 0.0_wp) return
                    section%kind = strip
                    section%direction = [-p(5), p(4)]/slope
                    section%extent = sqrt(half)/a
                else
                    section%kind = ellipse
                    section%centre = section%centre + p(4:5)*((z - p(3))/(p(6)*a))
                    if (slope > 0.0_wp) section%direction = p(4:5)/slope
                    section%extent = p(7)/a*[1.0_wp/abs(p(6)), 1.0_wp]
                end if
            case (shape_pillar)
                if (z <= p(4) .or. z >= p(5)) return
                section%kind = ellipse
                section%extent = p(3)/a
            case (shape_box)
                if (z <= p(5) .or. z >= p(6)) return
                section%kind = rectangle
                section%centre = ([0.5_wp*(p(1) + p(2)), 0.5_wp*(p(3) + p(4))] - [x, y])/a
                section%extent = 0.5_wp*[p(2) - p(1), p(4) - p(3)]/a
            case default
                return
            end select
        end associate
    end function section_at

    !> Depths where the section is not an analytic function of z; not ordered, of any sign.
    pure subroutine depth_breaks(self, x, y, depths, count)
        type(shape_t), intent(in) :: self
        !> place of the contact
        real(wp), intent(in) :: x, y
        real(wp), intent(out) :: depths(most_depths)
        integer, intent(out) :: count
        real(wp) :: slope

        depths = 0.0_wp
        count = 2
        associate (p => self%parameters)
            select case (self%kind)
            case (shape_layer)
                depths = p(1:2)
            case (shape_ball)
                depths = p(3) + [-1.0_wp, 1.0_wp]*p(4)
            case (shape_pillar)
                depths = p(4:5)
            case (shape_box)
                depths = p(5:6)
            case (shape_fibre)
                ! around the point of the axis that is nearest next to the contact, as far as the fibre is thick above and below
                slope = norm2(p(4:5))
                count = merge(2, 0, slope >= horizontal)
                if (count == 0) return
                depths = p(3) - p(6)*dot_product(p(1:2) - [x, y], p(4:5))/slope**2 + [-1.0_wp, 1.0_wp]*p(7)/slope
            case default
                depths = p(3)
                count = 1
            end select
        end associate
    end subroutine depth_breaks

    pure subroutine check_all(error, name, values)
        type(error_t), allocatable, intent(inout) :: error
        character(len=*), intent(in) :: name
        real(wp), intent(in) :: values(:)
        integer :: i

        do i = 1, size(values)
            call check_finite(error, "coordinate "//count_text(i)//" of "//name, values(i))
        end do
    end subroutine check_all

    pure subroutine check_interval(error, low_name, low, high_name, high)
        type(error_t), allocatable, intent(inout) :: error
        character(len=*), intent(in) :: low_name, high_name
        real(wp), intent(in) :: low, high

        if (is_nan(low) .or. is_nan(high)) then
            call raise(error, error_invalid, low_name//" and "//high_name//": they must not be NaN")
        else if (.not. low < high) then
            call raise(error, error_invalid, high_name//" = "//to_text(high)//": it must be greater than "//low_name//" = "// &
                       to_text(low))
        end if
    end subroutine check_interval

    pure subroutine normalize(error, name, direction)
        type(error_t), allocatable, intent(inout) :: error
        character(len=*), intent(in) :: name
        real(wp), intent(inout) :: direction(3)
        real(wp) :: length

        if (allocated(error)) return
        length = norm2(direction)
        if (is_finite(length) .and. length > 0.0_wp) then
            direction = direction/length
        else
            call raise(error, error_invalid, name//" of length "//to_text(length)//": the length must be finite and greater than 0")
        end if
    end subroutine normalize

end module mdrcontact_lateral_shape
