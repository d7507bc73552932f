/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * LAMMPS: grains that rub and stick. As in grains_lammps.c forces come from a compiled law by fix external; the law's sliders give
 * the tangential forces, which turn the grains (atom_style sphere), and an adhesive law says when contacts form and break.
 *
 * 1. Coated glass grains under Coulomb's friction, and grains of silica dust that stick and whose contacts bear a constant shear
 *    strength: a cloud of each with random velocities and spins. Check: the energy of motion, spin and contacts and what slip and
 *    jumps into contact have dissipated stay in sum; so do momentum and angular momentum.
 * 2. Two grains are pulled apart: two of silica, two of glass with a coat that sticks. Check: the greatest tension is the pull-off
 *    force, JKR's 3/2 pi R times the work of adhesion where there is no coat, and they part at the depth of pull-off.
 * 3. A grain spins on another one. Check: friction slows it as a force mu F does; under a shear strength as pi a^2 times that.
 * 4. Two grains that stick are sheared, then turned as one. Check: T turns with them.
 *
 * Rolling and spin about the normal meet no resistance here. SI units.
 */
#include "contact_memory.h"
#include "grain_motion.h"
#include "lammps_commands.h"

#include <math.h>
#include <mdrcontact_law.h>

static const double pi = 3.14159265358979323846;

/* Grains of one size, and how two of them touch. */
typedef struct kind {
    const char *name;
    double diameter, density, coat, E_coat, nu_coat, E, nu; /* coat 0: none */
    double work_of_adhesion, friction, shear_strength;
    double largest_depth;
    mdr_contact *contact;
    mdr_law *law;
    mdr_law_view view;
    mdr_law_facts facts;
    double jump; /* the energy that a jump into contact dissipates; these laws have one segment, and no jump within contact */
} kind;

/* Two equal grains: bodies in series, whose gap is that of a ball of half the radius and a plane. */
static void make_law(kind *self)
{
    const mdr_layer coat = mdr_isotropic(self->E_coat, self->nu_coat, self->coat), base = mdr_isotropic(self->E, self->nu, 0.0);
    mdr_contact_options adhesion = MDR_SIZED(mdr_contact_options);
    mdr_law_options options = MDR_SIZED(mdr_law_options);
    mdr_profile *gap = NULL;
    mdr_body *body = NULL;
    mdr_medium *grain = NULL, *both = NULL;
    mdr_friction *friction = NULL;
    mdr_law_point point;
    int segment = 0;

    adhesion.work_of_adhesion = self->work_of_adhesion;
    check(mdr_profile_paraboloid(0.25 * self->diameter, &gap));
    check(mdr_body_layered(self->coat > 0.0, &coat, &base, NULL, &body));
    check(mdr_medium_new(body, NULL, &grain));
    check(mdr_free(body));
    check(mdr_medium_pair(grain, grain, &both));
    check(mdr_contact_new(gap, both, &adhesion, &self->contact));
    if (self->friction > 0.0) check(mdr_friction_new(self->contact, self->friction, &friction));
    options.friction = friction;
    options.shear_strength = self->shear_strength;
    options.sliders = 16 * (self->friction > 0.0 || self->shear_strength > 0.0);
    options.continue_beyond = 1;
    check(mdr_law_new(self->contact, self->largest_depth, &options, &self->law));
    check(mdr_law_view_of(self->law, MDR_ON_UNLOADING, &self->view));
    self->facts = MDR_SIZED(mdr_law_facts);
    check(mdr_law_about(self->law, &self->facts));
    if (self->facts.adhesive) { /* U is 0 of bodies that are apart, and of those at pull-off */
        check(mdr_law_follow(self->law, 0.0, &segment, &point));
        self->jump = -point.energy;
        if (self->facts.segments != 1) exit(EXIT_FAILURE);
    }
    check(mdr_free(friction));
    check(mdr_free(both));
    check(mdr_free(grain));
    check(mdr_free(gap));
}

