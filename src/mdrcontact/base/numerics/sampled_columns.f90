! SPDX-License-Identifier: GPL-3.0-or-later
!> Several functions of one variable that cost much, sampled once and then evaluated with their slopes for the price of short
!> polynomials.
!>
!> Piecewise Chebyshev series, from values alone or from values and slopes. A panel is halved until its last terms vanish and it
!> meets the functions where they were not sampled, or their slopes; neighbours must meet each other, and functions that jump are
!> refused. A panel that begins at a
!> break of the functions uses the variable sqrt(x - left edge), in which the square-root branches of contact mechanics are
!> analytic.
module mdrcontact_numerics_sampled_columns
    use mdrcontact_cancel, only: check_cancelled
    use mdrcontact_error, only: check_memory, error_no_convergence, error_t, raise, to_text
    use mdrcontact_kinds, only: pi, wp
    use mdrcontact_numerics_chebyshev, only: half, node, series_of_slopes, series_of_values, terms
    use mdrcontact_numerics_search, only: interval_of
    implicit none (type, external)
    private
    public :: columns_t, column_source_t, sampling_t, new_columns, series, lanes

    !> Columns that are summed side by side.
    integer, parameter :: lanes = 4
    integer, parameter :: most_panels = 400
    !> Halving a panel makes its last terms many times smaller: where more than this part is left, slopes may be less exact than
    !> values.
    real(wp), parameter :: least_gain = 0.1_wp
    !> Halving a panel of smooth functions below this length makes its last terms many times smaller: else they are noise.
    real(wp), parameter :: noisy_length = 0.25_wp
    !> A break closer to an edge than this is there.
    real(wp), parameter :: no_room = 1.0e-9_wp
    !> Where a series is compared with its functions, in the panel's variable: where the polynomial that vanishes at the nodes, of
    !> values and of slopes alike, is largest.
    real(wp), parameter :: between = cos(0.625_wp*pi)
    !> By how much more than its last terms a series may miss its functions.
    real(wp), parameter :: margin = 30.0_wp
    !> A panel of the shortest length is kept though it misses its functions, near a kink between its edges, but by no more
    !> than this.
    real(wp), parameter :: largest_miss = 1.0e-4_wp
    !> Edges closer than this part of the shortest length were named, around a kink: halving leaves no such panel.
    real(wp), parameter :: negligible = 0.5_wp
    !> The slope of a function of t = sqrt(x - left edge) is taken no closer to the edge than this t.
    real(wp), parameter :: smallest_root = 1.0e-5_wp

    !> How functions are sampled.
    type :: sampling_t
        !> of the values of counted columns
        real(wp) :: tolerance = 0.0_wp
        !> noise of the values up to which a panel is accepted though it misses the tolerance
        real(wp) :: noise = 0.0_wp
        !> panels are so long at first, and none is halved below the second
        real(wp) :: usual_length = 1.0_wp, shortest_length = 1.0e-4_wp
    end type sampling_t

    !> What is sampled.
    type, abstract :: column_source_t
        !> columns, how many of them, the first ones, must meet the tolerance, and how many are continuous at breaks
        integer :: columns = lanes, counted = lanes, continuous = lanes
        !> whether slopes come with the values; made false by a sample that has none
        logical :: has_slopes = .false.
        !> whether errors are relative to the largest value in a panel, or absolute: of logarithms
        logical :: is_relative = .false.
        !> evaluations
        integer :: solutions = 0
    contains
        procedure(sample_at), deferred :: sample
        procedure(radius_at), deferred :: radius
        procedure :: attainable
    end type column_source_t

    abstract interface
        !> The columns at x and, if they are wanted and has_slopes remains true, their slopes.
        subroutine sample_at(self, x, values, error, slopes)
            import :: column_source_t, error_t, wp
            class(column_source_t), intent(inout) :: self
            real(wp), intent(in) :: x
            real(wp), intent(out) :: values(:)
            type(error_t), allocatable, intent(inout) :: error
            real(wp), intent(out), optional :: slopes(:)
        end subroutine sample_at

        !> The contact radius at x, for an error.
        pure function radius_at(self, x) result(radius)
            import :: column_source_t, wp
            class(column_source_t), intent(in) :: self
            real(wp), intent(in) :: x
            real(wp) :: radius
        end function radius_at
    end interface

    !> The series.
    type :: columns_t
        !> panel i runs over x from edges(i) to edges(i+1)
        real(wp), allocatable :: edges(:)
        !> whether panel i begins at a break and is a series in sqrt(x - edges(i))
        logical, allocatable :: from_root(:)
        !> (lanes, terms, groups of columns, panels)
        real(wp), allocatable :: coefficients(:, :, :, :)
        !> the most by which a counted column missed its function where it was not sampled; no panel missed it by more than
        !> `largest_miss` or its noise
        real(wp) :: error = 0.0_wp
        !> how often the functions were evaluated
        integer :: solutions = 0
    contains
        procedure, non_overridable :: in_panel
        procedure, non_overridable :: values_at
        procedure, non_overridable :: local
        procedure, non_overridable :: place
        procedure, non_overridable :: rate
    end type columns_t

