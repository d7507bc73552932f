! SPDX-License-Identifier: GPL-3.0-or-later
!> The contact of an indenter with a medium: states from depth, force or radius, and their fields (theory 2, 4, 5).
module mdrcontact_contact
    use mdrcontact_body, only: body_t
    use mdrcontact_body_layers, only: layers_t
    use mdrcontact_contact_branch, only: branch_t, new_branch, stable_segment_t
    use mdrcontact_contact_control, only: control_t, depth_control, force_control
    use mdrcontact_contact_state, only: contact_state_t
    use mdrcontact_contact_equilibrium, only: adhesion_automatic, adhesion_energy, adhesion_paper, equilibrium_t, &
                                              new_equilibrium
    use mdrcontact_contact_exact_zeta, only: exact_zeta
    use mdrcontact_error, only: check_choice, check_finite, check_not_negative, error_domain, error_invalid, error_t, &
                                error_unreachable, raise, to_text
    use mdrcontact_field_body_field, only: body_field
    use mdrcontact_field_energy, only: layer_energies
    use mdrcontact_field_load, only: load_t
    use mdrcontact_gsl, only: disable_gsl_abort
    use mdrcontact_contact_inversion, only: invert, neighbours_t
    use mdrcontact_kinds, only: wp
    use mdrcontact_medium, only: medium_t
    use mdrcontact_profile, only: profile_t
    use mdrcontact_numerics_radius_law, only: radius_law_t
    implicit none (type, external)
    private
    public :: contact_t, new_contact, contact_options_t
    public :: on_loading, on_unloading, check_branch

    !> Which stable state is meant where an adhesive contact has several: the one met when the bodies approach, or
    !> the one kept when they are drawn apart.
    integer, parameter :: on_loading = 1, on_unloading = 2

    !> What a contact can have beyond indenter and medium.
    type :: contact_options_t
        !> gamma >= 0 [modulus length]
        real(wp) :: work_of_adhesion = 0.0_wp
        !> adhesion_automatic, adhesion_paper or adhesion_energy
        integer :: adhesion_rule = adhesion_automatic
        !> zeta(a) of (9), d = zeta(a) g(a), for a medium with an effective modulus; the source's zeta = 1 if not allocated
        type(radius_law_t), allocatable :: zeta
        !> whether zeta is that of the same body solved exactly, for radii up to 1000 thicknesses, instead of a given one
        logical :: zeta_is_exact = .false.
    end type contact_options_t

    !> Where the lowest pressure is looked for: so many radii, and again as many between the neighbours of the lowest.
    integer, parameter :: pressure_probes = 32, pressure_rounds = 3

    !> An indenter on a medium. It holds copies of both and never changes; any number of threads may share it.
    type :: contact_t
        !> what determines a state once the radius is known; to be read only
        type(equilibrium_t) :: equilibrium
        !> the adhesive branch; not allocated without adhesion
        type(branch_t), allocatable, private :: branch
    contains
        procedure :: at_radius
        procedure :: at_depth
        procedure :: at_force
        procedure :: at_control
        procedure :: pull_off
        procedure :: stable_segments
        procedure :: state_on_segment
        procedure :: work_between
        procedure :: is_adhesive
        procedure :: is_formula
        procedure :: radius_range
        procedure :: line_load
        procedure :: pressure
        procedure :: displacement
        procedure :: elastic_energy
        procedure :: lowest_pressure
        procedure :: interior
        procedure :: layer_energy
    end type contact_t

