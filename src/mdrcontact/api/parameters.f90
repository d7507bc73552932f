! SPDX-License-Identifier: GPL-3.0-or-later
!> The numbers of indenters, materials, bodies and media by name, for C.
module mdrcontact_api_parameters
    use, intrinsic :: iso_c_binding, only: c_int, c_loc, c_ptr
    use mdrcontact_api_any_body, only: any_body_t
    use mdrcontact_api_handles, only: look_inside, refuse_kind
    use mdrcontact_api_records, only: c_parameter_t
    use mdrcontact_api_status, only: status_of
    use mdrcontact_api_text, only: write_text
    use mdrcontact_parameter, only: parameter_t
    use mdrcontact_error, only: error_t
    use mdrcontact_material_rheology, only: rheology_t
    use mdrcontact_medium, only: medium_t
    use mdrcontact_medium_power_graded, only: power_law_parameters
    use mdrcontact_profile, only: profile_t
    implicit none (type, external)
    private
    public :: mdr_parameters

    character(len=*), parameter :: kinds = "mdr_profile, mdr_material, mdr_body or mdr_medium"

contains

    function mdr_parameters(object, capacity, out, count) result(status) bind(C, name="mdrcontact_entry_parameters")
        type(c_ptr), value :: object
        integer(c_int), value :: capacity
        type(c_parameter_t), intent(inout), optional, target :: out(*)
        integer(c_int), intent(inout), optional :: count
        integer(c_int) :: status
        class(*), pointer :: inside
        type(parameter_t), allocatable :: list(:)
        type(error_t), allocatable :: error
        integer :: i

        allocate (list(0))
        call look_inside(object, "object", kinds, inside, error)
        if (.not. allocated(error)) call list_parameters(inside, list, error)
        status = status_of(error)
        if (allocated(error)) return
        do i = 1, min(int(capacity), size(list))
            out(i)%value = list(i)%value
            call write_text(trim(list(i)%name), size(out(i)%name), c_loc(out(i)%name))
        end do
        count = size(list, kind=c_int)
    end function mdr_parameters

    !> Leaves an empty list where there are none.
    subroutine list_parameters(object, list, error)
        class(*), intent(in) :: object
        type(parameter_t), allocatable, intent(inout) :: list(:)
        type(error_t), allocatable, intent(inout) :: error

        select type (object)
        class is (profile_t)
            call object%parameters(list)
        type is (rheology_t)
            call object%parameters(list)
        type is (medium_t)
            call object%parameters(list)
        type is (any_body_t)
            if (allocated(object%elastic)) call object%elastic%parameters(list)
            if (allocated(object%relaxing)) call object%relaxing%parameters(list)
            if (allocated(object%solved)) then
                if (allocated(object%solved%power_law)) list = power_law_parameters(object%solved%power_law)
            end if
        class default
            call refuse_kind("object", kinds, error)
        end select
    end subroutine list_parameters

end module mdrcontact_api_parameters
