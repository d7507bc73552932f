! SPDX-License-Identifier: GPL-3.0-or-later
!> Indenter and medium as functions of a vector of parameters: what a fit varies.
!>
!> The vector is [indenter, medium, counterbody, instrument]. indenter_count and body_count say how many parameters there are; what
!> does not fit one of the kinds is given as a finished object and then has none.
module mdrcontact_fit_body
    use mdrcontact_error, only: count_text, error_invalid, error_t, raise
    use mdrcontact_fit_medium_of, only: make_medium, medium_choice_t, medium_count, medium_none
    use mdrcontact_kinds, only: wp
    use mdrcontact_layered_shared, only: layered_shared_t
    use mdrcontact_medium, only: medium_t, new_pair
    use mdrcontact_profile, only: profile_t
    use mdrcontact_profile_area_function, only: new_area_function_profile
    use mdrcontact_profile_flat_cone, only: flat_cone_t, new_flat_cone
    use mdrcontact_profile_flat_paraboloid, only: flat_paraboloid_t, new_flat_paraboloid
    use mdrcontact_profile_flat_punch, only: flat_punch_t, new_flat_punch
    use mdrcontact_profile_power_law, only: new_cone, new_paraboloid, new_power_law, power_law_t
    use mdrcontact_profile_rounded_cone, only: new_rounded_cone, rounded_cone_t
    use mdrcontact_profile_sampled, only: sampled_profile_t
    use mdrcontact_profile_sphere, only: new_sphere, sphere_t
    implicit none (type, external)
    private
    public :: area_terms, fit_body_t, indenter_count, body_count, make_body
    public :: indenter_given, indenter_paraboloid, indenter_sphere, indenter_cone, indenter_power_law, indenter_flat_punch, &
              indenter_flat_cone, indenter_flat_paraboloid, indenter_rounded_cone, indenter_area_function

    !> Kinds of indenter; their parameters are the arguments of the shape's `new_...` procedure, in its order.
    integer, parameter :: indenter_given = 0, indenter_paraboloid = 1, indenter_sphere = 2, indenter_cone = 3, &
                          indenter_power_law = 4, indenter_flat_punch = 5, indenter_flat_cone = 6, &
                          indenter_flat_paraboloid = 7, indenter_rounded_cone = 8, indenter_area_function = 9
    !> Coefficients C0, C1, ... of an area function, 0 for those it has not; before them stand its smallest and its largest height.
    integer, parameter :: area_terms = 8
    integer, parameter :: indenter_numbers(0:9) = [0, 1, 1, 1, 2, 1, 2, 2, 2, 2 + area_terms]

    !> Which indenter on which medium.
    type :: fit_body_t
        !> one of indenter_...
        integer :: indenter = indenter_given
        !> the finished indenter for indenter_given
        class(profile_t), allocatable :: profile
        !> the kind of medium and its choices
        type(medium_choice_t) :: medium
        !> the same of the upper one of two deformable bodies; medium_none: a rigid indenter, or one that is a number, E*_i
        type(medium_choice_t) :: counterbody = medium_choice_t(kind=medium_none)
    end type fit_body_t

contains

    !> How many parameters the indenter has; -1 for a kind that does not exist.
    pure function indenter_count(self) result(count)
        type(fit_body_t), intent(in) :: self
        integer :: count

        count = -1
        if (self%indenter >= 0 .and. self%indenter <= ubound(indenter_numbers, 1)) count = indenter_numbers(self%indenter)
    end function indenter_count

    !> How many parameters indenter, medium and counterbody have together; -1 for kinds that do not exist.
    pure function body_count(self) result(count)
        type(fit_body_t), intent(in) :: self
        integer :: count
        integer :: counts(3)

        counts = [indenter_count(self), medium_count(self%medium), medium_count(self%counterbody)]
        count = -1
        if (all(counts >= 0) .and. self%medium%kind /= medium_none) count = sum(counts)
    end function body_count

    !> Indenter and medium, a pair where there is a counterbody, from their parameters, values = [indenter, medium, counterbody].
    subroutine make_body(self, values, shared, profile, medium, error)
        type(fit_body_t), intent(in) :: self
        real(wp), intent(in) :: values(:)
        !> what exact media have in common from one trial to the next
        type(layered_shared_t), intent(inout) :: shared
        class(profile_t), allocatable, intent(out) :: profile
        type(medium_t), intent(out) :: medium
        type(error_t), allocatable, intent(out) :: error
        type(medium_t) :: lower, upper
        integer :: first, last

        first = indenter_count(self) + 1
        last = indenter_count(self) + medium_count(self%medium)
        call make_profile(self, values(:first - 1), profile, error)
        if (allocated(error)) return
        if (self%counterbody%kind == medium_none) then
            call make_medium(self%medium, values(first:last), shared, medium, error)
            return
        end if
        call make_medium(self%medium, values(first:last), shared, lower, error)
        if (.not. allocated(error)) call make_medium(self%counterbody, values(last + 1:), shared, upper, error)
        if (.not. allocated(error)) call new_pair(medium, lower, upper, error)
    end subroutine make_body

    subroutine make_profile(self, values, profile, error)
        type(fit_body_t), intent(in) :: self
        real(wp), intent(in) :: values(:)
        class(profile_t), allocatable, intent(out) :: profile
        type(error_t), allocatable, intent(out) :: error
        type(power_law_t) :: power_law
        type(sphere_t) :: sphere
        type(flat_punch_t) :: flat_punch
        type(flat_cone_t) :: flat_cone
        type(flat_paraboloid_t) :: flat_paraboloid
        type(rounded_cone_t) :: rounded_cone
        type(sampled_profile_t) :: sampled

        select case (self%indenter)
        case (indenter_given)
            if (allocated(self%profile)) then
                call self%profile%copy_to(profile, error)
            else
                call raise(error, error_invalid, "the indenter is missing: a profile must be given")
            end if
        case (indenter_paraboloid)
            call new_paraboloid(power_law, values(1), error)
            allocate (profile, source=power_law)
        case (indenter_sphere)
            call new_sphere(sphere, values(1), error)
            allocate (profile, source=sphere)
        case (indenter_cone)
            call new_cone(power_law, values(1), error)
            allocate (profile, source=power_law)
        case (indenter_power_law)
            call new_power_law(power_law, values(1), values(2), error)
            allocate (profile, source=power_law)
        case (indenter_flat_punch)
            call new_flat_punch(flat_punch, values(1), error)
            allocate (profile, source=flat_punch)
        case (indenter_flat_cone)
            call new_flat_cone(flat_cone, values(1), values(2), error)
            allocate (profile, source=flat_cone)
        case (indenter_flat_paraboloid)
            call new_flat_paraboloid(flat_paraboloid, values(1), values(2), error)
            allocate (profile, source=flat_paraboloid)
        case (indenter_rounded_cone)
            call new_rounded_cone(rounded_cone, values(1), values(2), error)
            allocate (profile, source=rounded_cone)
        case (indenter_area_function)
            call new_area_function_profile(sampled, values(3:), values(1), values(2), error)
            allocate (profile, source=sampled)
        case default
            call raise(error, error_invalid, "indenter = "//count_text(self%indenter)//" is not allowed: it must be a kind of "// &
                       "indenter in enum mdr_fit_indenter")
        end select
    end subroutine make_profile

end module mdrcontact_fit_body