typedef struct grains {
    void *lammps;
    const kind *kind;
    double step;                /* of time */
    int64_t last;               /* the step that the memory is of */
    contact_memory now, before;
    touch *touches;
    double *load, *shift, *normal, *spin, *T; /* of each contact, as the law takes them */
    double normal_energy;       /* of all contacts */
    double lost;                /* energy dissipated by jumps, and by the friction of contacts that have ended */
    double greatest_tension, last_depth;
    long formed, ended, contacts;
} grains;

/* A pair of grains: is it in contact, by its own past and its depth? Then its force F along the normal is added to f. */
static void press(grains *self, touch t, const int *tag, double *const *x, double **f, double *const *v, double *const *omega,
                  double time)
{
    const uint64_t pair = pair_of(tag[t.i], tag[t.j]);
    const int old = *find(&self->before, pair);
    const double along[3] = {x[t.i][0] - x[t.j][0], x[t.i][1] - x[t.j][1], x[t.i][2] - x[t.j][2]};
    const double distance = sqrt(dot(along, along)), d = self->kind->diameter - distance;
    int segment = old < 0 ? 0 : self->before.segment[old];
    mdr_law_point point;

    if (segment == 0 && d < 0.0) return;
    check(mdr_law_view_follow(&self->kind->view, d, &segment, &point));
    if (segment == 0) return;
    t.arm = 0.5 * distance;
    for (int c = 0; c < 3; c++) t.normal[c] = along[c] / distance;

    const int number = remember(&self->now, pair, segment, old < 0 ? NULL : self->before.records + old * self->before.record);
    self->touches[number] = t;
    self->load[number] = self->kind->facts.shear_strength > 0.0 ? point.radius : point.force;
    memcpy(self->normal + 3 * number, t.normal, sizeof t.normal);
    motion_of(&t, v, omega, time, self->shift + 3 * number, self->spin + number);
    for (int c = 0; c < 3; c++) {
        f[t.i][c] += point.force * t.normal[c];
        f[t.j][c] -= point.force * t.normal[c];
    }
    self->normal_energy += point.energy;
    self->greatest_tension = fmax(self->greatest_tension, -point.force);
    self->last_depth = d;
    if (old < 0) {
        self->formed++;
        self->lost += self->kind->jump;
    } else {
        self->before.segment[old] = 0; /* it goes on */
    }
}

/* What a record of friction stores and what slip has taken; 0 without friction. */
static void friction_energies(const grains *self, const contact_memory *m, int number, double *stored, double *dissipated)
{
    *stored = *dissipated = 0.0;
    if (m->record > 0) check(mdr_law_energies(self->kind->law, 1, m->records + number * m->record, stored, dissipated));
}

/* The friction of contacts that have ended: what slip has taken, and what their springs still held. */
static void end_contacts(grains *self)
{
    for (int old = 0; old < self->before.count; old++) {
        double stored, dissipated;
        if (self->before.segment[old] == 0) continue;
        friction_energies(self, &self->before, old, &stored, &dissipated);
        self->lost += stored + dissipated;
        self->ended++;
    }
}

/* The tangential forces T of all contacts: on the second grain, and opposite on the first. */
static void rub(grains *self, double **f, double **torque)
{
    const mdr_law *law = self->kind->law;
    if (self->kind->facts.sliders == 0) return;
    check(mdr_law_turn(law, self->now.count, self->normal, self->spin, self->now.records));
    check(mdr_law_advance(law, self->now.count, self->load, self->shift, 0, NULL, self->now.records, self->T));
    for (int number = 0; number < self->now.count; number++) {
        const touch *t = self->touches + number;
        const double *T = self->T + 3 * number;
        double moment[3];
        cross(t->normal, T, moment);
        for (int c = 0; c < 3; c++) {
            f[t->i][c] -= T[c];
            f[t->j][c] += T[c];
            torque[t->i][c] += t->arm * moment[c];
            torque[t->j][c] += t->arm * moment[c];
        }
    }
}

