! SPDX-License-Identifier: GPL-3.0-or-later
!> From any contact on homogeneous bodies, one with adhesion too, to the sliders of a constant shear strength tau0: smooth, dry,
!> molecular contacts (Homola et al., Wear 136 (1990) 65). Springs at x carry up to b(x) = 2 tau0 sqrt(a^2 - x^2). In first shear
!>     T = 2 tau0 a^2 (y sqrt(1 - y^2) + arcsin y),  y = G_t s/(2 tau0 a) <= 1,  k_t = 2 G_t a,
!> so that T = pi a^2 tau0 in sliding (theory/friction.md (7.10)). That T makes a smaller is neglected.
module mdrcontact_law_shear_strength
    use mdrcontact_body_compliance, only: shear_load
    use mdrcontact_contact, only: contact_t, on_unloading
    use mdrcontact_error, only: check_made, check_positive, error_invalid, error_t, raise, to_text
    use mdrcontact_kinds, only: pi, wp
    use mdrcontact_law, only: contact_law_t
    use mdrcontact_law_evaluate, only: point_at
    use mdrcontact_law_friction, only: check_sliders, default_sliders, friction_law_t, find_levels
    use mdrcontact_law_from_contact, only: law_options_t, new_law_of_contact => new_contact_law
    use mdrcontact_medium_solver, only: solver_t
    implicit none (type, external)
    private
    public :: new_law_with_shear_strength

    !> Contact radii below this part of the largest make no difference.
    real(wp), parameter :: smallest_part = 0.01_wp

contains

    !> The law of a contact of constant shear strength: F(d) and all that belongs to it, and its sliders.
    subroutine new_law_with_shear_strength(self, contact, largest_depth, shear_strength, error, options, sliders)
        type(contact_law_t), intent(out) :: self
        !> on homogeneous bodies, with or without adhesion
        type(contact_t), intent(in) :: contact
        !> > 0 [length]
        real(wp), intent(in) :: largest_depth
        !> tau0 > 0 [modulus]
        real(wp), intent(in) :: shear_strength
        type(error_t), allocatable, intent(out) :: error
        type(law_options_t), intent(in), optional :: options
        !> 4 to 64 vector sliders for the springs of the contact; default 8
        integer, intent(in), optional :: sliders

        call check_made(error, "contact", contact%is_made)
        call check_positive(error, "shear_strength", shear_strength)
        if (present(sliders)) call check_sliders(error, sliders)
        if (allocated(error)) return
        if (.not. contact%equilibrium%medium%has_free_springs) then
            call raise(error, error_invalid, " = "//to_text(shear_strength)//": it is available on homogeneous bodies only", &
                       "shear_strength")
            return
        end if
        call new_law_of_contact(self, contact, largest_depth, error, options)
        if (allocated(error)) return
        allocate (self%friction)
        self%friction%shear_strength = shear_strength
        self%friction%sliders = default_sliders
        if (present(sliders)) self%friction%sliders = sliders
        call find_sliders(self, contact, self%friction, error)
        ! what verifies it takes it as made
        self%friction%is_made = .not. allocated(error)
        if (.not. allocated(error)) call verify(self%friction, error)
        self%is_made = .not. allocated(error)
    end subroutine new_law_with_shear_strength

    !> Radii, modulus and levels.
    subroutine find_sliders(law, contact, friction, error)
        type(contact_law_t), intent(in) :: law
        type(contact_t), intent(in) :: contact
        type(friction_law_t), intent(inout) :: friction
        type(error_t), allocatable, intent(out) :: error
        class(solver_t), allocatable :: tangential
        real(wp) :: force, slope, radius, stiffness, modulus(1)

        call contact%equilibrium%medium%for_load(shear_load, tangential, error)
        if (allocated(error)) return
        call point_at(law%by_depth, on_unloading, law%by_depth%highest, force, slope, radius, stiffness)
        call tangential%modulus([radius], modulus, error)
        if (allocated(error)) return
        friction%modulus = modulus(1)
        friction%radii = [smallest_part, 1.0_wp]*radius
        friction%continued = law%by_depth%continued
        call find_levels(friction, .false.)
    end subroutine find_sliders

    !> T after one step at constant radius against the closed form.
    subroutine verify(friction, error)
        type(friction_law_t), intent(inout) :: friction
        type(error_t), allocatable, intent(out) :: error
        integer, parameter :: radii = 8, shifts = 40
        real(wp) :: memory(friction%memory_size()), before(friction%memory_size()), radius, y, limit, traction(3)
        integer :: i, j

        do i = 1, radii
            radius = friction%radii(2)*(1.0_wp - 0.08_wp*(i - 1))
            limit = pi*radius**2*friction%shear_strength
            before = 0.0_wp
            call friction%advance(radius, [0.0_wp, 0.0_wp, 0.0_wp], before, traction, error)
            do j = 1, shifts
                if (allocated(error)) return
                y = real(j, wp)/shifts
                memory = before
                call friction%advance(radius, [2.0_wp*friction%shear_strength*radius*y/friction%modulus, 0.0_wp, 0.0_wp], memory, &
                                      traction, error)
                friction%first_shear_error = max(friction%first_shear_error, &
                                                 abs(traction(1)/limit - 2.0_wp*(y*sqrt(1.0_wp - y**2) + asin(y))/pi))
            end do
        end do
    end subroutine verify

end module mdrcontact_law_shear_strength
