! SPDX-License-Identifier: GPL-3.0-or-later
!> Line load, pressure and displacement of a contact on a surface with tension or a plate, from the coefficients of its load
!> (theory/surfaces.md (6.4), (6.11), (6.12)), q dx = psi d theta, psi = E0* sum c_j cos 2 j theta, x = a cos theta.
module mdrcontact_tension_fields
    use mdrcontact_body_compliance, only: compliance_t
    use mdrcontact_error, only: error_t
    use mdrcontact_kinds, only: half_pi, pi, wp
    use mdrcontact_numerics_chebyshev, only: chebyshev_sum, chebyshev_sums
    use mdrcontact_numerics_quadrature, only: gauss_legendre, legendre
    use mdrcontact_tension_body_part, only: body_waves, wave_basis
    use mdrcontact_tension_green, only: green_t, of_couple, of_load
    implicit none (type, external)
    private
    public :: tension_load_t, new_tension_load

    !> Nodes of a panel, growth of panels from the edge, and the shortest of them relative to the distance from the edge.
    integer, parameter :: nodes = 20
    real(wp), parameter :: growth = 3.0_wp, shortest = 1.0e-12_wp

    !> The load of one state. Made by new_tension_load.
    type :: tension_load_t
        private
        real(wp) :: radius = 0.0_wp
        !> of the ring couple, 0 without a plate, and of the line force on the edge, 2 a f/E0* [length^2]
        real(wp) :: couple = 0.0_wp
        real(wp), public :: line_force = 0.0_wp
        !> what the series leaves of a line force if it does not exist: its error, without which force and displacement lose digits
        real(wp) :: remainder = 0.0_wp
        !> of the cosines [length^2]
        real(wp), allocatable :: cosines(:)
    contains
        procedure :: line_load
        procedure :: pressure
        procedure :: spring_depth
        procedure :: displacement
    end type tension_load_t

