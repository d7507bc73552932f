C     SPDX-License-Identifier: GPL-3.0-or-later
C
C     THE CONTACT OF A FINITE-ELEMENT CODE WITH USER SUBROUTINES: UINTER
C     GIVES NORMAL AND TANGENTIAL FORCE OF A STEEL BALL ON STEEL, AND
C     THEIR DERIVATIVES, FROM WHERE THE BALL IS. WHAT THE CONTACT HAS
C     GONE THROUGH IS IN STATEV, 11 + 4 N NUMBERS FOR N SLIDERS:
C
C         SLIDERS            8    16    32
C         SIZE OF STATEV    43    75   139
C
C     All 0 before the first increment. The code hands over STATEV as it
C     was at the beginning of the increment in each iteration, and keeps
C     what UINTER leaves in it only when the iterations have converged.
C
C     ------------------------------------------------ the new part ----
      module contact_of_ball
        use mdrcontact, only: contact_law_t
        implicit none
        private
        type(contact_law_t), public, save :: law
      end module contact_of_ball

C     Makes the law. IERR = 0 or the library's error code.
      subroutine cntini(dmax, nslide, ierr)
      use contact_of_ball, only: law
      use mdrcontact, only: contact_t, error_t, friction_t,
     &    homogeneous_t, material_t, new_contact, new_contact_law,
     &    new_friction, new_homogeneous, new_material, new_paraboloid,
     &    power_law_t
      implicit none
      double precision, intent(in) :: dmax
      integer, intent(in) :: nslide
      integer, intent(out) :: ierr
      type(material_t) :: steel
      type(homogeneous_t) :: body
      type(power_law_t) :: ball
      type(contact_t) :: contact
      type(friction_t) :: friction
      type(error_t), allocatable :: error

      call new_material(steel, 2.1d11, 0.3d0, error)
      if (.not. allocated(error)) call new_homogeneous(body, steel)
      if (.not. allocated(error)) call new_paraboloid(ball, 1d-3, error)
      if (.not. allocated(error))
     &    call new_contact(contact, ball, body, error)
      if (.not. allocated(error))
     &    call new_friction(friction, contact, 0.3d0, error)
      if (.not. allocated(error)) call new_contact_law(law, contact,
     &    friction, dmax, error, sliders=nslide)
      ierr = 0
      if (.not. allocated(error)) return
      write (*, '(1x,a)') error%message
      ierr = error%code
      end subroutine cntini

C     The force of the ball at the depth RDISP(1), moved along the
C     surface by DRDISP(2) and DRDISP(3) in this increment: STRESS(1)
C     is normal, the others are tangential; DDSDDR holds their
C     derivatives. LERROR = 1: a shorter increment is needed.
      subroutine uinter(stress, ddsddr, statev, nstatv, rdisp, drdisp,
     &                  ndir, lerror)
      use contact_of_ball, only: law
      use mdrcontact, only: error_t
      implicit none
      integer, intent(in) :: nstatv, ndir
      double precision, intent(out) :: stress(ndir), ddsddr(ndir, ndir)
      double precision, intent(inout) :: statev(nstatv)
      double precision, intent(in) :: rdisp(ndir), drdisp(ndir)
      integer, intent(out) :: lerror
      double precision :: shift(3), t(3), slopes(4, 3)
      type(error_t), allocatable :: error

      call law%force_and_slope(rdisp(1), stress(1), ddsddr(1, 1))
      shift = [drdisp(2), drdisp(3), 0d0]
      call law%friction%advance(stress(1), shift, statev, t, error,
     &                          slopes)
      lerror = 0
      if (allocated(error)) lerror = 1
      stress(2:3) = t(1:2)
      ddsddr(1, 2:3) = 0d0
      ddsddr(2:3, 1) = slopes(4, 1:2)*ddsddr(1, 1)
      ddsddr(2:3, 2:3) = transpose(slopes(1:2, 1:2))
      end subroutine uinter

