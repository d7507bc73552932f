! SPDX-License-Identifier: GPL-3.0-or-later
!> Numbers of a medium one by one, where a test wants a state or a field at one radius and nothing else of it.
module medium_numbers
    use mdrcontact, only: error_t, load_t, profile_t, solved_t, solver_t
    use mdrcontact_kinds, only: wp
    implicit none (type, external)
    private
    public :: state_numbers, surface_field
    public :: of_displacement, of_line_load, of_pressure

    integer, parameter :: of_line_load = 1, of_pressure = 2, of_displacement = 3

contains

    !> Depth, force, E_eff and k' of the non-adhesive contact.
    subroutine state_numbers(medium, profile, a, depth, force, modulus, slope, error, adhesive, depth_slope, accuracy)
        class(solver_t), intent(in) :: medium
        class(profile_t), intent(in) :: profile
        real(wp), intent(in) :: a
        real(wp), intent(out) :: depth, force, modulus, slope
        type(error_t), allocatable, intent(out) :: error
        logical, intent(in), optional :: adhesive
        real(wp), intent(out), optional :: depth_slope
        real(wp), intent(inout), optional :: accuracy
        type(solved_t) :: solved

        call medium%solve(profile, a, solved, error, adhesive, accuracy)
        depth = solved%depth
        force = solved%force
        modulus = solved%modulus
        slope = solved%stiffness_slope
        if (present(depth_slope)) depth_slope = solved%depth_slope
    end subroutine state_numbers

    !> Line load, pressure or displacement.
    subroutine surface_field(medium, quantity, profile, a, punch_depth, r, values, error)
        class(solver_t), intent(in), target :: medium
        integer, intent(in) :: quantity
        class(profile_t), intent(in), target :: profile
        real(wp), intent(in) :: a, punch_depth
        real(wp), intent(in) :: r(:)
        real(wp), intent(out) :: values(:)
        type(error_t), allocatable, intent(out) :: error
        class(load_t), allocatable :: load

        call medium%load(profile, a, punch_depth, load, error)
        if (allocated(error)) return
        select case (quantity)
        case (of_line_load)
            call load%line_load(r, values, error)
        case (of_pressure)
            call load%pressure(r, values, error)
        case default
            call load%displacement(r, values, error)
        end select
    end subroutine surface_field

end module medium_numbers
