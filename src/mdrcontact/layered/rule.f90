! SPDX-License-Identifier: GPL-3.0-or-later
!> Gauss-Legendre nodes as a basis on a panel [0, 1]: quadrature, Legendre coefficients, interpolation.
module mdrcontact_layered_rule
    use mdrcontact_kinds, only: wp
    use mdrcontact_numerics_quadrature, only: gauss_legendre
    implicit none (type, external)
    private
    public :: rule_t, new_rule, legendre

    integer, parameter :: rp = wp

    include "rule.inc"

end module mdrcontact_layered_rule
