! SPDX-License-Identifier: GPL-3.0-or-later
!> A structure made of bodies in a background material: E_eff by quadrature over depths, radii and exact arcs (theory 7).
module mdrcontact_lateral_shapes
    use, intrinsic :: ieee_arithmetic, only: ieee_is_finite
    use mdrcontact_cancel, only: check_cancelled
    use mdrcontact_error, only: check_poisson, check_within, error_no_convergence, error_t, raise, to_text
    use mdrcontact_kinds, only: pi, wp
    use mdrcontact_lateral_density, only: lateral_density
    use mdrcontact_lateral_panels, only: depth_rule, radius_rule, rule_t
    use mdrcontact_lateral_section, only: crossing_angles, everything, holds, most_crossings, nothing, section_t, touching_radii
    use mdrcontact_lateral_shape, only: depth_breaks, most_depths, section_at, shape_t
    use mdrcontact_lateral_structure, only: structure_t
    use mdrcontact_material, only: material_t
    use mdrcontact_numerics_power_mean, only: new_power_mean, power_mean_t
    use mdrcontact_numerics_quadrature, only: gauss_legendre
    implicit none (type, external)
    private
    public :: shapes_t, new_shapes

    real(wp), parameter :: default_tolerance = 1.0e-5_wp
    !> The depth, over a, at which the sections at the surface are looked at.
    real(wp), parameter :: surface = 1.0e-6_wp
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

        self%background = background
        self%shapes = shapes
        self%reference_nu = background%poisson
        if (present(reference_nu)) self%reference_nu = reference_nu
        if (present(tolerance)) self%tolerance = tolerance
        if (present(exponent)) self%exponent = exponent
        call new_power_mean(mean, self%exponent, [background%shear()], error)
        call check_poisson(error, "reference_nu", self%reference_nu)
        call check_within(error, "tolerance", self%tolerance, 1.0e-10_wp, 0.1_wp)
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
                           " is known to "//to_text(maxval(abs(excess - before)/scale))//" only: the tolerance is "// &
                           to_text(self%tolerance))
                return
            end if
        end do
        shear = mean%mean(moduli(0) + excess(1))
        poisson = poisson + excess(2)
    end subroutine means

    !> What the bodies add to the background's sums for G and nu, with so many nodes in a panel.
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
        integer, allocatable :: present_shapes(:)
        real(wp) :: gauss(nodes), weights(nodes), plane(2), shear, poisson
        integer :: i, j

        excess = 0.0_wp
        call gauss_legendre(gauss, weights, error)
        if (allocated(error)) return
        call depth_rule(all_depth_breaks(self, x, y, a), gauss, weights, depths)
        do i = 1, size(depths%nodes)
            call check_cancelled(error)
            if (allocated(error)) return
            call cut(self, x, y, a, depths%nodes(i), sections, present_shapes)
            if (size(present_shapes) == 0) cycle
            call radius_rule(all_touching_radii(sections), depths%nodes(i), gauss, weights, radii)
            plane = 0.0_wp
            do j = 1, size(radii%nodes)
                call lateral_density(radii%nodes(j), depths%nodes(i), self%reference_nu, shear, poisson)
                plane = plane + radii%weights(j)*radii%nodes(j)*[shear, poisson] &
                        *circle_integral(contrast, sections, present_shapes, radii%nodes(j))
            end do
            excess = excess + depths%weights(i)*plane
        end do
    end subroutine excess_means

    !> Depths where sections are not analytic, and those at which panels must still resolve what lies beside.
    function all_depth_breaks(self, x, y, a) result(breaks)
        class(shapes_t), intent(in) :: self
        real(wp), intent(in) :: x, y, a
        real(wp), allocatable :: breaks(:)
        real(wp) :: depths(most_depths), touching(most_crossings), middle
        integer :: i, count, found

        allocate (breaks((most_depths + 1)*size(self%shapes)))
        found = 0
        do i = 1, size(self%shapes)
            call depth_breaks(self%shapes(i), x, y, depths, count)
            breaks(found + 1:found + count) = depths(:count)/a
            found = found + count
            ! what lies far beside the contact is seen from depths as large
            middle = surface
            if (count == 2 .and. all(ieee_is_finite(depths))) middle = max(surface, 0.5_wp*sum(depths)/a)
            call touching_radii(section_at(self%shapes(i), x, y, a, middle), touching, count)
            touching(:count) = merge(touching(:count), 0.0_wp, ieee_is_finite(touching(:count)))
            if (count > 0) then
                found = found + 1
                breaks(found) = maxval(touching(:count))
            end if
        end do
        breaks = breaks(:found)
    end function all_depth_breaks

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

    function all_touching_radii(sections) result(radii)
        type(section_t), intent(in) :: sections(:)
        real(wp), allocatable :: radii(:)
        real(wp) :: touching(most_crossings)
        integer :: i, count, found

        allocate (radii(most_crossings*size(sections)))
        found = 0
        do i = 1, size(sections)
            call touching_radii(sections(i), touching, count)
            radii(found + 1:found + count) = touching(:count)
            found = found + count
        end do
        radii = pack(radii(:found), ieee_is_finite(radii(:found)))
    end function all_touching_radii

    !> The integral of `contrast` dtheta around the circle of radius rho: exact arcs, the last body on top.
    function circle_integral(contrast, sections, present_shapes, rho) result(integral)
        real(wp), intent(in) :: contrast(:, :)
        type(section_t), intent(in) :: sections(:)
        integer, intent(in) :: present_shapes(:)
        real(wp), intent(in) :: rho
        real(wp) :: integral(2)
        real(wp) :: angles(0:most_crossings*size(sections) + 1), crossings(most_crossings), middle
        integer :: i, k, count, found

        found = 0
        do i = 1, size(sections)
            if (sections(i)%kind == everything) cycle
            call crossing_angles(sections(i), rho, crossings, count)
            do k = 1, count
                call insert(angles(1:), found, crossings(k))
            end do
        end do
        if (found == 0) then
            found = 1
            angles(1) = 0.0_wp
        end if
        angles(0) = angles(found) - 2.0_wp*pi
        integral = 0.0_wp
        do k = 1, found
            middle = 0.5_wp*(angles(k - 1) + angles(k))
            do i = size(sections), 1, -1
                if (.not. holds(sections(i), rho*[cos(middle), sin(middle)])) cycle
                integral = integral + (angles(k) - angles(k - 1))*contrast(:, present_shapes(i))
                exit
            end do
        end do
    end function circle_integral

    !> Keeps angles(:count) ascending.
    pure subroutine insert(angles, count, angle)
        real(wp), intent(inout) :: angles(:)
        integer, intent(inout) :: count
        real(wp), intent(in) :: angle
        integer :: place

        place = count + 1
        do while (place > 1)
            if (angles(place - 1) <= angle) exit
            angles(place) = angles(place - 1)
            place = place - 1
        end do
        angles(place) = angle
        count = count + 1
    end subroutine insert

end module mdrcontact_lateral_shapes
