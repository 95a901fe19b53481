#include "curricula/fields.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <utility>

#include "curricula/nearest.h"
#include "curricula/number_text.h"

namespace curricula {
namespace {

std::string quoted(std::string_view word) {
  // a long value would bury the sentence
  constexpr std::size_t kLongest = 60;
  if (word.size() <= kLongest) return "'" + std::string(word) + "'";
  std::size_t cut = kLongest;
  while (cut > 0 && (static_cast<unsigned char>(word[cut]) & 0xC0U) == 0x80U) --cut;
  return "'" + std::string(word.substr(0, cut)) + "...'";
}

bool is_word(const YamlNode& node) { return node.kind == YamlNode::Kind::scalar; }

// What YAML writes for not-a-number and the infinities.
bool is_special_number(std::string_view word) {
  static constexpr std::array kWords = {".nan", ".NaN",  ".NAN",  ".inf",  ".Inf",
                                        ".INF", "-.inf", "-.Inf", "-.INF", "+.inf",
                                        "nan",  "NaN",   "inf",   "-inf",  "Infinity"};
  return std::find(kWords.begin(), kWords.end(), word) != kWords.end();
}

std::string range_text(const Bounds& bounds) {
  return (bounds.above_low ? "above " : "from ") + number_text(bounds.low) +
         (bounds.above_low ? " up to " : " to ") + number_text(bounds.high);
}

// Is `known` the key `word` with its unit added or changed, as to_mm is to 'to' and 'to_cm'?
bool adds_unit(std::string_view known, std::string_view word) {
  static constexpr std::array<std::string_view, 8> kUnits = {"mm",   "deg",   "s",  "n",
                                                             "n_mm", "n_mm2", "ml", "days"};
  for (const std::string_view unit : kUnits) {
    if (known == std::string(word) + "_" + std::string(unit)) return true;
  }
  return false;
}

}  // namespace

bool is_id(std::string_view word) {
  const auto lower = [](char c) { return c >= 'a' && c <= 'z'; };
  return !word.empty() && word.size() <= 64 && lower(word[0]) &&
         std::all_of(word.begin(), word.end(), [&](char c) {
           return lower(c) || (c >= '0' && c <= '9') || c == '-' || c == '_';
         });
}

std::string kind_text(const YamlNode& node) {
  switch (node.kind) {
    case YamlNode::Kind::null:
      return "nothing";
    case YamlNode::Kind::scalar:
      return quoted(node.text);
    case YamlNode::Kind::list:
      return "a list";
    case YamlNode::Kind::map:
      return "a map";
    case YamlNode::Kind::unusable:
      break;
  }
  return "something refused";
}

std::string alternatives(const std::vector<std::string>& words) {
  std::string result;
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (i > 0) result += i + 1 == words.size() ? " or " : ", ";
    result += words[i];
  }
  return result;
}

Fields::Fields(const YamlNode& node, std::string what, Problems& problems)
    : node_(node), what_(std::move(what)), problems_(problems) {
  if (!is_map() && node.kind != YamlNode::Kind::unusable) {
    problems_.error(node, what_ + " must be a map of 'key: value' lines, here it is " +
                              kind_text(node) + ": write its fields out");
  }
}

const YamlNode* Fields::find(std::string_view key) {
  known_.emplace_back(key);
  return node_.find(key);
}

const YamlNode* Fields::need(std::string_view key) {
  const YamlNode* value = find(key);
  if (!value && is_map()) missing_.emplace_back(key);
  return value;
}

std::optional<double> Fields::read_number(const YamlNode& value, std::string_view key) {
  const std::string name = quoted(key);
  if (value.kind == YamlNode::Kind::unusable) return {};
  if (!is_word(value)) {
    problems_.error(value, name + " must be a number, here it is " + kind_text(value) +
                               ": write the number after the colon");
    return {};
  }
  if (is_special_number(value.text)) {
    problems_.error(value, name + " is " + quoted(value.text) + ": write a finite number");
    return {};
  }
  std::string_view digits = value.text;
  if (!digits.empty() && digits.front() == '+') digits.remove_prefix(1);
  double number = 0.0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), number);
  const bool all_read = end == digits.data() + digits.size();
  if (error == std::errc::result_out_of_range) {
    problems_.error(value, name + " is too large or too small a number: write one in range");
    return {};
  }
  if (error != std::errc{} || !all_read || !std::isfinite(number)) {
    const bool starts_as_number = error == std::errc{} && end != digits.data();
    problems_.error(value, name + " must be a number, but " + quoted(value.text) + " is not one: " +
                               (starts_as_number && *end != ','
                                    ? "write the number alone, its unit is in the key"
                                    : "write it in digits, with a dot for decimals"));
    return {};
  }
  if (value.quoted) {
    problems_.error(value, name + " must be a number: take the quotes off " + quoted(value.text));
    return {};
  }
  return number;
}

