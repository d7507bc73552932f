! SPDX-License-Identifier: GPL-3.0-or-later
!> Rows of the tables of contacts with friction, tests/data/tangential.csv and friction_history.csv.
module tangential_rows
    use mdrcontact_body_stack, only: new_stack, stack_t
    use mdrcontact_contact, only: contact_t, new_contact
    use mdrcontact_error, only: error_t
    use mdrcontact_kinds, only: wp
    use mdrcontact_layered_exact, only: layered_exact_t, new_layered_exact
    use mdrcontact_material, only: material_t
    use mdrcontact_medium, only: medium_t
    use mdrcontact_medium_homogeneous, only: homogeneous_t, new_homogeneous
    use mdrcontact_profile_power_law, only: new_cone, new_paraboloid, new_power_law, power_law_t
    implicit none (type, external)
    private
    public :: tangential_row_t, read_tangential_rows, new_row_contact

    real(wp), parameter :: eighth_turn = atan(1.0_wp)

    type :: tangential_row_t
        character(len=80) :: layers = "", base = "", profile = ""
        real(wp) :: base_poisson = 0.0_wp
        !> a (the layers' total thickness is 1), mu, s, s_slide, d, F, k_n, k_t, c, T, energy of a cycle, k_t(c)
        real(wp) :: radius = 0.0_wp, coefficient = 0.0_wp, part = 0.0_wp, shift = 0.0_wp, sliding_shift = 0.0_wp, depth = 0.0_wp
        real(wp) :: force = 0.0_wp, stiffness = 0.0_wp, tangential_stiffness = 0.0_wp, stick_radius = 0.0_wp
        real(wp) :: tangential_force = 0.0_wp, cycle_energy = 0.0_wp, slope = 0.0_wp
    end type tangential_row_t

contains

    !> All rows of tangential.csv.
    subroutine read_tangential_rows(path, rows)
        character(len=*), intent(in) :: path
        type(tangential_row_t), allocatable, intent(out) :: rows(:)
        type(tangential_row_t) :: row
        character(len=512) :: line
        character(len=80) :: words(5)
        real(wp) :: values(13)
        integer :: unit, status, i, from, comma

        allocate (rows(0))
        open (newunit=unit, file=path, action="read", status="old")
        do
            read (unit, "(a)", iostat=status) line
            if (status /= 0) exit
            if (line(1:1) == "#" .or. line(1:6) == "stack,") cycle
            from = 1
            do i = 1, 5
                comma = from + index(line(from:), ",") - 1
                words(i) = line(from:comma - 1)
                from = comma + 1
            end do
            read (line(from:), *) values
            row%layers = words(2)
            row%base = words(3)
            read (words(4), *) row%base_poisson
            row%profile = words(5)
            row%radius = values(1)
            row%coefficient = values(2)
            row%part = values(3)
            row%shift = values(4)
            row%sliding_shift = values(5)
            row%depth = values(6)
            row%force = values(7)
            row%stiffness = values(8)
            row%tangential_stiffness = values(9)
            row%stick_radius = values(10)
            row%tangential_force = values(11)
            row%cycle_energy = values(12)
            row%slope = values(13)
            rows = [rows, row]
        end do
        close (unit)
    end subroutine read_tangential_rows

    !> The contact of a row: layers "h:G:nu;..." from the surface down, "-" for none.
    subroutine new_row_contact(row, contact)
        type(tangential_row_t), intent(in) :: row
        type(contact_t), intent(out) :: contact
        class(medium_t), allocatable :: medium
        type(material_t) :: materials(8), substrate
        type(homogeneous_t) :: homogeneous
        type(layered_exact_t) :: exact
        type(stack_t) :: stack
        type(power_law_t) :: shape
        type(error_t), allocatable :: error
        real(wp) :: h(8), values(3), base
        character(len=len(row%layers)) :: part
        integer :: from, last, n, i
        logical :: rigid_base

        rigid_base = row%base == "inf"
        base = 1.0_wp
        if (.not. rigid_base) read (row%base, *) base
        substrate = material_t(2.0_wp*base*(1.0_wp + row%base_poisson), row%base_poisson)
        n = 0
        from = 1
        do while (from <= len_trim(row%layers) .and. row%layers /= "-")
            last = from + index(row%layers(from:)//";", ";") - 2
            part = row%layers(from:last)
            from = last + 2
            do i = 1, len(part)
                if (part(i:i) == ":") part(i:i) = " "
            end do
            read (part, *) values
            n = n + 1
            h(n) = values(1)
            materials(n) = material_t(2.0_wp*values(2)*(1.0_wp + values(3)), values(3))
        end do
        if (n == 0) then
            call new_homogeneous(homogeneous, substrate)
            allocate (medium, source=homogeneous)
        else
            call new_stack(stack, materials(:n), h(:n), substrate, error, rigid_base)
            if (.not. allocated(error)) call new_layered_exact(exact, stack, error)
            if (allocated(error)) error stop "a body of the table could not be made"
            allocate (medium, source=exact)
        end if
        select case (row%profile)
        case ("paraboloid f=r^2/2"); call new_paraboloid(shape, 1.0_wp, error)
        case ("cone f=r"); call new_cone(shape, eighth_turn, error)
        case ("quartic f=r^4"); call new_power_law(shape, 4.0_wp, 1.0_wp, error)
        case default; error stop "unknown profile"
        end select
        call new_contact(contact, shape, medium, error)
        if (allocated(error)) error stop "a contact of the table could not be made"
    end subroutine new_row_contact

end module tangential_rows
