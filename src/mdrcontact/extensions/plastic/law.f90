! SPDX-License-Identifier: GPL-3.0-or-later
!> The contact law of a body that yields: force, slope and radius of many contacts over the depth, each of which remembers its
!> largest depth (theory/plastic.md (9.1)).
!>
!> A contact that has not yielded is that of the elastic law. On first loading the force is a polynomial of the depth. Below the
!> largest depth the contact is elastic, with the imprint that the largest depth has left, in closed form. With adhesion the
!> contact also remembers whether it is closed, and the energy that its jumps have lost.
!>
!> include/mdrcontact_plastic_law.h evaluates a law; law/kernel.c calls it.
module mdrcontact_plastic_law
    use, intrinsic :: iso_c_binding, only: c_double, c_int, c_loc, c_null_ptr, c_ptr
    use mdrcontact_batch, only: batch_t, check_threads, run_batch
    use mdrcontact_error, only: check_finite, check_made, check_positive, error_domain, error_invalid, error_t, raise, &
                                raise_at, to_text
    use mdrcontact_kinds, only: wp
    use mdrcontact_law_evaluate, only: law_view_t
    use mdrcontact_law_table, only: law_table_t
    implicit none (type, external)
    private
    public :: plastic_law_t, plastic_steps_t, plastic_view_t, view_of

    !> Energy that no contact loses, as in mdrcontact_plastic_law.h [modulus length^3].
    real(wp), parameter :: most_lost = 1.0e150_wp

    !> struct mdr_plastic_view of include/mdrcontact_plastic_law.h.
    type, bind(C) :: plastic_view_t
        type(law_view_t) :: elastic, virgin
        real(c_double) :: yield = 0.0_c_double, highest = 0.0_c_double
        type(c_ptr) :: edges = c_null_ptr, rows = c_null_ptr, energy = c_null_ptr, tension = c_null_ptr
        real(c_double) :: modulus = 0.0_c_double, line = 0.0_c_double, hertz = 0.0_c_double, radius = 0.0_c_double, &
                          touch = 0.0_c_double
        integer(c_int) :: panels = 0_c_int, coated = 0_c_int
    end type plastic_view_t

    !> A law. It never changes.
    type :: plastic_law_t
        !> all numbers that a view reads
        real(wp), allocatable :: buffer(:)
        !> the elastic law that the buffer holds
        type(law_table_t) :: elastic
        !> d and F at first yield; a E*/(R Y) there of the body that yields, 0 if it is not known
        real(wp) :: yield_depth = 0.0_wp, yield_force = 0.0_wp, first_yield = 0.0_wp
        !> the largest depth, F and a there
        real(wp) :: largest_depth = 0.0_wp, largest_force = 0.0_wp, largest_radius = 0.0_wp
        !> whether E* with which a contact unloads varies with its largest depth
        logical :: is_coated = .false.
        !> R of a paraboloid [length], 0: the law is one of points; E*, of a coated body at the largest depth [modulus]; work of
        !> adhesion [modulus length]
        real(wp) :: radius = 0.0_wp, modulus = 0.0_wp, work_of_adhesion = 0.0_wp
        !> the tolerance set, and the largest error of the polynomials that was found, relative
        real(wp) :: tolerance = 0.0_wp, error = 0.0_wp
        !> whether it was made: set last by what makes it
        logical :: is_made = .false.
    contains
        procedure :: memory_size
        procedure :: steps
        procedure :: energies
        procedure :: first_loading
        procedure :: restitution
    end type plastic_law_t

    !> One step of each of many contacts; arrays of n.
    type :: plastic_steps_t
        !> d at the end of the step [length]
        real(wp), pointer, contiguous :: depth(:) => null()
        !> of each contact (memory_size(), n)
        real(wp), pointer, contiguous :: memory(:, :) => null()
        !> receive F, dF/dd along the path and a; null: not requested
        real(wp), pointer, contiguous :: force(:) => null(), slope(:) => null(), radius(:) => null()
        !> whether the memories are to remain as they are: a trial
        logical :: is_trial = .false.
    end type plastic_steps_t

    !> A path of one contact.
    type :: path_t
        real(wp) :: depth(1) = 0.0_wp
        real(wp), allocatable :: memory(:, :)
    end type path_t

    type, extends(batch_t) :: work_t
        type(plastic_view_t) :: view
        type(plastic_steps_t) :: steps
    contains
        procedure :: work => do_steps
    end type work_t

    !> Contacts that a thread takes at a time, and from how many on several threads pay.
    integer, parameter :: block_size = 2048, smallest_parallel = 8*block_size
    !> Most steps of a search, and where it ends.
    integer, parameter :: most_steps = 200
    real(wp), parameter :: close = 4.0_wp*epsilon(1.0_wp)

    interface
        function mdrcontact_plastic_view(buffer, view) result(status) bind(C)
            import :: c_int, c_ptr, plastic_view_t
            type(c_ptr), intent(in), value :: buffer
            type(plastic_view_t), intent(inout) :: view
            integer(c_int) :: status
        end function mdrcontact_plastic_view

        function mdrcontact_plastic_steps(view, n, depth, is_trial, memory, force, slope, radius) result(done) bind(C)
            import :: c_double, c_int, c_ptr, plastic_view_t
            type(plastic_view_t), intent(in) :: view
            integer(c_int), intent(in), value :: n, is_trial
            real(c_double), intent(in) :: depth(n)
            type(c_ptr), intent(in), value :: memory, force, slope, radius
            integer(c_int) :: done
        end function mdrcontact_plastic_steps

        pure function mdrcontact_plastic_possible(view, largest, n, depth, memory) result(possible) bind(C)
            import :: c_double, c_int, plastic_view_t
            type(plastic_view_t), intent(in) :: view
            real(c_double), intent(in), value :: largest
            integer(c_int), intent(in), value :: n
            real(c_double), intent(in) :: depth(n), memory(n)
            integer(c_int) :: possible
        end function mdrcontact_plastic_possible

        function mdrcontact_plastic_energies(view, n, depth, memory, stored, dissipated) result(done) bind(C)
            import :: c_double, c_int, c_ptr, plastic_view_t
            type(plastic_view_t), intent(in) :: view
            integer(c_int), intent(in), value :: n
            real(c_double), intent(in) :: depth(n)
            type(c_ptr), intent(in), value :: memory
            real(c_double), intent(inout) :: stored(n), dissipated(n)
            integer(c_int) :: done
        end function mdrcontact_plastic_energies

        function mdrcontact_plastic_residual(view, deepest) result(residual) bind(C)
            import :: c_double, plastic_view_t
            type(plastic_view_t), intent(in) :: view
            real(c_double), intent(in), value :: deepest
            real(c_double) :: residual
        end function mdrcontact_plastic_residual
    end interface

