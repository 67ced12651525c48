#include "drivers/burst.hpp"

#include <Teuchos_ParameterList.hpp>
#include <algorithm>
#include <cmath>

#include "drivers/exact_parameters.hpp"

namespace brisance {
namespace {

// Within so many cells bodies share nodes and feel each other.
constexpr double felt = 2;

}  // namespace

BurstWatch::BurstWatch(const List& list, const WatchedMaterials& materials)
    : fluid_(materials.fluid),
      case_(materials.number(get<std::string>(list, "case"))),
      wall_(materials.number(get<std::string>(list, "wall"))),
      products_(materials.number(get<std::string>(list, "products"))),
      centre_(place_of(list, "centre")),
      inner_(get<double>(list, "inner face")),
      symmetric_until_(get<double>(list, "symmetric until")),
      docs_(measure_docs(list)),
      velocity_(std::nan("")),
      velocity_time_(std::nan("")),
      case_arrival_(std::nan("")),
      products_arrival_(std::nan("")) {
  if (fluid_[wall_]) refuse(list, "wall", "must be a solid");
  if (case_ >= 0 && fluid_[case_]) refuse(list, "case", "must be a solid");
  if (case_ == wall_) refuse(list, "case", "must be another material than 'wall'");
  if (products_ >= 0 && !fluid_[products_]) refuse(list, "products", "must be a fluid");
}

List BurstWatch::valid_parameters(const std::vector<std::string>& materials, int dim) {
  std::vector<std::string> or_none = materials;
  or_none.insert(or_none.begin(), "none");
  List valid;
  declare(valid, "centre", std::vector<double>(dim, 0.0), anything() && entries(dim),
          "of charge and box; a corner of the grid where that holds a quarter [m]");
  declare_required<std::string>(valid, "wall", one_of(materials), "what the box is made of [-]");
  declare(valid, "case", "none", one_of(or_none), "what the charge is wrapped in [-]");
  declare(valid, "products", "none", one_of(or_none), "what the charge becomes [-]");
  declare_required<double>(valid, "inner face", positive(),
                           "distance of the wall's inner face from the centre, along x [m]");
  declare(valid, "symmetric until", 0.0, at_least_zero(),
          "last output at which the asymmetry is measured; 0: the end [s]");
  return valid;
}

std::vector<MeasureDoc> BurstWatch::measure_docs(const List& given) {
  const auto has = [&](const std::string& name) {
    const auto all = names(given);
    return std::find(all.begin(), all.end(), name) != all.end() &&
           get<std::string>(given, name) != "none";
  };
  std::vector<MeasureDoc> docs;
  if (has("case")) {
    docs.push_back({"case velocity", "m/s",
                    "radial velocity of the case, mean by mass, greatest of all outputs"});
    docs.push_back({"case velocity time", "s", "output at which that was"});
    docs.push_back({"fragments reach wall", "s",
                    "first output with a point of the case within two cells of one of the wall"});
  }
  if (has("products"))
    docs.push_back({"products reach wall", "s",
                    "first output with a point of the products within two cells of one of the wall"});
  docs.insert(docs.end(),
              {{"four-fold asymmetry", "-",
                "difference of mass and of radial momentum from their images under the symmetries "
                "of the square, over their sum, greatest of the outputs asked for"},
               {"interpenetration", "-",
                "share of the fluids' mass that lies within solids, deeper than 0.4 spacings of "
                "their points, greatest of all outputs"},
               {"greatest overlap", "-",
                "1 - distance over half the sum of sizes of a point of fluid (no larger than the "
                "solid's) and one of a solid, greatest of all outputs"},
               {"damage near the middle", "-",
                "share of the wall's failure, 1 - (1 - damage)(1 - decohesion), that lies within a "
                "quarter of a face of the middle of a face"},
               {"damaged share", "-", "of the wall's mass with a failure above 0.1"},
               {"damage spread", "-",
                "inverse participation ratio of failure along the faces: 1 where they fail alike "
                "everywhere, 1 over the number of parts where one part does"},
               {"damaged length", "-",
                "share of the length of the faces along which some point has a failure above 0.1"}});
  return docs;
}

void BurstWatch::observe(const ParticleTable& table, double time) {
  if (case_ >= 0) {
    const double velocity = outward_velocity(table, case_, centre_);
    if (std::isnan(velocity_) || velocity > velocity_) {
      velocity_ = velocity;
      velocity_time_ = time;
    }
  }
  const auto arrive = [&](int material, double& arrival) {
    if (material >= 0 && std::isnan(arrival) && within(table, material, wall_, felt * table.cell_size))
      arrival = time;
  };
  arrive(case_, case_arrival_);
  arrive(products_, products_arrival_);
  // Outputs come at the first step at or past their time.
  if (symmetric_until_ == 0 || time <= symmetric_until_)
    asymmetry_ = std::max(asymmetry_, four_fold_asymmetry(table, centre_));
  const Overlap now = overlap_of(table, fluid_);
  overlap_.share = std::max(overlap_.share, now.share);
  overlap_.greatest = std::max(overlap_.greatest, now.greatest);
  damage_ = wall_damage(table, wall_, centre_, inner_);
}

std::vector<Measure> BurstWatch::measures() const {
  return with_values(docs_, {{"case velocity", velocity_},
                             {"case velocity time", velocity_time_},
                             {"fragments reach wall", case_arrival_},
                             {"products reach wall", products_arrival_},
                             {"four-fold asymmetry", asymmetry_},
                             {"interpenetration", overlap_.share},
                             {"greatest overlap", overlap_.greatest},
                             {"damage near the middle", damage_.near_middle},
                             {"damaged share", damage_.share},
                             {"damage spread", damage_.spread},
                             {"damaged length", damage_.length}});
}

}  // namespace brisance
