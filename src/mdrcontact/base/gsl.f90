! SPDX-License-Identifier: GPL-3.0-or-later
!> The GSL calls that the library uses, as Fortran interfaces and nothing more.
!>
!> GSL's default error handler aborts the process. `disable_gsl_abort` is called before GSL is
!> used, and switches it off the first time, for the whole process: a program that relies on GSL's own handler must set it
!> again afterwards.
module mdrcontact_gsl
    use, intrinsic :: iso_c_binding, only: c_double, c_funptr, c_int, c_ptr, c_size_t
    implicit none (type, external)
    private
    public :: gsl_function, gsl_success
    public :: disable_gsl_abort
    public :: gsl_integration_glfixed_table_alloc, gsl_integration_glfixed_table_free, gsl_integration_glfixed_point
    public :: gsl_integration_fixed_jacobi, gsl_integration_fixed_alloc, gsl_integration_fixed_free, gsl_integration_fixed_nodes, &
              gsl_integration_fixed_weights
    public :: gsl_root_fsolver_brent, gsl_root_fsolver_alloc, gsl_root_fsolver_free, gsl_root_fsolver_set, &
              gsl_root_fsolver_iterate, gsl_root_fsolver_root, gsl_root_fsolver_x_lower, gsl_root_fsolver_x_upper, &
              gsl_root_test_interval
    public :: gsl_sf_bessel_j0, gsl_sf_bessel_j1, gsl_sf_bessel_il_scaled_array, gsl_sf_bessel_jl_steed_array, &
              gsl_sf_bessel_jn_array, gsl_sf_psi_1piy, &
              gsl_sf_ellint_ecomp, gsl_sf_ellint_kcomp, &
              gsl_sf_ellint_rd, gsl_sf_ellint_rf
    public :: gsl_interp_bsearch, gsl_sort, gsl_sort_index
    public :: gsl_interp_steffen, gsl_spline_alloc, gsl_spline_init, gsl_spline_free, gsl_spline_eval_deriv

    !> Status of a successful call.
    integer(c_int), parameter :: gsl_success = 0

    !> GSL's `gsl_function`: a C function pointer and its parameters.
    type, bind(C) :: gsl_function
        type(c_funptr) :: function
        type(c_ptr) :: params
    end type gsl_function

    !> The Gauss-Jacobi rule's type object.
    type(c_ptr), protected, bind(C, name="gsl_integration_fixed_jacobi") :: gsl_integration_fixed_jacobi
    !> The Brent solver's type object.
    type(c_ptr), protected, bind(C, name="gsl_root_fsolver_brent") :: gsl_root_fsolver_brent
    !> The monotone Steffen interpolation's type object.
    type(c_ptr), protected, bind(C, name="gsl_interp_steffen") :: gsl_interp_steffen

    interface
        subroutine mdrcontact_switch_gsl_handler_off() bind(C)
        end subroutine mdrcontact_switch_gsl_handler_off

        !> Nodes and weights of the Gauss-Legendre rule of n nodes; null without memory.
        function gsl_integration_glfixed_table_alloc(n) result(table) bind(C)
            import :: c_ptr, c_size_t
            integer(c_size_t), value :: n
            type(c_ptr) :: table
        end function gsl_integration_glfixed_table_alloc

        !> Frees a table.
        subroutine gsl_integration_glfixed_table_free(table) bind(C)
            import :: c_ptr
            type(c_ptr), value :: table
        end subroutine gsl_integration_glfixed_table_free

        !> Node and weight i, from 0, on [a, b].
        function gsl_integration_glfixed_point(a, b, i, xi, wi, table) result(status) bind(C)
            import :: c_double, c_int, c_ptr, c_size_t
            real(c_double), value :: a, b
            integer(c_size_t), value :: i
            real(c_double), intent(out) :: xi, wi
            type(c_ptr), value :: table
            integer(c_int) :: status
        end function gsl_integration_glfixed_point

        !> Rule of n nodes on [a, b] for integrals with the weight (b - x)^alpha (x - a)^beta; null without memory.
        function gsl_integration_fixed_alloc(kind, n, a, b, alpha, beta) result(rule) bind(C)
            import :: c_double, c_ptr, c_size_t
            type(c_ptr), value :: kind
            integer(c_size_t), value :: n
            real(c_double), value :: a, b, alpha, beta
            type(c_ptr) :: rule
        end function gsl_integration_fixed_alloc

        !> Frees a rule.
        subroutine gsl_integration_fixed_free(rule) bind(C)
            import :: c_ptr
            type(c_ptr), value :: rule
        end subroutine gsl_integration_fixed_free

        !> The n nodes of a rule.
        function gsl_integration_fixed_nodes(rule) result(nodes) bind(C)
            import :: c_ptr
            type(c_ptr), value :: rule
            type(c_ptr) :: nodes
        end function gsl_integration_fixed_nodes

        !> Its n weights.
        function gsl_integration_fixed_weights(rule) result(weights) bind(C)
            import :: c_ptr
            type(c_ptr), value :: rule
            type(c_ptr) :: weights
        end function gsl_integration_fixed_weights

        !> A solver of the given kind; null without memory.
        function gsl_root_fsolver_alloc(kind) result(solver) bind(C)
            import :: c_ptr
            type(c_ptr), value :: kind
            type(c_ptr) :: solver
        end function gsl_root_fsolver_alloc

        !> Frees a solver.
        subroutine gsl_root_fsolver_free(solver) bind(C)
            import :: c_ptr
            type(c_ptr), value :: solver
        end subroutine gsl_root_fsolver_free

        !> Sets function and bracket.
        function gsl_root_fsolver_set(solver, f, lower, upper) result(status) bind(C)
            import :: c_double, c_int, c_ptr, gsl_function
            type(c_ptr), value :: solver
            type(gsl_function), intent(in) :: f
            real(c_double), value :: lower, upper
            integer(c_int) :: status
        end function gsl_root_fsolver_set

        !> One step.
        function gsl_root_fsolver_iterate(solver) result(status) bind(C)
            import :: c_int, c_ptr
            type(c_ptr), value :: solver
            integer(c_int) :: status
        end function gsl_root_fsolver_iterate

        !> The present estimate.
        function gsl_root_fsolver_root(solver) result(root) bind(C)
            import :: c_double, c_ptr
            type(c_ptr), value :: solver
            real(c_double) :: root
        end function gsl_root_fsolver_root

        !> Lower end of the present bracket.
        function gsl_root_fsolver_x_lower(solver) result(x) bind(C)
            import :: c_double, c_ptr
            type(c_ptr), value :: solver
            real(c_double) :: x
        end function gsl_root_fsolver_x_lower

        !> Upper end of the present bracket.
        function gsl_root_fsolver_x_upper(solver) result(x) bind(C)
            import :: c_double, c_ptr
            type(c_ptr), value :: solver
            real(c_double) :: x
        end function gsl_root_fsolver_x_upper

        !> Whether a bracket is short enough: gsl_success, or "go on".
        function gsl_root_test_interval(lower, upper, epsabs, epsrel) result(status) bind(C)
            import :: c_double, c_int
            real(c_double), value :: lower, upper, epsabs, epsrel
            integer(c_int) :: status
        end function gsl_root_test_interval

        !> i from first to last - 1 with edges(i) <= x < edges(i + 1), counted from 0.
        pure function gsl_interp_bsearch(edges, x, first, last) result(i) bind(C)
            import :: c_double, c_size_t
            real(c_double), intent(in) :: edges(*)
            real(c_double), intent(in), value :: x
            integer(c_size_t), intent(in), value :: first, last
            integer(c_size_t) :: i
        end function gsl_interp_bsearch

        !> An interpolation of n points; null without memory.
        function gsl_spline_alloc(kind, n) result(spline) bind(C)
            import :: c_ptr, c_size_t
            type(c_ptr), value :: kind
            integer(c_size_t), value :: n
            type(c_ptr) :: spline
        end function gsl_spline_alloc

        !> Interpolates the points (x, y).
        function gsl_spline_init(spline, x, y, n) result(status) bind(C)
            import :: c_double, c_int, c_ptr, c_size_t
            type(c_ptr), value :: spline
            real(c_double), intent(in) :: x(*), y(*)
            integer(c_size_t), value :: n
            integer(c_int) :: status
        end function gsl_spline_init

        !> Frees an interpolation.
        subroutine gsl_spline_free(spline) bind(C)
            import :: c_ptr
            type(c_ptr), value :: spline
        end subroutine gsl_spline_free

        !> The derivative at x; a null accelerator is allowed.
        function gsl_spline_eval_deriv(spline, x, accelerator) result(slope) bind(C)
            import :: c_double, c_ptr
            type(c_ptr), value :: spline
            real(c_double), value :: x
            type(c_ptr), value :: accelerator
            real(c_double) :: slope
        end function gsl_spline_eval_deriv

        !> exp(-|x|) i_l(x), l = 0 ... lmax, modified spherical Bessel functions.
        function gsl_sf_bessel_il_scaled_array(lmax, x, values) result(status) bind(C)
            import :: c_double, c_int
            integer(c_int), value :: lmax
            real(c_double), value :: x
            real(c_double), intent(inout) :: values(*)
            integer(c_int) :: status
        end function gsl_sf_bessel_il_scaled_array

        !> j_l(x), l = 0 ... lmax, spherical Bessel functions, x >= 0.
        function gsl_sf_bessel_jl_steed_array(lmax, x, values) result(status) bind(C)
            import :: c_double, c_int
            integer(c_int), value :: lmax
            real(c_double), value :: x
            real(c_double), intent(inout) :: values(*)
            integer(c_int) :: status
        end function gsl_sf_bessel_jl_steed_array

        !> Real part of the digamma function at 1 + i y.
        function gsl_sf_psi_1piy(y) result(value) bind(C)
            import :: c_double
            real(c_double), value :: y
            real(c_double) :: value
        end function gsl_sf_psi_1piy

        !> J_n(x), n = nmin ... nmax.
        function gsl_sf_bessel_jn_array(nmin, nmax, x, values) result(status) bind(C, name="gsl_sf_bessel_Jn_array")
            import :: c_double, c_int
            integer(c_int), value :: nmin, nmax
            real(c_double), value :: x
            real(c_double), intent(inout) :: values(*)
            integer(c_int) :: status
        end function gsl_sf_bessel_jn_array

        !> Complete elliptic integral E of modulus k; mode = 0: double precision.
        pure function gsl_sf_ellint_ecomp(k, mode) result(y) bind(C, name="gsl_sf_ellint_Ecomp")
            import :: c_double, c_int
            real(c_double), intent(in), value :: k
            integer(c_int), intent(in), value :: mode
            real(c_double) :: y
        end function gsl_sf_ellint_ecomp

        !> Complete elliptic integral K of modulus k < 1; mode = 0: double precision.
        pure function gsl_sf_ellint_kcomp(k, mode) result(y) bind(C, name="gsl_sf_ellint_Kcomp")
            import :: c_double, c_int
            real(c_double), intent(in), value :: k
            integer(c_int), intent(in), value :: mode
            real(c_double) :: y
        end function gsl_sf_ellint_kcomp

        !> Carlson's symmetric integral R_F(x, y, z); `mode` 0 is double precision.
        pure function gsl_sf_ellint_rf(x, y, z, mode) result(value) bind(C, name="gsl_sf_ellint_RF")
            import :: c_double, c_int
            real(c_double), value :: x, y, z
            integer(c_int), value :: mode
            real(c_double) :: value
        end function gsl_sf_ellint_rf

        !> Carlson's R_D(x, y, z).
        pure function gsl_sf_ellint_rd(x, y, z, mode) result(value) bind(C, name="gsl_sf_ellint_RD")
            import :: c_double, c_int
            real(c_double), value :: x, y, z
            integer(c_int), value :: mode
            real(c_double) :: value
        end function gsl_sf_ellint_rd

        !> Bessel function J0(x).
        pure function gsl_sf_bessel_j0(x) result(y) bind(C, name="gsl_sf_bessel_J0")
            import :: c_double
            real(c_double), intent(in), value :: x
            real(c_double) :: y
        end function gsl_sf_bessel_j0

        !> Bessel function J1(x).
        pure function gsl_sf_bessel_j1(x) result(y) bind(C, name="gsl_sf_bessel_J1")
            import :: c_double
            real(c_double), intent(in), value :: x
            real(c_double) :: y
        end function gsl_sf_bessel_j1

        !> The order, from 0, in which data ascends.
        pure subroutine gsl_sort_index(order, data, stride, n) bind(C)
            import :: c_double, c_size_t
            integer(c_size_t), intent(out) :: order(*)
            real(c_double), intent(in) :: data(*)
            integer(c_size_t), value :: stride, n
        end subroutine gsl_sort_index

        !> Data in ascending order.
        pure subroutine gsl_sort(data, stride, n) bind(C)
            import :: c_double, c_size_t
            real(c_double), intent(inout) :: data(*)
            integer(c_size_t), value :: stride, n
        end subroutine gsl_sort
    end interface

contains

    !> Makes GSL return status codes instead of ending the process. Idempotent; called before any use of GSL.
    subroutine disable_gsl_abort()
        call mdrcontact_switch_gsl_handler_off()
    end subroutine disable_gsl_abort

end module mdrcontact_gsl
