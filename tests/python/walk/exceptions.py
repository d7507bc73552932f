# SPDX-License-Identifier: GPL-3.0-or-later
"""Members that do not matter to an answer, and why: one line a class, member and answer."""

from __future__ import annotations

from collections.abc import Callable
from itertools import product
from typing import Any, NamedTuple

import mdrcontact as mdr

from .tree import members


class Exempt(NamedTuple):
    """A member that does not matter to an answer: nowhere, or in one scene or at one place of it."""

    member: str
    """Class.member, and of a choice what it becomes"""
    answer: str
    reason: str
    where: str = ""
    """"", a condition, a scene, or a scene and a path"""

    def __str__(self) -> str:
        return f"{self.member} | {self.answer} | {self.where or 'anywhere'} | {self.reason}"


def _adheres(contact: Any) -> bool:
    given = members(contact)
    return bool(given.get("work_of_adhesion", 0.0)) or given.get("adhesion") is not None


def _is_exact(contact: Any) -> bool:
    """Whether the medium is solved exactly, or homogeneous: the rule of the energy is that of "automatic"."""
    return getattr(members(contact)["medium"], "model", "exact") == "exact"


CONDITIONS: dict[str, Callable[[Any], bool]] = {
    "without adhesion": lambda contact: not _adheres(contact),
    "with adhesion, exact": lambda contact: _adheres(contact) and _is_exact(contact),
}
"""Where an exception holds, by the object that has the member."""

EXCEPTIONS: list[Exempt] = []
MODELS = [name for name in mdr.Coated.models() if name not in ("exact", "dimitriadis", "garcia")]


def _except(reason: str, of: str, answers: str, where: str = "") -> None:
    """A line for each of some members and each of some answers, separated by blanks."""
    EXCEPTIONS.extend(Exempt(member, answer, reason, where) for member, answer in product(of.split(), answers.split()))


_except(
    "conducting has no part in mechanics",
    "Elastic.conductor=present",
    "at_depth at_depth_loading at_force at_radius compliance_coupling compliance_limits compliance_normal compliance_omega "
    "compliance_shear compliance_twist responses "
    "creep critical displacement displacement_of_bodies dynamic_depth dynamic_force dynamic_radius "
    "energy energy_of_bodies fibre_modulus first_failure friction_history friction_history_force gradient "
    "history_depth history_force history_radius imprint_of_pressure imprint_of_two_terms imprint_pull_off "
    "imprint_unloading interior interior_sliding interior_upper law_at_depth law_at_force "
    "law_beyond law_buffer law_conductance law_energy law_shear law_with_radius line_load loop_depth loop_force "
    "loop_spring lowest_pressure material_modulus modulus pressure pull_off_depth pull_off_force punch_depth "
    "punch_in_time rate_history rate_history_force rate_history_spring relaxation shear_at_force shear_at_shift "
    "shear_cycles shear_fields state_slope stiffness structure_bounds structure_materials structure_modulus tangential_modulus "
    "torsional_stiffness twisted voxel_map voxel_modulus wear_at_depth wear_at_force wear_bracket wear_bracket_force "
    "wear_limit wear_limit_force wear_rings wear_running_in wear_same_places wear_track wrinkling zone",
)
_except(
    "conducting has no part in mechanics",
    "Elastic.conductor=present",
    "law_facts",
    "law",
)
_except(
    "a resistance is none to forces",
    "Interface.resistance",
    "at_depth at_depth_loading at_force at_radius compliance_coupling compliance_limits compliance_normal compliance_omega "
    "compliance_shear compliance_twist responses "
    "creep critical displacement dynamic_depth dynamic_force dynamic_radius energy friction_history "
    "friction_history_force history_depth history_force history_radius interior interior_sliding line_load loop_depth "
    "loop_force loop_spring modulus pressure pull_off_depth pull_off_force punch_depth relaxation shear_at_force "
    "shear_at_shift shear_cycles shear_fields state_slope stiffness tangential_modulus wear_at_depth wear_at_force wear_bracket "
    "wear_bracket_force wear_limit wear_limit_force wear_rings wear_same_places wear_track wrinkling",
)
_STEADY = "along compliance_flux conduction_compliance friction_heat spot spot_fields tabulated"
_LATE = "admittance compliance_flux_omega conduction_compliance_omega conduction_follow conduction_step step_flux"
_CONDUCTION = f"{_STEADY} {_LATE}"
_except(
    "elasticity has no part in conduction",
    "Elastic.E Elastic.nu",
    f"{_CONDUCTION} law_conductance",
)
_except(
    "elasticity has no part in conduction",
    "Interface.normal Interface.normal=None Interface.tangential Interface.tangential=None",
    "compliance_flux conduction_compliance spot",
)
_except(
    "elasticity has no part in conduction",
    "Interface.normal=present Interface.tangential=present",
    "admittance along conduction_compliance conduction_compliance_omega conduction_follow conduction_step "
    "friction_heat friction_heat_of_pair law_conductance rough spot spot_fields spot_upper step_flux tabulated",
)
_except(
    "a stress has no part in conduction",
    "Layer.prestress",
    "compliance_flux conduction_compliance spot",
)
_except(
    "the surface's tension has no part in conduction",
    "Coated.surface=present Homogeneous.surface=present",
    "along conduction_compliance friction_heat spot spot_fields tabulated",
)
_except(
    "the surface's tension has no part in conduction",
    "Layered.surface=present",
    _CONDUCTION,
)
_except(
    "conduction has one model",
    " ".join(f"Coated.model={name}" for name in MODELS),
    _STEADY,
)
_except(
    "conduction has one model",
    "Layered.model=gao Layered.model=gao-series Layered.model=gao-power",
    _CONDUCTION,
)
_except(
    "a steady flux fills no heat capacity",
    "Conductor.capacity",
    f"{_STEADY} friction_heat_of_pair friction_heat_spinning joint_resistance_of_bodies law_conductance rough spot_upper",
)
_except(
    "the answer of the bodies, without the film",
    "Conduction.film",
    "conduction_compliance conduction_compliance_omega",
)
_except(
    "the resistance of rough surfaces replaces the film",
    "Conduction.film",
    "joint_resistance_of_bodies rough",
)
_except(
    "one body takes all heat, with a film or without",
    "Conduction.film",
    "friction_heat friction_heat_moving",
)
_except(
    "of a table: beyond it the conductance is solved",
    "TabulatedConduction.smallest TabulatedConduction.largest",
    "spot",
)
_except(
    "an accuracy",
    "TabulatedConduction.tolerance",
    "spot",
)

