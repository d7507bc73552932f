! SPDX-License-Identifier: GPL-3.0-or-later
!> Weights of laterally heterogeneous structures, for C (theory/lateral.md (2.4), (2.5)).
module mdrcontact_api_lateral
    use, intrinsic :: iso_c_binding, only: c_double, c_int
    use mdrcontact_api_arrays, only: check_each_finite
    use mdrcontact_api_status, only: status_of
    use mdrcontact_error, only: check_count_within, check_memory, check_not_negative, check_poisson, check_positive, &
                                error_invalid, error_t, raise, to_text
    use mdrcontact_kinds, only: wp
    use mdrcontact_lateral_cells, only: cell_weights
    use mdrcontact_lateral_field, only: space_rule, space_rule_size
    use mdrcontact_lateral_slab, only: in_radii, new_slab, slab_t
    implicit none (type, external)
    private
    public :: mdr_lateral_cells, mdr_lateral_rule

contains

    function mdr_lateral_cells(nu, a, z_top, z_bottom, nx, x, ny, y, shear, poisson) result(status) &
        bind(C, name="mdrcontact_entry_lateral_cells")
        real(c_double), value :: nu, a, z_top, z_bottom
        integer(c_int), value :: nx, ny
        real(c_double), intent(in), optional :: x(*), y(*)
        real(c_double), intent(inout), optional :: shear(*), poisson(*)
        integer(c_int) :: status
        type(slab_t) :: slab
        real(wp), allocatable :: across(:), along(:), weights(:, :, :)
        type(error_t), allocatable :: error
        integer :: stat

        call check_poisson(error, "nu", nu)
        call check_positive(error, "a", a)
        call check_not_negative(error, "z_top", z_top)
        call check_positive(error, "z_bottom", z_bottom)
        if (.not. z_bottom > z_top) call raise(error, error_invalid, "z_bottom = "//to_text(z_bottom)// &
                                               ": it must be greater than z_top = "//to_text(z_top))
        call check_lines(error, "x", nx, x)
        call check_lines(error, "y", ny, y)
        if (real(nx, wp)*real(ny, wp) > real(huge(1), wp)) then
            call raise(error, error_invalid, "nx, ny: the number of cells exceeds the range of int. Use fewer cells")
        end if
        if (.not. allocated(error)) then
            allocate (weights(nx, ny, 2), stat=stat)
            if (stat == 0) allocate (across(nx + 1), along(ny + 1), stat=stat)
            call check_memory(error, stat)
        end if
        if (.not. allocated(error)) then
            across = in_radii(x(:nx + 1), a)
            along = in_radii(y(:ny + 1), a)
            call new_slab(slab, nu, in_radii(z_top, a), in_radii(z_bottom, a), &
                          hypot(maxval(abs(across)), maxval(abs(along))), error)
        end if
        if (.not. allocated(error)) call cell_weights(slab, across, along, weights(:, :, 1), weights(:, :, 2), error)
        if (.not. allocated(error)) then
            shear(:nx*ny) = reshape(weights(:, :, 1), [nx*ny])
            poisson(:nx*ny) = reshape(weights(:, :, 2), [nx*ny])
        end if
        status = status_of(error)
    end function mdr_lateral_cells

    function mdr_lateral_rule(order, nu, points, weights) result(status) bind(C, name="mdrcontact_entry_lateral_rule")
        integer(c_int), value :: order
        real(c_double), value :: nu
        real(c_double), intent(inout), optional :: points(3, *), weights(2, *)
        integer(c_int) :: status
        type(error_t), allocatable :: error
        integer :: n

        call check_count_within(error, "order", int(order), 1, 200)
        call check_poisson(error, "nu", nu)
        if (.not. allocated(error)) then
            n = space_rule_size(int(order))
            call space_rule(int(order), nu, points(:, :n), weights(:, :n), error)
        end if
        status = status_of(error)
    end function mdr_lateral_rule

    subroutine check_lines(error, name, n, lines)
        type(error_t), allocatable, intent(inout) :: error
        character(len=*), intent(in) :: name
        integer(c_int), intent(in) :: n
        real(c_double), intent(in), optional :: lines(*)
        integer :: i

        call check_count_within(error, "n"//name, int(n), 1, huge(1) - 1)
        if (allocated(error)) return
        call check_each_finite(error, name, lines(:n + 1))
        do i = 1, n
            if (allocated(error)) return
            if (.not. lines(i + 1) > lines(i)) call raise(error, error_invalid, " = "//to_text(lines(i + 1))//": "//name// &
                                                          " must be strictly ascending", name, i + 1)
        end do
    end subroutine check_lines

end module mdrcontact_api_lateral
