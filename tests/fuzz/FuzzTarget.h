#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>

/// What libFuzzer calls, and RunCorpus.cpp for every file of a corpus. Anything but a return is a
/// finding.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace aolib::fuzz {

/// Ends the program where something does not hold that must.
inline void require(bool holds, const char* what) {
    if (!holds) {
        std::fprintf(stderr, "does not hold: %s\n", what);
        std::abort();
    }
}

/// Values from a fuzzer's bytes; zeros behind their end.
class Bytes {
public:
    Bytes(const std::uint8_t* data, std::size_t size) : data_(data), size_(size) {}

    bool empty() const { return size_ == 0; }
    template <typename T>
    T take() {
        T value{};
        auto* to = reinterpret_cast<std::uint8_t*>(&value);
        for (std::size_t i = 0; i < sizeof(T) && size_ > 0; ++i, --size_) {
            to[i] = *data_++;
        }
        return value;
    }

private:
    const std::uint8_t* data_;
    std::size_t size_;
};

} // namespace aolib::fuzz
