#include "audit/oracle/radau.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace superstep::audit {
namespace {

constexpr int points = 5;
constexpr double work_of_a_trial = 2e5;  // besides the cube of the unknowns
constexpr double most_work = 5e10;       // about a minute

const RadauTable& table() {
  static const RadauTable instance(points);
  return instance;
}

class Stepper {
 public:
  Stepper(const StatedScene& scene, double tolerance, const std::vector<double>& scale)
      : scene_(scene), physics_(scene), tolerance_(tolerance), given_scale_(scale), n_(physics_.size()) {
    run_.values.resize(physics_.fields());
    run_.low.assign(physics_.fields(), std::numeric_limits<double>::infinity());
    run_.high.assign(physics_.fields(), -std::numeric_limits<double>::infinity());
    z_.setZero(n_, points);
  }

  RadauRun run() {
    y_ = physics_.initial();
    physics_.choose_intervals(y_);
    const auto times = knots(scene_, corner_times(scene_));
    for (std::size_t k = 0; k + 1 < times.size(); ++k)
      run_piece(times[k], times[k + 1], k + 2 == times.size());
    return std::move(run_);
  }

 private:
  void run_piece(double t0, double t1, bool last) {
    physics_.enter(t0, t1);
    physics_.make_consistent(0, y_);
    const double length = t1 - t0;
    since_ = 0;
    can_extrapolate_ = false;
    see(0, y_);
    h_ = h_ > 0 ? std::min(length, 0.3 * h_) : 1e-3 * length;
    while (since_ < length) {
      const bool output_due =
          output_ < scene_.output_times.size() && (last || scene_.output_times[output_] < t1);
      const double stop = output_due ? std::min(length, scene_.output_times[output_] - t0) : length;
      if (stop > since_) step_towards(stop, t1);
      if (!output_due || since_ < stop) continue;
      for (std::size_t f = 0; f < physics_.fields(); ++f)
        run_.values[f].push_back(physics_.values(f, since_, y_));
      ++output_;
    }
  }

  /// One accepted step that does not pass `stop`.
  void step_towards(double stop, double t1) {
    update_scale();
    physics_.evaluate(since_, y_, f0_, &jacobian_);
    bool shrunk = false;
    for (;;) {
      work_ += work_of_a_trial + std::pow(static_cast<double>(n_), 3);
      if (work_ > most_work)
        throw std::runtime_error("the oracle does not get on: a law's corner is passed again and again");
      if (!(h_ > 1e-15 * t1)) throw std::runtime_error("the oracle's step fell below rounding");
      const double room = stop - since_;
      const bool lands = h_ >= 0.9999 * room;
      const double h = lands ? room : h_ > 0.5 * room ? 0.5 * room : h_;
      if (!solve_stages(h)) {
        h_ = 0.25 * h;
        shrunk = true;
        continue;
      }
      const double error = estimate(h, shrunk || !can_extrapolate_);
      const double factor = std::clamp(0.9 * std::pow(std::max(error, 1e-12), -1.0 / (points + 1)), 0.1, 6.0);
      if (error > 1) {
        h_ = std::min(factor, 0.9) * h;
        shrunk = true;
        continue;
      }
      double crossing = 1;
      if (corner_within(h, crossing)) {
        if (crossing * h > 1e-15 * t1) {
          h_ = crossing * h;
          shrunk = true;
          continue;
        }
        return;  // on a corner already: the interval has changed, take the step anew
      }
      accept(h, lands ? stop : since_ + h);
      h_ = std::max(lands ? h_ : 0.0, (shrunk ? std::min(1.0, factor) : factor) * h);
      return;
    }
  }

  void accept(double h, double reached) {
    for (int k = 0; k < points; ++k) see(since_ + table().c(k) * h, y_ + z_.col(k));
    y_ += z_.col(points - 1);
    since_ = reached;
    last_h_ = h;
    last_z_ = z_;
    can_extrapolate_ = true;
    ++run_.steps;
  }

