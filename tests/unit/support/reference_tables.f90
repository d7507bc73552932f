! SPDX-License-Identifier: GPL-3.0-or-later
!> The tables of reference numbers in tests/data, and the bodies and indenters that their words mean.
module reference_tables
    use mdrcontact_body_stack, only: new_stack, stack_t
    use mdrcontact_error, only: error_t
    use mdrcontact_kinds, only: wp
    use mdrcontact_medium_exact, only: layered_exact_t, new_layered_exact
    use mdrcontact_material, only: material_t
    use mdrcontact_medium_solver, only: solver_t
    use mdrcontact_medium_homogeneous, only: homogeneous_t, new_homogeneous
    use mdrcontact_profile, only: profile_t
    use mdrcontact_profile_power_law, only: new_cone, new_paraboloid, new_power_law, power_law_t
    implicit none (type, external)
    private
    public :: line_length, read_table, split, numbers_of, number_after, layers_of, new_table_medium, new_table_profile

    integer, parameter :: line_length = 512, most_layers = 8
    real(wp), parameter :: eighth_turn = atan(1.0_wp)

contains

    !> The lines of a table, without its comments, which begin with #, and the line of names behind them.
    subroutine read_table(path, lines)
        character(len=*), intent(in) :: path
        character(len=line_length), allocatable, intent(out) :: lines(:)
        character(len=line_length) :: line
        integer :: unit, status

        allocate (lines(0))
        open (newunit=unit, file=path, action="read", status="old")
        do
            read (unit, "(a)", iostat=status) line
            if (status /= 0) exit
            if (line(1:1) /= "#") lines = [lines, line]
        end do
        close (unit)
        lines = lines(2:)
    end subroutine read_table

    !> The words of a text between commas or other marks: the first ones, the last of them with all that follows; blank where there
    !> are fewer.
    subroutine split(text, mark, words)
        character(len=*), intent(in) :: text
        character(len=1), intent(in) :: mark
        character(len=line_length), intent(out) :: words(:)
        integer :: i, from, length

        words = ""
        from = 1
        do i = 1, size(words) - 1
            length = index(text(from:), mark) - 1
            if (length < 0) exit
            words(i) = text(from:from + length - 1)
            from = from + length + 1
        end do
        words(i) = text(from:)
    end subroutine split

    !> The numbers of a text between commas or other marks, as many as are requested.
    subroutine numbers_of(text, mark, values)
        character(len=*), intent(in) :: text
        character(len=1), intent(in) :: mark
        real(wp), intent(out) :: values(:)
        character(len=len(text)) :: spaced
        integer :: i

        spaced = text
        do i = 1, len(text)
            if (spaced(i:i) == mark) spaced(i:i) = " "
        end do
        read (spaced, *) values
    end subroutine numbers_of

    !> The number behind a name such as "a=", up to a blank or a semicolon, which list-directed input does not take as a separator.
    function number_after(text, name) result(number)
        character(len=*), intent(in) :: text, name
        real(wp) :: number
        real(wp) :: values(1)

        call numbers_of(text(index(text, name) + len(name):), ";", values)
        number = values(1)
    end function number_after

    !> Layers "h:modulus:nu; ..." from the surface down; none for a blank or "-".
    subroutine layers_of(text, thickness, moduli, poisson)
        character(len=*), intent(in) :: text
        real(wp), allocatable, intent(out) :: thickness(:), moduli(:), poisson(:)
        character(len=line_length) :: parts(most_layers)
        real(wp) :: values(3, most_layers)
        integer :: i, n

        call split(text, ";", parts)
        n = count(parts /= "" .and. parts /= "-")
        do i = 1, n
            call numbers_of(parts(i), ":", values(:, i))
        end do
        thickness = values(1, :n)
        moduli = values(2, :n)
        poisson = values(3, :n)
    end subroutine layers_of

    !> Layers from the surface down, if there are any, on a half-space or a rigid base, solved exactly.
    subroutine new_table_medium(medium, layers, thickness, substrate, rigid_base)
        class(solver_t), allocatable, intent(out) :: medium
        type(material_t), intent(in) :: layers(:), substrate
        real(wp), intent(in) :: thickness(:)
        logical, intent(in) :: rigid_base
        type(homogeneous_t) :: homogeneous
        type(layered_exact_t) :: exact
        type(stack_t) :: stack
        type(error_t), allocatable :: error

        if (size(layers) == 0) then
            call new_homogeneous(homogeneous, substrate)
            allocate (medium, source=homogeneous)
            return
        end if
        call new_stack(stack, layers, thickness, substrate, error, rigid_base)
        if (.not. allocated(error)) call new_layered_exact(exact, stack, error)
        if (allocated(error)) error stop "a body of the table could not be made"
        allocate (medium, source=exact)
    end subroutine new_table_medium

    subroutine new_table_profile(profile, name)
        class(profile_t), allocatable, intent(out) :: profile
        character(len=*), intent(in) :: name
        type(power_law_t) :: shape
        type(error_t), allocatable :: error

        select case (name)
        case ("paraboloid R=1", "paraboloid f=r^2/2"); call new_paraboloid(shape, 1.0_wp, error)
        case ("cone slope 1", "cone tan=1", "cone f=r"); call new_cone(shape, eighth_turn, error)
        case ("r^4", "quartic f=r^4"); call new_power_law(shape, 4.0_wp, 1.0_wp, error)
        case default; error stop "unknown profile"
        end select
        allocate (profile, source=shape)
    end subroutine new_table_profile

end module reference_tables
