! SPDX-License-Identifier: GPL-3.0-or-later
!> Several functions of one variable that cost much, side by side, sampled to a tolerance: neighbouring panels must meet, and
!> functions that jump are refused.
!>
!> Users: contact_curve and contact_zone_curve (laws, branches, loops, fits).
module mdrcontact_numerics_sampled_columns
    use mdrcontact_error, only: check_memory, error_no_convergence, error_t, raise, to_text
    use mdrcontact_kinds, only: pi, wp
    use mdrcontact_numerics_chebyshev, only: terms
    use mdrcontact_numerics_sampler, only: column_source_t, lanes, panels_t, sample_panels, sampling_t
    use mdrcontact_numerics_search, only: interval_of
    implicit none (type, external)
    private
    public :: columns_t, new_columns, series

    !> Where columns are compared with their functions, in the panel's variable: where the polynomial that vanishes at the nodes, of
    !> values and of slopes alike, is largest.
    real(wp), parameter :: between(1) = [cos(0.625_wp*pi)]
    !> A break closer to an edge than this is there.
    real(wp), parameter :: no_room = 1.0e-9_wp

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

    !> The first columns at z in a panel, -1 at its left and 1 at its right edge, and their slopes in z.
    pure subroutine in_panel(self, panel, z, values, slopes)
        class(columns_t), intent(in) :: self
        integer, intent(in) :: panel
        real(wp), intent(in) :: z
        !> of the requested columns, and the same size
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

end module mdrcontact_numerics_sampled_columns
