! SPDX-License-Identifier: GPL-3.0-or-later
!> The flat punch on a surface with tension or a plate, and all indenters by it (theory/surfaces.md (6.2), (6.6)).
!>
!> With A c = pi e (e the constant load) and A v = A' c, A' = dA/da, every contact at radius a is
!>     k = E0* pi c_0,   k' = -E0* pi v_0,   F_g = E0* g.c,   F_g' = E0* (g'.c - g.v),   d0 = F_g'/k',   F0 = k d0 - F_g,
!> g the moments of the profile: the rule dF/da = 0 at fixed depth replaces every condition at the edge.
module mdrcontact_tension_solution
    use mdrcontact_body_compliance, only: compliance_t
    use mdrcontact_error, only: error_no_convergence, error_t, raise, to_text
    use mdrcontact_kinds, only: pi, wp
    use mdrcontact_lapack, only: dpotrs
    use mdrcontact_numerics_one_thread, only: factorize_positive
    use mdrcontact_profile, only: profile_t
    use mdrcontact_tension_body_part, only: add_body_part
    use mdrcontact_tension_green, only: green_t
    use mdrcontact_tension_matrices, only: half_space_matrices
    use mdrcontact_tension_moments, only: profile_moments
    implicit none (type, external)
    private
    public :: solution_t, solve_punch, cosines_for, extrapolated

    !> A flat punch of radius a.
    type :: solution_t
        !> contact radius [length]
        real(wp) :: radius = 0.0_wp
        !> 1 with a plate, whose ring couple is the first of the coefficients; else 0
        integer :: couple = 0
        !> c [length] and v [1]
        real(wp), allocatable :: punch(:), rate(:)
        !> those of two thirds as many cosines
        real(wp), allocatable :: fewer_punch(:), fewer_rate(:)
        !> Cholesky factor of A [length^(-1/2)], for loads of profiles; not allocated in a solution from a table
        real(wp), allocatable :: factor(:, :)
    contains
        procedure :: flat
        procedure :: respond
        procedure :: load_of
    end type solution_t

    !> Cosines: at least so many, and more for wide contacts.
    real(wp), parameter :: fewest = 10.0_wp, of_tension = 20.0_wp, of_plate = 4.0_wp, of_depth = 14.0_wp
    integer, parameter :: most = 200

contains

    !> Number of cosines for a contact of radius a.
    pure function cosines_for(green, a, first_depth) result(n)
        type(green_t), intent(in) :: green
        real(wp), intent(in) :: a
        !> thickness of the first layer, 0 without one [length]
        real(wp), intent(in) :: first_depth
        integer :: n
        real(wp) :: wanted

        if (green%columns > 2) then
            wanted = of_plate*(a*green%rate)**0.5_wp
        else
            wanted = of_tension*(a*green%rate)**0.3_wp
        end if
        if (first_depth > 0.0_wp) wanted = max(wanted, of_depth*sqrt(a/first_depth))
        n = ceiling(min(fewest + wanted, real(most, wp)))
    end function cosines_for

    !> The flat punch of radius a on a body with this compliance.
    subroutine solve_punch(self, green, compliance, a, error, cosines, rates)
        type(solution_t), intent(out) :: self
        type(green_t), intent(in) :: green
        !> of the body without its surface
        class(compliance_t), intent(in) :: compliance
        real(wp), intent(in) :: a
        type(error_t), allocatable, intent(inout) :: error
        !> how many; default as many as this radius needs
        integer, intent(in), optional :: cosines
        !> whether v is needed; default true
        logical, intent(in), optional :: rates
        real(wp), allocatable :: slope(:, :)
        integer :: n, info
        logical :: with_rates

        with_rates = .true.
        if (present(rates)) with_rates = rates
        n = cosines_for(green, a, compliance%first_depth)
        if (present(cosines)) n = cosines
        self%radius = a
        self%couple = merge(1, 0, green%columns > 2)
        call half_space_matrices(green, a, n, with_rates, self%factor, slope, error)
        if (.not. allocated(error)) call add_body_part(green, compliance, a, self%factor, slope, error)
        if (allocated(error)) return
        n = size(self%factor, 1)
        call factorize_positive(n, n, self%factor, info)
        if (info /= 0) then
            call raise(error, error_no_convergence, "the contact of radius "//to_text(a)// &
                       " on a surface with tension or a plate was not found: its matrix is not positive definite")
            return
        end if
        call punch_of(self, n, self%punch)
        call punch_of(self, max((2*n)/3, self%couple + 1), self%fewer_punch)
        if (.not. with_rates) return
        call rate_of(self, slope, self%punch, self%rate)
        call rate_of(self, slope, self%fewer_punch, self%fewer_rate)
    end subroutine solve_punch

    !> c with the first n of the basis.
    subroutine punch_of(self, n, punch)
        type(solution_t), intent(in) :: self
        integer, intent(in) :: n
        real(wp), allocatable, intent(out) :: punch(:)

        allocate (punch(n))
        punch = 0.0_wp
        punch(self%couple + 1) = pi
        punch = solved(self, punch)
    end subroutine punch_of

    !> v = A^-1 A' c.
    subroutine rate_of(self, slope, punch, rate)
        type(solution_t), intent(in) :: self
        real(wp), intent(in) :: slope(:, :), punch(:)
        real(wp), allocatable, intent(out) :: rate(:)

        rate = solved(self, matmul(slope(:size(punch), :size(punch)), punch))
    end subroutine rate_of

    !> k/E0* and k'/E0*.
    pure subroutine flat(self, stiffness, stiffness_slope)
        class(solution_t), intent(in) :: self
        !> [length], [1]
        real(wp), intent(out) :: stiffness, stiffness_slope

        stiffness = pi*self%punch(self%couple + 1)
        stiffness_slope = -pi*self%rate(self%couple + 1)
        if (.not. allocated(self%fewer_punch) .or. self%couple > 0) return
        stiffness = extrapolated(stiffness, pi*self%fewer_punch(1))
        stiffness_slope = extrapolated(stiffness_slope, -pi*self%fewer_rate(1))
    end subroutine flat

    !> d0 and F0/E0* of a profile on this contact.
    subroutine respond(self, profile, stiffness, stiffness_slope, depth, force, error)
        class(solution_t), intent(in) :: self
        class(profile_t), intent(in) :: profile
        !> [length], [1], [length], [length^2]
        real(wp), intent(out) :: stiffness, stiffness_slope, depth, force
        type(error_t), allocatable, intent(inout) :: error
        real(wp) :: moments(size(self%punch)), slopes(size(self%punch)), fine(4), coarse(4)

        stiffness = 0.0_wp
        stiffness_slope = 0.0_wp
        depth = 0.0_wp
        force = 0.0_wp
        call profile_moments(profile, self%radius, self%couple, moments, slopes, error)
        if (allocated(error)) return
        fine = linear_numbers(self%couple, self%punch, self%rate, moments, slopes)
        if (allocated(self%fewer_punch) .and. self%couple == 0) then
            coarse = linear_numbers(self%couple, self%fewer_punch, self%fewer_rate, moments, slopes)
            fine = extrapolated(fine, coarse)
        end if
        stiffness = fine(1)
        stiffness_slope = fine(2)
        depth = fine(4)/fine(2)
        force = stiffness*depth - fine(3)
    end subroutine respond

    !> k, k', F_g and F_g' over E0*.
    pure function linear_numbers(couple, punch, rate, moments, slopes) result(numbers)
        integer, intent(in) :: couple
        real(wp), intent(in) :: punch(:), rate(:), moments(:), slopes(:)
        real(wp) :: numbers(4)

        associate (n => size(punch))
            numbers = [pi*punch(couple + 1), -pi*rate(couple + 1), dot_product(moments(:n), punch), &
                       dot_product(slopes(:n), punch) - dot_product(moments(:n), rate)]
        end associate
    end function linear_numbers

    !> Richardson's step from two thirds as many cosines, with errors as n^-6.
    elemental function extrapolated(fine, coarse) result(value)
        real(wp), intent(in) :: fine, coarse
        real(wp) :: value

        value = fine + (fine - coarse)/(1.5_wp**6 - 1.0_wp)
    end function extrapolated

    !> The coefficients of the load that makes u = d - g.
    subroutine load_of(self, profile, depth, coefficients, error)
        class(solution_t), intent(in) :: self
        class(profile_t), intent(in) :: profile
        real(wp), intent(in) :: depth
        !> those of q dx/E0* [length^2]
        real(wp), allocatable, intent(out) :: coefficients(:)
        type(error_t), allocatable, intent(inout) :: error
        real(wp), dimension(size(self%punch)) :: moments, slopes, coarse

        allocate (coefficients(size(self%punch)))
        call profile_moments(profile, self%radius, self%couple, moments, slopes, error)
        coefficients = depth*self%punch - solved(self, moments)
        if (self%couple > 0) return
        coarse = 0.0_wp
        associate (fewer => size(self%fewer_punch))
            coarse(:fewer) = depth*self%fewer_punch - solved(self, moments(:fewer))
        end associate
        coefficients = extrapolated(coefficients, coarse)
    end subroutine load_of

    !> A^-1 of a right side, with as many of the basis as that has.
    function solved(self, right) result(x)
        type(solution_t), intent(in) :: self
        real(wp), intent(in) :: right(:)
        real(wp) :: x(size(right))
        integer :: info

        x = right
        call dpotrs("L", size(x), 1, self%factor, size(self%factor, 1), x, size(x), info)
    end function solved

end module mdrcontact_tension_solution
