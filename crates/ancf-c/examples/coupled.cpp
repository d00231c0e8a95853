/*
 * Couples the two models of coupled.c with iterations: the force of the coupling varies linearly over each exchange interval, and the
 * interval is repeated from a snapshot until the force at its end agrees with the states there (implicit coupling).
 *
 * The error of the coupling is proportional to the square of the exchange interval.
 *
 * Usage: coupled FOLDER, with the models trolley.toml, pendulum.toml and whole.toml.
 */

#include <cmath>
#include <cstdio>
#include <exception>
#include <string>
#include <utility>

#include "ancf.hpp"

namespace {

constexpr double stiffness = 200, damping = 2, end = 1;

/// A model with one input and with the position and the speed of its end of the coupling.
struct Side {
    explicit Side(const std::string &path)
        : simulation(ancf::Simulation::open(path)), force(simulation.input("coupling")),
          position(simulation.column("rail.displacement")), speed(simulation.column("rail.speed")) {}

    ancf::Simulation simulation;
    std::size_t force, position, speed;
};

double force_between(const Side &a, const Side &b) {
    double stretch = b.simulation.read(b.position) - a.simulation.read(a.position);
    double rate = b.simulation.read(b.speed) - a.simulation.read(a.speed);
    return stiffness * stretch + damping * rate;
}

/// Position of the trolley and angle of the pendulum at the end, with exchanges at a number of equal intervals.
std::pair<double, double> couple(const std::string &folder, int intervals) {
    Side a(folder + "/trolley.toml"), b(folder + "/pendulum.toml");
    const double h = end / intervals;
    for (int i = 1; i <= intervals; i++) {
        const auto start_a = a.simulation.save(), start_b = b.simulation.save();
        double last = force_between(a, b);
        for (int iteration = 0; iteration < 50; iteration++) {
            a.simulation.restore(start_a);
            b.simulation.restore(start_b);
            a.simulation.set(a.force, last, h);
            b.simulation.set(b.force, -last, h);
            a.simulation.advance(end * i / intervals);
            b.simulation.advance(end * i / intervals);
            const double next = force_between(a, b), change = std::abs(next - last);
            last = next;
            if (change < 1e-10) break;
        }
    }
    return {a.simulation.read(a.position), b.simulation.read(b.simulation.column("pin.angle"))};
}

int run(const std::string &folder) {
    auto whole = ancf::Simulation::open(folder + "/whole.toml");
    whole.advance(end);
    const double position = whole.read(whole.column("rail.displacement")), angle = whole.read(whole.column("pin.angle"));
    double errors[2];
    for (int i = 0; i < 2; i++) {
        const int intervals = 50 << i;
        const auto [x, phi] = couple(folder, intervals);
        errors[i] = std::hypot(x - position, phi - angle);
        std::printf("%d exchanges: %.6f m, %.6f rad, error %.2e\n", intervals, x, phi, errors[i]);
    }
    std::printf("one model:     %.6f m, %.6f rad\n", position, angle);
    const double order = std::log2(errors[0] / errors[1]);
    std::printf("order %.2f\n", order);
    return errors[1] < 1e-3 && std::abs(order - 2) < 0.15 ? 0 : 1;
}

} // namespace

int main(int count, char **arguments) {
    if (count != 2) {
        std::fprintf(stderr, "usage: %s FOLDER\n", arguments[0]);
        return 2;
    }
    try {
        return run(arguments[1]);
    } catch (const std::exception &error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 1;
    }
}
