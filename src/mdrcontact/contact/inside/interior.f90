! SPDX-License-Identifier: GPL-3.0-or-later
!> Displacements and stresses inside a homogeneous, layered or graded body under a load on its surface
!> (theory/stress.md (1.2)-(1.5), (6.4)-(6.6)).
!>
!> In the surface layer: the closed field of a half-space of its material, and the Hankel integral of what the layers below
!> add; deeper: the Hankel integral of the whole state. z >= 0 points into the body, tension is positive.
module mdrcontact_inside_interior
    use mdrcontact_nonfinite, only: infinity
    use mdrcontact_batch, only: batch_t, run_batch
    use mdrcontact_error, only: check_memory, check_not_negative, error_domain, error_t, raise, to_text
    use mdrcontact_inside_half_space, only: half_space_rule_t, integrate, new_half_space_rule, normal_sums, shear_sums
    use mdrcontact_inside_hankel, only: add_grid, add_point, hankel_t, new_hankel, part_t, twin_hankel
    use mdrcontact_inside_layer_states, only: layer_states_t, new_layer_states
    use mdrcontact_inside_lattice, only: distinct_among, lattice_t, new_lattice
    use mdrcontact_medium_load, only: load_t
    use mdrcontact_body_layers, only: layers_t
    use mdrcontact_inside_states, only: depth_t, states_t
    use mdrcontact_inside_waves, only: faded
    use mdrcontact_kinds, only: pi, wp
    implicit none (type, external)
    private
    public :: interior_field, state_field, check_distances, depth_of, infinite_pressure, components, kept_waves_t
    public :: u_r, u_t, u_z, s_rr, s_tt, s_zz, s_rz, s_rt, s_tz

    !> The components by their place in a result.
    integer, parameter :: u_r = 1, u_t = 2, u_z = 3, s_rr = 4, s_tt = 5, s_zz = 6, s_rz = 7, s_rt = 8, s_tz = 9, components = 9

    !> Points farther away than this raise an error [a].
    real(wp), parameter :: farthest_point = 1.0e12_wp
    !> On a grid the whole state is integrated from this part of the surface layer on, because the waves are shared there; not in
    !> one thinner than the other number, where waves cost more than the closed field [a].
    real(wp), parameter :: shared_from = 0.5_wp, thin = 0.05_wp
    !> Where the pressure is infinite, what is finite is taken this far below the surface: halfway if it jumps there [a].
    real(wp), parameter :: just_below = 1.0e-15_wp

    !> Points up to this a + r share a rule [a].
    real(wp), parameter :: near = 3.0_wp
    !> Rules that are kept reach up to this a + r and its doubles [a], and to wavenumbers that an earlier rule has, if these are no
    !> larger than so many times those at hand.
    real(wp), parameter :: near_kept = 2.2_wp, most_waves = 4.0_wp
    !> Rules that are kept at most, and nodes times layers of all of them, of 50 bytes each.
    integer, parameter :: most_kept = 8
    !> Layers at most of a body whose states are copied for a rule that is kept: about 100 kB.
    integer, parameter :: most_kept_steps = 100
    real(wp), parameter :: most_kept_amplitudes = 2.0e6_wp

    !> The states of a body at the nodes of one rule of wavenumbers.
    type :: waves_t
        class(states_t), allocatable :: states
        type(hankel_t) :: hankel
        !> what it covers: a + r [a], wavenumbers [1/a]
        real(wp) :: farthest = 0.0_wp, last = 0.0_wp
    end type waves_t

    !> What many fields of one load on one body share.
    type :: kept_waves_t
        private
        !> the one after the last that is kept is for those that are not
        type(waves_t) :: waves(most_kept + 1)
        integer :: count = 0
        real(wp) :: amplitudes = 0.0_wp
        !> of the closed field
        type(half_space_rule_t), allocatable :: rule
    end type kept_waves_t

    !> Points whose sums must be found; `order` lists those of one prepared integral.
    type, extends(batch_t) :: points_t
        class(load_t), pointer :: load => null()
        type(half_space_rule_t), pointer :: rule => null()
        class(states_t), pointer :: states => null()
        type(depth_t), pointer :: depths(:) => null()
        !> distances from the axis [length] and [a]
        real(wp), pointer :: position(:) => null(), r(:) => null()
        !> (sum, point): of the load across the surface, then of the one along it
        real(wp), pointer :: sums(:, :) => null()
        !> of the half-space, (function, point), where the second load has those of the first one
        real(wp), pointer :: integrals(:, :) => null()
        logical, pointer :: is_known(:) => null()
        !> allocated for all points
        integer, allocatable :: order(:)
        !> what is added: the closed field, or these integrals
        logical :: is_closed = .false.
        type(part_t), allocatable :: parts(:)
    contains
        procedure :: work => points_work
    end type points_t

