#include "mapping/whole_file.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstdio>
#include <system_error>
#include <utility>

namespace polygonal_perception::mapping {

namespace {

class Descriptor
{
public:
  explicit Descriptor(int number) : number_(number) {}
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  ~Descriptor()
  {
    if (number_ >= 0) ::close(number_);
  }

  int number() const { return number_; }

  /// @return 0, or the error: some file systems tell only now that the disc is full
  int close() { return ::close(std::exchange(number_, -1)) == 0 ? 0 : errno; }

private:
  int number_;
};

/// @return 0, or the error
int writeAll(const Descriptor& file, const std::string& contents)
{
  for (std::size_t done = 0; done < contents.size();) {
    const ssize_t written = ::write(file.number(), contents.data() + done, contents.size() - done);
    if (written < 0 && errno != EINTR) return errno;
    if (written > 0) done += static_cast<std::size_t>(written);
  }
  return ::fsync(file.number()) == 0 ? 0 : errno;
}

/// A new name is on the disc when its folder is.
void syncFolder(const std::string& path)
{
  const std::size_t slash = path.rfind('/');
  const std::string folder = slash == std::string::npos ? "." : path.substr(0, slash + 1);
  const Descriptor opened(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (opened.number() >= 0) (void)::fsync(opened.number());  // not each file system can
}

std::string reasonOf(int error)
{
  return std::generic_category().message(error);
}

}  // namespace

MapFileError readFailure(const std::string& path, const std::string& reason)
{
  return {"cannot read " + path + ": " + reason};
}

MapFileError writeFailure(const std::string& path, const std::string& reason)
{
  return {"cannot write " + path + ": " + reason};
}

PendingFile::~PendingFile()
{
  if (!beside_.empty()) (void)::unlink(beside_.c_str());
}

std::optional<MapFileError> PendingFile::write(const std::string& contents)
{
  // Not with mkstemp: it makes files that only their owner may read.
  static std::atomic<unsigned> count{0};
  constexpr int kTries = 100;  // a process of our number may have left some
  int number = -1;
  std::string name;
  for (int tries = 0; number < 0 && (tries == 0 || errno == EEXIST) && tries < kTries; ++tries) {
    name = path_ + ".new-" + std::to_string(::getpid()) + "-" + std::to_string(++count);
    number = ::open(name.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
  }
  if (number < 0) return writeFailure(path_, reasonOf(errno));
  beside_ = name;
  Descriptor file(number);
  if (const int error = writeAll(file, contents); error != 0) return writeFailure(path_, reasonOf(error));
  if (const int error = file.close(); error != 0) return writeFailure(path_, reasonOf(error));
  return std::nullopt;
}

std::optional<MapFileError> PendingFile::takePlace()
{
  if (std::rename(beside_.c_str(), path_.c_str()) != 0) return writeFailure(path_, reasonOf(errno));
  beside_.clear();
  syncFolder(path_);
  return std::nullopt;
}

std::optional<MapFileError> writeWhole(const std::string& path, const std::string& contents)
{
  PendingFile file(path);
  if (auto error = file.write(contents)) return error;
  return file.takePlace();
}

std::variant<std::string, MapFileError> readWhole(const std::string& path, std::size_t most_bytes)
{
  // Without O_NONBLOCK a named pipe would wait for a writer.
  const Descriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));
  struct stat status = {};
  if (file.number() < 0 || ::fstat(file.number(), &status) != 0) return readFailure(path, reasonOf(errno));
  if (!S_ISREG(status.st_mode)) return readFailure(path, "it is no file");
  const auto size = static_cast<std::size_t>(status.st_size);
  if (size > most_bytes) {
    return readFailure(path, "it has " + std::to_string(size) + " bytes, accepted are at most " +
                                 std::to_string(most_bytes));
  }
  std::string contents(size, '\0');
  std::size_t done = 0;
  while (done < size) {
    const ssize_t got = ::read(file.number(), &contents[done], size - done);
    if (got < 0 && errno != EINTR) return readFailure(path, reasonOf(errno));
    if (got == 0) break;  // somebody has made it shorter
    if (got > 0) done += static_cast<std::size_t>(got);
  }
  contents.resize(done);
  return contents;
}

}  // namespace polygonal_perception::mapping