/* LAMMPS's callback: forces f on the n grains at x, and torques. One process without periodic boundaries: every neighbour is one of
 * them. The beginning of a run calls it again at the last step of the run before: there no time has passed. */
static void contact_forces(void *context, int64_t step, int n, int *tag, double **x, double **f)
{
    grains *self = context;
    const int list = lammps_find_pair_neighlist(self->lammps, "zero", 1, 0, 0);
    const int rows = lammps_neighlist_num_elements(self->lammps, list);
    double **v = lammps_extract_atom(self->lammps, "v"), **omega = lammps_extract_atom(self->lammps, "omega");
    const double time = step == self->last || self->last < 0 ? 0.0 : self->step;
    const contact_memory older = self->before;

    self->before = self->now;
    self->now = older;
    forget(&self->now);
    self->normal_energy = 0.0;
    for (int i = 0; i < n; i++) f[i][0] = f[i][1] = f[i][2] = 0.0;
    for (int row = 0; row < rows; row++) {
        int i, neighbours, *neighbour;
        lammps_neighlist_element_neighbors(self->lammps, list, row, &i, &neighbours, &neighbour);
        for (int entry = 0; entry < neighbours; entry++) {
            const int j = neighbour[entry] & NEIGHBOUR_BITS;
            const int first = tag[i] < tag[j] ? i : j; /* lists name them either way; shift and normal keep their sense */
            const touch t = {first, i + j - first, {0.0, 0.0, 0.0}, 0.0};
            press(self, t, tag, x, f, v, omega, time);
        }
    }
    end_contacts(self);
    rub(self, f, lammps_extract_atom(self->lammps, "torque"));
    self->contacts += self->now.count;
    self->last = step;
}

/* What LAMMPS is not to change. */
typedef struct sums {
    double motion, stored, dissipated, energy; /* energy: all of them */
    double momentum[3], angular_momentum[3], all_momentum, all_angular_momentum; /* all: the sums of magnitudes */
} sums;

static sums sums_of(const grains *self)
{
    const int n = (int)lammps_get_natoms(self->lammps);
    double **x = lammps_extract_atom(self->lammps, "x"), **v = lammps_extract_atom(self->lammps, "v");
    double **omega = lammps_extract_atom(self->lammps, "omega"), *mass = lammps_extract_atom(self->lammps, "rmass");
    sums s = {0};

    for (int i = 0; i < n; i++) {
        const double inertia = 0.1 * mass[i] * self->kind->diameter * self->kind->diameter;
        double orbital[3];
        cross(x[i], v[i], orbital);
        s.motion += 0.5 * mass[i] * dot(v[i], v[i]) + 0.5 * inertia * dot(omega[i], omega[i]);
        for (int c = 0; c < 3; c++) {
            s.momentum[c] += mass[i] * v[i][c];
            s.angular_momentum[c] += mass[i] * orbital[c] + inertia * omega[i][c];
        }
        s.all_momentum += mass[i] * sqrt(dot(v[i], v[i]));
        s.all_angular_momentum += mass[i] * sqrt(dot(orbital, orbital)) + inertia * sqrt(dot(omega[i], omega[i]));
    }
    s.stored = self->normal_energy;
    s.dissipated = self->lost;
    for (int number = 0; number < self->now.count; number++) {
        double stored, dissipated;
        friction_energies(self, &self->now, number, &stored, &dissipated);
        s.stored += stored;
        s.dissipated += dissipated;
    }
    s.energy = s.motion + s.stored + s.dissipated;
    return s;
}

