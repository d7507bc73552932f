! SPDX-License-Identifier: GPL-3.0-or-later
!> A viscoelastic half-space, homogeneous or layered. It has no elastic states, and so no solver: histories
!> (mdrcontact_time_history) and oscillations (mdrcontact_time_stiffness) start from its materials.
module mdrcontact_medium_viscoelastic
    use, intrinsic :: iso_fortran_env, only: int64
    use mdrcontact_object, only: object_t
    use mdrcontact_parameter, only: append, parameter_t, prefixed
    use mdrcontact_body_chain, only: chain_t, new_chain
    use mdrcontact_body_elements_interface, only: bond_of, bond_t
    use mdrcontact_body_stack, only: new_stack, stack_t
    use mdrcontact_error, only: check_made, check_memory, check_positive, count_text, error_t
    use mdrcontact_kinds, only: wp
    use mdrcontact_line_shared, only: kernel_cache_t
    use mdrcontact_material, only: material_t, moduli_t, new_material
    use mdrcontact_material_prony, only: prony_t
    use mdrcontact_material_rheology, only: rheology_t, same_shape
    use mdrcontact_medium_solver, only: solver_t
    use mdrcontact_medium_homogeneous, only: homogeneous_t, new_homogeneous
    use mdrcontact_model, only: model_options_t, models, new_solver
    implicit none (type, external)
    private
    public :: viscoelastic_t, new_viscoelastic_medium

    !> Materials top to bottom, the substrate last, unless the base is rigid.
    type, extends(object_t) :: viscoelastic_t
        !> top to bottom
        type(rheology_t), allocatable :: materials(:)
        !> of the layers [length]
        real(wp), allocatable :: thickness(:)
        !> bond of each layer to what lies below it
        type(bond_t), allocatable :: bonds(:)
        !> below the last layer, instead of a half-space
        logical :: rigid_base = .false.
        !> the model by which elastic bodies of this shape are solved
        integer :: model = models%exact
        !> the model's options
        type(model_options_t) :: options
        !> whether all materials relax proportionally: every state then follows from the elastic ones (theory/time.md (3.1))
        logical :: is_proportional = .false.
        !> the elastic body whose contact modulus is multiplied by `relaxation_shape`, where they do: the glassy one without
        !> dashpots, with power laws at their unit of time
        class(solver_t), allocatable :: reference
    contains
        procedure :: parameters
        procedure :: with_parameters
        procedure :: relaxation_shape
        procedure :: chain_at
        procedure :: bytes
    end type viscoelastic_t

