! SPDX-License-Identifier: GPL-3.0-or-later
!> Sums of indenters: f and g are linear in each other, so the MDR profile of a sum is the sum of the MDR profiles.
module mdrcontact_profile_sum
    use, intrinsic :: iso_fortran_env, only: int64
    use mdrcontact_object, only: room
    use mdrcontact_error, only: error_invalid, error_t, raise
    use mdrcontact_kinds, only: wp
    use mdrcontact_profile, only: profile_t
    use mdrcontact_numerics_quadrature, only: merge_breaks
    implicit none (type, external)
    private
    public :: profile_sum_t, profile_term_t, new_profile_sum

    !> One term of a sum.
    type :: profile_term_t
        !> any indenter, another sum included
        class(profile_t), allocatable :: profile
    end type profile_term_t

    !> f(r) = f_1(r) + f_2(r) + ...; the first term to end, ends the sum.
    type, extends(profile_t) :: profile_sum_t
        private
        type(profile_term_t), allocatable :: terms(:)
    contains
        procedure :: height
        procedure :: slope
        procedure :: mdr
        procedure :: mdr_slope
        procedure :: mdr_slope_beyond
        procedure :: mdr_moment
        procedure :: add_breaks
        procedure :: powers
        procedure :: bytes
    end type profile_sum_t

contains

    !> The sum of at least one indenter.
    subroutine new_profile_sum(self, terms, error)
        type(profile_sum_t), intent(out) :: self
        type(profile_term_t), intent(in) :: terms(:)
        type(error_t), allocatable, intent(out) :: error
        integer :: i

        if (size(terms) == 0) call raise(error, error_invalid, "terms: the array is empty. Give at least one profile")
        do i = 1, size(terms)
            if (.not. allocated(terms(i)%profile)) call raise(error, error_invalid, "terms: each term must contain a profile")
        end do
        if (.not. allocated(error)) call room(bytes_of(terms), error)
        if (allocated(error)) return
        allocate (self%terms, source=terms)
        self%end_radius = huge(1.0_wp)
        do i = 1, size(terms)
            associate (term => terms(i)%profile)
                ! the term that ends first has a vertical wall or a sharp end there
                if (term%largest_radius <= self%largest_radius) then
                    self%sharp_radius = term%sharp_radius
                    self%has_wall = term%has_wall .or. (self%has_wall .and. term%largest_radius >= self%largest_radius)
                end if
                self%largest_radius = min(self%largest_radius, term%largest_radius)
                self%singular_radius = min(self%singular_radius, term%singular_radius)
                self%end_radius = min(self%end_radius, term%end_radius)
            end associate
        end do
        self%is_made = .not. allocated(error)
    end subroutine new_profile_sum

    pure recursive function bytes(self)
        class(profile_sum_t), intent(in) :: self
        integer(int64) :: bytes

        bytes = bytes_of(self%terms)
    end function bytes

    pure recursive function bytes_of(terms) result(bytes)
        type(profile_term_t), intent(in) :: terms(:)
        integer(int64) :: bytes
        integer :: i

        bytes = storage_size(terms)/8*size(terms, kind=int64)
        do i = 1, size(terms)
            bytes = bytes + terms(i)%profile%bytes()
        end do
    end function bytes_of

    elemental function height(self, x) result(y)
        class(profile_sum_t), intent(in) :: self
        real(wp), intent(in) :: x
        real(wp) :: y
        integer :: i

        y = 0.0_wp
        do i = 1, size(self%terms)
            y = y + self%terms(i)%profile%height(x)
        end do
    end function height

    elemental function slope(self, x) result(y)
        class(profile_sum_t), intent(in) :: self
        real(wp), intent(in) :: x
        real(wp) :: y
        integer :: i

        y = 0.0_wp
        do i = 1, size(self%terms)
            y = y + self%terms(i)%profile%slope(x)
        end do
    end function slope

    elemental function mdr(self, x) result(y)
        class(profile_sum_t), intent(in) :: self
        real(wp), intent(in) :: x
        real(wp) :: y
        integer :: i

        y = 0.0_wp
        do i = 1, size(self%terms)
            y = y + self%terms(i)%profile%mdr(x)
        end do
    end function mdr

    elemental function mdr_slope(self, x) result(y)
        class(profile_sum_t), intent(in) :: self
        real(wp), intent(in) :: x
        real(wp) :: y
        integer :: i

        y = 0.0_wp
        do i = 1, size(self%terms)
            y = y + self%terms(i)%profile%mdr_slope(x)
        end do
    end function mdr_slope

    elemental function mdr_slope_beyond(self, start, distance) result(y)
        class(profile_sum_t), intent(in) :: self
        real(wp), intent(in) :: start, distance
        real(wp) :: y
        integer :: i

        y = 0.0_wp
        do i = 1, size(self%terms)
            y = y + self%terms(i)%profile%mdr_slope_beyond(start, distance)
        end do
    end function mdr_slope_beyond

    elemental function mdr_moment(self, x) result(y)
        class(profile_sum_t), intent(in) :: self
        real(wp), intent(in) :: x
        real(wp) :: y
        integer :: i

        y = 0.0_wp
        do i = 1, size(self%terms)
            y = y + self%terms(i)%profile%mdr_moment(x)
        end do
    end function mdr_moment

    pure subroutine add_breaks(self, radii, error)
        class(profile_sum_t), intent(in) :: self
        real(wp), allocatable, intent(inout) :: radii(:)
        type(error_t), allocatable, intent(inout) :: error
        real(wp), allocatable :: own(:)
        integer :: i

        do i = 1, size(self%terms)
            call self%terms(i)%profile%add_breaks(own, error)
        end do
        call merge_breaks(radii, own(:count(own < self%largest_radius)), error)
    end subroutine add_breaks

    !> Powers of all terms, if each is a sum of powers.
    pure subroutine powers(self, exponents, coefficients)
        class(profile_sum_t), intent(in) :: self
        real(wp), allocatable, intent(out) :: exponents(:), coefficients(:)
        real(wp), allocatable :: more_exponents(:), more_coefficients(:)
        integer :: i

        allocate (exponents(0), coefficients(0))
        do i = 1, size(self%terms)
            call self%terms(i)%profile%powers(more_exponents, more_coefficients)
            exponents = [exponents, more_exponents]
            coefficients = [coefficients, more_coefficients]
            if (size(more_exponents) > 0) cycle
            exponents = more_exponents
            coefficients = more_coefficients
            return
        end do
    end subroutine powers

end module mdrcontact_profile_sum
