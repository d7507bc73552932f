! SPDX-License-Identifier: GPL-3.0-or-later
!> A calibrated nanoindenter tip by its area function A(f) = C0 f^2 + C1 f + C2 f^(1/2) + C3 f^(1/4) + ..., A = pi r^2.
!> Oliver, Pharr, J. Mater. Res. 7 (1992) 1564.
module mdrcontact_profile_area_function
    use mdrcontact_parameter, only: nature_signed, nature_term, parameter_t
    use mdrcontact_error, only: check_finite, check_made, check_not_negative, check_positive, count_text, error_invalid, error_t, &
                                raise, to_text
    use mdrcontact_gsl, only: disable_gsl_abort
    use mdrcontact_kinds, only: pi, wp
    use mdrcontact_profile, only: profile_t
    use mdrcontact_profile_sampled, only: sample_from_height, sampled_profile_t
    use mdrcontact_numerics_roots, only: solve_increasing
    use mdrcontact_numerics_scalar_function, only: scalar_function_t
    implicit none (type, external)
    private
    public :: area_function_t, new_area_function_profile

    !> A tip with the area function from which it was sampled.
    type, extends(sampled_profile_t) :: area_function_t
        private
        real(wp), allocatable :: coefficients(:)
        real(wp) :: min_height = 0.0_wp, max_height = 0.0_wp
    contains
        procedure :: parameters
        procedure :: with_parameters
    end type area_function_t

    !> The height f at radius r, from A(f) = pi r^2.
    type, extends(scalar_function_t) :: height_t
        real(wp), allocatable :: coefficients(:)
        real(wp) :: min_height = 0.0_wp, max_height = 0.0_wp
    contains
        procedure :: value => height_at
    end type height_t

    !> ln(A(f)/wanted) at x = ln(f/max_height): the ratio keeps its digits however small the unit of length makes f.
    type, extends(scalar_function_t) :: mismatch_t
        real(wp), allocatable :: coefficients(:)
        real(wp) :: max_height = 0.0_wp, wanted = 0.0_wp
    contains
        procedure :: value => mismatch_at
    end type mismatch_t

    integer, parameter :: monotony_samples = 2000
    !> of f to max_height where the search for f begins
    real(wp), parameter :: smallest_ratio = 1.0e-300_wp

