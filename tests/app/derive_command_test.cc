// `parti derive` as a person runs it, and rules given to the other commands.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>

#include "base/text_file.h"
#include "tests/support/program.h"

namespace parti::app {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;
using tests::ProgramRun;
using tests::RunParti;

constexpr std::string_view kHouse = R"(attr height = 6
@StartRule
Lot --> extrude(height) Mass
Mass --> comp(f) { side: Facade | top: Roof }
Facade --> layers("floors", "door") { Floors | Door }
Floors --> segment(y) { ~3: Floor }*
Floor --> segment(x) { ~1: NIL | 1.2: Window | ~1: NIL }*
Window --> extrude(0.1) Glass
Door --> segment(x) { ~1: NIL | 1: segment(y) { 2.2: extrude(-0.2) Leaf | ~1: NIL } | ~1: NIL }
)";

std::string File(std::string_view text, const std::string& name = "/house.cga") {
  std::string path = tests::TestFolder() + name;
  EXPECT_TRUE(WriteFile(path, text));
  return path;
}

nlohmann::json StatsOf(std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), "derive");
  arguments.emplace_back("--stats");
  const ProgramRun run = RunParti(arguments);
  EXPECT_EQ(run.status, 0) << run.errors;
  return nlohmann::json::parse(run.output);
}

std::vector<std::string> Lines(const std::string& text) {
  std::vector<std::string> lines;
  for (size_t from = 0; from < text.size();) {
    const size_t end = std::min(text.find('\n', from), text.size());
    lines.push_back(text.substr(from, end - from));
    from = end + 1;
  }
  return lines;
}

size_t Selected(const std::string& file, const std::string& query,
                std::vector<std::string> options = {}) {
  options.insert(options.begin(), {"query", file, query});
  return Lines(RunParti(options).output).size();
}

TEST(DeriveCommand, SaysWhatItSkipped) {
  const std::string house = File("Lot --> envelope(3) extrude(3) envelope(1)\n");
  for (const std::vector<std::string>& arguments :
       {std::vector<std::string>{"derive", house, "--start", "Lot"},
        {"query", house, ".Lot", "--start", "Lot"},
        {"export", house, tests::TestFolder() + "/house.obj", "--start", "Lot"}}) {
    EXPECT_EQ(RunParti(arguments).status, 1) << arguments[0];
    std::vector<std::string> skipping = arguments;
    skipping.emplace_back("--skip-unknown");
    const ProgramRun run = RunParti(skipping);
    EXPECT_EQ(run.status, 0) << arguments[0] << run.errors;
    EXPECT_THAT(run.errors, HasSubstr("parti: skipped operation 'envelope', 2 places\n"));
  }
}

TEST(DeriveCommand, SaysWhatItMade) {
  const auto stats = StatsOf({File(kHouse), "--lot", "rect(9,6)"});
  for (const char* key : {"shapes", "terminals", "triangles", "derive_ms", "normalise_ms",
                          "export_ms", "peak_bytes"}) {
    ASSERT_TRUE(stats.contains(key)) << key;
    EXPECT_GE(stats[key].get<double>(), 0) << key;
  }
  EXPECT_GT(stats["shapes"], stats["terminals"]);
  EXPECT_GT(stats["triangles"], 0);
}

TEST(DeriveCommand, WritesModelsPicturesAndDocuments) {
  const std::string folder = tests::TestFolder();
  const ProgramRun run =
      RunParti({"derive", File(kHouse), "--export", folder + "/a.glb", "--export",
                folder + "/a.obj", "--png", folder + "/a.png", "--save", folder + "/a.parti"});
  EXPECT_EQ(run.status, 0) << run.errors;
  for (const char* name : {"/a.glb", "/a.obj", "/a.png", "/a.parti"}) {
    EXPECT_TRUE(std::filesystem::exists(folder + name)) << name;
  }
}

