! SPDX-License-Identifier: GPL-3.0-or-later
!> Laterally heterogeneous structures, for C (theory/lateral.md (1.1)).
module mdrcontact_api_lateral_structure
    use, intrinsic :: iso_c_binding, only: c_double, c_f_procpointer, c_funptr, c_int, c_loc, c_null_ptr, c_ptr, c_sizeof
    use mdrcontact_api_handles, only: return_object
    use mdrcontact_api_options, only: read_options
    use mdrcontact_api_records, only: c_structure_options_t
    use mdrcontact_error, only: check_count_from, check_memory, count_text, error_callback, error_invalid, error_t, raise
    use mdrcontact_kinds, only: wp
    use mdrcontact_lateral_field, only: field_t
    use mdrcontact_lateral_shape, only: new_shape, shape_t
    use mdrcontact_lateral_shapes, only: new_shapes, shapes_t
    use mdrcontact_lateral_voxels, only: new_voxels, voxels_t
    use mdrcontact_material, only: material_t, new_material
    implicit none (type, external)
    private
    public :: c_field_t, mdr_structure_shapes, mdr_structure_voxels, read_structure_options

    !> A C function E(x, y, z), nu(x, y, z).
    type, extends(field_t) :: c_field_t
        type(c_funptr) :: function
        type(c_ptr) :: context = c_null_ptr
    contains
        procedure :: material => c_field_material
    end type c_field_t

    abstract interface
        function mdr_field(x, y, z, e, nu, context) result(status) bind(C)
            import :: c_double, c_int, c_ptr
            real(c_double), value :: x, y, z
            real(c_double), intent(inout) :: e, nu
            type(c_ptr), value :: context
            integer(c_int) :: status
        end function mdr_field
    end interface

