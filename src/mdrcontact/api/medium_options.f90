! SPDX-License-Identifier: GPL-3.0-or-later
!> The optional settings of a medium, `mdr_medium_options`, and the model codes, for C.
module mdrcontact_api_medium_options
    use, intrinsic :: iso_c_binding, only: c_double, c_int
    use mdrcontact_error, only: count_text, error_invalid, error_t, raise
    use mdrcontact_kinds, only: half_pi
    use mdrcontact_medium_gao, only: gao_options_t
    implicit none (type, external)
    private
    public :: medium_options_t, options_or_defaults, gao_options, raise_model, mdr_medium_options_init
    public :: model_gao, model_gao_series, model_doerner_nix, model_wave, model_mencik_exponential, model_mencik_reciprocal, &
              model_bec, model_perriot_barthel, model_hay_crawford, model_dimitriadis, model_garcia, model_exact

    !> enum mdr_model
    integer(c_int), parameter :: model_gao = 0_c_int, model_gao_series = 1_c_int, model_doerner_nix = 2_c_int, &
                                 model_wave = 3_c_int, model_mencik_exponential = 4_c_int, model_mencik_reciprocal = 5_c_int, &
                                 model_bec = 6_c_int, model_perriot_barthel = 7_c_int, model_hay_crawford = 8_c_int, &
                                 model_dimitriadis = 9_c_int, model_garcia = 10_c_int, model_exact = 11_c_int

    !> struct mdr_medium_options; the order of the components is that of the header.
    type, bind(C) :: medium_options_t
        real(c_double) :: alpha = 1.0_c_double
        real(c_double) :: wave_factor = half_pi
        integer(c_int) :: weight_nu_choice = 0_c_int
        real(c_double) :: weight_nu = 0.5_c_double
        real(c_double) :: tolerance = 1.0e-10_c_double
    end type medium_options_t

contains

    subroutine mdr_medium_options_init(options) bind(C)
        type(medium_options_t), intent(inout), optional :: options

        if (present(options)) options = medium_options_t()
    end subroutine mdr_medium_options_init

    !> What the caller gave, or the defaults for a null pointer.
    pure function options_or_defaults(options) result(chosen)
        type(medium_options_t), intent(in), optional :: options
        type(medium_options_t) :: chosen

        chosen = medium_options_t()
        if (present(options)) chosen = options
    end function options_or_defaults

    !> The part that concerns Gao's weights.
    pure function gao_options(model, options) result(chosen)
        integer(c_int), intent(in) :: model
        type(medium_options_t), intent(in), optional :: options
        type(gao_options_t) :: chosen
        type(medium_options_t) :: given

        given = options_or_defaults(options)
        chosen%in_series = model == model_gao_series
        chosen%weight_nu_choice = int(given%weight_nu_choice)
        chosen%weight_nu = given%weight_nu
    end function gao_options

    !> The error of a model code that does not go with the kind of medium.
    pure subroutine raise_model(error, model, allowed)
        type(error_t), allocatable, intent(inout) :: error
        integer(c_int), intent(in) :: model
        character(len=*), intent(in) :: allowed

        call raise(error, error_invalid, "model = "//count_text(int(model))//" is not allowed: it must be "//allowed)
    end subroutine raise_model

end module mdrcontact_api_medium_options
