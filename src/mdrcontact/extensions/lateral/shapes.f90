! SPDX-License-Identifier: GPL-3.0-or-later
!> A structure made of bodies in a background material: E_eff by quadrature over depths, radii and exact arcs (theory/lateral.md
!> (1.2)).
module mdrcontact_lateral_shapes
    use, intrinsic :: iso_c_binding, only: c_size_t
    use mdrcontact_cancel, only: check_cancelled
    use mdrcontact_error, only: check_made, check_poisson, check_within, error_no_convergence, error_t, raise, to_text
    use mdrcontact_gsl, only: gsl_sort
    use mdrcontact_kinds, only: pi, wp
    use mdrcontact_lateral_breaks, only: depths_between, radii_between
    use mdrcontact_lateral_density, only: lateral_density
    use mdrcontact_lateral_panels, only: depth_rule, radius_rule, rule_t
    use mdrcontact_lateral_section, only: crossing_angles, holds, is_round, most_crossings, nothing, section_t
    use mdrcontact_lateral_shape, only: section_at, shape_t
    use mdrcontact_lateral_structure, only: structure_t
    use mdrcontact_material, only: material_t
    use mdrcontact_numerics_power_mean, only: new_power_mean, power_mean_t
    use mdrcontact_numerics_quadrature, only: gauss_legendre
    implicit none (type, external)
    private
    public :: shapes_t, new_shapes

    real(wp), parameter :: default_tolerance = 1.0e-5_wp
    integer, parameter :: fewest_nodes = 5, most_nodes = 40

    !> Bodies in a background; where they overlap, the later one is there.
    type, extends(structure_t) :: shapes_t
        private
        type(material_t) :: background
        type(shape_t), allocatable :: shapes(:)
        real(wp) :: tolerance = default_tolerance
    contains
        procedure :: means
    end type shapes_t