_except(
    "answers to waves are exact: docs/coatings.md",
    " ".join(f"Coated.model={name}" for name in MODELS),
    "compliance_coupling compliance_limits compliance_normal compliance_shear compliance_twist compliance_omega responses",
)
_except(
    "answers to waves are exact: docs/coatings.md",
    "Graded.model=gao Graded.model=gao-series Graded.model=gao-power Layered.model=gao Layered.model=gao-series "
    "Layered.model=gao-power",
    "compliance_coupling compliance_limits compliance_normal compliance_shear compliance_twist responses",
)
_except(
    "waves of no length and a uniform pressure do not shear an interface",
    "Interface.tangential Interface.tangential=None",
    "compliance_limits",
)
_except(
    "a twist has no component normal to the surface",
    "Interface.normal Interface.normal=None",
    "compliance_twist",
)
_except(
    "a twist shears along and across the axis alone: C44 and (C11 - C12)/2",
    "TransverselyIsotropic.C13 TransverselyIsotropic.C33",
    "compliance_twist torsional_stiffness",
)
_except(
    "a twist shears along and across the axis alone: G_z and E_t/(1 + nu_t)",
    "TransverselyIsotropic.engineering[1] TransverselyIsotropic.engineering[3]",
    "compliance_twist torsional_stiffness",
)
_AXISYMMETRIC = (
    "at_depth at_force at_radius compliance_coupling compliance_limits compliance_normal displacement displacement_of_bodies "
    "energy energy_of_bodies responses "
    "line_load material_modulus modulus pressure stiffness"
)
_except(
    "axisymmetric waves of normal load see C11, C13, C33 and C44",
    "TransverselyIsotropic.C12",
    _AXISYMMETRIC,
)
_except(
    "of the upper body, whose stresses alone know it",
    "TransverselyIsotropic.C12",
    "interior interior_sliding",
    "pair",
)
_except(
    "the layer's own prestress is what is found",
    "Layer.prestress",
    "wrinkling",
    "stack medium:layers[0].prestress",
)

