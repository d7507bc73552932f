! SPDX-License-Identifier: GPL-3.0-or-later
!> What an external procedure that takes the whole library pays for it at every call, beside a procedure of a module: F and dF/dd of
!> a compiled law (docs/host-codes.md). Prints a section of tests/data/benchmarks.md; processor time, the least of many repetitions.
module law_in_module
    use mdrcontact, only: contact_law_t, wp
    implicit none (type, external)
    private
    public :: of_module

contains

    subroutine of_module(law, depth, force, slope)
        type(contact_law_t), intent(in) :: law
        real(wp), intent(in) :: depth
        real(wp), intent(out) :: force, slope

        call law%force_and_slope(depth, force, slope)
    end subroutine of_module

end module law_in_module

subroutine of_host(law, depth, force, slope)
    use mdrcontact
    implicit none (type, external)
    type(contact_law_t), intent(in) :: law
    real(wp), intent(in) :: depth
    real(wp), intent(out) :: force, slope

    call law%force_and_slope(depth, force, slope)
end subroutine of_host

program law_external
    use, intrinsic :: iso_fortran_env, only: output_unit
    use law_in_module, only: of_module
    use mdrcontact, only: contact_law_t, contact_t, error_t, layered_exact_t, material_t, new_contact, new_contact_law, &
                          new_layered_exact, new_material, new_paraboloid, power_law_t, wp
    implicit none (type, external)
    abstract interface
        subroutine law_of_depth(law, depth, force, slope)
            import :: contact_law_t, wp
            type(contact_law_t), intent(in) :: law
            real(wp), intent(in) :: depth
            real(wp), intent(out) :: force, slope
        end subroutine law_of_depth
    end interface
    procedure(law_of_depth) :: of_host
    integer, parameter :: points = 4096, repeats = 400
    type(contact_law_t) :: law
    real(wp) :: depth(points), sum_of_module, sum_of_host, module_time, host_time

    call film(law)
    call random_number(depth)
    depth = 1.0e-6_wp*(0.01_wp + 0.98_wp*depth)
    call least_time(of_module, module_time, sum_of_module)
    call least_time(of_host, host_time, sum_of_host)
    if (abs(sum_of_module - sum_of_host) > 0.0_wp) error stop "the two procedures differ"
    write (output_unit, "(a)") "## Laws in procedures of a host", "", &
        "Made by `benchmarks/law_external.f90`: F and dF/dd of a law at random depths, processor time a call.", "", &
        "| procedure | ns |", "|---|---|"
    write (output_unit, "(a, f0.1, a)") "| of a module | ", 1.0e9_wp*module_time, " |", &
        "| external, with `use mdrcontact` in it | ", 1.0e9_wp*host_time, " |"

contains

    subroutine least_time(procedure_of_law, seconds, total)
        procedure(law_of_depth) :: procedure_of_law
        !> of a call
        real(wp), intent(out) :: seconds, total
        real(wp) :: force, slope, start, now
        integer :: i, j

        seconds = huge(seconds)
        do j = 1, repeats
            total = 0.0_wp
            call cpu_time(start)
            do i = 1, points
                call procedure_of_law(law, depth(i), force, slope)
                total = total + force + slope
            end do
            call cpu_time(now)
            seconds = min(seconds, (now - start)/points)
        end do
    end subroutine least_time

    !> A stiff film on a softer body under a ball.
    subroutine film(law)
        type(contact_law_t), intent(out) :: law
        type(error_t), allocatable :: error
        type(power_law_t) :: ball
        type(material_t) :: coating, base
        type(layered_exact_t) :: medium
        type(contact_t) :: contact

        call new_paraboloid(ball, 1.0e-4_wp, error)
        if (.not. allocated(error)) call new_material(coating, 400.0e9_wp, 0.25_wp, error)
        if (.not. allocated(error)) call new_material(base, 208.0e9_wp, 0.3_wp, error)
        if (.not. allocated(error)) call new_layered_exact(medium, [coating], [2.0e-6_wp], base, error)
        if (.not. allocated(error)) call new_contact(contact, ball, medium, error)
        if (.not. allocated(error)) call new_contact_law(law, contact, 1.0e-6_wp, error)
        if (allocated(error)) error stop "the law was not made"
    end subroutine film

end program law_external
