! SPDX-License-Identifier: GPL-3.0-or-later
!> The equilibria of a contact, sampled once over the contact radius and then evaluated and inverted for the price of a short
!> polynomial: F(d) for the adhesive branch, the law and the fit.
!>
!> The radius is the natural parameter: one solution gives depth, force and stiffness, none of them by iteration. What is
!> interpolated are the logarithms of d0, F0, k and, with adhesion, dl over x = ln(a - end radius), where every shape and medium is
!> close to a straight line (theory/paper.md (4.1), (5.1)): d = d0 - dl, F = F0 - k dl.
module mdrcontact_contact_curve
    use mdrcontact_contact_control, only: control_t, depth_control
    use mdrcontact_contact_coordinate, only: coordinate_t
    use mdrcontact_contact_equilibrium, only: equilibrium_t
    use mdrcontact_contact_samples, only: curve_point_t, rows, samples_t
    use mdrcontact_contact_state, only: contact_state_t
    use mdrcontact_error, only: error_no_convergence, error_t, raise, to_text
    use mdrcontact_kinds, only: wp
    use mdrcontact_medium_solver, only: solver_t
    use mdrcontact_numerics_chebyshev, only: node, nodes => terms, series_of_values
    use mdrcontact_numerics_quadrature, only: gauss_legendre
    use mdrcontact_numerics_sampled_columns, only: new_columns
    use mdrcontact_numerics_sampler, only: column_source_t, sampling_t
    implicit none (type, external)
    private
    public :: curve_t, curve_point_t, new_curve

    !> The length in ln a of a panel for which its terms usually suffice.
    real(wp), parameter :: usual_length = 1.6_wp
    !> ln dl may jump by this from one panel to the next.
    real(wp), parameter :: largest_kink = 1.0e-5_wp
    !> Panels shorter than this enclose a kink.
    real(wp), parameter :: enclosing = 1.0e-6_wp
    !> Close to a panel's left edge, in its variable.
    real(wp), parameter :: beside = -0.9_wp
    !> Nodes between two of a panel for the integral of 1/k.
    integer, parameter :: shift_nodes = 20
    !> Which column is ln d0, ln F0, ln k, ln dl.
    integer, parameter :: of_depth = 1, of_force = 2, of_stiffness = 3, of_excess = 4

    !> The sampled equilibria.
    type, extends(samples_t) :: curve_t
        !> of contact radii
        type(coordinate_t) :: coordinate
        logical :: adhesive = .false.
    contains
        procedure :: point_of
        procedure :: control_of
        procedure :: state_at
        procedure :: parts
        procedure :: shear
    end type curve_t

    !> The columns of an equilibrium.
    type, extends(column_source_t) :: parts_t
        type(equilibrium_t), pointer :: equilibrium => null()
    contains
        procedure :: sample
        procedure :: radius
        procedure :: attainable
    end type parts_t

