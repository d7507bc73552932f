! SPDX-License-Identifier: GPL-3.0-or-later
!> The equilibria of a contact, sampled once over the contact radius: the raw material of a compiled law.
!>
!> The radius is the natural parameter: one solution gives depth, force and stiffness, none of them by iteration. What
!> is interpolated are the logarithms of d0, F0, k and, with adhesion, dl over x = ln(a - end radius), where every shape
!> and medium is close to a straight line (theory 4 and 5): d = d0 - dl, F = F0 - k dl.
module mdrcontact_law_curve
    use mdrcontact_contact, only: contact_t
    use mdrcontact_contact_state, only: contact_state_t
    use mdrcontact_error, only: error_no_convergence, error_t, raise, to_text
    use mdrcontact_kinds, only: pi, wp
    implicit none (type, external)
    private
    public :: curve_t, curve_point_t, new_curve

    !> Chebyshev nodes in a panel, and the length in ln a up to which that many usually suffice.
    integer, parameter :: nodes = 16
    real(wp), parameter :: usual_length = 1.6_wp, shortest_length = 1.0e-4_wp
    integer, parameter :: most_panels = 400
    !> rows of the samples: ln d0, ln F0, ln k, ln dl
    integer, parameter :: rows = 4

    !> One equilibrium.
    type :: curve_point_t
        real(wp) :: radius = 0.0_wp, depth = 0.0_wp, force = 0.0_wp, stiffness = 0.0_wp
    end type curve_point_t

    !> The sampled equilibria.
    type :: curve_t
        !> radius of the indenter's flat end [length]
        real(wp) :: end_radius = 0.0_wp
        logical :: adhesive = .false.
        !> panel i runs over x from edges(i) to edges(i+1)
        real(wp), allocatable :: edges(:)
        !> whether panel i begins at a break of the indenter or medium and uses sqrt(x - edges(i))
        logical, allocatable :: from_root(:)
        !> (nodes, rows, panels)
        real(wp), allocatable :: coefficients(:, :, :)
        !> how many contact states were computed
        integer :: solutions = 0
    contains
        procedure :: at
    end type curve_t

contains

    !> Samples the states between the coordinates breaks(1) and breaks(size(breaks)).
    subroutine new_curve(self, contact, end_radius, breaks, tolerance, error)
        type(curve_t), intent(out) :: self
        type(contact_t), intent(in) :: contact
        real(wp), intent(in) :: end_radius
        !> ascending coordinates; at the inner ones indenter or medium are not analytic
        real(wp), intent(in) :: breaks(:)
        !> relative, of the interpolated quantities
        real(wp), intent(in) :: tolerance
        type(error_t), allocatable, intent(out) :: error
        real(wp), allocatable :: waiting(:)
        real(wp) :: coefficients(nodes, rows), left, right, attainable
        logical :: root

        self%end_radius = end_radius
        self%adhesive = contact%is_adhesive()
        allocate (waiting, source=first_edges(breaks))
        allocate (self%edges(1), self%from_root(0), self%coefficients(nodes, rows, 0))
        self%edges(1) = breaks(1)
        do while (size(waiting) > 0)
            left = self%edges(size(self%edges))
            right = waiting(1)
            root = any(breaks(2:) == left)
            call sample_panel(self, contact, left, right, root, coefficients, error)
            if (allocated(error)) return
            ! Close to a flat end a - b, and all that depends on it, has lost digits.
            attainable = max(tolerance, 16.0_wp*epsilon(1.0_wp)*end_radius*exp(-left))
            if (maxval(abs(coefficients(nodes - 1:, :))) > attainable) then
                if (right - left < shortest_length .or. size(self%from_root) + size(waiting) > most_panels) then
                    call raise(error, error_no_convergence, "the contact is not smooth enough near radius = "// &
                               to_text(end_radius + exp(left))//" to be compiled to this tolerance")
                    return
                end if
                waiting = [0.5_wp*(left + right), waiting]
                cycle
            end if
            waiting = waiting(2:)
            self%edges = [self%edges, right]
            self%from_root = [self%from_root, root]
            self%coefficients = reshape([self%coefficients, coefficients], [nodes, rows, size(self%from_root)])
        end do
    end subroutine new_curve

    !> Right edges of panels of at most the usual length between the breaks.
    pure function first_edges(breaks) result(edges)
        real(wp), intent(in) :: breaks(:)
        real(wp), allocatable :: edges(:)
        integer :: i, j, count

        allocate (edges(0))
        do i = 1, size(breaks) - 1
            count = max(1, ceiling((breaks(i + 1) - breaks(i))/usual_length))
            edges = [edges, (breaks(i) + (breaks(i + 1) - breaks(i))*(real(j, wp)/count), j=1, count - 1), breaks(i + 1)]
        end do
    end function first_edges

    subroutine sample_panel(self, contact, left, right, root, coefficients, error)
        type(curve_t), intent(inout) :: self
        type(contact_t), intent(in) :: contact
        real(wp), intent(in) :: left, right
        logical, intent(in) :: root
        real(wp), intent(out) :: coefficients(nodes, rows)
        type(error_t), allocatable, intent(out) :: error
        type(contact_state_t) :: state
        real(wp) :: values(nodes, rows), t
        integer :: i, j

        coefficients = 0.0_wp
        values = 0.0_wp
        do i = 1, nodes
            t = 0.5_wp*(1.0_wp + cos(pi*(i - 0.5_wp)/nodes))
            if (root) t = t**2
            call contact%at_radius(self%end_radius + exp(left + (right - left)*t), state, error)
            if (allocated(error)) return
            self%solutions = self%solutions + 1
            values(i, 1) = log(state%depth - state%excess)
            values(i, 2) = log(state%force - state%stiffness*state%excess)
            values(i, 3) = log(state%stiffness)
            if (self%adhesive) values(i, 4) = log(-state%excess)
        end do
        do j = 1, nodes
            coefficients(j, :) = (2.0_wp/nodes)*matmul(cos(pi*(j - 1)*([(i, i=1, nodes)] - 0.5_wp)/nodes), values)
        end do
        coefficients(1, :) = 0.5_wp*coefficients(1, :)
    end subroutine sample_panel

    !> The interpolated equilibrium at coordinate x.
    pure function at(self, x) result(point)
        class(curve_t), intent(in) :: self
        real(wp), intent(in) :: x
        type(curve_point_t) :: point
        real(wp) :: t, v(rows), b(rows), b1(rows), b2(rows), hanging
        integer :: i, j

        i = min(max(count(self%edges <= x), 1), size(self%from_root))
        t = (x - self%edges(i))/(self%edges(i + 1) - self%edges(i))
        if (self%from_root(i)) t = sqrt(max(t, 0.0_wp))
        t = 2.0_wp*t - 1.0_wp
        b1 = 0.0_wp
        b2 = 0.0_wp
        do j = nodes, 2, -1
            b = 2.0_wp*t*b1 - b2 + self%coefficients(j, :, i)
            b2 = b1
            b1 = b
        end do
        v = exp(t*b1 - b2 + self%coefficients(1, :, i))
        hanging = 0.0_wp
        if (self%adhesive) hanging = v(4)
        point = curve_point_t(radius=self%end_radius + exp(x), depth=v(1) - hanging, force=v(2) - v(3)*hanging, stiffness=v(3))
    end function at

end module mdrcontact_law_curve
