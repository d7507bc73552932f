! SPDX-License-Identifier: GPL-3.0-or-later
!> Which interval between ascending edges holds a position.
module mdrcontact_numerics_search
    use, intrinsic :: iso_c_binding, only: c_size_t
    use mdrcontact_gsl, only: gsl_interp_bsearch
    use mdrcontact_kinds, only: wp
    implicit none (type, external)
    private
    public :: interval_of

contains

    !> i with edges(i) <= x < edges(i + 1); beyond the ends the first or the last interval.
    pure function interval_of(edges, x) result(i)
        !> ascending, at least 2
        real(wp), intent(in), contiguous :: edges(:)
        real(wp), intent(in) :: x
        integer :: i

        i = 1 + int(gsl_interp_bsearch(edges, x, 0_c_size_t, size(edges, kind=c_size_t) - 1_c_size_t))
    end function interval_of

end module mdrcontact_numerics_search