TEST(DeriveCommand, OutputsAreNotNamedAsWhatTheyAreNot) {
  const std::string rules = File(kHouse), folder = tests::TestFolder() + "/";
  const std::map<std::string, std::vector<std::string>> wrong = {
      {"a.jpg", {"derive", rules, "--png"}},
      {"a.glb", {"derive", rules, "--save"}},
      {"a.fbx", {"derive", rules, "--export"}},
      {"b.jpg", {"render", rules, "--png"}},
      {"b.png.gz", {"render", rules, "--png"}},
      {"c.jpeg", {"export", rules}},
      {"d.png", {"report", rules}},
      {"d.txt", {"record"}},
      {"e.gif", {"replay", rules, "--png"}},
      {"e.cga", {"replay", rules, "--save"}},
      {"f.jpg", {"--display", "no", "--screenshot"}}};
  for (auto [name, arguments] : wrong) {
    arguments.push_back(folder + name);
    const ProgramRun run = RunParti(arguments);
    EXPECT_EQ(run.status, 1) << name;
    EXPECT_THAT(run.errors, HasSubstr(name));
    EXPECT_THAT(run.errors, HasSubstr("hint: ")) << name;
    EXPECT_FALSE(std::filesystem::exists(folder + name)) << name;
  }
}

TEST(DeriveCommand, EndingsInCapitalsAndNoneAreFine) {
  const std::string folder = tests::TestFolder();
  const ProgramRun run = RunParti({"derive", File(kHouse), "--export", folder + "/A.OBJ", "--png",
                                   folder + "/picture", "--save", folder + "/A.Parti"});
  EXPECT_EQ(run.status, 0) << run.errors;
  EXPECT_THAT(*ReadFile(folder + "/picture"), HasSubstr("PNG"));
}

TEST(DeriveCommand, ASeedIsAWholeNumberThatFits) {
  const std::string rules = File(kHouse);
  EXPECT_EQ(RunParti({"derive", rules, "--seed", "18446744073709551615"}).status, 0);
  for (const char* seed : {"-1", "-0", "1.5", "1e3", "18446744073709551616", "", "nan"}) {
    const ProgramRun run = RunParti({"derive", rules, "--seed", seed});
    EXPECT_EQ(run.status, 2) << seed;
    EXPECT_THAT(run.errors, HasSubstr("from 0 to 18446744073709551615")) << seed;
  }
  for (const char* seconds : {"-1", "nan", "inf"}) {
    EXPECT_EQ(RunParti({"derive", rules, "--seconds", seconds}).status, 2) << seconds;
  }
}

TEST(DeriveCommand, WhatIsNoNumberIsOneWordEverywhere) {
  const std::string rules = File(
      "attr a = 0/0\nattr b = -(0/0)\n"
      "Lot --> print(a) print(b) print(str(a) + str(b)) report(\"n\", a - b) extrude(1) A\n");
  const ProgramRun run = RunParti({"derive", rules});
  EXPECT_EQ(run.status, 0) << run.errors;
  for (const char* line : {"9: rule Lot: nan\n", "18: rule Lot: nan\n", "27: rule Lot: nannan\n"}) {
    EXPECT_THAT(run.errors, HasSubstr(line));
  }
  for (const char* bad : {"0/0", "-(0/0)"}) {
    const std::string wrong = File(std::string("Lot --> extrude(") + bad + ") A\n");
    EXPECT_THAT(RunParti({"derive", wrong}).errors, HasSubstr("distance is nan")) << bad;
  }
  for (const char* bad : {"a=nan", "a=-nan", "a=inf", "a=-inf"}) {
    EXPECT_EQ(RunParti({"derive", rules, "--set", bad}).status, 1) << bad;
  }
}

