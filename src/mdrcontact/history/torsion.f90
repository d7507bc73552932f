! SPDX-License-Identifier: GPL-3.0-or-later
!> A contact under Coulomb's law of friction that is twisted about its axis at constant normal force (theory 10): Lubkin's problem.
!>
!> Pressed without friction first, then twisted by the angle phi: a disc of stick shrinks from the contact radius towards the axis,
!> as under a shift, and the same two functions of its radius give all: -dphi/dc and the torsional stiffness. Nothing is neglected:
!> torsion moves neither the pressure nor anything that varies around the axis.
module mdrcontact_history_torsion
    use, intrinsic :: iso_c_binding, only: c_double
    use mdrcontact_contact_state, only: contact_state_t
    use mdrcontact_error, only: check_finite, error_t, error_unreachable, raise, to_text
    use mdrcontact_medium_slip, only: slip_t
    use mdrcontact_history_friction, only: first_shear_t, friction_t, new_first_shear, tangential_state_t
    use mdrcontact_kinds, only: wp
    use mdrcontact_medium_twisted_slip, only: new_twisted_slip, twisted_slip_t
    implicit none (type, external)
    private
    public :: new_torsion, torsion_t, torsional_state_t

    !> A state of partial slip, C's struct mdr_torsional_state.
    type, bind(C) :: torsional_state_t
        !> phi, of the indenter about the axis [radian]
        real(c_double) :: twist = 0.0_c_double
        !> M [modulus length^3]
        real(c_double) :: torque = 0.0_c_double
        !> c, 0 where the contact slides [length]
        real(c_double) :: stick_radius = 0.0_c_double
        !> dM/dphi, that of a contact of radius c that sticks all over [modulus length^3]
        real(c_double) :: stiffness = 0.0_c_double
        !> energy dissipated since phi = 0 [modulus length^3]
        real(c_double) :: dissipated_energy = 0.0_c_double
        !> 1 if the disc of stick is smaller than 1e-6 a, else 0
        real(c_double) :: sliding = 0.0_c_double
    end type torsional_state_t

    !> One normal state, twisted for the first time.
    type :: torsion_t
        private
        !> phi in the place of s, M in that of T
        type(first_shear_t) :: shear
        !> contact radius a [length], and the torque as the twist grows, coefficient times int r p dA [modulus length^3]
        real(wp), public :: radius = 0.0_wp, sliding_torque = 0.0_wp
    contains
        procedure :: at_twist
        procedure :: at_torque
        procedure :: loop
        procedure :: line_load
        procedure :: traction
    end type torsion_t

contains

    !> What happens to a normal state as its indenter is twisted.
    subroutine new_torsion(self, friction, state, error)
        type(torsion_t), intent(out) :: self
        !> of a contact with a homogeneous medium
        type(friction_t), intent(in) :: friction
        !> a state of its contact, a > 0
        type(contact_state_t), intent(in) :: state
        type(error_t), allocatable, intent(out) :: error
        type(twisted_slip_t), allocatable :: twisted
        class(slip_t), allocatable :: slip

        call friction%check_state(state, error)
        if (allocated(error)) return
        associate (equilibrium => friction%contact%equilibrium)
            allocate (twisted)
            call new_twisted_slip(twisted, equilibrium%medium, equilibrium%profile, state%radius, state%excess, error)
        end associate
        if (allocated(error)) return
        call move_alloc(twisted, slip)
        call new_first_shear(self%shear, slip, friction%coefficient)
        self%radius = self%shear%radius
        self%sliding_torque = self%shear%sliding_force
    end subroutine new_torsion

    !> The state at a twist.
    subroutine at_twist(self, twist, state, error)
        class(torsion_t), intent(in) :: self
        !> phi, of either sign [radian]
        real(wp), intent(in) :: twist
        type(torsional_state_t), intent(out) :: state
        type(error_t), allocatable, intent(out) :: error
        type(tangential_state_t) :: sheared

        call check_finite(error, "twist", twist)
        if (.not. allocated(error)) call self%shear%at_shift(twist, sheared, error)
        if (.not. allocated(error)) state = as_torsion(sheared)
    end subroutine at_twist

    !> The state under a torque.
    subroutine at_torque(self, torque, state, error)
        class(torsion_t), intent(in) :: self
        !> M, |M| < sliding_torque [modulus length^3]
        real(wp), intent(in) :: torque
        type(torsional_state_t), intent(out) :: state
        type(error_t), allocatable, intent(out) :: error
        type(tangential_state_t) :: sheared

        call check_finite(error, "torque", torque)
        if (allocated(error)) return
        if (abs(torque) >= self%sliding_torque) then
            call raise(error, error_unreachable, " = "//to_text(torque)//" cannot be reached: a growing twist approaches that "// &
                       "of sliding, "//to_text(self%sliding_torque)//"; it must be below", "torque")
            return
        end if
        call self%shear%at_tangential_force(torque, sheared, error)
        if (.not. allocated(error)) state = as_torsion(sheared)
    end subroutine at_torque

    !> A cycle between +amplitude and -amplitude, by Masing's rule.
    subroutine loop(self, turn, twist, torque, error)
        class(torsion_t), intent(in) :: self
        !> the state of the amplitude, phi > 0
        type(torsional_state_t), intent(in) :: turn
        !> phi [radian] and M [modulus length^3] in equal steps from +phi to -phi and back; same size, at least 3
        real(wp), intent(out) :: twist(:), torque(:)
        type(error_t), allocatable, intent(out) :: error

        call self%shear%loop(as_shear(turn), twist, torque, error)
    end subroutine loop

    !> q(x) = 2 x int_x^a tau dr/sqrt(r^2 - x^2), the line load of the springs [modulus length].
    subroutine line_load(self, state, x, values, error)
        class(torsion_t), intent(in) :: self
        type(torsional_state_t), intent(in) :: state
        !> 0 <= x <= a [length]
        real(wp), intent(in) :: x(:)
        !> (size(x))
        real(wp), intent(out) :: values(:)
        type(error_t), allocatable, intent(out) :: error

        call check_finite(error, "twist of the torsional state", state%twist)
        if (.not. allocated(error)) call self%shear%line_load(as_shear(state), x, values, error)
    end subroutine line_load

    !> tau(r), the shear traction around the axis [modulus].
    subroutine traction(self, state, r, values, error)
        class(torsion_t), intent(in) :: self
        type(torsional_state_t), intent(in) :: state
        !> 0 <= r <= a [length]
        real(wp), intent(in) :: r(:)
        !> (size(r))
        real(wp), intent(out) :: values(:)
        type(error_t), allocatable, intent(out) :: error

        call check_finite(error, "twist of the torsional state", state%twist)
        if (.not. allocated(error)) call self%shear%traction(as_shear(state), r, values, error)
    end subroutine traction

    elemental function as_torsion(state) result(twisted)
        type(tangential_state_t), intent(in) :: state
        type(torsional_state_t) :: twisted

        twisted = torsional_state_t(state%shift, state%tangential_force, state%stick_radius, state%stiffness, &
                                    state%dissipated_energy, state%sliding)
    end function as_torsion

    elemental function as_shear(state) result(sheared)
        type(torsional_state_t), intent(in) :: state
        type(tangential_state_t) :: sheared

        sheared = tangential_state_t(state%twist, state%torque, state%stick_radius, state%stiffness, state%dissipated_energy, &
                                     state%sliding)
    end function as_shear

end module mdrcontact_history_torsion
