! SPDX-License-Identifier: GPL-3.0-or-later
!> One or two conductors that exchange a flux through a circular contact area, and the kernels of their springs: compliances of both
!> sides add, 1/S_0 = 1/S_1 + 1/S_2 of the surface layers and X = S_0 (X_1/S_1 + X_2/S_2): theory/conduction.md (3.1).
module mdrcontact_conduction_bodies
    use mdrcontact_conduction_compliance, only: flux_compliance_t, new_flux_compliance
    use mdrcontact_conduction_conductors, only: conductors_t, insulating_base
    use mdrcontact_conduction_sink, only: add_sink
    use mdrcontact_error, only: check_made, check_not_negative, check_positive, error_domain, error_invalid, error_t, raise, &
                                to_text
    use mdrcontact_kinds, only: wp
    use mdrcontact_law_conducting, only: conducting_t
    use mdrcontact_line_combine, only: add_kernels
    use mdrcontact_line_kernel, only: kernel_t
    use mdrcontact_line_shared, only: kernel_cache_t, shared_kernel
    use mdrcontact_numerics_radius_law, only: radius_law_t
    implicit none (type, external)
    private
    public :: conduction_t, new_conduction, tolerance

    !> Relative tolerance of steady conductances.
    real(wp), parameter :: tolerance = 1.0e-11_wp
    !> Largest contact radius over the total depth of the layers.
    real(wp), parameter :: largest_ratio = 1.0e4_wp
    !> The sink lies this many thicknesses of an insulated body beyond the contact area: the potential around it is uniform through
    !> them.
    real(wp), parameter :: nearest_sink = 8.5_wp

    !> To be read only.
    type, extends(conducting_t) :: conduction_t
        !> whether it was made: set last by what makes it
        logical :: is_made = .false.
        !> the lower one and, of two, the upper one
        type(conductors_t), allocatable :: bodies(:)
        !> the steady kernels of the bodies,
        type(kernel_t), allocatable :: kernels(:)
        !> and of both together
        type(kernel_t) :: kernel
        !> S_0 [conductance/length]
        real(wp) :: scale = 1.0_wp
        !> S_0/S_i of each body [1]
        real(wp), allocatable :: share(:)
        !> G(a)/a where it has been tabulated
        type(radius_law_t), allocatable :: table
        !> R_c >= 0, resistance in the contact area
        real(wp) :: film = 0.0_wp
        !> b, where the flux leaves a body on an insulating base; 0: not given
        real(wp) :: sink = 0.0_wp
        !> of contact areas
        real(wp) :: largest_radius = huge(1.0_wp)
        !> whether one of them lies on an insulating base
        logical :: is_insulated = .false.
    contains
        procedure :: conductance => conductance_for_law
        procedure :: check_radius
        procedure :: chi
        procedure :: compliance
        procedure :: radius_in_layers
        procedure :: waves_in
        procedure :: check_steady
    end type conduction_t

    interface
        !> G and dG/da.
        module subroutine conductance_for_law(self, a, conductance, slope, error)
            class(conduction_t), intent(in) :: self
            !> > 0 [length]
            real(wp), intent(in) :: a
            !> [conductance], [conductance/length]
            real(wp), intent(out) :: conductance, slope
            type(error_t), allocatable, intent(inout) :: error
        end subroutine conductance_for_law
    end interface

