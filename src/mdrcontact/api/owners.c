/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * How many need the object behind a handle, in whatever threads: the caller who has not freed it, and the handles whose objects
 * refer to it.
 */
#include <stdatomic.h>

int mdrcontact_count_owners(atomic_int *owners, int change);

/* Called from Fortran only, for whom it is an int. */
int mdrcontact_count_owners(atomic_int *owners, int change)
{
    return atomic_fetch_add(owners, change) + change;
}
