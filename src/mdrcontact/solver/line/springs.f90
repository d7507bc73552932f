! SPDX-License-Identifier: GPL-3.0-or-later
!> The springs on a line to which a body comes exactly, E0* w = q + K q with K by the kernel X (theory/exact.md (1.2)), and what
!> follows from them without an indenter.
module mdrcontact_line_springs
    use, intrinsic :: iso_c_binding, only: c_int
    use mdrcontact_error, only: error_invalid, error_no_convergence, error_t, raise, to_text
    use mdrcontact_gsl, only: gsl_sf_ellint_ecomp, gsl_sf_ellint_kcomp
    use mdrcontact_kinds, only: pi, wp
    use mdrcontact_line_kernel, only: kernel_t
    use mdrcontact_line_legendre, only: interaction_matrix
    use mdrcontact_line_stiffness, only: relative_stiffness
    implicit none (type, external)
    private
    public :: springs_t

    !> Rings of friction up to this many thicknesses of the first layer, which their quadrature has to resolve.
    real(wp), parameter :: widest = 30.0_wp
    !> Even Legendre polynomials for the interaction of springs: so many, and so many more for each thickness in the contact radius.
    real(wp), parameter :: fewest_waves = 8.0_wp, waves_per_depth = 5.0_wp
    !> The number of points of their rule grows with the root of that ratio, which here exceeds every use.
    real(wp), parameter :: longest_contact = 1.0e12_wp

    !> Under one load. Free springs, those of a half-space, have a kernel that vanishes.
    type :: springs_t
        type(kernel_t) :: kernel
        !> E0*: of the half-space of the surface materials under that load [modulus]
        real(wp) :: modulus = 0.0_wp
        !> relative, of results
        real(wp) :: tolerance = 1.0e-10_wp
    contains
        procedure :: disc_products
        procedure :: interaction
        procedure :: torsional_stiffness
    end type springs_t

contains

    !> int u dA over discs around the axis, u the displacement by a pressure of 1 on another one. With it what rings of constant
    !> pressure do to each other is a sum of four terms.
    !>
    !> Integral of free springs, int of 4 sqrt(a^2 - x^2) sqrt(b^2 - x^2) dx over the smaller disc, by complete elliptic integrals
    !> of modulus b/a; of the kernel by Gauss and Chebyshev's rule of the second kind for both discs' springs 2 sqrt(r^2 - x^2).
    subroutine disc_products(self, radius, radii, products, error)
        class(springs_t), intent(in) :: self
        !> of the disc under pressure, and of the others [length]
        real(wp), intent(in) :: radius
        real(wp), intent(in) :: radii(:)
        !> (size(radii)) [length^3/modulus]
        real(wp), intent(out) :: products(:)
        type(error_t), allocatable, intent(inout) :: error
        real(wp), allocatable :: t(:), w(:), x(:)
        real(wp) :: total, a, b
        integer :: i, j, k, n

        if (max(radius, maxval(radii)) > widest*self%kernel%unit .and. .not. self%kernel%vanishes) then
            call raise(error, error_invalid, "rings of radius "//to_text(max(radius, maxval(radii)))//" are too large for a "// &
                       "first layer of thickness "//to_text(self%kernel%unit)//": at most "//to_text(widest)//" times that")
        end if
        if (allocated(error)) return
        do k = 1, size(radii)
            a = max(radius, radii(k))
            b = min(radius, radii(k))
            products(k) = a**2 + b**2
            if (b < a) products(k) = (a**2 + b**2)*gsl_sf_ellint_ecomp(b/a, 0_c_int) &
                                     - (a**2 - b**2)*gsl_sf_ellint_kcomp(b/a, 0_c_int)
            products(k) = 8.0_wp/3.0_wp*a/self%modulus*products(k)
        end do
        if (self%kernel%vanishes) return
        do k = 1, size(radii)
            n = 8 + 2*ceiling(2.0_wp*max(radius, radii(k))/self%kernel%unit)
            t = [(cos(pi*real(i, wp)/real(n + 1, wp)), i=1, n)]
            w = pi/real(n + 1, wp)*(1.0_wp - t**2)
            if (.not. allocated(x)) allocate (x(n))
            if (size(x) /= n) x = t
            total = 0.0_wp
            ! n is even, and both discs are the same on either side of the axis
            do j = 1, n/2
                call self%kernel%evaluate(abs(radius*t(j) - radii(k)*t)/self%kernel%unit, 0.0_wp, x)
                total = total + 2.0_wp*w(j)*dot_product(w, x)
            end do
            products(k) = products(k) + 4.0_wp*(radius*radii(k))**2*total/(pi*self%kernel%unit*self%modulus)
        end do
    end subroutine disc_products

    !> K between the even Legendre polynomials sqrt((4 j + 1)/2) P_2j(x/a) on -a < x < a, up to where waves are so short that they
    !> do not reach through the first layer: the 2j-th one has waves of about pi a/j, which a depth of h damps by exp(-4 j h/a).
    subroutine interaction(self, a, most, matrix, error)
        class(springs_t), intent(in) :: self
        !> [length]
        real(wp), intent(in) :: a
        !> how many polynomials at most
        integer, intent(in) :: most
        !> (0, 0) where springs are free [1]
        real(wp), allocatable, intent(out) :: matrix(:, :)
        type(error_t), allocatable, intent(inout) :: error
        integer :: n

        if (self%kernel%vanishes) then
            allocate (matrix(0, 0))
            return
        end if
        if (a > longest_contact*self%kernel%unit) then
            call raise(error, error_no_convergence, "a contact of radius "//to_text(a)//" is too large for a first layer of "// &
                       "thickness "//to_text(self%kernel%unit))
            return
        end if
        n = min(most, ceiling(min(fewest_waves + waves_per_depth*a/self%kernel%unit, real(most, wp))))
        call interaction_matrix(self%kernel, a, n, max(ceiling(16.0_wp*sqrt(a/self%kernel%unit)) + 14, 2*n), matrix, error)
    end subroutine interaction

    !> M/phi of springs under a twist, whose modulus is 4 G0: of a half-space (16/3) G a^3.
    subroutine torsional_stiffness(self, a, values, error)
        class(springs_t), intent(in) :: self
        !> contact radii [length]
        real(wp), intent(in) :: a(:)
        !> [modulus length^3]
        real(wp), intent(out) :: values(:)
        type(error_t), allocatable, intent(inout) :: error
        complex(wp) :: ratio
        integer :: i

        values = 0.0_wp
        do i = 1, size(a)
            if (allocated(error)) return
            call relative_stiffness([self%kernel], a(i), self%tolerance, .true., ratio, error)
            values(i) = 4.0_wp/3.0_wp*self%modulus*a(i)**3*real(ratio, wp)
        end do
    end subroutine torsional_stiffness

end module mdrcontact_line_springs
