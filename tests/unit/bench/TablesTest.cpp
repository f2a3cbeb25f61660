#include <set>
#include <string>

#include <gtest/gtest.h>

#include "bench/CaseTable.h"
#include "bench/FamilyStyle.h"
#include "bench/MethodTable.h"
#include "bench/ThesisTable.h"

namespace aolib::bench {
namespace {

TEST(CaseTable, HasTwoCamerasAndTwoRadiiOfEveryScene) {
    std::set<std::string> seen;
    for (const BenchCase& which : benchCases()) {
        seen.insert(which.scene.name + std::to_string(which.camera) +
                    std::to_string(which.radiusShare));
    }
    EXPECT_EQ(seen.size(), 36U);
    EXPECT_EQ(benchCases().size(), 36U);
}

TEST(CaseTable, KeepsTheCasesOfASceneInARow) {
    std::set<std::string> finished;
    std::string current;
    for (const BenchCase& which : benchCases()) {
        if (which.scene.name != current) {
            EXPECT_TRUE(finished.insert(which.scene.name).second) << which.scene.name;
            current = which.scene.name;
        }
    }
}

TEST(MethodTable, NamesEveryMethodOnce) {
    std::set<std::string> names;
    for (const Method& method : benchMethods()) {
        EXPECT_TRUE(names.insert(method.name).second) << method.name;
        EXPECT_FALSE(method.label.empty()) << method.name;
    }
}

TEST(MethodTable, HasAStandardMethodOfEveryFamily) {
    for (const Family family : families()) {
        bool found = false;
        for (const Method& method : chooseMethods({})) {
            found = found || method.family == family;
        }
        EXPECT_TRUE(found) << familyName(family);
    }
}

TEST(MethodTable, ListsEveryFamilyAMethodHas) {
    for (const Method& method : benchMethods()) {
        bool listed = false;
        for (const Family family : families()) {
            listed = listed || family == method.family;
        }
        EXPECT_TRUE(listed) << method.name;
        EXPECT_FALSE(familyName(method.family).empty()) << method.name;
        EXPECT_GT(styleOf(method.family).width, 0.0) << method.name;
    }
}

TEST(MethodTable, PlacesNoCubeMapsByItself) {
    for (const Method& method : benchMethods()) {
        const auto* facade = std::get_if<FacadeMethod>(&method.how);
        if (facade != nullptr && facade->cubeMaps > 0) {
            EXPECT_FALSE(facade->options.cubeMaps.place) << method.name;
            EXPECT_GE(facade->options.cubeMaps.nearest, facade->cubeMaps) << method.name;
        }
    }
}

TEST(MethodTable, PatternsMatchWholeNames) {
    EXPECT_TRUE(matches("rays-*", "rays-16"));
    EXPECT_TRUE(matches("*8x16*", "layered-8x16-512"));
    EXPECT_TRUE(matches("rays-?", "rays-4"));
    EXPECT_TRUE(matches("*", ""));
    EXPECT_FALSE(matches("rays-?", "rays-16"));
    EXPECT_FALSE(matches("rays", "rays-16"));
    EXPECT_FALSE(matches("", "rays"));
}

TEST(MethodTable, AsksForMethodsThatAreNotStandard) {
    const std::vector<Method> chosen = chooseMethods({"layered-16x32-1024", "rays-4"});
    ASSERT_EQ(chosen.size(), 2U);
    EXPECT_FALSE(chosen[0].standard);
    EXPECT_EQ(chosen[1].name, "rays-4");
}

TEST(ThesisTable, VariesOneThingPerFigure) {
    for (const ThesisFigure figure : thesisFigures()) {
        const std::vector<ThesisSetting> settings =
            thesisSettings(figure, Estimator::HorizonSplit, false);
        std::set<int> values;
        for (const ThesisSetting& setting : settings) {
            values.insert(setting.value());
            ThesisSetting same = settings.front();
            same.faceSize = figure == ThesisFigure::FaceSize ? setting.faceSize : same.faceSize;
            same.directions =
                figure == ThesisFigure::Directions ? setting.directions : same.directions;
            same.steps = figure == ThesisFigure::Steps ? setting.steps : same.steps;
            same.cubeMaps = figure == ThesisFigure::CubeMaps ? setting.cubeMaps : same.cubeMaps;
            EXPECT_EQ(same.faceSize, setting.faceSize);
            EXPECT_EQ(same.directions, setting.directions);
            EXPECT_EQ(same.steps, setting.steps);
            EXPECT_EQ(same.cubeMaps, setting.cubeMaps);
        }
        EXPECT_EQ(values.size(), settings.size()) << figureName(figure);
    }
}

} // namespace
} // namespace aolib::bench
