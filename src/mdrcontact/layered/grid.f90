! SPDX-License-Identifier: GPL-3.0-or-later
!> Panels of the contact [0, a]: short against the kernel's width or against the distance from where the line load varies at
!> that width.
!>
!> For a >> h the line load is smooth in the interior and only a layer of width ~h is not: at the edge of the contact, and where the
!> indenter's profile is not smooth. Panels are halved towards these radii, which takes log2(a/h) of them.
module mdrcontact_layered_grid
    use mdrcontact_kinds, only: wp
    use mdrcontact_layered_rule, only: rule_t
    implicit none (type, external)
    private
    public :: grid_t, new_grid, split_panels, longest_panel

    !> Longest panel that need not be split, in units of the kernel's width.
    real(wp), parameter :: longest_panel = 1.5_wp
    !> Halvings of a panel at most: a thousandth of the smallest ratio of lengths in use.
    integer, parameter :: most_halvings = 60

    !> Panels over 0 <= x <= a and the nodes in them.
    type :: grid_t
        !> panel i is [edges(i), edges(i + 1)]
        real(wp), allocatable :: edges(:)
        !> nodes per panel
        integer :: order = 0
        !> all nodes and weights
        real(wp), allocatable :: x(:), w(:)
    end type grid_t

contains

    !> The nodes of a rule on every panel.
    pure function new_grid(edges, rule) result(self)
        real(wp), intent(in) :: edges(:)
        type(rule_t), intent(in) :: rule
        type(grid_t) :: self
        integer :: i, first, last

        allocate (self%edges(size(edges)))
        self%edges(:) = edges
        self%order = rule%n
        allocate (self%x((size(edges) - 1)*rule%n), self%w((size(edges) - 1)*rule%n))
        do i = 1, size(edges) - 1
            first = (i - 1)*rule%n + 1
            last = i*rule%n
            self%x(first:last) = edges(i) + (edges(i + 1) - edges(i))*rule%nodes
            self%w(first:last) = (edges(i + 1) - edges(i))*rule%weights
        end do
    end function new_grid

    !> Edges of panels on [0, a], each at most longest_panel*width + the distance from the nearest of `singular`.
    pure subroutine split_panels(a, width, singular, edges)
        real(wp), intent(in) :: a, width, singular(:)
        real(wp), allocatable, intent(out) :: edges(:)
        real(wp) :: pending(most_halvings + 1), low, high
        real(wp), allocatable :: longer(:)
        integer :: waiting, count

        allocate (edges(64))
        edges(1) = 0.0_wp
        count = 1
        low = 0.0_wp
        ! upper ends of the panels not yet accepted; the last one is next
        pending(1) = a
        waiting = 1
        do while (waiting > 0)
            high = pending(waiting)
            if (waiting <= most_halvings .and. high - low > longest_panel*width + distance(low, high, singular)) then
                waiting = waiting + 1
                pending(waiting) = low + 0.5_wp*(high - low)
                cycle
            end if
            waiting = waiting - 1
            count = count + 1
            if (count > size(edges)) then
                allocate (longer(2*size(edges)))
                longer(:size(edges)) = edges
                call move_alloc(longer, edges)
            end if
            edges(count) = high
            low = high
        end do
        edges = edges(:count)
    end subroutine split_panels

    pure function distance(low, high, points) result(nearest)
        real(wp), intent(in) :: low, high, points(:)
        real(wp) :: nearest
        integer :: i

        nearest = huge(1.0_wp)
        do i = 1, size(points)
            nearest = min(nearest, max(low - points(i), points(i) - high, 0.0_wp))
        end do
    end function distance

end module mdrcontact_layered_grid
