! SPDX-License-Identifier: GPL-3.0-or-later
!> F(d) of one contact over a range of depths: its equilibria traced once, then any number of depths inverted on the samples. With
!> adhesion the curve is the branch that unloading follows down to pull-off, where it ends.
module mdrcontact_fit_force_curve
    use mdrcontact_contact_control, only: depth_control
    use mdrcontact_contact_curve, only: curve_point_t, curve_t, new_curve
    use mdrcontact_contact_equilibrium, only: equilibrium_t
    use mdrcontact_contact_range, only: coordinate_before, coordinate_below_pull_off, coordinate_beyond, coordinates_between
    use mdrcontact_contact_state, only: contact_state_t
    use mdrcontact_error, only: error_t, error_unreachable, raise, to_text
    use mdrcontact_kinds, only: wp
    use mdrcontact_numerics_chebyshev, only: node, series_of_values, series_value, terms
    implicit none (type, external)
    private
    public :: force_curve_t, new_force_curve

    !> Relative accuracy of the curve: far below any data, far above rounding.
    real(wp), parameter :: tolerance = 1.0e-9_wp
    !> Depths below this part of the largest one are extrapolated.
    real(wp), parameter :: smallest_depth_ratio = 1.0e-6_wp
    !> So many depths for each term of the series in the depth pay for them.
    integer, parameter :: worth = 3

    !> A traced curve.
    type :: force_curve_t
        private
        !> not allocated where there is but one contact radius
        type(curve_t), allocatable :: curve
        !> coordinates between which depth and force rise, and the states there
        real(wp) :: first = 0.0_wp, last = 0.0_wp
        type(curve_point_t) :: lowest, highest
        logical :: adhesive = .false.
        !> the state at the vertical wall of the indenter, beyond which it is a flat punch
        type(contact_state_t), allocatable :: wall
        !> where many depths follow without adhesion: ln d at the ends of the curve's panels; series of ln F and of the
        !> coordinate in ln d between them (2, terms, panels); and whether they are as accurate as the curve
        real(wp), allocatable :: log_depths(:), series(:, :, :)
        logical, allocatable :: converged(:)
    contains
        procedure :: at
        procedure :: pull_off_depth
    end type force_curve_t

