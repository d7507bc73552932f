! SPDX-License-Identifier: GPL-3.0-or-later
!> The fields of a state of contact on the surface: line load, pressure, displacement; and the elastic energy of the bodies.
module mdrcontact_contact_fields
    use mdrcontact_contact_equilibrium, only: equilibrium_t
    use mdrcontact_contact_state, only: contact_state_t
    use mdrcontact_error, only: check_finite, check_not_negative, error_domain, error_invalid, error_t, raise, to_text
    use mdrcontact_kinds, only: pi, wp
    use mdrcontact_contact_zone_fields, only: zone_displacement, zone_energy, zone_line_load, zone_pressure
    use mdrcontact_medium_solver, only: of_displacement, of_line_load, of_pressure, refuse
    use mdrcontact_numerics_pick, only: pick
    implicit none (type, external)
    private
    public :: fields_t, check_positions, check_state

    !> The axis of a zone without contact, where the displacement is a limit [c].
    real(wp), parameter :: smallest_ratio = 1.0e-9_wp
    !> Where the lowest pressure is looked for: so many radii, and again as many between the neighbours of the lowest.
    integer, parameter :: pressure_probes = 32, pressure_rounds = 3
    !> A negative pressure of this part of the mean pressure is more than the solver's error.
    real(wp), parameter :: noticeable = 1.0e-4_wp

    !> What gives the fields of its states; a contact is one.
    type :: fields_t
        !> what determines a state once the radius is known; to be read only
        type(equilibrium_t) :: equilibrium
    contains
        procedure :: line_load
        procedure :: pressure
        procedure :: displacement
        procedure :: energy
        procedure :: lowest_pressure
        procedure :: check_one_disc
    end type fields_t

