! SPDX-License-Identifier: GPL-3.0-or-later
!> 1 - exp(-y) to full relative precision.
module mdrcontact_numerics_exponential
    use mdrcontact_kinds, only: wp
    implicit none (type, external)
    private
    public :: one_minus_exp, transition_exponents

contains

    !> 1 - exp(-y), y >= 0, by the hyperbolic tangent of y/2: nothing cancels at small y.
    elemental function one_minus_exp(y) result(value)
        real(wp), intent(in) :: y
        real(wp) :: value, t

        t = tanh(0.5_wp*y)
        value = 2.0_wp*t/(1.0_wp + t)
    end function one_minus_exp

    !> Values of y between which 1/(1 + contrast exp(-y)) is smooth enough for one panel: its poles lie pi off the real axis, at
    !> |ln(contrast)|, and it is over where exp(-y) contrast vanishes.
    pure function transition_exponents(contrast) result(y)
        real(wp), intent(in) :: contrast
        real(wp), allocatable :: y(:)
        real(wp), parameter :: spacing = 2.5_wp, beyond = 10.0_wp
        integer :: k

        y = [(spacing*k, k=1, ceiling((abs(log(contrast)) + beyond)/spacing))]
    end function transition_exponents

end module mdrcontact_numerics_exponential
