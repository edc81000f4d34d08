#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cli/commands.h"
#include "cli/usage.h"

namespace overstrike {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::Pair;
using testing::StartsWith;

template <class Kind>
Kind parsed(const std::vector<std::string>& words) {
  return std::get<Kind>(parse_command_line(words));
}

std::string error_of(const std::vector<std::string>& words) {
  try {
    parse_command_line(words);
  } catch (const UsageError& error) {
    return error.what();
  }
  return "no error";
}

TEST(Parse, RenderTakesItsOptionsInAnyOrder) {
  const auto command =
      parsed<RenderCommand>({"render", "--size", "135x180", "-o", "a.txt", "scene.yaml", "--stream",
                             "asa", "--method", "nn74", "--tolerance", "0.1", "--threads=2", "-v"});
  EXPECT_EQ(command.scene, "scene.yaml");
  EXPECT_EQ(command.output, "a.txt");
  EXPECT_EQ(command.method, Method::nn74);
  EXPECT_EQ(command.tolerance, 0.1);
  EXPECT_EQ(command.threads, 2);
  EXPECT_TRUE(command.verbose);
  EXPECT_THAT(command.settings, ElementsAre(Pair("size", "135x180"), Pair("stream", "asa")));
}

TEST(Parse, NegativeNumbersAreValues) {
  for (const auto& words :
       std::vector<std::vector<std::string>>{{"render", "s.yaml", "--light", "-20,45"},
                                             {"render", "--light=-20,45", "s.yaml"},
                                             {"render", "--light", "-20,45", "s.yaml"}}) {
    const auto command = parsed<RenderCommand>(words);
    EXPECT_EQ(command.scene, "s.yaml");
    EXPECT_EQ(command.changes.light->azimuth_deg, -20);
  }
  EXPECT_EQ(parsed<RenderCommand>({"render", "-", "--ground", "-.5"}).changes.ground_z, -0.5);
}

TEST(Parse, StandardStreamsAreDashes) {
  const auto command =
      parsed<RenderCommand>({"render", "-", "--format", "stl", "-o", "-", "-d", "image"});
  EXPECT_EQ(command.scene, "-");
  EXPECT_EQ(command.output, "-");
  EXPECT_EQ(command.format, "stl");
  EXPECT_EQ(command.device, "image");
}

TEST(Parse, SettingsAreForwardedAsTheyStand) {
  const auto command = parsed<RenderCommand>(
      {"render", "--set", "paper=A4", "s.yaml", "--set", "pen=a=b", "--lpi", "8"});
  EXPECT_EQ(command.scene, "s.yaml");
  EXPECT_THAT(command.settings,
              ElementsAre(Pair("lpi", "8"), Pair("paper", "A4"), Pair("pen", "a=b")));
  EXPECT_EQ(error_of({"render", "s.yaml", "--set", "paper"}),
            "--set: expected NAME=VALUE, found 'paper'");
}

TEST(Parse, TheLastOfARepeatedOptionCounts) {
  EXPECT_EQ(parsed<RenderCommand>({"render", "s", "-o", "a", "-o", "b"}).output, "b");
}

TEST(Parse, TimingsAreTextOrJson) {
  EXPECT_EQ(parsed<RenderCommand>({"render", "s"}).timings, TimingsFormat::none);
  EXPECT_EQ(parsed<RenderCommand>({"render", "--timings", "s"}).timings, TimingsFormat::text);
  EXPECT_EQ(parsed<RenderCommand>({"render", "--timings=json", "s"}).timings, TimingsFormat::json);
  EXPECT_EQ(error_of({"render", "--timings=xml", "s"}),
            "--timings: expected nothing or =json, found 'xml'");
}

TEST(Parse, EmulateCheckAndDevices) {
  const auto emulate =
      parsed<EmulateCommand>({"emulate", "line-printer", "-", "-o", "p.png", "--lpi", "8"});
  EXPECT_EQ(emulate.machine, "line-printer");
  EXPECT_EQ(emulate.input, "-");
  EXPECT_EQ(emulate.output, "p.png");
  EXPECT_THAT(emulate.settings, ElementsAre(Pair("lpi", "8")));
  EXPECT_EQ(parsed<CheckCommand>({"check", "s.yaml"}).scene, "s.yaml");
  EXPECT_EQ(parsed<DevicesCommand>({"devices"}).name, "");
  EXPECT_EQ(parsed<DevicesCommand>({"devices", "plotter"}).name, "plotter");
}

TEST(Parse, HelpAndVersionAreTexts) {
  EXPECT_THAT(parsed<TextCommand>({"--version"}).text, StartsWith("overstrike "));
  EXPECT_THAT(parsed<TextCommand>({"--help"}).text, HasSubstr("emulate"));
  EXPECT_THAT(parsed<TextCommand>({"render", "--help"}).text, HasSubstr("--azimuth DEG"));
  EXPECT_THAT(parsed<TextCommand>({"devices", "-h"}).text, HasSubstr("overstrike devices"));
}

TEST(Parse, SlipsAreNamedWithWhatWasMeant) {
  EXPECT_EQ(error_of({"rendr", "s"}), "unknown subcommand 'rendr' (did you mean 'render'?)");
  EXPECT_EQ(error_of({"render", "s", "--ligth", "-20,45"}),
            "unknown option '--ligth' (did you mean '--light'?)");
  EXPECT_EQ(error_of({"render", "s", "--tresholds=3"}), "unknown option '--tresholds'");
  EXPECT_EQ(error_of({"render", "s", "--method", "nn47"}),
            "--method: expected auto, line or nn74, found 'nn47' (did you mean 'nn74'?)");
  EXPECT_EQ(error_of({"render", "a.yaml", "b.yaml"}), "unexpected word 'b.yaml'");
  EXPECT_EQ(error_of({"--lihgt"}), "unknown option '--lihgt'");
}

TEST(Parse, WhatIsMissingIsNamed) {
  EXPECT_EQ(error_of({}), "a subcommand is missing: render, watch, emulate, check or devices");
  EXPECT_EQ(error_of({"render"}), "SCENE is missing");
  EXPECT_EQ(error_of({"check"}), "SCENE is missing");
  EXPECT_EQ(error_of({"emulate", "plotter"}), "FILE is missing");
  EXPECT_EQ(error_of({"emulate", "plotter", "a.hpgl"}), "-o FILE is missing");
  EXPECT_EQ(error_of({"render", "s", "--size="}), "--size: a value is missing");
  EXPECT_EQ(error_of({"render", "s", "--eye", ""}), "--eye: a value is missing");
  EXPECT_EQ(error_of({"render", "s", "--light"}), "--light: 1 required AZ,EL missing");
}

TEST(Parse, NumbersOutOfBoundsAreRefused) {
  EXPECT_EQ(error_of({"render", "s", "--threads", "-1"}),
            "--threads: expected N from 0 (all processors) to 1024, found '-1'");
  EXPECT_EQ(error_of({"render", "s", "--tolerance", "0"}),
            "--tolerance: expected T in cells, above 0 and at most 100, found '0'");
}

}  // namespace
}  // namespace overstrike
