/* SPDX-License-Identifier: GPL-3.0-or-later */
/**
 * @file mdrcontact.h
 * Contact of real, coated, layered and graded bodies, computed in one dimension: the core of the C interface and its manual.
 *
 * A rigid axisymmetric indenter (mdr_profile) is pressed into an elastic half-space (mdr_medium); the two make a contact
 * (mdr_contact), which gives indentation depth d, contact radius a, normal force F and stiffness k from any one of
 * the first three, and the pressure, line load and surface displacement. A compiled law (mdr_law) is a contact for programs that
 * call it millions of times. Equation numbers are those of V. L. Popov,
 * "Method of dimensionality reduction in contact mechanics and tribology. Heterogeneous media", Physical
 * Mesomechanics 17 (2014) 50-57; the pages in docs/theory/ state the equations and list where they are misprinted.
 *
 * @par Extensions
 * Further physics have headers of their own, which a program includes beside this one. All hold to what is said here:
 * - mdrcontact/time.h: contacts with viscoelastic bodies in time;
 * - mdrcontact/adhesion.h: adhesion that depends on speed, adhesion of viscoelastic bodies;
 * - mdrcontact/wear.h: wear by Archard's law;
 * - mdrcontact/conduction.h: conduction of heat or current, heat of friction;
 * - mdrcontact/poroelastic.h: gels, whose liquid moves through them;
 * - mdrcontact/lateral.h: structures whose moduli vary in all directions, which give a medium for each place on them;
 * - mdrcontact/fit.h: from measured curves back to the moduli.
 *
 * mdrcontact/all.h includes them all. A library can be built without any of them, by the CMake options that the headers name: it
 * has neither the functions nor the header then.
 *
 * @par Versions
 * Each part says since which version there are its functions, `since`, and each function that came later. The shared library's
 * symbols carry these versions.
 *
 * @par Units
 * Any consistent set: choose a unit of length and one of modulus (pressure); forces are then in modulus length^2, stiffnesses
 * and line loads in modulus length, works of adhesion in modulus length. SI (m, Pa, N) is one choice, (um, MPa, uN) and
 * (nm, GPa, nN) are others. In the comments the unit of each number stands in brackets; [1] has none. Angles are in radian.
 *
 * @par Signs
 * Depth, force and surface displacement are positive into the medium, pressure in compression.
 *
 * @par Status
 * Every function that can fail returns MDR_SUCCESS (0) or another value of enum mdr_status; mdr_last_error() then says in
 * words which argument was wrong, what it was and what is allowed. A failed call writes no output and loses no memory.
 * Every function can return MDR_ENULL for a missing pointer, MDR_EINVALID for NaN, infinity, a negative n, a handle of another kind
 * or a value out of its range, MDR_ENOMEMORY, MDR_ENOCONVERGENCE for a result outside the number range, and in long calls
 * MDR_ECANCELLED; only further codes, and further reasons, are listed with the functions.
 *
 * @par Memory
 * A call whose caller-sized data (points, layers, cells, files) do not fit into memory returns MDR_ENOMEMORY and changes nothing. What
 * the library sizes itself, some MiB an object, is not checked: without memory for that the program ends.
 *
 * @par Arrays
 * `n` is the number of elements of all arrays of the call; n = 0 is allowed, and then the arrays may be NULL. An
 * output array may be the input array itself; otherwise arrays must not overlap. Error messages count entries from 1,
 * indices in arguments and results begin at 0.
 *
 * @par Structures that grow
 * Options, problems and what the library says of its objects may get more members in later versions. They begin with their size,
 * which the program sets: `mdr_law_options options = MDR_SIZED(mdr_law_options);` - all other members are 0 then, which stands for
 * the default; where 0 is a value, too, a member `..._is_given` says that it is meant. The library reads and writes the members
 * that both it and the program know: a program runs with older and newer libraries than the header it was compiled with.
 * MDR_EINVALID for a size that cannot be, and for members that are not 0 and that the library does not know.
 *
 * @par Handles and their release
 * Functions with an argument `out` make handles; the calling program owns them and frees them by mdr_free(), or by the macro
 * MDR_FREE, which also sets the program's pointer to NULL. A handle never changes after its creation, but for histories,
 * mdr_friction_history and that of wear, which must not be used by two threads at a time.
 *
 * @par What is copied, what is kept
 * Every call copies what it needs from its arguments: handles, arrays, texts and structures, with the handles and arrays to which a
 * structure points. They must be valid until the call returns; the program may free or change them afterwards. User functions are
 * called before the call that takes them returns, and never later. Two functions of the core keep a pointer: mdr_set_cancel() keeps
 * the function and its context, and mdr_set_progress() keeps the pointer to the number, until the calling thread sets others, or
 * NULL, or ends. One of lateral.h keeps a function until the structure is freed.
 *
 * The library returns pointers to its own memory: texts of mdr_name_of() are valid for ever; the text of mdr_last_error() until the
 * next failure of the thread; the texts in structures about a law, and views of it (mdr_law_view_of()), until the law is freed.
 *
 * @par Rounding
 * Every function that computes does so rounding to nearest, with denormal numbers and without traps of exceptions, and then sets
 * the calling thread's own arithmetic again; flags of exceptions stay set, as after any computation. User functions are called in
 * this arithmetic and leave it as it is. States of laws, which take nanoseconds - mdr_law_force(), mdr_law_values(),
 * mdr_law_follow(), mdrcontact_law.h, and the conductance of a law -, compute in the caller's: under another rounding mode they
 * differ in the last digits, by 1e-14.
 *
 * @par Threads
 * Any number of threads may use the same handle at the same time; the error text belongs to the thread that failed.
 * Functions of arrays share the work among several threads of their own (OpenMP) where mdr_set_threads() allows it.
 * Only freeing a handle needs the certainty that no other thread uses it. GSL's error handler, which would end the program, is
 * switched off for the process when an object is made; a program with a GSL handler of its own sets it again afterwards.
 *
 * A call takes up to 56 kB of the calling thread's stack, and what user functions take on top. 128 kB, as threads have under musl,
 * are enough, also where the BLAS keeps data of each thread there (OpenBLAS: 60 kB).
 */
#ifndef MDRCONTACT_H
#define MDRCONTACT_H

#include "mdrcontact/base.h"
#include "mdrcontact/profile.h"
#include "mdrcontact/material.h"
#include "mdrcontact/body.h"
#include "mdrcontact/medium.h"
#include "mdrcontact/weights.h"
#include "mdrcontact/contact.h"
#include "mdrcontact/friction.h"
#include "mdrcontact/law.h"
#include "mdrcontact/closed_forms.h"

#endif
