! SPDX-License-Identifier: GPL-3.0-or-later
!> Friction of springs that do not interact, along any path of depth d and shift s, exactly (theory/friction.md (6.1)).
!>
!> Every spring obeys Coulomb's law independently: w <- clip(w + ds, +-m (d - y)), w = q_t/G*, m = mu E*/G*, y = g(x) the depth at
!> which it comes into contact. As long as d and s change proportionally, spring and limit are straight lines in time, so that a
!> step of any size is exact; and w is a straight line in y between a few values of y, which are all that has to be remembered.
module mdrcontact_friction_springs
    use mdrcontact_contact, only: contact_t
    use mdrcontact_contact_state, only: contact_state_t
    use mdrcontact_error, only: error_t
    use mdrcontact_kinds, only: wp
    use mdrcontact_numerics_quadrature, only: gauss_legendre, graded_rule, smallest_panel_ratio
    implicit none (type, external)
    private
    public :: springs_t, radius_at

    integer, parameter :: nodes = 16

    !> w = constant + slope y on the springs that come into contact at depths from `from` to `to`.
    type :: piece_t
        real(wp) :: from = 0.0_wp, to = 0.0_wp, constant = 0.0_wp, slope = 0.0_wp
        !> -1, 1: they slipped in the last step, in that sense; 0: they stuck
        integer :: slip = 0
    end type piece_t

    !> The springs in contact, from the axis outwards.
    type :: springs_t
        !> m [1], d and s [length]
        real(wp) :: limit = 0.0_wp, depth = 0.0_wp, shift = 0.0_wp
        type(piece_t), allocatable :: pieces(:)
        !> those that lost contact in the last step, and what each spring that slipped dissipated in it (see lost_by)
        type(step_t), allocatable, private :: lost(:)
    contains
        procedure :: advance
        procedure :: force
        procedure :: dissipated
        procedure :: stick_depth
    end type springs_t

    !> Slip of springs in a step: per spring and over G*, limit v int (d(t) - y) dt from t1 to t2, both straight in y.
    type :: step_t
        real(wp) :: from = 0.0_wp, to = 0.0_wp, first(2) = 0.0_wp, last(2) = 0.0_wp
        real(wp) :: velocity = 0.0_wp, depth = 0.0_wp, rise = 0.0_wp
    end type step_t

