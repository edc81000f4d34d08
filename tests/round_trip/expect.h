#pragma once
// What page and sheet must have in common with the picture.
#include <string>

namespace overstrike {

/// gtest expectations for one scene of scenes/.
void expect_page_is_picture(const std::string& scene);
void expect_sheet_is_picture(const std::string& scene);

}  // namespace overstrike
