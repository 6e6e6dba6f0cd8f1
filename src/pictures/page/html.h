// The frame of every page, and data in it.
#pragma once

#include <string>

namespace poinsot::pictures {

// JSON such that no text in it ends the element that holds it.
std::string embedded_json(std::string json);

struct PageParts {
  std::string title;
  std::string data_id;   // by which the script finds the data
  std::string data;      // JSON
  std::string fallback;  // plain text for a browser without scripts
};

// shared: as in PageOptions. Throws NoPages.
std::string page_html(const PageParts& parts, const std::string& shared);

}  // namespace poinsot::pictures
