! SPDX-License-Identifier: GPL-3.0-or-later
!> The medium that belongs to a vector of parameters.
module mdrcontact_fit_medium_of
    use mdrcontact_base_parameter, only: parameter_t
    use mdrcontact_body, only: body_t
    use mdrcontact_body_graded, only: graded_body_t, new_graded_body
    use mdrcontact_body_stack, only: new_stack, stack_t
    use mdrcontact_error, only: count_text, error_invalid, error_t, raise
    use mdrcontact_kinds, only: wp
    use mdrcontact_layered_shared, only: layered_shared_t
    use mdrcontact_material, only: material_t, new_material
    use mdrcontact_medium, only: medium_t, new_medium
    use mdrcontact_medium_homogeneous, only: homogeneous_t, new_homogeneous
    use mdrcontact_medium_power_graded, only: new_power_graded, power_graded_t
    use mdrcontact_medium_viscoelastic, only: viscoelastic_t
    use mdrcontact_model, only: model_options_t, model_position, model_table, models, option_names, option_values, with_constant
    use mdrcontact_tension_surface, only: is_bare, surface_t
    implicit none (type, external)
    private
    public :: medium_choice_t, is_half_space, make_medium, medium_count, set_pattern, surface_count
    public :: modulus_parameter
    public :: medium_none, medium_given, medium_homogeneous, medium_stack, medium_graded, medium_power_graded, &
              medium_pattern

    !> Kinds of medium and their parameters: none; E, nu; E, nu, h of each layer from the surface down, then E, nu of the
    !> substrate (infinite E: rigid base) and the model's constant (its option that is a number); z, E, nu at each depth;
    !> E0, z0, exponent, nu; those of a pattern: of the body of an elastic medium (body%parameters), then the model's constant if it
    !> has one, then tension and bending of the surface unless it is bare; or of a viscoelastic body. A counterbody may be missing.
    integer, parameter :: medium_none = -1, medium_given = 0, medium_homogeneous = 1, medium_stack = 2, medium_graded = 3, &
                          medium_power_graded = 4, medium_pattern = 5

    !> Which medium the parameters belong to.
    type :: medium_choice_t
        !> one of medium_...
        integer :: kind = medium_given
        !> one of models%...
        integer :: model = models%exact
        !> layers of a stack, depths of a graded medium
        integer :: layers = 0
        !> what the model leaves to choose; the constant of a stack's model is among the parameters instead
        type(model_options_t) :: options = model_options_t()
        !> whether the surface of a half-space or of layers has tension and bending: its last two parameters
        logical :: has_surface = .false.
        !> the finished medium for medium_given
        type(medium_t), allocatable :: object
        !> for medium_pattern, see set_pattern: the elastic body that trials are like
        class(body_t), allocatable :: body
        !> or the one that relaxes
        type(viscoelastic_t), allocatable :: relaxing
        !> its numbers
        type(parameter_t), allocatable :: parameters(:)
    end type medium_choice_t

