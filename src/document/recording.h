// Recording a motion: what a problem file says under `record:`, to a CSV or HDF5 file.
//
// While it runs, a recording is an append-only journal beside the data file, OUT.journal: first what is recorded
// (problem, settings, columns), then block after block of rows, each with the state from which the next one starts, all
// framed with length and checksum. A run that stops at any time leaves a journal that the same call takes up again:
// a torn end is cut off, and the blocks that follow have the bits that they would have had. The data file is made from
// the journal, under another name first; the journal stays.
#pragma once

#include <string>

#include "poinsot/problem.h"
#include "problem/entries/statement.h"

namespace poinsot::document {

// Records the motion of a statement to `output`, as Problem::record says, as far as the budget in force lasts. text:
// what the statement was read from. Throws problem::StatementError where the file or a set is wrong, RecordingError
// else.
Recording record_motion(const problem::Statement& stated, const std::string& text, const std::string& output,
                        const RecordOptions& options);

}  // namespace poinsot::document
