/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * LAMMPS: grains that yield, rub and stick. Normal forces come from a plastic law by fix external. Each contact remembers the numbers
 * of the law, its tangential force T and the stiffness that belongs to it.
 *
 * 1. Two grains collide. Check: the coefficient of restitution is that of the law, 1 below yield; with adhesion slow grains stick.
 * 2. Damping after Hunt and Crossley, F (1 + lambda v). Check: below yield the coefficient of restitution is the prescribed one
 *    (docs/laws.md).
 * 3. A cloud with random velocities and spins, of steel balls under Coulomb's friction and of steel dust that sticks, whose contacts
 *    bear a constant shear strength. Check: the energy of motion, spin and contacts and what plastic flow, jumps and tangential
 *    forces have taken stay in sum; so do momentum and angular momentum.
 *
 * T grows by the stiffness of the contact radius and is cut at its limit: a model while the contact yields. A pair of grains that is
 * apart forgets its imprint, as it meets elsewhere next time. SI units.
 */
#include "contact_memory.h"
#include "grain_motion.h"
#include "lammps_commands.h"

#include <mdrcontact/plastic.h>
#include <mdrcontact_plastic_law.h>

static const double pi = 3.14159265358979323846;

/* Grains of one size, and how two of them touch. */
typedef struct kind {
    const char *name;
    double diameter, density, E, nu, yield_stress;
    double work_of_adhesion, friction, shear_strength;
    double largest_depth;
    mdr_plastic_law *law;
    mdr_plastic_law_facts facts;
    double *numbers;
    mdr_plastic_view view;
} kind;

/* Two equal grains that yield, whose gap is that of a ball of half the radius and a plane. */
static void make_law(kind *self)
{
    const double strain = 0.0;
    mdr_plastic_law_options options = MDR_SIZED(mdr_plastic_law_options);
    mdr_profile *gap = NULL;
    mdr_yielding *metal = NULL;

    check(mdr_profile_paraboloid(0.25 * self->diameter, &gap));
    check(mdr_yielding_new(self->E, self->nu, 1, &strain, &self->yield_stress, &metal));
    options.other = metal;
    options.work_of_adhesion = self->work_of_adhesion;
    check(mdr_plastic_law_new(gap, metal, self->largest_depth, &options, &self->law));
    self->facts = MDR_SIZED(mdr_plastic_law_facts);
    check(mdr_plastic_law_about(self->law, &self->facts));
    self->numbers = room_for((size_t)self->facts.buffer_size, sizeof(double));
    check(mdr_plastic_law_buffer(self->law, self->facts.buffer_size, self->numbers));
    check(mdr_plastic_view_at(self->numbers, self->numbers, &self->view));
    check(mdr_free(metal));
    check(mdr_free(gap));
}

/* What a contact remembers: the numbers of the law, two of them with adhesion; T and its stiffness; the depth. */
enum { OF_LAW = 0, OF_T = 2, OF_STIFFNESS = 5, OF_DAMPING = 6, OF_DEPTH = 7, RECORD = 8 };

typedef struct grains {
    void *lammps;
    const kind *kind;
    double step, lambda; /* of time; of damping */
    int64_t last;        /* the step that the memory is of */
    contact_memory now, before;
    double taken;        /* by plastic flow and jumps of contacts that have ended, by tangential forces and damping of all */
    long formed, contacts;
} grains;

/* The energies of a contact. */
static void energies_of(const grains *self, const double record[], double *stored, double *dissipated)
{
    check(mdr_plastic_view_energies(&self->kind->view, record[OF_DEPTH], record + OF_LAW, stored, dissipated));
}

/* The tangential force after a shift: on the second grain, and opposite on the first. */
static void rub(grains *self, const touch *t, const mdr_plastic_point *state, const double shift[3], double record[])
{
    const kind *of = self->kind;
    const double stiffness = 4.0 * (1.0 - of->nu) / (2.0 - of->nu) * of->facts.modulus * state->radius; /* Mindlin */
    const double limit = of->shear_strength > 0.0 ? of->shear_strength * pi * state->radius * state->radius
                                                  : of->friction * (state->force > 0.0 ? state->force : 0.0);
    double *const T = record + OF_T, old[3];
    const double before = sqrt(dot(T, T)), along = dot(T, t->normal);

    for (int c = 0; c < 3; c++) T[c] -= along * t->normal[c]; /* it turns with the pair */
    const double turned = sqrt(dot(T, T));
    double share = turned > 0.0 ? before / turned : 0.0;
    for (int c = 0; c < 3; c++) old[c] = share * T[c];
    share = stiffness < record[OF_STIFFNESS] ? stiffness / record[OF_STIFFNESS] : 1.0;
    for (int c = 0; c < 3; c++) T[c] = share * old[c] + stiffness * shift[c];
    const double size = sqrt(dot(T, T));
    if (size > limit) {
        for (int c = 0; c < 3; c++) T[c] *= limit / size;
    }
    record[OF_STIFFNESS] = stiffness;
    for (int c = 0; c < 3; c++) self->taken += 0.5 * (old[c] + T[c]) * shift[c];
}

