! SPDX-License-Identifier: GPL-3.0-or-later
!> Layers with complex elastic constants, those of an oscillation or of a Laplace transform: chi(k) is complex on the real axis.
!>
!> Its real and its imaginary part there are two functions that are analytic in k and real on the axis,
!> [chi(k) + conjg chi(conjg k)]/2 and the difference over 2i, so that each is a body like an elastic one to whoever tabulates its
!> kernel.
module mdrcontact_body_harmonic
    use mdrcontact_body_stack, only: stack_t
    use mdrcontact_body_surface, only: new_surface, surface_t
    use mdrcontact_error, only: check_memory, error_t
    use mdrcontact_kinds, only: wp
    implicit none (type, external)
    private
    public :: harmonic_t, harmonic_memory_t, new_harmonic

    !> Blocks that are kept at most.
    integer, parameter :: most_blocks = 512

    !> Both parts of sigma and of chi at some wavenumbers: (sigma real, imaginary, chi real, imaginary; wavenumber).
    type :: block_t
        complex(wp) :: first = 0.0_wp
        complex(wp), allocatable :: values(:, :)
    end type block_t

    !> What one part leaves to the other, which asks for the same wavenumbers: blocks in the order in which they were asked for.
    type :: harmonic_memory_t
        private
        type(block_t), allocatable :: blocks(:)
        integer :: count = 0, latest = 0
    end type harmonic_memory_t

    !> One of the two parts; of the stack's data none but the depths are used.
    type, extends(stack_t) :: harmonic_t
        type(surface_t), private :: oscillating
        !> sigma(0)
        complex(wp), private :: zero = 0.0_wp
        type(harmonic_memory_t), pointer, private :: memory => null()
        !> which part it is
        logical, private :: is_imaginary = .false.
    contains
        procedure :: response
        procedure :: responses
        procedure :: take_part
        procedure :: ratios
    end type harmonic_t

contains

    !> The body whose part take_part() chooses.
    subroutine new_harmonic(self, memory, shear, poisson, thickness, rigid_base, error)
        type(harmonic_t), intent(out) :: self
        !> lives as long as the body
        type(harmonic_memory_t), intent(out), target :: memory
        !> of the layers and, one more, of the half-space, which is not used if the base is rigid [modulus]; [1]
        complex(wp), intent(in) :: shear(:), poisson(:)
        !> of the layers [length]
        real(wp), intent(in) :: thickness(:)
        logical, intent(in) :: rigid_base
        type(error_t), allocatable, intent(inout) :: error
        integer :: n, stat

        n = size(thickness)
        call new_surface(self%oscillating, shear, poisson, thickness, rigid_base, error)
        if (allocated(error)) return
        if (.not. rigid_base) self%zero = shear(1)*(1.0_wp - poisson(n + 1))/(shear(n + 1)*(1.0_wp - poisson(1)))
        allocate (memory%blocks(most_blocks), stat=stat)
        call check_memory(error, stat)
        if (stat /= 0) return
        self%memory => memory
        self%first_depth = self%oscillating%h(1)
        self%last_depth = self%oscillating%depth
    end subroutine new_harmonic

    !> Makes it the real or the imaginary part of chi; sigma = 1 + chi of both.
    pure subroutine take_part(self, imaginary)
        class(harmonic_t), intent(inout) :: self
        logical, intent(in) :: imaginary

        self%is_imaginary = imaginary
        self%long_wave_limit = merge(1.0_wp + aimag(self%zero), real(self%zero, wp), imaginary)
    end subroutine take_part

    pure subroutine response(self, k, sigma, chi)
        class(harmonic_t), intent(in) :: self
        complex(wp), intent(in) :: k
        complex(wp), intent(out) :: sigma, chi
        complex(wp) :: parts(4)

        parts = both_parts(self, k)
        sigma = parts(merge(2, 1, self%is_imaginary))
        chi = parts(merge(4, 3, self%is_imaginary))
    end subroutine response

    !> The part at wavenumbers of which the first one tells them all: what the other part was asked for is known.
    subroutine responses(self, k, sigma, chi)
        class(harmonic_t), intent(in) :: self
        complex(wp), intent(in) :: k(:)
        complex(wp), intent(out) :: sigma(:), chi(:)
        complex(wp) :: values(4, size(k))
        integer :: i, place

        associate (memory => self%memory)
            do i = 1, memory%count
                place = modulo(memory%latest + i - 1, memory%count) + 1
                if (abs(memory%blocks(place)%first - k(1)) > 0.0_wp) cycle
                if (size(memory%blocks(place)%values, 2) == size(k)) exit
            end do
            if (i <= memory%count) then
                values = memory%blocks(place)%values
                memory%latest = place
            else
                do i = 1, size(k)
                    values(:, i) = both_parts(self, k(i))
                end do
                if (memory%count < size(memory%blocks)) then
                    memory%count = memory%count + 1
                    memory%blocks(memory%count)%first = k(1)
                    memory%blocks(memory%count)%values = values
                end if
            end if
        end associate
        sigma = values(merge(2, 1, self%is_imaginary), :)
        chi = values(merge(4, 3, self%is_imaginary), :)
    end subroutine responses

    pure function both_parts(self, k) result(parts)
        class(harmonic_t), intent(in) :: self
        complex(wp), intent(in) :: k
        complex(wp) :: parts(4)
        complex(wp) :: sigma, chi, other_sigma, other_chi

        call self%oscillating%normal_response(k, sigma, chi)
        other_sigma = sigma
        other_chi = chi
        if (abs(aimag(k)) > 0.0_wp) call self%oscillating%normal_response(conjg(k), other_sigma, other_chi)
        parts(1) = 0.5_wp*(sigma + conjg(other_sigma))
        parts(3) = 0.5_wp*(chi + conjg(other_chi))
        parts(4) = (chi - conjg(other_chi))/(0.0_wp, 2.0_wp)
        parts(2) = 1.0_wp + parts(4)
    end function both_parts

    !> None: no two frequencies have the same kernel.
    pure subroutine ratios(self, values, error)
        class(harmonic_t), intent(in) :: self
        real(wp), allocatable, intent(out) :: values(:)
        type(error_t), allocatable, intent(inout) :: error

        associate (unused => self, also_unused => error)
        end associate
        allocate (values(0))
    end subroutine ratios

end module mdrcontact_body_harmonic
