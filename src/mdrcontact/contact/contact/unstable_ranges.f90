! SPDX-License-Identifier: GPL-3.0-or-later
!> Where depth and force of a contact without adhesion fall while its radius grows.
!>
!> A surface layer much stiffer than what lies below it bends as a plate, and a plate does not follow a tip, a corner or a
!> flat flank. p(r) is the sum of flat punches' pressures d'(s) p_1(r; s) ds over s > r (theory/exact.md (1.7)), negative near the
!> edge where d' is: of the states of one depth the contact, as it grows, comes to the one with the smallest radius, and larger ones
!> pull.
module mdrcontact_contact_unstable_ranges
    use mdrcontact_contact_control, only: depth_control
    use mdrcontact_contact_curve, only: curve_point_t, curve_t, new_curve
    use mdrcontact_contact_equilibrium, only: equilibrium_t, unstable_range_t
    use mdrcontact_contact_range, only: coordinates_between
    use mdrcontact_error, only: error_no_convergence, error_t
    use mdrcontact_kinds, only: wp
    implicit none (type, external)
    private
    public :: find_unstable_ranges

    !> Contrasts of surface and body from which on depths are considered: they have been seen to fall from 80 on under cones, where
    !> E0*/E_eff is 31, and from 12 on at the corner of a flat end 30 thicknesses wide.
    real(wp), parameter :: least_contrast = 30.0_wp, least_at_flat_end = 7.0_wp
    !> Radii considered, as parts of the medium's largest one.
    real(wp), parameter :: smallest = 1.0e-7_wp, largest = 1.0e-2_wp
    !> Relative tolerance of the samples, and the noise up to which they are taken: what falls by less may be missed.
    real(wp), parameter :: tolerance = 1.0e-6_wp, largest_noise = 1.0e-2_wp
    !> By so much in the coordinate the range is made shorter where it cannot be sampled.
    real(wp), parameter :: decade = 2.3_wp

contains

    !> Fills equilibrium%unstable_ranges. Where the states cannot be sampled none are known.
    subroutine find_unstable_ranges(equilibrium, error)
        type(equilibrium_t), intent(inout) :: equilibrium
        type(error_t), allocatable, intent(out) :: error
        type(curve_t) :: curve
        type(curve_point_t) :: point
        type(unstable_range_t) :: found
        real(wp), allocatable :: coordinates(:), turns(:, :)
        real(wp) :: first, last, lowest
        integer :: i

        if (equilibrium%medium%surface_contrast < merge(least_at_flat_end, least_contrast, &
                                                        equilibrium%profile%end_radius > 0.0_wp)) return
        first = log(smallest*equilibrium%medium%largest_radius)
        last = equilibrium%coordinate_of(min(equilibrium%last_radius, largest*equilibrium%medium%largest_radius))
        do
            if (.not. first < last) return
            call coordinates_between(equilibrium, first, last, coordinates, error)
            if (allocated(error)) return
            call new_curve(curve, equilibrium, coordinates, tolerance, error, largest_noise)
            if (.not. allocated(error)) exit
            if (error%code /= error_no_convergence) return
            ! wide contacts may fail
            deallocate (error)
            last = last - decade
        end do
        turns = curve%turns(depth_control)
        if (size(turns, 2) == 0) return
        if (.not. curve%slope(depth_control, turns(1, 1)) > 0.0_wp) return
        do i = 1, size(turns, 2), 2
            call curve%turn(depth_control, turns(1, i), turns(2, i), found%first, error)
            if (allocated(error)) return
            found%last = last
            if (i < size(turns, 2)) then
                call curve%turn(depth_control, turns(1, i + 1), turns(2, i + 1), found%last, error)
                if (allocated(error)) return
            end if
            point = curve%at(found%last)
            lowest = point%depth
            point = curve%at(found%first)
            if (lowest > point%depth*(1.0_wp - 10.0_wp*tolerance)) cycle
            found%top%radius = point%radius
            found%top%depth = point%depth
            found%top%force = point%force
            found%top%stiffness = point%stiffness
            equilibrium%unstable_ranges = [equilibrium%unstable_ranges, found]
        end do
    end subroutine find_unstable_ranges

end module mdrcontact_contact_unstable_ranges
