! SPDX-License-Identifier: GPL-3.0-or-later
!> The conductance of compiled contact laws, for C.
module mdrcontact_api_conduction_law
    use, intrinsic :: iso_c_binding, only: c_double, c_int, c_ptr
    use mdrcontact_api_arrays, only: check_array, check_count
    use mdrcontact_api_open_handle, only: open_handle
    use mdrcontact_api_status, only: status_of
    use mdrcontact_contact, only: check_branch
    use mdrcontact_error, only: error_invalid, error_t, raise
    use mdrcontact_law, only: check_points, contact_law_t
    implicit none (type, external)
    private
    public :: mdr_law_conductance

contains

    function mdr_law_conductance(law, branch, n, d, conductance, slope) result(status) bind(C)
        type(c_ptr), value :: law
        integer(c_int), value :: branch, n
        real(c_double), intent(in), optional :: d(n)
        real(c_double), intent(inout), optional :: conductance(n), slope(n)
        integer(c_int) :: status
        type(contact_law_t), pointer :: inside
        type(error_t), allocatable :: error
        real(c_double) :: found(2)
        integer :: i

        call open_handle(law, "law", inside, error)
        call check_branch(error, int(branch))
        call check_count(error, n)
        call check_array(error, "d", n, present(d))
        if (.not. allocated(error)) then
            if (.not. allocated(inside%by_depth%conductance)) then
                call raise(error, error_invalid, "law: it has no conductance. Create it with options.conduction")
            else if (n > 0) then
                call check_points(error, inside%by_depth, int(branch), d)
            end if
        end if
        if (.not. allocated(error) .and. n > 0) then
            do i = 1, n
                call inside%conductance(d(i), found(1), found(2), int(branch))
                if (present(conductance)) conductance(i) = found(1)
                if (present(slope)) slope(i) = found(2)
            end do
        end if
        status = status_of(error)
    end function mdr_law_conductance

end module mdrcontact_api_conduction_law
