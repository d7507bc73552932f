! SPDX-License-Identifier: GPL-3.0-or-later
!> The area conductance between rough surfaces as a function of their pressure, 1/R_c(p) = scale^-1 conductance(p): proportional to
!> it, or by plastic micro-contacts and the gas between them (theory/conduction.md (4.14)-(4.17)).
module mdrcontact_conduction_rough_law
    use mdrcontact_conduction_bodies, only: conduction_t
    use mdrcontact_error, only: check_made, check_not_negative, check_positive, error_domain, error_invalid, error_t, raise, to_text
    use mdrcontact_kinds, only: pi, wp
    implicit none (type, external)
    private
    public :: rough_law_t, proportional_t, micro_contacts_t, new_micro_contacts, micro_resistance

    !> h = 1.25 k_s m/sigma (p/H)^0.95: Cooper, Mikic and Yovanovich (1969), in the form of Yovanovich (2005).
    real(wp), parameter :: factor = 1.25_wp, exponent = 0.95_wp
    !> At this part of the hardness the mean planes of both surfaces meet.
    real(wp), parameter :: closed = 0.5_wp
    !> Newton's steps for the mean separation, at most.
    integer, parameter :: most_steps = 60

    !> A law of rough surfaces, conductance per area at a pressure.
    type, abstract :: rough_law_t
        !> R_c times the conductance below
        real(wp) :: scale = 1.0_wp
    contains
        procedure(conductance_at_pressure), deferred :: conductance
        procedure(check_of_pressure), deferred :: check
    end type rough_law_t

    abstract interface
        elemental function conductance_at_pressure(self, pressure) result(conductance)
            import :: rough_law_t, wp
            class(rough_law_t), intent(in) :: self
            !> > 0 [modulus]
            real(wp), intent(in) :: pressure
            real(wp) :: conductance
        end function conductance_at_pressure

        !> Raises where the law does not hold up to a pressure.
        pure subroutine check_of_pressure(self, pressure, error)
            import :: error_t, rough_law_t, wp
            class(rough_law_t), intent(in) :: self
            real(wp), intent(in) :: pressure
            type(error_t), allocatable, intent(inout) :: error
        end subroutine check_of_pressure
    end interface

    !> R_c = kappa/p, scale = kappa.
    type, extends(rough_law_t) :: proportional_t
    contains
        procedure :: conductance => pressure_itself
        procedure :: check => check_nothing
    end type proportional_t

    !> R_c = 1/h(p).
    type, extends(rough_law_t) :: micro_contacts_t
        private
        !> 1.25 k_s m/sigma [conductance/length^2]
        real(wp) :: solid = 0.0_wp
        !> sigma [length], H [modulus], k_g [conductance/length], M [length]
        real(wp) :: roughness = 1.0_wp, hardness = 1.0_wp, gas = 0.0_wp, jump = 0.0_wp
    contains
        procedure :: conductance => micro_conductance
        procedure :: check => check_closed
    end type micro_contacts_t

