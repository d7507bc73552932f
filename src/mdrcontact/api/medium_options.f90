! SPDX-License-Identifier: GPL-3.0-or-later
!> The optional settings of a medium, `mdr_medium_options`, and the names of the models, for C.
module mdrcontact_api_medium_options
    use, intrinsic :: iso_c_binding, only: c_char, c_int, c_null_char
    use mdrcontact_api_status, only: check_given, status_of
    use mdrcontact_error, only: count_text, error_invalid, error_t, raise
    use mdrcontact_model, only: find_model, medium_options_t => model_options_t, model_position, model_table
    implicit none (type, external)
    private
    public :: medium_options_t, options_or_defaults
    public :: mdr_medium_options_init, mdr_model_name, mdr_model_from_name

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

    function mdr_model_name(model, length, name) result(status) bind(C)
        integer(c_int), value :: model, length
        character(kind=c_char), intent(inout), optional :: name(*)
        integer(c_int) :: status
        type(error_t), allocatable :: error
        integer :: i, position

        position = model_position(int(model))
        call check_given(error, "name", present(name))
        if (position == 0) then
            call raise(error, error_invalid, "model = "//count_text(int(model))//" is not allowed: "// &
                       "it must be one of enum mdr_model")
        end if
        if (length < len(model_table%name) + 1) then
            call raise(error, error_invalid, "length = "//count_text(int(length))//" is not allowed: it must be at least "// &
                       count_text(len(model_table%name) + 1))
        end if
        if (.not. allocated(error)) then
            do i = 1, len_trim(model_table(position)%name)
                name(i) = model_table(position)%name(i:i)
            end do
            name(i) = c_null_char
        end if
        status = status_of(error)
    end function mdr_model_name

    function mdr_model_from_name(name, model) result(status) bind(C)
        character(kind=c_char), intent(in), optional :: name(*)
        integer(c_int), intent(inout), optional :: model
        integer(c_int) :: status
        type(error_t), allocatable :: error
        character(len=len(model_table%name) + 1) :: text
        integer :: i, code

        call check_given(error, "name", present(name))
        call check_given(error, "model", present(model))
        if (.not. allocated(error)) then
            text = ""
            do i = 1, len(text)
                if (name(i) == c_null_char) exit
                text(i:i) = name(i)
            end do
            code = find_model(text)
            if (code >= 0) then
                model = int(code, c_int)
            else
                call raise(error, error_invalid, "name = "//trim(text)//" is not allowed: it must be the name of a model")
            end if
        end if
        status = status_of(error)
    end function mdr_model_from_name

end module mdrcontact_api_medium_options
