! SPDX-License-Identifier: GPL-3.0-or-later
!> Response of the surface of a body to one load in Hankel space: u(k) = S(k) p(k), k S(k) = (2/S0)(1 + chi(k)).
!>
!> S0 is the modulus of the surface material under this load, so that chi vanishes for short waves, which do not reach beyond it:
!> E0* = 2 G0/(1 - nu0) of a normal load; G0* = 4 G0/(2 - nu0) of a load of one direction along the surface, as far as its
!> displacement along itself is axisymmetric; 4 G0 of one around the axis. The second and the third are made of the compliances
!> of plane waves in their plane and across it,
!>     chi_t = [(1 - nu0) chi_L + chi_T]/(2 - nu0)   and   chi_T   (theory/friction.md (2.2), (2.3)).
!> one_plus_chi and chi are analytic in a sector around the positive k axis.
module mdrcontact_body_compliance
    use mdrcontact_object, only: object_t
    use mdrcontact_codes, only: coupling_load => load_coupling, normal_load => load_normal, &
                                shear_load => load_shear, twist_load => load_twist
    use mdrcontact_error, only: error_invalid, error_t, raise
    use mdrcontact_kinds, only: wp
    use mdrcontact_material, only: moduli_t
    implicit none (type, external)
    private
    public :: compliance_t, plane_compliance_t, coupling_load, normal_load, shear_load, twist_load, along, normal_to

    !> Directions in the plane of a wave: along the surface and normal to it.
    integer, parameter :: along = 1, normal_to = 2

    !> The compliance under one load. Its numbers must only be read.
    type, abstract, extends(object_t) :: compliance_t
        !> S0 [modulus]
        complex(wp) :: scale = 1.0_wp
        !> one_plus_chi(0): 0 on a rigid base [1]
        complex(wp) :: at_zero = 1.0_wp
        !> depth of the first interface, 0 where chi vanishes, and that below which the body is homogeneous, or rigid [length]
        real(wp) :: first_depth = 0.0_wp, last_depth = 0.0_wp
        !> whether chi at many wavenumbers takes longer than a table of it
        logical :: is_costly = .false.
    contains
        !> one_plus_chi and chi at wavenumbers, each to full relative precision as far as it is known
        procedure(chi_at), deferred :: chi
        !> one_plus_chi of what short waves meet, and what the body adds to it, which decays with the depth of the first interface
        procedure :: split
        !> of a normal load: displacement along a wave over that of the surface's half-space along the normal
        procedure :: coupling => no_coupling
        !> the shortest and the longest length in it, 0 of a half-space [length]
        procedure :: lengths => depths
        !> numbers without a unit that determine it but for length and stiffness; none if that takes too many
        procedure :: key => none
    end type compliance_t

    !> A compliance that is made of those of plane waves.
    type, abstract, extends(compliance_t) :: plane_compliance_t
        integer :: load = normal_load
        !> parts of chi_L and chi_T under a load along the surface, together 1
        complex(wp) :: in_plane = 0.0_wp, across = 0.0_wp
    contains
        procedure :: chi => chi_of_waves
        procedure, non_overridable :: set_load
        !> under a load in the plane of the wave, `along` or `normal_to` the surface
        procedure(in_plane_at), deferred :: chi_in_plane
        !> under a load across it
        procedure(across_at), deferred :: chi_across
    end type plane_compliance_t

    abstract interface
        subroutine chi_at(self, k, one_plus_chi, chi)
            import :: compliance_t, wp
            class(compliance_t), intent(in) :: self
            !> real parts > 0, arguments within the sector of analyticity [1/length]
            complex(wp), intent(in) :: k(:)
            !> same size as k
            complex(wp), intent(out) :: one_plus_chi(:), chi(:)
        end subroutine chi_at

        pure subroutine in_plane_at(self, k, direction, one_plus_chi, chi)
            import :: plane_compliance_t, wp
            class(plane_compliance_t), intent(in) :: self
            complex(wp), intent(in) :: k
            integer, intent(in) :: direction
            complex(wp), intent(out) :: one_plus_chi, chi
        end subroutine in_plane_at

        pure subroutine across_at(self, k, one_plus_chi, chi)
            import :: plane_compliance_t, wp
            class(plane_compliance_t), intent(in) :: self
            complex(wp), intent(in) :: k
            complex(wp), intent(out) :: one_plus_chi, chi
        end subroutine across_at
    end interface

