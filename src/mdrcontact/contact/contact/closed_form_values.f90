! SPDX-License-Identifier: GPL-3.0-or-later
!> The closed forms at many contact radii, on one thread or several.
module mdrcontact_contact_closed_form_values
    use mdrcontact_batch, only: map_t, run_map
    use mdrcontact_codes, only: of_adhesive_depth => form_adhesive_depth, of_cone_force => form_cone_force, &
                                of_depth_scale => form_depth_scale, of_paraboloid_force => form_paraboloid_force, &
                                of_radius_scale => form_radius_scale, of_reduced_depth => form_reduced_depth
    use mdrcontact_contact_closed_forms, only: adhesive_depth_scale, adhesive_radius_scale, coated_cone_force, &
                                               coated_paraboloid_adhesive_depth, coated_paraboloid_force, &
                                               reduced_adhesive_depth
    use mdrcontact_kinds, only: wp
    implicit none (type, external)
    private
    public :: closed_form_values
    public :: of_paraboloid_force, of_cone_force, of_adhesive_depth, of_reduced_depth, of_radius_scale, of_depth_scale

    type, extends(map_t) :: closed_form_map_t
        integer :: form = of_paraboloid_force
        real(wp) :: numbers(5) = 0.0_wp
    contains
        procedure :: values
    end type closed_form_map_t

contains

    !> One of the closed forms at many radii.
    subroutine closed_form_values(form, a, numbers, y, threads)
        !> of_...
        integer, intent(in) :: form
        !> contact radii > 0 [length], reduced ones for of_reduced_depth, those of the paraboloid for both scales
        real(wp), intent(in), contiguous :: a(:)
        !> the function's other arguments in their order, at most 5
        real(wp), intent(in) :: numbers(:)
        !> same size as a
        real(wp), intent(inout), contiguous :: y(:)
        !> at least 1, or 0 for as many as OpenMP offers; few radii stay on one
        integer, intent(in) :: threads
        type(closed_form_map_t) :: map

        map%form = form
        map%numbers(:size(numbers)) = numbers
        call run_map(map, a, y, threads)
    end subroutine closed_form_values

    pure subroutine values(self, x, y)
        class(closed_form_map_t), intent(in) :: self
        real(wp), intent(in) :: x(:)
        real(wp), intent(out) :: y(:)
        integer :: i

        associate (p => self%numbers)
            select case (self%form)
            case (of_paraboloid_force)
                do i = 1, size(x)
                    y(i) = coated_paraboloid_force(x(i), p(1), p(2), p(3), p(4))
                end do
            case (of_cone_force)
                do i = 1, size(x)
                    y(i) = coated_cone_force(x(i), p(1), p(2), p(3), p(4))
                end do
            case (of_adhesive_depth)
                do i = 1, size(x)
                    y(i) = coated_paraboloid_adhesive_depth(x(i), p(1), p(2), p(3), p(4), p(5))
                end do
            case (of_radius_scale)
                do i = 1, size(x)
                    y(i) = adhesive_radius_scale(x(i), p(1), p(2))
                end do
            case (of_depth_scale)
                do i = 1, size(x)
                    y(i) = adhesive_depth_scale(x(i), p(1), p(2))
                end do
            case default
                do i = 1, size(x)
                    y(i) = reduced_adhesive_depth(x(i), p(1), p(2))
                end do
            end select
        end associate
    end subroutine values

end module mdrcontact_contact_closed_form_values