contains

    !> A background half-space with bodies in it.
    subroutine new_shapes(self, background, shapes, error, reference_nu, tolerance, exponent)
        type(shapes_t), intent(out) :: self
        type(material_t), intent(in) :: background
        !> none is allowed
        type(shape_t), intent(in) :: shapes(:)
        type(error_t), allocatable, intent(out) :: error
        !> Poisson's ratio of the weights, -1 < nu <= 1/2; default: that of the background
        real(wp), intent(in), optional :: reference_nu
        !> relative error of G_eff and nu_eff, 1e-10 to 0.1; default 1e-5
        real(wp), intent(in), optional :: tolerance
        !> of the mean of G, -1 (series) to 1 (parallel); default 1
        real(wp), intent(in), optional :: exponent
        type(power_mean_t) :: mean

        call check_made(error, "background", background%young > 0.0_wp)
        call check_made(error, "shapes", all(shapes%is_made))
        if (allocated(error)) return
        self%background = background
        self%shapes = shapes
        self%reference_nu = background%poisson
        if (present(reference_nu)) self%reference_nu = reference_nu
        if (present(tolerance)) self%tolerance = tolerance
        if (present(exponent)) self%exponent = exponent
        call new_power_mean(mean, self%exponent, [background%shear()], error)
        call check_poisson(error, "reference_nu", self%reference_nu)
        call check_within(error, "tolerance", self%tolerance, 1.0e-10_wp, 0.1_wp)
        self%is_made = .not. allocated(error)
    end subroutine new_shapes

    !> Rules of rising order until two agree.
    subroutine means(self, x, y, a, exponent, shear, poisson, error)
        class(shapes_t), intent(in) :: self
        real(wp), intent(in) :: x, y, a, exponent
        real(wp), intent(out) :: shear, poisson
        type(error_t), allocatable, intent(out) :: error
        type(power_mean_t) :: mean
        real(wp) :: moduli(0:size(self%shapes)), contrast(2, size(self%shapes)), excess(2), before(2), scale(2)
        integer :: nodes

        call check_made(error, "structure", self%is_made)
        if (allocated(error)) return
        shear = self%background%shear()
        poisson = self%background%poisson
        if (size(self%shapes) == 0) return
        moduli(0) = shear
        moduli(1:) = self%shapes%material%shear()
        call new_power_mean(mean, exponent, moduli, error)
        if (allocated(error)) return
        moduli = mean%transformed(moduli)
        contrast(1, :) = moduli(1:) - moduli(0)
        contrast(2, :) = self%shapes%material%poisson - poisson
        nodes = fewest_nodes
        call excess_means(self, contrast, x, y, a, nodes, excess, error)
        do
            before = excess
            nodes = 2*nodes
            call excess_means(self, contrast, x, y, a, nodes, excess, error)
            if (allocated(error)) return
            scale = [min(mean%relative_unit(moduli(0)), mean%relative_unit(moduli(0) + excess(1))), 1.0_wp - poisson - excess(2)]
            if (all(abs(excess - before) <= self%tolerance*scale)) exit
            if (2*nodes > most_nodes) then
                call raise(error, error_no_convergence, "E_eff at x = "//to_text(x)//", y = "//to_text(y)//", a = "//to_text(a)// &
                           " has an error of "//to_text(maxval(abs(excess - before)/scale))//", and the tolerance is "// &
                           to_text(self%tolerance))
                return
            end if
        end do
        shear = mean%mean(moduli(0) + excess(1))
        poisson = poisson + excess(2)
    end subroutine means

    !> Contribution of the bodies to the background's sums for G and nu, with a given number of nodes in a panel.
    subroutine excess_means(self, contrast, x, y, a, nodes, excess, error)
        class(shapes_t), intent(in) :: self
        !> (2, size(shapes)) of each body: its values less the background's
        real(wp), intent(in) :: contrast(:, :)
        real(wp), intent(in) :: x, y, a
        integer, intent(in) :: nodes
        real(wp), intent(out) :: excess(2)
        type(error_t), allocatable, intent(inout) :: error
        type(rule_t) :: depths, radii
        type(section_t), allocatable :: sections(:)
        integer, allocatable :: present_shapes(:), seen(:)
        real(wp) :: gauss(nodes), weights(nodes), plane(2), arcs(2), shear, poisson
        integer :: i, j, k, l
        logical :: same_seen

        excess = 0.0_wp
        call gauss_legendre(gauss, weights, error)
        if (allocated(error)) return
        call depth_rule(depths_between(self%shapes, x, y, a), gauss, weights, depths)
        do i = 1, size(depths%nodes)
            call check_cancelled(error)
            if (allocated(error)) return
            call cut(self, x, y, a, depths%nodes(i), sections, present_shapes)
            if (size(present_shapes) == 0) cycle
            call radius_rule(radii_between(sections), depths%nodes(i), gauss, weights, radii)
            plane = 0.0_wp
            same_seen = all(is_round(sections))
            do k = 1, size(radii%nodes)
                ! within a panel, from its middle node on, the same discs are seen
                j = k + merge(nodes/2, nodes/2 - nodes, mod(k - 1, nodes) < nodes - nodes/2)
                if (mod(k - 1, nodes) == 0 .or. .not. same_seen) seen = [(l, l=1, size(sections))]
                call circle_integral(contrast(:, present_shapes), sections, radii%nodes(j), seen, arcs)
                call lateral_density(radii%nodes(j), depths%nodes(i), self%reference_nu, shear, poisson)
                plane = plane + radii%weights(j)*radii%nodes(j)*[shear, poisson]*arcs
            end do
            excess = excess + depths%weights(i)*plane
        end do
    end subroutine excess_means

    !> The bodies that the plane cuts, and their sections.
    pure subroutine cut(self, x, y, a, xi, sections, present_shapes)
        class(shapes_t), intent(in) :: self
        real(wp), intent(in) :: x, y, a, xi
        type(section_t), allocatable, intent(out) :: sections(:)
        integer, allocatable, intent(out) :: present_shapes(:)
        integer :: i

        allocate (sections(size(self%shapes)))
        do i = 1, size(sections)
            sections(i) = section_at(self%shapes(i), x, y, a, xi)
        end do
        present_shapes = pack([(i, i=1, size(sections))], sections%kind /= nothing)
        sections = sections(present_shapes)
    end subroutine cut

    !> The integral of `contrast` dtheta around the circle of radius rho: exact arcs, the last body on top.
    subroutine circle_integral(contrast, sections, rho, seen, integral)
        !> (2, size(sections))
        real(wp), intent(in) :: contrast(:, :)
        type(section_t), intent(in) :: sections(:)
        real(wp), intent(in) :: rho
        !> those to look at, ascending; afterwards those of which something is seen
        integer, allocatable, intent(inout) :: seen(:)
        real(wp), intent(out) :: integral(2)
        real(wp) :: angles(0:most_crossings*size(seen) + 1), crossings(most_crossings), middle, point(2)
        logical :: has_arc(size(seen))
        integer :: i, k, count, found

        found = 0
        do i = 1, size(seen)
            call crossing_angles(sections(seen(i)), rho, crossings, count)
            angles(found + 1:found + count) = crossings(:count)
            found = found + count
        end do
        call gsl_sort(angles(1:), 1_c_size_t, int(found, c_size_t))
        if (found == 0) then
            found = 1
            angles(1) = 0.0_wp
        end if
        angles(0) = angles(found) - 2.0_wp*pi
        integral = 0.0_wp
        has_arc = .false.
        do k = 1, found
            middle = 0.5_wp*(angles(k - 1) + angles(k))
            point = rho*[cos(middle), sin(middle)]
            do i = size(seen), 1, -1
                if (.not. holds(sections(seen(i)), point)) cycle
                integral = integral + (angles(k) - angles(k - 1))*contrast(:, seen(i))
                has_arc(i) = .true.
                exit
            end do
        end do
        seen = pack(seen, has_arc)
    end subroutine circle_integral

end module mdrcontact_lateral_shapes
