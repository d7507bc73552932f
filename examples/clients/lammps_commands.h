/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What the clients in LAMMPS share: calls that must succeed, of the library and of LAMMPS. */
#ifndef LAMMPS_COMMANDS_H
#define LAMMPS_COMMANDS_H

#include <lammps/library.h>
#include <mdrcontact.h>
#include <stdio.h>
#include <stdlib.h>

enum { NEIGHBOUR_BITS = 0x1FFFFFFF }; /* the rest of an entry of LAMMPS's lists marks bonds */

static void check(int status)
{
    if (status != MDR_SUCCESS) {
        fprintf(stderr, "%s: %s\n", mdr_name_of(status), mdr_last_error());
        exit(EXIT_FAILURE);
    }
}

static void command(void *lammps, const char *words)
{
    lammps_command(lammps, words);
    if (lammps_has_error(lammps)) {
        char text[512];
        lammps_get_last_error_message(lammps, text, (int)sizeof text);
        fprintf(stderr, "%s\n%s\n", words, text);
        exit(EXIT_FAILURE);
    }
}

/* A silent LAMMPS for grains, in one process. */
static void *open_lammps(void)
{
    char *arguments[] = {"lammps", "-log", "none", "-screen", "none"};
    void *lammps = lammps_open_no_mpi(5, arguments, NULL);
    if (!lammps) exit(EXIT_FAILURE);
    command(lammps, "units si");
    command(lammps, "atom_style sphere");
    command(lammps, "comm_modify vel yes");
    return lammps;
}

#endif
