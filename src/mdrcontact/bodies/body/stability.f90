! SPDX-License-Identifier: GPL-3.0-or-later
!> Whether the surface of a body under stress stays flat, and the stress of a layer at which it wrinkles
!> (theory/surfaces.md (4.3), (7.1)).
!>
!> Equilibrium is stable while the stiffness 1/(k C(k)) of every wave is positive, and with it what holds every place inside: a
!> layer that buckles many wavelengths below the surface hardly shows there.
module mdrcontact_body_stability
    use mdrcontact_body, only: body_t
    use mdrcontact_body_chain, only: chain_t
    use mdrcontact_body_compliance, only: compliance_t, normal_load
    use mdrcontact_error, only: error_invalid, error_t, raise, to_text
    use mdrcontact_kinds, only: pi, wp
    use mdrcontact_numerics_lowest, only: find_lowest, in_six_digits
    use mdrcontact_numerics_scalar_function, only: scalar_function_t
    implicit none (type, external)
    private
    public :: check_stable, softest_wave

    !> Octaves of k h below and above 1 that are considered, further above it if a layer is thinner than that at the surface, and
    !> waves in each.
    integer, parameter :: lowest = -30, highest = 5, in_octave = 8

    !> Stiffness of waves against the logarithm of their wavenumbers.
    type, extends(scalar_function_t) :: stiffness_t
        class(compliance_t), allocatable :: compliance
    contains
        procedure :: value => stiffness_at
    end type stiffness_t

contains

    !> Raises if some wave has no stiffness.
    subroutine check_stable(body, error)
        class(body_t), intent(in) :: body
        type(error_t), allocatable, intent(inout) :: error
        real(wp) :: k, stiffness

        if (allocated(error) .or. .not. body%first_depth > 0.0_wp) return
        call softest_wave(body, k, stiffness, error)
        if (allocated(error) .or. stiffness > 0.0_wp) return
        call raise(error, error_invalid, "prestress: under this compression the surface wrinkles, at the wavelength "// &
                   to_text(in_six_digits(2.0_wp*pi/k)))
    end subroutine check_stable

    !> The wave that the body opposes least: at the surface next to a half-space of its material, 1/one_plus_chi(k), or inside.
    subroutine softest_wave(body, k, stiffness, error)
        class(body_t), intent(in) :: body
        !> its wavenumber [1/length], and how stiff the body is to it [1], 0 or less where it is unstable
        real(wp), intent(out) :: k, stiffness
        type(error_t), allocatable, intent(inout) :: error
        type(stiffness_t) :: of_wave
        real(wp), allocatable :: octaves(:)
        real(wp) :: place
        integer :: i, more

        k = 1.0_wp
        stiffness = 1.0_wp
        call body%compliance(normal_load, of_wave%compliance, error)
        if (allocated(error)) return
        more = 0
        select type (chain => of_wave%compliance)
        class is (chain_t)
            more = max(0, ceiling(log(body%first_depth/chain%thinnest())/log(2.0_wp)))
        end select
        octaves = [(log(2.0_wp)*(lowest + real(i, wp)/in_octave) - log(body%first_depth), i=0, (highest + more - lowest)*in_octave)]
        call find_lowest(of_wave, octaves, place, stiffness)
        k = exp(place)
    end subroutine softest_wave

    !> At ln k.
    function stiffness_at(self, x) result(y)
        class(stiffness_t), intent(inout) :: self
        real(wp), intent(in) :: x
        real(wp) :: y
        complex(wp) :: one_plus_chi(1), chi(1)

        call self%compliance%chi([cmplx(exp(x), kind=wp)], one_plus_chi, chi)
        y = 1.0_wp/real(one_plus_chi(1), wp)
        select type (chain => self%compliance)
        class is (chain_t)
            y = min(y, chain%least_support(exp(x)))
        end select
    end function stiffness_at

end module mdrcontact_body_stability
