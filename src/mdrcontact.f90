! SPDX-License-Identifier: GPL-3.0-or-later
!> The public Fortran surface of the library: `use mdrcontact, only: ...`.
!>
!> In comments the unit of each number is in brackets: [length], [modulus] (that of pressure), [1] for none; any consistent set
!> does. Angles are in radian. Equation numbers such as (10) are those of Popov (2014). The pages in docs/theory/ state the
!> equations, under numbers such as (3.1).
!>
!> The procedures compute in the arithmetic of the caller, which must be the default: rounding to nearest.
module mdrcontact
    use mdrcontact_parameter, only: nature_fraction, nature_not_negative, nature_poisson, nature_positive, nature_signed, &
                                         nature_term, parameter_t
    use mdrcontact_body, only: body_t
    use mdrcontact_body_compliance, only: compliance_t, coupling_load, normal_load, shear_load, twist_load
    use mdrcontact_body_graded, only: graded_body_t, new_graded_body, new_graded_body_from_functions
    use mdrcontact_body_stack, only: new_stack, stack_t
    use mdrcontact_body_elements_interface, only: bond_t
    use mdrcontact_body_wrinkling, only: find_wrinkling
    use mdrcontact_contact_control, only: control_t, depth_control, force_control
    use mdrcontact_contact_closed_forms, only: adhesive_depth_scale, adhesive_radius_scale, coated_cone_force, &
                                               coated_paraboloid_adhesive_depth, coated_paraboloid_force, reduced_adhesive_depth
    use mdrcontact_cancel, only: cancel_function, set_cancel, set_progress
    use mdrcontact_contact_warnings, only: contact_warning_t, warning_compression, warning_contrast, warning_pressure, warning_slope
    use mdrcontact_contact, only: contact_options_t, contact_t, new_contact, on_loading, on_unloading
    use mdrcontact_contact_load, only: contact_load_t
    use mdrcontact_contact_state, only: contact_state_t
    use mdrcontact_contact_values, only: contact_states, field_displacement, field_displacement_lower, &
                                         field_displacement_upper, field_line_load, field_pressure, given_depth, given_force, &
                                         given_radius, load_field
    use mdrcontact_contact_equilibrium, only: adhesion_automatic, adhesion_energy, adhesion_paper
    use mdrcontact_error, only: error_callback, error_cancelled, error_domain, error_file, error_invalid, error_memory, &
                                error_no_convergence, error_t, error_unreachable
    use mdrcontact_codes, only: free_surface_tension, interface_shear, interface_tension, tension, tresca, von_mises, word_of
    use mdrcontact_inside, only: interior, interior_error, layer_energy
    use mdrcontact_inside_critical, only: critical
    use mdrcontact_inside_failure, only: failure_load_t, first_failure, strength_t
    use mdrcontact_inside_largest, only: maximum_t
    use mdrcontact_fit, only: fit_result_t, solve_fit
    use mdrcontact_fit_body, only: fit_body_t, new_fit_body
    use mdrcontact_fit_interval, only: profile_interval
    use mdrcontact_fit_predict, only: predict
    use mdrcontact_fit_problem, only: at_contact_depth_factor, at_depth_offset, at_force_offset, at_frame_compliance, &
                                      at_indenter_modulus, at_stiffness_factor, at_work_of_adhesion, data_depth_time, &
                                      data_dynamic_stiffness, data_force_depth, data_force_time, data_modulus_radius, &
                                      data_stiffness_depth, data_stiffness_radius, fit_data_t, fit_parameter_t, fit_problem_t, &
                                      instrument_numbers, loss_cauchy, loss_huber, loss_linear, part_loss, part_storage, &
                                      problem_parameters, start_parameters
    use mdrcontact_friction_partial_slip, only: first_shear_t, friction_t, new_friction, tangential_state_t
    use mdrcontact_friction_history, only: friction_history_t, given_shift, given_tangential_force, new_friction_history
    use mdrcontact_friction_law, only: new_contact_law
    use mdrcontact_adhesion_rate_contact, only: new_rate_contact, rate_contact_t
    use mdrcontact_adhesion_cohesive_history, only: cohesive_columns, cohesive_history
    use mdrcontact_adhesion_rate_history, only: rate_history
    use mdrcontact_adhesion_rate_law, only: new_rate_law, new_surface_law, rate_law_t
    use mdrcontact_adhesion_rate_state, only: rate_state_t
    use mdrcontact_time_history, only: contact_history
    use mdrcontact_contact_relaxing_contact, only: new_relaxing_contact, relaxing_contact_t
    use mdrcontact_time_stiffness, only: dynamic_stiffness, step_creep, step_relaxation, step_response
    use mdrcontact_kinds, only: wp
    use mdrcontact_layout, only: same_layout
    use mdrcontact_lateral_density, only: deviatoric_weight, lateral_density, volumetric_weight
    use mdrcontact_lateral_field, only: field_structure_t, field_t, new_field_structure
    use mdrcontact_lateral_medium, only: new_lateral_medium
    use mdrcontact_lateral_shape, only: new_shape, shape_box, shape_fibre, shape_half_space, shape_layer, shape_pillar, &
                                        shape_ball, shape_t
    use mdrcontact_lateral_shapes, only: new_shapes, shapes_t
    use mdrcontact_lateral_structure, only: structure_t
    use mdrcontact_lateral_voxels, only: new_voxels, voxels_t
    use mdrcontact_lateral_values, only: density_values, structure_values
    use mdrcontact_law, only: contact_law_t, law_point_t
    use mdrcontact_law_from_contact, only: law_options_t
    use mdrcontact_law_friction, only: contact_steps_t, friction_law_t
    use mdrcontact_law_file, only: load_law, save_law
    use mdrcontact_medium_exact, only: layered_exact_t, new_layered_exact
    use mdrcontact_line_shared, only: kernel_cache_t
    use mdrcontact_contact_loop, only: loop_t, new_loop, spring_control
    use mdrcontact_material, only: material_t, new_material, new_transverse
    use mdrcontact_material_transverse, only: from_engineering, from_stiffness, transverse_t
    use mdrcontact_material_rheology, only: new_elastic_rheology, new_power_law_rheology, new_viscoelastic, rheology_t
    use mdrcontact_medium, only: medium_t, new_medium, new_pair
    use mdrcontact_medium_load, only: load_t, lower_body, upper_body
    use mdrcontact_medium_solver, only: solved_t, solver_t
    use mdrcontact_medium_values, only: modulus_values
    use mdrcontact_medium_compliance, only: compliance_limits, compliance_limits_t, surface_compliance
    use mdrcontact_medium_response, only: new_response, point_response, rectangle_response, response_t
    use mdrcontact_medium_gao, only: gao_nu_effective, gao_nu_given, gao_nu_substrate, gao_nu_surface, gao_options_t, gao_t, &
                                     new_gao, new_gao_layered
    use mdrcontact_medium_bec, only: bec_t, new_bec
    use mdrcontact_medium_bottom_effect, only: bottom_effect_t, dimitriadis_series, garcia_series, new_bottom_effect
    use mdrcontact_medium_doerner_nix, only: doerner_nix_t, new_doerner_nix
    use mdrcontact_medium_graded, only: graded_t, new_graded
    use mdrcontact_medium_hay_crawford, only: hay_crawford_t, new_hay_crawford
    use mdrcontact_medium_mencik, only: mencik_t, new_mencik
    use mdrcontact_medium_perriot_barthel, only: new_perriot_barthel, perriot_barthel_t
    use mdrcontact_medium_power_graded, only: new_power_graded, power_graded_t
    use mdrcontact_medium_tabulated, only: new_medium_from_function, new_tabulated_medium, tabulated_medium_t
    use mdrcontact_medium_viscoelastic, only: new_viscoelastic_medium, viscoelastic_t
    use mdrcontact_medium_wave, only: new_wave, wave_t
    use mdrcontact_medium_homogeneous, only: homogeneous_t, new_homogeneous, new_homogeneous_from_modulus, new_rigid
    use mdrcontact_model, only: model_options_t, models, new_solver
    use mdrcontact_conduction_along, only: conductance_along
    use mdrcontact_conduction_answers, only: admittance_of, flux_after_step, follow_history, step_of, spot_conductance_answer, &
                                             spot_resistance_answer
    use mdrcontact_conduction_bodies, only: conduction_t, new_conduction
    use mdrcontact_conduction_conductors, only: conductor_t, conductors_t, half_space_base, insulating_base, new_conductors, &
                                                perfect_base
    use mdrcontact_conduction_fields, only: conductance_at, flux_at, inside_at
    use mdrcontact_conduction_heat, only: friction_heat, heat_field, heat_t
    use mdrcontact_conduction_moving, only: moving_heat
    use mdrcontact_conduction_rough, only: joint_conductance, rough_conductance
    use mdrcontact_conduction_rough_law, only: joint_resistance => micro_resistance
    use mdrcontact_conduction_source, only: sliding, spinning
    use mdrcontact_conduction_table, only: tabulate_conductance
    use mdrcontact_conduction_transient, only: gaussian, uniform_centre, uniform_mean
    use mdrcontact_plastic_cap, only: cap_state_t, cap_t, new_cap, truncated_hertz
    use mdrcontact_plastic_overload, only: new_overload, overload_state_t, overload_t
    use mdrcontact_plastic_imprint, only: imprint_t, new_imprint, new_imprint_from_pressure, new_imprint_of_two_terms
    use mdrcontact_plastic_law, only: plastic_law_t, plastic_steps_t
    use mdrcontact_plastic_law_coated, only: new_plastic_law_from_overload
    use mdrcontact_plastic_law_new, only: new_plastic_law, new_plastic_law_from_points, plastic_options_t, &
                                          plastic_law_with_radius => with_radius
    use mdrcontact_plastic_profile, only: imprint_profile_t
    use mdrcontact_plastic_yielding, only: new_elastic, new_yielding, yield_stress_from_hardness, yielding_t
    use mdrcontact_poroelastic_gel, only: drains_by_surface, sealed, sealed_by_indenter
    use mdrcontact_poroelastic_compliance, only: poroelastic_compliance
    use mdrcontact_poroelastic_history, only: poroelastic_history
    use mdrcontact_poroelastic_response, only: gel_creep => creep, gel_mean_creep => mean_creep, &
                                               gel_mean_relaxation => mean_relaxation, gel_paraboloid => paraboloid, &
                                               gel_relaxation => relaxation, poroelastic_dynamic_stiffness, poroelastic_pressure, &
                                               poroelastic_response, &
                                               pore_pressure, total_pressure
    use mdrcontact_poroelastic_table, only: new_poroelastic, poroelastic_t
    use mdrcontact_profile, only: profile_t
    use mdrcontact_profile_power_law, only: new_cone, new_paraboloid, new_power_law, power_law_t
    use mdrcontact_profile_area_function, only: area_function_t, new_area_function_profile
    use mdrcontact_profile_flat_ended, only: flat_ended_t, new_flat_cone, new_flat_paraboloid
    use mdrcontact_profile_flat_punch, only: flat_punch_t, new_flat_punch
    use mdrcontact_profile_rounded_cone, only: new_rounded_cone, rounded_cone_t
    use mdrcontact_profile_sampled, only: sampled_profile_t
    use mdrcontact_profile_sphere, only: new_sphere, sphere_t
    use mdrcontact_profile_values, only: of_height, of_mdr, of_mdr_slope, of_slope, profile_values
    use mdrcontact_profile_sum, only: new_profile_sum, profile_sum_t, profile_term_t
    use mdrcontact_profile_tabulated, only: new_profile_from_function, new_profile_from_mdr, new_tabulated_profile
    use mdrcontact_profile_worn, only: worn_profile_t
    use mdrcontact_numerics_radius_law, only: new_radius_law_from_function, new_radius_law_from_table, radius_law_t
    use mdrcontact_numerics_scalar_function, only: scalar_function_t
    use mdrcontact_tension_surface, only: surface_t
    use mdrcontact_version, only: version_major, version_minor, version_patch, version_string
    use mdrcontact_wear, only: new_wear, wear_t
    use mdrcontact_wear_history, only: fixed_rings, moving_disc, new_wear_history, wear_history_t, wear_past_t, wear_state_t
    use mdrcontact_wear_limit, only: wear_limit_t
    use mdrcontact_weights, only: weight_i0, weight_i0_tangential, weight_i1, weight_j0, weight_j0_tangential, weight_j1, &
                                  weight_phi
    use mdrcontact_words, only: code_of
    implicit none (type, external)
    public
end module mdrcontact
