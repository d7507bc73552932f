! SPDX-License-Identifier: GPL-3.0-or-later
!> Fields of the steady contact area at potential difference 1, with or without a film in it: flux density through the contact area,
!> potential and flux density in each body.
module mdrcontact_conduction_fields
    use mdrcontact_conduction_bodies, only: conduction_t
    use mdrcontact_conduction_film, only: film_spot_t, new_film_spot, terms_of_flux
    use mdrcontact_conduction_inside, only: fields_inside
    use mdrcontact_conduction_spot, only: new_spot, spot_conductance
    use mdrcontact_error, only: check_choice, check_made, error_domain, error_t, raise, to_text
    use mdrcontact_kinds, only: wp
    use mdrcontact_line_fields, only: line_load_t
    implicit none (type, external)
    private
    public :: conductance_at, flux_at, inside_at, check_inside

contains

    !> G and dG/da.
    subroutine conductance_at(self, a, conductance, slope, error)
        type(conduction_t), intent(in) :: self
        !> > 0 [length]
        real(wp), intent(in) :: a
        !> [conductance], [conductance/length]
        real(wp), intent(out) :: conductance, slope
        type(error_t), allocatable, intent(out) :: error
        type(film_spot_t) :: spot

        conductance = 0.0_wp
        slope = 0.0_wp
        call check_made(error, "conduction", self%is_made)
        if (allocated(error)) return
        if (allocated(self%table)) then
            if (a >= self%table%smallest_radius .and. a <= self%table%largest_radius) then
                slope = self%table%at(a)
                conductance = slope*a
                slope = slope + a*self%table%slope_at(a)
                return
            end if
        end if
        call check(self, a, error)
        if (allocated(error)) return
        if (.not. self%film > 0.0_wp) then
            call spot_conductance(self, a, conductance, slope, error)
            return
        end if
        call new_film_spot(spot, self, a, error)
        conductance = spot%conductance
        slope = spot%slope
    end subroutine conductance_at

    subroutine check(self, a, error)
        type(conduction_t), intent(in) :: self
        real(wp), intent(in) :: a
        type(error_t), allocatable, intent(inout) :: error

        call self%check_steady(error)
        call self%check_radius(a, error)
        if (allocated(error) .or. .not. (self%film > 0.0_wp .and. self%is_insulated)) return
        call raise(error, error_domain, "film: it is not available on layers with an insulating base. Omit the film")
    end subroutine check

    !> Raises unless points lie in a contact area.
    pure subroutine check_inside(r, a, error)
        !> [length]
        real(wp), intent(in) :: r(:)
        !> its radius [length]
        real(wp), intent(in) :: a
        type(error_t), allocatable, intent(inout) :: error
        integer :: i

        do i = 1, size(r)
            if (allocated(error)) return
            if (r(i) >= 0.0_wp .and. r(i) < a) cycle
            call raise(error, error_domain, " = "//to_text(r(i))//": it must be at least 0 and less than the contact radius "// &
                       to_text(a), "r", i)
        end do
    end subroutine check_inside

    !> j(r) in the contact area.
    subroutine flux_at(self, a, r, density, error)
        type(conduction_t), intent(in) :: self
        !> > 0 [length]
        real(wp), intent(in) :: a
        !> 0 <= r < a, where it is infinite without a film [length]
        real(wp), intent(in) :: r(:)
        !> same size as r [conductance/length^2]
        real(wp), intent(out) :: density(:)
        type(error_t), allocatable, intent(out) :: error
        type(film_spot_t) :: film
        type(line_load_t) :: spot
        integer :: i

        density = 0.0_wp
        call check_made(error, "conduction", self%is_made)
        if (allocated(error)) return
        call check(self, a, error)
        call check_inside(r, a, error)
        if (allocated(error)) return
        if (self%film > 0.0_wp) then
            call new_film_spot(film, self, a, error, terms_of_flux)
            if (.not. allocated(error)) call film%flux(self, r, density, error)
            return
        end if
        call new_spot(spot, self, a, error)
        if (allocated(error)) return
        do i = 1, size(r)
            density(i) = 2.0_wp*self%scale*spot%punch_pressure(r(i))
        end do
    end subroutine flux_at

    !> Potential of one body from its own far field, and the flux density in it: into the body and away from the axis.
    subroutine inside_at(self, body, a, r, z, lower, potential, flux_z, flux_r, error)
        type(conduction_t), intent(in) :: self
        !> 1 or 2
        integer, intent(in) :: body
        !> > 0 [length]
        real(wp), intent(in) :: a
        !> r >= 0, z >= 0 [length]
        real(wp), intent(in) :: r(:), z(:)
        !> at an interface: below it
        logical, intent(in) :: lower
        !> same size as r
        real(wp), intent(out) :: potential(:), flux_z(:), flux_r(:)
        type(error_t), allocatable, intent(out) :: error
        type(film_spot_t) :: film
        type(line_load_t) :: spot
        real(wp), allocatable :: q(:)

        potential = 0.0_wp
        flux_z = 0.0_wp
        flux_r = 0.0_wp
        call check_made(error, "conduction", self%is_made)
        if (allocated(error)) return
        call check_choice(error, "body", body, 1, size(self%bodies), merge("1     ", "1 or 2", size(self%bodies) == 1))
        call check(self, a, error)
        if (allocated(error)) return
        if (self%film > 0.0_wp) then
            call new_film_spot(film, self, a, error)
            if (.not. allocated(error)) call film%line_load(q, error)
        else
            call new_spot(spot, self, a, error)
            if (.not. allocated(error)) q = 2.0_wp*self%scale*spot%q
        end if
        if (allocated(error)) return
        call fields_inside(self%bodies(body), a, q, r, z, lower, potential, flux_z, flux_r, error)
    end subroutine inside_at

end module mdrcontact_conduction_fields
