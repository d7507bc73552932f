! SPDX-License-Identifier: GPL-3.0-or-later
!> Homogeneous layers with their elastic constants: a body as the stresses inside it need it.
module mdrcontact_body_layers
    use mdrcontact_body_elements_interface, only: bond_t
    use mdrcontact_kinds, only: wp
    use mdrcontact_material, only: material_t
    use mdrcontact_material_transverse, only: of_isotropic, transverse_t
    use mdrcontact_numerics_layer_search, only: find_layer
    implicit none (type, external)
    private
    public :: layers_t

    !> Layers top to bottom, on a half-space or a rigid base.
    type :: layers_t
        !> thicknesses > 0 [length]
        real(wp), allocatable :: thickness(:)
        !> materials of the layers and, one more, of the half-space; not allocated of layers that were not given as such
        type(material_t), allocatable :: materials(:)
        !> bond of each to what lies below it; not allocated: all are bonded
        type(bond_t), allocatable :: bonds(:)
        !> shear moduli mu [modulus] and Poisson's ratios of the layers and, one more, of the half-space
        real(wp), allocatable :: shear(:), poisson(:)
        !> bonded to a rigid base: the half-space's constants are not used
        logical :: rigid_base = .false.
    contains
        procedure :: top
        procedure :: layer_at
        procedure :: is_plain
        procedure :: constants
        procedure :: contrast
        procedure :: decays_to
        procedure :: bodies
        procedure :: contact_modulus
    end type layers_t

contains

    !> Depth of a layer's upper face [length]; layer n + 1 is the half-space.
    pure function top(self, layer) result(z)
        class(layers_t), intent(in) :: self
        integer, intent(in) :: layer
        real(wp) :: z

        z = sum(self%thickness(:layer - 1))
    end function top

    !> Whether all layers are isotropic, bonded and free of stress.
    pure function is_plain(self) result(answer)
        class(layers_t), intent(in) :: self
        logical :: answer

        answer = .true.
        if (allocated(self%bonds)) answer = all(self%bonds%is_bonded())
        if (allocated(self%materials)) answer = answer .and. all(self%materials(:self%bodies())%is_plain)
    end function is_plain

    !> Number of deformable layers and half-spaces.
    pure function bodies(self) result(number)
        class(layers_t), intent(in) :: self
        integer :: number

        number = size(self%thickness) + merge(0, 1, self%rigid_base)
    end function bodies

    !> The six numbers of a layer in units of 2 G.
    pure function constants(self, layer, shear) result(numbers)
        class(layers_t), intent(in) :: self
        integer, intent(in) :: layer
        !> G [modulus]
        real(wp), intent(in) :: shear
        type(transverse_t) :: numbers

        numbers = of_isotropic(self%shear(layer), self%poisson(layer))
        if (allocated(self%materials)) then
            if (.not. self%materials(layer)%is_plain) numbers = self%materials(layer)%constants
        end if
        numbers = numbers%scaled(2.0_wp*shear)
    end function constants

    !> Stiffest over softest modulus, the largest ratio of bending wavelengths to the thickness of the layers.
    pure function contrast(self) result(ratio)
        class(layers_t), intent(in) :: self
        real(wp) :: ratio
        type(transverse_t) :: numbers
        real(wp) :: most, least
        integer :: i

        if (self%is_plain()) then
            ratio = maxval(self%shear(:self%bodies()))/minval(self%shear(:self%bodies()))
            return
        end if
        most = 0.0_wp
        least = huge(1.0_wp)
        do i = 1, self%bodies()
            numbers = self%constants(i, 1.0_wp)
            most = max(most, numbers%h, numbers%c66)
            least = min(least, numbers%contact(), 1.0_wp/numbers%s44)
        end do
        ratio = most/least
    end function contrast

    !> The exponent at depth z, in units of k, of waves that decay from the surface, or that come back from the first interface.
    pure function decays_to(self, z, back) result(depth)
        class(layers_t), intent(in) :: self
        !> [length]
        real(wp), intent(in) :: z
        logical, intent(in) :: back
        real(wp) :: depth
        type(transverse_t) :: numbers
        integer :: i

        depth = z
        if (back) depth = 2.0_wp*self%thickness(1) - z
        if (self%is_plain()) return
        numbers = self%constants(1, 1.0_wp)
        depth = depth*numbers%decay()
        if (back) return
        depth = 0.0_wp
        do i = 1, self%bodies()
            numbers = self%constants(i, 1.0_wp)
            if (i > size(self%thickness)) then
                depth = depth + numbers%decay()*max(0.0_wp, z - self%top(i))
            else
                depth = depth + numbers%decay()*max(0.0_wp, min(z - self%top(i), self%thickness(i)))
            end if
        end do
    end function decays_to

    !> E* of a half-space of the surface's material [modulus]
    pure function contact_modulus(self) result(modulus)
        class(layers_t), intent(in) :: self
        real(wp) :: modulus
        type(transverse_t) :: numbers

        modulus = 2.0_wp*self%shear(1)/(1.0_wp - self%poisson(1))
        if (self%is_plain()) return
        numbers = self%constants(1, 0.5_wp)
        modulus = numbers%contact()
    end function contact_modulus

    !> The layer at depth z, at an interface the one above or below it; 0 inside a rigid base.
    pure function layer_at(self, z, below) result(layer)
        class(layers_t), intent(in) :: self
        real(wp), intent(in) :: z
        logical, intent(in) :: below
        integer :: layer
        real(wp) :: distance

        call find_layer(self%thickness, z, below, layer, distance)
        if (layer > size(self%thickness) .and. self%rigid_base) layer = 0
    end function layer_at

end module mdrcontact_body_layers
