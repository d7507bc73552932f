! SPDX-License-Identifier: GPL-3.0-or-later
!> A structure given by functions G(x, y, z) and nu(x, y, z): E_eff by a product rule in oblate spheroidal coordinates
!> (theory/lateral.md (2.8)).
!>
!> There the weights are smooth up to the edge of the contact. The rule converges exponentially for smooth functions; for those with
!> jumps it is slow, and shapes or voxels are the better description.
module mdrcontact_lateral_field
    use mdrcontact_nonfinite, only: is_finite
    use mdrcontact_cancel, only: check_cancelled
    use mdrcontact_error, only: check_made, check_memory, check_poisson, check_within, error_callback, error_no_convergence, &
                                error_t, raise, to_text
    use mdrcontact_kinds, only: pi, wp
    use mdrcontact_lateral_density, only: lateral_density_spheroidal
    use mdrcontact_lateral_structure, only: structure_t
    use mdrcontact_numerics_power_mean, only: new_power_mean, power_mean_t
    use mdrcontact_numerics_quadrature, only: gauss_legendre
    implicit none (type, external)
    private
    public :: field_t, field_structure_t, new_field_structure, space_rule, space_rule_size

    real(wp), parameter :: default_tolerance = 1.0e-5_wp
    integer, parameter :: lowest_order = 8, highest_order = 64

    !> Material at a point; extend it with the data it needs. A failed evaluation allocates `error`.
    type, abstract :: field_t
    contains
        !> G > 0 [modulus] and nu [1] at a point (x, y, z) of the half-space z > 0 [length]
        procedure(material_at), deferred :: material
    end type field_t

    abstract interface
        !> G > 0 and nu at a point of the half-space z > 0.
        subroutine material_at(self, x, y, z, shear, poisson, error)
            import :: error_t, field_t, wp
            class(field_t), intent(in) :: self
            real(wp), intent(in) :: x, y, z
            real(wp), intent(out) :: shear, poisson
            type(error_t), allocatable, intent(inout) :: error
        end subroutine material_at
    end interface

    !> Unlike other objects it keeps the user's function and calls it in every evaluation.
    type, extends(structure_t) :: field_structure_t
        private
        class(field_t), allocatable :: field
        real(wp) :: tolerance = default_tolerance
    contains
        procedure :: means
        procedure :: calls_user => yes
    end type field_structure_t

