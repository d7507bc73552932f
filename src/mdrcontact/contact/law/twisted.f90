! SPDX-License-Identifier: GPL-3.0-or-later
!> From a contact and its coefficient of friction to the sliders of its twist about the normal, mdrcontact_law_twist: a paraboloid
!> on homogeneous bodies, of which the shape of first twist is the same under every force.
module mdrcontact_law_twisted
    use mdrcontact_contact, only: contact_t, on_unloading
    use mdrcontact_error, only: error_invalid, error_t, raise
    use mdrcontact_kinds, only: wp
    use mdrcontact_law_evaluate, only: point_at
    use mdrcontact_law_friction, only: default_sliders, find_levels, friction_law_t
    use mdrcontact_law_table, only: law_table_t
    use mdrcontact_medium_twisted_slip, only: new_twisted_slip, twisted_slip_t
    implicit none (type, external)
    private
    public :: new_twist_law

    !> Contact radii below this part of the largest make no difference.
    real(wp), parameter :: smallest_part = 0.01_wp

contains

    !> The sliders up to the end of a law.
    subroutine new_twist_law(self, by_depth, contact, coefficient, error, sliders)
        type(friction_law_t), intent(out) :: self
        !> of the contact
        type(law_table_t), intent(in) :: by_depth
        !> without adhesion
        type(contact_t), intent(in) :: contact
        !> mu > 0 [1]
        real(wp), intent(in) :: coefficient
        type(error_t), allocatable, intent(out) :: error
        !> 4 to 64; default 8
        integer, intent(in), optional :: sliders
        type(twisted_slip_t), allocatable :: slip
        real(wp) :: force, slope, radius, stiffness

        if (.not. (contact%equilibrium%medium%has_free_springs .and. contact%equilibrium%profile%paraboloid_radius > 0.0_wp)) then
            call raise(error, error_invalid, "options.twist: it is available for a paraboloid on homogeneous bodies only", "")
            return
        end if
        self%sliders = default_sliders
        if (present(sliders)) self%sliders = sliders
        call point_at(by_depth, on_unloading, by_depth%highest, force, slope, radius, stiffness)
        allocate (slip)
        call new_twisted_slip(slip, contact%equilibrium%medium, contact%equilibrium%profile, radius, 0.0_wp, error)
        if (allocated(error)) return
        self%coefficient = coefficient
        self%cubic = force/radius**3
        self%modulus = 0.1875_wp*slip%stiffness/radius**3
        self%radii = [smallest_part, 1.0_wp]*radius
        self%continued = by_depth%continued
        call find_levels(self, .false.)
        ! what verifies it takes it as made
        self%is_made = .true.
        call verify(self, slip, error)
        self%is_made = .not. allocated(error)
    end subroutine new_twist_law

    !> M after one step at constant F, compared with the contact itself: phi and M at the largest radius times the ratio of another
    !> one to it, to the powers of 1 and 4, are those of that one.
    subroutine verify(self, slip, error)
        type(friction_law_t), intent(inout) :: self
        type(twisted_slip_t), intent(in) :: slip
        type(error_t), allocatable, intent(out) :: error
        integer, parameter :: radii = 6, discs = 40
        real(wp) :: before(self%memory_size()), memory(self%memory_size()), found(3)
        real(wp) :: c, ratio, force, twist, torque, stiffness, rate
        integer :: i, j

        do i = 1, radii
            ratio = 1.0_wp - 0.11_wp*(i - 1)
            force = self%cubic*(ratio*self%radii(2))**3*(1.0_wp - 4.0_wp*epsilon(1.0_wp))
            before = 0.0_wp
            call self%advance(force, [0.0_wp, 0.0_wp, 0.0_wp], before, found, error)
            do j = 1, discs
                c = slip%radius*(1.0_wp - real(j, wp)/(discs + 1))
                if (.not. allocated(error)) call slip%at(c, slip%radius - c, twist, torque, stiffness, rate, error)
                if (allocated(error)) return
                memory = before
                call self%advance(force, [self%coefficient*twist*ratio, 0.0_wp, 0.0_wp], memory, found, error)
                self%first_shear_error = max(self%first_shear_error, &
                                             abs(found(1)/(self%coefficient*ratio**4) - torque)/slip%force)
            end do
        end do
    end subroutine verify

end module mdrcontact_law_twisted
