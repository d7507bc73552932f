! SPDX-License-Identifier: GPL-3.0-or-later
!> Panels on which functions of one variable that cost much are short polynomials.
!>
!> Piecewise Chebyshev series, from values alone or from values and slopes. A panel is halved until its last terms vanish and the
!> series meets the functions where they were not sampled. A panel that begins at a break uses the variable sqrt(x - left edge), in
!> which the square-root branches of contact mechanics are analytic. One function is `sampled_function_t` of
!> numerics_sampled_function, several are `columns_t` of numerics_sampled_columns.
module mdrcontact_numerics_sampler
    use mdrcontact_cancel, only: check_cancelled
    use mdrcontact_error, only: check_memory, error_no_convergence, error_t, raise, to_text
    use mdrcontact_kinds, only: wp
    use mdrcontact_nonfinite, only: is_finite
    use mdrcontact_numerics_chebyshev, only: chebyshev_sum, cosine_transform, half, node, series_of_slopes, &
                                             series_of_values, terms
    implicit none (type, external)
    private
    public :: column_source_t, lanes, panels_t, part, sample_panels, sampling_t, smallest_root

    !> Columns that are summed side by side.
    integer, parameter :: lanes = 4
    !> Largest number of halvings of a panel.
    integer, parameter :: most_halvings = 64
    !> Halving a panel makes its last terms many times smaller: where more than this part is left, slopes may be less exact than
    !> values.
    real(wp), parameter :: least_gain = 0.1_wp
    !> Halving a panel of smooth columns below this length makes their last terms many times smaller: else they are noise.
    real(wp), parameter :: noisy_length = 0.25_wp
    !> Edges closer than this part of the shortest length were named, around a kink: halving leaves no such panel.
    real(wp), parameter :: negligible = 0.5_wp
    !> Where a function may have steps of noise, a panel shorter than the first, relative to its distance from 0, is a straight line
    !> if its last terms have not fallen below the second times the others: it holds a kink or noise, of which a polynomial has
    !> slopes that the function has nowhere.
    real(wp), parameter :: narrow_panel = 1.0e-6_wp, least_fall = 1.0e-3_wp
    !> The slope in x of a function of t = sqrt(x - left edge) is taken no closer to the edge than this t: 1/t amplifies rounding.
    real(wp), parameter :: smallest_root = 1.0e-5_wp

    !> Options of the sampling of functions.
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

    !> Sampled functions.
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
        !> The columns at x and, if requested and has_slopes remains true, their slopes.
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

    !> Panels that are to be sampled.
    type :: waiting_t
        !> how many, and how many there is room for
        integer :: count = 0, room = 0
        !> left edge, right edge, and what the last terms were before the panel was halved; leftmost on top, so that finished panels
        !> come in ascending order
        real(wp), allocatable :: edges(:, :)
        !> whether it begins at a square-root branch
        logical, allocatable :: roots(:)
    end type waiting_t

    !> Outcome for a panel.
    integer, parameter :: keep = 0, halve = 1, by_values = 2

    !> A panel that is sampled.
    type :: trial_t
        real(wp) :: left = 0.0_wp, right = 0.0_wp, before = 0.0_wp
        logical :: root = .false.
        !> whether slopes are used, and whether values alone were tried instead
        logical :: by_slopes = .false., tested = .false.
        !> its distance from 0, its last terms, what they may be, and by how much it misses its functions
        real(wp) :: distance = 0.0_wp, tail = 0.0_wp, allowed = 0.0_wp, missed = 0.0_wp
        integer :: verdict = keep
    end type trial_t

