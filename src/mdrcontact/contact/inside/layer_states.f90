! SPDX-License-Identifier: GPL-3.0-or-later
!> The states of layers that are isotropic in their planes, and of compliant interfaces, in Hankel space under a traction on their
!> surface, carried up and down without a positive exponent (theory/stress.md (2.2)-(2.4), (6.2); theory/surfaces.md (1.8), (3.1)).
!>
!> Per unit p_hat the state is (y1, y2, T, S) = (k U, k W, T, S) for displacements U, W and stresses T = sigma_rz, S = sigma_zz;
!> a load normal to the surface has T = 0, S = -1 there. A load along it adds y5 = k V and N. With Q and Z of a layer
!> (mdrcontact_body_elements_transverse), s = k (z - top) and t = k (bottom - z),
!>     v = (y1, S) = e^(-Q s) A + e^(-Q t) B,    w = (y2, T) = Z (e^(-Q t) B - e^(-Q s) A),
!> displacements in units of 1/(2 G) of the body's surface.
module mdrcontact_inside_layer_states
    use mdrcontact_body_elements_interface, only: bond_t, interface_t, new_interface
    use mdrcontact_body_elements_transverse, only: modes_t, new_modes
    use mdrcontact_body_layers, only: layers_t
    use mdrcontact_error, only: check_memory, error_invalid, error_t, raise
    use mdrcontact_inside_isotropic, only: isotropic_half_space_t, new_isotropic_half_space
    use mdrcontact_inside_states, only: depth_t, shear_rows, states_t
    use mdrcontact_inside_transverse, only: new_transverse_half_space, transverse_half_space_t
    use mdrcontact_kinds, only: wp
    use mdrcontact_numerics_small_matrices, only: inverse, times_matrix, times_vector
    implicit none (type, external)
    private
    public :: layer_states_t, new_layer_states

    !> Roots no farther from their mean count as equal: the square of this is rounding.
    real(wp), parameter :: rounding = 3.0e-8_wp

    !> A layer and what lies below it.
    type :: layer_t
        type(modes_t) :: modes
        !> displacements (y1, y2) and tractions (T, S) of the waves that decay downward and upward, where they begin
        real(wp), dimension(2, 2) :: down_u = 0.0_wp, down_t = 0.0_wp, up_u = 0.0_wp, up_t = 0.0_wp
        !> thickness and depth of its top [a]; the first is 0 for the half-space
        real(wp) :: thickness = 0.0_wp, top = 0.0_wp
        type(interface_t) :: below
        !> whether both roots are equal, as those of an isotropic layer
        logical :: has_one_root = .false.
    end type layer_t

    !> States of such a body.
    type, extends(states_t) :: layer_states_t
        private
        type(layer_t), allocatable :: sheets(:)
        logical :: rigid_base = .false., slides = .false.
        real(wp), allocatable :: k(:)
        !> A and B (1:2, 3:4; layer; wavenumber) in the plane of r and z, and of the third direction under a shear load
        real(wp), allocatable :: plane(:, :, :), along(:, :, :)
        !> A of the surface layer less that of a half-space of its material
        real(wp), allocatable :: plane_less(:, :), along_less(:)
    contains
        procedure :: turn
        procedure :: prepare
        procedure :: state
    end type layer_states_t

    !> Products of 2 x 2 matrices and vectors: matmul allocates memory for each.
    interface times
        module procedure times_matrix, times_vector
    end interface times

