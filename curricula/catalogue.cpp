#include "curricula/catalogue.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <optional>
#include <set>
#include <system_error>

#include "curricula/read_catalogue.h"

namespace curricula {
namespace {

namespace fs = std::filesystem;

base::Error broken(const fs::path& file, const std::vector<Problem>& problems) {
  const auto first = std::find_if(problems.begin(), problems.end(), [](const Problem& problem) {
    return problem.severity == Problem::Severity::error;
  });
  const Problem problem = first == problems.end() ? Problem{} : *first;
  return {base::ErrorCode::corrupt_data,
          file.string() + ":" + std::to_string(problem.line) + ": " + problem.message};
}

// The YAML files of a folder by name, so that the order is the same everywhere.
base::Result<std::vector<fs::path>> yaml_files(const fs::path& folder) {
  std::error_code error;
  std::vector<fs::path> files;
  for (fs::directory_iterator it(folder, error), end; !error && it != end; it.increment(error)) {
    if (it->path().extension() == ".yaml") files.push_back(it->path());
  }
  if (error) {
    return base::Error{base::ErrorCode::not_found, "the library folder " + folder.string() +
                                                       " cannot be read (" + error.message() +
                                                       "): name the right one with --library"};
  }
  std::sort(files.begin(), files.end());
  return files;
}

base::Result<std::string> read_file(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  std::string text{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
  if (!stream) {
    return base::Error{base::ErrorCode::not_found,
                       file.string() + " cannot be read: check its permissions"};
  }
  return text;
}

// Reads every file of a folder with `read` (text -> Result of a description) and refuses two
// descriptions with one id.
template <typename Spec, typename Read>
base::Status load_folder(const fs::path& folder, Read read, std::vector<Spec>& specs) {
  const auto files = yaml_files(folder);
  if (!files) return files.error();
  std::map<std::string, fs::path> ids;
  for (const fs::path& file : *files) {
    const auto text = read_file(file);
    if (!text) return text.error();
    base::Result<Spec> spec = read(file, *text);
    if (!spec) return spec.error();
    const auto [place, is_new] = ids.emplace(spec->id, file);
    if (!is_new) {
      return base::Error{base::ErrorCode::conflict, file.string() + ":1: the id '" + spec->id +
                                                        "' is also in " + place->second.string() +
                                                        ": give one of them another id"};
    }
    specs.push_back(std::move(*std::move(spec)));
  }
  return base::Done{};
}

template <typename Spec>
const Spec* find_spec(const std::vector<Spec>& specs, const std::string& id) {
  const auto found =
      std::find_if(specs.begin(), specs.end(), [&](const Spec& spec) { return spec.id == id; });
  return found == specs.end() ? nullptr : &*found;
}

template <typename Spec>
base::Result<Spec> spec_or_error(const fs::path& file, CatalogueEntry<Spec> entry) {
  if (!entry.spec) return broken(file, entry.problems);
  return std::move(*entry.spec);
}

}  // namespace

double InstrumentSpec::length() const {
  double sum = 0.0;
  for (const InstrumentSectionSpec& section : sections) sum += section.length;
  return sum;
}

double AnatomySpec::length() const {
  double sum = 0.0;
  for (const TubeLegSpec& leg : legs) sum += leg.length;
  return sum;
}

Catalogue Library::catalogue() const {
  Catalogue catalogue;
  for (const AnatomySpec& spec : anatomies) catalogue.anatomies.push_back({spec.id, spec.length()});
  for (const InstrumentSpec& spec : instruments)
    catalogue.instruments.push_back({spec.id, spec.length()});
  return catalogue;
}

const InstrumentSpec* Library::instrument(const std::string& id) const {
  return find_spec(instruments, id);
}
const AnatomySpec* Library::anatomy(const std::string& id) const {
  return find_spec(anatomies, id);
}

base::Result<Library> load_library(const std::string& folder) {
  const fs::path root = folder;
  Library library;
  const auto instruments = load_folder(
      root / "instruments",
      [](const fs::path& file, const std::string& text) {
        return spec_or_error(file, read_instrument(text));
      },
      library.instruments);
  if (!instruments) return instruments.error();
  const auto anatomies = load_folder(
      root / "anatomies",
      [](const fs::path& file, const std::string& text) {
        return spec_or_error(file, read_anatomy(text));
      },
      library.anatomies);
  if (!anatomies) return anatomies.error();

  // curricula last: they are checked against the catalogue
  const Catalogue catalogue = library.catalogue();
  const auto curricula = load_folder(
      root / "library",
      [&](const fs::path& file, const std::string& text) -> base::Result<Curriculum> {
        CheckResult result = check(text, catalogue);
        if (!result.ok()) return broken(file, result.problems);
        return std::move(*result.curriculum);
      },
      library.curricula);
  if (!curricula) return curricula.error();
  return library;
}

}  // namespace curricula
