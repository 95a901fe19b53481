// The words of an enumeration, one table for both directions so that they cannot disagree.
#pragma once

#include <cassert>
#include <span>
#include <string>

namespace assessment {

template <typename Value>
struct Word {
  Value value;
  const char* text;
};

template <typename Value>
const char* word_of(std::span<const Word<Value>> words, Value value) {
  for (const Word<Value>& entry : words) {
    if (entry.value == value) return entry.text;
  }
  assert(false && "an enumerator without a word");
  return "";
}

// Leaves `value` alone and returns false for a word that is not in the table.
template <typename Value>
bool value_of(std::span<const Word<Value>> words, const std::string& text, Value& value) {
  for (const Word<Value>& entry : words) {
    if (text == entry.text) {
      value = entry.value;
      return true;
    }
  }
  return false;
}

}  // namespace assessment
