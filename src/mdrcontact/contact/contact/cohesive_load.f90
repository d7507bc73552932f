! SPDX-License-Identifier: GPL-3.0-or-later
!> The load of a contact with a cohesive zone: line load, pressure, displacement of the surface, elastic energy.
!>
!> Inside, p and u are those of d - g and of what the kernel adds, without a singular edge; the zone's load adds
!>     p(r) = -(2 sigma_0/pi) atan sqrt((c^2 - a^2)/(a^2 - r^2)), r < a,     u(r) = (2/pi) int_a^r w(x)/sqrt(r^2 - x^2) dx, r > a,
!> w = q/E0* + K q/E0* on the zone and beyond it: theory/adhesion.md (2.8), (2.9).
module mdrcontact_contact_cohesive_load
    use mdrcontact_contact_cohesion, only: cohesion_t
    use mdrcontact_contact_state, only: contact_state_t
    use mdrcontact_error, only: check_memory, error_invalid, error_t, raise
    use mdrcontact_gsl, only: gsl_sf_ellint_rd, gsl_sf_ellint_rf
    use mdrcontact_kinds, only: half_pi, pi, wp
    use mdrcontact_line_zone, only: zone_load_t, zoned_springs_t
    use mdrcontact_medium_effective, only: effective_load_t
    use mdrcontact_medium_load, only: load_t, upper_body
    use mdrcontact_medium_homogeneous, only: homogeneous_t, new_homogeneous_from_modulus
    use mdrcontact_medium_solver, only: solver_t
    use mdrcontact_numerics_pick, only: pick
    use mdrcontact_profile, only: profile_t
    implicit none (type, external)
    private
    public :: cohesive_load_t, new_cohesive_load

    !> The load of a contact and of the zone around it, up to radius c.
    type, extends(load_t) :: cohesive_load_t
        private
        type(cohesion_t), pointer :: cohesion => null()
        !> d and c [length]
        real(wp) :: depth = 0.0_wp, zone_radius = 0.0_wp
        !> whether either of two bodies takes a known part of the displacement
        logical :: is_shared = .true.
        type(zoned_springs_t) :: springs
        type(zone_load_t) :: zone
    contains
        procedure :: line_load
        procedure :: pressure
        procedure :: displacement
        procedure :: displacement_of_body
        procedure :: energies
    end type cohesive_load_t

