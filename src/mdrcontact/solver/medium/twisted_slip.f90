! SPDX-License-Identifier: GPL-3.0-or-later
!> First twist of a contact of homogeneous half-spaces about its axis (theory/friction.md (5.1)-(5.6)): the twist phi represents the
!> shift, the torque for the tangential force, the torsional stiffness (16/3) G c^3 for k_t.
!>
!> The load of a spring is q(x) = 2 x int_x^a tau dr/sqrt(r^2 - x^2): 4 G phi x where it sticks, mu B(x) where tau = mu p. Each
!> increment of depth adds a flat punch's pressure, so that with K and B = [E - kappa^2 K]/(1 - kappa^2) of the complementary
!> modulus kappa = c/b and q_n the normal line load (mu = 1)
!>     phi(c) = (1/(2 pi G)) [int_c^a (-q_n'(b)) K db/b + q_n(a) K(c/a)/a],
!>     -dphi/dc = (1/(2 pi G c)) [(pi/2) (-q_n'(c)) + int_c^a (-q_n'(b)) B db/b + q_n(a) B(c/a)/a].
!> Under a paraboloid phi = (3 F/(4 pi G a^2)) [K - E] of the modulus sqrt(1 - c^2/a^2) (Lubkin, J. Appl. Mech. 18 (1951) 183).
!> The axis sticks at any twist: phi grows as ln(1/c).
module mdrcontact_medium_twisted_slip
    use mdrcontact_error, only: count_text, error_invalid, error_t, raise
    use mdrcontact_medium_slip, only: slip_t, thin
    use mdrcontact_kinds, only: half_pi, pi, wp
    use mdrcontact_medium_load, only: load_t
    use mdrcontact_medium_solver, only: copy, refuse, solver_t
    use mdrcontact_medium_shear_moduli, only: moduli_under_shear
    use mdrcontact_numerics_elliptic, only: complete_b, complete_k
    use mdrcontact_numerics_quadrature, only: gauss_legendre, graded_rule, mark_breaks, merge_breaks
    use mdrcontact_profile, only: copy, profile_t
    implicit none (type, external)
    private
    public :: twisted_slip_t, new_twisted_slip

    !> A stick zone of this part of the radius carries 1e-18 of the torque: the contact slides.
    real(wp), parameter :: smallest = 1.0e-6_wp
    !> Panels of stick radii grow by the first factor, or by the second where the torque does not see them, below this part of a.
    real(wp), parameter :: growth = 1.6_wp, far_growth = 8.0_wp, far = 0.003_wp
    !> And as fast as the distance from a radius where the profile is not analytic, but for this part of a.
    real(wp), parameter :: shortest = 1.0e-8_wp
    !> The work grows with the square of the number of pieces of the profile.
    integer, parameter :: most_pieces = 64
    !> Nodes in a panel for tractions.
    integer, parameter :: nodes = 12
    !> Positions whose turns are computed at a time: room for them is fixed.
    integer, parameter :: together = 256

    !> One normal state.
    type, extends(slip_t) :: twisted_slip_t
        private
        class(solver_t), allocatable :: normal
        class(profile_t), allocatable :: profile
        real(wp), allocatable :: breaks(:)
        !> E* and G [modulus], q_n(a) [modulus length], depth beyond the non-adhesive one [length]
        real(wp) :: modulus = 0.0_wp, shear = 0.0_wp, edge = 0.0_wp, punch_depth = 0.0_wp
    contains
        procedure :: rates
        procedure :: panels
        procedure :: at
        procedure :: line_load
        procedure :: traction
    end type twisted_slip_t

contains

    !> The state of contact radius a under a profile. `force` becomes the torque of sliding over mu.
    subroutine new_twisted_slip(self, normal, profile, a, punch_depth, error)
        type(twisted_slip_t), intent(out) :: self
        !> of homogeneous bodies
        class(solver_t), intent(in) :: normal
        class(profile_t), intent(in) :: profile
        !> [length]
        real(wp), intent(in) :: a, punch_depth
        type(error_t), allocatable, intent(out) :: error
        real(wp), allocatable :: b(:), weights(:), breaks(:)
        real(wp), dimension(1) :: modulus, twist, rate, stiffness, slope
        real(wp) :: shear(2)

        if (.not. normal%has_free_springs) then
            call refuse(normal, "torsion with friction is", "a homogeneous one with E and nu, or a pair of them", &
                        "the theory does not include a twist", error)
            return
        end if
        call moduli_under_shear(normal, shear, error)
        if (.not. allocated(error)) call normal%modulus([a], modulus, error)
        if (.not. allocated(error)) call copy(normal, self%normal, error)
        if (.not. allocated(error)) call copy(profile, self%profile, error)
        call profile%add_breaks(breaks, error)
        call merge_breaks(self%breaks, breaks(:count(breaks < a)), error)
        if (allocated(error)) return
        if (size(self%breaks) > most_pieces) then
            call raise(error, error_invalid, "indenter: torsion with friction is available for up to "//count_text(most_pieces)// &
                       " pieces below the contact radius, and this indenter has "//count_text(size(self%breaks))// &
                       ". Use fewer points, or a shape with a formula")
            return
        end if
        self%radius = a
        self%punch_depth = punch_depth
        self%modulus = modulus(1)
        self%shear = shear(1)
        self%edge = self%modulus*punch_depth
        self%stiffness = 16.0_wp/3.0_wp*self%shear*a**3
        self%first_shift = self%edge/(4.0_wp*self%shear*a)
        self%smallest_stick = smallest*a
        call self%rates([self%smallest_stick], twist, rate, stiffness, slope, error)
        if (.not. allocated(error)) then
            call graded_rule(self%smallest_stick, a, self%breaks, profile%singular_radius, b, weights, error)
        end if
        if (allocated(error)) return
        self%sliding_shift = twist(1)
        ! int r tau dA of a flat punch's pressure of unit depth: (pi/2) E* b^2
        self%force = half_pi*(self%modulus*sum(weights*profile%mdr_slope(b)*b**2) + self%edge*a**2)
    end subroutine new_twisted_slip

    subroutine rates(self, c, shift, shift_rate, stiffness, stiffness_slope, error)
        class(twisted_slip_t), intent(in) :: self
        real(wp), intent(in) :: c(:)
        real(wp), intent(out) :: shift(:), shift_rate(:), stiffness(:), stiffness_slope(:)
        type(error_t), allocatable, intent(out) :: error
        real(wp), allocatable :: b(:), load(:)
        real(wp) :: ratio
        integer :: i, j

        stiffness = 16.0_wp/3.0_wp*self%shear*c**3
        stiffness_slope = 16.0_wp*self%shear*c**2
        do i = 1, size(c)
            call graded_rule(c(i), self%radius, self%breaks, self%profile%singular_radius, b, load, error)
            if (allocated(error)) return
            do j = 1, size(b)
                load(j) = self%modulus*load(j)*self%profile%mdr_slope(b(j))/b(j)
            end do
            ratio = c(i)/self%radius
            shift(i) = sum(load*complete_k(c(i)/b)) + self%edge/self%radius*complete_k(ratio)
            shift_rate(i) = half_pi*self%modulus*self%profile%mdr_slope(c(i)) + sum(load*complete_b(c(i)/b)) + &
                            self%edge/self%radius*complete_b(ratio)
        end do
        shift = shift/(2.0_wp*pi*self%shear)
        shift_rate = shift_rate/(2.0_wp*pi*self%shear*c)
    end subroutine rates

    subroutine panels(self, c, edges, has_root, error)
        class(twisted_slip_t), intent(in) :: self
        real(wp), intent(in) :: c
        real(wp), allocatable, intent(out) :: edges(:)
        logical, allocatable, intent(out) :: has_root(:)
        type(error_t), allocatable, intent(inout) :: error
        real(wp) :: here, next, length
        integer :: i

        edges = [c]
        here = c
        do while (here < self%radius)
            next = here*merge(growth, far_growth, here > far*self%radius)
            ! a root of b - break behind: panels proportionally to the distance from it
            length = minval(here - self%breaks, mask=self%breaks < here)
            next = min(next, here + max(length, shortest*self%radius))
            if (self%radius - next < 0.5_wp*(next - here)) next = self%radius
            do i = 1, size(self%breaks)
                if (self%breaks(i) > here) next = min(next, self%breaks(i))
            end do
            edges = [edges, next]
            here = next
        end do
        call mark_breaks(edges, self%breaks, has_root, error)
    end subroutine panels

    subroutine at(self, c, width, shift, force, stiffness, shift_rate, error)
        class(twisted_slip_t), intent(in) :: self
        real(wp), intent(in) :: c, width
        real(wp), intent(out) :: shift, force, stiffness, shift_rate
        type(error_t), allocatable, intent(out) :: error
        real(wp) :: dissipated, known(1), rate(1), k(1), slope(1)

        call self%rates([c], known, rate, k, slope, error)
        if (.not. allocated(error)) call self%integrate(c, width, shift, force, dissipated, error)
        if (allocated(error)) return
        if (width > thin*self%radius) shift = known(1)
        stiffness = k(1)
        shift_rate = rate(1)
    end subroutine at

    !> 4 G x phi(max(x, c)).
    subroutine line_load(self, c, r, values, error)
        class(twisted_slip_t), intent(in), target :: self
        real(wp), intent(in) :: c
        real(wp), intent(in) :: r(:)
        real(wp), intent(out) :: values(:)
        type(error_t), allocatable, intent(out) :: error
        real(wp), dimension(together) :: rate, stiffness, slope
        integer :: first, last, n

        do first = 1, size(r), together
            last = min(first + together - 1, size(r))
            n = last - first + 1
            call self%rates(max(r(first:last), c, self%smallest_stick), values(first:last), rate(:n), stiffness(:n), slope(:n), &
                            error)
            if (allocated(error)) return
        end do
        values = 4.0_wp*self%shear*r*values
    end subroutine line_load

    !> p where it slips; in the stick zone the sum of (4 G r/pi) dphi/sqrt(b^2 - r^2) over the stick radii b of its past.
    subroutine traction(self, c, r, values, error)
        class(twisted_slip_t), intent(in), target :: self
        real(wp), intent(in) :: c
        real(wp), intent(in) :: r(:)
        real(wp), intent(out) :: values(:)
        type(error_t), allocatable, intent(out) :: error
        class(load_t), allocatable :: pressed
        real(wp), allocatable :: edges(:), b(:), w(:), rate(:), shift(:), stiffness(:), slope(:)
        logical, allocatable :: has_root(:)
        real(wp) :: t(nodes), weights(nodes), start, length
        integer :: i, j, n

        call gauss_legendre(t, weights, error)
        if (allocated(error)) return
        call self%normal%load(self%profile, self%radius, self%punch_depth, pressed, error)
        if (.not. allocated(error)) call pressed%pressure(r, values, error)
        if (.not. allocated(error)) call self%panels(max(c, self%smallest_stick), edges, has_root, error)
        if (allocated(error)) return
        n = nodes*(size(edges) - 1)
        allocate (b(n), w(n), shift(n), rate(n), stiffness(n), slope(n))
        do i = 1, size(r)
            if (r(i) >= edges(1)) cycle
            ! in y = sqrt(b^2 - r^2): db/sqrt(b^2 - r^2) = dy/b
            do j = 1, size(edges) - 1
                start = sqrt((edges(j) - r(i))*(edges(j) + r(i)))
                length = sqrt((edges(j + 1) - r(i))*(edges(j + 1) + r(i))) - start
                n = nodes*(j - 1)
                if (has_root(j)) then
                    b(n + 1:n + nodes) = hypot(r(i), start + length*t**2)
                    w(n + 1:n + nodes) = 2.0_wp*length*t*weights
                else
                    b(n + 1:n + nodes) = hypot(r(i), start + length*t)
                    w(n + 1:n + nodes) = length*weights
                end if
            end do
            call self%rates(b, shift, rate, stiffness, slope, error)
            if (allocated(error)) return
            values(i) = 4.0_wp*self%shear*r(i)/pi*(sum(w*rate/b) + self%first_shift &
                                                     /sqrt((self%radius - r(i))*(self%radius + r(i))))
        end do
    end subroutine traction

end module mdrcontact_medium_twisted_slip
