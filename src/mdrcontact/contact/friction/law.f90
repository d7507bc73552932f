! SPDX-License-Identifier: GPL-3.0-or-later
!> From a contact with friction to its compiled law: its sliders, the shares of springs that interact, and its verification in first
!> shear and along cycles of depth and shift.
module mdrcontact_friction_law
    use mdrcontact_cancel, only: check_cancelled
    use mdrcontact_contact, only: contact_t, on_unloading
    use mdrcontact_contact_load, only: contact_load_t
    use mdrcontact_contact_state, only: contact_state_t
    use mdrcontact_contact_values, only: given_depth
    use mdrcontact_error, only: check_made, check_memory, error_invalid, error_t, raise, to_text
    use mdrcontact_friction_partial_slip, only: first_shear_t, friction_t, tangential_state_t
    use mdrcontact_friction_history, only: friction_history_t, given_shift, new_friction_history
    use mdrcontact_kinds, only: pi, wp
    use mdrcontact_law, only: contact_law_t
    use mdrcontact_law_evaluate, only: point_at
    use mdrcontact_law_friction, only: check_sliders, friction_law_t, find_levels
    use mdrcontact_law_from_contact, only: law_options_t, new_law_of_contact => new_contact_law
    use mdrcontact_law_levels, only: allocate_shares, levels_t, share_index
    use mdrcontact_law_shear_strength, only: new_law_with_shear_strength
    use mdrcontact_law_strengths, only: growth_beyond, place_t
    use mdrcontact_law_twisted, only: new_twist_law
    implicit none (type, external)
    private
    public :: new_contact_law, new_friction_law

    !> The law of a contact, of a contact and its friction, or of a contact of constant shear strength.
    interface new_contact_law
        procedure new_law_of_contact, new_law_with_friction, new_law_with_shear_strength
    end interface new_contact_law

    !> Parts of the largest depth and of the shift of sliding; and cycles: steps, shifts in units of the largest mu S,
    !> cycles of the shift in one of the depth.
    real(wp), parameter :: depths(*) = [0.01_wp, 0.1_wp, 0.5_wp, 0.6_wp, 0.7_wp, 0.85_wp, 1.0_wp], &
                           parts(*) = [0.05_wp, 0.13_wp, 0.2_wp, 0.3_wp, 0.6_wp, 0.9_wp, 0.96_wp]
    integer, parameter :: steps = 100
    !> Largest difference between states of a contact that was created twice.
    real(wp), parameter :: same = 1.0e-9_wp
    real(wp), parameter :: amplitudes(*) = [0.3_wp, 1.0_wp, 3.0_wp], cycles(*) = [0.5_wp, 1.0_wp, 2.0_wp]

