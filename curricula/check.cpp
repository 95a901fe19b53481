#include "curricula/check.h"

#include <exception>
#include <limits>
#include <utility>

#include "curricula/cross_check.h"
#include "curricula/fields.h"
#include "curricula/read_benchmarks.h"
#include "curricula/read_exercise.h"
#include "curricula/read_plan.h"
#include "curricula/semantic_version.h"
#include "curricula/sha256.h"
#include "curricula/yaml_source.h"
#include "curricula/yaml_tree.h"

namespace curricula {
namespace {

constexpr const char* kSchema = "cathedra-curriculum/1";
constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";

void read_schema(Fields& fields, Problems& problems) {
  const std::string schema = fields.need_word("schema");
  if (schema.empty() || schema == kSchema) return;
  problems.error(*fields.find("schema"), "the schema is '" + schema.substr(0, 64) +
                                             "', but this program reads '" + kSchema +
                                             "': write that, or use the program of that schema");
}

void read_identity(Fields& fields, Curriculum& curriculum, Problems& problems) {
  curriculum.id = fields.need_id("id");
  curriculum.version = fields.need_word("version");
  if (!curriculum.version.empty() && !parse_version(curriculum.version)) {
    problems.error(*fields.find("version"), "the version is '" + curriculum.version.substr(0, 64) +
                                                "': write three numbers, as in 1.0.0");
  }
  const auto status = fields.need_choice("status", {"draft", "published", "retired"});
  if (status) curriculum.status = static_cast<Lifecycle>(*status);
  curriculum.title = fields.need_text("title", 200);
  for (const Fields::Word& author : fields.words("authors"))
    curriculum.authors.push_back(author.text);
}

// The byte at which the item after `i` begins, or what follows the whole list.
std::size_t next_begin(const YamlNode& root, const YamlNode& list, std::size_t i, std::size_t end) {
  if (i + 1 < list.items.size()) return list.items[i + 1].begin;
  for (const YamlEntry& entry : root.entries) {
    if (entry.key.begin > list.items[i].begin) return entry.key.begin;
  }
  return end;
}

Drafts read_parts(Fields& fields, Curriculum& curriculum, const Catalogue& catalogue,
                  bool truncated, std::string_view text, Problems& problems) {
  Drafts drafts;
  drafts.truncated = truncated;
  ExerciseDefaults defaults;
  if (const YamlNode* node = fields.find("defaults")) defaults = read_defaults(*node, problems);
  if (const YamlNode* node = fields.find("benchmarks")) {
    curriculum.benchmarks = read_benchmarks(*node, problems);
  }
  const ExerciseContext context{catalogue, curriculum.benchmarks, defaults, truncated};
  const std::vector<const YamlNode*> exercises = fields.need_list("exercises");
  for (std::size_t i = 0; i < exercises.size(); ++i) {
    drafts.exercises.push_back(read_exercise(*exercises[i], context, problems));
    if (exercises[i]->kind != YamlNode::Kind::map) continue;
    const YamlNode& list = *fields.find("exercises");
    drafts.exercises.back().exercise.yaml =
        source_of(text, *exercises[i], next_begin(fields.node(), list, i, text.size()));
  }
  for (const YamlNode* block : fields.need_list("plan")) {
    drafts.blocks.push_back(read_block(*block, problems));
  }
  if (const YamlNode* node = fields.find("completion")) {
    drafts.retention = read_completion(*node, problems);
  }
  return drafts;
}

Curriculum read_curriculum(std::string_view text, const Catalogue& catalogue, Problems& problems) {
  Curriculum curriculum;
  const YamlTree tree = parse_yaml(text, problems);
  if (tree.root.kind == YamlNode::Kind::unusable) return curriculum;
  Fields fields(tree.root, "a curriculum", problems);
  read_schema(fields, problems);
  read_identity(fields, curriculum, problems);
  Drafts drafts = read_parts(fields, curriculum, catalogue, tree.truncated, text, problems);
  fields.finish();
  cross_check(drafts, problems);
  for (ExerciseDraft& draft : drafts.exercises)
    curriculum.exercises.push_back(std::move(draft.exercise));
  for (BlockDraft& draft : drafts.blocks) curriculum.plan.push_back(std::move(draft.block));
  return curriculum;
}

}  // namespace

CheckResult check(const std::string& text, const Catalogue& catalogue) {
  CheckResult result;
  Problems problems;
  try {
    std::string_view content = text;
    if (content.starts_with(kByteOrderMark)) content.remove_prefix(kByteOrderMark.size());
    Curriculum curriculum = read_curriculum(content, catalogue, problems);
    if (!problems.any_error()) {
      curriculum.sha256 = sha256_hex(text);
      curriculum.yaml = text;
      result.curriculum = std::move(curriculum);
    }
  } catch (const std::exception& exception) {
    // out of memory, say: the caller was promised an answer
    problems.error(
        1, 1,
        std::string("the file could not be checked (") + exception.what() + "): make it smaller");
  }
  result.problems = std::move(problems).sorted();
  return result;
}

}  // namespace curricula
