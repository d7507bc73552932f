! SPDX-License-Identifier: GPL-3.0-or-later
! A contact, its states and its end, flat for f2py.

!> See mdr_contact_new; zeta_count = 0 for zeta = 1. (f2py takes no empty arrays: the table then holds one unused entry.)
subroutine contact_new(profile, medium, zeta_count, n, zeta_radius, zeta, work_of_adhesion, adhesion_rule, handle, status)
    use, intrinsic :: iso_c_binding, only: c_double, c_int, c_int64_t, c_loc, c_null_ptr, c_ptr
    use mdrcontact_address, only: to_address, to_pointer
    use mdrcontact_api_contact, only: c_contact_options_t, mdr_contact_new
    implicit none (type, external)
    !f2py threadsafe
    integer(c_int), intent(in) :: zeta_count, n, adhesion_rule
    integer(c_int64_t), intent(in) :: profile, medium
    real(c_double), intent(in), target :: zeta_radius(n), zeta(n)
    real(c_double), intent(in) :: work_of_adhesion
    integer(c_int64_t), intent(out) :: handle
    integer(c_int), intent(out) :: status
    type(c_contact_options_t) :: options
    type(c_ptr) :: object

    object = c_null_ptr
    options%work_of_adhesion = work_of_adhesion
    options%adhesion_rule = adhesion_rule
    if (zeta_count > 0) then
        options%zeta_count = zeta_count
        options%zeta_radius = c_loc(zeta_radius)
        options%zeta = c_loc(zeta)
    end if
    status = mdr_contact_new(to_pointer(profile), to_pointer(medium), options, object)
    handle = to_address(object)
end subroutine contact_new

!> See mdr_contact_from_depth_on.
subroutine contact_from_depth(n, threads, handle, branch, given, d, a, F, k, status)
    use, intrinsic :: iso_c_binding, only: c_double, c_int, c_int64_t
    use mdrcontact_address, only: to_pointer
    use mdrcontact_api_contact, only: mdr_contact_from_depth_on_threads
    implicit none (type, external)
    !f2py threadsafe
    integer(c_int), intent(in) :: n, threads, branch
    integer(c_int64_t), intent(in) :: handle
    real(c_double), intent(in) :: given(n)
    real(c_double), intent(out) :: d(n), a(n), F(n), k(n)
    integer(c_int), intent(out) :: status

    status = mdr_contact_from_depth_on_threads(to_pointer(handle), branch, n, given, d, a, F, k, threads)
end subroutine contact_from_depth

!> See mdr_contact_from_force_on.
subroutine contact_from_force(n, threads, handle, branch, given, d, a, F, k, status)
    use, intrinsic :: iso_c_binding, only: c_double, c_int, c_int64_t
    use mdrcontact_address, only: to_pointer
    use mdrcontact_api_contact, only: mdr_contact_from_force_on_threads
    implicit none (type, external)
    !f2py threadsafe
    integer(c_int), intent(in) :: n, threads, branch
    integer(c_int64_t), intent(in) :: handle
    real(c_double), intent(in) :: given(n)
    real(c_double), intent(out) :: d(n), a(n), F(n), k(n)
    integer(c_int), intent(out) :: status

    status = mdr_contact_from_force_on_threads(to_pointer(handle), branch, n, given, d, a, F, k, threads)
end subroutine contact_from_force

!> See mdr_contact_from_radius.
subroutine contact_from_radius(n, threads, handle, given, d, a, F, k, status)
    use, intrinsic :: iso_c_binding, only: c_double, c_int, c_int64_t
    use mdrcontact_address, only: to_pointer
    use mdrcontact_api_contact, only: mdr_contact_from_radius_threads
    implicit none (type, external)
    !f2py threadsafe
    integer(c_int), intent(in) :: n, threads
    integer(c_int64_t), intent(in) :: handle
    real(c_double), intent(in) :: given(n)
    real(c_double), intent(out) :: d(n), a(n), F(n), k(n)
    integer(c_int), intent(out) :: status

    status = mdr_contact_from_radius_threads(to_pointer(handle), n, given, d, a, F, k, threads)
end subroutine contact_from_radius

!> See mdr_contact_free.
subroutine contact_free(handle, status)
    use, intrinsic :: iso_c_binding, only: c_int, c_int64_t, c_ptr
    use mdrcontact_address, only: to_pointer
    use mdrcontact_api_handles, only: mdr_contact_free
    implicit none (type, external)
    integer(c_int64_t), intent(in) :: handle
    integer(c_int), intent(out) :: status
    type(c_ptr) :: object

    object = to_pointer(handle)
    status = mdr_contact_free(object)
end subroutine contact_free
