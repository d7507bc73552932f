! SPDX-License-Identifier: GPL-3.0-or-later
!> The same as mdrcontact_layered_rule in longer numbers.
module mdrcontact_layered_rule_long
    use mdrcontact_kinds, only: long, wp
    use mdrcontact_numerics_quadrature, only: gauss_legendre
    implicit none (type, external)
    private
    public :: rule_t, new_rule, legendre

    integer, parameter :: rp = long

    include "rule.inc"

end module mdrcontact_layered_rule_long
