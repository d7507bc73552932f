! SPDX-License-Identifier: GPL-3.0-or-later
!> First shear of a contact under constant normal force, for a coefficient of friction of 1: the stick zone shrinks from the contact
!> radius a while the indenter is displaced by s along the surface, and the tangential force T rises.
!>
!> In terms of the stick radius c everything follows from two functions, eta(c) = -ds/dc and the stiffness of a full contact of
!> that radius, k_t(c), because dT/ds = k_t(c):
!>     s = int_c^a eta db,    T = int_c^a k_t eta db,    D = int_c^a (s - s(b)) s(b) k_t'(b) db,
!> D the energy dissipated (theory/friction.md (3.4), (3.5)). All integrands are positive: nothing cancels, however little slips.
!> With a coefficient of friction mu, s and T are mu times, D is mu^2 times as large at the same stick radius.
module mdrcontact_medium_slip
    use mdrcontact_error, only: error_domain, error_t, raise, to_text
    use mdrcontact_kinds, only: wp
    use mdrcontact_numerics_quadrature, only: new_antiderivative
    implicit none (type, external)
    private
    public :: beside, slip_t, thin

    !> Nodes in a panel of stick radii, at least.
    integer, parameter :: fewest_nodes = 4
    !> Relative error of a panel's integrals with fewer nodes.
    real(wp), parameter :: negligible = 1.0e-11_wp
    !> Annuli of slip thinner than this part of the radius: s and T, differences where they are known, are integrated.
    real(wp), parameter :: thin = 0.01_wp
    !> A stiffness that falls by a smaller power of the radius is one that does not vary.
    real(wp), parameter :: falling = 1.0e-9_wp
    !> Relative distance to a singular point of the pressure at which the traction is taken.
    real(wp), parameter :: close = 1.0e-9_wp

    !> First shear of one normal state. Media give what fits them.
    type, abstract :: slip_t
        !> contact radius a [length] and normal force F [modulus length^2]
        real(wp) :: radius = 0.0_wp, force = 0.0_wp
        !> shift at which sliding begins [length], and the stick radius just before it: the indenter's flat end, if it has one
        real(wp) :: sliding_shift = 0.0_wp, smallest_stick = 0.0_wp
        !> shift up to which nothing slips [length], greater than 0 under an indenter with a vertical wall, and k_t(a)
        real(wp) :: first_shift = 0.0_wp, stiffness = 0.0_wp
        !> -ds/dc at c = a where it is known, else 0: what a search begins with
        real(wp) :: edge_rate = 0.0_wp
        !> power of c with which s begins to fall at the axis, about, for the same purpose
        real(wp) :: exponent = 2.0_wp
        !> nodes in a panel of stick radii, at most
        integer :: nodes = 8
        !> length in which everything varies but for powers of c [length]; 0 where that is not known
        real(wp) :: scale = 0.0_wp
    contains
        !> s if the medium provides it directly, eta, k_t and k_t' at stick radii
        procedure(rates_at), deferred :: rates
        !> radii between which these are integrated, and whether a square root starts at the lower end of each interval
        procedure(panels_from), deferred :: panels
        !> s and T of a stick radius
        procedure(state_at), deferred :: at
        !> q_t(x) [modulus length] and tau(r) [modulus] of a stick radius, 0 <= x, r <= a
        procedure(field_at), deferred :: line_load, traction
        !> D [modulus length^3] of a stick radius
        procedure :: dissipation
        procedure, non_overridable :: integrate
    end type slip_t

    abstract interface
        subroutine rates_at(self, c, shift, shift_rate, stiffness, stiffness_slope, error)
            import :: error_t, slip_t, wp
            class(slip_t), intent(in) :: self
            !> stick radii, smallest_stick < c <= a [length]
            real(wp), intent(in) :: c(:)
            !> s [length], -ds/dc [1], k_t [modulus length], dk_t/dc [modulus]; same size as c. A shift of 0 is not known
            real(wp), intent(out) :: shift(:), shift_rate(:), stiffness(:), stiffness_slope(:)
            type(error_t), allocatable, intent(out) :: error
        end subroutine rates_at

        subroutine panels_from(self, c, edges, has_root, error)
            import :: error_t, slip_t, wp
            class(slip_t), intent(in) :: self
            real(wp), intent(in) :: c
            !> ascending from c to a
            real(wp), allocatable, intent(out) :: edges(:)
            !> one entry less
            logical, allocatable, intent(out) :: has_root(:)
            type(error_t), allocatable, intent(inout) :: error
        end subroutine panels_from

        subroutine state_at(self, c, width, shift, force, stiffness, shift_rate, error)
            import :: error_t, slip_t, wp
            class(slip_t), intent(in) :: self
            !> stick radius, and a - c without cancellation [length]
            real(wp), intent(in) :: c, width
            !> s [length], T [modulus length^2], k_t(c) [modulus length] and -ds/dc [1]
            real(wp), intent(out) :: shift, force, stiffness, shift_rate
            type(error_t), allocatable, intent(out) :: error
        end subroutine state_at

        subroutine field_at(self, c, r, values, error)
            import :: error_t, slip_t, wp
            class(slip_t), intent(in), target :: self
            !> stick radius, smallest_stick <= c <= a [length]
            real(wp), intent(in) :: c
            !> positions [length]
            real(wp), intent(in) :: r(:)
            real(wp), intent(out) :: values(:)
            type(error_t), allocatable, intent(out) :: error
        end subroutine field_at
    end interface