contains

    subroutine split(self, k, bare, change)
        class(compliance_t), intent(in) :: self
        !> as of chi [1/length]
        complex(wp), intent(in) :: k(:)
        !> same size as k
        complex(wp), intent(out) :: bare(:), change(:)

        call self%chi(k, bare, change)
        bare = 1.0_wp
    end subroutine split

    subroutine no_coupling(self, k, ratio, error)
        class(compliance_t), intent(in) :: self
        !> real part > 0 [1/length]
        complex(wp), intent(in) :: k
        !> of coupling, always 0 here [1]
        complex(wp), intent(out) :: ratio
        type(error_t), allocatable, intent(inout) :: error

        associate (unused => self, also_unused => k)
        end associate
        ratio = 0.0_wp
        call raise(error, error_invalid, "load: the coupling is not available for this surface")
    end subroutine no_coupling

    pure function depths(self) result(lengths)
        class(compliance_t), intent(in) :: self
        real(wp) :: lengths(2)

        lengths = [self%first_depth, self%last_depth]
    end function depths

    pure subroutine none(self, values, error)
        class(compliance_t), intent(in) :: self
        !> numbers without a unit, or none
        real(wp), allocatable, intent(out) :: values(:)
        type(error_t), allocatable, intent(inout) :: error

        associate (unused => self, also_unused => error)
        end associate
        allocate (values(0))
    end subroutine none

    !> The load, and with it scale and at_zero.
    pure subroutine set_load(self, load, surface, base)
        class(plane_compliance_t), intent(inout) :: self
        integer, intent(in) :: load
        !> of the surface, and of what lies below the last interface; without it a rigid base
        type(moduli_t), intent(in) :: surface
        type(moduli_t), intent(in), optional :: base
        complex(wp) :: across, in_plane, sideways
        logical :: is_plain

        self%load = load
        across = 0.0_wp
        in_plane = 0.0_wp
        is_plain = surface%is_plain
        if (present(base)) then
            across = surface%shear/base%shear
            is_plain = is_plain .and. base%is_plain
            if (is_plain) in_plane = across*(1.0_wp - base%poisson)/(1.0_wp - surface%poisson)
            if (.not. is_plain) in_plane = surface%in_plane()/base%in_plane()
        end if
        select case (load)
        case (normal_load)
            self%scale = surface%contact
            self%at_zero = 0.0_wp
            if (present(base) .and. is_plain) self%at_zero = surface%shear*(1.0_wp - base%poisson) &
                                                             /(base%shear*(1.0_wp - surface%poisson))
            if (present(base) .and. .not. is_plain) self%at_zero = surface%contact/base%contact
        case (shear_load)
            if (surface%is_plain) then
                self%scale = 4.0_wp*surface%shear/(2.0_wp - surface%poisson)
                self%in_plane = (1.0_wp - surface%poisson)/(2.0_wp - surface%poisson)
                self%across = 1.0_wp/(2.0_wp - surface%poisson)
            else
                sideways = surface%in_plane()
                self%scale = 4.0_wp/(1.0_wp/sideways + 1.0_wp/surface%shear)
                self%in_plane = surface%shear/(sideways + surface%shear)
                self%across = sideways/(sideways + surface%shear)
            end if
            self%at_zero = self%in_plane*in_plane + self%across*across
        case default ! twist_load
            self%scale = 4.0_wp*surface%shear
            self%across = 1.0_wp
            self%at_zero = across
        end select
    end subroutine set_load

    subroutine chi_of_waves(self, k, one_plus_chi, chi)
        class(plane_compliance_t), intent(in) :: self
        complex(wp), intent(in) :: k(:)
        complex(wp), intent(out) :: one_plus_chi(:), chi(:)
        complex(wp) :: in_plane_one_plus_chi, in_plane_chi
        integer :: i

        do i = 1, size(k)
            if (self%load == normal_load) then
                call self%chi_in_plane(k(i), normal_to, one_plus_chi(i), chi(i))
                cycle
            end if
            call self%chi_across(k(i), one_plus_chi(i), chi(i))
            if (self%load == twist_load) cycle
            call self%chi_in_plane(k(i), along, in_plane_one_plus_chi, in_plane_chi)
            one_plus_chi(i) = self%in_plane*in_plane_one_plus_chi + self%across*one_plus_chi(i)
            chi(i) = self%in_plane*in_plane_chi + self%across*chi(i)
        end do
    end subroutine chi_of_waves

end module mdrcontact_body_compliance
