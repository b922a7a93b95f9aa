/// The only file with MPI. It is a module of its own, loaded where a launcher started the program.

#include <mpi.h>
#include <petscsf.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <span>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "parallel/communicator.hpp"
#include "parallel/file_part.hpp"

namespace superstep {
namespace {

/// What failed is said and not gone on with: MPI ends all processes for most errors, but not for those of
/// sums that go on in the background, which would look like a result.
void check(int code, const char* what) {
  if (code != 0) throw std::runtime_error(std::string("MPI: ") + what + " failed");
}

/// Looks at once and again for as long as a message between cores takes, then leaves the processor to others:
/// where processes outnumber the cores it is one of those that has to answer.
int looks = 2000;  // set once: fewer where cores are short

void wait_for(std::span<MPI_Request> requests) {
  constexpr unsigned nap = 20;  // microseconds
  int done = 0;
  for (int look = 0; !done; ++look) {
    check(MPI_Testall(static_cast<int>(requests.size()), requests.data(), &done, MPI_STATUSES_IGNORE),
          "MPI_Testall");
    if (!done && look >= looks) ::usleep(nap);
  }
}

/// Who wants which rows from whom is worked out by a star forest of PETSc; its messages are persistent ones.
/// PETSc's own wait for them would hold the processor, on which those that are to answer may have to wait.
class StarForest final : public Exchange {
 public:
  StarForest(const Partition& rows, std::span<const std::int64_t> halo) {
    check(PetscSFCreate(PETSC_COMM_WORLD, &forest_), "PetscSFCreate");
    PetscSFNode* remote = nullptr;
    check(PetscMalloc1(halo.size(), &remote), "allocation");
    for (std::size_t k = 0; k < halo.size(); ++k) {
      const int owner = rows.owner(halo[k]);
      remote[k].rank = owner;
      remote[k].index = static_cast<PetscInt>(halo[k] - rows.first(owner));
    }
    check(PetscSFSetGraph(forest_, static_cast<PetscInt>(rows.owned()), static_cast<PetscInt>(halo.size()),
                          nullptr, PETSC_COPY_VALUES, remote, PETSC_OWN_POINTER),
          "PetscSFSetGraph");
    check(PetscSFSetUp(forest_), "PetscSFSetUp");
    check(MPI_Comm_dup(MPI_COMM_WORLD, &messages_), "MPI_Comm_dup");
    prepare_sending();
    prepare_receiving(halo.size());
  }
  ~StarForest() override {
    int finished = 0;
    MPI_Finalized(&finished);
    if (finished) return;
    for (auto& request : requests_) MPI_Request_free(&request);
    MPI_Comm_free(&messages_);
    PetscSFDestroy(&forest_);
  }

  void begin(const double* owned, double* halo) override {
    halo_ = halo;
    for (std::size_t k = 0; k < sent_.size(); ++k) sent_[k] = owned[wanted_[k]];
    if (!requests_.empty())
      check(MPI_Startall(static_cast<int>(requests_.size()), requests_.data()), "MPI_Startall");
  }
  void end() override {
    if (!requests_.empty()) wait_for(requests_);
    for (std::size_t k = 0; k < received_.size(); ++k) halo_[place_[k]] = received_[k];
  }
  /// MPI moves what is large only while it is called.
  void progress() override {
    int done = 0;
    if (!requests_.empty())
      check(MPI_Testall(static_cast<int>(requests_.size()), requests_.data(), &done, MPI_STATUSES_IGNORE),
            "MPI_Testall");
  }
  [[nodiscard]] std::uint64_t messages() const noexcept override { return sends_; }
  [[nodiscard]] std::uint64_t bytes() const noexcept override { return sent_.size() * sizeof(double); }

 private:
  void prepare_sending() {
    PetscInt ranks = 0;
    const PetscMPIInt* rank = nullptr;
    const PetscInt *offset = nullptr, *row = nullptr;
    check(PetscSFGetLeafRanks(forest_, &ranks, &rank, &offset, &row), "PetscSFGetLeafRanks");
    if (ranks > 0) wanted_.assign(row, row + offset[ranks]);
    sent_.resize(wanted_.size());
    sends_ = static_cast<std::uint64_t>(ranks);
    for (PetscInt k = 0; k < ranks; ++k)
      check(MPI_Send_init(sent_.data() + offset[k], static_cast<int>(offset[k + 1] - offset[k]), MPI_DOUBLE,
                          rank[k], 0, messages_, &requests_.emplace_back()),
            "MPI_Send_init");
  }
  void prepare_receiving(std::size_t size) {
    PetscInt ranks = 0;
    const PetscMPIInt* rank = nullptr;
    const PetscInt *offset = nullptr, *leaf = nullptr, *row = nullptr;
    check(PetscSFGetRootRanks(forest_, &ranks, &rank, &offset, &leaf, &row), "PetscSFGetRootRanks");
    received_.resize(size);
    if (ranks > 0) place_.assign(leaf, leaf + offset[ranks]);
    for (PetscInt k = 0; k < ranks; ++k)
      check(MPI_Recv_init(received_.data() + offset[k], static_cast<int>(offset[k + 1] - offset[k]),
                          MPI_DOUBLE, rank[k], 0, messages_, &requests_.emplace_back()),
            "MPI_Recv_init");
  }

