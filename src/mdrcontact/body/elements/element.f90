! SPDX-License-Identifier: GPL-3.0-or-later
!> An element of a body: a layer, or what lies between two. It carries the compliance of what lies below it to its top.
!>
!> In the plane of a wave (u, w) = S (tau, sigma)/(2 G k) with the amplitudes of displacement and stress, z down, and G the shear
!> modulus of the body's surface: S is negative definite. Across it v = -s tau/(G k).
module mdrcontact_body_elements_element
    use mdrcontact_kinds, only: wp
    implicit none (type, external)
    private
    public :: element_t

    !> An element at one Laplace variable.
    type, abstract :: element_t
        !> h [length]
        real(wp) :: thickness = 0.0_wp
        !> S and s of a half-space of its material, whose waves see nothing below it
        complex(wp) :: half_space(2, 2) = 0.0_wp, half_space_across = 0.0_wp
    contains
        !> the compliance at its top in the plane, and what of it is not the half-space's, to full relative precision
        procedure(carried), deferred :: above
        procedure(carried), deferred :: reflected
        !> the same across the plane
        procedure(carried_across), deferred :: above_across
        procedure(carried_across), deferred :: reflected_across
        !> multiplies a power series in k of transfer matrices of (u, w, tau/(2 G k), sigma/(2 G k)) by its own from the right
        procedure(multiplied), deferred :: extend
    end type element_t

    abstract interface
        pure function carried(self, k, below) result(above)
            import :: element_t, wp
            class(element_t), intent(in) :: self
            complex(wp), intent(in) :: k
            !> S at its bottom
            complex(wp), intent(in) :: below(2, 2)
            complex(wp) :: above(2, 2)
        end function carried

        pure function carried_across(self, k, below) result(above)
            import :: element_t, wp
            class(element_t), intent(in) :: self
            complex(wp), intent(in) :: k
            !> s at its bottom
            complex(wp), intent(in) :: below
            complex(wp) :: above
        end function carried_across

        pure subroutine multiplied(self, series)
            import :: element_t, wp
            class(element_t), intent(in) :: self
            !> (4, 4, 0:order)
            complex(wp), intent(inout) :: series(:, :, 0:)
        end subroutine multiplied
    end interface

end module mdrcontact_body_elements_element
