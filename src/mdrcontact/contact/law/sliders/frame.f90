! SPDX-License-Identifier: GPL-3.0-or-later
!> Sliders in a tangent plane that turns.
module mdrcontact_law_sliders_frame
    use mdrcontact_kinds, only: wp
    use mdrcontact_law_levels, only: levels_t
    use mdrcontact_law_sliders_record, only: at_law, at_normal, head
    implicit none (type, external)
    private
    public :: turn_record

contains

    !> All t turned with the tangent plane: by the least rotation from its old normal to the new one, and about that by an angle.
    !> Where no old normal is known, each is laid into the plane with the length it has.
    pure subroutine turn_record(levels, normal, angle, record)
        type(levels_t), intent(in) :: levels
        !> of length 1
        real(wp), intent(in) :: normal(3)
        !> [1]
        real(wp), intent(in) :: angle
        real(wp), intent(inout), contiguous :: record(:)
        real(wp) :: t(3), axis(3), cosine
        integer :: i
        logical :: known

        associate (old => record(at_normal:at_normal + 2))
            known = any(abs(old) > 0.0_wp)
            axis = cross(old, normal)
            cosine = dot_product(old, normal)
        end associate
        do i = head + 1 + levels%sliders, head + 2*levels%sliders
            t = record(i:i + 2*levels%sliders:levels%sliders)
            if (.not. any(abs(t) > 0.0_wp)) cycle
            if (.not. known) then
                call lay(t, normal)
            else if (cosine > -1.0_wp) then
                t = cosine*t + cross(axis, t) + dot_product(axis, t)/(1.0_wp + cosine)*axis
            end if
            t = cos(angle)*t + sin(angle)*cross(normal, t)
            record(i:i + 2*levels%sliders:levels%sliders) = t
        end do
        record(at_law) = levels%mark
        record(at_normal:at_normal + 2) = normal
    end subroutine turn_record

    pure subroutine lay(vector, normal)
        real(wp), intent(inout) :: vector(3)
        real(wp), intent(in) :: normal(3)
        real(wp) :: length, left

        length = norm2(vector)
        vector = vector - dot_product(vector, normal)*normal
        left = norm2(vector)
        if (left > 0.0_wp) vector = length/left*vector
    end subroutine lay

    pure function cross(a, b) result(product)
        real(wp), intent(in) :: a(3), b(3)
        real(wp) :: product(3)

        product = [a(2)*b(3) - a(3)*b(2), a(3)*b(1) - a(1)*b(3), a(1)*b(2) - a(2)*b(1)]
    end function cross

end module mdrcontact_law_sliders_frame
