! SPDX-License-Identifier: GPL-3.0-or-later
!> The surface compliance of a body at one wavenumber, and the kernel of a body.
module body_response
    use, intrinsic :: ieee_arithmetic, only: ieee_quiet_nan, ieee_value
    use mdrcontact_body, only: body_t
    use mdrcontact_body_compliance, only: compliance_t, normal_load
    use mdrcontact_error, only: error_t
    use mdrcontact_kinds, only: wp
    use mdrcontact_line_kernel, only: kernel_t
    use mdrcontact_line_tabulate, only: attempts, elastic_misfit, tabulate_kernel
    use mdrcontact_line_waves, only: wave_table_t
    implicit none (type, external)
    private
    public :: response, kernel_of

contains

    !> sigma and chi under a load, default normal_load; NaN where the body has none.
    subroutine response(body, k, sigma, chi, load)
        class(body_t), intent(in) :: body
        complex(wp), intent(in) :: k
        complex(wp), intent(out) :: sigma, chi
        integer, intent(in), optional :: load
        class(compliance_t), allocatable :: compliance
        type(error_t), allocatable :: error
        complex(wp) :: sigmas(1), chis(1)
        integer :: chosen

        chosen = normal_load
        if (present(load)) chosen = load
        sigma = ieee_value(1.0_wp, ieee_quiet_nan)
        chi = sigma
        call body%compliance(chosen, compliance, error)
        if (allocated(error)) return
        call compliance%chi([k], sigmas, chis)
        sigma = sigmas(1)
        chi = chis(1)
    end subroutine response

    subroutine kernel_of(body, tables, kernel, error)
        class(body_t), intent(in) :: body
        type(wave_table_t), intent(inout) :: tables(attempts)
        type(kernel_t), intent(out) :: kernel
        type(error_t), allocatable, intent(out) :: error
        class(compliance_t), allocatable :: compliance

        call body%compliance(normal_load, compliance, error)
        if (.not. allocated(error)) call tabulate_kernel(kernel, compliance, tables, elastic_misfit, error)
    end subroutine kernel_of

end module body_response