std::optional<double> Fields::number(std::string_view key, Bounds bounds) {
  const YamlNode* value = find(key);
  if (!value) return {};
  const std::optional<double> number = read_number(*value, key);
  if (!number) return {};
  const bool below = bounds.above_low ? *number <= bounds.low : *number < bounds.low;
  if (below || *number > bounds.high) {
    problems_.error(*value, quoted(key) + " is " + quoted(value->text) + ": write a number " +
                                range_text(bounds));
    return {};
  }
  return number;
}

double Fields::need_number(std::string_view key, Bounds bounds) {
  if (!need(key)) return bounds.low;
  return number(key, bounds).value_or(bounds.low);
}

std::optional<std::int64_t> Fields::integer(std::string_view key, std::int64_t low,
                                            std::int64_t high) {
  const YamlNode* value = find(key);
  if (!value) return {};
  const std::optional<double> number = read_number(*value, key);
  if (!number) return {};
  const bool whole = *number == std::floor(*number);
  if (!whole || *number < static_cast<double>(low) || *number > static_cast<double>(high)) {
    problems_.error(*value, quoted(key) + " is " + quoted(value->text) +
                                ": write a whole number from " + std::to_string(low) + " to " +
                                std::to_string(high));
    return {};
  }
  return static_cast<std::int64_t>(*number);
}

std::int64_t Fields::need_integer(std::string_view key, std::int64_t low, std::int64_t high) {
  if (!need(key)) return low;
  return integer(key, low, high).value_or(low);
}

std::optional<bool> Fields::boolean(std::string_view key) {
  const YamlNode* value = find(key);
  if (!value || value->kind == YamlNode::Kind::unusable) return {};
  if (is_word(*value) && !value->quoted && value->text == "true") return true;
  if (is_word(*value) && !value->quoted && value->text == "false") return false;
  problems_.error(*value, quoted(key) + " is " + kind_text(*value) + ": write true or false");
  return {};
}

std::optional<std::string> Fields::word(std::string_view key, std::size_t longest) {
  const YamlNode* value = find(key);
  if (!value || value->kind == YamlNode::Kind::unusable) return {};
  if (!is_word(*value) || value->text.empty()) {
    problems_.error(*value, quoted(key) + " must be a word or a sentence, here it is " +
                                kind_text(*value) + ": write it after the colon");
    return {};
  }
  if (value->text.size() > longest) {
    problems_.error(
        *value, quoted(key) + " is longer than " + std::to_string(longest) + " bytes: shorten it");
    return {};
  }
  return value->text;
}

std::string Fields::need_word(std::string_view key, std::size_t longest) {
  if (!need(key)) return {};
  return word(key, longest).value_or("");
}

std::string Fields::need_id(std::string_view key) {
  const YamlNode* value = need(key);
  if (!value) return {};
  const std::string id = word(key).value_or("");
  if (id.empty() || is_id(id)) return id;
  problems_.error(*value, quoted(id) +
                              " cannot be an id: use up to 64 small letters, digits, '-' "
                              "and '_', beginning with a letter");
  return {};
}

std::optional<std::size_t> Fields::choice(std::string_view key,
                                          const std::vector<std::string>& words) {
  const YamlNode* value = find(key);
  if (!value || value->kind == YamlNode::Kind::unusable) return {};
  const auto found =
      is_word(*value) ? std::find(words.begin(), words.end(), value->text) : words.end();
  if (found != words.end()) return static_cast<std::size_t>(found - words.begin());
  problems_.error(*value,
                  quoted(key) + " is " + kind_text(*value) + ": write " + alternatives(words));
  return {};
}

std::optional<std::size_t> Fields::need_choice(std::string_view key,
                                               const std::vector<std::string>& words) {
  if (!need(key)) return {};
  return choice(key, words);
}

