#pragma once
// Which points of a table are near a place: square bins, so that all pairs of near points are found
// in a time that grows with their number alone.
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "drivers/measure.hpp"

namespace brisance {

/// Edge of the square of a particle's volume; its length on a line. [m]
inline double point_size(const ParticleTable& table, std::size_t k) {
  return table.dim == 1 ? table.volume[k] : std::pow(table.volume[k], 1. / table.dim);
}

class Bins {
 public:
  using Place = std::array<double, 3>;

  /// Of some rows of a table. The edge [m] is that of most searches; it is a matter of speed only.
  Bins(const ParticleTable& table, const std::vector<std::size_t>& rows, double edge);

  /// f(row, place) for all points of the bins that the box around a place touches: all that are
  /// less than `radius` away in each direction, and others. Always in the same order.
  template <class F>
  void each_near(const Place& place, double radius, const F& f) const {
    std::array<long, 3> low{}, high{};
    for (int d = 0; d < 3; ++d) {
      low[d] = index(place[d] - radius, d);
      high[d] = index(place[d] + radius, d);
    }
    for (long k = low[2]; k <= high[2]; ++k)
      for (long j = low[1]; j <= high[1]; ++j) {
        const std::size_t line = (k * count_[1] + j) * count_[0];
        for (std::size_t n = begin_[line + low[0]]; n < begin_[line + high[0] + 1]; ++n)
          f(row_[n], place_[n]);
      }
  }

 private:
  Place low_{};
  double edge_;
  std::array<long, 3> count_{{1, 1, 1}};
  std::vector<std::size_t> begin_;  ///< first point of each bin, and the end
  std::vector<std::size_t> row_;
  std::vector<Place> place_;

  long index(double x, int d) const {
    return static_cast<long>(
        clamped(std::floor((x - low_[d]) / edge_), static_cast<double>(count_[d] - 1)));
  }
  static double clamped(double a, double most) { return std::max(0., std::min(most, a)); }
};

}  // namespace brisance
