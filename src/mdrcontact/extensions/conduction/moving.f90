! SPDX-License-Identifier: GPL-3.0-or-later
!> The heat of friction of a source that moves over the lower body at any speed: what it adds to the source at rest,
!>     T(x) - T_static(x) = (1/S_0) int j_hat(k) (2/pi) int_0^(pi/2) Re[dchi exp(i k x cos phi)] dphi dk,
!>     dchi = chi(k, i v k cos phi) - chi(k, 0)
!> at a distance x behind the centre; with J_0 instead of the last factor, means
!> (theory/conduction.md (10.5), (10.6), (10.8)).
module mdrcontact_conduction_moving
    use mdrcontact_cancel, only: check_cancelled
    use mdrcontact_conduction_bodies, only: conduction_t
    use mdrcontact_conduction_conductors, only: conductors_t
    use mdrcontact_conduction_heat, only: friction_heat, heat_t
    use mdrcontact_conduction_inside, only: fields_inside
    use mdrcontact_conduction_source, only: sliding
    use mdrcontact_contact, only: contact_t
    use mdrcontact_contact_state, only: contact_state_t
    use mdrcontact_error, only: check_made, check_positive, error_domain, error_t, raise, to_text
    use mdrcontact_kinds, only: half_pi, pi, wp
    use mdrcontact_numerics_chebyshev, only: chebyshev_sums, cosine_transform, node, series_of_values, series_value, terms
    use mdrcontact_numerics_even_waves, only: even_waves
    use mdrcontact_numerics_quadrature, only: gauss_legendre
    use mdrcontact_numerics_waves, only: wave_rule
    implicit none (type, external)
    private
    public :: moving_heat

    !> Nodes of a panel of directions, the angle below which nothing is left, and the phase that a panel takes.
    integer, parameter :: direction_nodes = 10
    real(wp), parameter :: shortest_panel = 1.0e-9_wp, longest_phase = 6.0_wp
    !> Phases of all points beyond which complex directions take fewer nodes, the exponent of the decay at which these end, and the
    !> panels of those from cos phi = 1.
    real(wp), parameter :: many_phases = 60.0_wp, decay = 32.0_wp
    integer, parameter :: panels_from_one = 3
    !> Waves over a from which means over directions, less their phase, are series in each octave, and the terms of one: singular
    !> points of chi lie on the imaginary axis, so that the last term is 1e-16 or less.
    real(wp), parameter :: first_octave = 16.0_wp
    integer, parameter :: octave_terms = 32
    !> Of these series, relative to the largest mean of an octave.
    real(wp), parameter :: series_error = 1.0e-12_wp
    !> Waves up to (cutoff_factor Pe)^(2/7)/a, and beyond the source's own, show in temperatures along its line to 1e-7.
    real(wp), parameter :: cutoff_factor = 1.0e7_wp, own_waves = 4.0_wp, fewest_waves = 60.0_wp
    !> Waves of the means: chi falls as Pe^2/k^2.
    real(wp), parameter :: waves_of_means = 2000.0_wp
    !> Places between two nodes of the series at which the largest value is searched for.
    integer, parameter :: places = 400
    !> Waves up to this over a show where the largest value lies, to a tenth of a.
    real(wp), parameter :: waves_of_search = 40.0_wp
    !> Distances over a at which parabolas are laid through three temperatures: the last is within 3e-4 a of the place.
    real(wp), parameter :: reaches(*) = [0.08_wp, 0.02_wp]
    !> v a c/kappa_r up to which this is offered: the waves grow with it.
    real(wp), parameter :: fastest = 1.0e3_wp

    !> j_hat and its waves.
    type :: waves_t
        real(wp), allocatable :: z(:), weight(:), hat(:)
        !> of a rule on [0, 1] for directions
        real(wp) :: node(direction_nodes) = 0.0_wp, share(direction_nodes) = 0.0_wp
        !> up to which wave temperatures along the line take them
        real(wp) :: last = 0.0_wp
    end type waves_t