contains

    !> A tip from its area function, for heights up to `max_height`.
    subroutine new_area_function_profile(self, coefficients, min_height, max_height, error)
        type(area_function_t), intent(out) :: self
        !> C0, C1, C2, ... of f^2, f, f^(1/2), f^(1/4), ... [length^0, length^1, length^(3/2), ...], at least C0
        real(wp), intent(in) :: coefficients(:)
        !> height below which the fitted area function is not to be trusted, 0 if it does not exist [length]; below it the tip is a
        !> paraboloid that meets the area function there
        real(wp), intent(in) :: min_height
        !> height up to which the tip is used; a contact cannot be deeper [length]
        real(wp), intent(in) :: max_height
        type(error_t), allocatable, intent(out) :: error
        type(height_t) :: height
        real(wp), allocatable :: breaks(:)
        integer :: i

        call disable_gsl_abort()
        call check_not_negative(error, "min_height", min_height)
        call check_positive(error, "max_height", max_height)
        if (size(coefficients) == 0) call raise(error, error_invalid, "coefficients: the array is empty. Give at least C0")
        do i = 1, size(coefficients)
            call check_finite(error, "coefficients", coefficients(i), i)
        end do
        if (allocated(error)) return
        if (max_height <= min_height) then
            call raise(error, error_invalid, "max_height = "//to_text(max_height)//": it must be greater than min_height = "// &
                       to_text(min_height))
            return
        end if
        call check_growing(coefficients, min_height, max_height, error)
        if (allocated(error)) return

        self%coefficients = coefficients
        self%min_height = min_height
        self%max_height = max_height
        height%coefficients = coefficients
        height%min_height = min_height
        height%max_height = max_height
        allocate (breaks(0))
        if (min_height > 0.0_wp) breaks = [radius_at(coefficients, min_height)]
        call sample_from_height(self%sampled_profile_t, height, radius_at(coefficients, max_height), 0.0_wp, breaks, &
                                scatter_of_heights(coefficients, min_height, max_height), error)
        self%is_made = .not. allocated(error)
    end subroutine new_area_function_profile

    !> Its coefficients. The last one is the area next to the apex, unless another shape is below min_height.
    pure subroutine parameters(self, list)
        class(area_function_t), intent(in) :: self
        type(parameter_t), allocatable, intent(out) :: list(:)
        integer :: i, nature

        nature = merge(nature_signed, nature_term, self%min_height > 0.0_wp)
        allocate (list(size(self%coefficients)))
        do i = 1, size(list)
            list(i) = parameter_t("C"//count_text(i - 1), self%coefficients(i), nature)
        end do
    end subroutine parameters

    subroutine with_parameters(self, values, profile, error)
        class(area_function_t), intent(in) :: self
        real(wp), intent(in) :: values(:)
        class(profile_t), allocatable, intent(out) :: profile
        type(error_t), allocatable, intent(out) :: error
        type(area_function_t), allocatable :: other

        call check_made(error, "profile", self%is_made)
        if (allocated(error)) return
        allocate (other)
        call new_area_function_profile(other, values, self%min_height, self%max_height, error)
        call move_alloc(other, profile)
    end subroutine with_parameters

    !> A(f) = C0 f^2 + C1 f + C2 f^(1/2) + ... [length^2]
    pure function projected_area(coefficients, height) result(area)
        real(wp), intent(in) :: coefficients(:), height
        real(wp) :: area
        real(wp) :: power
        integer :: i

        area = coefficients(1)*height**2
        power = height
        do i = 2, size(coefficients)
            area = area + coefficients(i)*power
            power = sqrt(power)
        end do
    end function projected_area

    !> Largest relative rounding of the height at a radius: large coefficients of both signs cancel in the area.
    pure function scatter_of_heights(coefficients, min_height, max_height) result(scatter)
        real(wp), intent(in) :: coefficients(:), min_height, max_height
        real(wp) :: scatter
        real(wp) :: low, height, step
        integer :: i

        scatter = epsilon(scatter)
        low = max(min_height, 1.0e-12_wp*max_height)
        step = (max_height/low)**(1.0_wp/monotony_samples)
        do i = 0, monotony_samples - 1
            height = low*step**i
            ! d ln A: what a step of ln f changes
            scatter = max(scatter, epsilon(scatter)*projected_area(abs(coefficients), height)*log(step) &
                          /max(projected_area(coefficients, height*step) - projected_area(coefficients, height), tiny(1.0_wp)))
        end do
    end function scatter_of_heights

    pure function radius_at(coefficients, height) result(radius)
        real(wp), intent(in) :: coefficients(:), height
        real(wp) :: radius

        radius = sqrt(projected_area(coefficients, height)/pi)
    end function radius_at

    !> A tip has to widen from its apex up; a fitted area function often does not close to the apex.
    pure subroutine check_growing(coefficients, min_height, max_height, error)
        real(wp), intent(in) :: coefficients(:), min_height, max_height
        type(error_t), allocatable, intent(inout) :: error
        real(wp) :: low, height, area, area_before
        integer :: i

        low = max(min_height, 1.0e-12_wp*max_height)
        area_before = 0.0_wp
        do i = monotony_samples, 0, -1
            height = max_height*(low/max_height)**(real(i, wp)/monotony_samples)
            area = projected_area(coefficients, height)
            if (.not. area > area_before) then
                call raise(error, error_invalid, "coefficients: the area A(f) = "//to_text(area)// &
                           " does not increase at height f = "//to_text(height)//". Give a min_height above it")
                return
            end if
            area_before = area
        end do
    end subroutine check_growing

    function height_at(self, x) result(y)
        class(height_t), intent(inout) :: self
        real(wp), intent(in) :: x
        real(wp) :: y
        type(mismatch_t) :: mismatch
        real(wp) :: root
        logical :: found

        y = 0.0_wp
        if (x <= 0.0_wp) return
        if (self%min_height > 0.0_wp) then
            if (x <= radius_at(self%coefficients, self%min_height)) then
                y = self%min_height*(x/radius_at(self%coefficients, self%min_height))**2
                return
            end if
        end if
        mismatch%coefficients = self%coefficients
        mismatch%max_height = self%max_height
        mismatch%wanted = pi*x**2
        call solve_increasing(mismatch, 0.0_wp, 2.0_wp, log(max(self%min_height/self%max_height, smallest_ratio)), 0.0_wp, &
                              root, found, self%error)
        if (.not. allocated(self%error)) y = self%max_height*exp(root)
    end function height_at

    function mismatch_at(self, x) result(y)
        class(mismatch_t), intent(inout) :: self
        real(wp), intent(in) :: x
        real(wp) :: y

        y = log(max(projected_area(self%coefficients, self%max_height*exp(x)), tiny(1.0_wp))/self%wanted)
    end function mismatch_at

end module mdrcontact_profile_area_function
