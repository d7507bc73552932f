! SPDX-License-Identifier: GPL-3.0-or-later
!> The states of a body whose constants vary with depth, and the images that represent its short waves near the surface.
!>
!> The equation of the state is integrated (theory/stress.md (2.5)), by the power series in k of mdrcontact_body_elements_gradient:
!> compliances go up, tractions down. Near the surface what remains in addition to the homogeneous half-space falls only as 1/k. It
!> is a Laplace transform, and from a wavenumber on a sum of (alpha + beta k z) e^(-k (z + s)) over few s follows it: fields of
!> half-spaces again, s deeper. They are found by least squares and compared with the states between the wavenumbers of the fit.
module mdrcontact_inside_gradient_states
    use mdrcontact_body, only: body_t
    use mdrcontact_body_elements_gradient, only: anti_plane_rate, gradient_series, in_plane_rate, multiply_series, order
    use mdrcontact_body_elements_layer, only: half_space_compliance
    use mdrcontact_body_sublayers, only: faces_through
    use mdrcontact_error, only: check_memory, error_no_convergence, error_t, raise, to_text
    use mdrcontact_inside_half_space, only: half_space_rule_t
    use mdrcontact_inside_isotropic, only: isotropic_half_space_t, new_isotropic_half_space
    use mdrcontact_inside_states, only: depth_t, normal_rows, shear_rows, states_t
    use mdrcontact_inside_waves, only: faded
    use mdrcontact_kinds, only: wp
    use mdrcontact_lapack, only: dgels
    use mdrcontact_medium_load, only: load_t
    use mdrcontact_numerics_quadrature, only: new_antiderivative
    use mdrcontact_numerics_small_matrices, only: inverse, times_matrix
    implicit none (type, external)
    private
    public :: gradient_states_t, new_gradient_states

    !> Nodes of a step.
    integer, parameter :: nodes = 10
    !> Waves see steps through one series while k times their depth is at most this.
    real(wp), parameter :: longest = 0.5_wp
    !> The first step is at most so deep [a].
    real(wp), parameter :: first_step = 1.0e-10_wp
    !> Images represent waves from the first number on, or from the second at most, to the third [1/a].
    real(wp), parameter :: first_cutoff = 800.0_wp, last_cutoff = 2.0e5_wp, shortest_wave = 1.0e6_wp
    !> Shifts and wavenumbers of the fit: each so many times as large as the one before.
    real(wp), parameter :: shift_ratio = 1.4_wp, wave_ratio = 1.12_wp
    !> Misfit of the images, weighted with (k/cutoff)^(-1/2), that is the target and that is an error, and what the amplitudes
    !> count in the fit. Under a smooth load the error of a stress is 1/20 of the misfit.
    real(wp), parameter :: tolerance = 3.0e-9_wp, refused = 2.0e-7_wp, ridge = 1.0e-13_wp

    !> States of a graded body.
    type, extends(states_t) :: gradient_states_t
        private
        !> depths of the ends of the steps, 0 first, and which of them the depths in use are [a]
        real(wp), allocatable :: faces(:), z(:)
        integer, allocatable :: place(:)
        !> transfer matrices of each step, and of all from the surface to its end (row, row, power of k, step)
        real(wp), allocatable :: series(:, :, :, :), from_surface(:, :, :, :), across(:, :, :, :), across_from_surface(:, :, :, :)
        !> compliance of a half-space of the material at each end
        real(wp), allocatable :: compliance(:, :, :), compliance_across(:)
        !> (wavenumber, row, depth)
        real(wp), allocatable :: y(:, :, :)
        !> images of the half-space, so far above the surface [a]: (alpha + beta k z) e^(-k (z + shift)), (image, row, depth)
        real(wp), allocatable :: shifts(:), alpha(:, :, :), beta(:, :, :)
        !> of the surface
        type(isotropic_half_space_t) :: surface
        !> depths at which the half-space is taken away, and where its images begin [1/a]
        logical, allocatable :: is_near(:)
        real(wp) :: cutoff = 0.0_wp
    contains
        procedure :: turn
        procedure :: add_images
        procedure :: prepare
        procedure :: state
    end type gradient_states_t

