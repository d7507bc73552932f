! SPDX-License-Identifier: GPL-3.0-or-later
!> One step of gross sliding on rings that are fixed on the indenter (theory/wear.md (6.1)): of first order, for any path of load
!> and depth.
!>
!> With hats phi_i between fixed radii, areas A_i = int phi_i 2 pi r dr, and the pressure at the end of the step,
!>
!>     sum_j B_ij p_j + int phi_i f_0 2 pi r dr + A_i [W(int p ds + ds p_i) - d] >= 0,   p_i >= 0,   one of both 0,
!>
!> B_ij = int phi_i S phi_j 2 pi r dr, is one contact under an added layer of springs: it has one solution, for any load. What
!> is worn off is sum A_i k p_i ds = k F ds to machine precision.
module mdrcontact_wear_rings
    use mdrcontact_error, only: error_domain, error_no_convergence, error_t, raise, to_text
    use mdrcontact_kinds, only: pi, wp
    use mdrcontact_medium_solver, only: solver_t
    use mdrcontact_numerics_one_thread, only: add_times, solve
    use mdrcontact_profile, only: profile_t
    use mdrcontact_medium_hats, only: find_heights, hats_t, line_compliance
    use mdrcontact_wear_history_on_disc, only: disc_t
    use mdrcontact_wear_rate, only: wear_rate_t
    implicit none (type, external)
    private
    public :: first_extent, step_rings

    !> Pressures and gaps down to minus this part of the largest ones are rounding errors.
    real(wp), parameter :: rounding = 1.0e-13_wp
    !> So often all rings change that should, without their number falling, before they change one by one, which ends (Murty).
    integer, parameter :: patience = 8
    !> Largest number of systems solved in a step, for each ring.
    integer, parameter :: most_rounds = 20
    !> The rings reach so far at first, in contact radii, and twice as far each time that the contact has come to this part of them.
    real(wp), parameter :: ahead = 1.5_wp, nearly_all = 0.9_wp

    !> The exponent at the edge is that of the pressures between the last ring but one and the one so many before the last.
    integer, parameter :: inner_ring = 6

