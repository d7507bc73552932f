! SPDX-License-Identifier: GPL-3.0-or-later
!> Contribution of the load of a cohesive zone, q = -2 sigma_0 sqrt(c^2 - x^2) on a < |x| < c, to the displacement in it where the
!> kernel X varies at all lengths: (K q)(x) by panels that grow with the distance from x: theory/adhesion.md (2.4).
module mdrcontact_line_zone_effect
    use mdrcontact_error, only: error_no_convergence, error_t, raise
    use mdrcontact_kinds, only: pi, wp
    use mdrcontact_line_kernel, only: kernel_t
    use mdrcontact_numerics_quadrature, only: gauss_legendre
    implicit none (type, external)
    private
    public :: effect_of_zone

    !> Nodes of a panel, and how many there may be in all for one place.
    integer, parameter :: nodes = 16, most = 80*nodes
    !> A panel is so long, in units of the kernel, or so many times as long as it is away from the place; one in which the load has
    !> its root, or begins to vary next to one, is shorter.
    real(wp), parameter :: shortest = 2.0_wp, longest = 3.0_wp, longest_at_root = 2.0_wp
    !> Length of a panel over the remaining distance to a root.
    real(wp), parameter :: towards_root = 0.6_wp

    !> Nodes around one place.
    type :: around_t
        integer :: count = 0
        !> distances from the place, and q dx there
        real(wp) :: distance(most), load(most)
    end type around_t

contains

    !> (K q)(x)/E0* [length] at places of the zone.
    subroutine effect_of_zone(kernel, a, length, stress, beyond, shift, values, error)
        type(kernel_t), intent(in) :: kernel
        !> a >= 0, c - a > 0 [length]
        real(wp), intent(in) :: a, length
        !> 2 sigma_0/E0* [1]
        real(wp), intent(in) :: stress
        !> x - a, 0 <= x - a < c - a [length]
        real(wp), intent(in) :: beyond(:)
        !> a constant taken off X [1/unit]
        real(wp), intent(in) :: shift
        real(wp), intent(out) :: values(:)
        type(error_t), allocatable, intent(inout) :: error
        type(around_t) :: around
        real(wp) :: x(most), node(nodes), weight(nodes)
        integer :: i

        values = 0.0_wp
        call gauss_legendre(node, weight, error)
        if (allocated(error)) return
        do i = 1, size(beyond)
            around%count = 0
            associate (here => beyond(i), left => length - beyond(i))
                call add_panels(around, kernel%unit, 0.0_wp, left, a + length, node, weight)
                call add_panels(around, kernel%unit, 0.0_wp, here, a + length, node, weight, left)
                call add_panels(around, kernel%unit, 2.0_wp*a + here, 2.0_wp*a + here + length, a + length, node, weight)
            end associate
            if (around%count > most) then
                call raise(error, error_no_convergence, "the cohesive zone spans too many lengths at which the body varies: a "// &
                           "larger cohesive_stress makes it shorter")
                return
            end if
            associate (n => around%count)
                call kernel%evaluate(around%distance(:n)/kernel%unit, shift, x(:n))
                values(i) = -stress*sum(around%load(:n)*x(:n))/(pi*kernel%unit)
            end associate
        end do
    end subroutine effect_of_zone

    !> Panels at the distances `from` to `to` from a place: up to c, where the load has its root, or away from c.
    pure subroutine add_panels(around, unit, from, to, end, node, weight, behind)
        type(around_t), intent(inout) :: around
        !> of the kernel [length]
        real(wp), intent(in) :: unit
        real(wp), intent(in) :: from, to
        !> c
        real(wp), intent(in) :: end
        real(wp), intent(in) :: node(nodes), weight(nodes)
        !> distance of c behind the place; default: at `to`
        real(wp), intent(in), optional :: behind
        real(wp) :: here, step, left(nodes)
        logical :: at_root

        here = from
        do while (here < to)
            if (around%count + nodes > most) then
                around%count = most + 1
                return
            end if
            at_root = .false.
            if (present(behind)) then
                step = min(max(shortest*unit, longest*here), longest_at_root*(here + behind))
                if (here + 1.2_wp*step > to) step = to - here
            else
                at_root = to - here <= max(shortest*unit, longest_at_root*here)
                step = to - here
                if (.not. at_root) step = min(max(shortest*unit, longest*here), towards_root*step)
            end if
            associate (distance => around%distance(around%count + 1:around%count + nodes), &
                       load => around%load(around%count + 1:around%count + nodes))
                if (at_root) then
                    left = step*node**2
                    distance = here + step*((1.0_wp - node)*(1.0_wp + node))
                    load = 2.0_wp*step*weight*node*sqrt(left*(2.0_wp*end - left))
                else
                    distance = here + step*node
                    left = to - distance
                    if (present(behind)) left = behind + distance
                    load = step*weight*sqrt(left*(2.0_wp*end - left))
                end if
            end associate
            around%count = around%count + nodes
            if (at_root .or. here + step >= to) exit
            here = here + step
        end do
    end subroutine add_panels

end module mdrcontact_line_zone_effect
