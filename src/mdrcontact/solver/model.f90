! SPDX-License-Identifier: GPL-3.0-or-later
!> The models under which a body becomes a medium: the one table of their codes, names and options, and the one factory.
!>
!>     call new_stack(film, [oxide], [500e-9_wp], silicon, error)
!>     if (.not. allocated(error)) call new_solver(medium, film, models%exact, error)
module mdrcontact_model
    use, intrinsic :: iso_c_binding, only: c_double, c_int
    use mdrcontact_parameter, only: parameter_t
    use mdrcontact_body, only: body_t, copy
    use mdrcontact_body_layers, only: layers_t
    use mdrcontact_codes, only: base_any, base_elastic, base_rigid, model_bec, model_dimitriadis, model_doerner_nix, model_exact, &
                                model_gao, model_gao_power, model_gao_series, model_garcia, model_hay_crawford, &
                                model_mencik_exponential, model_mencik_reciprocal, model_perriot_barthel, model_wave, &
                                weight_nu_surface, word_of
    use mdrcontact_error, only: check_made, code_text, count_text, error_invalid, error_t, raise, to_text
    use mdrcontact_kinds, only: half_pi, wp
    use mdrcontact_medium_exact, only: layered_exact_t, new_layered_exact
    use mdrcontact_line_shared, only: kernel_cache_t
    use mdrcontact_material, only: material_t
    use mdrcontact_medium_solver, only: solver_t
    use mdrcontact_medium_bec, only: bec_t, new_bec
    use mdrcontact_medium_bottom_effect, only: bottom_effect_ratio, bottom_effect_t, dimitriadis_series, garcia_series, &
                                                 new_bottom_effect
    use mdrcontact_medium_doerner_nix, only: doerner_nix_t, new_doerner_nix
    use mdrcontact_medium_gao, only: gao_options_t, gao_t, new_gao_layered
    use mdrcontact_medium_graded, only: graded_t, new_graded
    use mdrcontact_medium_hay_crawford, only: hay_crawford_t, new_hay_crawford
    use mdrcontact_medium_homogeneous, only: homogeneous_t, new_homogeneous
    use mdrcontact_medium_mencik, only: mencik_t, new_mencik
    use mdrcontact_medium_perriot_barthel, only: new_perriot_barthel, perriot_barthel_t
    use mdrcontact_medium_surface_tension_solver, only: new_surface_tension_solver, surface_tension_solver_t
    use mdrcontact_medium_elastic_sheet, only: new_elastic_sheet, elastic_sheet_t
    use mdrcontact_medium_wave, only: new_wave, wave_t
    use mdrcontact_tension_surface, only: has_springs, is_bare, surface_t
    implicit none (type, external)
    private
    public :: models, model_table, new_solver, model_position, model_text
    public :: constant_of, model_options_t, option_names, option_values, options_of, with_constant

    !> Codes of the models, enum mdr_model of the C header.
    type :: model_codes_t
        integer :: gao = model_gao, gao_series = model_gao_series, doerner_nix = model_doerner_nix, &
                   wave = model_wave, mencik_exponential = model_mencik_exponential, mencik_reciprocal = model_mencik_reciprocal, &
                   bec = model_bec, perriot_barthel = model_perriot_barthel, hay_crawford = model_hay_crawford, &
                   dimitriadis = model_dimitriadis, garcia = model_garcia, exact = model_exact, &
                   gao_power = model_gao_power
    end type model_codes_t

    !> Codes of the models by name, as models%exact
    type(model_codes_t), parameter :: models = model_codes_t()

    !> Options of the models, struct mdr_medium_options; a model uses only its own.
    type, bind(C) :: model_options_t
        !> decay constant > 0 of Doerner-Nix and Mencik
        real(c_double) :: alpha = 1.0_c_double
        !> q a > 0 of the wave
        real(c_double) :: wave_factor = half_pi
        !> one of gao_nu_..., which nu enters I0, and the number for gao_nu_given
        integer(c_int) :: weight_nu_choice = int(weight_nu_surface, c_int)
        !> that number, -1 < weight_nu <= 1/2
        real(c_double) :: weight_nu = 0.5_c_double
        !> relative tolerance of the exact solution
        real(c_double) :: tolerance = 1.0e-10_c_double
        !> p of the power mean of Gao's weights, -1 (series) to 1 (parallel); with the default E_eff is -14 to +18 %
        !> off for shear moduli within a factor 10 (docs/model-errors.md)
        real(c_double) :: exponent = -0.65_c_double
    end type model_options_t

    !> Names of the options, in the order of their values below.
    character(len=16), parameter :: option_names(*) = [character(len=16) :: "alpha", "wave_factor", "weight_nu_choice", &
                                                       "weight_nu", "tolerance", "exponent"]

    !> A row of the table.
    type :: model_t
        integer :: code = -1
        !> one of base_...
        integer :: base = base_elastic
        !> whether it takes any number of layers, and a graded body
        logical :: layers = .false., graded = .false.
        !> the options it takes: a number that can be fitted, and another one
        character(len=16) :: constant = "", option = ""
        !> where it is valid: under a paraboloid or a sphere only; up to this a/h
        logical :: spherical_only = .false.
        real(wp) :: largest_ratio = huge(1.0_wp)
    end type model_t

    !> The models.
    type(model_t), parameter :: model_table(*) = [ &
        model_t(models%gao, base_elastic, .true., .true., option="weight_nu"), &
        model_t(models%gao_series, base_elastic, .true., .true., option="weight_nu"), &
        model_t(models%gao_power, base_elastic, .true., .true., "exponent", "weight_nu"), &
        model_t(models%doerner_nix, constant="alpha"), &
        model_t(models%wave, constant="wave_factor"), &
        model_t(models%mencik_exponential, constant="alpha"), &
        model_t(models%mencik_reciprocal, constant="alpha"), &
        model_t(models%bec), &
        model_t(models%perriot_barthel), &
        model_t(models%hay_crawford), &
        model_t(models%dimitriadis, base_rigid, spherical_only=.true., largest_ratio=bottom_effect_ratio), &
        model_t(models%garcia, base_rigid, spherical_only=.true., largest_ratio=bottom_effect_ratio), &
        model_t(models%exact, base_any, .true., .true., option="tolerance")]

