! SPDX-License-Identifier: GPL-3.0-or-later
!> What is pressed: an elastic half-space whose constants vary with depth, as far as its surface shows it (theory 6).
!>
!> A body answers with its surface compliance in Hankel space: u(k) = C(k) p(k), k C(k) = (2/E0*) sigma(k), sigma = 1 + chi.
!> sigma is the compliance relative to a half-space of the surface material; chi vanishes for short waves, which
!> do not reach beyond that material. Both are analytic in a sector around the positive k axis and are needed there. The same holds
!> for its compliances under shear, in the plane of the wave and across it.
!> Concrete bodies are made by their `new_...` procedures, keep their materials and never change afterwards.
module mdrcontact_body
    use mdrcontact_body_layers, only: layers_t
    use mdrcontact_error, only: check_memory, error_t
    use mdrcontact_kinds, only: wp
    use mdrcontact_material, only: material_t
    implicit none (type, external)
    private
    public :: body_t

    !> A body of which media are made: by a model (mdrcontact_model), or by its exact compliance. Its numbers are to be read only.
    type, abstract :: body_t
        !> E [modulus] and nu at the surface
        type(material_t) :: surface_material
        !> E0*, the contact modulus of the surface material [modulus]
        real(wp) :: surface_modulus = 0.0_wp
        !> sigma(0) = E0*/E1* with the contact modulus E1* of the substrate; 0 on a rigid base [1]
        real(wp) :: long_wave_limit = 0.0_wp
        !> the same under shear in the plane of the wave, and across it [1]
        real(wp) :: in_plane_limit = 0.0_wp, anti_plane_limit = 0.0_wp
        !> depth of the first interface, 0 if the body is homogeneous, and that below which it is homogeneous, or rigid [length]
        real(wp) :: first_depth = 0.0_wp, last_depth = 0.0_wp
        !> the smallest and the largest Young's modulus in it, 0 where they are not known [modulus]
        real(wp) :: softest = 0.0_wp, stiffest = 0.0_wp
        !> whether the constants vary with depth: sublayers() refuses it
        logical :: is_graded = .false.
    contains
        !> sigma(k) and chi(k) = sigma(k) - 1, each to full relative precision as far as it is known
        procedure(response_at), deferred :: response
        !> the two at several wavenumbers
        procedure :: responses
        !> the same two for the compliance under shear in the plane of the wave, k C_L = ((1 - nu0)/G0) sigma, and across it,
        !> k C_T = (1/G0) sigma
        procedure(response_at), deferred :: in_plane_response
        !> see in_plane_response
        procedure(response_at), deferred :: anti_plane_response
        !> numbers without a unit that determine the body but for its size and stiffness; none if that takes too many, or where
        !> kernels are not kept
        procedure :: ratios => none
        !> the homogeneous layers of a body, for stresses inside
        procedure(sublayers_at), deferred :: sublayers
        !> a copy, or error_memory; those with arrays that grow with a caller's data override it
        procedure :: copy_to
        !> makes the numbers that every body has those of another one
        procedure, non_overridable :: take_numbers
    end type body_t

    abstract interface
        pure subroutine response_at(self, k, sigma, chi)
            import :: body_t, wp
            class(body_t), intent(in) :: self
            !> wavenumber, real part > 0, argument within the sector of analyticity [1/length]
            complex(wp), intent(in) :: k
            complex(wp), intent(out) :: sigma, chi
        end subroutine response_at

        pure subroutine sublayers_at(self, layers, error)
            import :: body_t, error_t, layers_t
            class(body_t), intent(in) :: self
            type(layers_t), intent(out) :: layers
            type(error_t), allocatable, intent(inout) :: error
        end subroutine sublayers_at
    end interface

contains

    !> `response` at each of several wavenumbers. A body may keep what it finds for another one: this is not pure.
    subroutine responses(self, k, sigma, chi)
        class(body_t), intent(in) :: self
        !> wavenumbers [1/length]
        complex(wp), intent(in) :: k(:)
        !> same size as k
        complex(wp), intent(out) :: sigma(:), chi(:)
        integer :: i

        do i = 1, size(k)
            call self%response(k(i), sigma(i), chi(i))
        end do
    end subroutine responses

    pure subroutine none(self, values, error)
        class(body_t), intent(in) :: self
        !> numbers without a unit, or none
        real(wp), allocatable, intent(out) :: values(:)
        type(error_t), allocatable, intent(inout) :: error

        associate (unused => self, also_unused => error)
        end associate
        allocate (values(0))
    end subroutine none

    subroutine copy_to(self, copy, error)
        class(body_t), intent(in) :: self
        class(body_t), allocatable, intent(out) :: copy
        type(error_t), allocatable, intent(inout) :: error
        integer :: stat

        if (allocated(error)) return
        allocate (copy, source=self, stat=stat)
        call check_memory(error, stat)
    end subroutine copy_to

    pure subroutine take_numbers(self, other)
        class(body_t), intent(inout) :: self
        class(body_t), intent(in) :: other

        self%surface_material = other%surface_material
        self%surface_modulus = other%surface_modulus
        self%long_wave_limit = other%long_wave_limit
        self%in_plane_limit = other%in_plane_limit
        self%anti_plane_limit = other%anti_plane_limit
        self%first_depth = other%first_depth
        self%last_depth = other%last_depth
        self%softest = other%softest
        self%stiffest = other%stiffest
        self%is_graded = other%is_graded
    end subroutine take_numbers

end module mdrcontact_body
