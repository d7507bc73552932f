! SPDX-License-Identifier: GPL-3.0-or-later
!> Friction along any path where springs interact: rings of constant traction in the plane, each under Coulomb's law
!> (theory/friction.md (6.2)-(6.6)).
!>
!> A step to a new contact and a shift s needs the forces t of the rings that minimise
!>     t.C t/2 - t.(s + v),    |t_j| <= mu N_j,
!> C_jk the mean displacement of ring j by a force of 1 on ring k, N_j the normal force on ring j, v_j the mean of u - s where
!> the ring came to stick. C is positive definite: there is one solution, for any mu. Slip need not be an annulus.
module mdrcontact_friction_rings
    use mdrcontact_cancel, only: check_cancelled
    use mdrcontact_contact, only: contact_t
    use mdrcontact_contact_state, only: contact_state_t
    use mdrcontact_error, only: check_memory, error_domain, error_t, raise, to_text
    use mdrcontact_friction_box, only: minimise_in_box
    use mdrcontact_kinds, only: pi, wp
    use mdrcontact_medium_load, only: load_t
    use mdrcontact_medium_solver, only: check_springs, solver_t
    use mdrcontact_numerics_quadrature, only: gauss_legendre
    implicit none (type, external)
    private
    public :: ring_grid_t, rings_t, new_ring_grid

    !> An edge of the contact closer to a ring's than this part of its width is taken there.
    real(wp), parameter :: close = 1.0e-3_wp
    !> A negative pressure of this part of the mean pressure is more than the solver's error.
    real(wp), parameter :: noticeable = 1.0e-4_wp
    !> Where in a growing ring the contact is when the ring counts as touched. A contact that sticks while it grows over a ring of
    !> width w gains T by 2 G* (b + w/2) ds; discs of rings of constant traction are stiff as if their radius were b - alpha w,
    !> and a ring touched at the part t adds (1 - t) w: t = 1/2 - alpha. Near the edge rings are strips under the compliance
    !> 1/|k|; from how the Toeplitz matrix a(th) = 4 sin^2(th/2) sum of 1/|th + 2 pi m|^3 factorizes (Wiener and Hopf),
    !>     t = 1/4 - (1/(2 pi)) int_0^pi ln[2 sin(th/2) a(th)]/(1 - cos th) dth.
    real(wp), parameter :: touched = 0.384948_wp
    !> Nodes in a ring for its normal force.
    integer, parameter :: nodes = 3

    !> A straight step is divided so that the depth changes by no more than this many parts of the largest one, in units of 1 over
    !> the number of rings: for flat ends, whose edge does not move.
    real(wp), parameter :: coarse = 4.0_wp

    !> Rings of equal width. They never change.
    type :: ring_grid_t
        !> outer radii [length], and the displacement by a unit pressure on disc k integrated over disc j [length^3/modulus]
        real(wp), allocatable :: radii(:), products(:, :)
        !> that of the largest radius [length]
        real(wp) :: largest_depth = 0.0_wp
    end type ring_grid_t

    !> Record of the rings of a contact.
    type :: rings_t
        !> of the contact: its radius, depth and shift [length]
        real(wp) :: radius = 0.0_wp, depth = 0.0_wp, shift = 0.0_wp
        !> on the rings of the contact: outer radii, t, N [modulus length^2] and v [length]. Beyond the base, where the contact
        !> last stopped shrinking or filled a ring, there is one ring more, in which the contact grows
        real(wp), allocatable :: edges(:), load(:), normal(:), offset(:)
        !> at the base: the same as above
        real(wp), allocatable :: base_load(:)
        real(wp) :: base_depth = 0.0_wp, base_shift = 0.0_wp
        !> what the ring in which the contact grows has dissipated since the base, in steps already counted [modulus length^3]
        real(wp) :: grown = 0.0_wp
        !> after a step: T [modulus length^2], what the step dissipated [modulus length^3], stick radius [length]
        real(wp) :: force = 0.0_wp, dissipated = 0.0_wp, stick_radius = 0.0_wp
    contains
        procedure :: advance
    end type rings_t

