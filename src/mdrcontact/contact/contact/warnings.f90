! SPDX-License-Identifier: GPL-3.0-or-later
!> Validity of a state: linear elasticity holds for small slopes and strains, and answers beyond them too.
module mdrcontact_contact_warnings
    use mdrcontact_body, only: body_t
    use mdrcontact_codes, only: warning_compression, warning_contrast, warning_pressure, warning_short_zone, warning_slope, &
                                warning_wetting
    use mdrcontact_contact_equilibrium, only: equilibrium_t
    use mdrcontact_contact_state, only: contact_state_t
    use mdrcontact_error, only: error_t, to_text
    use mdrcontact_kinds, only: pi, wp
    use mdrcontact_medium_load, only: load_t, lower_body, upper_body
    implicit none (type, external)
    private
    public :: contact_warning_t, find_warnings
    public :: warning_slope, warning_pressure, warning_compression, warning_contrast, warning_short_zone, warning_wetting, &
              add

    !> The largest slope of the indenter in the contact: 50 degrees, a little more than the cone of a cube corner has.
    real(wp), parameter :: largest_slope = 1.2_wp
    !> The largest mean pressure over E_eff(a), and over the contact modulus of the surface: that under a cone of the largest
    !> slope, F/(pi a^2 E*) = f'/2.
    real(wp), parameter :: largest_pressure = 0.5_wp*largest_slope
    !> The largest part of their thickness by which layers are compressed.
    real(wp), parameter :: largest_compression = 0.5_wp
    !> The largest ratio of two Young's moduli: a gel of 1 kPa on glass has 7e7, GPa with Pa 1e9.
    real(wp), parameter :: largest_contrast = 1.0e9_wp

    !> The largest work of adhesion over the surface tension, 1 - cos theta of the angle of contact: 18 degrees.
    real(wp), parameter :: largest_wetting = 0.05_wp

    !> One warning: its code and what it means, as a sentence without a full stop.
    type :: contact_warning_t
        !> one of warning_...
        integer :: code = 0
        !> what it means
        character(len=240) :: text = ""
    end type contact_warning_t

