#include "core/transfer_impl.hpp"

namespace brisance {
template std::unique_ptr<Transfer<PlaneStrain>> make_transfer<PlaneStrain>(const TransferChoice&);
}
