! SPDX-License-Identifier: GPL-3.0-or-later
!> Responses of a gel, in the units of the caller: theory/poroelastic.md (5.1)-(5.6).
module mdrcontact_poroelastic_response
    use mdrcontact_codes, only: creep, mean_creep, mean_relaxation, paraboloid => paraboloid_relaxation, pore_pressure, &
                                relaxation, total_pressure
    use mdrcontact_error, only: check_code, check_made, check_not_negative, check_positive, error_domain, error_t, raise, &
                                raise_at, to_text
    use mdrcontact_kinds, only: pi, wp
    use mdrcontact_poroelastic_answers, only: loss, storage
    use mdrcontact_poroelastic_contact, only: flat, parabolic
    use mdrcontact_poroelastic_pressure, only: gel_pressure
    use mdrcontact_poroelastic_table, only: poroelastic_t
    implicit none (type, external)
    private
    public :: poroelastic_response, poroelastic_dynamic_stiffness, poroelastic_pressure
    public :: relaxation, creep, paraboloid, mean_relaxation, mean_creep, total_pressure, pore_pressure

    !> The responses in the order of the table's columns.
    integer, parameter :: columns(*) = [relaxation, creep, paraboloid, mean_relaxation, mean_creep]

    !> Smallest D t/a^2 of a pressure.
    real(wp), parameter :: shortest_pressure = 1.0e-5_wp

contains

    !> Force per depth [modulus length] after a step of the depth, of a flat punch (relaxation) or of a paraboloid whose contact
    !> radius is held (paraboloid), or depth per force of a punch after a step of the force (creep).
    subroutine poroelastic_response(table, answer, shear_modulus, diffusivity, radius, time, values, error)
        type(poroelastic_t), intent(in) :: table
        !> relaxation, creep, paraboloid, mean_relaxation or mean_creep
        integer, intent(in) :: answer
        !> > 0 [modulus], [length^2/time], [length]
        real(wp), intent(in) :: shear_modulus, diffusivity, radius
        !> >= 0 [time]
        real(wp), intent(in) :: time(:)
        !> same size as time
        real(wp), intent(out) :: values(:)
        type(error_t), allocatable, intent(out) :: error
        real(wp) :: scale
        integer :: i

        values = 0.0_wp
        call check_made(error, "table", table%is_made)
        if (allocated(error)) return
        call check_code(error, "answer", answer, columns)
        call check_units(shear_modulus, diffusivity, radius, error)
        if (allocated(error)) return
        scale = 8.0_wp*shear_modulus*radius
        if (answer == creep .or. answer == mean_creep) scale = 1.0_wp/scale
        if (answer == paraboloid) scale = scale*2.0_wp/3.0_wp
        do i = 1, size(time)
            if (.not. time(i) >= 0.0_wp) call check_not_negative(error, "time", time(i), i)
            if (.not. allocated(error)) then
                call table%value(findloc(columns, answer, dim=1), diffusivity*time(i)/radius**2, values(i), error)
            end if
            if (allocated(error)) then
                if (error%entry == 0) call raise_at(error, i)
                return
            end if
        end do
        values = scale*values
    end subroutine poroelastic_response

    !> k' + i k'' of a flat punch, or of small oscillations of a contact of this radius [modulus length].
    subroutine poroelastic_dynamic_stiffness(table, shear_modulus, diffusivity, radius, omega, values, error)
        type(poroelastic_t), intent(in) :: table
        !> > 0 [modulus], [length^2/time], [length]
        real(wp), intent(in) :: shear_modulus, diffusivity, radius
        !> > 0 [1/time]
        real(wp), intent(in) :: omega(:)
        !> same size as omega
        complex(wp), intent(out) :: values(:)
        type(error_t), allocatable, intent(out) :: error
        real(wp) :: parts(2), tau
        integer :: i

        values = 0.0_wp
        call check_made(error, "table", table%is_made)
        if (allocated(error)) return
        call check_units(shear_modulus, diffusivity, radius, error)
        do i = 1, size(omega)
            call check_positive(error, "omega", omega(i), i)
            if (allocated(error)) return
            tau = diffusivity/(omega(i)*radius**2)
            call table%value(storage, tau, parts(1), error)
            if (.not. allocated(error)) call table%value(loss, tau, parts(2), error)
            if (allocated(error)) return
            values(i) = 8.0_wp*shear_modulus*radius*cmplx(parts(1), parts(2), wp)
        end do
    end subroutine poroelastic_dynamic_stiffness

    !> Pressure per depth [modulus/length] at radii under an indenter pressed in at time 0, its contact radius being held.
    subroutine poroelastic_pressure(table, kind, is_flat, shear_modulus, diffusivity, radius, time, r, values, error)
        type(poroelastic_t), intent(in) :: table
        !> total_pressure or pore_pressure
        integer, intent(in) :: kind
        !> a flat punch; else a paraboloid
        logical, intent(in) :: is_flat
        !> time such that D t/a^2 >= 1e-5: earlier, the pressure differs from that of the undrained body at the edge alone
        real(wp), intent(in) :: shear_modulus, diffusivity, radius, time
        !> 0 <= r < radius [length]
        real(wp), intent(in) :: r(:)
        !> same size as r
        real(wp), intent(out) :: values(:)
        type(error_t), allocatable, intent(out) :: error
        real(wp) :: tau
        integer :: i

        values = 0.0_wp
        call check_made(error, "table", table%is_made)
        if (allocated(error)) return
        call check_code(error, "kind", kind, [total_pressure, pore_pressure])
        call check_units(shear_modulus, diffusivity, radius, error)
        call check_positive(error, "time", time)
        do i = 1, size(r)
            call check_not_negative(error, "r", r(i), i)
            if (allocated(error)) return
            if (r(i) < radius) cycle
            call raise(error, error_domain, " = "//to_text(r(i))//": it must be less than the contact radius "//to_text(radius), &
                       "r", i)
        end do
        if (allocated(error)) return
        tau = diffusivity*time/radius**2
        if (tau < shortest_pressure) then
            call raise(error, error_domain, " = "//to_text(time)//": D t/a^2 must be at least "//to_text(shortest_pressure), "time")
            return
        end if
        call gel_pressure(table%gel, merge(flat, parabolic, is_flat), kind == pore_pressure, tau, r/radius, values, error)
        values = 4.0_wp*shear_modulus/(pi*radius)*values
    end subroutine poroelastic_pressure

    pure subroutine check_units(shear_modulus, diffusivity, radius, error)
        real(wp), intent(in) :: shear_modulus, diffusivity, radius
        type(error_t), allocatable, intent(inout) :: error

        call check_positive(error, "shear_modulus", shear_modulus)
        call check_positive(error, "diffusivity", diffusivity)
        call check_positive(error, "radius", radius)
    end subroutine check_units

end module mdrcontact_poroelastic_response
