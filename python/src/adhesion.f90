! SPDX-License-Identifier: GPL-3.0-or-later
! Pull-off and loops of adhesive contacts, flat for f2py.

!> See mdr_contact_pull_offs; count may be greater than n, and d, a, F then hold the first n.
subroutine contact_pull_offs(n, handle, control, d, a, F, count, status)
    use, intrinsic :: iso_c_binding, only: c_double, c_int, c_int64_t
    use mdrcontact_address, only: to_pointer
    use mdrcontact_api_adhesion, only: mdr_contact_pull_offs
    implicit none (type, external)
    !f2py threadsafe
    integer(c_int), intent(in) :: n, control
    integer(c_int64_t), intent(in) :: handle
    real(c_double), intent(out) :: d(n), a(n), F(n)
    integer(c_int), intent(out) :: count, status

    d = 0.0_c_double
    a = 0.0_c_double
    F = 0.0_c_double
    count = 0
    status = mdr_contact_pull_offs(to_pointer(handle), control, n, d, a, F, count)
end subroutine contact_pull_offs

!> See mdr_loop_new.
subroutine loop_new(contact, control, largest, points, spring_stiffness, handle, status)
    use, intrinsic :: iso_c_binding, only: c_double, c_int, c_int64_t, c_null_ptr, c_ptr
    use mdrcontact_address, only: to_address, to_pointer
    use mdrcontact_api_adhesion, only: mdr_loop_new
    implicit none (type, external)
    !f2py threadsafe
    integer(c_int64_t), intent(in) :: contact
    integer(c_int), intent(in) :: control, points
    real(c_double), intent(in) :: spring_stiffness, largest
    integer(c_int64_t), intent(out) :: handle
    integer(c_int), intent(out) :: status
    type(c_ptr) :: object

    object = c_null_ptr
    status = mdr_loop_new(to_pointer(contact), control, largest, points, spring_stiffness, object)
    handle = to_address(object)
end subroutine loop_new

!> See mdr_loop_size.
subroutine loop_size(handle, points, turning_point, jumps, status)
    use, intrinsic :: iso_c_binding, only: c_int, c_int64_t
    use mdrcontact_address, only: to_pointer
    use mdrcontact_api_adhesion, only: mdr_loop_size
    implicit none (type, external)
    !f2py threadsafe
    integer(c_int64_t), intent(in) :: handle
    integer(c_int), intent(out) :: points, turning_point, jumps, status

    status = mdr_loop_size(to_pointer(handle), points, turning_point, jumps)
end subroutine loop_size

!> See mdr_loop_path.
subroutine loop_path(n, handle, position, d, a, F, status)
    use, intrinsic :: iso_c_binding, only: c_double, c_int, c_int64_t
    use mdrcontact_address, only: to_pointer
    use mdrcontact_api_adhesion, only: mdr_loop_path
    implicit none (type, external)
    !f2py threadsafe
    integer(c_int), intent(in) :: n
    integer(c_int64_t), intent(in) :: handle
    real(c_double), intent(out) :: position(n), d(n), a(n), F(n)
    integer(c_int), intent(out) :: status

    status = mdr_loop_path(to_pointer(handle), n, position, d, a, F)
end subroutine loop_path

!> See mdr_loop_jumps.
subroutine loop_jumps(n, handle, indices, status)
    use, intrinsic :: iso_c_binding, only: c_int, c_int64_t
    use mdrcontact_address, only: to_pointer
    use mdrcontact_api_adhesion, only: mdr_loop_jumps
    implicit none (type, external)
    !f2py threadsafe
    integer(c_int), intent(in) :: n
    integer(c_int64_t), intent(in) :: handle
    integer(c_int), intent(out) :: indices(n)
    integer(c_int), intent(out) :: status

    status = mdr_loop_jumps(to_pointer(handle), n, indices)
end subroutine loop_jumps

!> See mdr_loop_dissipated_energy.
subroutine loop_dissipated_energy(handle, energy, status)
    use, intrinsic :: iso_c_binding, only: c_double, c_int, c_int64_t
    use mdrcontact_address, only: to_pointer
    use mdrcontact_api_adhesion, only: mdr_loop_dissipated_energy
    implicit none (type, external)
    !f2py threadsafe
    integer(c_int64_t), intent(in) :: handle
    real(c_double), intent(out) :: energy
    integer(c_int), intent(out) :: status

    status = mdr_loop_dissipated_energy(to_pointer(handle), energy)
end subroutine loop_dissipated_energy

!> See mdr_loop_free.
subroutine loop_free(handle, status)
    use, intrinsic :: iso_c_binding, only: c_int, c_int64_t, c_ptr
    use mdrcontact_address, only: to_pointer
    use mdrcontact_api_adhesion, only: mdr_loop_free
    implicit none (type, external)
    integer(c_int64_t), intent(in) :: handle
    integer(c_int), intent(out) :: status
    type(c_ptr) :: object

    object = to_pointer(handle)
    status = mdr_loop_free(object)
end subroutine loop_free
