// The channel between the modules of the bench: blocks of work, bounded, with an end.
#pragma once

#include <deque>
#include <systemc>
#include <utility>

namespace wrinkle {

template <class Block>
class BlockWriter : virtual public sc_core::sc_interface {
 public:
  // Waits while the channel is full. False when the reader has cancelled: nothing more is wanted.
  virtual bool put(Block&& block) = 0;
  // No more blocks in this run.
  virtual void close() = 0;
};

template <class Block>
class BlockReader : virtual public sc_core::sc_interface {
 public:
  // Waits for a block. False at the end of the run.
  virtual bool get(Block& block) = 0;
  // Drops what is queued and releases the writer.
  virtual void cancel() = 0;
};

// To be used from threads only. One writer, one reader; reopened before each run.
template <class Block>
class BlockChannel final : public sc_core::sc_object, public BlockWriter<Block>, public BlockReader<Block> {
 public:
  BlockChannel(const char* name, std::size_t capacity) : sc_core::sc_object(name), capacity_(capacity) {}

  void open() {
    queue_.clear();
    closed_ = cancelled_ = false;
  }

  bool put(Block&& block) override {
    while (queue_.size() >= capacity_ && !cancelled_) sc_core::wait(taken_);
    if (cancelled_) return false;
    queue_.push_back(std::move(block));
    written_.notify();
    return true;
  }

  void close() override {
    closed_ = true;
    written_.notify();
  }

  bool get(Block& block) override {
    while (queue_.empty() && !closed_) sc_core::wait(written_);
    if (queue_.empty()) return false;
    block = std::move(queue_.front());
    queue_.pop_front();
    taken_.notify();
    return true;
  }

  void cancel() override {
    cancelled_ = true;
    queue_.clear();
    taken_.notify();
  }

 private:
  std::size_t capacity_;
  std::deque<Block> queue_;
  bool closed_ = true, cancelled_ = false;
  sc_core::sc_event written_, taken_;
};

}  // namespace wrinkle
