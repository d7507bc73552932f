! SPDX-License-Identifier: GPL-3.0-or-later
!> Effective moduli at many places and radii of a structure, and its weights at many points, on one thread or several.
module mdrcontact_lateral_values
    use mdrcontact_batch, only: batch_t, run_batch
    use mdrcontact_error, only: check_made, error_t
    use mdrcontact_kinds, only: wp
    use mdrcontact_lateral_density, only: lateral_density
    use mdrcontact_lateral_structure, only: structure_t
    implicit none (type, external)
    private
    public :: structure_values, density_values

    type, extends(batch_t) :: structure_batch_t
        class(structure_t), pointer :: structure => null()
        real(wp), pointer, contiguous :: x(:) => null(), y(:) => null(), a(:) => null(), values(:) => null()
    contains
        procedure :: work => evaluate
    end type structure_batch_t

    type, extends(batch_t) :: density_batch_t
        real(wp) :: nu = 0.5_wp
        real(wp), pointer, contiguous :: rho(:) => null(), z(:) => null(), shear(:) => null(), poisson(:) => null()
    contains
        procedure :: work => weigh
    end type density_batch_t

    !> Points that a thread takes at a time, and from how many on several threads pay.
    integer, parameter :: point_block = 512, point_smallest = 4096

contains

    !> E_eff(a, x, y) [modulus]. A structure that is a user's function is evaluated on the calling thread alone.
    subroutine structure_values(structure, x, y, a, values, threads, error)
        class(structure_t), intent(in), target :: structure
        !> all of equal size [length]
        real(wp), intent(in), target, contiguous :: x(:), y(:), a(:)
        !> same size [modulus]
        real(wp), intent(inout), target, contiguous :: values(:)
        !> at least 1, or 0 for as many as OpenMP offers
        integer, intent(in) :: threads
        type(error_t), allocatable, intent(out) :: error
        type(structure_batch_t) :: batch
        integer :: team

        call check_made(error, "structure", structure%is_made)
        if (allocated(error)) return
        team = threads
        if (structure%calls_user()) team = 1
        batch%structure => structure
        batch%x => x
        batch%y => y
        batch%a => a
        batch%values => values
        call run_batch(batch, size(values), 1, 2, team, error)
    end subroutine structure_values

    subroutine evaluate(self, first, last, error)
        class(structure_batch_t), intent(inout) :: self
        integer, intent(in) :: first, last
        type(error_t), allocatable, intent(out) :: error

        call self%structure%modulus(self%x(first:last), self%y(first:last), self%a(first:last), self%values(first:last), error)
    end subroutine evaluate

    !> The pair of weights of lateral_density.
    subroutine density_values(rho, z, nu, shear, poisson, threads)
        !> distances from the axis and depths in units of the contact radius, same size
        real(wp), intent(in), target, contiguous :: rho(:), z(:)
        !> Poisson's ratio that the weights are for
        real(wp), intent(in) :: nu
        !> same size
        real(wp), intent(inout), target, contiguous :: shear(:), poisson(:)
        !> at least 1, or 0 for as many as OpenMP offers
        integer, intent(in) :: threads
        type(density_batch_t) :: batch
        type(error_t), allocatable :: error

        batch%is_quick = .true.
        batch%nu = nu
        batch%rho => rho
        batch%z => z
        batch%shear => shear
        batch%poisson => poisson
        call run_batch(batch, size(rho), point_block, point_smallest, threads, error)
    end subroutine density_values

    subroutine weigh(self, first, last, error)
        class(density_batch_t), intent(inout) :: self
        integer, intent(in) :: first, last
        type(error_t), allocatable, intent(out) :: error
        real(wp) :: shear, poisson
        integer :: i

        do i = first, last
            call lateral_density(self%rho(i), self%z(i), self%nu, shear, poisson)
            self%shear(i) = shear
            self%poisson(i) = poisson
        end do
    end subroutine weigh

end module mdrcontact_lateral_values