contains

    !> Checks the numbers and tabulates the kernels, which insulated bodies without a sink do not have.
    subroutine new_conduction(self, bodies, film, sink, error)
        type(conduction_t), intent(out) :: self
        !> one or two
        type(conductors_t), intent(in) :: bodies(:)
        !> R_c >= 0 [length^2/conductance]; b > 0, or 0 without a sink [length]
        real(wp), intent(in) :: film, sink
        type(error_t), allocatable, intent(out) :: error
        integer :: i, n

        call check_made(error, "bodies", all(bodies%is_made))
        if (allocated(error)) return
        call check_not_negative(error, "film", film)
        call check_not_negative(error, "sink", sink)
        if (allocated(error)) return
        n = size(bodies)
        self%film = film
        self%sink = sink
        allocate (self%bodies(n), source=bodies)
        allocate (self%kernels(n), self%share(n))
        self%scale = 1.0_wp/sum([(1.0_wp/bodies(i)%s(1), i=1, n)])
        self%share = [(self%scale/bodies(i)%s(1), i=1, n)]
        do i = 1, n
            if (bodies(i)%layers > 0) self%largest_radius = min(self%largest_radius, largest_ratio*bodies(i)%depth())
            if (bodies(i)%base /= insulating_base) cycle
            self%is_insulated = .true.
            if (sink > 0.0_wp) self%largest_radius = min(self%largest_radius, sink - nearest_sink*bodies(i)%depth())
        end do
        if (sink > 0.0_wp .and. .not. self%is_insulated) then
            call raise(error, error_invalid, " = "//to_text(sink)//": only a body on an insulating base has a sink. Omit it", &
                       "sink")
            return
        end if
        self%is_made = self%is_insulated .and. .not. sink > 0.0_wp
        if (self%is_made) return
        if (.not. self%largest_radius > 0.0_wp) then
            call raise(error, error_domain, " = "//to_text(sink)//": it must be more than "//to_text(nearest_sink)// &
                       " times the thickness of the layers on the insulating base", "sink")
            return
        end if
        call tabulate(self, error)
        self%is_made = .not. allocated(error)
    end subroutine new_conduction

    !> chi of the bodies together.
    elemental function chi(self, k, s)
        class(conduction_t), intent(in) :: self
        !> wavenumber [1/length]; Laplace variable, 0: steady [1/time]
        complex(wp), intent(in) :: k, s
        complex(wp) :: chi
        complex(wp) :: one_plus_chi, part
        integer :: i

        chi = 0.0_wp
        do i = 1, size(self%bodies)
            call self%bodies(i)%response(k, s, one_plus_chi, part)
            chi = chi + self%share(i)*part
        end do
    end function chi

    !> The radius over the thickness of the thinnest first layer; 0 without layers.
    pure function radius_in_layers(self, a) result(ratio)
        class(conduction_t), intent(in) :: self
        !> [length]
        real(wp), intent(in) :: a
        real(wp) :: ratio
        integer :: i

        ratio = 0.0_wp
        do i = 1, size(self%bodies)
            if (self%bodies(i)%layers > 0) ratio = max(ratio, a/self%bodies(i)%h(1))
        end do
    end function radius_in_layers

    !> The radius in lengths of the fastest decay in time; 0 without a capacity.
    pure function waves_in(self, a, s) result(waves)
        class(conduction_t), intent(in) :: self
        !> [length], and |s| [1/time]
        real(wp), intent(in) :: a, s
        real(wp) :: waves
        integer :: i

        waves = 0.0_wp
        do i = 1, size(self%bodies)
            waves = max(waves, sqrt(s*maxval(self%bodies(i)%rate))*a)
        end do
    end function waves_in

    !> C(k): potential over flux at the surface of a wave, of two bodies the sum of both; what lies in the contact area is left out.
    pure subroutine compliance(self, k, omega, values)
        class(conduction_t), intent(in) :: self
        !> wavenumbers > 0 [1/length]
        real(wp), intent(in) :: k(:)
        !> angular frequencies of either sign, same size as k [1/time]
        real(wp), intent(in) :: omega(:)
        !> same size as k [length/conductance]
        complex(wp), intent(out) :: values(:)
        complex(wp) :: one_plus_chi(size(k)), chi(size(k))
        integer :: i

        values = 0.0_wp
        do i = 1, size(self%bodies)
            call self%bodies(i)%response(cmplx(k, kind=wp), cmplx(0.0_wp, abs(omega), wp), one_plus_chi, chi)
            values = values + one_plus_chi/(self%bodies(i)%s(1)*k)
        end do
        where (omega < 0.0_wp) values = conjg(values)
    end subroutine compliance

    subroutine tabulate(self, error)
        type(conduction_t), intent(inout) :: self
        type(error_t), allocatable, intent(inout) :: error
        type(kernel_cache_t) :: shared
        type(flux_compliance_t) :: compliance
        integer :: i

        do i = 1, size(self%bodies)
            associate (body => self%bodies(i))
                call new_flux_compliance(compliance, body)
                ! one insulated layer is its own sheet
                if (body%base /= insulating_base .or. body%layers > 1) then
                    call shared_kernel(shared, compliance, self%kernels(i), error)
                    if (allocated(error)) return
                end if
                if (body%base == insulating_base) call add_sink(self%kernels(i), body%h(1), body%sheet(), self%sink)
            end associate
        end do
        self%kernel = self%kernels(1)
        if (size(self%bodies) == 1) return
        call add_kernels(self%kernels(1), self%kernels(2), self%share, self%kernel, error)
        if (self%is_insulated) self%kernel%one_plus_chi_zero = 1.0_wp
    end subroutine tabulate

    !> Raise an error for unsupported contact radii.
    pure subroutine check_radius(self, a, error)
        class(conduction_t), intent(in) :: self
        !> [length]
        real(wp), intent(in) :: a
        type(error_t), allocatable, intent(inout) :: error

        call check_made(error, "conduction", self%is_made)
        if (allocated(error)) return
        call check_positive(error, "radius", a)
        if (allocated(error) .or. a <= self%largest_radius) return
        call raise(error, error_domain, " = "//to_text(a)//": it must be at most "//to_text(self%largest_radius)// &
                   ", 10000 times the thickness of the layers, and well within the sink of an insulating base", "radius")
    end subroutine check_radius

    !> Raises where nothing steady exists.
    pure subroutine check_steady(self, error)
        class(conduction_t), intent(in) :: self
        type(error_t), allocatable, intent(inout) :: error

        call check_made(error, "conduction", self%is_made)
        if (allocated(error)) return
        if (allocated(error) .or. .not. self%is_insulated .or. self%sink > 0.0_wp) return
        call raise(error, error_invalid, "sink = 0: layers on an insulating base have no steady conductance. Give the radius "// &
                   "of a sink, or use steps and admittances")
    end subroutine check_steady

end module mdrcontact_conduction_bodies
