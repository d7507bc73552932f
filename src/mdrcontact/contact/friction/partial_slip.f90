! SPDX-License-Identifier: GPL-3.0-or-later
!> A contact under Coulomb's law of friction: partial slip at constant normal force (theory/friction.md (3.4), (3.5), (3.7)).
!>
!> The indenter is displaced by the shift s along the surface. A stick zone shrinks from the contact radius to 0, where sliding
!> begins. Neglected are the displacement that varies as cos 2 phi around the axis and the effect of the shear on the pressure.
!>
!> Twisted about its axis by the angle phi, Lubkin's problem, the disc shrinks towards the axis, and the same two functions of its
!> radius give all. Nothing is neglected then: torsion moves neither the pressure nor anything that varies around the axis.
module mdrcontact_friction_partial_slip
    use, intrinsic :: iso_c_binding, only: c_double
    use, intrinsic :: iso_fortran_env, only: int64
    use mdrcontact_object, only: object_t, room
    use mdrcontact_body_compliance, only: shear_load
    use mdrcontact_contact, only: contact_t
    use mdrcontact_error, only: check_finite, check_made, check_not_negative, check_positive, error_invalid, error_t, &
                                error_unreachable, raise, to_text
    use mdrcontact_contact_load, only: check_positions, contact_load_t
    use mdrcontact_medium_slip, only: slip_t
    use mdrcontact_kinds, only: wp
    use mdrcontact_medium_solver, only: solver_t
    use mdrcontact_medium_twisted_slip, only: new_twisted_slip, twisted_slip_t
    use mdrcontact_numerics_roots, only: solve_increasing
    use mdrcontact_numerics_scalar_function, only: scalar_function_t
    implicit none (type, external)
    private
    public :: friction_t, new_friction, tangential_state_t, first_shear_t

    !> ln(a^2/c^2 - 1) at least, below which no double changes, and at most: c = 1e-10 a.
    real(wp), parameter :: least = -700.0_wp, most = 46.0_wp

    !> Kind of shear of a contact, and its names: a shift under a force, or a twist under a torque.
    integer, parameter :: along_surface = 1, about_axis = 2
    character(len=*), parameter :: ways(*) = [character(len=5) :: "shift", "twist"], &
                                   loads(*) = [character(len=16) :: "tangential_force", "torque"], &
                                   states(*) = [character(len=16) :: "tangential state", "torsional state"]

    !> A state of partial slip, C's struct mdr_shear_state; of a twist, C's struct mdr_shear_state, with phi [radian] instead of s,
    !> M [modulus length^3] in that of T, and dM/dphi [modulus length^3] in that of dT/ds.
    type, bind(C) :: tangential_state_t
        !> s, of the indenter along the surface [length]
        real(c_double) :: shift = 0.0_c_double
        !> T [modulus length^2]
        real(c_double) :: tangential_force = 0.0_c_double
        !> c, 0 where the contact slides [length]
        real(c_double) :: stick_radius = 0.0_c_double
        !> dT/ds = k_t(c) [modulus length]
        real(c_double) :: stiffness = 0.0_c_double
        !> energy dissipated since s = 0 [modulus length^3]
        real(c_double) :: dissipated_energy = 0.0_c_double
        !> 1 if the whole contact slides, else 0
        real(c_double) :: sliding = 0.0_c_double
    end type tangential_state_t

    !> A contact and its coefficient of friction. It never changes; any number of threads may share it.
    type, extends(object_t) :: friction_t
        !> read only
        type(contact_t) :: contact
        !> of friction, > 0 [1]
        real(wp) :: coefficient = 0.0_wp
        !> what responds to a shift as the contact's medium does to a depth: its modulus is G_t(a) = k_t(a)/(2 a)
        class(solver_t), allocatable :: tangential
    contains
        procedure :: first_shear
        procedure :: first_twist
        procedure :: bytes
    end type friction_t

    !> One normal state of it, sheared or twisted for the first time.
    type :: first_shear_t
        private
        !> whether it was made: set last by what makes it
        logical, public :: is_made = .false.
        class(slip_t), allocatable :: slip
        real(wp) :: coefficient = 0.0_wp
        integer :: way = along_surface
        !> contact radius a [length], mu F [modulus length^2] and the shift at which sliding begins [length]; of a twist the torque
        !> as the twist grows, mu int r p dA [modulus length^3], and the twist [radian]
        real(wp), public :: radius = 0.0_wp, sliding_force = 0.0_wp, sliding_shift = 0.0_wp
    contains
        procedure :: is_twist
        procedure :: at_shift
        procedure :: at_tangential_force
        procedure :: load_beyond
        procedure :: loop
        procedure :: line_load
        procedure :: traction
    end type first_shear_t

    !> ln of s or T over the requested value, of x = ln(a^2/c^2 - 1).
    type, extends(scalar_function_t) :: shear_equation_t
        class(slip_t), pointer :: slip => null()
        real(wp) :: target = 0.0_wp
        logical :: of_force = .false.
    contains
        procedure :: value => shear_value
    end type shear_equation_t

