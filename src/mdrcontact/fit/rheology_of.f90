! SPDX-License-Identifier: GPL-3.0-or-later
!> The material of a viscoelastic body that belongs to a vector of parameters. What kind of material it is, and of how many terms, a
!> material says that serves as the pattern.
module mdrcontact_fit_rheology_of
    use mdrcontact_error, only: error_t
    use mdrcontact_kinds, only: wp
    use mdrcontact_material, only: material_t, new_material
    use mdrcontact_material_rheology, only: new_elastic_rheology, new_power_law_rheology, new_viscoelastic, rheology_t
    implicit none (type, external)
    private
    public :: rheology_count, make_rheology
    public :: at_exponent

    !> Parameters of an elastic material: E, nu; of a power law: modulus, time, exponent, nu; of a Prony series: relaxed modulus,
    !> modulus and time of each term, viscosity, and nu or the bulk modulus.
    integer, parameter :: elastic_count = 2, power_law_count = 4, at_exponent = 3

contains

    !> How many parameters a material like the pattern has.
    pure function rheology_count(pattern) result(count)
        type(rheology_t), intent(in) :: pattern
        integer :: count

        if (pattern%is_elastic()) then
            count = elastic_count
        else if (pattern%is_power_law()) then
            count = power_law_count
        else
            count = 3 + 2*size(pattern%shear%rate)
        end if
    end function rheology_count

    !> The material.
    subroutine make_rheology(pattern, values, rheology, error)
        type(rheology_t), intent(in) :: pattern
        !> rheology_count numbers
        real(wp), intent(in) :: values(:)
        type(rheology_t), intent(out) :: rheology
        type(error_t), allocatable, intent(out) :: error
        type(material_t) :: material
        real(wp) :: poisson, bulk
        integer :: n

        n = size(values)
        if (pattern%is_elastic()) then
            call new_material(material, values(1), values(2), error)
            if (.not. allocated(error)) rheology = new_elastic_rheology(material)
        else if (pattern%is_power_law()) then
            call new_power_law_rheology(rheology, values(1), values(2), values(at_exponent), values(4), error)
        else
            poisson = values(n)
            bulk = 0.0_wp
            if (pattern%bulk > 0.0_wp) then
                poisson = 0.0_wp
                bulk = values(n)
            end if
            call new_viscoelastic(rheology, values(1), values(2:n - 2:2), values(3:n - 2:2), values(n - 1), poisson, bulk, error)
        end if
    end subroutine make_rheology

end module mdrcontact_fit_rheology_of
