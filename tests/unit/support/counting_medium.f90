! SPDX-License-Identifier: GPL-3.0-or-later
!> A medium that counts how often it is solved.
module counting_medium
    use mdrcontact, only: error_t, load_t, profile_t, solved_t, solver_t
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
        procedure :: solve
        procedure :: load => new_load
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

    subroutine solve(self, profile, a, solved, error, adhesive, accuracy, series)
        class(counting_medium_t), intent(in) :: self
        class(profile_t), intent(in) :: profile
        real(wp), intent(in) :: a
        type(solved_t), intent(out) :: solved
        type(error_t), allocatable, intent(out) :: error
        logical, intent(in), optional :: adhesive
        real(wp), intent(inout), optional :: accuracy
        real(wp), allocatable, intent(out), optional :: series(:, :)

        self%counter%solutions = self%counter%solutions + 1
        call self%inside%solve(profile, a, solved, error, adhesive, accuracy, series)
    end subroutine solve

    subroutine new_load(self, profile, a, punch_depth, load, error)
        class(counting_medium_t), intent(in), target :: self
        class(profile_t), intent(in), target :: profile
        real(wp), intent(in) :: a, punch_depth
        class(load_t), allocatable, intent(out) :: load
        type(error_t), allocatable, intent(out) :: error

        self%counter%solutions = self%counter%solutions + 1
        call self%inside%load(profile, a, punch_depth, load, error)
    end subroutine new_load

end module counting_medium
