! SPDX-License-Identifier: GPL-3.0-or-later
!> Plane figures: what a horizontal plane cuts out of a body, and where circles around the contact's axis meet its outline.
!>
!> Coordinates are relative to the axis. An outline is given by the angles at which a circle crosses it and by the radii of
!> the circles that touch it: between two such radii the cut arcs are analytic functions of the radius.
module mdrcontact_lateral_section
    use mdrcontact_kinds, only: half_pi, pi, wp
    use mdrcontact_lateral_trigonometric, only: trigonometric_roots
    implicit none (type, external)
    private
    public :: section_t, nothing, everything, ellipse, strip, rectangle, holds, crossing_angles, touching_radii, most_crossings
    public :: is_round

    !> no point, every point
    integer, parameter :: nothing = 0, everything = 1
    !> semi-axes extent(1:2), the first one along `direction`
    integer, parameter :: ellipse = 2
    !> points whose distance from the line through `centre` at right angles to `direction` lies between -extent(1) and extent(2),
    !> counted along `direction`; an infinite extent makes a half-plane
    integer, parameter :: strip = 3
    !> half-widths extent(1:2), sides along and across `direction`
    integer, parameter :: rectangle = 4
    !> a circle crosses an outline at most this often
    integer, parameter :: most_crossings = 8

    !> A plane figure.
    type :: section_t
        integer :: kind = nothing
        real(wp) :: centre(2) = 0.0_wp
        !> a unit vector
        real(wp) :: direction(2) = [1.0_wp, 0.0_wp]
        real(wp) :: extent(2) = 0.0_wp
    end type section_t

