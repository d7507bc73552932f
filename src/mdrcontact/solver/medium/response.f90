! SPDX-License-Identifier: GPL-3.0-or-later
!> Displacement of the surface of a body in space: under a point force and under a uniform pressure on a rectangle
!> (theory/exact.md (6.1)-(6.5)).
!>
!> k C(k)/2 is fitted by a constant and a sum of exponentials, whose surface displacements are elementary: each is that of a
!> half-space at a depth, an image. The fit belongs to the body; it is made once and then serves all points and rectangles.
module mdrcontact_medium_response
    use, intrinsic :: iso_fortran_env, only: int64
    use mdrcontact_batch, only: batch_t, run_batch
    use mdrcontact_body, only: body_t
    use mdrcontact_body_chain, only: chain_t
    use mdrcontact_body_compliance, only: compliance_t, normal_load
    use mdrcontact_error, only: check_made, check_memory, check_positive, count_text, error_no_convergence, error_t, raise, to_text
    use mdrcontact_kinds, only: pi, wp
    use mdrcontact_lapack, only: dgels
    use mdrcontact_medium_compliance, only: compliance_limits, compliance_limits_t, normal_compliance
    use mdrcontact_medium_rectangle, only: rectangle_potential
    use mdrcontact_medium_viscoelastic, only: viscoelastic_t
    use mdrcontact_nonfinite, only: is_finite
    use mdrcontact_object, only: object_t, real_bytes
    use mdrcontact_tension_surface, only: surface_t
    implicit none (type, external)
    private
    public :: new_response, point_response, rectangle_response, response_t

    !> Images that are tried in turn, wavenumbers of the fit for each of them, and of the check.
    integer, parameter :: numbers_of_images(3) = [60, 120, 240], nodes = 8, checks = 21
    !> Depth of the images from `nearest` over the wavenumber beyond which the body counts as its surface, to `farthest` over that
    !> below which it counts as its base, where k C has reached `part` of its change.
    real(wp), parameter :: nearest = 8.0_wp, farthest = 10.0_wp, part = 1.0e-2_wp
    !> Wavenumbers of the fit and of the check reach so far below the last one; rounding of the fit's weights.
    real(wp), parameter :: below_of_fit = 1.0e-4_wp, below_of_check = 1.0e-7_wp, ridge = 1.0e-14_wp
    !> Range in which k C is searched for its change, around the lengths of the body, and wavenumbers of a decade.
    real(wp), parameter :: beyond = 1.0e12_wp
    integer, parameter :: of_decade = 8
    !> Points that a thread takes at a time, and from how many on several threads pay.
    integer, parameter :: block = 256, smallest = 2048

    !> The surface of a body in space. Made by new_response; its numbers must only be read.
    type, extends(object_t) :: response_t
        !> k C/2 at large k [1/modulus]
        real(wp) :: bare = 0.0_wp
        !> of the images [1/modulus]
        real(wp), allocatable :: weight(:)
        !> depths of the images, ascending [length]
        real(wp), allocatable :: depth(:)
        !> largest error of k C/2, checked between the nodes, over its largest value [1]
        real(wp) :: error = 0.0_wp
    contains
        procedure :: bytes
    end type response_t

    !> The fit of an elastic body, or of one that has relaxed.
    interface new_response
        module procedure of_elastic, of_relaxed
    end interface new_response

    !> k C/2 of a body and its surface.
    type :: source_t
        class(compliance_t), allocatable :: compliance
        type(surface_t) :: surface
        type(compliance_limits_t) :: limits
    end type source_t

    type, extends(batch_t) :: rectangle_batch_t
        type(response_t), pointer :: response => null()
        real(wp), pointer, contiguous :: x(:) => null(), y(:) => null(), values(:) => null()
        real(wp) :: half(2) = 0.0_wp
    contains
        procedure :: work
    end type rectangle_batch_t

