! SPDX-License-Identifier: GPL-3.0-or-later
!> A body as its surface answers to shear instead of normal load, so that whatever is known of normal contact serves for shear:
!> the axisymmetric part of the displacement along a traction of one direction.
!>
!>     k S = (2/G0*)(1 + chi_t),   G0* = 4 G0/(2 - nu0),   chi_t = [(1 - nu0) chi_L + chi_T]/(2 - nu0)
!> takes the place of k C = (2/E0*)(1 + chi): chi_L is shear in the plane of the wave, chi_T shear across it.
module mdrcontact_body_sheared
    use mdrcontact_body, only: body_t
    use mdrcontact_body_layers, only: layers_t
    use mdrcontact_error, only: error_t
    use mdrcontact_kinds, only: wp
    implicit none (type, external)
    private
    public :: sheared_body_t, new_sheared_body, new_twisted_body

    !> Another body under shear.
    type, extends(body_t) :: sheared_body_t
        private
        class(body_t), allocatable :: body
        !> parts of chi_L and chi_T in the response, together 1
        real(wp) :: in_plane_part = 0.0_wp, anti_plane_part = 0.0_wp
    contains
        procedure :: response
        procedure :: in_plane_response
        procedure :: anti_plane_response
        procedure :: sublayers
        procedure :: copy_to
    end type sheared_body_t

contains

    !> The body under a traction of one direction along its surface.
    subroutine new_sheared_body(self, body, error)
        type(sheared_body_t), intent(out) :: self
        class(body_t), intent(in) :: body
        type(error_t), allocatable, intent(inout) :: error

        associate (nu => body%surface_material%poisson)
            call shear(self, body, (1.0_wp - nu)/(2.0_wp - nu), 1.0_wp/(2.0_wp - nu), body%surface_material%tangential(), error)
        end associate
    end subroutine new_sheared_body

    !> The body under a traction around an axis: shear across the plane alone, and 4 G0 in place of the modulus.
    subroutine new_twisted_body(self, body, error)
        type(sheared_body_t), intent(out) :: self
        class(body_t), intent(in) :: body
        type(error_t), allocatable, intent(inout) :: error

        call shear(self, body, 0.0_wp, 1.0_wp, 4.0_wp*body%surface_material%shear(), error)
    end subroutine new_twisted_body

    subroutine shear(self, body, in_plane_part, anti_plane_part, modulus, error)
        type(sheared_body_t), intent(inout) :: self
        class(body_t), intent(in) :: body
        real(wp), intent(in) :: in_plane_part, anti_plane_part, modulus
        type(error_t), allocatable, intent(inout) :: error

        call body%copy_to(self%body, error)
        self%in_plane_part = in_plane_part
        self%anti_plane_part = anti_plane_part
        call self%take_numbers(body)
        self%surface_modulus = modulus
        self%long_wave_limit = in_plane_part*body%in_plane_limit + anti_plane_part*body%anti_plane_limit
    end subroutine shear

    subroutine copy_to(self, copy, error)
        class(sheared_body_t), intent(in) :: self
        class(body_t), allocatable, intent(out) :: copy
        type(error_t), allocatable, intent(inout) :: error
        type(sheared_body_t), allocatable :: own

        allocate (own)
        call shear(own, self%body, self%in_plane_part, self%anti_plane_part, self%surface_modulus, error)
        call move_alloc(own, copy)
    end subroutine copy_to

    pure subroutine response(self, k, sigma, chi)
        class(sheared_body_t), intent(in) :: self
        complex(wp), intent(in) :: k
        complex(wp), intent(out) :: sigma, chi
        complex(wp) :: in_plane_sigma, in_plane_chi

        call self%body%anti_plane_response(k, sigma, chi)
        call self%body%in_plane_response(k, in_plane_sigma, in_plane_chi)
        sigma = self%in_plane_part*in_plane_sigma + self%anti_plane_part*sigma
        chi = self%in_plane_part*in_plane_chi + self%anti_plane_part*chi
    end subroutine response

    pure subroutine in_plane_response(self, k, sigma, chi)
        class(sheared_body_t), intent(in) :: self
        complex(wp), intent(in) :: k
        complex(wp), intent(out) :: sigma, chi

        call self%body%in_plane_response(k, sigma, chi)
    end subroutine in_plane_response

    pure subroutine anti_plane_response(self, k, sigma, chi)
        class(sheared_body_t), intent(in) :: self
        complex(wp), intent(in) :: k
        complex(wp), intent(out) :: sigma, chi

        call self%body%anti_plane_response(k, sigma, chi)
    end subroutine anti_plane_response

    pure subroutine sublayers(self, layers, error)
        class(sheared_body_t), intent(in) :: self
        type(layers_t), intent(out) :: layers
        type(error_t), allocatable, intent(inout) :: error

        call self%body%sublayers(layers, error)
    end subroutine sublayers

end module mdrcontact_body_sheared