C     ------------------------------------------------ the old code ----
C     2,000 INCREMENTS UNDER RANDOM LOADS, EACH BY NEWTON'S METHOD.
      PROGRAM NEWTON
      INTEGER NSTATV, I, J, K, IERR, ITER, MOST, NGOOD
      PARAMETER (NSTATV = 75)
      DOUBLE PRECISION STATEV(NSTATV), TRIAL(NSTATV), WANT(3), X(3)
      DOUBLE PRECISION S(3), D(3,3), LEFT, RNDM, DMAX, FMAX
      DOUBLE PRECISION ANGLE, SIZE
      COMMON /SEED/ K
      K = 17
      DMAX = 5.0D-6
      CALL CNTINI(DMAX, 16, IERR)
      IF (IERR .NE. 0) STOP 1
      DO 10 I = 1, NSTATV
        STATEV(I) = 0.0D0
   10 CONTINUE
      CALL AT(0.9D0*DMAX, 0.0D0, 0.0D0, STATEV, TRIAL, NSTATV, S, D)
      FMAX = S(1)
      X(1) = 0.1D0*DMAX
      MOST = 0
      NGOOD = 0
      DO 40 I = 1, 2000
        WANT(1) = FMAX*(0.02D0 + 0.9D0*RNDM()**2)
        SIZE = 0.95D0*0.3D0*WANT(1)*RNDM()
        ANGLE = 6.28D0*RNDM()
        WANT(2) = SIZE*COS(ANGLE)
        WANT(3) = SIZE*SIN(ANGLE)
        X(2) = 0.0D0
        X(3) = 0.0D0
        CALL SOLVE(WANT, X, STATEV, TRIAL, NSTATV, LEFT, ITER)
        IF (LEFT .LE. 1.0D-11*WANT(1)) NGOOD = NGOOD + 1
        MOST = MAX(MOST, ITER)
        DO 30 J = 1, NSTATV
          STATEV(J) = TRIAL(J)
   30   CONTINUE
   40 CONTINUE
      WRITE (*, 100) NGOOD, MOST
  100 FORMAT (1X, I5, ' OF 2000 INCREMENTS CONVERGE, IN AT MOST', I3,
     &        ' ITERATIONS')
      IF (NGOOD .NE. 2000) STOP 1
      END

C     FORCES AND DERIVATIVES; TRIAL BECOMES STATEV AFTER THE INCREMENT.
      SUBROUTINE AT(D1, D2, D3, STATEV, TRIAL, NSTATV, S, D)
      INTEGER NSTATV, I, LERROR
      DOUBLE PRECISION D1, D2, D3, STATEV(NSTATV), TRIAL(NSTATV)
      DOUBLE PRECISION S(3), D(3,3), RDISP(3), DRDISP(3)
      DO 10 I = 1, NSTATV
        TRIAL(I) = STATEV(I)
   10 CONTINUE
      RDISP(1) = D1
      RDISP(2) = 0.0D0
      RDISP(3) = 0.0D0
      DRDISP(1) = 0.0D0
      DRDISP(2) = D2
      DRDISP(3) = D3
      CALL UINTER(S, D, TRIAL, NSTATV, RDISP, DRDISP, 3, LERROR)
C     BEYOND THE LAW NO STEP IS NEARER.
      IF (LERROR .EQ. 0) RETURN
      S(1) = 1.0D30
      S(2) = 0.0D0
      S(3) = 0.0D0
      END

C     DEPTH AND SHIFT AT WHICH THE FORCES ARE THOSE WANTED. A STEP IS
C     HALVED WHILE THE FORCES ARE NOT NEARER.
      SUBROUTINE SOLVE(WANT, X, STATEV, TRIAL, NSTATV, LEFT, ITER)
      INTEGER NSTATV, ITER, J
      DOUBLE PRECISION WANT(3), X(3), STATEV(NSTATV), TRIAL(NSTATV)
      DOUBLE PRECISION LEFT, S(3), D(3,3), DX(3), DET, R2, R3, NEXT
      CALL AT(X(1), X(2), X(3), STATEV, TRIAL, NSTATV, S, D)
      LEFT = SQRT((WANT(1) - S(1))**2 + (WANT(2) - S(2))**2
     &       + (WANT(3) - S(3))**2)
      DO 20 ITER = 1, 50
        IF (LEFT .LE. 1.0D-11*WANT(1)) RETURN
        DX(1) = (WANT(1) - S(1))/D(1,1)
        R2 = WANT(2) - S(2) - D(2,1)*DX(1)
        R3 = WANT(3) - S(3) - D(3,1)*DX(1)
        DET = D(2,2)*D(3,3) - D(2,3)*D(3,2)
        DX(2) = (D(3,3)*R2 - D(2,3)*R3)/DET
        DX(3) = (D(2,2)*R3 - D(3,2)*R2)/DET
        DO 10 J = 1, 40
          CALL AT(X(1) + DX(1), X(2) + DX(2), X(3) + DX(3), STATEV,
     &            TRIAL, NSTATV, S, D)
          NEXT = SQRT((WANT(1) - S(1))**2 + (WANT(2) - S(2))**2
     &           + (WANT(3) - S(3))**2)
          IF (NEXT .LT. LEFT) GO TO 15
          DX(1) = 0.5D0*DX(1)
          DX(2) = 0.5D0*DX(2)
          DX(3) = 0.5D0*DX(3)
   10   CONTINUE
   15   X(1) = X(1) + DX(1)
        X(2) = X(2) + DX(2)
        X(3) = X(3) + DX(3)
        LEFT = NEXT
   20 CONTINUE
      END

C     A NUMBER FROM 0 TO 1.
      DOUBLE PRECISION FUNCTION RNDM()
      INTEGER K
      COMMON /SEED/ K
      K = MOD(16807*MOD(K, 127773) - 2836*(K/127773), 2147483647)
      IF (K .LT. 0) K = K + 2147483647
      RNDM = DBLE(K)/2147483647.0D0
      END
