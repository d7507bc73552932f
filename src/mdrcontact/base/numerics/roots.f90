! SPDX-License-Identifier: GPL-3.0-or-later
!> Roots of a scalar function by GSL's bracketing Brent solver.
module mdrcontact_numerics_roots
    use, intrinsic :: iso_c_binding, only: c_associated, c_double, c_f_pointer, c_funloc, c_int, c_loc, c_ptr
    use mdrcontact_error, only: error_memory, error_no_convergence, error_t, raise, to_text
    use mdrcontact_gsl, only: disable_gsl_abort, gsl_function, gsl_root_fsolver_alloc, gsl_root_fsolver_brent, &
                              gsl_root_fsolver_free, gsl_root_fsolver_iterate, gsl_root_fsolver_root, gsl_root_fsolver_set, &
                              gsl_root_fsolver_x_lower, gsl_root_fsolver_x_upper, gsl_root_test_interval, gsl_success
    use mdrcontact_kinds, only: wp
    use mdrcontact_numerics_scalar_function, only: scalar_function_t
    implicit none (type, external)
    private
    public :: find_root, solve_increasing, guess_from_below, inverse_cubic, cubic_error

    integer, parameter :: most_iterations = 200
    !> Newton's or secant steps before Brent's method takes over.
    integer, parameter :: most_secants = 12
    !> Steps that are halved.
    integer, parameter :: most_refused = 6
    real(wp), parameter :: relative_width = 4.0_wp*epsilon(1.0_wp)
    real(wp), parameter :: widest_step = 50.0_wp
    !> A slope between points that are not farther apart is one of the function near them.
    real(wp), parameter :: nearby = 0.1_wp
    !> Steps that shrink less do not converge yet; the distance from the root at which they end.
    real(wp), parameter :: largest_ratio = 0.1_wp, negligible = 0.1_wp*epsilon(1.0_wp)
    !> A function that takes an accuracy takes steps of this length at most, begins with this accuracy, and is considered with this
    !> part of the distance that is left to the root; Newton's steps leave this part of their square.
    real(wp), parameter :: careful_step = 2.0_wp, first_accuracy = 1.0e-2_wp, share = 0.1_wp, curvature = 0.3_wp
    !> Square of a distance of values, and length of a step, below which a cubic does not pay.
    real(wp), parameter :: closest = 1.0e-8_wp, close_by = 1.0e-3_wp
    !> Steps that f takes as near enough must leave no more of f than at this slope.
    real(wp), parameter :: steepest = 10.0_wp
    !> Points at which a cubic is considered for its first root.
    integer, parameter :: probes = 32

    !> Lets a polymorphic function travel through GSL's `void *params`.
    type :: carrier_t
        class(scalar_function_t), pointer :: f => null()
    end type carrier_t

