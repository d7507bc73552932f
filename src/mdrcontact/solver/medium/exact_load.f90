! SPDX-License-Identifier: GPL-3.0-or-later
!> The load of a body, or of two, solved exactly: with d, the indenter's one-dimensional profile g and what the layers below the
!> surface do to the springs, v,
!>     q(x; a) = E0* (d - g(x) - v(x));
!>     p(r) by equation (6): the half-space of the surface material under d - g, and what the layers below it add;
!>     u(r) = (2/pi) int_0^r w(x)/sqrt(r^2 - x^2) dx with the springs' displacement w, which is d - g inside the contact.
module mdrcontact_medium_exact_load
    use mdrcontact_nonfinite, only: infinity
    use mdrcontact_medium_load, only: load_t, lower_body, upper_body
    use mdrcontact_error, only: check_memory, error_t
    use mdrcontact_kinds, only: pi, wp
    use mdrcontact_line_fields, only: line_load_t, new_line_load
    use mdrcontact_line_kernel, only: kernel_t
    use mdrcontact_line_series, only: even_slope
    use mdrcontact_line_springs, only: springs_t
    use mdrcontact_medium_effective, only: effective_load_t
    use mdrcontact_medium_homogeneous, only: homogeneous_t
    use mdrcontact_numerics_pick, only: pick
    use mdrcontact_profile, only: profile_t
    implicit none (type, external)
    private
    public :: exact_load_t, new_exact_load, part_t

    !> Data of each body of a pair: the kernel and its part E0*/E_i* of the compliance.
    type :: part_t
        type(kernel_t) :: kernel
        real(wp) :: share = 0.0_wp
    end type part_t

    !> q and what it is of.
    type, extends(load_t) :: exact_load_t
        private
        !> q/E0*: v as a series, or on panels where that falls too slowly
        type(line_load_t) :: line
        type(springs_t), pointer :: springs => null()
        !> a half-space of the surface materials
        type(homogeneous_t), pointer :: surface => null()
        !> of two deformable bodies: the lower and the upper one
        type(part_t), pointer :: parts(:) => null()
    contains
        procedure :: line_load
        procedure :: pressure
        procedure :: displacement
        procedure :: displacement_of_body
        procedure :: energies
        procedure :: least_pressure
        procedure :: slope
        procedure :: take_series
    end type exact_load_t

