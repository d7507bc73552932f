! SPDX-License-Identifier: GPL-3.0-or-later
!> Errors travel as values: an allocated `error_t` means failure and contains the reason.
!>
!> The codes are the status values of the C API (`MDR_E...` in mdrcontact.h) and select the
!> exception class in Python. A message names the argument, its value and the rule.
module mdrcontact_error
    use mdrcontact_nonfinite, only: infinity, is_finite
    use mdrcontact_codes, only: error_callback => ecallback, error_cancelled => ecancelled, error_domain => edomain, &
                                error_file => efile, error_invalid => einvalid, error_memory => enomemory, &
                                error_no_convergence => enoconvergence, error_null => enull, error_unreachable => eunreachable, &
                                success, word_of
    use mdrcontact_kinds, only: half_pi, wp
    use mdrcontact_padded_text, only: padded_count, padded_number
    implicit none (type, external)
    private
    public :: error_t, raise, explain, raise_at, code_text, count_text, to_text
    public :: check_made, check_memory, check_choice, check_code, check_count_from, check_count_within, check_same_size, &
              check_finite, check_positive, check_not_negative, check_within, check_poisson, check_inclination, check_table
    public :: success, error_null, error_invalid, error_domain, error_unreachable, error_no_convergence, &
              error_memory, error_callback, error_file, error_cancelled

    !> A failure: `code` is one of the constants above, `message` the reason as text.
    type :: error_t
        !> one of the constants of this module; a status of mdrcontact.h
        integer :: code = success
        !> the finished sentence: names the argument, its value and the rule
        character(len=:), allocatable :: message
        !> its parts, for a layer with messages of its own: the argument, if it is known,
        character(len=:), allocatable :: argument
        !> which entry of it, counted from 1; 0: none,
        integer :: entry = 0
        !> and the rest of the text
        character(len=:), allocatable :: text
    end type error_t

