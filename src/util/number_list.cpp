// SPDX-License-Identifier: MIT
#include "revisit_slam/util/number_list.h"

#include <cmath>
#include <cstdlib>
#include <sstream>

#include "revisit_slam/util/parameters.h"

namespace revisit_slam {
namespace {

[[noreturn]] void refuse(const std::string& text, const std::string& parameter,
                         const std::string& form) {
  throw ParameterError("parameter '" + parameter + "' is '" + text + "', not " + form);
}

}  // namespace

std::vector<std::string> wordsOf(const std::string& text) {
  std::istringstream stream(text);
  std::vector<std::string> words;
  for (std::string word; stream >> word;) words.push_back(word);
  return words;
}

std::vector<double> numbersOf(const std::string& text, const std::string& parameter,
                              const std::string& form) {
  std::vector<double> numbers;
  for (const std::string& word : wordsOf(text)) {
    char* end = nullptr;
    numbers.push_back(std::strtod(word.c_str(), &end));
    if (*end != '\0' || !std::isfinite(numbers.back())) refuse(text, parameter, form);
  }
  return numbers;
}

std::vector<double> numbersOf(const std::string& text, std::size_t count,
                              const std::string& parameter, const std::string& form) {
  std::vector<double> numbers = numbersOf(text, parameter, form);
  if (!numbers.empty() && numbers.size() != count) refuse(text, parameter, form);
  return numbers;
}

}  // namespace revisit_slam
