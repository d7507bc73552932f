! SPDX-License-Identifier: GPL-3.0-or-later
!> GSL's nonlinear least squares (gsl_multifit_nlinear), as Fortran interfaces and nothing more.
module mdrcontact_fit_gsl_multifit
    use, intrinsic :: iso_c_binding, only: c_double, c_funptr, c_int, c_ptr, c_size_t
    implicit none (type, external)
    private
    public :: gsl_vector, gsl_matrix, gsl_multifit_nlinear_fdf, gsl_multifit_nlinear_parameters
    public :: gsl_multifit_nlinear_trust, gsl_multifit_nlinear_solver_qr
    public :: gsl_multifit_nlinear_default_parameters, gsl_multifit_nlinear_alloc, gsl_multifit_nlinear_free, &
              gsl_multifit_nlinear_init, gsl_multifit_nlinear_iterate, gsl_multifit_nlinear_position, &
              gsl_multifit_nlinear_residual, gsl_multifit_nlinear_jac
    public :: gsl_enoprog

    !> Status GSL_ENOPROG, no step lowers the sum any more.
    integer(c_int), parameter :: gsl_enoprog = 27_c_int

    !> GSL's vector.
    type, bind(C) :: gsl_vector
        integer(c_size_t) :: size
        integer(c_size_t) :: stride
        type(c_ptr) :: data
        type(c_ptr) :: block
        integer(c_int) :: owner
    end type gsl_vector

    !> GSL's matrix, by rows.
    type, bind(C) :: gsl_matrix
        integer(c_size_t) :: size1
        integer(c_size_t) :: size2
        integer(c_size_t) :: tda
        type(c_ptr) :: data
        type(c_ptr) :: block
        integer(c_int) :: owner
    end type gsl_matrix

    !> Residuals and their derivatives as C functions, and how often each was called.
    type, bind(C) :: gsl_multifit_nlinear_fdf
        type(c_funptr) :: f
        type(c_funptr) :: df
        type(c_funptr) :: fvv
        integer(c_size_t) :: n
        integer(c_size_t) :: p
        type(c_ptr) :: params
        integer(c_size_t) :: nevalf
        integer(c_size_t) :: nevaldf
        integer(c_size_t) :: nevalfvv
    end type gsl_multifit_nlinear_fdf

    !> Method, scaling and step sizes.
    type, bind(C) :: gsl_multifit_nlinear_parameters
        type(c_ptr) :: trs
        type(c_ptr) :: scale
        type(c_ptr) :: solver
        integer(c_int) :: fdtype
        real(c_double) :: factor_up
        real(c_double) :: factor_down
        real(c_double) :: avmax
        real(c_double) :: h_df
        real(c_double) :: h_fvv
    end type gsl_multifit_nlinear_parameters

    !> The trust-region method's type object.
    type(c_ptr), protected, bind(C, name="gsl_multifit_nlinear_trust") :: gsl_multifit_nlinear_trust
    !> The QR solver's type object.
    type(c_ptr), protected, bind(C, name="gsl_multifit_nlinear_solver_qr") :: gsl_multifit_nlinear_solver_qr

    interface
        !> GSL's defaults.
        function gsl_multifit_nlinear_default_parameters() result(parameters) bind(C)
            import :: gsl_multifit_nlinear_parameters
            type(gsl_multifit_nlinear_parameters) :: parameters
        end function gsl_multifit_nlinear_default_parameters

        !> A workspace for n data and p parameters; null without memory.
        function gsl_multifit_nlinear_alloc(kind, parameters, n, p) result(workspace) bind(C)
            import :: c_ptr, c_size_t, gsl_multifit_nlinear_parameters
            type(c_ptr), value :: kind
            type(gsl_multifit_nlinear_parameters), intent(in) :: parameters
            integer(c_size_t), value :: n, p
            type(c_ptr) :: workspace
        end function gsl_multifit_nlinear_alloc

        !> Frees a workspace.
        subroutine gsl_multifit_nlinear_free(workspace) bind(C)
            import :: c_ptr
            type(c_ptr), value :: workspace
        end subroutine gsl_multifit_nlinear_free

        !> Sets problem and starting point.
        function gsl_multifit_nlinear_init(x, fdf, workspace) result(status) bind(C)
            import :: c_int, c_ptr, gsl_vector
            type(gsl_vector), intent(in) :: x
            !> gsl_multifit_nlinear_fdf *, which GSL keeps
            type(c_ptr), value :: fdf
            type(c_ptr), value :: workspace
            integer(c_int) :: status
        end function gsl_multifit_nlinear_init

        !> One step.
        function gsl_multifit_nlinear_iterate(workspace) result(status) bind(C)
            import :: c_int, c_ptr
            type(c_ptr), value :: workspace
            integer(c_int) :: status
        end function gsl_multifit_nlinear_iterate

        !> The present point: gsl_vector *, owned by the workspace.
        function gsl_multifit_nlinear_position(workspace) result(vector) bind(C)
            import :: c_ptr
            type(c_ptr), value :: workspace
            type(c_ptr) :: vector
        end function gsl_multifit_nlinear_position

        !> The residuals there: gsl_vector *, owned by the workspace.
        function gsl_multifit_nlinear_residual(workspace) result(vector) bind(C)
            import :: c_ptr
            type(c_ptr), value :: workspace
            type(c_ptr) :: vector
        end function gsl_multifit_nlinear_residual

        !> Their derivatives there: gsl_matrix *, owned by the workspace.
        function gsl_multifit_nlinear_jac(workspace) result(matrix) bind(C)
            import :: c_ptr
            type(c_ptr), value :: workspace
            type(c_ptr) :: matrix
        end function gsl_multifit_nlinear_jac
    end interface

end module mdrcontact_fit_gsl_multifit
