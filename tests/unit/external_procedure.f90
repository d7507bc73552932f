! SPDX-License-Identifier: GPL-3.0-or-later
!> What a host calls at every contact: an external procedure that takes the whole library, as docs/host-codes.md has it.
subroutine cntfor(law, depth, force, slope)
    use mdrcontact, only: contact_law_t
    implicit none (type, external)
    type(contact_law_t), intent(in) :: law
    double precision, intent(in) :: depth
    double precision, intent(out) :: force, slope

    call law%force_and_slope(depth, force, slope)
end subroutine cntfor
