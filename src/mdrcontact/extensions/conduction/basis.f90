! SPDX-License-Identifier: GPL-3.0-or-later
!> Even Legendre polynomials in Fourier space for kernels in time, whose chi falls as k^-2 alone:
!>     A_ij = delta_ij + (2/pi) int_0^inf chi b_i b_j dk,  b_j = sqrt(4j + 1) (-1)^j j_2j(k),  k in units of 1/a
!> (theory/conduction.md (9.1)).
!>
!> Beyond the last node j_l = (h_l + conj h_l)/2 splits products into their mean, which is smooth, and waves exp(+-2 i k), which
!> fall along the imaginary direction: nothing is cut off.
module mdrcontact_conduction_basis
    use mdrcontact_conduction_waves, only: wave_rule
    use mdrcontact_error, only: error_t
    use mdrcontact_kinds, only: pi, wp
    use mdrcontact_lapack, only: dgemm
    use mdrcontact_numerics_even_waves, only: even_waves
    use mdrcontact_numerics_quadrature, only: gauss_legendre
    implicit none (type, external)
    private
    public :: basis_t, new_basis

    !> Nodes beyond the last wave: of the mean, and of each panel of the waves' fall.
    integer, parameter :: far_nodes = 24, fall_nodes = 16, fall_panels = 3
    !> exp(-2 x) there.
    real(wp), parameter :: deepest = 18.0_wp

    !> Waves of one number of polynomials.
    type :: basis_t
        integer :: order = 0
        !> nodes, weights with 2/pi, and b (order, node)
        real(wp), allocatable :: k(:), weight(:), b(:, :)
        !> wavenumbers beyond the last, their weights, and the two factors of each product
        complex(wp), allocatable :: far(:), far_weight(:), left(:, :), right(:, :)
    contains
        procedure :: project
    end type basis_t

contains

    !> For chi that varies over octaves from `first` on and is smooth beyond `last`.
    subroutine new_basis(self, order, first, last, error)
        type(basis_t), intent(out) :: self
        integer, intent(in) :: order
        real(wp), intent(in) :: first, last
        type(error_t), allocatable, intent(inout) :: error
        integer :: i, n

        self%order = order
        call wave_rule(first, last, 1.0_wp, self%k, self%weight, error)
        if (allocated(error)) return
        n = far_nodes + 2*fall_nodes*fall_panels
        allocate (self%b(order, size(self%k)), self%far(n), self%far_weight(n), self%left(order, n), self%right(order, n))
        self%weight = self%weight*(2.0_wp/pi)
        do i = 1, size(self%k)
            call even_waves(self%k(i), self%b(:, i), error)
            if (allocated(error)) return
        end do
        do i = 1, order
            self%b(i, :) = sqrt(4.0_wp*i - 3.0_wp)*self%b(i, :)
        end do
        call fill_far(self, last, error)
    end subroutine new_basis

    subroutine fill_far(self, last, error)
        type(basis_t), intent(inout) :: self
        real(wp), intent(in) :: last
        type(error_t), allocatable, intent(inout) :: error
        real(wp) :: node(far_nodes), weight(far_nodes), fall(fall_nodes), fall_weight(fall_nodes), step
        complex(wp) :: phase
        integer :: i, j, n

        call gauss_legendre(node, weight, error)
        call gauss_legendre(fall, fall_weight, error)
        if (allocated(error)) return
        ! int_K^inf f dk = int_0^1 f(K/t) K/t^2 dt
        do i = 1, far_nodes
            self%far(i) = last/node(i)
            self%far_weight(i) = weight(i)*last/node(i)**2/pi
            self%left(:, i) = outgoing(self%far(i), self%order)
            self%right(:, i) = conjg(self%left(:, i))
        end do
        n = far_nodes
        step = deepest/fall_panels
        phase = exp(cmplx(0.0_wp, 2.0_wp*last, wp))
        do j = 1, fall_panels
            do i = 1, fall_nodes
                n = n + 1
                self%far(n) = cmplx(last, step*(j - 1 + fall(i)), wp)
                self%far_weight(n) = 0.5_wp/pi*phase*(0.0_wp, 1.0_wp)*step*fall_weight(i)*exp(-2.0_wp*aimag(self%far(n)))
                self%left(:, n) = outgoing(self%far(n), self%order)
                self%right(:, n) = self%left(:, n)
                n = n + 1
                self%far(n) = conjg(self%far(n - 1))
                self%far_weight(n) = conjg(self%far_weight(n - 1))
                self%left(:, n) = conjg(self%left(:, n - 1))
                self%right(:, n) = self%left(:, n)
            end do
        end do
    end subroutine fill_far

    !> sqrt(4j + 1) (-1)^j h_2j(k) exp(-ik), by the recurrence that outgoing waves dominate.
    pure function outgoing(k, order) result(h)
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
    end function outgoing

    !> The matrix of chi: at the nodes, and at `far`.
    subroutine project(self, chi, far, matrix)
        class(basis_t), intent(in) :: self
        complex(wp), intent(in) :: chi(:), far(:)
        !> (order, order)
        complex(wp), intent(out) :: matrix(:, :)
        real(wp), allocatable :: scaled(:, :), product(:, :)
        integer :: i, j, n

        n = self%order
        allocate (scaled(2*n, size(self%k)), product(2*n, n))
        do i = 1, size(self%k)
            scaled(:n, i) = self%b(:, i)*(self%weight(i)*real(chi(i), wp))
            scaled(n + 1:, i) = self%b(:, i)*(self%weight(i)*aimag(chi(i)))
        end do
        call dgemm("N", "T", 2*n, n, size(self%k), 1.0_wp, scaled, 2*n, self%b, n, 0.0_wp, product, 2*n)
        matrix = cmplx(product(:n, :), product(n + 1:, :), wp)
        do i = 1, size(far)
            do j = 1, n
                if (i <= far_nodes) then
                    matrix(:, j) = matrix(:, j) + far(i)*self%far_weight(i)*real(self%left(:, i)*self%right(j, i), wp)
                else
                    matrix(:, j) = matrix(:, j) + far(i)*self%far_weight(i)*self%right(j, i)*self%left(:, i)
                end if
            end do
        end do
        do j = 1, n
            matrix(j, j) = matrix(j, j) + 1.0_wp
        end do
    end subroutine project

end module mdrcontact_conduction_basis