contains

    !> The law of a contact with friction: F(d) and all that belongs to it, and its sliders.
    subroutine new_law_with_friction(self, contact, friction, largest_depth, error, options, sliders, twist)
        type(contact_law_t), intent(out) :: self
        type(contact_t), intent(in) :: contact
        !> of this contact
        type(friction_t), intent(in) :: friction
        !> > 0 [length]
        real(wp), intent(in) :: largest_depth
        type(error_t), allocatable, intent(out) :: error
        type(law_options_t), intent(in), optional :: options
        !> 4 to 64 vector sliders for the springs of the contact; default 8
        integer, intent(in), optional :: sliders
        !> whether they carry a twist about the normal, with its torque, instead of the shift; of a paraboloid on homogeneous bodies
        logical, intent(in), optional :: twist

        call check_made(error, "contact", contact%is_made)
        call check_made(error, "friction", friction%is_made)
        if (present(sliders)) call check_sliders(error, sliders)
        if (allocated(error)) return
        call new_law_of_contact(self, contact, largest_depth, error, options)
        if (.not. allocated(error)) call check_same_contact(contact, friction, largest_depth, error)
        if (allocated(error)) return
        allocate (self%friction)
        if (present(twist)) then
            if (twist) then
                call new_twist_law(self%friction, self%by_depth, friction%contact, friction%coefficient, error, sliders)
                self%is_made = .not. allocated(error)
                return
            end if
        end if
        call new_friction_law(self%friction, friction, largest_depth, error, options, sliders)
        self%is_made = .not. allocated(error)
    end subroutine new_law_with_friction

    !> Raises unless friction is that of a contact, as far as states show.
    subroutine check_same_contact(contact, friction, largest_depth, error)
        type(contact_t), intent(in) :: contact
        type(friction_t), intent(in) :: friction
        real(wp), intent(in) :: largest_depth
        type(error_t), allocatable, intent(out) :: error
        type(contact_state_t) :: one, other
        integer :: i

        do i = 1, size(depths)
            call contact%at_depth(depths(i)*largest_depth, one, error)
            if (.not. allocated(error)) call friction%contact%at_depth(depths(i)*largest_depth, other, error)
            if (allocated(error)) return
            if (abs(one%force - other%force) <= same*abs(one%force) .and. abs(one%radius - other%radius) <= same*one%radius) cycle
            call raise(error, error_invalid, ": it must belong to the contact of the law. At depth "//to_text(one%depth)// &
                       " the force of its contact is "//to_text(other%force)//" instead of "//to_text(one%force), "friction")
            return
        end do
    end subroutine check_same_contact

    !> The sliders of a contact with friction up to `largest_depth`.
    subroutine new_friction_law(self, friction, largest_depth, error, options, sliders)
        type(friction_law_t), intent(out) :: self
        type(friction_t), intent(in) :: friction
        !> > 0 [length]
        real(wp), intent(in) :: largest_depth
        type(error_t), allocatable, intent(out) :: error
        !> as of a contact's law
        type(law_options_t), intent(in), optional :: options
        !> 4 to 64; default 8
        integer, intent(in), optional :: sliders
        type(contact_law_t) :: law

        if (present(sliders)) self%sliders = sliders
        call check_sliders(error, self%sliders)
        if (allocated(error)) return
        call new_law_of_contact(law, friction%contact, largest_depth, error, options, friction%tangential)
        if (allocated(error)) return
        self%by_shift = law%by_depth
        self%by_force = law%by_force
        self%coefficient = friction%coefficient
        associate (medium => friction%contact%equilibrium%medium)
            call find_levels(self, .not. medium%has_free_springs)
            if (.not. medium%has_free_springs) call find_shares(self, friction, error)
            ! what verifies it takes it as made
            self%is_made = .true.
            if (.not. allocated(error)) call verify_first_shear(self, friction, largest_depth, error)
            if (medium%has_free_springs .and. .not. allocated(error)) call verify_paths(self, friction, largest_depth, error)
        end associate
        self%is_made = .not. allocated(error)
    end subroutine new_friction_law

    !> The shares of springs that interact: first shear of the contact at each level and half-way to the next.
    subroutine find_shares(self, friction, error)
        type(friction_law_t), intent(inout) :: self
        type(friction_t), intent(in) :: friction
        type(error_t), allocatable, intent(out) :: error
        real(wp), dimension(self%levels%count) :: radii, at_level, half_way, at_next
        integer :: m, stat

        associate (levels => self%levels)
            call allocate_shares(levels, stat)
            call check_memory(error, stat)
            if (.not. allocated(error)) call find_radii(levels, friction, radii, error)
            at_level = 1.0_wp
            do m = 1, levels%count - 1
                if (.not. allocated(error)) call find_share(self, friction, radii, m, half_way, error, 0.5_wp)
                if (.not. allocated(error)) call find_share(self, friction, radii, m + 1, at_next, error)
                if (allocated(error)) return
                ! nothing slips at the edge: what is beyond the level itself is known from above alone
                at_level(m) = 2.0_wp*half_way(m) - at_next(m)
                associate (first => share_index(1, m), last => share_index(m, m))
                    levels%share(1, first:last) = at_level(:m)
                    levels%share(2, first:last) = 4.0_wp*half_way(:m) - 3.0_wp*at_level(:m) - at_next(:m)
                    levels%share(3, first:last) = 2.0_wp*(at_level(:m) + at_next(:m)) - 4.0_wp*half_way(:m)
                end associate
                at_level = at_next
            end do
            at_level(levels%count) = 1.0_wp
            levels%share(1, share_index(1, levels%count):share_index(levels%count, levels%count)) = at_level
        end associate
        if (superposed(self%levels)) call find_levels(self, .false.)
    end subroutine find_shares

    !> Whether all shares are 1 but for what no slider notices.
    pure function superposed(levels) result(within)
        type(levels_t), intent(in) :: levels
        logical :: within
        real(wp), parameter :: unnoticed = 1.0e-3_wp

        within = all(abs(levels%share(1, :) - 1.0_wp) < unnoticed) .and. all(abs(levels%share(2:, :)) < unnoticed)
    end function superposed

    !> Contact radii at the levels.
    subroutine find_radii(levels, friction, radii, error)
        type(levels_t), intent(in) :: levels
        type(friction_t), intent(in) :: friction
        real(wp), intent(out) :: radii(:)
        type(error_t), allocatable, intent(out) :: error
        type(contact_state_t) :: state
        integer :: l

        do l = 1, levels%count
            call friction%contact%at_force(levels%force(l), state, error)
            if (allocated(error)) return
            radii(l) = state%radius
        end do
    end subroutine find_radii

    !> The shares of the springs beyond each level below, of a contact at a level, or at a part of the way to the next.
    subroutine find_share(self, friction, radii, level, share, error, part)
        type(friction_law_t), intent(in) :: self
        type(friction_t), intent(in) :: friction
        real(wp), intent(in) :: radii(:)
        integer, intent(in) :: level
        !> 1 of those that are not below
        real(wp), intent(out) :: share(:)
        type(error_t), allocatable, intent(out) :: error
        real(wp), intent(in), optional :: part
        type(contact_state_t) :: state
        type(contact_load_t) :: pressed
        type(first_shear_t) :: shear
        type(place_t) :: place
        real(wp) :: shift, force, load, superposed_load, radius, stiffness, unused
        integer :: l

        share = 1.0_wp
        call check_cancelled(error)
        associate (levels => self%levels)
            shift = levels%shift(level)
            force = levels%force(level)
            if (present(part)) then
                shift = (1.0_wp - part)*shift + part*levels%shift(level + 1)
                call point_at(self%by_shift, on_unloading, shift, force, unused, radius, stiffness)
            end if
            if (.not. allocated(error)) call friction%contact%at_force(force, state, error)
            if (.not. allocated(error)) call friction%contact%load(state, pressed, error)
            if (.not. allocated(error)) call friction%first_shear(pressed, shear, error)
            if (allocated(error)) return
            place = place_t(force, shift, 1.0_wp, 1.0_wp, force)
            do l = 1, level
                call growth_beyond(levels, [levels%shift(l), levels%force(l), levels%stiffness(l)], place, superposed_load, unused)
                if (.not. superposed_load > 0.0_wp) cycle
                call shear%load_beyond(radii(l), load, error)
                if (allocated(error)) return
                share(l) = load/superposed_load
            end do
        end associate
    end subroutine find_share

    !> T after one step at constant F, compared with the contact itself.
    subroutine verify_first_shear(self, friction, largest_depth, error)
        type(friction_law_t), intent(inout) :: self
        type(friction_t), intent(in) :: friction
        real(wp), intent(in) :: largest_depth
        type(error_t), allocatable, intent(out) :: error
        type(contact_state_t) :: state
        type(contact_load_t) :: load
        type(first_shear_t) :: shear
        type(tangential_state_t) :: exact
        real(wp) :: memory(self%memory_size()), force, traction(3)
        integer :: i, j

        do i = 1, size(depths)
            call friction%contact%at_depth(depths(i)*largest_depth, state, error)
            if (.not. allocated(error)) call friction%contact%load(state, load, error)
            if (.not. allocated(error)) call friction%first_shear(load, shear, error)
            if (allocated(error)) return
            do j = 1, size(parts)
                call shear%at_shift(parts(j)*shear%sliding_shift, exact, error)
                if (allocated(error)) return
                memory = 0.0_wp
                force = state%force*(1.0_wp - 4.0_wp*epsilon(1.0_wp))
                call self%advance(force, [0.0_wp, 0.0_wp, 0.0_wp], memory, traction, error)
                if (.not. allocated(error)) call self%advance(force, [exact%shift, 0.0_wp, 0.0_wp], memory, traction, error)
                if (allocated(error)) return
                self%first_shear_error = max(self%first_shear_error, abs(traction(1) - exact%tangential_force)/shear%sliding_force)
            end do
        end do
    end subroutine verify_first_shear

    !> T along cycles of depth from touch to touch, with shifts to and fro, against the exact history.
    subroutine verify_paths(self, friction, largest_depth, error)
        type(friction_law_t), intent(inout) :: self
        type(friction_t), intent(in) :: friction
        real(wp), intent(in) :: largest_depth
        type(error_t), allocatable, intent(out) :: error
        type(friction_history_t) :: history
        real(wp) :: memory(self%memory_size()), traction(3)
        real(wp) :: time, depth, shift, before, size_of_shift
        integer :: i, j, step

        self%path_error = 0.0_wp
        size_of_shift = self%coefficient*self%by_shift%highest
        do i = 1, size(amplitudes)
            do j = 1, size(cycles)
                call new_friction_history(history, friction, error)
                if (allocated(error)) return
                memory = 0.0_wp
                before = 0.0_wp
                do step = 1, steps - 1
                    time = real(step, wp)/steps
                    depth = (1.0_wp - 4.0_wp*epsilon(1.0_wp))*largest_depth*sin(pi*time)
                    shift = amplitudes(i)*size_of_shift*sin(2.0_wp*pi*cycles(j)*time)
                    call history%advance(given_depth, depth, given_shift, shift, error)
                    if (.not. allocated(error)) then
                        call self%advance(history%past%normal%force, [shift - before, 0.0_wp, 0.0_wp], memory, &
                                          traction, error)
                    end if
                    if (allocated(error)) return
                    before = shift
                    self%path_error = max(self%path_error, abs(traction(1) - history%past%tangential%tangential_force) &
                                          /(self%coefficient*self%by_force%highest))
                end do
            end do
        end do
    end subroutine verify_paths

end module mdrcontact_friction_law
