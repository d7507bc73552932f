! SPDX-License-Identifier: GPL-3.0-or-later
!> E_eff(a) of a body solved exactly, sampled once: one body of a pair whose other body is known by an effective modulus only.
module mdrcontact_medium_sampled_exact
    use mdrcontact_body, only: copy
    use mdrcontact_error, only: error_t
    use mdrcontact_kinds, only: wp
    use mdrcontact_medium_exact, only: layered_exact_t
    use mdrcontact_medium_solver, only: modulus_of_radius_t
    use mdrcontact_medium_tabulated, only: new_medium_from_function, tabulated_medium_t
    implicit none (type, external)
    private
    public :: new_sampled_exact

    !> Sampled up to this many depths of all layers, a tenth of where the exact solution ends: the rest would take most of the time.
    real(wp), parameter :: largest_ratio = 1.0e3_wp
    !> The search for the smallest radius begins at this part of the surface layer's thickness.
    real(wp), parameter :: first_ratio = 1.0e-3_wp
    !> Below the smallest radius E_eff is constant within this, relative.
    real(wp), parameter :: negligible = 1.0e-12_wp

contains

    !> E_eff from radii at which the surface alone is felt to a thousand depths of the layers, or to where the exact solution ends.
    subroutine new_sampled_exact(self, exact, error)
        type(tabulated_medium_t), intent(out) :: self
        !> one body, not a homogeneous one
        type(layered_exact_t), intent(in), target :: exact
        type(error_t), allocatable, intent(out) :: error
        type(modulus_of_radius_t) :: modulus
        type(error_t), allocatable :: beyond
        real(wp) :: smallest, largest, values(2)

        smallest = first_ratio*exact%pressed%first_depth
        do
            call exact%modulus(smallest*[1.0_wp, 0.1_wp], values, error)
            if (allocated(error)) return
            if (abs(values(1) - values(2)) <= negligible*values(2)) exit
            smallest = 0.1_wp*smallest
        end do
        largest = largest_ratio*exact%pressed%last_depth
        do
            call exact%modulus([largest], values(:1), beyond)
            if (.not. allocated(beyond)) exit
            largest = 0.5_wp*largest
        end do
        modulus%medium => exact
        call new_medium_from_function(self, modulus, smallest, largest, error, exact%springs%tolerance, smooth=.true.)
        if (allocated(error)) return
        ! contacts begin at 0: below the first sample the modulus is that of the surface
        self%smallest_radius = 0.0_wp
        self%why_it_ends = ", where the sampled modulus of the exact body ends; take the model exact for both bodies"
        call copy(exact%pressed, self%pressed, error)
        self%is_made = .not. allocated(error)
    end subroutine new_sampled_exact

end module mdrcontact_medium_sampled_exact
