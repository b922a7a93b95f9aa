#pragma once
/// A few particles by the classical Runge-Kutta method with tiny steps, straight from the printed equations:
/// it shares no code with what it judges. Jumps are found by bisection to the last bit of time.

#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <vector>

namespace superstep::oracle {

/// Laws with their numbers, named as in the papers.
struct Laws {
  double K = 1e7, T_star = 1e300, K_lim = 0, zeta = 0, mu = 0, v_s = 1, g = 0, drag = 0;
  double kappa = 0, C = 100;
  enum { none, overlap, tension, neck } bond = none;
  double K_b = 0, E_star = 1e300, E_r = 0.05, w = 0.02, Tb_star = 1e300, Kb_lim = 0, zeta_b = 0;
  double k_ref = 0, Q = 0, T_ref = 1000, p_s = 1e300;
  bool coble = false;
  bool floor = false;  ///< a lower wall at z = 0, law as between particles
  double T_wall = 300;
  double J = 0, a = 0.5, sigma = 0.1;  ///< current of the wall; 0 = none, and nothing is held
};

struct Body {
  std::array<double, 3> x, v;
  double T, r, m;
};

/// y = all x, v, T of the bodies, then u of each pair.
class Few {
 public:
  Few(Laws laws, std::vector<Body> bodies) : laws_(laws), bodies_(std::move(bodies)) {
    const std::size_t n = bodies_.size();
    for (const auto& b : bodies_) {
      for (double x : b.x) y_.push_back(x);
      for (double v : b.v) y_.push_back(v);
      y_.push_back(b.T);
    }
    pairs_ = n * (n - 1) / 2;
    y_.resize(7 * n + pairs_, 0.0);
    bonded_.assign(pairs_, false);
    deepest_.assign(pairs_, 0.0);
    held_.assign(n, false);
    settle();
  }

  void advance(double t_end, double h) {
    double t = 0;
    while (t < t_end) {
      double step = std::min(h, t_end - t);
      if (t_end - t - step < 1e-3 * h) step = t_end - t;
      std::vector<double> next = runge_kutta(step);
      if (switches(next)) {
        double low = 0, high = step;
        for (int k = 0; k < 60; ++k) {
          const double middle = 0.5 * (low + high);
          (switches(runge_kutta(middle)) ? high : low) = middle;
        }
        step = high;
        next = runge_kutta(step);
      }
      t = t + step >= t_end * (1 - 1e-15) ? t_end : t + step;
      y_ = next;
      settle();
    }
  }

  [[nodiscard]] double position(std::size_t i, std::size_t axis) const { return y_[7 * i + axis]; }
  [[nodiscard]] double velocity(std::size_t i, std::size_t axis) const { return y_[7 * i + 3 + axis]; }
  [[nodiscard]] double temperature(std::size_t i) const { return y_[7 * i + 6]; }
  [[nodiscard]] int switched() const { return switched_; }
  [[nodiscard]] double grown(std::size_t pair) const { return y_[7 * bodies_.size() + pair]; }

 private:
  using Vector = std::vector<double>;

  [[nodiscard]] double overlap(const Vector& y, std::size_t i, std::size_t j) const {
    double d2 = 0;
    for (std::size_t a = 0; a < 3; ++a) d2 += std::pow(y[7 * j + a] - y[7 * i + a], 2);
    return 1 - std::sqrt(d2) / (bodies_[i].r + bodies_[j].r);
  }
  [[nodiscard]] double lens(std::size_t i, std::size_t j, double e) const {
    const double ri = bodies_[i].r, rj = bodies_[j].r, d = (ri + rj) * (1 - e);
    const double l = 0.5 * (d - (rj * rj - ri * ri) / d);
    return e > 0 ? M_PI * (ri * ri - l * l) : 0;
  }
  static double step_up(double t) { return t <= 0 ? 0 : t >= 1 ? 1 : 3 * t * t - 2 * t * t * t; }
  [[nodiscard]] double soft(double T) const {
    return std::max(laws_.K * (1 - T / laws_.T_star), laws_.K_lim);
  }
  [[nodiscard]] double soft_bond(double T) const {
    return std::max(laws_.K_b * (1 - T / laws_.Tb_star), laws_.Kb_lim);
  }
  [[nodiscard]] double filled(double u) const {
    return laws_.coble ? (std::cbrt(u + 1e-6) - 0.01) / (std::cbrt(1 + 1e-6) - 0.01) : u;
  }

