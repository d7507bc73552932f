! SPDX-License-Identifier: GPL-3.0-or-later
!> The past of a worn contact as numbers, and whether numbers are a past: of this contact, and one that wear leaves.
!>
!> Numbers of another contact differ in the first state under load, that is its depth, radius, force and stiffness, in heights of
!> the indenter around it, or in wear coefficients. Altered numbers differ from their checksum, the last number. Numbers that were
!> forged with their checksum violate what holds in each state (theory/wear.md (5.2)): the force is the integral of the pressure,
!> S p + f + W is the depth at each hat in contact, and int p ds over the disc is the work of the force.
module mdrcontact_wear_past
    use mdrcontact_contact, only: contact_t
    use mdrcontact_contact_state, only: contact_state_t
    use mdrcontact_crc32, only: mark_of
    use mdrcontact_error, only: count_text, error_invalid, error_t, raise
    use mdrcontact_kinds, only: pi, wp
    use mdrcontact_nonfinite, only: is_finite
    use mdrcontact_medium_hats, only: hats_t, line_compliance
    use mdrcontact_wear_history_on_disc, only: disc_t, wear_history_on_disc_t, new_wear_history_on_disc
    use mdrcontact_wear_rate, only: wear_rate_t
    implicit none (type, external)
    private
    public :: check_fits, find_mark, past_size, read_past, save_past, wear_past_t, wearing_t

    !> Radii around the first one at which the heights of the indenter identify it.
    real(wp), parameter :: around(*) = [0.25_wp, 0.5_wp, 1.0_wp, 2.0_wp, 4.0_wp, 8.0_wp]
    !> Numbers that identify a contact: the first state, the surface of the bodies, three for the wear of both sides, and heights.
    integer, parameter :: of_state = 4, of_wear = 7, marks = of_state + of_wear + size(around)
    !> Numbers of a saved past before those of the contact, and of each disc before its pressures.
    integer, parameter :: saved_numbers = 7, saved_of_disc = 6
    !> Relative deviation of two contacts that are the same: the same numbers on another machine.
    real(wp), parameter :: same = 1.0e-6_wp
    !> Relative residual of a sum of products. The schemes have up to 0.4 of the depth and 0.4 of the work, with 16 intervals
    !> under a flat end or an edge; these limits reject only numbers of another order of magnitude.
    real(wp), parameter :: rounding = 1.0e-6_wp, of_depth = 1.0_wp, of_work = 0.75_wp
    !> Pressures and loads below minus so many times the mean pressure and the largest load are not errors of the hats, which
    !> overshoot where a coating or a flat end ends: by 6 and 0.07.
    real(wp), parameter :: lowest_pressure = 100.0_wp, lowest_load = 0.5_wp
    !> Ratio of the depths of the two resolutions beyond which they are not those of one contact; 1.3 occurs.
    real(wp), parameter :: most_apart = 3.0_wp

    !> Record of the past: the discs of n/2 and of n intervals.
    type :: wear_past_t
        !> s since the beginning [length], and int F ds of both discs [modulus length^3]
        real(wp) :: sliding = 0.0_wp, works(2) = 0.0_wp
        !> s at which the target last began to change or ceased to [length]
        real(wp) :: steady_from = 0.0_wp
        !> of the coarser disc [length]
        real(wp) :: last_step = 0.0_wp
        !> of n/2 and of n intervals
        type(disc_t) :: discs(2)
        !> what identifies the contact, by its first depth
        real(wp) :: mark(marks) = 0.0_wp
    end type wear_past_t

    !> What wears, and how it is resolved.
    type :: wearing_t
        type(contact_t), pointer :: contact => null()
        type(hats_t), pointer :: hats(:) => null()
        !> of the indenter, and of both where the body wears at the same places
        type(wear_rate_t), pointer :: rate => null()
        logical :: has_rings = .false.
        !> k of the body where it wears, else 0 [1/modulus], and its largest wear [length]
        real(wp) :: body_coefficient = 0.0_wp, deepest = 0.0_wp
    end type wearing_t

