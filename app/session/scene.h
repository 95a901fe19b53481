// Turns the catalogue's descriptions into what the simulator computes with. Building a vessel
// takes a second or so, so that each is built once and shared by every trial in it.
#pragma once

#include <map>
#include <memory>
#include <mutex>
#include <string>

#include "curricula/catalogue.h"
#include "sim/anatomy/vessel.h"
#include "sim/dynamics/world.h"
#include "sim/instrument/instrument.h"

namespace app {

// Everything a trial's world stands on.
struct Scene {
  // shared: by every trial running in this vessel, and by the store of scenes
  std::shared_ptr<const sim::Vessel> vessel;
  sim::Instrument instrument;
  std::string instrument_title;
  double start_inserted = 0.0;  // mm
  std::string anatomy_sha256, instruments_sha256;

  sim::Scenario scenario() const;  // borrows from this Scene
};

sim::Instrument build_instrument(const curricula::InstrumentSpec& spec);
std::unique_ptr<const sim::Vessel> build_vessel(const curricula::AnatomySpec& spec);

// Vessels built so far. May be used from several threads.
class SceneStore {
 public:
  explicit SceneStore(curricula::Library library);
  const curricula::Library& library() const { return library_; }

  base::Result<std::shared_ptr<const Scene>> scene(const curricula::Scene& description);
  base::Result<std::shared_ptr<const sim::Vessel>> vessel(const std::string& anatomy_id);

 private:
  curricula::Library library_;
  std::mutex mutex_;
  std::map<std::string, std::shared_ptr<const sim::Vessel>> vessels_;
};

}  // namespace app
