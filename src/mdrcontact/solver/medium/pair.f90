! SPDX-License-Identifier: GPL-3.0-or-later
!> Two deformable bodies as one medium (theory/exact.md (5.1), (5.4)): the same pressure acts on both, so that their compliances
!> add.
!>
!> Homogeneous bodies and bodies solved exactly add exactly. Where one of them is known by an effective modulus only, the moduli add
!> in series. The springs of power-law graded bodies add only if they have the same exponent.
module mdrcontact_medium_pair
    use mdrcontact_object, only: room
    use mdrcontact_body, only: copy
    use mdrcontact_error, only: error_invalid, error_t, raise
    use mdrcontact_kinds, only: wp
    use mdrcontact_medium_exact, only: layered_exact_t, new_exact_pair, new_layered_exact
    use mdrcontact_medium_sampled_exact, only: new_sampled_exact
    use mdrcontact_medium_solver, only: copy, solver_t
    use mdrcontact_medium_effective, only: effective_medium_t
    use mdrcontact_medium_homogeneous, only: homogeneous_t, new_homogeneous_from_modulus, new_homogeneous_pair
    use mdrcontact_medium_power_graded, only: new_power_graded_pair, power_graded_t
    use mdrcontact_medium_series, only: new_series, series_t
    use mdrcontact_medium_tabulated, only: tabulated_medium_t
    use mdrcontact_tension_surface, only: is_bare
    implicit none (type, external)
    private
    public :: new_pair

    !> The solver of two bodies.
    interface new_pair
        module procedure new_pair_of_solvers
    end interface new_pair

contains

    !> The medium of two bodies. The profile of a contact with it is the gap before contact, the sum of both shapes; its depth is
    !> the approach of distant points.
    subroutine new_pair_of_solvers(medium, lower, upper, error)
        class(solver_t), allocatable, intent(out) :: medium
        !> media of one body each; one of them may be rigid. Copied
        class(solver_t), intent(in) :: lower, upper
        type(error_t), allocatable, intent(out) :: error
        type(homogeneous_t) :: homogeneous
        type(power_graded_t) :: power_graded

        if (lower%is_pair) call raise(error, error_invalid, ": it is already a pair of bodies", "lower")
        if (upper%is_pair) call raise(error, error_invalid, ": it is already a pair of bodies", "upper")
        if (lower%is_rigid .and. upper%is_rigid) then
            call raise(error, error_invalid, ": one of the two bodies must be deformable", "upper")
        end if
        if (allocated(error)) return
        if (.not. (is_bare(lower%sheet) .or. upper%is_rigid) .or. .not. is_bare(upper%sheet)) then
            call raise(error, error_invalid, "medium: a pair is not available for surfaces with tension or a sheet. Use a "// &
                       "rigid body for the other one")
            return
        end if
        if (upper%is_rigid) then
            call copy(lower, medium, error)
            return
        end if
        select type (lower)
        class is (homogeneous_t)
            select type (upper)
            class is (homogeneous_t)
                call new_homogeneous_pair(homogeneous, lower, upper, error)
                allocate (medium, source=homogeneous)
                return
            end select
        class is (power_graded_t)
            select type (upper)
            class is (power_graded_t)
                call new_power_graded_pair(power_graded, lower, upper, error)
                if (.not. allocated(error)) allocate (medium, source=power_graded)
                return
            end select
        end select
        if (is_solved(lower) .and. is_solved(upper)) then
            call add_exactly(medium, lower, upper, error)
        else
            call add_in_series(medium, lower, upper, error)
        end if
    end subroutine new_pair_of_solvers

    !> Whether its exact solution is known: then the compliances add.
    pure function is_solved(medium) result(answer)
        class(solver_t), intent(in) :: medium
        logical :: answer

        answer = .false.
        select type (medium)
        class is (homogeneous_t)
            answer = .true.
        class is (layered_exact_t)
            answer = .true.
        end select
    end function is_solved

    subroutine add_exactly(medium, lower, upper, error)
        class(solver_t), allocatable, intent(out) :: medium
        !> solved
        class(solver_t), intent(in), target :: lower, upper
        type(error_t), allocatable, intent(out) :: error
        type(layered_exact_t), target :: bare(2)
        class(layered_exact_t), pointer :: first, second
        type(layered_exact_t), allocatable :: exact

        allocate (exact)
        call as_exact(lower, bare(1), first, error)
        if (.not. allocated(error)) call as_exact(upper, bare(2), second, error)
        if (.not. allocated(error)) call new_exact_pair(exact, first, second, error)
        if (.not. allocated(error)) call move_alloc(exact, medium)
    end subroutine add_exactly

    !> The medium itself, or a half-space in the same form.
    subroutine as_exact(medium, bare, exact, error)
        class(solver_t), intent(in), target :: medium
        type(layered_exact_t), intent(inout), target :: bare
        class(layered_exact_t), pointer, intent(out) :: exact
        type(error_t), allocatable, intent(inout) :: error

        exact => bare
        select type (medium)
        class is (homogeneous_t)
            call new_layered_exact(bare, medium, error)
        class is (layered_exact_t)
            exact => medium
        end select
    end subroutine as_exact

    subroutine add_in_series(medium, lower, upper, error)
        class(solver_t), allocatable, intent(out) :: medium
        class(solver_t), intent(in) :: lower, upper
        type(error_t), allocatable, intent(out) :: error
        class(effective_medium_t), allocatable :: first, second
        type(series_t), allocatable :: series

        allocate (series)
        call as_effective(lower, first, error)
        if (.not. allocated(error)) call as_effective(upper, second, error)
        if (allocated(error)) return
        call new_series(series, first, second, error)
        if (.not. allocated(error)) call move_alloc(series, medium)
    end subroutine add_in_series

    !> A body by its effective modulus.
    subroutine as_effective(medium, effective, error)
        class(solver_t), intent(in) :: medium
        class(effective_medium_t), allocatable, intent(out) :: effective
        type(error_t), allocatable, intent(out) :: error
        type(tabulated_medium_t), allocatable :: sampled
        type(homogeneous_t) :: homogeneous

        select type (medium)
        class is (effective_medium_t)
            call room(medium%bytes(), error)
            if (.not. allocated(error)) allocate (effective, source=medium)
        class is (layered_exact_t)
            if (medium%pressed%first_depth > 0.0_wp) then
                allocate (sampled)
                call new_sampled_exact(sampled, medium, error)
                if (.not. allocated(error)) call move_alloc(sampled, effective)
            else
                ! layers of one material
                call new_homogeneous_from_modulus(homogeneous, medium%pressed%surface_modulus, error)
                if (.not. allocated(error)) call copy(medium%pressed, homogeneous%pressed, error)
                if (.not. allocated(error)) allocate (effective, source=homogeneous)
            end if
        class default
            call raise(error, error_invalid, ": a power-law graded body pairs only with its own kind. Use a graded body with "// &
                       "layers instead", "upper")
        end select
    end subroutine as_effective

end module mdrcontact_medium_pair
