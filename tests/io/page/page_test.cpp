#include "io/page/page.hpp"

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "engine/base/error.hpp"
#include "io/page/base64.hpp"
#include "tests/io/mesh/sample_mesh.hpp"
#include "tests/io/mesh/temporary_folder.hpp"

namespace quarry {
namespace {

std::string encoded(std::string_view text) { return base64(std::as_bytes(std::span(text))); }

TEST(Base64, IsThatOfTheStandard) {
  EXPECT_EQ(encoded(""), "");
  EXPECT_EQ(encoded("f"), "Zg==");
  EXPECT_EQ(encoded("fo"), "Zm8=");
  EXPECT_EQ(encoded("foo"), "Zm9v");
  EXPECT_EQ(encoded("foobar"), "Zm9vYmFy");
  EXPECT_EQ(encoded("\xff\xfe\xfd"), "//79");
}

class Page : public testing::Test {
 protected:
  Page() : mesh_(make_sample_mesh({.size = 4})), quality_(mesh_.face_slots(), 0.5) {}
  [[nodiscard]] std::string page(const std::string& title, std::vector<PageFigure> figures = {},
                                 std::vector<PageHistogram> histograms = {}) const {
    const PageOptions options{title, std::move(figures), std::move(histograms), quality_};
    write_page(folder_.file("page.html"), mesh_, options);
    return file_content(folder_.file("page.html"));
  }
  Mesh mesh_;
  std::vector<double> quality_;
  TemporaryFolder folder_;
};

TEST_F(Page, HoldsAllThatItShows) {
  const std::string text = page("Traces");
  for (const char* part : {"<title>Traces</title>", "\"points\":\"", "\"features\":\"", "WebGL"})
    EXPECT_NE(text.find(part), std::string::npos) << part;
  for (const char* outside : {"src=", "href=", "@import"})
    EXPECT_EQ(text.substr(0, text.find("<script>")).find(outside), std::string::npos) << outside;
  EXPECT_EQ(text.find("{{"), text.find("{{", text.find("<script>")));
}

TEST_F(Page, ShowsFiguresAndHistograms) {
  const std::string text = page("Traces", {{"smallest angle", "31.4"}}, {{"Angles", 0, 90, {1, 0, 7}}});
  EXPECT_NE(text.find("<tr><td>smallest angle</td><td>31.4</td></tr>"), std::string::npos);
  EXPECT_NE(text.find("<h2>Angles</h2>"), std::string::npos);
  EXPECT_NE(text.find("<title>7</title>"), std::string::npos);
}

TEST_F(Page, EscapesWhatItIsGiven) {
  const std::string text = page("a<b>&\"c\"");
  EXPECT_NE(text.find("<h1>a&lt;b&gt;&amp;&quot;c&quot;</h1>"), std::string::npos);
}

TEST_F(Page, HasTheSameBytesEachTime) { EXPECT_TRUE(page("x") == page("x")); }

TEST_F(Page, RefusesWhatItCannotShow) {
  const Mesh empty;
  for (const auto& [name, mesh] :
       {std::pair<const char*, const Mesh*>("page.htm", &mesh_), {"page.html", &empty}}) {
    try {
      write_page(folder_.file(name), *mesh, {"Traces", {}, {}, quality_});
      FAIL() << name;
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::kUsage);
    }
  }
  EXPECT_EQ(folder_.entries(), 0);
}

}  // namespace
}  // namespace quarry
