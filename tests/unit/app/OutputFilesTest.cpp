#include "app/OutputFiles.h"

#include "Program.h"

namespace aolib::test {

namespace {

using app::OutputFiles;

class OutputFilesTest : public ProgramTest {};

TEST_F(OutputFilesTest, WritesAllThatWasPut) {
    OutputFiles files;
    ASSERT_FALSE(files.createFolder("--out", path("a/b")));
    ASSERT_FALSE(files.announce("--out", path("a/b") / "w.pfm", {".pfm"}));
    files.put(path("a/b") / "w.pfm", FloatImage(2, 2, 1, 0.5F));
    files.put(path("c.png"), ByteImage(2, 2, 3));
    EXPECT_FALSE(files.commit());
    EXPECT_EQ(names(), (std::vector<std::string>{"a", "a/b", "a/b/w.pfm", "c.png"}));
}

TEST_F(OutputFilesTest, OneThatFailsLeavesNothing) {
    write("old.png", "as it was");
    OutputFiles files;
    ASSERT_FALSE(files.createFolder("--out", path("a/b")));
    files.put(path("a/b") / "w.pfm", FloatImage(2, 2, 1, 0.5F));
    files.put(path("old.png"), ByteImage(2, 2, 3));
    files.put(path("no.png"), ByteImage()); // an empty picture cannot be written
    const app::MaybeFailure failure = files.commit();
    ASSERT_TRUE(failure);
    EXPECT_EQ(failure->exit, app::ExitCode::Failed);
    EXPECT_NE(failure->sentence.find("no.png"), std::string::npos) << failure->sentence;
    EXPECT_EQ(names(), (std::vector<std::string>{"old.png"}));
    EXPECT_EQ(bytesOf("old.png"), "as it was");
}

TEST_F(OutputFilesTest, RefusesNamesBeforeAnyWork) {
    OutputFiles files;
    EXPECT_FALSE(files.announce("--ao", path("w.pfm"), {".pfm", ".png"}));
    EXPECT_TRUE(files.announce("--truth", path("w.pfm"), {".pfm", ".png"})); // twice
    EXPECT_TRUE(files.announce("--ao", path("w.jpg"), {".pfm", ".png"}));
    EXPECT_TRUE(files.announce("--ao", path("gone") / "w.pfm", {".pfm"}));
    write("file", "");
    EXPECT_TRUE(files.createFolder("--out", path("file") / "deeper"));
}

} // namespace

} // namespace aolib::test