  /// Newton's method on the stages, with the Jacobian at the step's start, down to rounding. False: diverges.
  bool solve_stages(double h) {
    const auto& radau = table();
    factorize(h);
    guess_stages(h);
    // A coarse run needs no more digits than it is asked for.
    const double rounding =
        std::numeric_limits<double>::epsilon() * y_.cwiseAbs().cwiseQuotient(scale_).maxCoeff();
    const double enough = std::max({1e-14, 1e-5 * tolerance_, 4 * rounding});
    double before = 0;
    for (int iteration = 0; iteration < 15; ++iteration) {
      Eigen::MatrixXd residual = -(z_ * radau.inverse.transpose());
      for (int k = 0; k < points; ++k) {
        physics_.evaluate(since_ + radau.c(k) * h, y_ + z_.col(k), stage_f_, nullptr);
        residual.col(k) = h * stage_f_ + physics_.mass().cwiseProduct(residual.col(k));
      }
      const Eigen::MatrixXcd transformed = residual * radau.vectors_inverse.transpose();
      Eigen::MatrixXd change =
          (real_.solve(transformed.col(0).real()) * radau.vectors.col(0).real().transpose());
      for (int pair = 0; pair < points / 2; ++pair) {
        const Eigen::VectorXcd w =
            complex_[static_cast<std::size_t>(pair)].solve(transformed.col(1 + 2 * pair));
        change += 2 * (w * radau.vectors.col(1 + 2 * pair).transpose()).real();
      }
      z_ += change;
      const double size = change.cwiseAbs().cwiseQuotient(scale_.replicate(1, points)).maxCoeff();
      if (!std::isfinite(size)) return false;
      if (size <= enough) return true;
      if (iteration > 0) {
        const double rate = size / before;
        if (rate < 1 && rate / (1 - rate) * size <= enough) return true;
        if (rate > 0.3 && size < std::max(1e-11, 30 * rounding)) return true;  // stands still at rounding
        if (rate > 1.5) return false;
      }
      before = size;
    }
    return false;
  }

  void factorize(double h) {
    const auto& radau = table();
    Eigen::MatrixXd matrix = -h * jacobian_;
    matrix.diagonal() += radau.lambda(0).real() * physics_.mass();
    real_.compute(matrix);
    complex_.resize(points / 2);
    for (int pair = 0; pair < points / 2; ++pair) {
      Eigen::MatrixXcd shifted = (-h * jacobian_).cast<std::complex<double>>();
      shifted.diagonal() += radau.lambda(1 + 2 * pair) * physics_.mass().cast<std::complex<double>>();
      complex_[static_cast<std::size_t>(pair)].compute(shifted);
    }
  }

  /// The last step's polynomial, continued; zero where there is none or it would be continued too far.
  void guess_stages(double h) {
    z_.setZero();
    if (!can_extrapolate_ || h > 2 * last_h_) return;
    for (int k = 0; k < points; ++k)
      z_.col(k) = polynomial(1 + table().c(k) * h / last_h_, last_z_) - last_z_.col(points - 1);
  }

  /// Collocation polynomial through 0 at 0 and the stages, at a fraction of the step.
  [[nodiscard]] static Eigen::VectorXd polynomial(double x, const Eigen::MatrixXd& z) {
    const auto& c = table().c;
    Eigen::VectorXd value = Eigen::VectorXd::Zero(z.rows());
    for (int k = 0; k < points; ++k) {
      double weight = x / c(k);
      for (int j = 0; j < points; ++j)
        if (j != k) weight *= (x - c(j)) / (c(k) - c(j));
      value += weight * z.col(k);
    }
    return value;
  }

