! SPDX-License-Identifier: GPL-3.0-or-later
!> Two deformable bodies as one medium (theory 9): the same pressure acts on both, so that their compliances add.
!>
!> Homogeneous bodies and bodies solved exactly add exactly. Where a body is known by an effective modulus only, the moduli add in
!> series. The springs of power-law graded bodies add only if they have the same exponent.
module mdrcontact_medium_pair
    use mdrcontact_error, only: error_invalid, error_t, raise
    use mdrcontact_layered_exact, only: layered_exact_t, new_exact_pair, new_layered_exact
    use mdrcontact_medium, only: medium_t
    use mdrcontact_medium_effective, only: effective_medium_t
    use mdrcontact_medium_homogeneous, only: homogeneous_t, new_homogeneous_pair
    use mdrcontact_medium_power_graded, only: new_power_graded_pair, power_graded_t
    use mdrcontact_medium_series, only: new_series, series_t
    implicit none (type, external)
    private
    public :: new_pair

contains

    !> The medium of two bodies. The profile of a contact with it is the gap before contact, the sum of both shapes; its depth is
    !> the approach of distant points.
    subroutine new_pair(medium, lower, upper, error)
        class(medium_t), allocatable, intent(out) :: medium
        !> media of one body each; one of them may be rigid. Copied
        class(medium_t), intent(in) :: lower, upper
        type(error_t), allocatable, intent(out) :: error
        type(layered_exact_t) :: first, second, exact
        type(homogeneous_t) :: homogeneous
        type(power_graded_t) :: power_graded
        type(series_t) :: series
        logical :: are_exact(2)

        if (lower%is_pair()) call raise(error, error_invalid, " is not allowed: it is a pair of bodies already", "lower")
        if (upper%is_pair()) call raise(error, error_invalid, " is not allowed: it is a pair of bodies already", "upper")
        if (lower%is_rigid() .and. upper%is_rigid()) then
            call raise(error, error_invalid, " is not allowed: one of the two bodies must be deformable", "upper")
        end if
        if (allocated(error)) return
        if (upper%is_rigid()) then
            allocate (medium, source=lower)
            return
        end if
        are_exact = .false.
        select type (lower)
        class is (homogeneous_t)
            select type (upper)
            class is (homogeneous_t)
                call new_homogeneous_pair(homogeneous, lower, upper)
                allocate (medium, source=homogeneous)
                return
            end select
            call new_layered_exact(first, lower)
            are_exact(1) = .true.
        class is (layered_exact_t)
            first = lower
            are_exact(1) = .true.
        class is (power_graded_t)
            select type (upper)
            class is (power_graded_t)
                call new_power_graded_pair(power_graded, lower, upper, error)
                if (.not. allocated(error)) allocate (medium, source=power_graded)
                return
            end select
        end select
        select type (upper)
        class is (homogeneous_t)
            call new_layered_exact(second, upper)
            are_exact(2) = .true.
        class is (layered_exact_t)
            second = upper
            are_exact(2) = .true.
        end select
        if (all(are_exact)) then
            call new_exact_pair(exact, first, second, error)
            if (.not. allocated(error)) allocate (medium, source=exact)
            return
        end if
        select type (lower)
        class is (effective_medium_t)
            select type (upper)
            class is (effective_medium_t)
                call new_series(series, lower, upper)
                allocate (medium, source=series)
                return
            end select
        end select
        call refuse(lower, upper, error)
    end subroutine new_pair

    subroutine refuse(lower, upper, error)
        class(medium_t), intent(in) :: lower, upper
        type(error_t), allocatable, intent(inout) :: error
        logical :: is_power_graded

        is_power_graded = .false.
        select type (lower)
        class is (power_graded_t)
            is_power_graded = .true.
        end select
        select type (upper)
        class is (power_graded_t)
            is_power_graded = .true.
        end select
        if (is_power_graded) then
            call raise(error, error_invalid, " is not allowed: the springs of a power-law graded body and those of "// &
                       "another kind do not add; take a graded body for the power law", "upper")
        else
            call raise(error, error_invalid, " is not allowed: one body is solved exactly, the other known by an "// &
                       "effective modulus; take the model exact for both, or an approximate one for both", "upper")
        end if
    end subroutine refuse

end module mdrcontact_medium_pair
