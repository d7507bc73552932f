/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * LAMMPS: coated grains collide. LAMMPS moves them and keeps lists of neighbours (pair_style zero); contact forces come from
 * a compiled law by fix external, through LAMMPS's C library.
 *
 * 1. A gas of 512 grains in a box with reflecting walls. Check: the energy of motion and contact (the law's int F dd, which fix
 *    external hands to LAMMPS's own balance) stays.
 * 2. A crystal of grains at rest in which each touches twelve others: the cost per contact and step, the lists of neighbours
 *    excepted, beside that of LAMMPS's gran/hertz/history, which computes friction and damping too.
 *
 * SI units. Glass grains, diameter 1 mm, E = 70 GPa, nu = 0.22, 2500 kg/m^3, coated with 20 um of polymer, E = 3 GPa, nu = 0.35.
 */
#include "lammps_commands.h"

#include <math.h>
#include <mdrcontact_law.h>
#include <stdint.h>
#include <time.h>

#define DIAMETER "1e-3"
static const double diameter = 1e-3;

/* Two equal grains, each coated: bodies in series, whose gap is that of a ball of half the radius and a plane. */
static mdr_law *two_grains(void)
{
    mdr_profile *gap = NULL;
    mdr_body *body = NULL;
    mdr_medium *grain = NULL, *both = NULL;
    mdr_contact *contact = NULL;
    mdr_law *law = NULL;
    mdr_law_options options;

    options = MDR_SIZED(mdr_law_options);
    options.continue_beyond = 1;
    check(mdr_profile_paraboloid(0.25 * diameter, &gap));
    const mdr_layer coating = mdr_isotropic(3e9, 0.35, 20e-6), base = mdr_isotropic(70e9, 0.22, 0.0);
    check(mdr_body_layered(1, &coating, &base, NULL, &body));
    check(mdr_medium_new(body, NULL, &grain));
    check(mdr_free(body));
    check(mdr_medium_pair(grain, grain, &both));
    check(mdr_contact_new(gap, both, NULL, &contact));
    check(mdr_law_new(contact, 10e-6, &options, &law));
    check(mdr_free(contact));
    check(mdr_free(both));
    check(mdr_free(grain));
    check(mdr_free(gap));
    return law;
}

/* What the callback needs, and what it counts. */
typedef struct grains {
    void *lammps;
    mdr_law_view law;
    int wants_energy;
    long contacts;
} grains;

/* LAMMPS's callback: forces f on the n grains at x. One process without periodic boundaries: every neighbour is one of them. */
static void contact_forces(void *context, int64_t step, int n, int *tag, double **x, double **f)
{
    grains *self = context;
    const int list = lammps_find_pair_neighlist(self->lammps, "zero", 1, 0, 0);
    const int rows = lammps_neighlist_num_elements(self->lammps, list);
    double energy = 0.0;
    (void)step;
    (void)tag;

    for (int i = 0; i < n; i++) f[i][0] = f[i][1] = f[i][2] = 0.0;
    for (int row = 0; row < rows; row++) {
        int i, neighbours, *neighbour;
        lammps_neighlist_element_neighbors(self->lammps, list, row, &i, &neighbours, &neighbour);
        for (int entry = 0; entry < neighbours; entry++) {
            const int j = neighbour[entry] & NEIGHBOUR_BITS;
            const double dx = x[i][0] - x[j][0], dy = x[i][1] - x[j][1], dz = x[i][2] - x[j][2];
            const double square = dx * dx + dy * dy + dz * dz;
            if (square >= diameter * diameter) continue;
            const double distance = sqrt(square), d = diameter - distance;
            double force, share;
            check(mdr_law_view_force(&self->law, d, &force));
            share = force / distance;
            f[i][0] += share * dx;
            f[i][1] += share * dy;
            f[i][2] += share * dz;
            f[j][0] -= share * dx;
            f[j][1] -= share * dy;
            f[j][2] -= share * dz;
            self->contacts++;
            if (self->wants_energy) {
                mdr_law_point point;
                check(mdr_law_view_state(&self->law, d, &point));
                energy += point.energy;
            }
        }
    }
    if (self->wants_energy) lammps_fix_external_set_energy_global(self->lammps, "law", energy);
}

/* A box of cells^3 unit cells of a lattice with a grain at each node; pair_style as given. */
static void *box_of_grains(const char *lattice, int cells, const char *pair_style)
{
    char words[256];
    void *lammps = open_lammps();
    command(lammps, "boundary f f f");
    snprintf(words, sizeof words, "lattice %s", lattice);
    command(lammps, words);
    snprintf(words, sizeof words, "region box block -0.5 %.1f -0.5 %.1f -0.5 %.1f", cells - 0.5, cells - 0.5, cells - 0.5);
    command(lammps, words);
    command(lammps, "create_box 1 box");
    command(lammps, "create_atoms 1 box");
    command(lammps, "set type 1 diameter " DIAMETER " density 2500");
    snprintf(words, sizeof words, "pair_style %s", pair_style);
    command(lammps, words);
    command(lammps, "pair_coeff * *");
    command(lammps, "neighbor 1e-4 bin");
    command(lammps, "neigh_modify delay 0 every 1 check yes");
    return lammps;
}

static void add_law(grains *self)
{
    command(self->lammps, "fix law all external pf/callback 1 1");
    lammps_set_fix_external_callback(self->lammps, "law", contact_forces, self);
}

/* The gas. Returns 1 if the energy does not stay. */
static int collide(mdr_law_view law)
{
    grains gas = {box_of_grains("sc 1.1e-3", 8, "zero " DIAMETER), law, 1, 0};
    double before = 0.0, worst = 0.0;

    add_law(&gas);
    command(gas.lammps, "fix_modify law energy yes");
    command(gas.lammps, "fix walls all wall/reflect xlo EDGE xhi EDGE ylo EDGE yhi EDGE zlo EDGE zhi EDGE");
    command(gas.lammps, "fix move all nve");
    command(gas.lammps, "velocity all create 3e14 1 mom no"); /* k T = m v^2/3: about 0.1 m/s */
    command(gas.lammps, "timestep 5e-8");
    command(gas.lammps, "thermo_modify lost error");
    puts("  t [ms]   motion [J]     contact [J]    change of the sum");
    for (int part = 0; part <= 10; part++) {
        command(gas.lammps, part ? "run 8000" : "run 0");
        const double motion = lammps_get_thermo(gas.lammps, "ke"), stored = lammps_get_thermo(gas.lammps, "pe");
        if (part == 0) before = motion + stored;
        const double change = (motion + stored) / before - 1.0;
        worst = fmax(worst, fabs(change));
        printf("%8.2f   %.6e   %.6e   %8.1e\n", 1e3 * 8000 * 5e-8 * part, motion, stored, change);
    }
    printf("512 grains, 80000 steps, %.1f contacts at a time\n", (double)gas.contacts / 80000.0);
    lammps_close(gas.lammps);
    return !(worst < 1e-4 && gas.contacts > 100000);
}

/* Processor time of 200 steps, with the lists of neighbours of a first run. */
static double seconds_of(void *lammps)
{
    command(lammps, "run 10 post no");
    const clock_t start = clock();
    command(lammps, "run 200 pre no post no");
    return (double)(clock() - start) / CLOCKS_PER_SEC;
}

/* The crystal: grains 1 um deep in each other, which no fix moves. */
static void compare_costs(mdr_law_view law)
{
    const char *crystal = "fcc 1.41280e-3"; /* nearest neighbours at 0.999 mm */
    enum { CELLS = 12, STEPS = 200 };
    grains bare = {box_of_grains(crystal, CELLS, "zero " DIAMETER), law, 0, 0};
    const double lists = seconds_of(bare.lammps);
    lammps_close(bare.lammps);

    grains coated = {box_of_grains(crystal, CELLS, "zero " DIAMETER), law, 0, 0};
    add_law(&coated);
    command(coated.lammps, "run 0");
    coated.contacts = 0;
    command(coated.lammps, "run 0");
    const double contacts = (double)coated.contacts;
    const double by_law = seconds_of(coated.lammps);
    lammps_close(coated.lammps);

    void *granular = box_of_grains(crystal, CELLS, "gran/hertz/history 1e9 NULL 0 NULL 0.5 1");
    const double by_hertz = seconds_of(granular);
    lammps_close(granular);

    printf("%.0f contacts; per contact and step: compiled law %.1f ns, gran/hertz/history %.1f ns\n", contacts,
           1e9 * (by_law - lists) / (contacts * STEPS), 1e9 * (by_hertz - lists) / (contacts * STEPS));
}

int main(void)
{
    mdr_law *law = two_grains();
    mdr_law_view view;
    check(mdr_law_view_of(law, MDR_ON_UNLOADING, &view));
    const int failed = collide(view);
    compare_costs(view);
    check(mdr_free(law));
    if (failed) puts("ENERGY IS NOT CONSERVED");
    return failed ? EXIT_FAILURE : EXIT_SUCCESS;
}
