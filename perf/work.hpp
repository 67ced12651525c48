#pragma once
#include <string>

namespace brisance::perf {

/// What a step has to do for a particle, whatever the program: counted by hand, see work.cpp.
struct Work {
  double flops = 0;  ///< operations on doubles
  double bytes = 0;  ///< of main memory, read and written
};

/// Of a perfect gas, 4 particles a cell, in plane strain. The shape is that of the preset, or
/// quadratic with `paper`.
Work gas_work(const std::string& preset, bool quadratic);
/// The same of von Mises steel that yields, with linear shapes and FLIP, or quadratic ones and MLS.
Work steel_work(bool quadratic);

}  // namespace brisance::perf