contains

    !> What identifies a contact: numbers by its first depth, which unlike a radius determines a state at a wall too.
    subroutine find_mark(of, depth, mark, error)
        type(wearing_t), intent(in) :: of
        !> [length]
        real(wp), intent(in) :: depth
        real(wp), intent(out) :: mark(marks)
        type(error_t), allocatable, intent(inout) :: error
        type(contact_state_t) :: state
        real(wp) :: r
        integer :: i

        mark = 0.0_wp
        call of%contact%at_depth(depth, state, error)
        if (allocated(error)) return
        associate (profile => of%contact%equilibrium%profile, springs => of%contact%equilibrium%medium%springs, k => of%rate)
            mark(:of_state) = [state%depth, state%radius, state%force, state%stiffness]
            mark(of_state + 1:of_state + of_wear) = &
                [springs%modulus, springs%kernel%unit, real(size(k%coefficients), wp), k%coefficients(1), &
                 k%coefficients(size(k%coefficients)), sum(k%starts) + sum(k%coefficients), of%body_coefficient]
            do i = 1, size(around)
                r = around(i)*state%radius
                if (r < profile%largest_radius) mark(of_state + of_wear + i) = profile%height(r)
            end do
        end associate
        where (.not. is_finite(mark)) mark = 0.0_wp
    end subroutine find_mark

    !> How many numbers a saved past has.
    pure function past_size(hats) result(count)
        type(hats_t), intent(in) :: hats(2)
        integer :: count

        count = saved_numbers + marks + 2*(hats(1)%n + hats(2)%n + saved_of_disc + 2) + 1
    end function past_size

    !> The past as numbers.
    pure subroutine save_past(past, has_rings, numbers)
        type(wear_past_t), intent(in) :: past
        logical, intent(in) :: has_rings
        !> of past_size()
        real(wp), intent(out) :: numbers(:)
        integer :: i, n, at

        numbers(:saved_numbers) = [real(ubound(past%discs(2)%load, 1), wp), past%sliding, past%works, past%steady_from, &
                                   past%last_step, merge(1.0_wp, 0.0_wp, has_rings)]
        numbers(saved_numbers + 1:saved_numbers + marks) = past%mark
        at = saved_numbers + marks
        do i = 1, 2
            associate (disc => past%discs(i))
                n = size(disc%load)
                numbers(at + 1:at + saved_of_disc) = [disc%radius, disc%depth, disc%force, disc%extent, disc%growth, disc%response]
                at = at + saved_of_disc
                numbers(at + 1:at + n) = disc%pressure
                numbers(at + n + 1:at + 2*n) = disc%load
                at = at + 2*n
            end associate
        end do
        numbers(at + 1) = mark_of(numbers(:at))
    end subroutine save_past

    !> The past in saved numbers; raises unless they are a past of what wears.
    subroutine read_past(of, numbers, past, error)
        type(wearing_t), intent(in) :: of
        real(wp), intent(in) :: numbers(:)
        !> of the same intervals and scheme; receives the past
        type(wear_past_t), intent(inout) :: past
        type(error_t), allocatable, intent(inout) :: error
        integer :: i, n, at

        if (size(numbers) /= past_size(of%hats) .or. .not. all(is_finite(numbers))) then
            call raise(error, error_invalid, "numbers: they do not belong to a history of this contact. There must be "// &
                       count_text(past_size(of%hats))//" finite ones, saved by a history with "//count_text(of%hats(2)%n)// &
                       " intervals")
            return
        end if
        if (any(abs(numbers([1, saved_numbers]) - [real(of%hats(2)%n, wp), merge(1.0_wp, 0.0_wp, of%has_rings)]) > 0.0_wp)) then
            call raise(error, error_invalid, "numbers: they do not belong to a history of this contact. Their intervals or "// &
                       "their scheme differ")
            return
        end if
        at = size(numbers) - 1
        if (abs(numbers(at + 1) - mark_of(numbers(:at))) > 0.0_wp) then
            call raise(error, error_invalid, "numbers: they are not as they were saved. Their checksum differs")
            return
        end if
        past%sliding = numbers(2)
        past%works = numbers(3:4)
        past%steady_from = numbers(5)
        past%last_step = numbers(6)
        past%mark = numbers(saved_numbers + 1:saved_numbers + marks)
        at = saved_numbers + marks
        do i = 1, 2
            associate (disc => past%discs(i))
                n = of%hats(i)%n + 1
                disc%radius = numbers(at + 1)
                disc%depth = numbers(at + 2)
                disc%force = numbers(at + 3)
                disc%extent = numbers(at + 4)
                disc%growth = numbers(at + 5)
                disc%response = numbers(at + 6)
                at = at + saved_of_disc
                disc%pressure(:) = numbers(at + 1:at + n)
                disc%load(:) = numbers(at + n + 1:at + 2*n)
                at = at + 2*n
            end associate
        end do
        call check_contact(of, past, error)
        if (.not. allocated(error)) call check_past(of, past, error)
    end subroutine read_past

    !> Raises unless a past has the arrays of a history.
    pure subroutine check_fits(hats, past, error)
        type(hats_t), intent(in) :: hats(2)
        type(wear_past_t), intent(in) :: past
        type(error_t), allocatable, intent(inout) :: error
        logical :: fits
        integer :: i

        fits = .true.
        do i = 1, 2
            fits = fits .and. allocated(past%discs(i)%load) .and. allocated(past%discs(i)%pressure)
            if (fits) fits = size(past%discs(i)%load) == hats(i)%n + 1 .and. size(past%discs(i)%pressure) == hats(i)%n + 1
        end do
        if (.not. fits) call raise(error, error_invalid, "past: it does not belong to a history with as many intervals")
    end subroutine check_fits

    !> Raises unless a past is one of the contact that wears.
    subroutine check_contact(of, past, error)
        type(wearing_t), intent(in) :: of
        type(wear_past_t), intent(in) :: past
        type(error_t), allocatable, intent(inout) :: error
        type(error_t), allocatable :: found
        real(wp) :: mark(marks)

        mark = 0.0_wp
        if (past%mark(1) > 0.0_wp) call find_mark(of, past%mark(1), mark, found)
        if (.not. allocated(found) .and. past%mark(1) > 0.0_wp) then
            if (all(abs(mark - past%mark) <= same*abs(mark))) return
        end if
        call raise(error, error_invalid, "numbers: they do not belong to a history of this contact. Another indenter, medium, "// &
                   "wear coefficient or thickness saved them")
    end subroutine check_contact

    !> Raises unless wear can leave a past.
    subroutine check_past(of, past, error)
        type(wearing_t), intent(in) :: of
        type(wear_past_t), intent(in) :: past
        type(error_t), allocatable, intent(inout) :: error
        real(wp) :: depths(2)
        logical :: valid
        integer :: i

        valid = min(past%sliding, minval(past%works), past%steady_from, past%last_step) >= 0.0_wp .and. &
                max(past%steady_from, past%last_step) <= past%sliding*(1.0_wp + rounding)
        do i = 1, 2
            if (valid) valid = is_in_range(of, of%hats(i), past%discs(i))
            if (valid) call balance(of, of%hats(i), past%discs(i), past%works(i), valid, error)
            if (allocated(error)) return
        end do
        depths = past%discs%depth
        valid = valid .and. maxval(depths) <= most_apart*minval(depths)
        if (.not. valid) call raise(error, error_invalid, "numbers: they are not the past of a contact that wears. Give the "// &
                                    "numbers as they were saved")
    end subroutine check_past

    !> Whether each number of a disc has a value that occurs, and its force is that of its pressures.
    pure function is_in_range(of, hats, disc) result(valid)
        type(wearing_t), intent(in) :: of
        type(hats_t), intent(in) :: hats
        type(disc_t), intent(in) :: disc
        logical :: valid
        real(wp) :: force

        associate (largest => of%contact%equilibrium%profile%largest_radius)
            valid = min(disc%radius, disc%depth, disc%force, disc%response) > 0.0_wp .and. disc%growth >= 0.0_wp .and. &
                    disc%radius*(1.0_wp - rounding) <= largest .and. disc%extent >= disc%radius*(1.0_wp - rounding) .and. &
                    0.5_wp*disc%extent <= largest
        end associate
        if (.not. of%has_rings) valid = valid .and. .not. (disc%extent > disc%radius .or. abs(disc%pressure(hats%n)) > 0.0_wp &
                                                           .or. abs(disc%load(hats%n)) > 0.0_wp)
        if (.not. valid) return
        force = dot_product(hats%areas, disc%pressure)*disc%extent**2
        valid = abs(force - disc%force) <= rounding*disc%force .and. &
                minval(disc%pressure) >= -lowest_pressure*disc%force/(pi*disc%radius**2) .and. &
                minval(disc%load) >= -lowest_load*maxval(disc%load) .and. &
                of%body_coefficient*maxval(disc%load) <= of%deepest
    end function is_in_range

    !> Whether the surfaces touch at each hat that has pressure, and the work of the force is that of the pressure.
    subroutine balance(of, hats, disc, work, valid, error)
        type(wearing_t), intent(in) :: of
        type(hats_t), intent(in) :: hats
        type(disc_t), intent(in) :: disc
        real(wp), intent(in) :: work
        logical, intent(out) :: valid
        type(error_t), allocatable, intent(inout) :: error
        real(wp) :: matrix(0:hats%n, 0:hats%n), depths(0:hats%n), areas(0:hats%n), modulus, total
        type(wear_history_on_disc_t) :: on_disc
        real(wp), dimension(size(hats%radii, 1), size(hats%radii, 2)) :: load, pressure, gap
        integer :: c

        valid = .false.
        call line_compliance(hats, of%contact%equilibrium%medium, disc%extent, matrix, modulus, error)
        if (allocated(error)) return
        call new_wear_history_on_disc(on_disc, disc)
        call on_disc%at(disc%extent*hats%radii, load, pressure)
        gap = 0.0_wp
        where (disc%extent*hats%radii < of%contact%equilibrium%profile%largest_radius)
            gap = of%contact%equilibrium%profile%height(disc%extent*hats%radii) + of%rate%worn_depth(max(load, 0.0_wp))
        end where
        areas = hats%areas*disc%extent**2
        depths = matmul(matrix, disc%pressure)
        do c = 1, hats%n
            associate (part => hats%weights(:, c)*disc%extent**2*gap(:, c), up => hats%rising(:, c))
                depths(c - 1) = depths(c - 1) + sum(part*(1.0_wp - up))
                depths(c) = depths(c) + sum(part*up)
            end associate
        end do
        total = sum(hats%weights*load)*disc%extent**2
        where (disc%pressure > 0.0_wp .or. .not. of%has_rings)
            depths = depths - areas*disc%depth
        else where
            depths = 0.0_wp
        end where
        valid = all(abs(depths) <= of_depth*areas*disc%depth) .and. abs(total - work) <= of_work*max(work, total)
    end subroutine balance

end module mdrcontact_wear_past