TEST(DeriveCommand, ADocumentDerivesTheSameAgain) {
  const std::string rules = File(kHouse), document = tests::TestFolder() + "/house.parti";
  const std::vector<std::string> options = {"--set", "height=9", "--layers-off", "Facade.door"};
  std::vector<std::string> save = {"derive", rules, "--save", document};
  save.insert(save.end(), options.begin(), options.end());
  ASSERT_EQ(RunParti(save).status, 0);
  std::filesystem::remove(rules);
  EXPECT_EQ(Selected(document, ".Leaf"), 0u);
  EXPECT_EQ(RunParti({"query", document, "*"}).output,
            RunParti([&] {
              std::vector<std::string> query = {"query", File(kHouse), "*"};
              query.insert(query.end(), options.begin(), options.end());
              return query;
            }())
                .output);
}

TEST(DeriveCommand, TheFrontIsOnTheStreetThatAFileGivesAndADocumentKeepsIt) {
  const std::string rules = File("Lot --> setback(2) { front: Garden | remainder: Plot }");
  for (const char* street : {"0", "90", "180", "270"}) {
    const std::string lots = File(
        R"({"type":"Feature","properties":{"street_deg":)" + std::string(street) +
            R"(},"geometry":{"type":"Polygon","coordinates":[[[0,0],[20,0],[20,12],[0,12]]]}})",
        "/lots.geojson");
    const std::string document = lots + ".parti";
    ASSERT_EQ(RunParti({"derive", rules, "--lot", lots, "--save", document}).status, 0);
    const std::string side = std::map<std::string, std::string>{
        {"0", "box(9,0,-12,2,1,1)"},
        {"90", "box(19,0,-7,1,1,2)"},
        {"180", "box(9,0,-1,2,1,1)"},
        {"270",
         "box(0,0,-7,1,1,2)"}}.at(street);
    const std::string query = ".Garden:intersects(" + side + ")";
    EXPECT_EQ(Selected(rules, query, {"--lot", lots}), 1u) << street;
    EXPECT_EQ(Selected(document, query), 1u) << street;
  }
}

std::string Feature(const std::string& id, int east, const std::string& properties) {
  return fmt::format(
      R"({{"type":"Feature","id":"{0}","properties":{{{2}}},"geometry":{{"type":"Polygon",)"
      R"("coordinates":[[[{1},0],[{1}9,0],[{1}9,8]]]}}}})"
      "\n",
      id, east, properties);
}

TEST(DeriveCommand, LotsGiveAttributesTheirPropertiesOnAnyNumberOfThreadsAndInDocuments) {
  const std::string rules = File(
      "@Range(1, 9) attr floors = 2\nattr flat = false\n"
      "Lot --> extrude(3 * floors) split(y) { 3: Floor }* Top\n"
      "Floor --> case flat: Flat. else: Steep.\n");
  const std::string lots =
      File(Feature("a", 1, R"("floors":4,"flat":true,"owner":["x"],"year":1920)") +
               Feature("b", 2, R"("floors":1)") + Feature("c", 3, ""),
           "/lots.geojson");
  const std::string document = lots + ".parti";
  ASSERT_EQ(RunParti({"derive", rules, "--lot", lots, "--save", document}).status, 0);
  for (const char* threads : {"1", "2", "7"}) {
    const std::vector<std::string> on = {"--lot", lots, "--threads", threads};
    EXPECT_EQ(Selected(rules, ".Flat", on), 4u);
    EXPECT_EQ(Selected(rules, ".Steep", on), 1u + 2u) << "the last has what the rules say";
  }
  std::filesystem::remove(lots);
  EXPECT_EQ(Selected(document, ".Flat"), 4u);
  EXPECT_EQ(Selected(document, ".Steep"), 3u);
}

TEST(DeriveCommand, WhatIsSetWinsOverPropertiesAndWrongOnesAreNamed) {
  const std::string rules =
      File("@Range(1, 9) attr floors = 2\nLot --> extrude(3 * floors) split(y) { 3: Floor }*\n");
  for (const char* wrong : {R"("floors":"many")", R"("floors":12)"}) {
    const std::string lots =
        File(Feature("a", 1, R"("floors":4)") + Feature("b", 2, wrong), "/lots.geojson");
    const ProgramRun run = RunParti({"derive", rules, "--lot", lots});
    EXPECT_EQ(run.status, 1);
    for (const char* word : {"lots.geojson: lot 'b'", "'floors'", "--skip-bad-lots"}) {
      EXPECT_THAT(run.errors, HasSubstr(word));
    }
    EXPECT_EQ(Selected(rules, ".Floor", {"--lot", lots, "--set", "floors=3"}), 6u);
    EXPECT_EQ(Selected(rules, ".Floor", {"--lot", lots, "--skip-bad-lots"}), 4u);
  }
}

