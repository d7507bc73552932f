! SPDX-License-Identifier: GPL-3.0-or-later
!> From sampled equilibria to the polynomials of a law: cuts the branch into intervals, fits the panels.
module mdrcontact_law_compile
    use mdrcontact_cancel, only: check_cancelled
    use mdrcontact_contact_control, only: control_t, depth_control, force_control
    use mdrcontact_contact_samples, only: curve_point_t, samples_t
    use mdrcontact_error, only: error_no_convergence, error_t, raise, to_text
    use mdrcontact_kinds, only: pi, wp
    use mdrcontact_law_interval, only: coefficient_count, column_count, in_units_of, interval_t, most_bits, new_interval, &
                                      panel_count, panel_ends, polynomial, row_t, u_of_y
    use mdrcontact_law_table, only: add_energies, contact_rows_t, fewest_roots, find_direct, law_table_t, most_roots, &
                                    table_segment_t, values_in
    use mdrcontact_numerics_scalar_function, only: scalar_function_t
    implicit none (type, external)
    private
    public :: piece_t, compile_pieces, compile_straight, control_of, interpolating, open_table, close_table

    !> A part of the branch in which s grows with x, from one coordinate to the next.
    type :: piece_t
        real(wp) :: first = 0.0_wp, last = 0.0_wp
        !> s has an extremum, or the branch a break, at the first end; an extremum at the last
        logical :: singular_first = .false., fold_last = .false.
        !> F and its slope are 0 at the first end: where the bodies begin to attract each other
        logical :: from_nothing = .false.
    end type piece_t

    !> The column of G, where there is one.
    integer, parameter :: conductance_column = column_count + 1
    !> Panels close to a singular end begin this part of the root of s there away from it.
    real(wp), parameter :: singular_scale = 0.5_wp
    !> and those in which F grows from 0, or that do not fit otherwise, this part of it.
    real(wp), parameter :: small_scale = 1.0e-3_wp
    !> Accuracy of F and the other quantities there, relative to their value at the other end.
    real(wp), parameter :: rounding = 16.0_wp*epsilon(1.0_wp)
    !> A series of roots with a smaller second term is a power.
    real(wp), parameter :: smallest_bend = 1.0e-6_wp

