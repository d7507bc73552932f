! SPDX-License-Identifier: GPL-3.0-or-later
!> A work of adhesion that depends on the speed v of the contact's edge: opening (v > 0) and closing (v < 0) each by a law of
!> their own, theory/adhesion.md (3.1), (3.2); Gent, Schultz, J. Adhesion 3 (1972) 281; Maugis, Barquins, J. Phys. D 11 (1978) 1989:
!>     v > 0:  G = work (1 + (v/speed)^exponent)
!>     v < 0:  G = closing_work/(1 + (|v|/closing_speed)^closing_exponent)
!> Between closing_work and work the edge is at rest. Or both follow from how the surface relaxes, see
!> extensions/adhesion/steady_crack.f90.
module mdrcontact_adhesion_rate_law
    use mdrcontact_error, only: check_made, check_positive, error_invalid, error_t, raise, to_text
    use mdrcontact_adhesion_steady_crack, only: new_steady_crack, steady_crack_t
    use mdrcontact_kinds, only: pi, wp
    use mdrcontact_material_rheology, only: rheology_t
    implicit none (type, external)
    private
    public :: rate_law_t, new_rate_law, new_surface_law

    !> The edge is not followed above this multiple of its speed at twice or half the work.
    real(wp), parameter :: fastest = 1.0e30_wp
    !> Lower limit of G, relative to the closing work: an edge without tension closes at the corresponding speed.
    real(wp), parameter :: least = 1.0e-9_wp

    !> Made by new_rate_law, never changed.
    type :: rate_law_t
        !> whether it was made: set last by what makes it
        logical :: is_made = .false.
        !> G of an edge that begins to open, and of one that begins to close [modulus length]
        real(wp) :: work = 0.0_wp, closing_work = 0.0_wp
        !> speeds at which the work is doubled and halved [length/time]
        real(wp) :: speed = 0.0_wp, closing_speed = 0.0_wp
        !> [1]
        real(wp) :: exponent = 0.0_wp, closing_exponent = 0.0_wp
        !> instead of speeds and exponents
        type(steady_crack_t), allocatable :: crack
        !> work over the square of the cohesive stress [length/modulus]
        real(wp) :: crack_scale = 0.0_wp
    contains
        procedure :: work_at
        procedure :: speed_at
        procedure :: zone
    end type rate_law_t

