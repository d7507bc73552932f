! SPDX-License-Identifier: GPL-3.0-or-later
!> Hertz's force through the installed library.
program main
    use, intrinsic :: iso_fortran_env, only: error_unit, output_unit
    use mdrcontact, only: contact_state_t, contact_t, error_t, homogeneous_t, new_contact, new_homogeneous_from_modulus, &
                          new_paraboloid, power_law_t, wp
    implicit none (type, external)
    type(power_law_t) :: indenter
    type(homogeneous_t) :: body
    type(contact_t) :: contact
    type(contact_state_t) :: state
    type(error_t), allocatable :: error
    real(wp), parameter :: expected = 4.0_wp*sqrt(2.0_wp)*0.5_wp**1.5_wp

    call new_paraboloid(indenter, -2.0_wp, error)
    if (.not. allocated(error)) error stop "a negative radius was taken"
    call new_paraboloid(indenter, 2.0_wp, error)
    call check()
    call new_homogeneous_from_modulus(body, 3.0_wp, error)
    call check()
    call new_contact(contact, indenter, body, error)
    call check()
    call contact%at_depth(0.5_wp, state, error)
    call check()
    if (abs(state%force - expected) > 1.0e-12_wp*expected) then
        write (error_unit, "(2(a, es24.16))") "force ", state%force, ", expected ", expected
        error stop 1
    end if
    write (output_unit, "(a)") "Fortran: 2 checks passed"

contains

    subroutine check()
        if (.not. allocated(error)) return
        write (error_unit, "(a)") error%message
        error stop 1
    end subroutine check

end program main