contains

    !> q(x), the line load of the one-dimensional springs, equation (5) or (21) [modulus length].
    subroutine line_load(self, state, x, values, error)
        class(fields_t), intent(in) :: self
        type(contact_state_t), intent(in) :: state
        !> positions 0 <= x <= a, or to the end c of a cohesive zone [length]
        real(wp), intent(in) :: x(:)
        !> same size as x
        real(wp), intent(out) :: values(:)
        type(error_t), allocatable, intent(out) :: error

        call check_state(self, state, error)
        call check_positions(error, "x", x, max(state%radius, state%zone_radius))
        if (allocated(error)) return
        if (allocated(self%equilibrium%cohesion)) then
            call zone_line_load(self%equilibrium%cohesion, self%equilibrium%profile, state, x, values, error)
            return
        end if
        call self%equilibrium%medium%field(of_line_load, self%equilibrium%profile, state%radius, state%punch_depth, x, values, &
                                           error)
    end subroutine line_load

    !> p(r), the contact pressure, equation (6) [modulus]. Infinite where theory says so: at the edge of a flat punch, at the
    !> apex of a cone; minus infinity at an adhesive edge without a range.
    subroutine pressure(self, state, r, values, error)
        class(fields_t), intent(in) :: self
        type(contact_state_t), intent(in) :: state
        !> positions 0 <= r <= a, or to the end c of a cohesive zone, where it is -sigma [length]
        real(wp), intent(in) :: r(:)
        !> same size as r
        real(wp), intent(out) :: values(:)
        type(error_t), allocatable, intent(out) :: error

        call check_state(self, state, error)
        call check_positions(error, "r", r, max(state%radius, state%zone_radius))
        if (allocated(error)) return
        if (allocated(self%equilibrium%cohesion)) then
            call zone_pressure(self%equilibrium%cohesion, self%equilibrium%profile, state, r, values, error)
            return
        end if
        call self%equilibrium%medium%field(of_pressure, self%equilibrium%profile, state%radius, state%punch_depth, r, values, error)
    end subroutine pressure

    !> u(r), the displacement of the surface, positive into the medium [length]: d - f(r) inside the contact, the free surface
    !> outside. Of two deformable bodies that of both surfaces together, each positive into its body, or of one of them.
    subroutine displacement(self, state, r, values, error, body)
        class(fields_t), intent(in) :: self
        type(contact_state_t), intent(in) :: state
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

        call check_state(self, state, error)
        call check_positions(error, "r", r)
        call pick(r, places, outside, found, error, above=state%radius)
        if (allocated(error)) return
        if (allocated(self%equilibrium%cohesion)) then
            ! without contact the axis, too, lies outside
            if (.not. state%radius > 0.0_wp) then
                outside = max(r, smallest_ratio*state%zone_radius)
                found = outside
                places = [(i, i=1, size(r))]
            end if
            call zone_displacement(self%equilibrium%cohesion, self%equilibrium%profile, state, outside, found, error)
            if (present(body)) call check_share(self, error)
        else
            call self%equilibrium%medium%field(of_displacement, self%equilibrium%profile, state%radius, state%punch_depth, &
                                               outside, found, error)
        end if
        if (allocated(error)) return
        do i = 1, size(r)
            if (r(i) <= state%radius) values(i) = state%depth - self%equilibrium%profile%height(r(i))
        end do
        do i = 1, size(places)
            values(places(i)) = found(i)
        end do
        if (.not. present(body)) return
        call self%equilibrium%medium%take_share(self%equilibrium%profile, state%radius, state%punch_depth, body, r, values, error)
    end subroutine displacement

    !> Elastic energy of the lower and of the upper body; without adhesion together int F dd from first touch.
    subroutine energy(self, state, values, error)
        class(fields_t), intent(in) :: self
        type(contact_state_t), intent(in) :: state
        !> of the lower and of the upper body [modulus length^3]
        real(wp), intent(out) :: values(2)
        type(error_t), allocatable, intent(out) :: error
        real(wp), allocatable :: found(:)

        values = 0.0_wp
        call check_state(self, state, error)
        if (allocated(error)) return
        if (allocated(self%equilibrium%cohesion)) then
            call check_share(self, error)
            if (allocated(error)) return
            call zone_energy(self%equilibrium%cohesion, self%equilibrium%profile, state, values(1), error)
            values = values(1)*[1.0_wp - self%equilibrium%medium%share_of_upper, self%equilibrium%medium%share_of_upper]
            return
        end if
        associate (medium => self%equilibrium%medium)
            call medium%energies(self%equilibrium%profile, state%radius, state%punch_depth, found, error)
            if (allocated(found)) values = found
            if (allocated(found) .or. allocated(error)) return
            call refuse(medium, "the elastic energy of a body is", "one that is homogeneous or solved exactly, or an effective "// &
                        "modulus", "the surface holds a part of it; int F dd is that of both", error)
        end associate
    end subroutine energy

    !> The lowest pressure in a contact without adhesion. Below 0 the bodies would have to pull on each other: the contact is then
    !> not one disc, its pressure is not that of the true contact, and F(d) is a little off (theory/exact.md (1.4)). On stiff
    !> coatings only.
    subroutine lowest_pressure(self, state, pressure, radius, error)
        class(fields_t), intent(in) :: self
        !> a state of this contact, a > 0, without adhesion
        type(contact_state_t), intent(in) :: state
        !> the smallest p(r), 0 <= r <= a, and the r that has it: 0 at the edge where no pressure is negative [modulus], [length]
        real(wp), intent(out) :: pressure, radius
        type(error_t), allocatable, intent(out) :: error
        real(wp) :: from, to, r(pressure_probes), values(pressure_probes)
        integer :: round, i

        pressure = 0.0_wp
        radius = state%radius
        if (self%equilibrium%work_of_adhesion > 0.0_wp) then
            call raise(error, error_invalid, "lowest_pressure is not allowed: under adhesion the bodies pull on "// &
                       "each other at the edge")
            return
        end if
        from = 0.0_wp
        to = state%radius
        do round = 1, pressure_rounds
            ! The edge is left out: p is 0 or infinite there.
            r = [(from + (to - from)*(i - 1)/pressure_probes, i=1, pressure_probes)]
            call self%pressure(state, r, values, error)
            if (allocated(error)) return
            i = minloc(values, dim=1)
            if (.not. values(i) < pressure) return
            pressure = values(i)
            radius = r(i)
            from = r(max(i - 1, 1))
            to = min(r(i) + (r(2) - r(1)), state%radius)
        end do
    end subroutine lowest_pressure

    !> Raises where an exact pressure would be negative.
    subroutine check_one_disc(self, state, what, error)
        class(fields_t), intent(in) :: self
        !> a state of this contact, a > 0, without adhesion
        type(contact_state_t), intent(in) :: state
        !> that needs a pressure
        character(len=*), intent(in) :: what
        type(error_t), allocatable, intent(out) :: error
        real(wp) :: pressure, radius

        if (.not. self%equilibrium%medium%is_exact .or. self%equilibrium%profile%is_spherical()) return
        call self%lowest_pressure(state, pressure, radius, error)
        if (allocated(error)) return
        if (.not. pressure*state%radius**2 < -noticeable*state%force/pi) return
        call raise(error, error_domain, "this contact is not one disc: without adhesion its pressure would be "// &
                   to_text(pressure)//" at r = "//to_text(radius)//" (contact radius "//to_text(state%radius)// &
                   "); "//what//" needs a pressure that is nowhere negative")
    end subroutine check_one_disc

    !> Raises unless a state can be one of this contact.
    pure subroutine check_state(self, state, error)
        class(fields_t), intent(in) :: self
        type(contact_state_t), intent(in) :: state
        type(error_t), allocatable, intent(out) :: error

        if (allocated(self%equilibrium%cohesion)) then
            call check_not_negative(error, "contact radius of the state", state%radius)
            if (.not. state%zone_radius > state%radius .and. .not. allocated(error)) then
                call raise(error, error_invalid, "the zone_radius of the state must be greater than its contact radius: this "// &
                           "contact has a cohesive zone")
            end if
        else if (.not. state%radius > 0.0_wp) then
            call raise(error, error_invalid, "the contact radius of the state must be greater than 0: there is no contact")
        end if
        if (allocated(error)) return
        if (max(state%radius, state%zone_radius) > self%equilibrium%last_radius) then
            call raise(error, error_invalid, "the contact radius of the state, "//to_text(state%radius)//", is not one of this "// &
                       "contact: indenter and medium are defined up to "//to_text(self%equilibrium%last_radius))
        end if
        call check_finite(error, "depth of the state", state%depth)
        call check_finite(error, "punch_depth of the state", state%punch_depth)
    end subroutine check_state

    !> Raises where a zone loads two bodies that do not share its displacement by a factor.
    pure subroutine check_share(self, error)
        class(fields_t), intent(in) :: self
        type(error_t), allocatable, intent(inout) :: error

        associate (medium => self%equilibrium%medium)
            if (.not. medium%is_pair .or. medium%has_free_springs .or. allocated(error)) return
        end associate
        call raise(error, error_invalid, "what each of two bodies takes of a cohesive zone is known for homogeneous ones only: "// &
                   "leave out the body, for both together")
    end subroutine check_share

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
            if (positions(i) > radius) call raise(error, error_domain, " = "//to_text(positions(i))//" is not allowed: it must "// &
                                                  "be at most the contact radius, "//to_text(radius), name, i)
        end do
    end subroutine check_positions

end module mdrcontact_contact_fields
