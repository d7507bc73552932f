! SPDX-License-Identifier: GPL-3.0-or-later
!> A contact of a gel at some Laplace variables s: the line load of a flat punch or a paraboloid at depth 1, in units of 4 G. Below,
!> 1 represents the shape.
!>
!> With q the line load of the total pressure, m that of the pore pressure where the indenter seals, w = q - m, R and P the cosine
!> integrals with r and Phi/k:  q + R w = 1,  m = P w - (P w)(1). A surface that drains, or is sealed, everywhere has no m in the
!> first and no second. Hence w + R w + P w - (P w)(1) = 1 and q = 1 - R w: theory/poroelastic.md (3.2)-(3.6).
module mdrcontact_poroelastic_contact
    use mdrcontact_body_compliance, only: normal_to
    use mdrcontact_body_film, only: film_t, new_film
    use mdrcontact_error, only: error_no_convergence, error_t, raise
    use mdrcontact_kinds, only: wp
    use mdrcontact_numerics_one_thread, only: solve
    use mdrcontact_numerics_waves, only: basis_t
    use mdrcontact_poroelastic_gel, only: gel_t, sealed_by_indenter
    use mdrcontact_poroelastic_kernel, only: surface_flux, relative_compliance
    implicit none (type, external)
    private
    public :: solve_contacts, solve_elastic, flat, parabolic

    !> Coefficients of 1, a flat punch at depth 1, and of 1 - x^2, a paraboloid.
    real(wp), parameter :: flat(2) = [1.0_wp, 0.0_wp], parabolic(2) = [2.0_wp/3.0_wp, -2.0_wp/(3.0_wp*sqrt(5.0_wp))]

contains

    !> Coefficients of q and of w in the basis's polynomials, at each s.
    subroutine solve_contacts(gel, basis, shape, s, q, w, error)
        type(gel_t), intent(in) :: gel
        type(basis_t), intent(in) :: basis
        !> the first two coefficients of the prescribed quantity on the line: flat or parabolic
        real(wp), intent(in) :: shape(2)
        complex(wp), intent(in) :: s(:)
        !> (order, s)
        complex(wp), intent(out) :: q(:, :), w(:, :)
        type(error_t), allocatable, intent(inout) :: error
        complex(wp), allocatable :: f(:, :), r(:, :, :), p(:, :, :)
        integer :: j

        q = 0.0_wp
        w = 0.0_wp
        if (allocated(error)) return
        allocate (f(size(basis%k), size(s)), r(basis%order, basis%order, size(s)), p(basis%order, basis%order, size(s)))
        do j = 1, size(s)
            f(:, j) = relative_compliance(gel, basis%k, s(j)) - gel%local()
        end do
        call basis%project_each(f, .false., r)
        p = 0.0_wp
        if (gel%drainage == sealed_by_indenter) then
            do j = 1, size(s)
                f(:, j) = surface_flux(gel, basis%k, s(j))
            end do
            call basis%project_each(f, .true., p)
        end if
        do j = 1, size(s)
            call add_to_diagonal(r(:, :, j), gel%local())
            call solve_shape(r(:, :, j) + p(:, :, j), shape, w(:, j), error)
            q(:, j) = w(:, j)
            if (gel%drainage == sealed_by_indenter) then
                q(:, j) = -matmul(r(:, :, j), w(:, j))
                q(:2, j) = q(:2, j) + shape
            end if
        end do
    end subroutine solve_contacts

    !> The same of an elastic body, the gel initially (nu = 1/2) or finally.
    subroutine solve_elastic(gel, basis, is_drained, q, error)
        type(gel_t), intent(in) :: gel
        type(basis_t), intent(in) :: basis
        logical, intent(in) :: is_drained
        complex(wp), intent(out) :: q(:)
        type(error_t), allocatable, intent(inout) :: error
        complex(wp), allocatable :: r(:, :)
        complex(wp) :: one_plus_chi, chi(size(basis%k))
        type(film_t) :: film
        real(wp) :: poisson
        integer :: i

        q = 0.0_wp
        if (allocated(error)) return
        allocate (r(basis%order, basis%order))
        poisson = merge(gel%poisson, 0.5_wp, is_drained)
        film = new_film(cmplx(poisson, 0.0_wp, wp), cmplx(poisson, 0.0_wp, wp), (0.0_wp, 0.0_wp))
        chi = 0.0_wp
        if (gel%ratio > 0.0_wp) then
            do i = 1, size(chi)
                call film%response(basis%k(i)/gel%ratio, normal_to, one_plus_chi, chi(i))
            end do
        end if
        call basis%project(2.0_wp*(1.0_wp - poisson)*chi, r)
        call add_to_diagonal(r, 1.0_wp - 2.0_wp*poisson)
        call solve_shape(r, flat, q, error)
    end subroutine solve_elastic

    !> (1 + matrix) w = shape.
    subroutine solve_shape(matrix, shape, w, error)
        complex(wp), intent(in) :: matrix(:, :)
        real(wp), intent(in) :: shape(2)
        complex(wp), intent(out) :: w(:)
        type(error_t), allocatable, intent(inout) :: error
        complex(wp) :: system(size(w), size(w))
        integer :: info

        w = 0.0_wp
        if (allocated(error)) return
        system = matrix
        call add_to_diagonal(system, 1.0_wp)
        w(:2) = shape
        call solve(system, w, info)
        if (info /= 0) call raise(error, error_no_convergence, "the contact of a gel could not be solved")
    end subroutine solve_shape

    pure subroutine add_to_diagonal(matrix, value)
        complex(wp), intent(inout) :: matrix(:, :)
        real(wp), intent(in) :: value
        integer :: i

        do i = 1, size(matrix, 1)
            matrix(i, i) = matrix(i, i) + value
        end do
    end subroutine add_to_diagonal

end module mdrcontact_poroelastic_contact
