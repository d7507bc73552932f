! SPDX-License-Identifier: GPL-3.0-or-later
!> Rows of the table of contacts with friction, tests/data/tangential.csv.
module tangential_rows
    use mdrcontact_contact, only: contact_t, new_contact
    use mdrcontact_error, only: error_t
    use mdrcontact_kinds, only: wp
    use mdrcontact_material, only: material_t
    use mdrcontact_medium_solver, only: solver_t
    use mdrcontact_profile, only: profile_t
    use reference_tables, only: layers_of, line_length, new_table_medium, new_table_profile, read_table, split
    implicit none (type, external)
    private
    public :: tangential_row_t, read_tangential_rows, new_row_contact

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
        character(len=line_length), allocatable :: lines(:)
        character(len=line_length) :: words(6)
        integer :: i

        call read_table(path, lines)
        allocate (rows(size(lines)))
        do i = 1, size(lines)
            call split(lines(i), ",", words)
            rows(i)%layers = words(2) (:80)
            rows(i)%base = words(3) (:80)
            read (words(4), *) rows(i)%base_poisson
            rows(i)%profile = words(5) (:80)
            read (words(6), *) rows(i)%radius, rows(i)%coefficient, rows(i)%part, rows(i)%shift, rows(i)%sliding_shift, &
                rows(i)%depth, rows(i)%force, rows(i)%stiffness, rows(i)%tangential_stiffness, rows(i)%stick_radius, &
                rows(i)%tangential_force, rows(i)%cycle_energy, rows(i)%slope
        end do
    end subroutine read_tangential_rows

    !> The contact of a row: layers "h:G:nu;..." from the surface down, "-" for none.
    subroutine new_row_contact(row, contact)
        type(tangential_row_t), intent(in) :: row
        type(contact_t), intent(out) :: contact
        class(solver_t), allocatable :: medium
        class(profile_t), allocatable :: profile
        type(error_t), allocatable :: error
        real(wp), allocatable :: h(:), G(:), nu(:)
        real(wp) :: base
        integer :: i

        base = 1.0_wp
        if (row%base /= "inf") read (row%base, *) base
        call layers_of(row%layers, h, G, nu)
        call new_table_medium(medium, [(material_t(2.0_wp*G(i)*(1.0_wp + nu(i)), nu(i)), i=1, size(h))], h, &
                              material_t(2.0_wp*base*(1.0_wp + row%base_poisson), row%base_poisson), row%base == "inf")
        call new_table_profile(profile, trim(row%profile))
        call new_contact(contact, profile, medium, error)
        if (allocated(error)) error stop "a contact of the table could not be made"
    end subroutine new_row_contact

end module tangential_rows
