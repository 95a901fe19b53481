#include "curricula/read_steps.h"

#include <numbers>
#include <set>

#include "curricula/nearest.h"
#include "curricula/number_text.h"

namespace curricula {
namespace {

constexpr double kRadPerDegree = std::numbers::pi / 180.0;
constexpr double kHoldTolerance = 2.0;    // mm the handle may move while it is held still
constexpr std::size_t kMostSteps = 1000;  // after unrolling

const std::vector<std::string> kKinds = {"translate", "rotate", "hold"};
const std::vector<std::string> kLaterKinds = {"navigate", "angiogram", "exchange"};

// Reads the steps of one exercise; ids must be unique in all of it.
class StepReader {
 public:
  StepReader(const Reach& reach, Problems& problems) : reach_(reach), problems_(problems) {}

  std::vector<Step> read_all(const std::vector<const YamlNode*>& nodes, bool inside_repeat) {
    std::vector<Step> steps;
    for (const YamlNode* node : nodes) {
      if (std::optional<Step> step = read(*node, inside_repeat)) steps.push_back(std::move(*step));
    }
    return steps;
  }

 private:
  std::optional<Step> read(const YamlNode& node, bool inside_repeat) {
    if (node.find("repeat")) return read_repeat(node, inside_repeat);
    Fields fields(node, "a step", problems_);
    const YamlNode* kind = fields.need("do");
    if (!kind) {
      // its keys cannot be judged without knowing the kind
      if (fields.is_map() && node.complete) {
        problems_.error(node, "a step needs 'do': write do: translate, rotate or hold");
      }
      return {};
    }
    if (kind->kind == YamlNode::Kind::unusable) return {};
    for (const std::string& later : kLaterKinds) {
      if (kind->text != later) continue;
      problems_.error(*kind, "'" + later +
                                 "' steps are part of the format, but not available in "
                                 "this version of the program: use " +
                                 alternatives(kKinds));
      return {};
    }
    const std::string guess = nearest(kind->text, kKinds);
    if (kind->text == "translate") return read_translate(node);
    if (kind->text == "rotate") return read_rotate(node);
    if (kind->text == "hold") return read_hold(node);
    problems_.error(*kind, "there is no step '" + kind->text.substr(0, 64) + "': " +
                               (guess.empty() ? "write " + alternatives(kKinds)
                                              : "did you mean '" + guess + "'?"));
    return {};
  }

  std::string read_id(Fields& fields) {
    std::string id = fields.need_id("id");
    if (!id.empty() && !ids_.insert(id).second) {
      problems_.error(*fields.find("id"), "step '" + id + "' is there already: give it another id");
    }
    return id;
  }

  Step read_translate(const YamlNode& node) {
    Fields fields(node, "a translate step", problems_);
    fields.find("do");
    Step step;
    step.kind = Step::Kind::translate;
    step.id = read_id(fields);
    const YamlNode* target = fields.need("to_mm");
    const std::optional<double> to = fields.number("to_mm", {-5000.0, 5000.0});
    step.target = to.value_or(0.0);
    if (to && reach_.known) check_reach(step.target, *target);
    step.tolerance = fields.need_number("tolerance_mm", {0.0, 50.0, true});
    step.hold = fields.number("hold_s", {0.0, 60.0}).value_or(0.0);
    fields.finish();
    return step;
  }

  void check_reach(double target, const YamlNode& at) {
    const double inserted = reach_.start + target;
    if (inserted < 0.0) {
      problems_.error(at, "this target lies " + number_text(-inserted) +
                              " mm outside the sheath: write at least " +
                              number_text(-reach_.start));
    }
    if (inserted > reach_.length) {
      problems_.error(at, "this target needs " + number_text(inserted) + " mm, but " +
                              reach_.shorter + " is " + number_text(reach_.length) +
                              " mm long: write at most " +
                              number_text(reach_.length - reach_.start));
    }
  }

  Step read_rotate(const YamlNode& node) {
    Fields fields(node, "a rotate step", problems_);
    fields.find("do");
    Step step;
    step.kind = Step::Kind::rotate;
    step.id = read_id(fields);
    step.target = fields.need_number("to_deg", {-36000.0, 36000.0}) * kRadPerDegree;
    step.tolerance = fields.need_number("tolerance_deg", {0.0, 180.0, true}) * kRadPerDegree;
    step.hold = fields.number("hold_s", {0.0, 60.0}).value_or(0.0);
    fields.finish();
    return step;
  }

  Step read_hold(const YamlNode& node) {
    Fields fields(node, "a hold step", problems_);
    fields.find("do");
    Step step;
    step.kind = Step::Kind::hold;
    step.id = read_id(fields);
    step.seconds = fields.need_number("seconds", {0.0, 600.0, true});
    step.tolerance = fields.number("tolerance_mm", {0.0, 50.0, true}).value_or(kHoldTolerance);
    fields.finish();
    return step;
  }

  std::optional<Step> read_repeat(const YamlNode& node, bool inside_repeat) {
    if (inside_repeat) {
      problems_.error(node, "a repeat cannot stand inside a repeat: write its steps out");
    }
    Fields fields(node, "a repeat", problems_);
    Step step;
    step.kind = Step::Kind::repeat;
    step.times = static_cast<int>(fields.need_integer("repeat", 1, 1000));
    step.steps = read_all(fields.need_list("steps"), true);
    fields.finish();
    return step;
  }

  const Reach& reach_;
  Problems& problems_;
  std::set<std::string> ids_;
};

}  // namespace

std::vector<Step> read_steps(const std::vector<const YamlNode*>& nodes, const Reach& reach,
                             Problems& problems) {
  std::vector<Step> steps = StepReader(reach, problems).read_all(nodes, false);
  std::size_t count = 0;
  for (const Step& step : steps) {
    // counted, not unrolled: a repeat inside a repeat could be a million steps
    count += step.kind == Step::Kind::repeat
                 ? step.steps.size() * static_cast<std::size_t>(step.times)
                 : 1;
  }
  if (count > kMostSteps) {
    problems.error(*nodes.front(), "these are " + std::to_string(count) +
                                       " steps in all: write at most " +
                                       std::to_string(kMostSteps));
  }
  return steps;
}

}  // namespace curricula
