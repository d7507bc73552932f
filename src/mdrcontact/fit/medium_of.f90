! SPDX-License-Identifier: GPL-3.0-or-later
!> The medium that belongs to a vector of numbers.
module mdrcontact_fit_medium_of
    use mdrcontact_body_graded, only: graded_body_t, new_graded_body
    use mdrcontact_error, only: count_text, error_invalid, error_t, raise
    use mdrcontact_kinds, only: wp
    use mdrcontact_layered_exact, only: layered_exact_t, new_layered_exact
    use mdrcontact_layered_shared, only: layered_shared_t
    use mdrcontact_material, only: material_t, new_material
    use mdrcontact_medium, only: medium_t
    use mdrcontact_medium_bec, only: bec_t, new_bec
    use mdrcontact_medium_bottom_effect, only: bottom_effect_t, dimitriadis_series, garcia_series, new_bottom_effect
    use mdrcontact_medium_doerner_nix, only: doerner_nix_t, new_doerner_nix
    use mdrcontact_medium_gao, only: gao_options_t, gao_t, new_gao_layered
    use mdrcontact_medium_graded, only: graded_t, new_graded
    use mdrcontact_medium_hay_crawford, only: hay_crawford_t, new_hay_crawford
    use mdrcontact_medium_homogeneous, only: homogeneous_t, new_homogeneous
    use mdrcontact_medium_mencik, only: mencik_t, new_mencik
    use mdrcontact_medium_perriot_barthel, only: new_perriot_barthel, perriot_barthel_t
    use mdrcontact_medium_power_graded, only: new_power_graded, power_graded_t
    use mdrcontact_medium_wave, only: new_wave, wave_t
    implicit none (type, external)
    private
    public :: medium_choice_t, make_medium
    public :: medium_given, medium_homogeneous, medium_stack, medium_graded, medium_power_graded
    public :: model_gao, model_gao_series, model_doerner_nix, model_wave, model_mencik_exponential, model_mencik_reciprocal, &
              model_bec, model_perriot_barthel, model_hay_crawford, model_dimitriadis, model_garcia, model_exact

    !> Kinds of medium and their numbers: none; E, nu; E, nu, h of each layer from the surface down, then E, nu of the substrate
    !> (infinite E: rigid base) and the model's constant (alpha, or the wave factor); z, E, nu at each depth; E0, z0, exponent, nu.
    integer, parameter :: medium_given = 0, medium_homogeneous = 1, medium_stack = 2, medium_graded = 3, medium_power_graded = 4

    !> Models of a coating, with the codes of enum mdr_model.
    integer, parameter :: model_gao = 0, model_gao_series = 1, model_doerner_nix = 2, model_wave = 3, &
                          model_mencik_exponential = 4, model_mencik_reciprocal = 5, model_bec = 6, model_perriot_barthel = 7, &
                          model_hay_crawford = 8, model_dimitriadis = 9, model_garcia = 10, model_exact = 11

    !> Which medium the numbers belong to.
    type :: medium_choice_t
        !> one of medium_...
        integer :: kind = medium_given
        !> one of model_...; gao, gao_series and exact for more than one layer and for graded media
        integer :: model = model_gao
        !> layers of a stack, depths of a graded medium
        integer :: layers = 0
        !> the choices of Gao's weights; `in_series` follows from the model
        type(gao_options_t) :: gao
        !> relative tolerance of the exact medium
        real(wp) :: tolerance = 1.0e-10_wp
        !> the finished medium for medium_given
        class(medium_t), allocatable :: object
    end type medium_choice_t

