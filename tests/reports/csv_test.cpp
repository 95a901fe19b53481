#include "reports/csv.h"

#include <gtest/gtest.h>

namespace {

std::string cell(const std::string& text) {
  const std::string row = reports::csv_row({text});
  return row.substr(0, row.size() - 2);
}

TEST(Csv, TextThatASpreadsheetWouldCalculateIsGuarded) {
  EXPECT_EQ(cell("=1+1"), "'=1+1");
  EXPECT_EQ(cell("+1+1"), "'+1+1");
  EXPECT_EQ(cell("-1+1"), "'-1+1");
  EXPECT_EQ(cell("@SUM(A1)"), "'@SUM(A1)");
  EXPECT_EQ(cell("\t=1"), "'\t=1");
  EXPECT_EQ(cell("\r=1"), "\"'\r=1\"");
  EXPECT_EQ(cell("\n=1"), "\"'\n=1\"");
}

TEST(Csv, NegativeNumbersStayNumbers) {
  EXPECT_EQ(cell("-6.2222"), "-6.2222");
  EXPECT_EQ(cell("-1e-7"), "-1e-7");
}

TEST(Csv, WhatOnlyLooksLikeANumberIsGuarded) {
  EXPECT_EQ(cell("\t5"), "'\t5");
  EXPECT_EQ(cell("+5"), "'+5");
  EXPECT_EQ(cell("-0x1F"), "'-0x1F");
  EXPECT_EQ(cell("-5 "), "'-5 ");
}

TEST(Csv, CommasQuotesAndLineBreaksAreQuoted) {
  EXPECT_EQ(cell("a,b"), "\"a,b\"");
  EXPECT_EQ(cell("say \"no\""), "\"say \"\"no\"\"\"");
  EXPECT_EQ(cell("a\nb"), "\"a\nb\"");
  EXPECT_EQ(cell("=A1,\"x\""), "\"'=A1,\"\"x\"\"\"");
}

TEST(Csv, RowsEndAsTheFormatDemands) {
  EXPECT_EQ(reports::csv_row({"a", "", "b"}), "a,,b\r\n");
  EXPECT_EQ(reports::csv_row({}), "\r\n");
}

}  // namespace