contains

    !> Checks the numbers.
    subroutine new_rate_law(self, work, speed, exponent, error, closing_work, closing_speed, closing_exponent)
        type(rate_law_t), intent(out) :: self
        !> gamma0 > 0 [modulus length], v0 > 0 [length/time], 0 < n <= 2
        real(wp), intent(in) :: work, speed, exponent
        type(error_t), allocatable, intent(out) :: error
        !> of the closing edge, > 0, at most `work`; speed > 0; 0 < exponent <= 2. Default or 0: those of the opening edge
        real(wp), intent(in), optional :: closing_work, closing_speed, closing_exponent

        self%work = work
        self%speed = speed
        self%exponent = exponent
        self%closing_work = given_or(work, closing_work)
        self%closing_speed = given_or(speed, closing_speed)
        self%closing_exponent = given_or(exponent, closing_exponent)
        call check_positive(error, "work", work)
        call check_positive(error, "speed", speed)
        call check_exponent(error, "exponent", exponent)
        call check_positive(error, "closing_work", self%closing_work)
        call check_positive(error, "closing_speed", self%closing_speed)
        call check_exponent(error, "closing_exponent", self%closing_exponent)
        if (self%closing_work > work) then
            call raise(error, error_invalid, " = "//to_text(self%closing_work)//": it must be at most the work of an opening "// &
                       "edge, work = "//to_text(work), "closing_work")
        end if
        self%is_made = .not. allocated(error)
    end subroutine new_rate_law

    !> The law of a surface whose cohesion does not depend on speed: all loss is in the solid around it.
    subroutine new_surface_law(self, material, work, cohesive_stress, error)
        type(rate_law_t), intent(out) :: self
        !> of the surface layer, with a glassy and a relaxed modulus; the contact itself has the relaxed moduli
        type(rheology_t), intent(in) :: material
        !> > 0 [modulus length], > 0 [modulus]
        real(wp), intent(in) :: work, cohesive_stress
        type(error_t), allocatable, intent(out) :: error

        call check_made(error, "material", material%is_made)
        if (allocated(error)) return
        call check_positive(error, "work", work)
        call check_positive(error, "cohesive_stress", cohesive_stress)
        if (allocated(error)) return
        self%work = work
        self%closing_work = work
        self%crack_scale = work/cohesive_stress**2
        allocate (self%crack)
        call new_steady_crack(self%crack, material, error)
        self%is_made = .not. allocated(error)
    end subroutine new_surface_law

    !> Length of the cohesive zone of a crack at rest in the relaxed surface, pi E* work/(4 sigma_0^2) [length]; 0: not known.
    pure function zone(self) result(length)
        class(rate_law_t), intent(in) :: self
        real(wp) :: length

        length = 0.0_wp
        if (allocated(self%crack)) length = 0.25_wp*pi*self%crack%relaxed_modulus*self%crack_scale
    end function zone

    pure function given_or(default, given) result(value)
        real(wp), intent(in) :: default
        real(wp), intent(in), optional :: given
        real(wp) :: value

        value = default
        if (.not. present(given)) return
        if (given /= 0.0_wp) value = given
    end function given_or

    pure subroutine check_exponent(error, name, value)
        type(error_t), allocatable, intent(inout) :: error
        character(len=*), intent(in) :: name
        real(wp), intent(in) :: value

        if (value > 0.0_wp .and. value <= 2.0_wp) return
        call raise(error, error_invalid, " = "//to_text(value)//": it must be greater than 0 and at most 2", name)
    end subroutine check_exponent

    !> G of an edge of speed v, > 0 where it opens [modulus length]; work at v = 0.
    elemental function work_at(self, v) result(work)
        class(rate_law_t), intent(in) :: self
        !> [length/time]
        real(wp), intent(in) :: v
        real(wp) :: work

        if (allocated(self%crack)) then
            work = self%work*self%crack%ratio_at(v/self%crack_scale)
        else if (v >= 0.0_wp) then
            work = self%work*(1.0_wp + (v/self%speed)**self%exponent)
        else
            work = self%closing_work/(1.0_wp + (-v/self%closing_speed)**self%closing_exponent)
        end if
    end function work_at

    !> v of an edge with energy release rate G >= 0, and dv/dG.
    pure subroutine speed_at(self, g, v, slope)
        class(rate_law_t), intent(in) :: self
        !> [modulus length]
        real(wp), intent(in) :: g
        !> [length/time], and per [modulus length]
        real(wp), intent(out) :: v, slope
        real(wp) :: more

        v = 0.0_wp
        slope = 0.0_wp
        if (allocated(self%crack)) then
            call self%crack%speed_at(g/self%work, v, slope)
            v = v*self%crack_scale
            slope = slope*self%crack_scale/self%work
        else if (g > self%work) then
            more = g/self%work - 1.0_wp
            v = more**(1.0_wp/self%exponent)
            if (.not. v < fastest) then
                v = fastest*self%speed
                return
            end if
            slope = v/(self%exponent*more)*self%speed/self%work
            v = v*self%speed
        else if (g < self%closing_work) then
            more = self%closing_work/max(g, least*self%closing_work) - 1.0_wp
            v = more**(1.0_wp/self%closing_exponent)
            if (g > least*self%closing_work) then
                slope = v/(self%closing_exponent*more)*self%closing_speed*self%closing_work/g**2
            end if
            v = -v*self%closing_speed
        end if
    end subroutine speed_at

end module mdrcontact_adhesion_rate_law
