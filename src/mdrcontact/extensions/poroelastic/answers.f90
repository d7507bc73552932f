! SPDX-License-Identifier: GPL-3.0-or-later
!> Response of a gel at some times and frequencies, solved there: relaxation, creep and oscillation.
!>
!> theory/poroelastic.md (5.1), (5.3), (6.2).
module mdrcontact_poroelastic_answers
    use mdrcontact_error, only: error_t
    use mdrcontact_kinds, only: wp
    use mdrcontact_numerics_laplace, only: inverse_laplace
    use mdrcontact_numerics_waves, only: basis_t, new_basis
    use mdrcontact_poroelastic_contact, only: flat, solve_contacts, solve_elastic
    use mdrcontact_poroelastic_gel, only: gel_t
    implicit none (type, external)
    private
    public :: first_time, basis_for, answers, at_end, nodes
    public :: columns, relaxation, creep, paraboloid, mean_relaxation, mean_creep, storage, loss

    !> Tabulated quantities. In time tau, per its value on an incompressible half-space: the force after a step of a flat punch's
    !> depth, the depth after a step of its force, the force of a paraboloid pressed in instantaneously whose contact radius is
    !> held, the means of the first two since the step, which are responses to ramps; of the frequency omega a^2/D: the two parts of
    !> a flat punch's dynamic stiffness.
    integer, parameter :: columns = 7, relaxation = 1, creep = 2, paraboloid = 3, mean_relaxation = 4, mean_creep = 5, &
                          storage = 6, loss = 7
    !> Nodes of the inverse Laplace transform: at one time, with an error of 2e-11, of means 2e-9; and per sqrt(8 r + 1) of times up
    !> to a factor r apart, with one of 3e-15: paths with steep ramps multiply differences of means at neighbouring times.
    integer, parameter :: nodes = 12
    real(wp), parameter :: density = 6.5_wp

contains

    !> From this tau on responses are solved. Before it, what drains is a layer at the surface so thin that few polynomials do not
    !> follow it at the edge, and that a film's base does not matter.
    elemental function first_time(gel) result(tau)
        type(gel_t), intent(in) :: gel
        real(wp) :: tau

        tau = merge(1.0e-5_wp, 1.0e-4_wp, gel%ratio > 1.0_wp)
    end function first_time

    !> The basis for tau, or 1/(omega a^2/D), between two values; `finer` adds to it.
    subroutine basis_for(gel, shortest, longest, basis, error, finer)
        type(gel_t), intent(in) :: gel
        real(wp), intent(in) :: shortest, longest
        type(basis_t), intent(out) :: basis
        type(error_t), allocatable, intent(inout) :: error
        logical, intent(in), optional :: finer
        real(wp) :: last, first
        integer :: order

        order = 16 + ceiling(1.5_wp*gel%ratio)
        if (shortest < 0.9e-2_wp) order = order + 4
        if (shortest < 0.9e-3_wp) order = order + 8
        if (shortest < 0.9e-4_wp) order = order + 6
        if (present(finer)) order = order + 6
        ! |s| is at most 25/tau where the weights of the inverse transform show
        last = max(4.0_wp*order, 6.0_wp/sqrt(shortest), 20.0_wp*gel%ratio)
        if (present(finer)) last = 1.5_wp*last
        first = 0.02_wp*min(1.0_wp, sqrt(1.0_wp/longest))
        if (gel%ratio > 0.0_wp) first = min(first, 0.02_wp*gel%ratio)
        call new_basis(basis, order, first, last, error)
    end subroutine basis_for

    !> Number of nodes that these times share.
    pure function shared_nodes(tau) result(count)
        real(wp), intent(in) :: tau(:)
        integer :: count

        count = ceiling(density*sqrt(8.0_wp*(maxval(tau)/minval(tau)) + 1.0_wp))
    end function shared_nodes

    !> All columns at times between those of the basis, and at the frequencies 1/tau.
    subroutine answers(gel, basis, tau, values, error)
        type(gel_t), intent(in) :: gel
        type(basis_t), intent(in) :: basis
        real(wp), intent(in) :: tau(:)
        !> (column, time)
        real(wp), intent(out) :: values(:, :)
        type(error_t), allocatable, intent(inout) :: error
        complex(wp) :: s(shared_nodes(tau)), weight(size(s), size(tau)), mean
        complex(wp), dimension(basis%order, size(s) + size(tau)) :: q, w
        integer :: i, j

        values = 0.0_wp
        if (allocated(error)) return
        call inverse_laplace(tau, s, weight)
        call solve_contacts(gel, basis, flat, [s, cmplx(0.0_wp, 1.0_wp/tau, wp)], q, w, error)
        if (allocated(error)) return
        do i = 1, size(tau)
            do j = 1, size(s)
                mean = 1.0_wp/(s(j)*tau(i))
                values(:storage - 1, i) = values(:storage - 1, i) &
                    + aimag(weight(j, i)*[q(1, j), 1.0_wp/q(1, j), of_paraboloid(q(:, j)), q(1, j)*mean, mean/q(1, j)])
            end do
            values(storage:, i) = [real(q(1, size(s) + i), wp), aimag(q(1, size(s) + i))]
        end do
    end subroutine answers

    !> All columns of the elastic body that a gel is initially, or finally.
    subroutine at_end(gel, basis, is_drained, values, error)
        type(gel_t), intent(in) :: gel
        type(basis_t), intent(in) :: basis
        logical, intent(in) :: is_drained
        real(wp), intent(out) :: values(columns)
        type(error_t), allocatable, intent(inout) :: error
        complex(wp) :: q(basis%order)

        values = 0.0_wp
        call solve_elastic(gel, basis, is_drained, q, error)
        if (allocated(error)) return
        associate (force => real(q(1), wp))
            values = [force, 1.0_wp/force, real(of_paraboloid(q), wp), force, 1.0_wp/force, force, 0.0_wp]
        end associate
    end subroutine at_end

    !> The force under 1 - x^2, by the reciprocity of the two loads: (3/2) int q (1 - x^2) dx, q being that of a punch.
    pure function of_paraboloid(q) result(force)
        complex(wp), intent(in) :: q(:)
        complex(wp) :: force

        force = q(1) - q(2)/sqrt(5.0_wp)
    end function of_paraboloid

end module mdrcontact_poroelastic_answers
