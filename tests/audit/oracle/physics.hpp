#pragma once
/// The equations of a stated scene with a dense Jacobian: M dy/dt = F(t, y). Steady potentials are rows with
/// M = 0. Values are relative to a base per field, so that a small span on a large offset keeps its digits.

#include <Eigen/Dense>
#include <vector>

#include "audit/oracle/pieces.hpp"
#include "audit/scenes/random_scene.hpp"

namespace superstep::audit {

/// Interval in which a temperature may move while a table of conductivity is taken as one straight line.
struct Corner {
  Eigen::Index entry = 0;    ///< of the state
  double low = 0, high = 0;  ///< relative to the base [K]
  std::size_t field = 0, node = 0;
};

class Physics {
 public:
  explicit Physics(const StatedScene& scene);

  [[nodiscard]] Eigen::Index size() const noexcept { return mass_.size(); }
  [[nodiscard]] const Eigen::VectorXd& mass() const noexcept { return mass_; }
  [[nodiscard]] Eigen::VectorXd initial() const;
  /// Field of an entry of the state.
  [[nodiscard]] std::size_t field_of(Eigen::Index entry) const {
    return field_of_[static_cast<std::size_t>(entry)];
  }
  [[nodiscard]] std::size_t fields() const noexcept { return parts_.size(); }

  /// The piece from t0 to t1, on which inputs are lines.
  void enter(double t0, double t1);
  /// F and, where asked for, dF/dy, `since` the piece began.
  void evaluate(double since, const Eigen::VectorXd& y, Eigen::VectorXd& f, Eigen::MatrixXd* jacobian);
  /// Solves for the steady potentials in y.
  void make_consistent(double since, Eigen::VectorXd& y);
  /// Values of a field on its nodes [K or V].
  [[nodiscard]] std::vector<double> values(std::size_t field, double since, const Eigen::VectorXd& y) const;

  /// Takes every table of conductivity on the interval that its temperature lies in.
  void choose_intervals(const Eigen::VectorXd& y);
  [[nodiscard]] std::vector<Corner> corners() const;
  /// The temperature passes the upper or the lower end of its interval.
  void pass(const Corner& corner, bool upward);

 private:
  struct Part {
    const FieldScene* stated = nullptr;
    double base = 0;
    bool varies = false;
    std::vector<Eigen::Index> entry;          ///< [nodes] -1 = known
    std::vector<Line> known;                  ///< [nodes] relative to the base
    std::vector<Line> source;                 ///< [nodes]
    std::vector<Line> convection, radiation;  ///< ambients, absolute
    std::vector<std::size_t> interval;        ///< [nodes] of a table of conductivity
    std::vector<double> u, kappa, slope;      ///< [nodes] at the evaluation
  };
  void number_entries(Part& part);
  void set_values(double since, const Eigen::VectorXd& y);
  void set_conductivity(Part& part);
  void conduct(Part& part, Eigen::VectorXd& f, Eigen::MatrixXd* jacobian);
  void exchange(Part& part, double since, Eigen::VectorXd& f, Eigen::MatrixXd* jacobian);
  void heat(const Part& electric, Part& thermal, Eigen::VectorXd& f, Eigen::MatrixXd* jacobian);
  [[nodiscard]] double temperature(std::size_t node) const;
  [[nodiscard]] Eigen::Index temperature_entry(std::size_t node) const;

  const StatedScene& scene_;
  std::vector<Part> parts_;
  std::vector<std::size_t> field_of_;
  std::ptrdiff_t thermal_ = -1;
  Eigen::VectorXd mass_;
};

}  // namespace superstep::audit