contains

    !> Index of a model in the table; 0 for a code that does not exist.
    pure function model_position(code) result(position)
        integer, intent(in) :: code
        integer :: position

        position = findloc(model_table%code, code, dim=1)
    end function model_position

    !> A model's name; any other code as number and word.
    pure function model_text(code) result(text)
        integer, intent(in) :: code
        character(len=48) :: text

        text = code_text(code)
        if (model_position(code) > 0) text = word_of(code)
    end function model_text

    !> The options as numbers, in the order of their names.
    pure function option_values(options) result(values)
        type(model_options_t), intent(in) :: options
        real(wp) :: values(size(option_names))

        values = [options%alpha, options%wave_factor, real(options%weight_nu_choice, wp), options%weight_nu, options%tolerance, &
                  options%exponent]
    end function option_values

    !> The options with these values.
    pure function options_of(values) result(options)
        real(wp), intent(in) :: values(:)
        type(model_options_t) :: options

        options = model_options_t(values(1), values(2), nint(values(3), c_int), values(4), values(5), values(6))
    end function options_of

    !> The model's constant, if it has one.
    pure function constant_of(model, options) result(constant)
        integer, intent(in) :: model
        type(model_options_t), intent(in) :: options
        type(parameter_t), allocatable :: constant(:)
        integer :: i

        i = findloc(model_table%code == model .and. model_table%constant /= "", .true., dim=1)
        allocate (constant(min(i, 1)))
        if (i == 0) return
        constant(1)%name = model_table(i)%constant
        constant(1)%value = sum(option_values(options), mask=option_names == model_table(i)%constant)
    end function constant_of

    !> The options with another value for the model's constant, if it has one.
    pure function with_constant(options, model, constant) result(changed)
        type(model_options_t), intent(in) :: options
        integer, intent(in) :: model
        real(wp), intent(in) :: constant
        type(model_options_t) :: changed
        real(wp) :: values(size(option_names))
        type(parameter_t) :: own(1)

        changed = options
        if (size(constant_of(model, options)) == 0) return
        own = constant_of(model, options)
        values = option_values(options)
        where (option_names == own(1)%name) values = constant
        changed = options_of(values)
    end function with_constant

    !> A body under a model. The medium keeps the body.
    subroutine new_solver(medium, body, model, error, options, shared, surface)
        class(solver_t), allocatable, intent(out) :: medium
        class(body_t), intent(in) :: body
        !> one of models%...
        integer, intent(in) :: model
        type(error_t), allocatable, intent(out) :: error
        !> without it: the defaults
        type(model_options_t), intent(in), optional :: options
        !> data shared by exact media created one after the other
        type(kernel_cache_t), intent(inout), optional :: shared
        !> tension and plate of its surface; default none
        type(surface_t), intent(in), optional :: surface
        type(model_options_t) :: chosen
        type(layered_exact_t), allocatable :: exact
        type(homogeneous_t), allocatable :: half_space

        call check_made(error, "body", body%is_made)
        if (allocated(error)) return
        if (present(options)) chosen = options
        call check_model(body, model, error)
        if (allocated(error)) return
        if (present(surface)) then
            if (.not. is_bare(surface)) then
                call new_sheeted(medium, body, model, chosen%tolerance, surface, error, shared)
                return
            end if
        end if
        if (model == models%exact .and. has_no_layers(body)) then
            allocate (half_space)
            call new_homogeneous(half_space, body%surface_material)
            call move_alloc(half_space, medium)
            return
        else if (model == models%exact) then
            allocate (exact)
            call new_layered_exact(exact, body, error, chosen%tolerance, shared)
            call move_alloc(exact, medium)
            return
        end if
        if (body%is_graded) then
            call new_graded_medium(medium, body, model, chosen, error)
        else
            call new_layered_medium(medium, body, model, chosen, error)
        end if
        if (allocated(error) .or. .not. allocated(medium)) return
        if (.not. allocated(medium%pressed)) call copy(body, medium%pressed, error)
    end subroutine new_solver

    !> A body under a surface that is not bare, solved exactly.
    subroutine new_sheeted(medium, body, model, tolerance, surface, error, shared)
        class(solver_t), allocatable, intent(out) :: medium
        class(body_t), intent(in) :: body
        integer, intent(in) :: model
        !> of one that has springs
        real(wp), intent(in) :: tolerance
        type(surface_t), intent(in) :: surface
        type(error_t), allocatable, intent(inout) :: error
        type(kernel_cache_t), intent(inout), optional :: shared
        type(surface_tension_solver_t), allocatable :: on_tension
        type(elastic_sheet_t), allocatable :: on_sheet

        if (model /= models%exact) then
            call refuse(model, " for a surface with tension or a sheet", model_table%code == models%exact, error)
        else if (body%is_graded) then
            call raise(error, error_invalid, "surface: tension and sheets are not available on a graded body. Use layers")
        end if
        if (allocated(error)) return
        if (has_springs(surface)) then
            allocate (on_sheet)
            call new_elastic_sheet(on_sheet, body, surface, tolerance, error, shared)
            call move_alloc(on_sheet, medium)
            return
        end if
        allocate (on_tension)
        call new_surface_tension_solver(on_tension, body, surface, error, shared)
        call move_alloc(on_tension, medium)
    end subroutine new_sheeted

    !> Whether it is a half-space, and not layers of one material either.
    pure function has_no_layers(body) result(answer)
        class(body_t), intent(in) :: body
        logical :: answer
        type(layers_t) :: layers
        type(error_t), allocatable :: error

        answer = .false.
        if (body%is_graded .or. body%last_depth > 0.0_wp) return
        call body%sublayers(layers, error)
        if (.not. allocated(error)) answer = size(layers%thickness) == 0
    end function has_no_layers

    !> Raises unless the model exists and accepts this kind of body.
    pure subroutine check_model(body, model, error)
        class(body_t), intent(in) :: body
        integer, intent(in) :: model
        type(error_t), allocatable, intent(inout) :: error
        type(layers_t) :: layers
        integer :: i, j, n

        i = model_position(model)
        if (i == 0) then
            call refuse(model, "", model_table%code >= 0, error)
        else if (.not. body%is_plain .and. model /= models%exact) then
            call refuse(model, " for layers that are not isotropic, bonded and free of stress", model_table%code == models%exact, &
                        error)
        else if (body%is_graded) then
            if (.not. model_table(i)%graded) call refuse(model, " for a graded body", &
                                                         [(model_table(j)%graded, j=1, size(model_table))], error)
        else
            call body%sublayers(layers, error)
            if (allocated(error)) return
            n = size(layers%thickness)
            if (n > 1 .and. .not. model_table(i)%layers) then
                call refuse(model, " for "//count_text(n)//" layers", [(model_table(j)%layers, j=1, size(model_table))], &
                            error)
            else if (layers%rigid_base .and. model_table(i)%base == base_elastic) then
                call refuse(model, " on a rigid base (substrate E = infinity)", model_table%base /= base_elastic, error)
            else if (model_table(i)%base == base_rigid .and. .not. layers%rigid_base) then
                call raise(error, error_invalid, "substrate E = "//to_text(layers%materials(n + 1)%young)//": the model "// &
                           trim(word_of(model))//" needs a layer on a rigid base, substrate E = infinity")
            end if
        end if
    end subroutine check_model

    pure subroutine refuse(model, what, allowed, error)
        integer, intent(in) :: model
        character(len=*), intent(in) :: what
        !> which models are allowed (size(model_table))
        logical, intent(in) :: allowed(:)
        type(error_t), allocatable, intent(inout) :: error
        character(len=20*size(model_table)) :: names
        integer :: i

        names = ""
        do i = 1, size(model_table)
            if (allowed(i)) names = trim(names)//", "//trim(word_of(model_table(i)%code))
        end do
        call raise(error, error_invalid, "model = "//trim(model_text(model))//": it is not available"//what//". Use one of "// &
                   trim(names(3:)))
    end subroutine refuse

    pure function gao_options(model, options) result(chosen)
        integer, intent(in) :: model
        type(model_options_t), intent(in) :: options
        type(gao_options_t) :: chosen

        if (model == models%gao_power) chosen%exponent = options%exponent
        if (model == models%gao_series) chosen%exponent = -1.0_wp
        chosen%weight_nu_choice = int(options%weight_nu_choice)
        chosen%weight_nu = options%weight_nu
    end function gao_options

    subroutine new_graded_medium(medium, body, model, options, error)
        class(solver_t), allocatable, intent(out) :: medium
        class(body_t), intent(in) :: body
        integer, intent(in) :: model
        type(model_options_t), intent(in) :: options
        type(error_t), allocatable, intent(inout) :: error
        type(graded_t), allocatable :: graded

        allocate (graded)
        call new_graded(graded, body, error, gao_options(model, options))
        call move_alloc(graded, medium)
    end subroutine new_graded_medium

    subroutine new_layered_medium(medium, body, model, options, error)
        class(solver_t), allocatable, intent(out) :: medium
        class(body_t), intent(in) :: body
        integer, intent(in) :: model
        type(model_options_t), intent(in) :: options
        type(error_t), allocatable, intent(inout) :: error
        type(homogeneous_t) :: homogeneous
        type(gao_t), allocatable :: gao
        type(layers_t) :: layers
        integer :: n

        call body%sublayers(layers, error)
        if (allocated(error)) return
        n = size(layers%thickness)
        if (n == 0) then
            call new_homogeneous(homogeneous, layers%materials(1))
            allocate (medium, source=homogeneous)
        else if (any(model == [models%gao, models%gao_series, models%gao_power])) then
            allocate (gao)
            call new_gao_layered(gao, layers%materials(:n), layers%thickness, layers%materials(n + 1), error, &
                                 gao_options(model, options))
            call move_alloc(gao, medium)
        else
            call new_coated_medium(medium, layers%materials(1), layers%thickness(1), layers%materials(2), model, options, error)
        end if
    end subroutine new_layered_medium

    !> The models for a single coating.
    subroutine new_coated_medium(medium, coating, h, substrate, model, options, error)
        class(solver_t), allocatable, intent(out) :: medium
        type(material_t), intent(in) :: coating, substrate
        real(wp), intent(in) :: h
        integer, intent(in) :: model
        type(model_options_t), intent(in) :: options
        type(error_t), allocatable, intent(inout) :: error
        type(doerner_nix_t) :: doerner_nix
        type(wave_t) :: wave
        type(mencik_t) :: mencik
        type(bec_t) :: bec
        type(perriot_barthel_t) :: perriot_barthel
        type(hay_crawford_t) :: hay_crawford
        type(bottom_effect_t) :: bottom_effect

        select case (model)
        case (models%doerner_nix)
            call new_doerner_nix(doerner_nix, coating, h, substrate, error, options%alpha)
            allocate (medium, source=doerner_nix)
        case (models%wave)
            call new_wave(wave, coating, h, substrate, error, options%wave_factor)
            allocate (medium, source=wave)
        case (models%mencik_exponential, models%mencik_reciprocal)
            call new_mencik(mencik, coating, h, substrate, error, model == models%mencik_reciprocal, options%alpha)
            allocate (medium, source=mencik)
        case (models%bec)
            call new_bec(bec, coating, h, substrate, error)
            allocate (medium, source=bec)
        case (models%perriot_barthel)
            call new_perriot_barthel(perriot_barthel, coating, h, substrate, error)
            allocate (medium, source=perriot_barthel)
        case (models%hay_crawford)
            call new_hay_crawford(hay_crawford, coating, h, substrate, error)
            allocate (medium, source=hay_crawford)
        case default ! dimitriadis, garcia
            call new_bottom_effect(bottom_effect, coating, h, &
                                   merge(garcia_series, dimitriadis_series, model == models%garcia), error)
            allocate (medium, source=bottom_effect)
        end select
    end subroutine new_coated_medium

end module mdrcontact_model
