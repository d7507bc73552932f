! SPDX-License-Identifier: GPL-3.0-or-later
!> The contact of an indenter with a medium and its states, for C.
module mdrcontact_api_contact
    use, intrinsic :: iso_c_binding, only: c_associated, c_double, c_f_pointer, c_int, c_null_ptr, c_ptr
    use mdrcontact_api_arrays, only: check_array, check_count, check_each_positive
    use mdrcontact_api_handles, only: deliver_contact, open_contact, open_medium, open_profile
    use mdrcontact_api_status, only: check_given, check_memory, status_of
    use mdrcontact_batch, only: check_threads
    use mdrcontact_contact, only: contact_options_t, contact_t, new_contact, on_unloading
    use mdrcontact_contact_state, only: contact_state_t
    use mdrcontact_contact_values, only: contact_states, given_depth, given_force, given_radius
    use mdrcontact_contact_equilibrium, only: adhesion_automatic
    use mdrcontact_error, only: check_table, count_text, error_invalid, error_t, raise
    use mdrcontact_medium, only: medium_t
    use mdrcontact_profile, only: profile_t
    use mdrcontact_numerics_radius_law, only: new_radius_law_from_table, radius_law_t
    implicit none (type, external)
    private
    public :: c_contact_options_t, mdr_contact_options_init, mdr_contact_new
    public :: mdr_contact_from_depth, mdr_contact_from_force, mdr_contact_from_radius
    public :: mdr_contact_from_depth_on, mdr_contact_from_force_on
    public :: mdr_contact_from_depth_on_threads, mdr_contact_from_force_on_threads, mdr_contact_from_radius_threads

    !> struct mdr_contact_options
    type, bind(C) :: c_contact_options_t
        integer(c_int) :: zeta_count = 0_c_int
        type(c_ptr) :: zeta_radius = c_null_ptr
        type(c_ptr) :: zeta = c_null_ptr
        real(c_double) :: work_of_adhesion = 0.0_c_double
        integer(c_int) :: adhesion_rule = int(adhesion_automatic, c_int)
    end type c_contact_options_t

