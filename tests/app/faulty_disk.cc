#include "tests/app/faulty_disk.h"

#include <sqlite3.h>

#include <atomic>

#include "base/check.h"

namespace parti::tests {
namespace {

using Fault = FaultyDisk::Fault;

std::atomic<Fault> fault = Fault::kNone;
std::atomic<int> left = 0;
std::atomic<int> done = 0;

sqlite3_vfs* Real() {
  static sqlite3_vfs* const real = sqlite3_vfs_find(nullptr);
  return real;
}

/// What SQLite knows of a file: the real one lies right behind.
struct File {
  sqlite3_file base;
  sqlite3_file* real() { return reinterpret_cast<sqlite3_file*>(this + 1); }
};

sqlite3_file* RealOf(sqlite3_file* file) { return reinterpret_cast<File*>(file)->real(); }

/// Whether the next operation fails, flush or write.
bool Fails(bool flush) {
  ++done;
  const Fault now = fault;
  if (now == Fault::kNone || flush != (now == Fault::kFlushFails)) return false;
  return left-- <= 0;
}

int Write(sqlite3_file* file, const void* bytes, int size, sqlite3_int64 at) {
  if (Fails(false)) return fault == Fault::kFull ? SQLITE_FULL : SQLITE_IOERR_WRITE;
  return RealOf(file)->pMethods->xWrite(RealOf(file), bytes, size, at);
}

int Sync(sqlite3_file* file, int flags) {
  if (Fails(true)) return SQLITE_IOERR_FSYNC;
  return RealOf(file)->pMethods->xSync(RealOf(file), flags);
}

/// Hands a call on to the real file.
template <auto method, typename... Arguments>
auto Pass(sqlite3_file* file, Arguments... arguments) {
  return (RealOf(file)->pMethods->*method)(RealOf(file), arguments...);
}

constexpr sqlite3_io_methods kMethods = {
    .iVersion = 2,  // with shared memory, without memory mapping
    .xClose = Pass<&sqlite3_io_methods::xClose>,
    .xRead = Pass<&sqlite3_io_methods::xRead, void*, int, sqlite3_int64>,
    .xWrite = Write,
    .xTruncate = Pass<&sqlite3_io_methods::xTruncate, sqlite3_int64>,
    .xSync = Sync,
    .xFileSize = Pass<&sqlite3_io_methods::xFileSize, sqlite3_int64*>,
    .xLock = Pass<&sqlite3_io_methods::xLock, int>,
    .xUnlock = Pass<&sqlite3_io_methods::xUnlock, int>,
    .xCheckReservedLock = Pass<&sqlite3_io_methods::xCheckReservedLock, int*>,
    .xFileControl = Pass<&sqlite3_io_methods::xFileControl, int, void*>,
    .xSectorSize = Pass<&sqlite3_io_methods::xSectorSize>,
    .xDeviceCharacteristics = Pass<&sqlite3_io_methods::xDeviceCharacteristics>,
    .xShmMap = Pass<&sqlite3_io_methods::xShmMap, int, int, int, void volatile**>,
    .xShmLock = Pass<&sqlite3_io_methods::xShmLock, int, int, int>,
    .xShmBarrier = Pass<&sqlite3_io_methods::xShmBarrier>,
    .xShmUnmap = Pass<&sqlite3_io_methods::xShmUnmap, int>,
    .xFetch = nullptr,
    .xUnfetch = nullptr,
};

int Open(sqlite3_vfs* /*vfs*/, sqlite3_filename name, sqlite3_file* file, int flags,
         int* out_flags) {
  file->pMethods = nullptr;
  const int code = Real()->xOpen(Real(), name, RealOf(file), flags, out_flags);
  if (RealOf(file)->pMethods != nullptr) file->pMethods = &kMethods;
  return code;
}

sqlite3_vfs& Vfs() {
  static sqlite3_vfs vfs = [] {
    sqlite3_vfs copy = *Real();
    copy.szOsFile += static_cast<int>(sizeof(File));
    copy.zName = "faulty";
    copy.pNext = nullptr;
    copy.xOpen = Open;
    return copy;
  }();
  return vfs;
}

}  // namespace

FaultyDisk::FaultyDisk() {
  Repair();
  CHECK(sqlite3_vfs_register(&Vfs(), 1) == SQLITE_OK, "SQLite takes a file system");
}

FaultyDisk::~FaultyDisk() {
  sqlite3_vfs_unregister(&Vfs());
  sqlite3_vfs_register(Real(), 1);
}

void FaultyDisk::Break(Fault how, int more) {
  done = 0;
  left = more;
  fault = how;
}

int FaultyDisk::operations() const { return done; }

}  // namespace parti::tests
