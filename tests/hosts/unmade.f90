! SPDX-License-Identifier: GPL-3.0-or-later
!> A host that hands over objects that were never made: each public procedure that takes one reports it.
program unmade
    use mdrcontact, only: admittance_of, area_function_t, bec_t, body_t, bond_t, bottom_effect_t, cohesive_history, &
                          conductance_along, conductance_at, conduction_t, conductors_t, contact_history, contact_law_t, &
                          contact_load_t, contact_options_t, contact_state_t, contact_states, contact_steps_t, contact_t, &
                          contact_warning_t, control_t, critical, doerner_nix_t, dynamic_stiffness, error_invalid, error_t, &
                          failure_load_t, find_wrinkling, first_failure, first_shear_t, fit_body_t, fit_data_t, fit_problem_t, &
                          fit_result_t, flux_after_step, flux_at, follow_history, friction_heat, friction_history_t, &
                          friction_law_t, friction_t, gao_t, graded_body_t, graded_t, hay_crawford_t, heat_field, heat_t, &
                          homogeneous_t, inside_at, interior, interior_error, kernel_cache_t, law_point_t, layer_energy, &
                          layered_exact_t, load_field, loop_t, material_t, maximum_t, medium_t, mencik_t, model_options_t, &
                          modulus_values, moving_heat, new_bec, new_bottom_effect, new_conduction, new_contact, new_doerner_nix, &
                          new_fit_body, new_friction, new_friction_history, new_gao, new_gao_layered, new_graded, &
                          new_hay_crawford, new_homogeneous, new_lateral_medium, new_layered_exact, new_loop, new_material, &
                          new_medium, new_mencik, new_pair, new_perriot_barthel, new_rate_contact, new_relaxing_contact, &
                          new_shape, new_shapes, new_solver, new_sphere, new_stack, new_surface_law, new_viscoelastic_medium, &
                          new_voxels, new_wave, new_wear, new_wear_history, perriot_barthel_t, poroelastic_dynamic_stiffness, &
                          poroelastic_history, poroelastic_pressure, poroelastic_response, poroelastic_t, predict, &
                          profile_interval, profile_t, rate_contact_t, rate_history, rate_law_t, rate_state_t, &
                          relaxing_contact_t, rheology_t, rough_conductance, save_law, shape_t, shapes_t, solve_fit, solver_t, &
                          sphere_t, stack_t, step_of, step_response, strength_t, structure_values, tabulate_conductance, &
                          tabulated_medium_t, tangential_state_t, viscoelastic_t, voxels_t, wave_t, wear_history_t, wear_limit_t, &
                          wear_t, worn_profile_t, wp
    implicit none (type, external)
    integer :: checked, failed

    checked = 0
    failed = 0
    call of_core(checked, failed)
    call of_extensions(checked, failed)
    call of_failed_makers(checked, failed)
    call of_stale_errors(checked, failed)
    print "(a, i0, a, i0, a)", "unmade: ", checked, " checks, ", failed, " failed"
    if (failed > 0 .or. checked == 0) error stop

