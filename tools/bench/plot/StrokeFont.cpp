#include "bench/plot/StrokeFont.h"

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

namespace aolib::bench {

namespace {

/// A character: its strokes, separated by spaces. A point is a digit for x ('0' is 0, ':' is 10)
/// and a letter for y ('e' is the baseline, 'm' the height of small letters, 'q' of capitals). A
/// stroke that begins with ~ is rounded; one that ends where it begins is closed.
struct Glyph {
    int width;
    std::string_view strokes;
};

constexpr double kUnitsPerSize = 16.6; ///< so that capitals are 0.72 of the font's size high
constexpr int kLetterGap = 3;          ///< between characters
constexpr char kFirst = ' ';
constexpr Glyph kUnknown{6, "0e0q6q6e0e"};

constexpr std::array<Glyph, 95> kGlyphs{{
    {3, ""},                                 // space
    {0, "0q0i 0e0f"},                        // !
    {3, "0q0n 3q3n"},                        // "
    {8, "1e3q 5e7q 0i8i 0m8m"},              // #
    {7, "~7n6p1p0n0l1k6k7j7h6f1f0h 3r3d"},   // $
    {9, "~1q3q3m0m0q1q 1e8q ~7i9i9e6e6i7i"}, // %
    {8, "~8e2m2q5q5m0j0e4e8j"},              // &
    {0, "0q0n"},                             // '
    {3, "~3r0n0g3c"},                        // (
    {3, "~0r3n3g0c"},                        // )
    {6, "0k6o 0o6k 3j3p"},                   // *
    {6, "0j6j 3g3m"},                        // +
    {1, "1f0c"},                             // ,
    {4, "0j4j"},                             // -
    {0, "0e0f"},                             // .
    {5, "0d5q"},                             // /
    {7, "~3q7q7e0e0q3q"},                    // 0
    {4, "0n3q3e"},                           // 1
    {7, "~0n0q7q7m5j0e 0e7e"},               // 2
    {7, "~0o1q7q7k3k ~3k7k7e1e0g"},          // 3
    {7, "5e5q0h7h"},                         // 4
    {7, "6q1q0k ~0k1m7m7e1e0g"},             // 5
    {7, "~6p5q0q0e7e7l1l0i"},                // 6
    {7, "0q7q2e"},                           // 7
    {7, "~3q7q7k0k0q3q ~3k7k7e0e0k3k"},      // 8
    {7, "~1f2e7e7q0q0j6j7m"},                // 9
    {0, "0e0f 0l0m"},                        // :
    {1, "1f0c 1l1m"},                        // ;
    {6, "6m0j6g"},                           // <
    {6, "0h6h 0k6k"},                        // =
    {6, "0m6j0g"},                           // >
    {6, "~0n0q6q6m3l3i 3e3f"},               // ?
    {9, "~6h3h3l6l6h9h9q0q0e8e"},            // @
    {8, "0e4q8e 1i7i"},                      // A
    {7, "0e0q ~0q7q7k0k ~0k8k8e0e 0q0e"},    // B
    {8, "~8n8q0q0e8e8h"},                    // C
    {8, "0e0q ~0q8q8e0e"},                   // D
    {6, "6q0q0e6e 0k5k"},                    // E
    {6, "6q0q0e 0k5k"},                      // F
    {8, "~8n8q0q0e8e8j 8e8j5j"},             // G
    {8, "0e0q 8e8q 0k8k"},                   // H
    {0, "0e0q"},                             // I
    {5, "~5q5e0e0h"},                        // J
    {7, "0e0q 7q0i 2k7e"},                   // K
    {6, "0q0e6e"},                           // L
    {9, "0e0q4g8q8e"},                       // M
    {8, "0e0q8e8q"},                         // N
    {9, "~4q9q9e0e0q4q"},                    // O
    {7, "0e0q ~0q8q8k0k"},                   // P
    {9, "~4q9q9e0e0q4q 5h9d"},               // Q
    {8, "0e0q ~0q8q8k0k 4k8e"},              // R
    {7, "~7o7q0q0k4k7k7e0e0g"},              // S
    {8, "0q8q 4q4e"},                        // T
    {8, "~0q0e8e8q"},                        // U
    {8, "0q4e8q"},                           // V
    {12, "0q3e6p9e<q"},                      // W
    {8, "0e8q 0q8e"},                        // X
    {8, "0q4k8q 4k4e"},                      // Y
    {7, "0q7q0e7e"},                         // Z
    {3, "3r0r0c3c"},                         // [
    {5, "0q5d"},                             // backslash
    {3, "0r3r3c0c"},                         // ]
    {6, "0n3q6n"},                           // ^
    {7, "0c7c"},                             // _
    {2, "0q2n"},                             // `
    {6, "~0k0m6m6e 6e6i ~6j0j0e6e6h"},       // a
    {7, "0e0q ~3m7m7e0e0m3m"},               // b
    {6, "~6k6m0m0e6e6g"},                    // c
    {7, "7e7q ~4m7m7e0e0m4m"},               // d
    {6, "0i6i ~6i6m0m0e6e6g"},               // e
    {4, "~4q1q1n1e 0m4m"},                   // f
    {7, "~4m7m7e0e0m4m ~7m7a1a0b"},          // g
    {6, "0e0q ~0j0m6m6e"},                   // h
    {0, "0e0m 0p0q"},                        // i
    {2, "~2m2a0a 2p2q"},                     // j
    {6, "0e0q 6m0h 2j6e"},                   // k
    {0, "0e0q"},                             // l
    {10, "0e0m ~0j0m5m5e ~5j5m:m:e"},        // m
    {6, "0e0m ~0j0m6m6e"},                   // n
    {7, "~3m7m7e0e0m3m"},                    // o
    {7, "0a0m ~3m7m7e0e0m3m"},               // p
    {7, "7a7m ~4m7m7e0e0m4m"},               // q
    {4, "0e0m ~0j0m3m4m"},                   // r
    {6, "~6l6m0m0i3i6i6e0e0f"},              // s
    {4, "~1p1e4e 0m4m"},                     // t
    {6, "~0m0e6e6h 6m6e"},                   // u
    {6, "0m3e6m"},                           // v
    {10, "0m2e5m8e:m"},                      // w
    {6, "0e6m 0m6e"},                        // x
    {6, "0m3e 6m2a0a"},                      // y
    {6, "0m6m0e6e"},                         // z
    {4, "~4r2r2k0j ~0j2i2c4c"},              // {
    {0, "0r0c"},                             // |
    {4, "~0r2r2k4j ~4j2i2c0c"},              // }
    {7, "~0i1l4j6h7k"},                      // ~
}};

const Glyph& glyphOf(char character) {
    const int index = character - kFirst;
    return index >= 0 && index < static_cast<int>(kGlyphs.size())
               ? kGlyphs[static_cast<std::size_t>(index)]
               : kUnknown;
}

using Stroke = std::vector<glm::dvec2>;

/// Chaikin's corner cutting: the limit is a quadratic B-spline.
Stroke rounded(Stroke stroke) {
    constexpr int turns = 3;
    const bool closed = stroke.size() > 2 && stroke.front() == stroke.back();
    for (int turn = 0; turn < turns; ++turn) {
        Stroke cut;
        if (!closed) {
            cut.push_back(stroke.front());
        }
        for (std::size_t i = 0; i + 1 < stroke.size(); ++i) {
            cut.push_back(0.75 * stroke[i] + 0.25 * stroke[i + 1]);
            cut.push_back(0.25 * stroke[i] + 0.75 * stroke[i + 1]);
        }
        cut.push_back(closed ? cut.front() : stroke.back());
        stroke = std::move(cut);
    }
    return stroke;
}

Stroke parse(std::string_view text) {
    const bool smooth = text.starts_with('~');
    Stroke stroke;
    for (std::size_t i = smooth ? 1 : 0; i + 1 < text.size(); i += 2) {
        stroke.emplace_back(text[i] - '0', text[i + 1] - 'e');
    }
    return smooth ? rounded(std::move(stroke)) : stroke;
}

} // namespace

double textWidth(const std::string& text, double size) {
    int units = 0;
    for (const char character : text) {
        units += glyphOf(character).width + kLetterGap;
    }
    return double(units) * size / kUnitsPerSize;
}

std::vector<Stroke> textStrokes(const std::string& text, double size) {
    const double scale = size / kUnitsPerSize;
    std::vector<Stroke> strokes;
    double x = 0.5 * kLetterGap;
    for (const char character : text) {
        std::string_view rest = glyphOf(character).strokes;
        while (!rest.empty()) {
            const std::size_t end = std::min(rest.find(' '), rest.size());
            Stroke stroke = parse(rest.substr(0, end));
            for (glm::dvec2& p : stroke) {
                p = {(p.x + x) * scale, -p.y * scale};
            }
            strokes.push_back(std::move(stroke));
            rest.remove_prefix(std::min(end + 1, rest.size()));
        }
        x += glyphOf(character).width + kLetterGap;
    }
    return strokes;
}

} // namespace aolib::bench
