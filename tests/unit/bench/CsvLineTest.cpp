#include "bench/CsvLine.h"

#include <gtest/gtest.h>

namespace aolib::bench {
namespace {

TEST(CsvLine, QuotesWhatMustBe) {
    CsvLine line;
    line.add("plain").add("a,b").add("say \"hi\"").add("two\nlines");
    EXPECT_EQ(line.text(), "plain,\"a,b\",\"say \"\"hi\"\"\",\"two\nlines\"\n");
}

TEST(CsvLine, LeavesUnknownNumbersEmpty) {
    CsvLine line;
    line.addKnown(-1.0).addKnown(0.0).add(-2.5).add(7);
    EXPECT_EQ(line.text(), ",0,-2.5,7\n");
}

TEST(CsvLine, KeepsAnEmptyFirstCell) {
    CsvLine line;
    line.add("").add("b");
    EXPECT_EQ(line.text(), ",b\n");
}

} // namespace
} // namespace aolib::bench
