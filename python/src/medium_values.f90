! SPDX-License-Identifier: GPL-3.0-or-later
! Default options, values and end of a medium, flat for f2py.

!> The defaults that mdr_medium_options_init sets.
subroutine medium_default_options(alpha, wave_factor, weight_nu_choice, weight_nu, tolerance)
    use, intrinsic :: iso_c_binding, only: c_double, c_int
    use mdrcontact_api_medium_options, only: mdr_medium_options_init, medium_options_t
    implicit none (type, external)
    real(c_double), intent(out) :: alpha, wave_factor
    integer(c_int), intent(out) :: weight_nu_choice
    real(c_double), intent(out) :: weight_nu, tolerance
    type(medium_options_t) :: options

    call mdr_medium_options_init(options)
    alpha = options%alpha
    wave_factor = options%wave_factor
    weight_nu_choice = options%weight_nu_choice
    weight_nu = options%weight_nu
    tolerance = options%tolerance
end subroutine medium_default_options

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
