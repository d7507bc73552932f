! SPDX-License-Identifier: GPL-3.0-or-later
!> The contact radius behind readings of depth, force and stiffness: that at which the surface sinks in as far as the body under
!> the tip lets it, f(a) = c (h - sink(a) P/S).
module mdrcontact_fit_contact_radius
    use mdrcontact_error, only: check_memory, error_domain, error_t, raise, to_text
    use mdrcontact_fit_problem, only: at_area_factor, at_contact_depth_factor, at_contact_depth_scale, at_depth_offset, &
                                      at_force_offset, at_frame_compliance, fit_data_t
    use mdrcontact_fit_sink_in, only: new_sink_in, sink_in_t
    use mdrcontact_kinds, only: wp
    use mdrcontact_medium_solver, only: solver_t
    use mdrcontact_numerics_roots, only: find_root, solve_increasing
    use mdrcontact_numerics_scalar_function, only: scalar_function_t
    use mdrcontact_profile, only: profile_t
    implicit none (type, external)
    private
    public :: contact_radii

    integer, parameter :: most_steps = 200
    !> Number of times that the range of radii is widened, and the factor.
    integer, parameter :: most_ranges = 6
    real(wp), parameter :: wider = 2.0_wp
    !> Contact depths below this part of the depth are beyond the first range, and room about it.
    real(wp), parameter :: least_part = 0.1_wp, room = 1.02_wp
    !> A contact depth and sink-in together that are less than this part of the depth are far from the root.
    real(wp), parameter :: smallest_share = 1.0e-3_wp
    !> No contact radius is larger [length].
    real(wp), parameter :: largest_number = 1.0e100_wp
    !> Nearer to the end of a tip or medium, as a part of the radius, is the end.
    real(wp), parameter :: last_part = 1.0e-9_wp

    !> Depths and P/S, freed of offsets and frame.
    type :: readings_t
        real(wp), allocatable :: depth(:), recovery(:)
    end type readings_t

    !> ln of (f(a)/c + sink(a) P/S)/h over ln a, close to a straight line.
    type, extends(scalar_function_t) :: balance_t
        class(profile_t), pointer :: profile => null()
        type(sink_in_t), pointer :: sink_in => null()
        real(wp) :: depth = 0.0_wp, recovery = 0.0_wp, scale = 1.0_wp, widening = 1.0_wp
    contains
        procedure :: value => imbalance
    end type balance_t

