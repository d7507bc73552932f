! SPDX-License-Identifier: GPL-3.0-or-later
!> The fields of a contact with a cohesive zone: line load, pressure, displacement of the surface, elastic energy.
!>
!> Inside, p and u are those of d - g and of what the kernel adds, without a singular edge; the zone's load adds
!>     p(r) = -(2 sigma/pi) atan sqrt((c^2 - a^2)/(a^2 - r^2)), r < a,     u(r) = (2/pi) int_a^r w(x)/sqrt(r^2 - x^2) dx, r > a,
!> w = q/E0* + K q/E0* on the zone and beyond it: theory/adhesion.md (2.8), (2.9).
module mdrcontact_contact_zone_fields
    use mdrcontact_contact_cohesion, only: cohesion_t
    use mdrcontact_contact_state, only: contact_state_t
    use mdrcontact_error, only: check_memory, error_t
    use mdrcontact_gsl, only: gsl_sf_ellint_rd, gsl_sf_ellint_rf
    use mdrcontact_kinds, only: half_pi, pi, wp
    use mdrcontact_line_fields, only: line_load_t
    use mdrcontact_line_zone, only: zone_load_t, zone_state_t, zoned_springs_t
    use mdrcontact_medium_homogeneous, only: homogeneous_t, new_homogeneous_from_modulus
    use mdrcontact_medium_solver, only: of_displacement, of_pressure
    use mdrcontact_numerics_pick, only: pick
    use mdrcontact_profile, only: profile_t
    implicit none (type, external)
    private
    public :: zone_line_load, zone_pressure, zone_displacement, zone_energy

