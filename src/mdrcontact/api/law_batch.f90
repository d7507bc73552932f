! SPDX-License-Identifier: GPL-3.0-or-later
!> Compiled contact laws for C: arrays of points.
module mdrcontact_api_law_batch
    use, intrinsic :: iso_c_binding, only: c_double, c_int, c_ptr
    use mdrcontact_api_arrays, only: check_array, check_count, check_in_out
    use mdrcontact_api_handles, only: open_handle
    use mdrcontact_api_status, only: status_of, wanted_threads
    use mdrcontact_error, only: error_invalid, error_t, raise
    use mdrcontact_contact, only: check_branch
    use mdrcontact_law, only: check_points, contact_law_t
    implicit none (type, external)
    private
    public :: mdr_law_from_depth, mdr_law_from_force, mdr_law_energy, mdr_law_conductance

contains

    function mdr_law_from_depth(law, branch, n, d, f, slope, a, k) result(status) bind(C)
        type(c_ptr), value :: law
        integer(c_int), value :: branch, n
        real(c_double), intent(in), optional :: d(n)
        real(c_double), intent(inout), optional, target :: f(n), slope(n), a(n), k(n)
        integer(c_int) :: status

        status = write_points(law, .true., branch, n, "d", d, f, slope, a, k)
    end function mdr_law_from_depth

    function mdr_law_from_force(law, branch, n, f, d, compliance, a, k) result(status) &
        bind(C)
        type(c_ptr), value :: law
        integer(c_int), value :: branch, n
        real(c_double), intent(in), optional :: f(n)
        real(c_double), intent(inout), optional, target :: d(n), compliance(n), a(n), k(n)
        integer(c_int) :: status

        status = write_points(law, .false., branch, n, "F", f, d, compliance, a, k)
    end function mdr_law_from_force

    function mdr_law_energy(law, branch, n, d, u) result(status) bind(C)
        type(c_ptr), value :: law
        integer(c_int), value :: branch, n
        real(c_double), intent(in), optional :: d(n)
        real(c_double), intent(inout), optional :: u(n)
        integer(c_int) :: status
        type(contact_law_t), pointer :: inside
        type(error_t), allocatable :: error
        integer :: i

        call open_handle(law, "law", inside, error)
        call check_branch(error, int(branch))
        call check_in_out(error, n, "d", present(d), present(u))
        if (.not. allocated(error) .and. n > 0) then
            call check_points(error, inside%by_depth, int(branch), d)
            if (.not. allocated(error)) then
                ! in one statement gfortran would copy, for `u` might be `d`
                do i = 1, n
                    u(i) = inside%energy(d(i), int(branch))
                end do
            end if
        end if
        status = status_of(error)
    end function mdr_law_energy

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
        call check_in_out(error, n, "d", present(d), .true.)
        if (.not. allocated(error)) then
            if (.not. allocated(inside%by_depth%conductance)) then
                call raise(error, error_invalid, "this law does not conduct: make it with options.conduction")
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

    !> Points at depths or under forces.
    function write_points(law, by_depth, branch, n, name, in, other, slope, a, k) result(status)
        type(c_ptr), intent(in) :: law
        logical, intent(in) :: by_depth
        integer(c_int), intent(in) :: branch, n
        character(len=*), intent(in) :: name
        real(c_double), intent(in), optional :: in(n)
        real(c_double), intent(inout), optional, target :: other(n), slope(n), a(n), k(n)
        integer(c_int) :: status
        type(contact_law_t), pointer :: inside
        real(c_double), pointer, contiguous :: out_1(:), out_2(:), out_3(:), out_4(:)
        type(error_t), allocatable :: error

        call open_handle(law, "law", inside, error)
        call check_count(error, n)
        call check_array(error, name, n, present(in))
        if (.not. allocated(error) .and. present(in)) then
            call point_to(n, other, out_1)
            call point_to(n, slope, out_2)
            call point_to(n, a, out_3)
            call point_to(n, k, out_4)
            if (by_depth) then
                call inside%from_depths(in, error, out_1, out_2, out_3, out_4, int(branch), wanted_threads())
            else
                call inside%from_forces(in, error, out_1, out_2, out_3, out_4, int(branch), wanted_threads())
            end if
        end if
        status = status_of(error)
    end function write_points

    !> An array, or null where there is none: absent arrays of fixed shape are no valid arguments where a shape is assumed.
    subroutine point_to(n, array, pointer)
        integer(c_int), intent(in) :: n
        real(c_double), intent(in), optional, target :: array(n)
        real(c_double), pointer, contiguous, intent(out) :: pointer(:)

        pointer => null()
        if (present(array)) pointer => array
    end subroutine point_to

end module mdrcontact_api_law_batch
