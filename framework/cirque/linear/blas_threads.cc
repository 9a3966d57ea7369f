#include "cirque/linear/blas_threads.h"

#include <dlfcn.h>
#include <sys/mman.h>
#include <sys/resource.h>

#include <algorithm>
#include <cstdlib>
#include <new>
#include <thread>
#include <vector>

// OpenBLAS' own functions, absent in other BLAS.
extern "C" {
void openblas_set_num_threads(int) __attribute__((weak));
int openblas_get_num_threads() __attribute__((weak));
char* openblas_get_config() __attribute__((weak));
void* blas_memory_alloc(int) __attribute__((weak));
void blas_memory_free(void*) __attribute__((weak));
}

// OpenMP's, absent where nothing uses it.
extern "C" void omp_set_max_active_levels(int) __attribute__((weak));
extern "C" int omp_get_max_active_levels() __attribute__((weak));

// The entry into a parallel region of libgomp, the OpenMP runtime of Debian's CHOLMOD.
extern "C" void GOMP_parallel(void (*region)(void*), void* data, unsigned num_threads,
                              unsigned flags);

namespace cirque {

namespace {

/// Whether a variable of the environment asks for more than one thread.
bool AsksForThreads(const char* variable) {
  const char* threads = std::getenv(variable);
  return threads && std::atoi(threads) != 1;
}

}  // namespace

}  // namespace cirque

// Defined in a program, it takes the place of libgomp's. That makes a team of threads for every
// region, even of one, with an allocation and a call of the system: CHOLMOD has four regions in
// every supernode, and a quarter of its numeric factorization went into their teams. Outside of any
// team a region is run by the thread that comes along.
void GOMP_parallel(void (*region)(void*), void* data, unsigned num_threads, unsigned flags) {
  using Enter = decltype(&GOMP_parallel);
  static const Enter kTeam = cirque::AsksForThreads("OMP_NUM_THREADS")
                                 ? reinterpret_cast<Enter>(dlsym(RTLD_NEXT, "GOMP_parallel"))
                                 : nullptr;
  if (kTeam) return kTeam(region, data, num_threads, flags);
  region(data);
}

namespace cirque {

namespace {

constexpr char kBlasThreads[] = "OPENBLAS_NUM_THREADS";
constexpr std::size_t kBlasBuffer = std::size_t{128} << 20;  // OpenBLAS's, for one call
constexpr std::size_t kRoomBeside = std::size_t{16} << 20;   // for all else, at the least
constexpr std::size_t kRoomToShare = 2 * kBlasBuffer;        // before a further thread takes some

bool HasLimitedAddressSpace() {
  rlimit limit = {};
  return getrlimit(RLIMIT_AS, &limit) == 0 && limit.rlim_cur != RLIM_INFINITY;
}

bool HasRoom(std::size_t bytes) {
  void* const room =
      mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  return room != MAP_FAILED && munmap(room, bytes) == 0;
}

}  // namespace

void UseOneBlasThread() {
  if (openblas_set_num_threads && !AsksForThreads(kBlasThreads)) openblas_set_num_threads(1);
  // CHOLMOD asks for four threads by name, whatever OMP_NUM_THREADS says, unless none may be
  // nested.
  if (omp_set_max_active_levels && !AsksForThreads("OMP_NUM_THREADS")) omp_set_max_active_levels(0);
}

OneBlasThread::OneBlasThread()
    : blas_threads_(NumBlasThreads()),
      active_levels_(omp_get_max_active_levels ? omp_get_max_active_levels() : 0) {
  UseOneBlasThread();
}

OneBlasThread::~OneBlasThread() {
  if (openblas_set_num_threads && blas_threads_ > 0) openblas_set_num_threads(blas_threads_);
  if (omp_set_max_active_levels && omp_get_max_active_levels) {
    omp_set_max_active_levels(active_levels_);
  }
}

int ReserveBlasBuffers(int threads) {
  if (!blas_memory_alloc || !blas_memory_free || !HasLimitedAddressSpace()) return threads;
  if (threads <= 0) threads = static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
  std::vector<void*> buffers;
  for (int i = 0; i < threads; ++i) {
    if (!HasRoom(kBlasBuffer + (i == 0 ? kRoomBeside : kRoomToShare))) break;
    buffers.push_back(blas_memory_alloc(0));
  }
  // OpenBLAS keeps them for the calls to come.
  for (void* buffer : buffers) blas_memory_free(buffer);
  if (buffers.empty()) throw std::bad_alloc();
  return static_cast<int>(buffers.size());
}

int ThreadsByEnvironment() {
  const char* threads = std::getenv("CIRQUE_NUM_THREADS");
  return threads ? std::max(0, std::atoi(threads)) : 0;
}

int NumBlasThreads() { return openblas_get_num_threads ? openblas_get_num_threads() : 0; }

std::string BlasName() { return openblas_get_config ? openblas_get_config() : "unknown"; }

}  // namespace cirque
