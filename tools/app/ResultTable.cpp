#include "app/ResultTable.h"

#include <cmath>

namespace aolib::app {

ResultTable::ResultTable()
    : table_({"scene", "triangles", "cube maps", "build ms", "AO ms/frame computing",
              "AO ms/frame converged", "host ms/frame", "coverage", "MB kept", "MB building",
              "RMSE", "bias", "truth noise"}) {}

void ResultTable::add(const std::string& scene, std::size_t triangles, const RenderResult& result,
                      const std::optional<ErrorAgainstTruth>& error) {
    std::string bias = "-";
    if (error) {
        bias = knownNumber(std::abs(error->metrics.bias), 4);
        bias = (error->metrics.bias < 0.0 ? "-" : "+") + bias;
    }
    table_.add({scene, grouped(triangles), std::to_string(result.cubeMaps),
                knownNumber(result.buildMs, 0), knownNumber(result.computingMs, 1),
                knownNumber(result.aoMs, 1), knownNumber(result.hostMs, 1),
                knownPercentage(result.coverage),
                knownNumber(static_cast<double>(result.bytesKept) / kMegabyte, 1),
                knownNumber(static_cast<double>(result.bytesCapture) / kMegabyte, 1),
                error ? knownNumber(error->metrics.rmse, 4) : "-", bias,
                error ? knownNumber(error->truthNoise, 4) : "-"});
}

} // namespace aolib::app
