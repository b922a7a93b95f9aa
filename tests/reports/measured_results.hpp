#pragma once
/// Results of two methods on one case, as a noisy machine would measure them.

#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "reports/gate/results_file.hpp"

namespace superstep::test {

/// Timings of a noisy machine: every round slower or faster as a whole, every run by itself, and now and then
/// one that was interrupted.
class Machine {
 public:
  Machine(unsigned seed, double noise) : random_(seed), noise_(noise) {}

  /// `rounds` timings of pieces of work that take `seconds` each.
  std::vector<std::vector<double>> measure(const std::vector<double>& seconds, int rounds) {
    std::vector<std::vector<double>> out(seconds.size());
    for (int round = 0; round < rounds; ++round) {
      const double weather = std::exp(0.2 * normal_(random_));
      for (std::size_t k = 0; k < seconds.size(); ++k) {
        const double hiccup = uniform_(random_) < 0.05 ? 1.5 : 1;
        out[k].push_back(seconds[k] * weather * hiccup * std::exp(noise_ * normal_(random_)));
      }
    }
    return out;
  }

 private:
  std::mt19937_64 random_;
  std::normal_distribution<double> normal_;
  std::uniform_real_distribution<double> uniform_;
  double noise_;
};

struct Build {
  double sweep = 1;         ///< cost of a sweep
  double rkc = 1;           ///< cost of the method besides
  double extra_sweeps = 0;  ///< per step
  double error = 1;         ///< times what it was
  int rounds = 21;
  double noise = 0.01;
};

inline MeasuredRow row_of(const std::string& spec, double steps, double rhs, double error) {
  MeasuredRow row;
  row.spec = spec;
  row.integrator = spec.substr(0, spec.find(':'));
  row.status = "ok";
  row.numbers = {{"steps", steps},          {"rejected", 0},   {"rhs", rhs},         {"jacobians", 0},
                 {"factorizations", 0},     {"solves", 0},     {"error_rms", error}, {"error_max", 3 * error},
                 {"reference_error", 1e-7}, {"balance", 1e-14}};
  return row;
}

inline ResultsFile measured(const Build& build, unsigned seed) {
  auto euler = row_of("forward-euler", 1000, 1000 * (1 + build.extra_sweeps), 1e-3 * build.error);
  auto rkc = row_of("rkc:rtol=1e-4", 70, 1400 + 70 * build.extra_sweeps, 2e-3 * build.error);
  const auto times =
      Machine(seed, build.noise)
          .measure({1.0 * build.sweep, 0.01, 0.1 * build.sweep * build.rkc, 0.01}, build.rounds);
  euler.cpu_stepping = times[0];
  euler.yardstick = times[1];
  rkc.cpu_stepping = times[2];
  rkc.yardstick = times[3];
  ResultsFile file;
  file.path = "synthetic";
  file.processor = "a processor";
  file.flags = "-O3";
  file.cases = {{"rod", "forward-euler", {euler, rkc}}};
  return file;
}

}  // namespace superstep::test
