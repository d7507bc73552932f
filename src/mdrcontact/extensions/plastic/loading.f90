! SPDX-License-Identifier: GPL-3.0-or-later
!> First loading of a contact beyond yield: force, contact radius and imprint over the depth.
module mdrcontact_plastic_loading
    use mdrcontact_error, only: check_memory, check_not_negative, check_positive, check_same_size, error_domain, error_invalid, &
                                error_t, raise, to_text
    use mdrcontact_kinds, only: pi, wp
    use mdrcontact_numerics_monotone_table, only: monotone_table_t, new_monotone_table
    use mdrcontact_plastic_virgin, only: largest_load, virgin_t
    use mdrcontact_plastic_yielding, only: tabor, yielding_t
    implicit none (type, external)
    private
    public :: loading_t, loaded_t, paraboloid_loading_t, table_loading_t, new_paraboloid_loading, new_table_loading

    !> A state of first loading.
    type :: loaded_t
        !> d, a [length] and F [modulus length^2]
        real(wp) :: depth = 0.0_wp, radius = 0.0_wp, force = 0.0_wp
        !> A2/E* of the line load A2 s + A1 s^2 (theory/plastic.md (2.1)) [length]
        real(wp) :: uniform = 0.0_wp
        !> E*, with which this imprint unloads [modulus]
        real(wp) :: modulus = 0.0_wp
    end type loaded_t

    !> A curve of first loading from yield on.
    type, abstract :: loading_t
        !> E*, with which the contact unloads [modulus]; the largest where it varies with the depth
        real(wp) :: modulus = 0.0_wp
        logical :: is_coated = .false.
        !> the first depth and the last one of the curve [length]
        real(wp) :: first = 0.0_wp, last = 0.0_wp
        !> depths between them at which it is not smooth, rising [length]
        real(wp), allocatable :: breaks(:)
    contains
        procedure(state_at), deferred :: at_depth
    end type loading_t

    abstract interface
        !> The state at a depth between first and last.
        pure function state_at(self, depth) result(state)
            import :: loaded_t, loading_t, wp
            class(loading_t), intent(in) :: self
            !> [length]
            real(wp), intent(in) :: depth
            type(loaded_t) :: state
        end function state_at
    end interface

    !> A paraboloid on a half-space that yields, pressed by a rigid or an elastic body, or by one like it.
    type, extends(loading_t) :: paraboloid_loading_t
        !> R [length]
        real(wp) :: radius = 0.0_wp
        !> E* of the body that yields, of two that yield that of the pair [modulus]
        real(wp) :: own_modulus = 0.0_wp
        !> the same over E* of an elastic body that presses it; 0: rigid, or equal
        real(wp) :: share = 0.0_wp
        type(virgin_t) :: virgin
        type(yielding_t) :: metal
    contains
        procedure :: at_depth => paraboloid_at_depth
        procedure :: at_load
    end type paraboloid_loading_t

    !> Points of a measured or computed curve, with cubics between them that rise.
    type, extends(loading_t) :: table_loading_t
        type(monotone_table_t), private :: force, radius, recovery, stiffness
    contains
        procedure :: at_depth => table_at_depth
    end type table_loading_t

    !> A term that is negative by no more than this part of the line load on the axis is 0: Hertz's unloading.
    real(wp), parameter :: nothing = 5.0e-3_wp
    !> Relative difference of moduli that are one.
    real(wp), parameter :: same = 1.0e-9_wp
    !> Largest number of steps of a search, and where it ends.
    integer, parameter :: most_steps = 200
    real(wp), parameter :: close = 4.0_wp*epsilon(1.0_wp)
    !> Curvature of the displacement of the body that does not yield, under a uniform pressure and under Hertz's.
    real(wp), parameter :: kappa_uniform = 1.4535_wp, kappa_hertz = 0.75_wp*pi

