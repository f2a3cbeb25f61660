#include "bench/plot/PlotFiles.h"

#include "bench/TextFile.h"
#include "bench/plot/Painter.h"
#include "bench/plot/SvgText.h"
#include "image/Png.h"

namespace aolib::bench {

namespace {

constexpr double kPngScale = 1.5; ///< pixels of the PNG per pixel of the drawing

} // namespace

std::string writePlot(const Plot& plot, const std::filesystem::path& stem) {
    const Drawing drawing = layOut(plot);
    const auto named = [&](const char* extension) {
        std::filesystem::path file = stem;
        file += extension;
        return file;
    };
    if (std::string reason = writeText(named(".svg"), svgText(drawing)); !reason.empty()) {
        return reason;
    }
    const ImageOutcome failure = writePng(named(".png"), paint(drawing, kPngScale));
    return failure ? failure->message : "";
}

} // namespace aolib::bench
