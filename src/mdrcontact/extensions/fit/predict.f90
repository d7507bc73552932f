! SPDX-License-Identifier: GPL-3.0-or-later
!> The forward model: what the instrument reads at given parameters of the problem.
module mdrcontact_fit_predict
    use mdrcontact_contact_equilibrium, only: equilibrium_t, new_equilibrium
    use mdrcontact_contact_zone_branch, only: add_cohesion
    use mdrcontact_error, only: check_finite, check_made, check_memory, check_not_negative, check_positive, error_domain, &
                                error_invalid, error_t, error_unreachable, raise, to_text
    use mdrcontact_contact, only: on_loading, on_unloading
    use mdrcontact_fit_branches, only: separate
    use mdrcontact_fit_body, only: make_body
    use mdrcontact_fit_contact_radius, only: contact_radii
    use mdrcontact_fit_force_curve, only: force_curve_t, new_force_curve
    use mdrcontact_fit_zone_force, only: zone_forces
    use mdrcontact_fit_problem, only: at_area_factor, at_cohesive_stress, at_contact_depth_factor, at_contact_depth_scale, &
                                      at_depth_offset, &
                                      at_force_offset, at_frame_compliance, at_indenter_modulus, at_stiffness_factor, &
                                      at_work_of_adhesion, data_force_depth, data_force_time, data_modulus_radius, &
                                      data_stiffness_depth, fit_data_t, fit_problem_t
    use mdrcontact_fit_predict_time, only: predict_time
    use mdrcontact_kinds, only: wp
    use mdrcontact_line_shared, only: kernel_cache_t
    use mdrcontact_medium, only: check_elastic, medium_t
    use mdrcontact_medium_solver, only: solver_t, modulus_of_radius_t
    use mdrcontact_medium_homogeneous, only: homogeneous_t, new_homogeneous_from_modulus
    use mdrcontact_medium_pair, only: new_pair
    use mdrcontact_profile, only: profile_t
    use mdrcontact_numerics_radius_law, only: new_radius_law_from_function, radius_law_t
    implicit none (type, external)
    private
    public :: predict

    !> So many radii are worth the sampling of E_eff(a) where each value is a solution of its own.
    integer, parameter :: worth_sampling = 400
    real(wp), parameter :: sampling_tolerance = 1.0e-9_wp