contains

    !> A contact of `profile` with `medium`.
    subroutine new_contact(self, profile, medium, error, options)
        type(contact_t), intent(out) :: self
        !> copied
        class(profile_t), intent(in) :: profile
        !> copied
        class(medium_t), intent(in) :: medium
        type(error_t), allocatable, intent(out) :: error
        !> without it: no adhesion, zeta = 1
        type(contact_options_t), intent(in), optional :: options
        type(radius_law_t), allocatable :: zeta

        call disable_gsl_abort()
        if (.not. present(options)) then
            call new_equilibrium(self%equilibrium, profile, medium, error)
            return
        end if
        if (options%zeta_is_exact) then
            call exact_zeta(profile, medium, zeta, error)
        else if (allocated(options%zeta)) then
            zeta = options%zeta
        end if
        if (.not. allocated(error)) call new_equilibrium(self%equilibrium, profile, medium, error, zeta)
        if (.not. allocated(error)) call set_adhesion(self, options%work_of_adhesion, options%adhesion_rule, error)
    end subroutine new_contact

    subroutine set_adhesion(self, work_of_adhesion, rule, error)
        type(contact_t), intent(inout) :: self
        real(wp), intent(in) :: work_of_adhesion
        integer, intent(in) :: rule
        type(error_t), allocatable, intent(out) :: error

        call check_not_negative(error, "work_of_adhesion", work_of_adhesion)
        call check_choice(error, "adhesion_rule", rule, adhesion_automatic, adhesion_energy, &
                          "0 (automatic), 1 (paper) or 2 (energy)")
        if (.not. allocated(error) .and. work_of_adhesion > 0.0_wp .and. self%equilibrium%medium%is_viscoelastic()) then
            call raise(error, error_invalid, " = "//to_text(work_of_adhesion)//" is not allowed with a viscoelastic body: how "// &
                       "much its edge holds depends on how fast it moves, on a scale that this theory does not have", &
                       "work_of_adhesion")
        end if
        if (allocated(error) .or. work_of_adhesion <= 0.0_wp) return
        self%equilibrium%work_of_adhesion = work_of_adhesion
        self%equilibrium%rule = rule
        allocate (self%branch)
        call new_branch(self%branch, self%equilibrium, error)
    end subroutine set_adhesion

    !> Whether the work of adhesion is greater than 0.
    pure function is_adhesive(self) result(answer)
        class(contact_t), intent(in) :: self
        logical :: answer

        answer = allocated(self%branch)
    end function is_adhesive

    !> Whether a state is a formula and costs less than to start a thread for it.
    pure function is_formula(self) result(answer)
        class(contact_t), intent(in) :: self
        logical :: answer

        answer = self%equilibrium%is_formula .and. .not. self%is_adhesive()
    end function is_formula

    !> Between which contact radii the contact is defined, and where it is not analytic in between.
    subroutine radius_range(self, end_radius, smallest, largest, breaks)
        class(contact_t), intent(in) :: self
        !> radius of the indenter's flat end, 0 if there is none [length]
        real(wp), intent(out) :: end_radius
        !> smallest and largest contact radius at which there is a state [length]; equal for a flat punch
        real(wp), intent(out) :: smallest, largest
        !> radii where indenter or medium are not analytic, ascending [length]
        real(wp), allocatable, intent(out) :: breaks(:)

        end_radius = self%equilibrium%profile%end_radius()
        smallest = max(end_radius, self%equilibrium%medium%smallest_radius())
        largest = max(smallest, self%equilibrium%last_radius)
        breaks = self%equilibrium%breaks()
        breaks = pack(breaks, breaks > smallest .and. breaks < largest)
    end subroutine radius_range

    !> The state of equilibrium at contact radius a, stable or not.
    subroutine at_radius(self, radius, state, error)
        class(contact_t), intent(in) :: self
        !> a: at least the radius of the indenter's flat end, at most where indenter and medium are defined; 0 is first touch
        real(wp), intent(in) :: radius
        type(contact_state_t), intent(out) :: state
        type(error_t), allocatable, intent(out) :: error
        real(wp) :: end_radius, wall_radius, smallest

        call check_not_negative(error, "radius", radius)
        if (allocated(error)) return
        end_radius = self%equilibrium%profile%end_radius()
        wall_radius = self%equilibrium%profile%largest_radius()
        smallest = self%equilibrium%medium%smallest_radius()
        if (radius < end_radius) then
            call raise(error, error_unreachable, " = "//to_text(radius)//" cannot be reached: the indenter's flat end "// &
                       "makes contact at radius "//to_text(end_radius)//" at once", "radius")
        else if (self%equilibrium%profile%has_wall() .and. radius >= wall_radius) then
            call raise(error, error_unreachable, " = "//to_text(radius)//" does not determine a state: at the indenter's "// &
                       "vertical wall, radius "//to_text(wall_radius)//", the depth is free; give depth or force", "radius")
        else if (radius > self%equilibrium%last_radius) then
            call raise(error, error_domain, " = "//to_text(radius)//" is not allowed: indenter and medium are defined up to "// &
                       to_text(self%equilibrium%last_radius)//trim(self%equilibrium%why_it_ends()), "radius")
        else if (radius < smallest) then
            call raise(error, error_domain, " = "//to_text(radius)//" is not allowed: the medium is defined from "// &
                       to_text(smallest)//" on", "radius")
        end if
        if (allocated(error)) return
        call self%equilibrium%at(radius, state, error)
    end subroutine at_radius

    !> The stable state at indentation depth d.
    subroutine at_depth(self, depth, state, error, branch, neighbours)
        class(contact_t), intent(in), target :: self
        !> d >= 0, or with adhesion down to the pull-off depth on unloading [length]
        real(wp), intent(in) :: depth
        type(contact_state_t), intent(out) :: state
        type(error_t), allocatable, intent(out) :: error
        !> on_loading or on_unloading (default)
        integer, intent(in), optional :: branch
        !> states found last, which may save most of the work without adhesion
        type(neighbours_t), intent(inout), optional :: neighbours

        call self%at_control(depth_control, "depth", depth, state, error, branch, neighbours)
        if (.not. allocated(error)) state%depth = depth
    end subroutine at_depth

    !> The stable state under normal force F.
    subroutine at_force(self, force, state, error, branch, neighbours)
        class(contact_t), intent(in), target :: self
        !> F >= 0, or with adhesion down to the pull-off force on unloading [modulus length^2]
        real(wp), intent(in) :: force
        type(contact_state_t), intent(out) :: state
        type(error_t), allocatable, intent(out) :: error
        !> on_loading or on_unloading (default)
        integer, intent(in), optional :: branch
        !> states found last, which may save most of the work without adhesion
        type(neighbours_t), intent(inout), optional :: neighbours

        call self%at_control(force_control, "force", force, state, error, branch, neighbours)
        if (.not. allocated(error)) state%force = force
    end subroutine at_force

    !> Raises unless `branch` is on_loading or on_unloading.
    pure subroutine check_branch(error, branch)
        type(error_t), allocatable, intent(inout) :: error
        integer, intent(in) :: branch

        call check_choice(error, "branch", branch, on_loading, on_unloading, "1 (loading) or 2 (unloading)")
    end subroutine check_branch

    !> The stable state at a given value s of what a machine controls: depth, force, or the far end of a spring.
    subroutine at_control(self, control, name, s, state, error, branch, neighbours)
        class(contact_t), intent(in), target :: self
        type(control_t), intent(in) :: control
        !> what s is called in error messages
        character(len=*), intent(in) :: name
        !> value of what is controlled, in its unit: [length] or [modulus length^2]
        real(wp), intent(in) :: s
        type(contact_state_t), intent(out) :: state
        type(error_t), allocatable, intent(out) :: error
        !> on_loading or on_unloading (default)
        integer, intent(in), optional :: branch
        !> states found last, which may save most of the work without adhesion
        type(neighbours_t), intent(inout), optional :: neighbours
        integer :: way

        way = on_unloading
        if (present(branch)) way = branch
        call check_branch(error, way)
        call check_finite(error, name, s)
        if (allocated(error)) return
        if (self%is_adhesive()) then
            call adhesive_state(self, control, name, s, way, state, error)
        else if (s < 0.0_wp) then
            call raise(error, error_unreachable, " = "//to_text(s)//" cannot be reached: without adhesion the bodies are apart "// &
                       "below "//name//" 0 and do not pull on each other", name)
        else
            call invert(self%equilibrium, control, name, s, state, error, neighbours)
        end if
    end subroutine at_control

    !> Where the contact breaks: the state of lowest depth or force on the whole branch, and the other local minima.
    subroutine pull_off(self, control, state, error, others)
        class(contact_t), intent(in) :: self
        !> depth_control, force_control, or a spring in between
        type(control_t), intent(in) :: control
        !> all zero without adhesion
        type(contact_state_t), intent(out) :: state
        type(error_t), allocatable, intent(out) :: error
        !> ends of the other stable segments, in ascending order of the radius
        type(contact_state_t), allocatable, intent(out), optional :: others(:)
        type(stable_segment_t), allocatable :: list(:)
        type(contact_state_t), allocatable :: ends(:)
        real(wp) :: smallest
        integer :: i, global

        if (present(others)) allocate (others(0))
        if (.not. self%is_adhesive()) return
        call self%stable_segments(control, list, error)
        if (allocated(error)) return
        if (size(list) == 0) then
            call raise(error, error_unreachable, "this contact has no stable adhesive state under the control asked for")
            return
        end if
        allocate (ends(size(list)))
        do i = 1, size(list)
            call self%state_on_segment(control, list(i), list(i)%lowest, ends(i), error)
            if (allocated(error)) return
        end do
        global = minloc(list%lowest, dim=1)
        smallest = self%equilibrium%medium%smallest_radius()
        if (smallest > self%equilibrium%profile%end_radius() .and. ends(global)%radius <= smallest*(1.0_wp + 1.0e-12_wp)) then
            call raise(error, error_domain, "the contact does not break at radii for which the medium is defined, from "// &
                       to_text(smallest)//" on: it is still stable there")
            return
        end if
        state = ends(global)
        if (present(others)) others = [ends(:global - 1), ends(global + 1:)]
    end subroutine pull_off

    !> The stable segments of the adhesive branch under a control, by ascending radius.
    subroutine stable_segments(self, control, list, error)
        class(contact_t), intent(in) :: self
        type(control_t), intent(in) :: control
        type(stable_segment_t), allocatable, intent(out) :: list(:)
        type(error_t), allocatable, intent(out) :: error

        if (allocated(self%branch)) then
            call self%branch%stable_segments(self%equilibrium, control, list, error)
        else
            allocate (list(0))
        end if
    end subroutine stable_segments

    !> The state with a given value of the controlled quantity on one of the stable segments.
    subroutine state_on_segment(self, control, segment, s, state, error)
        class(contact_t), intent(in) :: self
        type(control_t), intent(in) :: control
        type(stable_segment_t), intent(in) :: segment
        !> between the lowest and the highest value of the segment
        real(wp), intent(in) :: s
        type(contact_state_t), intent(out) :: state
        type(error_t), allocatable, intent(out) :: error

        call self%branch%state_on(self%equilibrium, control, segment, s, state, error)
    end subroutine state_on_segment

    !> int F dd along the adhesive branch between two of its states; at a vertical wall the depth alone changes.
    function work_between(self, from, to) result(work)
        class(contact_t), intent(in) :: self
        type(contact_state_t), intent(in) :: from, to
        real(wp) :: work

        if (self%equilibrium%profile%has_wall() .and. from%radius >= self%equilibrium%last_radius &
            .and. to%radius >= self%equilibrium%last_radius) then
            work = 0.5_wp*(from%force + to%force)*(to%depth - from%depth)
        else
            work = self%branch%work_between(self%equilibrium%coordinate_of(from%radius), &
                                            self%equilibrium%coordinate_of(to%radius))
        end if
    end function work_between

    !> q(x), the line load of the one-dimensional springs, equation (5) or (21) [modulus length].
    subroutine line_load(self, state, x, values, error)
        class(contact_t), intent(in) :: self
        type(contact_state_t), intent(in) :: state
        !> positions 0 <= x <= a [length]
        real(wp), intent(in) :: x(:)
        !> same size as x
        real(wp), intent(out) :: values(:)
        type(error_t), allocatable, intent(out) :: error

        call check_positions(self, state, "x", x, state%radius, error)
        if (allocated(error)) return
        call self%equilibrium%medium%line_load(self%equilibrium%profile, state%radius, state%excess, x, values, error)
    end subroutine line_load

    !> p(r), the contact pressure, equation (6) [modulus]. Infinite where theory says so: at the edge of a flat punch, at the
    !> apex of a cone; minus infinity at an adhesive edge.
    subroutine pressure(self, state, r, values, error)
        class(contact_t), intent(in) :: self
        type(contact_state_t), intent(in) :: state
        !> positions 0 <= r <= a [length]
        real(wp), intent(in) :: r(:)
        !> same size as r
        real(wp), intent(out) :: values(:)
        type(error_t), allocatable, intent(out) :: error

        call check_positions(self, state, "r", r, state%radius, error)
        if (allocated(error)) return
        call self%equilibrium%medium%pressure(self%equilibrium%profile, state%radius, state%excess, r, values, error)
    end subroutine pressure

    !> u(r), the displacement of the surface, positive into the medium [length]: d - f(r) inside the contact, the free surface
    !> outside. Of two deformable bodies that of both surfaces together, each positive into its body, or of one of them.
    subroutine displacement(self, state, r, values, error, body)
        class(contact_t), intent(in) :: self
        type(contact_state_t), intent(in) :: state
        !> positions r >= 0 [length]
        real(wp), intent(in) :: r(:)
        !> same size as r
        real(wp), intent(out) :: values(:)
        type(error_t), allocatable, intent(out) :: error
        !> lower_body or upper_body; without it both together
        integer, intent(in), optional :: body
        real(wp), allocatable :: outside(:)

        call check_positions(self, state, "r", r, huge(1.0_wp), error)
        if (allocated(error)) return
        allocate (outside(count(r > state%radius)))
        call self%equilibrium%medium%displacement_outside(self%equilibrium%profile, state%radius, state%excess, &
                                                          pack(r, r > state%radius), outside, error)
        if (allocated(error)) return
        values = unpack(outside, r > state%radius, state%depth - self%equilibrium%profile%height(min(r, state%radius)))
        if (.not. present(body)) return
        call self%equilibrium%medium%take_share(self%equilibrium%profile, state%radius, state%excess, body, r, values, error)
    end subroutine displacement

    !> Elastic energy of the lower and of the upper body; without adhesion together int F dd from first touch.
    subroutine elastic_energy(self, state, values, error)
        class(contact_t), intent(in) :: self
        type(contact_state_t), intent(in) :: state
        !> of the lower and of the upper body [modulus length^3]
        real(wp), intent(out) :: values(2)
        type(error_t), allocatable, intent(out) :: error

        values = 0.0_wp
        call check_positions(self, state, "r", [real(wp) ::], 0.0_wp, error)
        if (allocated(error)) return
        call self%equilibrium%medium%energies(self%equilibrium%profile, state%radius, state%excess, values, error)
    end subroutine elastic_energy

    !> The lowest pressure in a contact without adhesion. Below 0 the bodies would have to pull on each other: the contact is then
    !> not one disc, its pressure is not that of the true contact, and F(d) is a little off (theory 6). On stiff coatings only.
    subroutine lowest_pressure(self, state, pressure, radius, error)
        class(contact_t), intent(in) :: self
        !> a state of this contact, a > 0, without adhesion
        type(contact_state_t), intent(in) :: state
        !> the smallest p(r), 0 <= r <= a, and the r that has it: 0 at the edge where no pressure is negative [modulus], [length]
        real(wp), intent(out) :: pressure, radius
        type(error_t), allocatable, intent(out) :: error
        real(wp) :: from, to, r(pressure_probes), values(pressure_probes)
        integer :: round, i

        pressure = 0.0_wp
        radius = state%radius
        if (self%is_adhesive()) then
            call raise(error, error_invalid, "lowest_pressure is not allowed: under adhesion the pressure is "// &
                       "minus infinity at the edge")
            return
        end if
        from = 0.0_wp
        to = state%radius
        do round = 1, pressure_rounds
            ! The edge is left out: p is 0 or infinite there.
            r = [(from + (to - from)*(i - 1)/pressure_probes, i=1, pressure_probes)]
            call self%pressure(state, r, values, error)
            if (allocated(error)) return
            i = minloc(values, dim=1)
            if (.not. values(i) < pressure) return
            pressure = values(i)
            radius = r(i)
            from = r(max(i - 1, 1))
            to = min(r(i) + (r(2) - r(1)), state%radius)
        end do
    end subroutine lowest_pressure

    !> The stable adhesive state with a given s, on loading (the smallest contact that the approach meets) or on unloading
    !> (the largest).
    subroutine adhesive_state(self, control, name, s, way, state, error)
        type(contact_t), intent(in) :: self
        type(control_t), intent(in) :: control
        character(len=*), intent(in) :: name
        real(wp), intent(in) :: s
        integer, intent(in) :: way
        type(contact_state_t), intent(out) :: state
        type(error_t), allocatable, intent(out) :: error
        type(stable_segment_t), allocatable :: list(:)
        character(len=:), allocatable :: what
        integer :: chosen

        what = " = "//to_text(s)//" cannot be reached"
        if (way == on_loading .and. s < 0.0_wp) then
            call raise(error, error_unreachable, what//" on loading: the bodies touch at "//name//" 0; below it a contact "// &
                       "exists on unloading only", name)
            return
        end if
        call self%stable_segments(control, list, error)
        if (allocated(error)) return
        if (size(list) == 0) then
            call raise(error, error_unreachable, what//": this contact has no stable adhesive state", name)
            return
        end if
        chosen = findloc(list%lowest <= s .and. s <= list%highest, .true., dim=1, back=way == on_unloading)
        if (chosen > 0) then
            call self%state_on_segment(control, list(chosen), s, state, error)
        else if (s < minval(list%lowest)) then
            call raise(error, error_unreachable, what//": the adhesive branch ends at pull-off, "//name//" = "// &
                       to_text(minval(list%lowest)), name)
        else
            call raise(error, error_unreachable, what//": the branch ends with the indenter or the medium at "//name//" = "// &
                       to_text(maxval(list%highest))//trim(self%equilibrium%why_it_ends()), name)
        end if
    end subroutine adhesive_state

    !> Displacements and stresses inside a body under the state's pressure, and under its friction where the contact slides.
    subroutine interior(self, state, upper, r, z, below, friction, angle, field, error, threads)
        class(contact_t), intent(in) :: self
        !> with a radius > 0
        type(contact_state_t), intent(in) :: state
        !> whether the upper body is meant, not the lower one; z points into the body that is meant
        logical, intent(in) :: upper
        !> points r >= 0, z >= 0 [length]
        real(wp), intent(in) :: r(:), z(:)
        !> at an interface the side of the larger z is meant
        logical, intent(in) :: below
        !> f >= 0: traction f p(r) in +x on the lower body, -f p(r) on the upper one; not with adhesion
        real(wp), intent(in) :: friction
        !> azimuths of the points from +x, same size as r [radian]
        real(wp), intent(in) :: angle(:)
        !> (size(r), components): u_r, u_t, u_z [length], s_rr, s_tt, s_zz, s_rz, s_rt, s_tz [modulus]
        real(wp), intent(out) :: field(:, :)
        type(error_t), allocatable, intent(out) :: error
        !> how many threads may share the work, 0: as many as OpenMP offers
        integer, intent(in) :: threads
        class(load_t), allocatable :: load
        integer :: i

        call check_not_negative(error, "friction", friction)
        do i = 1, size(angle)
            call check_finite(error, "angle", angle(i), i)
        end do
        if (allocated(error)) return
        call load_of(self, state, upper, load, error)
        if (allocated(error)) return
        if (friction > 0.0_wp .and. load%edge < 0.0_wp) then
            call raise(error, error_invalid, " = "//to_text(friction)//" is not allowed with adhesion: Coulomb's "// &
                       "law knows no tension, use friction = 0", "friction")
            return
        end if
        associate (medium => self%equilibrium%medium)
            if (upper) then
                call body_field(load, medium%counterbody, r, z, below, field, error, -friction, angle, threads)
            else
                call body_field(load, medium%pressed, r, z, below, field, error, friction, angle, threads)
            end if
        end associate
    end subroutine interior

    !> Elastic energy of each layer of a body, from the surface down, the half-space last [modulus length^3].
    subroutine layer_energy(self, state, upper, energies, error)
        class(contact_t), intent(in) :: self
        !> with a radius > 0
        type(contact_state_t), intent(in) :: state
        !> whether the upper body is meant
        logical, intent(in) :: upper
        !> one of each layer, and that of the half-space if there is one [modulus length^3]
        real(wp), allocatable, intent(out) :: energies(:)
        type(error_t), allocatable, intent(out) :: error
        class(load_t), allocatable :: load
        class(body_t), allocatable :: body
        type(layers_t) :: layers

        call load_of(self, state, upper, load, error)
        if (allocated(error)) return
        if (upper) then
            allocate (body, source=self%equilibrium%medium%counterbody)
        else
            allocate (body, source=self%equilibrium%medium%pressed)
        end if
        if (body%is_graded()) then
            call raise(error, error_invalid, "a graded body has no layers whose energies could be told apart")
            return
        end if
        call body%sublayers(load%radius, 1.0_wp, [real(wp) ::], layers)
        allocate (energies, source=layer_energies(load, layers, error))
    end subroutine layer_energy

    !> The load of a state on a body that is there.
    subroutine load_of(self, state, upper, load, error)
        type(contact_t), intent(in) :: self
        type(contact_state_t), intent(in) :: state
        logical, intent(in) :: upper
        class(load_t), allocatable, intent(inout) :: load
        type(error_t), allocatable, intent(out) :: error

        associate (equilibrium => self%equilibrium)
            if (upper .and. .not. equilibrium%medium%is_pair()) then
                call raise(error, error_invalid, " = upper is not allowed: the indenter is rigid", "body")
                return
            end if
            call check_positions(self, state, "r", [real(wp) ::], 0.0_wp, error)
            if (allocated(error)) return
            call equilibrium%medium%surface_load(equilibrium%profile, state%radius, state%excess, load, error)
            if (allocated(error)) return
            if (upper .and. allocated(equilibrium%medium%counterbody)) return
            if (allocated(equilibrium%medium%pressed) .and. .not. upper) return
            call raise(error, error_invalid, "stresses inside are not known for this medium: E and nu of its layers are needed")
        end associate
    end subroutine load_of

    pure subroutine check_positions(self, state, name, positions, largest, error)
        type(contact_t), intent(in) :: self
        type(contact_state_t), intent(in) :: state
        character(len=*), intent(in) :: name
        real(wp), intent(in) :: positions(:), largest
        type(error_t), allocatable, intent(out) :: error
        integer :: i

        if (.not. state%radius > 0.0_wp) then
            call raise(error, error_invalid, "the contact radius of the state must be greater than 0: there is no contact")
        else if (state%radius > self%equilibrium%last_radius) then
            call raise(error, error_invalid, "the contact radius of the state, "//to_text(state%radius)//", is not one of this "// &
                       "contact: indenter and medium are defined up to "//to_text(self%equilibrium%last_radius))
        end if
        call check_finite(error, "depth of the state", state%depth)
        call check_finite(error, "excess of the state", state%excess)
        if (allocated(error)) return
        do i = 1, size(positions)
            call check_not_negative(error, name, positions(i))
            if (allocated(error)) return
            if (positions(i) > largest) then
                call raise(error, error_domain, " = "//to_text(positions(i))//" is not allowed: it must be at most the contact "// &
                           "radius, "//to_text(largest), name)
                return
            end if
        end do
    end subroutine check_positions

end module mdrcontact_contact
