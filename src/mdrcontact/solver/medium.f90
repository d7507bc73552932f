! SPDX-License-Identifier: GPL-3.0-or-later
!> A medium: a body under a model, or two of them. Elastic bodies have a solver; one that relaxes has materials in its place.
module mdrcontact_medium
    use, intrinsic :: iso_fortran_env, only: int64
    use mdrcontact_object, only: object_t, room
    use mdrcontact_parameter, only: parameter_t
    use mdrcontact_body, only: body_t
    use mdrcontact_error, only: check_made, error_invalid, error_t, raise
    use mdrcontact_kinds, only: wp
    use mdrcontact_line_shared, only: kernel_cache_t
    use mdrcontact_medium_pair, only: new_pair
    use mdrcontact_medium_power_graded, only: new_power_graded, power_graded_t, power_law_parameters
    use mdrcontact_medium_solver, only: solver_t
    use mdrcontact_medium_viscoelastic, only: viscoelastic_t
    use mdrcontact_model, only: constant_of, model_options_t, models, new_solver, with_constant
    use mdrcontact_tension_surface, only: is_bare, surface_t
    implicit none (type, external)
    private
    public :: medium_t, new_medium, new_pair, check_elastic, refuse_states

    !> Either a solver or a viscoelastic body; both must only be read.
    type, extends(object_t) :: medium_t
        !> of an elastic body, or of two
        class(solver_t), allocatable :: solver
        !> the materials of a viscoelastic body
        type(viscoelastic_t), allocatable :: relaxing
        !> the model of its one body
        integer :: model = models%exact
        !> and what that leaves to choose
        type(model_options_t) :: options = model_options_t()
    contains
        !> its numbers: of one body, the model's constant, those of a surface that is not bare; none of two bodies
        procedure :: parameters
        !> the same kind of medium with other numbers
        procedure :: with_parameters
        procedure :: bytes
        !> whether there is a body in it
        procedure :: is_given
    end type medium_t

    !> The medium of two bodies.
    interface new_pair
        module procedure new_pair_of_media
    end interface new_pair

