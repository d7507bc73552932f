! SPDX-License-Identifier: GPL-3.0-or-later
!> Functions of the core that convert, call and deliver, for C. Written by tools/generate.py.
module mdrcontact_api_entries
    use, intrinsic :: iso_c_binding, only: c_double, c_funptr, c_int, c_ptr
    use mdrcontact_api_any_body, only: any_body_t, return_elastic, return_solved
    use mdrcontact_api_arrays, only: check_array, check_each_finite, check_each_not_negative, check_each_positive, &
        check_each_within, check_not_empty, check_results, check_results_or_infinity, make_room, return_parts
    use mdrcontact_api_callback, only: c_function_t, new_c_function
    use mdrcontact_api_closed_forms, only: check_constants, constant_count, formulas, variable_name
    use mdrcontact_api_handles, only: return_object, return_solver
    use mdrcontact_api_law_file, only: read_content, read_name
    use mdrcontact_api_loop, only: choose_control
    use mdrcontact_api_medium, only: new_medium_of
    use mdrcontact_api_medium_options, only: read_medium_options
    use mdrcontact_api_open_handle, only: open_handle
    use mdrcontact_api_profile_terms, only: copy_terms
    use mdrcontact_api_status, only: status_of, wanted_threads
    use mdrcontact_batch, only: run_map
    use mdrcontact_body, only: body_t
    use mdrcontact_body_compliance, only: coupling_load, normal_load, shear_load, twist_load
    use mdrcontact_body_graded, only: graded_body_t, new_graded_body, new_graded_body_from_functions
    use mdrcontact_codes, only: limit_glassy, limit_relaxed
    use mdrcontact_contact, only: contact_t
    use mdrcontact_contact_closed_form_values, only: closed_form_values
    use mdrcontact_contact_control, only: control_t
    use mdrcontact_contact_load, only: contact_load_t
    use mdrcontact_contact_loop, only: loop_t, new_loop
    use mdrcontact_contact_state, only: contact_state_t
    use mdrcontact_contact_values, only: contact_states, load_field
    use mdrcontact_error, only: check_code, check_memory, check_poisson, check_table, error_invalid, error_t, raise, raise_at
    use mdrcontact_friction_history, only: friction_history_t, new_friction_history
    use mdrcontact_friction_partial_slip, only: friction_t, new_friction
    use mdrcontact_law, only: contact_law_t
    use mdrcontact_law_file, only: law_from_text, load_law, save_law
    use mdrcontact_material, only: material_t
    use mdrcontact_material_rheology, only: new_power_law_rheology, new_viscoelastic, rheology_t
    use mdrcontact_medium, only: medium_t, new_pair
    use mdrcontact_medium_compliance, only: surface_compliance
    use mdrcontact_medium_homogeneous, only: homogeneous_t, new_homogeneous_from_modulus, new_rigid
    use mdrcontact_medium_power_graded, only: new_power_graded, power_graded_t
    use mdrcontact_medium_response, only: new_response, point_response, rectangle_response, response_t
    use mdrcontact_medium_solver, only: solver_t
    use mdrcontact_medium_tabulated, only: new_medium_from_function, new_tabulated_medium, tabulated_medium_t
    use mdrcontact_model, only: model_options_t
    use mdrcontact_profile, only: profile_t
    use mdrcontact_profile_area_function, only: area_function_t, new_area_function_profile
    use mdrcontact_profile_flat_ended, only: flat_ended_t, new_flat_cone, new_flat_paraboloid
    use mdrcontact_profile_flat_punch, only: flat_punch_t, new_flat_punch
    use mdrcontact_profile_power_law, only: new_cone, new_paraboloid, new_power_law, power_law_t
    use mdrcontact_profile_rounded_cone, only: new_rounded_cone, rounded_cone_t
    use mdrcontact_profile_sampled, only: sampled_profile_t
    use mdrcontact_profile_sphere, only: new_sphere, sphere_t
    use mdrcontact_profile_sum, only: new_profile_sum, profile_sum_t, profile_term_t
    use mdrcontact_profile_tabulated, only: new_profile_from_function, new_profile_from_mdr, new_tabulated_profile
    use mdrcontact_profile_values, only: of_height, of_mdr, of_mdr_slope, of_slope, profile_values
    use mdrcontact_weights, only: of_i0, of_i0_slope, of_i0_tangential, of_i1, of_j0, of_j0_tangential, of_j1, weight_map_t
    implicit none (type, external)
    private
    public :: mdr_profile_paraboloid
    public :: mdr_profile_sphere
    public :: mdr_profile_cone
    public :: mdr_profile_power
    public :: mdr_profile_flat_punch
    public :: mdr_profile_flat_cone
    public :: mdr_profile_flat_paraboloid
    public :: mdr_profile_rounded_cone
    public :: mdr_profile_area_function
    public :: mdr_profile_table
    public :: mdr_profile_function
    public :: mdr_profile_sum
    public :: mdr_profile_values
    public :: mdr_material_viscoelastic
    public :: mdr_material_power_law
    public :: mdr_material_limit
    public :: mdr_body_graded
    public :: mdr_body_graded_function
    public :: mdr_body_power_graded
    public :: mdr_body_rigid
    public :: mdr_body_compliance
    public :: mdr_response_new
    public :: mdr_response_about
    public :: mdr_response_point
    public :: mdr_response_rectangle
    public :: mdr_medium_contact_modulus
    public :: mdr_medium_new
    public :: mdr_medium_pair
    public :: mdr_medium_table
    public :: mdr_medium_function
    public :: mdr_weight
    public :: mdr_contact_states
    public :: mdr_contact_slope
    public :: mdr_loop_new
    public :: mdr_load_energy
    public :: mdr_load_field
    public :: mdr_load_lowest_pressure
    public :: mdr_friction_new
    public :: mdr_friction_history_new
    public :: mdr_friction_history_copy
    public :: mdr_law_with_radius
    public :: mdr_law_save
    public :: mdr_law_load
    public :: mdr_law_read
    public :: mdr_closed_form

