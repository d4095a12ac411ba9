// SPDX-License-Identifier: MIT
// Holds the tables of the documentation against the code. UPDATE_DOCS=1 writes the table of
// parameters.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <vector>

#include "revisit_slam/io/presets.h"
#include "revisit_slam/slam/slam_config.h"
#include "support/child_process.h"

namespace revisit_slam {
namespace {

/// The first group of every match.
std::set<std::string> findAll(const std::string& text, const std::string& pattern) {
  const std::regex expression(pattern);
  std::set<std::string> found;
  for (std::sregex_iterator it(text.begin(), text.end(), expression), end; it != end; ++it)
    found.insert((*it)[1]);
  return found;
}

std::string tableRows(const std::string& markdown) {
  std::istringstream lines(markdown);
  std::string rows;
  for (std::string line; std::getline(lines, line);)
    if (line.rfind("|", 0) == 0) rows += line + "\n";
  return rows;
}

std::string textOfFolder(const std::string& folder, const std::string& extension) {
  std::string text;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    if (entry.path().extension() == extension) text += textOf(entry.path());
  return text;
}

/// All pages of the documentation.
std::vector<std::filesystem::path> pages() {
  std::vector<std::filesystem::path> found{"README.md", "CONTRIBUTING.md"};
  for (const auto& entry : std::filesystem::directory_iterator("docs"))
    if (entry.path().extension() == ".md") found.push_back(entry.path());
  return found;
}

/// Names with their groups of the parameters in cfg/*.cfg.
std::set<std::string> liveParameters() {
  const std::map<std::string, std::string> places{{"recognition", "loops/recognition"}};
  std::set<std::string> live;
  for (const auto& entry : std::filesystem::directory_iterator("cfg")) {
    const std::string text = textOf(entry.path());
    const std::set<std::string> groups = findAll(text, R"re(generate\("revisit_slam", "(\w+)")re");
    for (const std::string& name : findAll(text, R"re(gen\.add\("(\w+)")re"))
      for (const std::string& group : groups)
        live.insert((places.count(group) ? places.at(group) : group) + "/" + name);
  }
  return live;
}

std::string parameterTable() {
  SlamConfig config;
  const std::set<std::string> live = liveParameters();
  std::ostringstream table;
  table << "\n| parameter | default | allowed | |\n|---|---|---|---|\n";
  for (const Parameter& parameter : parametersOf(config))
    table << "| `" << parameter.name << "` | " << valueText(parameter) << " | "
          << std::regex_replace(allowedText(parameter), std::regex(R"( \| )"), ", ") << " | "
          << parameter.description << (live.count(parameter.name) ? " *(live)*" : "") << " |\n";
  return table.str() + "\n";
}

TEST(Documentation, TheTableOfParametersIsThatOfTheCode) {
  const std::string path = "docs/parameters.md";
  std::string page = textOf(path);
  const std::string begin_mark = "documentation_test.cpp) -->\n", end_mark = "<!-- parameters: end";
  const std::size_t mark = page.find(begin_mark), end = page.find(end_mark);
  ASSERT_NE(mark, std::string::npos);
  ASSERT_NE(end, std::string::npos);
  const std::size_t begin = mark + begin_mark.size();
  ASSERT_LE(begin, end);
  if (std::getenv("UPDATE_DOCS")) {
    page.replace(begin, end - begin, parameterTable());
    std::ofstream(path) << page;
  } else {
    EXPECT_EQ(page.substr(begin, end - begin), parameterTable());
  }
}

/// Those that other pages have measured.
TEST(Documentation, NoFigureIsStale) {
  ChildProcess process({"/usr/bin/python3", "scripts/figures", "--check"});
  EXPECT_EQ(process.wait(60.0), 0) << process.output();
}

TEST(Documentation, EveryValueOfThePresetOfThePaperHasItsStatement) {
  const std::string rows = tableRows(textOf("docs/paper.md"));
  const std::vector<NamedText> values = readPreset("paper");
  EXPECT_GE(values.size(), 25u);
  for (const auto& [name, value] : values) {
    const std::size_t row = rows.find("`" + name + "`");
    EXPECT_NE(row, std::string::npos) << name;
    EXPECT_NE(rows.substr(row, rows.find('\n', row) - row).find(" " + value), std::string::npos)
        << name << " is " << value;
  }
}

TEST(Documentation, EveryTopicAndServiceStandsInATable) {
  const std::string nodes =
      textOfFolder("src/nodelets", ".cpp") + textOfFolder("src/ros/node", ".cpp");
  const std::set<std::string> documented =
      findAll(tableRows(textOf("docs/ros_interface.md")), "`([\\w/]+)`");
  const auto names = findAll(nodes, R"re((?:advertise|subscribe)(?:<[\w:]+>)?\(\s*"([\w/]+)")re");
  ASSERT_GE(names.size(), 25u);
  for (const std::string& name : names) EXPECT_EQ(documented.count(name), 1u) << name;
  const auto services = findAll(nodes, R"re(advertiseService\("(\w+)")re");
  ASSERT_GE(services.size(), 4u);
  for (const std::string& service : services)
    EXPECT_EQ(documented.count("odometry/" + service) + documented.count("back_end/" + service), 1u)
        << service;
}

TEST(Documentation, EveryLiveParameterStandsAtItsNodelet) {
  const std::string rows = tableRows(textOf("docs/ros_interface.md"));
  for (const std::string& parameter : liveParameters()) {
    const std::size_t slash = parameter.rfind('/');
    const std::regex row("`\\w+/" + parameter.substr(0, slash) + "` \\|[^\n]*`" +
                         parameter.substr(slash + 1) + "`");
    EXPECT_TRUE(std::regex_search(rows, row)) << parameter;
  }
}

TEST(Documentation, TheFirstCommandStandsWithin35Lines) {
  std::istringstream readme(textOf("README.md"));
  std::string line;
  int number = 0;
  while (std::getline(readme, line) && line != "scripts/demo") ++number;
  EXPECT_LT(number, 35);
}

TEST(Documentation, EveryHeaderThatAPageNamesExists) {
  const std::string pattern = "`((?:\\w+/)+\\w+\\.h)`";
  EXPECT_GE(findAll(textOf("docs/notation.md"), pattern).size(), 20u);
  for (const auto& page : pages())
    for (const std::string& header : findAll(textOf(page), pattern))
      EXPECT_TRUE(std::filesystem::exists("include/revisit_slam/" + header))
          << page << ": " << header;
}

}  // namespace
}  // namespace revisit_slam
