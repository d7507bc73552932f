! SPDX-License-Identifier: GPL-3.0-or-later
!> Functions on a contact that vary at all lengths next to its edge, from their values at few places: Chebyshev panels that shrink
!> towards the edge, interpolated at the nodes of a rule with many more.
module mdrcontact_line_edge_panels
    use mdrcontact_kinds, only: pi, wp
    use mdrcontact_numerics_chebyshev, only: node
    implicit none (type, external)
    private
    public :: edge_panels_t, new_edge_panels

    !> Panels, and values at the nodes of a rule as sums of those at the places of one panel.
    type :: edge_panels_t
        !> distances from the edge over the contact radius
        real(wp), allocatable :: places(:)
        !> for each node the place before those of its panel, and the weights of these
        integer, allocatable, private :: before(:)
        real(wp), allocatable, private :: weights(:, :)
    contains
        procedure :: at_nodes
    end type edge_panels_t

contains

    !> `count` places on each of the panels between `ends`, from the edge inwards.
    pure subroutine new_edge_panels(self, ends, count, nodes)
        type(edge_panels_t), intent(out) :: self
        !> ascending from 0 to 1
        real(wp), intent(in) :: ends(0:)
        integer, intent(in) :: count
        !> distances of the nodes from the edge over the contact radius, 0 to 1
        real(wp), intent(in) :: nodes(:)
        real(wp) :: place(count), weight(count)
        integer :: i, panel

        place = [(node(i, count), i=1, count)]
        weight = [(sin(pi*(i - 0.5_wp)/count)*merge(1.0_wp, -1.0_wp, modulo(i, 2) == 1), i=1, count)]
        self%places = [(ends(panel - 1) + 0.5_wp*(ends(panel) - ends(panel - 1))*(1.0_wp + place), panel=1, ubound(ends, 1))]
        allocate (self%before(size(nodes)), self%weights(count, size(nodes)))
        do i = 1, size(nodes)
            panel = max(findloc(ends >= nodes(i), .true., dim=1) - 1, 1)
            self%before(i) = (panel - 1)*count
            self%weights(:, i) = interpolation(place, weight, &
                                               2.0_wp*(nodes(i) - ends(panel - 1))/(ends(panel) - ends(panel - 1)) - 1.0_wp)
        end do
    end subroutine new_edge_panels

    !> The polynomials at z that are 1 at one of the places and 0 at the others (barycentric formula).
    pure function interpolation(place, weight, z) result(values)
        real(wp), intent(in) :: place(:), weight(:), z
        real(wp) :: values(size(place))

        if (any(abs(z - place) <= 0.0_wp)) then
            values = merge(1.0_wp, 0.0_wp, abs(z - place) <= 0.0_wp)
            return
        end if
        values = weight/(z - place)
        values = values/sum(values)
    end function interpolation

    !> A function at the nodes.
    pure function at_nodes(self, values) result(interpolated)
        class(edge_panels_t), intent(in) :: self
        !> at the places
        real(wp), intent(in) :: values(:)
        real(wp) :: interpolated(size(self%before))
        integer :: i

        do i = 1, size(self%before)
            associate (first => self%before(i) + 1, last => self%before(i) + size(self%weights, 1))
                interpolated(i) = dot_product(values(first:last), self%weights(:, i))
            end associate
        end do
    end function at_nodes

end module mdrcontact_line_edge_panels
