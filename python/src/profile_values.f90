! SPDX-License-Identifier: GPL-3.0-or-later
! Values and end of a profile, flat for f2py.

!> See mdr_profile_height.
subroutine profile_height(n, threads, handle, x, values, status)
    use, intrinsic :: iso_c_binding, only: c_double, c_int, c_int64_t
    use mdrcontact_address, only: to_pointer
    use mdrcontact_api_profile_values, only: mdr_profile_height_threads
    implicit none (type, external)
    !f2py threadsafe
    integer(c_int), intent(in) :: n, threads
    integer(c_int64_t), intent(in) :: handle
    real(c_double), intent(in) :: x(n)
    real(c_double), intent(out) :: values(n)
    integer(c_int), intent(out) :: status

    status = mdr_profile_height_threads(to_pointer(handle), n, x, values, threads)
end subroutine profile_height

!> See mdr_profile_slope.
subroutine profile_slope(n, threads, handle, x, values, status)
    use, intrinsic :: iso_c_binding, only: c_double, c_int, c_int64_t
    use mdrcontact_address, only: to_pointer
    use mdrcontact_api_profile_values, only: mdr_profile_slope_threads
    implicit none (type, external)
    !f2py threadsafe
    integer(c_int), intent(in) :: n, threads
    integer(c_int64_t), intent(in) :: handle
    real(c_double), intent(in) :: x(n)
    real(c_double), intent(out) :: values(n)
    integer(c_int), intent(out) :: status

    status = mdr_profile_slope_threads(to_pointer(handle), n, x, values, threads)
end subroutine profile_slope

!> See mdr_profile_mdr.
subroutine profile_mdr(n, threads, handle, x, values, status)
    use, intrinsic :: iso_c_binding, only: c_double, c_int, c_int64_t
    use mdrcontact_address, only: to_pointer
    use mdrcontact_api_profile_values, only: mdr_profile_mdr_threads
    implicit none (type, external)
    !f2py threadsafe
    integer(c_int), intent(in) :: n, threads
    integer(c_int64_t), intent(in) :: handle
    real(c_double), intent(in) :: x(n)
    real(c_double), intent(out) :: values(n)
    integer(c_int), intent(out) :: status

    status = mdr_profile_mdr_threads(to_pointer(handle), n, x, values, threads)
end subroutine profile_mdr

!> See mdr_profile_mdr_slope.
subroutine profile_mdr_slope(n, threads, handle, x, values, status)
    use, intrinsic :: iso_c_binding, only: c_double, c_int, c_int64_t
    use mdrcontact_address, only: to_pointer
    use mdrcontact_api_profile_values, only: mdr_profile_mdr_slope_threads
    implicit none (type, external)
    !f2py threadsafe
    integer(c_int), intent(in) :: n, threads
    integer(c_int64_t), intent(in) :: handle
    real(c_double), intent(in) :: x(n)
    real(c_double), intent(out) :: values(n)
    integer(c_int), intent(out) :: status

    status = mdr_profile_mdr_slope_threads(to_pointer(handle), n, x, values, threads)
end subroutine profile_mdr_slope

!> See mdr_profile_free.
subroutine profile_free(handle, status)
    use, intrinsic :: iso_c_binding, only: c_int, c_int64_t, c_ptr
    use mdrcontact_address, only: to_pointer
    use mdrcontact_api_handles, only: mdr_profile_free
    implicit none (type, external)
    integer(c_int64_t), intent(in) :: handle
    integer(c_int), intent(out) :: status
    type(c_ptr) :: object

    object = to_pointer(handle)
    status = mdr_profile_free(object)
end subroutine profile_free
