! SPDX-License-Identifier: GPL-3.0-or-later
!> A compiled contact law: F(d), a(d), k(d) and d(F), a(F), k(F) of one contact over a range of depths, for the price of a short
!> polynomial.
!>
!> It is made once from any contact and verified against it. Evaluating it allocates nothing and locks nothing; any number of
!> threads may share it. Unlike the contact it is made from, the law has an answer for separated bodies: force, radius, stiffness
!> and slope are 0 below initial contact, and with adhesion below pull-off (on loading: below the first attraction).
module mdrcontact_law
    use, intrinsic :: iso_c_binding, only: c_double
    use mdrcontact_nonfinite, only: is_finite, quiet_nan
    use mdrcontact_batch, only: check_threads
    use mdrcontact_contact, only: check_branch, on_loading, on_unloading
    use mdrcontact_error, only: check_finite, check_made, check_positive, check_same_size, count_text, error_domain, &
                                error_invalid, error_t, error_unreachable, raise, raise_at, to_text
    use mdrcontact_kinds, only: wp
    use mdrcontact_law_evaluate, only: count_within, energy_at, point_at, point_in, run_points, wanted_t
    use mdrcontact_law_friction, only: friction_law_t
    use mdrcontact_law_interval, only: interval_place, place_t, polynomial, polynomial_with_slope
    use mdrcontact_law_table, only: below_range, conductance_in, interval_for, interval_in, law_table_t, no_contact, scale_table, &
                                    segment_for, value_below, values_in
    implicit none (type, external)
    private
    public :: contact_law_t, law_point_t
    public :: check_points

    !> Largest power of two in with_radius, which avoids over- and underflow.
    integer, parameter :: largest_power = 500

    !> A state of the law; struct mdr_law_point of the header.
    type, bind(C) :: law_point_t
        !> d [length]
        real(c_double) :: depth = 0.0_c_double
        !> F [modulus length^2]
        real(c_double) :: force = 0.0_c_double
        !> dF/dd along the branch [modulus length]; infinite slopes at pull-off are cut off at a large number
        real(c_double) :: slope = 0.0_c_double
        !> a [length]
        real(c_double) :: radius = 0.0_c_double
        !> k = 2 a E_eff(a), the stiffness at constant radius [modulus length]; without adhesion it equals the slope
        real(c_double) :: stiffness = 0.0_c_double
        !> U = int F dd along the branch from initial contact on, without adhesion the elastic energy; with adhesion from pull-off
        !> on, with a cohesive stress from separated bodies [modulus length^3]
        real(c_double) :: energy = 0.0_c_double
        !> d minus the largest depth, where the law is continued along its tangent: the numbers are then no longer those of the
        !> contact; 0 within the range [length]
        real(c_double) :: beyond = 0.0_c_double
    end type law_point_t

    !> A compiled law. It never changes.
    type :: contact_law_t
        !> whether it was made: set last by what makes it
        logical :: is_made = .false.
        !> F, a, k from the depth, and d, a, k from the force; `lowest` and `highest` are the ends of the range
        type(law_table_t) :: by_depth, by_force
        !> the tolerance set, and the largest error found on verification
        real(wp) :: tolerance = 0.0_wp, error = 0.0_wp
        !> contact states computed to make and to verify it
        integer :: solutions = 0
        !> R of the paraboloid it was made for [length]; 0 for any other indenter
        real(wp) :: radius = 0.0_wp
        !> the problem as text, as given in the options
        character(len=:), allocatable :: description
        !> the sliders that T follows from; not allocated in a law without friction
        type(friction_law_t), allocatable :: friction
    contains
        procedure :: at_depth
        procedure :: at_force
        procedure :: follow
        procedure :: force
        procedure :: force_and_slope
        procedure :: energy
        procedure :: conductance
        procedure :: from_depths
        procedure :: from_forces
        procedure :: with_radius
    end type contact_law_t

