! SPDX-License-Identifier: GPL-3.0-or-later
!> The indenter's profile g(x) on the panels of a contact, in the kernel's units.
!>
!> The springs' load is q = E0* (d - g - v) with v smooth at the kernel's width whatever g is: g itself is not interpolated.
!> Panels on which their
!> own nodes do not resolve g (a break of the profile, a fractional power at the tip) integrate it by a finer, graded rule.
module mdrcontact_layered_indenter
    use mdrcontact_kinds, only: wp
    use mdrcontact_layered_grid, only: grid_t, longest_panel, split_panels
    use mdrcontact_layered_kernel, only: kernel_t
    use mdrcontact_layered_matrix, only: interaction_at
    use mdrcontact_layered_rule, only: rule_t
    use mdrcontact_profile, only: profile_t
    use mdrcontact_quadrature, only: graded_rule, smallest_panel_ratio
    implicit none (type, external)
    private
    public :: load_t, choose_panels, new_load, add_fine_interaction

    !> Relative size of the last Legendre coefficients of g on a panel that count as resolved.
    real(wp), parameter :: resolved = 1.0e-13_wp
    integer, parameter :: most_splits = 40

    !> g on a grid.
    type :: load_t
        !> g at the grid's nodes [length]; 0 on panels that integrate it by the finer rule
        real(wp), allocatable :: values(:)
        !> nodes of the finer rule [unit] and g times weight there [length unit]
        real(wp), allocatable :: fine_x(:), fine_gw(:)
    end type load_t

contains

    !> Edges of the panels [unit] for contact radius a [unit].
    subroutine choose_panels(kernel, profile, a, width, rule, edges)
        type(kernel_t), intent(in) :: kernel
        class(profile_t), intent(in) :: profile
        !> contact radius, and the width that panels need not resolve
        real(wp), intent(in) :: a, width
        type(rule_t), intent(in) :: rule
        real(wp), allocatable, intent(out) :: edges(:)
        real(wp), allocatable :: breaks(:), singular(:)
        integer :: i, split, before

        allocate (breaks, source=profile%break_radii()/kernel%unit)
        allocate (singular, source=[a, pack(breaks, breaks < a)])
        call split_panels(a, width, singular, edges)
        if (size(edges) == 2) return
        if (.not. is_even(kernel, profile, edges(2), rule)) singular = [singular, 0.0_wp]
        do split = 1, most_splits
            call split_panels(a, width, singular, edges)
            before = size(singular)
            do i = 1, size(edges) - 1
                if (edges(i + 1) - edges(i) <= longest_panel*width) cycle
                if (resolves(kernel, profile, edges(i), edges(i + 1), rule)) cycle
                singular = [singular, 0.5_wp*(edges(i) + edges(i + 1))]
            end do
            if (size(singular) == before) exit
        end do
    end subroutine choose_panels

    !> g on the grid.
    subroutine new_load(kernel, profile, grid, rule, load)
        type(kernel_t), intent(in) :: kernel
        class(profile_t), intent(in) :: profile
        type(grid_t), intent(in) :: grid
        type(rule_t), intent(in) :: rule
        type(load_t), intent(out) :: load
        real(wp), allocatable :: breaks(:), s(:), ds(:)
        real(wp) :: low, high, lowest
        integer :: i, first, last

        allocate (load%values(size(grid%x)), load%fine_x(0), load%fine_gw(0))
        load%values = profile%mdr(grid%x*kernel%unit)
        allocate (breaks, source=profile%break_radii())
        do i = 1, size(grid%edges) - 1
            low = grid%edges(i)*kernel%unit
            high = grid%edges(i + 1)*kernel%unit
            if (.not. any(breaks > low .and. breaks < high)) then
                if (resolves(kernel, profile, grid%edges(i), grid%edges(i + 1), rule)) cycle
            end if
            first = (i - 1)*rule%n + 1
            last = i*rule%n
            load%values(first:last) = 0.0_wp
            lowest = max(low, profile%end_radius(), smallest_panel_ratio*high)
            if (lowest >= high) cycle
            if (low < lowest) then
                load%fine_x = [load%fine_x, 0.0_wp]
                load%fine_gw = [load%fine_gw, (lowest*profile%mdr(lowest) - profile%mdr_moment(lowest))/kernel%unit]
            end if
            call graded_rule(lowest, high, breaks, profile%largest_radius(), s, ds)
            load%fine_x = [load%fine_x, s/kernel%unit]
            load%fine_gw = [load%fine_gw, profile%mdr(s)*ds/kernel%unit]
        end do
    end subroutine new_load

    !> Adds the interaction of the finely integrated part of g with position x.
    subroutine add_fine_interaction(kernel, load, x, value)
        type(kernel_t), intent(in) :: kernel
        type(load_t), intent(in) :: load
        real(wp), intent(in) :: x
        real(wp), intent(inout) :: value
        real(wp) :: interaction(size(load%fine_x))

        if (size(load%fine_x) == 0) return
        call interaction_at(kernel, x, load%fine_x, interaction)
        value = value + sum(interaction*load%fine_gw)
    end subroutine add_fine_interaction

    !> Whether the panel's nodes resolve g.
    function resolves(kernel, profile, low, high, rule) result(answer)
        type(kernel_t), intent(in) :: kernel
        class(profile_t), intent(in) :: profile
        real(wp), intent(in) :: low, high
        type(rule_t), intent(in) :: rule
        logical :: answer
        real(wp) :: values(rule%n)

        values = profile%mdr((low + (high - low)*rule%nodes)*kernel%unit)
        answer = maxval(abs(matmul(rule%to_legendre(rule%n - 1:, :), values))) <= resolved*maxval(abs(values))
    end function resolves

    !> Whether g is a smooth even function at the tip: resolved as a polynomial in x^2 on [0, high].
    function is_even(kernel, profile, high, rule) result(answer)
        type(kernel_t), intent(in) :: kernel
        class(profile_t), intent(in) :: profile
        real(wp), intent(in) :: high
        type(rule_t), intent(in) :: rule
        logical :: answer
        real(wp) :: values(rule%n)

        values = profile%mdr(high*sqrt(rule%nodes)*kernel%unit)
        answer = maxval(abs(matmul(rule%to_legendre(rule%n - 1:, :), values))) <= resolved*maxval(abs(values))
    end function is_even

end module mdrcontact_layered_indenter
