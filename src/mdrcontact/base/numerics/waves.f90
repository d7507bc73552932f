! SPDX-License-Identifier: GPL-3.0-or-later
!> Integrals over wavenumbers, and even Legendre polynomials in Fourier space: with k in units of 1/a the integral operators of a
!> contact are matrices
!>     (2/pi) int_0^inf f(k) b_i b_j dk,  b_j = sqrt(4j + 1) (-1)^j j_2j(k) = sqrt(4j + 1) int_0^1 P_2j(x) cos(kx) dx
!> (theory/conduction.md (9.1), theory/poroelastic.md (6.1)).
!>
!> Beyond the last node j_l = (h_l + conj h_l)/2 splits products into their mean, which is smooth, and waves exp(+-2 i k), which
!> fall along the imaginary direction: nothing is cut off.
module mdrcontact_numerics_waves
    use mdrcontact_error, only: error_domain, error_t, raise, to_text
    use mdrcontact_kinds, only: pi, wp
    use mdrcontact_numerics_even_waves, only: even_waves
    use mdrcontact_numerics_one_thread, only: add_product
    use mdrcontact_numerics_quadrature, only: gauss_legendre
    implicit none (type, external)
    private
    public :: wave_rule, panel_nodes, legendre_waves, basis_t, new_basis

    !> Nodes in a panel; the largest phase of cos(kx) in one, where 16 nodes integrate to 1e-16.
    integer, parameter :: panel_nodes = 16
    real(wp), parameter :: longest_phase = 15.0_wp
    !> Nodes at most: some seconds.
    real(wp), parameter :: most_nodes = 1.0e6_wp
    !> Nodes beyond the last wave, of the mean and of the waves' fall, which exp(-2 deepest) ends.
    integer, parameter :: far_nodes = 24
    real(wp), parameter :: deepest = 18.0_wp
    !> Products b_i b_j, and nodes, of one step of the sums for several functions.
    integer, parameter :: block_pairs = 48, block_nodes = 64

    !> The polynomials at the nodes of a rule.
    type :: basis_t
        integer :: order = 0
        !> wavenumbers: of products of two real numbers, then of products of two outgoing waves
        complex(wp), allocatable :: k(:)
        !> weights with 2/pi, and b_j (order, node) for the first ones; b_0 - cos k, what is left next to the value at the edge
        real(wp), allocatable :: weight(:), b(:, :), inner(:)
        !> the same for the others, whose cos k is 1
        complex(wp), allocatable :: far_weight(:), outgoing(:, :)
    contains
        procedure :: project, project_each
    end type basis_t

