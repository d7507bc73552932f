! SPDX-License-Identifier: GPL-3.0-or-later
!> Contribution of the load of a cohesive zone, q = -2 sigma_0 sqrt(c^2 - x^2) on a < |x| < c, to the displacement in it where the
!> kernel X varies at all lengths: (K q)(x) by panels that grow with the distance from x (theory/adhesion.md (2.4)); and to the gap
!> (2.5), in which X at one distance t has the weight of all pairs of places of the zone that are as far apart (2.13).
module mdrcontact_line_zone_effect
    use mdrcontact_error, only: error_no_convergence, error_t, raise
    use mdrcontact_kinds, only: pi, wp
    use mdrcontact_line_kernel, only: kernel_t
    use mdrcontact_line_zone_rule, only: new_zone_rule, zone_rule_t
    use mdrcontact_numerics_quadrature, only: gauss_legendre
    implicit none (type, external)
    private
    public :: effect_of_zone, effect_on_gap

    !> Nodes of a panel, and how many there may be in all for one place.
    integer, parameter :: nodes = 16, most = 80*nodes
    !> A panel is so long, in units of the kernel, or so many times as long as it is away from the place; one in which the load has
    !> its root, or begins to vary next to one, is shorter.
    real(wp), parameter :: shortest = 2.0_wp, longest = 3.0_wp, longest_at_root = 2.0_wp
    !> Length of a panel over the remaining distance to a root.
    real(wp), parameter :: towards_root = 0.6_wp
    !> Nodes of the integral over pairs of places, and the part of the zone over which the closest pairs are summed at once.
    integer, parameter :: nodes_of_pairs = 20
    real(wp), parameter :: closest = 1.0e-6_wp
    !> The mirror image of the zone varies over so many contact radii.
    real(wp), parameter :: image_length = 0.5_wp
    !> Relative, of integrals with the mirror image.
    real(wp), parameter :: all_digits = epsilon(1.0_wp)

    !> Nodes around one place.
    type :: around_t
        integer :: count = 0
        !> distances from the place, distances of the load from c, and dx there
        real(wp) :: distance(most), left(most), dx(most)
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
        real(wp) :: node(nodes), weight(nodes)
        integer :: i

        values = 0.0_wp
        call gauss_legendre(node, weight, error)
        if (allocated(error)) return
        do i = 1, size(beyond)
            around%count = 0
            associate (here => beyond(i), left => length - beyond(i))
                call add_panels(around, kernel%unit, 0.0_wp, left, node, weight)
                call add_panels(around, kernel%unit, 0.0_wp, here, node, weight, left)
                call add_panels(around, kernel%unit, 2.0_wp*a + here, 2.0_wp*a + here + length, node, weight)
            end associate
            call check_room(around, error)
            if (allocated(error)) return
            values(i) = -stress*sum_around(around, kernel, a + length, shift)/(pi*kernel%unit)
        end do
    end subroutine effect_of_zone

    !> int_a^c (K q)(x)/sqrt(c^2 - x^2) dx/E0* [length].
    subroutine effect_on_gap(kernel, a, length, stress, shift, value, error)
        type(kernel_t), intent(in) :: kernel
        !> as in effect_of_zone
        real(wp), intent(in) :: a, length, stress, shift
        real(wp), intent(out) :: value
        type(error_t), allocatable, intent(inout) :: error
        type(around_t) :: around
        type(zone_rule_t) :: rule
        real(wp) :: x(most), node(nodes), weight(nodes), pair_node(nodes_of_pairs), pair_weight(nodes_of_pairs)
        integer :: i

        value = 0.0_wp
        call gauss_legendre(node, weight, error)
        if (.not. allocated(error)) call gauss_legendre(pair_node, pair_weight, error)
        if (.not. allocated(error)) call new_zone_rule(rule, a, length, [-1.0_wp], max(kernel%unit, image_length*a), all_digits, &
                                                       error, graded=.true.)
        if (allocated(error)) return
        ! pairs of places close to each other have a weight with t ln t
        call add_panels(around, min(kernel%unit, closest*length), 0.0_wp, length, node, weight)
        call check_room(around, error)
        if (allocated(error)) return
        associate (n => around%count)
            call kernel%evaluate(around%distance(:n)/kernel%unit, shift, x(:n))
            do i = 1, n
                value = value + around%dx(i)*x(i)*pairs(a + length, around%distance(i), around%left(i), pair_node, pair_weight)
            end do
        end associate
        do i = 1, size(rule%beyond)
            around%count = 0
            associate (here => 2.0_wp*a + rule%beyond(i))
                call add_panels(around, kernel%unit, here, here + length, node, weight)
            end associate
            call check_room(around, error)
            if (allocated(error)) return
            value = value + rule%over_root(i)*sum_around(around, kernel, a + length, shift)
        end do
        value = -stress*value/(pi*kernel%unit)
    end subroutine effect_on_gap

    !> The weight of the distance t: int sqrt(c^2 - s^2)/sqrt(c^2 - x^2) dx over the places x and s of the zone with |x - s| = t.
    !> The roots that are close to each other, at c and t away from it, are taken out by c - max(x, s) = t sinh(v)^2.
    pure function pairs(end, t, left, node, weight) result(total)
        !> c, t, and c - a - t [length]
        real(wp), intent(in) :: end, t, left
        real(wp), intent(in) :: node(:), weight(:)
        real(wp) :: total
        real(wp), dimension(size(node)) :: grown, square, ratio
        real(wp) :: last

        last = asinh(sqrt(left/t))
        grown = exp(2.0_wp*last*node)
        ! sinh(v)^2
        square = 0.25_wp*(grown + 1.0_wp/grown - 2.0_wp)
        ratio = sqrt((2.0_wp*end - t - t*square)/(2.0_wp*end - t*square))
        total = 2.0_wp*t*last*sum(weight*((1.0_wp + square)*ratio + square/ratio))
    end function pairs

    !> int X sqrt(c^2 - x^2) dx.
    pure function sum_around(around, kernel, end, shift) result(total)
        type(around_t), intent(in) :: around
        type(kernel_t), intent(in) :: kernel
        !> c
        real(wp), intent(in) :: end
        real(wp), intent(in) :: shift
        real(wp) :: total
        real(wp) :: x(around%count)

        associate (n => around%count)
            call kernel%evaluate(around%distance(:n)/kernel%unit, shift, x)
            total = sum(around%dx(:n)*sqrt(around%left(:n)*(2.0_wp*end - around%left(:n)))*x)
        end associate
    end function sum_around

    !> Raises where there were too many panels.
    pure subroutine check_room(around, error)
        type(around_t), intent(in) :: around
        type(error_t), allocatable, intent(inout) :: error

        if (around%count <= most) return
        call raise(error, error_no_convergence, "the cohesive zone spans too many lengths at which the body varies: a larger "// &
                   "cohesive_stress makes it shorter")
    end subroutine check_room

    !> Panels at the distances `from` to `to` from a place: up to c, where the load has its root, or away from c.
    pure subroutine add_panels(around, unit, from, to, node, weight, behind)
        type(around_t), intent(inout) :: around
        !> of the kernel [length]
        real(wp), intent(in) :: unit
        real(wp), intent(in) :: from, to
        real(wp), intent(in) :: node(nodes), weight(nodes)
        !> distance of c behind the place; default: at `to`
        real(wp), intent(in), optional :: behind
        real(wp) :: here, step
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
                       left => around%left(around%count + 1:around%count + nodes), &
                       dx => around%dx(around%count + 1:around%count + nodes))
                if (at_root) then
                    left = step*node**2
                    distance = here + step*((1.0_wp - node)*(1.0_wp + node))
                    dx = 2.0_wp*step*weight*node
                else
                    distance = here + step*node
                    left = to - distance
                    if (present(behind)) left = behind + distance
                    dx = step*weight
                end if
            end associate
            around%count = around%count + nodes
            if (at_root .or. here + step >= to) exit
            here = here + step
        end do
    end subroutine add_panels

end module mdrcontact_line_zone_effect
