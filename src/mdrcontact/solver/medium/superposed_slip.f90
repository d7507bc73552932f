! SPDX-License-Identifier: GPL-3.0-or-later
!> First shear of media with effective moduli: each increment of depth adds a flat punch's pressure, each increment of the shift a
!> flat punch's shear, both with the modulus that belongs to their radius (theory/friction.md (4.3)).
!>
!>     eta(c) = (E_eff/G_t)(c) d'(c),    T(c) = F(a) - F(c),    q_t(x) = q(max(x, c)),    tau(r) = p(r; a) - p(r; c)
!> (mu = 1). On a homogeneous body these are exact: s = (E*/G*) [d - g(c)] (Ciavarella, Int. J. Solids Struct. 35 (1998) 2349;
!> Jaeger, Arch. Appl. Mech. 65 (1995) 478).
module mdrcontact_medium_superposed_slip
    use mdrcontact_error, only: check_memory, error_t
    use mdrcontact_medium_slip, only: beside, slip_t
    use mdrcontact_kinds, only: wp
    use mdrcontact_medium_load, only: load_t
    use mdrcontact_medium_solver, only: copy, depth_and_force, solver_t
    use mdrcontact_numerics_pick, only: pick
    use mdrcontact_numerics_quadrature, only: graded_edges, mark_breaks, smallest_panel_ratio
    use mdrcontact_profile, only: copy, profile_t
    implicit none (type, external)
    private
    public :: superposed_slip_t, new_superposed_slip, traction_between

    !> Nodes in a panel: a singularity lies at least a third of its length away, where they give rounding.
    integer, parameter :: nodes = 16

    !> One normal state and the media that respond to its parts.
    type, extends(slip_t) :: superposed_slip_t
        private
        class(solver_t), allocatable :: normal, tangential
        class(profile_t), allocatable :: profile
        real(wp), allocatable :: breaks(:)
        !> depth beyond the non-adhesive one [length]
        real(wp) :: punch_depth = 0.0_wp
    contains
        procedure :: rates
        procedure :: panels
        procedure :: at
        procedure :: line_load
        procedure :: traction
    end type superposed_slip_t

