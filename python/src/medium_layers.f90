! SPDX-License-Identifier: GPL-3.0-or-later
! Coated, layered and graded media, flat for f2py.

!> See mdr_medium_coated.
subroutine medium_coated(coating_E, coating_nu, thickness, substrate_E, substrate_nu, model, alpha, wave_factor, &
    weight_nu_choice, weight_nu, tolerance, handle, status)
    use, intrinsic :: iso_c_binding, only: c_double, c_int, c_int64_t, c_null_ptr, c_ptr
    use mdrcontact_address, only: to_address
    use mdrcontact_api_coated, only: mdr_medium_coated
    use mdrcontact_api_medium_options, only: medium_options_t
    implicit none (type, external)
    !f2py threadsafe
    real(c_double), intent(in) :: coating_E, coating_nu, thickness, substrate_E, substrate_nu
    real(c_double), intent(in) :: alpha, wave_factor, weight_nu, tolerance
    integer(c_int), intent(in) :: model, weight_nu_choice
    integer(c_int64_t), intent(out) :: handle
    integer(c_int), intent(out) :: status
    type(medium_options_t) :: options
    type(c_ptr) :: object

    options = medium_options_t(alpha, wave_factor, weight_nu_choice, weight_nu, tolerance)
    object = c_null_ptr
    status = mdr_medium_coated(coating_E, coating_nu, thickness, substrate_E, substrate_nu, model, options, object)
    handle = to_address(object)
end subroutine medium_coated

!> See mdr_medium_layered.
subroutine medium_layered(n, E, nu, thickness, substrate_E, substrate_nu, model, alpha, wave_factor, &
    weight_nu_choice, weight_nu, tolerance, handle, status)
    use, intrinsic :: iso_c_binding, only: c_double, c_int, c_int64_t, c_null_ptr, c_ptr
    use mdrcontact_address, only: to_address
    use mdrcontact_api_layered, only: mdr_medium_layered
    use mdrcontact_api_medium_options, only: medium_options_t
    implicit none (type, external)
    !f2py threadsafe
    integer(c_int), intent(in) :: n
    real(c_double), intent(in) :: E(n), nu(n), thickness(n)
    real(c_double), intent(in) :: substrate_E, substrate_nu
    real(c_double), intent(in) :: alpha, wave_factor, weight_nu, tolerance
    integer(c_int), intent(in) :: model, weight_nu_choice
    integer(c_int64_t), intent(out) :: handle
    integer(c_int), intent(out) :: status
    type(medium_options_t) :: options
    type(c_ptr) :: object

    options = medium_options_t(alpha, wave_factor, weight_nu_choice, weight_nu, tolerance)
    object = c_null_ptr
    status = mdr_medium_layered(n, E, nu, thickness, substrate_E, substrate_nu, model, options, object)
    handle = to_address(object)
end subroutine medium_layered

!> See mdr_medium_graded.
subroutine medium_graded(n, z, E, nu, model, alpha, wave_factor, weight_nu_choice, weight_nu, tolerance, handle, status)
    use, intrinsic :: iso_c_binding, only: c_double, c_int, c_int64_t, c_null_ptr, c_ptr
    use mdrcontact_address, only: to_address
    use mdrcontact_api_layered, only: mdr_medium_graded
    use mdrcontact_api_medium_options, only: medium_options_t
    implicit none (type, external)
    !f2py threadsafe
    integer(c_int), intent(in) :: n
    real(c_double), intent(in) :: z(n), E(n), nu(n)
    integer(c_int), intent(in) :: model, weight_nu_choice
    real(c_double), intent(in) :: alpha, wave_factor, weight_nu, tolerance
    integer(c_int64_t), intent(out) :: handle
    integer(c_int), intent(out) :: status
    type(medium_options_t) :: options
    type(c_ptr) :: object

    options = medium_options_t(alpha, wave_factor, weight_nu_choice, weight_nu, tolerance)
    object = c_null_ptr
    status = mdr_medium_graded(n, z, E, nu, model, options, object)
    handle = to_address(object)
end subroutine medium_graded

!> See mdr_medium_graded_callback; E and nu are addresses of mdr_functions. They run Python code: the lock stays.
subroutine medium_graded_callback(E, nu, depth, model, alpha, wave_factor, weight_nu_choice, weight_nu, tolerance, &
    handle, status)
    use, intrinsic :: iso_c_binding, only: c_double, c_int, c_int64_t, c_null_ptr, c_ptr
    use mdrcontact_address, only: to_address, to_function
    use mdrcontact_api_layered, only: mdr_medium_graded_callback
    use mdrcontact_api_medium_options, only: medium_options_t
    implicit none (type, external)
    integer(c_int64_t), intent(in) :: E, nu
    real(c_double), intent(in) :: depth, alpha, wave_factor, weight_nu, tolerance
    integer(c_int), intent(in) :: model, weight_nu_choice
    integer(c_int64_t), intent(out) :: handle
    integer(c_int), intent(out) :: status
    type(medium_options_t) :: options
    type(c_ptr) :: object

    options = medium_options_t(alpha, wave_factor, weight_nu_choice, weight_nu, tolerance)
    object = c_null_ptr
    status = mdr_medium_graded_callback(to_function(E), to_function(nu), c_null_ptr, depth, model, options, object)
    handle = to_address(object)
end subroutine medium_graded_callback