contains

    !> The contact radius of each point, and E_eff there where the body sinks in by a factor that depends on the radius; else
    !> `modulus` is not allocated.
    subroutine contact_radii(profile, medium, instrument, is_elastic, data, a, modulus, error)
        class(profile_t), intent(in), target :: profile
        class(solver_t), intent(in) :: medium
        real(wp), intent(in) :: instrument(:)
        !> whether the indenter itself lies in the indent, and not the one that epsilon represents
        logical, intent(in) :: is_elastic
        type(fit_data_t), intent(in) :: data
        real(wp), allocatable, intent(out) :: a(:), modulus(:)
        type(error_t), allocatable, intent(out) :: error
        type(readings_t) :: readings
        logical :: is_half_space

        call free_readings(instrument, data, readings, error)
        if (allocated(error)) return
        associate (c => instrument(at_contact_depth_scale), eps => instrument(at_contact_depth_factor), &
                   widening => sqrt(instrument(at_area_factor)))
            is_half_space = medium%has_free_springs
            ! the surface stays where it is, or goes as the tangent of the curve does, on every body
            if (.not. is_elastic .and. (is_half_space .or. .not. abs(eps*(1.0_wp - eps)) > 0.0_wp)) then
                readings%depth(:) = c*(readings%depth - eps*readings%recovery)
                call radii_at(profile, data%x, readings%depth, a, error)
                if (.not. allocated(error)) a(:) = a*widening
            else
                call balanced_radii(profile, medium, readings, instrument, is_elastic, data, a, modulus, error)
            end if
        end associate
    end subroutine contact_radii

    subroutine free_readings(instrument, data, readings, error)
        real(wp), intent(in) :: instrument(:)
        type(fit_data_t), intent(in) :: data
        type(readings_t), intent(out) :: readings
        type(error_t), allocatable, intent(out) :: error
        real(wp) :: load, compliance
        integer :: i, stat

        allocate (readings%depth(size(data%x)), readings%recovery(size(data%x)), stat=stat)
        call check_memory(error, stat)
        if (allocated(error)) return
        do i = 1, size(data%x)
            load = data%given(i) - instrument(at_force_offset)
            compliance = 1.0_wp/data%y(i) - instrument(at_frame_compliance)
            readings%depth(i) = data%x(i) - instrument(at_depth_offset) - instrument(at_frame_compliance)*load
            readings%recovery(i) = load*compliance
            if (.not. compliance > 0.0_wp) then
                call raise(error, error_domain, "the stiffness at depth "//to_text(data%x(i))//" is "//to_text(data%y(i))// &
                           ": it must be less than that of the frame alone. Check units and frame compliance, or omit tests "// &
                           "in which contact began at another depth")
                return
            end if
            if (readings%depth(i) > 0.0_wp) cycle
            call refuse_depth(data%x(i), readings%depth(i), error)
            return
        end do
    end subroutine free_readings

    pure subroutine refuse_depth(depth, height, error)
        real(wp), intent(in) :: depth, height
        type(error_t), allocatable, intent(inout) :: error

        call raise(error, error_domain, "the contact depth at depth "//to_text(depth)//" is "//to_text(height)// &
                   ": it must be greater than 0. Omit the first points, or check units, offset and frame compliance")
    end subroutine refuse_depth

    pure subroutine refuse_height(height, error)
        real(wp), intent(in) :: height
        type(error_t), allocatable, intent(inout) :: error

        call raise(error, error_domain, "the contact depth "//to_text(height)//" is beyond the end of the indenter")
    end subroutine refuse_height

    !> The radii at which the tip has these heights.
    subroutine radii_at(profile, depth, height, a, error)
        class(profile_t), intent(in) :: profile
        !> as read, for messages; and the contact depths [length]
        real(wp), intent(in) :: depth(:)
        real(wp), allocatable, intent(in) :: height(:)
        real(wp), allocatable, intent(out) :: a(:)
        type(error_t), allocatable, intent(out) :: error
        integer :: i, stat

        allocate (a(size(height)), stat=stat)
        call check_memory(error, stat)
        if (allocated(error)) return
        do i = 1, size(a)
            if (.not. height(i) > 0.0_wp) then
                call refuse_depth(depth(i), height(i), error)
                return
            end if
            a(i) = radius_at_height(profile, height(i))
            if (a(i) > 0.0_wp .and. a(i) < profile%largest_radius) cycle
            call refuse_height(height(i), error)
            return
        end do
    end subroutine radii_at

    !> The radii at which depth, tip and sink-in of the body agree; the range of radii is widened until it holds all of them.
    subroutine balanced_radii(profile, medium, readings, instrument, is_elastic, data, a, modulus, error)
        class(profile_t), intent(in), target :: profile
        class(solver_t), intent(in) :: medium
        type(readings_t), intent(in) :: readings
        real(wp), intent(in) :: instrument(:)
        logical, intent(in) :: is_elastic
        type(fit_data_t), intent(in) :: data
        real(wp), allocatable, intent(out) :: a(:), modulus(:)
        type(error_t), allocatable, intent(out) :: error
        type(sink_in_t), target :: sink_in
        type(balance_t) :: balance
        real(wp) :: smallest, largest, end_of_tip
        integer :: i, range, side, stat

        ! the first point begins at its depth as a radius
        allocate (a(size(data%x)), modulus(size(data%x)), stat=stat)
        call check_memory(error, stat)
        if (stat /= 0) return
        a(:) = readings%depth
        balance%profile => profile
        balance%sink_in => sink_in
        balance%scale = instrument(at_contact_depth_scale)
        balance%widening = sqrt(instrument(at_area_factor))
        end_of_tip = balance%widening*min(profile%largest_radius, largest_number)
        side = 0
        call first_range(balance, readings, instrument(at_contact_depth_factor), smallest, largest)
        do range = 1, most_ranges
            if (is_elastic) then
                call new_sink_in(sink_in, medium, smallest, largest, error, indenter=profile)
            else
                call new_sink_in(sink_in, medium, smallest, largest, error, instrument(at_contact_depth_factor))
            end if
            if (allocated(error)) return
            do i = 1, size(a)
                balance%depth = readings%depth(i)
                balance%recovery = readings%recovery(i)
                call find_radius(balance, log(a(max(i - 1, 1))), a(i), modulus(i), side, error)
                if (allocated(error)) return
                if (side /= 0) exit
            end do
            if (side == 0) return
            if (side > 0 .and. .not. sink_in%largest < min(end_of_tip, medium%largest_radius)*(1.0_wp - last_part)) exit
            if (side < 0 .and. .not. sink_in%smallest > medium%smallest_radius*(1.0_wp + last_part)) exit
            if (side > 0) largest = min(wider*largest, end_of_tip)
            if (side < 0) smallest = smallest/wider
        end do
        call refuse_radius(balance, medium, data%x(i), side, error)
    end subroutine balanced_radii

    !> The radii that contacts between no sink-in and that of a punch have.
    subroutine first_range(balance, readings, epsilon_factor, smallest, largest)
        type(balance_t), intent(in) :: balance
        type(readings_t), intent(in) :: readings
        real(wp), intent(in) :: epsilon_factor
        real(wp), intent(out) :: smallest, largest

        smallest = minval(max(readings%depth - readings%recovery, least_part*readings%depth))/room
        largest = maxval(readings%depth + max(0.0_wp, -wider*epsilon_factor)*readings%recovery)*room
        smallest = balance%widening*radius_at_height(balance%profile, balance%scale*smallest)
        largest = balance%widening*radius_at_height(balance%profile, balance%scale*largest)
    end subroutine first_range

    !> The radius at which depth, tip and sink-in agree, and E_eff there.
    subroutine find_radius(balance, guess, a, modulus, side, error)
        type(balance_t), intent(inout) :: balance
        !> of ln a: neighbouring points lie close together
        real(wp), intent(in) :: guess
        real(wp), intent(out) :: a, modulus
        !> 1 or -1 where the radius lies above or below the range of radii, else 0
        integer, intent(out) :: side
        type(error_t), allocatable, intent(out) :: error
        real(wp) :: first, last, x, sink
        logical :: found

        first = log(balance%sink_in%smallest)
        last = log(balance%sink_in%largest)
        call solve_increasing(balance, min(max(guess, first), last), 1.0_wp, first, last, x, found, error)
        if (allocated(error)) call find_slowly(balance, first, last, x, found, error)
        if (allocated(error)) return
        side = 0
        if (.not. found) side = merge(1, -1, 2.0_wp*x > first + last)
        a = exp(x)
        call balance%sink_in%at(a, sink, modulus)
    end subroutine find_radius

    !> The same between the ends of the range, for readings so near to those of no contact that the balance hardly grows.
    subroutine find_slowly(balance, first, last, x, found, error)
        type(balance_t), intent(inout) :: balance
        real(wp), intent(in) :: first, last
        real(wp), intent(out) :: x
        logical, intent(out) :: found
        type(error_t), allocatable, intent(out) :: error
        real(wp) :: below, above

        below = balance%value(first)
        above = balance%value(last)
        found = below < 0.0_wp .and. above > 0.0_wp
        x = first
        if (found) call find_root(balance, first, last, x, error)
    end subroutine find_slowly

    function imbalance(self, x) result(y)
        class(balance_t), intent(inout) :: self
        !> ln a
        real(wp), intent(in) :: x
        real(wp) :: y
        real(wp) :: sink, modulus

        call self%sink_in%at(exp(x), sink, modulus)
        y = (self%profile%height(exp(x)/self%widening)/self%scale + sink*self%recovery)/self%depth
        y = log(max(y, smallest_share))
    end function imbalance

    !> Why a point has no contact radius.
    subroutine refuse_radius(balance, medium, depth, side, error)
        type(balance_t), intent(in) :: balance
        class(solver_t), intent(in) :: medium
        !> as read [length]
        real(wp), intent(in) :: depth
        integer, intent(in) :: side
        type(error_t), allocatable, intent(out) :: error
        real(wp) :: sink, modulus, height

        call balance%sink_in%at(merge(balance%sink_in%largest, balance%sink_in%smallest, side > 0), sink, modulus)
        height = balance%scale*(balance%depth - sink*balance%recovery)
        if (.not. height > 0.0_wp) then
            call refuse_depth(depth, height, error)
        else if (side < 0 .or. balance%sink_in%largest >= medium%largest_radius*(1.0_wp - last_part)) then
            call raise(error, error_domain, "the contact radius at depth "//to_text(depth)// &
                       " is outside the range of the medium"//trim(medium%why_it_ends))
        else
            call refuse_height(height, error)
        end if
    end subroutine refuse_radius

    !> The radius at which f(r) has a value: bisection in ln r, then Newton.
    function radius_at_height(profile, height) result(radius)
        class(profile_t), intent(in) :: profile
        real(wp), intent(in) :: height
        real(wp) :: radius
        real(wp) :: low, high, middle, punch_depth, step
        integer :: i

        low = profile%end_radius
        high = min(profile%largest_radius, max(10.0_wp*low, height))
        do i = 1, most_steps
            if (high >= profile%largest_radius .or. profile%height(high) >= height) exit
            low = high
            high = min(2.0_wp*high, profile%largest_radius)
        end do
        radius = high
        do i = 1, most_steps
            punch_depth = profile%height(radius) - height
            if (punch_depth > 0.0_wp) then
                high = radius
            else
                low = radius
            end if
            step = -punch_depth/max(profile%slope(radius), tiny(1.0_wp))
            middle = radius + step
            if (.not. (middle > low .and. middle < high)) middle = 0.5_wp*(low + high)
            if (abs(middle - radius) <= 4.0_wp*epsilon(1.0_wp)*radius) exit
            radius = middle
        end do
    end function radius_at_height

end module mdrcontact_fit_contact_radius
