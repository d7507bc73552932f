! SPDX-License-Identifier: GPL-3.0-or-later
!> A body as its surface answers to shear instead of normal load, so that whatever is known of normal contact serves for shear
!>: the axisymmetric
!> part of the displacement along a traction of one direction.
!>
!>     k S = (2/G0*)(1 + chi_t),   G0* = 4 G0/(2 - nu0),   chi_t = [(1 - nu0) chi_L + chi_T]/(2 - nu0)
!> takes the place of k C = (2/E0*)(1 + chi): chi_L is shear in the plane of the wave, chi_T shear across it.
module mdrcontact_body_sheared
    use mdrcontact_body, only: body_t
    use mdrcontact_body_layers, only: layers_t
    use mdrcontact_kinds, only: wp
    use mdrcontact_material, only: material_t
    implicit none (type, external)
    private
    public :: sheared_body_t, new_sheared_body, new_twisted_body

    !> Another body under shear.
    type, extends(body_t) :: sheared_body_t
        private
        class(body_t), allocatable :: body
        !> parts of chi_L and chi_T in the response, together 1
        real(wp) :: in_plane_part = 0.0_wp, anti_plane_part = 0.0_wp
        real(wp) :: modulus = 0.0_wp
    contains
        procedure :: response
        procedure :: in_plane_response
        procedure :: anti_plane_response
        procedure :: surface_material
        procedure :: shear_limits
        procedure :: surface_modulus
        procedure :: long_wave_limit
        procedure :: first_depth
        procedure :: last_depth
        procedure :: ratios
        procedure :: sublayers
        procedure :: is_graded
    end type sheared_body_t

contains

    !> The body under a traction of one direction along its surface.
    subroutine new_sheared_body(self, body)
        type(sheared_body_t), intent(out) :: self
        class(body_t), intent(in) :: body
        type(material_t) :: surface

        surface = body%surface_material()
        allocate (self%body, source=body)
        self%anti_plane_part = 1.0_wp/(2.0_wp - surface%poisson)
        self%in_plane_part = (1.0_wp - surface%poisson)/(2.0_wp - surface%poisson)
        self%modulus = surface%tangential()
    end subroutine new_sheared_body

    !> The body under a traction around an axis: shear across the plane alone, and 4 G0 in place of the modulus.
    pure subroutine new_twisted_body(self, body)
        type(sheared_body_t), intent(out) :: self
        class(body_t), intent(in) :: body
        type(material_t) :: surface

        surface = body%surface_material()
        allocate (self%body, source=body)
        self%anti_plane_part = 1.0_wp
        self%modulus = 4.0_wp*surface%shear()
    end subroutine new_twisted_body

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

    pure function surface_material(self) result(material)
        class(sheared_body_t), intent(in) :: self
        type(material_t) :: material

        material = self%body%surface_material()
    end function surface_material

    pure subroutine shear_limits(self, in_plane, anti_plane)
        class(sheared_body_t), intent(in) :: self
        real(wp), intent(out) :: in_plane, anti_plane

        call self%body%shear_limits(in_plane, anti_plane)
    end subroutine shear_limits

    pure function surface_modulus(self) result(value)
        class(sheared_body_t), intent(in) :: self
        real(wp) :: value

        value = self%modulus
    end function surface_modulus

    pure function long_wave_limit(self) result(value)
        class(sheared_body_t), intent(in) :: self
        real(wp) :: value
        real(wp) :: in_plane, anti_plane

        call self%body%shear_limits(in_plane, anti_plane)
        value = self%in_plane_part*in_plane + self%anti_plane_part*anti_plane
    end function long_wave_limit

    pure function first_depth(self) result(value)
        class(sheared_body_t), intent(in) :: self
        real(wp) :: value

        value = self%body%first_depth()
    end function first_depth

    pure function last_depth(self) result(value)
        class(sheared_body_t), intent(in) :: self
        real(wp) :: value

        value = self%body%last_depth()
    end function last_depth

    !> None: the kernels of a body under shear and under normal load are not kept together.
    pure function ratios(self) result(values)
        class(sheared_body_t), intent(in) :: self
        real(wp), allocatable :: values(:)

        associate (unused => self)
        end associate
        values = [real(wp) ::]
    end function ratios

    pure subroutine sublayers(self, unit, ratio, depths, layers)
        class(sheared_body_t), intent(in) :: self
        real(wp), intent(in) :: unit, ratio, depths(:)
        type(layers_t), intent(out) :: layers

        call self%body%sublayers(unit, ratio, depths, layers)
    end subroutine sublayers

    pure function is_graded(self) result(answer)
        class(sheared_body_t), intent(in) :: self
        logical :: answer

        answer = self%body%is_graded()
    end function is_graded

end module mdrcontact_body_sheared
