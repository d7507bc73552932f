! SPDX-License-Identifier: GPL-3.0-or-later
!> Weights of boxes: rectangular cells of a slab (theory/lateral.md (2.9)). Lengths in units of the contact radius, the contact at
!> the origin.
!>
!> With D(rho) = int_rho^inf W rho drho the integral of W over a rectangle is -(closed integral of D dtheta along its boundary),
!> plus the whole for the rectangle that holds the axis. So the singular edge of the contact is integrated once, in D, and
!> neighbouring cells share their edges: what the quadrature along an edge loses in one cell it gives to the next.
module mdrcontact_lateral_cells
    use mdrcontact_cancel, only: check_cancelled
    use mdrcontact_error, only: error_t
    use mdrcontact_kinds, only: half_pi, wp
    use mdrcontact_lateral_slab, only: outside, slab_distance, slab_t
    implicit none (type, external)
    private
    public :: cell_weights

    !> Edges are halved towards the foot of the axis as far as need be, towards the ring so often, and to this length at least.
    integer, parameter :: deepest = 7
    real(wp), parameter :: shortest = 1.0_wp/64.0_wp
    real(wp), parameter :: outer2 = 0.5773502691896257645_wp
    real(wp), parameter :: node4(4) = [-0.8611363115940525752_wp, -0.3399810435848562648_wp, &
                                       0.3399810435848562648_wp, 0.8611363115940525752_wp]
    real(wp), parameter :: weight4(4) = [0.3478548451374538574_wp, 0.6521451548625461426_wp, &
                                         0.6521451548625461426_wp, 0.3478548451374538574_wp]

contains

    !> Weights of the cells between ascending lines x(0:nx) and y(0:ny).
    subroutine cell_weights(slab, x, y, shear, poisson, error)
        type(slab_t), intent(in) :: slab
        real(wp), intent(in) :: x(0:), y(0:)
        !> (nx, ny)
        real(wp), intent(out) :: shear(:, :), poisson(:, :)
        type(error_t), allocatable, intent(inout) :: error
        real(wp) :: edge(2), left(2, size(y) - 1), below(2)
        integer :: i, j, panel

        panel = 1
        do j = 1, ubound(y, 1)
            call edge_integral(slab, x(0), y(j - 1), y(j), panel, left(:, j))
        end do
        do i = 1, ubound(x, 1)
            call check_cancelled(error)
            if (allocated(error)) return
            call edge_integral(slab, y(0), x(i - 1), x(i), panel, below)
            do j = 1, ubound(y, 1)
                ! counter-clockwise around the cell; its upper side follows below
                call edge_integral(slab, x(i), y(j - 1), y(j), panel, edge)
                associate (weight => left(:, j) - edge + below + turns(x(i - 1), x(i), y(j - 1), y(j))*slab%whole)
                    shear(i, j) = weight(1)
                    poisson(i, j) = weight(2)
                end associate
                left(:, j) = edge
                call edge_integral(slab, y(j), x(i - 1), x(i), panel, edge)
                shear(i, j) = shear(i, j) - edge(1)
                poisson(i, j) = poisson(i, j) - edge(2)
                below = edge
            end do
        end do
    end subroutine cell_weights

    !> int D dtheta along the line at distance c from the axis, from v = low to high, where dtheta = c dv/(c^2 + v^2), which has no
    !> squares as dv/(c + v (v/c)).
    pure recursive subroutine edge_integral(slab, c, low, high, panel, integral, depth)
        type(slab_t), intent(in) :: slab
        real(wp), intent(in) :: c, low, high
        integer, intent(inout) :: panel
        real(wp), intent(out) :: integral(2)
        integer, intent(in), optional :: depth
        real(wp) :: length, centre, near, far, v, weights(2), part(2)
        integer :: level, i

        integral = 0.0_wp
        if (c == 0.0_wp) return
        level = 0
        if (present(depth)) level = depth
        length = high - low
        centre = 0.5_wp*(low + high)
        near = abs(c)
        if (low > 0.0_wp .or. high < 0.0_wp) near = hypot(c, min(abs(low), abs(high)))
        if (24.0_wp*length < min(near, slab_distance(slab, near), slab_distance(slab, near + length))) then
            do i = -1, 1, 2
                v = centre + 0.5_wp*i*length*outer2
                call outside(slab, hypot(c, v), panel, weights)
                integral = integral + weights*(0.5_wp*length/(c + v*(v/c)))
            end do
            return
        end if
        far = hypot(c, max(abs(low), abs(high)))
        if (3.0_wp*length > near .or. (3.0_wp*length > ring_distance(slab, near, far) .and. &
                                       (level < deepest .or. length > shortest))) then
            call edge_integral(slab, c, low, centre, panel, integral, level + 1)
            call edge_integral(slab, c, centre, high, panel, part, level + 1)
            integral = integral + part
            return
        end if
        do i = 1, 4
            v = centre + 0.5_wp*length*node4(i)
            call outside(slab, hypot(c, v), panel, weights)
            integral = integral + weights*(0.5_wp*length*weight4(i)/(c + v*(v/c)))
        end do
    end subroutine edge_integral

    !> Distance of radii near ... far from the singular ring.
    elemental function ring_distance(slab, near, far) result(distance)
        type(slab_t), intent(in) :: slab
        real(wp), intent(in) :: near, far
        real(wp) :: distance

        distance = slab_distance(slab, min(max(1.0_wp, near), far))
    end function ring_distance

    !> The angle under which the axis sees the rectangle's boundary: 2 pi inside, pi on a side, pi/2 at a corner, 0 outside.
    elemental function turns(x_low, x_high, y_low, y_high) result(angle)
        real(wp), intent(in) :: x_low, x_high, y_low, y_high
        real(wp) :: angle

        angle = half_pi*sides(x_low, x_high)*sides(y_low, y_high)
    end function turns

    elemental function sides(low, high) result(count)
        real(wp), intent(in) :: low, high
        integer :: count

        count = merge(1, 0, low < 0.0_wp .and. high >= 0.0_wp) + merge(1, 0, low <= 0.0_wp .and. high > 0.0_wp)
    end function sides

end module mdrcontact_lateral_cells
