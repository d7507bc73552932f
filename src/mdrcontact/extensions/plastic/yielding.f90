! SPDX-License-Identifier: GPL-3.0-or-later
!> A material that yields: isotropic elasticity and a yield stress, constant or rising with the plastic strain.
module mdrcontact_plastic_yielding
    use mdrcontact_error, only: check_memory, check_not_negative, check_positive, check_same_size, check_within, error_domain, &
                                error_invalid, error_t, raise, to_text
    use mdrcontact_kinds, only: pi, wp
    use mdrcontact_material, only: material_t
    use mdrcontact_plastic_virgin, only: largest_load, largest_poisson, new_virgin, virgin_t
    implicit none (type, external)
    private
    public :: yielding_t, new_yielding, new_elastic, are_equal, yield_stress_from_hardness, tabor, fall_of_hardness, largest_slope

    !> Representative strain of a contact over a/R (Tabor).
    real(wp), parameter :: tabor = 0.2_wp
    !> Hardness over yield stress without a/R, and the error of that: P is 2.6 to 3.01 for 23 <= L <= 250.
    real(wp), parameter :: hardness_ratio = 2.8_wp, ratio_error = 0.08_wp
    !> Error of the mean pressure of the law.
    real(wp), parameter :: pressure_error = 3.0e-3_wp
    !> The hardness of spheres falls by this times (a/R)^2: 1.6, 6, 13 % at 0.1, 0.2, 0.3, the largest a/R. Up to the small one that
    !> is left out.
    real(wp), parameter :: fall_of_hardness = 1.45_wp, largest_slope = 0.3_wp, small_slope = 0.1_wp

    !> A material and its yield stress over the plastic strain: linear between the points, constant below and above them. Without
    !> points it does not yield.
    type :: yielding_t
        !> the elastic material
        type(material_t) :: material
        !> plastic strains [1], rising, and the yield stress at each [modulus], not falling
        real(wp), allocatable :: strain(:), stress(:)
        !> whether it was made: set last by what makes it
        logical :: is_made = .false.
    contains
        procedure :: stress_at
        procedure :: reach
    end type yielding_t

