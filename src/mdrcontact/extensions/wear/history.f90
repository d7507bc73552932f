! SPDX-License-Identifier: GPL-3.0-or-later
!> A contact that slides and wears as a whole, with the memory of what each place of its indenter has lost (theory/wear.md (1.1)).
!>
!> Two discs of n/2 and n intervals march side by side, the first with steps twice as long. Both are of second order: results are
!> their extrapolation, and their difference states the error; it holds at the apex of a cone too, which wears off with errors of
!> first order. Rings instead of discs are of first order: results are those of the n intervals, and the difference states the error
!> as well.
module mdrcontact_wear_history
    use, intrinsic :: iso_c_binding, only: c_double
    use mdrcontact_nonfinite, only: infinity
    use mdrcontact_cancel, only: check_cancelled, report_progress
    use mdrcontact_codes, only: fixed_rings => wear_rings, moving_disc => wear_disc
    use mdrcontact_contact_load, only: contact_load_t
    use mdrcontact_contact_state, only: contact_state_t
    use mdrcontact_contact_values, only: given_depth, given_force
    use mdrcontact_error, only: check_code, check_count_within, check_made, check_not_negative, check_positive, count_text, &
                                error_domain, error_invalid, error_t, raise, to_text
    use mdrcontact_kinds, only: pi, wp
    use mdrcontact_profile_worn, only: new_worn_profile, worn_profile_t
    use mdrcontact_wear, only: wear_t
    use mdrcontact_medium_solver, only: check_springs
    use mdrcontact_wear_disc, only: step_disc, worn_volume
    use mdrcontact_medium_hats, only: hats_t, new_hats
    use mdrcontact_wear_history_on_disc, only: disc_t, wear_history_on_disc_t, new_wear_history_on_disc
    use mdrcontact_wear_limit, only: check_carries, check_control
    use mdrcontact_wear_past, only: check_fits, find_mark, past_size, read_past, save_past, wear_past_t, wearing_t
    use mdrcontact_wear_rate, only: wear_rate_t
    use mdrcontact_wear_rings, only: first_extent, step_rings
    implicit none (type, external)
    private
    public :: new_wear_history, moving_disc, fixed_rings, wear_history_t, wear_past_t, wear_state_t

    !> Intervals: by default, fewest, most; a multiple of 4.
    integer, parameter :: usual_intervals = 80, fewest_intervals = 16, most_intervals = 640
    !> Largest number of Legendre polynomials for the interaction of a film's springs.
    integer, parameter :: most_waves = 128
    !> A history begins with steps to (i/n)^1.5 of the contact radius; later ones grow with the distance. Soon after the force began
    !> to change, or ceased to, they are at most this multiple of a/n in k E0* s. So are all those under a given depth, where the
    !> force falls exponentially, and of coated tips, where the pressure jumps at the end of the coating.
    real(wp), parameter :: step_power = 1.5_wp, longest_step = 4.0_wp
    !> A place's int p ds has errors proportional to the step, which a much shorter one after it would turn into pressures. Long
    !> steps are at least this part of the one before, and at most this part of what is left, down to a part of their length.
    real(wp), parameter :: shrinking = 0.5_wp, last_part = 0.05_wp
    !> Pressures below minus this part of the mean one are no errors of the hats.
    real(wp), parameter :: noticeable = 1.0e-2_wp
    !> The part of the thickness of its coating that the body may lose at most: its layers stay as they are.
    real(wp), parameter :: deepest_loss = 0.25_wp
    !> A part of a path of a coated tip is so long at most: contact radii over k E0*.
    real(wp), parameter :: farthest = 1.0e3_wp
    !> A target that differs from what there is by less than this part is the same.
    real(wp), parameter :: unchanged = 1.0e-9_wp
    !> The error of rings, which falls a little less than their width, over the difference of two resolutions.
    real(wp), parameter :: first_order = 1.25_wp
    !> Part of a radius that is close to the axis.
    real(wp), parameter :: apex = 1.0e-3_wp

    !> Current state of a history, C's struct mdr_wear_state.
    type, bind(C) :: wear_state_t
        !> s since the beginning [length]
        real(c_double) :: sliding = 0.0_c_double
        !> d from the original apex [length], a [length], F [modulus length^2]
        real(c_double) :: depth = 0.0_c_double, radius = 0.0_c_double, force = 0.0_c_double
        !> p on the axis [modulus]
        real(c_double) :: pressure = 0.0_c_double
        !> what the indenter has lost on the axis [length] and as a whole [length^3]
        real(c_double) :: worn_depth = 0.0_c_double, worn_volume = 0.0_c_double
        !> the same of the body, where both wear at the same places
        real(c_double) :: body_depth = 0.0_c_double, body_volume = 0.0_c_double
        !> int F ds [modulus length^3]
        real(c_double) :: work = 0.0_c_double
        !> relative, of a, d, F, p or the worn depth, whichever is largest
        real(c_double) :: error = 0.0_c_double
    end type wear_state_t

    !> A contact with its past. It belongs to its user: copies by assignment are independent, and no two threads may advance one
    !> at a time.
    type :: wear_history_t
        private
        !> whether it was made: set last by what makes it
        logical, public :: is_made = .false.
        type(wear_t) :: wear
        type(hats_t) :: hats(2)
        logical :: has_rings = .false.
        !> of the indenter, and of both where the body wears at the same places
        type(wear_rate_t) :: rate
        !> k of the body where it does, else 0 [1/modulus]
        real(wp) :: body_coefficient = 0.0_wp
        !> E0* [modulus], and thickness of the coating that may wear; infinite if it does not exist [length]
        real(wp) :: modulus = 0.0_wp, thickness = infinity
        !> a copy of it goes back to it
        type(wear_past_t), public :: past
    contains
        procedure :: advance
        procedure :: state
        procedure :: worn_profile
        procedure :: pressure
        procedure :: save
        procedure :: restore
        procedure :: saved_size
    end type wear_history_t

