! SPDX-License-Identifier: GPL-3.0-or-later
!> History of each place of a worn disc: int p ds and the pressure, between the places where they are kept.
module mdrcontact_wear_history_on_disc
    use mdrcontact_kinds, only: half_pi, wp
    use mdrcontact_medium_hats, only: hat_nodes
    implicit none (type, external)
    private
    public :: disc_t, wear_history_on_disc_t, new_wear_history_on_disc

    !> A disc in contact, or rings of which some are.
    type :: disc_t
        !> a [length], d [length], F [modulus length^2]
        real(wp) :: radius = 0.0_wp, depth = 0.0_wp, force = 0.0_wp
        !> da/ds of the last step [1], and its dln F/dln a, or of d where that is given: where the search for the next radius begins
        real(wp) :: growth = 0.0_wp, response = 1.0_wp/0.3_wp
        !> the last one of the radii, a of a disc [length]
        real(wp) :: extent = 0.0_wp
        !> whether the radii are those of rings that stay on the indenter
        logical :: stays = .false.
        !> m of the radii, see mdrcontact_medium_hats
        integer :: power = 1
        !> p [modulus] and int p ds [modulus length] at the radii 0 ... n: both 0 at the edge of a disc
        real(wp), allocatable :: pressure(:), load(:)
    end type disc_t

    !> int p ds as a cubic spline over (arcsin(r/a))^(1/m), flat at the axis, of rings as straight lines between the radii, as p is.
    type :: wear_history_on_disc_t
        private
        real(wp) :: radius = 0.0_wp
        logical :: stays = .false.
        integer :: power = 1
        real(wp), allocatable :: nodes(:), pressure(:), load(:), curvature(:)
    contains
        procedure :: at
    end type wear_history_on_disc_t

contains

    !> Create the history of a disc.
    pure subroutine new_wear_history_on_disc(self, disc)
        type(wear_history_on_disc_t), intent(out) :: self
        type(disc_t), intent(in) :: disc
        real(wp) :: pivot(0:ubound(disc%load, 1)), side(0:ubound(disc%load, 1))
        integer :: i, n

        n = ubound(disc%load, 1)
        self%radius = disc%extent
        self%stays = disc%stays
        self%power = disc%power
        allocate (self%nodes(0:n), self%pressure(0:n), self%load(0:n), self%curvature(0:n))
        self%nodes = hat_nodes(n, disc%power)
        self%pressure = disc%pressure
        self%load = disc%load
        self%curvature = 0.0_wp
        if (disc%stays) return
        ! second differences; at the edge int p ds vanishes faster than the square of the distance in theta
        pivot(0) = 2.0_wp
        side(0) = 6.0_wp*(self%load(1) - self%load(0))
        do i = 1, n - 1
            pivot(i) = 4.0_wp - 1.0_wp/pivot(i - 1)
            side(i) = 6.0_wp*(self%load(i - 1) - 2.0_wp*self%load(i) + self%load(i + 1)) - side(i - 1)/pivot(i - 1)
        end do
        do i = n - 1, 0, -1
            self%curvature(i) = (side(i) - self%curvature(i + 1))/pivot(i)
        end do
    end subroutine new_wear_history_on_disc

    !> int p ds and p at a radius; 0 outside.
    elemental subroutine at(self, r, load, pressure)
        class(wear_history_on_disc_t), intent(in) :: self
        !> >= 0 [length]
        real(wp), intent(in) :: r
        real(wp), intent(out) :: load, pressure
        real(wp) :: t, s, place
        integer :: i, n

        load = 0.0_wp
        pressure = 0.0_wp
        if (r > self%radius .or. r >= self%radius .and. .not. self%stays) return
        n = ubound(self%load, 1)
        place = r/self%radius
        if (self%power > 0) place = asin(place)/half_pi
        if (self%power == 2) place = sqrt(place)
        place = place*real(n, wp)
        i = min(int(place), n - 1)
        t = (r/self%radius - self%nodes(i))/(self%nodes(i + 1) - self%nodes(i))
        pressure = self%pressure(i) + (self%pressure(i + 1) - self%pressure(i))*t
        if (.not. self%stays) t = place - real(i, wp)
        s = 1.0_wp - t
        load = s*self%load(i) + t*self%load(i + 1) + (s*(s**2 - 1.0_wp)*self%curvature(i) &
                                                      + t*(t**2 - 1.0_wp)*self%curvature(i + 1))/6.0_wp
    end subroutine at

end module mdrcontact_wear_history_on_disc