contains

    subroutine expect(name, error, checked, failed)
        character(len=*), intent(in) :: name
        type(error_t), allocatable, intent(inout) :: error
        integer, intent(inout) :: checked, failed
        logical :: right

        checked = checked + 1
        right = allocated(error)
        if (right) right = error%code == error_invalid .and. index(error%message, "has not been made") > 0
        if (.not. right) then
            failed = failed + 1
            print "(2a)", name, ": no error, or another one"
            if (allocated(error)) print "(a)", error%message
        end if
        if (allocated(error)) deallocate (error)
    end subroutine expect

    !> Core.
    subroutine of_core(checked, failed)
        integer, intent(inout) :: checked, failed
        type(stack_t) :: made_stack
        type(material_t) :: material_list(2)
        type(material_t) :: material
        type(bond_t) :: bond_list(2)
        type(contact_t) :: made_contact
        type(sphere_t) :: sphere
        type(medium_t) :: medium
        type(layered_exact_t) :: layered_exact
        type(contact_t) :: contact
        type(contact_state_t) :: contact_state_list(2)
        type(contact_load_t) :: contact_load
        type(maximum_t), allocatable :: any_maximum_list(:)
        type(strength_t) :: strength_list(2)
        type(failure_load_t), allocatable :: any_failure_load_list(:)
        type(friction_t) :: made_friction
        type(friction_history_t) :: made_friction_history
        type(friction_t) :: friction
        type(control_t) :: control
        type(rheology_t) :: rheology
        type(relaxing_contact_t) :: made_relaxing_contact
        type(viscoelastic_t) :: viscoelastic
        type(contact_law_t) :: contact_law
        type(layered_exact_t) :: made_layered_exact
        type(stack_t) :: stack
        type(homogeneous_t) :: homogeneous
        type(loop_t) :: made_loop
        type(medium_t) :: made_medium
        type(gao_t) :: made_gao
        type(bec_t) :: made_bec
        type(bottom_effect_t) :: made_bottom_effect
        type(doerner_nix_t) :: made_doerner_nix
        type(graded_t) :: made_graded
        type(hay_crawford_t) :: made_hay_crawford
        type(mencik_t) :: made_mencik
        type(perriot_barthel_t) :: made_perriot_barthel
        type(viscoelastic_t) :: made_viscoelastic
        type(rheology_t) :: rheology_list(2)
        type(model_options_t) :: model_options
        type(wave_t) :: made_wave
        class(solver_t), allocatable :: any_layered_exact
        type(contact_state_t) :: contact_state
        class(body_t), allocatable :: any_stack
        type(graded_body_t) :: graded_body
        type(contact_state_t) :: made_contact_state
        type(contact_load_t) :: made_contact_load
        type(contact_warning_t), allocatable :: any_contact_warning_list(:)
        type(first_shear_t) :: first_shear
        type(tangential_state_t) :: made_tangential_state
        type(tangential_state_t) :: tangential_state
        type(first_shear_t) :: made_first_shear
        type(friction_history_t) :: friction_history
        type(law_point_t) :: made_law_point
        type(contact_law_t) :: made_contact_law
        type(friction_law_t) :: friction_law
        type(material_t) :: made_material
        type(rheology_t) :: made_rheology
        type(kernel_cache_t) :: kernel_cache
        class(profile_t), allocatable :: any_sphere
        type(area_function_t) :: area_function
        real(wp) :: x(2)
        real(wp) :: y(2, 3)
        real(wp) :: values(3)
        real(wp) :: place(3), traction(3)
        real(wp) :: five(0:4)
        real(wp) :: table(8, 2)
        real(wp), allocatable :: found(:)
        integer :: number
        type(error_t), allocatable :: error

        x = 1.0_wp
        y = 1.0_wp
        place = 1.0_wp
        five = 1.0_wp
        number = 1
        call new_stack(made_stack, material_list, x, material, error)
        call expect("new_stack", error, checked, failed)
        call find_wrinkling(material_list, x, material, .false., bond_list, 1, values(1), values(2), error)
        call expect("find_wrinkling", error, checked, failed)
        call new_contact(made_contact, sphere, medium, error)
        call expect("new_contact", error, checked, failed)
        call new_contact(made_contact, sphere, layered_exact, error)
        call expect("new_contact", error, checked, failed)
        call contact_states(contact, 1, x, contact_state_list, error)
        call expect("contact_states", error, checked, failed)
        call load_field(contact_load, 1, x, y(:, 1), error)
        call expect("load_field", error, checked, failed)
        call interior(contact_load, .false., x, x, .false., 1.0_wp, x, table, error, 1)
        call expect("interior", error, checked, failed)
        call interior_error(contact_load, .false., values(1), error)
        call expect("interior_error", error, checked, failed)
        call layer_energy(contact_load, .false., found, error)
        call expect("layer_energy", error, checked, failed)
        call critical(contact_load, .false., 1.0_wp, any_maximum_list, error)
        call expect("critical", error, checked, failed)
        call first_failure(contact, .false., 1.0_wp, 1.0_wp, strength_list, any_failure_load_list, error)
        call expect("first_failure", error, checked, failed)
        call new_friction(made_friction, contact, 1.0_wp, error)
        call expect("new_friction", error, checked, failed)
        call new_friction_history(made_friction_history, friction, error)
        call expect("new_friction_history", error, checked, failed)
        call new_relaxing_contact(made_relaxing_contact, sphere, viscoelastic, error)
        call expect("new_relaxing_contact", error, checked, failed)
        call save_law(contact_law, "name", error)
        call expect("save_law", error, checked, failed)
        call new_layered_exact(made_layered_exact, stack, error)
        call expect("new_layered_exact", error, checked, failed)
        call new_layered_exact(made_layered_exact, material_list, x, material, error)
        call expect("new_layered_exact", error, checked, failed)
        call new_layered_exact(made_layered_exact, homogeneous, error)
        call expect("new_layered_exact", error, checked, failed)
        call new_loop(made_loop, contact, control, 1.0_wp, 1, error)
        call expect("new_loop", error, checked, failed)
        call new_medium(made_medium, stack, 1, error)
        call expect("new_medium", error, checked, failed)
        call new_pair(made_medium, medium, medium, error)
        call expect("new_pair", error, checked, failed)
        call modulus_values(layered_exact, x, y(:, 1), 1, error)
        call expect("modulus_values", error, checked, failed)
        call new_gao(made_gao, material, 1.0_wp, material, error)
        call expect("new_gao", error, checked, failed)
        call new_gao_layered(made_gao, material_list, x, material, error)
        call expect("new_gao_layered", error, checked, failed)
        call new_bec(made_bec, material, 1.0_wp, material, error)
        call expect("new_bec", error, checked, failed)
        call new_bottom_effect(made_bottom_effect, material, 1.0_wp, five, error)
        call expect("new_bottom_effect", error, checked, failed)
        call new_doerner_nix(made_doerner_nix, material, 1.0_wp, material, error)
        call expect("new_doerner_nix", error, checked, failed)
        call new_graded(made_graded, stack, error)
        call expect("new_graded", error, checked, failed)
        call new_hay_crawford(made_hay_crawford, material, 1.0_wp, material, error)
        call expect("new_hay_crawford", error, checked, failed)
        call new_mencik(made_mencik, material, 1.0_wp, material, error)
        call expect("new_mencik", error, checked, failed)
        call new_perriot_barthel(made_perriot_barthel, material, 1.0_wp, material, error)
        call expect("new_perriot_barthel", error, checked, failed)
        call new_viscoelastic_medium(made_viscoelastic, rheology_list, x, .false., 1, model_options, error)
        call expect("new_viscoelastic_medium", error, checked, failed)
        call new_wave(made_wave, material, 1.0_wp, material, error)
        call expect("new_wave", error, checked, failed)
        call new_solver(any_layered_exact, stack, 1, error)
        call expect("new_solver", error, checked, failed)
        call stack%with_parameters(x, any_stack, error)
        call expect("body_t%with_parameters", error, checked, failed)
        call graded_body%with_parameters(x, any_stack, error)
        call expect("graded_body_t%with_parameters", error, checked, failed)
        call stack%with_parameters(x, any_stack, error)
        call expect("stack_t%with_parameters", error, checked, failed)
        call contact%at_radius(1.0_wp, made_contact_state, error)
        call expect("contact_t%at_radius", error, checked, failed)
        call contact%at_depth(1.0_wp, made_contact_state, error)
        call expect("contact_t%at_depth", error, checked, failed)
        call contact%at_force(1.0_wp, made_contact_state, error)
        call expect("contact_t%at_force", error, checked, failed)
        call contact%at_control(control, "name", 1.0_wp, made_contact_state, error)
        call expect("contact_t%at_control", error, checked, failed)
        call contact%load(contact_state, made_contact_load, error)
        call expect("contact_t%load", error, checked, failed)
        call contact%slope(contact_state, values(1), error)
        call expect("contact_t%slope", error, checked, failed)
        call contact%pull_off(control, made_contact_state, error)
        call expect("contact_t%pull_off", error, checked, failed)
        call contact%radius_range(values(1), values(2), values(3), found, error)
        call expect("contact_t%radius_range", error, checked, failed)
        call contact%warnings(contact_state, any_contact_warning_list, error)
        call expect("contact_t%warnings", error, checked, failed)
        call contact_load%line_load(x, y(:, 1), error)
        call expect("contact_load_t%line_load", error, checked, failed)
        call contact_load%pressure(x, y(:, 1), error)
        call expect("contact_load_t%pressure", error, checked, failed)
        call contact_load%displacement(x, y(:, 1), error)
        call expect("contact_load_t%displacement", error, checked, failed)
        call contact_load%energy(y, error)
        call expect("contact_load_t%energy", error, checked, failed)
        call contact_load%lowest_pressure(values(1), values(2), error)
        call expect("contact_load_t%lowest_pressure", error, checked, failed)
        call first_shear%at_shift(1.0_wp, made_tangential_state, error)
        call expect("first_shear_t%at_shift", error, checked, failed)
        call first_shear%at_tangential_force(1.0_wp, made_tangential_state, error)
        call expect("first_shear_t%at_tangential_force", error, checked, failed)
        call first_shear%load_beyond(1.0_wp, values(1), error)
        call expect("first_shear_t%load_beyond", error, checked, failed)
        call first_shear%loop(tangential_state, y(:, 1), y(:, 2), error)
        call expect("first_shear_t%loop", error, checked, failed)
        call first_shear%line_load(tangential_state, x, y(:, 1), error)
        call expect("first_shear_t%line_load", error, checked, failed)
        call first_shear%traction(tangential_state, x, y(:, 1), error)
        call expect("first_shear_t%traction", error, checked, failed)
        call friction%first_shear(contact_load, made_first_shear, error)
        call expect("friction_t%first_shear", error, checked, failed)
        call friction%first_twist(contact_load, made_first_shear, error)
        call expect("friction_t%first_twist", error, checked, failed)
        call friction_history%advance(1, 1.0_wp, 1, 1.0_wp, error)
        call expect("friction_history_t%advance", error, checked, failed)
        call friction_history%copy(made_friction_history, error)
        call expect("friction_history_t%copy", error, checked, failed)
        call contact_law%at_depth(1.0_wp, made_law_point, error)
        call expect("contact_law_t%at_depth", error, checked, failed)
        call contact_law%at_force(1.0_wp, made_law_point, error)
        call expect("contact_law_t%at_force", error, checked, failed)
        call contact_law%follow(1.0_wp, number, made_law_point, error)
        call expect("contact_law_t%follow", error, checked, failed)
        call contact_law%from_depths(x, error)
        call expect("contact_law_t%from_depths", error, checked, failed)
        call contact_law%from_forces(x, error)
        call expect("contact_law_t%from_forces", error, checked, failed)
        call contact_law%with_radius(1.0_wp, made_contact_law, error)
        call expect("contact_law_t%with_radius", error, checked, failed)
        call friction_law%advance(1.0_wp, place, y(:, 1), traction, error)
        call expect("friction_law_t%advance", error, checked, failed)
        call friction_law%attempt(1.0_wp, place, x, traction, error)
        call expect("friction_law_t%attempt", error, checked, failed)
        call friction_law%energies(x, values(1), values(2), error)
        call expect("friction_law_t%energies", error, checked, failed)
        call friction_law%turn(place, 1.0_wp, y(:, 1), error)
        call expect("friction_law_t%turn", error, checked, failed)
        call layered_exact%modulus(x, y(:, 1), error)
        call expect("layered_exact_t%modulus", error, checked, failed)
        call material%with_parameters(x, made_material, error, "name")
        call expect("material_t%with_parameters", error, checked, failed)
        call material%stretch(1.0_wp, error, "name")
        call expect("material_t%stretch", error, checked, failed)
        call rheology%with_parameters(x, made_rheology, error)
        call expect("rheology_t%with_parameters", error, checked, failed)
        call rheology%glassy(made_material, error)
        call expect("rheology_t%glassy", error, checked, failed)
        call rheology%relaxed(made_material, error)
        call expect("rheology_t%relaxed", error, checked, failed)
        call rheology%of_shear(1.0_wp, made_material, error)
        call expect("rheology_t%of_shear", error, checked, failed)
        call medium%with_parameters(x, made_medium, error, kernel_cache)
        call expect("medium_t%with_parameters", error, checked, failed)
        call sphere%with_parameters(x, any_sphere, error)
        call expect("profile_t%with_parameters", error, checked, failed)
        call area_function%with_parameters(x, any_sphere, error)
        call expect("area_function_t%with_parameters", error, checked, failed)
    end subroutine of_core

    !> Extensions.
    subroutine of_extensions(checked, failed)
        integer, intent(inout) :: checked, failed
        type(material_t) :: material_list(2)
        type(material_t) :: material
        type(sphere_t) :: sphere
        type(medium_t) :: medium
        type(contact_t) :: contact
        type(fit_problem_t) :: fit_problem
        type(fit_data_t) :: fit_data
        type(fit_result_t) :: made_fit_result
        type(fit_body_t) :: made_fit_body
        type(fit_result_t) :: fit_result
        type(rate_contact_t) :: made_rate_contact
        type(rate_law_t) :: rate_law
        type(relaxing_contact_t) :: relaxing_contact
        type(control_t) :: control
        type(rate_state_t) :: made_rate_state
        type(rate_contact_t) :: rate_contact
        type(rate_state_t) :: rate_state
        type(rate_law_t) :: made_rate_law
        type(rheology_t) :: rheology
        type(tabulated_medium_t) :: made_tabulated_medium
        type(shapes_t) :: shapes
        type(shape_t) :: made_shape
        type(shapes_t) :: made_shapes
        type(shape_t) :: shape_list(2)
        type(voxels_t) :: made_voxels
        type(conduction_t) :: conduction
        type(contact_state_t) :: contact_state
        type(conduction_t) :: made_conduction
        type(conductors_t) :: conductors_list(2)
        type(heat_t) :: made_heat
        type(poroelastic_t) :: poroelastic
        type(wear_t) :: made_wear
        type(wear_history_t) :: made_wear_history
        type(wear_t) :: wear
        type(friction_law_t) :: friction_law
        type(contact_steps_t) :: contact_steps
        type(wear_limit_t) :: made_wear_limit
        type(wear_history_t) :: wear_history
        type(worn_profile_t), allocatable :: any_worn_profile
        real(wp) :: x(2)
        real(wp) :: y(2, 3)
        real(wp) :: values(3)
        real(wp) :: place(3)
        real(wp) :: seven(7)
        real(wp) :: table(8, 2)
        complex(wp) :: z(2)
        integer :: labels(1, 1, 1)
        type(error_t), allocatable :: error

        x = 1.0_wp
        y = 1.0_wp
        place = 1.0_wp
        seven = 1.0_wp
        labels = 1
        call solve_fit(fit_problem, fit_data, made_fit_result, error)
        call expect("solve_fit", error, checked, failed)
        call new_fit_body(made_fit_body, sphere, medium, error)
        call expect("new_fit_body", error, checked, failed)
        call profile_interval(fit_problem, fit_data, fit_result, 1, 1.0_wp, values(1), values(2), error)
        call expect("profile_interval", error, checked, failed)
        call predict(fit_problem, x, fit_data, y(:, 1), error)
        call expect("predict", error, checked, failed)
        call new_rate_contact(made_rate_contact, contact, rate_law, 1.0_wp, error)
        call expect("new_rate_contact", error, checked, failed)
        call cohesive_history(relaxing_contact, control, .false., x, x, table, made_rate_state, error)
        call expect("cohesive_history", error, checked, failed)
        call rate_history(rate_contact, control, x, x, rate_state, table, error)
        call expect("rate_history", error, checked, failed)
        call new_surface_law(made_rate_law, rheology, 1.0_wp, 1.0_wp, error)
        call expect("new_surface_law", error, checked, failed)
        call contact_history(relaxing_contact, 1, x, x, y(:, 1), y(:, 2), y(:, 3), error)
        call expect("contact_history", error, checked, failed)
        call dynamic_stiffness(relaxing_contact, x, x, z, error)
        call expect("dynamic_stiffness", error, checked, failed)
        call step_response(relaxing_contact, 1, x, 1.0_wp, y(:, 1), error)
        call expect("step_response", error, checked, failed)
        call new_lateral_medium(made_tabulated_medium, shapes, 1.0_wp, 1.0_wp, 1.0_wp, 1.0_wp, error)
        call expect("new_lateral_medium", error, checked, failed)
        call new_shape(made_shape, 1, seven, material, error)
        call expect("new_shape", error, checked, failed)
        call new_shapes(made_shapes, material, shape_list, error)
        call expect("new_shapes", error, checked, failed)
        call new_voxels(made_voxels, labels, material_list, place, material, error)
        call expect("new_voxels", error, checked, failed)
        call structure_values(shapes, x, x, x, y(:, 1), 1, error)
        call expect("structure_values", error, checked, failed)
        call conductance_along(conduction, contact, contact_state, values(1), values(2), values(3), error)
        call expect("conductance_along", error, checked, failed)
        call admittance_of(conduction, 1, 1.0_wp, x, z, error)
        call expect("admittance_of", error, checked, failed)
        call flux_after_step(conduction, 1.0_wp, 1.0_wp, x, y(:, 1), error)
        call expect("flux_after_step", error, checked, failed)
        call follow_history(conduction, 1, 1.0_wp, x, x, y(:, 1), error)
        call expect("follow_history", error, checked, failed)
        call step_of(conduction, 1, 1.0_wp, x, y(:, 1), error)
        call expect("step_of", error, checked, failed)
        call new_conduction(made_conduction, conductors_list, 1.0_wp, 1.0_wp, error)
        call expect("new_conduction", error, checked, failed)
        call conductance_at(conduction, 1.0_wp, values(1), values(2), error)
        call expect("conductance_at", error, checked, failed)
        call flux_at(conduction, 1.0_wp, x, y(:, 1), error)
        call expect("flux_at", error, checked, failed)
        call inside_at(conduction, 1, 1.0_wp, x, x, .false., y(:, 1), y(:, 2), y(:, 3), error)
        call expect("inside_at", error, checked, failed)
        call friction_heat(conduction, contact, contact_state, 1, 1.0_wp, made_heat, error)
        call expect("friction_heat", error, checked, failed)
        call heat_field(conduction, contact, contact_state, 1, 1.0_wp, 1, x, x, .false., y(:, 1), error)
        call expect("heat_field", error, checked, failed)
        call moving_heat(conduction, contact, contact_state, 1.0_wp, 1.0_wp, made_heat, error)
        call expect("moving_heat", error, checked, failed)
        call rough_conductance(conduction, contact, contact_state, 1.0_wp, values(1), error)
        call expect("rough_conductance", error, checked, failed)
        call tabulate_conductance(conduction, 1.0_wp, 1.0_wp, 1.0_wp, made_conduction, error)
        call expect("tabulate_conductance", error, checked, failed)
        call poroelastic_history(poroelastic, 1, 1.0_wp, 1.0_wp, 1.0_wp, x, x, y(:, 1), error)
        call expect("poroelastic_history", error, checked, failed)
        call poroelastic_dynamic_stiffness(poroelastic, 1.0_wp, 1.0_wp, 1.0_wp, x, z, error)
        call expect("poroelastic_dynamic_stiffness", error, checked, failed)
        call poroelastic_pressure(poroelastic, 1, .false., 1.0_wp, 1.0_wp, 1.0_wp, 1.0_wp, x, y(:, 1), error)
        call expect("poroelastic_pressure", error, checked, failed)
        call poroelastic_response(poroelastic, 1, 1.0_wp, 1.0_wp, 1.0_wp, x, y(:, 1), error)
        call expect("poroelastic_response", error, checked, failed)
        call new_wear(made_wear, contact, x, error)
        call expect("new_wear", error, checked, failed)
        call new_wear_history(made_wear_history, wear, 1, 1.0_wp, error)
        call expect("new_wear_history", error, checked, failed)
        call shapes%modulus(x, x, x, y(:, 1), error)
        call expect("structure_t%modulus", error, checked, failed)
        call shapes%modulus_at(1.0_wp, 1.0_wp, 1.0_wp, values(1), error)
        call expect("structure_t%modulus_at", error, checked, failed)
        call shapes%bounds(x, x, x, y(:, 1), y(:, 2), error)
        call expect("structure_t%bounds", error, checked, failed)
        call friction_law%steps(contact_steps, 1, error)
        call expect("friction_law_t%steps", error, checked, failed)
        call poroelastic%value(1, 1.0_wp, values(1), error)
        call expect("poroelastic_t%value", error, checked, failed)
        call wear%limit(contact_state, 1.0_wp, 1, made_wear_limit, error)
        call expect("wear_t%limit", error, checked, failed)
        call wear%track(contact_state, x, 1.0_wp, y(:, 1), error)
        call expect("wear_t%track", error, checked, failed)
        call wear%passes_through(contact_state, 1.0_wp, values(1), error)
        call expect("wear_t%passes_through", error, checked, failed)
        call wear%running_in_length(1, values(1), error)
        call expect("wear_t%running_in_length", error, checked, failed)
        call wear_history%advance(1.0_wp, 1, 1.0_wp, error)
        call expect("wear_history_t%advance", error, checked, failed)
        call wear_history%worn_profile(any_worn_profile, error)
        call expect("wear_history_t%worn_profile", error, checked, failed)
        call wear_history%pressure(x, y(:, 1), error)
        call expect("wear_history_t%pressure", error, checked, failed)
        call wear_history%restore(x, error)
        call expect("wear_history_t%restore", error, checked, failed)
    end subroutine of_extensions

    !> What a maker refuses stays unmade.
    subroutine of_failed_makers(checked, failed)
        integer, intent(inout) :: checked, failed
        type(sphere_t) :: sphere
        type(material_t) :: steel
        type(homogeneous_t) :: medium
        type(contact_options_t) :: options
        type(contact_t) :: contact
        type(contact_state_t) :: state
        type(error_t), allocatable :: error

        call new_sphere(sphere, -1.0_wp, error)
        call new_material(steel, 2.0e11_wp, 0.3_wp, error)
        call new_homogeneous(medium, steel)
        call new_contact(contact, sphere, medium, error)
        call expect("a sphere of negative radius", error, checked, failed)
        call new_sphere(sphere, 1.0_wp, error)
        options%work_of_adhesion = -1.0_wp
        call new_contact(contact, sphere, medium, error, options)
        call contact%at_depth(0.01_wp, state, error)
        call expect("a contact of negative work of adhesion", error, checked, failed)
        call new_material(steel, -1.0_wp, 0.3_wp, error)
        call new_homogeneous(medium, steel)
        call new_contact(contact, sphere, medium, error)
        call expect("a medium of a material that was not made", error, checked, failed)
    end subroutine of_failed_makers

    !> An error of another call neither stops the next one nor becomes its own.
    subroutine of_stale_errors(checked, failed)
        integer, intent(inout) :: checked, failed
        type(sphere_t) :: sphere
        type(material_t) :: steel
        type(homogeneous_t) :: medium
        type(error_t), allocatable :: error
        real(wp) :: moduli(2)

        call new_material(steel, 2.0e11_wp, 0.0_wp, error)
        call new_homogeneous(medium, steel)
        call new_sphere(sphere, -1.0_wp, error)
        moduli = 0.0_wp
        call modulus_values(medium, [1.0_wp, 2.0_wp], moduli, 1, error)
        checked = checked + 1
        if (allocated(error) .or. any(abs(moduli - 2.0e11_wp) > 1.0_wp)) then
            failed = failed + 1
            print "(a)", "modulus_values after a failure of another call"
        end if
    end subroutine of_stale_errors

end program unmade