_GEOMETRY = "at a given depth the surface of a half-space has its shape whatever its moduli are"
_except(
    _GEOMETRY,
    "Elastic.E Elastic.nu",
    "displacement",
    "half-space",
)
_except(
    _GEOMETRY,
    " ".join(f"TransverselyIsotropic.engineering[{i}]" for i in range(5)),
    "displacement",
    "engineered",
)
_except(
    _GEOMETRY,
    "PowerLawGraded.E0 PowerLawGraded.z0 PowerLawGraded.nu",
    "displacement",
)
_except(
    "at a given depth moduli of a film on a rigid base cancel",
    "Elastic.E",
    "displacement",
    "rigid base",
)
_except(
    "an effective modulus leaves the surface that of a half-space",
    "Elastic.E Elastic.nu Coated.thickness Coated.model=gao-power Coated.model=gao-series",
    "displacement",
    "gao inside",
)
_except(
    "an effective modulus leaves the surface that of a half-space",
    "Coated.weight_nu Coated.weight_nu=surface Coated.weight_nu=substrate Coated.weight_nu=effective",
    "displacement",
    "gao inside",
)
for _scene in ("half-space", "engineered", "power graded"):
    _except(
        "springs inside the contact know the depth alone", "Contact.work_of_adhesion Contact.adhesion=present", "line_load", _scene
    )
_except(
    "at a given contact radius the shape of the indenter does not matter",
    "Sphere.radius Contact.zeta=present",
    "creep dynamic_radius relaxation",
)
_except(
    "the end is flat: g = 0",
    "FlatPunch.radius",
    "profile_mdr",
)
_except(
    "moduli cancel: forces of the state at a depth",
    "Elastic.E Elastic.nu",
    "wear_limit_force",
    "wear on half-space",
)

_except(
    "without adhesion no spring is stretched",
    "Contact.adhesion_rule=paper Contact.adhesion_rule=energy",
    "at_depth at_force at_radius displacement displacement_of_bodies energy energy_of_bodies interior "
    "interior_sliding interior_upper line_load pressure lowest_pressure law_at_depth law_at_force law_energy "
    "law_buffer law_beyond law_with_radius law_conductance law_shear creep dynamic_depth dynamic_force dynamic_radius "
    "gel_dynamic gel_history gel_pressure gel_steps history_depth history_force history_radius punch_in_time "
    "relaxation friction_history friction_history_force shear_at_force shear_at_shift shear_cycles shear_fields "
    "twisted wear_at_depth wear_at_force wear_bracket wear_bracket_force wear_limit wear_limit_force wear_rings "
    "wear_running_in wear_same_places wear_track",
    "without adhesion",
)
_except(
    "without adhesion no spring is stretched",
    "Contact.adhesion_rule=paper Contact.adhesion_rule=energy",
    "law_facts",
    "law",
)
_except(
    'it is the rule that "automatic" takes here',
    "Contact.adhesion_rule=energy",
    "adhesive_history at_depth at_depth_loading at_force at_radius displacement energy interior law_at_depth "
    "law_at_force law_energy law_buffer line_load loop_depth loop_force loop_spring pressure pull_off_depth "
    "pull_off_force punch_depth state_slope zone",
    "with adhesion, exact",
)
_except(
    'it takes the rule "paper" here',
    "Contact.adhesion_rule=automatic",
    "at_depth at_force at_radius pressure pull_off_force",
    "adhesion by a table",
)
_RESTING = (
    "RateAdhesion.speed RateAdhesion.exponent RateAdhesion.closing_work RateAdhesion.closing_speed RateAdhesion.closing_exponent"
)
_except(
    "states are those of an edge at rest",
    _RESTING,
    "at_depth pull_off_force",
)
_except(
    "states are those of an edge at rest",
    " ".join(f"RateAdhesion.closing_{name}=None" for name in ("work", "speed", "exponent")),
    "at_depth pull_off_force",
)
_except(
    "states are those of an edge at rest",
    "RheologicalAdhesion.cohesive_stress",
    "at_depth",
)
_except(
    "states are those of an edge at rest",
    "Viscoelastic.relaxed_shear_modulus Viscoelastic.terms[0][0] Viscoelastic.terms[0][1] Viscoelastic.nu",
    "at_depth",
    "rheology",
)
_except(
    "at a given contact radius adhesion adds nothing to shear",
    "Contact.adhesion=present",
    "law_shear",
    "law with a shear strength",
)

