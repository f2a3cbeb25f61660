#pragma once

#include <concepts>
#include <string>
#include <string_view>

namespace aolib::bench {

/// One line of comma-separated values (RFC 4180): texts are quoted where they must be.
class CsvLine {
public:
    CsvLine& add(std::string_view text);
    CsvLine& add(double value);
    template <std::integral Integer>
    CsvLine& add(Integer value) {
        return add(std::string_view(std::to_string(value)));
    }
    /// Empty where the value is negative: the sign of "not known".
    CsvLine& addKnown(double value);

    /// The line with its line feed.
    std::string text() const { return text_ + "\n"; }

private:
    std::string text_;
    bool empty_ = true;
};

} // namespace aolib::bench
