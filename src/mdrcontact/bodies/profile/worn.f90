! SPDX-License-Identifier: GPL-3.0-or-later
!> A worn indenter: any other one, less a depth W(r) that wear has taken from it.
module mdrcontact_profile_worn
    use, intrinsic :: iso_fortran_env, only: int64
    use mdrcontact_object, only: real_bytes
    use mdrcontact_error, only: check_memory, error_t
    use mdrcontact_kinds, only: wp
    use mdrcontact_numerics_quadrature, only: merge_breaks
    use mdrcontact_profile, only: copy, profile_t, root_beyond
    use mdrcontact_profile_free_surface, only: free_surface_t
    implicit none (type, external)
    private
    public :: worn_profile_t, new_worn_profile

    !> f(r) = f_0(r) + W(r) - W(0), W with a continuous and piecewise linear slope. With f' = a + b r from radius c on,
    !> g(x) = x [a arccos(c/x) + b sqrt(x^2 - c^2)], and a sum of such terms for the pieces. Where f is known as a free surface,
    !> heights and slopes are those of it, and the pieces serve g alone.
    type, extends(profile_t) :: worn_profile_t
        !> the indenter before it wore
        class(profile_t), allocatable :: base
        !> W' = slopes(i) + curvatures(i) r from radii(i), ascending from 0, to the next [length], [1], [1/length]
        real(wp), allocatable :: radii(:), slopes(:), curvatures(:)
        !> what the pieces add to those before them
        real(wp), allocatable, private :: more_slope(:), more_curvature(:)
        !> W at the radii [length]
        real(wp), allocatable, private :: depths(:)
        !> f between two radii
        type(free_surface_t), allocatable, private :: surface
    contains
        procedure :: worn_depth
        procedure :: height
        procedure :: slope
        procedure :: mdr
        procedure :: mdr_slope
        procedure :: mdr_moment
        procedure :: add_breaks
        procedure :: linear_pieces
        procedure :: bytes
    end type worn_profile_t

