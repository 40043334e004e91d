// The files of this folder that a page is made of, as they were when the library was built.
#pragma once

#include <string_view>

namespace quarry {

extern const std::string_view kPageTemplate;  // page.html
extern const std::string_view kPageViewer;    // viewer/viewer.min.js

}  // namespace quarry
