! SPDX-License-Identifier: GPL-3.0-or-later
!> Rows of a table of exact layered contacts: layers_h, layers_E, layers_nu (";" between layers), substrate_E ("inf": rigid base),
!> substrate_nu, a, profile ("paraboloid R=1" or "cone tan=1"), work_of_adhesion, E_eff, d, F.
module layered_rows
    use mdrcontact_kinds, only: wp
    use mdrcontact_material, only: material_t
    use mdrcontact_medium_solver, only: solver_t
    use mdrcontact_profile, only: profile_t
    use reference_tables, only: line_length, new_table_medium, new_table_profile, numbers_of, read_table, split
    implicit none (type, external)
    private
    public :: layered_row_t, read_layered_rows, new_row_bodies

    integer, parameter :: most_layers = 8

    type :: layered_row_t
        integer :: layers = 0
        real(wp) :: thickness(most_layers) = 0.0_wp, young(most_layers) = 0.0_wp, poisson(most_layers) = 0.0_wp
        logical :: rigid_base = .false.
        real(wp) :: substrate_young = 1.0_wp, substrate_poisson = 0.0_wp
        real(wp) :: radius = 0.0_wp, work_of_adhesion = 0.0_wp
        character(len=32) :: profile = ""
        real(wp) :: modulus = 0.0_wp, depth = 0.0_wp, force = 0.0_wp
    end type layered_row_t

contains

    !> All rows of a file.
    subroutine read_layered_rows(path, rows)
        character(len=*), intent(in) :: path
        type(layered_row_t), allocatable, intent(out) :: rows(:)
        character(len=line_length), allocatable :: lines(:)
        integer :: i

        call read_table(path, lines)
        allocate (rows(size(lines)))
        do i = 1, size(lines)
            rows(i) = parsed(lines(i))
        end do
    end subroutine read_layered_rows

    function parsed(line) result(row)
        character(len=*), intent(in) :: line
        type(layered_row_t) :: row
        character(len=line_length) :: field(8), layers(most_layers)

        call split(line, ",", field)
        call split(field(1), ";", layers)
        row%layers = count(layers /= "")
        call numbers_of(field(1), ";", row%thickness(:row%layers))
        call numbers_of(field(2), ";", row%young(:row%layers))
        call numbers_of(field(3), ";", row%poisson(:row%layers))
        row%rigid_base = field(4) == "inf"
        if (.not. row%rigid_base) read (field(4), *) row%substrate_young
        read (field(5), *) row%substrate_poisson
        read (field(6), *) row%radius
        row%profile = field(7) (:len(row%profile))
        read (field(8), *) row%work_of_adhesion, row%modulus, row%depth, row%force
    end function parsed

    subroutine new_row_bodies(row, profile, medium)
        type(layered_row_t), intent(in) :: row
        class(profile_t), allocatable, intent(out) :: profile
        class(solver_t), allocatable, intent(out) :: medium
        integer :: i

        call new_table_profile(profile, trim(row%profile))
        call new_table_medium(medium, [(material_t(row%young(i), row%poisson(i)), i=1, row%layers)], row%thickness(:row%layers), &
                              material_t(row%substrate_young, row%substrate_poisson), row%rigid_base)
    end subroutine new_row_bodies

end module layered_rows
