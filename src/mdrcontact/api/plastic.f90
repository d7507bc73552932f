! SPDX-License-Identifier: GPL-3.0-or-later
!> Bodies that yield, for C.
module mdrcontact_api_plastic
    use, intrinsic :: iso_c_binding, only: c_double, c_int, c_loc, c_ptr, c_size_t, c_sizeof
    use mdrcontact_api_arrays, only: check_array
    use mdrcontact_api_options, only: check_size, write_facts
    use mdrcontact_api_plastic_open_handle, only: open_handle
    use mdrcontact_api_records, only: c_imprint_facts_t
    use mdrcontact_api_status, only: status_of
    use mdrcontact_error, only: check_count_from, error_t
    use mdrcontact_plastic_imprint, only: imprint_t
    implicit none (type, external)
    private
    public :: mdr_imprint_about, mdr_imprint_reverse_yield

contains

    function mdr_imprint_about(i, facts) result(status) bind(C, name="mdrcontact_entry_imprint_about")
        type(c_ptr), value :: i, facts
        integer(c_int) :: status
        type(imprint_t), pointer :: imprint
        type(c_imprint_facts_t), target :: made
        integer(c_size_t) :: used
        type(error_t), allocatable :: error

        call open_handle(i, "i", imprint, error)
        call check_size(error, "facts", facts, c_sizeof(made), used)
        status = status_of(error)
        if (allocated(error)) return
        made%radius = imprint%radius
        made%force = imprint%force
        made%depth = imprint%depth
        made%residual_depth = imprint%residual_depth
        made%recovered_work = imprint%recovered_work
        made%uniform = imprint%uniform
        made%hertz = imprint%hertz
        made%misfit = imprint%misfit
        call write_facts(facts, c_loc(made), used)
    end function mdr_imprint_about

    function mdr_imprint_reverse_yield(i, n, yield_stress, ratio, layer) result(status) &
        bind(C, name="mdrcontact_entry_imprint_reverse_yield")
        type(c_ptr), value :: i
        integer(c_int), value :: n
        real(c_double), intent(in), optional :: yield_stress(*)
        real(c_double), intent(inout), optional :: ratio
        integer(c_int), intent(inout), optional :: layer
        integer(c_int) :: status
        type(imprint_t), pointer :: imprint
        real(c_double) :: largest
        integer :: place
        type(error_t), allocatable :: error

        call open_handle(i, "i", imprint, error)
        call check_count_from(error, "n", n, 1)
        call check_array(error, "yield_stress", n, present(yield_stress))
        if (.not. allocated(error)) call imprint%reverse_yield(yield_stress(:n), largest, place, error)
        status = status_of(error)
        if (allocated(error)) return
        ratio = largest
        layer = int(place, c_int)
    end function mdr_imprint_reverse_yield

end module mdrcontact_api_plastic
