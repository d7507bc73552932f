! SPDX-License-Identifier: GPL-3.0-or-later
!> Rows of a table of exact layered contacts: layers_h, layers_E, layers_nu (";" between layers), substrate_E ("inf": rigid base),
!> substrate_nu, a, profile ("paraboloid R=1" or "cone tan=1"), work_of_adhesion, E_eff, d, F.
module layered_rows
    use mdrcontact_kinds, only: wp
    implicit none (type, external)
    private
    public :: layered_row_t, read_layered_rows

    integer, parameter :: most_layers = 8, columns = 11

    type :: layered_row_t
        integer :: layers = 0
        real(wp) :: thickness(most_layers) = 0.0_wp, young(most_layers) = 0.0_wp, poisson(most_layers) = 0.0_wp
        logical :: rigid_base = .false.
        real(wp) :: substrate_young = 1.0_wp, substrate_poisson = 0.0_wp
        real(wp) :: radius = 0.0_wp, work_of_adhesion = 0.0_wp
        logical :: is_cone = .false.
        real(wp) :: modulus = 0.0_wp, depth = 0.0_wp, force = 0.0_wp
    end type layered_row_t

contains

    !> All rows of a file.
    subroutine read_layered_rows(path, rows)
        character(len=*), intent(in) :: path
        type(layered_row_t), allocatable, intent(out) :: rows(:)
        character(len=512) :: line
        integer :: unit, status

        allocate (rows(0))
        open (newunit=unit, file=path, action="read", status="old")
        read (unit, "(a)") line
        do
            read (unit, "(a)", iostat=status) line
            if (status /= 0) exit
            rows = [rows, parsed(line)]
        end do
        close (unit)
    end subroutine read_layered_rows

    function parsed(line) result(row)
        character(len=*), intent(in) :: line
        type(layered_row_t) :: row
        character(len=128) :: field(columns)
        integer :: i, from, comma

        from = 1
        do i = 1, columns
            comma = index(line(from:)//",", ",")
            field(i) = line(from:from + comma - 2)
            from = from + comma
        end do
        row%layers = count([(field(1) (i:i) == ";", i=1, len(field(1)))]) + 1
        call read_list(field(1), row%thickness(:row%layers))
        call read_list(field(2), row%young(:row%layers))
        call read_list(field(3), row%poisson(:row%layers))
        row%rigid_base = field(4) == "inf"
        if (.not. row%rigid_base) read (field(4), *) row%substrate_young
        read (field(5), *) row%substrate_poisson
        read (field(6), *) row%radius
        row%is_cone = index(field(7), "cone") == 1
        read (field(8), *) row%work_of_adhesion
        read (field(9), *) row%modulus
        read (field(10), *) row%depth
        read (field(11), *) row%force
    end function parsed

    subroutine read_list(text, values)
        character(len=*), intent(in) :: text
        real(wp), intent(out) :: values(:)
        character(len=len(text)) :: spaced
        integer :: i

        spaced = text
        do i = 1, len(text)
            if (spaced(i:i) == ";") spaced(i:i) = " "
        end do
        read (spaced, *) values
    end subroutine read_list

end module layered_rows
