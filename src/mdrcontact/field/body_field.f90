! SPDX-License-Identifier: GPL-3.0-or-later
!> Displacements and stresses inside a body, layered or graded.
!>
!> A graded body is replaced by homogeneous layers with the constants of their middles and with faces at the points' depths, where
!> the error falls with the square of their thickness: fields of three divisions are extrapolated (Richardson). Stresses along the
!> faces take the constants just at the point. Points nearer to the surface than a part of the uppermost layer stay inside it.
module mdrcontact_field_body_field
    use mdrcontact_body, only: body_t
    use mdrcontact_body_layers, only: layers_t
    use mdrcontact_error, only: error_t
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
        real(wp), allocatable :: part(:, :)
        integer, allocatable :: first(:), chosen(:)
        integer :: which(size(z)), group, i

        if (.not. body%is_graded) then
            call body%sublayers(load%radius, coarsest, z(:0), layers)
            call interior_field(load, layers, r, z, below, field, error, friction, angle, threads)
            return
        end if
        call distinct(z, first, which)
        do group = 0, (size(first) - 1)/depths_together
            chosen = pack([(i, i=1, size(z))], (which - 1)/depths_together == group)
            allocate (part(size(chosen), components))
            call graded_field(load, body, r(chosen), z(chosen), part, error, friction, angle(chosen), threads)
            if (allocated(error)) return
            field(chosen, :) = part
            deallocate (part)
        end do
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
        real(wp) :: fields(size(r), components, divisions), faces(size(z)), ratio
        integer, allocatable :: first(:)
        integer :: which(size(z)), i, j

        call distinct(z, first, which)
        ratio = coarsest*0.5_wp**(divisions - 1)
        faces = -1.0_wp
        faces(:size(first)) = z(first)
        do i = 1, divisions
            ! points above the finest first layer stay inside it
            call body%sublayers(load%radius, coarsest*0.5_wp**(i - 1), pack(faces, faces > 0.25_wp*ratio*load%radius), layers)
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