contains

    !> Rings up to a state of the largest depth.
    subroutine new_ring_grid(self, tangential, state, count, error)
        type(ring_grid_t), intent(out) :: self
        class(solver_t), intent(in) :: tangential
        type(contact_state_t), intent(in) :: state
        integer, intent(in) :: count
        type(error_t), allocatable, intent(out) :: error
        integer :: i, stat

        self%largest_depth = state%depth
        self%radii = [(state%radius*real(i, wp)/real(count, wp), i=1, count)]
        allocate (self%products(count, count), stat=stat)
        call check_memory(error, stat)
        if (allocated(error)) return
        call check_springs(tangential, "histories of friction on rings are", error)
        do i = 1, count
            call check_cancelled(error)
            if (allocated(error)) return
            call tangential%springs%disc_products(self%radii(i), self%radii(:i), self%products(:i, i), error)
            if (allocated(error)) return
            self%products(i, :i) = self%products(:i, i)
        end do
    end subroutine new_ring_grid

    !> A straight step to a state and a shift. It is divided where the edge of the contact comes to a ring's.
    subroutine advance(self, grid, contact, tangential, coefficient, state, shift, error)
        class(rings_t), intent(inout) :: self
        type(ring_grid_t), intent(in) :: grid
        type(contact_t), intent(in) :: contact
        class(solver_t), intent(in) :: tangential
        real(wp), intent(in) :: coefficient
        type(contact_state_t), intent(in) :: state
        real(wp), intent(in) :: shift
        type(error_t), allocatable, intent(out) :: error
        type(contact_state_t) :: halt
        real(wp) :: radius, from(2), dissipated
        logical :: is_last

        if (.not. allocated(self%edges)) call open_contact(self, 0.0_wp)
        from = [self%depth, self%shift]
        dissipated = 0.0_wp
        if (.not. self%radius > 0.0_wp) call touch(self, grid, contact%equilibrium%profile%end_radius)
        do
            call find_halt(self, grid, contact, state, halt, radius, is_last, error)
            if (allocated(error)) return
            if (is_last .and. .not. radius > 0.0_wp) exit
            if (is_last) then
                call step(self, grid, contact, tangential, coefficient, state, radius, shift, error)
            else
                call step(self, grid, contact, tangential, coefficient, halt, radius, &
                          from(2) + (shift - from(2))*(halt%depth - from(1))/(state%depth - from(1)), error)
            end if
            if (allocated(error)) return
            dissipated = dissipated + self%dissipated
            if (is_last) exit
        end do
        if (.not. state%depth > 0.0_wp) call open_contact(self, shift)
        self%dissipated = dissipated
    end subroutine advance

    !> The initial contact: a flat end does so with all of its rings simultaneously, which carry nothing yet.
    subroutine touch(self, grid, end_radius)
        type(rings_t), intent(inout) :: self
        type(ring_grid_t), intent(in) :: grid
        !> 0 where there is no flat end [length]
        real(wp), intent(in) :: end_radius

        if (.not. end_radius > 0.0_wp) return
        self%radius = snapped(self, grid, min(end_radius, grid%radii(size(grid%radii))))
        self%edges = [pack(grid%radii, grid%radii < self%radius), self%radius]
        self%load = 0.0_wp*self%edges
        self%normal = self%load
        self%base_load = self%load
        self%offset = self%load - self%shift
    end subroutine touch

    !> The next state at which a straight step is divided, or its last one.
    subroutine find_halt(self, grid, contact, state, halt, radius, is_last, error)
        class(rings_t), intent(in) :: self
        type(ring_grid_t), intent(in) :: grid
        type(contact_t), intent(in) :: contact
        type(contact_state_t), intent(in) :: state
        type(contact_state_t), intent(out) :: halt
        !> of the halt [length]
        real(wp), intent(out) :: radius
        logical, intent(out) :: is_last
        type(error_t), allocatable, intent(out) :: error
        real(wp) :: most
        integer :: ring

        radius = snapped(self, grid, min(state%radius, grid%radii(size(grid%radii))))
        if (radius > self%radius) then
            ring = findloc(grid%radii > self%radius .and. grid%radii < radius, .true., dim=1)
        else
            ring = findloc(grid%radii < self%radius .and. grid%radii > radius, .true., dim=1, back=.true.)
        end if
        most = coarse*grid%largest_depth/real(size(grid%radii), wp)
        halt = state
        if (ring > 0) then
            call contact%at_radius(grid%radii(ring), halt, error)
            if (allocated(error)) return
            radius = grid%radii(ring)
        end if
        is_last = ring == 0
        if (abs(halt%depth - self%depth) <= most .or. .not. self%radius > 0.0_wp) return
        is_last = .false.
        call contact%at_depth(self%depth + sign(most, state%depth - self%depth), halt, error)
        if (.not. allocated(error)) radius = snapped(self, grid, min(halt%radius, grid%radii(size(grid%radii))))
    end subroutine find_halt

    !> A step within a ring, or of a contact that does not grow.
    subroutine step(self, grid, contact, tangential, coefficient, state, radius, shift, error)
        type(rings_t), intent(inout) :: self
        type(ring_grid_t), intent(in) :: grid
        type(contact_t), intent(in) :: contact
        class(solver_t), intent(in) :: tangential
        real(wp), intent(in) :: coefficient
        type(contact_state_t), intent(in) :: state
        !> of the contact [length]
        real(wp), intent(in) :: radius, shift
        type(error_t), allocatable, intent(out) :: error
        real(wp), allocatable, dimension(:) :: edges, areas, normal, limit, load, offset, before, moved, lost
        real(wp), allocatable :: compliance(:, :)
        real(wp) :: grown
        integer :: base, known, n, stat

        base = size(self%base_load)
        if (radius > self%radius) then
            edges = [self%edges(:base), radius]
        else
            edges = [pack(self%edges, self%edges < radius), radius]
        end if
        n = size(edges)
        known = min(n, size(self%load))
        areas = pi*(edges**2 - [0.0_wp, edges(:n - 1)]**2)
        allocate (normal(n))
        allocate (compliance(n, n), stat=stat)
        call check_memory(error, stat)
        if (.not. allocated(error)) call ring_forces(contact, state, edges, normal, error)
        if (.not. allocated(error)) call ring_compliance(grid, tangential, edges, areas, compliance, error)
        if (allocated(error)) return
        limit = coefficient*normal
        allocate (offset(n), load(n), before(n), source=0.0_wp)
        load(:known) = self%load(:known)
        before(:known) = self%normal(:known)
        offset(:known) = self%offset(:known)
        if (radius > self%radius) call find_touch(self, contact, state, shift, edges, compliance, limit, offset, error)
        if (.not. allocated(error)) call minimise_in_box(compliance, shift + offset, limit, load, error)
        if (allocated(error)) return
        moved = matmul(compliance, load) - shift
        if (radius > self%radius) before(n) = 0.0_wp
        lost = merge(0.5_wp*coefficient*(before + normal)*abs(moved - offset), 0.0_wp, abs(load) >= limit)
        if (radius > self%radius) then
            ! the slip of this ring is that since it touched, for any number of steps since then
            grown = max(self%grown, lost(n))
            lost(n) = grown - self%grown
            self%grown = grown
        end if
        self%dissipated = sum(lost)
        ! rings that have left slipped like the last one while their limit fell to 0
        self%dissipated = self%dissipated + 0.5_wp*coefficient*sum(self%normal(n + 1:))*abs(moved(n) - offset(n))
        self%force = sum(load)
        self%stick_radius = stick_radius(edges, 1.0_wp - abs(load)/max(limit, tiny(limit)))
        self%offset = merge(moved, offset, abs(load) >= limit)
        self%edges = edges
        self%load = load
        self%normal = normal
        if (radius > self%radius .and. any(grid%radii == radius)) call fill(self, grid, areas)
        if (radius <= self%radius .or. any(grid%radii == radius)) then
            self%grown = 0.0_wp
            self%base_load = self%load
            self%base_depth = state%depth
            self%base_shift = shift
        end if
        self%radius = radius
        self%depth = state%depth
        self%shift = shift
    end subroutine step

    !> Where the ring in which the contact grows was when it touched: between where it was when the growth began and where it would
    !> be without touching.
    subroutine find_touch(self, contact, state, shift, edges, compliance, limit, offset, error)
        type(rings_t), intent(in) :: self
        type(contact_t), intent(in) :: contact
        type(contact_state_t), intent(in) :: state
        real(wp), intent(in) :: shift, edges(:), compliance(:, :), limit(:)
        real(wp), intent(inout) :: offset(:)
        type(error_t), allocatable, intent(inout) :: error
        real(wp) :: free(size(self%base_load)), was, time
        type(contact_state_t) :: touching
        integer :: base, n

        base = size(self%base_load)
        n = base + 1
        free = self%load(:base)
        call minimise_in_box(compliance(:base, :base), shift + offset(:base), limit(:base), free, error)
        if (allocated(error)) return
        was = dot_product(compliance(n, :base), self%base_load) - self%base_shift
        time = touched*edges(n)
        if (base > 0) time = edges(base) + touched*(edges(n) - edges(base))
        call contact%at_radius(max(time, contact%equilibrium%profile%end_radius), touching, error)
        if (allocated(error)) return
        time = min(max((touching%depth - self%base_depth)/(state%depth - self%base_depth), 0.0_wp), 1.0_wp)
        offset(n) = was + time*(dot_product(compliance(n, :base), free) - shift - was)
    end subroutine find_touch

    !> Extend the contact to a whole ring whose inner part was already in contact, as one ring.
    subroutine fill(self, grid, areas)
        type(rings_t), intent(inout) :: self
        type(ring_grid_t), intent(in) :: grid
        real(wp), intent(in) :: areas(:)
        integer :: n

        n = size(self%edges)
        if (n == 1) return
        if (any(grid%radii == self%edges(n - 1))) return
        self%offset = [self%offset(:n - 2), sum(areas(n - 1:)*self%offset(n - 1:))/sum(areas(n - 1:))]
        self%load = [self%load(:n - 2), sum(self%load(n - 1:))]
        self%normal = [self%normal(:n - 2), sum(self%normal(n - 1:))]
        self%edges = [self%edges(:n - 2), self%edges(n)]
    end subroutine fill

    !> Nothing is in contact.
    subroutine open_contact(self, shift)
        type(rings_t), intent(inout) :: self
        real(wp), intent(in) :: shift
        real(wp), allocatable :: none(:)

        allocate (none(0))
        self%edges = none
        self%load = none
        self%normal = none
        self%offset = none
        self%base_load = none
        self%grown = 0.0_wp
        self%base_depth = 0.0_wp
        self%base_shift = shift
        self%radius = 0.0_wp
        self%depth = 0.0_wp
        self%shift = shift
        self%force = 0.0_wp
        self%dissipated = 0.0_wp
        self%stick_radius = 0.0_wp
    end subroutine open_contact

    !> A radius, or that of a ring or of the contact as it is if it is close.
    pure function snapped(self, grid, radius) result(taken)
        class(rings_t), intent(in) :: self
        type(ring_grid_t), intent(in) :: grid
        real(wp), intent(in) :: radius
        real(wp) :: taken
        integer :: nearest

        taken = radius
        if (size(self%edges) > 0) then
            nearest = minloc(abs(self%edges - radius), dim=1)
            if (abs(self%edges(nearest) - radius) < close*grid%radii(1)) taken = self%edges(nearest)
        end if
        nearest = nint(radius/grid%radii(1))
        if (nearest < 1 .or. nearest > size(grid%radii)) return
        if (abs(radius - grid%radii(nearest)) < close*grid%radii(1)) taken = grid%radii(nearest)
    end function snapped

    !> Normal forces on the rings between some radii, the last one the contact radius: p is smooth in sqrt(a^2 - r^2).
    subroutine ring_forces(contact, state, edges, forces, error)
        type(contact_t), intent(in), target :: contact
        type(contact_state_t), intent(in) :: state
        real(wp), intent(in) :: edges(:)
        real(wp), intent(out) :: forces(:)
        type(error_t), allocatable, intent(out) :: error
        class(load_t), allocatable :: load
        real(wp) :: t(nodes), weights(nodes), roots(0:size(edges)), root(nodes*size(edges)), pressure(nodes*size(edges))
        integer :: j

        forces = 0.0_wp
        if (.not. state%force > 0.0_wp) return
        call gauss_legendre(t, weights, error)
        if (allocated(error)) return
        roots(0) = state%radius
        roots(1:) = sqrt(max(state%radius**2 - edges**2, 0.0_wp))
        roots(size(edges)) = 0.0_wp
        do j = 1, size(edges)
            root(nodes*(j - 1) + 1:nodes*j) = roots(j) + (roots(j - 1) - roots(j))*t
        end do
        associate (equilibrium => contact%equilibrium)
            call equilibrium%medium%load(equilibrium%profile, state%radius, state%punch_depth, load, error)
        end associate
        if (.not. allocated(error)) call load%pressure(sqrt(max(state%radius**2 - root**2, 0.0_wp)), pressure, error)
        if (allocated(error)) return
        if (minval(pressure) < -noticeable*state%force/(pi*state%radius**2)) then
            call raise(error, error_domain, "this contact is not a single area: without adhesion its pressure would be "// &
                       to_text(minval(pressure))//" somewhere (contact radius "//to_text(state%radius)// &
                       "). Friction needs a pressure that is nowhere negative")
            return
        end if
        do j = 1, size(edges)
            forces(j) = 2.0_wp*pi*(roots(j - 1) - roots(j)) &
                        *sum(weights*pressure(nodes*(j - 1) + 1:nodes*j)*root(nodes*(j - 1) + 1:nodes*j))
        end do
        forces = max(forces, 0.0_wp)
        forces = state%force/sum(forces)*forces
    end subroutine ring_forces

    !> Mean displacements of rings by forces on rings.
    subroutine ring_compliance(rings, tangential, edges, areas, compliance, error)
        type(ring_grid_t), intent(in) :: rings
        class(solver_t), intent(in) :: tangential
        real(wp), intent(in) :: edges(:), areas(:)
        real(wp), intent(out) :: compliance(:, :)
        type(error_t), allocatable, intent(inout) :: error
        real(wp), allocatable :: products(:, :)
        integer :: grid(size(edges))
        integer :: i, n, stat

        n = size(edges)
        compliance = 0.0_wp
        allocate (products(0:n, 0:n), stat=stat)
        call check_memory(error, stat)
        if (allocated(error)) return
        grid = nint(edges/rings%radii(1))
        products = 0.0_wp
        do i = 1, n
            if (.not. is_of_grid(i)) grid(i) = 0
        end do
        do i = 1, n
            if (grid(i) > 0) then
                where (grid > 0) products(1:, i) = rings%products(max(grid, 1), grid(i))
            else
                call tangential%springs%disc_products(edges(i), edges, products(1:, i), error)
                if (allocated(error)) return
                products(i, 1:) = products(1:, i)
            end if
        end do
        do i = 1, n
            if (grid(i) == 0) products(i, 1:) = products(1:, i)
        end do
        compliance = products(1:, 1:) - products(:n - 1, 1:) - products(1:, :n - 1) + products(:n - 1, :n - 1)
        do i = 1, n
            compliance(:, i) = compliance(:, i)/(areas*areas(i))
        end do

    contains

        pure function is_of_grid(i) result(answer)
            integer, intent(in) :: i
            logical :: answer

            answer = grid(i) >= 1 .and. grid(i) <= size(rings%radii)
            if (answer) answer = edges(i) == rings%radii(grid(i))
        end function is_of_grid

    end subroutine ring_compliance

    !> The radius within which rings stick: what is missing to the limit grows with the root of the distance from it.
    pure function stick_radius(edges, missing) result(c)
        !> outer radii, and 1 - |t|/limit
        real(wp), intent(in) :: edges(:), missing(:)
        real(wp) :: c
        real(wp) :: middle(size(edges))
        integer :: last

        last = findloc(missing > 0.0_wp, .true., dim=1, back=.true.)
        c = 0.0_wp
        if (last == 0) return
        c = edges(last)
        if (last == size(edges) .or. last == 1) return
        middle = 0.5_wp*(edges + [0.0_wp, edges(:size(edges) - 1)])
        c = middle(last + 1)
        if (missing(last - 1) <= missing(last)) return
        c = min(c, middle(last) + (middle(last) - middle(last - 1))*missing(last)**2/(missing(last - 1)**2 - missing(last)**2))
    end function stick_radius

end module mdrcontact_friction_rings