contains

    !> Doubts about the numbers of a state, in the order of the codes.
    subroutine find_warnings(equilibrium, state, found)
        type(equilibrium_t), intent(in) :: equilibrium
        !> a state of this contact; none is found without a contact, a = 0
        type(contact_state_t), intent(in) :: state
        type(contact_warning_t), allocatable, intent(out) :: found(:)

        allocate (found(0))
        if (state%radius > 0.0_wp) then
            call look_at_slope(equilibrium, state, found)
            if (size(found) == 0) call look_at_pressure(equilibrium, state, found)
            call look_at_layers(equilibrium, state, found)
        end if
        call look_at_moduli(equilibrium, found)
        call check_wetting(equilibrium, found)
    end subroutine find_warnings

    !> The slope of the surface jumps by sqrt(2 gamma/tau) at an adhesive edge (theory/surfaces.md (5.7)). Under a plate its
    !> curvature does, by sqrt(2 gamma/B), and the slope changes by about that over the plate's length, B/length^2 standing for the
    !> tension.
    pure subroutine check_wetting(equilibrium, found)
        type(equilibrium_t), intent(in) :: equilibrium
        type(contact_warning_t), allocatable, intent(inout) :: found(:)
        real(wp) :: holds

        associate (gamma => equilibrium%work_of_adhesion, sheet => equilibrium%medium%sheet)
            holds = max(sheet%tension, sheet%bending**(1.0_wp/3.0_wp)*(0.5_wp*surface_modulus(equilibrium))**(2.0_wp/3.0_wp))
            if (.not. (holds > 0.0_wp .and. gamma > largest_wetting*holds)) return
            call add(found, warning_wetting, "the work of adhesion is "//to_text(gamma/holds)//" of "// &
                     trim(merge("the surface tension         ", "what bends the plate, B/L^2,", holds <= sheet%tension))// &
                     ": the slope of the surface at the edge is not small, and the theory assumes small slopes")
        end associate
    end subroutine check_wetting

    pure subroutine look_at_slope(equilibrium, state, found)
        type(equilibrium_t), intent(in) :: equilibrium
        type(contact_state_t), intent(in) :: state
        type(contact_warning_t), allocatable, intent(inout) :: found(:)
        real(wp) :: slope

        if (equilibrium%profile%has_wall .and. state%radius >= equilibrium%profile%largest_radius) return
        ! the slope at the edge of an imprint is infinite, in a neighbourhood without extent
        if (equilibrium%ends_sharply() .and. state%radius >= equilibrium%last_radius) return
        slope = equilibrium%profile%slope(state%radius)
        if (slope <= largest_slope) return
        call add(found, warning_slope, "the indenter's surface has a slope of "//to_text(slope)// &
                 " at the edge of the contact (contact radius "//to_text(state%radius)//"): linear elasticity assumes small "// &
                 "slopes, and a paraboloid represents a sphere only at radii much smaller than R")
    end subroutine look_at_slope

    pure subroutine look_at_pressure(equilibrium, state, found)
        type(equilibrium_t), intent(in) :: equilibrium
        type(contact_state_t), intent(in) :: state
        type(contact_warning_t), allocatable, intent(inout) :: found(:)
        real(wp) :: ratio

        ! a stiff film on a soft body is bent by a pressure that strains it little
        ratio = state%force/(pi*state%radius**2*max(0.5_wp*state%stiffness/state%radius, surface_modulus(equilibrium)))
        if (ratio <= largest_pressure) return
        call add(found, warning_pressure, "the mean pressure is "//to_text(ratio)//" times the contact modulus (depth "// &
                 to_text(state%depth)//", contact radius "//to_text(state%radius)//"): strains are not small, so linear "// &
                 "elasticity is not valid")
    end subroutine look_at_pressure

    !> Modulus at the surface of one body or two, 0 if it is not known [modulus].
    pure function surface_modulus(equilibrium) result(modulus)
        type(equilibrium_t), intent(in) :: equilibrium
        real(wp) :: modulus

        modulus = 0.0_wp
        if (.not. allocated(equilibrium%medium%pressed)) return
        modulus = equilibrium%medium%pressed%surface_modulus
        if (allocated(equilibrium%medium%counterbody)) then
            modulus = modulus/(1.0_wp + modulus/equilibrium%medium%counterbody%surface_modulus)
        else if (equilibrium%medium%is_pair) then
            modulus = 0.0_wp
        end if
    end function surface_modulus

    subroutine look_at_layers(equilibrium, state, found)
        type(equilibrium_t), intent(in) :: equilibrium
        type(contact_state_t), intent(in) :: state
        type(contact_warning_t), allocatable, intent(inout) :: found(:)

        associate (medium => equilibrium%medium)
            if (allocated(medium%pressed)) call look_at_body(equilibrium, lower_body, medium%pressed, state, found)
            if (allocated(medium%counterbody)) call look_at_body(equilibrium, upper_body, medium%counterbody, state, found)
        end associate
    end subroutine look_at_layers

    subroutine look_at_body(equilibrium, which, body, state, found)
        type(equilibrium_t), intent(in), target :: equilibrium
        !> lower_body or upper_body, and that body
        integer, intent(in) :: which
        class(body_t), intent(in) :: body
        type(contact_state_t), intent(in) :: state
        type(contact_warning_t), allocatable, intent(inout) :: found(:)
        class(load_t), allocatable :: load
        type(error_t), allocatable :: error
        real(wp) :: force, base, depth(1)

        if (.not. body%last_depth > 0.0_wp) return
        ! what lies below the layers gives way by at most F/(a E1*), as a half-space does under a cone; F without adhesion
        force = state%force - min(state%punch_depth, 0.0_wp)*state%stiffness
        if (state%zone_radius > 0.0_wp) force = max(state%force, 0.0_wp)
        base = force*body%long_wave_limit/(state%radius*body%surface_modulus)
        depth = state%depth
        if (depth(1) - base <= largest_compression*body%last_depth) return
        if (equilibrium%medium%is_pair) then
            call equilibrium%medium%load(equilibrium%profile, state%radius, state%punch_depth, load, error)
            if (.not. allocated(error)) call load%displacement_of_body(which, [0.0_wp], depth, error)
        end if
        if (allocated(error)) return
        if (depth(1) - base <= largest_compression*body%last_depth) return
        call add(found, warning_compression, "layers of thickness "//to_text(body%last_depth)//" would be compressed by "// &
                 to_text(depth(1) - base)//" or more (depth "//to_text(state%depth)//"): linear elasticity assumes a small "// &
                 "fraction of the thickness")
    end subroutine look_at_body

    pure subroutine look_at_moduli(equilibrium, found)
        type(equilibrium_t), intent(in) :: equilibrium
        type(contact_warning_t), allocatable, intent(inout) :: found(:)
        real(wp) :: softest, stiffest

        softest = huge(1.0_wp)
        stiffest = 0.0_wp
        if (allocated(equilibrium%medium%pressed)) call widen(equilibrium%medium%pressed, softest, stiffest)
        if (allocated(equilibrium%medium%counterbody)) call widen(equilibrium%medium%counterbody, softest, stiffest)
        if (stiffest < largest_contrast*softest) return
        call add(found, warning_contrast, "Young's moduli from "//to_text(softest)//" to "//to_text(stiffest)// &
                 " are combined: check that all have the same unit")
    end subroutine look_at_moduli

    pure subroutine widen(body, softest, stiffest)
        class(body_t), intent(in) :: body
        real(wp), intent(inout) :: softest, stiffest

        if (.not. body%softest > 0.0_wp) return
        softest = min(softest, body%softest)
        stiffest = max(stiffest, body%stiffest)
    end subroutine widen

    !> A warning more, unless the other body gave it already.
    pure subroutine add(found, code, text)
        type(contact_warning_t), allocatable, intent(inout) :: found(:)
        integer, intent(in) :: code
        character(len=*), intent(in) :: text

        if (all(found%code /= code)) found = [found, contact_warning_t(code, text)]
    end subroutine add

end module mdrcontact_contact_warnings