contains

    !> The indenter `base` with W(r) through values and slopes at some radii, by two parabolas in each interval.
    subroutine new_worn_profile(self, base, radii, depths, slopes, error, surface)
        type(worn_profile_t), intent(out) :: self
        !> copied
        class(profile_t), intent(in) :: base
        !> ascending, >= 0, at least 2; below the first and beyond the last one W has its value there [length]
        real(wp), intent(in) :: radii(:)
        !> W >= 0, 0 at the last radius unless the indenter ends there [length]; W' [1]: the first or the last one, if infinite, is
        !> that of one parabola
        real(wp), intent(in) :: depths(:), slopes(:)
        type(error_t), allocatable, intent(inout) :: error
        !> f itself between radii from the first on, below which nothing is worn
        type(free_surface_t), intent(in), optional :: surface
        real(wp) :: step, rise, middle, from, to
        integer :: i, n, stat

        n = size(radii)
        call copy(base, self%base, error)
        if (allocated(error)) return
        allocate (self%radii(2*n), self%slopes(2*n), self%curvatures(2*n), self%more_slope(2*n), self%more_curvature(2*n), &
                  self%depths(2*n), stat=stat)
        call check_memory(error, stat)
        if (stat /= 0) return
        self%largest_radius = base%largest_radius
        self%singular_radius = base%singular_radius
        self%end_radius = merge(base%end_radius, 0.0_wp, radii(1) > 0.0_wp)
        self%has_wall = base%has_wall
        self%sharp_radius = base%sharp_radius
        call set_piece(self, 1, 0.0_wp, 0.0_wp, 0.0_wp, depths(1))
        do i = 1, n - 1
            step = radii(i + 1) - radii(i)
            rise = (depths(i + 1) - depths(i))/step
            from = slopes(i)
            to = slopes(i + 1)
            if (abs(from) > huge(from)) from = 2.0_wp*rise - to
            if (abs(to) > huge(to)) to = 2.0_wp*rise - from
            middle = 2.0_wp*rise - 0.5_wp*(from + to)
            call set_piece(self, 2*i, radii(i), from, 2.0_wp*(middle - from)/step, depths(i))
            call set_piece(self, 2*i + 1, radii(i) + 0.5_wp*step, middle, 2.0_wp*(to - middle)/step, &
                           depths(i) + 0.25_wp*step*(from + middle))
        end do
        call set_piece(self, 2*n, radii(n), 0.0_wp, 0.0_wp, depths(n))
        self%is_made = .true.
        if (.not. present(surface)) return
        allocate (self%surface, source=surface, stat=stat)
        call check_memory(error, stat)
    end subroutine new_worn_profile

    !> The piece i from a radius on, where W, its slope and its curvature are given.
    pure subroutine set_piece(self, i, radius, slope, curvature, depth)
        type(worn_profile_t), intent(inout) :: self
        integer, intent(in) :: i
        real(wp), intent(in) :: radius, slope, curvature, depth

        self%radii(i) = radius
        self%slopes(i) = slope - curvature*radius
        self%curvatures(i) = curvature
        self%depths(i) = depth
        self%more_slope(i) = self%slopes(i)
        self%more_curvature(i) = curvature
        if (i == 1) return
        self%more_slope(i) = self%slopes(i) - self%slopes(i - 1)
        self%more_curvature(i) = curvature - self%curvatures(i - 1)
    end subroutine set_piece

    subroutine linear_pieces(self, radii, slopes, curvatures, base)
        class(worn_profile_t), intent(in), target :: self
        real(wp), allocatable, intent(out) :: radii(:), slopes(:), curvatures(:)
        class(profile_t), pointer, intent(out) :: base

        base => self%base
        radii = self%radii
        slopes = self%slopes
        curvatures = self%curvatures
    end subroutine linear_pieces

    pure recursive function bytes(self)
        class(worn_profile_t), intent(in) :: self
        integer(int64) :: bytes

        bytes = self%base%bytes() + 6*real_bytes*size(self%radii)
        if (allocated(self%surface)) bytes = bytes + self%surface%bytes()
    end function bytes

    !> W(r) [length].
    elemental function worn_depth(self, x) result(y)
        class(worn_profile_t), intent(in) :: self
        !> radius, from 0 to the largest one [length]
        real(wp), intent(in) :: x
        real(wp) :: y
        integer :: i

        if (allocated(self%surface)) then
            if (self%surface%holds(x)) then
                y = max(self%surface%height(x) - self%base%height(x), 0.0_wp)
                return
            end if
        end if
        i = piece_of(self, x)
        y = self%depths(i) + (x - self%radii(i))*(self%slopes(i) + 0.5_wp*self%curvatures(i)*(x + self%radii(i)))
    end function worn_depth

    !> The last piece that begins at or before x.
    pure function piece_of(self, x) result(low)
        class(worn_profile_t), intent(in) :: self
        real(wp), intent(in) :: x
        integer :: low
        integer :: high, middle

        low = 1
        high = size(self%radii) + 1
        do while (high - low > 1)
            middle = (low + high)/2
            if (self%radii(middle) <= x) then
                low = middle
            else
                high = middle
            end if
        end do
    end function piece_of

    elemental function height(self, x) result(y)
        class(worn_profile_t), intent(in) :: self
        real(wp), intent(in) :: x
        real(wp) :: y

        if (allocated(self%surface)) then
            if (self%surface%holds(x)) then
                y = self%surface%height(x)
                return
            end if
        end if
        y = self%base%height(x) + (self%worn_depth(x) - self%depths(1))
    end function height

    elemental function slope(self, x) result(y)
        class(worn_profile_t), intent(in) :: self
        real(wp), intent(in) :: x
        real(wp) :: y
        integer :: i

        if (allocated(self%surface)) then
            if (self%surface%holds(x)) then
                y = self%surface%slope(x)
                return
            end if
        end if
        i = piece_of(self, x)
        y = self%base%slope(x) + self%slopes(i) + self%curvatures(i)*x
    end function slope

    elemental function mdr(self, x) result(y)
        class(worn_profile_t), intent(in) :: self
        real(wp), intent(in) :: x
        real(wp) :: y
        real(wp) :: root
        integer :: i

        y = 0.0_wp
        do i = 1, count(self%radii < x)
            root = root_beyond(x, self%radii(i))
            y = y + self%more_slope(i)*atan2(root, self%radii(i)) + self%more_curvature(i)*root
        end do
        y = self%base%mdr(x) + x*y
    end function mdr

    elemental function mdr_slope(self, x) result(y)
        class(worn_profile_t), intent(in) :: self
        real(wp), intent(in) :: x
        real(wp) :: y
        real(wp) :: root, jump
        integer :: i

        y = self%base%mdr_slope(x)
        do i = 1, count(self%radii < x)
            root = root_beyond(x, self%radii(i))
            y = y + self%more_slope(i)*atan2(root, self%radii(i)) + 2.0_wp*self%more_curvature(i)*root
            ! W' is continuous but where wear begins or ends
            jump = self%more_slope(i) + self%more_curvature(i)*self%radii(i)
            if (i == 2 .or. i == size(self%radii)) y = y + jump*self%radii(i)/root
        end do
    end function mdr_slope

    elemental function mdr_moment(self, x) result(y)
        class(worn_profile_t), intent(in) :: self
        real(wp), intent(in) :: x
        real(wp) :: y
        real(wp) :: root
        integer :: i

        y = self%base%mdr_moment(x)
        do i = 1, count(self%radii < x)
            root = root_beyond(x, self%radii(i))
            y = y + 0.5_wp*self%more_slope(i)*(x**2*atan2(root, self%radii(i)) + self%radii(i)*root) &
                + self%more_curvature(i)*root*(x**2 - root**2/3.0_wp)
        end do
    end function mdr_moment

    !> Breaks of the indenter, and the ends of the worn part.
    pure subroutine add_breaks(self, radii, error)
        class(worn_profile_t), intent(in) :: self
        real(wp), allocatable, intent(inout) :: radii(:)
        type(error_t), allocatable, intent(inout) :: error

        call self%base%add_breaks(radii, error)
        if (self%radii(2) > 0.0_wp) call merge_breaks(radii, [self%radii(2)], error)
        call merge_breaks(radii, [self%radii(size(self%radii))], error)
    end subroutine add_breaks

end module mdrcontact_profile_worn
