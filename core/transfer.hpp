#pragma once
// The transfer seam: how particles and nodes exchange mass, momentum, force and velocity. It knows
// geometry, shape, transfer scheme and whether stress is a number or a tensor; it does not know the
// material. Each function adds a stage to a sweep, which the step runs.
#include <memory>
#include <string>

#include "core/grid.hpp"
#include "core/particles.hpp"
#include "core/schedule.hpp"

namespace brisance {

/// The choices of a transfer, by the names that the input uses.
struct TransferChoice {
  std::string shape = "linear";         ///< linear, GIMP, quadratic, cubic
  std::string scheme = "FLIP";          ///< FLIP, APIC, MLS
  std::string quadrature = "particle";  ///< particle, cell
};

/// The rule that a choice breaks, or nothing.
std::string broken_rule(const TransferChoice& choice);

template <class G>
class Transfer {
 public:
  static constexpr int D = G::dim;

  virtual ~Transfer() = default;
  /// Whether the shape depends on the extents of particles.
  virtual bool sized() const = 0;
  virtual bool affine() const = 0;
  virtual bool cell_quadrature() const = 0;
  /// The weight of a node at the next one. [-]
  virtual double beside() const = 0;
  /// sum over nodes of N r r, the second moment that carries affine kinetic energy. [m^2]
  virtual double affine_inertia(double h) const = 0;

  /// points.bin <- the bin of each particle: the first node that its shape touches; lattice.size
  /// when it has left. As a stage, for those that lie in bins already; or at once, for all.
  virtual void find_bins(Sweep<D>&, const Particles<G>&) const = 0;
  virtual void find_bins(const Lattice<D>&, const Particles<G>&) const = 0;

  /// sums <- momentum (columns 0 .. D-1) and mass (column D). (A.1, A.2)
  virtual void scatter_momentum(Sweep<D>&, const Particles<G>&, const Accumulator&) const = 0;

  /// sums <- internal force. (A.3, minus sign restored)
  virtual void scatter_force(Sweep<D>&, const Particles<G>&, const Grid<G>&, Stress,
                             const Accumulator&) const = 0;

  /// Particle gradients <- gradient of a nodal velocity. (A.13)
  virtual void gather_gradient(Sweep<D>&, const Particles<G>&,
                               const Table<double>& velocity) const = 0;

  /// sums(column) <- volume of the particles in each cell; or spread over the cells that their
  /// shapes overlap.
  virtual void scatter_volume(Sweep<D>&, const Particles<G>&, int column,
                              const Accumulator&) const = 0;
  virtual void scatter_overlap(Sweep<D>&, const Particles<G>&, int column,
                               const Accumulator&) const = 0;

  /// Particle velocity from the nodes, positions unmoved: FLIP with blend. (A.6, A.8)
  virtual void accelerate(Sweep<D>&, const Particles<G>&, const Grid<G>&, int velocity_class,
                          double flip) const = 0;

  /// Gradient of `velocity`, then the move with grid.after. (A.7, A.9, A.13)
  virtual void gradient_and_move(Sweep<D>&, const Particles<G>&, const Grid<G>&,
                                 const Table<double>& velocity, double dt) const = 0;

  /// The end of a midpoint step: velocity, affine field, move, mid-step gradient, and the specific
  /// energy that work and transfer give to each particle, so that total energy is kept to
  /// round-off.
  virtual void finish_midpoint(Sweep<D>&, const Particles<G>&, const Grid<G>&, Stress,
                               int velocity_class, double flip, double dt) const = 0;

  /// sums <- N w v (column) and N w (column + 1), for nodal means of a value v with weight w; or
  /// of two (columns 0 .. 3).
  virtual void scatter_mean(Sweep<D>&, const Particles<G>&, const Weighted&, int column,
                            const Accumulator&) const = 0;
  virtual void scatter_two_means(Sweep<D>&, const Particles<G>&, const Weighted&, const Weighted&,
                                 const Accumulator&) const = 0;

  /// sums <- N w v for three values v (columns 0 .. 2) and N w (column 3), from columns 0 .. 3 of a
  /// table; and values <- values - sum over nodes of N field.
  virtual void scatter_means(Sweep<D>&, const Particles<G>&, const Table<double>& values,
                             const Accumulator&) const = 0;
  virtual void subtract_means(Sweep<D>&, const Particles<G>&, const Table<double>& field,
                              const Table<double>& values) const = 0;

  virtual void gather_scalar(Sweep<D>&, const Particles<G>&, const Gathering&) const = 0;
  virtual void gather_two_scalars(Sweep<D>&, const Particles<G>&, const Gathering&,
                                  const Gathering&) const = 0;
};

template <class G>
std::unique_ptr<Transfer<G>> make_transfer(const TransferChoice& choice);

}  // namespace brisance
