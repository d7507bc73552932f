! SPDX-License-Identifier: GPL-3.0-or-later
! Fields of a contact, flat for f2py.

!> See mdr_contact_pressure.
subroutine contact_pressure(n, threads, handle, a, r, values, status)
    use, intrinsic :: iso_c_binding, only: c_double, c_int, c_int64_t
    use mdrcontact_address, only: to_pointer
    use mdrcontact_api_fields, only: mdr_contact_pressure_threads
    implicit none (type, external)
    !f2py threadsafe
    integer(c_int), intent(in) :: n, threads
    integer(c_int64_t), intent(in) :: handle
    real(c_double), intent(in) :: a
    real(c_double), intent(in) :: r(n)
    real(c_double), intent(out) :: values(n)
    integer(c_int), intent(out) :: status

    status = mdr_contact_pressure_threads(to_pointer(handle), a, n, r, values, threads)
end subroutine contact_pressure

!> See mdr_contact_displacement.
subroutine contact_displacement(n, threads, handle, a, r, values, status)
    use, intrinsic :: iso_c_binding, only: c_double, c_int, c_int64_t
    use mdrcontact_address, only: to_pointer
    use mdrcontact_api_fields, only: mdr_contact_displacement_threads
    implicit none (type, external)
    !f2py threadsafe
    integer(c_int), intent(in) :: n, threads
    integer(c_int64_t), intent(in) :: handle
    real(c_double), intent(in) :: a
    real(c_double), intent(in) :: r(n)
    real(c_double), intent(out) :: values(n)
    integer(c_int), intent(out) :: status

    status = mdr_contact_displacement_threads(to_pointer(handle), a, n, r, values, threads)
end subroutine contact_displacement

!> See mdr_contact_line_load.
subroutine contact_line_load(n, threads, handle, a, r, values, status)
    use, intrinsic :: iso_c_binding, only: c_double, c_int, c_int64_t
    use mdrcontact_address, only: to_pointer
    use mdrcontact_api_fields, only: mdr_contact_line_load_threads
    implicit none (type, external)
    !f2py threadsafe
    integer(c_int), intent(in) :: n, threads
    integer(c_int64_t), intent(in) :: handle
    real(c_double), intent(in) :: a
    real(c_double), intent(in) :: r(n)
    real(c_double), intent(out) :: values(n)
    integer(c_int), intent(out) :: status

    status = mdr_contact_line_load_threads(to_pointer(handle), a, n, r, values, threads)
end subroutine contact_line_load

!> See mdr_contact_pressure_at_depth.
subroutine contact_pressure_at_depth(n, threads, handle, d, r, values, status)
    use, intrinsic :: iso_c_binding, only: c_double, c_int, c_int64_t
    use mdrcontact_address, only: to_pointer
    use mdrcontact_api_fields, only: mdr_contact_pressure_at_depth_threads
    implicit none (type, external)
    !f2py threadsafe
    integer(c_int), intent(in) :: n, threads
    integer(c_int64_t), intent(in) :: handle
    real(c_double), intent(in) :: d
    real(c_double), intent(in) :: r(n)
    real(c_double), intent(out) :: values(n)
    integer(c_int), intent(out) :: status

    status = mdr_contact_pressure_at_depth_threads(to_pointer(handle), d, n, r, values, threads)
end subroutine contact_pressure_at_depth

!> See mdr_contact_displacement_at_depth.
subroutine contact_displacement_at_depth(n, threads, handle, d, r, values, status)
    use, intrinsic :: iso_c_binding, only: c_double, c_int, c_int64_t
    use mdrcontact_address, only: to_pointer
    use mdrcontact_api_fields, only: mdr_contact_displacement_at_depth_threads
    implicit none (type, external)
    !f2py threadsafe
    integer(c_int), intent(in) :: n, threads
    integer(c_int64_t), intent(in) :: handle
    real(c_double), intent(in) :: d
    real(c_double), intent(in) :: r(n)
    real(c_double), intent(out) :: values(n)
    integer(c_int), intent(out) :: status

    status = mdr_contact_displacement_at_depth_threads(to_pointer(handle), d, n, r, values, threads)
end subroutine contact_displacement_at_depth

!> See mdr_contact_line_load_at_depth.
subroutine contact_line_load_at_depth(n, threads, handle, d, r, values, status)
    use, intrinsic :: iso_c_binding, only: c_double, c_int, c_int64_t
    use mdrcontact_address, only: to_pointer
    use mdrcontact_api_fields, only: mdr_contact_line_load_at_depth_threads
    implicit none (type, external)
    !f2py threadsafe
    integer(c_int), intent(in) :: n, threads
    integer(c_int64_t), intent(in) :: handle
    real(c_double), intent(in) :: d
    real(c_double), intent(in) :: r(n)
    real(c_double), intent(out) :: values(n)
    integer(c_int), intent(out) :: status

    status = mdr_contact_line_load_at_depth_threads(to_pointer(handle), d, n, r, values, threads)
end subroutine contact_line_load_at_depth
