! SPDX-License-Identifier: GPL-3.0-or-later
!> The checksum CRC-32 (ISO 3309, as in zip and PNG files): finds every single damaged byte.
module mdrcontact_law_crc32
    use, intrinsic :: iso_fortran_env, only: int32
    implicit none (type, external)
    private
    public :: crc32_text

    !> 0xEDB88320
    integer(int32), parameter :: reversed_polynomial = -306674912_int32

contains

    !> The checksum of a text as eight hexadecimal digits.
    pure function crc32_text(text) result(digits)
        character(len=*), intent(in) :: text
        character(len=8) :: digits
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
        write (digits, "(z8.8)") not(remainder)
    end function crc32_text

end module mdrcontact_law_crc32
