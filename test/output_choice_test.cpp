// What a run writes is what its scene names, as precise and as often, and no more than it allows.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Teuchos_Array.hpp>
#include <Teuchos_ParameterList.hpp>
#include <algorithm>
#include <cmath>

#include "drivers/commands.hpp"
#include "drivers/exact.hpp"
#include "drivers/output_choice.hpp"
#include "drivers/output_times.hpp"
#include "drivers/scene.hpp"
#include "drivers/simulation.hpp"
#include "drivers/vtk_read.hpp"
#include "test/program.hpp"
#include "test/runs.hpp"
#include "test/state.hpp"

namespace brisance {
namespace {

namespace fs = std::filesystem;
using test::Folder;
using test::run_into;
using testing::ElementsAre;
using testing::HasSubstr;
using Names = std::vector<std::string>;

/// Sod's tube on 50 cells; it ends at 0.2.
List tube(const Names& assignments) {
  Names all = {"grid/cells={50}", "grid/cell size=0.02"};
  all.insert(all.end(), assignments.begin(), assignments.end());
  return load_scene({test::input("sod"), {}, all});
}

Names names_of(const std::vector<vtk::ReadColumn>& columns) {
  Names names;
  for (const auto& column : columns) names.push_back(column.name);
  return names;
}

std::string refused(const std::function<void()>& work) {
  try {
    work();
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

long files_in(const fs::path& folder, const std::string& kind) {
  return std::count_if(fs::directory_iterator(folder), fs::directory_iterator(),
                       [&](const auto& entry) { return entry.path().extension() == kind; });
}

TEST(OutputColumns, AreThoseNamed) {
  const Folder folder("columns");
  run_into(folder.path, tube({"output/columns={density, velocity, id}"}));
  EXPECT_THAT(names_of(vtk::read_vtp(folder.path / "particles_000003.vtp")),
              ElementsAre("points", "velocity", "density", "id"));
  EXPECT_THAT(names_of(vtk::read_vtp(folder.path / "grid_000003.vti")),
              ElementsAre("density", "velocity"));
}

TEST(OutputColumns, ThatThereAreNotAreToldWithThoseThatThereAre) {
  const std::string told = refused([] { tube({"output/columns={density, presure}"}); });
  EXPECT_THAT(told,
              HasSubstr("list 'output', parameter 'columns' = {density, presure}: every entry "
                        "must be one of: velocity, mass, volume, density, pressure, energy, "
                        "material, id, fill; did you mean 'pressure'?"));
  EXPECT_EQ(told.find('\n'), told.npos);
}

void expect_named(const List& scene) {
  const List* exact_list = find_list(scene, "exact");
  const auto exact = exact_list ? make_exact(*exact_list) : nullptr;
  const auto simulation = make_simulation(scene, exact.get());
  const List valid = OutputChoice::valid_parameters(scene.sublist("materials"), dimension(scene));
  for (const auto& field : simulation->snapshot().table.fields) {
    List given;
    given.set("columns", Teuchos::Array<std::string>(1, field.name));
    EXPECT_EQ(refused([&] { check(given, valid); }), "") << scene.name() << " " << field.name;
  }
}

TEST(OutputColumns, OfEveryLawCanBeNamed) {
  for (const char* name : {"bomb_quarter", "elastic_bar", "piston_container", "concrete_impact"})
    expect_named(load_scene({test::input(name), {}, {}}));
  expect_named(test::scene(1, {"materials/gas/viscosity/shear=0.001"}));
}

TEST(OutputPrecision, SingleIsTheNearestNumberInHalfTheBytes) {
  const Folder whole("double"), rounded("single");
  run_into(whole.path, tube({}));
  run_into(rounded.path, tube({"output/precision=single"}));
  for (const char* name : {"particles_000010.vtp", "grid_000010.vti"}) {
    const auto a = vtk::read_vtp(whole.path / name), b = vtk::read_vtp(rounded.path / name);
    ASSERT_EQ(names_of(a), names_of(b));
    for (std::size_t c = 0; c < a.size(); ++c)
      for (std::size_t k = 0; k < a[c].values.size(); ++k)
        ASSERT_EQ(b[c].values[k], static_cast<double>(static_cast<float>(a[c].values[k])))
            << a[c].name;
  }
}

TEST(OutputBySteps, ComesEverySoManyAndAtTheEnd) {
  const Folder folder("by_steps");
  const RunResult result = run_into(folder.path, tube({"output/steps=20"}));
  EXPECT_EQ(files_in(folder.path, ".vtp"), 1 + (result.end.step + 19) / 20);
  EXPECT_THAT(
      refused([] {
        tube({"output/steps=20", "output/interval=0.1"});
      }),
      HasSubstr("list 'output', parameter 'steps' = 20: must be 0 where 'interval' is given"));
}

// By time again at 0.55, with multiples of 0.1: the next is due at 0.6.
TEST(OutputBySteps, MayBecomeOutputByTimeWhenARunGoesOn) {
  OutputTimes by_steps(test::scene(1, {"time/end=1", "output/steps=4"}));
  for (int step = 1; step <= 11; ++step)
    EXPECT_EQ(by_steps.due(step, 0.05 * step) == OutputTimes::Due::output, step % 4 == 0);
  Archive written;
  by_steps.keep(written);
  Archive read(written.entries());
  OutputTimes by_time(test::scene(1, {"time/end=1"}));
  by_time.keep(read);
  EXPECT_EQ(by_time.due(12, 0.58), OutputTimes::Due::nothing);
  EXPECT_EQ(by_time.due(13, 0.6), OutputTimes::Due::output);
}

// Heads of files are not counted: they name the columns, in some kilobytes.
TEST(OutputSize, IsThatOfTheFiles) {
  for (const Names& choice :
       {Names{}, Names{"output/precision=single"},
        Names{"output/columns={velocity, material, fill}"},
        Names{"output/grid=false", "output/interval=0.03"}, Names{"output/particles=false"}}) {
    const Folder folder("size");
    const List scene = tube(choice);
    const auto exact = make_exact(scene.sublist("exact"));
    const OutputSize size = output_size(scene, *make_simulation(scene, exact.get()));
    run_into(folder.path, scene);
    double particles = 0, grid = 0;
    if (fs::exists(folder.path / "particles_000000.vtp"))
      particles = static_cast<double>(fs::file_size(folder.path / "particles_000000.vtp"));
    if (fs::exists(folder.path / "grid_000000.vti"))
      grid = static_cast<double>(fs::file_size(folder.path / "grid_000000.vti"));
    EXPECT_NEAR(particles, size.particle_file, size.particle_file > 0 ? 4000 : 0);
    EXPECT_NEAR(grid, size.grid_file, size.grid_file > 0 ? 2000 : 0);
    EXPECT_GE(particles, size.particle_file);
    EXPECT_GE(grid, size.grid_file);
    const long files = std::max(files_in(folder.path, ".vtp"), files_in(folder.path, ".vti"));
    EXPECT_EQ(files, size.times);
  }
}

TEST(OutputSize, AboveTheLimitIsRefusedBeforeAnythingIsWritten) {
  const Folder folder("limit");
  const fs::path out = folder.path / "out";
  const List scene = tube({"output/largest size=1e-4"});
  const std::string told = refused([&] { run_into(out, scene); });
  EXPECT_THAT(told,
              HasSubstr("list 'output', parameter 'largest size' = 1e-04: the run would write "
                        "more, about 11 times "));
  EXPECT_EQ(told.find('\n'), told.npos);
  EXPECT_FALSE(fs::exists(out));
  RunOptions nowhere;
  nowhere.quiet = true;
  EXPECT_EQ(run(scene, nowhere).outcome.status, "finished");
}

// Outputs come at most once a step.
TEST(OutputSize, CountsNoMoreOutputsThanSteps) {
  const OutputChoice choice(tube({"output/interval=1e-6"}));
  EXPECT_EQ(choice.size(1, 1, 30, 0).times, 31);
  EXPECT_EQ(OutputChoice(tube({"output/steps=7"})).size(1, 1, 30, 0).times, 6);
}

}  // namespace
}  // namespace brisance
