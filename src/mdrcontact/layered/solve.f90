! SPDX-License-Identifier: GPL-3.0-or-later
!> The springs' equation at one contact radius, on one grid (theory 6): q + (1/pi) int [X(x-s) + X(x+s)] q ds = E0* (d - g).
!>
!> Two right-hand sides give everything: q_1 for d = 1 (the flat punch) and v for g, with q = E0* (d q_1 - g - v). In the
!> kernel's unit of length.
module mdrcontact_layered_solve
    use mdrcontact_kinds, only: wp
    use mdrcontact_lapack, only: dpotrf, dpotrs
    use mdrcontact_layered_grid, only: grid_t, new_grid, split_panels
    use mdrcontact_layered_indenter, only: add_fine_interaction, choose_panels, load_t, new_load
    use mdrcontact_layered_kernel, only: kernel_t
    use mdrcontact_layered_matrix, only: interaction_matrix, interaction_row
    use mdrcontact_layered_refine, only: refine
    use mdrcontact_layered_rule, only: rule_t
    use mdrcontact_layered_rule_long, only: long_rule_t => rule_t
    use mdrcontact_profile, only: profile_t
    implicit none (type, external)
    private
    public :: solution_t, solve_on_grid

    !> The state at one contact radius.
    type :: solution_t
        !> contact radius [unit]
        real(wp) :: a = 0.0_wp
        type(grid_t) :: grid
        !> q_1 [1] and v [length] at the grid's nodes
        real(wp), allocatable :: punch(:), v(:)
        !> the same at the edge of the contact
        real(wp) :: punch_edge = 1.0_wp, v_edge = 0.0_wp
        !> E_eff/E0* [1], first-touch depth [length] and force/E0* [length^2]
        real(wp) :: modulus = 1.0_wp, depth = 0.0_wp, force = 0.0_wp
        !> relative error of the modulus per unit of relative error of the kernel: (q_1, q_1)/(1, q_1)
        real(wp) :: amplification = 1.0_wp
        !> the matrix was positive definite
        logical :: solved = .false.
    end type solution_t

contains

    !> Solves at contact radius a [unit]; without a profile for the flat punch alone.
    subroutine solve_on_grid(kernel, rules, level, a, width, solution, profile, long_rule)
        type(kernel_t), intent(in) :: kernel
        !> rules of rising order, and the one to use
        type(rule_t), intent(in) :: rules(:)
        integer, intent(in) :: level
        !> contact radius, and the width at its edge that panels need not resolve
        real(wp), intent(in) :: a, width
        type(solution_t), intent(out) :: solution
        class(profile_t), intent(in), optional :: profile
        !> the rule in longer numbers: refine with residuals in them
        type(long_rule_t), intent(in), optional :: long_rule
        real(wp), allocatable :: edges(:), matrix(:, :), rhs(:, :), z(:, :), root(:), row(:)
        type(load_t) :: load
        integer :: i, n, sides, info
        real(wp) :: interaction, total

        solution%a = a
        if (present(profile)) then
            call choose_panels(kernel, profile, a, width, rules(level), edges)
        else
            call split_panels(a, width, [a], edges)
        end if
        solution%grid = new_grid(edges, rules(level))
        n = size(solution%grid%x)
        sides = merge(2, 1, present(profile))
        allocate (matrix(n, n), rhs(n, sides), root(n), row(n), solution%punch(n), solution%v(n))
        root = sqrt(solution%grid%w)
        call interaction_matrix(kernel, solution%grid, rules(level), matrix)
        rhs(:, 1) = root
        if (present(profile)) then
            call new_load(kernel, profile, solution%grid, rules, level, load)
            do i = 1, n
                interaction = 0.0_wp
                call add_fine_interaction(kernel, load, solution%grid%x(i), interaction)
                rhs(i, 2) = root(i)*(load%values(i) - interaction)
            end do
        end if
        do i = 1, n
            matrix(i, i) = matrix(i, i) + (1.0_wp + kernel%defect)
        end do
        call dpotrf("L", n, matrix, n, info)
        solution%solved = info == 0
        if (.not. solution%solved) return
        allocate (z, source=rhs)
        call dpotrs("L", n, sides, matrix, n, z, n, info)
        if (present(long_rule)) call refine(kernel, solution%grid, long_rule, matrix, rhs, z, solution%solved)

        solution%punch = z(:, 1)/root
        call interaction_row(kernel, solution%grid, rules(level), a, row)
        solution%punch_edge = 1.0_wp - sum(row*solution%punch)
        total = sum(solution%grid%w*solution%punch)
        solution%modulus = total/a
        solution%amplification = sum(solution%grid%w*solution%punch**2)/total
        if (.not. present(profile)) return

        z(:, 2) = z(:, 2)/root
        solution%v = z(:, 2) - load%values
        interaction = sum(row*z(:, 2))
        call add_fine_interaction(kernel, load, a, interaction)
        solution%v_edge = -interaction
        ! q(a) = 0, and F = 2 E0* int_0^a (d q_1 - q_g) dx
        solution%depth = (profile%mdr(a*kernel%unit) - interaction)/solution%punch_edge
        solution%force = 2.0_wp*kernel%unit*(solution%depth*total - sum(solution%grid%w*z(:, 2)) - sum(load%fine_gw))
    end subroutine solve_on_grid

end module mdrcontact_layered_solve
