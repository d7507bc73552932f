! SPDX-License-Identifier: GPL-3.0-or-later
!> The object of the handle of a body.
module mdrcontact_api_any_body
    use, intrinsic :: iso_c_binding, only: c_int, c_ptr
    use mdrcontact_api_handles, only: return_object
    use mdrcontact_body, only: body_t
    use mdrcontact_error, only: error_t
    use mdrcontact_medium_solver, only: solver_t
    use mdrcontact_medium_viscoelastic, only: viscoelastic_t
    use mdrcontact_tension_surface, only: surface_t
    implicit none (type, external)
    private
    public :: any_body_t, return_body, return_elastic, return_solved

    !> One of three; the other two are not allocated.
    type :: any_body_t
        !> an elastic body, whose constants are known at every depth
        class(body_t), allocatable :: elastic
        !> and its surface
        type(surface_t) :: surface
        !> one that relaxes, under no model yet
        type(viscoelastic_t), allocatable :: relaxing
        !> one that has one solution only: of a power of the depth, or rigid
        class(solver_t), allocatable :: solved
    end type any_body_t

contains

    !> Puts a body behind a new handle, unless there is an error.
    function return_body(body, out, error) result(status)
        type(any_body_t), allocatable, intent(inout) :: body
        type(c_ptr), intent(inout), optional :: out
        type(error_t), allocatable, intent(inout) :: error
        integer(c_int) :: status
        class(*), allocatable :: object

        call move_alloc(body, object)
        status = return_object(object, out, error)
    end function return_body

    !> The same with an elastic body alone.
    function return_elastic(elastic, out, error) result(status)
        class(body_t), allocatable, intent(inout) :: elastic
        type(c_ptr), intent(inout), optional :: out
        type(error_t), allocatable, intent(inout) :: error
        integer(c_int) :: status
        type(any_body_t), allocatable :: body

        allocate (body)
        call move_alloc(elastic, body%elastic)
        status = return_body(body, out, error)
    end function return_elastic

    !> The same with one that has one solution.
    function return_solved(solved, out, error) result(status)
        class(solver_t), allocatable, intent(inout) :: solved
        type(c_ptr), intent(inout), optional :: out
        type(error_t), allocatable, intent(inout) :: error
        integer(c_int) :: status
        type(any_body_t), allocatable :: body

        allocate (body)
        call move_alloc(solved, body%solved)
        status = return_body(body, out, error)
    end function return_solved

end module mdrcontact_api_any_body
