// Is the site well, is it saved, and who changed what: for administrators.
#include <charconv>

#include <nlohmann/json.hpp>

#include "app/server/actor_names.h"
#include "app/server/json_body.h"
#include "app/server/problem.h"
#include "app/server/routes/handlers.h"
#include "app/server/site.h"
#include "app/server/system_health.h"
#include "app/session/build_info.h"
#include "database/audit.h"
#include "database/stored_counts.h"

namespace app {
namespace {

using nlohmann::json;

constexpr int kAuditPage = 100;  // rows

json backup_json(const BackupFile& file) {
  return {{"name", file.name},
          {"bytes", file.bytes},
          {"made_utc", file.made_utc},
          {"sha256", file.sha256}};
}

json versions_json(const Call& call) {
  return json::array({
      {{"what", "Cathedra"}, {"version", call.site.options.version}},
      {{"what", "Build"}, {"version", build_id()}},
      {{"what", "Processor"}, {"version", kInstructionSet}},
      {{"what", "Database schema"}, {"version", std::to_string(call.store.schema_version())}},
  });
}

json storage_json(const BackupFolder& folder, const std::vector<BackupFile>& backups) {
  std::uintmax_t saved = 0;
  for (const BackupFile& file : backups) saved += file.bytes;
  return json::array({
      {{"what", "Database"}, {"bytes", folder.database_bytes()}},
      {{"what", "Backups on this server"}, {"bytes", saved}},
      {{"what", "Free on the disk"}, {"bytes", folder.free_bytes()}},
  });
}

// 0 when absent: from the newest.
base::Result<int> read_before(const std::string& text) {
  int before = 0;
  if (text.empty()) return before;
  const char* end = text.data() + text.size();
  const auto read = std::from_chars(text.data(), end, before);
  if (read.ec == std::errc{} && read.ptr == end && before > 0) return before;
  return base::Error{base::ErrorCode::invalid_input,
                     "Give the number of a row of the audit log after before=."};
}

}  // namespace

base::Result<Response> get_system(Call& call) {
  Site& site = call.site;
  const auto backups = site.backups.list();
  if (!backups) return backups.error();
  const auto health = system_health(site, call.store, *backups);
  if (!health) return health.error();
  const auto counts = database::stored_counts(call.store);
  if (!counts) return counts.error();
  json counted = json::array(), checks = json::array(), files = json::array();
  for (const database::StoredCount& row : *counts) {
    counted.push_back({{"what", row.what}, {"count", row.count}});
  }
  for (const HealthCheck& check : *health) {
    checks.push_back({{"what", check.what}, {"state", check.state}, {"sentence", check.sentence}});
  }
  for (const BackupFile& file : *backups) files.push_back(backup_json(file));
  return json_response({{"versions", versions_json(call)},
                        {"started_utc", site.started_utc},
                        {"storage", storage_json(site.backups, *backups)},
                        {"counts", counted},
                        {"running_trials", site.live.running().size()},
                        {"health", checks},
                        {"backups", files}});
}

base::Result<Response> post_backup(Call& call) {
  const auto body = read_text_fields(call.request, {});
  if (!body) return body.error();
  const auto made = call.site.backups.make(call.store, call.me().person.id);
  if (!made) return made.error();
  return json_response(backup_json(*made), 201);
}

base::Result<Response> get_backup(Call& call) {
  const std::string& name = call.parameter("name");
  auto content = call.site.backups.read(name);
  if (!content) return content.error();
  const auto noted = database::note_in_audit(call.store, call.me().person.id, "backup.download",
                                             "backup:" + name, name);
  if (!noted) return noted.error();
  Response response;
  response.type = "application/vnd.sqlite3";
  response.body = *std::move(content);
  response.headers.emplace_back("Content-Disposition", "attachment; filename=\"" + name + "\"");
  return response;
}

base::Result<Response> get_audit(Call& call) {
  const auto before = read_before(call.request.parameter("before"));
  if (!before) return before.error();
  const auto verdict = call.site.audit.look(call.store, steady_seconds());
  if (!verdict) return verdict.error();
  const auto names = ActorNames::load(call.store);
  if (!names) return names.error();
  auto found = database::audit_log(call.store, kAuditPage + 1, *before);
  if (!found) return found.error();
  std::vector<database::AuditRow> rows = *std::move(found);
  const bool more = rows.size() > kAuditPage;
  if (more) rows.pop_back();
  json list = json::array();
  for (const database::AuditRow& row : rows) {
    list.push_back({{"seq", row.seq},
                    {"utc", row.utc},
                    {"actor", names->actor(row.actor)},
                    {"action", row.action},
                    {"object", names->object(row.object)},
                    {"hash", row.hash}});
  }
  return json_response({{"rows", list},
                        {"more", more},
                        {"intact", verdict->intact},
                        {"sentence", verdict->sentence}});
}

}  // namespace app
