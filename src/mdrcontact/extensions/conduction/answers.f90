! SPDX-License-Identifier: GPL-3.0-or-later
!> Response of a contact area in time: at a frequency, and after a step, by an inverse Laplace transform for all times up to a
!> factor apart (theory/conduction.md (9.3)-(9.5)).
module mdrcontact_conduction_answers
    use mdrcontact_codes, only: spot_conductance_answer => conductance, spot_resistance_answer => resistance
    use mdrcontact_conduction_bodies, only: conduction_t
    use mdrcontact_conduction_fields, only: check_inside, conductance_at
    use mdrcontact_conduction_film, only: film_basis_t, film_spot_at, new_film_basis
    use mdrcontact_conduction_spot, only: set_series
    use mdrcontact_conduction_transient, only: basis_for, gaussian, given_flux, spot_at, uniform_centre, uniform_mean
    use mdrcontact_cancel, only: check_cancelled
    use mdrcontact_error, only: check_code, check_finite, check_made, check_memory, check_not_negative, check_positive, &
                                error_domain, error_invalid, error_t, raise, to_text
    use mdrcontact_kinds, only: wp
    use mdrcontact_line_fields, only: line_load_t
    use mdrcontact_numerics_laplace, only: inverse_laplace
    use mdrcontact_numerics_waves, only: basis_t
    implicit none (type, external)
    private
    public :: spot_conductance_answer, spot_resistance_answer, admittance_of, step_of, follow_history, flux_after_step

    !> Times up to this factor apart share so many nodes: exp(-2 pi nodes/sqrt(8 span + 1)) = 1e-13; one time takes
    !> fewer.
    real(wp), parameter :: span = 4.0_wp
    integer, parameter :: shared_nodes = 28, own_nodes = 16
    !> Largest relative difference of time steps that count as equal.
    real(wp), parameter :: even = 1.0e-9_wp
    !> D t/a^2 from which on responses are solved, D the largest diffusivity at the surface, and omega a^2/D up to which.
    real(wp), parameter :: first_time = 1.0e-4_wp, last_frequency = 1.0e5_wp

    !> Expansion of the solution: without a film in the contact area, and with one.
    type :: waves_t
        type(basis_t) :: basis
        type(film_basis_t) :: film
    end type waves_t

