! SPDX-License-Identifier: GPL-3.0-or-later
!> Quadrature over contact radii: composite Gauss-Legendre rules (nodes from GSL) on panels that are graded by the problem.
!>
!> Integrands of contact mechanics are analytic except at known radii: the origin, where a modulus varies on the scale of the
!> thinnest layer and a profile may be a broken power, and the break radii of the profile, where g has a square-root branch to the
!> right (flat ends, tangent points, knots of a table). Panels that grow by a constant ratio from every such radius and a quadratic
!> substitution behind it make the rule converge exponentially, for any lengths in the integrand.
module mdrcontact_numerics_quadrature
    use, intrinsic :: iso_c_binding, only: c_associated, c_double, c_f_pointer, c_int, c_ptr, c_size_t
    use mdrcontact_cancel, only: check_cancelled
    use mdrcontact_error, only: check_memory, error_t
    use mdrcontact_gsl, only: disable_gsl_abort, gsl_integration_fixed_alloc, gsl_integration_fixed_free, &
                              gsl_integration_fixed_jacobi, gsl_integration_fixed_nodes, gsl_integration_fixed_weights, &
                              gsl_integration_glfixed_point, gsl_integration_glfixed_table_alloc, &
                              gsl_integration_glfixed_table_free
    use mdrcontact_kinds, only: wp
    implicit none (type, external)
    private
    public :: gauss_jacobi, gauss_legendre, legendre, graded_rule, graded_edges, mark_breaks, merge_breaks, new_antiderivative, &
              smallest_panel_ratio

    !> Nodes in a panel: a panel's nearest singularity lies at least a third of its length away, where 20 nodes give 1e-16.
    integer, parameter :: nodes_per_panel = 20
    !> Growth of the panels away from a singular radius.
    real(wp), parameter :: panel_growth = 4.0_wp
    !> Panels are not refined below this length, relative to the upper limit.
    real(wp), parameter :: shortest_panel = 1.0e-12_wp
    !> Where panels end towards the origin, relative to the upper limit; what lies below is for the leading-order term.
    real(wp), parameter :: smallest_panel_ratio = panel_growth**(-20)

