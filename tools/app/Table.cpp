#include "app/Table.h"

#include <algorithm>
#include <cstdio>
#include <utility>

namespace aolib::app {

Table::Table(std::vector<std::string> header) {
    rows_.push_back(std::move(header));
}

void Table::add(std::vector<std::string> row) {
    row.resize(rows_.front().size());
    rows_.push_back(std::move(row));
}

std::string Table::text(const std::vector<std::string>& remarks) const {
    std::vector<std::size_t> widths(rows_.front().size(), 0);
    for (const auto& row : rows_) {
        for (std::size_t column = 0; column < row.size(); ++column) {
            widths[column] = std::max(widths[column], row[column].size());
        }
    }
    std::string text;
    for (std::size_t line = 0; line < rows_.size(); ++line) {
        const auto& row = rows_[line];
        for (std::size_t column = 0; column < row.size(); ++column) {
            const std::string padding(widths[column] - row[column].size(), ' ');
            text += column == 0 ? row[column] + padding : "  " + padding + row[column];
        }
        if (line < remarks.size()) {
            text += "  " + remarks[line];
        }
        text += '\n';
    }
    return text;
}

std::string knownNumber(double value, int decimals) {
    if (!(value >= 0.0)) {
        return "-";
    }
    char text[64];
    std::snprintf(text, sizeof(text), "%.*f", decimals, value);
    return text;
}

std::string knownPercentage(double share) {
    return share >= 0.0 ? knownNumber(100.0 * share, 1) + "%" : "-";
}

std::string grouped(std::size_t count) {
    std::string digits = std::to_string(count);
    for (std::size_t at = digits.size(); at > 3; at -= 3) {
        digits.insert(at - 3, 1, ' ');
    }
    return digits;
}

} // namespace aolib::app