contains

    !> Nodes k and weights dk on [0, last]: panels of one octave from `first` on, then of one length.
    subroutine wave_rule(first, last, farthest, k, weight, error)
        !> below `first` > 0 nothing varies [1/length]
        real(wp), intent(in) :: first, last
        !> the largest x > 0 of waves cos(kx) in the integrand [length]
        real(wp), intent(in) :: farthest
        real(wp), allocatable, intent(out) :: k(:), weight(:)
        type(error_t), allocatable, intent(inout) :: error
        real(wp), allocatable :: ends(:)
        real(wp) :: node(panel_nodes), w(panel_nodes)
        integer :: i

        if (allocated(error)) return
        call gauss_legendre(node, w, error)
        if (allocated(error)) return
        if (last*farthest > most_nodes/panel_nodes*longest_phase) then
            call raise(error, error_domain, "points at this distance need "//to_text(panel_nodes*last*farthest/longest_phase)// &
                       " waves, and the limit is "//to_text(most_nodes)//". Choose points closer to the contact")
            return
        end if
        call panel_ends(min(first, last), last, longest_phase/farthest, ends)
        allocate (k(panel_nodes*(size(ends) - 1)), weight(panel_nodes*(size(ends) - 1)))
        do i = 1, size(ends) - 1
            k(panel_nodes*(i - 1) + 1:panel_nodes*i) = ends(i) + (ends(i + 1) - ends(i))*node
            weight(panel_nodes*(i - 1) + 1:panel_nodes*i) = (ends(i + 1) - ends(i))*w
        end do
    end subroutine wave_rule

    pure subroutine panel_ends(first, last, longest, ends)
        real(wp), intent(in) :: first, last, longest
        real(wp), allocatable, intent(out) :: ends(:)
        integer :: octaves, equal

        ! octaves until they are longer than the longest panel
        octaves = max(0, ceiling(log(min(longest, last)/first)/log(2.0_wp)))
        allocate (ends(0))
        ends = [0.0_wp, first*2.0_wp**[(equal, equal=0, octaves)]]
        if (ends(size(ends)) >= last) then
            ends = [pack(ends, ends < last), last]
            return
        end if
        associate (from => ends(size(ends)))
            equal = ceiling((last - from)/longest)
            ends = [ends, from + (last - from)*[(real(octaves, wp)/real(equal, wp), octaves=1, equal)]]
        end associate
    end subroutine panel_ends

    !> b_j at wavenumbers >= 0.
    subroutine legendre_waves(k, b, error)
        real(wp), intent(in) :: k(:)
        !> (j, wavenumber)
        real(wp), intent(out) :: b(:, :)
        type(error_t), allocatable, intent(inout) :: error
        real(wp) :: normalisation(size(b, 1))
        integer :: i

        normalisation = [(sqrt(4.0_wp*i - 3.0_wp), i=1, size(b, 1))]
        do i = 1, size(k)
            call even_waves(k(i), b(:, i), error)
            if (allocated(error)) return
            b(:, i) = normalisation*b(:, i)
        end do
    end subroutine legendre_waves

    !> For functions that vary over octaves from `first` on and are smooth beyond `last` >= 4 order.
    subroutine new_basis(self, order, first, last, error)
        type(basis_t), intent(out) :: self
        integer, intent(in) :: order
        real(wp), intent(in) :: first, last
        type(error_t), allocatable, intent(inout) :: error
        real(wp) :: node(far_nodes), share(far_nodes)
        real(wp), allocatable :: k(:), weight(:)
        complex(wp) :: far(far_nodes), h(order)
        integer :: i, n

        ! products oscillate as cos 2k
        call wave_rule(first, last, 2.0_wp, k, weight, error)
        call gauss_legendre(node, share, error)
        if (allocated(error)) return
        n = size(k)
        self%order = order
        allocate (self%b(order, n + 2*far_nodes), self%inner(n + 2*far_nodes), self%outgoing(order, 2*far_nodes))
        call legendre_waves(k, self%b(:, :n), error)
        self%inner(:n) = self%b(1, :n) - cos(k)
        ! the mean of b_i b_j is Re(h_i conj h_j)/2; int_K^inf f dk = int_0^1 f(K/t) K/t^2 dt
        far = cmplx(last, deepest*node, wp)
        do i = 1, far_nodes
            h = outgoing_waves(cmplx(last/node(i), 0.0_wp, wp), order)
            self%b(:, n + i) = real(h, wp)
            self%b(:, n + far_nodes + i) = aimag(h)
            self%outgoing(:, i) = outgoing_waves(far(i), order)
        end do
        self%inner(n + 1:) = self%b(1, n + 1:)
        self%inner(n + 1:n + far_nodes) = self%b(1, n + 1:n + far_nodes) - 1.0_wp
        self%outgoing(:, far_nodes + 1:) = conjg(self%outgoing(:, :far_nodes))
        self%far_weight = (0.0_wp, 0.5_wp)/pi*deepest*share*exp((0.0_wp, 2.0_wp)*far)
        self%far_weight = [self%far_weight, conjg(self%far_weight)]
        self%weight = [2.0_wp/pi*weight, share*last/node**2/pi, share*last/node**2/pi]
        self%k = [cmplx(k, kind=wp), cmplx(last/node, kind=wp), cmplx(last/node, kind=wp), far, conjg(far)]
    end subroutine new_basis

    !> sqrt(4j + 1) (-1)^j h_2j(k) exp(-ik), by the recurrence that outgoing waves dominate.
    pure function outgoing_waves(k, order) result(h)
        complex(wp), intent(in) :: k
        integer, intent(in) :: order
        complex(wp) :: h(order)
        complex(wp) :: before, here
        integer :: j

        before = (0.0_wp, -1.0_wp)/k
        here = -(1.0_wp + (0.0_wp, 1.0_wp)/k)/k
        h(1) = before
        do j = 1, order - 1
            before = (4*j - 1)/k*here - before
            h(j + 1) = (-1)**j*sqrt(4.0_wp*j + 1.0_wp)*before
            here = (4*j + 1)/k*before - here
        end do
    end function outgoing_waves

    !> The matrix (2/pi) int f b_i b_j dk.
    subroutine project(self, f, matrix)
        class(basis_t), intent(in) :: self
        !> at self%k
        complex(wp), intent(in) :: f(:)
        !> (order, order)
        complex(wp), intent(out) :: matrix(:, :)
        real(wp), allocatable :: scaled(:, :)
        real(wp) :: product(2*self%order, self%order)
        complex(wp) :: far(self%order, size(self%far_weight))
        integer :: i, n, m

        n = self%order
        m = size(self%weight)
        allocate (scaled(2*n, m))
        do i = 1, m
            scaled(:n, i) = self%b(:, i)*(self%weight(i)*real(f(i), wp))
            scaled(n + 1:, i) = self%b(:, i)*(self%weight(i)*aimag(f(i)))
        end do
        call add_product("N", "T", 2*n, n, m, 1.0_wp, scaled, 2*n, self%b, n, 0.0_wp, product, 2*n)
        do i = 1, size(far, 2)
            far(:, i) = self%outgoing(:, i)*(self%far_weight(i)*f(m + i))
        end do
        matrix = cmplx(product(:n, :), product(n + 1:, :), wp) + matmul(far, transpose(self%outgoing))
    end subroutine project

    !> The matrices of several functions: the products b_i b_j are formed once, i >= j.
    subroutine project_each(self, f, is_inner, matrices)
        class(basis_t), intent(in) :: self
        !> (node, function) at self%k
        complex(wp), intent(in) :: f(:, :)
        !> with b_0 - cos k for the b_0 of the rows
        logical, intent(in) :: is_inner
        !> (order, order, function)
        complex(wp), intent(out) :: matrices(:, :, :)
        complex(wp), allocatable :: values(:, :)
        integer, allocatable :: row(:), column(:)
        integer :: p

        call list_pairs(self%order, is_inner, row, column)
        allocate (values(size(row), size(f, 2)))
        call add_near(self, row, column, f, values)
        call add_far(self, row, column, f, values)
        do p = 1, size(row)
            matrices(max(row(p), 1), column(p), :) = values(p, :)
            if (row(p) > 0) matrices(column(p), row(p), :) = values(p, :)
        end do
    end subroutine project_each

    !> Rows and columns of the elements that determine the matrix. Row 0 is the first one with b_0 - cos k, listed last.
    pure subroutine list_pairs(order, is_inner, row, column)
        integer, intent(in) :: order
        logical, intent(in) :: is_inner
        integer, allocatable, intent(out) :: row(:), column(:)
        integer :: i, j

        row = [((i, i=j, order), j=1, order)]
        column = [((j, i=j, order), j=1, order)]
        if (.not. is_inner) return
        row = [row(2:), (0, j=1, order)]
        column = [column(2:), (j, j=1, order)]
    end subroutine list_pairs

    !> The integrals over products of two real numbers.
    subroutine add_near(self, row, column, f, values)
        class(basis_t), intent(in) :: self
        integer, intent(in) :: row(:), column(:)
        complex(wp), intent(in) :: f(:, :)
        !> (pair, function)
        complex(wp), intent(out) :: values(:, :)
        real(wp), allocatable :: b(:, :), parts(:, :)
        real(wp) :: products(block_nodes, block_pairs), sums(block_pairs, 2*size(f, 2))
        integer :: i, m, n, first, pairs, start, nodes

        m = size(self%weight)
        n = size(f, 2)
        allocate (b(m, 0:self%order), parts(m, 2*n))
        b(:, 0) = self%inner
        b(:, 1:) = transpose(self%b)
        do i = 1, n
            parts(:, i) = self%weight*real(f(:m, i), wp)
            parts(:, n + i) = self%weight*aimag(f(:m, i))
        end do
        do first = 1, size(row), block_pairs
            pairs = min(block_pairs, size(row) - first + 1)
            sums = 0.0_wp
            do start = 1, m, block_nodes
                nodes = min(block_nodes, m - start + 1)
                do i = 1, pairs
                    products(:nodes, i) = b(start:start + nodes - 1, row(first + i - 1)) &
                                          *b(start:start + nodes - 1, column(first + i - 1))
                end do
                call add_product("T", "N", pairs, 2*n, nodes, 1.0_wp, products, block_nodes, parts(start, 1), m, 1.0_wp, sums, &
                                 block_pairs)
            end do
            values(first:first + pairs - 1, :) = cmplx(sums(:pairs, :n), sums(:pairs, n + 1:), wp)
        end do
    end subroutine add_near

    !> Adds the integrals over products of two outgoing waves.
    subroutine add_far(self, row, column, f, values)
        class(basis_t), intent(in) :: self
        integer, intent(in) :: row(:), column(:)
        complex(wp), intent(in) :: f(:, :)
        complex(wp), intent(inout) :: values(:, :)
        complex(wp) :: waves(0:self%order, size(self%far_weight)), products(size(row), size(self%far_weight))
        integer :: i

        waves(0, :) = self%outgoing(1, :) - 1.0_wp
        waves(1:, :) = self%outgoing
        do i = 1, size(self%far_weight)
            products(:, i) = self%far_weight(i)*waves(row, i)*waves(column, i)
        end do
        values = values + matmul(products, f(size(self%weight) + 1:, :))
    end subroutine add_far

end module mdrcontact_numerics_waves
