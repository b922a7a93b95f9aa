/// Small cases that hold every key there is, each with its files in one input: write_cases FOLDER

#include <filesystem>
#include <fstream>
#include <iterator>

#include "whole_cases.hpp"

int main(int argc, char** argv) {
  using namespace superstep::test;
  if (argc != 2) return 2;
  std::filesystem::create_directories(argv[1]);
  const CaseFolder folder;
  for (const auto& one : whole_cases(folder)) {
    std::string text = toml_text(one.tree).text;
    for (const auto& file : std::filesystem::directory_iterator(folder.file("."))) {
      const std::string name = file.path().filename().string();
      if (text.find('"' + name + '"') == std::string::npos) continue;
      std::ifstream stream(file.path(), std::ios::binary);
      text += "\n=== " + name + "\n" + std::string(std::istreambuf_iterator<char>(stream), {});
    }
    std::ofstream(std::filesystem::path(argv[1]) / one.name, std::ios::binary) << text;
  }
  return 0;
}
