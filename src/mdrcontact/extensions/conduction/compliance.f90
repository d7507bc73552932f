! SPDX-License-Identifier: GPL-3.0-or-later
!> The steady surface compliance of a conductor as the solver of the springs takes it: E_0* represents 2 S_0 (theory/conduction.md
!> (1.4), (2.1)).
!>
!> Unbounded layers on an insulating base have no finite conductance, chi grows as 1/(H_s k). What they are less one sheet of equal
!> conductance along the surface, coth(k H_s), is tabulated instead (mdrcontact_conduction_sink has the rest).
module mdrcontact_conduction_compliance
    use mdrcontact_body_compliance, only: compliance_t
    use mdrcontact_conduction_conductors, only: conductors_t, half_space_base, insulating_base
    use mdrcontact_kinds, only: wp
    implicit none (type, external)
    private
    public :: flux_compliance_t, new_flux_compliance

    !> Terms of the power series in k^2 of long waves over an insulating base.
    integer, parameter :: terms = 8

    !> Its numbers must only be read.
    type, extends(compliance_t) :: flux_compliance_t
        private
        type(conductors_t) :: body
        !> H_s of an insulating base; waves up to `longest` take the power series
        real(wp) :: sheet = 0.0_wp, longest = 0.0_wp
        !> coefficients of k^2 of (S_0 phi - J/H_s)/k^2 and of J = j/k^2 at the surface, phi = 1 at the base
        real(wp) :: above(0:terms) = 0.0_wp, beneath(0:terms) = 0.0_wp
    contains
        procedure :: chi => chi_of_flux
    end type flux_compliance_t

contains

    !> Create the compliance of a body.
    pure subroutine new_flux_compliance(self, body)
        type(flux_compliance_t), intent(out) :: self
        type(conductors_t), intent(in) :: body

        self%body = body
        self%scale = 2.0_wp*body%s(1)
        self%is_made = .true.
        if (body%layers == 0) return
        self%first_depth = body%h(1)
        self%last_depth = body%depth()
        select case (body%base)
        case (half_space_base)
            self%at_zero = body%s(1)/body%s(body%layers + 1)
        case (insulating_base)
            self%sheet = body%sheet()
            call expand(self)
        case default
            self%at_zero = 0.0_wp
        end select
    end subroutine new_flux_compliance

    !> Fields of long waves in powers of k^2, from the insulating base up.
    pure subroutine expand(self)
        type(flux_compliance_t), intent(inout) :: self
        real(wp), dimension(0:terms) :: phi, j, even, odd, next
        real(wp) :: h, factor
        integer :: i, m

        phi = 0.0_wp
        j = 0.0_wp
        phi(0) = 1.0_wp
        associate (body => self%body)
            do i = body%layers, 1, -1
                if (i < body%layers) phi(1:) = phi(1:) + body%r(i)*j(:terms - 1)
                h = body%h(i)
                factor = 1.0_wp
                do m = 0, terms
                    even(m) = factor
                    odd(m) = factor*h/real(2*m + 1, wp)
                    factor = factor*h**2/real((2*m + 1)*(2*m + 2), wp)
                end do
                next = product_of(even, phi)
                next(1:) = next(1:) + reshape(product_of(odd, j), [terms])/body%s(i)
                j = body%s(i)*product_of(odd, phi) + product_of(even, j)
                phi = next
            end do
            self%longest = 0.1_wp/max(3.0_wp*body%depth(), sqrt(sum(body%r(:body%layers - 1))*body%s(1)*self%sheet))
            self%above(:terms - 1) = body%s(1)*phi(1:) - j(1:)/self%sheet
        end associate
        self%beneath = j
    end subroutine expand

    pure function product_of(x, y) result(z)
        real(wp), intent(in) :: x(0:terms), y(0:terms)
        real(wp) :: z(0:terms)
        integer :: m

        do m = 0, terms
            z(m) = sum(x(0:m)*y(m:0:-1))
        end do
    end function product_of

    subroutine chi_of_flux(self, k, one_plus_chi, chi)
        class(flux_compliance_t), intent(in) :: self
        complex(wp), intent(in) :: k(:)
        complex(wp), intent(out) :: one_plus_chi(:), chi(:)
        complex(wp) :: fall
        integer :: i

        if (.not. self%sheet > 0.0_wp) then
            call self%body%response(k, (0.0_wp, 0.0_wp), one_plus_chi, chi)
            return
        end if
        do i = 1, size(k)
            if (abs(k(i)) < self%longest) then
                chi(i) = of_long_wave(self, k(i))
            else
                call self%body%response(k(i), (0.0_wp, 0.0_wp), one_plus_chi(i), chi(i))
                fall = exp(-2.0_wp*k(i)*self%sheet)
                if (abs(k(i)*self%sheet) < 0.3_wp) then
                    chi(i) = one_plus_chi(i) - 1.0_wp/tanh(k(i)*self%sheet)
                else
                    chi(i) = chi(i) - 2.0_wp*fall/(1.0_wp - fall)
                end if
            end if
            one_plus_chi(i) = 1.0_wp + chi(i)
        end do
    end subroutine chi_of_flux

    !> S_0 k C - coth x, x = k H_s, without 1/x, which both have.
    pure function of_long_wave(self, k) result(chi)
        class(flux_compliance_t), intent(in) :: self
        complex(wp), intent(in) :: k
        complex(wp) :: chi
        complex(wp) :: above, beneath, x, w
        integer :: m

        above = 0.0_wp
        beneath = 0.0_wp
        do m = terms, 0, -1
            above = above*k**2 + self%above(m)
            beneath = beneath*k**2 + self%beneath(m)
        end do
        x = k*self%sheet
        if (abs(x) < 0.3_wp) then
            w = x**2
            chi = x/3.0_wp*(1.0_wp - w/15.0_wp*(1.0_wp - w*2.0_wp/21.0_wp*(1.0_wp - w/10.0_wp*(1.0_wp - w*10.0_wp/99.0_wp &
                  *(1.0_wp - w*691.0_wp/6825.0_wp*(1.0_wp - w*70.0_wp/691.0_wp))))))
        else
            chi = 1.0_wp/tanh(x) - 1.0_wp/x
        end if
        chi = k*above/beneath - chi
    end function of_long_wave

end module mdrcontact_conduction_compliance