TEST(DeriveCommand, BadLotsAreLeftOutAsIfTheFileHadNoneOfThem) {
  const std::string rules = File(
      "@Range(1, 9) attr floors = 2\nattr height = 3\n"
      "Lot --> extrude(height * floors) split(y) { ~rand(1, 3): Floor }*\n");
  const std::string good = Feature("a", 1, R"("floors":4)") + Feature("d", 4, "");
  const std::string lots = File(Feature("far", 7000000, R"("floors":"many")") +
                                    "{\"id\":\"line\",\"rings\":[[[0,0],[9,0],[18,0]]]}\n" +
                                    Feature("low", 6, R"("height":-20000)") + good,
                                "/lots.geojson");
  const ProgramRun refused = RunParti({"derive", rules, "--lot", lots});
  EXPECT_EQ(refused.status, 1);
  EXPECT_THAT(refused.errors, HasSubstr("--skip-bad-lots leaves such lots out"));
  const std::string out = tests::TestFolder();
  const ProgramRun run =
      RunParti({"derive", rules, "--lot", lots, "--skip-bad-lots", "--export", out + "/a.obj"});
  EXPECT_EQ(run.status, 0) << run.errors;
  for (const char* name :
       {"lot 'line'", "lot 'far'", "lot 'low'", "parti: skipped 3 of 5 lots\n"}) {
    EXPECT_THAT(run.errors, HasSubstr(name));
  }
  const std::string alone = File(good, "/good.geojson");
  ASSERT_EQ(RunParti({"derive", rules, "--lot", alone, "--export", out + "/b.obj"}).status, 0);
  EXPECT_EQ(*ReadFile(out + "/a.obj"), *ReadFile(out + "/b.obj"));
}

TEST(DeriveCommand, WhereAllLotsAreBadNothingIsSkipped) {
  const std::string rules = File("attr height = 3\nLot --> extrude(height) Mass\n");
  for (const char* height : {"-20000", "\"low\""}) {
    const std::string lots =
        File(Feature("a", 1, std::string("\"height\":") + height), "/lots.geojson");
    for (const bool skips : {false, true}) {
      std::vector<std::string> arguments = {"derive", rules, "--lot", lots};
      if (skips) arguments.emplace_back("--skip-bad-lots");
      const ProgramRun run = RunParti(arguments);
      EXPECT_EQ(run.status, 1);
      EXPECT_THAT(run.errors, Not(HasSubstr("--skip-bad-lots"))) << "it would not help";
    }
  }
}

TEST(DeriveCommand, ImportsOfAFolderAboveAreFoundAndKept) {
  const std::string folder = tests::TestFolder();
  const std::string roof = folder + "/roof.cga", house = folder + "/towers/house.cga";
  const std::string saved = folder + "/house.parti";
  std::filesystem::create_directory(folder + "/towers");
  ASSERT_TRUE(WriteFile(roof, "Roof --> color(\"#ad7859\")\n"));
  ASSERT_TRUE(
      WriteFile(house, "import r : \"roof.cga\"\nLot --> split(x) { ~1: r.Roof | ~1: A }\n"));
  EXPECT_EQ(StatsOf({house, "--save", saved})["terminals"], 2);
  std::filesystem::remove(roof);
  EXPECT_THAT(RunParti({"derive", house}).errors, HasSubstr("towers/roof.cga"));
  EXPECT_EQ(StatsOf({saved})["terminals"], 2) << "the document has it";
}

