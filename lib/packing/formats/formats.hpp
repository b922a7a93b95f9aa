#pragma once
/// One reader per file format; `read_packing` chooses by content. Each throws InputError that names file,
/// line, value and rule.

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "packing/packing.hpp"
#include "packing/read_options.hpp"

namespace superstep {

/// A unit of length that somebody states.
struct StatedUnit {
  double metres = 0;       ///< 0: without dimension
  std::string words;       ///< as in "um, as line 1 says"
  std::string style = {};  ///< unit style that it belongs to, if any
};

/// What a reader is given.
struct PackingFile {
  std::string path;                  ///< for messages
  std::string_view content;          ///< all of it, unpacked
  PackingOptions options;            ///< what the user says
  std::optional<StatedUnit> stated;  ///< by a comment at the top
  bool is_text = true;               ///< without NUL bytes
};

struct PackingFormat {
  std::string name;                             ///< as messages and `superstep info` call it
  bool (*recognises)(const PackingFile& file);  ///< by its beginning, never by its name alone
  Packing (*read)(const PackingFile& file);
  bool names_columns = false;  ///< always: nobody else need say what they are
  bool ends_lines = false;     ///< as programs do, who write it: a last line without an end may be cut
};

/// LAMMPS/LIGGGHTS dump: the last frame, columns in any order, box and units as stated.
[[nodiscard]] PackingFormat lammps_dump_format();
/// LAMMPS/LIGGGHTS data: section Atoms of any style that knows diameters.
[[nodiscard]] PackingFormat lammps_data_format();
/// Yade text: columns as its line `#format` names them.
[[nodiscard]] PackingFormat yade_format();
/// MercuryDPM .data in two or three dimensions: the last frame.
[[nodiscard]] PackingFormat mercury_format();
/// Extended XYZ with radii: the last frame.
[[nodiscard]] PackingFormat xyz_format();
/// VTK files with points that have radii: XML (VTP, VTU) and legacy.
[[nodiscard]] PackingFormat vtk_xml_format();
[[nodiscard]] PackingFormat vtk_legacy_format();
/// Rows of four doubles: x y z and a diameter or radius. Known by its declared name, or by that of the file.
[[nodiscard]] PackingFormat doubles_format();
/// True where a file is such rows, whose bytes mean themselves: nothing of them is encoding or line end.
[[nodiscard]] bool holds_doubles(const std::string& path, std::string_view bytes,
                                 const PackingOptions& options);
/// CSV and other tables, with a header or without: takes nearly everything, so that it is asked last.
[[nodiscard]] PackingFormat table_format();

/// True for the text of a file that `read_packing` would take for a table.
[[nodiscard]] bool is_table(const std::string& path, std::string_view text, const PackingOptions& options);
/// What `read_packing` does with the text of a table. Throws InputError.
[[nodiscard]] Packing read_table(const std::string& path, std::string_view text,
                                 const PackingOptions& options);

/// Unit of length of a file [m]: what the user, the comments and the reader state must agree. Nobody says
/// anything = metres. Leaves a note, or a warning about units without dimension, in `packing`. Throws
/// InputError.
double choose_unit(const PackingFile& file, const std::optional<StatedUnit>& by_format, Packing& packing);

}  // namespace superstep
