! SPDX-License-Identifier: GPL-3.0-or-later
!> A medium that counts how often it is solved.
module counting_medium
    use mdrcontact, only: error_t, load_t, profile_t, solved_t, solver_t
    use mdrcontact_kinds, only: wp
    implicit none (type, external)
    private
    public :: counter_t, counting_medium_t

    !> Reset and read by calls: gfortran 14 to 16 assume that what a medium reaches by a pointer remains, where the medium is passed
    !> as `class(solver_t), intent(in)`, and then omit a reset and repeat an earlier value.
    type :: counter_t
        integer, private :: solutions = 0
    contains
        procedure :: restart
        procedure :: counted
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

    !> Counts from 0 again.
    subroutine restart(self)
        class(counter_t), intent(inout) :: self

        self%solutions = 0
    end subroutine restart

    !> Solutions since then.
    function counted(self)
        class(counter_t), intent(in) :: self
        integer :: counted

        counted = self%solutions
    end function counted

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
