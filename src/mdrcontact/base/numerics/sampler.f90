! SPDX-License-Identifier: GPL-3.0-or-later
!> Functions of one variable that cost much, sampled once and then evaluated, differentiated and integrated for the price of short
!> polynomials.
!>
!> Piecewise Chebyshev series, from values alone or from values and slopes. A panel is halved until its last terms vanish and the
!> series meets the functions where they were not sampled. A panel that begins at a break uses the variable sqrt(x - left edge), in
!> which the square-root branches of contact mechanics are analytic.
!>
!> `sampled_function_t` is one function with its integral, from values to their rounding. Users: profile_sampled (shapes of
!> indenters), numerics_radius_law (laws of the contact radius), body_graded (constants of a gradient), medium_power_graded
!> (transforms of shapes), adhesion_steady_crack (speeds of a crack). `columns_t` is several functions side by side, to a tolerance;
!> neighbours must meet, and functions that jump are refused. Users: contact_curve and contact_zone_curve (laws, branches, loops,
!> fits).
module mdrcontact_numerics_sampler
    use, intrinsic :: iso_fortran_env, only: int64
    use mdrcontact_cancel, only: check_cancelled
    use mdrcontact_error, only: check_memory, error_no_convergence, error_t, raise, to_text
    use mdrcontact_kinds, only: pi, wp
    use mdrcontact_nonfinite, only: is_finite
    use mdrcontact_numerics_chebyshev, only: chebyshev_sum, chebyshev_sums, cosine_transform, differentiate, half, node, &
                                             series_of_slopes, series_of_values, terms
    use mdrcontact_numerics_scalar_function, only: scalar_function_t
    use mdrcontact_numerics_search, only: interval_of
    use mdrcontact_object, only: real_bytes
    implicit none (type, external)
    private
    public :: column_source_t, columns_t, lanes, new_columns, new_sampled_function, sampled_function_t, sampling_t, series

    !> Terms of a panel of one function.
    integer, parameter :: nodes = 20
    !> Columns that are summed side by side.
    integer, parameter :: lanes = 4
    !> How often a panel is halved at most.
    integer, parameter :: most_halvings = 64
    !> Where columns are compared with their functions, in the panel's variable: where the polynomial that vanishes at the nodes, of
    !> values and of slopes alike, is largest.
    real(wp), parameter :: between(1) = [cos(0.625_wp*pi)]
    !> Where one function is: in two gaps between the nodes, or in all of them and beyond the outermost ones.
    real(wp), parameter :: in_some(2) = [cos(0.35_wp*pi), cos(0.6_wp*pi)]
    integer, parameter :: gaps(nodes + 1) = [0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18, 19, 20]
    real(wp), parameter :: in_all(nodes + 1) = (1.0_wp - 1.0e-6_wp)*cos(pi*real(gaps, wp)/nodes)
    !> Halving a panel makes its last terms many times smaller: where more than this part is left, slopes may be less exact than
    !> values.
    real(wp), parameter :: least_gain = 0.1_wp
    !> Halving a panel of smooth columns below this length makes their last terms many times smaller: else they are noise.
    real(wp), parameter :: noisy_length = 0.25_wp
    !> A break closer to an edge than this is there.
    real(wp), parameter :: no_room = 1.0e-9_wp
    !> Edges closer than this part of the shortest length were named, around a kink: halving leaves no such panel.
    real(wp), parameter :: negligible = 0.5_wp
    !> Where a function may have steps of noise, a panel shorter than the first, relative to its distance from 0, is a straight line
    !> if its last terms have not fallen below the second times the others: it holds a kink or noise, of which a polynomial has
    !> slopes that the function has nowhere.
    real(wp), parameter :: narrow_panel = 1.0e-6_wp, least_fall = 1.0e-3_wp
    !> The slope in x of a function of t = sqrt(x - left edge) is taken no closer to the edge than this t: 1/t amplifies rounding.
    real(wp), parameter :: smallest_root = 1.0e-5_wp

    !> How functions are sampled.
    type :: sampling_t
        !> of the values of counted columns
        real(wp) :: tolerance = 0.0_wp
        !> noise of the values up to which a panel is accepted though it misses the tolerance
        real(wp) :: noise = 0.0_wp
        !> panels are so long at first, and none is halved below the second
        real(wp) :: usual_length = 1.0_wp, shortest_length = 1.0e-4_wp
        !> nor below this part of its distance from 0, which counts as no smaller than the second
        real(wp) :: shortest_part = 0.0_wp, least_size = 0.0_wp
        !> panels, beyond which the functions are not smooth enough
        integer :: most_panels = 400
        !> the last terms of a panel, by which its accuracy is judged
        integer :: last_terms = 2
        !> factor by which more than its last terms a series may miss its functions
        real(wp) :: margin = 30.0_wp
        !> a panel of the shortest length is kept though it misses its functions, near a kink between its edges, but by no more
        !> than this
        real(wp) :: largest_miss = 1.0e-4_wp
        !> relative accuracy of one function where its terms no longer fall, and relative size of its steps that are noise
        real(wp) :: roughness = 0.0_wp, steps = 0.0_wp
    end type sampling_t

    !> What is sampled.
    type, abstract :: column_source_t
        !> columns, how many of them, the first ones, must meet the tolerance, and how many are continuous at breaks
        integer :: columns = lanes, counted = lanes, continuous = lanes
        !> terms of a panel
        integer :: terms = terms
        !> whether slopes come with the values; made false by a sample that has none
        logical :: has_slopes = .false.
        !> whether errors are relative to the largest value in a panel, or absolute: of logarithms
        logical :: is_relative = .false.
        !> evaluations
        integer :: solutions = 0
        !> for errors
        character(len=12) :: what = "the contact"
        character(len=6) :: argument = "radius"
    contains
        procedure(sample_at), deferred :: sample
        procedure(radius_at), deferred :: radius
        procedure :: attainable
        procedure :: allowed => allowed_of_columns
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

        !> The contact radius at x, or x itself, for an error.
        pure function radius_at(self, x) result(radius)
            import :: column_source_t, wp
            class(column_source_t), intent(in) :: self
            real(wp), intent(in) :: x
            real(wp) :: radius
        end function radius_at
    end interface

    !> One function as a column.
    type, extends(column_source_t) :: function_source_t
        class(scalar_function_t), pointer :: f => null()
    contains
        procedure :: sample => sample_function
        procedure :: radius => argument_of_function
        procedure :: allowed => allowed_of_function
    end type function_source_t

    !> Panels of a variable x.
    type :: panels_t
        !> panel i runs over x from edges(i) to edges(i+1)
        real(wp), allocatable :: edges(:)
        !> whether panel i begins at a break and is a series in sqrt(x - edges(i))
        logical, allocatable :: from_root(:)
        !> the most by which a counted column missed its function where it was not sampled; no panel missed it by more than
        !> `largest_miss` or its noise
        real(wp) :: error = 0.0_wp
    contains
        procedure, non_overridable :: local
        procedure, non_overridable :: place
        procedure, non_overridable :: rate
    end type panels_t

    !> Series of several functions.
    type, extends(panels_t) :: columns_t
        !> (lanes, terms, groups of columns, panels)
        real(wp), allocatable :: coefficients(:, :, :, :)
        !> how often the functions were evaluated
        integer :: solutions = 0
    contains
        procedure, non_overridable :: in_panel
        procedure, non_overridable :: values_at
    end type columns_t

    !> Series of one function.
    type, extends(panels_t) :: sampled_function_t
        private
        !> (nodes, panels)
        real(wp), allocatable :: coefficients(:, :)
        !> those of the derivative in the panel's variable, which runs from -1 to 1 (nodes, panels)
        real(wp), allocatable :: derivatives(:, :)
        !> how many coefficients of each panel count; the others are rounding
        integer, allocatable :: used(:)
        !> integral from edges(1) to edges(i)
        real(wp), allocatable :: integrals(:)
    contains
        procedure :: value
        procedure :: slope
        procedure :: integral
        procedure :: lower
        procedure :: upper
        procedure :: move_to
        procedure :: bytes
        procedure :: values_in
        procedure :: slopes_in
        procedure :: degree_in
    end type sampled_function_t

