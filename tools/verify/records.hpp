// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// The records of scenarios and of flight worlds (docs/formats.md): one a line, a keyword and what follows.
#ifndef TERN_VERIFY_RECORDS_HPP
#define TERN_VERIFY_RECORDS_HPP

#include <map>
#include <string>
#include <vector>

#include "verify/problem.hpp"

namespace tern_verify {

/// True if all of the word is a finite number.
bool is_number(const std::string& word);

struct Record {
  std::string file;
  int line;
  std::vector<std::string> words;

  const std::string& key() const { return words[0]; }
  /// Throws InputError with the record's place.
  [[noreturn]] void refuse(const std::string& reason) const;
  /// The words from `first` on as numbers: the doubles next to them, taken as they are.
  std::vector<Rational> numbers(std::size_t first = 1) const;
  /// The same, of a given number.
  std::vector<Rational> numbers(std::size_t first, std::size_t count) const;
};

/// The records of a text; `name` is for messages.
std::vector<Record> records_of(const std::string& text, const std::string& name);

/// From the numbers at `first` on.
Point point_from(const std::vector<Rational>& v, std::size_t first = 0);
Box box_from(const Record& record, const std::vector<Rational>& v);
/// `block`, with or without a colour.
Box block_from(const Record& record);
Via via_from(const Record& record);

/// What records of one value each say; each may be given once.
class Settings {
 public:
  void add(const Record& record);
  bool has(const std::string& key) const { return given_.count(key) != 0; }
  Rational number(const std::string& key, const Rational& otherwise) const;
  /// Zero if it is not given.
  Point vector(const std::string& key) const;
  /// One number for all axes, or one each.
  Point limit(const std::string& key, const Rational& otherwise) const;
  /// The record's one word; empty if it is not given, or has others.
  std::string word(const std::string& key) const;
  /// Null if it is not given.
  const Record* record(const std::string& key) const;

 private:
  std::map<std::string, Record> given_;
};

}  // namespace tern_verify

#endif
