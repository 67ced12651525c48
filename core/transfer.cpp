#include "core/transfer.hpp"

namespace brisance {

std::string broken_rule(const TransferChoice& c) {
  const bool spline = c.shape == "quadratic" || c.shape == "cubic";
  if (c.quadrature == "cell" && c.shape != "linear")
    return "quadrature 'cell' needs the shape 'linear'";
  if (c.scheme != "FLIP" && !spline)
    return "transfer '" + c.scheme +
           "' needs the shape 'quadratic' or 'cubic' (others lose momentum or energy)";
  return {};
}

}  // namespace brisance
