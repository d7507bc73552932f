! SPDX-License-Identifier: GPL-3.0-or-later
!> Displacements, stresses and energies inside the bodies of a contact (theory/stress.md (1.2)-(1.4), (5.3)).
module mdrcontact_inside
    use mdrcontact_nonfinite, only: is_finite
    use mdrcontact_body_layers, only: layers_t
    use mdrcontact_contact_fields, only: check_state, fields_t
    use mdrcontact_contact_state, only: contact_state_t
    use mdrcontact_error, only: check_finite, check_not_negative, error_invalid, error_t, raise, to_text
    use mdrcontact_inside_body_field, only: body_field
    use mdrcontact_inside_energy, only: layer_energies
    use mdrcontact_inside_interior, only: components, s_zz, u_z
    use mdrcontact_medium_load, only: load_t
    use mdrcontact_kinds, only: pi, wp
    use mdrcontact_medium_solver, only: lower_body, refuse, upper_body
    implicit none (type, external)
    private
    public :: check_friction, interior, interior_error, layer_energy, layers_of, load_of

    !> Where the field inside a body is compared with the surface [a]: off the axis and the edge, where pressures may be infinite.
    real(wp), parameter :: compared(3) = [0.31_wp, 0.62_wp, 0.9_wp]

contains

    !> Displacements and stresses inside a body under the state's pressure, and under its friction where the contact slides.
    subroutine interior(contact, state, upper, r, z, below, friction, angle, field, error, threads)
        class(fields_t), intent(in) :: contact
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

        do i = 1, size(angle)
            call check_finite(error, "angle", angle(i), i)
        end do
        if (allocated(error)) return
        call load_of(contact, state, upper, load, error)
        if (.not. allocated(error)) call check_friction(load, friction, error)
        if (allocated(error)) return
        associate (medium => contact%equilibrium%medium)
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
    subroutine interior_error(contact, state, upper, deviation, error)
        class(fields_t), intent(in) :: contact
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
        call interior(contact, state, upper, r, 0.0_wp*r, .true., 0.0_wp, 0.0_wp*r, field, error, 1)
        if (.not. allocated(error)) call contact%pressure(state, r, pressure, error)
        if (allocated(error)) return
        inside = is_finite(pressure) .and. is_finite(field(:, s_zz))
        if (.not. any(inside)) return
        deviation = maxval(abs(field(:, s_zz) + pressure), mask=inside) &
                    /max(abs(state%force)/(pi*state%radius**2), maxval(abs(pressure), mask=inside))
        associate (equilibrium => contact%equilibrium, medium => contact%equilibrium%medium)
            ! the springs of a homogeneous body are exact, though its modulus is an effective one
            if (.not. (medium%is_exact .or. medium%has_free_springs)) return
            motion = state%depth - equilibrium%profile%height(r)
            if (medium%is_pair) call medium%take_share(equilibrium%profile, state%radius, state%punch_depth, &
                                                       merge(upper_body, lower_body, upper), r, motion, error)
            if (allocated(error)) return
            deviation = max(deviation, maxval(abs(field(:, u_z) - motion)) &
                            /max(abs(state%depth), equilibrium%profile%height(state%radius)))
        end associate
    end subroutine interior_error

    !> Elastic energy of each layer of a body, from the surface down, the half-space last [modulus length^3].
    subroutine layer_energy(contact, state, upper, energies, error)
        class(fields_t), intent(in) :: contact
        !> with a radius > 0
        type(contact_state_t), intent(in) :: state
        !> whether the upper body is meant
        logical, intent(in) :: upper
        !> one of each layer, and that of the half-space if there is one [modulus length^3]
        real(wp), allocatable, intent(out) :: energies(:)
        type(error_t), allocatable, intent(out) :: error
        class(load_t), allocatable :: load
        type(layers_t) :: layers

        call load_of(contact, state, upper, load, error)
        if (.not. allocated(error)) call layers_of(contact, upper, layers, error)
        if (allocated(error)) return
        allocate (energies, source=layer_energies(load, layers, error))
    end subroutine layer_energy

    !> The homogeneous layers of a body that is there.
    subroutine layers_of(contact, upper, layers, error)
        class(fields_t), intent(in) :: contact
        !> whether the upper body is meant
        logical, intent(in) :: upper
        type(layers_t), intent(out) :: layers
        type(error_t), allocatable, intent(inout) :: error

        call check_body(contact, upper, error)
        call check_known(contact, upper, error)
        if (allocated(error)) return
        associate (medium => contact%equilibrium%medium)
            if (upper) then
                call medium%counterbody%sublayers(layers, error)
            else
                call medium%pressed%sublayers(layers, error)
            end if
        end associate
    end subroutine layers_of

    !> The load of a state on a body that is there.
    subroutine load_of(contact, state, upper, load, error)
        class(fields_t), intent(in) :: contact
        type(contact_state_t), intent(in) :: state
        logical, intent(in) :: upper
        class(load_t), allocatable, intent(inout) :: load
        type(error_t), allocatable, intent(out) :: error

        call check_body(contact, upper, error)
        if (.not. allocated(error)) call check_state(contact, state, error)
        if (allocated(error)) return
        associate (equilibrium => contact%equilibrium)
            call equilibrium%medium%surface_load(equilibrium%profile, state%radius, state%punch_depth, load, error)
            if (.not. (allocated(load) .or. allocated(error))) call refuse(equilibrium%medium, "stresses inside are", &
                "a homogeneous, coated, layered or graded one", &
                "the body is loaded beside the contact, too, by what the surface hands on", error)
        end associate
        call check_known(contact, upper, error)
    end subroutine load_of

    !> Raises unless the body is there and the contact one whose inside is known.
    subroutine check_body(contact, upper, error)
        class(fields_t), intent(in) :: contact
        logical, intent(in) :: upper
        type(error_t), allocatable, intent(inout) :: error

        if (upper .and. .not. contact%equilibrium%medium%is_pair) then
            call raise(error, error_invalid, " = upper is not allowed: the indenter is rigid", "body")
        else if (allocated(contact%equilibrium%cohesion)) then
            call raise(error, error_invalid, "stresses and energies inside are not known of a contact with a "// &
                       "cohesive_stress: leave it out for adhesion without a range")
        end if
    end subroutine check_body

    !> Raises unless E and nu are known inside the body.
    subroutine check_known(contact, upper, error)
        class(fields_t), intent(in) :: contact
        logical, intent(in) :: upper
        type(error_t), allocatable, intent(inout) :: error
        logical :: is_known

        is_known = allocated(contact%equilibrium%medium%pressed)
        if (upper) is_known = allocated(contact%equilibrium%medium%counterbody)
        if (.not. is_known) call raise(error, error_invalid, "stresses inside are not known for this medium: E and nu of its "// &
                                       "layers are needed")
    end subroutine check_known

    !> Raises unless a contact can slide with a coefficient of friction.
    subroutine check_friction(load, friction, error)
        class(load_t), intent(in) :: load
        !> f >= 0
        real(wp), intent(in) :: friction
        type(error_t), allocatable, intent(inout) :: error

        call check_not_negative(error, "friction", friction)
        if (allocated(error)) return
        if (friction > 0.0_wp .and. load%edge < 0.0_wp) then
            call raise(error, error_invalid, " = "//to_text(friction)//" is not allowed with adhesion: Coulomb's "// &
                       "law knows no tension, use friction = 0", "friction")
        end if
    end subroutine check_friction

end module mdrcontact_inside
