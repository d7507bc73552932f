! SPDX-License-Identifier: GPL-3.0-or-later
!> The Galerkin matrices of a contact on a half-space under tension or a plate (theory/surfaces.md (6.5), (6.7)).
!>
!> Basis: q dx = cos(2 j theta) d theta, j = 0, 1, ..., x = a cos theta, with transforms pi (-1)^j J_2j(ka); with a plate the ring
!> couple, pi ka J_1(ka), before them. A_ij = (1/pi) int kappa_0 q_i q_j dk and its slope over a, from Phi(2a sin alpha sin beta):
!>     A_ij = (4/pi) F(i + j, |i - j|),   F(m, n) = int int cos(2 m alpha) cos(2 n beta) Phi d alpha d beta.
module mdrcontact_tension_matrices
    use mdrcontact_error, only: error_t
    use mdrcontact_kinds, only: pi, wp
    use mdrcontact_numerics_one_thread, only: add_product
    use mdrcontact_tension_green, only: green_t, of_couple, of_couple_slope, of_couples, of_couples_slope, of_load, of_load_slope
    use mdrcontact_tension_grid, only: grid_t, new_grid
    implicit none (type, external)
    private
    public :: half_space_matrices

contains

    !> A and dA/da of the half-space's own part.
    subroutine half_space_matrices(green, a, n, with_slope, matrix, slope, error)
        type(green_t), intent(in) :: green
        !> contact radius [length]
        real(wp), intent(in) :: a
        !> how many cosines
        integer, intent(in) :: n
        !> whether dA/da is needed; 0 else
        logical, intent(in) :: with_slope
        !> (n + c, n + c), c = 1 with a plate, whose couple is the first [1/length] and [1/length^2]
        real(wp), allocatable, intent(out) :: matrix(:, :), slope(:, :)
        type(error_t), allocatable, intent(inout) :: error
        type(grid_t) :: grid
        real(wp), allocatable :: kernel(:, :, :), waves(:, :), transform(:, :)
        integer :: couple, i, used

        couple = merge(1, 0, green%columns > 2)
        used = merge(green%columns, 1, couple == 1)
        call new_grid(grid, 0.5_wp*green%near/a, 4.0_wp*n, error)
        if (allocated(error)) return
        associate (nodes => size(grid%angle))
            allocate (kernel(nodes, nodes, used), matrix(n + couple, n + couple), slope(n + couple, n + couple), &
                      waves(nodes, 0:2*n - 2))
        end associate
        call fill_kernel(green, grid, a, kernel)
        do i = 0, 2*n - 2
            waves(:, i) = cos(2.0_wp*i*grid%angle)
        end do
        call transform_cosines(waves, kernel(:, :, of_load), 4.0_wp/pi, n, transform)
        call take_entries(transform, 1.0_wp, matrix(couple + 1:, couple + 1:))
        slope = 0.0_wp
        if (with_slope) then
            call take_slope(transform, 4.0_wp/pi*mean_slope(green, a, error))
            call take_entries(transform, 1.0_wp/a, slope(couple + 1:, couple + 1:))
        end if
        if (couple == 0) return
        call fill_couple(grid, kernel(:, :, of_couple), 4.0_wp*a/pi, matrix(1, 2:))
        call fill_couple(grid, kernel(:, :, of_couple_slope), 4.0_wp/pi, slope(1, 2:))
        matrix(2:, 1) = matrix(1, 2:)
        slope(2:, 1) = slope(1, 2:)
        matrix(1, 1) = -4.0_wp*a**2/pi*couples(grid, kernel(:, :, of_couples))
        slope(1, 1) = -4.0_wp*a/pi*couples(grid, kernel(:, :, of_couples_slope))
    end subroutine half_space_matrices

    !> The first columns of Phi between the nodes, times the weights of both. Next to 0 in either angle with weights for the
    !> logarithm.
    pure subroutine fill_kernel(green, grid, a, kernel)
        type(green_t), intent(in) :: green
        type(grid_t), intent(in) :: grid
        real(wp), intent(in) :: a
        !> (node, node, column)
        real(wp), intent(out) :: kernel(:, :, :)
        real(wp), dimension(size(grid%angle), size(kernel, 3)) :: values, logarithmic
        real(wp) :: y(size(grid%angle)), ends(size(grid%angle))
        integer :: i, j, n

        n = size(grid%angle)
        do j = 1, n
            y(j:) = 2.0_wp*a*grid%sine(j)*grid%sine(j:)
            if (j <= grid%beside) then
                call green%split(y(j:), values(j:, :), logarithmic(j:, :))
                ends(j:) = log(2.0_wp*a)*grid%weight(j)*grid%weight(j:) + grid%log_weight(j)*grid%weight(j:) &
                           + grid%weight(j)*grid%log_weight(j:)
            else
                call green%at(y(j:), values(j:, :))
            end if
            do i = 1, size(kernel, 3)
                kernel(j:, j, i) = grid%weight(j)*grid%weight(j:)*values(j:, i)
                if (j <= grid%beside) kernel(j:, j, i) = kernel(j:, j, i) + ends(j:)*logarithmic(j:, i)
                kernel(j, j:, i) = kernel(j:, j, i)
            end do
        end do
    end subroutine fill_kernel

    !> factor F(m, n).
    subroutine transform_cosines(waves, kernel, factor, n, transform)
        !> cos(2 m alpha) at the nodes, m = 0, 1, ...
        real(wp), intent(in) :: waves(:, 0:), kernel(:, :), factor
        !> how many in the second angle
        integer, intent(in) :: n
        !> (m, n)
        real(wp), allocatable, intent(out) :: transform(:, :)
        real(wp), allocatable :: half(:, :)
        integer :: nodes, most

        nodes = size(waves, 1)
        most = size(waves, 2)
        allocate (half(nodes, n), transform(0:most - 1, 0:n - 1))
        call add_product("N", "N", nodes, n, nodes, 1.0_wp, kernel, nodes, waves, nodes, 0.0_wp, half, nodes)
        call add_product("T", "N", most, n, nodes, factor, waves, nodes, half, nodes, 0.0_wp, transform, most)
    end subroutine transform_cosines

    !> factor F(i + j, |i - j|).
    pure subroutine take_entries(transform, factor, matrix)
        real(wp), intent(in) :: transform(0:, 0:), factor
        real(wp), intent(out) :: matrix(:, :)
        integer :: i, j

        do j = 1, size(matrix, 2)
            do i = 1, size(matrix, 1)
                matrix(i, j) = factor*transform(i + j - 2, abs(i - j))
            end do
        end do
    end subroutine take_entries

    !> F' of y Phi' instead of F: y Phi' = tan alpha dPhi/d alpha, and by parts, for cos 2 m alpha + cos 2 (m + 1) alpha has the
    !> factor cos alpha,
    !>     F'(m + 1, n) + F'(m, n) = 2 m F(m, n) - 2 (m + 1) F(m + 1, n),   F'(0, n) = F'(n, 0).
    pure subroutine take_slope(transform, first)
        !> (m, n)
        real(wp), intent(inout) :: transform(0:, 0:)
        !> F'(0, 0)
        real(wp), intent(in) :: first
        real(wp) :: here, next
        integer :: m, n

        do n = 0, ubound(transform, 2)
            here = transform(0, n)
            transform(0, n) = first
            if (n > 0) transform(0, n) = transform(n, 0)
            do m = 0, ubound(transform, 1) - 1
                next = transform(m + 1, n)
                transform(m + 1, n) = 2.0_wp*m*here - 2.0_wp*(m + 1)*next - transform(m, n)
                here = next
            end do
        end do
    end subroutine take_slope

    !> int int y Phi' d alpha d beta, without waves.
    function mean_slope(green, a, error) result(total)
        type(green_t), intent(in) :: green
        real(wp), intent(in) :: a
        type(error_t), allocatable, intent(inout) :: error
        real(wp) :: total
        type(grid_t) :: grid
        real(wp), allocatable :: kernel(:, :, :)

        total = 0.0_wp
        call new_grid(grid, 0.5_wp*green%near/a, 0.0_wp, error)
        if (allocated(error)) return
        allocate (kernel(size(grid%angle), size(grid%angle), of_load_slope))
        call fill_kernel(green, grid, a, kernel)
        total = sum(kernel(:, :, of_load_slope))
    end function mean_slope

    !> factor int int sin((2j + 1) alpha) sin((2j - 1) beta) of the kernel, j = 0, 1, ...
    pure subroutine fill_couple(grid, kernel, factor, row)
        type(grid_t), intent(in) :: grid
        real(wp), intent(in) :: kernel(:, :), factor
        real(wp), intent(out) :: row(:)
        real(wp) :: image(size(kernel, 1))
        integer :: j

        do j = 0, size(row) - 1
            image = matmul(kernel, sin((2.0_wp*j - 1.0_wp)*grid%angle))
            row(j + 1) = factor*dot_product(sin((2.0_wp*j + 1.0_wp)*grid%angle), image)
        end do
    end subroutine fill_couple

    !> int int cos(2 alpha) of the kernel.
    pure function couples(grid, kernel) result(total)
        type(grid_t), intent(in) :: grid
        real(wp), intent(in) :: kernel(:, :)
        real(wp) :: total

        total = dot_product(cos(2.0_wp*grid%angle), sum(kernel, dim=2))
    end function couples

end module mdrcontact_tension_matrices
