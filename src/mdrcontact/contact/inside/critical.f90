! SPDX-License-Identifier: GPL-3.0-or-later
!> Critical stresses inside a layered body: the largest stresses of a state in each layer, at each interface and on the free surface
!> (theory/stress.md (5.1), (5.2), (5.4)).
module mdrcontact_inside_critical
    use mdrcontact_cancel, only: report_progress
    use mdrcontact_codes, only: free_surface_tension, interface_shear, interface_tension, tension, tresca, von_mises
    use mdrcontact_contact_load, only: contact_load_t
    use mdrcontact_error, only: check_made, check_memory, error_no_convergence, error_t, raise, to_text
    use mdrcontact_inside, only: check_friction, interior_error, layers_of, load_inside
    use mdrcontact_inside_largest, only: box_t, maximum_t, stressed_t
    use mdrcontact_kinds, only: wp
    use mdrcontact_numerics_layer_search, only: rounding
    implicit none (type, external)
    private
    public :: check_deviation, critical, largest_of, new_stressed

    !> Maxima are searched for up to so many times a + z from the axis: the ring of tension on a coating need not lie at the edge.
    real(wp), parameter :: farthest = 3.0_wp
    !> The search excludes smaller distances to a singular edge of the free surface [a].
    real(wp), parameter :: off_edge = 1.0e-3_wp
    !> The face below n layers is considered from n times this part of its depth inside a layer, where nothing takes it for the
    !> face.
    real(wp), parameter :: inside = 2.0_wp*rounding
    !> Largest deviation of the field from the contact on the surface; beyond, no maxima are given [1].
    real(wp), parameter :: largest_deviation = 1.0e-3_wp
    integer, parameter :: of_layer(3) = [von_mises, tresca, tension]
    integer, parameter :: of_interface(2) = [interface_shear, interface_tension]

contains

    !> The largest stresses under a load. With friction in the plane of sliding, where they are by symmetry for the most part.
    subroutine critical(load, upper, friction, maxima, error, threads, counted_only)
        type(contact_load_t), intent(in) :: load
        !> whether the upper body is meant, not the lower one
        logical, intent(in) :: upper
        !> f >= 0: see interior
        real(wp), intent(in) :: friction
        !> of each layer top to bottom von_mises, tresca and tension, the half-space last; of each interface interface_shear and
        !> interface_tension; free_surface_tension
        type(maximum_t), allocatable, intent(out) :: maxima(:)
        type(error_t), allocatable, intent(out) :: error
        !> how many threads may share the work, 0: as many as OpenMP offers; default 1
        integer, intent(in), optional :: threads
        !> count only, without a search
        logical, intent(in), optional :: counted_only
        type(stressed_t) :: body
        integer :: i, n, stat

        call check_made(error, "load", load%is_made)
        if (allocated(error)) return
        call new_stressed(body, load, upper, friction, error, threads)
        if (allocated(error)) return
        allocate (maxima(size(of_layer)*body%layers%bodies() + size(of_interface)*size(body%layers%thickness) + 1), stat=stat)
        call check_memory(error, stat)
        if (present(counted_only)) then
            if (counted_only) return
        end if
        call check_deviation(load, upper, error)
        n = 0
        do i = 0, body%layers%bodies() - 1
            call largest_of(body, of_layer, i, .false., maxima(n + 1:n + size(of_layer)), error)
            n = n + size(of_layer)
            call report_progress(real(n, wp)/real(size(maxima), wp))
            if (allocated(error)) return
        end do
        do i = 0, size(body%layers%thickness) - 1
            call largest_of(body, of_interface, i, .false., maxima(n + 1:n + size(of_interface)), error)
            n = n + size(of_interface)
            call report_progress(real(n, wp)/real(size(maxima), wp))
            if (allocated(error)) return
        end do
        call largest_of(body, [free_surface_tension], 0, .false., maxima(n + 1:), error)
        call report_progress(1.0_wp)
    end subroutine critical

    !> A body with what stresses inside it need.
    subroutine new_stressed(self, load, upper, friction, error, threads)
        type(stressed_t), intent(out) :: self
        type(contact_load_t), intent(in) :: load
        logical, intent(in) :: upper
        real(wp), intent(in) :: friction
        type(error_t), allocatable, intent(out) :: error
        integer, intent(in), optional :: threads

        call load_inside(load, upper, self%load, error)
        if (.not. allocated(error)) call check_friction(self%load, friction, error)
        if (.not. allocated(error)) call layers_of(load%equilibrium, upper, self%layers, error)
        if (allocated(error)) return
        self%friction = merge(-friction, friction, upper)
        if (present(threads)) self%threads = threads
        call self%mark_singular()
    end subroutine new_stressed

    !> Raises where the field of a state is not that of its contact on the surface.
    subroutine check_deviation(load, upper, error)
        type(contact_load_t), intent(in) :: load
        logical, intent(in) :: upper
        type(error_t), allocatable, intent(inout) :: error
        real(wp) :: deviation

        if (allocated(error)) return
        call interior_error(load, upper, deviation, error)
        if (allocated(error) .or. deviation <= largest_deviation) return
        call raise(error, error_no_convergence, "subsurface displacements and stresses have an error of about "// &
                   to_text(deviation)//" relative to the depth and the largest pressure, by comparison with displacement and "// &
                   "pressure at the surface")
    end subroutine check_deviation

    !> The largest values of quantities that belong to one layer, one interface or the free surface.
    subroutine largest_of(body, quantities, place, is_coarse, found, error)
        type(stressed_t), intent(inout) :: body
        integer, intent(in) :: quantities(:)
        !> which layer or interface, 0 is the first one
        integer, intent(in) :: place
        logical, intent(in) :: is_coarse
        !> same size as quantities
        type(maximum_t), intent(out) :: found(:)
        type(error_t), allocatable, intent(inout) :: error

        if (allocated(error)) return
        call body%largest(box_of(body, quantities(1), place), quantities, is_coarse, found, error)
        found%place = place
        ! exactly, not from inside
        if (any(quantities(1) == of_interface)) found%z = body%layers%top(place + 2)
    end subroutine largest_of

    !> Where the largest value of a quantity is searched for.
    pure function box_of(body, quantity, place) result(box)
        type(stressed_t), intent(in) :: body
        integer, intent(in) :: quantity, place
        type(box_t) :: box
        real(wp) :: radius

        radius = body%load%radius
        if (quantity == free_surface_tension) then
            box%r = radius*[1.0_wp, farthest]
            if (body%has_singular_edge()) box%r(1) = radius*(1.0_wp + off_edge)
        else if (any(quantity == of_interface)) then
            box%z = body%layers%top(place + 2)*(1.0_wp - (place + 1)*inside)
            box%r = [0.0_wp, farthest*(radius + box%z(1))]
        else
            box%z(1) = body%layers%top(place + 1)*(1.0_wp + place*inside)
            box%r = [0.0_wp, farthest*(radius + box%z(1))]
            box%z(2) = box%z(1) + box%r(2)
            if (place < size(body%layers%thickness)) then
                box%z(2) = min(box%z(2), body%layers%top(place + 2)*(1.0_wp - (place + 1)*inside))
            end if
        end if
    end function box_of

end module mdrcontact_inside_critical
