! SPDX-License-Identifier: GPL-3.0-or-later
!> The numbers of the C header's enumerations, written by tools/generate.py.
module mdrcontact_codes
    implicit none (type, external)
    private
    public :: success, enull, einvalid, edomain, eunreachable, enoconvergence, enomemory, ecallback, efile, ecancelled
    public :: depth, force, radius, spring, shift, tangential_force, twist, torque, height, height_slope, g, g_slope, modulus, &
              stiffness, tangential_modulus, torsional_stiffness, pressure, displacement, line_load, displacement_lower, &
              displacement_upper, traction, tangential_line_load, relaxation, creep, mean_relaxation, mean_creep, &
              paraboloid_relaxation, complex_modulus, storage, loss, total_pressure, pore_pressure, flux, flux_z, flux_r, &
              potential, conductance, resistance, mean_potential, centre_potential, gaussian_potential, von_mises, tresca, &
              tension, interface_shear, interface_tension, free_surface_tension
    public :: load_normal, load_shear, load_twist, load_coupling
    public :: form_paraboloid_force, form_cone_force, form_adhesive_depth, form_reduced_depth, form_radius_scale, form_depth_scale
    public :: base_half_space, base_perfect, base_insulating
    public :: heat_sliding, heat_spinning, heat_moving
    public :: adhesion_automatic, adhesion_paper, adhesion_energy
    public :: on_loading, on_unloading
    public :: warning_slope, warning_pressure, warning_compression, warning_contrast, warning_short_zone, warning_wetting
    public :: body_lower, body_upper
    public :: side_below, side_above
    public :: fit_force_depth, fit_stiffness_depth, fit_modulus_radius, fit_stiffness_radius, fit_force_time, fit_depth_time, &
              fit_dynamic_stiffness
    public :: fit_work_of_adhesion, fit_depth_offset, fit_force_offset, fit_frame_compliance, fit_indenter_modulus, &
              fit_contact_depth_factor, fit_stiffness_factor, fit_contact_depth_scale, fit_area_factor, fit_cohesive_stress, &
              fit_instrument_count
    public :: fit_linear, fit_huber, fit_cauchy
    public :: along, around
    public :: shape_layer, shape_half_space, shape_ball, shape_fibre, shape_pillar, shape_box
    public :: law_format
    public :: limit_glassy, limit_relaxed
    public :: model_gao, model_gao_series, model_doerner_nix, model_wave, model_mencik_exponential, model_mencik_reciprocal, &
              model_bec, model_perriot_barthel, model_hay_crawford, model_dimitriadis, model_garcia, model_exact, model_gao_power
    public :: base_elastic, base_any, base_rigid
    public :: weight_nu_surface, weight_nu_substrate, weight_nu_effective, weight_nu_given
    public :: drainage_surface, drainage_sealed, drainage_indenter
    public :: wear_fresh, wear_same
    public :: wear_disc, wear_rings
    public :: weight_phi, weight_i0, weight_i1, weight_j0, weight_j1, weight_i0_tangential, weight_j0_tangential
    public :: codes_beside, word_of

    ! enum mdr_status
    !> MDR_SUCCESS. The call succeeded.
    integer, parameter :: success = 0
    !> MDR_ENULL. A required pointer or handle is NULL.
    integer, parameter :: enull = 1
    !> MDR_EINVALID. An argument has a value that is never valid (NaN, E <= 0, a table that is not ascending).
    integer, parameter :: einvalid = 2
    !> MDR_EDOMAIN. A point lies outside the range in which the object is defined (r > a, beyond the end of a table).
    integer, parameter :: edomain = 3
    !> MDR_EUNREACHABLE. No contact state has the requested depth, force or radius.
    integer, parameter :: eunreachable = 4
    !> MDR_ENOCONVERGENCE. An iteration ended before it met its tolerance, or a result exceeds the range of double precision.
    integer, parameter :: enoconvergence = 5
    !> MDR_ENOMEMORY. Data of a size that the caller chose do not fit into memory.
    integer, parameter :: enomemory = 6
    !> MDR_ECALLBACK. A user function reported a failure or returned NaN or infinity.
    integer, parameter :: ecallback = 7
    !> MDR_EFILE. A file cannot be read or written, or is damaged.
    integer, parameter :: efile = 8
    !> MDR_ECANCELLED. The function set by mdr_set_cancel() cancelled the call.
    integer, parameter :: ecancelled = 9

    ! enum mdr_quantity
    !> MDR_DEPTH. d, indentation depth; with adhesion down to the pull-off depth [length].
    integer, parameter :: depth = 101
    !> MDR_FORCE. F, normal force; with adhesion down to the pull-off force [modulus length^2].
    integer, parameter :: force = 102
    !> MDR_RADIUS. a, contact radius, at least the radius of the flat end of the indenter and below its vertical wall [length]. With
    !> adhesion, a state of given radius may be unstable under depth or force control.
    integer, parameter :: radius = 103
    !> MDR_SPRING. Position of the far end of a spring that presses the indenter, d + F/stiffness [length].
    integer, parameter :: spring = 104
    !> MDR_SHIFT. s, displacement of the indenter along the surface, of either sign [length].
    integer, parameter :: shift = 105
    !> MDR_TANGENTIAL_FORCE. T, |T| <= coefficient F; the bound returns the state in which sliding begins [modulus length^2].
    integer, parameter :: tangential_force = 106
    !> MDR_TWIST. phi, rotation of the indenter about its axis, of either sign [radian].
    integer, parameter :: twist = 107
    !> MDR_TORQUE. M, less than the torque of sliding [modulus length^3].
    integer, parameter :: torque = 108
    !> MDR_HEIGHT. f(r), height of the indenter surface above its lowest point [length].
    integer, parameter :: height = 111
    !> MDR_HEIGHT_SLOPE. f'(r) [1]; infinite at the equator of a sphere.
    integer, parameter :: height_slope = 112
    !> MDR_G. g(x), one-dimensional profile of an indenter, equation (3) [length]; infinite at the equator of a sphere.
    integer, parameter :: g = 113
    !> MDR_G_SLOPE. g'(x) [1].
    integer, parameter :: g_slope = 114
    !> MDR_MODULUS. E_eff(a), effective contact modulus, equation (10) [modulus].
    integer, parameter :: modulus = 121
    !> MDR_STIFFNESS. k = 2 a E_eff(a), stiffness of a flat punch of radius a, equation (10) [modulus length].
    integer, parameter :: stiffness = 122
    !> MDR_TANGENTIAL_MODULUS. G_t(a) = k_t(a)/(2 a), the modulus that replaces E_eff for a full-stick contact displaced along the
    !> surface [modulus]. 4 G/(2 - nu) of a homogeneous body; 1/G_t adds for two bodies. Available for homogeneous media with E and
    !> nu; for coated, layered or graded ones with MDR_MODEL_EXACT, exact except for the displacement that varies as cos 2 phi
    !> around the axis (k_t is low by at most 0.35 %), or with Gao's weights of a tangential load; and for pairs of these.
    integer, parameter :: tangential_modulus = 123
    !> MDR_TORSIONAL_STIFFNESS. M/phi of a full-stick contact twisted about its axis: 16 G a^3/3 of a homogeneous body [modulus
    !> length^3]. Exact. Available for homogeneous media with E and nu, for coated, layered and graded ones with MDR_MODEL_EXACT,
    !> and for pairs of these.
    integer, parameter :: torsional_stiffness = 124
    !> MDR_PRESSURE. p(r), contact pressure, equation (6), 0 <= r <= a [modulus]. Infinite at the edge of a flat punch or of an
    !> adhesive contact and at the apex of a cone. With a cohesive stress sigma_0 it extends to zone_radius: finite at a, and
    !> -sigma_0 from there on.
    integer, parameter :: pressure = 131
    !> MDR_DISPLACEMENT. u(r), surface displacement, any r >= 0: d - f(r) for r <= a, inside the range of f; the free surface for r
    !> > a [length]. For two bodies, the sum, positive into each body. With an approximate model, each increment of depth moves the
    !> free surface as on a homogeneous body.
    integer, parameter :: displacement = 132
    !> MDR_LINE_LOAD. q(x), line load of the one-dimensional springs, equations (5), (21), 0 <= x <= a, or to zone_radius [modulus
    !> length].
    integer, parameter :: line_load = 133
    !> MDR_DISPLACEMENT_LOWER. u(r) of the medium, or of the lower of two bodies, into that body. On an initially flat surface it is
    !> the shape of the deformed interface for r <= a [length].
    integer, parameter :: displacement_lower = 134
    !> MDR_DISPLACEMENT_UPPER. u(r) of the upper body, into that body; 0 for a rigid indenter [length].
    integer, parameter :: displacement_upper = 135
    !> MDR_TRACTION. tau(r), shear traction in the direction of the shift, or around the axis, 0 <= r <= a [modulus].
    integer, parameter :: traction = 136
    !> MDR_TANGENTIAL_LINE_LOAD. q_t(x), line load of the springs in the direction of the shift, 0 <= x <= a; under a twist 2 x
    !> int_x^a tau dr/sqrt(r^2 - x^2) [modulus length].
    integer, parameter :: tangential_line_load = 137
    !> MDR_RELAXATION. Response to a unit step of the deformation at time 0. Of a material: G(t), shear relaxation modulus
    !> [modulus]; at t = 0 the glassy modulus; without the contribution of a dashpot at t > 0; t >= 0, and t > 0 for a power law or
    !> a dashpot, whose G(0) is infinite. Of a contact: force per depth of a flat punch [modulus length].
    integer, parameter :: relaxation = 141
    !> MDR_CREEP. Response to a unit step of the load at time 0. Of a material: J(t), shear compliance, t >= 0 [1/modulus]; J(0) = 0
    !> for a power law or a dashpot. Of a contact: depth per force of a flat punch [1/(modulus length)].
    integer, parameter :: creep = 142
    !> MDR_MEAN_RELAXATION. Time average of the relaxation of a contact since the step, the response to a ramp of the depth [modulus
    !> length].
    integer, parameter :: mean_relaxation = 143
    !> MDR_MEAN_CREEP. Time average of the creep of a contact since the step, the response to a ramp of the force [1/(modulus
    !> length)].
    integer, parameter :: mean_creep = 144
    !> MDR_PARABOLOID_RELAXATION. Force per depth of a paraboloid after a step of its depth d, at the fixed contact radius a =
    !> sqrt(R d) [modulus length]. The true contact radius rises and returns, with MDR_DRAINAGE_INDENTER by up to 9 %; the error of
    !> the force is then up to 0.05 of its relaxing part. If the whole surface drains or is sealed, the error is of second order.
    integer, parameter :: paraboloid_relaxation = 145
    !> MDR_COMPLEX_MODULUS. Complex shear modulus at angular frequencies omega > 0: storage and loss modulus [modulus].
    integer, parameter :: complex_modulus = 146
    !> MDR_STORAGE. Real part of a dynamic stiffness [modulus length].
    integer, parameter :: storage = 147
    !> MDR_LOSS. Imaginary part of a dynamic stiffness [modulus length].
    integer, parameter :: loss = 148
    !> MDR_TOTAL_PRESSURE. Of a gel: total pressure on the indenter.
    integer, parameter :: total_pressure = 149
    !> MDR_PORE_PRESSURE. Of a gel: pressure of the fluid at the surface; of a film only with MDR_DRAINAGE_SURFACE, where it is 0.
    integer, parameter :: pore_pressure = 150
    !> MDR_FLUX. Flux density through the contact area, 0 <= r < a; without a film infinite at the edge.
    integer, parameter :: flux = 161
    !> MDR_FLUX_Z. Flux density into a body.
    integer, parameter :: flux_z = 162
    !> MDR_FLUX_R. Flux density away from the axis.
    integer, parameter :: flux_r = 163
    !> MDR_POTENTIAL. Potential relative to the far field of the body.
    integer, parameter :: potential = 164
    !> MDR_CONDUCTANCE. Flux per potential of an equipotential contact area [conductance].
    integer, parameter :: conductance = 165
    !> MDR_RESISTANCE. Potential per flux of an equipotential contact area [1/conductance].
    integer, parameter :: resistance = 166
    !> MDR_MEAN_POTENTIAL. Area mean of the potential per flux under a uniform flux, without the film.
    integer, parameter :: mean_potential = 167
    !> MDR_CENTRE_POTENTIAL. Potential at the centre per flux under a uniform flux, without the film.
    integer, parameter :: centre_potential = 168
    !> MDR_GAUSSIAN_POTENTIAL. Mean potential over a Gaussian probe per flux of a Gaussian pump with radii w0 and w1 (1/e^2):
    !> `radius` is sqrt(w0^2 + w1^2).
    integer, parameter :: gaussian_potential = 169
    !> MDR_VON_MISES. Of a layer: largest von Mises stress; a metal yields at the yield stress.
    integer, parameter :: von_mises = 181
    !> MDR_TRESCA. Of a layer: largest (s_1 - s_3)/2; by Tresca's criterion a metal yields at half the yield stress.
    integer, parameter :: tresca = 182
    !> MDR_TENSION. Of a layer: largest principal stress s_1. A strength of the first layer applies also to its free surface.
    integer, parameter :: tension = 183
    !> MDR_INTERFACE_SHEAR. Of an interface: largest sqrt(s_rz^2 + s_tz^2).
    integer, parameter :: interface_shear = 184
    !> MDR_INTERFACE_TENSION. Of an interface: largest s_zz.
    integer, parameter :: interface_tension = 185
    !> MDR_FREE_SURFACE_TENSION. Of the free surface, a <= r <= 3 a: largest s_1, which opens ring cracks.
    integer, parameter :: free_surface_tension = 186

    ! enum mdr_load_kind
    !> MDR_LOAD_NORMAL. Pressure.
    integer, parameter :: load_normal = 901
    !> MDR_LOAD_SHEAR. Unidirectional traction along the surface, averaged over the directions of the wave.
    integer, parameter :: load_shear = 902
    !> MDR_LOAD_TWIST. Traction along the surface, normal to the wave vector; a traction around an axis consists of such waves.
    integer, parameter :: load_twist = 903
    !> MDR_LOAD_COUPLING. Normal displacement per traction along the wave vector, -i C, and displacement along the wave vector per
    !> pressure, i C, of waves exp(i k x); both positive into the body and along x.
    integer, parameter :: load_coupling = 904

    ! enum mdr_formula
    !> MDR_FORM_PARABOLOID_FORCE. R > 0, G0, G1, h: F(a) of a paraboloid without adhesion, equation (24): (16 a^3/(3R)) [G1 + (G0 -
    !> G1)/(2 pi) (4 arctan xi + xi^3 ln(1 + xi^-2) - xi)].
    integer, parameter :: form_paraboloid_force = 1101
    !> MDR_FORM_CONE_FORCE. phi, 0 < phi < pi/2 [radian], G0, G1, h: F(a) of a cone without adhesion, equation (27): 2 pi a^2
    !> tan(phi) [G1 + (G0 - G1) (2/pi) arctan(h/a)].
    integer, parameter :: form_cone_force = 1102
    !> MDR_FORM_ADHESIVE_DEPTH. R > 0, G0, G1, h, gamma >= 0: d(a) of an adhesive paraboloid with the edge condition (28), equation
    !> (29): a^2/R - sqrt(2 pi a gamma/E_eff(a)).
    integer, parameter :: form_adhesive_depth = 1103
    !> MDR_FORM_REDUCED_DEPTH. tau = G0/G1 > 0 [1], ht = h/a_c > 0 [1]: d/d_c at at = a/a_c, equation (32): at^2/3 - (4/3) sqrt(at)
    !> [1 + (tau - 1) I0(ht/at; nu = 1/2)]^(-1/2).
    integer, parameter :: form_reduced_depth = 1104
    !> MDR_FORM_RADIUS_SCALE. G1, gamma > 0: a_c = (pi gamma R^2/(32 G1))^(1/3) as a function of R, the contact radius at pull-off
    !> of an uncoated contact under depth control, equation (31).
    integer, parameter :: form_radius_scale = 1105
    !> MDR_FORM_DEPTH_SCALE. G1, gamma > 0: d_c = 3 (pi^2 gamma^2 R/(2^10 G1^2))^(1/3) as a function of R, minus the depth at that
    !> pull-off.
    integer, parameter :: form_depth_scale = 1106

    ! enum mdr_conduction_base
    !> MDR_BASE_HALF_SPACE. The last layer is a half-space.
    integer, parameter :: base_half_space = 1801
    !> MDR_BASE_PERFECT. A perfect conductor at potential 0.
    integer, parameter :: base_perfect = 1802
    !> MDR_BASE_INSULATING. No flux: steady states need a sink.
    integer, parameter :: base_insulating = 1803

    ! enum mdr_heat_motion
    !> MDR_HEAT_SLIDING. q = mu v p(r), at rest relative to both bodies: fretting, or low speeds.
    integer, parameter :: heat_sliding = 1901
    !> MDR_HEAT_SPINNING. q = mu omega r p(r) of a rotation about the axis: exact at any speed.
    integer, parameter :: heat_spinning = 1902
    !> MDR_HEAT_MOVING. q = mu v p(r), moving over the lower body with v a c/sigma <= 1000 and at rest relative to the upper one.
    !> Two bodies share the heat so that flux_mean is equal, an approximation.
    integer, parameter :: heat_moving = 1903

    ! enum mdr_adhesion_rule
    !> MDR_ADHESION_AUTOMATIC. MDR_ADHESION_ENERGY on media for which the energy balance is exact, MDR_ADHESION_PAPER on the others.
    integer, parameter :: adhesion_automatic = 801
    !> MDR_ADHESION_PAPER. dl = sqrt(2 pi a gamma/E_eff), equation (28).
    integer, parameter :: adhesion_paper = 802
    !> MDR_ADHESION_ENERGY. dl = sqrt(4 pi a gamma/k'(a)), the energy balance.
    integer, parameter :: adhesion_energy = 803

    ! enum mdr_branch
    !> MDR_ON_LOADING. The smallest contact radius, reached on approach.
    integer, parameter :: on_loading = 301
    !> MDR_ON_UNLOADING. The largest contact radius, kept on retraction; the usual choice.
    integer, parameter :: on_unloading = 302

    ! enum mdr_warning
    !> MDR_WARNING_SLOPE. The slope f'(a) of the indenter at the contact edge exceeds 1.2: 50 degrees, or a = 1.2 R of a paraboloid,
    !> which represents a sphere only for a much smaller than R.
    integer, parameter :: warning_slope = 1
    !> MDR_WARNING_PRESSURE. The mean pressure exceeds 0.6 of E_eff(a) and of the contact modulus of the surface, for example under
    !> a flat punch at depths beyond 0.94 a. Not set together with MDR_WARNING_SLOPE if the slope is the cause.
    integer, parameter :: warning_pressure = 2
    !> MDR_WARNING_COMPRESSION. Layers are compressed by more than half of their thickness. On a rigid base the depth is compared
    !> with the thickness; on an elastic one the depth minus F/(a E1*), the largest possible displacement of the base.
    integer, parameter :: warning_compression = 4
    !> MDR_WARNING_CONTRAST. Young's moduli differ by a factor of 1e9 or more, for example because of mixed units (GPa and Pa).
    integer, parameter :: warning_contrast = 8
    !> MDR_WARNING_SHORT_ZONE. The cohesive zone is too short to affect the result and is neglected: the JKR limit applies.
    integer, parameter :: warning_short_zone = 16
    !> MDR_WARNING_WETTING. The work of adhesion exceeds 0.05 of the surface tension, or under a plate 0.05 of B^(1/3) (0.5
    !> E*)^(2/3): the slope of the surface at the edge is not small.
    integer, parameter :: warning_wetting = 32

    ! enum mdr_which_body
    !> MDR_BODY_LOWER. The medium, or the lower of two bodies.
    integer, parameter :: body_lower = 401
    !> MDR_BODY_UPPER. The upper of two deformable bodies. A rigid indenter does not count as a body.
    integer, parameter :: body_upper = 402

    ! enum mdr_side
    !> MDR_SIDE_BELOW. The side of larger depth.
    integer, parameter :: side_below = 501
    !> MDR_SIDE_ABOVE. The side of smaller depth.
    integer, parameter :: side_above = 502

    ! enum mdr_fit_data_kind
    !> MDR_FIT_FORCE_DEPTH. Indentation depth [length] and force [modulus length^2].
    integer, parameter :: fit_force_depth = 1501
    !> MDR_FIT_STIFFNESS_DEPTH. Indentation depth [length] and contact stiffness > 0 [modulus length]; `given`: force at each point
    !> [modulus length^2] (dynamic nanoindentation).
    integer, parameter :: fit_stiffness_depth = 1502
    !> MDR_FIT_MODULUS_RADIUS. Contact radius > 0 [length] and effective contact modulus [modulus].
    integer, parameter :: fit_modulus_radius = 1503
    !> MDR_FIT_STIFFNESS_RADIUS. Contact radius > 0 [length] and contact stiffness [modulus length].
    integer, parameter :: fit_stiffness_radius = 1504
    !> MDR_FIT_FORCE_TIME. Ascending times [time] and force [modulus length^2] of a viscoelastic body; `given`: indentation depth at
    !> each time [length], linear in between, see mdr_contact_history().
    integer, parameter :: fit_force_time = 1505
    !> MDR_FIT_DEPTH_TIME. Ascending times [time] and indentation depth [length]; `given`: force [modulus length^2].
    integer, parameter :: fit_depth_time = 1506
    !> MDR_FIT_DYNAMIC_STIFFNESS. Angular frequency > 0 [1/time] and real or imaginary part of the dynamic stiffness [modulus
    !> length], selected for each point by `branch`: MDR_STORAGE or MDR_LOSS; `given`: contact radius > 0 [length]; see
    !> mdr_contact_dynamic_stiffness().
    integer, parameter :: fit_dynamic_stiffness = 1507

    ! enum mdr_fit_instrument
    !> MDR_FIT_WORK_OF_ADHESION. gamma >= 0; the start value must exceed 0 [modulus length].
    integer, parameter :: fit_work_of_adhesion = 0
    !> MDR_FIT_DEPTH_OFFSET. Depth reading at initial contact [length].
    integer, parameter :: fit_depth_offset = 1
    !> MDR_FIT_FORCE_OFFSET. Force reading at initial contact [modulus length^2].
    integer, parameter :: fit_force_offset = 2
    !> MDR_FIT_FRAME_COMPLIANCE. Compliance of the instrument frame [1/(modulus length)].
    integer, parameter :: fit_frame_compliance = 3
    !> MDR_FIT_INDENTER_MODULUS. Contact modulus E*_i of the indenter > 0, homogeneous, combined with the medium as in
    !> mdr_medium_pair(); INFINITY: rigid [modulus].
    integer, parameter :: fit_indenter_modulus = 4
    !> MDR_FIT_CONTACT_DEPTH_FACTOR. epsilon of the contact depth h_c = h - epsilon P/S on a half-space (Oliver, Pharr 1992);
    !> usually 0.75, that of a paraboloid; 0 or less for pile-up. On any other body the sink-in is that of the same indenter c r^n:
    !> (d - f(a)) k/F of the exact contact replaces epsilon [1].
    integer, parameter :: fit_contact_depth_factor = 5
    !> MDR_FIT_STIFFNESS_FACTOR. beta of S = 2 beta a E_r; usually 1 [1].
    integer, parameter :: fit_stiffness_factor = 6
    !> MDR_FIT_CONTACT_DEPTH_SCALE. Factor of h_c, usually 1; 1.2 with epsilon = 1: Loubet's contact depth [1].
    integer, parameter :: fit_contact_depth_scale = 7
    !> MDR_FIT_AREA_FACTOR. Ratio of the true to the assumed projected contact area, for all data except force against depth;
    !> usually 1 [1].
    integer, parameter :: fit_area_factor = 8
    !> MDR_FIT_COHESIVE_STRESS. sigma_0 >= 0: finite-range adhesion, as in mdr_contact_options; 0: the JKR limit [modulus].
    integer, parameter :: fit_cohesive_stress = 9
    !> MDR_FIT_INSTRUMENT_COUNT. Number of parameters of the instrument.
    integer, parameter :: fit_instrument_count = 10

    ! enum mdr_fit_loss
    !> MDR_FIT_LINEAR. r^2: least squares.
    integer, parameter :: fit_linear = 1601
    !> MDR_FIT_HUBER. r^2 up to s, linear in r beyond.
    integer, parameter :: fit_huber = 1602
    !> MDR_FIT_CAUCHY. s^2 ln(1 + r^2/s^2).
    integer, parameter :: fit_cauchy = 1603

    ! enum mdr_shear_direction
    !> MDR_ALONG. Displacement of the indenter along the surface.
    integer, parameter :: along = 601
    !> MDR_AROUND. Rotation of the indenter about its axis.
    integer, parameter :: around = 602

    ! enum mdr_shape
    !> MDR_SHAPE_LAYER. z_top, z_bottom > z_top; INFINITY is possible.
    integer, parameter :: shape_layer = 1401
    !> MDR_SHAPE_HALF_SPACE. x, y, z of a point on the interface; x, y, z of the normal into the material, of any length.
    integer, parameter :: shape_half_space = 1402
    !> MDR_SHAPE_BALL. x, y, z of the centre; radius > 0.
    integer, parameter :: shape_ball = 1403
    !> MDR_SHAPE_FIBRE. Infinite circular cylinder: x, y, z of a point on the axis; x, y, z of its direction, of any length; radius
    !> > 0.
    integer, parameter :: shape_fibre = 1404
    !> MDR_SHAPE_PILLAR. Vertical circular cylinder: x, y of the axis; radius > 0; z_top, z_bottom > z_top; INFINITY is possible.
    integer, parameter :: shape_pillar = 1405
    !> MDR_SHAPE_BOX. x_low, x_high, y_low, y_high, z_top, z_bottom, ascending in pairs.
    integer, parameter :: shape_box = 1406

    ! enum mdr_law_format
    !> MDR_LAW_FORMAT. This version.
    integer, parameter :: law_format = 1296843314

    ! enum mdr_limit
    !> MDR_LIMIT_GLASSY. The instantaneous response.
    integer, parameter :: limit_glassy = 701
    !> MDR_LIMIT_RELAXED. The long-time response.
    integer, parameter :: limit_relaxed = 702

    ! enum mdr_model
    !> MDR_MODEL_GAO. Gao's weights, moduli in parallel, equations (12)-(16); the model of Popov (2014).
    integer, parameter :: model_gao = 201
    !> MDR_MODEL_GAO_SERIES. Gao's weights, 1/G in series; at large contrast much more accurate.
    integer, parameter :: model_gao_series = 202
    !> MDR_MODEL_DOERNER_NIX. 1/E_eff = (1 - e^(-alpha xi))/E*0 + e^(-alpha xi)/E*1, equation (11). alpha is a fitted constant.
    integer, parameter :: model_doerner_nix = 203
    !> MDR_MODEL_WAVE. Response to a wave of wavenumber q = wave_factor/a, equations (19), (20). Exact for antiplane shear.
    integer, parameter :: model_wave = 204
    !> MDR_MODEL_MENCIK_EXPONENTIAL. E_eff = E*1 + (E*0 - E*1) e^(-alpha x). alpha is a fitted constant.
    integer, parameter :: model_mencik_exponential = 205
    !> MDR_MODEL_MENCIK_RECIPROCAL. 1/E_eff = 1/E*1 + (1/E*0 - 1/E*1) e^(-alpha x). alpha is a fitted constant.
    integer, parameter :: model_mencik_reciprocal = 206
    !> MDR_MODEL_BEC. Bec et al. 2006: film and substrate as springs in series.
    integer, parameter :: model_bec = 207
    !> MDR_MODEL_PERRIOT_BARTHEL. Perriot, Barthel 2004: a fit to their exact solution.
    integer, parameter :: model_perriot_barthel = 208
    !> MDR_MODEL_HAY_CRAWFORD. Hay, Crawford 2011: Gao's weights, with the film also in parallel; E_eff = 2 G_eff/(1 - nu_eff) with
    !> Gao's nu_eff.
    integer, parameter :: model_hay_crawford = 209
    !> MDR_MODEL_DIMITRIADIS. Dimitriadis et al. 2002: layer with nu = 1/2 bonded to a rigid base, under a paraboloid or a sphere, a
    !> < h. Other cases return MDR_EINVALID.
    integer, parameter :: model_dimitriadis = 210
    !> MDR_MODEL_GARCIA. Garcia, Garcia 2018: the same layer with their coefficients.
    integer, parameter :: model_garcia = 211
    !> MDR_MODEL_EXACT. Exact solution of the layered half-space.
    integer, parameter :: model_exact = 212
    !> MDR_MODEL_GAO_POWER. Gao's weights, power mean G_eff = [G1^p + (G0^p - G1^p) I0]^(1/p) of both moduli.
    integer, parameter :: model_gao_power = 213

    ! enum mdr_model_base
    !> MDR_BASE_ELASTIC. An elastic half-space.
    integer, parameter :: base_elastic = 1301
    !> MDR_BASE_ANY. An elastic half-space or a rigid base.
    integer, parameter :: base_any = 1302
    !> MDR_BASE_RIGID. A rigid base.
    integer, parameter :: base_rigid = 1303

    ! enum mdr_weight_nu
    !> MDR_WEIGHT_NU_SURFACE. That of the surface: the most accurate on average; the default.
    integer, parameter :: weight_nu_surface = 1201
    !> MDR_WEIGHT_NU_SUBSTRATE. Poisson's ratio of the substrate.
    integer, parameter :: weight_nu_substrate = 1202
    !> MDR_WEIGHT_NU_EFFECTIVE. The effective one at the same contact radius.
    integer, parameter :: weight_nu_effective = 1203
    !> MDR_WEIGHT_NU_GIVEN. The value of weight_nu.
    integer, parameter :: weight_nu_given = 1204

    ! enum mdr_drainage
    !> MDR_DRAINAGE_SURFACE. The fluid drains everywhere, also under the indenter, which is porous or leaks along the interface.
    integer, parameter :: drainage_surface = 1701
    !> MDR_DRAINAGE_SEALED. No flux through the surface anywhere.
    integer, parameter :: drainage_sealed = 1702
    !> MDR_DRAINAGE_INDENTER. No flux under the indenter; pore pressure 0 outside.
    integer, parameter :: drainage_indenter = 1703

    ! enum mdr_wear_places
    !> MDR_WEAR_FRESH. The indenter always slides on fresh places of the body: only the indenter changes.
    integer, parameter :: wear_fresh = 2001
    !> MDR_WEAR_SAME. The same places slide on each other, in oscillations much shorter than a: both sides change.
    integer, parameter :: wear_same = 2002

    ! enum mdr_wear_scheme
    !> MDR_WEAR_DISC. A disc that moves with the contact edge; second order with extrapolation: with 80 intervals the errors of a, d
    !> and F are about 1e-4 on bodies of any layers. For contacts that do not shrink; not for a flat punch.
    integer, parameter :: wear_disc = 2101
    !> MDR_WEAR_RINGS. Rings fixed to the indenter; first order: with 80 intervals the error of a is some 1e-3, that of p 1e-2, but
    !> the worn volume k F s is exact to machine precision. For any path of load and depth, and for a flat punch.
    integer, parameter :: wear_rings = 2102

    ! enum mdr_weight_kind
    !> MDR_WEIGHT_PHI. Phi(xi) = dI0/dxi, weight of the depth a xi; equation (18) at nu = 1/2.
    integer, parameter :: weight_phi = 1001
    !> MDR_WEIGHT_I0. I0(xi), weight of the shear modulus above the depth a xi, equations (12)-(15).
    integer, parameter :: weight_i0 = 1002
    !> MDR_WEIGHT_I1. I1(xi), weight of Poisson's ratio above the depth a xi; it does not depend on nu, which must still be valid.
    integer, parameter :: weight_i1 = 1003
    !> MDR_WEIGHT_J0. 1 - I0, weight of the material below, with full relative accuracy.
    integer, parameter :: weight_j0 = 1004
    !> MDR_WEIGHT_J1. 1 - I1, with full relative accuracy.
    integer, parameter :: weight_j1 = 1005
    !> MDR_WEIGHT_I0_TANGENTIAL. I0 of a tangential load, weight of the shear modulus in the tangential stiffness, I1 + [xi L -
    !> xi/(1 + xi^2)]/(2 pi (2 - nu)) with L = ln(1 + 1/xi^2). The weight of Poisson's ratio is again I1.
    integer, parameter :: weight_i0_tangential = 1006
    !> MDR_WEIGHT_J0_TANGENTIAL. 1 - I0 of a tangential load, with full relative accuracy.
    integer, parameter :: weight_j0_tangential = 1007

    !> The codes in ascending order, statuses first, and their words.
    integer, parameter :: numbers(*) = [0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 101, 102, 103, 104, 105, 106, 107, 108, 111, 112, 113, 114, &
        121, 122, 123, 124, 131, 132, 133, 134, 135, 136, 137, 141, 142, 143, 144, 145, 146, 147, 148, 149, 150, 161, 162, 163, &
        164, 165, 166, 167, 168, 169, 181, 182, 183, 184, 185, 186, 201, 202, 203, 204, 205, 206, 207, 208, 209, 210, 211, 212, &
        213, 301, 302, 401, 402, 501, 502, 601, 602, 701, 702, 801, 802, 803, 901, 902, 903, 904, 1001, 1002, 1003, 1004, 1005, &
        1006, 1007, 1101, 1102, 1103, 1104, 1105, 1106, 1201, 1202, 1203, 1204, 1301, 1302, 1303, 1401, 1402, 1403, 1404, 1405, &
        1406, 1501, 1502, 1503, 1504, 1505, 1506, 1507, 1601, 1602, 1603, 1701, 1702, 1703, 1801, 1802, 1803, 1901, 1902, 1903, &
        2001, 2002, 2101, 2102]
    character(len=21), parameter :: words(*) = [character(len=21) :: "success", "null", "invalid", "domain", "unreachable", &
        "no-convergence", "no-memory", "callback", "file", "cancelled", "depth", "force", "radius", "spring", "shift", &
        "tangential_force", "twist", "torque", "height", "height_slope", "g", "g_slope", "modulus", "stiffness", &
        "tangential_modulus", "torsional_stiffness", "pressure", "displacement", "line_load", "displacement_lower", &
        "displacement_upper", "traction", "tangential_line_load", "relaxation", "creep", "mean_relaxation", "mean_creep", &
        "paraboloid_relaxation", "complex_modulus", "storage", "loss", "total_pressure", "pore_pressure", "flux", "flux_z", &
        "flux_r", "potential", "conductance", "resistance", "mean_potential", "centre_potential", "gaussian_potential", &
        "von_mises", "tresca", "tension", "interface_shear", "interface_tension", "free_surface_tension", "gao", "gao-series", &
        "doerner-nix", "wave", "mencik-exponential", "mencik-reciprocal", "bec", "perriot-barthel", "hay-crawford", "dimitriadis", &
        "garcia", "exact", "gao-power", "loading", "unloading", "lower", "upper", "below", "above", "along", "around", "glassy", &
        "relaxed", "automatic", "paper", "energy", "normal", "shear", "twist", "coupling", "phi", "i0", "i1", "j0", "j1", &
        "i0-tangential", "j0-tangential", "paraboloid-force", "cone-force", "adhesive-depth", "reduced-depth", "radius-scale", &
        "depth-scale", "surface", "substrate", "effective", "given", "elastic", "any", "rigid", "layer", "half-space", "ball", &
        "fibre", "pillar", "box", "force-depth", "stiffness-depth", "modulus-radius", "stiffness-radius", "force-time", &
        "depth-time", "dynamic-stiffness", "linear", "huber", "cauchy", "surface", "sealed", "indenter", "half-space", "perfect", &
        "insulating", "sliding", "spinning", "moving", "fresh", "same", "disc", "rings"]

contains

    !> Name of a code, the same in all languages and problem files; empty for a number that is not a code.
    pure function word_of(code) result(word)
        !> of any enumeration
        integer, intent(in) :: code
        character(len=len(words)) :: word
        integer :: place

        word = ""
        place = findloc(numbers, code, dim=1)
        if (place > 0) word = words(place)
    end function word_of

    !> The codes of the enumeration that a code belongs to; none for a number that is no code.
    pure function codes_beside(code) result(codes)
        integer, intent(in) :: code
        integer, allocatable :: codes(:)

        codes = pack(numbers, numbers - modulo(numbers, 100) == code - modulo(code, 100) .and. any(numbers == code))
    end function codes_beside

end module mdrcontact_codes
