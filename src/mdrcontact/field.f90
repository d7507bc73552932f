! SPDX-License-Identifier: GPL-3.0-or-later
!> The fields of a state of contact: line load, pressure, displacement, and stresses and energies inside the bodies.
module mdrcontact_field
    use mdrcontact_base_nonfinite, only: infinity, is_finite
    use mdrcontact_body, only: body_t
    use mdrcontact_body_layers, only: layers_t
    use mdrcontact_contact_equilibrium, only: equilibrium_t
    use mdrcontact_contact_state, only: contact_state_t
    use mdrcontact_error, only: check_finite, check_not_negative, error_domain, error_invalid, error_t, raise, to_text
    use mdrcontact_field_body_field, only: body_field
    use mdrcontact_field_energy, only: layer_energies
    use mdrcontact_field_interior, only: components, s_zz, u_z
    use mdrcontact_field_load, only: load_t
    use mdrcontact_kinds, only: pi, wp
    use mdrcontact_medium, only: lower_body, upper_body
    use mdrcontact_numerics_pick, only: pick
    implicit none (type, external)
    private
    public :: fields_t, check_positions, check_state

    !> Where the lowest pressure is looked for: so many radii, and again as many between the neighbours of the lowest.
    integer, parameter :: pressure_probes = 32, pressure_rounds = 3
    !> Where the field inside a body is compared with the surface [a]: off the axis and the edge, where pressures may be infinite.
    real(wp), parameter :: compared(3) = [0.31_wp, 0.62_wp, 0.9_wp]

    !> What gives the fields of its states; a contact is one.
    type :: fields_t
        !> what determines a state once the radius is known; to be read only
        type(equilibrium_t) :: equilibrium
    contains
        procedure :: line_load
        procedure :: pressure
        procedure :: displacement
        procedure :: elastic_energy
        procedure :: lowest_pressure
        procedure :: interior
        procedure :: interior_error
        procedure :: layer_energy
    end type fields_t

