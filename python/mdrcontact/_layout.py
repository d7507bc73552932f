# SPDX-License-Identifier: GPL-3.0-or-later
"""Structures and constants of the C headers, written by tools/generate.py."""

import numpy as np

failure = np.dtype(
    [
        ("size", np.uintp),
        ("status", np.intc),
        ("entry", np.intc),
        ("argument", "S64"),
        ("text", "S1024"),
    ],
    align=True,
)
parameter = np.dtype(
    [
        ("name", "S48"),
        ("value", np.float64),
    ],
    align=True,
)
layer = np.dtype(
    [
        ("size", np.uintp),
        ("thickness", np.float64),
        ("E", np.float64),
        ("nu", np.float64),
        ("E_z", np.float64),
        ("nu_tz", np.float64),
        ("G_z", np.float64),
        ("C11", np.float64),
        ("C12", np.float64),
        ("C13", np.float64),
        ("C33", np.float64),
        ("C44", np.float64),
        ("prestress", np.float64),
        ("normal_compliance", np.float64),
        ("tangential_compliance", np.float64),
        ("material", np.uintp),
    ],
    align=True,
)
surface = np.dtype(
    [
        ("size", np.uintp),
        ("tension", np.float64),
        ("bending", np.float64),
        ("stretching", np.float64),
    ],
    align=True,
)
model_facts = np.dtype(
    [
        ("size", np.uintp),
        ("largest_ratio", np.float64),
        ("base", np.intc),
        ("takes_layers", np.intc),
        ("takes_graded", np.intc),
        ("spherical_only", np.intc),
        ("constant", "S24"),
        ("option", "S24"),
        ("default_constant", np.float64),
    ],
    align=True,
)
medium_options = np.dtype(
    [
        ("size", np.uintp),
        ("model", np.intc),
        ("alpha", np.float64),
        ("wave_factor", np.float64),
        ("weight_nu_choice", np.intc),
        ("weight_nu", np.float64),
        ("tolerance", np.float64),
        ("exponent", np.float64),
        ("exponent_is_given", np.intc),
    ],
    align=True,
)
contact_options = np.dtype(
    [
        ("size", np.uintp),
        ("zeta_count", np.intc),
        ("zeta_radius", np.uintp),
        ("zeta", np.uintp),
        ("work_of_adhesion", np.float64),
        ("adhesion_rule", np.intc),
        ("zeta_is_exact", np.intc),
        ("cohesive_stress", np.float64),
    ],
    align=True,
)
state = np.dtype(
    [
        ("depth", np.float64),
        ("radius", np.float64),
        ("force", np.float64),
        ("stiffness", np.float64),
        ("punch_depth", np.float64),
        ("zone_radius", np.float64),
    ],
    align=True,
)
loop_point = np.dtype(
    [
        ("position", np.float64),
        ("depth", np.float64),
        ("radius", np.float64),
        ("force", np.float64),
        ("jumps", np.float64),
    ],
    align=True,
)
loop_facts = np.dtype(
    [
        ("size", np.uintp),
        ("dissipated_energy", np.float64),
        ("points", np.intc),
        ("turning_point", np.intc),
        ("jumps", np.intc),
    ],
    align=True,
)
interior = np.dtype(
    [
        ("u_r", np.float64),
        ("u_t", np.float64),
        ("u_z", np.float64),
        ("s_rr", np.float64),
        ("s_tt", np.float64),
        ("s_zz", np.float64),
        ("s_rz", np.float64),
        ("s_rt", np.float64),
        ("s_tz", np.float64),
    ],
    align=True,
)
maximum = np.dtype(
    [
        ("quantity", np.intc),
        ("place", np.intc),
        ("value", np.float64),
        ("r", np.float64),
        ("z", np.float64),
        ("angle", np.float64),
    ],
    align=True,
)
strength = np.dtype(
    [
        ("quantity", np.intc),
        ("place", np.intc),
        ("value", np.float64),
    ],
    align=True,
)
failure_load = np.dtype(
    [
        ("depth", np.float64),
        ("radius", np.float64),
        ("force", np.float64),
        ("stiffness", np.float64),
        ("punch_depth", np.float64),
        ("zone_radius", np.float64),
        ("quantity", np.intc),
        ("place", np.intc),
        ("strength", np.float64),
        ("value", np.float64),
        ("r", np.float64),
        ("z", np.float64),
        ("angle", np.float64),
    ],
    align=True,
)
shear_state = np.dtype(
    [
        ("shift", np.float64),
        ("tangential_force", np.float64),
        ("stick_radius", np.float64),
        ("stiffness", np.float64),
        ("dissipated_energy", np.float64),
        ("sliding", np.float64),
    ],
    align=True,
)
shear_facts = np.dtype(
    [
        ("size", np.uintp),
        ("sliding_shift", np.float64),
        ("sliding_force", np.float64),
        ("direction", np.intc),
    ],
    align=True,
)
law_options = np.dtype(
    [
        ("size", np.uintp),
        ("smallest_depth", np.float64),
        ("tolerance", np.float64),
        ("description", np.uintp),
        ("continue_beyond", np.intc),
        ("friction", np.uintp),
        ("sliders", np.intc),
        ("shear_strength", np.float64),
        ("conduction", np.uintp),
        ("twist", np.intc),
    ],
    align=True,
)
law_point = np.dtype(
    [
        ("depth", np.float64),
        ("force", np.float64),
        ("slope", np.float64),
        ("radius", np.float64),
        ("stiffness", np.float64),
        ("energy", np.float64),
        ("beyond", np.float64),
    ],
    align=True,
)
law_facts = np.dtype(
    [
        ("size", np.uintp),
        ("lowest_depth", np.float64),
        ("highest_depth", np.float64),
        ("lowest_force", np.float64),
        ("highest_force", np.float64),
        ("tolerance", np.float64),
        ("error", np.float64),
        ("solutions", np.intc),
        ("adhesive", np.intc),
        ("segments", np.intc),
        ("description", np.uintp),
        ("continue_beyond", np.intc),
        ("sliders", np.intc),
        ("memory_size", np.intc),
        ("coefficient", np.float64),
        ("highest_sliding_shift", np.float64),
        ("first_shear_error", np.float64),
        ("path_error", np.float64),
        ("buffer_size", np.intc),
        ("shear_strength", np.float64),
        ("conducts", np.intc),
        ("twists", np.intc),
    ],
    align=True,
)
law_head = np.dtype(
    [
        ("format", np.float64),
        ("size", np.float64),
        ("adhesive", np.float64),
        ("continues", np.float64),
        ("end_radius", np.float64),
        ("lowest", np.float64),
        ("highest", np.float64),
        ("open_loading", np.float64),
        ("open_unloading", np.float64),
        ("first_force", np.float64),
        ("first_radius", np.float64),
        ("force_power", np.float64),
        ("radius_power", np.float64),
        ("force_roots", np.float64),
        ("direct", np.float64),
        ("segment_count", np.float64),
        ("segments", np.float64),
        ("interval_count", np.float64),
        ("intervals", np.float64),
        ("panel_count", np.float64),
        ("force", np.float64),
        ("contact", np.float64),
        ("energy", np.float64),
    ],
    align=True,
)
law_segment = np.dtype(
    [
        ("lowest", np.float64),
        ("highest", np.float64),
        ("first", np.float64),
        ("last", np.float64),
    ],
    align=True,
)
law_interval = np.dtype(
    [
        ("lowest", np.float64),
        ("highest", np.float64),
        ("scale", np.float64),
        ("offset", np.float64),
        ("last_y", np.float64),
        ("is_root", np.float64),
        ("origin", np.float64),
        ("side", np.float64),
        ("smallest_root", np.float64),
        ("bits", np.float64),
        ("first_panel", np.float64),
    ],
    align=True,
)
rate_options = np.dtype(
    [
        ("size", np.uintp),
        ("work", np.float64),
        ("speed", np.float64),
        ("exponent", np.float64),
        ("closing_work", np.float64),
        ("closing_speed", np.float64),
        ("closing_exponent", np.float64),
        ("material", np.uintp),
        ("cohesive_stress", np.float64),
        ("largest_radius", np.float64),
        ("smallest_radius", np.float64),
    ],
    align=True,
)
rate_state = np.dtype(
    [
        ("radius", np.float64),
        ("depth", np.float64),
        ("dissipated", np.float64),
        ("work", np.float64),
        ("lowest_force", np.float64),
        ("lowest_time", np.float64),
        ("lowest_depth", np.float64),
        ("lowest_radius", np.float64),
        ("lowest_speed", np.float64),
        ("rupture_time", np.float64),
        ("rupture_depth", np.float64),
        ("ruptures", np.float64),
        ("force", np.float64),
        ("mark", np.float64),
    ],
    align=True,
)
wear_state = np.dtype(
    [
        ("sliding", np.float64),
        ("depth", np.float64),
        ("radius", np.float64),
        ("force", np.float64),
        ("pressure", np.float64),
        ("worn_depth", np.float64),
        ("worn_volume", np.float64),
        ("body_depth", np.float64),
        ("body_volume", np.float64),
        ("work", np.float64),
        ("error", np.float64),
    ],
    align=True,
)
wear_options = np.dtype(
    [
        ("size", np.uintp),
        ("intervals", np.intc),
        ("places", np.intc),
        ("scheme", np.intc),
    ],
    align=True,
)
conductor = np.dtype(
    [
        ("thickness", np.float64),
        ("sigma", np.float64),
        ("along", np.float64),
        ("capacity", np.float64),
        ("resistance", np.float64),
    ],
    align=True,
)
friction_heat = np.dtype(
    [
        ("total", np.float64),
        ("share", np.float64),
        ("centre", np.float64),
        ("flux_mean", np.float64),
        ("area_mean", np.float64),
        ("largest", np.float64),
        ("behind", np.float64),
    ],
    align=True,
)
imprint_facts = np.dtype(
    [
        ("size", np.uintp),
        ("radius", np.float64),
        ("force", np.float64),
        ("depth", np.float64),
        ("residual_depth", np.float64),
        ("recovered_work", np.float64),
        ("uniform", np.float64),
        ("hertz", np.float64),
        ("misfit", np.float64),
    ],
    align=True,
)
plastic_law_options = np.dtype(
    [
        ("size", np.uintp),
        ("other", np.uintp),
        ("work_of_adhesion", np.float64),
        ("tolerance", np.float64),
    ],
    align=True,
)
plastic_law_facts = np.dtype(
    [
        ("size", np.uintp),
        ("yield_depth", np.float64),
        ("yield_force", np.float64),
        ("first_yield", np.float64),
        ("largest_depth", np.float64),
        ("largest_force", np.float64),
        ("largest_radius", np.float64),
        ("radius", np.float64),
        ("modulus", np.float64),
        ("work_of_adhesion", np.float64),
        ("tolerance", np.float64),
        ("error", np.float64),
        ("memory_size", np.intc),
        ("buffer_size", np.intc),
    ],
    align=True,
)
overload_state = np.dtype(
    [
        ("depth", np.float64),
        ("radius", np.float64),
        ("force", np.float64),
        ("load", np.float64),
        ("uniform", np.float64),
        ("hertz", np.float64),
        ("force_error", np.float64),
        ("depth_error", np.float64),
    ],
    align=True,
)
cap_state = np.dtype(
    [
        ("depth", np.float64),
        ("radius", np.float64),
        ("force", np.float64),
        ("capped_radius", np.float64),
        ("residual_depth", np.float64),
        ("recovered_work", np.float64),
        ("error", np.float64),
    ],
    align=True,
)
structure_options = np.dtype(
    [
        ("size", np.uintp),
        ("reference_nu", np.float64),
        ("tolerance", np.float64),
        ("padded", np.intc),
        ("images", np.intc),
        ("beside_E", np.float64),
        ("beside_nu", np.float64),
        ("origin", np.float64, (2,)),
        ("exponent", np.float64),
        ("reference_nu_is_given", np.intc),
        ("exponent_is_given", np.intc),
    ],
    align=True,
)
fit_parameter = np.dtype(
    [
        ("value", np.float64),
        ("lower", np.float64),
        ("upper", np.float64),
        ("prior", np.float64),
        ("prior_sd", np.float64),
        ("is_free", np.intc),
        ("name", "S48"),
    ],
    align=True,
)
fit_problem = np.dtype(
    [
        ("size", np.uintp),
        ("data_kind", np.intc),
        ("profile", np.uintp),
        ("medium", np.uintp),
        ("counterbody", np.uintp),
        ("adhesion_rule", np.intc),
        ("loss", np.intc),
        ("loss_scale", np.float64),
        ("sd_is_relative", np.intc),
        ("max_iterations", np.intc),
        ("any_units", np.intc),
        ("parameter_count", np.intc),
        ("parameters", np.uintp),
        ("prior_count", np.intc),
        ("prior_weights", np.uintp),
        ("branch", np.uintp),
        ("is_elastic", np.intc),
    ],
    align=True,
)
fit_summary = np.dtype(
    [
        ("size", np.uintp),
        ("converged", np.intc),
        ("iterations", np.intc),
        ("evaluations", np.intc),
        ("chi_square", np.float64),
        ("prior_chi_square", np.float64),
        ("degrees_of_freedom", np.float64),
        ("noise", np.float64),
        ("log_likelihood", np.float64),
        ("pattern_probability", np.float64),
        ("weakest", np.float64),
        ("lag_correlation", np.float64),
    ],
    align=True,
)

