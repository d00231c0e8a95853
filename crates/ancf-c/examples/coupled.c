/*
 * Couples two models: a trolley on a rail and the hanger of a pendulum beside it, connected by a spring and a damper that this program
 * computes. Each exchange interval, both models receive the force of its begin (explicit coupling), and advance in their own steps.
 *
 * The reference is one model of the whole mechanism. The error of the coupling is proportional to the exchange interval.
 *
 * Usage: coupled FOLDER, with the models trolley.toml, pendulum.toml and whole.toml.
 */

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "ancf.h"

#define STIFFNESS 200.0
#define DAMPING 2.0
#define END 1.0

static void check(ancf_status status) {
    if (status != ANCF_STATUS_OK) {
        fprintf(stderr, "status %d: %s\n", (int)status, ancf_last_error());
        exit(1);
    }
}

static ancf_simulation *open_in(const char *folder, const char *name) {
    char path[4096];
    ancf_simulation *simulation = NULL;
    snprintf(path, sizeof path, "%s/%s", folder, name);
    check(ancf_open(path, &simulation));
    return simulation;
}

/* A model with one input and with the position and the speed of its end of the coupling. */
typedef struct {
    ancf_simulation *simulation;
    size_t force, position, speed;
} side;

static side open_side(const char *folder, const char *name) {
    side s;
    s.simulation = open_in(folder, name);
    check(ancf_find_input(s.simulation, "coupling", &s.force));
    check(ancf_find_column(s.simulation, "rail.displacement", &s.position));
    check(ancf_find_column(s.simulation, "rail.speed", &s.speed));
    return s;
}

static double read_column(ancf_simulation *simulation, size_t column) {
    double value = 0;
    check(ancf_read(simulation, column, &value));
    return value;
}

/* Position of the trolley and angle of the pendulum at the end, with exchanges at a number of equal intervals. */
static void couple(const char *folder, int intervals, double result[2]) {
    side a = open_side(folder, "trolley.toml"), b = open_side(folder, "pendulum.toml");
    for (int i = 1; i <= intervals; i++) {
        double stretch = read_column(b.simulation, b.position) - read_column(a.simulation, a.position);
        double rate = read_column(b.simulation, b.speed) - read_column(a.simulation, a.speed);
        double force = STIFFNESS * stretch + DAMPING * rate;
        check(ancf_set_input(a.simulation, a.force, force, 0));
        check(ancf_set_input(b.simulation, b.force, -force, 0));
        check(ancf_advance(a.simulation, END * i / intervals, NULL));
        check(ancf_advance(b.simulation, END * i / intervals, NULL));
    }
    size_t angle;
    check(ancf_find_column(b.simulation, "pin.angle", &angle));
    result[0] = read_column(a.simulation, a.position);
    result[1] = read_column(b.simulation, angle);
    ancf_close(a.simulation);
    ancf_close(b.simulation);
}

int main(int count, char **arguments) {
    if (count != 2) {
        fprintf(stderr, "usage: %s FOLDER\n", arguments[0]);
        return 2;
    }
    const char *folder = arguments[1];
    ancf_simulation *whole = open_in(folder, "whole.toml");
    size_t position, angle;
    check(ancf_find_column(whole, "rail.displacement", &position));
    check(ancf_find_column(whole, "pin.angle", &angle));
    check(ancf_advance(whole, END, NULL));
    double reference[2] = {read_column(whole, position), read_column(whole, angle)};
    ancf_close(whole);

    double errors[2];
    for (int i = 0; i < 2; i++) {
        int intervals = 500 << i;
        double result[2];
        couple(folder, intervals, result);
        errors[i] = hypot(result[0] - reference[0], result[1] - reference[1]);
        printf("%d exchanges: %.6f m, %.6f rad, error %.2e\n", intervals, result[0], result[1], errors[i]);
    }
    printf("one model:     %.6f m, %.6f rad\n", reference[0], reference[1]);
    double order = log2(errors[0] / errors[1]);
    printf("order %.2f\n", order);
    return errors[1] < 2e-3 && fabs(order - 1) < 0.15 ? 0 : 1;
}
