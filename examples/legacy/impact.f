C     SPDX-License-Identifier: GPL-3.0-or-later
C
C     A STEEL BALL FALLS ON A PAINTED PLATE: AN OLD-STYLE TIME LOOP THAT
C     TAKES ITS CONTACT FORCE FROM A COMPILED LAW. THE INPUT DECK
C     IMPACT.INP NAMES ITS FILE, WHICH WAS MADE FROM A PROBLEM FILE BY
C
C         mdrcontact law problem.toml painted_plate.law
C
C     or by any program that saves a law, here by bouncing_ball.c: steel
C     ball of radius 1 mm, rigid; epoxy paint, 25 um; aluminium.
C
C     The main program and STEP are FORTRAN 77 and know nothing of the
C     library: they call CNTINI once and CNTFOR in each step. These two,
C     and the module that keeps the law between the calls, are all that
C     is new; they stand at the top of this file in fixed form, since a
C     module must come before its use.
C
C     ------------------------------------------------ the new part ----
      module contact_of_ball
        use mdrcontact, only: contact_law_t
        implicit none
        private
        type(contact_law_t), public, save :: law
      end module contact_of_ball

C     Reads the law. IERR = 0 or the library's error code.
      subroutine cntini(name, ierr)
      use contact_of_ball, only: law
      use mdrcontact, only: error_t, load_law
      implicit none
      character(len=*), intent(in) :: name
      integer, intent(out) :: ierr
      type(error_t), allocatable :: error

      ierr = 0
      call load_law(law, name, error)
      if (.not. allocated(error)) return
      write (*, '(1x,a)') error%message
      ierr = error%code
      end subroutine cntini

C     Force F and stiffness S = dF/dD at depth D; both 0 when apart.
      subroutine cntfor(d, f, s)
      use contact_of_ball, only: law
      implicit none
      double precision, intent(in) :: d
      double precision, intent(out) :: f, s

      call law%force_and_slope(d, f, s)
      end subroutine cntfor

C     ------------------------------------------------ the old code ----
      PROGRAM IMPACT
      DOUBLE PRECISION X, V, F, S, T, DT, V0, AMASS
      DOUBLE PRECISION FMAX, DMAX, TOUCH
      INTEGER I, IERR
      CHARACTER*60 LAWFIL
      COMMON /BALL/ AMASS

      OPEN (10, FILE='impact.inp', STATUS='OLD')
      READ (10, '(A)') LAWFIL
      READ (10, *) AMASS, V0, DT
      CLOSE (10)
      CALL CNTINI(LAWFIL, IERR)
      IF (IERR .NE. 0) STOP 1

      X = 0.0D0
      V = V0
      F = 0.0D0
      FMAX = 0.0D0
      DMAX = 0.0D0
      TOUCH = 0.0D0
      WRITE (*, 100)
      DO 10 I = 1, 10000
        CALL STEP(X, V, F, S, DT)
C       A DEPTH BEYOND THE LAW'S LARGEST GIVES NO NUMBER.
        IF (F .NE. F) STOP 1
        T = DT*I
        IF (F .GT. FMAX) FMAX = F
        IF (X .GT. DMAX) DMAX = X
        IF (MOD(I, 100) .EQ. 0) WRITE (*, 110) T*1D6, X*1D6, F, S*1D-6
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
     &        5X, 'S, N/UM')
  110 FORMAT (F12.2, F13.4, F13.5, F12.5)
  120 FORMAT (' CONTACT TIME', F8.2, ' US, DEPTH', F8.4, ' UM, FORCE',
     &        F9.5, ' N, REBOUND AT', F9.6, ' M/S')
      END

C     One step of the leap-frog scheme.
      SUBROUTINE STEP(X, V, F, S, DT)
      DOUBLE PRECISION X, V, F, S, DT, AMASS
      COMMON /BALL/ AMASS
      V = V - 0.5D0*DT*F/AMASS
      X = X + DT*V
      CALL CNTFOR(X, F, S)
      V = V - 0.5D0*DT*F/AMASS
      END
