// Working memory that chunks of a parallel loop borrow: no more pieces are made than chunks run at once, and
// all go when the pool goes. What a piece holds must not matter to who borrows it.
#pragma once

#include <functional>
#include <memory>
#include <mutex>
#include <utility>
#include <vector>

namespace quarry {

template <class T>
class ScratchPool {
 public:
  // make(): a new piece.
  explicit ScratchPool(std::function<std::unique_ptr<T>()> make) : make_(std::move(make)) {}

  // A piece that is given back at the end of the scope.
  class Loan {
   public:
    explicit Loan(ScratchPool& pool) : pool_(pool), piece_(pool.take()) {}
    ~Loan() { pool_.put(std::move(piece_)); }
    Loan(const Loan&) = delete;
    Loan& operator=(const Loan&) = delete;
    T& operator*() const { return *piece_; }
    T* operator->() const { return piece_.get(); }

   private:
    ScratchPool& pool_;
    std::unique_ptr<T> piece_;
  };

 private:
  std::unique_ptr<T> take() {
    {
      const std::scoped_lock lock(mutex_);
      if (!free_.empty()) {
        std::unique_ptr<T> piece = std::move(free_.back());
        free_.pop_back();
        return piece;
      }
    }
    return make_();
  }
  void put(std::unique_ptr<T> piece) {
    const std::scoped_lock lock(mutex_);
    free_.push_back(std::move(piece));
  }

  std::function<std::unique_ptr<T>()> make_;
  std::mutex mutex_;
  std::vector<std::unique_ptr<T>> free_;
};

}  // namespace quarry
