! SPDX-License-Identifier: GPL-3.0-or-later
!> One indenter of every kind, for tests that must hold for all of them.
module example_profiles
    use mdrcontact, only: area_function_t, error_t, new_area_function_profile, new_cone, new_flat_cone, new_flat_paraboloid, &
                          new_flat_punch, new_paraboloid, new_power_law, new_profile_from_function, new_profile_from_mdr, &
                          new_profile_sum, new_rounded_cone, new_sphere, new_tabulated_profile, flat_ended_t, &
                          flat_punch_t, power_law_t, profile_sum_t, profile_t, profile_term_t, rounded_cone_t, &
                          sampled_profile_t, scalar_function_t, sphere_t, wp
    implicit none (type, external)
    private
    public :: example_profile_t, make_example_profiles, hyperboloid_t, break_radii

    type :: example_profile_t
        character(len=32) :: name = ""
        class(profile_t), allocatable :: profile
        !> the largest radius to use
        real(wp) :: reach = 1.0_wp
        !> closed forms hold to 1e-12, sampled profiles to 1e-10
        real(wp) :: tolerance = 1.0e-12_wp
    end type example_profile_t

    !> f(r) = r^2/(1 + sqrt(1 + r^2)), the hyperboloid sqrt(1 + r^2) - 1, whose MDR profile is x arctan(x).
    type, extends(scalar_function_t) :: hyperboloid_t
    contains
        procedure :: value => hyperboloid_height
    end type hyperboloid_t

contains

    !> Radii at which a profile is not analytic.
    pure function break_radii(profile) result(radii)
        class(profile_t), intent(in) :: profile
        real(wp), allocatable :: radii(:)
        type(error_t), allocatable :: error

        call profile%add_breaks(radii, error)
    end function break_radii

    !> All of them except the flat punch, whose profile is 0, unless `with_punch`.
    subroutine make_example_profiles(examples, with_punch)
        type(example_profile_t), allocatable, intent(out) :: examples(:)
        logical, intent(in), optional :: with_punch
        logical :: punch

        punch = .false.
        if (present(with_punch)) punch = with_punch
        allocate (examples(merge(18, 17, punch)))
        call add_closed(examples(:11))
        call add_sampled(examples(12:16))
        call add_sum(examples(17))
        if (punch) call add_punch(examples(18))
    end subroutine make_example_profiles

    subroutine add_closed(examples)
        type(example_profile_t), intent(inout) :: examples(11)
        real(wp), parameter :: exponents(6) = [0.5_wp, 1.0_wp, 1.5_wp, 3.0_wp, 4.0_wp, 10.0_wp]
        type(power_law_t) :: power
        type(sphere_t) :: sphere
        type(flat_ended_t) :: flat_cone, flat_paraboloid
        type(rounded_cone_t) :: rounded_cone
        type(error_t), allocatable :: error
        integer :: i

        do i = 1, 6
            call new_power_law(power, exponents(i), 0.3_wp, error)
            call put(examples(i), "power law", power, error, 2.0_wp)
            write (examples(i)%name, "(a, f5.1)") "power law", exponents(i)
        end do
        call new_paraboloid(power, 1.3_wp, error)
        call put(examples(7), "paraboloid", power, error, 2.0_wp)
        call new_sphere(sphere, 1.0_wp, error)
        call put(examples(8), "sphere", sphere, error, 0.96_wp)
        call new_flat_cone(flat_cone, 0.4_wp, 0.3_wp, error)
        call put(examples(9), "flat-ended cone", flat_cone, error, 2.0_wp)
        call new_flat_paraboloid(flat_paraboloid, 0.4_wp, 1.3_wp, error)
        call put(examples(10), "flat-ended paraboloid", flat_paraboloid, error, 2.0_wp)
        call new_rounded_cone(rounded_cone, 0.4_wp, 0.3_wp, error)
        call put(examples(11), "rounded cone", rounded_cone, error, 2.0_wp)
    end subroutine add_closed

    subroutine add_sampled(examples)
        type(example_profile_t), intent(inout) :: examples(5)
        real(wp), parameter :: r(*) = [0.0_wp, 0.2_wp, 0.5_wp, 0.9_wp, 1.4_wp, 2.0_wp]
        type(sampled_profile_t) :: sampled
        type(area_function_t) :: tip
        type(hyperboloid_t) :: height
        type(error_t), allocatable :: error

        call new_tabulated_profile(sampled, r, r**2/(1.0_wp + r), error)
        call put(examples(1), "table of heights", sampled, error, 1.9_wp)
        call new_profile_from_mdr(sampled, r, r**2/(1.0_wp + r), error)
        call put(examples(2), "table of MDR heights", sampled, error, 1.9_wp)
        call new_profile_from_function(sampled, height, 3.0_wp, error)
        call put(examples(3), "user function", sampled, error, 2.0_wp)
        call new_area_function_profile(tip, [24.5_wp, 1.7_wp, 0.02_wp], 0.0_wp, 0.5_wp, error)
        call put(examples(4), "area function", tip, error, 1.3_wp)
        call new_area_function_profile(tip, [24.5_wp, 1.7_wp], 0.05_wp, 0.5_wp, error)
        call put(examples(5), "area function, round tip", tip, error, 1.3_wp)
        examples%tolerance = 1.0e-10_wp
    end subroutine add_sampled

    subroutine add_sum(example)
        type(example_profile_t), intent(inout) :: example
        type(profile_term_t) :: terms(2)
        type(power_law_t) :: cone
        type(flat_ended_t) :: flat_paraboloid
        type(profile_sum_t) :: total
        type(error_t), allocatable :: error

        call new_cone(cone, 0.2_wp, error)
        call require_success(error)
        call new_flat_paraboloid(flat_paraboloid, 0.7_wp, 2.0_wp, error)
        call require_success(error)
        allocate (terms(1)%profile, source=cone)
        allocate (terms(2)%profile, source=flat_paraboloid)
        call new_profile_sum(total, terms, error)
        call put(example, "sum of two", total, error, 2.0_wp)
    end subroutine add_sum

    subroutine add_punch(example)
        type(example_profile_t), intent(inout) :: example
        type(flat_punch_t) :: punch
        type(error_t), allocatable :: error

        call new_flat_punch(punch, 0.8_wp, error)
        call put(example, "flat punch", punch, error, 0.8_wp)
    end subroutine add_punch

    subroutine put(example, name, profile, error, reach)
        type(example_profile_t), intent(inout) :: example
        character(len=*), intent(in) :: name
        class(profile_t), intent(in) :: profile
        type(error_t), allocatable, intent(in) :: error
        real(wp), intent(in) :: reach

        call require_success(error)
        if (allocated(example%profile)) deallocate (example%profile)
        allocate (example%profile, source=profile)
        example%name = name
        example%reach = reach
    end subroutine put

    subroutine require_success(error)
        type(error_t), allocatable, intent(in) :: error

        if (allocated(error)) error stop "an example profile could not be made"
    end subroutine require_success

    function hyperboloid_height(self, x) result(y)
        class(hyperboloid_t), intent(inout) :: self
        real(wp), intent(in) :: x
        real(wp) :: y

        associate (unused => self)
        end associate
        y = x**2/(1.0_wp + sqrt(1.0_wp + x**2))
    end function hyperboloid_height

end module example_profiles
