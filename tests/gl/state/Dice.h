#pragma once

#include <array>
#include <cstddef>
#include <initializer_list>
#include <random>

namespace aolib {

/// Decides whether a piece of state takes its normal value or an unusual one. Seeded; a share of
/// the pieces departs, drawn once per seed, so that states come one by one as well as all at once.
/// A calm one always says the normal value.
class Dice {
public:
    static Dice calm() { return Dice(0, 0.0); }
    explicit Dice(unsigned seed) : Dice(seed, kShares[seed % kShares.size()]) {}

    bool chance(double share) { return std::bernoulli_distribution(share)(engine_); }
    bool unusual() { return share_ > 0.0 && chance(share_); }
    bool flag(bool normal) { return unusual() ? !normal : normal; }
    template <typename T>
    T pick(T normal, std::initializer_list<T> others) {
        return unusual() ? others.begin()[below(others.size())] : normal;
    }
    int integer(int normal, int least, int most) {
        return unusual() ? between(least, most) : normal;
    }
    float real(float normal, float least, float most) {
        return unusual() ? std::uniform_real_distribution<float>(least, most)(engine_) : normal;
    }

    /// Any of least ... most, also when calm.
    int between(int least, int most) {
        return std::uniform_int_distribution<int>(least, most)(engine_);
    }
    std::size_t below(std::size_t count) {
        return std::uniform_int_distribution<std::size_t>(0, count - 1)(engine_);
    }

private:
    static constexpr std::array<double, 4> kShares{0.02, 0.1, 0.5, 1.0};
    Dice(unsigned seed, double share) : engine_(seed), share_(share) {}

    std::mt19937 engine_;
    double share_;
};

} // namespace aolib
