#include <string>

#include "Program.h"
#include "image/Pfm.h"
#include "image/Png.h"

namespace aolib::test {

namespace {

class CompareTest : public ProgramTest {
protected:
    void SetUp() override {
        ProgramTest::SetUp();
        FloatImage reference(2, 2, 1, 0.5F);
        reference.at(1, 1) = backgroundValue;
        FloatImage test = reference;
        test.at(0, 0) = 0.75F; // errors 0.25, 0, 0 and a background pixel
        ASSERT_FALSE(writePfm(path("test.pfm"), test).has_value());
        ASSERT_FALSE(writePfm(path("reference.pfm"), reference).has_value());
    }
};

TEST_F(CompareTest, PrintsTheMetricsAsJson) {
    const ProgramRun compared = run({"compare", "test.pfm", "reference.pfm", "--json"});
    ASSERT_EQ(compared.exitCode, 0) << compared.err;
    for (const char* line : {"\"pixels\": 3", "\"rmse\": 0.1443375", "\"mae\": 0.083333",
                             "\"bias\": 0.083333", "\"max\": 0.25", "\"ssim\": null"}) {
        EXPECT_NE(compared.out.find(line), std::string::npos) << line << "\n" << compared.out;
    }
}

TEST_F(CompareTest, EqualPicturesHaveNoFinitePsnr) {
    const ProgramRun json = run({"compare", "test.pfm", "test.pfm", "--json"});
    EXPECT_NE(json.out.find("\"psnr_db\": null"), std::string::npos) << json.out;
    const ProgramRun table = run({"compare", "test.pfm", "test.pfm"});
    EXPECT_EQ(table.exitCode, 0);
    EXPECT_NE(table.out.find("infinite"), std::string::npos) << table.out;
    EXPECT_NE(table.out.find("RMSE"), std::string::npos) << table.out;
}

TEST_F(CompareTest, WritesTheDifferenceInRed) {
    const ProgramRun compared =
        run({"compare", "test.pfm", "reference.pfm", "--difference", "d.png"});
    ASSERT_EQ(compared.exitCode, 0) << compared.err;
    const Result<ByteImage, ImageError> picture = readPng(path("d.png"));
    ASSERT_TRUE(picture.ok()) << picture.error().message;
    EXPECT_EQ(picture->at(0, 0, 0), 255); // too bright by the whole scale: red
    EXPECT_EQ(picture->at(0, 0, 2), 0);
    EXPECT_EQ(picture->at(1, 0, 2), 255); // equal: white
}

} // namespace

} // namespace aolib::test
