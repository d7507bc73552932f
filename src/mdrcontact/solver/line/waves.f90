! SPDX-License-Identifier: GPL-3.0-or-later
!> exp(iky) on a ray of wavenumbers k = t exp(i theta), octave by octave of k y: the part of a kernel's tabulation that is the
!> same for every body. Bodies that are made one after the other share it.
module mdrcontact_line_waves
    use mdrcontact_error, only: check_memory, error_t
    use mdrcontact_kinds, only: wp
    use mdrcontact_line_kernel, only: degree
    use mdrcontact_numerics_chebyshev, only: node
    use mdrcontact_numerics_quadrature, only: gauss_legendre
    implicit none (type, external)
    private
    public :: wave_table_t, new_wave_table, panel_nodes, order, first_wave

    !> Nodes in a panel of wavenumbers.
    integer, parameter :: panel_nodes = 20
    !> Below this octave of k y (k y < 1/64) exp(iky) is its power series of this order.
    integer, parameter :: first_wave = -8, order = 7
    !> Octaves of k that the table for y <= 1 holds: a homogeneous first layer leaves nothing beyond.
    integer, parameter :: last_near = 4
    !> |exp(iky)| beyond which nothing is left: exp(-faded).
    real(wp), parameter :: faded = 45.0_wp

    !> Waves on one ray. Made by new_wave_table.
    type :: wave_table_t
        !> exp(i theta)
        complex(wp) :: direction = 1.0_wp
        !> the base octave [1, 2) of wavenumbers
        real(wp), allocatable :: nodes(:), weights(:)
        !> what takes values on a panel to its last two Legendre coefficients
        real(wp) :: last(panel_nodes, 2) = 0.0_wp
        !> (node, n): (i k)^n/n! on the base octave
        complex(wp), allocatable :: powers(:, :)
        !> how often halves of octaves of the kernel are halved
        integer :: halvings = 0
        !> Chebyshev positions of the kernel's panels: in [0, 1], and in [1, 2) for all parts of an octave
        real(wp) :: near_y(degree + 1) = 0.0_wp
        real(wp), allocatable :: far_y(:)
        !> cos(ky) - 1 on the real axis: (position, node, octave of k from first_wave)
        real(wp), allocatable :: near(:, :, :)
        !> exp(iky) on the ray, less 1 below octave 0: (position, real and imaginary part, node, octave of k y from first_wave)
        real(wp), allocatable :: far(:, :, :, :)
    contains
        procedure :: is_made
    end type wave_table_t

