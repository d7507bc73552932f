/* SPDX-License-Identifier: GPL-3.0-or-later */
/**
 * @file mdrcontact.h
 * The core of the C interface, and the conventions of all headers.
 *
 * A rigid axisymmetric indenter (profile.h) is pressed into a medium (medium.h): an elastic half-space that is homogeneous, coated,
 * layered or graded, layers on a rigid base, a pair of such bodies, or a viscoelastic body. Indenter and medium form a contact
 * (contact.h). Given the indentation depth d, the normal force F or the contact radius a, a contact returns states with all three,
 * the stiffness k, and fields such as the pressure. A compiled law (law.h) evaluates a contact in nanoseconds, for programs that
 * need it millions of times.
 *
 * Equation numbers of the form (10) are those of V. L. Popov, "Method of dimensionality reduction in contact mechanics and
 * tribology. Heterogeneous media", Physical Mesomechanics 17 (2014) 50-57, below "Popov (2014)". The pages in docs/theory/ derive
 * the equations and list the misprints.
 *
 * @par Extensions
 * Further physics have headers of their own, which a program includes in addition to this one:
 * - mdrcontact/time.h: contacts with viscoelastic bodies;
 * - mdrcontact/adhesion.h: rate-dependent adhesion, and adhesion of viscoelastic bodies;
 * - mdrcontact/wear.h: Archard wear;
 * - mdrcontact/conduction.h: electrical and thermal conduction, frictional heat;
 * - mdrcontact/poroelastic.h: poroelastic gels;
 * - mdrcontact/plastic.h: imprints of plastic contacts, laws of yielding contacts, pressure caps;
 * - mdrcontact/lateral.h: structures whose moduli vary in all directions, which provide a medium at each position;
 * - mdrcontact/fit.h: fits of measured curves.
 *
 * mdrcontact/all.h includes all of them. Each extension is a CMake option. A library built without one has neither its functions
 * nor its header.
 *
 * @par Examples
 * Each function has an example. The examples share a few objects: `ball`, a paraboloid of radius 10 um; `oxide` and `silicon`, two
 * layers; `film`, a body of 500 nm of oxide on silicon; `medium` and `contact` made of these; `state` and `load`, its state at a
 * depth of 50 nm; `sticky`, an adhesive contact of the ball with rubber. Other objects have the name of their kind. An example sets
 * `status`, the value that the function returns.
 *
 * @par Versions
 * The tag "since" of a header or function gives the version that introduced it. The symbols of the shared library carry the same
 * versions.
 *
 * @par Units
 * Use any consistent set. Choose a unit of length and one of modulus (pressure). Forces are then in modulus length^2, stiffnesses
 * and line loads in modulus length, works of adhesion in modulus length. Examples are SI (m, Pa, N), (um, MPa, uN) and (nm, GPa,
 * nN). Brackets in the descriptions give the unit of each number; [1] means dimensionless. Angles are in radian.
 *
 * @par Signs
 * Depth, force and surface displacement are positive into the medium. Pressure is positive in compression.
 *
 * @par Status
 * Every function that can fail returns MDR_SUCCESS (0) or another value of enum mdr_status. After a failure, mdr_last_error()
 * returns a text that names the argument, its value and the allowed range. A failed call writes no output and leaks no memory.
 *
 * Every function can return MDR_ENULL for a missing pointer; MDR_EINVALID for NaN, infinity, a negative n, a handle of another kind
 * or a value outside its range; MDR_ENOMEMORY; MDR_ENOCONVERGENCE for a result outside the range of double precision; and, if the
 * call is long, MDR_ECANCELLED. The description of a function lists only further codes and further reasons.
 *
 * @par Memory
 * If data whose size the caller chooses (points, layers, cells, files) do not fit into memory, the call returns MDR_ENOMEMORY and
 * changes nothing. Memory of a size that the library chooses, a few MiB per object, is not checked: if it is missing, the program
 * stops.
 *
 * @par Arrays
 * `n` is the number of elements of all arrays of a call. n = 0 is valid; the arrays may then be NULL. An output array may be the
 * input array itself. Otherwise arrays must not overlap. Error messages count entries from 1. Indices in arguments and results
 * begin at 0.
 *
 * @par Sized structures
 * Structures of options, problems and properties may gain members in later versions. They begin with a member `size`. Initialize
 * them with MDR_SIZED: `mdr_law_options options = MDR_SIZED(mdr_law_options);` sets the size and all other members to 0, which
 * selects the default. If 0 is also a meaningful value, a member `..._is_given` selects it. The library reads and writes only the
 * members that both it and the program contain, so a program runs with older and newer libraries than its header. An impossible
 * size, and a member that is not 0 but unknown to the library, return MDR_EINVALID.
 *
 * @par Handles
 * Functions with an argument `out` create handles. The calling program owns them and releases them with mdr_free(), or with the
 * macro MDR_FREE, which also sets the variable to NULL. Handles are immutable, except histories (mdr_friction_history and the
 * history of wear), which only one thread may use at a time.
 *
 * @par Arrays
 * An array has at most 2147418112 entries, 2^31 - 65536; a larger n returns MDR_EINVALID.
 *
 * @par Lifetime of arguments
 * Every call copies what it needs from its arguments: handles, arrays, texts, and structures with the handles and arrays to which
 * they point. Arguments must be valid until the call returns. The program may change or free them afterwards. User functions are
 * called only before the call that receives them returns. There are three exceptions. mdr_set_cancel() keeps its function and
 * context, and mdr_set_progress() its pointer, until the calling thread sets another one or NULL, or ends. One function of
 * lateral.h keeps a user function until the structure is freed.
 *
 * Some functions return pointers to memory of the library. Texts of mdr_name_of() stay valid. The text of mdr_last_error() is valid
 * until the next failure of the thread. Texts in the properties of a law, and views of it (mdr_law_view_of()), are valid until the
 * law is freed.
 *
 * @par Functions of the program
 * A function that the library calls must return. If it leaves by longjmp() or by a C++ exception, the memory of the call is lost,
 * and an exception may end the program; mdrcontact.hpp keeps exceptions and throws them again after the call. A function may call the
 * library, but not with the object that is being created. A function of mdr_set_cancel() must not make long calls.
 *
 * @par Rounding
 * Every function that computes sets round-to-nearest, denormal numbers, the full precision of x87 and no floating-point traps, and
 * restores the arithmetic of the calling thread at the end. Exception flags stay set. User functions are called in this arithmetic
 * and must leave it unchanged; a function of mdr_set_cancel() is called in that of the program. Evaluations of laws take nanoseconds and use the arithmetic of the caller: mdr_law_force(), mdr_law_values(),
 * mdr_law_follow(), mdrcontact_law.h and the conductance of a law. Under another rounding mode their relative difference is about
 * 1e-14.
 *
 * @par Threads
 * Any number of threads may use the same handle at the same time. The error text belongs to the thread that failed. Functions of
 * arrays use several threads (OpenMP) if mdr_set_threads() allows it. Free a handle only when no other thread uses it. When an
 * object is created, the library switches off the error handler of GSL for the process, because it would stop the program. A
 * program with its own GSL handler must set it again afterwards.
 *
 * After fork() the child must not let the library use several threads if its parent did: OpenMP threads do not exist in the child.
 * Call mdr_set_threads(1) in the child, or exec() another program. The shared library stays loaded after dlclose(), because OpenMP
 * threads wait for work in it. A process may contain several copies of the library, static or shared. Each has its own error texts,
 * threads and cancel functions, and returns MDR_EINVALID for handles of another copy.
 *
 * A call needs up to 56 kB of stack in the calling thread, in addition to the stack of user functions; up to 96 kB if flang
 * 22 compiled the library. 128 kB, the default of threads under musl, suffice; with gfortran also if the BLAS keeps per-thread data
 * on the stack (OpenBLAS: 60 kB).
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
