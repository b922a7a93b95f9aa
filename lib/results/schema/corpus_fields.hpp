#pragma once
/// The columns of corpus.csv: a contract.

#include "results/corpus/corpus_row.hpp"
#include "results/schema/record_field.hpp"

namespace superstep {

template <>
const RecordFields<CorpusRow>& fields_of<CorpusRow>();

}  // namespace superstep
