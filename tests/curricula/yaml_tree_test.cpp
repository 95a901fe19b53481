#include "curricula/yaml_tree.h"

#include <string>

#include <gtest/gtest.h>

#include "curricula/yaml_source.h"

namespace {

using curricula::parse_yaml;
using curricula::Problems;
using curricula::source_of;
using curricula::YamlNode;

YamlNode parsed(const std::string& text) {
  Problems problems;
  YamlNode root = parse_yaml(text, problems).root;
  for (const auto& problem : std::move(problems).sorted()) ADD_FAILURE() << problem.message;
  return root;
}

TEST(YamlTree, RemembersWhereEverythingStands) {
  const YamlNode root = parsed("a: 1\nlist:\n  - {b: two}\n  - \"3\"\n");
  ASSERT_EQ(root.kind, YamlNode::Kind::map);
  EXPECT_EQ(root.entries[1].key.line, 2);
  const YamlNode* list = root.find("list");
  ASSERT_NE(list, nullptr);
  ASSERT_EQ(list->items.size(), 2U);
  const YamlNode* two = list->items[0].find("b");
  ASSERT_NE(two, nullptr);
  EXPECT_EQ(two->text, "two");
  EXPECT_EQ(two->line, 3);
  EXPECT_EQ(two->column, 9);
  EXPECT_EQ(two->begin, 19U);
  EXPECT_FALSE(two->quoted);
  EXPECT_TRUE(list->items[1].quoted);
  EXPECT_EQ(root.find("nothing"), nullptr);
}

TEST(YamlTree, CountsBytesForTextAndCharactersForPeople) {
  const YamlNode root = parsed("\xC3\xA4\xC3\xB6: {\xC3\xBC: x}\n");  // two letters, then one
  const YamlNode* x = root.entries[0].value.find("\xC3\xBC");
  ASSERT_NE(x, nullptr);
  EXPECT_EQ(x->column, 9);
  EXPECT_EQ(x->begin, 11U);
}

TEST(YamlTree, KeepsWhatStandsBeforeASyntaxError) {
  Problems problems;
  const auto tree = parse_yaml("a: 1\nb: {c: 2\nd: [\n", problems);
  EXPECT_TRUE(tree.truncated);
  ASSERT_NE(tree.root.find("a"), nullptr);
  EXPECT_EQ(tree.root.find("a")->text, "1");
  EXPECT_FALSE(tree.root.complete);
  EXPECT_TRUE(problems.any_error());
}

TEST(YamlTree, SourceOfABlockMapLosesItsIndentation) {
  const std::string text =
      "list:\n  - a: 1\n    b:\n      c: 2\n  # about the next\n\n  - d: 3\nend: 4\n";
  const YamlNode root = parsed(text);
  const auto& items = root.find("list")->items;
  EXPECT_EQ(source_of(text, items[0], items[1].begin), "a: 1\nb:\n  c: 2\n");
  EXPECT_EQ(source_of(text, items[1], root.entries[1].key.begin), "d: 3\n");
}

TEST(YamlTree, SourceOfTheLastMapEndsWithTheFile) {
  const std::string text = "list:\n- a: 1\n  b: 2";
  const YamlNode root = parsed(text);
  EXPECT_EQ(source_of(text, root.find("list")->items[0], text.size()), "a: 1\nb: 2\n");
}

TEST(YamlTree, SourceOfAFlowMapEndsWithItsBracket) {
  const std::string text = "list: [{a: \"}]\", b: it's, c: {d: '{'}} , {e: 1}]\n";
  const YamlNode root = parsed(text);
  const auto& items = root.find("list")->items;
  ASSERT_EQ(items.size(), 2U);
  EXPECT_EQ(source_of(text, items[0], items[1].begin), "{a: \"}]\", b: it's, c: {d: '{'}}\n");
  EXPECT_EQ(source_of(text, items[1], text.size()), "{e: 1}\n");
}

}  // namespace