contains

    !> The curve of a paraboloid, from first yield to a E*/(R Y) = 250 of the body that yields.
    pure subroutine new_paraboloid_loading(self, radius, metal, virgin, modulus, own_modulus, share)
        type(paraboloid_loading_t), intent(out) :: self
        !> R > 0 [length]
        real(wp), intent(in) :: radius
        type(yielding_t), intent(in) :: metal
        type(virgin_t), intent(in) :: virgin
        !> E* of the contact and of the body that yields [modulus], and the latter over that of an elastic body that presses it
        real(wp), intent(in) :: modulus, own_modulus, share
        type(loaded_t) :: state
        integer :: i

        self%radius = radius
        self%metal = metal
        self%virgin = virgin
        self%modulus = modulus
        self%own_modulus = own_modulus
        self%share = share
        state = self%at_load(virgin%first_yield)
        self%first = state%depth
        state = self%at_load(largest_load)
        self%last = state%depth
        allocate (self%breaks(0))
        do i = 1, size(metal%strain)
            if (size(metal%strain) == 1) exit
            state%depth = depth_at_strain(self, metal%strain(i))
            if (state%depth > self%first .and. state%depth < self%last) self%breaks = [self%breaks, state%depth]
        end do
    end subroutine new_paraboloid_loading

    !> The state at L = a_1 E_1*/(R_1 Y) of the body that yields, which sees a partner that is flattened (theory/plastic.md
    !> (4.9)-(4.11)); Y at the strain 0.2 a/R, (4.8).
    pure function at_load(self, load) result(state)
        class(paraboloid_loading_t), intent(in) :: self
        !> [1]
        real(wp), intent(in) :: load
        type(loaded_t) :: state
        real(wp) :: pressure, depth, line, deficit, kappa, total, strain, stress, own

        call self%virgin%at(load, pressure, depth, line, deficit)
        kappa = kappa_uniform + (line - 2.0_wp)*(kappa_hertz - kappa_uniform)/(0.75_wp*pi - 2.0_wp)
        total = load + kappa*pressure*self%share
        strain = self%metal%reach(tabor*total/self%own_modulus)
        stress = self%metal%stress_at(strain)
        state%radius = total*self%radius*stress/self%own_modulus
        own = state%radius*self%own_modulus/(load*stress)
        state%force = pi*state%radius**2*stress*pressure
        state%modulus = self%modulus
        state%depth = state%radius**2/own*depth + line*stress*pressure*state%radius*self%share/self%own_modulus
        state%uniform = pi/2.0_wp*deficit*state%radius*pressure*stress/self%modulus/(pi/4.0_wp - 2.0_wp/3.0_wp)
    end function at_load

    !> The depth at which 0.2 a/R has a value; the ends of the curve outside it.
    pure function depth_at_strain(self, strain) result(depth)
        type(paraboloid_loading_t), intent(in) :: self
        real(wp), intent(in) :: strain
        real(wp) :: depth
        real(wp) :: low, high, middle
        type(loaded_t) :: state
        integer :: i

        low = self%virgin%first_yield
        high = largest_load
        do i = 1, most_steps
            middle = sqrt(low*high)
            state = self%at_load(middle)
            if (tabor*state%radius/self%radius < strain) then
                low = middle
            else
                high = middle
            end if
            if (high - low <= close*high) exit
        end do
        state = self%at_load(0.5_wp*(low + high))
        depth = state%depth
    end function depth_at_strain

    !> The state at a depth: regula falsi (Illinois) in the logarithms of L and d.
    pure function paraboloid_at_depth(self, depth) result(state)
        class(paraboloid_loading_t), intent(in) :: self
        real(wp), intent(in) :: depth
        type(loaded_t) :: state
        real(wp) :: low, high, below, above, x, miss
        integer :: i

        low = log(self%virgin%first_yield)
        high = log(largest_load)
        below = log(self%first/depth)
        above = log(self%last/depth)
        if (below >= 0.0_wp .or. above <= 0.0_wp) then
            state = self%at_load(merge(self%virgin%first_yield, largest_load, below >= 0.0_wp))
            return
        end if
        do i = 1, most_steps
            x = high - above*(high - low)/(above - below)
            if (.not. (x > low .and. x < high)) x = 0.5_wp*(low + high)
            state = self%at_load(exp(x))
            miss = log(state%depth/depth)
            if (abs(miss) <= close .or. high - low <= close) exit
            if (miss < 0.0_wp) then
                low = x
                below = miss
                above = 0.5_wp*above
            else
                high = x
                above = miss
                below = 0.5_wp*below
            end if
        end do
    end function paraboloid_at_depth

    !> A curve through points, the first of which is the end of elastic loading.
    subroutine new_table_loading(self, depth, force, radius, residual, modulus, error)
        type(table_loading_t), intent(out) :: self
        !> d, F and a of at least 3 points, each > 0 and rising; the depth that remains after an elastic unloading from each
        real(wp), intent(in) :: depth(:), force(:), radius(:), residual(:)
        !> E* > 0, with which the contact unloads from each [modulus]
        real(wp), intent(in) :: modulus(:)
        type(error_t), allocatable, intent(out) :: error
        real(wp), allocatable :: recovery(:)
        integer :: i, n, stat

        n = size(depth)
        call check_same_size(error, n, size(force))
        call check_same_size(error, n, size(radius))
        call check_same_size(error, n, size(residual))
        call check_same_size(error, n, size(modulus))
        do i = 1, n
            if (.not. allocated(error)) call check_positive(error, "modulus", modulus(i), i)
        end do
        if (n < 3) call raise(error, error_invalid, "depth: the curve needs at least 3 points")
        call check_rising("depth", depth, error)
        call check_rising("force", force, error)
        call check_rising("radius", radius, error)
        if (allocated(error)) return
        call check_residual(depth, force, radius, residual, modulus, error)
        if (.not. allocated(error)) call new_monotone_table(self%force, depth, force, error)
        if (.not. allocated(error)) call new_monotone_table(self%radius, depth, radius, error)
        if (allocated(error)) return
        allocate (recovery(n), self%breaks(n - 2), stat=stat)
        call check_memory(error, stat)
        if (allocated(error)) return
        recovery = depth - residual
        call new_monotone_table(self%recovery, depth, recovery, error)
        if (.not. allocated(error)) call new_monotone_table(self%stiffness, depth, modulus, error)
        if (allocated(error)) return
        self%modulus = maxval(modulus)
        self%is_coated = any(modulus < (1.0_wp - same)*self%modulus)
        self%first = depth(1)
        self%last = depth(n)
        self%breaks = depth(2:n - 1)
    end subroutine new_table_loading

    !> Raises unless numbers are > 0 and rise.
    pure subroutine check_rising(name, values, error)
        character(len=*), intent(in) :: name
        real(wp), intent(in) :: values(:)
        type(error_t), allocatable, intent(inout) :: error
        integer :: i

        if (allocated(error)) return
        do i = 1, size(values)
            call check_positive(error, name, values(i), i)
            if (allocated(error)) return
            if (values(i) > values(max(i - 1, 1)) .or. i == 1) cycle
            call raise(error, error_invalid, " = "//to_text(values(i))//": the values must rise. Average or omit points", name, i)
            return
        end do
    end subroutine check_rising

    !> Raises unless imprints of two terms leave these depths: A2 >= 0 and A2 + 2 A1 > 0.
    pure subroutine check_residual(depth, force, radius, residual, modulus, error)
        real(wp), intent(in) :: depth(:), force(:), radius(:), residual(:), modulus(:)
        type(error_t), allocatable, intent(inout) :: error
        real(wp) :: mean
        integer :: i

        do i = 1, size(depth)
            call check_not_negative(error, "residual_depth", residual(i), i)
            if (allocated(error)) return
            ! of A1 and A2 over E*
            mean = 0.5_wp*force(i)/(radius(i)*modulus(i))
            associate (recovery => depth(i) - residual(i), least => mean/(pi/2.0_wp - 2.0_wp/3.0_wp), most => 1.5_wp*mean)
                if (recovery > most*(1.0_wp + nothing) .or. .not. recovery > least) then
                    call raise(error, error_domain, " = "//to_text(residual(i))//": an imprint of this force and radius leaves "// &
                               "between "//to_text(max(depth(i) - most, 0.0_wp))//" and "//to_text(depth(i) - least)// &
                               ". Check depth, force, radius and modulus", "residual_depth", i)
                    return
                end if
            end associate
        end do
    end subroutine check_residual

    pure function table_at_depth(self, depth) result(state)
        class(table_loading_t), intent(in) :: self
        real(wp), intent(in) :: depth
        type(loaded_t) :: state

        state%depth = depth
        state%force = self%force%at(depth)
        state%radius = self%radius%at(depth)
        state%modulus = self%modulus
        if (self%is_coated) state%modulus = self%stiffness%at(depth)
        state%uniform = max((state%force/(2.0_wp*state%radius*state%modulus) - 2.0_wp/3.0_wp*self%recovery%at(depth)) &
                            /(pi/4.0_wp - 2.0_wp/3.0_wp), 0.0_wp)
    end function table_at_depth

end module mdrcontact_plastic_loading
