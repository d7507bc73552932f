! SPDX-License-Identifier: GPL-3.0-or-later
!> Sublayers of a body whose constants vary with depth: between two of their ends they vary little.
!>
!> Below the first, homogeneous sublayer (a negligible fraction of the gradient's depth) sublayers take a tenth of their
!> depth, so that any wavelength sees the same number of them.
module mdrcontact_body_sublayers
    use mdrcontact_body, only: body_t
    use mdrcontact_body_gradation, only: nodes
    use mdrcontact_error, only: check_memory, error_t
    use mdrcontact_kinds, only: wp
    use mdrcontact_numerics_quadrature, only: merge_breaks, new_antiderivative
    implicit none (type, external)
    private
    public :: faces_through, is_integrated_by, sublayer_ends

    !> Growth of depth from one sublayer to the next, and the largest ratio of shear moduli within one.
    real(wp), parameter :: growth = 1.1_wp, largest_ratio = 1.3_wp
    !> Relative, of the integrals that show whether a rule follows the constants.
    real(wp), parameter :: rule_tolerance = 1.0e-13_wp

contains

    !> Whether a rule on [0, 1] integrates the constants between two depths as it does over both halves, where its nodes are others,
    !> to its tolerance or to what the rounding of z allows.
    pure function is_integrated_by(body, places, weights, from, to) result(answer)
        class(body_t), intent(in) :: body
        !> nodes and weights, same size
        real(wp), intent(in) :: places(:), weights(:)
        !> 0 <= from < to, no knot between them [length]
        real(wp), intent(in) :: from, to
        logical :: answer
        real(wp), dimension(6) :: whole, halves
        real(wp) :: middle, shear(2), nu, rounding

        middle = from + 0.5_wp*(to - from)
        answer = .not. (from < middle .and. middle < to)
        if (answer) return
        whole = moments(body, places, weights, from, to, from)
        halves = moments(body, places, weights, from, middle, from) + moments(body, places, weights, middle, to, from)
        call body%moduli(from, shear(1), nu)
        call body%moduli(to, shear(2), nu)
        rounding = epsilon(1.0_wp)*to/(to - from)*(maxval(shear)/minval(shear) - 1.0_wp)
        answer = all(abs(whole - halves) <= max(rule_tolerance, rounding)*halves)
    end function is_integrated_by

    !> int {G, 1/G, 1 + nu} dz between two depths, and the same times z - start. All integrands lie between G and 1/G.
    pure function moments(body, places, weights, from, to, start) result(values)
        class(body_t), intent(in) :: body
        real(wp), intent(in) :: places(:), weights(:), from, to, start
        real(wp) :: values(6)
        real(wp) :: z, shear, nu, constants(3)
        integer :: i

        values = 0.0_wp
        do i = 1, size(places)
            z = from + (to - from)*places(i)
            call body%moduli(z, shear, nu)
            constants = weights(i)*(to - from)*[shear, 1.0_wp/shear, 1.0_wp + nu]
            values = values + [constants, (z - start)*constants]
        end do
    end function moments

    !> Ends of sublayers from a homogeneous one of thickness `first` down to the last knot, split at each.
    subroutine sublayer_ends(body, first, knots, places, weights, ends, error)
        class(body_t), intent(in) :: body
        real(wp), intent(in) :: first, knots(:)
        !> the rule by which a sublayer is integrated
        real(wp), intent(in) :: places(:), weights(:)
        real(wp), allocatable, intent(out) :: ends(:)
        type(error_t), allocatable, intent(inout) :: error
        real(wp) :: here, next, shear, shear_next, nu
        integer :: i, count, round, stat

        ! counted, then set
        do round = 1, 2
            count = 2
            here = first
            do i = 1, size(knots)
                do while (here < knots(i))
                    next = min(here*growth, knots(i))
                    if (knots(i) - next < 0.3_wp*(next - here)) next = knots(i)
                    call body%moduli(here, shear, nu)
                    do
                        call body%moduli(next, shear_next, nu)
                        if (next <= here*(1.0_wp + 8.0_wp*epsilon(1.0_wp))) exit
                        if (max(shear/shear_next, shear_next/shear) <= largest_ratio) then
                            if (is_integrated_by(body, places, weights, here, next)) exit
                        end if
                        next = here + 0.5_wp*(next - here)
                    end do
                    count = count + 1
                    if (round == 2) ends(count) = next
                    here = next
                end do
            end do
            if (round == 2) exit
            allocate (ends(count), stat=stat)
            call check_memory(error, stat)
            if (stat /= 0) return
            ends(:2) = [0.0_wp, first]
        end do
    end subroutine sublayer_ends

    !> Depths between which the constants vary little and lengths are small against the depth: 0, `first`, the knots and others.
    subroutine faces_through(body, first, depths, faces, error)
        class(body_t), intent(in) :: body
        !> > 0, and others, ascending from there on [length]
        real(wp), intent(in) :: first, depths(:)
        !> ascending from 0 [length]
        real(wp), allocatable, intent(out) :: faces(:)
        type(error_t), allocatable, intent(inout) :: error
        real(wp) :: antiderivative(nodes + 1, nodes), t(nodes)
        real(wp), allocatable :: knots(:)

        call body%add_breaks(knots, error)
        call merge_breaks(knots, depths, error)
        call new_antiderivative(t, antiderivative, error)
        if (.not. allocated(error)) call sublayer_ends(body, first, knots, t, antiderivative(nodes + 1, :), faces, error)
    end subroutine faces_through

end module mdrcontact_body_sublayers
