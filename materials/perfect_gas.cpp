#include "materials/perfect_gas.hpp"

#include <Teuchos_ParameterList.hpp>

#include "core/parameters.hpp"

namespace brisance {

PerfectGas::PerfectGas(const List& list) : gamma(get<double>(list, "gamma")) {}

List PerfectGas::valid_parameters() {
  List valid;
  declare_required<double>(valid, "gamma", above(1), "ratio of specific heats [-]");
  return valid;
}

}  // namespace brisance
