! SPDX-License-Identifier: GPL-3.0-or-later
!> A quantity known as a function of the contact radius, by a table or by sampling a function: E_eff(a), zeta(a).
!>
!> It is interpolated in ln a, and constant below its smallest radius: forces are integrated from first contact.
module mdrcontact_numerics_radius_law
    use, intrinsic :: iso_fortran_env, only: int64
    use mdrcontact_nonfinite, only: is_finite
    use mdrcontact_object, only: real_bytes
    use mdrcontact_error, only: check_positive, check_table, error_callback, error_invalid, error_memory, error_no_convergence, &
                                error_t, raise, to_text
    use mdrcontact_gsl, only: disable_gsl_abort
    use mdrcontact_kinds, only: wp
    use mdrcontact_numerics_monotone_table, only: monotone_table_t, new_monotone_table
    use mdrcontact_numerics_quadrature, only: merge_breaks
    use mdrcontact_numerics_sampled_function, only: new_sampled_function, sampled_function_t
    use mdrcontact_numerics_scalar_function, only: scalar_function_t
    implicit none (type, external)
    private
    public :: radius_law_t, new_radius_law_from_table, new_radius_law_from_function
    public :: interpolation_roughness

    !> Relative error of the slope of an interpolated quantity: a function that is itself computed to 1e-9 has no better one.
    real(wp), parameter :: interpolation_roughness = 1.0e-6_wp
    !> Relative, of the values of a user function, which may itself have been solved with ever more unknowns.
    real(wp), parameter :: noise_of_values = 1.0e-10_wp

    !> The interpolated quantity. Beyond its largest radius it is not evaluated.
    type :: radius_law_t
        !> whether it was made: set last by what makes it
        logical :: is_made = .false.
        !> of the table or the range; read only [length]
        real(wp) :: smallest_radius = 0.0_wp, largest_radius = 0.0_wp
        !> one of the two
        type(monotone_table_t), allocatable, private :: table
        type(sampled_function_t), allocatable, private :: sampled
        real(wp), allocatable, private :: breaks(:)
    contains
        procedure :: at
        procedure :: bytes
        procedure :: slope_at
        procedure :: add_breaks
    end type radius_law_t

    !> The function of ln a, watched for values that are not positive numbers.
    type, extends(scalar_function_t) :: logarithmic_t
        class(scalar_function_t), pointer :: f => null()
        character(len=:), allocatable :: name
        !> the last a
        real(wp) :: last = 0.0_wp
    contains
        procedure :: value => logarithmic_value
    end type logarithmic_t

