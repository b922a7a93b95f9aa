#pragma once
/// What a benchmark saw besides numbers in a table: histories at probes and a slice through the packing.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace superstep {

/// History of one method at one probe, thinned to what a chart can show.
struct ProbeCurve {
  std::string spec;                 ///< of the method
  std::string field, unit, probe;   ///< "temperature", "K", "mid-height"
  std::vector<double> time{};       ///< s, ascending
  std::vector<double> value{};      ///< in `unit`, one per time
  std::vector<double> reference{};  ///< of the reference at the same times; empty without one
  std::size_t transient = 0;        ///< leading entries that the decay of the error was fitted to
};

/// Spheres that the vertical mid-plane (normal y) cuts, with a field at several times.
struct Slice {
  struct Sphere {
    std::int64_t id = 0;
    double across = 0, height = 0;  ///< x and z of the centre [m]
    double depth = 0;               ///< y of the centre minus y of the plane [m]
    double radius = 0;              ///< m
  };
  struct Frame {
    std::string field, unit;
    double time = 0;              ///< s
    std::vector<double> value{};  ///< in `unit`, one per sphere
  };
  std::string source;   ///< SPEC whose values these are
  std::size_t cut = 0;  ///< spheres that the plane cuts; more than `spheres` when some were left out
  std::vector<Sphere> spheres{};
  std::vector<Frame> frames{};
};

/// Everything of that kind about one case.
struct CaseObservations {
  std::vector<ProbeCurve> curves;
  std::optional<Slice> slice;  ///< only for cases with a packing
};

}  // namespace superstep
