! SPDX-License-Identifier: GPL-3.0-or-later
!> The history of a flat punch on a gel, along any path of its depth or force: theory/poroelastic.md (5.4).
module mdrcontact_poroelastic_history
    use mdrcontact_cancel, only: check_cancelled
    use mdrcontact_codes, only: creep, depth, force, mean_creep, mean_relaxation, relaxation
    use mdrcontact_error, only: check_code, check_made, check_table, error_t, raise_at
    use mdrcontact_kinds, only: wp
    use mdrcontact_poroelastic_response, only: poroelastic_response
    use mdrcontact_poroelastic_table, only: poroelastic_t
    implicit none (type, external)
    private
    public :: poroelastic_history

    !> A slope that changes by less, relative to the slope, is the rounding of a straight path.
    real(wp), parameter :: straight = 1.0e-12_wp

contains

    !> The force along a path of the depth, or the depth along a path of the force. The path is linear in time between its
    !> entries; the bodies are at rest before the first time, and reach the first value in a jump. Tension is allowed.
    subroutine poroelastic_history(table, given, shear_modulus, diffusivity, radius, time, path, values, error)
        type(poroelastic_t), intent(in) :: table
        !> depth or force: the prescribed quantity
        integer, intent(in) :: given
        !> > 0 [modulus], [length^2/time], [length]
        real(wp), intent(in) :: shear_modulus, diffusivity, radius
        !> strictly ascending [time]
        real(wp), intent(in) :: time(:)
        !> same size as time [length] or [modulus length^2]
        real(wp), intent(in) :: path(:)
        !> same size as time: the other quantity
        real(wp), intent(out) :: values(:)
        type(error_t), allocatable, intent(out) :: error
        real(wp), allocatable :: mean(:)
        real(wp) :: slope, before
        integer :: step, ramp, i

        values = 0.0_wp
        call check_made(error, "table", table%is_made)
        if (allocated(error)) return
        call check_code(error, "given", given, [depth, force])
        call check_table(error, "time", time, merge("depth", "force", given == depth), path, 1)
        if (allocated(error)) return
        step = merge(relaxation, creep, given == depth)
        ramp = merge(mean_relaxation, mean_creep, given == depth)
        call poroelastic_response(table, step, shear_modulus, diffusivity, radius, time - time(1), values, error)
        values = path(1)*values
        before = 0.0_wp
        do i = 1, size(time) - 1
            slope = (path(i + 1) - path(i))/(time(i + 1) - time(i))
            if (abs(slope - before) <= straight*max(abs(slope), abs(before))) cycle
            call check_cancelled(error)
            if (allocated(error)) return
            allocate (mean(size(time) - i))
            associate (since => time(i + 1:) - time(i))
                call poroelastic_response(table, ramp, shear_modulus, diffusivity, radius, since, mean, error)
                if (allocated(error)) then
                    if (error%entry > 0) call raise_at(error, i + error%entry)
                    return
                end if
                values(i + 1:) = values(i + 1:) + (slope - before)*since*mean
            end associate
            deallocate (mean)
            before = slope
        end do
    end subroutine poroelastic_history

end module mdrcontact_poroelastic_history
