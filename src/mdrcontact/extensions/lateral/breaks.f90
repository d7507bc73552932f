! SPDX-License-Identifier: GPL-3.0-or-later
!> Depths and radii between which the integrands of a structure of bodies are analytic (theory/lateral.md (1.2)): those at which an
!> outline begins or ends, and those at which the outlines of two balls, or of two discs in a plane, cross.
!>
!> Parts covered by a later ball or disc do not contribute: only visible parts need panels, for any number of overlaps.
module mdrcontact_lateral_breaks
    use mdrcontact_nonfinite, only: is_finite
    use mdrcontact_kinds, only: wp
    use mdrcontact_lateral_section, only: is_round, most_crossings, section_t, touching_radii
    use mdrcontact_lateral_shape, only: depth_breaks, most_depths, section_at, shape_ball, shape_t
    implicit none (type, external)
    private
    public :: depths_between, radii_between

    !> The depth, over a, at which the sections at the surface are considered.
    real(wp), parameter :: surface = 1.0e-6_wp
    !> Balls whose centres lie so nearly above each other, by the sine, cross at one depth.
    real(wp), parameter :: upright = 1.0e-6_wp

    !> Balls, or discs: centre (i, :) and radius (i), each under those that follow.
    type :: round_t
        real(wp), allocatable :: centre(:, :), radius(:)
    end type round_t

contains

    !> Depths over a where sections are not analytic, any order, and last the one to which panels resolve what lies next to.
    function depths_between(shapes, x, y, a) result(breaks)
        type(shape_t), intent(in) :: shapes(:)
        real(wp), intent(in) :: x, y, a
        real(wp), allocatable :: breaks(:)
        type(round_t) :: balls
        real(wp), dimension(3) :: towards, middle, up
        real(wp) :: depths(most_depths), touching(most_crossings), beside, farthest, half
        logical :: is_ball(size(shapes))
        integer :: i, j, found

        allocate (breaks(0))
        farthest = 0.0_wp
        is_ball = shapes%kind == shape_ball
        do i = 1, size(shapes)
            call depth_breaks(shapes(i), x, y, depths, found)
            if (.not. is_ball(i)) breaks = [breaks, depths(:found)/a]
            ! what lies far next to the contact is seen from depths as large
            beside = surface
            if (found == 2 .and. all(is_finite(depths))) beside = max(surface, 0.5_wp*sum(depths)/a)
            call touching_radii(section_at(shapes(i), x, y, a, beside), touching, found)
            farthest = max(farthest, maxval(touching(:found), mask=is_finite(touching(:found))))
        end do
        allocate (balls%centre(count(is_ball), 3))
        do j = 1, 3
            balls%centre(:, j) = pack([(shapes(i)%parameters(j), i=1, size(shapes))], is_ball)
        end do
        balls%radius = pack([(shapes(i)%parameters(4), i=1, size(shapes))], is_ball)
        up = [0.0_wp, 0.0_wp, 1.0_wp]
        do i = 1, size(balls%radius)
            middle = balls%centre(i, :)
            call add(i, middle, balls%radius(i)*up)
            do j = i + 1, size(balls%radius)
                call cross(balls, i, j, towards, middle, half)
                if (half < 0.0_wp) cycle
                towards = up - towards(3)*towards
                if (norm2(towards) > upright) then
                    call add(j, middle, half*towards/norm2(towards))
                else
                    breaks = [breaks, middle(3)/a]
                end if
            end do
        end do
        breaks = [breaks, farthest]

    contains

        !> The depths of centre -+ arm, on ball i and on ball `on`, where they are seen.
        subroutine add(on, centre, arm)
            integer, intent(in) :: on
            real(wp), intent(in) :: centre(3), arm(3)

            if (is_seen(balls, i, on, centre - arm)) breaks = [breaks, (centre(3) - arm(3))/a]
            if (is_seen(balls, i, on, centre + arm)) breaks = [breaks, (centre(3) + arm(3))/a]
        end subroutine add

    end function depths_between

    !> Radii where the arcs of circles around the axis are not analytic, any order.
    function radii_between(sections) result(breaks)
        type(section_t), intent(in) :: sections(:)
        real(wp), allocatable :: breaks(:)
        type(round_t) :: discs
        real(wp), dimension(2) :: towards, middle
        real(wp) :: touching(most_crossings), half
        logical :: is_disc(size(sections))
        integer :: i, j, found

        allocate (breaks(0))
        is_disc = is_round(sections)
        do i = 1, size(sections)
            if (is_disc(i)) cycle
            call touching_radii(sections(i), touching, found)
            breaks = [breaks, pack(touching(:found), is_finite(touching(:found)))]
        end do
        allocate (discs%centre(count(is_disc), 2))
        do j = 1, 2
            discs%centre(:, j) = pack([(sections(i)%centre(j), i=1, size(sections))], is_disc)
        end do
        discs%radius = pack([(sections(i)%extent(1), i=1, size(sections))], is_disc)
        do i = 1, size(discs%radius)
            towards = [1.0_wp, 0.0_wp]
            middle = discs%centre(i, :)
            if (norm2(middle) > 0.0_wp) towards = middle/norm2(middle)
            call add(i, middle, discs%radius(i)*towards)
            do j = i + 1, size(discs%radius)
                call cross(discs, i, j, towards, middle, half)
                if (half >= 0.0_wp) call add(j, middle, half*[-towards(2), towards(1)])
            end do
        end do

    contains

        !> The radii of centre -+ arm, on disc i and on disc `on`, where they are seen.
        subroutine add(on, centre, arm)
            integer, intent(in) :: on
            real(wp), intent(in) :: centre(2), arm(2)

            if (is_seen(discs, i, on, centre - arm)) breaks = [breaks, norm2(centre - arm)]
            if (is_seen(discs, i, on, centre + arm)) breaks = [breaks, norm2(centre + arm)]
        end subroutine add

    end function radii_between

    !> Whether none after the first holds a point of its outline, but for the one on whose outline it lies too.
    pure function is_seen(self, first, on, point) result(answer)
        type(round_t), intent(in) :: self
        integer, intent(in) :: first, on
        real(wp), intent(in) :: point(:)
        logical :: answer
        integer :: k

        answer = .false.
        ! the last one holds the most
        do k = size(self%radius), first + 1, -1
            if (k == on) cycle
            if (sum((self%centre(k, :) - point)**2) < self%radius(k)**2) return
        end do
        answer = .true.
    end function is_seen

    !> Where two outlines cross: `half` next to `middle`, at right angles to the unit vector `towards` the second centre; half < 0
    !> if they do not.
    pure subroutine cross(self, i, j, towards, middle, half)
        type(round_t), intent(in) :: self
        integer, intent(in) :: i, j
        real(wp), intent(out) :: towards(:), middle(:), half
        real(wp) :: distance, along

        half = -1.0_wp
        towards = self%centre(j, :) - self%centre(i, :)
        middle = 0.0_wp
        distance = norm2(towards)
        associate (r => self%radius(i), s => self%radius(j))
            if (.not. (abs(r - s) < distance .and. distance < r + s)) return
            towards = towards/distance
            along = 0.5_wp*(distance + (r - s)*((r + s)/distance))
            middle = self%centre(i, :) + along*towards
            half = sqrt(max((r - along)*(r + along), 0.0_wp))
        end associate
    end subroutine cross

end module mdrcontact_lateral_breaks
