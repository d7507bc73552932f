! SPDX-License-Identifier: GPL-3.0-or-later
!> Displacements, stresses and energies inside the bodies of a contact (theory/stress.md (1.2)-(1.4), (5.3)).
module mdrcontact_inside
    use mdrcontact_nonfinite, only: is_finite
    use mdrcontact_body_layers, only: layers_t
    use mdrcontact_contact_equilibrium, only: equilibrium_t
    use mdrcontact_contact_load, only: contact_load_t
    use mdrcontact_error, only: check_finite, check_made, check_not_negative, error_invalid, error_t, raise, to_text
    use mdrcontact_inside_body_field, only: body_field
    use mdrcontact_inside_energy, only: layer_energies
    use mdrcontact_inside_interior, only: components, s_zz, u_z
    use mdrcontact_kinds, only: pi, wp
    use mdrcontact_medium_load, only: load_t, lower_body, upper_body
    use mdrcontact_medium_solver, only: refuse
    implicit none (type, external)
    private
    public :: check_friction, interior, interior_error, layer_energy, layers_of, load_inside

    !> Where the field inside a body is compared with the surface [a]: off the axis and the edge, where pressures may be infinite.
    real(wp), parameter :: compared(3) = [0.31_wp, 0.62_wp, 0.9_wp]

