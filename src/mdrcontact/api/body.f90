! SPDX-License-Identifier: GPL-3.0-or-later
!> Layered bodies, for C.
module mdrcontact_api_body
    use, intrinsic :: iso_c_binding, only: c_associated, c_double, c_f_pointer, c_int, c_int8_t, c_loc, c_ptr, c_size_t, &
                                           c_sizeof
    use mdrcontact_api_any_body, only: any_body_t, return_body
    use mdrcontact_api_arrays, only: check_results
    use mdrcontact_api_open_handle, only: open_handle
    use mdrcontact_api_options, only: read_options
    use mdrcontact_api_records, only: c_layer_t, c_surface_t
    use mdrcontact_api_status, only: check_given, status_of
    use mdrcontact_body_elements_interface, only: bond_t
    use mdrcontact_body_layers, only: layers_t
    use mdrcontact_body_stack, only: new_stack, stack_t
    use mdrcontact_body_wrinkling, only: find_wrinkling
    use mdrcontact_error, only: check_choice, check_finite, check_memory, count_text, error_invalid, error_t, raise
    use mdrcontact_kinds, only: wp
    use mdrcontact_material, only: material_t, new_material, new_transverse
    use mdrcontact_material_transverse, only: by_engineering, by_stiffness
    use mdrcontact_material_rheology, only: new_elastic_rheology, rheology_t
    use mdrcontact_medium_compliance, only: check_body_surface, compliance_limits, compliance_limits_t
    use mdrcontact_tension_surface, only: is_bare, surface_t
    implicit none (type, external)
    private
    public :: mdr_body_compliance_limits, mdr_body_layered, mdr_body_wrinkling

