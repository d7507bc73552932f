! SPDX-License-Identifier: GPL-3.0-or-later
!> Assertions with the names and the meaning of pFUnit's, for systems where pFUnit is not installed.
module funit
    use assert_condition, only: assertFalse, assertGreaterThan, assertGreaterThanOrEqual, assertIsFinite, assertIsNaN, &
                                assertLessThan, assertLessThanOrEqual, assertTrue
    use assert_exact, only: assertEqual
    use assert_real, only: assertEqual, assertRelativelyEqual
    use test_record, only: anyExceptions, finish_suite, finish_test, skip_test, SourceLocation, start_test
    implicit none (type, external)
    public
end module funit
