! SPDX-License-Identifier: GPL-3.0-or-later
!> The conductance for a law: in a file of its own, since the fields that give it use the conductors.
submodule(mdrcontact_conduction_bodies) mdrcontact_conduction_for_law
    use mdrcontact_conduction_fields, only: conductance_at
    use mdrcontact_kinds, only: wp
    implicit none (type, external)

contains

    module procedure conductance_for_law
        conductance = 0.0_wp
        slope = 0.0_wp
        if (.not. allocated(error)) call conductance_at(self, a, conductance, slope, error)
    end procedure conductance_for_law

end submodule mdrcontact_conduction_for_law
