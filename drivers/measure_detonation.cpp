#include <algorithm>
#include <cmath>

#include "drivers/exact_detonation.hpp"

namespace brisance {

std::vector<MeasureDoc> Detonation::possible_measures() {
  return {
      {"detonation speed error", "-",
       "way of the front, where the cells' pressure last passes half that of Chapman and "
       "Jouguet, over the exact way, less 1"},
      {"front position", "cells", "of the same front, ahead of the exact one"},
      {"L1 fan", "-",
       "error of the cells' pressure over the exact one, from the tail of the fan to 0.98 of "
       "the front"},
      {"plateau error", "-",
       "mean pressure of the cells at 0.05 to 0.9 of the products at rest, over the exact one, "
       "less 1"},
      {"L1 plateau", "-", "error of the cells' pressure there, over the exact one"},
      {"peak error", "-", "largest pressure of a cell over that of Chapman and Jouguet, less 1"},
      {"peak of points error", "-", "the same of a particle"}};
}

std::vector<Measure> Detonation::measures(const ParticleTable& table, double t) const {
  const std::vector<Sums> cells = sums_per_layer(table, 0);
  const double front = cj_.D * t, tail = tail_speed() * t, rest = plateau();
  Profile profile;
  double fan = 0, fan_scale = 0, flat = 0, flat_error = 0, flat_count = 0, peak = 0;
  for (int k = 0; k < table.cells[0]; ++k) {
    if (cells[k].empty()) continue;
    const double x = table.layer_centre(0, k), way = x - data_.wall, p = cells[k].mean_pressure();
    profile.where.push_back(x);
    profile.value.push_back(p);
    peak = std::max(peak, p);
    const double exact = at({x, 0, 0}, t).p;
    if (way > tail && way < 0.98 * front) {
      fan += std::abs(p - exact);
      fan_scale += exact;
    } else if (way > 0.05 * tail && way < 0.9 * tail) {
      flat += p;
      flat_error += std::abs(p - rest);
      flat_count += 1;
    }
  }
  const double place = last_fall(profile, 0.5 * cj_.p, data_.wall) - data_.wall;
  double point = 0;
  for (const double p : table.pressure) point = std::max(point, p);
  return with_values(possible_measures(), {{"detonation speed error", place / front - 1},
                                           {"front position", (place - front) / table.cell_size},
                                           {"L1 fan", relative(fan, fan_scale)},
                                           {"plateau error", relative(flat, flat_count * rest) - 1},
                                           {"L1 plateau", relative(flat_error, flat_count * rest)},
                                           {"peak error", peak / cj_.p - 1},
                                           {"peak of points error", point / cj_.p - 1}});
}

}  // namespace brisance
