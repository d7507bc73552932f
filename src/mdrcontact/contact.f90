! SPDX-License-Identifier: GPL-3.0-or-later
!> The contact of an indenter with a medium: states from depth, force or radius, and their fields (theory 2 and 4).
module mdrcontact_contact
    use, intrinsic :: ieee_arithmetic, only: ieee_is_finite
    use mdrcontact_error, only: check_finite, check_not_negative, error_domain, error_invalid, error_no_convergence, error_t, &
                                error_unreachable, raise, to_text
    use mdrcontact_gsl, only: disable_gsl_abort
    use mdrcontact_kinds, only: wp
    use mdrcontact_medium, only: medium_t
    use mdrcontact_medium_effective, only: effective_medium_t
    use mdrcontact_profile, only: profile_t
    use mdrcontact_radius_law, only: radius_law_t
    use mdrcontact_roots, only: solve_increasing
    use mdrcontact_scalar_function, only: scalar_function_t
    implicit none (type, external)
    private
    public :: contact_t, contact_state_t, new_contact

    !> One state of a contact.
    type :: contact_state_t
        !> a [length]
        real(wp) :: radius = 0.0_wp
        !> d, positive into the medium [length]
        real(wp) :: depth = 0.0_wp
        !> F, positive in compression [modulus length^2]
        real(wp) :: force = 0.0_wp
        !> k = dF/dd at constant radius = 2 a E_eff(a) [modulus length]
        real(wp) :: stiffness = 0.0_wp
        !> depth beyond that of first touch at this radius [length]: 0 but at a vertical wall of the indenter
        real(wp) :: excess = 0.0_wp
    end type contact_state_t

    !> An indenter on a medium. It holds copies of both and never changes; any number of threads may share it.
    type :: contact_t
        private
        class(profile_t), allocatable :: profile
        class(medium_t), allocatable :: medium
        !> the largest contact radius at which all parts are defined [length]
        real(wp) :: last_radius = 0.0_wp
    contains
        procedure :: at_radius
        procedure :: at_depth
        procedure :: at_force
        procedure :: line_load
        procedure :: pressure
        procedure :: displacement
    end type contact_t

    !> ln(d/target) or ln(F/target) as a function of ln(a - end radius): close to linear for every shape and medium.
    type, extends(scalar_function_t) :: mismatch_t
        type(contact_t), pointer :: contact => null()
        real(wp) :: target_value = 0.0_wp
        logical :: of_force = .false.
    contains
        procedure :: value => mismatch_value
    end type mismatch_t

    !> ln of the smallest contact radius searched: its cube is still a normal number.
    real(wp), parameter :: smallest_log = -230.0_wp

