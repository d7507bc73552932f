! SPDX-License-Identifier: GPL-3.0-or-later
!> Media of one body, and the modulus and stiffness of any medium, for C.
module mdrcontact_api_medium
    use, intrinsic :: iso_c_binding, only: c_double, c_int, c_ptr
    use mdrcontact_api_any_body, only: any_body_t
    use mdrcontact_api_arrays, only: check_each_positive, check_each_within, check_positive_results, make_room
    use mdrcontact_api_open_handle, only: open_handle
    use mdrcontact_api_status, only: status_of, wanted_threads
    use mdrcontact_body_compliance, only: shear_load, twist_load
    use mdrcontact_codes, only: of_modulus => modulus, of_stiffness => stiffness, of_tangential_modulus => tangential_modulus, &
                                of_torsional_stiffness => torsional_stiffness, word_of
    use mdrcontact_error, only: check_code, check_memory, error_invalid, error_t, raise
    use mdrcontact_medium, only: check_elastic, medium_t, new_medium
    use mdrcontact_medium_solver, only: solver_t
    use mdrcontact_medium_values, only: modulus_values
    use mdrcontact_medium_viscoelastic, only: new_viscoelastic_medium
    use mdrcontact_model, only: model_options_t, model_text, models
    implicit none (type, external)
    private
    public :: mdr_medium_values, new_medium_of

contains

    !> The medium of a body under a model.
    subroutine new_medium_of(medium, body, model, options, error)
        type(medium_t), intent(out) :: medium
        type(any_body_t), intent(in) :: body
        integer, intent(in) :: model
        type(model_options_t), intent(in) :: options
        type(error_t), allocatable, intent(inout) :: error

        if (allocated(body%solved)) then
            call take_solved(body%solved, model, medium, error)
        else if (allocated(body%relaxing)) then
            allocate (medium%relaxing)
            associate (relaxing => body%relaxing)
                call new_viscoelastic_medium(medium%relaxing, relaxing%materials, relaxing%thickness, relaxing%rigid_base, model, &
                                             options, error, bonds=relaxing%bonds)
            end associate
        else
            call new_medium(medium, body%elastic, model, error, options, surface=body%surface)
        end if
    end subroutine new_medium_of

    !> The medium of a body that has one solution.
    subroutine take_solved(solved, model, medium, error)
        class(solver_t), intent(in) :: solved
        integer, intent(in) :: model
        type(medium_t), intent(inout) :: medium
        type(error_t), allocatable, intent(inout) :: error
        integer :: stat

        if (model /= models%exact) then
            call raise(error, error_invalid, "model = "//trim(model_text(model))//": it is not available for rigid and "// &
                       "power-law graded bodies. Use "//trim(word_of(models%exact)))
            return
        end if
        allocate (medium%solver, source=solved, stat=stat)
        call check_memory(error, stat)
    end subroutine take_solved

    !> A quantity of a deformable medium at radii > 0; nothing is written before the whole result is known.
    function mdr_medium_values(m, quantity, n, a, out) result(status) bind(C, name="mdrcontact_entry_medium_values")
        type(c_ptr), value :: m
        integer(c_int), value :: quantity, n
        real(c_double), intent(in), optional :: a(*)
        real(c_double), intent(inout), optional :: out(*)
        integer(c_int) :: status
        type(medium_t), pointer :: whole
        class(solver_t), pointer :: medium
        class(solver_t), allocatable, target :: other
        real(c_double), allocatable :: values(:)
        type(error_t), allocatable :: error
        integer :: i

        call open_handle(m, "m", whole, error)
        call check_code(error, "quantity", int(quantity), [of_modulus, of_stiffness, of_tangential_modulus, of_torsional_stiffness])
        if (.not. allocated(error)) call check_elastic(whole, error)
        if (.not. allocated(error)) then
            medium => whole%solver
            if (medium%is_rigid) call raise(error, error_invalid, ": it is rigid. Pair it with a deformable body", "m")
        end if
        if (.not. allocated(error) .and. quantity == of_tangential_modulus) then
            call medium%for_load(shear_load, other, error)
            medium => other
        end if
        if (.not. allocated(error) .and. n > 0) then
            call check_each_positive(error, "a", a(:n))
            call check_each_within(error, "a", a(:n), medium%smallest_radius, medium%largest_radius, "the medium", &
                                   trim(medium%why_it_ends))
        end if
        call make_room(error, n, values)
        if (.not. allocated(error) .and. n > 0) then
            if (quantity == of_torsional_stiffness) then
                call medium%for_load(twist_load, other, error)
                if (.not. allocated(error)) call other%springs%torsional_stiffness(a(:n), values, error)
            else
                call modulus_values(medium, a(:n), values, wanted_threads(), error)
            end if
            if (quantity == of_stiffness .and. .not. allocated(error)) then
                do i = 1, n
                    values(i) = 2.0_c_double*a(i)*values(i)
                end do
            end if
            if (.not. allocated(error)) call check_positive_results(error, values)
            if (.not. allocated(error)) out(:n) = values
        end if
        status = status_of(error)
    end function mdr_medium_values

end module mdrcontact_api_medium