contains

    !> Displacements and stresses inside a body under the state's pressure, and under its friction where the contact slides.
    subroutine interior(load, upper, r, z, below, friction, angle, field, error, threads)
        type(contact_load_t), intent(in) :: load
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
        class(load_t), allocatable :: own
        integer :: i

        call check_made(error, "load", load%is_made)
        if (allocated(error)) return
        do i = 1, size(angle)
            call check_finite(error, "angle", angle(i), i)
        end do
        if (allocated(error)) return
        call load_inside(load, upper, own, error)
        if (.not. allocated(error)) call check_friction(own, friction, error)
        if (allocated(error)) return
        associate (medium => load%equilibrium%medium)
            if (upper) then
                call body_field(own, medium%counterbody, r, z, below, field, error, -friction, angle, threads)
            else
                call body_field(own, medium%pressed, r, z, below, field, error, friction, angle, threads)
            end if
        end associate
    end subroutine interior

    !> Difference of the field inside a body from the state on the surface: at some radii within the contact s_zz from -p(r),
    !> relative to the largest pressure there and the mean one, and u_z from d - f(r), of two bodies from the body's part of it,
    !> relative to d and to f(a). Under an approximate model s_zz alone, for its surface does not fit the indenter.
    subroutine interior_error(load, upper, deviation, error)
        type(contact_load_t), intent(in) :: load
        !> whether the upper body is meant
        logical, intent(in) :: upper
        !> the largest of them [1]
        real(wp), intent(out) :: deviation
        type(error_t), allocatable, intent(out) :: error
        real(wp), dimension(size(compared)) :: r, pressure, motion
        real(wp) :: field(size(compared), components)
        logical :: inside(size(compared))

        deviation = 0.0_wp
        call check_made(error, "load", load%is_made)
        if (allocated(error)) return
        r = compared*load%state%radius
        call interior(load, upper, r, 0.0_wp*r, .true., 0.0_wp, 0.0_wp*r, field, error, 1)
        if (.not. allocated(error)) call load%pressure(r, pressure, error)
        if (allocated(error)) return
        inside = is_finite(pressure) .and. is_finite(field(:, s_zz))
        if (.not. any(inside)) return
        deviation = maxval(abs(field(:, s_zz) + pressure), mask=inside) &
                    /max(abs(load%state%force)/(pi*load%state%radius**2), maxval(abs(pressure), mask=inside))
        associate (profile => load%equilibrium%profile, medium => load%equilibrium%medium, state => load%state)
            ! the springs of a homogeneous body are exact, though its modulus is an effective one
            if (.not. (medium%is_exact .or. medium%has_free_springs)) return
            motion = state%depth - profile%height(r)
            if (medium%is_pair) call load%surface%displacement_of_body(merge(upper_body, lower_body, upper), r, motion, error)
            if (allocated(error)) return
            deviation = max(deviation, maxval(abs(field(:, u_z) - motion)) &
                            /max(abs(state%depth), profile%height(state%radius)))
        end associate
    end subroutine interior_error

    !> Elastic energy of each layer of a body, top to bottom, the half-space last [modulus length^3].
    subroutine layer_energy(load, upper, energies, error)
        type(contact_load_t), intent(in) :: load
        !> whether the upper body is meant
        logical, intent(in) :: upper
        !> one of each layer, and that of the half-space if there is one [modulus length^3]
        real(wp), allocatable, intent(out) :: energies(:)
        type(error_t), allocatable, intent(out) :: error
        class(load_t), allocatable :: own
        type(layers_t) :: layers

        call check_made(error, "load", load%is_made)
        if (allocated(error)) return
        call load_inside(load, upper, own, error)
        if (.not. allocated(error)) call layers_of(load%equilibrium, upper, layers, error)
        if (allocated(error)) return
        allocate (energies, source=layer_energies(own, layers, error))
    end subroutine layer_energy

    !> The homogeneous layers of an existing body.
    subroutine layers_of(equilibrium, upper, layers, error)
        type(equilibrium_t), intent(in) :: equilibrium
        !> whether the upper body is meant
        logical, intent(in) :: upper
        type(layers_t), intent(out) :: layers
        type(error_t), allocatable, intent(inout) :: error

        call check_body(equilibrium, upper, error)
        call check_known(equilibrium, upper, error)
        if (allocated(error)) return
        associate (medium => equilibrium%medium)
            if (upper) then
                call medium%counterbody%sublayers(layers, error)
            else
                call medium%pressed%sublayers(layers, error)
            end if
        end associate
    end subroutine layers_of

    !> A load in the form for the inside of an existing body.
    subroutine load_inside(load, upper, own, error)
        type(contact_load_t), intent(in) :: load
        logical, intent(in) :: upper
        class(load_t), allocatable, intent(inout) :: own
        type(error_t), allocatable, intent(out) :: error

        call check_body(load%equilibrium, upper, error)
        if (allocated(error)) return
        if (.not. load%surface%is_complete) call refuse(load%equilibrium%medium, "subsurface stresses are", &
            "a homogeneous, coated, layered or graded one", "the surface layer also loads the body outside the contact", error)
        call check_known(load%equilibrium, upper, error)
        if (allocated(error)) return
        allocate (own, source=load%surface)
        call own%find_kinks(error)
    end subroutine load_inside

    !> Raises unless the body is there and the contact one whose inside is known.
    subroutine check_body(equilibrium, upper, error)
        type(equilibrium_t), intent(in) :: equilibrium
        logical, intent(in) :: upper
        type(error_t), allocatable, intent(inout) :: error

        if (upper .and. .not. equilibrium%medium%is_pair) then
            call raise(error, error_invalid, " = upper: the indenter is rigid. Use lower", "body")
        else if (allocated(equilibrium%cohesion)) then
            call raise(error, error_invalid, "cohesive_stress: subsurface stresses and energies are not available with a "// &
                       "cohesive zone. Omit it: the JKR limit applies")
        end if
    end subroutine check_body

    !> Raises unless E and nu are known inside the body.
    subroutine check_known(equilibrium, upper, error)
        type(equilibrium_t), intent(in) :: equilibrium
        logical, intent(in) :: upper
        type(error_t), allocatable, intent(inout) :: error
        logical :: is_known

        is_known = allocated(equilibrium%medium%pressed)
        if (upper) is_known = allocated(equilibrium%medium%counterbody)
        if (.not. is_known) call raise(error, error_invalid, "medium: subsurface stresses need E and nu of its layers")
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
            call raise(error, error_invalid, " = "//to_text(friction)//": it must be 0 with adhesion, because Coulomb's law "// &
                       "is not defined under tension", "friction")
        end if
    end subroutine check_friction

end module mdrcontact_inside
