! SPDX-License-Identifier: GPL-3.0-or-later
!> The state of bonded layers in Hankel space under a traction on their surface, carried up and down without a positive exponent.
!>
!> Per unit p_hat and with the layer's shear modulus mu the state is y = (2 mu k U, 2 mu k W, T, S) for displacements U, W and
!> stresses T = sigma_rz, S = sigma_zz in Hankel space; a load normal to the surface has T = 0, S = -1 there. A load along it adds
!> y5 = 2 mu k V and N. In every layer y = D(s) A + G(t) B, s = k (z - top), t = k (z - bottom) <= 0, with the columns
!>     D: e^-s (1, 1, -1, -1) and e^-s (s, s + 3 - 4 nu, -(1 - 2 nu + s), -(2 (1 - nu) + s))
!>     G: e^t (1, -1, 1, -1)  and e^t (t, 3 - 4 nu - t, t - (1 - 2 nu), 2 (1 - nu) - t)
!> Nothing is divided by 1 - 2 nu: nu = 1/2 is allowed.
module mdrcontact_field_sweep
    use mdrcontact_body_layers, only: layers_t
    use mdrcontact_error, only: check_memory, error_t
    use mdrcontact_field_states, only: normal_rows, shear_rows
    use mdrcontact_kinds, only: wp
    use mdrcontact_numerics_small_matrices, only: inverse, times_matrix, times_vector
    implicit none (type, external)
    private
    public :: sweep_t, new_sweep, layer_state, normal_rows, shear_rows

    !> Amplitudes A and B of all layers at given wavenumbers. Made by new_sweep.
    type :: sweep_t
        real(wp), allocatable :: k(:)
        !> (1:2 of A, 3:4 of B; layer; wavenumber) in the plane of r and z, and (A, B) of the third direction under a shear load
        real(wp), allocatable :: plane(:, :, :), along(:, :, :)
        !> A of the surface layer less that of a half-space of its material
        real(wp), allocatable :: plane_less(:, :), along_less(:)
    end type sweep_t

    !> Products of 2 x 2 matrices and vectors: matmul allocates memory for each.
    interface times
        module procedure times_matrix, times_vector
    end interface times