SUCCESS = 0
ENULL = 1
EINVALID = 2
EDOMAIN = 3
EUNREACHABLE = 4
ENOCONVERGENCE = 5
ENOMEMORY = 6
ECALLBACK = 7
EFILE = 8
ECANCELLED = 9

DEPTH = 101
FORCE = 102
RADIUS = 103
SPRING = 104
SHIFT = 105
TANGENTIAL_FORCE = 106
TWIST = 107
TORQUE = 108
HEIGHT = 111
HEIGHT_SLOPE = 112
G = 113
G_SLOPE = 114
MODULUS = 121
STIFFNESS = 122
TANGENTIAL_MODULUS = 123
TORSIONAL_STIFFNESS = 124
PRESSURE = 131
DISPLACEMENT = 132
LINE_LOAD = 133
DISPLACEMENT_LOWER = 134
DISPLACEMENT_UPPER = 135
TRACTION = 136
TANGENTIAL_LINE_LOAD = 137
RELAXATION = 141
CREEP = 142
MEAN_RELAXATION = 143
MEAN_CREEP = 144
PARABOLOID_RELAXATION = 145
COMPLEX_MODULUS = 146
STORAGE = 147
LOSS = 148
TOTAL_PRESSURE = 149
PORE_PRESSURE = 150
FLUX = 161
FLUX_Z = 162
FLUX_R = 163
POTENTIAL = 164
CONDUCTANCE = 165
RESISTANCE = 166
MEAN_POTENTIAL = 167
CENTRE_POTENTIAL = 168
GAUSSIAN_POTENTIAL = 169
VON_MISES = 181
TRESCA = 182
TENSION = 183
INTERFACE_SHEAR = 184
INTERFACE_TENSION = 185
FREE_SURFACE_TENSION = 186

