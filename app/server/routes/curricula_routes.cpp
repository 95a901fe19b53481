// Curricula for administrators: versions, drafts, their problems, publishing and retiring.
#include <algorithm>
#include <map>
#include <optional>

#include <nlohmann/json.hpp>

#include "app/server/json_body.h"
#include "app/server/routes/handlers.h"
#include "app/server/site.h"
#include "app/server/views/curriculum_view.h"
#include "app/server/views/words.h"
#include "curricula/copy.h"
#include "curricula/semantic_version.h"
#include "curricula/sha256.h"
#include "curricula/yaml_tree.h"
#include "database/curriculum_drafts.h"
#include "database/training_by.h"

namespace app {
namespace {

using base::Error;
using base::ErrorCode;
using nlohmann::json;

constexpr const char* kDraft = "draft";

const curricula::Library& library_of(Call& call) { return call.site.scenes.library(); }

bool is_built_in(Call& call, const std::string& id) {
  const auto& built_in = library_of(call).curricula;
  return std::any_of(built_in.begin(), built_in.end(),
                     [&](const curricula::Curriculum& each) { return each.id == id; });
}

// The text of the newest published version; null when there is none.
base::Result<std::optional<std::string>> published_text(Call& call, const std::string& id) {
  const auto current = database::current_curriculum(call.store, id);
  if (current) return std::optional<std::string>(current->yaml);
  if (current.error().code == ErrorCode::not_found) return std::optional<std::string>{};
  return current.error();
}

// A draft's problems, those that follow from what is published among them.
base::Result<CheckedText> checked_draft(Call& call, const std::string& id,
                                        const std::string& yaml) {
  const auto published = published_text(call, id);
  if (!published) return published.error();
  return check_text(yaml, *published ? &**published : nullptr, library_of(call).catalogue());
}

// A stored version; or a built-in one of another number than those stored.
base::Result<database::CurriculumVersion> stored_version(Call& call, const std::string& id,
                                                         const std::string& version) {
  const auto versions = database::curriculum_versions(call.store);
  if (!versions) return versions.error();
  for (const database::CurriculumVersion& each : *versions) {
    if (each.curriculum_id == id && each.version == version) return each;
  }
  for (const curricula::Curriculum& each : library_of(call).curricula) {
    if (each.id != id || each.version != version) continue;
    database::CurriculumVersion built_in;
    built_in.curriculum_id = id;
    built_in.version = version;
    built_in.yaml = each.yaml;
    built_in.sha256 = each.sha256;
    built_in.status = each.status == curricula::Lifecycle::published ? "published" : kDraft;
    return built_in;
  }
  return Error{ErrorCode::not_found,
               "There is no version " + version + " of '" + id + "': choose one from the list."};
}

json text_json(Call& call, const std::string& id, const CheckedText& checked,
               const std::string& yaml) {
  const bool readable = checked.curriculum.has_value();
  return {{"id", id},
          {"title", readable ? english(checked.curriculum->title) : id},
          {"version", readable ? checked.curriculum->version : ""},
          {"built_in", is_built_in(call, id)},
          {"yaml", yaml},
          {"check", check_json(checked, yaml, library_of(call))}};
}

base::Result<json> version_json(Call& call, const database::CurriculumVersion& version) {
  const CheckedText checked = check_text(version.yaml, nullptr, library_of(call).catalogue());
  json answer = text_json(call, version.curriculum_id, checked, version.yaml);
  answer["version"] = version.version;
  answer["status"] = version.status;
  answer["sha256"] = version.sha256;
  answer["saved_utc"] = version.published_utc.empty() ? json(nullptr) : json(version.published_utc);
  answer["saved_by"] = "";
  return answer;
}

base::Result<json> draft_json(Call& call, const database::CurriculumDraft& draft) {
  const auto checked = checked_draft(call, draft.curriculum_id, draft.yaml);
  if (!checked) return checked.error();
  json answer = text_json(call, draft.curriculum_id, *checked, draft.yaml);
  answer["status"] = kDraft;
  answer["sha256"] = draft.sha256;
  answer["saved_utc"] = draft.saved_utc;
  answer["saved_by"] = draft.saved_by_name;
  return answer;
}

base::Result<Response> draft_response(Call& call, const database::CurriculumDraft& draft,
                                      int status = 200) {
  const auto answer = draft_json(call, draft);
  if (!answer) return answer.error();
  return json_response(*answer, status);
}

// The number after the newest one stored, a patch on.
std::string next_version(const std::vector<database::VersionSummary>& versions,
                         const std::string& id) {
  curricula::SemanticVersion newest;
  for (const database::VersionSummary& each : versions) {
    if (each.curriculum_id != id) continue;
    if (const auto version = curricula::parse_version(each.version)) {
      newest = std::max(newest, *version);
    }
  }
  ++newest.patch;
  return curricula::version_text(newest);
}

base::Result<std::string> draft_text(Call& call, const database::CurriculumVersion& source,
                                     const std::string& new_id) {
  const auto versions = database::version_summaries(call.store);
  if (!versions) return versions.error();
  if (new_id == source.curriculum_id) {
    if (is_built_in(call, new_id)) {
      return Error{ErrorCode::conflict, "'" + new_id +
                                            "' comes with the program and is not changed here: "
                                            "give the copy an id of its own."};
    }
    return curricula::next_draft(source.yaml, next_version(*versions, new_id));
  }
  const bool taken = is_built_in(call, new_id) ||
                     std::any_of(versions->begin(), versions->end(),
                                 [&](const auto& each) { return each.curriculum_id == new_id; });
  if (taken) {
    return Error{ErrorCode::conflict,
                 "There is a curriculum '" + new_id + "' already: choose another id."};
  }
  const auto checked = curricula::check(source.yaml, library_of(call).catalogue());
  if (!checked.ok()) {
    return Error{ErrorCode::corrupt_data, "Version " + source.version + " of '" +
                                              source.curriculum_id +
                                              "' cannot be read by this program any more."};
  }
  return curricula::copy_as_draft(*checked.curriculum, new_id);
}

// The id a text gives itself, if it can be read that far.
std::string id_in(const std::string& yaml) {
  curricula::Problems ignored;
  const curricula::YamlTree tree = curricula::parse_yaml(yaml, ignored);
  const curricula::YamlNode* id = tree.root.find("id");
  return id == nullptr ? std::string() : id->text;
}

database::CurriculumVersion row_of(const curricula::Curriculum& curriculum) {
  database::CurriculumVersion version;
  version.curriculum_id = curriculum.id;
  version.version = curriculum.version;
  version.sha256 = curriculum.sha256;
  version.yaml = curriculum.yaml;
  version.status = "published";
  for (const curricula::Exercise& exercise : curriculum.exercises) {
    version.exercises.push_back({"", exercise.id, exercise.version, exercise.yaml});
  }
  return version;
}

struct Overview {
  std::vector<database::VersionSummary> versions;
  std::vector<database::CurriculumDraft> drafts;
  std::map<std::string, int> trainees;
  std::string standard;  // the default; empty when nothing is published
};

base::Result<Overview> overview_of(database::Store& store) {
  Overview overview;
  auto versions = database::version_summaries(store);
  if (!versions) return versions.error();
  overview.versions = *std::move(versions);
  auto drafts = database::curriculum_drafts(store);
  if (!drafts) return drafts.error();
  overview.drafts = *std::move(drafts);
  auto trainees = database::trainees_by_curriculum(store);
  if (!trainees) return trainees.error();
  overview.trainees = *std::move(trainees);
  if (const auto standard = database::default_curriculum(store)) overview.standard = *standard;
  return overview;
}

int people_of(const Overview& overview, const std::string& id) {
  const auto count = [&](const std::string& key) {
    const auto found = overview.trainees.find(key);
    return found == overview.trainees.end() ? 0 : found->second;
  };
  return count(id) + (id == overview.standard ? count("") : 0);
}

base::Result<json> row_json(Call& call, const Overview& overview, const std::string& id) {
  json row{{"id", id},
           {"title", id},
           {"built_in", is_built_in(call, id)},
           {"is_default", id == overview.standard},
           {"people", people_of(overview, id)},
           {"published_version", nullptr},
           {"draft", nullptr},
           {"versions", json::array()}};
  for (const database::VersionSummary& each : overview.versions) {
    if (each.curriculum_id != id) continue;
    if (row["published_version"].is_null() && each.status == "published") {
      row["published_version"] = each.version;
    }
    row["versions"].push_back(
        {{"version", each.version},
         {"status", each.status},
         {"published_utc", each.published_utc.empty() ? json(nullptr) : json(each.published_utc)},
         {"sha256", each.sha256},
         {"exercises", each.exercises},
         {"trials", each.trials}});
  }
  if (!row["published_version"].is_null()) {
    const auto current = call.site.curricula.by_id(call.store, library_of(call).catalogue(), id);
    if (current) row["title"] = english((*current)->title);
  }
  for (const database::CurriculumDraft& draft : overview.drafts) {
    if (draft.curriculum_id != id) continue;
    const auto checked = checked_draft(call, id, draft.yaml);
    if (!checked) return checked.error();
    if (row["title"] == id && checked->curriculum) {
      row["title"] = english(checked->curriculum->title);
    }
    row["draft"] = {{"version", checked->curriculum ? checked->curriculum->version : ""},
                    {"saved_utc", draft.saved_utc},
                    {"saved_by", draft.saved_by_name},
                    {"errors", checked->errors()},
                    {"warnings", checked->warnings()}};
  }
  return row;
}

// A text named in a difference, and the curriculum in it.
base::Result<curricula::Curriculum> side_of_diff(Call& call, const std::string& id,
                                                 const std::string& version) {
  std::string yaml;
  if (version == kDraft) {
    const auto draft = database::curriculum_draft(call.store, id);
    if (!draft) return draft.error();
    yaml = draft->yaml;
  } else {
    const auto stored = stored_version(call, id, version);
    if (!stored) return stored.error();
    yaml = stored->yaml;
  }
  curricula::CheckResult checked = curricula::check(yaml, library_of(call).catalogue());
  if (checked.ok()) return *std::move(checked.curriculum);
  curricula::Curriculum broken;  // its lines can be compared all the same
  broken.yaml = yaml;
  return broken;
}

}  // namespace

base::Result<Response> get_curricula(Call& call) {
  const auto overview = overview_of(call.store);
  if (!overview) return overview.error();
  std::vector<std::string> ids;
  for (const auto& each : overview->versions) ids.push_back(each.curriculum_id);
  for (const auto& each : overview->drafts) ids.push_back(each.curriculum_id);
  std::sort(ids.begin(), ids.end());
  ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
  json rows = json::array();
  for (const std::string& id : ids) {
    auto row = row_json(call, *overview, id);
    if (!row) return row.error();
    rows.push_back(*std::move(row));
  }
  return json_response({{"curricula", rows}});
}

base::Result<Response> get_curriculum_version(Call& call) {
  const std::string &id = call.parameter("id"), &version = call.parameter("version");
  if (version == kDraft) {
    const auto draft = database::curriculum_draft(call.store, id);
    if (!draft) return draft.error();
    return draft_response(call, *draft);
  }
  const auto stored = stored_version(call, id, version);
  if (!stored) return stored.error();
  const auto answer = version_json(call, *stored);
  if (!answer) return answer.error();
  return json_response(*answer);
}

base::Result<Response> post_curriculum(Call& call) {
  const auto body = read_text_fields(call.request, {"from_id", "from_version", "new_id"});
  if (!body) return body.error();
  const std::string from_id = (*body)["from_id"], from_version = (*body)["from_version"];
  const std::string new_id = (*body)["new_id"];
  const auto source = stored_version(call, from_id, from_version);
  if (!source) return source.error();
  const auto text = draft_text(call, *source, new_id);
  if (!text) return text.error();
  database::CurriculumDraft draft;
  draft.curriculum_id = new_id;
  draft.yaml = *text;
  draft.sha256 = curricula::sha256_hex(*text);
  draft.from_version = from_id + "@" + from_version;
  const auto begun = database::begin_draft(call.store, draft, call.me().person.id);
  if (!begun) return begun.error();
  return draft_response(call, *begun, 201);
}

base::Result<Response> post_curriculum_check(Call& call) {
  const auto body = read_text_fields(call.request, {"yaml"});
  if (!body) return body.error();
  const std::string yaml = (*body)["yaml"];
  const auto checked = checked_draft(call, id_in(yaml), yaml);
  if (!checked) return checked.error();
  return json_response(check_json(*checked, yaml, library_of(call)));
}

base::Result<Response> put_draft(Call& call) {
  const auto body = read_text_fields(call.request, {"yaml", "replaces_sha256"});
  if (!body) return body.error();
  const std::string yaml = (*body)["yaml"], replaces = (*body)["replaces_sha256"];
  const std::string& id = call.parameter("id");
  const std::string id_now = id_in(yaml);
  if (!id_now.empty() && id_now != id) {
    return Error{ErrorCode::invalid_input, "This draft is that of '" + id +
                                               "', but its text says '" + id_now.substr(0, 64) +
                                               "': put the id back, or copy it under another."};
  }
  database::CurriculumDraft draft;
  draft.curriculum_id = id;
  draft.yaml = yaml;
  draft.sha256 = curricula::sha256_hex(yaml);
  const auto saved = database::save_draft(call.store, draft, replaces, call.me().person.id);
  if (!saved) return saved.error();
  return draft_response(call, *saved);
}

base::Result<Response> delete_draft_of(Call& call) {
  const auto removed =
      database::delete_draft(call.store, call.parameter("id"), call.me().person.id);
  if (!removed) return removed.error();
  Response response;
  response.status = 204;
  return response;
}

base::Result<Response> post_publish(Call& call) {
  const auto body = read_text_fields(call.request, {"sha256"});
  if (!body) return body.error();
  const std::string& id = call.parameter("id");
  const auto draft = database::curriculum_draft(call.store, id);
  if (!draft) return draft.error();
  const auto checked = checked_draft(call, id, draft->yaml);
  if (!checked) return checked.error();
  for (const curricula::Problem& problem : checked->problems) {
    if (problem.severity != curricula::Problem::Severity::error) continue;
    return Error{ErrorCode::conflict, "This draft cannot be published yet. Line " +
                                          std::to_string(problem.line) + ": " + problem.message};
  }
  if (checked->curriculum->id != id) {
    return Error{ErrorCode::conflict, "The id inside this draft is not '" + id + "': put it back."};
  }
  const auto text = curricula::as_published(draft->yaml);
  if (!text) return text.error();
  const auto ready = curricula::check(*text, library_of(call).catalogue());
  if (!ready.ok()) {
    return Error{ErrorCode::corrupt_data, "The text with the status published has a problem: " +
                                              ready.problems.front().message};
  }
  const auto published = database::publish_from_draft(call.store, row_of(*ready.curriculum),
                                                      (*body)["sha256"], call.me().person.id);
  if (!published) return published.error();
  const auto answer = version_json(call, *published);
  if (!answer) return answer.error();
  return json_response(*answer);
}

base::Result<Response> post_retire(Call& call) {
  const auto body = read_text_fields(call.request, {"version"});
  if (!body) return body.error();
  const auto retired = database::retire_curriculum(call.store, call.parameter("id"),
                                                   (*body)["version"], call.me().person.id);
  if (!retired) return retired.error();
  return get_curricula(call);
}

base::Result<Response> put_default_curriculum(Call& call) {
  const auto body = read_text_fields(call.request, {"curriculum_id"});
  if (!body) return body.error();
  const auto chosen =
      database::set_default_curriculum(call.store, (*body)["curriculum_id"], call.me().person.id);
  if (!chosen) return chosen.error();
  return get_curricula(call);
}

base::Result<Response> get_curriculum_diff(Call& call) {
  const std::string& id = call.parameter("id");
  const std::string from = call.request.parameter("from"), to = call.request.parameter("to");
  const auto before = side_of_diff(call, id, from);
  if (!before) return before.error();
  const auto after = side_of_diff(call, id, to);
  if (!after) return after.error();
  const bool both = !before->id.empty() && !after->id.empty();
  const auto changes = both ? curricula::diff(*before, *after) : std::vector<curricula::Change>{};
  const auto heaviest =
      std::max_element(changes.begin(), changes.end(),
                       [](const auto& a, const auto& b) { return a.weight < b.weight; });
  return json_response(
      {{"from", from},
       {"to", to},
       {"needed_bump", heaviest == changes.end() ? "none" : curricula::word(heaviest->weight)},
       {"changes", changes_json(changes)},
       {"lines", diff_lines_json(curricula::line_diff(before->yaml, after->yaml))}});
}

}  // namespace app