contains

    !> The load with these coefficients.
    pure subroutine new_tension_load(self, radius, coefficients, couple, has_line_force)
        type(tension_load_t), intent(out) :: self
        real(wp), intent(in) :: radius, coefficients(:)
        !> 1 where the first coefficient is that of the ring couple, else 0
        integer, intent(in) :: couple
        !> whether the edge carries a line force
        logical, intent(in) :: has_line_force

        self%radius = radius
        if (couple == 1) self%couple = coefficients(1)
        self%cosines = coefficients(couple + 1:)
        if (has_line_force) then
            self%line_force = sum(self%cosines)
        else
            self%remainder = sum(self%cosines)
        end if
    end subroutine new_tension_load

    !> q(x)/E0* [length], 0 <= x < a.
    elemental function line_load(self, x) result(q)
        class(tension_load_t), intent(in) :: self
        real(wp), intent(in) :: x
        real(wp) :: q
        real(wp) :: root

        root = sqrt((self%radius - x)*(self%radius + x))
        ! cos 2 theta
        q = (chebyshev_sum(self%cosines, 2.0_wp*(x/self%radius)**2 - 1.0_wp) - self%remainder)/root &
            + self%couple*self%radius**2/root**3
    end function line_load

    !> p(r)/E0* [1], 0 <= r <= a, without what line force and couple put on the edge itself.
    pure function pressure(self, r) result(p)
        class(tension_load_t), intent(in) :: self
        real(wp), intent(in) :: r(:)
        real(wp) :: p(size(r))
        real(wp) :: waves(size(r), 0:size(self%cosines) - 1), total
        integer :: j

        waves = legendre(size(self%cosines), 2.0_wp*(r/self%radius)**2 - 1.0_wp)
        p = 0.0_wp
        total = -(self%line_force + self%remainder)
        do j = 0, size(self%cosines) - 1
            total = total + self%cosines(j + 1)
            p = p + total*real(2*j + 1, wp)*waves(:, j)
        end do
        p = p/self%radius**2
    end function pressure

    !> w(x) = (1/pi) int q/E0* Phi(x - s) ds, x > a: what the line of springs does outside the contact [length].
    subroutine spring_depth(self, green, compliance, x, w, error)
        class(tension_load_t), intent(in) :: self
        type(green_t), intent(in) :: green
        class(compliance_t), intent(in) :: compliance
        !> ascending [length]
        real(wp), intent(in) :: x(:)
        real(wp), intent(out) :: w(:)
        type(error_t), allocatable, intent(inout) :: error
        integer :: i

        do i = 1, size(x)
            call half_space_depth(self, green, x(i), w(i), error)
            if (allocated(error)) return
        end do
        if (compliance%first_depth > 0.0_wp) call add_body_depth(self, green, compliance, x, w, error)
    end subroutine spring_depth

    !> By panels in theta that grow from the edge, at which Phi is nearly singular.
    subroutine half_space_depth(self, green, x, w, error)
        type(tension_load_t), intent(in) :: self
        type(green_t), intent(in) :: green
        real(wp), intent(in) :: x
        real(wp), intent(out) :: w
        type(error_t), allocatable, intent(inout) :: error
        real(wp) :: t(nodes), weight(nodes), theta(nodes), psi(nodes), y(nodes), phi(nodes, green%columns), low, length

        call gauss_legendre(t, weight, error)
        w = 0.0_wp
        low = 0.0_wp
        length = max(sqrt(2.0_wp*(x/self%radius - 1.0_wp)), sqrt(shortest))
        do while (low < half_pi)
            length = min(length, 8.0_wp/size(self%cosines), half_pi - low)
            if (low + 1.01_wp*length > half_pi) length = half_pi - low
            theta = low + length*t
            call chebyshev_sums(self%cosines, -1.0_wp, 1.0_wp, cos(2.0_wp*theta), psi)
            ! both halves of the contact, from the points next to x on; x - a cos theta without cancellation
            y = (x - self%radius) + 2.0_wp*self%radius*sin(0.5_wp*theta)**2
            call green%at(y, phi)
            w = w + length/pi*sum(weight*psi*phi(:, of_load))
            y = x + self%radius*cos(theta(nodes:1:-1))
            call green%at(y, phi)
            w = w + length/pi*sum(weight*psi*phi(nodes:1:-1, of_load))
            low = low + length
            if (.not. low < half_pi*(1.0_wp - 1.0e-12_wp)) exit
            length = max(length, (growth - 1.0_wp)*low)
        end do
        if (green%columns > 2) w = w + couple_depth(self, green, x)
    end subroutine half_space_depth

    !> The ring couple at the edge: of q_0 = 1/sqrt(a^2 - x^2), whose depth is (1/pi) int_0^pi Phi(x - a cos theta) d theta, it is
    !> -a d/da.
    function couple_depth(self, green, x) result(w)
        type(tension_load_t), intent(in) :: self
        type(green_t), intent(in) :: green
        real(wp), intent(in) :: x
        real(wp) :: w
        integer, parameter :: count = 400
        real(wp) :: theta(count), phi(count, green%columns), y(count)
        integer :: i

        w = 0.0_wp
        if (.not. abs(self%couple) > 0.0_wp) return
        theta = [(pi*(i - 0.5_wp)/count, i=1, count)]
        y = x - self%radius*cos(theta)
        call green%at(y, phi)
        w = self%couple*self%radius*sum(cos(theta)*phi(:, of_couple))/count
    end function couple_depth

    !> The layers' part, (1/pi) int (kappa - kappa_0) q cos kx dk.
    subroutine add_body_depth(self, green, compliance, x, w, error)
        type(tension_load_t), intent(in) :: self
        type(green_t), intent(in) :: green
        class(compliance_t), intent(in) :: compliance
        real(wp), intent(in) :: x(:)
        real(wp), intent(inout) :: w(:)
        type(error_t), allocatable, intent(inout) :: error
        real(wp), allocatable :: k(:), weight(:), basis(:, :), transform(:)
        integer :: i, couple

        couple = merge(1, 0, green%columns > 2)
        call body_waves(green, compliance, self%radius + maxval(x), k, weight, error)
        if (allocated(error)) return
        call wave_basis(k, self%radius, size(self%cosines), couple, basis, error)
        if (allocated(error)) return
        transform = weight*matmul(self%cosines, basis(couple + 1:, :))
        if (couple == 1) transform = transform + weight*self%couple*basis(1, :)
        do i = 1, size(x)
            w(i) = w(i) + dot_product(transform, cos(k*x(i)))
        end do
    end subroutine add_body_depth

    !> u(r) = (2/pi) int_0^r w/sqrt(r^2 - x^2) dx, r > a, from `inside`, its part below a.
    subroutine displacement(self, green, compliance, r, inside, u, error)
        class(tension_load_t), intent(in) :: self
        type(green_t), intent(in) :: green
        class(compliance_t), intent(in) :: compliance
        real(wp), intent(in) :: r, inside
        real(wp), intent(out) :: u
        type(error_t), allocatable, intent(inout) :: error
        real(wp) :: t(nodes), weight(nodes), w(nodes), low, first, length

        call gauss_legendre(t, weight, error)
        u = inside
        first = asin(self%radius/r)
        low = 0.0_wp
        length = 1.0e-3_wp*(half_pi - first)
        do while (low < half_pi - first)
            length = min(length, half_pi - first - low)
            if (low + 1.01_wp*length > half_pi - first) length = half_pi - first - low
            call self%spring_depth(green, compliance, max(r*sin(first + low + length*t), self%radius), w, error)
            if (allocated(error)) return
            u = u + 2.0_wp/pi*length*dot_product(weight, w)
            low = low + length
            length = (growth - 1.0_wp)*low
            if (.not. low < (half_pi - first)*(1.0_wp - 1.0e-12_wp)) exit
        end do
    end subroutine displacement

end module mdrcontact_tension_fields
