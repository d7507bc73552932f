! SPDX-License-Identifier: GPL-3.0-or-later
!> Homogeneous media, and the modulus and stiffness of any medium, for C.
module mdrcontact_api_medium
    use, intrinsic :: iso_c_binding, only: c_double, c_int, c_ptr
    use mdrcontact_api_arrays, only: check_each_positive, check_each_within, check_in_out, check_positive_results
    use mdrcontact_api_handles, only: deliver, hand_over, open_handle
    use mdrcontact_api_status, only: check_memory, status_of, wanted_threads
    use mdrcontact_error, only: error_invalid, error_t, raise
    use mdrcontact_material, only: material_t, new_material
    use mdrcontact_medium, only: medium_t
    use mdrcontact_medium_homogeneous, only: homogeneous_t, new_homogeneous, new_homogeneous_from_modulus, new_rigid
    use mdrcontact_medium_pair, only: new_pair
    use mdrcontact_medium_values, only: modulus_values
    implicit none (type, external)
    private
    public :: mdr_medium_rigid, mdr_medium_pair
    public :: mdr_medium_homogeneous, mdr_medium_contact_modulus, mdr_medium_modulus, mdr_medium_stiffness
    public :: mdr_medium_tangential_modulus, mdr_medium_torsional_stiffness

