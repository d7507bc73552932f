! SPDX-License-Identifier: GPL-3.0-or-later
!> An isotropic linear viscoelastic material: how its shear modulus relaxes, and what its Poisson's ratio or bulk modulus is.
!>
!> Laplace transforms of moduli are multiplied by s, so that s = i omega gives the complex modulus and an elastic formula holds
!> between them as it is: theory/time.md (1.5)-(1.7).
module mdrcontact_material_rheology
    use mdrcontact_parameter, only: nature_fraction, nature_not_negative, nature_poisson, parameter_t
    use mdrcontact_error, only: check_made, check_not_negative, check_poisson, check_positive, count_text, error_invalid, &
                                error_t, raise, to_text
    use mdrcontact_kinds, only: wp
    use mdrcontact_material, only: material_t, moduli_t, new_material
    use mdrcontact_material_prony, only: creep_of, creep_t, merged, power_law_series, prony_t
    implicit none (type, external)
    private
    public :: rheology_t, new_viscoelastic, new_power_law_rheology, new_elastic_rheology, same_shape

    !> Relative error of power laws that are written as sums of exponentials.
    real(wp), parameter :: series_tolerance = 5.0e-14_wp

    !> A material. Made by new_..., never changed.
    type :: rheology_t
        !> whether it was made: set last by what makes it
        logical :: is_made = .false.
        !> constant Poisson's ratio, and constant bulk modulus [modulus]: the first holds where the second is 0
        real(wp) :: poisson = 0.0_wp, bulk = 0.0_wp
        !> shear modulus G(t), unless it is a power law
        type(prony_t) :: shear
        !> G(t) = modulus (t/time)^(-exponent); an exponent of 0 means that it is not
        real(wp) :: modulus = 0.0_wp, time = 0.0_wp, exponent = 0.0_wp
    contains
        !> its numbers
        procedure :: parameters
        !> the same kind of material, of as many terms, with other numbers
        procedure :: with_parameters
        !> whether G(t) is a power law, without a glassy and a relaxed limit
        procedure :: is_power_law
        !> whether G does not depend on time
        procedure :: is_elastic
        !> whether a jump of the strain is borne by a finite stress
        procedure :: has_glassy
        !> G(t), the shear relaxation modulus [modulus]
        procedure :: relaxation
        !> J(t), the shear compliance [1/modulus]
        procedure :: creep
        !> s times the Laplace transform of G(t) [modulus]
        procedure :: complex_shear
        !> Poisson's ratio at s [1]
        procedure :: complex_poisson
        procedure :: moduli_at
        procedure :: glassy
        procedure :: relaxed
        procedure :: of_shear
        procedure :: contact_series
        procedure :: between
    end type rheology_t

