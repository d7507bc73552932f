! SPDX-License-Identifier: GPL-3.0-or-later
!> Displacements and stresses inside a body, layered or graded.
module mdrcontact_inside_body_field
    use mdrcontact_body, only: body_t
    use mdrcontact_body_layers, only: layers_t
    use mdrcontact_error, only: check_memory, error_t
    use mdrcontact_inside_gradient_states, only: gradient_states_t, new_gradient_states
    use mdrcontact_inside_interior, only: check_distances, components, depth_of, interior_field, state_field
    use mdrcontact_inside_lattice, only: distinct, lattice_t, new_lattice
    use mdrcontact_medium_load, only: load_t
    use mdrcontact_inside_states, only: depth_t
    use mdrcontact_kinds, only: wp
    use mdrcontact_material_transverse, only: of_isotropic
    implicit none (type, external)
    private
    public :: body_field

    !> Depths of a graded body that are worked on together.
    integer, parameter :: depths_together = 64

contains

    !> The field at points (r, z, angle); see interior_field.
    subroutine body_field(load, body, r, z, below, field, error, friction, angle, threads)
        class(load_t), intent(in) :: load
        class(body_t), intent(in) :: body
        !> r >= 0, z >= 0 [length]
        real(wp), intent(in) :: r(:), z(:)
        !> which side of an interface is meant
        logical, intent(in) :: below
        !> (size(r), components)
        real(wp), intent(out) :: field(:, :)
        type(error_t), allocatable, intent(out) :: error
        !> traction friction*p(r) in +x on the surface, and azimuth of the points from +x [radian]
        real(wp), intent(in) :: friction, angle(:)
        integer, intent(in) :: threads
        type(layers_t) :: layers

        if (body%is_graded) then
            call graded_field(load, body, r, z, field, error, friction, angle, threads)
        else
            call body%sublayers(layers, error)
            if (allocated(error)) return
            call interior_field(load, layers, r, z, below, field, error, friction, angle, threads)
        end if
    end subroutine body_field

    !> By groups of depths.
    subroutine graded_field(load, body, r, z, field, error, friction, angle, threads)
        class(load_t), intent(in) :: load
        class(body_t), intent(in) :: body
        real(wp), intent(in) :: r(:), z(:)
        real(wp), intent(out) :: field(:, :)
        type(error_t), allocatable, intent(out) :: error
        real(wp), intent(in) :: friction, angle(:)
        integer, intent(in) :: threads
        real(wp), allocatable :: part(:, :), depth(:)
        integer, allocatable :: first(:), which(:), here(:)
        integer :: group, i, stat

        call check_distances(load, r, z, error)
        if (allocated(error)) return
        allocate (which(size(z)), depth(size(z)), stat=stat)
        call check_memory(error, stat)
        if (stat /= 0) return
        do i = 1, size(z)
            depth(i) = depth_of(load, r(i), z(i))
        end do
        call distinct(depth, first, which, error)
        if (allocated(error)) return
        do group = 0, (size(first) - 1)/depths_together
            here = pack([(i, i=1, size(z))], (which - 1)/depths_together == group)
            allocate (part(size(here), components), stat=stat)
            call check_memory(error, stat)
            if (stat /= 0) return
            call group_field(load, body, r(here), z(here), depth(here), part, error, friction, angle(here), threads)
            if (allocated(error)) return
            field(here, :) = part
            deallocate (part)
        end do
    end subroutine graded_field

    !> At points of few depths.
    subroutine group_field(load, body, r, z, depth, field, error, friction, angle, threads)
        class(load_t), intent(in) :: load
        class(body_t), intent(in) :: body
        !> the last one in units of a
        real(wp), intent(in) :: r(:), z(:), depth(:)
        real(wp), intent(out) :: field(:, :)
        type(error_t), allocatable, intent(inout) :: error
        real(wp), intent(in) :: friction, angle(:)
        integer, intent(in) :: threads
        type(gradient_states_t), target :: states
        type(lattice_t) :: lattice
        type(depth_t), allocatable :: depths(:)
        integer, allocatable :: first(:), which(:)
        real(wp) :: shear, poisson
        integer :: i, stat

        allocate (depths(size(z)), which(size(z)), stat=stat)
        call check_memory(error, stat)
        call distinct(depth, first, which, error)
        call new_lattice(lattice, r, depth, error)
        if (allocated(error)) return
        call new_gradient_states(states, body, load%radius, depth(first), error)
        if (allocated(error)) return
        do i = 1, size(z)
            depths(i)%z = depth(i)
            depths(i)%layer = which(i)
            depths(i)%shear = body%surface_material%shear()
            call body%moduli(z(i), shear, poisson)
            depths(i)%constants = of_isotropic(shear/(2.0_wp*depths(i)%shear), poisson)
        end do
        call state_field(load, states, lattice, r, z, depths, field, error, friction, angle, threads)
    end subroutine group_field

end module mdrcontact_inside_body_field
