! SPDX-License-Identifier: GPL-3.0-or-later
!> A medium: a body under a model, or two of them. Elastic bodies have a solver; one that relaxes has materials in its place.
module mdrcontact_medium
    use mdrcontact_body, only: body_t
    use mdrcontact_error, only: check_memory, error_invalid, error_t, raise
    use mdrcontact_layered_shared, only: layered_shared_t
    use mdrcontact_medium_pair, only: new_pair
    use mdrcontact_medium_solver, only: solver_t
    use mdrcontact_medium_viscoelastic, only: viscoelastic_t
    use mdrcontact_model, only: model_options_t, new_solver
    use mdrcontact_tension_surface, only: surface_t
    implicit none (type, external)
    private
    public :: medium_t, new_medium, new_pair, refuse_states

    !> Either a solver or a body that relaxes; both are to be read only.
    type :: medium_t
        !> of an elastic body, or of two
        class(solver_t), allocatable :: solver
        !> the materials of a body that relaxes
        type(viscoelastic_t), allocatable :: relaxing
    contains
        !> raises unless it has a solver
        procedure :: check_elastic
        !> a copy, or error_memory
        procedure :: copy_to
    end type medium_t

    !> The medium of two bodies.
    interface new_pair
        module procedure new_pair_of_media
    end interface new_pair

contains

    !> A body under a model.
    subroutine new_medium(self, body, model, error, options, shared, surface)
        type(medium_t), intent(out) :: self
        class(body_t), intent(in) :: body
        !> one of models%...
        integer, intent(in) :: model
        type(error_t), allocatable, intent(out) :: error
        !> without it: the defaults
        type(model_options_t), intent(in), optional :: options
        !> what exact media made one after the other have in common
        type(layered_shared_t), intent(inout), optional :: shared
        !> tension and plate of its surface; default none
        type(surface_t), intent(in), optional :: surface

        call new_solver(self%solver, body, model, error, options, shared, surface)
    end subroutine new_medium

    !> The medium of two bodies, of which a relaxing one may be the lower of a rigid upper one.
    subroutine new_pair_of_media(self, lower, upper, error)
        type(medium_t), intent(out) :: self
        !> media of one body each. Copied
        type(medium_t), intent(in) :: lower, upper
        type(error_t), allocatable, intent(out) :: error

        call upper%check_elastic(error)
        if (allocated(error)) return
        if (allocated(lower%relaxing) .and. upper%solver%is_rigid) then
            call lower%copy_to(self, error)
            return
        end if
        call lower%check_elastic(error)
        if (.not. allocated(error)) call new_pair(self%solver, lower%solver, upper%solver, error)
    end subroutine new_pair_of_media

    pure subroutine check_elastic(self, error)
        class(medium_t), intent(in) :: self
        type(error_t), allocatable, intent(inout) :: error

        if (allocated(self%relaxing)) call refuse_states(error)
    end subroutine check_elastic

    !> Raises what is said of states of a body that relaxes, wherever they are requested.
    pure subroutine refuse_states(error)
        type(error_t), allocatable, intent(inout) :: error

        call raise(error, error_invalid, "the body is viscoelastic, so that stiffness and states depend on time: use its "// &
                   "history (a path in time) or its dynamic stiffness (an oscillation) under a rigid indenter, or take the "// &
                   "glassy or the relaxed material")
    end subroutine refuse_states

    subroutine copy_to(self, copy, error)
        class(medium_t), intent(in) :: self
        type(medium_t), intent(inout) :: copy
        type(error_t), allocatable, intent(inout) :: error
        integer :: stat

        if (allocated(error)) return
        if (allocated(self%solver)) call self%solver%copy_to(copy%solver, error)
        if (.not. allocated(self%relaxing)) return
        allocate (copy%relaxing, source=self%relaxing, stat=stat)
        call check_memory(error, stat)
    end subroutine copy_to

end module mdrcontact_medium
