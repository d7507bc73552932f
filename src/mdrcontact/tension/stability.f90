! SPDX-License-Identifier: GPL-3.0-or-later
!> The compression under which the surface of a body wrinkles: tau_c = -min over k of [1/(k C~) + B k^2], C~ = k C the body's own
!> compliance (theory_surfaces 7). Of a half-space k_c = (E*/(4B))^(1/3), tau_c = -3 B k_c^2 (Chen and Hutchinson 2004).
module mdrcontact_tension_stability
    use mdrcontact_body_compliance, only: compliance_t
    use mdrcontact_error, only: error_invalid, error_t, raise, to_text
    use mdrcontact_kinds, only: wp
    use mdrcontact_tension_surface, only: surface_t
    implicit none (type, external)
    private
    public :: check_stability, critical_tension

    !> Wavenumbers looked at: those of a half-space under the plate times this much, both ways, in so many steps; then between the
    !> neighbours of the lowest, so often.
    real(wp), parameter :: widest = 1.0e6_wp
    integer, parameter :: steps = 400, rounds = 40
    !> Part of the critical tension that is allowed: beyond it the compliance is nearly infinite at k_c.
    real(wp), parameter :: largest_part = 0.95_wp

contains

    !> Raises unless the tension is above the critical one.
    subroutine check_stability(surface, compliance, error)
        type(surface_t), intent(in) :: surface
        !> of the body without its surface, under a normal load
        class(compliance_t), intent(in) :: compliance
        type(error_t), allocatable, intent(inout) :: error
        real(wp) :: tension, wave

        if (allocated(error) .or. .not. surface%tension < 0.0_wp) return
        call critical_tension(surface%bending, compliance, tension, wave)
        if (surface%tension > largest_part*tension) return
        call raise(error, error_invalid, "surface tension = "//to_text(surface%tension)//" is not allowed: the surface "// &
                   "wrinkles under tau_c = "//to_text(tension)//", at the wavenumber k_c = "//to_text(wave)// &
                   "; it must be greater than 0.95 tau_c")
    end subroutine check_stability

    !> tau_c < 0 [modulus length] and k_c [1/length].
    subroutine critical_tension(bending, compliance, tension, wave)
        !> B > 0 [modulus length^3]
        real(wp), intent(in) :: bending
        class(compliance_t), intent(in) :: compliance
        real(wp), intent(out) :: tension, wave
        real(wp) :: x(0:steps), y(0:steps), low, high, t(2), at_t(2), part
        integer :: i

        wave = (0.25_wp*real(compliance%scale, wp)/bending)**(1.0_wp/3.0_wp)
        x = [(log(wave) + log(widest)*(2.0_wp*i/steps - 1.0_wp), i=0, steps)]
        y = resistance(bending, compliance, x)
        i = min(max(minloc(y, dim=1) - 1, 1), steps - 1)
        low = x(i - 1)
        high = x(i + 1)
        part = 0.5_wp*(sqrt(5.0_wp) - 1.0_wp)
        do i = 1, rounds
            t = [high - part*(high - low), low + part*(high - low)]
            at_t = resistance(bending, compliance, t)
            if (at_t(1) < at_t(2)) then
                high = t(2)
            else
                low = t(1)
            end if
        end do
        t = 0.5_wp*(low + high)
        at_t = resistance(bending, compliance, t)
        wave = exp(t(1))
        tension = -at_t(1)
    end subroutine critical_tension

    !> E0*/(2 k (1 + chi)) + B k^2 at ln k.
    function resistance(bending, compliance, x) result(values)
        real(wp), intent(in) :: bending
        class(compliance_t), intent(in) :: compliance
        real(wp), intent(in) :: x(:)
        real(wp) :: values(size(x))
        complex(wp), dimension(size(x)) :: sigma, chi

        call compliance%chi(cmplx(exp(x), 0.0_wp, wp), sigma, chi)
        values = 0.5_wp*real(compliance%scale, wp)/(exp(x)*real(sigma, wp)) + bending*exp(x)**2
    end function resistance

end module mdrcontact_tension_stability
