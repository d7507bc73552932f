! SPDX-License-Identifier: GPL-3.0-or-later
!> The indented body: an elastic half-space whose constants vary with depth.
!>
!> Its surface responds to a load with its compliance in Hankel space (mdrcontact_body_compliance, theory/exact.md (1.1)).
!> Concrete bodies are made by their `new_...` procedures, keep their materials and never change afterwards.
module mdrcontact_body
    use mdrcontact_object, only: object_t, room
    use mdrcontact_parameter, only: parameter_t
    use mdrcontact_body_compliance, only: compliance_t
    use mdrcontact_body_layers, only: layers_t
    use mdrcontact_error, only: check_made, error_t
    use mdrcontact_kinds, only: wp
    use mdrcontact_material, only: material_t
    implicit none (type, external)
    private
    public :: body_t, copy

    !> A body of which media are made: by a model (mdrcontact_model), or by its exact compliance. Its numbers must only be read.
    type, abstract, extends(object_t) :: body_t
        !> E [modulus] and nu at the surface
        type(material_t) :: surface_material
        !> E0*, the contact modulus of the surface material [modulus]
        real(wp) :: surface_modulus = 0.0_wp
        !> one_plus_chi(0) = E0*/E1* with the contact modulus E1* of the substrate; 0 on a rigid base [1]
        real(wp) :: long_wave_limit = 0.0_wp
        !> depth of the first interface, 0 if the body is homogeneous, and that below which it is homogeneous, or rigid [length]
        real(wp) :: first_depth = 0.0_wp, last_depth = 0.0_wp
        !> the smallest and the largest Young's modulus in it, 0 where they are not known [modulus]
        real(wp) :: softest = 0.0_wp, stiffest = 0.0_wp
        !> whether the constants vary continuously with depth: it has no layers
        logical :: is_graded = .false.
        !> whether the whole body is isotropic, bonded and free of stress
        logical :: is_plain = .true.
        !> whether a layer slides on what lies below it: an endless sheet, which opposes nothing to a traction along the surface
        logical :: slides = .false.
    contains
        !> the compliance of its surface under a load
        procedure(compliance_under), deferred :: compliance
        !> the homogeneous layers of a body, for stresses inside
        procedure(sublayers_at), deferred :: sublayers
        !> G and nu at a depth
        procedure(moduli_at), deferred :: moduli
        !> depths between which they are analytic
        procedure(breaks_of), deferred :: add_breaks
        !> its numbers, top to bottom; none of what is not made of a few
        procedure :: parameters
        !> the same kind of body with other numbers
        procedure :: with_parameters
    end type body_t

    !> A copy of a body, after a trial of the memory that it takes.
    interface copy
        module procedure copy_body
    end interface copy

    abstract interface
        subroutine compliance_under(self, load, compliance, error)
            import :: body_t, compliance_t, error_t
            class(body_t), intent(in) :: self
            !> normal_load, shear_load or twist_load
            integer, intent(in) :: load
            class(compliance_t), allocatable, intent(out) :: compliance
            type(error_t), allocatable, intent(inout) :: error
        end subroutine compliance_under

        pure subroutine sublayers_at(self, layers, error)
            import :: body_t, error_t, layers_t
            class(body_t), intent(in) :: self
            type(layers_t), intent(out) :: layers
            type(error_t), allocatable, intent(inout) :: error
        end subroutine sublayers_at

        pure subroutine moduli_at(self, z, shear, poisson)
            import :: body_t, wp
            class(body_t), intent(in) :: self
            !> depth, at least 0 [length]
            real(wp), intent(in) :: z
            !> G [modulus] and nu [1] there
            real(wp), intent(out) :: shear, poisson
        end subroutine moduli_at

        pure subroutine breaks_of(self, depths, error)
            import :: body_t, error_t, wp
            class(body_t), intent(in) :: self
            !> ascending; not allocated: none yet. Beyond the last one the constants do not vary [length]
            real(wp), allocatable, intent(inout) :: depths(:)
            type(error_t), allocatable, intent(inout) :: error
        end subroutine breaks_of
    end interface

contains

    pure subroutine parameters(self, list)
        class(body_t), intent(in) :: self
        type(parameter_t), allocatable, intent(out) :: list(:)

        associate (unused => self)
        end associate
        allocate (list(0))
    end subroutine parameters

    subroutine with_parameters(self, values, body, error)
        class(body_t), intent(in) :: self
        !> in the order of `parameters`
        real(wp), intent(in) :: values(:)
        class(body_t), allocatable, intent(out) :: body
        type(error_t), allocatable, intent(out) :: error

        call check_made(error, "body", self%is_made)
        if (allocated(error)) return
        associate (unused => values)
        end associate
        call copy(self, body, error)
    end subroutine with_parameters

    !> The same body; an error where there is no memory for it.
    subroutine copy_body(from, to, error)
        class(body_t), intent(in) :: from
        class(body_t), allocatable, intent(out) :: to
        type(error_t), allocatable, intent(inout) :: error

        call room(from%bytes(), error)
        if (.not. allocated(error)) allocate (to, source=from)
    end subroutine copy_body

end module mdrcontact_body
