#include <algorithm>
#include <cmath>

#include "drivers/exact.hpp"

namespace brisance {
namespace {

constexpr double core = 0.3;   // of the radius: where the exact pressure is flat to 0.2 % and more
constexpr double reach = 1.2;  // of the radius: beyond it nothing has happened

// The mean pressures of shells half a cell thick. The innermost one is left out: it holds too few
// particles.
Profile shells(const std::vector<Sums>& sums, double thickness) {
  Profile profile;
  for (std::size_t i = 1; i < sums.size(); ++i) {
    if (sums[i].empty()) continue;
    profile.where.push_back((static_cast<double>(i) + 0.5) * thickness);
    profile.value.push_back(sums[i].mean_pressure());
  }
  return profile;
}

double highest(const Profile& profile) {
  return profile.value.empty() ? 0 : *std::max_element(profile.value.begin(), profile.value.end());
}

// The mean of the exact pressure over the core, as a fraction of the peak.
double exact_core(const Sedov& exact, int symmetry) {
  constexpr int points = 200;
  double sum = 0, weight = 0;
  for (int i = 0; i < points; ++i) {
    const double x = core * (i + 0.5) / points, w = std::pow(x, symmetry - 1);
    sum += w * exact.profile(x).p;
    weight += w;
  }
  return sum / weight;
}

}  // namespace

std::vector<MeasureDoc> Sedov::possible_measures() {
  const std::string over =
      "error over the particles within 1.2 radii, weighted by volume, over the exact ";
  return {
      {"L1 density", "-", over + "density"},
      {"L1 velocity", "-", over + "radial velocity"},
      {"L1 pressure", "-", over + "pressure"},
      {"peak pressure", "Pa", "highest mean pressure of a shell half a cell thick"},
      {"peak pressure error", "-", "peak pressure over that just behind the exact front, less 1"},
      {"front radius", "m", "where the mean pressure falls to half its peak"},
      {"front position", "cells", "how far the front is ahead of (+) or behind (-) its place"},
      {"central pressure error", "-",
       "mean pressure by volume within 0.3 radii over the exact mean there, less 1"},
      {"asymmetry", "-",
       "front radius within 15 degrees of the axes over that within 15 degrees of the diagonals, "
       "less 1"}};
}

std::vector<MeasureDoc> Sedov::measure_docs() const {
  std::vector<MeasureDoc> docs = possible_measures();
  if (data_.symmetry != 2)
    docs.pop_back();  // a plane has no directions, a point has more than these
  return docs;
}

std::vector<Measure> Sedov::measures(const ParticleTable& table, double t) const {
  const double front = radius(t), thickness = 0.5 * table.cell_size;
  const std::size_t bins = static_cast<std::size_t>(std::ceil(2 * front / thickness));
  std::vector<Sums> all(bins), axis(bins), diagonal(bins);
  Sums middle;
  double rho_error = 0, u_error = 0, p_error = 0, rho_scale = 0, u_scale = 0, p_scale = 0;
  for (std::size_t k = 0; k < table.size(); ++k) {
    const Place x = table.place(k);
    const double r = distance(x);
    const std::size_t bin =
        static_cast<std::size_t>(std::min(r / thickness, 2 * front / thickness + 1));
    if (bin < bins) {
      all[bin].add(table, k);
      if (data_.symmetry == 2) {
        const double a = std::abs(x[0] - data_.centre[0]), b = std::abs(x[1] - data_.centre[1]);
        const double degrees = std::atan2(std::min(a, b), std::max(a, b)) * 57.29577951308232;
        if (degrees < 15) axis[bin].add(table, k);
        if (degrees >= 30) diagonal[bin].add(table, k);
      }
    }
    if (r < core * front) middle.add(table, k);
    if (r >= reach * front) continue;
    const MatterState exact = at(x, t);
    const Place v = table.motion(k);
    double u = 0, exact_u = 0;
    for (int d = 0; d < data_.symmetry && r > 0; ++d) {
      const double outward = (x[d] - data_.centre[d]) / r;
      u += v[d] * outward;
      exact_u += exact.v[d] * outward;
    }
    const double volume = table.volume[k];
    rho_error += volume * std::abs(table.density[k] - exact.rho);
    u_error += volume * std::abs(u - exact_u);
    p_error += volume * std::abs(table.pressure[k] - exact.p);
    rho_scale += volume * exact.rho;
    u_scale += volume * std::abs(exact_u);
    p_scale += volume * exact.p;
  }
  const Profile profile = shells(all, thickness);
  const double peak = highest(profile), half = 0.5 * peak;
  const double found =
      last_fall(profile, half, 0);  // a front that is nowhere has not left the centre
  const double along_axis = last_fall(shells(axis, thickness), half, 0);
  const double along_diagonal = last_fall(shells(diagonal, thickness), half, 0);
  const double exact_middle = peak_pressure(t) * exact_core(*this, data_.symmetry);
  return with_values(
      measure_docs(),
      {{"L1 density", relative(rho_error, rho_scale)},
       {"L1 velocity", relative(u_error, u_scale)},
       {"L1 pressure", relative(p_error, p_scale)},
       {"peak pressure", peak},
       {"peak pressure error", peak / peak_pressure(t) - 1},
       {"front radius", found},
       {"front position", (found - front) / table.cell_size},
       {"central pressure error", middle.empty() ? -1 : middle.mean_pressure() / exact_middle - 1},
       {"asymmetry", relative(along_axis, along_diagonal) - 1}});
}

}  // namespace brisance
