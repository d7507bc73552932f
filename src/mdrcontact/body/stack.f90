! SPDX-License-Identifier: GPL-3.0-or-later
!> A stack of bonded isotropic layers on an elastic half-space or a rigid base, as a surface compliance (theory 6).
module mdrcontact_body_stack
    use mdrcontact_body, only: body_t
    use mdrcontact_body_film, only: film_t, new_film
    use mdrcontact_body_layers, only: layers_t
    use mdrcontact_body_modes, only: compliance_above, half_space_compliance, layer_modes_t, new_layer_modes, reflected_part, &
                                     series_product
    use mdrcontact_error, only: check_positive, error_invalid, error_t, raise, to_text
    use mdrcontact_kinds, only: wp
    use mdrcontact_material, only: material_t
    implicit none (type, external)
    private
    public :: stack_t, new_stack

    !> What lies deeper than this, in units of 1/k below the first interface, changes chi by less than rounding.
    real(wp), parameter :: deepest = 25.0_wp
    !> Waves so long that k times the total thickness is below `longest` see all layers through a power series of this order.
    integer, parameter :: series_order = 10
    real(wp), parameter :: longest = 0.1_wp

    !> Bonded layers on a half-space or on a rigid base.
    type, extends(body_t) :: stack_t
        !> materials from the surface down
        type(material_t), allocatable :: layers(:)
        !> their thicknesses [length]
        real(wp), allocatable :: thickness(:)
        !> what lies below them, unless the base is rigid
        type(material_t) :: substrate
        !> whether the layers lie on a rigid base; the substrate is then not used
        logical :: rigid_base = .false.
        !> the same with neighbours of one material joined, none if the body is homogeneous: modes, thicknesses [length], shear
        !> moduli relative to the first layer's
        type(layer_modes_t), allocatable, private :: modes(:)
        !> of a single layer
        type(film_t) :: film
        real(wp), allocatable, private :: h(:), shear(:)
        !> compliance of the base relative to 1/(2 G) of the first layer; 0 if rigid
        complex(wp), private :: base(2, 2) = 0.0_wp
        real(wp), private :: contact_modulus = 0.0_wp, sigma_zero = 0.0_wp
        !> total thickness [length]
        real(wp), private :: total_thickness = 0.0_wp
        !> the power series in k of all layers' transfer matrix with the base below them, what the surface compliance takes of
        !> it: (1, 1), (1, 2), (2, 1), (2, 2) of the displacements, then the same of the tractions
        real(wp), private :: series(8, 0:series_order) = 0.0_wp
        !> sigma(0) under shear across the plane, G of the first layer over that of the base, and in the plane; 0 if rigid
        real(wp), private :: base_compliance = 0.0_wp, in_plane_zero = 0.0_wp
    contains
        procedure :: response
        procedure :: in_plane_response
        procedure :: anti_plane_response
        procedure :: surface_material
        procedure :: shear_limits
        procedure :: surface_modulus
        procedure :: long_wave_limit
        procedure :: first_depth
        procedure :: last_depth
        procedure :: ratios
        procedure :: sublayers
    end type stack_t

