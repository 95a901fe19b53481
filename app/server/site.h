// What every handler may use: the catalogue, the live trials, who was refused lately. One per
// server; its parts may be used from several threads.
#pragma once

#include "app/server/audit_verdict.h"
#include "app/server/backup_folder.h"
#include "app/server/expert_bands.h"
#include "app/server/live_trials.h"
#include "app/server/mesh_cache.h"
#include "app/server/practice_results.h"
#include "app/server/published_curricula.h"
#include "app/server/server.h"
#include "app/server/sessions.h"
#include "app/server/throttle.h"
#include "app/session/scene.h"

namespace app {

struct Site {
  Site(ServerOptions its_options, curricula::Library library)
      : options(std::move(its_options)),
        scenes(std::move(library)),
        meshes(scenes),
        backups(options.database_url),
        live(options.max_live_trials,
             {options.abandon_live_after_s, options.abandon_practice_after_s}),
        requests(options.requests_per_second) {}

  const ServerOptions options;
  SceneStore scenes;
  MeshCache meshes;
  BackupFolder backups;
  AuditVerdict audit;
  const std::string started_utc = database::utc_now();
  PublishedCurricula curricula;
  PracticeResults practice;  // before the trials, which put their results there
  ExpertBandCache expert_bands;
  LiveTrials live;
  FailureThrottle names{5};     // wrong passwords for one name
  FailureThrottle clients{30};  // wrong passwords from one address, a class room perhaps
  RequestThrottle requests;

  SessionRules session_rules() const {
    return {options.session_idle_s, options.session_absolute_s,
            options.tls() || options.behind_proxy};
  }
};

}  // namespace app