contains

    !> Create the states of layers under a contact of radius a.
    subroutine new_layer_states(self, layers, radius, error)
        type(layer_states_t), intent(out) :: self
        type(layers_t), intent(in) :: layers
        !> [length]
        real(wp), intent(in) :: radius
        type(error_t), allocatable, intent(inout) :: error
        type(isotropic_half_space_t) :: plain_surface
        type(transverse_half_space_t) :: surface
        type(bond_t) :: bond
        real(wp) :: unit, springs
        integer :: i, n, stat

        if (allocated(layers%materials)) then
            if (any(layers%materials%constants%prestress /= 0.0_wp)) then
                call raise(error, error_invalid, "prestress: subsurface stresses and energies are not available for layers "// &
                    "with a prestress")
                return
            end if
        end if
        n = size(layers%thickness)
        unit = layers%shear(1)
        self%rigid_base = layers%rigid_base
        if (allocated(layers%bonds)) self%slides = any(layers%bonds%slides())
        self%steps = n + 1
        allocate (self%sheets(n + merge(0, 1, layers%rigid_base)), stat=stat)
        call check_memory(error, stat)
        if (stat /= 0) return
        springs = 0.0_wp
        do i = 1, size(self%sheets)
            associate (sheet => self%sheets(i))
                call new_modes(sheet%modes, layers%constants(i, unit))
                sheet%has_one_root = abs(sheet%modes%apart) <= rounding
                call fill_matrices(sheet)
                sheet%top = layers%top(i)/radius
                if (i > n) cycle
                sheet%thickness = layers%thickness(i)/radius
                if (allocated(layers%bonds)) bond = layers%bonds(i)%per_length(radius)
                call new_interface(sheet%below, bond, cmplx(unit, kind=wp))
                springs = max(springs, sheet%below%softness())
            end associate
        end do
        if (n > 0) self%structure = sum(self%sheets%thickness)*layers%contrast() + springs
        if (layers%is_plain()) then
            call new_isotropic_half_space(plain_surface, layers%poisson(1))
            allocate (self%half_space, source=plain_surface)
        else
            call new_transverse_half_space(surface, layers%constants(1, unit))
            allocate (self%half_space, source=surface)
        end if
    end subroutine new_layer_states

    pure subroutine fill_matrices(sheet)
        type(layer_t), intent(inout) :: sheet

        associate (z => sheet%modes%z)
            sheet%down_u(1, 1) = 1.0_wp
            sheet%down_t(2, 2) = 1.0_wp
            sheet%up_u(1, 1) = 1.0_wp
            sheet%up_t(2, 2) = 1.0_wp
            sheet%down_u(2, :) = -z(1, :)
            sheet%down_t(1, :) = -z(2, :)
            sheet%up_u(2, :) = z(1, :)
            sheet%up_t(1, :) = z(2, :)
        end associate
    end subroutine fill_matrices

    !> exp(-Q x); without complex numbers if both roots are equal.
    pure function fall(sheet, x) result(matrix)
        type(layer_t), intent(in) :: sheet
        real(wp), intent(in) :: x
        real(wp) :: matrix(2, 2)

        if (.not. sheet%has_one_root) then
            matrix = real(sheet%modes%fall(cmplx(x, kind=wp)), wp)
            return
        end if
        matrix = -x*sheet%modes%turn
        matrix(1, 1) = matrix(1, 1) + 1.0_wp
        matrix(2, 2) = matrix(2, 2) + 1.0_wp
        matrix = exp(-0.5_wp*sheet%modes%total*x)*matrix
    end function fall

    !> exp(-Q x) times a vector, without the matrix if both roots are equal: most of the time of stresses is spent here.
    pure subroutine carry(sheet, x, vector)
        type(layer_t), intent(in) :: sheet
        real(wp), intent(in) :: x
        real(wp), intent(inout) :: vector(2)
        real(wp) :: fading, first

        if (.not. sheet%has_one_root) then
            vector = times(fall(sheet, x), vector)
            return
        end if
        fading = exp(-0.5_wp*sheet%modes%total*x)
        associate (turn => sheet%modes%turn)
            first = vector(1) - x*(turn(1, 1)*vector(1) + turn(1, 2)*vector(2))
            vector(2) = fading*(vector(2) - x*(turn(2, 1)*vector(1) + turn(2, 2)*vector(2)))
            vector(1) = fading*first
        end associate
    end subroutine carry

    !> Refuses a load along the surface of what slides.
    subroutine turn(self, along_surface, depths, error)
        class(layer_states_t), intent(inout) :: self
        logical, intent(in) :: along_surface
        type(depth_t), intent(inout) :: depths(:)
        type(error_t), allocatable, intent(inout) :: error

        associate (unused => depths)
        end associate
        self%along_surface = along_surface
        if (.not. along_surface .or. .not. self%slides) return
        call raise(error, error_invalid, "friction: it must be 0 on a layer with a sliding interface. Give the interface a "// &
                   "tangential stiffness")
    end subroutine turn

    subroutine prepare(self, k, error)
        class(layer_states_t), intent(inout) :: self
        real(wp), intent(in) :: k(:)
        type(error_t), allocatable, intent(inout) :: error
        real(wp), allocatable, dimension(:, :, :) :: reflection, to_amplitude, down
        integer :: i, n, stat

        n = size(self%sheets)
        if (allocated(self%k)) deallocate (self%k, self%plane, self%plane_less)
        if (allocated(self%along)) deallocate (self%along, self%along_less)
        allocate (self%k(size(k)), self%plane(4, n, size(k)), self%plane_less(2, size(k)), reflection(2, 2, n), &
                  to_amplitude(2, 2, n), down(2, 2, n), stat=stat)
        if (stat == 0 .and. self%along_surface) allocate (self%along(2, n, size(k)), self%along_less(size(k)), stat=stat)
        call check_memory(error, stat)
        if (stat /= 0) return
        self%k(:) = k
        do i = 1, size(k)
            call plane_amplitudes(self, k(i), merge([1.0_wp, 0.0_wp], [0.0_wp, -1.0_wp], self%along_surface), &
                                  reflection, to_amplitude, down, self%plane(:, :, i), self%plane_less(:, i))
            if (self%along_surface) call along_amplitudes(self, k(i), reflection(1, 1, :), down(1, 1, :), self%along(:, :, i), &
                                                          self%along_less(i))
        end do
    end subroutine prepare

    !> Up: the compliance M, (y1, y2) = M (T, S), and R, B = R A. Down: the amplitudes under the traction `load` = (T, S).
    pure subroutine plane_amplitudes(self, k, load, reflection, to_amplitude, down, amplitudes, less)
        class(layer_states_t), intent(in) :: self
        real(wp), intent(in) :: k, load(2)
        !> R of each layer, what makes A of the traction on it, and e^(-Q s) at its bottom
        real(wp), intent(inout), dimension(:, :, :) :: reflection, to_amplitude, down
        real(wp), intent(out) :: amplitudes(:, :), less(2)
        real(wp) :: m(2, 2), faded(2, 2), traction(2)
        integer :: i, n

        n = size(self%sheets)
        m = 0.0_wp
        do i = n, 1, -1
            associate (sheet => self%sheets(i))
                reflection(:, :, i) = 0.0_wp
                if (sheet%thickness > 0.0_wp) then
                    m = real(sheet%below%above(cmplx(k, kind=wp), cmplx(m, kind=wp)), wp)
                    down(:, :, i) = fall(sheet, k*sheet%thickness)
                    reflection(:, :, i) = -times(times(inverse(sheet%up_u - times(m, sheet%up_t)), &
                                                       sheet%down_u - times(m, sheet%down_t)), down(:, :, i))
                    faded = times(down(:, :, i), reflection(:, :, i))
                else
                    faded = 0.0_wp
                end if
                to_amplitude(:, :, i) = inverse(sheet%down_t + times(sheet%up_t, faded))
                m = times(sheet%down_u + times(sheet%up_u, faded), to_amplitude(:, :, i))
            end associate
        end do
        traction = load
        do i = 1, n
            associate (a => amplitudes(1:2, i), b => amplitudes(3:4, i), sheet => self%sheets(i))
                a = times(to_amplitude(:, :, i), traction)
                b = times(reflection(:, :, i), a)
                if (sheet%thickness > 0.0_wp) traction = times(sheet%down_t, times(down(:, :, i), a)) + times(sheet%up_t, b)
            end associate
        end do
        less = 0.0_wp
        associate (sheet => self%sheets(1))
            if (sheet%thickness > 0.0_wp) then
                less = -times(inverse(sheet%down_t), times(sheet%up_t, times(down(:, :, 1), amplitudes(3:4, 1))))
            end if
        end associate
    end subroutine plane_amplitudes

    !> The same for V and N under N = -1.
    pure subroutine along_amplitudes(self, k, reflection, fade, amplitudes, less)
        class(layer_states_t), intent(in) :: self
        real(wp), intent(in) :: k
        !> R of each layer, and what its waves are at its bottom
        real(wp), intent(inout) :: reflection(:), fade(:)
        real(wp), intent(out) :: amplitudes(:, :), less
        real(wp) :: below, traction, stiffness
        integer :: i, n

        n = size(self%sheets)
        below = 0.0_wp
        fade = 0.0_wp
        reflection = 0.0_wp
        do i = n, 1, -1
            associate (sheet => self%sheets(i))
                ! of G
                stiffness = 2.0_wp*sheet%modes%shear
                if (sheet%thickness > 0.0_wp) then
                    below = real(sheet%below%above_across(cmplx(k, kind=wp), cmplx(below, kind=wp)), wp)
                    fade(i) = exp(-sheet%modes%across*k*sheet%thickness)
                    reflection(i) = fade(i)*(stiffness*below - 1.0_wp)/(stiffness*below + 1.0_wp)
                end if
                below = (1.0_wp + fade(i)*reflection(i))/(stiffness*(1.0_wp - fade(i)*reflection(i)))
            end associate
        end do
        traction = -1.0_wp
        do i = 1, n
            amplitudes(1, i) = -traction/(1.0_wp - fade(i)*reflection(i))
            amplitudes(2, i) = reflection(i)*amplitudes(1, i)
            traction = amplitudes(2, i) - fade(i)*amplitudes(1, i)
        end do
        less = fade(1)*amplitudes(2, 1)
    end subroutine along_amplitudes

    pure subroutine state(self, depth, first, last, y)
        class(layer_states_t), intent(in) :: self
        type(depth_t), intent(in) :: depth
        integer, intent(in) :: first, last
        real(wp), intent(out) :: y(first:, :)
        real(wp) :: a(2), b(2), s, t, up, down
        integer :: i
        logical :: is_layer

        associate (sheet => self%sheets(depth%layer), z => self%sheets(depth%layer)%modes%z)
            is_layer = sheet%thickness > 0.0_wp
            do i = first, last
                s = self%k(i)*(depth%z - sheet%top)
                t = self%k(i)*sheet%thickness - s
                a = self%plane(1:2, depth%layer, i)
                if (depth%less) a = self%plane_less(:, i)
                call carry(sheet, s, a)
                b = 0.0_wp
                if (is_layer) then
                    b = self%plane(3:4, depth%layer, i)
                    call carry(sheet, t, b)
                end if
                y(i, 1) = a(1) + b(1)
                y(i, 4) = a(2) + b(2)
                b = b - a
                y(i, 2) = z(1, 1)*b(1) + z(1, 2)*b(2)
                y(i, 3) = z(2, 1)*b(1) + z(2, 2)*b(2)
                if (size(y, 2) < shear_rows) cycle
                down = self%along(1, depth%layer, i)
                if (depth%less) down = self%along_less(i)
                down = exp(-sheet%modes%across*s)*down
                up = 0.0_wp
                if (is_layer) up = exp(-sheet%modes%across*t)*self%along(2, depth%layer, i)
                y(i, 5) = (down + up)/sheet%modes%shear
                y(i, 6) = up - down
            end do
        end associate
    end subroutine state

end module mdrcontact_inside_layer_states
