/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * From a measured force-depth curve to the modulus of a film: a sphere of 10 um radius on thermal oxide on silicon, fitted with
 * the exact layered medium. The film's thickness is known to 10 nm, and that uncertainty goes into the modulus.
 *
 * Usage: film_from_curve examples/fit/sphere_on_oxide.csv   (two columns: depth in nm, load in mN, one header line)
 * Units of this program: nm, GPa and nN (1 GPa nm^2 = 1 nN).
 */
#include <mdrcontact.h>

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

enum { MOST_POINTS = 10000 };

/* The numbers of this problem, in the library's order: indenter, medium, instrument. */
enum {
    RADIUS,
    FILM_E,
    FILM_NU,
    FILM_THICKNESS,
    SUBSTRATE_E,
    SUBSTRATE_NU,
    MODEL_CONSTANT,
    INSTRUMENT,
    COUNT = INSTRUMENT + MDR_FIT_INSTRUMENT_COUNT
};

static void check(int status)
{
    if (status != MDR_SUCCESS) {
        char text[512];
        mdr_last_error(text, (int)sizeof text);
        fprintf(stderr, "%s: %s\n", mdr_status_name(status), text);
        exit(EXIT_FAILURE);
    }
}

/* Depth and load, and 1 % of the load as its standard deviation; points below 3 nm are left out. */
static int read_curve(const char *path, double depth[], double load[], double sd[])
{
    char line[256];
    int n = 0;
    double d, F;
    FILE *file = fopen(path, "r");

    if (file == NULL) {
        fprintf(stderr, "%s cannot be read\n", path);
        exit(EXIT_FAILURE);
    }
    while (n < MOST_POINTS && fgets(line, sizeof line, file) != NULL) {
        if (sscanf(line, "%lf,%lf", &d, &F) != 2 || d < 3.0) continue;
        depth[n] = d;
        load[n] = 1e6 * F; /* mN to nN */
        sd[n] = 0.01 * load[n];
        n++;
    }
    fclose(file);
    return n;
}

static void set_problem(mdr_fit_problem *problem, mdr_fit_parameter numbers[COUNT])
{
    static const double values[COUNT] = {10000, 60, 0.17, 500, 163, 0.22, 1, /* instrument: */ 0, 0, 0, 0, INFINITY, 0.75, 1,
                                         1, 1};

    for (int i = 0; i < COUNT; i++) numbers[i] = (mdr_fit_parameter){values[i], -INFINITY, INFINITY, 0, 0, 0};
    numbers[FILM_E].is_free = 1;
    numbers[FILM_THICKNESS].is_free = 1;
    numbers[FILM_THICKNESS].prior = 500;
    numbers[FILM_THICKNESS].prior_sd = 10;
    numbers[INSTRUMENT + MDR_FIT_DEPTH_OFFSET].is_free = 1;

    *problem = MDR_SIZED(mdr_fit_problem);
    problem->data_kind = MDR_FIT_FORCE_DEPTH;
    problem->indenter = MDR_FIT_INDENTER_SPHERE;
    problem->medium = MDR_FIT_MEDIUM_STACK;
    problem->model = MDR_MODEL_EXACT;
    problem->parameter_count = COUNT;
    problem->parameters = numbers;
}

int main(int argc, char *argv[])
{
    static double depth[MOST_POINTS], load[MOST_POINTS], sd[MOST_POINTS];
    mdr_fit_problem problem;
    mdr_fit_parameter numbers[COUNT];
    mdr_fit_summary summary = MDR_SIZED(mdr_fit_summary);
    double values[COUNT], covariance[COUNT * COUNT], lower, upper;
    const int offset = INSTRUMENT + MDR_FIT_DEPTH_OFFSET;
    int n;

    if (argc != 2) {
        fprintf(stderr, "usage: %s CURVE.csv\n", argv[0]);
        return EXIT_FAILURE;
    }
    n = read_curve(argv[1], depth, load, sd);
    set_problem(&problem, numbers);
    check(mdr_fit_solve(&problem, n, depth, load, NULL, sd, values, covariance, NULL, NULL, NULL, NULL, NULL, &summary));
    printf("%d points, %s after %d evaluations, chi-square %.1f of %.1f degrees of freedom\n", n,
           summary.converged ? "converged" : "NOT converged", summary.evaluations, summary.chi_square, summary.degrees_of_freedom);
    printf("film modulus    %7.2f +- %.2f GPa\n", values[FILM_E], sqrt(covariance[FILM_E * COUNT + FILM_E]));
    printf("film thickness  %7.2f +- %.2f nm\n", values[FILM_THICKNESS],
           sqrt(covariance[FILM_THICKNESS * COUNT + FILM_THICKNESS]));
    printf("depth offset    %7.3f +- %.3f nm\n", values[offset], sqrt(covariance[offset * COUNT + offset]));
    check(mdr_fit_interval(&problem, n, depth, load, NULL, sd, FILM_E, 0.95, &lower, &upper));
    printf("95 %% interval of the modulus by profile likelihood: %.2f to %.2f GPa\n", lower, upper);
    return EXIT_SUCCESS;
}
