! SPDX-License-Identifier: GPL-3.0-or-later
!> Radii at which a user's profile is not analytic - where a rounding meets a cone, the knots of a spline - seen from how narrow the
!> panels of the sampled function must be. Quadratures lose their digits where they are not split there.
module mdrcontact_profile_corners
    use mdrcontact_error, only: error_t
    use mdrcontact_kinds, only: wp
    use mdrcontact_numerics_chebyshev, only: chebyshev_sum, cosine_transform, differentiate
    use mdrcontact_numerics_quadrature, only: merge_breaks
    use mdrcontact_numerics_sampled_function, only: sampled_function_t
    use mdrcontact_numerics_scalar_function, only: scalar_function_t
    implicit none (type, external)
    private
    public :: add_corners

    !> Panels below this part of their planned width stand next to a corner, or where f varies so fast that a split does no harm.
    real(wp), parameter :: narrow = 2.0_wp**(-4)
    !> A corner this near to another, relative to its radius, is the same.
    real(wp), parameter :: same = 1.0e-4_wp
    !> A corner is placed by a series on either side, which begins some widths of the narrowest panel away, at least `gap` of the
    !> radius, and ends at `reach`, and by the first of the derivatives up to `most_order` that jumps: by at least `share` of the
    !> largest jump in units of the reach. It is not moved further than the gap.
    integer, parameter :: nodes = 8, most_order = 4
    real(wp), parameter :: widths = 4.0_wp, gap = 1.0e-4_wp, reach = 1.0e-2_wp, share = 0.05_wp

contains

    !> Adds the corners of f to ascending radii: one for each run of narrow panels.
    subroutine add_corners(f, height, planned, radii, error)
        type(sampled_function_t), intent(in) :: f
        !> what f was sampled from
        class(scalar_function_t), intent(inout) :: height
        !> edges between which f was sampled before any panel was halved, ascending
        real(wp), intent(in) :: planned(:)
        real(wp), allocatable, intent(inout) :: radii(:)
        type(error_t), allocatable, intent(inout) :: error
        real(wp) :: left, right, corner, least
        integer :: i, k
        logical :: is_narrow

        k = 1
        least = huge(least)
        corner = 0.0_wp
        do i = 1, size(f%from_root)
            left = f%edges(i)
            right = f%edges(i + 1)
            if (left >= planned(k + 1)) k = k + 1
            is_narrow = right - left < narrow*(planned(k + 1) - planned(k))
            if (is_narrow .and. right - left < least) then
                least = right - left
                corner = 0.5_wp*(left + right)
            end if
            if (least < huge(least) .and. (.not. is_narrow .or. right >= planned(k + 1))) then
                if (f%upper() - corner > same*corner .and. all(abs(radii - corner) > same*corner)) then
                    call place_corner(height, f%upper(), max(widths*least, gap*corner), corner)
                    if (allocated(height%error)) error = height%error
                    call merge_breaks(radii, [corner], error)
                end if
                least = huge(least)
            end if
        end do
    end subroutine add_corners

    !> Moves a corner to where the series of its two sides meet: if derivative m is the first that jumps, derivative m - 1 of their
    !> difference has a simple root there, one step of Newton's method away.
    subroutine place_corner(height, upper, nearest, corner)
        class(scalar_function_t), intent(inout) :: height
        !> where the profile ends, and how near to the corner the series begin [length]
        real(wp), intent(in) :: upper, nearest
        real(wp), intent(inout) :: corner
        real(wp) :: jumps(0:most_order), length, move
        integer :: order

        length = min(max(reach*corner, 10.0_wp*nearest), 0.5_wp*(upper - corner), 0.5_wp*corner)
        if (length < 2.0_wp*nearest) return
        jumps = derivatives(height, corner, length, nearest) - derivatives(height, corner, -length, nearest)
        if (allocated(height%error)) return
        do order = 1, most_order
            if (abs(jumps(order)) >= share*maxval(abs(jumps(1:)))) exit
        end do
        if (order > most_order .or. .not. abs(jumps(order)) > 0.0_wp) return
        move = -length*jumps(order - 1)/(order*jumps(order))
        if (abs(move) <= nearest) corner = corner + move
    end subroutine place_corner

    !> f^(k) length^k/k! at the corner, k = 0 to most_order, from values on the side that `length` points to.
    function derivatives(height, corner, length, nearest) result(d)
        class(scalar_function_t), intent(inout) :: height
        real(wp), intent(in) :: corner, length, nearest
        real(wp) :: d(0:most_order)
        real(wp) :: cosines(nodes, nodes), values(nodes), series(nodes), slopes(nodes), start, scale
        integer :: i, k

        d = 0.0_wp
        start = nearest/abs(length)
        call cosine_transform(cosines)
        do i = 1, nodes
            values(i) = height%value(corner + length*(start + (1.0_wp - start)*0.5_wp*(1.0_wp + 0.5_wp*nodes*cosines(i, 2))))
            if (allocated(height%error)) return
        end do
        series = matmul(values, cosines)
        scale = 1.0_wp
        do k = 0, most_order
            d(k) = scale*chebyshev_sum(series, -1.0_wp - 2.0_wp*start/(1.0_wp - start))*sign(1.0_wp, length)**k
            call differentiate(series, slopes)
            series = slopes
            scale = scale*2.0_wp/(1.0_wp - start)/(k + 1)
        end do
    end function derivatives

end module mdrcontact_profile_corners
