! SPDX-License-Identifier: GPL-3.0-or-later
!> The imprint of a plastic contact (theory/plastic.md (1.3), (2.1)): while nothing yields, unloading and reloading are those of an
!> elastic contact of another profile on the same body.
module mdrcontact_plastic_imprint
    use mdrcontact_contact, only: contact_t, new_contact
    use mdrcontact_contact_load, only: contact_load_t
    use mdrcontact_contact_state, only: contact_state_t
    use mdrcontact_codes, only: von_mises
    use mdrcontact_error, only: check_finite, check_made, check_memory, check_not_negative, check_positive, count_text, &
                                error_domain, error_invalid, error_no_convergence, error_t, raise, to_text
    use mdrcontact_inside_critical, only: check_deviation, largest_of, new_stressed
    use mdrcontact_inside_largest, only: maximum_t, stressed_t
    use mdrcontact_kinds, only: half_pi, pi, wp
    use mdrcontact_line_legendre, only: normalisation
    use mdrcontact_line_series, only: even_sum
    use mdrcontact_line_springs, only: springs_t
    use mdrcontact_medium, only: check_elastic, medium_t
    use mdrcontact_medium_solver, only: check_springs
    use mdrcontact_object, only: room
    use mdrcontact_plastic_pressure, only: fit_pressure
    use mdrcontact_plastic_profile, only: imprint_profile_t, new_imprint_profile
    implicit none (type, external)
    private
    public :: imprint_t, new_imprint, new_imprint_from_pressure, new_imprint_of_two_terms

    !> A body and what the largest load has left on it. Immutable once created.
    type :: imprint_t
        !> the medium that unloads
        type(medium_t) :: medium
        !> the effective indenter; its depth counts from the end of contact
        type(imprint_profile_t) :: profile
        !> A [length], F [modulus length^2] and the depth [length] at the largest load
        real(wp) :: radius = 0.0_wp, force = 0.0_wp, depth = 0.0_wp
        !> the depth at which contact ends [length]
        real(wp) :: residual_depth = 0.0_wp
        !> work that unloading gives back [modulus length^3]
        real(wp) :: recovered_work = 0.0_wp
        !> parts of the pressure uniform + hertz sqrt(1 - r^2/A^2) where it has these two terms [modulus]
        real(wp) :: uniform = 0.0_wp, hertz = 0.0_wp
        !> part of F by which data would need a uniform part below 0, taken as 0; or misfit of a pressure at its points [1]
        real(wp) :: misfit = 0.0_wp
        !> whether it was made: set last by what makes it
        logical :: is_made = .false.
    contains
        procedure :: reverse_yield
    end type imprint_t

    !> What layers below the surface do to a line load at one contact radius: K q by Legendre polynomials.
    type :: layers_t
        real(wp) :: radius = 0.0_wp
        !> K between sqrt((4 j + 1)/2) P_2j(u); of size 0 on a half-space
        real(wp), allocatable :: matrix(:, :)
    contains
        procedure :: project
        procedure :: on_axis
    end type layers_t

    !> Legendre polynomials at most, and the part of their largest coefficient to which the last ones must have fallen.
    integer, parameter :: most_polynomials = 600
    real(wp), parameter :: last_coefficient = 1.0e-7_wp
    !> A uniform part below 0 by this part of F/A, as from a measured residual depth, is taken as 0; by that of q(0) it is rounding.
    real(wp), parameter :: largest_misfit = 0.005_wp, rounding = 1.0e-9_wp
    !> Ratio of stress and yield stress above which unloading yields again so much that the imprint does not hold.
    real(wp), parameter :: largest_ratio = 3.0_wp
    !> Thickness of a layer below which the search for its largest stress takes long [contact radius].
    real(wp), parameter :: thin = 0.1_wp
    !> Where the profile is seen to rise, in each half of its radius.
    integer, parameter :: probes = 200

