// The only source that is compiled with the version: another version compiles nothing else again.
#include "document/program_version.h"

namespace poinsot::document {

std::string_view program_version() { return POINSOT_VERSION; }

}  // namespace poinsot::document
