! SPDX-License-Identifier: GPL-3.0-or-later
!> Solves the springs' equation to a stated relative tolerance: on finer and finer grids until two in a row agree.
!>
!> The finer of the two is returned; its error is far below their difference, since the grids converge exponentially. Rounding,
!> which the grids share through the kernel, is bounded by the amplification that the solution itself gives.
module mdrcontact_layered_converge
    use mdrcontact_error, only: error_no_convergence, error_t, raise, to_text
    use mdrcontact_kinds, only: wp
    use mdrcontact_layered_grid, only: longest_panel
    use mdrcontact_layered_kernel, only: kernel_t
    use mdrcontact_layered_rule, only: new_rule, rule_t
    use mdrcontact_layered_solve, only: solution_t, solve_on_grid
    use mdrcontact_profile, only: profile_t
    implicit none (type, external)
    private
    public :: solve_to_tolerance, make_rules

    !> Nodes per panel, in turn.
    integer, parameter :: orders(*) = [6, 8, 10, 12, 16, 20, 32]
    !> Where to begin: contacts small against the kernel's width, as wide as it, wider.
    integer, parameter :: first_small = 1, first_medium = 2, first_large = 3
    real(wp), parameter :: small = 0.3_wp
    !> Rounding of the matrix relative to 1, as its smooth modes see it: measured, with a factor to spare.
    real(wp), parameter :: rounding_per_entry = 8.0_wp*epsilon(1.0_wp)

contains

    !> The rules that solve_to_tolerance takes.
    function make_rules() result(rules)
        type(rule_t) :: rules(size(orders))
        integer :: i

        do i = 1, size(orders)
            rules(i) = new_rule(orders(i))
        end do
    end function make_rules

    !> The solution at contact radius a [unit of the kernel]; without a profile for the flat punch alone.
    subroutine solve_to_tolerance(kernel, rules, tolerance, a, solution, error, profile)
        type(kernel_t), intent(in) :: kernel
        type(rule_t), intent(in) :: rules(:)
        !> relative, of E_eff, d and F
        real(wp), intent(in) :: tolerance, a
        type(solution_t), intent(out) :: solution
        type(error_t), allocatable, intent(out) :: error
        class(profile_t), intent(in), optional :: profile
        type(solution_t) :: coarse
        real(wp) :: difference, rounding
        integer :: level, first

        first = first_large
        if (a <= longest_panel) first = first_medium
        if (a <= small) first = first_small
        difference = huge(1.0_wp)
        rounding = 0.0_wp
        call solve_on_grid(kernel, rules(first), a, coarse, profile)
        do level = first + 1, size(rules)
            call solve_on_grid(kernel, rules(level), a, solution, profile)
            if (coarse%solved .and. solution%solved) then
                difference = max(relative(coarse%modulus, solution%modulus), relative(coarse%depth, solution%depth), &
                                 relative(coarse%force, solution%force))
                rounding = solution%amplification*(rounding_per_entry + abs(kernel%defect))
                if (max(difference, rounding) <= tolerance) return
            end if
            coarse = solution
        end do
        call raise(error, error_no_convergence, "the exact layered medium did not reach the relative tolerance "// &
                   to_text(tolerance)//" at contact radius "//to_text(a*kernel%unit)//"; two refinements differ by "// &
                   to_text(difference)//", rounding may add "//to_text(rounding))
    end subroutine solve_to_tolerance

    pure function relative(one, other) result(difference)
        real(wp), intent(in) :: one, other
        real(wp) :: difference

        difference = abs(one - other)/max(abs(other), tiny(1.0_wp))
    end function relative

end module mdrcontact_layered_converge
