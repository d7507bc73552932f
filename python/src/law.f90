! SPDX-License-Identifier: GPL-3.0-or-later
! Compiled contact laws, flat for f2py. Texts travel as rows of the numbers of their bytes: f2py knows no kind for a byte.

!> See mdr_law_new; description ends with a zero.
subroutine law_new(contact, largest_depth, smallest_depth, tolerance, n, description, handle, status)
    use, intrinsic :: iso_c_binding, only: c_char, c_double, c_int, c_int64_t, c_loc, c_null_ptr, c_ptr
    use mdrcontact_address, only: to_address, to_pointer
    use mdrcontact_api_law, only: c_law_options_t, mdr_law_new
    implicit none (type, external)
    !f2py threadsafe
    integer(c_int64_t), intent(in) :: contact
    real(c_double), intent(in) :: largest_depth, smallest_depth, tolerance
    integer(c_int), intent(in) :: n
    integer(c_int), intent(in) :: description(n)
    integer(c_int64_t), intent(out) :: handle
    integer(c_int), intent(out) :: status
    type(c_law_options_t) :: options
    type(c_ptr) :: object
    character(kind=c_char), target :: text(n)

    text = achar(description)
    object = c_null_ptr
    options%smallest_depth = smallest_depth
    options%tolerance = tolerance
    options%description = c_loc(text)
    status = mdr_law_new(to_pointer(contact), largest_depth, options, object)
    handle = to_address(object)
end subroutine law_new

!> See mdr_law_from_depth.
subroutine law_from_depth(n, handle, branch, threads, given, force, slope, radius, stiffness, status)
    use, intrinsic :: iso_c_binding, only: c_double, c_int, c_int64_t
    use mdrcontact_address, only: to_pointer
    use mdrcontact_api_law_batch, only: mdr_law_from_depth
    implicit none (type, external)
    !f2py threadsafe
    integer(c_int), intent(in) :: n, branch, threads
    integer(c_int64_t), intent(in) :: handle
    real(c_double), intent(in) :: given(n)
    real(c_double), intent(out) :: force(n), slope(n), radius(n), stiffness(n)
    integer(c_int), intent(out) :: status

    status = mdr_law_from_depth(to_pointer(handle), branch, n, given, force, slope, radius, stiffness, threads)
end subroutine law_from_depth

!> See mdr_law_from_depth: the force alone.
subroutine law_force(n, handle, branch, threads, given, force, status)
    use, intrinsic :: iso_c_binding, only: c_double, c_int, c_int64_t
    use mdrcontact_address, only: to_pointer
    use mdrcontact_api_law_batch, only: mdr_law_from_depth
    implicit none (type, external)
    !f2py threadsafe
    integer(c_int), intent(in) :: n, branch, threads
    integer(c_int64_t), intent(in) :: handle
    real(c_double), intent(in) :: given(n)
    real(c_double), intent(out) :: force(n)
    integer(c_int), intent(out) :: status

    status = mdr_law_from_depth(to_pointer(handle), branch, n, given, f=force, threads=threads)
end subroutine law_force

!> See mdr_law_from_force.
subroutine law_from_force(n, handle, branch, threads, given, depth, compliance, radius, stiffness, status)
    use, intrinsic :: iso_c_binding, only: c_double, c_int, c_int64_t
    use mdrcontact_address, only: to_pointer
    use mdrcontact_api_law_batch, only: mdr_law_from_force
    implicit none (type, external)
    !f2py threadsafe
    integer(c_int), intent(in) :: n, branch, threads
    integer(c_int64_t), intent(in) :: handle
    real(c_double), intent(in) :: given(n)
    real(c_double), intent(out) :: depth(n), compliance(n), radius(n), stiffness(n)
    integer(c_int), intent(out) :: status

    status = mdr_law_from_force(to_pointer(handle), branch, n, given, depth, compliance, radius, stiffness, threads)
end subroutine law_from_force

