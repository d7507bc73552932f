! SPDX-License-Identifier: GPL-3.0-or-later
!> Whether the surface of a body under stress stays flat, and the stress of a layer at which it wrinkles (theory of surfaces 7).
!>
!> Equilibrium is stable while the stiffness 1/(k C(k)) of every wave is positive.
module mdrcontact_body_stability
    use mdrcontact_body, only: body_t
    use mdrcontact_body_compliance, only: compliance_t, normal_load
    use mdrcontact_error, only: error_invalid, error_t, raise, to_text
    use mdrcontact_kinds, only: pi, wp
    implicit none (type, external)
    private
    public :: check_stable, softest_wave

    !> Octaves of k h below and above 1 that are looked at, and waves in each.
    integer, parameter :: lowest = -30, highest = 5, in_octave = 8

contains

    !> Raises if some wave has no stiffness.
    subroutine check_stable(body, error)
        class(body_t), intent(in) :: body
        type(error_t), allocatable, intent(inout) :: error
        real(wp) :: k, stiffness

        if (allocated(error) .or. .not. body%first_depth > 0.0_wp) return
        call softest_wave(body, k, stiffness, error)
        if (allocated(error) .or. stiffness > 0.0_wp) return
        call raise(error, error_invalid, "prestress is not allowed: under so much compression the surface wrinkles, at the "// &
                   "wavelength "//to_text(2.0_wp*pi/k))
    end subroutine check_stable

    !> The wave that the surface opposes least, beside a half-space of the surface material: 1/sigma(k) is smallest there.
    subroutine softest_wave(body, k, stiffness, error)
        class(body_t), intent(in) :: body
        !> its wavenumber [1/length], and 1/sigma [1], 0 or less where the body is unstable
        real(wp), intent(out) :: k, stiffness
        type(error_t), allocatable, intent(inout) :: error
        class(compliance_t), allocatable :: compliance
        real(wp) :: waves((highest - lowest)*in_octave + 1), values((highest - lowest)*in_octave + 1)
        real(wp) :: low, high, inner, outer, at_inner, at_outer
        real(wp), parameter :: golden = 0.3819660112501051_wp
        integer :: i, least

        k = 1.0_wp
        stiffness = 1.0_wp
        call body%compliance(normal_load, compliance, error)
        if (allocated(error)) return
        waves = [(2.0_wp**(lowest + real(i, wp)/in_octave)/body%first_depth, i=0, size(waves) - 1)]
        do i = 1, size(waves)
            values(i) = stiffness_at(compliance, waves(i))
        end do
        least = minloc(values, dim=1)
        low = waves(max(1, least - 1))
        high = waves(min(size(waves), least + 1))
        inner = low + golden*(high - low)
        outer = high - golden*(high - low)
        at_inner = stiffness_at(compliance, inner)
        at_outer = stiffness_at(compliance, outer)
        do while (high - low > 1.0e-8_wp*high)
            if (at_inner < at_outer) then
                high = outer
                outer = inner
                at_outer = at_inner
                inner = low + golden*(high - low)
                at_inner = stiffness_at(compliance, inner)
            else
                low = inner
                inner = outer
                at_inner = at_outer
                outer = high - golden*(high - low)
                at_outer = stiffness_at(compliance, outer)
            end if
        end do
        k = inner
        stiffness = min(at_inner, values(least))
    end subroutine softest_wave

    function stiffness_at(compliance, k) result(stiffness)
        class(compliance_t), intent(in) :: compliance
        real(wp), intent(in) :: k
        real(wp) :: stiffness
        complex(wp) :: sigma(1), chi(1)

        call compliance%chi([cmplx(k, kind=wp)], sigma, chi)
        stiffness = 1.0_wp/real(sigma(1), wp)
    end function stiffness_at

end module mdrcontact_body_stability
