! SPDX-License-Identifier: GPL-3.0-or-later
!> The compliance of a body whose surface carries a sheet that is stiff in its plane (theory/surfaces.md (5.2)-(5.4)).
!>
!> With the compliance S(k) of the body in the plane of a wave, displacements (u, w) over tractions along and across the surface,
!> and q = K_m k/(2 G) of the sheet,
!>     S_ext = (S^-1 - diag(q, 0))^-1,   1 + chi = s (S_22 - q det S)/(1 - q S_11),   s = S_11/det S of the surface's half-space,
!> relative to what short waves meet, a surface that cannot move sideways: E0* = E* 4 (1 - nu)^2/(3 - 4 nu) of an isotropic one.
!> On a half-space chi = c/(1 + k l) with c = S_12 S_21/det S: it falls as 1/k only, and X(y) is a logarithm next to y = 0, as on
!> graded bodies. Waves far shorter than all lengths are left out as those do it, by a factor exp(-2 k h_0).
module mdrcontact_body_membrane
    use, intrinsic :: iso_fortran_env, only: int64
    use mdrcontact_object, only: room
    use mdrcontact_body_chain, only: chain_t
    use mdrcontact_body_compliance, only: compliance_t
    use mdrcontact_error, only: error_invalid, error_t, raise, to_text
    use mdrcontact_kinds, only: wp
    implicit none (type, external)
    private
    public :: membrane_t, new_membrane

    !> h_0 over l or, if that is less, the first layer: it moves the modulus by less than twice as much.
    real(wp), parameter :: finest = 2.0_wp**(-40)
    !> The wave number at which the body counts as what very long waves meet [1/depth of all layers].
    real(wp), parameter :: long_wave = 1.0e-3_wp
    !> Largest ratio of l and the layers.
    real(wp), parameter :: farthest = 1.0e12_wp

    !> A chain under a sheet. Made by new_membrane.
    type, extends(compliance_t) :: membrane_t
        !> of the surface's half-space under it: c and l [length], chi = c/(1 + k l)
        real(wp) :: excess = 0.0_wp, length = 0.0_wp
        type(chain_t), allocatable, private :: body
        !> K_m/(2 G) [length], and s
        real(wp), private :: stretching = 0.0_wp, scale_of_surface = 1.0_wp
        !> h_0, 0 where all waves are kept [length]
        real(wp), private :: faded = 0.0_wp
    contains
        procedure :: chi => chi_at
        procedure :: split
        procedure :: lengths
        procedure, private :: parts
        procedure :: key
        procedure :: bytes
    end type membrane_t