contains

    !> A contact of `profile` with `medium`.
    subroutine new_contact(self, profile, medium, error, zeta)
        type(contact_t), intent(out) :: self
        class(profile_t), intent(in) :: profile
        class(medium_t), intent(in) :: medium
        type(error_t), allocatable, intent(out) :: error
        !> zeta(a) of (9), d = zeta(a) g(a), for a medium with an effective modulus; the source's zeta = 1 if absent
        type(radius_law_t), intent(in), optional :: zeta

        call disable_gsl_abort()
        if (profile%end_radius() > medium%largest_radius()) then
            call raise(error, error_domain, "the indenter's flat end, radius "//to_text(profile%end_radius())// &
                       ", is larger than the largest contact radius of the medium, "//to_text(medium%largest_radius()))
            return
        end if
        allocate (self%profile, source=profile)
        allocate (self%medium, source=medium)
        ! A hair below the profile's end, which may be a vertical tangent; far below the end of the number range.
        self%last_radius = min(profile%largest_radius()*(1.0_wp - epsilon(1.0_wp)), medium%largest_radius(), 1.0e100_wp)
        if (present(zeta)) call set_zeta(self, zeta, error)
    end subroutine new_contact

    subroutine set_zeta(self, zeta, error)
        type(contact_t), intent(inout) :: self
        type(radius_law_t), intent(in) :: zeta
        type(error_t), allocatable, intent(out) :: error
        real(wp), allocatable :: radii(:), depths(:)
        integer :: i

        select type (medium => self%medium)
        class is (effective_medium_t)
            medium%zeta = zeta
            self%last_radius = min(self%last_radius, zeta%largest_radius())
        class default
            call raise(error, error_invalid, "zeta is not allowed: this medium determines its depth exactly")
            return
        end select
        radii = pack(zeta%break_radii(), zeta%break_radii() <= self%profile%largest_radius())
        depths = zeta%at(radii)*self%profile%mdr(radii)
        do i = 2, size(radii)
            if (depths(i) < depths(i - 1)) then
                call raise(error, error_invalid, "zeta is not allowed: the depth zeta(a) g(a) decreases between a = "// &
                           to_text(radii(i - 1))//" and a = "//to_text(radii(i)))
                return
            end if
        end do
    end subroutine set_zeta

    !> The state at contact radius a.
    subroutine at_radius(self, radius, state, error)
        class(contact_t), intent(in) :: self
        !> a: at least the radius of the indenter's flat end, at most where indenter and medium are defined; 0 is first touch
        real(wp), intent(in) :: radius
        type(contact_state_t), intent(out) :: state
        type(error_t), allocatable, intent(out) :: error

        call check_not_negative(error, "radius", radius)
        if (allocated(error)) return
        if (radius < self%profile%end_radius()) then
            call raise(error, error_unreachable, "radius = "//to_text(radius)//" cannot be reached: the indenter's flat end "// &
                       "makes contact at radius "//to_text(self%profile%end_radius())//" at once")
        else if (self%profile%has_wall() .and. radius >= self%profile%largest_radius()) then
            call raise(error, error_unreachable, "radius = "//to_text(radius)//" does not determine a state: at the indenter's "// &
                       "vertical wall, radius "//to_text(self%profile%largest_radius())//", the depth is free; give depth or force")
        else if (radius > self%last_radius) then
            call raise(error, error_domain, "radius = "//to_text(radius)//" is not allowed: indenter and medium are "// &
                       "defined up to "//to_text(self%last_radius))
        else if (radius < self%medium%smallest_radius()) then
            call raise(error, error_domain, "radius = "//to_text(radius)//" is not allowed: the medium is defined from "// &
                       to_text(self%medium%smallest_radius())//" on")
        end if
        if (allocated(error)) return
        call state_at(self, radius, state, error)
    end subroutine at_radius

    !> The state at indentation depth d.
    subroutine at_depth(self, depth, state, error)
        class(contact_t), intent(in), target :: self
        !> d >= 0 [length]
        real(wp), intent(in) :: depth
        type(contact_state_t), intent(out) :: state
        type(error_t), allocatable, intent(out) :: error

        call check_finite(error, "depth", depth)
        if (allocated(error)) return
        if (depth < 0.0_wp) then
            call raise(error, error_unreachable, "depth = "//to_text(depth)//" cannot be reached: the bodies "// &
                       "are apart below depth 0")
            return
        end if
        call invert(self, depth, .false., state, error)
        if (.not. allocated(error)) state%depth = depth
    end subroutine at_depth

    !> The state under normal force F.
    subroutine at_force(self, force, state, error)
        class(contact_t), intent(in), target :: self
        !> F >= 0 [modulus length^2]
        real(wp), intent(in) :: force
        type(contact_state_t), intent(out) :: state
        type(error_t), allocatable, intent(out) :: error

        call check_finite(error, "force", force)
        if (allocated(error)) return
        if (force < 0.0_wp) then
            call raise(error, error_unreachable, "force = "//to_text(force)//" cannot be reached: without adhesion the bodies "// &
                       "do not pull on each other")
            return
        end if
        call invert(self, force, .true., state, error)
        if (.not. allocated(error)) state%force = force
    end subroutine at_force

    !> q(x), the line load of the one-dimensional springs, equation (5) or (21) [modulus length].
    subroutine line_load(self, state, x, values, error)
        class(contact_t), intent(in) :: self
        type(contact_state_t), intent(in) :: state
        !> positions 0 <= x <= a [length]
        real(wp), intent(in) :: x(:)
        !> same size as x
        real(wp), intent(out) :: values(:)
        type(error_t), allocatable, intent(out) :: error

        call check_positions(state, "x", x, state%radius, error)
        if (allocated(error)) return
        call self%medium%line_load(self%profile, state%radius, state%excess, x, values, error)
    end subroutine line_load

    !> p(r), the contact pressure, equation (6) [modulus]. Infinite where theory says so: at the edge of a flat punch, at the
    !> apex of a cone.
    subroutine pressure(self, state, r, values, error)
        class(contact_t), intent(in) :: self
        type(contact_state_t), intent(in) :: state
        !> positions 0 <= r <= a [length]
        real(wp), intent(in) :: r(:)
        !> same size as r
        real(wp), intent(out) :: values(:)
        type(error_t), allocatable, intent(out) :: error

        call check_positions(state, "r", r, state%radius, error)
        if (allocated(error)) return
        call self%medium%pressure(self%profile, state%radius, state%excess, r, values, error)
    end subroutine pressure

    !> u(r), the displacement of the surface, positive into the medium [length]: d - f(r) inside the contact, the free surface
    !> outside.
    subroutine displacement(self, state, r, values, error)
        class(contact_t), intent(in) :: self
        type(contact_state_t), intent(in) :: state
        !> positions r >= 0 [length]
        real(wp), intent(in) :: r(:)
        !> same size as r
        real(wp), intent(out) :: values(:)
        type(error_t), allocatable, intent(out) :: error
        real(wp), allocatable :: outside(:)

        call check_positions(state, "r", r, huge(1.0_wp), error)
        if (allocated(error)) return
        allocate (outside(count(r > state%radius)))
        call self%medium%displacement_outside(self%profile, state%radius, state%excess, pack(r, r > state%radius), outside, error)
        if (allocated(error)) return
        values = unpack(outside, r > state%radius, state%depth - self%profile%height(min(r, state%radius)))
    end subroutine displacement

    !> Depth, force and stiffness at a radius that has been checked.
    subroutine state_at(self, radius, state, error)
        class(contact_t), intent(in) :: self
        real(wp), intent(in) :: radius
        type(contact_state_t), intent(out) :: state
        type(error_t), allocatable, intent(out) :: error
        real(wp) :: modulus(1)

        if (radius <= 0.0_wp) return
        state%radius = radius
        call self%medium%depth_and_force(self%profile, radius, state%depth, state%force, error)
        if (allocated(error)) return
        call self%medium%modulus([radius], modulus, error)
        if (allocated(error)) return
        state%stiffness = 2.0_wp*radius*modulus(1)
        if (.not. (ieee_is_finite(state%depth) .and. ieee_is_finite(state%force) .and. ieee_is_finite(state%stiffness))) then
            call raise(error, error_no_convergence, "the state at radius = "//to_text(radius)// &
                       " is beyond the range of floating-point numbers")
        end if
    end subroutine state_at

    !> The state with a given depth or force, both of which grow with the contact radius.
    subroutine invert(self, wanted, of_force, state, error)
        class(contact_t), intent(in), target :: self
        real(wp), intent(in) :: wanted
        logical, intent(in) :: of_force
        type(contact_state_t), intent(out) :: state
        type(error_t), allocatable, intent(out) :: error
        real(wp) :: closest
        logical :: found

        call state_at(self, self%profile%end_radius(), state, error)
        if (wanted <= 0.0_wp .or. allocated(error)) return
        if (self%profile%has_wall()) then
            call state_at(self, self%profile%largest_radius(), state, error)
            if (allocated(error)) return
            if (wanted >= merge(state%force, state%depth, of_force)) then
                call push_beyond_wall(state, wanted, of_force)
                return
            end if
        end if
        call radius_of(self, wanted, of_force, closest, found, error)
        if (allocated(error)) return
        call state_at(self, closest, state, error)
        if (allocated(error) .or. found) return
        call raise_unreachable(state, wanted, of_force, error)
    end subroutine invert

    !> At a vertical wall the radius stays and the indenter goes on as a flat punch.
    pure subroutine push_beyond_wall(state, wanted, of_force)
        type(contact_state_t), intent(inout) :: state
        real(wp), intent(in) :: wanted
        logical, intent(in) :: of_force

        if (of_force) then
            state%excess = (wanted - state%force)/state%stiffness
        else
            state%excess = wanted - state%depth
        end if
        state%depth = state%depth + state%excess
        state%force = state%force + state%stiffness*state%excess
    end subroutine push_beyond_wall

    subroutine radius_of(self, wanted, of_force, radius, found, error)
        class(contact_t), intent(in), target :: self
        real(wp), intent(in) :: wanted
        logical, intent(in) :: of_force
        real(wp), intent(out) :: radius
        logical, intent(out) :: found
        type(error_t), allocatable, intent(out) :: error
        type(mismatch_t) :: mismatch
        real(wp) :: first, last, guess, root

        mismatch%contact => self
        mismatch%target_value = wanted
        mismatch%of_force = of_force
        first = smallest_log
        if (self%medium%smallest_radius() > self%profile%end_radius()) first = &
            log(self%medium%smallest_radius() - self%profile%end_radius())
        last = log(self%last_radius - self%profile%end_radius())
        guess = 0.0_wp
        if (.not. of_force) then
            radius = self%profile%radius_from_mdr(wanted)
            if (radius > self%profile%end_radius()) guess = log(radius - self%profile%end_radius())
        end if
        call solve_increasing(mismatch, guess, 2.0_wp, first, last, root, found, error)
        radius = min(self%profile%end_radius() + exp(root), self%last_radius)
    end subroutine radius_of

    function mismatch_value(self, x) result(y)
        class(mismatch_t), intent(inout) :: self
        real(wp), intent(in) :: x
        real(wp) :: y
        type(contact_state_t) :: state
        real(wp) :: value

        y = 0.0_wp
        call first_touch(min(self%contact%profile%end_radius() + exp(x), self%contact%last_radius))
        if (allocated(self%error)) return
        value = merge(state%force, state%depth, self%of_force)
        if (value > tiny(value)) then
            y = log(value/self%target_value)
        else
            y = log(tiny(value)/self%target_value)
        end if

    contains

        subroutine first_touch(radius)
            real(wp), intent(in) :: radius

            call self%contact%medium%depth_and_force(self%contact%profile, radius, state%depth, state%force, self%error)
        end subroutine first_touch

    end function mismatch_value

    pure subroutine raise_unreachable(state, wanted, of_force, error)
        type(contact_state_t), intent(in) :: state
        real(wp), intent(in) :: wanted
        logical, intent(in) :: of_force
        type(error_t), allocatable, intent(inout) :: error
        character(len=:), allocatable :: name
        real(wp) :: last

        if (of_force) then
            name = "force"
            last = state%force
        else
            name = "depth"
            last = state%depth
        end if
        call raise(error, error_unreachable, name//" = "//to_text(wanted)//" cannot be reached: at radius "// &
                   to_text(state%radius)//", where the indenter or the medium ends, the "//name//" is "//to_text(last))
    end subroutine raise_unreachable

    pure subroutine check_positions(state, name, positions, largest, error)
        type(contact_state_t), intent(in) :: state
        character(len=*), intent(in) :: name
        real(wp), intent(in) :: positions(:), largest
        type(error_t), allocatable, intent(out) :: error
        integer :: i

        if (.not. state%radius > 0.0_wp) then
            call raise(error, error_invalid, "the contact radius of the state must be greater than 0: there is no contact")
            return
        end if
        do i = 1, size(positions)
            call check_not_negative(error, name, positions(i))
            if (allocated(error)) return
            if (positions(i) > largest) then
                call raise(error, error_domain, name//" = "//to_text(positions(i))//" is not allowed: it must be at most the "// &
                           "contact radius, "//to_text(largest))
                return
            end if
        end do
    end subroutine check_positions

end module mdrcontact_contact
