#include "curricula/yaml_tree.h"

#include <algorithm>
#include <exception>
#include <istream>
#include <optional>
#include <streambuf>
#include <unordered_set>
#include <utility>

#include <yaml-cpp/eventhandler.h>
#include <yaml-cpp/yaml.h>

namespace curricula {
namespace {

constexpr const char* kAliasRefused =
    "aliases (*name) are not part of the format: write the value out";

// Thrown by the builder to leave yaml-cpp; what was wrong is noted already.
struct Stop {
  bool truncated = false;  // the first document was not read to its end
};

// Where a byte stands. The events come almost in order, so that the cursor moves on from the last
// place instead of counting from the top.
class Cursor {
 public:
  explicit Cursor(std::string_view text) : text_(text) {}

  void move_to(std::size_t byte) {
    byte = std::min(byte, text_.size());
    if (byte < at_) at_ = 0, line_ = 1, column_ = 1;
    for (; at_ < byte; ++at_) {
      if (text_[at_] == '\n') {
        ++line_;
        column_ = 1;
      } else if ((static_cast<unsigned char>(text_[at_]) & 0xC0U) != 0x80U) {
        ++column_;  // bytes that continue a character do not count
      }
    }
  }
  int line() const { return line_; }
  int column() const { return column_; }

 private:
  std::string_view text_;
  std::size_t at_ = 0;
  int line_ = 1, column_ = 1;
};

// Builds the tree from yaml-cpp's events and refuses what the subset does not have.
class TreeBuilder : public YAML::EventHandler {
 public:
  TreeBuilder(std::string_view text, Problems& problems)
      : text_(text), problems_(problems), cursor_(text) {}

  void OnDocumentStart(const YAML::Mark& mark) override {
    if (!has_root_) return;
    // yaml-cpp would go on to it; nobody would see what it says
    problems_.error(place(mark, YamlNode::Kind::null),
                    "a second document begins here: one file holds one document");
    throw Stop{};
  }
  void OnDocumentEnd() override {}

  void OnNull(const YAML::Mark& mark, YAML::anchor_t anchor) override {
    YamlNode node = place(mark, YamlNode::Kind::null);
    refuse_anchor(node, anchor);
    attach(std::move(node));
  }

  void OnAlias(const YAML::Mark& mark, YAML::anchor_t) override {
    const YamlNode node = place(mark, YamlNode::Kind::unusable);
    problems_.error(node, kAliasRefused);
    attach(node);
  }

  void OnScalar(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                const std::string& value) override {
    YamlNode node = place(mark, YamlNode::Kind::scalar);
    refuse_tag(node, tag);
    refuse_anchor(node, anchor);
    node.text = value;
    node.quoted = tag == "!" && text_[std::min(node.begin, text_.size() - 1)] != '!';
    attach(std::move(node));
  }

  void OnSequenceStart(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                       YAML::EmitterStyle::value style) override {
    open(mark, YamlNode::Kind::list, tag, anchor, style);
  }
  void OnSequenceEnd() override { close(); }

  void OnMapStart(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                  YAML::EmitterStyle::value style) override {
    open(mark, YamlNode::Kind::map, tag, anchor, style);
  }
  void OnMapEnd() override { close(); }

  // What was still open when the parser gave up is kept and marked as cut short.
  YamlNode finish() {
    while (!open_.empty()) {
      open_.back().node.complete = false;
      close();
    }
    return std::move(root_);
  }

  bool has_root() const { return has_root_; }

 private:
  struct Open {
    YamlNode node;
    std::optional<YamlNode> key;  // read, its value is still to come
    std::unordered_set<std::string> keys;
  };

  YamlNode place(const YAML::Mark& mark, YamlNode::Kind kind) {
    YamlNode node;
    node.kind = kind;
    node.begin = mark.pos > 0 ? static_cast<std::size_t>(mark.pos) : 0;
    cursor_.move_to(node.begin);
    node.line = cursor_.line();
    node.column = cursor_.column();
    return node;
  }

  void refuse_anchor(const YamlNode& node, YAML::anchor_t anchor) {
    if (anchor != 0) {
      problems_.error(node, "anchors (&name) are not part of the format: take the '&name' out");
    }
  }

  // "?" stands for no tag; "!" for a quoted scalar, unless the file really says so
  void refuse_tag(const YamlNode& node, const std::string& tag) {
    const bool written = node.begin < text_.size() && text_[node.begin] == '!';
    if ((tag != "?" && tag != "!" && !tag.empty()) || written) {
      problems_.error(node, "tags (!name) are not part of the format: take the tag out");
    }
  }

  void open(const YAML::Mark& mark, YamlNode::Kind kind, const std::string& tag,
            YAML::anchor_t anchor, YAML::EmitterStyle::value style) {
    YamlNode node = place(mark, kind);
    refuse_tag(node, tag);
    refuse_anchor(node, anchor);
    node.flow = style == YAML::EmitterStyle::Flow;
    if (open_.size() >= kDepthLimit) {
      problems_.error(node, "the file is nested more than 32 levels deep: flatten it");
      throw Stop{true};
    }
    open_.push_back({std::move(node), std::nullopt, {}});
  }

  void close() {
    YamlNode node = std::move(open_.back().node);
    if (open_.back().key) {  // only when cut short between a key and its value
      YamlNode nothing = *open_.back().key;
      nothing.kind = YamlNode::Kind::unusable;
      node.entries.push_back({std::move(*open_.back().key), std::move(nothing)});
    }
    open_.pop_back();
    attach(std::move(node));
  }

