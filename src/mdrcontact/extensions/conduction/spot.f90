! SPDX-License-Identifier: GPL-3.0-or-later
!> The steady equipotential spot: a flat punch whose depth is the potential and whose force is the flux, with E_0* = 2 S_0:
!>     G = 4 S_0 int_0^a q_1 dx,  dG/da = 4 S_0 q_1(a)^2
!> (theory/conduction.md (2.1)-(2.3)).
module mdrcontact_conduction_spot
    use mdrcontact_cancel, only: check_cancelled
    use mdrcontact_conduction_bodies, only: conduction_t, tolerance
    use mdrcontact_error, only: check_memory, error_no_convergence, error_t, raise, to_text
    use mdrcontact_kinds, only: pi, wp
    use mdrcontact_line_legendre, only: normalisation
    use mdrcontact_line_solve, only: equation_t, first_unknowns, new_equation, next_unknowns, solution_t, solve, solve_lower, &
                                        solve_upper
    implicit none (type, external)
    private
    public :: spot_conductance, spot_t, new_spot

    integer, parameter :: most_unknowns = 1500
    !> What the last coefficients of the flux may be, relative to their mean square: rounding, with some to spare.
    real(wp), parameter :: settled = 1.0e-13_wp

    !> The flux through a spot at potential 1 as a Legendre series.
    type :: spot_t
        !> a [length]
        real(wp) :: radius = 0.0_wp
        !> coefficients of P_2j(x/a), j = 0, 1, ..., of q_1, and q_1 at the edge
        real(wp), allocatable :: q(:)
        real(wp) :: edge = 0.0_wp
    contains
        procedure :: flux
    end type spot_t

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

    !> The series, as long as its coefficients say.
    subroutine new_spot(self, conduction, a, error)
        type(spot_t), intent(out) :: self
        type(conduction_t), intent(in) :: conduction
        real(wp), intent(in) :: a
        type(error_t), allocatable, intent(inout) :: error
        real(wp) :: reached
        integer :: n

        associate (kernel => conduction%kernel)
            n = ceiling(1.5_wp*first_unknowns(kernel, tolerance, a/kernel%unit, is_kinked=.false., to_edge=.true.))
            do
                call check_cancelled(error)
                if (.not. allocated(error)) call expand(self, conduction, a, n, reached, error)
                if (allocated(error)) return
                if (reached <= settled .or. kernel%vanishes) return
                if (n >= most_unknowns) exit
                n = min(next_unknowns(n, reached/settled), most_unknowns)
            end do
        end associate
        if (reached > tolerance) call raise(error, error_no_convergence, "the flux through a spot of radius "//to_text(a)// &
                                            " is off by about "//to_text(reached))
    end subroutine new_spot

    subroutine expand(self, conduction, a, n, reached, error)
        type(spot_t), intent(inout) :: self
        type(conduction_t), intent(in) :: conduction
        real(wp), intent(in) :: a
        integer, intent(in) :: n
        !> how large the last coefficients are
        real(wp), intent(out) :: reached
        type(error_t), allocatable, intent(inout) :: error
        type(equation_t) :: equation
        real(wp) :: c(n, 1)
        logical :: solved

        reached = 0.0_wp
        call new_equation(equation, conduction%kernel, a, n, n, 4*n + 4, 4*n, solved, error)
        if (.not. solved .and. .not. allocated(error)) then
            call raise(error, error_no_convergence, "the layers of these bodies nearly cancel at spot radius "//to_text(a))
        end if
        if (allocated(error)) return
        c(:, 1) = equation%rhs(:, 1)
        call solve_lower(n, n, 1, equation%h, c)
        call solve_upper(n, n, 1, equation%h, c)
        reached = maxval(abs(c(n - 2:, 1)))*n/sqrt(sum(c**2))
        self%radius = a
        self%edge = sum(equation%rhs(:, 2)*c(:, 1))
        self%q = normalisation(n)*c(:, 1)
    end subroutine expand

    !> j(r) over 2 S_0 V at r <= a, from q = P_2j(x/a) <-> P_2j(w)/(P_2j(0) pi a w), w = sqrt(1 - r^2/a^2): infinite at the edge.
    pure function flux(self, r) result(density)
        class(spot_t), intent(in) :: self
        !> 0 <= r < a [length]
        real(wp), intent(in) :: r
        real(wp) :: density
        real(wp) :: w, square, total, even, odd, b, at_zero
        integer :: j

        square = (1.0_wp - r/self%radius)*(1.0_wp + r/self%radius)
        w = sqrt(square)
        ! even: P_2j, odd: P_(2j+1)/w, b = [P_2j(w)/P_2j(0) - 1]/w^2
        even = 1.0_wp
        odd = 1.0_wp
        b = 0.0_wp
        at_zero = 1.0_wp
        total = 0.0_wp
        do j = 0, size(self%q) - 2
            b = b - real(4*j + 3, wp)/real(2*j + 1, wp)*odd/at_zero
            at_zero = -at_zero*real(2*j + 1, wp)/real(2*j + 2, wp)
            even = (real(4*j + 3, wp)*square*odd - real(2*j + 1, wp)*even)/real(2*j + 2, wp)
            odd = (real(4*j + 5, wp)*even - real(2*j + 2, wp)*odd)/real(2*j + 3, wp)
            total = total + self%q(j + 2)*b
        end do
        density = (self%edge/w + w*total)/(pi*self%radius)
    end function flux

end module mdrcontact_conduction_spot
