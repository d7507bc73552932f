! SPDX-License-Identifier: GPL-3.0-or-later
!> Where contact begins and ends in a measured adhesive curve.
!>
!> Tip and surface jump into contact and out of it. Which readings belong to the contact is a fact of the data, and a model whose
!> parameters are still wrong must not decide it: a baseline taken for a contact, or a contact for a baseline, would hold the search
!> where it is. So on each branch, in order of depth, the point is found up to which "in contact" explains the readings best; those
!> deeper than one above half of the largest force are in contact in any case.
module mdrcontact_fit_branches
    use mdrcontact_kinds, only: wp
    implicit none (type, external)
    private
    public :: separate

contains

    !> Replaces the model in contact by that of separated bodies where this explains the shallow end of each branch better.
    pure subroutine separate(order, branch, y, sd, apart, model)
        !> positions of the points by branch and, within a branch, by ascending depth
        integer, intent(in) :: order(:)
        !> of each point
        integer, intent(in) :: branch(:)
        !> readings and their standard deviations
        real(wp), intent(in) :: y(:), sd(:)
        !> what separated bodies read
        real(wp), intent(in) :: apart
        !> what bodies in contact read, on return the better of both
        real(wp), intent(inout) :: model(:)
        integer :: first, last, i, best
        real(wp) :: gain, largest, pressed

        first = 1
        do while (first <= size(order))
            ! the shallow end, up to `best`, is apart: as far as that lowers the sum of squares most
            gain = 0.0_wp
            largest = 0.0_wp
            best = first - 1
            last = first
            pressed = y(order(first))
            do while (last < size(order))
                if (branch(order(last + 1)) /= branch(order(first))) exit
                last = last + 1
                pressed = max(pressed, y(order(last)))
            end do
            pressed = apart + 0.5_wp*(pressed - apart)
            do i = first, last
                if (y(order(i)) > pressed) exit
                associate (j => order(i))
                    gain = gain + ((y(j) - model(j))**2 - (y(j) - apart)**2)/sd(j)**2
                end associate
                if (gain > largest) then
                    largest = gain
                    best = i
                end if
            end do
            model(order(first:best)) = apart
            first = last + 1
        end do
    end subroutine separate

end module mdrcontact_fit_branches
