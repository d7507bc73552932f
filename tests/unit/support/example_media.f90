! SPDX-License-Identifier: GPL-3.0-or-later
!> One coated medium of every effective-modulus model, for tests that must hold for all of them.
module example_media
    use mdrcontact, only: bec_t, doerner_nix_t, error_t, gao_nu_effective, gao_nu_given, gao_nu_substrate, gao_options_t, gao_t, &
                          hay_crawford_t, material_t, solver_t, mencik_t, new_bec, new_doerner_nix, new_gao, new_hay_crawford, &
                          new_material, new_mencik, new_perriot_barthel, new_wave, perriot_barthel_t, wave_t, wp
    implicit none (type, external)
    private
    public :: example_medium_t, make_example_media, model_count

    integer, parameter :: model_count = 14

    type :: example_medium_t
        character(len=32) :: name = ""
        class(solver_t), allocatable :: medium
    end type example_medium_t

contains

    !> Every model of a coating of thickness h = 1.
    subroutine make_example_media(coating_young, coating_poisson, substrate_young, substrate_poisson, examples)
        real(wp), intent(in) :: coating_young, coating_poisson, substrate_young, substrate_poisson
        type(example_medium_t), intent(out) :: examples(model_count)
        type(material_t) :: coating, substrate
        type(error_t), allocatable :: error

        call new_material(coating, coating_young, coating_poisson, error)
        call require_success(error)
        call new_material(substrate, substrate_young, substrate_poisson, error)
        call require_success(error)
        call add_gao(examples(1:5), coating, substrate)
        call add_interpolations(examples(6:11), coating, substrate)
        call add_film_formulas(examples(12:14), coating, substrate)
    end subroutine make_example_media

    subroutine add_gao(examples, coating, substrate)
        type(example_medium_t), intent(inout) :: examples(5)
        type(material_t), intent(in) :: coating, substrate
        type(gao_options_t) :: options(5)
        character(len=*), parameter :: names(5) = [character(len=32) :: "gao", "gao-series", "gao, nu of the substrate", &
                                                   "gao, effective nu", "gao, nu given"]
        type(gao_t) :: gao
        type(error_t), allocatable :: error
        integer :: i

        options(2)%exponent = -1.0_wp
        options(3)%weight_nu_choice = gao_nu_substrate
        options(4)%weight_nu_choice = gao_nu_effective
        options(5) = gao_options_t(exponent=-1.0_wp, weight_nu_choice=gao_nu_given, weight_nu=-0.3_wp)
        do i = 1, 5
            call new_gao(gao, coating, 1.0_wp, substrate, error, options(i))
            call put(examples(i), names(i), gao, error)
        end do
    end subroutine add_gao

    subroutine add_interpolations(examples, coating, substrate)
        type(example_medium_t), intent(inout) :: examples(6)
        type(material_t), intent(in) :: coating, substrate
        type(doerner_nix_t) :: doerner_nix
        type(wave_t) :: wave
        type(mencik_t) :: mencik
        type(error_t), allocatable :: error

        call new_doerner_nix(doerner_nix, coating, 1.0_wp, substrate, error)
        call put(examples(1), "doerner-nix", doerner_nix, error)
        call new_doerner_nix(doerner_nix, coating, 1.0_wp, substrate, error, alpha=0.7_wp)
        call put(examples(2), "doerner-nix, alpha 0.7", doerner_nix, error)
        call new_wave(wave, coating, 1.0_wp, substrate, error)
        call put(examples(3), "wave", wave, error)
        call new_wave(wave, coating, 1.0_wp, substrate, error, wave_factor=2.0_wp)
        call put(examples(4), "wave, factor 2", wave, error)
        call new_mencik(mencik, coating, 1.0_wp, substrate, error)
        call put(examples(5), "mencik-exponential", mencik, error)
        call new_mencik(mencik, coating, 1.0_wp, substrate, error, reciprocal=.true., alpha=0.7_wp)
        call put(examples(6), "mencik-reciprocal, alpha 0.7", mencik, error)
    end subroutine add_interpolations

    subroutine add_film_formulas(examples, coating, substrate)
        type(example_medium_t), intent(inout) :: examples(3)
        type(material_t), intent(in) :: coating, substrate
        type(bec_t) :: bec
        type(perriot_barthel_t) :: perriot_barthel
        type(hay_crawford_t) :: hay_crawford
        type(error_t), allocatable :: error

        call new_bec(bec, coating, 1.0_wp, substrate, error)
        call put(examples(1), "bec", bec, error)
        call new_perriot_barthel(perriot_barthel, coating, 1.0_wp, substrate, error)
        call put(examples(2), "perriot-barthel", perriot_barthel, error)
        call new_hay_crawford(hay_crawford, coating, 1.0_wp, substrate, error)
        call put(examples(3), "hay-crawford", hay_crawford, error)
    end subroutine add_film_formulas

    subroutine put(example, name, medium, error)
        type(example_medium_t), intent(inout) :: example
        character(len=*), intent(in) :: name
        class(solver_t), intent(in) :: medium
        type(error_t), allocatable, intent(in) :: error

        call require_success(error)
        example%name = name
        if (allocated(example%medium)) deallocate (example%medium)
        allocate (example%medium, source=medium)
    end subroutine put

    subroutine require_success(error)
        type(error_t), allocatable, intent(in) :: error

        if (allocated(error)) error stop "an example medium could not be made"
    end subroutine require_success

end module example_media
