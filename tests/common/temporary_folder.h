#pragma once

#include <string>

namespace cirque {

/// A folder of this test's own, empty, removed with the object.
class TemporaryFolder {
 public:
  TemporaryFolder();
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  const std::string& path() const { return path_; }
  std::string Path(const std::string& name) const { return path_ + "/" + name; }

  /// Writes a file, with the folders above it, and returns its path.
  std::string Write(const std::string& name, const std::string& content) const;

  std::string Read(const std::string& name) const;

 private:
  std::string path_;
};

}  // namespace cirque
