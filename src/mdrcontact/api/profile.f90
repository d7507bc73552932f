! SPDX-License-Identifier: GPL-3.0-or-later
!> Indenter profiles with closed forms, for C.
module mdrcontact_api_profile
    use, intrinsic :: iso_c_binding, only: c_double, c_int, c_ptr
    use mdrcontact_api_handles, only: deliver_profile
    use mdrcontact_error, only: error_t
    use mdrcontact_profile_power_law, only: new_cone, new_paraboloid, new_power_law, power_law_t
    implicit none (type, external)
    private
    public :: mdr_profile_paraboloid, mdr_profile_cone, mdr_profile_power

contains

    function mdr_profile_paraboloid(radius, out) result(status) bind(C)
        real(c_double), value :: radius
        type(c_ptr), intent(inout), optional :: out
        integer(c_int) :: status
        type(power_law_t) :: profile
        type(error_t), allocatable :: error

        call new_paraboloid(profile, radius, error)
        status = deliver_profile(profile, out, error)
    end function mdr_profile_paraboloid

    function mdr_profile_cone(inclination, out) result(status) bind(C)
        real(c_double), value :: inclination
        type(c_ptr), intent(inout), optional :: out
        integer(c_int) :: status
        type(power_law_t) :: profile
        type(error_t), allocatable :: error

        call new_cone(profile, inclination, error)
        status = deliver_profile(profile, out, error)
    end function mdr_profile_cone

    function mdr_profile_power(exponent, coefficient, out) result(status) bind(C)
        real(c_double), value :: exponent, coefficient
        type(c_ptr), intent(inout), optional :: out
        integer(c_int) :: status
        type(power_law_t) :: profile
        type(error_t), allocatable :: error

        call new_power_law(profile, exponent, coefficient, error)
        status = deliver_profile(profile, out, error)
    end function mdr_profile_power

end module mdrcontact_api_profile