  void attach(YamlNode node) {
    if (open_.empty()) {
      root_ = std::move(node);
      has_root_ = true;
      return;
    }
    Open& parent = open_.back();
    if (parent.node.kind == YamlNode::Kind::list) {
      parent.node.items.push_back(std::move(node));
    } else if (!parent.key) {
      accept_key(parent, std::move(node));
    } else {
      if (node.kind == YamlNode::Kind::null) {  // yaml-cpp places nothing at what comes next
        node.line = parent.key->line;
        node.column = parent.key->column;
        node.begin = parent.key->begin;
      }
      parent.node.entries.push_back({std::move(*parent.key), std::move(node)});
      parent.key.reset();
    }
  }

  void accept_key(Open& parent, YamlNode key) {
    if (key.kind != YamlNode::Kind::scalar) {
      if (key.kind != YamlNode::Kind::unusable) {
        problems_.error(key, "a key must be a plain word, as in 'to_mm: 350'");
      }
      key.kind = YamlNode::Kind::unusable;
      key.items.clear();
      key.entries.clear();
    } else if (!parent.keys.insert(key.text).second) {
      problems_.error(key, "'" + key.text + "' stands here twice: take one of the two out");
      key.kind = YamlNode::Kind::unusable;
    }
    parent.key = std::move(key);
  }

  std::string_view text_;
  Problems& problems_;
  Cursor cursor_;
  std::vector<Open> open_;
  YamlNode root_;
  bool has_root_ = false;
};

// Bytes of the UTF-8 character that begins at `i`; 0 when there is none.
std::size_t character_length(std::string_view text, std::size_t i) {
  const auto byte = [&](std::size_t k) { return static_cast<unsigned char>(text[k]); };
  const unsigned char first = byte(i);
  if (first < 0x80) return 1;
  const std::size_t length = first >= 0xF0 ? 4 : first >= 0xE0 ? 3 : 2;
  if (first < 0xC2 || first > 0xF4 || i + length > text.size()) return 0;
  for (std::size_t k = 1; k < length; ++k) {
    if ((byte(i + k) & 0xC0U) != 0x80U) return 0;
  }
  // overlong forms, surrogates, and what lies beyond Unicode
  const unsigned char second = byte(i + 1);
  if (first == 0xE0 && second < 0xA0) return 0;
  if (first == 0xED && second > 0x9F) return 0;
  if (first == 0xF0 && second < 0x90) return 0;
  if (first == 0xF4 && second > 0x8F) return 0;
  return length;
}

// The characters are checked before the parser sees them: it takes some control characters for
// the end of the file and guesses at other encodings.
bool characters_are_fine(std::string_view text, Problems& problems) {
  Cursor cursor(text);
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t length = character_length(text, i);
    const auto byte = static_cast<unsigned char>(text[i]);
    const bool line_end =
        byte == '\n' || (byte == '\r' && i + 1 < text.size() && text[i + 1] == '\n');
    const bool control = (byte < 0x20 && byte != '\t' && !line_end) || byte == 0x7F;
    if (length == 0 || control) {
      cursor.move_to(i);
      problems.error(cursor.line(), cursor.column(),
                     length == 0 ? "this byte is not UTF-8: save the file as UTF-8"
                                 : "a control character stands here: take it out");
      return false;
    }
    i += length;
  }
  return true;
}

// An input stream over text that somebody else keeps.
class ViewBuffer : public std::streambuf {
 public:
  explicit ViewBuffer(std::string_view text) {
    char* begin = const_cast<char*>(text.data());  // streambuf's interface; it is only read
    setg(begin, begin, begin + text.size());
  }
};

void parse_into(TreeBuilder& builder, std::string_view text) {
  ViewBuffer buffer(text);
  std::istream stream(&buffer);
  YAML::Parser parser(stream);
  while (parser.HandleNextDocument(builder)) {
  }
}

void report_syntax(std::string_view text, const YAML::Exception& exception, Problems& problems) {
  Cursor cursor(text);
  const auto at = static_cast<std::size_t>(std::max(exception.mark.pos, 0));
  cursor.move_to(at);
  if (at < text.size() && text[at] == '*') {  // an alias of nothing stops yaml-cpp
    problems.error(cursor.line(), cursor.column(), kAliasRefused);
    return;
  }
  problems.error(
      cursor.line(), cursor.column(),
      "the YAML cannot be read from here on (" + exception.msg +
          "): look at the indentation, brackets and quotes of this line and the one above");
}

}  // namespace

const YamlNode* YamlNode::find(std::string_view key) const {
  for (const YamlEntry& entry : entries) {
    if (entry.key.kind == Kind::scalar && entry.key.text == key) return &entry.value;
  }
  return nullptr;
}

YamlTree parse_yaml(std::string_view text, Problems& problems) {
  YamlTree tree;
  tree.truncated = true;
  tree.root.kind = YamlNode::Kind::unusable;
  if (text.size() > kFileSizeLimit) {
    problems.error(1, 1, "the file is larger than 1 MiB: split it");
    return tree;
  }
  if (!characters_are_fine(text, problems)) return tree;

  TreeBuilder builder(text, problems);
  try {
    parse_into(builder, text);
    tree.truncated = false;
  } catch (const Stop& stop) {
    tree.truncated = stop.truncated;
  } catch (const YAML::Exception& exception) {
    report_syntax(text, exception, problems);
  } catch (const std::exception& exception) {
    problems.error(1, 1,
                   std::string("the YAML cannot be read (") + exception.what() +
                       "): write it anew from an exercise that works");
  }
  YamlNode root = builder.finish();
  if (builder.has_root()) {
    tree.root = std::move(root);
  } else if (!tree.truncated) {
    problems.error(1, 1, "the file is empty: begin with its 'schema:'");
  }
  return tree;
}

}  // namespace curricula
