// The table of a Shapefile (.dbf), as far as it travels with lines.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include <shapefil.h>

#include "io/lines/line_attributes.hpp"

namespace quarry {

class DbfTable {
 public:
  // path: of the .dbf; "" for a Shapefile without one. Tells the encoding of its texts with -v. Throws
  // Error(kInput) for a file that is no table, or that ends before its last record.
  explicit DbfTable(const std::string& path);

  // Hands over the attributes of a record, from 0; those of one that is not there are empty.
  void read(int record, AttributeCollector& attributes) const;

 private:
  struct Close {
    void operator()(DBFInfo* table) const { DBFClose(table); }
  };
  struct Column {
    int field = 0;
    std::string name;
    bool number = false;
  };
  [[nodiscard]] std::string in_utf8(const char* text) const;

  std::unique_ptr<DBFInfo, Close> table_;
  std::vector<Column> columns_;
  int records_ = 0;
  std::string encoding_;  // "" if the file does not name one
};

}  // namespace quarry
