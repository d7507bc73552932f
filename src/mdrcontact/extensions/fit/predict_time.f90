! SPDX-License-Identifier: GPL-3.0-or-later
!> Predicted readings on a viscoelastic body: forces or depths in time, and dynamic stiffnesses.
module mdrcontact_fit_predict_time
    use mdrcontact_contact_values, only: given_depth, given_force
    use mdrcontact_error, only: check_memory, error_invalid, error_t, raise
    use mdrcontact_fit_problem, only: at_area_factor, at_depth_offset, at_force_offset, at_frame_compliance, &
                                      at_indenter_modulus, at_stiffness_factor, at_work_of_adhesion, &
                                      data_dynamic_stiffness, data_force_time, fit_data_t, part_loss
    use mdrcontact_time_history, only: contact_history
    use mdrcontact_time_stiffness, only: dynamic_stiffness
    use mdrcontact_contact_relaxing_contact, only: new_relaxing_contact, relaxing_contact_t
    use mdrcontact_kinds, only: wp
    use mdrcontact_medium, only: medium_t
    use mdrcontact_profile, only: profile_t
    implicit none (type, external)
    private
    public :: predict_time

    !> Tolerance of histories, more than the effect of noisy depths on the edge of a shrinking contact.
    real(wp), parameter :: history_tolerance = 1.0e-3_wp

contains

    !> The y of each point, and its contact radius.
    subroutine predict_time(data_kind, instrument, profile, medium, data, y, a, error)
        !> data_force_time, data_depth_time or data_dynamic_stiffness
        integer, intent(in) :: data_kind
        real(wp), intent(in) :: instrument(:)
        class(profile_t), intent(in) :: profile
        type(medium_t), intent(in) :: medium
        type(fit_data_t), intent(in) :: data
        !> same size as data%x
        real(wp), intent(out) :: y(:)
        real(wp), allocatable, intent(out) :: a(:)
        type(error_t), allocatable, intent(out) :: error
        type(relaxing_contact_t) :: contact
        real(wp), allocatable :: depth(:), force(:)
        integer :: stat

        y = 0.0_wp
        allocate (a(size(y)), depth(size(y)), force(size(y)), stat=stat)
        call check_memory(error, stat)
        if (allocated(error)) return
        a(:) = 0.0_wp
        if (instrument(at_work_of_adhesion) > 0.0_wp) then
            call raise(error, error_invalid, "work_of_adhesion: it is not available with a viscoelastic body. Fix it at 0")
        else if (instrument(at_indenter_modulus) <= huge(1.0_wp)) then
            call raise(error, error_invalid, "indenter_modulus: with a viscoelastic body the indenter must be rigid. Set it "// &
                "to infinity")
        else if (.not. allocated(medium%relaxing)) then
            call raise(error, error_invalid, "medium: an elastic body has no history. Use states")
        else if (instrument(at_frame_compliance) /= 0.0_wp .and. data_kind /= data_dynamic_stiffness) then
            call raise(error, error_invalid, "frame_compliance: it must be 0 with a viscoelastic body. Subtract the "// &
                "deflection of the frame from the depths")
        end if
        if (.not. allocated(error)) call new_relaxing_contact(contact, profile, medium%relaxing, error)
        if (allocated(error)) return
        if (data_kind == data_dynamic_stiffness) then
            call predict_oscillation(contact, instrument, data, y, a, error)
        else if (data_kind == data_force_time) then
            call contact_history(contact, given_depth, data%x, data%given - instrument(at_depth_offset), depth, a, force, error, &
                                 history_tolerance)
            y = force + instrument(at_force_offset)
        else
            ! a reading below the offset is noise of an instrument that does not touch
            call contact_history(contact, given_force, data%x, max(data%given - instrument(at_force_offset), 0.0_wp), depth, a, &
                                 force, error, history_tolerance, depth_alone=.true.)
            y = depth + instrument(at_depth_offset)
        end if
    end subroutine predict_time

    !> k' and k'' of contact and frame in series.
    subroutine predict_oscillation(contact, instrument, data, y, a, error)
        type(relaxing_contact_t), intent(in) :: contact
        real(wp), intent(in) :: instrument(:)
        type(fit_data_t), intent(in) :: data
        real(wp), intent(inout) :: y(:), a(:)
        type(error_t), allocatable, intent(out) :: error
        complex(wp), allocatable :: k(:)
        integer :: stat

        allocate (k(size(y)), stat=stat)
        call check_memory(error, stat)
        if (allocated(error)) return
        a = data%given*sqrt(instrument(at_area_factor))
        call dynamic_stiffness(contact, data%x, a, k, error)
        if (allocated(error)) return
        k(:) = 1.0_wp/(1.0_wp/(instrument(at_stiffness_factor)*k) + instrument(at_frame_compliance))
        y = merge(aimag(k), real(k, wp), data%branch == part_loss)
    end subroutine predict_oscillation

end module mdrcontact_fit_predict_time