TEST(DeriveCommand, RulesWrittenOutGiveTheSameModel) {
  const std::string rules = File(kHouse), out = tests::TestFolder() + "/out.cga";
  const ProgramRun run = RunParti({"export", rules, out, "--set", "height=9"});
  ASSERT_EQ(run.status, 0) << run.errors;
  EXPECT_TRUE(ReadFile(out).value_or("").starts_with("version \"2021.0\"\n"));
  EXPECT_EQ(RunParti({"query", out, "*"}).output,
            RunParti({"query", rules, "*", "--set", "height=9"}).output);
}

TEST(DeriveCommand, LayersAreSwitchedOffByName) {
  const std::string rules = File(kHouse);
  EXPECT_EQ(Selected(rules, ".Leaf"), 4u);
  EXPECT_EQ(Selected(rules, ".Leaf", {"--layers-off", "Facade.door"}), 0u);
  EXPECT_EQ(Selected(rules, ".Glass", {"--layers-off", "Facade.door,Facade.floors"}), 0u);
  const ProgramRun run = RunParti({"derive", rules, "--layers-off", "Facade.doors"});
  EXPECT_EQ(run.status, 1);
  EXPECT_THAT(run.errors, HasSubstr("did you mean 'Facade.door'?"));
}

TEST(DeriveCommand, TreesRunOnWhatTheRulesMade) {
  const std::string file = File(std::string(kHouse) + "\ntree t { .Roof --> extrude(2) Attic }\n");
  EXPECT_EQ(RunParti({"query", file, ".Roof > .Attic"}).output.size(), 6u);
}

TEST(DeriveCommand, SeveralLotsGiveSeveralTreesTheSameOnAnyNumberOfThreads) {
  const std::string lots = File(R"({"id":"a","rings":[[[0,0],[8,0],[8,9],[0,9]]]}
{"id":"b","rings":[[[20,0],[32,0],[32,9],[20,9]]]}
)",
                                "/lots.jsonl");
  const std::string one = tests::TestFolder() + "/one.obj", two = tests::TestFolder() + "/two.obj";
  const std::string rules = File(kHouse);
  ASSERT_EQ(RunParti({"derive", rules, "--lot", lots, "--threads", "1", "--export", one}).status,
            0);
  ASSERT_EQ(RunParti({"derive", rules, "--lot", lots, "--threads", "2", "--export", two}).status,
            0);
  EXPECT_EQ(*ReadFile(one), *ReadFile(two));
  EXPECT_THAT(RunParti({"query", rules, ".Roof", "--lot", lots}).output, HasSubstr("lot-1:0/"));
}

TEST(DeriveCommand, WrongOptionsSayWhatToDo) {
  const std::string rules = File(kHouse);
  EXPECT_THAT(RunParti({"derive", rules, "--set", "hight=2"}).errors, HasSubstr("'height'"));
  EXPECT_THAT(RunParti({"derive", rules, "--set", "height"}).errors, HasSubstr("NAME=VALUE"));
  EXPECT_THAT(RunParti({"derive", rules, "--start", "Lod"}).errors, HasSubstr("Lot"));
  EXPECT_EQ(RunParti({"derive", rules, "--seed", "x"}).status, 2);
  EXPECT_EQ(RunParti({"derive"}).status, 2);
}

TEST(DeriveCommand, LimitsAndFailuresNameThePlace) {
  const std::string endless = File("Lot --> Lot\n");
  const ProgramRun run = RunParti({"derive", endless, "--depth", "20"});
  EXPECT_EQ(run.status, 1);
  EXPECT_THAT(run.errors, HasSubstr("house.cga:1:9: error: rule Lot: Lot comes of itself"));
  const ProgramRun empty = RunParti({"derive", File("Lot --> NIL\n", "/nil.cga")});
  EXPECT_EQ(empty.status, 1);
}

