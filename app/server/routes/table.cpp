#include <array>

#include "app/server/routes/handlers.h"

namespace app {
namespace {

using database::Role;

Who trains() { return Who::roles({Role::trainee, Role::instructor, Role::administrator}); }
Who teaches() { return Who::roles({Role::instructor, Role::administrator}); }
Who administers() { return Who::roles({Role::administrator}); }
Who compares() { return Who::roles({Role::instructor, Role::administrator, Role::researcher}); }

}  // namespace

std::span<const Route> routes() {
  using enum Method;
  constexpr LaneKind kSlow = LaneKind::slow;
  constexpr LaneKind kQuick = LaneKind::quick;
  // 1 MiB of text, some characters of which are escaped in JSON
  constexpr std::size_t kCurriculum = (std::size_t{1} << 20) + (std::size_t{1} << 18);  // bytes
  constexpr std::size_t kLongList = std::size_t{1} << 20;                               // bytes
  static const std::array kRoutes = std::to_array<Route>({
      {get, "/api/health", Who::anyone(), get_health},
      {get, "/api/site", Who::anyone(), get_site},
      {post, "/api/session", Who::anyone(), post_session, kSlow},
      {get, "/api/session", Who::signed_in(), get_session},
      {remove, "/api/session", Who::signed_in(), delete_session},
      {post, "/api/setup", Who::anyone(), post_setup, kSlow},
      {post, "/api/invitation/look", Who::anyone(), post_look_at_invitation},
      {post, "/api/invitation", Who::anyone(), post_invitation, kSlow},

      // one's own
      {get, "/api/training", trains(), get_training},
      {get, "/api/exercises/{id}", trains(), get_exercise},
      {get, "/api/anatomies/{id}/mesh.glb", Who::signed_in(), get_mesh, kSlow},
      {get, "/api/metrics", Who::signed_in(), get_metrics},
      {get, "/api/me/settings", Who::signed_in(), get_settings},
      {put, "/api/me/settings", Who::signed_in(), put_settings},
      {post, "/api/me/password", Who::signed_in(), post_password, kSlow},

      // trials
      {post, "/api/trials", trains(), post_trial, kSlow},
      {post, "/api/practice", trains(), post_practice, kSlow},
      {get, "/api/practice/{id}/result", trains().about(Subject::practice), get_practice_result},
      {get, "/api/live", trains(), get_live},
      {get, "/api/live/mine", trains(), get_live_mine},
      {get, "/api/live/{id}", trains().about(Subject::live_trial), nullptr, kQuick, true},
      {get, "/api/trials/{id}", trains().about(Subject::trial), get_trial},
      {post, "/api/trials/{id}/comments", teaches().about(Subject::trial), post_comment},
      {remove, "/api/trials/{id}/comments/{comment}", teaches().about(Subject::trial),
       delete_comment},
      {post, "/api/trials/{id}/void", teaches().about(Subject::trial), post_void},

      // people
      {get, "/api/people", teaches(), get_people},
      {post, "/api/people", administers(), post_person},
      {get, "/api/people/{id}", administers().about(Subject::person), get_person},
      {put, "/api/people/{id}", administers().about(Subject::person), put_person},
      {post, "/api/people/{id}/invitation", administers().about(Subject::person),
       post_person_invitation},
      {get, "/api/people/{id}/progress", trains().about(Subject::person), get_progress},
      {post, "/api/people/import/preview", administers(), post_import_preview, kQuick, false,
       kLongList},
      {post, "/api/people/import", administers(), post_import, kSlow, false, kLongList},
      {get, "/api/groups", teaches(), get_groups},

      // curricula, instruments; the checker may take its time, so not in the quick lane
      {get, "/api/curricula", administers(), get_curricula, kSlow},
      {post, "/api/curricula", administers(), post_curriculum, kSlow},
      {post, "/api/curricula/check", administers(), post_curriculum_check, kSlow, false,
       kCurriculum},
      {put, "/api/curricula/default", administers(), put_default_curriculum, kSlow},
      {get, "/api/curricula/{id}/versions/{version}", administers(), get_curriculum_version, kSlow},
      {put, "/api/curricula/{id}/draft", administers(), put_draft, kSlow, false, kCurriculum},
      {remove, "/api/curricula/{id}/draft", administers(), delete_draft_of},
      {post, "/api/curricula/{id}/publish", administers(), post_publish, kSlow},
      {post, "/api/curricula/{id}/retire", administers(), post_retire, kSlow},
      {get, "/api/curricula/{id}/diff", administers(), get_curriculum_diff, kSlow},
      {get, "/api/catalogue", teaches(), get_catalogue},
      {get, "/api/instruments", teaches(), get_instruments},

      // cohort

      // the system
      {get, "/api/system", administers(), get_system, kSlow},
      {post, "/api/system/backups", administers(), post_backup, kSlow},
      {get, "/api/system/backups/{name}", administers(), get_backup, kSlow},
      {get, "/api/audit", administers(), get_audit, kSlow},

      // reports
      {get, "/api/compare", compares(), get_compare_options},
      {get, "/api/compare/{id}.csv", compares(), get_comparison_csv, kSlow},
      {get, "/api/compare/{id}.html", compares(), get_comparison_html, kSlow},
      {get, "/api/compare/{id}", compares(), get_comparison},
  });
  return kRoutes;
}

}  // namespace app