contains

    function mdr_medium_homogeneous(e, nu, out) result(status) bind(C)
        real(c_double), value :: e, nu
        type(c_ptr), intent(inout), optional :: out
        integer(c_int) :: status
        type(material_t) :: material
        type(homogeneous_t) :: medium
        type(error_t), allocatable :: error

        call new_material(material, e, nu, error)
        call new_homogeneous(medium, material)
        status = deliver(medium, out, error)
    end function mdr_medium_homogeneous

    function mdr_medium_contact_modulus(contact_modulus, out) result(status) bind(C)
        real(c_double), value :: contact_modulus
        type(c_ptr), intent(inout), optional :: out
        integer(c_int) :: status
        type(homogeneous_t) :: medium
        type(error_t), allocatable :: error

        call new_homogeneous_from_modulus(medium, contact_modulus, error)
        status = deliver(medium, out, error)
    end function mdr_medium_contact_modulus

    function mdr_medium_rigid(out) result(status) bind(C)
        type(c_ptr), intent(inout), optional :: out
        integer(c_int) :: status
        type(homogeneous_t) :: medium
        type(error_t), allocatable :: error

        call new_rigid(medium)
        status = deliver(medium, out, error)
    end function mdr_medium_rigid

    function mdr_medium_pair(lower, upper, out) result(status) bind(C)
        type(c_ptr), value :: lower, upper
        type(c_ptr), intent(inout), optional :: out
        integer(c_int) :: status
        class(medium_t), pointer :: first, second
        class(medium_t), allocatable :: medium
        class(*), allocatable :: object
        type(error_t), allocatable :: error

        call open_handle(lower, "lower", first, error)
        call open_handle(upper, "upper", second, error)
        if (.not. allocated(error)) call new_pair(medium, first, second, error)
        if (allocated(error)) then
            status = status_of(error)
        else
            call move_alloc(medium, object)
            status = hand_over(object, out, error)
        end if
    end function mdr_medium_pair

    function mdr_medium_modulus(m, n, a, out) result(status) bind(C)
        type(c_ptr), value :: m
        integer(c_int), value :: n
        real(c_double), intent(in), optional :: a(*)
        real(c_double), intent(inout), optional :: out(*)
        integer(c_int) :: status
        real(c_double), allocatable :: modulus(:)
        type(error_t), allocatable :: error

        call evaluate(m, n, a, present(out), modulus, error)
        if (.not. allocated(error) .and. n > 0) out(:n) = modulus
        status = status_of(error)
    end function mdr_medium_modulus

    function mdr_medium_stiffness(m, n, a, out) result(status) bind(C)
        type(c_ptr), value :: m
        integer(c_int), value :: n
        real(c_double), intent(in), optional :: a(*)
        real(c_double), intent(inout), optional :: out(*)
        integer(c_int) :: status, i
        real(c_double), allocatable :: modulus(:)
        type(error_t), allocatable :: error

        call evaluate(m, n, a, present(out), modulus, error)
        if (.not. allocated(error) .and. n > 0) then
            do i = 1, n
                modulus(i) = 2.0_c_double*a(i)*modulus(i)
            end do
            call check_positive_results(error, modulus)
        end if
        if (.not. allocated(error) .and. n > 0) out(:n) = modulus
        status = status_of(error)
    end function mdr_medium_stiffness

    function mdr_medium_tangential_modulus(m, n, a, out) result(status) bind(C)
        type(c_ptr), value :: m
        integer(c_int), value :: n
        real(c_double), intent(in), optional :: a(*)
        real(c_double), intent(inout), optional :: out(*)
        integer(c_int) :: status
        class(medium_t), pointer :: medium
        class(medium_t), allocatable, target :: tangential
        real(c_double), allocatable :: modulus(:)
        type(error_t), allocatable :: error

        call open_handle(m, "m", medium, error)
        if (.not. allocated(error)) call check_deformable(medium, error)
        if (.not. allocated(error)) call medium%new_tangential(tangential, error)
        if (.not. allocated(error)) call evaluate_medium(tangential, n, a, present(out), modulus, error)
        if (.not. allocated(error) .and. n > 0) out(:n) = modulus
        status = status_of(error)
    end function mdr_medium_tangential_modulus

    function mdr_medium_torsional_stiffness(m, n, a, out) result(status) bind(C)
        type(c_ptr), value :: m
        integer(c_int), value :: n
        real(c_double), intent(in), optional :: a(*)
        real(c_double), intent(inout), optional :: out(*)
        integer(c_int) :: status
        class(medium_t), pointer :: medium
        real(c_double), allocatable :: stiffness(:)
        type(error_t), allocatable :: error

        ! checks media and radii, and gives E_eff, which is overwritten
        call evaluate(m, n, a, present(out), stiffness, error)
        if (.not. allocated(error) .and. n > 0) then
            call open_handle(m, "m", medium, error)
            if (.not. allocated(error)) call medium%torsional_stiffness(a(:n), stiffness, error)
            if (.not. allocated(error)) call check_positive_results(error, stiffness)
        end if
        if (.not. allocated(error) .and. n > 0) out(:n) = stiffness
        status = status_of(error)
    end function mdr_medium_torsional_stiffness

    !> E_eff(a) at checked radii.
    subroutine evaluate(m, n, a, has_out, modulus, error)
        type(c_ptr), intent(in) :: m
        integer(c_int), intent(in) :: n
        real(c_double), intent(in), optional :: a(*)
        logical, intent(in) :: has_out
        real(c_double), allocatable, intent(out) :: modulus(:)
        type(error_t), allocatable, intent(out) :: error
        class(medium_t), pointer :: medium

        call open_handle(m, "m", medium, error)
        if (.not. allocated(error)) call check_deformable(medium, error)
        if (.not. allocated(error)) call evaluate_medium(medium, n, a, has_out, modulus, error)
    end subroutine evaluate

    subroutine check_deformable(medium, error)
        class(medium_t), intent(in) :: medium
        type(error_t), allocatable, intent(inout) :: error

        if (.not. medium%is_rigid()) return
        call raise(error, error_invalid, " is not allowed: it is rigid; pair it with a deformable body", "m")
    end subroutine check_deformable

    subroutine evaluate_medium(medium, n, a, has_out, modulus, error)
        class(medium_t), intent(in), target :: medium
        integer(c_int), intent(in) :: n
        real(c_double), intent(in), optional :: a(*)
        logical, intent(in) :: has_out
        real(c_double), allocatable, intent(out) :: modulus(:)
        type(error_t), allocatable, intent(inout) :: error
        integer :: stat

        call check_in_out(error, n, "a", present(a), has_out)
        if (allocated(error) .or. n == 0) return
        call check_each_positive(error, "a", a(:n))
        call check_each_within(error, "a", a(:n), medium%smallest_radius(), medium%largest_radius(), "the medium", &
                               trim(medium%why_it_ends()))
        if (allocated(error)) return
        allocate (modulus(n), stat=stat)
        call check_memory(error, stat)
        if (allocated(error)) return
        call modulus_values(medium, a(:n), modulus, wanted_threads(), error)
        if (.not. allocated(error)) call check_positive_results(error, modulus)
    end subroutine evaluate_medium

end module mdrcontact_api_medium
