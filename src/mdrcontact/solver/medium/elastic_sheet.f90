! SPDX-License-Identifier: GPL-3.0-or-later
!> A body whose surface carries a sheet that is stiff in its plane (theory/surfaces.md (5.3), (5.4)): short waves still meet
!> springs, those of a surface that cannot move sideways, and its states are those of a body with that compliance.
module mdrcontact_medium_elastic_sheet
    use mdrcontact_body, only: body_t, copy
    use mdrcontact_body_compliance, only: compliance_t, normal_load
    use mdrcontact_error, only: error_t
    use mdrcontact_kinds, only: wp
    use mdrcontact_line_shared, only: kernel_cache_t
    use mdrcontact_medium_exact, only: layered_exact_t, new_layered_exact
    use mdrcontact_medium_load, only: load_t
    use mdrcontact_medium_solver, only: solved_t, solver_t
    use mdrcontact_profile, only: profile_t
    use mdrcontact_body_membrane, only: membrane_t, new_membrane
    use mdrcontact_tension_surface, only: check_surface, surface_t
    implicit none (type, external)
    private
    public :: elastic_sheet_t, new_elastic_sheet

    !> Contact radii up to this many lengths of the sheet: what it adds falls, and the work of finding it grows.
    real(wp), parameter :: most_lengths = 1.0e3_wp

    !> A body under such a sheet.
    type, extends(solver_t) :: elastic_sheet_t
        private
        type(layered_exact_t) :: exact
    contains
        procedure :: modulus
        procedure :: solve
        procedure :: load => new_load
    end type elastic_sheet_t

contains

    !> A body under a sheet with neither tension nor bending stiffness.
    subroutine new_elastic_sheet(self, body, surface, tolerance, error, shared)
        type(elastic_sheet_t), intent(out) :: self
        !> copied
        class(body_t), intent(in) :: body
        !> K_m > 0
        type(surface_t), intent(in) :: surface
        !> relative, of E_eff, d and F, 1e-12 to 1e-2
        real(wp), intent(in) :: tolerance
        type(error_t), allocatable, intent(inout) :: error
        !> data shared with media created before, which make this one cheaper
        type(kernel_cache_t), intent(inout), optional :: shared
        class(compliance_t), allocatable :: compliance
        type(membrane_t) :: membrane

        call check_surface(surface, error)
        if (.not. allocated(error)) call body%compliance(normal_load, compliance, error)
        if (.not. allocated(error)) call new_membrane(membrane, surface%stretching, compliance, error, has_springs=.true.)
        if (.not. allocated(error)) call new_layered_exact(self%exact, membrane, error, tolerance, shared)
        if (allocated(error)) return
        ! without its springs, which are nearly singular at the edge
        self%largest_radius = self%exact%largest_radius
        self%surface_contrast = self%exact%surface_contrast
        self%is_exact = .true.
        self%is_modulus_formula = .false.
        self%sheet = surface
        if (body%last_depth > 0.0_wp) self%largest_radius = self%largest_radius*(body%last_depth/membrane%last_depth)
        if (membrane%excess > 0.0_wp .and. most_lengths*membrane%length < self%largest_radius) then
            self%largest_radius = most_lengths*membrane%length
            self%why_it_ends = ". Beyond 1000 lengths 2 K_m/E* the sheet contributes less than 0.2 %: omit it"
        end if
        call copy(body, self%pressed, error)
        self%is_made = .not. allocated(error)
    end subroutine new_elastic_sheet

    subroutine modulus(self, a, values, error, slopes)
        class(elastic_sheet_t), intent(in) :: self
        real(wp), intent(in) :: a(:)
        real(wp), intent(out) :: values(:)
        type(error_t), allocatable, intent(out) :: error
        real(wp), intent(out), optional :: slopes(:)

        call self%exact%modulus(a, values, error, slopes)
    end subroutine modulus

    subroutine solve(self, profile, a, solved, error, adhesive, accuracy, series)
        class(elastic_sheet_t), intent(in) :: self
        class(profile_t), intent(in) :: profile
        real(wp), intent(in) :: a
        type(solved_t), intent(out) :: solved
        type(error_t), allocatable, intent(out) :: error
        logical, intent(in), optional :: adhesive
        real(wp), intent(inout), optional :: accuracy
        real(wp), allocatable, intent(out), optional :: series(:, :)

        if (present(series)) continue
        call self%exact%solve(profile, a, solved, error, adhesive, accuracy)
    end subroutine solve

    !> The sheet hands on to the body what is not part of it.
    subroutine new_load(self, profile, a, punch_depth, load, error)
        class(elastic_sheet_t), intent(in), target :: self
        class(profile_t), intent(in), target :: profile
        real(wp), intent(in) :: a, punch_depth
        class(load_t), allocatable, intent(out) :: load
        type(error_t), allocatable, intent(out) :: error

        call self%exact%load(profile, a, punch_depth, load, error)
        if (.not. allocated(error)) load%is_complete = .false.
    end subroutine new_load

end module mdrcontact_medium_elastic_sheet