contains

    !> G(t) = relaxed + sum moduli_i exp(-t/times_i) + viscosity delta(t).
    subroutine new_viscoelastic(self, relaxed, moduli, times, viscosity, poisson, bulk, error)
        type(rheology_t), intent(out) :: self
        !> G(infinity) >= 0, terms > 0 [modulus]
        real(wp), intent(in) :: relaxed, moduli(:)
        !> relaxation times > 0, as many as moduli [time]
        real(wp), intent(in) :: times(:)
        !> of a dashpot in parallel, >= 0 (Kelvin-Voigt) [modulus time]
        real(wp), intent(in) :: viscosity
        !> Poisson's ratio, constant, where bulk = 0; else not used
        real(wp), intent(in) :: poisson
        !> bulk modulus K > 0, constant [modulus]; 0: the Poisson's ratio is constant
        real(wp), intent(in) :: bulk
        type(error_t), allocatable, intent(out) :: error
        type(prony_t) :: series
        integer :: i

        call check_not_negative(error, "relaxed_shear_modulus", relaxed)
        call check_not_negative(error, "viscosity", viscosity)
        do i = 1, size(moduli)
            call check_positive(error, "moduli", moduli(i), i)
            call check_positive(error, "times", times(i), i)
        end do
        if (bulk /= 0.0_wp) then
            call check_positive(error, "bulk_modulus", bulk)
        else
            call check_poisson(error, "nu", poisson)
        end if
        if (allocated(error)) return
        if (.not. relaxed + sum(moduli) > 0.0_wp) then
            call raise(error, error_invalid, "relaxed_shear_modulus = 0: it must be greater than 0 if there are no terms")
        else if (bulk > 0.0_wp .and. viscosity > 0.0_wp) then
            call raise(error, error_invalid, "viscosity = "//to_text(viscosity)//": it excludes a bulk modulus. Give nu")
        end if
        if (allocated(error)) return
        series%limit = relaxed
        series%viscosity = viscosity
        series%weight = moduli
        series%rate = 1.0_wp/times
        self%shear = merged(series)
        self%bulk = bulk
        if (.not. bulk > 0.0_wp) self%poisson = poisson
        self%is_made = .not. allocated(error)
    end subroutine new_viscoelastic

    !> G(t) = modulus (t/time)^(-exponent), a fractional element (springpot).
    subroutine new_power_law_rheology(self, modulus, time, exponent, poisson, error)
        type(rheology_t), intent(out) :: self
        !> shear relaxation modulus at `time`, > 0 [modulus]
        real(wp), intent(in) :: modulus
        !> > 0 [time]
        real(wp), intent(in) :: time
        !> 0 < exponent < 1
        real(wp), intent(in) :: exponent
        !> Poisson's ratio, constant
        real(wp), intent(in) :: poisson
        type(error_t), allocatable, intent(out) :: error

        call check_positive(error, "modulus", modulus)
        call check_positive(error, "time", time)
        call check_poisson(error, "nu", poisson)
        if (.not. (exponent > 0.0_wp .and. exponent < 1.0_wp)) then
            call raise(error, error_invalid, " = "//to_text(exponent)//": it must be greater than 0 (elastic) and less than 1 "// &
                       "(viscous)", "exponent")
        end if
        if (allocated(error)) return
        self%modulus = modulus
        self%time = time
        self%exponent = exponent
        self%poisson = poisson
        allocate (self%shear%weight(0), self%shear%rate(0))
        self%is_made = .not. allocated(error)
    end subroutine new_power_law_rheology

    !> A material without memory.
    pure function new_elastic_rheology(material) result(self)
        type(material_t), intent(in) :: material
        type(rheology_t) :: self

        self%poisson = material%poisson
        self%shear%limit = material%shear()
        allocate (self%shear%weight(0), self%shear%rate(0))
        self%is_made = material%young > 0.0_wp
    end function new_elastic_rheology

    !> Numbers of an elastic material: E, nu; of a power law: modulus, time, exponent, nu; of a Prony series the relaxed modulus,
    !> modulus and time of each term, viscosity, and nu or the bulk modulus.
    pure subroutine parameters(self, list)
        class(rheology_t), intent(in) :: self
        type(parameter_t), allocatable, intent(out) :: list(:)
        type(parameter_t) :: last
        character(len=:), allocatable :: term
        integer :: i

        last = parameter_t("nu", self%poisson, nature_poisson)
        if (self%bulk > 0.0_wp) last = parameter_t("bulk_modulus", self%bulk)
        if (self%is_elastic()) then
            list = [parameter_t("E", 2.0_wp*self%shear%limit*(1.0_wp + self%poisson)), last]
        else if (self%is_power_law()) then
            list = [parameter_t("modulus", self%modulus), parameter_t("time", self%time), &
                    parameter_t("exponent", self%exponent, nature_fraction), last]
        else
            list = [parameter_t("relaxed_shear_modulus", self%shear%limit, nature_not_negative)]
            do i = 1, size(self%shear%rate)
                term = "terms["//count_text(i - 1)//"]."
                list = [list, parameter_t(term//"modulus", self%shear%weight(i)), &
                        parameter_t(term//"time", 1.0_wp/self%shear%rate(i))]
            end do
            list = [list, parameter_t("viscosity", self%shear%viscosity, nature_not_negative), last]
        end if
    end subroutine parameters

    subroutine with_parameters(self, values, rheology, error)
        class(rheology_t), intent(in) :: self
        !> in the order of `parameters`
        real(wp), intent(in) :: values(:)
        type(rheology_t), intent(out) :: rheology
        type(error_t), allocatable, intent(out) :: error
        type(material_t) :: material
        real(wp) :: poisson, bulk
        integer :: n

        call check_made(error, "material", self%is_made)
        if (allocated(error)) return
        n = size(values)
        if (self%is_elastic()) then
            call new_material(material, values(1), values(2), error)
            if (.not. allocated(error)) rheology = new_elastic_rheology(material)
        else if (self%is_power_law()) then
            call new_power_law_rheology(rheology, values(1), values(2), values(3), values(4), error)
        else
            poisson = merge(0.0_wp, values(n), self%bulk > 0.0_wp)
            bulk = merge(values(n), 0.0_wp, self%bulk > 0.0_wp)
            call new_viscoelastic(rheology, values(1), values(2:n - 2:2), values(3:n - 2:2), values(n - 1), poisson, bulk, error)
        end if
    end subroutine with_parameters

    elemental function is_power_law(self) result(answer)
        class(rheology_t), intent(in) :: self
        logical :: answer

        answer = self%exponent > 0.0_wp
    end function is_power_law

    elemental function has_glassy(self) result(answer)
        class(rheology_t), intent(in) :: self
        logical :: answer

        answer = .not. self%is_power_law() .and. .not. self%shear%viscosity > 0.0_wp
    end function has_glassy

    elemental function is_elastic(self) result(answer)
        class(rheology_t), intent(in) :: self
        logical :: answer

        answer = self%has_glassy() .and. size(self%shear%rate) == 0
    end function is_elastic

    !> G(t), at t = 0 the glassy one [modulus].
    elemental function relaxation(self, t) result(value)
        class(rheology_t), intent(in) :: self
        !> >= 0, and > 0 of a power law or with a dashpot in parallel, whose G(0) is infinite [time]
        real(wp), intent(in) :: t
        real(wp) :: value

        if (self%is_power_law()) then
            value = self%modulus*(t/self%time)**(-self%exponent)
        else
            value = self%shear%at(t)
        end if
    end function relaxation

    !> J(t), the shear compliance: strain under a constant stress of 1, at t = 0 that of the sudden load [1/modulus].
    pure function creep(self, t) result(values)
        class(rheology_t), intent(in) :: self
        !> >= 0 [time]
        real(wp), intent(in) :: t(:)
        real(wp) :: values(size(t))
        type(creep_t) :: series
        integer :: i

        if (self%is_power_law()) then
            values = (t/self%time)**self%exponent/(self%modulus*gamma(1.0_wp - self%exponent)*gamma(1.0_wp + self%exponent))
        else
            series = creep_of(self%shear)
            do i = 1, size(t)
                values(i) = series%at(t(i))
            end do
        end if
    end function creep

    !> Q(s) of the shear modulus [modulus]; G*(omega) at s = i omega.
    elemental function complex_shear(self, s) result(value)
        class(rheology_t), intent(in) :: self
        !> real part >= 0, s = i omega of an oscillation [1/time]
        complex(wp), intent(in) :: s
        complex(wp) :: value

        if (self%is_power_law()) then
            value = self%modulus*gamma(1.0_wp - self%exponent)*(s*self%time)**self%exponent
        else
            value = self%shear%transform(s)
        end if
    end function complex_shear

    !> Poisson's ratio at s.
    elemental function complex_poisson(self, s) result(value)
        class(rheology_t), intent(in) :: self
        !> as of complex_shear [1/time]
        complex(wp), intent(in) :: s
        complex(wp) :: value
        complex(wp) :: shear

        value = self%poisson
        if (.not. self%bulk > 0.0_wp) return
        shear = self%complex_shear(s)
        value = (3.0_wp*self%bulk - 2.0_wp*shear)/(2.0_wp*(3.0_wp*self%bulk + shear))
    end function complex_poisson

    !> The moduli at s.
    elemental function moduli_at(self, s) result(moduli)
        class(rheology_t), intent(in) :: self
        !> as of complex_shear [1/time]
        complex(wp), intent(in) :: s
        type(moduli_t) :: moduli

        moduli%shear = self%complex_shear(s)
        moduli%poisson = self%complex_poisson(s)
        moduli%contact = 2.0_wp*moduli%shear/(1.0_wp - moduli%poisson)
    end function moduli_at

    !> The elastic material of a sudden load.
    subroutine glassy(self, material, error)
        class(rheology_t), intent(in) :: self
        type(material_t), intent(out) :: material
        type(error_t), allocatable, intent(out) :: error

        call check_made(error, "material", self%is_made)
        if (allocated(error)) return
        if (self%is_power_law()) then
            call raise(error, error_invalid, "limit: a power law has no glassy modulus, because its modulus diverges at short "// &
                "times")
        else if (self%shear%viscosity > 0.0_wp) then
            call raise(error, error_invalid, "limit: a material with a parallel dashpot has no glassy modulus")
        else
            call self%of_shear(self%shear%instant(), material, error)
        end if
    end subroutine glassy

    !> The elastic material of a load that has lasted.
    subroutine relaxed(self, material, error)
        class(rheology_t), intent(in) :: self
        type(material_t), intent(out) :: material
        type(error_t), allocatable, intent(out) :: error

        call check_made(error, "material", self%is_made)
        if (allocated(error)) return
        if (self%is_power_law() .or. .not. self%shear%limit > 0.0_wp) then
            call raise(error, error_invalid, "limit: this material has no relaxed modulus, because it is a liquid")
        else
            call self%of_shear(self%shear%limit, material, error)
        end if
    end subroutine relaxed

    !> The elastic material of a shear modulus that this one has at some time.
    subroutine of_shear(self, shear, material, error)
        class(rheology_t), intent(in) :: self
        !> > 0 [modulus]
        real(wp), intent(in) :: shear
        type(material_t), intent(out) :: material
        type(error_t), allocatable, intent(out) :: error
        real(wp) :: poisson

        call check_made(error, "material", self%is_made)
        if (allocated(error)) return
        poisson = self%poisson
        if (self%bulk > 0.0_wp) poisson = (3.0_wp*self%bulk - 2.0_wp*shear)/(2.0_wp*(3.0_wp*self%bulk + shear))
        call new_material(material, 2.0_wp*shear*(1.0_wp + poisson), poisson, error)
    end subroutine of_shear

    !> The contact modulus E*(t) of a half-space as a sum of exponentials. With a constant bulk modulus
    !> E* = Q + 9K/4 - (27 K^2/4)/(3K + 4Q), whose last part is a compliance.
    function contact_series(self, shortest, longest, tolerance) result(series)
        class(rheology_t), intent(in) :: self
        !> times between which a power law is to hold, > 0 [time]
        real(wp), intent(in) :: shortest, longest
        !> relative, of a power law; default that of rounding
        real(wp), intent(in), optional :: tolerance
        type(prony_t) :: series
        type(prony_t) :: mixed
        type(creep_t) :: part
        real(wp) :: factor, accuracy

        if (self%is_power_law()) then
            accuracy = series_tolerance
            if (present(tolerance)) accuracy = max(accuracy, tolerance)
            series = power_law_series(self%time, self%exponent, shortest, longest, accuracy)
            series%weight = series%weight*self%modulus
            series%viscosity = series%viscosity*self%modulus
        else
            series = self%shear
        end if
        if (self%bulk > 0.0_wp) then
            mixed = series
            mixed%limit = 3.0_wp*self%bulk + 4.0_wp*series%limit
            mixed%weight = 4.0_wp*series%weight
            part = creep_of(mixed)
            factor = 6.75_wp*self%bulk**2
            series%limit = series%limit + 9.0_wp*self%bulk*series%limit/mixed%limit
            series%weight = [series%weight, factor*part%weight]
            series%rate = [series%rate, part%rate]
            series = merged(series)
        else
            factor = 2.0_wp/(1.0_wp - self%poisson)
            series%limit = factor*series%limit
            series%weight = factor*series%weight
            series%viscosity = factor*series%viscosity
        end if
    end function contact_series

    !> A material with a glassy and a relaxed modulus that answers as this one between two times: a power law is a sum of
    !> exponentials, a dashpot in parallel relaxes before the first time, a liquid carries load long after the last.
    function between(self, shortest, longest, tolerance) result(solid)
        class(rheology_t), intent(in) :: self
        !> > 0 [time]
        real(wp), intent(in) :: shortest, longest
        !> relative, of the modulus of a power law at the longest time
        real(wp), intent(in) :: tolerance
        type(rheology_t) :: solid
        real(wp), parameter :: at_once = 40.0_wp, hardly = 1.0e-12_wp
        real(wp) :: rate

        solid%poisson = self%poisson
        solid%bulk = self%bulk
        solid%shear = self%shear
        solid%is_made = self%is_made
        if (self%is_power_law()) then
            solid%shear = power_law_series(self%time, self%exponent, shortest, longest, tolerance)
            solid%shear%weight = solid%shear%weight*self%modulus
            solid%shear%viscosity = solid%shear%viscosity*self%modulus
        end if
        if (solid%shear%viscosity > 0.0_wp) then
            rate = 2.0_wp*max(at_once/shortest, maxval([0.0_wp, solid%shear%rate]))
            solid%shear%weight = [solid%shear%weight, solid%shear%viscosity*rate]
            solid%shear%rate = [solid%shear%rate, rate]
            solid%shear%viscosity = 0.0_wp
        end if
        if (.not. solid%shear%limit > 0.0_wp) solid%shear%limit = hardly/maxval(self%creep([longest]))
    end function between

    !> Whether two materials relax proportionally, each at a constant Poisson's ratio.
    pure function same_shape(one, other) result(answer)
        type(rheology_t), intent(in) :: one, other
        logical :: answer
        real(wp), parameter :: tolerance = 1.0e-13_wp
        real(wp) :: ratio

        answer = .not. (one%bulk > 0.0_wp .or. other%bulk > 0.0_wp)
        answer = answer .and. size(one%shear%rate) == size(other%shear%rate)
        if (.not. answer) return
        if (one%is_power_law() .or. other%is_power_law()) then
            answer = abs(one%exponent - other%exponent) <= tolerance
            return
        end if
        ratio = other%shear%instant()/one%shear%instant()
        answer = close(one%shear%limit*ratio, other%shear%limit) .and. &
                 close(one%shear%viscosity*ratio, other%shear%viscosity) .and. &
                 all(close(one%shear%weight*ratio, other%shear%weight)) .and. all(close(one%shear%rate, other%shear%rate))

    contains

        elemental function close(x, y) result(answer)
            real(wp), intent(in) :: x, y
            logical :: answer

            answer = abs(x - y) <= tolerance*max(abs(x), abs(y))
        end function close

    end function same_shape

end module mdrcontact_material_rheology
