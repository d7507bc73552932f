! SPDX-License-Identifier: GPL-3.0-or-later
!> The surface compliance of layers, and of what lies between them, on a half-space or a rigid base (theory/exact.md (2.2)), for
!> real elastic constants and for the complex ones of an oscillation or of a Laplace transform.
module mdrcontact_body_chain
    use, intrinsic :: iso_fortran_env, only: int64
    use mdrcontact_object, only: real_bytes
    use mdrcontact_body_compliance, only: plane_compliance_t
    use mdrcontact_body_elements_element, only: element_t
    use mdrcontact_body_elements_interface, only: bond_t, interface_t, new_interface
    use mdrcontact_body_elements_layer, only: half_space_compliance, layer_t, new_layer
    use mdrcontact_body_elements_transverse, only: new_transverse_layer, transverse_half_space, transverse_layer_t
    use mdrcontact_body_film, only: film_t, new_film
    use mdrcontact_error, only: check_memory, error_t
    use mdrcontact_kinds, only: wp
    use mdrcontact_material, only: moduli_t
    use mdrcontact_material_transverse, only: transverse_t
    implicit none (type, external)
    private
    public :: chain_t, new_chain

    !> Deeper layers, in units of 1/k below the first interface, change chi by less than rounding.
    real(wp), parameter :: deepest = 25.0_wp
    !> Waves so long that k times the total thickness is below `longest` see all layers through a power series of this order.
    integer, parameter :: series_order = 10
    !> More layers than these take longer than a table.
    integer, parameter :: most_layers = 4
    real(wp), parameter :: longest = 0.1_wp

    !> A place in the chain.
    type :: link_t
        class(element_t), allocatable :: element
    end type link_t

    !> Elements top to bottom, none if the body is homogeneous, at one Laplace variable.
    type, extends(plane_compliance_t) :: chain_t
        private
        type(link_t), allocatable :: links(:)
        !> of a single bonded isotropic layer, which has a closed form
        logical :: is_film = .false.
        type(film_t) :: film
        !> compliances of the base, relative to those of the surface: 1/(2 G) in the plane and 1/G across it; 0 if rigid
        complex(wp) :: base(2, 2) = 0.0_wp, base_across = 0.0_wp
        !> the power series in k of all elements' transfer matrix with the base below them, what the surface compliance takes of
        !> it: (1, 1), (1, 2), (2, 1), (2, 2) of the displacements, then the same of the tractions; taken where |k| is below
        !> series_end, nowhere where layers are not bonded
        complex(wp) :: series(8, 0:series_order) = 0.0_wp
        real(wp) :: series_end = 0.0_wp
        !> numbers without a unit that determine chi, where it is real
        real(wp), allocatable :: numbers(:)
    contains
        procedure :: chi_in_plane
        procedure :: chi_across
        procedure :: coupling
        procedure :: matrices
        procedure :: least_support
        procedure :: thinnest
        procedure :: key
        procedure :: bytes
    end type chain_t