contains

    !> The medium of a kind from its numbers.
    subroutine make_medium(choice, values, shared, medium, error)
        type(medium_choice_t), intent(in) :: choice
        real(wp), intent(in) :: values(:)
        !> what exact media have in common from one trial to the next
        type(layered_shared_t), intent(inout) :: shared
        class(medium_t), allocatable, intent(out) :: medium
        type(error_t), allocatable, intent(out) :: error
        type(material_t) :: material
        type(homogeneous_t) :: homogeneous
        type(power_graded_t) :: power_graded

        select case (choice%kind)
        case (medium_given)
            if (allocated(choice%object)) then
                allocate (medium, source=choice%object)
            else
                call raise(error, error_invalid, "the medium is missing: it must be given")
            end if
        case (medium_homogeneous)
            call new_material(material, values(1), values(2), error, "material")
            if (allocated(error)) return
            call new_homogeneous(homogeneous, material)
            allocate (medium, source=homogeneous)
        case (medium_stack)
            call make_stack(choice, values, shared, medium, error)
        case (medium_graded)
            call make_graded(choice, values, medium, error)
        case (medium_power_graded)
            call new_power_graded(power_graded, values(1), values(2), values(3), values(4), error)
            allocate (medium, source=power_graded)
        case default
            call raise(error, error_invalid, "medium = "//count_text(choice%kind)//" is not allowed: it must be a kind of "// &
                       "medium in enum mdr_fit_medium")
        end select
    end subroutine make_medium

    subroutine make_stack(choice, values, shared, medium, error)
        type(medium_choice_t), intent(in) :: choice
        real(wp), intent(in) :: values(:)
        type(layered_shared_t), intent(inout) :: shared
        class(medium_t), allocatable, intent(out) :: medium
        type(error_t), allocatable, intent(out) :: error
        type(material_t) :: layers(max(choice%layers, 1)), substrate
        type(gao_options_t) :: options
        type(gao_t) :: gao
        type(layered_exact_t) :: exact
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
        if (rigid) then
            if (.not. any(choice%model == [model_dimitriadis, model_garcia, model_exact])) then
                call raise(error, error_invalid, "a rigid base is not allowed with this model: use exact, dimitriadis or garcia")
            end if
        else
            call new_material(substrate, values(3*n + 1), values(3*n + 2), error, "substrate")
        end if
        if (allocated(error)) return
        select case (choice%model)
        case (model_gao, model_gao_series)
            options = choice%gao
            options%in_series = choice%model == model_gao_series
            call new_gao_layered(gao, layers, thickness, substrate, error, options)
            allocate (medium, source=gao)
        case (model_exact)
            call new_layered_exact(exact, layers, thickness, substrate, error, choice%tolerance, rigid, shared)
            allocate (medium, source=exact)
        case default
            if (n > 1) then
                call raise(error, error_invalid, "model = "//count_text(choice%model)//" is not allowed for "//count_text(n)// &
                           " layers: use gao, gao-series or exact")
                return
            end if
            call make_coated(choice%model, layers(1), thickness(1), substrate, rigid, values(3*n + 3), medium, error)
        end select
    end subroutine make_stack

    !> The models that know one coating only.
    subroutine make_coated(model, coating, thickness, substrate, rigid, constant, medium, error)
        integer, intent(in) :: model
        type(material_t), intent(in) :: coating, substrate
        real(wp), intent(in) :: thickness, constant
        logical, intent(in) :: rigid
        class(medium_t), allocatable, intent(out) :: medium
        type(error_t), allocatable, intent(out) :: error
        type(doerner_nix_t) :: doerner_nix
        type(wave_t) :: wave
        type(mencik_t) :: mencik
        type(bec_t) :: bec
        type(perriot_barthel_t) :: perriot_barthel
        type(hay_crawford_t) :: hay_crawford
        type(bottom_effect_t) :: bottom_effect

        select case (model)
        case (model_doerner_nix)
            call new_doerner_nix(doerner_nix, coating, thickness, substrate, error, constant)
            allocate (medium, source=doerner_nix)
        case (model_wave)
            call new_wave(wave, coating, thickness, substrate, error, constant)
            allocate (medium, source=wave)
        case (model_mencik_exponential, model_mencik_reciprocal)
            call new_mencik(mencik, coating, thickness, substrate, error, model == model_mencik_reciprocal, constant)
            allocate (medium, source=mencik)
        case (model_bec)
            call new_bec(bec, coating, thickness, substrate, error)
            allocate (medium, source=bec)
        case (model_perriot_barthel)
            call new_perriot_barthel(perriot_barthel, coating, thickness, substrate, error)
            allocate (medium, source=perriot_barthel)
        case (model_hay_crawford)
            call new_hay_crawford(hay_crawford, coating, thickness, substrate, error)
            allocate (medium, source=hay_crawford)
        case (model_dimitriadis, model_garcia)
            if (.not. rigid) then
                call raise(error, error_invalid, "this model is for a layer on a rigid base: the substrate's E must be infinite")
                return
            end if
            call new_bottom_effect(bottom_effect, coating, thickness, &
                                   merge(garcia_series, dimitriadis_series, model == model_garcia), error)
            allocate (medium, source=bottom_effect)
        case default
            call raise(error, error_invalid, "model = "//count_text(model)//" is not allowed: it must be one of enum mdr_model")
        end select
    end subroutine make_coated

    subroutine make_graded(choice, values, medium, error)
        type(medium_choice_t), intent(in) :: choice
        real(wp), intent(in) :: values(:)
        class(medium_t), allocatable, intent(out) :: medium
        type(error_t), allocatable, intent(out) :: error
        type(gao_options_t) :: options
        type(graded_body_t) :: body
        type(graded_t) :: graded

        if (choice%model /= model_gao .and. choice%model /= model_gao_series) then
            call raise(error, error_invalid, "model = "//count_text(choice%model)//" is not allowed for the fit of a graded "// &
                       "medium: use gao or gao-series")
            return
        end if
        options = choice%gao
        options%in_series = choice%model == model_gao_series
        call new_graded_body(body, values(1::3), values(2::3), values(3::3), error)
        if (.not. allocated(error)) call new_graded(graded, body, error, options)
        allocate (medium, source=graded)
    end subroutine make_graded

end module mdrcontact_fit_medium_of
