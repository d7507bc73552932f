! SPDX-License-Identifier: GPL-3.0-or-later
!> A stack of layers on an elastic half-space or a rigid base, bonded or held by springs, as a surface compliance (theory/exact.md
!> (2.2)).
module mdrcontact_body_stack
    use, intrinsic :: iso_fortran_env, only: int64
    use mdrcontact_parameter, only: append, nature_signed, parameter_t, prefixed
    use mdrcontact_body, only: body_t
    use mdrcontact_body_chain, only: chain_t, new_chain
    use mdrcontact_body_elements_interface, only: bond_of, bond_t, check_bond
    use mdrcontact_body_compliance, only: compliance_t, normal_load
    use mdrcontact_body_layers, only: layers_t
    use mdrcontact_body_stability, only: check_stable
    use mdrcontact_error, only: check_made, check_memory, check_positive, count_text, error_invalid, error_t, raise, to_text
    use mdrcontact_kinds, only: wp
    use mdrcontact_material, only: material_t, moduli_t
    use mdrcontact_material_transverse, only: transverse_t
    use mdrcontact_numerics_quadrature, only: merge_breaks
    implicit none (type, external)
    private
    public :: stack_t, new_stack

    !> Layers on a half-space or on a rigid base.
    type, extends(body_t) :: stack_t
        !> materials top to bottom
        type(material_t), allocatable :: layers(:)
        !> their thicknesses [length]
        real(wp), allocatable :: thickness(:)
        !> bond of each to what lies below it
        type(bond_t), allocatable :: bonds(:)
        !> what lies below them, unless the base is rigid
        type(material_t) :: substrate
        !> whether the layers lie on a rigid base; the substrate is then not used
        logical :: rigid_base = .false.
    contains
        procedure :: compliance => surface_compliance
        procedure :: sublayers
        procedure :: moduli => moduli_at
        procedure :: add_breaks
        procedure :: parameters
        procedure :: with_parameters
        procedure :: bytes
    end type stack_t

    !> Numbers of a layer behind those of its material: thickness, prestress, K_n and K_t.
    integer, parameter :: of_place = 4

