! SPDX-License-Identifier: GPL-3.0-or-later
!> The surface compliance of constants that vary with depth, by sublayers that thin towards the surface, each with its gradient.
!>
!> Waves that see many sublayers see those shallower than themselves through one power series, and some forty more one by one.
module mdrcontact_body_gradation
    use mdrcontact_body_compliance, only: normal_load, plane_compliance_t, twist_load
    use mdrcontact_body_elements_gradient, only: anti_plane_rate, gradient_series, in_plane_rate, multiply_series, order, &
                                                 series_value
    use mdrcontact_body_elements_layer, only: half_space_compliance, layer_t, new_layer, transferred
    use mdrcontact_error, only: check_memory, error_t
    use mdrcontact_kinds, only: wp
    use mdrcontact_material, only: moduli_t
    use mdrcontact_numerics_quadrature, only: new_antiderivative
    implicit none (type, external)
    private
    public :: gradation_t, new_gradation, nodes

    !> Places in a sublayer at which its constants are known.
    integer, parameter :: nodes = 10
    !> Waves see sublayers through one series while k times their depth is at most `longest`, and nothing below `deepest`/k.
    real(wp), parameter :: longest = 0.5_wp, deepest = 25.0_wp

    !> Series of the transfer matrices of one wave, top to bottom.
    type :: transfers_t
        !> of each sublayer, and of all from the surface to its end (m, m, 0:order, sublayer)
        real(wp), allocatable :: series(:, :, :, :), from_surface(:, :, :, :)
    end type transfers_t

    !> Sublayers under one load.
    type, extends(plane_compliance_t) :: gradation_t
        private
        !> depths of their ends, 0 first [length]
        real(wp), allocatable :: ends(:)
        !> in the plane of the wave and across it, those that the load takes
        type(transfers_t) :: plane, side
        !> compliance of a half-space of the material at each end, relative to 1/(2 G) of the surface (2, 2, end)
        real(wp), allocatable :: local(:, :, :)
        !> the first, homogeneous one
        type(layer_t) :: top
    contains
        procedure :: chi_in_plane
        procedure :: chi_across
        procedure :: coupling
        procedure, private :: carried_up
    end type gradation_t

