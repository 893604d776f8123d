#pragma once

#include <string>

#include "limber/common/atomic_file.hpp"
#include "support/run_command.hpp"
#include "support/temporary_folder.hpp"

namespace limber {

/// What Python's XML parser finds in `xml`, as tests/python/describe_xml.py prints it; code 1 and
/// the parser's message where it is not well-formed.
inline CommandResult described_xml(const std::string& xml) {
  const TemporaryFolder folder;
  const auto path = folder.path() / "picture.xml";
  write_file_atomically(path, xml);
  return run_command(std::string("'") + LIMBER_PYTHON + "' '" + LIMBER_SOURCE_DIR +
                     "/tests/python/describe_xml.py' '" + path.string() + "'");
}

}  // namespace limber
