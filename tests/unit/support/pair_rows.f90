! SPDX-License-Identifier: GPL-3.0-or-later
!> Rows of the table of contacts of two deformable bodies, tests/data/bodies.csv.
module pair_rows
    use mdrcontact_body_stack, only: new_stack, stack_t
    use mdrcontact_error, only: error_t
    use mdrcontact_kinds, only: wp
    use mdrcontact_layered_exact, only: layered_exact_t, new_layered_exact
    use mdrcontact_material, only: material_t
    use mdrcontact_medium, only: medium_t
    use mdrcontact_medium_homogeneous, only: homogeneous_t, new_homogeneous, new_rigid
    use mdrcontact_profile, only: profile_t
    use mdrcontact_profile_power_law, only: new_cone, new_paraboloid, new_power_law, power_law_t
    implicit none (type, external)
    private
    public :: pair_row_t, read_pair_rows, new_row_body, new_row_profile

    integer, parameter :: comments = 3, numbers = 11
    real(wp), parameter :: eighth_turn = atan(1.0_wp)

    type :: pair_row_t
        character(len=80) :: bodies(2) = ""
        character(len=80) :: profile = ""
        real(wp) :: radius = 0.0_wp, work_of_adhesion = 0.0_wp, surface_modulus = 0.0_wp
        real(wp) :: depth = 0.0_wp, force = 0.0_wp, modulus = 0.0_wp, modulus_slope = 0.0_wp
        !> displacements on the axis and elastic energies, lower and upper
        real(wp) :: displacements(2) = 0.0_wp, energies(2) = 0.0_wp
    end type pair_row_t

contains

    !> All rows of the file.
    subroutine read_pair_rows(path, rows)
        character(len=*), intent(in) :: path
        type(pair_row_t), allocatable, intent(out) :: rows(:)
        character(len=512) :: line
        integer :: unit, status, i

        allocate (rows(0))
        open (newunit=unit, file=path, action="read", status="old")
        do i = 1, comments + 1
            read (unit, "(a)") line
        end do
        do
            read (unit, "(a)", iostat=status) line
            if (status /= 0) exit
            rows = [rows, parsed(line)]
        end do
        close (unit)
    end subroutine read_pair_rows

    function parsed(line) result(row)
        character(len=*), intent(in) :: line
        type(pair_row_t) :: row
        character(len=80) :: words(3)
        real(wp) :: values(numbers)
        integer :: i, from, comma

        from = 1
        do i = 1, 3
            comma = from + index(line(from:), ",") - 1
            words(i) = line(from:comma - 1)
            from = comma + 1
        end do
        read (line(from:), *) values
        row%bodies = words(:2)
        row%profile = words(3)
        row%radius = values(1)
        row%work_of_adhesion = values(2)
        row%surface_modulus = values(3)
        row%depth = values(4)
        row%force = values(5)
        row%modulus = values(6)
        row%modulus_slope = values(7)
        row%displacements = values(8:9)
        row%energies = values(10:11)
    end function parsed

    !> "h:E:nu; ...; E:nu", "...; rigid base" or "rigid".
    subroutine new_row_body(text, medium)
        character(len=*), intent(in) :: text
        class(medium_t), allocatable, intent(out) :: medium
        type(material_t) :: materials(8), substrate
        type(homogeneous_t) :: homogeneous
        type(layered_exact_t) :: exact
        type(stack_t) :: stack
        type(error_t), allocatable :: error
        real(wp) :: h(8), values(3)
        character(len=len(text)) :: part
        integer :: from, last, n, colons, i
        logical :: rigid_base

        if (text == "rigid") then
            call new_rigid(homogeneous)
            allocate (medium, source=homogeneous)
            return
        end if
        n = 0
        rigid_base = .false.
        from = 1
        do while (from <= len_trim(text))
            last = from + index(text(from:)//";", ";") - 2
            part = text(from:last)
            from = last + 2
            if (index(part, "rigid") > 0) then
                rigid_base = .true.
                cycle
            end if
            colons = count([(part(i:i) == ":", i=1, len(part))])
            do i = 1, len(part)
                if (part(i:i) == ":") part(i:i) = " "
            end do
            read (part, *) values(:colons + 1)
            if (colons == 2) then
                n = n + 1
                h(n) = values(1)
                materials(n) = material_t(values(2), values(3))
            else
                substrate = material_t(values(1), values(2))
            end if
        end do
        if (n == 0) then
            call new_homogeneous(homogeneous, substrate)
            allocate (medium, source=homogeneous)
            return
        end if
        call new_stack(stack, materials(:n), h(:n), substrate, error, rigid_base)
        if (.not. allocated(error)) call new_layered_exact(exact, stack, error)
        if (allocated(error)) error stop "a body of the table could not be made"
        allocate (medium, source=exact)
    end subroutine new_row_body

    subroutine new_row_profile(name, profile)
        character(len=*), intent(in) :: name
        class(profile_t), allocatable, intent(out) :: profile
        type(power_law_t) :: shape
        type(error_t), allocatable :: error

        select case (name)
        case ("paraboloid R=1"); call new_paraboloid(shape, 1.0_wp, error)
        case ("cone slope 1"); call new_cone(shape, eighth_turn, error)
        case ("r^4"); call new_power_law(shape, 4.0_wp, 1.0_wp, error)
        case default; error stop "unknown profile"
        end select
        allocate (profile, source=shape)
    end subroutine new_row_profile

end module pair_rows
