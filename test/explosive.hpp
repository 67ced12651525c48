#pragma once
#include <Teuchos_ParameterList.hpp>

namespace brisance::test {

/// TNT by Table 3 of Hu & Chen (2006), without its "law".
inline Teuchos::ParameterList tnt() {
  Teuchos::ParameterList list;
  list.set("density", 1630.0);
  list.set("A", 373.8e9);
  list.set("B", 3.747e9);
  list.set("R1", 4.15);
  list.set("R2", 0.9);
  list.set("omega", 0.35);
  list.set("energy density", 6e9);
  list.set("detonation speed", 6930.0);
  return list;
}

}  // namespace brisance::test