contains

    !> Amplitudes at wavenumbers k > 0 under a normal load, or under a load along the surface.
    pure subroutine new_sweep(self, layers, k, along_surface, error)
        type(sweep_t), intent(out) :: self
        type(layers_t), intent(in) :: layers
        real(wp), intent(in) :: k(:)
        logical, intent(in) :: along_surface
        type(error_t), allocatable, intent(inout) :: error
        real(wp), allocatable :: reflection(:, :, :), to_amplitude(:, :, :)
        integer :: i, n, stat

        n = size(layers%thickness)
        allocate (self%k(size(k)), self%plane(4, n + 1, size(k)), self%plane_less(2, size(k)), reflection(2, 2, n), &
                  to_amplitude(2, 2, n), stat=stat)
        if (stat == 0 .and. along_surface) allocate (self%along(2, n + 1, size(k)), self%along_less(size(k)), stat=stat)
        call check_memory(error, stat)
        if (stat /= 0) return
        self%k(:) = k
        do i = 1, size(k)
            call plane_amplitudes(layers, k(i), merge([1.0_wp, 0.0_wp], [0.0_wp, -1.0_wp], along_surface), &
                                  reflection, to_amplitude, self%plane(:, :, i), self%plane_less(:, i))
        end do
        if (.not. along_surface) return
        do i = 1, size(k)
            call along_amplitudes(layers, k(i), reflection(1, 1, :), self%along(:, :, i), self%along_less(i))
        end do
    end subroutine new_sweep

    !> Up: the compliance M, k (U, W) = M (T, S), and R, B = R A. Down: the amplitudes under the traction `load` = (T, S).
    pure subroutine plane_amplitudes(layers, k, load, reflection, to_amplitude, amplitudes, less)
        type(layers_t), intent(in) :: layers
        real(wp), intent(in) :: k, load(2)
        !> R of each layer, and what makes A of the traction on it
        real(wp), intent(out) :: reflection(:, :, :), to_amplitude(:, :, :)
        real(wp), intent(out) :: amplitudes(:, :), less(2)
        real(wp), dimension(2, 2) :: compliance, m
        real(wp) :: traction(2), t
        integer :: i, n

        n = size(layers%thickness)
        compliance = 0.0_wp
        if (.not. layers%rigid_base) then
            associate (mu => layers%shear(n + 1), nu => layers%poisson(n + 1))
                compliance = times(displaced_down(0.0_wp, nu), inverse(traction_down(0.0_wp, nu)))/(2.0_wp*mu)
            end associate
        end if
        do i = n, 1, -1
            associate (mu => layers%shear(i), nu => layers%poisson(i))
                t = k*layers%thickness(i)
                ! in units of 1/(2 mu)
                m = 2.0_wp*mu*compliance
                reflection(:, :, i) = -exp(-t)*times(inverse(displaced_up(0.0_wp, nu) - times(m, traction_up(0.0_wp, nu))), &
                                                      displaced_down(t, nu) - times(m, traction_down(t, nu)))
                m = exp(-t)*reflection(:, :, i)
                to_amplitude(:, :, i) = inverse(traction_down(0.0_wp, nu) + times(traction_up(-t, nu), m))
                compliance = times(displaced_down(0.0_wp, nu) + times(displaced_up(-t, nu), m), to_amplitude(:, :, i)) &
                             /(2.0_wp*mu)
            end associate
        end do
        traction = load
        do i = 1, n
            associate (a => amplitudes(1:2, i), b => amplitudes(3:4, i), nu => layers%poisson(i))
                t = k*layers%thickness(i)
                a = times(to_amplitude(:, :, i), traction)
                b = times(reflection(:, :, i), a)
                traction = exp(-t)*times(traction_down(t, nu), a) + times(traction_up(0.0_wp, nu), b)
            end associate
        end do
        amplitudes(:, n + 1) = 0.0_wp
        if (.not. layers%rigid_base) then
            amplitudes(1:2, n + 1) = times(inverse(traction_down(0.0_wp, layers%poisson(n + 1))), traction)
        end if
        less = 0.0_wp
        if (n == 0) return
        t = k*layers%thickness(1)
        less = -exp(-t)*times(inverse(traction_down(0.0_wp, layers%poisson(1))), &
                               times(traction_up(-t, layers%poisson(1)), amplitudes(3:4, 1)))
    end subroutine plane_amplitudes

    !> The same for V and N, k V = M N, under N = -1.
    pure subroutine along_amplitudes(layers, k, reflection, amplitudes, less)
        type(layers_t), intent(in) :: layers
        real(wp), intent(in) :: k
        !> R of each layer
        real(wp), intent(out) :: reflection(:)
        real(wp), intent(out) :: amplitudes(:, :), less
        real(wp) :: compliance, fade, traction
        integer :: i, n

        n = size(layers%thickness)
        compliance = 0.0_wp
        if (.not. layers%rigid_base) compliance = -1.0_wp/layers%shear(n + 1)
        do i = n, 1, -1
            associate (mu => layers%shear(i))
                fade = exp(-k*layers%thickness(i))
                reflection(i) = -fade*(1.0_wp/mu + compliance)/(1.0_wp/mu - compliance)
                compliance = (1.0_wp + fade*reflection(i))/(mu*(-1.0_wp + fade*reflection(i)))
            end associate
        end do
        traction = -1.0_wp
        do i = 1, n
            fade = exp(-k*layers%thickness(i))
            amplitudes(1, i) = traction/(-1.0_wp + fade*reflection(i))
            amplitudes(2, i) = reflection(i)*amplitudes(1, i)
            traction = -fade*amplitudes(1, i) + amplitudes(2, i)
        end do
        amplitudes(:, n + 1) = [-traction, 0.0_wp]
        if (layers%rigid_base) amplitudes(1, n + 1) = 0.0_wp
        less = 0.0_wp
        if (n > 0) less = exp(-k*layers%thickness(1))*amplitudes(2, 1)
    end subroutine along_amplitudes

    !> y(k, z) in a layer: rows y1 to y4 and, under a load along the surface, y5 and N. With `less` what is left of the surface
    !> layer's state when that of a half-space of its material is taken away.
    pure subroutine layer_state(self, layers, layer, above, z, less, first, last, y)
        type(sweep_t), intent(in) :: self
        type(layers_t), intent(in) :: layers
        integer, intent(in) :: layer
        !> depths of the layer's upper face and of the point [length]
        real(wp), intent(in) :: above, z
        logical, intent(in) :: less
        !> wavenumbers wanted
        integer, intent(in) :: first, last
        !> (wavenumber, row)
        real(wp), intent(out) :: y(first:, :)
        real(wp) :: s, t, down(2), up(2), fade_down, fade_up, nu
        integer :: i
        logical :: deepest

        nu = layers%poisson(layer)
        deepest = layer > size(layers%thickness)
        t = 0.0_wp
        fade_up = 0.0_wp
        do i = first, last
            s = self%k(i)*(z - above)
            fade_down = exp(-s)
            if (.not. deepest) then
                t = self%k(i)*((z - above) - layers%thickness(layer))
                fade_up = exp(t)
            end if
            down = fade_down*self%plane(1:2, layer, i)
            if (less) down = fade_down*self%plane_less(:, i)
            up = fade_up*self%plane(3:4, layer, i)
            y(i, 1) = down(1) + s*down(2) + up(1) + t*up(2)
            y(i, 2) = down(1) + (s + 3.0_wp - 4.0_wp*nu)*down(2) - up(1) + (3.0_wp - 4.0_wp*nu - t)*up(2)
            y(i, 3) = -down(1) - (1.0_wp - 2.0_wp*nu + s)*down(2) + up(1) + (t - (1.0_wp - 2.0_wp*nu))*up(2)
            y(i, 4) = -down(1) - (2.0_wp*(1.0_wp - nu) + s)*down(2) - up(1) + (2.0_wp*(1.0_wp - nu) - t)*up(2)
        end do
        if (size(y, 2) < shear_rows) return
        do i = first, last
            fade_down = exp(-self%k(i)*(z - above))
            if (.not. deepest) fade_up = exp(self%k(i)*((z - above) - layers%thickness(layer)))
            down(1) = fade_down*self%along(1, layer, i)
            if (less) down(1) = fade_down*self%along_less(i)
            up(1) = fade_up*self%along(2, layer, i)
            y(i, 5) = 2.0_wp*(down(1) + up(1))
            y(i, 6) = up(1) - down(1)
        end do
    end subroutine layer_state

    !> Displacements, times 2 mu, of the modes that fade downward, without e^-s.
    pure function displaced_down(s, nu) result(m)
        real(wp), intent(in) :: s, nu
        real(wp) :: m(2, 2)

        m(:, 1) = [1.0_wp, 1.0_wp]
        m(:, 2) = [s, s + 3.0_wp - 4.0_wp*nu]
    end function displaced_down

    !> Their tractions.
    pure function traction_down(s, nu) result(m)
        real(wp), intent(in) :: s, nu
        real(wp) :: m(2, 2)

        m(:, 1) = [-1.0_wp, -1.0_wp]
        m(:, 2) = [-(1.0_wp - 2.0_wp*nu + s), -(2.0_wp*(1.0_wp - nu) + s)]
    end function traction_down

    !> Displacements, times 2 mu, of the modes that fade upward, without e^t.
    pure function displaced_up(t, nu) result(m)
        real(wp), intent(in) :: t, nu
        real(wp) :: m(2, 2)

        m(:, 1) = [1.0_wp, -1.0_wp]
        m(:, 2) = [t, 3.0_wp - 4.0_wp*nu - t]
    end function displaced_up

    !> Their tractions.
    pure function traction_up(t, nu) result(m)
        real(wp), intent(in) :: t, nu
        real(wp) :: m(2, 2)

        m(:, 1) = [1.0_wp, -1.0_wp]
        m(:, 2) = [t - (1.0_wp - 2.0_wp*nu), 2.0_wp*(1.0_wp - nu) - t]
    end function traction_up

end module mdrcontact_field_sweep