contains

    !> The field at points (r, z, angle); a grid of few distinct r and z costs far less than as many scattered points.
    !>
    !> Stresses are infinite where the load is singular on the surface: edge of a flat punch or of an adhesive contact, apex of
    !> a cone, edge of a flat end. With friction so are the shear tractions. Signs are those inside the contact. What jumps there
    !> has the value just below the surface, halfway: s_rt at the edge of a flat end.
    subroutine interior_field(load, layers, r, z, below, field, error, friction, angle, threads, kept, opposite)
        class(load_t), intent(in), target :: load
        type(layers_t), intent(in) :: layers
        !> distance from the axis r >= 0 and depth z >= 0 [length]
        real(wp), intent(in), target :: r(:)
        real(wp), intent(in) :: z(:)
        !> which side of an interface is meant
        logical, intent(in) :: below
        !> (size(r), components) [length] and [modulus]
        real(wp), intent(out) :: field(:, :)
        type(error_t), allocatable, intent(out) :: error
        !> traction friction*p(r) in +x on the surface, and azimuth of the points from +x [radian]
        real(wp), intent(in) :: friction, angle(:)
        !> how many threads
        integer, intent(in) :: threads
        !> of earlier fields of this load and these layers
        type(kept_waves_t), intent(inout), target, optional :: kept
        !> like field, at angle + pi
        real(wp), intent(out), optional :: opposite(:, :)
        type(depth_t), allocatable, target :: depths(:)
        type(layer_states_t), target :: states
        type(lattice_t) :: lattice
        integer :: stat

        call check_points(load, layers, r, z, below, error)
        if (allocated(error) .or. size(r) == 0) return
        call new_layer_states(states, layers, load%radius, error)
        if (allocated(error)) return
        allocate (depths(size(r)), stat=stat)
        call check_memory(error, stat)
        call new_lattice(lattice, r, z, error)
        if (allocated(error)) return
        call set_depths(load, layers, r, z, below, lattice%is_grid, present(kept), depths, error)
        if (allocated(error)) return
        call state_field(load, states, lattice, r, z, depths, field, error, friction, angle, threads, kept, opposite)
    end subroutine interior_field

    !> The field of a body whose states are known, at points with what is known of their depths; see interior_field.
    subroutine state_field(load, states, lattice, r, z, depths, field, error, friction, angle, threads, kept, opposite)
        class(load_t), intent(in), target :: load
        class(states_t), intent(inout), target :: states
        type(lattice_t), intent(in) :: lattice
        real(wp), intent(in), target :: r(:)
        real(wp), intent(in) :: z(:)
        type(depth_t), intent(inout), target :: depths(:)
        real(wp), intent(out) :: field(:, :)
        type(error_t), allocatable, intent(inout) :: error
        real(wp), intent(in) :: friction, angle(:)
        integer, intent(in) :: threads
        type(kept_waves_t), intent(inout), target, optional :: kept
        real(wp), intent(out), optional :: opposite(:, :)
        type(points_t) :: points
        real(wp), allocatable, target :: radii(:), sums(:, :), integrals(:, :)
        logical, allocatable, target :: is_known(:)
        type(half_space_rule_t), target :: rule
        integer :: i, stat

        allocate (radii(size(r)), sums(merge(normal_sums + shear_sums, normal_sums, friction /= 0.0_wp), size(r)), stat=stat)
        call check_memory(error, stat)
        if (stat /= 0) return
        ! as both are targets, an assignment of arrays takes memory that may be refused
        do i = 1, size(r)
            radii(i) = r(i)/load%radius
        end do
        points%load => load
        points%states => states
        points%depths => depths
        points%position => r
        points%r => radii
        points%sums => sums
        if (friction /= 0.0_wp) then
            allocate (integrals(states%half_space%functions, size(r)), is_known(size(r)), stat=stat)
            call check_memory(error, stat)
            if (stat /= 0) return
            is_known(:) = .false.
            points%integrals => integrals
            points%is_known => is_known
        end if
        if (present(kept)) then
            if (.not. allocated(kept%rule)) call take_rule(kept%rule, load, error)
            points%rule => kept%rule
        else
            call new_half_space_rule(rule, load, error)
            points%rule => rule
        end if
        if (friction /= 0.0_wp .and. present(kept)) then
            call find_sums(points, [.false., .true.], lattice, threads, error, kept)
        else
            call find_sums(points, [.false.], lattice, threads, error, kept)
            if (friction /= 0.0_wp) call find_sums(points, [.true.], lattice, threads, error, kept)
        end if
        if (allocated(error)) return
        call normal_components(depths, radii, load%radius, sums(:normal_sums, :), field)
        if (present(opposite)) opposite = field
        if (friction /= 0.0_wp) then
            associate (shear => sums(normal_sums + 1:, :))
                call add_shear_components(depths, radii, load%radius, shear, friction, angle, field)
                if (present(opposite)) then
                    call add_shear_components(depths, radii, load%radius, shear, friction, angle + pi, opposite)
                end if
            end associate
        end if
        call mark_singular(load, states%half_space%singular, r, z, friction, angle, field)
        if (present(opposite)) call mark_singular(load, states%half_space%singular, r, z, friction, angle + pi, opposite)
    end subroutine state_field

    subroutine take_rule(rule, load, error)
        type(half_space_rule_t), allocatable, intent(out) :: rule
        class(load_t), intent(in) :: load
        type(error_t), allocatable, intent(inout) :: error

        allocate (rule)
        call new_half_space_rule(rule, load, error)
    end subroutine take_rule

    !> Refuses points outside the body or too far away.
    subroutine check_distances(load, r, z, error)
        class(load_t), intent(in) :: load
        real(wp), intent(in) :: r(:), z(:)
        type(error_t), allocatable, intent(inout) :: error
        integer :: i

        do i = 1, size(r)
            call check_not_negative(error, "r", r(i), i)
            call check_not_negative(error, "z", z(i), i)
            if (allocated(error)) return
            if (max(r(i), z(i)) > farthest_point*load%radius) then
                call raise(error, error_domain, " = "//to_text(r(i))//", "//to_text(z(i))//": stresses are available within "// &
                           "1e12 contact radii, a = "//to_text(load%radius), "r, z", i)
                return
            end if
        end do
    end subroutine check_distances

    subroutine check_points(load, layers, r, z, below, error)
        class(load_t), intent(in) :: load
        type(layers_t), intent(in) :: layers
        real(wp), intent(in) :: r(:), z(:)
        logical, intent(in) :: below
        type(error_t), allocatable, intent(inout) :: error
        integer :: i

        call check_distances(load, r, z, error)
        do i = 1, size(r)
            if (allocated(error)) return
            if (layers%layer_at(z(i), below) == 0) then
                call raise(error, error_domain, " = "//to_text(z(i))//": the rigid base begins at z = "// &
                           to_text(sum(layers%thickness))//". Use the side above for points on its surface", "z", i)
            end if
        end do
    end subroutine check_points

    subroutine set_depths(load, layers, r, z, below, is_grid, is_search, depths, error)
        class(load_t), intent(in) :: load
        type(layers_t), intent(in) :: layers
        real(wp), intent(in) :: r(:), z(:)
        logical, intent(in) :: below, is_grid, is_search
        !> same size as z
        type(depth_t), intent(inout) :: depths(:)
        type(error_t), allocatable, intent(inout) :: error
        type(depth_t), allocatable :: in_layer(:)
        integer :: i, stat

        allocate (in_layer(size(layers%thickness) + merge(0, 1, layers%rigid_base)), stat=stat)
        call check_memory(error, stat)
        if (stat /= 0) return
        do i = 1, size(in_layer)
            in_layer(i)%layer = i
            in_layer(i)%shear = layers%shear(1)
            in_layer(i)%constants = layers%constants(i, in_layer(i)%shear)
        end do
        do i = 1, size(z)
            depths(i) = in_layer(layers%layer_at(z(i), below))
            depths(i)%z = depth_of(load, r(i), z(i))
            depths(i)%less = depths(i)%layer == 1
            if (size(layers%thickness) == 0) cycle
            if (is_grid .and. layers%thickness(1) > thin*load%radius) then
                depths(i)%less = depths(i)%less .and. depths(i)%z < shared_from*layers%thickness(1)/load%radius
            end if
            depths(i)%last = last_wave(load, layers%decays_to(depths(i)%z*load%radius, depths(i)%less)/load%radius, is_search)
        end do
    end subroutine set_depths

    !> The largest wavenumber needed [1/a]. In searches, which see many waves, fewer of a smooth load: k p_hat falls as 1/k beside
    !> those of the contact, so that exp(-faded) is reached earlier by its logarithm.
    pure function last_wave(load, decay, is_search) result(last)
        class(load_t), intent(in) :: load
        !> the state falls as exp(-k decay) [a]
        real(wp), intent(in) :: decay
        logical, intent(in) :: is_search
        real(wp) :: last

        last = faded/decay
        if (is_search .and. load%edge == 0.0_wp .and. size(load%kinks) == 0) last = (faded - log(1.0_wp + last))/decay
    end function last_wave

    !> The depth where what is finite at a point is taken [a].
    pure function depth_of(load, r, z) result(depth)
        class(load_t), intent(in) :: load
        !> [length]
        real(wp), intent(in) :: r, z
        real(wp) :: depth

        depth = z/load%radius
        if (abs(infinite_pressure(load, r, z)) > 0.0_wp) depth = just_below
    end function depth_of

    !> The sums of all points, for a load across or along the surface, or for both. States that are kept allow both.
    subroutine find_sums(points, along_surface, lattice, threads, error, kept)
        type(points_t), intent(inout) :: points
        logical, intent(in) :: along_surface(:)
        type(lattice_t), intent(in) :: lattice
        integer, intent(in) :: threads
        type(error_t), allocatable, intent(inout) :: error
        type(kept_waves_t), intent(inout), target, optional :: kept
        logical, allocatable :: waiting(:), chosen(:)
        real(wp) :: reach
        integer :: i, n, stat

        if (allocated(error)) return
        n = size(points%r)
        allocate (waiting(n), chosen(n), stat=stat)
        if (stat == 0 .and. .not. allocated(points%order)) allocate (points%order(n), stat=stat)
        call check_memory(error, stat)
        if (stat /= 0) return
        points%is_short = .true.
        do i = 1, size(along_surface)
            call points%states%turn(along_surface(i), points%depths, error)
            if (allocated(error)) return
            points%sums(first_sum(points):last_sum(points), :) = 0.0_wp
            points%is_closed = .true.
            chosen(:) = points%depths%less
            call list_chosen(chosen, points%order, n)
            call run_batch(points, n, 32, 64, threads, error)
            if (allocated(error)) return
        end do
        if (.not. points%states%structure > 0.0_wp) return
        points%is_closed = .false.
        waiting(:) = .true.
        ! far points need more waves than near ones: each doubling of a + r has its own rule
        do while (any(waiting))
            reach = max(near, 2.0_wp*(1.0_wp + minval(points%r, mask=waiting)))
            if (present(kept)) reach = kept_reach(reach)
            chosen(:) = waiting .and. 1.0_wp + points%r <= reach
            waiting(:) = waiting .and. .not. chosen
            call list_chosen(chosen, points%order, n)
            call add_waves(points, along_surface, 1.0_wp + maxval(points%r, mask=chosen), &
                           maxval(points%depths%last, mask=chosen), lattice, n, threads, error, kept)
            if (allocated(error)) return
        end do
    end subroutine find_sums

    !> The first and the last sum of the load that is meant.
    pure function first_sum(points) result(number)
        class(points_t), intent(in) :: points
        integer :: number

        number = merge(normal_sums, 0, points%states%along_surface) + 1
    end function first_sum

    pure function last_sum(points) result(number)
        class(points_t), intent(in) :: points
        integer :: number

        number = merge(normal_sums + shear_sums, normal_sums, points%states%along_surface)
    end function last_sum

    !> Adds the Hankel integrals at the first n points in `order`: those of kept rules together, those of others part after part.
    subroutine add_waves(points, along_surface, farthest, last, lattice, n, threads, error, kept)
        type(points_t), intent(inout) :: points
        logical, intent(in) :: along_surface(:)
        !> largest a + r [a] and largest wavenumber [1/a]
        real(wp), intent(in) :: farthest, last
        type(lattice_t), intent(in) :: lattice
        integer, intent(in) :: n, threads
        type(error_t), allocatable, intent(inout) :: error
        type(kept_waves_t), intent(inout), target, optional :: kept
        type(kept_waves_t), allocatable, target :: own
        type(part_t) :: ready(size(along_surface)), part
        logical :: is_ready
        integer :: i, m

        if (.not. present(kept)) allocate (own)
        m = 0
        do i = 1, size(along_surface)
            points%states%along_surface = along_surface(i)
            part%before = first_sum(points) - 1
            is_ready = present(kept)
            if (present(kept)) then
                call find_waves(kept, points%load, points%states, farthest, last, part%hankel, is_ready, error)
            else
                call find_waves(own, points%load, points%states, farthest, last, part%hankel, is_ready, error)
            end if
            if (allocated(error)) return
            if (is_ready) then
                m = m + 1
                ready(m) = part
                cycle
            end if
            do while (part%hankel%next_part(error))
                call add_parts(points, [part], lattice, n, threads, error)
            end do
            if (allocated(error)) return
        end do
        if (m > 0) call add_parts(points, ready(:m), lattice, n, threads, error)
    end subroutine add_waves

    !> The kept rule that covers some points, or a new one.
    subroutine find_waves(kept, load, states, farthest, last, hankel, is_ready, error)
        type(kept_waves_t), intent(inout), target :: kept
        class(load_t), intent(in) :: load
        class(states_t), intent(inout), target :: states
        !> largest a + r [a] and largest wavenumber [1/a]
        real(wp), intent(in) :: farthest, last
        type(hankel_t), pointer, intent(out) :: hankel
        !> whether it may be kept; then whether it is, with all its nodes as one part
        logical, intent(inout) :: is_ready
        type(error_t), allocatable, intent(inout) :: error
        integer :: own, twin, i

        call find_kept(kept, states%along_surface, farthest, last, own)
        if (own > 0) then
            hankel => kept%waves(own)%hankel
            hankel%states => kept%waves(own)%states
            is_ready = .true.
            return
        end if
        is_ready = is_ready .and. kept%count < most_kept .and. states%steps <= most_kept_steps
        associate (waves => kept%waves(kept%count + 1))
            hankel => kept%waves(kept%count + 1)%hankel
            waves%last = last
            waves%farthest = farthest
            if (is_ready) then
                waves%farthest = kept_reach(farthest)
                do i = 1, kept%count
                    if (kept%waves(i)%last <= most_waves*last) waves%last = max(waves%last, kept%waves(i)%last)
                end do
            end if
            call find_kept(kept, .not. states%along_surface, farthest, last, twin)
            if (is_ready .and. twin > 0) then
                waves%last = kept%waves(twin)%last
                waves%farthest = kept%waves(twin)%farthest
                call twin_hankel(hankel, states, kept%waves(twin)%hankel)
            else
                call new_hankel(hankel, load, states, waves%farthest, waves%last, error)
            end if
            if (allocated(error)) return
            associate (amplitudes => kept%amplitudes + real(size(hankel%all_k), wp)*real(states%steps, wp))
                is_ready = is_ready .and. amplitudes <= most_kept_amplitudes
                if (.not. is_ready) return
                kept%amplitudes = amplitudes
            end associate
            if (allocated(waves%states)) deallocate (waves%states)
            allocate (waves%states, source=states)
            hankel%states => kept%waves(kept%count + 1)%states
            if (.not. hankel%next_part(error)) return
        end associate
        kept%count = kept%count + 1
    end subroutine find_waves

    !> The reach of a rule that is kept.
    pure function kept_reach(farthest) result(reach)
        !> largest a + r at hand [a]
        real(wp), intent(in) :: farthest
        real(wp) :: reach

        reach = near_kept
        do while (reach < farthest)
            reach = 2.0_wp*reach
        end do
    end function kept_reach

    !> The rule that covers some points, for the load in one direction; 0: none.
    pure subroutine find_kept(kept, along_surface, farthest, last, which)
        type(kept_waves_t), intent(in) :: kept
        logical, intent(in) :: along_surface
        real(wp), intent(in) :: farthest, last
        integer, intent(out) :: which
        real(wp) :: reach
        integer :: i

        which = 0
        reach = kept_reach(farthest)
        do i = 1, kept%count
            associate (waves => kept%waves(i))
                if (waves%states%along_surface .neqv. along_surface) cycle
                if (waves%last >= last .and. waves%farthest <= reach .and. waves%farthest >= farthest) which = i
            end associate
        end do
    end subroutine find_kept

    !> Adds the integrals over a part of the wavenumbers to the sums of the first n points in `order`.
    subroutine add_parts(points, parts, lattice, n, threads, error)
        type(points_t), intent(inout) :: points
        type(part_t), intent(in) :: parts(:)
        type(lattice_t), intent(in) :: lattice
        integer, intent(in) :: n, threads
        type(error_t), allocatable, intent(inout) :: error

        if (lattice%is_grid) then
            call add_on_grid(parts, lattice, points%depths, points%r, points%order(:n), points%sums, threads, error)
        else
            points%parts = parts
            call run_batch(points, n, 16, 32, threads, error)
        end if
    end subroutine add_parts

    !> The places of the n chosen points come first in `order`.
    pure subroutine list_chosen(chosen, order, n)
        logical, intent(in) :: chosen(:)
        integer, intent(inout) :: order(:)
        integer, intent(out) :: n
        integer :: i

        n = 0
        do i = 1, size(chosen)
            if (.not. chosen(i)) cycle
            n = n + 1
            order(n) = i
        end do
    end subroutine list_chosen

    !> The Hankel integrals of chosen points by products of matrices over their distinct radii and depths.
    subroutine add_on_grid(parts, lattice, depths, r, order, sums, threads, error)
        type(part_t), intent(in) :: parts(:)
        type(lattice_t), intent(in) :: lattice
        type(depth_t), intent(in) :: depths(:)
        real(wp), intent(in) :: r(:)
        !> the points meant
        integer, intent(in) :: order(:)
        real(wp), intent(inout) :: sums(:, :)
        integer, intent(in) :: threads
        type(error_t), allocatable, intent(inout) :: error
        integer, allocatable :: first_r(:), first_z(:), row(:), column(:)
        type(depth_t), allocatable :: levels(:)
        real(wp), allocatable :: radii(:), table(:, :, :)
        integer :: i, stat

        call distinct_among(lattice%row, order, first_r, row, error)
        call distinct_among(lattice%column, order, first_z, column, error)
        if (allocated(error)) return
        allocate (levels(size(first_z)), radii(size(first_r)), table(size(first_r), size(sums, 1), size(first_z)), stat=stat)
        call check_memory(error, stat)
        if (stat /= 0) return
        table(:, :, :) = 0.0_wp
        do i = 1, size(first_z)
            levels(i) = depths(first_z(i))
        end do
        do i = 1, size(first_r)
            radii(i) = r(first_r(i))
        end do
        call add_grid(parts, levels, radii, table, threads, error)
        if (allocated(error)) return
        do i = 1, size(order)
            sums(:, order(i)) = sums(:, order(i)) + table(row(i), :, column(i))
        end do
    end subroutine add_on_grid

    subroutine points_work(self, first, last, error)
        class(points_t), intent(inout) :: self
        integer, intent(in) :: first, last
        type(error_t), allocatable, intent(out) :: error
        integer :: i, j, k

        do j = first, last
            i = self%order(j)
            if (self%is_closed) then
                call add_closed(self, i)
                cycle
            end if
            do k = 1, size(self%parts)
                associate (hankel => self%parts(k)%hankel, before => self%parts(k)%before)
                    if (hankel%states%along_surface) then
                        call add_point(hankel, self%depths(i), self%r(i), self%sums(before + 1:before + shear_sums, i))
                    else
                        call add_point(hankel, self%depths(i), self%r(i), self%sums(before + 1:before + normal_sums, i))
                    end if
                end associate
            end do
        end do
    end subroutine points_work

    !> The half-space of the surface material, and its images.
    pure subroutine add_closed(self, i)
        class(points_t), intent(inout) :: self
        integer, intent(in) :: i
        real(wp), allocatable :: integrals(:)
        logical :: shared, is_known

        associate (states => self%states, half_space => self%states%half_space, depth => self%depths(i), r => self%position(i))
            shared = associated(self%is_known)
            allocate (integrals(merge(half_space%functions, half_space%normal_functions, shared)))
            is_known = .false.
            if (shared) is_known = self%is_known(i)
            if (is_known) then
                integrals(:) = self%integrals(:, i)
            else
                call integrate(half_space, self%rule, self%load, r, depth%z, integrals)
                if (shared) then
                    self%integrals(:, i) = integrals
                    self%is_known(i) = .true.
                end if
            end if
            associate (sums => self%sums(first_sum(self):last_sum(self), i))
                if (states%along_surface) then
                    call half_space%add_shear(depth%z, integrals, sums)
                else
                    call half_space%add_normal(depth%z, integrals, sums)
                end if
                call states%add_images(self%rule, self%load, depth, r, sums)
            end associate
        end associate
    end subroutine add_closed

    pure subroutine normal_components(depths, r, unit, sums, field)
        type(depth_t), intent(in) :: depths(:)
        real(wp), intent(in) :: r(:), unit, sums(:, :)
        real(wp), intent(out) :: field(:, :)
        integer :: i

        field(:, [u_t, s_rt, s_tz]) = 0.0_wp
        do i = 1, size(r)
            associate (s => sums(:, i), mu => depths(i)%shear, h => depths(i)%constants%h, c => depths(i)%constants%c, &
                       c66 => depths(i)%constants%c66)
                field(i, u_z) = unit*s(1)/(2.0_wp*mu)
                field(i, u_r) = unit*r(i)*s(4)/(2.0_wp*mu)
                field(i, s_zz) = s(2)
                field(i, s_rr) = h*s(3) + c*s(2) - 2.0_wp*c66*s(4)
                field(i, s_tt) = (h - 2.0_wp*c66)*s(3) + c*s(2) + 2.0_wp*c66*s(4)
                field(i, s_rz) = r(i)*s(5)
            end associate
        end do
    end subroutine normal_components

    pure subroutine add_shear_components(depths, r, unit, sums, friction, angle, field)
        type(depth_t), intent(in) :: depths(:)
        real(wp), intent(in) :: r(:), unit, sums(:, :), friction, angle(:)
        real(wp), intent(inout) :: field(:, :)
        real(wp) :: along, across
        integer :: i

        do i = 1, size(r)
            along = friction*cos(angle(i))
            across = friction*sin(angle(i))
            associate (s => sums(:, i), mu => depths(i)%shear, h => depths(i)%constants%h, c => depths(i)%constants%c, &
                       c66 => depths(i)%constants%c66)
                field(i, u_r) = field(i, u_r) + along*unit*(s(1) + r(i)**2*s(7))/(4.0_wp*mu)
                field(i, u_t) = field(i, u_t) - across*unit*(s(1) - r(i)**2*s(7))/(4.0_wp*mu)
                field(i, u_z) = field(i, u_z) + along*unit*r(i)*s(3)/(2.0_wp*mu)
                field(i, s_rr) = field(i, s_rr) + along*r(i)*(h*s(5) + c*s(4) - 2.0_wp*c66*s(7))
                field(i, s_tt) = field(i, s_tt) + along*r(i)*((h - 2.0_wp*c66)*s(5) + c*s(4) + 2.0_wp*c66*s(7))
                field(i, s_zz) = field(i, s_zz) + along*r(i)*s(4)
                field(i, s_rz) = field(i, s_rz) + along*0.5_wp*(s(2) + s(8))
                field(i, s_rt) = field(i, s_rt) + across*r(i)*c66*(s(6) - 2.0_wp*s(7))
                field(i, s_tz) = field(i, s_tz) - across*0.5_wp*(s(2) - s(8))
            end associate
        end do
    end subroutine add_shear_components

    !> +-infinity where the pressure is infinite: on the surface at an edge with q(a), at the edge of a flat end, at an apex that is
    !> no sharper than a cone's; 0 elsewhere.
    pure function infinite_pressure(load, r, z) result(pressure)
        class(load_t), intent(in) :: load
        !> [length]
        real(wp), intent(in) :: r, z
        real(wp) :: pressure
        real(wp) :: slope(1)

        pressure = 0.0_wp
        if (z > 0.0_wp .or. r > load%radius) return
        if (r == load%radius) then
            slope = -load%edge
        else if (r <= 0.0_wp) then
            ! where q' does not vanish on the axis
            slope = 0.0_wp
            if (load%order_on_axis() < 1.0e-6_wp) slope = load%slope(0.0_wp, load%radius*[1.0e-11_wp])
        else
            if (.not. any(load%kinks == r)) return
            slope = load%slope(r, [0.0_wp])
            if (abs(slope(1)) <= huge(1.0_wp)) return
        end if
        if (abs(slope(1)) > 0.0_wp) pressure = -sign(infinity, slope(1))
    end function infinite_pressure

    !> Infinities where the pressure is infinite: the quadratures do not see them.
    pure subroutine mark_singular(load, ratio, r, z, friction, angle, field)
        class(load_t), intent(in) :: load
        !> see half_space_t
        real(wp), intent(in) :: ratio(3), r(:), z(:), friction, angle(:)
        real(wp), intent(inout) :: field(:, :)
        real(wp) :: pressure, part
        integer :: i, j

        do i = 1, size(r)
            pressure = infinite_pressure(load, r(i), z(i))
            if (.not. abs(pressure) > 0.0_wp) cycle
            field(i, s_zz) = -pressure
            do j = s_rr, s_tt
                part = ratio(merge(j - s_rr + 1, 3, r(i) > 0.0_wp))
                if (abs(part) > 0.0_wp) field(i, j) = -sign(1.0_wp, part)*pressure
            end do
            call mark_sliding(friction, angle(i), pressure, r(i) == load%radius, field(i, :))
        end do
    end subroutine mark_singular

    !> Contribution of friction where p is infinite: the traction -f p and, at the edge of the contact, s_rt, which is infinite
    !> outside. Across a logarithm of p it jumps, and keeps its value halfway.
    pure subroutine mark_sliding(friction, angle, pressure, at_edge, field)
        real(wp), intent(in) :: friction, angle
        !> +-infinity
        real(wp), intent(in) :: pressure
        logical, intent(in) :: at_edge
        real(wp), intent(inout) :: field(:)
        real(wp) :: along, across

        along = friction*nonzero(cos(angle))
        across = friction*nonzero(sin(angle))
        if (abs(along) > 0.0_wp) field(s_rz) = -along*pressure
        if (.not. abs(across) > 0.0_wp) return
        field(s_tz) = across*pressure
        if (at_edge) field(s_rt) = across*pressure

    contains

        !> 0 where a cosine or sine is only the rounding error of the angle.
        pure function nonzero(value) result(answer)
            real(wp), intent(in) :: value
            real(wp) :: answer

            answer = merge(0.0_wp, value, abs(value) <= 4.0_wp*epsilon(1.0_wp)*max(1.0_wp, abs(angle)))
        end function nonzero

    end subroutine mark_sliding

end module mdrcontact_inside_interior
