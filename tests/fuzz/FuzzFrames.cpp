// The calls of a host in any order, with frames of any view: each succeeds or says why not, what a
// frame computed lies in [0, 1], a view at rest comes to an end, and GL has nothing to complain of.
#include "FuzzHost.h"

namespace {

constexpr int kMostCalls = 24;

} // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    aolib::fuzz::Bytes bytes(data, size);
    aolib::fuzz::FuzzHost host(bytes);
    for (int calls = 0; calls < kMostCalls && !bytes.empty(); ++calls) {
        host.call();
    }
    return 0;
}
