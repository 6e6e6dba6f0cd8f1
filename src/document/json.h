// The answer document as JSON, for other programs. Its form is fixed by answer_schema().
#pragma once

#include <string>

#include "document/document.h"

namespace poinsot::document {

// The document on one line, without the line's end. Questions stand in the order of the file; numbers have the digits
// that make them read back as the same double; bytes that are no UTF-8 become U+FFFD; a residual that could not be
// formed (not finite) is null. Throws as require_values().
std::string to_json(const Document& document);

}  // namespace poinsot::document
