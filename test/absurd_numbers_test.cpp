// A number that nobody can mean, far too large or too small, in any place of a scene: it is
// refused, or the run starts all the same.
#include <gtest/gtest.h>

#include <Teuchos_ParameterList.hpp>

#include "drivers/commands.hpp"
#include "drivers/exact.hpp"
#include "drivers/simulation.hpp"
#include "test/runs.hpp"

namespace brisance {
namespace {

/// Paths of all numbers of a list and the lists in it.
void add_numbers(const List& list, std::vector<std::string>& paths) {
  const std::string path = path_of(list);
  for (const auto& name : names(list)) {
    if (list.isSublist(name))
      add_numbers(list.sublist(name), paths);
    else if (described(list, name).type == "double")
      paths.push_back(path.empty() ? name : path + "/" + name);
  }
}

class AbsurdNumber : public testing::TestWithParam<const char*> {};

TEST_P(AbsurdNumber, IsRefusedOrDoesNoHarm) {
#ifdef BRISANCE_FPE_TRAPS
  GTEST_SKIP() << "such numbers are what traps are for";
#endif
  const std::string file = test::input(GetParam());
  const List whole = load_scene({file, {}, {}});
  std::vector<std::string> paths;
  for (const char* part : {"time", "scheme", "materials", "bodies"})
    add_numbers(whole.sublist(part), paths);
  EXPECT_GT(paths.size(), 10u);
  for (const auto& path : paths)
    for (const char* value : {"1e300", "1e30", "1e-300", "1e-30"}) {
      SCOPED_TRACE(path + "=" + value);
      try {
        const List scene = load_scene({file, {}, {path + "=" + value}});
        const List* exact_list = find_list(scene, "exact");
        const auto exact = exact_list ? make_exact(*exact_list) : nullptr;
        const auto simulation = make_simulation(scene, exact.get());
        for (int k = 0; k < 3; ++k) simulation->advance(1e300);
      } catch (const InputError&) {
      } catch (const std::exception& error) {
        ADD_FAILURE() << error.what();
      }
    }
}

INSTANTIATE_TEST_SUITE_P(Scenes, AbsurdNumber,
                         testing::Values("sod", "detonation_1d", "plastic_wave", "concrete_impact"),
                         [](const auto& p) { return std::string(p.param); });

}  // namespace
}  // namespace brisance