contains

    !> Sublayers, the first one homogeneous.
    subroutine new_gradation(self, load, ends, shear, poisson, end_shear, end_poisson, error)
        type(gradation_t), intent(out) :: self
        integer, intent(in) :: load
        !> depths of their ends, ascending from 0 [length]
        real(wp), intent(in) :: ends(:)
        !> G [modulus] and nu [1] at the places of new_antiderivative (nodes, sublayer)
        real(wp), intent(in) :: shear(:, :), poisson(:, :)
        !> and at their lower ends
        real(wp), intent(in) :: end_shear(:), end_poisson(:)
        type(error_t), allocatable, intent(inout) :: error
        real(wp) :: antiderivative(nodes + 1, nodes), t(nodes)
        integer :: i, n, stat

        n = size(ends) - 1
        call new_antiderivative(t, antiderivative, error)
        if (allocated(error)) return
        allocate (self%ends(n + 1), self%local(2, 2, n), stat=stat)
        call check_memory(error, stat)
        if (stat /= 0) return
        self%ends(:) = ends
        self%first_depth = ends(2)
        self%last_depth = ends(n + 1)
        self%is_costly = .true.
        call self%set_load(load, moduli_of(shear(1, 1), poisson(1, 1)), moduli_of(end_shear(n), end_poisson(n)))
        call new_layer(self%top, ends(2), (1.0_wp, 0.0_wp), cmplx(poisson(1, 1), kind=wp))
        do i = 1, n
            self%local(:, :, i) = real(half_space_compliance(cmplx(end_poisson(i), kind=wp)), wp)*(shear(1, 1)/end_shear(i))
        end do
        if (load /= twist_load) call new_transfers(self%plane, 4, antiderivative, ends, shear, poisson, error)
        if (load /= normal_load) call new_transfers(self%side, 2, antiderivative, ends, shear, poisson, error)
        self%is_made = .not. allocated(error)
    end subroutine new_gradation

    pure function moduli_of(shear, poisson) result(moduli)
        real(wp), intent(in) :: shear, poisson
        type(moduli_t) :: moduli

        moduli%shear = shear
        moduli%poisson = poisson
        moduli%contact = 2.0_wp*shear/(1.0_wp - poisson)
    end function moduli_of

    subroutine new_transfers(self, m, antiderivative, ends, shear, poisson, error)
        type(transfers_t), intent(inout) :: self
        !> size of the matrices: 4 in the plane, 2 across it
        integer, intent(in) :: m
        real(wp), intent(in) :: antiderivative(:, :), ends(:)
        !> G [modulus] and nu (nodes, sublayer)
        real(wp), intent(in) :: shear(:, :), poisson(:, :)
        type(error_t), allocatable, intent(inout) :: error
        real(wp) :: rate(m, m, nodes)
        integer :: i, j, stat

        if (allocated(error)) return
        allocate (self%series(m, m, 0:order, size(ends) - 1), self%from_surface(m, m, 0:order, size(ends) - 1), stat=stat)
        call check_memory(error, stat)
        if (stat /= 0) return
        do i = 1, size(ends) - 1
            do j = 1, nodes
                if (m == 4) then
                    rate(:, :, j) = in_plane_rate(shear(j, i)/shear(1, 1), poisson(j, i))
                else
                    rate(:, :, j) = anti_plane_rate(shear(j, i)/shear(1, 1))
                end if
            end do
            call gradient_series(antiderivative, ends(i + 1) - ends(i), rate, self%series(:, :, :, i))
            self%from_surface(:, :, :, i) = self%series(:, :, :, i)
            if (i == 1) cycle
            self%from_surface(:, :, :, i) = self%from_surface(:, :, :, i - 1)
            call multiply_series(self%from_surface(:, :, :, i), self%series(:, :, :, i))
        end do
    end subroutine new_transfers

    !> The sublayers that a wave sees: from `start` up one by one, those down to `seen` together.
    pure subroutine find_sublayers(self, k, start, seen)
        class(gradation_t), intent(in) :: self
        complex(wp), intent(in) :: k
        integer, intent(out) :: start, seen

        start = min(count(self%ends(2:)*real(k, wp) <= deepest) + 1, size(self%ends) - 1)
        seen = min(count(self%ends(2:)*abs(k) <= longest), start)
    end subroutine find_sublayers

    !> In the plane of the wave.
    pure subroutine chi_in_plane(self, k, direction, one_plus_chi, chi)
        class(gradation_t), intent(in) :: self
        complex(wp), intent(in) :: k
        integer, intent(in) :: direction
        complex(wp), intent(out) :: one_plus_chi, chi
        complex(wp) :: compliance(2, 2)
        real(wp) :: scale
        logical :: is_whole

        call self%carried_up(k, compliance, is_whole)
        scale = real(self%top%half_space(direction, direction), wp)
        if (is_whole) then
            one_plus_chi = compliance(direction, direction)/scale
            chi = one_plus_chi - 1.0_wp
        else
            chi = compliance(direction, direction)/scale
            one_plus_chi = 1.0_wp + chi
        end if
    end subroutine chi_in_plane

    !> S_12 over S_22 of the surface's half-space.
    subroutine coupling(self, k, ratio, error)
        class(gradation_t), intent(in) :: self
        complex(wp), intent(in) :: k
        complex(wp), intent(out) :: ratio
        type(error_t), allocatable, intent(inout) :: error
        complex(wp) :: compliance(2, 2)
        logical :: is_whole

        associate (unused => error)
        end associate
        call self%carried_up(k, compliance, is_whole)
        if (.not. is_whole) compliance = compliance + self%top%half_space
        ratio = compliance(1, 2)/self%top%half_space(2, 2)
    end subroutine coupling

    !> The compliance carried up from where waves end, or from the homogeneous body below: the whole of it, or what is not the
    !> surface's half-space's.
    pure subroutine carried_up(self, k, compliance, is_whole)
        class(gradation_t), intent(in) :: self
        complex(wp), intent(in) :: k
        complex(wp), intent(out) :: compliance(2, 2)
        logical, intent(out) :: is_whole
        integer :: i, start, seen

        call find_sublayers(self, k, start, seen)
        compliance = self%local(:, :, start)
        do i = start, max(seen, 1) + 1, -1
            compliance = transferred(series_value(self%plane%series(:, :, :, i), k), compliance)
        end do
        is_whole = seen > 0
        if (is_whole) then
            compliance = transferred(series_value(self%plane%from_surface(:, :, :, seen), k), compliance)
        else
            compliance = self%top%reflected(k, compliance)
        end if
    end subroutine carried_up

    !> Across the plane of the wave.
    pure subroutine chi_across(self, k, one_plus_chi, chi)
        class(gradation_t), intent(in) :: self
        complex(wp), intent(in) :: k
        complex(wp), intent(out) :: one_plus_chi, chi
        complex(wp) :: compliance
        integer :: i, start, seen

        call find_sublayers(self, k, start, seen)
        ! (1, 1) + (1, 2) of a half-space in the plane is -1/G, what it is across it
        compliance = self%local(1, 1, start) + self%local(1, 2, start)
        do i = start, max(seen, 1) + 1, -1
            compliance = carried(series_value(self%side%series(:, :, :, i), k), compliance)
        end do
        if (seen > 0) then
            one_plus_chi = -carried(series_value(self%side%from_surface(:, :, :, seen), k), compliance)
            chi = one_plus_chi - 1.0_wp
        else
            one_plus_chi = self%top%above_across(k, -compliance)
            chi = self%top%reflected_across(k, -compliance)
        end if

    contains

        pure function carried(p, below) result(above)
            complex(wp), intent(in) :: p(2, 2), below
            complex(wp) :: above

            above = (p(1, 1)*below + p(1, 2))/(p(2, 1)*below + p(2, 2))
        end function carried

    end subroutine chi_across

end module mdrcontact_body_gradation
