#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string>

#include "pictures/page/bundle.h"
#include "pictures/page/html.h"
#include "poinsot/pictures.h"

namespace poinsot {
namespace page_test {

using Json = nlohmann::json;

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++found;
  return found;
}

// What the page's script reads.
Json data_of(const std::string& html, const std::string& id) {
  const std::string begin = "<script type=\"application/json\" id=\"" + id + "\">";
  const std::size_t from = html.find(begin) + begin.size();
  return Json::parse(html.substr(from, html.find("</script>", from) - from));
}

struct Page {
  std::string text;
  Problem problem;
  Document document;

  explicit Page(const std::string& statement)
      : text(statement),
        problem(Problem::from_text(statement, "page.yaml")),
        document(problem.illustrate({}, {}, true)) {}
  std::string html(const PageOptions& options = {}) const { return to_html(problem, text, document, options); }
};

// The pages that are asked for here can be made.
class Pages : public testing::Test {
 protected:
  void SetUp() override {
    if (pictures::page_script.empty()) GTEST_SKIP() << "built without pages";
  }
};

const std::string falling =
    "title: Falling ball\n"
    "given: {m: 2 kg, h: 3 m}\n"
    "letters: {J: N*s}\n"
    "points: {A: [0, 0, h]}\n"
    "bodies: {ball: {sphere: {center: A, radius: 100 mm}, mass: m}}\n"
    "gravity: -z\n"
    "instants: {start: rest}\n"
    "ask: {a: acceleration(ball)}\n";

TEST_F(Pages, a_page_holds_the_document_and_the_statement) {
  const Page page(falling);
  const Json data = data_of(page.html(), "poinsot-page");
  EXPECT_EQ(data["document"]["solutions"][0]["answers"]["a"]["unit"], "m/s^2");
  EXPECT_TRUE(data["document"]["solutions"][0].contains("explanation"));
  EXPECT_EQ(data["document"]["solutions"][0]["scene"]["bodies"][0]["name"], "ball");
  EXPECT_EQ(data["problem"]["text"], falling);
  EXPECT_EQ(data["situations"][0]["data"][0]["text"], "2 kg");
  EXPECT_EQ(data["situations"][0]["letters"][0]["name"], "J");
  EXPECT_EQ(data["questions"][0]["name"], "a");
}

TEST_F(Pages, a_page_alone_holds_script_and_style_and_is_smaller_than_three_megabytes) {
  const std::string html = Page(falling).html();
  EXPECT_NE(html.find(pictures::page_script), std::string::npos);
  EXPECT_NE(html.find(pictures::page_style), std::string::npos);
  EXPECT_NE(html.find("script-src '" + std::string(pictures::page_script_hash) + "'"), std::string::npos);
  EXPECT_LT(html.size(), 3'000'000U);
}

TEST_F(Pages, pages_of_a_gallery_share_script_and_style) {
  const std::string html = Page(falling).html({.shared = "./", .gallery = "index.html"});
  EXPECT_EQ(html.find(pictures::page_script), std::string::npos);
  EXPECT_EQ(html.find(pictures::page_style), std::string::npos);
  EXPECT_NE(html.find("<script src=\"./page.js\"></script>"), std::string::npos);
  EXPECT_NE(html.find("href=\"./page.css\""), std::string::npos);
  EXPECT_EQ(data_of(html, "poinsot-page")["gallery"], "index.html");
  const std::vector<PageFile> files = shared_page_files();
  ASSERT_EQ(files.size(), 2U);
  EXPECT_EQ(files[0].name, "page.js");
  EXPECT_EQ(files[0].contents, pictures::page_script);
}

TEST_F(Pages, hostile_text_of_a_file_stays_text) {
  const std::string hostile = "</script><script>alert(1)</script><!-- <img src=x onerror=alert(2)> '\"&";
  const std::string statement = "title: |\n  " + hostile + "\n" + falling.substr(falling.find('\n') + 1);
  const Page page(statement);
  const std::string html = page.html({.shared = "./"});
  EXPECT_EQ(count(html, "<script"), 2U);  // the data and the reference to the script
  EXPECT_EQ(count(html, "</script"), 2U);
  EXPECT_EQ(count(html, "<img"), 0U);
  EXPECT_EQ(count(html, "<!--"), 0U);
  const std::string title = data_of(html, "poinsot-page")["document"]["title"];
  EXPECT_NE(title.find(hostile), std::string::npos);
}

TEST_F(Pages, bytes_that_are_no_text_do_not_break_the_data) {
  const std::string html = to_html(Page(falling).problem, "\xff\xfe # \xc3", Page(falling).document, {.shared = "./"});
  EXPECT_NE(data_of(html, "poinsot-page")["problem"]["text"].get<std::string>().find("\xef\xbf\xbd"),
            std::string::npos);
}

TEST_F(Pages, a_gallery_lists_its_problems) {
  const std::string html = gallery_html(
      "Some <problems>", {{.page = "a.html", .figure = "a.svg", .title = "A & B", .file = "a.yaml", .kinds = {"blow"}},
                          {.page = "", .figure = "", .title = "", .file = "b.yaml", .kinds = {}, .note = "is wrong"}});
  const Json data = data_of(html, "poinsot-gallery");
  ASSERT_EQ(data["entries"].size(), 2U);
  EXPECT_EQ(data["entries"][0]["title"], "A & B");
  EXPECT_EQ(data["entries"][1]["note"], "is wrong");
  EXPECT_NE(html.find("<title>Some &lt;problems&gt;</title>"), std::string::npos);
}

TEST(PageText, embedded_json_reads_back) {
  const Json value{{"a<b", "</script>"}, {"n", 1}};
  const std::string text = pictures::embedded_json(value.dump());
  EXPECT_EQ(text.find('<'), std::string::npos);
  EXPECT_EQ(Json::parse(text), value);
}

std::vector<std::string> kinds(const std::string& statement) { return kinds_of(statement, Page(statement).document); }
bool has(const std::vector<std::string>& list, const std::string& word) {
  return std::ranges::find(list, word) != list.end();
}

TEST(Kinds, say_what_a_problem_is_about) {
  EXPECT_TRUE(has(kinds(falling), "instant"));
  EXPECT_FALSE(has(kinds(falling), "motion"));
  std::string late = falling;
  late.replace(late.find("ask: {a: acceleration(ball)}"), 28, "ask: {b: center(ball) @ 0.2 s}");
  EXPECT_TRUE(has(kinds(late), "motion"));
  const std::string struck =
      "letters: {m: kg, a: m, J: N*s}\n"
      "points: {A: [0, -a, a], B: [0, 0, a], C: [0, 0, -a], D: [0, a, -a]}\n"
      "bodies: {rod: {wire: [A, B, C, D], mass: m}}\n"
      "impulses: {blow: {body: rod, at: A, value: [J, 0, 0]}}\n"
      "instants: {before: rest}\n"
      "ask: {w: angular_velocity(rod)}\n"
      "claim: {more: kinetic_energy(rod) > J^2/(2*m)}\n";
  const std::vector<std::string> of_blow = kinds(struck);
  for (const char* kind : {"blow", "formula", "claim"}) EXPECT_TRUE(has(of_blow, kind)) << kind;
  EXPECT_FALSE(has(of_blow, "instant"));
}

}  // namespace page_test
}  // namespace poinsot
