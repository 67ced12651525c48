#include "drivers/output_times.hpp"

#include <Teuchos_ParameterList.hpp>

namespace brisance {
namespace {

double interval_or(const List& scene, const char* name, double standard) {
  const double given = get<double>(scene.sublist("output"), name);
  return given > 0 ? given : standard;
}

double end_of(const List& scene) { return get<double>(scene.sublist("time"), "end"); }

}  // namespace

OutputTimes::OutputTimes(const List& scene)
    : steps_(get<int>(scene.sublist("output"), "steps")),
      outputs_(interval_or(scene, "interval", end_of(scene) / 10)),
      lines_(interval_or(scene, "history interval", 2 * end_of(scene))) {}

bool OutputTimes::by_steps(const List& output) {
  return output.isParameter("steps") && get<int>(output, "steps") > 0;
}

// Both cadences go on in any case, so that a restart may change from one to the other.
OutputTimes::Due OutputTimes::due(long step, double time) {
  const bool line = lines_.due(time), by_time = outputs_.due(time);
  if (steps_ > 0 ? step % steps_ == 0 : by_time) return Due::output;
  return line ? Due::line : Due::nothing;
}

void OutputTimes::keep(Archive& archive) {
  outputs_.keep(archive, "output");
  lines_.keep(archive, "history");
}

}  // namespace brisance
