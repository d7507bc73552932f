! SPDX-License-Identifier: GPL-3.0-or-later
!> A height between two radii c and b that rises from c as the free surface next to a contact does: analytic not in r but in s =
!> sqrt(r^2 - c^2). Chebyshev series of s on panels.
module mdrcontact_profile_free_surface
    use, intrinsic :: iso_fortran_env, only: int64
    use mdrcontact_object, only: real_bytes
    use mdrcontact_error, only: check_memory, error_t
    use mdrcontact_kinds, only: wp
    use mdrcontact_numerics_chebyshev, only: chebyshev_sum, cosine_transform, differentiate, node
    use mdrcontact_numerics_search, only: interval_of
    implicit none (type, external)
    private
    public :: free_surface_t, new_free_surface, panel_points, panel_radii, series_of

    !> Points of a panel, and terms of its series.
    integer, parameter :: panel_points = 24

    !> Heights between c and b [length] at radii r [length].
    type :: free_surface_t
        !> c and b [length]
        real(wp) :: inner = 0.0_wp, outer = 0.0_wp
        !> ends of the panels, s from 0 on [length]
        real(wp), allocatable :: ends(:)
        !> series of the height [length], and of its slope by s [1], (panel_points, panels)
        real(wp), allocatable :: heights(:, :), slopes(:, :)
    contains
        procedure :: holds
        procedure :: height
        procedure :: slope
        procedure :: bytes
    end type free_surface_t

contains

    !> The surface of these panels.
    subroutine new_free_surface(self, inner, outer, ends, heights, error)
        type(free_surface_t), intent(out) :: self
        !> 0 < c < b [length]
        real(wp), intent(in) :: inner, outer
        !> of the panels, s from 0 to that of b [length]
        real(wp), intent(in) :: ends(:)
        !> series of each panel, by `series_of` [length]
        real(wp), intent(in) :: heights(:, :)
        type(error_t), allocatable, intent(inout) :: error
        integer :: i, stat

        allocate (self%ends(size(ends)), self%heights(panel_points, size(heights, 2)), &
                  self%slopes(panel_points, size(heights, 2)), stat=stat)
        call check_memory(error, stat)
        if (stat /= 0) return
        self%inner = inner
        self%outer = outer
        self%ends(:) = ends
        self%heights(:, :) = heights
        do i = 1, size(heights, 2)
            call differentiate(heights(:, i), self%slopes(:, i))
            self%slopes(:, i) = self%slopes(:, i)*(2.0_wp/(ends(i + 1) - ends(i)))
        end do
    end subroutine new_free_surface

    !> Radii of the points of a panel [length].
    pure function panel_radii(inner, from, to) result(r)
        !> c, and the ends of the panel, in s [length]
        real(wp), intent(in) :: inner, from, to
        real(wp) :: r(panel_points)
        integer :: i

        r = hypot(inner, 0.5_wp*(from + to) + 0.5_wp*(to - from)*[(node(i, panel_points), i=1, panel_points)])
    end function panel_radii

    !> The series through the values at the points of a panel.
    pure function series_of(values) result(coefficients)
        real(wp), intent(in) :: values(panel_points)
        real(wp) :: coefficients(panel_points)
        real(wp) :: cosines(panel_points, panel_points)

        call cosine_transform(cosines)
        coefficients = matmul(values, cosines)
    end function series_of

    !> Whether a radius lies between c and b.
    elemental function holds(self, r) result(answer)
        class(free_surface_t), intent(in) :: self
        real(wp), intent(in) :: r
        logical :: answer

        answer = r > self%inner .and. r < self%outer
    end function holds

    !> The height at c < r < b [length].
    elemental function height(self, r) result(y)
        class(free_surface_t), intent(in) :: self
        real(wp), intent(in) :: r
        real(wp) :: y
        real(wp) :: z
        integer :: panel

        call find_place(self, sqrt((r - self%inner)*(r + self%inner)), panel, z)
        y = chebyshev_sum(self%heights(:, panel), z)
    end function height

    !> Its slope by r there [1].
    elemental function slope(self, r) result(y)
        class(free_surface_t), intent(in) :: self
        real(wp), intent(in) :: r
        real(wp) :: y
        real(wp) :: z, s
        integer :: panel

        s = sqrt((r - self%inner)*(r + self%inner))
        call find_place(self, s, panel, z)
        y = chebyshev_sum(self%slopes(:, panel), z)*(r/s)
    end function slope

    !> The panel that holds s, and the place in it, -1 to 1.
    pure subroutine find_place(self, s, panel, z)
        class(free_surface_t), intent(in) :: self
        real(wp), intent(in) :: s
        integer, intent(out) :: panel
        real(wp), intent(out) :: z

        panel = interval_of(self%ends, s)
        associate (from => self%ends(panel), to => self%ends(panel + 1))
            z = min((2.0_wp*s - from - to)/(to - from), 1.0_wp)
        end associate
    end subroutine find_place

    pure function bytes(self)
        class(free_surface_t), intent(in) :: self
        integer(int64) :: bytes

        bytes = real_bytes*(size(self%ends) + 2*size(self%heights, kind=int64))
    end function bytes

end module mdrcontact_profile_free_surface
