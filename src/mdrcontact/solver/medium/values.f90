! SPDX-License-Identifier: GPL-3.0-or-later
!> The effective modulus of a medium at many contact radii, on one thread or several.
module mdrcontact_medium_values
    use mdrcontact_batch, only: batch_t, run_batch
    use mdrcontact_error, only: check_made, error_t
    use mdrcontact_kinds, only: wp
    use mdrcontact_medium_solver, only: solver_t
    implicit none (type, external)
    private
    public :: modulus_values

    type, extends(batch_t) :: modulus_batch_t
        class(solver_t), pointer :: medium => null()
        real(wp), pointer, contiguous :: a(:) => null(), values(:) => null()
    contains
        procedure :: work
    end type modulus_batch_t

    !> Radii that a thread takes at a time where the modulus is a formula, and from how many on several threads pay. Elsewhere each
    !> is the solution of a system.
    integer, parameter :: formula_block = 256, formula_smallest = 2048

contains

    !> E_eff(a) [modulus].
    subroutine modulus_values(medium, a, values, threads, error)
        class(solver_t), intent(in), target :: medium
        !> a > 0 where the medium is defined, not checked [length]
        real(wp), intent(in), target, contiguous :: a(:)
        !> same size as a
        real(wp), intent(inout), target, contiguous :: values(:)
        !> at least 1, or 0 for as many as OpenMP offers
        integer, intent(in) :: threads
        type(error_t), allocatable, intent(out) :: error
        type(modulus_batch_t) :: batch

        call check_made(error, "medium", medium%is_made)
        if (allocated(error)) return
        batch%medium => medium
        batch%a => a
        batch%values => values
        if (medium%is_modulus_formula) then
            call run_batch(batch, size(a), formula_block, formula_smallest, threads, error)
        else
            call run_batch(batch, size(a), 1, 2, threads, error)
        end if
    end subroutine modulus_values

    subroutine work(self, first, last, error)
        class(modulus_batch_t), intent(inout) :: self
        integer, intent(in) :: first, last
        type(error_t), allocatable, intent(out) :: error

        call self%medium%modulus(self%a(first:last), self%values(first:last), error)
    end subroutine work

end module mdrcontact_medium_values
