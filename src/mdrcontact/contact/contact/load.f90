! SPDX-License-Identifier: GPL-3.0-or-later
!> The load of a state of contact: its fields on the surface, line load, pressure and displacement, and the elastic energy of the
!> bodies.
module mdrcontact_contact_load
    use mdrcontact_contact_equilibrium, only: equilibrium_t
    use mdrcontact_contact_state, only: contact_state_t
    use mdrcontact_error, only: check_finite, check_made, check_not_negative, error_domain, error_invalid, error_t, raise, to_text
    use mdrcontact_kinds, only: pi, wp
    use mdrcontact_contact_cohesive_load, only: cohesive_load_t, new_cohesive_load
    use mdrcontact_medium_load, only: load_t
    use mdrcontact_medium_solver, only: refuse
    use mdrcontact_numerics_pick, only: pick
    implicit none (type, external)
    private
    public :: contact_load_t, new_contact_load, check_positions, check_state

    !> The axis of a zone without contact, where the displacement is a limit [c].
    real(wp), parameter :: smallest_ratio = 1.0e-9_wp
    !> Where the lowest pressure is searched for: so many radii, and again as many between the neighbours of the lowest.
    integer, parameter :: pressure_probes = 32, pressure_rounds = 3
    !> A pressure that is at least this part of the largest one is not negative by rounding.
    real(wp), parameter :: rounding = 1.0e-9_wp
    !> A negative pressure of this part of the mean pressure is more than the solver's error.
    real(wp), parameter :: noticeable = 1.0e-4_wp

    !> The load of a state. It is solved when it is made, never changes, and any number of threads may share it. It refers to its
    !> contact, which must outlive it.
    type :: contact_load_t
        !> whether it was made: set last by what makes it
        logical :: is_made = .false.
        !> of the contact
        type(equilibrium_t), pointer :: equilibrium => null()
        !> whose load it is
        type(contact_state_t) :: state
        !> what the surface supports
        class(load_t), allocatable :: surface
    contains
        procedure :: line_load
        procedure :: projection
        procedure :: pressure
        procedure :: displacement
        procedure :: energy
        procedure :: lowest_pressure
        procedure :: check_one_disc
    end type contact_load_t