contains

    !> An empty table.
    subroutine open_table(table, by_depth, adhesive, end_radius)
        type(law_table_t), intent(out) :: table
        logical, intent(in) :: by_depth, adhesive
        real(wp), intent(in) :: end_radius

        table%by_depth = by_depth
        table%adhesive = adhesive
        table%end_radius = end_radius
        table%lowest = huge(1.0_wp)
        table%highest = -huge(1.0_wp)
        allocate (table%segments(0), table%intervals(0), table%other(0), table%contact(0))
    end subroutine open_table

    !> Adds one segment, given as its pieces by ascending radius.
    subroutine compile_pieces(table, curve, pieces, tolerance, error, conductance)
        type(law_table_t), intent(inout) :: table
        class(samples_t), intent(in) :: curve
        type(piece_t), intent(in) :: pieces(:)
        real(wp), intent(in) :: tolerance
        type(error_t), allocatable, intent(out) :: error
        !> G(a), for a law that conducts
        class(scalar_function_t), intent(inout), optional :: conductance
        real(wp) :: low, high, middle
        integer :: i, first

        first = size(table%intervals) + 1
        do i = 1, size(pieces)
            low = curve_value(table, curve, pieces(i)%first)
            high = curve_value(table, curve, pieces(i)%last)
            if (pieces(i)%fold_last) then
                middle = 0.5_wp*(low + high)
                call compile_interval(table, curve, pieces(i), low, 1.0_wp, .true., [0.0_wp, middle - low], tolerance, error, &
                                      conductance)
                if (allocated(error)) return
                call compile_interval(table, curve, pieces(i), high, -1.0_wp, .true., [0.0_wp, high - middle], tolerance, error, &
                                      conductance)
            else if (pieces(i)%singular_first) then
                call compile_interval(table, curve, pieces(i), low, 1.0_wp, .true., [0.0_wp, high - low], tolerance, error, &
                                      conductance)
            else
                call compile_interval(table, curve, pieces(i), 0.0_wp, 1.0_wp, .false., [low, high], tolerance, error, conductance)
            end if
            if (allocated(error)) return
        end do
        call add_segment(table, first)
    end subroutine compile_pieces

    !> Adds a segment on which the radius and hence the stiffness stay: a flat punch, F = k d.
    subroutine compile_straight(table, radius, stiffness, low, high, conductance)
        type(law_table_t), intent(inout) :: table
        real(wp), intent(in) :: radius, stiffness, low, high
        !> G(a), for a law that conducts
        class(scalar_function_t), intent(inout), optional :: conductance
        type(interval_t) :: interval
        real(wp) :: ends(2), s(2), other(2)
        real(wp), allocatable :: coefficients(:, :, :)
        integer :: panel, first

        first = size(table%intervals) + 1
        interval = new_interval(low, 1.0_wp, .false., 0.0_wp, high - low, 1.0_wp, 0)
        interval%first_panel = size(table%other)
        allocate (coefficients(coefficient_count, columns_of(conductance), panel_count(interval)), source=0.0_wp)
        if (present(conductance)) coefficients(1, conductance_column, :) = conductance%value(radius)
        do panel = 1, size(coefficients, 3)
            ends = panel_ends(interval, panel)
            s = [u_of_y(interval, ends(1)), u_of_y(interval, ends(2))]
            other = s*merge(stiffness, 1.0_wp/stiffness, table%by_depth)
            coefficients(1, :column_count, panel) = [0.5_wp*(other(1) + other(2)), radius, stiffness]
            coefficients(2, 1, panel) = 0.5_wp*(other(2) - other(1))
        end do
        call append(table, interval, coefficients)
        call add_segment(table, first)
    end subroutine compile_straight

    subroutine add_segment(table, first)
        type(law_table_t), intent(inout) :: table
        integer, intent(in) :: first
        integer :: last

        last = size(table%intervals)
        table%segments = [table%segments, &
                          table_segment_t(table%intervals(first)%lowest, table%intervals(last)%highest, first, last)]
        table%lowest = min(table%lowest, table%intervals(first)%lowest)
        table%highest = max(table%highest, table%intervals(last)%highest)
    end subroutine add_segment

    !> Quantities derived from the polynomials.
    subroutine close_table(table)
        type(law_table_t), intent(inout) :: table

        if (.not. table%adhesive) call continue_below(table)
        if (table%by_depth) call add_energies(table)
        call find_direct(table)
    end subroutine close_table

    !> Continuation of a table without adhesion below its range with the same value and slope: powers of s; or, where the power of F
    !> changes along the range as it does if s^(1/2) or s of a series is the cause, as on coated bodies, a series of two terms.
    subroutine continue_below(table)
        type(law_table_t), intent(inout) :: table
        real(wp) :: other, slope, radius, stiffness, above(4), near, bend, tilt
        integer :: roots

        near = table%lowest*(1.0_wp + 1.0e-4_wp)
        call values_in(table, 1, table%lowest, other, slope, radius, stiffness)
        call values_in(table, 1, near, above(1), above(2), above(3), above(4))
        table%end_values = [other, radius - table%end_radius]
        table%powers(1) = slope*table%lowest/other
        if (radius > table%end_radius) then
            table%powers(2) = log((above(3) - table%end_radius)/(radius - table%end_radius))/log(near/table%lowest)
        end if
        roots = nint(2.0_wp*table%powers(1))
        if (.not. table%by_depth .or. roots < fewest_roots .or. roots > most_roots) return
        near = min(2.0_wp*table%lowest, table%intervals(1)%highest)
        call values_in(table, 1, near, above(1), above(2), above(3), above(4))
        bend = 2.0_wp*table%powers(1) - roots
        tilt = bend*sqrt(near/table%lowest)
        associate (power => above(2)*near/above(1))
            if (abs(bend) <= smallest_bend .or. abs(power - 0.5_wp*(roots + tilt/(1.0_wp - bend + tilt))) <= &
                abs(power - table%powers(1))) table%roots = roots
        end associate
    end subroutine continue_below

    !> Meaning of the table's argument s.
    pure function control_of(table) result(control)
        type(law_table_t), intent(in) :: table
        type(control_t) :: control

        control = force_control
        if (table%by_depth) control = depth_control
    end function control_of

    !> s at coordinate x.
    pure function curve_value(table, curve, x) result(s)
        type(law_table_t), intent(in) :: table
        class(samples_t), intent(in) :: curve
        real(wp), intent(in) :: x
        real(wp) :: s
        type(curve_point_t) :: point

        point = curve%at(x)
        s = merge(point%depth, point%force, table%by_depth)
    end function curve_value

    !> Columns of a table, with or without G.
    pure function columns_of(conductance) result(columns)
        class(scalar_function_t), intent(in), optional :: conductance
        integer :: columns

        columns = column_count
        if (present(conductance)) columns = conductance_column
    end function columns_of

    !> Adds an interval in as few panels as the tolerance allows.
    subroutine compile_interval(table, curve, piece, origin, side, root, u, tolerance, error, conductance)
        type(law_table_t), intent(inout) :: table
        class(samples_t), intent(in) :: curve
        type(piece_t), intent(in) :: piece
        real(wp), intent(in) :: origin, side, u(2), tolerance
        logical, intent(in) :: root
        type(error_t), allocatable, intent(out) :: error
        class(scalar_function_t), intent(inout), optional :: conductance
        type(interval_t) :: interval
        real(wp), allocatable :: coefficients(:, :, :)
        real(wp) :: margin
        integer :: bits, attempt
        logical :: fits

        margin = 0.0_wp
        if (root) margin = singular_scale*sqrt(max(abs(origin), 1.0e-12_wp*u(2))/u(2))
        if (piece%from_nothing) margin = small_scale*margin
        do attempt = 1, merge(2, 1, root)
            do bits = 2, most_bits
                interval = new_interval(origin, side, root, u(1), u(2), margin, bits)
                interval%first_panel = size(table%other)
                if (allocated(coefficients)) deallocate (coefficients)
                allocate (coefficients(coefficient_count, columns_of(conductance), panel_count(interval)))
                call fit_panels(table, curve, piece, interval, tolerance, coefficients, fits, error, conductance)
                if (allocated(error)) return
                if (fits) exit
            end do
            if (fits) exit
            ! a short zone that passes a kink of the indenter changes fast at first
            margin = small_scale*margin
        end do
        if (fits) then
            call append(table, interval, coefficients)
        else
            call raise(error, error_no_convergence, "no piecewise polynomial of "//to_text(2.0_wp**most_bits)// &
                       " panels in an octave meets the tolerance between "//to_text(interval%lowest)//" and "// &
                       to_text(interval%highest))
        end if
    end subroutine compile_interval

    !> All panels of an interval, or those up to the first that does not fit.
    subroutine fit_panels(table, curve, piece, interval, tolerance, coefficients, fits, error, conductance)
        type(law_table_t), intent(in) :: table
        class(samples_t), intent(in) :: curve
        type(piece_t), intent(in) :: piece
        type(interval_t), intent(in) :: interval
        real(wp), intent(in) :: tolerance
        !> (coefficient, column, panel)
        real(wp), intent(inout) :: coefficients(:, :, :)
        logical, intent(out) :: fits
        type(error_t), allocatable, intent(out) :: error
        class(scalar_function_t), intent(inout), optional :: conductance
        integer :: panel

        fits = .true.
        do panel = 1, size(coefficients, 3)
            call check_cancelled(error)
            if (allocated(error)) return
            call fit_panel(table, curve, piece, interval, panel, tolerance, coefficients(:, :, panel), fits, conductance)
            if (present(conductance)) then
                if (allocated(conductance%error)) call move_alloc(conductance%error, error)
                if (allocated(error)) return
            end if
            if (.not. fits) return
        end do
    end subroutine fit_panels

    !> Adds an interval and its polynomials over -1 <= t <= 1, from now on over panels of their true length.
    subroutine append(table, interval, coefficients)
        type(law_table_t), intent(inout) :: table
        type(interval_t), intent(in) :: interval
        real(wp), intent(in) :: coefficients(:, :, :)
        type(row_t) :: other(size(coefficients, 3)), conductance(size(coefficients, 3))
        type(contact_rows_t) :: contact(size(coefficients, 3))
        real(wp) :: ends(2), unit
        integer :: i

        do i = 1, size(other)
            ends = panel_ends(interval, i)
            unit = 0.5_wp*(ends(2) - ends(1))
            other(i)%c = in_units_of(coefficients(:, 1, i), unit)
            contact(i)%radius%c = in_units_of(coefficients(:, 2, i), unit)
            contact(i)%stiffness%c = in_units_of(coefficients(:, 3, i), unit)
        end do
        if (size(coefficients, 2) == conductance_column) then
            do i = 1, size(other)
                ends = panel_ends(interval, i)
                conductance(i)%c = in_units_of(coefficients(:, conductance_column, i), 0.5_wp*(ends(2) - ends(1)))
            end do
            if (.not. allocated(table%conductance)) allocate (table%conductance(0))
            table%conductance = [table%conductance, conductance]
        end if
        table%intervals = [table%intervals, interval]
        table%other = [table%other, other]
        table%contact = [table%contact, contact]
    end subroutine append

    !> Interpolates the columns at Chebyshev's extrema, ends included: the law is continuous from panel to panel.
    subroutine fit_panel(table, curve, piece, interval, panel, tolerance, coefficients, fits, conductance)
        type(law_table_t), intent(in) :: table
        class(samples_t), intent(in) :: curve
        type(piece_t), intent(in) :: piece
        type(interval_t), intent(in) :: interval
        integer, intent(in) :: panel
        real(wp), intent(in) :: tolerance
        !> (coefficient, column)
        real(wp), intent(out) :: coefficients(:, :)
        logical, intent(out) :: fits
        class(scalar_function_t), intent(inout), optional :: conductance
        real(wp), dimension(coefficient_count, size(coefficients, 2)) :: values
        real(wp), dimension(size(coefficients, 2)) :: between, scale
        real(wp) :: t(coefficient_count), ends(2), found, u(2)
        integer :: i, j

        ends = panel_ends(interval, panel)
        do i = 1, coefficient_count
            t(i) = -cos(pi*(i - 1)/(coefficient_count - 1))
            call find_columns(table, curve, piece, interval, 0.5_wp*(ends(1)*(1.0_wp - t(i)) + ends(2)*(1.0_wp + t(i))), &
                              between, conductance)
            values(i, :) = between
        end do
        do j = 1, size(values, 2)
            coefficients(:, j) = interpolating(t, values(:, j))
        end do
        fits = .true.
        scale = maxval(abs(values), dim=1)
        ! With adhesion values pass through 0 and slopes through infinity: no value can be better than its argument s.
        if (table%adhesive) then
            u = [u_of_y(interval, ends(1)), u_of_y(interval, ends(2))]
            scale = scale + (maxval(values, dim=1) - minval(values, dim=1)) &
                    *maxval(abs(interval%origin + interval%side*u))/(u(2) - u(1))
        end if
        if (piece%from_nothing) then
            call find_columns(table, curve, piece, interval, interval%last_y, between, conductance)
            scale = scale + rounding*abs(between)/tolerance
        end if
        do i = 1, coefficient_count - 1, 3
            found = 0.5_wp*(t(i) + t(i + 1))
            call find_columns(table, curve, piece, interval, 0.5_wp*(ends(1)*(1.0_wp - found) + ends(2)*(1.0_wp + found)), &
                              between, conductance)
            do j = 1, size(values, 2)
                fits = fits .and. abs(polynomial(coefficients(:, j), found) - between(j)) <= tolerance*scale(j)
            end do
        end do
    end subroutine fit_panel

    !> The coefficients of the polynomial through (t, values): Newton's divided differences, multiplied out.
    pure function interpolating(t, values) result(c)
        real(wp), intent(in) :: t(coefficient_count), values(coefficient_count)
        real(wp) :: c(coefficient_count)
        real(wp) :: difference(coefficient_count)
        integer :: i, k

        difference = values
        do k = 2, coefficient_count
            do i = coefficient_count, k, -1
                difference(i) = (difference(i) - difference(i - 1))/(t(i) - t(i - k + 1))
            end do
        end do
        c = 0.0_wp
        c(1) = difference(coefficient_count)
        do k = coefficient_count - 1, 1, -1
            c(2:) = c(:coefficient_count - 1) - t(k)*c(2:)
            c(1) = difference(k) - t(k)*c(1)
        end do
    end function interpolating

    !> F or d, a and k of the state at y, and G.
    subroutine find_columns(table, curve, piece, interval, y, columns, conductance)
        type(law_table_t), intent(in) :: table
        class(samples_t), intent(in) :: curve
        type(piece_t), intent(in) :: piece
        type(interval_t), intent(in) :: interval
        real(wp), intent(in) :: y
        real(wp), intent(out) :: columns(:)
        class(scalar_function_t), intent(inout), optional :: conductance
        type(curve_point_t) :: point

        point = curve%find(control_of(table), interval%origin, interval%side, interval%root, u_of_y(interval, y), piece%first, &
                           piece%last)
        columns(:column_count) = [merge(point%force, point%depth, table%by_depth), point%radius, point%stiffness]
        if (present(conductance)) columns(conductance_column) = conductance%value(point%radius)
    end subroutine find_columns

end module mdrcontact_law_compile