contains

    !> A stack of layers. Equal neighbours are one layer to the compliance: a stack of equal layers is a homogeneous body.
    subroutine new_stack(self, layers, thickness, substrate, error, rigid_base, bonds)
        type(stack_t), intent(out) :: self
        !> materials top to bottom, as made by new_material
        type(material_t), intent(in) :: layers(:)
        !> thicknesses, same size, > 0 [length]
        real(wp), intent(in) :: thickness(:)
        !> the half-space below; an infinite E makes it a rigid base
        type(material_t), intent(in) :: substrate
        type(error_t), allocatable, intent(out) :: error
        !> bonded to a rigid base instead of the substrate, which is then ignored; default false. At least one layer then.
        logical, intent(in), optional :: rigid_base
        !> bond of each layer to what lies below it; without it all are bonded
        type(bond_t), intent(in), optional :: bonds(:)
        type(material_t), allocatable :: kept(:)
        real(wp), allocatable :: kept_thickness(:)
        type(bond_t), allocatable :: kept_bonds(:)
        type(material_t) :: surface
        logical :: rigid
        integer :: i, count, stat

        rigid = substrate%young > huge(1.0_wp)
        if (present(rigid_base)) rigid = rigid .or. rigid_base
        call check_made(error, "layers", all(layers%young > 0.0_wp))
        call check_made(error, "substrate", rigid .or. substrate%young > 0.0_wp)
        if (allocated(error)) return
        if (size(layers) /= size(thickness)) then
            call raise(error, error_invalid, "thickness must have as many values as there are layers, "// &
                       to_text(real(size(layers), wp))//", not "//to_text(real(size(thickness), wp)))
        else if (rigid .and. size(layers) == 0) then
            call raise(error, error_invalid, "layers: a rigid base needs at least one layer")
        end if
        do i = 1, size(layers)
            if (allocated(error)) return
            if (size(layers) > 1) then
                call check_positive(error, "thickness", thickness(i), i)
            else
                call check_positive(error, "thickness", thickness(i))
            end if
            call check_positive(error, "E of a layer", layers(i)%young)
        end do
        if (.not. rigid) call check_positive(error, "E of the substrate", substrate%young)
        if (present(bonds)) then
            do i = 1, size(layers)
                call check_bond(bonds(i), error)
            end do
        end if
        if (allocated(error)) return
        allocate (self%layers(size(layers)), self%thickness(size(layers)), self%bonds(size(layers)), stat=stat)
        call check_memory(error, stat)
        if (stat /= 0) return
        self%layers(:) = layers
        self%thickness(:) = thickness
        if (present(bonds)) self%bonds(:) = bonds
        self%substrate = substrate
        self%rigid_base = rigid
        call join(self, count, kept, kept_thickness, kept_bonds, error)
        if (allocated(error)) return
        surface = kept(1)
        self%surface_material = surface
        self%surface_modulus = surface%contact()
        if (count > 0) self%first_depth = kept_thickness(1)
        self%last_depth = sum(kept_thickness(:count))
        self%softest = minval(layers%young)
        self%stiffest = maxval(layers%young)
        self%slides = any(self%bonds%slides())
        self%is_plain = all(layers%is_plain) .and. all(self%bonds%is_bonded())
        if (.not. rigid) then
            self%softest = min(self%softest, substrate%young)
            self%stiffest = max(self%stiffest, substrate%young)
            self%long_wave_limit = surface%contact()/substrate%contact()
            self%is_plain = self%is_plain .and. substrate%is_plain
        end if
        ! what looks at its stability takes it as made
        self%is_made = .true.
        if (any(layers%constants%prestress < 0.0_wp)) call check_stable(self, error)
        self%is_made = .not. allocated(error)
    end subroutine new_stack

    !> The layers with neighbours of one material joined, and the substrate after them.
    pure subroutine join(self, count, materials, thickness, bonds, error)
        class(stack_t), intent(in) :: self
        !> of the joined layers: 0 if the body is homogeneous
        integer, intent(out) :: count
        !> the first count + 1, the last of them not used if the base is rigid, and the first count
        type(material_t), allocatable, intent(out) :: materials(:)
        real(wp), allocatable, intent(out) :: thickness(:)
        type(bond_t), allocatable, intent(out) :: bonds(:)
        type(error_t), allocatable, intent(inout) :: error
        logical :: is_new
        integer :: i, stat

        count = 0
        allocate (materials(size(self%layers) + 1), thickness(size(self%layers)), bonds(size(self%layers)), stat=stat)
        call check_memory(error, stat)
        if (stat /= 0) return
        do i = 1, size(self%layers)
            is_new = count == 0
            if (.not. is_new) is_new = .not. (same(self%layers(i), materials(count)) .and. bonds(count)%is_bonded())
            if (is_new) then
                count = count + 1
                materials(count) = self%layers(i)
                thickness(count) = self%thickness(i)
            else
                thickness(count) = thickness(count) + self%thickness(i)
            end if
            bonds(count) = self%bonds(i)
        end do
        if (count > 0 .and. .not. self%rigid_base) then
            if (same(self%substrate, materials(count)) .and. bonds(count)%is_bonded()) count = count - 1
        end if
        materials(count + 1) = self%substrate
    end subroutine join

    !> For each layer the numbers of its material, thickness, prestress, and K_n and K_t of the interface below it; then those of
    !> the substrate, whose names have no prefix if there is no layer.
    pure subroutine parameters(self, list)
        class(stack_t), intent(in) :: self
        type(parameter_t), allocatable, intent(out) :: list(:)
        type(parameter_t), allocatable :: own(:)
        type(transverse_t) :: six
        integer :: i, count

        allocate (list(0))
        count = 0
        do i = 1, size(self%layers)
            call self%layers(i)%parameters(own)
            six = self%layers(i)%as_transverse()
            own = [own, parameter_t("thickness", self%thickness(i)), &
                   parameter_t("prestress", six%prestress, nature_signed, six%c66), self%bonds(i)%parameters()]
            call append(list, count, prefixed(own, "layers["//count_text(i - 1)//"]."))
        end do
        if (.not. self%rigid_base) then
            call self%substrate%parameters(own)
            if (size(self%layers) > 0) own = prefixed(own, "substrate.")
            call append(list, count, own)
        end if
        list = list(:count)
    end subroutine parameters

    subroutine with_parameters(self, values, body, error)
        class(stack_t), intent(in) :: self
        real(wp), intent(in) :: values(:)
        class(body_t), allocatable, intent(out) :: body
        type(error_t), allocatable, intent(out) :: error
        type(material_t), allocatable :: materials(:)
        type(bond_t), allocatable :: bonds(:)
        real(wp), allocatable :: thickness(:)
        type(parameter_t), allocatable :: own(:)
        type(stack_t), allocatable :: stack
        integer :: i, first, last, stat
        character(len=:), allocatable :: role

        call check_made(error, "body", self%is_made)
        if (allocated(error)) return
        allocate (materials(size(self%layers) + 1), bonds(size(self%layers)), thickness(size(self%layers)), stat=stat)
        call check_memory(error, stat)
        if (stat /= 0) return
        first = 1
        do i = 1, size(self%layers)
            call self%layers(i)%parameters(own)
            last = first + size(own) - 1
            role = "layer "//count_text(i)
            call self%layers(i)%with_parameters(values(first:last), materials(i), error, role)
            if (allocated(error)) return
            thickness(i) = values(last + 1)
            call materials(i)%stretch(values(last + 2), error, role)
            bonds(i) = bond_of(values(last + 3:last + 4))
            first = last + of_place + 1
        end do
        materials(size(materials)) = self%substrate
        associate (substrate => materials(size(materials)))
            if (.not. self%rigid_base) call self%substrate%with_parameters(values(first:), substrate, error, "substrate")
        end associate
        if (allocated(error)) return
        allocate (stack)
        call new_stack(stack, materials(:size(self%layers)), thickness, materials(size(materials)), error, self%rigid_base, bonds)
        call move_alloc(stack, body)
    end subroutine with_parameters

    pure recursive function bytes(self)
        class(stack_t), intent(in) :: self
        integer(int64) :: bytes

        bytes = (storage_size(self%layers) + storage_size(self%thickness) + storage_size(self%bonds))/8 &
                *size(self%layers, kind=int64)
    end function bytes

    pure function same(one, other) result(answer)
        type(material_t), intent(in) :: one, other
        logical :: answer

        answer = one%young == other%young .and. one%poisson == other%poisson .and. (one%is_plain .eqv. other%is_plain)
        if (.not. answer .or. one%is_plain) return
        answer = all(numbers_of(one%constants) == numbers_of(other%constants))
    end function same

    pure function numbers_of(constants) result(numbers)
        type(transverse_t), intent(in) :: constants
        real(wp) :: numbers(6)

        numbers = [constants%s44, constants%s33, constants%c, constants%h, constants%c66, constants%prestress]
    end function numbers_of

    subroutine surface_compliance(self, load, compliance, error)
        class(stack_t), intent(in) :: self
        integer, intent(in) :: load
        class(compliance_t), allocatable, intent(out) :: compliance
        type(error_t), allocatable, intent(inout) :: error
        type(material_t), allocatable :: materials(:)
        real(wp), allocatable :: thickness(:)
        type(chain_t), allocatable :: chain
        type(moduli_t), allocatable :: moduli(:)
        type(bond_t), allocatable :: bonds(:)
        integer :: i, count, stat

        call check_made(error, "body", self%is_made)
        if (allocated(error)) return
        allocate (chain)
        call join(self, count, materials, thickness, bonds, error)
        if (allocated(error)) return
        allocate (moduli(count + 1), stat=stat)
        call check_memory(error, stat)
        if (stat /= 0) return
        do i = 1, size(moduli)
            moduli(i) = materials(i)%moduli()
        end do
        call new_chain(chain, load, thickness(:count), moduli, self%rigid_base, error, bonds(:count))
        if (load == normal_load) chain%at_zero = self%long_wave_limit
        call move_alloc(chain, compliance)
    end subroutine surface_compliance

    !> The layers as they were given.
    pure subroutine sublayers(self, layers, error)
        class(stack_t), intent(in) :: self
        type(layers_t), intent(out) :: layers
        type(error_t), allocatable, intent(inout) :: error
        integer :: i, n, stat

        call check_made(error, "body", self%is_made)
        if (allocated(error)) return
        n = size(self%layers)
        layers%rigid_base = self%rigid_base
        allocate (layers%thickness(n), layers%shear(n + 1), layers%poisson(n + 1), layers%materials(n + 1), layers%bonds(n), &
                  stat=stat)
        call check_memory(error, stat)
        if (stat /= 0) return
        layers%thickness(:) = self%thickness
        layers%bonds(:) = self%bonds
        layers%materials(:n) = self%layers
        layers%materials(n + 1) = self%substrate
        do i = 1, n
            layers%shear(i) = self%layers(i)%shear()
            layers%poisson(i) = self%layers(i)%poisson
        end do
        layers%shear(n + 1) = merge(1.0_wp, self%substrate%shear(), self%rigid_base)
        layers%poisson(n + 1) = merge(0.0_wp, self%substrate%poisson, self%rigid_base)
    end subroutine sublayers

    !> At an interface those of what lies below it; in a rigid base those of the last layer.
    pure subroutine moduli_at(self, z, shear, poisson)
        class(stack_t), intent(in) :: self
        real(wp), intent(in) :: z
        real(wp), intent(out) :: shear, poisson
        type(material_t) :: material
        real(wp) :: bottom
        integer :: i

        if (.not. self%rigid_base) material = self%substrate
        if (self%rigid_base) material = self%layers(size(self%layers))
        bottom = 0.0_wp
        do i = 1, size(self%layers)
            bottom = bottom + self%thickness(i)
            if (z >= bottom) cycle
            material = self%layers(i)
            exit
        end do
        shear = material%shear()
        poisson = material%poisson
    end subroutine moduli_at

    pure subroutine add_breaks(self, depths, error)
        class(stack_t), intent(in) :: self
        real(wp), allocatable, intent(inout) :: depths(:)
        type(error_t), allocatable, intent(inout) :: error
        real(wp), allocatable :: bottoms(:)
        real(wp) :: bottom
        integer :: i, stat

        allocate (bottoms(size(self%thickness)), stat=stat)
        call check_memory(error, stat)
        if (stat /= 0) return
        bottom = 0.0_wp
        do i = 1, size(bottoms)
            bottom = bottom + self%thickness(i)
            bottoms(i) = bottom
        end do
        call merge_breaks(depths, bottoms, error)
    end subroutine add_breaks

end module mdrcontact_body_stack
