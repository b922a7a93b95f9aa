#pragma once
/// Colours: one per method, the same everywhere, and a scale for fields. Chosen to be told apart by people
/// who are colour-blind, on white and on black paper.

#include <span>
#include <string>
#include <vector>

namespace superstep {

enum class Marker { none, circle, square, triangle, diamond, plus, cross };

/// How a series is drawn.
struct Look {
  std::string colour;  ///< "#rrggbb"
  std::string dash;    ///< SVG stroke-dasharray; empty = solid
  Marker marker = Marker::circle;
};

/// Colour and marker of a method by its name; unknown names share what the table leaves.
/// Source of most hues: Okabe & Ito (2008), Color Universal Design, jfly.uni-koeln.de/color
[[nodiscard]] Look method_look(const std::string& integrator);

/// Looks of many SPECs: the method gives the hue; the first setting in which SPECs of one method differ gives
/// the shade and marker, the second one the dashes.
[[nodiscard]] std::vector<Look> looks_of(std::span<const std::string> specs);

/// Look of the k-th of several curves that are not methods; they repeat after seven.
/// Source of the hues: Okabe & Ito (2008)
[[nodiscard]] Look curve_look(std::size_t k);

/// Colour of a value on the scale of fields, from dark blue (0) over green to yellow (1); values outside are
/// clamped. Lightness grows all the way, so it reads in grey too.
[[nodiscard]] std::string field_colour(double fraction);

/// `share` of white mixed in.
[[nodiscard]] std::string tinted(const std::string& colour, double share);

}  // namespace superstep
