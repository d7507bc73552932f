! SPDX-License-Identifier: GPL-3.0-or-later
!> 1 - exp(-y) to full relative precision.
module mdrcontact_exponential
    use mdrcontact_kinds, only: wp
    implicit none (type, external)
    private
    public :: one_minus_exp

contains

    !> 1 - exp(-y), y >= 0, by the hyperbolic tangent of y/2: nothing cancels at small y.
    elemental function one_minus_exp(y) result(value)
        real(wp), intent(in) :: y
        real(wp) :: value, t

        t = tanh(0.5_wp*y)
        value = 2.0_wp*t/(1.0_wp + t)
    end function one_minus_exp

end module mdrcontact_exponential
