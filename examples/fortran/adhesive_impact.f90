! SPDX-License-Identifier: GPL-3.0-or-later
!> A small glass bead strikes a soft coating that it sticks to: the contact closes at first touch, but opens only at pull-off, and
!> what lies between is the energy that adhesion takes. The compiled law keeps that history in one integer of the caller.
!>
!> SI units. Glass bead R = 50 um, density 2500 kg/m^3; PDMS E = 2 MPa, nu = 0.49, 100 um, on glass E = 70 GPa, nu = 0.22;
!> work of adhesion 50 mJ/m^2 (typical values).
program adhesive_impact
    use mdrcontact, only: contact_law_t, contact_options_t, contact_t, error_t, law_point_t, layered_exact_t, material_t, &
                          new_contact, new_contact_law, new_layered_exact, new_material, new_paraboloid, power_law_t, wp
    implicit none (type, external)

    real(wp), parameter :: radius = 50.0e-6_wp, work_of_adhesion = 0.05_wp, speed = 0.2_wp, step = 2.0e-9_wp
    real(wp), parameter :: pi = acos(-1.0_wp), mass = 4.0_wp/3.0_wp*pi*radius**3*2500.0_wp
    type(contact_law_t) :: law
    type(law_point_t) :: point
    type(error_t), allocatable :: error
    real(wp) :: d, v, force, energy_before, deepest
    integer :: segment, steps

    call bead_on_pdms(law)
    print "(a, i0, a, es7.0)", "law from ", law%solutions, " contact states, relative error ", law%error
    d = -0.1e-6_wp
    v = speed
    energy_before = 0.5_wp*mass*v**2
    force = 0.0_wp
    deepest = 0.0_wp
    segment = 0
    steps = 0
    ! Velocity Verlet, without gravity: d grows into the coating.
    do while (d > -0.5e-6_wp)
        v = v - 0.5_wp*step*force/mass
        d = d + step*v
        call law%follow(d, segment, point, error)
        call stop_on(error)
        force = point%force
        v = v - 0.5_wp*step*force/mass
        deepest = max(deepest, d)
        steps = steps + 1
        if (modulo(steps, 1000) == 0) print "(a, f7.2, a, f8.4, a, f9.4, a, i0)", "t = ", 1.0e6_wp*steps*step, " us   d = ", &
            1.0e6_wp*d, " um   F = ", 1.0e6_wp*force, " uN   segment ", segment
        if (steps > 1000000) exit
    end do
    print "(a, f7.4, a, f7.4, a)", "deepest ", 1.0e6_wp*deepest, " um; pull-off at d = ", 1.0e6_wp*law%by_depth%lowest, " um"
    print "(a, f8.5, a, f6.3)", "rebound ", -v, " m/s, coefficient of restitution ", -v/speed
    call balance(energy_before, 0.5_wp*mass*v**2, dissipated(law))

contains

    !> Energy before, after, and what the law's two branches enclose: the work that loading does less what unloading gives back.
    subroutine balance(before, after, lost)
        real(wp), intent(in) :: before, after, lost

        print "(a, es12.5, a)", "energy before             ", before, " J"
        print "(a, es12.5, a)", "energy after              ", after, " J"
        print "(a, es12.5, a)", "enclosed by the branches  ", lost, " J"
        print "(a, es9.1)", "balance, relative to the energy before", (after + lost)/before - 1.0_wp
        if (abs((after + lost)/before - 1.0_wp) > 1.0e-3_wp) error stop "the energy does not balance"
    end subroutine balance

    !> int F dd along the branch from pull-off to d = 0, which only the way out takes; negative force, hence energy lost.
    function dissipated(law) result(energy)
        type(contact_law_t), intent(in) :: law
        real(wp) :: energy
        type(law_point_t) :: at
        integer, parameter :: n = 20000
        integer :: i
        real(wp) :: t

        ! d = d0 (1 - t^2) takes the infinite slope at pull-off d0 away.
        energy = 0.0_wp
        do i = 1, n
            t = (i - 0.5_wp)/n
            call law%at_depth(law%by_depth%lowest*(1.0_wp - t**2), at, error)
            call stop_on(error)
            energy = energy + at%force*2.0_wp*t*law%by_depth%lowest/n
        end do
    end function dissipated

    subroutine bead_on_pdms(law)
        type(contact_law_t), intent(out) :: law
        type(material_t) :: pdms, glass
        type(layered_exact_t) :: coated
        type(power_law_t) :: bead
        type(contact_t) :: contact
        type(contact_options_t) :: options

        call new_material(pdms, 2.0e6_wp, 0.49_wp, error)
        call stop_on(error)
        call new_material(glass, 70.0e9_wp, 0.22_wp, error)
        call stop_on(error)
        call new_layered_exact(coated, [pdms], [100.0e-6_wp], glass, error)
        call stop_on(error)
        call new_paraboloid(bead, radius, error)
        call stop_on(error)
        options%work_of_adhesion = work_of_adhesion
        call new_contact(contact, bead, coated, error, options)
        call stop_on(error)
        call new_contact_law(law, contact, 10.0e-6_wp, error)
        call stop_on(error)
    end subroutine bead_on_pdms

    subroutine stop_on(error)
        type(error_t), allocatable, intent(in) :: error

        if (.not. allocated(error)) return
        print "(a)", error%message
        error stop
    end subroutine stop_on

end program adhesive_impact
