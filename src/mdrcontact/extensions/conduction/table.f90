! SPDX-License-Identifier: GPL-3.0-or-later
!> The conductance of contact areas between two radii, sampled once: for codes that integrate motion, to which a compiled law of the
!> contact gives the radius. It is compared with the solution between its nodes.
module mdrcontact_conduction_table
    use mdrcontact_conduction_bodies, only: conduction_t
    use mdrcontact_conduction_fields, only: conductance_at
    use mdrcontact_error, only: check_made, check_within, error_t
    use mdrcontact_kinds, only: wp
    use mdrcontact_numerics_radius_law, only: new_radius_law_from_function
    use mdrcontact_numerics_scalar_function, only: scalar_function_t
    implicit none (type, external)
    private
    public :: tabulate_conductance

    !> Range of the relative tolerance of a table's values.
    real(wp), parameter :: smallest_tolerance = 1.0e-10_wp, largest_tolerance = 1.0e-2_wp

    !> G(a)/a.
    type, extends(scalar_function_t) :: per_radius_t
        type(conduction_t) :: conduction
    contains
        procedure :: value
    end type per_radius_t

contains

    !> The same conduction with a table of its conductance, which conductance_at then reads between these radii.
    subroutine tabulate_conductance(conduction, smallest, largest, tolerance, tabulated, error)
        type(conduction_t), intent(in) :: conduction
        !> 0 < smallest < largest [length]
        real(wp), intent(in) :: smallest, largest
        !> relative, 1e-10 to 1e-2
        real(wp), intent(in) :: tolerance
        type(conduction_t), intent(out) :: tabulated
        type(error_t), allocatable, intent(out) :: error
        type(per_radius_t), target :: function

        call check_made(error, "conduction", conduction%is_made)
        if (allocated(error)) return
        call check_within(error, "tolerance", tolerance, smallest_tolerance, largest_tolerance)
        call conduction%check_steady(error)
        call conduction%check_radius(largest, error)
        if (allocated(error)) return
        tabulated = conduction
        if (allocated(tabulated%table)) deallocate (tabulated%table)
        function%conduction = tabulated
        allocate (tabulated%table)
        call new_radius_law_from_function(tabulated%table, function, "the conductance", smallest, largest, tolerance, error, &
                                          everywhere=.false.)
    end subroutine tabulate_conductance

    function value(self, x) result(y)
        class(per_radius_t), intent(inout) :: self
        real(wp), intent(in) :: x
        real(wp) :: y
        type(error_t), allocatable :: error
        real(wp) :: slope

        call conductance_at(self%conduction, x, y, slope, error)
        if (allocated(error) .and. .not. allocated(self%error)) call move_alloc(error, self%error)
        self%known_slope = (slope - y/x)/x
        y = y/x
    end function value

end module mdrcontact_conduction_table
