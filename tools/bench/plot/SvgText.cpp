#include "bench/plot/SvgText.h"

#include <cstdio>

namespace aolib::bench {

namespace {

/// Two decimals at most: what a picture needs, and short.
std::string number(double value) {
    char text[40];
    std::snprintf(text, sizeof(text), "%.2f", value);
    std::string result = text;
    result.erase(result.find_last_not_of('0') + 1);
    if (result.back() == '.') {
        result.pop_back();
    }
    return result == "-0" ? "0" : result;
}

std::string colour(const Colour& c) {
    char text[16];
    std::snprintf(text, sizeof(text), "#%02x%02x%02x", c.r, c.g, c.b);
    return text;
}

std::string escaped(const std::string& text) {
    std::string result;
    for (const char c : text) {
        switch (c) {
        case '&':
            result += "&amp;";
            break;
        case '<':
            result += "&lt;";
            break;
        case '>':
            result += "&gt;";
            break;
        default:
            result += c;
        }
    }
    return result;
}

std::string points(const std::vector<glm::dvec2>& list) {
    std::string text;
    for (const glm::dvec2& p : list) {
        text += (text.empty() ? "" : " ") + number(p.x) + "," + number(p.y);
    }
    return " points=\"" + text + "\"";
}

std::string outline(const Colour& c, double width) {
    return width > 0.0 ? " stroke=\"" + colour(c) + "\" stroke-width=\"" + number(width) + "\""
                       : "";
}

struct Writer {
    std::string operator()(const Polyline& line) const {
        const std::string dash =
            line.dash > 0.0 ? " stroke-dasharray=\"" + number(line.dash) + "\"" : "";
        return "<polyline" + points(line.points) + " fill=\"none\" stroke-linejoin=\"round\"" +
               (line.dash > 0.0 ? "" : " stroke-linecap=\"round\"") +
               outline(line.colour, line.width) + dash + "/>";
    }
    std::string operator()(const Polygon& polygon) const {
        return "<polygon" + points(polygon.points) + " fill=\"" + colour(polygon.fill) + "\"" +
               outline(polygon.outline, polygon.outlineWidth) + "/>";
    }
    std::string operator()(const Disc& disc) const {
        return "<circle cx=\"" + number(disc.center.x) + "\" cy=\"" + number(disc.center.y) +
               "\" r=\"" + number(disc.radius) + "\" fill=\"" + colour(disc.fill) + "\"" +
               outline(disc.outline, disc.outlineWidth) + "/>";
    }
    std::string operator()(const Text& text) const {
        const std::string x = number(text.position.x);
        const std::string y = number(text.position.y);
        const char* const anchor = text.anchor == Anchor::Start    ? "start"
                                   : text.anchor == Anchor::Middle ? "middle"
                                                                   : "end";
        return "<text x=\"" + x + "\" y=\"" + y + "\" font-size=\"" + number(text.size) +
               "\" fill=\"" + colour(text.colour) + "\" text-anchor=\"" + anchor + "\"" +
               (text.bold ? " font-weight=\"bold\"" : "") +
               (text.upwards ? " transform=\"rotate(-90 " + x + " " + y + ")\"" : "") + ">" +
               escaped(text.text) + "</text>";
    }
};

} // namespace

std::string svgText(const Drawing& drawing) {
    const std::string size =
        "width=\"" + number(drawing.width) + "\" height=\"" + number(drawing.height) + "\"";
    std::string text = "<svg xmlns=\"http://www.w3.org/2000/svg\" " + size + " viewBox=\"0 0 " +
                       number(drawing.width) + " " + number(drawing.height) +
                       "\" font-family=\"Helvetica, Arial, sans-serif\">\n<rect " + size +
                       " fill=\"#ffffff\"/>\n";
    for (const Shape& shape : drawing.shapes) {
        text += std::visit(Writer(), shape) + "\n";
    }
    return text + "</svg>\n";
}

} // namespace aolib::bench
