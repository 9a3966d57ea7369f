#include "experiments/common/options_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/common/run_program.h"

namespace cirque {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

TEST(WordsOfOptions, UnderstandsCommentsAndQuotes) {
  EXPECT_THAT(*WordsOfOptions("o", "-io ear.obj   # the input\n# -oc c\r\n\t-oo opt.obj\n"),
              ElementsAre("-io", "ear.obj", "-oo", "opt.obj"));
  EXPECT_THAT(
      *WordsOfOptions("o", "\xEF\xBB\xBF-io \"my ear.obj\" --oo='a \"b\"' a#b \"\" x\"y z\"w"),
      ElementsAre("-io", "my ear.obj", "--oo=a \"b\"", "a#b", "", "xy zw"));
  EXPECT_THAT(*WordsOfOptions("o", " \n# nothing"), IsEmpty());
  EXPECT_EQ(WordsOfOptions("o", "-io \"a b\"\n-oo 'c\n'").status().message(),
            "o:2: a quote is not closed on its line");
}

TEST(OptionsFile, OfAMeshItSaysThatItIsOne) {
  const TemporaryFolder folder;
  const std::string text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
  for (const std::string name : {"m.obj", "m"}) {
    const std::string path = folder.Write(name, text);
    EXPECT_EQ(ReadOptionsFile(path).status().message(),
              path + ": this is a mesh, where a file of options was expected; write -io " + path);
  }
  const std::string other = folder.Write("other", "hello\n");
  EXPECT_EQ(ReadOptionsFile(other).status().message(),
            other + ": a file of options begins with one, this one with 'hello'");
  EXPECT_THAT(ReadOptionsFile(folder.Path("none")).status().message(), HasSubstr("--help"));
}

}  // namespace
}  // namespace cirque
