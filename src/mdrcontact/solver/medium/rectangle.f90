! SPDX-License-Identifier: GPL-3.0-or-later
!> Potential of uniform rectangles at several depths at a point of the surface (theory/exact.md (6.4), (6.5)).
!>
!> Love, Phil. Trans. R. Soc. A 228 (1929) 377.
module mdrcontact_medium_rectangle
    use mdrcontact_kinds, only: wp
    implicit none (type, external)
    private
    public :: rectangle_potential

    !> Distances, in units of the longer half side, from which a product rule replaces the closed form, whose terms then cancel, and
    !> the series (6.5) the rule: each to rounding, because the weights of images cancel also.
    real(wp), parameter :: near = 4.5_wp, far = 64.0_wp
    !> Gauss's rule of eight points.
    real(wp), parameter :: half_nodes(4) = [0.18343464249564980_wp, 0.52553240991632899_wp, 0.79666647741362674_wp, &
                                            0.96028985649753623_wp], &
                           nodes(8) = [half_nodes, -half_nodes], &
                           half_weights(4) = [0.36268378337836198_wp, 0.31370664587788729_wp, 0.22238103445337447_wp, &
                                              0.10122853629037626_wp], &
                           weights(8) = [half_weights, half_weights]

contains

    !> bare I(0) + sum weight I(depth), I(z) = int int dx' dy'/sqrt((x - x')^2 + (y - y')^2 + z^2) over the rectangle.
    pure function rectangle_potential(half, x, y, bare, weight, depth) result(potential)
        !> half sides > 0 along x and y [length]
        real(wp), intent(in) :: half(2)
        !> the point, in the first quadrant from the centre [length]
        real(wp), intent(in) :: x, y
        real(wp), intent(in) :: bare
        !> depths in ascending order [length]
        real(wp), intent(in), contiguous :: weight(:), depth(:)
        real(wp) :: potential
        real(wp) :: area, far2, squares(2), place(2), parts(size(depth))
        integer :: i, first

        squares = half**2
        place = [x, y]**2
        area = 4.0_wp*half(1)*half(2)
        far2 = (far*maxval(half))**2 - sum(place)
        potential = 0.0_wp
        first = 1
        if (bare > 0.0_wp) potential = bare*potential_at(half, x, y, 0.0_wp)
        if (far2 > 0.0_wp) then
            do first = 1, size(depth)
                if (depth(first)**2 > far2) exit
                potential = potential + weight(first)*potential_at(half, x, y, depth(first))
            end do
        end if
        do i = first, size(depth)
            parts(i) = weight(i)*series(squares, place, depth(i)**2)
        end do
        potential = potential + area*sum(parts(first:))
    end function rectangle_potential

    !> I(z) at any distance.
    pure function potential_at(half, x, y, z) result(potential)
        real(wp), intent(in) :: half(2), x, y, z
        real(wp) :: potential
        real(wp) :: distance, columns(8)
        integer :: i

        distance = sqrt(x**2 + y**2 + z**2)/maxval(half)
        if (distance > far) then
            potential = 4.0_wp*half(1)*half(2)*series(half**2, [x, y]**2, z**2)
        else if (distance > near) then
            do i = 1, 8
                columns(i) = sum(weights/sqrt((x - half(1)*nodes(i))**2 + (y - half(2)*nodes)**2 + z**2))
            end do
            potential = half(1)*half(2)*sum(weights*columns)
        else
            potential = closed_form(half, x, y, z)
        end if
    end function potential_at

    !> I(z) by its corners.
    pure function closed_form(half, x, y, z) result(potential)
        real(wp), intent(in) :: half(2), x, y, z
        real(wp) :: potential
        real(wp) :: right, left, top, bottom

        right = x + half(1)
        left = x - half(1)
        top = y + half(2)
        bottom = y - half(2)
        potential = edge(right, top, bottom, z) - edge(left, top, bottom, z) + edge(top, right, left, z) &
                    - edge(bottom, right, left, z)
        if (z > 0.0_wp) potential = potential - z*(angle(right, top, z) - angle(left, top, z) - angle(right, bottom, z) &
                                                   + angle(left, bottom, z))
    end function closed_form

    !> Contribution of an edge at the distance `a` from `low` to `high`.
    pure function edge(a, high, low, z) result(part)
        real(wp), intent(in) :: a, high, low, z
        real(wp) :: part
        real(wp) :: distance

        distance = hypot(a, z)
        part = 0.0_wp
        if (abs(a) > 0.0_wp) part = a*(asinh(high/distance) - asinh(low/distance))
    end function edge

    pure function angle(a, b, z)
        real(wp), intent(in) :: a, b, z
        real(wp) :: angle

        angle = atan2(a*b, z*sqrt(a**2 + b**2 + z**2))
    end function angle

    !> I(z) over the area far away, by the moments of the rectangle up to the sixth order.
    pure function series(half, place, depth) result(sum_of)
        !> squares of the half sides, of x and y, and of z [length^2]
        real(wp), intent(in) :: half(2), place(2), depth
        real(wp) :: sum_of
        real(wp) :: u, a, b, s, t

        u = 1.0_wp/(place(1) + place(2) + depth)
        s = place(1)*u
        t = place(2)*u
        a = half(1)*u
        b = half(2)*u
        sum_of = sqrt(u)*(1.0_wp + (a*(3.0_wp*s - 1.0_wp) + b*(3.0_wp*t - 1.0_wp))/6.0_wp &
                          + (a**2*quartic(s) + b**2*quartic(t))/40.0_wp + a*b*(1.0_wp - 5.0_wp*(s + t) + 35.0_wp*s*t)/12.0_wp &
                          + (a**3*sextic(s) + b**3*sextic(t))/112.0_wp + a*b*(a*mixed(s, t) + b*mixed(t, s))/16.0_wp)
    end function series

    !> Derivatives of 1/R along x, 4 and 6 times, and 4 times along x and twice along y, by s = x^2/R^2 and t = y^2/R^2, over 3, 45
    !> and 45 and the power of R.
    pure function quartic(s) result(value)
        real(wp), intent(in) :: s
        real(wp) :: value

        value = (35.0_wp*s - 30.0_wp)*s + 3.0_wp
    end function quartic

    pure function sextic(s) result(value)
        real(wp), intent(in) :: s
        real(wp) :: value

        value = ((231.0_wp*s - 315.0_wp)*s + 105.0_wp)*s - 5.0_wp
    end function sextic

    pure function mixed(s, t) result(value)
        real(wp), intent(in) :: s, t
        real(wp) :: value

        value = (231.0_wp*t - 21.0_wp)*s**2 - 126.0_wp*s*t + 14.0_wp*s + 7.0_wp*t - 1.0_wp
    end function mixed

end module mdrcontact_medium_rectangle
