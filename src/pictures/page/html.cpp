#include "pictures/page/html.h"

#include <fmt/format.h>

#include "pictures/drawing/markup.h"
#include "pictures/page/bundle.h"
#include "poinsot/pictures.h"

namespace poinsot::pictures {

std::string embedded_json(std::string json) {
  // In JSON the sign stands in texts alone.
  for (std::size_t at = json.find('<'); at != std::string::npos; at = json.find('<', at))
    json.replace(at, 1, "\\u003c");
  return json;
}

namespace {

// The script of the page itself may run and nothing else; nothing is fetched but, by a page of a gallery, the files
// beside it. Typeset formulas carry their measures as style attributes.
std::string policy(bool shared) {
  const std::string script = shared ? "'self' file:" : fmt::format("'{}'", page_script_hash);
  const std::string beside = shared ? " 'self' file:" : "";
  return fmt::format(
      "default-src 'none'; script-src {}; style-src 'unsafe-inline'{}; font-src data:; img-src data: blob:{}; "
      "base-uri 'none'; form-action 'none'",
      script, beside, beside);
}

}  // namespace

std::string page_html(const PageParts& parts, const std::string& shared) {
  if (page_script.empty())
    throw NoPages("this poinsot was built without pages: build it with Node.js and npm, and POINSOT_WEB=ON");
  std::string html = "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n";
  html += fmt::format("<meta http-equiv=\"Content-Security-Policy\" content=\"{}\">\n", policy(!shared.empty()));
  html +=
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<link rel=\"icon\" href=\"data:,\">\n";
  html += fmt::format("<title>{}</title>\n", escaped_markup(parts.title));
  if (shared.empty())
    html.append("<style>").append(page_style).append("</style>\n");
  else
    html += fmt::format("<link rel=\"stylesheet\" href=\"{}page.css\">\n", escaped_markup(shared));
  html += fmt::format("</head>\n<body>\n<noscript><pre>{}</pre></noscript>\n", escaped_markup(parts.fallback));
  html += fmt::format("<script type=\"application/json\" id=\"{}\">{}</script>\n", parts.data_id,
                      embedded_json(parts.data));
  if (shared.empty())
    html.append("<script>").append(page_script).append("</script>\n");
  else
    html += fmt::format("<script src=\"{}page.js\"></script>\n", escaped_markup(shared));
  return html + "</body>\n</html>\n";
}

}  // namespace poinsot::pictures
