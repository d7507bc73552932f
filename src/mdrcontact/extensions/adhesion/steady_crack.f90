! SPDX-License-Identifier: GPL-3.0-or-later
!> A crack along a viscoelastic surface that moves at a constant speed under a constant cohesive stress sigma_0: what its work of
!> adhesion seems to be to the relaxed body around (Greenwood, Johnson, Phil. Mag. A 43 (1981) 697; Schapery, Int. J. Fracture 11
!> (1975) 141): theory/adhesion.md (4.1)-(4.3). J(t) is the creep compliance of 1/E*, l the length of the cohesive zone, x = l/v:
!>     opening:  m = int_0^1 J(x u) A(u) du,        G/gamma0 = J(inf)/m,                               l = pi gamma0/(4 sigma_0^2 m)
!>     closing:  m = int_0^1 J(x u) [B - A](u) du,  G/gamma0 = [int_0^1 J(x u) B(u) du]^2/(4 J(inf) m),     l as before
!> with A(u) = arcosh(u^(-1/2)), B(u) = (1 - u)^(-1/2), whose integrals are 1 and 2.
module mdrcontact_adhesion_steady_crack
    use mdrcontact_error, only: error_invalid, error_t, raise
    use mdrcontact_kinds, only: pi, wp
    use mdrcontact_material_prony, only: creep_of, creep_t, risen
    use mdrcontact_material_rheology, only: rheology_t
    use mdrcontact_numerics_quadrature, only: gauss_legendre
    use mdrcontact_numerics_roots, only: find_root
    use mdrcontact_numerics_sampled_function, only: new_sampled_function, sampled_function_t
    use mdrcontact_numerics_scalar_function, only: scalar_function_t
    implicit none (type, external)
    private
    public :: crack_integrals_t, new_crack_integrals, crack_point_t, steady_crack_t, new_steady_crack

    !> Panels towards u = 0, each a quarter of the one before, and nodes in each.
    integer, parameter :: panels = 27, nodes = 20, points = panels*nodes
    real(wp), parameter :: shrinks = 0.25_wp
    !> The speed is sampled over ln((G - gamma0)/(G_glassy - G)) from -span to span, where it is a straight line beyond.
    real(wp), parameter :: span = 22.0_wp
    !> Beyond this the speed does not grow: an edge under more than the glassy work has no steady speed.
    real(wp), parameter :: fastest = 60.0_wp
    !> Smallest and largest l/v considered, in the shortest and longest time of creep, as logarithms.
    real(wp), parameter :: reach = 30.0_wp
    real(wp), parameter :: tolerance = 1.0e-10_wp

    !> A crack at one x.
    type :: crack_point_t
        !> G/gamma0; m [1/modulus]
        real(wp) :: ratio = 1.0_wp, compliance = 0.0_wp
        !> ln of |G - gamma0| over the distance of G from its glassy limit
        real(wp) :: place = 0.0_wp
    end type crack_point_t

    !> Integrals over J, in u = w (2 - w).
    type, extends(scalar_function_t) :: crack_integrals_t
        type(creep_t) :: creep
        real(wp), private :: u(points) = 0.0_wp, weight_a(points) = 0.0_wp, weight_b(points) = 0.0_wp
        !> opening (1) or closing (2), and the place that is searched for
        integer, private :: side = 1
        real(wp), private :: wanted = 0.0_wp
    contains
        procedure :: at
        procedure :: value => place_less_wanted
        procedure, private :: parts
    end type crack_integrals_t

    !> ln(v sigma_0^2/gamma0) as a function of the place.
    type, extends(scalar_function_t) :: speed_t
        type(crack_integrals_t) :: integrals
    contains
        procedure :: value => logarithmic_speed
    end type speed_t

    !> The speed over G, opening (1) and closing (2).
    type :: steady_crack_t
        !> J(0)/J(inf); the longest time of creep [time]; 1/J(inf) [modulus]
        real(wp) :: glassy = 0.0_wp, longest = 0.0_wp, relaxed_modulus = 0.0_wp
        type(sampled_function_t), private :: speeds(2)
    contains
        procedure :: speed_at
        procedure :: ratio_at
    end type steady_crack_t