  /// > 0 where a bond has to switch.
  [[nodiscard]] bool bond_switches(const Vector& y, std::size_t i, std::size_t j, std::size_t p) const {
    const double e = overlap(y, i, j);
    if (laws_.bond == Laws::overlap) return bonded_[p] ? e < laws_.E_star : e >= laws_.E_star;
    if (laws_.bond == Laws::tension) return bonded_[p] ? -e > laws_.E_r : e >= laws_.E_star;
    if (laws_.bond == Laws::neck)
      return bonded_[p] ? std::max(deepest_[p], e) - e > laws_.E_r : e >= laws_.E_star;
    return false;
  }
  [[nodiscard]] bool touches_floor(const Vector& y, std::size_t i) const {
    return laws_.floor && y[7 * i + 2] < bodies_[i].r;
  }
  [[nodiscard]] bool switches(const Vector& y) const {
    std::size_t p = 0;
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
      if (laws_.J > 0 && touches_floor(y, i) != held_[i]) return true;
      for (std::size_t j = i + 1; j < bodies_.size(); ++j, ++p)
        if (bond_switches(y, i, j, p)) return true;
    }
    return laws_.J > 0 && reached(y) != lit_;
  }
  void settle() {
    std::size_t p = 0;
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
      if (laws_.J > 0 && touches_floor(y_, i) != held_[i]) {
        held_[i] = !held_[i];
        ++switched_;
      }
      if (held_[i]) y_[7 * i + 6] = laws_.T_wall;
      for (std::size_t j = i + 1; j < bodies_.size(); ++j, ++p) {
        if (bond_switches(y_, i, j, p)) {
          bonded_[p] = !bonded_[p];
          deepest_[p] = 0;
          ++switched_;
        }
        if (bonded_[p]) deepest_[p] = std::max(deepest_[p], overlap(y_, i, j));
      }
    }
    const auto lit = reached(y_);
    if (laws_.J > 0 && !lit_.empty() && lit != lit_) ++switched_;
    lit_ = lit;
  }
  /// Current flows in whatever hangs together with somebody at the wall.
  [[nodiscard]] std::vector<bool> reached(const Vector& y) const {
    std::vector<bool> lit(bodies_.size(), false);
    for (std::size_t i = 0; i < bodies_.size(); ++i) lit[i] = laws_.J > 0 && touches_floor(y, i);
    for (std::size_t pass = 0; pass < bodies_.size(); ++pass)
      for (std::size_t i = 0; i < bodies_.size(); ++i)
        for (std::size_t j = 0; j < bodies_.size(); ++j)
          if (i != j && lit[i] && overlap(y, i, j) > 0) lit[j] = true;
    return lit;
  }

  void contact(const Vector& y, std::size_t i, const std::array<double, 3>& n, const std::array<double, 3>& w,
               double push, double e, double length, double mass, double keep, double pull, double c_b,
               std::array<double, 3>& force) const {
    (void)y;
    (void)i;
    double parting = 0, slip2 = 0;
    for (std::size_t a = 0; a < 3; ++a) parting += w[a] * n[a];
    std::array<double, 3> slip{};
    for (std::size_t a = 0; a < 3; ++a) {
      slip[a] = w[a] - parting * n[a];
      slip2 += slip[a] * slip[a];
    }
    const double c = e > 0 ? 2 * laws_.zeta * std::sqrt(mass * 3 * push / (e * length)) : 0;
    const double normal = -keep * std::max(push - c * parting, 0.0) + pull + c_b * parting;
    for (std::size_t a = 0; a < 3; ++a)
      force[a] = normal * n[a] + keep * laws_.mu * push * slip[a] / std::sqrt(slip2 + laws_.v_s * laws_.v_s);
  }

  [[nodiscard]] Vector rates(const Vector& y) const {
    const std::size_t n = bodies_.size();
    Vector f(y.size(), 0.0);
    std::vector<double> heat(n, 0.0);
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t a = 0; a < 3; ++a) {
        f[7 * i + a] = y[7 * i + 3 + a];
        f[7 * i + 3 + a] = -6 * M_PI * laws_.drag * bodies_[i].r * y[7 * i + 3 + a] / bodies_[i].m;
      }
      f[7 * i + 5] -= laws_.g;
      if (lit_[i] && laws_.J > 0)
        heat[i] += laws_.a * laws_.J * laws_.J * 4.0 / 3.0 * M_PI * std::pow(bodies_[i].r, 3) / laws_.sigma;
      if (!laws_.floor || !touches_floor(y, i)) continue;
      const double r = bodies_[i].r, z = y[7 * i + 2], e = (r - z) / r, area = M_PI * (r * r - z * z);
      std::array<double, 3> force{}, w{};
      for (std::size_t a = 0; a < 3; ++a) w[a] = -y[7 * i + 3 + a];
      contact(y, i, {0, 0, -1}, w, soft(0.5 * (y[7 * i + 6] + laws_.T_wall)) * e * e * area, e, r,
              bodies_[i].m, 1, 0, 0, force);
      for (std::size_t a = 0; a < 3; ++a) f[7 * i + 3 + a] += force[a] / bodies_[i].m;
      heat[i] += laws_.kappa * area / z * (laws_.T_wall - y[7 * i + 6]);
    }
    std::size_t p = 0;
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = i + 1; j < n; ++j, ++p) {
        const double e = overlap(y, i, j), sum = bodies_[i].r + bodies_[j].r, d = sum * (1 - e);
        if (e <= 0 && !bonded_[p]) continue;
        const double Ti = y[7 * i + 6], Tj = y[7 * j + 6], T = 0.5 * (Ti + Tj);
        const double m = bodies_[i].m * bodies_[j].m / (bodies_[i].m + bodies_[j].m);
        const double area = lens(i, j, e), pressure = e > 0 ? soft(T) * e * e : 0;
        double keep = 1, pull = 0, c_b = 0, conducts = area;
        if (bonded_[p] && laws_.bond == Laws::overlap) pull = soft_bond(T) * e * e * area;
        if (bonded_[p] && laws_.bond == Laws::tension) {
          conducts = lens(i, j, std::max(deepest_[p], e));
          pull = soft_bond(T) * e * e * (e > 0 ? area : conducts);
        }
        if (bonded_[p] && laws_.bond == Laws::neck) {
          const double u = y[7 * n + p], deepest = std::max(deepest_[p], e), x = deepest - e;
          const double neck_area = lens(i, j, deepest);
          const double s = filled(u) * (1 - step_up(2 * x / laws_.E_r - 1)), b = step_up(x / laws_.w);
          keep = 1 - s * b;
          pull = s * b * soft_bond(T) * neck_area * x;
          c_b = 2 * laws_.zeta_b * s * std::sqrt(m * soft_bond(T) * neck_area / sum);
          conducts = area + s * std::max(neck_area - area, 0.0);
          const double k =
              laws_.k_ref * (1 + pressure / laws_.p_s) *
              std::exp(-laws_.Q / 8.31446261815324 * (0.5 * (1 / Ti + 1 / Tj) - 1 / laws_.T_ref));
          f[7 * n + p] = k * step_up(2 * (e / laws_.E_star - 1)) * (1 - b) * (1 - u);
        }
        std::array<double, 3> normal{}, w{}, force{};
        for (std::size_t a = 0; a < 3; ++a) {
          normal[a] = (y[7 * j + a] - y[7 * i + a]) / d;
          w[a] = y[7 * j + 3 + a] - y[7 * i + 3 + a];
        }
        contact(y, i, normal, w, pressure * area, e, sum, m, keep, pull, c_b, force);
        for (std::size_t a = 0; a < 3; ++a) {
          f[7 * i + 3 + a] += force[a] / bodies_[i].m;
          f[7 * j + 3 + a] -= force[a] / bodies_[j].m;
        }
        const double flow = laws_.kappa * conducts / d * (Tj - Ti);
        heat[i] += flow;
        heat[j] -= flow;
      }
    for (std::size_t i = 0; i < n; ++i) f[7 * i + 6] = held_[i] ? 0 : heat[i] / (bodies_[i].m * laws_.C);
    return f;
  }

  [[nodiscard]] Vector runge_kutta(double h) const {
    const auto plus = [&](const Vector& f, double part) {
      Vector y = y_;
      for (std::size_t k = 0; k < y.size(); ++k) y[k] += part * h * f[k];
      return y;
    };
    const Vector a = rates(y_), b = rates(plus(a, 0.5)), c = rates(plus(b, 0.5)), d = rates(plus(c, 1));
    Vector y = y_;
    for (std::size_t k = 0; k < y.size(); ++k) y[k] += h / 6 * (a[k] + 2 * b[k] + 2 * c[k] + d[k]);
    return y;
  }

  Laws laws_;
  std::vector<Body> bodies_;
  Vector y_;
  std::size_t pairs_ = 0;
  std::vector<bool> bonded_, held_, lit_;
  std::vector<double> deepest_;
  int switched_ = 0;
};

}  // namespace superstep::oracle