contains

    !> Accuracy that values near x cannot have; none by default.
    pure function attainable(self, x) result(accuracy)
        class(column_source_t), intent(in) :: self
        real(wp), intent(in) :: x
        real(wp) :: accuracy

        associate (unused_source => self, unused_x => x)
        end associate
        accuracy = 0.0_wp
    end function attainable

    !> Samples between the first and the last of some edges.
    subroutine new_columns(self, source, edges, breaks, sampling, error)
        class(columns_t), intent(inout) :: self
        class(column_source_t), intent(inout) :: source
        !> ascending; panels cross none
        real(wp), intent(in) :: edges(:)
        !> among them, where the functions have a square-root branch
        real(wp), intent(in) :: breaks(:)
        type(sampling_t), intent(in) :: sampling
        type(error_t), allocatable, intent(inout) :: error
        real(wp), allocatable :: waiting(:), before(:), kept(:, :, :, :)
        real(wp) :: panel(source%columns, terms), left, right, tail, allowed, missed, ends(most_panels + 1), reached(most_panels)
        logical :: root, by_slopes, tested, fits, roots(most_panels)
        integer :: count, stat

        ! one more than can be sampled is enough to be refused
        allocate (waiting, source=first_edges(edges(:min(size(edges), most_panels + 2)), sampling%usual_length))
        allocate (before(size(waiting)), source=huge(1.0_wp))
        allocate (kept(lanes, terms, (source%columns + lanes - 1)/lanes, most_panels), source=0.0_wp, stat=stat)
        call check_memory(error, stat)
        if (allocated(error)) return
        by_slopes = source%has_slopes
        tested = .false.
        count = 0
        ends(1) = edges(1)
        do while (size(waiting) > 0)
            if (count + size(waiting) > most_panels) then
                call raise(error, error_no_convergence, "the contact is not smooth or not accurate enough near radius = "// &
                           to_text(source%radius(ends(count + 1)))//" to be sampled")
                return
            end if
            left = ends(count + 1)
            right = waiting(1)
            root = any(abs(breaks - left) <= no_room)
            call check_cancelled(error)
            if (.not. allocated(error)) call sample_panel(source, left, right, root, by_slopes, panel, error)
            if (allocated(error)) return
            if (by_slopes .and. .not. source%has_slopes) then
                by_slopes = .false.
                cycle
            end if
            allowed = max(sampling%tolerance, source%attainable(left))
            tail = largest(source, panel, panel(:, terms - 1:))
            ! what halving does not make smaller is noise
            if (right - left < noisy_length .and. tail > 0.5_wp*before(1)) allowed = max(allowed, sampling%noise)
            if (by_slopes .and. tail > allowed .and. (.not. tested .or. tail > least_gain*before(1))) then
                ! if values alone make the panel, slopes are left for good
                by_slopes = .false.
                tested = .true.
                cycle
            end if
            fits = tail <= allowed
            missed = tail
            ! slopes that do not belong to the values show in the last terms
            if (.not. by_slopes .and. (fits .or. right - left <= sampling%shortest_length)) then
                call compare(source, left, right, root, panel, missed, error)
                if (allocated(error)) return
                fits = missed <= margin*max(tail, allowed)
            end if
            if (.not. fits .and. right - left > sampling%shortest_length) then
                by_slopes = source%has_slopes
                waiting = [0.5_wp*(left + right), waiting]
                before = [tail, tail, before(2:)]
                cycle
            end if
            missed = max(missed, tail)
            ! the end of the last panel may be that of a sphere, where depths grow without bound
            if (missed > max(largest_miss, margin*allowed) .and. right < edges(size(edges)) .and. &
                right - left > negligible*sampling%shortest_length) then
                call raise(error, error_no_convergence, "the contact jumps near radius = "//to_text(source%radius(left))//": "// &
                           "samples of it are "//to_text(missed)//" off; give the indenter or the medium no steps there")
                return
            end if
            waiting = waiting(2:)
            before = before(2:)
            count = count + 1
            ends(count + 1) = right
            roots(count) = root
            call keep(panel, kept(:, :, :, count))
            reached(count) = max(tail, allowed)
            self%error = max(self%error, missed)
        end do
        self%edges = ends(:count + 1)
        self%from_root = roots(:count)
        allocate (self%coefficients(lanes, terms, size(kept, 3), count), stat=stat)
        call check_memory(error, stat)
        if (allocated(error)) return
        self%coefficients(:, :, :, :) = kept(:, :, :, :count)
        self%solutions = self%solutions + source%solutions
        call compare_neighbours(self, source, reached(:count), error)
    end subroutine new_columns

    !> Two panels must agree where they meet, which is a node of neither.
    subroutine compare_neighbours(self, source, reached, error)
        class(columns_t), intent(in) :: self
        class(column_source_t), intent(in) :: source
        !> accuracy of each panel by its last terms
        real(wp), intent(in) :: reached(:)
        type(error_t), allocatable, intent(inout) :: error
        real(wp), dimension(source%continuous) :: before, next, unused, unit
        real(wp) :: missed
        integer :: i, row

        unit = 1.0_wp
        do i = 1, size(reached) - 1
            call self%in_panel(i, 1.0_wp, before, unused)
            call self%in_panel(i + 1, -1.0_wp, next, unused)
            if (source%is_relative) unit = [(max(sum(abs(self%coefficients(modulo(row - 1, lanes) + 1, :, &
                                                                           (row - 1)/lanes + 1, i))), tiny(1.0_wp)), &
                                             row=1, source%continuous)]
            missed = maxval(abs(before - next)/unit)
            if (missed <= margin*maxval(reached(i:i + 1))) cycle
            call raise(error, error_no_convergence, "samples of the contact differ by "//to_text(missed)//" from one another "// &
                       "near radius = "//to_text(source%radius(self%edges(i + 1))))
            return
        end do
    end subroutine compare_neighbours

    !> Right edges of panels of at most the usual length.
    pure function first_edges(edges, usual_length) result(right)
        real(wp), intent(in) :: edges(:), usual_length
        real(wp), allocatable :: right(:)
        integer :: i, j, count

        allocate (right(0))
        do i = 1, size(edges) - 1
            count = max(1, ceiling((edges(i + 1) - edges(i))/usual_length))
            right = [right, (edges(i) + (edges(i + 1) - edges(i))*(real(j, wp)/count), j=1, count - 1), edges(i + 1)]
        end do
    end function first_edges

    !> The series of a panel, from values and slopes where the slopes are known.
    subroutine sample_panel(source, left, right, root, by_slopes, panel, error)
        class(column_source_t), intent(inout) :: source
        real(wp), intent(in) :: left, right
        logical, intent(in) :: root, by_slopes
        !> (columns, terms)
        real(wp), intent(out) :: panel(:, :)
        type(error_t), allocatable, intent(inout) :: error
        real(wp), dimension(size(panel, 1), terms) :: values, slopes
        real(wp) :: t, stretch
        integer :: i

        panel = 0.0_wp
        values = 0.0_wp
        slopes = 0.0_wp
        if (by_slopes) then
            do i = 1, half
                t = 0.5_wp*(1.0_wp + node(i, half))
                stretch = 0.5_wp*(right - left)
                if (root) stretch = 2.0_wp*t*stretch
                call source%sample(left + (right - left)*merge(t**2, t, root), values(:, i), error, slopes(:, i))
                if (allocated(error) .or. .not. source%has_slopes) return
                slopes(:, i) = stretch*slopes(:, i)
            end do
            panel = series_of_slopes(values(:, :half), slopes(:, :half))
        else
            ! from the last to the first: what grows with x begins where it is easy
            do i = terms, 1, -1
                t = 0.5_wp*(1.0_wp + node(i, terms))
                call source%sample(left + (right - left)*merge(t**2, t, root), values(:, i), error)
                if (allocated(error)) return
            end do
            panel = series_of_values(values)
        end if
    end subroutine sample_panel

    !> How large some numbers of each counted column are, by the measure of errors.
    pure function largest(source, panel, numbers) result(size_of_them)
        class(column_source_t), intent(in) :: source
        real(wp), intent(in) :: panel(:, :), numbers(:, :)
        real(wp) :: size_of_them
        real(wp) :: unit
        integer :: row

        size_of_them = 0.0_wp
        do row = 1, source%counted
            unit = 1.0_wp
            if (source%is_relative) unit = max(sum(abs(panel(row, :))), tiny(1.0_wp))
            size_of_them = max(size_of_them, maxval(abs(numbers(row, :)))/unit)
        end do
    end function largest

    !> How far a panel's series is from its functions where it was not sampled.
    subroutine compare(source, left, right, root, panel, missed, error)
        class(column_source_t), intent(inout) :: source
        real(wp), intent(in) :: left, right
        logical, intent(in) :: root
        real(wp), intent(in) :: panel(:, :)
        real(wp), intent(out) :: missed
        type(error_t), allocatable, intent(inout) :: error
        real(wp) :: values(size(panel, 1)), t
        integer :: j

        missed = huge(1.0_wp)
        t = 0.5_wp*(1.0_wp + between)
        call source%sample(left + (right - left)*merge(t**2, t, root), values, error)
        if (allocated(error)) return
        missed = largest(source, panel, reshape(values - matmul(panel, [(cos((j - 1)*acos(between)), j=1, terms)]), &
                                                [size(values), 1]))
    end subroutine compare

    !> Columns into groups.
    pure subroutine keep(panel, groups)
        real(wp), intent(in) :: panel(:, :)
        real(wp), intent(inout) :: groups(:, :, :)
        integer :: row

        do row = 1, size(panel, 1)
            groups(modulo(row - 1, lanes) + 1, :, (row - 1)/lanes + 1) = panel(row, :)
        end do
    end subroutine keep

    !> The first columns at z in a panel, -1 at its left and 1 at its right edge, and their slopes in z.
    pure subroutine in_panel(self, panel, z, values, slopes)
        class(columns_t), intent(in) :: self
        integer, intent(in) :: panel
        real(wp), intent(in) :: z
        !> of the columns that are wanted, and the same size
        real(wp), intent(out) :: values(:), slopes(:)
        real(wp) :: v(lanes), dv(lanes)
        integer :: group, first, last

        if (size(values) == lanes) then
            call series(self%coefficients(:, :, 1, panel), z, values, slopes)
            return
        end if
        do group = 1, (size(values) + lanes - 1)/lanes
            first = (group - 1)*lanes + 1
            last = min(group*lanes, size(values))
            call series(self%coefficients(:, :, group, panel), z, v, dv)
            values(first:last) = v(:last - first + 1)
            slopes(first:last) = dv(:last - first + 1)
        end do
    end subroutine in_panel

    !> The first columns at x, and their slopes in x.
    pure subroutine values_at(self, x, values, slopes)
        class(columns_t), intent(in) :: self
        real(wp), intent(in) :: x
        real(wp), intent(out) :: values(:), slopes(:)
        real(wp) :: z
        integer :: panel

        panel = interval_of(self%edges, x)
        z = self%local(panel, x)
        call self%in_panel(panel, z, values, slopes)
        slopes = slopes*self%rate(panel, z)
    end subroutine values_at

    !> The series of one group and their slopes by Clenshaw's recurrence.
    pure subroutine series(c, z, v, dv)
        real(wp), intent(in) :: c(lanes, terms), z
        real(wp), intent(out) :: v(lanes), dv(lanes)
        real(wp), dimension(lanes) :: b, b1, b2, s, s1, s2
        integer :: j

        b1 = 0.0_wp
        b2 = 0.0_wp
        s1 = 0.0_wp
        s2 = 0.0_wp
        do j = terms, 2, -1
            s = 2.0_wp*(z*s1 + b1) - s2
            s2 = s1
            s1 = s
            b = 2.0_wp*z*b1 - b2 + c(:, j)
            b2 = b1
            b1 = b
        end do
        v = z*b1 - b2 + c(:, 1)
        dv = z*s1 - s2 + b1
    end subroutine series

    !> The panel's variable, -1 at its left and 1 at its right edge.
    pure function local(self, panel, x) result(z)
        class(columns_t), intent(in) :: self
        integer, intent(in) :: panel
        real(wp), intent(in) :: x
        real(wp) :: z

        z = (x - self%edges(panel))/(self%edges(panel + 1) - self%edges(panel))
        if (self%from_root(panel)) z = sqrt(max(z, 0.0_wp))
        z = 2.0_wp*z - 1.0_wp
    end function local

    !> Its inverse.
    pure function place(self, panel, z) result(x)
        class(columns_t), intent(in) :: self
        integer, intent(in) :: panel
        real(wp), intent(in) :: z
        real(wp) :: x
        real(wp) :: t

        t = 0.5_wp*(1.0_wp + z)
        if (self%from_root(panel)) t = t**2
        x = self%edges(panel) + (self%edges(panel + 1) - self%edges(panel))*t
    end function place

    !> dz/dx of the panel's variable.
    pure function rate(self, panel, z) result(dz)
        class(columns_t), intent(in) :: self
        integer, intent(in) :: panel
        real(wp), intent(in) :: z
        real(wp) :: dz

        dz = 2.0_wp/(self%edges(panel + 1) - self%edges(panel))
        if (self%from_root(panel)) dz = dz/max(1.0_wp + z, 2.0_wp*smallest_root)
    end function rate

end module mdrcontact_numerics_sampled_columns