contains

    function mdr_profile_paraboloid(radius, out) result(status) &
        bind(C, name="mdrcontact_entry_profile_paraboloid")
        real(c_double), value :: radius
        type(c_ptr), intent(inout), optional :: out
        integer(c_int) :: status
        type(power_law_t), allocatable :: made
        class(*), allocatable :: object
        type(error_t), allocatable :: error

        allocate (made)
        call new_paraboloid(made, radius, error)
        call move_alloc(made, object)
        status = return_object(object, out, error)
    end function mdr_profile_paraboloid

    function mdr_profile_sphere(radius, out) result(status) &
        bind(C, name="mdrcontact_entry_profile_sphere")
        real(c_double), value :: radius
        type(c_ptr), intent(inout), optional :: out
        integer(c_int) :: status
        type(sphere_t), allocatable :: made
        class(*), allocatable :: object
        type(error_t), allocatable :: error

        allocate (made)
        call new_sphere(made, radius, error)
        call move_alloc(made, object)
        status = return_object(object, out, error)
    end function mdr_profile_sphere

    function mdr_profile_cone(inclination, out) result(status) &
        bind(C, name="mdrcontact_entry_profile_cone")
        real(c_double), value :: inclination
        type(c_ptr), intent(inout), optional :: out
        integer(c_int) :: status
        type(power_law_t), allocatable :: made
        class(*), allocatable :: object
        type(error_t), allocatable :: error

        allocate (made)
        call new_cone(made, inclination, error)
        call move_alloc(made, object)
        status = return_object(object, out, error)
    end function mdr_profile_cone

    function mdr_profile_power(exponent, coefficient, out) result(status) &
        bind(C, name="mdrcontact_entry_profile_power")
        real(c_double), value :: exponent, coefficient
        type(c_ptr), intent(inout), optional :: out
        integer(c_int) :: status
        type(power_law_t), allocatable :: made
        class(*), allocatable :: object
        type(error_t), allocatable :: error

        allocate (made)
        call new_power_law(made, exponent, coefficient, error)
        call move_alloc(made, object)
        status = return_object(object, out, error)
    end function mdr_profile_power

    function mdr_profile_flat_punch(radius, out) result(status) &
        bind(C, name="mdrcontact_entry_profile_flat_punch")
        real(c_double), value :: radius
        type(c_ptr), intent(inout), optional :: out
        integer(c_int) :: status
        type(flat_punch_t), allocatable :: made
        class(*), allocatable :: object
        type(error_t), allocatable :: error

        allocate (made)
        call new_flat_punch(made, radius, error)
        call move_alloc(made, object)
        status = return_object(object, out, error)
    end function mdr_profile_flat_punch

    function mdr_profile_flat_cone(end_radius, inclination, out) result(status) &
        bind(C, name="mdrcontact_entry_profile_flat_cone")
        real(c_double), value :: end_radius, inclination
        type(c_ptr), intent(inout), optional :: out
        integer(c_int) :: status
        type(flat_ended_t), allocatable :: made
        class(*), allocatable :: object
        type(error_t), allocatable :: error

        allocate (made)
        call new_flat_cone(made, end_radius, inclination, error)
        call move_alloc(made, object)
        status = return_object(object, out, error)
    end function mdr_profile_flat_cone

    function mdr_profile_flat_paraboloid(end_radius, radius, out) result(status) &
        bind(C, name="mdrcontact_entry_profile_flat_paraboloid")
        real(c_double), value :: end_radius, radius
        type(c_ptr), intent(inout), optional :: out
        integer(c_int) :: status
        type(flat_ended_t), allocatable :: made
        class(*), allocatable :: object
        type(error_t), allocatable :: error

        allocate (made)
        call new_flat_paraboloid(made, end_radius, radius, error)
        call move_alloc(made, object)
        status = return_object(object, out, error)
    end function mdr_profile_flat_paraboloid

    function mdr_profile_rounded_cone(blend_radius, inclination, out) result(status) &
        bind(C, name="mdrcontact_entry_profile_rounded_cone")
        real(c_double), value :: blend_radius, inclination
        type(c_ptr), intent(inout), optional :: out
        integer(c_int) :: status
        type(rounded_cone_t), allocatable :: made
        class(*), allocatable :: object
        type(error_t), allocatable :: error

        allocate (made)
        call new_rounded_cone(made, blend_radius, inclination, error)
        call move_alloc(made, object)
        status = return_object(object, out, error)
    end function mdr_profile_rounded_cone

    function mdr_profile_area_function(n, coefficients, min_height, max_height, out) result(status) &
        bind(C, name="mdrcontact_entry_profile_area_function")
        integer(c_int), value :: n
        real(c_double), intent(in), optional :: coefficients(*)
        real(c_double), value :: min_height, max_height
        type(c_ptr), intent(inout), optional :: out
        integer(c_int) :: status
        type(area_function_t), allocatable :: made
        class(*), allocatable :: object
        type(error_t), allocatable :: error

        allocate (made)
        if (n == 0) call raise(error, error_invalid, "coefficients: the array is empty. Give at least C0")
        if (.not. allocated(error) .and. n > 0) then
            call new_area_function_profile(made, coefficients(:n), min_height, max_height, error)
        end if
        call move_alloc(made, object)
        status = return_object(object, out, error)
    end function mdr_profile_area_function

    function mdr_profile_table(quantity, n, x, y, out) result(status) &
        bind(C, name="mdrcontact_entry_profile_table")
        integer(c_int), value :: quantity, n
        real(c_double), intent(in), optional :: x(*), y(*)
        type(c_ptr), intent(inout), optional :: out
        integer(c_int) :: status
        type(sampled_profile_t), allocatable :: made
        class(*), allocatable :: object
        type(error_t), allocatable :: error

        allocate (made)
        call check_code(error, "quantity", quantity, [of_height, of_mdr])
        if (.not. allocated(error)) call check_not_empty(error, merge("r", "x", quantity == of_height), n, 3)
        if (.not. allocated(error) .and. n > 0) then
            if (quantity == of_height) call new_tabulated_profile(made, x(:n), y(:n), error)
        end if
        if (.not. allocated(error) .and. n > 0) then
            if (quantity == of_mdr) call new_profile_from_mdr(made, x(:n), y(:n), error)
        end if
        call move_alloc(made, object)
        status = return_object(object, out, error)
    end function mdr_profile_table

    function mdr_profile_function(height, context, largest_radius, out) result(status) &
        bind(C, name="mdrcontact_entry_profile_function")
        type(c_funptr), value :: height
        type(c_ptr), value :: context
        real(c_double), value :: largest_radius
        type(c_ptr), intent(inout), optional :: out
        integer(c_int) :: status
        type(sampled_profile_t), allocatable :: made
        class(*), allocatable :: object
        type(c_function_t) :: height_function
        type(error_t), allocatable :: error

        allocate (made)
        call new_c_function(height_function, "height", height, context, error)
        if (.not. allocated(error)) call new_profile_from_function(made, height_function, largest_radius, error)
        call move_alloc(made, object)
        status = return_object(object, out, error)
    end function mdr_profile_function

    function mdr_profile_sum(n, terms, out) result(status) &
        bind(C, name="mdrcontact_entry_profile_sum")
        integer(c_int), value :: n
        type(c_ptr), intent(in), optional :: terms(*)
        type(c_ptr), intent(inout), optional :: out
        integer(c_int) :: status
        type(profile_sum_t), allocatable :: made
        class(*), allocatable :: object
        type(profile_term_t), allocatable :: copies(:)
        type(error_t), allocatable :: error

        allocate (made)
        if (n == 0) call raise(error, error_invalid, "terms: the array is empty. Give at least one term")
        if (.not. allocated(error)) call check_array(error, "terms", n, present(terms))
        if (.not. allocated(error) .and. n > 0) call copy_terms(terms(:n), copies, error)
        if (.not. allocated(error)) call new_profile_sum(made, copies, error)
        call move_alloc(made, object)
        status = return_object(object, out, error)
    end function mdr_profile_sum

    function mdr_profile_values(p, quantity, n, x, out) result(status) &
        bind(C, name="mdrcontact_entry_profile_values")
        type(c_ptr), value :: p
        integer(c_int), value :: quantity, n
        real(c_double), intent(in), optional :: x(*)
        real(c_double), intent(inout), optional :: out(*)
        integer(c_int) :: status
        class(profile_t), pointer :: p_inside
        real(c_double), allocatable :: out_values(:)
        type(error_t), allocatable :: error

        call open_handle(p, "p", p_inside, error)
        if (.not. allocated(error)) call check_code(error, "quantity", quantity, [of_height, of_slope, of_mdr, of_mdr_slope])
        if (.not. allocated(error) .and. n > 0) call check_each_not_negative(error, merge("r", "x", quantity < of_mdr), x(:n))
        if (.not. allocated(error) .and. n > 0) then
            call check_each_within(error, merge("r", "x", quantity < of_mdr), x(:n), 0.0_c_double, p_inside%largest_radius, &
                "the profile")
        end if
        call make_room(error, n, out_values)
        if (.not. allocated(error) .and. n > 0) call profile_values(p_inside, quantity, x(:n), out_values, wanted_threads())
        if (.not. allocated(error)) call check_results_or_infinity(error, out_values)
        status = status_of(error)
        if (allocated(error)) return
        if (present(out)) out(:n) = out_values
    end function mdr_profile_values

    function mdr_material_viscoelastic(relaxed_shear_modulus, n, moduli, times, viscosity, nu, bulk_modulus, out) result(status) &
        bind(C, name="mdrcontact_entry_material_viscoelastic")
        real(c_double), value :: relaxed_shear_modulus, viscosity, nu, bulk_modulus
        integer(c_int), value :: n
        real(c_double), intent(in), optional :: moduli(*), times(*)
        type(c_ptr), intent(inout), optional :: out
        integer(c_int) :: status
        type(rheology_t), allocatable :: made
        class(*), allocatable :: object
        real(c_double) :: none(0)
        type(error_t), allocatable :: error

        allocate (made)
        if (n == 0) call new_viscoelastic(made, relaxed_shear_modulus, none, none, viscosity, nu, bulk_modulus, error)
        if (.not. allocated(error) .and. n > 0) then
            call new_viscoelastic(made, relaxed_shear_modulus, moduli(:n), times(:n), viscosity, nu, bulk_modulus, error)
        end if
        call move_alloc(made, object)
        status = return_object(object, out, error)
    end function mdr_material_viscoelastic

    function mdr_material_power_law(modulus, time, exponent, nu, out) result(status) &
        bind(C, name="mdrcontact_entry_material_power_law")
        real(c_double), value :: modulus, time, exponent, nu
        type(c_ptr), intent(inout), optional :: out
        integer(c_int) :: status
        type(rheology_t), allocatable :: made
        class(*), allocatable :: object
        type(error_t), allocatable :: error

        allocate (made)
        call new_power_law_rheology(made, modulus, time, exponent, nu, error)
        call move_alloc(made, object)
        status = return_object(object, out, error)
    end function mdr_material_power_law

    function mdr_material_limit(m, limit, e, nu) result(status) &
        bind(C, name="mdrcontact_entry_material_limit")
        type(c_ptr), value :: m
        integer(c_int), value :: limit
        real(c_double), intent(inout), optional :: e, nu
        integer(c_int) :: status
        type(rheology_t), pointer :: m_inside
        type(material_t) :: found
        real(c_double) :: e_value, nu_value
        type(error_t), allocatable :: error

        call open_handle(m, "m", m_inside, error)
        if (.not. allocated(error)) call check_code(error, "limit", limit, [limit_glassy, limit_relaxed])
        if (.not. allocated(error)) then
            if (limit == limit_glassy) call m_inside%glassy(found, error)
        end if
        if (.not. allocated(error)) then
            if (limit == limit_relaxed) call m_inside%relaxed(found, error)
        end if
        e_value = 0.0_c_double
        if (.not. allocated(error)) e_value = found%young
        nu_value = 0.0_c_double
        if (.not. allocated(error)) nu_value = found%poisson
        status = status_of(error)
        if (allocated(error)) return
        if (present(e)) e = e_value
        if (present(nu)) nu = nu_value
    end function mdr_material_limit

    function mdr_body_graded(n, z, e, nu, out) result(status) &
        bind(C, name="mdrcontact_entry_body_graded")
        integer(c_int), value :: n
        real(c_double), intent(in), optional :: z(*), e(*), nu(*)
        type(c_ptr), intent(inout), optional :: out
        integer(c_int) :: status
        type(graded_body_t), allocatable :: made
        class(body_t), allocatable :: object
        type(error_t), allocatable :: error

        allocate (made)
        call check_not_empty(error, "z", n, 2)
        if (.not. allocated(error) .and. n > 0) call new_graded_body(made, z(:n), e(:n), nu(:n), error)
        call move_alloc(made, object)
        status = return_elastic(object, out, error)
    end function mdr_body_graded

    function mdr_body_graded_function(e, nu, context, depth, out) result(status) &
        bind(C, name="mdrcontact_entry_body_graded_function")
        type(c_funptr), value :: e, nu
        type(c_ptr), value :: context
        real(c_double), value :: depth
        type(c_ptr), intent(inout), optional :: out
        integer(c_int) :: status
        type(graded_body_t), allocatable :: made
        class(body_t), allocatable :: object
        type(c_function_t) :: e_function, nu_function
        type(error_t), allocatable :: error

        allocate (made)
        call new_c_function(e_function, "E", e, context, error)
        call new_c_function(nu_function, "nu", nu, context, error)
        if (.not. allocated(error)) call new_graded_body_from_functions(made, e_function, nu_function, depth, error)
        call move_alloc(made, object)
        status = return_elastic(object, out, error)
    end function mdr_body_graded_function

    function mdr_body_power_graded(e0, z0, exponent, nu, out) result(status) &
        bind(C, name="mdrcontact_entry_body_power_graded")
        real(c_double), value :: e0, z0, exponent, nu
        type(c_ptr), intent(inout), optional :: out
        integer(c_int) :: status
        type(power_graded_t), allocatable :: made
        class(solver_t), allocatable :: object
        type(error_t), allocatable :: error

        allocate (made)
        call new_power_graded(made, e0, z0, exponent, nu, error)
        call move_alloc(made, object)
        status = return_solved(object, out, error)
    end function mdr_body_power_graded

    function mdr_body_rigid(out) result(status) &
        bind(C, name="mdrcontact_entry_body_rigid")
        type(c_ptr), intent(inout), optional :: out
        integer(c_int) :: status
        type(homogeneous_t), allocatable :: made
        class(solver_t), allocatable :: object
        type(error_t), allocatable :: error

        allocate (made)
        call new_rigid(made)
        call move_alloc(made, object)
        status = return_solved(object, out, error)
    end function mdr_body_rigid

    function mdr_body_compliance(body, load, n, k, omega, out, imaginary) result(status) &
        bind(C, name="mdrcontact_entry_body_compliance")
        type(c_ptr), value :: body
        integer(c_int), value :: load, n
        real(c_double), intent(in), optional :: k(*), omega(*)
        real(c_double), intent(inout), optional :: out(*), imaginary(*)
        integer(c_int) :: status
        type(any_body_t), pointer :: body_inside
        real(c_double), allocatable :: wavenumbers(:), frequencies(:)
        complex(c_double), allocatable :: out_values(:)
        type(error_t), allocatable :: error

        call open_handle(body, "body", body_inside, error)
        if (.not. allocated(error)) call check_code(error, "load", load, [normal_load, shear_load, twist_load, coupling_load])
        if (.not. allocated(error)) call make_room(error, n, wavenumbers)
        if (.not. allocated(error) .and. n > 0) wavenumbers(:) = k(:n)
        if (.not. allocated(error)) call check_each_not_negative(error, "k", wavenumbers)
        if (.not. allocated(error) .and. n > 0) then
            if (present(omega)) call check_each_finite(error, "omega", omega(:n))
        end if
        if (.not. allocated(error)) then
            if (allocated(body_inside%relaxing)) call make_room(error, n, frequencies)
        end if
        if (.not. allocated(error)) then
            if (allocated(frequencies)) frequencies(:) = 0.0_c_double
        end if
        if (.not. allocated(error) .and. n > 0) then
            if (allocated(frequencies) .and. present(omega)) frequencies(:) = omega(:n)
        end if
        call make_room(error, n, out_values)
        if (.not. allocated(error)) then
            if (allocated(body_inside%relaxing)) call surface_compliance(body_inside%relaxing, load, frequencies, wavenumbers, &
                out_values, error)
        end if
        if (.not. allocated(error)) then
            if (allocated(body_inside%elastic)) call surface_compliance(body_inside%elastic, body_inside%surface, load, &
                wavenumbers, out_values, error)
        end if
        if (.not. allocated(error)) then
            if (allocated(body_inside%solved)) call surface_compliance(body_inside%solved, load, wavenumbers, out_values, error)
        end if
        call return_parts(error, out_values, out, imaginary)
        status = status_of(error)
    end function mdr_body_compliance

    function mdr_response_new(body, tolerance, out) result(status) &
        bind(C, name="mdrcontact_entry_response_new")
        type(c_ptr), value :: body
        real(c_double), value :: tolerance
        type(c_ptr), intent(inout), optional :: out
        integer(c_int) :: status
        type(response_t), allocatable :: made
        class(*), allocatable :: object
        type(any_body_t), pointer :: body_inside
        type(error_t), allocatable :: error

        allocate (made)
        call open_handle(body, "body", body_inside, error)
        if (.not. allocated(error)) then
            if (allocated(body_inside%relaxing)) call new_response(made, body_inside%relaxing, tolerance, error)
        end if
        if (.not. allocated(error)) then
            if (allocated(body_inside%elastic)) call new_response(made, body_inside%elastic, body_inside%surface, tolerance, &
                error)
        end if
        if (.not. allocated(error)) then
            if (allocated(body_inside%solved)) call raise(error, error_invalid, &
                ": the response of rigid and of power-law graded bodies "// "is not available. Use another body", "body")
        end if
        call move_alloc(made, object)
        status = return_object(object, out, error)
    end function mdr_response_new

    function mdr_response_about(response, tolerance, images) result(status) &
        bind(C, name="mdrcontact_entry_response_about")
        type(c_ptr), value :: response
        real(c_double), intent(inout), optional :: tolerance
        integer(c_int), intent(inout), optional :: images
        integer(c_int) :: status, images_value
        type(response_t), pointer :: response_inside
        real(c_double) :: tolerance_value
        type(error_t), allocatable :: error

        call open_handle(response, "response", response_inside, error)
        tolerance_value = 0.0_c_double
        if (.not. allocated(error)) tolerance_value = response_inside%error
        if (.not. allocated(error)) images_value = size(response_inside%depth)
        status = status_of(error)
        if (allocated(error)) return
        if (present(tolerance)) tolerance = tolerance_value
        if (present(images)) images = images_value
    end function mdr_response_about

    function mdr_response_point(response, n, r, out) result(status) &
        bind(C, name="mdrcontact_entry_response_point")
        type(c_ptr), value :: response
        integer(c_int), value :: n
        real(c_double), intent(in), optional :: r(*)
        real(c_double), intent(inout), optional :: out(*)
        integer(c_int) :: status
        type(response_t), pointer :: response_inside
        real(c_double), allocatable :: out_values(:)
        type(error_t), allocatable :: error

        call open_handle(response, "response", response_inside, error)
        if (.not. allocated(error) .and. n > 0) call check_each_positive(error, "r", r(:n))
        call make_room(error, n, out_values)
        if (.not. allocated(error) .and. n > 0) call point_response(response_inside, r(:n), out_values)
        if (.not. allocated(error)) call check_results(error, out_values)
        status = status_of(error)
        if (allocated(error)) return
        if (present(out)) out(:n) = out_values
    end function mdr_response_point

    function mdr_response_rectangle(response, width, height, n, x, y, out) result(status) &
        bind(C, name="mdrcontact_entry_response_rectangle")
        type(c_ptr), value :: response
        real(c_double), value :: width, height
        integer(c_int), value :: n
        real(c_double), intent(in), optional :: x(*), y(*)
        real(c_double), intent(inout), optional :: out(*)
        integer(c_int) :: status
        type(response_t), pointer :: response_inside
        real(c_double), allocatable :: out_values(:)
        type(error_t), allocatable :: error

        call open_handle(response, "response", response_inside, error)
        if (.not. allocated(error) .and. n > 0) call check_each_finite(error, "x", x(:n))
        if (.not. allocated(error) .and. n > 0) call check_each_finite(error, "y", y(:n))
        call make_room(error, n, out_values)
        if (.not. allocated(error) .and. n > 0) then
            call rectangle_response(response_inside, width, height, x(:n), y(:n), out_values, wanted_threads(), error)
        end if
        if (.not. allocated(error)) call check_results(error, out_values)
        status = status_of(error)
        if (allocated(error)) return
        if (present(out)) out(:n) = out_values
    end function mdr_response_rectangle

    function mdr_medium_contact_modulus(contact_modulus, out) result(status) &
        bind(C, name="mdrcontact_entry_medium_contact_modulus")
        real(c_double), value :: contact_modulus
        type(c_ptr), intent(inout), optional :: out
        integer(c_int) :: status
        type(homogeneous_t), allocatable :: made
        class(solver_t), allocatable :: object
        type(error_t), allocatable :: error

        allocate (made)
        call new_homogeneous_from_modulus(made, contact_modulus, error)
        call move_alloc(made, object)
        status = return_solver(object, out, error)
    end function mdr_medium_contact_modulus

    function mdr_medium_new(body, options, out) result(status) &
        bind(C, name="mdrcontact_entry_medium_new")
        type(c_ptr), value :: body, options
        type(c_ptr), intent(inout), optional :: out
        integer(c_int) :: status
        type(medium_t), allocatable :: made
        class(*), allocatable :: object
        type(any_body_t), pointer :: body_inside
        type(model_options_t) :: chosen
        integer :: model
        type(error_t), allocatable :: error

        allocate (made)
        call open_handle(body, "body", body_inside, error)
        if (.not. allocated(error)) call read_medium_options(error, options, model, chosen)
        if (.not. allocated(error)) call new_medium_of(made, body_inside, model, chosen, error)
        call move_alloc(made, object)
        status = return_object(object, out, error)
    end function mdr_medium_new

    function mdr_medium_pair(lower, upper, out) result(status) &
        bind(C, name="mdrcontact_entry_medium_pair")
        type(c_ptr), value :: lower, upper
        type(c_ptr), intent(inout), optional :: out
        integer(c_int) :: status
        type(medium_t), allocatable :: made
        class(*), allocatable :: object
        type(medium_t), pointer :: lower_inside, upper_inside
        type(error_t), allocatable :: error

        allocate (made)
        call open_handle(lower, "lower", lower_inside, error)
        call open_handle(upper, "upper", upper_inside, error)
        if (.not. allocated(error)) call new_pair(made, lower_inside, upper_inside, error)
        call move_alloc(made, object)
        status = return_object(object, out, error)
    end function mdr_medium_pair

    function mdr_medium_table(n, a, moduli, out) result(status) &
        bind(C, name="mdrcontact_entry_medium_table")
        integer(c_int), value :: n
        real(c_double), intent(in), optional :: a(*), moduli(*)
        type(c_ptr), intent(inout), optional :: out
        integer(c_int) :: status
        type(tabulated_medium_t), allocatable :: made
        class(solver_t), allocatable :: object
        type(error_t), allocatable :: error

        allocate (made)
        call check_not_empty(error, "a", n, 3)
        if (.not. allocated(error) .and. n > 0) call check_table(error, "a", a(:n), "moduli", moduli(:n), 3)
        if (.not. allocated(error) .and. n > 0) call check_each_positive(error, "a", a(:n))
        if (.not. allocated(error) .and. n > 0) call check_each_positive(error, "moduli", moduli(:n))
        if (.not. allocated(error) .and. n > 0) call new_tabulated_medium(made, a(:n), moduli(:n), error)
        call move_alloc(made, object)
        status = return_solver(object, out, error)
    end function mdr_medium_table

    function mdr_medium_function(modulus, context, smallest_radius, largest_radius, out) result(status) &
        bind(C, name="mdrcontact_entry_medium_function")
        type(c_funptr), value :: modulus
        type(c_ptr), value :: context
        real(c_double), value :: smallest_radius, largest_radius
        type(c_ptr), intent(inout), optional :: out
        integer(c_int) :: status
        type(tabulated_medium_t), allocatable :: made
        class(solver_t), allocatable :: object
        type(c_function_t) :: modulus_function
        type(error_t), allocatable :: error

        allocate (made)
        call new_c_function(modulus_function, "modulus", modulus, context, error)
        if (.not. allocated(error)) call new_medium_from_function(made, modulus_function, smallest_radius, largest_radius, error)
        call move_alloc(made, object)
        status = return_solver(object, out, error)
    end function mdr_medium_function

    function mdr_weight(weight, nu, n, xi, out) result(status) &
        bind(C, name="mdrcontact_entry_weight")
        integer(c_int), value :: weight, n
        real(c_double), value :: nu
        real(c_double), intent(in), optional :: xi(*)
        real(c_double), intent(inout), optional :: out(*)
        integer(c_int) :: status
        type(weight_map_t) :: map
        type(error_t), allocatable :: error

        call check_code(error, "weight", weight, [of_i0_slope, of_i0, of_i1, of_j0, of_j1, of_i0_tangential, of_j0_tangential])
        if (.not. allocated(error)) call check_poisson(error, "nu", nu)
        if (.not. allocated(error) .and. n > 0) call check_each_not_negative(error, "xi", xi(:n))
        if (.not. allocated(error)) map%weight = weight
        if (.not. allocated(error)) map%nu = nu
        if (.not. allocated(error) .and. n > 0) call run_map(map, xi(:n), out(:n), wanted_threads())
        status = status_of(error)
    end function mdr_weight

    function mdr_contact_states(c, given, branch, n, in, out) result(status) &
        bind(C, name="mdrcontact_entry_contact_states")
        type(c_ptr), value :: c
        integer(c_int), value :: given, branch, n
        real(c_double), intent(in), optional :: in(*)
        type(contact_state_t), intent(inout), optional :: out(*)
        integer(c_int) :: status
        type(contact_t), pointer :: c_inside
        type(contact_state_t), allocatable :: out_values(:)
        integer :: stat
        type(error_t), allocatable :: error

        call open_handle(c, "c", c_inside, error)
        if (.not. allocated(error)) then
            allocate (out_values(n), stat=stat)
            call check_memory(error, stat)
        end if
        if (.not. allocated(error) .and. n > 0) then
            call contact_states(c_inside, given, in(:n), out_values, error, branch, wanted_threads())
        end if
        status = status_of(error)
        if (allocated(error)) return
        if (present(out)) out(:n) = out_values
    end function mdr_contact_states

    function mdr_contact_slope(c, n, states, out) result(status) &
        bind(C, name="mdrcontact_entry_contact_slope")
        type(c_ptr), value :: c
        integer(c_int), value :: n
        type(contact_state_t), intent(in), optional :: states(*)
        real(c_double), intent(inout), optional :: out(*)
        integer(c_int) :: status
        type(contact_t), pointer :: c_inside
        real(c_double), allocatable :: out_values(:)
        integer :: i
        type(error_t), allocatable :: error

        call open_handle(c, "c", c_inside, error)
        call make_room(error, n, out_values)
        do i = 1, n
            if (allocated(error)) exit
            call c_inside%slope(states(i), out_values(i), error)
            if (.not. allocated(error)) call check_results(error, [out_values(i)])
            if (allocated(error)) call raise_at(error, i)
        end do
        status = status_of(error)
        if (allocated(error)) return
        if (present(out)) out(:n) = out_values
    end function mdr_contact_slope

    function mdr_loop_new(c, control, largest, points, spring_stiffness, out) result(status) &
        bind(C, name="mdrcontact_entry_loop_new")
        type(c_ptr), value :: c
        integer(c_int), value :: control, points
        real(c_double), value :: largest, spring_stiffness
        type(c_ptr), intent(inout), optional :: out
        integer(c_int) :: status
        type(loop_t), allocatable :: made
        class(*), allocatable :: object
        type(contact_t), pointer :: c_inside
        type(control_t) :: chosen
        type(error_t), allocatable :: error

        allocate (made)
        call open_handle(c, "c", c_inside, error)
        if (.not. allocated(error)) call choose_control(chosen, control, spring_stiffness, .true., error)
        if (.not. allocated(error)) call new_loop(made, c_inside, chosen, largest, points, error)
        call move_alloc(made, object)
        status = return_object(object, out, error)
    end function mdr_loop_new

    function mdr_load_energy(load, lower, upper) result(status) &
        bind(C, name="mdrcontact_entry_load_energy")
        type(c_ptr), value :: load
        real(c_double), intent(inout), optional :: lower, upper
        integer(c_int) :: status
        type(contact_load_t), pointer :: load_inside
        real(c_double) :: values(2), lower_value, upper_value
        type(error_t), allocatable :: error

        call open_handle(load, "load", load_inside, error)
        if (.not. allocated(error)) call load_inside%energy(values, error)
        if (.not. allocated(error)) call check_results_or_infinity(error, values)
        lower_value = 0.0_c_double
        if (.not. allocated(error)) lower_value = values(1)
        upper_value = 0.0_c_double
        if (.not. allocated(error)) upper_value = values(2)
        status = status_of(error)
        if (allocated(error)) return
        if (present(lower)) lower = lower_value
        if (present(upper)) upper = upper_value
    end function mdr_load_energy

    function mdr_load_field(load, field, n, r, out) result(status) &
        bind(C, name="mdrcontact_entry_load_field")
        type(c_ptr), value :: load
        integer(c_int), value :: field, n
        real(c_double), intent(in), optional :: r(*)
        real(c_double), intent(inout), optional :: out(*)
        integer(c_int) :: status
        type(contact_load_t), pointer :: load_inside
        real(c_double), allocatable :: out_values(:)
        type(error_t), allocatable :: error

        call open_handle(load, "load", load_inside, error)
        call make_room(error, n, out_values)
        if (.not. allocated(error) .and. n > 0) call load_field(load_inside, field, r(:n), out_values, error, wanted_threads())
        if (.not. allocated(error)) call check_results_or_infinity(error, out_values)
        status = status_of(error)
        if (allocated(error)) return
        if (present(out)) out(:n) = out_values
    end function mdr_load_field

    function mdr_load_lowest_pressure(load, pressure, r) result(status) &
        bind(C, name="mdrcontact_entry_load_lowest_pressure")
        type(c_ptr), value :: load
        real(c_double), intent(inout), optional :: pressure, r
        integer(c_int) :: status
        type(contact_load_t), pointer :: load_inside
        real(c_double) :: pressure_value, r_value
        type(error_t), allocatable :: error

        call open_handle(load, "load", load_inside, error)
        pressure_value = 0.0_c_double
        r_value = 0.0_c_double
        if (.not. allocated(error)) call load_inside%lowest_pressure(pressure_value, r_value, error)
        status = status_of(error)
        if (allocated(error)) return
        if (present(pressure)) pressure = pressure_value
        if (present(r)) r = r_value
    end function mdr_load_lowest_pressure

    function mdr_friction_new(c, coefficient, out) result(status) &
        bind(C, name="mdrcontact_entry_friction_new")
        type(c_ptr), value :: c
        real(c_double), value :: coefficient
        type(c_ptr), intent(inout), optional :: out
        integer(c_int) :: status
        type(friction_t), allocatable :: made
        class(*), allocatable :: object
        type(contact_t), pointer :: c_inside
        type(error_t), allocatable :: error

        allocate (made)
        call open_handle(c, "c", c_inside, error)
        if (.not. allocated(error)) call new_friction(made, c_inside, coefficient, error)
        call move_alloc(made, object)
        status = return_object(object, out, error)
    end function mdr_friction_new

    function mdr_friction_history_new(f, largest_depth, rings, out) result(status) &
        bind(C, name="mdrcontact_entry_friction_history_new")
        type(c_ptr), value :: f
        real(c_double), value :: largest_depth
        integer(c_int), value :: rings
        type(c_ptr), intent(inout), optional :: out
        integer(c_int) :: status
        type(friction_history_t), allocatable :: made
        class(*), allocatable :: object
        type(friction_t), pointer :: f_inside
        type(error_t), allocatable :: error

        allocate (made)
        call open_handle(f, "f", f_inside, error)
        if (.not. allocated(error)) call new_friction_history(made, f_inside, error, largest_depth, rings)
        call move_alloc(made, object)
        status = return_object(object, out, error)
    end function mdr_friction_history_new

    function mdr_friction_history_copy(h, out) result(status) &
        bind(C, name="mdrcontact_entry_friction_history_copy")
        type(c_ptr), value :: h
        type(c_ptr), intent(inout), optional :: out
        integer(c_int) :: status
        type(friction_history_t), allocatable :: made
        class(*), allocatable :: object
        type(friction_history_t), pointer :: h_inside
        type(error_t), allocatable :: error

        allocate (made)
        call open_handle(h, "h", h_inside, error)
        if (.not. allocated(error)) call h_inside%copy(made, error)
        call move_alloc(made, object)
        status = return_object(object, out, error)
    end function mdr_friction_history_copy

    function mdr_law_with_radius(law, radius, out) result(status) &
        bind(C, name="mdrcontact_entry_law_with_radius")
        type(c_ptr), value :: law
        real(c_double), value :: radius
        type(c_ptr), intent(inout), optional :: out
        integer(c_int) :: status
        type(contact_law_t), allocatable :: made
        class(*), allocatable :: object
        type(contact_law_t), pointer :: law_inside
        type(error_t), allocatable :: error

        allocate (made)
        call open_handle(law, "law", law_inside, error)
        if (.not. allocated(error)) call law_inside%with_radius(radius, made, error)
        call move_alloc(made, object)
        status = return_object(object, out, error)
    end function mdr_law_with_radius

    function mdr_law_save(law, path) result(status) &
        bind(C, name="mdrcontact_entry_law_save")
        type(c_ptr), value :: law, path
        integer(c_int) :: status
        type(contact_law_t), pointer :: law_inside
        character(len=:), allocatable :: name
        type(error_t), allocatable :: error

        call open_handle(law, "law", law_inside, error)
        if (.not. allocated(error)) call read_name(path, name, error)
        if (.not. allocated(error)) call save_law(law_inside, name, error)
        status = status_of(error)
    end function mdr_law_save

    function mdr_law_load(path, out) result(status) &
        bind(C, name="mdrcontact_entry_law_load")
        type(c_ptr), value :: path
        type(c_ptr), intent(inout), optional :: out
        integer(c_int) :: status
        type(contact_law_t), allocatable :: made
        class(*), allocatable :: object
        character(len=:), allocatable :: name
        type(error_t), allocatable :: error

        allocate (made)
        call read_name(path, name, error)
        if (.not. allocated(error)) call load_law(made, name, error)
        call move_alloc(made, object)
        status = return_object(object, out, error)
    end function mdr_law_load

    function mdr_law_read(buffer, length, out) result(status) &
        bind(C, name="mdrcontact_entry_law_read")
        type(c_ptr), value :: buffer
        integer(c_int), value :: length
        type(c_ptr), intent(inout), optional :: out
        integer(c_int) :: status
        type(contact_law_t), allocatable :: made
        class(*), allocatable :: object
        character(len=:), allocatable :: text
        type(error_t), allocatable :: error

        allocate (made)
        call read_content(buffer, length, text, error)
        if (.not. allocated(error)) call law_from_text(made, text, error)
        call move_alloc(made, object)
        status = return_object(object, out, error)
    end function mdr_law_read

    function mdr_closed_form(formula, n, x, constants, out) result(status) &
        bind(C, name="mdrcontact_entry_closed_form")
        integer(c_int), value :: formula, n
        real(c_double), intent(in), optional :: x(*), constants(*)
        real(c_double), intent(inout), optional :: out(*)
        integer(c_int) :: status
        real(c_double), allocatable :: out_values(:)
        type(error_t), allocatable :: error

        call check_code(error, "formula", formula, formulas)
        if (.not. allocated(error)) call check_constants(error, formula, constants(:constant_count(formula)))
        if (.not. allocated(error) .and. n > 0) call check_each_positive(error, trim(variable_name(formula)), x(:n))
        call make_room(error, n, out_values)
        if (.not. allocated(error) .and. n > 0) then
            call closed_form_values(formula, x(:n), constants(:constant_count(formula)), out_values, wanted_threads())
        end if
        if (.not. allocated(error)) call check_results(error, out_values)
        status = status_of(error)
        if (allocated(error)) return
        if (present(out)) out(:n) = out_values
    end function mdr_closed_form

end module mdrcontact_api_entries
