! SPDX-License-Identifier: GPL-3.0-or-later
! Closed forms for an incompressible coating, flat for f2py.

!> See mdr_coated_paraboloid_force.
subroutine coated_paraboloid_force(n, threads, radius, coating_shear, substrate_shear, thickness, a, values, status)
    use, intrinsic :: iso_c_binding, only: c_double, c_int
    use mdrcontact_api_closed_forms, only: mdr_coated_paraboloid_force_threads
    implicit none (type, external)
    !f2py threadsafe
    integer(c_int), intent(in) :: n, threads
    real(c_double), intent(in) :: radius, coating_shear, substrate_shear, thickness
    real(c_double), intent(in) :: a(n)
    real(c_double), intent(out) :: values(n)
    integer(c_int), intent(out) :: status

    status = mdr_coated_paraboloid_force_threads(n, a, radius, coating_shear, substrate_shear, thickness, values, threads)
end subroutine coated_paraboloid_force

!> See mdr_coated_cone_force.
subroutine coated_cone_force(n, threads, inclination, coating_shear, substrate_shear, thickness, a, values, status)
    use, intrinsic :: iso_c_binding, only: c_double, c_int
    use mdrcontact_api_closed_forms, only: mdr_coated_cone_force_threads
    implicit none (type, external)
    !f2py threadsafe
    integer(c_int), intent(in) :: n, threads
    real(c_double), intent(in) :: inclination, coating_shear, substrate_shear, thickness
    real(c_double), intent(in) :: a(n)
    real(c_double), intent(out) :: values(n)
    integer(c_int), intent(out) :: status

    status = mdr_coated_cone_force_threads(n, a, inclination, coating_shear, substrate_shear, thickness, values, threads)
end subroutine coated_cone_force

!> See mdr_coated_paraboloid_adhesive_depth.
subroutine coated_paraboloid_adhesive_depth(n, threads, radius, coating_shear, substrate_shear, thickness, work_of_adhesion, &
                                            a, values, status)
    use, intrinsic :: iso_c_binding, only: c_double, c_int
    use mdrcontact_api_closed_forms, only: mdr_coated_paraboloid_adhesive_depth_threads
    implicit none (type, external)
    !f2py threadsafe
    integer(c_int), intent(in) :: n, threads
    real(c_double), intent(in) :: radius, coating_shear, substrate_shear, thickness, work_of_adhesion
    real(c_double), intent(in) :: a(n)
    real(c_double), intent(out) :: values(n)
    integer(c_int), intent(out) :: status

    status = mdr_coated_paraboloid_adhesive_depth_threads(n, a, radius, coating_shear, substrate_shear, thickness, &
                                                           work_of_adhesion, values, threads)
end subroutine coated_paraboloid_adhesive_depth

!> See mdr_reduced_adhesive_depth.
subroutine reduced_adhesive_depth(n, threads, shear_ratio, reduced_thickness, a, values, status)
    use, intrinsic :: iso_c_binding, only: c_double, c_int
    use mdrcontact_api_closed_forms, only: mdr_reduced_adhesive_depth_threads
    implicit none (type, external)
    !f2py threadsafe
    integer(c_int), intent(in) :: n, threads
    real(c_double), intent(in) :: shear_ratio, reduced_thickness
    real(c_double), intent(in) :: a(n)
    real(c_double), intent(out) :: values(n)
    integer(c_int), intent(out) :: status

    status = mdr_reduced_adhesive_depth_threads(n, a, shear_ratio, reduced_thickness, values, threads)
end subroutine reduced_adhesive_depth

!> See mdr_adhesive_radius_scale.
subroutine adhesive_radius_scale(radius, substrate_shear, work_of_adhesion, scale, status)
    use, intrinsic :: iso_c_binding, only: c_double, c_int
    use mdrcontact_api_closed_forms, only: mdr_adhesive_radius_scale
    implicit none (type, external)
    !f2py threadsafe
    real(c_double), intent(in) :: radius, substrate_shear, work_of_adhesion
    real(c_double), intent(out) :: scale
    integer(c_int), intent(out) :: status

    status = mdr_adhesive_radius_scale(radius, substrate_shear, work_of_adhesion, scale)
end subroutine adhesive_radius_scale

!> See mdr_adhesive_depth_scale.
subroutine adhesive_depth_scale(radius, substrate_shear, work_of_adhesion, scale, status)
    use, intrinsic :: iso_c_binding, only: c_double, c_int
    use mdrcontact_api_closed_forms, only: mdr_adhesive_depth_scale
    implicit none (type, external)
    !f2py threadsafe
    real(c_double), intent(in) :: radius, substrate_shear, work_of_adhesion
    real(c_double), intent(out) :: scale
    integer(c_int), intent(out) :: status

    status = mdr_adhesive_depth_scale(radius, substrate_shear, work_of_adhesion, scale)
end subroutine adhesive_depth_scale
