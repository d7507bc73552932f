! SPDX-License-Identifier: GPL-3.0-or-later
!> A table of the compliance of a body over many wavenumbers, for bodies whose compliance takes long: graded ones and many layers.
module mdrcontact_medium_compliance_table
    use mdrcontact_body_compliance, only: compliance_t
    use mdrcontact_error, only: error_t
    use mdrcontact_kinds, only: wp
    use mdrcontact_numerics_sampled_function, only: new_sampled_function, sampled_function_t
    use mdrcontact_numerics_scalar_function, only: scalar_function_t
    implicit none (type, external)
    private
    public :: tabulated_compliance

    !> Relative error, and the panels beyond which the compliance is not smooth enough for a table.
    real(wp), parameter :: tolerance = 1.0e-11_wp
    integer, parameter :: most_panels = 100

    !> ln(1 + chi) over ln k.
    type, extends(scalar_function_t) :: logarithm_t
        class(compliance_t), pointer :: compliance => null()
    contains
        procedure :: value
    end type logarithm_t

contains

    !> 1 + chi of an elastic body at wavenumbers, to `tolerance`. It is checked between the nodes.
    subroutine tabulated_compliance(compliance, k, one_plus_chi, error)
        class(compliance_t), intent(in), target :: compliance
        !> > 0, not all equal [1/length]
        real(wp), intent(in) :: k(:)
        !> same size as k
        real(wp), intent(out) :: one_plus_chi(:)
        !> if the compliance is not smooth enough
        type(error_t), allocatable, intent(out) :: error
        type(logarithm_t) :: f
        type(sampled_function_t) :: table
        real(wp) :: ends(2)
        integer :: i

        one_plus_chi = 0.0_wp
        f%compliance => compliance
        ! the ends themselves are inside
        ends = log([minval(k), maxval(k)]) + [-1.0e-3_wp, 1.0e-3_wp]
        call new_sampled_function(table, f, ends, [.false.], tiny(1.0_wp), error, noise=tolerance, most=most_panels)
        if (allocated(error)) return
        do i = 1, size(table%edges) - 1
            call interpolate(table, i, k, one_plus_chi)
        end do
    end subroutine tabulated_compliance

    !> The values at the wavenumbers of one panel, some at a time.
    subroutine interpolate(table, panel, k, one_plus_chi)
        type(sampled_function_t), intent(in) :: table
        integer, intent(in) :: panel
        real(wp), intent(in) :: k(:)
        real(wp), intent(inout) :: one_plus_chi(:)
        integer, parameter :: block = 512
        integer :: places(block), i, n
        real(wp) :: x(block), y(block), left, right

        left = exp(table%edges(panel))
        right = exp(table%edges(panel + 1))
        n = 0
        do i = 1, size(k)
            if (k(i) >= left .and. k(i) < right) then
                n = n + 1
                places(n) = i
            end if
            if (n == block .or. (i == size(k) .and. n > 0)) then
                ! as many as a block has, also of the last ones: rounding does not depend on the place
                x = left
                x(:n) = k(places(:n))
                x = log(x)
                call table%values_in(panel, x, y)
                y = exp(y)
                one_plus_chi(places(:n)) = y(:n)
                n = 0
            end if
        end do
    end subroutine interpolate

    function value(self, x) result(y)
        class(logarithm_t), intent(inout) :: self
        real(wp), intent(in) :: x
        real(wp) :: y
        complex(wp) :: one_plus_chi(1), chi(1)

        call self%compliance%chi([cmplx(exp(x), kind=wp)], one_plus_chi, chi)
        y = log(real(one_plus_chi(1), wp))
    end function value

end module mdrcontact_medium_compliance_table