!> See mdr_law_info: range of depth and of force, tolerance, error; solutions, adhesive, stretches, length of the description.
subroutine law_info(handle, numbers, counts, status)
    use, intrinsic :: iso_c_binding, only: c_double, c_int, c_int64_t
    use mdrcontact_address, only: to_pointer
    use mdrcontact_api_law, only: c_law_facts_t, mdr_law_info
    implicit none (type, external)
    integer(c_int64_t), intent(in) :: handle
    real(c_double), intent(out) :: numbers(6)
    integer(c_int), intent(out) :: counts(4), status
    type(c_law_facts_t) :: facts

    status = mdr_law_info(to_pointer(handle), facts)
    numbers = [facts%lowest_depth, facts%highest_depth, facts%lowest_force, facts%highest_force, facts%tolerance, facts%error]
    counts = [facts%solutions, facts%adhesive, facts%stretches, facts%description_length]
end subroutine law_info

!> See mdr_law_description.
subroutine law_description(handle, n, buffer, status)
    use, intrinsic :: iso_c_binding, only: c_char, c_int, c_int64_t, c_loc
    use mdrcontact_address, only: to_pointer
    use mdrcontact_api_law, only: mdr_law_description
    implicit none (type, external)
    integer(c_int64_t), intent(in) :: handle
    integer(c_int), intent(in) :: n
    integer(c_int), intent(out) :: buffer(n)
    integer(c_int), intent(out) :: status
    character(kind=c_char), target :: text(n)

    text = " "
    status = mdr_law_description(to_pointer(handle), c_loc(text), n)
    buffer = iachar(text)
end subroutine law_description

!> See mdr_law_write: the length alone.
subroutine law_length(handle, length, status)
    use, intrinsic :: iso_c_binding, only: c_int, c_int64_t, c_null_ptr
    use mdrcontact_address, only: to_pointer
    use mdrcontact_api_law_file, only: mdr_law_write
    implicit none (type, external)
    integer(c_int64_t), intent(in) :: handle
    integer(c_int), intent(out) :: length, status

    length = 0
    status = mdr_law_write(to_pointer(handle), c_null_ptr, 0_c_int, length)
end subroutine law_length

!> See mdr_law_write.
subroutine law_write(handle, n, buffer, status)
    use, intrinsic :: iso_c_binding, only: c_char, c_int, c_int64_t, c_loc
    use mdrcontact_address, only: to_pointer
    use mdrcontact_api_law_file, only: mdr_law_write
    implicit none (type, external)
    integer(c_int64_t), intent(in) :: handle
    integer(c_int), intent(in) :: n
    integer(c_int), intent(out) :: buffer(n)
    integer(c_int), intent(out) :: status
    character(kind=c_char), allocatable, target :: text(:)
    integer(c_int) :: length

    allocate (text(n))
    text = " "
    status = mdr_law_write(to_pointer(handle), c_loc(text), n, length)
    buffer = iachar(text)
end subroutine law_write

!> See mdr_law_read.
subroutine law_read(n, buffer, handle, status)
    use, intrinsic :: iso_c_binding, only: c_char, c_int, c_int64_t, c_loc, c_null_ptr, c_ptr
    use mdrcontact_address, only: to_address
    use mdrcontact_api_law_file, only: mdr_law_read
    implicit none (type, external)
    integer(c_int), intent(in) :: n
    integer(c_int), intent(in) :: buffer(n)
    integer(c_int64_t), intent(out) :: handle
    integer(c_int), intent(out) :: status
    type(c_ptr) :: object
    character(kind=c_char), allocatable, target :: text(:)

    allocate (text(n))
    text = achar(buffer)
    object = c_null_ptr
    status = mdr_law_read(c_loc(text), n, object)
    handle = to_address(object)
end subroutine law_read

!> See mdr_law_free.
subroutine law_free(handle, status)
    use, intrinsic :: iso_c_binding, only: c_int, c_int64_t, c_ptr
    use mdrcontact_address, only: to_pointer
    use mdrcontact_api_law_handle, only: mdr_law_free
    implicit none (type, external)
    integer(c_int64_t), intent(in) :: handle
    integer(c_int), intent(out) :: status
    type(c_ptr) :: object

    object = to_pointer(handle)
    status = mdr_law_free(object)
end subroutine law_free
