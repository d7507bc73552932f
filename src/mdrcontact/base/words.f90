! SPDX-License-Identifier: GPL-3.0-or-later
!> The codes of names; `mdrcontact_codes` has the names of codes.
module mdrcontact_words
    use mdrcontact_codes, only: codes_beside, word_of
    use mdrcontact_error, only: count_text, error_invalid, error_t, raise
    implicit none (type, external)
    private
    public :: code_of

contains

    !> The code of a word. One that its enumeration does not have raises an error that lists the nearest word and all words.
    pure subroutine code_of(enumeration, word, code, error)
        !> any code of the enumeration, models%exact for a model
        integer, intent(in) :: enumeration
        !> to the letter
        character(len=*), intent(in) :: word
        !> -1 with an error
        integer, intent(out) :: code
        type(error_t), allocatable, intent(out) :: error
        character(len=:), allocatable :: known
        integer, allocatable :: codes(:), edits(:)
        integer :: i

        code = -1
        allocate (codes, source=codes_beside(enumeration))
        if (size(codes) == 0) then
            call raise(error, error_invalid, "enumeration = "//count_text(enumeration)// &
                       ": it must be a code of the enumeration that contains the name")
            return
        end if
        known = ""
        allocate (edits(size(codes)))
        do i = 1, size(codes)
            known = known//", "//trim(word_of(codes(i)))
            edits(i) = edits_between(word, trim(word_of(codes(i))))
            ! no letter more either, be it a blank
            if (edits(i) == 0) code = codes(i)
        end do
        if (code == -1) call raise(error, error_invalid, " = "//word(:min(len(word), 40))//": did you mean "// &
                                   trim(word_of(codes(minloc(edits, dim=1))))//"? It must be one of "//known(3:), "name")
    end subroutine code_of

    !> Number of insertions, deletions and substitutions that turn one word into the other (Levenshtein).
    pure function edits_between(first, second) result(edits)
        character(len=*), intent(in) :: first, second
        integer :: edits
        integer :: row(0:len(second)), i, j, above_left, above

        row = [(j, j=0, len(second))]
        do i = 1, len(first)
            above_left = row(0)
            row(0) = i
            do j = 1, len(second)
                above = row(j)
                row(j) = min(above + 1, row(j - 1) + 1, above_left + merge(0, 1, first(i:i) == second(j:j)))
                above_left = above
            end do
        end do
        edits = row(len(second))
    end function edits_between

end module mdrcontact_words
