! SPDX-License-Identifier: GPL-3.0-or-later
!> The indenter (theory/paper.md (1.1), (1.2)): a profile f(r), f(0) = 0, and its one-dimensional MDR profile g(x).
!>
!> A rigid axisymmetric indenter enters every contact problem through four functions of one radius and one
!> integral, which each shape provides in closed form where there is one.
!> Popov, Phys. Mesomech. 17 (2014) 50, equations (3) and (4).
module mdrcontact_profile
    use mdrcontact_object, only: object_t, room
    use mdrcontact_parameter, only: parameter_t
    use mdrcontact_error, only: check_made, error_t
    use mdrcontact_kinds, only: wp
    use mdrcontact_numerics_quadrature, only: merge_breaks
    implicit none (type, external)
    private
    public :: copy, profile_t, root_after, root_beyond

    !> An axisymmetric indenter. Concrete shapes are made by their `new_...` procedures and never change afterwards: numbers must
    !> only be read.
    !>
    !> The functions are elemental and do not check their argument: it must lie in [0, largest_radius],
    !> below the end where the profile ends in a vertical tangent (sphere). Beyond it they return NaN or are undefined.
    type, abstract, extends(object_t) :: profile_t
        !> the largest radius at which the profile is defined [length]; huge() where there is no end
        real(wp) :: largest_radius = huge(1.0_wp)
        !> where g is singular at its end [length]: quadrature is refined towards it; huge() where it is not
        real(wp) :: singular_radius = huge(1.0_wp)
        !> radius of the flat end [length], 0 if it does not exist: the contact radius as the depth tends to 0
        real(wp) :: end_radius = 0.0_wp
        !> whether the profile rises vertically at largest_radius, so that the contact radius stays there (flat punch)
        logical :: has_wall = .false.
        !> radius at which it ends as an imprint does [length], 0 if it does not: g' may be infinite there, no contact is larger,
        !> and an adhesive edge rests there until the springs are drawn
        real(wp) :: sharp_radius = 0.0_wp
        !> R of a paraboloid f(r) = r^2/(2R) [length]; 0 for any other shape
        real(wp) :: paraboloid_radius = 0.0_wp
    contains
        !> f(r), the height of the surface above its lowest point [length]
        procedure(radial_function), deferred :: height
        !> f'(r) [1]
        procedure(radial_function), deferred :: slope
        !> g(x), equation (3) [length]
        procedure(radial_function), deferred :: mdr
        !> g at many places, for profiles that are faster at it
        procedure :: mdr_at
        !> g'(x) [1]
        procedure(radial_function), deferred :: mdr_slope
        !> g' at a distance beyond a radius, with full accuracy next to the edge of a flat end, where it is infinite
        procedure :: mdr_slope_beyond
        !> int_0^x s g'(s) ds [length^2]; a homogeneous body's force is 2 E* times it
        procedure(radial_function), deferred :: mdr_moment
        !> adds to ascending radii those at which f is not analytic, in (0, largest_radius); quadrature is split there
        procedure :: add_breaks
        !> where a search for the contact radius at a depth begins: the inverse of g if it has a closed form [length]; else negative
        procedure :: radius_from_mdr => no_inverse
        !> g as a sum of powers c x^s where it is one
        procedure :: powers => no_powers
        !> f', or what it adds to another profile's, where that is piecewise linear
        procedure :: linear_pieces => no_pieces
        !> whether it is a paraboloid, or a sphere, which is one near its axis
        procedure :: is_spherical
        !> its numbers, the arguments of its `new_...` procedure; none of tables, functions and sums
        procedure :: parameters => no_parameters
        !> the same shape with other numbers
        procedure :: with_parameters
        !> puts these numbers into a copy of the shape
        procedure :: set => nothing
    end type profile_t

    !> A copy of an indenter, after a trial of the memory that it takes.
    interface copy
        module procedure copy_profile
    end interface copy

    abstract interface
        elemental function radial_function(self, x) result(y)
            import :: profile_t, wp
            class(profile_t), intent(in) :: self
            !> distance from the axis, 0 <= x <= largest_radius [length]
            real(wp), intent(in) :: x
            real(wp) :: y
        end function radial_function
    end interface

