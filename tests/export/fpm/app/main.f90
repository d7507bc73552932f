! SPDX-License-Identifier: GPL-3.0-or-later
!> A program of an fpm project that depends on mdrcontact, the C layer included.
program main
    use, intrinsic :: iso_c_binding, only: c_int
    use, intrinsic :: iso_fortran_env, only: error_unit, output_unit
    use mdrcontact, only: contact_state_t, contact_t, error_t, homogeneous_t, new_contact, new_homogeneous_from_modulus, &
                          new_paraboloid, power_law_t, wp
    implicit none (type, external)
    type(power_law_t) :: indenter
    type(homogeneous_t) :: body
    type(contact_t) :: contact
    type(contact_state_t) :: state
    type(error_t), allocatable :: error

    interface
        function mdr_version() result(version) bind(C)
            import :: c_int
            integer(c_int) :: version
        end function mdr_version
    end interface

    call new_paraboloid(indenter, 2.0_wp, error)
    call check()
    call new_homogeneous_from_modulus(body, 3.0_wp, error)
    call check()
    call new_contact(contact, indenter, body, error)
    call check()
    call contact%at_depth(0.5_wp, state, error)
    call check()
    if (abs(state%force - 4.0_wp*sqrt(2.0_wp)*0.5_wp**1.5_wp) > 1.0e-12_wp .or. mdr_version() <= 0) then
        write (error_unit, "(a)") "not Hertz's force"
        error stop 1
    end if
    write (output_unit, "(a)") "fpm: 1 check passed"

contains

    subroutine check()
        if (.not. allocated(error)) return
        write (error_unit, "(a)") error%message
        error stop 1
    end subroutine check

end program main
