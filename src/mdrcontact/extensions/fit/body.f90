! SPDX-License-Identifier: GPL-3.0-or-later
!> Indenter and medium as functions of a vector of numbers: what a fit varies.
!>
!> The vector is [indenter, medium, counterbody, instrument]. Objects list their numbers; trials are objects like them with
!> other numbers.
module mdrcontact_fit_body
    use mdrcontact_object, only: room
    use mdrcontact_parameter, only: parameter_t, prefixed
    use mdrcontact_error, only: check_made, error_t
    use mdrcontact_kinds, only: wp
    use mdrcontact_line_shared, only: kernel_cache_t
    use mdrcontact_medium, only: medium_t, new_pair
    use mdrcontact_profile, only: copy, profile_t
    implicit none (type, external)
    private
    public :: fit_body_t, new_fit_body, make_body

    !> Which indenter on which medium; made by new_fit_body and read only.
    type :: fit_body_t
        !> whether it was made: set last by what makes it
        logical :: is_made = .false.
        !> what trials are like: the indenter
        class(profile_t), allocatable :: profile
        !> and what it presses on
        type(medium_t), allocatable :: medium
        !> the upper one of two deformable bodies; not allocated: a rigid indenter, or one that is a number, E*_i
        type(medium_t), allocatable :: counterbody
        !> their numbers, one after the other: "indenter.radius", "layers[0].E", "upper.E"
        type(parameter_t), allocatable :: parameters(:)
        !> how many of these belong to the indenter, and how many to the medium
        integer :: of_indenter = 0, of_medium = 0
    end type fit_body_t

contains

    !> Copies the objects and lists their numbers.
    subroutine new_fit_body(self, profile, medium, error, counterbody)
        type(fit_body_t), intent(out) :: self
        class(profile_t), intent(in) :: profile
        !> of one body, or of two that stay as they are
        type(medium_t), intent(in) :: medium
        type(error_t), allocatable, intent(out) :: error
        !> of one body; the medium is then of onealso
        type(medium_t), intent(in), optional :: counterbody
        type(parameter_t), allocatable :: of_medium(:), of_counterbody(:)

        call check_made(error, "profile", profile%is_made)
        call check_made(error, "medium", medium%is_given())
        if (present(counterbody)) call check_made(error, "counterbody", counterbody%is_given())
        if (allocated(error)) return
        call room(profile%bytes() + medium%bytes(), error)
        if (present(counterbody)) call room(counterbody%bytes(), error)
        if (allocated(error)) return
        allocate (self%profile, source=profile)
        allocate (self%medium, source=medium)
        call profile%parameters(self%parameters)
        call medium%parameters(of_medium)
        allocate (of_counterbody(0))
        if (present(counterbody)) then
            allocate (self%counterbody, source=counterbody)
            call counterbody%parameters(of_counterbody)
        end if
        self%of_indenter = size(self%parameters)
        self%of_medium = size(of_medium)
        self%parameters = [prefixed(self%parameters, "indenter."), of_medium, prefixed(of_counterbody, "upper.")]
        self%is_made = .not. allocated(error)
    end subroutine new_fit_body

    !> Indenter and medium, a pair where there is a counterbody, with these numbers.
    subroutine make_body(self, values, shared, profile, medium, error)
        type(fit_body_t), intent(in) :: self
        !> same size as self%parameters
        real(wp), intent(in) :: values(:)
        !> what exact media have in common from one trial to the next
        type(kernel_cache_t), intent(inout) :: shared
        class(profile_t), allocatable, intent(out) :: profile
        type(medium_t), intent(out) :: medium
        type(error_t), allocatable, intent(out) :: error
        type(medium_t) :: lower, upper
        integer :: n, last

        n = self%of_indenter
        last = n + self%of_medium
        if (any(abs(values(:n) - self%parameters(:n)%value) > 0.0_wp)) then
            call self%profile%with_parameters(values(:n), profile, error)
        else
            ! a tip that stays as it is need not be sampled anew
            call copy(self%profile, profile, error)
        end if
        if (allocated(error)) return
        if (.not. allocated(self%counterbody)) then
            call self%medium%with_parameters(values(n + 1:last), medium, error, shared)
            return
        end if
        call self%medium%with_parameters(values(n + 1:last), lower, error, shared)
        if (.not. allocated(error)) call self%counterbody%with_parameters(values(last + 1:), upper, error, shared)
        if (.not. allocated(error)) call new_pair(medium, lower, upper, error)
    end subroutine make_body

end module mdrcontact_fit_body
