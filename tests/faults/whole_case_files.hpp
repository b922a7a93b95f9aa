#pragma once
/// Data files of the cases that hold every key.

#include "support/temporary_case.hpp"

namespace superstep::test {

void write_files_of_cases(const CaseFolder& folder);

}  // namespace superstep::test
