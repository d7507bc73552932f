! SPDX-License-Identifier: GPL-3.0-or-later
!> The contacts that rows of tests/data/wear.csv speak of.
module wear_rows
    use mdrcontact, only: contact_t, error_t, homogeneous_t, layered_exact_t, material_t, new_contact, &
                          new_homogeneous_from_modulus, new_layered_exact, profile_t, wp
    implicit none (type, external)
    private
    public :: press_on_row

contains

    !> An indenter on the body that a row names: homogeneous, or a film with h = 1, nu = 0.3, E0* = 1.
    subroutine press_on_row(row, profile, contact)
        character(len=*), intent(in) :: row
        class(profile_t), intent(in) :: profile
        type(contact_t), intent(out) :: contact
        type(homogeneous_t) :: body
        type(layered_exact_t) :: film
        type(error_t), allocatable :: error
        real(wp), parameter :: e0 = 0.91_wp

        if (index(row, "G0/G1=10") > 0) then
            call new_layered_exact(film, [material_t(e0, 0.3_wp)], [1.0_wp], material_t(e0/10.0_wp, 0.3_wp), error)
        else if (index(row, "rigid base nu=.4") > 0) then
            call new_layered_exact(film, [material_t(0.84_wp, 0.4_wp)], [1.0_wp], material_t(1.0_wp, 0.3_wp), error, &
                                   rigid_base=.true.)
        else if (index(row, "film") > 0) then
            call new_layered_exact(film, [material_t(e0, 0.3_wp)], [1.0_wp], material_t(e0*10.0_wp, 0.3_wp), error)
        else
            call new_homogeneous_from_modulus(body, 1.0_wp, error)
            call new_contact(contact, profile, body, error)
            return
        end if
        call new_contact(contact, profile, film, error)
    end subroutine press_on_row

end module wear_rows