contains

    function mdr_body_layered(n, layers, substrate, surface, out) result(status) bind(C, name="mdrcontact_entry_body_layered")
        integer(c_int), value :: n
        type(c_ptr), value :: layers, substrate, surface
        type(c_ptr), intent(inout), optional :: out
        integer(c_int) :: status
        type(layers_t) :: layered
        type(rheology_t), allocatable :: relaxing(:)
        type(stack_t), allocatable :: stack
        type(any_body_t), allocatable :: body
        type(material_t), allocatable :: unit(:)
        type(error_t), allocatable :: error
        integer :: stat

        allocate (body, stack)
        call read_surface(error, surface, body%surface)
        call read_layers(error, n, layers, substrate, layered, relaxing)
        if (allocated(relaxing)) then
            if (.not. is_bare(body%surface)) then
                call raise(error, error_invalid, "surface: the body below a surface with tension or a sheet must be elastic")
            end if
            ! what does not depend on the materials is checked as of an elastic body
            allocate (unit(n + 1), stat=stat)
            call check_memory(error, stat)
            if (.not. allocated(error)) unit(:) = material_t(1.0_wp, 0.0_wp)
            if (.not. allocated(error)) call new_stack(stack, unit(:n), layered%thickness, unit(n + 1), error, layered%rigid_base, &
                                                       layered%bonds)
            allocate (body%relaxing)
            call move_alloc(relaxing, body%relaxing%materials)
            call move_alloc(layered%thickness, body%relaxing%thickness)
            call move_alloc(layered%bonds, body%relaxing%bonds)
            body%relaxing%rigid_base = layered%rigid_base
            body%relaxing%is_made = .not. allocated(error)
        else
            if (.not. allocated(error)) call new_stack(stack, layered%materials(:n), layered%thickness, layered%materials(n + 1), &
                                                       error, layered%rigid_base, layered%bonds)
            if (.not. allocated(error)) call check_body_surface(stack, body%surface, error)
            call move_alloc(stack, body%elastic)
        end if
        status = return_body(body, out, error)
    end function mdr_body_layered

    !> Tension and sheets of a surface; bare for a null pointer.
    subroutine read_surface(error, structure, surface)
        type(error_t), allocatable, intent(inout) :: error
        type(c_ptr), intent(in) :: structure
        type(surface_t), intent(out) :: surface
        type(c_surface_t), target :: given

        call read_options(error, "surface", structure, c_loc(given), c_sizeof(given))
        surface = surface_t(given%tension, given%bending, given%stretching)
    end subroutine read_surface

    function mdr_body_compliance_limits(body, omega, out, imaginary) result(status) &
        bind(C, name="mdrcontact_entry_body_compliance_limits")
        type(c_ptr), value :: body
        real(c_double), value :: omega
        real(c_double), intent(inout), optional :: out(*), imaginary(*)
        integer(c_int) :: status
        type(any_body_t), pointer :: given
        type(compliance_limits_t) :: limits
        complex(wp) :: found(3)
        type(error_t), allocatable :: error

        call open_handle(body, "body", given, error)
        if (.not. allocated(error)) call check_finite(error, "omega", omega)
        if (allocated(error)) then
            status = status_of(error)
            return
        end if
        if (allocated(given%relaxing)) then
            call compliance_limits(given%relaxing, omega, limits, error)
        else if (allocated(given%elastic)) then
            call compliance_limits(given%elastic, given%surface, limits, error)
        else
            call raise(error, error_invalid, ": the compliance of rigid and of power-law graded bodies has no limits. Use "// &
                       "another body", "body")
        end if
        found = [limits%short, limits%long, limits%rest]
        if (.not. allocated(error)) call check_results(error, [real(found), aimag(found)])
        status = status_of(error)
        if (allocated(error)) return
        if (present(out)) out(:3) = real(found)
        if (present(imaginary)) imaginary(:3) = aimag(found)
    end function mdr_body_compliance_limits

    function mdr_body_wrinkling(body, layer, stress, wavelength) result(status) bind(C, name="mdrcontact_entry_body_wrinkling")
        type(c_ptr), value :: body
        integer(c_int), value :: layer
        real(c_double), intent(inout), optional :: stress, wavelength
        integer(c_int) :: status
        type(any_body_t), pointer :: given
        type(layers_t) :: layers
        logical :: is_layered
        real(c_double) :: found(2)
        type(error_t), allocatable :: error
        integer :: n

        call open_handle(body, "body", given, error)
        if (.not. allocated(error)) then
            is_layered = allocated(given%elastic) .and. is_bare(given%surface)
            if (is_layered) is_layered = .not. given%elastic%is_graded
            if (.not. is_layered) then
                call raise(error, error_invalid, ": it must consist of elastic layers with a bare surface. For a viscoelastic "// &
                           "body use one of its limits", "body")
            end if
        end if
        if (.not. allocated(error)) call given%elastic%sublayers(layers, error)
        if (.not. allocated(error)) then
            n = size(layers%thickness)
            call check_choice(error, "layer", int(layer), 1, n, "from 1 (at the surface) to "//count_text(n)// &
                " (the number of layers)")
        end if
        if (.not. allocated(error)) call find_wrinkling(layers%materials(:n), layers%thickness, layers%materials(n + 1), &
                                                        layers%rigid_base, layers%bonds, int(layer), found(1), found(2), error)
        status = status_of(error)
        if (allocated(error)) return
        if (present(stress)) stress = found(1)
        if (present(wavelength)) wavelength = found(2)
    end function mdr_body_wrinkling

    !> An array of struct mdr_layer, and the half-space below it or NULL.
    subroutine read_layers(error, n, layers, substrate, layered, relaxing)
        type(error_t), allocatable, intent(inout) :: error
        integer(c_int), intent(in) :: n
        type(c_ptr), intent(in) :: layers, substrate
        !> without moduli
        type(layers_t), intent(out) :: layered
        !> the materials top to bottom where one is given by a handle, else not allocated
        type(rheology_t), allocatable, intent(out) :: relaxing(:)
        type(bond_t) :: unused
        type(rheology_t), allocatable :: materials(:)
        logical :: relaxes
        real(c_double) :: ignored
        integer :: i, stat

        layered%rigid_base = .not. c_associated(substrate)
        if (n > 0) call check_given(error, "layers", c_associated(layers))
        if (n == 0 .and. layered%rigid_base) then
            call raise(error, error_invalid, "substrate = NULL: a rigid base needs at least one layer. Give a layer or a substrate")
        end if
        if (allocated(error)) return
        allocate (layered%materials(n + 1), layered%bonds(n), layered%thickness(n), &
                  materials(n + merge(0, 1, layered%rigid_base)), stat=stat)
        call check_memory(error, stat)
        relaxes = .false.
        do i = 1, n
            if (allocated(error)) return
            call read_layer(error, "layer "//count_text(i), nth(layers, i), layered%materials(i), layered%thickness(i), &
                            layered%bonds(i), materials(i), relaxes)
        end do
        if (.not. layered%rigid_base) call read_layer(error, "substrate", substrate, layered%materials(n + 1), ignored, unused, &
                                                      materials(n + 1), relaxes, alone=n == 0)
        if (allocated(error) .or. .not. relaxes) return
        do i = 1, size(materials)
            if (layered%materials(i)%is_plain) cycle
            call raise(error, error_invalid, "E_z, nu_tz, G_z, C11 to C44 and prestress of layer "//count_text(i)// &
                       ": the layers of a viscoelastic body must be isotropic and stress-free. Set these members to 0")
            return
        end do
        call move_alloc(materials, relaxing)
    end subroutine read_layers

    !> A structure of an array whose elements have the size that the first one states.
    function nth(first, i) result(element)
        type(c_ptr), intent(in) :: first
        integer, intent(in) :: i
        type(c_ptr) :: element
        integer(c_size_t), pointer :: size
        integer(c_int8_t), pointer :: bytes(:)

        call c_f_pointer(first, size)
        call c_f_pointer(first, bytes, [int(i, c_size_t)*max(size, 1_c_size_t)])
        element = c_loc(bytes(int(i - 1, c_size_t)*size + 1_c_size_t))
    end function nth

    !> A layer, or a half-space, whose thickness and interface are then not considered.
    subroutine read_layer(error, role, given, material, thickness, bond, rheology, relaxes, alone)
        type(error_t), allocatable, intent(inout) :: error
        !> its name in error messages
        character(len=*), intent(in) :: role
        !> struct mdr_layer
        type(c_ptr), intent(in) :: given
        type(material_t), intent(out) :: material
        real(c_double), intent(out) :: thickness
        type(bond_t), intent(out) :: bond
        !> the material as part of a viscoelastic body; set where the layer has a handle
        type(rheology_t), intent(out) :: rheology
        logical, intent(inout) :: relaxes
        !> whether it is all of the body, whose E then is "E", not the role's
        logical, intent(in), optional :: alone
        type(c_layer_t), target :: layer
        type(rheology_t), pointer :: given_material
        real(c_double) :: in_plane(2), axial(3), stiffness(5)

        thickness = 0.0_c_double
        call read_options(error, role, given, c_loc(layer), c_sizeof(layer))
        if (allocated(error)) return
        thickness = layer%thickness
        in_plane = [layer%e, layer%nu]
        axial = [layer%e_z, layer%nu_tz, layer%g_z]
        stiffness = [layer%c11, layer%c12, layer%c13, layer%c33, layer%c44]
        bond = bond_t(layer%normal_compliance, layer%tangential_compliance)
        if (c_associated(layer%material)) then
            relaxes = .true.
            call open_handle(layer%material, "material of "//role, given_material, error)
            if (allocated(error)) return
            rheology = given_material
            if (any([in_plane, axial, stiffness, layer%prestress] /= 0.0_c_double)) then
                call raise(error, error_invalid, "constants and prestress of "//role//": they must be 0 if a material is given")
            end if
            return
        end if
        if (any(stiffness /= 0.0_c_double)) then
            if (any([in_plane, axial] /= 0.0_c_double)) then
                call raise(error, error_invalid, "E, nu, E_z, nu_tz and G_z of "//role//": they must be 0 if a stiffness "// &
                           "matrix is given. Give either these or C11 to C44")
                return
            end if
            call new_transverse(material, by_stiffness, stiffness, error, role)
        else if (any(axial /= 0.0_c_double)) then
            call new_transverse(material, by_engineering, [layer%e, layer%e_z, layer%nu, layer%nu_tz, layer%g_z], error, role)
        else
            if (present(alone)) then
                if (alone) call new_material(material, layer%e, layer%nu, error)
                if (.not. alone) call new_material(material, layer%e, layer%nu, error, role)
            else
                call new_material(material, layer%e, layer%nu, error, role)
            end if
        end if
        if (.not. allocated(error)) call material%stretch(layer%prestress, error, role)
        rheology = new_elastic_rheology(material)
    end subroutine read_layer

end module mdrcontact_api_body
