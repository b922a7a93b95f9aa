/// Points of VTK files as packings: every encoding that ParaView and LIGGGHTS write.

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <zlib.h>

#include <algorithm>
#include <cstring>

#include "core/error.hpp"
#include "packing/read.hpp"
#include "support/temporary_folder.hpp"

namespace superstep {
namespace {

Packing read_text(const std::string& content) {
  const test::TemporaryFolder folder;
  return read_packing(folder.write("p.vtk", content));
}

std::string refusal(const std::string& content) {
  return test::message_of<InputError>([&] { (void)read_text(content); });
}

/// Three points on a line, radii 0.5, 0.25, 1, types 1, 2, 1, temperatures 10, 20, 30.
const std::vector<float> points = {0, 0, 0, 3, 0, 0, 6, 0.5, 0};
const std::vector<float> radii = {0.5, 0.25, 1};
const std::vector<std::int64_t> types = {1, 2, 1};
const std::vector<double> temperatures = {10, 20, 30};

void expect_points(const Packing& packing) {
  ASSERT_EQ(packing.size(), 3u);
  EXPECT_EQ(packing.centre[2].x, 6);
  EXPECT_EQ(packing.centre[2].y, 0.5);
  EXPECT_EQ(packing.radius, (std::vector<double>{0.5, 0.25, 1}));
  EXPECT_EQ(packing.material, (std::vector<std::int32_t>{0, 1, 0}));
  ASSERT_NE(find_attribute(packing, "temperature"), nullptr);
  EXPECT_EQ(find_attribute(packing, "temperature")->value, temperatures);
}

template <class Value>
std::string bytes_of(const std::vector<Value>& values, bool swapped = false) {
  std::string out(values.size() * sizeof(Value), '\0');
  std::memcpy(out.data(), values.data(), out.size());
  for (std::size_t k = 0; swapped && k < out.size(); k += sizeof(Value))
    for (std::size_t b = 0; b < sizeof(Value) / 2; ++b) std::swap(out[k + b], out[k + sizeof(Value) - 1 - b]);
  return out;
}

template <class Header>
std::string header(std::initializer_list<Header> values) {
  return bytes_of(std::vector<Header>(values));
}

std::string base64(const std::string& bytes) {
  const std::string digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string out;
  for (std::size_t k = 0; k < bytes.size(); k += 3) {
    std::uint32_t group = 0;
    for (std::size_t b = 0; b < 3; ++b)
      group = group << 8 | (k + b < bytes.size() ? static_cast<unsigned char>(bytes[k + b]) : 0u);
    const std::size_t digits_used = std::min<std::size_t>(bytes.size() - k, 3) + 1;
    for (std::size_t d = 0; d < 4; ++d) out += d < digits_used ? digits[group >> (18 - 6 * d) & 63] : '=';
  }
  return out;
}

std::string deflated(const std::string& bytes) {
  uLongf size = compressBound(bytes.size());
  std::string out(size, '\0');
  compress(reinterpret_cast<Bytef*>(out.data()), &size, reinterpret_cast<const Bytef*>(bytes.data()),
           bytes.size());
  out.resize(size);
  return out;
}

/// How the arrays of a file are written: in place or behind, in base64 or raw, plain or in zlib blocks.
struct Writer {
  bool appended = false, raw = false, zlib = false, wide = false;
  std::string behind;

