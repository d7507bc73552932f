! SPDX-License-Identifier: GPL-3.0-or-later
!> The medium that an indenter meets at one place of a laterally heterogeneous structure: E_eff(a, x, y) at fixed (x, y)
!> (theory/lateral.md (1.1)).
module mdrcontact_lateral_medium
    use mdrcontact_error, only: check_count_within, check_made, check_memory, check_positive, error_invalid, error_t, raise, &
                                to_text
    use mdrcontact_kinds, only: wp
    use mdrcontact_lateral_structure, only: structure_t
    use mdrcontact_medium_tabulated, only: new_tabulated_medium, tabulated_medium_t
    implicit none (type, external)
    private
    public :: new_lateral_medium

    integer, parameter :: default_points = 33, most_points = 1000000

contains

    !> Samples E_eff at radii evenly spaced in ln a. The structure is not needed afterwards.
    subroutine new_lateral_medium(self, structure, x, y, smallest_radius, largest_radius, error, points)
        type(tabulated_medium_t), intent(out) :: self
        class(structure_t), intent(in) :: structure
        !> place of the contact [length]
        real(wp), intent(in) :: x, y
        !> 0 < smallest_radius < largest_radius; below the smaller one E_eff is taken as constant [length]
        real(wp), intent(in) :: smallest_radius, largest_radius
        type(error_t), allocatable, intent(out) :: error
        !> number of radii, 3 to 1000000; default 33
        integer, intent(in), optional :: points
        real(wp), allocatable :: radii(:), modulus(:)
        integer :: count, i, stat

        call check_made(error, "structure", structure%is_made)
        if (allocated(error)) return
        count = default_points
        if (present(points)) count = points
        call check_positive(error, "smallest_radius", smallest_radius)
        call check_positive(error, "largest_radius", largest_radius)
        call check_count_within(error, "points", count, 3, most_points)
        if (largest_radius <= smallest_radius) then
            call raise(error, error_invalid, "largest_radius = "//to_text(largest_radius)// &
                       ": it must be greater than smallest_radius = "//to_text(smallest_radius))
        end if
        if (allocated(error)) return
        allocate (radii(count), modulus(count), stat=stat)
        call check_memory(error, stat)
        do i = 1, count
            if (allocated(error)) return
            radii(i) = smallest_radius*(largest_radius/smallest_radius)**(real(i - 1, wp)/(count - 1))
            if (i == count) radii(i) = largest_radius
            call structure%modulus_at(x, y, radii(i), modulus(i), error)
        end do
        if (.not. allocated(error)) call new_tabulated_medium(self, radii, modulus, error)
        self%is_made = .not. allocated(error)
    end subroutine new_lateral_medium

end module mdrcontact_lateral_medium
