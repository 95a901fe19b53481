// A small training ground for the tests of app/session: a short vessel with one bend, an exercise
// of a few seconds in it, and a database that knows both.
#pragma once

#include <memory>
#include <stdexcept>
#include <string>
#include <utility>

#include "app/session/publish_library.h"
#include "app/session/scene.h"
#include "app/session/simulated_trial.h"
#include "curricula/catalogue.h"
#include "curricula/check.h"
#include "tests/database/temporary_store.h"

namespace app::test {

template <class T>
T checked(base::Result<T> result) {
  if (!result) throw std::runtime_error(result.error().message);
  return *std::move(result);
}
inline void check_done(const base::Status& status) {
  if (!status) throw std::runtime_error(status.error().message);
}

// Feed 40 mm round the bend and come back half way: about six seconds of a practised hand.
inline std::string push_curriculum() {
  return R"(schema: cathedra-curriculum/1
id: workshop
version: 1.0.0
status: published
title: {en: "Workshop"}
authors: ["the tests"]
exercises:
  - id: push
    version: 1
    title: {en: "Push"}
    goal: {en: "Push round the bend and come half way back."}
    scene: {anatomy: s-bend-phantom, instruments: [guidewire-035-straight], start_mm: 20}
    attempt: {time_limit_s: 60, on_timeout: fail, on_abort: invalid}
    steps:
      - {id: in, do: translate, to_mm: 40, tolerance_mm: 2, hold_s: 0.5}
      - {id: out, do: translate, to_mm: 20, tolerance_mm: 2, hold_s: 0.5}
    limits:
      - {metric: force_max_n, op: "<=", value: 20, on_breach: critical_error}
    record: [time_s, path_length_mm, idle_s, sparc_stroke, force_max_n, contact_impulse_n_s]
    pass: {all: [{goal: reached}, {errors: critical, op: "==", value: 0}]}
    proficiency: {consecutive: 2}
plan:
  - {block: first, exercises: [push]}
completion: {all_blocks: true, sign_off: instructor}
)";
}

// The installed library with the S-bend cut down to 90 mm of vessel and one bend of 60 degrees, so
// that it is built in an instant and there is still a wall to lean on.
inline curricula::Library small_library() {
  curricula::Library library = checked(curricula::load_library(CATHEDRA_SOURCE_DIR "/curricula"));
  constexpr double kBend = 1.0471975511966;  // rad, 60 degrees
  for (curricula::AnatomySpec& anatomy : library.anatomies) {
    if (anatomy.id != "s-bend-phantom") continue;
    anatomy.legs = {{30.0, 0.0, 0.0, 4.0}, {30.0, kBend, 0.0, 4.0}, {30.0, 0.0, 0.0, 4.0}};
  }
  const curricula::CheckResult made = curricula::check(push_curriculum(), library.catalogue());
  if (!made.ok()) throw std::runtime_error(made.problems.front().message);
  library.curricula = {*made.curriculum};
  return library;
}

// Everything a trial of the exercise "push" needs.
struct Bench {
  Bench() : scenes(small_library()) {
    scene = checked(scenes.scene(exercise().scene));
    store = database_test::open_store(folder.url());
    check_done(publish_library(*store, scenes.library()));
  }

  const curricula::Curriculum& curriculum() const { return scenes.library().curricula.front(); }
  const curricula::Exercise& exercise() const { return curriculum().exercises.front(); }

  std::string person(const std::string& skill) {
    return checked(simulated_person(*store, "simulated:" + skill, "Simulated " + skill, skill));
  }
  // One filed trial by a simulated operator.
  SimulatedResult trial(const std::string& skill, std::uint64_t seed, int practice = 1) {
    return checked(run_simulated(
        *store, {&curriculum(), &exercise(), skill, seed, practice, person(skill)}, scene, {}));
  }

  database_test::TemporaryFolder folder;
  SceneStore scenes;
  std::shared_ptr<const Scene> scene;
  std::unique_ptr<database::Store> store;
};

}  // namespace app::test
