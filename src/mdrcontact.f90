! SPDX-License-Identifier: GPL-3.0-or-later
!> The public Fortran surface of the library: `use mdrcontact, only: ...`.
module mdrcontact
    use mdrcontact_contact, only: contact_state_t, contact_t, new_contact
    use mdrcontact_error, only: error_t
    use mdrcontact_kinds, only: wp
    use mdrcontact_material, only: material_t, new_material
    use mdrcontact_medium, only: medium_t
    use mdrcontact_medium_gao, only: gao_nu_effective, gao_nu_given, gao_nu_substrate, gao_nu_surface, gao_t, new_gao
    use mdrcontact_medium_homogeneous, only: homogeneous_t, new_homogeneous, new_homogeneous_from_modulus
    use mdrcontact_profile, only: profile_t
    use mdrcontact_profile_power_law, only: new_cone, new_paraboloid, new_power_law, power_law_t
    use mdrcontact_version, only: version_string
    use mdrcontact_weights, only: weight_i0, weight_i1, weight_j0, weight_j1, weight_phi
    implicit none (type, external)
    public
end module mdrcontact
