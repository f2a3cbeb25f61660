#include "bench/CsvLine.h"

#include <cstdio>

namespace aolib::bench {

CsvLine& CsvLine::add(std::string_view text) {
    text_ += empty_ ? "" : ",";
    empty_ = false;
    if (text.find_first_of(",\"\r\n") == std::string_view::npos) {
        text_ += text;
        return *this;
    }
    text_ += '"';
    for (const char c : text) {
        text_ += c == '"' ? "\"\"" : std::string(1, c);
    }
    text_ += '"';
    return *this;
}

CsvLine& CsvLine::add(double value) {
    char text[40];
    std::snprintf(text, sizeof(text), "%.6g", value);
    return add(std::string_view(text));
}

CsvLine& CsvLine::addKnown(double value) {
    return value >= 0.0 ? add(value) : add(std::string_view());
}

} // namespace aolib::bench
