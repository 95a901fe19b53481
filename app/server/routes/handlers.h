// What answers each route; the table that says who may call them is routes/table.cpp. Each fails
// with an error of the program, which the router turns into a Problem.
#pragma once

#include "app/server/router.h"

namespace app {

base::Result<Response> get_health(Call& call);
base::Result<Response> get_site(Call& call);
base::Result<Response> get_session(Call& call);
base::Result<Response> post_session(Call& call);
base::Result<Response> delete_session(Call& call);
base::Result<Response> post_setup(Call& call);
base::Result<Response> post_look_at_invitation(Call& call);
base::Result<Response> post_invitation(Call& call);

base::Result<Response> get_training(Call& call);
base::Result<Response> get_exercise(Call& call);
base::Result<Response> get_mesh(Call& call);
base::Result<Response> get_metrics(Call& call);
base::Result<Response> get_settings(Call& call);
base::Result<Response> put_settings(Call& call);
base::Result<Response> post_password(Call& call);

base::Result<Response> post_trial(Call& call);
base::Result<Response> get_trial(Call& call);
base::Result<Response> post_comment(Call& call);
base::Result<Response> delete_comment(Call& call);
base::Result<Response> post_void(Call& call);
base::Result<Response> post_practice(Call& call);
base::Result<Response> get_practice_result(Call& call);
base::Result<Response> get_live(Call& call);
base::Result<Response> get_live_mine(Call& call);

base::Result<Response> get_people(Call& call);
base::Result<Response> get_person(Call& call);
base::Result<Response> post_person(Call& call);
base::Result<Response> put_person(Call& call);
base::Result<Response> post_person_invitation(Call& call);
base::Result<Response> get_progress(Call& call);
base::Result<Response> post_import_preview(Call& call);
base::Result<Response> post_import(Call& call);
base::Result<Response> get_groups(Call& call);

base::Result<Response> get_system(Call& call);
base::Result<Response> post_backup(Call& call);
base::Result<Response> get_backup(Call& call);
base::Result<Response> get_audit(Call& call);

base::Result<Response> get_compare_options(Call& call);
base::Result<Response> get_comparison(Call& call);
base::Result<Response> get_comparison_csv(Call& call);
base::Result<Response> get_comparison_html(Call& call);

base::Result<Response> get_curricula(Call& call);
base::Result<Response> get_curriculum_version(Call& call);
base::Result<Response> post_curriculum(Call& call);
base::Result<Response> post_curriculum_check(Call& call);
base::Result<Response> put_draft(Call& call);
base::Result<Response> delete_draft_of(Call& call);
base::Result<Response> post_publish(Call& call);
base::Result<Response> post_retire(Call& call);
base::Result<Response> put_default_curriculum(Call& call);
base::Result<Response> get_curriculum_diff(Call& call);

base::Result<Response> get_catalogue(Call& call);
base::Result<Response> get_instruments(Call& call);

}  // namespace app
