#include "curricula/cross_check.h"

#include <algorithm>
#include <map>
#include <set>
#include <string>

#include "curricula/nearest.h"

namespace curricula {
namespace {

class CrossChecker {
 public:
  CrossChecker(const Drafts& drafts, Problems& problems) : drafts_(drafts), problems_(problems) {
    for (const ExerciseDraft& draft : drafts.exercises) {
      if (!draft.id_node) continue;
      exercise_ids_.push_back(draft.exercise.id);
      exercises_.emplace(draft.exercise.id, &draft);  // of two with one id the first
    }
    for (const BlockDraft& draft : drafts.blocks) {
      if (draft.id_node) block_ids_.push_back(draft.block.id);
    }
  }

  void run() {
    check_duplicates();
    check_requirements();
    check_blocks();
    for (const Fields::Word& word : drafts_.retention) find_exercise(word.text, *word.node);
    check_cycles();
  }

 private:
  void check_duplicates() {
    std::set<std::string> seen;
    for (const ExerciseDraft& draft : drafts_.exercises) {
      if (draft.id_node && !seen.insert(draft.exercise.id).second) {
        problems_.error(*draft.id_node, "exercise '" + draft.exercise.id +
                                            "' is there already: give this one another id");
      }
    }
    seen.clear();
    for (const BlockDraft& draft : drafts_.blocks) {
      if (draft.id_node && !seen.insert(draft.block.id).second) {
        problems_.error(*draft.id_node, "block '" + draft.block.id +
                                            "' is there already: give this one another id");
      }
    }
  }

  const ExerciseDraft* find_exercise(const std::string& id, const YamlNode& at) {
    const auto found = exercises_.find(id);
    if (found != exercises_.end()) return found->second;
    report_unknown("exercise", id, at, exercise_ids_);
    return nullptr;
  }

  void report_unknown(const char* what, const std::string& id, const YamlNode& at,
                      const std::vector<std::string>& known) {
    if (drafts_.truncated) return;
    const std::string guess = problems_.full() ? "" : nearest(id, known);
    problems_.error(
        at,
        std::string("there is no ") + what + " '" + id.substr(0, 64) + "' in this file: " +
            (guess.empty() ? "add it or take its name out here" : "did you mean '" + guess + "'?"));
  }

  // Somebody must be able to become proficient in what others require.
  void check_can_be_met(const ExerciseDraft& draft, const YamlNode& at, const std::string& who) {
    std::vector<std::string> lacks;
    if (!draft.node->complete) return;
    if (!draft.has_record) lacks.emplace_back("'record'");
    if (!draft.has_pass) lacks.emplace_back("'pass'");
    if (!draft.has_proficiency) lacks.emplace_back("'proficiency'");
    if (lacks.empty()) return;
    std::string list = lacks[0];
    for (std::size_t i = 1; i < lacks.size(); ++i)
      list += (i + 1 == lacks.size() ? " and " : ", ") + lacks[i];
    problems_.error(at, who + " requires '" + draft.exercise.id +
                            "', which has no way to become "
                            "proficient: add " +
                            list + " to it");
  }

  void check_requirements() {
    for (const ExerciseDraft& draft : drafts_.exercises) {
      for (const auto& requirement : draft.requirements) {
        const ExerciseDraft* required = find_exercise(requirement.exercise, *requirement.at);
        if (required) check_can_be_met(*required, *requirement.at, "'" + draft.exercise.id + "'");
      }
    }
  }

  void check_blocks() {
    std::map<std::string, std::string> block_of;
    for (const BlockDraft& draft : drafts_.blocks) {
      for (const Fields::Word& word : draft.exercises) {
        if (!find_exercise(word.text, *word.node)) continue;
        const auto [place, is_new] = block_of.emplace(word.text, draft.block.id);
        if (!is_new) {
          problems_.error(*word.node, "'" + word.text + "' is in block '" + place->second +
                                          "' already: take it out of one of the two");
        }
      }
      if (draft.after_node) check_after(draft);
    }
    if (drafts_.truncated || drafts_.blocks.empty()) return;
    for (const ExerciseDraft& draft : drafts_.exercises) {
      if (draft.id_node && !block_of.contains(draft.exercise.id)) {
        problems_.warning(*draft.id_node, "'" + draft.exercise.id +
                                              "' is in no block of the plan, so that "
                                              "nobody is led to it: add it to one");
      }
    }
  }

