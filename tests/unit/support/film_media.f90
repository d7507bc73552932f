! SPDX-License-Identifier: GPL-3.0-or-later
!> A film on a substrate as a medium.
module film_media
    use mdrcontact, only: error_t, material_t, medium_t, model_options_t, new_medium, new_stack, stack_t, wp
    implicit none (type, external)
    private
    public :: new_film

contains

    !> Under a model; `constant` is alpha and wave_factor of those that have one.
    subroutine new_film(medium, model, film, thickness, base, constant)
        type(medium_t), intent(out) :: medium
        integer, intent(in) :: model
        !> E and nu; infinite E of the base: rigid
        real(wp), intent(in) :: film(2), thickness, base(2)
        real(wp), intent(in), optional :: constant
        type(model_options_t) :: options
        type(stack_t) :: stack
        type(error_t), allocatable :: error

        if (present(constant)) options%alpha = constant
        if (present(constant)) options%wave_factor = constant
        call new_stack(stack, [material_t(film(1), film(2))], [thickness], material_t(base(1), base(2)), error, &
                       base(1) > huge(1.0_wp))
        if (.not. allocated(error)) call new_medium(medium, stack, model, error, options)
        if (allocated(error)) error stop "a film of the tests is refused"
    end subroutine new_film

end module film_media
