#include "reports/svg.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace reports {
namespace {

constexpr const char* kFont = "Inter, system-ui, 'Liberation Sans', 'DejaVu Sans', sans-serif";

std::string stroke_attributes(const Stroke& stroke) {
  std::string text =
      " stroke=\"" + stroke.colour + "\" stroke-width=\"" + coordinate(stroke.width) + "\"";
  if (!stroke.dash.empty()) text += " stroke-dasharray=\"" + stroke.dash + "\"";
  if (stroke.opacity != 1.0) text += " opacity=\"" + coordinate(stroke.opacity) + "\"";
  if (!stroke.css_class.empty()) text += " class=\"" + stroke.css_class + "\"";
  return text;
}

std::string points_text(const std::vector<Point>& points) {
  std::string text;
  for (const Point& point : points) {
    if (!text.empty()) text += ' ';
    text += coordinate(point.x) + "," + coordinate(point.y);
  }
  return text;
}

const char* anchor_text(Anchor anchor) {
  switch (anchor) {
    case Anchor::middle:
      return "middle";
    case Anchor::end:
      return "end";
    default:
      return "start";
  }
}

// The places where characters of a UTF-8 text begin, and its end.
std::vector<std::size_t> character_starts(const std::string& text) {
  std::vector<std::size_t> starts;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if ((static_cast<unsigned char>(text[i]) & 0xC0U) != 0x80U) starts.push_back(i);
  }
  starts.push_back(text.size());
  return starts;
}

bool is_control(char c) {
  return static_cast<unsigned char>(c) < 0x20 && c != '\t' && c != '\n' && c != '\r';
}

}  // namespace

double text_width(const std::string& words, bool strong) {
  return (strong ? 6.9 : 6.5) * static_cast<double>(character_starts(words).size() - 1);
}

std::string shortened(const std::string& words, double width, bool strong, bool keep_end) {
  if (text_width(words, strong) <= width) return words;
  const std::vector<std::size_t> starts = character_starts(words);
  const auto room =
      static_cast<std::size_t>(std::max(2.0, std::floor(width / text_width("x", strong)) - 1.0));
  const std::size_t tail = keep_end ? room / 2 : 0;
  const std::size_t total = starts.size() - 1;
  if (room >= total) return words;
  return words.substr(0, starts[room - tail]) + "\u2026" + words.substr(starts[total - tail]);
}

std::string escaped(const std::string& text) {
  std::string safe;
  for (const char c : text) {
    switch (c) {
      case '&':
        safe += "&amp;";
        break;
      case '<':
        safe += "&lt;";
        break;
      case '>':
        safe += "&gt;";
        break;
      case '"':
        safe += "&quot;";
        break;
      case '\'':
        safe += "&#39;";
        break;
      default:
        safe += is_control(c) ? "\uFFFD" : std::string(1, c);
    }
  }
  return safe;
}

std::string coordinate(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.2f", std::round(value * 100.0) / 100.0);
  std::string digits = text;
  while (digits.back() == '0') digits.pop_back();
  if (digits.back() == '.') digits.pop_back();
  return digits == "-0" ? "0" : digits;
}

Svg::Svg(const std::string& name, double width, double height, const std::string& title,
         const std::string& description)
    : width_(width), height_(height) {
  const std::string id = escaped(name);
  const std::string size = coordinate(width) + " " + coordinate(height);
  body_ = "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 " + size + "\" width=\"" +
          coordinate(width) + "\" height=\"" + coordinate(height) +
          "\" role=\"img\" aria-labelledby=\"" + id + "-title " + id + "-desc\" font-family=\"" +
          kFont + "\" font-size=\"12\" class=\"chart\">" + "<title id=\"" + id + "-title\">" +
          escaped(title) + "</title><desc id=\"" + id + "-desc\">" + escaped(description) +
          "</desc>";
}

void Svg::line(Point from, Point to, const Stroke& stroke) {
  body_ += "<line x1=\"" + coordinate(from.x) + "\" y1=\"" + coordinate(from.y) + "\" x2=\"" +
           coordinate(to.x) + "\" y2=\"" + coordinate(to.y) + "\"" + stroke_attributes(stroke) +
           "/>";
}

void Svg::polyline(const std::vector<Point>& points, const Stroke& stroke) {
  if (points.size() < 2) return;
  body_ += "<polyline fill=\"none\" stroke-linejoin=\"round\" points=\"" + points_text(points) +
           "\"" + stroke_attributes(stroke) + "/>";
}

void Svg::area(const std::vector<Point>& outline, const std::string& fill,
               const std::string& css_class) {
  body_ += "<polygon points=\"" + points_text(outline) + "\" fill=\"" + fill + "\" class=\"" +
           css_class + "\"/>";
}

void Svg::rectangle(Point corner, double width, double height, const std::string& fill,
                    const std::string& css_class, double radius) {
  body_ += "<rect x=\"" + coordinate(corner.x) + "\" y=\"" + coordinate(corner.y) + "\" width=\"" +
           coordinate(width) + "\" height=\"" + coordinate(height) + "\" rx=\"" +
           coordinate(radius) + "\" fill=\"" + fill + "\" class=\"" + css_class + "\"/>";
}

void Svg::text(Point at, const std::string& words, Anchor anchor, const std::string& colour,
               const std::string& css_class, bool strong, const std::string& full) {
  body_ += "<text x=\"" + coordinate(at.x) + "\" y=\"" + coordinate(at.y) + "\" text-anchor=\"" +
           anchor_text(anchor) + "\" fill=\"" + colour + "\" class=\"" + css_class + "\"";
  if (strong) body_ += " font-weight=\"600\"";
  body_ += ">";
  if (!full.empty() && full != words) body_ += "<title>" + escaped(full) + "</title>";
  body_ += escaped(words) + "</text>";
}

void Svg::raw(const std::string& element) { body_ += element; }

std::string Svg::finish() const { return body_ + "</svg>"; }

}  // namespace reports