contains

    subroutine mdr_contact_options_init(options) bind(C)
        type(c_contact_options_t), intent(inout), optional :: options

        if (present(options)) options = c_contact_options_t()
    end subroutine mdr_contact_options_init

    function mdr_contact_new(profile, medium, options, out) result(status) bind(C)
        type(c_ptr), value :: profile, medium
        type(c_contact_options_t), intent(in), optional :: options
        type(c_ptr), intent(inout), optional :: out
        integer(c_int) :: status
        class(profile_t), pointer :: indenter
        class(medium_t), pointer :: body
        type(contact_t) :: contact
        type(contact_options_t) :: chosen
        type(error_t), allocatable :: error

        call open_profile(profile, "profile", indenter, error)
        call open_medium(medium, "medium", body, error)
        if (present(options)) then
            chosen%work_of_adhesion = options%work_of_adhesion
            chosen%adhesion_rule = options%adhesion_rule
            if (options%zeta_count /= 0 .and. .not. allocated(error)) call read_zeta(options, chosen%zeta, error)
        end if
        if (.not. allocated(error)) call new_contact(contact, indenter, body, error, chosen)
        status = deliver_contact(contact, out, error)
    end function mdr_contact_new

    !> zeta(a) from the table in the options.
    subroutine read_zeta(options, zeta, error)
        type(c_contact_options_t), intent(in) :: options
        type(radius_law_t), allocatable, intent(out) :: zeta
        type(error_t), allocatable, intent(out) :: error
        real(c_double), pointer :: radius(:), values(:)

        if (options%zeta_count < 0) then
            call raise(error, error_invalid, "zeta_count = "//count_text(int(options%zeta_count))// &
                       " is not allowed: it must be at least 0")
        end if
        call check_given(error, "zeta_radius", c_associated(options%zeta_radius))
        call check_given(error, "zeta", c_associated(options%zeta))
        if (allocated(error)) return
        call c_f_pointer(options%zeta_radius, radius, [options%zeta_count])
        call c_f_pointer(options%zeta, values, [options%zeta_count])
        call check_table(error, "zeta_radius", radius, "zeta", values, 3)
        call check_each_positive(error, "zeta_radius", radius)
        call check_each_positive(error, "zeta", values)
        if (allocated(error)) return
        allocate (zeta)
        call new_radius_law_from_table(zeta, radius, "zeta", values, error)
    end subroutine read_zeta

    function mdr_contact_from_depth(c, n, in, d, a, f, k) result(status) bind(C)
        type(c_ptr), value :: c
        integer(c_int), value :: n
        real(c_double), intent(in), optional :: in(*)
        real(c_double), intent(inout), optional :: d(*), a(*), f(*), k(*)
        integer(c_int) :: status

        status = write_states(c, given_depth, n, in, d, a, f, k, on_unloading, 1_c_int)
    end function mdr_contact_from_depth

    function mdr_contact_from_depth_on(c, branch, n, in, d, a, f, k) result(status) bind(C)
        type(c_ptr), value :: c
        integer(c_int), value :: branch, n
        real(c_double), intent(in), optional :: in(*)
        real(c_double), intent(inout), optional :: d(*), a(*), f(*), k(*)
        integer(c_int) :: status

        status = write_states(c, given_depth, n, in, d, a, f, k, int(branch), 1_c_int)
    end function mdr_contact_from_depth_on

    function mdr_contact_from_force(c, n, in, d, a, f, k) result(status) bind(C)
        type(c_ptr), value :: c
        integer(c_int), value :: n
        real(c_double), intent(in), optional :: in(*)
        real(c_double), intent(inout), optional :: d(*), a(*), f(*), k(*)
        integer(c_int) :: status

        status = write_states(c, given_force, n, in, d, a, f, k, on_unloading, 1_c_int)
    end function mdr_contact_from_force

    function mdr_contact_from_force_on(c, branch, n, in, d, a, f, k) result(status) bind(C)
        type(c_ptr), value :: c
        integer(c_int), value :: branch, n
        real(c_double), intent(in), optional :: in(*)
        real(c_double), intent(inout), optional :: d(*), a(*), f(*), k(*)
        integer(c_int) :: status

        status = write_states(c, given_force, n, in, d, a, f, k, int(branch), 1_c_int)
    end function mdr_contact_from_force_on

    function mdr_contact_from_radius(c, n, in, d, a, f, k) result(status) bind(C)
        type(c_ptr), value :: c
        integer(c_int), value :: n
        real(c_double), intent(in), optional :: in(*)
        real(c_double), intent(inout), optional :: d(*), a(*), f(*), k(*)
        integer(c_int) :: status

        status = write_states(c, given_radius, n, in, d, a, f, k, on_unloading, 1_c_int)
    end function mdr_contact_from_radius

    function mdr_contact_from_depth_on_threads(c, branch, n, in, d, a, f, k, threads) result(status) bind(C)
        type(c_ptr), value :: c
        integer(c_int), value :: branch, n, threads
        real(c_double), intent(in), optional :: in(*)
        real(c_double), intent(inout), optional :: d(*), a(*), f(*), k(*)
        integer(c_int) :: status

        status = write_states(c, given_depth, n, in, d, a, f, k, int(branch), threads)
    end function mdr_contact_from_depth_on_threads

    function mdr_contact_from_force_on_threads(c, branch, n, in, d, a, f, k, threads) result(status) bind(C)
        type(c_ptr), value :: c
        integer(c_int), value :: branch, n, threads
        real(c_double), intent(in), optional :: in(*)
        real(c_double), intent(inout), optional :: d(*), a(*), f(*), k(*)
        integer(c_int) :: status

        status = write_states(c, given_force, n, in, d, a, f, k, int(branch), threads)
    end function mdr_contact_from_force_on_threads

    function mdr_contact_from_radius_threads(c, n, in, d, a, f, k, threads) result(status) bind(C)
        type(c_ptr), value :: c
        integer(c_int), value :: n, threads
        real(c_double), intent(in), optional :: in(*)
        real(c_double), intent(inout), optional :: d(*), a(*), f(*), k(*)
        integer(c_int) :: status

        status = write_states(c, given_radius, n, in, d, a, f, k, on_unloading, threads)
    end function mdr_contact_from_radius_threads

    !> All states are computed before the first number is written.
    function write_states(c, given, n, in, d, a, f, k, branch, threads) result(status)
        type(c_ptr), intent(in) :: c
        integer, intent(in) :: given
        integer(c_int), intent(in) :: n, threads
        real(c_double), intent(in), optional :: in(*)
        real(c_double), intent(inout), optional :: d(*), a(*), f(*), k(*)
        integer, intent(in) :: branch
        integer(c_int) :: status
        type(contact_t), pointer :: contact
        type(contact_state_t), allocatable :: states(:)
        type(error_t), allocatable :: error

        call open_contact(c, "c", contact, error)
        call check_count(error, n)
        call check_array(error, "in", n, present(in))
        call check_threads(error, int(threads))
        if (.not. allocated(error) .and. n > 0) call solve(contact, given, branch, in(:n), states, int(threads), error)
        status = status_of(error)
        if (allocated(error) .or. n == 0) return
        if (present(d)) d(:n) = states%depth
        if (present(a)) a(:n) = states%radius
        if (present(f)) f(:n) = states%force
        if (present(k)) k(:n) = states%stiffness
    end function write_states

    subroutine solve(contact, given, branch, in, states, threads, error)
        type(contact_t), pointer, intent(in) :: contact
        integer, intent(in) :: given, branch, threads
        real(c_double), intent(in) :: in(:)
        type(contact_state_t), allocatable, intent(out) :: states(:)
        type(error_t), allocatable, intent(out) :: error
        integer :: stat

        allocate (states(size(in)), stat=stat)
        call check_memory(error, stat)
        if (allocated(error)) return
        call contact_states(contact, given, in, states, error, branch, threads)
    end subroutine solve

end module mdrcontact_api_contact
