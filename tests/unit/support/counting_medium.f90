! SPDX-License-Identifier: GPL-3.0-or-later
!> A medium that counts how often it is solved.
module counting_medium
    use mdrcontact, only: error_t, solver_t, profile_t
    use mdrcontact_kinds, only: wp
    implicit none (type, external)
    private
    public :: counter_t, counting_medium_t

    type :: counter_t
        integer :: solutions = 0
    end type counter_t

    type, extends(solver_t) :: counting_medium_t
        class(solver_t), allocatable :: inside
        type(counter_t), pointer :: counter => null()
    contains
        procedure :: modulus
        procedure :: response
        procedure :: field
    end type counting_medium_t

contains

    subroutine modulus(self, a, values, error, slopes)
        class(counting_medium_t), intent(in) :: self
        real(wp), intent(in) :: a(:)
        real(wp), intent(out) :: values(:)
        type(error_t), allocatable, intent(out) :: error
        real(wp), intent(out), optional :: slopes(:)

        self%counter%solutions = self%counter%solutions + size(a)
        call self%inside%modulus(a, values, error, slopes)
    end subroutine modulus

    subroutine response(self, profile, a, depth, force, modulus, stiffness_slope, error, adhesive, depth_slope, accuracy)
        class(counting_medium_t), intent(in) :: self
        class(profile_t), intent(in) :: profile
        real(wp), intent(in) :: a
        real(wp), intent(out) :: depth, force, modulus, stiffness_slope
        type(error_t), allocatable, intent(out) :: error
        logical, intent(in), optional :: adhesive
        real(wp), intent(inout), optional :: depth_slope, accuracy

        self%counter%solutions = self%counter%solutions + 1
        call self%inside%response(profile, a, depth, force, modulus, stiffness_slope, error, adhesive, depth_slope, &
                                  accuracy)
    end subroutine response

    subroutine field(self, quantity, profile, a, punch_depth, r, values, error)
        class(counting_medium_t), intent(in) :: self
        integer, intent(in) :: quantity
        class(profile_t), intent(in) :: profile
        real(wp), intent(in) :: a, punch_depth
        real(wp), intent(in) :: r(:)
        real(wp), intent(out) :: values(:)
        type(error_t), allocatable, intent(out) :: error

        self%counter%solutions = self%counter%solutions + 1
        call self%inside%field(quantity, profile, a, punch_depth, r, values, error)
    end subroutine field

end module counting_medium
