// Reads the fields of one map in a file, and notes everything that is wrong with them.
//
//     Fields fields(node, "a translate step", problems);
//     step.target = fields.need_number("to_mm", {0.0, 5000.0});
//     fields.finish();                      // now unknown and missing keys are known
//
// Every accessor makes its key known. Where a value is wrong, the problem is noted and a harmless
// default is returned, so that reading goes on and all problems are found in one pass.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "curricula/curriculum.h"
#include "curricula/yaml_tree.h"

namespace curricula {

// What a number may be; the ends belong to it unless said otherwise.
struct Bounds {
  double low = 0.0, high = 0.0;
  bool above_low = false;  // the low end itself is excluded
};

class Fields {
 public:
  // `what` names the map in sentences: "a limit".
  Fields(const YamlNode& node, std::string what, Problems& problems);

  bool is_map() const { return node_.kind == YamlNode::Kind::map; }
  const YamlNode& node() const { return node_; }

  // The node itself, whatever it is; null when absent. `need` notes the absence.
  const YamlNode* find(std::string_view key);
  const YamlNode* need(std::string_view key);

  std::optional<double> number(std::string_view key, Bounds bounds);
  double need_number(std::string_view key, Bounds bounds);
  std::optional<std::int64_t> integer(std::string_view key, std::int64_t low, std::int64_t high);
  std::int64_t need_integer(std::string_view key, std::int64_t low, std::int64_t high);
  std::optional<bool> boolean(std::string_view key);

  // A word or sentence of 1 to `longest` bytes.
  std::optional<std::string> word(std::string_view key, std::size_t longest = 200);
  std::string need_word(std::string_view key, std::size_t longest = 200);
  std::string need_id(std::string_view key);  // a-z, 0-9, '-' and '_', beginning with a letter
  // One of `words`; the index into them.
  std::optional<std::size_t> choice(std::string_view key, const std::vector<std::string>& words);
  std::optional<std::size_t> need_choice(std::string_view key,
                                         const std::vector<std::string>& words);

  std::optional<Text> text(std::string_view key, std::size_t longest = 2000);  // {en: "..."}
  Text need_text(std::string_view key, std::size_t longest = 2000);

  // The items of a list; empty when absent or no list.
  std::vector<const YamlNode*> list(std::string_view key);
  std::vector<const YamlNode*> need_list(std::string_view key);  // and not empty
  // A list of words, and where each stands.
  struct Word {
    std::string text;
    const YamlNode* node = nullptr;
  };
  std::vector<Word> words(std::string_view key);

  // A key the format has but this version of the program does not act on.
  void unavailable(std::string_view key, const std::string& sentence);

  void finish();

 private:
  std::optional<double> read_number(const YamlNode& value, std::string_view key);

  const YamlNode& node_;
  std::string what_;
  Problems& problems_;
  std::vector<std::string> known_, missing_;
};

// Is it a word that may name something: a-z first, then a-z, 0-9, '-', '_', up to 64?
bool is_id(std::string_view word);

// "a list", "a number or word", ...: what a node is, for sentences.
std::string kind_text(const YamlNode& node);

// The words of a list of alternatives: "mark, fail or stop".
std::string alternatives(const std::vector<std::string>& words);

}  // namespace curricula
