! SPDX-License-Identifier: GPL-3.0-or-later
!> A number of an object that a fit may vary: its name, value and range.
module mdrcontact_parameter
    use mdrcontact_kinds, only: wp
    implicit none (type, external)
    private
    public :: parameter_t, append, prefixed
    public :: nature_positive, nature_poisson, nature_signed, nature_not_negative, nature_fraction, nature_term

    !> Which values a parameter may take: > 0; those of an isotropic material's Poisson's ratio; any; >= 0; between 0 and 1; any of
    !> a term of a sum, but >= 0 of the last term that is not fixed at 0.
    integer, parameter :: nature_positive = 1, nature_poisson = 2, nature_signed = 3, nature_not_negative = 4, &
                          nature_fraction = 5, nature_term = 6

    !> One number of an object.
    type :: parameter_t
        !> as in problem files: "layers[0].C44"; blank where it has none
        character(len=48) :: name = ""
        !> in the unit of the whole problem
        real(wp) :: value = 0.0_wp
        !> one of nature_...
        integer :: nature = nature_positive
        !> of one of nature_signed: the size of its effect, > 0; 0: not known, see the data [unit of the value]
        real(wp) :: scale = 0.0_wp
    end type parameter_t

contains

    !> Adds numbers behind the first `count` of a list that has room for more: the cost of n of them grows as n.
    pure subroutine append(list, count, more)
        type(parameter_t), allocatable, intent(inout) :: list(:)
        integer, intent(inout) :: count
        type(parameter_t), intent(in) :: more(:)
        type(parameter_t), allocatable :: longer(:)

        if (count + size(more) > size(list)) then
            allocate (longer(2*(count + size(more))))
            longer(:count) = list(:count)
            call move_alloc(longer, list)
        end if
        list(count + 1:count + size(more)) = more
        count = count + size(more)
    end subroutine append

    !> The same numbers, called as those of a part.
    elemental function prefixed(parameter, prefix) result(part)
        type(parameter_t), intent(in) :: parameter
        character(len=*), intent(in) :: prefix
        type(parameter_t) :: part

        part = parameter
        part%name = prefix//parameter%name
    end function prefixed

end module mdrcontact_parameter
