! SPDX-License-Identifier: GPL-3.0-or-later
!> A user-defined f(r) as the height of an indenter, down to the axis.
!>
!> A formula such as R - sqrt(R^2 - r^2) loses its digits towards the axis. Below the radius where that shows as scatter of the
!> values, f is continued by the series r^s (c_0 + c_1 r^k + c_2 r^2k + ...), k = 2 or 1, that agrees with the values there within
!> their scatter, if they determine it well enough; else an error is raised. A curvature is no scatter: where the values do not
!> scatter they are taken as they are.
module mdrcontact_profile_user_height
    use mdrcontact_error, only: error_invalid, error_no_convergence, error_t, raise, to_text
    use mdrcontact_kinds, only: wp
    use mdrcontact_lapack, only: dgels
    use mdrcontact_numerics_chebyshev, only: chebyshev_sum
    use mdrcontact_numerics_scalar_function, only: scalar_function_t
    use mdrcontact_numerics_scatter, only: scatter_at
    use mdrcontact_profile_sampled, only: first_edge
    implicit none (type, external)
    private
    public :: user_height_t, new_user_height

    !> The height over the lowest point.
    type, extends(scalar_function_t) :: user_height_t
        !> scatter of the values relative to themselves, the largest that is taken as it is
        real(wp) :: roughness = epsilon(1.0_wp)
        class(scalar_function_t), pointer, private :: f => null()
        !> f at the axis
        real(wp), private :: lowest = 0.0_wp
        !> where the series begins, 0 if it does not exist
        real(wp), private :: radius = 0.0_wp
        !> of the series: s and k, and Chebyshev coefficients of (r/radius)^k
        integer, private :: first_power = 2, step = 2
        real(wp), allocatable, private :: coefficients(:)
    contains
        procedure :: value
    end type user_height_t

    !> f(0) may differ from 0 by this much of the largest height.
    real(wp), parameter :: start_tolerance = 1.0e-12_wp
    !> Scatter relative to the value from which on it is a loss of digits; a formula without cancellation has 1e-16 to 1e-15.
    real(wp), parameter :: lost = 1.0e-13_wp
    !> Where lost digits are searched for: down to this radius and height, relative to the largest.
    real(wp), parameter :: smallest_radius = 1.0e-10_wp, smallest_value = 1.0e-20_wp
    !> Largest relative error of the height close to the axis, where a series continues it.
    real(wp), parameter :: series_accuracy = 3.0e-10_wp
    !> Number of values, of which every other one is fitted and the rest compared, and most terms of a series in r^2 and in r.
    integer, parameter :: samples = 128, most_terms(2) = [12, 6]
    !> Where the scatter is considered, relative to the radius of the series.
    real(wp), parameter :: places(4) = [1.0_wp, 0.87_wp, 0.61_wp, 0.52_wp]
    !> Standard deviations of the values within which a series agrees with them: in the mean, and at every one.
    real(wp), parameter :: mean_limit = 3.0_wp, single_limit = 10.0_wp
    !> Keeps the radii off edges of panels.
    real(wp), parameter :: irrational = 0.7320508075688772_wp