contains

    !> The state of contact radius a under a profile.
    subroutine new_superposed_slip(self, normal, tangential, profile, a, punch_depth, error)
        type(superposed_slip_t), intent(out) :: self
        !> with effective moduli E_eff and G_t, whose depth is that of the profile
        class(solver_t), intent(in) :: normal, tangential
        class(profile_t), intent(in) :: profile
        !> [length]
        real(wp), intent(in) :: a, punch_depth
        type(error_t), allocatable, intent(out) :: error
        real(wp) :: depth, modulus(1), shear(1), dissipated, tangential_force, lowest

        call copy(normal, self%normal, error)
        if (.not. allocated(error)) call copy(tangential, self%tangential, error)
        if (.not. allocated(error)) call copy(profile, self%profile, error)
        call profile%add_breaks(self%breaks, error)
        call normal%add_breaks(self%breaks, error)
        if (allocated(error)) return
        self%radius = a
        self%punch_depth = punch_depth
        self%smallest_stick = profile%end_radius
        self%nodes = nodes
        call depth_and_force(normal, profile, a, depth, self%force, error)
        if (.not. allocated(error)) call normal%modulus([a], modulus, error)
        if (.not. allocated(error)) call tangential%modulus([a], shear, error)
        if (allocated(error)) return
        self%force = self%force + 2.0_wp*a*modulus(1)*punch_depth
        self%first_shift = modulus(1)/shear(1)*punch_depth
        self%stiffness = 2.0_wp*a*shear(1)
        lowest = max(self%smallest_stick, smallest_panel_ratio*a)
        self%sliding_shift = self%first_shift
        if (.not. a > lowest) return
        call self%integrate(lowest, a - lowest, self%sliding_shift, tangential_force, dissipated, error)
        if (allocated(error) .or. self%smallest_stick > 0.0_wp) return
        ! below, the moduli are those of the surface
        call normal%modulus([lowest], modulus, error)
        if (.not. allocated(error)) call tangential%modulus([lowest], shear, error)
        self%sliding_shift = self%sliding_shift + modulus(1)/shear(1)*profile%mdr(lowest)
    end subroutine new_superposed_slip

    subroutine rates(self, c, shift, shift_rate, stiffness, stiffness_slope, error)
        class(superposed_slip_t), intent(in) :: self
        real(wp), intent(in) :: c(:)
        real(wp), intent(out) :: shift(:), shift_rate(:), stiffness(:), stiffness_slope(:)
        type(error_t), allocatable, intent(out) :: error
        real(wp), dimension(size(c)) :: modulus, shear, slope

        call self%normal%modulus(c, modulus, error)
        if (.not. allocated(error)) call self%tangential%modulus(c, shear, error, slope)
        if (allocated(error)) return
        shift = 0.0_wp
        shift_rate = modulus/shear*self%profile%mdr_slope(c)
        stiffness = 2.0_wp*c*shear
        stiffness_slope = 2.0_wp*(shear + c*slope)
    end subroutine rates

    subroutine panels(self, c, edges, has_root, error)
        class(superposed_slip_t), intent(in) :: self
        real(wp), intent(in) :: c
        real(wp), allocatable, intent(out) :: edges(:)
        logical, allocatable, intent(out) :: has_root(:)
        type(error_t), allocatable, intent(inout) :: error

        call graded_edges(max(c, smallest_panel_ratio*self%radius), self%radius, self%breaks, self%profile%singular_radius, &
                          edges, error)
        call mark_breaks(edges, self%breaks, has_root, error)
    end subroutine panels

    subroutine at(self, c, width, shift, force, stiffness, shift_rate, error)
        class(superposed_slip_t), intent(in) :: self
        real(wp), intent(in) :: c, width
        real(wp), intent(out) :: shift, force, stiffness, shift_rate
        type(error_t), allocatable, intent(out) :: error
        real(wp) :: dissipated, known(1), rate(1), k(1), slope(1)

        call self%integrate(c, width, shift, force, dissipated, error)
        if (.not. allocated(error)) call self%rates([max(c, smallest_panel_ratio*self%radius)], known, rate, k, slope, error)
        if (allocated(error)) return
        shift_rate = rate(1)
        stiffness = k(1)
    end subroutine at

    subroutine line_load(self, c, r, values, error)
        class(superposed_slip_t), intent(in), target :: self
        real(wp), intent(in) :: c
        real(wp), intent(in) :: r(:)
        real(wp), intent(out) :: values(:)
        type(error_t), allocatable, intent(out) :: error
        class(load_t), allocatable :: pressed
        real(wp), allocatable :: slipping(:)
        integer :: stat

        allocate (slipping(size(r)), stat=stat)
        call check_memory(error, stat)
        if (allocated(error)) return
        slipping(:) = max(r, c)
        call self%normal%load(self%profile, self%radius, self%punch_depth, pressed, error)
        if (.not. allocated(error)) call pressed%line_load(slipping, values, error)
    end subroutine line_load

    subroutine traction(self, c, r, values, error)
        class(superposed_slip_t), intent(in), target :: self
        real(wp), intent(in) :: c
        real(wp), intent(in) :: r(:)
        real(wp), intent(out) :: values(:)
        type(error_t), allocatable, intent(out) :: error
        class(load_t), allocatable :: pressed

        call self%normal%load(self%profile, self%radius, self%punch_depth, pressed, error)
        if (.not. allocated(error)) call traction_between(pressed, self%normal, self%profile, c, r, values, error)
    end subroutine traction

    !> p of a load less p of a contact of radius c without adhesion, at positions up to the radius of the load.
    subroutine traction_between(whole, stick, of_stick, c, r, values, error)
        class(load_t), intent(in) :: whole
        !> the medium of the stick zone and the profile on it
        class(solver_t), intent(in), target :: stick
        class(profile_t), intent(in), target :: of_stick
        !> stick radius [length]
        real(wp), intent(in) :: c
        real(wp), intent(in) :: r(:)
        !> same size as r [modulus]
        real(wp), intent(out) :: values(:)
        type(error_t), allocatable, intent(out) :: error
        class(load_t), allocatable :: stuck
        real(wp), allocatable :: near(:), inside(:), inner(:)
        integer, allocatable :: places(:)
        integer :: i, stat

        allocate (near(size(r)), stat=stat)
        call check_memory(error, stat)
        call pick(r, places, inside, inner, error, below=c)
        if (allocated(error)) return
        near(:) = beside(r, c, whole%profile%end_radius)
        call whole%pressure(near, values, error)
        if (allocated(error) .or. size(places) == 0) return
        inside(:) = beside(inside, c, whole%profile%end_radius)
        call stick%load(of_stick, c, 0.0_wp, stuck, error)
        if (.not. allocated(error)) call stuck%pressure(inside, inner, error)
        if (allocated(error)) return
        do i = 1, size(places)
            values(places(i)) = values(places(i)) - inner(i)
        end do
    end subroutine traction_between

end module mdrcontact_medium_superposed_slip