  std::string block(const std::string& bytes) {
    std::string head, body = bytes;
    if (zlib) {
      const std::string first = deflated(bytes.substr(0, 8)), second = deflated(bytes.substr(8));
      head = wide ? header<std::uint64_t>({2, 8, bytes.size() - 8, first.size(), second.size()})
                  : header<std::uint32_t>({2, 8, static_cast<std::uint32_t>(bytes.size() - 8),
                                           static_cast<std::uint32_t>(first.size()),
                                           static_cast<std::uint32_t>(second.size())});
      body = first + second;
    } else {
      head = wide ? header<std::uint64_t>({bytes.size()})
                  : header<std::uint32_t>({static_cast<std::uint32_t>(bytes.size())});
    }
    if (raw) return head + body;
    return zlib ? base64(head) + base64(body) : base64(head + body);
  }
  std::string array(const std::string& attributes, const std::string& bytes) {
    if (!appended)
      return fmt::format("<DataArray {} format=\"binary\">\n   {}\n</DataArray>\n", attributes, block(bytes));
    const std::string out =
        fmt::format("<DataArray {} format=\"appended\" offset=\"{}\"/>\n", attributes, behind.size());
    behind += block(bytes);
    return out;
  }
  std::string file(const char* type) {
    std::string out = fmt::format(
        "<?xml version=\"1.0\"?>\n<VTKFile type=\"{0}\" version=\"1.0\" byte_order=\"LittleEndian\" "
        "header_type=\"{1}\"{2}>\n<{0}>\n<Piece NumberOfPoints=\"3\" NumberOfCells=\"0\">\n",
        type, wide ? "UInt64" : "UInt32", zlib ? " compressor=\"vtkZLibDataCompressor\"" : "");
    out += "<PointData Scalars=\"radius\">\n" + array("type=\"Float32\" Name=\"Radius\"", bytes_of(radii)) +
           array("type=\"Int64\" Name=\"type\"", bytes_of(types)) +
           array("type=\"Float64\" Name=\"temperature\" NumberOfComponents=\"1\"", bytes_of(temperatures)) +
           "</PointData>\n";
    out += "<CellData>\n</CellData>\n<Points>\n" +
           array("type=\"Float32\" Name=\"Points\" NumberOfComponents=\"3\"", bytes_of(points)) +
           "</Points>\n";
    out += fmt::format("</Piece>\n</{}>\n", type);
    if (appended)
      out += fmt::format("<AppendedData encoding=\"{}\">\n _{}\n</AppendedData>\n", raw ? "raw" : "base64",
                         behind);
    return out + "</VTKFile>\n";
  }
};

TEST(VtkXml, EveryEncodingReadsTheSame) {
  for (const char* type : {"PolyData", "UnstructuredGrid"})
    for (const bool appended : {false, true})
      for (const bool raw : {false, true})
        for (const bool zlib : {false, true})
          for (const bool wide : {false, true}) {
            if (raw && !appended) continue;
            SCOPED_TRACE(
                fmt::format("{} appended {} raw {} zlib {} wide {}", type, appended, raw, zlib, wide));
            expect_points(read_text(Writer{appended, raw, zlib, wide, {}}.file(type)));
          }
}

const std::string ascii =
    "<VTKFile type=\"PolyData\" version=\"0.1\" byte_order=\"BigEndian\">\n<!-- a <remark> "
    "-->\n<PolyData><Piece NumberOfPoints=\"3\">"
    "<PointData><DataArray type=\"Float32\" Name=\"radius\" format=\"ascii\">0.5 0.25 1</DataArray>"
    "<DataArray type=\"Int32\" Name=\"type\" format=\"ascii\">1 2 1</DataArray>"
    "<DataArray type=\"String\" Name=\"label\" format=\"ascii\">1 2 3</DataArray>"
    "<DataArray type=\"Float32\" Name=\"temperature\" format=\"ascii\">10 20\n30</DataArray></PointData>"
    "<Points><DataArray type=\"Float32\" NumberOfComponents=\"3\" format=\"ascii\">0 0 0 3 0 0 6 0.5 "
    "0</DataArray></Points>"
    "</Piece></PolyData></VTKFile>\n";

std::string replaced(std::string text, const std::string& what, const std::string& by) {
  const auto at = text.find(what);
  EXPECT_NE(at, std::string::npos);
  return text.replace(at, what.size(), by);
}

TEST(VtkXml, AsciiAndPiecesAndErrors) {
  expect_points(read_text(ascii));
  EXPECT_NE(refusal(replaced(ascii, "Name=\"radius\"", "Name=\"size\"")).find("'radius' is missing"),
            std::string::npos);
  EXPECT_NE(
      refusal(replaced(ascii, "NumberOfPoints=\"3\"", "NumberOfPoints=\"4\"")).find("announces 4 points"),
      std::string::npos);
  EXPECT_NE(refusal(replaced(ascii, "0.25 1", "0.25 x")).find("'x'"), std::string::npos);
  EXPECT_NE(refusal(replaced(ascii, "PolyData\" v", "ImageData\" v")).find("'ImageData'"), std::string::npos);
  EXPECT_NE(refusal(replaced(ascii, "0.5 0.25", "-0.5 0.25")).find("point 0: radius is -0.5"),
            std::string::npos);
  Writer writer{true, true, false, false, {}};
  const std::string whole = writer.file("PolyData");
  EXPECT_NE(refusal(whole.substr(0, whole.find("_") + 20)), "") << "cut off";
  EXPECT_NE(refusal(replaced(Writer{false, false, true, false, {}}.file("PolyData"), "vtkZLib", "vtkLZ4"))
                .find("vtkLZ4DataCompressor"),
            std::string::npos);
}

TEST(VtkLegacy, AsciiAndBinaryWithCellsBetween) {
  const std::string head = "# vtk DataFile Version 3.0\nspheres\n", set = "DATASET POLYDATA\n";
  const std::string text = head + "ASCII\n" + set +
                           "POINTS 3 float\n0 0 0 3 0 0\n6 0.5 0\nVERTICES 3 6\n1 0\n1 1\n1 2\nCELL_DATA "
                           "3\nSCALARS radius float\nLOOKUP_TABLE default\n"
                           "9 9 9\nPOINT_DATA 3\nVECTORS v float\n1 2 3 4 5 6 7 8 9\nSCALARS radius float "
                           "1\nLOOKUP_TABLE default\n0.5 0.25 1\n"
                           "FIELD more 2\ntype 1 3 int\n1 2 1\ntemperature 1 3 double\n10 20 30\n";
  const auto packing = read_text(text);
  expect_points(packing);
  EXPECT_EQ(find_attribute(packing, "v:2")->value[1], 6);
  const std::vector<std::int32_t> vertices = {1, 0, 1, 1, 1, 2};
  const std::string binary =
      head + "BINARY\n" + set + "POINTS 3 float\n" + bytes_of(points, true) + "\nVERTICES 3 6\n" +
      bytes_of(vertices, true) + "\nPOINT_DATA 3\nSCALARS radius float 1\nLOOKUP_TABLE default\n" +
      bytes_of(radii, true) +
      "\nMETADATA\nINFORMATION 0\n\nSCALARS type vtktypeint64 1\nLOOKUP_TABLE default\n" +
      bytes_of(types, true) + "\nSCALARS temperature double 1\nLOOKUP_TABLE default\n" +
      bytes_of(temperatures, true) + "\n";
  expect_points(read_text(binary));
  EXPECT_NE(refusal(binary.substr(0, binary.size() / 2)), "");
  EXPECT_NE(refusal(text.substr(0, text.find("0.25"))).find("cut off"), std::string::npos);
  EXPECT_NE(refusal(text.substr(0, text.find("type 1 3"))).find("cut off"), std::string::npos);
  EXPECT_NE(refusal(head + "ASCII\nDATASET STRUCTURED_POINTS\nDIMENSIONS 2 2 2\n").find("'DIMENSIONS'"),
            std::string::npos);
}

std::string legacy(const std::string& data) {
  return "# vtk DataFile Version 5.1\nt\nASCII\nDATASET POLYDATA\nPOINTS 3 float\n0 0 0 3 0 0 6 0.5 0\n"
         "METADATA\nCOMPONENT_NAMES\nX\nY\n\nINFORMATION 1\nNAME L2 LOCATION vtkDataArray\nDATA 2 0 6\n\n"
         "POINT_DATA 3\n" +
         data + "SCALARS radius double 1\nLOOKUP_TABLE default\n0.5 0.25 1\n";
}

TEST(VtkLegacy, EveryKindOfDataIsReadOrNamed) {
  const std::string nine = "1 2 3 4 5 6 7 8 9\n", three = "7 8 9\n";
  for (const auto& data :
       {"GLOBAL_IDS GlobalPointIds vtkIdType\n" + three, "PEDIGREE_IDS PedigreeIds vtkIdType\n" + three,
        "EDGE_FLAGS flags unsigned_char\n" + three, "COLOR_SCALARS col 3\n" + nine,
        "TEXTURE_COORDINATES tex 3 float\n" + nine, "VECTORS v float\n" + nine, "NORMALS n float\n" + nine,
        "TENSORS t float\n" + nine + nine + nine, "TENSORS6 t float\n" + nine + nine,
        "SCALARS s float\nLOOKUP_TABLE mine\n" + three + "LOOKUP_TABLE mine 2\n0 0 0 1 1 1 1 1\n",
        "FIELD f 1\nv 3 3 float\n" + nine + "METADATA\nCOMPONENT_NAMES\nX\n\n\nINFORMATION 0\n\n"}) {
    const auto packing = read_text(legacy(data));
    EXPECT_EQ(packing.radius, (std::vector<double>{0.5, 0.25, 1})) << data;
  }
  const auto message = refusal(legacy("HIGHER_ORDER_DEGREES d float\n" + nine));
  EXPECT_NE(message.find("'HIGHER_ORDER_DEGREES' begins no data that are read"), std::string::npos)
      << message;
}

TEST(VtkLegacy, DataBelongToOneListOfPoints) {
  const std::string once = "# vtk DataFile Version 3.0\nt\nASCII\nDATASET POLYDATA\nPOINTS 1 float\n0 0 0\n",
                    data = "POINT_DATA 1\nSCALARS radius float 1\nLOOKUP_TABLE default\n1\n",
                    again = "POINTS 2 float\n0 0 0 1.9 0 0\n";
  for (const auto& text : {once + data + again, once + again + data})
    EXPECT_NE(refusal(text).find("POINTS stands twice"), std::string::npos) << text;
  EXPECT_NE(refusal(once + "POINT_DATA 2\nSCALARS radius float 1\nLOOKUP_TABLE default\n1 1\n")
                .find("POINT_DATA announces 2 points, and POINTS has 1"),
            std::string::npos);
}

TEST(VtkLegacy, AQuoteThatIsNotClosedIsRefused) {
  const std::string head = "# vtk DataFile Version 3.0\nt\nASCII\n";
  for (const char* rest :
       {"\"D\n", "DATASET POLYDATA\nPOINTS 1 float\n0 0 0\nPOINT_DATA 1\nFIELD f 1\n\"r 1 1 float\n1\n"})
    EXPECT_NE(refusal(head + rest).find("quote that is not closed"), std::string::npos) << rest;
}

TEST(VtkLegacy, NamesHaveTheirBlanksBack) {
  const auto packing = read_text(
      "# vtk DataFile Version 3.0\nt\nASCII\nDATASET POLYDATA\nPOINTS 2 double\n0 0 0 0 0 1\nPOINT_DATA 2\n"
      "FIELD FieldData 2\nparticle%20radius 1 2 double\n0.55 0.55\n50%25%20done 1 2 double\n1 2\n");
  EXPECT_EQ(packing.radius[0], 0.55);
  EXPECT_NE(find_attribute(packing, "50% done"), nullptr);
}

TEST(VtkXml, AnArrayCalledXIsNoCoordinate) {
  const auto packing = read_text(
      "<VTKFile type=\"PolyData\"><PolyData><Piece NumberOfPoints=\"2\"><PointData>"
      "<DataArray type=\"Float64\" Name=\"radius\" format=\"ascii\">1 2</DataArray>"
      "<DataArray type=\"Float64\" Name=\"x\" format=\"ascii\">7 8</DataArray>"
      "<DataArray type=\"Float64\" Name=\"Points\" NumberOfComponents=\"3\" format=\"ascii\">9 9 9 9 9 9"
      "</DataArray></PointData><Points><DataArray type=\"Float64\" NumberOfComponents=\"3\" format=\"ascii\">"
      "0 0 0 5 0 0</DataArray></Points></Piece></PolyData></VTKFile>");
  EXPECT_EQ(packing.centre[1].x, 5);
  EXPECT_EQ(find_attribute(packing, "x")->value, (std::vector<double>{7, 8}));
}

}  // namespace
}  // namespace superstep
