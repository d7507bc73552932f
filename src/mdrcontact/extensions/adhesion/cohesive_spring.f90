! SPDX-License-Identifier: GPL-3.0-or-later
!> One spring of a viscoelastic half-space next to a contact that attracts its surroundings (Haiat, Phan Huy, Barthel, J. Mech.
!> Phys. Solids 51 (2003) 69; theory/adhesion.md (5.1), (5.2)): the spring at x displaces by
!>     w = J_0 q + sum J_l z_l,    dz_l/dt = rate_l (q - z_l)
!> and over a step in time, in which the contact's radius a and the cohesive zone's radius c are linear in time,
!>     x < a(t): q linear in time;    a < x < c: q = -2 sigma_0 sqrt(c^2 - x^2);    x > c: q = 0
!> Events that pass x within a step split the step there; q is continuous.
module mdrcontact_adhesion_cohesive_spring
    use mdrcontact_error, only: error_t
    use mdrcontact_time_path, only: mean_lag, mean_rise
    use mdrcontact_kinds, only: wp
    use mdrcontact_material_prony, only: creep_t, risen
    use mdrcontact_numerics_quadrature, only: gauss_legendre
    implicit none (type, external)
    private
    public :: spring_step_t, new_spring_step, zone_load

    !> Gauss nodes in time, in u of t = u^2 (3 - 2 u): q goes as a root where c passes.
    integer, parameter :: nodes = 12

    !> A step in time.
    type :: spring_step_t
        !> [time]
        real(wp) :: length = 0.0_wp
        !> a and c at its beginning and end [length]
        real(wp) :: a(2) = 0.0_wp, c(2) = 0.0_wp
        !> 2 sigma_0 [modulus]
        real(wp) :: stress = 0.0_wp
        !> J_0 [1/modulus], the weights J_l and the rates
        type(creep_t) :: creep
        real(wp), private :: place(nodes) = 0.0_wp, weight(nodes) = 0.0_wp
    contains
        procedure :: pass
    end type spring_step_t

contains

    !> A step of a body; its radii and length are set afterwards.
    subroutine new_spring_step(self, creep, stress, error)
        type(spring_step_t), intent(out) :: self
        type(creep_t), intent(in) :: creep
        !> 2 sigma_0 [modulus]
        real(wp), intent(in) :: stress
        type(error_t), allocatable, intent(inout) :: error
        real(wp) :: u(nodes), weight(nodes)

        self%creep = creep
        self%stress = stress
        call gauss_legendre(u, weight, error)
        self%place = u**2*(3.0_wp - 2.0_wp*u)
        self%weight = 6.0_wp*u*(1.0_wp - u)*weight
    end subroutine new_spring_step

    !> q = -2 sigma_0 sqrt(c^2 - x^2) of a zone, 0 outside [modulus length].
    elemental function zone_load(stress, c, x) result(q)
        !> 2 sigma_0 [modulus], c and x [length]
        real(wp), intent(in) :: stress, c, x
        real(wp) :: q

        q = -stress*sqrt(max(c - x, 0.0_wp)*(c + x))
    end function zone_load

    !> A spring after the step, w = memory + compliance q.
    pure subroutine pass(self, x, q, z, rise, memory, compliance)
        class(spring_step_t), intent(in) :: self
        !> place >= 0 [length], and the load at the beginning [modulus length]
        real(wp), intent(in) :: x, q
        !> z_l at the beginning; at the end what q does not add to it [modulus length]
        real(wp), intent(inout) :: z(:)
        !> z_l = z + rise q at the end; 0 where q is known, beside the contact
        real(wp), intent(out) :: rise(:)
        !> [length], [1/modulus]
        real(wp), intent(out) :: memory, compliance
        real(wp) :: cuts(4), middle, q_from, q_to
        integer :: i

        rise = 0.0_wp
        cuts = [0.0_wp, crossings(self, x), 1.0_wp]
        q_from = q
        do i = 1, 3
            if (.not. cuts(i + 1) > cuts(i)) cycle
            middle = 0.5_wp*(cuts(i) + cuts(i + 1))
            q_to = zone_load(self%stress, at(self%c, cuts(i + 1)), x)
            if (x < at(self%a, middle)) then
                call hold(self, cuts(i + 1) - cuts(i), q_from, q_to, x <= self%a(2) .and. .not. cuts(i + 1) < 1.0_wp, &
                          z, rise)
            else if (x < at(self%c, middle)) then
                call attract(self, x, cuts(i:i + 1), q_to, z)
            else
                z = exp(-self%creep%rate*self%length*(cuts(i + 1) - cuts(i)))*z
            end if
            q_from = q_to
        end do
        memory = sum(self%creep%weight*z)
        compliance = self%creep%instant + sum(self%creep%weight*rise)
    end subroutine pass

    !> The parts of the step after which an edge passes x, ascending; 0 or 1 where none does.
    pure function crossings(self, x) result(cuts)
        type(spring_step_t), intent(in) :: self
        real(wp), intent(in) :: x
        real(wp) :: cuts(2)

        cuts = [crossing(self%a, x), crossing(self%c, x)]
        if (cuts(2) < cuts(1)) cuts = cuts(2:1:-1)
    end function crossings

    pure function crossing(edge, x) result(part)
        real(wp), intent(in) :: edge(2), x
        real(wp) :: part

        part = 0.0_wp
        if ((edge(1) < x) .neqv. (edge(2) < x)) part = min(max((x - edge(1))/(edge(2) - edge(1)), 0.0_wp), 1.0_wp)
    end function crossing

    pure function at(edge, part) result(radius)
        real(wp), intent(in) :: edge(2), part
        real(wp) :: radius

        radius = edge(1) + part*(edge(2) - edge(1))
    end function at

    !> In contact for a part of the step, q linear in time.
    pure subroutine hold(self, part, q_from, q_to, is_free, z, rise)
        type(spring_step_t), intent(in) :: self
        real(wp), intent(in) :: part, q_from, q_to
        !> whether q at the end is not known yet
        logical, intent(in) :: is_free
        real(wp), intent(inout) :: z(:), rise(:)
        real(wp) :: u(size(z))

        u = self%creep%rate*self%length*part
        z = exp(-u)*z + mean_lag(u)*q_from
        if (is_free) then
            rise = mean_rise(u)
        else
            z = z + mean_rise(u)*q_to
        end if
    end subroutine hold

    !> In the zone from one part of the step to another. The integrand is the distance of q from its end: of short times little is
    !> left, for any rule.
    pure subroutine attract(self, x, parts, q_to, z)
        type(spring_step_t), intent(in) :: self
        real(wp), intent(in) :: x, parts(2), q_to
        real(wp), intent(inout) :: z(:)
        real(wp) :: less(nodes), length
        integer :: l

        length = self%length*(parts(2) - parts(1))
        less = self%weight*(q_to - zone_load(self%stress, at(self%c, parts(1)) + self%place*(at(self%c, parts(2)) &
                                                                                             - at(self%c, parts(1))), x))
        do l = 1, size(z)
            associate (u => self%creep%rate(l)*length)
                z(l) = exp(-u)*z(l) + risen(u)*q_to - u*sum(less*exp(-u*(1.0_wp - self%place)))
            end associate
        end do
    end subroutine attract

end module mdrcontact_adhesion_cohesive_spring
