! SPDX-License-Identifier: GPL-3.0-or-later
!> Rows of the table of contacts of two deformable bodies, tests/data/bodies.csv.
module pair_rows
    use mdrcontact_kinds, only: wp
    use mdrcontact_material, only: material_t
    use mdrcontact_medium_solver, only: solver_t
    use mdrcontact_medium_homogeneous, only: homogeneous_t, new_rigid
    use reference_tables, only: layers_of, line_length, new_table_medium, numbers_of, read_table, split
    implicit none (type, external)
    private
    public :: pair_row_t, read_pair_rows, new_row_body

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
        character(len=line_length), allocatable :: lines(:)
        character(len=line_length) :: words(4)
        integer :: i

        call read_table(path, lines)
        allocate (rows(size(lines)))
        do i = 1, size(lines)
            call split(lines(i), ",", words)
            rows(i)%bodies = words(:2) (:80)
            rows(i)%profile = words(3) (:80)
            read (words(4), *) rows(i)%radius, rows(i)%work_of_adhesion, rows(i)%surface_modulus, rows(i)%depth, rows(i)%force, &
                rows(i)%modulus, rows(i)%modulus_slope, rows(i)%displacements, rows(i)%energies
        end do
    end subroutine read_pair_rows

    !> "h:E:nu; ...; E:nu", "...; rigid base" or "rigid".
    subroutine new_row_body(text, medium)
        character(len=*), intent(in) :: text
        class(solver_t), allocatable, intent(out) :: medium
        type(material_t) :: substrate
        type(homogeneous_t) :: rigid
        real(wp), allocatable :: h(:), E(:), nu(:)
        real(wp) :: values(2)
        logical :: rigid_base
        integer :: i, last

        if (text == "rigid") then
            call new_rigid(rigid)
            allocate (medium, source=rigid)
            return
        end if
        last = index(text, ";", back=.true.)
        call layers_of(text(:last - 1), h, E, nu)
        rigid_base = adjustl(text(last + 1:)) == "rigid base"
        if (.not. rigid_base) then
            call numbers_of(text(last + 1:), ":", values)
            substrate = material_t(values(1), values(2))
        end if
        call new_table_medium(medium, [(material_t(E(i), nu(i)), i=1, size(h))], h, substrate, rigid_base)
    end subroutine new_row_body

end module pair_rows
