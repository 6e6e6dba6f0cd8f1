// Worked solutions with figures in them.
#include "pictures/svg/different_figures.h"
#include "poinsot/pictures.h"
#include "poinsot/rendering.h"

namespace poinsot {

IllustratedMarkdown to_illustrated_markdown(const Document& document, const std::string& stem) {
  IllustratedMarkdown illustrated;
  std::vector<std::vector<MarkdownPicture>> pictures(document.solutions.size());
  for (std::size_t i = 0; i < document.solutions.size(); ++i)
    for (pictures::DrawnFigure& figure : pictures::different_figures(document, i)) {
      std::string name = stem;
      if (i > 0) name += "-" + std::to_string(i + 1);
      if (!figure.title.situation.empty()) name += "-" + figure.title.situation;
      name += "-" + figure.title.name + ".svg";
      pictures[i].push_back({figure.title.section, figure.title.title, name});
      illustrated.figures.push_back({name, std::move(figure.svg)});
    }
  illustrated.text = to_markdown(document, pictures);
  return illustrated;
}

}  // namespace poinsot
