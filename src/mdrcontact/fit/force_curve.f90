! SPDX-License-Identifier: GPL-3.0-or-later
!> F(d) of one contact over a range of depths, traced once and then evaluated for the price of a short polynomial.
!>
!> Depth and force are sampled at Chebyshev radii in ln(a - end radius), where both are smooth; any number of depths is then
!> inverted on the polynomials. With adhesion the curve is the branch that unloading follows down to pull-off.
module mdrcontact_fit_force_curve
    use mdrcontact_contact_state, only: contact_state_t
    use mdrcontact_contact_equilibrium, only: equilibrium_t
    use mdrcontact_error, only: error_no_convergence, error_t, raise, to_text
    use mdrcontact_fit_chebyshev, only: node_positions, nodes, tail, to_coefficients, value_and_slope
    use mdrcontact_fit_radius_range, only: last_coordinate, radius_range
    use mdrcontact_kinds, only: wp
    implicit none (type, external)
    private
    public :: force_curve_t, new_force_curve

    integer, parameter :: most_panels = 200
    !> Relative accuracy of the curve: far below any data, far above rounding.
    real(wp), parameter :: tolerance = 1.0e-9_wp
    !> A panel in ln a is not halved below this width: a kink of a tabulated shape is then resolved well enough.
    real(wp), parameter :: narrowest = 1.0e-3_wp
    integer, parameter :: most_newton = 60
    !> Panels in ln a that resolve a film.
    real(wp), parameter :: usual_panel = 1.2_wp

    !> A traced curve.
    type :: force_curve_t
        private
        !> ln d and ln F are interpolated instead of d and F (without adhesion)
        logical :: logarithmic = .true.
        !> edges of the panels in ln(a - end radius), and the (logarithmic) depth there, both ascending
        real(wp), allocatable :: edges(:), depths(:)
        !> (nodes, panels)
        real(wp), allocatable :: depth(:, :), force(:, :)
        !> the state at the vertical wall of the indenter, beyond which it is a flat punch
        type(contact_state_t), allocatable :: wall
    contains
        procedure :: at
    end type force_curve_t

