#pragma once
// What every particle has, and the only place that knows how it lies in memory: columns sorted by
// bin, one value after the other. Kernels capture it by value and reach particles through its
// accessors.
#include <string>

#include "core/geometry.hpp"
#include "core/lattice.hpp"

namespace brisance {

/// Whether a material's stress is a pressure (a fluid without shear) or a tensor.
enum class Stress { pressure, tensor };

/// Which optional columns the scheme needs; what it does not need takes no memory.
struct ColumnNeeds {
  Stress stress = Stress::pressure;
  int history = 0;           ///< state variables of the material
  bool affine = false;       ///< APIC: the affine velocity field of each particle
  bool work = false;         ///< midpoint: specific energy received in a step
  bool half_stress = false;  ///< midpoint, solids: the stress half a step on, beside the state
  bool relaxation = false;   ///< relaxations of fluids: residuals and exchanges
  bool stress_relaxation = false;  ///< of solids: residuals of the direct stresses and a weight
  bool extent =
      false;  ///< edges of each particle, where the scheme asks for them in more than one direction
};

template <class G>
struct Particles {
  static constexpr int D = G::dim;

  int count = 0;
  Table<double> position, velocity, gradient, mass, volume, stress, history, affine, work, scratch,
      extent;
  Table<double> acting;  ///< the stress that pulls at the nodes: `stress` itself, or a column apart
  bool acts_apart = false;
  Array<std::int64_t> id;
  Array<int> first;  ///< bin b holds the particles first(b) .. first(b + 1)
  Array<int> bin;    ///< where each goes in the next sort

  Particles() = default;
  Particles(int capacity, const ColumnNeeds& needs);

  int capacity() const { return static_cast<int>(mass.extent(0)); }

  /// Room for at least `needed` particles, columns kept.
  void reserve(int needed);

  /// Calls f(name, column, carried) for each allocated column of doubles; `carried` columns hold
  /// state, the others nothing that outlives a kernel. Sorting, splitting, output, restart and
  /// migration are written over this, so that nobody lists the columns twice. `f` may replace the
  /// column.
  template <class F>
  void each_column(F&& f) {
    f("position", position, true);
    f("velocity", velocity, true);
    f("gradient", gradient, true);
    f("mass", mass, true);
    f("volume", volume, true);
    f("stress", stress, true);
    if (history.extent(1) > 0) f("history", history, true);
    if (affine.extent(1) > 0) f("affine", affine, true);
    if (extent.extent(1) > 0) f("extent", extent, true);
    if (acts_apart) f("half stress", acting, false);
    if (work.extent(1) > 0) f("work", work, false);
    if (scratch.extent(1) > 0) f("scratch", scratch, false);
  }

  template <int N>
  KOKKOS_INLINE_FUNCTION static Vec<N> load(const Table<double>& column, int p) {
    Vec<N> value;
    for (int k = 0; k < N; ++k) value[k] = column(p, k);
    return value;
  }
  template <int N>
  KOKKOS_INLINE_FUNCTION static void store(const Table<double>& column, int p,
                                           const Vec<N>& value) {
    for (int k = 0; k < N; ++k) column(p, k) = value[k];
  }

  KOKKOS_INLINE_FUNCTION Vec<D> x(int p) const { return load<D>(position, p); }
  KOKKOS_INLINE_FUNCTION Vec<D> v(int p) const { return load<D>(velocity, p); }
  KOKKOS_INLINE_FUNCTION double& m(int p) const { return mass(p, 0); }
  KOKKOS_INLINE_FUNCTION double& vol(int p) const { return volume(p, 0); }

  KOKKOS_INLINE_FUNCTION Mat<D> matrix(const Table<double>& column, int p) const {
    Mat<D> value;
    for (int k = 0; k < D * D; ++k) value.a[k] = column(p, k);
    return value;
  }
  KOKKOS_INLINE_FUNCTION void set_matrix(const Table<double>& column, int p,
                                         const Mat<D>& value) const {
    for (int k = 0; k < D * D; ++k) column(p, k) = value.a[k];
  }

  /// The stress tensor, tension positive; a pressure column gives -p I. [Pa]
  template <Stress kind>
  KOKKOS_INLINE_FUNCTION static Sym3 sigma(const Table<double>& column, int p) {
    Sym3 s;
    if constexpr (kind == Stress::pressure)
      s[0] = s[1] = s[2] = -column(p, 0);
    else
      for (int k = 0; k < G::stress_components; ++k) s[k] = column(p, k);
    return s;
  }
  template <Stress kind>
  KOKKOS_INLINE_FUNCTION static void set_sigma(const Table<double>& column, int p, const Sym3& s) {
    if constexpr (kind == Stress::pressure)
      column(p, 0) = -s[0];
    else
      for (int k = 0; k < G::stress_components; ++k) column(p, k) = s[k];
  }
  template <Stress kind>
  KOKKOS_INLINE_FUNCTION Sym3 sigma(int p) const {
    return sigma<kind>(stress, p);
  }
  template <Stress kind>
  KOKKOS_INLINE_FUNCTION void set_sigma(int p, const Sym3& s) const {
    set_sigma<kind>(stress, p, s);
  }

  /// Half the edge along d of the box that the particle fills: its extents, brought to its volume.
  /// [m]
  KOKKOS_INLINE_FUNCTION double half_size(int p, int d) const {
    if constexpr (D == 1) return 0.5 * vol(p);
    if (extent.extent(1) == 0) return 0.5 * root(vol(p));
    double box = 1;
    for (int k = 0; k < D; ++k) box *= extent(p, k);
    return 0.5 * extent(p, d) * root(vol(p) / box);
  }

  /// The same in cells, as sized shapes take it.
  KOKKOS_INLINE_FUNCTION double half_length(int p, int d, double h) const {
    return clamp(half_size(p, d) / h, 1e-6, 0.5);
  }

  /// Stretches the extents with a step's strain, if they are kept; none gets longer than four times
  /// another.
  KOKKOS_INLINE_FUNCTION void stretch(int p, const Mat<D>& gradient_, double dt) const {
    if (extent.extent(1) == 0) return;
    double longest = 0;
    for (int d = 0; d < D; ++d) {
      extent(p, d) *= most(1 + gradient_(d, d) * dt, 0.1);
      longest = most(longest, extent(p, d));
    }
    for (int d = 0; d < D; ++d) extent(p, d) = most(extent(p, d), 0.25 * longest);
  }

  KOKKOS_INLINE_FUNCTION static double root(double v) { return D == 2 ? sqrt(v) : pow(v, 1. / D); }
};

}  // namespace brisance