contains

    !> Whether it is a half-space of E and nu.
    pure function is_half_space(choice) result(answer)
        type(medium_choice_t), intent(in) :: choice
        logical :: answer

        answer = choice%kind == medium_homogeneous
        if (choice%kind /= medium_pattern .or. .not. allocated(choice%parameters)) return
        if (size(choice%parameters) == 2) answer = choice%parameters(1)%name == "E"
    end function is_half_space

    !> How many parameters a medium has; -1 for a kind that does not exist.
    elemental function medium_count(choice) result(count)
        type(medium_choice_t), intent(in) :: choice
        integer :: count

        select case (choice%kind)
        case (medium_none, medium_given); count = 0
        case (medium_homogeneous); count = 2 + surface_count(choice)
        case (medium_stack); count = 3*max(choice%layers, 1) + 3 + surface_count(choice)
        case (medium_graded); count = 3*max(choice%layers, 2)
        case (medium_power_graded); count = 4
        case (medium_pattern)
            count = -1
            if (allocated(choice%parameters)) count = size(choice%parameters)
        case default; count = -1
        end select
    end function medium_count

    !> How many parameters its surface has.
    pure function surface_count(choice) result(count)
        type(medium_choice_t), intent(in) :: choice
        integer :: count

        count = 0
        if (choice%has_surface .and. any(choice%kind == [medium_homogeneous, medium_stack, medium_pattern])) count = 2
    end function surface_count

    !> Tension and plate among the parameters of a medium.
    pure function surface_of(choice, values) result(surface)
        type(medium_choice_t), intent(in) :: choice
        real(wp), intent(in) :: values(:)
        type(surface_t) :: surface

        if (surface_count(choice) > 0) surface = surface_t(values(size(values) - 1), values(size(values)))
    end function surface_of

    !> The medium of a kind from its parameters.
    subroutine make_medium(choice, values, shared, medium, error)
        type(medium_choice_t), intent(in) :: choice
        real(wp), intent(in) :: values(:)
        !> what exact media have in common from one trial to the next
        type(layered_shared_t), intent(inout) :: shared
        type(medium_t), intent(out) :: medium
        type(error_t), allocatable, intent(out) :: error
        type(material_t) :: material
        type(homogeneous_t) :: homogeneous
        type(graded_body_t) :: graded
        type(power_graded_t) :: power_graded
        type(stack_t) :: bare

        select case (choice%kind)
        case (medium_given)
            if (allocated(choice%object)) then
                call choice%object%copy_to(medium, error)
            else
                call raise(error, error_invalid, "the medium is missing: it must be given")
            end if
        case (medium_homogeneous)
            call new_material(material, values(1), values(2), error, "material")
            if (allocated(error)) return
            if (choice%has_surface) then
                call new_stack(bare, [material_t ::], [real(wp) ::], material, error)
                if (allocated(error)) return
                call new_medium(medium, bare, models%exact, error, shared=shared, surface=surface_of(choice, values))
                return
            end if
            call new_homogeneous(homogeneous, material)
            allocate (medium%solver, source=homogeneous)
        case (medium_stack)
            call make_stack(choice, values, shared, medium, error)
        case (medium_graded)
            call new_graded_body(graded, values(1::3), values(2::3), values(3::3), error)
            if (.not. allocated(error)) call new_medium(medium, graded, choice%model, error, choice%options, shared)
        case (medium_power_graded)
            call new_power_graded(power_graded, values(1), values(2), values(3), values(4), error)
            allocate (medium%solver, source=power_graded)
        case (medium_pattern)
            call make_alike(choice, values, shared, medium, error)
        case default
            call raise(error, error_invalid, "medium = "//count_text(choice%kind)//" is not allowed: it must be a kind of "// &
                       "medium in enum mdr_fit_medium")
        end select
    end subroutine make_medium

    !> Trials are media like this one, of bodies with other numbers under the model of the choice.
    subroutine set_pattern(choice, medium, error)
        type(medium_choice_t), intent(inout) :: choice
        !> of one body
        type(medium_t), intent(in) :: medium
        type(error_t), allocatable, intent(inout) :: error
        type(parameter_t), allocatable :: list(:)
        real(wp) :: constant
        integer :: i

        if (allocated(error)) return
        if (allocated(medium%relaxing)) then
            choice%relaxing = medium%relaxing
            call choice%relaxing%parameters(choice%parameters)
            return
        end if
        if (.not. allocated(medium%solver%pressed) .or. medium%solver%is_pair) then
            call raise(error, error_invalid, "the medium is not allowed as a pattern: it must be a half-space, layers or a "// &
                       "graded body, and no pair")
            return
        end if
        call medium%solver%pressed%copy_to(choice%body, error)
        if (allocated(error)) return
        call choice%body%parameters(list)
        i = model_position(choice%model)
        if (i > 0) then
            if (model_table(i)%constant /= "") then
                constant = sum(option_values(choice%options), mask=option_names == model_table(i)%constant)
                list = [list, parameter_t(model_table(i)%constant, constant)]
            end if
        end if
        associate (sheet => medium%solver%sheet)
            choice%has_surface = .not. is_bare(sheet)
            if (choice%has_surface) list = [list, parameter_t("surface.tension", sheet%tension), &
                                            parameter_t("surface.bending", sheet%bending)]
        end associate
        call move_alloc(list, choice%parameters)
    end subroutine set_pattern

    subroutine make_alike(choice, values, shared, medium, error)
        type(medium_choice_t), intent(in) :: choice
        real(wp), intent(in) :: values(:)
        type(layered_shared_t), intent(inout) :: shared
        type(medium_t), intent(out) :: medium
        type(error_t), allocatable, intent(out) :: error
        class(body_t), allocatable :: body
        real(wp) :: constant
        integer :: last

        if (allocated(choice%relaxing)) then
            allocate (medium%relaxing)
            call choice%relaxing%with_parameters(values, medium%relaxing, error, shared)
            return
        end if
        call choice%body%with_parameters(values, body, error)
        if (allocated(error)) return
        constant = 0.0_wp
        last = size(values) - surface_count(choice)
        if (last > 0) constant = values(last)
        call new_medium(medium, body, choice%model, error, with_constant(choice%options, choice%model, constant), shared, &
                        surface_of(choice, values))
    end subroutine make_alike

    !> The one parameter to which all forces are proportional: the modulus of a power law that stands alone or on a rigid base; 0:
    !> there is none.
    pure function modulus_parameter(choice) result(position)
        type(medium_choice_t), intent(in) :: choice
        integer :: position

        position = 0
        if (.not. allocated(choice%relaxing)) return
        associate (materials => choice%relaxing%materials)
            if (size(materials) > 1) return
            if (materials(1)%is_power_law()) position = 1
        end associate
    end function modulus_parameter

    subroutine make_stack(choice, values, shared, medium, error)
        type(medium_choice_t), intent(in) :: choice
        real(wp), intent(in) :: values(:)
        type(layered_shared_t), intent(inout) :: shared
        type(medium_t), intent(out) :: medium
        type(error_t), allocatable, intent(out) :: error
        type(material_t) :: layers(max(choice%layers, 1)), substrate
        type(stack_t) :: body
        real(wp) :: thickness(max(choice%layers, 1))
        logical :: rigid
        integer :: i, n

        n = size(layers)
        do i = 1, n
            call new_material(layers(i), values(3*i - 2), values(3*i - 1), error, "layer "//count_text(i))
            if (allocated(error)) return
            thickness(i) = values(3*i)
        end do
        rigid = values(3*n + 1) > huge(1.0_wp)
        if (.not. rigid) call new_material(substrate, values(3*n + 1), values(3*n + 2), error, "substrate")
        if (.not. allocated(error)) call new_stack(body, layers, thickness, substrate, error, rigid)
        if (.not. allocated(error)) then
            call new_medium(medium, body, choice%model, error, &
                            with_constant(choice%options, choice%model, values(3*n + 3)), shared, surface_of(choice, values))
        end if
    end subroutine make_stack

end module mdrcontact_fit_medium_of
