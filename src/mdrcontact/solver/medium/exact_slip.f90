! SPDX-License-Identifier: GPL-3.0-or-later
!> First shear of a layered body, exactly in the axisymmetric part (theory/friction.md (3.1)-(3.6)): with a stick zone of radius c
!> the load q* = q_n - q_t is that of a contact of radius c without adhesion, with the kernel of shear and the profile [R(0) -
!> R(x)]/G0*. Its depth is R(0)/G0* - s, its force F - T.
module mdrcontact_medium_exact_slip
    use mdrcontact_error, only: check_memory, error_domain, error_t, raise
    use mdrcontact_medium_slip, only: slip_t, thin
    use mdrcontact_kinds, only: wp
    use mdrcontact_line_fields, only: line_load_t, new_line_load
    use mdrcontact_line_slip_profile, only: slip_profile_t
    use mdrcontact_medium_load, only: load_t
    use mdrcontact_medium_solver, only: copy, solved_t, solver_t
    use mdrcontact_medium_superposed_slip, only: traction_between
    use mdrcontact_numerics_quadrature, only: graded_edges, graded_rule, mark_breaks, smallest_panel_ratio
    use mdrcontact_numerics_pick, only: pick
    use mdrcontact_profile, only: copy, profile_t
    implicit none (type, external)
    private
    public :: layered_slip_t, new_layered_slip

    !> Nodes in a panel, of springs that slip and of stick radii.
    integer, parameter :: nodes = 12
    !> Largest apparent excess of the first shift over that of sliding where they are equal, as under a punch on a homogeneous body.
    real(wp), parameter :: largest_excess = 1.0e-9_wp

    !> One normal state, the medium that responds to shear, and the profile above.
    type, extends(slip_t) :: layered_slip_t
        private
        class(solver_t), allocatable :: normal, tangential
        type(slip_profile_t) :: profile
        !> q_n/E0*
        type(line_load_t) :: springs
        !> depth beyond the non-adhesive one [length]
        real(wp) :: punch_depth = 0.0_wp
    contains
        procedure :: dissipation
        procedure :: rates
        procedure :: panels
        procedure :: at
        procedure :: line_load
        procedure :: traction
    end type layered_slip_t