contains

    !> q(x), the line load of the one-dimensional springs, equation (5) or (21) [modulus length].
    subroutine line_load(self, state, x, values, error)
        class(fields_t), intent(in) :: self
        type(contact_state_t), intent(in) :: state
        !> positions 0 <= x <= a [length]
        real(wp), intent(in) :: x(:)
        !> same size as x
        real(wp), intent(out) :: values(:)
        type(error_t), allocatable, intent(out) :: error

        call check_state(self, state, error)
        call check_positions(error, "x", x, state%radius)
        if (allocated(error)) return
        call self%equilibrium%medium%line_load(self%equilibrium%profile, state%radius, state%excess, x, values, error)
    end subroutine line_load

    !> p(r), the contact pressure, equation (6) [modulus]. Infinite where theory says so: at the edge of a flat punch, at the
    !> apex of a cone; minus infinity at an adhesive edge.
    subroutine pressure(self, state, r, values, error)
        class(fields_t), intent(in) :: self
        type(contact_state_t), intent(in) :: state
        !> positions 0 <= r <= a [length]
        real(wp), intent(in) :: r(:)
        !> same size as r
        real(wp), intent(out) :: values(:)
        type(error_t), allocatable, intent(out) :: error

        call check_state(self, state, error)
        call check_positions(error, "r", r, state%radius)
        if (allocated(error)) return
        call self%equilibrium%medium%pressure(self%equilibrium%profile, state%radius, state%excess, r, values, error)
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
        call self%equilibrium%medium%displacement_outside(self%equilibrium%profile, state%radius, state%excess, &
                                                          outside, found, error)
        if (allocated(error)) return
        do i = 1, size(r)
            if (r(i) <= state%radius) values(i) = state%depth - self%equilibrium%profile%height(r(i))
        end do
        do i = 1, size(places)
            values(places(i)) = found(i)
        end do
        if (.not. present(body)) return
        call self%equilibrium%medium%take_share(self%equilibrium%profile, state%radius, state%excess, body, r, values, error)
    end subroutine displacement

    !> Elastic energy of the lower and of the upper body; without adhesion together int F dd from first touch.
    subroutine elastic_energy(self, state, values, error)
        class(fields_t), intent(in) :: self
        type(contact_state_t), intent(in) :: state
        !> of the lower and of the upper body [modulus length^3]
        real(wp), intent(out) :: values(2)
        type(error_t), allocatable, intent(out) :: error

        values = 0.0_wp
        call check_state(self, state, error)
        if (allocated(error)) return
        call self%equilibrium%medium%energies(self%equilibrium%profile, state%radius, state%excess, values, error)
    end subroutine elastic_energy

    !> The lowest pressure in a contact without adhesion. Below 0 the bodies would have to pull on each other: the contact is then
    !> not one disc, its pressure is not that of the true contact, and F(d) is a little off (theory 6). On stiff coatings only.
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
            call raise(error, error_invalid, "lowest_pressure is not allowed: under adhesion the pressure is "// &
                       "minus infinity at the edge")
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

    !> Displacements and stresses inside a body under the state's pressure, and under its friction where the contact slides.
    subroutine interior(self, state, upper, r, z, below, friction, angle, field, error, threads)
        class(fields_t), intent(in) :: self
        !> with a radius > 0
        type(contact_state_t), intent(in) :: state
        !> whether the upper body is meant, not the lower one; z points into the body that is meant
        logical, intent(in) :: upper
        !> points r >= 0, z >= 0 [length]
        real(wp), intent(in) :: r(:), z(:)
        !> at an interface the side of the larger z is meant
        logical, intent(in) :: below
        !> f >= 0: traction f p(r) in +x on the lower body, -f p(r) on the upper one; not with adhesion
        real(wp), intent(in) :: friction
        !> azimuths of the points from +x, same size as r [radian]
        real(wp), intent(in) :: angle(:)
        !> (size(r), components): u_r, u_t, u_z [length], s_rr, s_tt, s_zz, s_rz, s_rt, s_tz [modulus]
        real(wp), intent(out) :: field(:, :)
        type(error_t), allocatable, intent(out) :: error
        !> how many threads may share the work, 0: as many as OpenMP offers
        integer, intent(in) :: threads
        class(load_t), allocatable :: load
        integer :: i

        call check_not_negative(error, "friction", friction)
        do i = 1, size(angle)
            call check_finite(error, "angle", angle(i), i)
        end do
        if (allocated(error)) return
        call load_of(self, state, upper, load, error)
        if (allocated(error)) return
        if (friction > 0.0_wp .and. load%edge < 0.0_wp) then
            call raise(error, error_invalid, " = "//to_text(friction)//" is not allowed with adhesion: Coulomb's "// &
                       "law knows no tension, use friction = 0", "friction")
            return
        end if
        associate (medium => self%equilibrium%medium)
            if (upper) then
                call body_field(load, medium%counterbody, r, z, below, field, error, -friction, angle, threads)
            else
                call body_field(load, medium%pressed, r, z, below, field, error, friction, angle, threads)
            end if
        end associate
    end subroutine interior

    !> How far the field inside a body is from what the state has on the surface: at some radii within the contact s_zz from -p(r),
    !> relative to the largest pressure there and the mean one, and u_z from d - f(r), of two bodies from the body's part of it,
    !> relative to d and to f(a). Under an approximate model s_zz alone, for its surface does not fit the indenter.
    subroutine interior_error(self, state, upper, deviation, error)
        class(fields_t), intent(in) :: self
        !> with a radius > 0
        type(contact_state_t), intent(in) :: state
        !> whether the upper body is meant
        logical, intent(in) :: upper
        !> the largest of them [1]
        real(wp), intent(out) :: deviation
        type(error_t), allocatable, intent(out) :: error
        real(wp), dimension(size(compared)) :: r, pressure, motion
        real(wp) :: field(size(compared), components)
        logical :: inside(size(compared))

        deviation = 0.0_wp
        r = compared*state%radius
        call self%interior(state, upper, r, 0.0_wp*r, .true., 0.0_wp, 0.0_wp*r, field, error, 1)
        if (.not. allocated(error)) call self%pressure(state, r, pressure, error)
        if (allocated(error)) return
        inside = is_finite(pressure) .and. is_finite(field(:, s_zz))
        if (.not. any(inside)) return
        deviation = maxval(abs(field(:, s_zz) + pressure), mask=inside) &
                    /max(abs(state%force)/(pi*state%radius**2), maxval(abs(pressure), mask=inside))
        associate (equilibrium => self%equilibrium, medium => self%equilibrium%medium)
            ! the springs of a homogeneous body are exact, though its modulus is an effective one
            if (.not. (medium%is_exact .or. medium%has_free_springs)) return
            motion = state%depth - equilibrium%profile%height(r)
            if (medium%is_pair) call medium%take_share(equilibrium%profile, state%radius, state%excess, &
                                                       merge(upper_body, lower_body, upper), r, motion, error)
            if (allocated(error)) return
            deviation = max(deviation, maxval(abs(field(:, u_z) - motion)) &
                            /max(abs(state%depth), equilibrium%profile%height(state%radius)))
        end associate
    end subroutine interior_error

    !> Elastic energy of each layer of a body, from the surface down, the half-space last [modulus length^3].
    subroutine layer_energy(self, state, upper, energies, error)
        class(fields_t), intent(in) :: self
        !> with a radius > 0
        type(contact_state_t), intent(in) :: state
        !> whether the upper body is meant
        logical, intent(in) :: upper
        !> one of each layer, and that of the half-space if there is one [modulus length^3]
        real(wp), allocatable, intent(out) :: energies(:)
        type(error_t), allocatable, intent(out) :: error
        class(load_t), allocatable :: load
        class(body_t), allocatable :: body
        type(layers_t) :: layers

        call load_of(self, state, upper, load, error)
        if (allocated(error)) return
        if (upper) then
            call self%equilibrium%medium%counterbody%copy_to(body, error)
        else
            call self%equilibrium%medium%pressed%copy_to(body, error)
        end if
        if (allocated(error)) return
        call body%sublayers(layers, error)
        if (allocated(error)) return
        allocate (energies, source=layer_energies(load, layers, error))
    end subroutine layer_energy

    !> The load of a state on a body that is there.
    subroutine load_of(self, state, upper, load, error)
        class(fields_t), intent(in) :: self
        type(contact_state_t), intent(in) :: state
        logical, intent(in) :: upper
        class(load_t), allocatable, intent(inout) :: load
        type(error_t), allocatable, intent(out) :: error

        associate (equilibrium => self%equilibrium)
            if (upper .and. .not. equilibrium%medium%is_pair) then
                call raise(error, error_invalid, " = upper is not allowed: the indenter is rigid", "body")
                return
            end if
            call check_state(self, state, error)
            if (allocated(error)) return
            call equilibrium%medium%surface_load(equilibrium%profile, state%radius, state%excess, load, error)
            if (allocated(error)) return
            if (upper .and. allocated(equilibrium%medium%counterbody)) return
            if (allocated(equilibrium%medium%pressed) .and. .not. upper) return
            call raise(error, error_invalid, "stresses inside are not known for this medium: E and nu of its layers are needed")
        end associate
    end subroutine load_of

    !> Raises unless a state can be one of this contact.
    pure subroutine check_state(self, state, error)
        class(fields_t), intent(in) :: self
        type(contact_state_t), intent(in) :: state
        type(error_t), allocatable, intent(out) :: error

        if (.not. state%radius > 0.0_wp) then
            call raise(error, error_invalid, "the contact radius of the state must be greater than 0: there is no contact")
        else if (state%radius > self%equilibrium%last_radius) then
            call raise(error, error_invalid, "the contact radius of the state, "//to_text(state%radius)//", is not one of this "// &
                       "contact: indenter and medium are defined up to "//to_text(self%equilibrium%last_radius))
        end if
        call check_finite(error, "depth of the state", state%depth)
        call check_finite(error, "excess of the state", state%excess)
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
            if (positions(i) > radius) call raise(error, error_domain, " = "//to_text(positions(i))//" is not allowed: it must "// &
                                                  "be at most the contact radius, "//to_text(radius), name, i)
        end do
    end subroutine check_positions

end module mdrcontact_field