contains

    !> The body's compliance under a normal load with the sheet on it.
    subroutine new_membrane(self, stretching, body, error, has_springs)
        type(membrane_t), intent(out) :: self
        !> K_m > 0 [modulus length]
        real(wp), intent(in) :: stretching
        !> without the sheet; not a graded one
        class(compliance_t), intent(in) :: body
        type(error_t), allocatable, intent(inout) :: error
        !> whether waves far shorter than all lengths are left out
        logical, intent(in) :: has_springs
        complex(wp), dimension(2, 2) :: half_space, whole, change
        complex(wp) :: k
        logical :: is_whole
        real(wp) :: determinant, shortest, longest

        if (allocated(error)) return
        select type (body)
        type is (chain_t)
            call room(body%bytes(), error)
            if (.not. allocated(error)) allocate (self%body, source=body)
        class default
            call raise(error, error_invalid, "surface stretching: it is not available on a graded body. Use layers")
            return
        end select
        if (allocated(error)) return
        k = 1.0_wp
        if (body%last_depth > 0.0_wp) k = long_wave/body%last_depth
        call self%body%matrices(k, half_space, whole, change, is_whole)
        determinant = real(half_space(1, 1)*half_space(2, 2) - half_space(1, 2)*half_space(2, 1), wp)
        self%scale_of_surface = real(half_space(1, 1), wp)/determinant
        ! k C = 2/E0* = -S_22/(2 G)
        self%stretching = -2.0_wp*stretching/(real(half_space(2, 2), wp)*real(body%scale, wp))
        self%excess = real(half_space(1, 2)*half_space(2, 1), wp)/determinant
        self%length = -self%stretching*real(half_space(1, 1), wp)
        self%scale = body%scale*(1.0_wp + self%excess)
        self%at_zero = body%at_zero*(1.0_wp + self%excess)
        self%first_depth = body%first_depth
        self%last_depth = body%last_depth
        self%is_costly = body%is_costly
        shortest = self%length
        longest = self%length
        if (body%first_depth > 0.0_wp) then
            shortest = min(shortest, body%first_depth)
            longest = max(longest, body%last_depth)
        end if
        if (.not. (longest < farthest*shortest .and. shortest > tiny(1.0_wp)/finest)) then
            call raise(error, error_invalid, "surface stretching = "//to_text(stretching)//": its length 2 K_m/E* = "// &
                       to_text(self%length)//" must be greater than 0, and within a factor 1e12 of the thicknesses")
        end if
        self%is_made = .not. allocated(error)
        if (.not. (abs(self%excess) > 0.0_wp .and. has_springs)) return
        self%faded = finest*shortest
        self%first_depth = self%faded
        self%last_depth = max(longest, abs(self%stretching*real(whole(1, 1), wp)))
    end subroutine new_membrane

    pure recursive function bytes(self)
        class(membrane_t), intent(in) :: self
        integer(int64) :: bytes

        bytes = self%body%bytes()
    end function bytes

    subroutine chi_at(self, k, one_plus_chi, chi)
        class(membrane_t), intent(in) :: self
        complex(wp), intent(in) :: k(:)
        complex(wp), intent(out) :: one_plus_chi(:), chi(:)
        complex(wp) :: bare, change, z, lost
        integer :: i

        do i = 1, size(k)
            call self%parts(k(i), one_plus_chi(i), bare, change)
            z = 2.0_wp*k(i)*self%faded
            ! 1 - exp(-z)
            lost = z - 0.5_wp*z**2
            if (abs(z) > 1.0e-6_wp) lost = 1.0_wp - exp(-z)
            one_plus_chi(i) = one_plus_chi(i) - lost*bare
            chi(i) = change + (1.0_wp - lost)*bare
        end do
    end subroutine chi_at

    !> With the length of the sheet, where it changes anything.
    pure function lengths(self)
        class(membrane_t), intent(in) :: self
        real(wp) :: lengths(2)

        lengths = [self%first_depth, self%last_depth]
        if (.not. abs(self%excess) > 0.0_wp) return
        lengths = [min(self%length, lengths(1)), max(self%length, lengths(2))]
        if (.not. lengths(1) > 0.0_wp) lengths(1) = self%length
    end function lengths

    !> Compliance of a half-space of the surface material, and the change by the layers.
    subroutine split(self, k, bare, change)
        class(membrane_t), intent(in) :: self
        complex(wp), intent(in) :: k(:)
        complex(wp), intent(out) :: bare(:), change(:)
        complex(wp) :: one_plus_chi
        integer :: i

        do i = 1, size(k)
            call self%parts(k(i), one_plus_chi, bare(i), change(i))
            bare(i) = 1.0_wp + bare(i)
        end do
    end subroutine split

    !> 1 + chi, and chi of the surface's half-space and what the layers change of it: both as exact as they are.
    pure subroutine parts(self, k, one_plus_chi, bare, change)
        class(membrane_t), intent(in) :: self
        complex(wp), intent(in) :: k
        complex(wp), intent(out) :: one_plus_chi, bare, change
        complex(wp), dimension(2, 2) :: h, whole, d
        complex(wp) :: q, ratio, rise, determinant, top, below
        logical :: is_whole

        call self%body%matrices(k, h, whole, d, is_whole)
        q = k*self%stretching
        ratio = 1.0_wp - q*h(1, 1)
        bare = self%excess/ratio
        determinant = whole(1, 1)*whole(2, 2) - whole(1, 2)*whole(2, 1)
        below = 1.0_wp - q*whole(1, 1)
        one_plus_chi = self%scale_of_surface*(whole(2, 2) - q*determinant)/below
        rise = h(1, 1)*d(2, 2) + h(2, 2)*d(1, 1) + d(1, 1)*d(2, 2) - h(1, 2)*d(2, 1) - h(2, 1)*d(1, 2) - d(1, 2)*d(2, 1)
        top = self%scale_of_surface*(d(2, 2) - q*rise)
        change = (top*ratio + q*d(1, 1)*(self%excess + ratio))/(below*ratio)
    end subroutine parts

    !> Key of the body and the length of the sheet.
    pure subroutine key(self, values, error)
        class(membrane_t), intent(in) :: self
        real(wp), allocatable, intent(out) :: values(:)
        type(error_t), allocatable, intent(inout) :: error
        real(wp), allocatable :: own(:)

        call self%body%key(own, error)
        if (allocated(error)) return
        values = own
        if (size(own) > 0) values = [own, self%length/self%first_depth, self%stretching/self%first_depth]
    end subroutine key

end module mdrcontact_body_membrane
