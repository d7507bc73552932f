! SPDX-License-Identifier: GPL-3.0-or-later
! Values and end of a medium, flat for f2py.

!> See mdr_medium_modulus.
subroutine medium_modulus(n, threads, handle, a, values, status)
    use, intrinsic :: iso_c_binding, only: c_double, c_int, c_int64_t
    use mdrcontact_address, only: to_pointer
    use mdrcontact_api_medium, only: mdr_medium_modulus_threads
    implicit none (type, external)
    !f2py threadsafe
    integer(c_int), intent(in) :: n, threads
    integer(c_int64_t), intent(in) :: handle
    real(c_double), intent(in) :: a(n)
    real(c_double), intent(out) :: values(n)
    integer(c_int), intent(out) :: status

    status = mdr_medium_modulus_threads(to_pointer(handle), n, a, values, threads)
end subroutine medium_modulus

!> See mdr_medium_stiffness.
subroutine medium_stiffness(n, threads, handle, a, values, status)
    use, intrinsic :: iso_c_binding, only: c_double, c_int, c_int64_t
    use mdrcontact_address, only: to_pointer
    use mdrcontact_api_medium, only: mdr_medium_stiffness_threads
    implicit none (type, external)
    !f2py threadsafe
    integer(c_int), intent(in) :: n, threads
    integer(c_int64_t), intent(in) :: handle
    real(c_double), intent(in) :: a(n)
    real(c_double), intent(out) :: values(n)
    integer(c_int), intent(out) :: status

    status = mdr_medium_stiffness_threads(to_pointer(handle), n, a, values, threads)
end subroutine medium_stiffness

!> See mdr_medium_free.
subroutine medium_free(handle, status)
    use, intrinsic :: iso_c_binding, only: c_int, c_int64_t, c_ptr
    use mdrcontact_address, only: to_pointer
    use mdrcontact_api_handles, only: mdr_medium_free
    implicit none (type, external)
    integer(c_int64_t), intent(in) :: handle
    integer(c_int), intent(out) :: status
    type(c_ptr) :: object

    object = to_pointer(handle)
    status = mdr_medium_free(object)
end subroutine medium_free
