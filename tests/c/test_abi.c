/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The binary interface of the last release, written by tools/record_abi.py. Programs compiled against that release no longer run
   if a declaration or an assertion does not compile, or if the linker or dlvsym does not find a function. */
#define _GNU_SOURCE
#include <dlfcn.h>
#include <stddef.h>
#include <stdio.h>

#include "mdrcontact/all.h"
#include "mdrcontact_law.h"
#ifdef MDRCONTACT_PLASTIC_H
#  include "mdrcontact_plastic_law.h"
#endif

#define EXACT(type, bytes) _Static_assert(sizeof(type) == (bytes), #type)
#define GROWS(type, bytes) _Static_assert(sizeof(type) >= (bytes), #type)
#define MEMBER(type, member, place, kind) \
    _Static_assert(offsetof(type, member) == (place) && _Generic(&((type *)0)->member, kind: 1, default: 0), #type "." #member)
#define VALUE(name, value) _Static_assert((name) == (value), #name)

#ifdef MDRCONTACT_BASE_H
typedef int (*mdr_cancel)(void *context);
typedef int (*mdr_function)(double x, double *y, void *context);
VALUE(MDR_SUCCESS, 0);
VALUE(MDR_ENULL, 1);
VALUE(MDR_EINVALID, 2);
VALUE(MDR_EDOMAIN, 3);
VALUE(MDR_EUNREACHABLE, 4);
VALUE(MDR_ENOCONVERGENCE, 5);
VALUE(MDR_ENOMEMORY, 6);
VALUE(MDR_ECALLBACK, 7);
VALUE(MDR_EFILE, 8);
VALUE(MDR_ECANCELLED, 9);
VALUE(MDR_DEPTH, 101);
VALUE(MDR_FORCE, 102);
VALUE(MDR_RADIUS, 103);
VALUE(MDR_SPRING, 104);
VALUE(MDR_SHIFT, 105);
VALUE(MDR_TANGENTIAL_FORCE, 106);
VALUE(MDR_TWIST, 107);
VALUE(MDR_TORQUE, 108);
VALUE(MDR_HEIGHT, 111);
VALUE(MDR_HEIGHT_SLOPE, 112);
VALUE(MDR_G, 113);
VALUE(MDR_G_SLOPE, 114);
VALUE(MDR_MODULUS, 121);
VALUE(MDR_STIFFNESS, 122);
VALUE(MDR_TANGENTIAL_MODULUS, 123);
VALUE(MDR_TORSIONAL_STIFFNESS, 124);
VALUE(MDR_PRESSURE, 131);
VALUE(MDR_DISPLACEMENT, 132);
VALUE(MDR_LINE_LOAD, 133);
VALUE(MDR_DISPLACEMENT_LOWER, 134);
VALUE(MDR_DISPLACEMENT_UPPER, 135);
VALUE(MDR_TRACTION, 136);
VALUE(MDR_TANGENTIAL_LINE_LOAD, 137);
VALUE(MDR_RELAXATION, 141);
VALUE(MDR_CREEP, 142);
VALUE(MDR_MEAN_RELAXATION, 143);
VALUE(MDR_MEAN_CREEP, 144);
VALUE(MDR_PARABOLOID_RELAXATION, 145);
VALUE(MDR_COMPLEX_MODULUS, 146);
VALUE(MDR_STORAGE, 147);
VALUE(MDR_LOSS, 148);
VALUE(MDR_TOTAL_PRESSURE, 149);
VALUE(MDR_PORE_PRESSURE, 150);
VALUE(MDR_FLUX, 161);
VALUE(MDR_FLUX_Z, 162);
VALUE(MDR_FLUX_R, 163);
VALUE(MDR_POTENTIAL, 164);
VALUE(MDR_CONDUCTANCE, 165);
VALUE(MDR_RESISTANCE, 166);
VALUE(MDR_MEAN_POTENTIAL, 167);
VALUE(MDR_CENTRE_POTENTIAL, 168);
VALUE(MDR_GAUSSIAN_POTENTIAL, 169);
VALUE(MDR_VON_MISES, 181);
VALUE(MDR_TRESCA, 182);
VALUE(MDR_TENSION, 183);
VALUE(MDR_INTERFACE_SHEAR, 184);
VALUE(MDR_INTERFACE_TENSION, 185);
VALUE(MDR_FREE_SURFACE_TENSION, 186);
GROWS(mdr_failure, 1104);
MEMBER(mdr_failure, size, 0, size_t *);
MEMBER(mdr_failure, status, 8, int *);
MEMBER(mdr_failure, entry, 12, int *);
MEMBER(mdr_failure, argument, 16, char (*)[64]);
MEMBER(mdr_failure, text, 80, char (*)[1024]);
EXACT(mdr_parameter, 56);
MEMBER(mdr_parameter, name, 0, char (*)[48]);
MEMBER(mdr_parameter, value, 48, double *);
int mdr_version(void);
const char *mdr_name_of(int code);
int mdr_code_of(int enumeration, const char *name, int *code);
const char *mdr_last_error(void);
int mdr_last_failure(mdr_failure *failure);
int mdr_set_threads(int threads);
int mdr_set_cancel(mdr_cancel cancel, void *context);
int mdr_set_progress(double part[]);
int mdr_free(void *handle);
int mdr_parameters(const void *object, int capacity, mdr_parameter out[], int *count);
#endif
#ifdef MDRCONTACT_PROFILE_H
typedef struct mdr_profile mdr_profile;
int mdr_profile_paraboloid(double radius, mdr_profile **out);
int mdr_profile_sphere(double radius, mdr_profile **out);
int mdr_profile_cone(double inclination, mdr_profile **out);
int mdr_profile_power(double exponent, double coefficient, mdr_profile **out);
int mdr_profile_flat_punch(double radius, mdr_profile **out);
int mdr_profile_flat_cone(double end_radius, double inclination, mdr_profile **out);
int mdr_profile_flat_paraboloid(double end_radius, double radius, mdr_profile **out);
int mdr_profile_rounded_cone(double blend_radius, double inclination, mdr_profile **out);
int mdr_profile_area_function(int n, const double coefficients[], double min_height, double max_height, mdr_profile **out);
int mdr_profile_table(int quantity, int n, const double x[], const double y[], mdr_profile **out);
int mdr_profile_function(mdr_function height, void *context, double largest_radius, mdr_profile **out);
int mdr_profile_sum(int n, const mdr_profile *const terms[], mdr_profile **out);
int mdr_profile_values(const mdr_profile *p, int quantity, int n, const double x[], double out[]);
#endif
#ifdef MDRCONTACT_MATERIAL_H
typedef struct mdr_material mdr_material;
VALUE(MDR_LIMIT_GLASSY, 701);
VALUE(MDR_LIMIT_RELAXED, 702);
int mdr_material_viscoelastic(double relaxed_shear_modulus, int n, const double moduli[], const double times[], double viscosity, double nu, double bulk_modulus, mdr_material **out);
int mdr_material_power_law(double modulus, double time, double exponent, double nu, mdr_material **out);
int mdr_material_values(const mdr_material *m, int quantity, int n, const double x[], double out[], double imaginary[]);
int mdr_material_limit(const mdr_material *m, int limit, double *E, double *nu);
#endif
#ifdef MDRCONTACT_BODY_H
typedef struct mdr_body mdr_body;
typedef struct mdr_response mdr_response;
VALUE(MDR_LOAD_NORMAL, 901);
VALUE(MDR_LOAD_SHEAR, 902);
VALUE(MDR_LOAD_TWIST, 903);
VALUE(MDR_LOAD_COUPLING, 904);
GROWS(mdr_layer, 128);
MEMBER(mdr_layer, size, 0, size_t *);
MEMBER(mdr_layer, thickness, 8, double *);
MEMBER(mdr_layer, E, 16, double *);
MEMBER(mdr_layer, nu, 24, double *);
MEMBER(mdr_layer, E_z, 32, double *);
MEMBER(mdr_layer, nu_tz, 40, double *);
MEMBER(mdr_layer, G_z, 48, double *);
MEMBER(mdr_layer, C11, 56, double *);
MEMBER(mdr_layer, C12, 64, double *);
MEMBER(mdr_layer, C13, 72, double *);
MEMBER(mdr_layer, C33, 80, double *);
MEMBER(mdr_layer, C44, 88, double *);
MEMBER(mdr_layer, prestress, 96, double *);
MEMBER(mdr_layer, normal_compliance, 104, double *);
MEMBER(mdr_layer, tangential_compliance, 112, double *);
MEMBER(mdr_layer, material, 120, const mdr_material **);
GROWS(mdr_surface, 32);
MEMBER(mdr_surface, size, 0, size_t *);
MEMBER(mdr_surface, tension, 8, double *);
MEMBER(mdr_surface, bending, 16, double *);
MEMBER(mdr_surface, stretching, 24, double *);
int mdr_body_layered(int n, const mdr_layer *layers, const mdr_layer *substrate, const mdr_surface *surface, mdr_body **out);
int mdr_body_graded(int n, const double z[], const double E[], const double nu[], mdr_body **out);
int mdr_body_graded_function(mdr_function E, mdr_function nu, void *context, double depth, mdr_body **out);
int mdr_body_power_graded(double E0, double z0, double exponent, double nu, mdr_body **out);
int mdr_body_rigid(mdr_body **out);
int mdr_body_wrinkling(const mdr_body *body, int layer, double *stress, double *wavelength);
int mdr_body_compliance(const mdr_body *body, int load, int n, const double k[], const double omega[], double out[], double imaginary[]);
int mdr_body_compliance_limits(const mdr_body *body, double omega, double out[3], double imaginary[3]);
int mdr_response_new(const mdr_body *body, double tolerance, mdr_response **out);
int mdr_response_about(const mdr_response *response, double *tolerance, int *images);
int mdr_response_point(const mdr_response *response, int n, const double r[], double out[]);
int mdr_response_rectangle(const mdr_response *response, double width, double height, int n, const double x[], const double y[], double out[]);
#endif
#ifdef MDRCONTACT_MEDIUM_H
typedef struct mdr_medium mdr_medium;
VALUE(MDR_MODEL_GAO, 201);
VALUE(MDR_MODEL_GAO_SERIES, 202);
VALUE(MDR_MODEL_DOERNER_NIX, 203);
VALUE(MDR_MODEL_WAVE, 204);
VALUE(MDR_MODEL_MENCIK_EXPONENTIAL, 205);
VALUE(MDR_MODEL_MENCIK_RECIPROCAL, 206);
VALUE(MDR_MODEL_BEC, 207);
VALUE(MDR_MODEL_PERRIOT_BARTHEL, 208);
VALUE(MDR_MODEL_HAY_CRAWFORD, 209);
VALUE(MDR_MODEL_DIMITRIADIS, 210);
VALUE(MDR_MODEL_GARCIA, 211);
VALUE(MDR_MODEL_EXACT, 212);
VALUE(MDR_MODEL_GAO_POWER, 213);
VALUE(MDR_BASE_ELASTIC, 1301);
VALUE(MDR_BASE_ANY, 1302);
VALUE(MDR_BASE_RIGID, 1303);
VALUE(MDR_WEIGHT_NU_SURFACE, 1201);
VALUE(MDR_WEIGHT_NU_SUBSTRATE, 1202);
VALUE(MDR_WEIGHT_NU_EFFECTIVE, 1203);
VALUE(MDR_WEIGHT_NU_GIVEN, 1204);
GROWS(mdr_model_facts, 88);
MEMBER(mdr_model_facts, size, 0, size_t *);
MEMBER(mdr_model_facts, largest_ratio, 8, double *);
MEMBER(mdr_model_facts, base, 16, int *);
MEMBER(mdr_model_facts, takes_layers, 20, int *);
MEMBER(mdr_model_facts, takes_graded, 24, int *);
MEMBER(mdr_model_facts, spherical_only, 28, int *);
MEMBER(mdr_model_facts, constant, 32, char (*)[24]);
MEMBER(mdr_model_facts, option, 56, char (*)[24]);
MEMBER(mdr_model_facts, default_constant, 80, double *);
GROWS(mdr_medium_options, 72);
MEMBER(mdr_medium_options, size, 0, size_t *);
MEMBER(mdr_medium_options, model, 8, int *);
MEMBER(mdr_medium_options, alpha, 16, double *);
MEMBER(mdr_medium_options, wave_factor, 24, double *);
MEMBER(mdr_medium_options, weight_nu_choice, 32, int *);
MEMBER(mdr_medium_options, weight_nu, 40, double *);
MEMBER(mdr_medium_options, tolerance, 48, double *);
MEMBER(mdr_medium_options, exponent, 56, double *);
MEMBER(mdr_medium_options, exponent_is_given, 64, int *);
int mdr_model_info(int model, mdr_model_facts *facts);
int mdr_medium_contact_modulus(double contact_modulus, mdr_medium **out);
int mdr_medium_new(const mdr_body *body, const mdr_medium_options *options, mdr_medium **out);
int mdr_medium_pair(const mdr_medium *lower, const mdr_medium *upper, mdr_medium **out);
int mdr_medium_table(int n, const double a[], const double moduli[], mdr_medium **out);
int mdr_medium_function(mdr_function modulus, void *context, double smallest_radius, double largest_radius, mdr_medium **out);
int mdr_medium_values(const mdr_medium *m, int quantity, int n, const double a[], double out[]);
#endif
#ifdef MDRCONTACT_WEIGHTS_H
VALUE(MDR_WEIGHT_PHI, 1001);
VALUE(MDR_WEIGHT_I0, 1002);
VALUE(MDR_WEIGHT_I1, 1003);
VALUE(MDR_WEIGHT_J0, 1004);
VALUE(MDR_WEIGHT_J1, 1005);
VALUE(MDR_WEIGHT_I0_TANGENTIAL, 1006);
VALUE(MDR_WEIGHT_J0_TANGENTIAL, 1007);
int mdr_weight(int weight, double nu, int n, const double xi[], double out[]);
#endif
#ifdef MDRCONTACT_CONTACT_H
typedef struct mdr_contact mdr_contact;
typedef struct mdr_loop mdr_loop;
typedef struct mdr_load mdr_load;
VALUE(MDR_ADHESION_AUTOMATIC, 801);
VALUE(MDR_ADHESION_PAPER, 802);
VALUE(MDR_ADHESION_ENERGY, 803);
VALUE(MDR_ON_LOADING, 301);
VALUE(MDR_ON_UNLOADING, 302);
VALUE(MDR_WARNING_SLOPE, 1);
VALUE(MDR_WARNING_PRESSURE, 2);
VALUE(MDR_WARNING_COMPRESSION, 4);
VALUE(MDR_WARNING_CONTRAST, 8);
VALUE(MDR_WARNING_SHORT_ZONE, 16);
VALUE(MDR_WARNING_WETTING, 32);
VALUE(MDR_BODY_LOWER, 401);
VALUE(MDR_BODY_UPPER, 402);
VALUE(MDR_SIDE_BELOW, 501);
VALUE(MDR_SIDE_ABOVE, 502);
GROWS(mdr_contact_options, 56);
MEMBER(mdr_contact_options, size, 0, size_t *);
MEMBER(mdr_contact_options, zeta_count, 8, int *);
MEMBER(mdr_contact_options, zeta_radius, 16, const double **);
MEMBER(mdr_contact_options, zeta, 24, const double **);
MEMBER(mdr_contact_options, work_of_adhesion, 32, double *);
MEMBER(mdr_contact_options, adhesion_rule, 40, int *);
MEMBER(mdr_contact_options, zeta_is_exact, 44, int *);
MEMBER(mdr_contact_options, cohesive_stress, 48, double *);
EXACT(mdr_state, 48);
MEMBER(mdr_state, depth, 0, double *);
MEMBER(mdr_state, radius, 8, double *);
MEMBER(mdr_state, force, 16, double *);
MEMBER(mdr_state, stiffness, 24, double *);
MEMBER(mdr_state, punch_depth, 32, double *);
MEMBER(mdr_state, zone_radius, 40, double *);
EXACT(mdr_loop_point, 40);
MEMBER(mdr_loop_point, position, 0, double *);
MEMBER(mdr_loop_point, depth, 8, double *);
MEMBER(mdr_loop_point, radius, 16, double *);
MEMBER(mdr_loop_point, force, 24, double *);
MEMBER(mdr_loop_point, jumps, 32, double *);
GROWS(mdr_loop_facts, 32);
MEMBER(mdr_loop_facts, size, 0, size_t *);
MEMBER(mdr_loop_facts, dissipated_energy, 8, double *);
MEMBER(mdr_loop_facts, points, 16, int *);
MEMBER(mdr_loop_facts, turning_point, 20, int *);
MEMBER(mdr_loop_facts, jumps, 24, int *);
EXACT(mdr_interior, 72);
MEMBER(mdr_interior, u_r, 0, double *);
MEMBER(mdr_interior, u_t, 8, double *);
MEMBER(mdr_interior, u_z, 16, double *);
MEMBER(mdr_interior, s_rr, 24, double *);
MEMBER(mdr_interior, s_tt, 32, double *);
MEMBER(mdr_interior, s_zz, 40, double *);
MEMBER(mdr_interior, s_rz, 48, double *);
MEMBER(mdr_interior, s_rt, 56, double *);
MEMBER(mdr_interior, s_tz, 64, double *);
EXACT(mdr_maximum, 40);
MEMBER(mdr_maximum, quantity, 0, int *);
MEMBER(mdr_maximum, place, 4, int *);
MEMBER(mdr_maximum, value, 8, double *);
MEMBER(mdr_maximum, r, 16, double *);
MEMBER(mdr_maximum, z, 24, double *);
MEMBER(mdr_maximum, angle, 32, double *);
EXACT(mdr_strength, 16);
MEMBER(mdr_strength, quantity, 0, int *);
MEMBER(mdr_strength, place, 4, int *);
MEMBER(mdr_strength, value, 8, double *);
EXACT(mdr_failure_load, 96);
MEMBER(mdr_failure_load, depth, 0, double *);
MEMBER(mdr_failure_load, radius, 8, double *);
MEMBER(mdr_failure_load, force, 16, double *);
MEMBER(mdr_failure_load, stiffness, 24, double *);
MEMBER(mdr_failure_load, punch_depth, 32, double *);
MEMBER(mdr_failure_load, zone_radius, 40, double *);
MEMBER(mdr_failure_load, quantity, 48, int *);
MEMBER(mdr_failure_load, place, 52, int *);
MEMBER(mdr_failure_load, strength, 56, double *);
MEMBER(mdr_failure_load, value, 64, double *);
MEMBER(mdr_failure_load, r, 72, double *);
MEMBER(mdr_failure_load, z, 80, double *);
MEMBER(mdr_failure_load, angle, 88, double *);
int mdr_contact_new(const mdr_profile *profile, const mdr_medium *medium, const mdr_contact_options *options, mdr_contact **out);
int mdr_contact_states(const mdr_contact *c, int given, int branch, int n, const double in[], mdr_state out[]);
int mdr_contact_slope(const mdr_contact *c, int n, const mdr_state states[], double out[]);
int mdr_contact_pull_off(const mdr_contact *c, int control, int capacity, mdr_state out[], int *count);
int mdr_loop_new(const mdr_contact *c, int control, double largest, int points, double spring_stiffness, mdr_loop **out);
int mdr_loop_points(const mdr_loop *l, int capacity, mdr_loop_point out[], int *count);
int mdr_loop_about(const mdr_loop *l, mdr_loop_facts *facts);
int mdr_contact_load(const mdr_contact *c, const mdr_state *state, mdr_load **out);
int mdr_load_energy(const mdr_load *load, double *lower, double *upper);
int mdr_load_field(const mdr_load *load, int field, int n, const double r[], double out[]);
int mdr_load_lowest_pressure(const mdr_load *load, double *pressure, double *r);
int mdr_contact_warnings(const mdr_contact *c, const mdr_state *state, char *buffer, int length, int *warnings);
int mdr_load_interior(const mdr_load *load, int body, int side, double friction, int n, const double r[], const double z[], const double angle[], mdr_interior out[]);
int mdr_load_interior_error(const mdr_load *load, int body, double *deviation);
int mdr_load_layer_energies(const mdr_load *load, int body, int capacity, double out[], int *count);
int mdr_load_critical(const mdr_load *load, int body, double friction, int capacity, mdr_maximum out[], int *count);
int mdr_contact_first_failure(const mdr_contact *c, int body, double friction, double largest_radius, int n, const mdr_strength strengths[], int capacity, mdr_failure_load out[], int *count);
#endif
#ifdef MDRCONTACT_FRICTION_H
typedef struct mdr_friction mdr_friction;
typedef struct mdr_shear mdr_shear;
typedef struct mdr_friction_history mdr_friction_history;
VALUE(MDR_ALONG, 601);
VALUE(MDR_AROUND, 602);
EXACT(mdr_shear_state, 48);
MEMBER(mdr_shear_state, shift, 0, double *);
MEMBER(mdr_shear_state, tangential_force, 8, double *);
MEMBER(mdr_shear_state, stick_radius, 16, double *);
MEMBER(mdr_shear_state, stiffness, 24, double *);
MEMBER(mdr_shear_state, dissipated_energy, 32, double *);
MEMBER(mdr_shear_state, sliding, 40, double *);
GROWS(mdr_shear_facts, 32);
MEMBER(mdr_shear_facts, size, 0, size_t *);
MEMBER(mdr_shear_facts, sliding_shift, 8, double *);
MEMBER(mdr_shear_facts, sliding_force, 16, double *);
MEMBER(mdr_shear_facts, direction, 24, int *);
int mdr_friction_new(const mdr_contact *c, double coefficient, mdr_friction **out);
int mdr_shear_new(const mdr_friction *f, const mdr_load *load, int direction, mdr_shear **out);
int mdr_shear_states(const mdr_shear *s, int given, int n, const double in[], mdr_shear_state out[]);
int mdr_shear_about(const mdr_shear *s, mdr_shear_facts *facts);
int mdr_shear_field(const mdr_shear *s, const mdr_shear_state *at, int field, int n, const double r[], double out[]);
int mdr_shear_loop(const mdr_shear *s, int given, double amplitude, int n, double shift[], double force[], double *dissipated);
int mdr_friction_history_new(const mdr_friction *f, double largest_depth, int rings, mdr_friction_history **out);
int mdr_friction_history_copy(const mdr_friction_history *h, mdr_friction_history **out);
int mdr_friction_history_advance(mdr_friction_history *h, int normal_given, int tangential_given, int n, const double normal[], const double tangential[], mdr_state states[], mdr_shear_state out[]);
#endif
#ifdef MDRCONTACT_LAW_H
typedef struct mdr_law mdr_law;
VALUE(MDR_LAW_FORMAT, 1296843314);
GROWS(mdr_law_options, 80);
MEMBER(mdr_law_options, size, 0, size_t *);
MEMBER(mdr_law_options, smallest_depth, 8, double *);
MEMBER(mdr_law_options, tolerance, 16, double *);
MEMBER(mdr_law_options, description, 24, const char **);
MEMBER(mdr_law_options, continue_beyond, 32, int *);
MEMBER(mdr_law_options, friction, 40, const mdr_friction **);
MEMBER(mdr_law_options, sliders, 48, int *);
MEMBER(mdr_law_options, shear_strength, 56, double *);
MEMBER(mdr_law_options, conduction, 64, const struct mdr_conduction **);
MEMBER(mdr_law_options, twist, 72, int *);
EXACT(mdr_law_point, 56);
MEMBER(mdr_law_point, depth, 0, double *);
MEMBER(mdr_law_point, force, 8, double *);
MEMBER(mdr_law_point, slope, 16, double *);
MEMBER(mdr_law_point, radius, 24, double *);
MEMBER(mdr_law_point, stiffness, 32, double *);
MEMBER(mdr_law_point, energy, 40, double *);
MEMBER(mdr_law_point, beyond, 48, double *);
GROWS(mdr_law_facts, 152);
MEMBER(mdr_law_facts, size, 0, size_t *);
MEMBER(mdr_law_facts, lowest_depth, 8, double *);
MEMBER(mdr_law_facts, highest_depth, 16, double *);
MEMBER(mdr_law_facts, lowest_force, 24, double *);
MEMBER(mdr_law_facts, highest_force, 32, double *);
MEMBER(mdr_law_facts, tolerance, 40, double *);
MEMBER(mdr_law_facts, error, 48, double *);
MEMBER(mdr_law_facts, solutions, 56, int *);
MEMBER(mdr_law_facts, adhesive, 60, int *);
MEMBER(mdr_law_facts, segments, 64, int *);
MEMBER(mdr_law_facts, description, 72, const char **);
MEMBER(mdr_law_facts, continue_beyond, 80, int *);
MEMBER(mdr_law_facts, sliders, 84, int *);
MEMBER(mdr_law_facts, memory_size, 88, int *);
MEMBER(mdr_law_facts, coefficient, 96, double *);
MEMBER(mdr_law_facts, highest_sliding_shift, 104, double *);
MEMBER(mdr_law_facts, first_shear_error, 112, double *);
MEMBER(mdr_law_facts, path_error, 120, double *);
MEMBER(mdr_law_facts, buffer_size, 128, int *);
MEMBER(mdr_law_facts, shear_strength, 136, double *);
MEMBER(mdr_law_facts, conducts, 144, int *);
MEMBER(mdr_law_facts, twists, 148, int *);
EXACT(mdr_law_head, 184);
MEMBER(mdr_law_head, format, 0, double *);
MEMBER(mdr_law_head, size, 8, double *);
MEMBER(mdr_law_head, adhesive, 16, double *);
MEMBER(mdr_law_head, continues, 24, double *);
MEMBER(mdr_law_head, end_radius, 32, double *);
MEMBER(mdr_law_head, lowest, 40, double *);
MEMBER(mdr_law_head, highest, 48, double *);
MEMBER(mdr_law_head, open_loading, 56, double *);
MEMBER(mdr_law_head, open_unloading, 64, double *);
MEMBER(mdr_law_head, first_force, 72, double *);
MEMBER(mdr_law_head, first_radius, 80, double *);
MEMBER(mdr_law_head, force_power, 88, double *);
MEMBER(mdr_law_head, radius_power, 96, double *);
MEMBER(mdr_law_head, force_roots, 104, double *);
MEMBER(mdr_law_head, direct, 112, double *);
MEMBER(mdr_law_head, segment_count, 120, double *);
MEMBER(mdr_law_head, segments, 128, double *);
MEMBER(mdr_law_head, interval_count, 136, double *);
MEMBER(mdr_law_head, intervals, 144, double *);
MEMBER(mdr_law_head, panel_count, 152, double *);
MEMBER(mdr_law_head, force, 160, double *);
MEMBER(mdr_law_head, contact, 168, double *);
MEMBER(mdr_law_head, energy, 176, double *);
EXACT(mdr_law_segment, 32);
MEMBER(mdr_law_segment, lowest, 0, double *);
MEMBER(mdr_law_segment, highest, 8, double *);
MEMBER(mdr_law_segment, first, 16, double *);
MEMBER(mdr_law_segment, last, 24, double *);
EXACT(mdr_law_interval, 88);
MEMBER(mdr_law_interval, lowest, 0, double *);
MEMBER(mdr_law_interval, highest, 8, double *);
MEMBER(mdr_law_interval, scale, 16, double *);
MEMBER(mdr_law_interval, offset, 24, double *);
MEMBER(mdr_law_interval, last_y, 32, double *);
MEMBER(mdr_law_interval, is_root, 40, double *);
MEMBER(mdr_law_interval, origin, 48, double *);
MEMBER(mdr_law_interval, side, 56, double *);
MEMBER(mdr_law_interval, smallest_root, 64, double *);
MEMBER(mdr_law_interval, bits, 72, double *);
MEMBER(mdr_law_interval, first_panel, 80, double *);
int mdr_law_new(const mdr_contact *contact, double largest_depth, const mdr_law_options *options, mdr_law **out);
int mdr_law_with_radius(const mdr_law *law, double radius, mdr_law **out);
int mdr_law_force(const mdr_law *law, int branch, double d, double *F, double *slope);
int mdr_law_follow(const mdr_law *law, double d, int *segment, mdr_law_point *point);
int mdr_law_values(const mdr_law *law, int given, int branch, int n, const double in[], double d[], double a[], double F[], double k[], double slope[], double energy[]);
int mdr_law_about(const mdr_law *law, mdr_law_facts *facts);
int mdr_law_buffer(const mdr_law *law, int size, double buffer[]);
int mdr_law_save(const mdr_law *law, const char *path);
int mdr_law_load(const char *path, mdr_law **out);
int mdr_law_write(const mdr_law *law, char *buffer, int length, int *full_length);
int mdr_law_read(const char *buffer, int length, mdr_law **out);
int mdr_law_advance(const mdr_law *law, int n, const double force[], const double shift[], int is_trial, double tangent[], double memory[], double T[]);
int mdr_law_energies(const mdr_law *law, int n, const double memory[], double stored[], double dissipated[]);
int mdr_law_turn(const mdr_law *law, int n, const double normal[], const double spin[], double memory[]);
#endif
#ifdef MDRCONTACT_CLOSED_FORMS_H
VALUE(MDR_FORM_PARABOLOID_FORCE, 1101);
VALUE(MDR_FORM_CONE_FORCE, 1102);
VALUE(MDR_FORM_ADHESIVE_DEPTH, 1103);
VALUE(MDR_FORM_REDUCED_DEPTH, 1104);
VALUE(MDR_FORM_RADIUS_SCALE, 1105);
VALUE(MDR_FORM_DEPTH_SCALE, 1106);
int mdr_closed_form(int formula, int n, const double x[], const double constants[], double out[]);
#endif
#ifdef MDRCONTACT_TIME_H
int mdr_contact_history(const mdr_contact *c, int given, double tolerance, int n, const double time[], const double in[], double d[], double a[], double F[]);
int mdr_contact_dynamic_stiffness(const mdr_contact *c, int n, const double omega[], const double radius[], double storage[], double loss[]);
int mdr_contact_step_response(const mdr_contact *c, int step, double radius, int n, const double time[], double out[]);
#endif
#ifdef MDRCONTACT_ADHESION_H
typedef struct mdr_rate mdr_rate;
GROWS(mdr_rate_options, 88);
MEMBER(mdr_rate_options, size, 0, size_t *);
MEMBER(mdr_rate_options, work, 8, double *);
MEMBER(mdr_rate_options, speed, 16, double *);
MEMBER(mdr_rate_options, exponent, 24, double *);
MEMBER(mdr_rate_options, closing_work, 32, double *);
MEMBER(mdr_rate_options, closing_speed, 40, double *);
MEMBER(mdr_rate_options, closing_exponent, 48, double *);
MEMBER(mdr_rate_options, material, 56, const mdr_material **);
MEMBER(mdr_rate_options, cohesive_stress, 64, double *);
MEMBER(mdr_rate_options, largest_radius, 72, double *);
MEMBER(mdr_rate_options, smallest_radius, 80, double *);
EXACT(mdr_rate_state, 112);
MEMBER(mdr_rate_state, radius, 0, double *);
MEMBER(mdr_rate_state, depth, 8, double *);
MEMBER(mdr_rate_state, dissipated, 16, double *);
MEMBER(mdr_rate_state, work, 24, double *);
MEMBER(mdr_rate_state, lowest_force, 32, double *);
MEMBER(mdr_rate_state, lowest_time, 40, double *);
MEMBER(mdr_rate_state, lowest_depth, 48, double *);
MEMBER(mdr_rate_state, lowest_radius, 56, double *);
MEMBER(mdr_rate_state, lowest_speed, 64, double *);
MEMBER(mdr_rate_state, rupture_time, 72, double *);
MEMBER(mdr_rate_state, rupture_depth, 80, double *);
MEMBER(mdr_rate_state, ruptures, 88, double *);
MEMBER(mdr_rate_state, force, 96, double *);
MEMBER(mdr_rate_state, mark, 104, double *);
int mdr_rate_new(const mdr_contact *c, const mdr_rate_options *options, mdr_rate **out);
int mdr_rate_work(const mdr_rate_options *options, int n, const double v[], double out[], double *time, double *zone);
int mdr_rate_history(const mdr_rate *r, int control, double spring_stiffness, double tolerance, const mdr_rate_state *start, int n, const double time[], const double in[], double d[], double a[], double F[], double v[], double dissipated[], double work[], mdr_rate_state *end);
int mdr_contact_adhesive_history(const mdr_contact *c, int control, double spring_stiffness, double tolerance, const mdr_rate_state *start, int n, const double time[], const double in[], double d[], double a[], double zone_radius[], double F[], mdr_rate_state *end);
#endif
#ifdef MDRCONTACT_WEAR_H
typedef struct mdr_wear mdr_wear;
typedef struct mdr_wear_history mdr_wear_history;
VALUE(MDR_WEAR_FRESH, 2001);
VALUE(MDR_WEAR_SAME, 2002);
VALUE(MDR_WEAR_DISC, 2101);
VALUE(MDR_WEAR_RINGS, 2102);
EXACT(mdr_wear_state, 88);
MEMBER(mdr_wear_state, sliding, 0, double *);
MEMBER(mdr_wear_state, depth, 8, double *);
MEMBER(mdr_wear_state, radius, 16, double *);
MEMBER(mdr_wear_state, force, 24, double *);
MEMBER(mdr_wear_state, pressure, 32, double *);
MEMBER(mdr_wear_state, worn_depth, 40, double *);
MEMBER(mdr_wear_state, worn_volume, 48, double *);
MEMBER(mdr_wear_state, body_depth, 56, double *);
MEMBER(mdr_wear_state, body_volume, 64, double *);
MEMBER(mdr_wear_state, work, 72, double *);
MEMBER(mdr_wear_state, error, 80, double *);
GROWS(mdr_wear_options, 24);
MEMBER(mdr_wear_options, size, 0, size_t *);
MEMBER(mdr_wear_options, intervals, 8, int *);
MEMBER(mdr_wear_options, places, 12, int *);
MEMBER(mdr_wear_options, scheme, 16, int *);
int mdr_wear_new(const mdr_contact *c, int n, const double coefficient[], const double thickness[], double body_coefficient, mdr_wear **out);
int mdr_wear_limit(const mdr_wear *w, const mdr_state *state, double stick_radius, int given, mdr_state *reached, double *outer_radius, double *worn_volume, mdr_profile **out);
int mdr_wear_track(const mdr_wear *w, const mdr_state *state, double passes, int n, const double y[], double out[]);
int mdr_wear_passes(const mdr_wear *w, const mdr_state *state, double depth, double *passes);
int mdr_wear_running_in(const mdr_wear *w, int given, double *length);
int mdr_wear_history_new(const mdr_wear *w, int given, double value, const mdr_wear_options *options, mdr_wear_history **out);
int mdr_wear_history_copy(const mdr_wear_history *h, mdr_wear_history **out);
int mdr_wear_history_advance(mdr_wear_history *h, int given, int n, const double sliding[], const double value[], mdr_wear_state out[]);
int mdr_wear_history_state(const mdr_wear_history *h, int n, const double r[], mdr_wear_state *out, double pressure[]);
int mdr_wear_history_profile(const mdr_wear_history *h, mdr_profile **out);
int mdr_wear_history_save(const mdr_wear_history *h, int capacity, double numbers[], int *count);
int mdr_wear_history_restore(mdr_wear_history *h, int n, const double numbers[]);
#endif
#ifdef MDRCONTACT_CONDUCTION_H
typedef struct mdr_conduction mdr_conduction;
VALUE(MDR_BASE_HALF_SPACE, 1801);
VALUE(MDR_BASE_PERFECT, 1802);
VALUE(MDR_BASE_INSULATING, 1803);
VALUE(MDR_HEAT_SLIDING, 1901);
VALUE(MDR_HEAT_SPINNING, 1902);
VALUE(MDR_HEAT_MOVING, 1903);
EXACT(mdr_conductor, 40);
MEMBER(mdr_conductor, thickness, 0, double *);
MEMBER(mdr_conductor, sigma, 8, double *);
MEMBER(mdr_conductor, along, 16, double *);
MEMBER(mdr_conductor, capacity, 24, double *);
MEMBER(mdr_conductor, resistance, 32, double *);
EXACT(mdr_friction_heat, 56);
MEMBER(mdr_friction_heat, total, 0, double *);
MEMBER(mdr_friction_heat, share, 8, double *);
MEMBER(mdr_friction_heat, centre, 16, double *);
MEMBER(mdr_friction_heat, flux_mean, 24, double *);
MEMBER(mdr_friction_heat, area_mean, 32, double *);
MEMBER(mdr_friction_heat, largest, 40, double *);
MEMBER(mdr_friction_heat, behind, 48, double *);
int mdr_conduction_new(int n, const mdr_conductor lower[], int lower_base, int m, const mdr_conductor upper[], int upper_base, double film, double sink, mdr_conduction **out);
int mdr_conduction_spot(const mdr_conduction *p, int n, const double radius[], double conductance[], double slope[]);
int mdr_conduction_tabulate(const mdr_conduction *p, double smallest, double largest, double tolerance, mdr_conduction **out);
int mdr_conduction_field(const mdr_conduction *p, int field, double radius, int body, int below, double time, int n, const double r[], const double z[], double out[]);
int mdr_conduction_compliance(const mdr_conduction *p, int n, const double k[], const double omega[], double out[], double imaginary[]);
int mdr_conduction_admittance(const mdr_conduction *p, int answer, double radius, int n, const double omega[], double in_phase[], double ahead[]);
int mdr_conduction_follow(const mdr_conduction *p, int answer, double radius, int n, const double time[], const double given[], double out[]);
int mdr_conduction_rough(const mdr_conduction *p, const mdr_contact *c, const mdr_state *state, double kappa, double *out);
int mdr_conduction_joint_resistance(const mdr_conduction *p, double roughness, double slope, double hardness, double gas, double jump, int n, const double pressure[], double out[]);
int mdr_conduction_joint(const mdr_conduction *p, const mdr_contact *c, const mdr_state *state, double roughness, double slope, double hardness, double gas, double jump, double *out);
int mdr_conduction_along(const mdr_conduction *p, const mdr_contact *c, int n, const mdr_state states[], double conductance[], double by_force[], double by_depth[]);
int mdr_conduction_heat(const mdr_conduction *p, const mdr_contact *c, int n, const mdr_state states[], int motion, double strength, double speed, mdr_friction_heat out[]);
int mdr_conduction_heat_field(const mdr_conduction *p, const mdr_contact *c, const mdr_state *state, int motion, double strength, int body, int below, int n, const double r[], const double z[], double out[]);
int mdr_law_conductance(const mdr_law *law, int branch, int n, const double d[], double conductance[], double slope[]);
#endif
#ifdef MDRCONTACT_POROELASTIC_H
typedef struct mdr_poroelastic mdr_poroelastic;
VALUE(MDR_DRAINAGE_SURFACE, 1701);
VALUE(MDR_DRAINAGE_SEALED, 1702);
VALUE(MDR_DRAINAGE_INDENTER, 1703);
int mdr_poroelastic_new(double nu, int drainage, double ratio, double *deviation, mdr_poroelastic **out);
int mdr_poroelastic_response(const mdr_poroelastic *p, int answer, double shear_modulus, double diffusivity, double radius, int n, const double time[], double out[]);
int mdr_poroelastic_history(const mdr_poroelastic *p, int given, double shear_modulus, double diffusivity, double radius, int n, const double time[], const double in[], double out[]);
int mdr_poroelastic_dynamic_stiffness(const mdr_poroelastic *p, double shear_modulus, double diffusivity, double radius, int n, const double omega[], double storage[], double loss[]);
int mdr_poroelastic_pressure(const mdr_poroelastic *p, int kind, int is_flat, double shear_modulus, double diffusivity, double radius, double time, int n, const double r[], double out[]);
int mdr_poroelastic_compliance(double nu, int drainage, double thickness, double shear_modulus, double diffusivity, int n, const double k[], const double omega[], double out[], double imaginary[]);
#endif
#ifdef MDRCONTACT_PLASTIC_H
typedef struct mdr_imprint mdr_imprint;
typedef struct mdr_yielding mdr_yielding;
typedef struct mdr_plastic_law mdr_plastic_law;
typedef struct mdr_overload mdr_overload;
typedef struct mdr_cap mdr_cap;
GROWS(mdr_imprint_facts, 72);
MEMBER(mdr_imprint_facts, size, 0, size_t *);
MEMBER(mdr_imprint_facts, radius, 8, double *);
MEMBER(mdr_imprint_facts, force, 16, double *);
MEMBER(mdr_imprint_facts, depth, 24, double *);
MEMBER(mdr_imprint_facts, residual_depth, 32, double *);
MEMBER(mdr_imprint_facts, recovered_work, 40, double *);
MEMBER(mdr_imprint_facts, uniform, 48, double *);
MEMBER(mdr_imprint_facts, hertz, 56, double *);
MEMBER(mdr_imprint_facts, misfit, 64, double *);
GROWS(mdr_plastic_law_options, 32);
MEMBER(mdr_plastic_law_options, size, 0, size_t *);
MEMBER(mdr_plastic_law_options, other, 8, const mdr_yielding **);
MEMBER(mdr_plastic_law_options, work_of_adhesion, 16, double *);
MEMBER(mdr_plastic_law_options, tolerance, 24, double *);
GROWS(mdr_plastic_law_facts, 104);
MEMBER(mdr_plastic_law_facts, size, 0, size_t *);
MEMBER(mdr_plastic_law_facts, yield_depth, 8, double *);
MEMBER(mdr_plastic_law_facts, yield_force, 16, double *);
MEMBER(mdr_plastic_law_facts, first_yield, 24, double *);
MEMBER(mdr_plastic_law_facts, largest_depth, 32, double *);
MEMBER(mdr_plastic_law_facts, largest_force, 40, double *);
MEMBER(mdr_plastic_law_facts, largest_radius, 48, double *);
MEMBER(mdr_plastic_law_facts, radius, 56, double *);
MEMBER(mdr_plastic_law_facts, modulus, 64, double *);
MEMBER(mdr_plastic_law_facts, work_of_adhesion, 72, double *);
MEMBER(mdr_plastic_law_facts, tolerance, 80, double *);
MEMBER(mdr_plastic_law_facts, error, 88, double *);
MEMBER(mdr_plastic_law_facts, memory_size, 96, int *);
MEMBER(mdr_plastic_law_facts, buffer_size, 100, int *);
EXACT(mdr_overload_state, 64);
MEMBER(mdr_overload_state, depth, 0, double *);
MEMBER(mdr_overload_state, radius, 8, double *);
MEMBER(mdr_overload_state, force, 16, double *);
MEMBER(mdr_overload_state, load, 24, double *);
MEMBER(mdr_overload_state, uniform, 32, double *);
MEMBER(mdr_overload_state, hertz, 40, double *);
MEMBER(mdr_overload_state, force_error, 48, double *);
MEMBER(mdr_overload_state, depth_error, 56, double *);
EXACT(mdr_cap_state, 56);
MEMBER(mdr_cap_state, depth, 0, double *);
MEMBER(mdr_cap_state, radius, 8, double *);
MEMBER(mdr_cap_state, force, 16, double *);
MEMBER(mdr_cap_state, capped_radius, 24, double *);
MEMBER(mdr_cap_state, residual_depth, 32, double *);
MEMBER(mdr_cap_state, recovered_work, 40, double *);
MEMBER(mdr_cap_state, error, 48, double *);
int mdr_imprint_new(const mdr_medium *medium, double radius, double force, double residual_depth, double depth, mdr_imprint **out);
int mdr_imprint_two_terms(const mdr_medium *medium, double radius, double uniform, double hertz, double depth, mdr_imprint **out);
int mdr_imprint_from_pressure(const mdr_medium *medium, int n, const double r[], const double p[], double depth, mdr_imprint **out);
int mdr_imprint_profile(const mdr_imprint *i, mdr_profile **out);
int mdr_imprint_about(const mdr_imprint *i, mdr_imprint_facts *facts);
int mdr_imprint_reverse_yield(const mdr_imprint *i, int n, const double yield_stress[], double *ratio, int *layer);
int mdr_yielding_new(double E, double nu, int n, const double strain[], const double yield_stress[], mdr_yielding **out);
int mdr_yield_stress_from_hardness(double E, double nu, double hardness, double radius_ratio, double *yield_stress, double *error);
int mdr_plastic_law_new(const mdr_profile *profile, const mdr_yielding *metal, double largest_depth, const mdr_plastic_law_options *options, mdr_plastic_law **out);
int mdr_plastic_law_from_points(int n, const double d[], const double F[], const double a[], const double residual_depth[], const double modulus[], const mdr_plastic_law_options *options, mdr_plastic_law **out);
int mdr_plastic_law_with_radius(const mdr_plastic_law *law, double radius, mdr_plastic_law **out);
int mdr_plastic_law_about(const mdr_plastic_law *law, mdr_plastic_law_facts *facts);
int mdr_plastic_law_advance(const mdr_plastic_law *law, int n, const double d[], int is_trial, double memory[], double F[], double slope[], double a[]);
int mdr_plastic_law_energies(const mdr_plastic_law *law, int n, const double d[], const double memory[], double stored[], double dissipated[]);
int mdr_plastic_law_loading(const mdr_plastic_law *law, int n, const double d[], double F[], double a[], double residual[], double work[]);
int mdr_plastic_law_restitution(const mdr_plastic_law *law, double mass, int n, const double speed[], double e[]);
int mdr_plastic_law_buffer(const mdr_plastic_law *law, int size, double buffer[]);
int mdr_overload_new(const mdr_contact *c, int n, const double yield_stress[], mdr_overload **out);
int mdr_overload_states(const mdr_overload *rule, int given, int n, const double value[], mdr_overload_state out[]);
int mdr_plastic_law_from_overload(const mdr_overload *rule, double largest_depth, const mdr_plastic_law_options *options, mdr_plastic_law **out);
int mdr_cap_new(const mdr_contact *c, double hardness, mdr_cap **out);
int mdr_cap_states(const mdr_cap *cap, int given, int n, const double value[], mdr_cap_state out[]);
int mdr_cap_pressure(const mdr_cap *cap, double radius, int n, const double r[], double pressure[], double residual[]);
int mdr_truncated_hertz(double a, double largest, double hardness, int n, const double x[], double out[]);
#endif
#ifdef MDRCONTACT_LATERAL_H
typedef struct mdr_structure mdr_structure;
typedef int (*mdr_field)(double x, double y, double z, double *E, double *nu, void *context);
VALUE(MDR_SHAPE_LAYER, 1401);
VALUE(MDR_SHAPE_HALF_SPACE, 1402);
VALUE(MDR_SHAPE_BALL, 1403);
VALUE(MDR_SHAPE_FIBRE, 1404);
VALUE(MDR_SHAPE_PILLAR, 1405);
VALUE(MDR_SHAPE_BOX, 1406);
GROWS(mdr_structure_options, 80);
MEMBER(mdr_structure_options, size, 0, size_t *);
MEMBER(mdr_structure_options, reference_nu, 8, double *);
MEMBER(mdr_structure_options, tolerance, 16, double *);
MEMBER(mdr_structure_options, padded, 24, int *);
MEMBER(mdr_structure_options, images, 28, int *);
MEMBER(mdr_structure_options, beside_E, 32, double *);
MEMBER(mdr_structure_options, beside_nu, 40, double *);
MEMBER(mdr_structure_options, origin, 48, double (*)[2]);
MEMBER(mdr_structure_options, exponent, 64, double *);
MEMBER(mdr_structure_options, reference_nu_is_given, 72, int *);
MEMBER(mdr_structure_options, exponent_is_given, 76, int *);
int mdr_structure_shapes(double E, double nu, int n, const int kind[], const double parameters[], const double shape_E[], const double shape_nu[], const mdr_structure_options *options, mdr_structure **out);
int mdr_structure_voxels(const int size[3], const int labels[], int phases, const double E[], const double nu[], const double spacing[3], double below_E, double below_nu, const mdr_structure_options *options, mdr_structure **out);
int mdr_structure_function(mdr_field field, void *context, double reference_nu, const mdr_structure_options *options, mdr_structure **out);
int mdr_structure_modulus(const mdr_structure *s, int n, const double x[], const double y[], const double a[], double out[]);
int mdr_structure_medium(const mdr_structure *s, double x, double y, double smallest_radius, double largest_radius, int points, mdr_medium **out);
int mdr_lateral_density(int n, const double rho[], const double z[], double nu, double shear[], double poisson[]);
int mdr_lateral_cells(double nu, double a, double z_top, double z_bottom, int nx, const double x[], int ny, const double y[], double shear[], double poisson[]);
int mdr_lateral_rule(int order, double nu, double points[], double weights[]);
#endif
#ifdef MDRCONTACT_FIT_H
VALUE(MDR_FIT_FORCE_DEPTH, 1501);
VALUE(MDR_FIT_STIFFNESS_DEPTH, 1502);
VALUE(MDR_FIT_MODULUS_RADIUS, 1503);
VALUE(MDR_FIT_STIFFNESS_RADIUS, 1504);
VALUE(MDR_FIT_FORCE_TIME, 1505);
VALUE(MDR_FIT_DEPTH_TIME, 1506);
VALUE(MDR_FIT_DYNAMIC_STIFFNESS, 1507);
VALUE(MDR_FIT_WORK_OF_ADHESION, 0);
VALUE(MDR_FIT_DEPTH_OFFSET, 1);
VALUE(MDR_FIT_FORCE_OFFSET, 2);
VALUE(MDR_FIT_FRAME_COMPLIANCE, 3);
VALUE(MDR_FIT_INDENTER_MODULUS, 4);
VALUE(MDR_FIT_CONTACT_DEPTH_FACTOR, 5);
VALUE(MDR_FIT_STIFFNESS_FACTOR, 6);
VALUE(MDR_FIT_CONTACT_DEPTH_SCALE, 7);
VALUE(MDR_FIT_AREA_FACTOR, 8);
VALUE(MDR_FIT_COHESIVE_STRESS, 9);
VALUE(MDR_FIT_INSTRUMENT_COUNT, 10);
VALUE(MDR_FIT_LINEAR, 1601);
VALUE(MDR_FIT_HUBER, 1602);
VALUE(MDR_FIT_CAUCHY, 1603);
EXACT(mdr_fit_parameter, 96);
MEMBER(mdr_fit_parameter, value, 0, double *);
MEMBER(mdr_fit_parameter, lower, 8, double *);
MEMBER(mdr_fit_parameter, upper, 16, double *);
MEMBER(mdr_fit_parameter, prior, 24, double *);
MEMBER(mdr_fit_parameter, prior_sd, 32, double *);
MEMBER(mdr_fit_parameter, is_free, 40, int *);
MEMBER(mdr_fit_parameter, name, 44, char (*)[48]);
GROWS(mdr_fit_problem, 112);
MEMBER(mdr_fit_problem, size, 0, size_t *);
MEMBER(mdr_fit_problem, data_kind, 8, int *);
MEMBER(mdr_fit_problem, profile, 16, const mdr_profile **);
MEMBER(mdr_fit_problem, medium, 24, const mdr_medium **);
MEMBER(mdr_fit_problem, counterbody, 32, const mdr_medium **);
MEMBER(mdr_fit_problem, adhesion_rule, 40, int *);
MEMBER(mdr_fit_problem, loss, 44, int *);
MEMBER(mdr_fit_problem, loss_scale, 48, double *);
MEMBER(mdr_fit_problem, sd_is_relative, 56, int *);
MEMBER(mdr_fit_problem, max_iterations, 60, int *);
MEMBER(mdr_fit_problem, any_units, 64, int *);
MEMBER(mdr_fit_problem, parameter_count, 68, int *);
MEMBER(mdr_fit_problem, parameters, 72, const mdr_fit_parameter **);
MEMBER(mdr_fit_problem, prior_count, 80, int *);
MEMBER(mdr_fit_problem, prior_weights, 88, const double **);
MEMBER(mdr_fit_problem, branch, 96, const int **);
MEMBER(mdr_fit_problem, is_elastic, 104, int *);
GROWS(mdr_fit_summary, 88);
MEMBER(mdr_fit_summary, size, 0, size_t *);
MEMBER(mdr_fit_summary, converged, 8, int *);
MEMBER(mdr_fit_summary, iterations, 12, int *);
MEMBER(mdr_fit_summary, evaluations, 16, int *);
MEMBER(mdr_fit_summary, chi_square, 24, double *);
MEMBER(mdr_fit_summary, prior_chi_square, 32, double *);
MEMBER(mdr_fit_summary, degrees_of_freedom, 40, double *);
MEMBER(mdr_fit_summary, noise, 48, double *);
MEMBER(mdr_fit_summary, log_likelihood, 56, double *);
MEMBER(mdr_fit_summary, pattern_probability, 64, double *);
MEMBER(mdr_fit_summary, weakest, 72, double *);
MEMBER(mdr_fit_summary, lag_correlation, 80, double *);
int mdr_fit_parameters(const mdr_fit_problem *problem, int capacity, mdr_fit_parameter out[], int *count);
int mdr_fit_solve(const mdr_fit_problem *problem, int n, const double x[], const double y[], const double given[], const double sd[], double values[], double covariance[], double widening[], int at_bound[], double weakest_direction[], double fitted[], double residuals[], mdr_fit_summary *summary);
int mdr_fit_predict(const mdr_fit_problem *problem, int n, const double x[], const double y[], const double given[], double fitted[], double radius[]);
int mdr_fit_interval(const mdr_fit_problem *problem, int n, const double x[], const double y[], const double given[], const double sd[], int position, double level, double *lower, double *upper);
int mdr_fit_quantile(double level, double degrees_of_freedom, double *factor);
#endif
#ifdef MDRCONTACT_LAW_INLINE_H
EXACT(mdr_law_view, 96);
MEMBER(mdr_law_view, lowest, 0, double *);
MEMBER(mdr_law_view, highest, 8, double *);
MEMBER(mdr_law_view, scale, 16, double *);
MEMBER(mdr_law_view, offset, 24, double *);
MEMBER(mdr_law_view, mask, 32, uint64_t *);
MEMBER(mdr_law_view, half, 40, uint64_t *);
MEMBER(mdr_law_view, force, 48, const double **);
MEMBER(mdr_law_view, contact, 56, const double **);
MEMBER(mdr_law_view, energy, 64, const double **);
MEMBER(mdr_law_view, buffer, 72, const double **);
MEMBER(mdr_law_view, branch, 80, int *);
MEMBER(mdr_law_view, shift, 84, int *);
MEMBER(mdr_law_view, open, 88, double *);
int mdr_law_view_of(const mdr_law *law, int branch, mdr_law_view *view);
int mdr_law_check(const double buffer[], size_t bytes);
#endif
#ifdef MDRCONTACT_PLASTIC_LAW_INLINE_H
VALUE((long long)MDR_PLASTIC_FORMAT, 1296843602);
EXACT(mdr_plastic_head, 144);
MEMBER(mdr_plastic_head, format, 0, double *);
MEMBER(mdr_plastic_head, size, 8, double *);
MEMBER(mdr_plastic_head, elastic, 16, double *);
MEMBER(mdr_plastic_head, yield, 24, double *);
MEMBER(mdr_plastic_head, highest, 32, double *);
MEMBER(mdr_plastic_head, scale, 40, double *);
MEMBER(mdr_plastic_head, offset, 48, double *);
MEMBER(mdr_plastic_head, bits, 56, double *);
MEMBER(mdr_plastic_head, panels, 64, double *);
MEMBER(mdr_plastic_head, edges, 72, double *);
MEMBER(mdr_plastic_head, rows, 80, double *);
MEMBER(mdr_plastic_head, energy, 88, double *);
MEMBER(mdr_plastic_head, tension, 96, double *);
MEMBER(mdr_plastic_head, modulus, 104, double *);
MEMBER(mdr_plastic_head, line, 112, double *);
MEMBER(mdr_plastic_head, radius, 120, double *);
MEMBER(mdr_plastic_head, touch, 128, double *);
MEMBER(mdr_plastic_head, coated, 136, double *);
EXACT(mdr_plastic_view, 288);
MEMBER(mdr_plastic_view, elastic, 0, mdr_law_view *);
MEMBER(mdr_plastic_view, virgin, 96, mdr_law_view *);
MEMBER(mdr_plastic_view, yield, 192, double *);
MEMBER(mdr_plastic_view, highest, 200, double *);
MEMBER(mdr_plastic_view, edges, 208, const double **);
MEMBER(mdr_plastic_view, rows, 216, const double **);
MEMBER(mdr_plastic_view, energy, 224, const double **);
MEMBER(mdr_plastic_view, tension, 232, const double **);
MEMBER(mdr_plastic_view, modulus, 240, double *);
MEMBER(mdr_plastic_view, line, 248, double *);
MEMBER(mdr_plastic_view, hertz, 256, double *);
MEMBER(mdr_plastic_view, radius, 264, double *);
MEMBER(mdr_plastic_view, touch, 272, double *);
MEMBER(mdr_plastic_view, panels, 280, int *);
MEMBER(mdr_plastic_view, coated, 284, int *);
EXACT(mdr_plastic_point, 24);
MEMBER(mdr_plastic_point, force, 0, double *);
MEMBER(mdr_plastic_point, slope, 8, double *);
MEMBER(mdr_plastic_point, radius, 16, double *);
EXACT(mdr_plastic_imprint, 32);
MEMBER(mdr_plastic_imprint, radius, 0, double *);
MEMBER(mdr_plastic_imprint, uniform, 8, double *);
MEMBER(mdr_plastic_imprint, hertz, 16, double *);
MEMBER(mdr_plastic_imprint, modulus, 24, double *);
EXACT(mdr_plastic_sticky, 32);
MEMBER(mdr_plastic_sticky, deepest, 0, double *);
MEMBER(mdr_plastic_sticky, s, 8, double *);
MEMBER(mdr_plastic_sticky, lost, 16, double *);
MEMBER(mdr_plastic_sticky, closed, 24, int *);
int mdr_plastic_law_check(const double buffer[], size_t bytes);
#endif

static const struct {
    const char *name, *version;
    void (*address)(void);
} functions[] = {
#ifdef MDRCONTACT_BASE_H
    {"mdr_version", "MDR_0.1", (void (*)(void))mdr_version},
    {"mdr_name_of", "MDR_0.1", (void (*)(void))mdr_name_of},
    {"mdr_code_of", "MDR_0.1", (void (*)(void))mdr_code_of},
    {"mdr_last_error", "MDR_0.1", (void (*)(void))mdr_last_error},
    {"mdr_last_failure", "MDR_0.1", (void (*)(void))mdr_last_failure},
    {"mdr_set_threads", "MDR_0.1", (void (*)(void))mdr_set_threads},
    {"mdr_set_cancel", "MDR_0.1", (void (*)(void))mdr_set_cancel},
    {"mdr_set_progress", "MDR_0.1", (void (*)(void))mdr_set_progress},
    {"mdr_free", "MDR_0.1", (void (*)(void))mdr_free},
    {"mdr_parameters", "MDR_0.1", (void (*)(void))mdr_parameters},
#endif
#ifdef MDRCONTACT_PROFILE_H
    {"mdr_profile_paraboloid", "MDR_0.1", (void (*)(void))mdr_profile_paraboloid},
    {"mdr_profile_sphere", "MDR_0.1", (void (*)(void))mdr_profile_sphere},
    {"mdr_profile_cone", "MDR_0.1", (void (*)(void))mdr_profile_cone},
    {"mdr_profile_power", "MDR_0.1", (void (*)(void))mdr_profile_power},
    {"mdr_profile_flat_punch", "MDR_0.1", (void (*)(void))mdr_profile_flat_punch},
    {"mdr_profile_flat_cone", "MDR_0.1", (void (*)(void))mdr_profile_flat_cone},
    {"mdr_profile_flat_paraboloid", "MDR_0.1", (void (*)(void))mdr_profile_flat_paraboloid},
    {"mdr_profile_rounded_cone", "MDR_0.1", (void (*)(void))mdr_profile_rounded_cone},
    {"mdr_profile_area_function", "MDR_0.1", (void (*)(void))mdr_profile_area_function},
    {"mdr_profile_table", "MDR_0.1", (void (*)(void))mdr_profile_table},
    {"mdr_profile_function", "MDR_0.1", (void (*)(void))mdr_profile_function},
    {"mdr_profile_sum", "MDR_0.1", (void (*)(void))mdr_profile_sum},
    {"mdr_profile_values", "MDR_0.1", (void (*)(void))mdr_profile_values},
#endif
#ifdef MDRCONTACT_MATERIAL_H
    {"mdr_material_viscoelastic", "MDR_0.1", (void (*)(void))mdr_material_viscoelastic},
    {"mdr_material_power_law", "MDR_0.1", (void (*)(void))mdr_material_power_law},
    {"mdr_material_values", "MDR_0.1", (void (*)(void))mdr_material_values},
    {"mdr_material_limit", "MDR_0.1", (void (*)(void))mdr_material_limit},
#endif
#ifdef MDRCONTACT_BODY_H
    {"mdr_body_layered", "MDR_0.1", (void (*)(void))mdr_body_layered},
    {"mdr_body_graded", "MDR_0.1", (void (*)(void))mdr_body_graded},
    {"mdr_body_graded_function", "MDR_0.1", (void (*)(void))mdr_body_graded_function},
    {"mdr_body_power_graded", "MDR_0.1", (void (*)(void))mdr_body_power_graded},
    {"mdr_body_rigid", "MDR_0.1", (void (*)(void))mdr_body_rigid},
    {"mdr_body_wrinkling", "MDR_0.1", (void (*)(void))mdr_body_wrinkling},
    {"mdr_body_compliance", "MDR_0.1", (void (*)(void))mdr_body_compliance},
    {"mdr_body_compliance_limits", "MDR_0.1", (void (*)(void))mdr_body_compliance_limits},
    {"mdr_response_new", "MDR_0.1", (void (*)(void))mdr_response_new},
    {"mdr_response_about", "MDR_0.1", (void (*)(void))mdr_response_about},
    {"mdr_response_point", "MDR_0.1", (void (*)(void))mdr_response_point},
    {"mdr_response_rectangle", "MDR_0.1", (void (*)(void))mdr_response_rectangle},
#endif
#ifdef MDRCONTACT_MEDIUM_H
    {"mdr_model_info", "MDR_0.1", (void (*)(void))mdr_model_info},
    {"mdr_medium_contact_modulus", "MDR_0.1", (void (*)(void))mdr_medium_contact_modulus},
    {"mdr_medium_new", "MDR_0.1", (void (*)(void))mdr_medium_new},
    {"mdr_medium_pair", "MDR_0.1", (void (*)(void))mdr_medium_pair},
    {"mdr_medium_table", "MDR_0.1", (void (*)(void))mdr_medium_table},
    {"mdr_medium_function", "MDR_0.1", (void (*)(void))mdr_medium_function},
    {"mdr_medium_values", "MDR_0.1", (void (*)(void))mdr_medium_values},
#endif
#ifdef MDRCONTACT_WEIGHTS_H
    {"mdr_weight", "MDR_0.1", (void (*)(void))mdr_weight},
#endif
#ifdef MDRCONTACT_CONTACT_H
    {"mdr_contact_new", "MDR_0.1", (void (*)(void))mdr_contact_new},
    {"mdr_contact_states", "MDR_0.1", (void (*)(void))mdr_contact_states},
    {"mdr_contact_slope", "MDR_0.1", (void (*)(void))mdr_contact_slope},
    {"mdr_contact_pull_off", "MDR_0.1", (void (*)(void))mdr_contact_pull_off},
    {"mdr_loop_new", "MDR_0.1", (void (*)(void))mdr_loop_new},
    {"mdr_loop_points", "MDR_0.1", (void (*)(void))mdr_loop_points},
    {"mdr_loop_about", "MDR_0.1", (void (*)(void))mdr_loop_about},
    {"mdr_contact_load", "MDR_0.1", (void (*)(void))mdr_contact_load},
    {"mdr_load_energy", "MDR_0.1", (void (*)(void))mdr_load_energy},
    {"mdr_load_field", "MDR_0.1", (void (*)(void))mdr_load_field},
    {"mdr_load_lowest_pressure", "MDR_0.1", (void (*)(void))mdr_load_lowest_pressure},
    {"mdr_contact_warnings", "MDR_0.1", (void (*)(void))mdr_contact_warnings},
    {"mdr_load_interior", "MDR_0.1", (void (*)(void))mdr_load_interior},
    {"mdr_load_interior_error", "MDR_0.1", (void (*)(void))mdr_load_interior_error},
    {"mdr_load_layer_energies", "MDR_0.1", (void (*)(void))mdr_load_layer_energies},
    {"mdr_load_critical", "MDR_0.1", (void (*)(void))mdr_load_critical},
    {"mdr_contact_first_failure", "MDR_0.1", (void (*)(void))mdr_contact_first_failure},
#endif
#ifdef MDRCONTACT_FRICTION_H
    {"mdr_friction_new", "MDR_0.1", (void (*)(void))mdr_friction_new},
    {"mdr_shear_new", "MDR_0.1", (void (*)(void))mdr_shear_new},
    {"mdr_shear_states", "MDR_0.1", (void (*)(void))mdr_shear_states},
    {"mdr_shear_about", "MDR_0.1", (void (*)(void))mdr_shear_about},
    {"mdr_shear_field", "MDR_0.1", (void (*)(void))mdr_shear_field},
    {"mdr_shear_loop", "MDR_0.1", (void (*)(void))mdr_shear_loop},
    {"mdr_friction_history_new", "MDR_0.1", (void (*)(void))mdr_friction_history_new},
    {"mdr_friction_history_copy", "MDR_0.1", (void (*)(void))mdr_friction_history_copy},
    {"mdr_friction_history_advance", "MDR_0.1", (void (*)(void))mdr_friction_history_advance},
#endif
#ifdef MDRCONTACT_LAW_H
    {"mdr_law_new", "MDR_0.1", (void (*)(void))mdr_law_new},
    {"mdr_law_with_radius", "MDR_0.1", (void (*)(void))mdr_law_with_radius},
    {"mdr_law_force", "MDR_0.1", (void (*)(void))mdr_law_force},
    {"mdr_law_follow", "MDR_0.1", (void (*)(void))mdr_law_follow},
    {"mdr_law_values", "MDR_0.1", (void (*)(void))mdr_law_values},
    {"mdr_law_about", "MDR_0.1", (void (*)(void))mdr_law_about},
    {"mdr_law_buffer", "MDR_0.1", (void (*)(void))mdr_law_buffer},
    {"mdr_law_save", "MDR_0.1", (void (*)(void))mdr_law_save},
    {"mdr_law_load", "MDR_0.1", (void (*)(void))mdr_law_load},
    {"mdr_law_write", "MDR_0.1", (void (*)(void))mdr_law_write},
    {"mdr_law_read", "MDR_0.1", (void (*)(void))mdr_law_read},
    {"mdr_law_advance", "MDR_0.1", (void (*)(void))mdr_law_advance},
    {"mdr_law_energies", "MDR_0.1", (void (*)(void))mdr_law_energies},
    {"mdr_law_turn", "MDR_0.1", (void (*)(void))mdr_law_turn},
#endif
#ifdef MDRCONTACT_CLOSED_FORMS_H
    {"mdr_closed_form", "MDR_0.1", (void (*)(void))mdr_closed_form},
#endif
#ifdef MDRCONTACT_TIME_H
    {"mdr_contact_history", "MDR_0.1", (void (*)(void))mdr_contact_history},
    {"mdr_contact_dynamic_stiffness", "MDR_0.1", (void (*)(void))mdr_contact_dynamic_stiffness},
    {"mdr_contact_step_response", "MDR_0.1", (void (*)(void))mdr_contact_step_response},
#endif
#ifdef MDRCONTACT_ADHESION_H
    {"mdr_rate_new", "MDR_0.1", (void (*)(void))mdr_rate_new},
    {"mdr_rate_work", "MDR_0.1", (void (*)(void))mdr_rate_work},
    {"mdr_rate_history", "MDR_0.1", (void (*)(void))mdr_rate_history},
    {"mdr_contact_adhesive_history", "MDR_0.1", (void (*)(void))mdr_contact_adhesive_history},
#endif
#ifdef MDRCONTACT_WEAR_H
    {"mdr_wear_new", "MDR_0.1", (void (*)(void))mdr_wear_new},
    {"mdr_wear_limit", "MDR_0.1", (void (*)(void))mdr_wear_limit},
    {"mdr_wear_track", "MDR_0.1", (void (*)(void))mdr_wear_track},
    {"mdr_wear_passes", "MDR_0.1", (void (*)(void))mdr_wear_passes},
    {"mdr_wear_running_in", "MDR_0.1", (void (*)(void))mdr_wear_running_in},
    {"mdr_wear_history_new", "MDR_0.1", (void (*)(void))mdr_wear_history_new},
    {"mdr_wear_history_copy", "MDR_0.1", (void (*)(void))mdr_wear_history_copy},
    {"mdr_wear_history_advance", "MDR_0.1", (void (*)(void))mdr_wear_history_advance},
    {"mdr_wear_history_state", "MDR_0.1", (void (*)(void))mdr_wear_history_state},
    {"mdr_wear_history_profile", "MDR_0.1", (void (*)(void))mdr_wear_history_profile},
    {"mdr_wear_history_save", "MDR_0.1", (void (*)(void))mdr_wear_history_save},
    {"mdr_wear_history_restore", "MDR_0.1", (void (*)(void))mdr_wear_history_restore},
#endif
#ifdef MDRCONTACT_CONDUCTION_H
    {"mdr_conduction_new", "MDR_0.1", (void (*)(void))mdr_conduction_new},
    {"mdr_conduction_spot", "MDR_0.1", (void (*)(void))mdr_conduction_spot},
    {"mdr_conduction_tabulate", "MDR_0.1", (void (*)(void))mdr_conduction_tabulate},
    {"mdr_conduction_field", "MDR_0.1", (void (*)(void))mdr_conduction_field},
    {"mdr_conduction_compliance", "MDR_0.1", (void (*)(void))mdr_conduction_compliance},
    {"mdr_conduction_admittance", "MDR_0.1", (void (*)(void))mdr_conduction_admittance},
    {"mdr_conduction_follow", "MDR_0.1", (void (*)(void))mdr_conduction_follow},
    {"mdr_conduction_rough", "MDR_0.1", (void (*)(void))mdr_conduction_rough},
    {"mdr_conduction_joint_resistance", "MDR_0.1", (void (*)(void))mdr_conduction_joint_resistance},
    {"mdr_conduction_joint", "MDR_0.1", (void (*)(void))mdr_conduction_joint},
    {"mdr_conduction_along", "MDR_0.1", (void (*)(void))mdr_conduction_along},
    {"mdr_conduction_heat", "MDR_0.1", (void (*)(void))mdr_conduction_heat},
    {"mdr_conduction_heat_field", "MDR_0.1", (void (*)(void))mdr_conduction_heat_field},
    {"mdr_law_conductance", "MDR_0.1", (void (*)(void))mdr_law_conductance},
#endif
#ifdef MDRCONTACT_POROELASTIC_H
    {"mdr_poroelastic_new", "MDR_0.1", (void (*)(void))mdr_poroelastic_new},
    {"mdr_poroelastic_response", "MDR_0.1", (void (*)(void))mdr_poroelastic_response},
    {"mdr_poroelastic_history", "MDR_0.1", (void (*)(void))mdr_poroelastic_history},
    {"mdr_poroelastic_dynamic_stiffness", "MDR_0.1", (void (*)(void))mdr_poroelastic_dynamic_stiffness},
    {"mdr_poroelastic_pressure", "MDR_0.1", (void (*)(void))mdr_poroelastic_pressure},
    {"mdr_poroelastic_compliance", "MDR_0.1", (void (*)(void))mdr_poroelastic_compliance},
#endif
#ifdef MDRCONTACT_PLASTIC_H
    {"mdr_imprint_new", "MDR_0.1", (void (*)(void))mdr_imprint_new},
    {"mdr_imprint_two_terms", "MDR_0.1", (void (*)(void))mdr_imprint_two_terms},
    {"mdr_imprint_from_pressure", "MDR_0.1", (void (*)(void))mdr_imprint_from_pressure},
    {"mdr_imprint_profile", "MDR_0.1", (void (*)(void))mdr_imprint_profile},
    {"mdr_imprint_about", "MDR_0.1", (void (*)(void))mdr_imprint_about},
    {"mdr_imprint_reverse_yield", "MDR_0.1", (void (*)(void))mdr_imprint_reverse_yield},
    {"mdr_yielding_new", "MDR_0.1", (void (*)(void))mdr_yielding_new},
    {"mdr_yield_stress_from_hardness", "MDR_0.1", (void (*)(void))mdr_yield_stress_from_hardness},
    {"mdr_plastic_law_new", "MDR_0.1", (void (*)(void))mdr_plastic_law_new},
    {"mdr_plastic_law_from_points", "MDR_0.1", (void (*)(void))mdr_plastic_law_from_points},
    {"mdr_plastic_law_with_radius", "MDR_0.1", (void (*)(void))mdr_plastic_law_with_radius},
    {"mdr_plastic_law_about", "MDR_0.1", (void (*)(void))mdr_plastic_law_about},
    {"mdr_plastic_law_advance", "MDR_0.1", (void (*)(void))mdr_plastic_law_advance},
    {"mdr_plastic_law_energies", "MDR_0.1", (void (*)(void))mdr_plastic_law_energies},
    {"mdr_plastic_law_loading", "MDR_0.1", (void (*)(void))mdr_plastic_law_loading},
    {"mdr_plastic_law_restitution", "MDR_0.1", (void (*)(void))mdr_plastic_law_restitution},
    {"mdr_plastic_law_buffer", "MDR_0.1", (void (*)(void))mdr_plastic_law_buffer},
    {"mdr_overload_new", "MDR_0.1", (void (*)(void))mdr_overload_new},
    {"mdr_overload_states", "MDR_0.1", (void (*)(void))mdr_overload_states},
    {"mdr_plastic_law_from_overload", "MDR_0.1", (void (*)(void))mdr_plastic_law_from_overload},
    {"mdr_cap_new", "MDR_0.1", (void (*)(void))mdr_cap_new},
    {"mdr_cap_states", "MDR_0.1", (void (*)(void))mdr_cap_states},
    {"mdr_cap_pressure", "MDR_0.1", (void (*)(void))mdr_cap_pressure},
    {"mdr_truncated_hertz", "MDR_0.1", (void (*)(void))mdr_truncated_hertz},
#endif
#ifdef MDRCONTACT_LATERAL_H
    {"mdr_structure_shapes", "MDR_0.1", (void (*)(void))mdr_structure_shapes},
    {"mdr_structure_voxels", "MDR_0.1", (void (*)(void))mdr_structure_voxels},
    {"mdr_structure_function", "MDR_0.1", (void (*)(void))mdr_structure_function},
    {"mdr_structure_modulus", "MDR_0.1", (void (*)(void))mdr_structure_modulus},
    {"mdr_structure_medium", "MDR_0.1", (void (*)(void))mdr_structure_medium},
    {"mdr_lateral_density", "MDR_0.1", (void (*)(void))mdr_lateral_density},
    {"mdr_lateral_cells", "MDR_0.1", (void (*)(void))mdr_lateral_cells},
    {"mdr_lateral_rule", "MDR_0.1", (void (*)(void))mdr_lateral_rule},
#endif
#ifdef MDRCONTACT_FIT_H
    {"mdr_fit_parameters", "MDR_0.1", (void (*)(void))mdr_fit_parameters},
    {"mdr_fit_solve", "MDR_0.1", (void (*)(void))mdr_fit_solve},
    {"mdr_fit_predict", "MDR_0.1", (void (*)(void))mdr_fit_predict},
    {"mdr_fit_interval", "MDR_0.1", (void (*)(void))mdr_fit_interval},
    {"mdr_fit_quantile", "MDR_0.1", (void (*)(void))mdr_fit_quantile},
#endif
#ifdef MDRCONTACT_LAW_INLINE_H
    {"mdr_law_view_of", "MDR_0.1", (void (*)(void))mdr_law_view_of},
    {"mdr_law_check", "MDR_0.1", (void (*)(void))mdr_law_check},
#endif
#ifdef MDRCONTACT_PLASTIC_LAW_INLINE_H
    {"mdr_plastic_law_check", "MDR_0.1", (void (*)(void))mdr_plastic_law_check},
#endif
};

int main(void)
{
    const int n = (int)(sizeof functions / sizeof *functions);
    int missing = 0;
    for (int i = 0; i < n; ++i) {
        int is_there = functions[i].address != NULL;
#ifdef __GLIBC__
        is_there = is_there && dlvsym(RTLD_DEFAULT, functions[i].name, functions[i].version);
#endif
        if (!is_there) printf("missing: %s, version %s\n", functions[i].name, functions[i].version);
        missing += !is_there;
    }
    printf("%d of %d functions, missing: %d\n", n - missing, n, missing);
    return missing != 0;
}