/* A pair of grains: the forces of its contact, if it has one. Half-step velocities v and omega led here from the last step. */
static void press(grains *self, touch t, const int *tag, double *const *x, double **f, double **torque, double *const *v,
                  double *const *omega, double time)
{
    const kind *of = self->kind;
    const uint64_t pair = pair_of(tag[t.i], tag[t.j]);
    const int old = *find(&self->before, pair);
    const double along[3] = {x[t.i][0] - x[t.j][0], x[t.i][1] - x[t.j][1], x[t.i][2] - x[t.j][2]};
    const double distance = sqrt(dot(along, along)), d = of->diameter - distance;
    const double *past = old < 0 ? NULL : self->before.records + old * RECORD;
    mdr_plastic_point state;
    double shift[3], spin, rate = 0.0, moment[3];

    /* separated grains; contacts that stick are closed at negative depth, their first number is negative */
    if (d < 0.0 && !(past && past[OF_LAW] < 0.0)) return;
    if (old < 0) self->formed++;
    else self->before.segment[old] = 0; /* it goes on */
    double *const record = self->now.records + RECORD * remember(&self->now, pair, 1, past);
    t.arm = 0.5 * distance;
    for (int c = 0; c < 3; c++) {
        t.normal[c] = along[c] / distance;
        rate -= (v[t.i][c] - v[t.j][c]) * t.normal[c];
    }
    check(mdr_plastic_view_try(&of->view, d, record + OF_LAW, record + OF_LAW, &state));
    motion_of(&t, v, omega, time, shift, &spin);
    rub(self, &t, &state, shift, record);
    const double damping = self->lambda * rate * (state.force > 0.0 ? state.force : 0.0);
    self->taken += 0.5 * (record[OF_DAMPING] + damping) * rate * time;
    record[OF_DAMPING] = damping;
    record[OF_DEPTH] = d;
    const double *const T = record + OF_T;
    cross(t.normal, T, moment);
    for (int c = 0; c < 3; c++) {
        f[t.i][c] += (state.force + damping) * t.normal[c] - T[c];
        f[t.j][c] -= (state.force + damping) * t.normal[c] - T[c];
        torque[t.i][c] += t.arm * moment[c];
        torque[t.j][c] += t.arm * moment[c];
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
    double **torque = lammps_extract_atom(self->lammps, "torque");
    const double time = step == self->last || self->last < 0 ? 0.0 : self->step;
    const contact_memory older = self->before;

    self->before = self->now;
    self->now = older;
    forget(&self->now);
    for (int i = 0; i < n; i++) f[i][0] = f[i][1] = f[i][2] = 0.0;
    for (int row = 0; row < rows; row++) {
        int i, neighbours, *neighbour;
        lammps_neighlist_element_neighbors(self->lammps, list, row, &i, &neighbours, &neighbour);
        for (int entry = 0; entry < neighbours; entry++) {
            const int j = neighbour[entry] & NEIGHBOUR_BITS;
            const int first = tag[i] < tag[j] ? i : j; /* lists name them either way; T keeps its sense */
            const touch t = {first, i + j - first, {0.0, 0.0, 0.0}, 0.0};
            press(self, t, tag, x, f, torque, v, omega, time);
        }
    }
    for (int old = 0; old < self->before.count; old++) { /* contacts that have ended */
        double stored, dissipated;
        if (self->before.segment[old] == 0) continue;
        energies_of(self, self->before.records + old * RECORD, &stored, &dissipated);
        self->taken += stored + dissipated;
    }
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
    s.dissipated = self->taken;
    for (int number = 0; number < self->now.count; number++) {
        double stored, dissipated;
        energies_of(self, self->now.records + number * RECORD, &stored, &dissipated);
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
    self->now = memory_for(room, RECORD);
    self->before = memory_for(room, RECORD);
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
    command(self->lammps, "fix move all nve/sphere");
}

static void close_grains(grains *self)
{
    lammps_close(self->lammps);
    free_memory(&self->now);
    free_memory(&self->before);
}

/* Two grains collide head-on. Returns their coefficient of restitution, 0 if they stick, and the relative change of the
 * energy. */
static double rebound(const kind *of, double speed, double lambda, double *lost)
{
    const int cells[3] = {1, 1, 2};
    const double mass = pi / 12.0 * of->density * pow(of->diameter, 3.0); /* reduced */
    /* Hertz's contact lasts as long; adhesion acts within a time that does not grow as 1/V */
    const double quick = fmax(speed, 0.1), star = of->facts.modulus;
    const double time = 2.87 * pow(mass * mass / (0.25 * of->diameter * star * star * quick), 0.2);
    char words[64];
    grains two;

    open_grains(&two, of, cells, of->diameter * (1.0 + 1e-12), time / 20000.0);
    two.lambda = lambda;
    double **v = lammps_extract_atom(two.lammps, "v"), **x = lammps_extract_atom(two.lammps, "x");
    const int lower = x[0][2] < x[1][2] ? 0 : 1;
    v[lower][2] = 0.5 * speed;
    v[1 - lower][2] = -0.5 * speed;
    command(two.lammps, "run 0");
    const double before = sums_of(&two).energy;
    snprintf(words, sizeof words, "run %d", 60000);
    command(two.lammps, words);
    v = lammps_extract_atom(two.lammps, "v");
    x = lammps_extract_atom(two.lammps, "x");
    const double after = fabs(v[1][2] - v[0][2]) / speed;
    const int apart = two.now.count == 0;
    const sums end = sums_of(&two);
    *lost = (end.energy - before) / fmax(before, end.dissipated); /* adhesion brings the energy of its jump */
    close_grains(&two);
    return apart ? after : 0.0;
}

/* Returns 1 if the coefficients of restitution are not those of the law. */
static int bounce(const kind *of, int count, const double speed[], double bound)
{
    const double mass = pi / 12.0 * of->density * pow(of->diameter, 3.0);
    int failed = 0;
    printf("%s\n  V [m/s]   restitution   of the law   change of energy\n", of->name);
    for (int i = 0; i < count; i++) {
        double lost, e;
        check(mdr_plastic_law_restitution(of->law, mass, 1, &speed[i], &e));
        const double found = rebound(of, speed[i], 0.0, &lost);
        printf("%9.3g    %.6f      %.6f       %8.1e\n", speed[i], found, e, lost);
        failed = failed || !(fabs(found - e) < bound && fabs(lost) < bound);
    }
    puts("");
    return failed;
}

/* Returns 1 if damping does not give a prescribed coefficient of restitution below yield: c (1 + e) = ln((1 + c)/(1 - e c)),
 * c = lambda V. */
static int damp(const kind *of, double speed)
{
    const double c = 1.0, lambda = c / speed;
    double low = 0.0, high = 1.0 / c, lost;
    for (int i = 0; i < 60; i++) {
        const double e = 0.5 * (low + high);
        if (c * (1.0 + e) > log1p(c) - log1p(-e * c)) low = e;
        else high = e;
    }
    const double found = rebound(of, speed, lambda, &lost);
    printf("damping: restitution %.6f, prescribed %.6f\n\n", found, low);
    return !(fabs(found - low) < 1e-5 && fabs(lost) < 1e-5);
}

/* A cloud with velocities and spins up to a speed of the surface. Returns 1 if a sum does not stay. */
static int collide(const kind *of, double gap, double speed, double step, int steps, double bound)
{
    enum { SIDE = 5, PARTS = 10 };
    const int cells[3] = {SIDE, SIDE, SIDE}, n = SIDE * SIDE * SIDE;
    double worst = 0.0, momentum = 0.0, angular_momentum = 0.0, before = 0.0;
    uint32_t seed = 1;
    char words[64];
    grains cloud;
    sums first, s;
    int falls = 0;

    open_grains(&cloud, of, cells, of->diameter + gap, step);
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
        falls = falls || s.dissipated < before - 0.01 * first.energy;
        before = s.dissipated;
        printf("%9.2e   %.5e   %+.5e   %.5e     %8.1e\n", steps / PARTS * step * part, s.motion, s.stored, s.dissipated, change);
    }
    printf("%d grains, %d steps: %ld contacts formed, %.1f at a time\n", n, steps, cloud.formed, (double)cloud.contacts / steps);
    printf("momentum and angular momentum change by %.0e and %.0e\n\n", momentum, angular_momentum);
    const long formed = cloud.formed;
    close_grains(&cloud);
    return falls || !(worst < bound && momentum < 1e-12 && angular_momentum < 1e-12 && s.dissipated > 0.1 * first.energy && formed > n);
}

int main(void)
{
    kind balls = {.name = "steel balls, friction 0.3", .diameter = 1e-3, .density = 7800.0, .E = 210e9, .nu = 0.3,
                  .yield_stress = 1e9, .friction = 0.3, .largest_depth = 8e-6};
    kind dust = {.name = "steel dust, work of adhesion 0.1 J/m^2, shear strength 100 MPa", .diameter = 10e-6, .density = 7800.0,
                 .E = 210e9, .nu = 0.3, .yield_stress = 1e9, .work_of_adhesion = 0.1, .shear_strength = 100e6,
                 .largest_depth = 80e-9};
    const double of_balls[] = {0.01, 0.1, 0.5, 1.0}, of_dust[] = {0.001, 0.1, 0.5};
    int failed;

    make_law(&balls);
    make_law(&dust);
    failed = bounce(&balls, 4, of_balls, 1e-5);
    failed += bounce(&dust, 3, of_dust, 1e-4);
    failed += damp(&balls, 0.01);
    failed += collide(&balls, 1e-5, 0.5, 1e-8, 40000, 1e-5);
    failed += collide(&dust, 2e-8, 0.2, 1e-10, 40000, 1e-4);
    for (kind *of[] = {&balls, &dust}, **each = of; each < of + 2; each++) {
        check(mdr_free((*each)->law));
        free((*each)->numbers);
    }
    if (failed) puts("A CHECK FAILED");
    return failed ? EXIT_FAILURE : EXIT_SUCCESS;
}
