#include "app/server/csv_reader.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

namespace app {
namespace {

std::string_view without_mark(std::string_view text) {
  constexpr std::string_view kMark = "\xef\xbb\xbf";
  if (text.starts_with(kMark)) text.remove_prefix(kMark.size());
  return text;
}

// Outside quotes, in the first line that is not empty.
char separator_of(std::string_view text) {
  constexpr std::array kSeparators = {',', ';', '\t'};
  std::array<int, kSeparators.size()> counts{};
  const std::size_t start = std::min(text.find_first_not_of("\r\n"), text.size());
  bool quoted = false;
  for (const char c : text.substr(start)) {
    if (c == '"') quoted = !quoted;
    if (quoted) continue;
    if (c == '\r' || c == '\n') break;
    for (std::size_t i = 0; i < kSeparators.size(); ++i) counts[i] += c == kSeparators[i] ? 1 : 0;
  }
  const auto most = std::max_element(counts.begin(), counts.end());
  return kSeparators[static_cast<std::size_t>(most - counts.begin())];
}

class Reader {
 public:
  explicit Reader(std::string_view text) : text_(without_mark(text)) {
    result_.separator = separator_of(text_);
  }

  CsvText read() {
    while (at_ < text_.size()) read_row();
    return std::move(result_);
  }

 private:
  bool at_end_of_row() const {
    return at_ >= text_.size() || text_[at_] == '\r' || text_[at_] == '\n';
  }

  // "\r\n", "\n" and "\r" each end one line.
  void pass_line_end() {
    const bool both = at_ < text_.size() && text_[at_] == '\r' && next_is('\n');
    at_ += both ? 2 : 1;
    ++line_;
  }

  void read_row() {
    CsvRow row;
    row.line = line_;
    for (;;) {
      row.cells.push_back(read_cell(row));
      if (at_end_of_row()) break;
      ++at_;  // the separator
    }
    pass_line_end();
    const bool blank = row.cells.size() == 1 && row.cells.front().empty() && row.problem.empty();
    if (!blank) result_.rows.push_back(std::move(row));
  }

  std::string read_cell(CsvRow& row) {
    std::string cell;
    if (at_ < text_.size() && text_[at_] == '"') cell = read_quoted(row);
    const std::size_t end = text_.find_first_of(std::string{result_.separator, '\r', '\n'}, at_);
    const std::string_view rest =
        text_.substr(at_, end == std::string_view::npos ? end : end - at_);
    at_ += rest.size();
    return cell + std::string(rest);
  }

  // From the opening quote to the closing one; "" is a quote.
  std::string read_quoted(CsvRow& row) {
    const int opened = line_;
    std::string cell;
    for (++at_; at_ < text_.size(); ++at_) {
      if (text_[at_] == '"') {
        const bool doubled = at_ + 1 < text_.size() && text_[at_ + 1] == '"';
        if (!doubled) break;
        ++at_;
      }
      if (text_[at_] == '\n' || (text_[at_] == '\r' && !next_is('\n'))) ++line_;
      cell += text_[at_];
    }
    if (at_ >= text_.size()) {
      row.problem = "a quote is opened and never closed: close it, or double it to keep it as text";
      if (result_.unclosed_line == 0) result_.unclosed_line = opened;
      return cell;
    }
    ++at_;  // the closing quote
    if (!at_end_of_row() && text_[at_] != result_.separator) {
      row.problem = "text follows a closing quote: double quotes that belong to the text";
    }
    return cell;
  }

  bool next_is(char c) const { return at_ + 1 < text_.size() && text_[at_ + 1] == c; }

  std::string_view text_;
  std::size_t at_ = 0;
  int line_ = 1;
  CsvText result_;
};

}  // namespace

CsvText read_csv(std::string_view text) { return Reader(text).read(); }

}  // namespace app
