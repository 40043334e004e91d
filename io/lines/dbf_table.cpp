#include "io/lines/dbf_table.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdio>

#include <fmt/format.h>

#include "engine/base/error.hpp"
#include "engine/base/log.hpp"
#include "io/lines/shapelib_errors.hpp"
#include "io/lines/text_encoding.hpp"

namespace quarry {
namespace {

// What is cut off would read as records without attributes.
void require_whole(const std::string& path, DBFInfo& table) {
  table.sHooks.FSeek(table.fp, 0, SEEK_END);
  const std::uint64_t bytes = table.sHooks.FTell(table.fp);
  const auto header = static_cast<std::uint64_t>(std::max(table.nHeaderLength, 0));
  const auto length = static_cast<std::uint64_t>(std::max(table.nRecordLength, 1));
  const std::uint64_t there = bytes > header ? (bytes - header) / length : 0;
  if (table.nRecords > 0 && there < static_cast<std::uint64_t>(table.nRecords))
    throw Error(ErrorKind::kInput,
                fmt::format("{}: the file ends too early: {} records are announced, and {} "
                            "are there; correct or remove it",
                            path, table.nRecords, there));
}

}  // namespace

DbfTable::DbfTable(const std::string& path) {
  if (path.empty()) return;
  SAHooks hooks = make_shapelib_hooks();
  table_.reset(DBFOpenLL(path.c_str(), "rb", &hooks));
  if (!table_)
    throw Error(ErrorKind::kInput, fmt::format("{}: no dBASE table{}{}; correct or remove it", path,
                                               shapelib_message.empty() ? "" : ": ", shapelib_message));
  require_whole(path, *table_);
  records_ = DBFGetRecordCount(table_.get());
  for (int field = 0; field < DBFGetFieldCount(table_.get()); ++field) {
    std::array<char, XBASE_FLDNAME_LEN_READ + 1> name{};
    const DBFFieldType type = DBFGetFieldInfo(table_.get(), field, name.data(), nullptr, nullptr);
    if (AttributeCollector::knows(name.data()))
      columns_.push_back({field, name.data(), type == FTInteger || type == FTDouble});
  }
  const char* const named = DBFGetCodePage(table_.get());
  encoding_ = encoding_name(named == nullptr ? "" : named);
  if (!columns_.empty() && !encoding_.empty()) log::detail("{}: texts are in {}", path, encoding_);
}

std::string DbfTable::in_utf8(const char* text) const {
  return encoding_.empty() || encoding_ == "UTF-8" ? text : to_utf8(text, encoding_);
}

void DbfTable::read(int record, AttributeCollector& attributes) const {
  if (record >= records_) return;
  for (const Column& column : columns_) {
    if (DBFIsAttributeNULL(table_.get(), record, column.field) != 0) continue;
    if (column.number) {
      attributes.set(column.name, DBFReadDoubleAttribute(table_.get(), record, column.field));
    } else if (const char* text = DBFReadStringAttribute(table_.get(), record, column.field);
               text != nullptr) {
      attributes.set(column.name, std::string_view(in_utf8(text)));
    }
  }
}

}  // namespace quarry