contains

    !> At distinct depths.
    subroutine new_gradient_states(self, body, radius, z, error)
        type(gradient_states_t), intent(out) :: self
        class(body_t), intent(in) :: body
        !> contact radius [length], and depths [a]
        real(wp), intent(in) :: radius, z(:)
        type(error_t), allocatable, intent(inout) :: error
        real(wp) :: surface(2), here(2), most, least
        integer :: i

        self%z = z
        allocate (self%place(size(z)), self%is_near(size(z)))
        self%is_near = .false.
        call faces_through(body, radius*min(first_step, minval(z, mask=z > 0.0_wp)), pack(radius*z, z > 0.0_wp), self%faces, &
                           error)
        if (allocated(error)) return
        self%faces(:) = self%faces/radius
        do i = 1, size(z)
            self%place(i) = minloc(abs(self%faces - z(i)), dim=1) - 1
        end do
        call build(self, body, radius, error)
        self%steps = size(self%faces) - 1
        call new_isotropic_half_space(self%surface, body%surface_material%poisson)
        allocate (self%half_space, source=self%surface)
        surface = constants(body, 0.0_wp)
        most = 1.0_wp
        least = 1.0_wp
        do i = 1, size(self%faces)
            here = constants(body, radius*self%faces(i))
            most = max(most, here(1)/surface(1))
            least = min(least, here(1)/surface(1))
        end do
        self%structure = body%last_depth/radius*most/least
    end subroutine new_gradient_states

    !> G and nu; above the first depth those of the surface.
    pure function constants(body, z) result(values)
        class(body_t), intent(in) :: body
        !> [length]
        real(wp), intent(in) :: z
        real(wp) :: values(2)

        call body%moduli(merge(0.5_wp*body%first_depth, z, z < body%first_depth), values(1), values(2))
    end function constants

    !> The series of all steps.
    subroutine build(self, body, radius, error)
        type(gradient_states_t), intent(inout) :: self
        class(body_t), intent(in) :: body
        real(wp), intent(in) :: radius
        type(error_t), allocatable, intent(inout) :: error
        real(wp) :: antiderivative(nodes + 1, nodes), t(nodes), here(2), surface(2), length
        real(wp) :: in_plane(4, 4, nodes), anti_plane(2, 2, nodes)
        integer :: i, j, n, stat

        n = size(self%faces) - 1
        allocate (self%series(4, 4, 0:order, n), self%from_surface(4, 4, 0:order, n), self%across(2, 2, 0:order, n), &
                  self%across_from_surface(2, 2, 0:order, n), self%compliance(2, 2, n), self%compliance_across(n), stat=stat)
        call check_memory(error, stat)
        call new_antiderivative(t, antiderivative, error)
        if (allocated(error)) return
        surface = constants(body, 0.0_wp)
        do i = 1, n
            length = self%faces(i + 1) - self%faces(i)
            do j = 1, nodes
                here = constants(body, radius*(self%faces(i) + length*t(j)))
                in_plane(:, :, j) = in_plane_rate(here(1)/surface(1), here(2))
                anti_plane(:, :, j) = anti_plane_rate(here(1)/surface(1))
            end do
            call gradient_series(antiderivative, length, in_plane, self%series(:, :, :, i))
            call gradient_series(antiderivative, length, anti_plane, self%across(:, :, :, i))
            self%from_surface(:, :, :, i) = self%series(:, :, :, i)
            self%across_from_surface(:, :, :, i) = self%across(:, :, :, i)
            if (i > 1) then
                self%from_surface(:, :, :, i) = self%from_surface(:, :, :, i - 1)
                call multiply_series(self%from_surface(:, :, :, i), self%series(:, :, :, i))
                self%across_from_surface(:, :, :, i) = self%across_from_surface(:, :, :, i - 1)
                call multiply_series(self%across_from_surface(:, :, :, i), self%across(:, :, :, i))
            end if
            here = constants(body, radius*self%faces(i + 1))
            self%compliance(:, :, i) = real(half_space_compliance(cmplx(here(2), kind=wp)), wp)*(surface(1)/here(1))
            self%compliance_across(i) = -surface(1)/here(1)
        end do
    end subroutine build

    !> Finds the images under a load of one direction.
    subroutine turn(self, along_surface, depths, error)
        class(gradient_states_t), intent(inout) :: self
        logical, intent(in) :: along_surface
        type(depth_t), intent(inout) :: depths(:)
        type(error_t), allocatable, intent(inout) :: error
        real(wp) :: misfit
        integer :: i

        self%along_surface = along_surface
        self%cutoff = first_cutoff
        if (allocated(self%shifts)) deallocate (self%shifts, self%alpha, self%beta)
        do
            self%is_near(:) = self%z*self%cutoff < faded
            misfit = 0.0_wp
            if (any(self%is_near)) call find_images(self, misfit, error)
            if (allocated(error)) return
            if (misfit <= tolerance .or. self%cutoff >= last_cutoff) exit
            self%cutoff = 2.0_wp*self%cutoff
        end do
        if (misfit > refused) then
            call raise(error, error_no_convergence, "z: above a depth of "//to_text(faded/self%cutoff)// &
                       " contact radii the stresses in this graded body have an error of about "//to_text(0.05_wp*misfit)// &
                       " of the largest, because its constants vary too steeply. Use deeper points")
            return
        end if
        do i = 1, size(depths)
            depths(i)%less = self%is_near(depths(i)%layer)
            depths(i)%last = self%cutoff
            if (.not. depths(i)%less) depths(i)%last = faded/depths(i)%z
        end do
    end subroutine turn

    !> The images at all near depths, for waves shorter than the cutoff, and how well they fit between the waves of the fit.
    subroutine find_images(self, misfit, error)
        class(gradient_states_t), intent(inout) :: self
        real(wp), intent(out) :: misfit
        type(error_t), allocatable, intent(inout) :: error
        real(wp), allocatable :: k(:), weight(:)
        integer :: i, n, waves, rows

        misfit = 0.0_wp
        rows = merge(shear_rows, normal_rows, self%along_surface)
        n = ceiling(log(100.0_wp*shortest_wave/self%cutoff)/log(shift_ratio))
        ! even ones are compared only
        waves = 2*ceiling(log(shortest_wave/self%cutoff)/log(wave_ratio)) + 1
        if (allocated(self%shifts)) deallocate (self%shifts, self%alpha, self%beta)
        k = self%cutoff*wave_ratio**[(0.5_wp*real(i - 1, wp), i=1, waves)]
        weight = sqrt(self%cutoff/k)
        call prepare(self, k, error)
        if (allocated(error)) return
        self%shifts = [0.0_wp, (30.0_wp/self%cutoff*shift_ratio**(2 - i), i=2, n)]
        allocate (self%alpha(n, rows, size(self%z)), self%beta(n, rows, size(self%z)), source=0.0_wp)
        do i = 1, size(self%z)
            if (.not. self%is_near(i)) cycle
            call fit_images(k, weight, self%z(i), self%shifts, self%y(:, :, i), self%alpha(:, :, i), self%beta(:, :, i), misfit)
        end do
    end subroutine find_images

    !> Closed forms for bodies other than the half-space.
    pure subroutine add_images(self, rule, load, depth, r, sums)
        class(gradient_states_t), intent(in) :: self
        type(half_space_rule_t), intent(in) :: rule
        class(load_t), intent(in) :: load
        type(depth_t), intent(in) :: depth
        !> distance from the axis [length]
        real(wp), intent(in) :: r
        real(wp), intent(inout) :: sums(:)
        integer :: j

        if (.not. allocated(self%shifts)) return
        do j = 1, size(self%shifts)
            associate (shift => self%shifts(j), alpha => self%alpha(j, :, depth%layer), beta => self%beta(j, :, depth%layer))
                if (self%along_surface) then
                    call self%surface%add_shear_image(rule, load, shift, alpha, beta, r, depth%z, sums)
                else
                    call self%surface%add_normal_image(rule, load, shift, alpha, beta, r, depth%z, sums)
                end if
            end associate
        end do
    end subroutine add_images

    !> At one depth; on the surface no state is left where waves are short.
    subroutine fit_images(k, weight, z, shifts, y, alpha, beta, misfit)
        real(wp), intent(in) :: k(:), weight(:), z, shifts(:), y(:, :)
        !> (image, row)
        real(wp), intent(inout) :: alpha(:, :), beta(:, :)
        !> the larger one of what it was and that of this depth
        real(wp), intent(inout) :: misfit
        real(wp), allocatable :: basis(:, :), matrix(:, :), right(:, :), work(:)
        integer :: first, n, m, i, j, images, info

        images = size(shifts)
        first = merge(1, 2, z > 0.0_wp)
        n = merge(2, 1, z > 0.0_wp)*(images - first + 1)
        m = (size(k) + 1)/2
        allocate (basis(size(k), n), matrix(m + n, n), right(m + n, size(y, 2)), work(64*(m + n)))
        do j = first, images
            basis(:, j - first + 1) = weight*exp(-k*(z + shifts(j)))
            if (z > 0.0_wp) basis(:, images + j) = k*z*basis(:, j)
        end do
        matrix(:, :) = 0.0_wp
        right(:, :) = 0.0_wp
        do i = 1, n
            matrix(:m, i) = basis(1::2, i)
            matrix(m + i, i) = ridge
        end do
        do i = 1, size(y, 2)
            right(:m, i) = weight(1::2)*y(1::2, i)
        end do
        call dgels("N", m + n, n, size(y, 2), matrix, m + n, right, m + n, work, size(work), info)
        do i = 1, size(y, 2)
            misfit = max(misfit, maxval(abs(weight*y(:, i) - matmul(basis, right(:n, i)))))
        end do
        alpha(first:, :) = right(:images - first + 1, :)
        if (z > 0.0_wp) beta(:, :) = right(images + 1:n, :)
    end subroutine fit_images

    !> The states at all depths, at near ones less the half-space and its images.
    subroutine prepare(self, k, error)
        class(gradient_states_t), intent(inout) :: self
        real(wp), intent(in) :: k(:)
        type(error_t), allocatable, intent(inout) :: error
        integer :: i, j, stat

        if (allocated(self%y)) deallocate (self%y)
        allocate (self%y(size(k), merge(shear_rows, normal_rows, self%along_surface), size(self%z)), stat=stat)
        call check_memory(error, stat)
        if (stat /= 0) return
        do i = 1, size(k)
            call plane_states(self, k(i), merge([1.0_wp, 0.0_wp], [0.0_wp, -1.0_wp], self%along_surface), self%y(i, 1:4, :))
            if (self%along_surface) call across_states(self, k(i), self%y(i, 5:6, :))
        end do
        do i = 1, size(self%z)
            if (.not. self%is_near(i)) cycle
            self%y(:, :, i) = self%y(:, :, i) - half_space_state(self, k, self%z(i))
            if (.not. allocated(self%shifts)) cycle
            do j = 1, size(self%shifts)
                call take_image(k, self%z(i), self%shifts(j), self%alpha(j, :, i), self%beta(j, :, i), self%y(:, :, i))
            end do
        end do
    end subroutine prepare

    pure subroutine take_image(k, z, shift, alpha, beta, y)
        real(wp), intent(in) :: k(:), z, shift, alpha(:), beta(:)
        real(wp), intent(inout) :: y(:, :)
        integer :: i

        do i = 1, size(y, 2)
            y(:, i) = y(:, i) - (alpha(i) + k*z*beta(i))*exp(-k*(z + shift))
        end do
    end subroutine take_image

    !> State of a half-space of the surface material; see add_normal_sums and add_shear_sums.
    pure function half_space_state(self, k, z) result(y)
        class(gradient_states_t), intent(in) :: self
        real(wp), intent(in) :: k(:), z
        real(wp) :: y(size(k), merge(shear_rows, normal_rows, self%along_surface))
        integer :: i

        associate (nu => self%surface%poisson)
            if (self%along_surface) then
                y(:, 1) = k*z - 2.0_wp*(1.0_wp - nu)
                y(:, 2) = 1.0_wp - 2.0_wp*nu + k*z
                y(:, 3) = 1.0_wp - k*z
                y(:, 4) = -k*z
                y(:, 5) = 2.0_wp
                y(:, 6) = -1.0_wp
            else
                y(:, 1) = k*z - (1.0_wp - 2.0_wp*nu)
                y(:, 2) = 2.0_wp*(1.0_wp - nu) + k*z
                y(:, 3) = -k*z
                y(:, 4) = -1.0_wp - k*z
            end if
        end associate
        do i = 1, size(y, 2)
            y(:, i) = y(:, i)*exp(-k*z)
        end do
    end function half_space_state

    !> The steps that a wave sees: those down to `seen` together, one by one to `last`.
    pure subroutine steps_of(self, k, seen, last)
        class(gradient_states_t), intent(in) :: self
        real(wp), intent(in) :: k
        integer, intent(out) :: seen, last

        last = min(count(self%faces(2:)*k < faded) + 1, size(self%faces) - 1)
        seen = min(count(self%faces(2:)*k <= longest), last)
    end subroutine steps_of

    !> y1 to y4 at the depths, under the traction `load` = (T, S).
    pure subroutine plane_states(self, k, load, y)
        class(gradient_states_t), intent(in) :: self
        real(wp), intent(in) :: k, load(2)
        !> (row, depth)
        real(wp), intent(out) :: y(:, :)
        real(wp) :: m(2, 2, 0:size(self%faces)), down(2, 2, size(self%faces)), p(4, 4), d(2, 2), t(2, 2), top(4)
        !> displacements and tractions at the top by the displacements below
        real(wp), dimension(2, 2) :: by_moving, by_pulling
        real(wp) :: traction(2, 0:size(self%faces))
        integer :: i, seen, last

        call steps_of(self, k, seen, last)
        m(:, :, last) = self%compliance(:, :, last)
        do i = last, seen + 1, -1
            p = series_at(self%series(:, :, :, i), k)
            by_moving = p(1:2, 1:2)
            by_pulling = p(3:4, 1:2)
            d = times_matrix(by_moving, m(:, :, i)) + p(1:2, 3:4)
            t = times_matrix(by_pulling, m(:, :, i)) + p(3:4, 3:4)
            down(:, :, i) = inverse(t)
            m(:, :, i - 1) = times_matrix(d, down(:, :, i))
        end do
        if (seen > 0) then
            p = series_at(self%from_surface(:, :, :, seen), k)
            by_moving = p(1:2, 1:2)
            by_pulling = p(3:4, 1:2)
            d = times_matrix(by_moving, m(:, :, seen)) + p(1:2, 3:4)
            t = inverse(times_matrix(by_pulling, m(:, :, seen)) + p(3:4, 3:4))
            top = [matmul(times_matrix(d, t), load), load]
            traction(:, seen) = matmul(t, load)
        else
            top = [matmul(m(:, :, 0), load), load]
            traction(:, 0) = load
        end if
        do i = seen + 1, last
            traction(1, i) = down(1, 1, i)*traction(1, i - 1) + down(1, 2, i)*traction(2, i - 1)
            traction(2, i) = down(2, 1, i)*traction(1, i - 1) + down(2, 2, i)*traction(2, i - 1)
        end do
        do i = 1, size(self%z)
            associate (at => self%place(i))
                if (at == 0) then
                    y(:, i) = top
                else if (at > last) then
                    y(:, i) = 0.0_wp
                else if (at >= seen) then
                    y(:, i) = [matmul(m(:, :, at), traction(:, at)), traction(:, at)]
                else
                    ! the inverse of a symplectic matrix
                    p = series_at(self%from_surface(:, :, :, at), k)
                    y(:2, i) = matmul(top(:2), p(3:4, 3:4)) - matmul(top(3:), p(1:2, 3:4))
                    y(3:, i) = matmul(top(3:), p(1:2, 1:2)) - matmul(top(:2), p(3:4, 1:2))
                end if
            end associate
        end do
    end subroutine plane_states

    !> y5 and N at the depths, under N = -1.
    pure subroutine across_states(self, k, y)
        class(gradient_states_t), intent(in) :: self
        real(wp), intent(in) :: k
        !> (row, depth)
        real(wp), intent(out) :: y(:, :)
        real(wp) :: m(0:size(self%faces)), down(size(self%faces)), p(2, 2), top(2), traction(0:size(self%faces))
        integer :: i, seen, last

        call steps_of(self, k, seen, last)
        m(last) = self%compliance_across(last)
        do i = last, seen + 1, -1
            p = series_at(self%across(:, :, :, i), k)
            down(i) = 1.0_wp/(p(2, 1)*m(i) + p(2, 2))
            m(i - 1) = (p(1, 1)*m(i) + p(1, 2))*down(i)
        end do
        top = [-m(0), -1.0_wp]
        traction(seen) = -1.0_wp
        if (seen > 0) then
            p = series_at(self%across_from_surface(:, :, :, seen), k)
            traction(seen) = -1.0_wp/(p(2, 1)*m(seen) + p(2, 2))
            top = [(p(1, 1)*m(seen) + p(1, 2))*traction(seen), -1.0_wp]
        end if
        do i = seen + 1, last
            traction(i) = down(i)*traction(i - 1)
        end do
        do i = 1, size(self%z)
            associate (at => self%place(i))
                if (at == 0) then
                    y(:, i) = top
                else if (at > last) then
                    y(:, i) = 0.0_wp
                else if (at >= seen) then
                    y(:, i) = [m(at), 1.0_wp]*traction(at)
                else
                    p = series_at(self%across_from_surface(:, :, :, at), k)
                    y(:, i) = [p(2, 2)*top(1) - p(1, 2)*top(2), p(1, 1)*top(2) - p(2, 1)*top(1)]
                end if
            end associate
            ! twice: y5 = 2 G k V
            y(1, i) = 2.0_wp*y(1, i)
        end do
    end subroutine across_states

    pure subroutine state(self, depth, first, last, y)
        class(gradient_states_t), intent(in) :: self
        type(depth_t), intent(in) :: depth
        integer, intent(in) :: first, last
        real(wp), intent(out) :: y(first:, :)

        y(first:last, :) = self%y(first:last, :, depth%layer)
    end subroutine state

    !> A power series of matrices at k.
    pure function series_at(series, k) result(value)
        real(wp), contiguous, intent(in) :: series(:, :, 0:)
        real(wp), intent(in) :: k
        real(wp) :: value(size(series, 1), size(series, 1))
        integer :: n

        value = series(:, :, order)
        do n = order - 1, 0, -1
            value = series(:, :, n) + k*value
        end do
    end function series_at

end module mdrcontact_inside_gradient_states