/* LAMMPS with cells_x cells_y cells_z grains of a kind on a simple cubic lattice. */
static void open_grains(grains *self, const kind *of, const int cells[3], double spacing, double step)
{
    const int room = 8 * cells[0] * cells[1] * cells[2];
    const double D = of->diameter;
    char words[256];

    *self = (grains){.lammps = open_lammps(), .kind = of, .step = step, .last = -1};
    self->now = memory_for(room, of->facts.memory_size);
    self->before = memory_for(room, of->facts.memory_size);
    self->touches = room_for((size_t)room, sizeof *self->touches);
    self->load = room_for((size_t)room, sizeof(double));
    self->shift = room_for(3 * (size_t)room, sizeof(double));
    self->normal = room_for(3 * (size_t)room, sizeof(double));
    self->spin = room_for((size_t)room, sizeof(double));
    self->T = room_for(3 * (size_t)room, sizeof(double));

    command(self->lammps, "boundary m m m");
    snprintf(words, sizeof words, "lattice sc %.17g", spacing);
    command(self->lammps, words);
    snprintf(words, sizeof words, "region box block -0.5 %.1f -0.5 %.1f -0.5 %.1f", cells[0] - 0.5, cells[1] - 0.5, cells[2] - 0.5);
    command(self->lammps, words);
    command(self->lammps, "create_box 1 box");
    command(self->lammps, "create_atoms 1 box");
    snprintf(words, sizeof words, "set type 1 diameter %.17g density %.17g", D, of->density);
    command(self->lammps, words);
    snprintf(words, sizeof words, "pair_style zero %.17g", 1.01 * D); /* contacts that stick reach farther than the diameter */
    command(self->lammps, words);
    command(self->lammps, "pair_coeff * *");
    snprintf(words, sizeof words, "neighbor %.17g bin", 0.1 * D);
    command(self->lammps, words);
    command(self->lammps, "neigh_modify delay 0 every 1 check yes");
    snprintf(words, sizeof words, "timestep %.17g", step);
    command(self->lammps, words);
    command(self->lammps, "fix law all external pf/callback 1 1");
    lammps_set_fix_external_callback(self->lammps, "law", contact_forces, self);
}

static void close_grains(grains *self)
{
    lammps_close(self->lammps);
    free_memory(&self->now);
    free_memory(&self->before);
    free(self->touches);
    free(self->load);
    free(self->shift);
    free(self->normal);
    free(self->spin);
    free(self->T);
}

/* A cloud with velocities and spins up to a speed of the surface. Returns 1 if a sum does not stay. */
static int collide(const kind *of, double gap, double speed, double step, int steps, double bound)
{
    enum { SIDE = 5, PARTS = 10 };
    const int cells[3] = {SIDE, SIDE, SIDE}, n = SIDE * SIDE * SIDE;
    double worst = 0.0, momentum = 0.0, angular_momentum = 0.0;
    uint32_t seed = 1;
    char words[64];
    grains cloud;
    sums first, s;

    open_grains(&cloud, of, cells, of->diameter + gap, step);
    command(cloud.lammps, "fix move all nve/sphere");
    double **v = lammps_extract_atom(cloud.lammps, "v"), **omega = lammps_extract_atom(cloud.lammps, "omega");
    for (int i = 0; i < n; i++) {
        for (int c = 0; c < 3; c++) {
            v[i][c] = speed * random_number(&seed);
            omega[i][c] = 2.0 * speed / of->diameter * random_number(&seed);
        }
    }
    snprintf(words, sizeof words, "run %d", steps / PARTS);
    command(cloud.lammps, "run 0");
    first = sums_of(&cloud);
    printf("%s\n  t [s]       motion [J]    stored [J]     dissipated [J]  change of the sum\n", of->name);
    for (int part = 0; part <= PARTS; part++) {
        if (part) command(cloud.lammps, words);
        s = sums_of(&cloud);
        const double change = s.energy / first.energy - 1.0;
        worst = fmax(worst, fabs(change));
        momentum = fmax(momentum, distance_of(s.momentum, first.momentum) / first.all_momentum);
        angular_momentum = fmax(angular_momentum,
                                distance_of(s.angular_momentum, first.angular_momentum) / first.all_angular_momentum);
        printf("%9.2e   %.5e   %+.5e   %.5e     %8.1e\n", steps / PARTS * step * part, s.motion, s.stored, s.dissipated, change);
    }
    printf("%d grains, %d steps: %ld contacts formed, %ld ended, %.1f at a time\n", n, steps, cloud.formed, cloud.ended,
           (double)cloud.contacts / steps);
    printf("momentum and angular momentum change by %.0e and %.0e\n\n", momentum, angular_momentum);
    const long formed = cloud.formed;
    close_grains(&cloud);
    return !(worst < bound && momentum < 1e-12 && angular_momentum < 1e-12 && s.dissipated > 0.1 * first.energy && formed > n);
}

