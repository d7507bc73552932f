! SPDX-License-Identifier: GPL-3.0-or-later
!> The heat that friction makes in a contact, as a line load: mu v q(x) of a contact that slides, and of one that spins the
!> line load of mu omega r p(r). At the nodes of a rule in theta, x = a sin theta, that follows kinks of the indenter.
module mdrcontact_conduction_source
    use mdrcontact_contact, only: contact_t
    use mdrcontact_contact_state, only: contact_state_t
    use mdrcontact_error, only: check_choice, check_memory, check_not_negative, error_invalid, error_t, raise
    use mdrcontact_kinds, only: half_pi, wp
    use mdrcontact_layered_moments, only: is_smooth
    use mdrcontact_layered_rule, only: new_rule, rule_t
    use mdrcontact_numerics_quadrature, only: gauss_legendre
    implicit none (type, external)
    private
    public :: source_t, new_source, sliding, spinning

    !> Kinds of motion.
    integer, parameter :: sliding = 1, spinning = 2
    !> Panels towards the axis, each `shrinking` times as long as the next.
    integer, parameter :: panels = 24
    real(wp), parameter :: shrinking = 0.25_wp
    !> Nodes of a panel of a spinning contact, and its shortest panel.
    integer, parameter :: spin_nodes = 20
    real(wp), parameter :: smallest = 1.0e-7_wp

    !> A line load of heat.
    type :: source_t
        !> a [length], and the heat Q [conductance potential]
        real(wp) :: radius = 0.0_wp, total = 0.0_wp
        !> sin theta, the weights of int_0^a dx, cos theta, and q there
        real(wp), allocatable :: u(:), dx(:), cosine(:), q(:)
        !> q(0)
        real(wp) :: centre = 0.0_wp
    end type source_t

contains

    !> The heat of a state.
    subroutine new_source(self, contact, state, motion, strength, nodes, error)
        type(source_t), intent(out) :: self
        type(contact_t), intent(in) :: contact
        !> of that contact, a > 0
        type(contact_state_t), intent(in) :: state
        !> sliding or spinning
        integer, intent(in) :: motion
        !> mu v [flux/force], or mu omega [flux/(force length)], >= 0
        real(wp), intent(in) :: strength
        !> of a rule over a smooth contact
        integer, intent(in) :: nodes
        type(error_t), allocatable, intent(inout) :: error
        real(wp), allocatable :: x(:), values(:)

        call check_choice(error, "motion", motion, sliding, spinning, "1 (sliding) or 2 (spinning)")
        call check_not_negative(error, "strength", strength)
        if (allocated(error)) return
        if (.not. state%radius > 0.0_wp) then
            call raise(error, error_invalid, "friction heat needs a contact: the state has the radius 0")
            return
        end if
        self%radius = state%radius
        ! r p(r) of a smooth p has a kink at the axis
        call place_nodes(self, contact, nodes, motion == sliding .and. is_smooth(contact%equilibrium%profile), error)
        if (allocated(error)) return
        ! the centre with the others: one solution serves all of them
        x = [0.0_wp, self%u]
        allocate (values, mold=x)
        if (motion == sliding) then
            call contact%line_load(state, self%radius*x, values, error)
        else
            call fill_spin(contact, state, x, values, error)
        end if
        if (allocated(error)) return
        self%q = values(2:)
        self%q = strength*self%q
        self%centre = strength*values(1)
        self%total = 2.0_wp*sum(self%dx*self%q)
    end subroutine new_source

    !> The rule: one panel where the load is smooth; else panels towards the axis and, with room for a root, behind each kink.
    subroutine place_nodes(self, contact, nodes, smooth, error)
        type(source_t), intent(inout) :: self
        type(contact_t), intent(in) :: contact
        integer, intent(in) :: nodes
        logical, intent(in) :: smooth
        type(error_t), allocatable, intent(inout) :: error
        type(rule_t) :: rule
        real(wp), allocatable :: edges(:), breaks(:), theta(:), weight(:), t(:), w(:)
        integer :: i, n, each, kinks, stat

        if (smooth) then
            allocate (breaks(0))
        else
            call contact%equilibrium%add_breaks(breaks, error)
            if (allocated(error)) return
            breaks = pack(breaks, breaks > 0.0_wp .and. breaks < self%radius)
        end if
        kinks = size(breaks)
        call new_rule(rule, merge(nodes, max(nodes, 64), smooth), error)
        if (allocated(error)) return
        t = 0.5_wp*rule%distance
        w = 0.5_wp*rule%weights
        if (smooth) then
            edges = [0.0_wp, half_pi]
        else
            edges = asin(min([breaks, self%radius]/self%radius, 1.0_wp))
            edges = [0.0_wp, [(edges(1)*shrinking**(panels - i), i=1, panels - 1)], edges]
        end if
        each = size(t)
        n = each*(size(edges) - 1)
        allocate (theta(n), weight(n), self%q(n), stat=stat)
        call check_memory(error, stat)
        if (stat /= 0) return
        do i = 1, size(edges) - 1
            associate (length => edges(i + 1) - edges(i), first => (i - 1)*each + 1, last => i*each)
                if (i > size(edges) - 1 - kinks) then
                    theta(first:last) = edges(i) + length*t**2
                    weight(first:last) = 2.0_wp*length*t*w
                else
                    theta(first:last) = edges(i) + length*t
                    weight(first:last) = length*w
                end if
            end associate
        end do
        self%u = sin(theta)
        self%cosine = cos(theta)
        self%dx = self%radius*self%cosine*weight
    end subroutine place_nodes

    !> 2 int_x^a r p(r) r/sqrt(r^2 - x^2) dr = 2 sqrt(a^2 - x^2) int_0^1 r p dt, r^2 = x^2 + (a^2 - x^2) t^2, t = sin tau in
    !> panels that shrink down to x, below which r hardly changes.
    subroutine fill_spin(contact, state, u, values, error)
        type(contact_t), intent(in) :: contact
        type(contact_state_t), intent(in) :: state
        !> x/a
        real(wp), intent(in) :: u(:)
        real(wp), intent(out) :: values(:)
        type(error_t), allocatable, intent(inout) :: error
        real(wp) :: node(spin_nodes), weight(spin_nodes), tau(spin_nodes), r(spin_nodes), p(spin_nodes), root, left, right
        integer :: i

        values = 0.0_wp
        call gauss_legendre(node, weight, error)
        do i = 1, size(u)
            root = sqrt((1.0_wp - u(i))*(1.0_wp + u(i)))
            right = half_pi
            do while (right > 0.0_wp)
                left = shrinking*right
                if (right < u(i) .or. right < smallest) left = 0.0_wp
                tau = left + (right - left)*node
                r = min(state%radius*hypot(u(i), root*sin(tau)), state%radius)
                call contact%pressure(state, r, p, error)
                if (allocated(error)) return
                values(i) = values(i) + 2.0_wp*state%radius*root*(right - left)*sum(weight*cos(tau)*r*p)
                right = left
            end do
        end do
    end subroutine fill_spin

end module mdrcontact_conduction_source
