! SPDX-License-Identifier: GPL-3.0-or-later
!> Contact whose pressure is at most a hardness, 0 <= p <= H, on any body: a bounded quadratic program for a pressure that is a sum
!> of hats on the disc of the contact (theory/plastic.md (6.1)-(6.3)).
!>
!> Where p < H the indenter touches the elastically deformed surface, int phi_i (S p + f - d) 2 pi r dr = 0; where p = H the surface
!> is left behind by u_p = d - f - S p >= 0. At the edge p = 0 and the last row is the half hat inside it.
module mdrcontact_plastic_cap
    use, intrinsic :: iso_c_binding, only: c_double
    use mdrcontact_contact, only: contact_t
    use mdrcontact_contact_state, only: contact_state_t
    use mdrcontact_error, only: check_made, check_memory, check_not_negative, check_positive, check_within, &
                                error_domain, error_invalid, error_no_convergence, error_t, raise, raise_at, to_text
    use mdrcontact_kinds, only: half_pi, pi, wp
    use mdrcontact_medium_hats, only: find_heights, hats_t, line_compliance, new_hats
    use mdrcontact_medium_solver, only: check_springs
    use mdrcontact_nonfinite, only: is_finite
    use mdrcontact_numerics_one_thread, only: add_times, solve_system => solve
    use mdrcontact_numerics_search, only: interval_of
    use mdrcontact_plastic_radius_search, only: by_depth, by_radius, check_given, find_radius, miss_t
    implicit none (type, external)
    private
    public :: cap_t, cap_state_t, new_cap, truncated_hertz

    !> Intervals of the finer disc; the coarser one has half as many. Their results are extrapolated, the error is of second order.
    integer, parameter :: intervals = 96
    !> Largest number of Legendre polynomials that line loads take on layered bodies.
    integer, parameter :: most_waves = 128
    !> So often all hats change that should, without their number falling, before they change one by one, which ends (Murty).
    integer, parameter :: patience = 8, most_rounds = 20
    !> Pressures and gaps beyond their bounds by this part of the largest are rounding errors; below 0 by more than the second, the
    !> contact is no disc.
    real(wp), parameter :: rounding = 1.0e-12_wp, least_pressure = -1.0e-6_wp
    !> The last hat inside the edge swings to about minus this part as the elastic annulus becomes narrower than its interval.
    real(wp), parameter :: swing = -0.2_wp
    !> The slope at this part of a radius over that at it, of an indenter with an apex.
    real(wp), parameter :: apex = 1.0e-3_wp

    !> An indenter on a body under a hardness. It never changes.
    type :: cap_t
        !> the elastic contact
        type(contact_t) :: contact
        !> H [modulus]
        real(wp) :: hardness = 0.0_wp
        !> whether a maker has made it
        logical :: is_made = .false.
        type(hats_t), private :: hats(2)
    contains
        procedure :: at
        procedure :: states
        procedure :: pressure_at
    end type cap_t

    !> A state, C's struct mdr_cap_state.
    type, bind(C) :: cap_state_t
        !> d, a [length], F [modulus length^2]
        real(c_double) :: depth = 0.0_c_double, radius = 0.0_c_double, force = 0.0_c_double
        !> the outermost radius at which p = H, 0: none [length]
        real(c_double) :: capped_radius = 0.0_c_double
        !> u_p on the axis, at which unloading ends the contact [length]
        real(c_double) :: residual_depth = 0.0_c_double
        !> work that unloading gives back [modulus length^3]
        real(c_double) :: recovered_work = 0.0_c_double
        !> relative error of force and depth, estimated from two resolutions [1]
        real(c_double) :: error = 0.0_c_double
    end type cap_state_t

    !> Pressure and residual displacement of a state on one disc.
    type :: disc_t
        !> p and u_p at the nodes, 0 ... n
        real(wp), allocatable :: pressure(:), residual(:)
        !> d, F, u_p on the axis, work given back
        real(wp) :: values(4) = 0.0_wp
    end type disc_t

    type, extends(miss_t) :: cap_miss_t
        type(cap_t), pointer :: cap => null()
    contains
        procedure :: depth_and_force
    end type cap_miss_t