  /// Largest component of the error estimate over its tolerance; filtered twice where the start is rough.
  double estimate(double h, bool rough) {
    const auto& radau = table();
    const double first = radau.lambda(0).real();
    const Eigen::VectorXd stages = first * physics_.mass().cwiseProduct(z_ * radau.error);
    const auto weigh = [&](const Eigen::VectorXd& e) {
      return e.cwiseAbs().cwiseQuotient(scale_).maxCoeff() / tolerance_;
    };
    Eigen::VectorXd e = real_.solve(h * f0_ + stages);
    if (weigh(e) <= 1 || !rough) return weigh(e);
    physics_.evaluate(since_, y_ + e, stage_f_, nullptr);
    e = real_.solve(h * stage_f_ + stages);
    return weigh(e);
  }

  /// True when a temperature leaves its interval of a table of conductivity within the step; `crossing` is
  /// the first fraction at which one does. A temperature that stands at the end of its interval passes it.
  bool corner_within(double h, double& crossing) {
    bool found = false;
    for (const auto& corner : physics_.corners()) {
      const auto offset = [&](double x) { return y_(corner.entry) + value_at(x, corner.entry); };
      const double slack = 1e-13 * scale_(corner.entry) + 1e-15 * std::abs(y_(corner.entry));
      for (int k = 0; k < points; ++k) {
        const double value = y_(corner.entry) + z_(corner.entry, k);
        const bool above = value > corner.high + slack;
        if (!above && !(value < corner.low - slack)) continue;
        const double border = above ? corner.high : corner.low;
        if (std::abs(y_(corner.entry) - border) <= 2 * slack) {
          physics_.pass(corner, above);
          crossing = 0;
          return true;
        }
        double a = 0, b = table().c(k);
        for (int halving = 0; halving < 60; ++halving) {
          const double middle = 0.5 * (a + b);
          ((above ? offset(middle) > border : offset(middle) < border) ? b : a) = middle;
        }
        crossing = std::min(crossing, b);
        found = true;
        break;
      }
    }
    (void)h;
    return found;
  }

  [[nodiscard]] double value_at(double x, Eigen::Index entry) const {
    return polynomial(x, z_.row(entry))(0);
  }

  void see(double since, const Eigen::VectorXd& y) {
    for (std::size_t f = 0; f < physics_.fields(); ++f)
      for (const double value : physics_.values(f, since, y)) {
        run_.low[f] = std::min(run_.low[f], value);
        run_.high[f] = std::max(run_.high[f], value);
      }
  }

  void update_scale() {
    if (!given_scale_.empty() && scale_.size() == n_) return;
    scale_.resize(n_);
    for (Eigen::Index k = 0; k < n_; ++k) {
      const auto f = physics_.field_of(k);
      const double seen = given_scale_.empty() ? run_.high[f] - run_.low[f] : given_scale_[f];
      // A field in which nothing has moved yet: any change counts, and the first step is small.
      const double size = std::max(std::abs(run_.high[f]), std::abs(run_.low[f]));
      const double roundings = 100 * std::numeric_limits<double>::epsilon() * size;
      // A field that rests at zero has no size yet: some small number lets the first step pass.
      constexpr double at_rest_at_zero = 1e-9;
      const double least = seen > 0 || size > 0 ? 1e-300 : at_rest_at_zero;
      scale_(k) = std::max({seen, 1e-9 * size, roundings / tolerance_, least});
    }
  }

  const StatedScene& scene_;
  Physics physics_;
  double tolerance_;
  std::vector<double> given_scale_;
  Eigen::Index n_;
  double work_ = 0;  // so far, see most_work
  RadauRun run_;
  std::size_t output_ = 0;
  double since_ = 0, h_ = 0, last_h_ = 0;
  bool can_extrapolate_ = false;
  Eigen::VectorXd y_, f0_, stage_f_, scale_;
  Eigen::MatrixXd jacobian_, z_, last_z_;
  Eigen::PartialPivLU<Eigen::MatrixXd> real_;
  std::vector<Eigen::PartialPivLU<Eigen::MatrixXcd>> complex_;
};

}  // namespace

RadauRun integrate_by_radau(const StatedScene& scene, double tolerance, const std::vector<double>& scale) {
  return Stepper(scene, tolerance, scale).run();
}

}  // namespace superstep::audit
