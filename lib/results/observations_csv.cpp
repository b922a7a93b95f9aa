#include "results/observations_csv.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/text/append.hpp"
#include "core/text/text_file.hpp"
#include "results/text/csv_table.hpp"
#include "results/text/csv_text.hpp"

namespace superstep {
namespace {

void append_curve(std::string& out, const std::string& case_name, const ProbeCurve& curve) {
  const std::string head = fmt::format("{},{},{},{},{}", csv_cell(case_name), csv_cell(curve.spec),
                                       csv_cell(curve.field), csv_cell(curve.unit), csv_cell(curve.probe));
  for (std::size_t k = 0; k < curve.time.size(); ++k) {
    append(out, "{},{},{},", head, curve.time[k], curve.value[k]);
    if (!curve.reference.empty()) append(out, "{}", curve.reference[k]);
    append(out, ",{}\n", k < curve.transient ? 1 : 0);
  }
}

void append_frame(std::string& out, const std::string& case_name, const Slice& slice,
                  const Slice::Frame& frame) {
  const std::string head = fmt::format("{},{},{},{},{},{}", csv_cell(case_name), csv_cell(slice.source),
                                       slice.cut, csv_cell(frame.field), csv_cell(frame.unit), frame.time);
  for (std::size_t k = 0; k < slice.spheres.size(); ++k) {
    const auto& s = slice.spheres[k];
    append(out, "{},{},{:.6g},{:.6g},{:.6g},{:.6g},{:.7g}\n", head, s.id, s.across, s.height, s.depth,
           s.radius, frame.value[k]);
  }
}

double instant(const CsvTable& table, std::size_t row, std::size_t column) {
  const double time = table.required(row, column);
  if (time < 0) table.reject(row, "its time must not be negative");
  return time;
}

void read_histories(const std::string& path, std::map<std::string, CaseObservations>& out) {
  const CsvTable table(path);
  const auto name = table.column("case"), spec = table.column("spec"), field = table.column("field"),
             unit = table.column("unit"), probe = table.column("probe"), time = table.column("time"),
             value = table.column("value"), reference = table.column("reference"),
             transient = table.column("in_transient");
  for (std::size_t row = 0; row < table.rows(); ++row) {
    auto& curves = out[table.text(row, name)].curves;
    const auto same = [&](const ProbeCurve& curve) {
      return curve.spec == table.text(row, spec) && curve.field == table.text(row, field) &&
             curve.probe == table.text(row, probe);
    };
    if (curves.empty() || !same(curves.back()))
      curves.push_back({.spec = table.text(row, spec),
                        .field = table.text(row, field),
                        .unit = table.text(row, unit),
                        .probe = table.text(row, probe)});
    auto& curve = curves.back();
    curve.time.push_back(instant(table, row, time));
    if (curve.time.size() > 1 && curve.time.back() < curve.time[curve.time.size() - 2])
      table.reject(row, "its time is before that of the row above");
    curve.value.push_back(table.required(row, value));
    if (const auto expected = table.number(row, reference)) curve.reference.push_back(*expected);
    const std::string in_transient = table.text(row, transient);
    if (in_transient != "0" && in_transient != "1") table.reject(row, "column 'in_transient' must be 0 or 1");
    if (in_transient == "1") curve.transient = curve.time.size();
  }
  for (auto& [ignored, one] : out)  // a reference that is there for some instants only is of no use
    for (auto& curve : one.curves)
      if (curve.reference.size() != curve.time.size()) curve.reference.clear();
}

void read_snapshots(const std::string& path, std::map<std::string, CaseObservations>& out) {
  const CsvTable table(path);
  const auto name = table.column("case"), source = table.column("source"), cut = table.column("cut"),
             field = table.column("field"), unit = table.column("unit"), time = table.column("time"),
             id = table.column("id"), across = table.column("across"), height = table.column("height"),
             depth = table.column("depth"), radius = table.column("radius"), value = table.column("value");
  for (std::size_t row = 0; row < table.rows(); ++row) {
    auto& slot = out[table.text(row, name)].slice;
    if (!slot) slot = Slice{.source = table.text(row, source), .cut = table.count(row, cut).value_or(0)};
    Slice& slice = *slot;
    const double t = instant(table, row, time);
    const std::string field_name = table.text(row, field);
    if (slice.frames.empty() || slice.frames.back().time != t || slice.frames.back().field != field_name)
      slice.frames.push_back({.field = field_name, .unit = table.text(row, unit), .time = t});
    slice.frames.back().value.push_back(table.required(row, value));
    if (slice.frames.size() > 1) continue;
    slice.spheres.push_back({.id = table.whole(row, id),
                             .across = table.required(row, across),
                             .height = table.required(row, height),
                             .depth = table.required(row, depth),
                             .radius = table.required(row, radius)});
  }
  for (auto& [ignored, one] : out)
    if (one.slice)
      std::erase_if(one.slice->frames, [spheres = one.slice->spheres.size()](const auto& frame) {
        return frame.value.size() != spheres;
      });
}

}  // namespace

std::string histories_csv(std::span<const BenchCase> cases) {
  std::string out = "case,spec,field,unit,probe,time,value,reference,in_transient\n";
  for (const auto& one : cases)
    for (const auto& curve : one.observations.curves) append_curve(out, one.name, curve);
  return out;
}

std::string snapshots_csv(std::span<const BenchCase> cases) {
  std::string out = "case,source,cut,field,unit,time,id,across,height,depth,radius,value\n";
  for (const auto& one : cases)
    if (const auto& slice = one.observations.slice)
      for (const auto& frame : slice->frames) append_frame(out, one.name, *slice, frame);
  return out;
}

std::map<std::string, CaseObservations> read_observations(const std::string& folder) {
  std::map<std::string, CaseObservations> out;
  if (is_regular_file(folder + "/histories.csv")) read_histories(folder + "/histories.csv", out);
  if (is_regular_file(folder + "/snapshots.csv")) read_snapshots(folder + "/snapshots.csv", out);
  return out;
}

}  // namespace superstep
