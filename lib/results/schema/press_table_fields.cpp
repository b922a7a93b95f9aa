#include "results/schema/press_table_fields.hpp"

namespace superstep {

template <>
const RecordFields<PressTableRow>& fields_of<PressTableRow>() {
  using Row = PressTableRow;
  static const RecordFields<Row> fields = {
      field("case", &Row::case_name, "stem of the case file"),
      field("seed", &Row::seed, "of the bed"),
      field("upper_wall", &Row::upper_wall, "m; lowest height of the upper wall"),
      field("hold", &Row::hold, "s"),
      field("status", &Row::status, "as in results.csv"),
      field("reason", &Row::reason, "why it is not ok"),
      field("fraction_poured", &Row::poured, "volume fraction below that height before the press"),
      field("fraction_pressed", &Row::pressed, "at the end of the hold"),
      field("fraction_released", &Row::released, "at the end of the run"),
      derived<Row>(
          "springback", [](const Row& row) { return row.springback(); },
          "part of the pressed volume fraction that is lost again"),
      derived<Row>(
          "porosity_drop_relative", [](const Row& row) { return row.porosity_drop(); },
          "by which the porosity after release lies below that of the poured bed, over that"),
      derived<Row>(
          "porosity_drop_points", [](const Row& row) { return row.porosity_points(); },
          "the same, as a difference"),
      field("temperature_hold", &Row::temperature_hold, "K; mean at the end of the hold"),
      field("temperature_end", &Row::temperature_end, "K; mean at the end of the run"),
      field("bonds", &Row::bonds, "at the end"),
  };
  return fields;
}

}  // namespace superstep
