! SPDX-License-Identifier: GPL-3.0-or-later
!> The quantity that a machine controls: s = depth_weight d + force_weight F. Depth (1, 0), force (0, 1), or the far end of a spring
!> of stiffness K that presses the indenter (1, 1/K).
module mdrcontact_contact_control
    use mdrcontact_kinds, only: wp
    implicit none (type, external)
    private
    public :: control_t, depth_control, force_control

    !> The quantity that the machine prescribes: s = depth_weight d + force_weight F.
    type :: control_t
        !> [1], or [modulus length] where s is a force
        real(wp) :: depth_weight = 1.0_wp
        !> [length^-1 modulus^-1], or [1] where s is a force
        real(wp) :: force_weight = 0.0_wp
    contains
        procedure :: of
        procedure :: distance
    end type control_t

    !> The machine prescribes the indentation depth.
    type(control_t), parameter :: depth_control = control_t(1.0_wp, 0.0_wp)
    !> The machine prescribes the normal force.
    type(control_t), parameter :: force_control = control_t(0.0_wp, 1.0_wp)

contains

    !> s of a state.
    elemental function of(self, depth, force) result(s)
        class(control_t), intent(in) :: self
        !> d [length], F [modulus length^2]
        real(wp), intent(in) :: depth, force
        real(wp) :: s

        s = self%depth_weight*depth + self%force_weight*force
    end function of

    !> Distance of a state from a given s: s - offset, or ln(s/offset).
    elemental function distance(self, depth, force, offset, is_logarithmic) result(y)
        class(control_t), intent(in) :: self
        !> d [length], F [modulus length^2], the given s
        real(wp), intent(in) :: depth, force, offset
        !> offset > 0; s is taken for positive
        logical, intent(in) :: is_logarithmic
        real(wp) :: y

        y = self%of(depth, force)
        if (is_logarithmic) then
            y = log(max(y, tiny(y))/offset)
        else
            y = y - offset
        end if
    end function distance

end module mdrcontact_contact_control
