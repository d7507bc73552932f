/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * From a measured force-depth curve to the modulus of a film: a sphere of 10 um radius on thermal oxide on silicon, fitted with
 * the exact layered medium. The film's thickness is known to 10 nm, and that uncertainty goes into the modulus.
 *
 * Usage: film_from_curve examples/fit/sphere_on_oxide.csv   (two columns: depth in nm, load in mN, one header line)
 * Units of this program: nm, GPa and nN (1 GPa nm^2 = 1 nN).
 */
#include <mdrcontact/fit.h>

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { MOST_POINTS = 10000 };

enum { MOST_NUMBERS = 30 };

static void check(int status)
{
    if (status != MDR_SUCCESS) {
        fprintf(stderr, "%s: %s\n", mdr_name_of(status), mdr_last_error());
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

/* The position of a number of the problem, which becomes free. */
static int set_free(mdr_fit_parameter numbers[MOST_NUMBERS], const char *name)
{
    int i = 0;

    while (strcmp(numbers[i].name, name) != 0) i++;
    numbers[i].is_free = 1;
    return i;
}

int main(int argc, char *argv[])
{
    static double depth[MOST_POINTS], load[MOST_POINTS], sd[MOST_POINTS];
    mdr_profile *sphere = NULL;
    mdr_body *body = NULL;
    mdr_medium *oxide = NULL;
    mdr_fit_problem problem = MDR_SIZED(mdr_fit_problem);
    mdr_fit_parameter numbers[MOST_NUMBERS];
    mdr_fit_summary summary = MDR_SIZED(mdr_fit_summary);
    double values[MOST_NUMBERS], covariance[MOST_NUMBERS * MOST_NUMBERS], lower, upper;
    int n, count, modulus, thickness, offset;

    if (argc != 2) {
        fprintf(stderr, "usage: %s CURVE.csv\n", argv[0]);
        return EXIT_FAILURE;
    }
    n = read_curve(argv[1], depth, load, sd);
    check(mdr_profile_sphere(10000.0, &sphere));
    const mdr_layer coating = mdr_isotropic(60.0, 0.17, 500.0), base = mdr_isotropic(163.0, 0.22, 0.0);
    check(mdr_body_layered(1, &coating, &base, NULL, &body));
    check(mdr_medium_new(body, NULL, &oxide));
    check(mdr_free(body));
    problem.profile = sphere;
    problem.medium = oxide;
    problem.parameters = numbers;
    check(mdr_fit_parameters(&problem, MOST_NUMBERS, numbers, &count));
    problem.parameter_count = count;
    modulus = set_free(numbers, "layers[0].E");
    thickness = set_free(numbers, "layers[0].thickness");
    offset = set_free(numbers, "depth_offset");
    numbers[thickness].prior = 500.0;
    numbers[thickness].prior_sd = 10.0;
    check(mdr_fit_solve(&problem, n, depth, load, NULL, sd, values, covariance, NULL, NULL, NULL, NULL, NULL, &summary));
    printf("%d points, %s after %d evaluations, chi-square %.1f of %.1f degrees of freedom\n", n,
           summary.converged ? "converged" : "NOT converged", summary.evaluations, summary.chi_square, summary.degrees_of_freedom);
    printf("film modulus    %7.2f +- %.2f GPa\n", values[modulus], sqrt(covariance[modulus * count + modulus]));
    printf("film thickness  %7.2f +- %.2f nm\n", values[thickness],
           sqrt(covariance[thickness * count + thickness]));
    printf("depth offset    %7.3f +- %.3f nm\n", values[offset], sqrt(covariance[offset * count + offset]));
    check(mdr_fit_interval(&problem, n, depth, load, NULL, sd, modulus, 0.95, &lower, &upper));
    printf("95 %% interval of the modulus by profile likelihood: %.2f to %.2f GPa\n", lower, upper);
    MDR_FREE(oxide);
    MDR_FREE(sphere);
    return EXIT_SUCCESS;
}
