#include "core/springs.hpp"

#include "core/geometry.hpp"
#include "core/sum.hpp"

namespace brisance {
namespace {

/// The solution of a x = b for a symmetric positive definite matrix, which is used up.
std::vector<double> solved(std::vector<std::vector<double>> a, std::vector<double> b) {
  const std::size_t n = b.size();
  for (std::size_t k = 0; k < n; ++k)
    for (std::size_t i = k + 1; i < n; ++i) {
      const double factor = a[i][k] / a[k][k];
      for (std::size_t j = k; j < n; ++j) a[i][j] -= factor * a[k][j];
      b[i] -= factor * b[k];
    }
  for (std::size_t k = n; k-- > 0;) {
    for (std::size_t j = k + 1; j < n; ++j) b[k] -= a[k][j] * b[j];
    b[k] /= a[k][k];
  }
  return b;
}

}  // namespace

template <class G>
double Springs<G>::energy() const {
  double sum = 0;
  for (const Spring& s : springs_) sum += 0.5 * s.stiffness * square(s.displacement);
  return sum;
}

template <class G>
std::vector<double> Springs<G>::displacements() const {
  std::vector<double> all;
  for (const Spring& s : springs_) all.push_back(s.displacement);
  return all;
}

template <class G>
void Springs<G>::set_displacements(const std::vector<double>& displacements) {
  for (std::size_t k = 0; k < springs_.size(); ++k) springs_[k].displacement = displacements.at(k);
}

template <class G>
void Springs<G>::weigh(const std::vector<std::unique_ptr<Group<G>>>& groups, const Grid<G>& grid,
                       Accumulator& sums) {
  for (Spring& s : springs_) {
    const Group<G>& group = *groups[s.group];
    const Entry mass{group.particles.mass, 0};
    Sweep<D> sweep(grid.lattice);
    sweep.clear(sums, 2);
    group.transfer->scatter_mean(sweep, group.particles, {mass, mass}, 0, sums);
    sweep.run();
    sums.contribute();
    if (s.weight.extent(0) == 0) s.weight = Table<double>("mass on spring", grid.lattice.size, D);
    const auto total = sums.total, weight = s.weight;
    const int direction = s.direction;
    s.mass = sum_in_order(
        "mass on spring", grid.lattice.size, KOKKOS_LAMBDA(const int n) {
          for (int d = 0; d < D; ++d) weight(n, d) = d == direction ? total(n, 1) : 0;
          return total(n, 1);
        });
    fold(weight, D, D, grid.lattice, grid.boundaries);
    constrain(weight, grid.lattice, grid.boundaries);
  }
}

/// How far the centre of mass moves in the step under the other forces. [m]
template <class G>
double Springs<G>::free_advance(const Spring& s, const Grid<G>& grid, const Table<double>& force,
                                double dt) const {
  const auto before = grid.before, weight = s.weight;
  const int d = s.direction;
  const double momentum = sum_in_order(
      "advance of spring", grid.lattice.size, KOKKOS_LAMBDA(const int n) {
        const double m = before(n, D);
        return m > 0 ? weight(n, d) * (before(n, d) + 0.5 * dt * force(n, d) / m) : 0;
      });
  return momentum * dt / s.mass;
}

/// How much further for each newton of another spring, or its own. [m/N]
template <class G>
double Springs<G>::compliance(const Spring& s, const Spring& t, const Grid<G>& grid,
                              double dt) const {
  if (s.direction != t.direction) return 0;
  const auto before = grid.before, weight = s.weight, other = t.weight;
  const int d = s.direction;
  const double of_both = sum_in_order(
      "compliance of springs", grid.lattice.size, KOKKOS_LAMBDA(const int n) {
        const double m = before(n, D);
        return m > 0 ? weight(n, d) * other(n, d) / m : 0;
      });
  return 0.5 * dt * dt * of_both / (s.mass * t.mass);
}

// Displacements depend on the forces linearly, u1 = u0 + a + b f, and f = -K (u0 + u1) / 2.
template <class G>
auto Springs<G>::pull(const Grid<G>& grid, const Table<double>& force, double dt) -> Vec<D> {
  std::vector<Spring*> loaded;  // whose points have not all left
  for (Spring& s : springs_)
    if (s.mass > 0) loaded.push_back(&s);
  const std::size_t count = loaded.size();
  std::vector<double> a(count), right(count);
  std::vector<std::vector<double>> b(count, std::vector<double>(count)), matrix;
  for (std::size_t i = 0; i < count; ++i) {
    a[i] = free_advance(*loaded[i], grid, force, dt);
    right[i] = -loaded[i]->displacement - 0.5 * a[i];
    for (std::size_t j = 0; j <= i; ++j)
      b[i][j] = b[j][i] = compliance(*loaded[i], *loaded[j], grid, dt);
  }
  matrix = b;
  for (std::size_t i = 0; i < count; ++i) {
    for (double& entry : matrix[i]) entry *= 0.5;
    matrix[i][i] += 1 / loaded[i]->stiffness;
  }
  const std::vector<double> forces = solved(matrix, right);

  Vec<D> given;
  for (std::size_t i = 0; i < count; ++i) {
    Spring& s = *loaded[i];
    s.displacement += a[i];
    for (std::size_t j = 0; j < count; ++j) s.displacement += b[i][j] * forces[j];
    const auto weight = s.weight;
    const int d = s.direction;
    const double per_mass = forces[i] / s.mass;
    given[d] -= dt * sum_in_order(
                         "pull of spring", grid.lattice.size, KOKKOS_LAMBDA(const int n) {
                           force(n, d) += per_mass * weight(n, d);
                           return per_mass * weight(n, d);
                         });
  }
  return given;
}

template class Springs<Line>;
template class Springs<PlaneStrain>;

}  // namespace brisance