contains

    !> The temperatures of the lower body under a source that moves over it at the speed v and rests on the upper one. Of two bodies
    !> the share is that at which their means over the heat are the same, an approximation: their temperatures do not agree at
    !> every point.
    subroutine moving_heat(conduction, contact, state, strength, speed, heat, error)
        type(conduction_t), intent(in) :: conduction
        type(contact_t), intent(in) :: contact
        type(contact_state_t), intent(in) :: state
        !> mu v >= 0 with the speed of sliding
        real(wp), intent(in) :: strength
        !> v > 0 of the source over the body [length/time]
        real(wp), intent(in) :: speed
        !> without the mean over the area
        type(heat_t), intent(out) :: heat
        type(error_t), allocatable, intent(out) :: error
        type(conduction_t) :: one
        type(heat_t) :: upper
        real(wp) :: share

        call check_made(error, "conduction", conduction%is_made)
        call check_made(error, "contact", contact%is_made)
        if (allocated(error)) return
        call check_positive(error, "speed", speed)
        if (allocated(error)) return
        call conduction%check_steady(error)
        if (allocated(error)) return
        call single_body(conduction, 1, one)
        call heat_all(one, contact, state, strength, speed, heat, error)
        if (size(conduction%bodies) == 1 .or. allocated(error) .or. .not. heat%total > 0.0_wp) return
        call single_body(conduction, 2, one)
        call friction_heat(one, contact, state, sliding, strength, upper, error)
        if (allocated(error)) return
        share = upper%flux_mean/(upper%flux_mean + heat%flux_mean)
        heat = heat_t(heat%total, share, share*heat%centre, share*heat%flux_mean, 0.0_wp, share*heat%largest, heat%behind)
    end subroutine moving_heat

    !> Conduction in one of the bodies.
    pure subroutine single_body(conduction, body, one)
        type(conduction_t), intent(in) :: conduction
        integer, intent(in) :: body
        type(conduction_t), intent(out) :: one

        one%bodies = conduction%bodies(body:body)
        one%kernels = conduction%kernels(body:body)
        one%kernel = one%kernels(1)
        one%scale = one%bodies(1)%s(1)
        one%share = [1.0_wp]
        one%largest_radius = conduction%largest_radius
        one%is_insulated = conduction%is_insulated
        one%sink = conduction%sink
        one%is_made = .true.
    end subroutine single_body

    !> All heat into one body.
    subroutine heat_all(conduction, contact, state, strength, speed, heat, error)
        type(conduction_t), intent(in) :: conduction
        type(contact_t), intent(in) :: contact
        type(contact_state_t), intent(in) :: state
        real(wp), intent(in) :: strength, speed
        type(heat_t), intent(out) :: heat
        type(error_t), allocatable, intent(inout) :: error
        type(waves_t) :: waves
        real(wp), allocatable :: loads(:, :)

        call friction_heat(conduction, contact, state, sliding, strength, heat, error, loads)
        heat%area_mean = 0.0_wp
        if (allocated(error) .or. .not. heat%total > 0.0_wp) return
        associate (body => conduction%bodies(1), a => state%radius)
            call find_waves(body, a, speed, loads(:, 1), waves, error)
            if (allocated(error)) return
            call add_means(body, a, speed, waves, heat, error)
            if (.not. allocated(error)) call find_largest(body, a, speed, loads(:, 1), waves, heat, error)
        end associate
    end subroutine heat_all

    !> The largest temperature on the line of motion: searched for among long waves, found by parabolas through three values.
    subroutine find_largest(body, a, speed, load, waves, heat, error)
        type(conductors_t), intent(in) :: body
        real(wp), intent(in) :: a, speed, load(:)
        type(waves_t), intent(in) :: waves
        type(heat_t), intent(inout) :: heat
        type(error_t), allocatable, intent(inout) :: error
        real(wp) :: along(terms), x(terms), near(3), values(3), reach
        integer :: i

        x = [(0.5_wp*a*(1.0_wp + node(i, terms)), i=1, terms)]
        call temperatures(body, a, speed, load, waves, x, min(waves%last, waves_of_search), along, error)
        if (allocated(error)) return
        heat%behind = 0.5_wp*a*(1.0_wp + place_of_largest(along))
        do i = 1, size(reaches)
            reach = reaches(i)*a
            near = min(max(heat%behind, reach), a - reach) + [-reach, 0.0_wp, reach]
            call temperatures(body, a, speed, load, waves, near, waves%last, values, error)
            if (allocated(error)) return
            heat%behind = min(max(near(2) + reach*top(values), 0.0_wp), a)
        end do
        call temperatures(body, a, speed, load, waves, [heat%behind], waves%last, values(:1), error)
        heat%largest = values(1)
    end subroutine find_largest

    !> The transform of the source.
    subroutine find_waves(body, a, speed, load, waves, error)
        type(conductors_t), intent(in) :: body
        real(wp), intent(in) :: a, speed
        !> coefficients of P_2j(x/a)
        real(wp), intent(in) :: load(:)
        type(waves_t), intent(out) :: waves
        type(error_t), allocatable, intent(inout) :: error
        real(wp) :: peclet, last, values(size(load))
        integer :: i

        peclet = speed*a*maxval(body%rate)
        if (peclet > fastest) then
            call raise(error, error_domain, " = "//to_text(speed)//": speed a c/kappa must be at most "//to_text(fastest)// &
                       ". Beyond, the heat flow is one-dimensional", "source speed")
            return
        end if
        waves%last = max(fewest_waves, (cutoff_factor*peclet)**(2.0_wp/7.0_wp), own_waves*peclet)
        last = max(fewest_waves, waves_of_means*sqrt(max(peclet, 1.0e-4_wp)))
        if (body%layers > 0) last = max(last, 20.0_wp*a/body%h(1))
        call gauss_legendre(waves%node, waves%share, error)
        call wave_rule(1.0e-8_wp, last, 2.0_wp, waves%z, waves%weight, error)
        if (allocated(error)) return
        allocate (waves%hat, mold=waves%z)
        do i = 1, size(waves%z)
            call even_waves(waves%z(i), values, error)
            if (allocated(error)) return
            waves%hat(i) = a/pi*sum(values*load)
        end do
    end subroutine find_waves

    !> Add the temperatures at the centre and the mean over the heat.
    subroutine add_means(body, a, speed, waves, heat, error)
        type(conductors_t), intent(in) :: body
        real(wp), intent(in) :: a, speed
        type(waves_t), intent(in) :: waves
        type(heat_t), intent(inout) :: heat
        type(error_t), allocatable, intent(inout) :: error
        real(wp), allocatable :: means(:, :)
        real(wp) :: less
        integer :: i

        call find_means(body, a, speed, waves, [0.0_wp], waves%z(size(waves%z)), means, error)
        if (allocated(error)) return
        do i = 1, size(waves%z)
            less = means(1, i)*waves%weight(i)/(a*body%s(1))*waves%hat(i)
            heat%centre = heat%centre + less
            heat%flux_mean = heat%flux_mean + 2.0_wp*pi/heat%total*waves%hat(i)*less
        end do
    end subroutine add_means

    !> T at distances behind the centre, along the line through it.
    subroutine temperatures(body, a, speed, load, waves, x, last, values, error)
        type(conductors_t), intent(in) :: body
        real(wp), intent(in) :: a, speed, load(:)
        type(waves_t), intent(in) :: waves
        !> 0 <= x <= a [length]
        real(wp), intent(in) :: x(:)
        !> wave up to which the motion shows
        real(wp), intent(in) :: last
        real(wp), intent(out) :: values(:)
        type(error_t), allocatable, intent(inout) :: error
        real(wp), allocatable :: means(:, :)
        real(wp) :: flux_z(size(x)), flux_r(size(x))
        integer :: i

        values = 0.0_wp
        call fields_inside(body, a, load, x, spread(0.0_wp, 1, size(x)), .true., values, flux_z, flux_r, error)
        if (allocated(error)) return
        call find_means(body, a, speed, waves, x, last, means, error)
        if (allocated(error)) return
        do i = 1, size(means, 2)
            values = values + waves%hat(i)*waves%weight(i)/(a*body%s(1))*means(:, i)
        end do
    end subroutine temperatures

    !> The means over all directions of the waves up to one, octave by octave where their phase is a factor.
    subroutine find_means(body, a, speed, waves, x, last, means, error)
        type(conductors_t), intent(in) :: body
        real(wp), intent(in) :: a, speed
        type(waves_t), intent(in) :: waves
        !> >= 0 [length]
        real(wp), intent(in) :: x(:)
        !> over a
        real(wp), intent(in) :: last
        !> (x, wave)
        real(wp), allocatable, intent(out) :: means(:, :)
        type(error_t), allocatable, intent(inout) :: error
        real(wp) :: from
        integer :: i, n, next

        n = count(waves%z <= last)
        allocate (means(size(x), n))
        from = first_octave
        if (maxval(x) > 0.0_wp) from = max(from, many_phases*a/max(minval(x), tiny(a)))
        i = 1
        do while (i <= n)
            call check_cancelled(error)
            if (allocated(error)) return
            if (waves%z(i) <= from) then
                next = i + 1
                call find_directions(body, waves, waves%z(i)/a, speed, x, means(:, i))
            else
                next = i + count(waves%z(i:n) <= 2.0_wp*waves%z(i))
                call find_octave(body, waves, waves%z(i:next - 1)/a, speed, x, means(:, i:next - 1))
            end if
            i = next
        end do
    end subroutine find_means

    !> The means of the waves of an octave: by series if they are many, unless these miss the wave in the middle.
    pure subroutine find_octave(body, waves, k, speed, x, means)
        type(conductors_t), intent(in) :: body
        type(waves_t), intent(in) :: waves
        !> ascending
        real(wp), intent(in) :: k(:), speed, x(:)
        !> (x, wave)
        real(wp), intent(out) :: means(:, :)
        real(wp) :: middle(size(x))
        integer :: i

        if (size(k) > octave_terms) then
            call find_by_series(body, waves, k, speed, x, means)
            i = size(k)/2
            middle = mean_of(k(i))
            if (all(abs(means(:, i) - middle) <= series_error*maxval(abs(means), dim=2))) return
        end if
        do i = 1, size(k)
            means(:, i) = mean_of(k(i))
        end do
    contains
        pure function mean_of(k) result(mean)
            real(wp), intent(in) :: k
            real(wp) :: mean(size(x)), parts(3, size(x))

            call find_parts(body, waves, k, speed, x, parts)
            mean = parts(1, :) + parts(2, :)*cos(k*x) - parts(3, :)*sin(k*x)
        end function mean_of
    end subroutine find_octave

    !> The same by series of what the means are without their phase.
    pure subroutine find_by_series(body, waves, k, speed, x, means)
        type(conductors_t), intent(in) :: body
        type(waves_t), intent(in) :: waves
        real(wp), intent(in) :: k(:), speed, x(:)
        real(wp), intent(out) :: means(:, :)
        real(wp) :: cosines(octave_terms, octave_terms), values(3, size(x), octave_terms), sums(size(k), 3)
        real(wp) :: ends(2)
        integer :: i, j

        ends = k([1, size(k)])
        do i = 1, octave_terms
            call find_parts(body, waves, ends(1) + 0.5_wp*(ends(2) - ends(1))*(1.0_wp + node(i, octave_terms)), speed, x, &
                            values(:, :, i))
        end do
        call cosine_transform(cosines)
        do i = 1, size(x)
            do j = 1, 3
                call chebyshev_sums(matmul(values(j, i, :), cosines), ends(1), ends(2), k, sums(:, j))
            end do
            means(i, :) = sums(:, 1) + sums(:, 2)*cos(k*x(i)) - sums(:, 3)*sin(k*x(i))
        end do
    end subroutine find_by_series

    !> The mean over all directions in parts: what has no phase, and real and imaginary part of the factor of exp(i k x).
    pure subroutine find_parts(body, waves, k, speed, x, parts)
        type(conductors_t), intent(in) :: body
        type(waves_t), intent(in) :: waves
        !> x all 0, or k x large
        real(wp), intent(in) :: k, speed, x(:)
        !> (3, size(x))
        real(wp), intent(out) :: parts(:, :)

        parts = 0.0_wp
        if (maxval(x) > 0.0_wp) then
            call find_complex_directions(body, waves, k, speed, x, parts)
        else
            call find_directions(body, waves, k, speed, x, parts(1, :))
        end if
    end subroutine find_parts

    !> The place, -1 to 1, where a series with these values at its points is largest.
    pure function place_of_largest(values) result(place)
        real(wp), intent(in) :: values(terms)
        real(wp) :: place
        real(wp) :: series(2, terms), x(0:places), found(0:places)
        integer :: i

        series = series_of_values(spread(values, 1, 2))
        x = [(-1.0_wp + 2.0_wp*i/places, i=0, places)]
        do i = 0, places
            found(i) = minval(series_value(series, x(i)))
        end do
        i = min(max(maxloc(found, dim=1) - 1, 1), places - 1)
        place = min(max(x(i) + (x(2) - x(1))*top(found(i - 1:i + 1)), -1.0_wp), 1.0_wp)
    end function place_of_largest

    !> Where the parabola through values at -1, 0 and 1 is largest, within -2 and 2; of one that opens upwards, 0.
    pure function top(values) result(place)
        real(wp), intent(in) :: values(3)
        real(wp) :: place, bend

        place = 0.0_wp
        bend = values(3) - 2.0_wp*values(2) + values(1)
        if (bend < 0.0_wp) place = min(max(0.5_wp*(values(1) - values(3))/bend, -2.0_wp), 2.0_wp)
    end function top

    !> The mean over all directions of Re[(chi(k, i v k cos phi) - chi(k, 0)) exp(i k x cos phi)]. Panels are halved towards
    !> cos phi = 0, near which lies the branch point cos phi = i k/(v c/kappa_r), and short where the phase turns.
    pure subroutine find_directions(body, waves, k, speed, x, mean)
        type(conductors_t), intent(in) :: body
        type(waves_t), intent(in) :: waves
        real(wp), intent(in) :: k, speed, x(:)
        !> same size as x
        real(wp), intent(out) :: mean(:)
        complex(wp) :: one_plus_chi, chi, rest
        real(wp) :: left, right, near, longest, cosine
        integer :: j

        mean = 0.0_wp
        call body%response(cmplx(k, 0.0_wp, wp), (0.0_wp, 0.0_wp), one_plus_chi, rest)
        near = branch_point(body, k, speed)
        longest = longest_phase/max(k*maxval(x), tiny(k))
        right = half_pi
        do while (right > 0.0_wp)
            left = max(0.5_wp*right, right - longest)
            if (right <= min(near, longest) .or. right < shortest_panel) left = 0.0_wp
            do j = 1, direction_nodes
                cosine = sin(left + (right - left)*waves%node(j))
                call body%response(cmplx(k, 0.0_wp, wp), cmplx(0.0_wp, speed*k*cosine, wp), one_plus_chi, chi)
                chi = (right - left)*waves%share(j)*(chi - rest)
                mean = mean + real(chi, wp)*cos(k*cosine*x) - aimag(chi)*sin(k*cosine*x)
            end do
            right = left
        end do
        mean = mean/half_pi
    end subroutine find_directions

    !> The size of cos phi at which chi changes from that of the source at rest.
    pure function branch_point(body, k, speed) result(cosine)
        type(conductors_t), intent(in) :: body
        real(wp), intent(in) :: k, speed
        real(wp) :: cosine

        cosine = min(k, 1.0_wp/max(body%depth(), tiny(k)))/max(speed*maxval(body%rate), tiny(k))
    end function branch_point

    !> The same at points where the phase turns often, in the parts of find_parts: from c = cos phi = 0 and from 1 along paths of
    !> complex c, exp(i pi/4) rho and 1 + i t^2, on which exp(i k x c) decays. Poles and branch points of chi have i c < 0, on the
    !> imaginary axis.
    pure subroutine find_complex_directions(body, waves, k, speed, x, parts)
        type(conductors_t), intent(in) :: body
        type(waves_t), intent(in) :: waves
        !> x > 0
        real(wp), intent(in) :: k, speed, x(:)
        !> (3, size(x))
        real(wp), intent(out) :: parts(:, :)
        complex(wp), parameter :: ray = (1.0_wp, 1.0_wp)*sqrt(0.5_wp)
        complex(wp) :: one_plus_chi, rest, c, from_zero(size(x)), from_one(size(x))
        real(wp) :: left, right, near, longest, t
        integer :: i, j

        from_zero = 0.0_wp
        from_one = 0.0_wp
        call body%response(cmplx(k, 0.0_wp, wp), (0.0_wp, 0.0_wp), one_plus_chi, rest)
        near = 0.5_wp*branch_point(body, k, speed)
        longest = longest_phase/(k*maxval(x))
        right = sqrt(2.0_wp)*decay/(k*minval(x))
        do while (right > 0.0_wp)
            left = max(0.5_wp*right, right - longest)
            if (right <= min(near, longest) .or. right < shortest_panel) left = 0.0_wp
            do j = 1, direction_nodes
                c = ray*(left + (right - left)*waves%node(j))
                from_zero = from_zero + (right - left)*waves%share(j)*ray/sqrt(1.0_wp - c**2)*change(body, k, speed, c, rest) &
                            *exp((0.0_wp, 1.0_wp)*k*c*x)
            end do
            right = left
        end do
        right = sqrt(decay/(k*minval(x)))/panels_from_one
        do i = 1, panels_from_one
            do j = 1, direction_nodes
                t = right*(i - 1 + waves%node(j))
                c = cmplx(1.0_wp, t**2, wp)
                ! -2 i t dt/sqrt(1 - c^2)
                from_one = from_one + right*waves%share(j)*(0.0_wp, -2.0_wp)/sqrt(cmplx(t**2, -2.0_wp, wp)) &
                           *change(body, k, speed, c, rest)*exp(-k*t**2*x)
            end do
        end do
        parts(1, :) = real(from_zero, wp)/half_pi
        parts(2, :) = real(from_one, wp)/half_pi
        parts(3, :) = aimag(from_one)/half_pi
    end subroutine find_complex_directions

    !> dchi in one complex direction c.
    pure function change(body, k, speed, c, rest) result(value)
        type(conductors_t), intent(in) :: body
        real(wp), intent(in) :: k, speed
        !> chi(k, 0)
        complex(wp), intent(in) :: c, rest
        complex(wp) :: value
        complex(wp) :: one_plus_chi

        call body%response(cmplx(k, 0.0_wp, wp), (0.0_wp, 1.0_wp)*speed*k*c, one_plus_chi, value)
        value = value - rest
    end function change

end module mdrcontact_conduction_moving
