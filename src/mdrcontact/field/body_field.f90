! SPDX-License-Identifier: GPL-3.0-or-later
!> Displacements and stresses inside a body, layered or graded.
!>
!> A graded body is replaced by homogeneous layers with the constants of their middles and with faces at the points' depths, where
!> the error falls with the square of their thickness: fields of three divisions are extrapolated (Richardson). Stresses along the
!> faces take the constants just at the point. Points nearer to the surface than a part of the uppermost layer stay inside it.
module mdrcontact_field_body_field
    use mdrcontact_body, only: body_t
    use mdrcontact_body_layers, only: layers_t
    use mdrcontact_error, only: check_memory, error_t
    use mdrcontact_field_interior, only: components, interior_field
    use mdrcontact_field_lattice, only: distinct
    use mdrcontact_field_load, only: load_t
    use mdrcontact_kinds, only: wp
    implicit none (type, external)
    private
    public :: body_field

    !> Thickness of a graded body's layers relative to a + z in the coarsest division.
    real(wp), parameter :: coarsest = 0.1_wp
    integer, parameter :: divisions = 3
    !> Depths of a graded body that share a division into layers.
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
        integer, allocatable :: first(:), which(:)
        integer :: group, stat

        if (.not. body%is_graded) then
            call body%sublayers(load%radius, coarsest, z(:0), layers, error)
            call interior_field(load, layers, r, z, below, field, error, friction, angle, threads)
            return
        end if
        allocate (which(size(z)), stat=stat)
        call check_memory(error, stat)
        call distinct(z, first, which, error)
        if (allocated(error)) return
        do group = 0, (size(first) - 1)/depths_together
            call group_field(count((which - 1)/depths_together == group))
            if (allocated(error)) return
        end do

    contains

        !> The field at the n points of this group of depths.
        subroutine group_field(n)
            integer, intent(in) :: n
            real(wp), allocatable :: r_here(:), z_here(:), angle_here(:), part(:, :)
            integer :: i, j

            allocate (r_here(n), z_here(n), angle_here(n), part(n, components), stat=stat)
            call check_memory(error, stat)
            if (stat /= 0) return
            j = 0
            do i = 1, size(z)
                if ((which(i) - 1)/depths_together /= group) cycle
                j = j + 1
                r_here(j) = r(i)
                z_here(j) = z(i)
                angle_here(j) = angle(i)
            end do
            call graded_field(load, body, r_here, z_here, part, error, friction, angle_here, threads)
            if (allocated(error)) return
            j = 0
            do i = 1, size(z)
                if ((which(i) - 1)/depths_together /= group) cycle
                j = j + 1
                field(i, :) = part(j, :)
            end do
        end subroutine group_field

    end subroutine body_field

    subroutine graded_field(load, body, r, z, field, error, friction, angle, threads)
        class(load_t), intent(in) :: load
        class(body_t), intent(in) :: body
        real(wp), intent(in) :: r(:), z(:)
        real(wp), intent(out) :: field(:, :)
        type(error_t), allocatable, intent(out) :: error
        real(wp), intent(in) :: friction, angle(:)
        integer, intent(in) :: threads
        type(layers_t) :: layers
        real(wp), allocatable :: fields(:, :, :), faces(:)
        real(wp) :: ratio
        integer, allocatable :: first(:), which(:)
        integer :: i, j, stat

        allocate (fields(size(r), components, divisions), which(size(z)), stat=stat)
        call check_memory(error, stat)
        call distinct(z, first, which, error)
        if (allocated(error)) return
        ratio = coarsest*0.5_wp**(divisions - 1)
        ! at most depths_together
        faces = z(first)
        do i = 1, divisions
            ! points above the finest first layer stay inside it
            call body%sublayers(load%radius, coarsest*0.5_wp**(i - 1), pack(faces, faces > 0.25_wp*ratio*load%radius), layers, &
                                error)
            if (allocated(error)) return
            call interior_field(load, layers, r, z, .true., fields(:, :, i), error, friction, angle, threads)
            if (allocated(error)) return
        end do
        do j = 1, divisions - 1
            do i = divisions, j + 1, -1
                where (abs(fields(:, :, i)) <= huge(1.0_wp))
                    fields(:, :, i) = fields(:, :, i) + (fields(:, :, i) - fields(:, :, i - 1))/(4.0_wp**j - 1.0_wp)
                end where
            end do
        end do
        field = fields(:, :, divisions)
    end subroutine graded_field

end module mdrcontact_field_body_field
