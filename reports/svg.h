// Writes one SVG drawing. Everything is a presentation attribute, so that the drawing looks the
// same in a browser, on its own and in print; classes let a page recolour it.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace reports {

// Escapes text for element content and attribute values. Control characters, which XML cannot
// hold, become the replacement character.
std::string escaped(const std::string& text);

// Roughly how wide a text of 12 px is drawn; semibold is wider.
double text_width(const std::string& words, bool strong = false);
// The text, or its beginning and an ellipsis where it is wider than `width`. With `keep_end` the
// middle is left out instead, because names often differ only at their end.
std::string shortened(const std::string& words, double width, bool strong = false,
                      bool keep_end = false);

struct Point {
  double x = 0.0, y = 0.0;
};

// How a line or an outline is drawn.
struct Stroke {
  std::string colour;
  double width = 1.0;
  std::string dash;  // "6 4", or empty
  std::string css_class;
  double opacity = 1.0;
};

enum class Anchor { start, middle, end };

class Svg {
 public:
  // `id` prefixes the ids of title and description, which must be unique on a page.
  Svg(const std::string& id, double width, double height, const std::string& title,
      const std::string& description);

  void line(Point from, Point to, const Stroke& stroke);
  void polyline(const std::vector<Point>& points, const Stroke& stroke);
  void area(const std::vector<Point>& outline, const std::string& fill,
            const std::string& css_class);
  void rectangle(Point corner, double width, double height, const std::string& fill,
                 const std::string& css_class, double radius = 0.0);
  // A shortened text shows `full` when it is pointed at.
  void text(Point at, const std::string& words, Anchor anchor, const std::string& colour,
            const std::string& css_class, bool strong = false, const std::string& full = {});
  void raw(const std::string& element);  // an element made elsewhere, already escaped

  std::string finish() const;  // the whole <svg> element

  double width() const { return width_; }
  double height() const { return height_; }

 private:
  double width_, height_;
  std::string body_;
};

// Coordinates with at most two decimals: the same bytes on every machine.
std::string coordinate(double value);

// The colours of the desk theme; a page's style sheet may override them by class.
namespace colour {
inline constexpr const char* kText = "#14181f";
inline constexpr const char* kText2 = "#47505e";
inline constexpr const char* kText3 = "#5f6876";
inline constexpr const char* kExpert = "#0b5cad";
inline constexpr const char* kExpertBand = "#d6e6f7";
inline constexpr const char* kNovice = "#a04400";
inline constexpr const char* kLimit = "#b3261e";
inline constexpr const char* kGrid = "#e8ebef";
inline constexpr const char* kAxis = "#818b99";
inline constexpr const char* kSurface = "#ffffff";
}  // namespace colour

}  // namespace reports
