! SPDX-License-Identifier: GPL-3.0-or-later
!> Gauss-Legendre rules right to the last digit, weights included: a film that nearly cancels its springs shows every error
!> of theirs.
module mdrcontact_line_rule
    use mdrcontact_error, only: error_t
    use mdrcontact_kinds, only: wp
    use mdrcontact_numerics_quadrature, only: gauss_legendre
    implicit none (type, external)
    private
    public :: rule_t, new_rule, largest_rule

    !> Sizes of which GSL has nodes and weights to machine precision.
    integer, parameter :: known(*) = [20, 32, 64, 96, 128, 256, 512, 1024]
    !> The largest of them.
    integer, parameter :: largest_rule = known(size(known))

    !> Nodes u in (-1, 1) by their distance 1 + u from the end, and weights.
    type :: rule_t
        real(wp), allocatable :: distance(:), weights(:)
    end type rule_t

contains

    !> A rule of at least n <= largest_rule nodes, a multiple of 4.
    subroutine new_rule(self, n, error)
        type(rule_t), intent(out) :: self
        integer, intent(in) :: n
        type(error_t), allocatable, intent(inout) :: error
        integer :: count

        count = known(findloc(known >= min(n, largest_rule), .true., dim=1))
        allocate (self%distance(count), self%weights(count))
        call gauss_legendre(self%distance, self%weights, error)
        self%distance = 2.0_wp*self%distance
        self%weights = 2.0_wp*self%weights
    end subroutine new_rule

end module mdrcontact_line_rule