contains

    !> Layers on a substrate, or on a rigid base.
    subroutine new_viscoelastic_medium(self, materials, thickness, rigid_base, model, options, error, shared, bonds)
        type(viscoelastic_t), intent(out) :: self
        !> top to bottom, then, unless the base is rigid, the half-space's
        type(rheology_t), intent(in) :: materials(:)
        !> of the layers, > 0: none for a homogeneous half-space [length]
        real(wp), intent(in) :: thickness(:)
        !> below the last layer, instead of a half-space
        logical, intent(in) :: rigid_base
        !> one of models%..., and its options
        integer, intent(in) :: model
        type(model_options_t), intent(in) :: options
        type(error_t), allocatable, intent(out) :: error
        !> data shared by exact media, which make the next ones cheaper
        type(kernel_cache_t), intent(inout), optional :: shared
        !> bond of each layer to what lies below it, by springs that do not relax; without it all are bonded
        type(bond_t), intent(in), optional :: bonds(:)
        type(material_t), allocatable :: elastic(:)
        type(homogeneous_t) :: homogeneous
        type(stack_t) :: body
        integer :: i, stat

        call check_made(error, "materials", all(materials(:size(thickness))%is_made))
        if (.not. rigid_base) call check_made(error, "materials", materials(size(materials))%is_made)
        if (allocated(error)) return
        do i = 1, size(thickness)
            call check_positive(error, "thickness", thickness(i), i)
        end do
        if (allocated(error)) return
        allocate (elastic(size(thickness) + 1), self%materials(size(materials)), self%thickness(size(thickness)), &
                  self%bonds(size(thickness)), stat=stat)
        call check_memory(error, stat)
        if (stat /= 0) return
        self%materials(:) = materials
        self%thickness(:) = thickness
        if (present(bonds)) self%bonds(:) = bonds
        self%rigid_base = rigid_base
        self%model = model
        self%options = options
        self%is_proportional = .true.
        do i = 2, size(materials)
            self%is_proportional = self%is_proportional .and. same_shape(materials(1), materials(i))
        end do
        if (size(thickness) > 0) self%is_proportional = self%is_proportional .and. .not. any(materials%bulk > 0.0_wp) &
                                                        .and. .not. any(self%bonds%has_springs())
        do i = 1, size(materials)
            if (allocated(error)) return
            call reference_material(materials(i), materials(1), elastic(i), error)
        end do
        if (allocated(error)) return
        if (size(thickness) == 0) then
            call new_homogeneous(homogeneous, elastic(1))
            allocate (self%reference, source=homogeneous)
        else
            call new_stack(body, elastic(:size(thickness)), thickness, elastic(size(thickness) + 1), error, rigid_base, self%bonds)
            if (.not. allocated(error)) call new_solver(self%reference, body, model, error, options, shared)
        end if
        self%is_made = .not. allocated(error)
    end subroutine new_viscoelastic_medium

    !> For each material, top to bottom, its numbers, and behind those of a layer its thickness, and K_n and K_t of the interface
    !> below it.
    pure subroutine parameters(self, list)
        class(viscoelastic_t), intent(in) :: self
        type(parameter_t), allocatable, intent(out) :: list(:)
        type(parameter_t), allocatable :: own(:)
        integer :: i, count

        allocate (list(0))
        count = 0
        do i = 1, size(self%materials)
            call self%materials(i)%parameters(own)
            if (i <= size(self%thickness)) then
                own = [own, parameter_t("thickness", self%thickness(i)), self%bonds(i)%parameters()]
                own = prefixed(own, "layers["//count_text(i - 1)//"].")
            else if (i > 1) then
                own = prefixed(own, "substrate.")
            end if
            call append(list, count, own)
        end do
        list = list(:count)
    end subroutine parameters

    !> The same kind of body with other numbers.
    subroutine with_parameters(self, values, body, error, shared)
        class(viscoelastic_t), intent(in) :: self
        !> in the order of `parameters`
        real(wp), intent(in) :: values(:)
        type(viscoelastic_t), intent(out) :: body
        type(error_t), allocatable, intent(out) :: error
        !> data shared by exact media
        type(kernel_cache_t), intent(inout) :: shared
        type(rheology_t), allocatable :: materials(:)
        real(wp), allocatable :: thickness(:)
        type(bond_t), allocatable :: bonds(:)
        type(parameter_t), allocatable :: own(:)
        integer :: i, first, stat

        if (.not. self%is_made) call check_made(error, "medium", self%is_made)
        if (allocated(error)) return
        allocate (materials(size(self%materials)), thickness(size(self%thickness)), bonds(size(self%thickness)), stat=stat)
        call check_memory(error, stat)
        if (stat /= 0) return
        first = 1
        do i = 1, size(materials)
            call self%materials(i)%parameters(own)
            call self%materials(i)%with_parameters(values(first:first + size(own) - 1), materials(i), error)
            if (allocated(error)) return
            first = first + size(own)
            if (i > size(thickness)) exit
            thickness(i) = values(first)
            bonds(i) = bond_of(values(first + 1:first + 2))
            first = first + 3
        end do
        call new_viscoelastic_medium(body, materials, thickness, self%rigid_base, self%model, self%options, error, shared, &
                                     bonds)
    end subroutine with_parameters

    pure recursive function bytes(self)
        class(viscoelastic_t), intent(in) :: self
        integer(int64) :: bytes

        bytes = (storage_size(self%materials) + storage_size(self%thickness) + storage_size(self%bonds))/8 &
                *size(self%materials, kind=int64)
        if (allocated(self%reference)) bytes = bytes + self%reference%bytes()
    end function bytes

    !> The elastic material that represents a relaxing one; of a power law its modulus at the time for which that of the first is
    !> given.
    subroutine reference_material(rheology, first, material, error)
        type(rheology_t), intent(in) :: rheology, first
        type(material_t), intent(out) :: material
        type(error_t), allocatable, intent(inout) :: error
        real(wp) :: shear

        if (rheology%bulk > 0.0_wp) then
            call rheology%glassy(material, error)
        else
            shear = rheology%shear%instant()
            if (rheology%is_power_law()) then
                shear = rheology%modulus
                if (first%is_power_law()) shear = shear*(rheology%time/first%time)**rheology%exponent
            end if
            call new_material(material, 2.0_wp*shear*(1.0_wp + rheology%poisson), rheology%poisson, error)
        end if
    end subroutine reference_material

    !> Factor of the contact modulus of the reference body, for proportional relaxation of all materials [1].
    function relaxation_shape(self, shortest, longest, tolerance) result(series)
        class(viscoelastic_t), intent(in) :: self
        !> times between which it is needed, > 0 [time], and how well, relative, if a power law
        real(wp), intent(in) :: shortest, longest, tolerance
        type(prony_t) :: series
        real(wp) :: scale

        series = self%materials(1)%contact_series(shortest, longest, tolerance)
        if (self%materials(1)%is_power_law()) then
            scale = 2.0_wp*self%materials(1)%modulus/(1.0_wp - self%materials(1)%poisson)
        else
            scale = series%instant()
        end if
        series%limit = series%limit/scale
        series%weight = series%weight/scale
        series%viscosity = series%viscosity/scale
    end function relaxation_shape

    !> The body's compliance under a load at s: where all moduli are those that an elastic body would have.
    pure subroutine chain_at(self, load, s, chain, error)
        class(viscoelastic_t), intent(in) :: self
        !> normal_load, shear_load or twist_load
        integer, intent(in) :: load
        !> [1/time]
        complex(wp), intent(in) :: s
        type(chain_t), intent(out) :: chain
        type(error_t), allocatable, intent(inout) :: error
        type(moduli_t) :: moduli(size(self%thickness) + 1)

        ! of a rigid base any
        if (.not. self%is_made) call check_made(error, "medium", self%is_made)
        if (allocated(error)) return
        moduli(size(moduli)) = moduli_t((1.0_wp, 0.0_wp), (2.0_wp, 0.0_wp), (0.0_wp, 0.0_wp))
        moduli(:size(self%materials)) = self%materials%moduli_at(s)
        call new_chain(chain, load, self%thickness, moduli, self%rigid_base, error, self%bonds)
    end subroutine chain_at

end module mdrcontact_medium_viscoelastic