LIMIT_GLASSY = 701
LIMIT_RELAXED = 702

LOAD_NORMAL = 901
LOAD_SHEAR = 902
LOAD_TWIST = 903
LOAD_COUPLING = 904

MODEL_GAO = 201
MODEL_GAO_SERIES = 202
MODEL_DOERNER_NIX = 203
MODEL_WAVE = 204
MODEL_MENCIK_EXPONENTIAL = 205
MODEL_MENCIK_RECIPROCAL = 206
MODEL_BEC = 207
MODEL_PERRIOT_BARTHEL = 208
MODEL_HAY_CRAWFORD = 209
MODEL_DIMITRIADIS = 210
MODEL_GARCIA = 211
MODEL_EXACT = 212
MODEL_GAO_POWER = 213

BASE_ELASTIC = 1301
BASE_ANY = 1302
BASE_RIGID = 1303

WEIGHT_NU_SURFACE = 1201
WEIGHT_NU_SUBSTRATE = 1202
WEIGHT_NU_EFFECTIVE = 1203
WEIGHT_NU_GIVEN = 1204

WEIGHT_PHI = 1001
WEIGHT_I0 = 1002
WEIGHT_I1 = 1003
WEIGHT_J0 = 1004
WEIGHT_J1 = 1005
WEIGHT_I0_TANGENTIAL = 1006
WEIGHT_J0_TANGENTIAL = 1007

