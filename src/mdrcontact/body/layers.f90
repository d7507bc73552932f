! SPDX-License-Identifier: GPL-3.0-or-later
!> Homogeneous layers with their elastic constants: a body as the stresses inside it need it.
module mdrcontact_body_layers
    use mdrcontact_body_elements_interface, only: bond_t
    use mdrcontact_error, only: error_t
    use mdrcontact_kinds, only: wp
    use mdrcontact_material, only: material_t
    use mdrcontact_numerics_copy, only: copy_array
    implicit none (type, external)
    private
    public :: layers_t

    !> Layers from the surface down, on a half-space or a rigid base.
    type :: layers_t
        !> thicknesses > 0 [length]
        real(wp), allocatable :: thickness(:)
        !> materials of the layers and, one more, of the half-space; not allocated of layers that were not given as such
        type(material_t), allocatable :: materials(:)
        !> how each holds to what lies below it; not allocated: all are bonded
        type(bond_t), allocatable :: bonds(:)
        !> shear moduli mu [modulus] and Poisson's ratios of the layers and, one more, of the half-space
        real(wp), allocatable :: shear(:), poisson(:)
        !> bonded to a rigid base: the half-space's constants are not used
        logical :: rigid_base = .false.
    contains
        procedure :: in_units_of
        procedure :: top
        procedure :: layer_at
    end type layers_t

contains

    !> The same with lengths in units of another one, without materials and interfaces.
    pure subroutine in_units_of(self, length, scaled, error)
        class(layers_t), intent(in) :: self
        !> > 0
        real(wp), intent(in) :: length
        type(layers_t), intent(out) :: scaled
        type(error_t), allocatable, intent(inout) :: error

        scaled%rigid_base = self%rigid_base
        call copy_array(self%thickness, scaled%thickness, error)
        call copy_array(self%shear, scaled%shear, error)
        call copy_array(self%poisson, scaled%poisson, error)
        if (.not. allocated(error)) scaled%thickness(:) = scaled%thickness/length
    end subroutine in_units_of

    !> Depth of a layer's upper face [length]; layer n + 1 is the half-space.
    pure function top(self, layer) result(z)
        class(layers_t), intent(in) :: self
        integer, intent(in) :: layer
        real(wp) :: z

        z = sum(self%thickness(:layer - 1))
    end function top

    !> The layer at depth z, at an interface the one above or below it; 0 inside a rigid base.
    pure function layer_at(self, z, below) result(layer)
        class(layers_t), intent(in) :: self
        real(wp), intent(in) :: z
        logical, intent(in) :: below
        integer :: layer
        real(wp) :: bottom

        bottom = 0.0_wp
        do layer = 1, size(self%thickness)
            bottom = bottom + self%thickness(layer)
            if (z < bottom .or. (z == bottom .and. .not. below)) return
        end do
        if (self%rigid_base) layer = 0
    end function layer_at

end module mdrcontact_body_layers