contains

    !> A straight step to a depth and a shift.
    pure subroutine advance(self, depth, shift)
        class(springs_t), intent(inout) :: self
        !> d >= 0 and s [length]
        real(wp), intent(in) :: depth, shift
        type(piece_t), allocatable :: trial(:), done(:)
        real(wp) :: way, rise
        integer :: i

        way = shift - self%shift
        rise = depth - self%depth
        if (.not. allocated(self%pieces)) allocate (self%pieces(0))
        if (allocated(self%lost)) deallocate (self%lost)
        allocate (self%lost(0))
        trial = self%pieces
        do i = 1, size(trial)
            if (trial(i)%to > depth) call part(self, trial(i), max(trial(i)%from, depth), trial(i)%to, way, rise)
        end do
        trial = pack(trial, trial%from < depth)
        trial%to = min(trial%to, depth)
        trial%constant = trial%constant + way
        allocate (done(0))
        do i = 1, size(trial)
            call clip(self, trial(i), depth, way, rise, done)
        end do
        if (rise > 0.0_wp) call touch(self, depth, way, rise, done)
        call join(done)
        call move_alloc(done, self%pieces)
        self%depth = depth
        self%shift = shift
    end subroutine advance

    !> Springs that lose contact: they slip in the sense of the load they would have when they part.
    pure subroutine part(self, piece, from, to, way, rise)
        class(springs_t), intent(inout) :: self
        type(piece_t), intent(in) :: piece
        real(wp), intent(in) :: from, to, way, rise
        real(wp) :: at_from, at_to, middle

        ! the load at the time (d - y)/(-rise)
        at_from = piece%constant + piece%slope*from - way*(self%depth - from)/rise
        at_to = piece%constant + piece%slope*to - way*(self%depth - to)/rise
        middle = merge(from, to, abs(at_from) < abs(at_to))
        if (at_from*at_to < 0.0_wp) middle = from + (to - from)*at_from/(at_from - at_to)
        call record(self, piece, from, middle, merge(1, -1, at_from > 0.0_wp), way, rise, [-self%depth/rise, 1.0_wp/rise])
        call record(self, piece, middle, to, merge(1, -1, at_to > 0.0_wp), way, rise, [-self%depth/rise, 1.0_wp/rise])
    end subroutine part

    !> Split a piece at its limits, and set the parts beyond them to the limits.
    pure subroutine clip(self, piece, depth, way, rise, done)
        class(springs_t), intent(inout) :: self
        type(piece_t), intent(in) :: piece
        real(wp), intent(in) :: depth, way, rise
        type(piece_t), allocatable, intent(inout) :: done(:)
        type(piece_t) :: next
        real(wp) :: cut(4), middle, load, bound
        integer :: i, sense

        cut = [piece%from, crossing(1.0_wp), crossing(-1.0_wp), piece%to]
        cut(2:3) = [minval(cut(2:3)), maxval(cut(2:3))]
        do i = 1, 3
            if (.not. cut(i + 1) > cut(i)) cycle
            middle = 0.5_wp*(cut(i) + cut(i + 1))
            load = piece%constant + piece%slope*middle
            bound = self%limit*(depth - middle)
            next = piece
            next%from = cut(i)
            next%to = cut(i + 1)
            next%slip = 0
            if (abs(load) > bound) then
                sense = merge(1, -1, load > 0.0_wp)
                next = piece
                next%constant = piece%constant - way
                call record(self, next, cut(i), cut(i + 1), sense, way, rise, [1.0_wp, 0.0_wp])
                next = piece_t(cut(i), cut(i + 1), sense*self%limit*depth, -sense*self%limit, sense)
            end if
            done = [done, next]
        end do

    contains

        !> Where the load reaches the limit of a sense, moved into the piece.
        pure function crossing(sense) result(y)
            real(wp), intent(in) :: sense
            real(wp) :: y
            real(wp) :: rate

            rate = piece%slope + sense*self%limit
            y = piece%from
            if (abs(rate) > 0.0_wp) y = (sense*self%limit*depth - piece%constant)/rate
            y = min(max(y, piece%from), piece%to)
        end function crossing

    end subroutine clip

    !> Springs that come into contact: all of them stick, or slip where the shift outruns the depth. Their loads are not compared
    !> with their limits one by one: where the depth rises by little they have no digits.
    pure subroutine touch(self, depth, way, rise, done)
        class(springs_t), intent(inout) :: self
        real(wp), intent(in) :: depth, way, rise
        type(piece_t), allocatable, intent(inout) :: done(:)
        type(piece_t) :: born
        integer :: sense

        born = piece_t(self%depth, depth, way/rise*depth, -way/rise, 0)
        if (abs(way) > self%limit*rise) then
            sense = merge(1, -1, way > 0.0_wp)
            born = piece_t(self%depth, depth, sense*self%limit*depth, -sense*self%limit, sense)
            call record(self, born, self%depth, depth, sense, way, rise, [1.0_wp, 0.0_wp], [-self%depth/rise, 1.0_wp/rise])
        end if
        done = [done, born]
    end subroutine touch

    !> Keeps what the slip of some springs dissipates: from the time at which they meet their limit, or touch, to the last one.
    pure subroutine record(self, before, from, to, sense, way, rise, last, first)
        class(springs_t), intent(inout) :: self
        !> loads at the beginning of the step
        type(piece_t), intent(in) :: before
        real(wp), intent(in) :: from, to
        integer, intent(in) :: sense
        real(wp), intent(in) :: way, rise
        !> times as constant and slope in y; without the first one it is that at which the limit is met
        real(wp), intent(in) :: last(2)
        real(wp), intent(in), optional :: first(2)
        type(step_t) :: step

        step%velocity = sense*way - self%limit*rise
        if (.not. (step%velocity > 0.0_wp .and. to > from)) return
        step%from = from
        step%to = to
        step%depth = self%depth
        step%rise = rise
        step%last = last
        if (present(first)) then
            step%first = first
        else
            step%first = [self%limit*self%depth - sense*before%constant, -self%limit - sense*before%slope]/step%velocity
        end if
        self%lost = [self%lost, step]
    end subroutine record

    !> Joins neighbours that are one straight line.
    pure subroutine join(pieces)
        type(piece_t), allocatable, intent(inout) :: pieces(:)
        integer :: i, kept

        if (size(pieces) == 0) return
        kept = 1
        do i = 2, size(pieces)
            if (pieces(i)%slip == pieces(kept)%slip .and. pieces(i)%constant == pieces(kept)%constant .and. &
                pieces(i)%slope == pieces(kept)%slope) then
                pieces(kept)%to = pieces(i)%to
            else
                kept = kept + 1
                pieces(kept) = pieces(i)
            end if
        end do
        pieces = pieces(:kept)
    end subroutine join

    !> T/G* [length^2].
    subroutine force(self, contact, total, error)
        class(springs_t), intent(in) :: self
        type(contact_t), intent(in) :: contact
        real(wp), intent(out) :: total
        type(error_t), allocatable, intent(inout) :: error
        real(wp) :: x, before
        integer :: i

        total = 0.0_wp
        before = 0.0_wp
        do i = 1, size(self%pieces)
            call radius_at(contact, self%pieces(i)%to, x, error)
            if (allocated(error)) return
            associate (profile => contact%equilibrium%profile)
                ! int g dx = x g - int x g' dx
                total = total + self%pieces(i)%constant*(x - before) &
                        + self%pieces(i)%slope*((x*profile%mdr(x) - before*profile%mdr(before)) &
                                                - (profile%mdr_moment(x) - profile%mdr_moment(before)))
            end associate
            before = x
        end do
        total = 2.0_wp*total
    end subroutine force

    !> The radius of contact at a depth, that of the spring that has just come into contact.
    subroutine radius_at(contact, depth, x, error)
        type(contact_t), intent(in) :: contact
        real(wp), intent(in) :: depth
        real(wp), intent(out) :: x
        type(error_t), allocatable, intent(inout) :: error
        type(contact_state_t) :: state

        x = 0.0_wp
        if (.not. depth > 0.0_wp) return
        call contact%at_depth(depth, state, error)
        x = state%radius
    end subroutine radius_at

    !> Energy dissipated in the last step over G* [length^3].
    subroutine dissipated(self, contact, total, error)
        class(springs_t), intent(in) :: self
        type(contact_t), intent(in) :: contact
        real(wp), intent(out) :: total
        type(error_t), allocatable, intent(inout) :: error
        real(wp), allocatable, dimension(:) :: x, dx, breaks, exponents, coefficients
        real(wp) :: t(nodes), weights(nodes), lower, upper
        logical :: is_polynomial
        integer :: i

        total = 0.0_wp
        if (size(self%lost) == 0) return
        call gauss_legendre(t, weights, error)
        associate (profile => contact%equilibrium%profile)
            call profile%powers(exponents, coefficients)
            is_polynomial = size(exponents) > 0 .and. all(modulo(exponents, 1.0_wp) == 0.0_wp)
            call profile%add_breaks(breaks, error)
            do i = 1, size(self%lost)
                if (.not. allocated(error)) call radius_at(contact, self%lost(i)%from, lower, error)
                if (.not. allocated(error)) call radius_at(contact, self%lost(i)%to, upper, error)
                if (allocated(error)) return
                if (.not. upper > lower) cycle
                if (is_polynomial) then
                    total = total + spent(self%lost(i), profile%mdr(lower + (upper - lower)*t), (upper - lower)*weights)
                else
                    call graded_rule(max(lower, smallest_panel_ratio*upper), upper, breaks, profile%singular_radius, x, dx, error)
                    if (allocated(error)) return
                    total = total + spent(self%lost(i), profile%mdr(x), dx)
                end if
            end do
        end associate
        total = 2.0_wp*self%limit*total
    end subroutine dissipated

    !> Energy dissipated by the slip of some springs, over G* and the limit.
    pure function spent(step, y, dx) result(total)
        type(step_t), intent(in) :: step
        !> depths of contact and weights of the springs
        real(wp), intent(in) :: y(:), dx(:)
        real(wp) :: total
        real(wp), dimension(size(y)) :: begin, end

        begin = max(step%first(1) + step%first(2)*y, 0.0_wp)
        end = max(step%last(1) + step%last(2)*y, begin)
        total = step%velocity*sum(dx*(end - begin)*((step%depth - y) + 0.5_wp*step%rise*(end + begin)))
    end function spent

    !> The depth at which the outermost spring came into contact that stuck in the last step [length].
    pure function stick_depth(self) result(depth)
        class(springs_t), intent(in) :: self
        real(wp) :: depth

        depth = 0.0_wp
        if (any(self%pieces%slip == 0)) depth = maxval(self%pieces%to, mask=self%pieces%slip == 0)
    end function stick_depth

end module mdrcontact_friction_springs
