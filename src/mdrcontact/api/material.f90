! SPDX-License-Identifier: GPL-3.0-or-later
!> Viscoelastic materials and the media made of them, for C.
module mdrcontact_api_material
    use, intrinsic :: iso_c_binding, only: c_associated, c_double, c_int, c_ptr
    use mdrcontact_api_arrays, only: check_array, check_complex_arrays, check_count, check_each_positive, check_in_out, &
                                     check_results, deliver_parts, make_room
    use mdrcontact_api_handles, only: deliver, hand_over, open_handle
    use mdrcontact_api_medium_options, only: read_medium_options, read_surface
    use mdrcontact_api_status, only: check_given, status_of
    use mdrcontact_error, only: check_choice, check_memory, check_not_negative, error_invalid, error_t, raise
    use mdrcontact_kinds, only: wp
    use mdrcontact_material, only: material_t, new_material
    use mdrcontact_material_rheology, only: new_elastic_rheology, new_power_law_rheology, new_viscoelastic, rheology_t
    use mdrcontact_medium, only: medium_t
    use mdrcontact_medium_viscoelastic, only: new_viscoelastic_medium
    use mdrcontact_model, only: model_options_t
    use mdrcontact_tension_surface, only: is_bare, surface_t
    implicit none (type, external)
    private
    public :: mdr_material_viscoelastic, mdr_material_power_law
    public :: mdr_material_relaxation, mdr_material_creep, mdr_material_complex_modulus, mdr_material_limit

    !> enum mdr_limit
    integer, parameter :: glassy = 1, relaxed = 2

contains

    function mdr_material_viscoelastic(relaxed_shear_modulus, n, moduli, times, viscosity, nu, bulk_modulus, out) &
        result(status) bind(C, name="mdrcontact_entry_material_viscoelastic")
        real(c_double), value :: relaxed_shear_modulus, viscosity, nu, bulk_modulus
        integer(c_int), value :: n
        real(c_double), intent(in), optional :: moduli(*), times(*)
        type(c_ptr), intent(inout), optional :: out
        integer(c_int) :: status
        type(rheology_t) :: rheology
        real(c_double) :: none(0)
        type(error_t), allocatable :: error

        call check_count(error, n)
        call check_array(error, "moduli", n, present(moduli))
        call check_array(error, "times", n, present(times))
        if (.not. allocated(error)) then
            if (n == 0) then
                call new_viscoelastic(rheology, relaxed_shear_modulus, none, none, viscosity, nu, bulk_modulus, error)
            else
                call new_viscoelastic(rheology, relaxed_shear_modulus, moduli(:n), times(:n), viscosity, nu, bulk_modulus, error)
            end if
        end if
        status = deliver(rheology, out, error)
    end function mdr_material_viscoelastic

    function mdr_material_power_law(modulus, time, exponent, nu, out) result(status) &
        bind(C, name="mdrcontact_entry_material_power_law")
        real(c_double), value :: modulus, time, exponent, nu
        type(c_ptr), intent(inout), optional :: out
        integer(c_int) :: status
        type(rheology_t) :: rheology
        type(error_t), allocatable :: error

        call new_power_law_rheology(rheology, modulus, time, exponent, nu, error)
        status = deliver(rheology, out, error)
    end function mdr_material_power_law

    function mdr_material_relaxation(m, n, t, out) result(status) bind(C, name="mdrcontact_entry_material_relaxation")
        type(c_ptr), value :: m
        integer(c_int), value :: n
        real(c_double), intent(in), optional :: t(*)
        real(c_double), intent(inout), optional :: out(*)
        integer(c_int) :: status

        status = in_time(m, n, t, out, .false.)
    end function mdr_material_relaxation

    function mdr_material_creep(m, n, t, out) result(status) bind(C, name="mdrcontact_entry_material_creep")
        type(c_ptr), value :: m
        integer(c_int), value :: n
        real(c_double), intent(in), optional :: t(*)
        real(c_double), intent(inout), optional :: out(*)
        integer(c_int) :: status

        status = in_time(m, n, t, out, .true.)
    end function mdr_material_creep

    function in_time(m, n, t, out, is_creep) result(status)
        type(c_ptr), intent(in) :: m
        integer(c_int), intent(in) :: n
        real(c_double), intent(in), optional :: t(*)
        real(c_double), intent(inout), optional :: out(*)
        logical, intent(in) :: is_creep
        integer(c_int) :: status
        type(rheology_t), pointer :: material
        real(c_double), allocatable :: values(:)
        type(error_t), allocatable :: error
        integer :: i

        call open_handle(m, "m", material, error)
        call check_in_out(error, n, "t", present(t), present(out))
        do i = 1, n
            if (allocated(error)) exit
            call check_not_negative(error, "t", t(i), i)
            if (is_creep .or. t(i) > 0.0_wp .or. material%has_glassy()) cycle
            call raise(error, error_invalid, " = 0.0 is not allowed: there G(t) of a power law, or with a dashpot in parallel, "// &
                       "is infinite", "t", i)
        end do
        call make_room(error, n, values)
        if (.not. allocated(error) .and. n > 0) then
            if (is_creep) then
                values = material%creep(t(:n))
            else
                values = material%relaxation(t(:n))
            end if
            call check_results(error, values)
            if (.not. allocated(error)) out(:n) = values
        end if
        status = status_of(error)
    end function in_time

    function mdr_material_complex_modulus(m, n, omega, storage, loss) result(status) &
        bind(C, name="mdrcontact_entry_material_complex_modulus")
        type(c_ptr), value :: m
        integer(c_int), value :: n
        real(c_double), intent(in), optional :: omega(*)
        real(c_double), intent(inout), optional :: storage(*), loss(*)
        integer(c_int) :: status
        type(rheology_t), pointer :: material
        complex(wp), allocatable :: values(:)
        type(error_t), allocatable :: error
        integer :: i

        call open_handle(m, "m", material, error)
        call check_complex_arrays(error, n, "omega", present(omega), present(storage), present(loss))
        if (.not. allocated(error) .and. n > 0) call check_each_positive(error, "omega", omega(:n))
        call make_room(error, n, values)
        do i = 1, n
            if (allocated(error)) exit
            values(i) = material%complex_shear(cmplx(0.0_wp, omega(i), wp))
        end do
        call deliver_parts(error, values, storage, loss)
        status = status_of(error)
    end function mdr_material_complex_modulus

    function mdr_material_limit(m, limit, e, nu) result(status) bind(C, name="mdrcontact_entry_material_limit")
        type(c_ptr), value :: m
        integer(c_int), value :: limit
        real(c_double), intent(inout), optional :: e, nu
        integer(c_int) :: status
        type(rheology_t), pointer :: rheology
        type(material_t) :: material
        type(error_t), allocatable :: error

        call open_handle(m, "m", rheology, error)
        call check_choice(error, "limit", int(limit), glassy, relaxed, "1 (glassy) or 2 (relaxed)")
        if (.not. allocated(error)) then
            if (limit == glassy) then
                call rheology%glassy(material, error)
            else
                call rheology%relaxed(material, error)
            end if
        end if
        status = status_of(error)
        if (allocated(error)) return
        if (present(e)) e = material%young
        if (present(nu)) nu = material%poisson
    end function mdr_material_limit

end module mdrcontact_api_material
