! SPDX-License-Identifier: GPL-3.0-or-later
!> Archard's law with a coefficient that changes with the worn depth, as under a coated tip that wears through:
!> theory/wear.md (8.3).
!>
!> dW = k(W) p ds at each place of the indenter: the worn depth W is a function of int p ds alone, piecewise linear where k is
!> piecewise constant, and no step has to end where the coating does.
!> Archard, J. Appl. Phys. 24 (1953) 981.
module mdrcontact_wear_rate
    use mdrcontact_error, only: check_positive, check_same_size, error_invalid, error_t, raise, to_text
    use mdrcontact_kinds, only: wp
    implicit none (type, external)
    private
    public :: wear_rate_t, new_wear_rate

    !> k(W).
    type :: wear_rate_t
        !> k of each layer of the indenter, the last one below all, with that of the body where it wears too [1/modulus]
        real(wp), allocatable :: coefficients(:)
        !> W at which each layer begins, the first one 0 [length]
        real(wp), allocatable :: starts(:)
        !> int p ds at which each layer begins [modulus length]
        real(wp), allocatable, private :: loads(:)
    contains
        procedure :: worn_depth
        procedure :: layer
        procedure :: coefficient
        procedure :: add
    end type wear_rate_t

contains

    !> Layers of given thickness, from the surface, and what lies below them.
    subroutine new_wear_rate(self, coefficients, thickness, error)
        type(wear_rate_t), intent(out) :: self
        !> k > 0: worn volume per force and sliding distance [1/modulus], of each layer and of what lies below
        real(wp), intent(in) :: coefficients(:)
        !> > 0, one less than coefficients [length]
        real(wp), intent(in) :: thickness(:)
        type(error_t), allocatable, intent(inout) :: error
        integer :: i

        if (size(coefficients) == 0) then
            call raise(error, error_invalid, "coefficient is missing: give the worn volume per force and sliding distance")
            return
        end if
        call check_same_size(error, size(coefficients), size(thickness) + 1)
        do i = 1, size(coefficients)
            if (size(coefficients) == 1) then
                call check_positive(error, "coefficient", coefficients(i))
            else
                call check_positive(error, "coefficient", coefficients(i), i)
            end if
        end do
        do i = 1, size(thickness)
            call check_positive(error, "thickness", thickness(i), i)
        end do
        if (allocated(error)) return
        self%coefficients = coefficients
        allocate (self%starts(size(coefficients)), self%loads(size(coefficients)))
        self%starts(1) = 0.0_wp
        self%loads(1) = 0.0_wp
        do i = 2, size(coefficients)
            self%starts(i) = self%starts(i - 1) + thickness(i - 1)
            self%loads(i) = self%loads(i - 1) + thickness(i - 1)/coefficients(i - 1)
        end do
    end subroutine new_wear_rate

    !> The layer that is at the surface after int p ds.
    elemental function layer(self, load) result(i)
        class(wear_rate_t), intent(in) :: self
        !> [modulus length]
        real(wp), intent(in) :: load
        integer :: i

        i = max(count(self%loads <= load), 1)
    end function layer

    !> W after int p ds.
    elemental function worn_depth(self, load) result(depth)
        class(wear_rate_t), intent(in) :: self
        !> int p ds >= 0 [modulus length]
        real(wp), intent(in) :: load
        real(wp) :: depth
        integer :: i

        i = self%layer(load)
        depth = self%starts(i) + self%coefficients(i)*(load - self%loads(i))
    end function worn_depth

    !> k(W) after int p ds.
    elemental function coefficient(self, load) result(k)
        class(wear_rate_t), intent(in) :: self
        !> int p ds >= 0 [modulus length]
        real(wp), intent(in) :: load
        real(wp) :: k

        k = self%coefficients(self%layer(load))
    end function coefficient

    !> The opposite body wears at the same places: W is then the wear of both.
    pure subroutine add(self, coefficient)
        class(wear_rate_t), intent(inout) :: self
        !> of the other side [1/modulus]
        real(wp), intent(in) :: coefficient

        self%starts = self%starts + coefficient*self%loads
        self%coefficients = self%coefficients + coefficient
    end subroutine add

end module mdrcontact_wear_rate
