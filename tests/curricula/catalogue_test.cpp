#include "curricula/catalogue.h"

#include <cmath>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <string>

#include <gtest/gtest.h>
#include <unistd.h>

#include "assessment/metrics.h"
#include "curricula/read_catalogue.h"
#include "curricula/sha256.h"
#include "tests/curricula/valid_curriculum.h"

namespace {

namespace fs = std::filesystem;

using curricula::load_library;
using curricula::read_anatomy;
using curricula::read_instrument;
using test::replaced;

const std::string kWire = R"(schema: cathedra-instrument/1
id: wire
title: "A wire"
kind: guidewire
outer_diameter_mm: 0.9
inner_diameter_mm: 0
sections:
  - {length_mm: 100, bending_stiffness_n_mm2: 20, twist_stiffness_n_mm2: 15}
  - {length_mm: 900, bending_stiffness_n_mm2: 300, twist_stiffness_n_mm2: 230}
tip: {shape: angled, bends: [{from_tip_mm: 2, length_mm: 8, angle_deg: 45}]}
friction: 0.1
sources: {stiffness: "a", friction: "b", shape: "c"}
)";

const std::string kTube = R"(schema: cathedra-anatomy/1
id: tube
title: "A tube"
surface: {voxel_mm: 0.5}
access: {position_mm: [1, 2, 3], direction: [0, 3, 4], radius_mm: 4}
legs:
  - {length_mm: 100, radius_mm: 4}
  - {length_mm: 80, bend_deg: -90, plane_deg: 30, radius_mm: 3}
sources: {radius: "a", shape: "b"}
)";

