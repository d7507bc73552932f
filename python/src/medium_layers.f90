! SPDX-License-Identifier: GPL-3.0-or-later
! Coated, layered and graded media, flat for f2py; options: the values of mdrcontact_model's option_names, in this order.

!> See mdr_medium_coated.
subroutine medium_coated(m, coating_E, coating_nu, thickness, substrate_E, substrate_nu, model, &
    options, handle, status)
    use, intrinsic :: iso_c_binding, only: c_double, c_int, c_int64_t, c_null_ptr, c_ptr
    use mdrcontact_address, only: to_address
    use mdrcontact_api_layered, only: mdr_medium_coated
    use mdrcontact_model, only: options_of
    implicit none (type, external)
    !f2py threadsafe
    real(c_double), intent(in) :: coating_E, coating_nu, thickness, substrate_E, substrate_nu
    integer(c_int), intent(in) :: m, model
    real(c_double), intent(in) :: options(m)
    integer(c_int64_t), intent(out) :: handle
    integer(c_int), intent(out) :: status
    type(c_ptr) :: object

    object = c_null_ptr
    status = mdr_medium_coated(coating_E, coating_nu, thickness, substrate_E, substrate_nu, model, options_of(options), object)
    handle = to_address(object)
end subroutine medium_coated

!> See mdr_medium_layered.
subroutine medium_layered(n, m, E, nu, thickness, substrate_E, substrate_nu, model, &
    options, handle, status)
    use, intrinsic :: iso_c_binding, only: c_double, c_int, c_int64_t, c_null_ptr, c_ptr
    use mdrcontact_address, only: to_address
    use mdrcontact_api_layered, only: mdr_medium_layered
    use mdrcontact_model, only: options_of
    implicit none (type, external)
    !f2py threadsafe
    integer(c_int), intent(in) :: n, m
    real(c_double), intent(in) :: E(n), nu(n), thickness(n)
    real(c_double), intent(in) :: substrate_E, substrate_nu
    integer(c_int), intent(in) :: model
    real(c_double), intent(in) :: options(m)
    integer(c_int64_t), intent(out) :: handle
    integer(c_int), intent(out) :: status
    type(c_ptr) :: object

    object = c_null_ptr
    status = mdr_medium_layered(n, E, nu, thickness, substrate_E, substrate_nu, model, options_of(options), object)
    handle = to_address(object)
end subroutine medium_layered

!> See mdr_medium_graded.
subroutine medium_graded(n, m, z, E, nu, model, options, handle, status)
    use, intrinsic :: iso_c_binding, only: c_double, c_int, c_int64_t, c_null_ptr, c_ptr
    use mdrcontact_address, only: to_address
    use mdrcontact_api_layered, only: mdr_medium_graded
    use mdrcontact_model, only: options_of
    implicit none (type, external)
    !f2py threadsafe
    integer(c_int), intent(in) :: n, m
    real(c_double), intent(in) :: z(n), E(n), nu(n)
    integer(c_int), intent(in) :: model
    real(c_double), intent(in) :: options(m)
    integer(c_int64_t), intent(out) :: handle
    integer(c_int), intent(out) :: status
    type(c_ptr) :: object

    object = c_null_ptr
    status = mdr_medium_graded(n, z, E, nu, model, options_of(options), object)
    handle = to_address(object)
end subroutine medium_graded

!> See mdr_medium_graded_callback; E and nu are addresses of mdr_functions. They run Python code: the lock stays.
subroutine medium_graded_callback(m, E, nu, depth, model, options, handle, status)
    use, intrinsic :: iso_c_binding, only: c_double, c_int, c_int64_t, c_null_ptr, c_ptr
    use mdrcontact_address, only: to_address, to_function
    use mdrcontact_api_layered, only: mdr_medium_graded_callback
    use mdrcontact_model, only: options_of
    implicit none (type, external)
    integer(c_int64_t), intent(in) :: E, nu
    real(c_double), intent(in) :: depth
    integer(c_int), intent(in) :: m, model
    real(c_double), intent(in) :: options(m)
    integer(c_int64_t), intent(out) :: handle
    integer(c_int), intent(out) :: status
    type(c_ptr) :: object

    object = c_null_ptr
    status = mdr_medium_graded_callback(to_function(E), to_function(nu), c_null_ptr, depth, model, options_of(options), object)
    handle = to_address(object)
end subroutine medium_graded_callback
