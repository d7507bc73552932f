! SPDX-License-Identifier: GPL-3.0-or-later
!> Graded media by Gao's weights from a table of constants, body and medium in one call.
module graded_media
    use mdrcontact_body_graded, only: graded_body_t, new_graded_body
    use mdrcontact_error, only: error_t
    use mdrcontact_kinds, only: wp
    use mdrcontact_medium_gao, only: gao_options_t
    use mdrcontact_medium_graded, only: graded_t, new_graded
    implicit none (type, external)
    private
    public :: new_graded_table

contains

    !> The arguments of new_graded_body and new_graded.
    subroutine new_graded_table(medium, z, young, poisson, error, options)
        type(graded_t), intent(out) :: medium
        real(wp), intent(in) :: z(:), young(:), poisson(:)
        type(error_t), allocatable, intent(out) :: error
        type(gao_options_t), intent(in), optional :: options
        type(graded_body_t) :: body

        call new_graded_body(body, z, young, poisson, error)
        if (.not. allocated(error)) call new_graded(medium, body, error, options)
    end subroutine new_graded_table

end module graded_media