TEST(Sha256, MatchesThePublishedExamples) {
  // FIPS 180-4, and the well-known fingerprint of nothing
  EXPECT_EQ(curricula::sha256_hex(""),
            "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
  EXPECT_EQ(curricula::sha256_hex("abc"),
            "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
}

TEST(Instrument, IsReadInTheUnitsOfTheProgram) {
  const auto entry = read_instrument(kWire);
  ASSERT_TRUE(entry.spec.has_value()) << entry.problems[0].message;
  EXPECT_EQ(entry.spec->id, "wire");
  EXPECT_EQ(entry.spec->title, "A wire");
  EXPECT_EQ(entry.spec->kind, "guidewire");
  EXPECT_EQ(entry.spec->outer_diameter, 0.9);
  EXPECT_EQ(entry.spec->inner_diameter, 0.0);
  ASSERT_EQ(entry.spec->sections.size(), 2U);
  EXPECT_EQ(entry.spec->sections[0].bending_stiffness, 20.0);
  EXPECT_EQ(entry.spec->sections[1].twist_stiffness, 230.0);
  EXPECT_EQ(entry.spec->length(), 1000.0);
  ASSERT_EQ(entry.spec->tip_bends.size(), 1U);
  EXPECT_DOUBLE_EQ(entry.spec->tip_bends[0].angle, std::numbers::pi / 4.0);
  EXPECT_EQ(entry.spec->friction, 0.1);
  EXPECT_EQ(entry.spec->source, "stiffness: a; friction: b; shape: c");
  EXPECT_EQ(entry.spec->sha256, curricula::sha256_hex(kWire));
}

TEST(Anatomy, IsReadInTheUnitsOfTheProgram) {
  const auto entry = read_anatomy(kTube);
  ASSERT_TRUE(entry.spec.has_value()) << entry.problems[0].message;
  EXPECT_EQ(entry.spec->access, (std::array{1.0, 2.0, 3.0}));
  EXPECT_DOUBLE_EQ(entry.spec->direction[1], 0.6);  // made a unit vector
  EXPECT_DOUBLE_EQ(entry.spec->direction[2], 0.8);
  EXPECT_EQ(entry.spec->start_radius, 4.0);
  EXPECT_EQ(entry.spec->voxel, 0.5);
  ASSERT_EQ(entry.spec->legs.size(), 2U);
  EXPECT_EQ(entry.spec->legs[0].bend, 0.0);
  EXPECT_DOUBLE_EQ(entry.spec->legs[1].bend, -std::numbers::pi / 2.0);
  EXPECT_DOUBLE_EQ(entry.spec->legs[1].plane, std::numbers::pi / 6.0);
  EXPECT_EQ(entry.spec->legs[1].radius, 3.0);
  EXPECT_EQ(entry.spec->length(), 180.0);
}

struct Broken {
  const char* from;
  const char* to;
  int line;
  const char* says;
};

TEST(Instrument, SaysWhatIsWrongWhere) {
  const Broken cases[] = {
      {"friction: 0.1", "friction: wet", 11, "must be a number"},
      {"outer_diameter_mm: 0.9", "outer_diameter: 0.9", 5,
       "lacks its unit: write 'outer_diameter_mm'"},
      {"length_mm: 100", "length: 100", 8, "lacks its unit: write 'length_mm'"},
      {"kind: guidewire", "kind: wire", 4, "guidewire or catheter"},
      {"length_mm: 900", "length_mm: 400", 8, "make it at least 600"},
      {"inner_diameter_mm: 0", "inner_diameter_mm: 1", 6, "smaller than the outer one"},
      {"shape: angled, bends: [{from_tip_mm: 2, length_mm: 8, angle_deg: 45}]", "shape: angled", 10,
       "needs its 'bends'"},
      {"shape: angled", "shape: straight", 10, "has no bends"},
      {"angle_deg: 45}", "angle_deg: 45}, {from_tip_mm: 9, length_mm: 2, angle_deg: 5}", 10,
       "overlaps"},
      {"stiffness: \"a\", ", "", 12, "needs 'stiffness'"},
      {"bending_stiffness_n_mm2: 300", "bending_stiffness_n_mm2: 0", 9, "above 0"},
      {"title:", "colour: red\ntitle:", 3, "no 'colour'"},
  };
  for (const Broken& broken : cases) {
    const auto entry = read_instrument(replaced(kWire, broken.from, broken.to));
    EXPECT_FALSE(entry.spec.has_value()) << broken.to;
    ASSERT_EQ(entry.problems.size(), 1U) << broken.to << ": " << entry.problems[1].message;
    EXPECT_EQ(entry.problems[0].line, broken.line) << broken.to;
    EXPECT_NE(entry.problems[0].message.find(broken.says), std::string::npos)
        << entry.problems[0].message;
  }
}

TEST(Anatomy, SaysWhatIsWrongWhere) {
  const Broken cases[] = {
      {"bend_deg: -90", "bend: -90", 8, "lacks its unit: write 'bend_deg'"},
      {"bend_deg: -90", "bend_deg: 1.6", 8, ""},  // gentle: fine
      {"length_mm: 80", "length_mm: 4", 8, "tighter than the lumen"},
      {"direction: [0, 3, 4]", "direction: [0, 0, 0]", 5, "has no length"},
      {"direction: [0, 3, 4]", "direction: [0, 3]", 5, "three numbers"},
      {"position_mm: [1, 2, 3]", "position_mm: [1, two, 3]", 5, "must be a number"},
      {"radius_mm: 3", "radius_mm: .inf", 8, "finite"},
      {"radius: \"a\", ", "", 9, "needs 'radius'"},
      {"anatomy/1", "anatomy/9", 1, "write cathedra-anatomy/1"},
  };
  for (const Broken& broken : cases) {
    const auto entry = read_anatomy(replaced(kTube, broken.from, broken.to));
    const bool fine = *broken.says == '\0';
    EXPECT_EQ(entry.spec.has_value(), fine) << broken.to;
    ASSERT_EQ(entry.problems.size(), fine ? 0U : 1U) << broken.to;
    if (fine) continue;
    EXPECT_EQ(entry.problems[0].line, broken.line) << broken.to;
    EXPECT_NE(entry.problems[0].message.find(broken.says), std::string::npos)
        << entry.problems[0].message;
  }
}

class BuiltInLibrary : public testing::Test {
 protected:
  void SetUp() override {
    auto loaded = load_library(std::string(CATHEDRA_SOURCE_DIR) + "/curricula");
    ASSERT_TRUE(loaded.has_value()) << loaded.error().message;
    library = std::move(*std::move(loaded));
  }
  curricula::Library library;
};

TEST_F(BuiltInLibrary, HasTheCatalogueAndTheTwoTasks) {
  EXPECT_NE(library.instrument("guidewire-035-straight"), nullptr);
  EXPECT_NE(library.instrument("guidewire-035-angled"), nullptr);
  EXPECT_NE(library.instrument("catheter-5f-angled"), nullptr);
  EXPECT_NE(library.anatomy("straight-phantom"), nullptr);
  EXPECT_NE(library.anatomy("s-bend-phantom"), nullptr);
  EXPECT_EQ(library.instrument("nothing"), nullptr);
  ASSERT_EQ(library.curricula.size(), 1U);
  EXPECT_EQ(library.curricula[0].id, "vascular-basics");
  EXPECT_NE(library.curricula[0].find("linear"), nullptr);
  EXPECT_NE(library.curricula[0].find("rotational"), nullptr);
}

TEST_F(BuiltInLibrary, ChecksWithoutErrorOrWarning) {
  const auto result = curricula::check(library.curricula[0].yaml, library.catalogue());
  EXPECT_TRUE(result.ok());
  for (const auto& problem : result.problems)
    ADD_FAILURE() << problem.line << ": " << problem.message;
}

TEST_F(BuiltInLibrary, TheLinearTaskCommands750Millimetres) {
  // the paper's feed of 350, retraction of 200, feed of 200 mm
  double travel = 0.0, at = 0.0;
  for (const auto& step : curricula::unroll(library.curricula[0].find("linear")->steps)) {
    travel += std::abs(step.target - at);
    at = step.target;
  }
  EXPECT_EQ(travel, 750.0);
}

TEST_F(BuiltInLibrary, TheRotationalTaskCommandsTwelveTurns) {
  double travel = 0.0, at = 0.0;
  const auto steps = curricula::unroll(library.curricula[0].find("rotational")->steps);
  for (const auto& step : steps) {
    travel += std::abs(step.target - at);
    at = step.target;
  }
  EXPECT_EQ(steps.size(), 12U);
  EXPECT_NEAR(travel, 12.0 * 2.0 * std::numbers::pi, 1e-12);
}

TEST_F(BuiltInLibrary, TheSBendIsLongEnoughAndBendsNoMoreThanHalfATurn) {
  const auto* phantom = library.anatomy("s-bend-phantom");
  double bend = 0.0;
  for (const auto& leg : phantom->legs) bend += std::abs(leg.bend);
  EXPECT_GE(phantom->length(), 450.0);
  EXPECT_LE(bend, std::numbers::pi);
}

TEST_F(BuiltInLibrary, ShaftStiffnessIsThatOfTheCitedModulus) {
  // 9.5 GPa, 0.035 inch: EI = E pi d^4 / 64 = 291 N mm^2 (Harrison et al. 2011), to the unit given
  const double expected = 9500.0 * std::numbers::pi * std::pow(0.889, 4) / 64.0;
  EXPECT_NEAR(library.instrument("guidewire-035-straight")->sections.back().bending_stiffness,
              expected, 0.5);
  // a tube of 390 MPa, 5F outside and 0.038 inch inside
  const double tube = 390.0 * std::numbers::pi * (std::pow(1.667, 4) - std::pow(0.965, 4)) / 64.0;
  EXPECT_NEAR(library.instrument("catheter-5f-angled")->sections.back().bending_stiffness, tube,
              0.5);
}

TEST_F(BuiltInLibrary, EveryInstrumentIsStifferTowardsTheBack) {
  for (const auto& instrument : library.instruments) {
    for (std::size_t i = 1; i < instrument.sections.size(); ++i) {
      EXPECT_GT(instrument.sections[i].bending_stiffness,
                instrument.sections[i - 1].bending_stiffness)
          << instrument.id;
      // no isotropic round section twists more stiffly than it bends
      EXPECT_LT(instrument.sections[i].twist_stiffness, instrument.sections[i].bending_stiffness);
    }
  }
}

// A library of our own in a folder that goes away with the test.
class OwnLibrary : public testing::Test {
 protected:
  void SetUp() override {
    root = fs::temp_directory_path() / ("cathedra-catalogue-test-" + std::to_string(::getpid()));
    fs::remove_all(root);
    for (const char* folder : {"instruments", "anatomies", "library"})
      fs::create_directories(root / folder);
    write("instruments/wire.yaml", kWire);
    write("anatomies/tube.yaml", replaced(kTube, "length_mm: 100", "length_mm: 320"));
  }
  void TearDown() override { fs::remove_all(root); }
  void write(const char* name, const std::string& text) { std::ofstream(root / name) << text; }
  fs::path root;
};

TEST_F(OwnLibrary, LoadsACurriculumAgainstItsCatalogue) {
  write("library/small.yaml", test::valid_curriculum());
  const auto library = load_library(root.string());
  ASSERT_TRUE(library.has_value()) << library.error().message;
  ASSERT_EQ(library->curricula.size(), 1U);
  const auto catalogue = library->catalogue();
  ASSERT_EQ(catalogue.anatomies.size(), 1U);
  EXPECT_EQ(catalogue.anatomies[0].length, 400.0);
  EXPECT_EQ(catalogue.instruments[0].length, 1000.0);
}

TEST_F(OwnLibrary, NamesTheBrokenFileAndItsLine) {
  write("instruments/wire.yaml", replaced(kWire, "friction: 0.1", "friction: wet"));
  const auto library = load_library(root.string());
  ASSERT_FALSE(library.has_value());
  EXPECT_EQ(library.error().code, base::ErrorCode::corrupt_data);
  EXPECT_NE(library.error().message.find("wire.yaml:11: 'friction' must be a number"),
            std::string::npos)
      << library.error().message;
}

TEST_F(OwnLibrary, NamesTheBrokenCurriculumAndItsLine) {
  write("library/small.yaml",
        replaced(test::valid_curriculum(), "anatomy: tube", "anatomy: tubes"));
  const auto library = load_library(root.string());
  ASSERT_FALSE(library.has_value());
  EXPECT_NE(library.error().message.find("small.yaml:21: there is no anatomy"), std::string::npos)
      << library.error().message;
}

TEST_F(OwnLibrary, RefusesTwoFilesWithOneId) {
  write("instruments/copy.yaml", kWire);
  const auto library = load_library(root.string());
  ASSERT_FALSE(library.has_value());
  EXPECT_EQ(library.error().code, base::ErrorCode::conflict);
  EXPECT_NE(library.error().message.find("'wire'"), std::string::npos);
}

TEST_F(OwnLibrary, SaysWhenThereIsNoLibrary) {
  const auto library = load_library((root / "nowhere").string());
  ASSERT_FALSE(library.has_value());
  EXPECT_EQ(library.error().code, base::ErrorCode::not_found);
}

}  // namespace