contains

    function mdr_structure_shapes(e, nu, n, kind, parameters, shape_e, shape_nu, options, out) result(status) &
        bind(C, name="mdrcontact_entry_structure_shapes")
        real(c_double), value :: e, nu
        integer(c_int), value :: n
        integer(c_int), intent(in), optional :: kind(*)
        real(c_double), intent(in), optional :: parameters(7, *), shape_e(*), shape_nu(*)
        type(c_ptr), value :: options
        type(c_ptr), intent(inout), optional :: out
        integer(c_int) :: status
        type(c_structure_options_t), target :: chosen
        type(material_t) :: background, material
        type(shape_t), allocatable :: shapes(:)
        type(shapes_t), allocatable :: structure
        class(*), allocatable :: object
        type(error_t), allocatable :: error
        integer :: i, stat

        allocate (structure)
        call new_material(background, e, nu, error)
        call read_structure_options(error, options, chosen)
        if (.not. allocated(error)) then
            allocate (shapes(n), stat=stat)
            call check_memory(error, stat)
        end if
        if (.not. allocated(error)) then
            do i = 1, n
                call new_material(material, shape_e(i), shape_nu(i), error, "shape "//count_text(i))
                if (.not. allocated(error)) call new_shape(shapes(i), int(kind(i)), parameters(:, i), material, error)
                if (allocated(error)) exit
            end do
        end if
        if (.not. allocated(error)) then
            if (chosen%reference_nu_is_given == 0_c_int) chosen%reference_nu = nu
            call new_shapes(structure, background, shapes, error, chosen%reference_nu, chosen%tolerance, chosen%exponent)
        end if
        call move_alloc(structure, object)
        status = return_object(object, out, error)
    end function mdr_structure_shapes

    function mdr_structure_voxels(size, labels, phases, e, nu, spacing, below_e, below_nu, options, out) result(status) &
        bind(C, name="mdrcontact_entry_structure_voxels")
        integer(c_int), intent(in), optional :: size(3), labels(*)
        integer(c_int), value :: phases
        real(c_double), intent(in), optional :: e(*), nu(*), spacing(3)
        real(c_double), value :: below_e, below_nu
        type(c_ptr), value :: options
        type(c_ptr), intent(inout), optional :: out
        integer(c_int) :: status
        type(c_structure_options_t), target :: chosen
        type(material_t) :: below
        type(material_t), allocatable :: materials(:), beside
        type(voxels_t), allocatable :: structure
        class(*), allocatable :: object
        type(error_t), allocatable :: error
        integer, allocatable :: cells(:, :, :)
        real(wp), allocatable :: reference_nu
        integer :: stat

        allocate (structure)
        call read_structure_options(error, options, chosen)
        call check_materials(phases, e, nu, materials, error)
        if (.not. allocated(error)) call new_material(below, below_e, below_nu, error, "below")
        if (.not. allocated(error) .and. chosen%padded /= 0_c_int) then
            allocate (beside)
            call new_material(beside, chosen%beside_e, chosen%beside_nu, error, "beside")
        end if
        if (.not. allocated(error)) then
            if (any(size < 1)) call raise(error, error_invalid, "size: each entry must be at least 1")
        end if
        if (.not. allocated(error)) then
            if (product(real(size, wp)) > real(huge(1_c_int), wp)) then
                call raise(error, error_invalid, "size: the number of voxels exceeds the range of int. Use fewer voxels")
            end if
        end if
        if (.not. allocated(error)) then
            allocate (cells(size(1), size(2), size(3)), stat=stat)
            call check_memory(error, stat)
        end if
        if (.not. allocated(error)) then
            call copy_labels(labels, int(phases), cells, error)
        end if
        if (.not. allocated(error)) then
            if (chosen%reference_nu_is_given /= 0_c_int) reference_nu = chosen%reference_nu
            call new_voxels(structure, cells, materials, spacing, below, error, beside, chosen%origin, int(chosen%images), &
                            reference_nu, chosen%exponent)
        end if
        call move_alloc(structure, object)
        status = return_object(object, out, error)
    end function mdr_structure_voxels

    !> Options of the caller, with defaults for the rest.
    subroutine read_structure_options(error, structure, options)
        type(error_t), allocatable, intent(inout) :: error
        type(c_ptr), intent(in) :: structure
        type(c_structure_options_t), intent(out), target :: options

        call read_options(error, "options", structure, c_loc(options), c_sizeof(options))
        if (options%reference_nu /= 0.0_c_double) options%reference_nu_is_given = 1_c_int
        if (options%tolerance == 0.0_c_double) options%tolerance = 1.0e-5_c_double
        if (options%images == 0_c_int) options%images = 1_c_int
        if (options%exponent == 0.0_c_double .and. options%exponent_is_given == 0_c_int) options%exponent = 1.0_c_double
    end subroutine read_structure_options

    subroutine check_materials(n, e, nu, materials, error)
        integer(c_int), intent(in) :: n
        real(c_double), intent(in), optional :: e(*), nu(*)
        type(material_t), allocatable, intent(out) :: materials(:)
        type(error_t), allocatable, intent(inout) :: error
        integer :: i, stat

        call check_count_from(error, "phases", int(n), 1)
        if (allocated(error)) return
        allocate (materials(n), stat=stat)
        call check_memory(error, stat)
        if (allocated(error)) return
        do i = 1, n
            call new_material(materials(i), e(i), nu(i), error, "phase "//count_text(i - 1))
            if (allocated(error)) return
        end do
    end subroutine check_materials

    !> C counts phases from 0.
    pure subroutine copy_labels(labels, phases, cells, error)
        integer(c_int), intent(in) :: labels(*)
        integer, intent(in) :: phases
        integer, intent(out) :: cells(:, :, :)
        type(error_t), allocatable, intent(inout) :: error
        integer :: i, j, k, place

        place = 0
        do k = 1, size(cells, 3)
            do j = 1, size(cells, 2)
                do i = 1, size(cells, 1)
                    place = place + 1
                    if (labels(place) < 0 .or. labels(place) >= phases) then
                        call raise(error, error_invalid, " = "//count_text(int(labels(place)))//": it must be the index of a "// &
                                   "phase, from 0 to "//count_text(phases - 1), "labels", place)
                        return
                    end if
                    cells(i, j, k) = labels(place) + 1
                end do
            end do
        end do
    end subroutine copy_labels

    subroutine c_field_material(self, x, y, z, shear, poisson, error)
        class(c_field_t), intent(in) :: self
        real(wp), intent(in) :: x, y, z
        real(wp), intent(out) :: shear, poisson
        type(error_t), allocatable, intent(inout) :: error
        procedure(mdr_field), pointer :: function
        real(c_double) :: e, nu
        integer(c_int) :: status

        call c_f_procpointer(self%function, function)
        e = 0.0_c_double
        nu = 0.0_c_double
        status = function(x, y, z, e, nu, self%context)
        shear = 0.5_wp*e/(1.0_wp + nu)
        poisson = nu
        if (status /= 0_c_int) then
            call raise(error, error_callback, "the function of the structure reported failure "//count_text(int(status)))
        end if
    end subroutine c_field_material

end module mdrcontact_api_lateral_structure
