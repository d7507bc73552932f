! SPDX-License-Identifier: GPL-3.0-or-later
!> A stack of bonded isotropic layers on an elastic half-space or a rigid base, as a surface compliance (theory 6).
module mdrcontact_body_stack
    use mdrcontact_body, only: body_t
    use mdrcontact_body_layers, only: layers_t
    use mdrcontact_body_surface, only: new_surface, surface_t
    use mdrcontact_error, only: check_memory, check_positive, error_invalid, error_t, raise, to_text
    use mdrcontact_kinds, only: wp
    use mdrcontact_material, only: material_t
    use mdrcontact_numerics_copy, only: copy_array
    implicit none (type, external)
    private
    public :: stack_t, new_stack

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
        !> the same with neighbours of one material joined, none if the body is homogeneous: their surface compliance, and shear
        !> moduli relative to the first layer's
        type(surface_t) :: surface
        real(wp), allocatable, private :: shear(:)
    contains
        procedure :: response
        procedure :: in_plane_response
        procedure :: anti_plane_response
        procedure :: ratios
        procedure :: sublayers
        procedure :: copy_to
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
        type(material_t), allocatable :: kept(:)
        type(material_t) :: surface
        real(wp), allocatable :: kept_thickness(:)
        complex(wp), allocatable :: shear(:), poisson(:)
        logical :: rigid
        integer :: i, count, stat

        rigid = substrate%young > huge(1.0_wp)
        if (present(rigid_base)) rigid = rigid .or. rigid_base
        if (size(layers) /= size(thickness)) then
            call raise(error, error_invalid, "thickness must have as many values as there are layers, "// &
                       to_text(real(size(layers), wp))//", not "//to_text(real(size(thickness), wp)))
        else if (rigid .and. size(layers) == 0) then
            call raise(error, error_invalid, "layers is empty: a rigid base must carry at least one layer")
        end if
        if (allocated(error)) return
        count = size(layers)
        allocate (kept(count), kept_thickness(count), shear(count + 1), poisson(count + 1), self%layers(count), &
                  self%thickness(count), stat=stat)
        call check_memory(error, stat)
        if (stat /= 0) return
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

        allocate (self%shear(count), stat=stat)
        call check_memory(error, stat)
        if (stat /= 0) return
        self%layers(:) = layers
        self%thickness(:) = thickness
        self%substrate = substrate
        self%rigid_base = rigid
        surface = substrate
        if (count > 0) surface = kept(1)
        self%surface_material = surface
        self%surface_modulus = surface%contact()
        do i = 1, count
            self%shear(i) = kept(i)%shear()/surface%shear()
            shear(i) = kept(i)%shear()
            poisson(i) = kept(i)%poisson
        end do
        shear(count + 1) = substrate%shear()
        poisson(count + 1) = substrate%poisson
        call new_surface(self%surface, shear(:count + 1), poisson(:count + 1), kept_thickness(:count), rigid, error)
        if (allocated(error)) return
        if (count > 0) self%first_depth = kept_thickness(1)
        self%last_depth = self%surface%depth
        self%softest = minval(layers%young)
        self%stiffest = maxval(layers%young)
        if (rigid) return
        self%softest = min(self%softest, substrate%young)
        self%stiffest = max(self%stiffest, substrate%young)
        self%long_wave_limit = surface%contact()/substrate%contact()
        self%anti_plane_limit = surface%shear()/substrate%shear()
        self%in_plane_limit = self%anti_plane_limit*(1.0_wp - substrate%poisson)/(1.0_wp - surface%poisson)
    end subroutine new_stack

    subroutine copy_to(self, copy, error)
        class(stack_t), intent(in) :: self
        class(body_t), allocatable, intent(out) :: copy
        type(error_t), allocatable, intent(inout) :: error
        type(stack_t), allocatable :: own
        integer :: stat

        allocate (own)
        call own%take_numbers(self)
        own%substrate = self%substrate
        own%rigid_base = self%rigid_base
        call copy_array(self%thickness, own%thickness, error)
        call copy_array(self%shear, own%shear, error)
        call self%surface%copy_to(own%surface, error)
        if (allocated(error)) return
        allocate (own%layers(size(self%layers)), stat=stat)
        call check_memory(error, stat)
        if (stat /= 0) return
        own%layers(:) = self%layers
        call move_alloc(own, copy)
    end subroutine copy_to

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

        call self%surface%normal_response(k, sigma, chi)
    end subroutine response

    !> Under shear in the plane of the wave.
    pure subroutine in_plane_response(self, k, sigma, chi)
        class(stack_t), intent(in) :: self
        complex(wp), intent(in) :: k
        complex(wp), intent(out) :: sigma, chi

        call self%surface%in_plane_response(k, sigma, chi)
    end subroutine in_plane_response

    !> Under shear across the plane: y = k C_T G of a layer goes from its bottom to its top as (y + tanh kh)/(1 + y tanh kh).
    pure subroutine anti_plane_response(self, k, sigma, chi)
        class(stack_t), intent(in) :: self
        complex(wp), intent(in) :: k
        complex(wp), intent(out) :: sigma, chi
        complex(wp) :: below, fall, rise
        integer :: i, seen

        sigma = 1.0_wp
        chi = 0.0_wp
        below = self%anti_plane_limit
        seen = self%surface%layers_seen(k)
        if (seen < size(self%surface%h)) below = 1.0_wp/self%shear(seen + 1)
        do i = seen, 1, -1
            below = self%shear(i)*below
            ! 1 - tanh, and tanh
            fall = exp(-2.0_wp*k*self%surface%h(i))
            fall = 2.0_wp*fall/(1.0_wp + fall)
            rise = tanh(k*self%surface%h(i))
            sigma = (below + rise)/(1.0_wp + below*rise)
            chi = (below - 1.0_wp)*fall/(1.0_wp + below*rise)
            below = sigma/self%shear(i)
        end do
    end subroutine anti_plane_response

    pure subroutine ratios(self, values, error)
        class(stack_t), intent(in) :: self
        real(wp), allocatable, intent(out) :: values(:)
        type(error_t), allocatable, intent(inout) :: error
        integer :: stat

        allocate (values(3*size(self%surface%h) + 5), stat=stat)
        call check_memory(error, stat)
        if (stat /= 0) return
        associate (n => size(self%surface%h))
            if (n > 0) values(:n) = self%surface%h/self%surface%h(1)
            values(n + 1:2*n) = self%shear
            values(2*n + 1:3*n) = real(self%surface%modes%poisson, wp)
            values(3*n + 1:3*n + 4) = real([self%surface%base(:, 1), self%surface%base(:, 2)], wp)
            values(3*n + 5) = self%long_wave_limit
        end associate
    end subroutine ratios

    !> The layers as they were given.
    pure subroutine sublayers(self, layers, error)
        class(stack_t), intent(in) :: self
        type(layers_t), intent(out) :: layers
        type(error_t), allocatable, intent(inout) :: error
        integer :: i, n, stat

        n = size(self%layers)
        layers%rigid_base = self%rigid_base
        allocate (layers%thickness(n), layers%shear(n + 1), layers%poisson(n + 1), stat=stat)
        call check_memory(error, stat)
        if (stat /= 0) return
        layers%thickness(:) = self%thickness
        do i = 1, n
            layers%shear(i) = self%layers(i)%shear()
            layers%poisson(i) = self%layers(i)%poisson
        end do
        layers%shear(n + 1) = merge(1.0_wp, self%substrate%shear(), self%rigid_base)
        layers%poisson(n + 1) = merge(0.0_wp, self%substrate%poisson, self%rigid_base)
    end subroutine sublayers

end module mdrcontact_body_stack
