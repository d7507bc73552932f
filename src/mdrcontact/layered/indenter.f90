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
    use mdrcontact_numerics_quadrature, only: graded_rule, smallest_panel_ratio
    implicit none (type, external)
    private
    public :: load_t, choose_panels, new_load, add_fine_interaction

    !> Size of the last Legendre coefficients of g on a panel that count as resolved, relative to g at the edge of the contact.
    real(wp), parameter :: resolved = 1.0e-12_wp
    integer, parameter :: most_splits = 40
    !> Panels up to this length, in widths of the kernel, integrate a smooth g by a finer rule: the kernel is no rougher there.
    real(wp), parameter :: longest_smooth = longest_panel

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
        real(wp), allocatable :: breaks(:), singular(:), halved(:)
        integer :: i, split
        logical :: resolved_all

        allocate (breaks, source=profile%break_radii()/kernel%unit)
        allocate (singular, source=[a, pack(breaks, breaks < a)])
        call split_panels(a, width, singular, edges)
        if (size(edges) == 2) return
        if (.not. is_even(kernel, profile, edges(2), profile%mdr(a*kernel%unit), rule)) singular = [singular, 0.0_wp]
        call split_panels(a, width, singular, edges)
        do split = 1, most_splits
            resolved_all = .true.
            halved = [edges(1)]
            do i = 1, size(edges) - 1
                if (edges(i + 1) - edges(i) > longest_panel*width) then
                    if (.not. resolves(kernel, profile, edges(i), edges(i + 1), profile%mdr(a*kernel%unit), rule)) then
                        halved = [halved, 0.5_wp*(edges(i) + edges(i + 1))]
                        resolved_all = .false.
                    end if
                end if
                halved = [halved, edges(i + 1)]
            end do
            if (resolved_all) exit
            edges = halved
        end do
    end subroutine choose_panels

    !> g on the grid.
    subroutine new_load(kernel, profile, grid, rules, level, load)
        type(kernel_t), intent(in) :: kernel
        class(profile_t), intent(in) :: profile
        type(grid_t), intent(in) :: grid
        !> rules of rising order, and the one of the grid
        type(rule_t), intent(in) :: rules(:)
        integer, intent(in) :: level
        type(load_t), intent(out) :: load
        real(wp), allocatable :: breaks(:), s(:), ds(:)
        real(wp) :: low, high, lowest, largest
        integer :: i, first, last, finer
        logical :: broken

        allocate (load%values(size(grid%x)), load%fine_x(0), load%fine_gw(0))
        load%values = profile%mdr(grid%x*kernel%unit)
        allocate (breaks, source=profile%break_radii())
        largest = profile%mdr(grid%edges(size(grid%edges))*kernel%unit)
        do i = 1, size(grid%edges) - 1
            low = grid%edges(i)*kernel%unit
            high = grid%edges(i + 1)*kernel%unit
            broken = any(breaks > low .and. breaks < high)
            if (.not. broken) then
                if (resolves(kernel, profile, grid%edges(i), grid%edges(i + 1), largest, rules(level))) cycle
            end if
            first = (i - 1)*rules(level)%n + 1
            last = i*rules(level)%n
            load%values(first:last) = 0.0_wp
            if (.not. broken) then
                finer = level_that_resolves(kernel, profile, grid%edges(i), grid%edges(i + 1), largest, rules, level + 1)
                if (finer <= size(rules)) then
                    s = low + (high - low)*rules(finer)%nodes
                    load%fine_x = [load%fine_x, s/kernel%unit]
                    load%fine_gw = [load%fine_gw, profile%mdr(s)*(high - low)/kernel%unit*rules(finer)%weights]
                    cycle
                end if
            end if
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
    function resolves(kernel, profile, low, high, largest, rule) result(answer)
        type(kernel_t), intent(in) :: kernel
        class(profile_t), intent(in) :: profile
        !> ends of the panel [unit]; g(a), of which the last coefficients must be a negligible part [length]
        real(wp), intent(in) :: low, high, largest
        type(rule_t), intent(in) :: rule
        logical :: answer
        real(wp) :: values(rule%n)

        values = profile%mdr((low + (high - low)*rule%nodes)*kernel%unit)
        answer = maxval(abs(matmul(rule%to_legendre(rule%n - 1:, :), values))) <= resolved*largest
    end function resolves

    !> The first rule from `first` on that resolves g on a panel that is short against the kernel's width; beyond the last rule
    !> if there is none.
    function level_that_resolves(kernel, profile, low, high, largest, rules, first) result(level)
        type(kernel_t), intent(in) :: kernel
        class(profile_t), intent(in) :: profile
        real(wp), intent(in) :: low, high, largest
        type(rule_t), intent(in) :: rules(:)
        integer, intent(in) :: first
        integer :: level

        level = size(rules) + 1
        if (high - low > longest_smooth) return
        do level = first, size(rules)
            if (resolves(kernel, profile, low, high, largest, rules(level))) return
        end do
    end function level_that_resolves

    !> Whether g is a smooth even function at the tip: resolved as a polynomial in x^2 on [0, high].
    function is_even(kernel, profile, high, largest, rule) result(answer)
        type(kernel_t), intent(in) :: kernel
        class(profile_t), intent(in) :: profile
        real(wp), intent(in) :: high, largest
        type(rule_t), intent(in) :: rule
        logical :: answer
        real(wp) :: values(rule%n)

        values = profile%mdr(high*sqrt(rule%nodes)*kernel%unit)
        answer = maxval(abs(matmul(rule%to_legendre(rule%n - 1:, :), values))) <= resolved*largest
    end function is_even

end module mdrcontact_layered_indenter
