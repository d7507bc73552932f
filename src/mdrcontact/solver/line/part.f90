! SPDX-License-Identifier: GPL-3.0-or-later
!> The two parts of a compliance with complex constants, that of an oscillation or of a Laplace transform: chi(k) is complex on the
!> real axis.
!>
!> Its real and its imaginary part there are two functions that are analytic in k and real on the axis,
!> [chi(k) + conjg chi(conjg k)]/2 and the difference over 2i, so that each is tabulated like the compliance of an elastic body.
module mdrcontact_line_part
    use mdrcontact_body_compliance, only: compliance_t
    use mdrcontact_kinds, only: wp
    implicit none (type, external)
    private
    public :: part_t, part_memory_t, new_part

    !> Largest number of blocks kept.
    integer, parameter :: most_blocks = 512

    !> Both parts of one_plus_chi and of chi at some wavenumbers: (one_plus_chi real, imaginary, chi real, imaginary; wavenumber).
    type :: block_t
        complex(wp) :: first = 0.0_wp
        complex(wp), allocatable :: values(:, :)
    end type block_t

    !> Data of one part for the other, which uses the same wavenumbers: blocks in the order in which they were made.
    type :: part_memory_t
        private
        type(block_t), allocatable :: blocks(:)
        integer :: count = 0, latest = 0
    end type part_memory_t

    !> One of the two parts.
    type, extends(compliance_t) :: part_t
        private
        class(compliance_t), pointer :: whole => null()
        type(part_memory_t), pointer :: memory => null()
        logical :: is_imaginary = .false.
    contains
        procedure :: chi => chi_of_part
    end type part_t

contains

    !> The real or the imaginary part of chi; one_plus_chi = 1 + chi of both.
    subroutine new_part(self, whole, imaginary, memory)
        type(part_t), intent(out) :: self
        !> both live as long as the part; the memory is that of both parts of one compliance
        class(compliance_t), intent(in), target :: whole
        logical, intent(in) :: imaginary
        type(part_memory_t), intent(inout), target :: memory

        if (.not. allocated(memory%blocks)) allocate (memory%blocks(most_blocks))
        self%whole => whole
        self%memory => memory
        self%is_imaginary = imaginary
        self%at_zero = merge(1.0_wp + aimag(whole%at_zero), real(whole%at_zero, wp), imaginary)
        self%first_depth = whole%first_depth
        self%last_depth = whole%last_depth
    end subroutine new_part

    !> The part at wavenumbers of which the first one determines them all: what the other part took is known.
    subroutine chi_of_part(self, k, one_plus_chi, chi)
        class(part_t), intent(in) :: self
        complex(wp), intent(in) :: k(:)
        complex(wp), intent(out) :: one_plus_chi(:), chi(:)
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
                call find_both(self%whole, k, values)
                if (memory%count < size(memory%blocks)) then
                    memory%count = memory%count + 1
                    memory%blocks(memory%count)%first = k(1)
                    memory%blocks(memory%count)%values = values
                end if
            end if
        end associate
        one_plus_chi = values(merge(2, 1, self%is_imaginary), :)
        chi = values(merge(4, 3, self%is_imaginary), :)
    end subroutine chi_of_part

    subroutine find_both(whole, k, values)
        class(compliance_t), intent(in) :: whole
        complex(wp), intent(in) :: k(:)
        complex(wp), intent(out) :: values(:, :)
        complex(wp), dimension(size(k)) :: one_plus_chi, chi, other_one_plus_chi, other_chi

        call whole%chi(k, one_plus_chi, chi)
        other_one_plus_chi = one_plus_chi
        other_chi = chi
        if (any(abs(aimag(k)) > 0.0_wp)) call whole%chi(conjg(k), other_one_plus_chi, other_chi)
        values(1, :) = 0.5_wp*(one_plus_chi + conjg(other_one_plus_chi))
        values(3, :) = 0.5_wp*(chi + conjg(other_chi))
        values(4, :) = (chi - conjg(other_chi))/(0.0_wp, 2.0_wp)
        values(2, :) = 1.0_wp + values(4, :)
    end subroutine find_both

end module mdrcontact_line_part
