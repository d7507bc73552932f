/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * MPI: the contact of a rough coated surface, its asperities shared out among the processes. One makes the law and broadcasts
 * what its file would hold; the others read it from memory, and no process solves the contact twice.
 *
 * Greenwood and Williamson, Proc. R. Soc. A 295 (1966) 300: asperities of equal radius, their heights z above the mean plane random
 * with the density exp(-z/s)/s. A plane at separation h presses those with z > h by d = z - h each.
 *
 * Checks: for heights of this kind the whole force falls with h as exp(-h/s), whatever the law F(d) of one asperity; it is N times
 * the mean of F over the density, int F(d) exp(-(d + h)/s) dd/s; all processes find the same force at the same depth, to the last
 * bit. SI units. Diamond-like carbon E = 300 GPa, nu = 0.2, 0.2 um on steel E = 210 GPa, nu = 0.3 (handbook values); R = 20 um,
 * s = 50 nm.
 */
#include <math.h>
#include <mdrcontact.h>
#include <mpi.h>
#include <stdio.h>
#include <stdlib.h>

static void check(int status)
{
    if (status != MDR_SUCCESS) {
        fprintf(stderr, "%s: %s\n", mdr_name_of(status), mdr_last_error());
        MPI_Abort(MPI_COMM_WORLD, EXIT_FAILURE);
    }
}

static mdr_law *new_law(double largest_depth)
{
    mdr_profile *asperity = NULL;
    mdr_body *body = NULL;
    mdr_medium *surface = NULL;
    mdr_contact *contact = NULL;
    mdr_law *law = NULL;

    check(mdr_profile_paraboloid(20e-6, &asperity));
    const mdr_layer coating = mdr_isotropic(300e9, 0.2, 0.2e-6), base = mdr_isotropic(210e9, 0.3, 0.0);
    check(mdr_body_layered(1, &coating, &base, NULL, &body));
    check(mdr_medium_new(body, NULL, &surface));
    check(mdr_free(body));
    check(mdr_contact_new(asperity, surface, NULL, &contact));
    check(mdr_law_new(contact, largest_depth, NULL, &law));
    check(mdr_free(contact));
    check(mdr_free(surface));
    check(mdr_free(asperity));
    return law;
}

/* The law of process 0 in all processes: the bytes of its file travel, no file is written. */
static mdr_law *broadcast(mdr_law *law, int rank)
{
    int length = 0;
    if (rank == 0) check(mdr_law_write(law, NULL, 0, &length));
    MPI_Bcast(&length, 1, MPI_INT, 0, MPI_COMM_WORLD);
    char *bytes = malloc((size_t)length);
    if (!bytes) MPI_Abort(MPI_COMM_WORLD, EXIT_FAILURE);
    if (rank == 0) check(mdr_law_write(law, bytes, length, &length));
    MPI_Bcast(bytes, length, MPI_CHAR, 0, MPI_COMM_WORLD);
    if (rank != 0) check(mdr_law_read(bytes, length, &law));
    free(bytes);
    return law;
}

int main(int argc, char **argv)
{
    enum { ASPERITIES = 2000000 };
    const double s = 50e-9, separations[] = {0.0, 1.0, 2.0, 3.0}; /* the latter in units of s */
    const double largest = s * log(2.0 * ASPERITIES);              /* depth of the highest asperity, at h = 0 */
    int rank, size, failed = 0;

    MPI_Init(&argc, &argv);
    MPI_Comm_rank(MPI_COMM_WORLD, &rank);
    MPI_Comm_size(MPI_COMM_WORLD, &size);
    const double start = MPI_Wtime();
    mdr_law *law = broadcast(rank == 0 ? new_law(largest) : NULL, rank);
    const double made = MPI_Wtime();

    /* This process's asperities: heights at equal steps of probability. */
    const int n = ASPERITIES / size + (rank < ASPERITIES % size);
    double *z = malloc((size_t)n * sizeof *z), *d = malloc((size_t)n * sizeof *d), *F = malloc((size_t)n * sizeof *F);
    if (!z || !d || !F) MPI_Abort(MPI_COMM_WORLD, EXIT_FAILURE);
    for (int i = 0; i < n; i++) z[i] = -s * log((rank + (double)size * i + 0.5) / ASPERITIES);

    double whole[4], expected = 0.0;
    for (int j = 0; j < 4; j++) {
        double sum = 0.0;
        for (int i = 0; i < n; i++) d[i] = z[i] - separations[j] * s; /* < 0: apart, and the law answers 0 */
        check(mdr_law_values(law, MDR_DEPTH, MDR_ON_UNLOADING, n, d, NULL, NULL, F, NULL, NULL, NULL));
        for (int i = 0; i < n; i++) sum += F[i];
        MPI_Allreduce(&sum, &whole[j], 1, MPI_DOUBLE, MPI_SUM, MPI_COMM_WORLD);
    }
    const double done = MPI_Wtime();

    /* The mean of F over the density, by the trapezoidal rule in u = ln(d/s), whose ends are 0. */
    for (double u = -30.0, step = 0.01; exp(u) * s < largest; u += step) {
        double force;
        check(mdr_law_force(law, MDR_ON_UNLOADING, exp(u) * s, &force, NULL));
        expected += ASPERITIES * step * force * exp(u - exp(u));
    }
    double one, least, greatest;
    check(mdr_law_force(law, MDR_ON_UNLOADING, 0.123 * s, &one, NULL));
    MPI_Allreduce(&one, &least, 1, MPI_DOUBLE, MPI_MIN, MPI_COMM_WORLD);
    MPI_Allreduce(&one, &greatest, 1, MPI_DOUBLE, MPI_MAX, MPI_COMM_WORLD);
    failed |= least < greatest;

    if (rank == 0) {
        printf("%d processes; the law in all of them after %.1f ms, %.1f ns a force\n", size, 1e3 * (made - start),
               1e9 * (done - made) * size / (4.0 * ASPERITIES));
        for (int j = 0; j < 4; j++) {
            const double by_density = expected * exp(-separations[j]);
            printf("h = %.0f s   F = %11.6f N   by the density %11.6f N   difference %.1e\n", separations[j], whole[j], by_density,
                   whole[j] / by_density - 1.0);
            failed |= !(fabs(whole[j] / by_density - 1.0) < 1e-4);
        }
        puts(failed ? "WRONG" : "the same force in all processes, falling with h as exp(-h/s)");
    }
    check(mdr_free(law));
    free(z);
    free(d);
    free(F);
    MPI_Finalize();
    return failed ? EXIT_FAILURE : EXIT_SUCCESS;
}
