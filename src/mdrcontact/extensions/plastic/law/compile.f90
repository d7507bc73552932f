! SPDX-License-Identifier: GPL-3.0-or-later
!> From a curve of first loading to the polynomials of a plastic law, all in one buffer.
module mdrcontact_plastic_law_compile
    use, intrinsic :: iso_c_binding, only: c_double
    use mdrcontact_cancel, only: check_cancelled
    use mdrcontact_error, only: check_memory, error_domain, &
                                error_no_convergence, error_t, raise, to_text
    use mdrcontact_kinds, only: pi, wp
    use mdrcontact_law, only: contact_law_t
    use mdrcontact_law_compile, only: interpolating
    use mdrcontact_law_evaluate, only: energy_at
    use mdrcontact_law_interval, only: coefficient_count, in_units_of, interval_t, new_interval, panel_count, panel_ends, &
                                      polynomial, polynomial_moments, u_of_y
    use mdrcontact_law_pack, only: pack_table, packed_size
    use mdrcontact_law_table, only: interval_for, law_table_t, scale_table
    use mdrcontact_contact, only: on_unloading
    use mdrcontact_plastic_law, only: plastic_law_t, plastic_view_t, view_of
    use mdrcontact_plastic_loading, only: loaded_t, loading_t
    implicit none (type, external)
    private
    public :: compile_loading, scale_law, default_tolerance, smallest_tolerance, largest_tolerance

    !> Relative tolerance of a law for which none is given, and its range.
    real(wp), parameter :: default_tolerance = 1.0e-9_wp, smallest_tolerance = 1.0e-11_wp, largest_tolerance = 1.0e-2_wp
    !> Share of the tolerance that polynomials take.
    real(wp), parameter :: fit_share = 0.3_wp
    !> First number of the buffer, and numbers of its head, struct mdr_plastic_head, before the next row.
    real(wp), parameter :: format = 1296843602.0_wp
    integer, parameter :: head_size = 18
    !> Columns of a panel, F, a, a A2/E* of the imprint, and 3 F/(4 E*) of coated bodies; coefficients of each.
    integer, parameter :: columns = 4, row = coefficient_count
    !> Length of the first panel over the yield depth, and the most bits that number a panel.
    real(wp), parameter :: first_panel = 1.0e-4_wp
    integer, parameter :: fewest_bits = 2, most_bits = 7
    !> Most panels between breaks, and where in a panel the polynomials are compared.
    integer, parameter :: most_panels = 4096
    real(wp), parameter :: probes(3) = [-0.873_wp, 0.117_wp, 0.739_wp]
    !> Loss may fall by this part of the largest through rounding, and between the points of curves of coated bodies.
    real(wp), parameter :: rounding = 1.0e-12_wp, between_points = 1.0e-6_wp
    !> Gauss's points and weights on (0, 1).
    integer, parameter :: points = 4
    real(wp), parameter :: x_gauss(points) = [0.069431844202973712_wp, 0.33000947820757187_wp, 0.66999052179242813_wp, &
                                              0.93056815579702629_wp]
    real(wp), parameter :: w_gauss(points) = [0.17392742256872693_wp, 0.32607257743127307_wp, 0.32607257743127307_wp, &
                                              0.17392742256872693_wp]

    !> The panels between yield and the largest depth.
    type :: panels_t
        !> of d - loading%first, where the bits of y number them
        type(interval_t) :: interval
        logical :: by_bits = .true.
        !> their ends, one more than panels [length]
        real(wp), allocatable :: ends(:)
        !> over -1 <= t <= 1 (coefficient, column, panel)
        real(wp), allocatable :: c(:, :, :)
        real(wp) :: error = 0.0_wp
        !> the polynomials of the elastic law at yield over the curve, within the tolerance: the law is continuous
        real(wp) :: joint(columns) = 1.0_wp
    end type panels_t

    interface
        function mdrcontact_plastic_loss(view, deepest) result(loss) bind(C)
            import :: c_double, plastic_view_t
            type(plastic_view_t), intent(in) :: view
            real(c_double), intent(in), value :: deepest
            real(c_double) :: loss
        end function mdrcontact_plastic_loss
    end interface

