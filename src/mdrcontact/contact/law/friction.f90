! SPDX-License-Identifier: GPL-3.0-or-later
!> Friction of compiled laws: the tangential force of many contacts step by step, along any path of the shift in the plane and of F
!> (theory/friction.md (7.1)-(7.8)).
!>
!> The springs of a contact are divided among a few vector sliders, mdrcontact_law_sliders_motion. That is stick, partial slip,
!> sliding and what earlier slip left behind, with an error of some 1.5 % (8 sliders) or 0.5 % (16) of mu F against as many springs
!> as one likes; T is continuous in F and in the shift, no cycle yields energy, and a step has a derivative. Springs for themselves
!> are exact for homogeneous bodies along a line; in the plane they are a model (docs/laws.md).
!>
!> Springs slip by Coulomb's law, or where their traction reaches a constant shear strength. The latter does not depend on F: a step
!> is then one of the contact radius, which any contact has, one with adhesion too.
!>
!> Sliders of a twist carry a torque M where the others carry T, and turn by phi where these move by s: the spin of a ball about the
!> normal, under Coulomb's law and any path of phi and F (mdrcontact_law_twist).
module mdrcontact_law_friction
    use mdrcontact_batch, only: batch_t, run_batch
    use mdrcontact_contact, only: on_unloading
    use mdrcontact_crc32, only: mark_of
    use mdrcontact_error, only: check_made, count_text, error_domain, error_invalid, error_t, raise, raise_at, to_text
    use mdrcontact_kinds, only: wp
    use mdrcontact_law_evaluate, only: point_at, run_points, wanted_t
    use mdrcontact_law_interval, only: interval_place, panel_place_t => place_t, polynomial_with_slope
    use mdrcontact_law_levels, only: by_shear, by_twist, fewest_sliders, levels_t, most_sliders, new_levels, &
                                    new_radius_levels
    use mdrcontact_law_sliders_frame, only: turn_record
    use mdrcontact_law_sliders_keep, only: keep
    use mdrcontact_law_sliders_motion, only: mdrcontact_sliders_sound, mdrcontact_sliders_steps, motion_t, &
                                             move
    use mdrcontact_law_sliders_record, only: at_lost, is_record, part, record_size, stored_energy
    use mdrcontact_law_strengths, only: new_place, place_t
    use mdrcontact_law_table, only: law_table_t, scale_table
    implicit none (type, external)
    private
    public :: friction_law_t, contact_steps_t, default_sliders, find_levels, check_sliders

    !> Default number of sliders for the springs of a contact.
    integer, parameter :: default_sliders = 8

    !> The law of a contact with friction. It never changes. The memory of a contact is a record of the caller, an array of
    !> memory_size() numbers, all 0 before the first step.
    type :: friction_law_t
        !> whether it was made: set last by what makes it
        logical :: is_made = .false.
        !> Coulomb's law: F and k_t over S = int dF/k_t, which replaces the depth, and S over F
        type(law_table_t) :: by_shift, by_force
        !> mu [1]; 0 where the shear strength is constant
        real(wp) :: coefficient = 0.0_wp
        !> where it is constant, else 0: the shear strength [modulus]
        real(wp) :: shear_strength = 0.0_wp
        !> of a twist F/a^3, else 0 [modulus/length]
        real(wp) :: cubic = 0.0_wp
        !> of both, else 0: k_t/(2 a), of a twist 3 k/(16 a^3), [modulus], and the range of contact radii [length]
        real(wp) :: modulus = 0.0_wp, radii(2) = 0.0_wp
        !> whether a radius may be larger
        logical :: continued = .false.
        !> how many sliders represents the springs
        integer :: sliders = default_sliders
        !> largest error of T found, relative to mu F: in first shear; along cycles of depth and shift against the exact history,
        !> relative to the largest mu F, -1 if it does not exist
        real(wp) :: first_shear_error = 0.0_wp, path_error = -1.0_wp
        !> strengths and stiffnesses of the sliders over S
        type(levels_t) :: levels
    contains
        procedure :: memory_size
        procedure :: sliding_shift
        procedure :: advance
        procedure :: attempt
        procedure :: steps
        procedure :: energies
        procedure :: turn
        procedure :: scale
    end type friction_law_t

    !> One step of each of many contacts.
    type :: contact_steps_t
        !> F at the end of the step, >= 0 [modulus length^2], or the contact radius where the shear strength is constant [length]; 0
        !> parts the bodies (n)
        real(wp), pointer, contiguous :: force(:) => null()
        !> displacement of the indenter along the surface in this step [length] (3, n)
        real(wp), pointer, contiguous :: shift(:, :) => null()
        !> the records (memory_size(), n)
        real(wp), pointer, contiguous :: memory(:, :) => null()
        !> receives T on the medium [modulus length^2] (3, n)
        real(wp), pointer, contiguous :: traction(:, :) => null()
        !> receives dT_i/ds_j, (j, i), and dT_i/dF, (4, i), at the end of the step (4, 3, n); null: not requested
        real(wp), pointer, contiguous :: tangent(:, :, :) => null()
        !> whether the records are to remain as they are: a trial
        logical :: is_trial = .false.
    end type contact_steps_t

    type, extends(batch_t) :: work_t
        type(friction_law_t), pointer :: law => null()
        type(contact_steps_t) :: steps
    contains
        procedure :: work => do_steps
    end type work_t

    !> Contacts for which the law is evaluated at a time, and below how many each alone is quicker; from how many on several threads
    !> pay.
    integer, parameter :: block_size = 256, few = 6, smallest_parallel = 16*block_size
    !> Forces, shifts and records of larger size raise an error: their squares overflow.
    real(wp), parameter :: largest = 1.0e150_wp
    !> A normal force of less than this part of the largest counts as 0: slopes there are no numbers.
    real(wp), parameter :: nothing = 1.0e-100_wp
    !> Largest deviation of the length of a normal from 1.
    real(wp), parameter :: loose = 1.0e-6_wp
    character(len=*), parameter :: must_be_moderate = " must be finite, at most 1e150 in size"

