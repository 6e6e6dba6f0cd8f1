// Pictures of what was found: line drawings as a printed text would have them, pages that a browser shows, and files
// for programs that show solids. They are made from the answer document and contain no mechanics.
#pragma once

#include <cstddef>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "poinsot/document.h"
#include "poinsot/problem.h"

namespace poinsot {

struct FigureTitle {
  std::string name;   // as FigureOptions::of has it
  std::string title;  // what it shows
  // The heading of the worked solution's section to which it belongs; "" if it belongs to none.
  std::string section{};
  std::string situation{};  // of several: which one it shows
};

// The line drawings of a solution, which are made of its scene (Problem::illustrate): "model" always; "free-body",
// "impulse", "cones", "motion", "answers", and the names of bodies on which something acts, where there are such; of
// each situation in turn. None if the solution has no scene. Throws std::out_of_range if there is no such solution.
std::vector<FigureTitle> figures(const Document& document, std::size_t solution);

struct FigureOptions {
  std::string of = "model";
  // From where it is seen: "front", "back", "left", "right", "top", "bottom"; "azimuth,elevation" in degrees from the
  // front, to the right and up; "x,y,z" towards the viewer. "" for the one of the file, or that in which least is lost.
  std::string view{};
  bool values = false;      // with values beside symbols
  std::string situation{};  // of several; "" for the first
};

// Thrown where there is no such figure or view; what() says which there are.
class FigureError : public std::invalid_argument {
 public:
  using std::invalid_argument::invalid_argument;
};

// A line drawing that stands alone, as SVG. Names and texts of the file stay text. Throws FigureError, and
// std::out_of_range if there is no such solution.
std::string to_svg(const Document& document, std::size_t solution, const FigureOptions& options = {});

// The worked solutions of a document (to_markdown) with their figures in them, and these figures as files that stand
// beside the text. stem: of the files' names, without folder: "top" gives top-model.svg and top-free-body.svg,
// top-2-model.svg for the second of several solutions, and top-slow-model.svg for the situation "slow" of several.
struct IllustratedMarkdown {
  struct Figure {
    std::string name, svg;
  };
  std::string text;
  std::vector<Figure> figures;
};
IllustratedMarkdown to_illustrated_markdown(const Document& document, const std::string& stem);

// The library was built without the script of the pages.
struct NoPages : std::runtime_error {
  using std::runtime_error::runtime_error;
};

struct PageOptions {
  // For pages that share script and style: the address of the folder where shared_page_files() lie, "files/" or "../".
  // A page without it holds both and opens from anywhere.
  std::string shared{};
  std::string gallery{};  // the address of the index; "" for a page that stands alone
};

// A page of one document: statement, view in space, answers, worked solution, problem file. The document has what
// Problem::illustrate() or another call put into it; `text` is the text of the problem file. Opened in a browser, the
// page needs no network and is not allowed any. Names and texts of the file stay text. Throws NoPages, and
// std::domain_error as require_values() does.
std::string to_html(const Problem& problem, std::string_view text, const Document& document,
                    const PageOptions& options = {});

// The bodies of one solution with their surfaces and edges, and their motion as an animation, as a binary file of the
// form glTF 2.0 (.glb). Throws std::out_of_range if there is no such solution, and std::invalid_argument if it has no
// scene.
std::string to_gltf(const Document& document, std::size_t solution);

// A file that the pages of a gallery share.
struct PageFile {
  std::string name;
  std::string_view contents;
};
std::vector<PageFile> shared_page_files();  // throws NoPages

// A problem in a gallery.
struct GalleryEntry {
  std::string page;    // the address of its page; "" if there is none
  std::string figure;  // the address of its thumbnail; "" if there is none
  std::string title, file;
  std::vector<std::string> kinds{};
  std::string note{};  // why there is no page
};

// What a problem is about, in the words by which a gallery is filtered: "motion", "blow", "claim", ...
std::vector<std::string> kinds_of(std::string_view text, const Document& document);

// The index of a gallery. It stands beside shared_page_files(). Throws NoPages.
std::string gallery_html(const std::string& title, const std::vector<GalleryEntry>& entries);

}  // namespace poinsot