contains

    !> The root of f between lower and upper, where f has opposite signs, to a few units in the last place.
    subroutine find_root(f, lower, upper, root, error)
        class(scalar_function_t), intent(inout), target :: f
        real(wp), intent(in) :: lower, upper
        real(wp), intent(out) :: root
        type(error_t), allocatable, intent(out) :: error
        type(carrier_t), target :: carrier
        type(gsl_function) :: gsl_f
        type(c_ptr) :: solver
        integer(c_int) :: status
        integer :: iteration

        root = lower
        call disable_gsl_abort()
        solver = gsl_root_fsolver_alloc(gsl_root_fsolver_brent)
        if (.not. c_associated(solver)) then
            call raise(error, error_memory, "not enough memory for a root finder")
            return
        end if
        carrier%f => f
        gsl_f%function = c_funloc(evaluate)
        gsl_f%params = c_loc(carrier)
        status = gsl_root_fsolver_set(solver, gsl_f, lower, upper)
        if (status == gsl_success) then
            do iteration = 1, most_iterations
                status = gsl_root_fsolver_iterate(solver)
                if (status /= gsl_success .or. allocated(f%error)) exit
                root = gsl_root_fsolver_root(solver)
                status = gsl_root_test_interval(gsl_root_fsolver_x_lower(solver), gsl_root_fsolver_x_upper(solver), &
                                                relative_width, relative_width)
                if (status == gsl_success) exit
            end do
        end if
        call gsl_root_fsolver_free(solver)
        if (allocated(f%error)) then
            error = f%error
        else if (status /= gsl_success) then
            call raise(error, error_no_convergence, "no root found between "//to_text(lower)//" and "//to_text(upper))
        end if
    end subroutine find_root

    !> The root of an increasing f in [smallest, largest] that is close to linear: Newton's steps where f provides its slope, and
    !> from the second on a cubic through two points with theirs, in y, or in x where f is nearly flat or falls for a while; else
    !> secant steps, from `guess` until they converge, bracketed by the signs seen on the way; Brent's method if they do not. The
    !> last step, which leaves less than rounding or than f needs for, is taken without looking at f again, unless f is rough. Far
    !> from the root f is evaluated with less accuracy. A step up to where f has no value is halved, a few times. `found` is false,
    !> and `root` the nearer end, if f keeps its sign over the whole interval.
    subroutine solve_increasing(f, guess, slope, smallest, largest, root, found, error, distance)
        class(scalar_function_t), intent(inout) :: f
        !> starting point and the expected slope of f there
        real(wp), intent(in) :: guess, slope
        real(wp), intent(in) :: smallest, largest
        real(wp), intent(out) :: root
        logical, intent(out) :: found
        type(error_t), allocatable, intent(out) :: error
        !> largest distance of the guess from the root; default 1
        real(wp), intent(in), optional :: distance
        real(wp) :: x, y, x_before, y_before, slope_before, accuracy_before, low, high, left, remaining, step_before
        real(wp) :: ratio_before
        logical :: has_low, has_high, slope_is_local, is_best
        integer :: iteration, refused

        refused = 0
        remaining = 1.0_wp
        if (present(distance)) remaining = distance
        slope_is_local = .true.
        has_low = .false.
        has_high = .false.
        low = smallest
        high = largest
        found = .true.
        x = min(max(guess, smallest), largest)
        root = x
        x_before = x
        y_before = 0.0_wp
        slope_before = 0.0_wp
        accuracy_before = 0.0_wp
        step_before = 0.0_wp
        ratio_before = 1.0_wp
        do iteration = 1, most_iterations
            f%accuracy = 0.0_wp
            if (remaining > f%near_enough .and. f%near_enough > 0.0_wp) then
                f%accuracy = min(first_accuracy, share*max(remaining**2, f%near_enough))
            end if
            y = f%value(x)
            if (allocated(f%error)) then
                if (refused < most_refused .and. y_before < 0.0_wp .and. x > x_before &
                    .and. f%error%code == error_no_convergence) then
                    refused = refused + 1
                    deallocate (f%error)
                    x = 0.5_wp*(x_before + x)
                    step_before = x - x_before
                    remaining = abs(step_before)
                    cycle
                end if
                error = f%error
                return
            end if
            root = x
            is_best = .not. f%accuracy > 0.0_wp
            if (is_best .and. y == 0.0_wp) return
            if (y < -f%accuracy) then
                has_low = .true.
                low = x
            else if (y > f%accuracy) then
                has_high = .true.
                high = x
            end if
            if (is_best .and. iteration > 1 .and. slope_is_local) then
                if (abs(x - x_before) <= relative_width*max(1.0_wp, abs(x))) return
            end if
            if ((x >= largest .and. y < 0.0_wp) .or. (x <= smallest .and. y > 0.0_wp)) then
                found = .not. is_best
                if (is_best) return
                remaining = 0.0_wp
                cycle
            end if
            if (iteration > most_secants .and. has_low .and. has_high) exit
            call take_step()
            if (is_best .and. left <= max(negligible, f%near_enough) .and. .not. f%is_rough) then
                root = x
                return
            end if
        end do
        call find_root(f, low, high, root, error)

    contains

        !> Moves x; a step that is not finite or leaves the bracket becomes a bisection or a wide stride. A step of nothing along
        !> a secant from afar does not mean that the root is here: it becomes a short one, which shows the slope near x.
        subroutine take_step()
            real(wp) :: next, rate, widest, cubic
            logical :: newton, in_y

            ! Where the last step did not help, as close to a vertical wall, the slope at x gives little information about the way
            ! back.
            newton = f%known_slope > 0.0_wp .and. (y_before == 0.0_wp .or. abs(y) < 0.5_wp*abs(y_before) + accuracy_before)
            rate = slope
            slope_is_local = .true.
            if (newton) then
                rate = f%known_slope
            else if (iteration > 1) then
                if (abs(x - x_before) > 0.0_wp) rate = (y - y_before)/(x - x_before)
                slope_is_local = abs(x - x_before) <= nearby
            end if
            if (.not. rate > 0.0_wp) rate = slope
            widest = merge(careful_step, widest_step, f%near_enough > 0.0_wp)
            next = x - min(max(y/rate, -widest), widest)
            left = error_after(next - x, newton)
            remaining = min(abs(next - x), curvature*(next - x)**2 + f%accuracy/rate)
            in_y = .false.
            if (newton .and. slope_before > 0.0_wp .and. f%near_enough > 0.0_wp) then
                cubic = inverse_cubic([x_before, x], [y_before, y], [slope_before, f%known_slope], next, accuracy_before)
                in_y = cubic /= next
                if (in_y) remaining = min(remaining, cubic_error(cubic, [x_before, x]) + f%accuracy/rate)
                next = cubic
            end if
            if (f%near_enough > 0.0_wp .and. .not. in_y .and. slope_before*f%known_slope /= 0.0_wp &
                .and. min(abs(x - x_before), abs(next - x)) > close_by .and. accuracy_before < share*abs(y)) then
                cubic = first_root([x_before, x], [y_before, y], [slope_before, f%known_slope], &
                                   merge(max(low, x - widest), min(high, x + widest), y > 0.0_wp))
                if (cubic /= x) then
                    slope_is_local = .true.
                    next = cubic
                    remaining = abs(next - x)
                end if
            end if
            if (f%near_enough > 0.0_wp) then
                left = abs(next - x)
                ! Next to a vertical tangent the shortest step may come from afar.
                if (abs(y) > steepest*f%near_enough) left = huge(left)
            end if
            if (.not. slope_is_local) then
                left = huge(left)
                if (abs(next - x) <= relative_width*max(1.0_wp, abs(x))) next = x - sign(0.1_wp*nearby, y)
            end if
            if ((next <= low .or. next >= high) .and. left > f%near_enough) then
                left = huge(left)
                if (has_low .and. has_high) next = 0.5_wp*(low + high)
                remaining = abs(next - x)
            end if
            x_before = x
            y_before = y
            slope_before = f%known_slope
            accuracy_before = f%accuracy
            x = min(max(next, smallest), largest)
            step_before = x - x_before
        end subroutine take_step

        !> Distance to the root after a step, estimated from how the steps have shrunk: after Newton by the square of the
        !> last ratio, after secants by the product of the last two.
        function error_after(step, newton) result(distance)
            real(wp), intent(in) :: step
            logical, intent(in) :: newton
            real(wp) :: distance, ratio

            distance = huge(distance)
            ratio = 1.0_wp
            if (step_before /= 0.0_wp .and. y_before /= 0.0_wp) ratio = max(abs(step/step_before), abs(y/y_before))
            if (ratio < largest_ratio) then
                if (newton) then
                    distance = abs(step)*ratio**2
                else if (ratio_before < largest_ratio) then
                    distance = abs(step)*ratio*ratio_before
                end if
            end if
            ratio_before = ratio
        end function error_after

    end subroutine solve_increasing

    !> The root of a function from its values and slopes at two points, by the cubic of x over y: `otherwise` where the root is not
    !> near the second point or the slopes differ by much.
    pure function inverse_cubic(x, y, slopes, otherwise, accuracy) result(root)
        real(wp), intent(in) :: x(2), y(2), slopes(2), otherwise
        !> of the first value
        real(wp), intent(in) :: accuracy
        real(wp) :: root
        real(wp) :: t, dx, dy

        root = otherwise
        dx = x(2) - x(1)
        dy = y(2) - y(1)
        ! from points closer together the errors of the values would make more than the cubic mends
        if (.not. (abs(y(2)) < 1.5_wp*abs(dy) .and. dy**2 > 10.0_wp*accuracy + closest)) return
        if (.not. (minval(slopes)*dx > 0.3_wp*dy .eqv. dy > 0.0_wp)) return
        if (.not. (maxval(slopes)*dx < 3.0_wp*dy .eqv. dy > 0.0_wp)) return
        ! Hermite's form in t, 0 at the second point
        t = y(2)/dy
        root = x(2) - y(2)/slopes(2) + t**2*(dy*(2.0_wp/slopes(2) + 1.0_wp/slopes(1)) - 3.0_wp*dx) &
               + t**3*(2.0_wp*dx - dy*(1.0_wp/slopes(1) + 1.0_wp/slopes(2)))
    end function inverse_cubic

    !> The first root, from the second point as far as `last`, of the cubic of y over x that has the values and slopes at two
    !> points; the second point if it does not exist.
    pure function first_root(x, y, slopes, last) result(root)
        real(wp), intent(in) :: x(2), y(2), slopes(2), last
        real(wp) :: root
        real(wp) :: dx, straight, c(2), step, before, value, value_before
        integer :: i

        dx = x(1) - x(2)
        straight = (y(1) - y(2))/dx
        c = [3.0_wp*straight - 2.0_wp*slopes(2) - slopes(1), (sum(slopes) - 2.0_wp*straight)/dx]/dx
        root = x(2)
        before = 0.0_wp
        value_before = y(2)
        do i = 1, probes
            step = (last - x(2))*real(i, wp)/probes
            value = y(2) + step*(slopes(2) + step*(c(1) + step*c(2)))
            if (value*y(2) <= 0.0_wp) then
                root = x(2) + before + (step - before)*value_before/(value_before - value)
                return
            end if
            before = step
            value_before = value
        end do
    end function first_root

    !> Largest distance from the root at which the cubic in y may be.
    pure function cubic_error(root, x) result(distance)
        real(wp), intent(in) :: root, x(2)
        real(wp) :: distance

        distance = curvature*product(root - x)**2
    end function cubic_error

    !> Where f would vanish if it went on as straight as it begins at `start`, and its slope there: a first guess that never takes
    !> a medium for a contact larger than needed. Falls back to `otherwise` where f is flat.
    subroutine guess_from_below(f, start, otherwise, guess, slope)
        class(scalar_function_t), intent(inout) :: f
        real(wp), intent(in) :: start, otherwise
        real(wp), intent(out) :: guess, slope
        real(wp) :: y

        guess = otherwise
        slope = 2.0_wp
        y = f%value(start)
        if (allocated(f%error)) return
        if (f%known_slope > 0.0_wp) then
            slope = f%known_slope
        else
            slope = f%value(start + 1.0_wp) - y
            if (allocated(f%error)) return
        end if
        if (slope > 0.01_wp) then
            guess = start - y/slope
        else
            slope = 2.0_wp
        end if
    end subroutine guess_from_below

    function evaluate(x, params) result(y) bind(C, name="")
        real(c_double), value :: x
        type(c_ptr), value :: params
        real(c_double) :: y
        type(carrier_t), pointer :: carrier

        call c_f_pointer(params, carrier)
        carrier%f%accuracy = 0.0_wp
        y = carrier%f%value(x)
    end function evaluate

end module mdrcontact_numerics_roots