contains

    !> Coulomb's law in a contact.
    subroutine new_friction(self, contact, coefficient, error)
        type(friction_t), intent(out) :: self
        !> without adhesion, with a medium whose tangential stiffness is known. Copied
        type(contact_t), intent(in) :: contact
        !> mu > 0 [1]
        real(wp), intent(in) :: coefficient
        type(error_t), allocatable, intent(out) :: error

        call check_made(error, "contact", contact%is_made)
        if (allocated(error)) return
        call check_positive(error, "coefficient", coefficient)
        if (contact%is_adhesive()) then
            call raise(error, error_invalid, "friction: it is not available with adhesion, because Coulomb's law is not "// &
                       "defined under tension. Set work_of_adhesion = 0")
        end if
        if (allocated(error)) return
        call room(contact%equilibrium%bytes(), error)
        if (allocated(error)) return
        self%contact%equilibrium = contact%equilibrium
        self%contact%is_made = .true.
        self%coefficient = coefficient
        call contact%equilibrium%medium%for_load(shear_load, self%tangential, error)
        self%is_made = .not. allocated(error)
    end subroutine new_friction

    pure recursive function bytes(self)
        class(friction_t), intent(in) :: self
        integer(int64) :: bytes

        bytes = self%contact%equilibrium%bytes() + self%tangential%bytes()
    end function bytes

    !> Response of a normal state to a displacement of its indenter along the surface.
    subroutine first_shear(self, load, shear, error)
        class(friction_t), intent(in) :: self
        !> of a state of the contact
        type(contact_load_t), intent(in) :: load
        type(first_shear_t), intent(out) :: shear
        type(error_t), allocatable, intent(out) :: error
        class(slip_t), allocatable :: slip

        call check_made(error, "friction", self%is_made)
        call check_made(error, "load", load%is_made)
        if (allocated(error)) return
        call check_load(load, error)
        if (.not. allocated(error)) call load%equilibrium%medium%slip(self%tangential, load%surface, slip, error)
        if (.not. allocated(error)) call new_first_shear(shear, slip, self%coefficient)
    end subroutine first_shear

    !> Response of a normal state of a homogeneous medium to a twist of its indenter: twists and torques instead of shifts and
    !> forces.
    subroutine first_twist(self, load, shear, error)
        class(friction_t), intent(in) :: self
        !> of a state of the contact
        type(contact_load_t), intent(in) :: load
        type(first_shear_t), intent(out) :: shear
        type(error_t), allocatable, intent(out) :: error
        type(twisted_slip_t), allocatable :: twisted
        class(slip_t), allocatable :: slip

        call check_made(error, "friction", self%is_made)
        call check_made(error, "load", load%is_made)
        if (allocated(error)) return
        call check_load(load, error)
        if (allocated(error)) return
        allocate (twisted)
        associate (equilibrium => load%equilibrium, state => load%state)
            call new_twisted_slip(twisted, equilibrium%medium, equilibrium%profile, state%radius, state%punch_depth, error)
        end associate
        if (allocated(error)) return
        call move_alloc(twisted, slip)
        call new_first_shear(shear, slip, self%coefficient)
        shear%way = about_axis
    end subroutine first_twist

    !> Raises unless the pressure is nowhere negative.
    subroutine check_load(load, error)
        type(contact_load_t), intent(in) :: load
        type(error_t), allocatable, intent(out) :: error

        call check_not_negative(error, "punch_depth of the state", load%state%punch_depth)
        if (.not. allocated(error)) call load%check_one_disc("friction", error)
    end subroutine check_load

    !> First shear from what a medium provides.
    subroutine new_first_shear(self, slip, coefficient)
        type(first_shear_t), intent(out) :: self
        !> moved
        class(slip_t), allocatable, intent(inout) :: slip
        !> of friction [1]
        real(wp), intent(in) :: coefficient

        call move_alloc(slip, self%slip)
        self%coefficient = coefficient
        self%radius = self%slip%radius
        self%sliding_force = coefficient*self%slip%force
        self%sliding_shift = coefficient*self%slip%sliding_shift
        self%is_made = .true.
    end subroutine new_first_shear

    !> Whether it is turned about its axis, not displaced.
    pure function is_twist(self)
        class(first_shear_t), intent(in) :: self
        logical :: is_twist

        is_twist = self%way == about_axis
    end function is_twist

    !> The state at a shift.
    subroutine at_shift(self, shift, state, error)
        class(first_shear_t), intent(in), target :: self
        !> s, of either sign [length]
        real(wp), intent(in) :: shift
        type(tangential_state_t), intent(out) :: state
        type(error_t), allocatable, intent(out) :: error

        call check_made(error, "shear", self%is_made)
        if (allocated(error)) return
        call check_finite(error, ways(self%way), shift)
        if (allocated(error)) return
        if (abs(shift) >= self%sliding_shift) then
            call slide(self, state, error)
            state%dissipated_energy = state%dissipated_energy + self%sliding_force*(abs(shift) - self%sliding_shift)
        else
            call partial_slip(self, abs(shift)/self%coefficient, .false., state, error)
        end if
        state%shift = shift
        state%tangential_force = sign(state%tangential_force, shift)
    end subroutine at_shift

    !> The state under a tangential force; at |T| = mu F that in which sliding begins.
    subroutine at_tangential_force(self, force, state, error)
        class(first_shear_t), intent(in), target :: self
        !> T, |T| <= mu F [modulus length^2]; M, |M| < sliding_force [modulus length^3]
        real(wp), intent(in) :: force
        type(tangential_state_t), intent(out) :: state
        type(error_t), allocatable, intent(out) :: error

        call check_made(error, "shear", self%is_made)
        if (allocated(error)) return
        call check_finite(error, trim(loads(self%way)), force)
        if (allocated(error)) return
        if (self%way == about_axis .and. abs(force) >= self%sliding_force) then
            call raise(error, error_unreachable, " = "//to_text(force)//": it must be less than the torque of sliding, "// &
                       to_text(self%sliding_force), "torque")
            return
        else if (abs(force) > self%sliding_force) then
            call raise(error, error_unreachable, " = "//to_text(force)//": the contact slides at coefficient times normal "// &
                       "force, "//to_text(self%sliding_force), "tangential_force")
        else if (abs(force) >= self%sliding_force) then
            call slide(self, state, error)
        else
            call partial_slip(self, abs(force)/self%coefficient, .true., state, error)
        end if
        state%shift = sign(state%shift, force)
        state%tangential_force = force
    end subroutine at_tangential_force

    !> Load of the slipping annulus beyond a radius, less its load if it stuck to the disc inside: T - k_t(c) s at the
    !> stick radius c, for a coefficient of friction of 1.
    subroutine load_beyond(self, radius, load, error)
        class(first_shear_t), intent(in) :: self
        !> c, 0 < c < a [length]
        real(wp), intent(in) :: radius
        !> [modulus length^2]
        real(wp), intent(out) :: load
        type(error_t), allocatable, intent(out) :: error
        real(wp) :: c, shift, force, stiffness, rate

        load = 0.0_wp
        call check_made(error, "shear", self%is_made)
        if (allocated(error)) return
        c = max(radius, self%slip%smallest_stick, tiny(1.0_wp))
        if (.not. c < self%radius) return
        call self%slip%at(c, self%radius - c, shift, force, stiffness, rate, error)
        if (.not. allocated(error)) load = max(force - stiffness*shift, 0.0_wp)
    end subroutine load_beyond

    !> A cycle between +amplitude and -amplitude, by Masing's rule: from each turn the force changes as twice the first loading of
    !> half the way, because the limits of both senses lie symmetrically.
    subroutine loop(self, turn, shift, force, error)
        class(first_shear_t), intent(in) :: self
        !> the state of the amplitude, s > 0
        type(tangential_state_t), intent(in) :: turn
        !> s [length] and T [modulus length^2] in equal steps from +s to -s and back; same size, at least 3
        real(wp), intent(out) :: shift(:), force(:)
        type(error_t), allocatable, intent(out) :: error
        type(tangential_state_t) :: half
        real(wp) :: way
        integer :: i

        call check_made(error, "shear", self%is_made)
        if (allocated(error)) return
        do i = 1, size(shift)
            ! part of the way there, or back
            way = 2.0_wp*real(i - 1, wp)/real(size(shift) - 1, wp)
            if (way <= 1.0_wp) then
                call self%at_shift(turn%shift*way, half, error)
                shift(i) = turn%shift*(1.0_wp - 2.0_wp*way)
                force(i) = turn%tangential_force - 2.0_wp*half%tangential_force
            else
                call self%at_shift(turn%shift*(way - 1.0_wp), half, error)
                shift(i) = turn%shift*(2.0_wp*way - 3.0_wp)
                force(i) = 2.0_wp*half%tangential_force - turn%tangential_force
            end if
            if (allocated(error)) return
        end do
    end subroutine loop

    !> The whole contact at its bound, just when that is reached.
    subroutine slide(self, state, error)
        class(first_shear_t), intent(in) :: self
        type(tangential_state_t), intent(inout) :: state
        type(error_t), allocatable, intent(inout) :: error
        real(wp) :: dissipated, lowest

        lowest = max(self%slip%smallest_stick, tiny(1.0_wp))
        call self%slip%dissipation(lowest, self%radius - lowest, self%slip%sliding_shift, dissipated, error)
        state%shift = self%sliding_shift
        state%tangential_force = self%sliding_force
        state%dissipated_energy = self%coefficient**2*dissipated
        state%sliding = 1.0_wp
    end subroutine slide

    !> The state with a given s or T of friction coefficient 1, below that of sliding.
    subroutine partial_slip(self, given, of_force, state, error)
        type(first_shear_t), intent(in), target :: self
        real(wp), intent(in) :: given
        logical, intent(in) :: of_force
        type(tangential_state_t), intent(inout) :: state
        type(error_t), allocatable, intent(inout) :: error
        type(shear_equation_t) :: equation
        real(wp) :: x, c, width, shift, force, dissipated, rate, part
        logical :: found

        associate (slip => self%slip)
            if (given <= slip%first_shift*merge(slip%stiffness, 1.0_wp, of_force)) then
                state%stick_radius = slip%radius
                state%stiffness = slip%stiffness
                state%shift = self%coefficient*given*merge(1.0_wp/slip%stiffness, 1.0_wp, of_force)
                state%tangential_force = state%stiffness*state%shift
                return
            end if
            equation%slip => self%slip
            equation%target = given
            equation%of_force = of_force
            part = complement(first_part(), 2.0_wp/slip%exponent)
            call solve_increasing(equation, log(part/max(1.0_wp - part, 1.0e-6_wp)), 1.0_wp, least, most, x, found, error)
            if (allocated(error)) return
            call annulus(slip%radius, x, c, width)
            call slip%at(c, width, shift, force, state%stiffness, rate, error)
            if (.not. allocated(error)) call slip%dissipation(c, width, shift, dissipated, error)
            if (allocated(error)) return
            state%stick_radius = c
            state%shift = self%coefficient*shift
            state%tangential_force = self%coefficient*force
            state%dissipated_energy = self%coefficient**2*dissipated
        end associate

    contains

        !> t = 1 - (c/a)^m, m the exponent of the shift: exact under c r^m on a homogeneous body; else from the shift relative to
        !> that of sliding by t [1 + b (1 - t)] with the slope that it has at the edge.
        pure function first_part() result(t)
            real(wp) :: t
            real(wp) :: b, relative

            associate (slip => self%slip, m => self%slip%exponent)
                if (of_force) then
                    t = complement(given/slip%force, m/(m + 1.0_wp))
                    return
                end if
                relative = given/slip%sliding_shift
                t = relative
                if (.not. (slip%edge_rate > 0.0_wp .and. slip%first_shift <= 0.0_wp)) return
                b = min(max(slip%edge_rate*slip%radius/(m*slip%sliding_shift) - 1.0_wp, -0.9_wp), 0.9_wp)
                t = 2.0_wp*relative/((1.0_wp + b) + sqrt((1.0_wp + b)**2 - 4.0_wp*b*relative))
            end associate
        end function first_part

    end subroutine partial_slip

    !> 1 - (1 - part)^power, without cancellation for small parts.
    pure function complement(part, power) result(value)
        real(wp), intent(in) :: part, power
        real(wp) :: value

        if (part < 1.0e-4_wp) then
            value = power*part
        else
            value = 1.0_wp - (1.0_wp - part)**power
        end if
    end function complement

    !> Stick radius and width of the annulus of slip at x = ln(a^2/c^2 - 1).
    pure subroutine annulus(a, x, c, width)
        real(wp), intent(in) :: a, x
        real(wp), intent(out) :: c, width
        real(wp) :: slipping, root

        slipping = exp(x)
        root = sqrt(1.0_wp + slipping)
        c = a/root
        width = a*(slipping/(root*(1.0_wp + root)))
    end subroutine annulus

    function shear_value(self, x) result(y)
        class(shear_equation_t), intent(inout) :: self
        real(wp), intent(in) :: x
        real(wp) :: y
        real(wp) :: c, width, shift, force, stiffness, rate

        call annulus(self%slip%radius, x, c, width)
        c = max(c, self%slip%smallest_stick, tiny(1.0_wp))
        call self%slip%at(c, width, shift, force, stiffness, rate, self%error)
        y = 0.0_wp
        if (allocated(self%error)) return
        if (.not. (shift > 0.0_wp .and. force > 0.0_wp)) then
            y = least - x
            return
        end if
        ! dc/dx = -c (a^2 - c^2)/(2 a^2)
        rate = 0.5_wp*rate*c*(width/self%slip%radius)*(1.0_wp + c/self%slip%radius)
        if (self%of_force) then
            y = log(force/self%target)
            self%known_slope = rate*stiffness/force
        else
            y = log(shift/self%target)
            self%known_slope = rate/shift
        end if
    end function shear_value

    !> q_t(x), the line load of the springs under shear [modulus length].
    subroutine line_load(self, state, x, values, error)
        class(first_shear_t), intent(in) :: self
        type(tangential_state_t), intent(in) :: state
        !> 0 <= x <= a [length]
        real(wp), intent(in) :: x(:)
        !> (size(x))
        real(wp), intent(out) :: values(:)
        type(error_t), allocatable, intent(out) :: error

        call check_made(error, "shear", self%is_made)
        if (allocated(error)) return
        call check_inside(self, state, "x", x, error)
        if (.not. allocated(error)) call self%slip%line_load(min(state%stick_radius, self%radius), x, values, error)
        if (.not. allocated(error)) values = load_factor(self, state)*values
    end subroutine line_load

    !> tau(r), the shear traction on the surface, of one direction or around the axis [modulus].
    subroutine traction(self, state, r, values, error)
        class(first_shear_t), intent(in) :: self
        type(tangential_state_t), intent(in) :: state
        !> 0 <= r <= a [length]
        real(wp), intent(in) :: r(:)
        !> (size(r))
        real(wp), intent(out) :: values(:)
        type(error_t), allocatable, intent(out) :: error

        call check_made(error, "shear", self%is_made)
        if (allocated(error)) return
        call check_inside(self, state, "r", r, error)
        if (.not. allocated(error)) call self%slip%traction(min(state%stick_radius, self%radius), r, values, error)
        if (.not. allocated(error)) values = load_factor(self, state)*values
    end subroutine traction

    !> The sign of the shear times the coefficient; where nothing slips yet the load is proportionally to the shift.
    pure function load_factor(self, state) result(factor)
        type(first_shear_t), intent(in) :: self
        type(tangential_state_t), intent(in) :: state
        real(wp) :: factor
        real(wp) :: first

        factor = sign(self%coefficient, state%shift)
        first = self%coefficient*self%slip%first_shift
        if (abs(state%shift) < first) factor = self%coefficient*state%shift/first
        if (state%shift == 0.0_wp) factor = 0.0_wp
    end function load_factor

    pure subroutine check_inside(self, state, name, positions, error)
        type(first_shear_t), intent(in) :: self
        type(tangential_state_t), intent(in) :: state
        character(len=*), intent(in) :: name
        real(wp), intent(in) :: positions(:)
        type(error_t), allocatable, intent(inout) :: error

        call check_finite(error, ways(self%way)//" of the "//trim(states(self%way)), state%shift)
        call check_not_negative(error, "stick_radius of the "//trim(states(self%way)), state%stick_radius)
        call check_positions(error, name, positions, self%radius)
    end subroutine check_inside

end module mdrcontact_friction_partial_slip
