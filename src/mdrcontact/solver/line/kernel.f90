! SPDX-License-Identifier: GPL-3.0-or-later
!> The kernel X(y) = int_0^inf chi(k) cos(ky) dk of the one-dimensional springs (theory/exact.md (1.3)), tabulated once per medium.
!>
!> X belongs to the body alone, not to contact radius or indenter. It is tabulated on [0, unit] as a polynomial in y^2 and on
!> parts of octaves [unit 2^j, unit 2^(j+1)] up to where it has become its own tail, c/y^2 + d/y^4: any ratio of lengths takes
!> the same few panels, halves of octaves, or shorter ones in layers along whose normal waves oscillate as they decay. Lengths in
!> this module are in units of `unit`, X in units of 1/unit.
module mdrcontact_line_kernel
    use, intrinsic :: iso_fortran_env, only: int64
    use mdrcontact_kinds, only: pi, wp
    use mdrcontact_numerics_chebyshev, only: terms
    implicit none (type, external)
    private
    public :: kernel_t, degree, near_degree

    !> Degree of the polynomials: the nearest singularity of half an octave (y = 0, or 2 h i with h the first layer's thickness)
    !> lies five half lengths from its centre or farther. Where waves exp(-lambda k z) oscillate it is 2 h i lambda, which
    !> comes near the y axis as lambda nears the imaginary one: an octave then has more panels.
    integer, parameter :: degree = terms - 1
    !> Below the unit, in y^2, the same singularity lies nine half lengths from the centre.
    integer, parameter :: near_degree = 13
    integer(int64), parameter :: mantissa = int(z'000FFFFFFFFFFFFF', int64), exponent_of_one = int(z'3FF0000000000000', int64)
    !> More bits than number the parts of an octave.
    integer(int64), parameter :: all_parts = int(z'FF', int64)
    !> Points evaluated together, so that the compiler interleaves their Horner schemes.
    integer, parameter :: block_size = 32, at_once = 12

    !> The table. Made by tabulate_kernel.
    type :: kernel_t
        !> length unit of the table: the thickness of the first layer [length]
        real(wp) :: unit = 1.0_wp
        !> X is zero: a homogeneous body
        logical :: vanishes = .true.
        !> thickness of the thinnest layer that shows at its own length, >= 1; infinite where all layers belong to fine gradings
        real(wp) :: resolved = 1.0_wp
        !> X(0), and one_plus_chi(0) = 1 + chi(0)
        real(wp) :: origin = 0.0_wp, one_plus_chi_zero = 1.0_wp
        !> Below 2^plateau the table holds X - X(0), which keeps its digits where X(0) is large: a stiff film on a soft base.
        integer :: plateau = 0
        !> how often halves of octaves are halved
        integer :: halvings = 0
        !> coefficients(:, 0): powers of 2 y^2 - 1 on [0, 1]; (:, 1 + n j + i): powers of the local variable in [-1, 1] on
        !> part i of the n of octave j
        real(wp), allocatable :: coefficients(:, :)
        !> y^2 X(y) = tail(1) + tail(2)/y^2 beyond the last octave
        real(wp) :: tail(2) = 0.0_wp
        !> integral of X from the start of each part of an octave to infinity; the last one that of the tail
        real(wp), allocatable :: rest(:)
    contains
        procedure :: octaves
        procedure :: parts
        procedure :: is_graded
        procedure :: evaluate
        procedure :: integral_beyond
        procedure :: integrate
        procedure :: defect
        procedure :: misfit
    end type kernel_t

contains

    !> Number of octaves in the table: the tail begins at 2^octaves.
    pure function octaves(self) result(count)
        class(kernel_t), intent(in) :: self
        integer :: count

        count = 0
        if (allocated(self%coefficients)) count = ubound(self%coefficients, 2)/self%parts()
    end function octaves

    !> Number of panels in an octave.
    elemental function parts(self) result(count)
        class(kernel_t), intent(in) :: self
        integer :: count

        count = 2*2**self%halvings
    end function parts

    !> Whether the body's constants vary with depth, and X at all lengths above `unit`.
    pure function is_graded(self) result(answer)
        class(kernel_t), intent(in) :: self
        logical :: answer

        answer = self%resolved > 1.0_wp
    end function is_graded

    !> X(y) - shift at y >= 0.
    pure subroutine evaluate(self, y, shift, x)
        class(kernel_t), intent(in) :: self
        !> in units of `unit`
        real(wp), intent(in) :: y(:)
        !> 0, or X(0) so that X(y) - X(0) keeps its digits
        real(wp), intent(in) :: shift
        !> same size as y
        real(wp), intent(out) :: x(:)
        integer :: first, count

        if (self%vanishes) then
            x = -shift
            return
        end if
        do first = 1, size(y), block_size
            count = min(block_size, size(y) - first + 1)
            call evaluate_block(count, y(first:first + count - 1), self%coefficients, self%octaves(), self%halvings, &
                                self%tail, self%plateau, self%origin - shift, -shift, x(first:first + count - 1))
        end do
    end subroutine evaluate

    !> int_y^inf X, y >= 1.
    pure function integral_beyond(self, y) result(total)
        class(kernel_t), intent(in) :: self
        real(wp), intent(in) :: y
        real(wp) :: total
        integer :: panel, part

        total = 0.0_wp
        if (self%vanishes) return
        part = int((2.0_wp*fraction(y) - 1.0_wp)*real(self%parts(), wp))
        panel = self%parts()*(exponent(y) - 1) + 1 + part
        if (panel >= size(self%rest)) then
            total = self%tail(1)/y + self%tail(2)/(3.0_wp*y**3)
        else
            total = self%rest(panel + 1) + on_panel(self, panel, local_variable(self%parts(), part, scale(y, 1 - exponent(y))))
        end if
    end function integral_beyond

    !> From -1 to 1 on a part of the octave 1 <= y < 2.
    elemental function local_variable(parts, part, y) result(u)
        integer, intent(in) :: parts, part
        real(wp), intent(in) :: y
        real(wp) :: u

        u = real(2*parts, wp)*y - real(2*parts + 1 + 2*part, wp)
    end function local_variable

    !> Fills `rest`, once the table is complete.
    pure subroutine integrate(self)
        class(kernel_t), intent(inout) :: self
        integer :: panel

        if (allocated(self%rest)) deallocate (self%rest)
        allocate (self%rest(ubound(self%coefficients, 2) + 1))
        self%rest(size(self%rest)) = sum(self%tail*[scale(1.0_wp, -self%octaves()), scale(1.0_wp, -3*self%octaves())/3.0_wp])
        do panel = size(self%rest) - 1, 1, -1
            self%rest(panel) = self%rest(panel + 1) + on_panel(self, panel, -1.0_wp)
        end do
    end subroutine integrate

    !> The integral from u to the end of a part of an octave.
    pure function on_panel(self, panel, u) result(part)
        class(kernel_t), intent(in) :: self
        integer, intent(in) :: panel
        real(wp), intent(in) :: u
        real(wp) :: part
        real(wp) :: there, here, c
        integer :: j

        there = 0.0_wp
        here = 0.0_wp
        do j = degree, 0, -1
            c = self%coefficients(j, panel)/real(j + 1, wp)
            there = there + c
            here = (here + c)*u
        end do
        part = there - here
        if ((panel - 1)/self%parts() < self%plateau) part = part + self%origin*(1.0_wp - u)
        part = part*scale(0.25_wp, (panel - 1)/self%parts() - self%halvings)
    end function on_panel

    !> Largest difference of y X(y) between two neighbouring panels where they meet, at no node of either: what that does to chi at
    !> the waves that see it.
    pure function misfit(self) result(largest)
        class(kernel_t), intent(in) :: self
        real(wp) :: largest
        real(wp) :: before, next
        integer :: panel, last

        last = ubound(self%coefficients, 2)
        largest = 0.0_wp
        do panel = 0, last
            before = sum(self%coefficients(:, panel)) + held_back(self, panel)
            if (panel < last) then
                next = sum(self%coefficients(0::2, panel + 1)) - sum(self%coefficients(1::2, panel + 1)) &
                       + held_back(self, panel + 1)
            else
                next = self%tail(1)*scale(1.0_wp, -2*self%octaves()) + self%tail(2)*scale(1.0_wp, -4*self%octaves())
            end if
            largest = max(largest, scale(abs(before - next), (panel + self%parts() - 1)/self%parts()))
        end do
    end function misfit

    !> X(0) where a panel holds X - X(0), else 0.
    pure function held_back(self, panel) result(value)
        class(kernel_t), intent(in) :: self
        integer, intent(in) :: panel
        real(wp) :: value

        value = merge(self%origin, 0.0_wp, panel == 0 .or. (panel - 1)/self%parts() < self%plateau)
    end function held_back

    !> chi(0) - (2/pi) int_0^inf X dy of the table as it is, which would be 0.
    pure function defect(self) result(difference)
        class(kernel_t), intent(in) :: self
        real(wp) :: difference
        real(wp) :: total, moment
        integer :: j

        total = self%origin + self%integral_beyond(1.0_wp)
        ! moment: int_0^1 (2 y^2 - 1)^j dy
        moment = 1.0_wp
        do j = 0, degree
            if (j > 0) moment = (1.0_wp - real(2*j, wp)*moment)/real(2*j + 1, wp)
            total = total + self%coefficients(j, 0)*moment
        end do
        difference = self%one_plus_chi_zero - 1.0_wp - total*(2.0_wp/pi)
    end function defect

    !> y < 1 throughout: one polynomial, for as many points at a time as the registers hold.
    pure subroutine evaluate_near(n, y, coefficients, x)
        integer, intent(in) :: n
        real(wp), intent(in) :: y(n), coefficients(0:near_degree)
        real(wp), intent(out) :: x(n)
        integer :: first, last, j
        real(wp), dimension(at_once) :: u, value

        do first = 1, n, at_once
            last = min(first + at_once - 1, n)
            u = 0.0_wp
            u(:last - first + 1) = y(first:last)
            u = 2.0_wp*u**2 - 1.0_wp
            value = coefficients(near_degree)
            do j = near_degree - 1, 0, -1
                value = value*u + coefficients(j)
            end do
            x(first:last) = value(:last - first + 1)
        end do
    end subroutine evaluate_near

    !> Sorts the points into those below 1 and those beyond.
    pure subroutine evaluate_block(n, y, coefficients, octaves, halvings, tail, plateau, on_plateau, elsewhere, x)
        integer, intent(in) :: n, octaves, halvings, plateau
        !> what is added below 2^plateau, and beyond
        real(wp), intent(in) :: y(n), coefficients(0:degree, 0:2*2**halvings*octaves), tail(2), on_plateau, elsewhere
        real(wp), intent(out) :: x(n)
        integer :: i, near, far, place(block_size)
        real(wp) :: sorted(block_size), values(block_size), edge

        edge = scale(1.0_wp, plateau)
        near = 0
        far = n + 1
        do i = 1, n
            if (y(i) < 1.0_wp) then
                near = near + 1
                place(i) = near
            else
                far = far - 1
                place(i) = far
            end if
            sorted(place(i)) = y(i)
        end do
        call evaluate_near(near, sorted(:near), coefficients(:, 0), values(:near))
        call evaluate_far(n - near, sorted(far:n), coefficients, octaves, halvings, tail, values(far:n))
        do i = 1, n
            x(i) = values(place(i)) + merge(on_plateau, elsewhere, y(i) < edge)
        end do
    end subroutine evaluate_block

    !> y >= 1.
    pure subroutine evaluate_far(n, y, coefficients, octaves, halvings, tail, x)
        integer, intent(in) :: n, octaves, halvings
        real(wp), intent(in) :: y(n), coefficients(0:degree, 0:2*2**halvings*octaves), tail(2)
        real(wp), intent(out) :: x(n)
        integer(int64) :: bits
        integer :: i, j, octave, part, parts, panel(block_size)
        real(wp) :: u(block_size), pair(2), square
        logical :: has_tail

        has_tail = .false.
        parts = 2*2**halvings
        do i = 1, n
            bits = transfer(y(i), bits)
            octave = int(shiftr(bits, 52)) - 1023
            part = iand(int(iand(shiftr(bits, 51 - halvings), all_parts)), parts - 1)
            u(i) = local_variable(parts, part, transfer(ior(iand(bits, mantissa), exponent_of_one), 1.0_wp))
            panel(i) = 1 + parts*octave + part
            if (octave >= octaves) then
                panel(i) = 0
                u(i) = 0.0_wp
                has_tail = .true.
            end if
        end do
        do i = 1, n
            ! even and odd powers side by side
            pair = coefficients(degree - 1:degree, panel(i))
            square = u(i)**2
            do j = degree - 3, 0, -2
                pair = pair*square + coefficients(j:j + 1, panel(i))
            end do
            x(i) = pair(1) + u(i)*pair(2)
        end do
        if (.not. has_tail) return
        do i = 1, n
            if (y(i) >= scale(1.0_wp, octaves)) x(i) = (tail(1) + tail(2)/y(i)**2)/y(i)**2
        end do
    end subroutine evaluate_far

end module mdrcontact_line_kernel
