! SPDX-License-Identifier: GPL-3.0-or-later
!> What a body under a surface with tension or a sheet does not answer, and why.
module mdrcontact_medium_sheeted
    use mdrcontact_error, only: error_invalid, error_t, raise
    use mdrcontact_kinds, only: wp
    use mdrcontact_layered_kernel, only: kernel_t
    use mdrcontact_medium_load, only: load_t
    use mdrcontact_medium_slip, only: slip_t
    use mdrcontact_medium_solver, only: solver_t
    use mdrcontact_profile, only: profile_t
    implicit none (type, external)
    private
    public :: sheeted_t

    !> States it has; what needs springs, or another law of the surface, it refuses.
    type, abstract, extends(solver_t) :: sheeted_t
    contains
        procedure :: energies
        procedure :: surface_load
        procedure :: new_tangential
        procedure :: torsional_stiffness
        procedure :: new_slip
        procedure :: disc_products
        procedure :: springs
        procedure :: interaction
    end type sheeted_t

contains

    pure subroutine refuse(what, why, error)
        !> with its verb
        character(len=*), intent(in) :: what, why
        type(error_t), allocatable, intent(inout) :: error

        call raise(error, error_invalid, what//" not known under a surface with tension or a sheet: "//why)
    end subroutine refuse

    subroutine energies(self, profile, a, excess, values, error)
        class(sheeted_t), intent(in) :: self
        class(profile_t), intent(in) :: profile
        real(wp), intent(in) :: a, excess
        real(wp), intent(out) :: values(2)
        type(error_t), allocatable, intent(out) :: error

        associate (unused => self, also_unused => profile, unused_too => a + excess)
        end associate
        values = 0.0_wp
        call refuse("the elastic energy of a body is", "the surface holds a part of it; int F dd is that of both", error)
    end subroutine energies

    subroutine surface_load(self, profile, a, excess, load, error)
        class(sheeted_t), intent(in) :: self
        class(profile_t), intent(in) :: profile
        real(wp), intent(in) :: a, excess
        class(load_t), allocatable, intent(inout) :: load
        type(error_t), allocatable, intent(out) :: error

        associate (unused => self, also_unused => profile, unused_too => a + excess, this_too => load)
        end associate
        call refuse("stresses inside are", "the body is loaded beside the contact, too, by what the surface hands on", error)
    end subroutine surface_load

    subroutine new_tangential(self, tangential, error)
        class(sheeted_t), intent(in) :: self
        class(solver_t), allocatable, intent(out) :: tangential
        type(error_t), allocatable, intent(out) :: error

        associate (unused => self)
        end associate
        call refuse("the tangential stiffness is", "what the surface does to a shift is not part of the theory", error)
        if (.not. allocated(error)) allocate (tangential, source=self)
    end subroutine new_tangential

    subroutine torsional_stiffness(self, a, values, error)
        class(sheeted_t), intent(in) :: self
        real(wp), intent(in) :: a(:)
        real(wp), intent(out) :: values(:)
        type(error_t), allocatable, intent(out) :: error

        associate (unused => self, also_unused => a)
        end associate
        values = 0.0_wp
        call refuse("the torsional stiffness is", "what the surface does to a twist is not part of the theory", error)
    end subroutine torsional_stiffness

    subroutine new_slip(self, tangential, profile, a, excess, slip, error)
        class(sheeted_t), intent(in) :: self
        class(solver_t), intent(in) :: tangential
        class(profile_t), intent(in) :: profile
        real(wp), intent(in) :: a, excess
        class(slip_t), allocatable, intent(out) :: slip
        type(error_t), allocatable, intent(out) :: error

        associate (unused => self, also_unused => tangential, unused_too => profile, and_this => a + excess)
        end associate
        if (allocated(slip)) return
        call refuse("friction is", "what the surface does to a shift is not part of the theory", error)
    end subroutine new_slip

    subroutine disc_products(self, radius, radii, products, error)
        class(sheeted_t), intent(in) :: self
        real(wp), intent(in) :: radius
        real(wp), intent(in) :: radii(:)
        real(wp), intent(out) :: products(:)
        type(error_t), allocatable, intent(inout) :: error

        associate (unused => self, unused_too => radius + sum(radii))
        end associate
        products = 0.0_wp
        call refuse("histories of friction on rings are", "what the surface does to a shift is not part of the theory", error)
    end subroutine disc_products

    subroutine springs(self, kernel, modulus, tolerance, error)
        class(sheeted_t), intent(in) :: self
        type(kernel_t), intent(out) :: kernel
        real(wp), intent(out) :: modulus, tolerance
        type(error_t), allocatable, intent(inout) :: error

        associate (unused => self, also_unused => kernel)
        end associate
        modulus = 0.0_wp
        tolerance = 0.0_wp
        call refuse("the load of a cohesive zone (cohesive_stress) is", "it has no springs, or nearly singular ones", error)
    end subroutine springs

    subroutine interaction(self, a, most, modulus, matrix, error)
        class(sheeted_t), intent(in) :: self
        real(wp), intent(in) :: a
        integer, intent(in) :: most
        real(wp), intent(out) :: modulus
        real(wp), allocatable, intent(out) :: matrix(:, :)
        type(error_t), allocatable, intent(inout) :: error

        associate (unused => self, also_unused => a, unused_too => most)
        end associate
        modulus = 0.0_wp
        call refuse("the wear of a sliding indenter is", "it has no springs, or nearly singular ones", error)
        allocate (matrix(0, 0))
    end subroutine interaction

end module mdrcontact_medium_sheeted
