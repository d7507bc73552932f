! SPDX-License-Identifier: GPL-3.0-or-later
!> Any history of any viscoelastic stack, step by step (theory/time.md (6.1)-(6.5)):
!>     J_g q + sum J_l z_l(x) + (2/pi) int cos(kx) [X_g q^ + sum R_m y_m] dk = d(t) - g(x),   x < a(t)
!>     th_l dz_l/dt = q - z_l,    th_m dy_m/dt = q^ - y_m
!> with q linear in time over a step. The memory y of the smooth part lives in k-space and never needs a(t); that of the
!> springs themselves, z, lives on panels of x which end at the edge of the contact and at the radii where it has turned.
module mdrcontact_time_march
    use mdrcontact_cancel, only: check_cancelled
    use mdrcontact_contact_values, only: given_depth, given_force, given_radius
    use mdrcontact_error, only: check_memory, error_domain, error_no_convergence, error_t, raise, to_text
    use mdrcontact_time_memory, only: memory_t
    use mdrcontact_time_panels, only: add_turn, cut, interpolate, new_panels, panels_t, per_panel
    use mdrcontact_time_path, only: mean_lag, mean_rise
    use mdrcontact_kinds, only: wp
    use mdrcontact_profile, only: copy, profile_t
    implicit none (type, external)
    private
    public :: march_t, start_march, step_march, mark_kink

    !> Smallest contact, relative to the largest radius; smaller ones count as lost.
    real(wp), parameter :: smallest_part = 1.0e-7_wp
    real(wp), parameter :: edge_tolerance = 1.0e-12_wp
    !> After so many trials the residual must have fallen to this part, else the bracket is cut in the middle of its logarithm: the
    !> force goes as a power of the radius, whose chord from a far end leads nowhere.
    integer, parameter :: patience = 3
    real(wp), parameter :: fallen = 0.1_wp
    integer, parameter :: most_trials = 200

    !> State of a history.
    type :: march_t
        class(profile_t), allocatable :: profile
        type(memory_t) :: memory
        !> no contact is larger [length]; whether because the indenter ends there in a wall, at which q need not vanish
        real(wp) :: limit = 0.0_wp
        logical :: ends_in_wall = .false.
        !> radius of a flat end, 0 without [length]
        real(wp) :: flat = 0.0_wp
        !> state: depth, contact radius, force
        real(wp) :: depth = 0.0_wp, radius = 0.0_wp, force = 0.0_wp
        !> least gap outside the contact so far, where the surface has been touched [length]
        real(wp) :: gap = 0.0_wp
        !> 1: grew in the last step, -1: shrank
        integer :: direction = 1
        !> radii where the contact has turned, or where the prescribed quantity has a kink, ascending
        real(wp), allocatable :: turns(:)
        !> q and z_l (nodes, l)
        type(panels_t) :: panels
        real(wp), allocatable :: q(:, :), z(:, :)
        !> y_m (k, m) and q^(k)
        real(wp), allocatable :: y(:, :), wave(:)
    end type march_t

    !> A step under trial radii.
    type :: trial_t
        type(panels_t) :: panels
        real(wp), allocatable :: q(:), z(:, :), wave(:)
        !> e_g - e_1 d, or F less the prescribed one; falls through 0 where the contact should end
        real(wp) :: residual = 0.0_wp, depth = 0.0_wp, force = 0.0_wp
        !> least of w - (d - g) outside the contact, where the surface has been touched
        real(wp) :: gap = 0.0_wp
    end type trial_t

