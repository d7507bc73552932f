! SPDX-License-Identifier: GPL-3.0-or-later
! Media without layers, flat for f2py.

!> See mdr_medium_homogeneous.
subroutine medium_homogeneous(E, nu, handle, status)
    use, intrinsic :: iso_c_binding, only: c_double, c_int, c_int64_t, c_null_ptr, c_ptr
    use mdrcontact_address, only: to_address
    use mdrcontact_api_medium, only: mdr_medium_homogeneous
    implicit none (type, external)
    real(c_double), intent(in) :: E, nu
    integer(c_int64_t), intent(out) :: handle
    integer(c_int), intent(out) :: status
    type(c_ptr) :: object

    object = c_null_ptr
    status = mdr_medium_homogeneous(E, nu, object)
    handle = to_address(object)
end subroutine medium_homogeneous

!> See mdr_medium_contact_modulus.
subroutine medium_contact_modulus(contact_modulus, handle, status)
    use, intrinsic :: iso_c_binding, only: c_double, c_int, c_int64_t, c_null_ptr, c_ptr
    use mdrcontact_address, only: to_address
    use mdrcontact_api_medium, only: mdr_medium_contact_modulus
    implicit none (type, external)
    real(c_double), intent(in) :: contact_modulus
    integer(c_int64_t), intent(out) :: handle
    integer(c_int), intent(out) :: status
    type(c_ptr) :: object

    object = c_null_ptr
    status = mdr_medium_contact_modulus(contact_modulus, object)
    handle = to_address(object)
end subroutine medium_contact_modulus

!> See mdr_medium_power_graded.
subroutine medium_power_graded(E0, z0, exponent, nu, handle, status)
    use, intrinsic :: iso_c_binding, only: c_double, c_int, c_int64_t, c_null_ptr, c_ptr
    use mdrcontact_address, only: to_address
    use mdrcontact_api_layered, only: mdr_medium_power_graded
    implicit none (type, external)
    real(c_double), intent(in) :: E0, z0, exponent, nu
    integer(c_int64_t), intent(out) :: handle
    integer(c_int), intent(out) :: status
    type(c_ptr) :: object

    object = c_null_ptr
    status = mdr_medium_power_graded(E0, z0, exponent, nu, object)
    handle = to_address(object)
end subroutine medium_power_graded

!> See mdr_medium_table.
subroutine medium_table(n, a, modulus, handle, status)
    use, intrinsic :: iso_c_binding, only: c_double, c_int, c_int64_t, c_null_ptr, c_ptr
    use mdrcontact_address, only: to_address
    use mdrcontact_api_medium_data, only: mdr_medium_table
    implicit none (type, external)
    !f2py threadsafe
    integer(c_int), intent(in) :: n
    real(c_double), intent(in) :: a(n), modulus(n)
    integer(c_int64_t), intent(out) :: handle
    integer(c_int), intent(out) :: status
    type(c_ptr) :: object

    object = c_null_ptr
    status = mdr_medium_table(n, a, modulus, object)
    handle = to_address(object)
end subroutine medium_table

!> See mdr_medium_callback; `modulus` is the address of an mdr_function. It runs Python code: the lock stays.
subroutine medium_callback(modulus, smallest_radius, largest_radius, handle, status)
    use, intrinsic :: iso_c_binding, only: c_double, c_int, c_int64_t, c_null_ptr, c_ptr
    use mdrcontact_address, only: to_address, to_function
    use mdrcontact_api_medium_data, only: mdr_medium_callback
    implicit none (type, external)
    integer(c_int64_t), intent(in) :: modulus
    real(c_double), intent(in) :: smallest_radius, largest_radius
    integer(c_int64_t), intent(out) :: handle
    integer(c_int), intent(out) :: status
    type(c_ptr) :: object

    object = c_null_ptr
    status = mdr_medium_callback(to_function(modulus), c_null_ptr, smallest_radius, largest_radius, object)
    handle = to_address(object)
end subroutine medium_callback
