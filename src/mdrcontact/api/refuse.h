/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What the entries say of arguments that the header does not allow, for any function. */
#ifndef MDRCONTACT_REFUSE_H
#define MDRCONTACT_REFUSE_H

/* Arrays of more entries are not taken: 2^31 less as many as any loop takes at a time. api/arrays.f90 has the same. */
#define MDRCONTACT_MOST_ENTRIES 2147418112

/* Each stores the text as the thread's last error and returns the status. */
int mdrcontact_refuse_null(const char *argument);
int mdrcontact_refuse_count(const char *argument, int count);

#endif
