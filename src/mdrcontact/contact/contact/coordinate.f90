! SPDX-License-Identifier: GPL-3.0-or-later
!> The coordinate x of a contact radius in which the laws of every shape are smooth and close to straight lines.
!>
!> x = ln(a - b) behind a flat end of radius b. Towards the sharp end of an imprint, radius A, depth and force go as
!> s = sqrt(1 - (a/A)^2): there a = A sin(e^x/A), in which s is analytic, and which is e^x far below A (theory/plastic.md (3.7)).
module mdrcontact_contact_coordinate
    use mdrcontact_kinds, only: half_pi, wp
    use mdrcontact_profile, only: profile_t
    implicit none (type, external)
    private
    public :: coordinate_t, coordinate_under

    !> Of an indenter.
    type :: coordinate_t
        !> b and A [length]; 0: none
        real(wp) :: end_radius = 0.0_wp, sharp_radius = 0.0_wp
    contains
        procedure :: radius
        procedure :: of
        procedure :: rate
    end type coordinate_t

contains

    !> The coordinate of contacts under an indenter.
    pure function coordinate_under(profile) result(self)
        class(profile_t), intent(in) :: profile
        type(coordinate_t) :: self

        self%end_radius = profile%end_radius
        self%sharp_radius = profile%sharp_radius
    end function coordinate_under

    !> a(x) [length].
    elemental function radius(self, x) result(a)
        class(coordinate_t), intent(in) :: self
        real(wp), intent(in) :: x
        real(wp) :: a

        if (self%sharp_radius > 0.0_wp) then
            a = self%sharp_radius*sin(min(exp(x)/self%sharp_radius, half_pi))
        else
            a = self%end_radius + exp(x)
        end if
    end function radius

    !> x(a).
    elemental function of(self, a) result(x)
        class(coordinate_t), intent(in) :: self
        !> [length]
        real(wp), intent(in) :: a
        real(wp) :: x

        if (self%sharp_radius > 0.0_wp) then
            x = log(max(self%sharp_radius*asin(min(a/self%sharp_radius, 1.0_wp)), tiny(1.0_wp)))
        else
            x = log(max(a - self%end_radius, tiny(1.0_wp)))
        end if
    end function of

    !> da/dx at a radius [length].
    elemental function rate(self, a)
        class(coordinate_t), intent(in) :: self
        !> [length]
        real(wp), intent(in) :: a
        real(wp) :: rate

        if (self%sharp_radius > 0.0_wp) then
            rate = self%sharp_radius*asin(min(a/self%sharp_radius, 1.0_wp)) &
                   *sqrt(max(self%sharp_radius - a, 0.0_wp)/self%sharp_radius*(1.0_wp + a/self%sharp_radius))
        else
            rate = a - self%end_radius
        end if
    end function rate

end module mdrcontact_contact_coordinate
