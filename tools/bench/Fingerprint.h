#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <type_traits>

namespace aolib::bench {

/// A 64 bit hash of data that goes by (FNV-1a): tells apart what a cache may hold. Not for defence.
class Fingerprint {
public:
    template <typename T>
    void add(std::span<const T> values) {
        static_assert(std::is_trivially_copyable_v<T>);
        const auto bytes = std::as_bytes(values);
        for (const std::byte byte : bytes) {
            value_ = (value_ ^ std::to_integer<std::uint64_t>(byte)) * kPrime;
        }
    }
    void add(std::string_view text) { add(std::span<const char>(text)); }

    std::uint64_t value() const { return value_; }

private:
    static constexpr std::uint64_t kPrime = 0x100000001b3ULL;
    std::uint64_t value_ = 0xcbf29ce484222325ULL;
};

} // namespace aolib::bench
