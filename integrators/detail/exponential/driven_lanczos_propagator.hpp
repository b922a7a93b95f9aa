#pragma once
/// Linear networks whose inputs follow tables of time, all their knots at once.
///
///   y(t) = y_0 + w(t),   w' = f(t_0, y_0) + sum_k (g_k(t) - g_k(t_0)) s_k - A w,   w(t_0) = 0
///
/// Where an input acts does not change with time: one Lanczos space for the rates at the start and one for
/// each shape s_k hold w for every t. In the small space of a shape an input that is a line between its knots
/// is solved exactly, at next to no cost a knot, so that a profile of thousands costs about as many sweeps
/// as a ramp. The bound of lanczos_propagator.hpp holds with the largest |g_k - g_k(t_0)| for a factor. The
/// superposition is our own.

#include "integrators/detail/exponential/instant_batch.hpp"
#include "integrators/detail/krylov/lanczos_space.hpp"
#include "integrators/detail/krylov/tridiagonal_response.hpp"

namespace superstep {

class DrivenLanczosPropagator final : public InstantBatch {
 public:
  ///   memory  that all bases together may take [bytes]
  DrivenLanczosPropagator(double rtol, double memory, double part = 1)
      : InstantBatch(rtol, part), memory_(memory) {}
  [[nodiscard]] bool takes_breakpoints() const noexcept override { return true; }

 private:
  void allocate() override;
  [[nodiscard]] bool keeps_origin() const noexcept override { return true; }
  void start_over() override { grown_ = false; }
  [[nodiscard]] Outcome propagate(std::span<Output> outputs) override;

  /// One input: what it does to f for a unit, and how it changes in time. Without a table it is constant: the
  /// rates at the start.
  struct Input {
    Input(Rhs& rhs, LanczosSpace::Storage storage, LanczosSpace::Recent& recent)
        : space(rhs, storage, recent) {}
    LanczosSpace space;
    InputShape shape;
    double inflow_rate = 0;                   ///< W or A for a unit
    LanczosSpace::Input size{};               ///< of its change since the start, up to the end of the run
    Bounds reported{};                        ///< of its error, as counted
    std::vector<TridiagonalInput> changes{};  ///< as seen from the instant that is looked at
  };
  /// The changes of an input before the time `t` [s], the last one first.
  void look_back(Input& input, double t) const;
  /// True where a line of the table is better seen as two steps.
  [[nodiscard]] bool acts_as_steps(const Input& input, double slope, double since_begin,
                                   double since_end) const;
  [[nodiscard]] Outcome grow(Input& input);
  /// How large an input gets, and how far it goes up and down in all, until the end of the run.
  [[nodiscard]] LanczosSpace::Input size_of(const Input& input) const;
  void add_responses(Input& input, std::span<Output> outputs);
  /// The largest sums of the small solution over some instants, by which roundings are multiplied.
  struct SmallSolution {
    double integral = 0;  ///< of all its entries over time [s]: each product rounds by some epsilons of rho
    double factors = 0;   ///< of unit vectors: kept vectors are rounded [K or V]
    double changed = 0;   ///< of what each change of the input adds [s]: it is rounded itself
  };
  void report(Input& input, double elapsed, const SmallSolution& largest);

  double memory_;
  LanczosSpace::Recent recent_;
  std::size_t most_vectors_ = 0;  ///< of all spaces together
  std::vector<Input> inputs_;     ///< the first one is constant
  std::size_t vectors_ = 0;
  double constant_inflow_ = 0;  ///< at the start [W or A]
  bool grown_ = false;
};

}  // namespace superstep