contains

    !> A stack of layers. Equal neighbours are one layer to the compliance: a stack of equal layers is a homogeneous body.
    pure subroutine new_stack(self, layers, thickness, substrate, error, rigid_base)
        type(stack_t), intent(out) :: self
        !> materials from the surface down, as made by new_material
        type(material_t), intent(in) :: layers(:)
        !> thicknesses, same size, > 0 [length]
        real(wp), intent(in) :: thickness(:)
        !> the half-space below; an infinite E makes it a rigid base
        type(material_t), intent(in) :: substrate
        type(error_t), allocatable, intent(out) :: error
        !> bonded to a rigid base instead of the substrate, which is then ignored; default false. At least one layer then.
        logical, intent(in), optional :: rigid_base
        type(material_t) :: kept(size(layers)), surface
        real(wp) :: kept_thickness(size(layers))
        logical :: rigid
        real(wp) :: series(4, 4, 0:series_order)
        integer :: i, count

        rigid = substrate%young > huge(1.0_wp)
        if (present(rigid_base)) rigid = rigid .or. rigid_base
        if (size(layers) /= size(thickness)) then
            call raise(error, error_invalid, "thickness must have as many values as there are layers, "// &
                       to_text(real(size(layers), wp))//", not "//to_text(real(size(thickness), wp)))
        else if (rigid .and. size(layers) == 0) then
            call raise(error, error_invalid, "layers is empty: a rigid base must carry at least one layer")
        end if
        if (allocated(error)) return
        count = 0
        do i = 1, size(layers)
            call check_positive(error, "thickness", thickness(i))
            call check_positive(error, "E of a layer", layers(i)%young)
            if (allocated(error)) return
            if (count > 0) then
                if (same(layers(i), kept(count))) then
                    kept_thickness(count) = kept_thickness(count) + thickness(i)
                    cycle
                end if
            end if
            count = count + 1
            kept(count) = layers(i)
            kept_thickness(count) = thickness(i)
        end do
        if (.not. rigid) then
            call check_positive(error, "E of the substrate", substrate%young)
            if (allocated(error)) return
            if (count > 0) then
                if (same(substrate, kept(count))) count = count - 1
            end if
        end if

        self%layers = layers
        self%thickness = thickness
        self%substrate = substrate
        self%rigid_base = rigid
        surface = substrate
        if (count > 0) surface = kept(1)
        self%contact_modulus = surface%contact()
        self%h = kept_thickness(:count)
        self%shear = kept(:count)%shear()/surface%shear()
        allocate (self%modes(count))
        series = 0.0_wp
        do i = 1, 4
            series(i, i, 0) = 1.0_wp
        end do
        do i = 1, count
            self%modes(i) = new_layer_modes(kept(i)%poisson)
            call series_product(self%modes(i), self%h(i), self%shear(i), series)
        end do
        self%total_thickness = sum(self%h)
        if (.not. rigid) then
            self%base = half_space_compliance(substrate%poisson)*(surface%shear()/substrate%shear())
            self%sigma_zero = surface%contact()/substrate%contact()
            self%base_compliance = surface%shear()/substrate%shear()
            self%in_plane_zero = self%base_compliance*(1.0_wp - substrate%poisson)/(1.0_wp - surface%poisson)
        end if
        self%series = with_base(series, real(self%base, wp))
        if (count == 1) self%film = new_film(surface%poisson, substrate%poisson, &
                                             merge(0.0_wp, surface%shear()/substrate%shear(), rigid))
    end subroutine new_stack

    !> What the surface compliance takes of a series of transfer matrices above a base.
    pure function with_base(transfer, base) result(series)
        real(wp), intent(in) :: transfer(4, 4, 0:series_order), base(2, 2)
        real(wp) :: series(8, 0:series_order)
        real(wp) :: rows(4, 2)
        integer :: n

        do n = 0, series_order
            rows = matmul(transfer(:, 1:2, n), base) + transfer(:, 3:4, n)
            series(:, n) = [rows(1, :), rows(2, :), rows(3, :), rows(4, :)]
        end do
    end function with_base

    pure function same(one, other) result(answer)
        type(material_t), intent(in) :: one, other
        logical :: answer

        answer = one%young == other%young .and. one%poisson == other%poisson
    end function same

    !> Under normal load.
    pure subroutine response(self, k, sigma, chi)
        class(stack_t), intent(in) :: self
        complex(wp), intent(in) :: k
        complex(wp), intent(out) :: sigma, chi

        if (size(self%h) == 1) then
            call self%film%response(k*self%h(1), sigma, chi)
        else
            call carry(self, k, 2, sigma, chi)
        end if
    end subroutine response

    !> Under shear in the plane of the wave.
    pure subroutine in_plane_response(self, k, sigma, chi)
        class(stack_t), intent(in) :: self
        complex(wp), intent(in) :: k
        complex(wp), intent(out) :: sigma, chi

        if (size(self%h) == 1) then
            call self%film%in_plane_response(k*self%h(1), sigma, chi)
        else
            call carry(self, k, 1, sigma, chi)
        end if
    end subroutine in_plane_response

    !> Carries the compliance from the deepest layer that matters at this k up to the surface.
    pure subroutine carry(self, k, load, sigma, chi)
        class(stack_t), intent(in) :: self
        complex(wp), intent(in) :: k
        !> the traction and its displacement: 1 in the plane, 2 normal to the surface
        integer, intent(in) :: load
        complex(wp), intent(out) :: sigma, chi
        complex(wp) :: compliance(2, 2), t
        real(wp) :: scale
        integer :: i, seen

        sigma = 1.0_wp
        chi = 0.0_wp
        if (size(self%h) == 0) return
        scale = real(self%modes(1)%half_space(load, load), wp)
        if (abs(k)*self%total_thickness < longest) then
            sigma = long_wave_compliance(self%series, k, load)/scale
            chi = sigma - 1.0_wp
            return
        end if
        compliance = self%base
        seen = layers_seen(self, k)
        if (seen < size(self%h)) compliance = self%modes(seen + 1)%half_space/self%shear(seen + 1)
        do i = seen, 2, -1
            compliance = compliance_above(self%modes(i), k*self%h(i), self%shear(i)*compliance)/self%shear(i)
        end do
        t = k*self%h(1)
        if (abs(t) < 1.0_wp) then
            compliance = compliance_above(self%modes(1), t, compliance)
            sigma = compliance(load, load)/scale
            chi = sigma - 1.0_wp
        else
            compliance = reflected_part(self%modes(1), t, compliance)
            chi = compliance(load, load)/scale
            sigma = 1.0_wp + chi
        end if
    end subroutine carry

    !> How many layers matter at this k; the one below them may be taken for a half-space.
    pure function layers_seen(self, k) result(count)
        class(stack_t), intent(in) :: self
        complex(wp), intent(in) :: k
        integer :: count
        real(wp) :: depth

        depth = 0.0_wp
        do count = 1, size(self%h) - 2
            depth = depth + self%h(count + 1)*real(k, wp)
            if (depth > deepest) return
        end do
        count = size(self%h)
    end function layers_seen

    !> Entry (load, load) of displacements times the inverse of tractions.
    pure function long_wave_compliance(series, k, load) result(compliance)
        real(wp), intent(in) :: series(8, 0:series_order)
        complex(wp), intent(in) :: k
        integer, intent(in) :: load
        complex(wp) :: compliance
        complex(wp) :: rows(8)
        integer :: n

        rows = series(:, series_order)
        do n = series_order - 1, 0, -1
            rows = series(:, n) + k*rows
        end do
        if (load == 1) then
            compliance = rows(1)*rows(8) - rows(2)*rows(7)
        else
            compliance = rows(4)*rows(5) - rows(3)*rows(6)
        end if
        compliance = compliance/(rows(5)*rows(8) - rows(6)*rows(7))
    end function long_wave_compliance

    !> Under shear across the plane: y = k C_T G of a layer goes from its bottom to its top as (y + tanh kh)/(1 + y tanh kh).
    pure subroutine anti_plane_response(self, k, sigma, chi)
        class(stack_t), intent(in) :: self
        complex(wp), intent(in) :: k
        complex(wp), intent(out) :: sigma, chi
        complex(wp) :: below, fall, rise
        integer :: i, seen

        sigma = 1.0_wp
        chi = 0.0_wp
        below = self%base_compliance
        seen = layers_seen(self, k)
        if (seen < size(self%h)) below = 1.0_wp/self%shear(seen + 1)
        do i = seen, 1, -1
            below = self%shear(i)*below
            ! 1 - tanh, and tanh
            fall = exp(-2.0_wp*k*self%h(i))
            fall = 2.0_wp*fall/(1.0_wp + fall)
            rise = tanh(k*self%h(i))
            sigma = (below + rise)/(1.0_wp + below*rise)
            chi = (below - 1.0_wp)*fall/(1.0_wp + below*rise)
            below = sigma/self%shear(i)
        end do
    end subroutine anti_plane_response

    pure function surface_material(self) result(material)
        class(stack_t), intent(in) :: self
        type(material_t) :: material

        material = self%substrate
        if (size(self%layers) > 0) material = self%layers(1)
    end function surface_material

    pure subroutine shear_limits(self, in_plane, anti_plane)
        class(stack_t), intent(in) :: self
        real(wp), intent(out) :: in_plane, anti_plane

        in_plane = self%in_plane_zero
        anti_plane = self%base_compliance
    end subroutine shear_limits

    pure function surface_modulus(self) result(value)
        class(stack_t), intent(in) :: self
        real(wp) :: value

        value = self%contact_modulus
    end function surface_modulus

    pure function long_wave_limit(self) result(value)
        class(stack_t), intent(in) :: self
        real(wp) :: value

        value = self%sigma_zero
    end function long_wave_limit

    pure function first_depth(self) result(value)
        class(stack_t), intent(in) :: self
        real(wp) :: value

        value = 0.0_wp
        if (size(self%h) > 0) value = self%h(1)
    end function first_depth

    pure function last_depth(self) result(value)
        class(stack_t), intent(in) :: self
        real(wp) :: value

        value = self%total_thickness
    end function last_depth

    pure function ratios(self) result(values)
        class(stack_t), intent(in) :: self
        real(wp), allocatable :: values(:)

        allocate (values(3*size(self%h) + 5))
        associate (n => size(self%h))
            if (n > 0) values(:n) = self%h/self%h(1)
            values(n + 1:2*n) = self%shear
            values(2*n + 1:3*n) = self%modes%poisson
            values(3*n + 1:3*n + 4) = real([self%base(:, 1), self%base(:, 2)], wp)
            values(3*n + 5) = self%sigma_zero
        end associate
    end function ratios

    !> The layers as they were given.
    pure subroutine sublayers(self, unit, ratio, depths, layers)
        class(stack_t), intent(in) :: self
        real(wp), intent(in) :: unit, ratio, depths(:)
        type(layers_t), intent(out) :: layers

        associate (unused => unit, also_unused => ratio, unused_too => depths)
        end associate
        layers%rigid_base = self%rigid_base
        allocate (layers%thickness, source=self%thickness)
        allocate (layers%shear, source=[self%layers%shear(), 1.0_wp])
        allocate (layers%poisson, source=[self%layers%poisson, 0.0_wp])
        if (self%rigid_base) return
        layers%shear(size(layers%shear)) = self%substrate%shear()
        layers%poisson(size(layers%shear)) = self%substrate%poisson
    end subroutine sublayers

end module mdrcontact_body_stack