contains

    !> A material with a yield stress at each of some plastic strains; one point is perfect plasticity.
    pure subroutine new_yielding(self, material, strain, stress, error)
        type(yielding_t), intent(out) :: self
        !> isotropic, 0 <= nu <= 0.49
        type(material_t), intent(in) :: material
        !> >= 0, rising [1]; as many > 0, not falling [modulus]
        real(wp), intent(in) :: strain(:), stress(:)
        type(error_t), allocatable, intent(out) :: error
        integer :: i, stat

        call check_same_size(error, size(strain), size(stress))
        if (.not. material%is_plain) call raise(error, error_invalid, "material: it must be isotropic and free of stress")
        call check_positive(error, "E", material%young)
        call check_within(error, "nu", material%poisson, 0.0_wp, largest_poisson)
        if (size(strain) == 0) call raise(error, error_invalid, "hardening: it is empty. Give at least one point")
        do i = 1, size(strain)
            if (allocated(error)) return
            call check_not_negative(error, "strain", strain(i), entry=merge(i, 0, size(strain) > 1))
            call check_positive(error, "yield_stress", stress(i), entry=merge(i, 0, size(strain) > 1))
            if (i > 1 .and. .not. allocated(error)) call check_rising(strain(i - 1:i), stress(i - 1:i), i, error)
        end do
        if (allocated(error)) return
        allocate (self%strain(size(strain)), self%stress(size(strain)), stat=stat)
        call check_memory(error, stat)
        if (allocated(error)) return
        self%material = material
        self%strain(:) = strain
        self%stress(:) = stress
        self%is_made = .not. allocated(error)
    end subroutine new_yielding

    !> A material that does not yield.
    pure subroutine new_elastic(self, material, error)
        type(yielding_t), intent(out) :: self
        !> isotropic
        type(material_t), intent(in) :: material
        type(error_t), allocatable, intent(out) :: error

        if (.not. material%is_plain) call raise(error, error_invalid, "material: it must be isotropic and free of stress")
        self%material = material
        allocate (self%strain(0), self%stress(0))
        self%is_made = .not. allocated(error)
    end subroutine new_elastic

    !> Raises unless the strain rises, the stress does not fall, and it rises less than proportionally to the strain.
    pure subroutine check_rising(strain, stress, i, error)
        real(wp), intent(in) :: strain(2), stress(2)
        integer, intent(in) :: i
        type(error_t), allocatable, intent(inout) :: error

        if (.not. strain(2) > strain(1)) then
            call raise(error, error_invalid, " = "//to_text(strain(2))//": strains must rise. Sort the points", "strain", i)
        else if (stress(2) < stress(1)) then
            call raise(error, error_invalid, " = "//to_text(stress(2))//": yield stresses must not fall. Softening has no "// &
                       "contact law here", "yield_stress", i)
        else if (.not. strain(2)*stress(1) > strain(1)*stress(2)) then
            call raise(error, error_invalid, " = "//to_text(stress(2))//": it must rise less than proportionally to the "// &
                       "strain, or the contact does not yield further. Give the yield stress at strain 0 first", "yield_stress", i)
        end if
    end subroutine check_rising

    !> Y at a plastic strain.
    pure function stress_at(self, strain) result(stress)
        class(yielding_t), intent(in) :: self
        !> >= 0 [1]
        real(wp), intent(in) :: strain
        real(wp) :: stress
        integer :: i

        i = count(self%strain <= strain)
        if (i == 0 .or. i == size(self%strain)) then
            stress = self%stress(max(i, 1))
        else
            stress = self%stress(i) + (self%stress(i + 1) - self%stress(i))*(strain - self%strain(i)) &
                     /(self%strain(i + 1) - self%strain(i))
        end if
    end function stress_at

    !> The strain at which strain/Y(strain) has a value: it rises with the strain.
    pure function reach(self, ratio) result(strain)
        class(yielding_t), intent(in) :: self
        !> >= 0 [1/modulus]
        real(wp), intent(in) :: ratio
        real(wp) :: strain
        real(wp) :: rise
        integer :: i

        i = count(self%strain <= ratio*self%stress)
        if (i == 0 .or. i == size(self%strain)) then
            strain = ratio*self%stress(max(i, 1))
        else
            rise = (self%stress(i + 1) - self%stress(i))/(self%strain(i + 1) - self%strain(i))
            strain = ratio*(self%stress(i) - rise*self%strain(i))/(1.0_wp - ratio*rise)
        end if
    end function reach

    !> Whether two materials have the same numbers.
    pure function are_equal(one, other) result(equal)
        type(yielding_t), intent(in) :: one, other
        logical :: equal

        equal = one%material%young == other%material%young .and. one%material%poisson == other%material%poisson .and. &
                size(one%strain) == size(other%strain)
        if (equal) equal = all(one%strain == other%strain) .and. all(one%stress == other%stress)
    end function are_equal

    !> Y from a hardness, the mean pressure of a contact, and its relative error: by H = Y P(a E*/(R Y)) where a/R is known, else
    !> by H = 2.8 Y, Tabor's rule.
    pure subroutine yield_stress_from_hardness(material, hardness, inclination, stress, relative_error, error)
        type(material_t), intent(in) :: material
        !> H > 0 [modulus]
        real(wp), intent(in) :: hardness
        !> a/R of the contact in which H was measured [1]; 0: not known
        real(wp), intent(in) :: inclination
        !> Y [modulus], and its error [1]
        real(wp), intent(out) :: stress, relative_error
        type(error_t), allocatable, intent(out) :: error
        type(virgin_t) :: virgin
        real(wp) :: slope, low, high, load, near(2), unused(3), miss
        integer :: i

        stress = hardness/hardness_ratio
        relative_error = ratio_error
        call check_positive(error, "hardness", hardness)
        call check_not_negative(error, "radius_ratio", inclination)
        if (inclination > largest_slope) call raise(error, error_domain, " = "//to_text(inclination)//": it must be at most "// &
                                                    "0.3, where hardness has fallen by 13 %. Leave it out", "radius_ratio")
        if (allocated(error) .or. inclination == 0.0_wp) return
        call new_virgin(virgin, material%poisson, error)
        if (allocated(error)) return
        ! P/L falls with L
        slope = hardness/(inclination*material%contact())
        low = virgin%first_yield
        high = largest_load
        call virgin%at(high, near(1), unused(1), unused(2), unused(3))
        if (.not. slope < 4.0_wp/(3.0_wp*pi)) then
            call raise(error, error_domain, " = "//to_text(hardness)//": it is at least the mean pressure of an elastic "// &
                       "contact, "//to_text(4.0_wp/(3.0_wp*pi)*inclination*material%contact())//". Nothing yields at this a/R", &
                       "hardness")
        else if (slope < near(1)/high) then
            call raise(error, error_domain, " = "//to_text(hardness)//": a E*/(R Y) of this contact exceeds "// &
                       to_text(largest_load)//". Omit a/R: H = 2.8 Y then has an error of 8 %", "hardness")
        end if
        if (allocated(error)) return
        do i = 1, 60
            load = sqrt(low*high)
            call virgin%at(load, near(1), unused(1), unused(2), unused(3))
            if (near(1) > slope*load) then
                low = load
            else
                high = load
            end if
        end do
        stress = inclination*material%contact()/load
        call virgin%at(load*1.001_wp, near(2), unused(1), unused(2), unused(3))
        miss = pressure_error
        if (inclination > small_slope) miss = miss + fall_of_hardness*inclination**2
        relative_error = miss/max(1.0_wp - log(near(2)/near(1))/log(1.001_wp), miss)
    end subroutine yield_stress_from_hardness

end module mdrcontact_plastic_yielding