ADHESION_AUTOMATIC = 801
ADHESION_PAPER = 802
ADHESION_ENERGY = 803

ON_LOADING = 301
ON_UNLOADING = 302

WARNING_SLOPE = 1
WARNING_PRESSURE = 2
WARNING_COMPRESSION = 4
WARNING_CONTRAST = 8
WARNING_SHORT_ZONE = 16
WARNING_WETTING = 32

BODY_LOWER = 401
BODY_UPPER = 402

SIDE_BELOW = 501
SIDE_ABOVE = 502

ALONG = 601
AROUND = 602

LAW_FORMAT = 1296843314

FORM_PARABOLOID_FORCE = 1101
FORM_CONE_FORCE = 1102
FORM_ADHESIVE_DEPTH = 1103
FORM_REDUCED_DEPTH = 1104
FORM_RADIUS_SCALE = 1105
FORM_DEPTH_SCALE = 1106

WEAR_FRESH = 2001
WEAR_SAME = 2002

WEAR_DISC = 2101
WEAR_RINGS = 2102

BASE_HALF_SPACE = 1801
BASE_PERFECT = 1802
BASE_INSULATING = 1803

HEAT_SLIDING = 1901
HEAT_SPINNING = 1902
HEAT_MOVING = 1903

DRAINAGE_SURFACE = 1701
DRAINAGE_SEALED = 1702
DRAINAGE_INDENTER = 1703

