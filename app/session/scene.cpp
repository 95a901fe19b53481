#include "app/session/scene.h"

#include <stdexcept>
#include <string>
#include <utility>

#include "sim/anatomy/tube.h"

namespace app {
namespace {

base::Error not_found(const std::string& what, const std::string& id) {
  return {base::ErrorCode::not_found, "There is no " + what + " '" + id + "' in the library."};
}

base::Error invalid(std::string message) {
  return {base::ErrorCode::invalid_input, std::move(message)};
}

// "412.5", as short as it can be written with a tenth of a millimetre.
std::string millimetres(double length) {
  std::string text = std::to_string(length);
  text.resize(text.find('.') + 2);
  if (text.ends_with(".0")) text.resize(text.size() - 2);
  return text + " mm";
}

sim::Vec3 vector_of(const std::array<double, 3>& values) {
  return {values[0], values[1], values[2]};
}

}  // namespace

sim::Scenario Scene::scenario() const { return {vessel.get(), &instrument, start_inserted}; }

sim::Instrument build_instrument(const curricula::InstrumentSpec& spec) {
  sim::Instrument instrument;
  instrument.id = spec.id;
  instrument.outer_diameter = spec.outer_diameter;
  instrument.inner_diameter = spec.inner_diameter;
  instrument.length = spec.length();
  instrument.friction = spec.friction;
  for (const auto& section : spec.sections) {
    instrument.sections.push_back(
        {section.length, section.bending_stiffness, section.twist_stiffness});
  }
  for (const auto& bend : spec.tip_bends) {
    // the file gives the angle of the whole bend, the rod wants it per length
    instrument.tip_bends.push_back({bend.from_tip, bend.length, bend.angle / bend.length});
  }
  return instrument;
}

std::unique_ptr<const sim::Vessel> build_vessel(const curricula::AnatomySpec& spec) {
  sim::TubeDescription tube;
  tube.id = spec.id;
  tube.start_radius = spec.start_radius;
  tube.access = vector_of(spec.access);
  tube.direction = vector_of(spec.direction);
  for (const auto& leg : spec.legs) {
    tube.legs.push_back({leg.length, leg.bend, leg.plane, leg.radius});
  }
  return sim::build_tube_vessel(tube, spec.voxel);
}

SceneStore::SceneStore(curricula::Library library) : library_(std::move(library)) {}

base::Result<std::shared_ptr<const Scene>> SceneStore::scene(const curricula::Scene& description) {
  const curricula::AnatomySpec* anatomy = library_.anatomy(description.anatomy);
  if (anatomy == nullptr) return not_found("anatomy", description.anatomy);
  if (description.instruments.size() != 1) {
    return invalid("A scene needs exactly one instrument, but this one names " +
                   std::to_string(description.instruments.size()) + ".");
  }
  const std::string& instrument_id = description.instruments.front();
  const curricula::InstrumentSpec* instrument = library_.instrument(instrument_id);
  if (instrument == nullptr) return not_found("instrument", instrument_id);

  if (description.start < 0.0) return invalid("A trial cannot start with less than 0 mm inserted.");
  if (description.start > instrument->length()) {
    return invalid("The trial starts with " + millimetres(description.start) +
                   " inserted, but the instrument '" + instrument_id + "' is only " +
                   millimetres(instrument->length()) + " long.");
  }
  if (description.start > anatomy->length()) {
    return invalid("The trial starts with " + millimetres(description.start) +
                   " inserted, but the vessel '" + anatomy->id + "' is only " +
                   millimetres(anatomy->length()) + " long.");
  }

  auto vessel = this->vessel(description.anatomy);
  if (!vessel) return vessel.error();
  auto scene = std::make_shared<Scene>();
  scene->vessel = *std::move(vessel);
  scene->instrument = build_instrument(*instrument);
  scene->instrument_title = instrument->title;
  scene->start_inserted = description.start;
  scene->anatomy_sha256 = anatomy->sha256;
  scene->instruments_sha256 = instrument->sha256;
  return std::shared_ptr<const Scene>(std::move(scene));
}

base::Result<std::shared_ptr<const sim::Vessel>> SceneStore::vessel(const std::string& anatomy_id) {
  const curricula::AnatomySpec* anatomy = library_.anatomy(anatomy_id);
  if (anatomy == nullptr) return not_found("anatomy", anatomy_id);

  // held while building: whoever asks for the same vessel meanwhile waits instead of building it
  const std::lock_guard lock(mutex_);
  const auto found = vessels_.find(anatomy_id);
  if (found != vessels_.end()) return found->second;
  try {
    std::shared_ptr<const sim::Vessel> built = build_vessel(*anatomy);
    vessels_.emplace(anatomy_id, built);
    return built;
  } catch (const std::invalid_argument& problem) {
    return invalid("The anatomy '" + anatomy_id + "' cannot be built: " + problem.what() + ".");
  }
}

}  // namespace app