TEST(DeriveCommand, WritesReportsAsTables) {
  const std::string folder = tests::TestFolder();
  const std::string rules = File(R"(Lot --> split(x) { ~1: Part }*
Part --> report("area", geometry.area) report("a \"b\", c", split.index == 0) A
)");
  const std::string lots = File(R"({"id": "a", "rings": [[[0, 0], [2, 0], [2, 3], [0, 3]]]}
{"id": "b", "rings": [[[9, 0], [12, 0], [12, 3], [9, 3]]]}
)",
                                "/lots.jsonl");
  const ProgramRun run = RunParti({"derive", rules, "--lot", lots, "--reports", folder + "/a.csv",
                                   "--stats", "--threads", "2"});
  ASSERT_EQ(run.status, 0) << run.errors;
  EXPECT_EQ(ReadFile(folder + "/a.csv").value_or(""),
            "lot,report,value,count,sum,average,min,max,no_numbers\r\n"
            ",\"a \"\"b\"\", c\",false,3,,,,,\r\n"
            ",\"a \"\"b\"\", c\",true,2,,,,,\r\n"
            ",area,,5,15,3,3,3,0\r\n"
            "lot-0,\"a \"\"b\"\", c\",false,1,,,,,\r\n"
            "lot-0,\"a \"\"b\"\", c\",true,1,,,,,\r\n"
            "lot-0,area,,2,6,3,3,3,0\r\n"
            "lot-1,\"a \"\"b\"\", c\",false,2,,,,,\r\n"
            "lot-1,\"a \"\"b\"\", c\",true,1,,,,,\r\n"
            "lot-1,area,,3,9,3,3,3,0\r\n");
  const auto stats = nlohmann::json::parse(run.output);
  EXPECT_EQ(stats["reports"][1]["report"], "area");
  EXPECT_EQ(stats["reports"][1]["sum"], 15);

  ASSERT_EQ(RunParti({"derive", rules, "--lot", lots, "--save", folder + "/a.parti"}).status, 0);
  const std::string json = folder + "/a.json";
  ASSERT_EQ(RunParti({"derive", folder + "/a.parti", "--reports", json}).status, 0);
  const auto written = nlohmann::json::parse(ReadFile(json).value_or(""));
  EXPECT_EQ(written["reports"], stats["reports"]) << "a document reports the same";
  EXPECT_EQ(written["reports"][0]["values"]["true"], 2);
  EXPECT_EQ(written["lots"][1]["lot"], "lot-1");
  EXPECT_EQ(written["lots"][1]["reports"][1]["sum"], 9);
}

TEST(DeriveCommand, ReportsThatAreNoneAndFilesThatAreNoTablesAreRefused) {
  const std::string folder = tests::TestFolder();
  const ProgramRun none =
      RunParti({"derive", File(kHouse), "--reports", folder + "/a.json", "--stats"});
  EXPECT_EQ(none.status, 1);
  EXPECT_THAT(none.errors, HasSubstr("the rules report nothing"));
  EXPECT_FALSE(std::filesystem::exists(folder + "/a.json"));
  const ProgramRun wrong = RunParti({"derive", File(kHouse), "--reports", folder + "/a.xls"});
  EXPECT_EQ(wrong.status, 2);
  EXPECT_THAT(wrong.errors, HasSubstr("written to .csv, .json, not to"));
}

TEST(DeriveCommand, WhatRulesPrintGoesToStandardErrorAlsoWhereTheyFail) {
  const std::string rules = File(
      "Lot --> extrude(3) split(y) { ~1: print(split.index) A }*\nA --> case split.index < 2: B "
      "else: print(\"fails\") t(0 / 0, 0, 0) C\n");
  const ProgramRun run = RunParti({"derive", rules, "--stats"});
  EXPECT_EQ(run.status, 1);
  EXPECT_EQ(run.output, "");
  EXPECT_THAT(run.errors, HasSubstr("house.cga:1:35: rule Lot: 2\n"));
  EXPECT_THAT(run.errors, HasSubstr("house.cga:2:37: rule A: fails\n"));
  EXPECT_THAT(run.errors, HasSubstr("error: rule A: t: "));
}

}  // namespace
}  // namespace parti::app
