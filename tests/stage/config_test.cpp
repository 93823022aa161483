// Configurations: the list of parameters, the rules, the width of a lane.
#include "golden/config/config.h"

#include "golden/datapath/datapaths.h"
#include "tests/stage/support.h"

namespace wrinkle {
namespace {

TEST(Config, ParametersAreTheMembers) {
  EXPECT_EQ(parameters().size() * sizeof(int), sizeof(Config));
  const Config standard;
  for (const Parameter& p : parameters()) {
    EXPECT_EQ(standard.*p.member, p.standard) << p.name;
    EXPECT_LE(p.minimum, p.standard) << p.name;
    EXPECT_GE(p.maximum, p.standard) << p.name;
    if (!p.values.empty()) {
      EXPECT_EQ(static_cast<int>(p.values.size()), p.maximum + 1) << p.name;
    }
  }
}

TEST(Config, StandardIsLegalAndNarrow) {
  EXPECT_EQ(check({}).key, "");
  EXPECT_LE(widest_operand_bits(Config()), 32);
  EXPECT_EQ(lane_bits(Config()), 32);
  EXPECT_EQ(lane_bits(with({{&Config::perspective, 1}})), 64);
}

TEST(Config, EveryRangeIsChecked) {
  for (const Parameter& p : parameters()) {
    for (int value : {p.minimum - 1, p.maximum + 1}) {
      Config config;
      config.*p.member = value;
      const IllegalParameter fault = check(config);
      EXPECT_EQ(fault.key, p.name);
      EXPECT_NE(fault.message.find(std::to_string(value)), std::string::npos) << fault.message;
    }
  }
}

TEST(Config, RulesBetweenParameters) {
  EXPECT_EQ(check(with({{&Config::unit_bits, 6}, {&Config::dot_bits, 13}, {&Config::power_bits, 13}})).key, "dot_bits");
  EXPECT_EQ(check(with({{&Config::unit_bits, 6}, {&Config::dot_bits, 12}, {&Config::power_bits, 12}})).key, "");
  EXPECT_EQ(check(with({{&Config::dot_bits, 13}})).key, "power_bits");
  const Config coarse = with({{&Config::reciprocal_bits, 16}, {&Config::q_bits, 18}});
  EXPECT_EQ(check(coarse).key, "") << "without perspective there is no reciprocal";
  Config divided = coarse;
  divided.perspective = 1;
  EXPECT_EQ(check(divided).key, "reciprocal_bits");
  divided.reciprocal_bits = 17;
  EXPECT_EQ(check(divided).key, "");
}

// What the rival datapaths ask for; 0 is none, 4 near.
TEST(Config, RulesOfTheRivals) {
  EXPECT_EQ(check(with({{&Config::datapath, 2}, {&Config::normalizer_n, 0}})).key, "normalizer_n");
  EXPECT_EQ(check(with({{&Config::lighting, 3}, {&Config::normalizer_h, 0}})).key, "normalizer_h");
  EXPECT_EQ(check(with({{&Config::normalizer_n, 0}, {&Config::normalizer_h, 0}})).key, "");
  EXPECT_EQ(check(with({{&Config::datapath, 2}, {&Config::normalizer_n, 4}})).key, "normalizer_n");
  EXPECT_EQ(check(with({{&Config::lighting, 3}, {&Config::normalizer_h, 4}})).key, "normalizer_h");
  for (int small : {2, 3}) {
    EXPECT_EQ(check(with({{&Config::datapath, 2}, {&Config::normalizer_n, small}})).key, "");
    EXPECT_EQ(check(with({{&Config::lighting, 3}, {&Config::normalizer_h, small}})).key, "");
  }
  EXPECT_EQ(check(with({{&Config::normalizer_n, 4}, {&Config::normalizer_l, 4}, {&Config::normalizer_h, 4}})).key, "");
  EXPECT_EQ(check(with({{&Config::datapath, 3}, {&Config::light_vectors, 1}})).key, "light_vectors");
  EXPECT_EQ(check(with({{&Config::datapath, 2}, {&Config::light_vectors, 1}})).key, "");
  const Config blinn = with({{&Config::datapath, 2}});
  EXPECT_EQ(Shape(blinn).texels, 2);
  EXPECT_EQ(Shape(blinn).normal_width, blinn.wide_bits + 3);
  EXPECT_EQ(Shape(with({{&Config::light_vectors, 1}})).draw_words, 6);
}

// A gloss multiplies a highlight, with a base colour or without, in every datapath.
TEST(Config, RulesOfTheGlossMap) {
  EXPECT_EQ(check(with({{&Config::gloss_map, 1}, {&Config::lighting, 0}})).key, "gloss_map");
  for (int datapath = 0; datapath <= static_cast<int>(Datapath::kOffset); ++datapath) {
    for (int decal : {0, 1}) {
      const Config config = with({{&Config::datapath, datapath}, {&Config::gloss_map, 1}, {&Config::decal, decal}});
      EXPECT_EQ(check(config).message, "");
      EXPECT_EQ(Shape(config).textured, 1);
      EXPECT_EQ(Shape(config).texels, Shape(config).bump_components + 3 * decal + 1);
    }
  }
}

// One unit in turn: three vectors, one kind of normalizer, and a highlight by H. Buffering is free.
TEST(Config, RulesOfSharing) {
  EXPECT_EQ(check(with({{&Config::sharing, 1}, {&Config::buffering, 1}})).key, "");
  EXPECT_EQ(check(with({{&Config::sharing, 1}, {&Config::datapath, 0}})).key, "");
  EXPECT_EQ(check(with({{&Config::sharing, 1}, {&Config::datapath, 2}})).key, "sharing");
  EXPECT_EQ(check(with({{&Config::sharing, 1}, {&Config::datapath, 3}})).key, "sharing");
  EXPECT_EQ(check(with({{&Config::sharing, 1}, {&Config::light_vectors, 1}})).key, "sharing");
  EXPECT_EQ(check(with({{&Config::sharing, 1}, {&Config::lighting, 0}})).key, "sharing");
  EXPECT_EQ(check(with({{&Config::sharing, 1}, {&Config::lighting, 2}})).key, "sharing");
  EXPECT_EQ(check(with({{&Config::sharing, 1}, {&Config::normalizer_h, 2}})).key, "sharing");
  const int none = static_cast<int>(Normalizer::kNone);
  EXPECT_EQ(check(with({{&Config::sharing, 1},
                        {&Config::normalizer_n, none},
                        {&Config::normalizer_l, none},
                        {&Config::normalizer_h, none}}))
                .key,
            "sharing");
  EXPECT_EQ(check(with({{&Config::buffering, 1}, {&Config::datapath, 2}})).key, "");
}

// Every legal configuration fits 64 bits, with room.
TEST(Config, WidestOperandFitsALane) {
  Random random(base_seed());
  int narrow = 0;
  for (int i = 0; i < 2000; ++i) {
    const Config config = random_config(random);
    EXPECT_LT(widest_operand_bits(config), 64);
    narrow += lane_bits(config) == 32 ? 1 : 0;
  }
  EXPECT_GT(narrow, 20);
}

}  // namespace
}  // namespace wrinkle