contains

    pure function mdr_at(self, x) result(y)
        class(profile_t), intent(in) :: self
        !> 0 <= x <= largest_radius [length]
        real(wp), intent(in) :: x(:)
        real(wp) :: y(size(x))

        y = self%mdr(x)
    end function mdr_at

    elemental function mdr_slope_beyond(self, start, distance) result(y)
        class(profile_t), intent(in) :: self
        !> start >= 0, distance >= 0 [length]
        real(wp), intent(in) :: start, distance
        real(wp) :: y

        y = self%mdr_slope(start + distance)
    end function mdr_slope_beyond

    !> The edge of a flat end.
    pure subroutine add_breaks(self, radii, error)
        class(profile_t), intent(in) :: self
        !> ascending [length]; not allocated: none yet
        real(wp), allocatable, intent(inout) :: radii(:)
        type(error_t), allocatable, intent(inout) :: error

        if (self%end_radius > 0.0_wp .and. self%end_radius < self%largest_radius) then
            call merge_breaks(radii, [self%end_radius], error)
        else if (.not. allocated(radii)) then
            allocate (radii(0))
        end if
    end subroutine add_breaks

    pure function no_inverse(self, depth) result(radius)
        class(profile_t), intent(in) :: self
        !> d >= 0 [length]
        real(wp), intent(in) :: depth
        real(wp) :: radius

        associate (unused => self, also_unused => depth)
        end associate
        radius = -1.0_wp
    end function no_inverse

    pure subroutine no_powers(self, exponents, coefficients)
        class(profile_t), intent(in) :: self
        !> s > 0 [1] and c [length^(1-s)] of each term; none where g is not such a sum
        real(wp), allocatable, intent(out) :: exponents(:), coefficients(:)

        associate (unused => self)
        end associate
        allocate (exponents(0), coefficients(0))
    end subroutine no_powers

    subroutine no_pieces(self, radii, slopes, curvatures, base)
        class(profile_t), intent(in), target :: self
        !> f'(r) = slopes(i) + curvatures(i) r from radii(i), ascending from 0, to the next [length], [1], [1/length]; none where f'
        !> is not such a function
        real(wp), allocatable, intent(out) :: radii(:), slopes(:), curvatures(:)
        !> the profile to which they are added; null: none
        class(profile_t), pointer, intent(out) :: base

        associate (unused => self)
        end associate
        nullify (base)
        allocate (radii(0), slopes(0), curvatures(0))
    end subroutine no_pieces

    pure subroutine no_parameters(self, list)
        class(profile_t), intent(in) :: self
        type(parameter_t), allocatable, intent(out) :: list(:)

        associate (unused => self)
        end associate
        allocate (list(0))
    end subroutine no_parameters

    subroutine with_parameters(self, values, profile, error)
        class(profile_t), intent(in) :: self
        !> in the order of `parameters`
        real(wp), intent(in) :: values(:)
        class(profile_t), allocatable, intent(out) :: profile
        type(error_t), allocatable, intent(out) :: error

        call check_made(error, "profile", self%is_made)
        if (allocated(error)) return
        call copy(self, profile, error)
        if (.not. allocated(error)) call profile%set(values, error)
    end subroutine with_parameters

    subroutine nothing(self, values, error)
        class(profile_t), intent(inout) :: self
        !> in the order of `parameters`
        real(wp), intent(in) :: values(:)
        type(error_t), allocatable, intent(inout) :: error

        associate (unused => self, also_unused => values, and_this => error)
        end associate
    end subroutine nothing

    pure function is_spherical(self) result(answer)
        class(profile_t), intent(in) :: self
        logical :: answer
        real(wp), allocatable :: exponents(:), coefficients(:)

        call self%powers(exponents, coefficients)
        answer = size(exponents) > 0 .and. all(exponents == 2.0_wp)
    end function is_spherical

    !> The same indenter; an error where there is no memory for it.
    subroutine copy_profile(from, to, error)
        class(profile_t), intent(in) :: from
        class(profile_t), allocatable, intent(out) :: to
        type(error_t), allocatable, intent(inout) :: error

        call room(from%bytes(), error)
        if (.not. allocated(error)) allocate (to, source=from)
    end subroutine copy_profile

    !> sqrt(x^2 - b^2) without cancellation, 0 for x <= b: the root that every flat end and tangent point brings into g(x).
    elemental function root_beyond(x, b) result(root)
        real(wp), intent(in) :: x, b
        real(wp) :: root

        root = sqrt(max(x - b, 0.0_wp)*(x + b))
    end function root_beyond

    !> The same for x = b + gap, whose gap is known to more digits than the difference x - b.
    elemental function root_after(gap, b) result(root)
        real(wp), intent(in) :: gap, b
        real(wp) :: root

        root = sqrt(max(gap, 0.0_wp)*(gap + 2.0_wp*b))
    end function root_after

end module mdrcontact_profile
