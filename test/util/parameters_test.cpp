// SPDX-License-Identifier: MIT
#include "revisit_slam/util/parameters.h"

#include <gtest/gtest.h>

#include <array>
#include <limits>

namespace revisit_slam {
namespace {

struct Inner {
  double size = 0.1;
  std::string mode = "auto";

  template <typename Visitor>
  void visit(Visitor& v) {
    v("size", size, Range{-5.0, 20.0}, "m", "a size");
    v("mode", mode, Choices{"auto", "none"}, "", "a mode");
  }
};

struct Outer {
  bool flag = false;
  int count = 3;
  std::string topic;
  Inner inner;

  template <typename Visitor>
  void visit(Visitor& v) {
    v("flag", flag, "a flag");
    v.group("inner", inner);
    v("count", count, Range{1, 10}, "scans", "a count");
    v("topic", topic, Choices{}, "", "any text");
  }
};

std::string messageOf(const NamedText& value) {
  Outer config;
  try {
    assign(parametersOf(config), {value});
  } catch (const ParameterError& error) {
    return error.what();
  }
  return "accepted";
}

TEST(Parameters, NestWithTheirGroups) {
  Outer config;
  std::vector<std::string> names;
  for (const Parameter& parameter : parametersOf(config)) names.push_back(parameter.name);
  EXPECT_EQ(names,
            (std::vector<std::string>{"flag", "inner/size", "inner/mode", "count", "topic"}));
}

TEST(Parameters, AreAssignedByName) {
  Outer config;
  const auto parameters = parametersOf(config);
  assign(parameters, {{"inner/size", "-2.5"}, {"inner/mode", "none"}, {"topic", "/a b"}});
  EXPECT_EQ(config.inner.size, -2.5);
  EXPECT_EQ(config.inner.mode, "none");
  EXPECT_EQ(config.topic, "/a b");
  EXPECT_EQ(config.count, 3);
  for (const auto& [text, value] : std::vector<std::pair<std::string, bool>>{{"true", true},
                                                                             {"false", false},
                                                                             {"True", true},
                                                                             {"False", false},
                                                                             {"1", true},
                                                                             {"0", false}}) {
    config.flag = !value;
    assign(parameters, {{"flag", text}});
    EXPECT_EQ(config.flag, value) << text;
  }
}

TEST(Parameters, UnknownNamesSuggestTheNearest) {
  for (const auto& [wrong, nearest] : std::vector<NamedText>{{"inner/sise", "inner/size"},
                                                             {"size", "inner/size"},
                                                             {"mod", "inner/mode"},
                                                             {"coumt", "count"},
                                                             {"Flag", "flag"},
                                                             {"iner/mode", "inner/mode"}}) {
    const std::string message = messageOf({wrong, "1"});
    EXPECT_EQ(message, "unknown parameter '" + wrong + "'; did you mean '" + nearest + "'?");
  }
}

TEST(Parameters, RefusalsNameParameterValueAndWhatIsAllowed) {
  const std::string whole = "a whole number", number = "a number", flag = "true or false";
  for (const auto& [name, value, allowed] :
       std::vector<std::array<std::string, 3>>{{"count", "0", "1 to 10 scans"},
                                               {"count", "11", "1 to 10 scans"},
                                               {"count", "2.5", whole},
                                               {"count", "2x", whole},
                                               {"count", "", whole},
                                               {"count", "99999999999", whole},
                                               {"inner/size", "-5.001", "-5 to 20 m"},
                                               {"inner/size", "20.5", "-5 to 20 m"},
                                               {"inner/size", "nan", number},
                                               {"inner/size", ".nan", number},
                                               {"inner/size", "1 m", number},
                                               {"inner/size", "1,5", number},
                                               {"inner/mode", "Auto", "auto | none"},
                                               {"inner/mode", "", "auto | none"},
                                               {"flag", "maybe", flag},
                                               {"flag", "2", flag}}) {
    EXPECT_EQ(messageOf({name, value}),
              "parameter '" + name + "' is '" + value + "', but must be " + allowed);
  }
}

TEST(Parameters, RangesAreClosed) {
  for (const NamedText& value : std::vector<NamedText>{
           {"count", "1"}, {"count", "10"}, {"inner/size", "-5"}, {"inner/size", "2e1"}})
    EXPECT_EQ(messageOf(value), "accepted") << value.first << value.second;
}

const RenamedParameters kRenamed{{"inner/width", "inner/size"}, {"amount", "count"}};

std::string messageWithOldNames(const std::vector<NamedText>& values) {
  Outer config;
  try {
    const auto warnings = assign(parametersOf(config), values, kRenamed);
    return std::to_string(warnings.size()) + " warnings";
  } catch (const ParameterError& error) {
    return error.what();
  }
}

TEST(Parameters, AnOldNameIsAcceptedWithAWarning) {
  Outer config;
  const auto warnings = assign(parametersOf(config),
                               {{"inner/width", "3"}, {"flag", "true"}, {"amount", "7"}}, kRenamed);
  EXPECT_EQ(config.inner.size, 3.0);
  EXPECT_EQ(config.count, 7);
  EXPECT_TRUE(config.flag);
  ASSERT_EQ(warnings.size(), 2u);
  EXPECT_EQ(
      warnings[0],
      "parameter 'inner/width' is now called 'inner/size'; the old name is accepted until the "
      "next release");
  EXPECT_EQ(messageWithOldNames({{"inner/size", "3"}}), "0 warnings");
}

TEST(Parameters, AnOldNameAndItsNewOneTogetherAreAnError) {
  EXPECT_EQ(messageWithOldNames({{"count", "2"}, {"amount", "2"}}),
            "parameter 'amount' is now called 'count'; give one of the two, not both");
}

TEST(Parameters, ValuesUnderAnOldNameAreCheckedAndOtherNamesAreUnknown) {
  EXPECT_EQ(messageWithOldNames({{"amount", "11"}}),
            "parameter 'count' is '11', but must be 1 to 10 scans");
  EXPECT_EQ(messageWithOldNames({{"inner/sise", "1"}}),
            "unknown parameter 'inner/sise'; did you mean 'inner/size'?");
}

TEST(Parameters, SettingsAreNamesAndValues) {
  EXPECT_EQ(parseSettings({"inner/size=2", "topic=a=b", "topic="}),
            (std::vector<NamedText>{{"inner/size", "2"}, {"topic", "a=b"}, {"topic", ""}}));
  EXPECT_THROW(parseSettings({"flag"}), ParameterError);
}

TEST(Parameters, ValuesSetByTheProgramAreCheckedToo) {
  Outer config;
  EXPECT_NO_THROW(check(parametersOf(config)));
  for (const double bad :
       {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(), 21.0}) {
    config.inner.size = bad;
    EXPECT_THROW(check(parametersOf(config)), ParameterError) << bad;
  }
}

TEST(Parameters, ValueTextReadsBackAsTheSameValue) {
  Outer config, copy;
  config.flag = true;
  config.topic = "/points raw";
  for (const double value : {0.1, 1.0 / 3.0, -1e-17, 0.1 + 0.2, 19.999999999999996, 0.0}) {
    config.inner.size = value;
    for (const Parameter& parameter : parametersOf(config))
      assign(parametersOf(copy), {{parameter.name, valueText(parameter)}});
    EXPECT_EQ(copy.inner.size, value);
  }
  EXPECT_TRUE(copy.flag);
  EXPECT_EQ(copy.topic, config.topic);
  config.inner.size = 0.1;
  EXPECT_EQ(valueText(parametersOf(config)[1]), "0.1");
}

}  // namespace
}  // namespace revisit_slam