contains

    !> From the springs' line load.
    subroutine new_layered_slip(self, normal, tangential, profile, springs, sheared, punch_depth, error)
        type(layered_slip_t), intent(out) :: self
        !> the medium under normal load and under shear, with their springs
        class(solver_t), intent(in) :: normal, tangential
        class(profile_t), intent(in) :: profile
        !> q_n/E0*, and (K_t q_n)/E0* as coefficients of P_2j(x/a) [length]
        type(line_load_t), intent(in) :: springs
        real(wp), intent(in) :: sheared(:)
        !> depth beyond the non-adhesive one [length]
        real(wp), intent(in) :: punch_depth
        type(error_t), allocatable, intent(out) :: error
        real(wp), allocatable :: exponents(:), coefficients(:)
        type(solved_t) :: pressed
        real(wp) :: even, depth, force
        integer :: j

        call copy(normal, self%normal, error)
        if (.not. allocated(error)) call copy(tangential, self%tangential, error)
        if (.not. allocated(error)) call copy(profile, self%profile%base, error)
        if (allocated(error)) return
        self%radius = springs%a
        call normal%solve(profile, springs%a, pressed, error)
        if (allocated(error)) return
        self%force = pressed%force + 2.0_wp*springs%a*pressed%modulus*punch_depth
        self%punch_depth = punch_depth
        self%springs = springs
        call profile%powers(exponents, coefficients)
        if (size(exponents) > 0) self%exponent = minval(exponents)
        associate (kernel => tangential%springs%kernel)
            if (size(exponents) > 0 .and. .not. kernel%vanishes) self%scale = kernel%unit
        end associate
        self%nodes = nodes
        self%profile%radius = springs%a
        self%profile%largest_radius = springs%a
        self%profile%singular_radius = profile%singular_radius
        self%profile%ratio = normal%springs%modulus/tangential%springs%modulus
        self%profile%c = springs%v - sheared
        self%profile%c = self%profile%c(:last_that_counts(self%profile%c))
        even = 1.0_wp
        do j = 1, size(self%profile%c)
            self%profile%at_axis = self%profile%at_axis + self%profile%c(j)*even
            even = -even*real(2*j - 1, wp)/real(2*j, wp)
        end do
        self%sliding_shift = self%profile%ratio*(pressed%depth + punch_depth - self%profile%at_axis)
        call solve(self, self%radius, depth, force, self%stiffness, self%edge_rate, error)
        ! without a load at the edge something slips with the slightest shift
        if (allocated(error) .or. punch_depth <= 0.0_wp) return
        self%first_shift = self%sliding_shift - depth
        if (self%first_shift > self%sliding_shift*(1.0_wp + largest_excess)) then
            call raise(error, error_domain, "slip would begin inside this contact, as under a flat punch on a stiff coating. "// &
                       "Partial slip is available only if it begins at the edge")
        end if
    end subroutine new_layered_slip

    !> Where a series ends but for terms below rounding; at least one is left.
    pure function last_that_counts(c) result(last)
        real(wp), intent(in) :: c(:)
        integer :: last

        do last = size(c), 2, -1
            if (abs(c(last)) > 0.01_wp*epsilon(c)*maxval(abs(c))) return
        end do
        last = 1
    end function last_that_counts

    !> Depth, force, stiffness and slope of the depth of the contact that q* is.
    subroutine solve(self, c, depth, force, stiffness, slope, error, stiffness_slope)
        class(layered_slip_t), intent(in) :: self
        real(wp), intent(in) :: c
        real(wp), intent(out) :: depth, force, stiffness, slope
        type(error_t), allocatable, intent(out) :: error
        real(wp), intent(out), optional :: stiffness_slope
        type(solved_t) :: stuck

        call self%tangential%solve(self%profile, c, stuck, error, adhesive=present(stiffness_slope))
        depth = stuck%depth
        force = stuck%force
        stiffness = 2.0_wp*c*stuck%modulus
        slope = stuck%depth_slope
        if (present(stiffness_slope)) stiffness_slope = stuck%stiffness_slope
    end subroutine solve

    subroutine rates(self, c, shift, shift_rate, stiffness, stiffness_slope, error)
        class(layered_slip_t), intent(in) :: self
        real(wp), intent(in) :: c(:)
        real(wp), intent(out) :: shift(:), shift_rate(:), stiffness(:), stiffness_slope(:)
        type(error_t), allocatable, intent(out) :: error
        real(wp) :: depth, force
        integer :: i

        do i = 1, size(c)
            call solve(self, c(i), depth, force, stiffness(i), shift_rate(i), error, stiffness_slope(i))
            if (allocated(error)) return
            shift(i) = self%sliding_shift - depth
        end do
    end subroutine rates

    !> Panels of a thin annulus, see dissipation. At its edge R varies at the length of the kernel.
    subroutine panels(self, c, edges, has_root, error)
        class(layered_slip_t), intent(in) :: self
        real(wp), intent(in) :: c
        real(wp), allocatable, intent(out) :: edges(:)
        logical, allocatable, intent(out) :: has_root(:)
        type(error_t), allocatable, intent(inout) :: error
        real(wp), allocatable :: breaks(:)
        real(wp) :: limit

        call self%profile%add_breaks(breaks, error)
        if (allocated(error)) return
        limit = self%profile%singular_radius
        if (.not. self%tangential%springs%kernel%vanishes) limit = min(limit, self%radius + self%tangential%springs%kernel%unit)
        call graded_edges(c, self%radius, breaks, limit, edges, error)
        call mark_breaks(edges, breaks, has_root, error)
    end subroutine panels

    !> 2 int_c^a q_n(x) w(x) dx: the springs of the annulus slip under their limit by w = R(x)/G0* + (K_t q*)(x)/G0* - d*, d* the
    !> depth of q*. One solution is enough, where an integral over c takes many; of a thin annulus w would be a small difference.
    subroutine dissipation(self, c, width, shift, dissipated, error)
        class(layered_slip_t), intent(in) :: self
        real(wp), intent(in) :: c, width, shift
        real(wp), intent(out) :: dissipated
        type(error_t), allocatable, intent(out) :: error
        type(line_load_t) :: stuck
        real(wp), allocatable, dimension(:) :: breaks, exponents, coefficients, x, dx, distances, added, q
        real(wp) :: start, length, depth, same_shift, force
        integer :: stat

        if (width < thin*self%radius) then
            call self%integrate(c, width, same_shift, force, dissipated, error, shift)
            return
        end if
        dissipated = 0.0_wp
        start = max(c, smallest_panel_ratio*self%radius)
        associate (springs => self%tangential%springs)
            call new_line_load(stuck, springs%kernel, springs%tolerance, self%profile, start, 0.0_wp, error)
        end associate
        if (allocated(error)) return
        ! everything varies at the length of the kernel next to c and a, and more slowly between, but for g: radii are counted from
        ! one length below c
        length = merge(self%radius, self%tangential%springs%kernel%unit, self%tangential%springs%kernel%vanishes)
        call self%profile%base%powers(exponents, coefficients)
        if (size(exponents) == 0 .or. any(modulo(exponents, 1.0_wp) > 0.0_wp)) breaks = [0.0_wp]
        call self%profile%add_breaks(breaks, error)
        if (allocated(error)) return
        breaks = (breaks - start) + length
        call graded_rule(length, length + (self%radius - start), breaks, &
                         min((self%profile%singular_radius - start) + length, (self%radius - start) + 2.0_wp*length), x, dx, &
                         error, distances, nodes)
        if (allocated(error)) return
        allocate (added(size(x)), q(size(x)), stat=stat)
        call check_memory(error, stat)
        if (allocated(error)) return
        call stuck%interaction_beyond(self%tangential%springs%kernel, size(x), distances, added, error)
        if (allocated(error)) return
        x(:) = start + distances
        call self%springs%at(self%profile%base, x, q)
        ! a sharp tip still shows in the depth where nothing else does
        depth = stuck%depth*min(c/start, 1.0_wp)**self%exponent
        dissipated = 2.0_wp*self%normal%springs%modulus*sum(dx*q*(self%profile%mdr_at(x) + added - depth))
    end subroutine dissipation

    subroutine at(self, c, width, shift, force, stiffness, shift_rate, error)
        class(layered_slip_t), intent(in) :: self
        real(wp), intent(in) :: c, width
        real(wp), intent(out) :: shift, force, stiffness, shift_rate
        type(error_t), allocatable, intent(out) :: error
        real(wp) :: dissipated

        call solve(self, c, shift, force, stiffness, shift_rate, error)
        if (allocated(error)) return
        shift = self%sliding_shift - shift
        force = self%force - force
        if (width < thin*self%radius) call self%integrate(c, width, shift, force, dissipated, error)
    end subroutine at

    !> q_n - q*.
    subroutine line_load(self, c, r, values, error)
        class(layered_slip_t), intent(in), target :: self
        real(wp), intent(in) :: c
        real(wp), intent(in) :: r(:)
        real(wp), intent(out) :: values(:)
        type(error_t), allocatable, intent(out) :: error
        class(load_t), allocatable :: stuck
        real(wp), allocatable :: inside(:), inner(:)
        integer, allocatable :: places(:)
        integer :: i

        call self%springs%at(self%profile%base, r, values)
        values = self%normal%springs%modulus*values
        call pick(r, places, inside, inner, error, below=c)
        if (allocated(error) .or. size(places) == 0) return
        call self%tangential%load(self%profile, c, 0.0_wp, stuck, error)
        if (.not. allocated(error)) call stuck%line_load(inside, inner, error)
        if (allocated(error)) return
        do i = 1, size(places)
            values(places(i)) = values(places(i)) - inner(i)
        end do
    end subroutine line_load

    !> p - p*.
    subroutine traction(self, c, r, values, error)
        class(layered_slip_t), intent(in), target :: self
        real(wp), intent(in) :: c
        real(wp), intent(in) :: r(:)
        real(wp), intent(out) :: values(:)
        type(error_t), allocatable, intent(out) :: error
        class(load_t), allocatable :: pressed

        call self%normal%load(self%profile%base, self%radius, self%punch_depth, pressed, error)
        if (.not. allocated(error)) call traction_between(pressed, self%tangential, self%profile, c, r, values, error)
    end subroutine traction

end module mdrcontact_medium_exact_slip