contains

    !> The y of each point, and its contact radius.
    subroutine predict(problem, values, data, y, error, shared, order, radius)
        type(fit_problem_t), intent(in) :: problem
        !> [indenter, medium, instrument]
        real(wp), intent(in) :: values(:)
        type(fit_data_t), intent(in) :: data
        !> same size as data%x
        real(wp), intent(out) :: y(:)
        type(error_t), allocatable, intent(out) :: error
        !> what exact media have in common from one call to the next, which then costs less
        type(kernel_cache_t), intent(inout), optional :: shared
        !> that of ascending_points: the readings y of the data then say which points of an adhesive curve are in contact; without
        !> it the model does: from initial contact on approach, until pull-off on retract
        integer, intent(in), optional, target :: order(:)
        !> same size as data%x: the contact radii, 0 out of contact [length]
        real(wp), intent(out), optional :: radius(:)
        type(kernel_cache_t) :: own
        real(wp), allocatable :: a(:)
        integer, pointer :: given(:)

        y = 0.0_wp
        call check_made(error, "problem", problem%body%is_made)
        if (allocated(error)) return
        nullify (given)
        if (present(order)) given => order
        if (present(shared)) then
            call predict_sharing(problem, values, data, shared, y, a, error, given)
        else
            call predict_sharing(problem, values, data, own, y, a, error, given)
        end if
        if (.not. present(radius)) return
        radius = 0.0_wp
        if (.not. allocated(error)) radius = a
    end subroutine predict

    subroutine predict_sharing(problem, values, data, shared, y, a, error, order)
        type(fit_problem_t), intent(in) :: problem
        real(wp), intent(in) :: values(:)
        type(fit_data_t), intent(in) :: data
        type(kernel_cache_t), intent(inout) :: shared
        real(wp), intent(out) :: y(:)
        !> the contact radii
        real(wp), allocatable, intent(out) :: a(:)
        type(error_t), allocatable, intent(out) :: error
        !> null if it is not given: gfortran 12 computes with the bounds of an absent array
        integer, pointer, intent(in) :: order(:)
        class(profile_t), allocatable :: profile
        type(medium_t) :: pressed
        class(solver_t), allocatable, target :: medium
        real(wp), allocatable :: modulus(:)
        integer :: n, stat

        y = 0.0_wp
        n = size(problem%body%parameters)
        call make_body(problem%body, values(:n), shared, profile, pressed, error)
        if (allocated(error)) return
        associate (instrument => values(n + 1:))
            call check_instrument(instrument, error)
            if (.not. allocated(error) .and. problem%data_kind >= data_force_time) then
                call predict_time(problem%data_kind, instrument, profile, pressed, data, y, a, error)
                return
            end if
            if (.not. allocated(error)) call press(pressed, instrument(at_indenter_modulus), medium, error)
            if (allocated(error)) return
            if (problem%data_kind == data_force_depth) then
                call predict_force(problem, instrument, profile, medium, data, y, a, error, order)
                return
            end if
            if (problem%data_kind == data_stiffness_depth) then
                call contact_radii(profile, medium, instrument, problem%is_elastic, data, a, modulus, error)
            else
                allocate (a(size(data%x)), stat=stat)
                call check_memory(error, stat)
                if (stat == 0) a(:) = data%x*sqrt(instrument(at_area_factor))
            end if
            if (.not. (allocated(error) .or. allocated(modulus))) call sampled_moduli(medium, a, modulus, error)
            if (allocated(error)) return
            ! an instrument that takes the area as too small finds S/(2a) too large
            y = modulus*sqrt(instrument(at_area_factor))
            if (problem%data_kind == data_modulus_radius) return
            y = 1.0_wp/(1.0_wp/(2.0_wp*instrument(at_stiffness_factor)*a*modulus) + instrument(at_frame_compliance))
        end associate
    end subroutine predict_sharing

    !> The medium under a homogeneous indenter.
    subroutine press(pressed, indenter_modulus, medium, error)
        type(medium_t), intent(inout) :: pressed
        !> E* of the indenter; infinite if it is rigid
        real(wp), intent(in) :: indenter_modulus
        class(solver_t), allocatable, intent(out) :: medium
        type(error_t), allocatable, intent(out) :: error
        type(homogeneous_t) :: indenter

        call check_elastic(pressed, error)
        if (allocated(error)) return
        if (indenter_modulus > huge(1.0_wp)) then
            call move_alloc(pressed%solver, medium)
            return
        end if
        call new_homogeneous_from_modulus(indenter, indenter_modulus, error)
        if (.not. allocated(error)) call new_pair(medium, pressed%solver, indenter, error)
    end subroutine press

    pure subroutine check_instrument(instrument, error)
        real(wp), intent(in) :: instrument(:)
        type(error_t), allocatable, intent(inout) :: error

        call check_not_negative(error, "work_of_adhesion", instrument(at_work_of_adhesion))
        call check_not_negative(error, "cohesive_stress", instrument(at_cohesive_stress))
        call check_finite(error, "depth_offset", instrument(at_depth_offset))
        call check_finite(error, "force_offset", instrument(at_force_offset))
        call check_finite(error, "frame_compliance", instrument(at_frame_compliance))
        if (.not. instrument(at_indenter_modulus) > 0.0_wp) then
            call raise(error, error_invalid, "indenter_modulus = "//to_text(instrument(at_indenter_modulus))// &
                       ": it must be greater than 0, or infinite for a rigid indenter")
        end if
        call check_finite(error, "contact_depth_factor", instrument(at_contact_depth_factor))
        call check_positive(error, "stiffness_factor", instrument(at_stiffness_factor))
        call check_positive(error, "contact_depth_scale", instrument(at_contact_depth_scale))
        call check_positive(error, "area_factor", instrument(at_area_factor))
    end subroutine check_instrument

    !> F + force offset at depths freed of the offset and of the deflection of the frame: d = x - offset - C (y - force offset).
    subroutine predict_force(problem, instrument, profile, medium, data, y, a, error, order)
        type(fit_problem_t), intent(in) :: problem
        real(wp), intent(in) :: instrument(:)
        class(profile_t), intent(in) :: profile
        class(solver_t), intent(in) :: medium
        type(fit_data_t), intent(in) :: data
        real(wp), intent(out) :: y(:)
        real(wp), allocatable, intent(out) :: a(:)
        type(error_t), allocatable, intent(out) :: error
        integer, pointer, intent(in) :: order(:)
        type(equilibrium_t) :: equilibrium
        type(force_curve_t) :: curve
        real(wp), allocatable :: d(:), sd(:)
        integer, allocatable :: branch(:)
        real(wp) :: smallest
        logical, allocatable :: apart(:)
        logical :: reached, everywhere
        integer :: i, n, stat

        n = size(y)
        allocate (a(n), d(n), sd(n), branch(n), apart(n), stat=stat)
        call check_memory(error, stat)
        if (allocated(error)) return
        a(:) = 0.0_wp
        d = data%x - instrument(at_depth_offset)
        if (instrument(at_frame_compliance) /= 0.0_wp) then
            d = d - instrument(at_frame_compliance)*(data%y - instrument(at_force_offset))
        end if
        y = instrument(at_force_offset)
        if (maxval(d) <= 0.0_wp .and. .not. instrument(at_work_of_adhesion) > 0.0_wp) return
        call make_equilibrium(problem, instrument, profile, medium, equilibrium, error)
        if (allocated(error)) return
        branch(:) = on_unloading
        if (allocated(data%branch)) branch(:) = data%branch
        everywhere = .true.
        if (allocated(equilibrium%cohesion)) then
            call zone_forces(equilibrium, d, branch == on_loading, y, a, apart, error)
            if (allocated(error)) return
        else
            smallest = minval(d)
            if (.not. instrument(at_work_of_adhesion) > 0.0_wp) smallest = minval(d, mask=d > 0.0_wp)
            call new_force_curve(curve, equilibrium, smallest, maxval(d), error, n)
            if (allocated(error)) return
            do i = 1, n
                call curve%at(d(i), y(i), a(i), reached)
                everywhere = everywhere .and. reached
            end do
            apart(:) = (branch == on_loading .and. d < 0.0_wp) .or. d < curve%pull_off_depth()
        end if
        y = y + instrument(at_force_offset)
        if (instrument(at_work_of_adhesion) > 0.0_wp) then
            if (associated(order)) then
                sd(:) = 1.0_wp
                if (allocated(data%sd)) sd(:) = data%sd
                call separate(order, branch, data%y, sd, instrument(at_force_offset), y)
            else
                do i = 1, n
                    if (.not. apart(i)) cycle
                    y(i) = instrument(at_force_offset)
                    a(i) = 0.0_wp
                end do
            end if
        end if
        if (.not. everywhere) call raise(error, error_unreachable, "depth = "//to_text(maxval(d))// &
                                           ": this indenter on this medium does not reach it")
    end subroutine predict_force

    subroutine make_equilibrium(problem, instrument, profile, medium, equilibrium, error)
        type(fit_problem_t), intent(in) :: problem
        real(wp), intent(in) :: instrument(:)
        class(profile_t), intent(in) :: profile
        class(solver_t), intent(in) :: medium
        type(equilibrium_t), intent(out) :: equilibrium
        type(error_t), allocatable, intent(out) :: error

        call new_equilibrium(equilibrium, profile, medium, error)
        equilibrium%work_of_adhesion = instrument(at_work_of_adhesion)
        equilibrium%rule = problem%adhesion_rule
        if (allocated(error) .or. .not. equilibrium%work_of_adhesion > 0.0_wp) return
        if (instrument(at_cohesive_stress) > 0.0_wp) call add_cohesion(equilibrium, instrument(at_cohesive_stress), error)
    end subroutine make_equilibrium

    !> E_eff(a) of medium and indenter.
    subroutine sampled_moduli(medium, a, modulus, error)
        class(solver_t), intent(in), target :: medium
        real(wp), intent(in) :: a(:)
        real(wp), allocatable, intent(out) :: modulus(:)
        type(error_t), allocatable, intent(out) :: error
        type(modulus_of_radius_t) :: f
        type(radius_law_t) :: law
        integer :: stat

        if (maxval(a) > medium%largest_radius .or. minval(a) < medium%smallest_radius) then
            call raise(error, error_domain, "the contact radii "//to_text(minval(a))//" to "//to_text(maxval(a))// &
                       " are outside the range of the medium"//trim(medium%why_it_ends))
            return
        end if
        allocate (modulus(size(a)), stat=stat)
        call check_memory(error, stat)
        if (allocated(error)) return
        if (size(a) < worth_sampling .or. medium%is_modulus_formula) then
            call medium%modulus(a, modulus, error)
        else
            f%medium => medium
            call new_radius_law_from_function(law, f, "modulus", minval(a), maxval(a), sampling_tolerance, error)
            if (.not. allocated(error)) modulus(:) = law%at(a)
        end if
        if (allocated(error)) return
    end subroutine sampled_moduli

end module mdrcontact_fit_predict