SHAPE_LAYER = 1401
SHAPE_HALF_SPACE = 1402
SHAPE_BALL = 1403
SHAPE_FIBRE = 1404
SHAPE_PILLAR = 1405
SHAPE_BOX = 1406

FIT_FORCE_DEPTH = 1501
FIT_STIFFNESS_DEPTH = 1502
FIT_MODULUS_RADIUS = 1503
FIT_STIFFNESS_RADIUS = 1504
FIT_FORCE_TIME = 1505
FIT_DEPTH_TIME = 1506
FIT_DYNAMIC_STIFFNESS = 1507

FIT_WORK_OF_ADHESION = 0
FIT_DEPTH_OFFSET = 1
FIT_FORCE_OFFSET = 2
FIT_FRAME_COMPLIANCE = 3
FIT_INDENTER_MODULUS = 4
FIT_CONTACT_DEPTH_FACTOR = 5
FIT_STIFFNESS_FACTOR = 6
FIT_CONTACT_DEPTH_SCALE = 7
FIT_AREA_FACTOR = 8
FIT_COHESIVE_STRESS = 9
FIT_INSTRUMENT_COUNT = 10

FIT_LINEAR = 1601
FIT_HUBER = 1602
FIT_CAUCHY = 1603

POINTERS = {
    "code_of": (1,),
    "last_failure": (0,),
    "set_cancel": (0, 1),
    "set_progress": (0,),
    "free": (0,),
    "parameters": (0, 2),
    "profile_function": (0, 1),
    "profile_sum": (0,),
    "profile_values": (0,),
    "material_viscoelastic": (2, 3),
    "material_values": (0,),
    "material_limit": (0,),
    "body_layered": (1, 2, 3),
    "body_graded_function": (0, 1, 2),
    "body_wrinkling": (0,),
    "body_compliance": (0,),
    "body_compliance_limits": (0,),
    "response_new": (0,),
    "response_about": (0,),
    "response_point": (0,),
    "response_rectangle": (0,),
    "model_info": (1,),
    "medium_new": (0, 1),
    "medium_pair": (0, 1),
    "medium_function": (0, 1),
    "medium_values": (0,),
    "contact_new": (0, 1, 2),
    "contact_states": (0,),
    "contact_slope": (0,),
    "contact_pull_off": (0,),
    "loop_new": (0,),
    "loop_points": (0,),
    "loop_about": (0, 1),
    "contact_load": (0,),
    "load_energy": (0,),
    "load_field": (0,),
    "load_lowest_pressure": (0,),
    "contact_warnings": (0, 2),
    "load_interior": (0,),
    "load_interior_error": (0,),
    "load_layer_energies": (0,),
    "load_critical": (0, 4),
    "contact_first_failure": (0, 5, 7),
    "friction_new": (0,),
    "shear_new": (0, 1),
    "shear_states": (0,),
    "shear_about": (0, 1),
    "shear_field": (0,),
    "shear_loop": (0,),
    "friction_history_new": (0,),
    "friction_history_copy": (0,),
    "friction_history_advance": (0,),
    "law_new": (0, 2),
    "law_with_radius": (0,),
    "law_force": (0,),
    "law_follow": (0,),
    "law_values": (0, 4, 5, 6, 7, 8, 9),
    "law_about": (0, 1),
    "law_buffer": (0, 2),
    "law_save": (0, 1),
    "law_load": (0,),
    "law_write": (0, 1),
    "law_read": (0,),
    "law_advance": (0, 4, 5),
    "law_energies": (0, 2),
    "law_turn": (0, 2, 3),
    "closed_form": (2,),
    "contact_history": (0,),
    "contact_dynamic_stiffness": (0,),
    "contact_step_response": (0,),
    "rate_new": (0, 1),
    "rate_work": (0,),
    "rate_history": (0,),
    "contact_adhesive_history": (0,),
    "wear_new": (0, 2),
    "wear_limit": (0,),
    "wear_track": (0,),
    "wear_passes": (0,),
    "wear_running_in": (0,),
    "wear_history_new": (0, 3),
    "wear_history_copy": (0,),
    "wear_history_advance": (0,),
    "wear_history_state": (0,),
    "wear_history_profile": (0,),
    "wear_history_save": (0,),
    "wear_history_restore": (0,),
    "conduction_new": (3,),
    "conduction_spot": (0,),
    "conduction_tabulate": (0,),
    "conduction_field": (0, 7),
    "conduction_compliance": (0,),
    "conduction_admittance": (0,),
    "conduction_follow": (0, 4),
    "conduction_rough": (0, 1),
    "conduction_joint_resistance": (0,),
    "conduction_joint": (0, 1),
    "conduction_along": (0, 1),
    "conduction_heat": (0, 1),
    "conduction_heat_field": (0, 1),
    "law_conductance": (0,),
    "poroelastic_response": (0,),
    "poroelastic_history": (0,),
    "poroelastic_dynamic_stiffness": (0,),
    "poroelastic_pressure": (0,),
    "imprint_new": (0,),
    "imprint_two_terms": (0,),
    "imprint_from_pressure": (0,),
    "imprint_profile": (0,),
    "imprint_about": (0, 1),
    "imprint_reverse_yield": (0,),
    "yielding_new": (3,),
    "plastic_law_new": (0, 1, 3),
    "plastic_law_from_points": (5,),
    "plastic_law_with_radius": (0,),
    "plastic_law_about": (0, 1),
    "plastic_law_advance": (0, 3),
    "plastic_law_energies": (0, 2),
    "plastic_law_loading": (0,),
    "plastic_law_restitution": (0,),
    "plastic_law_buffer": (0, 2),
    "overload_new": (0,),
    "overload_states": (0,),
    "plastic_law_from_overload": (0, 2),
    "cap_new": (0,),
    "cap_states": (0,),
    "cap_pressure": (0,),
    "structure_shapes": (6,),
    "structure_voxels": (1, 7),
    "structure_function": (0, 1, 3),
    "structure_modulus": (0,),
    "structure_medium": (0,),
    "fit_parameters": (0, 2),
    "fit_solve": (0, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12),
    "fit_predict": (0, 3, 4),
    "fit_interval": (0, 3, 4),
}
"""Places of pointers among the arguments of a function."""
