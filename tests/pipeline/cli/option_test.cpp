// What the command line takes, and what it refuses in one line with exit code 2.
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/pipeline/cli/command_run.hpp"

namespace quarry {
namespace {

void expect_usage_error(const std::vector<std::string>& arguments, const std::string& word) {
  const CommandResult result = run_quarry(arguments);
  EXPECT_EQ(result.exit_code, 2) << result.err;
  EXPECT_EQ(result.error_lines(), 1U) << result.err;
  EXPECT_EQ(result.out, "");
  EXPECT_NE(result.err.find(word), std::string::npos) << word << " in " << result.err;
}

nlohmann::json options_of(const std::string& report) {
  return nlohmann::json::parse(read_text(report))["options"];
}

TEST(CommandLine, VersionAndHelpAreResults) {
  for (const std::vector<std::string>& arguments : {std::vector<std::string>{"--version"},
                                                    {"--help"},
                                                    {"mesh", "--help"},
                                                    {"clean", "--help"},
                                                    {"improve", "--help"},
                                                    {"quality", "--help"},
                                                    {"convert", "--help"},
                                                    {"picture", "--help"},
                                                    {"generate", "--help"},
                                                    {"generate", "fractures", "--help"},
                                                    {"generate", "layers", "--help"}}) {
    const CommandResult result = run_quarry(arguments);
    EXPECT_EQ(result.exit_code, 0) << arguments[0];
    EXPECT_NE(result.out, "") << arguments[0];
    EXPECT_EQ(result.err, "") << arguments[0];
  }
}

TEST(CommandLine, MistakesAreToldInOneLine) {
  expect_usage_error({}, "--help");
  expect_usage_error({"melt", "a.geojson"}, "melt");
  expect_usage_error({"--frobnicate"}, "--frobnicate");
  expect_usage_error({"mesh", "-o", "out.vtu", "--size", "5"}, "input");
  expect_usage_error({"mesh", kDemoSection, "--size", "5"}, "output");
  expect_usage_error({"mesh", kDemoSection, "-o", "out.vtu", "--sise", "5"}, "--sise");
  expect_usage_error({"mesh", kDemoSection, "-o", "out.vtu", "--size"}, "--size");
  expect_usage_error({"mesh", kDemoSection, "-o", "out.vtu", "--size", "5", "--threads", "-1"}, "--threads");
  expect_usage_error({"mesh", kDemoSection, "-o", "out.vtu", "--size", "5", "--elements", "hex"}, "hex");
  expect_usage_error({"mesh", kDemoSection, "-o", "out.vtu", "--size", "5", "--orient", "north"}, "north");
  expect_usage_error({"mesh", kDemoSection, "-o", "out.vtu", "--size", "5", "--max-elements", "0"},
                     "--max-elements");
  expect_usage_error({"mesh", kDemoSection, "-o", "out.vtu", "--size", "5", "--max-elements", "1e10"},
                     "--max-elements");
  for (const std::string seed : {"-1", "1.5", "x"})
    expect_usage_error({"mesh", kDemoSection, "-o", "out.vtu", "--size", "5", "--seed", seed}, "--seed");
  expect_usage_error({"clean", kDemoSection, "-o", "out.geojson"}, "--snap");
}

TEST(CommandLine, MistakesInGenerateAreToldInOneLine) {
  expect_usage_error({"generate"}, "quarry generate --help");
  expect_usage_error({"generate", "karst", "-o", "out.geojson"}, "karst");
  expect_usage_error({"generate", "fractures", "--count", "10"}, "-o");
  expect_usage_error({"generate", "fractures", "--count", "10", "-o", "out.vtu"}, "out.vtu");
  expect_usage_error({"generate", "fractures", "-o", "out.geojson"}, "--count");
  expect_usage_error({"generate", "fractures", "--count", "-1", "-o", "out.geojson"}, "--count");
  expect_usage_error({"generate", "fractures", "--count", "10", "--box", "10", "-o", "out.geojson"}, "--box");
  for (const std::string set : {"", "north", "10:", "10:x", "10:1:1:1"})
    expect_usage_error({"generate", "fractures", "--count", "10", "--set", set, "-o", "out.geojson"},
                       "--set");
  expect_usage_error({"generate", "layers", "--dip", "0", "-o", "out.geojson"}, "--dip");
}

TEST(CommandLine, GenerateDrawsWhatMeshReads) {
  const TestFolder folder;
  for (const std::vector<std::string>& model :
       {std::vector<std::string>{"fractures", "--p21", "0.02", "--set", "20:40", "--set", "95:40:0.5",
                                 "--curved"},
        std::vector<std::string>{"layers", "--outline", "--origin", "466000,6691000"}}) {
    std::vector<std::string> arguments = {"generate", model[0], "-o", folder / "model.geojson", "--quiet"};
    arguments.insert(arguments.end(), model.begin() + 1, model.end());
    const CommandResult drawn = run_quarry(arguments);
    EXPECT_EQ(drawn.exit_code, 0) << drawn.err;
    EXPECT_EQ(drawn.err, "");
    const CommandResult meshed =
        run_quarry({"mesh", folder / "model.geojson", "-o", folder / "out.vtu", "--size", "30", "--quiet"});
    EXPECT_EQ(meshed.exit_code, 0) << meshed.err;
  }
}

TEST(CommandLine, FormatsThatCannotHoldWhatIsAskedAreToldBeforeTheWork) {
  expect_usage_error({"mesh", kDemoSection, "-o", "out.obj", "--size", "5", "--order", "2"}, "second order");
  expect_usage_error({"mesh", kDemoSection, "-o", "out.inp", "--size", "5", "--order", "2-full"},
                     "second order");
  expect_usage_error({"mesh", kDemoSection, "-o", "out.vtu", "--size", "5", "--order", "3"}, "--order");
  expect_usage_error({"mesh", kDemoSection, "-o", "out.vtu", "--size", "5", "--for", "moose"}, "out.vtu");
  expect_usage_error({"convert", "in.vtu", "out.msh", "--for", "ogs"}, "out.msh");
  expect_usage_error({"convert", "in.vtkhdf", "out.msh"}, "is written and not read");
  expect_usage_error(
      {"mesh", "tests/data/demo_horizon.obj", "-o", "out.vtu", "--size", "50", "--split-fractures"},
      "--split-fractures");
}

TEST(CommandLine, WhatChangesTheFileStandsInIt) {
  const TestFolder folder;
  ASSERT_EQ(run_quarry({"mesh", kDemoSection, "-o", folder / "out.msh", "--size", "30", "--order", "2",
                        "--split-fractures", "--quiet"})
                .exit_code,
            0);
  const std::string text = read_text(folder / "out.msh");
  EXPECT_NE(text.find("seed=0 order=2 split-fractures=1\n"), std::string::npos) << text.substr(0, 600);
}

TEST(CommandLine, UnknownOutputExtensionsAreToldBeforeTheWork) {
  expect_usage_error({"mesh", kDemoSection, "-o", "out.xyz", "--size", "5"}, "out.xyz");
  expect_usage_error({"mesh", kDemoSection, "-o", "out", "--size", "5"}, "out");
  expect_usage_error({"clean", kDemoSection, "-o", "out.vtu", "--size", "5"}, "out.vtu");
  expect_usage_error({"convert", "in.vtu", "out.xyz"}, "out.xyz");
}

TEST(CommandLine, WhatIsNotBuiltSaysSo) {
  const std::vector<std::vector<std::string>> values = {
      {"--method", "front"},
      {"--method", "blocks"},
      {"--quads", "field"},
  };
  for (const std::vector<std::string>& value : values) {
    std::vector<std::string> arguments = {"mesh", kDemoSection, "-o", "out.vtu", "--size", "20"};
    arguments.insert(arguments.end(), value.begin(), value.end());
    expect_usage_error(arguments, "not built yet");
  }
  expect_usage_error({"adapt"}, "not built yet");
  expect_usage_error({"adapt", "some", "--option", "3"}, "not built yet");
}

TEST(MixedElements, AreQuadsAndFewTriangles) {
  const TestFolder folder;
  const CommandResult result =
      run_quarry({"mesh", kDemoSection, "-o", folder / "out.msh", "--size", "20", "--elements", "mixed",
                  "--mixed-quality", "0.6", "--require", "mean-sj=0.5", "--report", folder / "r.json",
                  "--picture", folder / "out.svg"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const nlohmann::json report = nlohmann::json::parse(read_text(folder / "r.json"));
  EXPECT_EQ(report["options"]["elements"], "mixed");
  EXPECT_EQ(report["options"]["mixed-quality"], 0.6);
  const std::size_t cut = report["counts"]["quads_cut"];
  EXPECT_GT(cut, 0U);
  EXPECT_LE(cut, report["counts"]["quads_below_quality"].get<std::size_t>());
  EXPECT_EQ(report["counts"]["triangles"], 2 * cut);
  EXPECT_EQ(report["quality"]["of_triangles"]["faces"], 2 * cut);
  EXPECT_GT(report["quality"]["of_quads"]["faces"], 10 * cut);
  for (const char* format : {"out.vtu", "out.obj", "out.inp"}) {
    ASSERT_EQ(run_quarry({"convert", folder / "out.msh", folder / format}).exit_code, 0) << format;
    const CommandResult quality = run_quarry({"quality", folder / format, "--json"});
    EXPECT_EQ(nlohmann::json::parse(quality.out)["triangles"], 2 * cut) << format;
  }
}

TEST(MixedElements, AloneHaveAQuality) {
  expect_usage_error({"mesh", kDemoSection, "-o", "out.vtu", "--size", "20", "--mixed-quality", "0.3"},
                     "--elements mixed");
  for (const std::string quality : {"-0.1", "1.5", "x"})
    expect_usage_error({"mesh", kDemoSection, "-o", "out.vtu", "--size", "20", "--elements", "mixed",
                        "--mixed-quality", quality},
                       "--mixed-quality");
  expect_usage_error(
      {"mesh", kDemoSection, "-o", "out.vtu", "--size", "20", "--elements", "mixed", "--keep-boundary"},
      "--quads matching");
}

TEST(Annealing, IsToldInTheReportAndNeedsMatching) {
  const TestFolder folder;
  ASSERT_EQ(run_quarry({"mesh", kDemoSection, "-o", folder / "out.vtu", "--size", "20", "--quads", "matching",
                        "--anneal", "10", "--report", folder / "r.json"})
                .exit_code,
            0);
  EXPECT_EQ(options_of(folder / "r.json")["anneal"], 10);
  EXPECT_GT(nlohmann::json::parse(read_text(folder / "r.json"))["counts"]["annealing_moves"], 0);
  expect_usage_error({"mesh", kDemoSection, "-o", "out.vtu", "--size", "20", "--anneal", "10"}, "matching");
  expect_usage_error({"mesh", kDemoSection, "-o", "out.vtu", "--size", "20", "--quads", "matching",
                      "--elements", "tri", "--anneal", "10"},
                     "--anneal");
  expect_usage_error({"mesh", kDemoSection, "-o", "out.vtu", "--size", "20", "--anneal", "-1"}, "--anneal");
}

TEST(IrregularPrice, IsTakenByMeshAndImprove) {
  const TestFolder folder;
  const std::string raster =
      folder.write("p.asc", "ncols 1\nnrows 1\nxllcorner 0\nyllcorner 0\ncellsize 400\n9\n");
  const auto run = [&](const std::vector<std::string>& words, const std::string& price) {
    std::vector<std::string> arguments = words;
    arguments.insert(arguments.end(), {"--irregular-price", price, "--report", folder / "r.json", "--quiet"});
    const CommandResult result = run_quarry(arguments);
    EXPECT_EQ(result.exit_code, 0) << result.err;
    return options_of(folder / "r.json")["irregular-price"].get<std::string>();
  };
  const std::vector<std::string> mesh = {"mesh", kDemoSection, "-o", folder / "a.vtu", "--size", "20"};
  EXPECT_EQ(run(mesh, "lines:40:5"), "lines:40:5");
  EXPECT_EQ(run(mesh, raster), "file");
  const std::vector<std::string> improve = {"improve", folder / "a.vtu", "-o", folder / "b.vtu"};
  EXPECT_EQ(run(improve, "lines:40:5"), "lines:40:5");
  EXPECT_EQ(run(improve, raster), "file");
}

TEST(IrregularPrice, IsRefusedWhereItMakesNoSense) {
  const TestFolder folder;
  const std::vector<std::string> mesh = {"mesh", kDemoSection, "-o", folder / "out.vtu", "--size", "20"};
  const auto refused = [&](const std::vector<std::string>& more, const std::string& word) {
    std::vector<std::string> arguments = mesh;
    arguments.insert(arguments.end(), more.begin(), more.end());
    expect_usage_error(arguments, word);
  };
  refused({"--irregular-price", "lines:40"}, "lines:DISTANCE:FACTOR");
  refused({"--irregular-price", "lines:40:5", "--cleanup", "none"}, "clean-up");
  refused({"--irregular-price", "lines:40:5", "--elements", "tri"}, "clean-up");
  const std::string raster =
      folder.write("p.asc", "ncols 2\nnrows 1\nxllcorner 0\nyllcorner 0\ncellsize 400\n9 -3\n");
  std::vector<std::string> arguments = mesh;
  arguments.insert(arguments.end(), {"--irregular-price", raster});
  const CommandResult result = run_quarry(arguments);
  EXPECT_EQ(result.exit_code, 3);
  EXPECT_EQ(result.error_lines(), 1U) << result.err;
  EXPECT_NE(result.err.find("row 1, column 2"), std::string::npos) << result.err;
}

TEST(ConfigFile, GivesWhatTheCommandLineDoesNot) {
  const TestFolder folder;
  const std::string config = folder.write("job.toml",
                                          "size = 20\nelements = \"tri\"\nseed = 7\nquiet = true\n"
                                          "inputs = [\"" +
                                              std::string(kDemoSection) + "\"]\n");
  const CommandResult result = run_quarry(
      {"mesh", "-o", folder / "out.vtu", "--config", config, "--seed", "3", "--report", folder / "r.json"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(result.err, "");
  const nlohmann::json options = options_of(folder / "r.json");
  EXPECT_EQ(options["size"], 20.0);
  EXPECT_EQ(options["elements"], "tri");
  EXPECT_EQ(options["seed"], 3) << "the command line wins";
}

TEST(ConfigFile, MakesTheSameMeshAsTheCommandLine) {
  const TestFolder folder;
  const std::string config = folder.write("job.toml", "size = 20.5\nsnap = 0.75\nboundary = \"box\"\n");
  ASSERT_EQ(run_quarry({"mesh", kDemoSection, "-o", folder / "a.vtu", "--config", config}).exit_code, 0);
  ASSERT_EQ(run_quarry({"mesh", kDemoSection, "-o", folder / "b.vtu", "--size", "20.5", "--snap", "0.75",
                        "--boundary", "box"})
                .exit_code,
            0);
  EXPECT_EQ(read_text(folder / "a.vtu"), read_text(folder / "b.vtu"));
}

TEST(ConfigFile, NamesWhatItCannotUse) {
  const TestFolder folder;
  const auto expect_refused = [&](const std::string& text, const std::string& word) {
    const std::string config = folder.write("job.toml", text);
    expect_usage_error({"mesh", kDemoSection, "-o", folder / "out.vtu", "--config", config}, word);
  };
  expect_refused("size = 20\nsise = 3\n", "sise");
  expect_refused("size = \"wide\"\n", "size");
  expect_refused("size = 2020-01-01\n", "size");
  expect_refused("seed = -1\nsize = 20\n", "seed");
  expect_refused("config = \"other.toml\"\n", "config");
  const CommandResult broken = run_quarry({"mesh", kDemoSection, "-o", folder / "out.vtu", "--config",
                                           folder.write("broken.toml", "size = = 3\n")});
  EXPECT_EQ(broken.exit_code, 3);
  EXPECT_EQ(broken.error_lines(), 1U) << broken.err;
  EXPECT_EQ(run_quarry({"mesh", kDemoSection, "-o", folder / "out.vtu", "--config", folder / "none.toml"})
                .exit_code,
            3);
}

TEST(Demands, AMeshThatFailsOneIsNotWritten) {
  const TestFolder folder;
  const std::string output = folder.write("out.vtu", "what was there before");
  const CommandResult result = run_quarry({"mesh", kDemoSection, "-o", output, "--size", "20", "--require",
                                           "mean-sj=0.1,min-sj=0.999", "--report", folder / "r.json"});
  EXPECT_EQ(result.exit_code, 6);
  EXPECT_EQ(result.error_lines(), 1U) << result.err;
  EXPECT_NE(result.err.find("min-sj=0.999"), std::string::npos) << result.err;
  EXPECT_NE(result.err.find(" at ("), std::string::npos) << "the worst place is told: " << result.err;
  EXPECT_EQ(read_text(output), "what was there before");
  EXPECT_TRUE(nlohmann::json::parse(read_text(folder / "r.json")).contains("quality"));
}

TEST(Demands, ThatAreMetChangeNothing) {
  const TestFolder folder;
  const CommandResult result =
      run_quarry({"mesh", kDemoSection, "-o", folder / "out.vtu", "--size", "20", "--require", "irregular=60",
                  "--require", "mean-sj=0.2,aspect=1e6"});
  EXPECT_EQ(result.exit_code, 0) << result.err;
}

TEST(Demands, UnknownFiguresAreToldBeforeTheWork) {
  expect_usage_error({"mesh", kDemoSection, "-o", "out.vtu", "--size", "20", "--require", "beauty=3"},
                     "beauty");
  expect_usage_error({"mesh", kDemoSection, "-o", "out.vtu", "--size", "20", "--require", "min-sj"},
                     "min-sj");
  expect_usage_error({"mesh", kDemoSection, "-o", "out.vtu", "--size", "20", "--require", "min-sj=x"},
                     "min-sj=x");
}

TEST(Report, HoldsTheResolvedOptions) {
  const TestFolder folder;
  ASSERT_EQ(run_quarry({"mesh", kDemoSection, "-o", folder / "out.vtu", "--count", "1000", "--report",
                        folder / "r.json"})
                .exit_code,
            0);
  const nlohmann::json options = options_of(folder / "r.json");
  const double size = options["size"];
  EXPECT_GT(size, 10);
  EXPECT_LT(size, 70)
      << "the lines ask for more elements than their area: sizes are up to thrice what that tells";
  EXPECT_DOUBLE_EQ(options["snap"].get<double>(), 0.05 * size);
  EXPECT_DOUBLE_EQ(options["min-edge"].get<double>(), 0.1 * size);
  EXPECT_DOUBLE_EQ(options["tolerance"].get<double>(), 0.05 * size);
  EXPECT_EQ(options["method"], "deferred");
}

TEST(Streams, StdoutCarriesOnlyWhatWasAskedFor) {
  const TestFolder folder;
  const CommandResult mesh = run_quarry({"mesh", kDemoSection, "-o", folder / "out.vtu", "--size", "20"});
  EXPECT_EQ(mesh.out, "");
  EXPECT_NE(mesh.err.find("quads"), std::string::npos);
  EXPECT_EQ(mesh.err.find('\r'), std::string::npos) << "a progress bar is for terminals";
  const CommandResult quality = run_quarry({"quality", folder / "out.vtu", "--json"});
  EXPECT_EQ(quality.exit_code, 0);
  EXPECT_EQ(quality.err, "");
  EXPECT_GT(nlohmann::json::parse(quality.out)["quads"], 0);
  EXPECT_EQ(run_quarry({"mesh", kDemoSection, "-o", folder / "q.vtu", "--size", "20", "--quiet"}).err, "");
}

}  // namespace
}  // namespace quarry
