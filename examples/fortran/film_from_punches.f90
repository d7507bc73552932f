! SPDX-License-Identifier: GPL-3.0-or-later
!> From measured stiffness against contact radius to the modulus and thickness of a film: flat punches on rubber on glass,
!> fitted with the exact layered medium on a rigid base.
!>
!> Usage: film_from_punches examples/fit/punches_on_rubber.csv   (contact radius in um, stiffness in N/m, one header line).
!> Units of this program: um, MPa and uN; a stiffness in N/m is one in uN/um.
program film_from_punches
    use, intrinsic :: iso_fortran_env, only: error_unit, iostat_end
    use mdrcontact, only: data_stiffness_radius, error_t, fit_data_t, fit_problem_t, fit_result_t, material_t, medium_t, models, &
                          new_fit_body, new_material, new_medium, new_paraboloid, new_stack, power_law_t, profile_interval, &
                          solve_fit, stack_t, start_parameters, wp
    implicit none (type, external)

    !> Positions of the numbers: R of the indenter; E, nu, h of the film, then what is not sought here.
    integer, parameter :: film_young = 2, film_thickness = 4
    type(fit_problem_t) :: problem
    type(fit_data_t) :: data
    type(fit_result_t) :: fit
    type(error_t), allocatable :: error
    real(wp) :: lower, upper

    call read_punches(data)
    call set_problem(problem)
    call solve_fit(problem, data, fit, error)
    call stop_on(error)
    if (.not. fit%converged) print "(a)", "NOT converged: the best point found is"
    print "(i0, a, f0.1, a, f0.1, a)", size(data%x), " punches, chi-square ", fit%chi_square, " of ", fit%degrees_of_freedom, &
        " degrees of freedom"
    print "(a, f8.4, a, f7.4, a)", "film modulus   ", fit%values(film_young), " +- ", sqrt(fit%covariance(1, 1)), " MPa"
    print "(a, f8.3, a, f7.3, a)", "film thickness ", fit%values(film_thickness), " +- ", sqrt(fit%covariance(2, 2)), " um"
    call profile_interval(problem, data, fit, film_young, 0.95_wp, lower, upper, error)
    call stop_on(error)
    print "(a, f0.4, a, f0.4, a)", "95 % interval of the modulus by profile likelihood: ", lower, " to ", upper, " MPa"

contains

    !> Stiffnesses with 2 % of each as its standard deviation.
    subroutine read_punches(data)
        type(fit_data_t), intent(out) :: data
        integer, parameter :: most = 1000
        real(wp) :: a(most), k(most)
        character(len=512) :: path
        integer :: unit, status, n

        call get_command_argument(1, path, status=status)
        if (status == 0) open (newunit=unit, file=trim(path), action="read", status="old", iostat=status)
        if (status /= 0) then
            write (error_unit, "(a)") "usage: film_from_punches PUNCHES.csv"
            error stop 1
        end if
        read (unit, *)
        do n = 0, most - 1
            read (unit, *, iostat=status) a(n + 1), k(n + 1)
            if (status == iostat_end) exit
            if (status /= 0) error stop "a line of the file is not two numbers"
        end do
        close (unit)
        data%x = a(:n)
        data%y = k(:n)
        data%sd = 0.02_wp*k(:n)
    end subroutine read_punches

    !> The indenter's shape does not enter stiffnesses at given radii; it must be there all the same.
    subroutine set_problem(problem)
        type(fit_problem_t), intent(out) :: problem
        type(power_law_t) :: tip
        type(material_t) :: rubber
        type(stack_t) :: film
        type(medium_t) :: medium
        type(error_t), allocatable :: error

        call new_paraboloid(tip, 1.0_wp, error)
        if (.not. allocated(error)) call new_material(rubber, 1.0_wp, 0.49_wp, error)
        if (.not. allocated(error)) call new_stack(film, [rubber], [2.0_wp], rubber, error, rigid_base=.true.)
        if (.not. allocated(error)) call new_medium(medium, film, models%exact, error)
        if (.not. allocated(error)) call new_fit_body(problem%body, tip, medium, error)
        call stop_on(error)
        problem%data_kind = data_stiffness_radius
        problem%parameters = start_parameters(problem%body)
        problem%parameters([film_young, film_thickness])%is_free = .true.
    end subroutine set_problem

    !> Prints the library's own words and ends the program.
    subroutine stop_on(error)
        type(error_t), intent(in), allocatable :: error

        if (.not. allocated(error)) return
        write (error_unit, "(a)") error%message
        error stop 1
    end subroutine stop_on

end program film_from_punches
