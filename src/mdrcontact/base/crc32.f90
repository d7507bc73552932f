! SPDX-License-Identifier: GPL-3.0-or-later
!> The checksum CRC-32 (ISO 3309, as in zip and PNG files): finds every single damaged byte.
module mdrcontact_crc32
    use, intrinsic :: iso_fortran_env, only: int32
    use mdrcontact_kinds, only: wp
    implicit none (type, external)
    private
    public :: coarse, crc32_text, mark_of

    !> 0xEDB88320
    integer(int32), parameter :: reversed_polynomial = -306674912_int32
    !> Marks differ from 0, and are exact as real numbers.
    real(wp), parameter :: offset = 2.0_wp**33
    !> Significant binary digits of numbers that are the same on every machine.
    integer, parameter :: digits_of_coarse = 23

contains

    !> The checksum of a text as eight hexadecimal digits.
    pure function crc32_text(text) result(digits)
        character(len=*), intent(in) :: text
        character(len=8) :: digits

        write (digits, "(z8.8)") crc32(text)
    end function crc32_text

    !> The checksum of numbers, all of whose bits count, as a number greater than 0.
    pure function mark_of(numbers) result(mark)
        real(wp), intent(in) :: numbers(:)
        real(wp) :: mark

        mark = offset + crc32(transfer(numbers, repeat(" ", size(numbers)*storage_size(numbers)/storage_size(" "))))
    end function mark_of

    !> A number without its last digits, which differ on another machine.
    elemental function coarse(x) result(y)
        real(wp), intent(in) :: x
        real(wp) :: y

        y = scale(anint(scale(fraction(x), digits_of_coarse)), exponent(x) - digits_of_coarse)
    end function coarse

    pure function crc32(text) result(checksum)
        character(len=*), intent(in) :: text
        integer(int32) :: checksum
        integer(int32) :: table(0:255), remainder
        integer :: i, bit

        do i = 0, 255
            remainder = int(i, int32)
            do bit = 1, 8
                remainder = merge(ieor(shiftr(remainder, 1), reversed_polynomial), shiftr(remainder, 1), btest(remainder, 0))
            end do
            table(i) = remainder
        end do
        remainder = not(0_int32)
        do i = 1, len(text)
            remainder = ieor(shiftr(remainder, 8), table(iand(ieor(remainder, int(iachar(text(i:i)), int32)), 255_int32)))
        end do
        checksum = not(remainder)
    end function crc32

end module mdrcontact_crc32
