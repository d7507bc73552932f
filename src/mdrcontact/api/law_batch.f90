! SPDX-License-Identifier: GPL-3.0-or-later
!> Compiled contact laws for C: arrays of points.
module mdrcontact_api_law_batch
    use, intrinsic :: iso_c_binding, only: c_double, c_int, c_ptr
    use mdrcontact_api_arrays, only: check_array, check_count, make_room
    use mdrcontact_api_open_handle, only: open_handle
    use mdrcontact_api_status, only: status_of, wanted_threads
    use mdrcontact_error, only: check_code, error_t
    use mdrcontact_contact, only: check_branch
    use mdrcontact_contact_values, only: given_depth, given_force
    use mdrcontact_law, only: contact_law_t
    implicit none (type, external)
    private
    public :: mdr_law_values

contains

    function mdr_law_values(law, given, branch, n, in, d, a, f, k, slope, energy) result(status) bind(C)
        type(c_ptr), value :: law
        integer(c_int), value :: given, branch, n
        real(c_double), intent(in), optional :: in(n)
        real(c_double), intent(inout), optional, target :: d(n), a(n), f(n), k(n), slope(n), energy(n)
        integer(c_int) :: status
        type(contact_law_t), pointer :: inside
        type(error_t), allocatable :: error

        call open_handle(law, "law", inside, error)
        call check_code(error, "given", int(given), [given_depth, given_force])
        call check_branch(error, int(branch))
        call check_count(error, n)
        call check_array(error, merge("d", "F", given == given_depth), n, present(in))
        if (.not. allocated(error) .and. n > 0) then
            if (given == given_depth) then
                call write_at_depths(inside, int(branch), n, in, d, a, f, k, slope, energy, error)
            else
                call write_at_forces(inside, int(branch), n, in, d, a, f, k, slope, energy, error)
            end if
        end if
        status = status_of(error)
    end function mdr_law_values

    subroutine write_at_depths(law, branch, n, in, d, a, f, k, slope, energy, error)
        type(contact_law_t), intent(in) :: law
        integer, intent(in) :: branch
        integer(c_int), intent(in) :: n
        real(c_double), intent(in) :: in(n)
        real(c_double), intent(inout), optional, target :: d(n), a(n), f(n), k(n), slope(n), energy(n)
        type(error_t), allocatable, intent(inout) :: error
        real(c_double), pointer, contiguous :: out_1(:), out_2(:), out_3(:), out_4(:)
        real(c_double), allocatable :: depths(:)

        ! `in` may be one of the outputs
        if (present(d) .or. present(energy)) then
            call make_room(error, n, depths)
            if (allocated(error)) return
            depths(:) = in
        end if
        call point_to(n, f, out_1)
        call point_to(n, slope, out_2)
        call point_to(n, a, out_3)
        call point_to(n, k, out_4)
        call law%from_depths(in, error, out_1, out_2, out_3, out_4, branch, wanted_threads())
        if (allocated(error)) return
        if (present(energy)) call write_energies(law, branch, depths, energy)
        if (present(d)) d = depths
    end subroutine write_at_depths

    subroutine write_at_forces(law, branch, n, in, d, a, f, k, slope, energy, error)
        type(contact_law_t), intent(in) :: law
        integer, intent(in) :: branch
        integer(c_int), intent(in) :: n
        real(c_double), intent(in) :: in(n)
        real(c_double), intent(inout), optional, target :: d(n), a(n), f(n), k(n), slope(n), energy(n)
        type(error_t), allocatable, intent(inout) :: error
        real(c_double), pointer, contiguous :: out_1(:), out_2(:), out_3(:), out_4(:)
        real(c_double), allocatable, target :: depths(:)
        real(c_double), allocatable :: forces(:)

        if (present(energy)) call make_room(error, n, depths)
        if (present(f)) call make_room(error, n, forces)
        if (allocated(error)) return
        if (present(f)) forces(:) = in
        call point_to(n, d, out_1)
        if (present(energy)) out_1 => depths
        call point_to(n, slope, out_2)
        call point_to(n, a, out_3)
        call point_to(n, k, out_4)
        call law%from_forces(in, error, out_1, out_2, out_3, out_4, branch, wanted_threads())
        if (allocated(error)) return
        if (present(energy)) call write_energies(law, branch, depths, energy)
        if (present(energy) .and. present(d)) d = depths
        if (present(f)) f = forces
    end subroutine write_at_forces

    subroutine write_energies(law, branch, depths, energy)
        type(contact_law_t), intent(in) :: law
        integer, intent(in) :: branch
        real(c_double), intent(in) :: depths(:)
        real(c_double), intent(inout) :: energy(:)
        integer :: i

        do i = 1, size(depths)
            energy(i) = law%energy(depths(i), branch)
        end do
    end subroutine write_energies

    !> An array, or null if it does not exist: absent arrays of fixed shape are no valid arguments where a shape is assumed.
    subroutine point_to(n, array, pointer)
        integer(c_int), intent(in) :: n
        real(c_double), intent(in), optional, target :: array(n)
        real(c_double), pointer, contiguous, intent(out) :: pointer(:)

        pointer => null()
        if (present(array)) pointer => array
    end subroutine point_to

end module mdrcontact_api_law_batch
