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

        one_plus_chi = 0.0_wp
        f%compliance => compliance
        ! the ends themselves are inside
        ends = log([minval(k), maxval(k)]) + [-1.0e-3_wp, 1.0e-3_wp]
        call new_sampled_function(table, f, ends, [.false.], tiny(1.0_wp), error, noise=tolerance, most=most_panels)
        if (.not. allocated(error)) one_plus_chi = exp(table%value(log(k)))
    end subroutine tabulated_compliance

    function value(self, x) result(y)
        class(logarithm_t), intent(inout) :: self
        real(wp), intent(in) :: x
        real(wp) :: y
        complex(wp) :: one_plus_chi(1), chi(1)

        call self%compliance%chi([cmplx(exp(x), kind=wp)], one_plus_chi, chi)
        y = log(real(one_plus_chi(1), wp))
    end function value

end module mdrcontact_medium_compliance_table