contains

    !> Layers top to bottom under a load.
    pure subroutine new_chain(self, load, thickness, moduli, rigid_base, error, bonds)
        type(chain_t), intent(out) :: self
        integer, intent(in) :: load
        !> of the layers [length]
        real(wp), intent(in) :: thickness(:)
        !> of the layers and, one more, of the half-space, which is not used if the base is rigid
        type(moduli_t), intent(in) :: moduli(:)
        logical, intent(in) :: rigid_base
        type(error_t), allocatable, intent(inout) :: error
        !> below each layer; without them all are bonded
        type(bond_t), intent(in), optional :: bonds(:)
        type(bond_t) :: below(size(thickness))
        complex(wp) :: contrast
        integer :: i, last, count, stat

        if (allocated(error)) return
        count = size(thickness)
        if (present(bonds)) below = bonds
        contrast = 0.0_wp
        allocate (self%links(count + size(pack(below, .not. below%is_bonded()))), stat=stat)
        call check_memory(error, stat)
        if (stat /= 0) return
        if (rigid_base) then
            call self%set_load(load, moduli(1))
        else
            call self%set_load(load, moduli(1), moduli(count + 1))
            contrast = moduli(1)%shear/moduli(count + 1)%shear
            self%base_across = contrast
            self%base = half_space(moduli(count + 1), moduli(1), contrast)
        end if
        self%last_depth = sum(thickness)
        last = 0
        do i = 1, count
            last = last + 1
            call append_layer(self%links(last), thickness(i), moduli(i), moduli(1), i == 1, error)
            if (allocated(error)) return
            if (below(i)%is_bonded()) cycle
            last = last + 1
            call append_interface(self%links(last), below(i), moduli(1), error)
            if (allocated(error)) return
        end do
        if (count > 0) self%first_depth = thickness(1)*self%links(1)%element%decay
        self%is_costly = count > most_layers
        if (count > 0 .and. last == count) call add_series(self)
        self%is_film = last == 1 .and. all(moduli%is_plain)
        if (self%is_film) self%film = new_film(moduli(1)%poisson, moduli(2)%poisson, contrast)
        call take_numbers(self, thickness, moduli, below, error)
        self%is_made = .not. allocated(error)
    end subroutine new_chain

    pure recursive function bytes(self)
        class(chain_t), intent(in) :: self
        integer(int64) :: bytes
        integer :: i

        bytes = storage_size(self%links)/8*size(self%links, kind=int64)
        do i = 1, size(self%links)
            bytes = bytes + storage_size(self%links(i)%element)/8
        end do
        if (allocated(self%numbers)) bytes = bytes + real_bytes*size(self%numbers)
    end function bytes

    !> Contribution of the series of transfer matrices above the base to the surface compliance.
    pure subroutine add_series(self)
        type(chain_t), intent(inout) :: self
        complex(wp) :: transfer(4, 4, 0:series_order), rows(4, 2)
        real(wp) :: depth
        integer :: i, n

        transfer = 0.0_wp
        do i = 1, 4
            transfer(i, i, 0) = 1.0_wp
        end do
        depth = 0.0_wp
        do i = 1, size(self%links)
            associate (element => self%links(i)%element)
                call element%extend(transfer)
                depth = depth + element%fastest*element%thickness
            end associate
        end do
        self%series_end = longest/depth
        do n = 0, series_order
            rows = matmul(transfer(:, 1:2, n), self%base) + transfer(:, 3:4, n)
            self%series(:, n) = [rows(1, :), rows(2, :), rows(3, :), rows(4, :)]
        end do
    end subroutine add_series

    !> S of the base, relative to the surface.
    pure function half_space(base, surface, contrast) result(compliance)
        type(moduli_t), intent(in) :: base, surface
        !> shear modulus of the surface over that of the base
        complex(wp), intent(in) :: contrast
        complex(wp) :: compliance(2, 2)

        if (base%is_plain) then
            compliance = half_space_compliance(base%poisson)*contrast
        else
            compliance = transverse_half_space(base%constants, real(surface%shear, wp))
        end if
    end function half_space

    pure subroutine append_layer(link, thickness, moduli, surface, is_surface, error)
        type(link_t), intent(inout) :: link
        real(wp), intent(in) :: thickness
        !> of the layer, and of that at the surface
        type(moduli_t), intent(in) :: moduli, surface
        logical, intent(in) :: is_surface
        type(error_t), allocatable, intent(inout) :: error
        type(layer_t), allocatable :: layer
        type(transverse_layer_t), allocatable :: transverse
        complex(wp) :: shear
        integer :: stat

        if (moduli%is_plain) then
            allocate (layer, stat=stat)
        else
            allocate (transverse, stat=stat)
        end if
        call check_memory(error, stat)
        if (stat /= 0) return
        if (moduli%is_plain) then
            ! a complex number divided by itself need not be 1
            shear = 1.0_wp
            if (.not. is_surface) shear = moduli%shear/surface%shear
            call new_layer(layer, thickness, shear, moduli%poisson)
            call move_alloc(layer, link%element)
        else
            call new_transverse_layer(transverse, thickness, moduli%constants, real(surface%shear, wp))
            call move_alloc(transverse, link%element)
        end if
    end subroutine append_layer

    pure subroutine append_interface(link, bond, surface, error)
        type(link_t), intent(inout) :: link
        type(bond_t), intent(in) :: bond
        !> of the layer at the surface
        type(moduli_t), intent(in) :: surface
        type(error_t), allocatable, intent(inout) :: error
        type(interface_t), allocatable :: between
        integer :: stat

        allocate (between, stat=stat)
        call check_memory(error, stat)
        if (stat /= 0) return
        call new_interface(between, bond, surface%shear)
        call move_alloc(between, link%element)
    end subroutine append_interface

    !> Numbers without a unit that determine the compliance.
    pure subroutine key(self, values, error)
        class(chain_t), intent(in) :: self
        real(wp), allocatable, intent(out) :: values(:)
        type(error_t), allocatable, intent(inout) :: error
        integer :: stat

        if (allocated(self%numbers)) then
            allocate (values(size(self%numbers) + 2), stat=stat)
            call check_memory(error, stat)
            if (stat /= 0) return
            values(:2) = [real(self%load, wp), real(self%at_zero, wp)]
            values(3:) = self%numbers
        else
            allocate (values(0))
        end if
    end subroutine key

    !> Thicknesses, elastic constants, interfaces and the base, if they are real: no two frequencies have the same kernel.
    pure subroutine take_numbers(self, thickness, moduli, bonds, error)
        type(chain_t), intent(inout) :: self
        real(wp), intent(in) :: thickness(:)
        type(moduli_t), intent(in) :: moduli(:)
        type(bond_t), intent(in) :: bonds(:)
        type(error_t), allocatable, intent(inout) :: error
        integer, parameter :: of_layer = 11
        type(transverse_t) :: six
        real(wp) :: shear
        integer :: i, n, stat

        n = size(thickness)
        if (any(abs(aimag(moduli%shear)) > 0.0_wp .or. abs(aimag(moduli%poisson)) > 0.0_wp)) return
        allocate (self%numbers(of_layer*n + 5), stat=stat)
        call check_memory(error, stat)
        if (stat /= 0) return
        shear = real(moduli(1)%shear, wp)
        do i = 1, n
            six = moduli(i)%constants%scaled(shear)
            self%numbers(of_layer*(i - 1) + 1:of_layer*i) = &
                [thickness(i)/thickness(1), real(moduli(i)%shear, wp)/shear, real(moduli(i)%poisson, wp), six%s44, six%s33, six%c, &
                 six%h, six%c66, six%prestress, shear*bonds(i)%normal/thickness(1), shear*bonds(i)%tangential/thickness(1)]
        end do
        self%numbers(of_layer*n + 1:) = real([self%base(:, 1), self%base(:, 2), self%base_across], wp)
    end subroutine take_numbers

    !> In the plane of the wave: a single layer by its closed form.
    pure subroutine chi_in_plane(self, k, direction, one_plus_chi, chi)
        class(chain_t), intent(in) :: self
        complex(wp), intent(in) :: k
        integer, intent(in) :: direction
        complex(wp), intent(out) :: one_plus_chi, chi

        one_plus_chi = 1.0_wp
        chi = 0.0_wp
        if (size(self%links) == 0) return
        if (self%is_film) then
            call self%film%response(k*self%last_depth, direction, one_plus_chi, chi)
        else
            call carry(self, k, direction, one_plus_chi, chi)
        end if
    end subroutine chi_in_plane

    !> The compliance carried from the deepest element that matters at this k up to the surface.
    pure subroutine carry(self, k, direction, one_plus_chi, chi)
        class(chain_t), intent(in) :: self
        complex(wp), intent(in) :: k
        integer, intent(in) :: direction
        complex(wp), intent(out) :: one_plus_chi, chi
        complex(wp), dimension(2, 2) :: half_space, whole, change
        logical :: is_whole

        call self%matrices(k, half_space, whole, change, is_whole)
        associate (scale => half_space(direction, direction))
            if (is_whole) then
                one_plus_chi = whole(direction, direction)/scale
                chi = one_plus_chi - 1.0_wp
            else
                chi = change(direction, direction)/scale
                one_plus_chi = 1.0_wp + chi
            end if
        end associate
    end subroutine carry

    !> S_12 of the body over S_22 of the surface material's half-space.
    subroutine coupling(self, k, ratio, error)
        class(chain_t), intent(in) :: self
        complex(wp), intent(in) :: k
        complex(wp), intent(out) :: ratio
        type(error_t), allocatable, intent(inout) :: error
        complex(wp), dimension(2, 2) :: half_space, whole, change
        logical :: is_whole

        associate (unused => error)
        end associate
        call self%matrices(k, half_space, whole, change, is_whole)
        ratio = whole(1, 2)/half_space(2, 2)
    end subroutine coupling

    !> S of the surface material's half-space, of the body, and what the body changes: the second keeps its digits for long waves
    !> and the third for short ones.
    pure subroutine matrices(self, k, half_space, whole, change, is_whole)
        class(chain_t), intent(in) :: self
        complex(wp), intent(in) :: k
        complex(wp), dimension(2, 2), intent(out) :: half_space, whole, change
        !> the third was made of the second, else the second of the third
        logical, intent(out) :: is_whole
        integer :: i, seen

        is_whole = .false.
        half_space = self%base
        whole = self%base
        change = 0.0_wp
        if (size(self%links) == 0) return
        associate (top => self%links(1)%element)
            half_space = top%half_space
            if (abs(k) < self%series_end) then
                whole = long_wave_compliance(self%series, k)
                is_whole = .true.
            else
                seen = elements_seen(self, k)
                if (seen < size(self%links)) whole = self%links(seen + 1)%element%half_space
                do i = seen, 2, -1
                    whole = self%links(i)%element%above(k, whole)
                end do
                is_whole = abs(k*top%thickness) < 1.0_wp
                if (is_whole) whole = top%above(k, whole)
                if (.not. is_whole) change = top%reflected(k, whole)
            end if
        end associate
        if (is_whole) then
            change = whole - half_space
        else
            whole = half_space + change
        end if
    end subroutine matrices

    !> Least stiffness of the places between the elements to a wave: 0 or less where the body is unstable
    !> inside. From the bottom up what lies below an element holds its bottom together with the element itself, whose top is
    !> held: the pivots of the body's stiffness matrix, all positive and with them that of the surface if the wave costs energy
    !> (Sylvester). No single layer is unstable between held faces, as long as no constant of it vanishes (van Hove).
    pure function least_support(self, k) result(least)
        class(chain_t), intent(in) :: self
        real(wp), intent(in) :: k
        !> in parts of the stiffnesses that hold the place
        real(wp) :: least
        !> of what holds a place from above, next to a fixed place, so that it has an inverse
        real(wp), parameter :: rigid = 1.0e-15_wp
        complex(wp), parameter :: held(2, 2) = 0.0_wp
        complex(wp) :: below(2, 2), above(2, 2), wave
        integer :: i, j

        least = huge(1.0_wp)
        wave = k
        below = self%base
        do i = size(self%links), 1, -1
            above = self%links(i)%element%above(wave, held)
            do j = 1, 2
                if (abs(above(j, j)) < rigid) above(j, j) = -rigid
            end do
            if (any(abs(below) > 0.0_wp)) least = min(least, support(real(below, wp), real(above, wp)))
            below = self%links(i)%element%above(wave, below)
        end do
    end function least_support

    !> The lowest stiffness of a place by its compliances to what lies below it and above, each negative definite where that is
    !> stable.
    pure function support(below, above) result(least)
        real(wp), intent(in) :: below(2, 2), above(2, 2)
        real(wp) :: least
        real(wp) :: one(3), other(3), both(3), part(2)

        one = stiffness(below)
        other = stiffness(above)
        ! seen from below the wave moves along the surface the other way
        both = one + other*[1.0_wp, 1.0_wp, -1.0_wp]
        ! each displacement in its own unit: a thin layer that keeps its volume is far stiffer along its normal
        part = 1.0_wp/sqrt(abs(one(:2)) + abs(other(:2)))
        both = both*[part**2, part(1)*part(2)]
        least = 0.5_wp*(both(1) + both(2)) - hypot(0.5_wp*(both(1) - both(2)), both(3))
    end function support

    !> (1, 1), (2, 2) and (1, 2) of the stiffness.
    pure function stiffness(compliance) result(numbers)
        real(wp), intent(in) :: compliance(2, 2)
        real(wp) :: numbers(3)

        associate (c => compliance)
            numbers = [-c(2, 2), -c(1, 1), 0.5_wp*(c(1, 2) + c(2, 1))]/(c(1, 1)*c(2, 2) - c(1, 2)*c(2, 1))
        end associate
    end function stiffness

    !> The smallest thickness, of a body with a layer.
    pure function thinnest(self) result(thickness)
        class(chain_t), intent(in) :: self
        real(wp) :: thickness
        integer :: i

        thickness = self%last_depth
        do i = 1, size(self%links)
            if (self%links(i)%element%thickness > 0.0_wp) thickness = min(thickness, self%links(i)%element%thickness)
        end do
    end function thinnest

    !> Across the plane of the wave.
    pure subroutine chi_across(self, k, one_plus_chi, chi)
        class(chain_t), intent(in) :: self
        complex(wp), intent(in) :: k
        complex(wp), intent(out) :: one_plus_chi, chi
        complex(wp) :: compliance
        integer :: i, seen

        one_plus_chi = 1.0_wp
        chi = 0.0_wp
        if (size(self%links) == 0) return
        compliance = self%base_across
        seen = elements_seen(self, k)
        if (seen < size(self%links)) compliance = self%links(seen + 1)%element%half_space_across
        do i = seen, 2, -1
            compliance = self%links(i)%element%above_across(k, compliance)
        end do
        one_plus_chi = self%links(1)%element%above_across(k, compliance)
        chi = self%links(1)%element%reflected_across(k, compliance)
    end subroutine chi_across

    !> Number of elements that matter at this k; the next one acts as a half-space.
    pure function elements_seen(self, k) result(count)
        class(chain_t), intent(in) :: self
        complex(wp), intent(in) :: k
        integer :: count
        real(wp) :: depth

        depth = 0.0_wp
        do count = 1, size(self%links) - 2
            associate (element => self%links(count + 1)%element)
                depth = depth + element%decay*element%thickness*real(k, wp)
            end associate
            if (depth > deepest) return
        end do
        count = size(self%links)
    end function elements_seen

    !> Displacements times the inverse of tractions.
    pure function long_wave_compliance(series, k) result(compliance)
        complex(wp), intent(in) :: series(8, 0:series_order)
        complex(wp), intent(in) :: k
        complex(wp) :: compliance(2, 2)
        complex(wp) :: rows(8)
        integer :: n

        rows = series(:, series_order)
        do n = series_order - 1, 0, -1
            rows = series(:, n) + k*rows
        end do
        compliance(1, 1) = rows(1)*rows(8) - rows(2)*rows(7)
        compliance(2, 1) = rows(3)*rows(8) - rows(4)*rows(7)
        compliance(1, 2) = rows(2)*rows(5) - rows(1)*rows(6)
        compliance(2, 2) = rows(4)*rows(5) - rows(3)*rows(6)
        compliance = compliance/(rows(5)*rows(8) - rows(6)*rows(7))
    end function long_wave_compliance

end module mdrcontact_body_chain