contains

    !> Traces the curve between two depths.
    subroutine new_force_curve(self, equilibrium, smallest, largest, error)
        type(force_curve_t), intent(out) :: self
        type(equilibrium_t), intent(in) :: equilibrium
        !> the range of depths that will be asked for, largest > 0 [length]
        real(wp), intent(in) :: smallest, largest
        type(error_t), allocatable, intent(out) :: error
        real(wp), allocatable :: breaks(:)
        real(wp) :: first, last
        integer :: i, count

        if (equilibrium%profile%end_radius() >= equilibrium%last_radius) then
            allocate (self%wall)
            call equilibrium%at(equilibrium%last_radius, self%wall, error)
            return
        end if
        self%logarithmic = .not. equilibrium%work_of_adhesion > 0.0_wp
        call radius_range(equilibrium, smallest, largest, first, last, error)
        if (allocated(error)) return
        if (last >= last_coordinate(equilibrium) .and. equilibrium%profile%has_wall()) then
            allocate (self%wall)
            call equilibrium%at(equilibrium%radius_of(last), self%wall, error)
            if (allocated(error)) return
        end if
        breaks = equilibrium%profile%break_radii()
        breaks = [(equilibrium%coordinate_of(breaks(i)), i=1, size(breaks))]
        breaks = [first, pack(breaks, breaks > first + narrowest .and. breaks < last - narrowest), last]
        if (size(breaks) == 2) then
            ! panels that are resolved as a rule; a larger one would be sampled in vain
            count = ceiling((last - first)/usual_panel)
            breaks = [(first + (last - first)*i/count, i=0, count)]
        end if
        call trace(self, equilibrium, breaks, error)
        if (.not. allocated(error) .and. .not. self%logarithmic) call cut_at_pull_off(self)
    end subroutine new_force_curve

    !> Samples the panels between `breaks`, and halves those that are not resolved.
    subroutine trace(self, equilibrium, breaks, error)
        type(force_curve_t), intent(inout) :: self
        type(equilibrium_t), intent(in) :: equilibrium
        real(wp), intent(in) :: breaks(:)
        type(error_t), allocatable, intent(out) :: error
        real(wp) :: pending(most_panels), edges(most_panels + 1), d(nodes, most_panels), f(nodes, most_panels), right, z
        logical :: resolved
        integer :: waiting, count

        if (size(breaks) > most_panels) then
            call raise(error, error_no_convergence, "the indenter has too many breaks for a fit")
            return
        end if
        waiting = size(breaks) - 1
        pending(:waiting) = breaks(size(breaks):2:-1)
        edges(1) = breaks(1)
        count = 0
        do while (waiting > 0)
            right = pending(waiting)
            call sample(self%logarithmic, equilibrium, edges(count + 1), right, d(:, count + 1), f(:, count + 1), resolved, error)
            if (allocated(error)) return
            if (resolved .or. right - edges(count + 1) < narrowest .or. waiting >= most_panels) then
                count = count + 1
                edges(count + 1) = right
                waiting = waiting - 1
            else
                waiting = waiting + 1
                pending(waiting) = 0.5_wp*(edges(count + 1) + right)
            end if
            if (count >= most_panels) then
                call raise(error, error_no_convergence, "the force-depth curve has too many kinks for a fit")
                return
            end if
        end do
        self%edges = edges(:count + 1)
        self%depth = d(:, :count)
        self%force = f(:, :count)
        allocate (self%depths(count + 1))
        do waiting = 1, count
            call value_and_slope(d(:, waiting), -1.0_wp, self%depths(waiting), z)
        end do
        call value_and_slope(d(:, count), 1.0_wp, self%depths(count + 1), z)
    end subroutine trace

    !> One panel.
    subroutine sample(logarithmic, equilibrium, left, right, depth, force, resolved, error)
        logical, intent(in) :: logarithmic
        type(equilibrium_t), intent(in) :: equilibrium
        real(wp), intent(in) :: left, right
        real(wp), intent(out) :: depth(nodes), force(nodes)
        logical, intent(out) :: resolved
        type(error_t), allocatable, intent(out) :: error
        type(contact_state_t) :: state
        real(wp) :: z(nodes), d(nodes), f(nodes)
        integer :: i

        resolved = .false.
        z = node_positions()
        do i = 1, nodes
            call equilibrium%at(equilibrium%radius_of(left + 0.5_wp*(right - left)*(1.0_wp + z(i))), state, error)
            if (allocated(error)) return
            d(i) = state%depth
            f(i) = state%force
        end do
        if (logarithmic) then
            if (.not. (minval(d) > 0.0_wp .and. minval(f) > 0.0_wp)) then
                call raise(error, error_no_convergence, "the depth or the force of this medium is not positive near a = "// &
                           to_text(equilibrium%radius_of(left)))
                return
            end if
            d = log(d)
            f = log(f)
        end if
        depth = to_coefficients(d)
        force = to_coefficients(f)
        if (logarithmic) then
            resolved = max(tail(depth), tail(force)) <= tolerance
        else
            resolved = tail(depth) <= tolerance*maxval(abs(d)) .and. tail(force) <= tolerance*maxval(abs(f))
        end if
    end subroutine sample

    !> Drops what lies below the lowest depth: the part of an adhesive branch that is unstable under depth control.
    subroutine cut_at_pull_off(self)
        type(force_curve_t), intent(inout) :: self
        real(wp) :: low, high, middle, value, slope
        integer :: i, count, step

        count = size(self%edges) - 1
        do i = count, 1, -1
            call value_and_slope(self%depth(:, i), -1.0_wp, value, slope)
            if (slope <= 0.0_wp) exit
        end do
        if (i == 0) return
        low = -1.0_wp
        high = 1.0_wp
        do step = 1, most_newton
            middle = 0.5_wp*(low + high)
            call value_and_slope(self%depth(:, i), middle, value, slope)
            if (slope <= 0.0_wp) then
                low = middle
            else
                high = middle
            end if
        end do
        ! The panel keeps its polynomial, and with it the edge z = -1; only the depth at which it begins is raised.
        self%edges = self%edges(i:)
        self%depth = self%depth(:, i:)
        self%force = self%force(:, i:)
        self%depths = self%depths(i:)
        call value_and_slope(self%depth(:, 1), high, self%depths(1), slope)
        self%edges(1) = self%edges(1) + 0.5_wp*(1.0_wp + high)*(self%edges(2) - self%edges(1))
        call rescale(self%depth(:, 1), high)
        call rescale(self%force(:, 1), high)
    end subroutine cut_at_pull_off

    !> The coefficients of the same polynomial on [z, 1] instead of [-1, 1].
    pure subroutine rescale(c, z)
        real(wp), intent(inout) :: c(nodes)
        real(wp), intent(in) :: z
        real(wp) :: values(nodes), positions(nodes), slope
        integer :: i

        positions = z + 0.5_wp*(1.0_wp - z)*(1.0_wp + node_positions())
        do i = 1, nodes
            call value_and_slope(c, positions(i), values(i), slope)
        end do
        c = to_coefficients(values)
    end subroutine rescale

    !> F at a depth. Without adhesion 0 for d <= 0; with it the pull-off value below the pull-off depth, where there is no state:
    !> such points do not belong into a fit. Beyond the end of the curve an error.
    elemental subroutine at(self, d, force, reached)
        class(force_curve_t), intent(in) :: self
        !> [length]
        real(wp), intent(in) :: d
        !> [modulus length^2]
        real(wp), intent(out) :: force
        !> false where the indenter or the medium ends before
        logical, intent(out) :: reached
        real(wp) :: x, slope, depth_slope, z
        integer :: low, high, middle

        reached = .true.
        force = 0.0_wp
        if (allocated(self%wall)) then
            if (d >= self%wall%depth .or. .not. allocated(self%edges)) then
                force = self%wall%force + self%wall%stiffness*(d - self%wall%depth)
                if (self%logarithmic .and. d <= 0.0_wp) force = 0.0_wp
                return
            end if
        end if
        if (self%logarithmic .and. d <= 0.0_wp) return
        x = d
        if (self%logarithmic) x = log(d)
        low = 1
        high = size(self%edges)
        if (x > self%depths(high) + 1.0e-6_wp*(self%depths(high) - self%depths(1))) reached = .false.
        do while (high - low > 1)
            middle = (low + high)/2
            if (x < self%depths(middle)) then
                high = middle
            else
                low = middle
            end if
        end do
        if (x <= self%depths(1)) then
            call value_and_slope(self%force(:, 1), -1.0_wp, force, slope)
            if (self%logarithmic) then
                ! below the traced range both are powers of a
                call value_and_slope(self%depth(:, 1), -1.0_wp, z, depth_slope)
                force = exp(force + (x - self%depths(1))*slope/depth_slope)
            end if
            return
        end if
        z = position_with(self%depth(:, low), x)
        call value_and_slope(self%force(:, low), z, force, slope)
        if (self%logarithmic) force = exp(force)
    end subroutine at

    !> The z in [-1, 1] at which an ascending polynomial has a value: Newton, held in a shrinking bracket.
    pure function position_with(c, target_value) result(z)
        real(wp), intent(in) :: c(nodes), target_value
        real(wp) :: z
        real(wp) :: low, high, value, slope, step
        integer :: i

        low = -1.0_wp
        high = 1.0_wp
        z = 0.0_wp
        do i = 1, most_newton
            call value_and_slope(c, z, value, slope)
            if (value < target_value) then
                low = z
            else
                high = z
            end if
            step = (target_value - value)/sign(max(abs(slope), tiny(slope)), slope)
            if (abs(step) <= 1.0e-13_wp) return
            if (z + step > low .and. z + step < high) then
                z = z + step
            else
                z = 0.5_wp*(low + high)
            end if
            if (high - low <= 1.0e-14_wp) return
        end do
    end function position_with

end module mdrcontact_fit_force_curve
