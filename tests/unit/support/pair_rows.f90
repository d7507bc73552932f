! SPDX-License-Identifier: GPL-3.0-or-later
!> Rows of the table of contacts of two deformable bodies, tests/data/bodies.csv.
module pair_rows
    use mdrcontact_kinds, only: wp
    use mdrcontact_material, only: material_t
    use mdrcontact_medium, only: medium_t
    use mdrcontact_medium_homogeneous, only: homogeneous_t, new_rigid
    use reference_tables, only: line_length, new_table_medium, numbers_of, read_table, split
    implicit none (type, external)
    private
    public :: pair_row_t, read_pair_rows, new_row_body

    integer, parameter :: most_parts = 9

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
        real(wp) :: values(11)
        integer :: i

        call read_table(path, lines)
        allocate (rows(size(lines)))
        do i = 1, size(lines)
            call split(lines(i), ",", words)
            call numbers_of(words(4), ",", values)
            rows(i)%bodies = words(:2) (:80)
            rows(i)%profile = words(3) (:80)
            rows(i)%radius = values(1)
            rows(i)%work_of_adhesion = values(2)
            rows(i)%surface_modulus = values(3)
            rows(i)%depth = values(4)
            rows(i)%force = values(5)
            rows(i)%modulus = values(6)
            rows(i)%modulus_slope = values(7)
            rows(i)%displacements = values(8:9)
            rows(i)%energies = values(10:11)
        end do
    end subroutine read_pair_rows

    !> "h:E:nu; ...; E:nu", "...; rigid base" or "rigid".
    subroutine new_row_body(text, medium)
        character(len=*), intent(in) :: text
        class(medium_t), allocatable, intent(out) :: medium
        character(len=line_length) :: parts(most_parts)
        type(material_t) :: layers(most_parts - 1), substrate
        type(homogeneous_t) :: rigid
        real(wp) :: h(most_parts - 1), values(3)
        integer :: i, n

        if (text == "rigid") then
            call new_rigid(rigid)
            allocate (medium, source=rigid)
            return
        end if
        call split(text, ";", parts)
        n = count(parts /= "") - 1
        do i = 1, n
            call numbers_of(parts(i), ":", values)
            h(i) = values(1)
            layers(i) = material_t(values(2), values(3))
        end do
        if (adjustl(parts(n + 1)) /= "rigid base") then
            call numbers_of(parts(n + 1), ":", values(:2))
            substrate = material_t(values(1), values(2))
        end if
        call new_table_medium(medium, layers(:n), h(:n), substrate, adjustl(parts(n + 1)) == "rigid base")
    end subroutine new_row_body

end module pair_rows
