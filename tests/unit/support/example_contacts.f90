! SPDX-License-Identifier: GPL-3.0-or-later
!> Contacts that several tests look at.
module example_contacts
    use mdrcontact, only: contact_options_t, contact_t, error_t, flat_ended_t, flat_punch_t, gao_t, homogeneous_t, &
                          layered_exact_t, material_t, solver_t, new_cone, new_contact, new_flat_cone, new_flat_punch, new_gao, &
                          new_homogeneous_from_modulus, new_layered_exact, new_paraboloid, power_law_t, profile_t, wp
    implicit none (type, external)
    private
    public :: coated, cone_on_stiff_film, jkr, steep_profile

contains

    !> A paraboloid, R = 1 by default, on an incompressible coating, G0 = 3, G1 = 1, h = 1, by Gao's weights.
    subroutine coated(contact, work_of_adhesion, radius)
        type(contact_t), intent(out) :: contact
        real(wp), intent(in) :: work_of_adhesion
        real(wp), intent(in), optional :: radius
        type(gao_t) :: medium
        type(power_law_t) :: profile
        type(error_t), allocatable :: error

        call new_gao(medium, material_t(9.0_wp, 0.5_wp), 1.0_wp, material_t(3.0_wp, 0.5_wp), error)
        call new_paraboloid(profile, 1.0_wp, error)
        if (present(radius)) call new_paraboloid(profile, radius, error)
        call press(profile, medium, work_of_adhesion, contact)
    end subroutine coated

    !> A paraboloid, R = 1 by default, on a homogeneous body.
    subroutine jkr(contact, modulus, work_of_adhesion, radius)
        type(contact_t), intent(out) :: contact
        real(wp), intent(in) :: modulus, work_of_adhesion
        real(wp), intent(in), optional :: radius
        type(homogeneous_t) :: body
        type(power_law_t) :: profile
        type(error_t), allocatable :: error

        call new_homogeneous_from_modulus(body, modulus, error)
        call new_paraboloid(profile, 1.0_wp, error)
        if (present(radius)) call new_paraboloid(profile, radius, error)
        call press(profile, body, work_of_adhesion, contact)
    end subroutine jkr

    !> It has a small contact, carried by the film, and a large one, carried by the substrate.
    subroutine cone_on_stiff_film(contact, work_of_adhesion)
        type(contact_t), intent(out) :: contact
        real(wp), intent(in) :: work_of_adhesion
        type(layered_exact_t) :: film
        type(power_law_t) :: cone
        type(error_t), allocatable :: error

        call new_layered_exact(film, [material_t(100.0_wp, 0.3_wp)], [0.1_wp], material_t(1.0_wp, 0.3_wp), error)
        call new_cone(cone, 0.3_wp, error)
        call press(cone, film, work_of_adhesion, contact)
    end subroutine cone_on_stiff_film

    !> A flat cone, a punch, a cone, or a paraboloid, R = 1, as wide as they are high.
    subroutine steep_profile(name, profile)
        character(len=*), intent(in) :: name
        class(profile_t), allocatable, intent(out) :: profile
        type(power_law_t) :: power
        type(flat_ended_t) :: flat_cone
        type(flat_punch_t) :: punch
        type(error_t), allocatable :: error

        select case (name)
        case ("flat cone")
            call new_flat_cone(flat_cone, 0.5_wp, 0.6_wp, error)
            allocate (profile, source=flat_cone)
        case ("punch")
            call new_flat_punch(punch, 0.7_wp, error)
            allocate (profile, source=punch)
        case default
            call new_paraboloid(power, 1.0_wp, error)
            if (name == "cone") call new_cone(power, 0.6_wp, error)
            allocate (profile, source=power)
        end select
    end subroutine steep_profile

    subroutine press(profile, medium, work_of_adhesion, contact)
        type(power_law_t), intent(in) :: profile
        class(solver_t), intent(in) :: medium
        real(wp), intent(in) :: work_of_adhesion
        type(contact_t), intent(out) :: contact
        type(contact_options_t) :: options
        type(error_t), allocatable :: error

        options%work_of_adhesion = work_of_adhesion
        call new_contact(contact, profile, medium, error, options)
        if (allocated(error)) error stop "the contact could not be made"
    end subroutine press

end module example_contacts
