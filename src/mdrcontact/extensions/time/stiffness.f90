! SPDX-License-Identifier: GPL-3.0-or-later
!> The contact stiffness k(a; s) of a viscoelastic body at constant contact radius (theory/time.md (4.1)-(4.3)): at s = i omega the
!> dynamic stiffness, its inverse Laplace transform the response of a flat punch to a step.
module mdrcontact_time_stiffness
    use mdrcontact_body_chain, only: chain_t
    use mdrcontact_body_compliance, only: normal_load
    use mdrcontact_codes, only: step_creep => creep, step_relaxation => relaxation
    use mdrcontact_error, only: check_code, check_made, check_positive, error_domain, error_invalid, error_no_convergence, &
                                error_t, raise, raise_at, to_text
    use mdrcontact_contact_relaxing_contact, only: refuse_attraction, relaxing_contact_t
    use mdrcontact_kinds, only: wp
    use mdrcontact_line_kernel, only: kernel_t
    use mdrcontact_line_part, only: new_part, part_memory_t, part_t
    use mdrcontact_line_shared, only: kernel_cache_t, shared_kernel
    use mdrcontact_line_stiffness, only: relative_stiffness
    use mdrcontact_material, only: moduli_t
    use mdrcontact_medium_viscoelastic, only: viscoelastic_t
    use mdrcontact_model, only: models
    use mdrcontact_numerics_laplace, only: inverse_laplace
    implicit none (type, external)
    private
    public :: dynamic_stiffness, step_response, step_relaxation, step_creep

    !> Nodes of the inverse Laplace transform.
    integer, parameter :: nodes = 16
    real(wp), parameter :: tolerance = 1.0e-13_wp
    !> Largest error of the table of chi. With a dashpot, at times far below its own, layers are millions of times stiffer than
    !> others, and the rounding of their waves is as much larger.
    real(wp), parameter :: allowed_misfit = 1.0e-7_wp
    !> Parts of the sum that may be left out where a body has no kernel: the last nodes lie near the negative axis, where springs
    !> and dashpots nearly cancel.
    real(wp), parameter :: dispensable = 1.0e-11_wp

    !> k(a; s) of one body at one s after the other.
    type :: stiffness_t
        type(kernel_cache_t) :: shared
        complex(wp) :: s = 0.0_wp
        type(kernel_t) :: parts(2)
        !> E0*(s)
        complex(wp) :: surface_modulus = 0.0_wp
    end type stiffness_t