contains

    !> Allocate `error` with a code and its message: the whole text, or the part after the name of the argument.
    pure subroutine raise(error, code, text, argument, entry)
        type(error_t), allocatable, intent(inout) :: error
        integer, intent(in) :: code
        character(len=*), intent(in) :: text
        !> argument at fault
        character(len=*), intent(in), optional :: argument
        !> which entry of it, from 1; 0: none
        integer, intent(in), optional :: entry

        if (allocated(error)) return
        allocate (error)
        error%code = code
        error%text = text
        error%argument = ""
        if (present(argument)) error%argument = argument
        if (present(entry)) error%entry = entry
        call compose(error)
    end subroutine raise

    !> Assigns an error to one entry of an array.
    pure subroutine raise_at(error, entry)
        type(error_t), intent(inout) :: error
        integer, intent(in) :: entry

        error%entry = entry
        call compose(error)
    end subroutine raise_at

    !> Explains an error of an inner layer for the outer one: `before` and `after` enclose its words.
    pure subroutine explain(error, before, after)
        type(error_t), intent(inout) :: error
        character(len=*), intent(in) :: before, after

        error%text = before//error%message//after
        error%argument = ""
        error%entry = 0
        call compose(error)
    end subroutine explain

    pure subroutine compose(error)
        type(error_t), intent(inout) :: error

        if (error%entry == 0) then
            error%message = error%argument//error%text
        else if (error%argument == "") then
            error%message = "entry "//count_text(error%entry)//": "//error%text
        else
            error%message = "entry "//count_text(error%entry)//" of "//error%argument//error%text
        end if
    end subroutine compose

    !> Raises unless `value` is finite.
    pure subroutine check_finite(error, name, value, entry)
        type(error_t), allocatable, intent(inout) :: error
        character(len=*), intent(in) :: name
        real(wp), intent(in) :: value
        integer, intent(in), optional :: entry

        if (.not. is_finite(value)) call raise_value(error, name, value, "it must be a finite number", entry)
    end subroutine check_finite

    !> Raises unless an object was made: it may only have been declared, or its maker may have failed.
    pure subroutine check_made(error, name, is_made)
        type(error_t), allocatable, intent(inout) :: error
        character(len=*), intent(in) :: name
        logical, intent(in) :: is_made

        if (is_made) return
        call raise(error, error_invalid, ": it has not been made, or making it failed. Make it, and check its error", name)
    end subroutine check_made

    !> Raises unless the `stat` of an allocation is zero.
    pure subroutine check_memory(error, stat)
        type(error_t), allocatable, intent(inout) :: error
        integer, intent(in) :: stat

        if (stat /= 0) call raise(error, error_memory, "not enough memory")
    end subroutine check_memory

    !> Raises unless first <= choice <= last; `allowed` are the codes and their meanings.
    pure subroutine check_choice(error, name, choice, first, last, allowed)
        type(error_t), allocatable, intent(inout) :: error
        character(len=*), intent(in) :: name, allowed
        integer, intent(in) :: choice, first, last

        if (choice >= first .and. choice <= last) return
        call raise(error, error_invalid, name//" = "//count_text(choice)//": it must be "//allowed)
    end subroutine check_choice

    !> Raises unless a code is one of those that are allowed, which it names by number and word.
    pure subroutine check_code(error, name, code, allowed)
        type(error_t), allocatable, intent(inout) :: error
        character(len=*), intent(in) :: name
        integer, intent(in) :: code, allowed(:)
        character(len=512) :: words
        integer :: i

        if (any(allowed == code)) return
        words = ""
        do i = 1, size(allowed)
            if (i > 1 .and. i < size(allowed)) words = trim(words)//","
            if (i > 1 .and. i == size(allowed)) words = trim(words)//" or"
            words = trim(words)//" "//code_text(allowed(i))
        end do
        call raise(error, error_invalid, name//" = "//trim(code_text(code))//": it must be"//trim(words))
    end subroutine check_code

    !> A code as number and word; of a number below 100, which may be a status by chance, the number.
    pure function code_text(code) result(text)
        integer, intent(in) :: code
        character(len=48) :: text

        text = count_text(code)
        if (code >= 100 .and. word_of(code) /= "") text = trim(text)//" ("//trim(word_of(code))//")"
    end function code_text

    !> Raises unless count >= smallest.
    pure subroutine check_count_from(error, name, count, smallest)
        type(error_t), allocatable, intent(inout) :: error
        character(len=*), intent(in) :: name
        integer, intent(in) :: count, smallest

        ! text is made for counts that are wrong only: this runs at each call for one state
        if (count >= smallest) return
        call check_choice(error, name, count, smallest, huge(1), "at least "//count_text(smallest))
    end subroutine check_count_from

    !> Raises unless smallest <= count <= largest.
    pure subroutine check_count_within(error, name, count, smallest, largest)
        type(error_t), allocatable, intent(inout) :: error
        character(len=*), intent(in) :: name
        integer, intent(in) :: count, smallest, largest

        if (count >= smallest .and. count <= largest) return
        call check_choice(error, name, count, smallest, largest, "from "//count_text(smallest)//" to "//count_text(largest))
    end subroutine check_count_within

    !> Raises unless two arrays that go together have as many entries.
    pure subroutine check_same_size(error, first, second)
        type(error_t), allocatable, intent(inout) :: error
        integer, intent(in) :: first, second

        if (first == second) return
        call raise(error, error_invalid, "the arrays have "//count_text(first)//" and "//count_text(second)// &
                   " entries: they must have equal sizes")
    end subroutine check_same_size

    !> Raises unless `value` is finite and greater than zero.
    pure subroutine check_positive(error, name, value, entry)
        type(error_t), allocatable, intent(inout) :: error
        character(len=*), intent(in) :: name
        real(wp), intent(in) :: value
        integer, intent(in), optional :: entry

        if (is_finite(value)) then
            if (value > 0.0_wp) return
        end if
        call raise_value(error, name, value, "it must be finite and greater than 0", entry)
    end subroutine check_positive

    !> Raises unless `value` is finite and at least zero.
    pure subroutine check_not_negative(error, name, value, entry)
        type(error_t), allocatable, intent(inout) :: error
        character(len=*), intent(in) :: name
        real(wp), intent(in) :: value
        integer, intent(in), optional :: entry

        if (is_finite(value)) then
            if (value >= 0.0_wp) return
        end if
        call raise_value(error, name, value, "it must be finite and at least 0", entry)
    end subroutine check_not_negative

    !> Raises unless smallest <= value <= largest.
    pure subroutine check_within(error, name, value, smallest, largest)
        type(error_t), allocatable, intent(inout) :: error
        character(len=*), intent(in) :: name
        real(wp), intent(in) :: value, smallest, largest

        if (is_finite(value)) then
            if (value >= smallest .and. value <= largest) return
        end if
        call raise_value(error, name, value, "it must lie in ["//to_text(smallest)//", "//to_text(largest)//"]")
    end subroutine check_within

    !> Raises unless `value` is a Poisson's ratio of a stable isotropic body, -1 < nu <= 1/2.
    pure subroutine check_poisson(error, name, value, entry)
        type(error_t), allocatable, intent(inout) :: error
        character(len=*), intent(in) :: name
        real(wp), intent(in) :: value
        integer, intent(in), optional :: entry

        if (is_finite(value)) then
            if (value > -1.0_wp .and. value <= 0.5_wp) return
        end if
        call raise_value(error, name, value, "Poisson's ratio must lie in (-1, 0.5]", entry)
    end subroutine check_poisson

    !> Raises unless `inclination` is the angle between a cone's face and the surface, 0 < phi < pi/2.
    pure subroutine check_inclination(error, inclination)
        type(error_t), allocatable, intent(inout) :: error
        real(wp), intent(in) :: inclination

        if (inclination > 0.0_wp .and. inclination < half_pi) return
        call raise_value(error, "inclination", inclination, "the angle between face and surface must lie in (0, pi/2) radian")
    end subroutine check_inclination

    !> Raises unless a table has at least `fewest` entries, finite values and strictly ascending abscissae.
    pure subroutine check_table(error, x_name, x, y_name, y, fewest)
        type(error_t), allocatable, intent(inout) :: error
        character(len=*), intent(in) :: x_name, y_name
        real(wp), intent(in) :: x(:), y(:)
        integer, intent(in) :: fewest
        integer :: i

        if (size(x) /= size(y)) then
            call raise(error, error_invalid, x_name//" has "//count_text(size(x))//" and "//y_name//" has "//count_text(size(y))// &
                       " entries: they must have equal sizes")
        else if (size(x) < fewest) then
            call raise(error, error_invalid, "a table of "//count_text(size(x))//" entries in "//x_name// &
                       " is too short. Give at least "//count_text(fewest))
        end if
        if (allocated(error)) return
        do i = 1, size(x)
            if (is_finite(x(i)) .and. is_finite(y(i))) cycle
            call check_finite(error, x_name, x(i), i)
            call check_finite(error, y_name, y(i), i)
            if (allocated(error)) return
        end do
        do i = 2, size(x)
            if (x(i) > x(i - 1)) cycle
            call raise(error, error_invalid, " = "//to_text(x(i))//": "//x_name//" must be strictly ascending, and the "// &
                       "previous entry is "//to_text(x(i - 1)), x_name, i)
            return
        end do
    end subroutine check_table

    !> A count as text.
    pure function count_text(count) result(text)
        integer, intent(in) :: count
        character(len=len_trim(padded_count(count))) :: text

        text = padded_count(count)
    end function count_text

    pure subroutine raise_value(error, name, value, allowed, entry)
        type(error_t), allocatable, intent(inout) :: error
        character(len=*), intent(in) :: name, allowed
        real(wp), intent(in) :: value
        integer, intent(in), optional :: entry

        call raise(error, error_invalid, " = "//to_text(value)//": "//allowed, name, entry)
    end subroutine raise_value

    !> A number as a person would write it: short, up to seven digits.
    pure function to_text(value) result(text)
        real(wp), intent(in) :: value
        character(len=len_trim(padded_number(value))) :: text

        text = padded_number(value)
    end function to_text

end module mdrcontact_error