contains

    !> D by integration over the stick radii of the contact's past.
    subroutine dissipation(self, c, width, shift, dissipated, error)
        class(slip_t), intent(in) :: self
        !> stick radius, a - c without cancellation, and s [length]
        real(wp), intent(in) :: c, width, shift
        !> [modulus length^3]
        real(wp), intent(out) :: dissipated
        type(error_t), allocatable, intent(out) :: error
        real(wp) :: same_shift, force

        call self%integrate(c, width, same_shift, force, dissipated, error, shift)
    end subroutine dissipation

    !> s, T and D of a stick radius by integration; D alone needs it where s and T are known and no small differences.
    subroutine integrate(self, c, width, shift, force, dissipated, error, known_shift)
        class(slip_t), intent(in) :: self
        !> stick radius, and a - c without cancellation [length]
        real(wp), intent(in) :: c, width
        !> s [length], T [modulus length^2], D [modulus length^3]
        real(wp), intent(out) :: shift, force, dissipated
        type(error_t), allocatable, intent(out) :: error
        !> s where it is known already; D is that of this shift
        real(wp), intent(in), optional :: known_shift
        real(wp), allocatable :: edges(:)
        logical, allocatable :: has_root(:)
        real(wp) :: length
        !> int s k_t' db and int s^2 k_t' db over the panels passed
        real(wp) :: first, second
        integer :: i, nodes

        shift = self%first_shift
        force = self%stiffness*self%first_shift
        dissipated = 0.0_wp
        if (.not. width > 0.0_wp) return
        call self%panels(c, edges, has_root, error)
        if (allocated(error)) return
        ! no double lies between c and a
        if (size(edges) < 2) then
            edges = [c, c]
            has_root = [.false.]
        end if
        first = 0.0_wp
        second = 0.0_wp
        do i = size(edges) - 1, 1, -1
            length = edges(i + 1) - edges(i)
            if (size(edges) == 2) length = width
            nodes = self%nodes
            if (.not. has_root(i)) nodes = nodes_for(edges(i), length, self%scale, self%nodes)
            call add_panel(nodes, edges(i), length, has_root(i))
            if (allocated(error)) return
        end do
        if (present(known_shift)) shift = known_shift
        dissipated = shift*first - second

    contains

        !> Adds the integrals from `edge` on.
        subroutine add_panel(nodes, edge, length, has_root)
            integer, intent(in) :: nodes
            real(wp), intent(in) :: edge, length
            logical, intent(in) :: has_root
            real(wp), dimension(nodes) :: t, b, db, rate, stiffness, slope, here, known
            real(wp) :: antiderivative(nodes + 1, nodes), within(nodes + 1)

            call new_antiderivative(t, antiderivative, error)
            if (allocated(error)) return
            if (has_root) then
                b = edge + length*t**2
                db = 2.0_wp*length*t
            else
                b = edge + length*t
                db = length
            end if
            call self%rates(b, known, rate, stiffness, slope, error)
            if (.not. allocated(error) .and. any(b*slope < -falling*stiffness)) then
                call raise(error, error_domain, "the tangential stiffness of this model falls with the contact radius near "// &
                           to_text(b(minloc(b*slope/stiffness, dim=1)))//": slip would produce energy. Use the model exact")
            end if
            if (allocated(error)) return
            ! from the lower end of the panel to each node, and to its upper end
            within = matmul(antiderivative, rate*db)
            here = shift + (within(nodes + 1) - within(:nodes))
            if (width > thin*self%radius) here = merge(known, here, known > 0.0_wp)
            shift = shift + within(nodes + 1)
            force = force + dot_product(antiderivative(nodes + 1, :), rate*stiffness*db)
            first = first + dot_product(antiderivative(nodes + 1, :), here*slope*db)
            second = second + dot_product(antiderivative(nodes + 1, :), here**2*slope*db)
        end subroutine add_panel

    end subroutine integrate

    !> Number of nodes of a panel: their error falls as rho^(-2 nodes), rho that of the largest ellipse around it without the
    !> axis, where a power of c may begin, and without what lies `scale` next to it.
    pure function nodes_for(edge, length, scale, most) result(nodes)
        real(wp), intent(in) :: edge, length, scale
        integer, intent(in) :: most
        integer :: nodes
        real(wp) :: from_axis, aside, rho

        nodes = most
        if (.not. scale > 0.0_wp) return
        from_axis = 1.0_wp + 2.0_wp*edge/length
        aside = 2.0_wp*scale/length
        rho = min(from_axis + sqrt(from_axis**2 - 1.0_wp), aside + sqrt(aside**2 + 1.0_wp))
        if (rho > 1.0_wp) nodes = ceiling(min(max(-0.5_wp*log(negligible)/log(rho), real(fewest_nodes, wp)), real(most, wp)))
    end function nodes_for

    !> Where a traction that is the difference of two pressures is taken in the stick zone: next to the apex and the edge of a flat
    !> end, where both may be infinite.
    elemental function beside(r, c, end_radius) result(near)
        !> position, stick radius and radius of the flat end [length]
        real(wp), intent(in) :: r, c, end_radius
        real(wp) :: near

        near = r
        if (r < c .and. (r <= 0.0_wp .or. r == end_radius)) near = max((1.0_wp + close)*r, close*c)
    end function beside

end module mdrcontact_medium_slip