_except(
    "moduli in shear do not know the bulk",
    "Viscoelastic.nu Viscoelastic.bulk_modulus PowerLawRheology.nu",
    "material_in_time",
)
_except(
    "what lasts has no terms",
    "Viscoelastic.terms[0][0] Viscoelastic.terms[0][1] Viscoelastic.terms[1][0] Viscoelastic.terms[1][1]",
    "material_relaxed",
)
_except(
    "what is sudden has no times",
    "Viscoelastic.terms[0][1] Viscoelastic.terms[1][1]",
    "material_glassy",
)
_except(
    "a dashpot bears nothing at rest",
    "Viscoelastic.viscosity",
    "material_relaxed relaxation",
)
_except(
    "moduli of a gel are those of its ends",
    "Poroelastic.diffusivity",
    "gel_moduli",
)

_except(
    "the body wears where the indenter meets the same places",
    "Wear.body_coefficient",
    "wear_at_depth wear_at_force wear_rings wear_running_in",
)
_except(
    "where wear ends does not depend on how fast it goes",
    "Wear.coefficient Wear.body_coefficient",
    "wear_limit wear_limit_force",
)
_except(
    "the track is what the body loses",
    "Wear.coefficient",
    "wear_track",
)

_except(
    "an accuracy",
    "ContactLaw.tolerance",
    "law_at_depth law_at_force law_beyond law_buffer law_conductance law_energy law_facts law_shear law_with_radius",
)
_except(
    "how far the law goes",
    "ContactLaw.largest_depth",
    "law_at_depth law_at_force law_conductance law_energy law_with_radius",
)
_except(
    "where its tolerance begins",
    "ContactLaw.smallest_depth",
    "law_at_depth law_at_force law_energy",
)
_except(
    "within its range",
    "ContactLaw.continue_beyond=True",
    "law_at_depth law_at_force law_energy law_facts",
)
_except(
    "within its range",
    "ContactLaw.continue_beyond=False",
    "law_with_radius",
)
_except(
    "words",
    "ContactLaw.description=another",
    "law_at_depth law_at_force law_buffer law_energy",
)
_except(
    "the new radius stands in its place",
    "Paraboloid.radius",
    "law_with_radius plastic_with_radius",
)
_except(
    "an accuracy",
    "PlasticLaw.tolerance",
    "plastic_steps plastic_loading plastic_with_radius plastic_table",
)
_except(
    "how far the law goes",
    "PlasticLaw.largest_depth",
    "plastic_steps plastic_loading plastic_with_radius plastic_table",
)
_except(
    "conducting has no part in mechanics",
    "Elastic.conductor=present",
    "plastic_steps plastic_loading plastic_facts plastic_with_radius plastic_table",
)

_except(
    "how far the indenter goes",
    "AreaFunction.max_height CallableProfile.r_max",
    "at_depth at_force at_radius line_load pressure profile_height profile_mdr",
)
_except(
    "how far the medium goes",
    "CallableMedium.smallest_radius CallableMedium.largest_radius",
    "modulus stiffness",
)
_except(
    "an accuracy",
    "Shapes.tolerance",
    "structure_bounds structure_modulus",
)
_except(
    "an accuracy",
    "Field.tolerance",
    "structure_modulus",
)
_except(
    "bounds are means of the exponents -1 and 1",
    "Shapes.exponent",
    "structure_bounds",
)
_except(
    "places of a map count from the array's corner",
    "Voxels.origin[0] Voxels.origin[1]",
    "voxel_map",
)

_except(
    "the film is left out",
    "Conduction.film",
    "conduction_step_flux_answers",
)
_except(
    "without adhesion no spring is stretched",
    "Contact.adhesion_rule=paper Contact.adhesion_rule=energy",
    "returned",
    "without adhesion",
)
_except(
    "conducting has no part in mechanics",
    "Elastic.conductor=present",
    "returned",
)
_except(
    "an elastic body answers at any frequency as at rest",
    "Medium.compliance.omega",
    "returned",
)
_except(
    "an accuracy, which the fewest exponentials exceed",
    "Medium.point_response.tolerance Medium.rectangle_response.tolerance Medium.response_error.tolerance",
    "returned",
)
_except(
    "without adhesion there is one branch",
    "ContactLaw.table.branch=loading lammps.table.branch=loading overclosure.table.branch=loading",
    "returned",
)
_except(
    "conducting has no part in mechanics",
    "Elastic.conductor=present",
    "overload coated_law pressure_cap",
)
_except(
    "without adhesion no spring is stretched",
    "Contact.adhesion_rule=paper Contact.adhesion_rule=energy",
    "overload coated_law",
)
_except(
    "the yield stress of a body below the film decides only whether the rule holds",
    "Overload.yield_stresses[1]",
    "overload coated_law",
)