contains

    !> q(x), 0 <= x <= c [modulus length].
    subroutine zone_line_load(cohesion, profile, state, x, values, error)
        type(cohesion_t), intent(in), target :: cohesion
        class(profile_t), intent(in), target :: profile
        type(contact_state_t), intent(in) :: state
        real(wp), intent(in) :: x(:)
        real(wp), intent(out) :: values(:)
        type(error_t), allocatable, intent(inout) :: error
        type(zoned_springs_t) :: springs
        type(zone_load_t) :: load
        integer :: i

        call cohesion%load(profile, state, springs, load, error)
        if (allocated(error)) return
        if (state%radius > 0.0_wp) call load%contact%at(profile, min(x, state%radius), values)
        do i = 1, size(x)
            if (x(i) < state%radius) then
                values(i) = cohesion%modulus*values(i)
            else
                values(i) = -2.0_wp*cohesion%stress*sqrt(max(state%zone_radius - x(i), 0.0_wp)*(state%zone_radius + x(i)))
            end if
        end do
    end subroutine zone_line_load

    !> p(r), 0 <= r <= c [modulus].
    subroutine zone_pressure(cohesion, profile, state, r, values, error)
        type(cohesion_t), intent(in), target :: cohesion
        class(profile_t), intent(in), target :: profile
        type(contact_state_t), intent(in) :: state
        real(wp), intent(in) :: r(:)
        real(wp), intent(out) :: values(:)
        type(error_t), allocatable, intent(inout) :: error
        type(zoned_springs_t) :: springs
        type(zone_load_t) :: load
        type(homogeneous_t) :: surface
        real(wp), allocatable :: inside(:), pressure(:)
        integer, allocatable :: places(:)
        integer :: i

        values = -cohesion%stress
        call cohesion%load(profile, state, springs, load, error)
        call pick(r, places, inside, pressure, error, below=state%radius)
        if (allocated(error)) return
        if (size(places) == 0) return
        call new_homogeneous_from_modulus(surface, cohesion%modulus, error)
        if (.not. allocated(error)) call surface%field(of_pressure, profile, state%radius, 0.0_wp, inside, pressure, error)
        if (allocated(error)) return
        associate (a => state%radius, c => state%zone_radius)
            do i = 1, size(places)
                values(places(i)) = pressure(i) - 2.0_wp*cohesion%stress/pi &
                                    *atan2(sqrt((c - a)*(c + a)), sqrt((a - inside(i))*(a + inside(i))))
                if (.not. cohesion%kernel%vanishes) then
                    values(places(i)) = values(places(i)) + cohesion%modulus*load%contact%smooth_pressure(inside(i))
                end if
            end do
        end associate
    end subroutine zone_pressure

    !> u(r), r > a [length].
    subroutine zone_displacement(cohesion, profile, state, r, values, error)
        type(cohesion_t), intent(in), target :: cohesion
        class(profile_t), intent(in), target :: profile
        type(contact_state_t), intent(in) :: state
        real(wp), intent(in) :: r(:)
        real(wp), intent(out) :: values(:)
        type(error_t), allocatable, intent(inout) :: error
        type(zoned_springs_t) :: springs
        type(zone_load_t) :: load
        type(homogeneous_t) :: surface
        real(wp), allocatable :: added(:)
        integer :: i, stat

        values = 0.0_wp
        call cohesion%load(profile, state, springs, load, error)
        if (allocated(error)) return
        allocate (added(size(r)), stat=stat)
        call check_memory(error, stat)
        if (allocated(error)) return
        if (state%radius > 0.0_wp) then
            call new_homogeneous_from_modulus(surface, cohesion%modulus, error)
            if (.not. allocated(error)) call surface%field(of_displacement, profile, state%radius, &
                                                           state%depth - profile%mdr(state%radius), r, values, error)
            if (allocated(error)) return
            if (.not. cohesion%kernel%vanishes) then
                call load%contact%displacement_beyond(cohesion%kernel, r, added, error)
                if (allocated(error)) return
                values = values + added
            end if
        end if
        do i = 1, size(r)
            values(i) = values(i) - 2.0_wp*cohesion%stress/cohesion%modulus*(2.0_wp/pi) &
                        *of_springs(state%radius, state%zone_radius, r(i)) + springs%beyond(load, r(i), error)
            if (allocated(error)) return
        end do
    end subroutine zone_displacement

    !> int_a^min(r,c) sqrt(c^2 - x^2)/sqrt(r^2 - x^2) dx, as elliptic integrals of x = min(r, c) sin t.
    pure function of_springs(a, c, r) result(total)
        real(wp), intent(in) :: a, c, r
        real(wp) :: total
        real(wp) :: k, first, second

        if (.not. r > a) then
            total = 0.0_wp
        else if (abs(r - c) <= 1.0e-14_wp*c) then
            total = c - a
        else if (r < c) then
            k = r/c
            call elliptic(a/r, k, first, second)
            total = c*second
        else
            k = c/r
            call elliptic(min(a/c, 1.0_wp), k, first, second)
            total = r*second - (r - c)*(r + c)/r*first
        end if
    end function of_springs

    !> Legendre's F and E of modulus k < 1 from asin(s) to pi/2, by Carlson's forms.
    pure subroutine elliptic(s, k, first, second)
        real(wp), intent(in) :: s, k
        real(wp), intent(out) :: first, second
        real(wp) :: here(2), whole(2)

        here = legendre(s)
        whole = legendre(1.0_wp)
        first = whole(1) - here(1)
        second = whole(2) - here(2)

    contains

        pure function legendre(s) result(values)
            real(wp), intent(in) :: s
            real(wp) :: values(2)
            real(wp) :: x, y

            values = 0.0_wp
            if (.not. s > 0.0_wp) return
            x = (1.0_wp - s)*(1.0_wp + s)
            y = (1.0_wp - k*s)*(1.0_wp + k*s)
            values(1) = s*gsl_sf_ellint_rf(x, y, 1.0_wp, 0)
            values(2) = values(1) - k**2*s**3*gsl_sf_ellint_rd(x, y, 1.0_wp, 0)/3.0_wp
        end function legendre

    end subroutine elliptic

    !> The elastic energy of both bodies, int q w dx over the whole load [modulus length^3].
    subroutine zone_energy(cohesion, profile, state, energy, error)
        type(cohesion_t), intent(in), target :: cohesion
        class(profile_t), intent(in), target :: profile
        type(contact_state_t), intent(in) :: state
        real(wp), intent(out) :: energy
        type(error_t), allocatable, intent(inout) :: error
        type(zoned_springs_t) :: springs
        type(zone_load_t) :: load

        energy = 0.0_wp
        call cohesion%load(profile, state, springs, load, error)
        if (allocated(error)) return
        energy = load%work
        if (state%radius > 0.0_wp) energy = energy + load%contact%work_on(profile, load%contact%v, error)
        energy = cohesion%modulus*energy
    end subroutine zone_energy

end module mdrcontact_contact_zone_fields
