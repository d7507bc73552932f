! SPDX-License-Identifier: GPL-3.0-or-later
!> Numbers as text of fixed length, blank-padded. A module of its own so that error texts can take their lengths from it:
!> gfortran keeps the length of a deferred-length function result in static memory, where threads that fail at
!> the same time would overwrite it, so texts made by functions need lengths that are known beforehand.
module mdrcontact_padded_text
    use mdrcontact_nonfinite, only: infinity, is_finite
    use mdrcontact_kinds, only: wp
    implicit none (type, external)
    private
    public :: padded_count, padded_number

contains

    !> A count as text.
    pure function padded_count(count) result(text)
        integer, intent(in) :: count
        character(len=12) :: text

        write (text, "(i0)") count
    end function padded_count

    !> A number as a person would write it, short, with up to seven digits: 0.25, 2e-06, -1.234568e+100.
    pure function padded_number(value) result(text)
        real(wp), intent(in) :: value
        character(len=24) :: text
        integer :: last

        if (value /= value) then
            text = "NaN"
        else if (.not. is_finite(value)) then
            text = merge("-infinity", "infinity ", value < 0.0_wp)
        else if (value /= 0.0_wp .and. (abs(value) < 1.0e-3_wp .or. abs(value) >= 1.0e6_wp)) then
            call write_scientific(value, text)
        else
            write (text, "(f16.7)") value
            last = verify(text, " 0", back=.true.)
            if (text(last:last) == ".") last = last - 1
            text = text(:last)
        end if
        text = adjustl(text)
    end function padded_number

    pure subroutine write_scientific(value, text)
        real(wp), intent(in) :: value
        character(len=24), intent(out) :: text
        character(len=14) :: full
        integer :: last, exponent

        write (full, "(es14.6e3)") value
        last = verify(full(:9), "0", back=.true.)
        if (full(last:last) == ".") last = last - 1
        read (full(11:), "(i4)") exponent
        if (abs(exponent) < 100) then
            write (text, "(a,a,sp,i3.2)") full(:last), "e", exponent
        else
            write (text, "(a,a,sp,i4.3)") full(:last), "e", exponent
        end if
    end subroutine write_scientific

end module mdrcontact_padded_text
