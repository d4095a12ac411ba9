// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

namespace revisit_slam {

/// The words of a text between spaces.
std::vector<std::string> wordsOf(const std::string& text);

/// The numbers of a text parameter, between spaces; none of an empty text. @throws ParameterError
/// that names the parameter, its value and `form`, where a word is no finite number.
std::vector<double> numbersOf(const std::string& text, const std::string& parameter,
                              const std::string& form);
/// Likewise where there are to be so many, or none.
std::vector<double> numbersOf(const std::string& text, std::size_t count,
                              const std::string& parameter, const std::string& form);

}  // namespace revisit_slam