  void check_after(const BlockDraft& draft) {
    const auto before = std::find_if(
        drafts_.blocks.begin(), drafts_.blocks.end(),
        [&](const BlockDraft& b) { return b.id_node && b.block.id == draft.block.after; });
    if (before == drafts_.blocks.end()) {
      report_unknown("block", draft.block.after, *draft.after_node, block_ids_);
      return;
    }
    for (const std::string& id : before->block.exercises) {
      const auto found = exercises_.find(id);
      if (found == exercises_.end()) continue;
      check_can_be_met(*found->second, *draft.after_node, "block '" + draft.block.id + "'");
    }
  }

  // What must be proficient before an exercise opens, and where that is written.
  struct Edge {
    std::string from, to;
    const YamlNode* at;
    bool is_choice;  // says "requires" itself; the others follow from where an exercise stands
  };

  std::vector<Edge> edges() const {
    std::vector<Edge> edges;
    for (const ExerciseDraft& draft : drafts_.exercises) {
      for (const auto& requirement : draft.requirements) {
        edges.push_back({draft.exercise.id, requirement.exercise, requirement.at, true});
      }
    }
    std::set<std::string> blocks;
    for (const BlockDraft& draft : drafts_.blocks) {
      if (!blocks.insert(draft.block.id).second) continue;  // reported already
      // blocks are nodes of their own, entered and left by different names, so that the graph
      // stays small and exercises of one block do not require each other
      const std::string entry = "before block " + draft.block.id;
      for (const Fields::Word& word : draft.exercises) {
        edges.push_back({word.text, entry, word.node, false});
        edges.push_back({"block " + draft.block.id, word.text, word.node, false});
      }
      if (draft.after_node) {
        edges.push_back({entry, "block " + draft.block.after, draft.after_node, true});
      }
      for (std::size_t i = 1; !draft.block.any_order && i < draft.exercises.size(); ++i) {
        const Fields::Word& word = draft.exercises[i];
        const std::string& before = draft.exercises[i - 1].text;
        if (word.text != before) edges.push_back({word.text, before, word.node, true});
      }
    }
    return edges;
  }

  // Depth first without recursion: the file decides how deep the graph is.
  void check_cycles() {
    const std::vector<Edge> all = edges();
    std::map<std::string, std::vector<const Edge*>> out;
    for (const Edge& edge : all) out[edge.from].push_back(&edge);

    enum class Mark { open, done };
    std::map<std::string, Mark> marks;
    struct Visit {
      std::string name;
      const Edge* by = nullptr;  // the edge it was reached by
      std::size_t next = 0;
    };
    for (const auto& [start, unused] : out) {
      if (marks.contains(start)) continue;
      std::vector<Visit> path{{start}};
      marks[start] = Mark::open;
      while (!path.empty()) {
        Visit& visit = path.back();
        const auto found = out.find(visit.name);
        if (found == out.end() || visit.next == found->second.size()) {
          marks[visit.name] = Mark::done;
          path.pop_back();
          continue;
        }
        const Edge* edge = found->second[visit.next++];
        const auto mark = marks.find(edge->to);
        if (mark == marks.end()) {
          marks[edge->to] = Mark::open;
          path.push_back({edge->to, edge});
        } else if (mark->second == Mark::open) {
          std::vector<const Edge*> cycle{edge};
          for (auto v = path.rbegin(); v->name != edge->to; ++v) cycle.push_back(v->by);
          std::reverse(cycle.begin(), cycle.end());
          report_cycle(cycle);
        }
      }
    }
  }

  void report_cycle(const std::vector<const Edge*>& cycle) {
    // one tangle, one sentence: whoever undoes it checks again
    bool is_new = true;
    for (const Edge* edge : cycle) is_new = in_cycle_.insert(edge->from).second && is_new;
    if (!is_new) return;
    const Edge* at = nullptr;  // the last of them in the file, most likely written last too
    std::string names;
    for (const Edge* edge : cycle) {
      if (edge->is_choice && (!at || edge->at->begin > at->at->begin)) at = edge;
      if (edge->from.starts_with("before block ")) continue;  // says no more than the block's name
      names += "'" + edge->from + "' requires ";
    }
    const std::string& first = cycle.front()->from;
    const std::string last = first.starts_with("before ") ? first.substr(7) : first;
    if (!at) return;  // where things stand alone makes no circle
    problems_.error(*at->at, "the prerequisites go in a circle (" + names + "'" + last +
                                 "'): take one of them out");
  }

  const Drafts& drafts_;
  Problems& problems_;
  std::vector<std::string> exercise_ids_, block_ids_;
  std::map<std::string, const ExerciseDraft*> exercises_;
  std::set<std::string> in_cycle_;  // what is part of a circle that was reported
};

}  // namespace

void cross_check(const Drafts& drafts, Problems& problems) { CrossChecker(drafts, problems).run(); }

}  // namespace curricula
