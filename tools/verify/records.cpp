// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
#include "verify/records.hpp"

#include <cmath>
#include <iterator>
#include <locale>
#include <sstream>

namespace tern_verify {
void Record::refuse(const std::string& reason) const {
  throw InputError(file + ":" + std::to_string(line) + ": " + reason);
}

namespace {

/// NaN for what is no number.
double value_of(const std::string& word) {
  std::istringstream stream(word);
  stream.imbue(std::locale::classic());
  double value = 0.0;
  stream >> value;
  return stream.fail() || !stream.eof() ? std::nan("") : value;
}

}  // namespace

bool is_number(const std::string& word) {
  return std::isfinite(value_of(word));
}

std::vector<Rational> Record::numbers(std::size_t first) const {
  std::vector<Rational> values;
  for (std::size_t i = first; i < words.size(); ++i) {
    if (!is_number(words[i])) refuse("'" + words[i] + "' is no number");
    values.emplace_back(value_of(words[i]));
  }
  return values;
}

std::vector<Rational> Record::numbers(std::size_t first, std::size_t count) const {
  std::vector<Rational> values = numbers(first);
  if (values.size() != count) refuse("'" + key() + "' needs " + std::to_string(count) + " numbers");
  return values;
}

std::vector<Record> records_of(const std::string& text, const std::string& name) {
  std::vector<Record> records;
  std::istringstream lines(text);
  std::string line;
  for (int number = 1; std::getline(lines, line); ++number) {
    std::istringstream words(line.substr(0, line.find('#')));
    Record record{name, number, {std::istream_iterator<std::string>(words), {}}};
    if (!record.words.empty()) records.push_back(std::move(record));
  }
  return records;
}

Point point_from(const std::vector<Rational>& v, std::size_t first) {
  return {v[first], v[first + 1], v[first + 2]};
}

Box box_from(const Record& record, const std::vector<Rational>& v) {
  const Box result{point_from(v), point_from(v, 3)};
  for (std::size_t a = 0; a < 3; ++a) {
    if (result.lower[a] > result.upper[a]) record.refuse("the box has its corners the wrong way round");
  }
  return result;
}

Box block_from(const Record& record) {
  const std::vector<Rational> v = record.numbers();
  if (v.size() != 6 && !(record.key() == "block" && v.size() == 9)) {
    record.refuse("'" + record.key() + "' needs 6 numbers");
  }
  return box_from(record, v);
}

Via via_from(const Record& record) {
  std::vector<std::string> words = record.words;
  Via result{{}, 0, false, {}, 0};
  for (std::size_t i = 1; i < words.size(); ++i) {
    if (words[i] == "stop" && (i + 1 == words.size() || words[i + 1] == "dwell")) {
      result.stop = true;
      words.erase(words.begin() + static_cast<std::ptrdiff_t>(i));
      --i;
    } else if (words[i] == "dwell") {
      result.stop = true;
      result.dwell = Record{record.file, record.line, words}.numbers(i + 1, 1)[0];
      words.resize(i);
    } else if (words[i] == "velocity") {
      result.velocity = point_from(record.numbers(i + 1, 3));
      words.resize(i);
    }
  }
  const std::vector<Rational> v = Record{record.file, record.line, words}.numbers();
  if (v.size() != 3 && v.size() != 4) record.refuse("'via' needs a point, and may have a tolerance");
  result.position = point_from(v);
  if (v.size() == 4) result.tolerance = v[3];
  return result;
}

void Settings::add(const Record& record) {
  if (!given_.emplace(record.key(), record).second) record.refuse("'" + record.key() + "' is given twice");
}

Rational Settings::number(const std::string& key, const Rational& otherwise) const {
  const auto found = given_.find(key);
  return found == given_.end() ? otherwise : found->second.numbers(1, 1)[0];
}

Point Settings::vector(const std::string& key) const {
  const auto found = given_.find(key);
  return found == given_.end() ? Point{0, 0, 0} : point_from(found->second.numbers(1, 3));
}

Point Settings::limit(const std::string& key, const Rational& otherwise) const {
  const auto found = given_.find(key);
  if (found == given_.end()) return {otherwise, otherwise, otherwise};
  const std::vector<Rational> v = found->second.numbers();
  if (v.size() == 1) return {v[0], v[0], v[0]};
  return point_from(found->second.numbers(1, 3));
}

const Record* Settings::record(const std::string& key) const {
  const auto found = given_.find(key);
  return found == given_.end() ? nullptr : &found->second;
}

std::string Settings::word(const std::string& key) const {
  const auto found = given_.find(key);
  return found != given_.end() && found->second.words.size() == 2 ? found->second.words[1] : "";
}

}  // namespace tern_verify
