! SPDX-License-Identifier: GPL-3.0-or-later
!> The exact zeta(a) = d/g(a), theory/paper.md (4.1), for an approximate medium: that of the body solved exactly.
module mdrcontact_contact_exact_zeta
    use mdrcontact_contact_equilibrium, only: equilibrium_t, new_equilibrium
    use mdrcontact_error, only: error_invalid, error_t, raise
    use mdrcontact_kinds, only: wp
    use mdrcontact_medium_exact, only: layered_exact_t, new_exact_pair, new_layered_exact
    use mdrcontact_medium_solver, only: solver_t
    use mdrcontact_numerics_radius_law, only: new_radius_law_from_table, radius_law_t
    use mdrcontact_profile, only: profile_t
    implicit none (type, external)
    private
    public :: exact_zeta

    !> Sampled from h/1000 beyond the indenter's flat end, where the coating alone is felt, to 1000 h, where the substrate is.
    integer, parameter :: decades = 3, per_decade = 60
    !> Radii closer to the flat end, relative to its radius, are left out: d and g vanish together there.
    real(wp), parameter :: closest = 1.0e-6_wp
    !> No sample lies between this part of the way to the last radius and that radius.
    real(wp), parameter :: last_part = 0.99_wp

contains

    !> zeta(a) of an indenter on the body, or the two bodies, that an approximate medium was made from.
    subroutine exact_zeta(profile, medium, zeta, error)
        class(profile_t), intent(in) :: profile
        !> made of one body, or two, by an approximate model
        class(solver_t), intent(in) :: medium
        type(radius_law_t), allocatable, intent(out) :: zeta
        type(error_t), allocatable, intent(out) :: error
        type(layered_exact_t) :: exact
        type(equilibrium_t) :: truth
        real(wp), allocatable :: radii(:), values(:)
        real(wp) :: thickness

        call solve_exactly(medium, exact, thickness, error)
        if (.not. allocated(error)) call new_equilibrium(truth, profile, exact, error)
        if (allocated(error)) return
        radii = sampled_radii(profile%end_radius, truth%last_radius, thickness)
        if (size(radii) < 3) then
            call raise(error, error_invalid, "zeta = exact: this indenter has only one contact radius, or ends within a "// &
                       "thousandth of the coating thickness")
            return
        end if
        allocate (values(size(radii)), zeta)
        call exact%zeta(profile, radii, values, error)
        if (.not. allocated(error)) call new_radius_law_from_table(zeta, radii, "zeta", values, error)
    end subroutine exact_zeta

    !> The exact medium of this body, or of these two bodies.
    subroutine solve_exactly(medium, exact, thickness, error)
        class(solver_t), intent(in) :: medium
        type(layered_exact_t), intent(out) :: exact
        !> depth below which the bodies are homogeneous [length]
        real(wp), intent(out) :: thickness
        type(error_t), allocatable, intent(out) :: error
        type(layered_exact_t) :: lower, upper

        thickness = 0.0_wp
        if (allocated(medium%pressed)) thickness = medium%pressed%last_depth
        if (allocated(medium%counterbody)) thickness = max(thickness, medium%counterbody%last_depth)
        if (medium%is_exact .or. .not. thickness > 0.0_wp) then
            call raise(error, error_invalid, "zeta = exact: it needs a coated, layered or graded body with an approximate model")
        else if (.not. medium%is_pair) then
            call new_layered_exact(exact, medium%pressed, error)
        else if (allocated(medium%pressed) .and. allocated(medium%counterbody)) then
            call new_layered_exact(lower, medium%pressed, error)
            if (.not. allocated(error)) call new_layered_exact(upper, medium%counterbody, error)
            if (.not. allocated(error)) call new_exact_pair(exact, lower, upper, error)
        else if (allocated(medium%counterbody) .and. medium%lower_is_rigid) then
            ! the lower body is rigid
            call new_layered_exact(exact, medium%counterbody, error)
        else
            call raise(error, error_invalid, "zeta = exact: one of the two bodies is given by its modulus alone. Give its "// &
                       "materials")
        end if
    end subroutine solve_exactly

    !> Logarithmic distances from the flat end as far as the contact goes, and its last radius where it ends before.
    pure function sampled_radii(flat_end, last_radius, thickness) result(radii)
        real(wp), intent(in) :: flat_end, last_radius, thickness
        real(wp), allocatable :: radii(:)
        real(wp) :: beyond(2*decades*per_decade + 1)
        integer :: i

        beyond = thickness*[(10.0_wp**(real(i, wp)/per_decade), i=-decades*per_decade, decades*per_decade)]
        radii = flat_end + pack(beyond, beyond > closest*flat_end)
        if (last_radius >= flat_end + beyond(size(beyond))) return
        radii = pack(radii, radii - flat_end < last_part*(last_radius - flat_end))
        if (size(radii) > 0) radii = [radii, last_radius]
    end function sampled_radii

end module mdrcontact_contact_exact_zeta