contains

    !> Numbers in the memory of a contact: the largest depth; with adhesion also the energy that jumps have lost.
    pure function memory_size(self) result(count)
        class(plastic_law_t), intent(in) :: self
        integer :: count

        count = merge(2, 1, self%work_of_adhesion > 0.0_wp)
    end function memory_size

    !> The view of a law, which must outlive it.
    function view_of(law) result(view)
        type(plastic_law_t), intent(in), target :: law
        type(plastic_view_t) :: view
        integer(c_int) :: status

        status = mdrcontact_plastic_view(c_loc(law%buffer), view)
    end function view_of

    !> One step of each of many contacts, on `threads` threads (0: as many as the runtime offers). After an error all memories are
    !> as before, and the error names the first contact that failed.
    subroutine steps(self, contacts, threads, error)
        class(plastic_law_t), intent(in), target :: self
        type(plastic_steps_t), intent(in) :: contacts
        !> >= 0
        integer, intent(in) :: threads
        type(error_t), allocatable, intent(out) :: error
        type(work_t) :: work

        call check_made(error, "law", self%is_made)
        if (allocated(error)) return
        call check_threads(error, threads)
        work%is_quick = .true.
        work%view = view_of(self)
        call check_contacts(self, work%view, contacts%depth, contacts%memory, error)
        if (allocated(error)) return
        work%steps = contacts
        call run_batch(work, size(contacts%depth), block_size, smallest_parallel, threads, error)
    end subroutine steps

    !> Raises for the first contact whose depth or memory is not one of the law.
    pure subroutine check_contacts(self, view, depth, memory, error)
        type(plastic_law_t), intent(in) :: self
        type(plastic_view_t), intent(in) :: view
        real(wp), intent(in), contiguous :: depth(:), memory(:, :)
        type(error_t), allocatable, intent(inout) :: error
        integer :: i

        if (size(memory, 1) /= self%memory_size() .or. size(memory, 2) /= size(depth)) then
            call raise(error, error_invalid, ": it must have memory_size numbers for each depth", "memory")
        end if
        if (allocated(error)) return
        if (size(memory, 1) == 1 .and. size(depth) > 0) then
            if (mdrcontact_plastic_possible(view, self%largest_depth, size(depth, kind=c_int), depth, memory) /= 0) return
        end if
        do i = 1, size(depth)
            if (allocated(error)) return
            if (is_possible(self, view, depth(i), memory(:, i))) cycle
            call check_step(self, view, depth(i), memory(:, i), error)
            if (allocated(error)) call raise_at(error, i)
        end do
    end subroutine check_contacts

    !> Whether a step certainly has no error.
    pure function is_possible(self, view, depth, memory) result(possible)
        type(plastic_law_t), intent(in) :: self
        type(plastic_view_t), intent(in) :: view
        real(wp), intent(in) :: depth, memory(:)
        logical :: possible

        possible = depth <= self%largest_depth .and. depth >= -huge(1.0_wp)
        if (size(memory) == 1) then
            possible = possible .and. memory(1) >= 0.0_wp .and. memory(1) <= view%highest
        else
            possible = possible .and. abs(memory(1)) <= view%highest .and. memory(2) >= 0.0_wp .and. memory(2) <= most_lost
        end if
    end function is_possible

    !> The error of a step that is not possible.
    pure subroutine check_step(self, view, depth, memory, error)
        type(plastic_law_t), intent(in) :: self
        type(plastic_view_t), intent(in) :: view
        real(wp), intent(in) :: depth, memory(:)
        type(error_t), allocatable, intent(inout) :: error

        call check_finite(error, "depth", depth)
        if (allocated(error)) return
        if (depth > self%largest_depth) then
            call raise(error, error_domain, " = "//to_text(depth)//": the largest depth of the law is "// &
                       to_text(self%largest_depth)//". Increase largest_depth", "depth")
        else if (.not. is_possible(self, view, 0.0_wp, memory)) then
            call raise(error, error_invalid, " = "//to_text(memory(1))//": it must be 0 before the first step, and later what "// &
                       "a step of this law has left", "memory")
        end if
    end subroutine check_step

    subroutine do_steps(self, first, last, error)
        class(work_t), intent(inout) :: self
        integer, intent(in) :: first, last
        type(error_t), allocatable, intent(out) :: error
        integer(c_int) :: done

        associate (s => self%steps)
            done = mdrcontact_plastic_steps(self%view, int(last - first + 1, c_int), s%depth(first:last), &
                                            merge(1_c_int, 0_c_int, s%is_trial), c_loc(s%memory(1, first)), &
                                            place(s%force, first), place(s%slope, first), place(s%radius, first))
            if (done > last - first) return
            call raise(error, error_domain, " = "//to_text(s%depth(first + done))//": the contact leaves the range of the "// &
                       "law. Increase largest_depth", "depth")
            call raise_at(error, first + int(done))
        end associate
    end subroutine do_steps

    !> Where entry i of an array lies; null for no array.
    function place(array, i) result(pointer)
        real(wp), pointer, intent(in) :: array(:)
        integer, intent(in) :: i
        type(c_ptr) :: pointer

        pointer = c_null_ptr
        if (associated(array)) pointer = c_loc(array(i))
    end function place

    !> What contacts at depths store, and what they have dissipated since their first step [modulus length^3]. A step to the
    !> depth is taken without a change of the memory.
    subroutine energies(self, depth, memory, stored, dissipated, error)
        class(plastic_law_t), intent(in) :: self
        !> [length]
        real(wp), intent(in), contiguous :: depth(:)
        !> (memory_size(), n)
        real(wp), intent(in), contiguous, target :: memory(:, :)
        !> as many [modulus length^3]
        real(wp), intent(inout), contiguous :: stored(:), dissipated(:)
        type(error_t), allocatable, intent(out) :: error
        type(plastic_view_t) :: view
        integer :: i, n

        call check_made(error, "law", self%is_made)
        if (allocated(error)) return
        n = size(depth)
        view = view_of(self)
        call check_contacts(self, view, depth, memory, error)
        if (allocated(error)) return
        i = int(mdrcontact_plastic_energies(view, int(n, c_int), depth, c_loc(memory), stored, dissipated))
        if (i < n) call raise(error, error_domain, " = "//to_text(depth(i + 1))//": the contact leaves the range of the law. "// &
                              "Increase largest_depth", "depth", i + 1)
    end subroutine energies

    !> First loading to a depth: F, a, the depth at which an open contact closes again, and the work int F dd.
    subroutine first_loading(self, depth, force, radius, residual, work, error)
        class(plastic_law_t), intent(in) :: self
        !> up to the largest one [length]
        real(wp), intent(in) :: depth
        !> [modulus length^2], [length], [length], [modulus length^3]
        real(wp), intent(out) :: force, radius, residual, work
        type(error_t), allocatable, intent(out) :: error
        type(path_t) :: path

        force = 0.0_wp
        radius = 0.0_wp
        residual = 0.0_wp
        work = 0.0_wp
        call check_made(error, "law", self%is_made)
        if (allocated(error)) return
        call begin_path(self, path)
        call go_to(self, path, depth, force, radius, error)
        call energies_on(self, path, work, error)
        if (allocated(error)) return
        residual = mdrcontact_plastic_residual(view_of(self), abs(path%memory(1, 1)))
    end subroutine first_loading

    !> A contact before its first step.
    subroutine begin_path(law, path)
        class(plastic_law_t), intent(in) :: law
        type(path_t), intent(out) :: path

        allocate (path%memory(law%memory_size(), 1), source=0.0_wp)
    end subroutine begin_path

    !> A step of one contact.
    subroutine go_to(law, path, depth, force, radius, error)
        class(plastic_law_t), intent(in) :: law
        type(path_t), intent(inout), target :: path
        real(wp), intent(in) :: depth
        real(wp), intent(out) :: force, radius
        type(error_t), allocatable, intent(inout) :: error
        real(wp), target :: f(1), a(1)
        type(plastic_steps_t) :: step

        f = 0.0_wp
        a = 0.0_wp
        path%depth = depth
        step%depth => path%depth
        step%memory => path%memory
        step%force => f
        step%radius => a
        if (.not. allocated(error)) call law%steps(step, 1, error)
        force = f(1)
        radius = a(1)
    end subroutine go_to

    !> What the contact stores and what it has lost, together or the latter alone.
    subroutine energies_on(law, path, sum, error, lost)
        class(plastic_law_t), intent(in) :: law
        type(path_t), intent(in) :: path
        real(wp), intent(out) :: sum
        type(error_t), allocatable, intent(inout) :: error
        real(wp), intent(out), optional :: lost
        real(wp) :: stored(1), dissipated(1)

        stored = 0.0_wp
        dissipated = 0.0_wp
        if (.not. allocated(error)) call law%energies(path%depth, path%memory, stored, dissipated, error)
        sum = stored(1) + dissipated(1)
        if (present(lost)) lost = dissipated(1)
    end subroutine energies_on

    !> Coefficient of restitution of a mass that meets the contact with a speed, without waves: what is left of the energy after
    !> plastic flow and, with adhesion, after the jumps; 0: it sticks (theory/plastic.md (5.1)).
    subroutine restitution(self, mass, speed, coefficient, error)
        class(plastic_law_t), intent(in) :: self
        !> the reduced mass > 0 [mass], and the speed > 0 at initial contact; mass speed^2 in [modulus length^3]
        real(wp), intent(in) :: mass, speed
        !> [1]
        real(wp), intent(out) :: coefficient
        type(error_t), allocatable, intent(out) :: error
        type(path_t) :: path
        real(wp) :: energy, low, high, middle, force, radius, residual, work, lost
        integer :: i

        coefficient = 1.0_wp
        call check_made(error, "law", self%is_made)
        if (allocated(error)) return
        call check_positive(error, "mass", mass)
        call check_positive(error, "speed", speed)
        energy = 0.5_wp*mass*speed**2
        if (.not. allocated(error)) call check_positive(error, "mass speed^2", energy)
        if (allocated(error)) return
        low = 0.0_wp
        high = self%largest_depth
        call self%first_loading(high, force, radius, residual, work, error)
        if (.not. allocated(error) .and. energy > work) then
            call raise(error, error_domain, " = "//to_text(speed)//": the law ends at the speed "// &
                       to_text(sqrt(2.0_wp*work/mass))//" of this mass. Increase largest_depth", "speed")
        end if
        do i = 1, most_steps
            if (allocated(error) .or. high - low <= close*high) exit
            middle = 0.5_wp*(low + high)
            call self%first_loading(middle, force, radius, residual, work, error)
            if (work < energy) then
                low = middle
            else
                high = middle
            end if
        end do
        call begin_path(self, path)
        call go_to(self, path, high, force, radius, error)
        call go_to(self, path, -self%largest_depth, force, radius, error)
        call energies_on(self, path, work, error, lost)
        if (.not. allocated(error)) coefficient = sqrt(max(energy - lost, 0.0_wp)/energy)
    end subroutine restitution

end module mdrcontact_plastic_law
