C     SPDX-License-Identifier: GPL-3.0-or-later
C
C     A STEEL BALL FALLS ON A PAINTED PLATE: AN OLD-STYLE TIME LOOP THAT
C     TAKES ITS CONTACT FORCE FROM THE LIBRARY.
C
C     The main program and STEP are FORTRAN 77 and know nothing of the
C     library: they call CNTINI once and CNTFOR in each step. These two,
C     and the module that keeps the contact between the calls, are all
C     that is new; they stand at the top of this file in fixed form,
C     since a module must come before its use.
C
C     Units: SI. Steel ball of radius 1 mm, density 7850 kg/m^3, 0.1 m/s;
C     epoxy paint E = 3 GPa, nu = 0.35, 25 um; aluminium E = 70 GPa,
C     nu = 0.33 (handbook values). The ball is taken as rigid.
C
C     ------------------------------------------------ the new part ----
      module contact_of_ball
        use mdrcontact, only: contact_t
        implicit none
        private
        type(contact_t), public, save :: contact
      end module contact_of_ball

C     Makes the contact. IERR = 0 or the library's error code.
      subroutine cntini(radius, ierr)
      use contact_of_ball, only: contact
      use mdrcontact, only: error_t, gao_options_t, gao_t, material_t,
     &  new_contact, new_gao, new_material, new_paraboloid, power_law_t
      implicit none
      double precision, intent(in) :: radius
      integer, intent(out) :: ierr
      type(material_t) :: epoxy, aluminium
      type(power_law_t) :: ball
      type(gao_t) :: plate
      type(error_t), allocatable :: error

      call new_material(epoxy, 3.0d9, 0.35d0, error)
      if (.not. allocated(error))
     &  call new_material(aluminium, 70.0d9, 0.33d0, error)
      if (.not. allocated(error))
     &  call new_gao(plate, epoxy, 25.0d-6, aluminium, error,
     &               gao_options_t(exponent=-1.0d0))
      if (.not. allocated(error))
     &  call new_paraboloid(ball, radius, error)
      if (.not. allocated(error))
     &  call new_contact(contact, ball, plate, error)
      call report(error, ierr)

      contains

        subroutine report(error, ierr)
          type(error_t), allocatable, intent(in) :: error
          integer, intent(out) :: ierr
          ierr = 0
          if (.not. allocated(error)) return
          write (*, '(1x,a)') error%message
          ierr = error%code
        end subroutine report

      end subroutine cntini

C     Force F and contact radius A at depth D; both 0 when apart.
      subroutine cntfor(d, f, a, ierr)
      use contact_of_ball, only: contact
      use mdrcontact, only: contact_state_t, error_t
      implicit none
      double precision, intent(in) :: d
      double precision, intent(out) :: f, a
      integer, intent(out) :: ierr
      type(contact_state_t) :: state
      type(error_t), allocatable :: error

      f = 0.0d0
      a = 0.0d0
      ierr = 0
      if (d .le. 0.0d0) return
      call contact%at_depth(d, state, error)
      if (allocated(error)) then
        write (*, '(1x,a)') error%message
        ierr = error%code
        return
      end if
      f = state%force
      a = state%radius
      end subroutine cntfor

C     ------------------------------------------------ the old code ----
      PROGRAM IMPACT
      DOUBLE PRECISION X, V, F, A, T, DT, RADIUS, V0, PI
      DOUBLE PRECISION FMAX, DMAX, TOUCH
      INTEGER I, IERR
      DOUBLE PRECISION AMASS
      COMMON /BALL/ AMASS
      PARAMETER (PI = 3.14159265358979D0, V0 = 0.1D0, DT = 2.0D-8)

      RADIUS = 1.0D-3
      AMASS = 4.0D0/3.0D0*PI*RADIUS**3*7850.0D0
      CALL CNTINI(RADIUS, IERR)
      IF (IERR .NE. 0) STOP 1

      X = 0.0D0
      V = V0
      F = 0.0D0
      FMAX = 0.0D0
      DMAX = 0.0D0
      TOUCH = 0.0D0
      WRITE (*, 100)
      DO 10 I = 1, 10000
        CALL STEP(X, V, F, A, DT, IERR)
        IF (IERR .NE. 0) STOP 1
        T = DT*I
        IF (F .GT. FMAX) FMAX = F
        IF (X .GT. DMAX) DMAX = X
        IF (MOD(I, 100) .EQ. 0) WRITE (*, 110) T*1D6, X*1D6, F, A*1D6
        IF (X .LE. 0.0D0) GO TO 20
        TOUCH = T
   10 CONTINUE
   20 WRITE (*, 120) TOUCH*1D6, DMAX*1D6, FMAX, -V
C     An elastic body gives back all of the energy.
      IF (ABS(-V/V0 - 1.0D0) .GT. 1.0D-4) THEN
        WRITE (*, *) 'ENERGY IS NOT CONSERVED'
        STOP 1
      END IF
  100 FORMAT (4X, 'TIME, US', 4X, 'DEPTH, UM', 5X, 'FORCE, N',
     &        3X, 'RADIUS, UM')
  110 FORMAT (F12.2, F13.4, F13.5, F13.3)
  120 FORMAT (' CONTACT TIME', F8.2, ' US, DEPTH', F8.4, ' UM, FORCE',
     &        F9.5, ' N, REBOUND AT', F9.6, ' M/S')
      END

C     One step of the leap-frog scheme.
      SUBROUTINE STEP(X, V, F, A, DT, IERR)
      DOUBLE PRECISION X, V, F, A, DT, AMASS
      INTEGER IERR
      COMMON /BALL/ AMASS
      V = V - 0.5D0*DT*F/AMASS
      X = X + DT*V
      CALL CNTFOR(X, F, A, IERR)
      V = V - 0.5D0*DT*F/AMASS
      END