contains

    !> Number of numbers in the record of a contact.
    pure function memory_size(self) result(count)
        class(friction_law_t), intent(in) :: self
        integer :: count

        count = record_size(self%sliders)
    end function memory_size

    !> The shift of first shear at which a contact slides under the largest F, or with the largest contact radius [length]; 0 of a
    !> twist, for the axis sticks at any.
    pure function sliding_shift(self) result(shift)
        class(friction_law_t), intent(in) :: self
        real(wp) :: shift

        if (self%cubic > 0.0_wp) then
            shift = 0.0_wp
        else if (self%levels%of_radius) then
            shift = 2.0_wp*self%shear_strength*self%radii(2)/self%modulus
        else
            shift = self%coefficient*self%by_shift%highest
        end if
    end function sliding_shift

    !> Levels and mark of a law that is otherwise complete; shares of springs that interact are left to the caller.
    subroutine find_levels(self, shared)
        type(friction_law_t), intent(inout) :: self
        !> whether there will be shares
        logical, intent(in) :: shared

        if (self%shear_strength > 0.0_wp) then
            call new_radius_levels(self%levels, self%radii(1), self%radii(2), 2.0_wp*self%modulus, by_shear, self%sliders)
            self%levels%strength = self%shear_strength
        else if (self%cubic > 0.0_wp) then
            call new_radius_levels(self%levels, self%radii(1), self%radii(2), 16.0_wp/3.0_wp*self%modulus, by_twist, self%sliders)
            self%levels%strength = 0.375_wp*self%coefficient*self%cubic/self%modulus
        else
            call new_levels(self%levels, self%by_shift, self%by_force, self%sliders, shared)
            self%levels%strength = self%coefficient
        end if
        ! of all that a record depends on
        self%levels%mark = mark_of([self%levels%strength, real(self%sliders, wp), self%levels%force, self%levels%shift])
    end subroutine find_levels

    !> The sliders of these bodies if F and S at each contact radius are a factor times what they were, and k_t is as it was: shares
    !> of springs that interact are those of contact radii, and so is the load at a constant shear strength.
    subroutine scale(self, factor)
        class(friction_law_t), intent(inout) :: self
        !> > 0
        real(wp), intent(in) :: factor
        real(wp), allocatable :: share(:, :)

        if (self%shear_strength > 0.0_wp) return
        if (self%cubic > 0.0_wp) then
            self%cubic = factor*self%cubic
            call find_levels(self, .false.)
            return
        end if
        call scale_table(self%by_shift, factor)
        call scale_table(self%by_force, factor)
        call move_alloc(self%levels%share, share)
        call find_levels(self, allocated(share))
        call move_alloc(share, self%levels%share)
    end subroutine scale

    !> Raises unless so many sliders can represents the springs.
    pure subroutine check_sliders(error, sliders)
        type(error_t), allocatable, intent(inout) :: error
        integer, intent(in) :: sliders

        if (sliders < fewest_sliders .or. sliders > most_sliders) then
            call raise(error, error_invalid, "sliders = "//count_text(sliders)//": it must be "//count_text(fewest_sliders)// &
                       " to "//count_text(most_sliders))
        end if
    end subroutine check_sliders

    !> One step of a contact, straight in S and the shift. After an error the record is as before.
    pure subroutine advance(self, force, shift, memory, traction, error, tangent)
        class(friction_law_t), intent(in) :: self
        !> F at the end of the step, >= 0 [modulus length^2], or the contact radius where the shear strength is constant [length]; 0
        !> parts the bodies
        real(wp), intent(in) :: force
        !> displacement of the indenter along the surface in this step [length]
        real(wp), intent(in) :: shift(3)
        !> of this contact, of memory_size() numbers
        real(wp), intent(inout), contiguous :: memory(:)
        !> T on the medium [modulus length^2]
        real(wp), intent(out) :: traction(3)
        type(error_t), allocatable, intent(out) :: error
        !> dT_i/ds_j, (j, i) [modulus length], and dT_i/dF, (4, i), at the end of the step
        real(wp), intent(out), optional :: tangent(4, 3)
        real(wp) :: level, compliance

        traction = 0.0_wp
        if (.not. self%is_made) call check_made(error, "law", self%is_made)
        if (allocated(error)) return
        if (present(tangent)) tangent = 0.0_wp
        call check_step(self, force, shift, memory, error)
        if (allocated(error)) return
        call level_at(self, force, level, compliance)
        call step(self, force, shift, level, compliance, .false., memory, traction, tangent)
    end subroutine advance

    !> Result of `advance`, without a change of the record.
    pure subroutine attempt(self, force, shift, memory, traction, error, tangent)
        class(friction_law_t), intent(in) :: self
        !> as of advance
        real(wp), intent(in) :: force, shift(3)
        !> the record, as of advance
        real(wp), intent(in), contiguous :: memory(:)
        !> tangential force on the medium at the end of the step [modulus length^2]
        real(wp), intent(out) :: traction(3)
        type(error_t), allocatable, intent(out) :: error
        !> as of advance
        real(wp), intent(out), optional :: tangent(4, 3)
        real(wp) :: copy(size(memory))

        if (.not. self%is_made) call check_made(error, "law", self%is_made)
        if (allocated(error)) return
        copy = memory
        call self%advance(force, shift, copy, traction, error, tangent)
    end subroutine attempt

    !> One step of each of many contacts, on `threads` threads (0: as many as the runtime offers), as advance or attempt does it.
    !> After an error all records are as before, and the error names the first contact that failed.
    subroutine steps(self, contacts, threads, error)
        class(friction_law_t), intent(in), target :: self
        type(contact_steps_t), intent(in) :: contacts
        !> at least 1, or 0 for as many as OpenMP offers
        integer, intent(in) :: threads
        type(error_t), allocatable, intent(out) :: error
        type(work_t) :: work
        integer :: i

        ! all are possible before the first one is done
        if (.not. self%is_made) call check_made(error, "law", self%is_made)
        if (allocated(error)) return
        i = 1
        do
            i = i + valid_steps(self, contacts, i)
            if (i > size(contacts%force)) exit
            call check_step(self, contacts%force(i), contacts%shift(:, i), contacts%memory(:, i), error)
            if (allocated(error)) then
                call raise_at(error, i)
                return
            end if
            i = i + 1
        end do
        work%is_quick = .true.
        work%law => self
        work%steps = contacts
        call run_batch(work, size(contacts%force), block_size, smallest_parallel, threads, error)
    end subroutine steps

    !> Number of contacts, from the first one on, that certainly have no error; check_step decides for the others.
    function valid_steps(self, contacts, first) result(valid)
        type(friction_law_t), intent(in) :: self
        type(contact_steps_t), intent(in) :: contacts
        integer, intent(in) :: first
        integer :: valid, last

        last = size(contacts%force)
        associate (c => contacts, l => self%levels)
            valid = mdrcontact_sliders_sound(l%row, l%count, l%sliders, l%mark, highest_given(self), last - first + 1, &
                                             c%force(first:), c%shift(:, first:), c%memory(:, first:))
        end associate
    end function valid_steps

    !> Steps of contacts first to last; the law is evaluated for many points at a time, which is quicker, and gives bitwise
    !> identical results.
    subroutine do_steps(self, first, last, error)
        class(work_t), intent(inout) :: self
        integer, intent(in) :: first, last
        type(error_t), allocatable, intent(out) :: error
        real(wp), dimension(block_size), target :: level, compliance
        integer :: i, n

        n = last - first + 1
        associate (s => self%steps, law => self%law)
            if (n >= few .and. .not. law%levels%of_radius) then
                call run_points(law%by_force, on_unloading, s%force(first:last), .false., 1, &
                                wanted_t(level(:n), compliance(:n)))
            else
                do i = 1, n
                    call level_at(law, s%force(first + i - 1), level(i), compliance(i))
                end do
            end if
            i = first
            do while (i <= last)
                n = i - first + 1
                if (.not. law%levels%of_radius) i = i + quick_steps(law, s, i, last, level(n:), compliance(n:))
                if (i > last) exit
                n = i - first + 1
                if (associated(s%tangent)) then
                    call step(law, s%force(i), s%shift(:, i), level(n), compliance(n), s%is_trial, s%memory(:, i), &
                              s%traction(:, i), s%tangent(:, :, i))
                else
                    call step(law, s%force(i), s%shift(:, i), level(n), compliance(n), s%is_trial, s%memory(:, i), &
                              s%traction(:, i))
                end if
                i = i + 1
            end do
        end associate
    end subroutine do_steps

    !> Steps of contacts first to last, up to one that is left to `step`; how many.
    function quick_steps(law, contacts, first, last, level, compliance) result(done)
        type(friction_law_t), intent(in) :: law
        type(contact_steps_t), intent(inout) :: contacts
        integer, intent(in) :: first, last
        !> S and dS/dF of each
        real(wp), intent(in) :: level(last - first + 1), compliance(last - first + 1)
        integer :: done
        real(wp), pointer, contiguous :: tangent(:, :, :)

        nullify (tangent)
        if (associated(contacts%tangent)) tangent => contacts%tangent(:, :, first:last)
        associate (c => contacts, l => law%levels)
            done = mdrcontact_sliders_steps(l%row, l%share, l%count, l%sliders, l%strength, nothing*largest_given(law), &
                                            last - first + 1, merge(1, 0, c%is_trial), c%force(first:last), level, compliance, &
                                            c%shift(:, first:last), c%memory(:, first:last), c%traction(:, first:last), tangent)
        end associate
    end function quick_steps

    !> A step that is possible: check_step has no error.
    pure subroutine step(self, force, shift, level, compliance, is_trial, memory, traction, tangent)
        class(friction_law_t), intent(in) :: self
        real(wp), intent(in) :: force, shift(3)
        !> S and dS/dF at F
        real(wp), intent(in) :: level, compliance
        logical, intent(in) :: is_trial
        real(wp), intent(inout), contiguous :: memory(:)
        real(wp), intent(out) :: traction(3)
        real(wp), intent(out), optional :: tangent(4, 3)
        type(motion_t) :: motion
        type(place_t) :: place

        if (.not. force > nothing*largest_given(self)) then
            traction = 0.0_wp
            if (present(tangent)) tangent = 0.0_wp
            if (.not. is_trial) call part(self%levels, memory)
            return
        end if
        place = new_place(self%levels, force, level, compliance)
        call move(self%levels, place, shift, memory, motion, tangent)
        traction = motion%total
        if (.not. is_trial) call keep(self%levels, place, motion, memory)
    end subroutine step

    !> The largest F of the law, or contact radius.
    pure function largest_given(self) result(largest)
        type(friction_law_t), intent(in) :: self
        real(wp) :: largest

        largest = self%by_force%highest
        if (self%levels%of_radius) largest = self%radii(2)
        if (self%cubic > 0.0_wp) largest = self%cubic*self%radii(2)**3
    end function largest_given

    !> The largest F that a step may have, or contact radius.
    pure function highest_given(self) result(highest)
        type(friction_law_t), intent(in) :: self
        real(wp) :: highest

        highest = largest
        if (.not. (self%by_force%continued .or. self%continued)) highest = min(largest_given(self), largest)
    end function highest_given

    !> S and dS/dF at F; S = a where that is given.
    pure subroutine level_at(self, force, level, compliance)
        type(friction_law_t), intent(in) :: self
        real(wp), intent(in) :: force
        real(wp), intent(out) :: level, compliance
        type(panel_place_t) :: place
        real(wp) :: radius, stiffness

        associate (table => self%by_force)
            if (self%cubic > 0.0_wp) then
                level = (force/self%cubic)**(1.0_wp/3.0_wp)
                compliance = 0.0_wp
                if (force > 0.0_wp) compliance = level/(3.0_wp*force)
            else if (self%levels%of_radius) then
                level = force
                compliance = 1.0_wp
            else if (force >= table%direct%lowest .and. force <= table%direct%highest) then
                place = interval_place(table%direct, force)
                call polynomial_with_slope(table%other(place%panel)%c, place%t, level, compliance)
                compliance = table%direct%scale*compliance
            else
                call point_at(table, on_unloading, force, level, compliance, radius, stiffness)
            end if
        end associate
    end subroutine level_at

    !> Energy stored in the springs, and dissipated since the first step [modulus length^3].
    pure subroutine energies(self, memory, stored, dissipated, error)
        class(friction_law_t), intent(in) :: self
        !> the record, as of advance
        real(wp), intent(in), contiguous :: memory(:)
        !> what the springs hold, and what slip has taken since the first step [modulus length^3]
        real(wp), intent(out) :: stored
        !> see stored
        real(wp), intent(out) :: dissipated
        type(error_t), allocatable, intent(out) :: error

        stored = 0.0_wp
        dissipated = 0.0_wp
        if (.not. self%is_made) call check_made(error, "law", self%is_made)
        if (allocated(error)) return
        call check_memory(self, memory, error)
        if (allocated(error)) return
        stored = stored_energy(self%levels, memory)
        dissipated = memory(at_lost)
    end subroutine energies

    !> Turns the record with its tangent plane: by the least rotation from the old normal to the new one, and by an angle about it.
    !> The first turn only makes the normal known: a contact whose plane turns is turned before its first step.
    pure subroutine turn(self, normal, spin, memory, error)
        class(friction_law_t), intent(in) :: self
        !> of the new plane, of length 1
        real(wp), intent(in) :: normal(3)
        !> angle by which the bodies have turned about the normal, on average of both: (w1 + w2).n/2 dt [1]
        real(wp), intent(in) :: spin
        !> the record, as of advance
        real(wp), intent(inout), contiguous :: memory(:)
        type(error_t), allocatable, intent(out) :: error

        if (.not. self%is_made) call check_made(error, "law", self%is_made)
        if (allocated(error)) return
        if (.not. abs(norm2(normal) - 1.0_wp) <= loose) then
            call raise(error, error_invalid, " of length "//to_text(norm2(normal))//": its length must be 1", "normal")
        end if
        if (.not. abs(spin) <= largest) call raise(error, error_invalid, must_be_moderate, "spin")
        call check_memory(self, memory, error)
        if (.not. allocated(error)) call turn_record(self%levels, normal/norm2(normal), spin, memory)
    end subroutine turn

    !> Whether a step is possible.
    pure subroutine check_step(self, force, shift, memory, error)
        class(friction_law_t), intent(in) :: self
        !> as of advance
        real(wp), intent(in) :: force
        !> see force
        real(wp), intent(in) :: shift(3)
        !> see force
        real(wp), intent(in), contiguous :: memory(:)
        type(error_t), allocatable, intent(inout) :: error
        real(wp) :: stiffest

        if (.not. (force >= 0.0_wp .and. force <= largest)) then
            call raise(error, error_invalid, " = "//to_text(force)//": it must be 0 (separated bodies) or greater, at most "// &
                       "1e150", "force")
        end if
        stiffest = max(self%levels%stiffness(self%levels%count), 1.0_wp)
        if (.not. (abs(shift(1)) + abs(shift(2)) + abs(shift(3)))*stiffest <= largest) then
            call raise(error, error_invalid, must_be_moderate//", and so must its product with the stiffness", "shift")
        end if
        if (.not. allocated(error)) call check_memory(self, memory, error)
        if (.not. (force > highest_given(self) .and. force <= largest)) return
        if (self%shear_strength > 0.0_wp) then
            call raise(error, error_domain, " = "//to_text(force)//": the largest contact radius of the law is "// &
                       to_text(self%radii(2))//" (`force` is the contact radius). Increase largest_depth, or set "// &
                       "continue_beyond", "force")
        else
            call raise(error, error_domain, " = "//to_text(force)//": the largest force of the law is "// &
                       to_text(largest_given(self))//". Increase largest_depth, or set continue_beyond", "force")
        end if
    end subroutine check_step

    !> Whether numbers are a record of this law.
    pure subroutine check_memory(self, memory, error)
        class(friction_law_t), intent(in) :: self
        real(wp), intent(in), contiguous :: memory(:)
        type(error_t), allocatable, intent(inout) :: error
        logical :: valid

        valid = size(memory) == record_size(self%sliders)
        if (valid) valid = is_record(self%levels, memory)
        if (valid) return
        call raise(error, error_invalid, ": it must be 0 before the first step, and a record of this law later", "memory")
    end subroutine check_memory

end module mdrcontact_law_friction
