! SPDX-License-Identifier: GPL-3.0-or-later
!> Working precision and the mathematical constants that every module shares.
module mdrcontact_kinds
    use, intrinsic :: iso_fortran_env, only: real64
    implicit none (type, external)
    private
    public :: wp, pi, half_pi

    !> Working precision: IEEE double, the precision of GSL, LAPACK and the C API.
    integer, parameter :: wp = real64
    !> The ratio of a circle's circumference to its diameter.
    real(wp), parameter :: pi = 3.141592653589793238462643383279502884_wp
    !> A right angle [radian].
    real(wp), parameter :: half_pi = 0.5_wp*pi

end module mdrcontact_kinds
