! SPDX-License-Identifier: GPL-3.0-or-later
! Fields of a contact, flat for f2py.

!> See mdr_contact_pressure.
subroutine contact_pressure(n, handle, a, r, values, status)
    use, intrinsic :: iso_c_binding, only: c_double, c_int, c_int64_t
    use mdrcontact_address, only: to_pointer
    use mdrcontact_api_fields, only: mdr_contact_pressure
    implicit none (type, external)
    !f2py threadsafe
    integer(c_int), intent(in) :: n
    integer(c_int64_t), intent(in) :: handle
    real(c_double), intent(in) :: a
    real(c_double), intent(in) :: r(n)
    real(c_double), intent(out) :: values(n)
    integer(c_int), intent(out) :: status

    status = mdr_contact_pressure(to_pointer(handle), a, n, r, values)
end subroutine contact_pressure

!> See mdr_contact_displacement.
subroutine contact_displacement(n, handle, a, r, values, status)
    use, intrinsic :: iso_c_binding, only: c_double, c_int, c_int64_t
    use mdrcontact_address, only: to_pointer
    use mdrcontact_api_fields, only: mdr_contact_displacement
    implicit none (type, external)
    !f2py threadsafe
    integer(c_int), intent(in) :: n
    integer(c_int64_t), intent(in) :: handle
    real(c_double), intent(in) :: a
    real(c_double), intent(in) :: r(n)
    real(c_double), intent(out) :: values(n)
    integer(c_int), intent(out) :: status

    status = mdr_contact_displacement(to_pointer(handle), a, n, r, values)
end subroutine contact_displacement

!> See mdr_contact_line_load.
subroutine contact_line_load(n, handle, a, r, values, status)
    use, intrinsic :: iso_c_binding, only: c_double, c_int, c_int64_t
    use mdrcontact_address, only: to_pointer
    use mdrcontact_api_fields, only: mdr_contact_line_load
    implicit none (type, external)
    !f2py threadsafe
    integer(c_int), intent(in) :: n
    integer(c_int64_t), intent(in) :: handle
    real(c_double), intent(in) :: a
    real(c_double), intent(in) :: r(n)
    real(c_double), intent(out) :: values(n)
    integer(c_int), intent(out) :: status

    status = mdr_contact_line_load(to_pointer(handle), a, n, r, values)
end subroutine contact_line_load

!> See mdr_contact_pressure_at_depth.
subroutine contact_pressure_at_depth(n, handle, d, r, values, status)
    use, intrinsic :: iso_c_binding, only: c_double, c_int, c_int64_t
    use mdrcontact_address, only: to_pointer
    use mdrcontact_api_fields, only: mdr_contact_pressure_at_depth
    implicit none (type, external)
    !f2py threadsafe
    integer(c_int), intent(in) :: n
    integer(c_int64_t), intent(in) :: handle
    real(c_double), intent(in) :: d
    real(c_double), intent(in) :: r(n)
    real(c_double), intent(out) :: values(n)
    integer(c_int), intent(out) :: status

    status = mdr_contact_pressure_at_depth(to_pointer(handle), d, n, r, values)
end subroutine contact_pressure_at_depth

!> See mdr_contact_displacement_at_depth.
subroutine contact_displacement_at_depth(n, handle, d, r, values, status)
    use, intrinsic :: iso_c_binding, only: c_double, c_int, c_int64_t
    use mdrcontact_address, only: to_pointer
    use mdrcontact_api_fields, only: mdr_contact_displacement_at_depth
    implicit none (type, external)
    !f2py threadsafe
    integer(c_int), intent(in) :: n
    integer(c_int64_t), intent(in) :: handle
    real(c_double), intent(in) :: d
    real(c_double), intent(in) :: r(n)
    real(c_double), intent(out) :: values(n)
    integer(c_int), intent(out) :: status

    status = mdr_contact_displacement_at_depth(to_pointer(handle), d, n, r, values)
end subroutine contact_displacement_at_depth

!> See mdr_contact_line_load_at_depth.
subroutine contact_line_load_at_depth(n, handle, d, r, values, status)
    use, intrinsic :: iso_c_binding, only: c_double, c_int, c_int64_t
    use mdrcontact_address, only: to_pointer
    use mdrcontact_api_fields, only: mdr_contact_line_load_at_depth
    implicit none (type, external)
    !f2py threadsafe
    integer(c_int), intent(in) :: n
    integer(c_int64_t), intent(in) :: handle
    real(c_double), intent(in) :: d
    real(c_double), intent(in) :: r(n)
    real(c_double), intent(out) :: values(n)
    integer(c_int), intent(out) :: status

    status = mdr_contact_line_load_at_depth(to_pointer(handle), d, n, r, values)
end subroutine contact_line_load_at_depth
