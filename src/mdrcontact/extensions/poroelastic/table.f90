! SPDX-License-Identifier: GPL-3.0-or-later
!> One table of a gel's responses: of a half-space it serves all contact radii, times and diffusivities of one drained Poisson's
!> ratio and drainage; of a film those of one ratio of contact radius to thickness.
!>
!> Chebyshev series in log tau, one a decade. Construction ends with a look between their nodes, at finer waves and more
!> polynomials. Shorter times follow from the terms with which the responses begin, longer ones are solved one by one.
module mdrcontact_poroelastic_table
    use mdrcontact_batch, only: batch_t, check_threads, run_batch
    use mdrcontact_nonfinite, only: is_finite
    use mdrcontact_error, only: check_made, error_no_convergence, error_t, raise, to_text
    use mdrcontact_kinds, only: wp
    use mdrcontact_numerics_chebyshev, only: chebyshev_sum, node, series_of_values, terms
    use mdrcontact_poroelastic_answers, only: answers, at_end, basis_for, columns, first_time
    use mdrcontact_poroelastic_early, only: early_part, early_terms, fit_early
    use mdrcontact_numerics_waves, only: basis_t
    use mdrcontact_poroelastic_gel, only: gel_t, new_gel
    implicit none (type, external)
    private
    public :: poroelastic_t, new_poroelastic

    !> Up to where series go.
    real(wp), parameter :: last_time = 1.0e8_wp
    !> A table that has an error of more than this part of the force is not valid.
    real(wp), parameter :: allowed = 2.0e-5_wp
    !> Where the early responses are fitted, and compared, in units of where the series begin.
    real(wp), parameter :: early(*) = [0.1_wp, 0.2_wp, 0.45_wp], joined(*) = [1.0_wp, 1.6_wp, 2.5_wp, 4.0_wp], &
                           between(*) = [0.06_wp, 0.15_wp, 0.65_wp]
    !> From this tau on what is left to relax, which falls as tau^-1/2, is rounding.
    real(wp), parameter :: at_rest = 1.0e28_wp

    !> A gel's responses, in units of those of an incompressible half-space.
    type :: poroelastic_t
        !> whether it was made: set last by what makes it
        logical :: is_made = .false.
        !> nu, drainage and the film's thickness
        type(gel_t) :: gel
        !> of the incompressible and of the drained body
        real(wp) :: undrained(columns) = 0.0_wp, drained(columns) = 0.0_wp
        !> where the series begin
        real(wp) :: first = 0.0_wp
        !> of Chebyshev polynomials of log10 tau in each decade (terms, columns, decades)
        real(wp), allocatable :: series(:, :, :)
        !> what follows below the first decade
        real(wp) :: early(early_terms, columns) = 0.0_wp
        !> the error of the table between its nodes
        real(wp) :: error = 0.0_wp
    contains
        procedure :: value
    end type poroelastic_t

    !> The decades of a table: each has a series and a misfit of its own.
    type, extends(batch_t) :: decades_t
        type(poroelastic_t), pointer :: table => null()
        real(wp), pointer :: misfit(:) => null()
    contains
        procedure :: work => fill
    end type decades_t