contains

    !> The nodes, and J of a creeping solid.
    subroutine new_crack_integrals(self, creep, error)
        type(crack_integrals_t), intent(out) :: self
        type(creep_t), intent(in) :: creep
        type(error_t), allocatable, intent(inout) :: error
        real(wp) :: place(nodes), weight(nodes), w(nodes), from, to
        integer :: i, first

        self%creep = creep
        call gauss_legendre(place, weight, error)
        to = 1.0_wp
        do i = 1, panels
            from = merge(0.0_wp, shrinks*to, i == panels)
            first = (i - 1)*nodes
            w = from + (to - from)*place
            self%u(first + 1:first + nodes) = w*(2.0_wp - w)
            ! u = 1 - y^2, y = 1 - w: A = artanh y, B = 1/y, du = 2 y dw
            self%weight_a(first + 1:first + nodes) = (to - from)*weight*(1.0_wp - w)*log((2.0_wp - w)/w)
            self%weight_b(first + 1:first + nodes) = 2.0_wp*(to - from)*weight
            to = from
        end do
    end subroutine new_crack_integrals

    !> int [J(inf) - J(x u)] A and B, and int [J(x u) - J(0)] A and B, without cancellation.
    pure subroutine parts(self, x, missing_a, missing_b, crept_a, crept_b)
        class(crack_integrals_t), intent(in) :: self
        real(wp), intent(in) :: x
        real(wp), intent(out) :: missing_a, missing_b, crept_a, crept_b
        real(wp) :: decayed(points), grown(points)
        integer :: i

        missing_a = 0.0_wp
        missing_b = 0.0_wp
        crept_a = 0.0_wp
        crept_b = 0.0_wp
        do i = 1, size(self%creep%rate)
            grown = risen(self%creep%rate(i)*x*self%u)
            decayed = exp(-self%creep%rate(i)*x*self%u)
            missing_a = missing_a + self%creep%weight(i)*dot_product(decayed, self%weight_a)
            missing_b = missing_b + self%creep%weight(i)*dot_product(decayed, self%weight_b)
            crept_a = crept_a + self%creep%weight(i)*dot_product(grown, self%weight_a)
            crept_b = crept_b + self%creep%weight(i)*dot_product(grown, self%weight_b)
        end do
    end subroutine parts

    !> The crack at x = l/v.
    pure function at(self, side, x) result(point)
        class(crack_integrals_t), intent(in) :: self
        !> 1: opening, 2: closing
        integer, intent(in) :: side
        !> > 0 [time]
        real(wp), intent(in) :: x
        type(crack_point_t) :: point
        real(wp) :: relaxed, missing_a, missing_b, crept_a, crept_b

        call self%parts(x, missing_a, missing_b, crept_a, crept_b)
        associate (glassy => self%creep%instant)
            relaxed = glassy + sum(self%creep%weight)
            if (side == 1) then
                point%compliance = glassy + crept_a
                point%ratio = relaxed/point%compliance
                point%place = log(missing_a*glassy/(relaxed*crept_a))
            else
                point%compliance = glassy + crept_b - crept_a
                point%ratio = (2.0_wp*glassy + crept_b)**2/(4.0_wp*relaxed*point%compliance)
                point%place = log((4.0_wp*relaxed*missing_a - missing_b**2)/(4.0_wp*glassy*crept_a + crept_b**2))
            end if
        end associate
    end function at

    function place_less_wanted(self, x) result(y)
        class(crack_integrals_t), intent(inout) :: self
        !> ln of l/v
        real(wp), intent(in) :: x
        real(wp) :: y
        type(crack_point_t) :: point

        point = self%at(self%side, exp(x))
        y = self%wanted - point%place
    end function place_less_wanted

    function logarithmic_speed(self, x) result(y)
        class(speed_t), intent(inout) :: self
        !> place
        real(wp), intent(in) :: x
        real(wp) :: y
        type(crack_point_t) :: point
        real(wp) :: root

        self%integrals%wanted = x
        associate (rate => self%integrals%creep%rate)
            call find_root(self%integrals, -reach - log(maxval(rate)), reach - log(minval(rate)), root, self%error)
        end associate
        point = self%integrals%at(self%integrals%side, exp(root))
        y = log(pi/(4.0_wp*point%compliance)) - root
    end function logarithmic_speed

    !> Samples the speeds of a solid's surface.
    subroutine new_steady_crack(self, material, error)
        type(steady_crack_t), intent(out) :: self
        type(rheology_t), intent(in) :: material
        type(error_t), allocatable, intent(out) :: error
        type(speed_t) :: speed
        type(creep_t) :: creep
        integer :: side

        if (material%is_power_law() .or. .not. material%has_glassy() .or. .not. material%shear%limit > 0.0_wp &
            .or. material%is_elastic()) then
            call raise(error, error_invalid, ": it needs a glassy and a relaxed modulus", "material")
            return
        end if
        creep = creep_of(material%contact_series(1.0_wp, 1.0_wp))
        call new_crack_integrals(speed%integrals, creep, error)
        do side = 1, 2
            speed%integrals%side = side
            if (.not. allocated(error)) call new_sampled_function(self%speeds(side), speed, [-span, 0.0_wp, span], &
                                                                  [logical ::], tolerance, error, least_size=1.0_wp)
        end do
        if (allocated(error)) return
        self%relaxed_modulus = 1.0_wp/(creep%instant + sum(creep%weight))
        self%glassy = creep%instant*self%relaxed_modulus
        self%longest = 1.0_wp/minval(creep%rate)
    end subroutine new_steady_crack

    !> v sigma_0^2/gamma0 and its slope over G/gamma0, > 0 where it opens.
    pure subroutine speed_at(self, ratio, v, slope)
        class(steady_crack_t), intent(in) :: self
        !> G/gamma0 >= 0
        real(wp), intent(in) :: ratio
        real(wp), intent(out) :: v, slope
        real(wp) :: from, limit, place

        v = 0.0_wp
        slope = 0.0_wp
        from = abs(ratio - 1.0_wp)
        if (.not. from > 0.0_wp) return
        limit = merge(1.0_wp/self%glassy - ratio, ratio - self%glassy, ratio > 1.0_wp)
        place = fastest
        if (limit > 0.0_wp) place = min(fastest, log(from/limit))
        call logarithm(self, merge(1, 2, ratio > 1.0_wp), place, v, slope)
        v = sign(exp(v), ratio - 1.0_wp)
        slope = abs(v)*slope*(1.0_wp/from + 1.0_wp/max(limit, tiny(limit)))
        if (.not. place < fastest) slope = 0.0_wp
    end subroutine speed_at

    !> ln of the speed and its slope over the place; a straight line beyond the samples.
    pure subroutine logarithm(self, side, place, value, slope)
        class(steady_crack_t), intent(in) :: self
        integer, intent(in) :: side
        real(wp), intent(in) :: place
        real(wp), intent(out) :: value, slope
        real(wp) :: inside

        inside = min(max(place, -span), span)
        slope = self%speeds(side)%slope(inside)
        value = self%speeds(side)%value(inside) + slope*(place - inside)
    end subroutine logarithm

    !> G/gamma0 of an edge of speed v sigma_0^2/gamma0.
    pure function ratio_at(self, v) result(ratio)
        class(steady_crack_t), intent(in) :: self
        real(wp), intent(in) :: v
        real(wp) :: ratio
        real(wp) :: low, high, place, value, slope, limit
        integer :: i

        ratio = 1.0_wp
        if (.not. abs(v) > 0.0_wp) return
        low = -700.0_wp
        high = fastest
        do i = 1, 100
            place = 0.5_wp*(low + high)
            call logarithm(self, merge(1, 2, v > 0.0_wp), place, value, slope)
            if (value < log(abs(v))) then
                low = place
            else
                high = place
            end if
        end do
        limit = merge(1.0_wp/self%glassy, self%glassy, v > 0.0_wp)
        ratio = 1.0_wp + (limit - 1.0_wp)/(1.0_wp + exp(-place))
    end function ratio_at

end module mdrcontact_adhesion_steady_crack
