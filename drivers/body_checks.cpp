#include "drivers/body_checks.hpp"

#include <Teuchos_ParameterList.hpp>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <optional>

#include "drivers/exact_parameters.hpp"
#include "materials/registry.hpp"

namespace brisance {
namespace {

using Doubles = std::vector<double>;

constexpr std::array<const char*, 2> axes = {"x", "y"};
constexpr double round_off = 1e-9;  // of a length

std::string number(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.4g", value);
  return text;
}

/// The box around a shape, and how thick its matter is along each direction.
struct Extent {
  std::string form;
  Doubles low, high, thickness;  // [m]

  Extent(std::string name, const Place& centre, std::size_t dim, double radius, double thick)
      : form(std::move(name)), thickness(dim, thick) {
    for (std::size_t d = 0; d < dim; ++d) {
      low.push_back(centre[d] - radius);
      high.push_back(centre[d] + radius);
    }
  }
  Extent(std::string name, Doubles from, Doubles to)
      : form(std::move(name)), low(std::move(from)), high(std::move(to)) {
    for (std::size_t d = 0; d < low.size(); ++d) thickness.push_back(high[d] - low[d]);
  }
};

/// Nothing for what has no end.
std::optional<Extent> extent_of(const List& body, std::size_t dim) {
  if (const List* box = find_list(body, "box"))
    return Extent("box", get<Doubles>(*box, "low"), get<Doubles>(*box, "high"));
  if (const List* disc = find_list(body, "disc")) {
    const double radius = get<double>(*disc, "radius");
    return Extent("disc", place_of(*disc, "centre"), dim, radius, 2 * radius);
  }
  if (const List* ring = find_list(body, "ring")) {
    const double outer = get<double>(*ring, "outer radius");
    return Extent("ring", place_of(*ring, "centre"), dim, outer,
                  outer - get<double>(*ring, "inner radius"));
  }
  if (const List* polygon = find_list(body, "polygon")) {
    Doubles low, high;
    for (const char* axis : axes) {
      const auto x = get<Doubles>(*polygon, axis);
      low.push_back(*std::min_element(x.begin(), x.end()));
      high.push_back(*std::max_element(x.begin(), x.end()));
    }
    return Extent("polygon", low, high);
  }
  return std::nullopt;
}

std::string law_of(const List& scene, const std::string& material) {
  return get<std::string>(scene.sublist("materials").sublist(material), "law");
}

/// Along one direction. Beyond walls matter has an image, so that a half of what is symmetric is
/// given by a whole shape. What fills the grid from end to end is cut nowhere, and a face farther
/// off than the grid is long stands for one without end.
void check_ends(const List& scene, const List& shape, const Extent& extent, std::size_t d) {
  const List& grid = scene.sublist("grid");
  const double low = get<Doubles>(grid, "origin")[d],
               length = get<std::vector<int>>(grid, "cells")[d] * get<double>(grid, "cell size"),
               high = low + length, same = round_off * length;
  if (extent.high[d] <= low + same || extent.low[d] >= high - same)
    refuse(shape, "",
           "has no part within the grid, which along " + std::string(axes[d]) + " is " +
               number(low) + " to " + number(high) + " m");
  const double beyond[] = {low - extent.low[d], extent.high[d] - high};
  if (beyond[0] > -same && beyond[1] > -same) return;
  for (const int end : {0, 1}) {
    const std::string name = std::string(axes[d]) + (end == 0 ? " low" : " high"),
                      kind = get<std::string>(scene.sublist("boundaries"), name);
    if (kind != "free" && kind != "periodic") continue;
    if (beyond[end] > same && beyond[end] < length)
      refuse(shape, "",
             "reaches " + number(beyond[end]) + " m beyond the end '" + name +
                 "' of the grid, which is " + kind + ": what is there would be missing");
  }
}

}  // namespace

void check_extents(const List& scene) {
  const List& bodies = scene.sublist("bodies");
  const double h = get<double>(scene.sublist("grid"), "cell size");
  for (const auto& name : list_names(bodies)) {
    const List& body = bodies.sublist(name);
    const std::size_t dim = get<Doubles>(scene.sublist("grid"), "origin").size();
    const auto extent = extent_of(body, dim);
    if (!extent) continue;
    const List& shape = body.sublist(extent->form);
    for (std::size_t d = 0; d < dim; ++d) check_ends(scene, shape, *extent, d);
    if (is_fluid(law_of(scene, get<std::string>(body, "material")))) continue;
    const bool by_points = get<std::string>(body, "edge") == "points";
    const double apart = by_points ? h / get<int>(body, "particles per cell") : h;
    for (std::size_t d = 0; d < dim; ++d)
      if (extent->thickness[d] < apart * (1 - round_off))
        refuse(shape, "",
               "is " + number(extent->thickness[d]) + " m thin, less than " +
                   (by_points ? "its points are apart, " : "a cell, ") + number(apart) +
                   " m: it needs " + (by_points ? "more 'particles per cell' or " : "") +
                   "smaller cells");
  }
}

Overlaps::Overlaps(const List& scene, const Bodies& bodies)
    : lists_(scene.sublist("bodies")), bodies_(bodies), of_(bodies.all().size()) {
  const auto condensed = [&](const Body& body) {
    const std::string law = law_of(scene, body.material);
    return !is_fluid(law) || law == Jwl::name;
  };
  const auto names = list_names(lists_);
  const auto& all = bodies.all();
  for (std::size_t b = 0; b < all.size(); ++b)
    for (std::size_t later = b + 1; later < all.size(); ++later)
      if (all[b].material != all[later].material && condensed(all[b]) && condensed(all[later]) &&
          !get<bool>(lists_.sublist(names[later]), "may overlap"))
        of_[b].push_back({static_cast<int>(later)});
}

void Overlaps::check() const {
  const auto names = list_names(lists_);
  for (std::size_t b = 0; b < of_.size(); ++b)
    for (const Pair& pair : of_[b])
      if (pair.shared && pair.apart)
        refuse(lists_.sublist(names[pair.later]), "",
               "overlaps '" + names[b] +
                   "', which does not lie within it: draw them side by side, "
                   "or set 'may overlap' here if '" +
                   names[b] + "' is to own what both hold");
}

}  // namespace brisance