contains

    !> The law of an elastic contact up to loading%first and of a curve of first loading from there on. `law` has its numbers.
    subroutine compile_loading(law, elastic, loading, highest, line, error)
        type(plastic_law_t), intent(inout) :: law
        !> without adhesion, at least up to the first depth of the curve or `highest`
        type(contact_law_t), intent(in) :: elastic
        class(loading_t), intent(in) :: loading
        !> the largest depth of the contact without adhesion, at most loading%last; 2 pi gamma/E* [length]
        real(wp), intent(in) :: highest, line
        type(error_t), allocatable, intent(inout) :: error
        type(panels_t) :: panels
        type(loaded_t) :: first

        law%elastic = elastic%by_depth
        if (highest > loading%first) then
            first = loading%at_depth(loading%first)
            panels%joint([1, 4]) = elastic%force(loading%first)/first%force
            if (size(loading%breaks) == 0) then
                call find_panels_by_bits(panels, loading, highest, fit_share*law%tolerance, error)
            else
                call find_panels_by_ends(panels, loading, highest, fit_share*law%tolerance, error)
            end if
        else
            allocate (panels%ends(1), source=highest)
            allocate (panels%c(row, columns, 0))
        end if
        if (allocated(error)) return
        law%error = max(elastic%error, panels%error)
        call pack_law(law, panels, loading, highest, line, error)
        if ((line > 0.0_wp .or. law%is_coated) .and. .not. allocated(error)) call check_loss(law, panels%ends, error)
    end subroutine compile_loading

    !> Panels that shrink towards yield, where F has a power 5/2 of the depth beyond it.
    subroutine find_panels_by_bits(panels, loading, highest, tolerance, error)
        type(panels_t), intent(inout) :: panels
        class(loading_t), intent(in) :: loading
        real(wp), intent(in) :: highest, tolerance
        type(error_t), allocatable, intent(inout) :: error
        real(wp) :: margin, y(2)
        integer :: bits, i, n
        logical :: fits

        margin = first_panel*loading%first/(highest - loading%first)
        do bits = fewest_bits, most_bits
            panels%interval = new_interval(0.0_wp, 1.0_wp, .false., 0.0_wp, highest - loading%first, margin, bits)
            n = panel_count(panels%interval)
            if (allocated(panels%c)) deallocate (panels%c, panels%ends)
            allocate (panels%c(row, columns, n), panels%ends(n + 1))
            do i = 1, n
                y = panel_ends(panels%interval, i)
                panels%ends(i) = loading%first + u_of_y(panels%interval, y(1))
                panels%ends(i + 1) = loading%first + u_of_y(panels%interval, y(2))
            end do
            panels%error = 0.0_wp
            do i = 1, n
                call check_cancelled(error)
                if (allocated(error)) return
                call fit_panel(loading, panels%joint, panels%ends(i:i + 1), tolerance, panels%c(:, :, i), panels%error, fits)
                if (.not. fits) exit
            end do
            if (fits) return
        end do
        call raise_no_fit(error, loading%first, highest)
    end subroutine find_panels_by_bits

    !> Panels between given depths, halved until they fit.
    subroutine find_panels_by_ends(panels, loading, highest, tolerance, error)
        type(panels_t), intent(inout) :: panels
        class(loading_t), intent(in) :: loading
        real(wp), intent(in) :: highest, tolerance
        type(error_t), allocatable, intent(inout) :: error
        real(wp) :: c(row, columns), left
        real(wp), allocatable :: to_do(:), made(:, :, :), ends(:)
        integer :: n, count
        logical :: fits

        panels%by_bits = .false.
        allocate (to_do, source=[highest, pack(loading%breaks(size(loading%breaks):1:-1), &
                                              loading%breaks(size(loading%breaks):1:-1) < highest)])
        count = most_panels + size(to_do)
        allocate (made(row, columns, count), ends(count + 1))
        left = loading%first
        ends(1) = left
        n = 0
        ! the last entry is the end of the panel at hand
        do while (size(to_do) > 0)
            call check_cancelled(error)
            if (allocated(error)) return
            associate (right => to_do(size(to_do)))
                call fit_panel(loading, panels%joint, [left, right], tolerance, c, panels%error, fits)
                if (.not. fits .and. right - left > rounding*right .and. n + size(to_do) < count) then
                    to_do = [to_do, 0.5_wp*(left + right)]
                    cycle
                end if
            end associate
            if (.not. fits) then
                call raise_no_fit(error, left, highest)
                return
            end if
            n = n + 1
            made(:, :, n) = c
            left = to_do(size(to_do))
            ends(n + 1) = left
            to_do = to_do(:size(to_do) - 1)
        end do
        panels%c = made(:, :, :n)
        panels%ends = ends(:n + 1)
    end subroutine find_panels_by_ends

    pure subroutine raise_no_fit(error, low, high)
        type(error_t), allocatable, intent(inout) :: error
        real(wp), intent(in) :: low, high

        call raise(error, error_no_convergence, "no piecewise polynomial meets the tolerance between the depths "//to_text(low)// &
                   " and "//to_text(high)//". Increase the tolerance")
    end subroutine raise_no_fit

    !> Polynomials through the curve at Chebyshev's extrema of a panel, ends included.
    pure subroutine fit_panel(loading, joint, ends, tolerance, c, error, fits)
        class(loading_t), intent(in) :: loading
        real(wp), intent(in) :: joint(columns), ends(2), tolerance
        real(wp), intent(out) :: c(row, columns)
        !> largest relative error found so far
        real(wp), intent(inout) :: error
        logical, intent(out) :: fits
        real(wp) :: t(row), values(row, columns), worst, between(columns), scale(columns)
        integer :: i, j

        do i = 1, row
            t(i) = -cos(pi*(i - 1)/(row - 1))
            values(i, :) = joint*numbers_at(loading, 0.5_wp*(ends(1)*(1.0_wp - t(i)) + ends(2)*(1.0_wp + t(i))))
        end do
        do j = 1, columns
            c(:, j) = interpolating(t, values(:, j))
        end do
        scale = maxval(abs(values), dim=1)
        ! the uniform pressure grows from 0: it counts against the whole
        scale(3) = max(scale(3), scale(1)/loading%modulus)
        scale(4) = max(scale(4), tiny(1.0_wp))
        worst = 0.0_wp
        do i = 1, size(probes)
            between = joint*numbers_at(loading, 0.5_wp*(ends(1)*(1.0_wp - probes(i)) + ends(2)*(1.0_wp + probes(i))))
            do j = 1, columns
                worst = max(worst, abs(polynomial(c(:, j), probes(i)) - between(j))/scale(j))
            end do
        end do
        fits = worst <= tolerance
        if (fits) error = max(error, worst)
    end subroutine fit_panel

    pure function numbers_at(loading, depth) result(numbers)
        class(loading_t), intent(in) :: loading
        real(wp), intent(in) :: depth
        real(wp) :: numbers(columns)
        type(loaded_t) :: state

        state = loading%at_depth(min(max(depth, loading%first), loading%last))
        numbers = [state%force, state%radius, state%radius*state%uniform, 0.0_wp]
        if (loading%is_coated) numbers(4) = 0.75_wp*state%force/state%modulus
    end function numbers_at

    !> Writes the buffer.
    subroutine pack_law(law, panels, loading, highest, line, error)
        type(plastic_law_t), intent(inout) :: law
        type(panels_t), intent(in) :: panels
        class(loading_t), intent(in) :: loading
        real(wp), intent(in) :: highest, line
        type(error_t), allocatable, intent(inout) :: error
        integer :: n, elastic, ends, rows, energy, tension, count, stat, i
        real(wp) :: y(2), unit, work, taken

        n = size(panels%c, 3)
        elastic = next_row(head_size)
        ends = next_row(elastic + packed_size(law%elastic))
        rows = next_row(ends + merge(0, n + 1, panels%by_bits))
        energy = rows + columns*row*n
        tension = next_row(energy + n)
        count = tension + merge(row*n, 0, line > 0.0_wp)
        allocate (law%buffer(count), source=0.0_wp, stat=stat)
        call check_memory(error, stat)
        if (allocated(error)) return
        law%buffer(:head_size) = [format, real(count, wp), real(elastic, wp), loading%first, highest, panels%interval%scale, &
                                  panels%interval%offset, real(panels%interval%bits, wp), real(n, wp), &
                                  real(merge(0, ends, panels%by_bits), wp), real(rows, wp), real(energy, wp), &
                                  real(merge(tension, 0, line > 0.0_wp), wp), law%modulus, line, elastic_radius(law, loading), &
                                  (line**2*elastic_radius(law, loading))**(1.0_wp/3.0_wp), merge(1.0_wp, 0.0_wp, law%is_coated)]
        call pack_table(law%elastic, law%buffer(elastic + 1:elastic + packed_size(law%elastic)))
        if (.not. panels%by_bits) law%buffer(ends + 1:ends + n + 1) = panels%ends
        work = energy_at(law%elastic, interval_for(law%elastic, on_unloading, min(loading%first, law%elastic%highest)), &
                         min(loading%first, law%elastic%highest))
        taken = 0.0_wp
        do i = 1, n
            y = [-1.0_wp, 1.0_wp]
            if (panels%by_bits) y = panel_ends(panels%interval, i)
            unit = 0.5_wp*(y(2) - y(1))
            call pack_panel(law%buffer, [rows + columns*row*(i - 1), energy + i, tension + row*(i - 1)], panels%c(:, :, i), &
                            panels%ends(i:i + 1), unit, law%modulus, line, work, taken)
        end do
    end subroutine pack_law

    !> a^2/d of the elastic contact.
    pure function elastic_radius(law, loading) result(radius)
        type(plastic_law_t), intent(in) :: law
        class(loading_t), intent(in) :: loading
        real(wp) :: radius
        type(loaded_t) :: state

        radius = law%radius
        if (radius > 0.0_wp) return
        state = loading%at_depth(loading%first)
        radius = state%radius**2/state%depth
    end function elastic_radius

    pure function next_row(place) result(next)
        integer, intent(in) :: place
        integer :: next

        next = row*((place + row - 1)/row)
    end function next_row

    !> The numbers of one panel: polynomials, the work in its middle, and with adhesion what that takes.
    pure subroutine pack_panel(buffer, places, c, ends, unit, modulus, line, work, taken)
        real(wp), intent(inout) :: buffer(:)
        !> before the polynomials, of the energy, and before the polynomial of what adhesion takes
        integer, intent(in) :: places(3)
        !> over -1 <= t <= 1
        real(wp), intent(in) :: c(row, columns), ends(2), unit, modulus, line
        !> at the first end, on return at the last
        real(wp), intent(inout) :: work, taken
        real(wp) :: half, moments(2), middle, polynomial_of(row)
        integer :: j

        half = 0.5_wp*(ends(2) - ends(1))
        ! the columns of a power lie together
        do j = 1, columns
            buffer(places(1) + j:places(1) + j + columns*(row - 1):columns) = in_units_of(c(:, j), unit)
        end do
        moments = polynomial_moments(c(:, 1), -1.0_wp)
        middle = work - half*moments(1)
        buffer(places(2)) = middle
        moments = polynomial_moments(c(:, 1), 1.0_wp)
        work = middle + half*moments(1)
        if (.not. line > 0.0_wp) return
        call find_tension(c, half, modulus, line, taken, polynomial_of)
        buffer(places(3) + 1:places(3) + row) = in_units_of(polynomial_of, unit)
    end subroutine pack_panel

    !> The integral of l(a) (2 E* a - dF/dd) over the depth (theory/plastic.md (9.6)): what first loading with adhesion takes less.
    pure subroutine find_tension(c, half, modulus, line, taken, tension)
        real(wp), intent(in) :: c(row, columns), half, modulus, line
        real(wp), intent(inout) :: taken
        real(wp), intent(out) :: tension(row)
        real(wp) :: t(row), values(row), at, a, slope, length
        integer :: i, j, k

        t = [(-cos(pi*(i - 1)/(row - 1)), i=1, row)]
        values(1) = taken
        do i = 2, row
            length = t(i) - t(i - 1)
            values(i) = values(i - 1)
            do j = 1, points
                at = t(i - 1) + length*x_gauss(j)
                a = polynomial(c(:, 2), at)
                slope = 0.0_wp
                do k = row, 2, -1
                    slope = slope*at + (k - 1)*c(k, 1)
                end do
                values(i) = values(i) + w_gauss(j)*length*half*sqrt(line*a)*(2.0_wp*modulus*a - slope/half)
            end do
        end do
        taken = values(row)
        tension = interpolating(t, values)
    end subroutine find_tension

    !> Raises if adhesion would let plastic flow give energy back.
    subroutine check_loss(law, ends, error)
        type(plastic_law_t), intent(in) :: law
        real(wp), intent(in) :: ends(:)
        type(error_t), allocatable, intent(inout) :: error
        type(plastic_view_t) :: view
        real(wp) :: before, loss, largest
        integer :: i, k

        view = view_of(law)
        before = 0.0_wp
        ! the last panel may end beyond the law
        largest = mdrcontact_plastic_loss(view, min(ends(size(ends)), view%highest))
        do i = 1, size(ends) - 1
            do k = 1, points
                loss = mdrcontact_plastic_loss(view, min(ends(i) + x_gauss(k)*(ends(i + 1) - ends(i)), view%highest))
                if (loss < before - merge(between_points, rounding, law%is_coated)*abs(largest)) then
                    if (law%is_coated) call raise(error, error_domain, "plastic flow on first loading would give energy back "// &
                                                  "at the depth "//to_text(ends(i))//". Check the curve")
                    call raise(error, error_domain, " = "//to_text(law%work_of_adhesion)//": plastic flow on first loading "// &
                               "would give energy back at the depth "//to_text(ends(i))//". Decrease it, or largest_depth", &
                               "work_of_adhesion")
                    return
                end if
                before = loss
            end do
        end do
    end subroutine check_loss

    !> Scales a law of a paraboloid without adhesion to lengths a factor larger, with the same moduli and stresses: d and a by the
    !> factor, F by its square, energies by its cube.
    pure subroutine scale_law(law, factor)
        type(plastic_law_t), intent(inout) :: law
        !> > 0
        real(wp), intent(in) :: factor
        real(wp) :: width_before
        integer :: i, n, rows, energy, ends, first

        call scale_elastic(law%elastic, factor)
        associate (head => law%buffer(:head_size))
            first = nint(head(3))
            n = nint(head(9))
            ends = nint(head(10))
            rows = nint(head(11))
            energy = nint(head(12))
            width_before = head(5) - head(4)
            head(4:5) = factor*head(4:5)
            ! not by the factor, so that rounding leaves the largest depth in the last panel
            if (n > 0) head(6) = head(6)*width_before/(head(5) - head(4))
            head(16) = factor*head(16)
        end associate
        call pack_table(law%elastic, law%buffer(first + 1:first + packed_size(law%elastic)))
        if (ends > 0) law%buffer(ends + 1:ends + n + 1) = factor*law%buffer(ends + 1:ends + n + 1)
        do i = 1, n
            associate (panel => law%buffer(rows + columns*row*(i - 1) + 1:rows + columns*row*i))
                panel(1::columns) = factor**2*panel(1::columns)
                panel(2::columns) = factor*panel(2::columns)
                panel(3::columns) = factor**2*panel(3::columns)
            end associate
        end do
        law%buffer(energy + 1:energy + n) = factor**3*law%buffer(energy + 1:energy + n)
        law%radius = factor*law%radius
        law%yield_depth = factor*law%yield_depth
        law%yield_force = factor**2*law%yield_force
        law%largest_depth = factor*law%largest_depth
        law%largest_force = factor**2*law%largest_force
        law%largest_radius = factor*law%largest_radius
    end subroutine scale_law

    !> An elastic law of lengths a factor larger at the same strains.
    pure subroutine scale_elastic(table, factor)
        type(law_table_t), intent(inout) :: table
        real(wp), intent(in) :: factor
        integer :: i

        ! depth and force at the same radius, and then force and radius at the same depth
        call scale_table(table, factor)
        table%end_values = factor*table%end_values
        do i = 1, size(table%other)
            table%other(i)%c = factor*table%other(i)%c
            table%contact(i)%radius%c = factor*table%contact(i)%radius%c
            table%contact(i)%stiffness%c = factor*table%contact(i)%stiffness%c
        end do
        table%energy = factor*table%energy
    end subroutine scale_elastic

end module mdrcontact_plastic_law_compile