contains

    !> k*(a, omega) = k' + i k'', exact for small oscillations of a contact of radius a.
    subroutine dynamic_stiffness(contact, omega, radius, values, error)
        !> the indenter does not matter beyond how large contacts can be
        type(relaxing_contact_t), intent(in) :: contact
        !> angular frequencies > 0 [1/time], and as many contact radii > 0 [length]
        real(wp), intent(in) :: omega(:), radius(:)
        !> same size as omega [modulus length]
        complex(wp), intent(out) :: values(:)
        type(error_t), allocatable, intent(out) :: error
        type(stiffness_t) :: at
        integer :: i

        values = 0.0_wp
        call check_made(error, "contact", contact%is_made)
        if (allocated(error)) return
        do i = 1, size(omega)
            call check_positive(error, "omega", omega(i), i)
            call check_radius(contact, radius(i), i, error)
            if (allocated(error)) return
        end do
        do i = 1, size(omega)
            call stiffness_at(contact%medium, at, cmplx(0.0_wp, omega(i), wp), radius(i), values(i), error)
            if (.not. allocated(error)) cycle
            call raise_at(error, i)
            return
        end do
    end subroutine dynamic_stiffness

    !> Force per depth [modulus length] at times after a step of the depth at constant contact radius, or depth per force after a
    !> step of the force: a flat punch.
    subroutine step_response(contact, step, time, radius, values, error)
        type(relaxing_contact_t), intent(in) :: contact
        !> step_relaxation or step_creep
        integer, intent(in) :: step
        !> > 0 [time], and one contact radius > 0 [length]
        real(wp), intent(in) :: time(:), radius
        !> same size as time
        real(wp), intent(out) :: values(:)
        type(error_t), allocatable, intent(out) :: error
        type(stiffness_t) :: at
        complex(wp) :: s(nodes), weight(nodes, 1), k, before
        integer :: i, j

        values = 0.0_wp
        call check_made(error, "contact", contact%is_made)
        if (allocated(error)) return
        call check_code(error, "step", step, [step_relaxation, step_creep])
        do i = 1, size(time)
            call check_positive(error, "time", time(i), i)
        end do
        call check_radius(contact, radius, 0, error)
        if (allocated(error)) return
        do i = 1, size(time)
            before = 0.0_wp
            call inverse_laplace(time(i:i), s, weight)
            do j = 1, nodes
                call stiffness_at(contact%medium, at, s(j), radius, k, error)
                if (allocated(error)) then
                    ! the stiffness hardly changes from node to node
                    if (error%code /= error_no_convergence) return
                    if (.not. abs(weight(j, 1)*before) < dispensable*abs(values(i))) return
                    deallocate (error)
                    exit
                end if
                if (step == step_creep) k = 1.0_wp/k
                values(i) = values(i) + aimag(weight(j, 1)*k)
                before = k
            end do
        end do
    end subroutine step_response

    pure subroutine check_radius(contact, radius, entry, error)
        type(relaxing_contact_t), intent(in) :: contact
        real(wp), intent(in) :: radius
        integer, intent(in) :: entry
        type(error_t), allocatable, intent(inout) :: error

        call refuse_attraction(contact, error)
        call check_positive(error, "radius", radius, entry)
        if (allocated(error)) return
        if (radius > contact%equilibrium%medium%largest_radius) then
            call raise(error, error_domain, " = "//to_text(radius)//": the medium is defined up to "// &
                       to_text(contact%equilibrium%medium%largest_radius), "radius", entry)
        end if
    end subroutine check_radius

    !> k(a; s) = 2 a E_eff(a; s).
    subroutine stiffness_at(medium, at, s, radius, value, error)
        type(viscoelastic_t), intent(in) :: medium
        type(stiffness_t), intent(inout) :: at
        complex(wp), intent(in) :: s
        real(wp), intent(in) :: radius
        complex(wp), intent(out) :: value
        type(error_t), allocatable, intent(inout) :: error
        type(moduli_t) :: moduli
        real(wp) :: modulus(1)

        value = 0.0_wp
        associate (top => medium%materials(1))
            if (size(medium%thickness) == 0) then
                moduli = top%moduli_at(s)
                value = 2.0_wp*radius*moduli%contact
            else if (medium%is_proportional) then
                call medium%reference%modulus([radius], modulus, error)
                if (allocated(error)) return
                value = 2.0_wp*radius*modulus(1)*top%complex_shear(s) &
                        /merge(top%modulus, top%shear%instant(), top%is_power_law())
            else if (medium%model /= models%exact) then
                call raise(error, error_invalid, "model: the materials of this body do not relax proportionally. Use the "// &
                           "model exact")
            else
                if (abs(at%s - s) > 0.0_wp) call prepare(medium, at, s, error)
                if (.not. allocated(error)) call relative_stiffness(at%parts, radius, tolerance, .false., value, error)
                value = 2.0_wp*radius*at%surface_modulus*value
            end if
        end associate
    end subroutine stiffness_at

    !> The two kernels at s.
    subroutine prepare(medium, at, s, error)
        type(viscoelastic_t), intent(in) :: medium
        type(stiffness_t), intent(inout) :: at
        complex(wp), intent(in) :: s
        type(error_t), allocatable, intent(inout) :: error
        type(chain_t), target :: chain
        type(part_t) :: part
        type(part_memory_t), target :: memory
        integer :: i

        at%s = 0.0_wp
        call medium%chain_at(normal_load, s, chain, error)
        at%surface_modulus = chain%scale
        do i = 1, 2
            call new_part(part, chain, i == 2, memory)
            if (.not. allocated(error)) call shared_kernel(at%shared, part, at%parts(i), error, allowed_misfit)
            if (allocated(error)) return
        end do
        at%s = s
    end subroutine prepare

end module mdrcontact_time_stiffness
