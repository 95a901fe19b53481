// What a case gets to work with: its parameters, checked against its definition, and a place to
// put down what came out.
#pragma once

#include <cmath>
#include <map>
#include <string>
#include <utility>

#include "sim/validation/validation_case.h"

namespace sim::validation {

class CaseRun {
 public:
  CaseRun(std::map<std::string, double> parameters, Progress progress)
      : parameters_(std::move(parameters)), progress_(std::move(progress)) {}

  double operator[](const std::string& parameter) const { return parameters_.at(parameter); }
  int whole(const std::string& parameter) const {
    return static_cast<int>(std::lround(parameters_.at(parameter)));
  }
  void progress(double share) const {
    if (progress_) progress_(share);
  }

  void simulated(const std::string& name, double value, const std::string& unit) {
    result_.simulated.push_back({name, value, unit});
  }
  void expected(const std::string& name, double value, const std::string& unit,
                const std::string& source) {
    result_.expected.push_back({name, value, unit, source});
  }
  void check(const std::string& name, double deviation, double bound, const std::string& unit) {
    result_.checks.push_back({name, deviation, bound, unit, std::abs(deviation) <= bound});
  }
  CaseResult take_result() { return std::move(result_); }

 private:
  std::map<std::string, double> parameters_;
  Progress progress_;
  CaseResult result_;
};

inline double percent(double value, double reference) {
  return 100.0 * (value - reference) / reference;
}

// The bound given for 50 elements, widened as h^2 for coarser meshes: the method is second order.
inline double mesh_bound(double bound, int elements) {
  const double ratio = elements < 50 ? 50.0 / elements : 1.0;
  return bound * ratio * ratio;
}

// One per case: what it is, and how it is run.
CaseDefinition cantilever_definition();
base::Status run_cantilever(CaseRun& run);
CaseDefinition elastica_definition();
base::Status run_elastica(CaseRun& run);
CaseDefinition buckling_definition();
base::Status run_buckling(CaseRun& run);
CaseDefinition twist_definition();
base::Status run_twist(CaseRun& run);
CaseDefinition capstan_definition();
base::Status run_capstan(CaseRun& run);
CaseDefinition pre_curved_tip_definition();
base::Status run_pre_curved_tip(CaseRun& run);
CaseDefinition whip_definition();
base::Status run_whip(CaseRun& run);
CaseDefinition stiction_definition();
base::Status run_stiction(CaseRun& run);
CaseDefinition feed_ripple_definition();
base::Status run_feed_ripple(CaseRun& run);
CaseDefinition handle_force_definition();
base::Status run_handle_force(CaseRun& run);

}  // namespace sim::validation
