#include "core/transfer_impl.hpp"

namespace brisance {
template std::unique_ptr<Transfer<Line>> make_transfer<Line>(const TransferChoice&);
}