contains

    pure function is_given(self) result(answer)
        class(medium_t), intent(in) :: self
        logical :: answer

        answer = allocated(self%solver) .or. allocated(self%relaxing)
    end function is_given

    !> A body under a model.
    subroutine new_medium(self, body, model, error, options, shared, surface)
        type(medium_t), intent(out) :: self
        class(body_t), intent(in) :: body
        !> one of models%...
        integer, intent(in) :: model
        type(error_t), allocatable, intent(out) :: error
        !> without it: the defaults
        type(model_options_t), intent(in), optional :: options
        !> data shared by exact media created one after the other
        type(kernel_cache_t), intent(inout), optional :: shared
        !> properties of its surface; default none
        type(surface_t), intent(in), optional :: surface

        call check_made(error, "body", body%is_made)
        if (allocated(error)) return
        self%model = model
        if (present(options)) self%options = options
        call new_solver(self%solver, body, model, error, options, shared, surface)
    end subroutine new_medium

    !> The medium of two bodies, of which a relaxing one may be the lower of a rigid upper one.
    subroutine new_pair_of_media(self, lower, upper, error)
        type(medium_t), intent(out) :: self
        !> media of one body each. Copied
        type(medium_t), intent(in) :: lower, upper
        type(error_t), allocatable, intent(out) :: error

        call check_made(error, "lower", lower%is_given())
        call check_made(error, "upper", upper%is_given())
        if (allocated(error)) return
        call check_elastic(upper, error)
        if (allocated(error)) return
        if (allocated(lower%relaxing) .and. upper%solver%is_rigid) then
            call room(lower%bytes(), error)
            if (.not. allocated(error)) self = lower
            return
        end if
        call check_elastic(lower, error)
        if (.not. allocated(error)) call new_pair(self%solver, lower%solver, upper%solver, error)
        ! under a rigid body it is the lower one alone
        self%model = lower%model
        self%options = lower%options
    end subroutine new_pair_of_media

    pure subroutine parameters(self, list)
        class(medium_t), intent(in) :: self
        type(parameter_t), allocatable, intent(out) :: list(:)

        allocate (list(0))
        if (allocated(self%relaxing)) then
            call self%relaxing%parameters(list)
            return
        end if
        if (.not. allocated(self%solver)) return
        if (self%solver%is_pair) return
        associate (solver => self%solver)
            if (allocated(solver%power_law)) list = power_law_parameters(solver%power_law)
            if (.not. allocated(solver%pressed)) return
            call solver%pressed%parameters(list)
            list = [list, constant_of(self%model, self%options)]
            if (.not. is_bare(solver%sheet)) list = [list, parameter_t("surface.tension", solver%sheet%tension), &
                                                     parameter_t("surface.bending", solver%sheet%bending), &
                                                     parameter_t("surface.stretching", solver%sheet%stretching)]
        end associate
    end subroutine parameters

    subroutine with_parameters(self, values, medium, error, shared)
        class(medium_t), intent(in) :: self
        !> in the order of `parameters`
        real(wp), intent(in) :: values(:)
        type(medium_t), intent(out) :: medium
        type(error_t), allocatable, intent(out) :: error
        !> data shared by exact media created one after the other
        type(kernel_cache_t), intent(inout) :: shared
        type(power_graded_t) :: power_graded

        call check_made(error, "medium", self%is_given())
        if (allocated(error)) return
        if (size(values) == 0) then
            call room(self%bytes(), error)
            if (.not. allocated(error)) medium = self
        else if (allocated(self%relaxing)) then
            allocate (medium%relaxing)
            call self%relaxing%with_parameters(values, medium%relaxing, error, shared)
        else if (allocated(self%solver%power_law)) then
            call new_power_graded(power_graded, values(1), values(2), values(3), values(4), error)
            allocate (medium%solver, source=power_graded)
        else
            call make_alike(self, values, shared, medium, error)
        end if
    end subroutine with_parameters

    !> A body with other numbers, under the same model.
    subroutine make_alike(self, values, shared, medium, error)
        class(medium_t), intent(in) :: self
        real(wp), intent(in) :: values(:)
        type(kernel_cache_t), intent(inout) :: shared
        type(medium_t), intent(inout) :: medium
        type(error_t), allocatable, intent(out) :: error
        class(body_t), allocatable :: body
        type(model_options_t) :: options
        type(surface_t) :: surface
        integer :: last

        last = size(values)
        if (.not. is_bare(self%solver%sheet)) then
            surface = surface_t(values(last - 2), values(last - 1), values(last))
            last = last - 3
        end if
        options = self%options
        if (size(constant_of(self%model, options)) > 0) then
            options = with_constant(options, self%model, values(last))
            last = last - 1
        end if
        call self%solver%pressed%with_parameters(values(:last), body, error)
        if (.not. allocated(error)) call new_medium(medium, body, self%model, error, options, shared, surface)
    end subroutine make_alike

    !> Raises unless the medium has a solver.
    pure subroutine check_elastic(self, error)
        type(medium_t), intent(in) :: self
        type(error_t), allocatable, intent(inout) :: error

        if (allocated(self%relaxing)) call refuse_states(error)
    end subroutine check_elastic

    !> Raises the error of states of a viscoelastic body, wherever they are requested.
    pure subroutine refuse_states(error)
        type(error_t), allocatable, intent(inout) :: error

        call raise(error, error_invalid, "medium: states and stiffness of a viscoelastic body depend on time. Use a history "// &
                   "or the dynamic stiffness with a rigid indenter, or use the glassy or the relaxed material")
    end subroutine refuse_states

    pure recursive function bytes(self)
        class(medium_t), intent(in) :: self
        integer(int64) :: bytes

        bytes = 0
        if (allocated(self%solver)) bytes = self%solver%bytes()
        if (allocated(self%relaxing)) bytes = self%relaxing%bytes()
    end function bytes

end module mdrcontact_medium
