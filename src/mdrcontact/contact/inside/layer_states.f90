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
    use mdrcontact_inside_waves, only: faded
    use mdrcontact_kinds, only: wp
    use mdrcontact_material_transverse, only: transverse_t
    use mdrcontact_numerics_small_matrices, only: inverse, times_matrix, times_vector
    implicit none (type, external)
    private
    public :: layer_states_t, new_layer_states

    !> Roots no farther from their mean count as equal: the square of this is rounding.
    real(wp), parameter :: rounding = 3.0e-8_wp

    !> Wavenumbers that are worked on together.
    integer, parameter :: block = 64
    !> Waves see layers whose top they reach with exp(-seen*faded): what comes back from deeper ones is less than rounding.
    real(wp), parameter :: seen = 1.5_wp

    !> A layer and what lies below it.
    type :: layer_t
        type(modes_t) :: modes
        !> displacements (y1, y2) and tractions (T, S) of the waves that decay downward and upward, where they begin
        real(wp), dimension(2, 2) :: down_u = 0.0_wp, down_t = 0.0_wp, up_u = 0.0_wp, up_t = 0.0_wp
        !> thickness and depth of its top [a]; the first is 0 for the half-space
        real(wp) :: thickness = 0.0_wp, top = 0.0_wp
        type(interface_t) :: below
        !> exponent at its top, in units of k, of waves that decay from the surface
        real(wp) :: decayed = 0.0_wp
        !> whether both roots are equal, as those of an isotropic layer, and whether its bottom gives
        logical :: has_one_root = .false., gives = .false.
    end type layer_t

    !> Wavenumbers that are carried up and down together, and what a layer does to each.
    type :: sweep_t
        !> the first one, their number, and they themselves; the last one fills the block
        integer :: first = 1, count = 0
        real(wp) :: k(block) = 0.0_wp
        !> the layer that they take for a half-space
        integer :: deepest = 0
        !> (wavenumber, 2, 2, layer): R, what makes A of the traction on the layer, and e^(-Q s) at its bottom
        real(wp), allocatable, dimension(:, :, :, :) :: reflection, to_amplitude, down
        !> (wavenumber, layer) across the plane: e^(-s) at the bottom, and R
        real(wp), allocatable :: fade(:, :), back(:, :)
    end type sweep_t

    !> States of such a body.
    type, extends(states_t) :: layer_states_t
        private
        type(layer_t), allocatable :: sheets(:)
        logical :: rigid_base = .false., slides = .false.
        real(wp), allocatable :: k(:)
        !> A and B (wavenumber; 1:2, 3:4; layer) in the plane of r and z, and of the third direction under a shear load, as deep as
        !> the waves reach
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
        type(transverse_t) :: numbers
        real(wp) :: unit, springs, decayed
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
        decayed = 0.0_wp
        do i = 1, size(self%sheets)
            associate (sheet => self%sheets(i))
                call new_modes(sheet%modes, layers%constants(i, unit))
                sheet%has_one_root = abs(sheet%modes%apart) <= rounding
                call fill_matrices(sheet)
                sheet%top = layers%top(i)/radius
                sheet%decayed = decayed
                if (i > n) cycle
                sheet%thickness = layers%thickness(i)/radius
                numbers = layers%constants(i, unit)
                decayed = decayed + numbers%decay()*sheet%thickness
                if (allocated(layers%bonds)) sheet%gives = .not. layers%bonds(i)%is_bonded()
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

    !> exp(-Q x) times vectors, without the matrix if both roots are equal.
    pure subroutine carry(sheet, x, vectors)
        type(layer_t), intent(in) :: sheet
        real(wp), intent(in) :: x(:)
        !> (x, row)
        real(wp), intent(inout) :: vectors(:, :)
        real(wp) :: fading(size(x)), first
        integer :: i

        if (.not. sheet%has_one_root) then
            do i = 1, size(x)
                vectors(i, :) = times(real(sheet%modes%fall(cmplx(x(i), kind=wp)), wp), vectors(i, :))
            end do
            return
        end if
        fading = exp(-0.5_wp*sheet%modes%total*x)
        associate (turn => sheet%modes%turn)
            do i = 1, size(x)
                first = vectors(i, 1) - x(i)*(turn(1, 1)*vectors(i, 1) + turn(1, 2)*vectors(i, 2))
                vectors(i, 2) = fading(i)*(vectors(i, 2) - x(i)*(turn(2, 1)*vectors(i, 1) + turn(2, 2)*vectors(i, 2)))
                vectors(i, 1) = fading(i)*first
            end do
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
        type(sweep_t) :: sweep
        integer :: first, n, stat

        n = size(self%sheets)
        if (allocated(self%k)) deallocate (self%k, self%plane, self%plane_less)
        if (allocated(self%along)) deallocate (self%along, self%along_less)
        allocate (self%k(size(k)), self%plane(size(k), 4, n), self%plane_less(size(k), 2), sweep%reflection(block, 2, 2, n), &
                  sweep%to_amplitude(block, 2, 2, n), sweep%down(block, 2, 2, n), sweep%fade(block, n), &
                  sweep%back(block, n), stat=stat)
        if (stat == 0 .and. self%along_surface) allocate (self%along(size(k), 2, n), self%along_less(size(k)), stat=stat)
        call check_memory(error, stat)
        if (stat /= 0) return
        self%k(:) = k
        do first = 1, size(k), block
            sweep%first = first
            sweep%count = min(block, size(k) - first + 1)
            sweep%k = k(first)
            sweep%k(:sweep%count) = k(first:first + sweep%count - 1)
            sweep%deepest = deepest(self, k(first))
            call carry_plane_up(self, sweep)
            call carry_plane_down(self, sweep, merge([1.0_wp, 0.0_wp], [0.0_wp, -1.0_wp], self%along_surface))
            if (self%along_surface) call carry_along(self, sweep)
        end do
    end subroutine prepare

    !> The layer that waves of wavenumbers from k on take for a half-space: what lies below it is not seen.
    pure function deepest(self, k) result(layer)
        class(layer_states_t), intent(in) :: self
        real(wp), intent(in) :: k
        integer :: layer

        do layer = 1, size(self%sheets) - 1
            if (k*self%sheets(layer)%decayed > seen*faded) return
        end do
    end function deepest

    !> Whether there is something below a layer of a sweep.
    pure function has_bottom(self, sweep, layer) result(answer)
        class(layer_states_t), intent(in) :: self
        type(sweep_t), intent(in) :: sweep
        integer, intent(in) :: layer
        logical :: answer

        answer = self%sheets(layer)%thickness > 0.0_wp .and. (layer < sweep%deepest .or. layer == size(self%sheets))
    end function has_bottom

    !> The compliance M, (y1, y2) = M (T, S), and R, B = R A.
    pure subroutine carry_plane_up(self, sweep)
        class(layer_states_t), intent(in) :: self
        type(sweep_t), intent(inout) :: sweep
        real(wp), dimension(block, 2, 2) :: m, faded_part, left, right
        integer :: i

        m = 0.0_wp
        do i = sweep%deepest, 1, -1
            associate (sheet => self%sheets(i), reflection => sweep%reflection(:, :, :, i), down => sweep%down(:, :, :, i), &
                       to_amplitude => sweep%to_amplitude(:, :, :, i))
                reflection = 0.0_wp
                faded_part = 0.0_wp
                if (has_bottom(self, sweep, i)) then
                    if (sheet%gives) call pass_interface(sheet, sweep%k, m)
                    call fall_of_all(sheet, sweep%k*sheet%thickness, down)
                    call add_times_constant(sheet%up_u, m, sheet%up_t, -1.0_wp, left)
                    call add_times_constant(sheet%down_u, m, sheet%down_t, -1.0_wp, right)
                    call invert_all(left)
                    call multiply_all(left, right, faded_part)
                    call multiply_all(faded_part, down, reflection)
                    reflection = -reflection
                    call multiply_all(down, reflection, faded_part)
                end if
                call add_constant_times(sheet%down_t, sheet%up_t, faded_part, to_amplitude)
                call invert_all(to_amplitude)
                call add_constant_times(sheet%down_u, sheet%up_u, faded_part, left)
                call multiply_all(left, to_amplitude, m)
            end associate
        end do
    end subroutine carry_plane_up

    !> The amplitudes under the traction `load` = (T, S), where waves reach.
    pure subroutine carry_plane_down(self, sweep, load)
        class(layer_states_t), intent(inout) :: self
        type(sweep_t), intent(in) :: sweep
        real(wp), intent(in) :: load(2)
        real(wp), dimension(block, 2) :: traction, a, b, bottom
        real(wp) :: above(2, 2)
        integer :: i, first, last

        first = sweep%first
        last = first + sweep%count - 1
        traction(:, 1) = load(1)
        traction(:, 2) = load(2)
        self%plane_less(first:last, :) = 0.0_wp
        do i = 1, sweep%deepest
            associate (sheet => self%sheets(i))
                call apply_all(sweep%to_amplitude(:, :, :, i), traction, a)
                call apply_all(sweep%reflection(:, :, :, i), a, b)
                self%plane(first:last, 1:2, i) = a(:sweep%count, :)
                self%plane(first:last, 3:4, i) = b(:sweep%count, :)
                if (.not. has_bottom(self, sweep, i)) exit
                call apply_all(sweep%down(:, :, :, i), a, bottom)
                call apply_constants(sheet%down_t, bottom, sheet%up_t, b, traction)
                if (i > 1) cycle
                call apply_all(sweep%down(:, :, :, i), b, bottom)
                above = -times(inverse(sheet%down_t), sheet%up_t)
                call apply_constants(above, bottom, 0.0_wp*above, b, a)
                self%plane_less(first:last, :) = a(:sweep%count, :)
            end associate
        end do
    end subroutine carry_plane_down

    !> Compliances above the interface below a layer.
    pure subroutine pass_interface(sheet, k, m)
        type(layer_t), intent(in) :: sheet
        real(wp), intent(in) :: k(block)
        real(wp), intent(inout) :: m(block, 2, 2)
        integer :: i

        do i = 1, block
            m(i, :, :) = real(sheet%below%above(cmplx(k(i), kind=wp), cmplx(m(i, :, :), kind=wp)), wp)
        end do
    end subroutine pass_interface

    !> exp(-Q x) of many x.
    pure subroutine fall_of_all(sheet, x, matrix)
        type(layer_t), intent(in) :: sheet
        real(wp), intent(in) :: x(block)
        real(wp), intent(out) :: matrix(block, 2, 2)
        real(wp) :: fading(block)
        integer :: i, j

        if (.not. sheet%has_one_root) then
            do i = 1, block
                matrix(i, :, :) = real(sheet%modes%fall(cmplx(x(i), kind=wp)), wp)
            end do
            return
        end if
        fading = exp(-0.5_wp*sheet%modes%total*x)
        do j = 1, 2
            do i = 1, 2
                matrix(:, i, j) = fading*(merge(1.0_wp, 0.0_wp, i == j) - x*sheet%modes%turn(i, j))
            end do
        end do
    end subroutine fall_of_all

    !> c = a b, for many matrices.
    pure subroutine multiply_all(a, b, c)
        real(wp), intent(in), dimension(block, 2, 2) :: a, b
        real(wp), intent(out) :: c(block, 2, 2)
        integer :: i, j

        do j = 1, 2
            do i = 1, 2
                c(:, i, j) = a(:, i, 1)*b(:, 1, j) + a(:, i, 2)*b(:, 2, j)
            end do
        end do
    end subroutine multiply_all

    !> c = b + factor a m for constant b and m.
    pure subroutine add_times_constant(b, a, m, factor, c)
        real(wp), intent(in) :: b(2, 2), a(block, 2, 2), m(2, 2), factor
        real(wp), intent(out) :: c(block, 2, 2)
        integer :: i, j

        do j = 1, 2
            do i = 1, 2
                c(:, i, j) = b(i, j) + factor*(a(:, i, 1)*m(1, j) + a(:, i, 2)*m(2, j))
            end do
        end do
    end subroutine add_times_constant

    !> c = b + m a for constant b and m.
    pure subroutine add_constant_times(b, m, a, c)
        real(wp), intent(in) :: b(2, 2), m(2, 2), a(block, 2, 2)
        real(wp), intent(out) :: c(block, 2, 2)
        integer :: i, j

        do j = 1, 2
            do i = 1, 2
                c(:, i, j) = b(i, j) + (m(i, 1)*a(:, 1, j) + m(i, 2)*a(:, 2, j))
            end do
        end do
    end subroutine add_constant_times

    !> To the inverses of many matrices.
    pure subroutine invert_all(m)
        real(wp), intent(inout) :: m(block, 2, 2)
        real(wp), dimension(block) :: determinant, first

        determinant = m(:, 1, 1)*m(:, 2, 2) - m(:, 1, 2)*m(:, 2, 1)
        first = m(:, 1, 1)
        m(:, 1, 1) = m(:, 2, 2)/determinant
        m(:, 2, 1) = -m(:, 2, 1)/determinant
        m(:, 1, 2) = -m(:, 1, 2)/determinant
        m(:, 2, 2) = first/determinant
    end subroutine invert_all

    !> y = m x, for many matrices and vectors.
    pure subroutine apply_all(m, x, y)
        real(wp), intent(in) :: m(block, 2, 2), x(block, 2)
        real(wp), intent(out) :: y(block, 2)
        integer :: i

        do i = 1, 2
            y(:, i) = m(:, i, 1)*x(:, 1) + m(:, i, 2)*x(:, 2)
        end do
    end subroutine apply_all

    !> z = a x + b y for constant a and b.
    pure subroutine apply_constants(a, x, b, y, z)
        real(wp), intent(in) :: a(2, 2), x(block, 2), b(2, 2), y(block, 2)
        real(wp), intent(out) :: z(block, 2)
        integer :: i

        do i = 1, 2
            z(:, i) = (a(i, 1)*x(:, 1) + a(i, 2)*x(:, 2)) + (b(i, 1)*y(:, 1) + b(i, 2)*y(:, 2))
        end do
    end subroutine apply_constants

    !> The same for V and N under N = -1: R of each layer, what its waves are at its bottom, and the amplitudes.
    pure subroutine carry_along(self, sweep)
        class(layer_states_t), intent(inout) :: self
        type(sweep_t), intent(inout) :: sweep
        real(wp), dimension(block) :: below, traction, down
        real(wp) :: stiffness
        integer :: i, j, first, last

        below = 0.0_wp
        do i = sweep%deepest, 1, -1
            associate (sheet => self%sheets(i), fade => sweep%fade(:, i), reflection => sweep%back(:, i))
                fade = 0.0_wp
                reflection = 0.0_wp
                ! of G
                stiffness = 2.0_wp*sheet%modes%shear
                if (has_bottom(self, sweep, i)) then
                    do j = 1, block
                        if (.not. sheet%gives) exit
                        below(j) = real(sheet%below%above_across(cmplx(sweep%k(j), kind=wp), cmplx(below(j), kind=wp)), wp)
                    end do
                    fade = exp(-sheet%modes%across*sweep%k*sheet%thickness)
                    reflection = fade*(stiffness*below - 1.0_wp)/(stiffness*below + 1.0_wp)
                end if
                below = (1.0_wp + fade*reflection)/(stiffness*(1.0_wp - fade*reflection))
            end associate
        end do
        first = sweep%first
        last = first + sweep%count - 1
        traction = -1.0_wp
        do i = 1, sweep%deepest
            associate (fade => sweep%fade(:, i), reflection => sweep%back(:, i))
                down = -traction/(1.0_wp - fade*reflection)
                self%along(first:last, 1, i) = down(:sweep%count)
                down = reflection*down
                self%along(first:last, 2, i) = down(:sweep%count)
                if (i == 1) self%along_less(first:last) = fade(:sweep%count)*down(:sweep%count)
                down = -traction/(1.0_wp - fade*reflection)
                traction = reflection*down - fade*down
            end associate
        end do
    end subroutine carry_along

    pure subroutine state(self, depth, first, last, y)
        class(layer_states_t), intent(in) :: self
        type(depth_t), intent(in) :: depth
        integer, intent(in) :: first, last
        real(wp), intent(out) :: y(first:, :)
        real(wp), dimension(last - first + 1, 2) :: a, b
        real(wp), dimension(last - first + 1) :: s, t

        associate (sheet => self%sheets(depth%layer), z => self%sheets(depth%layer)%modes%z)
            s = self%k(first:last)*(depth%z - sheet%top)
            t = self%k(first:last)*sheet%thickness - s
            if (depth%less) then
                a = self%plane_less(first:last, :)
            else
                a = self%plane(first:last, 1:2, depth%layer)
            end if
            call carry(sheet, s, a)
            b = 0.0_wp
            if (sheet%thickness > 0.0_wp) then
                b = self%plane(first:last, 3:4, depth%layer)
                call carry(sheet, t, b)
            end if
            y(:, 1) = a(:, 1) + b(:, 1)
            y(:, 4) = a(:, 2) + b(:, 2)
            b = b - a
            y(:, 2) = z(1, 1)*b(:, 1) + z(1, 2)*b(:, 2)
            y(:, 3) = z(2, 1)*b(:, 1) + z(2, 2)*b(:, 2)
            if (size(y, 2) < shear_rows) return
            if (depth%less) then
                s = exp(-sheet%modes%across*s)*self%along_less(first:last)
            else
                s = exp(-sheet%modes%across*s)*self%along(first:last, 1, depth%layer)
            end if
            if (sheet%thickness > 0.0_wp) then
                t = exp(-sheet%modes%across*t)*self%along(first:last, 2, depth%layer)
            else
                t = 0.0_wp
            end if
            y(:, 5) = (s + t)/sheet%modes%shear
            y(:, 6) = t - s
        end associate
    end subroutine state

end module mdrcontact_inside_layer_states
