! SPDX-License-Identifier: GPL-3.0-or-later
! Profiles with closed forms, flat for f2py.

!> See mdr_profile_paraboloid.
subroutine profile_paraboloid(radius, handle, status)
    use, intrinsic :: iso_c_binding, only: c_double, c_int, c_int64_t, c_null_ptr, c_ptr
    use mdrcontact_address, only: to_address
    use mdrcontact_api_profile, only: mdr_profile_paraboloid
    implicit none (type, external)
    real(c_double), intent(in) :: radius
    integer(c_int64_t), intent(out) :: handle
    integer(c_int), intent(out) :: status
    type(c_ptr) :: object

    object = c_null_ptr
    status = mdr_profile_paraboloid(radius, object)
    handle = to_address(object)
end subroutine profile_paraboloid

!> See mdr_profile_sphere.
subroutine profile_sphere(radius, handle, status)
    use, intrinsic :: iso_c_binding, only: c_double, c_int, c_int64_t, c_null_ptr, c_ptr
    use mdrcontact_address, only: to_address
    use mdrcontact_api_profile, only: mdr_profile_sphere
    implicit none (type, external)
    real(c_double), intent(in) :: radius
    integer(c_int64_t), intent(out) :: handle
    integer(c_int), intent(out) :: status
    type(c_ptr) :: object

    object = c_null_ptr
    status = mdr_profile_sphere(radius, object)
    handle = to_address(object)
end subroutine profile_sphere

!> See mdr_profile_cone.
subroutine profile_cone(inclination, handle, status)
    use, intrinsic :: iso_c_binding, only: c_double, c_int, c_int64_t, c_null_ptr, c_ptr
    use mdrcontact_address, only: to_address
    use mdrcontact_api_profile, only: mdr_profile_cone
    implicit none (type, external)
    real(c_double), intent(in) :: inclination
    integer(c_int64_t), intent(out) :: handle
    integer(c_int), intent(out) :: status
    type(c_ptr) :: object

    object = c_null_ptr
    status = mdr_profile_cone(inclination, object)
    handle = to_address(object)
end subroutine profile_cone

!> See mdr_profile_power.
subroutine profile_power(exponent, coefficient, handle, status)
    use, intrinsic :: iso_c_binding, only: c_double, c_int, c_int64_t, c_null_ptr, c_ptr
    use mdrcontact_address, only: to_address
    use mdrcontact_api_profile, only: mdr_profile_power
    implicit none (type, external)
    real(c_double), intent(in) :: exponent, coefficient
    integer(c_int64_t), intent(out) :: handle
    integer(c_int), intent(out) :: status
    type(c_ptr) :: object

    object = c_null_ptr
    status = mdr_profile_power(exponent, coefficient, object)
    handle = to_address(object)
end subroutine profile_power

!> See mdr_profile_flat_punch.
subroutine profile_flat_punch(radius, handle, status)
    use, intrinsic :: iso_c_binding, only: c_double, c_int, c_int64_t, c_null_ptr, c_ptr
    use mdrcontact_address, only: to_address
    use mdrcontact_api_profile, only: mdr_profile_flat_punch
    implicit none (type, external)
    real(c_double), intent(in) :: radius
    integer(c_int64_t), intent(out) :: handle
    integer(c_int), intent(out) :: status
    type(c_ptr) :: object

    object = c_null_ptr
    status = mdr_profile_flat_punch(radius, object)
    handle = to_address(object)
end subroutine profile_flat_punch

!> See mdr_profile_flat_cone.
subroutine profile_flat_cone(end_radius, inclination, handle, status)
    use, intrinsic :: iso_c_binding, only: c_double, c_int, c_int64_t, c_null_ptr, c_ptr
    use mdrcontact_address, only: to_address
    use mdrcontact_api_profile, only: mdr_profile_flat_cone
    implicit none (type, external)
    real(c_double), intent(in) :: end_radius, inclination
    integer(c_int64_t), intent(out) :: handle
    integer(c_int), intent(out) :: status
    type(c_ptr) :: object

    object = c_null_ptr
    status = mdr_profile_flat_cone(end_radius, inclination, object)
    handle = to_address(object)
end subroutine profile_flat_cone

!> See mdr_profile_flat_paraboloid.
subroutine profile_flat_paraboloid(end_radius, radius, handle, status)
    use, intrinsic :: iso_c_binding, only: c_double, c_int, c_int64_t, c_null_ptr, c_ptr
    use mdrcontact_address, only: to_address
    use mdrcontact_api_profile, only: mdr_profile_flat_paraboloid
    implicit none (type, external)
    real(c_double), intent(in) :: end_radius, radius
    integer(c_int64_t), intent(out) :: handle
    integer(c_int), intent(out) :: status
    type(c_ptr) :: object

    object = c_null_ptr
    status = mdr_profile_flat_paraboloid(end_radius, radius, object)
    handle = to_address(object)
end subroutine profile_flat_paraboloid

!> See mdr_profile_rounded_cone.
subroutine profile_rounded_cone(blend_radius, inclination, handle, status)
    use, intrinsic :: iso_c_binding, only: c_double, c_int, c_int64_t, c_null_ptr, c_ptr
    use mdrcontact_address, only: to_address
    use mdrcontact_api_profile, only: mdr_profile_rounded_cone
    implicit none (type, external)
    real(c_double), intent(in) :: blend_radius, inclination
    integer(c_int64_t), intent(out) :: handle
    integer(c_int), intent(out) :: status
    type(c_ptr) :: object

    object = c_null_ptr
    status = mdr_profile_rounded_cone(blend_radius, inclination, object)
    handle = to_address(object)
end subroutine profile_rounded_cone
