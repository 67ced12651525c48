#include <Teuchos_ParameterList.hpp>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>

#include "drivers/files.hpp"
#include "drivers/fragments.hpp"

namespace brisance {
namespace {

std::array<double*, 15> numbers_of(Fragment& f) {
  return {&f.mass,        &f.volume,      &f.centre[0],   &f.centre[1], &f.centre[2],
          &f.velocity[0], &f.velocity[1], &f.velocity[2], &f.spin,      &f.translation,
          &f.rotation,    &f.rest,        &f.size,        &f.length,    &f.width};
}

void keep_sums(Archive& archive, const std::string& name, MotionSums& sums) {
  const Archive::Part part(archive, name);
  archive.keep("points", sums.points);
  archive.keep("mass", sums.mass);
  archive.keep("kinetic", sums.kinetic);
  for (const char axis : {'x', 'y', 'z'})
    archive.keep(std::string("momentum ") + axis, sums.momentum[axis - 'x']);
}

}  // namespace

FragmentWatch::FragmentWatch(const List& list, const WatchedMaterials& materials)
    : material_(materials.number(get<std::string>(list, "material"))),
      reach_(get<double>(list, "reach")),
      least_mass_(get<double>(list, "least mass")),
      at_(get<double>(list, "at")),
      dust_(get<bool>(list, "dust")) {
  if (materials.fluid[material_]) refuse(list, "material", "must be a solid");
}

List FragmentWatch::valid_parameters(const std::vector<std::string>& materials) {
  List valid;
  declare_required<std::string>(valid, "material", one_of(materials), "what has broken [-]");
  // Between 1.4, what is left of neighbours when a lattice is stretched by 40 % at constant volume,
  // and 2, points of unstrained matter with one of them missing.
  declare(valid, "reach", 1.7, at_least(1) && at_most(10),
          "points belong together within this times the mean of their sizes [-]");
  declare(valid, "least mass", 0.0, at_least_zero(),
          "of a piece that counts, per metre or square metre [kg]");
  declare(valid, "at", 0.0, at_least_zero(),
          "time of which the measures tell, by the first output there; 0: the end [s]");
  declare(valid, "dust", true, anything(),
          "points that have lost all strength belong to no piece [-]");
  return valid;
}

std::vector<MeasureDoc> FragmentWatch::measure_docs() {
  return {
      {"fragments", "-", "number of pieces that count, by the least mass"},
      {"largest fragment", "kg", "mass of the heaviest piece, per metre or square metre"},
      {"dust mass", "kg", "of points that have lost all strength"},
      {"fastest fragment", "m/s", "greatest speed of the centres of the pieces that count"},
      {"slowest fragment", "m/s", "least of these speeds"},
      {"mean fragment speed", "m/s", "of these speeds, by mass"},
      {"fragment slenderness", "-", "length over width of the pieces that count, mean by mass"},
      {"fragment mass error", "-", "of pieces and dust, over the mass of the material"},
      {"fragment momentum error", "-", "the same, over sqrt(2 mass energy)"},
      {"fragment energy error", "-", "of translation, rotation and rest, over the kinetic energy"}};
}

void FragmentWatch::observe(const ParticleTable& table, double time) {
  Fragments now = find_fragments(table, material_, reach_, dust_);
  int number = 0;
  for (const Fragment& f : now.pieces) {
    if (f.mass < least_mass_) break;
    char row[512];
    std::snprintf(row, sizeof row,
                  "%.9g,%d,%ld,%.9g,%.9g,%.9g,%.9g,%.9g,%.9g,%.9g,%.9g,%.9g,%.9g,%.9g,%.9g\n", time,
                  ++number, f.points, f.mass, f.centre[0], f.centre[1], f.velocity[0],
                  f.velocity[1], f.spin, f.translation, f.rotation, f.rest, f.size, f.length,
                  f.width);
    rows_ += row;
  }
  if (settled_) return;
  found_ = std::move(now);
  settled_ = at_ > 0 && time >= at_;
}

std::vector<Measure> FragmentWatch::measures() const {
  double count = 0, mass = 0, speed = 0, slenderness = 0;
  double fastest = std::nan(""), slowest = std::nan("");
  for (const Fragment& f : found_.pieces) {
    if (f.mass < least_mass_) break;
    ++count;
    mass += f.mass;
    speed += f.mass * f.speed();
    slenderness += f.mass * f.slenderness();
    fastest = std::fmax(fastest, f.speed());
    slowest = std::fmin(slowest, f.speed());
  }
  return with_values(measure_docs(),
                     {{"fragments", count},
                      {"largest fragment", found_.pieces.empty() ? 0 : found_.pieces.front().mass},
                      {"dust mass", found_.dust.mass},
                      {"fastest fragment", fastest},
                      {"slowest fragment", slowest},
                      {"mean fragment speed", count > 0 ? speed / mass : std::nan("")},
                      {"fragment slenderness", count > 0 ? slenderness / mass : std::nan("")},
                      {"fragment mass error", found_.mass_error()},
                      {"fragment momentum error", found_.momentum_error()},
                      {"fragment energy error", found_.energy_error()}});
}

void FragmentWatch::keep(Archive& archive) {
  const Archive::Part part(archive, "fragments");
  archive.keep("rows", rows_);
  archive.keep("settled", settled_);
  if (!settled_) return;  // what was found is found anew at the end
  Archive::Integers points;
  Archive::Doubles numbers;
  for (Fragment& f : found_.pieces) {
    points.push_back(f.points);
    for (const double* number : numbers_of(f)) numbers.push_back(*number);
  }
  archive.keep("points", points);
  archive.keep("numbers", numbers);
  found_.pieces.resize(points.size());
  std::size_t next = 0;
  for (std::size_t k = 0; k < points.size(); ++k) {
    found_.pieces[k].points = points[k];
    for (double* number : numbers_of(found_.pieces[k])) *number = numbers.at(next++);
  }
  keep_sums(archive, "dust", found_.dust);
  keep_sums(archive, "all", found_.all);
}

void FragmentWatch::write(const std::filesystem::path& folder, Backlog* later) const {
  write_file(folder / "fragments.csv",
             "time,piece,points,mass,x,y,velocity_x,velocity_y,spin,translation,rotation,rest,"
             "size,length,width\n" +
                 rows_,
             later);
}

}  // namespace brisance