contains

    !> Traces the curve between two depths.
    subroutine new_force_curve(self, equilibrium, smallest, largest, error, count)
        type(force_curve_t), intent(out) :: self
        type(equilibrium_t), intent(in) :: equilibrium
        !> the range of depths that will follow, largest > 0, or with adhesion anything but 0 [length]
        real(wp), intent(in) :: smallest, largest
        type(error_t), allocatable, intent(out) :: error
        !> how many depths will follow; default: few
        integer, intent(in), optional :: count
        real(wp), allocatable :: brackets(:, :), coordinates(:)
        real(wp) :: found
        integer :: i, solutions

        self%adhesive = equilibrium%work_of_adhesion > 0.0_wp
        if (equilibrium%profile%end_radius >= equilibrium%last_radius) then
            allocate (self%wall)
            call equilibrium%at(equilibrium%last_radius, self%wall, error)
            return
        end if
        if (.not. (abs(smallest) + abs(largest) <= huge(1.0_wp) .and. max(abs(smallest), largest) > 0.0_wp)) then
            call raise(error, error_unreachable, "depths from "//to_text(smallest)//" to "//to_text(largest)// &
                " do not define a curve")
            return
        end if
        solutions = 0
        ! an adhesive contact may lie below depth 0 altogether
        call coordinate_beyond(equilibrium, largest, max(largest, merge(0.0_wp, abs(smallest), largest > 0.0_wp)), self%last, &
                               found, solutions, error)
        if (allocated(error)) return
        if (found < largest) then
            if (.not. equilibrium%profile%has_wall) then
                call raise(error, error_unreachable, " = "//to_text(largest)//": the indenter or the medium ends at depth "// &
                           to_text(found)//trim(equilibrium%why_it_ends()), "depth")
                return
            end if
            allocate (self%wall)
            call equilibrium%at(equilibrium%last_radius, self%wall, error)
            if (allocated(error)) return
        end if
        if (self%adhesive) then
            call coordinate_below_pull_off(equilibrium, self%last, smallest, self%first, error)
        else
            call coordinate_before(equilibrium, max(smallest, smallest_depth_ratio*largest), self%first, found, solutions, error)
        end if
        if (allocated(error)) return
        self%first = min(self%first, self%last - 0.01_wp)
        allocate (self%curve)
        call coordinates_between(equilibrium, self%first, self%last, coordinates, error)
        if (.not. allocated(error)) call new_curve(self%curve, equilibrium, coordinates, tolerance, error)
        if (allocated(error)) return
        if (self%adhesive) then
            ! Below the uppermost minimum of the depth the branch is unstable.
            allocate (brackets, source=self%curve%turns(depth_control))
            do i = 1, size(brackets, 2)
                if (self%curve%slope(depth_control, brackets(2, i)) < 0.0_wp) cycle
                call self%curve%turn(depth_control, brackets(1, i), brackets(2, i), self%first, error)
                if (allocated(error)) return
            end do
        end if
        self%lowest = self%curve%at(self%first)
        self%highest = self%curve%at(self%last)
        if (self%adhesive .or. .not. present(count)) return
        if (count >= worth*terms*(size(self%curve%edges) - 1)) call expand_in_depth(self)
    end subroutine new_force_curve

    !> From series in the coordinate to series in ln d, panel by panel.
    pure subroutine expand_in_depth(self)
        type(force_curve_t), intent(inout) :: self
        type(curve_point_t) :: point
        real(wp) :: values(2, terms), middle, half
        integer :: i, j, panels

        panels = size(self%curve%edges) - 1
        allocate (self%log_depths(panels + 1), self%series(2, terms, panels), self%converged(panels))
        do i = 1, panels + 1
            point = self%curve%at(self%curve%edges(i))
            self%log_depths(i) = log(point%depth)
        end do
        do i = 1, panels
            middle = 0.5_wp*(self%log_depths(i) + self%log_depths(i + 1))
            half = 0.5_wp*(self%log_depths(i + 1) - self%log_depths(i))
            do j = 1, terms
                point = self%curve%find(depth_control, 0.0_wp, 1.0_wp, .false., exp(middle + half*node(j, terms)), &
                                        self%curve%edges(i), self%curve%edges(i + 1))
                values(:, j) = [log(point%force), point%x]
            end do
            self%series(:, :, i) = series_of_values(values)
            self%converged(i) = half > 0.0_wp .and. maxval(abs(self%series(:, terms - 1:, i))) <= tolerance
        end do
    end subroutine expand_in_depth

    !> The depth at which unloading leaves the curve and the bodies part; without adhesion 0.
    pure function pull_off_depth(self) result(depth)
        class(force_curve_t), intent(in) :: self
        real(wp) :: depth

        depth = 0.0_wp
        if (.not. self%adhesive) return
        if (allocated(self%curve)) then
            depth = self%lowest%depth
        else
            depth = self%wall%depth
        end if
    end function pull_off_depth

    !> F and a in contact at a depth. Without adhesion 0 for d <= 0; with it those of pull-off below the pull-off depth, where
    !> there is no contact: whether a point belongs there is decided by the caller. Beyond the end of the curve an error.
    elemental subroutine at(self, d, force, radius, reached)
        class(force_curve_t), intent(in) :: self
        !> [length]
        real(wp), intent(in) :: d
        !> [modulus length^2]
        real(wp), intent(out) :: force
        !> [length]
        real(wp), intent(out) :: radius
        !> false where the indenter or the medium ends before
        logical, intent(out) :: reached
        type(curve_point_t) :: point
        real(wp) :: power, values(2), z
        integer :: panel

        reached = .true.
        force = 0.0_wp
        radius = 0.0_wp
        if (.not. self%adhesive .and. d <= 0.0_wp) return
        if (allocated(self%wall)) then
            if (d >= self%wall%depth .or. .not. allocated(self%curve)) then
                force = self%wall%force + self%wall%stiffness*(max(d, self%pull_off_depth()) - self%wall%depth)
                radius = self%wall%radius
                return
            end if
        end if
        reached = d <= self%highest%depth + 1.0e-6_wp*(self%highest%depth - self%lowest%depth)
        if (allocated(self%series) .and. d > self%lowest%depth) then
            panel = max(count(self%log_depths(:size(self%converged)) <= log(d)), 1)
            if (self%converged(panel)) then
                z = (2.0_wp*log(d) - self%log_depths(panel) - self%log_depths(panel + 1)) &
                    /(self%log_depths(panel + 1) - self%log_depths(panel))
                values = exp(series_value(self%series(:, :, panel), z))
                force = values(1)
                radius = self%curve%coordinate%end_radius + values(2)
                return
            end if
        end if
        point = self%lowest
        if (d > self%lowest%depth .and. self%adhesive) then
            point = self%curve%find(depth_control, self%lowest%depth, 1.0_wp, .true., d - self%lowest%depth, self%first, self%last)
        else if (d > self%lowest%depth) then
            point = self%curve%find(depth_control, 0.0_wp, 1.0_wp, .false., d, self%first, self%last)
        else if (.not. self%adhesive) then
            ! below the traced range force and depth are powers of a, k is proportional to a, and dF = k dd
            power = point%stiffness*point%depth/point%force
            point%force = point%force*(d/point%depth)**power
            point%radius = point%radius*(d/point%depth)**(power - 1.0_wp)
        end if
        force = point%force
        radius = point%radius
    end subroutine at

end module mdrcontact_fit_force_curve
