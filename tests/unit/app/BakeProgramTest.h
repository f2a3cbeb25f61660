#pragma once

#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "Program.h"
#include "image/Image.h"

namespace aolib::test {

using Json = nlohmann::json;

/// Runs `aolib bake` in a folder of its own.
class BakeProgramTest : public ProgramTest {
protected:
    void expectDone(const std::vector<std::string>& arguments) const {
        const ProgramRun done = run(arguments);
        EXPECT_EQ(done.exitCode, 0) << done.err;
    }
    void expectRefused(const std::vector<std::string>& arguments,
                       const std::vector<std::string>& words) const {
        const auto before = names();
        const ProgramRun refused = run(arguments);
        EXPECT_EQ(refused.exitCode, 2) << refused.out << refused.err;
        for (const std::string& word : words) {
            EXPECT_NE(refused.err.find(word), std::string::npos) << refused.err;
        }
        EXPECT_EQ(names(), before);
    }
    Json jsonOf(const std::string& name) const {
        const std::string bytes = bytesOf(name);
        std::uint32_t length = 0;
        std::memcpy(&length, &bytes.at(12), 4);
        return Json::parse(bytes.substr(20, length));
    }
    /// The middle of a map's part, given in shares of its sides.
    static float at(const FloatImage& map, float u, float v) {
        return map.at(static_cast<int>(u * float(map.width)),
                      static_cast<int>(v * float(map.height)));
    }
};

} // namespace aolib::test
