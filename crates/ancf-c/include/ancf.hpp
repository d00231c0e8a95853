/*
 * C++ wrapper of ancf.h: a simulation that releases itself and reports errors as exceptions. Header only, C++17.
 */

#ifndef ANCF_HPP
#define ANCF_HPP

#include <cstddef>
#include <cstdint>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "ancf.h"

namespace ancf {

/// Error with the status and the message of the library.
class Error : public std::runtime_error {
public:
    explicit Error(ancf_status status) : std::runtime_error(ancf_last_error()), status_(status) {}

    ancf_status status() const noexcept { return status_; }

private:
    ancf_status status_;
};

/// Throws an exception unless the status is that of success.
inline void check(ancf_status status) {
    if (status != ANCF_STATUS_OK) throw Error(status);
}

/// Motion of a model that is advanced step by step. Movable, not copyable.
class Simulation {
public:
    /// Reads a model file.
    static Simulation open(const std::string &path) {
        ancf_simulation *simulation = nullptr;
        check(ancf_open(path.c_str(), &simulation));
        return Simulation(simulation);
    }

    /// Reads the text of a model file.
    static Simulation parse(const std::string &toml) {
        ancf_simulation *simulation = nullptr;
        check(ancf_parse(toml.c_str(), &simulation));
        return Simulation(simulation);
    }

    /// Index of an input.
    std::size_t input(const std::string &name) const {
        std::size_t index = 0;
        check(ancf_find_input(get(), name.c_str(), &index));
        return index;
    }

    /// Index of a column.
    std::size_t column(const std::string &name) const {
        std::size_t index = 0;
        check(ancf_find_column(get(), name.c_str(), &index));
        return index;
    }

    /// Sets an input, with a linear transition over a duration.
    void set(std::size_t input, double value, double ramp = 0) { check(ancf_set_input(get(), input, value, ramp)); }

    /// Value of a column.
    double read(std::size_t column) const {
        double value = 0;
        check(ancf_read(get(), column, &value));
        return value;
    }

    /// Performs one step.
    ancf_step_report step(double h) {
        ancf_step_report report{};
        check(ancf_step(get(), h, &report));
        return report;
    }

    /// Advances to a time in steps of the model.
    ancf_step_report advance(double until) {
        ancf_step_report report{};
        check(ancf_advance(get(), until, &report));
        return report;
    }

    /// Present time.
    double time() const {
        double time = 0;
        check(ancf_time(get(), &time));
        return time;
    }

    /// Warnings of all steps so far, one per line.
    std::string warnings() const {
        const char *warnings = nullptr;
        check(ancf_warnings(get(), &warnings));
        return warnings;
    }

    /// Snapshot of everything on which later steps depend.
    std::vector<std::uint8_t> save() const {
        std::size_t size = 0;
        std::vector<std::uint8_t> bytes;
        ancf_status status = ancf_save(get(), nullptr, 0, &size);
        if (status == ANCF_STATUS_BUFFER) {
            bytes.resize(size);
            status = ancf_save(get(), bytes.data(), bytes.size(), &size);
        }
        check(status);
        return bytes;
    }

    /// Continues from a snapshot.
    void restore(const std::vector<std::uint8_t> &bytes) { check(ancf_restore(get(), bytes.data(), bytes.size())); }

    /// Handle of the C interface.
    ancf_simulation *get() const noexcept { return simulation_.get(); }

private:
    struct Close {
        void operator()(ancf_simulation *simulation) const noexcept { ancf_close(simulation); }
    };

    explicit Simulation(ancf_simulation *simulation) : simulation_(simulation) {}

    std::unique_ptr<ancf_simulation, Close> simulation_;
};

} // namespace ancf

#endif
