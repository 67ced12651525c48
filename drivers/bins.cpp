#include "drivers/bins.hpp"

namespace brisance {

Bins::Bins(const ParticleTable& table, const std::vector<std::size_t>& rows, double edge)
    : edge_(edge), row_(rows.size()), place_(rows.size()) {
  Place high{};
  for (std::size_t n = 0; n < rows.size(); ++n) {
    const Place x = table.place(rows[n]);
    for (int d = 0; d < 3; ++d) {
      low_[d] = n == 0 ? x[d] : std::min(low_[d], x[d]);
      high[d] = n == 0 ? x[d] : std::max(high[d], x[d]);
    }
  }
  // Points scattered over a wide space: wider bins, no more of them than a few for each point.
  const auto bins_along = [&](int d) { return std::floor((high[d] - low_[d]) / edge_) + 1; };
  while (bins_along(0) * bins_along(1) * bins_along(2) > 4. * static_cast<double>(rows.size()) + 64)
    edge_ *= 2;
  for (int d = 0; d < 3; ++d) count_[d] = static_cast<long>(bins_along(d));

  const auto bin_of = [&](const Place& x) {
    return static_cast<std::size_t>((index(x[2], 2) * count_[1] + index(x[1], 1)) * count_[0] +
                                    index(x[0], 0));
  };
  begin_.assign(count_[0] * count_[1] * count_[2] + 1, 0);
  for (const std::size_t row : rows) ++begin_[bin_of(table.place(row)) + 1];
  for (std::size_t b = 1; b < begin_.size(); ++b) begin_[b] += begin_[b - 1];
  std::vector<std::size_t> next(begin_.begin(), begin_.end() - 1);
  for (const std::size_t row : rows) {
    const Place x = table.place(row);
    const std::size_t n = next[bin_of(x)]++;
    row_[n] = row;
    place_[n] = x;
  }
}

}  // namespace brisance
