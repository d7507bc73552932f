! SPDX-License-Identifier: GPL-3.0-or-later
!> A Berkovich tip on 2 um of titanium nitride on steel: what modulus an indenter sees as it goes deeper.
!>
!> Units of this program: um, GPa, and hence mN (1 GPa um^2 = 1 mN). The library takes any consistent set.
!> TiN: E = 450 GPa, nu = 0.25; hardened steel: E = 210 GPa, nu = 0.3 (handbook values). The tip is rigid and stands for
!> the Berkovich pyramid as the cone of the same projected area, half-angle 70.30 degrees.
program berkovich_on_tin
    use, intrinsic :: iso_fortran_env, only: error_unit, output_unit
    use mdrcontact, only: contact_state_t, contact_t, error_t, layered_exact_t, material_t, new_cone, new_contact, &
                          new_layered_exact, new_material, power_law_t, wp
    implicit none (type, external)
    real(wp), parameter :: degree = acos(-1.0_wp)/180.0_wp
    real(wp), parameter :: depths(*) = [0.01_wp, 0.05_wp, 0.1_wp, 0.2_wp, 0.5_wp, 1.0_wp, 2.0_wp]
    type(material_t) :: tin, steel
    type(power_law_t) :: tip
    type(layered_exact_t) :: coated
    type(contact_t) :: contact
    type(contact_state_t) :: state
    type(error_t), allocatable :: error
    real(wp) :: modulus(1)
    integer :: i

    call new_material(tin, 450.0_wp, 0.25_wp, error)
    call check(error)
    call new_material(steel, 210.0_wp, 0.30_wp, error)
    call check(error)
    call new_cone(tip, (90.0_wp - 70.30_wp)*degree, error)
    call check(error)
    call new_layered_exact(coated, [tin], [2.0_wp], steel, error)
    call check(error)
    call new_contact(contact, tip, coated, error)
    call check(error)

    write (output_unit, "(a)") "   depth, um   radius, um    force, mN   E_eff, GPa"
    do i = 1, size(depths)
        call contact%at_depth(depths(i), state, error)
        call check(error)
        call coated%modulus([state%radius], modulus, error)
        call check(error)
        write (output_unit, "(4f13.4)") state%depth, state%radius, state%force, modulus
    end do

contains

    !> Prints the library's words and ends the program; the library itself never does either.
    subroutine check(error)
        type(error_t), allocatable, intent(in) :: error

        if (.not. allocated(error)) return
        write (error_unit, "(a)") error%message
        error stop 1
    end subroutine check

end program berkovich_on_tin
