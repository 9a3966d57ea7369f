// What the files of an experiment's records are to the program that writes and the one that reads.
#include "experiments/common/records.h"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/common/temporary_folder.h"

namespace cirque {
namespace {

using nlohmann::json;
using ::testing::ElementsAre;
using ::testing::IsEmpty;

TEST(Records, AreWholeLinesWithAKeyAndAnOutcome) {
  const json record = {{"key", "k"}, {"outcome", "ok"}};
  EXPECT_EQ(ParseRecord(record.dump()), record);
  for (const json& other : {json(), json(3), json::array({"key", "outcome"}), json{{"key", "k"}},
                            json{{"outcome", "ok"}}, json{{"key", 1}, {"outcome", "ok"}},
                            json{{"key", "k"}, {"outcome", nullptr}}}) {
    EXPECT_FALSE(ParseRecord(other.dump())) << other;
  }
  EXPECT_FALSE(ParseRecord(record.dump().substr(1)));
  EXPECT_FALSE(ParseRecord(record.dump().substr(0, 12)));
}

TEST(Records, LieInOneFileForAllAndOneForEachShard) {
  const TemporaryFolder folder;
  for (const char* name :
       {"results.shard-2-of-2.jsonl", "results.jsonl", "results.shard-1-of-2.jsonl", "results.csv",
        "results.shard-1-of-2.jsonl.tmp", "figures.json", ".results.jsonl.lock"}) {
    folder.Write(name, "");
  }
  EXPECT_THAT(RecordFiles(folder.path()),
              ElementsAre(folder.Path("results.jsonl"), folder.Path("results.shard-1-of-2.jsonl"),
                          folder.Path("results.shard-2-of-2.jsonl")));
  EXPECT_THAT(RecordFiles(folder.Path("none")), IsEmpty());
}

TEST(Records, PartsAreFoundByPointersAndMayBeMissing) {
  const json record = {
      {"mesh", {{"name", "a"}, {"triangles", 7}}}, {"map", nullptr}, {"list", {1, "b"}}};
  EXPECT_EQ(NumberAt(record, "/mesh/triangles"), 7);
  EXPECT_TRUE(std::isnan(NumberAt(record, "/mesh/name")));
  EXPECT_TRUE(std::isnan(NumberAt(record, "/mesh/name/first")));
  EXPECT_TRUE(std::isnan(NumberAt(record, "/none")));
  EXPECT_EQ(TextAt(record, "/mesh/name"), "a");
  EXPECT_EQ(TextAt(record, "/mesh/triangles"), "7");
  EXPECT_EQ(TextAt(record, "/list"), "[1,\"b\"]");
  EXPECT_EQ(TextAt(record, "/map"), "");
  EXPECT_EQ(TextAt(record, "/none"), "");
}

TEST(Records, FieldsOfACsvAreQuotedWhereTheyMust) {  // RFC 4180, section 2
  EXPECT_EQ(CsvField("plain text"), "plain text");
  EXPECT_EQ(CsvField("a,b"), "\"a,b\"");
  EXPECT_EQ(CsvField("say \"hi\""), "\"say \"\"hi\"\"\"");
  EXPECT_EQ(CsvField("two\nlines"), "\"two\nlines\"");
  EXPECT_EQ(CsvField("one\r"), "\"one\r\"");
  // What a spreadsheet would reckon with.
  for (const std::string text : {"=1+1", "+a", "-a", "@SUM(A1)"}) {
    EXPECT_EQ(CsvField(text), "'" + text);
  }
  EXPECT_EQ(CsvField("=a,b"), "\"'=a,b\"");
  EXPECT_EQ(CsvField(-1.5), "-1.5");
  EXPECT_EQ(CsvField(0.1), "0.1");
  EXPECT_EQ(CsvField(true), "true");
  EXPECT_EQ(CsvField({1, 2}), "\"[1,2]\"");
  EXPECT_EQ(CsvField(nullptr), "");
}

}  // namespace
}  // namespace cirque