contains

    !> Finds the radius down to which f is accurate.
    subroutine new_user_height(self, f, largest, error)
        type(user_height_t), intent(out) :: self
        !> f(r) on [0, largest] [length]
        class(scalar_function_t), intent(inout), target :: f
        !> > 0 [length]
        real(wp), intent(in) :: largest
        type(error_t), allocatable, intent(out) :: error
        real(wp) :: top, radius, scatter, exponent

        self%f => f
        top = 0.0_wp
        self%lowest = f%value(0.0_wp)
        if (.not. allocated(f%error)) top = f%value(largest)
        if (allocated(f%error)) error = f%error
        if (.not. allocated(error)) call check_start(self%lowest, top, error)
        if (allocated(error)) return
        call find_loss(self, largest, radius, scatter, exponent)
        if (allocated(f%error)) error = f%error
        if (allocated(error)) return
        if (scatter > 0.0_wp) call continue_to_axis(self, radius, largest, scatter, exponent, error)
    end subroutine new_user_height

    subroutine check_start(lowest, top, error)
        real(wp), intent(in) :: lowest, top
        type(error_t), allocatable, intent(inout) :: error

        if (abs(lowest) > start_tolerance*abs(top)) then
            call raise(error, error_invalid, "f(0) = "//to_text(lowest)//": heights are relative to the lowest point of the "// &
                       "indenter, f(0) = 0")
        else if (.not. top > lowest) then
            call raise(error, error_invalid, "f at the largest radius = "//to_text(top)//": the profile must increase")
        end if
    end subroutine check_start

    function value(self, x) result(y)
        class(user_height_t), intent(inout) :: self
        real(wp), intent(in) :: x
        real(wp) :: y

        if (x < self%radius) then
            y = series_at(self, x/self%radius)
        else
            y = self%f%value(x) - self%lowest
            if (allocated(self%f%error)) self%error = self%f%error
        end if
    end function value

    pure function series_at(self, t) result(y)
        type(user_height_t), intent(in) :: self
        real(wp), intent(in) :: t
        real(wp) :: y

        y = t**self%first_power*chebyshev_sum(self%coefficients, 2.0_wp*t**self%step - 1.0_wp)
    end function series_at

    !> The largest radius, by octaves, at which the values scatter by more than `lost`, the scatter and the exponent of r there;
    !> scatter is 0 if it does not exist.
    subroutine find_loss(self, largest, radius, scatter, exponent)
        type(user_height_t), intent(inout) :: self
        real(wp), intent(in) :: largest
        real(wp), intent(out) :: radius, scatter, exponent
        real(wp) :: here, outside, top, ratio

        top = self%f%value(largest) - self%lowest
        exponent = 0.0_wp
        outside = top
        ratio = irrational
        radius = largest
        scatter = 0.0_wp
        do while (radius > smallest_radius*largest)
            here = self%f%value(irrational*radius) - self%lowest
            if (allocated(self%f%error)) return
            if (.not. here > smallest_value*top) exit
            exponent = -log(outside/here)/log(ratio)
            scatter = scatter_at(self%f, irrational*radius, 0.01_wp*lost)
            if (allocated(self%f%error)) return
            if (scatter > lost*here) return
            self%roughness = max(self%roughness, scatter/here)
            outside = here
            ratio = merge(first_edge, 0.5_wp, radius >= largest)
            radius = ratio*radius
        end do
        scatter = 0.0_wp
    end subroutine find_loss

    !> The series below `radius`, or if the values there do not determine it, below twice the radius.
    subroutine continue_to_axis(self, radius, largest, scatter, exponent, error)
        type(user_height_t), intent(inout) :: self
        !> at most `largest` [length]
        real(wp), intent(in) :: radius, largest
        !> of the values at irrational*radius [length], and the local power of r
        real(wp), intent(in) :: scatter, exponent
        type(error_t), allocatable, intent(inout) :: error
        logical :: found

        call try_series(self, radius, scatter, max(nint(exponent), 1), found)
        if (.not. (found .or. allocated(self%f%error))) then
            call try_series(self, min(2.0_wp*radius, largest), scatter, max(nint(exponent), 1), found)
        end if
        if (allocated(self%f%error)) then
            error = self%f%error
        else if (.not. found) then
            call raise(error, error_no_convergence, "the profile function f is inaccurate near the axis: at r = "// &
                       to_text(irrational*radius)//", of "//to_text(largest)//", its values scatter by "// &
                       to_text(scatter/(self%f%value(irrational*radius) - self%lowest))//" of themselves, and they do not "// &
                       "determine f closer to the axis. Write it without differences of large terms, r^2/(R + sqrt(R^2 - "// &
                       "r^2)) rather than R - sqrt(R^2 - r^2)")
        end if
    end subroutine continue_to_axis

    !> The first of the series, from the most special on, that agrees with the values below a radius and is determined by them.
    subroutine try_series(self, radius, scatter, power, found)
        type(user_height_t), intent(inout) :: self
        real(wp), intent(in) :: radius, scatter
        !> the largest first power
        integer, intent(in) :: power
        logical, intent(out) :: found
        real(wp) :: heights(samples), noise
        integer :: i

        found = .false.
        do i = 1, samples
            heights(i) = self%f%value(radius*place(i)) - self%lowest
            if (allocated(self%f%error)) return
        end do
        noise = scatter
        do i = 1, size(places)
            noise = max(noise, scatter_at(self%f, places(i)*radius, 0.0_wp))
        end do
        call find_series(self, heights, noise, power, 2, found)
        do i = power, 1, -1
            if (.not. found) call find_series(self, heights, noise, i, 1, found)
        end do
        if (found) self%radius = radius
    end subroutine try_series

    !> Where value i is taken, relative to the radius.
    elemental function place(i) result(t)
        integer, intent(in) :: i
        real(wp) :: t

        t = (i - 1 + irrational)/samples
    end function place

    !> The shortest series that agrees with the values, and one term more: what the term changes is part of the error.
    subroutine find_series(self, heights, noise, first_power, step, found)
        type(user_height_t), intent(inout) :: self
        !> (samples) heights, and their standard deviation [length]
        real(wp), intent(in) :: heights(samples), noise
        integer, intent(in) :: first_power, step
        logical, intent(out) :: found
        real(wp) :: before, uncertainty, at_axis, constant
        integer :: terms
        logical :: agreed, agrees

        found = .false.
        agrees = .false.
        before = 0.0_wp
        self%first_power = first_power
        self%step = step
        do terms = 1, most_terms(step) + 1
            agreed = agrees
            call fit_series(self, heights, noise, terms, constant, uncertainty, agrees)
            at_axis = chebyshev_sum(self%coefficients, -1.0_wp)
            if (agreed) exit
            before = at_axis
        end do
        if (.not. (agreed .and. agrees)) return
        found = uncertainty + abs(at_axis - before) <= series_accuracy*at_axis
        if (found) self%lowest = self%lowest + constant
    end subroutine find_series

    !> Least squares with a constant, which is the rounding error of f(0): every other value is fitted, the others are compared.
    subroutine fit_series(self, heights, noise, terms, constant, uncertainty, agrees)
        type(user_height_t), intent(inout) :: self
        real(wp), intent(in) :: heights(samples), noise
        integer, intent(in) :: terms
        !> what the series leaves at the axis, and three standard deviations of its coefficient of r^s [length]
        real(wp), intent(out) :: constant, uncertainty
        logical, intent(out) :: agrees
        real(wp) :: matrix(samples/2, terms + 1), right(samples/2), work(64*(terms + 1)), misfit(samples)
        real(wp) :: at_axis(terms + 1)
        integer :: i, j, info

        do i = 1, samples/2
            associate (t => place(2*i))
                do j = 1, terms
                    matrix(i, j) = t**self%first_power*cos((j - 1)*acos(2.0_wp*t**self%step - 1.0_wp))
                end do
            end associate
        end do
        matrix(:, terms + 1) = 1.0_wp
        right = heights(2::2)
        call dgels("N", size(matrix, 1), terms + 1, 1, matrix, size(matrix, 1), right, size(right), work, size(work), info)
        self%coefficients = right(:terms)
        constant = right(terms + 1)
        do i = 1, samples
            misfit(i) = heights(i) - constant - series_at(self, place(i))
        end do
        agrees = info == 0 .and. norm2(misfit) <= mean_limit*noise*sqrt(real(samples, wp)) .and. &
                 maxval(abs(misfit)) <= single_limit*noise .and. abs(constant) <= single_limit*noise
        ! the coefficient is at_axis . right; R of the matrix Q R gives its variance
        at_axis = [((-1.0_wp)**(j - 1), j=1, terms), 0.0_wp]
        do j = 1, terms + 1
            at_axis(j) = (at_axis(j) - dot_product(matrix(:j - 1, j), at_axis(:j - 1)))/matrix(j, j)
        end do
        uncertainty = 3.0_wp*noise*norm2(at_axis)
    end subroutine fit_series

end module mdrcontact_profile_user_height