contains

    !> A contact under a hardness.
    subroutine new_cap(self, contact, hardness, error)
        type(cap_t), intent(out) :: self
        !> copied; without adhesion
        type(contact_t), intent(in) :: contact
        !> H > 0 [modulus]
        real(wp), intent(in) :: hardness
        type(error_t), allocatable, intent(out) :: error
        integer :: i, power

        call check_made(error, "contact", contact%is_made)
        call check_positive(error, "hardness", hardness)
        if (.not. allocated(error) .and. contact%is_adhesive()) then
            call raise(error, error_invalid, "contact: a pressure cap has no adhesion. Omit it, and unload an imprint "// &
                       "with adhesion")
        end if
        if (.not. allocated(error) .and. contact%equilibrium%has_zeta) then
            call raise(error, error_invalid, "zeta: it is not available under a pressure cap. Omit it")
        end if
        if (.not. allocated(error) .and. contact%equilibrium%profile%has_wall) then
            call raise(error, error_invalid, "contact: the pressure under a flat punch does not determine its radius. Use an "// &
                       "indenter without a vertical wall")
        end if
        if (.not. allocated(error)) call check_springs(contact%equilibrium%medium, "a pressure cap is", error)
        if (allocated(error)) return
        self%contact = contact
        self%hardness = hardness
        power = merge(2, 1, is_pointed(contact))
        do i = 1, 2
            call new_hats(self%hats(i), intervals*i/2, power, merge(0, most_waves, contact%is_formula()), error)
            if (allocated(error)) return
        end do
        self%is_made = .true.
    end subroutine new_cap

    !> Whether the slope does not vanish towards the axis.
    pure function is_pointed(contact) result(answer)
        type(contact_t), intent(in) :: contact
        logical :: answer
        real(wp) :: r

        associate (profile => contact%equilibrium%profile)
            r = min(1.0_wp, profile%largest_radius)
            do while (profile%height(r) > r)
                r = 0.5_wp*r
            end do
            answer = profile%slope(apex*r) > 0.1_wp*profile%slope(r)
        end associate
    end function is_pointed

    !> The state at a given radius, depth or force.
    subroutine at(self, given, value, state, error)
        class(cap_t), intent(in), target :: self
        !> radius, depth or force of mdrcontact_codes
        integer, intent(in) :: given
        !> > 0 [length] or [modulus length^2]
        real(wp), intent(in) :: value
        type(cap_state_t), intent(out) :: state
        type(error_t), allocatable, intent(out) :: error
        real(wp) :: a

        call check_made(error, "cap", self%is_made)
        call check_given(given, value, error)
        if (given == by_radius) call check_end(self, value, error)
        if (allocated(error)) return
        a = value
        if (given /= by_radius) call search(self, given == by_depth, value, a, error)
        if (.not. allocated(error)) call state_at(self, a, state, error)
    end subroutine at

    !> Raises beyond the end of indenter or medium.
    pure subroutine check_end(self, a, error)
        class(cap_t), intent(in) :: self
        real(wp), intent(in) :: a
        type(error_t), allocatable, intent(inout) :: error

        if (a <= self%contact%equilibrium%last_radius .or. allocated(error)) return
        call raise(error, error_domain, " = "//to_text(a)//": indenter and medium are defined up to "// &
                   to_text(self%contact%equilibrium%last_radius), "radius")
    end subroutine check_end

    !> States at given radii, depths or forces.
    subroutine states(self, given, values, found, error)
        class(cap_t), intent(in), target :: self
        !> see at
        integer, intent(in) :: given
        !> radii [length], depths [length] or forces, > 0
        real(wp), intent(in) :: values(:)
        !> as many
        type(cap_state_t), intent(out) :: found(:)
        type(error_t), allocatable, intent(out) :: error
        integer :: i

        call check_made(error, "cap", self%is_made)
        if (allocated(error)) return
        do i = 1, size(values)
            call self%at(given, values(i), found(i), error)
            if (.not. allocated(error)) cycle
            call raise_at(error, i)
            return
        end do
    end subroutine states

    !> p and u_p at radii, of the state of a contact radius; 0 beyond it.
    subroutine pressure_at(self, a, r, pressure, residual, error)
        class(cap_t), intent(in) :: self
        !> a > 0, and places >= 0 [length]
        real(wp), intent(in) :: a, r(:)
        !> [modulus], [length]
        real(wp), intent(out) :: pressure(:), residual(:)
        type(error_t), allocatable, intent(out) :: error
        type(disc_t) :: disc
        real(wp) :: part, nodes(0:intervals)
        integer :: i, k

        pressure = 0.0_wp
        residual = 0.0_wp
        call check_made(error, "cap", self%is_made)
        call check_positive(error, "radius", a)
        call check_end(self, a, error)
        do i = 1, size(r)
            call check_not_negative(error, "r", r(i), i)
        end do
        if (.not. allocated(error)) call press(self, self%hats(2), a, disc, error)
        if (allocated(error)) return
        nodes = a*self%hats(2)%nodes
        do i = 1, size(r)
            if (r(i) >= a) cycle
            k = interval_of(nodes, r(i)) - 1
            part = (r(i) - nodes(k))/(nodes(k + 1) - nodes(k))
            pressure(i) = min(max((1.0_wp - part)*disc%pressure(k) + part*disc%pressure(k + 1), 0.0_wp), self%hardness)
            residual(i) = (1.0_wp - part)*disc%residual(k) + part*disc%residual(k + 1)
        end do
    end subroutine pressure_at

    !> By both discs, extrapolated.
    subroutine state_at(self, a, state, error)
        class(cap_t), intent(in) :: self
        real(wp), intent(in) :: a
        type(cap_state_t), intent(out) :: state
        type(error_t), allocatable, intent(inout) :: error
        type(disc_t) :: discs(2)
        real(wp) :: values(4), change(4)
        integer :: i

        do i = 1, 2
            call press(self, self%hats(i), a, discs(i), error)
            if (allocated(error)) return
        end do
        change = (discs(2)%values - discs(1)%values)/3.0_wp
        values = discs(2)%values + change
        state%radius = a
        state%depth = values(1)
        state%force = values(2)
        state%residual_depth = max(values(3), 0.0_wp)
        state%recovered_work = values(4)
        state%error = maxval(abs(change(:2)/values(:2)))
        i = findloc(discs(2)%pressure >= self%hardness, .true., dim=1, back=.true.)
        if (i > 0) state%capped_radius = a*self%hats(2)%nodes(i - 1)
    end subroutine state_at

    !> The radius of a depth or a force: both grow with it, from that of the elastic contact.
    subroutine search(self, is_depth, wanted, a, error)
        class(cap_t), intent(in), target :: self
        logical, intent(in) :: is_depth
        real(wp), intent(in) :: wanted
        real(wp), intent(out) :: a
        type(error_t), allocatable, intent(inout) :: error
        type(cap_miss_t) :: miss
        real(wp) :: guess

        a = 0.0_wp
        call start_of(self%contact, is_depth, wanted, guess, error)
        if (allocated(error)) return
        miss%cap => self
        miss%is_depth = is_depth
        miss%wanted = wanted
        associate (last => self%contact%equilibrium%last_radius)
            call find_radius(miss, guess, last, "the hardness supports less up to the radius "//to_text(last)// &
                             ", where indenter or medium end", a, error)
        end associate
    end subroutine search

    !> A radius at which a search may begin: the elastic one, or where the elastic contact does not reach so far, the largest one.
    subroutine start_of(contact, is_depth, wanted, a, error)
        type(contact_t), intent(in), target :: contact
        logical, intent(in) :: is_depth
        real(wp), intent(in) :: wanted
        real(wp), intent(out) :: a
        type(error_t), allocatable, intent(inout) :: error
        type(contact_state_t) :: state, last
        type(error_t), allocatable :: missing, failed

        if (is_depth) then
            call contact%at_depth(wanted, state, missing)
        else
            call contact%at_force(wanted, state, missing)
        end if
        a = state%radius
        if (.not. allocated(missing)) return
        a = contact%equilibrium%last_radius
        call contact%at_radius(a, last, failed)
        if (allocated(failed) .or. merge(last%depth, last%force, is_depth) >= wanted) call move_alloc(missing, error)
    end subroutine start_of

    subroutine depth_and_force(self, radius, depth, force, error)
        class(cap_miss_t), intent(in) :: self
        real(wp), intent(in) :: radius
        real(wp), intent(out) :: depth, force
        type(error_t), allocatable, intent(out) :: error
        type(cap_state_t) :: state

        call state_at(self%cap, radius, state, error)
        depth = state%depth
        force = state%force
    end subroutine depth_and_force

    !> Pressure, depth and residual displacement of a contact radius on one disc.
    subroutine press(self, hats, a, disc, error)
        class(cap_t), intent(in) :: self
        type(hats_t), intent(in) :: hats
        real(wp), intent(in) :: a
        type(disc_t), intent(out) :: disc
        type(error_t), allocatable, intent(inout) :: error
        real(wp), allocatable :: matrix(:, :)
        real(wp) :: heights(0:hats%n), areas(0:hats%n), gap(0:hats%n), modulus
        logical :: reachable(0:hats%n), capped(0:hats%n), wrong(0:hats%n)
        integer :: fewest, n, round, tries, stat

        n = hats%n
        allocate (disc%pressure(0:n), disc%residual(0:n), matrix(0:n, 0:n), stat=stat)
        call check_memory(error, stat)
        if (.not. allocated(error)) call line_compliance(hats, self%contact%equilibrium%medium, a, matrix, modulus, error)
        if (allocated(error)) return
        call find_heights(hats, self%contact%equilibrium%profile, a, heights, reachable)
        areas = hats%areas*a**2
        capped = .false.
        fewest = n + 2
        tries = patience
        do round = 1, most_rounds*(n + 1)
            call solve(matrix, areas, heights, self%hardness, capped, disc%pressure, disc%values(1), error)
            if (allocated(error)) return
            gap = heights - areas*disc%values(1)
            call add_times("N", n + 1, n + 1, 1.0_wp, matrix, n + 1, disc%pressure, gap)
            wrong = merge(gap > rounding*areas*disc%values(1), disc%pressure > self%hardness*(1.0_wp + rounding), capped)
            if (.not. any(wrong)) exit
            call exchange(wrong, fewest, tries, capped)
        end do
        disc%residual = merge(max(-gap/areas, 0.0_wp), 0.0_wp, capped)
        disc%values(2) = dot_product(areas, disc%pressure)
        disc%values(3) = disc%residual(0)
        ! half of int p S p dA
        disc%values(4) = 0.5_wp*dot_product(disc%pressure, gap - heights + areas*disc%values(1))
        if (.not. all(is_finite(disc%values))) then
            call raise(error, error_no_convergence, "radius = "//to_text(a)//": depth, force or work under the cap exceeds the "// &
                       "range of double precision. Choose other units")
        else if (any(wrong)) then
            call raise(error, error_no_convergence, "the capped pressure at contact radius "//to_text(a)//" was not found")
        else if (any(disc%pressure(:n - 2) < least_pressure*maxval(disc%pressure)) .or. &
                 disc%pressure(n - 1) < swing*maxval(disc%pressure)) then
            call raise(error, error_domain, "radius = "//to_text(a)//": the contact under the cap is not a single disc there, "// &
                       "as on stiff films. Reduce the load")
        end if
    end subroutine press

    !> Hats that are wrong change; all together as long as their number falls, else the outermost one alone.
    pure subroutine exchange(wrong, fewest, tries, capped)
        logical, intent(in) :: wrong(0:)
        integer, intent(inout) :: fewest, tries
        logical, intent(inout) :: capped(0:)
        integer :: last

        tries = tries - 1
        if (count(wrong) < fewest) then
            fewest = count(wrong)
            tries = patience
        end if
        if (tries > 0) then
            capped = capped .neqv. wrong
        else
            last = findloc(wrong, .true., dim=1, back=.true.) - 1
            capped(last) = .not. capped(last)
        end if
    end subroutine exchange

    !> Pressures of the hats that are not capped, and the depth; the pressure at the edge is 0.
    subroutine solve(matrix, areas, heights, hardness, capped, pressure, depth, error)
        real(wp), intent(in) :: matrix(0:, 0:), areas(0:), heights(0:), hardness
        logical, intent(in) :: capped(0:)
        real(wp), intent(out) :: pressure(0:)
        real(wp), intent(out) :: depth
        type(error_t), allocatable, intent(inout) :: error
        real(wp), allocatable :: system(:, :), unknowns(:)
        integer, allocatable :: free(:)
        integer :: i, info, m, n

        n = ubound(areas, 1)
        free = pack([(i, i=0, n)], .not. capped)
        m = size(free)
        pressure = merge(hardness, 0.0_wp, capped)
        unknowns = -heights(free) - matmul(matrix(free, :), pressure)
        system = matrix(free, free)
        ! the last one is that of the edge, whose unknown is the depth
        system(:, m) = -areas(free)
        call solve_system(system, unknowns, info)
        depth = 0.0_wp
        if (info /= 0 .and. info <= m) then ! the caller reports numbers that are not finite
            call raise(error, error_no_convergence, "the pressure under a cap was not found: the system is singular")
            return
        end if
        depth = unknowns(m)
        pressure(free(:m - 1)) = unknowns(:m - 1)
    end subroutine solve

    !> The line load of Hertz's pressure that is cut at a hardness, min(p0 sqrt(1 - r^2/a^2), H): another model, theory/plastic.md
    !> (6.4), (6.5).
    pure subroutine truncated_hertz(a, largest, hardness, x, loads, error)
        !> a > 0 [length], p0 > 0 and H > 0 [modulus]
        real(wp), intent(in) :: a, largest, hardness
        !> 0 <= x <= a [length]
        real(wp), intent(in) :: x(:)
        !> [modulus length]
        real(wp), intent(out) :: loads(:)
        type(error_t), allocatable, intent(out) :: error
        real(wp) :: rest, square
        integer :: i

        loads = 0.0_wp
        call check_positive(error, "a", a)
        call check_positive(error, "largest", largest)
        call check_positive(error, "hardness", hardness)
        do i = 1, size(x)
            if (allocated(error)) return
            call check_within(error, "x", x(i), 0.0_wp, a)
            if (allocated(error)) then
                call raise_at(error, i)
                return
            end if
            rest = (a - x(i))/a*(1.0_wp + x(i)/a)
            square = rest - min(hardness/largest, 1.0_wp)**2
            loads(i) = half_pi*largest*rest*a
            if (square > 0.0_wp) loads(i) = (hardness*sqrt(square) + largest*rest*acos(sqrt(min(square/rest, 1.0_wp))))*a
        end do
    end subroutine truncated_hertz

end module mdrcontact_plastic_cap