contains

    !> The load of a state: all that it refers to must outlive it.
    subroutine new_exact_load(self, springs, surface, profile, a, punch_depth, error, parts)
        type(exact_load_t), intent(out) :: self
        type(springs_t), intent(in), target :: springs
        !> of the surface materials
        type(homogeneous_t), intent(in), target :: surface
        class(profile_t), intent(in), target :: profile
        !> [length]
        real(wp), intent(in) :: a, punch_depth
        type(error_t), allocatable, intent(out) :: error
        !> of two deformable bodies
        type(part_t), intent(in), target, optional :: parts(:)

        self%springs => springs
        self%surface => surface
        self%profile => profile
        if (present(parts)) self%parts => parts
        self%radius = a
        self%punch_depth = punch_depth
        self%is_complete = .true.
        call new_line_load(self%line, springs%kernel, springs%tolerance, profile, a, punch_depth, error, at_points=.true.)
        self%edge = springs%modulus*self%line%edge
    end subroutine new_exact_load

    !> q/E0* as a series in any case; where it is on panels it is solved again.
    subroutine take_series(self, line, error)
        class(exact_load_t), intent(in) :: self
        type(line_load_t), intent(out) :: line
        type(error_t), allocatable, intent(out) :: error

        if (allocated(self%line%panels)) then
            call new_line_load(line, self%springs%kernel, self%springs%tolerance, self%profile, self%radius, self%punch_depth, &
                               error)
        else
            line = self%line
        end if
    end subroutine take_series

    subroutine line_load(self, r, values, error)
        class(exact_load_t), intent(in) :: self
        real(wp), intent(in) :: r(:)
        real(wp), intent(out) :: values(:)
        type(error_t), allocatable, intent(out) :: error

        if (allocated(error)) continue
        call self%line%at(self%profile, r, values)
        values = self%springs%modulus*values
    end subroutine line_load

    subroutine pressure(self, r, values, error)
        class(exact_load_t), intent(in) :: self
        real(wp), intent(in) :: r(:)
        real(wp), intent(out) :: values(:)
        type(error_t), allocatable, intent(out) :: error
        type(effective_load_t) :: bare
        integer :: i

        call bare%begin(self%surface, self%profile, self%radius, 0.0_wp)
        call bare%pressure(r, values, error)
        if (allocated(error)) return
        associate (a => self%radius)
            do i = 1, size(r)
                values(i) = values(i) + self%springs%modulus*self%line%smooth_pressure(r(i))
                if (self%punch_depth == 0.0_wp) cycle
                if (r(i) < a) then
                    values(i) = values(i) + self%springs%modulus*self%line%edge/(pi*sqrt((a - r(i))*(a + r(i))))
                else
                    values(i) = sign(infinity, self%punch_depth)
                end if
            end do
        end associate
    end subroutine pressure

    subroutine displacement(self, r, values, error)
        class(exact_load_t), intent(in) :: self
        real(wp), intent(in) :: r(:)
        real(wp), intent(out) :: values(:)
        type(error_t), allocatable, intent(out) :: error
        real(wp), allocatable :: added(:)
        integer :: stat

        call beside_half_space(self, self%line, r, values, error)
        if (allocated(error) .or. self%springs%kernel%vanishes) return
        allocate (added(size(r)), stat=stat)
        call check_memory(error, stat)
        if (allocated(error)) return
        call self%line%displacement_beyond(self%springs%kernel, r, added, error)
        values = values + added
    end subroutine displacement

    !> u(r), r > a, of the half-space of the surface material under d - g.
    subroutine beside_half_space(self, line, r, values, error)
        class(exact_load_t), intent(in) :: self
        type(line_load_t), intent(in) :: line
        real(wp), intent(in) :: r(:)
        real(wp), intent(out) :: values(:)
        type(error_t), allocatable, intent(out) :: error
        type(effective_load_t) :: bare

        call bare%begin(self%surface, self%profile, self%radius, line%depth - self%profile%mdr(self%radius))
        call bare%displacement(r, values, error)
    end subroutine beside_half_space

    !> u_i(r) = (E0*/E_i*) (2/pi) int_0^r w_i(x)/sqrt(r^2 - x^2) dx with w_i = [q + K_i q]/E0* = d - g - v + v_i inside the contact.
    subroutine displacement_of_body(self, body, r, values, error)
        class(exact_load_t), intent(in) :: self
        integer, intent(in) :: body
        real(wp), intent(in) :: r(:)
        real(wp), intent(inout) :: values(:)
        type(error_t), allocatable, intent(out) :: error
        type(line_load_t) :: line
        real(wp), allocatable :: v(:), outside(:), difference(:), total(:), added(:)
        integer, allocatable :: places(:)
        integer :: i, stat

        if (.not. associated(self%parts)) then
            if (body == upper_body) values = 0.0_wp
            return
        end if
        call self%take_series(line, error)
        if (allocated(error)) return
        call pick(r, places, outside, total, error, above=self%radius)
        if (allocated(error)) return
        allocate (v, mold=line%q)
        allocate (difference(size(r)), added(size(outside)), stat=stat)
        call check_memory(error, stat)
        if (allocated(error)) return
        added = 0.0_wp
        associate (part => self%parts(body))
            call line%part_of(part%kernel, v, error)
            call line%displacement_by(v - line%v, r, difference, error)
            if (allocated(error)) return
            call beside_half_space(self, line, outside, total, error)
            if (allocated(error)) return
            if (.not. part%kernel%vanishes) call line%displacement_beyond(part%kernel, outside, added, error)
            do i = 1, size(places)
                values(places(i)) = total(i) + added(i)
            end do
            values = part%share*(values + difference)
        end associate
    end subroutine displacement_of_body

    !> W_i = int_0^a q w_i dx.
    subroutine energies(self, values, error)
        class(exact_load_t), intent(in) :: self
        real(wp), allocatable, intent(out) :: values(:)
        type(error_t), allocatable, intent(out) :: error
        type(line_load_t) :: line
        real(wp), allocatable :: v(:)
        integer :: i

        if (.not. self%is_complete) return
        allocate (values(2), source=0.0_wp)
        if (.not. associated(self%parts)) then
            values(lower_body) = self%springs%modulus*self%line%work_on(self%profile, self%line%v, error)
            return
        end if
        call self%take_series(line, error)
        if (allocated(error)) return
        allocate (v, mold=line%q)
        do i = 1, 2
            call line%part_of(self%parts(i)%kernel, v, error)
            if (allocated(error)) return
            values(i) = self%springs%modulus*self%parts(i)%share*line%work_on(self%profile, v, error)
        end do
    end subroutine energies

    !> In a part of the time that pressures take: between two positions, and from the last one to a, 1/sqrt(s^2 - r^2) is not below
    !> its value at the outer end, and g does not fall.
    pure subroutine least_pressure(self, r, values)
        class(exact_load_t), intent(in) :: self
        real(wp), intent(in) :: r(:)
        real(wp), intent(out) :: values(:)
        real(wp) :: ends(size(r)), rises(size(r))
        integer :: i, n

        n = size(r)
        values = -huge(1.0_wp)
        ends = [r(2:), self%radius]
        rises = self%profile%mdr(ends) - self%profile%mdr(r)
        if (any(rises < 0.0_wp) .or. self%line%edge < 0.0_wp) return
        rises(n) = rises(n) + self%line%edge
        do i = 1, n
            values(i) = self%springs%modulus &
                        *(sum(rises(i:)/sqrt((ends(i:) - r(i))*(ends(i:) + r(i))))/pi + self%line%smooth_pressure(r(i)))
        end do
    end subroutine least_pressure

    !> -E0* (g' + v').
    pure function slope(self, start, distance) result(y)
        class(exact_load_t), intent(in) :: self
        real(wp), intent(in) :: start, distance(:)
        real(wp) :: y(size(distance))
        integer :: i

        if (allocated(self%line%panels)) then
            y = [(self%line%panels%slope(start + distance(i)), i=1, size(distance))]
        else
            y = even_slope(self%line%v, (start + distance)/self%radius)/self%radius
        end if
        y = -self%springs%modulus*(self%profile%mdr_slope_beyond(start, distance) + y)
    end function slope

end module mdrcontact_medium_exact_load
