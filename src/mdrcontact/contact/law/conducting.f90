! SPDX-License-Identifier: GPL-3.0-or-later
!> Conductors of a law: the conductance of their contact areas.
module mdrcontact_law_conducting
    use mdrcontact_error, only: error_t
    use mdrcontact_kinds, only: wp
    use mdrcontact_numerics_scalar_function, only: scalar_function_t
    implicit none (type, external)
    private
    public :: conducting_t, conductance_function_t

    !> Conductors whose contact areas have a steady conductance.
    type, abstract :: conducting_t
    contains
        procedure(conductance_of), deferred :: conductance
    end type conducting_t

    !> G(a), for a law that conducts.
    type, extends(scalar_function_t) :: conductance_function_t
        class(conducting_t), pointer :: conductors => null()
    contains
        procedure :: value
    end type conductance_function_t

    abstract interface
        !> G and dG/da.
        subroutine conductance_of(self, a, conductance, slope, error)
            import :: conducting_t, error_t, wp
            class(conducting_t), intent(in) :: self
            !> > 0 [length]
            real(wp), intent(in) :: a
            !> [conductance], [conductance/length]
            real(wp), intent(out) :: conductance, slope
            type(error_t), allocatable, intent(inout) :: error
        end subroutine conductance_of
    end interface

contains

    function value(self, x) result(y)
        class(conductance_function_t), intent(inout) :: self
        real(wp), intent(in) :: x
        real(wp) :: y

        call self%conductors%conductance(x, y, self%known_slope, self%error)
    end function value

end module mdrcontact_law_conducting
