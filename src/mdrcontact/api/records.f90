! SPDX-License-Identifier: GPL-3.0-or-later
!> The structures of the C header, all 0 at first, written by tools/generate.py.
module mdrcontact_api_records
    use, intrinsic :: iso_c_binding, only: c_char, c_double, c_int, c_null_char, c_null_ptr, c_ptr, c_size_t
    implicit none (type, external)
    private
    public :: c_failure_t, c_parameter_t, c_layer_t, c_surface_t, c_model_facts_t, c_medium_options_t, c_contact_options_t, &
              c_loop_facts_t, c_maximum_t, c_strength_t, c_failure_load_t, c_shear_facts_t, c_law_options_t, c_law_facts_t, &
              c_rate_options_t, c_wear_options_t, c_imprint_facts_t, c_plastic_law_options_t, c_plastic_law_facts_t, &
              c_structure_options_t, c_fit_parameter_t, c_fit_problem_t, c_fit_summary_t

    !> struct mdr_failure
    type, bind(C) :: c_failure_t
        integer(c_size_t) :: size = 0_c_size_t
        integer(c_int) :: status = 0_c_int
        integer(c_int) :: entry = 0_c_int
        character(kind=c_char) :: argument(64) = c_null_char
        character(kind=c_char) :: text(1024) = c_null_char
    end type c_failure_t

    !> struct mdr_parameter
    type, bind(C) :: c_parameter_t
        character(kind=c_char) :: name(48) = c_null_char
        real(c_double) :: value = 0.0_c_double
    end type c_parameter_t

    !> struct mdr_layer
    type, bind(C) :: c_layer_t
        integer(c_size_t) :: size = 0_c_size_t
        real(c_double) :: thickness = 0.0_c_double
        real(c_double) :: e = 0.0_c_double
        real(c_double) :: nu = 0.0_c_double
        real(c_double) :: e_z = 0.0_c_double
        real(c_double) :: nu_tz = 0.0_c_double
        real(c_double) :: g_z = 0.0_c_double
        real(c_double) :: c11 = 0.0_c_double
        real(c_double) :: c12 = 0.0_c_double
        real(c_double) :: c13 = 0.0_c_double
        real(c_double) :: c33 = 0.0_c_double
        real(c_double) :: c44 = 0.0_c_double
        real(c_double) :: prestress = 0.0_c_double
        real(c_double) :: normal_compliance = 0.0_c_double
        real(c_double) :: tangential_compliance = 0.0_c_double
        type(c_ptr) :: material = c_null_ptr
    end type c_layer_t

    !> struct mdr_surface
    type, bind(C) :: c_surface_t
        integer(c_size_t) :: size = 0_c_size_t
        real(c_double) :: tension = 0.0_c_double
        real(c_double) :: bending = 0.0_c_double
        real(c_double) :: stretching = 0.0_c_double
    end type c_surface_t

    !> struct mdr_model_facts
    type, bind(C) :: c_model_facts_t
        integer(c_size_t) :: size = 0_c_size_t
        real(c_double) :: largest_ratio = 0.0_c_double
        integer(c_int) :: base = 0_c_int
        integer(c_int) :: takes_layers = 0_c_int
        integer(c_int) :: takes_graded = 0_c_int
        integer(c_int) :: spherical_only = 0_c_int
        character(kind=c_char) :: constant(24) = c_null_char
        character(kind=c_char) :: option(24) = c_null_char
        real(c_double) :: default_constant = 0.0_c_double
    end type c_model_facts_t

    !> struct mdr_medium_options
    type, bind(C) :: c_medium_options_t
        integer(c_size_t) :: size = 0_c_size_t
        integer(c_int) :: model = 0_c_int
        real(c_double) :: alpha = 0.0_c_double
        real(c_double) :: wave_factor = 0.0_c_double
        integer(c_int) :: weight_nu_choice = 0_c_int
        real(c_double) :: weight_nu = 0.0_c_double
        real(c_double) :: tolerance = 0.0_c_double
        real(c_double) :: exponent = 0.0_c_double
        integer(c_int) :: exponent_is_given = 0_c_int
    end type c_medium_options_t

    !> struct mdr_contact_options
    type, bind(C) :: c_contact_options_t
        integer(c_size_t) :: size = 0_c_size_t
        integer(c_int) :: zeta_count = 0_c_int
        type(c_ptr) :: zeta_radius = c_null_ptr
        type(c_ptr) :: zeta = c_null_ptr
        real(c_double) :: work_of_adhesion = 0.0_c_double
        integer(c_int) :: adhesion_rule = 0_c_int
        integer(c_int) :: zeta_is_exact = 0_c_int
        real(c_double) :: cohesive_stress = 0.0_c_double
    end type c_contact_options_t

    !> struct mdr_loop_facts
    type, bind(C) :: c_loop_facts_t
        integer(c_size_t) :: size = 0_c_size_t
        real(c_double) :: dissipated_energy = 0.0_c_double
        integer(c_int) :: points = 0_c_int
        integer(c_int) :: turning_point = 0_c_int
        integer(c_int) :: jumps = 0_c_int
    end type c_loop_facts_t

    !> struct mdr_maximum
    type, bind(C) :: c_maximum_t
        integer(c_int) :: quantity = 0_c_int
        integer(c_int) :: place = 0_c_int
        real(c_double) :: value = 0.0_c_double
        real(c_double) :: r = 0.0_c_double
        real(c_double) :: z = 0.0_c_double
        real(c_double) :: angle = 0.0_c_double
    end type c_maximum_t

    !> struct mdr_strength
    type, bind(C) :: c_strength_t
        integer(c_int) :: quantity = 0_c_int
        integer(c_int) :: place = 0_c_int
        real(c_double) :: value = 0.0_c_double
    end type c_strength_t

    !> struct mdr_failure_load
    type, bind(C) :: c_failure_load_t
        real(c_double) :: depth = 0.0_c_double
        real(c_double) :: radius = 0.0_c_double
        real(c_double) :: force = 0.0_c_double
        real(c_double) :: stiffness = 0.0_c_double
        real(c_double) :: punch_depth = 0.0_c_double
        real(c_double) :: zone_radius = 0.0_c_double
        integer(c_int) :: quantity = 0_c_int
        integer(c_int) :: place = 0_c_int
        real(c_double) :: strength = 0.0_c_double
        real(c_double) :: value = 0.0_c_double
        real(c_double) :: r = 0.0_c_double
        real(c_double) :: z = 0.0_c_double
        real(c_double) :: angle = 0.0_c_double
    end type c_failure_load_t

    !> struct mdr_shear_facts
    type, bind(C) :: c_shear_facts_t
        integer(c_size_t) :: size = 0_c_size_t
        real(c_double) :: sliding_shift = 0.0_c_double
        real(c_double) :: sliding_force = 0.0_c_double
        integer(c_int) :: direction = 0_c_int
    end type c_shear_facts_t

    !> struct mdr_law_options
    type, bind(C) :: c_law_options_t
        integer(c_size_t) :: size = 0_c_size_t
        real(c_double) :: smallest_depth = 0.0_c_double
        real(c_double) :: tolerance = 0.0_c_double
        type(c_ptr) :: description = c_null_ptr
        integer(c_int) :: continue_beyond = 0_c_int
        type(c_ptr) :: friction = c_null_ptr
        integer(c_int) :: sliders = 0_c_int
        real(c_double) :: shear_strength = 0.0_c_double
        type(c_ptr) :: conduction = c_null_ptr
        integer(c_int) :: twist = 0_c_int
    end type c_law_options_t

    !> struct mdr_law_facts
    type, bind(C) :: c_law_facts_t
        integer(c_size_t) :: size = 0_c_size_t
        real(c_double) :: lowest_depth = 0.0_c_double
        real(c_double) :: highest_depth = 0.0_c_double
        real(c_double) :: lowest_force = 0.0_c_double
        real(c_double) :: highest_force = 0.0_c_double
        real(c_double) :: tolerance = 0.0_c_double
        real(c_double) :: error = 0.0_c_double
        integer(c_int) :: solutions = 0_c_int
        integer(c_int) :: adhesive = 0_c_int
        integer(c_int) :: segments = 0_c_int
        type(c_ptr) :: description = c_null_ptr
        integer(c_int) :: continue_beyond = 0_c_int
        integer(c_int) :: sliders = 0_c_int
        integer(c_int) :: memory_size = 0_c_int
        real(c_double) :: coefficient = 0.0_c_double
        real(c_double) :: highest_sliding_shift = 0.0_c_double
        real(c_double) :: first_shear_error = 0.0_c_double
        real(c_double) :: path_error = 0.0_c_double
        integer(c_int) :: buffer_size = 0_c_int
        real(c_double) :: shear_strength = 0.0_c_double
        integer(c_int) :: conducts = 0_c_int
        integer(c_int) :: twists = 0_c_int
    end type c_law_facts_t

    !> struct mdr_rate_options
    type, bind(C) :: c_rate_options_t
        integer(c_size_t) :: size = 0_c_size_t
        real(c_double) :: work = 0.0_c_double
        real(c_double) :: speed = 0.0_c_double
        real(c_double) :: exponent = 0.0_c_double
        real(c_double) :: closing_work = 0.0_c_double
        real(c_double) :: closing_speed = 0.0_c_double
        real(c_double) :: closing_exponent = 0.0_c_double
        type(c_ptr) :: material = c_null_ptr
        real(c_double) :: cohesive_stress = 0.0_c_double
        real(c_double) :: largest_radius = 0.0_c_double
        real(c_double) :: smallest_radius = 0.0_c_double
    end type c_rate_options_t

    !> struct mdr_wear_options
    type, bind(C) :: c_wear_options_t
        integer(c_size_t) :: size = 0_c_size_t
        integer(c_int) :: intervals = 0_c_int
        integer(c_int) :: places = 0_c_int
        integer(c_int) :: scheme = 0_c_int
    end type c_wear_options_t

    !> struct mdr_imprint_facts
    type, bind(C) :: c_imprint_facts_t
        integer(c_size_t) :: size = 0_c_size_t
        real(c_double) :: radius = 0.0_c_double
        real(c_double) :: force = 0.0_c_double
        real(c_double) :: depth = 0.0_c_double
        real(c_double) :: residual_depth = 0.0_c_double
        real(c_double) :: recovered_work = 0.0_c_double
        real(c_double) :: uniform = 0.0_c_double
        real(c_double) :: hertz = 0.0_c_double
        real(c_double) :: misfit = 0.0_c_double
    end type c_imprint_facts_t

    !> struct mdr_plastic_law_options
    type, bind(C) :: c_plastic_law_options_t
        integer(c_size_t) :: size = 0_c_size_t
        type(c_ptr) :: other = c_null_ptr
        real(c_double) :: work_of_adhesion = 0.0_c_double
        real(c_double) :: tolerance = 0.0_c_double
    end type c_plastic_law_options_t

    !> struct mdr_plastic_law_facts
    type, bind(C) :: c_plastic_law_facts_t
        integer(c_size_t) :: size = 0_c_size_t
        real(c_double) :: yield_depth = 0.0_c_double
        real(c_double) :: yield_force = 0.0_c_double
        real(c_double) :: first_yield = 0.0_c_double
        real(c_double) :: largest_depth = 0.0_c_double
        real(c_double) :: largest_force = 0.0_c_double
        real(c_double) :: largest_radius = 0.0_c_double
        real(c_double) :: radius = 0.0_c_double
        real(c_double) :: modulus = 0.0_c_double
        real(c_double) :: work_of_adhesion = 0.0_c_double
        real(c_double) :: tolerance = 0.0_c_double
        real(c_double) :: error = 0.0_c_double
        integer(c_int) :: memory_size = 0_c_int
        integer(c_int) :: buffer_size = 0_c_int
    end type c_plastic_law_facts_t

    !> struct mdr_structure_options
    type, bind(C) :: c_structure_options_t
        integer(c_size_t) :: size = 0_c_size_t
        real(c_double) :: reference_nu = 0.0_c_double
        real(c_double) :: tolerance = 0.0_c_double
        integer(c_int) :: padded = 0_c_int
        integer(c_int) :: images = 0_c_int
        real(c_double) :: beside_e = 0.0_c_double
        real(c_double) :: beside_nu = 0.0_c_double
        real(c_double) :: origin(2) = 0.0_c_double
        real(c_double) :: exponent = 0.0_c_double
        integer(c_int) :: reference_nu_is_given = 0_c_int
        integer(c_int) :: exponent_is_given = 0_c_int
    end type c_structure_options_t

    !> struct mdr_fit_parameter
    type, bind(C) :: c_fit_parameter_t
        real(c_double) :: value = 0.0_c_double
        real(c_double) :: lower = 0.0_c_double
        real(c_double) :: upper = 0.0_c_double
        real(c_double) :: prior = 0.0_c_double
        real(c_double) :: prior_sd = 0.0_c_double
        integer(c_int) :: is_free = 0_c_int
        character(kind=c_char) :: name(48) = c_null_char
    end type c_fit_parameter_t

    !> struct mdr_fit_problem
    type, bind(C) :: c_fit_problem_t
        integer(c_size_t) :: size = 0_c_size_t
        integer(c_int) :: data_kind = 0_c_int
        type(c_ptr) :: profile = c_null_ptr
        type(c_ptr) :: medium = c_null_ptr
        type(c_ptr) :: counterbody = c_null_ptr
        integer(c_int) :: adhesion_rule = 0_c_int
        integer(c_int) :: loss = 0_c_int
        real(c_double) :: loss_scale = 0.0_c_double
        integer(c_int) :: sd_is_relative = 0_c_int
        integer(c_int) :: max_iterations = 0_c_int
        integer(c_int) :: any_units = 0_c_int
        integer(c_int) :: parameter_count = 0_c_int
        type(c_ptr) :: parameters = c_null_ptr
        integer(c_int) :: prior_count = 0_c_int
        type(c_ptr) :: prior_weights = c_null_ptr
        type(c_ptr) :: branch = c_null_ptr
        integer(c_int) :: is_elastic = 0_c_int
    end type c_fit_problem_t

    !> struct mdr_fit_summary
    type, bind(C) :: c_fit_summary_t
        integer(c_size_t) :: size = 0_c_size_t
        integer(c_int) :: converged = 0_c_int
        integer(c_int) :: iterations = 0_c_int
        integer(c_int) :: evaluations = 0_c_int
        real(c_double) :: chi_square = 0.0_c_double
        real(c_double) :: prior_chi_square = 0.0_c_double
        real(c_double) :: degrees_of_freedom = 0.0_c_double
        real(c_double) :: noise = 0.0_c_double
        real(c_double) :: log_likelihood = 0.0_c_double
        real(c_double) :: pattern_probability = 0.0_c_double
        real(c_double) :: weakest = 0.0_c_double
        real(c_double) :: lag_correlation = 0.0_c_double
    end type c_fit_summary_t

end module mdrcontact_api_records