/* Two grains that touch are pulled apart slowly. Returns 1 if they do not part as they should. */
static int pull_apart(const kind *of, double largest_tension)
{
    const int cells[3] = {1, 1, 2}, steps = 20000;
    const double pressed = -of->facts.lowest_depth, way = 3.0 * pressed, step = 1e-9;
    mdr_state at_depth;
    char words[128];
    grains two;

    check(mdr_contact_pull_off(of->contact, MDR_DEPTH, 1, &at_depth, NULL));
    open_grains(&two, of, cells, of->diameter - pressed, step);
    two.last_depth = NAN;
    command(two.lammps, "group upper id 2");
    snprintf(words, sizeof words, "fix pull upper move linear 0 0 %.17g units box", way / (steps * step));
    command(two.lammps, words);
    snprintf(words, sizeof words, "run %d", steps);
    command(two.lammps, words);
    const double error = two.greatest_tension / largest_tension - 1.0, depth_error = two.last_depth / at_depth.depth - 1.0;
    printf("%s: pulled apart at %.6e N, %.0e off; at a depth of %.5e m, %.0e off\n", of->name, two.greatest_tension, error,
           two.last_depth, depth_error);
    const int failed = !(fabs(error) < 1e-6 && fabs(depth_error) < 2e-4 && two.formed == 1 && two.ended == 1);
    close_grains(&two);
    return failed;
}

/* A grain spins on another one, their centres held, until long after sliding has begun; then for a while that is measured. Returns
 * 1 if it is not slowed as by a force. */
static int spin_on(const kind *of, double depth, double omega_0, double step, int skipped, int measured)
{
    const int cells[3] = {1, 1, 2};
    const double mass = pi / 6.0 * of->density * pow(of->diameter, 3.0), arm = 0.5 * (of->diameter - depth);
    mdr_state state;
    char words[64];
    grains two;

    check(mdr_contact_states(of->contact, MDR_DEPTH, MDR_ON_UNLOADING, 1, &depth, &state));
    open_grains(&two, of, cells, of->diameter - depth, step);
    command(two.lammps, "fix hold all setforce 0 0 0");
    command(two.lammps, "fix move all nve/sphere");
    ((double **)lammps_extract_atom(two.lammps, "omega"))[0][0] = omega_0;
    snprintf(words, sizeof words, "run %d", skipped);
    command(two.lammps, words);
    const double before = ((double **)lammps_extract_atom(two.lammps, "omega"))[0][0];
    snprintf(words, sizeof words, "run %d", measured);
    command(two.lammps, words);
    const double after = ((double **)lammps_extract_atom(two.lammps, "omega"))[0][0];
    const double T = (before - after) / (measured * step) * 0.1 * mass * of->diameter * of->diameter / arm;
    const double by_strength = pi * state.radius * state.radius * of->shear_strength;
    const double expected = of->friction > 0.0 ? of->friction * state.force : by_strength;
    printf("%s: a grain that spins is slowed by %.6e N, %.0e off\n", of->name, T, T / expected - 1.0);
    close_grains(&two);
    return !(fabs(T / expected - 1.0) < 1e-6);
}

