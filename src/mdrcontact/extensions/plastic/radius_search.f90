! SPDX-License-Identifier: GPL-3.0-or-later
!> The contact radius of a depth or a force, of models whose depth and force grow with the radius.
module mdrcontact_plastic_radius_search
    use mdrcontact_codes, only: by_depth => depth, by_force => force, by_radius => radius
    use mdrcontact_error, only: check_code, check_positive, error_domain, error_t, raise, to_text
    use mdrcontact_kinds, only: wp
    use mdrcontact_numerics_roots, only: find_root
    use mdrcontact_numerics_scalar_function, only: scalar_function_t
    implicit none (type, external)
    private
    public :: by_radius, by_depth, check_given, find_radius, miss_t

    !> A search begins at a guess and widens by this, at most so often, which is from any radius to any other.
    real(wp), parameter :: widening = 1.3_wp
    integer, parameter :: most_widenings = 2000

    !> What a state misses of a depth or a force, over it, at a radius over `unit`. Extend it with the model.
    type, abstract, extends(scalar_function_t) :: miss_t
        logical :: is_depth = .true.
        real(wp) :: wanted = 0.0_wp
        !> the first radius, as roots are found to an absolute error, and the largest one [length]
        real(wp), private :: unit = 1.0_wp, last = 0.0_wp
    contains
        procedure :: value => missed
        procedure(depth_and_force_at), deferred :: depth_and_force
    end type miss_t

    abstract interface
        !> d and F at a radius.
        subroutine depth_and_force_at(self, radius, depth, force, error)
            import :: error_t, miss_t, wp
            class(miss_t), intent(in) :: self
            real(wp), intent(in) :: radius
            real(wp), intent(out) :: depth, force
            type(error_t), allocatable, intent(out) :: error
        end subroutine depth_and_force_at
    end interface

contains

    !> Raises unless a radius, a depth or a force is greater than 0.
    pure subroutine check_given(given, value, error)
        !> radius, depth or force of mdrcontact_codes
        integer, intent(in) :: given
        real(wp), intent(in) :: value
        type(error_t), allocatable, intent(inout) :: error

        call check_code(error, "given", given, [by_radius, by_depth, by_force])
        if (allocated(error)) return
        if (given == by_radius) call check_positive(error, "radius", value)
        if (given == by_depth) call check_positive(error, "depth", value)
        if (given == by_force) call check_positive(error, "force", value)
    end subroutine check_given

    !> The radius at which nothing is missed.
    subroutine find_radius(miss, guess, last, limit, radius, error)
        class(miss_t), intent(inout) :: miss
        !> > 0, and the largest radius [length]
        real(wp), intent(in) :: guess, last
        !> what is so up to the largest radius, for the error
        character(len=*), intent(in) :: limit
        real(wp), intent(out) :: radius
        type(error_t), allocatable, intent(inout) :: error
        real(wp) :: low, high, root
        logical :: found

        miss%unit = guess
        miss%last = last
        radius = guess
        high = 1.0_wp
        call bracket(miss, low, high, last/guess, found)
        if (allocated(miss%error)) then
            call move_alloc(miss%error, error)
        else if (.not. found) then
            call raise(error, error_domain, " = "//to_text(miss%wanted)//": "//limit//". Reduce it", &
                       trim(merge("depth", "force", miss%is_depth)))
        end if
        if (allocated(error)) return
        root = high
        if (high > low) call find_root(miss, low, high, root, error)
        radius = radius_at(miss, root)
    end subroutine find_radius

    pure function radius_at(miss, x) result(radius)
        class(miss_t), intent(in) :: miss
        real(wp), intent(in) :: x
        real(wp) :: radius

        radius = min(x*miss%unit, miss%last)
    end function radius_at

    !> Places between which a function that grows with the radius changes its sign.
    subroutine bracket(miss, low, high, last, found)
        class(miss_t), intent(inout) :: miss
        !> on return f(low) <= 0 <= f(high); on entry a guess of the latter
        real(wp), intent(out) :: low
        real(wp), intent(inout) :: high
        !> the largest place
        real(wp), intent(in) :: last
        logical, intent(out) :: found
        real(wp) :: value
        integer :: i

        do i = 1, most_widenings
            value = miss%value(high)
            if (value <= 0.0_wp .or. allocated(miss%error)) exit
            high = high/widening
        end do
        low = high
        do i = 1, most_widenings
            if (value >= 0.0_wp .or. allocated(miss%error) .or. high >= last) exit
            low = high
            high = min(widening*high, last)
            value = miss%value(high)
        end do
        found = value >= 0.0_wp
    end subroutine bracket

    function missed(self, x) result(y)
        class(miss_t), intent(inout) :: self
        !> radius over unit [1]
        real(wp), intent(in) :: x
        real(wp) :: y
        real(wp) :: depth, force

        y = 0.0_wp
        call self%depth_and_force(radius_at(self, x), depth, force, self%error)
        if (.not. allocated(self%error)) y = merge(depth, force, self%is_depth)/self%wanted - 1.0_wp
    end function missed

end module mdrcontact_plastic_radius_search
