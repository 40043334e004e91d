#include "io/mesh/xml_element.hpp"

#include <cctype>
#include <fmt/format.h>

#include "engine/base/error.hpp"

namespace quarry {
namespace {

class XmlParser {
 public:
  XmlParser(const std::string& path, std::string_view text, std::string_view stop)
      : path_(path), text_(text), stop_(stop) {}

  XmlElement parse() {
    skip_prolog();
    return element(0);
  }

 private:
  static constexpr int kDeepest = 64;

  void skip_prolog() {
    while (true) {
      skip_space();
      if (!text_.substr(at_).starts_with("<?") && !text_.substr(at_).starts_with("<!")) return;
      skip_comment();
    }
  }

  // Also processing instructions and document types.
  void skip_comment() {
    const std::string_view end = text_.substr(at_).starts_with("<!--") ? "-->" : ">";
    const std::size_t found = text_.find(end, at_);
    if (found == std::string_view::npos) fail("a comment does not end");
    at_ = found + end.size();
  }

  XmlElement element(int depth) {
    if (depth > kDeepest) fail("elements are nested too deeply");
    if (at_ >= text_.size() || text_[at_] != '<') fail("an element is expected");
    ++at_;
    XmlElement result;
    result.name = name();
    const bool closed = read_attributes(result);
    if (result.name == stop_) {
      result.text = text_.substr(at_);
      stopped_ = true;
    } else if (!closed) {
      read_content(result, depth);
    }
    return result;
  }

  // True for an element that is closed at once: <a/>.
  bool read_attributes(XmlElement& element) {
    while (true) {
      skip_space();
      if (text_.substr(at_).starts_with("/>")) {
        at_ += 2;
        return true;
      }
      if (at_ < text_.size() && text_[at_] == '>') {
        ++at_;
        return false;
      }
      const std::string_view key = name();
      skip_space();
      expect('=');
      skip_space();
      const char quote = at_ < text_.size() ? text_[at_] : '\0';
      if (quote != '"' && quote != '\'') fail("a quoted value is expected");
      const std::size_t end = text_.find(quote, at_ + 1);
      if (end == std::string_view::npos) fail("a quoted value does not end");
      element.attributes.emplace_back(key, text_.substr(at_ + 1, end - at_ - 1));
      at_ = end + 1;
    }
  }

  void read_content(XmlElement& parent, int depth) {
    const std::size_t begin = at_;
    while (!stopped_) {
      at_ = text_.find('<', at_);
      if (at_ == std::string_view::npos) fail(fmt::format("the element {} does not end", parent.name));
      const std::string_view rest = text_.substr(at_);
      if (rest.starts_with("</")) {
        if (parent.children.empty()) parent.text = text_.substr(begin, at_ - begin);
        at_ += 2;
        if (name() != parent.name) fail(fmt::format("</{}> is expected", parent.name));
        skip_space();
        expect('>');
        return;
      }
      if (rest.starts_with("<!") || rest.starts_with("<?"))
        skip_comment();
      else
        parent.children.push_back(element(depth + 1));
    }
  }

  std::string_view name() {
    const std::size_t begin = at_;
    while (at_ < text_.size() &&
           text_.substr(at_, 1).find_first_of(" \t\r\n=/>\"'<") == std::string_view::npos)
      ++at_;
    if (at_ == begin) fail("a name is expected");
    return text_.substr(begin, at_ - begin);
  }

  void skip_space() {
    while (at_ < text_.size() && std::isspace(static_cast<unsigned char>(text_[at_])) != 0) ++at_;
  }
  void expect(char c) {
    if (at_ >= text_.size() || text_[at_] != c) fail(fmt::format("'{}' is expected", c));
    ++at_;
  }
  [[noreturn]] void fail(const std::string& message) const {
    throw Error(ErrorKind::kInput,
                fmt::format("{}: broken XML at byte {}: {}", path_, std::min(at_, text_.size()), message));
  }

  const std::string& path_;
  std::string_view text_;
  std::string_view stop_;
  std::size_t at_ = 0;
  bool stopped_ = false;
};

}  // namespace

XmlElement parse_xml(const std::string& path, std::string_view text, std::string_view stop) {
  return XmlParser(path, text, stop).parse();
}

}  // namespace quarry