contains

    pure function yes(self) result(answer)
        class(field_structure_t), intent(in) :: self
        logical :: answer

        associate (unused => self)
        end associate
        answer = .true.
    end function yes

    !> A structure of the given field.
    subroutine new_field_structure(self, field, reference_nu, error, tolerance, exponent)
        type(field_structure_t), intent(out) :: self
        class(field_t), intent(in) :: field
        !> Poisson's ratio of the weights, -1 < nu <= 1/2
        real(wp), intent(in) :: reference_nu
        type(error_t), allocatable, intent(out) :: error
        !> relative error of G_eff and nu_eff, 1e-10 to 0.1; default 1e-5
        real(wp), intent(in), optional :: tolerance
        !> of the mean of G, -1 (series) to 1 (parallel); default 1
        real(wp), intent(in), optional :: exponent
        type(power_mean_t) :: mean

        allocate (self%field, source=field)
        self%reference_nu = reference_nu
        if (present(tolerance)) self%tolerance = tolerance
        if (present(exponent)) self%exponent = exponent
        call new_power_mean(mean, self%exponent, [1.0_wp], error)
        call check_poisson(error, "reference_nu", reference_nu)
        call check_within(error, "tolerance", self%tolerance, 1.0e-10_wp, 0.1_wp)
        self%is_made = .not. allocated(error)
    end subroutine new_field_structure

    subroutine means(self, x, y, a, exponent, shear, poisson, error)
        class(field_structure_t), intent(in) :: self
        real(wp), intent(in) :: x, y, a, exponent
        real(wp), intent(out) :: shear, poisson
        type(error_t), allocatable, intent(out) :: error
        real(wp) :: before(2), found(2), difference(2)
        integer :: order

        shear = 0.0_wp
        poisson = 0.0_wp
        call check_made(error, "structure", self%is_made)
        if (allocated(error)) return
        ! far from any result, and a ratio to one is still a number
        found = sqrt(huge(1.0_wp))
        order = lowest_order
        do
            before = found
            call sum_at_order(self, order, x, y, a, exponent, found, error)
            if (allocated(error)) return
            difference = abs(found - before)/[found(1), 1.0_wp - found(2)]
            if (all(difference <= self%tolerance)) exit
            order = 2*order
            if (order > highest_order) then
                call raise(error, error_no_convergence, "E_eff at x = "//to_text(x)//", y = "//to_text(y)//", a = "//to_text(a)// &
                           " has an error of "//to_text(maxval(difference))//", and the tolerance is "//to_text(self%tolerance))
                return
            end if
        end do
        shear = found(1)
        poisson = found(2)
    end subroutine means

    subroutine sum_at_order(self, order, x, y, a, exponent, found, error)
        class(field_structure_t), intent(in) :: self
        integer, intent(in) :: order
        real(wp), intent(in) :: x, y, a, exponent
        real(wp), intent(out) :: found(2)
        type(error_t), allocatable, intent(out) :: error
        type(power_mean_t) :: mean
        real(wp), allocatable :: points(:, :), weights(:, :), shear(:), poisson(:)
        integer :: i, n, stat

        n = space_rule_size(order)
        allocate (points(3, n), weights(2, n), shear(n), poisson(n), stat=stat)
        call check_memory(error, stat)
        if (stat /= 0) return
        call space_rule(order, self%reference_nu, points, weights, error)
        if (allocated(error)) return
        found = 0.0_wp
        do i = 1, n
            call check_cancelled(error)
            if (allocated(error)) return
            call self%field%material(x + a*points(1, i), y + a*points(2, i), a*points(3, i), shear(i), poisson(i), error)
            if (.not. allocated(error)) call check_material(shear(i), poisson(i), error)
            if (allocated(error)) return
        end do
        call new_power_mean(mean, exponent, shear, error)
        if (allocated(error)) return
        ! in one statement gfortran would copy
        do i = 1, n
            shear(i) = mean%transformed(shear(i))
        end do
        ! differences from the first point: a homogeneous structure returns itself exactly
        do i = 1, n
            found = found + weights(:, i)*[shear(i) - shear(1), poisson(i) - poisson(1)]
        end do
        found = [mean%mean(found(1) + shear(1)), found(2) + poisson(1)]
    end subroutine sum_at_order

    pure subroutine check_material(shear, poisson, error)
        real(wp), intent(in) :: shear, poisson
        type(error_t), allocatable, intent(inout) :: error

        if (is_finite(shear) .and. is_finite(poisson)) then
            if (shear > 0.0_wp .and. poisson > -1.0_wp .and. poisson <= 0.5_wp) return
        end if
        call raise(error, error_callback, "the function of the structure returned G = "//to_text(shear)//", nu = "// &
                   to_text(poisson)//": G must be greater than 0, and nu greater than -1 and at most 0.5")
    end subroutine check_material

    !> Number of points of the rule of this order.
    elemental function space_rule_size(order) result(count)
        integer, intent(in) :: order
        integer :: count

        count = 6*order**3
    end function space_rule_size

    !> Points (3, n) in units of a and their weights (2, n) for G and for nu; each row of weights has sum 1.
    subroutine space_rule(order, nu, points, weights, error)
        integer, intent(in) :: order
        real(wp), intent(in) :: nu
        real(wp), intent(out) :: points(:, :), weights(:, :)
        type(error_t), allocatable, intent(inout) :: error
        real(wp) :: u(order), w(order), s(3), t(3), jacobian(3), shear, poisson, rho, angle
        integer :: i, j, part, k, n

        call gauss_legendre(u, w, error)
        n = 0
        do j = 1, order
            call check_cancelled(error)
            if (allocated(error)) return
            do i = 1, order
                ! two triangles that meet at the edge of the contact, and all that is further than s = 1
                s = [u(i), u(i)*u(j), 1.0_wp/u(i)]
                t = [u(i)*u(j), u(i), u(j)]
                jacobian = [u(i), u(i), s(3)**2]
                do part = 1, 3
                    call lateral_density_spheroidal(s(part), t(part), nu, shear, poisson)
                    rho = sqrt((1.0_wp + s(part)**2)*(1.0_wp - t(part))*(1.0_wp + t(part)))
                    do k = 1, 2*order
                        n = n + 1
                        angle = pi*(k - 0.5_wp)/order
                        points(:, n) = [rho*cos(angle), rho*sin(angle), s(part)*t(part)]
                        weights(:, n) = [shear, poisson]*(w(i)*w(j)*jacobian(part)*(s(part)**2 + t(part)**2)*pi/order)
                    end do
                end do
            end do
        end do
        ! the last significant digits of a finite order: the mean of a constant is that constant
        weights(1, :) = weights(1, :)/sum(weights(1, :))
        weights(2, :) = weights(2, :)/sum(weights(2, :))
    end subroutine space_rule

end module mdrcontact_lateral_field