contains

    !> A contact that is pressed on and has not slid yet.
    subroutine new_wear_history(self, wear, control, target, error, intervals, both, scheme)
        type(wear_history_t), intent(out), target :: self
        !> copied
        type(wear_t), intent(in) :: wear
        !> given_depth or given_force
        integer, intent(in) :: control
        !> d [length] or F [modulus length^2] at the beginning, > 0
        real(wp), intent(in) :: target
        type(error_t), allocatable, intent(out) :: error
        !> a multiple of 4, 16 to 640; default or 0: 80
        integer, intent(in), optional :: intervals
        !> indenter and body rub at the same places, as they do where both move back and forth by much less than the contact
        !> radius: the gap opens by what both lose. Default: the body meets the indenter with fresh places
        logical, intent(in), optional :: both
        !> moving_disc or fixed_rings; default or 0: moving_disc
        integer, intent(in), optional :: scheme
        type(contact_state_t) :: state
        integer :: n

        call check_made(error, "wear", wear%is_made)
        if (allocated(error)) return
        call choose(self, intervals, scheme, n, error)
        call check_target(control, target, error)
        if (.not. allocated(error)) call check_indenter(wear, self%has_rings, error)
        if (allocated(error)) return
        self%wear = wear
        self%rate = wear%rate
        if (present(both)) then
            if (both) call add_body(self, error)
        end if
        if (.not. allocated(error)) call press(self, control, target, state, error)
        if (.not. allocated(error)) call find_modulus(self, error)
        if (allocated(error)) return
        call begin(self, n, state%radius, control, target, error)
        if (.not. allocated(error)) call find_mark(wearing(self), state%depth, self%past%mark, error)
        self%is_made = .not. allocated(error)
    end subroutine new_wear_history

    !> Intervals and scheme.
    subroutine choose(self, intervals, scheme, n, error)
        type(wear_history_t), intent(inout) :: self
        integer, intent(in), optional :: intervals, scheme
        integer, intent(out) :: n
        type(error_t), allocatable, intent(inout) :: error

        n = 0
        if (present(intervals)) n = intervals
        if (n == 0) n = usual_intervals
        call check_count_within(error, "intervals", n, fewest_intervals, most_intervals)
        if (.not. allocated(error) .and. modulo(n, 4) /= 0) then
            call raise(error, error_invalid, "intervals = "//count_text(n)//": it must be a multiple of 4")
        end if
        if (.not. present(scheme)) return
        if (scheme /= 0) call check_code(error, "scheme", scheme, [moving_disc, fixed_rings])
        self%has_rings = scheme == fixed_rings
    end subroutine choose

    !> Both discs under the first target.
    subroutine begin(self, n, radius, control, target, error)
        type(wear_history_t), intent(inout) :: self
        integer, intent(in) :: n, control
        !> of the unworn contact [length]
        real(wp), intent(in) :: radius, target
        type(error_t), allocatable, intent(inout) :: error
        type(disc_t) :: seed
        real(wp) :: extent, unused
        integer :: i, power

        extent = first_extent(self%wear%contact%equilibrium%profile, radius)
        power = merge(2, 1, is_pointed(self%wear))
        ! under a wall the pressure is infinite at first
        if (self%has_rings) power = merge(0, 1, extent > radius)
        do i = 1, 2
            call new_hats(self%hats(i), n*i/2, power, merge(0, most_waves, self%wear%contact%is_formula()), error)
            if (allocated(error)) return
            if (self%has_rings) then
                call make_seed(self%hats(i), radius, seed)
                seed%stays = .true.
                seed%extent = extent
            else
                call make_seed(self%hats(i), 0.9_wp*radius, seed)
            end if
            call one_step(self, i, seed, 0.0_wp, control, target, self%past%discs(i), unused, error)
            if (allocated(error)) return
        end do
    end subroutine begin

    pure subroutine check_target(control, target, error)
        integer, intent(in) :: control
        real(wp), intent(in) :: target
        type(error_t), allocatable, intent(inout) :: error

        call check_control(error, control)
        if (allocated(error)) return
        if (control == given_depth) then
            call check_positive(error, "depth", target)
        else
            call check_positive(error, "force", target)
        end if
    end subroutine check_target

    !> Raises for indenters whose pressure the hats cannot follow, and for those with a zeta: what wears is f(r), of which its depth
    !> knows nothing.
    subroutine check_indenter(wear, has_rings, error)
        type(wear_t), intent(in) :: wear
        logical, intent(in) :: has_rings
        type(error_t), allocatable, intent(inout) :: error

        if (wear%contact%equilibrium%has_zeta) then
            call raise(error, error_invalid, "zeta: it is not available with the wear of a sliding indenter. Omit it")
            return
        end if
        if (has_rings) return
        associate (profile => wear%contact%equilibrium%profile)
            if (profile%has_wall .and. profile%end_radius >= profile%largest_radius) then
                call raise(error, error_invalid, "scheme: a flat punch, whose edge pressure is infinite, needs the scheme "// &
                           "rings. Use it, or an indenter with a rounded edge")
            end if
        end associate
    end subroutine check_indenter

    !> Whether the slope does not vanish towards the axis, as the pressure of a paraboloid's contact needs to be finite there.
    pure function is_pointed(wear) result(answer)
        type(wear_t), intent(in) :: wear
        logical :: answer
        real(wp) :: r

        associate (profile => wear%contact%equilibrium%profile)
            r = min(1.0_wp, profile%largest_radius)
            do while (profile%height(r) > r)
                r = 0.5_wp*r
            end do
            answer = profile%slope(apex*r) > 0.1_wp*profile%slope(r)
        end associate
    end function is_pointed

    !> A disc that has seen nothing.
    subroutine make_seed(hats, radius, seed)
        type(hats_t), intent(in) :: hats
        real(wp), intent(in) :: radius
        type(disc_t), intent(out) :: seed

        seed%radius = radius
        seed%extent = radius
        seed%power = hats%power
        allocate (seed%pressure(0:hats%n), seed%load(0:hats%n), source=0.0_wp)
    end subroutine make_seed

    subroutine press(self, control, target, state, error)
        type(wear_history_t), intent(in), target :: self
        integer, intent(in) :: control
        real(wp), intent(in) :: target
        type(contact_state_t), intent(out) :: state
        type(error_t), allocatable, intent(inout) :: error
        type(contact_load_t) :: load

        if (control == given_depth) then
            call self%wear%contact%at_depth(target, state, error)
        else
            call self%wear%contact%at_force(target, state, error)
        end if
        ! rings that would pull do not touch
        if (allocated(error) .or. self%has_rings) return
        call self%wear%contact%load(state, load, error)
        if (.not. allocated(error)) call check_carries(load, error)
    end subroutine press

    subroutine find_modulus(self, error)
        type(wear_history_t), intent(inout) :: self
        type(error_t), allocatable, intent(inout) :: error

        associate (medium => self%wear%contact%equilibrium%medium)
            call check_springs(medium, "the wear of a sliding indenter is", error)
            if (.not. allocated(error)) self%modulus = medium%springs%modulus
        end associate
    end subroutine find_modulus

    !> The body wears too; its coating, if it has one, by a part of its thickness only.
    subroutine add_body(self, error)
        type(wear_history_t), intent(inout) :: self
        type(error_t), allocatable, intent(inout) :: error

        self%body_coefficient = self%wear%body_coefficient
        if (.not. self%body_coefficient > 0.0_wp) then
            call raise(error, error_invalid, "body_coefficient = 0: it must be greater than 0 for a body that wears")
            return
        end if
        call self%rate%add(self%body_coefficient)
        associate (medium => self%wear%contact%equilibrium%medium)
            if (.not. allocated(medium%pressed)) return
            if (medium%pressed%first_depth > 0.0_wp) self%thickness = medium%pressed%first_depth
        end associate
    end subroutine add_body

    !> Slides on by a distance, while depth or force goes evenly to its value at the end; after a failure all is as before.
    subroutine advance(self, sliding, control, target, error)
        class(wear_history_t), intent(inout) :: self
        !> >= 0 [length]
        real(wp), intent(in) :: sliding
        !> given_depth or given_force: what is given at the end
        integer, intent(in) :: control
        !> d from the original apex [length], or F [modulus length^2], > 0
        real(wp), intent(in) :: target
        type(error_t), allocatable, intent(out) :: error
        type(wear_past_t) :: past
        real(wp) :: from, done, middle, next

        call check_made(error, "history", self%is_made)
        if (allocated(error)) return
        call check_not_negative(error, "sliding", sliding)
        if (.not. allocated(error)) call check_target(control, target, error)
        if (.not. allocated(error)) call check_fits(self%hats, self%past, error)
        if (allocated(error)) return
        past = self%past
        from = merge(self%past%discs(2)%depth, self%past%discs(2)%force, control == given_depth)
        if (abs(from - target) <= unchanged*target) from = target
        if (.not. (sliding > 0.0_wp .or. abs(from - target) > 0.0_wp)) return
        call check_length(self, sliding, error)
        if (allocated(error)) return
        if (abs(from - target) > 0.0_wp) past%steady_from = past%sliding
        done = 0.0_wp
        do
            call check_cancelled(error)
            if (allocated(error)) exit
            call plan_step(self, past, control, sliding - done, middle, next)
            call pair_step(self, past, [middle, next], control, from + (target - from)*part(done + [middle, next], sliding), &
                           error)
            if (allocated(error)) exit
            done = done + next
            call report_progress(part(done, sliding))
            if (done >= sliding*(1.0_wp - epsilon(done))) exit
        end do
        if (allocated(error)) return
        past%sliding = self%past%sliding + sliding
        if (abs(from - target) > 0.0_wp) past%steady_from = past%sliding
        self%past = past
    end subroutine advance

    !> Raises for a distance under which a coated tip would take very many steps.
    subroutine check_length(self, sliding, error)
        class(wear_history_t), intent(in) :: self
        real(wp), intent(in) :: sliding
        type(error_t), allocatable, intent(inout) :: error
        real(wp) :: most

        most = farthest*self%past%discs(2)%radius/(self%modulus*maxval(self%rate%coefficients))
        if (sliding <= most .or. size(self%rate%coefficients) == 1) return
        call raise(error, error_domain, "sliding = "//to_text(sliding)//": it must be at most "//to_text(most)// &
                   " in one part of a path of a coated tip, "//to_text(farthest)// &
                   " contact radii over coefficient times contact modulus. Divide the path")
    end subroutine check_length

    !> Completed fraction of a distance.
    elemental function part(done, all) result(ratio)
        real(wp), intent(in) :: done, all
        real(wp) :: ratio

        ratio = 1.0_wp
        if (all > 0.0_wp) ratio = min(done/all, 1.0_wp)
    end function part

    !> The next step of the coarser disc, and where it is halved for the finer one.
    pure subroutine plan_step(self, past, control, left, middle, next)
        class(wear_history_t), intent(in) :: self
        type(wear_past_t), intent(in) :: past
        integer, intent(in) :: control
        !> distance that is left [length]
        real(wp), intent(in) :: left
        !> from here [length]
        real(wp), intent(out) :: middle, next
        real(wp) :: scale, here, there, early, longest, steady
        integer :: n

        n = self%hats(1)%n
        scale = past%discs(2)%radius/(self%modulus*maxval(self%rate%coefficients))
        here = past%sliding/scale
        early = (here**(1.0_wp/step_power) + 1.0_wp/real(n, wp))**step_power - here
        longest = longest_step*scale/real(n, wp)
        if (control == given_force .and. size(self%rate%coefficients) == 1) then
            steady = step_power*(past%sliding - past%steady_from)/real(n, wp)
            longest = max(longest, shrinking*past%last_step, min(steady, max(shrinking*left, last_part*steady)))
        end if
        next = min(scale*max(early, here*step_power/real(n, wp)), longest)
        if (next >= left*(1.0_wp - 1.0e-9_wp)) next = left
        if (left - next < 0.5_wp*next .and. next < left) next = 0.5_wp*left
        there = here + next/scale
        middle = scale*((0.5_wp*(here**(1.0_wp/step_power) + there**(1.0_wp/step_power)))**step_power - here)
        middle = min(max(middle, 0.25_wp*next), 0.75_wp*next)
    end subroutine plan_step

    !> One step of the coarser disc, two of the finer one.
    subroutine pair_step(self, past, distances, control, targets, error)
        class(wear_history_t), intent(in) :: self
        type(wear_past_t), intent(inout) :: past
        !> of the middle and the end from the beginning of the step
        real(wp), intent(in) :: distances(2)
        integer, intent(in) :: control
        real(wp), intent(in) :: targets(2)
        type(error_t), allocatable, intent(inout) :: error
        type(disc_t) :: coarse, middle, fine
        real(wp) :: works(3)

        call one_step(self, 1, past%discs(1), distances(2), control, targets(2), coarse, works(1), error)
        if (allocated(error)) return
        call one_step(self, 2, past%discs(2), distances(1), control, targets(1), middle, works(2), error)
        if (allocated(error)) return
        call one_step(self, 2, middle, distances(2) - distances(1), control, targets(2), fine, works(3), error)
        if (allocated(error)) return
        past%works = past%works + [works(1), works(2) + works(3)]
        past%sliding = past%sliding + distances(2)
        past%last_step = distances(2)
        past%discs(1) = coarse
        past%discs(2) = fine
    end subroutine pair_step

    subroutine one_step(self, level, disc, sliding, control, target, next, work, error)
        class(wear_history_t), intent(in) :: self
        integer, intent(in) :: level, control
        type(disc_t), intent(in) :: disc
        real(wp), intent(in) :: sliding, target
        type(disc_t), intent(out) :: next
        !> int F ds [modulus length^3]
        real(wp), intent(out) :: work
        type(error_t), allocatable, intent(inout) :: error

        associate (equilibrium => self%wear%contact%equilibrium)
            if (self%has_rings) then
                call step_rings(self%hats(level), equilibrium%medium, equilibrium%profile, self%rate, disc, sliding, &
                                control == given_depth, target, next, work, error)
            else
                call step_disc(self%hats(level), equilibrium%medium, equilibrium%profile, self%rate, disc, sliding, &
                               control == given_depth, target, next, work, error)
            end if
        end associate
        if (allocated(error)) return
        if (lowest(next%pressure) < -noticeable*next%force/(pi*next%radius**2)) then
            call raise(error, error_domain, "the worn contact is no longer a single area: its pressure would be "// &
                       to_text(lowest(next%pressure))//" somewhere (contact radius "//to_text(next%radius)// &
                       "). Use the scheme rings, or another number of intervals")
        else if (self%body_coefficient*maxval(next%load) > deepest_loss*self%thickness) then
            call raise(error, error_domain, "the coating would lose "//to_text(self%body_coefficient*maxval(next%load))// &
                       " of its thickness "//to_text(self%thickness)//": the layers are treated as unworn, which is valid up "// &
                       "to a quarter of it")
        end if
    end subroutine one_step

    !> The lowest pressure but for hats that overshoot in turn, as they do where a coating of the indenter ends and the pressure
    !> jumps.
    pure function lowest(pressure) result(value)
        real(wp), intent(in) :: pressure(0:)
        real(wp) :: value
        integer :: n

        n = ubound(pressure, 1)
        value = minval(0.25_wp*pressure(:n - 2) + 0.5_wp*pressure(1:n - 1) + 0.25_wp*pressure(2:))
    end function lowest

    !> Its current state.
    subroutine state(self, now)
        class(wear_history_t), intent(in) :: self
        type(wear_state_t), intent(out) :: now
        real(wp) :: values(8, 2), best(8)
        integer :: i

        if (.not. self%is_made) return
        do i = 1, 2
            associate (disc => self%past%discs(i))
                values(:5, i) = [disc%depth, disc%radius, disc%force, disc%pressure(0), self%rate%worn_depth(disc%load(0))]
                call worn_volume(self%hats(i), self%rate, disc, values(6, i))
                values(7, i) = self%body_coefficient*disc%load(0)
                call loaded_volume(self%hats(i), disc, values(8, i))
            end associate
        end do
        values(8, :) = self%body_coefficient*values(8, :)
        best = values(:, 2)
        if (.not. self%has_rings) best = best + (values(:, 2) - values(:, 1))/3.0_wp
        now%sliding = self%past%sliding
        now%depth = best(1)
        now%radius = best(2)
        now%force = best(3)
        now%pressure = best(4)
        now%worn_depth = best(5) - best(7)
        now%worn_volume = best(6) - best(8)
        now%body_depth = best(7)
        now%body_volume = best(8)
        now%work = self%past%works(2)
        now%error = maxval(abs(values(:4, 2) - values(:4, 1))/abs(best(:4)))
        associate (disc => self%past%discs(2))
            ! the edge lies within a ring
            if (disc%extent > disc%radius) now%error = max(now%error, disc%extent/(real(self%hats(2)%n, wp)*disc%radius))
        end associate
        if (best(5) > 0.0_wp) now%error = max(now%error, abs(values(5, 2) - values(5, 1))/best(5))
        if (self%has_rings) now%error = first_order*now%error
    end subroutine state

    !> int int p ds 2 pi r dr.
    subroutine loaded_volume(hats, disc, volume)
        type(hats_t), intent(in) :: hats
        type(disc_t), intent(in) :: disc
        real(wp), intent(out) :: volume
        type(wear_history_on_disc_t) :: on_disc
        real(wp), dimension(size(hats%radii, 1), size(hats%radii, 2)) :: load, pressure

        call new_wear_history_on_disc(on_disc, disc)
        call on_disc%at(disc%extent*hats%radii, load, pressure)
        volume = sum(hats%weights*load)*disc%extent**2
    end subroutine loaded_volume

    !> The indenter as it is now, for contacts with it, whose depth counts from its new apex; of the gap, where both wear.
    subroutine worn_profile(self, profile, error)
        class(wear_history_t), intent(in) :: self
        type(worn_profile_t), allocatable, intent(out) :: profile
        type(error_t), allocatable, intent(out) :: error
        real(wp), dimension(0:self%hats(2)%n) :: load, other, unused, depths, slopes
        type(wear_history_on_disc_t) :: on_disc
        real(wp) :: radius
        integer :: i, n

        call check_made(error, "history", self%is_made)
        if (allocated(error)) return
        n = self%hats(2)%n
        allocate (profile)
        associate (coarse => self%past%discs(1), fine => self%past%discs(2))
            call new_wear_history_on_disc(on_disc, coarse)
            load = fine%load
            radius = fine%extent
            if (.not. self%has_rings) then
                call on_disc%at(coarse%radius*self%hats(2)%nodes, other, unused)
                radius = fine%radius + (fine%radius - coarse%radius)/3.0_wp
                load = max(fine%load + (fine%load - other)/3.0_wp, 0.0_wp)
                load(n) = 0.0_wp
            end if
        end associate
        depths = self%rate%worn_depth(load)
        slopes(0) = 0.0_wp
        slopes(n) = infinity
        do i = 1, n - 1
            slopes(i) = slope_at(radius*self%hats(2)%nodes(i - 1:i + 1), depths(i - 1:i + 1))
        end do
        call new_worn_profile(profile, self%wear%contact%equilibrium%profile, radius*self%hats(2)%nodes, depths, slopes, error)
    end subroutine worn_profile

    !> The slope at the middle of three points, by the parabola through them.
    pure function slope_at(x, y) result(slope)
        real(wp), intent(in) :: x(3), y(3)
        real(wp) :: slope
        real(wp) :: before, after

        before = (y(2) - y(1))/(x(2) - x(1))
        after = (y(3) - y(2))/(x(3) - x(2))
        slope = (before*(x(3) - x(2)) + after*(x(2) - x(1)))/(x(3) - x(1))
    end function slope_at

    !> p(r) by the finer disc, 0 outside.
    subroutine pressure(self, r, values, error)
        class(wear_history_t), intent(in) :: self
        !> >= 0 [length]
        real(wp), intent(in) :: r(:)
        !> same size as r [modulus]
        real(wp), intent(out) :: values(:)
        type(error_t), allocatable, intent(out) :: error
        type(wear_history_on_disc_t) :: on_disc
        real(wp) :: load(size(r))
        integer :: i

        values = 0.0_wp
        call check_made(error, "history", self%is_made)
        if (allocated(error)) return
        do i = 1, size(r)
            call check_not_negative(error, "r", r(i), i)
        end do
        if (allocated(error)) return
        call new_wear_history_on_disc(on_disc, self%past%discs(2))
        call on_disc%at(r, load, values)
    end subroutine pressure

    !> Size of a saved past.
    pure function saved_size(self) result(count)
        class(wear_history_t), intent(in) :: self
        integer :: count

        count = past_size(self%hats)
    end function saved_size

    !> The past as numbers, from which another history of the same contact continues with bitwise identical results.
    pure subroutine save(self, numbers)
        class(wear_history_t), intent(in) :: self
        !> of saved_size()
        real(wp), intent(out) :: numbers(:)

        call save_past(self%past, self%has_rings, numbers)
    end subroutine save

    !> Continues from saved numbers; after a failure all is as before.
    subroutine restore(self, numbers, error)
        class(wear_history_t), intent(inout), target :: self
        !> by save(), of a history of the same contact with as many intervals
        real(wp), intent(in) :: numbers(:)
        type(error_t), allocatable, intent(out) :: error
        type(wear_past_t) :: past

        call check_made(error, "history", self%is_made)
        if (allocated(error)) return
        past = self%past
        call read_past(wearing(self), numbers, past, error)
        if (.not. allocated(error)) self%past = past
    end subroutine restore

    !> What wears, for its past.
    function wearing(self) result(of)
        class(wear_history_t), intent(in), target :: self
        type(wearing_t) :: of

        of%contact => self%wear%contact
        of%hats => self%hats
        of%rate => self%rate
        of%has_rings = self%has_rings
        of%body_coefficient = self%body_coefficient
        of%deepest = deepest_loss*min(self%thickness, huge(self%thickness))
    end function wearing

end module mdrcontact_wear_history