contains

    !> Radius of the last ring for a contact that begins with a radius; of an indenter with a wall, half as far some times.
    pure function first_extent(profile, radius) result(extent)
        class(profile_t), intent(in) :: profile
        !> [length]
        real(wp), intent(in) :: radius
        real(wp) :: extent

        extent = ahead*radius
        if (.not. profile%has_wall) return
        extent = profile%largest_radius
        do while (0.5_wp*extent >= ahead*radius)
            extent = 0.5_wp*extent
        end do
    end function first_extent

    !> The rings after a step, from those before it.
    subroutine step_rings(hats, solver, profile, rate, disc, sliding, by_depth, target, next, work, error)
        type(hats_t), intent(in) :: hats
        class(solver_t), intent(in) :: solver
        !> unworn
        class(profile_t), intent(in) :: profile
        type(wear_rate_t), intent(in) :: rate
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
        logical :: is_full

        next = disc
        do
            call step_on(hats, solver, profile, rate, sliding, by_depth, target, next, is_full, error)
            work = sliding*next%force
            if (allocated(error) .or. .not. is_full) return
            call widen(hats, next)
        end do
    end subroutine step_rings

    !> The step of rings up to one radius.
    subroutine step_on(hats, solver, profile, rate, sliding, by_depth, target, disc, is_full, error)
        type(hats_t), intent(in) :: hats
        class(solver_t), intent(in) :: solver
        class(profile_t), intent(in) :: profile
        type(wear_rate_t), intent(in) :: rate
        real(wp), intent(in) :: sliding, target
        logical, intent(in) :: by_depth
        type(disc_t), intent(inout) :: disc
        !> whether few rings are left that do not touch, though the indenter continues
        logical, intent(out) :: is_full
        type(error_t), allocatable, intent(inout) :: error
        real(wp) :: matrix(0:hats%n, 0:hats%n), heights(0:hats%n), areas(0:hats%n), modulus
        logical :: reachable(0:hats%n), touching(0:hats%n)

        is_full = .false.
        call line_compliance(hats, solver, disc%extent, matrix, modulus, error)
        if (allocated(error)) return
        areas = hats%areas*disc%extent**2
        call find_heights(hats, profile, disc%extent, heights, reachable)
        touching = disc%pressure > 0.0_wp .and. reachable
        if (.not. any(touching)) touching = disc%extent*hats%nodes <= disc%radius .and. reachable
        call settle(matrix, disc%extent*hats%nodes, heights, areas, reachable, rate, disc%load, sliding, by_depth, target, &
                    touching, disc%pressure, disc%depth, disc%radius, error)
        if (allocated(error)) return
        is_full = disc%extent < profile%largest_radius .and. last_of(touching) >= nint(nearly_all*real(hats%n, wp))
        if (.not. is_full) call check_touch(profile, reachable, touching, target, error)
        disc%force = dot_product(areas, disc%pressure)
        if (.not. is_full) disc%load = disc%load + sliding*disc%pressure
    end subroutine step_on

    !> The outermost ring of some, -1 without any.
    pure function last_of(rings) result(last)
        logical, intent(in) :: rings(0:)
        integer :: last

        last = findloc(rings, .true., dim=1, back=.true.) - 1
    end function last_of

    !> The rings that touch, their pressures, and the depth.
    subroutine settle(matrix, radii, heights, areas, reachable, rate, load, sliding, by_depth, target, touching, pressure, depth, &
                      radius, error)
        real(wp), intent(in) :: matrix(0:, 0:), radii(0:), heights(0:), areas(0:)
        logical, intent(in) :: reachable(0:)
        type(wear_rate_t), intent(in) :: rate
        real(wp), intent(in) :: load(0:), sliding, target
        logical, intent(in) :: by_depth
        !> on entry the first guess
        logical, intent(inout) :: touching(0:)
        real(wp), intent(inout) :: pressure(0:)
        real(wp), intent(out) :: depth, radius
        type(error_t), allocatable, intent(inout) :: error
        real(wp), dimension(0:ubound(load, 1)) :: further, next, k, known, gap
        logical :: wrong(0:ubound(load, 1)), is_settled
        integer :: round, fewest, tries, n, beyond(2)

        n = ubound(load, 1)
        fewest = n + 2
        tries = patience
        further = sliding*pressure
        is_settled = .false.
        do round = 1, most_rounds*(n + 1)
            k = rate%coefficient(load + further)
            known = heights + areas*(rate%worn_depth(load + further) - k*further)
            call press(matrix, areas, known, sliding*k*areas, by_depth, target, touching, pressure, depth, error)
            if (allocated(error)) return
            gap = known - areas*depth
            call add_times("N", n + 1, n + 1, 1.0_wp, matrix, n + 1, pressure, gap)
            wrong = (touching .and. pressure < -rounding*maxval(abs(pressure))) &
                    .or. (.not. touching .and. reachable .and. gap < -rounding*areas*abs(depth))
            next = sliding*max(pressure, 0.0_wp)
            is_settled = .not. any(wrong) .and. all(rate%layer(load + next) == rate%layer(load + further))
            further = next
            if (is_settled) exit
            call exchange(wrong, fewest, tries, touching)
        end do
        if (.not. is_settled) then
            call raise(error, error_no_convergence, "the rings that touch were not found for "//to_text(target)// &
                       " at this step of wear")
            return
        end if
        pressure = max(pressure, 0.0_wp)
        radius = touching_radius(matrix, areas, sliding*k*areas, gap, touching, pressure)
        beyond = last_of(touching) + [2, 3]
        if (is_one_disc(touching, beyond(2), n)) then
            if (all(reachable(beyond)) .and. all(load(beyond(1) - 1:) <= 0.0_wp)) then
                call move_edge(gap(beyond)/areas(beyond), beyond(1), pressure, radii, radius)
            end if
        end if
    end subroutine settle

    !> Whether only a disc of inner rings touches, at least two rings from the last one.
    pure function is_one_disc(touching, beyond, n) result(answer)
        logical, intent(in) :: touching(0:)
        integer, intent(in) :: beyond, n
        logical :: answer

        answer = beyond <= n .and. count(touching) == last_of(touching) + 1 .and. count(touching) > inner_ring + 2
    end function is_one_disc

    !> Moves the edge to where the gap over unworn rings vanishes, as far as the pressure ends in a step there. With p ~ rho^lambda
    !> the gap follows rho^(1 + lambda) (theory/wear.md (6.2)). At lambda = 1/2, without wear, the area that touches is better.
    pure subroutine move_edge(gaps, ring, pressure, radii, radius)
        !> of a ring beyond the edge and the next one [length]
        real(wp), intent(in) :: gaps(2)
        integer, intent(in) :: ring
        real(wp), intent(in) :: pressure(0:), radii(0:)
        real(wp), intent(inout) :: radius
        real(wp) :: exponent, edge, roots(2)
        integer :: last, inner

        last = ring - 3
        inner = last - inner_ring
        ! rings that are worn off touch without pressure
        if (min(pressure(inner), pressure(last)) <= 0.0_wp) return
        exponent = log(pressure(inner)/pressure(last))/log((radius - radii(inner))/(radius - radii(last)))
        exponent = min(max(exponent, 0.0_wp), 0.5_wp)
        roots = gaps**(1.0_wp/(1.0_wp + exponent))
        edge = radii(ring) - (radii(ring + 1) - radii(ring))*roots(1)/(roots(2) - roots(1))
        if (abs(edge - radius) < radii(ring + 1) - radii(ring - 1)) radius = radius + (1.0_wp - 2.0_wp*exponent)*(edge - radius)
    end subroutine move_edge

    !> Rings that pull or overlap change; all together as long as their number falls, else the outermost one alone.
    pure subroutine exchange(wrong, fewest, tries, touching)
        logical, intent(in) :: wrong(0:)
        integer, intent(inout) :: fewest, tries
        logical, intent(inout) :: touching(0:)
        integer :: last

        tries = tries - 1
        if (count(wrong) < fewest) then
            fewest = count(wrong)
            tries = patience
        end if
        if (tries > 0) then
            touching = touching .neqv. wrong
        else if (any(wrong)) then
            last = last_of(wrong)
            touching(last) = .not. touching(last)
        end if
    end subroutine exchange

    !> Pressures of rings that all touch, and the depth.
    subroutine press(matrix, areas, known, softness, by_depth, target, touching, pressure, depth, error)
        real(wp), intent(in) :: matrix(0:, 0:), areas(0:), known(0:), softness(0:), target
        logical, intent(in) :: by_depth, touching(0:)
        real(wp), intent(out) :: pressure(0:)
        real(wp), intent(out) :: depth
        type(error_t), allocatable, intent(inout) :: error
        real(wp), allocatable :: system(:, :), unknowns(:)
        integer, allocatable :: rings(:)
        integer :: i, m, info

        rings = pack([(i, i=0, ubound(areas, 1))], touching)
        m = size(rings)
        allocate (system(m + 1, m + 1), unknowns(m + 1))
        system(:m, :m) = matrix(rings, rings)
        do i = 1, m
            system(i, i) = system(i, i) + softness(rings(i))
        end do
        system(:m, m + 1) = -areas(rings)
        system(m + 1, :m) = merge(0.0_wp, 1.0_wp, by_depth)*areas(rings)
        system(m + 1, m + 1) = merge(1.0_wp, 0.0_wp, by_depth)
        unknowns(:m) = -known(rings)
        unknowns(m + 1) = target
        call solve(system, unknowns, info)
        if (info /= 0) then
            call raise(error, error_no_convergence, "the pressure of a worn contact was not found: the system is singular")
            return
        end if
        pressure = 0.0_wp
        pressure(rings) = unknowns(:m)
        depth = unknowns(m + 1)
    end subroutine press

    !> Radius of a disc of the contact area; the outermost ring counts with a part from 0, when it begins to carry, to 1, when
    !> the next one does.
    pure function touching_radius(matrix, areas, softness, gap, touching, pressure) result(radius)
        real(wp), intent(in) :: matrix(0:, 0:), areas(0:), softness(0:), gap(0:), pressure(0:)
        logical, intent(in) :: touching(0:)
        real(wp) :: radius
        real(wp) :: area, overlap
        integer :: last

        area = sum(areas, mask=touching)
        last = last_of(touching)
        if (last >= 0 .and. last < ubound(areas, 1)) then
            overlap = pressure(last)*(matrix(last, last) + softness(last))
            area = area - areas(last)*gap(last + 1)/(gap(last + 1) + overlap)
        end if
        radius = sqrt(area/pi)
    end function touching_radius

    !> Raises where nothing touches any more, or what touches reaches the end of the indenter.
    subroutine check_touch(profile, reachable, touching, target, error)
        class(profile_t), intent(in) :: profile
        logical, intent(in) :: reachable(0:), touching(0:)
        real(wp), intent(in) :: target
        type(error_t), allocatable, intent(inout) :: error
        integer :: last

        last = last_of(reachable)
        if (.not. any(touching)) then
            call raise(error, error_domain, "the indenter would lift off at depth "//to_text(target)//". The history is unchanged")
        else if (last < 0 .or. .not. profile%has_wall .and. touching(max(last, 0))) then
            call raise(error, error_domain, "the contact would grow beyond where the indenter ends, "// &
                       to_text(profile%largest_radius)//". The history is unchanged")
        end if
    end subroutine check_touch

    !> Twice as far, with rings twice as wide: every second radius stays, and each ring's int p ds and pressure go to the rings that
    !> its hat is a part of, which keeps volume and force.
    pure subroutine widen(hats, disc)
        type(hats_t), intent(in) :: hats
        type(disc_t), intent(inout) :: disc

        disc%extent = 2.0_wp*disc%extent
        disc%load = wider(hats%areas, disc%load)
        disc%pressure = wider(hats%areas, disc%pressure)
    end subroutine widen

    !> Values on rings twice as wide, of an even number of intervals.
    pure function wider(areas, values) result(means)
        real(wp), intent(in) :: areas(0:), values(0:)
        real(wp) :: means(0:ubound(values, 1))
        real(wp) :: parts(0:ubound(values, 1))
        integer :: i, n

        n = ubound(values, 1)
        parts = areas*values
        means = 0.0_wp
        means(0) = parts(0)
        do i = 1, n/2
            means(i) = means(i) + parts(2*i) + 0.5_wp*parts(2*i - 1)
            means(i - 1) = means(i - 1) + 0.5_wp*parts(2*i - 1)
        end do
        means(:n/2) = 0.25_wp*means(:n/2)/areas(:n/2)
    end function wider

end module mdrcontact_wear_rings