contains

    !> The imprint from what a record knows: two terms of pressure, theory/plastic.md (2.4).
    subroutine new_imprint(self, medium, radius, force, residual_depth, depth, error)
        type(imprint_t), intent(out) :: self
        !> homogeneous or exact. Copied
        type(medium_t), intent(in) :: medium
        !> A > 0 [length] and F > 0 [modulus length^2] at the largest load
        real(wp), intent(in) :: radius, force
        !> at the end of contact, 0 <= residual_depth < depth, and at the largest load [length]
        real(wp), intent(in) :: residual_depth, depth
        type(error_t), allocatable, intent(out) :: error
        type(layers_t) :: layers
        real(wp) :: axis(2), loads(2), mean, modulus

        call check_made(error, "medium", medium%is_given())
        if (allocated(error)) return
        call check_positive(error, "radius", radius)
        call check_positive(error, "force", force)
        call check_positive(error, "depth", depth)
        call check_not_negative(error, "residual_depth", residual_depth)
        if (.not. allocated(error) .and. residual_depth >= depth) then
            call raise(error, error_invalid, " = "//to_text(residual_depth)//": it must be less than the depth at the largest "// &
                       "load, "//to_text(depth), "residual_depth")
        end if
        call begin(self, medium, radius, depth, layers, error)
        if (allocated(error)) return
        modulus = medium%solver%springs%modulus
        ! 2/3 A1 + pi/4 A2 = F/(2 A), and (L q)(0) = E0* (d - residual depth)
        call layers%on_axis([1.0_wp, 0.0_wp], axis(1), error)
        call layers%on_axis([0.0_wp, 1.0_wp], axis(2), error)
        if (allocated(error)) return
        mean = force/(2.0_wp*radius*modulus)
        loads(1) = (mean*axis(2) - 2.0_wp/3.0_wp*(depth - residual_depth))/(0.25_wp*pi*axis(2) - 2.0_wp/3.0_wp*axis(1))
        self%misfit = -loads(1)*modulus*radius/force
        if (self%misfit > largest_misfit) then
            call raise(error, error_invalid, " = "//to_text(residual_depth)//": with this force and radius the pressure falls "// &
                       "towards the edge by more than Hertz's. At least "//to_text(depth - 1.5_wp*mean*axis(2))// &
                       " is possible. Check radius, force and depth", "residual_depth")
            return
        end if
        if (.not. 3.0_wp*mean + (1.0_wp - 0.75_wp*pi)*loads(1) > 0.0_wp) then
            call raise(error, error_invalid, " = "//to_text(residual_depth)//": with this force and radius the line load rises "// &
                       "from the axis. Check radius, force and depth", "residual_depth")
            return
        end if
        if (loads(1) < rounding*(depth - residual_depth)) loads(1) = 0.0_wp
        if (self%misfit < rounding) self%misfit = 0.0_wp
        loads(2) = 1.5_wp*(mean - 0.25_wp*pi*loads(1))
        call finish(self, loads, layers, error)
        self%is_made = .not. allocated(error)
    end subroutine new_imprint

    !> The imprint of the pressure uniform + hertz sqrt(1 - r^2/A^2) at the largest load.
    subroutine new_imprint_of_two_terms(self, medium, radius, uniform, hertz, depth, error)
        type(imprint_t), intent(out) :: self
        !> homogeneous or exact. Copied
        type(medium_t), intent(in) :: medium
        !> A > 0 [length]
        real(wp), intent(in) :: radius
        !> >= 0 [modulus]
        real(wp), intent(in) :: uniform
        !> above -(2/pi) uniform, where the line load would rise [modulus]
        real(wp), intent(in) :: hertz
        !> at the largest load [length]
        real(wp), intent(in) :: depth
        type(error_t), allocatable, intent(out) :: error
        type(layers_t) :: layers

        call check_made(error, "medium", medium%is_given())
        if (allocated(error)) return
        call check_positive(error, "radius", radius)
        call check_not_negative(error, "uniform", uniform)
        call check_finite(error, "hertz", hertz)
        call check_finite(error, "depth", depth)
        if (.not. allocated(error) .and. .not. 2.0_wp*uniform + pi*hertz > 0.0_wp) then
            call raise(error, error_invalid, " = "//to_text(hertz)//": it must be greater than -2/pi of uniform, because the "// &
                       "line load must fall from the axis on", "hertz")
        end if
        call begin(self, medium, radius, depth, layers, error)
        if (allocated(error)) return
        call finish(self, [2.0_wp*uniform, half_pi*hertz]*(radius/medium%solver%springs%modulus), layers, error)
        self%is_made = .not. allocated(error)
    end subroutine new_imprint_of_two_terms

    !> The imprint of a pressure known at points, a polynomial in sqrt(1 - r^2/A^2) by least squares.
    subroutine new_imprint_from_pressure(self, medium, r, p, depth, error)
        type(imprint_t), intent(out) :: self
        !> homogeneous or exact. Copied
        type(medium_t), intent(in) :: medium
        !> ascending from >= 0 to A, at least 4 [length]
        real(wp), intent(in) :: r(:)
        !> >= 0 at the largest load, as many [modulus]
        real(wp), intent(in) :: p(:)
        !> at the largest load [length]
        real(wp), intent(in) :: depth
        type(error_t), allocatable, intent(out) :: error
        type(layers_t) :: layers
        real(wp), allocatable :: powers(:)
        real(wp) :: misfit
        integer :: k

        call check_made(error, "medium", medium%is_given())
        if (allocated(error)) return
        call check_finite(error, "depth", depth)
        call fit_pressure(r, p, powers, misfit, error)
        if (allocated(error)) return
        call begin(self, medium, r(size(r)), depth, layers, error)
        if (allocated(error)) return
        self%misfit = misfit
        ! a pressure s^k has the line load A B(1/2, k/2 + 1) s^(k + 1), B the same as moment(k)
        do k = 0, size(powers) - 1
            powers(k + 1) = powers(k + 1)*moment(k)*self%radius/medium%solver%springs%modulus
        end do
        call finish(self, powers, layers, error)
        self%is_made = .not. allocated(error)
    end subroutine new_imprint_from_pressure

    !> What all imprints have, after checks.
    subroutine begin(self, medium, radius, depth, layers, error)
        type(imprint_t), intent(inout) :: self
        type(medium_t), intent(in) :: medium
        real(wp), intent(in) :: radius, depth
        type(layers_t), intent(out) :: layers
        type(error_t), allocatable, intent(inout) :: error

        if (.not. allocated(error)) call check_elastic(medium, error)
        if (.not. allocated(error)) call check_springs(medium%solver, "an imprint is", error)
        if (.not. allocated(error) .and. medium%solver%is_rigid) then
            call raise(error, error_invalid, ": it is rigid. Pair it with a deformable body", "medium")
        end if
        if (.not. allocated(error)) call room(medium%bytes(), error)
        if (allocated(error)) return
        if (radius > medium%solver%largest_radius) then
            call raise(error, error_domain, " = "//to_text(radius)//": the medium is defined up to "// &
                       to_text(medium%solver%largest_radius)//trim(medium%solver%why_it_ends), "radius")
            return
        end if
        self%medium = medium
        self%radius = radius
        self%depth = depth
        layers%radius = radius
        call medium%solver%springs%interaction(radius, most_polynomials, layers%matrix, error)
    end subroutine begin

    !> Profile, depths and work of the line load q/E0* = sum_k loads(k) s^k: theory/plastic.md (1.3), (1.8).
    subroutine finish(self, loads, layers, error)
        type(imprint_t), intent(inout) :: self
        !> [length]
        real(wp), intent(in) :: loads(:)
        type(layers_t), intent(in) :: layers
        type(error_t), allocatable, intent(inout) :: error
        real(wp), allocatable :: q(:), v(:), values(:)
        real(wp) :: axis, modulus
        integer :: i, k, n

        modulus = self%medium%solver%springs%modulus
        axis = sum(loads)
        do k = 1, size(loads)
            self%force = self%force + self%radius*modulus*loads(k)*moment(k)
            do i = 1, size(loads)
                self%recovered_work = self%recovered_work + 0.5_wp*modulus*self%radius*loads(i)*loads(k)*moment(i + k)
            end do
        end do
        if (size(loads) == 2) then
            self%uniform = 0.5_wp*loads(1)*modulus/self%radius
            self%hertz = loads(2)*modulus/self%radius/half_pi
        end if
        n = size(layers%matrix, 1)
        if (n == 0) then
            call new_imprint_profile(self%profile, self%radius, loads, error)
        else
            call layers%project(loads, q, v, error)
            if (allocated(error)) return
            self%recovered_work = self%recovered_work + 0.5_wp*modulus*self%radius*dot_product(q, v)
            v = v*normalisation(n)
            associate (at_axis => even_sum(v, [0.0_wp]))
                axis = axis + at_axis(1)
                values = [((0.5_wp*(1.0_wp + cos(pi*(i - 0.5_wp)/n))), i=1, n)]
                values = (at_axis(1) - even_sum(v, sqrt(values)))/values
            end associate
            call new_imprint_profile(self%profile, self%radius, loads, error, values)
        end if
        self%residual_depth = self%depth - axis
        call check_numbers(self, error)
        call check_rise(self, error)
    end subroutine finish

    !> Raises if force or work are not normal numbers: of tiny or huge radii or pressures.
    pure subroutine check_numbers(self, error)
        type(imprint_t), intent(in) :: self
        type(error_t), allocatable, intent(inout) :: error

        if (self%force >= tiny(1.0_wp) .and. self%force <= huge(1.0_wp) .and. &
            self%recovered_work >= tiny(1.0_wp) .and. self%recovered_work <= huge(1.0_wp)) return
        call raise(error, error_no_convergence, " = "//to_text(self%radius)//": force or work at this pressure exceeds the "// &
                   "range of double precision. Choose other units", "radius")
    end subroutine check_numbers

    !> Raises where the profile falls: contact would not end on one disc.
    pure subroutine check_rise(self, error)
        type(imprint_t), intent(in) :: self
        type(error_t), allocatable, intent(inout) :: error
        real(wp) :: x
        integer :: i

        do i = 1, 2*probes - 1
            if (allocated(error)) return
            x = self%radius*sin(half_pi*i/(2*probes))
            if (self%profile%mdr_slope(x) < 0.0_wp) then
                call raise(error, error_domain, "the imprint of this pressure falls at x = "//to_text(x)//": the contact would "// &
                           "end in a ring. Only imprints whose contact is a disc are available")
            end if
        end do
    end subroutine check_rise

    !> Q_j = int q p_j du and V = K Q of p_j = sqrt((4 j + 1)/2) P_2j(u) on -1 < u < 1.
    subroutine project(self, loads, q, v, error)
        class(layers_t), intent(in) :: self
        real(wp), intent(in) :: loads(:)
        real(wp), allocatable, intent(out) :: q(:), v(:)
        type(error_t), allocatable, intent(inout) :: error
        real(wp) :: term
        integer :: j, k, n, stat

        n = size(self%matrix, 1)
        allocate (q(n), v(n), stat=stat)
        call check_memory(error, stat)
        if (allocated(error)) return
        q = 0.0_wp
        do k = 1, size(loads)
            ! int (1 - u^2)^(k/2) P_2j du by a ratio of gamma functions
            term = moment(k)
            do j = 0, n - 1
                q(j + 1) = q(j + 1) + loads(k)*term
                term = -term*(0.5_wp*k - j)*(j + 0.5_wp)/((0.5_wp*k + j + 1.5_wp)*(j + 1))
            end do
        end do
        q = q*normalisation(n)
        v = matmul(self%matrix, q)
        if (maxval(abs(v(n - 1:))) > last_coefficient*maxval(abs(v))) then
            call raise(error, error_no_convergence, "the imprint varies faster than "//count_text(n)//" polynomials resolve at "// &
                       "contact radius "//to_text(self%radius))
        end if
    end subroutine project

    !> (L q)(0) of the line load sum_k loads(k) s^k.
    subroutine on_axis(self, loads, y, error)
        class(layers_t), intent(in) :: self
        real(wp), intent(in) :: loads(:)
        real(wp), intent(out) :: y
        type(error_t), allocatable, intent(inout) :: error
        real(wp), allocatable :: q(:), v(:)
        real(wp) :: values(1)

        y = sum(loads)
        if (size(self%matrix) == 0) return
        call self%project(loads, q, v, error)
        if (allocated(error)) return
        values = even_sum(v*normalisation(size(v)), [0.0_wp])
        y = y + values(1)
    end subroutine on_axis

    !> int_-1^1 (1 - u^2)^(k/2) du.
    pure function moment(k) result(y)
        integer, intent(in) :: k
        real(wp) :: y
        integer :: i

        y = merge(2.0_wp, half_pi, modulo(k, 2) == 0)
        do i = merge(2, 3, modulo(k, 2) == 0), k, 2
            y = y*i/(i + 1)
        end do
    end function moment

    !> Computes R_Y, the largest von Mises stress of the elastic body under the pressure at the largest load over the yield stress
    !> of a layer
    !> (theory/plastic.md (1.9)). Above 3 it raises.
    subroutine reverse_yield(self, yield_stress, ratio, layer, error)
        class(imprint_t), intent(in) :: self
        !> > 0 of each layer from the surface and of the half-space last, infinite where it does not yield [modulus]
        real(wp), intent(in) :: yield_stress(:)
        !> the largest [1]
        real(wp), intent(out) :: ratio
        !> the layer where it is, 0 the first
        integer, intent(out) :: layer
        type(error_t), allocatable, intent(out) :: error
        type(contact_t), target :: contact
        type(contact_state_t) :: state
        type(contact_load_t) :: load
        type(stressed_t) :: body
        integer :: i

        ratio = 0.0_wp
        layer = 0
        call check_made(error, "imprint", self%is_made)
        if (allocated(error)) return
        do i = 1, size(yield_stress)
            if (.not. yield_stress(i) > 0.0_wp) then
                call raise(error, error_invalid, " = "//to_text(yield_stress(i))//": it must be greater than 0. Use infinity "// &
                           "for a layer that does not yield", "yield_stress", i)
                return
            end if
        end do
        call new_contact(contact, self%profile, self%medium, error)
        if (.not. allocated(error)) call contact%at_radius(self%radius, state, error)
        if (.not. allocated(error)) call contact%load(state, load, error)
        if (.not. allocated(error)) call new_stressed(body, load, .false., 0.0_wp, error)
        if (allocated(error)) return
        if (size(yield_stress) /= body%layers%bodies()) then
            call raise(error, error_invalid, "yield_stress has "//count_text(size(yield_stress))//" entries: the body has "// &
                       count_text(body%layers%bodies())//" layers with its half-space. Give one for each")
            return
        end if
        call check_deviation(load, .false., error)
        ! searches in thin layers take long: where their grid already shows far too much, its peaks do not matter
        if (any(body%layers%thickness < thin*self%radius)) then
            call find_largest(body, yield_stress, .true., ratio, layer, error)
        end if
        if (.not. ratio > 2.0_wp*largest_ratio) call find_largest(body, yield_stress, .false., ratio, layer, error)
        if (allocated(error)) return
        if (ratio > largest_ratio) call raise(error, error_domain, &
            " = "//to_text(yield_stress(layer + 1))//": R_Y = "//to_text(ratio)//" exceeds 3, so that layer "//count_text(layer)// &
            " yields again on unloading and the imprint does not hold. Use the measured unloading curve", "yield_stress", layer + 1)
    end subroutine reverse_yield

    !> The largest von Mises stress over the yield stress of a layer, and the layer. A coarse search gives that of its grids, and
    !> ends with a layer that yields by far.
    subroutine find_largest(body, yield_stress, is_coarse, ratio, layer, error)
        type(stressed_t), intent(inout) :: body
        real(wp), intent(in) :: yield_stress(:)
        logical, intent(in) :: is_coarse
        real(wp), intent(out) :: ratio
        integer, intent(out) :: layer
        type(error_t), allocatable, intent(inout) :: error
        type(maximum_t) :: found(1)
        integer :: i

        ratio = 0.0_wp
        layer = 0
        do i = 1, size(yield_stress)
            call largest_of(body, [von_mises], i - 1, is_coarse, found, error)
            if (allocated(error)) return
            if (found(1)%value/yield_stress(i) > ratio) then
                ratio = found(1)%value/yield_stress(i)
                layer = i - 1
            end if
            if (is_coarse .and. ratio > 2.0_wp*largest_ratio) return
        end do
    end subroutine find_largest

end module mdrcontact_plastic_imprint
