! SPDX-License-Identifier: GPL-3.0-or-later
!> One step of gross sliding on a disc that moves with the edge of the contact (theory/wear.md (5.1)-(5.7)): of second order in
!> the step and in the intervals, the contact radius included.
!>
!> With hats phi_i in the disc of the new radius the contact is int phi_i (S p + f - d) 2 pi r dr = 0, i = 0 ... n, of which the
!> last is the half hat inside the edge; unknowns are p at n radii and d. Each place of the indenter keeps int p ds, and
!>
!>     int p ds (new) = int p ds (old) + ds [w_o p_old + w_n p_new],
!>
!> with weights that are exact for pressures 1 and rho^lambda, rho the distance from an edge that moves evenly, where
!> tan(pi lambda) = 2 a'(s)/(k E0*) is the exponent at the edge, layered or not.
module mdrcontact_wear_disc
    use mdrcontact_error, only: error_domain, error_no_convergence, error_t, raise, to_text
    use mdrcontact_kinds, only: pi, wp
    use mdrcontact_medium_solver, only: solver_t
    use mdrcontact_numerics_one_thread, only: solve
    use mdrcontact_profile, only: profile_t
    use mdrcontact_medium_hats, only: hat_points, hats_t, line_compliance
    use mdrcontact_wear_history_on_disc, only: disc_t, wear_history_on_disc_t, new_wear_history_on_disc
    use mdrcontact_wear_rate, only: wear_rate_t
    implicit none (type, external)
    private
    public :: step_disc, worn_volume

    !> The radius of a step is searched for so often, until force or depth is met to this relative accuracy.
    integer, parameter :: most_rounds = 60
    real(wp), parameter :: close_enough = 1.0e-12_wp
    !> Accepted residual where force and depth change steeply with the radius by less than the error of the scheme, as a point of
    !> its rules passes the edge of the step before; it does not add up, as each step meets the target anew.
    real(wp), parameter :: tolerated = 1.0e-4_wp
    !> Targets that differ by less than this part are the same.
    real(wp), parameter :: same_target = 2.0_wp*tolerated
    !> Number of times that the coefficient is adapted to the depth of a place.
    integer, parameter :: most_changes = 40
    !> Steps of the trapezoidal rule are at most so many times a/n in k E0* s: the pressure oscillates under longer ones.
    real(wp), parameter :: longest_trapezoid = 4.01_wp
    !> The part of a long step that its first stage takes, and the weight of the pressure at the end.
    real(wp), parameter :: first_part = 1.0_wp - 0.5_wp*sqrt(2.0_wp)
    integer, parameter :: trapezoid = 0, first_stage = 1, second_stage = 2
    !> A search begins at no more than so many of the last radii.
    real(wp), parameter :: farthest_guess = 1.5_wp
    !> Edges that move by less than this part of their distance; exponents below which p is a step.
    real(wp), parameter :: at_rest = 1.0e-4_wp, least_exponent = 1.0e-3_wp
    !> The contact may shrink by this part of an interval in a step under a target that falls, and under any other, where it only
    !> seems to: that is error of the scheme.
    real(wp), parameter :: shrinks = 0.1_wp, seems_to_shrink = 1.0_wp
    !> An edge is slow that moves by less than so many of the last intervals in a step; so many of them are next to it.
    real(wp), parameter :: slow = 4.0_wp, zone = 16.0_wp
    !> Over so many of them beyond the edge of the step before the weights go over from those of places in contact to those of fresh
    !> ones.
    real(wp), parameter :: fading = 2.0_wp

    !> Wear of a place in a step, or up to a stage of it.
    type :: stage_t
        integer :: kind = trapezoid
        !> distance up to its end, and radius at the beginning [length]
        real(wp) :: sliding = 0.0_wp, radius = 0.0_wp
        !> at the beginning of the step, and after its first stage
        type(wear_history_on_disc_t) :: before, middle
    contains
        procedure :: known
    end type stage_t

