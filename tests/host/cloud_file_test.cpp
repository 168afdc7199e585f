// Copyright (c) 2026, the Tern authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Point clouds: every form says the same, and what is not wholly right is refused.
#include "host/map/cloud_file.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "support/map_bytes.hpp"

namespace {

using tern::Vec3;
using tern_host::Cloud;
using tern_host::RecordError;
using tern_test::bytes_of;
using tern_test::contains;

/// Why a cloud is refused, with its line; empty where it is not.
std::string cloud_refusal(const std::string& bytes) {
  try {
    tern_host::parse_cloud(bytes, {"it", 0});
  } catch (const RecordError& error) {
    EXPECT_EQ(error.place().file, "it");
    return error.what();
  }
  return "";
}

std::string replaced(std::string text, const std::string& part, const std::string& by) {
  const std::size_t at = text.find(part);
  EXPECT_NE(at, std::string::npos) << part;
  return text.replace(at, part.size(), by);
}

void expect_refused(const std::string& bytes, const std::string& reason) {
  EXPECT_TRUE(contains(cloud_refusal(bytes), reason))
      << "'" << cloud_refusal(bytes) << "', not '" << reason << "', of\n"
      << bytes;
}

const std::string kPcd =
    "VERSION 0.7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\nWIDTH 2\nHEIGHT 1\nVIEWPOINT 0 0 0 1 0 0 0\n"
    "POINTS 2\nDATA ascii\n1 2 3\n4 5 6\n";
const std::string kPly =
    "ply\nformat ascii 1.0\ncomment made by hand\nelement vertex 2\nproperty float x\nproperty float y\n"
    "property float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n1 2 3\n4 5 6\n3 0 1 0\n";

TEST(CloudFile, AllFormsHaveTheSamePoints) {
  std::vector<std::string> names = {"points_text.pcd", "points_binary.pcd", "points_text.ply", "points_little.ply",
                                    "points_big.ply"};
  const std::string packed = cloud_refusal(bytes_of("points_packed.pcd"));
  EXPECT_TRUE(packed.empty() || contains(packed, "this build is without liblzf")) << packed;
  if (packed.empty()) names.push_back("points_packed.pcd");
  for (const std::string& name : names) {
    const Cloud cloud = tern_host::parse_cloud(bytes_of(name), {name, 0});
    ASSERT_EQ(cloud.points.size(), 4u) << name;  // the third one of five is not finite
    EXPECT_EQ(cloud.dropped, 1u);
    EXPECT_FALSE(cloud.has_viewpoint);
    EXPECT_EQ(cloud.points[1].x, 1.0);
    EXPECT_EQ(cloud.points[1].y, -2.0);
    EXPECT_EQ(cloud.points[1].z, 3.5);
    EXPECT_EQ(cloud.points[2].x, 1000.0);
    EXPECT_EQ(cloud.points[2].z, -0.125);
  }
}

TEST(CloudFile, WhatChangesNothingMayDiffer) {
  const std::string pcds[] = {"# .PCD v0.7 - Point Cloud Data file format\n" + kPcd,
                              "# made by a scanner\n\n#second\n" + kPcd,
                              replaced(kPcd, "VERSION 0.7", "VERSION .7"),
                              replaced(kPcd, "VERSION 0.7\n", ""),
                              replaced(kPcd, "COUNT 1 1 1\n", ""),
                              replaced(kPcd, "HEIGHT 1\n", ""),
                              replaced(kPcd, "FIELDS", "COLUMNS"),
                              replaced(kPcd, "1 2 3\n", "1 2 3\n\n"),
                              kPcd + "\n \n",
                              kPcd.substr(0, kPcd.size() - 1)};
  for (const std::string& pcd : pcds) {
    EXPECT_EQ(cloud_refusal(pcd), "") << pcd;
    EXPECT_EQ(tern_host::parse_cloud(pcd, {"it", 0}).points.size(), 2u);
  }
  for (std::string text : {kPcd, kPly}) {
    for (std::size_t at = 0; (at = text.find('\n', at)) != std::string::npos; at += 2) text.insert(at, "\r");
    EXPECT_EQ(cloud_refusal(text), "");
  }
  EXPECT_EQ(cloud_refusal(kPly), "");
}

TEST(CloudFile, OnlyWordsThatSaySoAreNotFinite) {
  for (const char* word : {"nan", "NaN", "-nan", "inf", "+inf", "-Inf", "Infinity", "-INFINITY"}) {
    const Cloud cloud = tern_host::parse_cloud(replaced(kPcd, "5", word), {"it", 0});
    EXPECT_EQ(cloud.points.size(), 1u) << word;
    EXPECT_EQ(cloud.dropped, 1u) << word;
  }
  for (const char* word :
       {"5,0", "5.0.", "5x", "1e",   "1e+",     "0x10",  "1_000", "1'000", "--5", ".",  "+",
        "e5",  "nane", "na", "inf5", "1.#QNAN", "1e999", "5;",    "\"5\"", "5f",  "#5", "\xD9\xA3"}) {
    expect_refused(replaced(kPcd, "5", word), "it:12: '");
    expect_refused(replaced(kPly, "5", word), "it:12: '");
  }
}

TEST(CloudFile, RowsHaveAsManyNumbersAsTheHeaderSays) {
  for (const std::string& text : {kPcd, kPly}) {
    expect_refused(replaced(text, "4 5 6", "4 5"), "it:12: a point has 2 numbers, the header says 3");
    expect_refused(replaced(text, "4 5 6", "4 5 6 7"), "it:12: a point has 4 numbers");
    expect_refused(replaced(text, "4 5 6", "4,5,6"), "it:12: a point has 1 numbers");
  }
  expect_refused(replaced(kPcd, "4 5 6\n", ""), "the header says 2 points, the file has 1 and 0 more lines");
  expect_refused(kPcd + "7 8 9\n", "the header says 2 points, the file has 2 and 1 more lines");
  expect_refused(replaced(kPly, "3 0 1 0\n", ""), "says 2 points and 1 other rows, the file has 2 and 0");
  expect_refused(kPly + "1 2 3\n", "says 2 points and 1 other rows, the file has 2 and 2");
  expect_refused(replaced(kPcd, "TYPE F F F", "TYPE F I F").replace(kPcd.find("4 5 6"), 5, "4 5.5 6"),
                 "'5.5' is not a whole number");
}

TEST(CloudFile, PcdHeadersMustBeWholeAndAgree) {
  for (const char* line : {"FIELDS x y z\n", "SIZE 4 4 4\n", "TYPE F F F\n", "POINTS 2\n", "WIDTH 2\n"}) {
    EXPECT_NE(cloud_refusal(replaced(kPcd, line, "")), "") << line;
    expect_refused(replaced(kPcd, line, std::string(line) + line), "is given twice");
  }
  expect_refused(replaced(kPcd, "POINTS 2\n", ""), "no 'POINTS'; 'WIDTH' 2 x 'HEIGHT' 1 would be 2");
  expect_refused(replaced(kPcd, "POINTS 2", "POINTS 1"), "it:9: 'POINTS' is 1, but 'WIDTH' 2 x 'HEIGHT' 1 is 2");
  expect_refused(replaced(kPcd, "HEIGHT 1", "HEIGHT 0"), "'POINTS' is 2, but 'WIDTH' 2 x 'HEIGHT' 0 is 0");
  expect_refused(replaced(kPcd, "WIDTH 2\n", ""), "'HEIGHT' without 'WIDTH'");
  expect_refused(replaced(kPcd, "POINTS 2", "POINTS 2 2"), "'POINTS' needs 1 word, found 2");
  for (const char* count : {"-2", "2.5", "2,0", "1e12", "nan", "two"}) {
    EXPECT_NE(cloud_refusal(replaced(kPcd, "POINTS 2", std::string("POINTS ") + count)), "") << count;
  }
  expect_refused(replaced(kPcd, "SIZE 4 4 4", "SIZE 4 4"), "it:3: 'SIZE' is for 2 fields, 'FIELDS' names 3");
  expect_refused(replaced(kPcd, "COUNT 1 1 1", "COUNT 1 1 1 1"), "'COUNT' is for 4 fields");
  expect_refused(replaced(kPcd, "COUNT 1 1 1", "COUNT 1 0 1"), "a count of 0");
  expect_refused(replaced(kPcd, "COUNT 1 1 1", "COUNT 1 2 1"), "field 'y' has more than one number");
  expect_refused(replaced(kPcd, "FIELDS x y z", "FIELDS x y y"), "field 'y' is given twice");
  expect_refused(replaced(kPcd, "FIELDS x y z", "FIELDS x y Z"), "no x, y and z");
  expect_refused(replaced(kPcd, "TYPE F F F", "TYPE F F S"), "has a type that no number has: 'S' of 4 bytes");
  expect_refused(replaced(kPcd, "TYPE F F F", "TYPE F F FF"), "'FF' is not a type");
  for (const char* size : {"2", "3", "16", "0"}) {
    EXPECT_NE(cloud_refusal(replaced(kPcd, "SIZE 4 4 4", std::string("SIZE 4 4 ") + size)), "") << size;
  }
  expect_refused(replaced(kPcd, "VERSION 0.7", "VERSION 0.8"), "of version '0.8'");
  expect_refused(replaced(kPcd, "HEIGHT", "HIGHT"), "it:7: unknown word 'HIGHT'");
  expect_refused(replaced(kPcd, "DATA ascii", "DATA text"), "'DATA' is 'text'");
  expect_refused(replaced(kPcd, "DATA ascii\n1 2 3\n4 5 6\n", ""), "no 'DATA'");
  expect_refused(replaced(kPcd, "VIEWPOINT 0 0 0 1 0 0 0", "VIEWPOINT 0 0 0 1"), "'VIEWPOINT' needs 7 numbers");
  expect_refused(replaced(kPcd, "VIEWPOINT 0 0 0 1", "VIEWPOINT 0 0 0 2"), "the length 2, not 1");
  expect_refused("# a comment\nsolid", "neither a PCD file nor a PLY file");
  expect_refused("# only comments\n#", "neither a PCD file nor a PLY file");
}

TEST(CloudFile, AViewpointIsSaid) {
  for (const char* at : {"VIEWPOINT 1 0 0 1 0 0 0", "VIEWPOINT 0 0 0 0 1 0 0"}) {
    const Cloud cloud = tern_host::parse_cloud(replaced(kPcd, "VIEWPOINT 0 0 0 1 0 0 0", at), {"it", 0});
    EXPECT_TRUE(cloud.has_viewpoint) << at;
    EXPECT_EQ(cloud.points[0].x, 1.0);
  }
}

TEST(CloudFile, PlyHeadersMustBeWholeAndAgree) {
  expect_refused(replaced(kPly, "format ascii 1.0\n", ""), "is not a 'format'");
  expect_refused(replaced(kPly, "format ascii 1.0", "format ascii 2.0"), "of version '2.0'");
  expect_refused(replaced(kPly, "format ascii 1.0", "format text 1.0"), "'format' is 'text'");
  expect_refused(replaced(kPly, "format ascii 1.0", "format ascii"), "'format' needs");
  expect_refused(replaced(kPly, "end_header\n", ""), "'1'");
  expect_refused(kPly.substr(0, kPly.find("end_header")), "no 'end_header'");
  expect_refused(replaced(kPly, "element vertex 2\n", ""), "before the first 'element'");
  expect_refused(replaced(kPly, "vertex 2", "point 2"), "not 'vertex'");
  expect_refused(replaced(kPly, "element face 1", "element vertex 1"), "element 'vertex' is given twice");
  for (const char* count : {"-2", "2.5", "1e12", "nan", "", "2 3"}) {
    EXPECT_NE(cloud_refusal(replaced(kPly, "vertex 2", std::string("vertex ") + count)), "") << count;
  }
  expect_refused(replaced(kPly, "float y", "float x"), "field 'x' is given twice");
  expect_refused(replaced(kPly, "property float y\n", ""), "no x, y and z");
  expect_refused(replaced(kPly, "float y", "real y"), "no known type: 'real'");
  expect_refused(replaced(kPly, "property float y", "property list uchar float y"), "of a vertex is a list");
  expect_refused(replaced(kPly, "property float y", "property float"), "not a type and a name");
  expect_refused(replaced(kPly, "list uchar int", "list float int"), "not a whole number");
  expect_refused(replaced(kPly, "comment", "coment"), "unknown word 'coment'");
}

TEST(CloudFile, BinaryDataAreAsLongAsTheHeaderSays) {
  std::vector<std::string> names = {"points_binary.pcd", "points_little.ply", "points_big.ply"};
  if (cloud_refusal(bytes_of("points_packed.pcd")).empty()) names.push_back("points_packed.pcd");
  for (const std::string& name : names) {
    const std::string whole = bytes_of(name);
    for (std::size_t n = 0; n < whole.size(); ++n) ASSERT_NE(cloud_refusal(whole.substr(0, n)), "") << name << " " << n;
    EXPECT_NE(cloud_refusal(whole + "x"), "") << name;
    EXPECT_NE(cloud_refusal(whole + std::string(12, '\0')), "") << name;
    EXPECT_NE(cloud_refusal(whole + whole), "") << name;
  }
  const std::string binary = bytes_of("points_binary.pcd");
  expect_refused(binary.substr(0, binary.size() - 1), "says 5 points, 120 bytes, the file has 119");
  expect_refused(binary + "xy", "the file has 2 bytes more, from byte");
  // PCL leaves the rest of the header's page.
  const std::size_t header = binary.size() - 120;
  EXPECT_EQ(cloud_refusal(binary + std::string(4096 - header, '\0')), "");
  expect_refused(binary + std::string(4096 - header, ' '), "bytes more");
  // A huge count takes no memory.
  expect_refused(replaced(replaced(binary, "POINTS 5", "POINTS 60000000"), "WIDTH 5", "WIDTH 60000000"), "cut off");
}

TEST(CloudFile, CompressedDataMustFit) {
  const std::string whole = bytes_of("points_packed.pcd");
  if (!cloud_refusal(whole).empty()) GTEST_SKIP() << "without liblzf";
  const std::size_t sizes = whole.find("binary_compressed\n") + 18;
  std::string other = whole;
  ++other[sizes + 4];
  expect_refused(other, "120 bytes, its compressed data 121 bytes");
  other = whole;
  other[sizes + 2] = 1;
  expect_refused(other, "cut off");
  other = whole;
  other[sizes + 8] = '\xFF';
  expect_refused(other, "compressed data are broken");
  // No more memory than the data can fill.
  other = replaced(replaced(whole, "POINTS 5", "POINTS 60000000"), "WIDTH 5", "WIDTH 60000000");
  const std::uint32_t claimed = 60000000u * 24u;
  for (std::size_t i = 0; i < 4; ++i) other[sizes + 14 + 4 + i] = static_cast<char>(claimed >> (8 * i));
  expect_refused(other, "write the file again");
  for (std::size_t n = sizes; n < whole.size(); ++n) {
    std::string broken = whole;
    broken[n] = '\x55';
    cloud_refusal(broken);
  }
}

}  // namespace
