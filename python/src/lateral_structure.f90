! SPDX-License-Identifier: GPL-3.0-or-later
! Laterally heterogeneous structures, flat for f2py.

!> See mdr_structure_shapes.
subroutine structure_shapes(E, nu, reference_nu, tolerance, n, kind, parameters, shape_E, shape_nu, handle, status)
    use, intrinsic :: iso_c_binding, only: c_double, c_int, c_int64_t, c_null_ptr, c_ptr
    use mdrcontact_address, only: to_address
    use mdrcontact_c_lateral, only: mdr_structure_options_init, mdr_structure_shapes, structure_options_t
    implicit none (type, external)
    real(c_double), intent(in) :: E, nu, reference_nu, tolerance
    integer(c_int), intent(in) :: n
    integer(c_int), intent(in) :: kind(n)
    real(c_double), intent(in) :: parameters(7, n), shape_E(n), shape_nu(n)
    integer(c_int64_t), intent(out) :: handle
    integer(c_int), intent(out) :: status
    type(structure_options_t) :: options
    type(c_ptr) :: object

    object = c_null_ptr
    call mdr_structure_options_init(options)
    options%reference_nu = reference_nu
    options%tolerance = tolerance
    status = mdr_structure_shapes(E, nu, n, kind, parameters, shape_E, shape_nu, options, object)
    handle = to_address(object)
end subroutine structure_shapes

!> See mdr_structure_voxels; beside is (E, nu), used only if padded is not 0. voxels = product of cells.
subroutine structure_voxels(cells, voxels, labels, phases, E, nu, spacing, below, reference_nu, padded, images, &
                            beside, origin, handle, status)
    use, intrinsic :: iso_c_binding, only: c_double, c_int, c_int64_t, c_null_ptr, c_ptr
    use mdrcontact_address, only: to_address
    use mdrcontact_c_lateral, only: mdr_structure_options_init, mdr_structure_voxels, structure_options_t
    implicit none (type, external)
    !f2py threadsafe
    integer(c_int), intent(in) :: cells(3), voxels, labels(voxels), phases
    real(c_double), intent(in) :: E(phases), nu(phases), spacing(3), below(2), reference_nu
    integer(c_int), intent(in) :: padded, images
    real(c_double), intent(in) :: beside(2), origin(2)
    integer(c_int64_t), intent(out) :: handle
    integer(c_int), intent(out) :: status
    type(structure_options_t) :: options
    type(c_ptr) :: object

    object = c_null_ptr
    call mdr_structure_options_init(options)
    options%reference_nu = reference_nu
    options%padded = padded
    options%images = images
    options%beside_e = beside(1)
    options%beside_nu = beside(2)
    options%origin = origin
    status = mdr_structure_voxels(cells, labels, phases, E, nu, spacing, below(1), below(2), options, object)
    handle = to_address(object)
end subroutine structure_voxels

!> See mdr_structure_modulus.
subroutine structure_modulus(n, threads, handle, x, y, a, values, status)
    use, intrinsic :: iso_c_binding, only: c_double, c_int, c_int64_t
    use mdrcontact_address, only: to_pointer
    use mdrcontact_c_lateral, only: mdr_structure_modulus_threads
    implicit none (type, external)
    !f2py threadsafe
    integer(c_int), intent(in) :: n, threads
    integer(c_int64_t), intent(in) :: handle
    real(c_double), intent(in) :: x(n), y(n), a(n)
    real(c_double), intent(out) :: values(n)
    integer(c_int), intent(out) :: status

    status = mdr_structure_modulus_threads(to_pointer(handle), n, x, y, a, values, threads)
end subroutine structure_modulus

!> See mdr_structure_free.
subroutine structure_free(handle, status)
    use, intrinsic :: iso_c_binding, only: c_int, c_int64_t, c_ptr
    use mdrcontact_address, only: to_pointer
    use mdrcontact_c_lateral, only: mdr_structure_free
    implicit none (type, external)
    integer(c_int64_t), intent(in) :: handle
    integer(c_int), intent(out) :: status
    type(c_ptr) :: object

    object = to_pointer(handle)
    status = mdr_structure_free(object)
end subroutine structure_free