contains

    !> A body at rest, no contact.
    subroutine start_march(self, profile, memory, limit, error)
        type(march_t), intent(out) :: self
        class(profile_t), intent(in) :: profile
        type(memory_t), intent(in) :: memory
        real(wp), intent(in) :: limit
        type(error_t), allocatable, intent(inout) :: error

        call copy(profile, self%profile, error)
        if (allocated(error)) return
        self%memory = memory
        self%limit = limit
        self%ends_in_wall = profile%has_wall .and. limit >= profile%largest_radius
        self%flat = profile%end_radius
        self%turns = [real(wp) ::]
        self%panels = new_panels([0.0_wp])
        allocate (self%q(0, 1), self%z(0, size(memory%local%rate)))
        allocate (self%y(size(memory%k), size(memory%time)), self%wave(size(memory%k)))
        self%y = 0.0_wp
        self%wave = 0.0_wp
    end subroutine start_march

    !> One step of length h to the prescribed depth, force or radius; h = 0 is a jump.
    subroutine step_march(self, h, given, value, error)
        type(march_t), intent(inout) :: self
        real(wp), intent(in) :: h
        !> given_depth, given_force or given_radius, and the prescribed quantity at the end of the step
        integer, intent(in) :: given
        real(wp), intent(in) :: value
        type(error_t), allocatable, intent(inout) :: error
        type(trial_t) :: trial
        real(wp) :: radius

        if (allocated(error)) return
        radius = value
        if (given == given_radius) then
            call try(self, h, radius, given, value, .false., trial, error)
        else
            call find_edge(self, h, given, value, radius, trial, error)
        end if
        if (allocated(error)) return
        call commit(self, h, radius, given, value, trial)
    end subroutine step_march

    !> The radius at the end of the step, and the state there.
    subroutine find_edge(self, h, given, value, radius, trial, error)
        type(march_t), intent(in) :: self
        real(wp), intent(in) :: h
        integer, intent(in) :: given
        real(wp), intent(in) :: value
        real(wp), intent(out) :: radius
        type(trial_t), intent(out) :: trial
        type(error_t), allocatable, intent(inout) :: error
        real(wp) :: low, high, x, x_before, y_before, y_checked, next
        integer :: i
        logical :: has_high

        radius = 0.0_wp
        low = smallest_part*self%limit
        call try(self, h, low, given, value, .false., trial, error)
        if (allocated(error)) return
        if (.not. trial%residual < 0.0_wp) then
            ! no contact at all
            call try(self, h, 0.0_wp, given, value, .false., trial, error)
            return
        end if
        high = self%limit
        has_high = .false.
        y_checked = huge(1.0_wp)
        x_before = low
        y_before = trial%residual
        x = min(max(self%radius, 1.0e-3_wp*self%limit), 0.9_wp*self%limit)
        if (self%ends_in_wall .and. self%radius >= self%limit) x = self%limit
        do i = 1, most_trials
            call check_cancelled(error)
            if (.not. allocated(error)) call try(self, h, x, given, value, .false., trial, error)
            if (allocated(error)) return
            radius = x
            if (trial%residual < 0.0_wp) then
                low = x
            else
                high = x
                has_high = .true.
            end if
            if (low >= self%limit*(1.0_wp - edge_tolerance)) then
                radius = self%limit
                if (self%ends_in_wall) then
                    call try(self, h, radius, given, value, .true., trial, error)
                else
                    call raise(error, error_domain, "the contact would be larger than radius "//to_text(self%limit))
                end if
                return
            end if
            next = high
            if (abs(trial%residual - y_before) > 0.0_wp) next = x - trial%residual*(x - x_before)/(trial%residual - y_before)
            if (abs(next - x) <= edge_tolerance*self%limit .or. high - low <= edge_tolerance*self%limit) return
            if (has_high .and. mod(i, patience) == 0) then
                if (abs(trial%residual) > fallen*y_checked) next = high
                y_checked = abs(trial%residual)
            end if
            if (.not. (next > low .and. next < high)) then
                next = sqrt(low)*sqrt(high)
                if (.not. has_high) next = min(1.5_wp*x, high)
            end if
            x_before = x
            y_before = trial%residual
            x = next
        end do
        call raise(error, error_no_convergence, "the edge of the contact was not found in a step of length "//to_text(h))
    end subroutine find_edge

    subroutine commit(self, h, radius, given, value, trial)
        type(march_t), intent(inout) :: self
        real(wp), intent(in) :: h, radius, value
        integer, intent(in) :: given
        type(trial_t), intent(in) :: trial
        real(wp) :: u
        integer :: direction, m

        direction = merge(1, -1, radius >= self%radius)
        if (direction /= self%direction .and. self%radius > 0.0_wp) call add_turn(self%turns, self%radius, self%limit)
        self%direction = direction
        self%radius = radius
        self%depth = trial%depth
        self%force = trial%force
        self%gap = min(self%gap, trial%gap)
        if (given == given_depth) self%depth = value
        if (given == given_force .and. radius > 0.0_wp) self%force = value
        self%panels = trial%panels
        deallocate (self%q)
        allocate (self%q(size(trial%q), 1))
        self%q(:, 1) = trial%q
        self%z = trial%z
        do m = 1, size(self%memory%time)
            u = h/self%memory%time(m)
            self%y(:, m) = exp(-u)*self%y(:, m) + mean_lag(u)*self%wave + mean_rise(u)*trial%wave
        end do
        self%wave = trial%wave
        ! a jump leaves a kink at its edge
        if (h <= 0.0_wp .and. radius > 0.0_wp) call add_turn(self%turns, radius, self%limit)
    end subroutine commit

    !> The prescribed quantity has a kink here: memories keep it at the edge as it is.
    pure subroutine mark_kink(self)
        type(march_t), intent(inout) :: self

        if (self%radius > 0.0_wp) call add_turn(self%turns, self%radius, self%limit)
    end subroutine mark_kink

    !> The state at the end of the step if the contact then has a given radius. The memory y is not touched.
    subroutine try(self, h, radius, given, value, is_held, trial, error)
        type(march_t), intent(in) :: self
        real(wp), intent(in) :: h, radius, value
        integer, intent(in) :: given
        !> by the wall: then q need not vanish at the edge, and there is no residual
        logical, intent(in) :: is_held
        type(trial_t), intent(out) :: trial
        type(error_t), allocatable, intent(inout) :: error
        real(wp), allocatable :: z(:, :), q(:, :), held(:), cosines(:, :), matrix(:, :), right(:, :), history(:), local(:), decay(:)
        real(wp), allocatable :: memory(:), factor(:), work(:, :), displacement(:), g(:), edge(:)
        real(wp) :: u, edge_one, edge_g, low, high, force(2)
        integer :: i, l, m, n, inner, last, stat

        call place(self, radius, trial%panels, inner, error)
        if (allocated(error)) return
        n = size(trial%panels%x)
        associate (x => trial%panels%x, creep => self%memory%local, k => self%memory%k)
            allocate (z, source=interpolate(self%panels, self%z, x))
            allocate (q, source=interpolate(self%panels, self%q, x))
            where (x > self%radius) q(:, 1) = 0.0_wp
            ! how long each place is in contact during the step; a flat end appears and disappears instantly
            allocate (held(n), local(n), history(n), decay(n), g(n))
            low = min(radius, self%radius)
            high = max(radius, self%radius)
            if (.not. low > 0.0_wp) low = min(self%flat, high)
            held = h
            where (x > low) held = 0.0_wp
            where (x > low .and. x < high) held = h*(high - x)/(high - low)
            ! z at the end: history and what q adds
            local = creep%instant
            history = 0.0_wp
            allocate (trial%z(n, size(creep%rate)))
            do l = 1, size(creep%rate)
                do i = 1, n
                    u = creep%rate(l)*held(i)
                    decay(i) = exp(-u)
                    if (x(i) > self%radius) then
                        ! free, then touched: q rises from 0
                        trial%z(i, l) = exp(-creep%rate(l)*h)*z(i, l)
                    else
                        ! held with q falling or changing, then free
                        trial%z(i, l) = decay(i)*z(i, l) + mean_lag(u)*q(i, 1)
                        if (x(i) > radius) trial%z(i, l) = exp(-creep%rate(l)*(h - held(i)))*trial%z(i, l)
                    end if
                    if (x(i) <= radius) local(i) = local(i) + creep%weight(l)*mean_rise(u)
                    history(i) = history(i) + creep%weight(l)*trial%z(i, l)
                end do
            end do
            ! the smooth part
            allocate (memory(size(k)), factor(size(k)), cosines(n, size(k)), stat=stat)
            call check_memory(error, stat)
            if (stat /= 0) return
            factor = self%memory%instant
            memory = 0.0_wp
            do m = 1, size(self%memory%time)
                u = h/self%memory%time(m)
                factor = factor + self%memory%rest(:, m)*mean_rise(u)
                memory = memory + self%memory%rest(:, m)*(exp(-u)*self%y(:, m) + mean_lag(u)*self%wave)
            end do
            do i = 1, size(k)
                cosines(:, i) = cos(k(i)*x)
            end do
            history = history + matmul(cosines, memory*self%memory%weights)
            do i = 1, n
                g(i) = self%profile%mdr(x(i))
            end do
            allocate (trial%q(n), trial%wave(size(k)))
            trial%q = 0.0_wp
            trial%wave = 0.0_wp
            trial%depth = 0.0_wp
            if (given == given_depth) trial%depth = value
            ! at radius 0, or under no force, the indenter touches the surface where it is
            if (given == given_radius .and. inner == 0 .and. n > 0) trial%depth = history(1)
            if (given == given_force .and. inner == 0 .and. n > 0) trial%depth = minval(history + g)
            if (inner > 0) then
                ! unknowns at all nodes of the contact, but the edge where q = 0
                last = merge(inner, inner - 1, is_held)
                allocate (matrix(inner, inner), right(last, 2), work(inner, size(k)), edge(inner), stat=stat)
                call check_memory(error, stat)
                if (stat /= 0) return
                do i = 1, size(k)
                    work(:, i) = cosines(:inner, i)*(factor(i)*self%memory%weights(i))
                end do
                matrix = matmul(work, transpose(cosines(:inner, :)))
                edge = matrix(inner, :)*trial%panels%weights(:inner)
                do i = 1, inner
                    matrix(i, i) = matrix(i, i) + local(i)/trial%panels%weights(i)
                end do
                right(:, 1) = 1.0_wp
                right(:, 2) = g(:last) + history(:last)
                call solve_symmetric(last, inner, matrix, right)
                force = 2.0_wp*sum(right, dim=1)
                do i = 1, 2
                    right(:, i) = right(:, i)/trial%panels%weights(:last)
                end do
                edge_one = 1.0_wp - sum(edge(:inner - 1)*right(:inner - 1, 1))
                edge_g = g(inner) + history(inner) - sum(edge(:inner - 1)*right(:inner - 1, 2))
                if (.not. (abs(edge_one) <= huge(1.0_wp) .and. abs(edge_g) <= huge(1.0_wp))) then
                    call raise(error, error_no_convergence, "the springs of this body are nearly singular at radius "// &
                        to_text(radius))
                    return
                end if
                if (given /= given_depth) trial%depth = edge_g/edge_one
                if (given == given_force .and. is_held) trial%depth = (value + force(2))/force(1)
                trial%q(:last) = trial%depth*right(:, 1) - right(:, 2)
                trial%force = trial%depth*force(1) - force(2)
                trial%residual = edge_g - edge_one*trial%depth
                if (given == given_force) trial%residual = trial%force - value
                trial%wave = matmul(trial%panels%weights(:inner)*trial%q(:inner), cosines(:inner, :))
            end if
            do l = 1, size(creep%rate)
                where (x <= radius) trial%z(:, l) = trial%z(:, l) + mean_rise(creep%rate(l)*held)*trial%q
            end do
            trial%gap = 0.0_wp
            if (n > inner) then
                allocate (displacement(n))
                displacement = history + matmul(cosines, factor*self%memory%weights*trial%wave)
                trial%gap = min(0.0_wp, minval(displacement(inner + 1:) - (trial%depth - g(inner + 1:))))
            end if
        end associate
    end subroutine try

    !> Replaces x by the solution of a x = x, a symmetric, by L D L^T without pivots: positive definite, but for the entry of a thin
    !> zone where the contact grows. Systems so small that no BLAS is to start threads for them.
    pure subroutine solve_symmetric(n, m, a, x)
        integer, intent(in) :: n, m
        !> lower triangle; overwritten
        real(wp), intent(inout) :: a(m, m), x(n, 2)
        integer :: i, j

        do j = 1, n
            do i = j + 1, n
                a(i:n, i) = a(i:n, i) - (a(i, j)/a(j, j))*a(i:n, j)
            end do
            do i = 1, 2
                x(j + 1:n, i) = x(j + 1:n, i) - (x(j, i)/a(j, j))*a(j + 1:n, j)
            end do
        end do
        do j = n, 1, -1
            do i = 1, 2
                x(j, i) = (x(j, i) - sum(a(j + 1:n, j)*x(j + 1:n, i)))/a(j, j)
            end do
        end do
    end subroutine solve_symmetric

    !> Panels for a trial radius: to the turns, to the edge, and as far as the surface has been touched.
    subroutine place(self, radius, panels, inner, error)
        type(march_t), intent(in) :: self
        real(wp), intent(in) :: radius
        type(panels_t), intent(out) :: panels
        !> nodes within the contact, its edge included
        integer, intent(out) :: inner
        type(error_t), allocatable, intent(inout) :: error
        real(wp), allocatable :: ends(:), inside(:)
        real(wp) :: near, largest
        integer :: i

        near = 1.0e-9_wp*self%limit
        allocate (ends, source=self%turns)
        if (self%radius > 0.0_wp .and. (radius < self%radius) .neqv. (self%direction < 0)) then
            call add_turn(ends, self%radius, self%limit)
        end if
        call self%profile%add_breaks(inside, error)
        do i = 1, size(inside)
            call add_turn(ends, inside(i), self%limit)
        end do
        ends = pack(ends, ends > near)
        largest = self%panels%ends(ubound(self%panels%ends, 1))
        inner = 0
        inside = [0.0_wp]
        if (radius > 0.0_wp) then
            inside = cut([0.0_wp, pack(ends, ends < radius - near), radius], self%memory%longest_panel)
            inner = per_panel*(size(inside) - 1)
        end if
        if (largest > radius + near) then
            ends = cut([radius, pack(ends, ends > radius + near .and. ends < largest - near), largest], self%memory%longest_panel)
            inside = [inside, ends(2:)]
        end if
        panels = new_panels(inside)
    end subroutine place

end module mdrcontact_time_march
