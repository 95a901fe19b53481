// People from a spreadsheet: what it would do, and doing it.
#include <nlohmann/json.hpp>

#include "app/server/invitation_link.h"
#include "app/server/json_body.h"
#include "app/server/json_fields.h"
#include "app/server/people_import.h"
#include "app/server/routes/handlers.h"
#include "app/server/site.h"

namespace app {
namespace {

using nlohmann::json;

base::Error refuse(const std::string& sentence) {
  return {base::ErrorCode::invalid_input, sentence};
}

base::Result<ImportPlan> plan_of(Call& call, const std::string& csv) {
  const auto known = known_people(call.store);
  if (!known) return known.error();
  return plan_import(csv, *known);
}

json preview_json(const ImportPlan& plan) {
  json rows = json::array();
  for (const ImportedRow& row : plan.rows) {
    rows.push_back({{"line", row.line},
                    {"name", row.name},
                    {"display_name", row.display_name},
                    {"action", word(row.action)},
                    {"sentence", row.sentence}});
  }
  return {{"rows", rows},
          {"add", plan.count(ImportAction::add)},
          {"change", plan.count(ImportAction::change)},
          {"unchanged", plan.count(ImportAction::unchanged)},
          {"broken", plan.count(ImportAction::broken)},
          {"problems", plan.problems},
          {"sha256", plan.sha256}};
}

// "lines 4, 9 and 17", with no more than a handful named.
std::string broken_lines(const ImportPlan& plan) {
  constexpr int kNamed = 8;
  std::string lines;
  int named = 0;
  for (const ImportedRow& row : plan.rows) {
    if (row.action != ImportAction::broken || ++named > kNamed) continue;
    lines += (lines.empty() ? "" : ", ") + std::to_string(row.line);
  }
  return (named == 1 ? "line " : "lines ") + lines + (named > kNamed ? ", ..." : "");
}

struct Asked {
  std::string csv, preview_sha256;
  bool skip_broken = false;
};

base::Result<Asked> read_request(const Request& request, bool preview) {
  const auto body = read_json_object(request);
  if (!body) return body.error();
  JsonFields fields(*body);
  Asked asked;
  asked.csv = fields.text("csv");
  if (!preview && fields.has("skip_broken")) asked.skip_broken = fields.truth("skip_broken");
  if (!preview && fields.has("preview_sha256")) {
    asked.preview_sha256 = fields.text("preview_sha256");
  }
  if (const auto read = fields.done(); !read) return read.error();
  return asked;
}

base::Status check_plan(const ImportPlan& plan, const Asked& asked) {
  if (!plan.problems.empty()) return refuse(plan.problems.front());
  if (!asked.preview_sha256.empty() && asked.preview_sha256 != plan.sha256) {
    return base::Error{base::ErrorCode::conflict,
                       "The list or the people have changed since the preview; look at the preview "
                       "again."};
  }
  const int broken = plan.count(ImportAction::broken);
  if (broken > 0 && !asked.skip_broken) {
    return refuse("Nothing was imported: mend " + broken_lines(plan) +
                  ", or import the other rows only.");
  }
  return base::Done{};
}

// What the plan does, in its order, with a fresh link for everybody new.
struct Work {
  std::vector<database::ListedPerson> list;
  std::vector<NewInvitation> invitations;  // of those without a person_id, in the same order
};

Work work_of(const ImportPlan& plan) {
  Work work;
  for (const ImportedRow& row : plan.rows) {
    const bool is_new = row.action == ImportAction::add;
    if (!is_new && row.action != ImportAction::change) continue;
    work.list.push_back(row.listed);
    if (!is_new) continue;
    work.invitations.push_back(new_invitation());
    work.list.back().link = work.invitations.back().link;
  }
  return work;
}

json invitations_json(const Work& work, const std::vector<std::string>& ids) {
  json invitations = json::array();
  auto invitation = work.invitations.begin();
  for (std::size_t i = 0; i < work.list.size(); ++i) {
    if (!work.list[i].person_id.empty()) continue;
    database::Person person;
    person.id = ids[i];
    person.name = work.list[i].added.name;
    person.display_name = work.list[i].added.display_name;
    invitations.push_back(invitation_json(person, *invitation++));
  }
  return invitations;
}

}  // namespace

base::Result<Response> post_import_preview(Call& call) {
  const auto asked = read_request(call.request, true);
  if (!asked) return asked.error();
  const auto plan = plan_of(call, asked->csv);
  if (!plan) return plan.error();
  return json_response(preview_json(*plan));
}

base::Result<Response> post_import(Call& call) {
  const auto asked = read_request(call.request, false);
  if (!asked) return asked.error();
  const auto plan = plan_of(call, asked->csv);
  if (!plan) return plan.error();
  if (const auto good = check_plan(*plan, *asked); !good) return good.error();
  const Work work = work_of(*plan);
  const auto ids = database::take_in_people(call.store, work.list, call.me().person.id);
  if (!ids) return ids.error();
  return json_response({{"added", plan->count(ImportAction::add)},
                        {"changed", plan->count(ImportAction::change)},
                        {"unchanged", plan->count(ImportAction::unchanged)},
                        {"skipped", plan->count(ImportAction::broken)},
                        {"invitations", invitations_json(work, *ids)}});
}

}  // namespace app
