#pragma once
// A velocity recorded in every step of a run, and what there is of an oscillation in it.
#include <cstddef>
#include <vector>

#include "drivers/archive.hpp"

namespace brisance {

class Oscillation {
 public:
  /// At ascending times [s]; between them the velocity [m/s] is taken as linear.
  void add(double time, double velocity);
  /// The whole record, for restart.
  void keep(Archive& archive);

  /// Whole periods, from one passage of the first place in the first direction to the next.
  std::size_t periods() const { return passages_.empty() ? 0 : passages_.size() - 1; }
  /// Slope of the line that fits the times of the passages best; not a number without two of
  /// them. [s]
  double period() const;
  /// Half the way between the two turning points that are furthest apart. [m]
  double amplitude() const { return 0.5 * (greatest_ - least_); }
  /// Of the root mean square of the velocity, from the first five periods to the last five, over
  /// the former (fewer: halves). [-]
  double velocity_drift() const;
  /// Of the mean displacement, the same, over the amplitude. [-]
  double place_drift() const;

 private:
  struct Sample {
    double time, velocity, displacement;
  };
  struct Means {
    double velocity_squared = 0, displacement = 0;
  };
  std::vector<Sample> samples_;
  struct Passage {
    std::size_t before;  ///< the sample
    double time;
  };
  std::vector<Passage> passages_;
  double least_ = 0, greatest_ = 0;

  std::size_t window() const { return periods() / 2 < 5 ? periods() / 2 : 5; }
  Means means(std::size_t from, std::size_t to) const;
};

}  // namespace brisance
