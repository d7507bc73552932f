! SPDX-License-Identifier: GPL-3.0-or-later
!> Contacts with friction that are twisted, for C. Their struct mdr_torsional_state has the numbers of mdr_tangential_state.
module mdrcontact_api_torsion
    use, intrinsic :: iso_c_binding, only: c_double, c_int, c_ptr
    use mdrcontact_api_arrays, only: check_results
    use mdrcontact_api_sheared, only: by_twist, shear_of, write_field, write_loop, write_states
    use mdrcontact_api_status, only: check_given, status_of
    use mdrcontact_contact_state, only: contact_state_t
    use mdrcontact_error, only: error_t
    use mdrcontact_history_friction, only: first_shear_t, tangential_state_t
    implicit none (type, external)
    private
    public :: mdr_torsion_states, mdr_torsion_sliding, mdr_torsion_field, mdr_torsion_loop

contains

    function mdr_torsion_states(f, state, given, n, in, out) result(status) bind(C, name="mdrcontact_entry_torsion_states")
        type(c_ptr), value :: f
        type(contact_state_t), intent(in), optional :: state
        integer(c_int), value :: given, n
        real(c_double), intent(in), optional :: in(*)
        type(c_ptr), value :: out
        integer(c_int) :: status

        status = write_states(f, by_twist, state, given, n, in, out)
    end function mdr_torsion_states

    function mdr_torsion_sliding(f, state, torque) result(status) bind(C, name="mdrcontact_entry_torsion_sliding")
        type(c_ptr), value :: f
        type(contact_state_t), intent(in), optional :: state
        real(c_double), intent(inout), optional :: torque
        integer(c_int) :: status
        type(first_shear_t) :: torsion
        type(error_t), allocatable :: error

        call check_given(error, "torque", present(torque))
        if (.not. allocated(error)) call shear_of(f, by_twist, state, torsion, error)
        if (.not. allocated(error)) call check_results(error, [torsion%sliding_force])
        status = status_of(error)
        if (.not. allocated(error)) torque = torsion%sliding_force
    end function mdr_torsion_sliding

    function mdr_torsion_field(f, state, twisted, field, n, r, out) result(status) bind(C, name="mdrcontact_entry_torsion_field")
        type(c_ptr), value :: f
        type(contact_state_t), intent(in), optional :: state
        type(tangential_state_t), intent(in), optional :: twisted
        integer(c_int), value :: field, n
        real(c_double), intent(in), optional :: r(*)
        real(c_double), intent(inout), optional :: out(*)
        integer(c_int) :: status

        status = write_field(f, by_twist, state, twisted, field, n, r, out)
    end function mdr_torsion_field

    function mdr_torsion_loop(f, state, given, amplitude, n, twist, torque, dissipated) result(status) &
        bind(C, name="mdrcontact_entry_torsion_loop")
        type(c_ptr), value :: f
        type(contact_state_t), intent(in), optional :: state
        integer(c_int), value :: given, n
        real(c_double), value :: amplitude
        real(c_double), intent(inout), optional :: twist(*), torque(*), dissipated
        integer(c_int) :: status

        status = write_loop(f, by_twist, state, given, amplitude, n, twist, torque, dissipated)
    end function mdr_torsion_loop

end module mdrcontact_api_torsion
