! SPDX-License-Identifier: GPL-3.0-or-later
! Profiles from tables, functions and other profiles, flat for f2py.

!> See mdr_profile_area_function.
subroutine profile_area_function(n, coefficients, min_height, max_height, handle, status)
    use, intrinsic :: iso_c_binding, only: c_double, c_int, c_int64_t, c_null_ptr, c_ptr
    use mdrcontact_address, only: to_address
    use mdrcontact_api_profile_data, only: mdr_profile_area_function
    implicit none (type, external)
    !f2py threadsafe
    integer(c_int), intent(in) :: n
    real(c_double), intent(in) :: coefficients(n)
    real(c_double), intent(in) :: min_height, max_height
    integer(c_int64_t), intent(out) :: handle
    integer(c_int), intent(out) :: status
    type(c_ptr) :: object

    object = c_null_ptr
    status = mdr_profile_area_function(n, coefficients, min_height, max_height, object)
    handle = to_address(object)
end subroutine profile_area_function

!> See mdr_profile_table.
subroutine profile_table(n, r, f, handle, status)
    use, intrinsic :: iso_c_binding, only: c_double, c_int, c_int64_t, c_null_ptr, c_ptr
    use mdrcontact_address, only: to_address
    use mdrcontact_api_profile_data, only: mdr_profile_table
    implicit none (type, external)
    !f2py threadsafe
    integer(c_int), intent(in) :: n
    real(c_double), intent(in) :: r(n), f(n)
    integer(c_int64_t), intent(out) :: handle
    integer(c_int), intent(out) :: status
    type(c_ptr) :: object

    object = c_null_ptr
    status = mdr_profile_table(n, r, f, object)
    handle = to_address(object)
end subroutine profile_table

!> See mdr_profile_from_mdr_table.
subroutine profile_from_mdr_table(n, x, g, handle, status)
    use, intrinsic :: iso_c_binding, only: c_double, c_int, c_int64_t, c_null_ptr, c_ptr
    use mdrcontact_address, only: to_address
    use mdrcontact_api_profile_data, only: mdr_profile_from_mdr_table
    implicit none (type, external)
    !f2py threadsafe
    integer(c_int), intent(in) :: n
    real(c_double), intent(in) :: x(n), g(n)
    integer(c_int64_t), intent(out) :: handle
    integer(c_int), intent(out) :: status
    type(c_ptr) :: object

    object = c_null_ptr
    status = mdr_profile_from_mdr_table(n, x, g, object)
    handle = to_address(object)
end subroutine profile_from_mdr_table

!> See mdr_profile_callback; `height` is the address of an mdr_function. It runs Python code: the lock stays.
subroutine profile_callback(height, largest_radius, handle, status)
    use, intrinsic :: iso_c_binding, only: c_double, c_int, c_int64_t, c_null_ptr, c_ptr
    use mdrcontact_address, only: to_address, to_function
    use mdrcontact_api_profile_data, only: mdr_profile_callback
    implicit none (type, external)
    integer(c_int64_t), intent(in) :: height
    real(c_double), intent(in) :: largest_radius
    integer(c_int64_t), intent(out) :: handle
    integer(c_int), intent(out) :: status
    type(c_ptr) :: object

    object = c_null_ptr
    status = mdr_profile_callback(to_function(height), c_null_ptr, largest_radius, object)
    handle = to_address(object)
end subroutine profile_callback

!> See mdr_profile_sum.
subroutine profile_sum(n, terms, handle, status)
    use, intrinsic :: iso_c_binding, only: c_int, c_int64_t, c_null_ptr, c_ptr
    use mdrcontact_address, only: to_address, to_pointer
    use mdrcontact_api_profile_data, only: mdr_profile_sum
    implicit none (type, external)
    integer(c_int), intent(in) :: n
    integer(c_int64_t), intent(in) :: terms(n)
    integer(c_int64_t), intent(out) :: handle
    integer(c_int), intent(out) :: status
    type(c_ptr) :: pointers(n)
    type(c_ptr) :: object

    pointers = to_pointer(terms)
    object = c_null_ptr
    status = mdr_profile_sum(n, pointers, object)
    handle = to_address(object)
end subroutine profile_sum
