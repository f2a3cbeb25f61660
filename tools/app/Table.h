#pragma once

#include <string>
#include <vector>

namespace aolib::app {

inline constexpr double kMegabyte = 1e6;

/// Text in aligned columns: the first to the left, the others, which hold numbers, to the right.
class Table {
public:
    explicit Table(std::vector<std::string> header);

    /// Adds a row with as many cells as the header has.
    void add(std::vector<std::string> row);
    /// One line per row, each ended by a newline.
    /// @param remarks  appended to the lines, to the left and as long as they are; the header
    /// first.
    std::string text(const std::vector<std::string>& remarks = {}) const;

private:
    std::vector<std::vector<std::string>> rows_; ///< the header first
};

/// A number with so many decimals, "-" when it is negative: the sign of "not known" in our tables.
std::string knownNumber(double value, int decimals);
/// "12.3%", "-" when negative.
std::string knownPercentage(double share);
/// Digits in groups of three: "563 968".
std::string grouped(std::size_t count);

} // namespace aolib::app