  PetscSF forest_ = nullptr;
  MPI_Comm messages_ = MPI_COMM_NULL;
  std::vector<PetscInt> wanted_, place_;  ///< own rows that are sent; where in the halo what comes goes
  std::vector<double> sent_, received_;
  std::vector<MPI_Request> requests_;
  double* halo_ = nullptr;
  std::uint64_t sends_ = 0;
};

/// By MPI's own files, which know parallel file systems. Each process opens for itself: writes have places of
/// their own, and who fails keeps nobody waiting.
class MpiFilePart final : public FilePart {
 public:
  explicit MpiFilePart(const std::string& file) {
    const int code = MPI_File_open(MPI_COMM_SELF, file.c_str(), MPI_MODE_WRONLY, MPI_INFO_NULL, &file_);
    if (code != MPI_SUCCESS) throw std::runtime_error(reason_of(code));
  }
  ~MpiFilePart() override { MPI_File_close(&file_); }
  MpiFilePart(const MpiFilePart&) = delete;
  MpiFilePart& operator=(const MpiFilePart&) = delete;

  void write(std::uint64_t offset, std::string_view bytes) override {
    constexpr std::size_t most = std::size_t{1} << 30;  // MPI counts in int
    while (!bytes.empty()) {
      MPI_Status status;
      int written = 0;
      errno = 0;
      const int code = MPI_File_write_at(file_, static_cast<MPI_Offset>(offset), bytes.data(),
                                         static_cast<int>(std::min(most, bytes.size())), MPI_BYTE, &status);
      const int error = errno;  // to some a write of no bytes is a success
      if (code != MPI_SUCCESS) throw std::runtime_error(error != 0 ? std::strerror(error) : reason_of(code));
      MPI_Get_count(&status, MPI_BYTE, &written);
      if (written <= 0) throw std::runtime_error(std::strerror(error != 0 ? error : EIO));
      offset += static_cast<std::uint64_t>(written);
      bytes.remove_prefix(static_cast<std::size_t>(written));
    }
  }
  void finish() override {
    if (const int code = MPI_File_sync(file_); code != MPI_SUCCESS) throw std::runtime_error(reason_of(code));
  }

 private:
  static std::string reason_of(int code) {
    char text[MPI_MAX_ERROR_STRING];
    int length = 0;
    MPI_Error_string(code, text, &length);
    return {text, static_cast<std::size_t>(length)};
  }

  MPI_File file_ = MPI_FILE_NULL;
};

class MpiWorld final : public Communicator {
 public:
  MpiWorld() {
    // Of Open MPI's two kinds of files the other one: its own puts locks beside a file, and hides a full
    // disk.
    ::setenv("OMPI_MCA_io", "^ompio", 0);
    int provided = 0;
    check(MPI_Init_thread(nullptr, nullptr, MPI_THREAD_FUNNELED, &provided), "MPI_Init_thread");
    check(PetscInitializeNoArguments(), "PetscInitialize");
    check(PetscPopSignalHandler(), "PetscPopSignalHandler");  // signals are the program's own
    MPI_Comm_rank(MPI_COMM_WORLD, &rank_);
    MPI_Comm_size(MPI_COMM_WORLD, &size_);
    count_cores();
    MPI_Comm_dup(MPI_COMM_WORLD, &arrivals_);
    MPI_Comm_dup(MPI_COMM_WORLD, &letters_);
  }
  ~MpiWorld() override {
    PetscFinalize();
    MPI_Finalize();
  }

  [[nodiscard]] int rank() const noexcept override { return rank_; }
  [[nodiscard]] int size() const noexcept override { return size_; }

  void broadcast(std::vector<std::byte>& bytes) override {
    if (is_root())
      for (int to = 1; to < size_; ++to) send(to, bytes);
    else
      bytes = receive(0);
  }
  std::unique_ptr<Exchange> make_exchange(const Partition& rows,
                                          std::span<const std::int64_t> halo) override {
    return std::make_unique<StarForest>(rows, halo);
  }