contains

    !> Micro-contacts between two conductors, of which k_s = 2 S_0 is the harmonic mean: 1/S_0 = 1/S_1 + 1/S_2.
    subroutine new_micro_contacts(self, conduction, roughness, slope, hardness, gas, jump, error)
        type(micro_contacts_t), intent(out) :: self
        type(conduction_t), intent(in) :: conduction
        !> sigma > 0, root mean square of the heights of both surfaces together [length]
        real(wp), intent(in) :: roughness
        !> m > 0, mean absolute slope of both together [1]
        real(wp), intent(in) :: slope
        !> H > 0 of the softer body [modulus]
        real(wp), intent(in) :: hardness
        !> k_g >= 0, conductivity of the gas; 0: vacuum [conductance/length]
        real(wp), intent(in) :: gas
        !> M >= 0, lengths over which the temperature jumps at both surfaces, together [length]
        real(wp), intent(in) :: jump
        type(error_t), allocatable, intent(inout) :: error

        call check_positive(error, "roughness", roughness)
        call check_positive(error, "slope", slope)
        call check_positive(error, "hardness", hardness)
        call check_not_negative(error, "gas", gas)
        call check_not_negative(error, "jump", jump)
        if (allocated(error)) return
        if (jump > 0.0_wp .and. .not. gas > 0.0_wp) then
            call raise(error, error_invalid, " = "//to_text(jump)//": temperatures jump at the surfaces of a gas. Give gas, or "// &
                       "omit jump", "jump")
            return
        end if
        self%solid = factor*2.0_wp*conduction%scale*slope/roughness
        self%roughness = roughness
        self%hardness = hardness
        self%gas = gas
        self%jump = jump
    end subroutine new_micro_contacts

    !> R_c at pressures.
    subroutine micro_resistance(conduction, roughness, slope, hardness, gas, jump, pressure, resistance, error)
        type(conduction_t), intent(in) :: conduction
        !> see new_micro_contacts
        real(wp), intent(in) :: roughness, slope, hardness, gas, jump
        !> > 0, below half of the hardness [modulus]
        real(wp), intent(in) :: pressure(:)
        !> [length^2/conductance]
        real(wp), intent(out) :: resistance(:)
        type(error_t), allocatable, intent(out) :: error
        type(micro_contacts_t) :: law
        integer :: i

        resistance = 0.0_wp
        call check_made(error, "conduction", conduction%is_made)
        if (allocated(error)) return
        call new_micro_contacts(law, conduction, roughness, slope, hardness, gas, jump, error)
        if (allocated(error)) return
        do i = 1, size(pressure)
            call check_positive(error, "pressure", pressure(i), i)
            call law%check(pressure(i), error)
            if (allocated(error)) return
        end do
        resistance = law%scale/law%conductance(pressure)
        do i = 1, size(pressure)
            if (allocated(error)) return
            if (resistance(i) >= tiny(1.0_wp) .and. resistance(i) <= huge(1.0_wp)) cycle
            call raise(error, error_domain, " = "//to_text(roughness)//": the resistance exceeds the range of double "// &
                       "precision. Choose other units", "roughness")
        end do
    end subroutine micro_resistance

    elemental function pressure_itself(self, pressure) result(conductance)
        class(proportional_t), intent(in) :: self
        real(wp), intent(in) :: pressure
        real(wp) :: conductance

        associate (unused => self%scale)
        end associate
        conductance = pressure
    end function pressure_itself

    pure subroutine check_nothing(self, pressure, error)
        class(proportional_t), intent(in) :: self
        real(wp), intent(in) :: pressure
        type(error_t), allocatable, intent(inout) :: error

        associate (unused => self%scale, of => pressure, no => error)
        end associate
    end subroutine check_nothing

    !> theory/conduction.md (4.14), (4.16).
    elemental function micro_conductance(self, pressure) result(conductance)
        class(micro_contacts_t), intent(in) :: self
        real(wp), intent(in) :: pressure
        real(wp) :: conductance
        real(wp) :: part

        part = pressure/self%hardness
        conductance = self%solid*part**exponent
        if (self%gas > 0.0_wp) conductance = conductance + self%gas/(self%roughness*separation(part) + self%jump)
    end function micro_conductance

    !> The distance of the mean planes over the roughness: theory/conduction.md (4.15). Newton's method for the logarithm, which is
    !> concave, so that it converges from the second step on from above.
    elemental function separation(part) result(lambda)
        !> p/H, 0 < p/H < 1/2
        real(wp), intent(in) :: part
        real(wp) :: lambda
        real(wp) :: z, scaled, change
        integer :: i

        z = sqrt(max(-log(2.0_wp*part), 0.0_wp))
        do i = 1, most_steps
            scaled = erfc_scaled(z)
            change = 0.5_wp*sqrt(pi)*scaled*(log(scaled) - z**2 - log(2.0_wp*part))
            z = max(z + change, 0.0_wp)
            if (abs(change) <= 4.0_wp*epsilon(z)*z) exit
        end do
        lambda = sqrt(2.0_wp)*z
    end function separation

    pure subroutine check_closed(self, pressure, error)
        class(micro_contacts_t), intent(in) :: self
        real(wp), intent(in) :: pressure
        type(error_t), allocatable, intent(inout) :: error

        if (allocated(error) .or. pressure < closed*self%hardness) return
        call raise(error, error_domain, "hardness = "//to_text(self%hardness)//": it must exceed twice the pressure, which "// &
                   "reaches "//to_text(pressure)//"; there the mean planes of the rough surfaces meet. Reduce the load, or "// &
                   "round the edge of the indenter")
    end subroutine check_closed

end module mdrcontact_conduction_rough_law