contains

    !> Samples several functions between the first and the last of some edges.
    subroutine new_columns(self, source, edges, breaks, sampling, error)
        class(columns_t), intent(inout) :: self
        class(column_source_t), intent(inout) :: source
        !> ascending; panels cross none
        real(wp), intent(in) :: edges(:)
        !> among them, where the functions have a square-root branch
        real(wp), intent(in) :: breaks(:)
        type(sampling_t), intent(in) :: sampling
        type(error_t), allocatable, intent(inout) :: error
        real(wp), allocatable :: first(:), kept(:, :, :), reached(:)
        logical, allocatable :: roots(:)
        integer :: i, row, stat

        ! one more than can be sampled is enough to be refused
        allocate (first, source=first_edges(edges(:min(size(edges), sampling%most_panels + 2)), sampling%usual_length))
        allocate (roots, source=[(any(abs(breaks - first(i)) <= no_room), i=1, size(first) - 1)])
        call sample_panels(self, source, first, roots, sampling, between, kept, reached, error)
        if (allocated(error)) return
        allocate (self%coefficients(lanes, terms, (source%columns + lanes - 1)/lanes, size(reached)), source=0.0_wp, stat=stat)
        call check_memory(error, stat)
        if (allocated(error)) return
        do row = 1, source%columns
            self%coefficients(modulo(row - 1, lanes) + 1, :, (row - 1)/lanes + 1, :) = kept(row, :, :)
        end do
        self%solutions = self%solutions + source%solutions
        call compare_neighbours(self, source, reached, sampling%margin, error)
    end subroutine new_columns

    !> Samples `f` between the first and the last of `edges` to a relative `tolerance` of the largest value in each panel.
    subroutine new_sampled_function(self, f, edges, from_root, tolerance, error, noise, most, roughness, everywhere, &
                                    least_size, steps)
        type(sampled_function_t), intent(out) :: self
        class(scalar_function_t), intent(inout), target :: f
        !> ascending; panels never cross one, so put them where f is not analytic
        real(wp), intent(in) :: edges(:)
        !> (size(edges) - 1) whether f has a square-root branch at the panel's left edge; of size 0: it has none
        logical, intent(in) :: from_root(:)
        real(wp), intent(in) :: tolerance
        type(error_t), allocatable, intent(out) :: error
        !> absolute accuracy of the values of f, beyond which no panel is refined; default 0
        real(wp), intent(in), optional :: noise
        !> number of panels, beyond which f is not smooth enough; default 20000
        integer, intent(in), optional :: most
        !> relative accuracy of the values of f, beyond which a panel whose coefficients no longer fall is not refined; default 0
        real(wp), intent(in), optional :: roughness
        !> whether the series are compared with f in all gaps between the nodes, for an f with narrow features; default: in two
        logical, intent(in), optional :: everywhere
        !> f sees x rounded as if |x| were at least this: 1 if x is a logarithm; default 0
        real(wp), intent(in), optional :: least_size
        !> relative size of steps of f that are noise: a panel that halving made no better is not refined below them, else its slope
        !> would be that of a step; default 0
        real(wp), intent(in), optional :: steps
        type(function_source_t) :: source
        type(sampling_t) :: sampling
        real(wp), allocatable :: kept(:, :, :), unused(:), places(:)
        logical :: roots(size(edges) - 1)
        integer :: i, count, stat

        sampling = sampling_t(tolerance, shortest_length=0.0_wp, shortest_part=1.0e-10_wp, most_panels=20000, last_terms=3, &
                              margin=10.0_wp, largest_miss=huge(1.0_wp))
        if (present(noise)) sampling%noise = noise
        if (present(most)) sampling%most_panels = most
        if (present(roughness)) sampling%roughness = roughness
        if (present(least_size)) sampling%least_size = least_size
        if (present(steps)) sampling%steps = steps
        places = in_some
        if (present(everywhere)) then
            if (everywhere) places = in_all
        end if
        source%columns = 1
        source%counted = 1
        source%terms = nodes
        source%what = "the function"
        source%argument = "x"
        source%f => f
        roots = .false.
        if (size(from_root) > 0) roots = from_root
        call sample_panels(self, source, edges, roots, sampling, places, kept, unused, error)
        if (allocated(error)) return
        count = size(self%from_root)
        allocate (self%coefficients(nodes, count), self%derivatives(nodes, count), self%used(count), self%integrals(count + 1), &
                  stat=stat)
        call check_memory(error, stat)
        if (allocated(error)) return
        self%integrals(1) = 0.0_wp
        do i = 1, count
            self%coefficients(:, i) = kept(1, :, i)
            self%used(i) = leading(self%coefficients(:, i), self%edges(i), self%edges(i + 1))
            ! those left out as rounding would come back in the lowest coefficients of the derivative, as a slope of what is level
            self%derivatives(:, i) = 0.0_wp
            if (self%used(i) > 1) call differentiate(self%coefficients(:self%used(i), i), self%derivatives(:self%used(i), i))
            self%integrals(i + 1) = self%integrals(i) + partial_integral(self, i, 1.0_wp)
        end do
    end subroutine new_sampled_function

    !> Series on panels that are halved until each is its functions.
    subroutine sample_panels(self, source, edges, roots, sampling, places, kept, reached, error)
        class(panels_t), intent(inout) :: self
        class(column_source_t), intent(inout) :: source
        !> of the first panels, and whether they begin at a square-root branch
        real(wp), intent(in) :: edges(:)
        logical, intent(in) :: roots(:)
        type(sampling_t), intent(in) :: sampling
        !> where the series are compared with the functions, in the panel's variable
        real(wp), intent(in) :: places(:)
        !> (columns, terms, panels)
        real(wp), allocatable, intent(out) :: kept(:, :, :)
        !> accuracy of each panel by its last terms
        real(wp), allocatable, intent(out) :: reached(:)
        type(error_t), allocatable, intent(inout) :: error
        !> left edge, right edge, and what the last terms were before the panel was halved; leftmost on top, so that finished panels
        !> come in ascending order
        real(wp), allocatable :: stack(:, :)
        logical, allocatable :: root_stack(:)
        real(wp) :: cosines(source%terms, source%terms), basis(source%terms, size(places)), panel(source%columns, source%terms)
        real(wp) :: left, right, shortest, tail, allowed, missed, middle, distance
        logical :: by_slopes, tested, fits
        integer :: waiting, count, row, i, stat

        waiting = size(roots)
        allocate (stack(3, waiting + most_halvings + 1), root_stack(waiting + most_halvings + 1), stat=stat)
        call check_memory(error, stat)
        if (stat /= 0) return
        cosines = 0.0_wp
        if (source%terms /= terms) call cosine_transform(cosines)
        basis(1, :) = 1.0_wp
        basis(2, :) = places
        do i = 3, source%terms
            basis(i, :) = 2.0_wp*places*basis(i - 1, :) - basis(i - 2, :)
        end do
        stack(1, :waiting) = edges(waiting:1:-1)
        stack(2, :waiting) = edges(waiting + 1:2:-1)
        stack(3, :waiting) = huge(1.0_wp)
        root_stack(:waiting) = roots(waiting:1:-1)
        count = 0
        call resize(self, kept, reached, shape(panel), 0, size(stack, 2), error)
        if (allocated(error)) return
        by_slopes = source%has_slopes
        tested = .false.
        do while (waiting > 0)
            left = stack(1, waiting)
            right = stack(2, waiting)
            if (count + waiting > sampling%most_panels .or. waiting == size(root_stack)) then
                call raise(error, error_no_convergence, trim(source%what)//" is not smooth or not accurate enough to be "// &
                           "sampled near "//trim(source%argument)//" = "//to_text(source%radius(left)))
                return
            end if
            call check_cancelled(error)
            if (.not. allocated(error)) call sample_panel(source, left, right, root_stack(waiting), by_slopes, cosines, panel, &
                                                          error)
            if (allocated(error)) return
            if (by_slopes .and. .not. source%has_slopes) then
                by_slopes = .false.
                cycle
            end if
            if (.not. all(is_finite(panel(:source%counted, :)))) then
                call raise(error, error_no_convergence, trim(source%what)//" exceeds the range of double precision near "// &
                           trim(source%argument)//" = "//to_text(source%radius(left)))
                return
            end if
            distance = max(abs(left), abs(right), sampling%least_size)
            shortest = max(sampling%shortest_length, sampling%shortest_part*distance)
            tail = largest(source, panel, panel(:, source%terms - sampling%last_terms + 1:))
            allowed = source%allowed(sampling, panel, left, right, tail, stack(3, waiting))
            if (by_slopes .and. tail > allowed .and. (.not. tested .or. tail > least_gain*stack(3, waiting))) then
                ! if values alone make the panel, slopes are left for good
                by_slopes = .false.
                tested = .true.
                cycle
            end if
            fits = tail <= allowed
            missed = tail
            ! slopes that do not belong to the values show in the last terms
            if (.not. by_slopes .and. (fits .or. right - left <= shortest)) then
                call compare(source, left, right, root_stack(waiting), panel, places, basis, missed, error)
                if (allocated(error)) return
                fits = missed <= sampling%margin*max(tail, allowed)
            end if
            if (.not. fits .and. right - left > shortest) then
                by_slopes = source%has_slopes
                middle = 0.5_wp*(left + right)
                stack(:, waiting + 1) = [left, middle, tail]
                stack(:, waiting) = [middle, right, tail]
                root_stack(waiting + 1) = root_stack(waiting)
                root_stack(waiting) = .false.
                waiting = waiting + 1
                cycle
            end if
            missed = max(missed, tail)
            ! the end of the last panel may be that of a sphere, where depths grow without bound
            if (missed > max(sampling%largest_miss, sampling%margin*allowed) .and. right < edges(size(edges)) .and. &
                right - left > negligible*sampling%shortest_length) then
                call raise(error, error_no_convergence, trim(source%what)//" jumps near "//trim(source%argument)//" = "// &
                           to_text(source%radius(left))//": the error of its samples is "//to_text(missed)// &
                           ". Smooth the indenter or the medium there")
                return
            end if
            if (sampling%steps > 0.0_wp .and. right - left < narrow_panel*distance .and. &
                tail > least_fall*maxval(abs(panel(:, 3:)))) then
                do row = 1, source%columns
                    call straighten(panel(row, :), 0.5_wp*source%terms*cosines(1, 2))
                end do
            end if
            count = count + 1
            if (count > size(reached)) call resize(self, kept, reached, shape(panel), count - 1, 2*count, error)
            if (allocated(error)) return
            self%edges(count:count + 1) = [left, right]
            self%from_root(count) = root_stack(waiting)
            kept(:, :, count) = panel
            reached(count) = max(tail, allowed)
            self%error = max(self%error, missed)
            waiting = waiting - 1
        end do
        call resize(self, kept, reached, shape(panel), count, count, error)
    end subroutine sample_panels

    !> Keeps the first panels and makes room for `room` of them.
    subroutine resize(self, kept, reached, shape_of_panel, count, room, error)
        class(panels_t), intent(inout) :: self
        real(wp), allocatable, intent(inout) :: kept(:, :, :), reached(:)
        integer, intent(in) :: shape_of_panel(2), count, room
        type(error_t), allocatable, intent(inout) :: error
        real(wp), allocatable :: edges(:), coefficients(:, :, :), accuracies(:)
        logical, allocatable :: from_root(:)
        integer :: stat

        allocate (edges(room + 1), from_root(room), coefficients(shape_of_panel(1), shape_of_panel(2), room), accuracies(room), &
                  stat=stat)
        call check_memory(error, stat)
        if (allocated(error)) return
        if (count > 0) then
            edges(:count + 1) = self%edges(:count + 1)
            from_root(:count) = self%from_root(:count)
            coefficients(:, :, :count) = kept(:, :, :count)
            accuracies(:count) = reached(:count)
        end if
        call move_alloc(edges, self%edges)
        call move_alloc(from_root, self%from_root)
        call move_alloc(coefficients, kept)
        call move_alloc(accuracies, reached)
    end subroutine resize

    !> The series of a panel, from values and slopes where the slopes are known.
    subroutine sample_panel(source, left, right, root, by_slopes, cosines, panel, error)
        class(column_source_t), intent(inout) :: source
        real(wp), intent(in) :: left, right
        logical, intent(in) :: root, by_slopes
        !> of cosine_transform; a series of `terms` has its own
        real(wp), intent(in) :: cosines(:, :)
        !> (columns, terms)
        real(wp), intent(out) :: panel(:, :)
        type(error_t), allocatable, intent(inout) :: error
        real(wp) :: values(size(panel, 1), size(panel, 2)), slopes(size(panel, 1), half), one(size(panel, 2))
        real(wp) :: z, stretch
        integer :: i, j, row, n

        panel = 0.0_wp
        values = 0.0_wp
        one = 0.0_wp
        n = size(panel, 2)
        if (by_slopes) then
            slopes = 0.0_wp
            do i = 1, half
                z = node(i, half)
                stretch = 0.5_wp*(right - left)
                if (root) stretch = 2.0_wp*(0.5_wp*(1.0_wp + z))*stretch
                call source%sample(place_in(left, right, root, z), values(:, i), error, slopes(:, i))
                if (allocated(error) .or. .not. source%has_slopes) return
                slopes(:, i) = stretch*slopes(:, i)
            end do
            panel = series_of_slopes(values(:, :half), slopes)
            return
        end if
        ! from the last to the first: what grows with x begins where it is easy
        do i = n, 1, -1
            if (n == terms) then
                z = node(i, terms)
            else
                z = 0.5_wp*n*cosines(i, 2)
            end if
            call source%sample(place_in(left, right, root, z), values(:, i), error)
            if (allocated(error)) return
        end do
        if (n == terms) then
            panel = series_of_values(values)
        else
            do row = 1, size(panel, 1)
                one = values(row, :)
                do j = 1, n
                    panel(row, j) = sum(one*cosines(:, j))
                end do
            end do
        end if
    end subroutine sample_panel

    !> Error of a panel's series at some places where they were not sampled.
    subroutine compare(source, left, right, root, panel, places, basis, missed, error)
        class(column_source_t), intent(inout) :: source
        real(wp), intent(in) :: left, right
        logical, intent(in) :: root
        !> (columns, terms), the places, and the polynomials there (terms, places)
        real(wp), intent(in) :: panel(:, :), places(:), basis(:, :)
        real(wp), intent(out) :: missed
        type(error_t), allocatable, intent(inout) :: error
        real(wp) :: distances(size(panel, 1), 1)
        integer :: i, row

        missed = 0.0_wp
        do i = 1, size(places)
            call source%sample(place_in(left, right, root, places(i)), distances(:, 1), error)
            if (allocated(error)) return
            do row = 1, source%counted
                distances(row, 1) = distances(row, 1) - sum(panel(row, :)*basis(:, i))
            end do
            ! what is no number has missed too
            if (.not. all(abs(distances(:source%counted, 1)) <= huge(1.0_wp))) distances = huge(1.0_wp)
            missed = max(missed, largest(source, panel, distances))
        end do
    end subroutine compare

    !> Two panels must agree where they meet, which is a node of neither.
    subroutine compare_neighbours(self, source, reached, margin, error)
        class(columns_t), intent(in) :: self
        class(column_source_t), intent(in) :: source
        !> accuracy of each panel by its last terms
        real(wp), intent(in) :: reached(:), margin
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
            call raise(error, error_no_convergence, "samples of the contact differ by "//to_text(missed)//" near radius = "// &
                       to_text(source%radius(self%edges(i + 1))))
            return
        end do
    end subroutine compare_neighbours

    !> Edges of panels of at most the usual length.
    pure function first_edges(edges, usual_length) result(first)
        real(wp), intent(in) :: edges(:), usual_length
        real(wp), allocatable :: first(:)
        integer :: i, j, count

        first = edges(:1)
        do i = 1, size(edges) - 1
            count = max(1, ceiling((edges(i + 1) - edges(i))/usual_length))
            first = [first, (edges(i) + (edges(i + 1) - edges(i))*(real(j, wp)/count), j=1, count - 1), edges(i + 1)]
        end do
    end function first_edges

    !> Accuracy that values near x cannot have; none by default.
    pure function attainable(self, x) result(accuracy)
        class(column_source_t), intent(in) :: self
        real(wp), intent(in) :: x
        real(wp) :: accuracy

        associate (unused_source => self, unused_x => x)
        end associate
        accuracy = 0.0_wp
    end function attainable

    !> What the last terms of columns may be.
    pure function allowed_of_columns(self, sampling, panel, left, right, tail, before) result(allowed)
        class(column_source_t), intent(in) :: self
        type(sampling_t), intent(in) :: sampling
        !> (columns, terms)
        real(wp), intent(in) :: panel(:, :)
        !> edges of the panel, its last terms, and what they were before it was halved
        real(wp), intent(in) :: left, right, tail, before
        real(wp) :: allowed

        associate (unused => panel)
        end associate
        allowed = max(sampling%tolerance, self%attainable(left))
        ! what halving does not make smaller is noise
        if (right - left < noisy_length .and. tail > 0.5_wp*before) allowed = max(allowed, sampling%noise)
    end function allowed_of_columns

    !> What those of one function may be.
    pure function allowed_of_function(self, sampling, panel, left, right, tail, before) result(allowed)
        class(function_source_t), intent(in) :: self
        type(sampling_t), intent(in) :: sampling
        real(wp), intent(in) :: panel(:, :)
        real(wp), intent(in) :: left, right, tail, before
        real(wp) :: allowed
        real(wp) :: size_of_f, x

        associate (unused => self)
        end associate
        size_of_f = maxval(abs(panel(1, :)))
        x = max(abs(left), abs(right), sampling%least_size)
        ! No polynomial can be closer than the rounding of x allows, which moves x by this much of a narrow panel.
        allowed = sampling%tolerance*size_of_f + epsilon(x)*x/(right - left)*maxval(abs(panel(1, 2:)))
        allowed = max(allowed, sampling%noise)
        if (tail > 0.1_wp*maxval(abs(panel(1, nodes/2:nodes - 3)))) allowed = max(allowed, sampling%roughness*size_of_f)
        if (tail > 0.5_wp*before) allowed = max(allowed, sampling%steps*size_of_f)
    end function allowed_of_function

    subroutine sample_function(self, x, values, error, slopes)
        class(function_source_t), intent(inout) :: self
        real(wp), intent(in) :: x
        real(wp), intent(out) :: values(:)
        type(error_t), allocatable, intent(inout) :: error
        real(wp), intent(out), optional :: slopes(:)

        if (present(slopes)) slopes = 0.0_wp
        values(1) = self%f%value(x)
        if (allocated(self%f%error)) error = self%f%error
    end subroutine sample_function

    pure function argument_of_function(self, x) result(radius)
        class(function_source_t), intent(in) :: self
        real(wp), intent(in) :: x
        real(wp) :: radius

        associate (unused => self)
        end associate
        radius = x
    end function argument_of_function

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

    !> The straight line through the values at the outermost nodes, z and -z.
    pure subroutine straighten(c, z)
        real(wp), intent(inout) :: c(nodes)
        real(wp), intent(in) :: z
        real(wp) :: ends(2)

        ends = [chebyshev_sum(c, -abs(z)), chebyshev_sum(c, abs(z))]
        c = 0.0_wp
        c(1) = 0.5_wp*sum(ends)
        c(2) = 0.5_wp*(ends(2) - ends(1))/abs(z)
    end subroutine straighten

    !> How many coefficients are more than the rounding of values and of positions.
    pure function leading(c, left, right) result(count)
        real(wp), intent(in) :: c(nodes), left, right
        integer :: count
        real(wp) :: rounding

        rounding = epsilon(c)*(2.0_wp*maxval(abs(c)) + max(abs(left), abs(right))/(right - left)*maxval(abs(c(2:))))
        do count = nodes, 2, -1
            if (abs(c(count)) > rounding) return
        end do
    end function leading

    !> The panel's variable, -1 at its left and 1 at its right edge.
    pure function local(self, panel, x) result(z)
        class(panels_t), intent(in) :: self
        integer, intent(in) :: panel
        real(wp), intent(in) :: x
        real(wp) :: z

        z = 2.0_wp*part(self, panel, x) - 1.0_wp
    end function local

    !> The same, 0 at its left edge.
    pure function part(self, panel, x) result(t)
        class(panels_t), intent(in) :: self
        integer, intent(in) :: panel
        real(wp), intent(in) :: x
        real(wp) :: t

        t = (x - self%edges(panel))/(self%edges(panel + 1) - self%edges(panel))
        if (self%from_root(panel)) t = sqrt(max(t, 0.0_wp))
    end function part

    !> Its inverse: where z lies.
    pure function place(self, panel, z) result(x)
        class(panels_t), intent(in) :: self
        integer, intent(in) :: panel
        real(wp), intent(in) :: z
        real(wp) :: x

        x = place_in(self%edges(panel), self%edges(panel + 1), self%from_root(panel), z)
    end function place

    pure function place_in(left, right, from_root, z) result(x)
        real(wp), intent(in) :: left, right, z
        logical, intent(in) :: from_root
        real(wp) :: x
        real(wp) :: t

        t = 0.5_wp*(1.0_wp + z)
        if (from_root) t = t**2
        x = left + (right - left)*t
    end function place_in

    !> dz/dx of the panel's variable.
    pure function rate(self, panel, z) result(dz)
        class(panels_t), intent(in) :: self
        integer, intent(in) :: panel
        real(wp), intent(in) :: z
        real(wp) :: dz

        dz = 2.0_wp/(self%edges(panel + 1) - self%edges(panel))
        if (self%from_root(panel)) dz = dz/max(1.0_wp + z, 2.0_wp*smallest_root)
    end function rate

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

    !> f(x) for lower() <= x <= upper(); beyond, the outermost panel's polynomial.
    elemental function value(self, x) result(y)
        class(sampled_function_t), intent(in) :: self
        real(wp), intent(in) :: x
        real(wp) :: y
        integer :: panel

        panel = interval_of(self%edges, x)
        y = chebyshev_sum(self%coefficients(:self%used(panel), panel), 2.0_wp*part(self, panel, x) - 1.0_wp)
    end function value

    !> f(x) and f'(x) at points of one panel, counted from 1, that does not begin at a branch.
    pure subroutine values_in(self, panel, x, y)
        class(sampled_function_t), intent(in) :: self
        integer, intent(in) :: panel
        real(wp), intent(in) :: x(:)
        !> same size as x
        real(wp), intent(out) :: y(:)

        call chebyshev_sums(self%coefficients(:self%used(panel), panel), self%edges(panel), self%edges(panel + 1), x, y)
    end subroutine values_in

    pure subroutine slopes_in(self, panel, x, y)
        class(sampled_function_t), intent(in) :: self
        integer, intent(in) :: panel
        real(wp), intent(in) :: x(:)
        real(wp), intent(out) :: y(:)

        call chebyshev_sums(self%derivatives(:max(self%used(panel) - 1, 1), panel), self%edges(panel), self%edges(panel + 1), x, y)
        y = y*(2.0_wp/(self%edges(panel + 1) - self%edges(panel)))
    end subroutine slopes_in

    !> The degree of a panel's polynomial.
    pure function degree_in(self, panel) result(degree)
        class(sampled_function_t), intent(in) :: self
        integer, intent(in) :: panel
        integer :: degree

        degree = self%used(panel) - 1
    end function degree_in

    !> f'(x).
    elemental function slope(self, x) result(y)
        class(sampled_function_t), intent(in) :: self
        real(wp), intent(in) :: x
        real(wp) :: y
        real(wp) :: t
        integer :: panel

        panel = interval_of(self%edges, x)
        t = part(self, panel, x)
        if (self%from_root(panel)) t = max(t, smallest_root)
        y = 2.0_wp*chebyshev_sum(self%derivatives(:max(self%used(panel) - 1, 1), panel), 2.0_wp*t - 1.0_wp) &
            /(self%edges(panel + 1) - self%edges(panel))
        if (self%from_root(panel)) y = y/(2.0_wp*t)
    end function slope

    !> The integral of f from lower() to x.
    elemental function integral(self, x) result(y)
        class(sampled_function_t), intent(in) :: self
        real(wp), intent(in) :: x
        real(wp) :: y
        integer :: i

        i = interval_of(self%edges, x)
        y = self%integrals(i) + partial_integral(self, i, part(self, i, x))
    end function integral

    !> The integral over panel i from its left edge to local variable t.
    pure function partial_integral(self, i, t) result(y)
        type(sampled_function_t), intent(in) :: self
        integer, intent(in) :: i
        real(wp), intent(in) :: t
        real(wp) :: y
        real(wp) :: integrand(nodes + 3), primitive(nodes + 2)
        integer :: j

        ! With x = l + L t the integrand in t is L f, with x = l + L t^2 it is 2 L t f, and t = (1 + z)/2.
        integrand = 0.0_wp
        if (self%from_root(i)) then
            integrand(:nodes) = self%coefficients(:, i)
            integrand(2) = integrand(2) + self%coefficients(1, i)
            do j = 2, nodes
                integrand(j - 1) = integrand(j - 1) + 0.5_wp*self%coefficients(j, i)
                integrand(j + 1) = integrand(j + 1) + 0.5_wp*self%coefficients(j, i)
            end do
        else
            integrand(:nodes) = self%coefficients(:, i)
        end if
        primitive(1) = 0.0_wp
        primitive(2) = integrand(1) - 0.5_wp*integrand(3)
        do j = 3, nodes + 2
            primitive(j) = (integrand(j - 1) - integrand(j + 1))/(2.0_wp*(j - 1))
        end do
        y = 0.5_wp*(self%edges(i + 1) - self%edges(i)) &
            *(chebyshev_sum(primitive, 2.0_wp*t - 1.0_wp) - chebyshev_sum(primitive, -1.0_wp))
    end function partial_integral

    pure function lower(self) result(x)
        class(sampled_function_t), intent(in) :: self
        real(wp) :: x

        x = self%edges(1)
    end function lower

    pure function upper(self) result(x)
        class(sampled_function_t), intent(in) :: self
        real(wp) :: x

        x = self%edges(size(self%edges))
    end function upper

    !> Moves to another place, without a copy.
    pure subroutine move_to(self, to)
        class(sampled_function_t), intent(inout) :: self
        type(sampled_function_t), intent(inout) :: to

        call move_alloc(self%edges, to%edges)
        call move_alloc(self%from_root, to%from_root)
        call move_alloc(self%coefficients, to%coefficients)
        call move_alloc(self%derivatives, to%derivatives)
        call move_alloc(self%used, to%used)
        call move_alloc(self%integrals, to%integrals)
    end subroutine move_to

    !> What a copy takes [byte].
    pure function bytes(self)
        class(sampled_function_t), intent(in) :: self
        integer(int64) :: bytes

        bytes = real_bytes*(2*size(self%coefficients) + 4*size(self%edges))
    end function bytes

end module mdrcontact_numerics_sampler