  void send(int to, std::span<const std::byte> bytes) override {
    const auto length = static_cast<std::uint64_t>(bytes.size());
    check(MPI_Send(&length, 1, MPI_UINT64_T, to, 0, letters_), "MPI_Send");
    for (std::size_t begin = 0; begin < bytes.size(); begin += piece)
      check(MPI_Send(bytes.data() + begin, static_cast<int>(std::min(piece, bytes.size() - begin)), MPI_BYTE,
                     to, 0, letters_),
            "MPI_Send");
  }
  std::vector<std::byte> receive(int from) override {
    int there = 0;
    constexpr unsigned shortest = 20, longest = 2000;  // microseconds
    for (unsigned wait = shortest; !there; wait = std::min(2 * wait, longest)) {
      check(MPI_Iprobe(from, 0, letters_, &there, MPI_STATUS_IGNORE), "MPI_Iprobe");
      if (!there) ::usleep(wait);
    }
    std::uint64_t length = 0;
    check(MPI_Recv(&length, 1, MPI_UINT64_T, from, 0, letters_, MPI_STATUS_IGNORE), "MPI_Recv");
    std::vector<std::byte> bytes(length);
    for (std::size_t begin = 0; begin < bytes.size(); begin += piece)
      check(MPI_Recv(bytes.data() + begin, static_cast<int>(std::min(piece, bytes.size() - begin)), MPI_BYTE,
                     from, 0, letters_, MPI_STATUS_IGNORE),
            "MPI_Recv");
    return bytes;
  }

  std::unique_ptr<FilePart> open_part(const std::string& file) override {
    return std::make_unique<MpiFilePart>(file);
  }

  bool all_arrive(double seconds) override {
    MPI_Request request = MPI_REQUEST_NULL;
    check(MPI_Ibarrier(arrivals_, &request), "MPI_Ibarrier");
    const double end = MPI_Wtime() + seconds;
    for (int arrived = 0;; ::usleep(1000)) {
      check(MPI_Test(&request, &arrived, MPI_STATUS_IGNORE), "MPI_Test");
      if (arrived) return true;
      if (MPI_Wtime() > end) return false;
    }
  }
  /// MPI_Abort allocates and talks, and may itself get no further; a process that dies is noticed, too.
  void abort(int exit_code) override {
    constexpr unsigned patience = 10;  // s
    std::signal(SIGALRM, SIG_DFL);
    ::alarm(patience);
    MPI_Abort(MPI_COMM_WORLD, exit_code);
    std::_Exit(exit_code);
  }

 private:
  static constexpr std::size_t piece = std::size_t{1} << 30;  // bytes; MPI counts in int

  /// Where processes of a machine outnumber its cores nobody waits without sleeping.
  static void count_cores() {
    MPI_Comm machine = MPI_COMM_NULL;
    int here = 1;
    MPI_Comm_split_type(MPI_COMM_WORLD, MPI_COMM_TYPE_SHARED, 0, MPI_INFO_NULL, &machine);
    MPI_Comm_size(machine, &here);
    MPI_Comm_free(&machine);
    if (static_cast<unsigned>(here) > std::thread::hardware_concurrency()) looks = 10;
  }

  void add_up(std::span<std::int64_t> words) override {
    MPI_Request request = MPI_REQUEST_NULL;
    check(MPI_Iallreduce(MPI_IN_PLACE, words.data(), static_cast<int>(words.size()), MPI_INT64_T, MPI_SUM,
                         MPI_COMM_WORLD, &request),
          "MPI_Iallreduce");
    wait_for({&request, 1});
  }
  void take_largest(std::span<double> values) override {
    MPI_Request request = MPI_REQUEST_NULL;
    check(MPI_Iallreduce(MPI_IN_PLACE, values.data(), static_cast<int>(values.size()), MPI_DOUBLE, MPI_MAX,
                         MPI_COMM_WORLD, &request),
          "MPI_Iallreduce");
    wait_for({&request, 1});
  }
  void gather_into(std::span<const double> own, std::span<const std::int64_t> counts,
                   std::span<double> all) override {
    if (!is_root()) return send(0, std::as_bytes(own));
    std::copy(own.begin(), own.end(), all.begin());
    auto begin = static_cast<std::size_t>(counts[0]);
    for (int from = 1; from < size_; ++from) {
      const auto bytes = receive(from);
      std::copy(bytes.begin(), bytes.end(), std::as_writable_bytes(all.subspan(begin)).begin());
      begin += static_cast<std::size_t>(counts[static_cast<std::size_t>(from)]);
    }
  }

  int rank_ = 0, size_ = 1;
  MPI_Comm arrivals_ = MPI_COMM_NULL, letters_ = MPI_COMM_NULL;
};

}  // namespace
}  // namespace superstep

extern "C" superstep::Communicator* superstep_make_world() {
  return new superstep::MpiWorld;
}
