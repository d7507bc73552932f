! SPDX-License-Identifier: GPL-3.0-or-later
!> A spot with a film in it at one Laplace variable: the equation of mdrcontact_conduction_film with chi(k, s), which falls as k^-2
!> (theory/conduction.md (4.3)-(4.5)).
module mdrcontact_conduction_film_in_time
    use mdrcontact_conduction_bodies, only: conduction_t
    use mdrcontact_conduction_film, only: of_half_space, odd_waves
        use mdrcontact_error, only: error_no_convergence, error_t, raise, to_text
    use mdrcontact_kinds, only: pi, wp
    use mdrcontact_lapack, only: dgemm
    use mdrcontact_numerics_waves, only: wave_rule
    implicit none (type, external)
    private
    public :: film_basis_t, new_film_basis, film_spot_at

    !> Terms, and half of them for the extrapolation.
    integer, parameter :: terms = 96
    !> What the extrapolation may change, relative.
    real(wp), parameter :: allowed = 1.0e-8_wp

    !> J_1, J_3, ... at the nodes of a rule.
    type :: film_basis_t
        real(wp), allocatable :: z(:), weight(:), waves(:, :)
    end type film_basis_t

contains

    !> For Laplace variables up to this size.
    subroutine new_film_basis(self, conduction, a, largest, error)
        type(film_basis_t), intent(out) :: self
        type(conduction_t), intent(in) :: conduction
        real(wp), intent(in) :: a, largest
        type(error_t), allocatable, intent(inout) :: error
        real(wp) :: last
        integer :: i

        last = max(20.0_wp*conduction%radius_in_layers(a), 4.0_wp*terms, 1200.0_wp*sqrt(conduction%waves_in(a, largest)))
        call wave_rule(1.0e-9_wp, last, 2.0_wp, self%z, self%weight, error)
        if (allocated(error)) return
        allocate (self%waves(terms, size(self%z)))
        do i = 1, size(self%z)
            call odd_waves(self%z(i), self%waves(:, i))
        end do
        self%weight = self%weight/self%z**2
    end subroutine new_film_basis

    !> G.
    subroutine film_spot_at(conduction, a, s, basis, conductance, error)
        type(conduction_t), intent(in) :: conduction
        real(wp), intent(in) :: a
        complex(wp), intent(in) :: s
        type(film_basis_t), intent(in) :: basis
        complex(wp), intent(out) :: conductance
        type(error_t), allocatable, intent(inout) :: error
        real(wp), allocatable :: scaled(:, :), product(:, :)
        complex(wp), allocatable :: matrix(:, :)
        complex(wp) :: chi, y(terms), partial
        integer :: i, j

        conductance = 0.0_wp
        if (allocated(error)) return
        allocate (scaled(2*terms, size(basis%z)), product(2*terms, terms), matrix(terms, terms))
        do i = 1, size(basis%z)
            chi = conduction%chi(cmplx(basis%z(i)/a, 0.0_wp, wp), s)*basis%weight(i)
            scaled(:terms, i) = real(chi, wp)*basis%waves(:, i)
            scaled(terms + 1:, i) = aimag(chi)*basis%waves(:, i)
        end do
        call dgemm("N", "T", 2*terms, terms, size(basis%z), 1.0_wp, scaled, 2*terms, basis%waves, terms, 0.0_wp, product, 2*terms)
        matrix = cmplx(product(:terms, :), product(terms + 1:, :), wp)
        do j = 1, terms
            do i = 1, terms
                matrix(i, j) = a**3/conduction%scale*(matrix(i, j) + of_half_space(i - 1, j - 1))
            end do
            matrix(j, j) = matrix(j, j) + 0.5_wp*a**2*conduction%film/(2*j - 1)
        end do
        y = 0.0_wp
        y(1) = 0.5_wp*a**2
        partial = 0.0_wp
        do j = 1, terms
            conductance = conductance + 2.0_wp*pi*y(j)**2/matrix(j, j)
            if (j == terms/2) partial = conductance
            do i = j + 1, terms
                y(i) = y(i) - matrix(i, j)/matrix(j, j)*y(j)
                matrix(i:, i) = matrix(i:, i) - matrix(i, j)/matrix(j, j)*matrix(i:, j)
            end do
        end do
        partial = (conductance - partial)/63.0_wp
        if (.not. abs(partial) <= allowed*abs(conductance)) then
            call raise(error, error_no_convergence, "the flux through a film of resistance "//to_text(conduction%film)// &
                       " in a spot of radius "//to_text(a)//" is off by about "//to_text(abs(partial/conductance))// &
                       " in time: its edge is too thin")
        end if
        conductance = conductance + partial
    end subroutine film_spot_at

end module mdrcontact_conduction_film_in_time