contains

    !> The law through the points (radius, values), interpolated in ln a without overshoot (Steffen).
    subroutine new_radius_law_from_table(self, radius, name, values, error)
        type(radius_law_t), intent(out) :: self
        !> ascending contact radii > 0, at least 3 [length]
        real(wp), intent(in) :: radius(:)
        !> name of the values in error messages
        character(len=*), intent(in) :: name
        !> positive, same size as radius
        real(wp), intent(in) :: values(:)
        type(error_t), allocatable, intent(out) :: error
        real(wp), allocatable :: logarithms(:)
        integer :: i, stat

        call check_table(error, "radius", radius, name, values, 3)
        if (allocated(error)) return
        call check_positive(error, "radius", radius(1), 1)
        do i = 1, size(values)
            call check_positive(error, name, values(i), i)
        end do
        if (allocated(error)) return
        self%smallest_radius = radius(1)
        self%largest_radius = radius(size(radius))
        allocate (self%table, self%breaks(size(radius)), logarithms(size(radius)), stat=stat)
        if (stat /= 0) then
            call raise(error, error_memory, "not enough memory for a table")
            return
        end if
        self%breaks(:) = radius
        logarithms(:) = log(radius)
        call new_monotone_table(self%table, logarithms, values, error)
        self%is_made = .not. allocated(error)
    end subroutine new_radius_law_from_table

    !> The law f(a) between two radii, sampled to a relative tolerance. f is called here and never again.
    subroutine new_radius_law_from_function(self, f, name, smallest, largest, tolerance, error, most, everywhere)
        type(radius_law_t), intent(out) :: self
        !> a positive, smooth function of the contact radius
        class(scalar_function_t), intent(inout), target :: f
        !> name of the values in error messages
        character(len=*), intent(in) :: name
        !> 0 < smallest < largest [length]
        real(wp), intent(in) :: smallest, largest
        !> relative, of the sampling
        real(wp), intent(in) :: tolerance
        type(error_t), allocatable, intent(out) :: error
        !> panels of the sampling, beyond which f is not smooth enough; default that of new_sampled_function
        integer, intent(in), optional :: most
        !> whether f may have narrow features, as in new_sampled_function
        logical, intent(in), optional :: everywhere
        type(logarithmic_t) :: logarithmic

        call disable_gsl_abort()
        call check_positive(error, "smallest_radius", smallest)
        call check_positive(error, "largest_radius", largest)
        if (allocated(error)) return
        if (largest <= smallest) then
            call raise(error, error_invalid, "largest_radius = "//to_text(largest)// &
                       ": it must be greater than smallest_radius = "//to_text(smallest))
            return
        end if
        logarithmic%f => f
        logarithmic%name = name
        self%smallest_radius = smallest
        self%largest_radius = largest
        allocate (self%sampled)
        call new_sampled_function(self%sampled, logarithmic, octaves(log(smallest), log(largest)), &
                                  spread(.false., 1, size(octaves(log(smallest), log(largest))) - 1), tolerance, error, most=most, &
                                  everywhere=everywhere, least_size=1.0_wp, steps=noise_of_values)
        if (.not. allocated(error)) then
            self%breaks = fine_edges(self%sampled)
        else if (error%code == error_no_convergence) then
            deallocate (error)
            call raise(error, error_no_convergence, "the function for "//name//" is not smooth enough to be sampled near a = "// &
                       to_text(logarithmic%last))
        end if
        self%is_made = .not. allocated(error)
    end subroutine new_radius_law_from_function

    !> Size of a copy [byte].
    pure function bytes(self)
        class(radius_law_t), intent(in) :: self
        integer(int64) :: bytes

        bytes = real_bytes*size(self%breaks)
        if (allocated(self%table)) bytes = bytes + self%table%bytes()
        if (allocated(self%sampled)) bytes = bytes + self%sampled%bytes()
    end function bytes

    !> The value at radius a <= largest_radius.
    elemental function at(self, a) result(y)
        class(radius_law_t), intent(in) :: self
        !> contact radius [length]
        real(wp), intent(in) :: a
        real(wp) :: y
        real(wp) :: x

        x = log(min(max(a, self%smallest_radius), self%largest_radius))
        if (allocated(self%table)) then
            y = self%table%at(x)
        else
            y = self%sampled%value(x)
        end if
    end function at

    !> The derivative with respect to a.
    elemental function slope_at(self, a) result(y)
        class(radius_law_t), intent(in) :: self
        !> contact radius [length]
        real(wp), intent(in) :: a
        real(wp) :: y

        if (a < self%smallest_radius .or. a > self%largest_radius) then
            y = 0.0_wp
        else if (allocated(self%table)) then
            y = self%table%slope_at(log(a))/a
        else
            y = self%sampled%slope(log(a))/a
        end if
    end function slope_at

    !> Radii where the law is not analytic: the points of a table.
    pure subroutine add_breaks(self, radii, error)
        class(radius_law_t), intent(in) :: self
        !> ascending [length]; not allocated: none yet
        real(wp), allocatable, intent(inout) :: radii(:)
        type(error_t), allocatable, intent(inout) :: error

        call merge_breaks(radii, self%breaks, error)
    end subroutine add_breaks

    !> Radii between which the law varies so fast that its sampling was refined: quadrature follows it there. And the smallest
    !> one where the law, constant below, has a kink.
    pure function fine_edges(sampled) result(radii)
        type(sampled_function_t), intent(in) :: sampled
        real(wp), allocatable :: radii(:)
        real(wp), allocatable :: edges(:)
        logical, allocatable :: fine(:)
        real(wp), parameter :: level = 1.0e-12_wp
        integer :: n

        allocate (edges, source=sampled%edges)
        n = size(edges)
        allocate (fine(n), source=.false.)
        fine(2:n - 1) = min(edges(2:n - 1) - edges(:n - 2), edges(3:) - edges(2:n - 1)) < 0.45_wp
        fine(1) = abs(sampled%slope(edges(1))) > level*sampled%value(edges(1))
        radii = exp(pack(edges, fine))
    end function fine_edges

    !> Panel edges about 1 apart in ln a, the scale on which effective moduli vary.
    pure function octaves(first, last) result(edges)
        real(wp), intent(in) :: first, last
        real(wp), allocatable :: edges(:)
        integer :: i, count

        count = max(1, nint(last - first))
        edges = [(first + (last - first)*(real(i, wp)/count), i=0, count)]
        edges(count + 1) = last
    end function octaves

    function logarithmic_value(self, x) result(y)
        class(logarithmic_t), intent(inout) :: self
        real(wp), intent(in) :: x
        real(wp) :: y

        self%last = exp(x)
        y = self%f%value(self%last)
        if (allocated(self%f%error)) then
            self%error = self%f%error
        else if (.not. (is_finite(y) .and. y > 0.0_wp)) then
            call raise(self%error, error_callback, "the function for "//self%name//" returned "//to_text(y)//" at a = "// &
                       to_text(self%last)//": it must return a finite number greater than 0")
        end if
    end function logarithmic_value

end module mdrcontact_numerics_radius_law
