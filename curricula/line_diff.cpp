#include "curricula/line_diff.h"

#include <algorithm>
#include <cstdint>

namespace curricula {
namespace {

using Lines = std::vector<std::string_view>;

constexpr std::size_t kLargestTable = 4'000'000;  // pairs of lines compared

Lines lines_of(std::string_view text) {
  Lines lines;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    std::string_view line = text.substr(0, end);
    if (line.ends_with('\r')) line.remove_suffix(1);
    lines.push_back(line);
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return lines;
}

int line_number(std::size_t index) { return static_cast<int>(index) + 1; }

// The middle parts of two texts that differ at both ends, by their longest common subsequence.
class Middle {
 public:
  Middle(const Lines& before, const Lines& after, std::size_t begin, std::size_t before_end,
         std::size_t after_end)
      : before_(before),
        after_(after),
        begin_(begin),
        rows_(before_end - begin),
        columns_(after_end - begin) {}

  void append_to(std::vector<DiffLine>& out) {
    const bool small = rows_ == 0 || columns_ == 0 || rows_ <= kLargestTable / columns_;
    if (small) fill_table();
    std::size_t i = 0, j = 0;
    while (i < rows_ || j < columns_) {
      if (small && i < rows_ && j < columns_ && equal(i, j)) {
        out.push_back({DiffLine::Kind::same, std::string(before_[begin_ + i]),
                       line_number(begin_ + i), line_number(begin_ + j)});
        ++i, ++j;
      } else if (i < rows_ && (j == columns_ || !small || length(i + 1, j) >= length(i, j + 1))) {
        out.push_back({DiffLine::Kind::removed, std::string(before_[begin_ + i]),
                       line_number(begin_ + i), 0});
        ++i;
      } else {
        out.push_back(
            {DiffLine::Kind::added, std::string(after_[begin_ + j]), 0, line_number(begin_ + j)});
        ++j;
      }
    }
  }

 private:
  bool equal(std::size_t i, std::size_t j) const {
    return before_[begin_ + i] == after_[begin_ + j];
  }
  std::uint32_t& length(std::size_t i, std::size_t j) { return table_[i * (columns_ + 1) + j]; }

  // length(i, j): lines in common from i and j on
  void fill_table() {
    table_.assign((rows_ + 1) * (columns_ + 1), 0);
    for (std::size_t i = rows_; i-- > 0;) {
      for (std::size_t j = columns_; j-- > 0;) {
        length(i, j) =
            equal(i, j) ? length(i + 1, j + 1) + 1 : std::max(length(i + 1, j), length(i, j + 1));
      }
    }
  }

  const Lines& before_;
  const Lines& after_;
  std::size_t begin_, rows_, columns_;
  std::vector<std::uint32_t> table_;
};

}  // namespace

std::vector<DiffLine> line_diff(std::string_view before_text, std::string_view after_text) {
  const Lines before = lines_of(before_text), after = lines_of(after_text);
  std::size_t begin = 0;
  while (begin < std::min(before.size(), after.size()) && before[begin] == after[begin]) ++begin;
  std::size_t before_end = before.size(), after_end = after.size();
  while (before_end > begin && after_end > begin &&
         before[before_end - 1] == after[after_end - 1]) {
    --before_end, --after_end;
  }

  std::vector<DiffLine> result;
  const auto same = [&](std::size_t i, std::size_t j) {
    result.push_back(
        {DiffLine::Kind::same, std::string(before[i]), line_number(i), line_number(j)});
  };
  for (std::size_t i = 0; i < begin; ++i) same(i, i);
  Middle(before, after, begin, before_end, after_end).append_to(result);
  for (std::size_t i = before_end, j = after_end; i < before.size(); ++i, ++j) same(i, j);
  return result;
}

}  // namespace curricula