contains

    pure function is_made(self) result(answer)
        class(wave_table_t), intent(in) :: self
        logical :: answer

        answer = allocated(self%far)
    end function is_made

    !> The table for a ray at `angle`, with so many panels in an octave of wavenumbers, for kernels whose halves of octaves are
    !> halved so often.
    subroutine new_wave_table(self, angle, panels, halvings, error)
        type(wave_table_t), intent(out) :: self
        real(wp), intent(in) :: angle
        integer, intent(in) :: panels, halvings
        type(error_t), allocatable, intent(inout) :: error
        real(wp) :: x(panel_nodes), w(panel_nodes), chebyshev(degree + 1), middle
        real(wp), allocatable :: near(:, :, :)
        integer :: i, n, highest, octave, parts, stat

        self%direction = cmplx(cos(angle), sin(angle), wp)
        call gauss_legendre(x, w, error)
        if (allocated(error)) return
        call last_coefficients(x, w, self%last)
        n = panels*panel_nodes
        parts = 2*2**halvings
        self%halvings = halvings
        highest = ceiling(log(faded/sin(angle))/log(2.0_wp)) - 1
        allocate (self%nodes(n), self%weights(n), self%powers(n, 0:order), near(degree + 1, 2, n), &
                  self%near(degree + 1, n, first_wave:last_near), self%far_y(parts*(degree + 1)), &
                  self%far(parts*(degree + 1), 2, n, first_wave:highest), stat=stat)
        call check_memory(error, stat)
        if (stat /= 0) return
        do i = 1, panels
            self%nodes((i - 1)*panel_nodes + 1:i*panel_nodes) = 1.0_wp + (real(i - 1, wp) + x)/real(panels, wp)
            self%weights((i - 1)*panel_nodes + 1:i*panel_nodes) = w/real(panels, wp)
        end do
        self%powers(:, 0) = 1.0_wp
        do i = 1, order
            self%powers(:, i) = self%powers(:, i - 1)*self%nodes*self%direction*(0.0_wp, 1.0_wp)/real(i, wp)
        end do
        chebyshev = node([(i, i=1, size(chebyshev))], size(chebyshev))
        self%near_y = sqrt(0.5_wp*(1.0_wp + chebyshev))
        do i = 1, parts
            middle = 1.0_wp + real(2*i - 1, wp)/real(2*parts, wp)
            self%far_y((i - 1)*size(chebyshev) + 1:i*size(chebyshev)) = middle + chebyshev/real(2*parts, wp)
        end do
        do i = 1, n
            near(:, :, i) = less_one(scale(self%nodes(i), first_wave)*self%near_y*(0.0_wp, 1.0_wp))
            self%far(:, :, i, first_wave) = less_one(scale(self%nodes(i), first_wave)*self%far_y*(0.0_wp, 1.0_wp)*self%direction)
        end do
        do octave = first_wave, last_near
            self%near(:, :, octave) = near(:, 1, :)
            do i = 1, n
                near(:, :, i) = twice(near(:, :, i), 1.0_wp)
            end do
        end do
        do octave = first_wave, highest - 1
            do i = 1, n
                self%far(:, :, i, octave + 1) = twice(self%far(:, :, i, octave), merge(1.0_wp, 0.0_wp, octave < 0))
            end do
            if (octave == -1) self%far(:, 1, :, 0) = self%far(:, 1, :, 0) + 1.0_wp
        end do
    end subroutine new_wave_table

    !> exp(2z) - c of exp(z) - c for c = 1, or for c = 0 where exp(z) fades, as real and imaginary parts: rounding grows no faster
    !> than that of z.
    pure function twice(w, c) result(next)
        !> (any number, 2)
        real(wp), intent(in) :: w(:, :), c
        real(wp) :: next(size(w, 1), 2)

        next(:, 1) = w(:, 1)*(2.0_wp*c + w(:, 1)) - w(:, 2)*w(:, 2)
        next(:, 2) = 2.0_wp*w(:, 2)*(c + w(:, 1))
    end function twice

    !> Real and imaginary parts of exp(z) - 1 for |z| < 1/64.
    pure function less_one(z) result(parts)
        complex(wp), intent(in) :: z(:)
        real(wp) :: parts(size(z), 2)
        complex(wp) :: value(size(z))
        integer :: i

        value = 1.0_wp
        do i = 8, 2, -1
            value = 1.0_wp + value*z/real(i, wp)
        end do
        value = value*z
        parts(:, 1) = real(value, wp)
        parts(:, 2) = aimag(value)
    end function less_one

    !> The two highest Legendre polynomials that a panel's nodes resolve, times weights and normalisation: what takes values on
    !> a panel to its two last Legendre coefficients.
    pure subroutine last_coefficients(nodes, weights, matrix)
        !> on [0, 1]
        real(wp), intent(in) :: nodes(:), weights(:)
        real(wp), intent(out) :: matrix(:, :)
        real(wp), dimension(size(nodes)) :: x, before, here, next
        integer :: n

        x = 2.0_wp*nodes - 1.0_wp
        before = 1.0_wp
        here = x
        do n = 1, size(nodes) - 2
            next = (real(2*n + 1, wp)*x*here - real(n, wp)*before)/real(n + 1, wp)
            before = here
            here = next
        end do
        n = size(nodes)
        matrix(:, 1) = real(2*n - 3, wp)*weights*before
        matrix(:, 2) = real(2*n - 1, wp)*weights*here
    end subroutine last_coefficients

end module mdrcontact_line_waves
