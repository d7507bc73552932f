! SPDX-License-Identifier: GPL-3.0-or-later
!> The history of a contact with a viscoelastic body: depth, radius and force along a path in time.
module mdrcontact_time_history
    use mdrcontact_contact, only: contact_t, new_contact
    use mdrcontact_contact_state, only: contact_state_t
    use mdrcontact_contact_values, only: contact_states, given_depth, given_force, given_radius
    use mdrcontact_error, only: check_code, check_made, check_not_negative, check_table, check_within, error_invalid, error_t, &
                                raise, to_text
    use mdrcontact_time_follow, only: follow_depth
    use mdrcontact_time_steps, only: march_through
    use mdrcontact_time_under_force, only: follow_force
    use mdrcontact_contact_relaxing_contact, only: refuse_attraction, relaxing_contact_t
    use mdrcontact_kinds, only: wp
    use mdrcontact_material_prony, only: prony_t
    use mdrcontact_medium_viscoelastic, only: viscoelastic_t
    implicit none (type, external)
    private
    public :: contact_history

    real(wp), parameter :: default_tolerance = 1.0e-5_wp, smallest_tolerance = 1.0e-9_wp, largest_tolerance = 1.0e-2_wp
    !> Factor by which power laws are more accurate than that, at little cost: to machine precision at tolerances that are not
    !> coarse.
    real(wp), parameter :: of_power_laws = 1.0e-7_wp

contains

    !> Depth, radius and force at each time, of which one is prescribed. Before the first time the bodies are separated and at rest;
    !> the first prescribed value is applied as a step. In between it is linear in time.
    subroutine contact_history(contact, given, time, values, depth, radius, force, error, tolerance, depth_alone)
        type(relaxing_contact_t), intent(in) :: contact
        !> given_depth, given_force or given_radius
        integer, intent(in) :: given
        !> strictly ascending [time]
        real(wp), intent(in) :: time(:)
        !> the prescribed quantity: d, negative for separated bodies [length], or F >= 0 [modulus length^2], or a >= 0 [length]
        real(wp), intent(in) :: values(:)
        !> same size as time
        real(wp), intent(out) :: depth(:), radius(:), force(:)
        type(error_t), allocatable, intent(out) :: error
        !> where steps in time are taken: relative to the largest depth, radius and force; a shrinking contact that grows again by
        !> less has not grown; default 1e-5
        real(wp), intent(in), optional :: tolerance
        !> under a prescribed force the tolerance is that of the depth alone; default .false.
        logical, intent(in), optional :: depth_alone
        real(wp) :: accuracy
        integer :: i
        logical :: covered

        call check_made(error, "contact", contact%is_made)
        if (allocated(error)) return
        accuracy = default_tolerance
        if (present(tolerance)) accuracy = tolerance
        depth = 0.0_wp
        radius = 0.0_wp
        force = 0.0_wp
        call check_code(error, "given", given, [given_depth, given_force, given_radius])
        call refuse_attraction(contact, error)
        if (allocated(error)) return
        call check_within(error, "tolerance", accuracy, smallest_tolerance, largest_tolerance)
        call check_table(error, "time", time, trim(word(given)), values, 1)
        if (given /= given_depth) then
            do i = 1, size(values)
                call check_not_negative(error, trim(word(given)), values(i), i)
            end do
        end if
        if (allocated(error)) return
        associate (medium => contact%medium)
            if (given /= given_force .and. values(1) > 0.0_wp .and. .not. medium%materials(1)%has_glassy()) then
                call raise(error, error_invalid, " = "//to_text(values(1))//": with a power law or a parallel dashpot a step "// &
                           "of the depth needs an infinite force. Begin with 0", trim(word(given)), 1)
                return
            end if
            covered = medium%is_proportional
            if (covered) call of_proportional(contact, medium, given, time, values, accuracy, depth, radius, force, &
                                              covered, error, depth_alone)
            if (allocated(error) .or. covered) return
            call march_through(contact, medium, given, time, values, accuracy, depth, radius, force, error)
        end associate
    end subroutine contact_history

    pure function word(given) result(name)
        integer, intent(in) :: given
        character(len=6) :: name

        name = "radius"
        if (given == given_depth) name = "depth"
        if (given == given_force) name = "force"
    end function word

    !> A body whose materials relax proportionally, as far as its history follows from the elastic curve.
    subroutine of_proportional(contact, medium, given, time, values, tolerance, depth, radius, force, covered, error, depth_alone)
        type(relaxing_contact_t), intent(in) :: contact
        type(viscoelastic_t), intent(in) :: medium
        integer, intent(in) :: given
        real(wp), intent(in) :: time(:), values(:), tolerance
        real(wp), intent(inout) :: depth(:), radius(:), force(:)
        logical, intent(out) :: covered
        type(error_t), allocatable, intent(out) :: error
        logical, intent(in), optional :: depth_alone
        type(contact_t) :: elastic
        type(prony_t) :: phi
        logical :: for_depth

        covered = .false.
        for_depth = .false.
        if (present(depth_alone)) for_depth = depth_alone
        call new_contact(elastic, contact%equilibrium%profile, medium%reference, error)
        if (allocated(error)) return
        phi = medium%relaxation_shape(shortest_step(time), max(time(size(time)) - time(1), shortest_step(time)), &
                                      merge(of_power_laws*tolerance, 0.0_wp, tolerance > default_tolerance))
        select case (given)
        case (given_depth)
            depth = values
            call follow_depth(elastic, phi, time, depth, tolerance, radius, force, covered, error)
        case (given_force)
            force = values
            call follow_force(elastic, phi, time, force, tolerance, for_depth, depth, radius, covered, error)
        case default
            call depths_of(elastic, values, depth, error)
            if (.not. allocated(error)) call follow_depth(elastic, phi, time, depth, tolerance, radius, force, covered, error)
            covered = covered .and. all(depth(2:) >= depth(:size(depth) - 1))
        end select
    end subroutine of_proportional

    !> Depths of the elastic contact at radii.
    subroutine depths_of(contact, radii, depths, error)
        type(contact_t), intent(in) :: contact
        real(wp), intent(in) :: radii(:)
        real(wp), intent(out) :: depths(:)
        type(error_t), allocatable, intent(out) :: error
        type(contact_state_t) :: states(size(radii))

        call contact_states(contact, given_radius, radii, states, error)
        if (.not. allocated(error)) depths = states%depth
    end subroutine depths_of

    !> The shortest time between samples; 1 for a single one.
    pure function shortest_step(time) result(step)
        real(wp), intent(in) :: time(:)
        real(wp) :: step

        step = 1.0_wp
        if (size(time) > 1) step = minval(time(2:) - time(:size(time) - 1))
    end function shortest_step

end module mdrcontact_time_history