contains

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
        type(waiting_t) :: waiting
        type(trial_t) :: trial
        real(wp) :: cosines(source%terms, source%terms), basis(source%terms, size(places)), panel(source%columns, source%terms)
        integer :: count

        cosines = 0.0_wp
        if (source%terms /= terms) call cosine_transform(cosines)
        basis = polynomials_at(places, source%terms)
        count = 0
        call put_all(waiting, edges, roots, error)
        if (.not. allocated(error)) call resize(self, kept, reached, shape(panel), 0, waiting%room, error)
        trial%by_slopes = source%has_slopes
        do while (waiting%count > 0 .and. .not. allocated(error))
            call next_of(waiting, trial)
            if (count + waiting%count > sampling%most_panels .or. waiting%count == waiting%room) then
                call refuse(source, trial%left, " is not smooth or not accurate enough to be sampled", error)
            else
                call check_cancelled(error)
                if (.not. allocated(error)) call try_panel(source, sampling, cosines, places, basis, trial, panel, error)
            end if
            if (allocated(error)) return
            select case (trial%verdict)
            case (by_values)
                cycle
            case (halve)
                trial%by_slopes = source%has_slopes
                call put_halves(waiting, trial)
            case default
                if (has_jump(sampling, trial) .and. trial%right < edges(size(edges))) then
                    call refuse(source, trial%left, " jumps", error, ": the error of its samples is "//to_text(trial%missed)// &
                                ". Smooth the indenter or the medium there")
                    return
                end if
                call straighten_noise(sampling, trial, 0.5_wp*source%terms*cosines(1, 2), panel)
                count = count + 1
                if (count > size(reached)) call resize(self, kept, reached, shape(panel), count - 1, 2*count, error)
                if (allocated(error)) return
                self%edges(count:count + 1) = [trial%left, trial%right]
                self%from_root(count) = trial%root
                kept(:, :, count) = panel
                reached(count) = max(trial%tail, trial%allowed)
                self%error = max(self%error, trial%missed)
                waiting%count = waiting%count - 1
            end select
        end do
        if (.not. allocated(error)) call resize(self, kept, reached, shape(panel), count, count, error)
    end subroutine sample_panels

    !> The series of a panel, and whether it is its functions.
    subroutine try_panel(source, sampling, cosines, places, basis, trial, panel, error)
        class(column_source_t), intent(inout) :: source
        type(sampling_t), intent(in) :: sampling
        real(wp), intent(in) :: cosines(:, :), places(:), basis(:, :)
        type(trial_t), intent(inout) :: trial
        real(wp), intent(out) :: panel(:, :)
        type(error_t), allocatable, intent(inout) :: error
        real(wp) :: shortest
        logical :: fits

        call sample_panel(source, trial%left, trial%right, trial%root, trial%by_slopes, cosines, panel, error)
        if (allocated(error)) return
        trial%verdict = by_values
        if (trial%by_slopes .and. .not. source%has_slopes) then
            trial%by_slopes = .false.
            return
        end if
        if (.not. all(is_finite(panel(:source%counted, :)))) then
            call refuse(source, trial%left, " exceeds the range of double precision", error)
            return
        end if
        trial%distance = max(abs(trial%left), abs(trial%right), sampling%least_size)
        shortest = max(sampling%shortest_length, sampling%shortest_part*trial%distance)
        trial%tail = largest(source, panel, panel(:, source%terms - sampling%last_terms + 1:))
        trial%allowed = source%allowed(sampling, panel, trial%left, trial%right, trial%tail, trial%before)
        if (trial%by_slopes .and. trial%tail > trial%allowed .and. &
            (.not. trial%tested .or. trial%tail > least_gain*trial%before)) then
            ! if values alone make the panel, slopes are left for good
            trial%by_slopes = .false.
            trial%tested = .true.
            return
        end if
        fits = trial%tail <= trial%allowed
        trial%missed = trial%tail
        ! slopes that do not belong to the values show in the last terms
        if (.not. trial%by_slopes .and. (fits .or. trial%right - trial%left <= shortest)) then
            call compare(source, trial%left, trial%right, trial%root, panel, places, basis, trial%missed, error)
            if (allocated(error)) return
            fits = trial%missed <= sampling%margin*max(trial%tail, trial%allowed)
        end if
        trial%missed = max(trial%missed, trial%tail)
        trial%verdict = merge(keep, halve, fits .or. .not. trial%right - trial%left > shortest)
    end subroutine try_panel

    !> Raises what is wrong with the functions near the left edge of a panel.
    subroutine refuse(source, left, what, error, more)
        class(column_source_t), intent(in) :: source
        real(wp), intent(in) :: left
        !> verb, and what follows the place
        character(len=*), intent(in) :: what
        type(error_t), allocatable, intent(inout) :: error
        character(len=*), intent(in), optional :: more
        character(len=:), allocatable :: place

        place = " near "//trim(source%argument)//" = "//to_text(source%radius(left))
        if (present(more)) place = place//more
        call raise(error, error_no_convergence, trim(source%what)//what//place)
    end subroutine refuse

    !> Whether a panel of the shortest length misses its functions by more than a kink does. At the end of the last panel, which may
    !> be that of a sphere, depths may grow without bound.
    pure function has_jump(sampling, trial) result(answer)
        type(sampling_t), intent(in) :: sampling
        type(trial_t), intent(in) :: trial
        logical :: answer

        answer = trial%missed > max(sampling%largest_miss, sampling%margin*trial%allowed) &
                 .and. trial%right - trial%left > negligible*sampling%shortest_length
    end function has_jump

    !> Straight lines in place of series that hold steps of noise.
    pure subroutine straighten_noise(sampling, trial, z, panel)
        type(sampling_t), intent(in) :: sampling
        type(trial_t), intent(in) :: trial
        real(wp), intent(in) :: z
        real(wp), intent(inout) :: panel(:, :)
        integer :: row

        if (.not. (sampling%steps > 0.0_wp .and. trial%right - trial%left < narrow_panel*trial%distance .and. &
                   trial%tail > least_fall*maxval(abs(panel(:, 3:))))) return
        do row = 1, size(panel, 1)
            call straighten(panel(row, :), z)
        end do
    end subroutine straighten_noise

    !> The first polynomials at some places (terms, places).
    pure function polynomials_at(places, count) result(basis)
        real(wp), intent(in) :: places(:)
        integer, intent(in) :: count
        real(wp) :: basis(count, size(places))
        integer :: i

        basis(1, :) = 1.0_wp
        basis(2, :) = places
        do i = 3, count
            basis(i, :) = 2.0_wp*places*basis(i - 1, :) - basis(i - 2, :)
        end do
    end function polynomials_at

    !> All panels wait.
    pure subroutine put_all(self, edges, roots, error)
        type(waiting_t), intent(inout) :: self
        real(wp), intent(in) :: edges(:)
        logical, intent(in) :: roots(:)
        type(error_t), allocatable, intent(inout) :: error
        integer :: n, stat

        n = size(roots)
        allocate (self%edges(3, n + most_halvings + 1), self%roots(n + most_halvings + 1), stat=stat)
        call check_memory(error, stat)
        if (stat /= 0) return
        self%edges(1, :n) = edges(n:1:-1)
        self%edges(2, :n) = edges(n + 1:2:-1)
        self%edges(3, :n) = huge(1.0_wp)
        self%roots(:n) = roots(n:1:-1)
        self%count = n
        self%room = size(self%roots)
    end subroutine put_all

    !> The leftmost panel.
    pure subroutine next_of(self, trial)
        type(waiting_t), intent(in) :: self
        type(trial_t), intent(inout) :: trial

        trial%left = self%edges(1, self%count)
        trial%right = self%edges(2, self%count)
        trial%before = self%edges(3, self%count)
        trial%root = self%roots(self%count)
    end subroutine next_of

    !> Both halves of the leftmost panel in its place.
    pure subroutine put_halves(self, trial)
        type(waiting_t), intent(inout) :: self
        type(trial_t), intent(in) :: trial
        real(wp) :: middle

        middle = 0.5_wp*(trial%left + trial%right)
        self%edges(:, self%count + 1) = [trial%left, middle, trial%tail]
        self%edges(:, self%count) = [middle, trial%right, trial%tail]
        self%roots(self%count + 1) = trial%root
        self%roots(self%count) = .false.
        self%count = self%count + 1
    end subroutine put_halves

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

    !> Accuracy that values near x cannot have; none by default.
    pure function attainable(self, x) result(accuracy)
        class(column_source_t), intent(in) :: self
        real(wp), intent(in) :: x
        real(wp) :: accuracy

        associate (unused_source => self, unused_x => x)
        end associate
        accuracy = 0.0_wp
    end function attainable

    !> Limits of the last terms of columns.
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

    !> Size of some numbers of each counted column, in the norm of the errors.
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
        real(wp), intent(inout) :: c(:)
        real(wp), intent(in) :: z
        real(wp) :: ends(2)

        ends = [chebyshev_sum(c, -abs(z)), chebyshev_sum(c, abs(z))]
        c = 0.0_wp
        c(1) = 0.5_wp*sum(ends)
        c(2) = 0.5_wp*(ends(2) - ends(1))/abs(z)
    end subroutine straighten

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

end module mdrcontact_numerics_sampler
