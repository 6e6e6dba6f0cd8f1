#include "problem/language/tree.h"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <random>

#include "problem/language/failure.h"

namespace poinsot::problem {
namespace tree_test {

std::string failure(const std::string& text) {
  return failure_of([&] { read_tree(text, "f.yaml"); });
}

TEST(Tree, KeepsOrderMarksAndKinds) {
  const Entry root = read_tree("title: Top\ngiven: {m: 3 kg, r: [1, 'two']}\nempty:\n", "f");
  ASSERT_TRUE(root.is_map());
  EXPECT_EQ(root.keys(), (std::vector<std::string>{"title", "given", "empty"}));
  EXPECT_EQ(root.find("title")->text, "Top");
  EXPECT_EQ(root.find("title")->mark, (Mark{1, 8}));
  const Entry& given = *root.find("given");
  EXPECT_EQ(given.mark, (Mark{2, 8}));
  EXPECT_EQ(given.find_key("r")->mark, (Mark{2, 18}));
  EXPECT_EQ(given.find("m")->text, "3 kg");
  const Entry& list = *given.find("r");
  ASSERT_TRUE(list.is_list());
  EXPECT_FALSE(list.items[0].quoted);
  EXPECT_EQ(list.items[1].text, "two");
  EXPECT_TRUE(list.items[1].quoted);
  EXPECT_TRUE(root.find("empty")->is_null());
  EXPECT_EQ(root.find("empty")->mark, (Mark{3, 1})) << "an empty value is where its key is";
  EXPECT_EQ(root.find("nothing"), nullptr);
  EXPECT_EQ(root.find_key("nothing"), nullptr);
}

TEST(Tree, WordsOfYamlStayText) {
  const Entry root = read_tree("{y: n, on: off, yes: no, true: false, 1: 0x10}", "f");
  EXPECT_EQ(root.keys(), (std::vector<std::string>{"y", "on", "yes", "true", "1"}));
  EXPECT_EQ(root.find("y")->text, "n");
  EXPECT_EQ(root.find("on")->text, "off");
  EXPECT_EQ(root.find("1")->text, "0x10");
}

TEST(Tree, NullWordsKeepTheirText) {
  const Entry root = read_tree("a: ~\nb: null\nc: ''\n", "f");
  EXPECT_TRUE(root.find("a")->is_null());
  EXPECT_EQ(root.find("a")->text, "~");
  EXPECT_EQ(root.find("b")->text, "null");
  EXPECT_EQ(root.find("b")->mark, (Mark{2, 4}));
  EXPECT_TRUE(root.find("c")->is_scalar()) << "a text in quotes is a text, even an empty one";
}

TEST(Tree, ColumnsCountCharactersNotBytes) {
  const Entry root = read_tree("{\xc3\xa4\xc3\xb6: 1, b: 2}", "f");
  EXPECT_EQ(root.find_key("b")->mark, (Mark{1, 9}));
}

TEST(Tree, ByteOrderMarkAndCarriageReturnsAreNoText) {
  const Entry root = read_tree(
      "\xef\xbb\xbf"
      "a: 1\r\nb: 2 m\r\n",
      "f");
  EXPECT_EQ(root.find("a")->text, "1");
  EXPECT_EQ(root.find_key("a")->mark, (Mark{1, 1}));
  EXPECT_EQ(root.find("b")->text, "2 m");
  EXPECT_EQ(root.find("b")->mark, (Mark{2, 4}));
}

TEST(Tree, PlacesInScalarsOverSeveralLinesAndInQuotes) {
  const Entry root = read_tree("a: 1 +\n   22\nb: 'x'' y'\nc: |\n  one\n  two\nd: \"p\n  q\"\n", "f");
  const Entry& folded = *root.find("a");
  EXPECT_EQ(folded.text, "1 + 22");
  EXPECT_EQ(folded.place(0), (Mark{1, 4}));
  EXPECT_EQ(folded.place(2), (Mark{1, 6}));
  EXPECT_EQ(folded.place(5), (Mark{2, 5}));
  const Entry& single = *root.find("b");
  EXPECT_EQ(single.text, "x' y");
  EXPECT_EQ(single.place(0), (Mark{3, 5}));
  const Entry& block = *root.find("c");
  EXPECT_EQ(block.place(block.text.find("two")), (Mark{6, 3}));
  const Entry& twofold = *root.find("d");
  EXPECT_EQ(twofold.place(2), (Mark{8, 3}));
}

TEST(Tree, PlaceCountsCharactersWithinAScalar) {
  const Entry root = read_tree("a: \xce\xb8 + b\n", "f");
  EXPECT_EQ(root.find("a")->place(3), (Mark{1, 6}));
}

TEST(Tree, DuplicateKeysNameBothPlaces) {
  EXPECT_EQ(failure("a: 1\nb: 2\na: 3\n"),
            "f.yaml:3:1: error: the key 'a' stands here a second time; the first is in line 1, column 1 (remove one of "
            "the two)");
  EXPECT_EQ(failure("x: {m: 1, 'm': 2}\n"),
            "f.yaml:1:11: error: the key 'm' stands here a second time; the first is in line 1, column 5 (remove one "
            "of the two)");
  EXPECT_EQ(failure("x: {m: 1}\ny: {m: 1}\n"), "no error");
}

TEST(Tree, AnchorsAliasesAndTagsAreRefused) {
  const std::string anchors =
      ", and anchors are not part of the problem language (write the value out, or give it a name "
      "under 'given:' and use the name)";
  EXPECT_EQ(failure("a: &x 1\n"), "f.yaml:1:4: error: a value that begins with '&' sets an anchor" + anchors);
  EXPECT_EQ(failure("a: &x [*x]\n"), "f.yaml:1:4: error: a value that begins with '&' sets an anchor" + anchors);
  EXPECT_EQ(failure("a: *x\n"), "f.yaml:1:4: error: a value that begins with '*' repeats an anchor" + anchors);
  const std::string tags =
      " error: a value that begins with '!' has a tag, and tags are not part of the problem language (leave the tag "
      "out, or put "
      "the text into quotes)";
  EXPECT_EQ(failure("a: !!str 1\n"), "f.yaml:1:4:" + tags);
  EXPECT_EQ(failure("a: ! 1\n"), "f.yaml:1:4:" + tags);
  EXPECT_EQ(failure("a: 1\nb: !x [1]\n"), "f.yaml:2:4:" + tags);
  EXPECT_EQ(failure("<<: {a: 1}\n"),
            "f.yaml:1:1: error: the key '<<' merges maps, and merging is not part of the problem language (write the "
            "entries out)");
}

TEST(Tree, BillionLaughsDieAtTheFirstAnchor) {
  EXPECT_EQ(failure("a: &a [x, x]\nb: &b [*a, *a]\nc: &c [*b, *b]\n").substr(0, 14), "f.yaml:1:4: er");
}

TEST(Tree, KeysArePlainText) {
  const std::string hint =
      " (if this was not meant as a key, is a blank or a ',' missing after a ':' or a value before it?)";
  EXPECT_EQ(failure("? [a, b]\n: 1\n"), "f.yaml:1:3: error: a key must be plain text, not a list" + hint);
  EXPECT_EQ(failure("a: {b: 1, {c: 2}: 3}\n"), "f.yaml:1:11: error: a key must be plain text, not a map" + hint);
  EXPECT_EQ(failure("'': 1\n"), "f.yaml:1:1: error: a key is missing before the ':'");
}

TEST(Tree, OneDocumentOnly) {
  EXPECT_EQ(failure("a: 1\n---\nb: 2\n"),
            "f.yaml:2:1: error: a second document begins here, but a problem file is one document (put each problem "
            "into a file "
            "of its own)");
  EXPECT_EQ(failure("---\na: 1\n...\n"), "no error");
}

TEST(Tree, NothingAtAllIsAnError) {
  const std::string empty = "f.yaml:1:1: error: the file is empty (a problem file begins with 'title: ...')";
  for (const char* text : {"", "\n\n", "# only a comment\n", "---\n", "~", "\xef\xbb\xbf"})
    EXPECT_EQ(failure(text), empty) << text;
}

TEST(Tree, BinaryAndOtherEncodingsAreRefused) {
  const std::string binary =
      " error: this is no text: a byte here is no UTF-8 or a control character (a problem file is a plain text file, "
      "saved as "
      "UTF-8)";
  EXPECT_EQ(failure("a: \xff\n"), "f.yaml:1:4:" + binary);
  EXPECT_EQ(failure(std::string("a: 1\nb: \0\n", 10)), "f.yaml:2:4:" + binary);
  EXPECT_EQ(failure("\x7f"
                    "ELF"),
            "f.yaml:1:1:" + binary);
  EXPECT_EQ(failure(std::string("\xff\xfe"
                                "a\0:\0 \0",
                                8)),
            "f.yaml:1:1:" + binary)
      << "UTF-16";
  EXPECT_EQ(failure("a: \xc0\xaf"), "f.yaml:1:4:" + binary) << "an overlong form";
  EXPECT_EQ(failure("a: \xed\xa0\x80"), "f.yaml:1:4:" + binary) << "a surrogate";
  EXPECT_EQ(failure("a: \xf4\x90\x80\x80"), "f.yaml:1:4:" + binary) << "beyond U+10FFFF";
  EXPECT_EQ(failure("a: \xe2\x82"), "f.yaml:1:4:" + binary) << "cut off";
  EXPECT_EQ(failure("a: \"\\0\"\n"),
            "f.yaml:1:4: error: an escape in this text stands for a control character or for no character at all "
            "(write plain "
            "text)");
}

TEST(Tree, LimitsOnDepth) {
  const std::string deep = "lists and maps are nested more than 64 deep here";
  EXPECT_EQ(failure(std::string(64, '[') + std::string(64, ']')), "no error");
  EXPECT_EQ(failure(std::string(65, '[') + std::string(65, ']')),
            "f.yaml:1:65: error: " + deep + " (close the brackets that are open, or state things flat, under names)");
  EXPECT_NE(failure(std::string(100'000, '[')).find(deep), std::string::npos);
  EXPECT_NE(failure(std::string(100'000, '{')).find(deep), std::string::npos);
  // Block lists in each other have no brackets.
  std::string block;
  for (int i = 0; i < 65; ++i) block += "- ";
  EXPECT_EQ(failure(block + "a\n"), "f.yaml:1:129: error: " + deep + " (state things flat, under names)");
  // Nor have maps by indentation.
  std::string maps;
  for (int i = 0; i < 70; ++i) maps += std::string(static_cast<std::size_t>(i), ' ') + "a:\n";
  EXPECT_EQ(failure(maps + std::string(70, ' ') + "b: 1\n"),
            "f.yaml:65:65: error: " + deep + " (state things flat, under names)");
  // Closing brackets in quotes deceive the bound before the parser, but not the count of what it opens.
  std::string deceiving = "a: ";
  for (int i = 0; i < 100; ++i) deceiving += "[']', ";
  deceiving += "1" + std::string(100, ']');
  EXPECT_EQ(failure(deceiving), "f.yaml:1:382: error: " + deep + " (state things flat, under names)");
}

TEST(Tree, LimitsOnSize) {
  std::string many = "a: [";
  for (int i = 0; i < 100'000; ++i) many += "1,";
  EXPECT_NE(failure(many + "]").find("the file has more than 100000 entries"), std::string::npos);
  EXPECT_EQ(failure("a: " + std::string(10'000, 'x')), "no error");
  EXPECT_EQ(failure("a: " + std::string(10'001, 'x')),
            "f.yaml:1:4: error: this text has 10001 bytes, more than the 10000 a text may have (split it into several "
            "entries)");
  EXPECT_EQ(failure("a: 1\n" + std::string(TreeLimits::bytes - 5, '\n')), "no error");
  EXPECT_EQ(failure("a: 1\n" + std::string(TreeLimits::bytes - 4, '\n')),
            "f.yaml:1:1: error: the file is larger than 1048576 bytes (a problem file is a page or two of text)");
}

TEST(Tree, MalformedYamlIsExplained) {
  EXPECT_EQ(failure("a: b: c\n"),
            "f.yaml:1:5: error: a ':' followed by a blank stands where no key can be (one line has one 'key: value'; "
            "several go "
            "into braces, {a: 1, b: 2}; a text with ': ' in it goes into quotes)");
  EXPECT_EQ(failure("a: {b: 1, c: 2\nd: 3\n"),
            "f.yaml:2:2: error: this map in braces is not closed properly; it begins in line 1, column 4 (add the '}', "
            "or the ',' between two entries; a value with brackets and commas of its own goes into quotes, "
            "'max([1, 2])')");
  EXPECT_EQ(failure("a: [1, 2\n"),
            "f.yaml:2:1: error: this list in brackets is not closed properly; it begins in line 1, column 4 (add the "
            "']', or the "
            "',' between two items)");
  EXPECT_EQ(failure("a:\n  b: 1\n c: 2\n"),
            "f.yaml:3:2: error: expected another 'key: value' here, indented like those before (check the indentation "
            "of this "
            "line, and that each ':' has a blank after it)");
  EXPECT_EQ(failure("a: 1\nb: }\n"),
            "f.yaml:2:4: error: this closing bracket has no opening one (remove it, or add the opening one)");
  EXPECT_EQ(failure("a: @b\n"), "f.yaml:1:4: error: no value can begin with this character (put the text into quotes)");
}

// The parser stumbles a line after the mistake, over a ':' that is right.
TEST(Tree, SlipsOfALineAreToldWhereTheyAre) {
  EXPECT_EQ(failure("a:\n\tb: 1\n"),
            "f.yaml:2:1: error: a tab stands in the indentation of this line (indent with blanks; most editors can "
            "replace tabs by them)");
  EXPECT_EQ(failure("a:\n  m 2 kg\n  L: 1 m\n"),
            "f.yaml:2:4: error: a ':' and a blank are missing behind 'm' (write 'm: 2 kg')");
  EXPECT_EQ(failure("a:\n  m = 2 kg  # heavy\n\n  # light\n  L: 1 m\n"),
            "f.yaml:2:4: error: '=' stands where a ':' is expected (write 'm: 2 kg')");
  EXPECT_EQ(failure("a:\n  m:2\n  L: 1 m\n"),
            "f.yaml:2:4: error: a ':' and a blank are missing behind 'm' (write 'm: 2')");
  EXPECT_EQ(failure("a:\n  m: 2 kg\n    L: 1 m\n"),
            "f.yaml:3:5: error: this line is indented farther than the one before it, which has a value already "
            "(begin both in the same column)");
}

TEST(Tree, BracketsThatStayOpenAreNoKeys) {
  EXPECT_EQ(failure("- [1\n- 2\n"), "f.yaml:1:3: error: this '[' is never closed (add the closing bracket)");
  EXPECT_EQ(failure("{a, b"), "f.yaml:1:1: error: this '{' is never closed (add the closing bracket)");
}

TEST(Tree, PlacesFarOutInALongLine) {
  std::string line = "a: [";
  while (line.size() < 250'000) line += "'\xc3\xa4', ";
  const Entry root = read_tree(line + "end]", "f");
  const Entry& last = root.find("a")->items.back();
  EXPECT_EQ(last.text, "end");
  EXPECT_EQ(last.mark.column, 5 + static_cast<int>(root.find("a")->items.size() - 1) * 5);
}

TEST(Tree, QuotesMustClose) {
  const std::string message = " error: the quotes that open here are never closed (add the closing quote)";
  EXPECT_EQ(failure("a: \"x\n"), "f.yaml:1:4:" + message);
  EXPECT_EQ(failure("b: 1\na: 'it''s\n"), "f.yaml:2:4:" + message);
  EXPECT_EQ(failure("a: \"x\\\"\n"), "f.yaml:1:4:" + message);
  EXPECT_EQ(failure("a: \"x\""), "no error");
  EXPECT_EQ(failure("a: 'x'"), "no error");
}

TEST(Tree, AnyBytesGiveATreeOrAnErrorWithAPlace) {
  std::mt19937_64 random(3);
  const std::string_view alphabet = "ab:-?[]{},#&*!|>'\"%@` \n\t01.~<";
  for (int i = 0; i < 20'000; ++i) {
    std::string text(random() % 30, ' ');
    for (char& c : text) c = alphabet[random() % alphabet.size()];
    try {
      read_tree(text, "f");
    } catch (const StatementError& error) {
      ASSERT_GE(error.diagnostics()[0].mark.line, 1) << text;
      ASSERT_GE(error.diagnostics()[0].mark.column, 1) << text;
    }
  }
}

// A folder of its own that goes with the test.
class ReadFile : public ::testing::Test {
 protected:
  ReadFile() {
    std::string name = (std::filesystem::temp_directory_path() / "poinsot_read_file_XXXXXX").string();
    if (!mkdtemp(name.data())) throw std::runtime_error("no scratch folder");
    folder_ = name;
  }
  ~ReadFile() override { std::filesystem::remove_all(folder_); }

  std::string write(const std::string& name, const std::string& bytes) {
    const std::string path = (folder_ / name).string();
    std::ofstream(path, std::ios::binary) << bytes;
    return path;
  }
  static std::string failure(const std::string& path) {
    return failure_of([&] { read_file(path); });
  }

  std::filesystem::path folder_;
};

TEST_F(ReadFile, GivesTheBytes) {
  const std::string bytes("a: 1\r\n\0\xff", 8);
  EXPECT_EQ(read_file(write("a.yaml", bytes)), bytes);
  EXPECT_EQ(read_file(write("empty.yaml", "")), "");
}

TEST_F(ReadFile, UpToTheLimitAndNotBeyond) {
  const std::string largest(TreeLimits::bytes, 'x');
  EXPECT_EQ(read_file(write("largest", largest)).size(), TreeLimits::bytes);
  const std::string path = write("larger", largest + "x");
  EXPECT_EQ(failure(path),
            path + ":1:1: error: the file is larger than 1048576 bytes (a problem file is a page or two of text)");
}

TEST_F(ReadFile, EndlessDevicesEnd) {
  EXPECT_EQ(failure("/dev/zero"),
            "/dev/zero:1:1: error: the file is larger than 1048576 bytes (a problem file is a page or two of text)");
  EXPECT_EQ(read_file("/dev/null"), "");
}

TEST_F(ReadFile, MissingFilesAndFolders) {
  const std::string missing = (folder_ / "missing.yaml").string();
  EXPECT_EQ(failure(missing), missing + ":1:1: error: there is no such file (check the path)");
  EXPECT_EQ(failure(folder_.string()),
            folder_.string() + ":1:1: error: this is a folder, not a problem file (name the files in it)");
}

TEST_F(ReadFile, FilesThatMayNotBeRead) {
  if (geteuid() == 0) GTEST_SKIP() << "the superuser may read everything";
  const std::string forbidden = write("forbidden", "a: 1\n");
  chmod(forbidden.c_str(), 0);
  EXPECT_EQ(failure(forbidden), forbidden + ":1:1: error: the file cannot be opened: Permission denied");
}

}  // namespace tree_test
}  // namespace poinsot::problem
