#include "drivers/oscillation.hpp"

#include <algorithm>
#include <cmath>

namespace brisance {

void Oscillation::add(double time, double velocity) {
  if (samples_.empty()) {
    samples_.push_back({time, velocity, 0});
    return;
  }
  const Sample last = samples_.back();
  const double way = 0.5 * (last.velocity + velocity) * (time - last.time),
               place = last.displacement + way;
  if (last.displacement <= 0 && place > 0)
    passages_.push_back(
        {samples_.size() - 1, last.time - last.displacement / way * (time - last.time)});
  samples_.push_back({time, velocity, place});
  least_ = std::min(least_, place);
  greatest_ = std::max(greatest_, place);
}

void Oscillation::keep(Archive& archive) {
  Archive::Doubles samples, times;
  Archive::Integers before;
  for (const Sample& s : samples_)
    samples.insert(samples.end(), {s.time, s.velocity, s.displacement});
  for (const Passage& p : passages_) {
    before.push_back(static_cast<std::int64_t>(p.before));
    times.push_back(p.time);
  }
  archive.keep("samples", samples);
  archive.keep("samples before passages", before);
  archive.keep("times of passages", times);
  archive.keep("least", least_);
  archive.keep("greatest", greatest_);
  samples_.clear();
  for (std::size_t k = 0; k + 2 < samples.size(); k += 3)
    samples_.push_back({samples[k], samples[k + 1], samples[k + 2]});
  passages_.clear();
  for (std::size_t k = 0; k < before.size(); ++k)
    passages_.push_back({static_cast<std::size_t>(before[k]), times.at(k)});
}

double Oscillation::period() const {
  if (periods() == 0) return std::nan("");
  const double n = static_cast<double>(passages_.size()), middle = 0.5 * (n - 1);
  double sum = 0, norm = 0;
  for (std::size_t k = 0; k < passages_.size(); ++k) {
    const double from_middle = static_cast<double>(k) - middle;
    sum += from_middle * passages_[k].time;
    norm += from_middle * from_middle;
  }
  return sum / norm;
}

double Oscillation::velocity_drift() const {
  if (window() == 0) return std::nan("");
  const double first = means(0, window()).velocity_squared,
               last = means(periods() - window(), periods()).velocity_squared;
  return std::sqrt(last / first) - 1;
}

double Oscillation::place_drift() const {
  if (window() == 0) return std::nan("");
  const double first = means(0, window()).displacement,
               last = means(periods() - window(), periods()).displacement;
  return (last - first) / amplitude();
}

/// From one passage to another, by the trapezoid rule over the samples between.
Oscillation::Means Oscillation::means(std::size_t from, std::size_t to) const {
  const std::size_t begin = passages_[from].before, end = passages_[to].before;
  Means sum;
  for (std::size_t k = begin; k < end; ++k) {
    const Sample &a = samples_[k], &b = samples_[k + 1];
    const double half = 0.5 * (b.time - a.time);
    sum.velocity_squared += half * (a.velocity * a.velocity + b.velocity * b.velocity);
    sum.displacement += half * (a.displacement + b.displacement);
  }
  const double length = samples_[end].time - samples_[begin].time;
  return {sum.velocity_squared / length, sum.displacement / length};
}

}  // namespace brisance