contains

    !> The load of a state: cohesion and profile must outlive it.
    subroutine new_cohesive_load(self, cohesion, profile, medium, state, error)
        type(cohesive_load_t), intent(out), target :: self
        type(cohesion_t), intent(in), target :: cohesion
        class(profile_t), intent(in), target :: profile
        class(solver_t), intent(in) :: medium
        type(contact_state_t), intent(in) :: state
        type(error_t), allocatable, intent(inout) :: error

        self%cohesion => cohesion
        self%profile => profile
        self%radius = state%radius
        self%punch_depth = state%punch_depth
        self%depth = state%depth
        self%zone_radius = state%zone_radius
        self%share_of_upper = medium%share_of_upper
        self%is_shared = .not. medium%is_pair .or. medium%has_free_springs
        call cohesion%load(profile, state, self%springs, self%zone, error)
    end subroutine new_cohesive_load

    !> q(x), 0 <= x <= c [modulus length].
    subroutine line_load(self, r, values, error)
        class(cohesive_load_t), intent(in) :: self
        real(wp), intent(in) :: r(:)
        real(wp), intent(out) :: values(:)
        type(error_t), allocatable, intent(out) :: error
        integer :: i

        if (allocated(error)) continue
        if (self%radius > 0.0_wp) call self%zone%contact%at(self%profile, min(r, self%radius), values)
        do i = 1, size(r)
            if (r(i) < self%radius) then
                values(i) = self%cohesion%modulus*values(i)
            else
                values(i) = -2.0_wp*self%cohesion%stress &
                            *sqrt(max(self%zone_radius - r(i), 0.0_wp)*(self%zone_radius + r(i)))
            end if
        end do
    end subroutine line_load

    !> p(r), 0 <= r <= c [modulus].
    subroutine pressure(self, r, values, error)
        class(cohesive_load_t), intent(in) :: self
        real(wp), intent(in) :: r(:)
        real(wp), intent(out) :: values(:)
        type(error_t), allocatable, intent(out) :: error
        type(homogeneous_t), target :: surface
        type(effective_load_t) :: bare
        real(wp), allocatable :: inside(:), pressure_inside(:)
        integer, allocatable :: places(:)
        integer :: i

        values = -self%cohesion%stress
        call pick(r, places, inside, pressure_inside, error, below=self%radius)
        if (allocated(error)) return
        if (size(places) == 0) return
        call new_homogeneous_from_modulus(surface, self%cohesion%modulus, error)
        if (allocated(error)) return
        call bare%begin(surface, self%profile, self%radius, 0.0_wp)
        call bare%pressure(inside, pressure_inside, error)
        if (allocated(error)) return
        associate (a => self%radius, c => self%zone_radius, stress => self%cohesion%stress)
            do i = 1, size(places)
                values(places(i)) = pressure_inside(i) - 2.0_wp*stress/pi &
                                    *atan2(sqrt((c - a)*(c + a)), sqrt((a - inside(i))*(a + inside(i))))
                if (.not. self%cohesion%kernel%vanishes) then
                    values(places(i)) = values(places(i)) + self%cohesion%modulus*self%zone%contact%smooth_pressure(inside(i))
                end if
            end do
        end associate
    end subroutine pressure

    !> u(r), r > a [length].
    subroutine displacement(self, r, values, error)
        class(cohesive_load_t), intent(in) :: self
        real(wp), intent(in) :: r(:)
        real(wp), intent(out) :: values(:)
        type(error_t), allocatable, intent(out) :: error
        type(homogeneous_t), target :: surface
        type(effective_load_t) :: bare
        real(wp), allocatable :: added(:)
        integer :: i, stat

        values = 0.0_wp
        allocate (added(size(r)), stat=stat)
        call check_memory(error, stat)
        if (allocated(error)) return
        if (self%radius > 0.0_wp) then
            call new_homogeneous_from_modulus(surface, self%cohesion%modulus, error)
            if (allocated(error)) return
            call bare%begin(surface, self%profile, self%radius, self%depth - self%profile%mdr(self%radius))
            call bare%displacement(r, values, error)
            if (allocated(error)) return
            if (.not. self%cohesion%kernel%vanishes) then
                call self%zone%contact%displacement_beyond(self%cohesion%kernel, r, added, error)
                if (allocated(error)) return
                values = values + added
            end if
        end if
        do i = 1, size(r)
            values(i) = values(i) - 2.0_wp*self%cohesion%stress/self%cohesion%modulus*(2.0_wp/pi) &
                        *of_springs(self%radius, self%zone_radius, r(i)) + self%springs%beyond(self%zone, r(i), error)
            if (allocated(error)) return
        end do
    end subroutine displacement

    subroutine displacement_of_body(self, body, r, values, error)
        class(cohesive_load_t), intent(in) :: self
        integer, intent(in) :: body
        real(wp), intent(in) :: r(:)
        real(wp), intent(inout) :: values(:)
        type(error_t), allocatable, intent(out) :: error

        associate (unused => r)
        end associate
        call check_share(self, error)
        values = merge(self%share_of_upper, 1.0_wp - self%share_of_upper, body == upper_body)*values
    end subroutine displacement_of_body

    !> int q w dx over the whole load, of which either body takes its part [modulus length^3].
    subroutine energies(self, values, error)
        class(cohesive_load_t), intent(in) :: self
        real(wp), allocatable, intent(out) :: values(:)
        type(error_t), allocatable, intent(out) :: error
        real(wp) :: energy

        call check_share(self, error)
        if (allocated(error)) return
        energy = self%zone%work
        if (self%radius > 0.0_wp) energy = energy + self%zone%contact%work_on(self%profile, self%zone%contact%v, error)
        values = self%cohesion%modulus*energy*[1.0_wp - self%share_of_upper, self%share_of_upper]
    end subroutine energies

    !> Raises where a zone loads two bodies that do not share its displacement by a factor.
    pure subroutine check_share(self, error)
        class(cohesive_load_t), intent(in) :: self
        type(error_t), allocatable, intent(inout) :: error

        if (.not. self%is_shared) call raise(error, error_invalid, "field: with a cohesive zone the displacement of each of "// &
                                             "two bodies is available for homogeneous bodies only. Use that of both together")
    end subroutine check_share

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

end module mdrcontact_contact_cohesive_load