contains

    !> At frequencies: G, 1/G, or the potential per flux. Steady at 0.
    subroutine admittance_of(conduction, answer, a, omega, values, error)
        type(conduction_t), intent(in) :: conduction
        !> spot_conductance_answer, spot_resistance_answer, uniform_mean, uniform_centre or gaussian
        integer, intent(in) :: answer
        !> > 0 [length]
        real(wp), intent(in) :: a
        !> >= 0 [1/time]
        real(wp), intent(in) :: omega(:)
        !> same size as omega
        complex(wp), intent(out) :: values(:)
        type(error_t), allocatable, intent(out) :: error
        real(wp) :: fastest
        integer :: i

        values = 0.0_wp
        call check_made(error, "conduction", conduction%is_made)
        if (allocated(error)) return
        call check_answer(answer, a, error)
        fastest = diffusivity_limit(conduction)
        do i = 1, size(omega)
            call check_not_negative(error, "omega", omega(i), i)
            if (allocated(error)) return
            if (omega(i)*a**2*fastest > last_frequency) then
                call raise(error, error_domain, " = "//to_text(omega(i))//": omega a^2/D of the surface must be at most "// &
                           to_text(last_frequency)//". Beyond, the flow is one-dimensional: G = pi a^2 sqrt(s kappa c)", "omega", i)
                return
            end if
            call check_cancelled(error)
            call at(conduction, answer, a, cmplx(0.0_wp, omega(i), wp), values(i), error)
            if (allocated(error)) return
        end do
    end subroutine admittance_of

    !> Raises for times that come too early.
    subroutine check_time(conduction, a, time, entry, error)
        type(conduction_t), intent(in) :: conduction
        real(wp), intent(in) :: a, time
        integer, intent(in) :: entry
        type(error_t), allocatable, intent(inout) :: error

        call check_positive(error, "time", time, entry)
        if (allocated(error) .or. time >= first_time*a**2*diffusivity_limit(conduction)) return
        call raise(error, error_domain, " = "//to_text(time)//": D t/a^2 of the surface must be at least "//to_text(first_time)// &
                   ". Before, the flow is one-dimensional: G = pi a^2 sqrt(kappa c/(pi t)) + pi a kappa", "time", entry)
    end subroutine check_time

    subroutine check_answer(answer, a, error)
        integer, intent(in) :: answer
        real(wp), intent(in) :: a
        type(error_t), allocatable, intent(inout) :: error

        call check_code(error, "answer", answer, [spot_conductance_answer, spot_resistance_answer, uniform_mean, uniform_centre, &
                                               gaussian])
        call check_positive(error, "radius", a)
    end subroutine check_answer

    !> Largest c/kappa_r at the surface.
    pure function diffusivity_limit(conduction) result(rate)
        type(conduction_t), intent(in) :: conduction
        real(wp) :: rate
        integer :: i

        rate = maxval([(conduction%bodies(i)%rate(1), i=1, size(conduction%bodies))])
    end function diffusivity_limit

    !> At one Laplace variable.
    subroutine at(conduction, answer, a, s, value, error)
        type(conduction_t), intent(in) :: conduction
        integer, intent(in) :: answer
        real(wp), intent(in) :: a
        complex(wp), intent(in) :: s
        complex(wp), intent(out) :: value
        type(error_t), allocatable, intent(inout) :: error
        type(waves_t) :: waves

        value = 0.0_wp
        if (allocated(error)) return
        if (.not. abs(s) > 0.0_wp) then
            call conduction%check_steady(error)
            call conduction%check_radius(a, error)
        end if
        call find_waves(conduction, answer, a, abs(s), abs(s), waves, error)
        call answer_at(conduction, answer, a, s, waves, value, error)
    end subroutine at

    !> Data shared by contact areas at Laplace variables of sizes between two.
    subroutine find_waves(conduction, answer, a, smallest, largest, waves, error)
        type(conduction_t), intent(in) :: conduction
        integer, intent(in) :: answer
        real(wp), intent(in) :: a, smallest, largest
        type(waves_t), intent(out) :: waves
        type(error_t), allocatable, intent(inout) :: error

        if (allocated(error) .or. .not. is_of_spot(answer) .or. .not. largest > 0.0_wp) return
        if (conduction%film > 0.0_wp) then
            call new_film_basis(waves%film, conduction, a, largest, error)
        else
            call basis_for(conduction, a, smallest, largest, waves%basis, error)
        end if
    end subroutine find_waves

    subroutine answer_at(conduction, answer, a, s, waves, value, error)
        type(conduction_t), intent(in) :: conduction
        integer, intent(in) :: answer
        real(wp), intent(in) :: a
        complex(wp), intent(in) :: s
        type(waves_t), intent(in) :: waves
        complex(wp), intent(inout) :: value
        type(error_t), allocatable, intent(inout) :: error
        real(wp) :: conductance, slope

        if (allocated(error)) return
        if (.not. is_of_spot(answer)) then
            call given_flux(conduction, answer, a, s, value, error)
        else if (.not. abs(s) > 0.0_wp) then
            call conductance_at(conduction, a, conductance, slope, error)
            value = conductance
        else if (conduction%film > 0.0_wp) then
            call film_spot_at(conduction, a, s, waves%film, value, error)
        else
            call spot_at(conduction, a, s, waves%basis, value, error)
        end if
        if (answer == spot_resistance_answer .and. .not. allocated(error)) value = 1.0_wp/value
    end subroutine answer_at

    !> Whether the potential of the contact area is given, not its flux.
    elemental function is_of_spot(answer)
        integer, intent(in) :: answer
        logical :: is_of_spot

        is_of_spot = answer == spot_conductance_answer .or. answer == spot_resistance_answer
    end function is_of_spot

    !> After a step of potential or flux at time 0.
    subroutine step_of(conduction, answer, a, time, values, error)
        type(conduction_t), intent(in) :: conduction
        !> as in admittance_of
        integer, intent(in) :: answer
        !> > 0 [length]
        real(wp), intent(in) :: a
        !> such that D t/a^2 >= 1e-4 with the D of every surface, or > 0 without a capacity there [time]
        real(wp), intent(in) :: time(:)
        !> same size as time
        real(wp), intent(out) :: values(:)
        type(error_t), allocatable, intent(out) :: error

        call check_made(error, "conduction", conduction%is_made)
        if (allocated(error)) return
        call respond(conduction, answer, a, time, .false., values, error)
    end subroutine step_of

    !> The response to a history of potential or flux that begins with 0 and goes evenly from one value to the next: ramps that
    !> begin at each time, superposed.
    subroutine follow_history(conduction, answer, a, time, given, values, error)
        type(conduction_t), intent(in) :: conduction
        !> as in admittance_of
        integer, intent(in) :: answer
        !> > 0 [length]
        real(wp), intent(in) :: a
        !> ascending, apart as step_of takes times [time]
        real(wp), intent(in) :: time(:)
        !> same size as time; the first is 0
        real(wp), intent(in) :: given(:)
        !> same size as time
        real(wp), intent(out) :: values(:)
        type(error_t), allocatable, intent(out) :: error
        real(wp), allocatable :: since(:), ramp(:)
        real(wp) :: slope, before
        integer :: i, j, n, stat
        logical :: is_even

        values = 0.0_wp
        call check_made(error, "conduction", conduction%is_made)
        if (allocated(error)) return
        n = size(time)
        call check_answer(answer, a, error)
        call check_history(time, given, error)
        if (allocated(error) .or. n < 2) return
        is_even = maxval(abs(time(2:) - time(:n - 1) - (time(n) - time(1))/(n - 1))) <= even*(time(n) - time(1))/(n - 1)
        allocate (since(merge(n - 1, n*(n - 1)/2, is_even)), stat=stat)
        call check_memory(error, stat)
        if (stat /= 0) return
        if (is_even) then
            since = [((time(n) - time(1))/(n - 1)*i, i=1, n - 1)]
        else
            do i = 2, n
                since(place(i, 1):place(i, i - 1)) = time(i) - time(:i - 1)
            end do
        end if
        allocate (ramp, mold=since)
        call respond(conduction, answer, a, since, .true., ramp, error)
        if (allocated(error)) return
        before = 0.0_wp
        do j = 1, n - 1
            slope = (given(j + 1) - given(j))/(time(j + 1) - time(j))
            do i = j + 1, n
                values(i) = values(i) + (slope - before)*ramp(merge(i - j, place(i, j), is_even))
            end do
            before = slope
        end do

    contains

        !> Index of a pair of times.
        pure integer function place(i, j)
            integer, intent(in) :: i, j

            place = (i - 1)*(i - 2)/2 + j
        end function place

    end subroutine follow_history

    !> Raises unless times ascend and what is given begins with 0.
    subroutine check_history(time, given, error)
        real(wp), intent(in) :: time(:), given(:)
        type(error_t), allocatable, intent(inout) :: error
        integer :: i

        do i = 1, size(time)
            call check_finite(error, "time", time(i), i)
            call check_finite(error, "given", given(i), i)
        end do
        if (allocated(error) .or. size(time) == 0) return
        if (abs(given(1)) > 0.0_wp) then
            call raise(error, error_invalid, " = "//to_text(given(1))//": a history must begin with 0. Use a short rise "// &
                       "instead of a step", "given", 1)
            return
        end if
        do i = 2, size(time)
            if (time(i) > time(i - 1)) cycle
            call raise(error, error_invalid, " = "//to_text(time(i))//": times must be strictly ascending", "time", i)
            return
        end do
    end subroutine check_history

    !> At times after a step, or after the beginning of a ramp of slope 1, those near to each other by the same nodes.
    subroutine respond(conduction, answer, a, time, is_ramp, values, error)
        type(conduction_t), intent(in) :: conduction
        integer, intent(in) :: answer
        real(wp), intent(in) :: a, time(:)
        logical, intent(in) :: is_ramp
        real(wp), intent(out) :: values(:)
        type(error_t), allocatable, intent(inout) :: error
        logical, allocatable :: done(:), chosen(:)
        real(wp) :: from
        integer :: i, stat

        values = 0.0_wp
        call check_answer(answer, a, error)
        do i = 1, size(time)
            call check_time(conduction, a, time(i), i, error)
        end do
        if (allocated(error)) return
        allocate (done(size(time)), chosen(size(time)), stat=stat)
        call check_memory(error, stat)
        if (stat /= 0) return
        done = .false.
        do while (.not. all(done))
            from = minval(time, mask=.not. done)
            chosen = .not. done .and. time <= span*from
            call check_cancelled(error)
            call by_shared_nodes(conduction, answer, a, pack(time, chosen), is_ramp, values, chosen, error)
            if (allocated(error)) return
            done = done .or. chosen
        end do
    end subroutine respond

    !> Flux density through a contact area without a film, a time after a step of its potential to 1.
    subroutine flux_after_step(conduction, a, time, r, values, error)
        type(conduction_t), intent(in) :: conduction
        !> > 0 [length]
        real(wp), intent(in) :: a
        !> as in step_of
        real(wp), intent(in) :: time
        !> 0 <= r < a [length]
        real(wp), intent(in) :: r(:)
        !> same size as r [conductance/length^2]
        real(wp), intent(out) :: values(:)
        type(error_t), allocatable, intent(out) :: error
        complex(wp) :: s(own_nodes), weight(own_nodes, 1), conductance
        complex(wp), allocatable :: series(:), total(:)
        type(basis_t) :: basis
        type(line_load_t) :: spot
        integer :: i

        values = 0.0_wp
        call check_made(error, "conduction", conduction%is_made)
        if (allocated(error)) return
        call check_answer(spot_conductance_answer, a, error)
        call check_time(conduction, a, time, 1, error)
        if (conduction%film > 0.0_wp .and. .not. allocated(error)) then
            call raise(error, error_invalid, "film: the transient flux density is not available with a film. Omit the film")
        end if
        call check_inside(r, a, error)
        if (allocated(error)) return
        call inverse_laplace([time], s, weight)
        call basis_for(conduction, a, abs(s(1)), abs(s(own_nodes)), basis, error)
        if (allocated(error)) return
        allocate (series(basis%order), total(basis%order))
        total = 0.0_wp
        do i = 1, own_nodes
            call check_cancelled(error)
            call spot_at(conduction, a, s(i), basis, conductance, error, series)
            if (allocated(error)) return
            total = total + weight(i, 1)*series
        end do
        call set_series(spot, a, aimag(total), sum(aimag(total)))
        values = [(spot%punch_pressure(r(i)), i=1, size(r))]
    end subroutine flux_after_step

    !> Times within a span by the same nodes.
    subroutine by_shared_nodes(conduction, answer, a, time, is_ramp, values, chosen, error)
        type(conduction_t), intent(in) :: conduction
        integer, intent(in) :: answer
        real(wp), intent(in) :: a, time(:)
        !> of slope 1, instead of a step
        logical, intent(in) :: is_ramp
        real(wp), intent(inout) :: values(:)
        !> where they belong in `values`
        logical, intent(in) :: chosen(:)
        type(error_t), allocatable, intent(inout) :: error
        complex(wp), allocatable :: s(:), weight(:, :), answered(:)
        real(wp) :: totals(size(time)), largest
        type(waves_t) :: waves
        integer :: i, n

        n = merge(shared_nodes, own_nodes, maxval(time) > minval(time))
        allocate (s(n), weight(n, size(time)), answered(n))
        call inverse_laplace(time, s, weight)
        ! beyond, exp(s t) leaves nothing of the last significant digits
        largest = maxval(abs(s), mask=real(s, wp)*minval(time) > -20.0_wp)
        call find_waves(conduction, answer, a, abs(s(1)), largest, waves, error)
        do i = 1, n
            call check_cancelled(error)
            call answer_at(conduction, answer, a, s(i), waves, answered(i), error)
            if (allocated(error)) return
            if (is_ramp) answered(i) = answered(i)/s(i)
        end do
        totals = [(sum(aimag(weight(:, i)*answered)), i=1, size(time))]
        values = unpack(totals, chosen, values)
    end subroutine by_shared_nodes

end module mdrcontact_conduction_answers
