! SPDX-License-Identifier: GPL-3.0-or-later
!> The surface compliance of bonded layers on a half-space or a rigid base (theory 6), for real elastic constants and for the
!> complex ones of an oscillation or of a Laplace transform.
module mdrcontact_body_surface
    use mdrcontact_body_film, only: film_t, new_film
    use mdrcontact_body_modes, only: compliance_above, half_space_compliance, layer_modes_t, new_layer_modes, reflected_part, &
                                     series_product
    use mdrcontact_error, only: check_memory, error_t
    use mdrcontact_kinds, only: wp
    implicit none (type, external)
    private
    public :: surface_t, new_surface

    !> What lies deeper than this, in units of 1/k below the first interface, changes chi by less than rounding.
    real(wp), parameter :: deepest = 25.0_wp
    !> Waves so long that k times the total thickness is below `longest` see all layers through a power series of this order.
    integer, parameter :: series_order = 10
    real(wp), parameter :: longest = 0.1_wp

    !> Layers, none if the body is homogeneous.
    type :: surface_t
        type(layer_modes_t), allocatable :: modes(:)
        !> of a single layer
        type(film_t), private :: film
        !> thicknesses and their sum [length]
        real(wp), allocatable :: h(:)
        real(wp) :: depth = 0.0_wp
        !> shear moduli relative to the first layer's
        complex(wp), allocatable, private :: shear(:)
        !> compliance of the base relative to 1/(2 G) of the first layer; 0 if rigid
        complex(wp) :: base(2, 2) = 0.0_wp
        !> the power series in k of all layers' transfer matrix with the base below them, what the surface compliance takes of
        !> it: (1, 1), (1, 2), (2, 1), (2, 2) of the displacements, then the same of the tractions
        complex(wp), private :: series(8, 0:series_order) = 0.0_wp
    contains
        procedure :: normal_response
        procedure :: in_plane_response
        procedure :: layers_seen
        procedure :: copy_to
    end type surface_t

contains

    !> Layers from the surface down.
    pure subroutine new_surface(self, shear, poisson, thickness, rigid_base, error)
        type(surface_t), intent(out) :: self
        !> of the layers and, one more, of the half-space, which is not used if the base is rigid [modulus]; [1]
        complex(wp), intent(in) :: shear(:), poisson(:)
        !> of the layers [length]
        real(wp), intent(in) :: thickness(:)
        logical, intent(in) :: rigid_base
        type(error_t), allocatable, intent(inout) :: error
        complex(wp) :: series(4, 4, 0:series_order), contrast
        integer :: i, count, stat

        if (allocated(error)) return
        count = size(thickness)
        allocate (self%h(count), self%shear(count), self%modes(count), stat=stat)
        call check_memory(error, stat)
        if (stat /= 0) return
        self%h(:) = thickness
        self%depth = sum(thickness)
        self%shear(:) = shear(:count)/shear(1)
        series = 0.0_wp
        do i = 1, 4
            series(i, i, 0) = 1.0_wp
        end do
        do i = 1, count
            self%modes(i) = new_layer_modes(poisson(i))
            call series_product(self%modes(i), self%h(i), self%shear(i), series)
        end do
        contrast = 0.0_wp
        if (.not. rigid_base) contrast = shear(1)/shear(count + 1)
        if (.not. rigid_base) self%base = half_space_compliance(poisson(count + 1))*contrast
        self%series = with_base(series, self%base)
        if (count == 1) self%film = new_film(poisson(1), poisson(2), contrast)
    end subroutine new_surface

    pure subroutine copy_to(self, copy, error)
        class(surface_t), intent(in) :: self
        type(surface_t), intent(out) :: copy
        type(error_t), allocatable, intent(inout) :: error
        integer :: count, stat

        if (allocated(error)) return
        count = size(self%h)
        allocate (copy%h(count), copy%shear(count), copy%modes(count), stat=stat)
        call check_memory(error, stat)
        if (stat /= 0) return
        copy%h(:) = self%h
        copy%shear(:) = self%shear
        copy%modes(:) = self%modes
        copy%film = self%film
        copy%depth = self%depth
        copy%base = self%base
        copy%series = self%series
    end subroutine copy_to

    !> What the surface compliance takes of a series of transfer matrices above a base.
    pure function with_base(transfer, base) result(series)
        complex(wp), intent(in) :: transfer(4, 4, 0:series_order), base(2, 2)
        complex(wp) :: series(8, 0:series_order)
        complex(wp) :: rows(4, 2)
        integer :: n

        do n = 0, series_order
            rows = matmul(transfer(:, 1:2, n), base) + transfer(:, 3:4, n)
            series(:, n) = [rows(1, :), rows(2, :), rows(3, :), rows(4, :)]
        end do
    end function with_base

    !> sigma(k) and chi(k) under normal load.
    pure subroutine normal_response(self, k, sigma, chi)
        class(surface_t), intent(in) :: self
        complex(wp), intent(in) :: k
        complex(wp), intent(out) :: sigma, chi

        if (size(self%h) == 1) then
            call self%film%response(k*self%h(1), sigma, chi)
        else
            call carry(self, k, 2, sigma, chi)
        end if
    end subroutine normal_response

    !> Under shear in the plane of the wave.
    pure subroutine in_plane_response(self, k, sigma, chi)
        class(surface_t), intent(in) :: self
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
        class(surface_t), intent(in) :: self
        complex(wp), intent(in) :: k
        !> the traction and its displacement: 1 in the plane, 2 normal to the surface
        integer, intent(in) :: load
        complex(wp), intent(out) :: sigma, chi
        complex(wp) :: compliance(2, 2), t
        complex(wp) :: scale
        integer :: i, seen

        sigma = 1.0_wp
        chi = 0.0_wp
        if (size(self%h) == 0) return
        scale = self%modes(1)%half_space(load, load)
        if (abs(k)*self%depth < longest) then
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
        class(surface_t), intent(in) :: self
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
        complex(wp), intent(in) :: series(8, 0:series_order)
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

end module mdrcontact_body_surface
