! SPDX-License-Identifier: GPL-3.0-or-later
!> Indenter profiles with closed forms, for C. Written by tools/generate.py.
module mdrcontact_api_profile
    use, intrinsic :: iso_c_binding, only: c_double, c_int, c_ptr
    use mdrcontact_api_handles, only: deliver
    use mdrcontact_error, only: error_t
    use mdrcontact_profile_flat_cone, only: flat_cone_t, new_flat_cone
    use mdrcontact_profile_flat_paraboloid, only: flat_paraboloid_t, new_flat_paraboloid
    use mdrcontact_profile_flat_punch, only: flat_punch_t, new_flat_punch
    use mdrcontact_profile_power_law, only: new_cone, new_paraboloid, new_power_law, power_law_t
    use mdrcontact_profile_rounded_cone, only: new_rounded_cone, rounded_cone_t
    use mdrcontact_profile_sphere, only: new_sphere, sphere_t
    implicit none (type, external)
    private
    public :: mdr_profile_paraboloid
    public :: mdr_profile_sphere
    public :: mdr_profile_cone
    public :: mdr_profile_power
    public :: mdr_profile_flat_punch
    public :: mdr_profile_flat_cone
    public :: mdr_profile_flat_paraboloid
    public :: mdr_profile_rounded_cone

contains

    function mdr_profile_paraboloid(radius, out) result(status) &
        bind(C, name="mdrcontact_entry_profile_paraboloid")
        real(c_double), value :: radius
        type(c_ptr), intent(inout), optional :: out
        integer(c_int) :: status
        type(power_law_t) :: profile
        type(error_t), allocatable :: error

        call new_paraboloid(profile, radius, error)
        status = deliver(profile, out, error)
    end function mdr_profile_paraboloid

    function mdr_profile_sphere(radius, out) result(status) &
        bind(C, name="mdrcontact_entry_profile_sphere")
        real(c_double), value :: radius
        type(c_ptr), intent(inout), optional :: out
        integer(c_int) :: status
        type(sphere_t) :: profile
        type(error_t), allocatable :: error

        call new_sphere(profile, radius, error)
        status = deliver(profile, out, error)
    end function mdr_profile_sphere

    function mdr_profile_cone(inclination, out) result(status) &
        bind(C, name="mdrcontact_entry_profile_cone")
        real(c_double), value :: inclination
        type(c_ptr), intent(inout), optional :: out
        integer(c_int) :: status
        type(power_law_t) :: profile
        type(error_t), allocatable :: error

        call new_cone(profile, inclination, error)
        status = deliver(profile, out, error)
    end function mdr_profile_cone

    function mdr_profile_power(exponent, coefficient, out) result(status) &
        bind(C, name="mdrcontact_entry_profile_power")
        real(c_double), value :: exponent, coefficient
        type(c_ptr), intent(inout), optional :: out
        integer(c_int) :: status
        type(power_law_t) :: profile
        type(error_t), allocatable :: error

        call new_power_law(profile, exponent, coefficient, error)
        status = deliver(profile, out, error)
    end function mdr_profile_power

    function mdr_profile_flat_punch(radius, out) result(status) &
        bind(C, name="mdrcontact_entry_profile_flat_punch")
        real(c_double), value :: radius
        type(c_ptr), intent(inout), optional :: out
        integer(c_int) :: status
        type(flat_punch_t) :: profile
        type(error_t), allocatable :: error

        call new_flat_punch(profile, radius, error)
        status = deliver(profile, out, error)
    end function mdr_profile_flat_punch

    function mdr_profile_flat_cone(end_radius, inclination, out) result(status) &
        bind(C, name="mdrcontact_entry_profile_flat_cone")
        real(c_double), value :: end_radius, inclination
        type(c_ptr), intent(inout), optional :: out
        integer(c_int) :: status
        type(flat_cone_t) :: profile
        type(error_t), allocatable :: error

        call new_flat_cone(profile, end_radius, inclination, error)
        status = deliver(profile, out, error)
    end function mdr_profile_flat_cone

    function mdr_profile_flat_paraboloid(end_radius, radius, out) result(status) &
        bind(C, name="mdrcontact_entry_profile_flat_paraboloid")
        real(c_double), value :: end_radius, radius
        type(c_ptr), intent(inout), optional :: out
        integer(c_int) :: status
        type(flat_paraboloid_t) :: profile
        type(error_t), allocatable :: error

        call new_flat_paraboloid(profile, end_radius, radius, error)
        status = deliver(profile, out, error)
    end function mdr_profile_flat_paraboloid

    function mdr_profile_rounded_cone(blend_radius, inclination, out) result(status) &
        bind(C, name="mdrcontact_entry_profile_rounded_cone")
        real(c_double), value :: blend_radius, inclination
        type(c_ptr), intent(inout), optional :: out
        integer(c_int) :: status
        type(rounded_cone_t) :: profile
        type(error_t), allocatable :: error

        call new_rounded_cone(profile, blend_radius, inclination, error)
        status = deliver(profile, out, error)
    end function mdr_profile_rounded_cone

end module mdrcontact_api_profile