contains

    !> The disc after a step, from the disc before it: by the trapezoidal rule, or over a long step under a force, in which the
    !> pressure would oscillate, by two implicit stages (theory/wear.md (5.7)).
    subroutine step_disc(hats, solver, profile, rate, disc, sliding, by_depth, target, next, work, error)
        type(hats_t), intent(in) :: hats
        class(solver_t), intent(in) :: solver
        !> unworn
        class(profile_t), intent(in) :: profile
        type(wear_rate_t), intent(in) :: rate
        !> its radius > 0
        type(disc_t), intent(in) :: disc
        !> ds >= 0 [length]
        real(wp), intent(in) :: sliding
        !> the target at the end of the step is a depth, else a force
        logical, intent(in) :: by_depth
        !> see by_depth
        real(wp), intent(in) :: target
        type(disc_t), intent(out) :: next
        !> int F ds of the step [modulus length^3]
        real(wp), intent(out) :: work
        type(error_t), allocatable, intent(inout) :: error
        type(stage_t) :: stage
        type(disc_t) :: middle
        real(wp) :: from, unit

        work = 0.0_wp
        stage%sliding = sliding
        stage%radius = disc%radius
        call new_wear_history_on_disc(stage%before, disc)
        unit = disc%radius/(solver%springs%modulus*maxval(rate%coefficients)*real(hats%n, wp))
        if (by_depth .or. sliding <= longest_trapezoid*unit) then
            call find_radius(hats, solver, profile, rate, stage, disc, by_depth, target, next, error)
            work = 0.5_wp*sliding*(disc%force + next%force)
            return
        end if
        from = merge(disc%depth, disc%force, by_depth)
        stage%kind = first_stage
        stage%sliding = first_part*sliding
        call find_radius(hats, solver, profile, rate, stage, disc, by_depth, from + first_part*(target - from), middle, error)
        if (allocated(error)) return
        stage%kind = second_stage
        stage%sliding = sliding
        call new_wear_history_on_disc(stage%middle, middle)
        middle%radius = disc%radius
        call find_radius(hats, solver, profile, rate, stage, middle, by_depth, target, next, error)
        work = sliding*((1.0_wp - first_part)*middle%force + first_part*next%force)
    end subroutine step_disc

    !> The radius at which the target is met, from that to which the contact would grow on as before.
    subroutine find_radius(hats, solver, profile, rate, stage, disc, by_depth, target, next, error)
        type(hats_t), intent(in) :: hats
        class(solver_t), intent(in) :: solver
        class(profile_t), intent(in) :: profile
        type(wear_rate_t), intent(in) :: rate
        type(stage_t), intent(in) :: stage
        !> at the beginning of the stage
        type(disc_t), intent(in) :: disc
        logical, intent(in) :: by_depth
        real(wp), intent(in) :: target
        type(disc_t), intent(out) :: next
        type(error_t), allocatable, intent(inout) :: error
        real(wp) :: a, low, high, before, miss_before, miss, response
        integer :: i

        low = 0.0_wp
        high = profile%largest_radius
        a = min(disc%radius + disc%growth*stage%sliding, farthest_guess*disc%radius)
        if (a >= high) a = disc%radius
        response = disc%response
        before = 0.0_wp
        miss_before = 0.0_wp
        do i = 1, most_rounds
            call disc_at(hats, solver, profile, rate, stage, a, next, error)
            if (allocated(error)) return
            miss = merge(next%depth, next%force, by_depth)/target - 1.0_wp
            if (i > 1 .and. abs(miss - miss_before) > 0.0_wp) response = (miss - miss_before)/(1.0_wp - before/a)
            if (abs(miss) <= close_enough) exit
            if (miss > 0.0_wp) high = a
            if (miss < 0.0_wp) low = a
            before = a
            miss_before = miss
            a = a*(1.0_wp + min(max(-miss/response, -0.3_wp), 0.5_wp))
            if (a <= low .or. a >= high) a = 0.5_wp*(max(low, 0.5_wp*before) + min(high, 2.0_wp*before))
            if (abs(a - before) <= epsilon(a)*a) exit
        end do
        call check_radius(hats, profile, disc, by_depth, target, miss, high, next, error)
        if (stage%sliding > 0.0_wp) next%growth = max(next%radius - disc%radius, 0.0_wp)/stage%sliding
        if (response > 0.0_wp) next%response = response
    end subroutine find_radius

    !> Raises unless the target is met by a contact that does not shrink.
    pure subroutine check_radius(hats, profile, disc, by_depth, target, miss, high, next, error)
        type(hats_t), intent(in) :: hats
        class(profile_t), intent(in) :: profile
        type(disc_t), intent(in) :: disc, next
        logical, intent(in) :: by_depth
        !> what was searched for, the relative error of it, and the radius below which its place is
        real(wp), intent(in) :: target, miss, high
        type(error_t), allocatable, intent(inout) :: error
        real(wp) :: before, most

        before = merge(disc%depth, disc%force, by_depth)
        most = merge(shrinks, seems_to_shrink, target < before*(1.0_wp - same_target))/real(hats%n, wp)

        if (.not. abs(miss) <= tolerated) then
            if (high >= profile%largest_radius) then
                call raise(error, error_domain, "the contact would grow beyond where the indenter ends, "// &
                           to_text(profile%largest_radius)//". The history is unchanged")
            else
                call raise(error, error_no_convergence, "no contact radius found for "//to_text(target)//" at this step of wear")
            end if
        else if (next%radius < disc%radius*(1.0_wp - most)) then
            call raise(error, error_domain, "the contact would shrink from radius "//to_text(disc%radius)//" to "// &
                       to_text(next%radius)//": the scheme disc does not keep the wear outside the contact. Use the scheme "// &
                       "rings, or do not decrease the load")
        end if
    end subroutine check_radius

    !> Pressure, depth and force where the new radius is a.
    subroutine disc_at(hats, solver, profile, rate, stage, a, next, error)
        type(hats_t), intent(in) :: hats
        class(solver_t), intent(in) :: solver
        class(profile_t), intent(in) :: profile
        type(wear_rate_t), intent(in) :: rate
        type(stage_t), intent(in) :: stage
        real(wp), intent(in) :: a
        type(disc_t), intent(out) :: next
        type(error_t), allocatable, intent(inout) :: error
        real(wp) :: matrix(0:hats%n, 0:hats%n), system(0:hats%n, 0:hats%n), rhs(0:hats%n), share_at_nodes(0:hats%n), modulus
        real(wp), dimension(hat_points, hats%n) :: height, load, share, further, unused
        integer :: info, round, n
        real(wp) :: exponent

        n = hats%n
        call line_compliance(hats, solver, a, matrix, modulus, error)
        if (allocated(error)) return
        exponent = atan(2.0_wp*max(a - stage%radius, 0.0_wp) &
                        /(modulus*rate%coefficients(1)*max(stage%sliding, tiny(a))))/pi
        height = profile%height(a*hats%radii)
        call stage%known(a*hats%radii, a, exponent, n, load, share)
        ! as if the pressure stayed
        call stage%before%at(a*hats%radii, unused, further)
        further = share*further
        do round = 1, most_changes
            system = matrix
            call add_wear(hats, rate, load, further, share, a, height, system, rhs)
            system(:, n) = -hats%areas*a**2
            call solve(system, rhs, info)
            if (info /= 0) then
                call raise(error, error_no_convergence, "the pressure of a worn contact was not found: the system is singular")
                return
            end if
            next%depth = rhs(n)
            rhs(n) = 0.0_wp
            if (size(rate%coefficients) == 1) exit
            if (is_settled(hats, rate, load, share, rhs, further)) exit
        end do
        next%radius = a
        next%extent = a
        next%power = hats%power
        next%force = dot_product(hats%areas, rhs)*a**2
        allocate (next%pressure(0:n), next%load(0:n))
        next%pressure = rhs
        call stage%known(a*hats%nodes, a, exponent, n, next%load, share_at_nodes)
        next%load = next%load + share_at_nodes*next%pressure
        next%load(n) = 0.0_wp
    end subroutine disc_at

    !> int p ds at the end of the stage without the pressure there, and what that pressure is multiplied by: continuous functions of
    !> the place.
    elemental subroutine known(self, r, a, exponent, n, load, share)
        class(stage_t), intent(in) :: self
        !> place, radius at the end [length], exponent of the pressure at the edge, and number of intervals
        real(wp), intent(in) :: r, a, exponent
        integer, intent(in) :: n
        real(wp), intent(out) :: load, share
        real(wp) :: pressure, unused, weight, fresh

        call self%before%at(r, load, pressure)
        if (self%kind == trapezoid) then
            weight = more_at_end(new_weight(r, self%radius, a, exponent), r, self%radius, a, n)
            load = load + self%sliding*(1.0_wp - weight)*pressure
            share = self%sliding*weight
            return
        end if
        share = self%sliding
        if (r >= self%radius) share = self%sliding*(a - r)/(a - self%radius)
        if (self%kind == first_stage) return
        call self%middle%at(r, unused, pressure)
        fresh = 0.0_wp
        if (r > self%radius) fresh = min((r - self%radius)/(fading*last_interval(a, n)), 1.0_wp)
        weight = more_at_end(first_part, r, self%radius, a, n)
        load = load + share*(1.0_wp - fresh)*(1.0_wp - weight)*pressure
        share = share*((1.0_wp - fresh)*weight + fresh/(1.0_wp + max(exponent, least_exponent)))
    end subroutine known

    !> w_n: of the pressure at the end of the step in int p ds over it, where the edge moves evenly from one radius to the other.
    elemental function new_weight(r, from, to, exponent) result(weight)
        real(wp), intent(in) :: r, from, to, exponent
        real(wp) :: weight
        real(wp) :: ratio, power, lambda

        lambda = max(exponent, least_exponent)
        if (r >= to) then
            weight = 0.0_wp
        else if (to - from <= at_rest*(to - r)) then
            weight = 0.5_wp + (1.0_wp - lambda)*max(to - from, 0.0_wp)/(12.0_wp*(to - r))
        else if (r >= from) then
            ! touched within the step
            weight = (to - r)/((to - from)*(1.0_wp + lambda))
        else
            ratio = (from - r)/(to - r)
            power = ratio**lambda
            weight = ((1.0_wp - ratio*power)/((1.0_wp + lambda)*(1.0_wp - ratio)) - power)/(1.0_wp - power)
        end if
    end function new_weight

    !> More of the end of the step next to an edge that moves by less than some of the intervals there: the hats at it, which wear
    !> fastest, would swing about the pressure from step to step.
    elemental function more_at_end(weight, r, from, to, n) result(more)
        real(wp), intent(in) :: weight, r, from, to
        integer, intent(in) :: n
        real(wp) :: more
        real(wp) :: width

        width = last_interval(to, n)
        more = weight + (1.0_wp - weight)*max(1.0_wp - max(to - from, 0.0_wp)/(slow*width), 0.0_wp) &
               /(1.0_wp + ((to - r)/(zone*width))**2)
    end function more_at_end

    !> About the length of the last of n intervals up to a radius.
    elemental function last_interval(radius, n) result(length)
        real(wp), intent(in) :: radius
        integer, intent(in) :: n
        real(wp) :: length

        length = 0.125_wp*radius*(pi/real(n, wp))**2
    end function last_interval

    !> Contribution of wear to the matrix, and the right-hand sides -int phi_i f 2 pi r dr, f the profile as far as it is known.
    pure subroutine add_wear(hats, rate, load, further, share, a, height, matrix, rhs)
        type(hats_t), intent(in) :: hats
        type(wear_rate_t), intent(in) :: rate
        !> int p ds without the pressure at the end of the step, that pressure times its share by the last guess, and the share
        real(wp), dimension(:, :), intent(in) :: load, further, share
        real(wp), intent(in) :: a, height(:, :)
        real(wp), intent(inout) :: matrix(0:, 0:)
        real(wp), intent(out) :: rhs(0:)
        real(wp) :: area, known, k
        integer :: c, i

        rhs = 0.0_wp
        do c = 1, hats%n
            do i = 1, hat_points
                area = hats%weights(i, c)*a**2
                k = rate%coefficient(load(i, c) + further(i, c))
                known = area*(height(i, c) + rate%worn_depth(load(i, c) + further(i, c)) - k*further(i, c))
                k = k*share(i, c)*area
                associate (up => hats%rising(i, c), down => 1.0_wp - hats%rising(i, c))
                    rhs(c - 1) = rhs(c - 1) - down*known
                    rhs(c) = rhs(c) - up*known
                    matrix(c - 1, c - 1) = matrix(c - 1, c - 1) + k*down**2
                    matrix(c, c - 1) = matrix(c, c - 1) + k*up*down
                    matrix(c - 1, c) = matrix(c - 1, c) + k*up*down
                    matrix(c, c) = matrix(c, c) + k*up**2
                end associate
            end do
        end do
    end subroutine add_wear

    !> Whether each place stays in the layer that was assumed; sets what is assumed next.
    function is_settled(hats, rate, load, share, pressure, further) result(settled)
        type(hats_t), intent(in) :: hats
        type(wear_rate_t), intent(in) :: rate
        real(wp), intent(in) :: load(:, :), share(:, :), pressure(0:)
        real(wp), intent(inout) :: further(:, :)
        logical :: settled
        real(wp) :: now(hat_points)
        integer :: c

        settled = .true.
        do c = 1, hats%n
            now = share(:, c)*(pressure(c - 1)*(1.0_wp - hats%rising(:, c)) + pressure(c)*hats%rising(:, c))
            settled = settled .and. all(rate%layer(load(:, c) + now) == rate%layer(load(:, c) + further(:, c)))
            further(:, c) = now
        end do
    end function is_settled

    !> int W 2 pi r dr of a disc, by what it has seen at each place.
    subroutine worn_volume(hats, rate, disc, volume)
        type(hats_t), intent(in) :: hats
        type(wear_rate_t), intent(in) :: rate
        type(disc_t), intent(in) :: disc
        real(wp), intent(out) :: volume
        type(wear_history_on_disc_t) :: on_disc
        real(wp), dimension(hat_points, hats%n) :: load, pressure

        if (disc%stays) then
            volume = sum(hats%areas*rate%worn_depth(disc%load))*disc%extent**2
            return
        end if
        call new_wear_history_on_disc(on_disc, disc)
        call on_disc%at(disc%radius*hats%radii, load, pressure)
        volume = sum(hats%weights*rate%worn_depth(load))*disc%radius**2
    end subroutine worn_volume

end module mdrcontact_wear_disc
