#include "bench/environment/EnvironmentTable.h"

#include <algorithm>
#include <array>
#include <cstdio>

#include "bench/CsvLine.h"

namespace aolib::bench {

namespace {

std::string fixed(double value) {
    std::array<char, 64> text{};
    std::snprintf(text.data(), text.size(), "%.1f", value);
    return text.data();
}

std::vector<host::LitMethod> methodsOf(const std::vector<EnvironmentRow>& rows, bool drawn) {
    std::vector<host::LitMethod> methods;
    for (const EnvironmentRow& row : rows) {
        if (row.drawn == drawn &&
            std::find(methods.begin(), methods.end(), row.method) == methods.end()) {
            methods.push_back(row.method);
        }
    }
    return methods;
}

} // namespace

std::string environmentCsv(const std::vector<EnvironmentRow>& rows) {
    std::string text = "scene,environment,method,values,rmse,bias,truth_noise,frame_ms\n";
    for (const EnvironmentRow& row : rows) {
        text += CsvLine()
                    .add(row.scene)
                    .add(row.environment)
                    .add(litMethodName(row.method))
                    .add(row.drawn ? "vertices" : "pixels")
                    .add(row.rmse)
                    .add(row.bias)
                    .add(row.noise)
                    .add(row.frameMs)
                    .text();
    }
    return text;
}

std::string environmentMarkdown(const std::vector<EnvironmentRow>& rows, bool drawn) {
    const std::vector<host::LitMethod> methods = methodsOf(rows, drawn);
    std::string text = "| scene | environment |";
    std::string line = "|---|---|";
    for (const host::LitMethod method : methods) {
        text += std::string(" ") + litMethodName(method) + " |";
        line += "---|";
    }
    text += "\n" + line;
    std::string last;
    for (const EnvironmentRow& row : rows) {
        if (row.drawn != drawn) {
            continue;
        }
        const std::string start = "\n| " + row.scene + " | " + row.environment + " |";
        if (start != last) {
            text += start;
            last = start;
        }
        text += " " + fixed(100.0 * row.rmse) + "%";
        text += drawn ? ", " + fixed(row.frameMs) + " ms |" : " |";
    }
    return text + "\n";
}

} // namespace aolib::bench
