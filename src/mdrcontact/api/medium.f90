! SPDX-License-Identifier: GPL-3.0-or-later
!> Media of one body or of two, and the modulus and stiffness of any medium, for C.
module mdrcontact_api_medium
    use, intrinsic :: iso_c_binding, only: c_double, c_int, c_ptr
    use mdrcontact_api_any_body, only: any_body_t
    use mdrcontact_api_arrays, only: check_each_positive, check_each_within, check_positive_results, make_room
    use mdrcontact_api_handles, only: hand_over, hand_over_solver
    use mdrcontact_api_medium_options, only: read_medium_options
    use mdrcontact_api_open_handle, only: open_handle
    use mdrcontact_api_status, only: status_of, wanted_threads
    use mdrcontact_body_compliance, only: shear_load, twist_load
    use mdrcontact_codes, only: of_modulus => modulus, of_stiffness => stiffness, of_tangential_modulus => tangential_modulus, &
                                of_torsional_stiffness => torsional_stiffness, word_of
    use mdrcontact_error, only: check_code, check_memory, error_invalid, error_t, raise
    use mdrcontact_medium, only: check_elastic, medium_t, new_medium, new_pair
    use mdrcontact_medium_solver, only: new_under, solver_t
    use mdrcontact_medium_homogeneous, only: homogeneous_t, new_homogeneous_from_modulus
    use mdrcontact_medium_values, only: modulus_values
    use mdrcontact_medium_viscoelastic, only: new_viscoelastic_medium
    use mdrcontact_model, only: model_options_t, model_text, models
    implicit none (type, external)
    private
    public :: mdr_medium_new, mdr_medium_pair
    public :: mdr_medium_contact_modulus, mdr_medium_values

contains

    function mdr_medium_contact_modulus(contact_modulus, out) result(status) bind(C, name="mdrcontact_entry_medium_contact_modulus")
        real(c_double), value :: contact_modulus
        type(c_ptr), intent(inout), optional :: out
        integer(c_int) :: status
        type(homogeneous_t), allocatable :: half_space
        class(solver_t), allocatable :: solver
        type(error_t), allocatable :: error

        allocate (half_space)
        call new_homogeneous_from_modulus(half_space, contact_modulus, error)
        call move_alloc(half_space, solver)
        status = hand_over_solver(solver, out, error)
    end function mdr_medium_contact_modulus

    function mdr_medium_new(body, options, out) result(status) bind(C, name="mdrcontact_entry_medium_new")
        type(c_ptr), value :: body, options
        type(c_ptr), intent(inout), optional :: out
        integer(c_int) :: status
        type(any_body_t), pointer :: given
        type(model_options_t) :: chosen
        type(medium_t), allocatable :: medium
        class(*), allocatable :: object
        type(error_t), allocatable :: error
        integer :: model

        allocate (medium)
        call open_handle(body, "body", given, error)
        call read_medium_options(error, options, model, chosen)
        if (.not. allocated(error)) then
            if (allocated(given%solved)) then
                call take_solved(given%solved, model, medium, error)
            else if (allocated(given%relaxing)) then
                allocate (medium%relaxing)
                associate (relaxing => given%relaxing)
                    call new_viscoelastic_medium(medium%relaxing, relaxing%materials, relaxing%thickness, relaxing%rigid_base, &
                                                 model, chosen, error, bonds=relaxing%bonds)
                end associate
            else
                call new_medium(medium, given%elastic, model, error, chosen, surface=given%surface)
            end if
        end if
        call move_alloc(medium, object)
        status = hand_over(object, out, error)
    end function mdr_medium_new

    !> The medium of a body that has one solution.
    subroutine take_solved(solved, model, medium, error)
        class(solver_t), intent(in) :: solved
        integer, intent(in) :: model
        type(medium_t), intent(inout) :: medium
        type(error_t), allocatable, intent(inout) :: error
        integer :: stat

        if (model /= models%exact) then
            call raise(error, error_invalid, "model = "//trim(model_text(model))//" is not allowed for a rigid body, or one "// &
                       "of a power of the depth: choose from "//trim(word_of(models%exact)))
            return
        end if
        allocate (medium%solver, source=solved, stat=stat)
        call check_memory(error, stat)
    end subroutine take_solved

    function mdr_medium_pair(lower, upper, out) result(status) bind(C, name="mdrcontact_entry_medium_pair")
        type(c_ptr), value :: lower, upper
        type(c_ptr), intent(inout), optional :: out
        integer(c_int) :: status
        type(medium_t), pointer :: first, second
        type(medium_t), allocatable :: medium
        class(*), allocatable :: object
        type(error_t), allocatable :: error

        allocate (medium)
        call open_handle(lower, "lower", first, error)
        call open_handle(upper, "upper", second, error)
        if (.not. allocated(error)) call new_pair(medium, first, second, error)
        call move_alloc(medium, object)
        status = hand_over(object, out, error)
    end function mdr_medium_pair

    !> A quantity of a deformable medium at radii > 0; nothing is written before all of it is known.
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
            if (medium%is_rigid) call raise(error, error_invalid, " is not allowed: it is rigid; pair it with a deformable "// &
                                              "body", "m")
        end if
        if (.not. allocated(error) .and. quantity == of_tangential_modulus) then
            call new_under(medium, shear_load, other, error)
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
                call new_under(medium, twist_load, other, error)
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
