! SPDX-License-Identifier: GPL-3.0-or-later
!> The steady equipotential contact area: a flat punch whose depth is the potential and whose force is the flux, with E_0* = 2 S_0:
!>     G = 4 S_0 int_0^a q_1 dx,  dG/da = 4 S_0 q_1(a)^2
!> (theory/conduction.md (2.1)-(2.3)).
module mdrcontact_conduction_spot
    use mdrcontact_cancel, only: check_cancelled
    use mdrcontact_conduction_bodies, only: conduction_t, tolerance
    use mdrcontact_error, only: error_no_convergence, error_t, raise, to_text
    use mdrcontact_kinds, only: wp
    use mdrcontact_line_fields, only: line_load_t
    use mdrcontact_line_legendre, only: normalisation
    use mdrcontact_line_solve, only: equation_t, first_unknowns, new_equation, next_unknowns, solution_t, solve, solve_lower, &
                                        solve_upper
    implicit none (type, external)
    private
    public :: spot_conductance, new_spot, set_series

    integer, parameter :: most_unknowns = 1500
    !> Limit of the last coefficients of the flux, relative to their mean square: rounding with a margin.
    real(wp), parameter :: settled = 1.0e-13_wp

contains

    !> G and dG/da.
    subroutine spot_conductance(self, a, conductance, slope, error)
        class(conduction_t), intent(in) :: self
        !> [length]
        real(wp), intent(in) :: a
        real(wp), intent(out) :: conductance, slope
        type(error_t), allocatable, intent(inout) :: error
        type(solution_t) :: solution

        conductance = 0.0_wp
        slope = 0.0_wp
        call solve(self%kernel, tolerance, a, solution, error, edge=.true.)
        if (allocated(error)) return
        conductance = 4.0_wp*self%scale*a*solution%modulus
        slope = 4.0_wp*self%scale*solution%punch_edge**2
    end subroutine spot_conductance

    !> The flux over 2 S_0 through a contact area at potential 1, with as many terms as its coefficients need.
    subroutine new_spot(load, conduction, a, error)
        type(line_load_t), intent(out) :: load
        type(conduction_t), intent(in) :: conduction
        !> [length]
        real(wp), intent(in) :: a
        type(error_t), allocatable, intent(inout) :: error
        type(equation_t) :: equation
        real(wp), allocatable :: c(:, :)
        real(wp) :: reached
        integer :: n
        logical :: solved

        associate (kernel => conduction%kernel)
            n = ceiling(1.5_wp*first_unknowns(kernel, tolerance, a/kernel%unit, is_kinked=.false., to_edge=.true.))
            do
                call check_cancelled(error)
                if (.not. allocated(error)) call new_equation(equation, kernel, a, n, n, 4*n + 4, 4*n, solved, error)
                if (allocated(error)) return
                if (.not. solved) then
                    call raise(error, error_no_convergence, "the contributions of the layers nearly cancel at contact radius "// &
                        to_text(a))
                    return
                end if
                c = equation%rhs(:, :1)
                call solve_lower(n, n, 1, equation%h, c)
                call solve_upper(n, n, 1, equation%h, c)
                reached = maxval(abs(c(n - 2:, 1)))*n/norm2(c)
                if (reached <= settled .or. kernel%vanishes .or. n >= most_unknowns) exit
                n = min(next_unknowns(n, reached/settled), most_unknowns)
            end do
            if (reached > tolerance .and. .not. kernel%vanishes) then
                call raise(error, error_no_convergence, "the flux through a contact area of radius "//to_text(a)// &
                           " has an error of about "//to_text(reached))
            end if
        end associate
        call set_series(load, a, normalisation(n)*c(:, 1), sum(equation%rhs(:, 2)*c(:, 1)))
    end subroutine new_spot

    !> The line load with the coefficients q of P_2j(x/a) and a value at the edge: the displacement in the contact area is 1.
    pure subroutine set_series(load, a, q, edge)
        type(line_load_t), intent(out) :: load
        real(wp), intent(in) :: a, q(:), edge

        load%a = a
        load%edge = edge
        load%q = q
        load%v = -q
    end subroutine set_series

end module mdrcontact_conduction_spot
