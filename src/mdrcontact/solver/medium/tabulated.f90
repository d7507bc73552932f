! SPDX-License-Identifier: GPL-3.0-or-later
!> The user's own effective modulus E_eff(a): a table or a function (theory/paper.md (3.1)).
module mdrcontact_medium_tabulated
    use, intrinsic :: iso_fortran_env, only: int64
    use mdrcontact_error, only: error_t
    use mdrcontact_kinds, only: wp
    use mdrcontact_medium_effective, only: effective_medium_t
    use mdrcontact_numerics_radius_law, only: interpolation_roughness, new_radius_law_from_function, &
                                                new_radius_law_from_table, radius_law_t
    use mdrcontact_numerics_scalar_function, only: scalar_function_t
    implicit none (type, external)
    private
    public :: tabulated_medium_t, new_tabulated_medium, new_medium_from_function

    !> E_eff(a) between two radii. States are offered between them; below the smaller one, where every contact
    !> begins, the modulus is taken as constant.
    type, extends(effective_medium_t) :: tabulated_medium_t
        private
        type(radius_law_t) :: law
    contains
        procedure :: effective_modulus
        procedure :: effective_modulus_slope
        procedure :: add_breaks
        procedure :: bytes
    end type tabulated_medium_t

    real(wp), parameter :: sampling_tolerance = 1.0e-13_wp

contains

    !> E_eff(a) through the points of a table, interpolated in ln a without overshoot (Steffen).
    subroutine new_tabulated_medium(self, radius, moduli, error)
        type(tabulated_medium_t), intent(out) :: self
        !> ascending contact radii > 0, at least 3 [length]
        real(wp), intent(in) :: radius(:)
        !> E_eff > 0, same size [modulus]
        real(wp), intent(in) :: moduli(:)
        type(error_t), allocatable, intent(out) :: error

        call new_radius_law_from_table(self%law, radius, "moduli", moduli, error)
        if (.not. allocated(error)) call take_range(self)
        self%is_made = .not. allocated(error)
    end subroutine new_tabulated_medium

    !> E_eff(a) by a function, which is called here and never again.
    subroutine new_medium_from_function(self, modulus, smallest_radius, largest_radius, error, accuracy, smooth)
        type(tabulated_medium_t), intent(out) :: self
        !> E_eff(a) > 0, smooth: peaks narrower than 0.5 % of the radius may be missed [modulus]
        class(scalar_function_t), intent(inout), target :: modulus
        !> 0 < smallest_radius < largest_radius: between them the function is sampled and states are offered [length]
        real(wp), intent(in) :: smallest_radius, largest_radius
        type(error_t), allocatable, intent(out) :: error
        !> relative, of the function's values; default 1e-13
        real(wp), intent(in), optional :: accuracy
        !> whether it is known to vary on the scale of its argument alone, so that fewer comparisons do; default false
        logical, intent(in), optional :: smooth
        real(wp) :: tolerance
        logical :: everywhere

        everywhere = .true.
        if (present(smooth)) everywhere = .not. smooth
        tolerance = sampling_tolerance
        if (present(accuracy)) tolerance = accuracy
        call new_radius_law_from_function(self%law, modulus, "the modulus", smallest_radius, largest_radius, tolerance, error, &
                                          everywhere=everywhere)
        if (.not. allocated(error)) call take_range(self)
        self%is_made = .not. allocated(error)
    end subroutine new_medium_from_function

    pure subroutine take_range(self)
        type(tabulated_medium_t), intent(inout) :: self

        self%smallest_radius = self%law%smallest_radius
        self%largest_radius = self%law%largest_radius
        self%roughness = interpolation_roughness
    end subroutine take_range

    pure recursive function bytes(self)
        class(tabulated_medium_t), intent(in) :: self
        integer(int64) :: bytes

        bytes = self%law%bytes()
        if (allocated(self%pressed)) bytes = bytes + self%pressed%bytes()
    end function bytes

    elemental function effective_modulus(self, a) result(value)
        class(tabulated_medium_t), intent(in) :: self
        real(wp), intent(in) :: a
        real(wp) :: value

        value = self%law%at(a)
    end function effective_modulus

    elemental function effective_modulus_slope(self, a) result(value)
        class(tabulated_medium_t), intent(in) :: self
        real(wp), intent(in) :: a
        real(wp) :: value

        value = self%law%slope_at(a)
    end function effective_modulus_slope

    pure subroutine add_breaks(self, radii, error)
        class(tabulated_medium_t), intent(in) :: self
        real(wp), allocatable, intent(inout) :: radii(:)
        type(error_t), allocatable, intent(inout) :: error

        call self%law%add_breaks(radii, error)
    end subroutine add_breaks

end module mdrcontact_medium_tabulated
