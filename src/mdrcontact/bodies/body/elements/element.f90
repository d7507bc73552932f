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
        !> the slowest wave in it decays as exp(-decay k z)
        real(wp) :: decay = 1.0_wp
        !> the transfer matrix of (u, w, tau/(2 G k), sigma/(2 G k)) from its bottom to its top is exp(k generator) [length]
        complex(wp) :: generator(4, 4) = 0.0_wp
        !> its fastest wave decays as exp(-fastest k z)
        real(wp) :: fastest = 1.0_wp
        !> S and s of a half-space of its material, whose waves see nothing below it
        complex(wp) :: half_space(2, 2) = 0.0_wp, half_space_across = 0.0_wp
    contains
        !> the compliance at its top in the plane, and what of it is not the half-space's, to full relative precision
        procedure(carried), deferred :: above
        procedure(carried), deferred :: reflected
        !> the same across the plane
        procedure(carried_across), deferred :: above_across
        procedure(carried_across), deferred :: reflected_across
        procedure, non_overridable :: extend
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
    end interface

contains

    !> Multiplies a power series in k of transfer matrices by its own from the right.
    pure subroutine extend(self, series)
        class(element_t), intent(in) :: self
        !> (4, 4, 0:order)
        complex(wp), intent(inout) :: series(:, :, 0:)
        complex(wp) :: power(4, 4), product(4, 4, 0:ubound(series, 3))
        integer :: i, n

        product = series
        power = 0.0_wp
        do i = 1, 4
            power(i, i) = 1.0_wp
        end do
        do n = 1, ubound(series, 3)
            power = matmul(power, self%generator)/real(n, wp)
            do i = n, ubound(series, 3)
                product(:, :, i) = product(:, :, i) + matmul(series(:, :, i - n), power)
            end do
        end do
        series = product
    end subroutine extend

end module mdrcontact_body_elements_element