contains

    !> Fits as many images as the tolerance takes.
    subroutine of_elastic(self, body, surface, tolerance, error)
        type(response_t), intent(out) :: self
        class(body_t), intent(in) :: body
        !> properties of its surface
        type(surface_t), intent(in) :: surface
        !> largest error of k C/2 over its largest value, > 0 [1]
        real(wp), intent(in) :: tolerance
        type(error_t), allocatable, intent(out) :: error
        type(source_t) :: source

        source%surface = surface
        call check_made(error, "body", body%is_made)
        if (.not. allocated(error)) call normal_compliance(body, surface, source%compliance, error)
        if (.not. allocated(error)) call compliance_limits(body, surface, source%limits, error)
        call fit_images(self, source, tolerance, error)
    end subroutine of_elastic

    !> The same of a viscoelastic body that has relaxed.
    subroutine of_relaxed(self, body, tolerance, error)
        type(response_t), intent(out) :: self
        type(viscoelastic_t), intent(in) :: body
        real(wp), intent(in) :: tolerance
        type(error_t), allocatable, intent(out) :: error
        type(source_t) :: source
        type(chain_t) :: chain

        call check_made(error, "body", body%is_made)
        if (.not. allocated(error)) call body%chain_at(normal_load, (0.0_wp, 0.0_wp), chain, error)
        if (.not. allocated(error)) allocate (source%compliance, source=chain)
        if (.not. allocated(error)) call compliance_limits(body, 0.0_wp, source%limits, error)
        call fit_images(self, source, tolerance, error)
    end subroutine of_relaxed

    pure recursive function bytes(self)
        class(response_t), intent(in) :: self
        integer(int64) :: bytes

        bytes = 2*real_bytes*size(self%weight)
    end function bytes

    subroutine fit_images(self, source, tolerance, error)
        type(response_t), intent(inout) :: self
        type(source_t), intent(in) :: source
        real(wp), intent(in) :: tolerance
        type(error_t), allocatable, intent(inout) :: error
        real(wp) :: ends(2), unit
        integer :: i

        if (.not. allocated(error)) call check_positive(error, "tolerance", tolerance)
        if (allocated(error)) return
        self%bare = real(source%limits%short, wp)
        call find_ends(source, 0.1_wp*tolerance, ends, unit, error)
        if (allocated(error)) return
        if (ends(2) <= 0.0_wp) then
            allocate (self%weight(0), self%depth(0))
        else
            do i = 1, size(numbers_of_images)
                call fit(self, source, numbers_of_images(i), ends, unit, error)
                if (allocated(error)) return
                if (self%error <= tolerance) exit
            end do
        end if
        if (.not. self%error <= tolerance) then
            call raise(error, error_no_convergence, "tolerance = "//to_text(tolerance)//": "// &
                       count_text(numbers_of_images(size(numbers_of_images)))//" images have an error of "// &
                       to_text(self%error)//". Give a tolerance of at least that")
        end if
        self%is_made = .not. allocated(error)
    end subroutine fit_images

    !> Wavenumbers below which k C is about that of the base, and beyond which it is that of the surface but for `change` times its
    !> largest value; 0 where it does not depend on k.
    subroutine find_ends(source, change, ends, unit, error)
        type(source_t), intent(in) :: source
        real(wp), intent(in) :: change
        real(wp), intent(out) :: ends(2)
        !> the largest k C/2 [1/modulus]
        real(wp), intent(out) :: unit
        type(error_t), allocatable, intent(inout) :: error
        real(wp), allocatable :: k(:), f(:)
        real(wp) :: lengths(2), most
        integer :: i, stat

        ends = 0.0_wp
        unit = max(real(source%limits%short, wp), real(source%limits%long, wp))
        lengths = lengths_with_surface(source)
        if (lengths(2) <= 0.0_wp) return
        i = ceiling(of_decade*log10(beyond**2*lengths(2)/lengths(1)))
        allocate (k(i), f(i), stat=stat)
        call check_memory(error, stat)
        if (stat /= 0) return
        k(:) = between(1.0_wp/(beyond*lengths(2)), beyond/lengths(1), size(k))
        call half_of_waves(source, k, f)
        unit = max(unit, maxval(f))
        associate (short => real(source%limits%short, wp), long => real(source%limits%long, wp))
            most = max(maxval(abs(f - long)), maxval(abs(f - short)))
            do i = size(k), 1, -1
                if (abs(f(i) - short) > change*unit) exit
            end do
            if (i == 0) return
            ends(2) = k(i)
            do i = 1, size(k)
                if (abs(f(i) - long) > part*most) exit
            end do
            ends(1) = min(k(min(i, size(k))), ends(2))
        end associate
    end subroutine find_ends

    !> The shortest and the longest length of a body and its surface, 0 of a half-space.
    pure function lengths_with_surface(source) result(lengths)
        type(source_t), intent(in) :: source
        real(wp) :: lengths(2)
        real(wp) :: all(4), scale

        scale = real(source%compliance%scale, wp)
        all(:2) = source%compliance%lengths()
        all(3:) = [abs(source%surface%tension)*2.0_wp/scale, (source%surface%bending*2.0_wp/scale)**(1.0_wp/3.0_wp)]
        lengths = 0.0_wp
        if (any(all > 0.0_wp)) lengths = [minval(all, mask=all > 0.0_wp), maxval(all)]
    end function lengths_with_surface

    !> k C/2 [1/modulus].
    subroutine half_of_waves(source, k, values)
        type(source_t), intent(in) :: source
        real(wp), intent(in) :: k(:)
        real(wp), intent(out) :: values(:)
        complex(wp) :: one_plus_chi(1), chi(1)
        integer :: i

        do i = 1, size(k)
            call source%compliance%chi([cmplx(k(i), kind=wp)], one_plus_chi, chi)
            values(i) = real(one_plus_chi(1)/source%compliance%scale, wp)
        end do
        values = values/(1.0_wp + 2.0_wp*(source%surface%tension + source%surface%bending*k**2)*k*values)
    end subroutine half_of_waves

    !> So many images at depths in geometric progression, and their error.
    subroutine fit(self, source, n, ends, unit, error)
        type(response_t), intent(inout) :: self
        type(source_t), intent(in) :: source
        integer, intent(in) :: n
        real(wp), intent(in) :: ends(2), unit
        type(error_t), allocatable, intent(inout) :: error
        real(wp), allocatable :: right(:, :), matrix(:, :), work(:)
        integer :: rows, info, stat

        rows = nodes*n
        if (allocated(self%weight)) deallocate (self%weight, self%depth)
        allocate (self%weight(n), self%depth(n), right(rows + n - 1, 1), matrix(rows + n - 1, n - 1), work(4*(rows + n)), &
                  stat=stat)
        call check_memory(error, stat)
        if (stat /= 0) return
        self%depth(:) = between(nearest/ends(2), max(farthest/ends(1), 2.0_wp*nearest/ends(2)), n)
        call set_system(self, source, ends, unit, matrix, right(:, 1))
        call dgels("N", rows + n - 1, n - 1, 1, matrix, rows + n - 1, right, rows + n - 1, work, size(work), info)
        if (info /= 0 .or. .not. all(is_finite(right(:n - 1, 1)))) then
            call raise(error, error_no_convergence, "body: its compliance cannot be represented by images")
            return
        end if
        self%weight(:n - 1) = unit*right(:n - 1, 1)
        self%weight(n) = real(source%limits%long, wp) - self%bare - sum(self%weight(:n - 1))
        self%error = largest_error(self, source, ends)/unit
    end subroutine fit

    !> Least squares for the weights but the last: their sum is the difference of the limits.
    subroutine set_system(self, source, ends, unit, matrix, right)
        type(response_t), intent(in) :: self
        type(source_t), intent(in) :: source
        real(wp), intent(in) :: ends(2), unit
        real(wp), intent(out) :: matrix(:, :), right(:)
        real(wp) :: k(nodes*size(self%depth)), last(size(k))
        integer :: i, n

        n = size(self%depth)
        k = between(below_of_fit*ends(1), 2.0_wp*ends(2), size(k))
        last = exp(-k*self%depth(n))
        right = 0.0_wp
        call half_of_waves(source, k, right(:size(k)))
        right(:size(k)) = (right(:size(k)) - self%bare - (real(source%limits%long, wp) - self%bare)*last)/unit
        matrix = 0.0_wp
        do i = 1, n - 1
            matrix(:size(k), i) = exp(-k*self%depth(i)) - last
            matrix(size(k) + i, i) = ridge
        end do
    end subroutine set_system

    !> The largest error of k C/2 at wavenumbers between those of the fit and beyond them [1/modulus].
    function largest_error(self, source, ends) result(largest)
        type(response_t), intent(in) :: self
        type(source_t), intent(in) :: source
        real(wp), intent(in) :: ends(2)
        real(wp) :: largest
        real(wp) :: k(checks*size(self%depth)), exact(size(k))
        integer :: i

        k = between(below_of_check*ends(1), 5.0_wp*ends(2), size(k))
        call half_of_waves(source, k, exact)
        largest = 0.0_wp
        do i = 1, size(k)
            largest = max(largest, abs(self%bare + sum(self%weight*exp(-k(i)*self%depth)) - exact(i)))
        end do
    end function largest_error

    !> Numbers in geometric progression.
    pure function between(first, last, n) result(numbers)
        real(wp), intent(in) :: first, last
        integer, intent(in) :: n
        real(wp) :: numbers(n)
        integer :: i

        numbers = [(first*(last/first)**(real(i, wp)/real(n - 1, wp)), i=0, n - 1)]
    end function between

    !> Displacement of the surface by a unit point force (theory/exact.md (6.3)).
    pure subroutine point_response(self, r, values)
        type(response_t), intent(in) :: self
        !> distances from the force > 0 [length]
        real(wp), intent(in) :: r(:)
        !> same size as r [1/(modulus length)]
        real(wp), intent(out) :: values(:)
        integer :: i

        do i = 1, size(r)
            values(i) = (self%bare/r(i) + sum(self%weight/hypot(r(i), self%depth)))/pi
        end do
    end subroutine point_response

    !> Displacement of the surface by a unit pressure on a rectangle whose centre is the origin (theory/exact.md (6.4)).
    subroutine rectangle_response(self, width, height, x, y, values, threads, error)
        type(response_t), intent(in), target :: self
        !> sides along x and y, > 0 [length]
        real(wp), intent(in) :: width, height
        !> points [length]
        real(wp), intent(in), target, contiguous :: x(:), y(:)
        !> same size as x [length/modulus]
        real(wp), intent(inout), target, contiguous :: values(:)
        !> at least 1, or 0 for as many as OpenMP offers
        integer, intent(in) :: threads
        type(error_t), allocatable, intent(out) :: error
        type(rectangle_batch_t) :: batch

        call check_made(error, "response", self%is_made)
        if (.not. allocated(error)) call check_positive(error, "width", width)
        if (.not. allocated(error)) call check_positive(error, "height", height)
        if (allocated(error)) return
        batch%is_quick = .true.
        batch%response => self
        batch%half = 0.5_wp*[width, height]
        batch%x => x
        batch%y => y
        batch%values => values
        call run_batch(batch, size(x), block, smallest, threads, error)
    end subroutine rectangle_response

    subroutine work(self, first, last, error)
        class(rectangle_batch_t), intent(inout) :: self
        integer, intent(in) :: first, last
        type(error_t), allocatable, intent(out) :: error
        integer :: i

        associate (response => self%response)
            do i = first, last
                self%values(i) = rectangle_potential(self%half, abs(self%x(i)), abs(self%y(i)), response%bare, response%weight, &
                                                     response%depth)/pi
            end do
        end associate
    end subroutine work

end module mdrcontact_medium_response