contains

    !> Computes the table.
    subroutine new_poroelastic(self, poisson, drainage, ratio, error, threads)
        type(poroelastic_t), intent(out), target :: self
        !> drained Poisson's ratio, -1 < nu < 1/2
        real(wp), intent(in) :: poisson
        !> drains_by_surface, sealed or sealed_by_indenter
        integer, intent(in) :: drainage
        !> contact radius over the thickness of a film on a rigid base, 0 to 4; 0: half-space
        real(wp), intent(in) :: ratio
        type(error_t), allocatable, intent(out) :: error
        !> at least 1 (default), or 0 for as many as OpenMP offers
        integer, intent(in), optional :: threads
        type(decades_t) :: decades
        type(basis_t) :: basis
        real(wp), allocatable, target :: misfit(:)
        integer :: i, team

        team = 1
        if (present(threads)) team = threads
        call check_threads(error, team)
        if (allocated(error)) return
        call new_gel(self%gel, poisson, drainage, ratio, error)
        if (allocated(error)) return
        call basis_for(self%gel, 1.0_wp, 1.0_wp, basis, error)
        call at_end(self%gel, basis, .false., self%undrained, error)
        call at_end(self%gel, basis, .true., self%drained, error)
        if (allocated(error)) return
        self%first = first_time(self%gel)
        allocate (self%series(terms, columns, nint(log10(last_time/self%first))))
        allocate (misfit(size(self%series, 3)))
        decades%table => self
        decades%misfit => misfit
        call run_batch(decades, size(misfit), 1, 2, team, error)
        if (allocated(error)) return
        do i = 1, size(misfit)
            call keep_largest(self%error, misfit(i))
        end do
        call fill_early(self, error)
        if (.not. self%error <= allowed) call raise(error, error_no_convergence, "the table of this gel has an error of "// &
                                                    to_text(self%error)//", more than "//to_text(allowed))
        self%is_made = .not. allocated(error)
    end subroutine new_poroelastic

    !> Response before the first decade: fitted to a few responses there and to the start of the decade, compared between them.
    subroutine fill_early(self, error)
        type(poroelastic_t), intent(inout) :: self
        type(error_t), allocatable, intent(inout) :: error
        real(wp) :: tau(size(early) + size(joined)), values(size(tau), columns), exact(columns, 2), &
                    checked(columns, size(between))
        integer :: i, j

        tau = self%first*[early, joined]
        do i = 1, size(early)
            call early_answers(self%gel, self%first*[early(i), between(i)], exact, error)
            if (allocated(error)) return
            values(i, :) = exact(:, 1) - self%undrained
            checked(:, i) = exact(:, 2)
        end do
        do i = size(early) + 1, size(tau)
            do j = 1, columns
                values(i, j) = chebyshev_sum(self%series(:, j, 1), 2.0_wp*log10(tau(i)/self%first) - 1.0_wp) - self%undrained(j)
            end do
        end do
        call fit_early(tau, values, self%early, error)
        do i = 1, size(between)
            call keep_largest(self%error, misfit_of(self, self%undrained + early_part(self%early, between(i)*self%first), &
                                                    checked(:, i)))
        end do
    end subroutine fill_early

    !> All columns at some tau before the first decade.
    subroutine early_answers(gel, tau, values, error)
        type(gel_t), intent(in) :: gel
        real(wp), intent(in) :: tau(:)
        !> (column, tau)
        real(wp), intent(out) :: values(:, :)
        type(error_t), allocatable, intent(inout) :: error
        type(basis_t) :: basis

        call basis_for(gel, minval(tau), maxval(tau), basis, error, finer=.true.)
        call answers(gel, basis, tau, values, error)
    end subroutine early_answers

    !> The largest difference of the columns, relative to the force.
    pure function misfit_of(self, values, exact) result(largest)
        type(poroelastic_t), intent(in) :: self
        real(wp), intent(in) :: values(columns), exact(columns)
        real(wp) :: largest
        integer :: j

        largest = 0.0_wp
        do j = 1, columns
            call keep_largest(largest, abs(values(j) - exact(j))/max(abs(exact(j)), self%drained(1)))
        end do
    end function misfit_of

    !> A NaN counts as an error, and stays.
    pure subroutine keep_largest(largest, misfit)
        real(wp), intent(inout) :: largest
        real(wp), intent(in) :: misfit

        if (largest >= misfit .or. .not. largest <= largest) return
        largest = misfit
    end subroutine keep_largest

    !> Some decades, and what lies between their nodes.
    subroutine fill(self, first, last, error)
        class(decades_t), intent(inout) :: self
        integer, intent(in) :: first, last
        type(error_t), allocatable, intent(out) :: error
        integer :: i

        do i = first, last
            call fill_one(self%table, i, self%misfit(i), error)
            if (allocated(error)) return
        end do
    end subroutine fill

    !> One decade.
    subroutine fill_one(self, decade, misfit, error)
        type(poroelastic_t), intent(inout) :: self
        integer, intent(in) :: decade
        real(wp), intent(out) :: misfit
        type(error_t), allocatable, intent(inout) :: error
        type(basis_t) :: basis
        real(wp) :: values(columns, terms), exact(columns, 2), shortest
        integer :: i, j

        misfit = 0.0_wp
        shortest = self%first*10.0_wp**(decade - 1)
        call basis_for(self%gel, shortest, 10.0_wp*shortest, basis, error)
        call answers(self%gel, basis, [(shortest*10.0_wp**(0.5_wp + 0.5_wp*node(i, terms)), i=1, terms)], values, error)
        if (allocated(error)) return
        self%series(:, :, decade) = transpose(series_of_values(values))
        call basis_for(self%gel, shortest, 10.0_wp*shortest, basis, error, finer=.true.)
        call answers(self%gel, basis, shortest*10.0_wp**[0.3_wp, 0.7_wp], exact, error)
        if (allocated(error)) return
        do i = 1, 2
            call keep_largest(misfit, misfit_of(self, [(chebyshev_sum(self%series(:, j, decade), 0.8_wp*i - 1.2_wp), &
                                                        j=1, columns)], exact(:, i)))
        end do
    end subroutine fill_one

    !> One column at tau, or at the frequency 1/tau, >= 0; at the ends those of the elastic bodies.
    subroutine value(self, column, tau, y, error)
        class(poroelastic_t), intent(in) :: self
        !> relaxation, creep, ..., storage or loss (mdrcontact_poroelastic_answers)
        integer, intent(in) :: column
        !> D t/a^2, or D/(omega a^2) [1]
        real(wp), intent(in) :: tau
        !> in units of that of an incompressible half-space
        real(wp), intent(out) :: y
        type(error_t), allocatable, intent(out) :: error
        type(basis_t) :: basis
        real(wp) :: x, all_values(columns, 1)
        integer :: decade

        call check_made(error, "table", self%is_made)
        if (allocated(error)) return
        y = self%undrained(column)
        if (.not. is_finite(tau)) then
            call raise(error, error_no_convergence, "D t/a^2 exceeds the range of double precision: the arguments are too "// &
                "large or too small")
            return
        end if
        if (tau <= 0.0_wp) return
        if (tau > at_rest) then
            y = self%drained(column)
            return
        end if
        if (tau < self%first) then
            all_values(:, 1) = early_part(self%early, tau)
            y = y + all_values(column, 1)
            return
        end if
        x = log10(tau/self%first)
        decade = int(x) + 1
        if (decade <= size(self%series, 3)) then
            y = chebyshev_sum(self%series(:, column, decade), 2.0_wp*(x - (decade - 1)) - 1.0_wp)
        else
            call basis_for(self%gel, tau, tau, basis, error)
            call answers(self%gel, basis, [tau], all_values, error)
            y = all_values(column, 1)
        end if
    end subroutine value

end module mdrcontact_poroelastic_table
