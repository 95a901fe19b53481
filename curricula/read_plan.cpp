#include "curricula/read_plan.h"

namespace curricula {

BlockDraft read_block(const YamlNode& node, Problems& problems) {
  Fields fields(node, "a block of the plan", problems);
  BlockDraft draft;
  draft.node = &node;
  draft.block.id = fields.need_id("block");
  draft.id_node = draft.block.id.empty() ? nullptr : fields.find("block");
  draft.block.title = fields.text("title", 200).value_or(Text{});
  fields.need_list("exercises");
  draft.exercises = fields.words("exercises");
  for (const Fields::Word& word : draft.exercises) draft.block.exercises.push_back(word.text);
  const auto order = fields.choice("order", {"any", "listed"});
  draft.block.any_order = !order || *order == 0;
  draft.block.max_trials_per_day =
      static_cast<int>(fields.integer("max_trials_per_day", 0, 1000).value_or(0));
  draft.block.after = fields.word("after").value_or("");
  if (!draft.block.after.empty()) draft.after_node = fields.find("after");
  fields.choice("unlock", {"proficiency"});
  fields.finish();
  return draft;
}

std::vector<Fields::Word> read_completion(const YamlNode& node, Problems& problems) {
  Fields fields(node, "'completion'", problems);
  fields.boolean("all_blocks");
  fields.choice("sign_off", {"instructor", "none"});
  std::vector<Fields::Word> exercises;
  if (const YamlNode* retention = fields.find("retention_test")) {
    Fields test(*retention, "the retention test", problems);
    test.need_integer("after_days", 1, 3650);
    test.need_list("exercises");
    exercises = test.words("exercises");
    test.need_integer("trials", 1, 100);
    test.finish();
    problems.warning(*retention,
                     "this version of the program does not call for retention tests yet: "
                     "this is kept in the file only");
  }
  fields.finish();
  return exercises;
}

}  // namespace curricula
