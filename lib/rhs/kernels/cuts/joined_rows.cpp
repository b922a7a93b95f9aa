#include "rhs/kernels/cuts/joined_rows.hpp"

#include <algorithm>

#include "core/index.hpp"

namespace superstep {
namespace {

std::vector<std::byte> packed(const NetworkPart& part) {
  Packer packer;
  pack(part, packer);
  return {packer.bytes().begin(), packer.bytes().end()};
}

/// Empty rows up to those of the part, and these.
void append(const RowsOfPart& rows, Network& out) {
  const Network& part = *rows.rows;
  const std::size_t place = rows.place, first = rows.first, last = rows.last;
  out.row_begin.resize(place + first + 1, out.row_begin.back());
  for (std::size_t row = first; row < last; ++row) {
    for (auto k = at(part.row_begin[row]); k < at(part.row_begin[row + 1]); ++k) {
      out.column.push_back(part.column[k] + static_cast<std::int32_t>(place));
      out.conductance.push_back(part.conductance[k]);
    }
    out.row_begin.push_back(static_cast<std::int64_t>(out.column.size()));
  }
  const auto is_taken = [&](std::int32_t row) { return at(row) >= first && at(row) < last; };
  const auto moved = [&](std::int32_t row) { return row + static_cast<std::int32_t>(place); };
  for (const auto& edge : part.ghost_edges) {
    if (!is_taken(edge.row)) continue;
    out.ghost_edges.push_back(
        {moved(edge.row), static_cast<std::int32_t>(out.ghost_value.size()), edge.conductance});
    out.ghost_value.push_back(part.ghost_value[at(edge.ghost)]);
  }
  for (auto exchange : part.radiation) {
    if (!is_taken(exchange.node)) continue;
    exchange.node = moved(exchange.node);
    out.radiation.push_back(exchange);
  }
  out.source.resize(out.row_begin.size() - 1, 0.0);
  std::copy(part.source.begin() + static_cast<std::ptrdiff_t>(first),
            part.source.begin() + static_cast<std::ptrdiff_t>(last),
            out.source.end() - static_cast<std::ptrdiff_t>(last - first));
}

/// Behind the last row that was appended: empty rows up to so many, and what goes without saying.
void complete(std::size_t rows, Network& out) {
  out.row_begin.resize(rows + 1, out.row_begin.back());
  out.source.resize(rows, 0.0);
  out.capacity.assign(rows, 1.0);
  out.ghost_node.assign(out.ghost_value.size(), 0);
  out.ghost_table.assign(out.ghost_value.size(), -1);
}

}  // namespace

/// The lower of the two sends first.
NetworkPart swap_rows(Communicator& among, int neighbour, const NetworkPart& given) {
  const auto bytes = packed(given);
  const bool first = among.rank() < neighbour;
  if (first) among.send(neighbour, bytes);
  const auto answer = among.receive(neighbour);
  if (!first) among.send(neighbour, bytes);
  NetworkPart taken;
  Unpacker unpacker(answer);
  unpack(unpacker, taken);
  return taken;
}

Network joined_rows(std::span<const RowsOfPart> parts, std::size_t rows) {
  Network out;
  out.row_begin.push_back(0);
  for (const auto& part : parts) append(part, out);
  complete(rows, out);
  return out;
}

}  // namespace superstep
