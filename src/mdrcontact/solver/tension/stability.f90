! SPDX-License-Identifier: GPL-3.0-or-later
!> The compression under which the surface of a body wrinkles: tau_c = -min over k of [1/(k C~) + B k^2], C~ = k C the body's own
!> compliance (theory/surfaces.md (7.2), (7.3)). Of a half-space k_c = (E*/(4B))^(1/3), tau_c = -3 B k_c^2 (Chen and Hutchinson
!> 2004).
module mdrcontact_tension_stability
    use mdrcontact_body_compliance, only: compliance_t
    use mdrcontact_error, only: error_invalid, error_t, raise, to_text
    use mdrcontact_kinds, only: wp
    use mdrcontact_numerics_lowest, only: find_lowest, in_six_digits
    use mdrcontact_numerics_scalar_function, only: scalar_function_t
    use mdrcontact_tension_surface, only: surface_t
    implicit none (type, external)
    private
    public :: check_stability, critical_tension

    !> Wavenumbers considered: those of a half-space under the plate times this much, both ways, in so many steps.
    real(wp), parameter :: widest = 1.0e6_wp
    integer, parameter :: steps = 400
    !> Part of the critical tension that is allowed: beyond it the compliance is nearly infinite at k_c.
    real(wp), parameter :: largest_part = 0.95_wp

    !> The stiffness of waves without the tension, over the logarithm of their wavenumbers.
    type, extends(scalar_function_t) :: resistance_t
        real(wp) :: bending = 0.0_wp
        class(compliance_t), pointer :: compliance => null()
    contains
        procedure :: value => resistance_at
    end type resistance_t

contains

    !> Raises unless the tension is above the critical one.
    subroutine check_stability(surface, compliance, error)
        type(surface_t), intent(in) :: surface
        !> of the body without its surface, under a normal load
        class(compliance_t), intent(in), target :: compliance
        type(error_t), allocatable, intent(inout) :: error
        real(wp) :: tension, wave

        if (allocated(error) .or. .not. surface%tension < 0.0_wp) return
        call critical_tension(surface%bending, compliance, tension, wave)
        if (surface%tension > largest_part*tension) return
        call raise(error, error_invalid, "surface tension = "//to_text(surface%tension)// &
                   ": it must be greater than 0.95 tau_c. The surface wrinkles at tau_c = "//to_text(tension)// &
                   " and the wavenumber k_c = "//to_text(in_six_digits(wave)))
    end subroutine check_stability

    !> tau_c < 0 [modulus length] and k_c [1/length].
    subroutine critical_tension(bending, compliance, tension, wave)
        !> B > 0 [modulus length^3]
        real(wp), intent(in) :: bending
        class(compliance_t), intent(in), target :: compliance
        real(wp), intent(out) :: tension, wave
        type(resistance_t) :: resistance
        real(wp) :: usual, place
        integer :: i

        resistance%bending = bending
        resistance%compliance => compliance
        usual = log(0.25_wp*real(compliance%scale, wp)/bending)/3.0_wp
        call find_lowest(resistance, [(usual + log(widest)*(2.0_wp*i/steps - 1.0_wp), i=0, steps)], place, tension)
        wave = exp(place)
        tension = -tension
    end subroutine critical_tension

    !> E0*/(2 k (1 + chi)) + B k^2 at ln k.
    function resistance_at(self, x) result(y)
        class(resistance_t), intent(inout) :: self
        real(wp), intent(in) :: x
        real(wp) :: y
        complex(wp) :: one_plus_chi(1), chi(1)

        call self%compliance%chi([cmplx(exp(x), kind=wp)], one_plus_chi, chi)
        y = 0.5_wp*real(self%compliance%scale, wp)/(exp(x)*real(one_plus_chi(1), wp)) + self%bending*exp(x)**2
    end function resistance_at

end module mdrcontact_tension_stability