contains

    !> Gauss-Legendre nodes and weights on [0, 1].
    subroutine gauss_legendre(nodes, weights, error)
        real(wp), intent(out) :: nodes(:)
        !> same size as nodes
        real(wp), intent(out) :: weights(:)
        type(error_t), allocatable, intent(inout) :: error
        type(c_ptr) :: table
        integer(c_int) :: status
        integer :: i

        call disable_gsl_abort()
        table = gsl_integration_glfixed_table_alloc(int(size(nodes), c_size_t))
        if (.not. c_associated(table)) then
            nodes = 0.5_wp
            weights = 0.0_wp
            call check_memory(error, 1)
            return
        end if
        ! it fails for an index beyond the table only; the other half mirrors these
        do i = 1, (size(nodes) + 1)/2
            status = gsl_integration_glfixed_point(0.0_wp, 1.0_wp, int(i - 1, c_size_t), nodes(i), weights(i), table)
            nodes(size(nodes) + 1 - i) = 1.0_wp - nodes(i)
            weights(size(nodes) + 1 - i) = weights(i)
        end do
        call gsl_integration_glfixed_table_free(table)
    end subroutine gauss_legendre

    !> Legendre polynomials P_0(u), P_1(u), ...: (place, polynomial). GSL rejects places that rounding puts beyond +-1.
    pure function legendre(number, u) result(p)
        !> how many, > 0
        integer, intent(in) :: number
        real(wp), intent(in) :: u(:)
        real(wp) :: p(size(u), number)
        integer :: k

        p(:, 1) = 1.0_wp
        if (number > 1) p(:, 2) = u
        do k = 3, number
            p(:, k) = (real(2*k - 3, wp)*u*p(:, k - 1) - real(k - 2, wp)*p(:, k - 2))/real(k - 1, wp)
        end do
    end function legendre

    !> Gauss-Jacobi nodes and weights on [0, 1] for the weight t^power.
    subroutine gauss_jacobi(power, nodes, weights, error)
        !> > -1
        real(wp), intent(in) :: power
        real(wp), intent(out) :: nodes(:)
        !> same size as nodes
        real(wp), intent(out) :: weights(:)
        type(error_t), allocatable, intent(inout) :: error
        type(c_ptr) :: rule
        real(c_double), pointer :: values(:)

        call disable_gsl_abort()
        rule = gsl_integration_fixed_alloc(gsl_integration_fixed_jacobi, int(size(nodes), c_size_t), 0.0_wp, 1.0_wp, 0.0_wp, power)
        if (.not. c_associated(rule)) then
            nodes = 0.5_wp
            weights = 0.0_wp
            call check_memory(error, 1)
            return
        end if
        call c_f_pointer(gsl_integration_fixed_nodes(rule), values, shape(nodes))
        nodes = values
        call c_f_pointer(gsl_integration_fixed_weights(rule), values, shape(weights))
        weights = values
        call gsl_integration_fixed_free(rule)
    end subroutine gauss_jacobi

    !> Gauss-Legendre nodes on [0, 1], and the matrix that takes values there to integrals from 0 to each node (rows 1 to n)
    !> and to 1 (row n + 1).
    subroutine new_antiderivative(nodes, matrix, error)
        real(wp), intent(out) :: nodes(:)
        !> (n + 1, n)
        real(wp), intent(out) :: matrix(:, :)
        type(error_t), allocatable, intent(inout) :: error
        real(wp), dimension(size(nodes) + 1) :: ends, u, before, here, next
        real(wp) :: weights(size(nodes))
        integer :: j

        call gauss_legendre(nodes, weights, error)
        ends = [nodes, 1.0_wp]
        u = 2.0_wp*ends - 1.0_wp
        before = 1.0_wp
        here = u
        matrix = spread(ends, 2, size(nodes))*spread(weights, 1, size(ends))
        do j = 1, size(nodes) - 1
            ! (2 j + 1) int_0^t P_j(2 s - 1) ds = (P_(j+1) - P_(j-1))/2, times what takes values to the coefficient of P_j
            next = (real(2*j + 1, wp)*u*here - real(j, wp)*before)/real(j + 1, wp)
            matrix = matrix + spread(0.5_wp*(next - before), 2, size(nodes))*spread(weights*here(:size(nodes)), 1, size(ends))
            before = here
            here = next
        end do
    end subroutine new_antiderivative

    !> Nodes s and weights ds of a composite rule over [lower, upper], graded towards 0, away from `breaks`
    !> and towards `singular_end` (the radius above `upper` where the integrand may blow up; huge() if none).
    subroutine graded_rule(lower, upper, breaks, singular_end, nodes, weights, error, distances, per_panel)
        !> 0 < lower < upper; for an integral from 0 take lower = upper*smallest_panel_ratio
        real(wp), intent(in) :: lower, upper
        !> ascending radii where the integrand is not analytic [length]
        real(wp), intent(in) :: breaks(:)
        real(wp), intent(in) :: singular_end
        real(wp), allocatable, intent(out) :: nodes(:), weights(:)
        type(error_t), allocatable, intent(inout) :: error
        !> nodes - lower without cancellation, for integrands that are singular there
        real(wp), allocatable, intent(out), optional :: distances(:)
        !> nodes in a panel, where rounding is not requested
        integer, intent(in), optional :: per_panel
        real(wp), allocatable :: edges(:), offsets(:), t(:), w(:)
        logical, allocatable :: at_break(:)
        real(wp) :: length
        integer :: panel, first, last, count, each, stat

        call check_cancelled(error)
        each = nodes_per_panel
        if (present(per_panel)) each = per_panel
        allocate (t(each), w(each))
        call gauss_legendre(t, w, error)
        call graded_edges(lower, upper, breaks, singular_end, edges, error)
        call mark_breaks(edges, breaks, at_break, error)
        if (allocated(error)) return
        count = (size(edges) - 1)*each
        allocate (nodes(count), weights(count), offsets(count), stat=stat)
        call check_memory(error, stat)
        if (allocated(error)) return
        do panel = 1, size(edges) - 1
            first = (panel - 1)*each + 1
            last = panel*each
            length = edges(panel + 1) - edges(panel)
            if (at_break(panel)) then
                offsets(first:last) = (edges(panel) - lower) + length*t**2
                weights(first:last) = 2.0_wp*length*t*w
            else
                offsets(first:last) = (edges(panel) - lower) + length*t
                weights(first:last) = length*w
            end if
        end do
        nodes = lower + offsets
        if (present(distances)) call move_alloc(offsets, distances)
    end subroutine graded_rule

    !> Adds to an ascending list of radii those of another, without repetitions. An error leaves the list as it was.
    pure subroutine merge_breaks(radii, more, error)
        !> not allocated: empty; allocated afterwards
        real(wp), allocatable, intent(inout) :: radii(:)
        real(wp), intent(in) :: more(:)
        type(error_t), allocatable, intent(inout) :: error
        real(wp), allocatable :: merged(:)
        real(wp) :: next
        integer :: i, j, count, stat

        if (.not. allocated(radii)) allocate (radii(0))
        if (allocated(error) .or. size(more) == 0) return
        allocate (merged(size(radii) + size(more)), stat=stat)
        call check_memory(error, stat)
        if (stat /= 0) return
        i = 1
        j = 1
        count = 0
        do while (i <= size(radii) .or. j <= size(more))
            next = huge(next)
            if (i <= size(radii)) next = radii(i)
            if (j <= size(more)) next = min(next, more(j))
            count = count + 1
            merged(count) = next
            i = i + count_upto(radii(i:), next)
            j = j + count_upto(more(j:), next)
        end do
        call move_alloc(merged, radii)
        if (count < size(radii)) call shorten(radii, count, error)
    end subroutine merge_breaks

    !> The first `count` of a list.
    pure subroutine shorten(list, count, error)
        real(wp), allocatable, intent(inout) :: list(:)
        integer, intent(in) :: count
        type(error_t), allocatable, intent(inout) :: error
        real(wp), allocatable :: first(:)
        integer :: stat

        allocate (first(count), stat=stat)
        call check_memory(error, stat)
        if (stat /= 0) return
        first(:) = list(:count)
        call move_alloc(first, list)
    end subroutine shorten

    !> Number of leading entries not above `limit`.
    pure function count_upto(list, limit) result(number)
        real(wp), intent(in) :: list(:), limit
        integer :: number

        do number = 0, size(list) - 1
            if (list(number + 1) > limit) return
        end do
        number = size(list)
    end function count_upto

    !> Whether each panel begins at a break.
    pure subroutine mark_breaks(edges, breaks, at_break, error)
        !> ascending, one more than there are panels
        real(wp), intent(in) :: edges(:)
        !> ascending
        real(wp), intent(in) :: breaks(:)
        logical, allocatable, intent(out) :: at_break(:)
        type(error_t), allocatable, intent(inout) :: error
        integer :: panel, passed, stat

        if (allocated(error)) return
        allocate (at_break(size(edges) - 1), stat=stat)
        call check_memory(error, stat)
        if (stat /= 0) return
        passed = 0
        do panel = 1, size(at_break)
            passed = passed + count_upto(breaks(passed + 1:), edges(panel))
            at_break(panel) = .false.
            if (passed > 0) at_break(panel) = breaks(passed) == edges(panel)
        end do
    end subroutine mark_breaks

    !> The edges of the panels of graded_rule.
    pure subroutine graded_edges(lower, upper, breaks, singular_end, edges, error)
        real(wp), intent(in) :: lower, upper, breaks(:), singular_end
        real(wp), allocatable, intent(out) :: edges(:)
        type(error_t), allocatable, intent(inout) :: error
        real(wp), allocatable :: longer(:)
        real(wp) :: here, next
        integer :: count, passed, stat

        passed = 0
        ! room for the breaks and the growth between two of them
        allocate (edges(64 + 2*size(breaks)), stat=stat)
        call check_memory(error, stat)
        if (allocated(error)) return
        count = 1
        edges(1) = lower
        here = lower
        do while (here < upper)
            passed = passed + count_upto(breaks(passed + 1:), here)
            next = here + step(here, breaks(:passed))
            if (passed < size(breaks)) next = min(next, breaks(passed + 1))
            if (upper - next < shortest_panel*upper .or. next <= here) next = upper
            count = count + 1
            if (count > size(edges)) then
                allocate (longer(2*size(edges)), stat=stat)
                call check_memory(error, stat)
                if (allocated(error)) return
                longer(:size(edges)) = edges
                call move_alloc(longer, edges)
            end if
            edges(count) = next
            here = next
        end do
        call shorten(edges, count, error)

    contains

        !> Panel length at `here`: proportional to the distance from the nearest singular radius behind and ahead.
        pure function step(here, behind) result(length)
            real(wp), intent(in) :: here
            !> the breaks up to there
            real(wp), intent(in) :: behind(:)
            real(wp) :: length
            logical :: at_break
            integer :: i

            at_break = .false.
            length = here
            do i = size(behind), 1, -1
                if (behind(i) < here) then
                    ! a break may lie below 0
                    length = min(here, here - behind(i))
                    exit
                end if
                at_break = .true.
            end do
            if (.not. at_break) length = (panel_growth - 1.0_wp)*length
            length = min(length, 0.75_wp*(singular_end - here))
        end function step

    end subroutine graded_edges

end module mdrcontact_numerics_quadrature