contains

    !> Solves the load of a state.
    subroutine new_contact_load(self, equilibrium, state, error)
        type(contact_load_t), intent(out) :: self
        !> of the contact; it must outlive the load
        type(equilibrium_t), intent(in), target :: equilibrium
        !> one of its states, with a contact
        type(contact_state_t), intent(in) :: state
        type(error_t), allocatable, intent(out) :: error
        type(cohesive_load_t), allocatable :: cohesive

        call check_state(equilibrium, state, error)
        if (allocated(error)) return
        self%equilibrium => equilibrium
        self%state = state
        if (allocated(equilibrium%cohesion)) then
            allocate (cohesive)
            call new_cohesive_load(cohesive, equilibrium%cohesion, equilibrium%profile, equilibrium%medium, state, error)
            call move_alloc(cohesive, self%surface)
        else
            call equilibrium%medium%load(equilibrium%profile, state%radius, state%punch_depth, self%surface, error)
        end if
        self%is_made = .not. allocated(error)
    end subroutine new_contact_load

    !> q(x), the line load of the one-dimensional springs, equation (5) or (21) [modulus length].
    subroutine line_load(self, x, values, error)
        class(contact_load_t), intent(in) :: self
        !> positions 0 <= x <= a, or to the end c of a cohesive zone [length]
        real(wp), intent(in) :: x(:)
        !> same size as x
        real(wp), intent(out) :: values(:)
        type(error_t), allocatable, intent(out) :: error

        if (.not. self%is_made) call check_made(error, "load", self%is_made)
        if (allocated(error)) return
        call check_positions(error, "x", x, max(self%state%radius, self%state%zone_radius))
        if (.not. allocated(error)) call self%surface%line_load(x, values, error)
    end subroutine line_load

    !> int p dy along a line at the distance x from the axis [modulus length]: the line load of everything that is proportional to
    !> the pressure, as the heat of friction. It is q(x) except on bodies graded by a power.
    subroutine projection(self, x, values, error)
        class(contact_load_t), intent(in) :: self
        !> positions 0 <= x <= a [length]
        real(wp), intent(in) :: x(:)
        !> same size as x
        real(wp), intent(out) :: values(:)
        type(error_t), allocatable, intent(out) :: error

        if (.not. self%is_made) call check_made(error, "load", self%is_made)
        if (allocated(error)) return
        call check_positions(error, "x", x, self%state%radius)
        if (.not. allocated(error)) call self%surface%projection(x, values, error)
    end subroutine projection

    !> p(r), the contact pressure, equation (6) [modulus]. Infinite at the edge of a flat punch, at the apex of a cone; minus
    !> infinity at an adhesive edge in the JKR limit.
    subroutine pressure(self, r, values, error)
        class(contact_load_t), intent(in) :: self
        !> positions 0 <= r <= a, or to the end c of a cohesive zone, where it is -sigma_0 [length]
        real(wp), intent(in) :: r(:)
        !> same size as r
        real(wp), intent(out) :: values(:)
        type(error_t), allocatable, intent(out) :: error

        if (.not. self%is_made) call check_made(error, "load", self%is_made)
        if (allocated(error)) return
        call check_positions(error, "r", r, max(self%state%radius, self%state%zone_radius))
        if (.not. allocated(error)) call self%surface%pressure(r, values, error)
    end subroutine pressure

    !> u(r), the displacement of the surface, positive into the medium [length]: d - f(r) inside the contact, the free surface
    !> outside. Of two deformable bodies that of both surfaces together, each positive into its body, or of one of them.
    subroutine displacement(self, r, values, error, body)
        class(contact_load_t), intent(in) :: self
        !> positions r >= 0 [length]
        real(wp), intent(in) :: r(:)
        !> same size as r
        real(wp), intent(out) :: values(:)
        type(error_t), allocatable, intent(out) :: error
        !> lower_body or upper_body; without it both together
        integer, intent(in), optional :: body
        real(wp), allocatable :: outside(:), found(:)
        integer, allocatable :: places(:)
        integer :: i

        if (.not. self%is_made) call check_made(error, "load", self%is_made)
        if (allocated(error)) return
        call check_positions(error, "r", r)
        call pick(r, places, outside, found, error, above=self%state%radius)
        if (allocated(error)) return
        ! attracted without contact: the axisalso, lies outside
        if (.not. self%state%radius > 0.0_wp) then
            outside = max(r, smallest_ratio*self%state%zone_radius)
            found = outside
            places = [(i, i=1, size(r))]
        end if
        call self%surface%displacement(outside, found, error)
        if (allocated(error)) return
        do i = 1, size(r)
            if (r(i) <= self%state%radius) values(i) = self%state%depth - self%equilibrium%profile%height(r(i))
        end do
        do i = 1, size(places)
            values(places(i)) = found(i)
        end do
        if (present(body)) call self%surface%displacement_of_body(body, r, values, error)
    end subroutine displacement

    !> Elastic energy of the lower and of the upper body; without adhesion together int F dd from initial contact.
    subroutine energy(self, values, error)
        class(contact_load_t), intent(in) :: self
        !> of the lower and of the upper body [modulus length^3]
        real(wp), intent(out) :: values(2)
        type(error_t), allocatable, intent(out) :: error
        real(wp), allocatable :: found(:)

        values = 0.0_wp
        if (.not. self%is_made) call check_made(error, "load", self%is_made)
        if (allocated(error)) return
        call self%surface%energies(found, error)
        if (allocated(found)) values = found
        if (allocated(found) .or. allocated(error)) return
        call refuse(self%equilibrium%medium, "the elastic energy of a body is", "a homogeneous body, the model exact, or an "// &
                    "effective modulus", "the surface contains part of it. int F dd is the sum of both", error)
    end subroutine energy

    !> The lowest pressure in a contact without adhesion. Below 0 the bodies would have to attract each other: the contact is then
    !> not a single contact area, its pressure is not that of the true contact, and F(d) is a little off (theory/exact.md (1.4)). On
    !> stiff coatings only.
    subroutine lowest_pressure(self, pressure, radius, error)
        class(contact_load_t), intent(in) :: self
        !> the smallest p(r), 0 <= r <= a, and the r that has it: 0 at the edge where no pressure is negative [modulus], [length]
        real(wp), intent(out) :: pressure, radius
        type(error_t), allocatable, intent(out) :: error
        real(wp) :: from, to, r(pressure_probes), values(pressure_probes)
        integer :: round, i

        pressure = 0.0_wp
        if (.not. self%is_made) call check_made(error, "load", self%is_made)
        if (allocated(error)) return
        radius = self%state%radius
        if (self%equilibrium%work_of_adhesion > 0.0_wp) then
            call raise(error, error_invalid, "lowest_pressure: it is defined without adhesion only, because the edge of an "// &
                       "adhesive contact is under tension")
            return
        end if
        from = 0.0_wp
        to = self%state%radius
        do round = 1, pressure_rounds
            ! The edge is left out: p is 0 or infinite there.
            r = [(from + (to - from)*(i - 1)/pressure_probes, i=1, pressure_probes)]
            if (round == 1) then
                call self%surface%least_pressure(r, values)
                if (minval(values) > rounding*maxval(values)) return
            end if
            call self%pressure(r, values, error)
            if (allocated(error)) return
            i = minloc(values, dim=1)
            if (.not. values(i) < pressure) return
            pressure = values(i)
            radius = r(i)
            from = r(max(i - 1, 1))
            to = min(r(i) + (r(2) - r(1)), self%state%radius)
        end do
    end subroutine lowest_pressure

    !> Raises where an exact pressure without adhesion would be negative.
    subroutine check_one_disc(self, what, error)
        class(contact_load_t), intent(in) :: self
        !> that needs a pressure
        character(len=*), intent(in) :: what
        type(error_t), allocatable, intent(out) :: error
        real(wp) :: pressure, radius

        if (.not. self%is_made) call check_made(error, "load", self%is_made)
        if (allocated(error)) return
        if (.not. self%equilibrium%medium%is_exact .or. self%equilibrium%profile%is_spherical()) return
        call self%lowest_pressure(pressure, radius, error)
        if (allocated(error)) return
        if (.not. pressure*self%state%radius**2 < -noticeable*self%state%force/pi) return
        call raise(error, error_domain, "this contact is not a single area: without adhesion its pressure would be "// &
                   to_text(pressure)//" at r = "//to_text(radius)//" (contact radius "//to_text(self%state%radius)//"). "//what// &
                   " needs a pressure that is nowhere negative")
    end subroutine check_one_disc

    !> Raises unless a state can be one of this contact.
    pure subroutine check_state(equilibrium, state, error)
        type(equilibrium_t), intent(in) :: equilibrium
        type(contact_state_t), intent(in) :: state
        type(error_t), allocatable, intent(out) :: error

        if (allocated(equilibrium%cohesion)) then
            call check_not_negative(error, "contact radius of the state", state%radius)
            if (.not. state%zone_radius > state%radius .and. .not. allocated(error)) then
                call raise(error, error_invalid, "the zone_radius of the state must be greater than its contact radius: this "// &
                           "contact has a cohesive zone")
            end if
        else if (.not. state%radius > 0.0_wp) then
            call raise(error, error_invalid, "the contact radius of the state must be greater than 0: there is no contact")
        end if
        if (allocated(error)) return
        if (max(state%radius, state%zone_radius) > equilibrium%last_radius) then
            call raise(error, error_invalid, "the contact radius of the state, "//to_text(state%radius)//", is not one of this "// &
                       "contact: indenter and medium are defined up to "//to_text(equilibrium%last_radius))
        end if
        call check_finite(error, "depth of the state", state%depth)
        call check_finite(error, "punch_depth of the state", state%punch_depth)
    end subroutine check_state

    !> Raises unless no position is negative or, where a contact radius is given, outside.
    pure subroutine check_positions(error, name, positions, radius)
        type(error_t), allocatable, intent(inout) :: error
        character(len=*), intent(in) :: name
        real(wp), intent(in) :: positions(:)
        real(wp), intent(in), optional :: radius
        integer :: i

        do i = 1, size(positions)
            if (allocated(error)) return
            call check_not_negative(error, name, positions(i), i)
            if (.not. present(radius)) cycle
            if (positions(i) > radius) call raise(error, error_domain, " = "//to_text(positions(i))// &
                                                  ": it must be at most the contact radius, "//to_text(radius), name, i)
        end do
    end subroutine check_positions

end module mdrcontact_contact_load
