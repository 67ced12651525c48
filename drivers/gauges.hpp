#pragma once
// Pressure gauges: what matter around a place is like against time. Switched on by the scene's list
// "gauges".
#include <string>
#include <vector>

#include "core/parameters.hpp"
#include "drivers/cadence.hpp"
#include "drivers/simulation.hpp"
#include "drivers/watch.hpp"

namespace brisance {

class Gauges final : public Watch {
 public:
  /// Of a complete scene that has the list. Throws InputError for what does not fit the rest of it.
  explicit Gauges(const List& scene);

  /// The schema, from what was given (may be null).
  static List valid_parameters(const List* given, const std::vector<std::string>& materials,
                               int dim);
  static std::vector<MeasureDoc> measure_docs(const std::vector<std::string>& gauges);

  bool looks_at_particles() const override { return false; }
  /// Moves gauges that ride, and samples when that is due.
  void follow(Simulation& simulation) override;
  /// The record so far.
  void keep(Archive& archive) override;
  void write(const std::filesystem::path& folder, Backlog* later) const override;

  /// The samples as a table, one line for each time: time, then for each gauge NAME the columns
  /// x_NAME (y_NAME), pressure_NAME, overpressure_NAME, impulse_NAME, positive_impulse_NAME,
  /// velocity_x_NAME (velocity_y_NAME), points_NAME. [SI]
  const std::string& table() const { return table_; }
  /// In the order of measure_docs().
  std::vector<Measure> measures() const override;

 private:
  /// One gauge and its record.
  struct Gauge {
    std::string name;
    double reference = 0;  ///< from which overpressure counts [Pa]
    bool reference_given = false;
    double arrival = 0;                     ///< overpressure that counts as arrival; 0: see there
    double impulse = 0, positive = 0;       ///< so far [Pa s]
    std::vector<double> overpressure = {};  ///< at the times of samples [Pa]

    void add(const Seen& seen, double since);
    double threshold() const;
    double arrival_time(const std::vector<double>& times) const;
    std::size_t peak() const;  ///< number of the sample
  };

  int dim_;
  double end_;
  Cadence cadence_;
  bool any_rides_ = false;
  std::vector<Window> windows_;
  std::vector<Gauge> gauges_;
  std::vector<double> times_;
  std::string table_;

  void sample(const Simulation& simulation);
};

}  // namespace brisance
