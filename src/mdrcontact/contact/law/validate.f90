! SPDX-License-Identifier: GPL-3.0-or-later
!> Whether the numbers of a file are those of a contact: a checksum finds damage, not what was written on purpose.
module mdrcontact_law_validate
    use mdrcontact_kinds, only: wp
    use mdrcontact_law, only: contact_law_t
    use mdrcontact_law_friction, only: friction_law_t
    use mdrcontact_law_interval, only: coefficient_count, in_units_of, interval_t, panel_count, panel_ends, polynomial, row_t
    use mdrcontact_law_table, only: fewest_roots, law_table_t, table_segment_t
    implicit none (type, external)
    private
    public :: is_valid

    !> Largest relative mismatch of a value between two panels or two intervals.
    real(wp), parameter :: rounding = 1.0e-6_wp
    !> How negative a polynomial that begins at 0 may be, relative to its largest value.
    real(wp), parameter :: last_digits = 64.0_wp*epsilon(1.0_wp)

contains

    !> Whether both tables of a law describe the same kind of contact, with contact radii and stiffnesses that are nowhere negative.
    pure function is_valid(law) result(valid)
        type(contact_law_t), intent(in) :: law
        logical :: valid

        valid = law%tolerance > 0.0_wp .and. law%error >= 0.0_wp .and. law%by_depth%by_depth .and. .not. law%by_force%by_depth &
                .and. (law%by_depth%adhesive .eqv. law%by_force%adhesive) .and. law%by_depth%roots == law%by_force%roots
        if (valid) valid = is_valid_table(law%by_depth)
        if (valid) valid = is_valid_table(law%by_force)
        if (valid .and. allocated(law%friction)) valid = is_valid_friction(law%friction)
    end function is_valid

    !> Whether the tables of a law's sliders are those of a shift without adhesion.
    pure function is_valid_friction(friction) result(valid)
        type(friction_law_t), intent(in) :: friction
        logical :: valid

        if (max(friction%shear_strength, friction%cubic) > 0.0_wp) then
            associate (radii => friction%radii)
                valid = (friction%coefficient > 0.0_wp .eqv. friction%cubic > 0.0_wp) .and. friction%coefficient < huge(1.0_wp) &
                        .and. friction%modulus > 0.0_wp .and. friction%modulus < huge(1.0_wp) .and. &
                        max(friction%shear_strength, friction%cubic) < huge(1.0_wp) .and. radii(1) > 0.0_wp .and. &
                        radii(2) > radii(1) .and. radii(2) < huge(1.0_wp)
            end associate
            return
        end if
        valid = friction%coefficient > 0.0_wp .and. friction%by_shift%by_depth .and. .not. friction%by_force%by_depth .and. &
                .not. friction%by_shift%adhesive .and. .not. friction%by_force%adhesive
        if (valid) valid = is_valid_table(friction%by_shift)
        if (valid) valid = is_valid_table(friction%by_force)
    end function is_valid_friction

    pure function is_valid_table(table) result(valid)
        type(law_table_t), intent(in) :: table
        logical :: valid
        integer :: i

        valid = table%end_radius >= 0.0_wp .and. table%lowest < table%highest .and. table%first_attraction <= 0.0_wp
        if (.not. table%adhesive) then
            ! below the range
            valid = valid .and. table%lowest > 0.0_wp .and. all(table%end_values >= 0.0_wp) .and. all(table%powers >= -rounding)
            if (table%roots > 0) valid = valid .and. has_roots(table)
        end if
        valid = valid .and. minval(table%segments%lowest) <= table%lowest .and. maxval(table%segments%highest) >= table%highest
        do i = 1, size(table%segments)
            if (valid) valid = is_valid_segment(table, table%segments(i))
        end do
    end function is_valid_table

    !> Whether F grows with the root of d below the range.
    pure function has_roots(table) result(valid)
        type(law_table_t), intent(in) :: table
        logical :: valid
        real(wp) :: power

        power = table%powers(1)
        if (.not. table%by_depth) power = 1.0_wp/max(power, rounding)
        valid = table%roots >= fewest_roots .and. abs(2.0_wp*power - table%roots) <= 0.5_wp + rounding
    end function has_roots

    !> Whether the intervals of a segment follow each other and the contact radius grows along them.
    pure function is_valid_segment(table, segment) result(valid)
        type(law_table_t), intent(in) :: table
        type(table_segment_t), intent(in) :: segment
        logical :: valid
        real(wp) :: radius, low, high, s, span
        integer :: i, panel, count

        s = segment%lowest
        span = segment%highest - segment%lowest
        valid = segment%lowest >= table%lowest .and. segment%highest <= table%highest .and. span > 0.0_wp
        radius = table%end_radius*(1.0_wp - rounding)
        do i = segment%first, segment%last
            associate (interval => table%intervals(i))
                valid = valid .and. abs(interval%lowest - s) <= rounding*span .and. interval%highest > interval%lowest
                s = interval%highest
                count = panel_count(interval)
                do panel = 1, count
                    call check_panel(table, interval, merge(panel, count + 1 - panel, interval%side > 0.0_wp), low, high, valid)
                    valid = valid .and. low >= radius*(1.0_wp - rounding) .and. high >= low*(1.0_wp - rounding)
                    radius = high
                end do
            end associate
        end do
        valid = valid .and. abs(segment%highest - s) <= rounding*span
    end function is_valid_segment

    !> a at both ends of a panel, by ascending s, and whether a and k are nowhere negative in between.
    pure subroutine check_panel(table, interval, panel, low, high, valid)
        type(law_table_t), intent(in) :: table
        type(interval_t), intent(in) :: interval
        integer, intent(in) :: panel
        real(wp), intent(out) :: low, high
        logical, intent(inout) :: valid
        real(wp) :: ends(2), radius(coefficient_count), unit

        ends = panel_ends(interval, panel)
        unit = 2.0_wp/(ends(2) - ends(1))
        associate (rows => table%contact(interval%first_panel + panel))
            radius = in_units_of(rows%radius%c, unit)
            if (valid) valid = is_positive(radius) .and. is_positive(in_units_of(rows%stiffness%c, unit))
        end associate
        low = polynomial(radius, -sign(1.0_wp, interval%side))
        high = polynomial(radius, sign(1.0_wp, interval%side))
    end subroutine check_panel

    !> Whether a polynomial is nowhere negative on -1 <= t <= 1 but for rounding, as at touch: its Bernstein coefficients, whose
    !> hull contains it, are not.
    pure function is_positive(c) result(positive)
        real(wp), intent(in) :: c(coefficient_count)
        logical :: positive
        integer, parameter :: degree = coefficient_count - 1
        real(wp) :: b(0:degree), binomial
        integer :: i, k

        b = c
        do i = 0, degree - 1 ! in powers of x = 1 + t, by repeated division
            do k = degree - 1, i, -1
                b(k) = b(k) - b(k + 1)
            end do
        end do
        binomial = 1.0_wp
        do i = 1, degree ! x = 2 y, 0 <= y <= 1, each power divided by its binomial coefficient
            binomial = binomial*(degree + 1 - i)/i
            b(i) = b(i)*2.0_wp**i/binomial
        end do
        do i = 1, degree ! b_j = sum over i of binomial(j, i) of them: differences undone
            do k = degree, i, -1
                b(k) = b(k) + b(k - 1)
            end do
        end do
        positive = all(b >= -last_digits*maxval(abs(b)))
    end function is_positive

end module mdrcontact_law_validate
