#include "drivers/watch.hpp"

#include <Teuchos_ParameterList.hpp>
#include <algorithm>

#include "drivers/burst.hpp"
#include "drivers/cracks.hpp"
#include "drivers/fragments.hpp"
#include "drivers/gauges.hpp"
#include "materials/registry.hpp"

namespace brisance {

int WatchedMaterials::number(const std::string& name) const {
  const auto at = std::find(names.begin(), names.end(), name);
  return at == names.end() ? -1 : static_cast<int>(at - names.begin());
}

void declare_watches(List& valid, const List& given, const std::vector<std::string>& materials,
                     int dim) {
  declare_optional_list(valid, "fragments", "the pieces into which a solid has broken") =
      FragmentWatch::valid_parameters(materials);
  declare_optional_list(valid, "burst", "measures a charge that bursts in the middle of a box") =
      BurstWatch::valid_parameters(materials, dim);
  declare_optional_list(valid, "cracks", "measures what a hit does to concrete") =
      CrackPattern::valid_parameters(dim);
  declare_optional_list(valid, "gauges", "what matter is like at some places against time") =
      Gauges::valid_parameters(find_list(given, "gauges"), materials, dim);
}

std::vector<MeasureDoc> watch_docs(const List& given) {
  std::vector<MeasureDoc> docs;
  const auto append = [&](const std::vector<MeasureDoc>& more) {
    docs.insert(docs.end(), more.begin(), more.end());
  };
  if (find_list(given, "fragments")) append(FragmentWatch::measure_docs());
  if (const List* burst = find_list(given, "burst")) append(BurstWatch::measure_docs(*burst));
  if (find_list(given, "cracks")) append(CrackPattern::measure_docs());
  if (const List* gauges = find_list(given, "gauges"))
    append(Gauges::measure_docs(list_names(*gauges)));
  return docs;
}

std::vector<std::unique_ptr<Watch>> make_watches(const List& scene) {
  WatchedMaterials materials;
  const List& given = scene.sublist("materials");
  for (const auto& name : list_names(given)) {
    materials.names.push_back(name);
    materials.fluid.push_back(is_fluid(get<std::string>(given.sublist(name), "law")));
  }
  std::vector<std::unique_ptr<Watch>> watches;
  if (const List* list = find_list(scene, "fragments"))
    watches.push_back(std::make_unique<FragmentWatch>(*list, materials));
  if (const List* list = find_list(scene, "burst")) {
    if (get<std::string>(scene, "geometry") == "line") refuse(*list, "", "needs a plane");
    watches.push_back(std::make_unique<BurstWatch>(*list, materials));
  }
  if (const List* list = find_list(scene, "cracks"))
    watches.push_back(std::make_unique<CrackPattern>(*list));
  if (find_list(scene, "gauges")) watches.push_back(std::make_unique<Gauges>(scene));
  return watches;
}

}  // namespace brisance