contains

    !> Whether it is a disc, of radius extent(1).
    elemental function is_round(self) result(answer)
        type(section_t), intent(in) :: self
        logical :: answer

        answer = self%kind == ellipse .and. self%extent(1) == self%extent(2)
    end function is_round

    !> Whether the point lies inside.
    pure function holds(self, point) result(answer)
        type(section_t), intent(in) :: self
        real(wp), intent(in) :: point(2)
        logical :: answer
        real(wp) :: along, across

        along = dot_product(point - self%centre, self%direction)
        across = self%direction(1)*(point(2) - self%centre(2)) - self%direction(2)*(point(1) - self%centre(1))
        select case (self%kind)
        case (everything)
            answer = .true.
        case (ellipse)
            answer = (along/self%extent(1))**2 + (across/self%extent(2))**2 < 1.0_wp
        case (strip)
            answer = along > -self%extent(1) .and. along < self%extent(2)
        case (rectangle)
            answer = abs(along) < self%extent(1) .and. abs(across) < self%extent(2)
        case default
            answer = .false.
        end select
    end function holds

    !> Angles, not ordered, at which the circle of radius rho around the origin crosses the outline.
    subroutine crossing_angles(self, rho, angles, count)
        type(section_t), intent(in) :: self
        real(wp), intent(in) :: rho
        real(wp), intent(out) :: angles(most_crossings)
        integer, intent(out) :: count
        real(wp) :: bearing, centre(2), inverse(2)
        integer :: i

        count = 0
        if (is_round(self)) then
            call add_circle(self%centre, self%extent(1), rho, angles, count)
            angles(:count) = modulo(angles(:count), 2.0_wp*pi)
            return
        end if
        bearing = atan2(self%direction(2), self%direction(1))
        centre = local_centre(self)
        select case (self%kind)
        case (ellipse)
            ! most circles meet none: roots cost much
            if (rho >= norm2(centre) + maxval(self%extent)) return
            if (rho <= max(norm2(centre) - maxval(self%extent), minval(self%extent) - norm2(centre))) return
            inverse = 1.0_wp/self%extent**2
            call trigonometric_roots(dot_product(centre**2, inverse) - 1.0_wp + 0.5_wp*rho**2*sum(inverse), &
                                     -2.0_wp*rho*centre(1)*inverse(1), -2.0_wp*rho*centre(2)*inverse(2), &
                                     0.5_wp*rho**2*(inverse(1) - inverse(2)), 0.0_wp, angles(:4), count)
        case (strip)
            call add_line(centre(1) - self%extent(1), rho, 0.0_wp, angles, count)
            call add_line(centre(1) + self%extent(2), rho, 0.0_wp, angles, count)
        case (rectangle)
            do i = 1, 2
                call add_line(centre(i) - self%extent(i), rho, (i - 1)*half_pi, angles, count)
                call add_line(centre(i) + self%extent(i), rho, (i - 1)*half_pi, angles, count)
            end do
        case default
            return
        end select
        angles(:count) = modulo(angles(:count) + bearing, 2.0_wp*pi)
    end subroutine crossing_angles

    !> Radii, not ordered, of the circles around the origin that touch the outline or pass through its corners.
    subroutine touching_radii(self, radii, count)
        type(section_t), intent(in) :: self
        real(wp), intent(out) :: radii(most_crossings)
        integer, intent(out) :: count
        real(wp) :: centre(2), angles(4)
        integer :: i

        count = 0
        centre = local_centre(self)
        select case (self%kind)
        case (ellipse)
            if (is_round(self)) then
                count = 2
                radii(:2) = abs(norm2(centre) + [-1.0_wp, 1.0_wp]*self%extent(1))
                return
            end if
            ! d/dphi |centre + (A cos phi, B sin phi)|^2 = 0
            call trigonometric_roots(0.0_wp, centre(2)*self%extent(2), -centre(1)*self%extent(1), 0.0_wp, &
                                     0.5_wp*(self%extent(2)**2 - self%extent(1)**2), angles, count)
            do i = 1, count
                radii(i) = norm2(centre + self%extent*[cos(angles(i)), sin(angles(i))])
            end do
        case (strip)
            count = 2
            radii(:2) = abs(centre(1) + [-1.0_wp, 1.0_wp]*self%extent)
        case (rectangle)
            count = 8
            radii(1:2) = abs(centre(1) + [-1.0_wp, 1.0_wp]*self%extent(1))
            radii(3:4) = abs(centre(2) + [-1.0_wp, 1.0_wp]*self%extent(2))
            radii(5:6) = hypot(centre(1) - self%extent(1), centre(2) + [-1.0_wp, 1.0_wp]*self%extent(2))
            radii(7:8) = hypot(centre(1) + self%extent(1), centre(2) + [-1.0_wp, 1.0_wp]*self%extent(2))
        case default
            return
        end select
    end subroutine touching_radii

    !> Adds the angles at which the circle around the origin meets another one.
    pure subroutine add_circle(centre, radius, rho, angles, count)
        real(wp), intent(in) :: centre(2), radius, rho
        real(wp), intent(inout) :: angles(:)
        integer, intent(inout) :: count
        real(wp) :: distance, half

        distance = norm2(centre)
        if (.not. (abs(distance - radius) < rho .and. rho < distance + radius)) return
        ! the sides of a triangle, by the tangent of half its angle
        half = 2.0_wp*atan2(sqrt((radius - (distance - rho))*(radius + (distance - rho))), &
                            sqrt((distance + rho - radius)*(distance + rho + radius)))
        angles(count + 1:count + 2) = atan2(centre(2), centre(1)) + [-half, half]
        count = count + 2
    end subroutine add_circle

    pure function local_centre(self) result(centre)
        type(section_t), intent(in) :: self
        real(wp) :: centre(2)

        centre(1) = dot_product(self%centre, self%direction)
        centre(2) = self%direction(1)*self%centre(2) - self%direction(2)*self%centre(1)
    end function local_centre

    !> Adds the angles at which the circle meets the line at signed distance `at` in the direction `bearing`.
    pure subroutine add_line(at, rho, bearing, angles, count)
        real(wp), intent(in) :: at, rho, bearing
        real(wp), intent(inout) :: angles(:)
        integer, intent(inout) :: count
        real(wp) :: half

        if (abs(at) >= rho) return
        half = acos(at/rho)
        angles(count + 1:count + 2) = bearing + [-half, half]
        count = count + 2
    end subroutine add_line

end module mdrcontact_lateral_section
