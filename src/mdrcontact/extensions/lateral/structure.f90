! SPDX-License-Identifier: GPL-3.0-or-later
!> Interface of a laterally heterogeneous structure: its effective moduli for a contact of radius a at (x, y) (theory/lateral.md
!> (1.2)).
module mdrcontact_lateral_structure
    use mdrcontact_error, only: check_finite, check_made, check_positive, error_no_convergence, error_t, raise, to_text
    use mdrcontact_kinds, only: wp
    implicit none (type, external)
    private
    public :: structure_t

    !> A half-space z > 0 whose moduli vary in all three directions. It never changes under evaluation.
    type, abstract :: structure_t
        !> whether it was made: set last by what makes it
        logical :: is_made = .false.
        !> Poisson's ratio of the reference medium, whose flat-punch field gives the weights
        real(wp) :: reference_nu = 0.5_wp
        !> p of the power mean G_eff = [sum w G^p]^(1/p): 1 in parallel, -1 in series, 0 the mean of the logarithms
        real(wp) :: exponent = 1.0_wp
    contains
        !> G_eff [modulus] and nu_eff [1] for a contact of radius a > 0 at (x, y) [length]
        procedure(weighted_means), deferred :: means
        procedure :: modulus
        procedure :: modulus_at
        procedure :: bounds
        !> whether it calls a user's function, which stays on the calling thread
        procedure :: calls_user => no
    end type structure_t

    abstract interface
        !> G_eff = [int W_shear G^p dV/a^3]^(1/p) and nu_eff = int W_poisson nu dV/a^3.
        subroutine weighted_means(self, x, y, a, exponent, shear, poisson, error)
            import :: error_t, structure_t, wp
            class(structure_t), intent(in) :: self
            !> centre of the contact and its radius a > 0 [length]
            real(wp), intent(in) :: x, y, a
            !> p, -1 to 1
            real(wp), intent(in) :: exponent
            !> G_eff [modulus] and nu_eff [1]
            real(wp), intent(out) :: shear, poisson
            type(error_t), allocatable, intent(out) :: error
        end subroutine weighted_means
    end interface

contains

    pure function no(self) result(answer)
        class(structure_t), intent(in) :: self
        logical :: answer

        associate (unused => self)
        end associate
        answer = .false.
    end function no

    !> E_eff(a, x, y) = 2 G_eff/(1 - nu_eff), equation (33) [modulus], at one place and one radius.
    subroutine modulus_at(self, x, y, a, value, error, exponent)
        class(structure_t), intent(in) :: self
        !> centre of the contact and its radius a > 0 [length]
        real(wp), intent(in) :: x, y, a
        !> E_eff [modulus]
        real(wp), intent(out) :: value
        type(error_t), allocatable, intent(out) :: error
        !> that of the mean, -1 to 1; default: the structure's own
        real(wp), intent(in), optional :: exponent
        real(wp) :: shear, poisson, p

        value = 0.0_wp
        call check_made(error, "structure", self%is_made)
        if (allocated(error)) return
        p = self%exponent
        if (present(exponent)) p = exponent
        call check_finite(error, "x", x)
        call check_finite(error, "y", y)
        call check_positive(error, "a", a)
        if (allocated(error)) return
        call self%means(x, y, a, p, shear, poisson, error)
        if (allocated(error)) return
        if (.not. shear > 0.0_wp) then
            call raise(error, error_no_convergence, "E_eff at x = "//to_text(x)//", y = "//to_text(y)//", a = "//to_text(a)// &
                       " is not determined: the moduli differ by too many orders of magnitude")
            return
        end if
        value = 2.0_wp*shear/(1.0_wp - poisson)
    end subroutine modulus_at

    !> E_eff(a, x, y) at several places and radii: along a line, at one place for many radii, ...
    subroutine modulus(self, x, y, a, values, error, exponent)
        class(structure_t), intent(in) :: self
        !> all of equal size [length]
        real(wp), intent(in) :: x(:), y(:), a(:)
        !> E_eff [modulus], same size
        real(wp), intent(out) :: values(:)
        type(error_t), allocatable, intent(out) :: error
        !> as in modulus_at
        real(wp), intent(in), optional :: exponent
        integer :: i

        values = 0.0_wp
        call check_made(error, "structure", self%is_made)
        if (allocated(error)) return
        do i = 1, size(values)
            call self%modulus_at(x(i), y(i), a(i), values(i), error, exponent)
            if (allocated(error)) return
        end do
    end subroutine modulus

    !> The bracket of E_eff(a, x, y) [modulus]: with the mean of G in series below, in parallel above. At one Poisson's ratio the
    !> exact E_eff lies between them, for any contrast (theory/lateral.md (3.1)).
    subroutine bounds(self, x, y, a, lower, upper, error)
        class(structure_t), intent(in) :: self
        !> all of equal size [length]
        real(wp), intent(in) :: x(:), y(:), a(:)
        !> same size [modulus]
        real(wp), intent(out) :: lower(:), upper(:)
        type(error_t), allocatable, intent(out) :: error

        upper = 0.0_wp
        call check_made(error, "structure", self%is_made)
        if (allocated(error)) return
        call self%modulus(x, y, a, lower, error, -1.0_wp)
        if (.not. allocated(error)) call self%modulus(x, y, a, upper, error, 1.0_wp)
    end subroutine bounds

end module mdrcontact_lateral_structure