contains

    !> The law of the same bodies for a paraboloid of another radius R. At a given contact radius depth and force are proportional
    !> to 1/R on any linear body, and the stiffness is the same: F(d; R) = (R0/R) F0(d R/R0), up to R0/R times the largest depth.
    !> The memory of a contact with friction belongs to one law: records of the other raise an error.
    subroutine with_radius(self, radius, law, error)
        class(contact_law_t), intent(in) :: self
        !> R > 0 [length]
        real(wp), intent(in) :: radius
        type(contact_law_t), intent(out) :: law
        type(error_t), allocatable, intent(out) :: error
        integer :: power

        if (.not. self%is_made) call check_made(error, "law", self%is_made)
        if (allocated(error)) return
        call check_positive(error, "radius", radius)
        if (allocated(error)) return
        if (self%by_depth%adhesive) then
            call raise(error, error_invalid, " = "//to_text(radius)//": a law with adhesion applies to other radii only at "// &
                       "constant work of adhesion times R^2. Create a law for each radius", "radius")
        else if (.not. self%radius > 0.0_wp) then
            call raise(error, error_invalid, " = "//to_text(radius)//": the law is not that of a paraboloid, or its file does "// &
                       "not contain the radius. Create a law for each indenter", "radius")
        else
            power = exponent(self%radius) - exponent(radius)
            if (min(power, power + exponent(min(self%by_depth%lowest, self%by_force%lowest))) < -largest_power .or. &
                max(power, power + exponent(max(self%by_depth%highest, self%by_force%highest))) > largest_power) then
                call raise(error, error_invalid, " = "//to_text(radius)//": it is too far from the radius of the law, "// &
                           to_text(self%radius), "radius")
            end if
        end if
        if (allocated(error)) return
        law = self
        law%radius = radius
        law%description = self%description//"; with_radius("//to_text(radius)//")"
        call scale_table(law%by_depth, self%radius/radius)
        call scale_table(law%by_force, self%radius/radius)
        if (allocated(law%friction)) call law%friction%scale(self%radius/radius)
    end subroutine with_radius

    !> The state at depth d; all but d is 0 for separated bodies.
    pure subroutine at_depth(self, depth, point, error, branch)
        class(contact_law_t), intent(in) :: self
        !> at most the largest depth, unless the law continues beyond; any value below [length]
        real(wp), intent(in) :: depth
        type(law_point_t), intent(out) :: point
        type(error_t), allocatable, intent(out) :: error
        !> on_loading or on_unloading (default)
        integer, intent(in), optional :: branch
        integer :: way, interval

        if (.not. self%is_made) call check_made(error, "law", self%is_made)
        if (allocated(error)) return
        way = on_unloading
        if (present(branch)) way = branch
        call check_branch(error, way)
        call check_point(error, self%by_depth, way, depth)
        if (allocated(error)) return
        interval = interval_for(self%by_depth, way, min(depth, self%by_depth%highest))
        point%depth = depth
        call point_in(self%by_depth, interval, depth, point%force, point%slope, point%radius, point%stiffness)
        call add_energy(self, interval, point)
    end subroutine at_depth

    !> The state under force F: there is one at every force down to 0, with adhesion down to pull-off on unloading.
    pure subroutine at_force(self, force, point, error, branch)
        class(contact_law_t), intent(in) :: self
        !> [modulus length^2]
        real(wp), intent(in) :: force
        type(law_point_t), intent(out) :: point
        type(error_t), allocatable, intent(out) :: error
        !> on_loading or on_unloading (default)
        integer, intent(in), optional :: branch
        real(wp) :: compliance
        integer :: way

        if (.not. self%is_made) call check_made(error, "law", self%is_made)
        if (allocated(error)) return
        way = on_unloading
        if (present(branch)) way = branch
        call check_branch(error, way)
        call check_point(error, self%by_force, way, force)
        if (allocated(error)) return
        point%force = force
        call point_at(self%by_force, way, force, point%depth, compliance, point%radius, point%stiffness)
        if (compliance > 0.0_wp) point%slope = 1.0_wp/compliance
        call add_energy(self, interval_at_radius(self%by_depth, point), point)
    end subroutine at_force

    !> Energy, and distance beyond the range, of a state on an interval of the depths.
    pure subroutine add_energy(self, interval, point)
        type(contact_law_t), intent(in) :: self
        integer, intent(in) :: interval
        type(law_point_t), intent(inout) :: point

        point%energy = energy_at(self%by_depth, interval, point%depth)
        point%beyond = max(point%depth - self%by_depth%highest, 0.0_wp)
    end subroutine add_energy

    !> The interval of the depths on which a state lies: of several at its depth the one with its contact radius.
    pure function interval_at_radius(table, point) result(interval)
        type(law_table_t), intent(in) :: table
        type(law_point_t), intent(in) :: point
        integer :: interval
        real(wp) :: unused(2), depth, radius, stiffness, nearest
        integer :: i, candidate

        ! rounding may put a state at an end of the range a little outside
        depth = min(max(point%depth, table%lowest), table%highest)
        interval = no_contact
        if (.not. table%adhesive) interval = interval_for(table, on_unloading, min(point%depth, table%highest))
        if (.not. table%adhesive .or. point%radius <= 0.0_wp) return
        nearest = huge(1.0_wp)
        do i = 1, size(table%segments)
            if (depth < table%segments(i)%lowest .or. depth > table%segments(i)%highest) cycle
            candidate = interval_in(table, i, depth)
            call values_in(table, candidate, depth, unused(1), unused(2), radius, stiffness)
            if (abs(radius - point%radius) > nearest) cycle
            nearest = abs(radius - point%radius)
            interval = candidate
        end do
    end function interval_at_radius

    !> F at depth d, for inner loops and arrays: as at_depth, but NaN where that has an error.
    elemental function force(self, depth, branch) result(value)
        class(contact_law_t), intent(in) :: self
        !> [length]
        real(wp), intent(in) :: depth
        !> on_loading or on_unloading (default)
        integer, intent(in), optional :: branch
        real(wp) :: value
        type(place_t) :: place
        real(wp) :: unused

        if (depth >= self%by_depth%direct%lowest .and. depth <= self%by_depth%direct%highest) then
            place = interval_place(self%by_depth%direct, depth)
            value = polynomial(self%by_depth%other(place%panel)%c, place%t)
        else
            call force_elsewhere(self, depth, branch, value, unused)
        end if
    end function force

    !> F and dF/dd at depth d, for inner loops and arrays: as at_depth, but NaN where that has an error.
    elemental subroutine force_and_slope(self, depth, force, slope, branch)
        class(contact_law_t), intent(in) :: self
        !> [length]
        real(wp), intent(in) :: depth
        !> [modulus length^2], [modulus length]
        real(wp), intent(out) :: force, slope
        !> on_loading or on_unloading (default)
        integer, intent(in), optional :: branch
        type(place_t) :: place

        if (depth >= self%by_depth%direct%lowest .and. depth <= self%by_depth%direct%highest) then
            place = interval_place(self%by_depth%direct, depth)
            call polynomial_with_slope(self%by_depth%other(place%panel)%c, place%t, force, slope)
            slope = self%by_depth%direct%scale*slope
        else
            call force_elsewhere(self, depth, branch, force, slope)
        end if
    end subroutine force_and_slope

    !> U = int F dd at depth d, as in law_point_t; NaN where at_depth has an error.
    elemental function energy(self, depth, branch) result(value)
        class(contact_law_t), intent(in) :: self
        !> [length]
        real(wp), intent(in) :: depth
        !> on_loading or on_unloading (default)
        integer, intent(in), optional :: branch
        !> [modulus length^3]
        real(wp) :: value
        type(law_point_t) :: point
        type(error_t), allocatable :: error

        call self%at_depth(depth, point, error, branch)
        value = point%energy
        if (allocated(error)) value = quiet_nan
    end function energy

    !> G at depth d of a law that conducts, and its slope along the branch: 0 for separated bodies, beyond the range G at its end;
    !> NaN where at_depth has an error.
    elemental subroutine conductance(self, depth, value, slope, branch)
        class(contact_law_t), intent(in) :: self
        !> [length]
        real(wp), intent(in) :: depth
        !> [conductance], [conductance/length]
        real(wp), intent(out) :: value, slope
        !> on_loading or on_unloading (default)
        integer, intent(in), optional :: branch
        type(error_t), allocatable :: error
        integer :: way, interval

        way = on_unloading
        if (present(branch)) way = branch
        call check_branch(error, way)
        call check_point(error, self%by_depth, way, depth)
        value = quiet_nan
        slope = value
        if (allocated(error) .or. .not. allocated(self%by_depth%conductance)) return
        value = 0.0_wp
        slope = 0.0_wp
        interval = interval_for(self%by_depth, way, min(depth, self%by_depth%highest))
        if (interval == no_contact) return
        call conductance_in(self%by_depth, interval, min(depth, self%by_depth%highest), value, slope)
        if (depth > self%by_depth%highest) slope = 0.0_wp
    end subroutine conductance

    pure subroutine force_elsewhere(self, depth, branch, force, slope)
        class(contact_law_t), intent(in) :: self
        real(wp), intent(in) :: depth
        integer, intent(in), optional :: branch
        real(wp), intent(out) :: force, slope
        real(wp) :: radius, stiffness
        type(error_t), allocatable :: error
        integer :: way

        force = quiet_nan
        slope = force
        if (.not. self%is_made) return
        way = on_unloading
        if (present(branch)) way = branch
        ! without adhesion both branches are one
        if (.not. self%by_depth%adhesive .and. depth < self%by_depth%lowest .and. is_finite(depth) .and. &
            (way == on_unloading .or. way == on_loading)) then
            force = 0.0_wp
            slope = 0.0_wp
            if (depth > 0.0_wp) call value_below(self%by_depth, depth, force, slope)
            return
        end if
        call check_branch(error, way)
        call check_point(error, self%by_depth, way, depth)
        if (.not. allocated(error)) call point_at(self%by_depth, way, depth, force, slope, radius, stiffness)
    end subroutine force_elsewhere

    !> The states at many depths: at_depth for arrays. If one fails, the error is that of the first, and nothing is written.
    subroutine from_depths(self, depths, error, force, slope, radius, stiffness, branch, threads)
        class(contact_law_t), intent(in) :: self
        !> [length]
        real(wp), intent(in), contiguous :: depths(:)
        type(error_t), allocatable, intent(out) :: error
        !> same size as depths: F [modulus length^2], dF/dd [modulus length], a [length], k [modulus length]; what is not given is
        !> not computed
        real(wp), intent(inout), optional, target, contiguous :: force(:), slope(:), radius(:), stiffness(:)
        !> on_loading or on_unloading (default)
        integer, intent(in), optional :: branch
        !> at least 1 (default), or 0 for as many as OpenMP offers; few points stay on one
        integer, intent(in), optional :: threads
        type(wanted_t) :: wanted

        if (.not. self%is_made) call check_made(error, "law", self%is_made)
        if (allocated(error)) return
        if (present(force)) wanted%other => force
        if (present(slope)) wanted%slope => slope
        if (present(radius)) wanted%radius => radius
        if (present(stiffness)) wanted%stiffness => stiffness
        call write_points(self%by_depth, depths, wanted, error, branch, threads)
    end subroutine from_depths

    !> The states under many forces: at_force for arrays, as from_depths.
    subroutine from_forces(self, forces, error, depth, compliance, radius, stiffness, branch, threads)
        class(contact_law_t), intent(in) :: self
        !> [modulus length^2]
        real(wp), intent(in), contiguous :: forces(:)
        type(error_t), allocatable, intent(out) :: error
        !> same size as forces: d [length], dd/dF [1/(modulus length)], a [length], k [modulus length]; what is not given is not
        !> computed
        real(wp), intent(inout), optional, target, contiguous :: depth(:), compliance(:), radius(:), stiffness(:)
        !> on_loading or on_unloading (default)
        integer, intent(in), optional :: branch
        !> at least 1 (default), or 0 for as many as OpenMP offers; few points stay on one
        integer, intent(in), optional :: threads
        type(wanted_t) :: wanted

        if (.not. self%is_made) call check_made(error, "law", self%is_made)
        if (allocated(error)) return
        if (present(depth)) wanted%other => depth
        if (present(compliance)) wanted%slope => compliance
        if (present(radius)) wanted%radius => radius
        if (present(stiffness)) wanted%stiffness => stiffness
        call write_points(self%by_force, forces, wanted, error, branch, threads)
    end subroutine from_forces

    !> Requested quantities of the states at many s; nothing is written if one of them fails.
    subroutine write_points(table, s, wanted, error, branch, threads)
        type(law_table_t), intent(in) :: table
        real(wp), intent(in), contiguous :: s(:)
        type(wanted_t), intent(in) :: wanted
        type(error_t), allocatable, intent(inout) :: error
        integer, intent(in), optional :: branch, threads
        integer :: way, team
        logical :: all_direct

        way = on_unloading
        if (present(branch)) way = branch
        team = 1
        if (present(threads)) team = threads
        call check_branch(error, way)
        call check_threads(error, team)
        call check_size(error, size(s), wanted%other)
        call check_size(error, size(s), wanted%slope)
        call check_size(error, size(s), wanted%radius)
        call check_size(error, size(s), wanted%stiffness)
        all_direct = count_within(s, table%direct%lowest, table%direct%highest) == size(s)
        if (.not. all_direct) call check_points(error, table, way, s)
        if (allocated(error)) return
        call run_points(table, way, s, all_direct, team, wanted)
    end subroutine write_points

    subroutine check_size(error, n, array)
        type(error_t), allocatable, intent(inout) :: error
        integer, intent(in) :: n
        real(wp), pointer, intent(in) :: array(:)

        if (associated(array)) call check_same_size(error, n, size(array))
    end subroutine check_size

    !> The state at depth d of a contact with a history: it stays on its segment until that ends, and then falls open or onto the
    !> nearest one. Open bodies come into contact at the first attraction.
    pure subroutine follow(self, depth, segment, point, error)
        class(contact_law_t), intent(in) :: self
        !> at most the largest depth, unless the law continues beyond; any value below [length]
        real(wp), intent(in) :: depth
        !> where the contact is: 0 for open at the beginning, then what the last call returned
        integer, intent(inout) :: segment
        type(law_point_t), intent(out) :: point
        type(error_t), allocatable, intent(out) :: error
        real(wp) :: within
        integer :: interval

        if (.not. self%is_made) call check_made(error, "law", self%is_made)
        if (allocated(error)) return
        if (segment < 0 .or. segment > size(self%by_depth%segments)) then
            call raise(error, error_invalid, "segment = "//count_text(segment)//": it must be 0 (open) or the value of the "// &
                       "last call")
        end if
        call check_point(error, self%by_depth, on_unloading, depth)
        if (allocated(error)) return
        within = min(depth, self%by_depth%highest)
        call move_segment(self%by_depth, within, segment)
        point%depth = depth
        if (segment == 0) return
        interval = below_range
        if (within >= self%by_depth%lowest) interval = interval_in(self%by_depth, segment, within)
        call point_in(self%by_depth, interval, depth, point%force, point%slope, point%radius, point%stiffness)
        call add_energy(self, interval, point)
    end subroutine follow

    pure subroutine move_segment(table, depth, segment)
        type(law_table_t), intent(in) :: table
        real(wp), intent(in) :: depth
        integer, intent(inout) :: segment

        if (.not. table%adhesive) then
            segment = merge(1, 0, depth > 0.0_wp)
        else if (segment == 0) then
            segment = segment_for(table, on_loading, depth)
        else if (depth > table%segments(segment)%highest) then
            if (segment == size(table%segments)) return
            do segment = segment + 1, size(table%segments) - 1
                if (depth >= table%segments(segment)%lowest .and. depth <= table%segments(segment)%highest) exit
            end do
        else if (depth < table%segments(segment)%lowest) then
            do segment = segment - 1, 1, -1
                if (depth >= table%segments(segment)%lowest .and. depth <= table%segments(segment)%highest) exit
            end do
        end if
    end subroutine move_segment

    !> Raises unless a branch has a state at each s.
    pure subroutine check_points(error, table, branch, s)
        type(error_t), allocatable, intent(inout) :: error
        type(law_table_t), intent(in) :: table
        integer, intent(in) :: branch
        real(wp), intent(in) :: s(:)
        integer :: i

        if (allocated(error)) return
        do i = 1, size(s)
            call check_point(error, table, branch, s(i))
            if (.not. allocated(error)) cycle
            call raise_at(error, i)
            return
        end do
    end subroutine check_points

    !> Raises unless s is finite, at most the end of the compiled range unless the table is continued, and a force that the branch
    !> can carry.
    pure subroutine check_point(error, table, branch, s)
        type(error_t), allocatable, intent(inout) :: error
        type(law_table_t), intent(in) :: table
        integer, intent(in) :: branch
        real(wp), intent(in) :: s
        real(wp) :: lowest

        ! a comparison with NaN would signal an invalid operation
        if (.not. is_finite(s)) then
            call check_finite(error, name_of(table), s)
        else if (s > table%highest) then
            if (.not. table%continued) call raise(error, error_domain, " = "//to_text(s)//": the law is compiled up to "// &
                                                  to_text(table%highest), name_of(table))
        else if (.not. table%by_depth) then
            lowest = 0.0_wp
            if (table%adhesive .and. branch == on_unloading) lowest = table%lowest
            if (s < lowest) call raise(error, error_unreachable, " = "//to_text(s)//": the lowest force of a contact is "// &
                                       to_text(lowest), name_of(table))
        end if
    end subroutine check_point

    pure function name_of(table) result(name)
        type(law_table_t), intent(in) :: table
        character(len=5) :: name

        name = merge("depth", "force", table%by_depth)
    end function name_of

end module mdrcontact_law