contains

    !> Samples the states between the first and the last of some coordinates.
    subroutine new_curve(self, equilibrium, coordinates, tolerance, error, largest_noise)
        type(curve_t), intent(out) :: self
        type(equilibrium_t), intent(in), target :: equilibrium
        !> ascending; at the inner ones indenter or medium are not analytic
        real(wp), intent(in) :: coordinates(:)
        !> relative, of the interpolated quantities
        real(wp), intent(in) :: tolerance
        type(error_t), allocatable, intent(out) :: error
        !> relative noise of the equilibria up to which a panel is accepted though it misses the tolerance, by a caller that
        !> compares the result with the contact itself; default: the roughness of medium and zeta, 0 where they are computed
        real(wp), intent(in), optional :: largest_noise
        type(parts_t) :: source
        type(sampling_t) :: sampling

        self%coordinate = equilibrium%coordinate()
        self%adhesive = equilibrium%work_of_adhesion > 0.0_wp
        self%follows_powers = .true.
        sampling = sampling_t(tolerance, equilibrium%roughness, usual_length)
        if (present(largest_noise)) sampling%noise = largest_noise
        source%equilibrium => equilibrium
        ! the slope of k, on which dl depends, may jump at a break
        source%continuous = of_stiffness
        ! where states are solved for, slopes come with them
        source%has_slopes = .not. (self%adhesive .or. equilibrium%medium%is_modulus_formula)
        call new_columns(self, source, coordinates, coordinates(2:), sampling, error)
        if (.not. allocated(error)) call self%prepare(error)
        if (.not. allocated(error)) call check_kinks(self, error)
    end subroutine new_curve

    !> Where the slope of k jumps, so does dl: the edge of the contact rests there while depth and force change, and states of one
    !> radius are many. That is harmless only where all states around are unstable under any control.
    subroutine check_kinks(self, error)
        type(curve_t), intent(in) :: self
        type(error_t), allocatable, intent(inout) :: error
        real(wp), dimension(rows) :: left, right, dv
        type(curve_point_t) :: below, above
        real(wp) :: unused, slopes(2)
        integer :: i, before

        before = 1
        do i = 2, size(self%from_root)
            if (self%edges(i + 1) - self%edges(i) < enclosing) cycle
            call self%in_panel(before, 1.0_wp, left, dv)
            call self%control_of(depth_control, left, dv, unused, slopes(1))
            call self%in_panel(i, -1.0_wp, right, dv)
            before = i
            if (.not. abs(right(of_excess) - left(of_excess)) > largest_kink) cycle
            below = self%point_of(self%edges(i), left)
            above = self%point_of(self%edges(i), right)
            ! a panel from a break on has no slope there
            call self%in_panel(i, beside, right, dv)
            call self%control_of(depth_control, right, dv, unused, slopes(2))
            if (above%depth < below%depth .and. all(slopes < 0.0_wp)) cycle
            call raise(error, error_no_convergence, "the contact modulus has a kink at radius = "// &
                       to_text(self%coordinate%radius(self%edges(i)))//": by the energy balance the contact edge rests there "// &
                       "while depth and force change. Smooth the modulus, or use the adhesion rule paper")
            return
        end do
    end subroutine check_kinks

    !> d0, F0, k and dl at coordinate x, and their slopes in x.
    subroutine sample(self, x, values, error, slopes)
        class(parts_t), intent(inout) :: self
        real(wp), intent(in) :: x
        real(wp), intent(out) :: values(:)
        type(error_t), allocatable, intent(inout) :: error
        real(wp), intent(out), optional :: slopes(:)
        type(contact_state_t) :: state
        logical :: adhesive

        values = 0.0_wp
        adhesive = self%equilibrium%work_of_adhesion > 0.0_wp
        if (present(slopes)) then
            slopes = 0.0_wp
            call self%equilibrium%parts(self%equilibrium%radius_of(x), state, error, slopes(:of_stiffness))
            self%has_slopes = slopes(of_depth) > 0.0_wp
        else
            call self%equilibrium%parts(self%equilibrium%radius_of(x), state, error)
        end if
        if (allocated(error)) return
        self%solutions = self%solutions + 1
        values = [state%depth, state%force, state%stiffness, merge(-state%punch_depth, 1.0_wp, adhesive)]
        if (.not. (minval(values) >= 0.0_wp .and. maxval(values) <= huge(1.0_wp))) then
            call raise(error, error_no_convergence, "the depth or the force of this medium is not a positive "// &
                       "number near a = "//to_text(state%radius))
            return
        end if
        values = log(max(values, tiny(1.0_wp)))
    end subroutine sample

    pure function radius(self, x)
        class(parts_t), intent(in) :: self
        real(wp), intent(in) :: x
        real(wp) :: radius

        radius = self%equilibrium%radius_of(x)
    end function radius

    !> Close to a flat end a - b, and all that depends on it, has lost digits.
    pure function attainable(self, x) result(accuracy)
        class(parts_t), intent(in) :: self
        real(wp), intent(in) :: x
        real(wp) :: accuracy

        accuracy = 16.0_wp*epsilon(1.0_wp)*self%equilibrium%profile%end_radius*exp(-x)
    end function attainable

    pure function point_of(self, x, v) result(point)
        class(curve_t), intent(in) :: self
        real(wp), intent(in) :: x, v(rows)
        type(curve_point_t) :: point
        real(wp) :: e(rows)

        e = exp(v)
        if (.not. self%adhesive) e(of_excess) = 0.0_wp
        point%x = x
        point%radius = self%coordinate%radius(x)
        point%depth = e(of_depth) - e(of_excess)
        point%force = e(of_force) - e(of_stiffness)*e(of_excess)
        point%stiffness = e(of_stiffness)
    end function point_of

    pure subroutine control_of(self, control, v, dv, s, ds)
        class(curve_t), intent(in) :: self
        type(control_t), intent(in) :: control
        real(wp), intent(in) :: v(rows), dv(rows)
        real(wp), intent(out) :: s, ds
        real(wp) :: e(rows)

        e = exp(v)
        if (.not. self%adhesive) e(of_excess) = 0.0_wp
        s = control%of(e(of_depth) - e(of_excess), e(of_force) - e(of_stiffness)*e(of_excess))
        ds = control%of(e(of_depth)*dv(of_depth) - e(of_excess)*dv(of_excess), &
                        e(of_force)*dv(of_force) - e(of_stiffness)*e(of_excess)*(dv(of_stiffness) + dv(of_excess)))
    end subroutine control_of

    !> d0, F0, k and dl at coordinate x, and their slopes in x.
    pure subroutine parts(self, x, values, slopes)
        class(curve_t), intent(in) :: self
        real(wp), intent(in) :: x
        real(wp), intent(out) :: values(rows), slopes(rows)

        call self%values_at(x, values, slopes)
        values = exp(values)
        slopes = values*slopes
    end subroutine parts

    subroutine state_at(self, equilibrium, x, state, error)
        class(curve_t), intent(in) :: self
        type(equilibrium_t), intent(in) :: equilibrium
        real(wp), intent(in) :: x
        type(contact_state_t), intent(out) :: state
        type(error_t), allocatable, intent(out) :: error

        call equilibrium%at(self%coordinate%radius(x), state, error)
    end subroutine state_at

    !> Puts instead of depth and stiffness the shift S = int dF/k_t under which the contact would begin to slide if its coefficient
    !> of friction were 1, and the tangential stiffness k_t = dF/dS: those of superposed punches (theory/friction.md (4.4)).
    subroutine shear(self, tangential, error)
        class(curve_t), intent(inout) :: self
        !> its modulus is G_t(a)
        class(solver_t), intent(in) :: tangential
        type(error_t), allocatable, intent(out) :: error
        type(curve_point_t) :: point
        real(wp) :: rule(shift_nodes, 2), z, v(rows), dv(rows), modulus(1), k(nodes), shifts(0:nodes), gained(0:nodes + 1), &
                    places(0:nodes + 1)
        integer :: panel, i, j

        self%adhesive = .false.
        call gauss_legendre(rule(:, 1), rule(:, 2), error)
        if (allocated(error)) return
        places = [-1.0_wp, (node(i, nodes), i=nodes, 1, -1), 1.0_wp]
        do panel = 1, size(self%from_root)
            do i = 1, nodes
                call self%in_panel(panel, node(i, nodes), v, dv)
                point = self%point_of(self%place(panel, node(i, nodes)), v)
                call tangential%modulus([point%radius], modulus, error)
                if (allocated(error)) return
                k(i) = 2.0_wp*point%radius*modulus(1)
            end do
            self%coefficients(of_stiffness, :, 1, panel) = reshape(series_of_values(reshape(log(k), [1, nodes])), [nodes])
            if (panel == 1) then
                ! below, F and k_t are powers of a
                call self%in_panel(1, -1.0_wp, v, dv)
                shifts(0) = exp(v(of_force) - v(of_stiffness))*dv(of_force)/(dv(of_force) - dv(of_stiffness))
            end if
            gained = 0.0_wp
            do i = 1, nodes + 1
                do j = 1, shift_nodes
                    z = places(i - 1) + (places(i) - places(i - 1))*rule(j, 1)
                    call self%in_panel(panel, z, v, dv)
                    gained(i) = gained(i) + (places(i) - places(i - 1))*rule(j, 2) &
                                *exp(v(of_force) - v(of_stiffness))*dv(of_force)
                end do
                gained(i) = gained(i) + gained(i - 1)
            end do
            shifts(1:) = shifts(0) + gained(nodes:1:-1)
            self%coefficients(of_depth, :, 1, panel) = reshape(series_of_values(reshape(log(shifts(1:)), [1, nodes])), [nodes])
            shifts(0) = shifts(0) + gained(nodes + 1)
        end do
        call self%keep_ends()
    end subroutine shear

end module mdrcontact_contact_curve