/* Two grains that stick are sheared by a spin of the first, then turned by a right angle as one body, about an axis oblique to the
 * normal. Returns 1 if T does not turn with them. */
static int turn_together(const kind *of, double spin, double step, int sheared, int turned)
{
    const int cells[3] = {1, 1, 2};
    const double axis[3] = {2.0 / 3.0, 1.0 / 3.0, 2.0 / 3.0};
    double before[3], expected[3], along;
    char words[256];
    grains two;

    open_grains(&two, of, cells, of->diameter, step);
    ((double **)lammps_extract_atom(two.lammps, "omega"))[0][0] = spin;
    snprintf(words, sizeof words, "run %d", sheared); /* nothing moves them: the spin stays */
    command(two.lammps, words);
    memcpy(before, two.T, sizeof before);
    snprintf(words, sizeof words, "fix turn all move rotate 0 0 0 %.17g %.17g %.17g %.17g", axis[0], axis[1], axis[2],
             4.0 * turned * step);
    command(two.lammps, words);
    snprintf(words, sizeof words, "run %d", turned);
    command(two.lammps, words);
    cross(axis, before, expected);
    along = dot(axis, before);
    for (int c = 0; c < 3; c++) expected[c] += along * axis[c];
    const double error = distance_of(two.T, expected) / sqrt(dot(before, before));
    printf("%s: T = %.2f pi a^2 tau0 of two grains that turn as one is %.0e off\n", of->name,
           sqrt(dot(before, before)) / (pi * two.load[0] * two.load[0] * of->shear_strength), error);
    close_grains(&two);
    return !(error < 1e-7);
}

int main(void)
{
    kind coated = {.name = "coated glass, friction 0.3", .diameter = 1e-3, .density = 2500.0, .coat = 20e-6, .E_coat = 3e9,
                   .nu_coat = 0.35, .E = 70e9, .nu = 0.22, .friction = 0.3, .largest_depth = 10e-6};
    kind silica = {.name = "silica dust, shear strength 100 MPa", .diameter = 1.2e-6, .density = 2000.0, .E = 54e9, .nu = 0.17,
                   .work_of_adhesion = 0.05, .shear_strength = 100e6, .largest_depth = 5e-9};
    kind sticky = {.name = "glass with a sticky coat", .diameter = 1e-3, .density = 2500.0, .coat = 20e-6, .E_coat = 3e6,
                   .nu_coat = 0.49, .E = 70e9, .nu = 0.22, .work_of_adhesion = 0.1, .largest_depth = 10e-6};
    mdr_state pull_off;
    int failed;

    make_law(&coated);
    make_law(&silica);
    make_law(&sticky);
    check(mdr_contact_pull_off(sticky.contact, MDR_FORCE, 1, &pull_off, NULL));

    failed = collide(&coated, 1e-5, 0.2, 2e-8, 80000, 1e-3);
    failed += collide(&silica, 2e-9, 0.2, 1e-11, 40000, 1e-3);
    failed += pull_apart(&silica, 1.5 * pi * silica.work_of_adhesion * 0.25 * silica.diameter);
    failed += pull_apart(&sticky, -pull_off.force);
    failed += spin_on(&coated, 1e-6, 2e4, 1e-9, 500, 1000);
    failed += spin_on(&silica, 1e-9, 1e7, 1e-11, 100, 1000);
    failed += turn_together(&silica, 1e5, 1e-11, 100, 10000);
    for (kind *of[] = {&coated, &silica, &sticky}, **each = of; each < of + 3; each++) {
        check(mdr_free((*each)->law));
        check(mdr_free((*each)->contact));
    }
    if (failed) puts("A CHECK FAILED");
    return failed ? EXIT_FAILURE : EXIT_SUCCESS;
}
