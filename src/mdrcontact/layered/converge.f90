! SPDX-License-Identifier: GPL-3.0-or-later
!> Solves the springs' equation to a stated relative tolerance: on finer and finer grids until two in a row agree.
!>
!> The finer of the two is returned; its error is far below their difference, since the grids converge exponentially. Rounding,
!> which the grids share through the kernel, is bounded by the amplification that the solution itself gives.
module mdrcontact_layered_converge
    use mdrcontact_error, only: error_no_convergence, error_t, raise, to_text
    use mdrcontact_kinds, only: long, wp
    use mdrcontact_layered_kernel, only: kernel_t
    use mdrcontact_layered_rule, only: new_rule, rule_t
    use mdrcontact_layered_rule_long, only: new_long_rule => new_rule
    use mdrcontact_layered_solve, only: solution_t, solve_on_grid
    use mdrcontact_profile, only: profile_t
    implicit none (type, external)
    private
    public :: solve_to_tolerance, make_rules

    !> Nodes per panel, in turn.
    integer, parameter :: orders(*) = [6, 8, 10, 12, 16, 20, 32]
    !> Where to begin: contacts small against the kernel's width, and others.
    integer, parameter :: first_small = 1, first_large = 2
    real(wp), parameter :: small = 0.3_wp
    !> Where the kernel is much narrower than the contact, the edge is resolved to a fraction of it that shrinks by so many
    !> octaves from
    !> one grid to the next: what varies there matters little, and the comparison tells when it does.
    integer, parameter :: finest_octave = 5
    !> Rounding of the matrix relative to 1, as its smooth modes see it: measured, with a factor to spare.
    real(wp), parameter :: rounding_per_entry = 8.0_wp*epsilon(1.0_wp)
    real(wp), parameter :: long_rounding = real(64.0_long*epsilon(1.0_long), wp)
    !> What the local spring leaves of the kernel's defect.
    real(wp), parameter :: left_of_defect = 1.0e-3_wp

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
        real(wp) :: difference, width
        !> working precision loses too many digits; even longer numbers do
        logical :: lost, hopeless
        integer :: level, first

        first = merge(first_small, first_large, a <= small)
        difference = huge(1.0_wp)
        lost = .false.
        do level = first, size(rules)
            width = max(1.0_wp, scale(a, -finest_octave*(level - first + 2)))
            call solve_on_level(kernel, rules, level, a, width, lost, solution, profile)
            if (.not. lost .and. solution%solved) then
                lost = .not. digits_suffice(kernel, solution, rounding_per_entry, tolerance)
                if (lost) call solve_on_level(kernel, rules, level, a, width, lost, solution, profile)
            end if
            if (coarse%solved .and. solution%solved) then
                difference = max(relative(coarse%modulus, solution%modulus), relative(coarse%depth, solution%depth), &
                                 relative(coarse%force, solution%force))
                hopeless = lost .and. .not. digits_suffice(kernel, solution, long_rounding, tolerance)
                if (hopeless) exit
                if (difference <= tolerance) return
            end if
            coarse = solution
        end do
        call raise(error, error_no_convergence, "the exact layered medium did not reach the relative tolerance "// &
                   to_text(tolerance)//" at contact radius "//to_text(a*kernel%unit)//"; two refinements differ by "// &
                   to_text(difference)//", and rounding errors grow by a factor "//to_text(solution%amplification))
    end subroutine solve_to_tolerance

    !> With or without longer numbers.
    subroutine solve_on_level(kernel, rules, level, a, width, precisely, solution, profile)
        type(kernel_t), intent(in) :: kernel
        type(rule_t), intent(in) :: rules(:)
        integer, intent(in) :: level
        real(wp), intent(in) :: a, width
        logical, intent(in) :: precisely
        type(solution_t), intent(out) :: solution
        class(profile_t), intent(in), optional :: profile

        if (precisely) then
            call solve_on_grid(kernel, rules, level, a, width, solution, profile, new_long_rule(rules(level)%n))
        else
            call solve_on_grid(kernel, rules, level, a, width, solution, profile)
        end if
    end subroutine solve_on_level

    !> Whether rounding, `per_entry` of the matrix relative to 1, stays below the tolerance.
    pure function digits_suffice(kernel, solution, per_entry, tolerance) result(answer)
        type(kernel_t), intent(in) :: kernel
        type(solution_t), intent(in) :: solution
        real(wp), intent(in) :: per_entry, tolerance
        logical :: answer

        answer = solution%amplification*(per_entry + left_of_defect*abs(kernel%defect)) <= tolerance
    end function digits_suffice

    pure function relative(one, other) result(difference)
        real(wp), intent(in) :: one, other
        real(wp) :: difference

        difference = abs(one - other)/max(abs(other), tiny(1.0_wp))
    end function relative

end module mdrcontact_layered_converge