std::optional<Text> Fields::text(std::string_view key, std::size_t longest) {
  const YamlNode* value = find(key);
  if (!value || value->kind == YamlNode::Kind::unusable) return {};
  if (value->kind != YamlNode::Kind::map) {
    problems_.error(*value, quoted(key) + " needs a language, here it is " + kind_text(*value) +
                                ": write {en: \"...\"}");
    return {};
  }
  Text result;
  for (const YamlEntry& entry : value->entries) {
    const std::string& language = entry.key.text;
    if (entry.key.kind == YamlNode::Kind::unusable) continue;
    if (language.size() != 2 || !is_id(language)) {
      problems_.error(entry.key,
                      quoted(language) + " is no language: use its two letters, as in en");
    } else if (!is_word(entry.value) || entry.value.text.empty()) {
      problems_.error(entry.value, quoted(key) + " in '" + language +
                                       "' must be a sentence: write it in quotes");
    } else if (entry.value.text.size() > longest) {
      problems_.error(entry.value, quoted(key) + " is longer than " + std::to_string(longest) +
                                       " bytes: shorten it");
    }
    result[language] = entry.value.text;
  }
  if (!result.contains("en") && value->complete) {
    problems_.error(*value, quoted(key) + " has no English text: add en: \"...\"");
  }
  return result;
}

Text Fields::need_text(std::string_view key, std::size_t longest) {
  if (!need(key)) return {};
  return text(key, longest).value_or(Text{});
}

std::vector<const YamlNode*> Fields::list(std::string_view key) {
  const YamlNode* value = find(key);
  std::vector<const YamlNode*> items;
  if (!value || value->kind == YamlNode::Kind::unusable) return items;
  if (value->kind != YamlNode::Kind::list) {
    problems_.error(*value, quoted(key) + " must be a list, here it is " + kind_text(*value) +
                                ": write [a, b] or one '- ' line each");
    return items;
  }
  for (const YamlNode& item : value->items) items.push_back(&item);
  return items;
}

std::vector<const YamlNode*> Fields::need_list(std::string_view key) {
  const YamlNode* value = need(key);
  if (!value) return {};
  if (value->kind == YamlNode::Kind::list && value->items.empty() && value->complete) {
    problems_.error(*value, quoted(key) + " is empty: write at least one item");
  }
  return list(key);
}

std::vector<Fields::Word> Fields::words(std::string_view key) {
  std::vector<Word> result;
  for (const YamlNode* item : list(key)) {
    if (is_word(*item) && !item->text.empty()) {
      result.push_back({item->text, item});
    } else if (item->kind != YamlNode::Kind::unusable) {
      problems_.error(*item, quoted(key) + " is a list of words, but here is " + kind_text(*item) +
                                 ": write a word");
    }
  }
  return result;
}

void Fields::unavailable(std::string_view key, const std::string& sentence) {
  if (const YamlNode* value = find(key)) problems_.error(*value, sentence);
}

void Fields::finish() {
  if (!is_map()) return;
  for (const YamlEntry& entry : node_.entries) {
    const std::string& key = entry.key.text;
    if (entry.key.kind != YamlNode::Kind::scalar) continue;
    if (std::find(known_.begin(), known_.end(), key) != known_.end()) continue;
    if (problems_.full()) {
      problems_.error(entry.key, {});
      continue;
    }

    const auto with_unit = std::find_if(known_.begin(), known_.end(),
                                        [&](const std::string& k) { return adds_unit(k, key); });
    std::string guess = with_unit != known_.end() ? *with_unit : nearest(key, known_);
    if (guess != "" && node_.find(guess)) guess.clear();  // it is there already
    if (guess.empty()) {
      problems_.error(entry.key, what_ + " has no " + quoted(key) + ": take it out");
    } else if (with_unit != known_.end()) {
      problems_.error(entry.key, quoted(key) + " lacks its unit: write '" + guess + "'");
    } else {
      problems_.error(entry.key,
                      what_ + " has no " + quoted(key) + ": did you mean '" + guess + "'?");
    }
    std::erase(missing_, guess);  // said once is enough
  }
  if (!node_.complete) return;  // the missing ones may stand behind the syntax error
  std::sort(missing_.begin(), missing_.end());
  missing_.erase(std::unique(missing_.begin(), missing_.end()), missing_.end());
  for (const std::string& key : missing_) {
    problems_.error(node_, what_ + " needs '" + key + "': add it");
  }
}

}  // namespace curricula
